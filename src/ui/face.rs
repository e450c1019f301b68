//! What every panel is given: the look, the words, and a way to ask for something.

use crate::{
    link::Links,
    measure::{Page, Scope},
    platform::Purpose,
    theme::{Look, Text},
};
use egui::{Response, RichText};
use rasterscope_core::{
    compare::{Setting, Side},
    explain::Level,
    labs::Stage,
    message::{Message, Value},
    pipeline::Overlay,
};
use rasterscope_figure::{theme::ThemeName, words::Words};
use std::cell::RefCell;

/// What a panel wants done. The shell does it after the frame, in one place.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Command {
    /// Go to a step.
    Seek(usize),
    /// Go on by a step of the chosen size.
    Next,
    /// Go back by a step of the chosen size.
    Back,
    /// Go to the start.
    Begin,
    /// Go to the end.
    End,
    /// Go to the next execution of a listing line.
    ToLine(usize),
    /// Go to the verdict on a fragment of the chosen pixel, counted from 0.
    ToEntry(usize),
    /// Choose a pixel.
    Pixel([u32; 2]),
    /// Choose the pixel so many columns and rows on.
    MovePixel([i8; 2]),
    /// Play, or stop playing.
    Play,
    /// Choose the size of a step.
    Level(Level),
    /// Choose the steps per second of playing.
    Speed(f32),
    /// Lay something on the overview's image.
    Overlay(Overlay),
    /// Take the last edit back.
    Undo,
    /// Take the last undo back.
    Redo,
    /// Wear the next theme.
    NextTheme,
    /// Wear a theme.
    Theme(ThemeName),
    /// Make everything bigger or smaller.
    TextSize(f32),
    /// Show or hide the keys.
    Keys,
    /// Show or hide the choices in a narrow window.
    Choices,
    /// Show or hide the hints of the first start.
    Hints,
    /// Show every digit of the values, or as many as there is room for.
    Exact,
    /// Move nothing that need not move, or move it.
    Still,
    /// Fit the drawing into the canvas.
    Fit,
    /// Close what lies over the canvas.
    Escape,
    /// Open the lab of a stage that was open last, or the overview.
    Stage(Stage),
    /// Open a lab.
    Lab(&'static str),
    /// Open the lab that is so many places on in its stage.
    Beside(isize),
    /// Open a preset.
    Preset(&'static str),
    /// Open a file.
    Open(String),
    /// Show the dialog that chooses a file.
    Choose(Purpose),
    /// Ask for a path to open.
    AskOpen,
    /// Ask for a path to save to.
    AskSave,
    /// Save to a path.
    SaveAs(String),
    /// Save where the document came from.
    Save,
    /// Close the bar under the ribbon.
    Dismiss,
    /// Go back to the document as it was opened or saved.
    Reset,
    /// Save, then do what was asked for.
    SaveFirst,
    /// Do what was asked for, without saving.
    Discard,
    /// Bring back the work that was set aside.
    BringBack,
    /// Forget the work that was set aside.
    Forget,
    /// Close the window.
    Quit,
    /// Ask for a path to write the picture to.
    AskPicture,
    /// Write the picture.
    Picture(String),
    /// Ask for a path to write the run to, as an animated picture.
    AskFilm,
    /// Write the run as an animated picture.
    Film(String),
    /// Stop what the timeline shows the progress of.
    Stop,
    /// Open a page of measurements.
    Measure(Page),
    /// Go back from the measurements to the lab.
    LeaveMeasure,
    /// Measure what the page shows, or all that it could show.
    StartMeasuring(Scope),
    /// Put the picture on the clipboard.
    CopyPicture,
    /// Put the values on the clipboard.
    CopyValues,
    /// Show or hide the command palette.
    Palette,
    /// Show what can be compared.
    AskCompare,
    /// Show two sides that differ in a setting, or one side only.
    Compare(Option<Setting>),
    /// Measure what each skip saves.
    MeasureSkips,
    /// Open the first broken case of the stress lab, made small, in the lab of its operation, beside exact.
    CaseInLab,
    /// Leave the split view, or show what can be compared.
    Split,
    /// Choose what a side has of the setting in which they differ.
    OfSide(Side, Setting),
    /// Let the inspector explain a side.
    Explain(Side),
    /// Make everything bigger by a step.
    Bigger,
    /// Make everything smaller by a step.
    Smaller,
}

impl Command {
    /// Whether it takes the document away.
    pub(crate) fn replaces(&self) -> bool {
        matches!(self, Self::Open(_) | Self::Preset(_) | Self::BringBack | Self::Quit)
    }
}

impl Command {
    /// Whether it is about the lab that is seen: its steps, its drawing, its input.
    pub(crate) fn is_of_lab(&self) -> bool {
        matches!(
            self,
            Self::Seek(_)
                | Self::Next
                | Self::Back
                | Self::Begin
                | Self::End
                | Self::Play
                | Self::MovePixel(_)
                | Self::Fit
                | Self::AskFilm
                | Self::AskCompare
                | Self::Undo
                | Self::Redo
        )
    }

    /// Whether it shows a lab.
    pub(crate) fn shows_lab(&self) -> bool {
        matches!(
            self,
            Self::Stage(_)
                | Self::Lab(_)
                | Self::Beside(_)
                | Self::Preset(_)
                | Self::Open(_)
                | Self::BringBack
                | Self::Compare(_)
                | Self::LeaveMeasure
        )
    }
}

/// The look and the words, and where commands go.
#[derive(Debug)]
pub(crate) struct Face<'a> {
    /// Colours, fonts and sizes.
    pub(crate) look: &'a Look,
    /// Sentences.
    pub(crate) words: &'a Words,
    /// What was asked for in this frame.
    pub(crate) commands: &'a RefCell<Vec<Command>>,
    /// What the pointer is on.
    pub(crate) links: &'a Links,
    /// Whether tables show every digit.
    pub(crate) exact: bool,
}

impl Face<'_> {
    /// Asks for something.
    pub(crate) fn ask(&self, command: Command) {
        self.commands.borrow_mut().push(command);
    }

    /// The words of a message without arguments.
    pub(crate) fn say(&self, id: &'static str) -> String {
        self.words.message(&Message::new(id))
    }

    /// The words of a message with one argument.
    pub(crate) fn say_with(&self, id: &'static str, name: &'static str, value: impl Into<Value>) -> String {
        self.words.message(&Message::new(id).with(name, value))
    }

    /// Lets a control say what the term of its label means, if the glossary has it.
    pub(crate) fn explain(&self, response: Response, term: &str) -> Response {
        match self.words.meaning(term) {
            Some(meaning) => response.on_hover_text(meaning),
            None => response,
        }
    }

    /// Text in a style, in the text colour.
    pub(crate) fn rich(&self, text: impl Into<String>, style: Text) -> RichText {
        RichText::new(text).font(self.look.font(style)).color(self.look.text)
    }

    /// Text in a style, in the colour of secondary text.
    pub(crate) fn dim(&self, text: impl Into<String>, style: Text) -> RichText {
        self.rich(text, style).color(self.look.dim)
    }
}
