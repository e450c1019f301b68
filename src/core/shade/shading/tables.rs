//! What goes into the stages and what comes out, as tables; and all about one pixel.

use super::{Input, Snapshot, corners};
use crate::{
    explain::{PixelReport, Row, Table},
    math::Tally,
    message::{Message, Value},
    pipeline::Shader,
    raster::edge::centre,
    scene::Shade,
};

/// Headings of places, colours and texture coordinates at once.
const COLUMNS: [&str; 4] = ["x r u", "y g v", "z b", "w a"];

/// A row of up to four numbers.
fn row<const N: usize>(name: &str, values: Option<[f32; N]>) -> Row {
    let mut cells: Vec<Value> = match values {
        Some(values) => values.map(Value::from).to_vec(),
        None => vec![Value::None; N],
    };
    cells.resize(4, Value::BLANK);
    Row::new(name, cells)
}

fn table(title: &'static str, rows: Vec<Row>) -> Table {
    Table { title, columns: COLUMNS.to_vec(), rows }
}

impl Snapshot {
    /// The stage in hand, the light in hand, and the counts.
    pub(super) fn stage_tables(&self, out: &mut Vec<Table>) {
        if let Some(vertex) = self.vertex {
            self.vertex_tables(vertex, out);
        } else if self.pixel.is_some() && !self.hidden {
            self.fragment_tables(out);
        }
        if let Some(point) = &self.point {
            out.push(point.terms_table());
            out.push(point.vectors_table());
        }
        let count = |n: u64| Value::Int(i64::try_from(n).unwrap_or(i64::MAX));
        out.push(Table {
            title: "shade-counts",
            columns: vec!["column-shade-lights", "column-shade-drawn", "column-shade-hidden"],
            rows: vec![Row::new("row-sum", self.counts.map(count).to_vec())],
        });
    }

    fn vertex_tables(&self, vertex: usize, out: &mut Vec<Table>) {
        let Some((object, stages)) = self.object() else { return };
        let mesh = stages.mesh();
        let mut given = vec![
            row("row-shade-position", mesh.positions.get(vertex).copied()),
            row("row-shade-color", mesh.colors.get(vertex).copied()),
        ];
        if let Some(normal) = mesh.normals.get(vertex) {
            given.insert(1, row("row-shade-normal", Some(*normal)));
        }
        given.extend(mesh.uvs.get(vertex).map(|uv| row("row-shade-uv", Some(*uv))));
        out.push(table("shade-vertex-in", given));
        let mut gives = vec![row("row-shade-clip", stages.clip().get(vertex).copied())];
        if let Some(normal) = stages.lit().normals.get(vertex) {
            let place = stages.world().get(vertex).map(|&[x, y, z, _]| [x, y, z]);
            gives.push(row("row-shade-place", place));
            gives.push(row("row-shade-world-normal", Some(*normal)));
        }
        let lit = if object.shade == Shade::Gouraud { "row-shade-lit" } else { "row-shade-color" };
        gives.push(row(lit, self.vertex_color).active(self.vertex_color.is_some()));
        out.push(table("shade-vertex-out", gives));
    }

    fn fragment_tables(&self, out: &mut Vec<Table>) {
        let [place, normal, color, uv] = self.inputs;
        let mut given = Vec::new();
        given.extend(place.map(|place| row("row-shade-place", Some(place))));
        given.extend(normal.map(|normal| row("row-shade-world-normal", Some(normal))));
        given.extend(uv.map(|[u, v, _]| row("row-shade-uv", Some([u, v]))));
        given.push(row("row-shade-color", color));
        given.extend(self.factor.map(|factor| row("row-shade-factor", Some([factor]))));
        out.push(table("shade-fragment-in", given));
        let code = self.output.map(|(code, _)| code.map(f32::from));
        let value = self.output.map(|(_, value)| [value]);
        let gives = vec![row("row-shade-value", value), row("row-shade-code", code).active(code.is_some())];
        out.push(table("shade-fragment-out", gives));
    }

    /// What a pixel shows in the end, from what, and in which light.
    pub(super) fn report(&self, at: [u32; 2]) -> PixelReport {
        let [x, y] = at;
        let inside = x < self.image.size[0] && y < self.image.size[1];
        let shown = if inside { self.image.at(at) } else { None };
        let none =
            PixelReport { sentence: Message::new("shade-pixel-none"), warning: None, tables: Vec::new() };
        let Some(shown) = shown else { return none };
        let (object, piece) = shown.owner;
        let (Some(object), Some(stages)) = (
            self.subject.objects.get(usize::from(object)),
            self.subject.outputs.draws.get(usize::from(object)),
        ) else {
            return none;
        };
        let mut tally = Tally::default();
        let piece = stages.clipped().pieces.get(piece as usize);
        let shader = piece.and_then(|piece| Shader::new(stages, piece, object.texture, &mut tally));
        let Some(shader) = shader else { return none };
        let inputs = shader.inputs(centre(x, y), &mut tally);
        let mut own = Self { pixel: Some(at), vertex: None, hidden: false, ..self.clone() };
        own.factor = piece.and_then(|piece| stages.lit().factors.get(piece.triangle as usize).copied());
        let [r, g, b, _] = inputs.color;
        own.inputs = [None; 4];
        own.inputs[Input::Color as usize] = Some([r, g, b]);
        own.inputs[Input::Uv as usize] = inputs.uv.map(|[u, v]| [u, v, 0.0]);
        own.output = Some((shown.code, shown.value));
        own.point = None;
        let mut tables = Vec::new();
        if let Some(surface) = inputs.surface {
            own.inputs[Input::Place as usize] = Some(surface.position);
            own.inputs[Input::Normal as usize] = Some(surface.normal);
            let light = object.illumination.at_pixel_traced(surface, &mut crate::trace::NoTrace);
            let terms = [("row-shade-matte", light.matte), ("row-shade-gloss", light.gloss)];
            tables.push(Table {
                title: "shade-terms",
                columns: vec!["column-value"],
                rows: terms.map(|(name, value)| Row::new(name, vec![value.into()])).to_vec(),
            });
        }
        own.fragment_tables(&mut tables);
        let sentence = Message::new("shade-pixel-shown")
            .with("name", Value::text(&object.name))
            .with("value", shown.value);
        PixelReport { sentence, warning: None, tables }
    }

    /// Every triangle on the screen: object, piece, corners in pixels.
    pub(super) fn triangles(&self) -> impl Iterator<Item = (usize, usize, [[f32; 2]; 3])> + '_ {
        self.subject.outputs.draws.iter().enumerate().flat_map(|(object, stages)| {
            stages
                .clipped()
                .pieces
                .iter()
                .enumerate()
                .map(move |(index, piece)| (object, index, corners(stages, piece).map(|[x, y, _]| [x, y])))
        })
    }
}
