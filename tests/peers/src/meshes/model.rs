//! What is drawn: a mesh with a colour a vertex, and the eyes that look at it.

use super::SIZE;
use rasterscope_core::{
    cull::CullMode,
    scene::{Draw, Geometry, Mesh, Scene, scene_from_obj},
    transform::{Camera, Chain},
};
use std::{f64::consts::TAU, sync::Arc};

/// How many eyes look at a model.
pub const VIEWS: usize = 4;

/// A mesh, seen by one eye after another.
#[derive(Clone)]
pub struct Sight {
    pub mesh: Arc<Mesh>,
    pub cameras: Vec<Camera>,
}

impl Sight {
    /// The camera of the app, and the same one turned about the model by a quarter each: all is inside the frustum
    /// or nearly so. Vertices are coloured by their place.
    fn new(mut mesh: Mesh) -> Self {
        let axis = |i: usize| mesh.positions.iter().map(move |p| p[i]);
        let ends = [0, 1, 2].map(|i| [axis(i).fold(f32::MAX, f32::min), axis(i).fold(f32::MIN, f32::max)]);
        let place =
            |p: &[f32; 3], i: usize| (p[i] - ends[i][0]) / (ends[i][1] - ends[i][0]).max(f32::MIN_POSITIVE);
        mesh.colors = mesh.positions.iter().map(|p| [place(p, 0), place(p, 1), place(p, 2), 1.0]).collect();
        let camera = scene_from_obj("", mesh.clone(), SIZE.map(|n| n as u32)).camera;
        let [x, y, z] = [0, 1, 2].map(|i| camera.eye[i] - camera.target[i]);
        let turned = [[x, y, z], [z, y, -x], [-x, y, -z], [-z, y, x]];
        let cameras =
            turned.map(|from| Camera { eye: [0, 1, 2].map(|i| camera.target[i] + from[i]), ..camera });
        Self { mesh: Arc::new(mesh), cameras: cameras.to_vec() }
    }

    /// As a scene, seen by the first eye.
    pub fn scene(&self) -> Scene {
        let draw = Draw { cull: CullMode::Back, ..Draw::new("", Geometry::Mesh(Arc::clone(&self.mesh))) };
        Scene { camera: self.cameras[0], draws: vec![draw], ..Scene::empty(SIZE.map(|n| n as u32)) }
    }

    /// For each eye, from object to clip space: rows of the product of the pipeline's matrices, in binary64. Depth
    /// is 0..1.
    pub fn matrices(&self) -> Vec<[[f64; 4]; 4]> {
        let mut scene = self.scene();
        let product = |camera: &Camera| {
            scene.camera = *camera;
            let chain = Chain::of(&scene, &scene.draws[0]);
            let entry = |m: &[f32; 16], row: usize, column: usize| f64::from(m[4 * column + row]);
            let all = [0, 1, 2, 3];
            all.map(|i| {
                all.map(|j| {
                    all.map(|k| entry(&chain.projection, i, k) * entry(&chain.view, k, j)).iter().sum()
                })
            })
        };
        self.cameras.iter().map(product).collect()
    }

    /// [`matrices`](Self::matrices), rounded.
    pub fn rounded_matrices(&self) -> Vec<[[f32; 4]; 4]> {
        let rounded = |matrix: [[f64; 4]; 4]| matrix.map(|row| row.map(|entry| entry as f32));
        self.matrices().into_iter().map(rounded).collect()
    }
}

/// The models in these files, with their names.
pub fn read(files: &[String]) -> Result<Vec<(String, Sight)>, String> {
    let one = |file: &String| {
        let bytes = std::fs::read(file).map_err(|error| format!("{file}: {error}"))?;
        let mesh = Mesh::from_obj(&bytes).map_err(|error| format!("{file}: {error:?}"))?;
        let name = std::path::Path::new(file).file_stem().unwrap_or_default().to_string_lossy();
        Ok((name.into_owned(), Sight::new(mesh)))
    };
    files.iter().map(one).collect()
}

/// A built-in model of 69,696 triangles.
pub fn torus() -> (String, Sight) {
    const AROUND: u32 = 264;
    const ACROSS: u32 = 132;
    // Four decimals: the same on every machine.
    let decimal = |x: f64| ((x * 1e4).round() / 1e4) as f32;
    let mut positions = Vec::new();
    for i in 0..AROUND {
        for j in 0..ACROSS {
            let [a, b] = [(i, AROUND), (j, ACROSS)].map(|(i, n)| f64::from(i) / f64::from(n) * TAU);
            let out = 1.0 + 0.4 * b.cos();
            positions.push([out * a.sin(), 0.4 * b.sin(), out * a.cos()].map(decimal));
        }
    }
    let at = |i: u32, j: u32| i % AROUND * ACROSS + j % ACROSS;
    let cells = (0..AROUND).flat_map(|i| (0..ACROSS).map(move |j| [i, j]));
    let triangles = cells.flat_map(|[i, j]| {
        let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        [[a, b, c], [a, c, d]]
    });
    let triangles = triangles.collect();
    let mesh = Mesh { triangles, colors: Vec::new(), uvs: Vec::new(), normals: Vec::new(), positions };
    ("torus".into(), Sight::new(mesh))
}
