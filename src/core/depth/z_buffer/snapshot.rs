//! What a z-buffer run has done so far.

use super::{Event, Image, Name, Settings, Triangle};
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
}

/// What the user sees between two events: the fold of the events so far.
#[derive(Debug, PartialEq)]
pub struct Snapshot {
    pub(super) triangles: Arc<[Triangle]>,
    /// One for each triangle.
    pub(super) names: Arc<[Name]>,
    pub(super) settings: Settings,
    pub(super) image: Image,
    /// The triangle being drawn, or the last one.
    pub(super) triangle: Option<u32>,
    pub(super) y: u32,
    pub(super) fragment: Option<Fragment>,
    /// Pixels that the triangle was tested at, and the verdicts; a tie where another triangle's code was
    /// the same.
    pub(super) verdicts: Vec<([u16; 2], Role)>,
    /// How many fragments have come to each pixel; more than that stay that.
    pub(super) arrived: Vec<u16>,
    /// Passed and failed fragments of each triangle begun.
    pub(super) counts: Vec<[u32; 2]>,
}

impl Snapshot {
    /// Before the first event.
    pub fn new(triangles: &[Triangle], mut names: Vec<Name>, settings: Settings) -> Self {
        names.truncate(triangles.len());
        names.extend((names.len()..triangles.len()).map(|object| Name { text: letter(object), object }));
        Self {
            triangles: triangles.into(),
            names: names.into(),
            settings,
            image: settings.empty(),
            arrived: vec![0; settings.raster.size.map(|side| side as usize).iter().product()],
            triangle: None,
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
        if let Some([passes, fails]) = self.counts.last_mut() {
            *(if passed { passes } else { fails }) += 1;
        }
    }
}

impl Clone for Snapshot {
    fn clone(&self) -> Self {
        Self {
            triangles: Arc::clone(&self.triangles),
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
        let Self { settings, triangle, y, fragment, .. } = *from;
        (self.settings, self.triangle, self.y, self.fragment) = (settings, triangle, y, fragment);
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
                self.counts.push([0, 0]);
            }
            Event::Row { y, .. } => (self.y, self.fragment) = (y, None),
            Event::Fragment { x, z, code, stored } => {
                let x = u32::from(x);
                let owner = self.image.owner([x, self.y]);
                let arrived = &mut self.arrived[self.image.depth.index([x, self.y])];
                *arrived = arrived.saturating_add(1);
                self.fragment = Some(Fragment { x, z, code, stored, owner, passed: None });
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
            + self.triangles.len() * size_of::<[u32; 2]>()
    }
}
