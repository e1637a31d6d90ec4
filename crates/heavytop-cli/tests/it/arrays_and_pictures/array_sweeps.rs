//! `heavytop sweep` of systems of arrays, and of starts that are no coordinates: rows as of `simulate`, and refusals.

use crate::commands::sweep::{column, rows};
use crate::program::{Folder, numbers};

/// A chain with open ends, over strengths of the anisotropy and cones of its wave.
const CHAIN: &str = "\
[system]
kind = 'spin-lattice'
parameters = { shape = [6], exchange = 1, periodic = 0, anisotropy = 0.2 }
initial = { direction = [0, 0, 1], waves = [1], cone = 0.3 }

[sweep]
observables = ['final-state', 'invariant-drift']
axes = [{ parameter = 'system.parameters.anisotropy', from = 0.1, to = 0.3, count = 2 },
        { parameter = 'system.initial.cone', from = 0.2, to = 1, count = 3 }]

[integrator]
step = 0.1
end = 2
";

/// Kirchhoff's ellipse in a strain, over its first semi-axis.
const ELLIPSE: &str = "\
[system]
kind = 'elliptical-vortex'
parameters = { strength = 1, strain = 0.1 }
initial = { a = 2, b = 1, angle = 0.3 }

[sweep]
observables = ['final-state']
axes = [{ parameter = 'system.initial.a', from = 1.5, to = 2.5, count = 3 }]

[integrator]
step = 0.1
end = 2
";

/// Checks that a row of a sweep has the last states of `simulate` with these assignments.
fn is_simulated(text: &str, row: usize, assignments: &[&str], names: &[&str]) {
    let folder = Folder::new();
    folder.write("run.toml", text);
    let swept = folder.heavytop(&["sweep", "run.toml", "--out", "swept"]);
    assert_eq!((swept.code(), swept.complaints().as_str()), (0, ""));
    let set = assignments.iter().flat_map(|assignment| ["--set", *assignment]);
    let arguments = ["simulate", "run.toml", "--out", "run.csv"].into_iter().chain(set);
    let run = folder.heavytop(&arguments.collect::<Vec<_>>());
    assert_eq!(run.code(), 0, "{}", run.stderr());
    let (header, table) = numbers(&folder.read("run.csv"));
    let rows = rows(&folder, "swept/sweep.parquet");
    for name in names {
        let place = header.iter().position(|own| own == name).unwrap();
        let found = column(&rows[row..row + 1], name)[0].unwrap();
        assert_eq!(found, table.last().unwrap()[place], "{name}");
        // Control: another row differs.
        assert_ne!(column(&rows, name)[0].unwrap(), table.last().unwrap()[place]);
    }
}

#[test]
fn a_row_has_the_bits_of_simulate() {
    let set = [
        "system.parameters.anisotropy=0.3",
        "system.initial.cone=1",
        "integrator.formulation='reduced'",
    ];
    is_simulated(CHAIN, 5, &set, &["S_1_1", "S_4_2", "S_6_3"]);
    is_simulated(ELLIPSE, 2, &["system.initial.a=2.5"], &["mu1", "mu3"]);
}

#[test]
fn indicators_need_tangent_vectors_and_starts_their_names() {
    let folder = Folder::new();
    let refused = |text: &str, said: &str| {
        folder.write("run.toml", text);
        let run = folder.heavytop(&["sweep", "run.toml", "--out", "none"]);
        assert!(run.code() == 2 && run.stderr().contains(said), "{}", run.stderr());
        assert!(!folder.path("none").exists());
    };
    let chaotic =
        CHAIN.replace("['final-state', 'invariant-drift']", "['lyapunov', 'megno', 'sali']");
    folder.write("chaos.toml", &chaotic);
    let run = folder.heavytop(&["sweep", "chaos.toml", "--out", "chaos"]);
    assert_eq!(run.code(), 0, "{}", run.stderr());
    // A fluid has tangent vectors in the direct formulation, which a sweep that needs them takes.
    let fluid = "[system]\nkind = 'sphere-fluid'\nparameters = { size = 4 }\ninitial = { degrees = [1, 3], rms = 1 }\n\
                 [sweep]\nobservables = ['megno']\n\
                 axes = [{ parameter = 'system.initial.rms', from = 1, to = 2, count = 2 }]\n\
                 [integrator]\nend = 1\n";
    folder.write("fluid.toml", fluid);
    let run = folder.heavytop(&["sweep", "fluid.toml", "--out", "fluid"]);
    assert!(run.code() == 0 && run.stdout().contains("each by direct"), "{}", run.stderr());
    // A sphere that rotates conserves less: the others have no value.
    let turning = fluid
        .replace("'megno'", "'invariant-drift'")
        .replace("system.initial.rms', from = 1", "system.parameters.rotation', from = 0");
    folder.write("turning.toml", &turning.replace("size = 4", "size = 4, rotation = 0"));
    let run = folder.heavytop(&["sweep", "turning.toml", "--out", "turning"]);
    assert_eq!(run.code(), 0, "{}", run.stderr());
    let table = rows(&folder, "turning/sweep.parquet");
    assert!(column(&table, "drift_h").iter().all(Option::is_some));
    assert_eq!(
        column(&table, "drift_M1").iter().map(Option::is_some).collect::<Vec<_>>(),
        [true, false]
    );
    refused(&(fluid.to_owned() + "formulation = 'reduced'\n"), "in the formulation direct alone");
    refused(
        &CHAIN.replace("initial.cone", "initial.cane"),
        "system.initial has cone, direction, waves",
    );
    refused(&CHAIN.replace("'invariant-drift'", "'relative-drift'"), "relative-drift");
    refused(&ELLIPSE.replace("initial.a'", "initial.c'"), "the coordinates are mu1, mu2, mu3");
}
