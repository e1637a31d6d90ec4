//! Commands that fail: for their files, their numbers, their threads, or what other runs have left.

use super::refused;
use crate::program::{Finished, Folder, heavytop};
use heavytop_cli::Error;
use heavytop_cli::commands::animate::animate;
use heavytop_cli::commands::bench::{Bench, BenchOptions, bench};
use heavytop_cli::commands::compare::compare;
use heavytop_cli::commands::plot::{PlotOptions, plot, plot_as_text};
use heavytop_cli::commands::reproduce::reproduce;
use heavytop_cli::commands::simulate::{Checkpoint, SimulateOptions, simulate};
use heavytop_cli::commands::sweep::sweep;
use heavytop_cli::configuration::Config;
use heavytop_cli::files::{Input, Output, Safeguard};
use heavytop_cli::reading::Sources;
use heavytop_cli::runs::{Moment, Saved};
use heavytop_cli::supervision::{TileOptions, Watch};
use std::collections::BTreeSet;
use std::fs;
use std::process::Command;

pub fn errors() -> BTreeSet<String> {
    let folder = Folder::new();
    [
        of_files(&folder),
        of_arrays(&folder),
        of_inputs(&folder),
        of_numbers(&folder),
        of_others(&folder),
    ]
    .into_iter()
    .flatten()
    .collect()
}

fn config(text: &str) -> Config {
    toml::from_str(text).unwrap()
}

fn of_files(folder: &Folder) -> BTreeSet<String> {
    let watch = Watch::default();
    let to = |name: &str| {
        let options = SimulateOptions::default();
        simulate(&config("integrator.end = 0.1"), &folder.path(name), &options)
    };
    folder.write("notes.csv", "time,temperature\n");
    folder.write("read.csv", "");
    let safeguard = Safeguard::new(vec![Input::File(folder.path("read.csv"))], false);
    let over_input = SimulateOptions { safeguard: &safeguard, ..SimulateOptions::default() };
    let over_input =
        simulate(&config("integrator.end = 0.1"), &folder.path("read.csv"), &over_input);
    [
        refused("Error::Read", Sources::read(None, Some(&folder.path("missing.toml")), &[])),
        refused("Error::Checkpoint", Checkpoint::read(&folder.path("missing"))),
        refused("Error::Format", to("a.txt")),
        refused("Error::Create", to("missing/a.csv")),
        refused("Error::NoPage", animate(Config::default(), &folder.path("a.txt"), &watch)),
        refused("Error::Write", Output::whole(&folder.path("missing/a"), b"")),
        refused("Error::Exists", to("notes.csv")),
        refused("Error::OutputIsInput", over_input),
        refused("Error::FolderIsStream", reproduce("-".as_ref(), 0.02, 1.0, &watch)),
        refused("Error::Unwritable", config_of_too_large_a_number().to_toml()),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// A lattice of spins, with its start.
const SPINS: &str =
    "[system]\nkind = 'spin-lattice'\nparameters = { shape = [6000], exchange = 1 }\n";

fn of_arrays(folder: &Folder) -> BTreeSet<String> {
    let watch = Watch::default();
    let options = SimulateOptions::default();
    let with = |start: &str| config(&format!("{SPINS}{start}\n[integrator]\nend = 0.1\n"));
    let drawn = |run: &str, out: &str| {
        plot(&folder.path(run), &folder.path(out), &PlotOptions::default(), &watch)
    };
    simulate(&config("integrator.end = 0.1"), &folder.path("top.npz"), &options).unwrap();
    let file = folder.path("top.npz");
    let from = |checksum: &str| with(&format!("initial_file = '{}'\n{checksum}", file.display()));
    let of_one = PlotOptions { sample: Some(0), ..PlotOptions::default() };
    let one_sample = plot(&folder.path("top.npz"), &folder.path("a.gif"), &of_one, &watch);
    folder.write("text.npz", "");
    let of_track = PlotOptions { trace: Some("Pi".into()), ..PlotOptions::default() };
    let other_shape = folder.path("five.ovf");
    folder.write("five.ovf", "# OOMMF OVF 2.0\n# Begin: Data Text\n");
    [
        refused(
            "Error::TooWide",
            simulate(&with("initial.tilt = 1"), &folder.path("w.csv"), &options),
        ),
        refused("Error::NoPicture", drawn("top.npz", "a.jpg")),
        refused("Error::NoFilm", drawn("top.npz", "a.gif")),
        refused("Error::NeedsPicture", plot_as_text(&folder.path("top.npz"), &of_track)),
        refused("Error::OtherPicture", one_sample),
        refused("FieldFileError::Read", drawn("missing.npz", "a.png")),
        refused("FieldFileError::Format", drawn("text.npz", "a.png")),
        refused("FieldFileError::NoArray", from("").run()),
        refused(
            "Error::FieldFile",
            with(&format!("initial_file = '{}'", other_shape.display())).run(),
        ),
        refused("SystemTableError::TwoStarts", from("initial.tilt = 1").run()),
        refused("SystemTableError::OtherStart", from("initial_checksum = 1").run()),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// Tables of inputs in files.
fn of_inputs(folder: &Folder) -> BTreeSet<String> {
    let with = |text: &str, keys: &str| {
        folder.write("u.csv", text);
        let file = folder.path("u.csv");
        let system = "[system]\nalgebra = 'so(3)'\nhamiltonian = 'u*Pi3'\ninitial.Pi = [1, 0, 0]\n";
        let input = format!("[inputs.u]\nfile = '{}'\ninterpolation = 'linear'\n", file.display());
        config(&format!("{system}[integrator]\nend = 1\nstep = 0.1\n{input}{keys}")).run()
    };
    let unnamed = config(
        "[torque]\nPi = [0, 0, 1]\n[inputs.u]\ntimes = [0, 1]\nvalues = [0, 1]\ninterpolation = 'linear'",
    );
    let missing = config(
        "[system]\nalgebra = 'so(3)'\nhamiltonian = 'u*Pi3'\ninitial.Pi = [1, 0, 0]\n\
         [inputs.u]\nfile = 'missing.csv'\ninterpolation = 'linear'",
    );
    assert!(with("t,u\n0,0\n1,1\n", "").is_ok());
    [
        refused("Error::InputFile", missing.run()),
        refused("InputFileError::Read", missing.run()),
        refused("InputFileError::Changed", with("t,u\n0,0\n1,1\n", "checksum = 1")),
        refused("InputFileError::NoColumn", with("t,u\n0,0\n1,1\n", "value = 'v'")),
        refused("InputFileError::NoCell", with("t,u\n0,0\n1\n", "")),
        refused("InputFileError::NoNumber", with("t,u\n0,0\n1,x\n", "")),
        refused("InputFileError::NotIncreasing", with("t,u\n0,0\n1,1\n1,2\n", "")),
        refused("InputFileError::Table", with("t,u\n0,0\n0.5,1\n", "")),
        refused("SystemTableError::UnnamedInput", unnamed.run()),
        refused("SystemTableError::TwoTables", with("t,u\n0,0\n1,1\n", "times = [0]")),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// TOML has no integers of more than 63 bits.
fn config_of_too_large_a_number() -> Config {
    let mut config = Config::default();
    config.output.every = u64::MAX;
    config
}

fn of_numbers(folder: &Folder) -> BTreeSet<String> {
    let watch = Watch::default();
    let compared = |text: &str, end| compare(&config(text), &folder.path("made"), end, &watch);
    let failing = "integrator = { step = 0.5, scheme = 'lobatto-iiia-iiib-4' }";
    let failed = simulate(&config(failing), &folder.path("a.csv"), &SimulateOptions::default());
    let experiment = Config::default().experiment().unwrap();
    let no_saved = Saved { step: 1024, state: vec![0.0] };
    // Without Γ there is no spinor.
    let no_start = heavytop_cli::runs::Experiment { start: vec![0.0; 6], ..experiment };
    [
        refused("Error::Argument", compared("", Some(0.0))),
        refused("Error::Reference", compared("integrator = { step = 0.8, end = 80 }", None)),
        refused("Error::Run", failed),
        refused("Error::Run", config(LOGARITHM).run().unwrap().follow(None, ignore)),
        refused("Error::Run", Config::default().run().unwrap().follow(Some(&no_saved), ignore)),
        refused("Error::Start", no_start.run(|_, _, _, _| Ok(()))),
        refused("Error::Configuration", timed(folder, "2 2 1 1 0 0 1 20\n", "Gauss-12")),
        refused("Error::NoContestant", timed(folder, &problem("4"), "Gaus-12")),
        refused("Error::Run", timed(folder, &problem("1e200"), "Gauss-12")),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// A system whose coordinate y grows as eᵗ, beyond the logarithm of its energy.
const LOGARITHM: &str = "[system]\ncoordinates = ['x', 'y']\nbrackets = { 'x, y' = 'y' }\n\
    hamiltonian = 'x + 1e-9*ln(2 - y)'\ninitial = { x = 0, y = 1 }\n\
    [integrator]\nformulation = 'direct'\nscheme = 'rk4'\nstep = 0.1\nend = 1\n";

/// Returns the file of a problem whose top turns so fast.
fn problem(speed: &str) -> String {
    let state = format!("0 0 {speed} 0 0 1 ");
    format!("2 2 1 1 0 0 1 20\n{}\n", state.repeat(3))
}

fn ignore(_: &Moment<'_>) -> Result<(), Error> {
    Ok(())
}

fn timed(folder: &Folder, problem: &str, only: &str) -> Result<Bench, Error> {
    folder.write("problem.txt", problem);
    let options = BenchOptions { only: Some(only.into()), tops: 2, threads: 1 };
    bench(&Config::default(), Some(&folder.path("problem.txt")), options, true)
}

fn of_others(folder: &Folder) -> BTreeSet<String> {
    let out = folder.path("swept");
    let small = "sweep.axes = [{ parameter = 'body.mass', from = 1, to = 2, count = 2 }]";
    let swept = || sweep(&config(small), &out, &TileOptions::default());
    fs::create_dir_all(out.join("sweep.partial/0000000")).unwrap();
    let mut found = refused("Error::Tile", swept());
    assert!(found.contains("Error::Resumable"), "{found:?}");
    found.extend(without_threads(folder));
    found
}

/// The stacks of so many threads do not fit into so little address space.
fn without_threads(folder: &Folder) -> [String; 2] {
    let fails = |arguments: &str, code, expected: &str| {
        let script = format!("ulimit -v 1000000; exec \"$0\" sweep --out swept {arguments}");
        let mut command = Command::new("sh");
        command.args(["-c", &script, heavytop()]);
        command.env("RAYON_NUM_THREADS", "1024").current_dir(folder.path("."));
        // Stacks so large that what does not fit is one of them, and not a small allocation beside it.
        command.env("RUST_MIN_STACK", (64 << 20).to_string());
        let run = Finished::of(command.output().unwrap());
        assert!(run.stderr().starts_with(expected), "{}", run.stderr());
        assert_eq!(run.code(), code);
    };
    fails("--threads 1024", 2, "heavytop: cannot start 1024 thread(s): ");
    fails("", 1, "heavytop: cannot start threads, of which RAYON_NUM_THREADS sets the number: ");
    ["Error::Threads".into(), "Error::Workers".into()]
}
