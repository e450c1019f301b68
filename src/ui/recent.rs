//! Which lab of each stage was open last: a click on the stage opens it again.

use rasterscope_core::labs::{self, LabInfo, Stage};

/// Names of labs, the one that was open last at the end.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Recent(Vec<&'static str>);

impl Recent {
    /// The labs of these names, oldest first; other names are passed over.
    pub(crate) fn of<'a>(names: impl IntoIterator<Item = &'a str>) -> Self {
        Self(names.into_iter().filter_map(labs::find).map(|lab| lab.name).collect())
    }

    /// Their names, oldest first.
    pub(crate) fn names(&self) -> &[&'static str] {
        &self.0
    }

    /// Says that a lab is open.
    pub(crate) fn note(&mut self, name: &'static str) {
        if self.0.last() != Some(&name) {
            self.0.retain(|other| *other != name);
            self.0.push(name);
        }
    }

    /// The lab of a stage that was open last, or its first; `None`: the stage has none.
    pub(crate) fn at(&self, stage: Stage) -> Option<&'static str> {
        let here = |name: &&&'static str| labs::find(name).is_some_and(|lab| lab.stage == stage);
        self.0.iter().rev().find(here).copied().or_else(|| siblings(stage).next().map(|lab| lab.name))
    }
}

/// The labs of a stage, in the order of the registry.
pub(crate) fn siblings(stage: Stage) -> impl Iterator<Item = LabInfo> {
    labs::ALL.iter().copied().filter(move |lab| lab.stage == stage)
}

/// The lab `by` places on from one, round the labs of its stage.
pub(crate) fn beside(name: &str, by: isize) -> Option<&'static str> {
    let all: Vec<LabInfo> = siblings(labs::find(name)?.stage).collect();
    let at = all.iter().position(|lab| lab.name == name)?;
    let next = (at as isize + by).rem_euclid(all.len() as isize);
    Some(all[next as usize].name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stage_opens_the_lab_that_was_open_last_and_first_its_first() {
        let mut recent = Recent::default();
        assert_eq!(recent.at(Stage::Clip), siblings(Stage::Clip).next().map(|lab| lab.name));
        assert_eq!(recent.at(Stage::Divide), None);
        for name in ["liang-barsky", "scanline", "pipeline", "scanline"] {
            recent.note(name);
        }
        assert_eq!(recent.at(Stage::Clip), Some("liang-barsky"));
        assert_eq!(recent.names(), ["liang-barsky", "pipeline", "scanline"]);
        assert_eq!(Recent::of(["liang-barsky", "no such lab"]).names(), ["liang-barsky"]);
    }

    #[test]
    fn the_labs_of_a_stage_are_a_ring() {
        let all: Vec<&str> = siblings(Stage::Clip).map(|lab| lab.name).collect();
        for (i, name) in all.iter().enumerate() {
            assert_eq!(beside(name, 1), Some(all[(i + 1) % all.len()]));
            assert_eq!(beside(beside(name, 1).expect("a lab"), -1), Some(*name));
        }
    }
}
