//! MEGNO: the mean exponential growth factor of nearby orbits.

/// MEGNO, the mean exponential growth factor of nearby orbits of a trajectory.
///
/// It is computed from the stretches δ(k)/δ(k−1) in successive steps of a tangent vector, whose length after k steps is
/// δ(k):
///
/// ```text
/// Y(n) = (2/n) Σ_(k≤n) k ln(δ(k)/δ(k−1)),    ⟨Y⟩(n) = (1/n) Σ_(k≤n) Y(k)
/// ```
///
/// It has no unit. On a torus of a system whose frequencies vary from torus to torus, ⟨Y⟩ tends to 2. Near a stable
/// periodic motion with neighbours of the same period it tends to 0. In a chaotic region it grows as λt/2, where λ is
/// the maximal Lyapunov exponent. It separates order from chaos sooner than λ, which tends to 0 as (ln t)/t on a torus.
///
/// Source: P. M. Cincotta, C. M. Giordano & C. Simó, *Phase space structure of multi-dimensional
/// systems by means of the mean exponential growth factor of nearby orbits*, Physica D 182 (2003).
///
/// # Example
/// Two motions in a double well:
/// ```
/// use collective_integrators::{Direct, Megno, RungeKutta, VariationalFlow, VectorField};
/// use lie_poisson::Real;
/// use nalgebra::Vector2;
/// struct Quartic;
/// impl<T: Real> VectorField<T> for Quartic {
///     type Point = Vector2<T>;
///     fn at(&self, z: &Vector2<T>) -> Vector2<T> {
///         Vector2::new(z.y, z.x - z.x * z.x * z.x)
///     }
/// }
/// let gauss = Direct::new(RungeKutta::gauss(2)?, Quartic);
/// let megno = |x: f64, steps: u32| {
///     let tangent = Vector2::new(0.6, 0.8);
///     let mut flow = VariationalFlow::new(&gauss, Vector2::new(x, 0.0), [tangent], 0.1);
///     let mut megno = Megno::default();
///     for _ in 0..steps {
///         flow.advance()?;
///         let [stretch] = flow.normalise()?;
///         megno.observe(stretch);
///     }
///     Ok::<_, collective_integrators::VariationalError>(megno.mean())
/// };
/// // a torus, and the saddle at 0 with λ = 1 and λt/2 = 50
/// assert!((megno(1.8, 3000)? - 2.0).abs() < 0.1);
/// assert!((megno(0.0, 1000)? - 50.0).abs() < 1.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Megno {
    steps: u64,
    /// The sum Σ k ln(δ(k)/δ(k−1)).
    weighted: f64,
    /// The sum Σ Y(k) of the values so far.
    sum: f64,
}

impl Megno {
    /// Adds the stretch δ(k)/δ(k−1) > 0 of the next step.
    pub fn observe(&mut self, stretch: f64) {
        self.steps += 1;
        let steps = self.steps as f64;
        self.weighted += steps * stretch.ln();
        self.sum += 2.0 * self.weighted / steps;
    }

    /// Returns Y(n), where n is the number of observed steps. It is 0 before the first.
    #[must_use]
    pub fn value(&self) -> f64 {
        2.0 * self.weighted / self.steps.max(1) as f64
    }

    /// Returns ⟨Y⟩(n), which fluctuates less than Y(n). It is 0 before the first step.
    #[must_use]
    pub fn mean(&self) -> f64 {
        self.sum / self.steps.max(1) as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exponential_and_linear_growth_have_their_closed_forms() {
        let (mut exponential, mut linear) = (Megno::default(), Megno::default());
        let s = 0.01_f64;
        for k in 1..=1000 {
            exponential.observe(s.exp());
            linear.observe(f64::from(k + 1) / f64::from(k));
        }
        // Y(n) = s (n + 1) and ⟨Y⟩(n) = s (n + 3)/2, with a relative round-off of 1e-16 per term
        assert!((exponential.value() - s * 1001.0).abs() < 1e-11);
        assert!((exponential.mean() - s * 501.5).abs() < 1e-11);
        // k ln(1 + 1/k) = 1 − 1/2k + …: 2 to within (ln n)²/2n
        assert!((linear.value() - 2.0).abs() < 0.01 && (linear.mean() - 2.0).abs() < 0.03);
        // Control: stretches of alternating sign do not grow.
        let mut turning = Megno::default();
        (0..1000).for_each(|k| turning.observe(if k % 2 == 0 { 2.0 } else { 0.5 }));
        assert!(turning.mean().abs() < 0.7);
        assert_eq!((Megno::default().value(), Megno::default().mean()), (0.0, 0.0));
    }
}
