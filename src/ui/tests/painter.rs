//! Draws egui's meshes on the CPU, so that pictures need no driver and are the same everywhere.

use egui::{
    Color32, Context, FullOutput, Rect, TextureFilter, TextureId, TexturesDelta,
    epaint::{ImageData, Mesh, Primitive, Vertex},
};
use egui_kittest::TestRenderer;
use image::{Rgba, RgbaImage};
use std::collections::HashMap;

/// The renderer of the window tests.
#[derive(Default)]
pub(crate) struct CpuPainter {
    textures: HashMap<TextureId, Texture>,
}

struct Texture {
    size: [usize; 2],
    pixels: Vec<Color32>,
    nearest: bool,
}

impl TestRenderer for CpuPainter {
    fn handle_delta(&mut self, delta: &mut TexturesDelta) {
        for (id, patches) in delta.set.drain() {
            for patch in patches {
                let ImageData::Color(image) = &patch.image;
                let nearest = patch.options.magnification == TextureFilter::Nearest;
                let [x0, y0] = patch.pos.unwrap_or_default();
                if patch.pos.is_none() {
                    self.textures
                        .insert(id, Texture { size: image.size, pixels: image.pixels.clone(), nearest });
                } else if let Some(texture) = self.textures.get_mut(&id) {
                    for (y, row) in image.pixels.chunks_exact(image.size[0]).enumerate() {
                        let at = (y0 + y) * texture.size[0] + x0;
                        texture.pixels[at..at + row.len()].copy_from_slice(row);
                    }
                }
            }
        }
        for id in delta.free.drain() {
            self.textures.remove(&id);
        }
    }

    fn render(&mut self, ctx: &Context, output: &FullOutput) -> Result<RgbaImage, String> {
        let size = ctx.content_rect().size() * ctx.pixels_per_point();
        let mut image = RgbaImage::new(size.x.round() as u32, size.y.round() as u32);
        for clipped in ctx.tessellate(output.shapes.clone(), ctx.pixels_per_point()) {
            if let Primitive::Mesh(mesh) = &clipped.primitive {
                let texture = self.textures.get(&mesh.texture_id).ok_or("a mesh without its texture")?;
                draw(&mut image, mesh, texture, clipped.clip_rect, ctx.pixels_per_point());
            }
        }
        Ok(image)
    }
}

fn draw(image: &mut RgbaImage, mesh: &Mesh, texture: &Texture, clip: Rect, scale: f32) {
    let limit = |low: f32, high: f32, end: u32| {
        ((low * scale).round().max(0.0) as u32, ((high * scale).round().max(0.0) as u32).min(end))
    };
    let (left, right) = limit(clip.left(), clip.right(), image.width());
    let (top, bottom) = limit(clip.top(), clip.bottom(), image.height());
    for corners in mesh.indices.chunks_exact(3) {
        let [a, b, c] = [0, 1, 2].map(|i| &mesh.vertices[corners[i] as usize]);
        let [pa, pb, pc] = [a, b, c].map(|vertex| [vertex.pos.x * scale, vertex.pos.y * scale]);
        let edge = |p: [f32; 2], q: [f32; 2], r: [f32; 2]| {
            (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
        };
        let area = edge(pa, pb, pc);
        if area == 0.0 {
            continue;
        }
        let low = |axis: usize| pa[axis].min(pb[axis]).min(pc[axis]).floor().max(0.0) as u32;
        let high = |axis: usize| pa[axis].max(pb[axis]).max(pc[axis]).ceil().max(0.0) as u32;
        for y in low(1).max(top)..high(1).min(bottom) {
            for x in low(0).max(left)..high(0).min(right) {
                let p = [x as f32 + 0.5, y as f32 + 0.5];
                let edges = [(pb, pc), (pc, pa), (pa, pb)];
                let inside = edges.iter().all(|&(from, to)| {
                    let value = edge(from, to, p) * area.signum();
                    // One of two neighbours draws a centre on their common edge.
                    let along = [(to[0] - from[0]) * area.signum(), (to[1] - from[1]) * area.signum()];
                    value > 0.0 || value == 0.0 && (along[1] < 0.0 || along[1] == 0.0 && along[0] > 0.0)
                });
                if inside {
                    let weights = edges.map(|(from, to)| edge(from, to, p) / area);
                    blend(image.get_pixel_mut(x, y), shade([a, b, c], weights, texture));
                }
            }
        }
    }
}

/// The colour at weights of three corners, premultiplied.
fn shade(corners: [&Vertex; 3], weights: [f32; 3], texture: &Texture) -> [f32; 4] {
    let mut color = [0.0; 4];
    let mut uv = [0.0; 2];
    for (vertex, weight) in corners.iter().zip(weights) {
        for (sum, channel) in color.iter_mut().zip(vertex.color.to_array()) {
            *sum += weight * f32::from(channel) / 255.0;
        }
        uv[0] += weight * vertex.uv.x;
        uv[1] += weight * vertex.uv.y;
    }
    let texel = texture.sample(uv);
    [0, 1, 2, 3].map(|i| color[i] * texel[i])
}

fn blend(pixel: &mut Rgba<u8>, color: [f32; 4]) {
    for (channel, new) in pixel.0.iter_mut().zip(color) {
        *channel = (255.0 * new + f32::from(*channel) * (1.0 - color[3])).round().clamp(0.0, 255.0) as u8;
    }
}

impl Texture {
    fn texel(&self, x: isize, y: isize) -> [f32; 4] {
        let x = x.clamp(0, self.size[0] as isize - 1) as usize;
        let y = y.clamp(0, self.size[1] as isize - 1) as usize;
        self.pixels[y * self.size[0] + x].to_array().map(|channel| f32::from(channel) / 255.0)
    }

    fn sample(&self, [u, v]: [f32; 2]) -> [f32; 4] {
        let (x, y) = (u * self.size[0] as f32, v * self.size[1] as f32);
        if self.nearest {
            return self.texel(x.floor() as isize, y.floor() as isize);
        }
        let (x, y) = (x - 0.5, y - 0.5);
        let (column, row) = (x.floor(), y.floor());
        let (fx, fy) = (x - column, y - row);
        let (column, row) = (column as isize, row as isize);
        let mix = |a: [f32; 4], b: [f32; 4], t: f32| [0, 1, 2, 3].map(|i| a[i] + (b[i] - a[i]) * t);
        let upper = mix(self.texel(column, row), self.texel(column + 1, row), fx);
        let lower = mix(self.texel(column, row + 1), self.texel(column + 1, row + 1), fx);
        mix(upper, lower, fy)
    }
}
