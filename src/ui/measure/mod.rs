//! Measuring: run time against error, the lectures' claims, how cost grows; one page each.
//!
//! A page lies over ribbon, choices, canvas and timeline, for it is about algorithms, not about the document.
//! Nothing is measured until somebody asks for it; the work is done beside the window, and what is there
//! already is shown. The diagram on the screen and in the file is one [`Figure`].

mod page;
mod save;
mod side;
mod table;
mod work;

pub(crate) use page::show;
pub(crate) use save::{Format, write};
pub(crate) use work::Scope;

use crate::app::App;
use egui::Context;
use rasterscope_core::{memo::Memo, stress::Family};
use rasterscope_figure::{
    figure::Figure,
    plot::{self, Drawn},
    theme::ThemeName,
    words::Words,
};
use rasterscope_measure::{
    Machine, ROUNDS,
    claims::{CLAIMS, Finding},
    growth::{Frame, Growing},
    pictures::{self, Chart, ErrorKind, Filter},
    race::{Row, STAGES, Stage},
};
use std::rc::Rc;
use work::Work;

/// A page.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Page {
    /// Run time against error.
    Errors,
    /// The claims of the lectures.
    Claims,
    /// How cost grows.
    Growth,
}

impl Page {
    /// Every page.
    pub(crate) const ALL: [Self; 3] = [Self::Errors, Self::Claims, Self::Growth];

    /// The message that names it.
    pub(crate) fn word(self) -> &'static str {
        match self {
            Self::Errors => "measure-errors",
            Self::Claims => "measure-claims",
            Self::Growth => "measure-growth",
        }
    }
}

/// What is shown of the results.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Shown {
    page: Page,
    /// Index of the operation.
    stage: usize,
    family: Option<Family>,
    error: ErrorKind,
    /// Index of the claim.
    claim: usize,
    growing: Growing,
}

impl Shown {
    fn stage(&self) -> &'static Stage {
        &STAGES[self.stage]
    }

    fn filter(&self) -> Filter {
        Filter { stage: self.stage(), family: self.family, error: self.error }
    }
}

/// The pages and the results.
#[derive(Debug)]
pub(crate) struct Measure {
    /// Whether a page is open.
    pub(crate) open: bool,
    shown: Shown,
    /// How often everything runs.
    pub(crate) rounds: u32,
    rows: Vec<Row>,
    findings: Vec<Option<Finding>>,
    frames: Vec<Frame>,
    /// Moves with the results.
    rev: u64,
    machine: Option<Machine>,
    work: Option<Work>,
    /// The point that was clicked, and the one under the pointer.
    chosen: Option<[usize; 2]>,
    hovered: Option<[usize; 2]>,
    chart: Memo<(Shown, u64), Option<Rc<Chart>>>,
    drawn: Memo<DrawnKey, Rc<Drawn>>,
    /// Whether what was drawn last is what is open.
    is_drawn: bool,
}

/// What a drawing depends on.
type DrawnKey = ((Shown, u64), [f32; 2], ThemeName, Option<[usize; 2]>);

impl Default for Measure {
    fn default() -> Self {
        Self {
            open: false,
            shown: Shown {
                page: Page::Errors,
                stage: 0,
                family: Some(Family::Ordinary),
                error: ErrorKind::default(),
                claim: 0,
                growing: Growing::Triangles,
            },
            rounds: ROUNDS,
            rows: Vec::new(),
            findings: vec![None; CLAIMS.len()],
            frames: Vec::new(),
            rev: 0,
            machine: None,
            work: None,
            chosen: None,
            hovered: None,
            chart: Memo::default(),
            drawn: Memo::default(),
            is_drawn: false,
        }
    }
}

impl Measure {
    /// Opens a page.
    pub(crate) fn open(&mut self, page: Page) {
        self.open = true;
        self.shown.page = page;
        self.chosen = None;
        self.hovered = None;
    }

    /// The page that is open.
    pub(crate) fn page(&self) -> Option<Page> {
        self.open.then_some(self.shown.page)
    }

    /// What is shown as a diagram; `None` if nothing of it was measured.
    fn chart(&mut self, words: &Words) -> Option<Rc<Chart>> {
        let Self { shown, rounds, rows, findings, frames, rev, machine, chart, .. } = self;
        let machine = machine.as_ref()?;
        let made = chart.get((*shown, *rev), |_| {
            let chart = match shown.page {
                Page::Errors => pictures::errors(rows, &shown.filter(), machine, *rounds, words),
                Page::Growth => pictures::growth(frames, shown.growing, machine, *rounds, words),
                Page::Claims => {
                    let finding = findings[shown.claim].as_ref()?;
                    pictures::claim(&CLAIMS[shown.claim], finding, machine, *rounds, words)
                }
            };
            let has_points = chart.plot.series.iter().any(|series| !series.points.is_empty());
            has_points.then(|| Rc::new(chart))
        });
        made.clone()
    }

    /// The diagram laid out.
    fn drawn(&mut self, size: [f32; 2], theme: ThemeName, words: &Words) -> Option<Rc<Drawn>> {
        let chart = self.chart(words);
        self.is_drawn = chart.is_some();
        let chart = chart?;
        let lit = self.hovered.or(self.chosen);
        let key = ((self.shown, self.rev), size, theme, lit);
        let drawn = self.drawn.get(key, |_| Rc::new(plot::draw(&chart.plot, size, theme.theme(), lit)));
        Some(Rc::clone(drawn))
    }

    /// The diagram as it was drawn last.
    fn figure(&self) -> Option<&Figure> {
        self.drawn.last().filter(|_| self.is_drawn).map(|drawn| &drawn.figure)
    }

    /// The result behind a point.
    fn row(&mut self, point: [usize; 2], words: &Words) -> Option<&Row> {
        let chart = self.chart(words)?;
        self.rows.get(*chart.results.get(point[0])?.get(point[1])?)
    }
}

impl App {
    /// Takes what was measured since the last frame, and asks for the next look.
    pub(crate) fn end_measuring(&mut self, ctx: &Context) {
        let now = ctx.input(|input| input.time);
        if let Some(problem) = self.measure.take(ctx, now) {
            self.notice = Some(crate::shell::notice::Notice::Failed(self.words.word(problem)));
        }
    }
}
