//! What the lab shows of a point in a light.

use super::{Event, Snapshot, Vector};
use crate::{
    compare::Fact,
    explain::{Explain, Formula, Level, Mark, Marker, Operations, Role, Row, Table, View},
    message::{Message, Value},
    shade::{Model, Place},
};

/// The names of the unit vectors, in the order of [`Vector`].
pub(super) const UNITS: [&str; 3] = ["n", "v", "l"];

impl Explain for Snapshot {
    const NAME: &'static str = "lighting";
    const PREFIX: &'static str = "shade";

    const LISTING: &'static [&'static str] = &[
        "N′ ← inverse transpose of M · N",
        "n ← N′ / |N′|;  v ← (E − P) / |E − P|",
        "both sides are lit and n·v < 0: n ← −n",
        "ambient ← ka",
        "l ← (L − P) / |L − P|",
        "f ← i / (c0 + c1 d + c2 d²)",
        "n·l",
        "n·l ≤ 0: behind the surface; no more",
        "diffuse ← f kd (n·l)",
        "r ← 2 (n·l) n − l;  c ← max(r·v, 0)",
        "h ← (l+v) / |l+v|;  c ← max(n·h, 0)",
        "specular ← f ks c^s",
        "I ← ambient + diffuse + specular ≤ 1",
    ];

    fn line(event: &Event) -> usize {
        match event {
            Event::Turned { .. } => 0,
            Event::Unit { vector: Vector::Light, .. } | Event::NoDirection { vector: Vector::Light } => 4,
            Event::Unit { .. } | Event::AsItIs { .. } | Event::NoDirection { .. } => 1,
            Event::Flipped { .. } => 2,
            Event::Ambient { .. } => 3,
            Event::Fade { .. } => 5,
            Event::Incidence { .. } => 6,
            Event::Behind => 7,
            Event::Diffuse { .. } => 8,
            Event::Mirrored { .. } | Event::Highlight { model: Model::Phong, .. } => 9,
            Event::Halfway { .. } | Event::Highlight { .. } => 10,
            Event::Power { .. } | Event::Specular { .. } => 11,
            Event::Sum { .. } => 12,
        }
    }

    fn operations(event: &Event) -> Operations {
        match event {
            Event::Turned { .. } => Operations::new(0, 9, 0),
            Event::Unit { .. } | Event::Halfway { .. } => Operations::new(0, 3, 3),
            Event::NoDirection { .. } | Event::Incidence { .. } => Operations::new(0, 3, 0),
            Event::Flipped { .. } | Event::Highlight { .. } => Operations::new(1, 3, 0),
            Event::Fade { .. } => Operations::new(0, 6, 1),
            Event::Behind => Operations::new(1, 0, 0),
            Event::Diffuse { .. } => Operations::new(1, 2, 0),
            Event::Mirrored { .. } => Operations::new(0, 3, 0),
            // One square for each bit, one product for each bit that is set.
            Event::Power { exponent, .. } => {
                let bits = u16::BITS - exponent.leading_zeros();
                Operations::new(0, u64::from(bits + exponent.count_ones()), 0)
            }
            Event::Specular { .. } => Operations::new(0, 2, 0),
            Event::Sum { .. } => Operations::new(1, 0, 0),
            Event::Ambient { .. } | Event::AsItIs { .. } => Operations::NONE,
        }
    }

    fn level(event: &Event) -> Level {
        match event {
            Event::Sum { .. } => Level::Primitive,
            Event::Ambient { .. } | Event::Behind | Event::Diffuse { .. } | Event::Specular { .. } => {
                Level::Row
            }
            _ => Level::Detail,
        }
    }

    fn marker(event: &Event) -> Option<Marker> {
        // A part has its name where it begins, so that it is the current one until the next begins.
        let (role, label) = match event {
            Event::Unit { vector: Vector::Normal, .. } => (Role::Neutral, Some("shade-marker-vectors")),
            Event::Ambient { .. } => (Role::Neutral, Some("shade-marker-ambient")),
            Event::Unit { vector: Vector::Light, .. } | Event::NoDirection { vector: Vector::Light } => {
                (Role::Neutral, Some("shade-marker-diffuse"))
            }
            Event::Behind => (Role::Rejected, Some("shade-marker-behind")),
            Event::Mirrored { .. } | Event::Halfway { .. } => (Role::Neutral, Some("shade-marker-specular")),
            Event::Diffuse { .. } | Event::Specular { .. } => (Role::Changed, None),
            Event::Sum { .. } => (Role::Accepted, Some("shade-marker-sum")),
            _ => return None,
        };
        Some(Marker { role, label })
    }

    fn opening(&self) -> Message {
        Message::new("shade-opening")
    }

    fn sentence(&self, event: &Event) -> Message {
        match *event {
            Event::Turned { normal } => {
                let id = if self.subject.mistaken { "shade-turned-mistaken" } else { "shade-turned" };
                Message::new(id).with("normal", self.vector(normal))
            }
            Event::Unit { vector, unit } => Message::new(match vector {
                Vector::Normal => "shade-unit-normal",
                Vector::Eye => "shade-unit-eye",
                Vector::Light => "shade-unit-light",
            })
            .with("unit", self.vector(unit)),
            Event::AsItIs { normal } => {
                let length = normal.iter().map(|c| f64::from(*c) * f64::from(*c)).sum::<f64>();
                Message::new("shade-as-it-is")
                    .with("normal", self.vector(normal))
                    .with("length", libm::sqrt(length))
            }
            Event::NoDirection { vector } => Message::new(match vector {
                Vector::Normal => "shade-no-normal",
                Vector::Eye => "shade-no-eye",
                Vector::Light => "shade-no-light",
            }),
            Event::Flipped { unit } => Message::new("shade-flipped").with("unit", self.vector(unit)),
            Event::Ambient { value } => Message::new("shade-ambient").with("value", value),
            Event::Fade { distance, factor } => {
                Message::new("shade-fade").with("distance", distance).with("factor", factor)
            }
            Event::Incidence { cosine } => {
                let degrees = libm::acos(cosine.clamp(-1.0, 1.0)).to_degrees();
                Message::new("shade-incidence").with("cosine", cosine).with("degrees", degrees)
            }
            Event::Behind => Message::new("shade-behind"),
            Event::Diffuse { value } => Message::new("shade-diffuse").with("value", value),
            Event::Mirrored { r } => Message::new("shade-mirrored").with("r", self.vector(r)),
            Event::Halfway { h } => Message::new("shade-halfway").with("h", self.vector(h)),
            Event::Highlight { model, cosine } => {
                let id = match (model, cosine > 0.0) {
                    (Model::Phong, true) => "shade-highlight-phong",
                    (Model::BlinnPhong, true) => "shade-highlight-blinn",
                    (_, false) => "shade-highlight-none",
                };
                let degrees = libm::acos(cosine.clamp(-1.0, 1.0)).to_degrees();
                Message::new(id).with("cosine", cosine).with("degrees", degrees)
            }
            Event::Power { exponent, value } => {
                Message::new("shade-power").with("exponent", u32::from(exponent)).with("value", value)
            }
            Event::Specular { value } => Message::new("shade-specular").with("value", value),
            Event::Sum { value } => {
                let sum = self.brightness();
                let id = if sum.matte + sum.gloss > 1.0 { "shade-sum-clamped" } else { "shade-sum" };
                Message::new(id).with("value", value).with("sum", sum.matte + sum.gloss)
            }
        }
    }

    fn formulas(&self, event: &Event, out: &mut Vec<Formula>) {
        out.extend(self.formula(event));
    }

    fn tables(&self, out: &mut Vec<Table>) {
        out.push(self.terms_table());
        out.push(self.vectors_table());
        out.push(self.numbers_table());
    }

    fn marks(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        self.draw(event, out);
    }

    fn view(&self) -> View {
        self.slice()
    }

    fn facts(&self, out: &mut Vec<Fact>) {
        let mut fact = |name: &'static str, value: Option<f64>| {
            if let Some(value) = value {
                out.push(Fact::named(name, vec![("column-value", Value::F32(value as f32))]));
            }
        };
        fact("n·l", self.incidence);
        fact(self.highlight_name(), self.highlight);
        for (name, value) in ["ambient", "diffuse", "specular"].into_iter().zip(self.terms) {
            fact(name, value);
        }
        fact("I", self.result.map(f64::from));
    }
}

impl Snapshot {
    /// A vector as it is written: two numbers where everything lies in one plane.
    pub(super) fn vector(&self, [x, y, z]: [f32; 3]) -> Value {
        if self.is_slice() { [x, y].into() } else { [x, y, z].into() }
    }

    /// Whether nothing leaves the plane z = 0.
    pub(super) fn is_slice(&self) -> bool {
        let of = |place: Place| match place {
            Place::Position(v) | Place::Direction(v) => v[2],
        };
        let subject = &self.subject;
        let all = [subject.surface.position[2], subject.surface.normal[2], of(subject.light.place)];
        all.iter().chain(&[of(subject.eye)]).all(|z| *z == 0.0)
    }

    /// What the highlight is made of.
    pub(super) fn highlight_name(&self) -> &'static str {
        match self.subject.material.model {
            Model::Phong => "r·v",
            Model::BlinnPhong => "n·h",
        }
    }

    /// The terms and their sum: what the lab is about.
    pub(in crate::shade) fn terms_table(&self) -> Table {
        let material = &self.subject.material;
        let shares = [material.ambient, material.diffuse, material.specular];
        let names = ["row-shade-ambient", "row-shade-diffuse", "row-shade-specular"];
        let mut rows: Vec<Row> = (0..3)
            .map(|i| {
                let cells = vec![shares[i].into(), self.terms[i].into()];
                Row::new(names[i], cells).active(self.computed == Some(i))
            })
            .collect();
        let sum = vec![Value::BLANK, self.result.map_or(Value::None, Value::from)];
        rows.push(Row::new("I", sum).active(self.result.is_some()));
        Table { title: "shade-terms", columns: vec!["k", "column-value"], rows }
    }

    /// n, v, l, and r or h.
    pub(in crate::shade) fn vectors_table(&self) -> Table {
        let slice = self.is_slice();
        let row = |name: &str, vector: Option<[f32; 3]>| {
            let cells = match vector {
                Some(vector) => vector.map(Value::from).to_vec(),
                None => vec![Value::None; 3],
            };
            Row::new(name, cells.into_iter().take(if slice { 2 } else { 3 }).collect())
        };
        let bisector = if self.subject.material.model == Model::Phong { "r" } else { "h" };
        let mut rows = vec![row("N′", self.turned)];
        rows.extend(UNITS.into_iter().zip(self.units).map(|(name, unit)| row(name, unit)));
        rows.push(row(bisector, self.bisector));
        let columns = ["x", "y", "z"].into_iter().take(if slice { 2 } else { 3 }).collect();
        Table { title: "shade-vectors", columns, rows }
    }

    /// The numbers between the vectors and the terms.
    fn numbers_table(&self) -> Table {
        let power = match self.subject.material.model {
            Model::Phong => "(r·v)^s",
            Model::BlinnPhong => "(n·h)^s",
        };
        let rows = [
            ("d", self.distance.map(f64::from)),
            ("f", self.fade),
            ("n·l", self.incidence),
            (self.highlight_name(), self.highlight),
            (power, self.power),
        ];
        let rows = rows.map(|(name, value)| Row::new(name, vec![value.into()])).to_vec();
        Table { title: "shade-numbers", columns: vec!["column-value"], rows }
    }
}
