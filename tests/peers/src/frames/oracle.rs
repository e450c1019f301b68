//! Soups and a mesh of ties against exact coverage.

use super::{
    SIZE, Soup,
    workload::{self, CELLS},
};
use crate::{
    coverage::{Facet, PIXEL, Wrong, apart},
    painter::Painter,
};

/// The image.
const IMAGE: [usize; 2] = [SIZE; 2];

/// Exact: the vertices are multiples of 2^-20 pixel.
fn facet(triangle: &[[f32; 3]; 3]) -> Facet {
    let corners = triangle.map(|[x, y, _]| [x, y].map(|n| (f64::from(n) * PIXEL) as i128));
    Facet { corners, slack: 0, culled: false }
}

/// Lets a painter draw many triangles that do not touch, then a mesh in parts that do not.
pub fn examine(painter: &mut dyn Painter<Soup>) -> Wrong {
    let mut wrong = Wrong::default();
    for workload in workload::ALL {
        let soup = workload.soup();
        let triangles: Vec<_> = soup.triangles().map(|(triangle, _)| triangle).take(60_000).collect();
        let facets: Vec<_> = triangles.iter().map(facet).collect();
        for group in apart(&facets, IMAGE, 4) {
            let frame: Vec<_> = group.iter().map(|&i| triangles[i]).collect();
            let drawn = draw(painter, &frame);
            group.iter().for_each(|&i| wrong.compare(&facets[i], IMAGE, &drawn, |_, _, _| ()));
        }
    }
    let mesh = workload::mesh(8.0, 1);
    let mut hits = vec![0_u8; SIZE * SIZE];
    for part in 0..8 {
        let of_part = |index: usize| {
            let (cell, half) = (index / 2, index % 2);
            half + 2 * (cell % CELLS % 2) + 4 * (cell / CELLS % 2) == part
        };
        let frame: Vec<_> = (0..mesh.len()).filter(|&i| of_part(i)).map(|i| mesh[i]).collect();
        let drawn = draw(painter, &frame);
        hits.iter_mut().zip(drawn).for_each(|(hits, color)| *hits += u8::from(color != 0));
    }
    // The border of the sheet runs through centres: its first row and column are drawn, its last not.
    let inside = 10..10 + CELLS * 8;
    for (at, hits) in hits.into_iter().enumerate() {
        let inside = inside.contains(&(at % SIZE)) && inside.contains(&(at / SIZE));
        wrong.holes += usize::from(inside && hits == 0);
        wrong.doubles += usize::from(hits > u8::from(inside));
    }
    wrong
}

fn draw(painter: &mut dyn Painter<Soup>, triangles: &[[[f32; 3]; 3]]) -> Vec<u32> {
    let mut soup = Soup::default();
    triangles.iter().for_each(|&triangle| soup.push(triangle));
    painter.take(&soup);
    painter.draw();
    painter.colors()
}
