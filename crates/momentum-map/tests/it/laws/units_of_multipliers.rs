//! The units of the residuals of multipliers: a fault of known size has a known residual, whatever the size of the
//! multipliers and momenta.

use crate::support::{holds, laws};
use lie_poisson::{Covector, LiePoisson, Real, StructureConstants};
use momentum_map::Multipliers;
use nalgebra::Vector1;

/// The multipliers eˣ of a line, whose bracket is zero, with faults: `inverse` is the relative error of inverses, and
/// `change · μ` is added to the coadjoint change, which should be zero.
#[derive(Clone)]
struct Line {
    algebra: StructureConstants<1>,
    inverse: f64,
    change: f64,
}

impl Line {
    fn new(inverse: f64, change: f64) -> Self {
        Self { algebra: StructureConstants::new(|_, _, _| 0.0).unwrap(), inverse, change }
    }
}

impl Multipliers for Line {
    type Space = LiePoisson<StructureConstants<1>>;
    type Multiplier<T: Real> = Vector1<T>;
    fn space(&self) -> Self::Space {
        LiePoisson::minus(self.algebra.clone())
    }
    fn one<T: Real>(&self) -> Vector1<T> {
        Vector1::new(T::one())
    }
    fn generate<T: Real>(&self, xi: &Vector1<T>, q: &Vector1<T>) -> Vector1<T> {
        Vector1::new(xi.x * q.x)
    }
    fn transport<T: Real>(
        &self,
        _: &Vector1<T>,
        mu: &Covector<Vector1<T>>,
    ) -> Covector<Vector1<T>> {
        *mu
    }
    fn coadjoint_change<T: Real>(
        &self,
        _: &Vector1<T>,
        mu: &Covector<Vector1<T>>,
    ) -> Covector<Vector1<T>> {
        Covector(mu.0 * T::from_f64(self.change))
    }
    fn product<T: Real>(&self, q: &Vector1<T>, b: &Vector1<T>) -> Vector1<T> {
        Vector1::new(q.x * b.x)
    }
    fn inverse<T: Real>(&self, b: &Vector1<T>) -> Vector1<T> {
        Vector1::new(T::from_f64(1.0 + self.inverse) / b.x)
    }
}

fn report(line: &Line, x: f64, mu: f64) -> laws::Report {
    let vector = Vector1::new;
    laws::multipliers(line, &[vector(0.7)], &[vector(x)], &[Covector(vector(mu))]).unwrap()
}

/// U⁻¹U − 1 is measured by |U||U⁻¹|, and the change of μ by |U|²|μ|. The suite also takes U near 1, where both units are
/// smaller than for a large U, and larger than for a small one.
#[test]
fn faults_of_known_size_have_known_residuals() {
    for mu in [2e-20, 2.0, 2e20] {
        for x in [-9.0, -3.0, 3.0, 9.0_f64] {
            let is = |law: &str, fault: Line, expected: f64| {
                let residual = report(&fault, x, mu).residual(law).unwrap();
                // The exponential is a series that is squared up to four times, which multiplies its rounding error by
                // up to sixteen.
                assert!(
                    (residual / expected - 1.0).abs() < 1e-13,
                    "{law} {x} {mu:e}: {residual:e}"
                );
            };
            is("inverse", Line::new(0.25, 0.0), 0.25 / 1.25);
            is("coadjoint change", Line::new(0.0, 0.25), 0.25 * (-2.0 * x).exp().max(1.0));
            // Control: without a fault the laws hold.
            holds(report(&Line::new(0.0, 0.0), x, mu));
        }
    }
}
