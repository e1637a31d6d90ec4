//! Integrators over SIMD lanes as batch integrators: [`Laned`].

use crate::batch::group_engine::{Group, advance_groups};
use crate::batch::lane_kernel::LaneResults;
use crate::batch::single_member::advance_alone;
use crate::{BatchIntegrator, IntegrationError, Integrator};
use core::marker::PhantomData;
use core::ops::Range;
use lie_poisson::{DefaultLanes, Lanes, Vector};

/// An integrator that advances as many states side by side as the scalar `T` has SIMD lanes: several trajectories in
/// one register.
///
/// Every integrator whose formulas are written over all scalars is suitable. Each member has the bits of its
/// [trajectory](Integrator::trajectory_from) over `f64`, for all lanes and all neighbours: operations on lanes round as
/// those of `f64` do, and iterations stop in each lane by itself. An integrator with other formulas over `f64`, such as
/// a fused kernel, differs from its lanes by rounding. The neighbours do not matter then either.
///
/// The steps are made in blocks that end at the multiples of [`CHECKPOINT`](crate::CHECKPOINT). If a step of some lane
/// fails, the block is repeated from its start, with one member at a time in all lanes. A member that fails there too
/// takes no further step; the others continue together.
///
/// # Example
/// Six harmonic oscillators, of which the fifth starts at NaN:
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
    /// Creates a batch integrator on the lanes that every processor has.
    pub fn new(integrator: I) -> Self {
        Self::with_lanes(integrator)
    }
}

impl<I, T> Laned<I, T> {
    /// Creates a batch integrator on the lanes of the scalar `T`.
    ///
    /// The scalar `f64` advances the members one by one. Lanes of other widths come from
    /// [`dispatch`](lie_poisson::dispatch), whose [`LaneTask`](lie_poisson::LaneTask) states what fast code requires.
    pub fn with_lanes(integrator: I) -> Self {
        Self { integrator, lanes: PhantomData }
    }

    /// Returns the integrator for one member.
    pub fn integrator(&self) -> &I {
        &self.integrator
    }
}

impl<I, T> BatchIntegrator for Laned<I, T>
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
struct IntegratorGroup<'a, I: Integrator<T>, T: Lanes> {
    integrator: &'a I,
    workspace: &'a mut I::Workspace,
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
