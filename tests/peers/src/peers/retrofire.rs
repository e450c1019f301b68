//! The crate retrofire-core: scan lines, binary32, nearer is a greater reciprocal depth.

use crate::frames::{Painter, SIZE, Soup};
use retrofire_core::{
    geom::Vertex,
    math::{point::pt3, rgba},
    render::{
        Colorbuf, Context, Frag, Framebuf, Target,
        raster::{ScreenPt, tri_fill},
    },
    util::{Buf2, Dims, pixfmt::Rgba8888},
};

pub struct Retrofire {
    target: Framebuf<Colorbuf<Buf2<u32>, Rgba8888>, Buf2<f32>>,
    context: Context,
    triangles: Vec<([Vertex<ScreenPt, ()>; 3], u32)>,
}

pub fn painter() -> Box<dyn Painter> {
    let size = Dims(SIZE as u32, SIZE as u32);
    Box::new(Retrofire {
        target: Framebuf { color_buf: Colorbuf::new(Buf2::new(size)), depth_buf: Buf2::new(size) },
        context: Context::default(),
        triangles: Vec::new(),
    })
}

impl Painter for Retrofire {
    fn name(&self) -> &'static str {
        "retrofire-core 0.4.0"
    }

    fn take(&mut self, soup: &Soup) {
        let vertex = |[x, y, z]: [f32; 3]| Vertex { pos: pt3(x, y, 1.0 - z), attrib: () };
        self.triangles = soup.triangles().map(|(triangle, color)| (triangle.map(vertex), color)).collect();
    }

    fn draw(&mut self) {
        self.target.color_buf.buf.fill(0);
        self.target.depth_buf.fill(0.0);
        for (triangle, color) in &self.triangles {
            let [a, b, c, d] = color.to_be_bytes();
            let color = rgba(a, b, c, d);
            tri_fill(triangle.clone(), |scanline| {
                self.target.rasterize(scanline, &|_: Frag<()>, ()| color, (), &self.context);
            });
        }
    }

    fn colors(&self) -> Vec<u32> {
        self.target.color_buf.buf.data().to_vec()
    }
}
