//! Lays compact JSON out for reading: what fits on a line stays on it, the rest is broken.
//!
//! Works on the text, so that every number keeps its digits; only a `.0` at the end is dropped.
//! Cost: linear in the text, times its depth.

const WIDTH: usize = 100;
const INDENT: usize = 2;

/// `json` with line breaks, and one at the end. Expects JSON without white space.
pub(super) fn lay_out(json: &str) -> String {
    let mut out = String::with_capacity(json.len() * 5 / 4);
    put(json, 0, 0, &mut out);
    out.push('\n');
    out
}

/// Appends the value `json`, which begins at `column` of a line indented by `indent`.
fn put(json: &str, indent: usize, column: usize, out: &mut String) {
    let line = on_one_line(json);
    let container = json.starts_with(['[', '{']);
    // The comma behind it needs a column too.
    if !container || column + line.chars().count() < WIDTH {
        out.push_str(&line);
        return;
    }
    let (open, close) = (&json[..1], &json[json.len() - 1..]);
    let inner = indent + INDENT;
    out.push_str(open);
    for (i, item) in parts(&json[1..json.len() - 1], b',').enumerate() {
        if i > 0 {
            out.push(',');
        }
        out.push('\n');
        out.extend(std::iter::repeat_n(' ', inner));
        match open {
            "{" => {
                let name = parts(item, b':').next().unwrap_or(item);
                out.push_str(name);
                out.push_str(": ");
                put(&item[(name.len() + 1).min(item.len())..], inner, inner + name.len() + 2, out);
            }
            _ => put(item, inner, inner, out),
        }
    }
    out.push('\n');
    out.extend(std::iter::repeat_n(' ', indent));
    out.push_str(close);
}

/// The pieces of `json` between separators that stand in no string, list or object of it.
fn parts(json: &str, separator: u8) -> impl Iterator<Item = &str> {
    let mut rest = json;
    let mut done = json.is_empty();
    std::iter::from_fn(move || {
        if done {
            return None;
        }
        let (mut depth, mut quoted, mut escaped) = (0_usize, false, false);
        for (i, byte) in rest.bytes().enumerate() {
            match byte {
                _ if escaped => escaped = false,
                b'\\' if quoted => escaped = true,
                b'"' => quoted = !quoted,
                _ if quoted => {}
                b'[' | b'{' => depth += 1,
                b']' | b'}' => depth = depth.saturating_sub(1),
                _ if byte == separator && depth == 0 => {
                    let part = &rest[..i];
                    rest = &rest[i + 1..];
                    return Some(part);
                }
                _ => {}
            }
        }
        done = true;
        Some(rest)
    })
}

/// `json` with a space after each comma and colon.
fn on_one_line(json: &str) -> String {
    let mut line = String::with_capacity(json.len() + 16);
    let (mut quoted, mut escaped) = (false, false);
    for c in json.chars() {
        if !quoted && matches!(c, ',' | ']' | '}') && line.ends_with(".0") {
            line.truncate(line.len() - 2);
        }
        line.push(c);
        match c {
            _ if escaped => escaped = false,
            '\\' if quoted => escaped = true,
            '"' => quoted = !quoted,
            ',' | ':' if !quoted => line.push(' '),
            _ => {}
        }
    }
    // A number alone.
    if json.bytes().all(|byte| byte == b'-' || byte == b'.' || byte.is_ascii_digit()) && line.ends_with(".0")
    {
        line.truncate(line.len() - 2);
    }
    line
}

#[cfg(test)]
mod tests {
    use super::lay_out;

    #[test]
    fn short_values_stay_on_one_line_and_numbers_lose_their_empty_fraction() {
        assert_eq!(
            lay_out(r#"{"a":[1.0,-0.0,0.5,10.0],"b":"x,y.0","c":3.0}"#),
            "{\"a\": [1, -0, 0.5, 10], \"b\": \"x,y.0\", \"c\": 3}\n"
        );
    }

    #[test]
    fn long_values_are_broken_and_mean_the_same() {
        let long = format!(
            r#"{{"p\"}}":"{}","q":[{},[0.5]],"r":7.0,"s":{{}}}}"#,
            "z".repeat(120),
            "[1,2],".repeat(30).trim_end_matches(',')
        );
        let laid = lay_out(&long);
        assert!(laid.lines().filter(|line| !line.contains('z')).all(|line| line.len() <= 100), "{laid}");
        let value = |text: &str| serde_json::from_str::<serde_json::Value>(text).ok();
        assert_eq!(value(&laid.replace("\"r\": 7", "\"r\": 7.0")), value(&long));
    }
}
