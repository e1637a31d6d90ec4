//! Laws of equations of motion, for which the crates below have no suite of their own: the fields of the gallery are the
//! Hamiltonian vector fields of their energies.

use crate::law_samples::Spins;
use lie_poisson_systems::collective_integrators::VectorField;
use lie_poisson_systems::isospectral_flows::{IsospectralField, LargeSkewHermitian};
use lie_poisson_systems::lie_poisson::laws::{Faulty, NoSamples, Report, regimes};
use lie_poisson_systems::lie_poisson::{
    Covector, Differential, Hamiltonian, LiePoisson, Point, PoissonSpace, SitesHamiltonian, So3,
    State, Vector, larger,
};
use lie_poisson_systems::nalgebra::Vector3;

/// A size below which nothing is compared.
const SMALLEST: f64 = 1e-300;

/// The factors of the samples: at zero, near it, and as they are.
const FACTORS: [f64; 3] = [0.0, 1e-8, 1.0];

/// Evaluates the law `rate` of a vector field on (so(3)∗)ᴺ: the rate at each site is the Hamiltonian vector of dh there.
/// Its method `at` may have the fault.
pub fn sites_field<F>(
    field: &Faulty<'_, F>,
    space: LiePoisson<So3>,
    samples: &[Spins],
) -> Result<Report, NoSamples>
where
    F: SitesHamiltonian<Vector3<f64>> + VectorField<Point = Spins>,
{
    let mut report = Report::default();
    for sample in samples {
        for factor in FACTORS {
            let mut mu = sample.clone();
            mu.scale_in_place(factor);
            let (mut dh, mut rate) =
                (mu.0.zeros_like(), field.halved("at", field.object().at(&mu)));
            field.object().differential_into(&mu, &mut dh);
            for ((mu, dh), rate) in mu.0.iter().zip(dh.iter()).zip(rate.0.iter_mut()) {
                *rate -= space.hamiltonian_vector::<f64>(&Covector(*mu), dh).0;
                report.note("rate", rate.amax(), larger(mu.amax() * dh.amax(), SMALLEST));
            }
        }
    }
    if samples.is_empty() { Err(NoSamples { what: "momenta" }) } else { Ok(report) }
}

/// Evaluates the law `generator` of an isospectral equation whose energy is a polynomial of degree 2: B = c dh in the
/// scalar product −tr(V W), with the given c. Its method `generator_into` may have the fault.
///
/// The differential is by central differences, which are exact for such a polynomial. Their width is the size of W, so that
/// no term is lost among the others, or the given unit if that is larger, for energies with a linear term.
pub fn generator<F: IsospectralField>(
    field: &Faulty<'_, F>,
    energy: impl Fn(&LargeSkewHermitian) -> f64,
    (c, unit): (f64, f64),
    samples: &[LargeSkewHermitian],
) -> Result<Report, NoSamples> {
    let mut report = Report::default();
    for sample in samples {
        for factor in FACTORS {
            let mut w = sample.clone();
            w.scale_in_place(factor);
            let mut b = w.zeros_like();
            field.object().generator_into(&w, &mut b);
            field.halve("generator_into", &mut b);
            let (mut pairs, mut size) = (Vec::new(), SMALLEST);
            for i in 0..w.dimension() {
                let mut v = w.zeros_like();
                v.set_coordinate(i, larger(w.norm(), unit));
                let [after, before] = [1.0, -1.0].map(|sign| c * energy(&moved(&w, sign, &v)));
                size = larger(size, larger(after.abs(), before.abs()));
                pairs.push((b.scalar_product(&v), 0.5 * (after - before)));
            }
            pairs.iter().for_each(|(b, slope)| report.note("generator", (b - slope).abs(), size));
        }
    }
    if samples.is_empty() { Err(NoSamples { what: "matrices" }) } else { Ok(report) }
}

/// Returns W + s V.
fn moved(w: &LargeSkewHermitian, s: f64, v: &LargeSkewHermitian) -> LargeSkewHermitian {
    let mut moved = w.clone();
    moved.add_multiple(s, v);
    moved
}

/// The width of the central differences of [`differences`], the cube root of the round-off. Its square, times the third
/// derivatives, and the round-off over the width are their error.
const WIDTH: f64 = 6e-6;

/// Evaluates the law `difference quotient` of a Hamiltonian: its differential is that by central differences, to some 10⁻¹⁰.
///
/// Unlike [`hamiltonian`](lie_poisson_systems::lie_poisson::laws::hamiltonian) it is independent of dual numbers, by which
/// [`Automatic`](lie_poisson_systems::lie_poisson::Automatic) differentiates.
pub fn differences<P: PoissonSpace, H: Hamiltonian<P>>(
    hamiltonian: &H,
    samples: &[Point<P>],
) -> Result<Report, NoSamples> {
    let mut report = Report::default();
    for z in regimes("points", samples)? {
        let claimed: Differential<P> = hamiltonian.differential(&z);
        for i in 0..Point::<P>::DIM {
            let along: Point<P> = Vector::basis(i);
            let at = |shift: f64| hamiltonian.value(&(z + along.scaled(shift)));
            let slope = (at(WIDTH) - at(-WIDTH)) / (2.0 * WIDTH);
            report.note("difference quotient", (claimed.coordinate(i) - slope).abs(), 1.0);
        }
    }
    Ok(report)
}
