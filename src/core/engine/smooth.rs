//! The colours of a mesh, interpolated perspectively: those of a row's pixels at once, in binary32.
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

/// Paints the pixels of a few triangles of a mesh.
///
/// With the edge functions E, inside a triangle from 0 to twice its area A, a code is `sum(E r c) / sum(E r)`: that of
/// the first vertex, and the differences of the others from it in their parts.
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
    /// Whether all alphas are 1.
    opaque: bool,
}

impl<'m, A: Arbiter> Smooth<'m, A> {
    pub(super) fn new(mesh: &'m Mesh<'m, A>) -> Self {
        let none = [0.0; LANES];
        Self {
            mesh,
            r: [none; 3],
            first: [none; 4],
            second: [none; 4],
            third: [none; 4],
            certain: none,
            opaque: false,
        }
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
    /// most `6 e m max(r) / S`, where `S = 2A min(r) - 3 e max(r)` is less than the sum of the weights. While that is
    /// small, no term goes through more than twelve roundings after that: `12u m`; codes and their sum are rounded
    /// twice at no more than 255. What is left of 7, 16 and 3 covers the roundings of the bound itself.
    #[inline(always)]
    fn set_up(&mut self, group: &Group, setup: &Setup, small: &Small) {
        self.gather(group);
        let error = small.error();
        self.opaque =
            [&self.first, &self.second, &self.third].into_iter().all(|codes| codes[3] == [1.0; LANES]);
        let [mut most, mut low, mut high] = [[0.0; LANES], [0.0; LANES], [255.0; LANES]];
        for channel in 0..4 {
            for i in 0..LANES {
                let (a, b, c) = (
                    255.0 * self.first[channel][i],
                    255.0 * self.second[channel][i],
                    255.0 * self.third[channel][i],
                );
                low[i] = lesser(low[i], lesser(a, lesser(b, c)));
                high[i] = larger(high[i], larger(a, larger(b, c)));
                let (b, c) = (b - a, c - a);
                most[i] = larger(most[i], larger(b.abs(), c.abs()));
                (self.first[channel][i], self.second[channel][i], self.third[channel][i]) = (a, b, c);
            }
        }
        self.round_constants(group);
        for i in 0..LANES {
            let [a, b, c] = [self.r[0][i], self.r[1][i], self.r[2][i]];
            let (least, greatest) = (lesser(a, lesser(b, c)), larger(a, larger(b, c)));
            let area = setup.area[i] as f32;
            let sum = area * least;
            let moved = error[i] * greatest;
            let bound = 7.0 * moved * most[i] / (sum - 4.0 * moved) + U * (16.0 * most[i] + 3.0 * 256.0);
            // What is not a number is less than nothing.
            let known = (sum > 64.0 * moved)
                & (least > SMALL)
                & (greatest < GREAT)
                & (area > SMALL)
                & (area < GREAT)
                & (low[i] >= 0.0)
                & (high[i] <= 255.0)
                & (bound < 0.25);
            self.certain[i] = if known { 0.5 - bound } else { -1.0 };
        }
    }

    #[inline(always)]
    fn row<const N: usize>(
        &mut self,
        stroke: Stroke<'_, N>,
        [_, drawn]: [&[u32; N]; 2],
        painted: [u32; N],
        stats: &mut Stats,
    ) -> [u32; N] {
        let mut any = 0;
        for i in 0..N {
            any |= drawn[i];
        }
        if any == 0 {
            return painted;
        }
        let Stroke { lane, planes, .. } = stroke;
        let (mut second, mut third) = ([0.0; N], [0.0; N]);
        for i in 0..N {
            // Each edge stands against the corner that is not on it.
            let a = planes[1][i] * self.r[0][lane];
            let b = planes[2][i] * self.r[1][lane];
            let c = planes[0][i] * self.r[2][lane];
            let inverse = 1.0 / (a + b + c);
            (second[i], third[i]) = (b * inverse, c * inverse);
        }
        let (mut codes, mut farthest) = ([0_u32; N], [0.0; N]);
        for channel in 0..3 {
            self.channel(channel, lane, [&second, &third], (&mut codes, &mut farthest));
        }
        if self.opaque {
            for i in 0..N {
                codes[i] |= 255 << 24;
            }
        } else {
            self.channel(3, lane, [&second, &third], (&mut codes, &mut farthest));
        }
        let certain = self.certain[lane];
        let (mut open, mut any) = ([0; N], 0);
        let mut new = [0; N];
        for i in 0..N {
            open[i] = drawn[i] & !mask(farthest[i] < certain);
            any |= open[i];
            new[i] = u32::from_le(codes[i]) & drawn[i] | painted[i] & !drawn[i];
        }
        if any != 0 { self.decided(stroke.color, stroke.pixel, (open, new), stats) } else { new }
    }
}

impl<A: Arbiter> Smooth<'_, A> {
    /// Puts in the codes of a channel, given the parts of the second and the third corner, and how far the farthest is
    /// from a whole number.
    #[inline(always)]
    fn channel<const N: usize>(
        &self,
        channel: usize,
        lane: usize,
        [second, third]: [&[f32; N]; 2],
        (codes, farthest): (&mut [u32; N], &mut [f32; N]),
    ) {
        let [a, b, c] = [self.first[channel][lane], self.second[channel][lane], self.third[channel][lane]];
        for i in 0..N {
            let code = a + (b * second[i] + c * third[i]);
            let shifted = code + SHIFT;
            let far = (code - (shifted - SHIFT)).abs();
            // The last one's NaN stays.
            farthest[i] = larger(farthest[i], far);
            codes[i] |= (shifted.to_bits() & 255) << (8 * channel);
        }
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
    fn decided<const N: usize>(
        &self,
        number: u32,
        [x, y]: [u32; 2],
        (open, mut colors): ([u32; N], [u32; N]),
        stats: &mut Stats,
    ) -> [u32; N] {
        for i in (0..N).filter(|&i| open[i] != 0) {
            stats.painted += 1;
            let codes = self.mesh.arbiter.color(number.wrapping_sub(1), [x + i as u32, y]);
            colors[i] = u32::from_ne_bytes(codes);
        }
        colors
    }
}
