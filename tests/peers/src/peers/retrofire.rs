//! The crate retrofire-core: scan lines, binary32, nearer is a greater reciprocal depth.

use crate::{
    frames::{SIZE, Soup},
    meshes::{self, Sight},
    painter::Painter,
};
use retrofire_core::{
    geom::{Tri, Vertex, Vertex3, tri, vertex},
    math::{Color3f, Mat4, ProjMat3, pt2, pt3, rgb, rgba, viewport},
    render::{
        Colorbuf, Context, Frag, Framebuf, Model, Ndc, Screen, Target,
        ctx::FaceCull,
        raster::{ScreenPt, tri_fill},
        render, shader,
    },
    util::{Buf2, Dims, pixfmt::Rgba8888},
};

type Image = Framebuf<Colorbuf<Buf2<u32>, Rgba8888>, Buf2<f32>>;

fn image([width, height]: [usize; 2]) -> Image {
    let size = Dims(width as u32, height as u32);
    Framebuf { color_buf: Colorbuf::new(Buf2::new(size)), depth_buf: Buf2::new(size) }
}

pub struct Retrofire {
    target: Image,
    context: Context,
    triangles: Vec<([Vertex<ScreenPt, ()>; 3], u32)>,
}

pub fn painter() -> Box<dyn Painter<Soup>> {
    Box::new(Retrofire { target: image([SIZE; 2]), context: Context::default(), triangles: Vec::new() })
}

impl Painter<Soup> for Retrofire {
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

/// As in its example of a triangle, by the call that does the whole pipeline; colours without a gamma.
struct Meshes {
    target: Image,
    triangles: Vec<Tri<usize>>,
    vertices: Vec<Vertex3<Color3f>>,
    matrices: Vec<ProjMat3<Model>>,
    viewport: Mat4<Ndc, Screen>,
    context: Context,
}

pub fn mesh_painter() -> Box<dyn Painter<Sight>> {
    let [width, height] = meshes::SIZE.map(|n| n as u32);
    Box::new(Meshes {
        target: image(meshes::SIZE),
        triangles: Vec::new(),
        vertices: Vec::new(),
        matrices: Vec::new(),
        // Row 0 is the highest: what turns counter-clockwise to the eye turns clockwise in rows and columns.
        viewport: viewport(pt2(0, height)..pt2(width, 0)),
        context: Context { face_cull: Some(FaceCull::Front), ..Context::default() },
    })
}

impl Painter<Sight> for Meshes {
    fn name(&self) -> &'static str {
        "retrofire-core 0.4.0"
    }

    fn take(&mut self, sight: &Sight) {
        let mesh = &sight.mesh;
        self.triangles =
            mesh.triangles.iter().map(|t| t.map(|i| i as usize)).map(|[a, b, c]| tri(a, b, c)).collect();
        let vertices = mesh.positions.iter().zip(&mesh.colors);
        self.vertices =
            vertices.map(|([x, y, z], [r, g, b, _])| vertex(pt3(*x, *y, *z), rgb(*r, *g, *b))).collect();
        self.matrices = sight.rounded_matrices().into_iter().map(ProjMat3::new).collect();
    }

    fn draw(&mut self) {
        let shader = shader::new(
            |v: Vertex3<Color3f>, matrix: &ProjMat3<Model>| vertex(matrix.apply(&v.pos), v.attrib),
            |frag: Frag<Color3f>, _| frag.var.to_color4(),
        );
        for matrix in &self.matrices {
            self.target.color_buf.buf.fill(0);
            self.target.depth_buf.fill(0.0);
            let (triangles, vertices) = (&self.triangles, &self.vertices);
            render(triangles, vertices, &shader, matrix, self.viewport, &mut self.target, &self.context);
        }
    }

    fn colors(&self) -> Vec<u32> {
        // Red is the highest byte there.
        let codes = self.target.color_buf.buf.data().iter();
        codes.map(|code| u32::from_ne_bytes(code.to_be_bytes())).collect()
    }
}
