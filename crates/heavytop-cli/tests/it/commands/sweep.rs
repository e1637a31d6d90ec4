//! `heavytop sweep`: the table, the heat maps, random axes, and tops that fail.

use crate::program::Folder;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::{Field, Row, RowAccessor};

/// A sweep over 24 × 25 tops, in three tiles.
const GRID: &str = "\
    [sweep]\nobservables = ['megno', 'sali', 'lyapunov', 'final-state', 'invariant-drift', \
    'rotation-number', 'nutation-amplitude']\n\
    axes = [{ parameter = 'body.inertia[1]', from = 1, to = 3, count = 24 }, \
    { parameter = 'initial.angular_momentum[2]', from = 0, to = 4, count = 25 }]\n\
    [integrator]\nformulation = 'reduced'\nscheme = 'gauss-4'\nstep = 0.1\nend = 1.0";

pub fn rows(folder: &Folder, file: &str) -> Vec<Row> {
    let file = std::fs::File::open(folder.path(file)).unwrap();
    let reader = SerializedFileReader::new(file).unwrap();
    reader.get_row_iter(None).unwrap().map(Result::unwrap).collect()
}

/// Returns the values of a column; `None` where a value is null.
pub fn column(rows: &[Row], name: &str) -> Vec<Option<f64>> {
    let cell = |row: &Row| match row.get_column_iter().find(|(key, _)| *key == name).unwrap().1 {
        Field::Double(value) => Some(*value),
        Field::Null => None,
        other => panic!("{other:?}"),
    };
    rows.iter().map(cell).collect()
}

pub fn failures(rows: &[Row]) -> Vec<Option<String>> {
    let cell = |row: &Row| match row.get_column_iter().last().unwrap().1 {
        Field::Str(reason) => Some(reason.clone()),
        _ => None,
    };
    rows.iter().map(cell).collect()
}

#[test]
#[ignore = "long"]
fn no_bit_depends_on_the_number_of_threads_and_maps_are_drawn() {
    let folder = Folder::new();
    folder.write("a.toml", GRID);
    for threads in ["1", "2", "5"] {
        let run = folder.heavytop_on(threads, &["sweep", "a.toml", "--out", threads]);
        assert_eq!((run.code(), run.complaints().as_str()), (0, ""));
        assert!(run.stdout().contains("600 tops, each by reduced, gauss-4"), "{}", run.stdout());
    }
    folder.write("b.toml", &GRID.replace("to = 4,", "to = 4.1,"));
    assert_eq!(folder.heavytop(&["sweep", "b.toml", "--out", "other"]).code(), 0);
    for file in ["sweep.parquet", "megno.svg", "megno.png", "drift_h.png", "Gamma3.svg"] {
        let read = |name: &str| std::fs::read(folder.path(name).join(file)).unwrap();
        assert!(read("1") == read("2") && read("1") == read("5"), "{file}");
        // Control: other tops give other bytes.
        assert!(read("1") != read("other"), "{file}");
    }
    assert!(!folder.path("1/sweep.partial").exists());
    let rows = rows(&folder, "1/sweep.parquet");
    assert_eq!(rows.len(), 600);
    assert!(failures(&rows).iter().all(Option::is_none));
    assert_eq!(column(&rows, "body.inertia[1]")[24..26], [Some(1.0), Some(1.0 + 2.0 / 23.0)]);
    // The Casimirs change by round-off, the energy by the error of the method.
    let drift = |name: &str| column(&rows, name).into_iter().flatten().fold(0.0, f64::max);
    assert!(drift("drift_f1") < 1e-13 && drift("drift_f2") < 1e-12);
    assert!(drift("drift_h") > 1e-9 && drift("drift_h") < 1e-2);
}

/// The last row of `simulate` is the final state of the sweep. Steps with tangent vectors differ from those by rounding errors.
#[test]
#[ignore = "long"]
fn a_top_ends_where_simulate_ends() {
    let folder = Folder::new();
    folder.write("a.toml", &GRID.replace("'megno', 'sali', 'lyapunov', ", ""));
    folder.write("tangents.toml", GRID);
    let integrator = GRID.split_once("[integrator]").unwrap().1;
    let top = "body.inertia = [2, 3, 1]\ninitial.angular_momentum = [2, 3, 4]";
    folder.write("b.toml", &format!("{top}\n[integrator]{integrator}"));
    assert_eq!(folder.heavytop(&["sweep", "a.toml", "--out", "."]).code(), 0);
    let run = folder.heavytop(&["simulate", "b.toml", "--out", "b.csv"]);
    assert_eq!(run.code(), 0, "{}", run.stderr());
    let (_, single) = crate::program::numbers(&folder.read("b.csv"));
    let run = folder.heavytop(&["sweep", "tangents.toml", "--out", "tangents"]);
    assert_eq!(run.code(), 0, "{}", run.stderr());
    let [with_tangents, rows] =
        ["tangents/sweep.parquet", "sweep.parquet"].map(|file| rows(&folder, file));
    let names = ["Pi1", "Pi2", "Pi3", "Gamma1", "Gamma2", "Gamma3"];
    for (name, expected) in names.iter().zip(&single.last().unwrap()[1..7]) {
        let of_sweep = column(&rows, name);
        let near = column(&with_tangents, name)[599].unwrap();
        assert!((near - expected).abs() < 1e-13, "{name}: {near} {expected}");
        assert_eq!(of_sweep[599], Some(*expected), "{name}");
        // Control: another top ends elsewhere.
        assert_ne!(of_sweep[598], Some(*expected), "{name}");
    }
}

#[test]
#[ignore = "long"]
fn tiles_that_are_there_are_used_and_torn_ones_made_again() {
    let folder = Folder::new();
    folder.write("a.toml", GRID);
    assert_eq!(folder.heavytop(&["sweep", "a.toml", "--out", "whole"]).code(), 0);
    // A folder blocks a map that is begun: all tiles are finished, and stay.
    std::fs::create_dir_all(folder.path("cut/megno.svg.partial")).unwrap();
    let stopped = folder.heavytop(&["sweep", "a.toml", "--out", "cut"]);
    assert_eq!(stopped.code(), 1, "{}", stopped.stderr());
    std::fs::remove_dir(folder.path("cut/megno.svg.partial")).unwrap();
    let tile = |n: u32| folder.path(&format!("cut/sweep.partial/000000{n}"));
    let second = std::fs::read_to_string(tile(1)).unwrap();
    std::fs::write(tile(1), &second[..second.len() / 2]).unwrap();
    // A changed number is accepted with its new checksum, and not without it.
    let changed = |n: u32| {
        let text = std::fs::read_to_string(tile(n)).unwrap();
        let (title, rows) = text.split_once('\n').unwrap();
        let rows = format!("7.0{}", &rows[rows.find(',').unwrap()..]);
        (title[..title.len() - 8].to_string(), title.to_string(), rows)
    };
    let (title, _, rows_0) = changed(0);
    let checksum = crc32fast::hash(rows_0.as_bytes());
    std::fs::write(tile(0), format!("{title}{checksum:08x}\n{rows_0}")).unwrap();
    let (_, line, rows_2) = changed(2);
    std::fs::write(tile(2), format!("{line}\n{rows_2}")).unwrap();
    assert_eq!(folder.heavytop(&["sweep", "a.toml", "--out", "cut", "--resume"]).code(), 0);
    let megno = |name: &str| column(&rows(&folder, &format!("{name}/sweep.parquet")), "megno");
    let (whole, cut) = (megno("whole"), megno("cut"));
    assert_eq!((cut[0], &cut[1..]), (Some(7.0), &whole[1..]));
}

/// The table has one top more than a group of rows; the test checks what is written, not the tops.
#[test]
#[ignore = "long"]
fn the_table_goes_by_groups_of_rows() {
    let folder = Folder::new();
    let text = |from: f64, count: u32| {
        format!(
            "sweep.observables = ['final-state']\nsweep.axes = [{{ parameter = \
             'initial.angular_momentum[0]', from = {from}, to = 65536, count = {count} }}]\n\
             [integrator]\nformulation = 'direct'\nscheme = 'explicit-midpoint'\n\
             step = 1e-3\nend = 1e-3"
        )
    };
    folder.write("a.toml", &text(0.0, 65_537));
    let run = folder.heavytop(&["sweep", "a.toml", "--out", "."]);
    // The last top turns by 33 rad in its step.
    assert_eq!((run.code(), run.complaints()), (0, String::new()));
    let worst = "warning: in the worst of 64 that were tried of 65537 tops, the motion turns by about 33 rad";
    assert!(run.stderr().contains(worst), "{}", run.stderr());
    let file = std::fs::File::open(folder.path("sweep.parquet")).unwrap();
    let reader = SerializedFileReader::new(file).unwrap();
    let groups = reader.metadata().row_groups();
    let counts: Vec<i64> = groups.iter().map(|group| group.num_rows()).collect();
    assert_eq!(counts, [1 << 16, 1]);
    // The last top, alone in its group, equals the only top of another sweep.
    folder.write("b.toml", &text(65_536.0, 1));
    assert_eq!(folder.heavytop(&["sweep", "b.toml", "--out", "b"]).code(), 0);
    let alone = &rows(&folder, "b/sweep.parquet")[0];
    let last = reader.get_row_group(1).unwrap().get_row_iter(None).unwrap().next().unwrap();
    let last = last.unwrap();
    assert_eq!((last.get_long(0).unwrap(), alone.get_long(0).unwrap()), (65_536, 0));
    let values = |row: &Row| (1..8).map(|i| row.get_double(i).unwrap()).collect::<Vec<_>>();
    assert_eq!(values(&last), values(alone));
    // Control: the first top has other values.
    let first = reader.get_row_group(0).unwrap().get_row_iter(None).unwrap().next().unwrap();
    assert_ne!(values(&first.unwrap()), values(alone));
}

#[test]
fn tops_that_fail_say_so_and_harm_no_other() {
    let folder = Folder::new();
    let axis = |to: f64, count: u32| {
        format!(
            "sweep.observables = ['final-state', 'rotation-number']\nsweep.axes = [\
             {{ parameter = 'body.inertia[2]', from = 1, to = {to}, count = {count} }}]\n\
             [integrator]\nend = 2.0\nstep = 0.02"
        )
    };
    // I₃ is 1, 2, 3 or 4; 5, 6 and 7 violate the triangle inequality.
    folder.write("a.toml", &axis(7.0, 7));
    folder.write("b.toml", &axis(4.0, 4));
    let run = folder.heavytop(&["sweep", "a.toml", "--out", "a"]);
    assert_eq!(run.code(), 0, "{}", run.stderr());
    assert!(run.stdout().contains("3 failed"), "{}", run.stdout());
    assert_eq!(folder.heavytop(&["sweep", "b.toml", "--out", "b"]).code(), 0);
    let (a, b) = (rows(&folder, "a/sweep.parquet"), rows(&folder, "b/sweep.parquet"));
    let (pi, alone) = (column(&a, "Pi1"), column(&b, "Pi1"));
    assert_eq!((&pi[..4], &pi[4..]), (alone.as_slice(), [None; 3].as_slice()));
    assert!(alone.iter().all(Option::is_some));
    let reasons = failures(&a);
    assert!(reasons[..4].iter().all(Option::is_none));
    assert!(reasons[4..].iter().flatten().filter(|r| r.contains("[body]")).count() == 3);

    // One step does not converge, and another one turns too far.
    folder.write(
        "c.toml",
        "sweep.observables = ['megno']\nsweep.axes = [{ parameter = 'initial.angular_momentum[0]', \
         from = 1, to = 1e4, count = 2 }]\nintegrator = { step = 0.5, end = 5.0 }",
    );
    assert_eq!(folder.heavytop(&["sweep", "c.toml", "--out", "c"]).code(), 0);
    let reasons = failures(&rows(&folder, "c/sweep.parquet"));
    assert!(reasons[1].as_ref().is_some_and(|r| r.contains("turns the motion")), "{reasons:?}");
}

#[test]
fn random_tops_are_the_same_in_a_longer_sweep() {
    let folder = Folder::new();
    let text = |count: u32| {
        format!(
            "[sweep]\nobservables = ['nutation-amplitude']\ncount = {count}\nseed = 3\naxes = [\
             {{ parameter = 'initial.vertical[0]', normal = [0, 1], normalise = true }}, \
             {{ parameter = 'body.mass', uniform = [1, 2] }}]\n[integrator]\nstep = 0.05\nend = 1.0"
        )
    };
    for count in [5, 300] {
        folder.write("a.toml", &text(count));
        let run = folder.heavytop(&["sweep", "a.toml", "--out", &count.to_string()]);
        assert_eq!(run.code(), 0, "{}", run.stderr());
    }
    let (few, many) = (rows(&folder, "5/sweep.parquet"), rows(&folder, "300/sweep.parquet"));
    assert_eq!(few[..], many[..5]);
    assert_ne!(column(&many, "body.mass")[5], column(&many, "body.mass")[6]);
    assert!(failures(&many).iter().all(Option::is_none));
    // The component is that of the unit vector that was run. Before scaling three tenths of the numbers are beyond ±1.
    let component = column(&many, "initial.vertical[0]");
    assert!(component.iter().all(|x| x.is_some_and(|x| x.abs() < 1.0)), "{component:?}");
    // A sweep without a plane has no map.
    assert!(!folder.path("5/nutation_amplitude.svg").exists());
}

#[test]
fn wrong_requests_are_refused_and_nothing_is_written() {
    let axis = "parameter = 'body.mass', from = 1, to = 2, count = 3";
    let axes = |axes: &str| format!("sweep.axes = [{axes}]");
    for (text, message) in [
        (axes(""), "[sweep] axes must have at least one axis"),
        (
            axes("{ parameter = 'body.weight', uniform = [1, 2] }"),
            "unknown parameter `body.weight`",
        ),
        (axes("{ parameter = 'body.mass', from = 1, to = 2 }"), "needs either from, to and count"),
        (
            axes("{ parameter = 'body.mass', from = 1, to = nan, count = 3 }"),
            "finite numbers, got NaN",
        ),
        (
            axes("{ parameter = 'body.mass', from = 1, to = 2, count = 0 }"),
            "a count of at least 1, got 0",
        ),
        (axes("{ parameter = 'body.mass', normal = [1, -2] }"), "not negative, got -2"),
        (axes("{ parameter = 'body.mass', uniform = [1, 2] }"), "count is needed"),
        (axes(&format!("{{ {axis}, normalise = true }}")), "no normalise"),
        (axes(&format!("{{ {axis} }}, {{ {axis} }}")), "set the same thing"),
        (format!("sweep.count = 2\n{}", axes(&format!("{{ {axis} }}"))), "count is needed"),
        (
            axes(&format!("{{ {axis} }}, {{ parameter = 'body.length', uniform = [1, 2] }}")),
            "all grids or all random",
        ),
        (
            axes(&format!("{{ {} }}", axis.replace("count = 3", "count = 4000000000"))),
            "more than 1e9",
        ),
        ("sweep.observables = []".into(), "observables must name at least one"),
        ("sweep.observables = ['megno', 'megno']".into(), "must not name one twice"),
        ("sweep.observables = ['chaos']".into(), "unknown observable `chaos`"),
        ("sweep.axis = 3".into(), "unknown key `axis`"),
        ("body.mass = 0".into(), "[body] mass must be positive"),
        ("integrator = { step = 0.03 }".into(), "not a whole number of steps"),
    ] {
        let folder = Folder::new();
        folder.write("a.toml", &text);
        let run = folder.heavytop(&["sweep", "a.toml", "--out", "made"]);
        assert_eq!(run.code(), 2, "{text}: {}", run.stderr());
        assert!(run.stderr().contains(message), "{text}: {}", run.stderr());
        assert_eq!((run.messages(), folder.names()), (1, vec!["a.toml".into()]));
    }
}

/// Returns what a table says of its integrator.
fn integrator(folder: &Folder, file: &str) -> String {
    let file = std::fs::File::open(folder.path(file)).unwrap();
    let reader = SerializedFileReader::new(file).unwrap();
    let pairs = reader.metadata().file_metadata().key_value_metadata().unwrap();
    let configuration = pairs.iter().find(|pair| pair.key == "configuration").unwrap();
    let configuration = configuration.value.as_deref().unwrap();
    let (_, table) = configuration.split_once("[integrator]\n").unwrap();
    table.split_once("\n\n").unwrap().0.into()
}

#[test]
#[ignore = "long"]
fn what_integrator_leaves_out_is_as_without_it() {
    let folder = Folder::new();
    let tops = "sweep.axes = [{ parameter = 'body.mass', from = 1, to = 2, count = 2 }]";
    for (keys, expected) in [
        ("", ["reduced", "gauss-8", "0.1", "100.0", "0.0"]),
        ("integrator.end = 7", ["reduced", "gauss-8", "0.1", "7.0", "0.0"]),
        ("integrator.step = 0.05", ["reduced", "gauss-8", "0.05", "100.0", "0.0"]),
        ("integrator.scheme = 'gauss-4'", ["reduced", "gauss-4", "0.1", "100.0", "0.0"]),
        ("integrator.formulation = 'collective'", ["collective", "gauss-8", "0.1", "100.0", "0.0"]),
        ("integrator.tolerance = 0.001", ["reduced", "gauss-8", "0.1", "100.0", "0.001"]),
    ] {
        folder.write("a.toml", &format!("{keys}\n{tops}"));
        let run = folder.heavytop(&["sweep", "a.toml", "--out", "made"]);
        assert_eq!(run.code(), 0, "{keys}");
        // Less accurate methods than the default one are warned of.
        let is_worse = keys.contains("gauss-4") || keys.contains("tolerance");
        let is_warned = run.stderr().contains("the motion turns by ");
        assert_eq!(is_warned, is_worse, "{keys}: {}", run.stderr());
        let [formulation, scheme, step, end, tolerance] = expected;
        let expected = format!(
            "formulation = \"{formulation}\"\nscheme = \"{scheme}\"\nstep = {step}\nend = {end}\n\
             tolerance = {tolerance}"
        );
        assert_eq!(integrator(&folder, "made/sweep.parquet"), expected, "{keys}");
    }
    // The keys of a preset count as keys of the configuration.
    folder.write("a.toml", &format!("integrator.end = 0.1\n{tops}"));
    let preset = ["sweep", "a.toml", "--preset", "multibody-benchmark", "--out", "made"];
    assert_eq!(folder.heavytop(&preset).code(), 0);
    assert!(integrator(&folder, "made/sweep.parquet").contains("gauss-16"));
}

#[test]
fn a_sweep_of_which_all_tops_fail_has_failed() {
    let folder = Folder::new();
    // The step is too long for all tops; the table of an earlier sweep stays.
    let tops = |step: u32, end: u32| {
        format!(
            "integrator = {{ step = {step}, end = {end} }}\nsweep.axes = [\
             {{ parameter = 'body.mass', from = 1, to = 2, count = 2 }}, \
             {{ parameter = 'body.length', from = 1, to = 2, count = 3 }}]"
        )
    };
    folder.write("a.toml", &tops(1, 10));
    assert_eq!(folder.heavytop(&["sweep", "a.toml", "--out", "made"]).code(), 0);
    let before = std::fs::read(folder.path("made/sweep.parquet")).unwrap();
    folder.write("b.toml", &tops(500, 1000));
    let run = folder.heavytop(&["sweep", "b.toml", "--out", "made", "--json"]);
    let said = run.stderr();
    assert_eq!((run.code(), run.stdout()), (1, String::new()), "{said}");
    let problem = "{\"error\":\"all 6 tops failed; the first: a step of 500 s turns";
    // No body has the moments of the paper's top with the masses and lengths of the axes.
    assert!(said.starts_with("{\"warning\":\"no body is 6 of 6 tops"), "{said}");
    assert!(said.lines().nth(1).is_some_and(|line| line.starts_with(problem)), "{said}");
    assert!(said.ends_with("made/sweep.parquet.partial\"}\n"), "{said}");
    assert!(std::fs::read(folder.path("made/sweep.parquet")).unwrap() == before);
    assert!(failures(&rows(&folder, "made/sweep.parquet.partial")).iter().all(Option::is_some));
    assert!(!folder.path("made/sweep.partial").exists());
}

/// What `[initial]` can say is varied by its own keys: the motions are those of `simulate` at the same numbers.
#[test]
fn angular_velocities_and_angles_vary_as_the_initial_table_says_them() {
    let folder = Folder::new();
    let text = "[initial]\nangular_velocity = [0.5, 0.0, 4.0]\ninclination = 0.0\nazimuth = 0.7\n\
                [integrator]\nformulation = 'reduced'\nstep = 0.05\nend = 2\n";
    let axes = "[sweep]\nobservables = ['final-state']\n\
                axes = [{ parameter = 'initial.angular_velocity[2]', from = 3, to = 5, count = 2 }, \
                { parameter = 'initial.inclination', from = 0.4, to = 1.0, count = 2 }]\n";
    folder.write("a.toml", &format!("{text}{axes}"));
    let run = folder.heavytop(&["sweep", "a.toml", "--out", "map"]);
    assert_eq!((run.code(), run.complaints().as_str()), (0, ""));
    let rows = rows(&folder, "map/sweep.parquet");
    assert_eq!(rows.len(), 4);
    folder.write("b.toml", text);
    let state = ["Pi1", "Pi2", "Pi3", "Gamma1", "Gamma2", "Gamma3"];
    let ends: Vec<Vec<f64>> =
        state.iter().map(|name| column(&rows, name).into_iter().flatten().collect()).collect();
    for (place, (spin, inclination)) in
        [(3, 0.4), (5, 0.4), (3, 1.0), (5, 1.0)].into_iter().enumerate()
    {
        let [spin, inclination] = [
            format!("initial.angular_velocity=[0.5,0,{spin}]"),
            format!("initial.inclination={inclination}"),
        ];
        let arguments = [
            "simulate",
            "b.toml",
            "--out",
            "b.csv",
            "--force",
            "--set",
            &spin,
            "--set",
            &inclination,
        ];
        assert_eq!(folder.heavytop(&arguments).code(), 0);
        let (_, table) = crate::program::numbers(&folder.read("b.csv"));
        let end = &table.last().unwrap()[1..7];
        let nearest = (0..4).map(|row| {
            let differences = ends.iter().zip(end).map(|(column, x)| (column[row] - x).abs());
            differences.fold(0.0, f64::max)
        });
        // Both make the same steps, by other code; each top is one of the table, and the others are elsewhere.
        let found: Vec<f64> = nearest.collect();
        let (near, far): (Vec<f64>, Vec<f64>) =
            found.iter().partition(|difference| **difference < 1e-12);
        assert!(
            near.len() == 1 && far.iter().all(|difference| *difference > 1e-2),
            "{place} {found:?}"
        );
    }
}
