//! The engine for whole frames, on each vector unit of this machine.

use crate::{
    frames::{SIZE, Soup},
    painter::{Maker, Painter},
};
use rasterscope_core::engine::{Canvas, Clear, Colors, Engine, Lanes, State, Stencil, Triangles};

const CLEAR: Clear = Clear { color: [0; 4], depth: 1.0, stencil: 0 };

pub struct Ours {
    name: &'static str,
    engine: Engine,
    canvas: Canvas,
    state: State,
    positions: Vec<[f32; 3]>,
    colors: Vec<[u8; 4]>,
}

/// One painter a vector unit, the widest first.
pub fn painters() -> Vec<Maker<Soup>> {
    let units = Lanes::all().into_iter().rev();
    units
        .map(|lanes| {
            let make = move || -> Box<dyn Painter<Soup>> {
                Box::new(Ours {
                    name: match lanes.name() {
                        "avx512" => "rasterscope engine, avx512",
                        "avx2" => "rasterscope engine, avx2",
                        _ => "rasterscope engine, baseline",
                    },
                    engine: Engine::default(),
                    canvas: Canvas::new([SIZE as u32; 2], CLEAR, Stencil::Without),
                    state: State { lanes, ..State::default() },
                    positions: Vec::new(),
                    colors: Vec::new(),
                })
            };
            Box::new(make) as Maker<Soup>
        })
        .collect()
}

impl Painter<Soup> for Ours {
    fn name(&self) -> &'static str {
        self.name
    }

    fn take(&mut self, soup: &Soup) {
        self.positions = soup.positions.clone();
        self.colors = soup.colors.iter().map(|color| color.to_ne_bytes()).collect();
    }

    fn draw(&mut self) {
        let triangles =
            Triangles { positions: &self.positions, indices: None, colors: Colors::Each(&self.colors) };
        self.engine.draw(&mut self.canvas, Some(CLEAR), &triangles, &self.state);
    }

    fn colors(&self) -> Vec<u32> {
        self.canvas.color().iter().map(|codes| u32::from_ne_bytes(*codes)).collect()
    }
}
