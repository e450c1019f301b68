//! The player on a long made-up run: bounded memory, seeks, search for a line.

use rasterscope_core::{
    explain::{Explain, Formula, Grid, Level, Mark, Marker, Operations, Role, Table, View},
    message::Message,
    replay::{Budget, Playback, Player, State},
    trace::{Count, Lift, Tracer},
};

/// A sum of 0, 1, 2, ...; every hundredth number ends a row.
#[derive(Clone, Debug, PartialEq)]
struct Sum {
    total: u64,
    padding: [u8; 4000],
}

impl State for Sum {
    type Event = u32;

    fn apply(&mut self, event: &u32) {
        self.total += u64::from(*event);
        self.padding[*event as usize % 4000] ^= 1;
    }
}

impl Explain for Sum {
    const NAME: &'static str = "sum";
    const LISTING: &'static [&'static str] = &["add", "row"];

    fn line(event: &u32) -> usize {
        usize::from(event % 100 == 99)
    }

    fn level(event: &u32) -> Level {
        if event % 100 == 99 { Level::Row } else { Level::Detail }
    }

    fn operations(_: &u32) -> Operations {
        Operations::new(1, 0, 0)
    }

    fn marker(event: &u32) -> Option<Marker> {
        event.is_multiple_of(1000).then_some(Marker { role: Role::Neutral, label: None })
    }

    fn opening(&self) -> Message {
        Message::new("sum-opening")
    }

    fn sentence(&self, _: &u32) -> Message {
        Message::new("sum-add").with("total", self.total as f64)
    }

    fn formulas(&self, _: &u32, _: &mut Vec<Formula>) {}

    fn tables(&self, _: &mut Vec<Table>) {}

    fn marks(&self, _: Option<&u32>, _: &mut Vec<Mark>) {}

    fn view(&self) -> View {
        View { min: [0.0; 2], max: [1.0; 2], y_up: true, grid: Grid::None }
    }
}

fn count_to<T: Tracer<u32>>(n: u32, t: &mut T) {
    (0..n).for_each(|i| t.emit(|| i));
}

fn player(n: u32, budget: Budget) -> Player<Sum> {
    Player::new(Sum { total: 0, padding: [0; 4000] }, budget, move |t| count_to(n, t))
}

#[test]
fn memory_does_not_grow_with_the_trace() {
    let budget = Budget { events: 4096, checkpoint_bytes: 64 << 10 };
    let mut player = player(200_000, budget);
    for step in [200_000, 3, 150_000, 149_999, 77_777, 0, 199_999] {
        player.seek(step);
        let last = step as u64;
        assert_eq!(player.state().total, last * last.saturating_sub(1) / 2, "at step {step}");
        assert!(player.events_in_memory() <= 4096);
    }
}

#[test]
fn levels_and_lines_are_found_outside_the_event_window() {
    let mut player = player(5_000, Budget { events: 16, checkpoint_bytes: 0 });
    player.seek(2_345);
    player.next(Level::Row);
    assert_eq!(player.cursor(), 2_400);
    player.back(Level::Row);
    assert_eq!(player.cursor(), 2_300);
    player.seek(4_990);
    assert!(player.next_at_line(1));
    assert_eq!(player.cursor(), 5_000);
    assert!(player.next_at_line(1), "from the start again");
    assert_eq!(player.cursor(), 100);
    assert_eq!(player.markers().len(), 5);
}

#[test]
fn values_before_the_step_leave_the_cursor_where_it_is() {
    let mut player = player(500, Budget::default());
    player.seek(120);
    player.tables_before();
    assert_eq!((player.cursor(), player.state().total), (120, 119 * 120 / 2));
}

#[test]
fn lifted_events_are_counted_once() {
    let mut count = Count(0);
    count_to(7, &mut Lift(&mut count, Some));
    assert_eq!(count, Count(7));
}
