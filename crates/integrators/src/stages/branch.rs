//! The solution of stage equations to which short steps lead: [`Branch`].

use crate::error::StepError;
use crate::iteration::block_sizes::{BlockSizes, MaskOf};
use crate::iteration::convergence::unknown;
use crate::iteration::lane_problem::Outcome;
use crate::iteration::stage_scale::{Scale, StageScale, SweepChange, TermScale};
use crate::iteration::stage_solver::{
    NEWTON_ITERATIONS, StageSolver, Unconverged, fill_unless, set_combination, sweep,
};
use crate::stages::flat_state::{FlatField, FlatState, ValueField};
use crate::stages::newton::{FieldOn, NewtonWorkspace, newton_step, without_derivatives};
use crate::stages::terms::{cancels, terms};
use crate::tableaux::tableau::Tableau;
use lie_poisson::{Mask, Real, State};

/// The multiple of the first change of Newton's iteration to which its changes add up where it contracts at once.
const AT_ONCE: f64 = 2.0;

/// The greatest relative distance from a guess to a solution that is near.
const NEAR: f64 = 0.5;

/// The relative distance within which two solutions are the same: half of the digits.
const SAME: f64 = 1.0 / (1 << 26) as f64;

/// The first part of a step to which the solution for no step is followed, and the least length of a part.
const FIRST_PART: f64 = 0.25;
const LEAST_PART: f64 = 1.0 / 1024.0;

/// The number of iterations for a part, whose guess is near.
const FEW_ITERATIONS: usize = 6;

/// The least and the greatest factor by which the length of a part changes.
const FACTORS: [f64; 2] = [0.25, 2.0];

/// The number of shorter steps after which the solution is not followed further.
const MOST_PARTS: usize = 32;

/// The sizes of the blocks of coordinates.
type Sizes<T> = BlockSizes<FlatState<T>>;

/// The stage equations k_i = X(z + τh Σ_j a_ij k_j) for 0 ≤ τ ≤ 1.
///
/// For τ = 0 the only solution is k_i = X(z). The solution of the step is the end, at τ = 1, of the curve of solutions that
/// begins there. Other solutions do not tend to X(z) for short steps. The states to which they lead are wrong, however
/// exactly they solve the equations.
///
/// The points are coordinates without a type, so that this is compiled once for each scalar.
struct Branch<'a, T: Real> {
    field: &'a FieldOn<'a, FlatState<T>>,
    z: &'a FlatState<T>,
    step: f64,
    tableau: &'a Tableau,
    solver: &'a StageSolver,
}

/// Solves the stage equations of a step of the given size from z, from k_i = `rate`, which is X(z), in the lanes in which
/// the sweeps have not converged. Returns the number of all iterations, and the lanes in which blocks are round-off of
/// larger terms, so that sweeps converge by the sizes of these terms alone. The others need Newton's iteration.
///
/// # Errors
/// Returns the errors of [`solve_by_newton`](Branch::solve_by_newton).
#[cold]
#[inline(never)]
pub(crate) fn solve_on_branch<V: State>(
    field: &FieldOn<'_, V>,
    (z, step): (&V, f64),
    (tableau, solver): (&Tableau, &StageSolver),
    sweeps: &Unconverged<MaskOf<V>>,
    (rate, k): (&V, &mut [V]),
    space: &mut NewtonWorkspace<V::Scalar>,
) -> (Result<usize, StepError>, MaskOf<V>) {
    let (field, start) = (FlatField { field, space: z.shape() }, FlatState::of(z));
    let branch = Branch { field: &field, z: &start, step, tableau, solver };
    let mut flat: Vec<_> = k.iter().map(|k| start.with(k)).collect();
    let solved = branch.solve(sweeps, &start.with(rate), &mut flat, space);
    for (k, flat) in k.iter_mut().zip(&flat) {
        flat.write_to(k);
    }
    solved
}

impl<T: Real> Branch<'_, T> {
    /// Solves the equations as [`solve_on_branch`] does.
    #[inline(never)]
    fn solve(
        &self,
        sweeps: &Unconverged<T::Mask>,
        rate: &FlatState<T>,
        k: &mut [FlatState<T>],
        space: &mut NewtonWorkspace<T>,
    ) -> (Result<usize, StepError>, T::Mask) {
        let terms = terms(self.field, (self.z, self.step), rate);
        let (mut done, mut made) = (sweeps.converged, sweeps.iterations);
        let cancels = cancels(&terms, (self.z, self.step), rate).and(done.not());
        let terms = &terms.of_step;
        let mut found = cancels;
        if cancels.any() {
            fill_unless(cancels.not(), k, rate);
            made += match self.sweep(cancels.not(), terms, k) {
                Ok(iterations) => iterations,
                Err(failed) => {
                    found = failed.converged.and(cancels);
                    failed.iterations
                }
            };
            done = done.or(found);
            if done.all() {
                return (Ok(made), found);
            }
        }
        let solved = if T::from_f64(0.0).without_derivative().is_some() {
            self.solve_values_first((done, made), terms, rate, k, space)
        } else {
            self.solve_by_newton((done, made), terms, rate, k, space)
        };
        (solved, found)
    }

    /// Solves the equations of the step for the values of dual numbers, by sweeps or else by Newton's iteration as if there
    /// were no derivatives, and then for the derivatives. Returns the number of iterations as
    /// [`solve_by_newton`](Self::solve_by_newton) does.
    ///
    /// The equations of the derivatives k′ are linear, k′ = DX(y) (z′ + h A k′) + X′(y) at the stages y of the values: they have
    /// one solution, which an iteration of Newton's finds whatever the size of k′. From values that are not yet those of the
    /// stages it would find derivatives that say nothing.
    ///
    /// # Errors
    /// Returns those of the values, or that the equations of the derivatives are singular.
    fn solve_values_first(
        &self,
        (done, made): (T::Mask, usize),
        terms: &Sizes<T>,
        rate: &FlatState<T>,
        k: &mut [FlatState<T>],
        space: &mut NewtonWorkspace<T>,
    ) -> Result<usize, StepError> {
        let (z, rate) = (without_derivatives(self.z), without_derivatives(rate));
        let values = Branch { field: &ValueField(self.field), z: &z, ..*self };
        let mut found = k.to_vec();
        fill_unless(done, &mut found, &rate);
        let made = match values.sweep(done, &Sizes::zero(), &mut found) {
            Ok(iterations) => made + iterations,
            Err(failed) => {
                let begun = (done.or(failed.converged), made + failed.iterations);
                let terms = self::terms(values.field, (&z, self.step), &rate).of_step;
                values.solve_by_newton(begun, &terms, &rate, &mut found, space)?
            }
        };
        for (k, found) in k.iter_mut().zip(&found) {
            k.replace_where(done.not(), found);
        }
        let (outcome, _) = self.newton(1.0, NEWTON_ITERATIONS, done, terms, k, space);
        outcome.map(|iterations| made + iterations).map_err(|unconverged| unconverged.error)
    }

    /// Sweeps from the guess in `k`, in the lanes that are not `done`. Changes are compared with the terms.
    fn sweep(
        &self,
        done: T::Mask,
        terms: &Sizes<T>,
        k: &mut [FlatState<T>],
    ) -> Outcome<FlatState<T>> {
        let scale = TermScale { scale: &StageScale::new(self.z, self.step), terms };
        let (mut point, mut spare) = (self.z.zeros_like(), self.z.zeros_like());
        let lanes = (done, T::Mask::from_bool(true));
        let sweeps = self.solver.max_iterations;
        self.solver.iterate(sweeps, lanes, &scale, &mut unknown(), |done, _| {
            sweep(done, k, &mut spare, |i, k, value| {
                set_combination(&mut point, self.tableau.row_low(i), k);
                point.add_combination(self.tableau.row(i), k);
                point.scale_in_place(T::from_f64(self.step));
                point.add_in_place(self.z);
                self.field.at_into(&point, value);
            })
        })
    }

    /// Solves the equations of the step by Newton's iteration from k_i = `rate`, in the lanes that are not `done`. Returns
    /// the number of its iterations and of those that were `made` before.
    ///
    /// If the iteration does not contract at once, and goes far, its solution is compared with that to which short steps
    /// lead, relative to the terms whose sums are the stage derivatives. It is not replaced by that, whose last bits depend
    /// on the other lanes.
    ///
    /// # Errors
    /// Returns the error of the iteration, or [`StepError::OtherSolution`] if short steps are not seen to lead to its
    /// solution.
    fn solve_by_newton(
        &self,
        (done, made): (T::Mask, usize),
        terms: &Sizes<T>,
        rate: &FlatState<T>,
        k: &mut [FlatState<T>],
        space: &mut NewtonWorkspace<T>,
    ) -> Result<usize, StepError> {
        fill_unless(done, k, rate);
        let (outcome, [first, path]) = self.newton(1.0, NEWTON_ITERATIONS, done, terms, k, space);
        let iterations = made
            + match outcome {
                Ok(iterations) => iterations,
                Err(far) if far.converged.or(far.astray).all() => far.iterations,
                Err(unconverged) => return Err(unconverged.error),
            };
        let near = path.at_most(T::from_f64(NEAR));
        let done = path.at_most(first * AT_ONCE).or(near).or(done);
        if done.all() {
            return Ok(iterations);
        }
        match self.follow(done, terms, rate, space) {
            Some(followed) if self.equal(terms, k, &followed).or(done).all() => Ok(iterations),
            _ => {
                let distance = T::select(done, T::from_f64(0.0), path).max_abs();
                Err(StepError::OtherSolution { distance })
            }
        }
    }

    /// Makes at most so many of Newton's iterations for the part τ of the step from the guess in `k`. Returns the outcome,
    /// the first change and the sum of the changes, relative to the size of the stages.
    fn newton(
        &self,
        part: f64,
        most: usize,
        done: T::Mask,
        terms: &Sizes<T>,
        k: &mut [FlatState<T>],
        space: &mut NewtonWorkspace<T>,
    ) -> (Outcome<FlatState<T>>, [T; 2]) {
        let (z, step) = (self.z, self.step * part);
        let scale = StageScale::new(z, step);
        let (mut first, mut path) = (None, T::from_f64(0.0));
        let outcome = self.solver.newton(most, done, &scale, k, |done, k| {
            let progress = newton_step(self.field, (z, step), self.tableau, done, k, space);
            let (change, size) = TermScale { scale: &scale, terms }.compare(&progress);
            // At an equilibrium both are 0.
            let relative =
                T::select(size.at_most(T::from_f64(0.0)), T::from_f64(0.0), change / size);
            first = first.or(Some(relative));
            path += relative;
            progress
        });
        (outcome, [first.unwrap_or(path), path])
    }

    /// Follows the solution from τ = 0 to τ = 1. Returns it, or `None` if it ends before.
    fn follow(
        &self,
        done: T::Mask,
        terms: &Sizes<T>,
        rate: &FlatState<T>,
        space: &mut NewtonWorkspace<T>,
    ) -> Option<Vec<FlatState<T>>> {
        let mut k = vec![rate.clone(); self.tableau.stages()];
        let mut before: Option<(f64, Vec<FlatState<T>>)> = None;
        let (mut reached, mut part) = (0.0, FIRST_PART);
        for _ in 0..MOST_PARTS {
            let next = f64::min(reached + part, 1.0);
            let mut guess = k.clone();
            if let Some((earlier, old)) = &before {
                let factor = T::from_f64((next - reached) / (reached - earlier));
                for ((guess, k), old) in guess.iter_mut().zip(&k).zip(old) {
                    guess.add_multiple(factor, k);
                    guess.add_multiple(-factor, old);
                }
            }
            let (outcome, [_, path]) =
                self.newton(next, FEW_ITERATIONS, done, terms, &mut guess, space);
            let far = T::select(done, T::from_f64(0.0), path).max_abs();
            // More digits are not compared, and a few iterations do not show that there are no more.
            let found = match outcome {
                Ok(_) => true,
                Err(Unconverged { error: StepError::NotConverged { residual, .. }, .. }) => {
                    residual <= SAME
                }
                Err(_) => false,
            };
            if found && far <= NEAR {
                if next >= 1.0 {
                    return Some(guess);
                }
                before = Some((reached, core::mem::replace(&mut k, guess)));
                reached = next;
            }
            // The distance of a guess by extrapolation is quadratic in the length of the part.
            let [least, greatest] = FACTORS;
            part *= if found { (0.5 * NEAR / far).sqrt().clamp(least, greatest) } else { least };
            if part < LEAST_PART {
                return None;
            }
        }
        None
    }

    /// Returns the lanes in which two solutions are the same.
    fn equal(&self, terms: &Sizes<T>, k: &[FlatState<T>], other: &[FlatState<T>]) -> T::Mask {
        let mut progress = SweepChange { change: BlockSizes::zero(), size: BlockSizes::of(k) };
        for (k, other) in k.iter().zip(other) {
            progress.change.include_difference(k, other);
        }
        let scale = TermScale { scale: &StageScale::new(self.z, self.step), terms };
        let (change, size) = scale.compare(&progress);
        change.at_most(size * SAME)
    }
}

#[cfg(test)]
mod tests {
    use crate::error::StepError;
    use crate::schemes::runge_kutta::RungeKutta;
    use crate::schemes::scheme::Scheme;
    use crate::vector_field::from_fn;
    use nalgebra::{Vector1, Vector3};

    /// Makes a midpoint step of the given size from x.
    fn midpoint(f: impl Fn(f64) -> f64, x: f64, step: f64) -> Result<f64, StepError> {
        let field = from_fn(|x: &Vector1<f64>| Vector1::new(f(x.x)));
        let midpoint = RungeKutta::implicit_midpoint();
        let made = midpoint.step(&field, &Vector1::new(x), step, &mut midpoint.workspace())?;
        Ok(made.point.x)
    }

    /// For f = x² the equation k = (x + hk/2)² has two solutions up to hx = ½, and none beyond. The bounded f has a third
    /// one near 100, to which sweeps and Newton's iteration lead where it is the only one.
    #[test]
    fn a_solution_that_no_short_step_leads_to_is_refused() {
        let saturating = |x: f64| 100.0 * x * x / (100.0 + x * x);
        for step in [0.1, 0.3, 0.45] {
            let (bounded, free) = (midpoint(saturating, 1.0, step), midpoint(|x| x * x, 1.0, step));
            assert!(bounded.is_ok_and(|x| x < free.unwrap_or(0.0) && x < 3.0), "{step}");
        }
        for step in [0.6, 1.0, 2.0] {
            let bounded = midpoint(saturating, 1.0, step);
            assert!(matches!(bounded, Err(StepError::OtherSolution { .. })), "{step} {bounded:?}");
        }
    }

    /// Sweeps and Newton's iteration from X(z) go far in steps in which a free body turns by several radians, to solutions
    /// that are exact to the order of the method.
    #[test]
    fn accurate_steps_of_several_radians_are_made() -> Result<(), StepError> {
        let body =
            from_fn(|x: &Vector3<f64>| x.cross(&x.component_div(&Vector3::new(1.0, 2.0, 3.0))));
        let start = Vector3::new(1.0, 0.2, 3.0);
        // The errors measured in the longest steps are 2e-2, 1.4e-3 and 2e-4.
        for (stages, bound) in [(4, 0.03), (6, 3e-3), (8, 5e-4)] {
            let gauss = RungeKutta::gauss(stages).map_err(|_| StepError::NotFinite)?;
            for step in (1..=20).map(|i| 0.25 * f64::from(i)) {
                let made = gauss.step(&body, &start, step, &mut gauss.workspace())?.point;
                let (mut exact, mut space) = (start, gauss.workspace());
                for _ in 0..64 {
                    exact = gauss.step(&body, &exact, step / 64.0, &mut space)?.point;
                }
                assert!((made - exact).amax() < bound, "{stages} {step} {made:?}");
                // In units that are powers of two the same steps are made, to the last bit.
                for unit in [f64::powi(2.0, -90), f64::powi(2.0, 90)] {
                    let (start, step) = (start * unit, step / unit);
                    let other = gauss.step(&body, &start, step, &mut gauss.workspace())?.point;
                    assert_eq!(other, made * unit, "{stages} {step}");
                }
            }
        }
        Ok(())
    }

    /// The equation k = −y − 1000 y³, y = x + hk/2, has one solution, which short steps lead to.
    #[test]
    fn a_long_step_of_a_stiff_field_is_made() {
        let f = |x: f64| -x - 1e3 * x * x * x;
        for step in [1.0, 10.0, 100.0] {
            let (mut low, mut high) = (0.0, 1.0);
            for _ in 0..60 {
                let y = 0.5 * (low + high);
                (low, high) = if y - 1.0 > step / 2.0 * f(y) { (low, y) } else { (y, high) };
            }
            let end = midpoint(f, 1.0, step);
            // the end is 2y − x, with the round-off of h f
            assert!(
                end.is_ok_and(|end| (end - (2.0 * low - 1.0)).abs() < 1e-12 * step),
                "{step} {end:?}"
            );
        }
    }
}
