//! Vector fields whose parts have flows in closed form: [`ExactFlows`].

use lie_poisson::{Real, State};

/// A vector field X = X₁ + … + X_n whose parts have flows in closed form.
///
/// If the parts are the Hamiltonian vector fields of h = h₁ + … + h_n, their exact flows are Poisson maps, and so are
/// compositions of them. A splitting method needs no realisation to be a Poisson integrator, but it exists only for
/// such h.
///
/// # Example
/// The pendulum h = p²/2 − cos q, whose parts have the flows of free motion and of a kick:
/// ```
/// use collective_integrators::{ExactFlows, Integrator, Splitting};
/// use nalgebra::Vector2;
///
/// struct Pendulum;
/// impl ExactFlows for Pendulum {
///     type Point = Vector2<f64>;
///     const COUNT: usize = 2;
///     fn flow(&self, index: usize, time: f64, z: &Vector2<f64>) -> Vector2<f64> {
///         match index {
///             0 => Vector2::new(z.x + time * z.y, z.y),
///             1 => Vector2::new(z.x, z.y - time * z.x.sin()),
///             _ => *z,
///         }
///     }
/// }
///
/// let energy = |z: &Vector2<f64>| z.y * z.y * 0.5 - z.x.cos();
/// let (verlet, start) = (Splitting::strang(Pendulum), Vector2::new(1.0, 0.0));
/// for sample in verlet.trajectory_from(start, 0.1).take(1000) {
///     assert!((energy(&sample?.state) - energy(&start)).abs() < 1e-3); // no drift
/// }
/// # Ok::<(), collective_integrators::IntegrationError>(())
/// ```
pub trait ExactFlows<T: Real = f64> {
    /// The type of the points of the space on which the field acts.
    type Point: State<Scalar = T>;

    /// The number n of parts.
    const COUNT: usize;

    /// Returns the point that z reaches along the flow of part number `index` + 1 in the given time, which may be
    /// negative.
    ///
    /// The flow is the identity for `index` ≥ `COUNT`.
    fn flow(&self, index: usize, time: f64, z: &Self::Point) -> Self::Point;

    /// Moves z along the flow of part number `index` + 1, in the same storage.
    ///
    /// [`Splitting`](crate::Splitting) calls this method. The default calls [`flow`](Self::flow); override it for large
    /// points, and take temporary points from the pool, so that a step allocates nothing.
    #[cfg_attr(optimised, inline(always))]
    fn flow_in_place(
        &self,
        index: usize,
        time: f64,
        z: &mut Self::Point,
        _pool: &mut <Self::Point as State>::Pool,
    ) {
        *z = self.flow(index, time, z);
    }
}
