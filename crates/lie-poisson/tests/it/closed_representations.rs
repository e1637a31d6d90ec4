//! The closed forms of representations and of coadjoint operators, compared with the definitions by coordinates.

use lie_poisson::*;
use nalgebra::Vector3;
use proptest::prelude::*;

/// The round-off of sums of a dozen products.
const ROUND_OFF: f64 = 16.0 * f64::EPSILON;

/// A representation of which only `act` is known.
#[derive(Clone)]
struct Derived<R>(R);

impl<R: Representation> Representation for Derived<R> {
    type Algebra = R::Algebra;
    type Space<T: Real> = R::Space<T>;
    fn algebra(&self) -> R::Algebra {
        self.0.algebra()
    }
    fn act<T: Real>(&self, xi: &RepresentedElement<R, T>, v: &R::Space<T>) -> R::Space<T> {
        self.0.act::<T>(xi, v)
    }
}

fn vector<V: Vector<Scalar = f64>>(coordinates: &[f64], shift: usize) -> V {
    V::from_coordinates(|i| coordinates[(i + shift) % coordinates.len()])
}

/// Returns the largest relative difference of the closed forms from those by coordinates.
fn deviation<R: Representation>(representation: &R, coordinates: &[f64]) -> f64 {
    let derived = Derived(representation.clone());
    let xi: RepresentedElement<R> = vector(coordinates, 0);
    let v: R::Space<f64> = vector(coordinates, 5);
    let alpha: Covector<R::Space<f64>> = vector(coordinates, 11);
    let transpose = representation.transpose_act::<f64>(&xi, &alpha)
        - derived.transpose_act::<f64>(&xi, &alpha);
    let diamond = representation.diamond::<f64>(&v, &alpha) - derived.diamond::<f64>(&v, &alpha);
    larger(
        transpose.max_abs() / (xi.max_abs() * alpha.max_abs()),
        diamond.max_abs() / (v.max_abs() * alpha.max_abs()),
    )
}

fn agrees<R: Representation>(representation: R, x: &[f64]) -> Result<(), TestCaseError> {
    let deviation = deviation(&representation, x);
    prop_assert!(deviation <= ROUND_OFF, "{deviation:e}");
    Ok(())
}

/// Compares ad∗ and Ad∗ with the transposes of ad and Ad.
fn coadjoint_agrees<G: LieGroup>(group: &G, x: &[f64]) -> Result<(), TestCaseError> {
    let (xi, mu): (AlgebraElement<G>, GroupMomentum<G>) = (vector(x, 0), vector(x, 9));
    let algebra = group.algebra();
    let closed = algebra.coadjoint::<f64>(&xi, &mu);
    let expected = GroupMomentum::<G>::from_coordinates(|i| {
        mu.pairing(&algebra.bracket::<f64>(&xi, &Vector::basis(i)))
    });
    let error = (closed - expected).max_abs() / (xi.max_abs() * mu.max_abs());
    prop_assert!(error <= ROUND_OFF, "ad*: {error:e}");
    let g = group.exp::<f64>(&xi);
    let closed = group.coadjoint::<f64>(&g, &mu);
    let expected = GroupMomentum::<G>::from_coordinates(|i| {
        mu.pairing(&group.adjoint::<f64>(&g, &Vector::basis(i)))
    });
    let error = (closed - expected).max_abs() / (g.max_abs() * g.max_abs() * mu.max_abs());
    prop_assert!(error <= 4.0 * ROUND_OFF, "Ad*: {error:e}");
    Ok(())
}

proptest! {
    #[test]
    fn transposes_and_diamond_products(x in prop::collection::vec(-2.0..2.0, 23)) {
        agrees(SO2OnR2, &x)?;
        agrees(SO3OnR3, &x)?;
        agrees(SL2OnR2, &x)?;
        agrees(SU2OnC2, &x)?;
        agrees(UnitaryOnComplexSpace::<1>, &x)?;
        agrees(UnitaryOnComplexSpace::<3>, &x)?;
        agrees(SP1OnQuaternions::<3>, &x)?;
        agrees(Adjoint(UnitaryGroup::<2>), &x)?;
        agrees(Diagonal::<_, 2>(SU2OnC2), &x)?;
        agrees(Sum(SL2OnR2, Adjoint(SL2)), &x)?;
        agrees(Inherited { quotient: SL2OnR2, representation: SL2OnR2 }, &x)?;
    }

    #[test]
    fn coadjoint_operators(x in prop::collection::vec(-2.0..2.0, 23)) {
        coadjoint_agrees(&SL2, &x)?;
        coadjoint_agrees(&UnitaryGroup::<2>, &x)?;
        coadjoint_agrees(&UnitaryGroup::<3>, &x)?;
    }

    /// A table of structure constants without symmetry: ad of e₀ maps e₁ to itself, e₂ to e₃ and e₃ to ½e₃.
    #[test]
    fn coadjoint_operators_of_structure_constants(x in prop::collection::vec(-2.0..2.0, 23)) {
        let table = StructureConstants::<4>::new(|i, j, k| match (i, j, k) {
            (0, 1, 1) | (0, 2, 3) => 1.0,
            (1, 0, 1) | (2, 0, 3) => -1.0,
            (0, 3, 3) => 0.5,
            (3, 0, 3) => -0.5,
            _ => 0.0,
        });
        let table = table.unwrap();
        let xi: nalgebra::SVector<f64, 4> = vector(&x, 0);
        let (mu, eta) = (Covector(vector(&x, 4)), vector(&x, 8));
        let difference = table.coadjoint(&xi, &mu).pairing(&eta) - mu.pairing(&table.bracket(&xi, &eta));
        prop_assert!(difference.abs() <= 8.0 * ROUND_OFF, "{difference:e}");
    }
}

/// Rotations with the wrong sign of the transpose.
#[derive(Clone)]
struct WrongTranspose;

impl Representation for WrongTranspose {
    type Algebra = So3;
    type Space<T: Real> = Vector3<T>;
    fn algebra(&self) -> So3 {
        So3
    }
    fn act<T: Real>(&self, xi: &Vector3<T>, v: &Vector3<T>) -> Vector3<T> {
        xi.cross(v)
    }
    fn transpose_act<T: Real>(
        &self,
        xi: &Vector3<T>,
        alpha: &Covector<Vector3<T>>,
    ) -> Covector<Vector3<T>> {
        Covector(xi.cross(&alpha.0))
    }
}

/// A negative control of the comparison.
#[test]
fn a_wrong_sign_is_seen() {
    let x: Vec<f64> = (0..23).map(|i| f64::from(i * i % 7) - 2.5).collect();
    assert!(deviation(&WrongTranspose, &x) > 0.1 && deviation(&SO3OnR3, &x) < ROUND_OFF);
}
