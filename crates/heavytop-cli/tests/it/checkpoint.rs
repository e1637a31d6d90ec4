//! `heavytop simulate` after an interruption: the run continues, to the same bytes.
#![cfg(unix)]

use crate::program::Folder;
use std::process::{Child, Command};
use std::thread::sleep;
use std::time::Duration;

const LONG: &str = "[integrator]\nscheme = 'gauss-4'\nend = 2000\n[output]\nevery = 3\n";

/// Starts the run that is interrupted, with a checkpoint whenever there can be one.
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

/// Kills a run after each of these times, resumes it, and compares the outputs.
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
            // The configuration is that of the checkpoint.
            let run = folder.heavytop(&["simulate", "--out", out, "--resume", &checkpoint]);
            assert_eq!((run.code(), run.complaints()), (0, String::new()), "{integrator} {time}");
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
            "integrator = {{ formulation = '{formulation}', scheme = '{scheme}', end = 400 }}\n\
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
        // Multiples of the golden section, in milliseconds, lie everywhere within the run.
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

/// Returns a folder with an interrupted run of a million steps.
fn interrupted(out: &str) -> Folder {
    interrupted_run(out, "")
}

/// Returns a folder with an interrupted run of a million steps, with more tables.
fn interrupted_run(out: &str, more: &str) -> Folder {
    let folder = Folder::new();
    folder.write("a.toml", &(LONG.replace("2000", "20000") + more));
    let mut child = start(&folder, out, false);
    wait(&folder, out, &mut child, 20);
    child.kill().unwrap();
    child.wait().unwrap();
    folder
}

#[test]
fn what_a_run_cannot_go_on_from_is_refused_and_left_as_it_is() {
    let folder = interrupted("a.csv");
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
        ("b.csv", "cannot go on from a.csv.checkpoint: the rows in b.csv.partial: No such file"),
    ] {
        let run = folder.heavytop(&["simulate", "--out", out, "--resume", "a.csv.checkpoint"]);
        assert_eq!(run.code(), 2);
        assert!(run.stderr().contains(message), "{}", run.stderr());
    }
    // Rows that differ from those of the checkpoint in one byte.
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

        // Without a checkpoint the rows so far are kept, as a file if it has room, and the message says where.
        let (code, said) = in_little_room(&folder, &format!("a.toml --out b-{out}"));
        let kept = format!("b-{out}.{}", if out == "a.npz" { "rows" } else { "partial" });
        assert_eq!(code, Some(1));
        assert!(said.ends_with(&format!("until then is in {kept}\n")), "{said}");
        assert_eq!(folder.names(), [out, "a.toml", &kept]);
    }
}

#[test]
fn without_resume_a_run_is_refused_unless_it_shall_start_anew() {
    for (out, rows) in [("a.csv", "a.csv.partial"), ("a.npz", "a.npz.rows")] {
        let folder = interrupted(out);
        let names = folder.names();
        let files = || -> Vec<Vec<u8>> {
            names.iter().map(|name| std::fs::read(folder.path(name)).unwrap()).collect()
        };
        let (before, checkpoint) = (files(), format!("{out}.checkpoint"));
        for arguments in [&["simulate", "--out", out][..], &["simulate", "a.toml", "--out", out]] {
            let run = folder.heavytop(arguments);
            let expected = format!(
                "heavytop: {checkpoint} is of an interrupted run: go on with --resume {checkpoint}, \
                 or discard it with --restart\n"
            );
            assert_eq!((run.code(), run.stderr()), (2, expected));
            assert!(folder.names() == names && files() == before);
        }
        // If the rows are lost, the refused run does not create them.
        std::fs::remove_file(folder.path(rows)).unwrap();
        assert_eq!(folder.heavytop(&["simulate", "--out", out]).code(), 2);
        assert!(!folder.path(rows).exists() && folder.path(&checkpoint).exists());

        let both = ["simulate", "--out", out, "--restart", "--resume", &checkpoint];
        assert_eq!(folder.heavytop(&both).code(), 2);
        assert!(folder.path(&checkpoint).exists());
        folder.write("a.toml", "[integrator]\nend = 0.1");
        let run = folder.heavytop(&["simulate", "a.toml", "--out", out, "--restart"]);
        assert_eq!((run.code(), run.complaints()), (0, String::new()));
        assert_eq!(folder.names(), [out, "a.toml"]);
    }
}

/// Returns the contents of a checkpoint after a change, with a new checksum.
fn changed(checkpoint: &str, change: impl Fn(&str) -> String) -> String {
    let contents = change(checkpoint.split_once('\n').unwrap().1);
    assert_ne!(checkpoint.split_once('\n').unwrap().1, contents);
    format!("heavytop-checkpoint {:08x}\n{contents}", crc32fast::hash(contents.as_bytes()))
}

/// Returns the line of a key, and what comes after the equals sign.
fn line<'a>(contents: &'a str, key: &str) -> (&'a str, &'a str) {
    let line = contents.lines().find(|line| line.starts_with(&format!("{key} = "))).unwrap();
    (line, line.split_once(" = ").unwrap().1)
}

/// Returns a change that gives a key another value.
fn with(key: &str, value: impl Fn(&str) -> String) -> impl Fn(&str) -> String {
    move |contents| {
        let (line, old) = line(contents, key);
        // The whole line: "step = 0" is also the beginning of "step = 0.02".
        contents.replacen(&format!("{line}\n"), &format!("{key} = {}\n", value(old)), 1)
    }
}

#[test]
fn what_no_run_can_have_kept_is_refused_though_it_is_whole() {
    let number = |text: &str| text.parse::<u64>().unwrap();
    // A list without its first number; a list with another first number.
    let shorter = |list: &str| format!("[{}", list.split_once(',').unwrap().1);
    let other = |list: &str, first: &str| format!("[{first},{}", list.split_once(',').unwrap().1);
    let system = "[system]\nalgebra = 'so(3)'\nhamiltonian = 'Pi1^2+2*Pi2^2+3*Pi3^2'\n\
                  initial.Pi = [1, 0.5, 0.3]\n";
    for (out, rows, more, few) in [
        ("a.csv", "a.csv.partial", "", "it has 3 deviations of 4 invariants"),
        ("a.npz", "a.npz.rows", "", "it has 3 deviations of 4 invariants"),
        ("b.csv", "b.csv.partial", system, "it has 1 deviations of 2 invariants"),
    ] {
        let folder = interrupted_run(out, more);
        let read = || std::fs::read(folder.path(rows)).unwrap();
        let (name, before) = (format!("{out}.checkpoint"), read());
        let checkpoint = folder.read(&name);
        // The run ends after a million steps.
        for (changed, message) in [
            (
                changed(&checkpoint, with("step", |_| "1000960".into())),
                "no run makes such a checkpoint: it has step 1000960 of a run of 1000000",
            ),
            (
                changed(&checkpoint, with("step", |step| (number(step) + 1).to_string())),
                "which is no multiple of 1024",
            ),
            (
                changed(&checkpoint, with("step", |step| (number(step) + 1024).to_string())),
                "are not those that belong to it",
            ),
            // As if the run had begun on a processor with other instructions.
            (
                changed(&checkpoint, with("instructions", |_| "\"others\"".into())),
                "it is of a run on the instructions others, and this processor would go on with ",
            ),
            (changed(&checkpoint, with("state", shorter)), "it has a state of "),
            (changed(&checkpoint, with("state", |s| other(s, "nan"))), "it has a state with NaN"),
            (changed(&checkpoint, with("deviations", shorter)), few),
            (
                changed(&checkpoint, with("deviations", |s| other(s, "-1e308"))),
                "it has a deviation of -1e308",
            ),
            // Empty rows, with the checksum of an empty file.
            (
                changed(&checkpoint, |contents| {
                    let none = with("bytes", |_| "0".into())(contents);
                    with("checksum", |_| "0".into())(&none)
                }),
                "are not those that belong to it",
            ),
        ] {
            folder.write(&name, &changed);
            let run = folder.heavytop(&["simulate", "--out", out, "--resume", &name]);
            let said = run.stderr();
            assert_eq!(run.code(), 2, "{message}: {said}");
            assert!(said.contains(message), "{message}: {said}");
            assert!(said.ends_with("; start anew with --restart\n"), "{said}");
            assert!(read() == before && folder.read(&name) == changed, "{message}");
        }
        // Control: unchanged numbers with a new checksum are accepted.
        folder.write(&name, &changed(&checkpoint, |contents| format!("{contents}# nothing\n")));
        let mut child = folder.start(&["simulate", "--out", out, "--resume", &name]);
        sleep(Duration::from_millis(200));
        assert!(child.try_wait().unwrap().is_none(), "it was refused, or too short");
        child.kill().unwrap();
        child.wait().unwrap();
    }
}
