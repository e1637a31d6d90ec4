//! Vector fields that are known over SIMD lanes: [`LaneField`].

use crate::iteration::lane_problem::{LaneProblem, Outcome};
use crate::stage_frame::StageFrame;
use crate::vector_field::VectorField;
use lie_poisson::{
    InstructionSet, Lanes, State, StorageOver, TaskOver, UnfusedTask, UnfusedWorkspace,
    dispatch_unfused,
};

/// A vector field that is known over `f64` and over the SIMD lanes of every processor.
///
/// Every such field has this trait.
#[diagnostic::on_unimplemented(
    message = "the vector field `{Self}` is not known over SIMD lanes",
    note = "a closure serves `f64` alone: implement `VectorField<T>` or `Hamiltonian<_, T>` for every `T: Real`"
)]
pub trait LaneField: VectorField<f64> {
    /// Solves stage equations with one stage in each lane of a register. Returns `None` if the processor lacks the
    /// instructions, or if nothing modest is predicted.
    fn solve_over_lanes(
        &self,
        instructions: InstructionSet,
        problem: &mut LaneProblem<'_, Self::Point>,
    ) -> Option<Outcome<Self::Point>>;
}

impl<F, V> LaneField for F
where
    F: VectorField<f64, Point = V>,
    V: State<Scalar = f64>,
    for<'a, 'b> Attempt<'a, 'b, F, V, 4>: UnfusedTask<NoStorage>,
    for<'a, 'b> Attempt<'a, 'b, F, V, 8>: UnfusedTask<NoStorage>,
{
    #[cfg_attr(optimised, inline(always))]
    fn solve_over_lanes(
        &self,
        instructions: InstructionSet,
        problem: &mut LaneProblem<'_, V>,
    ) -> Option<Outcome<V>> {
        let few = problem.columns.stages <= 4;
        // Four stages fit a register of AVX2, which is faster than a wider one that is half empty.
        let set = match instructions {
            InstructionSet::Avx512 if few => InstructionSet::Avx2,
            set => set,
        };
        let mut space = UnfusedWorkspace::new(&NoStorage, set).ok()?;
        let (field, mut result) = (self, None);
        let outcome = &mut result;
        if few {
            dispatch_unfused(Attempt::<_, _, 4> { field, problem, outcome }, &mut space);
        } else {
            dispatch_unfused(Attempt::<_, _, 8> { field, problem, outcome }, &mut space);
        }
        result
    }
}

/// The storage that an [`Attempt`] keeps: none.
#[derive(Debug)]
pub struct NoStorage;

impl<T: Lanes> StorageOver<T> for NoStorage {
    type Storage = ();

    fn storage(&self) {}
}

/// The task to solve stage equations with room for S stages.
#[derive(Debug)]
pub struct Attempt<'a, 'b, F, V: State, const S: usize> {
    field: &'a F,
    problem: &'a mut LaneProblem<'b, V>,
    outcome: &'a mut Option<Outcome<V>>,
}

impl<F, V, T, const S: usize> TaskOver<T, NoStorage> for Attempt<'_, '_, F, V, S>
where
    F: VectorField<f64, Point = V> + VectorField<T, Point: State<Shape = V::Shape>>,
    V: State<Scalar = f64>,
    T: Lanes,
{
    #[cfg_attr(optimised, inline(always))]
    fn run(self, (): &mut ()) {
        // Nothing is compiled for registers that so few stages do not fill: others are chosen for them.
        if S < T::COUNT {
            return;
        }
        let Self { field, problem, outcome } = self;
        let blank = <<F as VectorField<T>>::Point>::zeros_of(&problem.z.shape());
        *outcome = problem.solve::<T, _, S>(
            blank,
            #[cfg_attr(optimised, inline(always))]
            |z, value| match size_of::<<V as State>::Pool>() {
                // A small value stays in registers.
                0 => *value = VectorField::<T>::at(field, z),
                _ => VectorField::<T>::at_into(field, z, value),
            },
        );
    }
}

/// A vector field over `f64` whose stages are computed side by side in SIMD lanes.
#[derive(Debug)]
pub(crate) struct InLanes<'a, F, L> {
    pub(crate) field: &'a F,
    /// The field `field` as it is known over SIMD lanes.
    pub(crate) lanes: &'a L,
    pub(crate) instructions: InstructionSet,
}

impl<F, L> VectorField<f64> for InLanes<'_, F, L>
where
    F: VectorField<f64, Point = L::Point>,
    L: LaneField,
{
    type Point = F::Point;

    #[cfg_attr(optimised, inline(always))]
    fn at(&self, z: &F::Point) -> F::Point {
        self.field.at(z)
    }

    fn derivative(&self, z: &F::Point, v: &F::Point) -> Option<F::Point> {
        self.field.derivative(z, v)
    }

    #[cfg_attr(optimised, inline(always))]
    fn stage_frame(&self) -> impl StageFrame<F::Point> {
        self.field.stage_frame()
    }

    #[cfg_attr(optimised, inline(always))]
    fn solve_in_lanes(&self, problem: &mut LaneProblem<'_, F::Point>) -> Option<Outcome<F::Point>> {
        self.lanes.solve_over_lanes(self.instructions, problem)
    }
}
