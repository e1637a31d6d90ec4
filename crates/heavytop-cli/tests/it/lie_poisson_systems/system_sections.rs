//! `heavytop section` of a Lie–Poisson system: the points, the picture, given states, interruptions, and refusals.

use crate::program::{Folder, numbers};

/// Kirchhoff's body in a fluid with three different moments and masses, on the level of its initial state.
const BODY: &str = "\
[system]
algebra = 'se(3)'
hamiltonian = '(Pi1^2 + Pi2^2/2 + Pi3^2/3 + Gamma1^2 + Gamma2^2/2 + Gamma3^2/4)/2'
initial = { Pi = [1, 0.5, 0.3], Gamma = [0.6, 0, 0.8] }

[section]
surface = 'Gamma3'
starts = 5
crossings = 20

[integrator]
step = 0.1
";

/// h, Π·Γ and |Γ|² of a row.
fn invariants(row: &[f64]) -> [f64; 3] {
    let (pi, gamma) = (&row[3..6], &row[6..9]);
    let weighted = |v: &[f64], w: [f64; 3]| -> f64 {
        v.iter().zip(w).map(|(x, w)| x * x / w).sum::<f64>() / 2.0
    };
    let dot = |a: &[f64], b: &[f64]| -> f64 { a.iter().zip(b).map(|(a, b)| a * b).sum() };
    let h = weighted(pi, [1.0, 2.0, 3.0]) + weighted(gamma, [1.0, 2.0, 4.0]);
    [h, dot(pi, gamma), dot(gamma, gamma)]
}

#[test]
#[ignore = "long"]
fn the_points_are_on_the_level_and_on_the_surface() {
    let folder = Folder::new();
    folder.write("body.toml", BODY);
    let run = folder.heavytop(&["section", "body.toml", "--out", "here"]);
    assert_eq!((run.code(), run.complaints().as_str()), (0, ""));
    assert!(
        run.stdout().contains("105 points of 5 starts, by reduced, gauss-8"),
        "{}",
        run.stdout()
    );
    let (header, rows) = numbers(&folder.read("here/section.csv"));
    assert_eq!(header.join(","), "start,crossing,t,Pi1,Pi2,Pi3,Gamma1,Gamma2,Gamma3,x,y");
    assert_eq!(rows.len(), 5 * 21);
    let level = invariants(&[0.0, 0.0, 0.0, 1.0, 0.5, 0.3, 0.6, 0.0, 0.8]);
    for orbit in rows.chunks(21) {
        for (number, row) in orbit.iter().enumerate() {
            assert_eq!((row[0], row[1]), (orbit[0][0], number as f64));
            assert!(row[8].abs() < 1e-14, "{row:?}");
            // The energy is conserved to order 8 in the step, the Casimirs to rounding.
            let [h, c1, c2] = invariants(row);
            assert!((h - level[0]).abs() < 1e-10, "{h} {}", level[0]);
            assert!((c1 - level[1]).abs() < 1e-12 && (c2 - level[2]).abs() < 1e-12);
            assert_eq!((row[9], row[10]), (row[3], row[4]));
        }
        assert!(orbit.is_sorted_by(|a, b| a[2] < b[2]));
    }
    // Control: another energy gives another level.
    let energy = ["section", "body.toml", "--out", "other", "--set", "section.energy=1"];
    assert_eq!(folder.heavytop(&energy).code(), 0);
    let (_, rows) = numbers(&folder.read("other/section.csv"));
    assert!(rows.iter().all(|row| (invariants(row)[0] - 1.0).abs() < 1e-10));
    assert!((level[0] - 1.0).abs() > 0.1);
    assert!(std::fs::read(folder.path("here/section.png")).unwrap().starts_with(b"\x89PNG"));
    assert!(folder.read("here/section.svg").starts_with("<svg"));
    assert!(run.stdout().contains("largest deviations: h "), "{}", run.stdout());
}

#[test]
#[ignore = "long"]
fn given_states_are_followed_to_the_surface() {
    let folder = Folder::new();
    let states = "axes = ['Pi1 + Pi2', 'Pi3']\nstates = [{ Pi = [1, 0.5, 0.3], Gamma = [0.6, 0, 0.8] }, \
                  { Pi = [0.8, 0.7, 0.2], Gamma = [0.5, 0.2, 0.7] }]\n[integrator]";
    folder.write("body.toml", &BODY.replace("[integrator]", states));
    let run = folder.heavytop(&["section", "body.toml", "--out", ".", "--json"]);
    assert_eq!(run.code(), 0, "{}", run.stderr());
    let (_, rows) = numbers(&folder.read("section.csv"));
    assert_eq!(rows.len(), 2 * 21);
    assert!(rows.iter().all(|row| row[8].abs() < 1e-14 && row[9] == row[3] + row[4]));
    // Each state has its own level.
    let level = |row: &[f64]| invariants(&[&[0.0; 3], row].concat());
    let expected = [level(&[1.0, 0.5, 0.3, 0.6, 0.0, 0.8]), level(&[0.8, 0.7, 0.2, 0.5, 0.2, 0.7])];
    for (orbit, expected) in rows.chunks(21).zip(expected) {
        for (value, expected) in
            orbit.iter().flat_map(|row| invariants(row)).zip(expected.repeat(21))
        {
            assert!((value - expected).abs() < 1e-10, "{value} {expected}");
        }
    }
    assert!((expected[0][0] - expected[1][0]).abs() > 0.1);
}

/// An angle as a surface: each level is passed once per turn, and the jump of atan2 does not count.
#[test]
#[ignore = "long"]
fn a_surface_may_be_an_angle_and_a_state_on_it_is_its_first_crossing() {
    let folder = Folder::new();
    // A Lagrange top that turns about the vertical and about its axis.
    let top = "\
[system]
algebra = 'se(3)'
hamiltonian = '(Pi1^2 + Pi2^2 + Pi3^2/0.6)/2 + Gamma3'
[section]
surface = 'atan2(Gamma2, Gamma1)'
direction = 'DIRECTION'
level = LEVEL
axes = ['Pi1', 'Pi2']
states = [{ Pi = [0.3, 0, 2.0], Gamma = [0.6, 0, 0.8] }]
crossings = 6
longest = 60
[integrator]
step = 0.05
";
    let mut counts = Vec::new();
    for (level, direction) in [
        ("0.0", "up"),
        ("0.0", "down"),
        ("3.141592653589793", "both"),
        ("7.0", "down"),
        ("-3.0", "down"),
    ] {
        let out = format!("out{}", counts.len());
        folder.write("top.toml", &top.replace("LEVEL", level).replace("DIRECTION", direction));
        let run = folder.heavytop(&["section", "top.toml", "--out", &out]);
        if run.code() != 0 {
            // In this direction the angle never passes its level.
            assert!(run.stderr().contains("does not cross the surface"), "{}", run.stderr());
            counts.push((direction, 0, false));
            continue;
        }
        let (_, rows) = numbers(&folder.read(&format!("{out}/section.csv")));
        let level: f64 = level.parse().unwrap();
        for row in &rows {
            let difference = row[7].atan2(row[6]) - level;
            assert!((0.5 * difference).sin().abs() < 1e-13, "{row:?}");
        }
        let is_given = rows[0][3..9] == [0.3, 0.0, 2.0, 0.6, 0.0, 0.8];
        counts.push((direction, rows.len(), is_given));
    }
    // Γ turns in one direction, downwards. The state lies on the level 0.
    let expected = [
        ("up", 0, false),
        ("down", 7, true),
        ("both", 7, false),
        ("down", 7, false),
        ("down", 7, false),
    ];
    assert_eq!(counts, expected);
}

#[test]
#[ignore = "long"]
fn an_interrupted_section_of_a_system_continues_byte_for_byte() {
    use heavytop_cli::commands::section::section;
    use heavytop_cli::configuration::Config;
    use heavytop_cli::supervision::TileOptions;
    use std::sync::atomic::AtomicBool;
    let folder = Folder::new();
    let mut config: Config = toml::from_str(BODY).unwrap();
    // A tile has some 256 returns.
    config.section.as_mut().unwrap().crossings = 60;
    let run = |name: &str, options: &TileOptions<'_>| section(&config, &folder.path(name), options);
    let whole = run("whole", &TileOptions::default()).unwrap();
    let stop = AtomicBool::new(true);
    let stopped = run("parts", &TileOptions { stop: Some(&stop), ..TileOptions::default() });
    assert_eq!(stopped.unwrap_err().exit_code(), 130);
    assert!(folder.path("parts/section.partial").exists());
    let resumed = run("parts", &TileOptions { resume: true, ..TileOptions::default() }).unwrap();
    assert_eq!((resumed.points, &resumed.deviations), (whole.points, &whole.deviations));
    for file in ["section.csv", "section.parquet", "section.svg", "section.png"] {
        let read = |name: &str| std::fs::read(folder.path(name).join(file)).unwrap();
        assert_eq!(read("parts"), read("whole"), "{file}");
    }
}

#[test]
fn a_dry_run_of_a_section_of_a_system_tells_the_rows() {
    let folder = Folder::new();
    folder.write("body.toml", BODY);
    let run = folder.heavytop(&["section", "body.toml", "--out", "here", "--dry-run"]);
    assert_eq!(run.code(), 0, "{}", run.stderr());
    assert!(run.stdout().contains("5 starts, at most 105 points"), "{}", run.stdout());
    assert_eq!(folder.names(), ["body.toml"]);
}

#[test]
#[ignore = "long"]
fn wrong_sections_of_systems_are_refused_and_nothing_is_written() {
    let folder = Folder::new();
    folder.write("body.toml", BODY);
    let top = "[section]\naxes = ['Pi1', 'Pi2']\n";
    folder.write("top.toml", top);
    let is_refused = |file: &str, set: &[&str], message: &str| {
        let set = set.iter().flat_map(|set| ["--set", set]);
        let arguments: Vec<&str> =
            ["section", file, "--out", "out"].into_iter().chain(set).collect();
        let run = folder.heavytop(&arguments);
        assert_eq!(run.code(), 2, "{}", run.stderr());
        assert!(run.stderr().contains(message), "{}", run.stderr());
        assert_eq!(folder.names(), ["body.toml", "top.toml"]);
    };
    is_refused(
        "body.toml",
        &["section.surface='Gama3'"],
        "there is no `Gama3`; did you mean `Gamma3`?",
    );
    is_refused("body.toml", &["section.axes=['Pi1', 'Pi4']"], "[section] axes: there is no `Pi4`");
    is_refused(
        "body.toml",
        &["section.level=2"],
        "of 5000 guesses 0 lead to a state of the section",
    );
    is_refused("body.toml", &["section.level=nan"], "the level must be a finite number");
    is_refused(
        "body.toml",
        &["section.vertical_momentum=1"],
        "vertical_momentum is of the section of a top",
    );
    is_refused(
        "top.toml",
        &[],
        "top.toml, line 2, column 8: [section] axes is of the section of [system]",
    );
    let far = "section.states=[{ Pi = [0, 0, 1], Gamma = [0, 0, 1] }]";
    is_refused(
        "body.toml",
        &[far, "section.longest=10"],
        "state 1 does not cross the surface within 10 s",
    );
    folder.write("body.toml", &BODY.replace("surface = 'Gamma3'\n", ""));
    is_refused("body.toml", &[], "surface is missing");
}

/// What has no value in one start does not delete what the others have made.
#[test]
fn a_quantity_without_a_value_keeps_the_points_before_it() {
    let folder = Folder::new();
    // Π₂ is −0.995 at the fourth crossing, and above −0.9 before.
    let axes = "axes = ['ln(Pi2 + 0.9)', 'Pi1']\nstates = [{ Pi = [1, 0.5, 0.3], Gamma = [0.6, 0, 0.8] }]\n[integrator]";
    let text = BODY.replace("[integrator]", axes);
    folder.write("body.toml", &text);
    let run = folder.heavytop(&["section", "body.toml", "--out", "here"]);
    let said = run.stderr();
    assert_eq!((run.code(), said.lines().count()), (1, 1), "{said}");
    for part in ["start 1, at t = ", "ln(Pi2 + 0.9) has no value at ", "here/section.csv.partial"] {
        assert!(said.contains(part), "{said}");
    }
    let (_, kept) = numbers(&folder.read("here/section.csv.partial"));
    assert_eq!(kept.len(), 3, "{kept:?}");
    assert!(!folder.path("here/section.partial").exists());
    // They are the points of the section with other axes, until Π₂ is too low.
    folder.write("other.toml", &text.replace("ln(Pi2 + 0.9)", "Pi2"));
    assert_eq!(folder.heavytop(&["section", "other.toml", "--out", "other"]).code(), 0);
    let (_, all) = numbers(&folder.read("other/section.csv"));
    assert!(kept.iter().zip(&all).all(|(kept, all)| kept[..9] == all[..9]));
    assert!(all[kept.len()][4] < -0.9, "{all:?}");
}

/// The picture says the Hamiltonian, whose comparisons have a sign of SVG.
#[test]
fn a_hamiltonian_with_a_comparison_is_drawn() {
    let folder = Folder::new();
    folder.write(
        "body.toml",
        "[system]\nalgebra = 'so(3)'\nhamiltonian = 'if(Pi1 < 9, Pi1^2 + 2*Pi2^2 + 3*Pi3^2, 0)'\n\
         initial = { Pi = [1, 0.2, 0.1] }\n\
         [section]\nsurface = 'Pi3'\nstarts = 1\ncrossings = 2\n",
    );
    let run = folder.heavytop(&["section", "body.toml", "--out", "here"]);
    assert_eq!(run.code(), 0, "{}", run.stderr());
    assert!(folder.path("here/section.svg").exists());
}
