//! The Clebsch map of an algebra of any dimension: [`QuadraticMomenta::clebsch`].

use super::cocycles::{cocycle, grading};
use crate::realisations::odd_powers::descends;
use crate::realisations::quadratic_momenta::QuadraticMomenta;
use lie_poisson::StructureTable;
use nalgebra::DMatrix;

/// The largest weight below which no basis vector is scaled.
const SCALED: f64 = 1e-6;

impl QuadraticMomenta {
    /// Returns the momenta of two copies of a representation on 𝔤 or 𝔤∗ that reach an open part of 𝔤∗; `None` if none is found.
    ///
    /// It is the adjoint one. The adjoint representation of an algebra with a centre does not see the centre, and is extended by a
    /// cocycle c to 𝔤 ⊕ R: ξ·(η, t) = ([ξ, η] − t c(ξ), 0). For a derivation, this is the one of 𝔤 ⋊ RD. Where no derivation sees
    /// the centre, the coadjoint representation is extended in the same way.
    pub(crate) fn clebsch(algebra: &StructureTable) -> Option<Self> {
        found(algebra).map(|(_, momenta)| momenta)
    }

    /// Returns whether steps along the momenta of [`clebsch`](Self::clebsch) descend to 𝔤∗.
    pub(crate) fn clebsch_descends(algebra: &StructureTable) -> bool {
        found(algebra).is_some_and(|(matrices, _)| descends(&matrices))
    }
}

/// Returns the matrices of the first representation whose momenta reach an open part of 𝔤∗, and these momenta.
fn found(algebra: &StructureTable) -> Option<(Vec<DMatrix<f64>>, QuadraticMomenta)> {
    let adjoint = adjoint_matrices(algebra);
    let scaled = || {
        let weights = grading(algebra);
        let scales = weights.amax() >= SCALED;
        scales.then(|| extended(&adjoint, &DMatrix::from_diagonal(&weights)))
    };
    let generic = |matrices: &[DMatrix<f64>]| {
        cocycle(algebra, matrices).map(|cocycle| extended(matrices, &cocycle))
    };
    let coadjoint = || -> Vec<DMatrix<f64>> { adjoint.iter().map(|ad| -ad.transpose()).collect() };
    let candidates: [&dyn Fn() -> Option<Vec<DMatrix<f64>>>; 4] =
        [&|| Some(adjoint.clone()), &scaled, &|| generic(&adjoint), &|| generic(&coadjoint())];
    candidates.iter().filter_map(|candidate| candidate()).find_map(|matrices| {
        let momenta = QuadraticMomenta::of_copies(&matrices, 2).ok()?;
        (momenta.rank() == algebra.dimension()).then_some((matrices, momenta))
    })
}

/// Returns the matrices of the adjoint representation.
fn adjoint_matrices(algebra: &StructureTable) -> Vec<DMatrix<f64>> {
    let d = algebra.dimension();
    let mut matrices = vec![DMatrix::zeros(d, d); d];
    for entry in algebra.entries() {
        if let Some(matrix) = matrices.get_mut(entry.i) {
            matrix[(entry.k, entry.j)] = entry.value;
        }
    }
    matrices
}

/// Returns the matrices of a representation that is extended by a cocycle, whose columns are its values c(e_a). It is multiplied
/// by the largest entry of the matrices, so that both have one scale.
fn extended(matrices: &[DMatrix<f64>], cocycle: &DMatrix<f64>) -> Vec<DMatrix<f64>> {
    let largest = matrices.iter().map(DMatrix::amax).fold(0.0, f64::max);
    let cocycle = if largest > 0.0 { cocycle * largest } else { cocycle.clone() };
    let extended = |(a, matrix): (usize, &DMatrix<f64>)| {
        let d = matrix.nrows();
        let mut extended = DMatrix::zeros(d + 1, d + 1);
        extended.view_mut((0, 0), (d, d)).copy_from(matrix);
        extended.view_mut((0, d), (d, 1)).copy_from(&-cocycle.column(a));
        extended
    };
    matrices.iter().enumerate().map(extended).collect()
}
