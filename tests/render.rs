//! `render`: a scene to its image, by `compute`.

use crate::compute::ask;
use base64::{Engine, engine::general_purpose::STANDARD};
use serde_json::{Value, json};

#[test]
fn scenes_are_rendered_and_no_skip_changes_the_image() {
    let scene = r#"{"rasterscope":1,"size":[8,6],"depth_format":"unorm16","draws":[
        {"vertices":[[-2,-1,0],[2,-1,0],[0,2,1]],"color":[1,0.5,0,1]},{"model":"cube.obj"}]}"#;
    let rendered = |skips: &str| ask(format!(r#"{{"op":"render","scene":{scene}{skips}}}"#).as_bytes());
    let all = rendered("");
    assert_eq!(all["size"], json!([8, 6]), "{all}");
    let bytes = |field: &str| STANDARD.decode(all[field].as_str().expect("base64")).expect("base64").len();
    let lengths = ["color", "depth", "depth_codes", "stencil"].map(bytes);
    assert_eq!(lengths, [8 * 6 * 4, 8 * 6 * 4, 8 * 6 * 4, 8 * 6]);
    assert!(all["stats"].as_object().is_some_and(|stats| !stats.is_empty()));
    for skips in [
        r#","skips":"all""#,
        r#","skips":"none""#,
        r#","skips":["tile","early-z","memo"]"#,
        r#","bounding":"sphere""#,
        r#","bounding":"tree""#,
    ] {
        let other = rendered(skips);
        for field in ["color", "depth", "depth_codes", "stencil"] {
            assert_eq!(other[field], all[field], "{skips} {field}");
        }
    }
    assert_eq!(rendered(r#","bounding":"bag""#)["error"]["code"], "unknown-bounding");
    let plain = ask(br#"{"op":"render","scene":{"rasterscope":1,"size":[1,1],"draws":[]}}"#);
    assert!(plain.get("depth_codes").is_none());
    let depth = STANDARD.decode(plain["depth"].as_str().expect("base64")).expect("base64");
    assert_eq!(depth, 1.0_f32.to_le_bytes());
}

/// The answer for a scene of one draw.
fn render(draw: &str, skips: &str) -> Value {
    let scene = format!(r#"{{"rasterscope":1,"size":[16,8],"draws":[{draw}]}}"#);
    ask(format!(r#"{{"op":"render","skips":"{skips}","scene":{scene}}}"#).as_bytes())
}

#[test]
fn a_draw_that_leaves_the_range_is_an_error_whatever_is_skipped() {
    let draw = |scale: &str| {
        let vertices = "[[-1e20,-2e19,0],[1e20,2e19,0],[0,1e20,0]]";
        format!(r#"{{"vertices":{vertices},"cull":"none","transform":{{"scale":[{scale},1,1]}}}}"#)
    };
    for skips in ["all", "none"] {
        let answer = render(&draw("1e30"), skips);
        assert_eq!(answer["error"]["code"], "overflow", "{answer}");
        let message = answer["error"]["message"].as_str().expect("a sentence");
        assert!(message.starts_with("draws[0]: ") && message.contains("Scale it down"), "{message}");
        // Large numbers are none the worse for it.
        assert!(render(&draw("1e18"), skips).get("color").is_some());
        assert!(render(&draw("3.4e18"), skips).get("color").is_some());
    }
}

#[test]
fn stencil_masks_may_be_written_as_webgpu_has_them() {
    let draw = |numbers: &str| {
        let triangle = r#""vertices":[[-9,-9,0],[9,-9,0],[0,9,0]],"cull":"none""#;
        format!(r#"{{{triangle},"stencil":{{"passOp":"replace",{numbers}}}}}"#)
    };
    let of = |numbers: &str| render(&draw(numbers), "all")["stencil"].clone();
    let wide = of(r#""readMask":4294967295,"writeMask":4294967295,"reference":263"#);
    assert_eq!(wide, of(r#""reference":7"#));
    assert!(wide.is_string());
}
