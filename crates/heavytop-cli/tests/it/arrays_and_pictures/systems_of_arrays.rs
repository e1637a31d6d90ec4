//! Systems of arrays: `simulate` has the bits of the library, and its archives are exported, drawn and read again.

use crate::program::{Finished, Folder, numbers};
use heavytop::methods::{Formulation, SchemeName};
use lie_poisson_runs::{Arguments, ArrayKind, Experiment, Model, Pace, RunFailure, Schedule};
use std::io::{Read, Write};

/// A system: its kind, its parameters and its start, both as TOML and for the library, and its method.
pub(super) struct Case {
    kind: &'static str,
    parameters: (&'static str, Arguments),
    pub(super) start: (&'static str, Arguments),
    method: (Option<Formulation>, SchemeName),
    columns: &'static str,
}

pub(super) fn cases() -> [Case; 4] {
    let new = Arguments::new;
    let strengths: Vec<f64> = (0..50).map(|i| 0.005 + 0.001 * f64::from(i)).collect();
    [
        Case {
            kind: "spin-lattice",
            parameters: (
                "shape = [2, 3], exchange = [1, 0.5], field = [0, 0, 0.2]",
                new()
                    .list("shape", vec![2.0, 3.0])
                    .list("exchange", vec![1.0, 0.5])
                    .list("field", vec![0.0, 0.0, 0.2]),
            ),
            start: ("tilt = 0.5, seed = 3", new().number("tilt", 0.5).number("seed", 3.0)),
            method: (Some(Formulation::Reduced), SchemeName::SphericalMidpoint),
            columns: "S_1_1,S_1_2,S_1_3,S_2_1",
        },
        Case {
            kind: "vibrating-lattice",
            parameters: (
                "atoms = 3, exchange = 1, coupling = 0.5",
                new().number("atoms", 3.0).number("exchange", 1.0).number("coupling", 0.5),
            ),
            start: (
                "waves = [1], cone = 0.3, p = [0.1, 0, 0]",
                new().list("waves", vec![1.0]).number("cone", 0.3).list("p", vec![0.1, 0.0, 0.0]),
            ),
            method: (None, SchemeName::Gauss(4)),
            columns: "S_1_1,S_1_2,S_1_3",
        },
        Case {
            kind: "sphere-fluid",
            parameters: (
                "size = 4, rotation = 0.1",
                new().number("size", 4.0).number("rotation", 0.1),
            ),
            start: ("degrees = [1, 3]", new().list("degrees", vec![1.0, 3.0])),
            method: (None, SchemeName::ImplicitMidpoint),
            columns: "omega_1_1,omega_1_2",
        },
        Case {
            kind: "vortices",
            parameters: ("STRENGTHS", new().list("strengths", strengths)),
            start: ("seed = 1", new().number("seed", 1.0)),
            method: (None, SchemeName::Gauss(2)),
            columns: "m_1_1,m_1_2,m_1_3",
        },
    ]
}

const PACE: &str = "step = 0.05\nend = 1\n[output]\nevery = 7\n";

pub(super) fn configuration(case: &Case) -> String {
    let (formulation, scheme) = case.method;
    let strengths: Vec<String> =
        (0..50).map(|i| format!("{}", 0.005 + 0.001 * f64::from(i))).collect();
    let strengths = format!("strengths = [{}]", strengths.join(", "));
    let parameters = case.parameters.0.replace("STRENGTHS", &strengths);
    let formulation = formulation.map_or(String::new(), |f| format!("formulation = '{f}'\n"));
    format!(
        "[system]\nkind = '{}'\nparameters = {{ {parameters} }}\ninitial = {{ {} }}\n[integrator]\n\
         {formulation}scheme = '{scheme}'\n{PACE}",
        case.kind, case.start.0
    )
}

pub(super) fn succeeded(done: &Finished) {
    assert_eq!(done.code(), 0, "{}", done.stderr());
}

/// Returns the rows of the library.
fn rows(case: &Case) -> Vec<Vec<f64>> {
    let model = ArrayKind::named(case.kind).unwrap().system(&case.parameters.1).unwrap();
    let start = Model::start(&model, &model.start_of(&case.start.1).unwrap()).unwrap();
    let method = model.method(case.method.0, case.method.1, 0.0).unwrap();
    let pace = Pace { schedule: Schedule::new(0.05, 1.0).unwrap(), every: 7 };
    let run = Experiment { model, start, method, pace, attitude: false };
    let mut rows = Vec::new();
    run.follow(None, |moment| -> Result<(), RunFailure> {
        rows.push(moment.row.to_vec());
        Ok(())
    })
    .unwrap();
    rows
}

#[test]
fn rows_have_the_bits_of_the_library() {
    assert_eq!(cases().len(), ArrayKind::ALL.len());
    let folder = Folder::new();
    for case in cases() {
        folder.write("a.toml", &configuration(&case));
        succeeded(&folder.heavytop(&["simulate", "a.toml", "--out", "a.csv", "--force"]));
        let (header, found) = numbers(&folder.read("a.csv"));
        assert!(header.join(",").starts_with(&format!("t,{}", case.columns)), "{header:?}");
        assert_eq!((found.len(), found), (4, rows(&case)), "{}", case.kind);
    }
}

/// Reads an array of an archive, of doubles in the order of C, with its shape as text.
pub(super) fn array(archive: &[u8], name: &str) -> (String, Vec<f64>) {
    let mut archive = zip::ZipArchive::new(std::io::Cursor::new(archive)).unwrap();
    let mut bytes = Vec::new();
    let mut file = archive.by_name(&format!("{name}.npy")).unwrap();
    file.read_to_end(&mut bytes).unwrap();
    let length = usize::from(u16::from_le_bytes([bytes[8], bytes[9]]));
    let header = String::from_utf8(bytes[10..10 + length].to_vec()).unwrap();
    let shape = header.split_once("'shape': ").unwrap().1.split_once(", }").unwrap().0;
    let numbers = bytes[10 + length..].as_chunks().0.iter().map(|b| f64::from_le_bytes(*b));
    (shape.to_owned(), numbers.collect())
}

#[test]
fn arrays_have_the_shapes_of_the_field() {
    let folder = Folder::new();
    let shapes = [
        [("S", "(4, 2, 3, 3)"), ("M", "(4,)")],
        [("S", "(4, 3, 3)"), ("q", "(4, 3)")],
        [("omega", "(4, 4, 4)"), ("Z", "(4,)")],
        [("m", "(4, 50, 3)"), ("h", "(4,)")],
    ];
    for (case, expected) in cases().iter().zip(shapes) {
        folder.write("a.toml", &configuration(case));
        succeeded(&folder.heavytop(&["simulate", "a.toml", "--out", "a.npz", "--force"]));
        let archive = std::fs::read(folder.path("a.npz")).unwrap();
        let first = case.columns.split_once('_').unwrap().0;
        for (name, shape) in expected {
            let (found, values) = array(&archive, name);
            assert_eq!(found, shape, "{} {name}", case.kind);
            if name == first {
                let own: Vec<f64> =
                    rows(case).iter().flat_map(|row| row[1..=values.len() / 4].to_vec()).collect();
                assert_eq!(values, own);
            }
        }
    }
}

#[test]
fn runs_are_drawn() {
    let folder = Folder::new();
    for case in cases() {
        folder.write("a.toml", &configuration(&case));
        succeeded(&folder.heavytop(&["simulate", "a.toml", "--out", "a.npz", "--force"]));
        for out in ["a.png", "a.svg"] {
            succeeded(&folder.heavytop(&["plot", "a.npz", "--out", out]));
        }
        assert!(std::fs::read(folder.path("a.png")).unwrap().starts_with(b"\x89PNG"));
        let last = folder.read("a.svg");
        let first = folder.heavytop(&["plot", "a.npz", "--out", "a.svg", "--sample", "0"]);
        // A chain is drawn against time; the others at one time.
        let is_chain = case.kind == "vibrating-lattice";
        assert_eq!(first.code(), if is_chain { 2 } else { 0 }, "{}", first.stderr());
        assert_eq!(folder.read("a.svg") == last, is_chain, "{}", case.kind);
    }
}

#[test]
fn what_cannot_be_drawn_or_exported_is_refused() {
    let folder = Folder::new();
    let cases = cases();
    for (name, case) in [("spins", &cases[0]), ("fluid", &cases[2])] {
        folder.write("a.toml", &configuration(case));
        succeeded(&folder.heavytop(&["simulate", "a.toml", "--out", &format!("{name}.npz")]));
    }
    write_archive(&folder, "foreign.npz", &[("t", "(1,)", vec![0.0])]);
    folder.write("text.npz", "no archive");
    folder.write("foreign.svg", "<svg ");
    std::fs::create_dir(folder.path("taken")).unwrap();
    folder.write("taken/S_000000.ovf", "# OOMMF OVF 2.0\nof another program");
    for (arguments, said) in [
        (&["plot", "missing.npz", "--out", "a.png"][..], "missing.npz: it cannot be read"),
        (&["plot", "text.npz", "--out", "a.png"], "it is no archive of arrays"),
        (&["plot", "foreign.npz", "--out", "a.png"], "it is no archive of simulate"),
        (&["plot", "spins.npz", "--out", "a.jpg"], "must end in .png, .svg or .gif"),
        (&["plot", "spins.npz", "--out", "foreign.svg"], "exists, and is not overwritten"),
        (
            &["plot", "spins.npz", "--out", "a.png", "--sample", "4"],
            "sample must be that of a sample of the run, got 4",
        ),
        (
            &["plot", "spins.npz", "--out", "a.png", "--plane", "1"],
            "plane must be below the number of planes, got 1",
        ),
        (
            &["export", "fluid.npz", "--out", "new", "--format", "vti"],
            "it has no vectors on a lattice",
        ),
        (
            &["export", "spins.npz", "--out", "new", "--format", "vti", "--every", "0"],
            "every must be at least 1",
        ),
        (
            &["export", "spins.npz", "--out", "taken", "--format", "ovf"],
            "exists, and is not overwritten",
        ),
    ] {
        let done = folder.heavytop(arguments);
        assert_eq!(done.code(), 2, "{}", done.stderr());
        assert!(done.stderr().contains(said), "{}", done.stderr());
    }
    assert!(!folder.path("a.png").exists() && !folder.path("new").exists());
    assert_eq!(folder.read("taken/S_000000.ovf"), "# OOMMF OVF 2.0\nof another program");
}

#[test]
fn starts_and_outputs_that_do_not_fit_are_refused_before_anything_is_written() {
    let folder = Folder::new();
    let spins = "[system]\nkind = 'spin-lattice'\nparameters = { shape = [4], exchange = 1 }\n";
    let end = "[integrator]\nend = 0.1\n";
    folder.write("a.toml", &format!("{spins}initial = {{ tilt = 1 }}\n{end}"));
    succeeded(&folder.heavytop(&["simulate", "a.toml", "--out", "four.npz"]));
    folder.write("five.ovf", "# OOMMF OVF 2.0\n# xnodes: 5\n# ynodes: 1\n# znodes: 1\n# valuedim: 3\n# Begin: Data Text\n");
    folder.write("old.ovf", "# OOMMF: rectangular mesh v1.0\n");
    folder.write("few.ovf", "# OOMMF OVF 2.0\n# xnodes: 4\n# ynodes: 1\n# znodes: 1\n# valuedim: 3\n# Begin: Data Text\n1 2 3\n");
    let wide = "[system]\nkind = 'spin-lattice'\nparameters = { shape = [80, 80], exchange = 1 }\ninitial = { tilt = 1 }\n";
    let names_before = folder.names();
    for (text, out, said) in [
        (
            format!("{spins}initial_file = 'missing.npz'\n"),
            "b.csv",
            "missing.npz: it cannot be read",
        ),
        (
            format!("{spins}initial_file = 'a.toml'\n"),
            "b.csv",
            "a start is read from .npz, .npy, .ovf, .omf or .vti",
        ),
        (
            format!("{spins}initial_file = 'five.ovf'\n"),
            "b.csv",
            "the shape of S is [5, 1, 1, 3], not [4, 3]",
        ),
        (format!("{spins}initial_file = 'old.ovf'\n"), "b.csv", "no OVF file of version 2"),
        (format!("{spins}initial_file = 'few.ovf'\n"), "b.csv", "it has 3 numbers, not 12"),
        (
            format!("{spins}initial_file = 'four.npz'\ninitial = {{ tilt = 1 }}\n"),
            "b.csv",
            "initial or initial_file, not both",
        ),
        (
            format!("{}initial_file = 'four.npz'\n", spins.replace("[4]", "[2, 2]")),
            "b.csv",
            "the shape of S is [6, 4, 3], not [2, 2, 3]",
        ),
        (format!("{spins}initial_file = 'four.npz'\n"), "four.npz", "which this command reads"),
        (format!("{spins}initial = {{ tilt = 4 }}\n"), "b.csv", "tilt must be from 0 to pi, got 4"),
        (wide.into(), "b.csv", "CSV has at most 16384 columns here, and the run has 19206"),
        (wide.into(), "b.parquet", "Parquet has at most 16384 columns"),
    ] {
        let done = folder.heavytop_fed(&format!("{text}{end}"), &["simulate", "-", "--out", out]);
        assert_eq!(done.code(), 2, "{text} {}", done.stderr());
        assert!(done.stderr().contains(said), "{said}: {}", done.stderr());
    }
    let done = folder.heavytop(&["section", "a.toml", "--out", "b"]);
    assert_eq!(done.code(), 2);
    assert!(done.stderr().contains("spin-lattice has no section"), "{}", done.stderr());
    assert_eq!(folder.names(), names_before);
    // An archive of the same run is large, and is written.
    let fast = "formulation = 'reduced'\nscheme = 'spherical-midpoint'\n";
    let done =
        folder.heavytop_fed(&format!("{wide}{end}{fast}"), &["simulate", "-", "--out", "b.npz"]);
    succeeded(&done);
}

/// Writes an archive of arrays with these names, shapes and numbers; a shape may lie.
fn write_archive(folder: &Folder, name: &str, arrays: &[(&str, &str, Vec<f64>)]) {
    let mut zip = zip::ZipWriter::new(std::fs::File::create(folder.path(name)).unwrap());
    let options = zip::write::SimpleFileOptions::default();
    for (array, shape, numbers) in arrays {
        zip.start_file(
            format!("{array}.npy"),
            options.compression_method(zip::CompressionMethod::Stored),
        )
        .unwrap();
        let header = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': {shape}, }}\n");
        zip.write_all(b"\x93NUMPY\x01\x00").unwrap();
        zip.write_all(&(header.len() as u16).to_le_bytes()).unwrap();
        zip.write_all(header.as_bytes()).unwrap();
        numbers.iter().for_each(|x| zip.write_all(&x.to_le_bytes()).unwrap());
    }
    zip.finish().unwrap();
}

/// Archives that lie about their sizes take no memory and no time, and no name of an array leads out of the folder.
#[test]
fn archives_that_lie_are_refused() {
    let folder = Folder::new();
    let spins = || vec![0.5; 12];
    for (arrays, said) in [
        (
            vec![("t", "(1,)", vec![0.0]), ("../out", "(1, 4, 3)", spins())],
            "needs a name of letters",
        ),
        (
            vec![("t", "(1,)", vec![0.0]), ("a\"<b>", "(1, 4, 3)", spins())],
            "needs a name of letters",
        ),
        (
            vec![("t", "(1,)", vec![0.0]), ("S", "(1, 0, 99999999999999, 3)", vec![])],
            "no vectors on a lattice",
        ),
        (vec![("t", "(2305843009213693952,)", vec![])], "as many numbers as its header says"),
        (vec![("t", "(1099511627776,)", vec![0.0])], "as many numbers as its header says"),
        (
            vec![("t", "(1,)", vec![0.0]), ("S", "(1, 576460752303423488, 3)", spins())],
            "no vectors on a lattice",
        ),
        (vec![("t", "(1,)", vec![0.0]), ("S", "(1, 5, 3)", spins())], "no vectors on a lattice"),
        (vec![("S", "(1, 4, 3)", spins())], "it has no array t; it has S"),
    ] {
        write_archive(&folder, "lie.npz", &arrays);
        let done = folder.heavytop(&["export", "lie.npz", "--out", "new", "--format", "vti"]);
        assert_eq!(done.code(), 2, "{arrays:?} {}", done.stderr());
        assert!(done.stderr().contains(said), "{said}: {}", done.stderr());
    }
    assert_eq!(folder.names(), ["lie.npz"]);
    // Control: what does not lie is written.
    write_archive(&folder, "true.npz", &[("t", "(1,)", vec![0.0]), ("S", "(1, 4, 3)", spins())]);
    succeeded(&folder.heavytop(&["export", "true.npz", "--out", "new", "--format", "vti"]));
}

/// A run from a file is resumed from another folder, and an archive whose arrays have been replaced is not drawn.
#[test]
fn paths_are_absolute_and_foreign_arrays_are_not_drawn() {
    let folder = Folder::new();
    let text = "[system]\nkind = 'spin-lattice'\nparameters = { shape = [4, 4], exchange = 1 }\n";
    folder.write("a.toml", &format!("{text}initial = {{ tilt = 1 }}\n[integrator]\nend = 0.1\n"));
    succeeded(&folder.heavytop(&["simulate", "a.toml", "--out", "a.npz"]));
    std::fs::create_dir(folder.path("below")).unwrap();
    folder.write(
        "below/b.toml",
        &format!("{text}initial_file = '../a.npz'\n[integrator]\nend = 0.1\n"),
    );
    succeeded(&folder.heavytop(&["simulate", "below/b.toml", "--out", "below/b.npz"]));
    let written = std::fs::read(folder.path("below/b.npz")).unwrap();
    let mut archive = zip::ZipArchive::new(std::io::Cursor::new(written)).unwrap();
    let mut metadata = Vec::new();
    archive.by_name("metadata.npy").unwrap().read_to_end(&mut metadata).unwrap();
    metadata.retain(|byte| *byte != 0);
    let metadata = String::from_utf8_lossy(&metadata).into_owned();
    let stated = folder.path("below/../a.npz").display().to_string();
    assert!(metadata.contains(&stated), "{metadata}");
    std::fs::copy(folder.path("a.npz"), folder.path("cut.npz")).unwrap();
    // The arrays of another run under the metadata of this one.
    let small = text.replace("[4, 4]", "[4, 2]");
    folder.write("c.toml", &format!("{small}initial = {{ tilt = 1 }}\n[integrator]\nend = 0.1\n"));
    succeeded(&folder.heavytop(&["simulate", "c.toml", "--out", "c.npz"]));
    let mut mixed = zip::ZipWriter::new(std::fs::File::create(folder.path("mixed.npz")).unwrap());
    for (from, names) in [("a.npz", &["t.npy", "metadata.npy"][..]), ("c.npz", &["S.npy"])] {
        let mut source =
            zip::ZipArchive::new(std::fs::File::open(folder.path(from)).unwrap()).unwrap();
        for name in names {
            mixed.raw_copy_file(source.by_name(name).unwrap()).unwrap();
        }
    }
    mixed.finish().unwrap();
    let done = folder.heavytop(&["plot", "mixed.npz", "--out", "a.png"]);
    assert!(
        done.code() == 2 && done.stderr().contains("the shape of S is [6, 4, 2, 3]"),
        "{}",
        done.stderr()
    );
    assert!(!folder.path("a.png").exists());
}
