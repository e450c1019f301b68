//! `compute`: request line in, answer line out.

use crate::support::Random;
use rasterscope_cli::compute::{MOST_BYTES, answer, compute};
use serde_json::{Value, json};
use std::io::{Cursor, Read};

/// The answer to one request.
pub(crate) fn ask(request: &[u8]) -> Value {
    let mut out = Vec::new();
    answer(request, &mut out).expect("writing to memory cannot fail");
    let text = String::from_utf8(out).expect("JSON is UTF-8");
    assert_eq!(text.matches('\n').count(), 1, "one line: {text}");
    serde_json::from_str(&text).expect("an answer is JSON")
}

#[track_caller]
pub(crate) fn check(cases: &[(&str, &str)]) {
    for (request, expected) in cases {
        let expected: Value = serde_json::from_str(expected).expect("the case is JSON");
        assert_eq!(ask(request.as_bytes()), expected, "{request}");
    }
}

/// The code of the error, which must come with a sentence.
#[track_caller]
fn refused(request: &[u8]) -> String {
    let answer = ask(request);
    let error = answer.get("error").unwrap_or_else(|| panic!("no error: {answer}"));
    let message = error["message"].as_str().expect("a sentence");
    assert!(message.ends_with('.') && !message.contains('⟨'), "{message}");
    assert_eq!(answer.as_object().map(serde_json::Map::len), Some(1));
    error["code"].as_str().expect("a code").to_owned()
}

#[track_caller]
pub(crate) fn check_codes(cases: &[(&str, &str)]) {
    for (request, code) in cases {
        assert_eq!(refused(request.as_bytes()), *code, "{request}");
    }
}

fn run_lines(input: &str) -> Vec<Value> {
    let mut out = Vec::new();
    compute(&mut Cursor::new(input), true, &mut out).expect("every line has an answer");
    let text = String::from_utf8(out).expect("JSON is UTF-8");
    text.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect()
}

const LINE: &str = r#"{"op":"clip_line","window":[0,0,4,4],"segment":[-2,1,6,3]}"#;

#[test]
fn lines_are_clipped_and_keep_the_outcodes_of_the_given_ends() {
    check(&[
        (LINE, r#"{"visible":true,"segment":[0.0,1.5,4.0,2.5],"outcodes":["0001","0010"]}"#),
        (
            r#"{"op":"clip_line","algorithm":"cohen-sutherland","window":[0,0,4,4],"segment":[6,3,-2,1]}"#,
            r#"{"visible":true,"segment":[4.0,2.5,0.0,1.5],"outcodes":["0010","0001"]}"#,
        ),
        (
            r#"{"op":"clip_line","window":[0,0,4,4],"segment":[-2,5,-1,6]}"#,
            r#"{"visible":false,"segment":null,"outcodes":["1001","1001"]}"#,
        ),
        (
            r#"{"op":"clip_line","algorithm":"liang-barsky","window":[0,0,4,4],"segment":[-2,1,6,3]}"#,
            r#"{"visible":true,"segment":[0.0,1.5,4.0,2.5],"t":[0.25,0.75]}"#,
        ),
        (
            r#"{"op":"clip_line","algorithm":"liang-barsky","window":[0,0,4,4],"segment":[-2,5,-1,6]}"#,
            r#"{"visible":false,"segment":null}"#,
        ),
        (
            r#"{"op":"clip_line","window":[2,2,2,2],"segment":[0,0,4,4],"arithmetic":"f64"}"#,
            r#"{"visible":true,"segment":[2.0,2.0,2.0,2.0],"outcodes":["0101","1010"]}"#,
        ),
    ]);
}

/// The two triangles of the square from (1.5, 1.5) to (7.5, 7.5), split on the diagonal.
const HALVES: [&str; 2] = ["[[1.5,1.5],[7.5,1.5],[7.5,7.5]]", "[[1.5,1.5],[7.5,7.5],[1.5,7.5]]"];

fn rows(options: &str, vertices: &str) -> Vec<[u64; 3]> {
    let request = format!(r#"{{"op":"coverage","size":[10,10],"vertices":{vertices}{options}}}"#);
    let answer = ask(request.as_bytes());
    serde_json::from_value(answer["rows"].clone()).unwrap_or_else(|_| panic!("no rows: {answer}"))
}

#[test]
fn the_acceptance_square_is_filled_as_its_rule_says() {
    for algorithm in ["aabb", "scanline"] {
        for (rule, once, twice) in [("top-left", 36, 0), ("inclusive", 42, 7), ("strict", 25, 0)] {
            let options = format!(r#","algorithm":"{algorithm}","fill_rule":"{rule}""#);
            let mut hits = [[0; 10]; 10];
            for half in HALVES {
                for [y, begin, end] in rows(&options, half) {
                    (begin..end).for_each(|x| hits[y as usize][x as usize] += 1);
                }
            }
            let count = |n: i32| hits.iter().flatten().filter(|&&hit| hit == n).count();
            if rule == "strict" {
                let inner = (2..7).flat_map(|y| (2..7).map(move |x| (x, y)));
                let holes = inner.filter(|&(x, y): &(usize, usize)| hits[y][x] == 0).count();
                assert_eq!((count(1) + holes, holes), (once, 5), "{algorithm} {rule}");
            } else {
                assert_eq!((count(1), count(2)), (once, twice), "{algorithm} {rule}");
            }
        }
    }
}

#[test]
fn coverage_leaves_out_empty_rows_and_has_none_without_area() {
    check(&[
        (r#"{"op":"coverage","size":[4,4],"vertices":[[0,0],[1,1],[2,2]]}"#, r#"{"rows":[]}"#),
        (r#"{"op":"coverage","size":[4,4],"vertices":[[9,9],[9,12],[12,9]]}"#, r#"{"rows":[]}"#),
        (
            r#"{"op":"coverage","size":[4,2],"vertices":[[0,0.5],[4,0.5],[0,4]],"y_axis":"down"}"#,
            r#"{"rows":[[0,0,4],[1,0,3]]}"#,
        ),
        (
            r#"{"op":"coverage","size":[4,2],"vertices":[[0,0.5],[4,0.5],[0,4]],"y_axis":"up"}"#,
            r#"{"rows":[[1,0,3]]}"#,
        ),
        (
            r#"{"op":"coverage","size":[4,2],"vertices":[[-1e30,-1e30],[1e30,-1e30],[0,1e30]]}"#,
            r#"{"rows":[[0,0,4],[1,0,4]]}"#,
        ),
    ]);
    for arithmetic in ["f32", "f64", "fixed-8"] {
        for half in HALVES {
            let options = format!(r#","arithmetic":"{arithmetic}","algorithm":"scanline""#);
            assert_eq!(rows(&options, half), rows("", half), "{arithmetic}");
        }
    }
}

#[test]
fn depths_are_stored_as_the_format_says() {
    let ask = |format: &str| {
        ask(format!(
            r#"{{"op":"depth","size":[2,1],"format":"{format}","vertices":[[0,0,0],[2,0,1],[0,2,0]]}}"#
        )
        .as_bytes())
    };
    assert_eq!(ask("f32"), json!({"pixels": [[0, 0, 0.25]]}));
    assert_eq!(ask("unorm16"), json!({"pixels": [[0, 0, 16384.0 / 65535.0]]}));
    assert_eq!(ask("unorm24"), json!({"pixels": [[0, 0, 4_194_304.0 / 16_777_215.0]]}));
    assert_eq!(ask("unorm32"), json!({"pixels": [[0, 0, 1_073_741_824.0 / 4_294_967_295.0]]}));
    check(&[
        (r#"{"op":"depth","size":[4,4],"vertices":[[0,0,1],[1,1,1],[2,2,1]]}"#, r#"{"pixels":[]}"#),
        (
            r#"{"op":"depth","size":[1,1],"format":"unorm16","vertices":[[0,0,7],[2,0,7],[0,2,7]]}"#,
            r#"{"pixels":[[0,0,1.0]]}"#,
        ),
    ]);
}

#[test]
fn attributes_are_interpolated_where_there_is_an_inside() {
    let ask = |more: &str, vertices: &str| {
        ask(format!(r#"{{"op":"interpolate","attribute":[0,6,12],"vertices":{vertices}{more}}}"#).as_bytes())
    };
    let flat = "[[0,0,1],[4,0,1],[0,4,1]]";
    let deep = "[[0,0,1],[4,0,2],[0,4,1]]";
    assert_eq!(ask(r#","at":[2,0]"#, flat), json!({"value": 3.0}));
    assert_eq!(ask(r#","at":[2,0]"#, deep), json!({"value": 2.0}));
    assert_eq!(ask(r#","at":[2,0],"mode":"affine""#, deep), json!({"value": 3.0}));
    for (at, vertices, code) in [
        ("[9,9]", flat, "outside-triangle"),
        ("[0,0]", "[[0,0,1],[1,1,1],[2,2,1]]", "zero-area"),
        ("[1,1]", "[[0,0,0],[4,0,1],[0,4,1]]", "zero-w"),
        ("[2,0]", "[[0,0,1],[4,0,-1],[0,4,1]]", "infinite"),
    ] {
        assert_eq!(ask(&format!(r#","at":{at}"#), vertices)["error"]["code"], code);
    }
}

#[test]
fn triangles_are_clipped_in_clip_space() {
    check(&[
        (
            r#"{"op":"clip_triangle","space":"clip","vertices":[[0,0,0.5,1],[0.5,0,0.5,1],[0,0.5,0.5,1]]}"#,
            r#"{"polygon":[[0.0,0.0,0.5,1.0],[0.5,0.0,0.5,1.0],[0.0,0.5,0.5,1.0]]}"#,
        ),
        (
            r#"{"op":"clip_triangle","vertices":[[0,0,-0.5,1],[0.5,0,-0.5,1],[0,0.5,-0.5,1]]}"#,
            r#"{"polygon":[]}"#,
        ),
    ]);
    let behind = r#"{"op":"clip_triangle","depth_range":"minus-one-to-one",
        "vertices":[[0,0,-0.5,1],[0.5,0,-0.5,1],[0,0.5,-0.5,1]]}"#;
    assert_eq!(ask(behind.as_bytes())["polygon"].as_array().map(Vec::len), Some(3));
}

#[test]
fn numbers_are_rounded_to_binary32_on_the_way_in_and_kept_on_the_way_out() {
    let mut random = Random::new(1);
    for _ in 0..2000 {
        let segment: [f32; 4] = std::array::from_fn(|_| random.any());
        let window = [f32::MIN, f32::MIN, f32::MAX, f32::MAX];
        let request = json!({
            "op": "clip_line", "window": window.map(f64::from), "segment": segment.map(f64::from)
        });
        let answer = ask(request.to_string().as_bytes());
        for (i, number) in segment.into_iter().enumerate() {
            let back = answer["segment"][i].as_f64().expect("a number");
            assert_eq!(back.to_bits(), f64::from(number).to_bits(), "{request}");
        }
    }
    let answer = ask(br#"{"op":"clip_line","window":[0,0,1,1],"segment":[0.1,0.2,0.3,1e-60]}"#);
    let expected = [f64::from(0.1_f32), f64::from(0.2_f32), f64::from(0.3_f32), 0.0];
    assert_eq!(answer["segment"], json!(expected));
}

#[test]
fn each_kind_of_bad_input_has_its_code() {
    check_codes(&[
        ("", "malformed"),
        ("  ", "malformed"),
        ("{", "malformed"),
        ("[1,2]", "malformed"),
        ("\"op\"", "malformed"),
        ("{} {}", "malformed"),
        (r#"{"op":"clip_line","window":[0,0,1,NaN]}"#, "not-finite"),
        (r#"{"op":"clip_line","window":[0,0,1,-Infinity]}"#, "not-finite"),
        (r#"{"op":"clip_line","window":[0,0,1,Infinity]}"#, "not-finite"),
        (r#"{"op":"clip_line","window":[0,0,1,1e999]}"#, "not-finite"),
        (r#"{"op":"clip_line","window":[0,0,1,1e39],"segment":[0,0,1,1]}"#, "not-finite"),
        (r#"{"op":"clip_line","window":[0,0,1,3.4028236e38],"segment":[0,0,1,1]}"#, "not-finite"),
        ("{}", "missing-field"),
        (r#"{"op":"clip_line"}"#, "missing-field"),
        (r#"{"op":7}"#, "bad-field"),
        (r#"{"op":null}"#, "bad-field"),
        (r#"{"op":"clip_line","window":[0,0,1],"segment":[0,0,1,1]}"#, "bad-field"),
        (r#"{"op":"clip_line","window":7,"segment":[0,0,1,1]}"#, "bad-field"),
        (r#"{"op":"clip_line","window":[0,0,1,"1"],"segment":[0,0,1,1]}"#, "bad-field"),
        (r#"{"op":"clip_line","window":[1,0,0,1],"segment":[0,0,1,1]}"#, "bad-window"),
        (r#"{"op":"fly"}"#, "unknown-op"),
        (r#"{"op":"clip_line","algorithm":"guess"}"#, "unknown-algorithm"),
        (
            r#"{"op":"clip_line","window":[0,0,1,1],"segment":[0,0,1,1],"arithmetic":"f16"}"#,
            "unknown-arithmetic",
        ),
        (
            r#"{"op":"clip_line","window":[0,0,1,1],"segment":[-3e38,-3e38,3e38,3e38],"arithmetic":"f32"}"#,
            "overflow",
        ),
        (r#"{"op":"coverage","vertices":[[0,0],[1,0],[0,1]]}"#, "missing-field"),
        (r#"{"op":"coverage","size":[0,1],"vertices":[[0,0],[1,0],[0,1]]}"#, "bad-size"),
        (r#"{"op":"coverage","size":[1,16385],"vertices":[[0,0],[1,0],[0,1]]}"#, "bad-size"),
        (r#"{"op":"coverage","size":[1,1.5],"vertices":[[0,0],[1,0],[0,1]]}"#, "bad-size"),
        (r#"{"op":"coverage","size":[1,-1],"vertices":[[0,0],[1,0],[0,1]]}"#, "bad-size"),
        (r#"{"op":"coverage","size":[1e300,1],"vertices":[[0,0],[1,0],[0,1]]}"#, "bad-size"),
        (r#"{"op":"coverage","size":[1,1],"vertices":[[0,0],[1,0]]}"#, "bad-field"),
        (r#"{"op":"coverage","size":[1,1],"vertices":[[0,0],[1,0],[0,1,2]]}"#, "bad-field"),
        (r#"{"op":"coverage","size":[1,1],"algorithm":"backtracking"}"#, "unsupported"),
        (r#"{"op":"coverage","size":[1,1],"algorithm":"homogeneous"}"#, "unsupported"),
        (r#"{"op":"coverage","size":[1,1],"algorithm":"cohen-sutherland"}"#, "unknown-algorithm"),
        (r#"{"op":"coverage","size":[1,1],"fill_rule":"left"}"#, "unknown-fill-rule"),
        (r#"{"op":"coverage","size":[1,1],"y_axis":"left"}"#, "unknown-y-axis"),
        (r#"{"op":"depth","size":[1,1],"format":"f16"}"#, "unknown-format"),
        (r#"{"op":"interpolate","mode":"cubic"}"#, "unknown-mode"),
        (r#"{"op":"clip_triangle","depth_range":"none"}"#, "unknown-depth-range"),
        (r#"{"op":"clip_triangle","space":"moon"}"#, "unknown-space"),
        (r#"{"op":"clip_triangle","arithmetic":"f32"}"#, "unsupported"),
        (r#"{"op":"clip_triangle","arithmetic":"fixed-8"}"#, "unsupported"),
        (
            r#"{"op":"clip_line","window":[0,0,1,1],"segment":[0,0,1,1],"arithmetic":"fixed-8"}"#,
            "unsupported",
        ),
        (r#"{"op":"render"}"#, "missing-field"),
        (r#"{"op":"render","skips":"some"}"#, "unknown-skip"),
        (r#"{"op":"render","skips":["row","fly"]}"#, "unknown-skip"),
        (r#"{"op":"render","skips":[7]}"#, "bad-field"),
        (r#"{"op":"render","skips":3}"#, "bad-field"),
        (r#"{"op":"render","arithmetic":"f32"}"#, "unsupported"),
        (r#"{"op":"render","scene":7}"#, "bad-scene"),
        (
            r#"{"op":"render","scene":{"rasterscope":1,"size":[4,4],"draws":[{"model":"no.obj"}]}}"#,
            "missing-model",
        ),
    ]);
    assert_eq!(refused(b"{\"op\":\"\xFF\"}"), "not-utf8");
    for nest in ["[", "{\"a\":"] {
        assert_eq!(refused(nest.repeat(100_000).as_bytes()), "too-deep");
    }
}

#[test]
fn messages_say_where() {
    for (request, part) in [
        (r#"{"op":"clip_line","window":[0,0,1,1],"segment":[0,0,true,1]}"#, "segment[2]"),
        (r#"{"op":"clip_line","window":[0,0,1,NaN]}"#, "column 35"),
        (r#"{"op":"clip_line","algorithm":"guess"}"#, "cohen-sutherland"),
        (r#"{"op":"render","skips":3}"#, "\"all\", \"none\""),
        (r#"{"op":"clip_line","window":[.5,0,1,1]}"#, "0.5"),
        ("{\"op\":\"\\u001b[31m\"}", "\\u{1b}[31m"),
    ] {
        let answer = ask(request.as_bytes());
        let message = answer["error"]["message"].as_str().expect("a sentence");
        assert!(message.contains(part), "{message}");
    }
}

#[test]
fn every_line_has_one_answer_and_errors_do_not_stop_the_rest() {
    let answers = run_lines(&format!("{LINE}\r\nnonsense\n\n{LINE}"));
    assert_eq!(answers.len(), 4);
    assert_eq!(answers[0], answers[3]);
    assert_eq!(answers[1]["error"]["code"], "malformed");
    assert_eq!(answers[2]["error"]["code"], "malformed");
    assert!(run_lines("").is_empty());
}

#[test]
fn a_line_of_a_hundred_megabytes_is_passed_over_in_little_memory() {
    let long = std::io::repeat(b'[').take(100 << 20);
    let end = format!("\n{LINE}\n");
    let mut input = std::io::BufReader::new(long.chain(end.as_bytes()));
    let mut out = Vec::new();
    compute(&mut input, true, &mut out).expect("every line has an answer");
    let text = String::from_utf8(out).expect("JSON is UTF-8");
    let answers: Vec<Value> = text.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect();
    assert_eq!(answers.len(), 2);
    assert_eq!(answers[0]["error"]["code"], "too-long");
    assert_eq!(answers[1], ask(LINE.as_bytes()));
    const { assert!(MOST_BYTES < 100 << 20) };
}

#[test]
fn without_lines_the_whole_input_is_one_request() {
    let mut out = Vec::new();
    let pretty = LINE.replace(',', ",\n  ");
    compute(&mut Cursor::new(&pretty), false, &mut out).expect("there is an answer");
    assert_eq!(serde_json::from_slice::<Value>(&out).expect("JSON"), ask(LINE.as_bytes()));
}

#[test]
fn garbage_never_costs_more_than_one_error_object() {
    let mut random = Random::new(7);
    let seeds = [
        LINE,
        r#"{"op":"coverage","size":[9,9],"fill_rule":"strict","vertices":[[0,0],[9,2],[1,8]]}"#,
        r#"{"op":"depth","size":[9,9],"format":"unorm24","vertices":[[0,0,0],[9,2,1],[1,8,0]]}"#,
        r#"{"op":"interpolate","vertices":[[0,0,1],[9,2,2],[1,8,3]],"attribute":[0,1,2],"at":[2,3]}"#,
        r#"{"op":"clip_triangle","vertices":[[0,0,0,1],[9,2,1,2],[1,8,0,3]]}"#,
        r#"{"op":"render","scene":{"rasterscope":1,"size":[9,9],"draws":[{"vertices":[[0,0,0],[9,2,1],[1,8,0]]}]}}"#,
    ];
    for _ in 0..1000 {
        let mut line = random.pick(&seeds).as_bytes().to_vec();
        for _ in 0..=random.below(6) {
            let at = random.below(line.len() as u32) as usize;
            match random.below(5) {
                0 => line[at] = random.bits() as u8,
                1 => drop(line.remove(at)),
                2 => line.insert(at, random.pick(b"{}[]\",:-9e.x")),
                3 => line.truncate(at + 1),
                _ => drop(line.splice(at..at, *b"1e38")),
            }
            if line.is_empty() {
                line.push(b' ');
            }
        }
        let answer = ask(&line);
        let known = ["error", "visible", "rows", "pixels", "value", "polygon", "color"];
        assert!(known.iter().any(|field| answer.get(field).is_some()), "{answer}");
    }
}

#[test]
fn a_cut_end_on_two_borders_has_the_bits_of_both() {
    let clip = |segment: &str| {
        let window = "[-0.0,8388607.5,1.0,8388608.0]";
        ask(format!(r#"{{"op":"clip_line","window":{window},"segment":{segment}}}"#).as_bytes())
    };
    let bits = |answer: &Value, i: usize| answer["segment"][i].as_f64().expect("a number").to_bits();
    let (there, back) = (clip("[-0.0,8388607.5,-3.375,2.453125]"), clip("[-3.375,2.453125,-0.0,8388607.5]"));
    for i in [0, 2] {
        assert_eq!(
            (bits(&there, i), bits(&back, i)),
            ((-0.0_f64).to_bits(), (-0.0_f64).to_bits()),
            "{there}"
        );
    }
}
