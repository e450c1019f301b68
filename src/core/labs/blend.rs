//! The lab that blends layers over one pixel.

use super::Family;
use crate::{
    blend::{
        BlendState, Mode,
        layers::{self, Order},
    },
    compare::Choice,
    message::Message,
    replay::{Budget, Playback},
    scene::{Checked, Problem, Scene, each_in_unit, refuse_if},
};
use serde::{Deserialize, Serialize};

/// Layers over one pixel.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Blend {
    /// In the order in which they come; at most [`layers::MOST`].
    pub layers: Vec<Layer>,
    /// What the pixel is cleared to: red, green, blue, alpha in 0..=1.
    #[serde(default = "clear")]
    pub clear: [f32; 4],
    /// Factors and operations by name.
    #[serde(default)]
    pub mode: Mode,
    /// Factors and operations one by one, instead of a mode.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub state: Option<BlendState>,
    /// In which order the layers are blended.
    #[serde(default)]
    pub order: Order,
}

/// A fragment that comes to the pixel.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Layer {
    /// As on the canvas; empty for A, B, C, ...
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub name: String,
    /// Red, green, blue, alpha in 0..=1.
    pub color: [f32; 4],
    /// In 0..=1, smaller is nearer.
    #[serde(default)]
    pub depth: f32,
}

fn clear() -> [f32; 4] {
    [0.0, 0.0, 0.0, 1.0]
}

impl Blend {
    /// The factors and operations of all layers.
    pub fn blend_state(&self) -> BlendState {
        self.state.unwrap_or_else(|| self.mode.state())
    }
}

impl Family for Blend {
    fn first() -> Self {
        let layer = |color, depth| Layer { name: String::new(), color, depth };
        Self {
            layers: vec![layer([0.8, 0.2, 0.2, 0.5], 0.75), layer([0.2, 0.4, 0.8, 0.5], 0.25)],
            clear: clear(),
            mode: Mode::default(),
            state: None,
            order: Order::default(),
        }
    }

    fn name(&self) -> &'static str {
        "blend"
    }

    fn is_of_scene(&self) -> bool {
        false
    }

    fn check(&self, _: &Scene) -> Checked {
        each_in_unit(&self.clear).map_err(|e| e.within("clear"))?;
        let constant = self.state.map_or([0.0; 4], |state| state.constant);
        each_in_unit(&constant).map_err(|e| e.within("constant").within("state"))?;
        let most = layers::MOST;
        let problem = Problem::Range { min: 0.0, max: most as f64 };
        refuse_if(self.layers.len() > most, "layers", problem)?;
        for (i, layer) in self.layers.iter().enumerate() {
            each_in_unit(&layer.color).map_err(|e| e.within("color").within(i).within("layers"))?;
            each_in_unit(&[layer.depth]).map_err(|e| e.within("depth").within(i).within("layers"))?;
        }
        Ok(())
    }

    fn play(&self, _: &Scene, budget: Budget) -> Result<Box<dyn Playback>, Message> {
        if self.layers.is_empty() {
            return Err(Message::new("error-no-layers"));
        }
        let state = self.blend_state();
        let all: Vec<_> = self
            .layers
            .iter()
            .map(|&Layer { color, depth, .. }| layers::Layer { color, depth, state })
            .collect();
        let names: Vec<_> = self.layers.iter().map(|layer| layer.name.clone()).collect();
        let settings = layers::Settings { order: self.order, clear: self.clear };
        Ok(Box::new(layers::play(&all, &names, settings, budget)))
    }

    fn choices(&self) -> Vec<Choice> {
        let modes = [
            ("\"over\"", "word-blend-over"),
            ("\"color-factors\"", "word-blend-color-factors"),
            ("\"premultiplied\"", "word-blend-premultiplied"),
            ("\"additive\"", "word-blend-additive"),
            ("\"multiply\"", "word-blend-multiply"),
            ("\"min\"", "word-blend-min"),
            ("\"max\"", "word-blend-max"),
            ("\"replace\"", "word-blend-replace"),
        ];
        let orders = [
            ("\"as-drawn\"", "word-order-as-drawn"),
            ("\"reversed\"", "word-order-reversed"),
            ("\"sorted\"", "word-order-sorted"),
        ];
        let mut all = Choice::all("order", "compare-blend-order", orders).to_vec();
        if self.state.is_none() {
            all.extend(Choice::all("mode", "compare-blend-mode", modes));
        }
        all
    }
}
