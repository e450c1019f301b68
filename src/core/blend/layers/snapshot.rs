//! What a run over one pixel has done so far.

use super::{Blended, Event, Layer, Order, Settings};
use crate::{explain::letter, replay::State};
use std::sync::Arc;

/// What the user sees between two events: the fold of the events so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    pub(super) layers: Arc<[Layer]>,
    /// One for each layer.
    pub(super) names: Arc<[String]>,
    pub(super) settings: Settings,
    /// The order so far: of a list, what has joined it.
    pub(super) list: Vec<u8>,
    /// The place of the first of two neighbours just compared.
    pub(super) compared: Option<u8>,
    /// The layer in hand.
    pub(super) layer: Option<u8>,
    /// The channel just computed.
    pub(super) channel: Option<u8>,
    /// Its layer's codes, as far as they are known.
    pub(super) new: [Option<u8>; 4],
    pub(super) result: Blended,
}

impl Snapshot {
    /// Before the first event. Layers without a name are called A, B, C, ...
    pub fn new(layers: Arc<[Layer]>, names: &[String], settings: Settings) -> Self {
        let name = |index: usize| names.get(index).filter(|name| !name.is_empty()).cloned();
        let names = (0..layers.len()).map(|index| name(index).unwrap_or_else(|| letter(index))).collect();
        let all = 0..layers.len() as u8;
        let list = match settings.order {
            Order::AsDrawn => all.collect(),
            Order::Reversed => all.rev().collect(),
            Order::Sorted => Vec::new(),
        };
        let result = Blended { after: Vec::new(), color: settings.codes() };
        let [compared, layer, channel] = [None; 3];
        Self { layers, names, settings, list, compared, layer, channel, new: [None; 4], result }
    }

    /// What has become of the pixel so far.
    pub fn result(&self) -> &Blended {
        &self.result
    }
}

impl State for Snapshot {
    type Event = Event;

    fn apply(&mut self, event: &Event) {
        self.compared = None;
        self.channel = None;
        match *event {
            Event::Append { index } => self.list.push(index),
            Event::Compare { at, swapped } => {
                self.compared = Some(at);
                if swapped {
                    self.list.swap(usize::from(at), usize::from(at) + 1);
                }
            }
            Event::Layer { index } => (self.layer, self.new) = (Some(index), [None; 4]),
            Event::Channel { channel, code } => {
                self.channel = Some(channel);
                self.new[usize::from(channel)] = Some(code);
            }
            Event::Store { codes } => {
                self.result.color = codes;
                self.result.after.extend(self.layer.map(|index| (index, codes)));
            }
        }
    }

    fn size_hint(&self) -> usize {
        size_of::<Self>() + self.layers.len() * (size_of::<u8>() + size_of::<(u8, [u8; 4])>())
    }
}
