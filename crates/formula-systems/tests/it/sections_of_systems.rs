//! Poincaré sections: starts on the level set, in all units, and what is refused.

use crate::support::system;
use collective_integrators::Direction;
use lie_poisson_formula_systems::{
    FormulaSystem, FormulaSystemError, SystemAlgebra, SystemSection,
};
use lie_poisson_formulas::Parameters;

const BODY: &str = "(Pi1^2 + Pi2^2/2 + Pi3^2/3 + Gamma1^2 + Gamma2^2/2 + Gamma3^2/3)/2";

fn body() -> FormulaSystem {
    system(SystemAlgebra::named("se(3)").unwrap(), BODY)
}

fn section(body: &FormulaSystem, surface: &str, at: (f64, Direction)) -> SystemSection {
    SystemSection::new(body, surface, &Parameters::new(), at).unwrap()
}

#[test]
fn starts_are_on_the_level_and_cross_in_the_direction() {
    let (body, state) = (body(), [1.0, 0.5, 0.3, 0.6, 0.0, 0.8]);
    let levels = body.invariants(&state).unwrap();
    for direction in [Direction::Up, Direction::Down] {
        let section = section(&body, "Gamma3 + Pi1*Pi2/10", (0.1, direction));
        let starts = section.starts(&state, &levels, 20, 0).unwrap();
        for start in &starts {
            assert!(section.value(start).abs() < 1e-15);
            // Rounding of numbers of size 1.
            for (value, level) in body.invariants(start).unwrap().iter().zip(&levels) {
                assert!((value - level).abs() < 1e-14, "{value} {level}");
            }
            let rate = body.rate(start).unwrap();
            let along = rate[5] + (rate[0] * start[1] + rate[1] * start[0]) / 10.0;
            assert!(if direction == Direction::Up { along > 0.0 } else { along < 0.0 });
        }
        // The starts differ from each other, and a longer list begins with a shorter one.
        assert!(starts.windows(2).all(|pair| (pair[0][0] - pair[1][0]).abs() > 1e-6));
        assert_eq!(section.starts(&state, &levels, 3, 0).unwrap(), starts[..3]);
        assert_ne!(section.starts(&state, &levels, 3, 1).unwrap(), starts[..3]);
    }
}

/// Half turns about the axes keep the energy, |Π| and Π₁Π₂Π₃, and move four points into each other. Guesses lead to all.
#[test]
fn starts_are_on_all_sides() {
    let body = system(SystemAlgebra::named("so(3)").unwrap(), "(Pi1^2 + Pi2^2/2 + Pi3^2/3)/2");
    let state = [0.6, 0.5, (1.0_f64 - 0.36 - 0.25).sqrt()];
    let levels = body.invariants(&state).unwrap();
    let section = section(&body, "Pi1*Pi2*Pi3", (state.iter().product(), Direction::Both));
    let starts = section.starts(&state, &levels, 60, 0).unwrap();
    for signs in [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]] {
        let found = starts.iter().filter(|x| x.iter().zip(signs).all(|(x, s)| x * s > 0.0)).count();
        // 15 are expected, with a standard deviation of 3.4.
        assert!(found > 1, "{signs:?}: {found}");
    }
}

#[test]
fn units_do_not_matter() {
    let state = [1.0, 0.5, 0.3, 0.6, 0.0, 0.8];
    let at = (0.0, Direction::Up);
    let plain = body();
    let starts = |body: &FormulaSystem, state: &[f64]| {
        let levels = body.invariants(state).unwrap();
        section(body, "Gamma3", at).starts(state, &levels, 10, 0).unwrap()
    };
    let expected = starts(&plain, &state);
    for scale in [2.0_f64.powi(100), 2.0_f64.powi(-100)] {
        // Π in another unit: h keeps its values with Π/scale for Π.
        let factor = 1.0 / scale;
        let text = BODY.replace("Pi", &format!("{:e}*Pi", factor * factor));
        let scaled = system(SystemAlgebra::named("se(3)").unwrap(), &text);
        let mut large = state;
        large[..3].iter_mut().for_each(|x| *x *= scale);
        for (start, expected) in starts(&scaled, &large).iter().zip(&expected) {
            for (i, (x, y)) in start.iter().zip(expected).enumerate() {
                let x = if i < 3 { x / scale } else { *x };
                assert!((x - y).abs() < 1e-9, "{i}: {x} {y}");
            }
        }
    }
}

/// Coordinates that are numbers are measured by their length together. A power of two is exact.
#[test]
fn units_of_numbers_do_not_matter() {
    let body = system(SystemAlgebra::named("sl(2)").unwrap(), "alpha^2 + beta^2/2 + gamma^2/3");
    let section = section(&body, "alpha", (0.0, Direction::Both));
    let starts = |scale: f64| {
        let state = [0.6, 0.5, 0.3].map(|x| x * scale);
        section.starts(&state, &body.invariants(&state).unwrap(), 10, 0).unwrap()
    };
    let plain = starts(1.0);
    for scale in [2.0_f64.powi(100), 2.0_f64.powi(-100)] {
        for (start, expected) in starts(scale).iter().zip(&plain) {
            assert!(start.iter().zip(expected).all(|(x, y)| (x / scale - y).abs() < 1e-9));
        }
    }
}

/// Returns the system of brackets of scalar coordinates, with the energy Σ (n + 1) x_n²/2.
fn of_brackets(names: &str, brackets: &[(&str, &str)]) -> FormulaSystem {
    let names: Vec<&str> = names.split(' ').collect();
    let coordinates = lie_poisson_formulas::Coordinates::scalars(names.iter().copied()).unwrap();
    let brackets = brackets.iter().copied();
    let algebra = SystemAlgebra::of_brackets(coordinates, brackets, &Parameters::new()).unwrap();
    let terms = names.iter().enumerate().map(|(n, x)| format!("{}*{x}^2", n + 1));
    system(algebra, &format!("({})/2", terms.collect::<Vec<_>>().join(" + ")))
}

/// The Casimirs of these algebras are no polynomials: y/x², x e^(−y/x), and an angle along a spiral. The starts lie on
/// the orbit of the state all the same.
#[test]
fn starts_lie_on_the_orbit_also_if_its_casimirs_are_unknown() {
    let none = Parameters::new();
    for (brackets, casimir) in [
        ([("a, x", "x"), ("a, y", "2*y")], "y/x^2"),
        ([("a, x", "x"), ("a, y", "x + y")], "x*exp(-y/x)"),
        ([("a, x", "0.3*x - y"), ("a, y", "x + 0.3*y")], "sqrt(x^2 + y^2)*exp(-0.3*atan2(y, x))"),
    ] {
        let body = of_brackets("a x y", &brackets);
        assert_eq!((body.casimirs().len(), body.missing_casimirs()), (0, Some(1)));
        let names = body.algebra().vocabulary(&none).unwrap();
        let casimir = lie_poisson_formulas::Formula::new(casimir, &names).unwrap();
        let state = [0.3, 0.5, 0.4];
        let levels = body.invariants(&state).unwrap();
        let starts = section(&body, "a", (0.1, Direction::Both)).starts(&state, &levels, 8, 0);
        for start in starts.unwrap() {
            let (found, expected) = (casimir.value_at(&start), casimir.value_at(&state));
            // The spiral has a cut at the angle π, where its Casimir jumps by a known factor.
            let turns = (found / expected).ln() / (0.3 * core::f64::consts::TAU);
            let error = if casimir.to_string().contains("atan2") {
                turns - turns.round()
            } else {
                found / expected - 1.0
            };
            assert!(error.abs() < 1e-12, "{casimir}: {found} {expected}");
            assert!((start[0] - 0.1).abs() < 1e-14);
            assert!((body.invariants(&start).unwrap()[0] - levels[0]).abs() < 1e-13);
        }
        // Another energy is allowed; a Casimir that is unknown cannot have another level.
        let other = [1.2 * levels[0]];
        assert!(section(&body, "a", (0.1, Direction::Both)).starts(&state, &other, 2, 0).is_ok());
    }
}

/// On the two sheets of a hyperboloid the Casimir has the same value, and at Γ = 0 both Casimirs of se(3) are 0 on
/// spheres of every radius.
#[test]
fn starts_lie_on_the_orbit_also_if_its_casimirs_do_not_tell() {
    let rotor = of_brackets("K H P", &[("K, H", "P"), ("K, P", "H"), ("H, P", "-K")]);
    let state = [0.2, 0.3, 1.0];
    assert_eq!(rotor.missing_casimirs(), Some(0));
    let levels = rotor.invariants(&state).unwrap();
    let section = section(&rotor, "K*H", (0.06, Direction::Both));
    for start in section.starts(&state, &levels, 6, 0).unwrap() {
        assert!(start[2] > 0.0, "{start:?}");
        assert!((rotor.invariants(&start).unwrap()[1] - levels[1]).abs() < 1e-13);
    }
    let (body, state) = (body(), [1.0, 0.5, 0.3, 0.0, 0.0, 0.0]);
    let levels = body.invariants(&state).unwrap();
    let section =
        SystemSection::new(&body, "Pi1 - 2*Pi2", &Parameters::new(), (0.0, Direction::Both));
    for start in section.unwrap().starts(&state, &levels, 4, 0).unwrap() {
        let square: f64 = start[..3].iter().map(|x| x * x).sum();
        assert!((square - 1.34).abs() < 1e-12, "{start:?}");
    }
}

/// Levels of Casimirs that are not those of the state choose the orbit nearest to it, if they determine one.
#[test]
fn other_levels_choose_another_orbit_or_are_refused() {
    let rotor = of_brackets("K H P", &[("K, H", "P"), ("K, P", "H"), ("H, P", "-K")]);
    let state = [0.2, 0.3, 1.0];
    let mut levels = rotor.invariants(&state).unwrap();
    levels[1] *= 1.1;
    let rotor_section = section(&rotor, "K", (0.1, Direction::Both));
    for start in rotor_section.starts(&state, &levels, 5, 0).unwrap() {
        assert!(start[2] > 0.0);
        assert!((rotor.invariants(&start).unwrap()[1] - levels[1]).abs() < 1e-13);
    }
    // z is a Casimir, and y/x² is one that is no polynomial.
    let lost = of_brackets("a x y z", &[("a, x", "x"), ("a, y", "2*y")]);
    let state = [0.3, 0.5, 0.4, 1.0];
    let mut levels = lost.invariants(&state).unwrap();
    let section = section(&lost, "a", (0.1, Direction::Both));
    assert!(section.starts(&state, &levels, 2, 0).is_ok());
    levels[1] += 0.1;
    let refused = section.starts(&state, &levels, 2, 0);
    assert_eq!(refused, Err(FormulaSystemError::UnknownOrbit { missing: Some(1) }));
}

#[test]
#[ignore = "long"]
fn what_is_no_section_is_refused() {
    type E = FormulaSystemError;
    let (body, state) = (body(), [1.0, 0.5, 0.3, 0.6, 0.0, 0.8]);
    let none = Parameters::new();
    let new = |text, level| SystemSection::new(&body, text, &none, (level, Direction::Both));
    assert!(matches!(new("Gama3", 0.0), Err(E::Surface(_))));
    assert!(matches!(new("Gamma3", f64::NAN), Err(E::Level { .. })));
    let wrong = new("Gamma3", 0.0).unwrap().with_axes(["Pi1", "Pi4"], &none);
    assert!(matches!(wrong, Err(E::Axis { axis: 1, .. })));
    let levels = body.invariants(&state).unwrap();
    let starts = |level| new("Gamma3", level).unwrap().starts(&state, &levels, 2, 0);
    // |Γ| = 1
    assert!(matches!(starts(1.5), Err(E::TooSmall { count: 2, found: 0, guesses: 2000 })));
    assert_eq!(starts(0.5).map(|starts| starts.len()), Ok(2));
    let two = SystemAlgebra::of_entries(
        lie_poisson_formulas::Coordinates::scalars(["x", "y"]).unwrap(),
        Vec::new(),
    );
    let two = FormulaSystem::new(two.unwrap(), "x", &none).unwrap();
    let error = SystemSection::new(&two, "x", &none, (0.0, Direction::Up)).unwrap_err();
    assert_eq!(error, E::NoAxes { dimension: 2 });
}

/// An angle is on the surface where it is the level up to turns of 2π, also at ±π, where `atan2` jumps.
#[test]
fn a_surface_may_be_an_angle() {
    use std::f64::consts::{PI, TAU};
    let (body, state) = (body(), [1.0, 0.5, 0.3, 0.6, 0.0, 0.8]);
    let levels = body.invariants(&state).unwrap();
    for level in [0.5, PI, -3.1, 7.0] {
        for direction in [Direction::Up, Direction::Down] {
            let section = section(&body, "atan2(Gamma2, Gamma1)", (level, direction));
            assert_eq!(section.period(), Some(TAU));
            for start in section.starts(&state, &levels, 6, 0).unwrap() {
                let difference = start[4].atan2(start[3]) - level;
                assert!((0.5 * difference).sin().abs() < 1e-14, "{level}: {difference}");
                assert!(section.value(&start).abs() < 1e-14);
                for (value, level) in body.invariants(&start).unwrap().iter().zip(&levels) {
                    assert!((value - level).abs() < 1e-13);
                }
                let rate = body.rate(&start).unwrap();
                let turning = rate[4] * start[3] - rate[3] * start[4];
                assert_eq!(turning > 0.0, direction == Direction::Up);
            }
        }
    }
    // Control: what is no angle has no period.
    assert_eq!(section(&body, "sin(atan2(Gamma2, Gamma1))", (0.5, Direction::Up)).period(), None);
}

/// Functions that cover half a turn have each value once: 2π more is another surface, which no state is on.
#[test]
fn half_a_turn_is_no_angle() {
    use core::f64::consts::TAU;
    let (body, state) = (body(), [1.0, 0.5, 0.3, 0.6, 0.0, 0.8]);
    let levels = body.invariants(&state).unwrap();
    for half in [
        "arctan(Gamma2/Gamma1)",
        "arcsin(Gamma2)",
        "arccos(Gamma2)",
        "atan2(Gamma2, 1)",
        "atan2(Gamma2, |Gamma1|)",
        "0.5 - arctan(Gamma2) + Gamma1",
    ] {
        let at = |level| section(&body, half, (level, Direction::Both));
        assert_eq!(at(0.6).period(), None, "{half}");
        for start in at(0.6).starts(&state, &levels, 2, 0).unwrap() {
            assert!(at(0.6).value(&start).abs() < 1e-14, "{half}");
            assert!((at(0.6 + TAU).value(&start) + TAU).abs() < 1e-14, "{half}");
        }
    }
    // Controls: an angle keeps its period beside functions that have none, and with an argument of either sign.
    for angle in ["atan2(Gamma2, Gamma1) + arctan(Pi1)", "Pi1 - atan2(Gamma2, -1)"] {
        assert_eq!(section(&body, angle, (0.6, Direction::Up)).period(), Some(TAU), "{angle}");
    }
}

/// A section is drawn over the first two coordinates that its surface does not fix, or over the formulas asked for.
#[test]
fn axes_are_the_free_coordinates_or_formulas() {
    let (body, state) = (body(), [1.0, 0.5, 0.3, 0.6, 0.0, 0.8]);
    let plain = section(&body, "Pi1", (0.25, Direction::Down));
    assert_eq!(plain.axes().each_ref().map(ToString::to_string), ["Pi2", "Pi3"]);
    assert_eq!(plain.plane(&state), [0.5, 0.3]);
    assert_eq!(plain.value(&state), 0.75);
    let parts = (plain.surface().to_string(), plain.level(), plain.direction());
    assert_eq!(parts, ("Pi1".to_owned(), 0.25, Direction::Down));
    assert_eq!(plain.system(), &body);
    let other = plain.with_axes(["Pi1 + 2*Pi2", "Gamma·Gamma"], &Parameters::new()).unwrap();
    assert_eq!(other.plane(&state)[0], 2.0);
    // Rounding of two squares and their sum.
    assert!((other.plane(&state)[1] - 1.0).abs() < 4.0 * f64::EPSILON);
    // Negative control: the axes change nothing else, and a state of another length has no place.
    assert_eq!(other.value(&state), 0.75);
    assert!(other.plane(&state[..4]).iter().all(|x| x.is_nan()));
    let levels = [f64::NAN];
    let lost = other.starts(&state, &levels, 1, 0);
    assert!(matches!(lost, Err(FormulaSystemError::Level { .. })));
}

/// Starts of motions with forces are on the orbit of the first, in all units, also where it is one of two sheets.
#[test]
fn states_of_an_orbit_have_its_casimirs() {
    let mut refused = Vec::new();
    for (algebra, h, state) in [
        ("se(3)", BODY, &[1.0, 0.5, 0.3, 0.6, 0.0, 0.8][..]),
        ("so(3)^2", "|Pi_1|^2", &[1.0, 0.5, 0.3, 0.6, 0.0, 0.8]),
        ("sl(2)", "alpha^2 + beta^2", &[0.3, 0.5, -0.7]),
    ] {
        let system = system(SystemAlgebra::named(algebra).unwrap(), h);
        for unit in [1.0, 1e-20, 1e20] {
            let state: Vec<f64> = state.iter().map(|x| x * unit).collect();
            let casimirs = |state: &[f64]| system.invariants(state).unwrap()[1..].to_vec();
            let states = system.orbit_states(&state, 8, 3).unwrap();
            assert_eq!((states.len(), &states[0]), (8, &state));
            for other in &states {
                let size: f64 = other.iter().map(|x| x * x).sum();
                for (value, level) in casimirs(other).iter().zip(casimirs(&state)) {
                    assert!((value - level).abs() < 1e-13 * size, "{algebra}: {value} {level}");
                }
            }
            let apart =
                |a: &[f64], b: &[f64]| a.iter().zip(b).any(|(a, b)| (a - b).abs() > 1e-3 * unit);
            assert!(states.windows(2).all(|pair| apart(&pair[0], &pair[1])), "{algebra}");
            assert_eq!(system.orbit_states(&state, 3, 3).unwrap(), states[..3]);
            assert_ne!(system.orbit_states(&state, 3, 4).unwrap(), states[..3]);
        }
        refused.extend(system.orbit_states(&[1.0], 2, 0).err());
    }
    assert_eq!(refused.len(), 3);
    assert!(refused.iter().all(|e| matches!(e, FormulaSystemError::StateLength { found: 1, .. })));
}
