//! Which maps are Poisson: DΦ Λ(W) DΦᵀ = Λ(Φ(W)), Λ(W)_ab = ⟨W, [e_a, e_b]⟩.

use crate::examples::{Quadratic, generic};
use isospectral_flows::collective_integrators::{
    Composition, Direct, Integrator, RungeKutta, Substeps,
};
use isospectral_flows::lie_poisson::State;
use isospectral_flows::{
    CommutatorField, ExponentialMidpoint, GaussMagnus, IsospectralRungeKutta, LargeSkewHermitian,
    Products,
};
use nalgebra::DMatrix;

const SIZE: usize = 3;
const DIMENSION: usize = SIZE * SIZE;

/// Returns the basis vector with the index a, of norm 1.
fn basis(a: usize) -> LargeSkewHermitian {
    let mut e = LargeSkewHermitian::zeros(SIZE);
    e.set_coordinate(a, 1.0);
    let norm = e.norm();
    e.scale_in_place(1.0 / norm);
    e
}

fn bracket(w: &LargeSkewHermitian) -> DMatrix<f64> {
    let mut commutator = w.zeros_like();
    DMatrix::from_fn(DIMENSION, DIMENSION, |a, b| {
        Products::default().commutator(&basis(a), &basis(b), &mut commutator);
        w.scalar_product(&commutator)
    })
}

/// Returns the relative Poisson defect of a step, with a Jacobian by central differences of order four.
fn defect<I: Integrator<State = LargeSkewHermitian>>(integrator: &I, h: f64) -> f64 {
    let (w, width) = (generic(SIZE, 0.3), 1e-3);
    let image =
        |w: &LargeSkewHermitian| integrator.step(w, h, &mut integrator.workspace()).unwrap().point;
    let moved = |b: usize, shift: f64| {
        let mut w = w.clone();
        w.add_multiple(shift, &basis(b));
        image(&w)
    };
    let mut jacobian = DMatrix::zeros(DIMENSION, DIMENSION);
    for b in 0..DIMENSION {
        let mut slope = w.zeros_like();
        for (weight, shift) in [(8.0, 1.0), (-8.0, -1.0), (-1.0, 2.0), (1.0, -2.0)] {
            slope.add_multiple(weight / (12.0 * width), &moved(b, shift * width));
        }
        (0..DIMENSION).for_each(|a| jacobian[(a, b)] = slope.scalar_product(&basis(a)));
    }
    let end = bracket(&image(&w));
    (&jacobian * bracket(&w) * jacobian.transpose() - &end).amax() / end.amax()
}

#[test]
#[ignore = "long"]
fn collective_and_variational_methods_are_poisson_maps_and_the_others_are_not() {
    let field = || Quadratic(SIZE);
    let h = 0.5;
    // Differences of order four with a width of 1e-3 are right to 1e-10 or so.
    let accuracy = 1e-9;
    let collective = |scheme| IsospectralRungeKutta::new(scheme, field());
    assert!(defect(&collective(RungeKutta::implicit_midpoint()), h) < accuracy);
    assert!(defect(&collective(RungeKutta::gauss(2).unwrap()), h) < accuracy);
    let midpoint = ExponentialMidpoint::new(field());
    assert!(defect(&midpoint, h) < accuracy, "{:e}", defect(&midpoint, h));
    let composed = Composition::new(midpoint, Substeps::suzuki4());
    assert!(defect(&composed, h) < accuracy);
    for stages in [1, 2] {
        let magnus = defect(&GaussMagnus::new(stages, field()).unwrap(), h);
        assert!(magnus > 1e-6, "{stages} {magnus:e}");
    }
    let direct = Direct::new(RungeKutta::rk4(), CommutatorField::new(field()));
    assert!(defect(&direct, h) > 1e-6);
}
