//! `heavytop sweep` of systems and tops with forces: rows as of `simulate`, threads, interruptions, and refusals.

use crate::commands::sweep::{column, rows};
use crate::program::{Folder, numbers};

/// A driven and damped spin at a temperature, in a table of an input.
const SPIN: &str = "\
[system]
algebra = 'so(3)'
hamiltonian = '-B*Pi3 - u*cos(t)*Pi1'
parameters.B = 2
initial.Pi = [1, 0, 0]
[inputs.u]
times = [0, 0.7, 2]
values = [0, 1, 0.5]
interpolation = 'linear'
[drive]
Pi = ['B*u', 0, 0]
[damping]
friction = 0.1
[noise]
temperature = 0.5
[integrator]
step = 0.1
end = 2
";

/// A top that is braked.
const TOP: &str = "\
[body]
inertia = [0.3, 0.3, 0.2]
weight_moment = 1
center_of_mass = [0, 0, 1]
[initial]
angular_velocity = [0, 0, 30]
inclination = '5 deg'
[damping]
friction = 0.2
inner_product = 1
[torque]
Pi = ['-0.1*Pi1', '-0.1*Pi2', '-u*Pi3']
[inputs.u]
file = 'u.csv'
interpolation = 'cubic'
[integrator]
step = 0.01
end = 0.5
";

/// Returns the tables of axes, of which each varies one number over three values.
fn axes(of: &[(&str, f64, f64)]) -> String {
    let axis = |(name, from, to): &(&str, f64, f64)| {
        format!("{{ parameter = '{name}', from = {from}, to = {to}, count = 3 }}")
    };
    let axes: Vec<String> = of.iter().map(axis).collect();
    format!(
        "[sweep]\nobservables = ['final-state', 'invariant-drift']\naxes = [{}]\n",
        axes.join(", ")
    )
}

#[test]
fn a_row_has_the_bits_of_simulate() {
    let folder = Folder::new();
    folder.write("u.csv", "t,u\n0,0.1\n0.2,0.4\n0.5,0.2\n");
    let in_time = SPIN.split("[inputs.u]").next().unwrap().replace("u*cos", "cos");
    let in_time = format!("{in_time}[integrator]\nstep = 0.1\nend = 2\n");
    let brackets = "[system]\ncoordinates = ['K', 'H', 'P']\n\
        brackets = { 'K, H' = 'a*P', 'K, P' = 'H' }\nhamiltonian = 'K^2/2 + b*H^2'\n\
        parameters = { a = 1, b = 0.75 }\ninitial = { K = 0.1, H = 0.3, P = -0.2 }\n\
        [torque]\nK = '-b*K + sin(t)'\n[integrator]\nstep = 0.05\nend = 2\n";
    for (text, of, names, kept) in [
        (
            SPIN,
            &[("system.parameters.B", 1.0, 3.0), ("damping.friction", 0.1, 0.3)][..],
            &["Pi1", "Pi2", "Pi3"][..],
            &["h", "c1"][..],
        ),
        (
            SPIN,
            &[("system.initial.Pi[1]", -1.0, 1.0), ("noise.temperature", 0.1, 0.3)],
            &["Pi1", "Pi2", "Pi3"],
            &["h", "c1"],
        ),
        (SPIN, &[("inputs.u.values[1]", -1.0, 1.0)], &["Pi1", "Pi3"], &["h", "c1"]),
        (&in_time, &[("system.parameters.B", 1.0, 3.0)], &["Pi1", "Pi2", "Pi3"], &["h", "c1"]),
        (brackets, &[("system.parameters.a", 0.5, 2.0)], &["K", "H", "P"], &["h", "c1"]),
        (
            TOP,
            &[("body.weight_moment", 0.5, 1.5), ("damping.friction", 0.1, 0.4)],
            &["Pi1", "Pi2", "Pi3", "Gamma1", "Gamma2", "Gamma3"],
            &["h", "f1", "f2"],
        ),
        (TOP, &[("inputs.u.values[1]", 0.1, 0.9)], &["Pi3"], &["f1"]),
    ] {
        folder.write("sweep.toml", &format!("{text}{}", axes(of)));
        let swept = folder.heavytop(&["sweep", "sweep.toml", "--out", "s", "--restart", "--force"]);
        assert_eq!(swept.code(), 0, "{of:?}: {}", swept.stderr());
        let table = rows(&folder, "s/sweep.parquet");
        folder.write("run.toml", text);
        for number in [0, table.len() - 1] {
            let value = |name: &str| column(&table, name)[number].unwrap();
            let set = |(name, _, _): &(&str, f64, f64)| match name.strip_suffix("values[1]") {
                // One value of a list is not assigned alone.
                Some(_) if text == TOP => {
                    let end = value(name);
                    folder.write("u.csv", &format!("t,u\n0,0.1\n0.2,{end:?}\n0.5,0.2\n"));
                    "integrator.step=0.01".into()
                }
                Some(table) => format!("{table}values=[0, {:?}, 0.5]", value(name)),
                None => format!("{name}={:?}", value(name)),
            };
            let set: Vec<String> = of.iter().map(set).collect();
            let set = set.iter().flat_map(|set| ["--set", set]);
            let run = ["simulate", "run.toml", "--out", "run.csv", "--force"].into_iter();
            let run = folder.heavytop(&run.chain(set).collect::<Vec<_>>());
            assert_eq!(run.code(), 0, "{of:?}: {}", run.stderr());
            folder.write("u.csv", "t,u\n0,0.1\n0.2,0.4\n0.5,0.2\n");
            let (header, run) = numbers(&folder.read("run.csv"));
            let place = |name: &str| header.iter().position(|column| column == name).unwrap();
            for name in names {
                let end = run.last().unwrap()[place(name)];
                assert_eq!(value(name), end, "{of:?} {number} {name}");
                // Control: another member ends elsewhere.
                assert_ne!(column(&table, name)[1].unwrap(), end, "{of:?} {number} {name}");
            }
            for name in kept {
                let first = run[0][place(name)];
                let deviation = |row: &Vec<f64>| (row[place(name)] - first).abs();
                let largest = run.iter().map(deviation).fold(0.0, f64::max);
                assert_eq!(value(&format!("drift_{name}")), largest, "{of:?} {number} {name}");
            }
        }
    }
}

#[test]
fn no_bit_depends_on_threads() {
    let folder = Folder::new();
    let of = [("system.parameters.B", 1.0, 3.0), ("damping.friction", 0.1, 0.3)];
    folder.write("a.toml", &format!("{SPIN}{}", axes(&of)));
    for threads in ["1", "4"] {
        let options = ["--threads", threads, "--quiet"];
        let run = ["sweep", "a.toml", "--out", threads];
        assert_eq!(
            folder.heavytop(&[run, [options[0], options[1], options[2], "--yes"]].concat()).code(),
            0
        );
    }
    for name in ["sweep.parquet", "Pi3.svg", "drift_c1.svg"] {
        let read =
            |threads: &str| std::fs::read(folder.path(&format!("{threads}/{name}"))).unwrap();
        assert!(read("1") == read("4"), "{name}");
    }
}

/// A torque −kΠ shrinks every tangent vector at the rate k, by every formulation that there is.
#[test]
fn indicators_of_chaos_are_those_of_motions_with_forces() {
    let folder = Folder::new();
    let text = SPIN
        .split_once("[damping]")
        .unwrap()
        .0
        .replace("parameters.B = 2", "parameters = { B = 2, k = 0 }");
    let sweep = "[integrator]\nstep = 0.1\nend = 2\n[sweep]\nobservables = ['lyapunov', 'megno', 'sali', 'final-state']\n\
                 axes = [{ parameter = 'system.parameters.k', from = 0.1, to = 0.4, count = 3 }]\n";
    folder
        .write("a.toml", &format!("{text}[torque]\nPi = ['-k*Pi1', '-k*Pi2', '-k*Pi3']\n{sweep}"));
    let done = folder.heavytop(&["sweep", "a.toml", "--out", "s"]);
    assert_eq!(done.code(), 0, "{}", done.stderr());
    let swept = rows(&folder, "s/sweep.parquet");
    let of = |name: &str| -> Vec<f64> { column(&swept, name).into_iter().flatten().collect() };
    let (rates, sali) = (of("system.parameters.k"), of("sali"));
    assert_eq!((rates.len(), sali.len()), (3, 3));
    for (i, k) in rates.into_iter().enumerate() {
        let (lyapunov, megno) = (of("lyapunov")[i], of("megno")[i]);
        // Twenty steps whose stages are solved to round-off.
        assert!((lyapunov + k).abs() < 1e-11, "{lyapunov} {k}");
        // MEGNO of a vector that shrinks as exp(−kt) is −kt, and its mean −kt/2; of sums over n steps −(kt/2)(1 + 3/n).
        assert!((megno + k * 1.15).abs() < 1e-10 && sali[i] > 0.1, "{megno} {k} {sali:?}");
    }
}

#[test]
fn what_a_sweep_with_forces_does_not_have_is_refused() {
    let folder = Folder::new();
    folder.write("u.csv", "t,u\n0,0.1\n0.2,0.4\n0.5,0.2\n");
    let friction = [("damping.friction", 0.1, 0.3)];
    for (text, of, sets, parts) in [
        (
            SPIN,
            &friction[..],
            "sweep.observables=['relative-drift']",
            &["relative-drift", "without forces"][..],
        ),
        (
            TOP,
            &friction,
            "sweep.observables=['rotation-number']",
            &["rotation-number", "final-state, invariant-drift, lyapunov, sali, megno"],
        ),
        (TOP, &friction, "sweep.observables=['nutation-amplitude']", &["nutation-amplitude"]),
        (SPIN, &[("noise.strength", 0.1, 0.2)], "sweep.seed=0", &["there is no noise.strength"]),
        (SPIN, &[("noise.seed", 0.1, 0.2)], "sweep.seed=0", &["noise.seed", "noise.temperature"]),
        (SPIN, &[("inputs.u.values[3]", 0.1, 0.2)], "sweep.seed=0", &["from 0 to 2", "got 3"]),
        (SPIN, &[("inputs.v.values[0]", 0.1, 0.2)], "sweep.seed=0", &["there is no inputs.v"]),
        (SPIN, &[("body.mass", 0.1, 0.2)], "sweep.seed=0", &["body.mass is of a top"]),
        (SPIN, &[friction[0], friction[0]], "sweep.seed=0", &["set the same thing"]),
        (
            SPIN,
            &[("damping.friction", 0.2, -0.1)],
            "sweep.seed=0",
            &["the axis damping.friction", "at least 0, got -0.1"],
        ),
        (
            SPIN,
            &[("noise.temperature", -1.0, 2.0)],
            "sweep.seed=0",
            &["the axis noise.temperature", "at least 0, got -1"],
        ),
        (TOP, &[("system.initial.x", 0.1, 0.2)], "sweep.seed=0", &["is of [system]"]),
        (SPIN, &friction, "integrator.end=3", &["from 0 to 2", "from 0 to 3"]),
        (TOP, &friction, "integrator.end=1", &["u.csv", "from 0 to 0.5", "from 0 to 1"]),
    ] {
        folder.write("a.toml", &format!("{text}{}", axes(of)));
        let refused = folder.heavytop(&["sweep", "a.toml", "--out", "s", "--set", sets]);
        let said = refused.stderr();
        assert_eq!(refused.code(), 2, "{of:?}: {said}");
        assert!(parts.iter().all(|part| said.contains(part)), "{of:?}: {said}");
        assert!(!folder.path("s").exists());
    }
    // Without forces there is no number of one.
    let closed =
        "[sweep]\naxes = [{ parameter = 'damping.friction', from = 0, to = 1, count = 2 }]\n";
    folder.write("a.toml", closed);
    let refused = folder.heavytop(&["sweep", "a.toml", "--out", "s"]);
    assert!(
        refused.code() == 2 && refused.stderr().contains("there is none here"),
        "{}",
        refused.stderr()
    );
}

/// σ√h at the largest number of the axis, √(2θkT h) of a temperature, whatever the configuration has.
#[test]
fn a_sweep_warns_of_its_strongest_noise() {
    let folder = Folder::new();
    let shaken = SPIN.replace("temperature = 0.5", "strength = 0.1");
    for (base, parameter, to, expected) in [
        (shaken.as_str(), "noise.strength", 3.0, Some("9.5e-1 rad")),
        (&shaken, "noise.strength", 0.9, None),
        (SPIN, "noise.temperature", 45.0, Some("9.5e-1 rad")),
        (SPIN, "noise.temperature", 4.0, None),
    ] {
        let axes = axes(&[(parameter, 0.1, to)]);
        folder.write("a.toml", &format!("{base}{axes}"));
        let done = folder.heavytop(&["sweep", "a.toml", "--out", "s", "--restart", "--force"]);
        let told = done.stderr();
        assert_eq!(done.code(), 0, "{told}");
        assert_eq!(told.contains("the noise turns the state"), expected.is_some(), "{told}");
        assert!(expected.is_none_or(|angle| told.contains(angle)), "{told}");
    }
}
