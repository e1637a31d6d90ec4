//! `heavytop init` and `heavytop man`.

use crate::program::Folder;
use std::process::Command;

#[test]
fn the_first_configuration_is_the_preset_and_overwrites_nothing() {
    for preset in ["kovalevskaya", "lagrange", "multibody-benchmark"] {
        let folder = Folder::new();
        let made = folder.heavytop(&["init", "--preset", preset, "a.toml"]);
        assert_eq!((made.code(), made.stderr(), made.stdout()), (0, String::new(), String::new()));
        let text = folder.read("a.toml");
        assert_eq!(folder.heavytop(&["init", "--preset", preset]).stdout(), text);
        for key in [
            "[body]",
            "inertia = ",
            "# principal moments about the support, kg m²",
            "[output]",
            "every = 1",
        ] {
            assert!(text.contains(key), "{text}");
        }
        // It runs as the preset does, to the last bit.
        let end = ["--set", "integrator.end=0.1", "--set", "integrator.step=0.003125", "--quiet"];
        let run = |first: &[&str], out: &str| {
            let run = folder.heavytop(&[&["simulate", "--out", out], first, &end[..]].concat());
            assert_eq!((run.code(), run.stderr()), (0, String::new()));
            folder.read(out)
        };
        assert_eq!(run(&["a.toml"], "a.csv"), run(&["--preset", preset], "b.csv"));

        // What nobody has edited may be replaced, and what somebody has is kept.
        let other = folder.heavytop(&["init", "--preset", "euler", "a.toml"]);
        assert_eq!((other.code(), other.stderr()), (0, String::new()));
        assert_ne!(folder.read("a.toml"), text);
        folder.write("a.toml", &text.replace("mass = ", "mass = 1"));
        let edited = folder.read("a.toml");
        let again = folder.heavytop(&["init", "a.toml"]);
        assert_eq!((again.code(), folder.read("a.toml")), (2, edited));
        let expected = "heavytop: a.toml exists, and is not overwritten: it is no configuration as init writes it; \
                        choose another name, or replace it with --force\n";
        assert_eq!(again.stderr(), expected);
        let forced = folder.heavytop(&["init", "--preset", preset, "a.toml", "--force"]);
        assert_eq!((forced.code(), folder.read("a.toml")), (0, text));
    }
    let folder = Folder::new();
    let nowhere = folder.heavytop(&["init", "missing/a.toml"]);
    assert_eq!(nowhere.code(), 2);
    assert!(nowhere.stderr().contains("cannot create missing/a.toml"), "{}", nowhere.stderr());
}

/// Configurations of sections and sweeps run as they are, and are those of `section` and `sweep`.
#[test]
fn sections_and_sweeps_begin_with_tables_of_their_own() {
    for (command, shrink, made) in [
        ("section", "section={starts=2,crossings=5}", "section.csv"),
        ("sweep", "integrator={end=1,step=0.5}", "sweep.parquet"),
    ] {
        let folder = Folder::new();
        for preset in ["kovalevskaya", "goryachev-chaplygin"] {
            let begun = folder.heavytop(&["init", "--for", command, "--preset", preset, "a.toml"]);
            assert_eq!((begun.code(), begun.stderr()), (0, String::new()));
            let text = folder.read("a.toml");
            assert!(
                text.contains(&format!("# Run it: heavytop {command} FILE --out DIR")),
                "{text}"
            );
            assert!(text.lines().all(|line| line.chars().count() <= 110), "{text}");
        }
        let run = folder.heavytop(&[command, "a.toml", "--set", shrink, "--out", "out"]);
        assert_eq!(run.code(), 0, "{}", run.stderr());
        assert!(folder.path("out").join(made).exists());
        // What somebody has edited is kept.
        folder.write(
            "a.toml",
            &folder
                .read("a.toml")
                .replace("count = 32", "count = 3")
                .replace("starts = 60", "starts = 6"),
        );
        assert_eq!(folder.heavytop(&["init", "--for", command, "a.toml"]).code(), 2);
    }
    let both = Folder::new().heavytop(&["init", "--for", "sweep", "--kind", "vortices"]);
    assert!(both.code() == 2 && both.stderr().contains("cannot be used with"), "{}", both.stderr());
}

#[test]
fn manual_pages_are_pages() {
    let folder = Folder::new();
    for (arguments, title, parts) in [
        (&["man"][..], ".TH heavytop 1", ["simulate", "EXIT CODES"]),
        (
            &["man", "simulate"],
            ".TH heavytop-simulate 1",
            ["checkpoint\\-interval", "FORMULATIONS"],
        ),
        (&["man", "sweep"], ".TH heavytop-sweep 1", ["threads", "lyapunov"]),
    ] {
        let run = folder.heavytop(arguments);
        let page = run.stdout();
        assert_eq!((run.code(), run.stderr()), (0, String::new()));
        assert!(page.contains(title), "{page}");
        assert!(parts.iter().all(|part| page.contains(part)), "{page}");
        folder.write("page.1", &page);
        let shown = Command::new("man")
            .args(["--warnings", "-l", "page.1"])
            .env("MANPAGER", "cat")
            .current_dir(folder.path("."))
            .output();
        match shown {
            Ok(shown) if shown.status.success() => {
                let warned = String::from_utf8_lossy(&shown.stderr);
                assert!(!warned.contains("macro"), "{warned}");
                assert!(String::from_utf8_lossy(&shown.stdout).contains("heavytop"));
            }
            _ => println!("skipped: there is no man here"),
        }
    }
    let wrong = folder.heavytop(&["man", "levitate"]);
    assert_eq!(wrong.code(), 2);
    assert!(
        wrong.stderr().contains("there is no command `levitate`; there are reproduce, simulate")
    );
}

/// A system by name, from its template to a picture.
#[test]
fn a_system_begins_with_its_configuration() {
    let folder = Folder::new();
    for kind in ["spin-lattice", "gyrostat"] {
        let done = |arguments: &[&str]| {
            let run = folder.heavytop(arguments);
            assert_eq!(run.code(), 0, "{}", run.stderr());
        };
        done(&["init", "--kind", kind, "a.toml", "--force"]);
        done(&["simulate", "a.toml", "--out", "a.npz", "--force", "--set", "integrator.end=1"]);
        done(&["plot", "a.npz", "--out", "a.png"]);
        // It is replaced as long as nobody has edited it.
        done(&["init", "--kind", kind, "a.toml"]);
        folder.write("a.toml", &(folder.read("a.toml") + "# mine\n"));
        let refused = folder.heavytop(&["init", "--kind", kind, "a.toml"]);
        assert!(refused.code() == 2 && refused.stderr().contains("a.toml"), "{}", refused.stderr());
    }
    let run = folder.heavytop(&["init", "--kind", "vortex"]);
    assert!(run.code() == 2 && run.stderr().contains("there is no system vortex; there are"));
}
