//! `heavytop section`: the points, the files, and what is refused.

use crate::program::{Folder, heavytop, numbers};
use heavytop::{HeavyTop, Invariant};
use lie_poisson::Se3Dual;
use nalgebra::Vector3;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::RowAccessor;

const SMALL: &str = "[section]\nenergy = 1.5\nvertical_momentum = 0.5\nstarts = 5\ncrossings = 20";

fn state(row: &[f64]) -> Se3Dual {
    Se3Dual::new(Vector3::new(row[3], row[4], row[5]), Vector3::new(row[6], row[7], row[8]))
}

#[test]
#[ignore = "long"]
fn the_points_are_on_level_and_surface_and_on_curves_of_kovalevskaya() {
    let folder = Folder::new();
    folder.write("a.toml", SMALL);
    let run = folder.heavytop(&["section", "a.toml", "--out", "made/here"]);
    assert_eq!((run.code(), run.complaints().as_str()), (0, ""));
    let (header, rows) = numbers(&folder.read("made/here/section.csv"));
    assert_eq!(header.join(","), "start,crossing,t,Pi1,Pi2,Pi3,Gamma1,Gamma2,Gamma3,x,y");
    assert_eq!(rows.len(), 5 * 21);
    let top = HeavyTop::kovalevskaya(1.0, 1.0).unwrap();
    for orbit in rows.chunks(21) {
        let value = |f: Invariant, row: &[f64]| f.value(&top, &state(row));
        for (number, row) in orbit.iter().enumerate() {
            assert_eq!((row[0], row[1]), (orbit[0][0], number as f64));
            assert!(row[8].abs() < 1e-15, "{row:?}");
            assert!((value(Invariant::Energy, row) - 1.5).abs() < 1e-11);
            assert!((value(Invariant::VerticalMomentum, row) - 0.5).abs() < 1e-12);
            let k = Invariant::Kovalevskaya;
            assert!((value(k, row) - value(k, &orbit[0])).abs() < 1e-9);
            assert_eq!(
                (row[9], row[10]),
                (row[7].atan2(row[6]).rem_euclid(std::f64::consts::TAU), row[5])
            );
        }
        assert!(orbit.is_sorted_by(|a, b| a[2] < b[2]));
    }
    // Control: K differs from start to start.
    let k: Vec<f64> =
        (0..5).map(|n| Invariant::Kovalevskaya.value(&top, &state(&rows[21 * n]))).collect();
    assert!(k.windows(2).all(|pair| (pair[0] - pair[1]).abs() > 1e-3), "{k:?}");
    assert!(folder.read("made/here/section.svg").starts_with("<svg"));
    assert!(std::fs::read(folder.path("made/here/section.png")).unwrap().starts_with(b"\x89PNG"));
    assert!(
        run.stdout().contains("105 points of 5 starts, by reduced, gauss-8"),
        "{}",
        run.stdout()
    );
}

#[test]
#[ignore = "long"]
fn no_bit_depends_on_the_number_of_threads() {
    let folder = Folder::new();
    folder.write("a.toml", SMALL);
    for threads in ["1", "2", "5"] {
        let run = folder.heavytop_on(threads, &["section", "a.toml", "--out", threads]);
        assert_eq!(run.code(), 0, "{}", run.stderr());
    }
    folder.write("b.toml", &format!("{SMALL}\nseed = 1"));
    assert_eq!(folder.heavytop(&["section", "b.toml", "--out", "other"]).code(), 0);
    for file in ["section.csv", "section.svg", "section.png"] {
        let read = |name: &str| std::fs::read(folder.path(name).join(file)).unwrap();
        assert!(read("1") == read("2") && read("1") == read("5"), "{file}");
        // Control: other starts give other bytes.
        assert!(read("1") != read("other"), "{file}");
    }
}

#[test]
fn surface_direction_and_integrator_are_those_of_the_configuration() {
    let folder = Folder::new();
    let integrator = "integrator = { formulation = 'splitting', scheme = 'suzuki-4', step = 0.05 }";
    let section = "surface = 'Pi1', level = 0.25, direction = 'down', starts = 3, crossings = 4";
    // The level is that of [initial], where h = 11.75.
    folder.write("a.toml", &format!("{integrator}\nsection = {{ {section} }}"));
    let run = folder.heavytop(&["section", "a.toml", "--out", "."]);
    assert_eq!(run.code(), 0, "{}", run.stderr());
    assert!(run.stdout().starts_with("h = 11.75 J"), "{}", run.stdout());
    assert!(run.stdout().contains("by splitting, suzuki-4, step 5.000e-2 s"), "{}", run.stdout());
    let (_, rows) = numbers(&folder.read("section.csv"));
    assert_eq!(rows.len(), 15);
    assert!(rows.iter().all(|row| (row[3] - 0.25).abs() < 1e-14 && row[10] == row[6]));
}

/// A surface may be the angle of Γ about an axis: it is passed at its level up to turns of 2π, and never at the jump of
/// atan2. The plane has the inclination and its momentum.
#[test]
#[ignore = "long"]
fn a_surface_of_a_top_may_be_an_angle() {
    let folder = Folder::new();
    let level = std::f64::consts::PI;
    for (name, axis, level) in [
        ("atan2(Gamma2, Gamma1)", 2, level),
        ("atan2(Gamma1,Gamma3)", 1, 0.5),
        ("atan2(Gamma3, Gamma2)", 0, -2.0 - 2.0 * level),
    ] {
        let surface = format!("surface = '{name}'\nlevel = {level:?}\ndirection = 'both'");
        folder.write("a.toml", &format!("{SMALL}\n{surface}"));
        let run = folder.heavytop(&["section", "a.toml", "--out", "."]);
        assert_eq!((run.code(), run.complaints().as_str()), (0, ""));
        let (_, rows) = numbers(&folder.read("section.csv"));
        assert_eq!(rows.len(), 105, "{name}");
        let mut seen = [false; 2];
        for row in &rows {
            let mu = state(row);
            let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
            let gamma = mu.0.1;
            let difference = gamma[k].atan2(gamma[j]) - level;
            assert!((0.5 * difference).sin().abs() < 1e-14, "{name}: {row:?}");
            assert!((gamma[axis].acos() - row[9]).abs() < 1e-7, "{name}: {row:?}");
            let node = Vector3::ith(axis, 1.0).cross(&gamma).normalize();
            assert!((mu.0.0.dot(&node) - row[10]).abs() < 1e-12, "{name}: {row:?}");
            let omega = HeavyTop::kovalevskaya(1.0, 1.0).unwrap().angular_velocity(&mu.0.0);
            seen[usize::from(gamma.cross(&omega).dot(&node) > 0.0)] = true;
        }
        assert_eq!(seen, [true; 2], "{name}: both directions count");
    }
    // Control: what is no angle about an axis is refused, with the names of those that are.
    folder.write("a.toml", "section.surface = 'atan2(Gamma1, Gamma2)'");
    let run = folder.heavytop(&["section", "a.toml", "--out", "."]);
    assert_eq!(run.code(), 2);
    assert!(run.stderr().contains("there are Pi1, Pi2, Pi3, Gamma1"), "{}", run.stderr());
    assert!(run.stderr().contains("atan2(Gamma2, Gamma1)"), "{}", run.stderr());
}

#[test]
fn starts_that_do_not_return_are_counted() {
    let folder = Folder::new();
    folder.write("a.toml", &format!("{SMALL}\nlongest = 20.0"));
    let run = folder.heavytop(&["section", "a.toml", "--out", "."]);
    assert_eq!(run.code(), 0, "{}", run.stderr());
    assert!(
        run.stdout().contains("5 starts have fewer than 20 returns in 20 s"),
        "{}",
        run.stdout()
    );
}

#[test]
fn wrong_requests_are_refused_and_nothing_is_written() {
    for (text, message) in [
        (
            "section.energy = -1.5\nsection.vertical_momentum = 0",
            "[section] no state of the section has an energy of -1.5 J: the least is -1",
        ),
        (
            "section.level = 1.0",
            "the level of Gamma3 must be more than -1 and less than 1, got 1.0\n",
        ),
        ("section.level = 1e308", "must be more than -1 and less than 1, got 1e308\n"),
        ("section.energy = nan", "[section] energy must be a finite number, got NaN"),
        (
            "[section]\nsurface = 'Pi4'",
            "line 2, column 11: section.surface: unknown surface `Pi4`; there are Pi1, Pi2, Pi3, Gamma1, Gamma2, Gamma3, atan2(Gamma3, Gamma2), ",
        ),
        ("section.direction = 'left'", "unknown direction `left`; there are up, down, both"),
        ("section.start = 3", "unknown key `start`"),
        ("section.starts = 0", "starts must be at least 1, got 0"),
        ("section.crossings = 0", "crossings must be at least 1, got 0"),
        (
            "section = { starts = 100000, crossings = 100000 }",
            "starts × crossings must be at most 1e7",
        ),
        ("section.longest = 0", "longest must be positive and finite, got 0"),
        ("section.longest = 1e300", "more than 1e12"),
        ("integrator.step = 0", "step must be finite and different from 0, got 0"),
        ("integrator = { step = -0.1, end = 10 }", "do not reach end = 10"),
        ("integrator.step = 100", "turns the motion by about"),
        ("body.mass = 0", "[body] mass must be positive"),
    ] {
        let folder = Folder::new();
        folder.write("a.toml", text);
        let run = folder.heavytop(&["section", "a.toml", "--out", "made"]);
        assert_eq!(run.code(), 2, "{text}: {}", run.stderr());
        assert!(run.stderr().contains(message), "{text}: {}", run.stderr());
        assert_eq!((run.messages(), folder.names()), (1, vec!["a.toml".into()]));
    }
}

#[test]
fn a_step_that_fails_ends_the_run_and_keeps_what_there_is() {
    let folder = Folder::new();
    folder.write(
        "a.toml",
        "integrator = { step = 0.5, formulation = 'collective', scheme = 'lobatto-iiia-iiib-4' }\n\
         section.starts = 3",
    );
    let run = folder.heavytop(&["section", "a.toml", "--out", "."]);
    assert_eq!(run.code(), 1, "{}", run.stderr());
    let said = run.stderr();
    for part in [
        "collective, lobatto-iiia-iiib-4, start 1: step ",
        "did not converge",
        "section.csv.partial",
    ] {
        assert!(said.contains(part), "{said}");
    }
    assert_eq!(folder.names(), ["a.toml", "section.csv.partial"]);
    assert!(!numbers(&folder.read("section.csv.partial")).1.is_empty());
}

#[test]
#[ignore = "long"]
fn parquet_has_the_numbers_of_the_csv_and_the_configuration_makes_them_again() {
    let folder = Folder::new();
    // The file contains keys that the configuration leaves out: [integrator] and the energy.
    folder.write("a.toml", "section = { starts = 40, crossings = 4, direction = 'both' }");
    assert_eq!(folder.heavytop(&["section", "a.toml", "--out", "a"]).code(), 0);
    let (header, expected) = numbers(&folder.read("a/section.csv"));
    let file = std::fs::File::open(folder.path("a/section.parquet")).unwrap();
    let reader = SerializedFileReader::new(file).unwrap();
    let about = reader.metadata().file_metadata();
    let names: Vec<&str> = about.schema_descr().columns().iter().map(|c| c.name()).collect();
    assert_eq!((names.join(","), about.num_rows()), (header.join(","), 200));
    for (row, expected) in reader.get_row_iter(None).unwrap().zip(&expected) {
        let row = row.unwrap();
        let indices = [0, 1].map(|i| row.get_long(i).unwrap() as f64);
        assert_eq!(indices[..], expected[..2]);
        for (i, number) in expected.iter().enumerate().skip(2) {
            assert_eq!(row.get_double(i).unwrap().to_bits(), number.to_bits());
        }
    }
    let pairs = about.key_value_metadata().unwrap();
    let value = |key: &str| pairs.iter().find(|p| p.key == key).unwrap().value.as_deref().unwrap();
    assert_eq!(value("version"), env!("CARGO_PKG_VERSION"));
    let configuration = value("configuration");
    for part in
        ["energy = 11.75\n", "direction = \"both\"\n", "scheme = \"gauss-8\"\n", "seed = 0\n"]
    {
        assert!(configuration.contains(part), "{configuration}");
    }
    folder.write("again.toml", configuration);
    assert_eq!(folder.heavytop(&["section", "again.toml", "--out", "again"]).code(), 0);
    for file in ["section.csv", "section.parquet", "section.svg", "section.png"] {
        let read = |name: &str| std::fs::read(folder.path(name).join(file)).unwrap();
        assert!(read("a") == read("again"), "{file}");
    }
}

#[test]
fn a_folder_in_the_way_is_refused_before_there_is_any_work() {
    for name in ["section.csv", "section.parquet", "section.svg", "section.png"] {
        let folder = Folder::new();
        std::fs::create_dir_all(folder.path(name)).unwrap();
        let run = folder.heavytop(&["section", "--out", "."]);
        assert_eq!(run.code(), 2);
        assert!(run.stderr().contains(&format!("cannot create ./{name}: ")), "{}", run.stderr());
        assert_eq!(folder.names(), [name]);
    }
}

/// A configuration that sets the step alone changes the step alone.
#[test]
fn what_integrator_leaves_out_is_as_without_it() {
    let folder = Folder::new();
    folder.write("a.toml", "integrator.step = 0.125\nsection = { starts = 2, crossings = 2 }");
    let run = folder.heavytop(&["section", "a.toml", "--out", "."]);
    assert_eq!((run.code(), run.complaints()), (0, String::new()));
    assert!(run.stdout().contains("by reduced, gauss-8, step 1.250e-1 s"), "{}", run.stdout());
}

#[test]
#[ignore = "long"]
#[cfg(target_os = "linux")]
fn without_memory_a_section_fails_and_goes_on_once_there_is_some() {
    let folder = Folder::new();
    folder.write("a.toml", "section = { starts = 12, crossings = 20 }");
    let whole = folder.heavytop(&["section", "a.toml", "--out", "whole"]);
    assert_eq!(whole.code(), 0, "{}", whole.stderr());
    // The program with arguments, in so many KB of address space.
    let within = |room: u32, arguments: &str| {
        let heavytop = heavytop();
        let script = format!("ulimit -v {room}; exec {heavytop} {arguments}");
        let mut command = std::process::Command::new("sh");
        command.env("RAYON_NUM_THREADS", "2");
        command.args(["-c", &script]).current_dir(folder.path(".")).output().unwrap()
    };
    // What the program and its libraries need to begin with.
    let mut rooms = (8_000..200_000).step_by(1_000);
    let least = rooms.find(|&room| within(room, "--version").status.success()).unwrap();
    let mut failed = 0;
    // From too little for the threads to enough for all but the picture. Without memory Rust ends a program as by a kill.
    for room in [0, 8_000, 80_000].map(|more| least + more) {
        if !within(room, "section a.toml --out cut").status.success() {
            failed += 1;
            let begun = folder.path("cut/section.partial/identity").exists();
            let option = if begun { "--resume" } else { "--restart" };
            let run = folder.heavytop(&["section", "a.toml", "--out", "cut", option]);
            assert_eq!((run.code(), run.complaints()), (0, String::new()), "{room}");
        }
        for file in ["section.csv", "section.parquet", "section.svg", "section.png"] {
            let read = |name: &str| std::fs::read(folder.path(name).join(file)).unwrap();
            assert!(read("whole") == read("cut"), "{room}: {file}");
        }
        std::fs::remove_dir_all(folder.path("cut")).unwrap();
    }
    assert!(failed > 0, "there was always memory enough");
}

/// Each warning has a line of its own.
#[test]
fn two_warnings_are_two_lines() {
    let folder = Folder::new();
    folder.write(
        "a.toml",
        "body = { inertia = [2e-4, 2e-4, 3e-4], mass = 0.5, gravity = 9.81, length = 0.04, center_of_mass = [0, 0, 1] }\n\
         initial = { angular_momentum = [0, 0, 0.03], vertical = [0.6, 0, 0.8] }\n\
         integrator = { formulation = 'collective', scheme = 'stormer-verlet', step = 1e-3, end = 0.01 }\n\
         section = { starts = 1, crossings = 1, longest = 0.1 }\n\
         sweep = { observables = ['final-state'], axes = \
         [{ parameter = 'initial.angular_momentum[0]', from = 0, to = 1e-3, count = 2 }] }",
    );
    for command in ["section", "sweep"] {
        let run = folder.heavytop(&[command, "a.toml", "--out", command]);
        let said = run.stderr();
        let of = |part: &str| said.lines().filter(|line| line.contains(part)).collect::<Vec<_>>();
        let (scheme, body) = (of("does not descend"), of("no body has these moments"));
        assert_eq!((scheme.len(), body.len()), (1, 1), "{command}: {said}");
        assert_ne!(scheme, body, "{command}");
        assert!(body[0].starts_with("heavytop: warning: [body]"), "{command}: {said}");
    }
}

/// The limits of the picture leave the tables alone; those that are no range are refused, and nothing is written.
#[test]
fn limits_cut_the_picture_alone() {
    let folder = Folder::new();
    for (name, limits) in [("all", ""), ("cut", "limits = { x = [-1, 1], y = [0, 0.5] }")] {
        folder.write("a.toml", &format!("{SMALL}\n{limits}"));
        let run = folder.heavytop(&["section", "a.toml", "--out", name]);
        assert_eq!(run.code(), 0, "{}", run.stderr());
    }
    assert_eq!(folder.read("all/section.csv"), folder.read("cut/section.csv"));
    // A point is a line of almost no length with round ends, in a path for each start.
    let drawn = |name: &str| {
        let svg = folder.read(&format!("{name}/section.svg"));
        let dots = svg.lines().filter(|line| line.contains("stroke-linecap=\"round\""));
        dots.map(|line| line.matches("M ").count()).sum::<usize>()
    };
    let (_, rows) = numbers(&folder.read("all/section.csv"));
    let turn = std::f64::consts::TAU;
    let is_inside = |row: &&Vec<f64>| {
        let x = if row[9] > turn / 2.0 { row[9] - turn } else { row[9] };
        (-1.0..=1.0).contains(&x) && (0.0..=0.5).contains(&row[10])
    };
    let inside = rows.iter().filter(is_inside).count();
    // Control: some points are inside, and some are not.
    assert!(inside > 0 && inside < rows.len(), "{inside}");
    assert_eq!((drawn("all"), drawn("cut")), (rows.len(), inside));

    let needs = [
        ("y = [1, -1]", "y must be two numbers, the second above the first, got [1, -1]"),
        ("x = [0, inf]", "x must be two finite numbers, got [0, inf]"),
        ("x = [0, 7]", "x must be at most 2π apart, since x is an angle, got [0, 7]"),
    ];
    for (limits, message) in needs {
        folder.write("a.toml", &format!("{SMALL}\nlimits = {{ {limits} }}"));
        let run = folder.heavytop(&["section", "a.toml", "--out", "refused"]);
        assert_eq!(run.code(), 2);
        assert!(run.stderr().contains(&format!("[section] limits.{message}")), "{}", run.stderr());
        assert!(!folder.path("refused").exists());
    }
}
