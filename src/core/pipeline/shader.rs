//! The colour of a fragment, exact until it is written.

use std::{cell::Cell, sync::Arc};

use super::{DrawOutputs, Piece, gradient::Gradient};
use crate::{
    blend::{BlendState, ExactColor, blend},
    interpolate::{Interpolator, Weights, unorm},
    math::{Approx, Dyadic, Tally, rounded_code, rounded_ratio},
    scene::Texture,
    shade::{Illumination, Surface, lighting},
    trace::{NoTrace, Tracer},
};

/// What a dark square of the checker leaves of a colour. A power of two, so that nothing is rounded.
const DARK: f32 = 0.25;

/// The fragment shader of one triangle: vertex colour, times texture, times shade; or, where each pixel
/// is lit, in that light. All of it leaves alpha alone.
pub(crate) struct Shader {
    interpolator: Interpolator,
    /// Vertex values of red, green, blue, alpha.
    channels: [[f32; 3]; 4],
    /// Vertex values of u and v, with the texture they look up.
    texture: Option<([[f32; 3]; 2], Texture)>,
    shade: f32,
    /// Present if each pixel is lit.
    pixels: Option<Pixels>,
    /// Whether the vertices have the same colour.
    uniform: bool,
    /// The code of all fragments, if they have the same colour.
    constant: Option<[u8; 4]>,
    /// What blending gave last, if the vertices have the same colour: neighbours mostly ask the same,
    /// and one half over codes is an exact tie, which is slow, every other time.
    last: Cell<Option<Blended>>,
}

/// What a lit pixel needs: vertex values of x, y and z of its place and of its normal, in world space.
struct Pixels {
    place: [[f32; 3]; 3],
    normal: [[f32; 3]; 3],
    illumination: Arc<Illumination>,
}

/// What the fragment stage is given: each value the exact interpolated one, rounded once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Inputs {
    /// Present if pixels are lit.
    pub(crate) surface: Option<Surface>,
    /// Before texture and light.
    pub(crate) color: [f32; 4],
    /// Present if there is a texture.
    pub(crate) uv: Option<[f32; 2]>,
}

/// A blended fragment of a triangle of one colour.
#[derive(Clone, Copy)]
struct Blended {
    factor: f32,
    stored: [u8; 4],
    result: [u8; 4],
}

/// The colour of one fragment, not rounded yet.
pub(crate) struct Color<'s> {
    shader: &'s Shader,
    weights: Weights<'s>,
    /// Multiplies red, green and blue; exact.
    factor: f32,
    /// In the light of this pixel, in place of all that.
    lit: Option<[f32; 4]>,
}

impl Shader {
    /// `None` if the piece has no area on the screen.
    pub(crate) fn new(
        draw: &DrawOutputs,
        piece: &Piece,
        texture: Option<Texture>,
        tally: &mut Tally,
    ) -> Option<Self> {
        let corners = piece.corners.map(|i| i as usize);
        let vertices = corners.map(|i| draw.screen()[i]).map(|[x, y, _, r]| [x, y, r]);
        let interpolator = Interpolator::new(vertices, tally)?;
        let constant = Self::constant_of(draw, piece, texture, tally);
        let channels = channels(draw, piece);
        let uvs = &draw.clipped().uvs;
        let texture = texture
            .filter(|_| !uvs.is_empty())
            .map(|texture| ([0, 1].map(|axis| corners.map(|i| uvs[i][axis])), texture));
        let by_axis = |values: &[[f32; 3]]| [0, 1, 2].map(|axis| corners.map(|i| values[i][axis]));
        let pixels = draw.lit().illumination.as_ref().map(|illumination| Pixels {
            place: by_axis(&draw.clipped().places),
            normal: by_axis(&draw.clipped().normals),
            illumination: Arc::clone(illumination),
        });
        let uniform = pixels.is_none() && is_uniform(&channels);
        let (shade, last) = (shade(draw, piece), Cell::new(None));
        Some(Self { interpolator, channels, texture, shade, pixels, uniform, constant, last })
    }

    /// The codes of every fragment of a piece, if they are the same.
    pub(super) fn constant_of(
        draw: &DrawOutputs,
        piece: &Piece,
        texture: Option<Texture>,
        tally: &mut Tally,
    ) -> Option<[u8; 4]> {
        let channels = channels(draw, piece);
        if draw.lit().illumination.is_some()
            || !is_uniform(&channels)
            || texture.is_some() && !draw.clipped().uvs.is_empty()
        {
            return None;
        }
        let [r, g, b, a] = channels.map(|channel| channel[0]);
        let shade = shade(draw, piece);
        let [r, g, b] = [r, g, b].map(|value| shaded(value, shade, tally));
        Some([r, g, b, unorm(a, 255) as u8])
    }

    /// The same for whole rows at once; `None` with a texture or where pixels are lit.
    pub(super) fn gradient(&self) -> Option<Gradient> {
        if self.texture.is_some() || self.pixels.is_some() {
            return None;
        }
        let scale = 255.0 * f64::from(self.shade);
        let scales = [scale, scale, scale, 255.0];
        let constant = [0, 1, 2, 3].map(|channel| {
            let [a, b, c] = self.channels[channel];
            let shade = if channel == 3 { 1.0 } else { self.shade };
            (a == b && b == c).then(|| shaded(a, shade, &mut Tally::default()))
        });
        Some(Gradient::new(&self.interpolator, &self.channels, scales, constant))
    }

    /// The codes of every fragment, if they are the same.
    pub(super) fn constant(&self) -> Option<[u8; 4]> {
        self.constant
    }

    /// The colour at a point of the triangle, in pixels.
    pub(crate) fn at(&self, point: [f32; 2], tally: &mut Tally) -> Color<'_> {
        self.at_traced(point, tally, &mut NoTrace)
    }

    /// [`at`](Self::at), with the light of the pixel step by step.
    pub(crate) fn at_traced<T: Tracer<lighting::Event>>(
        &self,
        point: [f32; 2],
        tally: &mut Tally,
        t: &mut T,
    ) -> Color<'_> {
        let weights = self.interpolator.at_point(point, tally);
        let texel = match self.texture {
            None => 1.0,
            Some((uvs, texture)) => {
                let [u, v] = uvs.map(|values| weights.value(values, tally));
                texture.factor(u, v)
            }
        };
        let lit = self.pixels.as_ref().map(|pixels| {
            let [r, g, b, a] = self.channels.map(|channel| weights.value(channel, tally));
            // A texel is a power of two.
            let color = [r * texel, g * texel, b * texel, a];
            pixels.illumination.at_pixel_traced(pixels.surface(&weights, tally), t).of(color)
        });
        Color { shader: self, weights, factor: texel * self.shade, lit }
    }

    /// What the fragment stage is given at a point.
    pub(crate) fn inputs(&self, point: [f32; 2], tally: &mut Tally) -> Inputs {
        let weights = self.interpolator.at_point(point, tally);
        Inputs {
            surface: self.pixels.as_ref().map(|pixels| pixels.surface(&weights, tally)),
            color: self.channels.map(|channel| weights.value(channel, tally)),
            uv: self.texture.map(|(uvs, _)| uvs.map(|values| weights.value(values, tally))),
        }
    }
}

impl Pixels {
    fn surface(&self, weights: &Weights<'_>, tally: &mut Tally) -> Surface {
        let mut vector = |values: &[[f32; 3]; 3]| values.map(|values| weights.value(values, tally));
        Surface { position: vector(&self.place), normal: vector(&self.normal) }
    }
}

/// The code of a value times a factor.
fn shaded(value: f32, shade: f32, tally: &mut Tally) -> u8 {
    // A product of two f32 is exact in f64.
    let value = f64::from(value) * f64::from(shade);
    rounded_code(Approx::exact(value), 255, || (Dyadic::from(value), Dyadic::one()), tally) as u8
}

/// Red, green, blue and alpha at a piece's corners.
fn channels(draw: &DrawOutputs, piece: &Piece) -> [[f32; 3]; 4] {
    let colors = piece.corners.map(|i| draw.clipped().colors[i as usize]);
    [0, 1, 2, 3].map(|channel| colors.map(|color| color[channel]))
}

fn is_uniform(channels: &[[f32; 3]; 4]) -> bool {
    channels.iter().all(|[a, b, c]| a == b && b == c)
}

/// What multiplies the colours of a piece.
fn shade(draw: &DrawOutputs, piece: &Piece) -> f32 {
    draw.lit().factors.get(piece.triangle as usize).copied().unwrap_or(1.0)
}

impl Texture {
    /// What multiplies the colour at these texture coordinates, nearest and repeating: the checker is
    /// light where `floor(n u) + floor(n v)` is even. Any finite coordinates.
    pub fn factor(self, u: f32, v: f32) -> f32 {
        let Self::Checker { squares } = self;
        // The product is exact up to 2^29 squares.
        let odd =
            |coordinate: f32| (f64::from(coordinate) * f64::from(squares)).floor().rem_euclid(2.0) != 0.0;
        if odd(u) == odd(v) { 1.0 } else { DARK }
    }
}

impl Color<'_> {
    /// The colour, each channel rounded once.
    pub(crate) fn values(&self, tally: &mut Tally) -> [f32; 4] {
        let value = |channel| rounded_ratio(self.approx(channel), || self.exact(channel), tally);
        self.lit.unwrap_or_else(|| [0, 1, 2, 3].map(value))
    }

    fn factor(&self, channel: usize) -> f32 {
        if channel == 3 { 1.0 } else { self.factor }
    }

    /// The alpha of all vertices, if it is one.
    pub(super) fn uniform_alpha(&self) -> Option<f32> {
        let [a, b, c] = self.shader.channels[3];
        (a == b && b == c).then_some(a)
    }

    pub(super) fn approx(&self, channel: usize) -> Approx {
        if let Some(lit) = self.lit {
            return Approx::exact(f64::from(lit[channel]));
        }
        self.weights.approx(self.shader.channels[channel]) * Approx::from(self.factor(channel))
    }

    /// One channel as a quotient without a rounding.
    pub(super) fn exact(&self, channel: usize) -> (Dyadic, Dyadic) {
        if let Some(lit) = self.lit {
            return (Dyadic::from(lit[channel]), Dyadic::one());
        }
        let (value, weight) = self.weights.exact(self.shader.channels[channel]);
        (value * Dyadic::from(self.factor(channel)), weight)
    }

    /// `floor(255 c + 1/2)` of each channel.
    pub(crate) fn codes(&self, tally: &mut Tally) -> [u8; 4] {
        if let Some(lit) = self.lit {
            return lit.map(|channel| unorm(channel, 255) as u8);
        }
        if self.factor == 1.0 {
            return self.shader.channels.map(|channel| self.weights.code8(channel, tally));
        }
        [0, 1, 2, 3]
            .map(|channel| rounded_code(self.approx(channel), 255, || self.exact(channel), tally) as u8)
    }

    /// What is stored after blending over `stored`.
    pub(super) fn blended(&self, state: &BlendState, stored: [u8; 4], tally: &mut Tally) -> [u8; 4] {
        let last = self.shader.last.get().filter(|last| last.factor == self.factor && last.stored == stored);
        if let Some(last) = last {
            return last.result;
        }
        let exact = || {
            let quotients = [0, 1, 2, 3].map(|channel| self.exact(channel));
            let denominator = quotients[0].1.clone();
            ExactColor { channels: quotients.map(|(value, _)| value), denominator }
        };
        let result = blend(state, [0, 1, 2, 3].map(|channel| self.approx(channel)), exact, stored, tally);
        if self.shader.uniform {
            self.shader.last.set(Some(Blended { factor: self.factor, stored, result }));
        }
        result
    }
}
