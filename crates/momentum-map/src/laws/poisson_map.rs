//! The law suites of [`PoissonMap`] and of symplectic spaces.

use super::{Faulty, NoSamples, Report, regimes};
use crate::maps::poisson_map::{PoissonMap, SourcePoint, TargetDifferential, TargetPoint};
use crate::maps::recentring::RecentringWorkspace;
use crate::phase_spaces::symplectic::SymplecticSpace;
use lie_poisson::{
    Differential, DualNumber, Point, PoissonSpace, Real, Vector, transposed_tangent,
};

/// Evaluates the laws of a Poisson map on samples of points:
///
/// * `pull-back`: the pull-back is the transposed derivative of `apply`;
/// * `generator`: the generator is the Hamiltonian vector of the pull-back;
/// * `Poisson`: {M_i, M_j} = Λ_ij ∘ M for all coordinates.
///
/// # Errors
/// Returns [`NoSamples`] if there are no samples.
pub fn poisson_map<M: PoissonMap>(
    map: &M,
    samples: &[SourcePoint<M>],
) -> Result<Report, NoSamples> {
    let (source, target, mut report) = (map.source(), map.target(), Report::default());
    let n = TargetPoint::<M>::DIM;
    for z in regimes("points", samples)? {
        let exact = |alpha: &TargetDifferential<M>| -> Differential<M::Source> {
            let apply = |z: &SourcePoint<M, DualNumber>| map.apply::<DualNumber>(z);
            transposed_tangent(apply, &z, alpha)
        };
        let tensor = target.poisson_tensor::<f64>(&map.apply::<f64>(&z));
        let slopes: Vec<Differential<M::Source>> =
            (0..n).map(|i| exact(&Vector::basis(i))).collect();
        let size = slopes.iter().fold(1e-300, |m: f64, slope| m.max(slope.max_abs()));
        for (i, slope) in slopes.iter().enumerate() {
            let alpha: TargetDifferential<M> = Vector::basis(i);
            let pulled = map.pull_back::<f64>(&alpha, &z);
            report.note("pull-back", (pulled - *slope).max_abs(), size);
            let vector = source.hamiltonian_vector::<f64>(&z, slope);
            let generated = map.generator::<f64>(&alpha, &z);
            report.note("generator", (generated - vector).max_abs(), size);
            for (j, other) in slopes.iter().enumerate() {
                let defect = source.bracket::<f64>(&z, slope, other) - tensor[(i, j)];
                report.note("Poisson", defect.abs(), size * size);
            }
        }
    }
    Ok(report)
}

/// The fault can be in the methods [`apply`](PoissonMap::apply), [`pull_back`](PoissonMap::pull_back) and
/// [`generator`](PoissonMap::generator).
impl<M: PoissonMap> PoissonMap for Faulty<'_, M> {
    type Source = M::Source;
    type Target = M::Target;

    fn source(&self) -> M::Source {
        self.object().source()
    }

    fn target(&self) -> M::Target {
        self.object().target()
    }

    fn apply<T: Real>(&self, z: &SourcePoint<M, T>) -> TargetPoint<M, T> {
        self.halved("apply", self.object().apply::<T>(z))
    }

    fn pull_back<T: Real>(
        &self,
        alpha: &TargetDifferential<M, T>,
        z: &SourcePoint<M, T>,
    ) -> Differential<M::Source, T> {
        self.halved("pull_back", self.object().pull_back::<T>(alpha, z))
    }

    fn generator<T: Real>(
        &self,
        alpha: &TargetDifferential<M, T>,
        z: &SourcePoint<M, T>,
    ) -> SourcePoint<M, T> {
        self.halved("generator", self.object().generator::<T>(alpha, z))
    }

    fn equivariant_maps_descend(&self) -> bool {
        self.object().equivariant_maps_descend()
    }

    fn gauge<T: Real>(&self, z: &SourcePoint<M, T>) -> SourcePoint<M, T> {
        self.object().gauge::<T>(z)
    }

    fn recentred<T: Real>(
        &self,
        z: &SourcePoint<M, T>,
        space: &mut RecentringWorkspace<T>,
    ) -> SourcePoint<M, T> {
        self.object().recentred::<T>(z, space)
    }
}

/// Evaluates the laws of a symplectic space on samples of points.
///
/// The laws are `flat inverts sharp`, i_X Ω = dH for X = X_H, and `antisymmetry` of Ω.
///
/// # Errors
/// Returns [`NoSamples`] if there are no samples.
pub fn symplectic_space<P: SymplecticSpace>(
    space: &P,
    samples: &[Point<P>],
) -> Result<Report, NoSamples> {
    let mut report = Report::default();
    for z in regimes("points", samples)? {
        for i in 0..Point::<P>::DIM {
            let alpha: Differential<P> = Vector::basis(i);
            let back = space.flat::<f64>(&space.hamiltonian_vector::<f64>(&z, &alpha)) - alpha;
            report.note("flat inverts sharp", back.max_abs(), 1.0);
            let v = Vector::basis(i);
            let sum = space.symplectic_form::<f64>(&z, &v) + space.symplectic_form::<f64>(&v, &z);
            report.note("antisymmetry", sum.abs(), z.max_abs().max(1e-300));
        }
    }
    Ok(report)
}
