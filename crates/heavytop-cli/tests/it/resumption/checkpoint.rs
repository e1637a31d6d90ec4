//! `heavytop simulate` after an interruption: the run continues, to the same bytes.
#![cfg(unix)]

use crate::program::{Folder, heavytop};
use std::process::{Child, Command};
use std::thread::sleep;
use std::time::Duration;

pub const LONG: &str = "[integrator]\nscheme = 'gauss-4'\nend = 2000\n[output]\nevery = 3\n";

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
            let named = ["simulate", "--out", out, "--resume", &checkpoint];
            // Without a name it is the checkpoint of the output.
            let resumed = if time == 0 { &named[..] } else { &named[..4] };
            let run = folder.heavytop(resumed);
            assert_eq!((run.code(), run.complaints()), (0, String::new()), "{integrator} {time}");
        }
        assert!(std::fs::read(folder.path(out)).unwrap() == expected, "{integrator} {time}");
        assert_eq!(folder.names(), [out, "a.toml", &reference]);
        std::fs::remove_file(folder.path(out)).unwrap();
    }
    assert!(interrupted > 0, "{integrator}: no run was killed before its end");
}

#[test]
#[ignore = "a fault, which .ci/run makes"]
fn a_killed_run_goes_on_to_the_same_bytes_in_every_format() {
    for out in ["a.csv", "a.npz", "a.parquet"] {
        kill_and_go_on(LONG, out, [0, 3, 40]);
    }
}

/// A path of spins at a temperature, with intervals of the noise that are no whole number of steps.
#[test]
#[ignore = "a fault, which .ci/run makes"]
fn a_killed_run_at_a_temperature_goes_on_to_the_same_bytes() {
    let warm = "[system]\nkind = 'spin-lattice'\nparameters = { shape = [3, 2], exchange = 1 }\n\
        initial = { tilt = 0.3 }\n[damping]\nfriction = 0.1\n[noise]\ntemperature = 1\ninterval = 0.05\n\
        [integrator]\nstep = 0.02\nend = 80\n[output]\nevery = 30\n";
    kill_and_go_on(warm, "a.npz", [0, 30]);
}

/// A lattice of 4800 numbers, whose checkpoint has them as a text of bytes, after each 512 steps; and a fluid.
#[test]
#[ignore = "a fault, which .ci/run makes"]
fn a_killed_run_of_arrays_goes_on_to_the_same_bytes() {
    let lattice = "[system]\nkind = 'spin-lattice'\nparameters = { shape = [40, 40], exchange = 1 }\n\
        initial = { tilt = 0.3 }\n[integrator]\nformulation = 'reduced'\nscheme = 'spherical-midpoint'\n\
        step = 0.02\nend = 80\n[output]\nevery = 30\n";
    kill_and_go_on(lattice, "a.npz", [0, 30]);
    let fluid = "[system]\nkind = 'sphere-fluid'\nparameters = { size = 8 }\ninitial = { degrees = [1, 5] }\n\
        [integrator]\nscheme = 'gauss-4'\nstep = 0.02\nend = 100\n[output]\nevery = 30\n";
    kill_and_go_on(fluid, "a.csv", [0, 30]);
    let stirred = fluid.replace("scheme = 'gauss-4'\n", "").replace("end = 100", "end = 50")
        + "[damping]\nviscosity = 0.01\n[noise]\ntransport = { degrees = [2, 3], strength = 0.01 }\n\
           stirring = { degrees = [3, 3], strength = 0.1 }\n";
    kill_and_go_on(&stirred, "a.csv", [0, 30]);
}

#[test]
#[ignore = "a fault, which .ci/run makes"]
fn a_killed_run_backward_in_time_goes_on_to_the_same_bytes() {
    for out in ["a.csv", "a.npz"] {
        kill_and_go_on(&LONG.replace("2000", "-2000"), out, [0, 30]);
    }
}

#[test]
#[ignore = "a fault, which .ci/run makes"]
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
#[ignore = "a fault, which .ci/run makes"]
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
        let expected = "heavytop: interrupted; go on by the same command with --resume\n";
        // The warning about the accuracy comes first.
        assert!(said.ends_with(expected), "{round}: {said}");
        assert_eq!(folder.names(), ["a.npz.checkpoint", "a.npz.rows", "a.toml"]);
    }
}

/// Returns a folder with an interrupted run of a million steps.
pub fn interrupted(out: &str) -> Folder {
    interrupted_run(out, "")
}

/// Returns a folder with an interrupted run of a million steps, with more tables.
pub fn interrupted_run(out: &str, more: &str) -> Folder {
    let folder = Folder::new();
    folder.write("a.toml", &(LONG.replace("2000", "20000") + more));
    let mut child = start(&folder, out, false);
    wait(&folder, out, &mut child, 20);
    child.kill().unwrap();
    child.wait().unwrap();
    folder
}

/// Runs `heavytop simulate` where files cannot have more than a million bytes.
fn in_little_room(folder: &Folder, arguments: &str) -> (Option<i32>, String) {
    let heavytop = heavytop();
    // Shells count in blocks of 512 or of 1024 bytes.
    let script = format!("trap '' XFSZ; ulimit -f 1000; exec {heavytop} simulate {arguments}");
    let mut command = Command::new("sh");
    let done = command.args(["-c", &script]).current_dir(folder.path(".")).output().unwrap();
    (done.status.code(), String::from_utf8(done.stderr).unwrap())
}

#[test]
#[ignore = "a fault, which .ci/run makes"]
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
#[ignore = "a fault, which .ci/run makes"]
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
                "heavytop: {checkpoint} is of an interrupted run: go on with --resume, \
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

/// As `section` and `sweep` do, a run goes on where there is something to go on from, and otherwise begins.
#[test]
#[ignore = "a fault, which .ci/run makes"]
fn resume_begins_where_there_is_nothing_to_go_on_from() {
    let folder = Folder::new();
    folder.write("a.toml", "integrator.end = 0.1\nsection = { starts = 2, crossings = 2 }");
    let resume = |command: &str, out: &str| {
        folder.heavytop(&[command, "a.toml", "--out", out, "--resume", "--quiet"])
    };
    for (command, out) in [("simulate", "a.csv"), ("section", "made"), ("sweep", "made")] {
        let run = resume(command, out);
        assert_eq!((run.code(), run.stderr()), (0, String::new()), "{command}");
    }
    // Without a configuration the run that was meant is not known, and one that is named must be there.
    for arguments in [&["--resume"][..], &["a.toml", "--resume", "missing"]] {
        let run = folder.heavytop(&[&["simulate", "--out", "b.csv"], arguments].concat());
        assert_eq!(run.code(), 2, "{arguments:?}");
        assert!(run.stderr().starts_with("heavytop: cannot go on from "), "{}", run.stderr());
        assert!(!folder.path("b.csv").exists());
    }
    // A configuration stands before the options: after --resume it would be a checkpoint.
    let run = folder.heavytop(&["simulate", "--resume", "a.toml", "--out", "b.csv"]);
    assert_eq!(run.code(), 2);
    let expected = "heavytop: cannot go on from a.toml: it is a configuration, which stands before the options: \
                    heavytop simulate a.toml --resume --out FILE\n";
    assert_eq!(run.stderr(), expected);
    // Control: what is neither a configuration nor a checkpoint.
    folder.write("b.toml", "my notes");
    let run = folder.heavytop(&["simulate", "--resume", "b.toml", "--out", "b.csv"]);
    assert!(run.stderr().contains("it is damaged, or no checkpoint"), "{}", run.stderr());
}
