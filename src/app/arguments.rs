//! The command line.

use clap::{Arg, ArgAction, ArgMatches, Command, builder::PossibleValuesParser, value_parser};
use rasterscope_cli::{
    bench::{BenchOptions, Subject, skips::SkipsOptions},
    figure::{self, AnimateOptions, FigureOptions},
    tour::TourOptions,
    trace::{TraceFormat, TraceOptions},
};
use rasterscope_core::{explain::Level, pipeline::Overlay, stress::Family};
use rasterscope_figure::{animation, theme::ThemeName, words::Words};
use rasterscope_measure::{
    pictures::ErrorKind,
    race::{STAGES, Stage},
};
use std::path::PathBuf;

/// What is asked for.
#[derive(Debug)]
pub(crate) enum Request {
    /// The window, with a file.
    Window(Option<PathBuf>),
    /// A request from a file.
    ComputeFile(PathBuf),
    /// Standard input: one request, or with `true` one a line.
    Compute(bool),
    /// The events of a run.
    Trace(TraceOptions),
    /// A picture.
    Figure(FigureOptions),
    /// An animated picture.
    Animate(FigureOptions, AnimateOptions),
    /// The page.
    Tour(TourOptions),
    /// Measurements.
    Bench(BenchOptions),
    /// What each skip saves.
    Skips(SkipsOptions),
    /// What there is.
    List,
}

/// Reads the command line; a wrong one ends the program with exit code 2, as `--help` ends it with 0.
pub(crate) fn read(words: &Words) -> Request {
    request(&command(words).get_matches())
}

fn command(words: &Words) -> Command {
    let path =
        |name: &'static str, help| Arg::new(name).help(words.word(help)).value_parser(value_parser!(PathBuf));
    let output = |help| path("output", help).short('o').long("output").required(true);
    let names = |all: &[&'static str]| PossibleValuesParser::new(all.to_vec());
    let choice = |name: &'static str, help, all: &[&'static str]| {
        Arg::new(name).long(name).help(words.word(help)).value_parser(names(all))
    };
    let sub = |name: &'static str, about| Command::new(name).about(words.word(about));
    Command::new("rasterscope")
        .version(env!("CARGO_PKG_VERSION"))
        .about(words.word("app-about"))
        .args_conflicts_with_subcommands(true)
        .arg(path("file", "app-file"))
        .subcommand(
            sub("compute", "app-compute").arg(path("file", "app-compute-file")).arg(
                Arg::new("lines")
                    .long("lines")
                    .help(words.word("app-compute-lines"))
                    .action(ArgAction::SetTrue)
                    .conflicts_with("file"),
            ),
        )
        .subcommand(
            sub("trace", "app-trace")
                .arg(Arg::new("algorithm").help(words.word("app-trace-algorithm")).required(true))
                .arg(path("file", "app-scene-or-request").required(true))
                .arg(
                    Arg::new("format")
                        .long("format")
                        .help(words.word("app-trace-format"))
                        .default_value(TraceFormat::default().name())
                        .value_parser(names(&TraceFormat::ALL.map(TraceFormat::name))),
                ),
        )
        .subcommand(
            sub("figure", "app-figure")
                .arg(Arg::new("lab").help(words.word("app-figure-lab")).required(true))
                .arg(path("file", "app-scene-or-request").required(true))
                .arg(
                    Arg::new("step")
                        .long("step")
                        .help(words.word("app-figure-step"))
                        .value_parser(value_parser!(usize)),
                )
                .arg(
                    Arg::new("size")
                        .long("size")
                        .value_name("WxH")
                        .help(words.word("app-figure-size"))
                        .value_parser(size_parser(words.word("app-error-size"))),
                )
                .arg(
                    Arg::new("theme")
                        .long("theme")
                        .help(words.word("app-figure-theme"))
                        .default_value(ThemeName::default().name())
                        .value_parser(names(&ThemeName::ALL.map(ThemeName::name))),
                )
                .arg(
                    Arg::new("overlay")
                        .long("overlay")
                        .help(words.word("app-figure-overlay"))
                        .conflicts_with("animate")
                        .value_parser(names(&figure::OVERLAYS.map(Overlay::name))),
                )
                .arg(
                    Arg::new("animate")
                        .long("animate")
                        .help(words.word("app-figure-animate"))
                        .action(ArgAction::SetTrue)
                        .conflicts_with("step"),
                )
                .arg(
                    Arg::new("level")
                        .long("level")
                        .help(words.word("app-figure-level"))
                        .requires("animate")
                        .value_parser(names(&Level::ALL.map(Level::name))),
                )
                .arg(
                    Arg::new("delay")
                        .long("delay")
                        .value_name("MS")
                        .help(words.word("app-figure-delay"))
                        .requires("animate")
                        .value_parser(value_parser!(u16).range(10..=60_000)),
                )
                .arg(output("app-figure-output")),
        )
        .subcommand(sub("tour", "app-tour").arg(path("file", "app-tour-file")).arg(output("app-tour-output")))
        .subcommand(
            sub("bench", "app-bench")
                .arg(
                    Arg::new("what")
                        .value_name("claims|growth|skips")
                        .help(words.word("app-bench-what"))
                        .value_parser(names(&["claims", "growth", "skips"])),
                )
                .arg(path("file", "app-bench-file").requires("what"))
                .arg(choice("operation", "app-bench-operation", &STAGES.each_ref().map(|stage| stage.name)))
                .arg(choice("workload", "app-bench-workload", &Family::ALL.map(Family::name)))
                .arg(choice("error", "app-bench-error", &ErrorKind::ALL.map(ErrorKind::name)))
                .arg(choice("theme", "app-bench-theme", &ThemeName::ALL.map(ThemeName::name)))
                .arg(path("output", "app-bench-output").short('o').long("output"))
                .arg(
                    Arg::new("json")
                        .long("json")
                        .help(words.word("app-bench-json"))
                        .action(ArgAction::SetTrue),
                )
                .arg(
                    Arg::new("rounds")
                        .long("rounds")
                        .value_name("N")
                        .help(words.word("app-bench-rounds"))
                        .value_parser(value_parser!(u32).range(1..=10_000)),
                ),
        )
        .subcommand(sub("list", "app-list"))
}

fn size_parser(wrong: String) -> impl Fn(&str) -> Result<[u32; 2], String> + Clone + Send + Sync + 'static {
    move |text| {
        let sides = text.split_once(['x', 'X', '×']);
        let size = sides.and_then(|(width, height)| Some([width.parse().ok()?, height.parse().ok()?]));
        size.ok_or_else(|| wrong.clone())
    }
}

fn request(matches: &ArgMatches) -> Request {
    let Some((name, matches)) = matches.subcommand() else { return Request::Window(path(matches, "file")) };
    let text = |name| matches.get_one::<String>(name).cloned().unwrap_or_default();
    match name {
        "compute" => match path(matches, "file") {
            Some(file) => Request::ComputeFile(file),
            None => Request::Compute(matches.get_flag("lines")),
        },
        "trace" => Request::Trace(TraceOptions {
            algorithm: text("algorithm"),
            file: path(matches, "file").unwrap_or_default(),
            format: TraceFormat::ALL
                .into_iter()
                .find(|format| format.name() == text("format"))
                .unwrap_or_default(),
        }),
        "figure" => {
            let options = FigureOptions {
                lab: text("lab"),
                file: path(matches, "file").unwrap_or_default(),
                step: matches.get_one("step").copied(),
                size: matches.get_one("size").copied().unwrap_or(figure::SIZE),
                overlay: Overlay::from_name(&text("overlay")).unwrap_or_default(),
                theme: ThemeName::from_name(&text("theme")).unwrap_or_default(),
                output: path(matches, "output").unwrap_or_default(),
            };
            if !matches.get_flag("animate") {
                return Request::Figure(options);
            }
            let level = Level::ALL.into_iter().find(|level| level.name() == text("level"));
            let delay = matches.get_one("delay").copied().unwrap_or(animation::DELAY);
            Request::Animate(options, AnimateOptions { level, delay })
        }
        "tour" => Request::Tour(TourOptions {
            file: path(matches, "file"),
            output: path(matches, "output").unwrap_or_default(),
        }),
        "bench" if text("what") == "skips" => Request::Skips(SkipsOptions {
            file: path(matches, "file"),
            json: matches.get_flag("json"),
            rounds: matches.get_one("rounds").copied().unwrap_or(rasterscope_measure::ROUNDS),
        }),
        "bench" => Request::Bench(BenchOptions {
            subject: Subject::NAMED
                .into_iter()
                .find(|(name, _)| *name == text("what"))
                .map_or(Subject::Table, |(_, subject)| subject),
            operation: Stage::from_name(&text("operation")),
            family: Family::from_name(&text("workload")),
            error: ErrorKind::from_name(&text("error")).unwrap_or_default(),
            json: matches.get_flag("json"),
            rounds: matches.get_one("rounds").copied().unwrap_or(rasterscope_measure::ROUNDS),
            output: path(matches, "output"),
            theme: ThemeName::from_name(&text("theme")).unwrap_or_default(),
            file: path(matches, "file"),
        }),
        _ => Request::List,
    }
}

fn path(matches: &ArgMatches, name: &str) -> Option<PathBuf> {
    matches.get_one(name).cloned()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(line: &str) -> Result<String, i32> {
        let matches = command(&Words::default()).try_get_matches_from(line.split(' '));
        matches.map(|matches| format!("{:?}", request(&matches))).map_err(|error| error.exit_code())
    }

    #[test]
    fn command_lines_ask_for_what_they_say() {
        command(&Words::default()).debug_assert();
        for (line, expected) in [
            ("rasterscope", "Window(None)"),
            ("rasterscope a.json", "Window(Some(\"a.json\"))"),
            ("rasterscope ./list", "Window(Some(\"./list\"))"),
            ("rasterscope list", "List"),
            ("rasterscope compute a.json", "ComputeFile(\"a.json\")"),
            ("rasterscope compute --lines", "Compute(true)"),
            ("rasterscope compute", "Compute(false)"),
            ("rasterscope tour -o out", "Tour(TourOptions { file: None, output: \"out\" })"),
        ] {
            assert_eq!(read(line).as_deref(), Ok(expected), "{line}");
        }
        let figure =
            read("rasterscope figure z-buffer a.json --step 3 --size 640x480 --theme light -o a.svg");
        let figure = figure.unwrap_or_default();
        for part in ["z-buffer", "Some(3)", "[640, 480]", "Light", "a.svg"] {
            assert!(figure.contains(part), "{part} in {figure}");
        }
        let laid = read("rasterscope figure pipeline a.json --overlay written -o a.svg");
        assert!(laid.unwrap_or_default().contains("overlay: Written"));
        let skips = read("rasterscope bench skips a.json --json --rounds 3");
        let expected = "Skips(SkipsOptions { file: Some(\"a.json\"), json: true, rounds: 3 })";
        assert_eq!(skips.as_deref(), Ok(expected));
        let film = read("rasterscope figure z-buffer a.json --animate --level row --delay 80 -o a.png");
        let film = film.unwrap_or_default();
        for part in ["Animate(", "Some(Row)", "delay: 80"] {
            assert!(film.contains(part), "{part} in {film}");
        }
    }

    #[test]
    fn a_benchmark_is_narrowed_down() {
        let bench = read(
            "rasterscope bench --operation coverage --workload sliver --error wrong --rounds 3 -o a.svg",
        );
        let bench = bench.unwrap_or_default();
        for part in ["subject: Table", "\"coverage\"", "Some(Sliver)", "error: Wrong", "rounds: 3", "a.svg"] {
            assert!(bench.contains(part), "{part} in {bench}");
        }
        let growth = read("rasterscope bench growth --json").unwrap_or_default();
        assert!(growth.contains("subject: Growth") && growth.contains("json: true"), "{growth}");
    }

    #[test]
    fn wrong_use_ends_with_2() {
        for line in [
            "rasterscope tour",
            "rasterscope figure z-buffer a.json --size big -o a.svg",
            "rasterscope figure z-buffer a.json --theme pink -o a.svg",
            "rasterscope figure pipeline a.json --overlay changed -o a.svg",
            "rasterscope figure pipeline a.json --overlay depth --animate -o a.png",
            "rasterscope figure z-buffer a.json --level row -o a.png",
            "rasterscope figure z-buffer a.json --animate --step 3 -o a.png",
            "rasterscope figure z-buffer a.json --animate --delay 1 -o a.png",
            "rasterscope figure z-buffer a.json --animate --level fine -o a.png",
            "rasterscope trace z-buffer",
            "rasterscope trace z-buffer a.json --format xml",
            "rasterscope compute a.json --lines",
            "rasterscope a.json b.json",
            "rasterscope bench everything",
            "rasterscope bench --operation painting",
        ] {
            assert_eq!(read(line), Err(2), "{line}");
        }
    }
}
