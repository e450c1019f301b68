//! A [`Figure`] as egui's shapes: the one place where drawings reach the screen.

use crate::theme::{Look, color, family};
use egui::{
    Align2, Color32, ColorImage, Context, FontId, Mesh, Painter, Pos2, Rect, StrokeKind, TextureHandle,
    TextureOptions, Vec2, pos2,
};
use rasterscope_core::explain::Role;
use rasterscope_figure::{
    figure::{Align, Figure, Shape, Stroke},
    markers,
};
use std::sync::Arc;

/// Textures of the images on screen, made anew only when an image changes.
#[derive(Default)]
pub(crate) struct Textures {
    kept: Vec<Texture>,
    made: usize,
}

struct Texture {
    /// Holds the image, so that no other image can have its address.
    rgba: Arc<Vec<u8>>,
    handle: TextureHandle,
    used: bool,
}

impl Textures {
    fn get(&mut self, ctx: &Context, size: [usize; 2], rgba: &Arc<Vec<u8>>) -> egui::TextureId {
        if let Some(texture) = self.kept.iter_mut().find(|texture| Arc::ptr_eq(&texture.rgba, rgba)) {
            texture.used = true;
            return texture.handle.id();
        }
        self.made += 1;
        let image = ColorImage::from_rgba_unmultiplied(size, rgba);
        let handle = ctx.load_texture("figure", image, TextureOptions::NEAREST);
        let id = handle.id();
        self.kept.push(Texture { rgba: Arc::clone(rgba), handle, used: true });
        id
    }

    /// Drops what the last frame did not paint.
    pub(crate) fn end_frame(&mut self) {
        self.kept.retain_mut(|texture| std::mem::take(&mut texture.used));
    }

    #[cfg(test)]
    /// How many textures were made: tests assert on it.
    pub(crate) fn made(&self) -> usize {
        self.made
    }
}

impl std::fmt::Debug for Textures {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Textures").field("kept", &self.kept.len()).field("made", &self.made).finish()
    }
}

/// Paints a figure with its upper left corner at `at`.
pub(crate) fn figure(painter: &Painter, textures: &mut Textures, at: Pos2, figure: &Figure) {
    let painter =
        painter.with_clip_rect(painter.clip_rect().intersect(Rect::from_min_size(at, figure.size.into())));
    let mut shapes = Shapes { painter: &painter, origin: at.to_vec2() };
    for shape in &figure.shapes {
        match shape {
            Shape::Image { min, max, size, rgba } => {
                let id = textures.get(painter.ctx(), *size, rgba);
                let rect = Rect::from_min_max(shapes.at(*min), shapes.at(*max));
                let uv = Rect::from_min_max(Pos2::ZERO, pos2(1.0, 1.0));
                painter.image(id, rect, uv, Color32::WHITE);
            }
            Shape::Inset { at: place, figure: inset } => {
                let at = at + Vec2::from(*place);
                let rect = Rect::from_min_size(at, inset.size.into());
                painter.rect_filled(rect, 0, color(inset.background));
                self::figure(&painter, textures, at, inset);
            }
            other => shapes.paint(other),
        }
    }
}

/// Paints the marker of a role.
pub(crate) fn marker(painter: &Painter, at: Pos2, role: Role, size: f32, look: &Look) {
    let style = look.theme.style(role);
    let shapes = markers::marker(style.marker, [at.x, at.y], size / 2.0, style.color, look.theme.panel);
    let mut to = Shapes { painter, origin: Vec2::ZERO };
    shapes.iter().for_each(|shape| to.paint(shape));
}

/// Paints shapes without pictures, their origin at `at`.
pub(crate) fn shapes(painter: &Painter, at: Pos2, shapes: &[Shape]) {
    let mut to = Shapes { painter, origin: at.to_vec2() };
    shapes.iter().for_each(|shape| to.paint(shape));
}

struct Shapes<'a> {
    painter: &'a Painter,
    origin: Vec2,
}

impl Shapes<'_> {
    fn at(&self, [x, y]: [f32; 2]) -> Pos2 {
        pos2(x, y) + self.origin
    }

    fn paint(&mut self, shape: &Shape) {
        match shape {
            Shape::Fill { points, color: fill } => {
                let points: Vec<Pos2> = points.iter().map(|p| self.at(*p)).collect();
                self.painter.add(fill_shape(points, color(*fill)));
            }
            Shape::Line { points, closed, stroke } => {
                let points: Vec<Pos2> = points.iter().map(|p| self.at(*p)).collect();
                self.line(points, *closed, stroke);
            }
            Shape::Circle { center, radius, fill, stroke } => {
                let fill = fill.map_or(Color32::TRANSPARENT, color);
                let outline = stroke.as_ref().map_or(egui::Stroke::NONE, solid);
                self.painter.circle(self.at(*center), *radius, fill, outline);
            }
            Shape::Rect { min, max, radius, fill, stroke } => {
                let rect = Rect::from_min_max(self.at(*min), self.at(*max));
                let fill = fill.map_or(Color32::TRANSPARENT, color);
                let outline = stroke.as_ref().filter(|s| s.dash.is_empty()).map_or(egui::Stroke::NONE, solid);
                self.painter.rect(rect, *radius, fill, outline, StrokeKind::Middle);
                if let Some(stroke) = stroke.filter(|s| !s.dash.is_empty()) {
                    let corners =
                        [rect.left_top(), rect.right_top(), rect.right_bottom(), rect.left_bottom()];
                    self.line(corners.into(), true, &stroke);
                }
            }
            Shape::Text { at, align, text, font, size, color: ink } => {
                let align = Align2(align.map(|align| match align {
                    Align::Min => egui::Align::Min,
                    Align::Center => egui::Align::Center,
                    Align::Max => egui::Align::Max,
                }));
                self.painter.text(self.at(*at), align, text, FontId::new(*size, family(*font)), color(*ink));
            }
            Shape::Image { .. } | Shape::Inset { .. } => {} // need textures: painted by the caller
        }
    }

    fn line(&self, mut points: Vec<Pos2>, closed: bool, stroke: &Stroke) {
        if stroke.dash.is_empty() && sharp(&points, closed) {
            // egui's mitres have no limit: a needle would grow a spike.
            points.extend(points.first().copied().filter(|_| closed));
            let segments =
                points.windows(2).map(|ends| egui::Shape::line_segment([ends[0], ends[1]], solid(stroke)));
            self.painter.extend(segments);
            return;
        }
        if stroke.dash.is_empty() {
            let shape = if closed {
                egui::Shape::closed_line(points, solid(stroke))
            } else {
                egui::Shape::line(points, solid(stroke))
            };
            self.painter.add(shape);
            return;
        }
        if closed {
            points.extend(points.first().copied());
        }
        self.painter.extend(dashed(&points, stroke, self.painter.pixels_per_point()));
    }
}

/// The dashes of a line.
///
/// egui moves both ends of a level or upright segment to pixels: a dash shorter than a pixel or two
/// would lose its length. A path keeps its ends; only its place across is moved, so that it is sharp.
fn dashed(points: &[Pos2], stroke: &Stroke, pixels_per_point: f32) -> Vec<egui::Shape> {
    let dashes: Vec<f32> = stroke.dash.iter().copied().step_by(2).collect();
    let gaps: Vec<f32> = stroke.dash.iter().copied().skip(1).step_by(2).collect();
    let pen = solid(stroke);
    let mut out = egui::Shape::dashed_line_with_offset(points, pen, &dashes, &gaps, -stroke.phase);
    for shape in &mut out {
        if let egui::Shape::LineSegment { points: [mut a, mut b], .. } = *shape {
            if a.x == b.x {
                pen.round_center_to_pixel(pixels_per_point, &mut a.x);
                b.x = a.x;
            } else if a.y == b.y {
                pen.round_center_to_pixel(pixels_per_point, &mut a.y);
                b.y = a.y;
            }
            *shape = egui::Shape::line(vec![a, b], pen);
        }
    }
    out
}

/// Whether a corner is sharper than 30 degrees.
fn sharp(points: &[Pos2], closed: bool) -> bool {
    let n = points.len();
    let corners = if closed { n } else { n.saturating_sub(2) };
    (0..corners).any(|i| {
        let (a, b, c) = (points[i], points[(i + 1) % n], points[(i + 2) % n]);
        let (u, v) = (a - b, c - b);
        u.dot(v) > 0.866 * u.length() * v.length()
    })
}

fn solid(stroke: &Stroke) -> egui::Stroke {
    egui::Stroke::new(stroke.width, color(stroke.color))
}

/// A filled polygon by the even-odd rule; egui's own shape is right for convex ones only.
fn fill_shape(points: Vec<Pos2>, color: Color32) -> egui::Shape {
    if convex(&points) && !thin(&points) {
        return egui::Shape::convex_polygon(points, color, egui::Stroke::NONE);
    }
    let mut mesh = Mesh::default();
    for [top, bottom] in trapezoids(&points) {
        let corners = [top.0, top.1, bottom.1, bottom.0];
        let first = mesh.vertices.len() as u32;
        corners.iter().for_each(|&corner| mesh.colored_vertex(corner, color));
        mesh.add_triangle(first, first + 1, first + 2);
        mesh.add_triangle(first, first + 2, first + 3);
    }
    egui::Shape::mesh(mesh)
}

/// Whether a polygon is so thin that egui's soft edge would stand out at its ends as spikes.
fn thin(points: &[Pos2]) -> bool {
    let turned = |i: usize| (points[i], points[(i + 1) % points.len()]);
    let edges = || (0..points.len()).map(turned);
    let area: f32 = edges().map(|(a, b)| a.x * b.y - b.x * a.y).sum();
    let longest = edges().map(|(a, b)| a.distance(b)).fold(0.0, f32::max);
    area.abs() < 3.0 * longest
}

/// Whether a polygon turns one way only, and once: a star turns one way too, but goes round twice.
fn convex(points: &[Pos2]) -> bool {
    let n = points.len();
    let rises = |i: usize| points[(i + 1) % n].x >= points[i].x;
    if (0..n).filter(|&i| rises(i) != rises((i + 1) % n)).count() > 2 {
        return false;
    }
    let turn = |i: usize| {
        let (a, b, c) = (points[i], points[(i + 1) % n], points[(i + 2) % n]);
        let (u, v) = (b - a, c - b);
        u.x * v.y - u.y * v.x
    };
    n < 4 || (0..n).all(|i| turn(i) >= 0.0) || (0..n).all(|i| turn(i) <= 0.0)
}

/// Cuts a polygon into trapezoids between the heights of its corners and crossings; each is its
/// top side and its bottom side, from left to right.
fn trapezoids(points: &[Pos2]) -> Vec<[(Pos2, Pos2); 2]> {
    let n = points.len();
    let edges: Vec<(Pos2, Pos2)> = (0..n)
        .map(|i| (points[i], points[(i + 1) % n]))
        .map(|(a, b)| if a.y <= b.y { (a, b) } else { (b, a) })
        .filter(|(a, b)| a.y < b.y)
        .collect();
    let mut heights: Vec<f32> = points.iter().map(|p| p.y).collect();
    for (i, a) in edges.iter().enumerate() {
        heights.extend(edges[i + 1..].iter().filter_map(|b| crossing(*a, *b)));
    }
    heights.sort_by(f32::total_cmp);
    heights.dedup();
    let x_at = |(a, b): (Pos2, Pos2), y: f32| a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y));
    let mut out = Vec::new();
    for band in heights.windows(2) {
        let (top, bottom) = (band[0], band[1]);
        let middle = (top + bottom) / 2.0;
        let mut here: Vec<_> = edges.iter().copied().filter(|(a, b)| a.y <= top && b.y >= bottom).collect();
        here.sort_by(|a, b| x_at(*a, middle).total_cmp(&x_at(*b, middle)));
        for pair in here.chunks_exact(2) {
            let side = |y: f32| (pos2(x_at(pair[0], y), y), pos2(x_at(pair[1], y), y));
            out.push([side(top), side(bottom)]);
        }
    }
    out
}

/// The height at which two edges cross, if they do.
fn crossing((a, b): (Pos2, Pos2), (c, d): (Pos2, Pos2)) -> Option<f32> {
    let (u, v, w) = (b - a, d - c, c - a);
    let cross = |p: Vec2, q: Vec2| p.x * q.y - p.y * q.x;
    let bottom = cross(u, v);
    let (t, s) = (cross(w, v) / bottom, cross(w, u) / bottom);
    (bottom != 0.0 && t > 0.0 && t < 1.0 && s > 0.0 && s < 1.0).then_some(a.y + t * u.y)
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::vec2;

    fn area(points: &[[f32; 2]]) -> f32 {
        let points: Vec<Pos2> = points.iter().map(|p| pos2(p[0], p[1])).collect();
        trapezoids(&points)
            .iter()
            .map(|[(a, b), (c, d)]| ((b.x - a.x) + (d.x - c.x)) / 2.0 * (c.y - a.y))
            .sum()
    }

    /// How much is painted of a dotted line from `at` in a direction, 120 points long.
    fn ink(at: Pos2, direction: Vec2, pixels_per_point: f32) -> f32 {
        let color = rasterscope_figure::theme::Color::hex(0);
        let stroke = Stroke { color, width: 2.0, dash: &[2.0, 4.0], phase: 0.0 };
        let shapes = dashed(&[at, at + 120.0 * direction], &stroke, pixels_per_point);
        let options = egui::epaint::TessellationOptions::default();
        let mut tessellator = egui::epaint::Tessellator::new(pixels_per_point, options, [1; 2], Vec::new());
        let mut sum = 0.0;
        for shape in shapes {
            let mut mesh = Mesh::default();
            tessellator.tessellate_shape(shape, &mut mesh);
            for corners in mesh.indices.chunks_exact(3) {
                let [a, b, c] = [0, 1, 2].map(|i| mesh.vertices[corners[i] as usize]);
                let (u, v) = (b.pos - a.pos, c.pos - a.pos);
                let shade = [a, b, c].iter().map(|v| f32::from(v.color.a()) / 255.0).sum::<f32>() / 3.0;
                sum += (u.x * v.y - u.y * v.x).abs() / 2.0 * shade;
            }
        }
        sum
    }

    #[test]
    fn no_dot_of_a_line_vanishes_in_any_direction() {
        let directions = [vec2(1.0, 0.0), vec2(0.0, 1.0), vec2(-1.0, 0.0), vec2(0.0, -1.0)];
        for pixels_per_point in [1.0, 1.25, 1.5, 2.0] {
            let slanted = ink(pos2(10.0, 10.0), vec2(0.6, 0.8), pixels_per_point);
            for (direction, i) in directions.into_iter().flat_map(|it| (0..8).map(move |i| (it, i))) {
                let at = pos2(200.0, 200.0) + vec2(0.13, 0.17) * i as f32;
                let ink = ink(at, direction, pixels_per_point);
                assert!((0.8..1.25).contains(&(ink / slanted)), "{at} {direction}: {ink}, {slanted}");
            }
        }
    }

    #[test]
    fn trapezoids_cover_the_inside_of_any_polygon() {
        let cases: [(&str, &[[f32; 2]], f32); 4] = [
            ("square", &[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]], 4.0),
            ("arrow", &[[0.0, 0.0], [4.0, 2.0], [0.0, 4.0], [1.0, 2.0]], 6.0),
            ("bow tie", &[[0.0, 0.0], [2.0, 2.0], [2.0, 0.0], [0.0, 2.0]], 2.0),
            ("point", &[[1.0, 1.0]], 0.0),
        ];
        for (name, points, expected) in cases {
            assert!((area(points) - expected).abs() < 1e-5, "{name}: {}", area(points));
        }
    }
}
