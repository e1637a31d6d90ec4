//! Gilbert's damping of spins by formula: the implicit equation, both brackets, orders, Casimirs, and a temperature.

use super::support::{Texts, after, distance, method, open};
use collective_integrators::{
    AnyState, BrownianPaths, Driven, Integrator, NoiseRule, Noisy, RungeKutta, Start, fitted_order,
};
use lie_poisson::{
    Autonomous, Covector, GilbertDamping, LiePoisson, Noise, OrbitField, Pair, PathNumber,
    PoissonSpace, Real, Sign, So3, Time, euclidean_norm, from_closure,
};
use lie_poisson_formula_systems::{
    Damping, FormulaSystem, FormulaSystemError, NamedInputs, OpenNames, OpenSystem,
    OpenSystemError, OpenTerms, SystemAlgebra,
};
use lie_poisson_formulas::{Coordinates, Parameters};
use momentum_map::HOPF;
use nalgebra::{Rotation3, Unit, Vector3};

const BODY: &str = "(Pi1^2 + Pi2^2/2 + Pi3^2/3)/2";
const START: [f64; 3] = [0.6, -0.5, 1.2];

/// Two spins of the lengths √2.05 and √0.53, with an exchange and a field.
const PAIR: &str = "-Pi_1·Pi_2 - 0.5*Pi_1_3 - Pi_2_1^2/3";
const SPINS: [f64; 6] = [0.6, -0.5, 1.2, 0.4, 0.6, -0.1];

/// dh of `BODY`.
struct Body;

impl OrbitField<LiePoisson<So3>> for Body {
    fn element(&self, Covector(pi): &Covector<Vector3<f64>>, _: f64) -> Vector3<f64> {
        Vector3::new(pi.x, pi.y * 0.5, pi.z * (1.0 / 3.0))
    }
}

fn gilbert(damping: f64) -> Texts {
    Texts { gilbert: Some(damping), ..Texts::default() }
}

/// Returns the spin of `BODY` with a bracket, damped.
fn spin(is_plus: bool, damping: f64) -> OpenSystem {
    let algebra = SystemAlgebra::named("so(3)").unwrap();
    let base = FormulaSystem::new(algebra, BODY, &Parameters::new()).unwrap();
    let base = if is_plus { base.with_plus_bracket().unwrap() } else { base };
    let damping = Some(Damping::Gilbert(damping));
    OpenSystem::new(base, OpenTerms { damping, ..OpenTerms::default() }, 0.1).unwrap()
}

#[test]
fn a_damped_spin_is_the_typed_one_in_both_brackets() {
    for (is_plus, sign) in [(false, Sign::Minus), (true, Sign::Plus)] {
        let found = spin(is_plus, 0.7).rate(&START, 0.0).unwrap();
        let space = LiePoisson::new(So3, sign);
        let field = GilbertDamping::new(space, Body, 0.7).unwrap();
        let at = Covector(Vector3::from(START));
        let expected = space.hamiltonian_vector(&at, &field.element(&at, 0.0)).0;
        assert!(distance(&found, expected.as_slice()) < 1e-15, "{found:?} {expected}");
        // Control: the other bracket.
        let other = spin(!is_plus, 0.7).rate(&START, 0.0).unwrap();
        assert!(distance(&found, &other) > 0.1);
    }
    let h = from_closure::<LiePoisson<So3>, _>(|Covector(pi)| {
        (pi.x * pi.x + pi.y * pi.y * 0.5 + pi.z * pi.z * (1.0 / 3.0)) * 0.5
    });
    let field = GilbertDamping::new(LiePoisson::minus(So3), Autonomous(h), 0.7).unwrap();
    let typed = Driven::new(RungeKutta::gauss(2).unwrap(), HOPF, field);
    let from = Pair(Covector(Vector3::from(START)), Time(0.0));
    let Pair(Covector(expected), _) = typed.after(&from, 0.1, 200).unwrap().momentum;
    let found = after(&spin(false, 0.7), ("collective", "gauss-4"), &START, 0.1, 200);
    // 200 steps of some roundings each.
    assert!(distance(&found, expected.as_slice()) < 1e-12, "{found:?} {expected}");
}

fn vectors(x: &[f64]) -> Vec<Vector3<f64>> {
    x.as_chunks::<3>().0.iter().map(|x| Vector3::from(*x)).collect()
}

/// ds/dt = s × Ω + (α/|s|) s × ds/dt for each spin of the minus bracket, and dh/dt = −Σ α/((1 + α²)|s|) |s × Ω|².
#[test]
fn each_spin_obeys_gilberts_equation_in_all_units() {
    for (damping, unit) in [(0.0, 1.0), (0.4, 1.0), (2.0, 1.0), (0.4, 1e-20), (0.4, 1e20)] {
        // The exchange scales with the spins, the field does not.
        let [damped, free] =
            [damping, 0.0].map(|damping| open("so(3)^2", PAIR, &gilbert(damping), 0.1).unwrap());
        let start = SPINS.map(|x| x * unit);
        let [rate, torque] = [&damped, &free].map(|system| system.rate(&start, 0.0).unwrap());
        let (mut loss, mut size) = (0.0, 0.0);
        let all = vectors(&start).into_iter().zip(vectors(&rate)).zip(vectors(&torque));
        for ((s, rate), torque) in all {
            let implicit =
                |damping: f64| (rate - torque - s.cross(&rate) * (damping / s.norm())).norm();
            // Round-off of some ten operations.
            assert!(implicit(damping) <= 1e-14 * (1.0 + damping) * torque.norm(), "{damping}");
            assert!(implicit(damping + 0.1) >= 0.09 * rate.norm(), "control: {damping}");
            loss += damping / ((1.0 + damping * damping) * s.norm()) * torque.norm_squared();
            size += torque.norm_squared() / s.norm();
        }
        // h is a quadratic function: its central difference has no error but rounding, 1e-16 of h over 1e-3.
        let largest = rate.iter().map(|x| x.abs()).fold(0.0, f64::max);
        let short = 1e-3 * unit / largest;
        let moved = |time: f64| -> Vec<f64> {
            start.iter().zip(&rate).map(|(s, rate)| s + time * rate).collect()
        };
        let [later, before] = [short, -short].map(|time| damped.energy(&moved(time), 0.0));
        let slope = (later - before) / (2.0 * short);
        let rounding = 1e-15 * damped.energy(&start, 0.0).abs().max(size * short) / short;
        assert!((slope + loss).abs() <= 10.0 * rounding, "{damping} {unit:e}: {slope:e} {loss:e}");
        assert!(damping == 0.0 || loss > 100.0 * rounding, "control: {damping} {unit:e}");
    }
}

#[test]
fn methods_have_their_orders_and_keep_the_lengths() {
    let pair = |step| open("so(3)^2", PAIR, &gilbert(0.4), step).unwrap();
    let exact = after(&pair(0.02), ("collective", "gauss-12"), &SPINS, 0.02, 100);
    for (scheme, order) in [("implicit-midpoint", 2.0), ("gauss-4", 4.0)] {
        let error = |steps: u64| {
            let step = 2.0 / steps as f64;
            let end = after(&pair(step), ("collective", scheme), &SPINS, step, steps);
            (step, distance(&end, &exact))
        };
        let fitted = fitted_order(&[error(10), error(20), error(40)], 1e-13).unwrap();
        assert!((fitted - order).abs() < 0.15, "{scheme}: {fitted}");
    }
    let end = after(&pair(0.1), ("collective", "gauss-4"), &SPINS, 0.1, 1000);
    let lengths = |x: &[f64]| [0, 3].map(|i| x[i..i + 3].iter().map(|x| x * x).sum::<f64>());
    for (before, later) in lengths(&SPINS).into_iter().zip(lengths(&end)) {
        assert!((later - before).abs() < 1e-13, "{before} {later}");
    }
    // Control: a method on the equations themselves does not.
    let direct = after(&pair(0.1), ("direct", "rk4"), &SPINS, 0.1, 1000);
    assert!((lengths(&direct)[0] - lengths(&SPINS)[0]).abs() > 1e-7);
    // A spin of length 0 stays 0, and does not disturb the other one.
    let end = after(&pair(0.1), ("direct", "gauss-4"), &[0.6, -0.5, 1.2, 0.0, 0.0, 0.0], 0.1, 10);
    assert_eq!(end[3..], [0.0; 3]);
    assert!(end.iter().all(|x| x.is_finite()));
}

/// Noise of the strength √(2bkT) with b = α/((1 + α²)|s|), for α = 0.7 and a kT.
struct OfLength(f64);

impl<T: Real> Noise<LiePoisson<So3>, T> for OfLength {
    fn count(&self) -> usize {
        3
    }

    fn element(&self, Covector(pi): &Covector<Vector3<T>>, _: T, weights: &[T]) -> Vector3<T> {
        let strength = (T::from_f64(2.0 * 0.7 / 1.49 * self.0) / euclidean_norm(pi)).sqrt();
        Vector3::from_fn(|i, _| weights[i] * strength)
    }
}

#[test]
fn a_temperature_is_the_typed_noise_of_the_length() {
    let h = from_closure::<LiePoisson<So3>, _>(|Covector(pi)| {
        (pi.x * pi.x + pi.y * pi.y * 0.5 + pi.z * pi.z * (1.0 / 3.0)) * 0.5
    });
    let texts = Texts { temperature: Some(0.5), ..gilbert(0.7) };
    let system = open("so(3)", BODY, &texts, 0.05).unwrap();
    let length = Vector3::from(START).norm();
    let angle = (2.0 * 0.7 / (1.49 * length) * 0.5 * 0.05_f64).sqrt();
    assert!((system.noise_angle(&START, 0.05).unwrap() - angle).abs() < 1e-15);
    for (temperature, is_same) in [(0.5, true), (0.6, false)] {
        let field = GilbertDamping::new(LiePoisson::minus(So3), Autonomous(&h), 0.7).unwrap();
        let paths = BrownianPaths::new(1, 0.05).unwrap();
        let scheme = RungeKutta::gauss(2).unwrap();
        let typed = Noisy::new(scheme, HOPF, field, OfLength(temperature), paths);
        let from = Pair(Covector(Vector3::from(START)), Pair(PathNumber(7.0), Time(0.0)));
        let Pair(Covector(expected), _) = typed.after(&from, 0.05, 100).unwrap().momentum;
        let found = after(&system.clone().on_path(7), ("collective", "gauss-4"), &START, 0.05, 100);
        assert!((Vector3::from_column_slice(&found).norm() - length).abs() < 1e-13);
        let apart = distance(&found, expected.as_slice());
        // 100 steps of some roundings each.
        assert_eq!(apart < 1e-12, is_same, "{temperature}: {apart:e}");
    }
}

/// The strength depends on the length alone, so that each component of the noise turns the spin exactly, by −σΔW about its axis.
#[test]
fn components_of_the_noise_turn_a_spin_exactly() {
    let rule = NoiseRule::Alternating;
    let texts = Texts { temperature: Some(0.5), rule, ..gilbert(0.7) };
    let system = open("so(3)", "0*Pi1", &texts, 0.05).unwrap().on_path(7);
    let found = after(&system, ("collective", "implicit-midpoint"), &START, 0.05, 40);
    let paths = BrownianPaths::new(1, 0.05).unwrap();
    for keeps_order in [true, false] {
        let mut spin = Vector3::from(START);
        let strength = (2.0 * 0.7 / (1.49 * spin.norm()) * 0.5).sqrt();
        for step in 0..40 {
            // The last one is the coin.
            let mut increments = [0.0; 4];
            paths.write_increments(7, f64::from(step), f64::from(step) + 1.0, &mut increments);
            let is_forward = (increments[3] >= 0.0) == keeps_order;
            for k in if is_forward { [0, 1, 2] } else { [2, 1, 0] } {
                let axis = Unit::new_unchecked(Vector3::ith(k, 1.0));
                spin = Rotation3::from_axis_angle(&axis, -strength * increments[k]) * spin;
            }
        }
        // 120 turns of some roundings each.
        let apart = distance(&found, spin.as_slice());
        assert_eq!(apart < 1e-13, keeps_order, "{apart:e}");
    }
}

/// ⟨s₃⟩ = L (coth x − 1/x) with x = BL/kT for a spin of length L, by the means of 60 paths.
#[test]
#[ignore = "long"]
fn spins_of_two_lengths_at_a_temperature_have_langevins_means() {
    let texts = Texts { temperature: Some(0.5), ..gilbert(1.0) };
    let pair = open("so(3)^2", "-Pi_1_3 - Pi_2_3", &texts, 0.05).unwrap();
    let start = [1.0, 0.0, 0.0, 0.0, 2.0, 0.0];
    let integrator =
        pair.tangent_integrator(&method(&pair, "collective", "gauss-4"), &start).unwrap();
    let means: Vec<[f64; 2]> = (0..60)
        .map(|path| {
            let mut state = integrator.start(&AnyState::from_slice(&start)).unwrap();
            pair.move_path(state.as_mut_slice(), path);
            let run = integrator.trajectory_from(state, 0.05);
            let late: Vec<_> = run.map(Result::unwrap).skip(200).step_by(20).take(60).collect();
            [2, 5].map(|i| late.iter().map(|at| at.momentum.as_slice()[i]).sum::<f64>() / 60.0)
        })
        .collect();
    let n = means.len() as f64;
    for (i, length) in [1.0, 2.0_f64].into_iter().enumerate() {
        let mean = means.iter().map(|own| own[i]).sum::<f64>() / n;
        let square = means.iter().map(|own| (own[i] - mean).powi(2)).sum::<f64>();
        let error = (square / (n * (n - 1.0))).sqrt();
        let langevin = |x: f64| length * (x.tanh().recip() - x.recip());
        let exact = langevin(2.0 * length);
        assert!((mean - exact).abs() < 4.0 * error && error < 0.04, "{mean} ± {error}: {exact}");
        assert!((mean - langevin(length)).abs() > 4.0 * error, "control: {mean} ± {error}");
    }
}

#[test]
fn spins_are_told_by_their_brackets_and_other_algebras_are_refused() {
    let damped = |algebra: SystemAlgebra| {
        let name = algebra.coordinates().names().next().unwrap();
        let base = FormulaSystem::new(algebra, &name, &Parameters::new()).unwrap();
        let damping = Some(Damping::Gilbert(0.5));
        OpenSystem::new(base, OpenTerms { damping, ..OpenTerms::default() }, 0.1)
    };
    let of_brackets = |brackets: [(&str, &str); 3]| {
        let coordinates = Coordinates::scalars(["x", "y", "z"]).unwrap();
        SystemAlgebra::of_brackets(coordinates, brackets, &Parameters::new()).unwrap()
    };
    for algebra in ["so(3)", "su(2)", "so(3)^3", "so(3) + su(2)"] {
        assert!(damped(SystemAlgebra::named(algebra).unwrap()).is_ok(), "{algebra}");
    }
    let cyclic = [("x, y", "z"), ("y, z", "x"), ("z, x", "y")];
    assert!(damped(of_brackets(cyclic)).is_ok());
    // The same up to a scale, or a sign: the equation would be another one.
    for brackets in [
        [("x, y", "2*z"), ("y, z", "2*x"), ("z, x", "2*y")],
        [("x, y", "-z"), ("y, z", "x"), ("z, x", "y")],
    ] {
        let refused = damped(of_brackets(brackets)).unwrap_err();
        assert!(matches!(refused, OpenSystemError::NoSpins { .. }), "{refused}");
    }
    for name in ["se(3)", "so(4)", "se(2)", "so(3) + R3", "so(2,1)"] {
        let algebra = SystemAlgebra::named(name).unwrap();
        let refused = damped(algebra.clone()).unwrap_err();
        let told = refused.to_string();
        assert!(matches!(refused, OpenSystemError::NoSpins { .. }), "{told}");
        for part in [name, "form", "inner_product"] {
            assert!(told.contains(part), "{told}");
        }
        let names = OpenNames::new(algebra, &NamedInputs::default(), Parameters::new()).unwrap();
        assert_eq!(names.require_spins(), Err(refused));
    }
}

/// A temperature without friction would do nothing, in both forms; and one of 0 does nothing with any friction.
#[test]
fn a_temperature_needs_a_friction_above_zero() {
    let of = |friction: Option<f64>, gilbert: Option<f64>, temperature: f64| {
        let temperature = Some(temperature);
        open("so(3)", BODY, &Texts { friction, gilbert, temperature, ..Texts::default() }, 0.1)
    };
    for (friction, gilbert) in [(Some(0.0), None), (None, Some(0.0)), (Some(-0.0), None)] {
        assert!(of(friction, gilbert, 0.0).is_ok());
        let refused = of(friction, gilbert, 0.5).unwrap_err();
        let expected = OpenSystemError::TemperatureWithoutFriction { temperature: 0.5 };
        assert!(matches!(&refused, FormulaSystemError::Open(error) if *error == expected));
    }
    for (damping, temperature, part) in [
        (-0.1, 0.5, "-0.1"),
        (f64::NAN, 0.5, "NaN"),
        (0.5, -2.0, "-2"),
        (0.5, f64::INFINITY, "inf"),
    ] {
        let Err(FormulaSystemError::Open(told)) = of(None, Some(damping), temperature) else {
            panic!("{damping} {temperature}");
        };
        let told = told.to_string();
        assert!(told.contains(part) && told.contains("0 or a positive number"), "{told}");
    }
}

/// Backward in time the weight of states would be exp(+h/kT); without a temperature, or without friction, there is a way back.
#[test]
fn a_temperature_has_no_way_back() {
    let of = |friction: Option<f64>, gilbert: Option<f64>, temperature: Option<f64>, step: f64| {
        open("so(3)", BODY, &Texts { friction, gilbert, temperature, ..Texts::default() }, step)
    };
    for (friction, gilbert) in [(Some(0.3), None), (None, Some(0.3))] {
        let refused = of(friction, gilbert, Some(0.5), -0.1).unwrap_err();
        let expected = OpenSystemError::BackAtTemperature { friction: 0.3, step: -0.1 };
        assert!(matches!(&refused, FormulaSystemError::Open(error) if *error == expected));
        assert!(of(friction, gilbert, Some(0.5), 0.1).is_ok());
        assert!(of(friction, gilbert, Some(0.0), -0.1).is_ok());
        assert!(of(friction, gilbert, None, -0.1).is_ok());
    }
    // Noise of fields beside friction has no temperature.
    let noise = Some(vec![vec!["0.1", "0", "0"]]);
    let texts = Texts { friction: Some(0.3), noise, ..Texts::default() };
    assert!(open("so(3)", BODY, &texts, -0.1).is_ok());
}
