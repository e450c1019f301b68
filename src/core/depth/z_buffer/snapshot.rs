//! What a z-buffer run has done so far.

use super::{Early, Event, Image, Name, Rules, Settings, Triangle};
use crate::{
    explain::{Role, letter},
    replay::State,
};
use std::sync::Arc;

/// A fragment on its way through the test.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Fragment {
    pub(super) x: u32,
    pub(super) z: f32,
    pub(super) code: u32,
    /// The code and the owner that its pixel held.
    pub(super) stored: u32,
    pub(super) owner: Option<u32>,
    /// The verdict.
    pub(super) passed: Option<bool>,
    /// Its alpha, once that was tested, and whether it is kept.
    pub(super) alpha: Option<(f32, bool)>,
}

impl Fragment {
    /// Whether it is decided what its pixel holds from now on.
    pub(super) fn is_decided(&self) -> bool {
        self.passed.is_some() || self.alpha.is_some_and(|(_, kept)| !kept)
    }
}

/// What the user sees between two events: the fold of the events so far.
#[derive(Debug, PartialEq)]
pub struct Snapshot {
    pub(super) triangles: Arc<[Triangle]>,
    /// Those of the first triangles; the others have none.
    pub(super) rules: Arc<[Rules]>,
    /// One for each triangle.
    pub(super) names: Arc<[Name]>,
    pub(super) settings: Settings,
    pub(super) image: Image,
    /// The triangle being drawn, or the last one.
    pub(super) triangle: Option<u32>,
    /// When its fragments may be tested, in runs with an alpha test.
    pub(super) early: Option<Early>,
    pub(super) y: u32,
    pub(super) fragment: Option<Fragment>,
    /// Pixels that the triangle was tested at, and the verdicts; a tie where another triangle's code was
    /// the same.
    pub(super) verdicts: Vec<([u16; 2], Role)>,
    /// How many fragments have come to each pixel; more than that stay that.
    pub(super) arrived: Vec<u16>,
    /// Passed, failed, discarded and scissored fragments of each triangle begun; and of those tested how many
    /// had the code of another triangle.
    pub(super) counts: Vec<[u32; 5]>,
}

impl Snapshot {
    /// Before the first event.
    pub fn new(triangles: &[Triangle], rules: &[Rules], mut names: Vec<Name>, settings: Settings) -> Self {
        names.truncate(triangles.len());
        names.extend((names.len()..triangles.len()).map(|object| Name { text: letter(object), object }));
        Self {
            triangles: triangles.into(),
            rules: rules.into(),
            names: names.into(),
            settings,
            image: settings.empty(),
            arrived: vec![0; settings.raster.size.map(|side| side as usize).iter().product()],
            triangle: None,
            early: None,
            y: 0,
            fragment: None,
            verdicts: Vec::new(),
            counts: Vec::new(),
        }
    }

    /// What has been drawn so far.
    pub fn result(&self) -> &Image {
        &self.image
    }

    fn verdict(&mut self, passed: bool) {
        let Some(fragment) = &mut self.fragment else { return };
        fragment.passed = Some(passed);
        let role = if fragment.code == fragment.stored && fragment.owner.is_some() {
            Role::Tie
        } else if passed {
            Role::Accepted
        } else {
            Role::Rejected
        };
        self.verdicts.push(([fragment.x as u16, self.y as u16], role));
        self.count(usize::from(!passed), 1);
        self.count(4, u32::from(role == Role::Tie));
    }

    /// Counts fragments of the triangle in hand: 0 passed, 1 failed, 2 discarded, 3 scissored, 4 equal codes.
    fn count(&mut self, what: usize, fragments: u32) {
        if let Some(counts) = self.counts.last_mut() {
            counts[what] += fragments;
        }
    }

    /// The rules of the triangle in hand.
    pub(super) fn current_rules(&self) -> Rules {
        self.triangle.and_then(|index| self.rules.get(index as usize)).copied().unwrap_or_default()
    }
}

impl Clone for Snapshot {
    fn clone(&self) -> Self {
        Self {
            triangles: Arc::clone(&self.triangles),
            rules: Arc::clone(&self.rules),
            names: Arc::clone(&self.names),
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
        let Self { settings, triangle, early, y, fragment, .. } = *from;
        (self.settings, self.triangle, self.early) = (settings, triangle, early);
        (self.y, self.fragment) = (y, fragment);
    }
}

impl State for Snapshot {
    type Event = Event;

    fn apply(&mut self, event: &Event) {
        match *event {
            Event::Triangle { index } => {
                self.triangle = Some(index);
                self.fragment = None;
                self.verdicts.clear();
                self.counts.push([0; 5]);
            }
            Event::Early { when, .. } => self.early = Some(when),
            Event::Scissor { y, whole, kept } => {
                (self.y, self.fragment) = (y.into(), None);
                let len = |[begin, end]: [u16; 2]| u32::from(end - begin);
                self.count(3, len(whole) - len(kept));
            }
            Event::Row { y, .. } => (self.y, self.fragment) = (y, None),
            Event::Fragment { x, z, code, stored } => {
                let x = u32::from(x);
                let owner = self.image.owner([x, self.y]);
                let arrived = &mut self.arrived[self.image.depth.index([x, self.y])];
                *arrived = arrived.saturating_add(1);
                self.fragment = Some(Fragment { x, z, code, stored, owner, passed: None, alpha: None });
            }
            Event::Alpha { alpha, kept } => {
                if let Some(fragment) = &mut self.fragment {
                    fragment.alpha = Some((alpha, kept));
                    if !kept {
                        self.verdicts.push(([fragment.x as u16, self.y as u16], Role::Skipped));
                        self.count(2, 1);
                    }
                }
            }
            Event::Pass => {
                self.verdict(true);
                if let (Some(Fragment { x, code, .. }), Some(triangle)) = (self.fragment, self.triangle) {
                    let state = self.settings.state;
                    if state.test && state.write {
                        self.image.depth.set([x, self.y], code);
                    }
                    self.image.show([x, self.y], triangle);
                }
            }
            Event::Fail => self.verdict(false),
            Event::Done { .. } => self.fragment = None,
        }
    }

    fn size_hint(&self) -> usize {
        let pixel = 2 * size_of::<u32>() + size_of::<u16>() + size_of::<([u16; 2], Role)>();
        size_of::<Self>()
            + self.image.depth.codes().len() * pixel
            + self.triangles.len() * size_of::<[u32; 5]>()
    }
}
