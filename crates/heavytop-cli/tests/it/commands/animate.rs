//! `heavytop animate`: the page, its frames, and what it needs to be shown.

use crate::program::{Folder, heavytop};
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use heavytop::{HeavyTop, Invariant};
use lie_poisson::{Quaternion, Se3Dual};
use nalgebra::Vector3;
use serde_json::Value;

/// Reads the data of a page: its JSON, and the frames.
fn motion(page: &str) -> (Value, Vec<Vec<f64>>) {
    let (_, rest) = page.split_once(r#"<script type="application/json" id="motion">"#).unwrap();
    let json: Value = serde_json::from_str(rest.split_once("</script>").unwrap().0).unwrap();
    let bytes = BASE64_STANDARD.decode(json["numbers"].as_str().unwrap()).unwrap();
    let numbers: Vec<f64> =
        bytes.chunks(8).map(|bytes| f64::from_le_bytes(bytes.try_into().unwrap())).collect();
    let width = 11 + json["invariants"].as_array().unwrap().len();
    assert_eq!(numbers.len() % width, 0);
    (json, numbers.chunks(width).map(Vec::from).collect())
}

fn vector(numbers: &[f64]) -> Vector3<f64> {
    Vector3::from_row_slice(numbers)
}

/// Returns the error |Γ − Rᵀe₃| of a frame.
fn vertical_error(frame: &[f64]) -> f64 {
    let attitude = Quaternion { scalar: frame[7], vector: vector(&frame[8..11]) };
    (vector(&frame[4..7]) - attitude.conjugate().rotate(&Vector3::z())).norm()
}

#[test]
fn the_page_is_complete_loads_nothing_and_has_every_frame() {
    let folder = Folder::new();
    let run = folder.heavytop(&["animate", "--out", "top.html"]);
    assert_eq!((run.code(), run.complaints()), (0, String::new()));
    assert_eq!(folder.names(), ["top.html"]);
    let page = folder.read("top.html");
    assert!(page.starts_with("<!DOCTYPE html>") && page.ends_with("</html>\n"));
    assert_eq!(page.matches("</script>").count(), 2);
    for loading in ["{{", "http:", "https:", "//cdn", " src=", "href=", "@import", "url(", "fetch("]
    {
        assert_eq!(page.matches(loading).count(), 0, "{loading}");
    }
    // Control: the search finds a reference where there is one.
    assert!(page.replace("<style>", "<style>@import").contains("@import"));

    let (json, frames) = motion(&page);
    assert_eq!(json["description"], "collective, gauss-8, step 0.02 s, a frame for each step");
    let words = "I = (2, 2, 1) kg m², m g l = 1 N m, c = (1, 0, 0); \
                 Π(0) = (2, 3, 4) kg m²/s, Γ(0) = (0.5, 0, 0.866025)";
    assert_eq!(json["top"], words);
    assert_eq!(json["inertia"], serde_json::json!([2.0, 2.0, 1.0]));
    assert_eq!(json["centerOfMass"], serde_json::json!([1.0, 0.0, 0.0]));
    let symbols: Vec<&Value> =
        json["invariants"].as_array().unwrap().iter().map(|i| &i[0]).collect();
    assert_eq!(symbols, ["h", "f1", "f2", "K"]);
    assert_eq!(frames.len(), 5001);
    assert_eq!((frames[0][0], frames[5000][0]), (0.0, 100.0));
    let top = HeavyTop::kovalevskaya(1.0, 1.0).unwrap();
    for frame in &frames {
        // Rounding over 5000 steps: |Γ|² is 1.6e-14 off, and R is kept orthogonal.
        assert!(vertical_error(frame) < 1e-13, "{frame:?}");
        let mu = Se3Dual::new(vector(&frame[1..4]), vector(&frame[4..7]));
        assert_eq!(frame[11], Invariant::Energy.value(&top, &mu));
        assert_eq!(frame[14], Invariant::Kovalevskaya.value(&top, &mu));
    }
    // Control: the attitude of another frame does not have this Γ.
    let mut mixed = frames[1].clone();
    mixed[7..11].copy_from_slice(&frames[0][7..11]);
    assert!(vertical_error(&mixed) > 1e-3);
}

#[test]
fn the_frames_are_the_rows_of_simulate() {
    let folder = Folder::new();
    folder.write(
        "a.toml",
        "output = { every = 7, attitude = true }\nintegrator = { end = 2.0, scheme = 'gauss-6' }",
    );
    for out in ["a.csv", "a.html"] {
        let command = if out == "a.csv" { "simulate" } else { "animate" };
        assert_eq!(folder.heavytop(&[command, "a.toml", "--out", out]).code(), 0);
    }
    let (_, rows) = crate::program::numbers(&folder.read("a.csv"));
    let (json, frames) = motion(&folder.read("a.html"));
    assert_eq!(json["description"], "collective, gauss-6, step 0.02 s, a frame for every 7 steps");
    assert_eq!(rows.len(), frames.len());
    for (row, frame) in rows.iter().zip(&frames) {
        // The columns are t, Π, Γ; h, f1, f2, K; q.
        assert_eq!(
            (&row[..7], &row[11..15], &row[7..11]),
            (&frame[..7], &frame[7..11], &frame[11..])
        );
    }
}

#[test]
fn many_steps_are_thinned_out_and_the_last_is_kept() {
    let folder = Folder::new();
    folder.write(
        "a.toml",
        "integrator = { formulation = 'splitting', scheme = 'strang', step = 0.001, end = 50.0 }\noutput.every = 2",
    );
    let run = folder.heavytop(&["animate", "a.toml", "--out", "a.html"]);
    assert_eq!((run.code(), run.complaints()), (0, String::new()));
    let (json, frames) = motion(&folder.read("a.html"));
    assert_eq!(json["description"], "splitting, strang, step 0.001 s, a frame for every 4 steps");
    assert_eq!((frames.len(), frames[12_500][0]), (12_501, 50.0));
}

#[test]
fn the_summary_in_json_is_that_of_the_page() {
    let folder = Folder::new();
    folder.write("a.toml", "integrator = { end = 2.0, scheme = 'gauss-6' }\noutput.every = 7");
    let run = folder.heavytop(&["animate", "a.toml", "--out", "a.html", "--json"]);
    assert_eq!((run.code(), run.complaints()), (0, String::new()));
    let summary: Value = serde_json::from_str(&run.stdout()).unwrap();
    let (_, frames) = motion(&folder.read("a.html"));
    for (key, value) in [
        ("out", serde_json::json!("a.html")),
        ("formulation", serde_json::json!("collective")),
        ("scheme", serde_json::json!("gauss-6")),
        ("step", serde_json::json!(0.02)),
        ("steps", serde_json::json!(100)),
        ("end", serde_json::json!(2.0)),
        ("frames", serde_json::json!(frames.len())),
        ("steps_per_frame", serde_json::json!(7)),
    ] {
        assert_eq!(summary[key], value, "{key}");
    }
    // The angle is 2 arccos|q₀·q₁|, known to the square root of round-off.
    let q = |frame: &[f64]| nalgebra::Vector4::from_row_slice(&frame[7..11]);
    let turns = frames.windows(2).map(|pair| 2.0 * q(&pair[0]).dot(&q(&pair[1])).abs().acos());
    let largest = turns.fold(0.0, f64::max);
    assert!((summary["largest_turn"].as_f64().unwrap() - largest).abs() < 1e-7, "{summary}");
    assert!(largest > 0.1, "{largest}");
    // Without --json the command prints nothing.
    let silent = folder.heavytop(&["animate", "a.toml", "--out", "a.html"]);
    assert_eq!((silent.code(), silent.stdout()), (0, String::new()));
}

#[test]
fn frames_that_are_far_apart_are_warned_of() {
    let folder = Folder::new();
    folder.write("a.toml", "integrator.end = 10.0\noutput.every = 50");
    let run = folder.heavytop(&["animate", "a.toml", "--out", "a.html"]);
    assert_eq!(run.code(), 0);
    assert!(run.stderr().contains("rad from frame to frame"), "{}", run.stderr());
    assert_eq!(run.complaints().lines().count(), 1);
}

#[test]
fn wrong_requests_are_refused_and_nothing_is_written() {
    for (text, out, message) in [
        ("integrator.formulation = 'direct'", "a.html", "direct has no attitude"),
        ("output.every = 0", "a.html", "every must be at least 1"),
        ("body.mas = 1", "a.html", "a.toml, line 1, column 6: unknown key `mas`"),
        ("", "a.csv", "cannot write a.csv: the name must end in .html"),
        ("", "missing/a.html", "cannot create missing/a.html: No such file"),
    ] {
        let folder = Folder::new();
        folder.write("a.toml", text);
        let run = folder.heavytop(&["animate", "a.toml", "--out", out]);
        assert_eq!(run.code(), 2, "{text}: {}", run.stderr());
        assert!(run.stderr().contains(message), "{text}: {}", run.stderr());
        assert_eq!((run.messages(), folder.names()), (1, vec!["a.toml".into()]));
    }
}

#[test]
fn of_a_run_that_fails_a_page_of_its_beginning_is_kept() {
    let folder = Folder::new();
    folder
        .write("a.toml", "integrator = { step = 0.5, end = 10.0, scheme = 'lobatto-iiia-iiib-4' }");
    let run = folder.heavytop(&["animate", "a.toml", "--out", "a.html"]);
    assert_eq!(run.code(), 1, "{}", run.stderr());
    assert!(run.stderr().contains("did not converge"), "{}", run.stderr());
    assert!(run.stderr().contains("a.html.partial"), "{}", run.stderr());
    assert_eq!(folder.names(), ["a.html.partial", "a.toml"]);
    let (_, frames) = motion(&folder.read("a.html.partial"));
    assert!(!frames.is_empty() && frames.len() < 20);
}

#[test]
#[cfg(unix)]
fn no_half_page_is_kept_where_there_is_no_room() {
    let folder = Folder::new();
    // Files of at most 40 or 20 KB: shells count in blocks of 1024 or of 512 bytes.
    let heavytop = heavytop();
    let script = format!("trap '' XFSZ; ulimit -f 40; exec {heavytop} animate --out a.html");
    let mut command = std::process::Command::new("sh");
    let done = command.args(["-c", &script]).current_dir(folder.path(".")).output().unwrap();
    let said = String::from_utf8(done.stderr).unwrap();
    assert_eq!(done.status.code(), Some(1), "{said}");
    assert!(said.starts_with("heavytop: cannot write a.html: File too large"), "{said}");
    assert!(folder.names().is_empty(), "{:?}", folder.names());
}
