//! Undo and redo by whole-document snapshots.

/// How many gestures can be taken back.
const MOST: usize = 200;

/// Past and future documents. A document is small (big meshes sit behind `Arc`), so a snapshot is
/// a clone and no command objects are needed.
#[derive(Clone, Debug)]
pub struct History<D> {
    undo: Vec<D>,
    redo: Vec<D>,
    /// The document when the gesture in progress began.
    before: Option<D>,
}

impl<D> Default for History<D> {
    fn default() -> Self {
        Self { undo: Vec::new(), redo: Vec::new(), before: None }
    }
}

impl<D: Clone + PartialEq> History<D> {
    /// Call before the frame's edits, with the document as it is.
    pub fn begin(&mut self, document: &D) {
        if self.before.is_none() {
            self.before = Some(document.clone());
        }
    }

    /// Call after the frame's edits. While a gesture goes on (a drag, a held key) nothing is
    /// recorded, so that one drag is one undo step.
    pub fn end(&mut self, document: &D, gesture_goes_on: bool) {
        if gesture_goes_on {
            return;
        }
        if let Some(before) = self.before.take()
            && before != *document
        {
            self.undo.push(before);
            self.redo.clear();
            if self.undo.len() > MOST {
                self.undo.remove(0);
            }
        }
    }

    /// The document when the gesture in progress began, to put back if the user cancels it.
    pub fn before(&self) -> Option<&D> {
        self.before.as_ref()
    }

    /// Whether there is a gesture to take back.
    pub fn can_undo(&self) -> bool {
        !self.undo.is_empty()
    }

    /// Whether an undo can be taken back.
    pub fn can_redo(&self) -> bool {
        !self.redo.is_empty()
    }

    /// Goes one gesture back.
    pub fn undo(&mut self, document: &mut D) {
        if let Some(old) = self.undo.pop() {
            self.redo.push(std::mem::replace(document, old));
            self.before = None;
        }
    }

    /// Takes one undo back.
    pub fn redo(&mut self, document: &mut D) {
        if let Some(new) = self.redo.pop() {
            self.undo.push(std::mem::replace(document, new));
            self.before = None;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_drag_is_one_step() {
        let (mut history, mut document) = (History::default(), 0);
        for (value, goes_on) in [(1, true), (2, true), (3, false)] {
            history.begin(&document);
            document = value;
            history.end(&document, goes_on);
        }
        history.undo(&mut document);
        assert_eq!(document, 0, "the whole drag is undone");
        history.redo(&mut document);
        assert_eq!(document, 3, "and redone");
    }

    #[test]
    fn an_edit_after_undo_forgets_the_future() {
        let (mut history, mut document) = (History::default(), 0);
        for value in [1, 2] {
            history.begin(&document);
            document = value;
            history.end(&document, false);
        }
        history.undo(&mut document);
        history.begin(&document);
        document = 9;
        history.end(&document, false);
        assert!(!history.can_redo());
        history.undo(&mut document);
        assert_eq!(document, 1);
    }

    #[test]
    fn a_frame_without_an_edit_records_nothing() {
        let mut history = History::default();
        history.begin(&5);
        history.end(&5, false);
        assert!(!history.can_undo());
    }
}
