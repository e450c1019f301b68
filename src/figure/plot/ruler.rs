//! An axis laid out: from numbers to points, and where its ticks stand.

use rasterscope_core::message::Value;

use crate::{
    numbers,
    plot::{Axis, Scale},
};

/// Width of a lane beside the axis proper.
const LANE: f64 = 64.0;

/// A mark of an axis.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Tick {
    pub(super) at: f32,
    /// Empty: a line only.
    pub(super) text: String,
}

/// An axis laid out between two places of the figure.
#[derive(Clone, Debug)]
pub(super) struct Ruler {
    scale: Scale,
    /// What lies at the ends of the axis proper; exponents of 10 on a logarithmic one.
    low: f64,
    high: f64,
    /// Where these lie.
    begin: f64,
    end: f64,
    /// Where the lanes are.
    pub(super) zero: Option<f32>,
    pub(super) infinite: Option<f32>,
}

impl Ruler {
    /// Lays an axis out for some values; `end` may lie before `begin`.
    pub(super) fn new(axis: &Axis, values: &[f64], begin: f32, end: f32) -> Self {
        let (mut begin, mut end) = (f64::from(begin), f64::from(end));
        let lane = LANE * (end - begin).signum();
        let log = axis.scale == Scale::Log;
        let has = |wanted: fn(f64) -> bool| values.iter().any(|value| wanted(*value));
        let zero = (log && has(|value| value == 0.0)).then(|| {
            begin += lane;
            (begin - lane / 2.0) as f32
        });
        let infinite = has(|value| value == f64::INFINITY).then(|| {
            end -= lane;
            (end + lane / 2.0) as f32
        });
        let [low, high] = match &axis.scale {
            Scale::Names(names) => [0.0, names.len().max(1) as f64],
            Scale::Linear => {
                let greatest = values.iter().copied().filter(|value| value.is_finite()).fold(0.0, f64::max);
                // Above the greatest there is room for its label; beside it, a little.
                let room = if end > begin { 1.05 } else { 1.2 };
                [0.0, if greatest > 0.0 { greatest * room } else { 1.0 }]
            }
            Scale::Log => log_bounds(values),
        };
        Self { scale: axis.scale.clone(), low, high, begin, end, zero, infinite }
    }

    /// Where a value lies, if it has a place.
    pub(super) fn at(&self, value: f64) -> Option<f32> {
        if value == f64::INFINITY {
            return self.infinite;
        }
        let value = match self.scale {
            Scale::Log if value == 0.0 => return self.zero,
            Scale::Log => value.log10(),
            Scale::Names(_) => value + 0.5,
            Scale::Linear => value,
        };
        let part = (value - self.low) / (self.high - self.low);
        part.is_finite().then_some((self.begin + part * (self.end - self.begin)) as f32)
    }

    /// The place on the axis proper that is nearest to a place.
    pub(super) fn within(&self, at: f32) -> f32 {
        let [begin, end] = self.ends();
        at.clamp(begin.min(end), begin.max(end))
    }

    /// Where the axis proper begins and ends.
    pub(super) fn ends(&self) -> [f32; 2] {
        [self.begin as f32, self.end as f32]
    }

    /// How much room one name has.
    pub(super) fn room(&self) -> f32 {
        ((self.end - self.begin).abs() / (self.high - self.low)) as f32
    }

    /// The ticks; a text needs `room`, in points.
    pub(super) fn ticks(&self, room: f32) -> Vec<Tick> {
        let room = f64::from(room);
        match &self.scale {
            Scale::Names(names) => {
                let tick =
                    |(i, name): (usize, &String)| Some(Tick { at: self.at(i as f64)?, text: name.clone() });
                names.iter().enumerate().filter_map(tick).collect()
            }
            Scale::Linear => self.linear(room),
            Scale::Log => self.log(room),
        }
    }

    fn linear(&self, room: f64) -> Vec<Tick> {
        let most = ((self.end - self.begin).abs() / room).max(1.0);
        let step = round_up((self.high - self.low) / most);
        let count = ((self.high - self.low) / step) as usize;
        let tick = |i: usize| {
            let value = i as f64 * step;
            Some(Tick { at: self.at(value)?, text: name(value) })
        };
        (0..=count).filter_map(tick).collect()
    }

    fn log(&self, room: f64) -> Vec<Tick> {
        let decade = (self.end - self.begin).abs() / (self.high - self.low);
        // Every so many decades has a text, and 2 and 5 have one if all of them have room.
        let every = (room / decade).ceil().max(1.0) as i32;
        let between = decade * 0.3 >= room;
        let lines = decade >= 60.0;
        let mut ticks = Vec::new();
        for exponent in self.low.floor() as i32..=self.high.ceil() as i32 {
            for (i, digit) in [1.0, 2.0, 5.0].into_iter().enumerate() {
                let place = f64::from(exponent) + f64::log10(digit);
                let near = 1e-9;
                if place < self.low - near || place > self.high + near {
                    continue;
                }
                let named = if i == 0 { exponent.rem_euclid(every) == 0 } else { between };
                if i == 0 || lines {
                    let value = digit * 10.0_f64.powi(exponent);
                    let text = if named { name(value) } else { String::new() };
                    let part = (place - self.low) / (self.high - self.low);
                    ticks.push(Tick { at: (self.begin + part * (self.end - self.begin)) as f32, text });
                }
            }
        }
        ticks
    }
}

/// A round number in its shortest form.
fn name(value: f64) -> String {
    numbers::short(&Value::F64(value))
}

/// Exponents around all values that have one: 1, 2 or 5 times a power of 10, not too near to a value.
fn log_bounds(values: &[f64]) -> [f64; 2] {
    let logs = values.iter().filter(|value| value.is_finite() && **value > 0.0).map(|value| value.log10());
    let [low, high] =
        logs.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], log| [low.min(log), high.max(log)]);
    if low > high {
        return [0.0, 2.0];
    }
    let margin = ((high - low) * 0.06).max(0.12);
    let [low, high] = [down(low - margin), -down(-high - margin)];
    if high - low < 1.0 { [low, low + 1.0] } else { [low, high] }
}

/// The next exponent of 1, 2 or 5 times a power of 10 below; mirrored, these are 1, 5 and 2 times one.
fn down(exponent: f64) -> f64 {
    let whole = exponent.floor();
    let step = [5.0_f64.log10(), 2.0_f64.log10(), 0.0].into_iter().find(|step| whole + step <= exponent);
    whole + step.unwrap_or(0.0)
}

/// The next of 1, 2 or 5 times a power of 10 above.
fn round_up(step: f64) -> f64 {
    let power = 10.0_f64.powf(step.log10().floor());
    [1.0, 2.0, 5.0, 10.0]
        .into_iter()
        .map(|digit| digit * power)
        .find(|it| *it >= step * 0.999)
        .unwrap_or(step)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ruler(scale: Scale, values: &[f64]) -> Ruler {
        Ruler::new(&Axis::new(String::new(), scale), values, 0.0, 600.0)
    }

    fn texts(ruler: &Ruler, room: f32) -> Vec<String> {
        ruler.ticks(room).into_iter().map(|tick| tick.text).filter(|text| !text.is_empty()).collect()
    }

    #[test]
    fn every_value_lies_on_its_axis() {
        let values = [3.0, 70.0, 12_345.0, 0.0, f64::INFINITY];
        let ruler = ruler(Scale::Log, &values);
        let places = values.map(|value| ruler.at(value).expect("it has a place"));
        assert!(places[3] < places[0] && places[0] < places[1] && places[1] < places[2]);
        assert!(places[2] < places[4] && places.iter().all(|at| (0.0..=600.0).contains(at)));
        assert_eq!(ruler.at(f64::NAN), None);
        assert_eq!(ruler.at(-1.0), None);
    }

    #[test]
    fn lanes_are_there_only_if_needed() {
        let ruler = ruler(Scale::Log, &[1.0, 10.0]);
        assert_eq!((ruler.zero, ruler.infinite, ruler.ends()), (None, None, [0.0, 600.0]));
        assert_eq!(ruler.at(0.0), None);
    }

    #[test]
    fn ticks_are_round_numbers_with_room() {
        assert_eq!(
            texts(&ruler(Scale::Log, &[1.0, 1e9]), 80.0),
            ["1", "100", "10\u{2009}000", "1 × 10⁶", "1 × 10⁸"]
        );
        assert_eq!(texts(&ruler(Scale::Log, &[4.0, 40.0]), 40.0), ["2", "5", "10", "20", "50", "100"]);
        assert_eq!(texts(&ruler(Scale::Linear, &[1.0]), 120.0), ["0", "0.5", "1"]);
        let up = Ruler::new(&Axis::new(String::new(), Scale::Linear), &[0.52], 600.0, 0.0);
        assert_eq!(texts(&up, 100.0), ["0", "0.2", "0.4", "0.6"]);
        assert_eq!(texts(&ruler(Scale::Names(vec!["a".into(), "b".into()]), &[0.0]), 10.0), ["a", "b"]);
    }

    #[test]
    fn nothing_measured_still_makes_an_axis() {
        for scale in [Scale::Log, Scale::Linear, Scale::Names(Vec::new())] {
            assert!(ruler(scale, &[]).ends()[1] > 0.0);
        }
    }
}
