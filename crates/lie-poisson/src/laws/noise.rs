//! The law suite of [`Noise`].

use super::orbit_field::{breaks, smoothness};
use super::{Faulty, NoSamples, Report, regimes};
use crate::brackets::poisson::PoissonSpace;
use crate::dissipation::noise::Noise;
use crate::orbits::orbit_field::OrbitField;
use generic_scalars::{Differential, DualNumber, Point, Real, Vector, larger, map_coordinates};

/// Evaluates the laws of a noise σ_k on samples of points, from the time `begin` to `end`:
///
/// * `linear in the weights`: Σ_k w_k σ_k is the sum of the fields with their weights;
/// * `dual numbers`: over dual numbers the fields have the values that they have over `f64`;
/// * `constant`: if the noise [says](Noise::is_constant) that no field depends on μ, they are the same at all samples. Give samples
///   that differ in every coordinate;
/// * `breaks`, `smoothness`: Σ_k w_k σ_k has these laws of an [orbit field](super::orbit_field), with the breaks that the noise tells.
///
/// All but the last two are evaluated at both ends.
///
/// # Errors
/// Returns [`NoSamples`] if there are no samples.
///
/// # Example
/// ```
/// use lie_poisson::{Covector, LiePoisson, Noise, Real, So3, laws};
/// use nalgebra::Vector3;
/// /// A field along the spin, which does not turn it, and one along e₃.
/// struct Two;
/// impl<T: Real> Noise<LiePoisson<So3>, T> for Two {
///     fn count(&self) -> usize {
///         2
///     }
///     fn element(&self, mu: &Covector<Vector3<T>>, _: T, weights: &[T]) -> Vector3<T> {
///         mu.0 * weights[0] + Vector3::new(T::zero(), T::zero(), weights[1])
///     }
/// }
/// let samples = [Covector(Vector3::new(0.3, -0.7, 0.5)), Covector(Vector3::new(0.9, 0.2, -0.6))];
/// let space = LiePoisson::minus(So3);
/// laws::noise(&space, &Two, (0.0, 1.0), &samples)?.check(1e-14)?;
/// // Control: the suite refuses a noise that says that it is constant and is not.
/// let faulty = laws::Faulty::new(&Two, "is_constant", 0);
/// assert!(laws::noise(&space, &faulty, (0.0, 1.0), &samples)?.check(1e-3).is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn noise<P, N>(
    _: &P,
    noise: &N,
    (begin, end): (f64, f64),
    samples: &[Point<P>],
) -> Result<Report, NoSamples>
where
    P: PoissonSpace,
    N: Noise<P> + Noise<P, DualNumber>,
{
    let (count, mut report) = (Noise::<P, f64>::count(noise), Report::default());
    let fields = |mu: &Point<P>, time: f64| -> Vec<Differential<P>> {
        let one = |k| (0..count).map(|i| f64::from(u8::from(i == k))).collect::<Vec<f64>>();
        (0..count).map(|k| Noise::<P, f64>::element(noise, mu, time, &one(k))).collect()
    };
    // Weights that obey no simple relation.
    let weights: Vec<f64> = (0..count).map(|k| (1.0 + 1.7 * k as f64).sin()).collect();
    let dual_weights: Vec<DualNumber> = weights.iter().map(|w| DualNumber::constant(*w)).collect();
    let points = regimes("points", samples)?;
    let field = Weighted { noise, weights: &weights };
    let breaks = breaks::<P>(&field, begin, end, &mut report);
    for (mu, piece) in points.iter().flat_map(|mu| breaks.windows(2).map(move |piece| (mu, piece)))
    {
        smoothness::<P, _>(&field, mu, (piece[0], piece[1]), &mut report);
    }
    for time in [begin, end] {
        let first = points.first().map(|mu| fields(mu, time)).unwrap_or_default();
        for mu in &points {
            let all = fields(mu, time);
            let largest = all.iter().fold(0.0, |most, sigma| larger(most, sigma.max_abs()));
            let element = Noise::<P, f64>::element(noise, mu, time, &weights);
            let mut sum = element;
            for (weight, sigma) in weights.iter().zip(&all) {
                sum -= sigma.scaled(*weight);
            }
            report.note("linear in the weights", sum.max_abs(), largest * count as f64);
            let dual: Point<P, DualNumber> = map_coordinates(mu, DualNumber::constant);
            let value = noise.element(&dual, DualNumber::variable(time), &dual_weights);
            let value: Differential<P> =
                map_coordinates(&value, |x: DualNumber| x.value_without_derivative());
            report.note("dual numbers", (value - element).max_abs(), largest);
            if Noise::<P, f64>::is_constant(noise) {
                for (sigma, first) in all.iter().zip(&first) {
                    report.note(
                        "constant",
                        (*sigma - *first).max_abs(),
                        larger(largest, first.max_abs()),
                    );
                }
            }
        }
    }
    Ok(report)
}

/// The field Σ_k w_k σ_k with fixed weights.
struct Weighted<'a, N> {
    noise: &'a N,
    weights: &'a [f64],
}

impl<P: PoissonSpace, T: Real, N: Noise<P, T>> OrbitField<P, T> for Weighted<'_, N> {
    fn element(&self, mu: &Point<P, T>, time: T) -> Differential<P, T> {
        let weights: Vec<T> = self.weights.iter().map(|w| T::from_f64(*w)).collect();
        self.noise.element(mu, time, &weights)
    }

    fn next_break(&self, time: f64, forward: bool) -> Option<f64> {
        self.noise.next_break(time, forward)
    }
}

/// The fault of [`is_constant`](Noise::is_constant) is that it is always true, and that of [`next_break`](Noise::next_break) that
/// there is never one.
impl<P: PoissonSpace, T: Real, N: Noise<P, T>> Noise<P, T> for Faulty<'_, N> {
    fn count(&self) -> usize {
        self.object().count()
    }

    fn element(&self, mu: &Point<P, T>, time: T, weights: &[T]) -> Differential<P, T> {
        self.object().element(mu, time, weights)
    }

    fn is_constant(&self) -> bool {
        self.has_fault_in("is_constant") || self.object().is_constant()
    }

    fn next_break(&self, time: f64, forward: bool) -> Option<f64> {
        let is_silent = self.has_fault_in("next_break");
        self.object().next_break(time, forward).filter(|_| !is_silent)
    }
}
