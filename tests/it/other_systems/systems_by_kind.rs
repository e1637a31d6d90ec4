//! Systems of the catalogue, against the same systems of the gallery.

use collective_integrators::{HamiltonianField, VectorField};
use lie_poisson::{Hamiltonian, LiePoisson, PoissonSpace, PowerAlgebra, Se3, So3, State, Vector};
use lie_poisson_formula_systems::{FormulaSystem, FormulaSystemError, ParameterShape, SystemKind};
use lie_poisson_formulas::Parameters;
use lie_poisson_systems::isospectral_flows::IsospectralField;
use lie_poisson_systems::{
    GeneralisedRigidBody, Gyrostat, HeisenbergChain, KidaVortex, Kirchhoff, MovableBaseAlgebra,
    MovableBaseTop, PointVortices, Satellite, SatelliteAlgebra, So21,
};
use nalgebra::{Matrix3, Matrix6, Rotation3, Vector3};
use proptest::prelude::*;

/// A rounding error of some dozen operations, relative to the size of the rates.
const ROUND_OFF: f64 = 1e-13;

fn parameters(given: &[(&str, &[f64])]) -> Parameters {
    given.iter().fold(Parameters::new(), |all, (name, values)| match values {
        [value] if !matches!(*name, "strengths" | "moments") => all.number(name, *value).unwrap(),
        values => all.vector(name, values).unwrap(),
    })
}

fn system(kind: &str, given: &[(&str, &[f64])]) -> FormulaSystem {
    SystemKind::named(kind).unwrap().system(&parameters(given)).unwrap()
}

/// Checks that a system has a rate at a state, and not another one: `control` is that of other parameters.
fn has_rate(system: &FormulaSystem, state: &[f64], expected: &[f64], control: &[f64]) {
    let rate = system.rate(state).unwrap();
    let distance =
        |other: &[f64]| rate.iter().zip(other).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
    let size = 1.0 + expected.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
    assert!(distance(expected) <= ROUND_OFF * size, "{rate:?} {expected:?}");
    assert!(distance(control) > 1e-6, "{rate:?} {control:?}");
}

/// Returns the rate of a Hamiltonian on a space.
fn rate_of<P, H>(space: P, hamiltonian: H, state: &[f64]) -> Vec<f64>
where
    P: PoissonSpace,
    H: Hamiltonian<P, f64>,
    HamiltonianField<P, H>: VectorField<Point = lie_poisson::Point<P, f64>>,
    lie_poisson::Point<P, f64>: Vector<Scalar = f64>,
{
    let field = HamiltonianField { space, hamiltonian };
    let rate = field.at(&Vector::from_coordinates(|i| state[i]));
    (0..state.len()).map(|i| rate.coordinate(i)).collect()
}

fn near(range: std::ops::Range<f64>) -> impl Strategy<Value = [f64; 9]> {
    prop::array::uniform9(range)
}

proptest! {
    /// Free rotors keep their angular momenta, so that the body moves as a gyrostat.
    #[test]
    fn a_body_with_rotors_moves_as_a_gyrostat(
        pi in prop::array::uniform3(-2.0..2.0_f64),
        l in prop::array::uniform2(0.2..2.0_f64),
        spin in prop::array::uniform2(0.1..2.0_f64),
    ) {
        prop_assume!(pi[2].abs() > 1e-2);
        let inertia = [2.0, 3.0, 4.0];
        let body = system("body-with-rotors", &[("I", &inertia), ("J", &spin)]);
        let of = |l: [f64; 2]| {
            let rotor = Vector3::new(l[0], l[1], 0.0);
            let gyrostat = Gyrostat::new(inertia.into(), 0.0, Vector3::z(), rotor).unwrap();
            let state = [pi[0], pi[1], pi[2], 0.0, 0.0, 1.0];
            let rate = rate_of(LiePoisson::minus(Se3::default()), gyrostat, &state);
            [&rate[..3], &[0.0; 2]].concat()
        };
        has_rate(&body, &[pi[0], pi[1], pi[2], l[0], l[1]], &of(l), &of([0.0; 2]));
    }

    #[test]
    fn bodies_move_as_those_of_the_gallery(z in near(0.2..2.0), r in prop::array::uniform3(0.2..1.0_f64)) {
        let (inertia, rotor) = ([2.0, 2.5, 3.0], [0.3, -0.5, 0.8]);
        let space = || LiePoisson::minus(Se3::default());
        let given: [(&str, &[f64]); 4] =
            [("inertia", &inertia), ("weight", &[1.7]), ("center_of_mass", &r), ("rotor", &rotor)];
        let gyrostat = |weight, rotor: [f64; 3]| {
            rate_of(space(), Gyrostat::new(inertia.into(), weight, r.into(), rotor.into()).unwrap(), &z[..6])
        };
        has_rate(&system("gyrostat", &given), &z[..6], &gyrostat(1.7, rotor), &gyrostat(1.7, [0.0; 3]));

        let masses = [3.0, 1.5, 2.0];
        let inverse = |m: [f64; 3]| Matrix3::from_diagonal(&Vector3::from(m).map(f64::recip));
        let kirchhoff = |m| {
            rate_of(space(), Kirchhoff::new(inverse(inertia), Matrix3::zeros(), inverse(m)).unwrap(), &z[..6])
        };
        let fluid = system("body-in-fluid", &[("inertia", &inertia), ("masses", &masses)]);
        has_rate(&fluid, &z[..6], &kirchhoff(masses), &kirchhoff([3.0, 3.0, 2.0]));

        // A propeller: I, M and D in axes that are no planes of symmetry.
        let propeller = |scale: f64| {
            let tilted = |diagonal: [f64; 3]| Matrix3::from_diagonal(&diagonal.into()) + Matrix3::repeat(0.2);
            (tilted(inertia), tilted(masses), Matrix3::from_row_slice(&r.map(|x| [scale * x, 0.1, -0.2]).concat()))
        };
        let compiled = |scale| {
            let (i, m, d) = propeller(scale);
            let mut whole = Matrix6::zeros();
            whole.fixed_view_mut::<3, 3>(0, 0).copy_from(&i);
            whole.fixed_view_mut::<3, 3>(0, 3).copy_from(&d);
            whole.fixed_view_mut::<3, 3>(3, 0).copy_from(&d.transpose());
            whole.fixed_view_mut::<3, 3>(3, 3).copy_from(&m);
            let inverse = whole.try_inverse().unwrap();
            let block = |row, column| inverse.fixed_view::<3, 3>(row, column).into_owned();
            let even = |matrix: Matrix3<f64>| (matrix + matrix.transpose()) * 0.5;
            rate_of(space(), Kirchhoff::new(even(block(0, 0)), block(0, 3), even(block(3, 3))).unwrap(), &z[..6])
        };
        let (i, m, d) = propeller(0.5);
        let rows = |matrix: Matrix3<f64>| matrix.transpose().as_slice().to_vec();
        let given = [("inertia", &*rows(i)), ("masses", &*rows(m)), ("coupling", &*rows(d))];
        has_rate(&system("body-in-fluid", &given), &z[..6], &compiled(0.5), &compiled(0.2));

        let top = |base| {
            let top = MovableBaseTop::new(inertia.into(), [0.8, base], 9.8, r.into()).unwrap();
            rate_of(LiePoisson::minus(MovableBaseAlgebra::default()), top, &z)
        };
        let given: [(&str, &[f64]); 5] = [
            ("inertia", &inertia), ("mass", &[0.8]), ("base_mass", &[1.3]), ("gravity", &[9.8]), ("center_of_mass", &r),
        ];
        has_rate(&system("top-on-base", &given), &z, &top(1.3), &top(2.0));

        let satellite = |rate| {
            let satellite = Satellite::new(inertia.into(), rate).unwrap();
            rate_of(LiePoisson::minus(SatelliteAlgebra::default()), satellite, &z)
        };
        let given: [(&str, &[f64]); 2] = [("I", &inertia), ("n", &[0.7])];
        has_rate(&system("satellite", &given), &z, &satellite(0.7), &satellite(0.8));
    }

    /// A start by angles is that of the rotation R₃(yaw) R₂(pitch) R₁(roll) from the axes of the orbit to those of the body.
    #[test]
    fn a_satellite_starts_from_angles(angles in prop::array::uniform3(-3.0..3.0_f64), w in prop::array::uniform3(-1.0..1.0_f64)) {
        let (inertia, rate, [roll, pitch, yaw]) = ([2.0, 2.5, 3.0], 0.7, angles);
        let given = [("roll", &[roll][..]), ("pitch", &[pitch]), ("yaw", &[yaw]), ("relative", &w)];
        let kind = SystemKind::named("satellite").unwrap();
        let coordinates = |given: &[(&str, &[f64])]| -> Vec<f64> {
            kind.coordinates(&parameters(&[("I", &inertia), ("n", &[rate])]), &parameters(given)).unwrap().unwrap()
        };
        let turn = Rotation3::from_axis_angle(&Vector3::z_axis(), yaw)
            * Rotation3::from_axis_angle(&Vector3::y_axis(), pitch)
            * Rotation3::from_axis_angle(&Vector3::x_axis(), roll);
        let seen = [Vector3::z(), Vector3::y()].map(|axis| turn.inverse() * axis);
        let satellite = Satellite::new(inertia.into(), rate).unwrap();
        let expected = satellite.momentum(seen, &w.into());
        for (i, x) in coordinates(&given).into_iter().enumerate() {
            prop_assert!((x - expected.coordinate(i)).abs() < 1e-14);
        }
        // What is left out is 0.
        let at_rest = satellite.momentum([Vector3::z(), Vector3::y()], &Vector3::<f64>::zeros());
        for (i, x) in coordinates(&[]).into_iter().enumerate() {
            prop_assert!((x - at_rest.coordinate(i)).abs() < 1e-15);
        }
    }

    #[test]
    fn an_elliptical_vortex_moves_as_that_of_the_gallery(a in 0.5..2.0_f64, b in 0.5..2.0_f64, angle in 0.1..3.0_f64) {
        prop_assume!((a - b).abs() > 0.05);
        let start = KidaVortex::momentum(a, b, angle).unwrap().0;
        let kind = SystemKind::named("elliptical-vortex").unwrap();
        let flow: [(&str, &[f64]); 3] = [("strength", &[1.2]), ("strain", &[0.3]), ("rotation", &[0.1])];
        let given = parameters(&[("a", &[a]), ("b", &[b]), ("angle", &[angle])]);
        let own = kind.coordinates(&parameters(&flow), &given).unwrap().unwrap();
        for (x, y) in own.iter().zip(&start) {
            prop_assert!((x - y).abs() <= 1e-15 * (a * a + b * b));
        }
        let kida = |strain| {
            rate_of(LiePoisson::plus(So21), KidaVortex::new(1.2, strain, 0.1).unwrap(), start.as_slice())
        };
        has_rate(&system("elliptical-vortex", &flow), start.as_slice(), &kida(0.3), &kida(0.0));
    }

    #[test]
    fn vortices_move_as_those_of_the_gallery(x in prop::collection::vec(-1.0..1.0_f64, 12)) {
        let strengths = [1.0, -0.7, 1.5, 0.4];
        let points: Vec<Vector3<f64>> = x.chunks(3).map(|x| Vector3::new(x[0], x[1], x[2])).collect();
        prop_assume!(points.iter().all(|x| x.norm() > 0.1));
        let points: Vec<_> = points.iter().map(|x| x.normalize()).collect();
        let far = |a: &Vector3<f64>, b: &Vector3<f64>| (a - b).norm() > 0.3;
        prop_assume!((0..4).all(|i| (0..i).all(|j| far(&points[i], &points[j]))));
        let kind = SystemKind::named("vortices").unwrap();
        let given = parameters(&[("strengths", &strengths)]);
        let flat: Vec<f64> = points.iter().flatten().copied().collect();
        let positions = Parameters::new().vector("positions", &flat).unwrap();
        let start = kind.coordinates(&given, &positions).unwrap().unwrap();
        let rate = |k| {
            let space = LiePoisson::minus(PowerAlgebra::<_, 4>(So3));
            rate_of(space, PointVortices::new(k).unwrap(), &start)
        };
        has_rate(&system("vortices", &[("strengths", &strengths)]), &start, &rate(strengths), &rate([1.0, -0.7, 1.5, 0.5]));
    }

    #[test]
    fn a_chain_moves_as_that_of_the_gallery(s in prop::collection::vec(0.1..1.0_f64, 24)) {
        let field = [0.3, -0.2, 0.5];
        let chain = system("spin-chain", &[("spins", &[8.0]), ("exchange", &[0.7]), ("field", &field)]);
        let rate = |j| {
            let space = LiePoisson::plus(PowerAlgebra::<_, 8>(So3));
            rate_of(space, HeisenbergChain::<8>::new(j, field.into()).unwrap(), &s)
        };
        has_rate(&chain, &s, &rate(0.7), &rate(0.8));
    }

    #[test]
    #[ignore = "long"]
    fn a_body_in_four_and_five_dimensions_moves_as_that_of_the_gallery(l in prop::collection::vec(0.1..1.0_f64, 10)) {
        for n in [3, 4, 5] {
            let moments = [1.0, 1.5, 2.2, 3.1, 0.9];
            let planes: Vec<(usize, usize)> = match n {
                3 => vec![(1, 2), (2, 0), (0, 1)],
                _ => (0..n).flat_map(|i| (i + 1..n).map(move |j| (i, j))).collect(),
            };
            let place = |i: usize, j: usize| planes.iter().position(|plane| *plane == (i, j));
            let rate = |moments: &[f64]| {
                let body = GeneralisedRigidBody::new(moments.to_vec()).unwrap();
                // M has the entry L_ij at (j, i).
                let m = body.momentum(|j, i| match (place(i, j), place(j, i)) {
                    (Some(at), _) => l[at],
                    (_, Some(at)) => -l[at],
                    _ => 0.0,
                });
                let rate = body.rate(&m);
                planes.iter().map(|&(i, j)| rate.matrix().real()[j + n * i]).collect::<Vec<f64>>()
            };
            let body = system("rigid-body", &[("moments", &moments[..n])]);
            let other: Vec<f64> = moments[..n].iter().enumerate().map(|(i, j)| j + 0.1 * i as f64).collect();
            has_rate(&body, &l[..planes.len()], &rate(&moments[..n]), &rate(&other));
        }
    }
}

/// Every system of the catalogue has a name of its own and all of its Casimirs, and says what its parameters are.
#[test]
fn systems_of_the_catalogue_are_what_they_say() {
    for kind in SystemKind::ALL {
        let given = kind.parameters.iter().try_fold(Parameters::new(), |all, parameter| {
            match parameter.shape {
                _ if parameter.default.is_some() => Ok(all),
                ParameterShape::Vector(count) => all.vector(parameter.name, &vec![1.5; count]),
                ParameterShape::List => all.vector(parameter.name, &[1.5; 3]),
                // The number of spins is a whole one, and a small mass leaves the moments positive.
                ParameterShape::Number | ParameterShape::NumberOrList => {
                    all.number(parameter.name, if parameter.name == "mass" { 0.1 } else { 2.0 })
                }
            }
        });
        let given = given.unwrap();
        let system = kind.system(&given).unwrap_or_else(|error| panic!("{}: {error}", kind.name));
        assert_eq!(SystemKind::named(kind.name).unwrap().name, kind.name);
        assert_eq!(system.missing_casimirs(), Some(0), "{}", kind.name);
        assert_eq!(kind.system_near(&system, &given).unwrap(), system);
        let error = kind.system(&Parameters::new()).unwrap_err().to_string();
        assert!(kind.parameters.iter().all(|own| error.contains(own.about)), "{error}");
        let extra = given.number("extra", 1.0).unwrap();
        assert!(kind.system(&extra).is_err());
    }
}

#[test]
fn values_that_make_no_system_are_refused() {
    let message = |kind: &str, given: &[(&str, &[f64])]| {
        SystemKind::named(kind).unwrap().system(&parameters(given)).unwrap_err().to_string()
    };
    let gyrostat = |inertia: &[f64], weight: &[f64]| {
        message(
            "gyrostat",
            &[
                ("inertia", inertia),
                ("weight", weight),
                ("center_of_mass", &[0.0; 3]),
                ("rotor", &[0.0; 3]),
            ],
        )
    };
    assert_eq!(gyrostat(&[1.0, -2.0, 2.0], &[1.0]), "gyrostat: inertia must be positive, got -2");
    assert!(gyrostat(&[1.0, 1.0, 2.1], &[1.0]).contains("none above the sum of the others"));
    assert_eq!(gyrostat(&[1.0; 3], &[-1.0]), "gyrostat: weight must be 0 or positive, got -1");
    let top = [
        ("inertia", &[0.1; 3][..]),
        ("mass", &[1.0]),
        ("base_mass", &[2.0]),
        ("gravity", &[1.0]),
        ("center_of_mass", &[0.0, 0.0, 1.0]),
    ];
    assert!(message("top-on-base", &top).starts_with("top-on-base: inertia must be larger than"));
    let fluid = |inertia: &[f64], coupling: &[f64]| {
        let given = [("inertia", inertia), ("masses", &[1.0; 3][..]), ("coupling", coupling)];
        message("body-in-fluid", &given[..if coupling.is_empty() { 2 } else { 3 }])
    };
    assert!(fluid(&[1.0; 4], &[]).contains("inertia must be 3 or 9 numbers, got 4"));
    assert!(fluid(&[1.0; 3], &[1.0; 3]).contains("coupling must be 9 numbers, got 3"));
    let leaning = [1.0, 0.5, 0.0, 0.4, 1.0, 0.0, 0.0, 0.0, 1.0];
    assert!(fluid(&leaning, &[]).contains("a symmetric matrix; it differs by"));
    // |D| > √(I M): some motion would have a negative energy.
    let large = [1.1, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    assert!(fluid(&[1.0; 3], &large).contains("the energy of every motion is positive"));
    assert!(message("vortices", &[("strengths", &[1.0, 0.0])]).contains("other than 0"));
    assert!(message("vortices", &[("strengths", &[1.0; 90])]).contains("1 to 48 numbers, got 90"));
    assert!(
        message("spin-chain", &[("spins", &[2.5]), ("exchange", &[1.0])])
            .contains("a whole number from 2 to 85")
    );
    assert!(
        message("spin-chain", &[("spins", &[3.0]), ("exchange", &[1.0]), ("periodic", &[2.0])])
            .contains("0 or 1")
    );
    assert!(message("rigid-body", &[("moments", &[1.0, 2.0])]).contains("at least 3 numbers"));
    let vortices = SystemKind::named("vortices").unwrap();
    let start = |positions: &[f64]| {
        let positions = Parameters::new().vector("positions", positions).unwrap();
        vortices.coordinates(&parameters(&[("strengths", &[1.0, 2.0])]), &positions).unwrap()
    };
    assert!(matches!(
        start(&[1.0; 5]),
        Err(FormulaSystemError::KindValue { name: "positions", .. })
    ));
    assert!(
        start(&[1.0, 0.0, 0.0, 0.0, 0.9, 0.0]).unwrap_err().to_string().contains("number 2 is 0.9")
    );
    assert_eq!(start(&[1.0, 0.0, 0.0, 0.0, 1.0, 0.0]).unwrap(), [1.0, 0.0, 0.0, 0.0, 2.0, 0.0]);
    // Coordinates are no positions.
    let coordinates = Parameters::new().vector("m", &[1.0, 0.0, 0.0]).unwrap();
    assert!(vortices.coordinates(&parameters(&[("strengths", &[1.0])]), &coordinates).is_none());
}
