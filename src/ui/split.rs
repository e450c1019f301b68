//! The split view: two drawings of one input, one camera, one cursor.

use crate::{
    app::App,
    document::{Document, Tab},
    face::Face,
    labs::Open,
    shell::{
        Frame,
        canvas::{Compared, Drawing, Maker},
        split::{self, Sides},
    },
};
use egui::{Id, Rect, Stroke, Ui, UiBuilder, pos2};
use rasterscope_core::{
    compare::{Difference, Fact, Pair, Side, side_b},
    explain::View,
};
use rasterscope_figure::{
    figure::Figure,
    split::{FOOT, HEADER, Pane, beside, counts, joined, stand_beside},
};

impl App {
    /// Whether two sides are asked for.
    pub(crate) fn split(&self) -> bool {
        self.document.scene.compared().is_some()
    }

    /// What can be dragged on either canvas, as of the last frame.
    pub(crate) fn handles(&self) -> Vec<Id> {
        let beside = if self.split() { self.beside.handles() } else { &[] };
        [self.canvas.handles(), beside].concat()
    }

    /// Where the window comes to show two sides, or one again, the drawing fits anew and a tab that
    /// is there is chosen.
    pub(crate) fn lay_out_sides(&mut self) {
        let split = self.split();
        if std::mem::replace(&mut self.view.split, split) == split {
            return;
        }
        self.canvas.fit();
        self.view.choices = false;
        self.view.part = None;
        self.run.explain(Side::A);
        if split {
            self.view.tab = Tab::Difference;
        } else if self.view.tab == Tab::Difference {
            self.view.tab = Tab::Step;
        }
    }

    /// The setting in which the two sides differ, if there are two.
    pub(crate) fn sides(&self) -> Option<Sides> {
        let scene = &self.document.scene;
        let setting = scene.compared()?;
        let all = setting.values(scene).into_iter();
        Some(Sides {
            name: self.words.word(setting.word()),
            own: [setting.of(scene), Some(setting)],
            all: all.map(|setting| (setting, self.words.value(&setting.value()))).collect(),
        })
    }

    /// Both sides with what stands round them; drags on either edit the document.
    pub(crate) fn split_panel(&mut self, ui: &mut Ui, face: &Face<'_>, frame: &Frame<'_>, lab: usize) {
        let rect = ui.max_rect();
        let (Some(sides), Some(setting), Some(scene)) =
            (&frame.compare, self.document.scene.compared(), side_b(&self.document.scene))
        else {
            return;
        };
        let Some(shown_a) = self.run.shown_of(Side::A) else {
            return split::problem(ui, face, rect, frame.problem.as_deref().unwrap_or_default());
        };
        let shown_b = self.run.shown_of(Side::B);
        let [left, right] = halves(rect);
        for (side, pane, shown) in [(Side::A, left, Some(shown_a)), (Side::B, right, shown_b)] {
            split::header(ui, face, pane.with_max_y(pane.top() + HEADER), side, sides, shown);
            if let Some(shown) = shown {
                split::foot(ui, face, pane.with_min_y(pane.bottom() - FOOT), shown);
            }
        }
        let views = [Some(shown_a), shown_b].map(|shown| shown.map_or(shown_a.view, |shown| shown.view));
        let views = joined(views);
        let pair = self.run.pair();
        let part = pair.zip(self.view.part.clone().or_else(|| first(pair))).map(|(pair, of)| pair.part(&of));
        let part = part.map(|part| [part.a.or(part.b), part.b.or(part.a)]);

        let body = |pane: Rect| {
            Rect::from_min_max(pane.min + egui::vec2(0.0, HEADER), pane.max - egui::vec2(0.0, FOOT))
        };
        let drawing = |side: Side, shown| {
            drawing(shown, &views[side as usize], pair, side, part.and_then(|part| part[side as usize]))
        };
        let mut open =
            Open { lab: self.labs[lab].as_ref(), document: &mut self.document, view: &mut self.view };
        let (canvas, textures) = (&mut self.canvas, &mut self.textures);
        let hover = self.run.hover(Side::A, canvas.hovered, face.words);
        inside(ui, body(left), "side A", |ui| {
            canvas.show(ui, face, textures, drawing(Side::A, shown_a), &mut open, hover.as_ref());
        });
        let x = ui.painter().round_to_pixel_center(left.right());
        ui.painter().vline(x, rect.y_range(), Stroke::new(1.0, face.look.line));
        let (Some(shown_b), Some(at)) = (shown_b, self.canvas.placement()) else {
            let problem = self.problem_of(Side::B).unwrap_or_default();
            return split::problem(ui, face, body(right), &problem);
        };

        let mut other = Document::new(scene);
        let before = other.clone();
        let name = other.input().name();
        let lab = self.labs.iter().find(|lab| lab.name() == name).unwrap_or(&self.labs[lab]);
        let placed = stand_beside(at, views[0], views[1]);
        self.beside.follow(&self.canvas, placed, views[1], body(right).size());
        let mut open = Open { lab: lab.as_ref(), document: &mut other, view: &mut self.view };
        let (canvas, textures) = (&mut self.beside, &mut self.textures);
        let hover = self.run.hover(Side::B, canvas.hovered, face.words);
        inside(ui, body(right), "side B", |ui| {
            canvas.show(ui, face, textures, drawing(Side::B, shown_b), &mut open, hover.as_ref());
        });
        if let Some(now) = self.beside.placement().filter(|now| *now != placed) {
            self.canvas.moved_to(stand_beside(now, views[1], views[0]));
            ui.ctx().request_repaint();
        }
        if other.scene != before.scene {
            setting.restore(&mut other.scene, &self.document.scene);
            self.document.scene = other.scene;
        }
    }

    /// Both drawings as one figure, as they stand in the window.
    pub(crate) fn split_figure(&self) -> Option<Figure> {
        let sides = self.sides()?;
        let pane = |side: Side| {
            let canvas = if side == Side::A { &self.canvas } else { &self.beside };
            let shown = self.run.shown_of(side)?;
            Some(Pane {
                side,
                setting: [sides.name.clone(), sides.value(side).to_owned()],
                counts: shown.operations.map_or_else(String::new, |[so_far, _]| counts(&self.words, so_far)),
                sentence: self.words.message(&shown.sentence),
                drawing: canvas.last_figure()?.clone(),
            })
        };
        Some(beside([pane(Side::A)?, pane(Side::B)?], self.look.theme))
    }
}

/// Two panes of equal width with a line between them.
fn halves(rect: Rect) -> [Rect; 2] {
    let width = ((rect.width() - 1.0) / 2.0).floor();
    [
        rect.with_max_x(rect.left() + width),
        Rect::from_min_max(pos2(rect.right() - width, rect.top()), rect.max),
    ]
}

/// Content that keeps to its place and has ids of its own.
fn inside(ui: &mut Ui, rect: Rect, name: &str, content: impl FnOnce(&mut Ui)) {
    ui.scope_builder(UiBuilder::new().id_salt(name).max_rect(rect), |ui| {
        ui.set_clip_rect(rect);
        content(ui);
    });
}

/// The part that is explained until one is chosen.
fn first(pair: Option<&Pair>) -> Option<Fact> {
    pair?.difference().parts().next()?.either().cloned()
}

/// A side as the canvas draws it; what differs shows once both are done.
fn drawing<'a>(
    shown: &'a crate::run::Shown,
    view: &'a View,
    pair: Option<&'a Pair>,
    side: Side,
    chosen: Option<&'a Fact>,
) -> Drawing<'a> {
    let done = shown.cursor == shown.len;
    let difference: Option<&Difference> = pair.filter(|_| done).map(Pair::difference);
    let facts = pair.map_or(&[][..], |pair| pair.facts(side));
    let compared = Some(Compared { side, facts, difference, chosen: chosen.filter(|_| done) });
    let vantage = shown.vantage.as_ref();
    Drawing { marks: &shown.marks, view, vantage, rev: (Maker::Run, shown.rev), compared, chosen: None }
}
