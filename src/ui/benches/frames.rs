//! What a frame of the window costs in egui, without window, driver and display: layout, painting
//! and tessellation, on one core. `cargo bench -p rasterscope-ui --bench frames [-- FILE...]`

#![expect(clippy::print_stdout, reason = "a benchmark says what it measured")]

use egui::{Context, Event, Modifiers, PointerButton, Pos2, RawInput, Rect, pos2, vec2};
use rasterscope_measure::Machine;
use rasterscope_ui::{App, Clock, Platform, Purpose, Reader};
use std::{io, time::Instant};

/// Milliseconds that this thread has run, so that other programs do not count; the system counts in
/// steps of some milliseconds, so only a mean over many frames says something. 0 where it does not say.
fn ran() -> f64 {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
    text.split(' ').next().and_then(|first| first.parse::<u64>().ok()).map_or(0.0, |n| n as f64 / 1e6)
}

/// Real files; nothing is kept.
struct Files;

impl Platform for Files {
    fn reader(&mut self) -> Reader {
        Box::new(|path| std::fs::read(path))
    }

    fn write(&mut self, _: &str, _: &[u8]) -> io::Result<()> {
        Ok(())
    }

    fn choose_file(&mut self, _: Purpose, _: &str) -> bool {
        false
    }

    fn chosen(&mut self) -> Option<(Purpose, String)> {
        None
    }

    fn kept(&mut self, _: &str) -> Option<Vec<u8>> {
        None
    }

    fn keep(&mut self, _: &str, _: &[u8]) -> io::Result<()> {
        Ok(())
    }

    fn spawn(&mut self, work: Box<dyn FnOnce() + Send>) {
        std::thread::spawn(work);
    }

    fn clock(&mut self) -> Clock {
        let start = Instant::now();
        Box::new(move || start.elapsed().as_secs_f64())
    }

    fn machine(&mut self) -> Machine {
        Machine::default()
    }
}

/// A window without a window.
struct Desk {
    ctx: Context,
    app: App,
    /// What this thread had run at the last report.
    ran: f64,
    time: f64,
    /// Milliseconds of each frame.
    times: Vec<f64>,
    /// Where things are, by their accessible names.
    places: Vec<(String, Rect)>,
}

impl Desk {
    fn open(file: &str) -> Self {
        let ctx = Context::default();
        ctx.enable_accesskit();
        let origin = Instant::now();
        let mut app = App::new(&ctx);
        app.start(&ctx, Some(file), &mut Files);
        let opened = origin.elapsed().as_secs_f64() * 1e3;
        let mut desk = Self { ctx, app, ran: ran(), time: 0.0, times: Vec::new(), places: Vec::new() };
        desk.frame(Vec::new());
        println!("{file}: started in {opened:.1} ms");
        desk.report("first frame");
        // Until what is done beside the window is there.
        let mut calm = 0;
        while calm < 30 {
            std::thread::sleep(std::time::Duration::from_millis(20));
            let busy = desk.places.is_empty() || desk.busy();
            calm = if busy { 0 } else { calm + 1 };
            desk.frame(Vec::new());
        }
        println!("    there after {:.0} ms", origin.elapsed().as_secs_f64() * 1e3);
        desk.report("while it opens");
        for _ in 0..20 {
            desk.frame(Vec::new());
        }
        desk.report("nothing happens");
        desk
    }

    fn frame(&mut self, events: Vec<Event>) {
        self.time += 1.0 / 60.0;
        let input = RawInput {
            screen_rect: Some(Rect::from_min_size(Pos2::ZERO, vec2(1280.0, 720.0))),
            time: Some(self.time),
            events,
            ..RawInput::default()
        };
        let start = Instant::now();
        let mut output = self.ctx.run_ui(input, |ui| self.app.ui(ui, &mut Files));
        let meshes = self.ctx.tessellate(std::mem::take(&mut output.shapes), output.pixels_per_point);
        self.times.push(start.elapsed().as_secs_f64() * 1e3);
        drop(meshes);
        output.textures_delta.clear();
        let nodes = output.platform_output.accesskit_update.into_iter().flat_map(|update| update.nodes);
        self.places = nodes
            .filter_map(|(_, node)| {
                let (name, at) = (node.label()?.to_owned(), node.bounds()?);
                let corner = |x: f64, y: f64| pos2(x as f32, y as f32);
                Some((name, Rect::from_min_max(corner(at.x0, at.y0), corner(at.x1, at.y1))))
            })
            .collect();
    }

    fn busy(&self) -> bool {
        ["Opening", "Computing", "Tracing"]
            .iter()
            .any(|verb| self.places.iter().any(|(name, _)| name.starts_with(verb)))
    }

    fn place(&self, name: &str) -> Option<Rect> {
        self.places.iter().find(|(label, _)| label == name).map(|(_, rect)| *rect)
    }

    fn drag(&mut self, from: Pos2, to: Pos2, frames: usize) {
        let button = |pos, pressed| Event::PointerButton {
            pos,
            button: PointerButton::Primary,
            pressed,
            modifiers: Modifiers::NONE,
        };
        self.frame(vec![Event::PointerMoved(from)]);
        self.frame(vec![button(from, true)]);
        self.clear();
        for i in 1..=frames {
            self.frame(vec![Event::PointerMoved(from + (to - from) * (i as f32 / frames as f32))]);
        }
        self.report(&format!("drag, {frames} frames"));
        self.frame(vec![button(to, false)]);
        self.clear();
    }

    fn report(&mut self, what: &str) {
        self.times.sort_by(f64::total_cmp);
        if let (Some(worst), n) = (self.times.last(), self.times.len()) {
            let mean = (ran() - self.ran) / n as f64;
            let median = self.times[n / 2];
            println!(
                "    {what:20} median {median:6.2}   worst {worst:7.2}   mean of the processor {mean:6.2} ms"
            );
        }
        self.clear();
    }

    fn clear(&mut self) {
        self.times.clear();
        self.ran = ran();
    }
}

fn main() {
    let mut files: Vec<String> = std::env::args().skip(1).filter(|name| !name.starts_with('-')).collect();
    if files.is_empty() {
        files = ["line-three-cuts", "span-needle", "depth-through", "vertex-perspective"]
            .into_iter()
            .chain(["two-through-each-other", "trefoil", "spheres"])
            .map(str::to_owned)
            .collect();
    }
    for file in files {
        let mut desk = Desk::open(&file);
        for name in ["P1", "A0"] {
            if let Some(at) = desk.place(name) {
                desk.drag(at.center(), at.center() + vec2(60.0, -45.0), 60);
            }
        }
        if let Some(bar) = desk.place("Step of the run") {
            let y = bar.center().y;
            println!("  scrubbing");
            desk.drag(pos2(bar.left() + 10.0, y), pos2(bar.right() - 10.0, y), 120);
        }
    }
}
