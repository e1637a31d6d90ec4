//! Trajectories with their tangent vectors: [`VariationalFlow`].

use super::carrier::Carrier;
use crate::chaos::tangent_integrator::{MomentumOf, StateOf, TangentIntegrator, VariationalError};
use lie_poisson::State;

/// A state z with K tangent vectors v, advanced by the integrator and by its exact tangent map:
///
/// ```text
/// z ← Φ_h(z),    v ← DΦ_h(z) v
/// ```
///
/// The derivative DΦ_h is that of the discrete map, computed by dual numbers. With a Poisson integrator it preserves
/// the Poisson tensor. One step costs one step over `f64` and K steps over dual numbers, and allocates nothing. States
/// may be on the heap. [`TangentFrame`](crate::TangentFrame) is for a number of vectors that is known only when the program
/// runs.
///
/// # States and momenta
/// The tangent vectors belong to the *state*: to 𝔤∗ for [`LiftFree`](crate::LiftFree) and [`Direct`](crate::Direct),
/// and to P, with its fibres, for [`Collective`](crate::Collective). There the tangent vectors of μ are their images
/// DM(z) v, which [`directions`](Self::directions) returns and [`normalise`](Self::normalise) measures.
///
/// The state is never moved along its fibre, since such a motion has no tangent map
/// ([`Integrator::pin`](crate::Integrator::pin)). It is bit-identical to that of a [`Trajectory`](crate::Trajectory) from the same start up to the first such motion of the
/// trajectory. From there on the momenta are equal to round-off. Along an orbit on which z grows, M(z) loses the
/// digits that the motions would save, in most realisations one for every tenfold time. Integrators without a lift
/// lose none.
///
/// # Lengths
/// If the vectors have several [blocks](State::BLOCKS) of coordinates, such as Π and Γ, lengths and angles are those of
/// coordinates in units of a [scale](lie_poisson::BlockScales) s_b for each block. No number depends on the units of the blocks. The
/// scales belong to the flow, and are those of its start: the size of the block, or what it gets from the other blocks
/// in the shortest time in which the motion changes them, if that is larger. For a heavy top they are about |Γ|, and
/// the larger of |Π| and √(I mgl |Γ|). They follow from the derivatives of one step from the start, in three directions
/// of each block. Vectors of one block have the Euclidean length of their coordinates.
///
/// # Example
/// The tangent map of a linear flow is the flow:
/// ```
/// use collective_integrators::{Direct, RungeKutta, VariationalFlow, VectorField};
/// use lie_poisson::Real;
/// use nalgebra::Vector2;
/// struct Oscillator;
/// impl<T: Real> VectorField<T> for Oscillator {
///     type Point = Vector2<T>;
///     fn at(&self, z: &Vector2<T>) -> Vector2<T> {
///         Vector2::new(z.y, -z.x)
///     }
/// }
/// let midpoint = Direct::new(RungeKutta::implicit_midpoint(), Oscillator);
/// let z = Vector2::new(1.0, 2.0);
/// let mut flow = VariationalFlow::new(&midpoint, z, [z], 0.1);
/// for _ in 0..10 {
///     flow.advance()?;
/// }
/// assert!((flow.tangents()[0] - flow.state()).norm() < 1e-14);
/// # Ok::<(), collective_integrators::VariationalError>(())
/// ```
pub struct VariationalFlow<'a, I, const K: usize>
where
    I: TangentIntegrator,
{
    carrier: Carrier<'a, I>,
    tangents: [StateOf<I>; K],
    /// The tangent vectors of the next step, and other temporary vectors.
    spare: [StateOf<I>; K],
}

impl<'a, I, const K: usize> VariationalFlow<'a, I, K>
where
    I: TangentIntegrator,
{
    /// Creates a flow from a state and its tangent vectors at t = 0, with steps of size `step`.
    pub fn new(integrator: &'a I, state: StateOf<I>, tangents: [StateOf<I>; K], step: f64) -> Self {
        let carrier = Carrier::new(integrator, state, step, K > 0);
        let spare = tangents.clone();
        Self { carrier, tangents, spare }
    }

    /// Creates a flow whose tangent vectors have no symmetry: the first K of the
    /// [`generic_tangents`](crate::generic_tangents) in units of the scales of the blocks.
    ///
    /// Coordinates from `dimension` on are zero in the first `dimension` vectors. It is the dimension of the states,
    /// unless coordinates that stay zero complete a smaller space.
    pub fn generic(integrator: &'a I, state: StateOf<I>, dimension: usize, step: f64) -> Self {
        let tangents = core::array::from_fn(|_| state.zeros_like());
        let mut flow = Self::new(integrator, state, tangents, step);
        flow.carrier.begin(dimension, &mut flow.tangents, &mut flow.spare);
        flow
    }

    /// Returns the number of steps made.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.carrier.steps
    }

    /// Returns the step size h.
    #[must_use]
    pub fn step_size(&self) -> f64 {
        self.carrier.size
    }

    /// Returns the time t, which is the number of steps times h.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.carrier.time()
    }

    /// Returns the current state z.
    #[must_use]
    pub fn state(&self) -> &StateOf<I> {
        &self.carrier.state
    }

    /// Returns the momentum μ of the state.
    #[must_use]
    pub fn momentum(&self) -> MomentumOf<I> {
        self.carrier.momentum()
    }

    /// Returns the tangent vectors v at z.
    #[must_use]
    pub fn tangents(&self) -> &[StateOf<I>; K] {
        &self.tangents
    }

    /// Returns the tangent vectors of μ, which are the images DM(z) v, in units of the scales of the blocks of μ.
    ///
    /// After [`normalise`](Self::normalise) they have the Euclidean length 1, as
    /// [`smaller_alignment_index`](crate::smaller_alignment_index) expects. For an integrator whose states are momenta
    /// they are the tangent vectors.
    ///
    /// # Errors
    /// Returns [`VariationalError::Integration`] if the first step fails, so that there are no scales.
    pub fn directions(&self) -> Result<[MomentumOf<I>; K], VariationalError> {
        let direction = self.carrier.directions()?;
        Ok(self.tangents.each_ref().map(direction))
    }

    /// Advances the state and the tangent vectors by one step.
    ///
    /// # Errors
    /// Returns [`VariationalError::Integration`] if the step fails for the state or for a tangent vector, or if a
    /// tangent vector has another dimension than the state. In these cases nothing is changed.
    pub fn advance(&mut self) -> Result<(), VariationalError> {
        self.carrier.advance(&self.tangents, &mut self.spare)?;
        core::mem::swap(&mut self.tangents, &mut self.spare);
        Ok(())
    }

    /// Orthonormalises the tangent vectors by the Gram–Schmidt process, and returns the lengths r_ii > 0.
    ///
    /// The previous vectors are v_i = Σ_j r_ji e_j, j ≤ i, where the new vectors e_j are orthonormal in the Euclidean
    /// product of coordinates in units of the scales of the blocks of the *states*. The v_i may have any size.
    ///
    /// # Errors
    /// Returns [`VariationalError::Dependent`] if a vector is a combination of those before it to round-off, if it is
    /// not finite, or if its length r_ii overflows or underflows. More than DIM vectors are always dependent. In case
    /// of an error, the vectors before the dependent one are already orthonormal. Returns
    /// [`VariationalError::Integration`] if the first step fails, so that there are no scales.
    pub fn orthonormalise(&mut self) -> Result<[f64; K], VariationalError> {
        let mut lengths = [0.0; K];
        self.carrier.orthonormalise(&mut self.tangents, &mut self.spare, &mut lengths)?;
        Ok(lengths)
    }

    /// Scales each tangent vector so that its image DM(z) v has the length 1, without orthogonalisation, and returns
    /// the previous lengths.
    ///
    /// Lengths are those of the [`directions`](Self::directions): of tangent vectors of μ, in units of the scales of
    /// the blocks. They depend on the lift only by these scales, which are larger for a z far along its fibre. Directions are
    /// kept: vectors that align stay aligned.
    ///
    /// # Errors
    /// Returns [`VariationalError::Dependent`] if a length is zero, not finite, or overflows, as for a vector along a
    /// fibre. In case of an error, the vectors before that one are already scaled. Returns
    /// [`VariationalError::Integration`] if the first step fails, so that there are no scales.
    pub fn normalise(&mut self) -> Result<[f64; K], VariationalError> {
        let mut lengths = [0.0; K];
        self.carrier.normalise(&mut self.tangents, &mut lengths)?;
        Ok(lengths)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integrators::direct::Direct;
    use crate::integrators::trajectories::integrator::Integrator;
    use crate::schemes::runge_kutta::RungeKutta;
    use crate::vector_field::VectorField;
    use lie_poisson::Real;
    use nalgebra::Vector2;

    /// The field ẋ = x², ẏ = −y with the flow x/(1 − tx), y exp(−t).
    struct Field;

    impl<T: Real> VectorField<T> for Field {
        type Point = Vector2<T>;

        fn at(&self, z: &Vector2<T>) -> Vector2<T> {
            Vector2::new(z.x * z.x, -z.y)
        }
    }

    #[test]
    fn tangents_are_those_of_the_flow() {
        let gauss = Direct::new(RungeKutta::rk4(), Field);
        let start = Vector2::new(0.5, 1.0);
        let mut flow = VariationalFlow::new(&gauss, start, [Vector2::x(), Vector2::y()], 0.01);
        for sample in gauss.trajectory_from(start, 0.01).take(101) {
            assert!(sample.is_ok_and(|s| s.state == *flow.state() && s.time == flow.time()));
            assert!(flow.advance().is_ok());
        }
        let t = flow.time();
        let expected = [Vector2::new((1.0 - 0.5 * t).powi(-2), 0.0), Vector2::y() * (-t).exp()];
        for (v, w) in flow.tangents().iter().zip(expected) {
            assert!((v - w).norm() < 1e-8, "{v} {w}");
        }
        assert!(flow.orthonormalise().is_ok_and(|r| (r[1] - (-t).exp()).abs() < 1e-9));
        assert_eq!(flow.tangents(), &[Vector2::x(), Vector2::y()]);
    }

    #[test]
    fn tangents_may_have_any_size() {
        let midpoint = Direct::new(RungeKutta::implicit_midpoint(), Field);
        let (x, y) = (Vector2::new(3.0, 4.0), Vector2::new(-4.0, 3.0));
        let near = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-15;
        for size in [5e-324, 1e-200, 1e-155, 1.0, 1e155, 1e200, 1e306] {
            let unit = [Vector2::new(0.6, 0.8), Vector2::new(-0.8, 0.6)];
            let flow =
                |tangents| VariationalFlow::<_, 2>::new(&midpoint, Vector2::y(), tangents, 0.1);
            let same = |a: &[Vector2<f64>; 2]| (0..2).all(|i| (a[i] - unit[i]).norm() < 1e-15);
            let fives = |lengths: Result<[f64; 2], VariationalError>| {
                lengths.is_ok_and(|lengths| lengths.iter().all(|&length| near(length, 5.0 * size)))
            };
            let mut upright = flow([x * size, (y + x) * size]);
            assert!(fives(upright.orthonormalise()) && same(upright.tangents()), "{size:e}");
            let mut scaled = flow([x * size, y * size]);
            assert!(fives(scaled.normalise()) && same(scaled.tangents()), "{size:e}");
            // control: a dependent vector is found at every size
            let mut aligned = flow([x * size, x * (0.5 * size)]);
            assert!(matches!(
                aligned.orthonormalise(),
                Err(VariationalError::Dependent { index: 1, .. })
            ));
        }
    }

    #[test]
    fn what_has_no_value_is_an_error() {
        let midpoint = Direct::new(RungeKutta::implicit_midpoint(), Field);
        let flow = |x: f64, tangents| {
            VariationalFlow::<_, 3>::new(&midpoint, Vector2::new(x, 1.0), tangents, 0.1)
        };
        let (x, y) = (Vector2::x(), Vector2::y());
        let dependent = |error| matches!(error, Err(VariationalError::Dependent { index: 2, .. }));
        assert!(dependent(flow(0.5, [x, y, x + y]).orthonormalise()));
        assert!(dependent(flow(0.5, [x, y, x * f64::NAN]).orthonormalise()));
        assert!(dependent(flow(0.5, [x, y, x * f64::NAN]).normalise()));
        assert!(dependent(flow(0.5, [x, y, x * 0.0]).normalise()));
        let mut aligned = flow(0.5, [x * 2.0, y, x * 3.0]);
        assert_eq!((aligned.normalise(), aligned.tangents()), (Ok([2.0, 1.0, 3.0]), &[x, y, x]));
        assert!(flow(0.5, [x, y, x * f64::NAN]).advance().is_err());
        let mut flow = flow(1e9, [x, y, x]);
        assert!(matches!(flow.advance(), Err(VariationalError::Integration(_))));
        assert_eq!((flow.steps(), flow.state().x, flow.tangents()[0]), (0, 1e9, x));
    }
}
