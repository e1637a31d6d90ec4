//! Partitioned Runge–Kutta methods: [`PartitionedRungeKutta`].

use crate::error::{SchemeError, StepError};
use crate::iteration::stage_scale::StageScale;
use crate::iteration::stage_solver::{StageSolver, fit, set_combination};
use crate::schemes::polarisation::Polarisation;
use crate::schemes::scheme::{Scheme, Step};
use crate::stages::extrapolation::Predictor;
use crate::stages::history::StageHistory;
use crate::tableaux::order_conditions::tree_order;
use crate::tableaux::tableau::{COEFFICIENT_TOLERANCE, Tableau};
use crate::vector_field::VectorField;
use core::marker::PhantomData;
use lie_poisson::{Real, State};

/// A partitioned Runge–Kutta method, with one tableau (a, b) for q and another tableau (A, B) for p:
///
/// ```text
/// Q_i = q + h Σ_j a_ij dq_j/dt,    P_i = p + h Σ_j A_ij dp_j/dt,    (dq_j/dt, dp_j/dt) = X(Q_j, P_j)
/// q₁ = q + h Σ_j b_j dq_j/dt,      p₁ = p + h Σ_j B_j dp_j/dt
/// ```
///
/// The field X need not be separable. The stages are solved together, by the iteration of [`StageSolver`].
///
/// All properties are computed from the coefficients. A partitioned method may be symplectic, but it is not
/// [`Equivariant`](crate::Equivariant): see
/// [`Collective::that_does_not_descend`](crate::Collective::that_does_not_descend).
///
/// Source: Hairer, Lubich & Wanner, *Geometric Numerical Integration*, 2nd ed. (2006), §II.2.
///
/// # Example
/// ```
/// use collective_integrators::{Alternating, PartitionedRungeKutta, Scheme, from_fn};
/// use nalgebra::Vector2;
/// let verlet = PartitionedRungeKutta::<Alternating>::kick_drift_kick();
/// assert!(verlet.is_symplectic() && verlet.is_symmetric() && verlet.order() == 2);
/// assert!(!verlet.preserves_quadratic_invariants());
/// let oscillator = from_fn(|z: &Vector2<f64>| Vector2::new(z.y, -z.x));
/// let z = verlet.step(&oscillator, &Vector2::new(1.0, 0.0), 0.1, &mut verlet.workspace())?.point;
/// // p½ = −0.05, q₁ = 1 − 0.005, p₁ = p½ − 0.05 q₁
/// assert!((z - Vector2::new(0.995, -0.09975)).norm() < 1e-16);
/// # Ok::<(), collective_integrators::StepError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct PartitionedRungeKutta<P> {
    q: Tableau,
    p: Tableau,
    order: usize,
    solver: StageSolver,
    predictor: Predictor,
    polarisation: PhantomData<P>,
}

impl<P: Polarisation> PartitionedRungeKutta<P> {
    /// Creates a method from the tableau (a, b) for q and (A, B) for p.
    ///
    /// # Errors
    /// Returns [`SchemeError::Stages`] if they differ in the number of stages.
    pub fn new(q: Tableau, p: Tableau) -> Result<Self, SchemeError> {
        if q.stages() != p.stages() {
            return Err(SchemeError::Stages { q: q.stages(), p: p.stages() });
        }
        Ok(Self::of_equal_stages(q, p))
    }

    fn of_equal_stages(q: Tableau, p: Tableau) -> Self {
        let order = if q == p {
            q.order()
        } else {
            tree_order(&[(q.matrix(), q.weights()), (p.matrix(), p.weights())])
        };
        let solver = StageSolver::default();
        let same_times =
            q.nodes().iter().zip(p.nodes()).all(|(c, d)| (c - d).abs() <= COEFFICIENT_TOLERANCE);
        let predictor = if same_times { Predictor::new(q.nodes()) } else { Predictor::none() };
        Self { q, p, order, solver, predictor, polarisation: PhantomData }
    }

    /// Returns the same method with another stage solver.
    #[must_use]
    pub fn with_solver(self, solver: StageSolver) -> Self {
        Self { solver, ..self }
    }

    /// Returns the tableaux for q and for p.
    #[must_use]
    pub fn tableaux(&self) -> (&Tableau, &Tableau) {
        (&self.q, &self.p)
    }

    /// Creates the symplectic Euler method that is implicit in p, of order 1:
    ///
    /// ```text
    /// p₁ = p − h H_q(q, p₁),    q₁ = q + h H_p(q, p₁)
    /// ```
    ///
    /// Source: de Vogelaere (1956); Hairer, Lubich & Wanner, Thm. VI.3.3.
    #[must_use]
    pub fn symplectic_euler_implicit_in_p() -> Self {
        Self::of_equal_stages(Tableau::literal(&[0.0], &[1.0]), Tableau::literal(&[1.0], &[1.0]))
    }

    /// Creates the symplectic Euler method that is implicit in q, of order 1:
    ///
    /// ```text
    /// q₁ = q + h H_p(q₁, p),    p₁ = p − h H_q(q₁, p)
    /// ```
    ///
    /// It is the adjoint of the method that is [implicit in p](Self::symplectic_euler_implicit_in_p).
    #[must_use]
    pub fn symplectic_euler_implicit_in_q() -> Self {
        Self::of_equal_stages(Tableau::literal(&[1.0], &[1.0]), Tableau::literal(&[0.0], &[1.0]))
    }

    /// Creates the Störmer–Verlet method that moves p first, of order 2:
    ///
    /// ```text
    /// p½ = p − (h/2) H_q(q, p½)
    /// q₁ = q + (h/2) (H_p(q, p½) + H_p(q₁, p½))
    /// p₁ = p½ − (h/2) H_q(q₁, p½)
    /// ```
    ///
    /// It is the two-stage Lobatto IIIA–IIIB pair.
    ///
    /// Source: Hairer, Lubich & Wanner, Thm. VI.3.4.
    #[must_use]
    pub fn kick_drift_kick() -> Self {
        let (trapezoidal, constant) = ([0.0, 0.0, 0.5, 0.5], [0.5, 0.0, 0.5, 0.0]);
        let tableau = |a: &[f64]| Tableau::literal(a, &[0.5, 0.5]);
        Self::of_equal_stages(tableau(&trapezoidal), tableau(&constant))
    }

    /// Creates the Störmer–Verlet method that moves q first, with the roles of q and p exchanged.
    #[must_use]
    pub fn drift_kick_drift() -> Self {
        let Self { q, p, .. } = Self::kick_drift_kick();
        Self::of_equal_stages(p, q)
    }

    /// Creates the pair of Lobatto IIIA for q and Lobatto IIIB for p, with s = 2 to 4 stages.
    ///
    /// The order is 2s − 2. The method is symplectic and symmetric.
    ///
    /// Source: Sun (1993), Jay (1996); Hairer, Lubich & Wanner, §IV.2 and Table II.1.3.
    ///
    /// # Errors
    /// Returns [`SchemeError::Family`] for another number of stages.
    pub fn lobatto_iiia_iiib(stages: usize) -> Result<Self, SchemeError> {
        let q = Tableau::lobatto_iiia(stages)?;
        let p = q.symplectic_conjugate()?;
        Ok(Self::of_equal_stages(q, p))
    }

    /// Writes h (Σ a_j dq_j/dt, Σ A_j dp_j/dt) to the sum.
    #[inline]
    fn set_sum<V: State>(
        sum: &mut V,
        step: f64,
        (a, a_hat): (&[f64], &[f64]),
        k: &[V],
        pool: &mut V::Pool,
    ) {
        let (mut q, mut p) = (V::take(pool, sum), V::take(pool, sum));
        set_combination(&mut q, a, k);
        set_combination(&mut p, a_hat, k);
        P::splice_into(&q, &p, sum);
        sum.scale_in_place(V::Scalar::from_f64(step));
        q.give(pool);
        p.give(pool);
    }
}

/// The storage of a partitioned step: its stage derivatives and those of earlier steps.
///
/// The next stages are predicted from the last steps if q and p have their stages at the same times.
#[derive(Clone, Debug)]
pub struct PartitionedWorkspace<V: State> {
    k: Vec<V>,
    memory: StageHistory<V>,
    pool: V::Pool,
}

impl<P: Polarisation> Scheme for PartitionedRungeKutta<P> {
    type Workspace<V: State> = PartitionedWorkspace<V>;

    fn workspace<V: State>(&self) -> PartitionedWorkspace<V> {
        PartitionedWorkspace {
            k: Vec::with_capacity(self.q.stages()),
            memory: StageHistory::new(&self.predictor),
            pool: V::Pool::default(),
        }
    }

    #[inline]
    fn increment<T: Real, F: VectorField<T>>(
        &self,
        field: &F,
        z: &F::Point,
        step: f64,
        workspace: &mut PartitionedWorkspace<F::Point>,
    ) -> Result<Step<F::Point>, StepError> {
        let PartitionedWorkspace { k, memory, pool } = workspace;
        // A workspace from another method, or for another size, still gives the right result.
        fit(k, self.q.stages(), z);
        let (mut point, mut spare) = (F::Point::take(pool, z), F::Point::take(pool, z));
        let derivative = |i: usize, k: &[F::Point], value: &mut F::Point| {
            Self::set_sum(&mut point, step, (self.q.row(i), self.p.row(i)), k, pool);
            point.add_in_place(z);
            field.at_into(&point, value);
        };
        let scale = StageScale::new(z, step);
        let (from, unknowns) = ((z, step, &scale), (k.as_mut_slice(), &mut spare));
        let solved = memory.solve(&self.predictor, &self.solver, field, from, unknowns, derivative);
        spare.give(pool);
        let iterations = match solved {
            Ok(iterations) => iterations,
            Err(unconverged) => {
                point.give(pool);
                return Err(unconverged.error);
            }
        };
        Self::set_sum(&mut point, step, (self.q.weights(), self.p.weights()), k, pool);
        memory.end_after(z, &point);
        Ok(Step { point, iterations })
    }

    #[inline]
    fn temporaries<'a, V: State>(
        &self,
        workspace: &'a mut PartitionedWorkspace<V>,
    ) -> Option<&'a mut V::Pool> {
        Some(&mut workspace.pool)
    }

    #[inline]
    fn forget<V: State>(&self, workspace: &mut PartitionedWorkspace<V>) {
        workspace.memory.forget();
    }

    /// Returns the order, from the order conditions of two-coloured trees. Orders above 8 are not tested.
    ///
    /// Source: Hairer, Lubich & Wanner, Thm. III.2.5.
    fn order(&self) -> usize {
        self.order
    }

    /// Returns whether b = B and b_i A_ij + B_j a_ji = b_i B_j.
    ///
    /// Source: Hairer, Lubich & Wanner, Thm. VI.4.6.
    fn is_symplectic(&self) -> bool {
        let (b, b_hat) = (self.q.weights(), self.p.weights());
        let small = |x: f64| x.abs() <= COEFFICIENT_TOLERANCE;
        let stages = 0..b.len();
        b.iter().zip(b_hat).all(|(x, y)| small(x - y))
            && stages.clone().all(|i| {
                stages.clone().all(|j| {
                    let (a_hat, a) = (self.p.row(i)[j], self.q.row(j)[i]);
                    small(b[i] * a_hat + b_hat[j] * a - b[i] * b_hat[j])
                })
            })
    }

    fn is_symmetric(&self) -> bool {
        self.q.is_symmetric() && self.p.is_symmetric()
    }

    /// Returns whether both tableaux are the same. The method is then not really partitioned.
    fn preserves_quadratic_invariants(&self) -> bool {
        self.q == self.p && self.q.is_symplectic()
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::schemes::polarisation::FirstHalf;

    /// Stages at the same times are extrapolated from the last step together.
    #[test]
    fn pairs_with_the_same_nodes_predict_their_stages() {
        for stages in [3, 4] {
            let pair = PartitionedRungeKutta::<FirstHalf>::lobatto_iiia_iiib(stages).unwrap();
            assert_eq!(pair.predictor, Predictor::new(pair.q.nodes()));
        }
        let euler = PartitionedRungeKutta::<FirstHalf>::symplectic_euler_implicit_in_p();
        assert_eq!(euler.predictor, Predictor::none());
    }
}
