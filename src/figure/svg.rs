//! A figure as an SVG file that looks the same everywhere: text is outlines, each glyph drawn once
//! and reused, and every text carries its words for those who listen instead of look.

use std::{collections::BTreeMap, fmt::Write};

use base64::Engine;

use crate::{
    figure::{Figure, Font, Shape, Stroke},
    png::rgba_png,
    text::{self, Glyph, Outline},
    theme::Color,
};

/// The figure as a self-contained SVG file.
pub fn svg(figure: &Figure) -> String {
    let mut writer = Writer::default();
    for shape in &figure.shapes {
        writer.shape(shape);
    }
    let [width, height] = figure.size.map(short);
    let texts: Vec<_> = figure.texts().map(escape).collect();
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"0 0 {width} {height}\" role=\"img\">\n\
         <title>Rasterscope</title>\n<desc>{}</desc>\n<defs>\n{}</defs>\n\
         <rect width=\"{width}\" height=\"{height}\"{}/>\n{}</svg>\n",
        texts.join("; "),
        writer.glyphs,
        paint("fill", figure.background),
        writer.body,
    )
}

#[derive(Default)]
struct Writer {
    /// Outlines of the glyphs used so far.
    glyphs: String,
    /// Which those are, by font and index.
    known: BTreeMap<(usize, u32), usize>,
    body: String,
}

impl Writer {
    fn shape(&mut self, shape: &Shape) {
        match shape {
            Shape::Fill { points, color } => {
                let fill = paint("fill", *color);
                self.element(&format!("<path d=\"{}\"{fill} fill-rule=\"evenodd\"/>", path(points, true)));
            }
            Shape::Line { points, closed, stroke } => {
                let line = stroked(*stroke);
                self.element(&format!("<path d=\"{}\" fill=\"none\"{line}/>", path(points, *closed)));
            }
            Shape::Circle { center: [x, y], radius, fill, stroke } => {
                let [x, y, r] = [*x, *y, *radius].map(short);
                self.element(&format!("<circle cx=\"{x}\" cy=\"{y}\" r=\"{r}\"{}/>", area(*fill, *stroke)));
            }
            Shape::Rect { min, max, radius, fill, stroke } => {
                let [x, y] = min.map(short);
                let [width, height] = [max[0] - min[0], max[1] - min[1]].map(short);
                let round = if *radius > 0.0 { format!(" rx=\"{}\"", short(*radius)) } else { String::new() };
                let area = area(*fill, *stroke);
                self.element(&format!(
                    "<rect x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\"{round}{area}/>"
                ));
            }
            Shape::Text { at, align, text, font, size, color } => {
                let line = text::layout(*font, *size, text);
                let [left, top] = text::corner(*at, *align, [line.width, line.height]);
                let label = escape(text);
                self.element(&format!("<g role=\"img\" aria-label=\"{label}\"{}>", paint("fill", *color)));
                for run in line.glyphs.chunk_by(|a, b| a.font == b.font) {
                    self.run(run, [left, top + line.ascent], *size);
                }
                self.element("</g>");
            }
            Shape::Image { min, max, size, rgba } => {
                let data = base64::engine::general_purpose::STANDARD.encode(rgba_png(*size, rgba));
                let [x, y] = min.map(short);
                let [width, height] = [max[0] - min[0], max[1] - min[1]].map(short);
                self.element(&format!(
                    "<image x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" \
                     preserveAspectRatio=\"none\" image-rendering=\"pixelated\" \
                     style=\"image-rendering:pixelated\" href=\"data:image/png;base64,{data}\"/>"
                ));
            }
            Shape::Inset { at, figure } => {
                let ([x, y], [width, height]) = (at.map(short), figure.size.map(short));
                self.element(&format!(
                    "<svg x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" overflow=\"hidden\">"
                ));
                let ground = paint("fill", figure.background);
                self.element(&format!("<rect width=\"{width}\" height=\"{height}\"{ground}/>"));
                figure.shapes.iter().for_each(|shape| self.shape(shape));
                self.element("</svg>");
            }
        }
    }

    fn element(&mut self, text: &str) {
        self.body.push_str(text);
        self.body.push('\n');
    }

    /// Glyphs of one font, in that font's units, y up.
    fn run(&mut self, glyphs: &[Glyph], [left, baseline]: [f32; 2], size: f32) {
        let Some(first) = glyphs.first() else { return };
        let units = size / text::units_per_em(first.font);
        let mut uses = String::new();
        for glyph in glyphs {
            if let Some(id) = self.glyph(glyph.font, glyph.id) {
                let x = ((glyph.x - first.x) / units).round();
                // Writing to a String cannot fail, here and below.
                let _ = if x == 0.0 {
                    write!(uses, "<use href=\"#g{id}\"/>")
                } else {
                    write!(uses, "<use href=\"#g{id}\" x=\"{x}\"/>")
                };
            }
        }
        if !uses.is_empty() {
            let [x, y] = [left + first.x, baseline].map(short);
            let scale = format!("{units:.6}");
            let scale = scale.trim_end_matches('0');
            self.element(&format!("<g transform=\"translate({x} {y}) scale({scale} -{scale})\">{uses}</g>"));
        }
    }

    /// The number of a glyph's outline; `None` for a space.
    fn glyph(&mut self, font: Font, id: u32) -> Option<usize> {
        let next = self.known.len();
        if let Some(&known) = self.known.get(&(font as usize, id)) {
            return Some(known);
        }
        let outline = text::outline(font, id);
        if outline.is_empty() {
            return None;
        }
        self.known.insert((font as usize, id), next);
        let mut data = String::new();
        for piece in outline {
            let _ = match piece {
                Outline::Move([x, y]) => write!(data, "M{x} {y}"),
                Outline::Line([x, y]) => write!(data, "L{x} {y}"),
                Outline::Quad([a, b], [x, y]) => write!(data, "Q{a} {b} {x} {y}"),
                Outline::Cubic([a, b], [c, d], [x, y]) => write!(data, "C{a} {b} {c} {d} {x} {y}"),
                Outline::Close => write!(data, "Z"),
            };
        }
        let _ = writeln!(self.glyphs, "<path id=\"g{next}\" d=\"{data}\"/>");
        Some(next)
    }
}

fn path(points: &[[f32; 2]], closed: bool) -> String {
    let mut data = String::new();
    for (i, point) in points.iter().enumerate() {
        let [x, y] = point.map(short);
        let _ = write!(data, "{}{x} {y}", if i == 0 { "M" } else { "L" });
    }
    if closed {
        data.push('Z');
    }
    data
}

fn area(fill: Option<Color>, stroke: Option<Stroke>) -> String {
    let fill = fill.map_or_else(|| " fill=\"none\"".to_owned(), |color| paint("fill", color));
    fill + &stroke.map(stroked).unwrap_or_default()
}

fn stroked(stroke: Stroke) -> String {
    let mut text = paint("stroke", stroke.color);
    let _ = write!(text, " stroke-width=\"{}\"", short(stroke.width));
    if !stroke.dash.is_empty() {
        let dash: Vec<_> = stroke.dash.iter().map(|&length| short(length)).collect();
        let _ = write!(text, " stroke-dasharray=\"{}\"", dash.join(" "));
        if stroke.phase != 0.0 {
            let _ = write!(text, " stroke-dashoffset=\"{}\"", short(stroke.phase));
        }
    }
    text
}

fn paint(what: &str, color: Color) -> String {
    let mut text = format!(" {what}=\"{}\"", color.css());
    if color.0[3] < 255 {
        let _ = write!(text, " {what}-opacity=\"{}\"", short(f32::from(color.0[3]) / 255.0));
    }
    text
}

/// At most two decimals of a point: less than anyone can see.
fn short(x: f32) -> String {
    let text = format!("{x:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

/// Text as it stands in XML and HTML, also inside quotes; a space for each control character.
pub fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            // XML 1.0 has hardly any, HTML should have none.
            c if c.is_control() => out.push(' '),
            c => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::figure::Align;

    fn text(text: &str) -> Shape {
        Shape::Text {
            at: [10.0, 10.0],
            align: [Align::Min, Align::Center],
            text: text.to_owned(),
            font: Font::Mono,
            size: 13.5,
            color: Color::hex(0x123456),
        }
    }

    fn figure(shapes: Vec<Shape>) -> String {
        svg(&Figure { size: [100.0, 50.0], background: Color::hex(0xFFFFFF), shapes })
    }

    #[test]
    fn a_glyph_is_drawn_once_however_often_it_is_used() {
        let svg = figure(vec![text("0101"), text("10")]);
        assert_eq!(svg.matches("<path id=").count(), 2);
        assert_eq!(svg.matches("<use ").count(), 6);
    }

    #[test]
    fn words_are_kept_for_those_who_listen() {
        let svg = figure(vec![text("a < b & \"c\"\u{7}")]);
        assert!(svg.contains("aria-label=\"a &lt; b &amp; &quot;c&quot; \""));
        assert!(svg.contains("<desc>a &lt; b"));
    }

    #[test]
    fn images_are_embedded_and_stay_sharp() {
        let rgba = Arc::new(vec![7; 8]);
        let svg = figure(vec![Shape::Image { min: [0.0; 2], max: [9.0; 2], size: [2, 1], rgba }]);
        assert!(svg.contains("image-rendering=\"pixelated\"") && svg.contains("data:image/png;base64,iVBOR"));
    }

    #[test]
    fn every_element_that_opens_closes() {
        let stroke = Stroke { color: Color([1, 2, 3, 100]), width: 2.0, dash: &[7.0, 5.0], phase: 1.5 };
        let svg = figure(vec![
            text("x ⌈y⌉"),
            Shape::Circle { center: [5.0; 2], radius: 2.0, fill: None, stroke: Some(stroke) },
            Shape::Line { points: vec![[0.0, -0.001], [9.0, 9.0]], closed: false, stroke },
            Shape::Fill { points: vec![[0.0; 2], [9.0, 0.0], [0.0, 9.0]], color: stroke.color },
        ]);
        for tag in ["g", "defs", "desc", "title", "svg"] {
            let open = svg.matches(&format!("<{tag}>")).count() + svg.matches(&format!("<{tag} ")).count();
            assert_eq!(open, svg.matches(&format!("</{tag}>")).count(), "{tag}");
        }
        assert!(svg.contains("stroke-dashoffset=\"1.5\"") && svg.contains("fill-opacity=\"0.39\""));
        assert!(!svg.contains("NaN") && !svg.contains("-0 ") && !svg.contains("\"-0\""));
    }
}
