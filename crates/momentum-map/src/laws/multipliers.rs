//! The law suite of [`Multipliers`].

use super::{NoSamples, Report, regimes};
use crate::multipliers::multiplier::{Multiplier, Multipliers};
use lie_poisson::{
    Differential, DualNumber, Point, PoissonSpace, Vector, derivative_part, map_coordinates, seed,
};

/// Evaluates the laws of multipliers on samples of multipliers, of differentials ξ and of momenta:
///
/// * `identity`: 1 is neutral, carries μ to μ, and changes nothing;
/// * `associativity`: (QB)C = Q(BC);
/// * `left multiplication`: ξ(QB) = (ξQ)B;
/// * `action`: transport(QB, μ) = transport(Q, transport(B, μ));
/// * `motion`: d/ds transport(exp(sξ), μ) = Λ(μ) ξ at s = 0, the Hamiltonian vector of ξ;
/// * `inverse`: U⁻¹U = UU⁻¹ = 1 for U = exp ξ, which satisfies the quadratic
///   invariants;
/// * `coadjoint change`: the change by U = exp ξ is transport(U, μ) − μ.
///
/// # Errors
/// Returns [`NoSamples`] if one of the lists of samples is empty.
///
/// # Example
/// ```
/// use lie_poisson::{Covector, Quaternion, nalgebra::Vector3};
/// use momentum_map::{Quaternions, laws};
/// let (v, w) = (Vector3::new(1.0, -2.0, 0.5), Vector3::new(0.3, 0.8, -1.0));
/// let q = [Quaternion { scalar: 0.4, vector: v }, Quaternion { scalar: -1.2, vector: w }];
/// laws::multipliers(&Quaternions, &q, &[v, w], &[Covector(v), Covector(w)])?.check(1e-13)?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn multipliers<M: Multipliers>(
    multipliers: &M,
    samples: &[Multiplier<M>],
    differentials: &[Differential<M::Space>],
    momenta: &[Point<M::Space>],
) -> Result<Report, NoSamples> {
    let (elements, momenta) = (regimes("multipliers", samples)?, regimes("momenta", momenta)?);
    let differentials = regimes("differentials", differentials)?;
    let mut report = Report::default();
    for q in &elements {
        algebra(multipliers, &mut report, q, &elements);
        for b in &elements {
            let product = multipliers.product::<f64>(q, b);
            let size = q.max_abs() * b.max_abs();
            for xi in &differentials {
                let whole = multipliers.generate::<f64>(xi, &product);
                let left = multipliers.product::<f64>(&multipliers.generate::<f64>(xi, q), b);
                report.note("left multiplication", (whole - left).max_abs(), size * xi.max_abs());
            }
            for mu in &momenta {
                let once = multipliers.transport::<f64>(&product, mu);
                let moved = multipliers.transport::<f64>(b, mu);
                let twice = multipliers.transport::<f64>(q, &moved);
                report.note("action", (once - twice).max_abs(), size * size * mu.max_abs());
            }
        }
    }
    for xi in &differentials {
        motion(multipliers, &mut report, xi, &momenta);
        of_exponentials(multipliers, &mut report, xi, &momenta);
    }
    Ok(report)
}

/// Evaluates the laws `identity` and `associativity`.
fn algebra<M: Multipliers>(
    multipliers: &M,
    report: &mut Report,
    q: &Multiplier<M>,
    elements: &[Multiplier<M>],
) {
    let product = |q: &Multiplier<M>, b: &Multiplier<M>| multipliers.product::<f64>(q, b);
    let one = multipliers.one::<f64>();
    report.note("identity", (product(q, &one) - *q).max_abs(), q.max_abs());
    report.note("identity", (product(&one, q) - *q).max_abs(), q.max_abs());
    for b in elements {
        for c in elements {
            let difference = product(&product(q, b), c) - product(q, &product(b, c));
            let size = q.max_abs() * b.max_abs() * c.max_abs();
            report.note("associativity", difference.max_abs(), size);
        }
    }
}

/// Evaluates the laws `motion`, and `identity` for momenta.
fn motion<M: Multipliers>(
    multipliers: &M,
    report: &mut Report,
    xi: &Differential<M::Space>,
    momenta: &[Point<M::Space>],
) {
    let one = multipliers.one::<f64>();
    let generated = multipliers.generate::<f64>(xi, &one);
    for mu in momenta {
        let still = multipliers.transport::<f64>(&one, mu) - *mu;
        report.note("identity", still.max_abs(), mu.max_abs());
        let change = multipliers.coadjoint_change::<f64>(&one, mu);
        report.note("identity", change.max_abs(), mu.max_abs());
        let constant: Point<M::Space, DualNumber> = map_coordinates(mu, DualNumber::constant);
        let moved = multipliers.transport::<DualNumber>(&seed(&one, &generated), &constant);
        let velocity: Point<M::Space> = derivative_part(&moved);
        let vector = multipliers.space().hamiltonian_vector::<f64>(mu, xi);
        report.note("motion", (velocity - vector).max_abs(), xi.max_abs() * mu.max_abs());
    }
}

/// Evaluates the laws `inverse` and `coadjoint change`.
fn of_exponentials<M: Multipliers>(
    multipliers: &M,
    report: &mut Report,
    xi: &Differential<M::Space>,
    momenta: &[Point<M::Space>],
) {
    let (u, one) = (exponential(multipliers, xi), multipliers.one::<f64>());
    let inverse = multipliers.inverse::<f64>(&u);
    let size = u.max_abs() * inverse.max_abs();
    for product in [(&u, &inverse), (&inverse, &u)] {
        let product = multipliers.product::<f64>(product.0, product.1);
        report.note("inverse", (product - one).max_abs(), size);
    }
    for mu in momenta {
        let difference = multipliers.transport::<f64>(&u, mu) - *mu;
        let change = multipliers.coadjoint_change::<f64>(&u, mu);
        let size = u.max_abs() * u.max_abs() * mu.max_abs();
        report.note("coadjoint change", (change - difference).max_abs(), size);
    }
}

/// Returns exp ξ, by its series for ξ/2ᵐ, squared m times.
fn exponential<M: Multipliers>(multipliers: &M, xi: &Differential<M::Space>) -> Multiplier<M> {
    let one = multipliers.one::<f64>();
    let size = multipliers.generate::<f64>(xi, &one).max_abs() * Multiplier::<M>::DIM as f64;
    let halvings = if size > 1.0 { size.log2().ceil().min(1000.0) } else { 0.0 };
    let small = xi.scaled((-halvings).exp2());
    let (mut term, mut sum) = (one, one);
    // 20 terms suffice: 1/20! < 2⁻⁶⁰.
    for k in 1..20 {
        term = multipliers.generate::<f64>(&small, &term).scaled(1.0 / f64::from(k));
        sum += term;
    }
    (0..halvings as usize).fold(sum, |u, _| multipliers.product::<f64>(&u, &u))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::multipliers::quaternions::Quaternions;
    use nalgebra::Vector3;

    /// The series is summed for a small vector, however large the turn is.
    #[test]
    fn exponentials_of_large_turns_are_unit_quaternions() {
        for angle in [0.0, 1e-9, 0.7, 3.0, 10.0, 100.0] {
            let turn = exponential(&Quaternions, &(Vector3::new(0.48, 0.6, 0.64) * angle));
            // Up to nine squarings, each of which doubles the error.
            assert!((turn.norm_squared() - 1.0).abs() < 1e-12, "{angle}: {turn:?}");
        }
    }
}
