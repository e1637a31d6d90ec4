//! The polynomial identities in rational arithmetic: equalities, not small residuals.

use heavytop::{SPINOR_MOTIONS, SpinorAlgebra, SpinorRealisation, Varpi};
use lie_poisson::*;
use momentum_map::*;
use nalgebra::{Vector2, Vector3};
use num_complex::Complex;
use workspace_tests::{Rational, rational_samples};

/// Returns whether {M_i, M_j} = Λ_ij ∘ M for every pair of coordinates, at rational points.
fn is_poisson<M: PoissonMap>(map: &M) -> bool {
    let dimension = TargetPoint::<M, Rational>::DIM;
    rational_samples::<SourcePoint<M, Rational>>(3).iter().all(|z| {
        let tensor = map.target().poisson_tensor::<Rational>(&map.apply::<Rational>(z));
        let slopes: Vec<_> =
            (0..dimension).map(|i| map.pull_back::<Rational>(&Vector::basis(i), z)).collect();
        (0..dimension * dimension).all(|n| {
            let (i, j) = (n / dimension, n % dimension);
            map.source().bracket::<Rational>(z, &slopes[i], &slopes[j]) == tensor[(i, j)]
        })
    })
}

#[test]
fn the_paper_s_maps_are_poisson() {
    assert!(is_poisson(&SpinorRealisation));
    assert!(is_poisson(&Varpi));
    assert!(is_poisson(&MomentumMap(SPINOR_MOTIONS)));
    assert!(is_poisson(&ComposedMap { outer: Varpi, inner: MomentumMap(SPINOR_MOTIONS) }));
}

#[test]
fn the_other_realisations_are_poisson() {
    assert!(is_poisson(&HOPF));
    assert!(is_poisson(&PARTICLE));
    assert!(is_poisson(&TWO_FIELDS));
    assert!(is_poisson(&unitary_realisation::<3>()));
    assert!(is_poisson(&QuadraticMomentumMap::new(Sum(SL2OnR2, Reversed(SL2OnR2)), Side::Left)));
    assert!(is_poisson(&PowerMap::<_, 2>(HOPF)));
}

/// The map M as the paper prints it in real coordinates, with two signs wrong in Γ.
#[derive(Clone)]
struct Misprint;

impl PoissonMap for Misprint {
    type Source = CotangentBundle<ComplexSpace<2>>;
    type Target = LiePoisson<Se3>;
    fn source(&self) -> Self::Source {
        SpinorRealisation.source()
    }
    fn target(&self) -> Self::Target {
        SpinorRealisation.target()
    }
    fn apply<T: Real>(&self, z: &Cotangent<Vector2<Complex<T>>>) -> Se3Dual<T> {
        let [p1, p2, p3, p4] = [0, 1, 2, 3].map(|i| z.p.coordinate(i));
        let first = (p1 * p3 - p2 * p4) * 2.0;
        let second = (p1 * p4 + p2 * p3) * -2.0;
        let third = p1 * p1 + p2 * p2 - p3 * p3 - p4 * p4;
        Se3Dual::new(SpinorRealisation.apply(z).0.0, Vector3::new(first, second, third))
    }
}

#[test]
fn the_misprint_is_not_poisson() {
    assert!(!is_poisson(&Misprint));
}

#[test]
fn closed_form_and_derived_m_are_one_polynomial() {
    let derived = ComposedMap { outer: Varpi, inner: MomentumMap(SPINOR_MOTIONS) };
    for z in rational_samples::<Cotangent<Vector2<Complex<Rational>>>>(4) {
        assert_eq!(SpinorRealisation.apply(&z), derived.apply(&z));
        for i in 0..6 {
            let dh = Vector::basis(i);
            assert_eq!(SpinorRealisation.generator(&dh, &z), derived.generator(&dh, &z));
        }
    }
}

/// The Cayley map makes unitary matrices with rational entries.
#[test]
fn the_momentum_map_is_equivariant() {
    let (group, lifted) = (SPINOR_MOTIONS.group(), CotangentLift(SPINOR_MOTIONS));
    let map = MomentumMap(SPINOR_MOTIONS);
    let rotations = rational_samples::<Vector3<Rational>>(3);
    let translations = rational_samples::<Vector2<Complex<Rational>>>(3);
    for (xi, rho) in rotations.iter().zip(translations) {
        let g = Pair(SU2.cayley(xi), rho);
        assert_eq!(group.compose(&g, &group.inverse(&g)), group.identity());
        for z in rational_samples(3) {
            let moved = map.apply::<Rational>(&lifted.act::<Rational>(&g, &z));
            assert_eq!(moved, group.coadjoint::<Rational>(&g, &map.apply::<Rational>(&z)));
            let wrong = group.coadjoint::<Rational>(&group.inverse(&g), &map.apply::<Rational>(&z));
            assert_ne!(moved, wrong, "a check that accepts Ad*_(g⁻¹) checks nothing");
        }
    }
}

fn casimirs_hold<A: Casimirs>(algebra: &A) {
    for mu in rational_samples::<Momentum<A, Rational>>(4) {
        for index in 0..A::COUNT {
            let dc = algebra.casimir_differential::<Rational>(index, &mu);
            assert_eq!(algebra.coadjoint::<Rational>(&dc, &mu), Vector::zero());
        }
    }
}

#[test]
fn casimirs() {
    casimirs_hold(&So3);
    casimirs_hold(&Sl2);
    casimirs_hold(&Se2::default());
    casimirs_hold(&Se3::default());
    casimirs_hold(&UnitaryAlgebra::<3>);
    casimirs_hold(&PowerAlgebra::<_, 2>(Se3::default()));
}

fn jacobi_holds<A: LieAlgebra>(algebra: &A) {
    let samples = rational_samples::<A::Element<Rational>>(3);
    let bracket =
        |a: &A::Element<Rational>, b: &A::Element<Rational>| algebra.bracket::<Rational>(a, b);
    let [x, y, z] = [&samples[0], &samples[1], &samples[2]];
    let cyclic =
        bracket(x, &bracket(y, z)) + bracket(y, &bracket(z, x)) + bracket(z, &bracket(x, y));
    assert_eq!(cyclic, Vector::zero());
}

#[test]
fn the_jacobi_identity() {
    jacobi_holds(&So3);
    jacobi_holds(&Sl2);
    jacobi_holds(&Se3::default());
    jacobi_holds(&SpinorAlgebra::default());
    jacobi_holds(&UnitaryAlgebra::<3>);
    jacobi_holds(&SemidirectAlgebra(Inherited { quotient: SO3OnR3, representation: SO3OnR3 }));
}

#[test]
fn the_fibre_symmetry_and_its_momenta() {
    for z in rational_samples::<Cotangent<Vector2<Complex<Rational>>>>(4) {
        let mu = SpinorRealisation.apply(&z);
        let moved = SpinorRealisation.flow(0, Rational::new(-7, 3), &z);
        assert_eq!(SpinorRealisation.apply(&moved), mu);
        let [j1, j2] = [0, 1].map(|index| SpinorRealisation.momentum(index, &z));
        // The relations f₁ = 4J₁² and f₂ = J₁J₂.
        assert_eq!(Se3::default().casimir(0, &mu), j1 * j1 * 4.0);
        assert_eq!(Se3::default().casimir(1, &mu), j1 * j2);
    }
}
