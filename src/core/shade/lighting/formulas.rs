//! The formulas of a point in a light, with the numbers of a step.

use super::{Event, Snapshot, Vector};
use crate::{
    explain::{Formula, Piece},
    message::Value,
    shade::{Model, Place},
};

impl Snapshot {
    /// The formula of an event, if it computes something.
    pub(super) fn formula(&self, event: &Event) -> Option<Formula> {
        let material = &self.subject.material;
        let [n, v, l] = self.units.map(|unit| self.vector(unit.unwrap_or_default()));
        let known = |value: Option<f64>| Value::from(value);
        let times = |general, factors: &[Value], result: f64| {
            let mut numbers = Vec::new();
            for (i, factor) in factors.iter().enumerate() {
                numbers.push(Piece::Text(if i == 0 { "= " } else { " · " }));
                numbers.push(Piece::Number(factor.clone()));
            }
            numbers.extend([Piece::Text(" = "), Piece::Result(result.into())]);
            Some(Formula { general, numbers })
        };
        match *event {
            Event::Turned { normal } if self.subject.mistaken => {
                self.applied("N′ = M N", self.subject.surface.normal, normal)
            }
            Event::Turned { normal } => self.applied("N′ = M⁻ᵀ N", self.subject.surface.normal, normal),
            Event::Unit { vector, unit } => self.normalised(vector, unit),
            Event::Fade { distance, factor } => self.faded(distance, factor),
            Event::Incidence { cosine } => times("n · l", &[n, l], cosine),
            Event::Diffuse { value } => {
                let factors =
                    [known(self.fade_or_intensity()), material.diffuse.into(), known(self.incidence)];
                times("diffuse = f kd (n · l)", &factors, value)
            }
            Event::Mirrored { r } => {
                let numbers = vec![
                    Piece::Text("= 2 · "),
                    Piece::Number(known(self.incidence)),
                    Piece::Text(" "),
                    Piece::Number(n),
                    Piece::Text(" − "),
                    Piece::Number(l),
                    Piece::Text(" = "),
                    Piece::Result(self.vector(r)),
                ];
                Some(Formula { general: "r = 2 (n · l) n − l", numbers })
            }
            Event::Halfway { h } => {
                let numbers = vec![
                    Piece::Text("= "),
                    Piece::Number(l),
                    Piece::Text(" + "),
                    Piece::Number(v),
                    Piece::Text(", of length 1 = "),
                    Piece::Result(self.vector(h)),
                ];
                Some(Formula { general: "h = (l + v) / |l + v|", numbers })
            }
            Event::Highlight { model, cosine } => {
                let bisector = self.vector(self.bisector.unwrap_or_default());
                match model {
                    Model::Phong => times("c = max(r · v, 0)", &[bisector, v], cosine),
                    Model::BlinnPhong => times("c = max(n · h, 0)", &[n, bisector], cosine),
                }
            }
            Event::Power { exponent, value } => {
                let numbers = vec![
                    Piece::Text("= "),
                    Piece::Number(known(self.highlight)),
                    Piece::Text(" ^ "),
                    Piece::Number(u32::from(exponent).into()),
                    Piece::Text(" = "),
                    Piece::Result(value.into()),
                ];
                Some(Formula { general: "c^s", numbers })
            }
            Event::Specular { value } => {
                let factors = [known(self.fade_or_intensity()), material.specular.into(), known(self.power)];
                times("specular = f ks c^s", &factors, value)
            }
            Event::Sum { value } => self.summed(value),
            Event::AsItIs { .. }
            | Event::NoDirection { .. }
            | Event::Flipped { .. }
            | Event::Ambient { .. }
            | Event::Behind => None,
        }
    }

    /// The intensity at the point: a light in infinity does not fade.
    fn fade_or_intensity(&self) -> Option<f64> {
        self.fade.or(Some(f64::from(self.light().intensity)))
    }

    fn applied(&self, general: &'static str, from: [f32; 3], to: [f32; 3]) -> Option<Formula> {
        let numbers =
            vec![Piece::Number(self.vector(from)), Piece::Text(" → "), Piece::Result(self.vector(to))];
        Some(Formula { general, numbers })
    }

    fn normalised(&self, vector: Vector, unit: [f32; 3]) -> Option<Formula> {
        let from = self.subject.surface.position;
        let towards = |place: Place| match place {
            Place::Position(to) => [0, 1, 2].map(|axis| to[axis] - from[axis]),
            Place::Direction(to) => to,
        };
        let (general, long) = match vector {
            Vector::Normal => ("n = N′ / |N′|", self.turned.unwrap_or_default()),
            Vector::Eye => ("v = (E − P) / |E − P|", towards(self.subject.eye)),
            Vector::Light => ("l = (L − P) / |L − P|", towards(self.light().place)),
        };
        let length = long.iter().map(|c| f64::from(*c) * f64::from(*c)).sum::<f64>();
        let numbers = vec![
            Piece::Text("= "),
            Piece::Number(self.vector(long)),
            Piece::Text(" / "),
            Piece::Number(libm::sqrt(length).into()),
            Piece::Text(" = "),
            Piece::Result(self.vector(unit)),
        ];
        Some(Formula { general, numbers })
    }

    fn faded(&self, distance: f32, factor: f64) -> Option<Formula> {
        let light = self.light();
        let [c0, c1, c2] = light.attenuation;
        let number = |value: f32| Piece::Number(value.into());
        let numbers = vec![
            Piece::Text("= "),
            number(light.intensity),
            Piece::Text(" / ("),
            number(c0),
            Piece::Text(" + "),
            number(c1),
            Piece::Text(" · "),
            number(distance),
            Piece::Text(" + "),
            number(c2),
            Piece::Text(" · "),
            number(distance),
            Piece::Text("²) = "),
            Piece::Result(factor.into()),
        ];
        Some(Formula { general: "f = i / (c0 + c1 d + c2 d²)", numbers })
    }

    fn summed(&self, value: f32) -> Option<Formula> {
        let mut numbers = Vec::new();
        for (i, term) in self.terms.into_iter().enumerate() {
            numbers.push(Piece::Text(if i == 0 { "= " } else { " + " }));
            numbers.push(Piece::Number(term.into()));
        }
        numbers.extend([Piece::Text(" = "), Piece::Result(value.into())]);
        Some(Formula { general: "I = ambient + diffuse + specular ≤ 1", numbers })
    }
}
