//! Runs that are interrupted, and go on.
#![allow(clippy::unwrap_used)]
#![cfg(unix)]

mod program;
use program::Folder;
use std::process::{Child, Command};
use std::thread::sleep;
use std::time::Duration;

const LONG: &str = "[integrator]\nscheme = 'gauss-4'\nend = 2000\n[output]\nevery = 3\n";

/// The run that is interrupted, with a checkpoint whenever there can be one.
fn start(folder: &Folder, out: &str, resume: bool) -> Child {
    let checkpoint = format!("{out}.checkpoint");
    let mut arguments = vec!["simulate", "a.toml", "--out", out, "--checkpoint-interval", "0"];
    if resume {
        arguments.extend(["--resume", &checkpoint]);
    }
    folder.start(&arguments)
}

/// Waits until there is a checkpoint, or the run is over, and for some milliseconds more.
fn wait(folder: &Folder, out: &str, child: &mut Child, milliseconds: u64) {
    while !folder.path(&format!("{out}.checkpoint")).exists() {
        if child.try_wait().unwrap().is_some() {
            return;
        }
        sleep(Duration::from_millis(1));
    }
    sleep(Duration::from_millis(milliseconds));
}

/// Kills a run after these milliseconds, lets it go on, and compares the outputs.
fn kill_and_go_on(integrator: &str, out: &str, times: impl IntoIterator<Item = u64>) {
    let folder = Folder::new();
    folder.write("a.toml", integrator);
    let reference = format!("reference-{out}");
    assert_eq!(folder.heavytop(&["simulate", "a.toml", "--out", &reference]).code(), 0);
    let expected = std::fs::read(folder.path(&reference)).unwrap();
    let mut interrupted = 0;
    for time in times {
        let mut child = start(&folder, out, false);
        wait(&folder, out, &mut child, time);
        let _ = child.kill();
        child.wait().unwrap();
        let checkpoint = format!("{out}.checkpoint");
        if folder.path(&checkpoint).exists() {
            interrupted += 1;
            // The configuration is the checkpoint's.
            let run = folder.heavytop(&["simulate", "--out", out, "--resume", &checkpoint]);
            assert_eq!((run.code(), run.stderr()), (0, String::new()), "{integrator} {time}");
        }
        assert!(std::fs::read(folder.path(out)).unwrap() == expected, "{integrator} {time}");
        assert_eq!(folder.names(), [out, "a.toml", &reference]);
        std::fs::remove_file(folder.path(out)).unwrap();
    }
    assert!(interrupted > 0, "{integrator}: no run was killed before its end");
}

#[test]
fn a_killed_run_goes_on_to_the_same_bytes_in_every_format() {
    for out in ["a.csv", "a.npz", "a.parquet"] {
        kill_and_go_on(LONG, out, [0, 3, 40]);
    }
}

#[test]
fn a_killed_run_goes_on_to_the_same_bytes_in_every_formulation() {
    for (formulation, scheme, attitude) in [
        ("collective", "implicit-midpoint", true),
        ("collective", "yoshida-6", false),
        ("reduced", "gauss-8", true),
        ("reduced", "suzuki-4", true),
        ("direct", "gauss-6", false),
        ("direct", "rk4", false),
        ("splitting", "kahan-li-6", true),
    ] {
        let text = format!(
            "integrator = {{ formulation = '{formulation}', scheme = '{scheme}', end = 1000 }}\n\
             output = {{ attitude = {attitude} }}"
        );
        kill_and_go_on(&text, "a.csv", [0]);
    }
}

#[test]
#[ignore = "takes a minute"]
fn twenty_kills_at_moments_that_are_not_chosen() {
    for out in ["a.csv", "a.npz", "a.parquet"] {
        let integrator = LONG.replace("2000", "6000");
        // Steps of the golden section, in milliseconds: everywhere within the run.
        kill_and_go_on(&integrator, out, (1..=20).map(|i| i * 618 % 1000));
    }
}

#[test]
fn ctrl_c_ends_a_run_with_a_checkpoint_also_twice() {
    let folder = Folder::new();
    folder.write("a.toml", &LONG.replace("2000", "20000"));
    for (round, resume) in [false, true].into_iter().enumerate() {
        let mut child = start(&folder, "a.npz", resume);
        wait(&folder, "a.npz", &mut child, 50);
        let id = child.id().to_string();
        assert!(Command::new("kill").args(["-INT", &id]).status().unwrap().success());
        let done = child.wait_with_output().unwrap();
        let said = String::from_utf8(done.stderr).unwrap();
        assert_eq!(done.status.code(), Some(130), "{said}");
        let expected = "heavytop: interrupted; go on by the same command with --resume \
                        a.npz.checkpoint\n";
        assert_eq!((round, said.as_str()), (round, expected));
        assert_eq!(folder.names(), ["a.npz.checkpoint", "a.npz.rows", "a.toml"]);
    }
}

/// A folder with an interrupted run.
fn interrupted() -> Folder {
    let folder = Folder::new();
    folder.write("a.toml", &LONG.replace("2000", "20000"));
    let mut child = start(&folder, "a.csv", false);
    wait(&folder, "a.csv", &mut child, 20);
    child.kill().unwrap();
    child.wait().unwrap();
    folder
}

#[test]
fn what_a_run_cannot_go_on_from_is_refused_and_left_as_it_is() {
    let folder = interrupted();
    folder.write("other.toml", &LONG.replace("gauss-4", "gauss-6"));
    folder.write("empty", "");
    let checkpoint = folder.read("a.csv.checkpoint");
    folder.write("damaged", &checkpoint.replace("gauss-4", "gauss-6"));
    folder.write("cut", &checkpoint[..checkpoint.len() - 10]);
    let contents = checkpoint.split_once('\n').unwrap().1;
    let version = format!("version = \"{}\"", env!("CARGO_PKG_VERSION"));
    let older = contents.replace(&version, "version = \"0.0.1\"");
    let checksum = crc32fast::hash(older.as_bytes());
    folder.write("older", &format!("heavytop-checkpoint {checksum:08x}\n{older}"));
    let before = std::fs::read(folder.path("a.csv.partial")).unwrap();
    for (arguments, message) in [
        (
            &["other.toml", "--resume", "a.csv.checkpoint"][..],
            "cannot go on from a.csv.checkpoint: it is of another configuration: [integrator] end: \
             20000.0 against 2000.0; [integrator] scheme: \"gauss-4\" against \"gauss-6\"",
        ),
        (&["--preset", "euler", "--resume", "a.csv.checkpoint"], "[body] inertia: "),
        (&["--resume", "missing"], "cannot go on from missing: No such file"),
        (&["--resume", "empty"], "damaged, or no checkpoint: it ends early"),
        (&["--resume", "a.csv.partial"], "damaged, or no checkpoint: it has no title"),
        (&["--resume", "damaged"], "its checksum is not that of its contents"),
        (&["--resume", "cut"], "its checksum is not that of its contents"),
        (&["--resume", "older"], "version 0.0.1 made it, and this is "),
    ] {
        let run = folder.heavytop(&[&["simulate", "--out", "a.csv"], arguments].concat());
        let said = run.stderr();
        assert_eq!(run.code(), 2, "{arguments:?}: {said}");
        assert!(said.contains(message), "{arguments:?}: {said}");
        assert_eq!(said.lines().count(), 1, "{said}");
        assert!(std::fs::read(folder.path("a.csv.partial")).unwrap() == before);
    }
    for (out, message) in [
        ("a.npz", "it is of an output in CSV, and a.npz is not"),
        ("b.csv", "the rows in b.csv.partial: No such file"),
    ] {
        let run = folder.heavytop(&["simulate", "--out", out, "--resume", "a.csv.checkpoint"]);
        assert_eq!(run.code(), 2);
        assert!(run.stderr().contains(message), "{}", run.stderr());
    }
    // Rows that are not those of the checkpoint: one byte is another.
    let mut other = before.clone();
    other[100] ^= 1;
    std::fs::write(folder.path("a.csv.partial"), &other).unwrap();
    let run = folder.heavytop(&["simulate", "--out", "a.csv", "--resume", "a.csv.checkpoint"]);
    assert_eq!(run.code(), 2);
    assert!(run.stderr().contains("a.csv.partial are not those that belong to it"));
    assert!(std::fs::read(folder.path("a.csv.partial")).unwrap() == other);
}

/// Runs `heavytop simulate` where files cannot have more than a million bytes.
fn in_little_room(folder: &Folder, arguments: &str) -> (Option<i32>, String) {
    let heavytop = env!("CARGO_BIN_EXE_heavytop");
    // Shells count in blocks of 512 or of 1024 bytes.
    let script = format!("trap '' XFSZ; ulimit -f 1000; exec {heavytop} simulate {arguments}");
    let mut command = Command::new("sh");
    let done = command.args(["-c", &script]).current_dir(folder.path(".")).output().unwrap();
    (done.status.code(), String::from_utf8(done.stderr).unwrap())
}

#[test]
fn a_run_without_room_goes_on_once_there_is_some() {
    for out in ["a.csv", "a.npz", "a.parquet"] {
        let folder = Folder::new();
        folder.write("a.toml", &LONG.replace("every = 3", "every = 1"));
        let arguments = format!("a.toml --out {out} --checkpoint-interval 0");
        let (code, said) = in_little_room(&folder, &arguments);
        assert_eq!(code, Some(1), "{said}");
        assert!(said.contains("File too large") && said.contains("; go on by "), "{said}");
        assert_eq!(said.lines().count(), 1, "{said}");
        let checkpoint = format!("{out}.checkpoint");
        let resumed = ["simulate", "--out", out, "--resume", &checkpoint];
        assert_eq!(folder.heavytop(&resumed).code(), 0);
        let bytes = std::fs::read(folder.path(out)).unwrap();
        assert_eq!(folder.heavytop(&["simulate", "a.toml", "--out", out]).code(), 0);
        assert!(std::fs::read(folder.path(out)).unwrap() == bytes, "{out}");
        assert_eq!(folder.names(), [out, "a.toml"]);

        // Without a checkpoint what there is is kept, and said where.
        let (code, said) = in_little_room(&folder, &format!("a.toml --out b-{out}"));
        let kept = format!("b-{out}.{}", if out == "a.csv" { "partial" } else { "rows" });
        assert_eq!(code, Some(1));
        assert!(said.ends_with(&format!("until then is in {kept}\n")), "{said}");
        assert_eq!(folder.names(), [out, "a.toml", &kept]);
    }
}

#[test]
fn without_resume_a_run_starts_anew() {
    let folder = interrupted();
    folder.write("a.toml", "[integrator]\nend = 0.1");
    assert_eq!(folder.heavytop(&["simulate", "a.toml", "--out", "a.csv"]).code(), 0);
    assert_eq!(folder.names(), ["a.csv", "a.toml"]);
}
