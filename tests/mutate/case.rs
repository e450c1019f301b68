//! A case as words, so that the runner can mutate and shrink what it knows nothing about.

use crate::random::Random;

/// The bits of the numbers of a case, and small choices.
pub(crate) type Case = Vec<u32>;

/// Reads a case from its start. Any words are a case: what makes no sense is bent into what does.
pub(crate) struct Reader<'a>(pub(crate) &'a [u32]);

impl Reader<'_> {
    fn word(&mut self) -> u32 {
        let (&first, rest) = self.0.split_first().unwrap_or((&0, &[]));
        self.0 = rest;
        first
    }

    /// A finite number.
    pub(crate) fn number(&mut self) -> f32 {
        let value = f32::from_bits(self.word());
        if value.is_finite() { value } else { f32::from_bits(value.to_bits() & !(1 << 30)) }
    }

    /// `N` numbers.
    pub(crate) fn numbers<const N: usize>(&mut self) -> [f32; N] {
        [0; N].map(|_| self.number())
    }

    /// A window: two opposite corners in any order.
    pub(crate) fn window(&mut self) -> [f32; 4] {
        let [x0, y0, x1, y1] = self.numbers();
        // By value, so that the sign of a zero stays with its place.
        let [xmin, xmax] = if x0 <= x1 { [x0, x1] } else { [x1, x0] };
        let [ymin, ymax] = if y0 <= y1 { [y0, y1] } else { [y1, y0] };
        [xmin, ymin, xmax, ymax]
    }

    /// One of `all`.
    pub(crate) fn choice<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.word() as usize % all.len()]
    }
}

/// A number as code, readable where it is short, to the bit where it is not.
pub(crate) fn code(number: f32) -> String {
    let plain = format!("{number:?}");
    if plain.len() <= 8 { plain } else { format!("f32::from_bits({:#010x})", number.to_bits()) }
}

/// Numbers as the code of an array.
pub(crate) fn codes(numbers: &[f32]) -> String {
    format!("[{}]", numbers.iter().map(|&n| code(n)).collect::<Vec<_>>().join(", "))
}

/// Points as the code of an array of arrays.
pub(crate) fn points<const N: usize>(points: &[[f32; N]]) -> String {
    format!("[{}]", points.iter().map(|p| codes(p)).collect::<Vec<_>>().join(", "))
}

/// Numbers that arithmetic stumbles over.
const SPECIAL: [f32; 18] = [
    0.0,
    -0.0,
    0.5,
    1.0,
    1.5,
    -1.0,
    2.0,
    3.0,
    1e-45,
    -1e-45,
    f32::MIN_POSITIVE,
    f32::EPSILON,
    8_388_608.0,
    16_777_216.0,
    1e19,
    f32::MAX,
    f32::MIN,
    1.7e38,
];

/// A number of one of several families.
pub(crate) fn number(random: &mut Random, family: u32) -> f32 {
    match family % 5 {
        0 => random.below(13) as f32 / 2.0 - 1.0,
        1 => random.grid(-3, 8),
        2 => random.any(),
        3 => random.pick(&SPECIAL),
        _ => random.uniform(-10.0, 10.0),
    }
}

/// A case of `length` numbers, most of them of one family.
pub(crate) fn fresh(random: &mut Random, length: usize) -> Case {
    let family = random.bits();
    let mut case: Case = (0..length).map(|_| number(random, family).to_bits()).collect();
    for _ in 0..random.below(3) {
        mutate(random, &mut case);
    }
    case
}

/// Changes a case a little, the way that hurts: equal numbers, neighbours in binary32, signs,
/// exponents, points between points.
pub(crate) fn mutate(random: &mut Random, case: &mut Case) {
    let place = |random: &mut Random| random.below(case.len() as u32) as usize;
    let (to, from, other) = (place(random), place(random), place(random));
    let value = f32::from_bits(case[to]);
    case[to] = match random.below(11) {
        0 => case[from],
        1 => random.near(f32::from_bits(case[from])).to_bits(),
        2 | 3 => random.near(value).to_bits(),
        4 => (-f32::from_bits(case[from])).to_bits(),
        5 => random.pick(&SPECIAL).to_bits(),
        6 => (value * random.pick(&[2.0, 0.5, 1e10, 1e-10, 3.0])).to_bits(),
        7 => (f32::from_bits(case[from]) / 2.0 + f32::from_bits(case[other]) / 2.0).to_bits(),
        8 => case[to] ^ 1 << random.below(32),
        9 => (f32::from_bits(case[from]) + f32::from_bits(case[other])).to_bits(),
        _ => {
            let family = random.bits();
            number(random, family).to_bits()
        }
    };
    if random.below(8) == 0 {
        case.swap(from, other);
    }
}
