//! Tables of numbers: tableaux, substeps and structure constants.

use super::steps;
use crate::input::Input;
use collective_integrators::{
    AlternatingSubsteps, Direct, FirstHalf, HamiltonianField, PartitionedRungeKutta, RungeKutta,
    Substeps, Tableau,
};
use heavytop::HeavyTop;
use lie_poisson::{LiePoisson, Se3, Se3Dual, StructureConstants};

pub(super) fn tableau(input: &mut Input<'_>) {
    let stages = input.choice(4);
    let a: Vec<f64> = (0..stages * stages).map(|_| input.number()).collect();
    let b: Vec<f64> = (0..stages).map(|_| input.number()).collect();
    let Ok(tableau) = Tableau::new(&a, &b) else { return };
    let _ = PartitionedRungeKutta::<FirstHalf>::new(tableau.clone(), tableau.clone());
    let start = Se3Dual::new(input.vector(), input.vector());
    let Ok(top) = HeavyTop::kovalevskaya(1.0, 1.0) else { return };
    let direct = HamiltonianField { space: LiePoisson::minus(Se3::default()), hamiltonian: top };
    steps(&Direct::new(RungeKutta::new(tableau), direct), &start, input.number());
}

pub(super) fn substeps(input: &mut Input<'_>) {
    let count = input.choice(6);
    let mut fractions: Vec<f64> = (0..count).map(|_| input.number()).collect();
    if input.choice(2) == 0 {
        fractions.push(1.0 - fractions.iter().sum::<f64>());
    }
    if let Ok(substeps) = Substeps::new(&fractions) {
        assert!(
            (substeps.fractions().iter().sum::<f64>() - 1.0).abs() <= 1.001e-8,
            "{fractions:?}"
        );
    }
    let _ = AlternatingSubsteps::new(&fractions, &fractions);
}

pub(super) fn structure_constants(input: &mut Input<'_>) {
    let table: [[f64; 3]; 3] = [(); 3].map(|()| input.numbers());
    let c = |i: usize, j: usize, k: usize| match (i, j) {
        (0, 1) => table[0][k],
        (1, 0) => -table[0][k],
        (0, 2) => table[1][k],
        (2, 0) => -table[1][k],
        (1, 2) => table[2][k],
        (2, 1) => -table[2][k],
        _ => 0.0,
    };
    let _ = StructureConstants::<3>::new(c);
}
