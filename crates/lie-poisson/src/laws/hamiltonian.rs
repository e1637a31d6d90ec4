//! The law suites of [`Hamiltonian`] and of Hamiltonians of N sites.

use super::{Faulty, NEAR, NoSamples, Report, regimes};
use crate::algebras::algebra::LieAlgebra;
use crate::brackets::hamiltonian::Hamiltonian;
use crate::brackets::poisson::PoissonSpace;
use crate::brackets::sites_hamiltonian::SitesHamiltonian;
use generic_scalars::{
    Covector, Differential, DualNumber, Point, Real, Sites, State, Vector, derivative_part,
    differential, larger, seed,
};

/// Evaluates the laws of a Hamiltonian on samples of points, with exact derivatives by dual numbers:
///
/// * `differential`: dh is the derivative of h;
/// * `second derivative`: D²h·v is the derivative of dh along v, if the Hamiltonian provides it.
///
/// The point 0 and points near it are left out if h is not finite there, as for a logarithm. The samples must belong
/// to the domain of h.
///
/// # Errors
/// Returns [`NoSamples`] if there are no samples.
///
/// # Example
/// ```
/// use lie_poisson::{Covector, LiePoisson, So3, energy, Automatic, laws};
/// use nalgebra::Vector3;
/// energy!(FreeBody {} on LiePoisson<So3>: |_body, Covector(pi)| pi.x * pi.x * 0.5 + pi.y * pi.y);
/// let samples = [Covector(Vector3::new(1.0, 2.0, 3.0)), Covector(Vector3::new(-1.0, 0.5, 2.0))];
/// let report = laws::hamiltonian(&Automatic(FreeBody {}), &samples)?;
/// report.check(1e-15)?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn hamiltonian<P, H>(hamiltonian: &H, samples: &[Point<P>]) -> Result<Report, NoSamples>
where
    P: PoissonSpace,
    H: Hamiltonian<P> + Hamiltonian<P, DualNumber>,
{
    let mut report = Report::default();
    let points = regimes("points", samples)?;
    for (index, z) in points.iter().enumerate() {
        // The samples themselves come last.
        let sample = index + samples.len() >= points.len();
        if !sample && !Hamiltonian::<P>::value(hamiltonian, z).is_finite() {
            continue;
        }
        let exact: Differential<P> =
            differential(|z: &Point<P, DualNumber>| hamiltonian.value(z), z);
        let claimed: Differential<P> = Hamiltonian::<P>::differential(hamiltonian, z);
        let size = larger(exact.max_abs(), SMALLEST);
        report.note("differential", (claimed - exact).max_abs(), size);
        second_derivative(hamiltonian, z, &mut report);
    }
    Ok(report)
}

/// A size below which nothing is compared.
const SMALLEST: f64 = 1e-300;

fn second_derivative<P, H>(hamiltonian: &H, z: &Point<P>, report: &mut Report)
where
    P: PoissonSpace,
    H: Hamiltonian<P> + Hamiltonian<P, DualNumber>,
{
    let along = |i| -> Point<P> { Vector::basis(i) };
    let exact = |i| -> Differential<P> {
        let seeded: Point<P, DualNumber> = seed(z, &along(i));
        derivative_part(&Hamiltonian::<P, DualNumber>::differential(hamiltonian, &seeded))
    };
    let columns: Vec<_> = (0..Point::<P>::DIM).map(exact).collect();
    let size = columns.iter().fold(SMALLEST, |size, column| larger(size, column.max_abs()));
    for (i, exact) in columns.iter().enumerate() {
        if let Some(claimed) = Hamiltonian::<P>::hessian(hamiltonian, z, &along(i)) {
            report.note("second derivative", (claimed - *exact).max_abs(), size);
        }
    }
}

/// The fault can be in the method [`differential`](Hamiltonian::differential).
impl<P: PoissonSpace, T: Real, H: Hamiltonian<P, T>> Hamiltonian<P, T> for Faulty<'_, H> {
    fn value(&self, z: &Point<P, T>) -> T {
        self.object().value(z)
    }

    fn differential(&self, z: &Point<P, T>) -> Differential<P, T> {
        self.halved("differential", self.object().differential(z))
    }

    fn hessian(&self, z: &Point<P, T>, v: &Point<P, T>) -> Option<Differential<P, T>> {
        self.object().hessian(z, v)
    }
}

/// A momentum of N sites of the algebra 𝔤.
type Momenta<A, T = f64> = Covector<Sites<<A as LieAlgebra>::Element<T>>>;

/// Evaluates the laws of a Hamiltonian of N copies of 𝔤∗ on samples of momenta, with exact derivatives by dual numbers:
///
/// * `differential`: dh is the derivative of h, whatever values its storage held before;
/// * `number of sites`: with one site more than in a sample, either the value and each coordinate of dh are NaN,
///   since h has a fixed number of sites, or dh is again the derivative of h.
///
/// As in [`hamiltonian`], momenta at 0 and near it are left out if h is not finite there.
///
/// # Errors
/// Returns [`NoSamples`] if there are no samples.
///
/// # Example
/// ```
/// use lie_poisson::{Covector, Real, Sites, SitesHamiltonian, So3, laws};
/// use nalgebra::Vector3;
/// /// h(s) = −Σ s_i·s_(i+1)
/// struct Ring;
/// impl<T: Real> SitesHamiltonian<Vector3<T>> for Ring {
///     fn value(&self, s: &Covector<Sites<Vector3<T>>>) -> T {
///         let next = s.0.iter().cycle().skip(1);
///         s.0.iter().zip(next).fold(T::zero(), |sum, (s, next)| sum - s.dot(next))
///     }
///     fn differential_into(&self, s: &Covector<Sites<Vector3<T>>>, dh: &mut Sites<Vector3<T>>) {
///         let n = s.0.len();
///         for (i, dh) in dh.iter_mut().enumerate() {
///             *dh = -s.0[(i + n - 1) % n] - s.0[(i + 1) % n];
///         }
///     }
/// }
/// let spins = |count: i32| Covector((0..count).map(|i| Vector3::new(1.0, f64::from(i), -2.0)).collect());
/// laws::sites_hamiltonian::<So3, _>(&Ring, &[spins(1), spins(2), spins(40)])?.check(1e-15)?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn sites_hamiltonian<A, H>(hamiltonian: &H, samples: &[Momenta<A>]) -> Result<Report, NoSamples>
where
    A: LieAlgebra,
    H: SitesHamiltonian<A::Element<f64>> + SitesHamiltonian<A::Element<DualNumber>>,
{
    if samples.is_empty() {
        return Err(NoSamples { what: "momenta" });
    }
    let mut report = Report::default();
    for sample in samples {
        for scale in [0.0, NEAR, 1.0] {
            let mut mu = sample.clone();
            mu.scale_in_place(scale);
            if scale == 1.0 || hamiltonian.value(&mu).is_finite() {
                differential_of_sites::<A, H>(hamiltonian, &mu, "differential", &mut report);
            }
        }
        let mut more = sample.0.clone().into_inner();
        more.push(sample.0.first().copied().unwrap_or_else(Vector::zero));
        let more = Covector(Sites::new(more));
        let law = "number of sites";
        let value: f64 = hamiltonian.value(&more);
        if value.is_nan() {
            let dh = written(hamiltonian, &more, 0.0);
            let numbers = (0..dh.dimension()).filter(|&i| !dh.coordinate(i).is_nan()).count();
            report.note(law, numbers as f64, 1.0);
        } else {
            differential_of_sites::<A, H>(hamiltonian, &more, law, &mut report);
        }
    }
    Ok(report)
}

/// Returns dh, written to an element whose coordinates were all equal.
fn written<V: Vector>(
    hamiltonian: &impl SitesHamiltonian<V>,
    mu: &Covector<Sites<V>>,
    before: V::Scalar,
) -> Sites<V> {
    let mut dh = mu.0.zeros_like();
    dh.set_coordinates(|_| before);
    hamiltonian.differential_into(mu, &mut dh);
    dh
}

fn differential_of_sites<A, H>(
    hamiltonian: &H,
    mu: &Momenta<A>,
    law: &'static str,
    report: &mut Report,
) where
    A: LieAlgebra,
    H: SitesHamiltonian<A::Element<f64>> + SitesHamiltonian<A::Element<DualNumber>>,
{
    let slope = |i: usize| {
        let mut seeded = Momenta::<A, DualNumber>::zeros_of(&mu.shape());
        seeded
            .set_coordinates(|j| DualNumber::new(mu.coordinate(j), if i == j { 1.0 } else { 0.0 }));
        hamiltonian.value(&seeded).derivative()
    };
    let exact: Vec<f64> = (0..mu.dimension()).map(slope).collect();
    let size = exact.iter().fold(SMALLEST, |size, x| larger(size, x.abs()));
    for before in [0.0, f64::NAN] {
        let dh = written(hamiltonian, mu, before);
        let errors = exact.iter().enumerate().map(|(i, x)| (dh.coordinate(i) - x).abs());
        report.note(law, errors.fold(0.0, larger), size);
    }
}

/// The fault can be in the method [`differential_into`](SitesHamiltonian::differential_into).
impl<V: Vector, H: SitesHamiltonian<V>> SitesHamiltonian<V> for Faulty<'_, H> {
    fn value(&self, mu: &Covector<Sites<V>>) -> V::Scalar {
        self.object().value(mu)
    }

    fn differential_into(&self, mu: &Covector<Sites<V>>, dh: &mut Sites<V>) {
        self.object().differential_into(mu, dh);
        self.halve("differential_into", dh);
    }
}
