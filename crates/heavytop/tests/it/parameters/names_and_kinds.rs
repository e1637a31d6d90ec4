//! Formulations, schemes, coordinates and invariants by name, the kinds of tops, and what is refused.

use collective_integrators::{ExactFlows, Start};
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
            "implicit-midpoint" | "spherical-midpoint" | "explicit-midpoint" | "stormer-verlet"
            | "strang" => 2,
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
        // Of all 19, one is for spins alone, three are partitioned, two explicit, and six compositions.
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
        assert!(listed(&goryachev_chaplygin).is_empty());
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

/// The rate of an invariant along the motion, from its values a little before and after, relative to those of its terms.
fn rate(top: &HeavyTop, invariant: Invariant, mu: &Se3Dual) -> f64 {
    let near = |step: f64| {
        let end = top.gauss(4).unwrap().after(mu, step, 1).unwrap().momentum;
        invariant.value(top, &end)
    };
    (near(1e-2) - near(1e-3)) / 9e-3
}

/// G is listed where Π·Γ = 0, and is conserved there alone.
#[test]
fn the_invariant_of_goryachev_and_chaplygin_is_that_of_one_level() {
    for axis in 0..3 {
        let top = about(axis, 1.0, 4.0, false);
        let [x, y] = [(axis + 1) % 3, (axis + 2) % 3];
        for (height, is_conserved) in [(0.0, true), (0.3, false)] {
            let (mut pi, mut gamma) = (Vector3::zeros(), Vector3::zeros());
            (pi[axis], pi[x], pi[y]) = (height, 0.8, 1.1);
            gamma[axis] = 1.0;
            let mu = Se3Dual::new(pi, gamma);
            let last = top.invariants_from(&mu).pop().unwrap();
            assert_eq!(last == Invariant::GoryachevChaplygin, is_conserved, "{axis} {height}");
            let rate = rate(&top, Invariant::GoryachevChaplygin, &mu).abs();
            assert_eq!(rate < 1e-10, is_conserved, "{axis} {height}: {rate:e}");
        }
        // The level has no unit.
        for scale in [1e-200, 1e200] {
            let mu = Se3Dual::new(Vector3::ith(x, scale), Vector3::ith(axis, 1.0));
            assert_eq!(top.invariants_from(&mu).len(), 4);
            let off = Se3Dual::new(Vector3::repeat(scale), Vector3::ith(axis, 1.0));
            assert_eq!(top.invariants_from(&off).len(), 3);
        }
    }
}

/// A sphere conserves Π·c, wherever its centre of mass is.
#[test]
fn a_sphere_conserves_the_momentum_about_its_centre_of_mass() {
    let sphere = |c: [f64; 3]| {
        let center_of_mass = Vector3::from(c);
        let inertia = Vector3::repeat(1.4);
        HeavyTop::new(&Body { inertia, mass: 1.0, gravity: 2.0, length: 0.5, center_of_mass })
    };
    let mu = Se3Dual::new(Vector3::new(0.5, 1.2, -0.8), Vector3::new(0.6, 0.0, 0.8));
    let aside = sphere([0.48, 0.6, 0.64]).unwrap();
    assert_eq!(aside.invariants().last(), Some(&Invariant::AxialMomentum));
    assert_eq!(aside.axial_component(), None);
    let expected = 0.5 * 0.48 + 1.2 * 0.6 - 0.8 * 0.64;
    assert!((Invariant::AxialMomentum.value(&aside, &mu) - expected).abs() < 1e-15);
    assert!(rate(&aside, Invariant::AxialMomentum, &mu).abs() < 1e-12);
    // Where the centre of mass is on an axis, Π·c is a component of Π, up to its sign.
    let along = sphere([0.0, -1.0, 0.0]).unwrap();
    assert_eq!(along.axial_component(), Some(1));
    assert_eq!(Invariant::AxialMomentum.value(&along, &mu), 1.2);
    // The control: not quite a sphere.
    let inertia = Vector3::new(1.4, 1.4, 1.41);
    let center_of_mass = Vector3::new(0.48, 0.6, 0.64);
    let other = Body { inertia, mass: 1.0, gravity: 2.0, length: 0.5, center_of_mass };
    assert_eq!(HeavyTop::new(&other).unwrap().invariants().len(), 3);
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
