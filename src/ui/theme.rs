//! The look of the window: the figure crate's tokens as egui knows them, fonts and sizes.
//!
//! The only file of this crate that makes a colour or names a font size; a test greps that.

use egui::{
    Color32, Context, CornerRadius, FontData, FontDefinitions, FontFamily, FontId, Margin, Shadow, Stroke,
    Style, TextStyle, Visuals, style::ScrollAnimation, vec2,
};
use rasterscope_core::explain::Role;
use rasterscope_figure::{
    figure::Font,
    text,
    theme::{Color, Theme, ThemeName},
};
use std::sync::Arc;

/// A theme ready to paint with.
#[derive(Clone, Debug)]
pub(crate) struct Look {
    /// The figure crate's tokens.
    pub(crate) theme: &'static Theme,
    /// Under every drawing.
    pub(crate) canvas: Color32,
    /// Ribbon, side panels, timeline.
    pub(crate) panel: Color32,
    /// Buttons, text fields, combos.
    pub(crate) field: Color32,
    /// Selected chip, preset row, pressed toggle.
    pub(crate) raised: Color32,
    /// 1 px between panels.
    pub(crate) line: Color32,
    /// Outline of toggles, done part of the scrub bar.
    pub(crate) edge: Color32,
    /// Text.
    pub(crate) text: Color32,
    /// Secondary text, units, headings of columns.
    pub(crate) dim: Color32,
    /// Switched off; on panels `dim` stands in for it.
    pub(crate) faint: Color32,
    /// Background of the current line or row.
    pub(crate) lit: Color32,
    /// The highlighter itself: playhead and current chip.
    pub(crate) now: Color32,
    /// Background of a row whose values changed.
    pub(crate) changed_bg: Color32,
    /// The ring round what has the keyboard.
    pub(crate) focus: Color32,
}

/// A text style of LOOK's table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Text {
    /// What is said first in the inspector.
    Headline,
    /// Title of a panel.
    Title,
    /// The sentence of a step.
    Sentence,
    /// What a sentence is about.
    SentenceStrong,
    /// Body and tabs.
    Body,
    /// Body that stands out.
    Strong,
    /// Labels, presets, buttons.
    Label,
    /// A heading above labels, the chosen preset.
    LabelStrong,
    /// Numbers in tables and formulas.
    Mono,
    /// Results.
    MonoStrong,
    /// The pseudocode.
    Listing,
    /// The step counter.
    Counter,
    /// The count of a stage in the tall ribbon.
    Count,
    /// The smallest allowed.
    Small,
    /// Numbers where many have to stand side by side.
    SmallMono,
}

impl Look {
    /// The look of one theme.
    pub(crate) fn new(name: ThemeName) -> Self {
        let theme = name.theme();
        let dark = name == ThemeName::Dark;
        Self {
            theme,
            canvas: color(theme.canvas),
            panel: color(theme.panel),
            field: color(theme.field),
            raised: color(theme.raised),
            line: color(theme.line),
            edge: color(theme.edge),
            text: color(theme.text),
            dim: color(theme.dim),
            faint: color(if name == ThemeName::Projector { theme.dim } else { theme.faint }),
            lit: color(theme.lit),
            now: if dark { color(theme.style(Role::Active).color) } else { color(theme.lit) },
            changed_bg: color(theme.changed_bg),
            focus: color(theme.focus),
        }
    }

    /// Whether sizes are those of a hall.
    pub(crate) fn projector(&self) -> bool {
        self.theme.name == ThemeName::Projector
    }

    /// The icon of a button that cannot be pressed.
    pub(crate) fn disabled(&self) -> Color32 {
        color(if self.projector() { self.theme.grid } else { self.theme.faint })
    }

    /// The colour of a role.
    pub(crate) fn role(&self, role: Role) -> Color32 {
        color(self.theme.style(role).color)
    }

    /// The font of a style.
    pub(crate) fn font(&self, text: Text) -> FontId {
        let sizes = &self.theme.sizes;
        let (size, font) = match text {
            Text::Headline => (sizes.headline, Font::SansBold),
            Text::Title => (sizes.title, Font::SansBold),
            Text::Sentence => (sizes.sentence, Font::Sans),
            Text::SentenceStrong => (sizes.sentence, Font::SansBold),
            Text::Body => (sizes.body, Font::Sans),
            Text::Strong => (sizes.body, Font::SansBold),
            Text::Label => (sizes.label, Font::Sans),
            Text::LabelStrong => (sizes.label, Font::SansBold),
            Text::Mono => (sizes.mono, Font::Mono),
            Text::MonoStrong => (sizes.mono, Font::MonoBold),
            Text::Listing => (sizes.listing, Font::Mono),
            Text::Counter => (sizes.counter, Font::MonoBold),
            Text::Count => (sizes.sentence, Font::SansBold),
            Text::Small => (sizes.smallest, Font::Sans),
            Text::SmallMono => (sizes.smallest, Font::Mono),
        };
        FontId::new(size, family(font))
    }

    /// The height of one line of a style.
    pub(crate) fn line_height(&self, text: Text) -> f32 {
        let sizes = &self.theme.sizes;
        match text {
            Text::Sentence | Text::Count => sizes.sentence_line,
            Text::Mono | Text::MonoStrong => sizes.mono_line,
            Text::Listing => sizes.listing_line,
            _ => (self.font(text).size * 1.35).round(),
        }
    }

    /// Buttons, combos and fields are this high.
    pub(crate) fn button_height(&self) -> f32 {
        if self.projector() { 36.0 } else { 26.0 }
    }

    /// Rows of presets.
    pub(crate) fn row_height(&self) -> f32 {
        if self.projector() { 34.0 } else { 25.0 }
    }

    /// A stroke, one wider on a projector.
    pub(crate) fn stroke(&self, width: f32, color: Color32) -> Stroke {
        Stroke::new(width + self.theme.extra_stroke, color)
    }

    /// The ring round what has the keyboard.
    pub(crate) fn focus_stroke(&self) -> Stroke {
        self.stroke(2.0, self.focus)
    }

    /// Makes egui wear this look. Call when the theme changes.
    pub(crate) fn apply(&self, ctx: &Context) {
        let theme = if self.theme.name == ThemeName::Dark { egui::Theme::Dark } else { egui::Theme::Light };
        ctx.set_theme(theme);
        ctx.all_styles_mut(|style| self.style(style));
    }

    fn style(&self, style: &mut Style) {
        let height = self.button_height();
        style.text_styles = [
            (TextStyle::Heading, Text::Title),
            (TextStyle::Body, Text::Body),
            (TextStyle::Button, Text::Label),
            (TextStyle::Monospace, Text::Mono),
            (TextStyle::Small, Text::Small),
            (small_mono(), Text::SmallMono),
        ]
        .map(|(name, text)| (name, self.font(text)))
        .into();
        style.drag_value_text_style = TextStyle::Monospace;
        style.visuals = self.visuals();
        let spacing = &mut style.spacing;
        spacing.item_spacing = vec2(8.0, 4.0);
        spacing.button_padding = vec2(8.0, 4.0);
        spacing.interact_size.y = height;
        spacing.icon_width = 16.0;
        spacing.menu_margin = Margin::same(6);
        spacing.scroll.floating = false;
        spacing.scroll.bar_width = 8.0;
        spacing.scroll.foreground_color = false;
        style.animation_time = 0.0;
        style.scroll_animation = ScrollAnimation::none();
        style.interaction.selectable_labels = false;
        style.interaction.interact_radius = 3.0;
        style.explanation_tooltips = false;
    }

    fn visuals(&self) -> Visuals {
        let dark = self.theme.name == ThemeName::Dark;
        let mut visuals = if dark { Visuals::dark() } else { Visuals::light() };
        let radius = CornerRadius::same(4);
        let mut wear = |of: fn(&mut Visuals) -> &mut egui::style::WidgetVisuals, fill, stroke| {
            let widget = of(&mut visuals);
            widget.bg_fill = fill;
            widget.weak_bg_fill = fill;
            widget.bg_stroke = stroke;
            widget.fg_stroke = Stroke::new(1.5, self.text);
            widget.corner_radius = radius;
            widget.expansion = 0.0;
        };
        wear(|v| &mut v.widgets.noninteractive, self.panel, Stroke::new(1.0, self.line));
        wear(|v| &mut v.widgets.inactive, self.field, Stroke::new(1.0, self.line));
        wear(|v| &mut v.widgets.hovered, self.raised, Stroke::new(1.0, self.edge));
        wear(|v| &mut v.widgets.open, self.raised, Stroke::new(1.0, self.edge));
        wear(|v| &mut v.widgets.active, self.raised, self.focus_stroke());
        visuals.panel_fill = self.panel;
        visuals.window_fill = self.panel;
        visuals.extreme_bg_color = self.field;
        visuals.text_edit_bg_color = Some(self.field);
        visuals.code_bg_color = self.canvas;
        visuals.faint_bg_color = self.panel;
        visuals.weak_text_color = Some(self.dim);
        visuals.override_text_color = None;
        visuals.selection.bg_fill = self.raised;
        visuals.selection.stroke = Stroke::new(1.5, self.text);
        visuals.hyperlink_color = self.role(Role::Accepted);
        visuals.warn_fg_color = self.role(Role::Rejected);
        visuals.error_fg_color = self.role(Role::Rejected);
        visuals.window_shadow = Shadow::NONE;
        visuals.popup_shadow = Shadow::NONE;
        visuals.window_stroke = Stroke::new(1.0, self.line);
        visuals.window_corner_radius = CornerRadius::same(6);
        visuals.menu_corner_radius = CornerRadius::same(6);
        visuals.striped = false;
        visuals.slider_trailing_fill = true;
        visuals.text_cursor.blink = false;
        visuals.text_cursor.stroke = Stroke::new(2.0, self.text);
        visuals
    }
}

/// The name under which egui knows [`Text::SmallMono`].
pub(crate) fn small_mono() -> TextStyle {
    TextStyle::Name("small-mono".into())
}

/// The family that holds one of the figure crate's fonts.
pub(crate) fn family(font: Font) -> FontFamily {
    match font {
        Font::Sans => FontFamily::Proportional,
        Font::SansBold => FontFamily::Name("semibold".into()),
        Font::Mono => FontFamily::Monospace,
        Font::MonoBold => FontFamily::Name("mono-semibold".into()),
    }
}

/// The fonts of the figure crate; the mono font is the last fallback of every family.
pub(crate) fn fonts() -> FontDefinitions {
    let mut fonts = FontDefinitions::empty();
    for font in Font::ALL {
        fonts.font_data.insert(format!("{font:?}"), Arc::new(FontData::from_static(text::data(font))));
        let fallback =
            if matches!(font, Font::SansBold | Font::MonoBold) { Font::MonoBold } else { Font::Mono };
        let names = [font, fallback].map(|font| format!("{font:?}"));
        fonts.families.insert(family(font), names.into());
    }
    fonts
}

/// A colour of the figure crate as egui's.
pub(crate) fn color(Color([r, g, b, a]): Color) -> Color32 {
    Color32::from_rgba_unmultiplied(r, g, b, a)
}

/// A colour of the image: its codes as they are stored.
pub(crate) fn code([r, g, b, _]: [u8; 4]) -> Color32 {
    Color32::from_rgb(r, g, b)
}
