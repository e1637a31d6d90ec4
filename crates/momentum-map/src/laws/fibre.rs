//! The law suites of [`FibreSymmetry`] and [`Lift`].

use super::{Faulty, NoSamples, Report, regimes};
use crate::maps::fibre::{FibreSymmetry, Lift, LiftError};
use crate::maps::poisson_map::{SourcePoint, TargetPoint};
use lie_poisson::{
    DualNumber, PoissonSpace, Real, Vector, derivative_part, differential, map_coordinates,
};

/// Evaluates the laws of a fibre symmetry on samples of points and of parameters s:
///
/// * `invariance` M ∘ flow = M, and `one-parameter group`;
/// * `commuting flows`;
/// * `momentum`: the Hamiltonian vector field of the momentum generates the flow;
/// * `gauge`: M(z + gauge(z)) = M(z).
///
/// # Errors
/// Returns [`NoSamples`] if one of the lists of samples is empty.
pub fn fibre_symmetry<M: FibreSymmetry>(
    map: &M,
    points: &[SourcePoint<M>],
    parameters: &[f64],
) -> Result<Report, NoSamples> {
    if parameters.is_empty() {
        return Err(NoSamples { what: "parameters" });
    }
    let mut report = Report::default();
    for z in regimes("points", points)? {
        let mu = map.apply::<f64>(&z);
        let gauged = map.apply::<f64>(&(z + map.gauge::<f64>(&z))) - mu;
        if z.max_abs() != 0.0 {
            report.note("gauge", gauged.max_abs(), z.max_abs().powi(2));
        }
        for index in 0..M::COUNT {
            generates(map, index, &z, &mut report);
            for &s in parameters {
                let moved = map.flow::<f64>(index, s, &z);
                let scale = 1e-300 + z.max_abs().max(moved.max_abs()).powi(2);
                let image = map.apply::<f64>(&moved);
                report.note("invariance", (image - mu).max_abs(), scale);
                let twice = map.flow::<f64>(index, s, &moved);
                let at_once = map.flow::<f64>(index, 2.0 * s, &z);
                let size = 1e-300 + twice.max_abs().max(z.max_abs());
                report.note("one-parameter group", (twice - at_once).max_abs(), size);
                for other in 0..index {
                    let one = map.flow::<f64>(other, s, &moved);
                    let two = map.flow::<f64>(index, s, &map.flow::<f64>(other, s, &z));
                    let size = 1e-300 + one.max_abs().max(z.max_abs());
                    report.note("commuting flows", (one - two).max_abs(), size);
                }
            }
        }
    }
    Ok(report)
}

/// The fault can be in the method [`flow`](FibreSymmetry::flow).
impl<M: FibreSymmetry> FibreSymmetry for Faulty<'_, M> {
    const COUNT: usize = M::COUNT;

    fn flow<T: Real>(&self, index: usize, s: T, z: &SourcePoint<M, T>) -> SourcePoint<M, T> {
        self.halved("flow", self.object().flow::<T>(index, s, z))
    }

    fn momentum<T: Real>(&self, index: usize, z: &SourcePoint<M, T>) -> T {
        self.object().momentum::<T>(index, z)
    }
}

fn generates<M: FibreSymmetry>(map: &M, index: usize, z: &SourcePoint<M>, report: &mut Report) {
    let dj = differential(|z: &SourcePoint<M, DualNumber>| map.momentum::<DualNumber>(index, z), z);
    let vector = map.source().hamiltonian_vector::<f64>(z, &dj);
    let constant = map_coordinates(z, DualNumber::constant);
    let along = map.flow::<DualNumber>(index, DualNumber::variable(0.0), &constant);
    let velocity: SourcePoint<M> = derivative_part(&along);
    report.note("momentum", (velocity - vector).max_abs(), z.max_abs().max(1e-300));
}

/// Evaluates the law `section` of a lift, M(lift μ) = μ, on samples of momenta of the image.
///
/// The momentum 0 is left out, since the fibre degenerates there. A momentum without a lift gives a residual of NaN.
///
/// # Errors
/// Returns [`NoSamples`] if there are no samples.
pub fn lift<M: Lift>(map: &M, samples: &[TargetPoint<M>]) -> Result<Report, NoSamples> {
    let mut report = Report::default();
    for mu in regimes("momenta", samples)?.into_iter().filter(|mu| mu.max_abs() != 0.0) {
        let residual =
            map.lift::<f64>(&mu).map_or(f64::NAN, |z| (map.apply::<f64>(&z) - mu).max_abs());
        report.note("section", residual, mu.max_abs());
    }
    Ok(report)
}

/// The fault can be in the method [`lift`](Lift::lift).
impl<M: Lift> Lift for Faulty<'_, M> {
    fn lift<T: Real>(&self, mu: &TargetPoint<M, T>) -> Result<SourcePoint<M, T>, LiftError> {
        Ok(self.halved("lift", self.object().lift::<T>(mu)?))
    }
}
