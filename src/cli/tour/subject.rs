//! What the tour is about: a scene and what every stage made of it.

use rasterscope_core::{
    math::Tally,
    pipeline::{DrawOutputs, Fate, Outputs, PixelCounts, ScreenTriangle, draw_name, triangle_name},
    raster::{self, Settings, Span},
    scene::Scene,
    transform::{Projection, matrices::row},
};
use rasterscope_figure::theme::{Color, Theme};

/// Vertices up to this many are named in the pictures.
pub(super) const NAMED: usize = 12;

/// Images up to this size are shown cell by cell.
const SMALL: [u32; 2] = [48, 36];

/// A scene, its stages and the colours of the page.
#[derive(Clone, Copy, Debug)]
pub(super) struct Subject<'a> {
    pub(super) scene: &'a Scene,
    pub(super) outputs: &'a Outputs,
    pub(super) counts: &'a PixelCounts,
    pub(super) theme: &'a Theme,
}

impl<'a> Subject<'a> {
    /// Whether each pixel can be shown as a cell with its value.
    pub(super) fn is_small(&self) -> bool {
        self.scene.size[0] <= SMALL[0] && self.scene.size[1] <= SMALL[1]
    }

    /// Whether every vertex can be named.
    pub(super) fn is_named(&self) -> bool {
        self.outputs.draws.iter().map(|draw| draw.mesh().positions.len()).sum::<usize>() <= NAMED
    }

    /// The name of a draw: its own, or its number.
    pub(super) fn name(&self, draw: usize) -> String {
        draw_name((draw, &self.scene.draws[draw]))
    }

    /// What a triangle of a draw is called.
    pub(super) fn triangle_name(&self, draw: usize, triangle: u32) -> String {
        triangle_name((draw, &self.scene.draws[draw]), triangle, None)
    }

    /// The fill of a draw.
    pub(super) fn color(&self, draw: usize) -> Color {
        self.theme.object(draw).0
    }

    /// The triangles of all draws in world space, with draw and index.
    pub(super) fn world(&self) -> impl Iterator<Item = (usize, usize, [[f32; 3]; 3])> + use<'a> {
        let outputs = self.outputs;
        outputs.draws.iter().enumerate().flat_map(|(index, draw)| {
            let world = draw.world();
            let triangles = if world.is_empty() { &[] } else { &draw.mesh().triangles[..] };
            triangles.iter().enumerate().map(move |(i, triangle)| {
                let corner = |i: u32| {
                    let [x, y, z, _] = world[i as usize];
                    [x, y, z]
                };
                (index, i, triangle.map(corner))
            })
        })
    }

    /// What became of a triangle in culling.
    pub(super) fn fate(&self, draw: usize, triangle: usize) -> Option<Fate> {
        self.outputs.draws.get(draw)?.culled().decisions.get(triangle).map(|decision| decision.fate)
    }

    /// Right, up and backwards of the scene's camera in world space.
    pub(super) fn axes(&self) -> [[f32; 3]; 3] {
        [0, 1, 2].map(|i| {
            let [x, y, z, _] = row(&self.outputs.view, i);
            [x, y, z]
        })
    }

    /// A point of camera space in world space.
    pub(super) fn world_of(&self, p: [f32; 3]) -> [f32; 3] {
        let axes = self.axes();
        [0, 1, 2]
            .map(|c| self.scene.camera.eye[c] + p[0] * axes[0][c] + p[1] * axes[1][c] + p[2] * axes[2][c])
    }

    /// How far the pictures of the frustum go: to the far plane, but not far behind everything.
    pub(super) fn depth_shown(&self) -> f32 {
        let camera = &self.scene.camera;
        let views = self.outputs.draws.iter().flat_map(DrawOutputs::view);
        let deepest = views.map(|p| -p[2]).filter(|d| d.is_finite() && *d <= camera.far).fold(0.0, f32::max);
        if deepest > 0.0 { camera.far.min((deepest * 1.25).max(camera.near * 2.0)) } else { camera.far }
    }

    /// Half width and half height of the visible part of camera space at a distance.
    pub(super) fn half_extent(&self, distance: f32) -> [f32; 2] {
        let half = match self.scene.camera.projection {
            Projection::Perspective { fovy_degrees } => {
                let tangent = libm::tan(f64::from(fovy_degrees).to_radians() / 2.0) as f32;
                distance * tangent
            }
            Projection::Orthographic { height } => height / 2.0,
        };
        [half * self.scene.size[0] as f32 / self.scene.size[1] as f32, half]
    }

    /// The corners of the visible part at a distance, counter-clockwise from the lower left.
    pub(super) fn window(&self, distance: f32) -> [[f32; 3]; 4] {
        let [x, y] = self.half_extent(distance);
        [[-x, -y], [x, -y], [x, y], [-x, y]].map(|[x, y]| self.world_of([x, y, -distance]))
    }

    /// The spans of one triangle on the screen.
    pub(super) fn spans(&self, triangle: &ScreenTriangle) -> Vec<Span> {
        let settings = Settings {
            fill_rule: self.scene.fill_rule,
            y_axis: self.scene.y_axis,
            ..Settings::new(self.scene.size)
        };
        let vertices = triangle.vertices.map(|[x, y, _]| [x, y]);
        raster::rows(raster::Algorithm::Scanline, vertices, &settings, &mut Tally::default())
    }

    /// The draw of the last fragment that a pixel got, counted row by row.
    pub(super) fn last_draw(&self, pixel: usize) -> Option<usize> {
        self.counts.last_generated(pixel).map(|triangle| triangle.draw as usize)
    }
}
