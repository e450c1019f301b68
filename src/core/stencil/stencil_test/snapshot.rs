//! What a stencil run has done so far.

use super::{Draw, Event, Image, Settings, StencilOutcome};
use crate::{explain::Role, replay::State};
use std::sync::Arc;

/// A fragment on its way through the tests.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Fragment {
    pub(super) x: u32,
    /// The stencil value that its pixel held.
    pub(super) stored: u8,
    /// Its depth code, and the one that its pixel held.
    pub(super) codes: [u32; 2],
    /// The verdict.
    pub(super) outcome: Option<StencilOutcome>,
    /// Whether its alpha was too low.
    pub(super) discarded: bool,
}

/// What the user sees between two events: the fold of the events so far.
#[derive(Debug, PartialEq)]
pub struct Snapshot {
    pub(super) draws: Arc<[Draw]>,
    pub(super) settings: Settings,
    pub(super) image: Image,
    /// The draw in hand, or the last one.
    pub(super) draw: Option<u32>,
    /// Whether its vertices have been moved outwards.
    pub(super) enlarged: bool,
    pub(super) y: u32,
    pub(super) fragment: Option<Fragment>,
    /// Pixels that the draw was tested at, and the verdicts.
    pub(super) verdicts: Vec<([u16; 2], Role)>,
    /// How many fragments have come to each pixel; more than that stay that.
    pub(super) arrived: Vec<u16>,
    /// Fragments of each draw begun, by their outcomes.
    pub(super) counts: Vec<[u32; 3]>,
}

impl Snapshot {
    /// Before the first event.
    pub fn new(draws: Arc<[Draw]>, settings: Settings) -> Self {
        Self {
            draws,
            settings,
            image: settings.empty(),
            draw: None,
            enlarged: false,
            y: 0,
            fragment: None,
            verdicts: Vec::new(),
            arrived: vec![0; settings.raster.size.map(|side| side as usize).iter().product()],
            counts: Vec::new(),
        }
    }

    /// What has been drawn so far.
    pub fn result(&self) -> &Image {
        &self.image
    }

    /// The draw in hand, or the last one, and which it is.
    pub(super) fn current(&self) -> Option<(&Draw, u32)> {
        self.draw.map(|index| (&self.draws[index as usize], index))
    }

    fn verdict(&mut self, outcome: StencilOutcome, after: u8) {
        let Some(fragment) = &mut self.fragment else { return };
        fragment.outcome = Some(outcome);
        let (pixel, code) = ([fragment.x, self.y], fragment.codes[0]);
        let index = self.image.depth.index(pixel);
        self.image.stencil[index] = after;
        let passed = outcome == StencilOutcome::Pass;
        let role = if passed { Role::Accepted } else { Role::Rejected };
        self.verdicts.push((pixel.map(|n| n as u16), role));
        if let Some(counts) = self.counts.last_mut() {
            counts[outcome as usize] += 1;
        }
        if let (StencilOutcome::Pass, Some((draw, owner))) = (outcome, self.current()) {
            let visible = draw.visible;
            if draw.depth.test && draw.depth.write {
                self.image.depth.set(pixel, code);
            }
            if visible {
                self.image.show(pixel, owner);
            }
        }
    }
}

impl Clone for Snapshot {
    fn clone(&self) -> Self {
        Self {
            draws: Arc::clone(&self.draws),
            image: self.image.clone(),
            arrived: self.arrived.clone(),
            verdicts: self.verdicts.clone(),
            counts: self.counts.clone(),
            ..*self
        }
    }

    /// Into the memory that is there: a seek starts with this.
    fn clone_from(&mut self, from: &Self) {
        self.image.clone_from(&from.image);
        self.arrived.clone_from(&from.arrived);
        self.verdicts.clone_from(&from.verdicts);
        self.counts.clone_from(&from.counts);
        let Self { settings, draw, enlarged, y, fragment, .. } = *from;
        (self.settings, self.draw, self.enlarged, self.y, self.fragment) =
            (settings, draw, enlarged, y, fragment);
    }
}

impl State for Snapshot {
    type Event = Event;

    fn apply(&mut self, event: &Event) {
        match *event {
            Event::Draw { index } => {
                (self.draw, self.enlarged, self.fragment) = (Some(index), false, None);
                self.verdicts.clear();
                self.counts.push([0; 3]);
            }
            Event::Enlarge { .. } => self.enlarged = true,
            Event::Early { .. } => {}
            Event::Scissor { y, .. } => (self.y, self.fragment) = (y.into(), None),
            Event::Row { y, .. } => (self.y, self.fragment) = (y, None),
            Event::Discard { .. } => {
                if let Some(fragment) = &mut self.fragment {
                    fragment.discarded = true;
                    self.verdicts.push(([fragment.x as u16, self.y as u16], Role::Skipped));
                }
            }
            Event::Fragment { x, stored, code, depth } => {
                let x = u32::from(x);
                let arrived = &mut self.arrived[self.image.depth.index([x, self.y])];
                *arrived = arrived.saturating_add(1);
                let codes = [code, depth];
                self.fragment = Some(Fragment { x, stored, codes, outcome: None, discarded: false });
            }
            Event::Fail { after } => self.verdict(StencilOutcome::Fail, after),
            Event::DepthFail { after } => self.verdict(StencilOutcome::DepthFail, after),
            Event::Pass { after } => self.verdict(StencilOutcome::Pass, after),
            Event::Done { .. } => self.fragment = None,
        }
    }

    fn size_hint(&self) -> usize {
        let pixel = 2 * size_of::<u32>() + size_of::<u8>() + size_of::<u16>() + size_of::<([u16; 2], Role)>();
        size_of::<Self>() + self.image.depth.codes().len() * pixel + self.draws.len() * size_of::<[u32; 3]>()
    }
}
