//! This project: the public fast calls, one at a time and many at once.

use super::{Lines, Polygons, wide};
use crate::{
    lines::{self, Segment, Sides},
    measure::{Contender, Each},
    polygons::{self, Polygon},
};
use rasterscope_core::clip::{
    line::{self, Kept, Window, cohen_sutherland, liang_barsky},
    polygon::sutherland_hodgman::{self, Buffers},
};

fn window(sides: Sides) -> Window {
    Window::new(sides).expect("the window is right")
}

pub fn lines(segments: &[Segment], sides: Sides, list: &mut Lines) {
    let window = window(sides);
    let read = |part: &Option<Segment>| part.map(|ends| ends.map(wide));
    list.push(Box::new(Batch { segments: segments.to_vec(), window, kept: Vec::new() }));
    list.push(Box::new(Each::new(
        "rasterscope",
        segments.to_vec(),
        move |segment| line::clip(*segment, &window),
        read,
    )));
    list.push(Box::new(Each::new(
        "rasterscope, Cohen-Sutherland",
        segments.to_vec(),
        move |segment| cohen_sutherland::clip(*segment, &window),
        read,
    )));
    list.push(Box::new(Each::new(
        "rasterscope, Liang-Barsky",
        segments.to_vec(),
        move |segment| liang_barsky::clip(*segment, &window),
        read,
    )));
}

/// All lines of a slice.
struct Batch {
    segments: Vec<Segment>,
    window: Window,
    kept: Vec<Kept>,
}

impl Contender<lines::Answer> for Batch {
    fn name(&self) -> &str {
        "rasterscope, batch"
    }

    fn run(&mut self) {
        self.kept.clear();
        line::clip_all(&self.segments, &self.window, &mut self.kept);
    }

    fn answers(&self) -> Vec<lines::Answer> {
        let mut answers = vec![None; self.segments.len()];
        for Kept { index, segment } in &self.kept {
            answers[*index as usize] = Some(segment.map(wide));
        }
        answers
    }
}

pub fn polygons(polygons: &[Polygon], sides: Sides, list: &mut Polygons) {
    let window = window(sides);
    list.push(Box::new(Each::new(
        "rasterscope, Sutherland-Hodgman",
        polygons.to_vec(),
        move |polygon| sutherland_hodgman::clip(polygon, &window),
        |left| vec![left.iter().map(|&p| wide(p)).collect()],
    )));
    list.push(Box::new(Reused {
        polygons: polygons.to_vec(),
        window,
        buffers: Buffers::default(),
        left: vec![Polygon::new(); polygons.len()],
    }));
}

/// Sutherland-Hodgman into lists that are used again.
struct Reused {
    polygons: Vec<Polygon>,
    window: Window,
    buffers: Buffers,
    left: Vec<Polygon>,
}

impl Contender<polygons::Answer> for Reused {
    fn name(&self) -> &str {
        "rasterscope, Sutherland-Hodgman, reused"
    }

    fn run(&mut self) {
        for (polygon, left) in self.polygons.iter().zip(&mut self.left) {
            sutherland_hodgman::clip_into(polygon, &self.window, &mut self.buffers, left);
        }
    }

    fn answers(&self) -> Vec<polygons::Answer> {
        self.left.iter().map(|left| vec![left.iter().map(|&p| wide(p)).collect()]).collect()
    }
}
