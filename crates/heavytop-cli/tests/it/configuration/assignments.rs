//! `--set`, a configuration from standard input, and `--threads`.

use crate::program::{Folder, numbers};

/// Runs `simulate` and returns the row of the end.
fn last(folder: &Folder, arguments: &[&str]) -> Vec<f64> {
    let arguments = [&["simulate", "--quiet", "--out", "a.csv"], arguments].concat();
    let run = folder.heavytop(&arguments);
    assert_eq!((run.code(), run.stderr()), (0, String::new()), "{arguments:?}");
    numbers(&folder.read("a.csv")).1.pop().unwrap()
}

#[test]
fn an_assignment_is_as_the_key_in_a_file_and_comes_after_it() {
    let folder = Folder::new();
    let text = "integrator.end = 1\nintegrator.scheme = 'gauss-4'\nbody.inertia = [2, 2, 1.5]";
    folder.write("whole.toml", text);
    folder.write("part.toml", "integrator.end = 7");
    let expected = last(&folder, &["whole.toml"]);
    let scheme = "integrator.scheme=gauss-4";
    let assigned = &["part.toml", "--set", "integrator.end=1", "--set", scheme];
    assert_eq!(
        last(&folder, &[assigned, &["--set", "body.inertia[2]=1.5"][..]].concat()),
        expected
    );
    assert_eq!(
        last(&folder, &[assigned, &["--set", "body.inertia=[2,2,1.5]"][..]].concat()),
        expected
    );
    // Negative control: without the last assignment it is another top.
    assert_ne!(last(&folder, assigned), expected);
    // The last assignment counts.
    let twice = ["--set", "integrator.end=5", "--set", "integrator.end=0.5"];
    assert_eq!(last(&folder, &twice)[0], 0.5);
    // An assignment is put over a preset too.
    let preset = last(&folder, &["--preset", "lagrange", "--set", "integrator.end=0.5"]);
    assert_eq!(preset[0], 0.5);
    assert!(preset[1..] != last(&folder, &twice)[1..]);
}

#[test]
fn wrong_assignments_are_refused_and_quoted() {
    for (assignment, parts) in [
        ("integrator.end", ["--set needs table.key=value, got `integrator.end`", "it has no ="]),
        ("=3", ["got `=3`", "it has no key before ="]),
        ("body.mass=", ["got `body.mass=`", "it has no value after ="]),
        ("body.inertia[3]=1", ["got `body.inertia[3]=1`", "there is no such component"]),
        ("body.mass[0]=1", ["got `body.mass[0]=1`", "there is no such array"]),
        ("body.mas=1", ["--set: unknown key `mas`", "^^^ did you mean `mass`?"]),
        ("body.mass=heavy", ["body.mass = \"heavy\"", "^^^^^^^ write a number"]),
        ("body.mass=0", ["--set: [body] mass must be positive", "^ write a number above 0"]),
        ("body.inertia[1]=-2", ["body.inertia = [2.0, -2, 1.0]", "^^ write 2"]),
        ("integrator.end=0.03", ["--set: end = 0.03 is not a whole", "^^^^ write 0.02 or 0.04"]),
        ("body.mass=1\nbody.length=2", ["body.mass: invalid type: string", "expected a number"]),
    ] {
        let folder = Folder::new();
        // The file is right; a wrong assignment is not put down to it.
        folder.write("a.toml", "[body]\nmass = 1.0\n[integrator]\nend = 1.0");
        let run = folder.heavytop(&["simulate", "a.toml", "--out", "a.csv", "--set", assignment]);
        assert_eq!((run.code(), run.messages()), (2, 1), "{assignment}: {}", run.stderr());
        for part in parts {
            assert!(run.stderr().contains(part), "{assignment}: {}", run.stderr());
        }
        assert!(!run.stderr().contains("a.toml"), "{}", run.stderr());
        assert_eq!(folder.names(), ["a.toml"]);
    }
}

#[test]
fn a_configuration_comes_from_standard_input() {
    let folder = Folder::new();
    let fed =
        |text: &str| folder.heavytop_fed(text, &["simulate", "-", "--out", "a.csv", "--quiet"]);
    assert_eq!(fed("integrator.end = 0.5").code(), 0);
    assert_eq!(numbers(&folder.read("a.csv")).1.len(), 26);
    let wrong = fed("[integrator]\nend = -inf");
    assert_eq!(wrong.code(), 2);
    let said = wrong.stderr();
    assert!(said.starts_with("heavytop: standard input, line 2, column 7: end must be finite"));
    assert!(said.contains("2 | end = -inf"), "{said}");
    // Nothing is as good as an empty file.
    assert_eq!(fed("").code(), 0);
    assert_eq!(numbers(&folder.read("a.csv")).1.len(), 5001);
}

#[test]
#[ignore = "long"]
fn threads_are_accepted_and_change_no_bit() {
    let folder = Folder::new();
    let sweep = |threads: &str, out: &str| {
        folder.heavytop(&[
            "sweep",
            "--out",
            out,
            "--threads",
            threads,
            "--set",
            "integrator.end=0.5",
            "--set",
            "sweep.axes=[{ parameter = 'body.mass', from = 1, to = 2, count = 600 }]",
        ])
    };
    for (threads, out) in [("1", "one"), ("3", "three")] {
        assert_eq!(sweep(threads, out).code(), 0);
    }
    let table = |out: &str| std::fs::read(folder.path(out).join("sweep.parquet")).unwrap();
    assert_eq!(table("one"), table("three"));
    for wrong in ["0", "1025", "-1", "many"] {
        let run = sweep(wrong, "none");
        assert_eq!(run.code(), 2, "{}", run.stderr());
        assert!(run.stderr().contains("threads"), "{}", run.stderr());
        assert!(!folder.path("none").exists());
    }
}
