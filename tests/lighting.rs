//! A point in a light: laws, golden logs, and every brightness beside one with 200 bits.

use crate::support::{Coverage, Random, check_golden, check_laws, log_text};
use num_bigint::BigInt;
use num_traits::FromPrimitive;
use rasterscope_core::{
    math::{Arithmetic, ulps_between},
    replay::{Budget, Playback},
    shade::{
        Light, Material, Model, NormalMatrix, Place, brightness,
        lighting::{self, Event, Snapshot, Subject, Surface},
    },
    transform::matrices,
};

fn subject() -> Subject {
    Subject {
        surface: Surface { position: [0.0; 3], normal: [0.0, 1.0, 0.0] },
        model: matrices::IDENTITY,
        mistaken: false,
        light: Light::new(Place::Position([-3.0, 4.0, 0.0])),
        eye: Place::Position([4.0, 3.0, 0.0]),
        material: Material {
            ambient: 0.125,
            diffuse: 0.5,
            specular: 0.375,
            exponent: 8,
            ..Material::default()
        },
        arithmetic: Arithmetic::F64,
    }
}

fn run(subject: &Subject) -> (f32, Vec<Event>) {
    let mut events = Vec::new();
    (lighting::light_traced(subject, &mut events), events)
}

#[track_caller]
fn check(name: &str, subject: &Subject, expected: f32) {
    let (value, events) = run(subject);
    assert_eq!(value, expected);
    check_golden(&format!("lighting/{name}"), &log_text(&events));
}

#[test]
fn the_mirrored_light_in_the_eye_is_the_whole_highlight() {
    let eye = Place::Position([3.0, 4.0, 0.0]);
    check("highlight", &Subject { eye, ..subject() }, 0.125 + 0.5 * 0.8 + 0.375);
}

#[test]
fn a_light_behind_the_surface_adds_nothing() {
    let light = Light::new(Place::Position([-3.0, -2.0, 0.0]));
    check("behind", &Subject { light, ..subject() }, 0.125);
}

#[test]
fn the_half_vector_makes_the_other_highlight() {
    let material = Material { model: Model::BlinnPhong, ..subject().material };
    let eye = Place::Position([3.0, 4.0, 0.0]);
    check("half_vector", &Subject { material, eye, ..subject() }, 0.125 + 0.5 * 0.8 + 0.375);
}

#[test]
fn a_light_fades_with_the_distance() {
    let light = Light { attenuation: [1.0, 0.25, 0.25], ..Light::new(Place::Position([-1.2, 1.6, 0.0])) };
    let material = Material { specular: 0.0, ..subject().material };
    // The distance is 2 but for the roundings of 1.2 and 1.6.
    check("fades", &Subject { light, material, ..subject() }, 0.285);
}

#[test]
fn both_sides_turn_the_normal_to_the_eye() {
    let below = Place::Position([0.0, -2.0, 0.0]);
    let material = Material { two_sided: true, specular: 0.0, ..subject().material };
    check("both_sides", &Subject { light: Light::new(below), eye: below, material, ..subject() }, 0.625);
}

#[test]
fn the_model_matrix_leans_a_normal_under_uneven_scale() {
    let model = matrices::model([0.0; 3], [0.0; 3], [1.0, 0.25, 1.0]);
    let surface = Surface { position: [0.0; 3], normal: [0.75, 0.75, 0.0] };
    // The light stands over the surface, along its right normal.
    let light = Light::new(Place::Direction([0.25, 1.0, 0.0]));
    let material = Material { ambient: 0.0, diffuse: 1.0, specular: 0.0, ..subject().material };
    let right = Subject { model, surface, light, material, ..subject() };
    check("normal_matrix", &right, 1.0);
    check("model_matrix", &Subject { mistaken: true, ..right }, 8.0 / 17.0);
}

#[test]
fn a_zero_normal_leaves_the_ambient_term() {
    let surface = Surface { position: [0.0; 3], normal: [0.0; 3] };
    check("no_normal", &Subject { surface, ..subject() }, 0.125);
}

/// A number with [`BITS`] bits behind the point.
#[derive(Clone, Debug, PartialEq, PartialOrd)]
struct Fixed(BigInt);

const BITS: usize = 400;

fn exact(value: f32) -> Fixed {
    let scaled = f64::from(value) * 2f64.powi(149);
    Fixed(BigInt::from_f64(scaled).expect("a whole number") << (BITS - 149))
}

impl Fixed {
    fn root(&self) -> Self {
        Self((&self.0 << BITS).sqrt())
    }

    fn over(&self, other: &Self) -> Self {
        Self((&self.0 << BITS) / &other.0)
    }

    fn times(&self, other: &Self) -> Self {
        Self((&self.0 * &other.0) >> BITS)
    }

    fn minus(&self, other: &Self) -> Self {
        Self(&self.0 - &other.0)
    }

    fn plus(&self, other: &Self) -> Self {
        Self(&self.0 + &other.0)
    }

    fn is_positive(&self) -> bool {
        self.0 > BigInt::from(0)
    }
}

fn dot(a: &[Fixed; 3], b: &[Fixed; 3]) -> Fixed {
    a[0].times(&b[0]).plus(&a[1].times(&b[1])).plus(&a[2].times(&b[2]))
}

fn unit(v: &[Fixed; 3]) -> [Fixed; 3] {
    let length = dot(v, v).root();
    if length.is_positive() { v.clone().map(|c| c.over(&length)) } else { [0.0; 3].map(exact) }
}

/// The brightness by the definition, cut far behind the last bit of binary64.
fn oracle(subject: &Subject) -> Fixed {
    let position = subject.surface.position.map(exact);
    let towards = |place: Place| match place {
        Place::Position(to) => [0, 1, 2].map(|axis| exact(to[axis]).minus(&position[axis])),
        Place::Direction(to) => to.map(exact),
    };
    let Material { ambient, diffuse, specular, exponent, model, two_sided, .. } = subject.material;
    let mut n = unit(&subject.surface.normal.map(exact));
    let v = unit(&towards(subject.eye));
    let to_light = towards(subject.light.place);
    let l = unit(&to_light);
    if two_sided && exact(0.0).minus(&dot(&n, &v)).is_positive() {
        n = n.map(|c| exact(0.0).minus(&c));
    }
    let ambient = exact(ambient);
    let incidence = dot(&n, &l);
    if !incidence.is_positive() {
        return ambient;
    }
    let intensity = exact(subject.light.intensity);
    let fade = match subject.light.place {
        Place::Position(_) => {
            let [c0, c1, c2] = subject.light.attenuation.map(exact);
            let d = dot(&to_light, &to_light).root();
            intensity.over(&c0.plus(&c1.times(&d)).plus(&c2.times(&d).times(&d)))
        }
        Place::Direction(_) => intensity,
    };
    let cosine = match model {
        Model::Phong => {
            let twice = incidence.plus(&incidence);
            dot(&[0, 1, 2].map(|i| twice.times(&n[i]).minus(&l[i])), &v)
        }
        Model::BlinnPhong => dot(&n, &unit(&[0, 1, 2].map(|i| l[i].plus(&v[i])))),
    };
    let power = (0..exponent).fold(exact(1.0), |power, _| power.times(&cosine));
    let specular = if cosine.is_positive() { exact(specular).times(&power) } else { exact(0.0) };
    let sum = ambient.plus(&fade.times(&exact(diffuse).times(&incidence).plus(&specular)));
    if sum > exact(1.0) { exact(1.0) } else { sum }
}

fn any(random: &mut Random) -> Subject {
    let mut vector = |reach: i32| [0; 3].map(|_| random.grid(-reach, reach));
    let (position, normal, light, eye) = (vector(2), vector(1), vector(4), vector(4));
    let place = random.pick(&[Place::Position, Place::Direction]);
    let light = Light {
        place: place(if light == [0.0; 3] { [0.0, 1.0, 0.0] } else { light }),
        intensity: random.uniform(0.5, 1.5),
        attenuation: random.pick(&[[1.0, 0.0, 0.0], [0.5, 0.25, 0.125], [0.0, 0.0, 0.25]]),
    };
    Subject {
        surface: Surface { position, normal: random.pick(&[normal, normal, [0.0, 1.0, 0.0], [0.0; 3]]) },
        light,
        eye: Place::Position(random.pick(&[eye, eye, eye, position])),
        material: Material {
            ambient: random.uniform(0.0, 0.3),
            diffuse: random.uniform(0.0, 0.5),
            specular: random.uniform(0.0, 0.5),
            exponent: random.pick(&[1, 2, 3, 8, 16, 100]),
            model: random.pick(&Model::ALL),
            two_sided: random.below(2) == 0,
            ..Material::default()
        },
        ..subject()
    }
}

/// The distance of a result from the value, in units of its last place.
fn off(value: f32, exactly: &Fixed) -> Fixed {
    let off = exact(value).minus(exactly);
    let off = if off.is_positive() { off } else { exact(0.0).minus(&off) };
    off.over(&exact(value.next_up()).minus(&exact(value)))
}

#[test]
fn binary64_gives_the_nearest_binary32() {
    let mut random = Random::new(71);
    let (mut bright, mut highlights) = (0, 0);
    for _ in 0..300 {
        let subject = any(&mut random);
        let exactly = oracle(&subject);
        let value = lighting::light(&subject);
        // A root and a power with 53 bits are far closer than half a unit of binary32.
        assert!(off(value, &exactly) <= exact(0.5 + 1.0 / 1024.0), "{value} of {subject:?}");
        let light = brightness(subject.surface, subject.eye, &[subject.light], &subject.material);
        bright += u32::from(light.matte > f64::from(subject.material.ambient));
        highlights += u32::from(light.gloss > 1e-6);
        assert_eq!(light.of_white(), value, "the identity turns nothing: {subject:?}");
    }
    assert!(bright > 60 && highlights > 30, "{bright} {highlights}");
}

#[test]
fn binary32_is_off_by_a_few_units() {
    let mut random = Random::new(72);
    let mut worst = 0;
    for _ in 0..20_000 {
        let subject = any(&mut random);
        let wide = lighting::light(&subject);
        let narrow = lighting::light(&Subject { arithmetic: Arithmetic::F32, ..subject });
        worst = worst.max(ulps_between(wide, narrow));
    }
    assert!((2..1000).contains(&worst), "{worst}");
}

/// In one plane the angle between r and v is twice that between n and h.
#[test]
fn the_mirrored_light_moves_twice_as_fast_as_the_half_vector() {
    let mut random = Random::new(73);
    let cosine = |subject: &Subject| {
        run(subject).1.into_iter().find_map(|event| match event {
            Event::Highlight { cosine, .. } => Some(cosine),
            _ => None,
        })
    };
    let mut seen = 0;
    for _ in 0..500 {
        let place =
            |random: &mut Random| Place::Direction([random.grid(-4, 4), random.grid(0, 4) + 1.0 / 64.0, 0.0]);
        let (light, eye) = (Light::new(place(&mut random)), place(&mut random));
        let [phong, blinn] = Model::ALL.map(|model| {
            let material = Material { model, ..subject().material };
            cosine(&Subject { light, eye, material, ..subject() }).expect("it is in front")
        });
        let twice = 2.0 * blinn * blinn - 1.0;
        if twice > 0.0 {
            seen += 1;
            assert!((phong - twice).abs() < 1e-14, "{phong} {twice}");
        }
    }
    assert!(seen > 100);
}

/// What a matrix does to a tangent it must undo for the normal.
#[test]
fn a_normal_stays_upright_on_its_surface() {
    let mut random = Random::new(74);
    for _ in 0..1000 {
        let mut vector = |reach: i32| [0; 3].map(|_| random.grid(-reach, reach));
        let (turn, scale, [a, b, c], along) = (vector(180), vector(3), vector(2), vector(2));
        let model = matrices::model([1.0, 2.0, 3.0], turn, scale);
        // Across (a, b, c) and along.
        let normal = [b * along[2] - c * along[1], c * along[0] - a * along[2], a * along[1] - b * along[0]];
        let turned = NormalMatrix::new(&model).apply(normal).map(f64::from);
        for [x, y, z] in [[a, b, c], along] {
            let [x, y, z, _] = matrices::apply(&model, [x, y, z, 0.0]).map(f64::from);
            let dot = turned[0] * x + turned[1] * y + turned[2] * z;
            let size = turned.iter().chain(&[x, y, z]).map(|c| c * c).sum::<f64>();
            assert!(dot.abs() <= 1e-5 * size.max(1e-30), "{dot} of {size}");
        }
    }
}

#[test]
fn keeps_the_laws() {
    let mut random = Random::new(75);
    let mut coverage = Coverage::default();
    for _ in 0..200 {
        let subject = any(&mut random);
        for arithmetic in [Arithmetic::F64, Arithmetic::F32] {
            let subject = Subject { arithmetic, mistaken: random.below(4) == 0, ..subject };
            let (traced, events) = run(&subject);
            check_laws(
                (&Some(lighting::light(&subject)), &Some(traced)),
                &events,
                |budget| lighting::play(subject, budget),
                Snapshot::result,
                &mut coverage,
            );
        }
    }
    coverage.check_every_line::<Snapshot>();
}

/// Of the terms, only one that the step computes is lit.
#[test]
fn a_term_is_lit_in_its_own_step() {
    let mut player = lighting::play(subject(), Budget::default());
    for step in 0..=player.len() {
        player.seek(step);
        let tables = player.tables();
        let lit: Vec<_> = tables[0].rows.iter().filter(|row| row.active).map(|row| &*row.name).collect();
        let expected: &[&str] = match player.event() {
            Some(Event::Ambient { .. }) => &["row-shade-ambient"],
            Some(Event::Diffuse { .. }) => &["row-shade-diffuse"],
            Some(Event::Specular { .. }) => &["row-shade-specular"],
            Some(Event::Sum { .. }) => &["I"],
            _ => &[],
        };
        assert_eq!(lit, expected, "step {step}");
    }
}
