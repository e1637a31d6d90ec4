//! Names for all algebras, and formulas against the same Hamiltonians in Rust.

use lie_poisson::*;
use lie_poisson_formulas::{
    FormulaHamiltonian, NamedAlgebra, Parameters, Problem, StructureEntry, Vocabulary,
    structure_constants,
};

fn names_of<A: NamedAlgebra>(algebra: &A) -> String {
    let coordinates = algebra.coordinates().unwrap();
    assert_eq!(coordinates.dimension(), A::Element::<f64>::DIM);
    coordinates.names().collect::<Vec<_>>().join(" ")
}

#[test]
fn every_algebra_has_as_many_names_as_dimensions() {
    assert_eq!(names_of(&So3), "Pi1 Pi2 Pi3");
    assert_eq!(names_of(&So2), "Pi");
    assert_eq!(names_of(&Su2), "mu1 mu2 mu3");
    assert_eq!(names_of(&Sl2), "alpha beta gamma");
    assert_eq!(names_of(&Se3::default()), "Pi1 Pi2 Pi3 Gamma1 Gamma2 Gamma3");
    assert_eq!(names_of(&Se2::default()), "Pi Gamma1 Gamma2");
    assert_eq!(names_of(&SemidirectAlgebra(SU2OnC2)), "mu1 mu2 mu3 alpha1 alpha2 alpha3 alpha4");
    assert_eq!(names_of(&RealSpace::<2>), "p1 p2");
    assert_eq!(names_of(&RealSpace::<0>), "");
    assert_eq!(names_of(&UnitaryAlgebra::<2>), "mu1 mu2 mu3 mu4");
    let base = SemidirectAlgebra(Inherited { quotient: SO3OnR3, representation: SO3OnR3 });
    assert_eq!(names_of(&base), "Pi1 Pi2 Pi3 P1 P2 P3 Gamma1 Gamma2 Gamma3");
    assert_eq!(names_of(&ProductAlgebra(So3, RealSpace::<1>)), "Pi1 Pi2 Pi3 p1");
    assert_eq!(names_of(&ProductAlgebra(So2, So2)), "Pi_1 Pi_2");
    assert_eq!(names_of(&PowerAlgebra::<_, 2>(So2)), "Pi_1 Pi_2");
    names_of(&PowerAlgebra::<_, 12>(So3));
    assert!(PowerAlgebra::<_, 100>(So3).coordinates().is_err());
}

energy!(HeavyTopEnergy {} on LiePoisson<Se3>: |_top, Covector(Pair(pi, gamma))| {
    (pi.x * pi.x / 2.0 + pi.y * pi.y / 3.0 + pi.z * pi.z / 4.0) * 0.5 + gamma.x * 0.6 + gamma.z * 0.8
});

/// A formula and the same energy in Rust agree, with all derivatives, to rounding.
#[test]
fn the_heavy_top_of_a_formula_is_that_of_rust() {
    let parameters = Parameters::new().vector("I", &[2.0, 3.0, 4.0]).unwrap();
    let parameters = parameters.vector("c", &[0.6, 0.0, 0.8]).unwrap();
    let names = Vocabulary::of(&Se3::default(), &parameters).unwrap();
    let text = "0.5*(Pi1^2/I1 + Pi2^2/I2 + Pi3^2/I3) + c·Gamma";
    let h = FormulaHamiltonian::<Se3>::new(text, &names).unwrap();
    let rust = Automatic(HeavyTopEnergy {});
    for x in crate::support::POINTS {
        let (z, v) = (crate::support::point(*x), crate::support::point([0.3; 6]));
        let value: f64 = rust.value(&z);
        assert!((h.value(&z) - value).abs() <= 4.0 * f64::EPSILON * value.abs());
        let pairs = [
            (h.differential(&z), rust.differential(&z)),
            (h.hessian(&z, &v).unwrap(), rust.hessian(&z, &v).unwrap()),
        ];
        for (formula, rust) in pairs {
            assert!((formula - rust).max_abs() <= 4.0 * f64::EPSILON * rust.max_abs());
        }
    }
}

/// The kinetic energy on the dual of so(3) from a table moves as on so(3).
#[test]
fn structure_constants_have_formulas() {
    let entries = [(0, 1, 2), (1, 2, 0), (2, 0, 1)];
    let entries = entries.map(|(i, j, k)| StructureEntry { i, j, k, value: 1.0 });
    let table = structure_constants::<3>(&entries).unwrap();
    let names = Vocabulary::of(&table, &Parameters::new()).unwrap();
    let h = FormulaHamiltonian::<StructureConstants<3>>::new("mu1^2/2 + mu2*mu3", &names).unwrap();
    let mu = Covector(nalgebra::Vector3::new(1.0, 2.0, 3.0));
    let rate = LiePoisson::minus(table).hamiltonian_vector(&mu, &h.differential(&mu));
    let so3 = LiePoisson::minus(So3);
    assert_eq!(rate, so3.hamiltonian_vector(&mu, &nalgebra::Vector3::new(1.0, 3.0, 2.0)));
}

#[test]
fn names_of_another_space_are_refused() {
    let names = Vocabulary::of(&Se3::default(), &Parameters::new()).unwrap();
    let error = FormulaHamiltonian::<So3>::new("Pi1", &names).unwrap_err();
    assert_eq!(*error.problem(), Problem::WrongDimension { formula: 6, space: 3 });
}

/// The names of coordinates and groups of them, by which formulas find their places.
#[test]
fn places_of_names() {
    let base = SemidirectAlgebra(Inherited { quotient: SO3OnR3, representation: SO3OnR3 });
    let coordinates = base.coordinates().unwrap();
    for (i, name) in coordinates.names().enumerate() {
        assert_eq!(coordinates.places(&name), Some(i..i + 1), "{name}");
    }
    let groups: Vec<_> = coordinates.groups().collect();
    assert_eq!(groups, [("Pi", 0..3), ("P", 3..6), ("Gamma", 6..9)]);
    for (name, places) in groups {
        assert_eq!(coordinates.places(name), Some(places));
    }
    assert_eq!(coordinates.places("Gamma4"), None);
}
