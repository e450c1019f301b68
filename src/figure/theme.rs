//! Colours, strokes, markers and type sizes: the three themes.
//!
//! With the tokens beside it the only place where a colour or a font size stands. Furniture is neutral; saturated colour
//! means a [`Role`], and each role also has a marker and a dash of its own, so that nothing
//! depends on colour alone. In the light themes "now" is ink over a yellow underlay, because no
//! yellow is readable on white. Contrasts are those of WCAG 2 and are tested below.

use rasterscope_core::explain::Role;

use crate::tokens::{DARK, LIGHT, PROJECTOR};

/// A colour: red, green, blue and straight alpha, in sRGB codes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Color(pub [u8; 4]);

impl Color {
    /// An opaque colour from `0xRRGGBB`.
    pub const fn hex(rgb: u32) -> Self {
        let [_, red, green, blue] = rgb.to_be_bytes();
        Self([red, green, blue, 255])
    }

    /// The same colour with `alpha` in 0..=1 of its opacity.
    #[must_use]
    pub fn alpha(self, alpha: f32) -> Self {
        let [red, green, blue, opacity] = self.0;
        Self([red, green, blue, (f32::from(opacity) * alpha.clamp(0.0, 1.0) + 0.5) as u8])
    }

    /// This colour painted over an opaque `ground`.
    #[must_use]
    pub fn over(self, ground: Self) -> Self {
        let alpha = u32::from(self.0[3]);
        let mix = |channel: usize| {
            let sum = u32::from(self.0[channel]) * alpha + u32::from(ground.0[channel]) * (255 - alpha);
            ((sum + 127) / 255) as u8
        };
        Self([mix(0), mix(1), mix(2), 255])
    }

    /// `#RRGGBB`, without alpha.
    pub fn css(self) -> String {
        let [red, green, blue, _] = self.0;
        format!("#{red:02X}{green:02X}{blue:02X}")
    }
}

/// Which theme.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum ThemeName {
    /// For a dark room.
    #[default]
    Dark,
    /// For paper and bright rooms.
    Light,
    /// For a hall: larger, bolder, no faint lines.
    Projector,
}

impl ThemeName {
    /// In the order in which the window cycles through them.
    pub const ALL: [Self; 3] = [Self::Dark, Self::Light, Self::Projector];

    /// The name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Dark => "dark",
            Self::Light => "light",
            Self::Projector => "projector",
        }
    }

    /// The theme of that name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|theme| theme.name() == name)
    }

    /// Message id of its name for people.
    pub fn word(self) -> &'static str {
        match self {
            Self::Dark => "figure-dark",
            Self::Light => "figure-light",
            Self::Projector => "figure-projector",
        }
    }

    /// Its colours and sizes.
    pub fn theme(self) -> &'static Theme {
        match self {
            Self::Dark => &DARK,
            Self::Light => &LIGHT,
            Self::Projector => &PROJECTOR,
        }
    }
}

/// Colours by use, and what else a theme decides.
#[derive(Clone, Debug, PartialEq)]
pub struct Theme {
    /// Which theme it is.
    pub name: ThemeName,
    /// Under every drawing.
    pub canvas: Color,
    /// Ribbon, side panels, timeline.
    pub panel: Color,
    /// Buttons, text fields, combos.
    pub field: Color,
    /// Selected chip, preset row, pressed toggle, set bit.
    pub raised: Color,
    /// One pixel between panels.
    pub line: Color,
    /// Outline of toggles, done part of the scrub bar, frustum.
    pub edge: Color,
    /// Pixel grid.
    pub grid: Color,
    /// Frame of the pixel grid, and every 6th or 10th line.
    pub grid_major: Color,
    /// Text, and outlines of input.
    pub text: Color,
    /// Secondary text, units, headings of columns.
    pub dim: Color,
    /// Switched off, clear value, line numbers; on the canvas only.
    pub faint: Color,
    /// Background of the current line or row; the yellow under the active stroke in light themes.
    pub lit: Color,
    /// Row whose values changed.
    pub changed_bg: Color,
    /// Ring around what has the keyboard focus.
    pub focus: Color,
    /// Fills of triangles A, B, C, D; later objects repeat them with a hatch.
    pub objects: [Color; 4],
    /// How opaque an object's fill is on the canvas.
    pub object_alpha: f32,
    /// Added to the width of every stroke except the grid's.
    pub extra_stroke: f32,
    /// Shades from the weakest to the strongest, with equal steps of lightness.
    pub(crate) heat: [Color; 6],
    /// Sizes of text.
    pub sizes: TypeSizes,
    /// Colours of the roles, in the order of [`Role::ALL`].
    pub(crate) roles: [Color; 10],
}

/// How one role looks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RoleStyle {
    /// Of lines, markers and text.
    pub color: Color,
    /// Width of its lines in points.
    pub width: f32,
    /// Dash of its lines.
    pub dash: &'static [f32],
    /// Its shape where there is no line.
    pub marker: Marker,
    /// How opaque its fill is; 0: none.
    pub fill_alpha: f32,
    /// Whether its areas are hatched.
    pub hatch: bool,
    /// Colour and width of a band under its lines.
    pub underlay: Option<(Color, f32)>,
}

/// The shape of a marker; each role has its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Marker {
    /// Active.
    RingedDot,
    /// Accepted.
    DiscTick,
    /// Rejected.
    Cross,
    /// Candidate.
    Ring,
    /// Changed.
    TriangleUp,
    /// Tie.
    Diamond,
    /// Skipped.
    Bar,
    /// Exact.
    Square,
    /// Taught; hollow.
    TriangleDown,
    /// Input that can be dragged.
    Handle,
}

impl Theme {
    /// How `role` looks in this theme.
    pub fn style(&self, role: Role) -> RoleStyle {
        let (width, dash, marker, fill_alpha): (f32, &'static [f32], Marker, f32) = match role {
            Role::Active => (3.5, &[], Marker::RingedDot, 0.16),
            Role::Accepted => (3.0, &[], Marker::DiscTick, 0.42),
            Role::Rejected => (2.5, &[7.0, 5.0], Marker::Cross, 0.0),
            Role::Candidate => (2.0, &[2.0, 4.0], Marker::Ring, 0.0),
            Role::Changed => (2.5, &[], Marker::TriangleUp, 0.0),
            Role::Tie => (2.5, &[9.0, 4.0, 2.0, 4.0], Marker::Diamond, 0.0),
            Role::Skipped => (2.0, &[1.0, 5.0], Marker::Bar, 0.0),
            Role::Exact => (2.5, &[12.0, 4.0], Marker::Square, 0.0),
            Role::Taught => (1.5, &[12.0, 4.0], Marker::TriangleDown, 0.0),
            Role::Neutral => (2.0, &[], Marker::Handle, 0.0),
        };
        let light = self.name != ThemeName::Dark;
        RoleStyle {
            color: self.roles[Role::ALL.iter().position(|&each| each == role).unwrap_or(0)],
            width: width + self.extra_stroke,
            dash,
            marker,
            fill_alpha,
            hatch: role == Role::Rejected,
            underlay: (role == Role::Active && light).then_some((self.lit, 9.0 + self.extra_stroke)),
        }
    }

    /// Fill of the object with that index, and whether it is hatched as a repetition.
    pub fn object(&self, index: usize) -> (Color, bool) {
        (self.objects[index % self.objects.len()], index >= self.objects.len())
    }

    /// The colour of a name on an object's opaque fill.
    pub fn object_ink(&self) -> Color {
        if self.name == ThemeName::Dark { self.canvas } else { self.text }
    }
}

/// Sizes of text in points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TypeSizes {
    /// Headline of the inspector, bold.
    pub headline: f32,
    /// Titles of panels, bold.
    pub title: f32,
    /// Sentences.
    pub sentence: f32,
    /// Height of a sentence's line.
    pub sentence_line: f32,
    /// Body text and tabs.
    pub body: f32,
    /// Labels, presets, buttons.
    pub label: f32,
    /// Numbers in tables and formulas.
    pub mono: f32,
    /// Height of their line.
    pub mono_line: f32,
    /// The listing.
    pub listing: f32,
    /// Height of its line.
    pub listing_line: f32,
    /// Labels on the canvas, bold.
    pub canvas: f32,
    /// Region codes.
    pub region: f32,
    /// The step counter.
    pub counter: f32,
    /// Nothing is smaller.
    pub smallest: f32,
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Relative luminance of WCAG 2.
    fn luminance(color: Color) -> f64 {
        let linear = |code: u8| {
            let c = f64::from(code) / 255.0;
            if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
        };
        let [red, green, blue, _] = color.0;
        0.2126 * linear(red) + 0.7152 * linear(green) + 0.0722 * linear(blue)
    }

    fn contrast(a: Color, b: Color) -> f64 {
        let (a, b) = (luminance(a) + 0.05, luminance(b) + 0.05);
        a.max(b) / a.min(b)
    }

    #[test]
    fn text_is_readable_wherever_it_stands() {
        for theme in ThemeName::ALL.map(ThemeName::theme) {
            for ground in [theme.canvas, theme.panel, theme.field, theme.raised, theme.lit, theme.changed_bg]
            {
                assert!(contrast(theme.text, ground) >= 4.5, "{:?} text on {}", theme.name, ground.css());
            }
            for ground in [theme.canvas, theme.panel] {
                assert!(contrast(theme.dim, ground) >= 4.5, "{:?} dim", theme.name);
            }
            assert!(contrast(theme.faint, theme.canvas) >= 4.5, "{:?} faint", theme.name);
        }
    }

    #[test]
    fn every_role_stands_out_from_canvas_panel_and_lit_row() {
        for theme in ThemeName::ALL.map(ThemeName::theme) {
            for role in Role::ALL {
                let color = theme.style(role).color;
                assert!(contrast(color, theme.canvas) >= 4.5, "{:?} {role:?} on the canvas", theme.name);
                for ground in [theme.panel, theme.lit] {
                    assert!(contrast(color, ground) >= 3.0, "{:?} {role:?}", theme.name);
                }
            }
            assert!(contrast(theme.edge, theme.canvas) >= 3.0);
            for object in theme.objects {
                // Names of objects are large and bold.
                assert!(contrast(theme.object_ink(), object) >= 4.0, "{:?} {}", theme.name, object.css());
            }
        }
    }

    #[test]
    fn contrasts_are_those_of_the_table() {
        let near = |a: f64, b: f64| (a - b).abs() < 0.051;
        assert!(near(contrast(DARK.style(Role::Active).color, DARK.canvas), 12.9));
        assert!(near(contrast(LIGHT.style(Role::Tie).color, LIGHT.canvas), 6.1));
        assert!(near(contrast(PROJECTOR.style(Role::Rejected).color, PROJECTOR.canvas), 7.7));
        assert!(near(contrast(PROJECTOR.line, PROJECTOR.canvas), 5.7));
    }

    #[test]
    fn no_two_roles_share_marker_or_the_pair_of_colour_and_dash() {
        for theme in ThemeName::ALL.map(ThemeName::theme) {
            for (i, a) in Role::ALL.into_iter().enumerate() {
                for b in &Role::ALL[i + 1..] {
                    let (a, b) = (theme.style(a), theme.style(*b));
                    assert_ne!(a.marker, b.marker);
                    assert!(
                        a.color != b.color || a.dash != b.dash || a.underlay != b.underlay,
                        "{:?}",
                        theme.name
                    );
                }
            }
        }
    }

    #[test]
    fn names_lead_back_to_themes() {
        for name in ThemeName::ALL {
            assert_eq!(ThemeName::from_name(name.name()), Some(name));
            assert_eq!(name.theme().name, name);
        }
        assert_eq!(ThemeName::from_name("sepia"), None);
    }

    #[test]
    fn painting_over_mixes_by_alpha() {
        let half = Color::hex(0xFF0000).alpha(0.5);
        assert_eq!(half.over(Color::hex(0x0000FF)), Color([128, 0, 127, 255]));
    }
}
