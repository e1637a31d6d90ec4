//! Errors of Lie algebras and their representations.

use super::refused;
use lie_poisson::{
    Cocycle, InfinitesimalAdjoint, InnerProduct, InputTable, Inputs, Interpolation, IsotropicNoise,
    StructureConstants, StructureEntry, StructureTable,
};
use nalgebra::Vector3;

/// Returns the errors of tables of constants, of linear maps, of matrices and of inputs that are what they should not be.
pub fn errors() -> Vec<String> {
    let heisenberg = |i, j, k| match (i, j, k) {
        (0, 1, 2) => 1.0,
        (1, 0, 2) => -1.0,
        _ => 0.0,
    };
    // [e₀, e₁] = e₂ and [e₀, e₂] = e₁, but [e₁, e₂] = e₁
    let broken = |i, j, k| match (i, j, k) {
        (0, 1, 2) | (0, 2, 1) | (1, 2, 1) => 1.0,
        (1, 0, 2) | (2, 0, 1) | (2, 1, 1) => -1.0,
        _ => 0.0,
    };
    let identity = |i, j| if i == j { 1.0 } else { 0.0 };
    let adjoint = || StructureConstants::<3>::new(heisenberg).map(InfinitesimalAdjoint).unwrap();
    let table = |times: &[f64], values: &[f64]| {
        InputTable::new(times.to_vec(), values.to_vec(), Interpolation::Linear)
    };
    vec![
        refused(IsotropicNoise::thermal(InnerProduct::euclidean(), (-1.0, 1.0))),
        refused(IsotropicNoise::thermal(InnerProduct::euclidean(), (1.0, f64::NAN))),
        refused(StructureTable::new(2, [StructureEntry { i: 0, j: 1, k: 2, value: 1.0 }])),
        refused(StructureConstants::<3>::new(|_, _, _| f64::NAN)),
        refused(StructureConstants::<3>::new(|_, _, _| 1.0)),
        refused(StructureConstants::<3>::new(broken)),
        refused(Cocycle::new(adjoint(), identity)),
        refused(Cocycle::new(adjoint(), |_, _| f64::INFINITY)),
        refused(InnerProduct::new(&[1.0, 0.0])),
        refused(InnerProduct::new(&[1.0, 0.0, 2.0, 9.0])),
        refused(InnerProduct::new(&[1.0, 0.0, 0.0, -1.0])),
        refused(table(&[0.0, 1.0], &[1.0])),
        refused(table(&[0.0], &[1.0])),
        refused(table(&[0.0, 1.0], &[1.0, f64::NAN])),
        refused(table(&[1.0, 1.0], &[0.0, 0.0])),
        refused(table(&[0.0, 1e-300], &[0.0, 1e300])),
        refused(table(&[0.0, 1.0], &[0.0, 1.0]).unwrap().require_until(0.0, 2.0)),
        refused(Inputs::new(vec![(
            Vector3::new(f64::NAN, 0.0, 0.0),
            table(&[0.0, 1.0], &[0.0, 1.0]).unwrap(),
        )])),
    ]
}
