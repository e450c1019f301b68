//! What the lab shows of a shading run.

use super::{Event, Input, Snapshot};
use crate::{
    compare::Fact,
    explain::{
        Explain, Formula, Level, Mark, Marker, Operations, Piece as Part, PixelReport, Role, Table, View,
    },
    message::{Message, Value},
    raster::view::view_of,
    scene::Shade,
    shade::lighting,
};

/// Of the listing's lines the first of the light's own.
const LIGHT: usize = 11;

impl Explain for Snapshot {
    const NAME: &'static str = "shading";
    const PREFIX: &'static str = "shade";

    const LISTING: &'static [&'static str] = &[
        "each vertex: the vertex stage",
        "  clip ← P V M p;  P ← M p;  N ← M⁻ᵀ n",
        "  Gouraud: c ← matte · c + gloss",
        "each triangle on the screen",
        "  flat: factor ← matte of the face",
        "  each row, each of its pixels",
        "    hidden by depth: next",
        "    the fragment stage: varyings",
        "    flat: c ← factor · c",
        "    Gouraud: c is lit already",
        "    Phong: c ← matte · c + gloss",
        "light: n ← N / |N|, v ← to the eye",
        "  matte ← ka;  gloss ← 0",
        "  l ← to the light;  f ← what comes",
        "  matte ← matte + f kd max(n·l, 0)",
        "  gloss ← gloss + f ks c^s",
    ];

    fn line(event: &Event) -> usize {
        match event {
            Event::Object { .. } => 0,
            Event::Vertex { .. } => 1,
            Event::VertexColor { .. } => 2,
            Event::Triangle { .. } | Event::Done { .. } => 3,
            Event::Face { .. } => 4,
            Event::Row { .. } => 5,
            Event::Hidden { .. } => 6,
            Event::Fragment { .. } | Event::Varying { .. } => 7,
            Event::Output { shade: Shade::Flat, .. } => 8,
            Event::Output { shade: Shade::None | Shade::Gouraud, .. } => 9,
            Event::Output { shade: Shade::Phong, .. } => 10,
            Event::Light(event) => LIGHT + light_line(event),
        }
    }

    fn operations(event: &Event) -> Operations {
        match event {
            // Three matrices with a vector each; the normal's has three rows.
            Event::Vertex { .. } => Operations::new(0, 57, 0),
            Event::VertexColor { shade: Shade::Gouraud, .. } => Operations::new(3, 3, 0),
            Event::Hidden { .. } | Event::Fragment { .. } => Operations::new(1, 3, 0),
            // One division a pixel, then three products a number.
            Event::Varying { input: Input::Uv, .. } => Operations::new(0, 6, 0),
            Event::Varying { .. } => Operations::new(0, 9, 0),
            Event::Output { shade: Shade::Flat, .. } => Operations::new(0, 3, 0),
            Event::Output { shade: Shade::Phong, .. } => Operations::new(3, 3, 0),
            Event::Light(event) => lighting::Snapshot::operations(event),
            _ => Operations::NONE,
        }
    }

    fn level(event: &Event) -> Level {
        match event {
            Event::Object { .. } | Event::Done { .. } => Level::Primitive,
            Event::VertexColor { .. }
            | Event::Triangle { .. }
            | Event::Face { .. }
            | Event::Output { .. } => Level::Row,
            _ => Level::Detail,
        }
    }

    fn marker(event: &Event) -> Option<Marker> {
        let (role, label) = match event {
            Event::Object { .. } => (Role::Neutral, Some("shade-marker-vertices")),
            Event::Triangle { .. } => (Role::Neutral, Some("shade-marker-triangle")),
            Event::Hidden { .. } => (Role::Rejected, None),
            Event::Output { .. } => (Role::Accepted, None),
            _ => return None,
        };
        Some(Marker { role, label })
    }

    fn opening(&self) -> Message {
        Message::new("shade-stages-opening")
    }

    fn sentence(&self, event: &Event) -> Message {
        let [x, y] = self.pixel.unwrap_or_default();
        let pixel = |id| Message::new(id).with("x", x).with("y", y);
        let name = || self.object().map_or(Value::None, |(object, _)| Value::text(&object.name));
        match *event {
            Event::Object { .. } => Message::new("shade-object").with("name", name()),
            Event::Vertex { index } => Message::new("shade-vertex").with("vertex", vertex_name(index)),
            Event::VertexColor { shade, color } => {
                let id = if shade == Shade::Gouraud { "shade-vertex-lit" } else { "shade-vertex-color" };
                let vertex = self.vertex.unwrap_or_default() as u32;
                Message::new(id).with("vertex", vertex_name(vertex)).with("color", color)
            }
            Event::Triangle { piece } => {
                Message::new("shade-triangle").with("number", piece + 1).with("name", name())
            }
            Event::Face { factor } => Message::new("shade-face").with("factor", factor),
            Event::Row { y, begin, end } => Message::new("shade-row").with("y", y).with("count", end - begin),
            Event::Hidden { .. } => pixel("shade-hidden"),
            Event::Fragment { .. } => pixel("shade-fragment"),
            Event::Varying { input, value: [a, b, c] } => match input {
                Input::Place => Message::new("shade-varying-place").with("value", [a, b, c]),
                Input::Normal => {
                    let length = [a, b, c].iter().map(|c| f64::from(*c) * f64::from(*c)).sum::<f64>();
                    Message::new("shade-varying-normal")
                        .with("value", [a, b, c])
                        .with("length", libm::sqrt(length))
                }
                Input::Color => Message::new("shade-varying-color").with("value", [a, b, c]),
                Input::Uv => Message::new("shade-varying-uv").with("value", [a, b]),
            },
            Event::Output { shade, code: [r, g, b, a], value } => {
                let id = match shade {
                    Shade::None => "shade-output-none",
                    Shade::Flat => "shade-output-flat",
                    Shade::Gouraud => "shade-output-gouraud",
                    Shade::Phong => "shade-output-phong",
                };
                let code = Value::text(format_args!("({r}, {g}, {b}, {a})"));
                pixel(id).with("value", value).with("code", code)
            }
            Event::Done { drawn, hidden } => {
                let id = if hidden == 0 { "shade-done" } else { "shade-done-hidden" };
                Message::new(id).with("drawn", drawn).with("hidden", hidden)
            }
            Event::Light(event) => match &self.point {
                Some(point) => point.sentence(&event),
                None => self.opening(),
            },
        }
    }

    fn formulas(&self, event: &Event, out: &mut Vec<Formula>) {
        let number = |value: f64| Part::Number(value.into());
        match (*event, &self.point) {
            (Event::Light(event), Some(point)) => point.formulas(&event, out),
            (Event::Output { shade: Shade::Phong, value, .. }, Some(point)) => {
                let [r, g, b] = self.inputs[Input::Color as usize].unwrap_or_default();
                let light = point.brightness();
                out.push(Formula {
                    general: "max channel = matte · c + gloss",
                    numbers: vec![
                        Part::Text("= "),
                        number(light.matte),
                        Part::Text(" · "),
                        Part::Number(r.max(g).max(b).into()),
                        Part::Text(" + "),
                        number(light.gloss),
                        Part::Text(" → "),
                        Part::Result(value.into()),
                    ],
                });
            }
            (Event::Output { shade: Shade::Flat, value, .. }, _) => {
                let [r, g, b] = self.inputs[Input::Color as usize].unwrap_or_default();
                out.push(Formula {
                    general: "max channel = factor · c",
                    numbers: vec![
                        Part::Text("= "),
                        Part::Number(self.factor.into()),
                        Part::Text(" · "),
                        Part::Number(r.max(g).max(b).into()),
                        Part::Text(" = "),
                        Part::Result(value.into()),
                    ],
                });
            }
            _ => {}
        }
    }

    fn tables(&self, out: &mut Vec<Table>) {
        self.stage_tables(out);
    }

    fn marks(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        self.draw(event, out);
    }

    fn view(&self) -> View {
        let points: Vec<_> = self.triangles().map(|(_, _, corners)| corners).collect();
        view_of(&points, &self.subject.raster)
    }

    fn pixel(&self, at: [u32; 2]) -> Option<PixelReport> {
        Some(self.report(at))
    }

    fn facts(&self, out: &mut Vec<Fact>) {
        let [width, height] = self.image.size;
        for pixel in (0..height).flat_map(|y| (0..width).map(move |x| [x, y])) {
            if let Some(shown) = self.image.at(pixel) {
                let code = u32::from(shown.code[0].max(shown.code[1]).max(shown.code[2]));
                out.push(Fact::pixel(pixel, vec![("column-code", code.into())]));
            }
        }
    }
}

/// The line of a light's step below the first one of the light's own.
fn light_line(event: &lighting::Event) -> usize {
    use lighting::{Event as Light, Vector};
    match event {
        Light::Unit { vector: Vector::Light, .. }
        | Light::NoDirection { vector: Vector::Light }
        | Light::Fade { .. } => 2,
        Light::Turned { .. }
        | Light::Unit { .. }
        | Light::AsItIs { .. }
        | Light::NoDirection { .. }
        | Light::Flipped { .. } => 0,
        Light::Ambient { .. } => 1,
        Light::Incidence { .. } | Light::Behind | Light::Diffuse { .. } => 3,
        Light::Mirrored { .. }
        | Light::Halfway { .. }
        | Light::Highlight { .. }
        | Light::Power { .. }
        | Light::Specular { .. }
        | Light::Sum { .. } => 4,
    }
}

/// As on the canvas.
pub(super) fn vertex_name(index: u32) -> Value {
    Value::text(format_args!("v{index}"))
}
