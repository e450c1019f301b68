//! One draw through the stages before scan conversion, each recomputed only when its input changed.

use std::sync::Arc;

use super::{
    Bounding, Skip, Skips, Stats,
    lit::{Lit, Varyings},
    stages::{self, Clipped, CullKey, Culled, Fate, Point},
    stats::Reason,
    visible::Visible,
};
use crate::{
    clip::polygon::Plane,
    cull::{Facing, bvh::Aabb, frustum::Bounds, object_frustum::Body, planes::Volume},
    memo::{Memo, Rev},
    scene::{Draw, Mesh, Scene, Shade},
    shade::{Illumination, Light, Material},
    stage::Stage,
    transform::{Camera, Matrix, Viewport, apply, chain::model_matrix, divide},
};

/// A stage's output, kept while its key stays equal; its revision moves only when its value does.
#[derive(Debug)]
struct Kept<K, V> {
    memo: Memo<K, ()>,
    out: Rev<V>,
}

impl<K: PartialEq, V: PartialEq + Default> Default for Kept<K, V> {
    fn default() -> Self {
        Self { memo: Memo::default(), out: Rev::new(V::default()) }
    }
}

impl<K: PartialEq, V: PartialEq> Kept<K, V> {
    fn update(&mut self, key: K, compute: impl FnOnce() -> V) {
        let out = &mut self.out;
        self.memo.get(key, |_| out.set(compute()));
    }
}

/// How often each stage of a draw has run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[expect(missing_docs, reason = "the names are the stages")]
pub struct DrawRuns {
    pub world: usize,
    pub view: usize,
    pub clip: usize,
    pub cull: usize,
    pub polygons: usize,
    pub divide: usize,
    pub viewport: usize,
    pub shade: usize,
}

impl DrawRuns {
    /// How many stages there are.
    pub const STAGES: usize = 8;

    /// All of them together.
    pub fn total(&self) -> usize {
        let Self { world, view, clip, cull, polygons, divide, viewport, shade } = *self;
        world + view + clip + cull + polygons + divide + viewport + shade
    }
}

/// What does not depend on the draw.
pub(super) struct Shared<'s> {
    pub(super) scene: &'s Scene,
    pub(super) view: Matrix,
    pub(super) projection: Matrix,
    pub(super) viewport: Viewport,
    pub(super) skips: Skips,
}

/// What light depends on: vertices, mesh and model matrix, and how, from where and by what it is lit.
type LitKey = ((u64, u64, Matrix), (Shade, Camera), (Vec<Light>, Material));

/// What the stages made of one draw.
#[derive(Debug, Default)]
pub struct DrawOutputs {
    mesh: Arc<Mesh>,
    /// Moves when the mesh does.
    mesh_rev: u64,
    model: Matrix,
    bounds: Kept<u64, Option<Bounds>>,
    body: Kept<(u64, Body), Option<Volume>>,
    outside: Option<Plane>,
    world: Kept<(u64, Matrix, bool), Vec<Point>>,
    view: Kept<(u64, Matrix), Vec<Point>>,
    clip: Kept<(u64, Matrix), Vec<Point>>,
    cull: Kept<(u64, u64, CullKey), Culled>,
    polygons: Kept<(u64, u64, [u64; 2], Visible), Clipped>,
    ndc: Kept<u64, Vec<Point>>,
    screen: Kept<(u64, Viewport), Vec<Point>>,
    lit: Kept<LitKey, Lit>,
}

impl DrawOutputs {
    /// The mesh that was drawn; empty for a model that was not loaded.
    pub fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    /// Object to world space.
    pub fn model(&self) -> &Matrix {
        &self.model
    }

    /// The plane that the body around the object lies outside of. Its vertices were not transformed
    /// then, and all further stages are empty.
    pub fn outside(&self) -> Option<Plane> {
        self.outside
    }

    /// The vertices in world space.
    pub fn world(&self) -> &[Point] {
        self.world.out.get()
    }

    /// The vertices in camera space.
    pub fn view(&self) -> &[Point] {
        self.view.out.get()
    }

    /// The vertices in clip space.
    pub fn clip(&self) -> &[Point] {
        self.clip.out.get()
    }

    /// What was decided about each triangle.
    pub fn culled(&self) -> &Culled {
        self.cull.out.get()
    }

    /// The clipped polygons with their attributes.
    pub fn clipped(&self) -> &Clipped {
        self.polygons.out.get()
    }

    /// The polygons' corners after the divide: (x, y, z, 1/w).
    pub fn ndc(&self) -> &[Point] {
        self.ndc.out.get()
    }

    /// The polygons' corners on the screen: x and y in pixels, depth, 1/w.
    pub fn screen(&self) -> &[Point] {
        self.screen.out.get()
    }

    /// The light on it.
    pub fn lit(&self) -> &Lit {
        self.lit.out.get()
    }

    /// What is interpolated over its triangles.
    pub(super) fn varyings(&self) -> Varyings<'_> {
        Varyings::new(&self.mesh, self.lit())
    }

    /// How often each stage has run.
    pub fn runs(&self) -> DrawRuns {
        DrawRuns {
            world: self.world.memo.runs(),
            view: self.view.memo.runs(),
            clip: self.clip.memo.runs(),
            cull: self.cull.memo.runs(),
            polygons: self.polygons.memo.runs(),
            divide: self.ndc.memo.runs(),
            viewport: self.screen.memo.runs(),
            shade: self.lit.memo.runs(),
        }
    }

    /// What the image depends on.
    pub(super) fn revisions(&self) -> [u64; 3] {
        [self.polygons.out.rev(), self.screen.out.rev(), self.lit.out.rev()]
    }

    /// Takes the draw's mesh and place, and what stands for the object in the frustum test.
    pub(super) fn place(&mut self, draw: &Draw, bounding: Bounding) {
        self.set_mesh(draw.geometry.mesh().cloned().unwrap_or_default());
        let mesh = &*self.mesh;
        self.model = model_matrix(&draw.transform);
        match bounding {
            Bounding::Tree => self.bounds.update(self.mesh_rev, || Bounds::of(&mesh.positions)),
            Bounding::Box => self.keep_body(Body::Box),
            Bounding::Sphere => self.keep_body(Body::Sphere),
        }
    }

    fn keep_body(&mut self, body: Body) {
        let mesh = &*self.mesh;
        self.body.update((self.mesh_rev, body), || body.around(&mesh.positions));
    }

    /// The body around the object in object space; `None` if it has no vertices.
    pub(super) fn body(&self) -> Option<&Volume> {
        self.body.out.get().as_ref()
    }

    /// A box that no vertex in world space lies outside of, rounded as the pipeline does; `None` for a
    /// model whose matrix is a projection: its vertices are no points there.
    pub(super) fn world_box(&self) -> Option<Aabb> {
        let Bounds { min, max } = self.bounds.out.get().as_ref()?.through(&self.model);
        let corner = |[x, y, z, _]: [f32; 4]| [x, y, z];
        (min[3] == 1.0 && max[3] == 1.0).then(|| [corner(min), corner(max)])
    }

    /// Brings the stages up to date; `outside`: a plane that the whole object lies outside of.
    pub(super) fn update(&mut self, draw: &Draw, shared: &Shared<'_>, outside: Option<Plane>) {
        let key = CullKey::new(draw, shared.scene.depth_range, shared.skips);
        // A body may lie beyond a plane that does not clip.
        self.outside = outside.filter(|plane| key.visible.clips_at(*plane));
        let mesh = &*self.mesh;
        let model = self.model;
        let is_outside = self.outside.is_some();
        self.world.update((self.mesh_rev, model, is_outside), || {
            let positions = if is_outside { &[] } else { &mesh.positions[..] };
            positions.iter().map(|&[x, y, z]| apply(&model, [x, y, z, 1.0])).collect()
        });
        let world = &self.world.out;
        self.view.update((world.rev(), shared.view), || through(&shared.view, world.get()));
        let view = &self.view.out;
        self.clip.update((view.rev(), shared.projection), || through(&shared.projection, view.get()));
        let clip = &self.clip.out;
        self.cull.update((clip.rev(), self.mesh_rev, key), || stages::cull(&key, clip.get(), mesh));
        let Scene { camera, lights, .. } = shared.scene;
        let lit = (draw.shade, *camera);
        self.lit.update(((world.rev(), self.mesh_rev, model), lit, (lights.clone(), draw.material)), || {
            let illumination = Illumination::new(camera, lights, draw.material);
            Lit::new(draw.shade, mesh, &model, world.get(), &illumination)
        });
        let lit = &self.lit.out;
        let (cull, varyings) = (&self.cull.out, Varyings::new(mesh, lit.get()));
        // A factor for each triangle is not interpolated.
        let attributes = [self.mesh_rev, if lit.get().normals.is_empty() { 0 } else { lit.rev() }];
        self.polygons.update((clip.rev(), cull.rev(), attributes, key.visible), || {
            stages::clip(cull.get(), clip.get(), &varyings, key.visible)
        });
        let polygons = &self.polygons.out;
        self.ndc.update(polygons.rev(), || polygons.get().corners.iter().copied().map(divide).collect());
        let ndc = &self.ndc.out;
        let viewport = shared.viewport;
        self.screen.update((ndc.rev(), viewport), || {
            ndc.get().iter().map(|&point| viewport.to_screen(point)).collect()
        });
    }

    /// The revision moves unless it is the same mesh, or an equal one.
    fn set_mesh(&mut self, mesh: Arc<Mesh>) {
        if !Arc::ptr_eq(&self.mesh, &mesh) {
            self.mesh_rev += u64::from(self.mesh != mesh);
            self.mesh = mesh;
        }
    }

    /// Adds what this draw's stages counted.
    pub(super) fn count(&self, stats: &mut Stats) {
        let triangles = self.mesh().triangles.len();
        stats.pass(Stage::Scene, triangles, triangles);
        if self.outside.is_some() {
            stats.stage_mut(Stage::Cull).drop(Reason::ObjectFrustum, triangles as u64);
            stats.skip(Skip::ObjectFrustum, triangles as u64);
        }
        let vertices = self.mesh().positions.len();
        stats.pass(Stage::Model, vertices, self.world().len());
        stats.pass(Stage::View, self.world().len(), self.view().len());
        stats.pass(Stage::ClipSpace, self.view().len(), self.clip().len());
        let mut kept = 0;
        for decision in &self.culled().decisions {
            if decision.fate != Fate::Dropped {
                kept += 1;
                continue;
            }
            let (reason, skip) = match decision.facing {
                None => (Reason::Frustum, Skip::Frustum),
                Some(Facing::Degenerate) => (Reason::Degenerate, Skip::Degenerate),
                Some(Facing::Back) => (Reason::BackFace, Skip::BackFace),
                Some(Facing::Front) => (Reason::FrontFace, Skip::BackFace),
            };
            stats.stage_mut(Stage::Cull).drop(reason, 1);
            stats.skip(skip, 1);
        }
        stats.pass(Stage::Cull, triangles, kept);
        let clipped = self.clipped();
        stats.pass(Stage::Clip, kept, clipped.pieces.len());
        stats.stage_mut(Stage::Clip).drop(Reason::Clipped, clipped.lost as u64);
        stats.cut += clipped.polygons.iter().filter(|polygon| polygon.cut).count() as u64;
        stats.pass(Stage::Divide, clipped.corners.len(), self.ndc().len());
        stats.pass(Stage::Viewport, self.ndc().len(), self.screen().len());
        stats.tally += self.culled().tally;
        stats.tally += clipped.tally;
    }
}

/// All vertices times a matrix.
fn through(matrix: &Matrix, points: &[Point]) -> Vec<Point> {
    points.iter().map(|&point| apply(matrix, point)).collect()
}
