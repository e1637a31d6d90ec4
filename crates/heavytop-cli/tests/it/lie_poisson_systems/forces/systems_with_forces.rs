//! Systems that are driven, damped and noisy: `[inputs]`, `[drive]`, `[damping]`, `[noise]`, and `t` in formulas.

use crate::program::{Finished, Folder, numbers};

/// A spin in a field along e₃.
const SPIN: &str = "\
[system]
algebra = 'so(3)'
bracket = 'plus'
hamiltonian = '-B*Pi3'
parameters.B = 2
initial.Pi = [1, 0, 0]

[integrator]
end = 10
step = 0.1
";

fn succeeded(done: &Finished) -> String {
    assert_eq!(done.code(), 0, "{}", done.stderr());
    done.stderr()
}

/// Returns what the program says of the run of a configuration, and the last row.
fn last(folder: &Folder, configuration: &str, more: &[&str]) -> (String, Vec<f64>) {
    folder.write("a.toml", configuration);
    let arguments = [&["simulate", "a.toml", "--out", "a.csv", "--force"], more].concat();
    let told = succeeded(&folder.heavytop(&arguments));
    let (_, mut rows) = numbers(&folder.read("a.csv"));
    (told, rows.pop().unwrap())
}

/// With friction θ, d(Π₃)/dt = θB(1 − Π₃²).
#[test]
fn a_damped_spin_turns_into_the_field_and_its_energy_is_no_error() {
    let folder = Folder::new();
    let damped = format!("{SPIN}[damping]\nfriction = 0.1\n");
    let (told, row) = last(&folder, &damped, &[]);
    assert!((row[3] - 2.0_f64.tanh()).abs() < 1e-12, "{row:?}");
    assert!(
        told.contains("largest deviations c1")
            && told.contains("what the motion does not keep, h 1.9e0"),
        "{told}"
    );
    let done = folder.heavytop(&["simulate", "a.toml", "--out", "b.csv", "--json"]);
    let summary: serde_json::Value = serde_json::from_str(&done.stdout()).unwrap();
    assert!(
        summary["deviations"]["c1"].as_f64() < Some(1e-13) && summary["deviations"]["h"].is_null()
    );
    assert!(summary["changes"]["h"].as_f64() > Some(1.9), "{summary}");
    // Control: without the table h is kept.
    let (told, row) = last(&folder, SPIN, &[]);
    assert!(row[3].abs() < 1e-13 && !told.contains("does not keep"), "{told}");
}

/// Friction takes 2 tanh 1 from h in ten units of time, to which the method adds rounding errors.
#[test]
fn a_balance_tells_what_the_forces_supply() {
    let folder = Folder::new();
    let damped = format!("{SPIN}[damping]\nfriction = 0.05\n");
    let (told, _) = last(&folder, &damped, &[]);
    assert!(!told.contains("supply"), "{told}");
    let whole = folder.read("a.csv");
    let (told, _) = last(&folder, &damped, &["--balance"]);
    assert!(told.contains("the forces supply -1.523e0 to h, the method "), "{told}");
    assert!(!told.contains("to c1") && folder.read("a.csv") == whole);
    let done = folder.heavytop(&["simulate", "a.toml", "--out", "b.csv", "--json", "--balance"]);
    let summary: serde_json::Value = serde_json::from_str(&done.stdout()).unwrap();
    let of = |name: &str, part: &str| summary["balance"][name][part].as_f64().unwrap();
    let lost = -2.0 * 1.0_f64.tanh();
    // A hundred steps of order 8, and their rounding errors.
    assert!((of("h", "change") - lost).abs() < 1e-11 && (of("h", "supplied") - lost).abs() < 1e-11);
    assert!(of("h", "defect") < 1e-11 && of("c1", "defect") < 1e-13, "{summary}");
    for other in ["", "[damping]\nfriction = 1\n[noise]\ntemperature = 1\n"] {
        folder.write("c.toml", &format!("{SPIN}{other}"));
        let done = folder.heavytop(&["simulate", "c.toml", "--out", "c.csv", "--balance"]);
        let told = done.stderr();
        assert!(
            done.code() == 2 && told.contains("a balance is of a top or a system by formula"),
            "{told}"
        );
        assert!(!folder.path("c.csv").exists());
    }
}

/// In the rotating frame the spin of a field B e₃ + b (cos Bt, −sin Bt, 0) turns about the field b e₁: Rabi's resonance.
#[test]
fn time_in_a_formula_is_the_time() {
    let folder = Folder::new();
    let rabi = SPIN
        .replace("-B*Pi3", "-B*Pi3 - b*(cos(B*t)*Pi1 - sin(B*t)*Pi2)")
        .replace("parameters.B = 2", "parameters = { B = 2, b = 0.3 }")
        .replace("[1, 0, 0]", "[0, 0, 1]");
    let (told, row) = last(&folder, &rabi, &[]);
    assert!((row[3] - 3.0_f64.cos()).abs() < 1e-10, "{row:?}");
    // The energy is that of the time of the row.
    let [t, x, y, z] = [row[0], row[1], row[2], row[3]];
    let h = -2.0 * z - 0.3 * ((2.0 * t).cos() * x - (2.0 * t).sin() * y);
    assert!((row[4] - h).abs() < 1e-14, "{told}");
    // A parameter of this name is no time.
    let (told, _) = last(
        &folder,
        &SPIN.replace("-B*Pi3", "-t*Pi3").replace("parameters.B", "parameters.t"),
        &[],
    );
    assert!(!told.contains("does not keep"), "{told}");
    // Backward in time the run comes back to its start.
    let [x, y, z] = [1, 2, 3].map(|i| row[i]);
    let back =
        rabi.replace("[0, 0, 1]", &format!("[{x:?}, {y:?}, {z:?}]")).replace("B*t", "B*(t + 10)");
    let (_, row) = last(&folder, &back.replace("end = 10", "end = -10"), &[]);
    assert!((row[3] - 1.0).abs() < 1e-10, "{row:?}");
}

/// A key of a table on the command line is put over that of the file.
#[test]
fn keys_of_inputs_are_assigned_one_by_one() {
    let folder = Folder::new();
    let input = "[inputs.u]\ntimes = [0, 10]\nvalues = [1, 1]\ninterpolation = 'linear'\n[drive]\nPi = [0, 0, 'u']\n";
    let still = SPIN.replace("parameters.B = 2", "parameters.B = 0") + input;
    let (_, row) = last(&folder, &still, &["--set", "inputs.u.values=[0.5, 0.5]"]);
    assert!((row[1] - 5.0_f64.cos()).abs() < 1e-9, "{row:?}");
    let (_, row) = last(&folder, &still, &["--set", "inputs.u.interpolation=cubic"]);
    assert!((row[1] - 10.0_f64.cos()).abs() < 1e-9, "{row:?}");
}

#[test]
fn inputs_by_tables_drive_a_spin_by_their_integral() {
    let folder = Folder::new();
    for (between, angle) in [("constant", 0.5 + 2.0 * 9.5), ("linear", 0.5 * 1.5 + 9.5)] {
        let tables = format!(
            "[inputs.u]\ntimes = [0, 0.5, 10]\nvalues = [1, 2, 0]\ninterpolation = '{between}'\n\
             [drive]\nPi = [0, 0, 'u']\n"
        );
        let still = SPIN.replace("parameters.B = 2", "parameters.B = 0");
        let (_, row) = last(&folder, &(still + &tables), &[]);
        // ds/dt = −s × u e₃ with the plus bracket.
        assert!((row[1] - f64::cos(angle)).abs() < 1e-7, "{between}: {row:?}");
    }
}

#[test]
fn noise_is_the_same_for_the_same_seed_and_path() {
    let folder = Folder::new();
    let warm = format!("{SPIN}[damping]\nfriction = 0.5\n[noise]\ntemperature = 0.5\n");
    let (told, first) = last(&folder, &warm, &[]);
    assert!(told.contains("noise of seed 1, path 0") && told.contains("of this path"), "{told}");
    let whole = folder.read("a.csv");
    last(&folder, &warm, &[]);
    assert_eq!(folder.read("a.csv"), whole);
    let others = [
        ["--set", "noise.path=1"],
        ["--set", "noise.seed=2"],
        ["--set", "noise.rule='alternating'"],
    ];
    for other in others {
        assert_ne!(last(&folder, &warm, &other).1, first, "{other:?}");
    }
    let length: f64 = first[1..4].iter().map(|x| x * x).sum();
    assert!((length - 1.0).abs() < 1e-13);
    // The half of the step sees the same noise: the paths come closer.
    let near = |step: &str| {
        let step = format!("integrator.step={step}");
        last(&folder, &warm, &["--set", "noise.interval=0.1", "--set", &step]).1
    };
    let [whole_steps, half, quarter] = ["0.1", "0.0125", "0.00625"].map(near);
    assert_eq!(whole_steps, first);
    let distance = |a: &[f64], b: &[f64]| (1..4).map(|i| (a[i] - b[i]).abs()).fold(0.0, f64::max);
    assert!(distance(&half, &quarter) < 0.1, "{half:?} {quarter:?}");
    // A chart and an array of the same run.
    let done = folder.heavytop(&["simulate", "a.toml", "--out", "a.npz"]);
    succeeded(&done);
    succeeded(&folder.heavytop(&["plot", "a.npz", "--out", "a.svg"]));
    assert!(folder.read("a.svg").contains("noise of seed 1, path 0"));
}

/// Strength and fields by formulas.
#[test]
fn noise_has_a_strength_or_fields() {
    let folder = Folder::new();
    let still = SPIN.replace("parameters.B = 2", "parameters.B = 0");
    let shaken = |noise: &str| last(&folder, &format!("{still}[noise]\n{noise}\n"), &[]).1;
    let about_e3 = shaken("fields = [{ Pi = [0, 0, 0.5] }]");
    assert!(about_e3[3].abs() < 1e-14 && (about_e3[1] - 1.0).abs() > 1e-3, "{about_e3:?}");
    let [one, other] = ["strength = 0.5", "strength = 0.25\ninner_product = 4"].map(shaken);
    assert!((1..4).all(|i| (one[i] - other[i]).abs() < 1e-12), "{one:?} {other:?}");
    assert!((shaken("strength = 0")[1] - 1.0).abs() < 1e-14);
}

/// Of a damped spin Π₃ = tanh(θBt), so that it is ½ at artanh(½)/θB.
#[test]
fn events_are_found_along_motions_with_forces() {
    let folder = Folder::new();
    let damped = format!("{SPIN}[damping]\nfriction = 0.1\n[events]\nfunctions = ['Pi3 - 0.5']\n");
    for configuration in [damped.clone(), damped.replace("-B*Pi3", "-B*Pi3 + 0*t")] {
        folder.write("a.toml", &configuration);
        succeeded(&folder.heavytop(&["events", "a.toml", "--out", "e.csv", "--force"]));
        let (_, rows) = numbers(&folder.read("e.csv"));
        assert_eq!(rows.len(), 1);
        assert!((rows[0][1] - 0.5_f64.atanh() / 0.2).abs() < 1e-10, "{rows:?}");
    }
}

/// A path with noise passes a value of a coordinate as often as the step lets it, and a time once.
#[test]
fn events_along_a_path_with_noise_are_those_of_the_time() {
    let folder = Folder::new();
    let events = |noise: &str, functions: &str| {
        folder.write("a.toml", &format!("{SPIN}{noise}[events]\nfunctions = {functions}\n"));
        folder.heavytop(&["events", "a.toml", "--out", "e.csv", "--force"])
    };
    let noise = "[noise]\nstrength = 0.1\n";
    for functions in ["['Pi3']", "['t - 1', 'Pi3']"] {
        let done = events(noise, functions);
        let told = done.stderr();
        assert_eq!(done.code(), 2, "{told}");
        for part in [
            "events.functions[",
            "Pi3 is a function of coordinates",
            "depends on the step",
            "^ write",
        ] {
            assert!(told.contains(part), "{part}: {told}");
        }
        assert_eq!(folder.names(), ["a.toml"]);
    }
    assert!(events(noise, "['t - 1', 'Pi3']").stderr().contains("functions[1]"));
    succeeded(&events(noise, "['t - 1.5']"));
    let (_, rows) = numbers(&folder.read("e.csv"));
    assert!(rows.len() == 1 && (rows[0][1] - 1.5).abs() < 1e-12, "{rows:?}");
    // Control: without noise a coordinate is as good.
    succeeded(&events("[damping]\nfriction = 0.1\n", "['Pi3 - 0.1']"));
}

/// The means are those of the paths, whatever the number of threads, and the first path is that of `simulate`.
#[test]
fn an_ensemble_has_means_with_errors_and_quantiles() {
    let folder = Folder::new();
    folder.write("a.toml", &format!("{SPIN}[damping]\nfriction = 0.5\n[noise]\ntemperature = 1\n"));
    let options = ["ensemble", "a.toml", "--set", "integrator.end=4", "--set", "output.every=10"];
    let on = |threads: &str, out: &str| {
        let arguments =
            [&options[..], &["--paths", "60", "--quantiles", "0.5", "--out", out]].concat();
        succeeded(&folder.heavytop_on(threads, &arguments))
    };
    let told = on("1", "one.csv");
    on("3", "three.csv");
    assert_eq!(folder.read("one.csv"), folder.read("three.csv"));
    assert!(
        told.contains("paths 0 to 59 of seed 1") && told.contains("Pi3 ") && told.contains(" ± "),
        "{told}"
    );
    let (header, rows) = numbers(&folder.read("one.csv"));
    assert_eq!(header[..6].join(","), "paths,t,Pi1_mean,Pi1_error,Pi1_deviation,Pi1_q0.5");
    assert_eq!((rows.len(), rows[4][0], rows[4][1]), (5, 60.0, 4.0));
    let mut sum = 0.0;
    for path in 0..60 {
        let set = format!("noise.path={path}");
        let alone = [
            "simulate",
            "a.toml",
            "--set",
            "integrator.end=4",
            "--set",
            &set,
            "--out",
            "p.csv",
            "--force",
        ];
        succeeded(&folder.heavytop(&alone));
        let (_, rows) = numbers(&folder.read("p.csv"));
        sum += rows[rows.len() - 1][3];
    }
    let place = header.iter().position(|name| name == "Pi3_mean").unwrap();
    assert!((rows[4][place] - sum / 60.0).abs() < 1e-13);
    // Steps of noise that are too long are told, and numbers of paths that are not told apart are refused.
    let set = ["--set", "noise.temperature=20", "--paths", "2", "--out", "long.csv"];
    let told = folder.heavytop(&[&options[..], &set].concat()).stderr();
    assert!(told.contains("the noise turns the state by about 1.4e0 rad in a step"), "{told}");
    let set = ["--set", "noise.path=9007199254740990", "--paths", "3", "--out", "no.csv"];
    let told = folder.heavytop(&[&options[..], &set].concat()).stderr();
    assert!(told.contains("must be below 9007199254740992"), "{told}");
    // Refusals name the bound, and leave nothing.
    for (more, part) in [
        (["--paths", "1"], "2 paths or more, got 1"),
        (["--quantiles", "1.5"], "between 0 and 1, got 1.5"),
        (["--set", "output.attitude=true"], "no attitude"),
    ] {
        let arguments = [&options[..], &more, &["--out", "no.csv"]].concat();
        let done = folder.heavytop(&arguments);
        assert!(done.code() == 2 && done.stderr().contains(part), "{}", done.stderr());
    }
    folder.write("b.toml", SPIN);
    let done = folder.heavytop(&["ensemble", "b.toml", "--out", "no.csv"]);
    assert!(
        done.code() == 2 && done.stderr().contains("a motion without noise has one path"),
        "{}",
        done.stderr()
    );
    assert!(!folder.path("no.csv").exists() && !folder.path("no.csv.partial").exists());
}

/// A tolerance of the stages is an error of the path alone by `reduced`; by the lift it is one of |Π|², too.
#[test]
fn paths_without_a_lift_keep_the_casimirs_for_a_tolerance() {
    let folder = Folder::new();
    folder.write("a.toml", &format!("{SPIN}[damping]\nfriction = 0.5\n[noise]\ntemperature = 1\n"));
    let run = |formulation: &str, tolerance: &str| {
        let keys = ["formulation", "scheme", "tolerance", "end"];
        let values = [formulation, "'implicit-midpoint'", tolerance, "4"];
        let sets: Vec<_> = keys
            .iter()
            .zip(values)
            .map(|(key, value)| format!("integrator.{key}={value}"))
            .collect();
        let mut arguments = vec!["simulate", "a.toml", "--force", "--out", "a.csv"];
        arguments.extend(sets.iter().flat_map(|set| ["--set", set]));
        succeeded(&folder.heavytop(&arguments));
        numbers(&folder.read("a.csv")).1
    };
    let length = |row: &[f64]| row[1..4].iter().map(|x| x * x).sum::<f64>();
    let change = |rows: &[Vec<f64>]| (length(&rows[rows.len() - 1]) - length(&rows[0])).abs();
    let [exact, quick, lifted] =
        [("'reduced'", "0"), ("'reduced'", "1e-4"), ("'collective'", "1e-4")]
            .map(|(f, t)| run(f, t));
    let last = exact.len() - 1;
    let apart = |a: f64, b: f64| (a - b).abs();
    assert!(apart(exact[last][3], quick[last][3]) < 1e-2 && exact[last] != quick[last]);
    assert!(change(&exact) < 1e-13 && change(&quick) < 1e-13 && change(&lifted) > 1e-9);
}
