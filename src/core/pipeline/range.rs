//! Whether a scene stays within the range of binary32 on its way to clip space.
//!
//! A product component beyond that range is clamped, so that no stage meets an infinity. Then the
//! picture is that of another scene, and whoever asked for it is to be told.

use crate::{
    cull::frustum::Bounds,
    explain::letter,
    message::{Message, Value},
    scene::{Draw, Mesh, Scene},
    transform::{
        Chain, Matrix, apply,
        matrices::{camera_leaves_range, product_leaves_range},
    },
};

/// The first thing in a resolved scene that cannot be drawn as it is: the camera, or a draw with a
/// vertex that leaves the range of binary32 in world, camera or clip space. `None` for nearly
/// every scene.
///
/// Depends on no skip: vertices count whether or not something culls them. Cost: a pass over the
/// vertices, and for a draw with enormous numbers three matrix products a vertex.
pub fn out_of_range(scene: &Scene) -> Option<Message> {
    let about = |id, path: String| Message::new(id).with("path", Value::text(path));
    let aspect = f64::from(scene.size[0]) / f64::from(scene.size[1]);
    if camera_leaves_range(&scene.camera, aspect, scene.depth_range, scene.reversed) {
        return Some(about("error-scene-camera-out-of-range", "camera".into()));
    }
    let leaves = |(index, draw): (usize, &Draw)| {
        let mesh = draw.geometry.mesh()?;
        let chain = Chain::of(scene, draw);
        let matrices = [&chain.model, &chain.view, &chain.projection];
        let name = if draw.name.is_empty() { letter(index) } else { draw.name.clone() };
        (!surely_within(mesh, matrices) && any_vertex_leaves(mesh, matrices)).then(|| {
            about("error-scene-draw-out-of-range", format!("draws[{index}]")).with("name", Value::text(name))
        })
    };
    scene.draws.iter().enumerate().find_map(leaves)
}

/// Whether the largest magnitudes of all vertices, taken together, stay within the range.
fn surely_within(mesh: &Mesh, matrices: [&Matrix; 3]) -> bool {
    let Some(Bounds { min, max }) = Bounds::of(&mesh.positions) else { return true };
    let mut size = [0, 1, 2, 3].map(|i| f64::from(min[i].abs().max(max[i].abs())));
    for matrix in matrices {
        size = [0, 1, 2, 3].map(|i| (0..4).map(|j| f64::from(matrix[4 * j + i]).abs() * size[j]).sum());
        // Half the range: far more than what rounding adds to these sums and to the products.
        if size.iter().any(|size| *size > f64::from(f32::MAX) / 2.0) {
            return false;
        }
    }
    true
}

fn any_vertex_leaves(mesh: &Mesh, matrices: [&Matrix; 3]) -> bool {
    mesh.positions.iter().any(|&[x, y, z]| {
        let mut point = [x, y, z, 1.0];
        matrices.into_iter().any(|matrix| {
            let leaves = product_leaves_range(matrix, point);
            point = apply(matrix, point);
            leaves
        })
    })
}
