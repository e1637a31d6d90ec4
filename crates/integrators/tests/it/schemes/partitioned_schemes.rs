//! Partitioned methods: order, symplecticity, symmetry, and what they do not conserve.

use crate::support::*;
use collective_integrators::*;
use lie_poisson::{DualNumber, Vector, derivative_part, seed};
use momentum_map::{SymplecticComplexSpace, SymplecticSpace};
use nalgebra::{SVector, Vector2};
use num_complex::Complex;

type Method = PartitionedRungeKutta<FirstHalf>;

#[test]
fn partitioned_methods_keep_their_promises() {
    let lobatto = |s| Method::lobatto_iiia_iiib(s).unwrap();
    let methods: [(&str, Method, usize, bool); 7] = [
        ("Euler, implicit in p", Method::symplectic_euler_implicit_in_p(), 1, false),
        ("Euler, implicit in q", Method::symplectic_euler_implicit_in_q(), 1, false),
        ("kick–drift–kick", Method::kick_drift_kick(), 2, true),
        ("drift–kick–drift", Method::drift_kick_drift(), 2, true),
        ("Lobatto, 2 stages", lobatto(2), 2, true),
        ("Lobatto, 3 stages", lobatto(3), 4, true),
        ("Lobatto, 4 stages", lobatto(4), 6, true),
    ];
    for (name, method, order, symmetric) in methods {
        assert_eq!((method.order(), method.is_symmetric()), (order, symmetric), "{name}");
        assert!(method.is_symplectic() && !method.preserves_quadratic_invariants(), "{name}");
        keeps_its_promises(&method, name);
    }
    assert_eq!(lobatto(2), Method::kick_drift_kick());
}

/// Negative controls: pairs of tableaux that are no symplectic method.
#[test]
fn a_pair_is_not_symplectic_by_being_a_pair() {
    let rk4 = RungeKutta::rk4().tableau().clone();
    let equal = Method::new(rk4.clone(), rk4).unwrap();
    assert_eq!((equal.order(), equal.is_symplectic(), equal.is_symmetric()), (4, false, false));
    keeps_its_promises(&equal, "RK4 twice");
    let iiia = Tableau::lobatto_iiia(3).unwrap();
    let iiia = Method::new(iiia.clone(), iiia).unwrap();
    assert_eq!((iiia.order(), iiia.is_symplectic(), iiia.is_symmetric()), (4, false, true));
    keeps_its_promises(&iiia, "Lobatto IIIA twice");
    // Both tableaux have order 4, alone and together; neither is symmetric or symplectic.
    let mixed = Method::new(
        Tableau::lobatto_iiia(3).unwrap(),
        Tableau::new(
            &[
                1.0 / 6.0,
                -1.0 / 3.0,
                1.0 / 6.0,
                1.0 / 6.0,
                5.0 / 12.0,
                -1.0 / 12.0,
                1.0 / 6.0,
                2.0 / 3.0,
                1.0 / 6.0,
            ],
            &[1.0 / 6.0, 2.0 / 3.0, 1.0 / 6.0],
        )
        .unwrap(),
    )
    .unwrap();
    assert_eq!((mixed.order(), mixed.is_symplectic(), mixed.is_symmetric()), (4, false, false));
    keeps_its_promises(&mixed, "Lobatto IIIA with IIIC");
    let gauss = |s| Tableau::gauss(s).unwrap();
    assert_eq!(Method::new(gauss(1), gauss(2)), Err(SchemeError::Stages { q: 1, p: 2 }));
    let twice = Method::new(gauss(6), gauss(6)).unwrap();
    assert!(twice.order() == 12 && twice.preserves_quadratic_invariants());
}

/// A rotation of the plane mixes q and p: the midpoint rule keeps |z|², Störmer–Verlet does not.
#[test]
fn quadratic_invariants_that_mix_q_and_p_are_lost() {
    let oscillator = from_fn(|z: &Vector2<f64>| Vector2::new(z.y, -z.x) * z.norm_squared());
    let z = Vector2::new(0.8, 0.6);
    let change = |z: Vector2<f64>| (z.norm_squared() - 1.0).abs();
    let verlet = PartitionedRungeKutta::<Alternating>::kick_drift_kick();
    assert!(change(advance(&verlet, &oscillator, z, 0.2, 1)) > 1e-3);
    let midpoint = RungeKutta::implicit_midpoint();
    assert!(change(advance(&midpoint, &oscillator, z, 0.2, 1)) < ROUND_OFF);
    // The bilinear invariant q₁p₂ − q₂p₁ of a central force is conserved.
    let central = from_fn(|z: &SVector<Complex<f64>, 2>| {
        let r2 = z.x.re * z.x.re + z.y.re * z.y.re;
        z.map(|z| Complex::new(z.im, -z.re * r2))
    });
    let z = SVector::from([Complex::new(0.3, 0.9), Complex::new(-0.5, 0.4)]);
    let momentum = |z: &SVector<Complex<f64>, 2>| z.x.re * z.y.im - z.y.re * z.x.im;
    let after = advance(&verlet, &central, z, 0.2, 1);
    assert!((momentum(&after) - momentum(&z)).abs() < ROUND_OFF);
}

type ComplexPoint = SVector<Complex<DualNumber>, 2>;

/// The conjugate of a position is a momentum, whose conjugate is that position.
#[test]
fn coordinates_come_in_conjugate_pairs() {
    fn check<P: Polarisation>(position_and_momentum: [usize; 2]) {
        for i in 0..6 {
            let other = P::conjugate(i, 6);
            assert!(
                P::conjugate(other, 6) == i && P::is_position(other, 6) != P::is_position(i, 6)
            );
        }
        let [q, p] = position_and_momentum;
        assert_eq!((P::conjugate(q, 6), P::is_position(q, 6)), (p, true));
    }
    check::<FirstHalf>([1, 4]);
    check::<Alternating>([2, 3]);
}

#[test]
fn complex_points_alternate() {
    // z = q + ip, H = ¼ |z|⁴: ż = −i |z|² z
    fn field<T: lie_poisson::Real>() -> impl VectorField<T, Point = SVector<Complex<T>, 2>> {
        from_fn(|z: &SVector<Complex<T>, 2>| {
            let r2 = z.x.norm_sqr() + z.y.norm_sqr();
            z.map(|z| Complex { re: z.im * r2, im: -z.re * r2 })
        })
    }
    let z = SVector::from([Complex::new(0.3, 0.9), Complex::new(-0.5, 0.4)]);
    let space = SymplecticComplexSpace::<2>;
    let defect = |step: &dyn Fn(&ComplexPoint) -> ComplexPoint| {
        let column = |i| -> SVector<Complex<f64>, 2> {
            derivative_part(&step(&seed(&z, &Vector::basis(i))))
        };
        let mut worst = 0.0_f64;
        for i in 0..4 {
            for j in 0..i {
                let flat = space.symplectic_form::<f64>(&Vector::basis(i), &Vector::basis(j));
                worst = worst.max((space.symplectic_form(&column(i), &column(j)) - flat).abs());
            }
        }
        worst
    };
    let right = PartitionedRungeKutta::<Alternating>::kick_drift_kick();
    let wrong = PartitionedRungeKutta::<FirstHalf>::kick_drift_kick();
    let right = defect(&|z| right.step(&field(), z, 0.1, &mut right.workspace()).unwrap().point);
    let wrong = defect(&|z| wrong.step(&field(), z, 0.1, &mut wrong.workspace()).unwrap().point);
    assert!(right < ROUND_OFF && wrong > 1e-4, "{right:e} {wrong:e}");
}
