//! Lattices of spins with `[damping]` and `[noise]`.

use crate::program::{Finished, Folder, numbers};
use lie_poisson_runs::{
    Arguments, ArrayKind, Experiment, LatticeNoise, LatticeTerms, NoisePaths, OpenArrays, Pace,
    RunFailure, Schedule, SpinDamping,
};

/// A ring of spins at kT = 0.5 J.
const RING: &str = "\
[system]
kind = 'spin-lattice'
parameters = { shape = [16], exchange = 1 }
initial.direction = [0, 0, 1]

[damping]
friction = 1

[noise]
temperature = 0.5

[integrator]
step = 0.05
end = 4

[output]
every = 20
";

fn succeeded(done: &Finished) -> String {
    assert_eq!(done.code(), 0, "{}", done.stderr());
    done.stderr()
}

/// Returns the rows of the ring by the library, with a damping, and on a path if there is noise.
fn rows(damping: SpinDamping, path: Option<u64>) -> Vec<Vec<f64>> {
    let given = Arguments::new().list("shape", vec![16.0]).number("exchange", 1.0);
    let ring = ArrayKind::named("spin-lattice").unwrap().system(&given).unwrap();
    let start = Arguments::new().list("direction", vec![0.0, 0.0, 1.0]);
    let start = ring.start_of(&start).unwrap();
    let paths = |path| NoisePaths { path, ..NoisePaths::default() };
    let noise = path.map(|path| LatticeNoise { temperature: 0.5, paths: paths(path) });
    let terms = LatticeTerms { damping: Some(damping), noise, field: None };
    let model = OpenArrays::new(ring, terms, 0.05).unwrap();
    let method = model.method(None, None, 0.0).unwrap();
    let pace = Pace { schedule: Schedule::new(0.05, 4.0).unwrap(), every: 20 };
    let run = Experiment { model, start, method, pace, attitude: false };
    let mut rows = Vec::new();
    run.follow(None, |moment| -> Result<(), RunFailure> {
        rows.push(moment.row.to_vec());
        Ok(())
    })
    .unwrap();
    rows
}

/// Rows have the bits of the library; the lengths are kept, and the energy is told to change.
#[test]
fn a_ring_at_a_temperature_keeps_the_lengths_of_its_spins() {
    let folder = Folder::new();
    folder.write("a.toml", RING);
    let told = succeeded(&folder.heavytop(&["simulate", "a.toml", "--out", "a.csv"]));
    for part in [
        "noise of seed 1, path 0; largest deviations C ",
        "what the motion does not keep, M1 ",
        "of this path; by direct, implicit-midpoint, step 0.05 s",
    ] {
        assert!(told.contains(part), "{told}: {part}");
    }
    let (header, found) = numbers(&folder.read("a.csv"));
    assert_eq!(header[49..].join(","), "h,M1,M2,M3,C");
    let friction = SpinDamping::LandauLifshitz(1.0);
    assert_eq!(found, rows(friction, Some(0)));
    for row in &found {
        for spin in row[1..49].as_chunks::<3>().0 {
            assert!((spin.iter().map(|x| x * x).sum::<f64>() - 1.0).abs() < 1e-13);
        }
        assert!((row[53] - 16.0).abs() < 1e-12);
    }
    // Other keys are other runs.
    let others = [
        ("noise.path=3", friction, Some(3)),
        ("damping.form='gilbert'", SpinDamping::Gilbert(1.0), Some(0)),
        ("noise.bound=1", friction, None),
        ("noise.seed=2", friction, None),
    ];
    for (set, damping, path) in others {
        let arguments = ["simulate", "a.toml", "--out", "a.csv", "--force", "--set", set];
        succeeded(&folder.heavytop(&arguments));
        let (_, other) = numbers(&folder.read("a.csv"));
        assert_ne!(other[4], found[4], "{set}");
        if path.is_some() {
            assert_eq!(other, rows(damping, path), "{set}");
        }
    }
}

/// Without noise there is one path, of the order 2, and spins turn into their field. All formats and pictures have it.
#[test]
fn friction_alone_and_the_outputs() {
    let folder = Folder::new();
    let damped = RING
        .replace("[noise]\ntemperature = 0.5\n", "form = 'gilbert'\n")
        .replace("exchange = 1", "exchange = 1, field = [0, 0, 1]")
        .replace("[0, 0, 1]\n\n[damping]", "[1, 0, 0]\n\n[damping]");
    folder.write("a.toml", &damped);
    let options = ["simulate", "a.toml", "--set", "damping.friction=0.5"];
    let told = succeeded(
        &folder.heavytop(&[&options[..], &["--out", "a.npz", "--check", "--json"]].concat()),
    );
    assert!(!told.contains("warning"), "{told}");
    let told = succeeded(&folder.heavytop(&[&options[..], &["--out", "a.csv"]].concat()));
    assert!(!told.contains("noise") && told.contains("of the state"), "{told}");
    // All spins are one: ds₃/dt = b(1 − s₃²) with b = α/(1 + α²); the error of the method is that of its order.
    let (_, found) = numbers(&folder.read("a.csv"));
    assert!((found[4][3] - (0.4 * 4.0_f64).tanh()).abs() < 1e-3, "{:?}", found[4]);
    succeeded(&folder.heavytop(&["plot", "a.npz", "--out", "a.svg"]));
    let picture = folder.read("a.svg");
    assert!(picture.contains("friction 0.5") && picture.contains("implicit-midpoint"));
    for out in ["a.parquet", "b.npz"] {
        let done = folder.heavytop(&[&options[..], &["--out", out, "--dry-run"]].concat());
        succeeded(&done);
        assert!(done.stdout().contains("5 rows"), "{}", done.stdout());
    }
    // Backward, the friction feeds energy, as other forces do.
    let back = ["--set", "integrator.end=-1", "--out", "back.csv"];
    succeeded(&folder.heavytop(&[&options[..], &back].concat()));
    let (_, found) = numbers(&folder.read("back.csv"));
    assert!((found[1][3] + 0.4_f64.tanh()).abs() < 1e-3, "{:?}", found[1]);
    // A start in an archive goes on with it.
    let other = damped.replace("initial.direction = [1, 0, 0]", "initial_file = 'a.npz'");
    folder.write("b.toml", &other);
    succeeded(&folder.heavytop(&["simulate", "b.toml", "--out", "c.csv"]));
}

/// The means do not depend on the threads, and are those of the temperature: for 16 spins −J (coth K − 1/K) but for 2e-4.
#[test]
fn an_ensemble_has_the_energy_of_the_temperature() {
    let folder = Folder::new();
    folder.write("a.toml", RING);
    let options = ["ensemble", "a.toml", "--set", "integrator.end=10", "--paths", "50"];
    let on = |threads: &str, out: &str| {
        let arguments = [&options[..], &["--out", out]].concat();
        succeeded(&folder.heavytop_on(threads, &arguments))
    };
    let told = on("1", "one.csv");
    on("4", "four.csv");
    assert_eq!(folder.read("one.csv"), folder.read("four.csv"));
    // 53 columns are too many for a line.
    assert!(told.contains("at the end h -") && !told.contains("S_1_1"), "{told}");
    let (header, rows) = numbers(&folder.read("one.csv"));
    let place = header.iter().position(|name| name == "h_mean").unwrap();
    let [mean, error] = [0, 1].map(|i| rows[rows.len() - 1][place + i] / 16.0);
    let exact = |k: f64| k.recip() - k.tanh().recip();
    assert!((mean - exact(2.0)).abs() < 4.0 * error, "{mean} ± {error}");
    assert!((mean - exact(3.0)).abs() > 6.0 * error, "control: {mean} ± {error}");
}

/// A lattice that is large enough for several threads.
#[test]
fn a_path_has_the_same_bytes_on_any_number_of_threads() {
    let folder = Folder::new();
    let text = RING.replace("[16]", "[70, 90]").replace("end = 4", "end = 0.1");
    folder.write("a.toml", &text);
    for (threads, out) in [("1", "one.npz"), ("4", "four.npz")] {
        succeeded(&folder.heavytop_on(threads, &["simulate", "a.toml", "--out", out]));
    }
    let bytes = |name: &str| std::fs::read(folder.path(name)).unwrap();
    assert!(bytes("one.npz") == bytes("four.npz"));
}

#[test]
fn errors_name_the_value_the_bound_and_the_line() {
    let folder = Folder::new();
    let wave = "initial = { direction = [0, 0, 1] }";
    for (old, new, parts) in [
        (
            "friction = 1",
            "friction = -1",
            &["0 or a positive number, it is -1", "friction = -1"][..],
        ),
        ("friction = 1", "form = 'gilbert'", &["friction is missing in [damping]"]),
        ("friction = 1", "friction = 1\nform = 'bloch'", &["landau-lifshitz", "gilbert"]),
        (
            "friction = 1",
            "friction = 1\ninner_product = 2",
            &[
                "damping.inner_product is of other systems",
                "a spin-lattice has friction and form",
                "^ leave it out",
            ],
        ),
        ("[damping]\nfriction = 1", "", &["a temperature needs a friction", "add [damping]"]),
        (
            "friction = 1",
            "friction = 0\nform = 'gilbert'",
            &["beside temperature = 0.5 the friction must be a positive number", "friction = 0"],
        ),
        ("temperature = 0.5", "temperature = nan", &["it is NaN"]),
        ("temperature = 0.5", "", &["temperature is missing in [noise]"]),
        (
            "temperature = 0.5",
            "strength = 1",
            &["noise.strength is of other systems", "strength = 1"],
        ),
        ("temperature = 0.5", "temperature = 1\nrule = 'alternating'", &["noise.rule is of"]),
        ("temperature = 0.5", "temperature = 1\ninner_product = 1", &["noise.inner_product is of"]),
        ("temperature = 0.5", "fields = [{ S = [0, 0, 1] }]", &["noise.fields is of other"]),
        ("temperature = 0.5", "temperature = 1\ninterval = 1e-9", &["must be at least 0.000005"]),
        ("temperature = 0.5", "temperature = 1\npath = 9007199254740992", &["below 900719925474"]),
        ("temperature = 0.5", "temperature = 1\nbound = 0.5", &["1 standard deviation or more"]),
        ("[noise]", "[drive]\nS = [0, 0, 1]\n[noise]", &["drive.S is of other systems"]),
        ("[noise]", "[torque]\nS = [0, 0, 1]\n[noise]", &["[torque] is for tops and systems by"]),
        (
            "step = 0.05",
            "step = 0.05\nscheme = 'gauss-8'",
            &[
                "friction, forces or noise has no direct gauss-8; direct has implicit-midpoint",
                "^^",
            ],
        ),
        (
            "step = 0.05",
            "step = 0.05\nformulation = 'collective'",
            &["has no collective implicit-midpoint; it has direct implicit-midpoint"],
        ),
        ("step = 0.05", "step = 60", &["it must be at most 100"]),
        (
            "kind = 'spin-lattice'\nparameters = { shape = [16], exchange = 1 }",
            "kind = 'vibrating-lattice'\nparameters = { atoms = 4, exchange = 1 }",
            &["[damping] is for tops and systems by formula", "other systems of arrays"],
        ),
        (
            "kind = 'spin-lattice'\nparameters = { shape = [16], exchange = 1 }\ninitial.direction = [0, 0, 1]",
            "algebra = 'so(3)'\nhamiltonian = 'Pi3'\ninitial.Pi = [0, 0, 1]",
            &[],
        ),
    ] {
        let text = RING.replace(old, new);
        assert_ne!(text, RING, "{old}");
        folder.write("a.toml", &text);
        let done = folder.heavytop(&["simulate", "a.toml", "--out", "a.csv"]);
        let told = done.stderr();
        let expected = if parts.is_empty() { 0 } else { 2 };
        assert_eq!(done.code(), expected, "{new}: {told}");
        assert!(parts.iter().all(|part| told.contains(part)), "{new}: {told}");
        if expected == 0 {
            std::fs::remove_file(folder.path("a.csv")).unwrap();
        }
        assert_eq!(folder.names(), ["a.toml"], "{new}");
    }
    folder.write("a.toml", &RING.replace("initial.direction = [0, 0, 1]", wave));
    for command in ["sweep", "section", "events"] {
        let done = folder.heavytop(&[command, "a.toml", "--out", "a"]);
        assert!(done.code() == 2 && folder.names() == ["a.toml"], "{}", done.stderr());
    }
}
