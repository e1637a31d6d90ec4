//! Batch integrators over the SIMD lanes of a given type: [`LanedOver`].

use crate::batch::group_engine::{Group, advance_groups};
use crate::batch::lane_kernel::LaneResults;
use crate::{BatchIntegrator, IntegrationError, Integrator};
use core::marker::PhantomData;
use core::ops::Range;
use lie_poisson::{Lanes, Vector};

/// An integrator that advances as many states side by side as the scalar `T` has SIMD lanes: several trajectories in
/// one register.
///
/// [`Laned`](crate::Laned) chooses the lanes itself. Use this type for comparisons with other lanes: `f64` advances the
/// members one by one, and [`dispatch`](lie_poisson::dispatch) passes lanes of other widths to a
/// [`LaneTask`](lie_poisson::LaneTask).
///
/// The steps are made in blocks that end at the multiples of [`CHECKPOINT`](crate::CHECKPOINT). If a step of some lane
/// fails, the block is repeated from its start, with one member at a time in all lanes. A member that fails there too
/// takes no further step; the others continue together.
///
/// # Example
/// A harmonic oscillator is advanced in one of the four lanes that every processor has. Its end is bit-identical to the
/// end over `f64`:
/// ```
/// use collective_integrators::{BatchIntegrator, Direct, LanedOver, RungeKutta, VectorField};
/// use lie_poisson::{DefaultLanes, Real};
/// use nalgebra::Vector2;
///
/// #[derive(Clone)]
/// struct Oscillator;
/// impl<T: Real> VectorField<T> for Oscillator {
///     type Point = Vector2<T>;
///     fn at(&self, z: &Vector2<T>) -> Vector2<T> {
///         Vector2::new(z.y, -z.x)
///     }
/// }
/// let gauss = Direct::new(RungeKutta::gauss(4)?, Oscillator);
/// let ends = [1.0, 2.0, 3.0].map(|x| Vector2::new(x, 0.0));
/// let (mut in_lanes, mut one_by_one) = (ends, ends);
/// let lanes = LanedOver::<_, DefaultLanes>::new(gauss.clone());
/// lanes.advance(&mut in_lanes, 0.1, 0..100, &mut lanes.workspace(), &mut |_, _| {});
/// let single = LanedOver::<_, f64>::new(gauss);
/// single.advance(&mut one_by_one, 0.1, 0..100, &mut single.workspace(), &mut |_, _| {});
/// assert_eq!(in_lanes, one_by_one);
/// assert!((in_lanes[2].x - 3.0 * 10.0_f64.cos()).abs() < 1e-11);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct LanedOver<I, T> {
    integrator: I,
    lanes: PhantomData<fn() -> T>,
}

impl<I, T> LanedOver<I, T> {
    /// Creates a batch integrator on the lanes of the scalar `T`.
    pub fn new(integrator: I) -> Self {
        Self { integrator, lanes: PhantomData }
    }

    /// Returns the integrator for one member.
    pub fn integrator(&self) -> &I {
        &self.integrator
    }
}

impl<I, T> BatchIntegrator for LanedOver<I, T>
where
    I: Integrator<f64, State: Vector> + Integrator<T, State: Vector> + Sync,
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

/// An integrator over lanes, as a group of members.
pub(crate) struct IntegratorGroup<'a, I: Integrator<T>, T: Lanes> {
    pub(crate) integrator: &'a I,
    pub(crate) workspace: &'a mut I::Workspace,
}

impl<I: Integrator<T>, T: Lanes> IntegratorGroup<'_, I, T> {
    /// Makes the steps of a state over lanes, without a memory of earlier steps.
    fn steps(
        &mut self,
        state: &mut I::State,
        step: f64,
        steps: Range<u64>,
    ) -> Result<(), IntegrationError> {
        self.integrator.forget(self.workspace);
        self.integrator.advance(state, step, steps, self.workspace).map(drop)
    }
}

impl<I, T> Group for IntegratorGroup<'_, I, T>
where
    I: Integrator<f64, State: Vector> + Integrator<T, State: Vector>,
    T: Lanes,
{
    type Member = <I as Integrator<f64>>::State;

    fn width(&self) -> usize {
        T::COUNT
    }

    /// Advances all members together. Either all have a result, or none is known to have one.
    fn together(&mut self, group: &mut [Self::Member], step: f64, count: u64) -> LaneResults {
        let mut results = LaneResults::default();
        let Some(last) = group.len().checked_sub(1) else { return results };
        let mut state = <I as Integrator<T>>::State::from_coordinates(|i| {
            T::from_lanes(|lane| group[lane.min(last)].coordinate(i))
        });
        if self.steps(&mut state, step, 0..count).is_ok() {
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
        let end = self.steps(&mut state, step, steps);
        *member = Vector::from_coordinates(|i| state.coordinate(i).lane(0));
        end
    }
}
