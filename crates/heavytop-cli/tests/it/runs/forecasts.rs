//! `--dry-run`, and the question before outputs that are absurdly large.

use crate::program::{Folder, heavytop, in_terminal};

#[test]
fn a_dry_run_says_what_a_run_would_write_and_writes_nothing() {
    for out in ["a.csv", "a.npz", "a.parquet"] {
        let folder = Folder::new();
        // Columns that are conserved to round-off, as h by the default scheme, are shorter in Parquet than others.
        let scheme = ["--set", "integrator.scheme=implicit-midpoint", "--set", "integrator.end=20"];
        let arguments = [&["simulate", "--out", out, "--quiet"], &scheme[..]].concat();
        let dry = folder.heavytop(&[&arguments[..], &["--dry-run", "--json"]].concat());
        assert_eq!((dry.code(), dry.stderr(), folder.names().len()), (0, String::new(), 0));
        let forecast: serde_json::Value = serde_json::from_str(&dry.stdout()).unwrap();
        assert_eq!(folder.heavytop(&arguments).code(), 0);
        let bytes = folder.path(out).metadata().unwrap().len() as f64;
        let forecast_bytes = forecast["bytes"].as_f64().unwrap();
        assert_eq!((&forecast["steps"], &forecast["rows"]), (&1000.into(), &1001.into()));
        // The names of columns and the metadata do not count; they are less than a tenth here.
        assert!((forecast_bytes / bytes - 1.0).abs() < 0.1, "{out}: {forecast_bytes} {bytes}");
        assert!(forecast["seconds"].as_f64().unwrap() > 0.0);
    }
    let folder = Folder::new();
    let said = folder.heavytop(&["simulate", "--out", "a.npz", "--dry-run"]).stdout();
    let expected = "5000 steps, 5001 rows, about 440.1 kB in a.npz (880.2 kB of disk until it is";
    assert!(said.starts_with(expected) && said.contains("; about "), "{said}");
    // A wrong request is refused as without --dry-run.
    let wrong = ["simulate", "--set", "body.mass=0", "--out", "a.npz", "--dry-run"];
    assert_eq!(folder.heavytop(&wrong).code(), 2);
}

#[test]
#[ignore = "long"]
fn dry_runs_of_sections_and_sweeps_say_what_they_would_write_and_write_nothing() {
    let section = ["--set", "section.starts=12", "--set", "section.crossings=100"];
    let sweep = ["--set", "integrator.end=2", "--set", "sweep.observables=[\"final-state\"]"];
    for (command, more, rows) in [("section", section, 12 * 101), ("sweep", sweep, 32 * 32)] {
        let folder = Folder::new();
        let arguments = [&[command, "--out", "a", "--quiet"], &more[..]].concat();
        let dry = folder.heavytop(&[&arguments[..], &["--dry-run", "--json"]].concat());
        assert_eq!((dry.code(), dry.stderr(), folder.names().len()), (0, String::new(), 0));
        let forecast: serde_json::Value = serde_json::from_str(&dry.stdout()).unwrap();
        assert_eq!(forecast["rows"], rows, "{command}");
        assert!(forecast["seconds"].as_f64().unwrap() > 0.0);

        assert_eq!(folder.heavytop(&arguments).code(), 0);
        let files = std::fs::read_dir(folder.path("a")).unwrap();
        let bytes = files.map(|file| file.unwrap().metadata().unwrap().len()).sum::<u64>();
        // The sizes of pictures depend on what they show.
        let ratio = forecast["bytes"].as_f64().unwrap() / bytes as f64;
        assert!((0.75..1.33).contains(&ratio), "{command}: {ratio}");
    }
    let folder = Folder::new();
    let said = folder.heavytop(&["sweep", "--out", "a", "--dry-run"]).stdout();
    assert!(said.starts_with("1024 tops of 1000 steps, about 201.7 kB in a ("), "{said}");
    assert_eq!(folder.heavytop(&["section", "--out", "a", "--dry-run", "--resume"]).code(), 2);
}

#[test]
fn an_absurdly_large_sweep_is_refused_where_nobody_can_be_asked() {
    let folder = Folder::new();
    folder.write(
        "large.toml",
        "sweep.observables = ['final-state', 'invariant-drift']\nsweep.count = 1000000000\n\
         [[sweep.axes]]\nparameter = 'body.mass'\nuniform = [1.0, 2.0]",
    );
    let run = folder.heavytop(&["sweep", "large.toml", "--out", "a"]);
    let said = run.stderr();
    assert_eq!((run.code(), folder.names().len()), (2, 1), "{said}");
    // Eleven numbers of eight bytes, compressed to six tenths, and nine of up to twenty in the tiles, for 1e9 tops.
    assert!(said.starts_with("heavytop: the run would write about 232.8 GB, and "), "{said}");
    assert!(said.ends_with(": lower the count, or agree with --yes\n"), "{said}");
}

/// Eleven numbers in each of 5e10 rows.
const LARGE: [&str; 5] = ["simulate", "--set", "integrator.end=1e9", "--out", "a.npz"];

#[test]
fn an_absurdly_large_output_is_refused_where_nobody_can_be_asked() {
    let folder = Folder::new();
    let run = folder.heavytop(&LARGE);
    assert_eq!((run.code(), folder.names().len()), (2, 0), "{}", run.stderr());
    let said = run.stderr();
    let expected = "heavytop: the run would write about 8.8 TB, and ";
    assert!(said.starts_with(expected) && said.ends_with("or agree with --yes\n"), "{said}");
    // Negative controls: --yes agrees; every n-th row is less; a device has room.
    let less = folder.heavytop(&[&LARGE[..], &["--dry-run"]].concat());
    assert_eq!(less.code(), 0);
    for more in [&["--yes"][..], &["--set", "output.every=1000000"], &["--out", "/dev/null"]] {
        let arguments = match more[0] {
            "--out" => [&LARGE[..3], more].concat(),
            _ => [&LARGE[..], more].concat(),
        };
        let mut child = folder.start(&arguments);
        std::thread::sleep(std::time::Duration::from_millis(700));
        assert!(child.try_wait().unwrap().is_none(), "{more:?}: the run did not begin");
        child.kill().unwrap();
        child.wait().unwrap();
    }
}

#[test]
fn on_a_terminal_there_is_a_question() {
    for (answer, begins) in [("n\n", false), ("\n", false), ("y\n", true)] {
        let folder = Folder::new();
        // With the answer yes the run is interrupted by the time limit.
        let heavytop = heavytop();
        let limited = format!("exec timeout --foreground 2 {heavytop} {}", LARGE.join(" "));
        let Some(said) = in_terminal(&folder, &limited, answer) else { return };
        assert!(said.contains(" are free; ") && said.contains("go on? [y/N] "), "{said}");
        assert_eq!(said.contains("agree with --yes"), !begins, "{said}");
        assert_eq!(folder.names().contains(&"a.npz.rows".into()), begins, "{:?}", folder.names());
    }
}
