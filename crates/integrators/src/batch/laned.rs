//! Any integrator over lanes as one that advances many states: [`Laned`].

use crate::batch::alone::advance_alone;
use crate::batch::groups::{Group, advance_groups};
use crate::batch::lane_kernel::LaneResults;
use crate::{BatchIntegrator, IntegrationError, Integrator};
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
/// Steps come in blocks that end at the multiples of [`CHECKPOINT`](crate::CHECKPOINT). A block in which a step of
/// some lane fails is made again from its start, with one member at a time in all lanes. A member that fails there
/// too is given up; the others continue together.
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

impl<I, T> BatchIntegrator for Laned<I, T>
where
    I: Integrator<f64> + Integrator<T> + Sync,
    T: Lanes,
{
    type Member = <I as Integrator<f64>>::State;
    type Workspace = <I as Integrator<T>>::Workspace;

    fn workspace(&self) -> Self::Workspace {
        Integrator::<T>::workspace(&self.integrator)
    }

    fn advance(
        &self,
        members: &mut [Self::Member],
        step: f64,
        steps: Range<u64>,
        workspace: &mut Self::Workspace,
        failed: &mut dyn FnMut(usize, IntegrationError),
    ) {
        let mut group = IntegratorGroup::<I, T> { integrator: &self.integrator, workspace };
        advance_groups(&mut group, members, step, steps, failed);
    }
}

/// The steps of an integrator over lanes.
struct IntegratorGroup<'a, I: Integrator<T>, T: Lanes> {
    integrator: &'a I,
    workspace: &'a mut I::Workspace,
}

impl<I, T> Group for IntegratorGroup<'_, I, T>
where
    I: Integrator<f64> + Integrator<T>,
    T: Lanes,
{
    type Member = <I as Integrator<f64>>::State;

    fn width(&self) -> usize {
        T::COUNT
    }

    /// All have a result, or none is known to have one.
    fn together(&mut self, group: &mut [Self::Member], step: f64, count: u64) -> LaneResults {
        let mut results = LaneResults::default();
        let Some(last) = group.len().checked_sub(1) else { return results };
        let mut state = <I as Integrator<T>>::State::from_coordinates(|i| {
            T::from_lanes(|lane| group[lane.min(last)].coordinate(i))
        });
        let steps = 0..count;
        if advance_alone::<T, I>(self.integrator, &mut state, step, steps, self.workspace).is_ok() {
            for (lane, member) in group.iter_mut().enumerate() {
                *member = Vector::from_coordinates(|i| state.coordinate(i).lane(lane));
                results[lane] = true;
            }
        }
        results
    }

    fn alone(
        &mut self,
        member: &mut Self::Member,
        step: f64,
        steps: Range<u64>,
    ) -> Result<(), IntegrationError> {
        let mut state =
            <I as Integrator<T>>::State::from_coordinates(|i| T::from_f64(member.coordinate(i)));
        let end = advance_alone::<T, I>(self.integrator, &mut state, step, steps, self.workspace);
        *member = Vector::from_coordinates(|i| state.coordinate(i).lane(0));
        end
    }
}
