//! Splitting into flows that are known exactly.

use crate::{Integrator, StateIsMomentum, Step, StepError};
use lie_poisson::{Real, Vector};

/// A vector field X = X_1 + … + X_n whose parts have flows in closed form.
///
/// If the parts are the Hamiltonian vector fields of h = h_1 + … + h_n, their exact flows are
/// Poisson maps, and so is what is composed of them: a splitting method needs no realisation to be
/// a Poisson integrator. It needs luck with h.
pub trait ExactFlows<T: Real = f64> {
    /// Where the field lives.
    type Point: Vector<Scalar = T>;

    /// n
    const COUNT: usize;

    /// The flow of X_{index+1} for the given time, which may be negative; the identity for `index`
    /// ≥ `COUNT`.
    fn flow(&self, index: usize, time: f64, z: &Self::Point) -> Self::Point;
}

/// The composition of exact flows, of order 1 or 2:
///
/// ```text
/// Lie–Trotter   φ_n^h ∘ … ∘ φ_1^h
/// Strang        φ_1^{h/2} ∘ … ∘ φ_{n−1}^{h/2} ∘ φ_n^h ∘ φ_{n−1}^{h/2} ∘ … ∘ φ_1^{h/2}
/// ```
///
/// Strang's is symmetric, so that [`Composition`](crate::Composition) raises its order by the same
/// [`Substeps`](crate::Substeps) as that of any other method:
/// [`order_over`](crate::Substeps::order_over)(2, true). Both are explicit, and fail only where the
/// result is not finite.
///
/// Source: Strang (1968), Marchuk (1968); McLachlan & Quispel, *Splitting methods*, Acta Numer. 11
/// (2002).
///
/// # Example
/// ```
/// use collective_integrators::{Composition, ExactFlows, Splitting, Start, Substeps};
/// use nalgebra::Vector2;
///
/// /// The pendulum: q̇ = p, then ṗ = −sin q.
/// struct Pendulum;
/// impl ExactFlows for Pendulum {
///     type Point = Vector2<f64>;
///     const COUNT: usize = 2;
///     fn flow(&self, index: usize, t: f64, z: &Vector2<f64>) -> Vector2<f64> {
///         match index {
///             0 => Vector2::new(z.x + t * z.y, z.y),
///             1 => Vector2::new(z.x, z.y - t * z.x.sin()),
///             _ => *z,
///         }
///     }
/// }
/// let energy = |z: &Vector2<f64>| 0.5 * z.y * z.y - z.x.cos();
/// let scheme = Composition::new(Splitting::strang(Pendulum), Substeps::kahan_li8());
/// let z = Vector2::new(1.0, 0.0);
/// for sample in scheme.trajectory(&z, 0.1)?.take(100) {
///     assert!((energy(&sample?.state) - energy(&z)).abs() < 1e-12);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Splitting<E> {
    flows: E,
    symmetric: bool,
}

impl<E> Splitting<E> {
    /// Strang's symmetric composition, of order 2.
    pub const fn strang(flows: E) -> Self {
        Self { flows, symmetric: true }
    }

    /// Lie and Trotter's composition, of order 1.
    pub const fn lie_trotter(flows: E) -> Self {
        Self { flows, symmetric: false }
    }

    /// The flows.
    pub const fn flows(&self) -> &E {
        &self.flows
    }

    /// Whether Φ_{−h} ∘ Φ_h = id.
    #[must_use]
    pub const fn is_symmetric(&self) -> bool {
        self.symmetric
    }

    /// The order for flows in general position.
    #[must_use]
    pub const fn order(&self) -> usize {
        if self.symmetric { 2 } else { 1 }
    }
}

impl<T: Real, E: ExactFlows<T>> Integrator<T> for Splitting<E> {
    type State = E::Point;
    type Momentum = E::Point;
    type Workspace = ();

    fn workspace(&self) {}

    #[inline]
    fn step(&self, z: &E::Point, step: f64, (): &mut ()) -> Result<Step<E::Point>, StepError> {
        let flow = |time: f64| move |z: E::Point, index| self.flows.flow(index, time, &z);
        let point = if self.symmetric {
            let last = E::COUNT.saturating_sub(1);
            let there = (0..last).fold(*z, flow(0.5 * step));
            let middle = flow(step)(there, last);
            (0..last).rev().fold(middle, flow(0.5 * step))
        } else {
            (0..E::COUNT).fold(*z, flow(step))
        };
        Step { point, iterations: 0 }.finite()
    }

    fn momentum(&self, z: &E::Point) -> E::Point {
        *z
    }
}

impl<E> StateIsMomentum for Splitting<E> {}
