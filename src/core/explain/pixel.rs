//! What an algorithm says of one pixel, whatever the step.

use super::Table;
use crate::message::Message;

/// Why a pixel is drawn or not.
#[derive(Clone, Debug, PartialEq)]
pub struct PixelReport {
    /// The verdict, and who made it.
    pub sentence: Message,
    /// What is wrong with it, if it is not the exact one.
    pub warning: Option<Message>,
    /// The numbers behind it.
    pub tables: Vec<Table>,
}
