//! Any integrator over lanes as one that advances many states: [`Laned`].

use crate::{BatchIntegrator, CHECKPOINT, IntegrationError, Integrator, StepError};
use core::marker::PhantomData;
use core::ops::Range;
use lie_poisson::{DefaultLanes, Lanes, Vector};

/// An integrator that advances as many states side by side as the scalar `T` has lanes.
///
/// Every integrator whose formulas are written over all scalars will do. Each member comes out with
/// the bits of its [trajectory](Integrator::trajectory_from) over `f64`, whatever the lanes and the
/// neighbours: operations on lanes round as those of `f64` do, iterations stop in each lane by
/// itself. (An integrator that computes otherwise over `f64`, by a fused kernel say, differs from its
/// lanes by rounding; the neighbours do not matter then either.)
///
/// Steps come in blocks that end at the multiples of [`CHECKPOINT`]. A block in which a step of some
/// lane fails is made again from its start, with one member at a time in all lanes; a member that
/// fails there too is given up, and a neighbour fills its lane.
///
/// # Example
/// Six harmonic oscillators; the last but one starts at no number:
/// ```
/// use collective_integrators::{BatchIntegrator, Direct, Laned, RungeKutta, VectorField};
/// use lie_poisson::Real;
/// use nalgebra::Vector2;
///
/// struct Oscillator;
/// impl<T: Real> VectorField<T> for Oscillator {
///     type Point = Vector2<T>;
///     fn at(&self, z: &Vector2<T>) -> Vector2<T> {
///         Vector2::new(z.y, -z.x)
///     }
/// }
/// let gauss = Laned::new(Direct::new(RungeKutta::gauss(4)?, Oscillator));
/// let mut members = [1.0, 2.0, 3.0, 4.0, f64::NAN, 6.0].map(|x| Vector2::new(x, 0.0));
/// let mut failures = Vec::new();
/// let mut report = |index, error| failures.push((index, error));
/// gauss.advance(&mut members, 0.1, 0..100, &mut gauss.workspace(), &mut report);
/// assert!((members[5].x - 6.0 * 10.0_f64.cos()).abs() < 1e-11);
/// assert!(failures.len() == 1 && failures[0].0 == 4 && failures[0].1.step == 1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Laned<I, T = DefaultLanes> {
    integrator: I,
    lanes: PhantomData<fn() -> T>,
}

impl<I> Laned<I> {
    /// The integrator on the lanes that every processor has.
    pub fn new(integrator: I) -> Self {
        Self::with_lanes(integrator)
    }
}

impl<I, T> Laned<I, T> {
    /// The integrator on other lanes: on `f64`, one by one; on those of
    /// [`dispatch`](lie_poisson::dispatch), whose [`LaneTask`](lie_poisson::LaneTask) says what they
    /// ask of code that is to be fast.
    pub fn with_lanes(integrator: I) -> Self {
        Self { integrator, lanes: PhantomData }
    }

    /// The integrator.
    pub fn integrator(&self) -> &I {
        &self.integrator
    }
}

/// The storage of [`Laned`]: that of a step over lanes, and which lanes hold a member that can go
/// on.
#[derive(Debug)]
pub struct LanedSpace<S> {
    storage: S,
    alive: Vec<bool>,
}

impl<I, T> BatchIntegrator for Laned<I, T>
where
    I: Integrator<f64> + Integrator<T> + Sync,
    T: Lanes,
{
    type Member = <I as Integrator<f64>>::State;
    type Workspace = LanedSpace<<I as Integrator<T>>::Workspace>;

    fn workspace(&self) -> Self::Workspace {
        LanedSpace {
            storage: Integrator::<T>::workspace(&self.integrator),
            alive: vec![false; T::COUNT],
        }
    }

    fn advance(
        &self,
        members: &mut [Self::Member],
        step: f64,
        steps: Range<u64>,
        space: &mut Self::Workspace,
        failed: &mut dyn FnMut(usize, IntegrationError),
    ) {
        for (n, group) in members.chunks_mut(T::COUNT).enumerate() {
            space.alive.fill(true);
            for block in blocks(steps.clone()) {
                if !self.advance_lanes(group, step, block.clone(), space) {
                    let mut report = |lane, error| failed(n * T::COUNT + lane, error);
                    self.advance_one_by_one(group, step, block, space, &mut report);
                }
            }
        }
    }
}

impl<I, T> Laned<I, T>
where
    I: Integrator<f64> + Integrator<T>,
    T: Lanes,
{
    /// One block of steps over lanes. If a step fails, nothing has happened, and it returns false.
    fn advance_lanes(
        &self,
        group: &mut [<I as Integrator<f64>>::State],
        step: f64,
        block: Range<u64>,
        space: &mut LanedSpace<<I as Integrator<T>>::Workspace>,
    ) -> bool {
        let Some(healthy) = group.iter().zip(&space.alive).position(|(_, &alive)| alive) else {
            return true;
        };
        let member = |lane: usize| match (group.get(lane), space.alive.get(lane)) {
            (Some(member), Some(true)) => member,
            _ => &group[healthy],
        };
        let mut state = <I as Integrator<T>>::State::from_coordinates(|i| {
            T::from_lanes(|lane| member(lane).coordinate(i))
        });
        if self.steps(&mut state, step, block, &mut space.storage).is_err() {
            return false;
        }
        for (lane, member) in group.iter_mut().enumerate() {
            if space.alive.get(lane) == Some(&true) {
                *member = Vector::from_coordinates(|i| state.coordinate(i).lane(lane));
            }
        }
        true
    }

    /// The same with one member at a time, in all lanes. What fails is reported, by its lane, and
    /// given up.
    fn advance_one_by_one(
        &self,
        group: &mut [<I as Integrator<f64>>::State],
        step: f64,
        block: Range<u64>,
        space: &mut LanedSpace<<I as Integrator<T>>::Workspace>,
        report: &mut dyn FnMut(usize, IntegrationError),
    ) {
        let lanes = group.iter_mut().zip(&mut space.alive).enumerate();
        for (lane, (member, alive)) in lanes.filter(|(_, (_, alive))| **alive) {
            let mut state = <I as Integrator<T>>::State::from_coordinates(|i| {
                T::from_f64(member.coordinate(i))
            });
            if let Err(error) = self.steps(&mut state, step, block.clone(), &mut space.storage) {
                *alive = false;
                report(lane, error);
            }
            *member = Vector::from_coordinates(|i| state.coordinate(i).lane(0));
        }
    }

    /// Steps that know nothing of those before the first of them. Where one fails, the state is that
    /// before it.
    fn steps(
        &self,
        state: &mut <I as Integrator<T>>::State,
        step: f64,
        block: Range<u64>,
        storage: &mut <I as Integrator<T>>::Workspace,
    ) -> Result<(), IntegrationError> {
        StepError::check_start(state, step)
            .map_err(|refused| IntegrationError::after(block.start, step, refused))?;
        Integrator::<T>::forget(&self.integrator, storage);
        for made in block {
            let next = Integrator::<T>::step(&self.integrator, state, step, storage);
            *state = next.map_err(|source| IntegrationError::after(made, step, source))?.point;
        }
        Ok(())
    }
}

/// The steps, divided at the multiples of [`CHECKPOINT`].
fn blocks(steps: Range<u64>) -> impl Iterator<Item = Range<u64>> {
    let mut next = steps.start;
    core::iter::from_fn(move || {
        let start = next;
        next = (start / CHECKPOINT + 1).saturating_mul(CHECKPOINT).min(steps.end);
        (start < steps.end).then_some(start..next)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_end_at_checkpoints() {
        let (c, all) = (CHECKPOINT, |steps| blocks(steps).collect::<Vec<_>>());
        assert_eq!(all(0..2 * c), [0..c, c..2 * c]);
        assert_eq!(all(5..c + 1), [5..c, c..c + 1]);
        assert!(all(u64::MAX - 1..u64::MAX).len() == 1 && all(3..9).len() == 1);
        assert!(all(7..7).is_empty());
    }
}
