//! What can lie on the image: a number for each pixel, the wires of the triangles, what an edit changed.

use super::{Frame, Outputs, PixelCounts, ScreenTriangle, Skips, frame::stored_depth, render};
use crate::{
    explain::{Field, Numbers, Tone},
    raster::line::diamond_exit,
    scene::Scene,
};
use std::sync::Arc;

/// What lies on the image.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Overlay {
    /// Nothing.
    #[default]
    None,
    /// The stored depth of each pixel.
    Depth,
    /// The stencil value of each pixel.
    Stencil,
    /// How many fragments each pixel got.
    Generated,
    /// How many fragments were written to each pixel.
    Written,
    /// The outlines of all triangles that are scan converted.
    Wireframe,
    /// The triangle under the pointer.
    Triangle,
    /// The pixels that the last edit changed.
    Changed,
    /// How many fragments of each pixel had the very depth code that was stored: where surfaces fight.
    Equal,
}

impl Overlay {
    /// All, in the order in which a key steps through them.
    pub const ALL: [Self; 9] = [
        Self::None,
        Self::Depth,
        Self::Stencil,
        Self::Generated,
        Self::Written,
        Self::Wireframe,
        Self::Triangle,
        Self::Changed,
        Self::Equal,
    ];

    /// The name on the command line and in what is kept.
    pub fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Depth => "depth",
            Self::Stencil => "stencil",
            Self::Generated => "generated",
            Self::Written => "written",
            Self::Wireframe => "wireframe",
            Self::Triangle => "triangle",
            Self::Changed => "changed",
            Self::Equal => "equal-codes",
        }
    }

    /// The overlay called `name`.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|overlay| overlay.name() == name)
    }

    /// Message id of its name for people.
    pub fn word(self) -> &'static str {
        match self {
            Self::None => "pipeline-overlay-none",
            Self::Depth => "pipeline-overlay-depth",
            Self::Stencil => "pipeline-overlay-stencil",
            Self::Generated => "pipeline-overlay-generated",
            Self::Written => "pipeline-overlay-written",
            Self::Wireframe => "pipeline-overlay-wireframe",
            Self::Triangle => "pipeline-overlay-triangle",
            Self::Changed => "pipeline-overlay-changed",
            Self::Equal => "pipeline-overlay-equal",
        }
    }

    /// Whether the image alone does not tell: the scene is drawn once more, and counted.
    pub fn counts(self) -> bool {
        matches!(self, Self::Generated | Self::Written | Self::Equal | Self::Triangle)
    }

    /// The number that it lays on each pixel; `None` if it lays none, or if it counts and there are no
    /// counts.
    pub fn field(self, scene: &Scene, frame: &Frame, counts: Option<&PixelCounts>) -> Option<Field> {
        let size = frame.size;
        Some(match self {
            Self::Depth => {
                let format = scene.depth_format;
                let clear = stored_depth(format, format.encode(scene.clear.depth));
                // What is nearer has the stronger shade.
                Field::new(size, Tone::Grey, Numbers::Floats(frame.depth.clone()), clear, !scene.reversed)
            }
            Self::Stencil => {
                let values = frame.stencil.iter().map(|value| u32::from(*value)).collect();
                let clear = f32::from(scene.clear.stencil);
                Field::new(size, Tone::Grey, Numbers::Counts(values), clear, false)
            }
            Self::Generated => heat(size, &counts?.generated),
            Self::Written => heat(size, &counts?.written),
            Self::Equal => heat(size, &counts?.equal),
            Self::None | Self::Wireframe | Self::Triangle | Self::Changed => return None,
        })
    }
}

fn heat(size: [u32; 2], counts: &[u32]) -> Field {
    Field::new(size, Tone::Heat, Numbers::Counts(counts.to_vec()), 0.0, false)
}

/// The wires of the triangles that are scan converted.
#[derive(Clone, Debug, PartialEq)]
pub enum Wires {
    /// Each edge once, in pixels.
    Lines(Vec<[[f32; 2]; 2]>),
    /// Too many for lines: the pixels that an edge passes, row by row.
    Pixels(Vec<bool>),
}

impl Wires {
    /// More edges than these become pixels: as lines they would hide each other.
    pub const MOST_LINES: usize = 6_000;

    /// The wires of all triangles that are drawn. What is not finite is left out.
    pub fn of(outputs: &Outputs) -> Self {
        let mut edges: Vec<_> = outputs.triangles().flat_map(edges_of).collect();
        edges.sort_unstable_by_key(|edge| edge.map(|end| end.map(f32::to_bits)));
        edges.dedup();
        if edges.len() <= Self::MOST_LINES {
            return Self::Lines(edges);
        }
        let size = outputs.frame.size;
        let mut pixels = vec![false; size[0] as usize * size[1] as usize];
        for edge in edges {
            diamond_exit::draw(edge, size, &mut Default::default(), &mut |at| {
                pixels[outputs.frame.index(at)] = true;
            });
        }
        Self::Pixels(pixels)
    }
}

/// Each edge from the lower end, so that neighbours have the same.
fn edges_of(triangle: ScreenTriangle) -> impl Iterator<Item = [[f32; 2]; 2]> {
    let corners = triangle.vertices.map(|[x, y, _]| [x, y]);
    [[0, 1], [1, 2], [2, 0]].into_iter().filter_map(move |[a, b]| {
        let ends = [corners[a], corners[b]];
        let key = |p: [f32; 2]| p.map(f32::to_bits);
        let finite = ends.as_flattened().iter().all(|c| c.is_finite());
        finite.then(|| if key(ends[0]) <= key(ends[1]) { ends } else { [ends[1], ends[0]] })
    })
}

/// In what two images of a scene differ.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Changed {
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// The pixels that differ in anything, row by row.
    pub pixels: Vec<[u32; 2]>,
    /// How many differ in colour.
    pub color: usize,
    /// How many differ in the bits of their depth.
    pub depth: usize,
    /// How many differ in their stencil value.
    pub stencil: usize,
}

impl Changed {
    /// Compares two images; `None` if they have different sizes.
    pub fn between(before: &Frame, now: &Frame) -> Option<Self> {
        if before.size != now.size {
            return None;
        }
        let mut changed = Self { size: now.size, ..Self::default() };
        let [width, height] = now.size;
        for pixel in (0..height).flat_map(|y| (0..width).map(move |x| [x, y])) {
            let at = now.index(pixel);
            let color = before.color[4 * at..4 * at + 4] != now.color[4 * at..4 * at + 4];
            let depth = before.depth[at].to_bits() != now.depth[at].to_bits();
            let stencil = before.stencil[at] != now.stencil[at];
            if color || depth || stencil {
                changed.pixels.push(pixel);
                changed.color += usize::from(color);
                changed.depth += usize::from(depth);
                changed.stencil += usize::from(stencil);
            }
        }
        Some(changed)
    }
}

/// What lies on one image, computed.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Layer {
    /// Nothing, or nothing that stands still.
    #[default]
    Nothing,
    /// A number on each pixel, and which overlay it is.
    Field(Overlay, Arc<Field>),
    /// The outlines of all triangles.
    Wires(Arc<Wires>),
    /// What the last edit changed; `None` if there was none, or if the image had another size before.
    Changed(Option<Arc<Changed>>),
}

impl Layer {
    /// What an overlay lays on the image of a scene. `before`: the scene before the last edit, with its
    /// skips. Costs another image for the overlays that count or compare.
    pub fn of(
        overlay: Overlay,
        scene: &Scene,
        outputs: &Outputs,
        counts: Option<&PixelCounts>,
        before: Option<&(Scene, Skips)>,
    ) -> Self {
        match overlay {
            Overlay::Wireframe => Self::Wires(Arc::new(Wires::of(outputs))),
            Overlay::Changed => {
                let changed = before
                    .and_then(|(before, skips)| Changed::between(&render(before, skips), &outputs.frame));
                Self::Changed(changed.map(Arc::new))
            }
            _ => match overlay.field(scene, &outputs.frame, counts) {
                Some(field) => Self::Field(overlay, Arc::new(field)),
                None => Self::Nothing,
            },
        }
    }
}
