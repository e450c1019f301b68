//! Text as shapes: widths and outlines from the four embedded fonts.
//!
//! Each character comes from its own font if that has it, else from DejaVu Sans Mono. Texts are one
//! line from left to right, without kerning or ligatures; sizes are in points, y down.

use std::sync::LazyLock;

use skrifa::{
    GlyphId, MetadataProvider,
    instance::{LocationRef, Size},
    metrics::GlyphMetrics,
    outline::{DrawSettings, OutlineGlyphCollection, OutlinePen},
    raw::FontRef,
};

use crate::figure::{Align, Font};

/// The font file behind each [`Font`], for a window that lays text out by itself.
pub fn data(font: Font) -> &'static [u8] {
    match font {
        Font::Sans => notosans::REGULAR_TTF,
        Font::SansBold => notosans::BOLD_TTF,
        Font::Mono => dejavu::sans_mono::regular(),
        Font::MonoBold => dejavu::sans_mono::bold(),
    }
}

/// Where `font` looks for a character that it lacks.
pub const fn fallback(font: Font) -> Font {
    match font {
        Font::Sans | Font::Mono => Font::Mono,
        Font::SansBold | Font::MonoBold => Font::MonoBold,
    }
}

/// One glyph of a laid out text.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Glyph {
    /// The font that has it.
    pub font: Font,
    /// Its index there.
    pub id: u32,
    /// Where it starts on the baseline, from the text's left side.
    pub x: f32,
}

/// A text laid out at a size.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Glyphs from left to right.
    pub glyphs: Vec<Glyph>,
    /// Sum of their advances.
    pub width: f32,
    /// From the top of the box to the baseline.
    pub ascent: f32,
    /// From the top of the box to its foot.
    pub height: f32,
    /// Characters that no font has; they are shown as boxes.
    pub missing: Vec<char>,
}

/// Lays `text` out.
pub fn layout(font: Font, size: f32, text: &str) -> Line {
    let face = face(font);
    let mut line = Line {
        glyphs: Vec::new(),
        width: 0.0,
        ascent: face.ascent * size,
        height: (face.ascent + face.descent) * size,
        missing: Vec::new(),
    };
    for c in text.chars() {
        let (font, id) = match find(font, c) {
            Some(found) => found,
            None => {
                line.missing.push(c);
                (font, GlyphId::NOTDEF)
            }
        };
        line.glyphs.push(Glyph { font, id: id.to_u32(), x: line.width });
        line.width += advance(font, id) * size;
    }
    line
}

/// Width and height of the box of `text`.
pub fn measure(font: Font, size: f32, text: &str) -> [f32; 2] {
    let width: f32 = text
        .chars()
        .map(|c| {
            let (font, id) = find(font, c).unwrap_or((font, GlyphId::NOTDEF));
            advance(font, id)
        })
        .sum();
    let face = face(font);
    [width * size, (face.ascent + face.descent) * size]
}

/// Upper left corner of the box of a text that is anchored at `at`.
pub fn corner(at: [f32; 2], align: [Align; 2], size: [f32; 2]) -> [f32; 2] {
    [at[0] - align[0].fraction() * size[0], at[1] - align[1].fraction() * size[1]]
}

/// Units of one em in the outlines of `font`.
pub fn units_per_em(font: Font) -> f32 {
    face(font).units_per_em
}

/// One piece of a glyph's outline, in font units, y up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outline {
    /// Starts a contour.
    Move([f32; 2]),
    /// A straight line.
    Line([f32; 2]),
    /// A quadratic curve: control point, end.
    Quad([f32; 2], [f32; 2]),
    /// A cubic curve: two control points, end.
    Cubic([f32; 2], [f32; 2], [f32; 2]),
    /// Ends a contour.
    Close,
}

/// The outline of a glyph, filled by the non-zero rule; empty for a space.
pub fn outline(font: Font, id: u32) -> Vec<Outline> {
    let mut pen = Pen(Vec::new());
    if let Some(glyph) = face(font).outlines.get(GlyphId::new(id)) {
        let settings = DrawSettings::unhinted(Size::unscaled(), LocationRef::default());
        if glyph.draw(settings, &mut pen).is_err() {
            pen.0.clear();
        }
    }
    pen.0
}

struct Pen(Vec<Outline>);

impl OutlinePen for Pen {
    fn move_to(&mut self, x: f32, y: f32) {
        self.0.push(Outline::Move([x, y]));
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.0.push(Outline::Line([x, y]));
    }

    fn quad_to(&mut self, cx: f32, cy: f32, x: f32, y: f32) {
        self.0.push(Outline::Quad([cx, cy], [x, y]));
    }

    fn curve_to(&mut self, cx0: f32, cy0: f32, cx1: f32, cy1: f32, x: f32, y: f32) {
        self.0.push(Outline::Cubic([cx0, cy0], [cx1, cy1], [x, y]));
    }

    fn close(&mut self) {
        self.0.push(Outline::Close);
    }
}

/// What is read once of a font file.
struct Face {
    font: FontRef<'static>,
    metrics: GlyphMetrics<'static>,
    outlines: OutlineGlyphCollection<'static>,
    units_per_em: f32,
    ascent: f32,
    descent: f32,
}

impl Face {
    /// `None` if the bytes are no font.
    fn read(data: &'static [u8]) -> Option<Self> {
        let font = FontRef::new(data).ok()?;
        let metrics = font.metrics(Size::unscaled(), LocationRef::default());
        let units_per_em = f32::from(metrics.units_per_em);
        Some(Self {
            metrics: font.glyph_metrics(Size::unscaled(), LocationRef::default()),
            outlines: font.outline_glyphs(),
            units_per_em,
            ascent: metrics.ascent / units_per_em,
            descent: -metrics.descent / units_per_em,
            font,
        })
    }
}

static FACES: LazyLock<[Face; 4]> = LazyLock::new(|| {
    Font::ALL.map(|font| {
        Face::read(data(font)).expect("the embedded fonts are valid: a test lays text out in each")
    })
});

fn face(font: Font) -> &'static Face {
    &FACES[font as usize]
}

fn find(font: Font, c: char) -> Option<(Font, GlyphId)> {
    [font, fallback(font)].into_iter().find_map(|font| Some((font, face(font).font.charmap().map(c)?)))
}

/// In ems.
fn advance(font: Font, id: GlyphId) -> f32 {
    let face = face(font);
    face.metrics.advance_width(id).unwrap_or(0.0) / face.units_per_em
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_sign_we_write_has_a_glyph_in_every_font() {
        let signs = "−×·≤≥≠²³⌈⌉⌊⌋∈∉⇒₀₁₂₃⁻⁰⁷∞–…′←→↔⟨⟩½°ΔΣ√\u{2009}čćđšžČĆĐŠŽñèéàùòìõäöüÕÄÖÜйцукен";
        for font in Font::ALL {
            assert_eq!(layout(font, 14.0, signs).missing, [], "{font:?}");
        }
    }

    #[test]
    fn a_missing_glyph_is_reported_and_shown_as_a_box() {
        let line = layout(Font::Sans, 10.0, "a\u{E000}");
        assert_eq!(line.missing, ['\u{E000}']);
        assert_eq!(line.glyphs.len(), 2);
    }

    #[test]
    fn digits_of_the_mono_fonts_have_one_width() {
        for font in [Font::Mono, Font::MonoBold] {
            let width = measure(font, 10.0, "0")[0];
            assert!((width - 6.02).abs() < 0.01);
            for c in ["1", "7", "−", "×", "∞", "\u{2009}"] {
                assert_eq!(measure(font, 10.0, c)[0], width, "{c}");
            }
        }
    }

    #[test]
    fn measuring_is_laying_out() {
        for font in Font::ALL {
            let line = layout(font, 13.5, "P1′ (2.375, 2) ⌈x⌉");
            assert!((measure(font, 13.5, "P1′ (2.375, 2) ⌈x⌉")[0] - line.width).abs() < 1e-3);
        }
    }

    #[test]
    fn outlines_are_closed_contours() {
        for font in Font::ALL {
            for glyph in layout(font, 10.0, "B8⌈").glyphs {
                let outline = outline(glyph.font, glyph.id);
                assert!(matches!(outline.first(), Some(Outline::Move(_))));
                assert_eq!(outline.last(), Some(&Outline::Close));
            }
        }
        let space = layout(Font::Sans, 10.0, " ").glyphs[0];
        assert!(outline(space.font, space.id).is_empty());
    }
}
