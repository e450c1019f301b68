//! The history of a pixel in words.

use rasterscope_core::{
    depth::DepthFormat,
    explain::Role,
    message::{Message, Value},
    pipeline::{
        Outcome, Outputs, PixelCounts, PixelEntry, PixelHistory, ScreenTriangle, draw_name, pixel_history,
        pixel_light, triangle_name,
    },
    scene::Scene,
};
use rasterscope_figure::words::Words;

/// What happened to a pixel, ready to be shown.
#[derive(Clone, Debug)]
pub(crate) struct History {
    pub(crate) pixel: [u32; 2],
    /// The image's.
    pub(crate) size: [u32; 2],
    /// Its colour codes now.
    pub(crate) color: [u8; 4],
    /// What the clear left, in order: depth, code.
    pub(crate) clear: String,
    pub(crate) entries: Vec<Entry>,
    pub(crate) sentence: String,
}

/// One fragment, or what kept it from becoming one.
#[derive(Clone, Debug)]
pub(crate) struct Entry {
    pub(crate) name: String,
    pub(crate) reason: String,
    pub(crate) role: Role,
    pub(crate) details: Vec<String>,
    /// Whether a run over the fragments steps through it.
    pub(crate) fragment: bool,
    pub(crate) of: PixelEntry,
}

impl History {
    pub(crate) fn new(history: &PixelHistory, scene: &Scene, outputs: &Outputs, words: &Words) -> Self {
        let light = |entry| pixel_light(scene, outputs, entry);
        let entries = history.entries.iter().map(|entry| Entry {
            name: entry.name.clone(),
            reason: words.message(&entry.reason()),
            role: entry.role(),
            details: entry
                .details(scene)
                .iter()
                .chain(&light(entry))
                .map(|line| words.message(line))
                .collect(),
            fragment: entry.is_fragment(),
            of: entry.clone(),
        });
        Self {
            pixel: history.pixel,
            size: scene.size,
            color: history.color,
            clear: words.value(&Value::F64(scene.depth_format.decode(history.clear_depth))),
            entries: entries.collect(),
            sentence: words.message(&history.sentence()),
        }
    }
}

/// Of larger scenes the pointer is not told who drew a pixel: that looks at every triangle.
const MOST_TRIANGLES: usize = 20_000;

/// What a pixel holds, for the line below the canvas.
#[derive(Clone, Debug)]
pub(crate) struct Hover {
    pub(crate) pixel: [u32; 2],
    pub(crate) text: String,
    /// The triangle that is seen there, if it is known: its corners on the screen, and its name.
    pub(crate) triangle: Option<(Vec<[f32; 2]>, String)>,
}

impl Hover {
    pub(crate) fn new(
        (scene, outputs): (&Scene, &Outputs),
        counts: Option<&PixelCounts>,
        pixel: [u32; 2],
        words: &Words,
    ) -> Self {
        let frame = &outputs.frame;
        let at = frame.index(pixel);
        if let Some(counts) = counts {
            let triangle = counts.last_written(at);
            let fragments = Message::new("ui-readout-fragments")
                .with("written", counts.written[at])
                .with("generated", counts.generated[at]);
            let seen = match triangle {
                Some(triangle) => words.message(&number(scene, triangle)),
                None => words.word("ui-readout-clear"),
            };
            let text = format!("{seen}  {}", words.message(&fragments));
            let triangle = triangle.map(|triangle| outline(scene, outputs, triangle));
            return Self { pixel, text, triangle };
        }
        let depth = Message::new("ui-readout-depth").with("depth", frame.depth[at]);
        let mut parts = vec![words.message(&depth)];
        if let Some(codes) = frame.depth_codes.as_ref().filter(|_| scene.depth_format != DepthFormat::F32) {
            let code = Value::Code { code: codes[at], width: scene.depth_format.bits() };
            parts.push(words.message(&Message::new("ui-readout-code").with("code", code)));
        }
        let triangles: usize = outputs.draws.iter().map(|draw| draw.mesh().triangles.len()).sum();
        if triangles <= MOST_TRIANGLES {
            let history = pixel_history(scene, outputs, pixel);
            let drawn =
                history.entries.iter().rfind(|entry| matches!(entry.outcome, Outcome::Written { .. }));
            parts.push(match drawn {
                Some(entry) => {
                    words.message(&Message::new("ui-readout-by").with("name", Value::text(&entry.name)))
                }
                None => words.word("ui-readout-clear"),
            });
        }
        Self { pixel, text: parts.join("  "), triangle: None }
    }
}

/// Which triangle of its draw a piece is of, from 1.
fn number(scene: &Scene, piece: &ScreenTriangle) -> Message {
    let index = piece.draw as usize;
    let draw = &scene.draws[index];
    let count = draw.geometry.mesh().map_or(0, |mesh| mesh.triangles.len());
    Message::new("ui-readout-triangle")
        .with("number", piece.triangle + 1)
        .with("count", count)
        .with("name", Value::Text(draw_name((index, draw))))
}

/// What clipping left of the triangle that a piece is of, and what it is called.
fn outline(scene: &Scene, outputs: &Outputs, piece: &ScreenTriangle) -> (Vec<[f32; 2]>, String) {
    let index = piece.draw as usize;
    let stages = &outputs.draws[index];
    let polygons = &stages.clipped().polygons;
    let polygon = polygons.iter().find(|polygon| polygon.triangle == piece.triangle);
    let corners =
        polygon.map_or(&[][..], |polygon| &stages.screen()[polygon.first as usize..][..polygon.len as usize]);
    let name = triangle_name((index, &scene.draws[index]), piece.triangle, None);
    (corners.iter().map(|[x, y, ..]| [*x, *y]).collect(), name)
}
