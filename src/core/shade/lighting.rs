//! The light that a point of a surface sends to the eye: an ambient, a diffuse and a specular term.
//!
//! *Source:* Phong, Illumination for Computer Generated Pictures, 1975 (the highlight by the mirrored
//! light); Blinn, Models of Light Reflection for Computer Synthesized Pictures, 1977 (by the half
//! vector); Foley et al., Computer Graphics: Principles and Practice, 2nd ed., sections 16.1.1 to 16.1.4
//! (the sum, attenuation). Deviations: the exponent is a whole number, so that a power is products; a
//! light behind the surface makes no highlight either.

mod explain;
mod formulas;
mod picture;
mod snapshot;

pub use snapshot::Snapshot;

use super::{Light, Material, Model, NormalMatrix, Place};
use crate::{
    math::{Arithmetic, Real},
    replay::{Budget, Player},
    trace::{NoTrace, Tracer},
    transform::Matrix,
};
use serde::Serialize;

/// A point of a surface in world space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    /// Where it is.
    pub position: [f32; 3],
    /// Where it faces; of any length, and without direction if it is zero.
    pub normal: [f32; 3],
}

impl Surface {
    /// Position and normal, to compute with.
    pub(super) fn parts<N: Real>(self) -> [[N; 3]; 2] {
        [self.position, self.normal].map(|vector| vector.map(N::from_f32))
    }

    /// The same with a normal of length 1.
    pub(super) fn upright<N: Real, T: Tracer<Event>>(self, t: &mut T) -> [[N; 3]; 2] {
        let [at, normal] = self.parts();
        [at, unit(normal, Vector::Normal, t)]
    }
}

/// What a run is about: a point, a light and an eye.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Subject {
    /// The point in world space with its normal in object space.
    pub surface: Surface,
    /// Object to world space.
    pub model: Matrix,
    /// Whether the normal goes through the model matrix itself, a common mistake.
    pub mistaken: bool,
    /// The only light.
    pub light: Light,
    /// Where it is seen from.
    pub eye: Place,
    /// How the surface answers.
    pub material: Material,
    /// [`Arithmetic::F32`] for binary32 throughout; any other is binary64.
    pub arithmetic: Arithmetic,
}

/// How bright a point is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Brightness {
    /// Ambient and diffuse: multiplies the surface's colour.
    pub matte: f64,
    /// Specular: white, added to it.
    pub gloss: f64,
}

impl Brightness {
    /// Of a white surface, in 0..=1, rounded once.
    pub fn of_white(self) -> f32 {
        clamped(self.matte + self.gloss) as f32
    }

    /// A colour in this light, each channel in 0..=1 and rounded once; alpha stays.
    pub fn of(self, [r, g, b, a]: [f32; 4]) -> [f32; 4] {
        let [r, g, b] = [r, g, b].map(|c| clamped(f64::from(c) * self.matte + self.gloss) as f32);
        [r, g, b, a]
    }
}

/// Within 0..=1; 0 for NaN.
fn clamped(value: f64) -> f64 {
    if value > 0.0 { value.min(1.0) } else { 0.0 }
}

/// A unit vector of the model, by its name in the listing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Vector {
    /// The normal, n.
    Normal,
    /// To the eye, v.
    Eye,
    /// To the light, l.
    Light,
}

/// What the algorithm did. At most 16 bytes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub enum Event {
    /// The normal in world space.
    Turned {
        /// Of any length.
        normal: [f32; 3],
    },
    /// A vector of length 1.
    Unit {
        /// Which.
        vector: Vector,
        /// Rounded to binary32.
        unit: [f32; 3],
    },
    /// An interpolated normal that is used as it is: a mistake.
    AsItIs {
        /// Of a length less than 1, mostly.
        normal: [f32; 3],
    },
    /// A vector of length 0 has no direction: it counts as zero.
    NoDirection {
        /// Which.
        vector: Vector,
    },
    /// The normal points away from the eye, and both sides are lit: it is turned around.
    Flipped {
        /// The unit normal after that.
        unit: [f32; 3],
    },
    /// The ambient term.
    Ambient {
        /// ka.
        value: f64,
    },
    /// How much of a light's intensity comes to the point.
    Fade {
        /// How far the light is.
        distance: f32,
        /// f.
        factor: f64,
    },
    /// The cosine between normal and light, or less than 0.
    Incidence {
        /// n . l.
        cosine: f64,
    },
    /// The light is behind the surface or just along it: no diffuse and no specular term.
    Behind,
    /// The diffuse term.
    Diffuse {
        /// f kd (n . l).
        value: f64,
    },
    /// The light mirrored at the normal.
    Mirrored {
        /// r.
        r: [f32; 3],
    },
    /// Halfway between the light and the eye, of length 1; zero if they are opposite.
    Halfway {
        /// h.
        h: [f32; 3],
    },
    /// The cosine that makes the highlight, at least 0.
    Highlight {
        /// Of which vectors.
        model: Model,
        /// r . v, or n . h.
        cosine: f64,
    },
    /// Its power.
    Power {
        /// s, at most 1024.
        exponent: u16,
        /// cosine ^ s.
        value: f64,
    },
    /// The specular term.
    Specular {
        /// f ks power.
        value: f64,
    },
    /// What goes out of a white surface, in 0..=1.
    Sum {
        /// Rounded once.
        value: f32,
    },
}
const _: () = assert!(size_of::<Event>() <= 16);

/// How bright a point is in the light of all `lights`.
///
/// World space, right-handed; any finite numbers. A zero normal, eye or light at the point itself has no
/// direction, and its terms are 0. In binary64. About 40 ns a light.
pub fn brightness(surface: Surface, eye: Place, lights: &[Light], material: &Material) -> Brightness {
    let (parts, t) = (surface.upright::<f64, _>(&mut NoTrace), &mut NoTrace);
    brightness_traced(parts, eye, lights, material, t)
}

/// A point as a run that can be scrubbed.
pub fn play(subject: Subject, budget: Budget) -> Player<Snapshot> {
    Player::new(Snapshot::new(subject), budget, move |t| {
        light_traced(&subject, t);
    })
}

/// The brightness of a white point, from its normal in object space on.
pub fn light(subject: &Subject) -> f32 {
    light_traced(subject, &mut NoTrace)
}

/// [`light`] and [`play`] are this with two tracers.
pub fn light_traced<T: Tracer<Event>>(subject: &Subject, t: &mut T) -> f32 {
    let Subject { surface, model, light, eye, ref material, .. } = *subject;
    let matrix = if subject.mistaken { NormalMatrix::mistaken(&model) } else { NormalMatrix::new(&model) };
    let normal = matrix.apply(surface.normal);
    t.emit(|| Event::Turned { normal });
    let surface = Surface { normal, ..surface };
    let brightness = match subject.arithmetic {
        Arithmetic::F32 => brightness_traced(surface.upright::<f32, T>(t), eye, &[light], material, t),
        _ => brightness_traced(surface.upright::<f64, T>(t), eye, &[light], material, t),
    };
    let value = brightness.of_white();
    t.emit(|| Event::Sum { value });
    value
}

/// The algorithm: [`brightness`] and [`light`] are this, of a position and a normal of length 1.
pub fn brightness_traced<N: Real, T: Tracer<Event>>(
    [at, n]: [[N; 3]; 2],
    eye: Place,
    lights: &[Light],
    material: &Material,
    t: &mut T,
) -> Brightness {
    let share = N::from_f32;
    let v = unit(towards(eye, at), Vector::Eye, t);
    let n = if material.two_sided && dot(n, v) < N::ZERO {
        let n = n.map(|c| -c);
        t.emit(|| Event::Flipped { unit: n.map(N::to_f32) });
        n
    } else {
        n
    };
    let mut matte = share(material.ambient);
    t.emit(|| Event::Ambient { value: matte.to_f64() });
    let mut gloss = N::ZERO;
    for light in lights {
        let to_light = towards::<N>(light.place, at);
        let l = unit(to_light, Vector::Light, t);
        let fade = fade(light, to_light, t);
        let incidence = dot(n, l);
        t.emit(|| Event::Incidence { cosine: incidence.to_f64() });
        // NaN, which only binary32 knows here, is no light either.
        if incidence.partial_cmp(&N::ZERO) != Some(std::cmp::Ordering::Greater) {
            t.emit(|| Event::Behind);
            continue;
        }
        let diffuse = fade * share(material.diffuse) * incidence;
        t.emit(|| Event::Diffuse { value: diffuse.to_f64() });
        matte = matte + diffuse;
        let cosine = match material.model {
            Model::Phong => {
                let twice = incidence + incidence;
                let r = [0, 1, 2].map(|axis| twice * n[axis] - l[axis]);
                t.emit(|| Event::Mirrored { r: r.map(N::to_f32) });
                dot(r, v)
            }
            Model::BlinnPhong => {
                let h = normalised([0, 1, 2].map(|axis| l[axis] + v[axis])).unwrap_or([N::ZERO; 3]);
                t.emit(|| Event::Halfway { h: h.map(N::to_f32) });
                dot(n, h)
            }
        };
        let cosine = if cosine > N::ZERO { cosine } else { N::ZERO };
        t.emit(|| Event::Highlight { model: material.model, cosine: cosine.to_f64() });
        let power = power(cosine, material.exponent);
        t.emit(|| Event::Power { exponent: material.exponent as u16, value: power.to_f64() });
        let specular = fade * share(material.specular) * power;
        t.emit(|| Event::Specular { value: specular.to_f64() });
        gloss = gloss + specular;
    }
    Brightness { matte: matte.to_f64(), gloss: gloss.to_f64() }
}

/// From a point to a place.
fn towards<N: Real>(place: Place, from: [N; 3]) -> [N; 3] {
    match place {
        Place::Position(to) => [0, 1, 2].map(|axis| N::from_f32(to[axis]) - from[axis]),
        Place::Direction(to) => to.map(N::from_f32),
    }
}

/// A vector of length 1 in its direction, or zero.
pub(super) fn unit<N: Real, T: Tracer<Event>>(v: [N; 3], vector: Vector, t: &mut T) -> [N; 3] {
    match normalised(v) {
        Some(unit) => {
            t.emit(|| Event::Unit { vector, unit: unit.map(N::to_f32) });
            unit
        }
        None => {
            t.emit(|| Event::NoDirection { vector });
            [N::ZERO; 3]
        }
    }
}

fn normalised<N: Real>(v: [N; 3]) -> Option<[N; 3]> {
    let length = dot(v, v).sqrt();
    (length > N::ZERO).then(|| v.map(|c| c / length))
}

/// `(x x' + y y') + z z'`.
fn dot<N: Real>([ax, ay, az]: [N; 3], [bx, by, bz]: [N; 3]) -> N {
    ax * bx + ay * by + az * bz
}

/// The intensity of a light at its distance.
fn fade<N: Real, T: Tracer<Event>>(light: &Light, to_light: [N; 3], t: &mut T) -> N {
    let intensity = N::from_f32(light.intensity);
    if matches!(light.place, Place::Direction(_)) {
        return intensity;
    }
    let [constant, linear, quadratic] = light.attenuation.map(N::from_f32);
    let distance = dot(to_light, to_light).sqrt();
    let divisor = constant + linear * distance + quadratic * distance * distance;
    // A light at the point itself that does not fade by a constant: it has no direction anyway.
    let factor = if divisor > N::ZERO { intensity / divisor } else { intensity };
    t.emit(|| Event::Fade { distance: distance.to_f32(), factor: factor.to_f64() });
    factor
}

/// `base ^ exponent`: squared for each bit of the exponent, from the highest, times the base where it is
/// set.
fn power<N: Real>(base: N, exponent: u32) -> N {
    let mut value = N::ONE;
    for bit in (0..u32::BITS - exponent.leading_zeros()).rev() {
        value = value * value;
        if exponent & 1 << bit != 0 {
            value = value * base;
        }
    }
    value
}
