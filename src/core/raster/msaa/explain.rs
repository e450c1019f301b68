//! What the lab shows of a multisampled run.

use super::{Conventions, Event, Image, Samples, Shading, Triangle};
use crate::{
    compare::Fact,
    explain::{Explain, Formula, Level, Mark, Marker, Operations, Piece, Role, Row, Table, View, letter},
    math::{Tally, edge_value},
    message::{Message, Value},
    raster::{Edges, view::view_of},
    replay::State,
};
use std::sync::Arc;

/// What is known of a sample of the pixel in hand: inside, and whether a tie rule decided.
pub(super) type Verdict = Option<(bool, bool)>;

/// What the user sees between two events: the fold of the events so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    pub(super) triangles: Arc<[Triangle]>,
    pub(super) conventions: Conventions,
    pub(super) image: Image,
    pub(super) triangle: Option<u32>,
    /// The pixel in hand, and what is known of its samples.
    pub(super) pixel: Option<[u32; 2]>,
    pub(super) verdicts: [Verdict; Samples::MOST],
    /// The triangle that each drawn sample shows, plus 1.
    pub(super) owners: Vec<[u8; Samples::MOST]>,
    /// How many pixels of the image have been looked at for the last time.
    pub(super) resolved: usize,
    /// Shades computed, samples tested, samples inside.
    pub(super) counts: [u64; 3],
}

impl Snapshot {
    /// Before the first event.
    pub fn new(triangles: &[Triangle], conventions: Conventions) -> Self {
        let image = Image::new(conventions.raster.size);
        Self {
            triangles: triangles.into(),
            conventions,
            owners: vec![[0; Samples::MOST]; image.masks.len()],
            image,
            triangle: None,
            pixel: None,
            verdicts: [None; Samples::MOST],
            resolved: 0,
            counts: [0; 3],
        }
    }

    /// The image so far.
    pub fn result(&self) -> Image {
        self.image.clone()
    }

    pub(super) fn sample_point(&self, pixel: [u32; 2], index: usize) -> [f32; 2] {
        self.conventions.samples.point(pixel, index, self.conventions.raster.y_axis)
    }

    /// The edge values of a point, twice the areas, inside positive.
    pub(super) fn edge_values(&self, triangle: usize, point: [f32; 2]) -> Option<[f64; 3]> {
        let raster = &self.conventions.raster;
        let points = raster.vertices(self.triangles.get(triangle)?.map(|[x, y, _]| [x, y]));
        let edges = Edges::new(points, raster, &mut Tally::default())?;
        Some(edges.0.map(|edge| edge_value(edge.ends[0], edge.ends[1], point).value))
    }

    fn name(&self) -> Value {
        self.triangle.map(|index| Value::text(letter(index as usize))).into()
    }
}

impl State for Snapshot {
    type Event = Event;

    fn apply(&mut self, event: &Event) {
        match *event {
            Event::Triangle { index } => (self.triangle, self.pixel) = (Some(index), None),
            Event::Pixel { x, y } => {
                self.pixel = Some([x.into(), y.into()]);
                self.verdicts = [None; Samples::MOST];
            }
            Event::Sample { index, covered, tie } => {
                self.verdicts[usize::from(index)] = Some((covered, tie));
                self.counts[1] += 1;
                self.counts[2] += u64::from(covered);
            }
            Event::Shade { mask, code, .. } => {
                self.counts[0] += 1;
                if let (Some(pixel), Some(triangle)) = (self.pixel, self.triangle) {
                    self.image.store(pixel, mask, code);
                    let owners = &mut self.owners[self.image.index(pixel)];
                    for (sample, owner) in owners.iter_mut().enumerate() {
                        if mask & 1 << sample != 0 {
                            *owner = (triangle + 1) as u8;
                        }
                    }
                }
            }
            Event::Resolve { x, y, code } => {
                let pixel = [x.into(), y.into()];
                let index = self.image.index(pixel);
                self.image.codes[index] = code;
                (self.resolved, self.pixel, self.triangle) = (index + 1, Some(pixel), None);
                self.verdicts = [None; Samples::MOST];
            }
            Event::Done => self.pixel = None,
            Event::Mask { .. } | Event::ZeroArea => {}
        }
    }

    fn size_hint(&self) -> usize {
        size_of::<Self>() + self.image.masks.len() * (2 * Samples::MOST + 2)
    }
}

impl Explain for Snapshot {
    const NAME: &'static str = "msaa";

    const LISTING: &'static [&'static str] = &[
        "for each triangle T",
        "  no area: draw nothing",
        "  for each pixel of the box around T",
        "    each sample: inside if E0, E1, E2 let it in",
        "    mask ← the samples inside; none: next pixel",
        "    centre: shade once, at the pixel's centre",
        "    centroid: shade once; all inside: at the centre,",
        "      else at the first sample inside",
        "    per sample: shade at each sample inside",
        "for each pixel: show ⌊mean of its samples + ½⌋",
    ];

    fn line(event: &Event) -> usize {
        match event {
            Event::Triangle { .. } => 0,
            Event::ZeroArea => 1,
            Event::Pixel { .. } => 2,
            Event::Sample { .. } => 3,
            Event::Mask { .. } => 4,
            Event::Shade { shading: Shading::Centre, .. } => 5,
            Event::Shade { shading: Shading::Centroid, at: None, .. } => 6,
            Event::Shade { shading: Shading::Centroid, .. } => 7,
            Event::Shade { shading: Shading::PerSample, .. } => 8,
            Event::Resolve { .. } | Event::Done => 9,
        }
    }

    fn operations(event: &Event) -> Operations {
        match event {
            // Three edge functions, each two products and a sign.
            Event::Sample { .. } => Operations::new(3, 6, 0),
            Event::Shade { .. } => Operations::new(0, 3, 0),
            Event::Resolve { .. } => Operations::new(0, 0, 1),
            _ => Operations::NONE,
        }
    }

    fn level(event: &Event) -> Level {
        match event {
            Event::Triangle { .. } | Event::Done => Level::Primitive,
            Event::Mask { .. } | Event::Resolve { .. } | Event::ZeroArea => Level::Row,
            Event::Pixel { .. } | Event::Sample { .. } | Event::Shade { .. } => Level::Detail,
        }
    }

    fn marker(event: &Event) -> Option<Marker> {
        let (role, label) = match event {
            Event::Triangle { .. } => (Role::Neutral, Some("msaa-marker-triangle")),
            Event::Sample { tie: true, .. } => (Role::Tie, None),
            Event::Shade { .. } => (Role::Accepted, None),
            Event::Resolve { .. } => (Role::Exact, None),
            Event::ZeroArea => (Role::Skipped, Some("scanline-marker-zero-area")),
            _ => return None,
        };
        Some(Marker { role, label })
    }

    fn caption(&self, event: &Event) -> Option<Message> {
        let label = Self::marker(event)?.label?;
        let Event::Triangle { index } = *event else { return Some(Message::new(label)) };
        Some(Message::new(label).with("object", Value::text(letter(index as usize))))
    }

    fn opening(&self) -> Message {
        Message::new("msaa-opening").with("count", self.conventions.samples.count())
    }

    fn sentence(&self, event: &Event) -> Message {
        let [x, y] = self.pixel.unwrap_or_default();
        let pixel = |id| Message::new(id).with("x", x).with("y", y);
        match *event {
            Event::Triangle { .. } => Message::new("msaa-triangle").with("object", self.name()),
            Event::ZeroArea => Message::new("msaa-zero-area").with("object", self.name()),
            Event::Pixel { .. } => pixel("msaa-pixel"),
            Event::Sample { index, covered, tie } => {
                let id = match (covered, tie) {
                    (true, false) => "msaa-sample-in",
                    (false, false) => "msaa-sample-out",
                    (true, true) => "msaa-sample-tie-in",
                    (false, true) => "msaa-sample-tie-out",
                };
                let at = self.sample_point([x, y], index.into());
                Message::new(id).with("sample", u32::from(index)).with("at", at)
            }
            Event::Mask { mask: 0 } => pixel("msaa-mask-none"),
            Event::Mask { mask } => pixel("msaa-mask")
                .with("inside", mask.count_ones())
                .with("count", self.conventions.samples.count()),
            Event::Shade { shading, at, code, mask } => {
                let id = match (shading, at) {
                    (_, None) if !self.is_centre_inside() => "msaa-shade-outside",
                    (_, None) => "msaa-shade-centre",
                    (Shading::PerSample, _) => "msaa-shade-sample",
                    _ => "msaa-shade-centroid",
                };
                Message::new(id)
                    .with("sample", at.map_or(0, u32::from))
                    .with("code", u32::from(code))
                    .with("inside", mask.count_ones())
            }
            Event::Resolve { code, .. } => pixel("msaa-resolve").with("code", u32::from(code)),
            Event::Done => {
                let [shades, tested, inside] = self.counts;
                let count = |n: u64| Value::Int(i64::try_from(n).unwrap_or(i64::MAX));
                Message::new("msaa-done")
                    .with("shades", count(shades))
                    .with("tested", count(tested))
                    .with("inside", count(inside))
            }
        }
    }

    fn formulas(&self, event: &Event, out: &mut Vec<Formula>) {
        if let (Event::Resolve { code, .. }, Some(pixel)) = (event, self.pixel) {
            let count = self.conventions.samples.count();
            let codes = &self.image.samples[self.image.index(pixel)][..count as usize];
            let mut numbers = Vec::new();
            for (i, code) in codes.iter().enumerate() {
                numbers.push(Piece::Text(if i == 0 { "⌊(" } else { " + " }));
                numbers.push(Piece::Number(u32::from(*code).into()));
            }
            numbers.extend([
                Piece::Text(") / "),
                Piece::Number(count.into()),
                Piece::Text(" + ½⌋ = "),
                Piece::Result(u32::from(*code).into()),
            ]);
            out.push(Formula { general: "code = ⌊mean of the samples + ½⌋", numbers });
        }
    }

    fn tables(&self, out: &mut Vec<Table>) {
        if let Some(pixel) = self.pixel {
            out.push(self.samples_table(pixel));
        }
        let counts = self.counts.map(|n| Value::Int(i64::try_from(n).unwrap_or(i64::MAX)));
        let [shades, tested, inside] = counts;
        out.push(Table {
            title: "msaa-counts",
            columns: vec!["column-shades", "column-tested", "column-inside"],
            rows: vec![Row::new("row-sum", vec![shades, tested, inside])],
        });
    }

    fn marks(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        self.draw(event, out);
    }

    fn view(&self) -> View {
        let points: Vec<_> = self.triangles.iter().map(|triangle| triangle.map(|[x, y, _]| [x, y])).collect();
        view_of(&points, &self.conventions.raster)
    }

    fn facts(&self, out: &mut Vec<Fact>) {
        let [width, height] = self.image.size;
        for pixel in (0..height).flat_map(|y| (0..width).map(move |x| [x, y])) {
            let index = self.image.index(pixel);
            if index < self.resolved && self.image.masks[index] != 0 {
                let code = u32::from(self.image.codes[index]);
                out.push(Fact::pixel(pixel, vec![("column-code", code.into())]));
            }
        }
    }
}

impl Snapshot {
    /// Whether the centre of the pixel in hand lies inside the triangle being drawn.
    fn is_centre_inside(&self) -> bool {
        let centre = self.pixel.map(|[x, y]| [x as f32 + 0.5, y as f32 + 0.5]);
        let values = centre.and_then(|centre| self.edge_values(self.triangle? as usize, centre));
        values.is_none_or(|values| values.iter().all(|value| *value >= 0.0))
    }

    /// The samples of a pixel: edge values while a triangle is drawn, then what is stored.
    fn samples_table(&self, pixel: [u32; 2]) -> Table {
        let index = self.image.index(pixel);
        let count = self.conventions.samples.count() as usize;
        let last = self.verdicts.iter().rposition(Option::is_some);
        let rows = (0..count).map(|sample| {
            let known = self.verdicts[sample];
            let values = self
                .triangle
                .filter(|_| known.is_some())
                .and_then(|index| self.edge_values(index as usize, self.sample_point(pixel, sample)));
            let mut cells = values.map_or_else(|| vec![Value::None; 3], |e| e.map(Value::from).to_vec());
            cells.push(u32::from(self.image.samples[index][sample]).into());
            let role = known.map(|(covered, tie)| match (covered, tie) {
                (true, false) => Role::Accepted,
                (false, false) => Role::Rejected,
                (_, true) => Role::Tie,
            });
            Row::new(sample.to_string(), cells).role(role).active(last == Some(sample))
        });
        let columns = vec!["E0", "E1", "E2", "column-code"];
        Table { title: "msaa-samples", columns, rows: rows.collect() }
    }
}
