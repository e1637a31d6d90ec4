//! Random points at three regimes: special, within 1e-8 of special, generic.
//!
//! The special points of a vector space are 0, its basis and points with coordinates in
//! {0, ±½, ±1}, where formulas vanish or branch; a formula with a small-angle branch shows itself
//! near them.

use lie_poisson::{AlgebraElement, LieGroup, Se3Dual, Vector};
use nalgebra::Vector3;
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::test_runner::FileFailurePersistence;

/// Draws 0, a basis vector, or coordinates in {0, ±½, ±1}.
fn special<V: Vector<Scalar = f64>>() -> impl Strategy<Value = V> {
    let corner = prop::sample::select(vec![0.0, 0.5, -0.5, 1.0, -1.0]);
    prop_oneof![
        1 => Just(V::zero()),
        2 => (0..V::DIM).prop_map(V::basis),
        2 => vec(corner, V::DIM).prop_map(|x| V::from_coordinates(|i| x[i])),
    ]
}

/// Draws coordinates in [−size, size].
fn within<V: Vector<Scalar = f64>>(size: f64) -> impl Strategy<Value = V> {
    vec(-size..size, V::DIM).prop_map(|x| V::from_coordinates(|i| x[i]))
}

/// Draws a vector: special, within 1e-8 of special, or generic with coordinates up to 3.
pub fn point<V: Vector<Scalar = f64>>() -> impl Strategy<Value = V> {
    prop_oneof![
        2 => special::<V>(),
        1 => (special::<V>(), within::<V>(1e-8)).prop_map(|(v, noise)| v + noise),
        3 => within::<V>(3.0),
    ]
}

/// Draws an element exp ξ of a group: the identity, within 1e-8 of it, special or generic.
pub fn element<G: LieGroup + 'static>(group: G) -> impl Strategy<Value = G::Element<f64>> {
    let algebra = prop_oneof![
        1 => within::<AlgebraElement<G>>(1e-8),
        4 => point::<AlgebraElement<G>>(),
    ];
    algebra.prop_map(move |xi| group.exp::<f64>(&xi))
}

/// Draws (Π, Γ) with Γ ≠ 0: Γ at a pole, near one, on the equator or generic, from 1e-100 to 1e100 in size; Π zero,
/// special or generic.
pub fn momentum_with_vertical() -> impl Strategy<Value = Se3Dual> {
    let poles = prop::sample::select(vec![1.0, -1.0]).prop_map(|z| Vector3::new(0.0, 0.0, z));
    let equator = (-3.2..3.2_f64).prop_map(|angle| Vector3::new(angle.cos(), angle.sin(), 0.0));
    let near = (poles.clone(), within::<Vector3<f64>>(1e-8)).prop_map(|(pole, noise)| pole + noise);
    let generic = within::<Vector3<f64>>(3.0).prop_filter("Γ ≠ 0", |gamma| gamma.norm() > 1e-3);
    let direction = prop_oneof![poles, near, equator, generic];
    let size = prop_oneof![2 => Just(1.0), 1 => (-100..=100_i32).prop_map(|k| 10.0_f64.powi(k))];
    (point::<Vector3<f64>>(), direction, size)
        .prop_map(|(pi, gamma, size)| Se3Dual::new(pi, gamma * size))
}

/// Returns the configuration of every property test: the default, with failing cases kept next to the test's file.
/// The default place is in `src`.
pub fn persistent() -> ProptestConfig {
    ProptestConfig::with_failure_persistence(FileFailurePersistence::WithSource("regressions"))
}
