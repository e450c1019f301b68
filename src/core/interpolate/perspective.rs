//! Perspective-correct attributes of a triangle that is drawn.
//!
//! *Source:* Heckbert and Moreton, Interpolation for Polygon Texture Mapping and Shading, State of
//! the Art in Computer Graphics, 1991; Blinn, Hyperbolic Interpolation, 1992.

use super::{Barycentric, Weights};
use crate::{math::Tally, raster::edge::centre};

/// A triangle on the screen, set up once for all its pixels and attributes.
#[derive(Clone, Copy, Debug)]
pub struct Interpolator(Barycentric);

impl Interpolator {
    /// From vertices (x, y, r): x and y in pixels, r = 1/w > 0 as the divide left it in the w
    /// slot. `None` if the area is zero.
    pub fn new(vertices: [[f32; 3]; 3], tally: &mut Tally) -> Option<Self> {
        let triangle = Barycentric::new(vertices.map(|[x, y, _]| [x, y]), tally)?;
        Some(Self(triangle.with_factors(vertices.map(|[_, _, r]| f64::from(r)))))
    }

    /// The weights at the centre of a pixel: compute them once for all attributes.
    #[inline]
    pub fn at(&self, pixel: [u32; 2], tally: &mut Tally) -> Weights<'_> {
        self.at_point(centre(pixel[0], pixel[1]), tally)
    }

    /// The weights at any point, in pixels, such as a sample of a pixel.
    #[inline]
    pub fn at_point(&self, point: [f32; 2], tally: &mut Tally) -> Weights<'_> {
        self.0.at(point, tally)
    }

    /// An attribute at the centre of a pixel, correctly rounded.
    #[inline]
    pub fn value(&self, attribute: [f32; 3], pixel: [u32; 2], tally: &mut Tally) -> f32 {
        self.at(pixel, tally).value(attribute, tally)
    }

    /// The 8-bit code of an attribute at the centre of a pixel: `floor(255 c + 1/2)` of the exact
    /// value c.
    #[inline]
    pub fn code8(&self, attribute: [f32; 3], pixel: [u32; 2], tally: &mut Tally) -> u8 {
        self.at(pixel, tally).code8(attribute, tally)
    }
}
