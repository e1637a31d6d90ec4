//! Units of mass, length and time: what `simulate` and `sweep` report is a number that does not depend on them, or is
//! multiplied by its unit. `compare`, which takes longer, is tested beside its measurements.

use crate::commands::sweep::{column, failures, rows};
use crate::program::{Folder, numbers};
use serde_json::Value;

/// The units in which a configuration is written.
#[derive(Clone, Copy, Debug)]
struct Units {
    mass: f64,
    length: f64,
    time: f64,
}

const ONE: Units = Units { mass: 1.0, length: 1.0, time: 1.0 };

/// The sizes of units that are tried.
const SIZES: [f64; 6] = [1e-30, 1e-15, 1e-6, 1e6, 1e15, 1e30];

impl Units {
    /// Returns the unit of each kind with a size.
    fn of_size(size: f64) -> [Self; 3] {
        [Self { mass: size, ..ONE }, Self { length: size, ..ONE }, Self { time: size, ..ONE }]
    }

    fn momentum(self) -> f64 {
        self.mass * self.length * self.length / self.time
    }

    fn energy(self) -> f64 {
        self.momentum() / self.time
    }

    /// Returns the unit of a column, or of a value of a summary.
    fn of(self, name: &str) -> f64 {
        match name.trim_start_matches("drift_") {
            "t" | "step" | "end" => self.time,
            "Pi1" | "Pi2" | "Pi3" | "f2" | "c1" => self.momentum(),
            "h" => self.energy(),
            "lyapunov" => 1.0 / self.time,
            _ => 1.0,
        }
    }

    /// Returns the table of steps; Γ and Π change by the errors of a method of order 2 in 40 of them.
    fn integrator(self, formulation: &str, scheme: &str) -> String {
        let [step, end] = [0.05, 2.0].map(|t| t * self.time);
        format!(
            "[integrator]\nformulation = '{formulation}'\nscheme = '{scheme}'\nstep = {step:e}\nend = {end:e}\n"
        )
    }

    /// Returns a top without a symmetry.
    fn top(self) -> String {
        let moment = |x: f64| x * self.mass * self.length * self.length;
        let [first, second, third] = [1.0, 1.4, 2.1].map(moment);
        let [x, y, z] = [1.2, -0.7, 2.3].map(|x| x * self.momentum());
        format!(
            "[body]\ninertia = [{first:e}, {second:e}, {third:e}]\nmass = {:e}\ngravity = {:e}\n\
             length = {:e}\ncenter_of_mass = [0.6, 0.0, 0.8]\n\
             [initial]\nangular_momentum = [{x:e}, {y:e}, {z:e}]\nvertical = [0.0, 0.8, 0.6]\n",
            0.7 * self.mass,
            9.81 * self.length / self.time / self.time,
            0.2 * self.length,
        )
    }

    /// Returns the same top as a system by a formula, with f₂ and f₁ as the Casimirs c₁ and c₂.
    fn system(self) -> String {
        let moment = |x: f64| x * self.mass * self.length * self.length;
        let [first, second, third] = [1.0, 1.4, 2.1].map(moment);
        let [x, y, z] = [1.2, -0.7, 2.3].map(|x| x * self.momentum());
        format!(
            "[system]\nalgebra = 'se(3)'\n\
             hamiltonian = '(Pi1^2/I1 + Pi2^2/I2 + Pi3^2/I3)/2 + w*(0.6*Gamma1 + 0.8*Gamma3)'\n\
             parameters = {{ I = [{first:e}, {second:e}, {third:e}], w = {:e} }}\n\
             initial = {{ Pi = [{x:e}, {y:e}, {z:e}], Gamma = [0.0, 0.8, 0.6] }}\n",
            0.7 * 9.81 * 0.2 * self.energy(),
        )
    }
}

/// A value with its name.
type Named = (String, f64);

/// Runs the program, which must succeed.
fn run(folder: &Folder, arguments: &[&str], what: &str) -> String {
    let run = folder.heavytop(arguments);
    assert_eq!(run.code(), 0, "{what}: {}", run.stderr());
    run.stdout()
}

/// Asserts that values in units are those in the units 1, to a tolerance. What was rounding there may be any rounding.
fn assert_same(what: &str, units: Units, found: &[Named], reference: &[Named], tolerance: f64) {
    assert_eq!(found.len(), reference.len(), "{what}");
    for ((name, found), (_, reference)) in found.iter().zip(reference) {
        let found = found / units.of(name);
        let gap = (found - reference).abs();
        let is_the_same = gap <= tolerance * reference.abs() + 1e-12;
        assert!(is_the_same, "{what}, {units:?}, {name}: {found:e} {reference:e}");
    }
}

/// The errors of the methods are above 1e-9, where rounding changes them by 1e-7; estimates have two digits.
const TOLERANCE: f64 = 1e-6;

/// Returns what `simulate --check` tells: the last row, the deviations, the estimate, and the error with its order.
fn simulated(folder: &Folder, text: &str) -> Vec<Named> {
    folder.write("units.toml", text);
    let arguments =
        ["simulate", "units.toml", "--out", "units.csv", "--check", "--json", "--force"];
    let told: Value = serde_json::from_str(&run(folder, &arguments, text)).unwrap();
    let (header, table) = numbers(&folder.read("units.csv"));
    let mut found: Vec<Named> = header.into_iter().zip(table.last().unwrap().clone()).collect();
    let deviations = told["deviations"].as_object().unwrap().iter();
    found.extend(deviations.map(|(name, value)| (name.clone(), value.as_f64().unwrap())));
    for name in ["error_estimate", "error", "order"] {
        let value = told[name].as_f64().unwrap_or_else(|| panic!("{name} of {told}"));
        found.push((name.into(), value));
    }
    found
}

#[test]
fn simulate_tells_the_same_in_all_units() {
    let folder = Folder::new();
    type Text = fn(Units) -> String;
    let texts: [(&str, Text); 4] = [
        ("a top", |units| units.top() + &units.integrator("direct", "rk4")),
        ("a top, collective", |units| units.top() + &units.integrator("collective", "gauss-4")),
        ("a system", |units| units.system() + &units.integrator("direct", "rk4")),
        ("a system, reduced", |units| units.system() + &units.integrator("reduced", "gauss-4")),
    ];
    for (what, text) in texts {
        let reference = simulated(&folder, &text(ONE));
        for units in SIZES.into_iter().flat_map(Units::of_size) {
            let found = simulated(&folder, &text(units));
            assert_same(what, units, &found, &reference, TOLERANCE);
            // Control: a number with a unit is another number in another unit.
            let energy = |values: &[Named]| values.iter().find(|(name, _)| name == "h").unwrap().1;
            assert!((energy(&found) / energy(&reference) - 1.0).abs() > 0.5, "{what} {units:?}");
        }
    }
}

/// Returns the numbers of a sweep over two of the tops or systems.
fn swept(folder: &Folder, text: &str) -> Vec<Named> {
    folder.write("units.toml", text);
    run(folder, &["sweep", "units.toml", "--out", "units", "--force"], text);
    let rows = rows(folder, "units/sweep.parquet");
    assert!(failures(&rows).iter().all(Option::is_none), "{text}");
    let names = rows[0].get_column_iter().map(|(name, _)| name.clone());
    let names: Vec<String> =
        names.filter(|name| !["index", "failure"].contains(&name.as_str())).collect();
    let values = |name: &String| {
        let values = column(&rows, name).into_iter().map(Option::unwrap);
        values.map(|value| (name.clone(), value)).collect::<Vec<_>>()
    };
    names.iter().filter(|name| !name.contains('.')).flat_map(values).collect()
}

/// Observables of every sweep.
const SHARED: &str =
    "'final-state', 'invariant-drift', 'relative-drift', 'lyapunov', 'megno', 'sali'";

/// Returns an axis of two values of a number with a unit.
fn axis(name: &str, unit: f64) -> String {
    let [from, to] = [1.5 * unit, 2.5 * unit];
    format!("axes = [{{ parameter = '{name}', from = {from:e}, to = {to:e}, count = 2 }}]\n")
}

fn sweeps_tell_the_same(what: &str, text: impl Fn(Units) -> String) {
    let folder = Folder::new();
    let reference = swept(&folder, &text(ONE));
    for units in [1e-30, 1e-6, 1e15].into_iter().flat_map(Units::of_size) {
        let found = swept(&folder, &text(units));
        assert_same(what, units, &found, &reference, TOLERANCE);
        // Control: a deviation that is not relative is another number in another unit.
        let drift = |values: &[Named]| values.iter().find(|(n, _)| n == "drift_h").unwrap().1;
        assert!((drift(&found) / drift(&reference) - 1.0).abs() > 0.5, "{what} {units:?}");
    }
}

#[test]
#[ignore = "long"]
fn sweeps_of_tops_tell_the_same_in_all_units() {
    sweeps_tell_the_same("tops", |units| {
        let sweep = axis("initial.angular_momentum[2]", units.momentum());
        let own = "'rotation-number', 'nutation-amplitude'";
        // Two maxima of the height.
        let run = units.integrator("splitting", "strang").replace("end = 2e", "end = 8e");
        format!("{}[sweep]\nobservables = [{SHARED}, {own}]\n{sweep}{run}", units.top())
    });
}

#[test]
#[ignore = "long"]
fn sweeps_of_systems_tell_the_same_in_all_units() {
    for (formulation, scheme) in [("collective", "rk4"), ("reduced", "gauss-4"), ("direct", "rk4")]
    {
        sweeps_tell_the_same(formulation, |units| {
            let sweep = axis("system.initial.Pi[2]", units.momentum());
            let run = units.integrator(formulation, scheme);
            format!("{}[sweep]\nobservables = [{SHARED}]\n{sweep}{run}", units.system())
        });
    }
}
