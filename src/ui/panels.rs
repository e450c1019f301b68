//! Where each panel stands in the window.

use crate::{
    app::App,
    document::Tab,
    face::{Command, Face},
    labs::Open,
    measure,
    shell::{
        self, Frame, NARROW,
        canvas::{Drawing, Maker},
        choices, header, hints,
        inspector::{self, Digest, Whole},
        keys, menu, notice, palette,
        ribbon::{self, Chip, Shape},
        timeline,
    },
    theme::Text,
    widgets::rule,
};
use egui::{Align2, CentralPanel, Color32, Margin, Panel, Rect, Ui, UiBuilder, vec2};
use rasterscope_core::{
    compare::{self, Side},
    labs as core_labs,
    message::Message,
};
use rasterscope_figure::numbers;
use std::{cell::RefCell, rc::Rc};

/// Width of the choices where they are a panel, and on a projector.
const CHOICES: [f32; 2] = [228.0, 280.0];
/// Widths of the choices and the inspector in a wide window, where the canvas has enough all the same.
const WIDE: [f32; 2] = [300.0, 480.0];
/// Width of the inspector from which on the listing stands beside the step.
const BESIDE: f32 = 640.0;
/// Width of the choices where they lie over the canvas.
const DRAWER: [f32; 2] = [260.0, 320.0];

impl App {
    /// Shows every panel of one frame.
    pub(crate) fn panels(&mut self, ui: &mut Ui, commands: &RefCell<Vec<Command>>) {
        let (look, words) = (Rc::clone(&self.look), Rc::clone(&self.words));
        let links = std::mem::take(&mut self.links);
        let face = Face { look: &look, words: &words, commands, links: &links, exact: self.view.aids.exact };
        let whole = ui.max_rect().width();
        let narrow = whole < NARROW;
        let presets = std::mem::take(&mut self.presets);
        let lab = self.lab();
        let name = self.labs[lab].name();
        let stage = core_labs::find(name).map_or(core_labs::Stage::Image, |lab| lab.stage);
        let frame = Frame {
            theme: self.view.theme,
            aids: self.view.aids,
            can_undo: self.history.can_undo(),
            can_redo: self.history.can_redo(),
            folded: (narrow || self.split()) && !self.measure.open,
            compare: self.sides(),
            settings: match &self.view.palette {
                Some(_) => compare::settings(&self.document.scene),
                None => Vec::new(),
            },
            title: self.words.word(self.measure.page().map_or(name, |_| "measure-title")),
            subtitle: self
                .measure
                .page()
                .map_or_else(|| self.subtitle(), |page| self.words.word(page.word())),
            modified: self.modified() && !self.measure.open,
            about: self.words.word(&format!("{name}-about")),
            lab: name,
            preset: self
                .preset
                .as_ref()
                .filter(|(_, scene)| *scene == self.document.scene)
                .map(|(name, _)| *name),
            presets: &presets,
            note: self.names.text(&self.words, &self.document.scene.note),
            problem: self.problem(),
        };
        let plain = |fill: Color32, margin: Margin| egui::Frame::NONE.fill(fill).inner_margin(margin);

        Panel::top("menu")
            .exact_size(36.0)
            .resizable(false)
            .show_separator_line(false)
            .frame(plain(look.panel, Margin::symmetric(14, 0)))
            .show(ui, |ui| menu::show(ui, &face, &frame));
        if self.measure.open {
            self.notice_panel(ui, &face);
            let now = ui.ctx().input(|input| input.time);
            measure::show(ui, &face, &mut self.measure, &mut self.textures, now);
            self.over(ui, &face, &frame);
            self.presets = presets;
            self.links = links;
            return;
        }
        let shape = match (narrow, name) {
            (true, _) => Shape::Path,
            (_, "pipeline") if frame.compare.is_none() => Shape::Tall,
            _ => Shape::Flat,
        };
        let chips = self.overview.chips(self.view.theme, &words);
        let chips = self.chips(chips, lab, stage);
        Panel::top("ribbon")
            .exact_size(shape.height())
            .resizable(false)
            .frame(plain(look.panel, Margin::ZERO))
            .show(ui, |ui| ribbon::show(ui, &face, &mut self.textures, shape, &chips, stage));
        self.notice_panel(ui, &face);
        let busy = self.busy(ui.ctx());
        Panel::bottom("timeline")
            .exact_size(if look.projector() { 76.0 } else { 64.0 })
            .resizable(false)
            .frame(plain(look.panel, Margin::ZERO))
            .show(ui, |ui| timeline::show(ui, &face, self.run.shown(), &self.view, busy.as_ref()));
        if !frame.folded {
            Panel::left("choices")
                .exact_size(if whole < shell::WIDE {
                    CHOICES[usize::from(look.projector())]
                } else {
                    WIDE[0]
                })
                .resizable(false)
                .frame(plain(look.panel, Margin::symmetric(14, 12)))
                .show(ui, |ui| {
                    choices::show(ui, &face, &frame, &mut self.opened(lab));
                });
        }
        let width = match (narrow, look.projector()) {
            _ if whole >= shell::WIDEST => BESIDE,
            _ if whole >= shell::WIDE => WIDE[1],
            (false, false) if name == "transform" => 400.0,
            (true, true) => 372.0,
            (true, false) => 340.0,
            (false, true) => 400.0,
            (false, false) => 360.0,
        };
        Panel::right("inspector")
            .exact_size(width)
            .resizable(false)
            .frame(plain(look.panel, Margin::ZERO))
            .show(ui, |ui| {
                let shown = self.run.shown();
                let digest = Digest::update(&mut self.digest, shown, &words);
                let history = self.view.pixel.and_then(|pixel| self.overview.history(pixel, &words));
                let stages = (name == "pipeline").then(|| self.overview.table(&words));
                let (pair, side) = (self.run.pair(), self.run.side());
                let costs = Side::ALL.map(|side| self.run.cost(side));
                let decides = self.run.pixel(side, [0, 0]).is_some();
                let report = self.view.pixel.and_then(|pixel| Some((pixel, self.run.pixel(side, pixel)?)));
                let (history, stages) = (history.as_deref(), stages.as_deref());
                let whole = Whole { history, stages, decides, report: report.as_ref(), pair, costs, side };
                inspector::show(ui, &face, &frame, shown, digest, whole, &mut self.view);
            });
        CentralPanel::default().frame(plain(look.canvas, Margin::ZERO)).show(ui, |ui| {
            let mut rect = ui.max_rect();
            if self.view.aids.hints {
                let strip = rect.with_min_y(rect.bottom() - hints::height(&face));
                rule(ui, strip.with_max_y(strip.top()), &look);
                ui.painter().rect_filled(strip, 0, look.panel);
                ui.scope_builder(UiBuilder::new().max_rect(strip), |ui| hints::show(ui, &face));
                rect = rect.with_max_y(strip.top() - 1.0);
            }
            ui.set_clip_rect(rect);
            if frame.compare.is_some() {
                let builder = UiBuilder::new().max_rect(rect);
                ui.scope_builder(builder, |ui| self.split_panel(ui, &face, &frame, lab));
            } else if name == "pipeline" {
                let head = rect.with_max_y(rect.top() + 42.0);
                header::show(ui, &face, head, &self.document.scene, &mut self.view);
                let body = rect.with_min_y(head.bottom());
                let builder = UiBuilder::new().max_rect(body);
                ui.scope_builder(builder, |ui| {
                    ui.set_clip_rect(body);
                    self.canvas_panel(ui, &face, &frame, lab);
                });
            } else {
                let builder = UiBuilder::new().max_rect(rect);
                ui.scope_builder(builder, |ui| self.canvas_panel(ui, &face, &frame, lab));
            }
            if frame.folded && self.view.choices {
                self.drawer(ui, &face, &frame, lab, rect);
            }
        });
        self.over(ui, &face, &frame);
        self.presets = presets;
        self.links = links;
    }

    /// The bar under the ribbon.
    fn notice_panel(&mut self, ui: &mut Ui, face: &Face<'_>) {
        let Some(notice) = &mut self.notice else { return };
        Panel::top("notice")
            .exact_size(notice::height(face))
            .resizable(false)
            .frame(egui::Frame::NONE.fill(face.look.panel))
            .show(ui, |ui| notice::show(ui, face, notice));
    }

    /// What lies over everything: keys and palette.
    fn over(&mut self, ui: &Ui, face: &Face<'_>, frame: &Frame<'_>) {
        if self.view.keys {
            keys::overlay(ui, face);
        }
        if let Some(palette) = &mut self.view.palette {
            palette::show(ui, face, frame, palette);
        }
    }

    /// The chips, with what the open lab does in its own.
    fn chips(&self, of_scene: Rc<[Chip]>, lab: usize, stage: core_labs::Stage) -> Rc<[Chip]> {
        let outcome_of = |side| {
            let shown = self.run.shown_of(side)?;
            self.labs[lab].outcome(&self.document, &shown.markers)
        };
        let Some(outcome) = outcome_of(Side::A) else { return of_scene };
        let empty = self.document.scene.draws.is_empty();
        // A lab that draws more than the scene, such as an outline: what the scene counts does not follow from it.
        let came = self.overview.counted().map(|(stats, _)| stats.stage(stage).came);
        let other = outcome.came.zip(came).is_some_and(|(lab, scene)| lab as u64 != scene);
        let fragments = core_labs::Stage::ScanConversion..;
        let beside = outcome_of(Side::B);
        let count = match &beside {
            Some(beside) => format!("{} | {}", outcome.went, beside.went),
            None => outcome.count(),
        };
        let went = beside.map_or(outcome.went, |beside| outcome.went.max(beside.went));
        let unit = |id, count: usize| self.words.message(&Message::new(id).with("count", count));
        let mut chips = of_scene.to_vec();
        for chip in &mut chips {
            if chip.stage == stage {
                chip.count = Some(count.clone());
                chip.unit = outcome.unit.map_or_else(String::new, |id| unit(id, went));
                chip.skipped.clear();
            } else if empty {
                // The lab has an input of its own: nothing comes to any other stage.
                let given = (chip.stage == core_labs::Stage::Scene).then_some(outcome.given);
                chip.count = given.map(|(count, _)| count.to_string());
                chip.unit = given.map_or_else(String::new, |(count, id)| unit(id, count));
            } else if other && fragments.contains(&stage) && fragments.contains(&chip.stage) {
                chip.count = chip.count.is_some().then(|| numbers::UNDEFINED.to_owned());
                (chip.unit, chip.skipped) = Default::default();
            }
        }
        chips.into()
    }

    fn canvas_panel(&mut self, ui: &mut Ui, face: &Face<'_>, frame: &Frame<'_>, lab: usize) {
        let overview =
            frame.lab == "pipeline" && self.run.shown().is_none_or(|shown| shown.cursor == shown.len);
        if self.shows_skips() {
            return self.skips_panel(ui, face);
        }
        let picture = if overview { self.overview.picture(&mut self.view) } else { None };
        let drawing = match (&picture, self.run.shown()) {
            (Some(picture), _) => Some(Drawing {
                marks: &picture.marks,
                view: &picture.view,
                vantage: None,
                rev: (picture.maker, picture.rev),
                compared: None,
                chosen: None,
            }),
            (None, Some(shown)) => Some(Drawing {
                marks: &shown.marks,
                view: &shown.view,
                vantage: shown.vantage.as_ref(),
                rev: (Maker::Run, shown.rev),
                compared: None,
                chosen: self.view.pixel.filter(|pixel| self.run.pixel(Side::A, *pixel).is_some()),
            }),
            (None, None) => None,
        };
        let Some(drawing) = drawing else {
            let rect = ui.max_rect().shrink(40.0);
            let text = frame.problem.clone().unwrap_or_else(|| face.say("ui-canvas-empty"));
            let font = face.look.font(Text::Sentence);
            let galley = ui.painter().layout(text, font, face.look.dim, rect.width());
            let at = Align2::CENTER_CENTER.align_size_within_rect(galley.size(), rect).min;
            ui.painter().galley(at, galley, face.look.dim);
            return;
        };
        let mut open =
            Open { lab: self.labs[lab].as_ref(), document: &mut self.document, view: &mut self.view };
        let before = open.view.pixel;
        let hovered = self.canvas.hovered;
        if overview {
            let hover = hovered.and_then(|pixel| self.overview.hover(pixel, face.words));
            return self.canvas.show(ui, face, &mut self.textures, drawing, &mut open, hover.as_deref());
        }
        let hover = self.run.hover(Side::A, hovered, face.words);
        self.canvas.show(ui, face, &mut self.textures, drawing, &mut open, hover.as_ref());
        let chosen = open.view.pixel.filter(|_| open.view.pixel != before);
        if chosen.is_some_and(|pixel| self.run.pixel(Side::A, pixel).is_some()) {
            open.view.tab = Tab::Pixel;
        }
    }

    /// The choices over the canvas of a narrow window.
    fn drawer(&mut self, ui: &mut Ui, face: &Face<'_>, frame: &Frame<'_>, lab: usize, rect: Rect) {
        let at =
            Rect::from_min_size(rect.min, vec2(DRAWER[usize::from(face.look.projector())], rect.height()));
        // Takes the clicks that would reach the canvas below.
        ui.interact(at, ui.scope_id().with("drawer"), egui::Sense::click_and_drag());
        ui.painter().rect_filled(at, 0, face.look.panel);
        ui.painter().vline(at.right(), at.y_range(), egui::Stroke::new(1.0, face.look.line));
        ui.scope_builder(UiBuilder::new().max_rect(at.shrink2(vec2(14.0, 12.0))), |ui| {
            choices::show(ui, face, frame, &mut self.opened(lab));
        });
    }

    /// The open lab, to be edited.
    fn opened(&mut self, lab: usize) -> Open<'_> {
        Open { lab: self.labs[lab].as_ref(), document: &mut self.document, view: &mut self.view }
    }

    /// What is open: a file, a preset, or a scene without either.
    pub(crate) fn subtitle(&self) -> String {
        let preset = self.preset.as_ref().and_then(|(name, _)| self.presets.iter().find(|p| p.name == *name));
        match (&self.path, preset) {
            (Some(path), _) => path.rsplit(['/', '\\']).next().unwrap_or(path).to_owned(),
            (None, Some(preset)) => preset.title.clone(),
            (None, None) => self.names.text(&self.words, &self.document.scene.name),
        }
    }
}
