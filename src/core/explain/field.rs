//! One number for each pixel of an image: shown as one picture, with the numbers where cells are large.

use crate::message::Value;

/// What the shades of a field look like; a theme has colours for each.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Tone {
    /// Neutral: for a quantity that is looked at for its shape.
    Grey,
    /// In colour, with equal steps for equal steps of the number: for a quantity that is compared.
    Heat,
}

/// The numbers of a field.
#[derive(Clone, Debug, PartialEq)]
pub enum Numbers {
    /// Whole numbers.
    Counts(Vec<u32>),
    /// Binary32 numbers.
    Floats(Vec<f32>),
}

/// One number for each pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct Field {
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// How it is shaded.
    pub tone: Tone,
    /// Row by row; as many as there are pixels.
    pub numbers: Numbers,
    /// The number of a pixel that nothing happened to: it has no shade.
    pub quiet: f32,
    /// The numbers of the weakest and of the strongest shade; the first may be the larger one.
    pub range: [f32; 2],
}

/// The weakest shade: a number with a shade is told from none.
const WEAKEST: f32 = 0.12;

impl Field {
    /// A field whose shades reach from the smallest to the largest number that is not `quiet`, or the
    /// other way round if `falling`.
    pub fn new(size: [u32; 2], tone: Tone, numbers: Numbers, quiet: f32, falling: bool) -> Self {
        let mut field = Self { size, tone, numbers, quiet, range: [quiet; 2] };
        let pixels = size[0] as usize * size[1] as usize;
        let loud = (0..pixels).map(|at| field.number(at)).filter(|number| *number != quiet);
        let ends = loud.fold(None, |ends: Option<[f32; 2]>, number| {
            let [low, high] = ends.unwrap_or([number; 2]);
            Some([low.min(number), high.max(number)])
        });
        if let Some([low, high]) = ends {
            field.range = if falling { [high, low] } else { [low, high] };
        }
        field
    }

    /// Whether every pixel is quiet.
    pub fn is_quiet(&self) -> bool {
        self.range == [self.quiet; 2]
    }

    /// The number of a pixel, counted row by row; as binary32, which holds counts up to 2^24.
    fn number(&self, at: usize) -> f32 {
        match &self.numbers {
            Numbers::Counts(counts) => counts.get(at).map_or(self.quiet, |count| *count as f32),
            Numbers::Floats(floats) => floats.get(at).copied().unwrap_or(self.quiet),
        }
    }

    /// How strong the shade of a pixel is, more than 0 and at most 1; `None` if it has none.
    pub fn share(&self, at: usize) -> Option<f32> {
        let number = self.number(at);
        if number == self.quiet {
            return None;
        }
        let [weak, strong] = self.range;
        let share = if weak == strong { 1.0 } else { (number - weak) / (strong - weak) };
        Some(WEAKEST + (1.0 - WEAKEST) * share.clamp(0.0, 1.0))
    }

    /// The number of a pixel as it is shown.
    pub fn value(&self, at: usize) -> Value {
        match &self.numbers {
            Numbers::Counts(counts) => counts.get(at).map_or(Value::None, |count| Value::from(*count)),
            Numbers::Floats(floats) => floats.get(at).map_or(Value::None, |number| Value::F32(*number)),
        }
    }

    /// The numbers of the weakest and of the strongest shade, as they are shown.
    pub fn ends(&self) -> [Value; 2] {
        self.range.map(|number| match self.numbers {
            Numbers::Counts(_) => Value::Int(number as i64),
            Numbers::Floats(_) => Value::F32(number),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shades_reach_from_the_weakest_to_the_strongest_and_leave_the_quiet_alone() {
        let field = |falling| Field::new([2, 2], Tone::Heat, Numbers::Counts(vec![0, 2, 3, 4]), 0.0, falling);
        let shares = |field: &Field| [0, 1, 2, 3].map(|at| field.share(at));
        assert_eq!(shares(&field(false)), [None, Some(WEAKEST), Some(0.56), Some(1.0)]);
        assert_eq!(shares(&field(true)), [None, Some(1.0), Some(0.56), Some(WEAKEST)]);
        assert_eq!(field(true).ends(), [Value::Int(4), Value::Int(2)]);
        assert_eq!(field(false).value(2), Value::from(3_u32));
    }

    #[test]
    fn one_number_has_the_strongest_shade() {
        let field = Field::new([2, 1], Tone::Grey, Numbers::Floats(vec![1.0, 0.5]), 1.0, true);
        assert_eq!([field.share(0), field.share(1)], [None, Some(1.0)]);
        assert!(!field.is_quiet());
        assert!(Field::new([1, 1], Tone::Grey, Numbers::Floats(vec![1.0]), 1.0, true).is_quiet());
    }
}
