//! The colours of a mesh, interpolated perspectively: those of a stamp's pixels at once, in binary32.
//!
//! *Source:* Pineda, A Parallel Algorithm for Polygon Rasterization, SIGGRAPH 1988 (edge functions as weights); Heckbert
//! and Moreton, Interpolation for Polygon Texture Mapping and Shading, 1991; Higham, Accuracy and Stability of Numerical
//! Algorithms, 2nd ed. 2002, section 3.1 (the error). Deviation: a code that the error leaves open is decided exactly.

use super::{
    Arbiter, Mesh, Stats,
    group::{Entry, Group},
    ink::{Ink, Stroke},
    lanes::{LANES, larger, lesser, mask},
    setup::Setup,
    small::{Narrow, Small},
    stamp::{Each, SIDE, STAMP},
};
use crate::interpolate::unorm;
use wide::f32x4;

/// The unit roundoff of binary32.
const U: f32 = f32::EPSILON / 2.0;

/// What lies between these is multiplied without overflow and underflow.
const GREAT: f32 = 1e15;
const SMALL: f32 = 1e-15;

/// Added to a number, leaves it rounded in the low bits: 1.5 * 2^23.
const SHIFT: f32 = 12_582_912.0;

/// The bits of that in each of four codes.
const SHIFTED: u32 = SHIFT.to_bits().wrapping_mul(0x0101_0101);

/// Less than any distance.
const UNKNOWN: u32 = (-1.0_f32).to_bits();

/// Paints the pixels of a few triangles of a mesh.
///
/// With the edge functions E, inside a triangle from 0 to twice its area A, a code is `sum(E r c) / sum(E r)`: that of
/// the first vertex, and the differences of the others from it in their parts.
#[repr(align(64))]
pub(super) struct Smooth<'m, A: Arbiter> {
    mesh: &'m Mesh<'m, A>,
    /// 1/w of each corner.
    r: [Narrow; 3],
    /// The codes of the first corner, not rounded, and how far those of the others are from them.
    first: [Narrow; 4],
    second: [Narrow; 4],
    third: [Narrow; 4],
    /// A code that is no farther than this from a whole number rounds to it.
    certain: Narrow,
}

impl<'m, A: Arbiter> Smooth<'m, A> {
    pub(super) fn new(mesh: &'m Mesh<'m, A>) -> Self {
        let none = [0.0; LANES];
        Self { mesh, r: [none; 3], first: [none; 4], second: [none; 4], third: [none; 4], certain: none }
    }

    /// Gathers what the corners hold.
    #[inline(always)]
    fn gather(&mut self, group: &Group) {
        for half in [0, LANES / 2] {
            let at = |i: usize| group.colors[half + i].wrapping_sub(1) as usize;
            let ([r0, r1, r2], a) = self.mesh.corners(at(0));
            let ([s0, s1, s2], b) = self.mesh.corners(at(1));
            let ([t0, t1, t2], c) = self.mesh.corners(at(2));
            let ([u0, u1, u2], d) = self.mesh.corners(at(3));
            self.r[0][half..half + LANES / 2].copy_from_slice(&[r0, s0, t0, u0]);
            self.r[1][half..half + LANES / 2].copy_from_slice(&[r1, s1, t1, u1]);
            self.r[2][half..half + LANES / 2].copy_from_slice(&[r2, s2, t2, u2]);
            for corner in 0..3 {
                let rows = f32x4::transpose([a[corner], b[corner], c[corner], d[corner]]);
                let codes = match corner {
                    0 => &mut self.first,
                    1 => &mut self.second,
                    _ => &mut self.third,
                };
                for channel in 0..4 {
                    codes[channel][half..half + LANES / 2].copy_from_slice(&rows[channel].to_array());
                }
            }
        }
    }
}

impl<A: Arbiter> Ink for Smooth<'_, A> {
    const COUNTS: bool = false;
    const TOUCHES: bool = false;
    const SHADES: bool = true;

    #[inline(always)]
    fn fetch(&self, next: &[Entry]) {
        let number = |entry: &Entry| entry.color().wrapping_sub(1) as usize;
        for (soon, later) in next.iter().zip(next.iter().skip(2 * LANES)).take(LANES) {
            self.mesh.fetch(number(soon), number(later));
        }
    }

    /// With m the greatest difference of codes and e the error of an edge function, moving the weights moves a code by at
    /// most `3 e m max(r) / S`, where `S = 2A min(r) - 3 e max(r)` is less than the sum of the weights. While that is
    /// small, no term goes through more than twelve roundings after that: `12u m`; codes and their sum are rounded
    /// twice at no more than 255. What is left of 3.5, 16 and 3 covers the roundings of the bound itself.
    #[inline(always)]
    fn set_up(&mut self, group: &Group, setup: &Setup, small: &Small) {
        self.gather(group);
        let error = &small.error;
        let mut most = [0.0; LANES];
        most = self.scale(0, most);
        most = self.scale(1, most);
        most = self.scale(2, most);
        if !self.mesh.range.opaque {
            most = self.scale(3, most);
        }
        self.round_constants(group);
        let unit = mask(self.mesh.range.unit);
        for i in 0..LANES {
            let [a, b, c] = [self.r[0][i], self.r[1][i], self.r[2][i]];
            let (least, greatest) = (lesser(a, lesser(b, c)), larger(a, larger(b, c)));
            let area = setup.area[i] as f32;
            let sum = area * least;
            let moved = error[i] * greatest;
            let bound = 3.5 * moved * most[i] / (sum - 4.0 * moved) + U * (16.0 * most[i] + 3.0 * 256.0);
            // What is not a number is less than nothing.
            let known = mask(sum > 64.0 * moved)
                & mask(least > SMALL)
                & mask(greatest < GREAT)
                & mask(area > SMALL)
                & mask(area < GREAT)
                & mask(bound < 0.25)
                & unit;
            self.certain[i] = f32::from_bits((0.5 - bound).to_bits() & known | UNKNOWN & !known);
        }
    }

    #[inline(always)]
    fn stamp(
        &mut self,
        stroke: Stroke<'_>,
        [_, drawn]: [&Each<u32>; 2],
        colors: &mut Each<u32>,
        stats: &mut Stats,
    ) {
        let mut any = 0;
        for i in 0..STAMP {
            any |= drawn[i];
        }
        if any == 0 {
            return;
        }
        let Stroke { lane, planes, .. } = stroke;
        let (mut second, mut third) = ([0.0; STAMP], [0.0; STAMP]);
        for i in 0..STAMP {
            // Each edge stands against the corner that is not on it.
            let a = planes[1][i] * self.r[0][lane];
            let b = planes[2][i] * self.r[1][lane];
            let c = planes[0][i] * self.r[2][lane];
            let inverse = 1.0 / (a + b + c);
            (second[i], third[i]) = (b * inverse, c * inverse);
        }
        let mut farthest = [0.0; STAMP];
        let parts = [&second, &third];
        let red = self.channel(0, lane, parts, &mut farthest);
        let green = self.channel(1, lane, parts, &mut farthest);
        let blue = self.channel(2, lane, parts, &mut farthest);
        let alpha = if self.mesh.range.opaque {
            [(SHIFT + 255.0).to_bits(); STAMP]
        } else {
            self.channel(3, lane, parts, &mut farthest)
        };
        let certain = self.certain[lane];
        let (mut open, mut any) = ([0; STAMP], 0);
        let mut new = [0; STAMP];
        for i in 0..STAMP {
            open[i] = drawn[i] & !mask(farthest[i] < certain);
            any |= open[i];
            // What the shift leaves above the codes cancels out.
            let codes = (red[i].wrapping_add(green[i] << 8))
                .wrapping_add((blue[i] << 16).wrapping_add(alpha[i] << 24))
                .wrapping_sub(SHIFTED);
            new[i] = u32::from_le(codes) & drawn[i] | colors[i] & !drawn[i];
        }
        *colors = new;
        if any != 0 {
            self.decide(stroke.color, stroke.pixel, (open, colors), stats);
        }
    }
}

impl<A: Arbiter> Smooth<'_, A> {
    /// The codes of a channel as the shift leaves them, given the parts of the second and the third corner, and how far
    /// the farthest is from a whole number.
    #[inline(always)]
    fn channel(
        &self,
        channel: usize,
        lane: usize,
        [second, third]: [&Each<f32>; 2],
        farthest: &mut Each<f32>,
    ) -> Each<u32> {
        let [a, b, c] = [self.first[channel][lane], self.second[channel][lane], self.third[channel][lane]];
        let mut codes = [0; STAMP];
        for i in 0..STAMP {
            let code = a + (b * second[i] + c * third[i]);
            let shifted = code + SHIFT;
            let far = (code - (shifted - SHIFT)).abs();
            // The last one's NaN stays.
            farthest[i] = larger(farthest[i], far);
            codes[i] = shifted.to_bits();
        }
        codes
    }

    /// Takes codes, and their differences from those of the first corner, for the values of a channel. Returns the
    /// greatest difference of any two, or a greater one of another channel.
    #[inline(always)]
    fn scale(&mut self, channel: usize, mut most: Narrow) -> Narrow {
        for i in 0..LANES {
            let a = 255.0 * self.first[channel][i];
            let (b, c) = (255.0 * self.second[channel][i] - a, 255.0 * self.third[channel][i] - a);
            most[i] = larger(most[i], larger((b - c).abs(), larger(b.abs(), c.abs())));
            (self.first[channel][i], self.second[channel][i], self.third[channel][i]) = (a, b, c);
        }
        most
    }

    /// A code that all three corners have is rounded once for all pixels.
    #[inline(always)]
    fn round_constants(&mut self, group: &Group) {
        let mut halfway = 0;
        for channel in 0..4 {
            for i in 0..LANES {
                let code = self.first[channel][i];
                let constant = (self.second[channel][i] == 0.0) & (self.third[channel][i] == 0.0);
                let near = (code + SHIFT) - SHIFT;
                let known = (code - near).abs() < 0.499;
                halfway |= mask(constant & !known);
                self.first[channel][i] = if constant & known { near } else { code };
            }
        }
        if halfway != 0 {
            self.round_halfway(group);
        }
    }

    /// The same where it lies nearly between two codes.
    #[cold]
    #[inline(never)]
    fn round_halfway(&mut self, group: &Group) {
        for i in 0..LANES {
            let (_, colors) = self.mesh.corners(group.colors[i].wrapping_sub(1) as usize);
            let [a, b, c] = colors.map(f32x4::to_array);
            for channel in 0..4 {
                if a[channel] == b[channel] && b[channel] == c[channel] {
                    self.first[channel][i] = unorm(a[channel], 255) as f32;
                }
            }
        }
    }

    /// Codes that are open are decided exactly.
    #[cold]
    #[inline(never)]
    fn decide(
        &self,
        number: u32,
        [x, y]: [u32; 2],
        (open, colors): (Each<u32>, &mut Each<u32>),
        stats: &mut Stats,
    ) {
        for i in (0..STAMP).filter(|&i| open[i] != 0) {
            stats.painted += 1;
            let pixel = [x + (i % SIDE) as u32, y + (i / SIDE) as u32];
            let codes = self.mesh.arbiter.color(number.wrapping_sub(1), pixel);
            colors[i] = u32::from_ne_bytes(codes);
        }
    }
}
