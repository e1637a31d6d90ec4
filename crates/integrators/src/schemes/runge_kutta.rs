//! Runge–Kutta methods: [`RungeKutta`].

use crate::error::StepError;
use crate::iteration::block_sizes::{BlockSizes, MaskOf};
use crate::iteration::convergence::is_finite;
use crate::iteration::stage_rows::{StageColumns, StageRows};
use crate::iteration::stage_scale::StageScale;
use crate::iteration::stage_solver::{StageSolver, Unconverged, fit, set_combination};
use crate::schemes::ladder::Ladder;
use crate::schemes::refinement::Refinement;
use crate::schemes::scheme::{Equivariant, Increment, Scheme, Step};
use crate::schemes::stage_equations::{Stages, is_plain_and_small};
use crate::stages::branch::solve_on_branch;
use crate::stages::extrapolation::Predictor;
use crate::stages::history::StageHistory;
use crate::stages::newton::{FieldOn, NewtonWorkspace};
use crate::sums::exact_combination::add_exactly;
use crate::sums::halves::scale_evenly;
use crate::tableaux::tableau::Tableau;
use crate::vector_field::VectorField;
use lie_poisson::{Mask, Pair, Real, State};

/// A Runge–Kutta method: a [`Tableau`], and a solver for its stages if it is implicit.
///
/// # Example
/// One step of the two-stage Gauss method (order 4) for the harmonic oscillator conserves the
/// energy, a quadratic invariant:
/// ```
/// use collective_integrators::{RungeKutta, Scheme, from_fn};
/// use nalgebra::Vector2;
/// let gauss = RungeKutta::gauss(2)?;
/// let oscillator = from_fn(|z: &Vector2<f64>| Vector2::new(z.y, -z.x));
/// let step = gauss.step(&oscillator, &Vector2::new(1.0, 0.0), 0.5, &mut gauss.workspace())?;
/// assert!((step.point.norm() - 1.0).abs() < 1e-15);
/// assert!((step.point.x - 0.5_f64.cos()).abs() < 1e-4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct RungeKutta {
    tableau: Tableau,
    solver: StageSolver,
    predictor: Predictor,
    columns: Option<StageColumns>,
    ladder: Option<Ladder>,
}

impl RungeKutta {
    /// Creates the method with the given coefficients. If it is implicit, its stages are solved to the round-off floor.
    #[must_use]
    pub fn new(tableau: Tableau) -> Self {
        let predictor =
            if tableau.is_explicit() { Predictor::none() } else { Predictor::new(tableau.nodes()) };
        let (columns, ladder) = (StageColumns::new(&tableau), Ladder::new(&tableau));
        Self { tableau, solver: StageSolver::default(), predictor, columns, ladder }
    }

    /// Returns the same method with another stage solver.
    #[must_use]
    pub fn with_solver(self, solver: StageSolver) -> Self {
        Self { solver, ..self }
    }

    /// Returns the coefficients of the method.
    #[must_use]
    pub fn tableau(&self) -> &Tableau {
        &self.tableau
    }

    /// Returns whether the method is explicit, and therefore without a predictor.
    #[cfg_attr(optimised, inline(always))]
    fn is_explicit(&self) -> bool {
        self.predictor.stages == 0
    }

    /// Solves for the stage derivatives. Returns the number of iterations, and the lanes in which the fixed-point
    /// iteration converged.
    ///
    /// The iteration starts from a prediction if the workspace has one. Otherwise, or if that fails, it starts from
    /// X(z). If this fails too, Newton's iteration follows. Its results are not suitable for predictions.
    #[cfg_attr(optimised, inline(always))]
    fn solve_stages<T: Real, F: VectorField<T>>(
        &self,
        field: &F,
        z: &F::Point,
        step: f64,
        workspace: &mut StageWorkspace<F::Point>,
    ) -> Result<(usize, T::Mask), StepError> {
        let StageWorkspace { k, small, memory, newton, pool, rows, .. } = workspace;
        for small in &mut *small {
            small.set_zero();
        }
        let mut spare = F::Point::take(pool, z);
        let (tableau, h, scale) = (&self.tableau, T::from_f64(step), StageScale::new(z, step));
        let lanes = self.columns.as_ref().map(|columns| (columns, step, &scale, rows));
        let equations = Stages { tableau, field, z, h, small, pool, lanes };
        let (from, unknowns) = ((z, step, &scale), (k.as_mut_slice(), &mut spare));
        let may_follow = T::HAS_SLOW_PATHS && self.solver.newton;
        // Few steps have such lanes, and the number of unknowns matters only there and where sweeps fail. The memory may be
        // that of a smaller state.
        let cancelling = memory.cancelling();
        let follows = may_follow && cancelling.any() && newton.allows(self.tableau.stages(), z);
        let solved = if follows && cancelling.all() {
            Err(Unconverged::before())
        } else {
            memory.solve(&self.predictor, &self.solver, field, from, unknowns, equations)
        };
        // A lane gives the same bits alone, whatever the sweeps of the others have found.
        let solved = if follows { Unconverged::unless(solved, cancelling) } else { solved };
        let outcome = match solved {
            Err(unconverged) if may_follow && newton.allows(self.tableau.stages(), z) => {
                let unknowns = (&mut spare, k.as_mut_slice());
                self.follow_branch(field, (z, step), &unconverged, unknowns, (memory, newton))
            }
            Ok(iterations) => Ok((iterations, T::Mask::from_bool(true))),
            Err(unconverged) => Err(unconverged.error),
        };
        spare.give(pool);
        outcome
    }

    /// Continues with Newton's iteration where sweeps have not converged. It is rare, and so compiled once for each type of
    /// vectors, and not for each field.
    #[cold]
    #[inline(never)]
    fn follow_branch<V: State>(
        &self,
        field: &FieldOn<'_, V>,
        (z, step): (&V, f64),
        unconverged: &Unconverged<MaskOf<V>>,
        (spare, k): (&mut V, &mut [V]),
        (memory, newton): (&mut StageHistory<V>, &mut NewtonWorkspace<V::Scalar>),
    ) -> Result<(usize, MaskOf<V>), StepError> {
        field.at_into(z, spare);
        // Newton's iteration begins at X(z). If that is not a number, its dense matrix would be computed in vain.
        let begins = is_finite(BlockSizes::of(core::slice::from_ref(&*spare)).largest());
        if !begins.and(unconverged.converged.not()).any() || !step.is_finite() {
            return Err(unconverged.error);
        }
        let (method, unknowns) = ((&self.tableau, &self.solver), (&*spare, k));
        let (outcome, cancelling) =
            solve_on_branch(field, (z, step), method, unconverged, unknowns, newton);
        memory.include_cancelling(cancelling);
        match outcome {
            Ok(iterations) => Ok((iterations, unconverged.converged)),
            // What the sweeps have found says more than that Newton's iteration finds nothing.
            Err(_) if unconverged.astray.any() => Err(unconverged.error),
            Err(error) => Err(error),
        }
    }

    /// Computes the stage derivatives of a step in the workspace. Returns the number of iterations, and the lanes in
    /// which the fixed-point iteration converged.
    #[cfg_attr(optimised, inline(always))]
    fn stages<T: Real, F: VectorField<T>>(
        &self,
        field: &F,
        z: &F::Point,
        step: f64,
        workspace: &mut StageWorkspace<F::Point>,
    ) -> Result<(usize, T::Mask), StepError> {
        // A workspace from another method, or for another size, still gives the right result.
        fit(&mut workspace.k, self.tableau.stages(), z);
        fit(&mut workspace.small, self.tableau.stages(), z);
        if !self.is_explicit() {
            return self.solve_stages(field, z, step, workspace);
        }
        let StageWorkspace { k, pool, .. } = workspace;
        let mut stage = F::Point::take(pool, z);
        for (i, row) in self.tableau.rows().enumerate() {
            set_combination(&mut stage, &row[..i], k);
            stage.scale_in_place(T::from_f64(step));
            stage.add_in_place(z);
            field.at_into(&stage, &mut k[i]);
        }
        stage.give(pool);
        Ok((0, T::Mask::from_bool(true)))
    }

    /// Returns h Σ_i (b_i + low_i) k_i for the stage derivatives in the workspace, and records the end of the step
    /// there.
    #[cfg_attr(optimised, inline(always))]
    fn end<V: State>(&self, z: &V, step: f64, workspace: &mut StageWorkspace<V>) -> V {
        let StageWorkspace { k, memory, pool, .. } = workspace;
        let (mut sum, mut change) = (V::take(pool, z), V::take(pool, z));
        set_combination(&mut sum, self.tableau.weights_low(), k);
        sum.add_combination(self.tableau.weights(), k);
        scale_evenly(&sum, step, &mut change);
        sum.give(pool);
        if !self.is_explicit() {
            memory.end_after(z, &change);
        }
        change
    }
}

/// The storage of a Runge–Kutta step: its stage derivatives, those of earlier steps, and the matrix of Newton's
/// iteration.
///
/// An implicit method predicts its stages from earlier steps. Vectors on the heap are allocated by the first step, and
/// the matrix of Newton's iteration by the first step that needs it.
#[derive(Clone, Debug)]
pub struct StageWorkspace<V: State> {
    k: Vec<V>,
    refinement: Refinement<V>,
    /// The sums Σ_j low_ij k_j with the low parts of the coefficients, once the stages are close; zero without them.
    small: Vec<V>,
    memory: StageHistory<V>,
    rows: StageRows,
    newton: NewtonWorkspace<V::Scalar>,
    pool: V::Pool,
}

impl Equivariant for RungeKutta {}

impl Scheme for RungeKutta {
    type Workspace<V: State> = StageWorkspace<V>;

    fn workspace<V: State>(&self) -> StageWorkspace<V> {
        let room = || Vec::with_capacity(self.tableau.stages());
        let side_by_side = self.columns.is_some() && is_plain_and_small::<V>();
        let coordinates = if side_by_side { size_of::<V>() / size_of::<f64>() } else { 0 };
        StageWorkspace {
            k: room(),
            refinement: Refinement::with_room(self.tableau.stages()),
            small: room(),
            memory: StageHistory::new(&self.predictor),
            rows: StageRows::with_room(coordinates),
            newton: NewtonWorkspace::default(),
            pool: V::Pool::default(),
        }
    }

    #[cfg_attr(optimised, inline(always))]
    fn increment<T: Real, F: VectorField<T>>(
        &self,
        field: &F,
        z: &F::Point,
        step: f64,
        workspace: &mut StageWorkspace<F::Point>,
    ) -> Result<Step<F::Point>, StepError> {
        if let Some(sum) = self.ladder.as_ref().and_then(|ladder| ladder.sum(field, z, step)) {
            let mut change = z.zeros_like();
            scale_evenly(&sum, step, &mut change);
            return Ok(Step { point: change, iterations: 0 });
        }
        let (iterations, _) = self.stages(field, z, step, workspace)?;
        Ok(Step { point: self.end(z, step, workspace), iterations })
    }

    /// Returns the increment of an implicit method without the rounding errors of the stages and of the sums over them.
    ///
    /// This takes four more evaluations of the field for each stage. What remains are the rounding errors of the field,
    /// and of the stages if Newton's iteration solves for them. Explicit methods use the default.
    #[cfg_attr(optimised, inline(always))]
    fn refined_increment<T: Real, F: VectorField<T>>(
        &self,
        field: &F,
        (z, e): (&F::Point, &F::Point),
        step: f64,
        workspace: &mut StageWorkspace<F::Point>,
    ) -> Result<Increment<F::Point>, StepError> {
        let (iterations, contracting) = self.stages(field, z, step, workspace)?;
        if self.is_explicit() {
            let change = self.end(z, step, workspace);
            let mut lost = F::Point::take(&mut workspace.pool, z);
            lost.set_zero();
            return Ok(Step { point: Pair(change, lost), iterations });
        }
        let StageWorkspace { k, refinement, memory, pool, .. } = workspace;
        let tableau = &self.tableau;
        refinement.refine(field, ((z, e), step), tableau, contracting, k, pool);
        let (mut change, mut lost) = (F::Point::take(pool, z), F::Point::take(pool, z));
        set_combination(&mut lost, tableau.weights(), refinement.corrections());
        lost.scale_in_place(T::from_f64(step));
        change.set_zero();
        let weights = (step, tableau.weights(), tableau.weights_low());
        add_exactly((&mut change, &mut lost), weights, k, pool);
        memory.end_after(z, &change);
        Ok(Step { point: Pair(change, lost), iterations })
    }

    #[cfg_attr(optimised, inline(always))]
    fn temporaries<'a, V: State>(
        &self,
        workspace: &'a mut StageWorkspace<V>,
    ) -> Option<&'a mut V::Pool> {
        Some(&mut workspace.pool)
    }

    #[cfg_attr(optimised, inline(always))]
    fn forget<V: State>(&self, workspace: &mut StageWorkspace<V>) {
        workspace.memory.forget();
    }

    fn order(&self) -> usize {
        self.tableau.order()
    }

    fn is_symplectic(&self) -> bool {
        self.tableau.is_symplectic()
    }

    fn is_symmetric(&self) -> bool {
        self.tableau.is_symmetric()
    }

    /// Returns whether the condition of [`Tableau::is_symplectic`] holds.
    fn preserves_quadratic_invariants(&self) -> bool {
        self.tableau.is_symplectic()
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::vector_field::from_fn;
    use lie_poisson::Sites;
    use nalgebra::{Vector1, Vector2};

    /// The memory of a small state in which terms cancel is of no use for a state with too many unknowns for Newton's
    /// iteration.
    #[test]
    fn a_workspace_serves_a_state_that_is_too_large_for_newtons_iteration() {
        let field = from_fn(|z: &Sites<Vector1<f64>>| {
            z.iter().map(|x| -x).collect::<Sites<Vector1<f64>>>()
        });
        let state = |sites| Sites::new(vec![Vector1::new(1.0); sites]);
        let midpoint = RungeKutta::implicit_midpoint();
        let mut used = midpoint.workspace();
        let _ = midpoint.step(&field, &state(2), 0.1, &mut used).unwrap();
        used.memory.include_cancelling(true);
        let again = midpoint.step(&field, &state(2000), 0.1, &mut used).unwrap();
        let fresh = midpoint.step(&field, &state(2000), 0.1, &mut midpoint.workspace()).unwrap();
        assert_eq!(again.point, fresh.point);
    }

    /// The low parts of the coefficients, which are below the round-off of a step, enter once the stages are close: the
    /// sums with them are those of the solution, to half of its digits.
    #[test]
    fn low_parts_of_the_coefficients_enter_the_stages() {
        let pendulum = from_fn(|z: &Vector2<f64>| Vector2::new(z.y, -z.x.sin()));
        let z = Vector2::new(1.0, 0.4);
        for stages in [2, 3, 5] {
            let gauss = RungeKutta::gauss(stages).unwrap();
            let mut space = gauss.workspace::<Vector2<f64>>();
            gauss.stages(&pendulum, &z, 0.5, &mut space).unwrap();
            for (i, small) in space.small.iter().enumerate() {
                let terms = gauss.tableau.row_low(i).iter().zip(&space.k);
                let (sum, size) = terms.fold((Vector2::zeros(), 0.0), |(sum, size), (low, k)| {
                    (sum + k * *low, size + low.abs() * k.amax())
                });
                // The change below which k is close is √ε of the largest; the error is a multiple of it.
                let near = 64.0 * f64::EPSILON.sqrt() * size;
                assert!((small - sum).amax() <= near, "{stages}, {i}: {small:?} {sum:?}");
                assert!(small.amax() > near, "{stages}, {i}");
            }
        }
        // Control: coefficients that are exact have no low parts.
        let midpoint = RungeKutta::implicit_midpoint();
        let mut space = midpoint.workspace::<Vector2<f64>>();
        midpoint.stages(&pendulum, &z, 0.5, &mut space).unwrap();
        assert_eq!(space.small, [Vector2::zeros()]);
    }
}
