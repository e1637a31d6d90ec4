//! The law suites of [`LieGroup`] and [`Cayley`].

use super::{NoSamples, Report, regimes};
use crate::algebras::algebra::LieAlgebra;
use crate::algebras::group::{AlgebraElement, GroupMomentum, LieGroup};
use crate::cayley::Cayley;
use generic_scalars::{DualNumber, Vector, derivative_part, map_coordinates};

type Dual<G> = AlgebraElement<G, DualNumber>;

/// Returns sξ for the dual number s = 0 + ε.
fn along<G: LieGroup>(xi: &AlgebraElement<G>) -> Dual<G> {
    map_coordinates(xi, |x| DualNumber::new(0.0, x))
}

/// Returns sξ for s = 0 + ε + ε′, where the coefficient of εε′ gives second derivatives.
fn along_twice<G: LieGroup>(xi: &AlgebraElement<G>) -> AlgebraElement<G, DualNumber<DualNumber>> {
    map_coordinates(xi, |x| DualNumber::new(DualNumber::new(0.0, x), DualNumber::constant(x)))
}

/// Evaluates the laws of a Lie group on samples of its algebra, with group elements made by exp:
///
/// * `identity`, `inverse`, `associativity`;
/// * `one-parameter group` exp(2ξ) = exp(ξ)², and `exp is Ad-equivariant` g exp(η) g⁻¹ = exp(Ad_g η);
/// * `Ad is a homomorphism`, `Ad preserves brackets`, `ad is the derivative of Ad`;
/// * `Ad* is the transpose of Ad`.
///
/// # Errors
/// Returns [`NoSamples`] if there are no samples.
pub fn lie_group<G: LieGroup>(
    group: &G,
    samples: &[AlgebraElement<G>],
) -> Result<Report, NoSamples> {
    let elements = regimes("algebra elements", samples)?;
    let mut report = Report::default();
    let e = group.identity::<f64>();
    let exp = |xi: &AlgebraElement<G>| group.exp::<f64>(xi);
    let product = |g: &G::Element<f64>, h: &G::Element<f64>| group.compose::<f64>(g, h);
    for xi in &elements {
        let (g, back) = (exp(xi), group.inverse::<f64>(&exp(xi)));
        let size = g.max_abs().max(1.0) * back.max_abs().max(1.0);
        report.note("identity", (product(&g, &e) - g).max_abs(), size);
        report.note("identity", (product(&e, &g) - g).max_abs(), size);
        report.note("inverse", (product(&g, &back) - e).max_abs(), size);
        report.note("inverse", (product(&back, &g) - e).max_abs(), size);
        let twice = exp(&xi.scaled(2.0)) - product(&g, &g);
        report.note("one-parameter group", twice.max_abs(), size * size);
        for eta in &elements {
            let h = exp(eta);
            let scale = size * size * h.max_abs().max(1.0);
            let moved = group.adjoint::<f64>(&g, eta);
            let conjugate = product(&product(&g, &h), &back) - exp(&moved);
            report.note(
                "exp is Ad-equivariant",
                conjugate.max_abs(),
                scale * (1.0 + eta.max_abs()),
            );
            for zeta in samples {
                two_elements(group, &mut report, (&g, &h), (eta, zeta), scale);
            }
            let slope: AlgebraElement<G> = derivative_part(&group.adjoint::<DualNumber>(
                &group.exp::<DualNumber>(&along::<G>(xi)),
                &map_coordinates(eta, DualNumber::constant),
            ));
            let ad = group.algebra().bracket::<f64>(xi, eta);
            let law = "ad is the derivative of Ad";
            report.note(law, (slope - ad).max_abs(), xi.max_abs() * eta.max_abs());
        }
    }
    Ok(report)
}

fn two_elements<G: LieGroup>(
    group: &G,
    report: &mut Report,
    (g, h): (&G::Element<f64>, &G::Element<f64>),
    (eta, zeta): (&AlgebraElement<G>, &AlgebraElement<G>),
    scale: f64,
) {
    let ad = |g: &G::Element<f64>, xi: &AlgebraElement<G>| group.adjoint::<f64>(g, xi);
    let algebra = group.algebra();
    let k = group.exp::<f64>(zeta);
    let gh = group.compose::<f64>(g, h);
    let left = group.compose::<f64>(&gh, &k);
    let right = group.compose::<f64>(g, &group.compose::<f64>(h, &k));
    report.note("associativity", (left - right).max_abs(), scale * k.max_abs().max(1.0));
    let twice = ad(&gh, zeta) - ad(g, &ad(h, zeta));
    let size = scale * scale * zeta.max_abs();
    report.note("Ad is a homomorphism", twice.max_abs(), size);
    let moved = algebra.bracket::<f64>(&ad(g, eta), &ad(g, zeta));
    let brackets = moved - ad(g, &algebra.bracket::<f64>(eta, zeta));
    report.note("Ad preserves brackets", brackets.max_abs(), size * eta.max_abs());
    let mu: GroupMomentum<G> = map_coordinates(zeta, |x| x);
    let pairing = group.coadjoint::<f64>(g, &mu).pairing(eta) - mu.pairing(&ad(g, eta));
    report.note("Ad* is the transpose of Ad", pairing.abs(), size * eta.max_abs());
}

/// Evaluates the laws `cay agrees with exp to second order` and `cay(−ξ) is the inverse` on samples of the
/// algebra.
///
/// # Errors
/// Returns [`NoSamples`] if there are no samples.
pub fn cayley<G: Cayley>(group: &G, samples: &[AlgebraElement<G>]) -> Result<Report, NoSamples> {
    let mut report = Report::default();
    for xi in regimes("algebra elements", samples)? {
        let (cay, exp) = (
            group.cayley::<DualNumber<DualNumber>>(&along_twice::<G>(&xi)),
            group.exp::<DualNumber<DualNumber>>(&along_twice::<G>(&xi)),
        );
        let law = "cay agrees with exp to second order";
        let size = xi.max_abs().max(1.0);
        report.note(law, (cay - exp).max_abs(), size * size);
        let (there, back) = (group.cayley::<f64>(&xi), group.cayley::<f64>(&-xi));
        let product = group.compose::<f64>(&there, &back) - group.identity::<f64>();
        report.note("cay(−ξ) is the inverse", product.max_abs(), there.max_abs() * back.max_abs());
    }
    Ok(report)
}
