//! The lab that runs the stencil test of every fragment, draw by draw.

use super::{Family, refuse_large, scan_settings};
use crate::{
    blend::{BlendComponent, BlendFactor, BlendOperation},
    compare::{Choice, Setting},
    depth::{CompareFunction, DepthState, Rules},
    message::Message,
    pipeline::{ScreenTriangle, draw_name, enlarged_triangles, screen_triangles},
    raster,
    replay::{Budget, Playback},
    scene::{self, Checked, Scene, each_finite},
    stencil::{
        Enlarge, StencilOperation, StencilState, Way,
        stencil_test::{self, Draw},
    },
};
use serde::{Deserialize, Serialize};

/// The scene's draws one after the other, or an outline of each.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Stencil {
    /// How outlines are made; `None` draws with the scene's own stencil states, or, if it has none,
    /// with outlines by scale.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub outline: Option<Way>,
    /// Whose outlines: one around all objects, or one around each.
    pub order: Order,
    /// What [`Way::Scale`] multiplies by.
    pub factor: f32,
    /// How far [`Way::Normals`] moves, in object space.
    pub distance: f32,
    /// How far [`Way::Pixels`] moves.
    pub pixels: f32,
}

/// The order of objects and outlines.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Order {
    /// All objects write 1, then all outlines are drawn where it is not 1: one outline around all.
    #[default]
    Together,
    /// Each object writes a value of its own, and its outline follows it.
    OneByOne,
}

impl Default for Stencil {
    fn default() -> Self {
        Self { outline: None, order: Order::default(), factor: 1.25, distance: 0.25, pixels: 2.0 }
    }
}

impl Stencil {
    /// How outlines are made on this scene; `None` if its own states are used.
    pub fn way(&self, scene: &Scene) -> Option<Way> {
        let own = scene.draws.iter().any(|draw| draw.stencil.is_some());
        self.outline.or((!own).then_some(Way::Scale))
    }

    /// How outlines are made, and how far they reach.
    pub fn enlarge(&self, scene: &Scene) -> Option<Enlarge> {
        let way = self.way(scene)?;
        let amount = match way {
            Way::Scale => self.factor,
            Way::Normals => self.distance,
            Way::Pixels => self.pixels,
        };
        Some(Enlarge { way, amount })
    }
}

impl Family for Stencil {
    fn first() -> Self {
        Self::default()
    }

    fn name(&self) -> &'static str {
        "stencil"
    }

    fn is_of_scene(&self) -> bool {
        true
    }

    fn check(&self, _: &Scene) -> Checked {
        for (field, value) in [("factor", self.factor), ("distance", self.distance), ("pixels", self.pixels)]
        {
            each_finite(&[value]).map_err(|e| e.within(field))?;
        }
        Ok(())
    }

    fn play(&self, scene: &Scene, budget: Budget) -> Result<Box<dyn Playback>, Message> {
        refuse_large(scene)?;
        let draws = match self.enlarge(scene) {
            Some(enlarge) => outlined(scene, enlarge, self.order),
            None => draws_of(scene),
        };
        Ok(Box::new(stencil_test::play(draws, stencil_settings(scene), budget)))
    }

    fn settings(&self, scene: &Scene) -> Vec<Setting> {
        let parts = [Setting::of_scan(), Setting::of_transform(), Setting::of_facing(scene)];
        let depth = if self.way(scene).is_some() { Vec::new() } else { Setting::of_depth(scene) };
        parts.into_iter().chain([depth]).flatten().collect()
    }

    fn choices(&self) -> Vec<Choice> {
        let ways = [
            ("null", "word-outline-of-scene"),
            ("\"scale\"", "word-outline-scale"),
            ("\"normals\"", "word-outline-normals"),
            ("\"pixels\"", "word-outline-pixels"),
        ];
        let orders =
            [("\"together\"", "word-outlines-together"), ("\"one-by-one\"", "word-outlines-one-by-one")];
        let mut all = Choice::all("outline", "compare-outline", ways).to_vec();
        all.extend(Choice::all("order", "compare-outlines", orders));
        all
    }
}

/// The stencil and depth test of all of the scene's draws, with their own states.
pub(super) fn play_stencil_of(scene: &Scene, budget: Budget) -> Box<dyn Playback> {
    Box::new(stencil_test::play(draws_of(scene), stencil_settings(scene), budget))
}

/// The scene's draws with their own states.
fn draws_of(scene: &Scene) -> Vec<Draw> {
    let triangles = screen_triangles(scene);
    let draw = |(index, own): (usize, &scene::Draw)| {
        let name = draw_name((index, own));
        Draw { name, stencil: own.stencil, visible: is_seen(own), ..bare(scene, &triangles, index) }
    };
    scene.draws.iter().enumerate().map(draw).collect()
}

/// Whether a draw changes colours: one that keeps what is there and adds nothing does not.
fn is_seen(draw: &scene::Draw) -> bool {
    let keeps = |color: BlendComponent| {
        let factors = (color.src_factor, color.dst_factor);
        factors == (BlendFactor::Zero, BlendFactor::One) && color.operation == BlendOperation::Add
    };
    !draw.blend.is_some_and(|blend| keeps(blend.color))
}

/// The triangles of one draw, without a stencil test.
fn bare(scene: &Scene, triangles: &[ScreenTriangle], index: usize) -> Draw {
    let own = || triangles.iter().filter(|triangle| triangle.draw as usize == index);
    Draw {
        name: String::new(),
        triangles: own().map(|triangle| triangle.vertices).collect(),
        rules: own().map(|triangle| triangle.rules(scene)).collect(),
        enlarged: None,
        depth: scene.draws[index].depth,
        stencil: None,
        visible: true,
    }
}

/// Every object of the scene with an outline: the object writes a value, and the same object enlarged is
/// drawn where that value is not.
fn outlined(scene: &Scene, enlarge: Enlarge, order: Order) -> Vec<Draw> {
    let triangles = screen_triangles(scene);
    let reference = |index: usize| match order {
        Order::Together => 1,
        // Eight bits name 255 objects; more share the last value.
        Order::OneByOne => u8::try_from(index + 1).unwrap_or(u8::MAX),
    };
    let object = |index: usize| {
        let pass_op = StencilOperation::Replace;
        let stencil = StencilState { pass_op, reference: reference(index), ..StencilState::default() };
        let own = &scene.draws[index];
        let name = draw_name((index, own));
        Draw { name, stencil: Some(stencil), ..bare(scene, &triangles, index) }
    };
    let outline = |index: usize| {
        let compare = CompareFunction::NotEqual;
        let stencil = StencilState { compare, reference: reference(index), ..StencilState::default() };
        let before = object(index);
        let scissor = scene.draws[index].scissor;
        let enlarged = enlarged_triangles(scene, index, enlarge);
        let triangles: Vec<_> = enlarged.iter().map(|triangle| triangle.vertices).collect();
        Draw {
            name: before.name + "′",
            rules: vec![Rules { scissor, ..Rules::default() }; triangles.len()],
            triangles,
            enlarged: Some((enlarge, before.triangles)),
            depth: DepthState { test: false, write: false, ..DepthState::default() },
            stencil: Some(stencil),
            visible: true,
        }
    };
    let all = 0..scene.draws.len();
    match order {
        Order::Together => all.clone().map(object).chain(all.map(outline)).collect(),
        Order::OneByOne => all.flat_map(|index| [object(index), outline(index)]).collect(),
    }
}

/// The scene's conventions of the two tests.
fn stencil_settings(scene: &Scene) -> stencil_test::Settings {
    stencil_test::Settings {
        algorithm: raster::Algorithm::Scanline,
        raster: scan_settings(scene),
        format: scene.depth_format,
        clear_depth: scene.clear.depth,
        clear: scene.clear.stencil,
    }
}
