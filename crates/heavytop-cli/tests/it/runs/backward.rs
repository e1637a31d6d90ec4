//! Runs backward in time: an end before 0, or a negative step, in every command that has one.

use crate::commands::sweep::{column, rows};
use crate::program::{Folder, numbers};

/// Returns the rows of a run with these keys of `[integrator]`.
fn simulated(folder: &Folder, keys: &str) -> Vec<Vec<f64>> {
    folder.write("a.toml", keys);
    let run = folder.heavytop(&["simulate", "a.toml", "--out", "a.csv", "--force"]);
    // Only of a chaotic motion there is something to say.
    let said = run.complaints();
    let is_right = said.is_empty() || said.contains("the motion is chaotic");
    assert!(run.code() == 0 && is_right, "{keys}: {said}");
    numbers(&folder.read("a.csv")).1
}

#[test]
fn an_end_before_0_or_a_negative_step_asks_for_it() {
    let folder = Folder::new();
    let rows = simulated(&folder, "integrator.end = -10");
    assert_eq!(rows.len(), 501);
    assert!((0..).zip(&rows).all(|(n, row)| row[0] == f64::from(n) * -0.02));
    let text = folder.read("a.csv");
    for keys in
        ["integrator = { step = -0.02, end = -10 }", "integrator = { step = 0.02, end = -10 }"]
    {
        simulated(&folder, keys);
        assert!(folder.read("a.csv") == text, "{keys}");
    }
    // A negative step alone turns the end that is left out.
    let rows = simulated(&folder, "integrator.step = -0.02");
    assert_eq!((rows.len(), rows[5000][0]), (5001, -100.0));
    let first: Vec<String> = text.lines().map(String::from).collect();
    assert!(folder.read("a.csv").lines().take(501).eq(first.iter().take(501).map(String::as_str)));
    // Control: forward is another motion.
    let forward = simulated(&folder, "integrator.end = 10");
    assert!(forward[500][0] == 10.0 && (forward[500][1] - rows[500][1]).abs() > 1e-3);
}

/// From the end of a run forward, a run backward comes to its start: symmetric methods to round-off.
#[test]
fn a_run_backward_returns_to_the_start() {
    let folder = Folder::new();
    for (method, most) in [
        ("formulation = 'reduced', scheme = 'gauss-8', step = 0.1", 1e-11),
        ("formulation = 'collective', scheme = 'implicit-midpoint', step = 0.05", 1e-11),
        ("formulation = 'splitting', scheme = 'yoshida-4', step = 0.05", 1e-11),
        // Of order 4, and not symmetric.
        ("formulation = 'direct', scheme = 'rk4', step = 0.02", 1e-3),
    ] {
        let there = simulated(&folder, &format!("integrator = {{ {method}, end = 20 }}"));
        let (first, last) = (&there[0], there.last().unwrap());
        let text = format!(
            "integrator = {{ {method}, end = -20 }}\ninitial = {{ angular_momentum = {:?}, vertical = {:?}, \
             normalise = true }}",
            &last[1..4],
            &last[4..7]
        );
        let back = simulated(&folder, &text);
        let distance = back.last().unwrap()[1..7].iter().zip(&first[1..7]);
        let distance = distance.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(distance < most, "{method}: {distance:e}");
        // Control: rk4 does not return to round-off.
        assert!(!method.contains("rk4") || distance > 1e-9, "{method}: {distance:e}");
    }
}

#[test]
#[ignore = "long"]
fn systems_sweeps_and_comparisons_go_backward() {
    let folder = Folder::new();
    let system =
        "system = { algebra = 'so(3)', hamiltonian = 'Pi3^2/2', initial = { Pi = [1, 0, 2] } }\n";
    let turned = simulated(&folder, &format!("{system}integrator = {{ step = 0.1, end = -1 }}"));
    // Π turns about e₃ by the angle −Π₃ t.
    for row in &turned {
        let angle = -2.0 * row[0];
        assert!(
            (row[1] - angle.cos()).abs() < 1e-2 && (row[2] - angle.sin()).abs() < 1e-2,
            "{row:?}"
        );
    }
    folder.write(
        "sweep.toml",
        "sweep = { axes = [{ parameter = 'body.mass', from = 1, to = 2, count = 2 }], \
         observables = ['final-state', 'lyapunov', 'megno', 'rotation-number'] }\n\
         initial.angular_momentum = [1, 2, 1]\nbody = { inertia = [1, 1.7, 2.2], gravity = 9.81, length = 0.5 }\n\
         integrator = { scheme = 'gauss-8', step = 0.05, end = -100 }",
    );
    let run = folder.heavytop(&["sweep", "sweep.toml", "--out", "map"]);
    assert!(
        run.code() == 0 && run.complaints().contains("the motion is chaotic"),
        "{}",
        run.stderr()
    );
    let measured = rows(&folder, "map/sweep.parquet");
    // The motion is chaotic, and tangent vectors grow along the run.
    for name in ["lyapunov", "megno"] {
        let values = column(&measured, name);
        assert!(values.iter().all(|value| value.is_some_and(|x| x > 0.1)), "{name} {values:?}");
    }
    // The end of a chaotic motion is that of the same steps alone, which are made without tangent vectors.
    let set = "sweep.observables=['final-state']";
    let run = folder.heavytop(&["sweep", "sweep.toml", "--out", "ends", "--set", set]);
    assert_eq!(run.code(), 0, "{}", run.stderr());
    let measured = rows(&folder, "ends/sweep.parquet");
    let alone = "initial.angular_momentum = [1, 2, 1]\nbody = { inertia = [1, 1.7, 2.2], gravity = 9.81, length = 0.5 }\n\
                 integrator = { formulation = 'reduced', scheme = 'gauss-8', step = 0.05, end = -100 }";
    let alone = simulated(&folder, alone);
    let end = alone.last().unwrap();
    assert_eq!(end[0], -100.0);
    assert_eq!(column(&measured, "Pi1")[0], Some(end[1]));

    folder.write("top.toml", "integrator = { step = 0.1, end = -1 }");
    let run = folder.heavytop(&["compare", "top.toml", "--out", "forward", "--end", "-1"]);
    assert_eq!(run.code(), 0, "{}", run.stderr());
    let table = folder.read("forward/work-precision.csv");
    let runs: Vec<Vec<&str>> = table.lines().skip(1).map(|row| row.split(',').collect()).collect();
    let (mut converged, mut all) = (0, 0);
    for row in &runs {
        let [step, end, error, seconds] = [2, 3, 4, 5].map(|i| row[i].parse::<f64>().unwrap());
        assert!(step < 0.0 && end == -1.0, "{row:?}");
        assert!(seconds.is_nan() || seconds > 0.0, "{row:?}");
        (converged, all) = (converged + usize::from(error < 1e-6), all + 1);
    }
    assert!(converged > all / 4, "{converged} of {all}");
    let refused = folder.heavytop(&["compare", "top.toml", "--out", "c", "--end", "1"]);
    assert!(
        refused.code() == 2
            && refused.stderr().contains("--end: steps of -0.1 s do not reach end = 1")
    );
}

/// A section is the same backward; its points have times before 0.
#[test]
fn sections_and_pages_go_backward() {
    let folder = Folder::new();
    let section =
        "section = { energy = 1.5, vertical_momentum = 0.5, starts = 3, crossings = 5 }\n";
    folder.write("a.toml", &format!("{section}integrator.step = -0.1"));
    let run = folder.heavytop(&["section", "a.toml", "--out", "back"]);
    assert_eq!((run.code(), run.complaints()), (0, String::new()));
    let rows = numbers(&folder.read("back/section.csv")).1;
    assert_eq!(rows.len(), 3 * 6);
    for orbit in rows.chunks(6) {
        assert!(orbit[0][2] == 0.0 && orbit.is_sorted_by(|a, b| a[2] > b[2]));
        for row in orbit {
            // The surface is Γ₃ = 0, and its direction upwards in time: dΓ₃/dt = Γ₁ Ω₂ − Γ₂ Ω₁, here with Ω = Π/2.
            assert!(row[8].abs() < 1e-14 && row[6] * row[4] - row[7] * row[3] > 0.0, "{row:?}");
        }
    }
    folder.write("b.toml", "integrator.end = -2");
    let run = folder.heavytop(&["animate", "b.toml", "--out", "b.html", "--json"]);
    assert_eq!((run.code(), run.complaints()), (0, String::new()));
    assert!(run.stdout().contains("\"end\": -2.0"), "{}", run.stdout());
    let refused = folder.heavytop(&["reproduce", "--out", "paper", "--end", "-1"]);
    assert_eq!(refused.code(), 2);
    assert!(refused.stderr().contains("end must be positive and finite, got -1"));
}

/// The first time is 0, not −0, and the rows of a run backward are recognised as those of the program.
#[test]
fn the_first_time_is_positive_zero() {
    let folder = Folder::new();
    folder.write("a.toml", "integrator.end = -2");
    assert_eq!(folder.heavytop(&["simulate", "a.toml", "--out", "a.csv"]).code(), 0);
    assert!(folder.read("a.csv").lines().nth(1).unwrap().starts_with("0.0,"));
    for out in ["a.npz", "a.parquet"] {
        // The rows that a killed run has left: a row of zeros but for the state.
        let rows: Vec<u8> = numbers(&folder.read("a.csv")).1[0]
            .iter()
            .flat_map(|number| number.to_le_bytes())
            .collect();
        std::fs::write(folder.path(&format!("{out}.rows")), rows).unwrap();
        let run = folder.heavytop(&["simulate", "a.toml", "--out", out]);
        assert_eq!((run.code(), run.complaints()), (0, String::new()), "{out}");
        assert!(!folder.path(&format!("{out}.rows")).exists());
    }
}
