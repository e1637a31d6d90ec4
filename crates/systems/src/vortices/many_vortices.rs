//! Point vortices on the sphere, whose number is known only when the program runs.

use crate::error::SystemError;
use crate::vortices::interaction::{add_differential, pairs, require_strength};
use crate::vortices::lane_interaction::Interaction;
use crate::vortices::sources::{BLOCK, Sources};
use collective_integrators::{StoragePool, VectorField};
use core::f64::consts::PI;
use lie_poisson::generic_scalars::{InstructionSet, MissingInstructions, Width, dispatch};
use lie_poisson::{Covector, Real, Sites, SitesHamiltonian, State, Vector};
use nalgebra::Vector3;
use rayon::iter::{IndexedParallelIterator, IntoParallelRefIterator, ParallelIterator};
use rayon::slice::ParallelSliceMut;

/// N point vortices on the unit sphere, with a number N that is known only when the program runs.
///
/// The equations, the variables m_i = k_i x_i and the units are those of [`PointVortices`](crate::PointVortices):
///
/// ```text
/// dm_i/dt = m_i × dh/dm_i,    h(m) = (1/4π) Σ_ij k_i k_j ln(2 − 2 x_i·x_j),    i < j
/// ```
///
/// Integrators for [`State`]s advance the vortices in place: schemes applied to the equations, and the
/// [`SphericalMidpoint`](collective_integrators::SphericalMidpoint) method, which is a Poisson map of order 2. As a
/// [`SitesHamiltonian`] it serves [`CollectiveSites`](collective_integrators::CollectiveSites), for Poisson maps of any
/// order on copies of [`HOPF`](momentum_map::HOPF).
///
/// From 32 vortices on, the rates of plain numbers `f64` are computed on the widest SIMD lanes of the processor and on
/// all threads of the current pool. They are bit-identical for any number of threads. They differ by rounding from the
/// rates as computed for fewer vortices. Unless the instructions are [portable](Self::with_instructions), they also
/// differ by rounding between processors with and without fused multiply-add.
///
/// # Example
/// A ring of vortices on a parallel of the sphere turns as a rigid body:
/// ```
/// use collective_integrators::{Integrator, SphericalMidpoint};
/// use lie_poisson_systems::ManyVortices;
/// use nalgebra::Vector3;
/// let count = 12; // from a file, say
/// let vortices = ManyVortices::new(vec![1.0; count])?;
/// let on_parallel = |i: usize| {
///     let (sin, cos) = (i as f64 * std::f64::consts::TAU / count as f64).sin_cos();
///     Vector3::new(0.6 * cos, 0.6 * sin, 0.8)
/// };
/// let start = vortices.momentum((0..count).map(on_parallel))?;
/// let midpoint = SphericalMidpoint::new(vortices.clone());
/// let mut run = midpoint.trajectory_from(start, 0.01);
/// assert!(vortices.positions(run.advance(100)?).all(|x| (x.z - 0.8).abs() < 1e-13));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ManyVortices {
    strengths: Vec<f64>,
    /// The reciprocals 1/k_i of the strengths.
    inverses: Vec<f64>,
    instructions: InstructionSet,
    storage: StoragePool<Sources>,
}

/// The least number of vortices whose interactions are computed on SIMD lanes.
const MANY: usize = 32;

/// The number of interactions of a task, so that a few hundred vortices are not spread over threads.
const TASK: usize = 1 << 16;

impl ManyVortices {
    /// Creates vortices of the given strengths k_i, in m²/s.
    ///
    /// # Errors
    /// Returns [`SystemError`] if a strength is not finite, or is so near zero that its reciprocal is not finite.
    pub fn new(strengths: Vec<f64>) -> Result<Self, SystemError> {
        strengths.iter().try_for_each(|&strength| require_strength(strength))?;
        let inverses = strengths.iter().map(|strength| strength.recip()).collect();
        let instructions = InstructionSet::detected();
        Ok(Self { strengths, inverses, instructions, storage: StoragePool::default() })
    }

    /// Replaces the instruction set of the SIMD lanes. The portable set gives bit-identical results on every processor.
    ///
    /// # Errors
    /// Returns [`MissingInstructions`] if the processor lacks it.
    pub fn with_instructions(self, set: InstructionSet) -> Result<Self, MissingInstructions> {
        Ok(Self { instructions: set.if_available()?, ..self })
    }

    /// Returns the strengths k_i.
    #[must_use]
    pub fn strengths(&self) -> &[f64] {
        &self.strengths
    }

    /// Returns the point m_i = k_i x_i of (so(3)∗)ᴺ for vortices at the given positions.
    ///
    /// # Errors
    /// Returns [`SystemError::Count`] if there are not as many positions as strengths.
    pub fn momentum(
        &self,
        positions: impl IntoIterator<Item = Vector3<f64>>,
    ) -> Result<Covector<Sites<Vector3<f64>>>, SystemError> {
        let positions: Vec<_> = positions.into_iter().collect();
        let (expected, found) = (self.strengths.len(), positions.len());
        if expected != found {
            return Err(SystemError::Count { name: "positions", expected, found });
        }
        Ok(Covector(positions.iter().zip(&self.strengths).map(|(x, k)| x * *k).collect()))
    }

    /// Returns the positions x_i = m_i/k_i of the vortices.
    pub fn positions<T: Real>(
        &self,
        m: &Covector<Sites<Vector3<T>>>,
    ) -> impl Iterator<Item = Vector3<T>> {
        m.0.iter().zip(&self.inverses).map(|(m, inverse)| m.scaled(T::from_f64(*inverse)))
    }

    /// Writes the differential on SIMD lanes and on all threads, if the numbers are `f64`. Returns whether they are.
    fn differential_on_lanes<T: Real>(&self, m: &[Vector3<T>], dh: &mut [Vector3<T>]) -> bool {
        let number = |x: T| x.as_f64().unwrap_or(f64::NAN);
        if T::zero().as_f64().is_none() {
            return false;
        }
        self.storage.with(|sources| {
            let vortex = |(m, inverse): (&Vector3<T>, &f64)| {
                let m = m.map(number);
                (m * *inverse, m * (-0.25 / PI))
            };
            sources.fill(m.iter().zip(&self.inverses).map(vortex));
            let (set, sources) = (self.instructions, &*sources);
            let compute = |first, sums: &mut [_]| {
                let interaction = Interaction { sources, first, sums };
                dispatch(interaction, set, Width::TwoRegisters).is_ok()
            };
            let count = task_size(m.len());
            if m.len() <= count {
                return compute(0, dh);
            }
            let tasks = dh.par_chunks_mut(count).enumerate();
            tasks.map(|(task, sums)| compute(task * count, sums)).reduce(|| true, |a, b| a && b)
        })
    }
}

/// The number of vortices whose pairs with those before them are a task of the energy.
const ROWS: usize = 64;

/// Returns the number of vortices of a task, a multiple of [`BLOCK`] and at least that.
fn task_size(count: usize) -> usize {
    (TASK / count.max(1)).max(1).next_multiple_of(BLOCK)
}

impl<T: Real> SitesHamiltonian<Vector3<T>> for ManyVortices {
    fn value(&self, m: &Covector<Sites<Vector3<T>>>) -> T {
        if m.0.len() != self.strengths.len() {
            return T::from_f64(f64::NAN);
        }
        let (x, count): (Vec<_>, _) = (self.positions(m).collect(), m.0.len());
        // Sums of so many vortices each, on all threads, are added in their order: the number of threads is of no account.
        let starts: Vec<usize> = (0..count).step_by(ROWS).collect();
        let sum =
            |start: &usize| pairs(&self.strengths, |i| x[i], *start..(start + ROWS).min(count));
        let sums: Vec<T> = starts.par_iter().map(sum).collect();
        sums.into_iter().fold(T::zero(), |all, sum| all + sum) / (4.0 * PI)
    }

    /// Writes dh/dm_i: for few vortices by one evaluation for each pair, for many on SIMD lanes and threads.
    fn differential_into(&self, m: &Covector<Sites<Vector3<T>>>, dh: &mut Sites<Vector3<T>>) {
        if [m.0.len(), dh.len()] != [self.strengths.len(); 2] {
            return dh.set_coordinates(|_| T::from_f64(f64::NAN));
        }
        if m.0.len() < MANY || !self.differential_on_lanes(&m.0, dh) {
            dh.set_zero();
            let position = |i: usize| m.0[i].scaled(T::from_f64(self.inverses[i]));
            add_differential(&self.strengths, position, dh);
        }
    }
}

impl<T: Real> VectorField<T> for ManyVortices {
    type Point = Covector<Sites<Vector3<T>>>;

    fn at(&self, m: &Self::Point) -> Self::Point {
        let mut rate = m.zeros_like();
        self.at_into(m, &mut rate);
        rate
    }

    /// Writes the rates dm_i/dt = m_i × dh/dm_i.
    ///
    /// They are NaN if m has another number of vortices, so that a step from it is an error, unless m is empty.
    fn at_into(&self, m: &Self::Point, rate: &mut Self::Point) {
        self.differential_into(m, &mut rate.0);
        for (rate, m) in rate.0.iter_mut().zip(m.0.iter()) {
            *rate = m.cross(rate);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_task_is_empty() {
        for count in [1, 32, 4096, 65_536, 65_537, usize::MAX] {
            let size = task_size(count);
            assert!(size >= BLOCK && size.is_multiple_of(BLOCK), "{count}");
        }
        assert_eq!(task_size(32), 2048);
    }
}
