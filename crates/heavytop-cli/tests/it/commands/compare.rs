//! `heavytop compare`: the table, the figure, the recommendations, and how it ends.

use crate::program::Folder;

const FILES: [&str; 3] = ["work-precision.csv", "work-precision.png", "work-precision.svg"];

/// Reads the rows of the table: formulation, scheme, and the numbers.
fn rows(csv: &str) -> Vec<(String, String, Vec<f64>)> {
    let mut lines = csv.lines();
    let header =
        "formulation,scheme,step,end,error,seconds,h,f1,f2,error_Pi,error_Gamma,relative_error";
    assert_eq!(lines.next(), Some(header));
    lines
        .map(|line| {
            let cells: Vec<&str> = line.split(',').collect();
            let numbers = cells[2..].iter().map(|cell| cell.parse().unwrap()).collect();
            (cells[0].into(), cells[1].into(), numbers)
        })
        .collect()
}

#[test]
#[ignore = "long"]
fn a_short_comparison_has_all_methods_and_says_which_to_take() {
    let folder = Folder::new();
    folder.write("a.toml", "integrator = { step = 0.1, end = 1 }\nbody.inertia = [3.0, 2.0, 1.5]");
    let run = folder.heavytop(&["compare", "a.toml", "--out", "made/here"]);
    assert_eq!((run.code(), run.complaints().as_str()), (0, ""));
    let entries = std::fs::read_dir(folder.path("made/here")).unwrap();
    let mut names: Vec<_> =
        entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    assert_eq!(names, FILES);
    assert!(folder.read("made/here/work-precision.svg").starts_with("<svg"));
    let png = std::fs::read(folder.path("made/here/work-precision.png")).unwrap();
    assert!(png.starts_with(b"\x89PNG"));

    // There are 1 to 100 steps; 17 methods collectively, 12 reduced, 14 directly, 6 by splitting.
    let rows = rows(&folder.read("made/here/work-precision.csv"));
    let ladder = [1.0, 2.0, 3.0, 6.0, 10.0, 18.0, 32.0, 56.0, 100.0];
    assert_eq!(rows.len(), (17 + 12 + 14 + 6) * ladder.len());
    for (i, (formulation, scheme, numbers)) in rows.iter().enumerate() {
        let [step, end, error, seconds, h, f1, f2, pi, gamma, relative] = numbers[..] else {
            panic!("{numbers:?}")
        };
        assert_eq!((step, end), (1.0 / ladder[i % ladder.len()], 1.0));
        let what = format!("{formulation} {scheme} {step}: {numbers:?}");
        let failed = error.is_nan();
        assert!(failed || (error >= 0.0 && seconds > 0.0 && h.is_finite()), "{what}");
        // The parts of the error; |Γ| = 1, and |Π| ≥ 4 kg m²/s at the start.
        assert!(failed || error <= (pi / 4.0).hypot(gamma) * (1.0 + 1e-14), "{what}");
        assert!(failed || (relative..=1.415 * relative).contains(&error), "{what}");
        assert!(failed || (relative - gamma).abs() <= 1e-14 * gamma || relative < pi, "{what}");
        // With a hundred steps all methods are near the solution.
        assert!(step > 0.011 || error < 0.1, "{what}");
        // Poisson maps conserve the Casimirs with any number of steps.
        let partitioned = ["symplectic-euler", "stormer-verlet", "lobatto-iiia-iiib-4"];
        let explicit = ["explicit-midpoint", "rk4"];
        let of = |schemes: &[&str]| schemes.contains(&scheme.as_str());
        if formulation != "direct" && !of(&partitioned) && !of(&explicit) && !failed {
            assert!(f1 < 1e-12 && f2 < 1e-11, "{what}");
        }
    }
    let best = rows.iter().map(|row| row.2[2]).fold(f64::INFINITY, f64::min);
    assert!(best < 1e-12, "{best}");

    let said = run.stdout();
    for target in ["1e-3", "1e-6", "1e-9"] {
        let line = said.lines().find(|line| line.starts_with(&format!("error {target}: fastest ")));
        assert!(
            line.is_some_and(|line| line.contains("Poisson") && line.contains(" µs (Pi ")),
            "{said}"
        );
    }
    assert!(said.contains("error 1e-12: ") && said.contains("made/here"), "{said}");
}

/// A top of the laboratory in another unit of mass: the numbers are others, the motion and its errors are not.
#[test]
#[ignore = "long"]
fn errors_do_not_depend_on_the_unit_of_mass() {
    let compared = |unit: f64| {
        let folder = Folder::new();
        let text = format!(
            "body = {{ inertia = [{}, {}, {}], mass = {unit}, gravity = 9.81, length = 0.005 }}\n\
             initial.angular_momentum = [{}, 0.0, {}]\nintegrator = {{ step = 0.002, end = 0.02 }}",
            2e-3 * unit,
            1.6e-3 * unit,
            1e-3 * unit,
            4e-3 * unit,
            2e-2 * unit,
        );
        folder.write("a.toml", &text);
        let run = folder.heavytop(&["compare", "a.toml", "--out", "."]);
        assert_eq!((run.code(), run.complaints().as_str()), (0, ""));
        rows(&folder.read("work-precision.csv"))
    };
    let [reference, small, large] = [1.0, 1e-30, 1e30].map(compared);
    let mut count = 0;
    for other in [small, large] {
        for ((formulation, scheme, one), (.., other)) in reference.iter().zip(&other) {
            // Round-off is no longer the same motion.
            if one[9] > 1e-9 {
                count += 1;
                for (name, column) in [("error", 2), ("error_Gamma", 8), ("relative_error", 9)] {
                    let (here, there) = (one[column], other[column]);
                    let near = (here / there - 1.0).abs() < 1e-3;
                    assert!(near, "{formulation} {scheme} {name} {here} {there}");
                }
                // Control: the error of Π has its unit.
                let ratio = one[7] / other[7];
                assert!(!(1e-9..1e9).contains(&ratio), "{scheme} {ratio}");
            }
        }
    }
    assert!(count > 100, "{count}");
}

#[test]
fn a_reference_that_is_not_certain_fails() {
    let folder = Folder::new();
    folder.write("a.toml", "integrator = { step = 0.8, end = 80 }");
    let run = folder.heavytop(&["compare", "a.toml", "--out", "."]);
    assert_eq!(run.code(), 1, "{}", run.stderr());
    let said = run.stderr();
    assert!(said.starts_with("heavytop: the reference solution is certain to "), "{said}");
    assert_eq!((said.lines().count(), folder.names()), (1, vec!["a.toml".into()]));
}

#[test]
fn wrong_requests_are_refused() {
    let folder = Folder::new();
    folder.write("file", "");
    folder.write("wrong.toml", "body.mass = 0");
    for arguments in [
        &["compare"][..],
        &["compare", "--out", "file"],
        &["compare", "wrong.toml", "--out", "made"],
        &["compare", "missing.toml", "--out", "made"],
    ] {
        let run = folder.heavytop(arguments);
        assert_eq!(run.code(), 2, "{arguments:?}: {}", run.stderr());
    }
    assert_eq!(folder.names(), ["file", "wrong.toml"]);
}

#[test]
fn what_cannot_be_written_is_found_before_there_is_any_work() {
    // Folders with the names of the partial table and of the pictures.
    for name in ["work-precision.csv.partial", "work-precision.svg", "work-precision.png"] {
        let folder = Folder::new();
        std::fs::create_dir_all(folder.path(name)).unwrap();
        let run = folder.heavytop(&["compare", "--out", "."]);
        assert_eq!(run.code(), 2, "{}", run.stderr());
        assert!(run.stderr().contains("cannot create ./work-precision."), "{}", run.stderr());
        assert_eq!(folder.names(), [name]);
    }
}

#[test]
#[ignore = "long"]
fn the_interval_ends_where_asked() {
    let folder = Folder::new();
    let compare = |end: &str| {
        folder.write("a.toml", "integrator = { step = 0.1, end = 1 }");
        folder.heavytop(&["compare", "a.toml", "--out", "made", "--end", end])
    };
    assert_eq!(compare("0.5").code(), 0);
    let rows = rows(&folder.read("made/work-precision.csv"));
    assert!(rows.iter().all(|(_, _, numbers)| numbers[1] == 0.5));
    // The end of the run plays no part in the refusal.
    let refused = compare("0.55");
    let expected = "heavytop: --end: end = 0.55 is not a whole number of steps of 0.1; the nearest \
                    ends are 0.5 and 0.6\n";
    assert_eq!((refused.code(), refused.stderr().as_str()), (2, expected));
    assert_eq!(compare("-0.55").code(), 2);
}
