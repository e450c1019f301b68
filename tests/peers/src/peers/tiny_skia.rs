//! The crate tiny-skia: paths, no depth; without anti-aliasing.

use crate::{
    frames::{SIZE, Soup},
    painter::Painter,
};
use tiny_skia::{Color, FillRule, Paint, Path, PathBuilder, Pixmap, Transform};

pub struct TinySkia {
    pixmap: Pixmap,
    paths: Vec<(Path, [u8; 4])>,
}

pub fn painter() -> Box<dyn Painter<Soup>> {
    let size = SIZE as u32;
    Box::new(TinySkia { pixmap: Pixmap::new(size, size).expect("it is not empty"), paths: Vec::new() })
}

impl Painter<Soup> for TinySkia {
    fn name(&self) -> &'static str {
        "tiny-skia 0.12.0 (no depth)"
    }

    fn has_depth(&self) -> bool {
        false
    }

    fn take(&mut self, soup: &Soup) {
        let path = |([[ax, ay, _], [bx, by, _], [cx, cy, _]], color): ([[f32; 3]; 3], u32)| {
            let mut path = PathBuilder::new();
            path.move_to(ax, ay);
            path.line_to(bx, by);
            path.line_to(cx, cy);
            path.close();
            path.finish().map(|path| (path, color.to_le_bytes()))
        };
        self.paths = soup.triangles().filter_map(path).collect();
    }

    fn draw(&mut self) {
        self.pixmap.fill(Color::TRANSPARENT);
        let mut paint = Paint { anti_alias: false, ..Paint::default() };
        for (path, [r, g, b, a]) in &self.paths {
            paint.set_color_rgba8(*r, *g, *b, *a);
            self.pixmap.fill_path(path, &paint, FillRule::Winding, Transform::identity(), None);
        }
    }

    fn colors(&self) -> Vec<u32> {
        self.pixmap.data().as_chunks().0.iter().map(|codes| u32::from_le_bytes(*codes)).collect()
    }
}
