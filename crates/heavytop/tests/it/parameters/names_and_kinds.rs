//! Formulations, schemes, coordinates and invariants by name, the kinds of tops, and what is refused.

use collective_integrators::ExactFlows;
use heavytop::methods::{Formulation, Method, MethodError, SchemeName};
use heavytop::{
    Body, Coordinate, HeavyTop, Invariant, RigidBody, RotorSplitting, SymmetricTopSplitting,
    TopError, require_unit,
};
use lie_poisson::{Covector, Hamiltonian, Se3Dual};
use nalgebra::Vector3;

#[test]
fn names_lead_to_items_and_back() {
    for &(name, formulation) in Formulation::NAMES {
        assert_eq!(name.parse(), Ok(formulation));
        assert_eq!(formulation.to_string(), name);
    }
    for &(name, scheme) in SchemeName::NAMES {
        assert_eq!(name.parse(), Ok(scheme));
    }
    let unknown = "gauss-5".parse::<SchemeName>().unwrap_err();
    assert_eq!((unknown.kind, unknown.name.as_str()), ("scheme", "gauss-5"));
    assert_eq!(unknown.known.len(), SchemeName::NAMES.len());
    let unknown = "Direct".parse::<Formulation>().unwrap_err();
    assert!(unknown.to_string().ends_with("there are collective, reduced, direct, splitting"));
    let names = Coordinate::ALL.map(|coordinate| coordinate.to_string());
    assert_eq!(names, ["Pi1", "Pi2", "Pi3", "Gamma1", "Gamma2", "Gamma3"]);
}

/// Most names end with the order.
#[test]
fn schemes_have_the_orders_of_their_names() {
    for &(name, scheme) in SchemeName::NAMES {
        let order = match name {
            "symplectic-euler" => 1,
            "implicit-midpoint" | "explicit-midpoint" | "stormer-verlet" | "strang" => 2,
            "rk4" => 4,
            _ => name.rsplit('-').next().unwrap().parse().unwrap(),
        };
        assert_eq!(scheme.order(), order, "{name}");
    }
}

#[test]
fn methods_are_pairs_that_make_sense_with_a_tolerance() {
    for &(_, formulation) in Formulation::NAMES {
        for &(_, scheme) in SchemeName::NAMES {
            let refused = MethodError::NoSuchPair { formulation, scheme };
            match Method::new(formulation, scheme, 0.0) {
                Ok(method) => assert_eq!(method.scheme(), scheme),
                Err(error) => assert_eq!(error, refused),
            }
        }
        let count = formulation.schemes().count();
        let poisson =
            formulation.schemes().filter(|scheme| formulation.is_poisson(*scheme)).count();
        // Of all 18, three are partitioned, two explicit, and six compositions.
        let expected = match formulation {
            Formulation::Collective => (18, 13),
            Formulation::Reduced => (13, 13),
            Formulation::Direct => (15, 0),
            Formulation::Splitting => (6, 6),
        };
        assert_eq!((count, poisson), expected, "{formulation}");
    }
    for value in [-1e-9, f64::INFINITY] {
        let refused = Method::new(Formulation::Reduced, SchemeName::ImplicitMidpoint, value);
        assert_eq!(refused, Err(MethodError::Tolerance { value }));
    }
}

/// A top about each of the three axes, by its moment about the axis and the two others, and the centre of mass.
fn about(axis: usize, moment: f64, other: f64, along: bool) -> HeavyTop {
    let mut inertia = Vector3::repeat(other);
    inertia[axis] = moment;
    let center = Vector3::ith(if along { axis } else { (axis + 1) % 3 }, 1.0);
    let body = Body { inertia, mass: 1.0, gravity: 1.0, length: 1.0, center_of_mass: center };
    HeavyTop::new(&body).unwrap()
}

#[test]
fn integrable_tops_have_one_invariant_more() {
    let listed = |top: &HeavyTop| -> Vec<&str> {
        assert_eq!(top.invariants()[..3].iter().map(|i| i.symbol()).collect::<String>(), "hf1f2");
        top.invariants()[3..].iter().map(|invariant| invariant.symbol()).collect()
    };
    for axis in 0..3 {
        let lagrange = about(axis, 1.0, 1.5, true);
        let kovalevskaya = about(axis, 1.0, 2.0, false);
        let goryachev_chaplygin = about(axis, 1.0, 4.0, false);
        assert_eq!(listed(&lagrange), ["f3"]);
        assert_eq!(listed(&kovalevskaya), ["K"]);
        assert_eq!(listed(&goryachev_chaplygin), ["G"]);
        // The questions are about the third axis alone.
        assert_eq!(lagrange.is_lagrange(), axis == 2);
        assert_eq!(kovalevskaya.is_kovalevskaya(), axis == 2);
        assert_eq!(goryachev_chaplygin.is_goryachev_chaplygin(), axis == 2);
        // The control: the moments of one with the centre of mass of the other.
        assert!(listed(&about(axis, 1.0, 2.5, false)).is_empty());
    }
    let free = HeavyTop::free_rigid_body(Vector3::new(1.0, 1.5, 2.0)).unwrap();
    assert_eq!(listed(&free), ["C"]);
    let mu = Se3Dual::new(Vector3::new(1.0, 2.0, -2.0), Vector3::z());
    assert_eq!(Invariant::MomentumSquared.value(&free, &mu), 9.0);
}

/// The unit of an invariant is that of its degree in Π, where those with gravity count m g l I as a square.
#[test]
fn invariants_have_the_units_of_their_degrees() {
    use Invariant::*;
    let units = [Energy, VerticalSquared, VerticalMomentum, AxialMomentum].map(Invariant::unit);
    assert_eq!(units, ["J", "", "kg m²/s", "kg m²/s"]);
    let units = [MomentumSquared, GoryachevChaplygin, Kovalevskaya].map(Invariant::unit);
    assert_eq!(units, ["(kg m²/s)²", "(kg m²/s)³", "(kg m²/s)⁴"]);
    assert_eq!(Kovalevskaya.to_string(), "K");
}

#[test]
fn the_energy_of_a_free_body_is_quadratic() {
    let body = RigidBody::new(Vector3::new(1.0, 2.0, 2.5)).unwrap();
    let pi = Covector(Vector3::new(2.0, -4.0, 5.0));
    assert_eq!(body.value(&pi), 0.5 * (4.0 + 8.0 + 10.0));
    assert_eq!(body.hessian(&pi, &pi), Some(body.differential(&pi)));
    let other = Covector(Vector3::new(1.0, 2.0, -2.5));
    assert_eq!(body.hessian(&other, &pi), Some(Vector3::new(2.0, -2.0, 2.0)));
}

/// The flows of a splitting count from 0; those beyond the last one do nothing.
#[test]
fn flows_beyond_the_last_one_rest() {
    let mu = Se3Dual::new(Vector3::new(0.3, -0.5, 0.8), Vector3::new(0.6, 0.0, 0.8));
    let top = about(2, 1.0, 1.5, true);
    let (rotors, symmetric) = (RotorSplitting(top), SymmetricTopSplitting::new(top).unwrap());
    for index in 0..6 {
        assert_eq!(rotors.flow(index, 0.1, &mu) == mu, index >= 4, "{index}");
        assert_eq!(symmetric.flow(index, 0.1, &mu) == mu, index >= 2, "{index}");
        let body = RotorSplitting(RigidBody::new(top.inertia()).unwrap());
        let pi = Covector(mu.0.0);
        assert_eq!(body.flow(index, 0.1, &pi) == pi, index >= 3, "{index}");
    }
}

#[test]
fn moments_without_a_body_and_directions_without_unit_length_are_refused() {
    // One moment is larger than the other two together.
    let refused = HeavyTop::free_rigid_body(Vector3::new(1.0, 2.5, 1.0));
    let expected = TopError::Triangle { largest: 2.5, first: 1.0, second: 1.0 };
    assert_eq!(refused, Err(expected));
    assert!(HeavyTop::free_rigid_body(Vector3::new(1.0, 2.0, 1.0)).is_ok());
    let name = "center_of_mass";
    let refused = require_unit(name, &Vector3::new(0.0, 2.0, 0.0)).unwrap_err();
    assert!(matches!(refused, TopError::NotUnit { name: n, length: 2.0, .. } if n == name));
    assert_eq!(require_unit(name, &Vector3::new(0.6, 0.0, -0.8)), Ok(()));
}
