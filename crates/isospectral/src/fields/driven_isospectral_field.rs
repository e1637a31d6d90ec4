//! Equations with the time in them that conserve the spectrum of a matrix: [`DrivenIsospectralField`].

use crate::fields::isospectral_field::IsospectralField;
use crate::matrices::skew_hermitian::LargeSkewHermitian;
use lie_poisson::{Controlled, Inputs, State, nearest_break};

/// An isospectral equation whose generator depends on the time, too,
///
/// ```text
/// dW/dt = [B(W, t), W],    B(W, t) ∈ u(N)
/// ```
///
/// such as that of a Hamiltonian h(W, t), of inputs or a control law, or of [damping](crate::IsospectralDoubleBracket). The spectrum is
/// conserved for every B. An equation without the time, an [`IsospectralField`], is one of them; [`Inputs`] u_i along matrices Ξ_i
/// are the field Σ_i u_i(t) Ξ_i; and a sum of two fields is [`Controlled`].
///
/// # Example
/// A pulse of one unit of time that turns W by Ξ: W(3) = exp(2Ξ) W(0) exp(−2Ξ).
/// ```
/// use collective_integrators::{BrownianPaths, RungeKutta, Start};
/// use isospectral_flows::{LargeSkewHermitian, NoisyIsospectral};
/// use lie_poisson::{InputTable, Inputs, Interpolation, Pair, PathNumber, Time};
/// use num_complex::Complex;
/// let xi = LargeSkewHermitian::from_upper(2, |j, k| Complex::new(0.0, if j == k { 0.5 - j as f64 } else { 0.0 }));
/// let pulse = InputTable::new(vec![0.0, 1.25, 2.25, 9.0], vec![0.0, 2.0, 0.0, 0.0], Interpolation::Constant)?;
/// let paths = BrownianPaths::new(1, 0.1)?; // the steps are intervals; there is no noise
/// let inputs = Inputs::new(vec![(xi, pulse)])?;
/// let driven = NoisyIsospectral::new(RungeKutta::gauss(2)?, inputs, Vec::new(), paths);
/// let w = LargeSkewHermitian::from_upper(2, |_, k| Complex::new(k as f64, 0.0));
/// let end = driven.after(&Pair(w, Pair(PathNumber(0.0), Time(0.0))), 0.1, 30)?.momentum.0;
/// assert!((end.at(0, 1) - Complex::from_polar(1.0, 2.0)).norm() < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait DrivenIsospectralField {
    /// Returns the size N.
    fn size(&self) -> usize;

    /// Writes the generator B(W, t). The matrix `generator` has the size N, and its previous entries are arbitrary.
    fn generator_at_into(
        &self,
        w: &LargeSkewHermitian,
        time: f64,
        generator: &mut LargeSkewHermitian,
    );

    /// Returns the next time strictly after `time`, or strictly before it if `forward` is false, at which B or a derivative of it
    /// jumps; there is none by default. A step is divided there.
    fn next_break(&self, time: f64, forward: bool) -> Option<f64> {
        let (_, _) = (time, forward);
        None
    }
}

impl<F: IsospectralField> DrivenIsospectralField for F {
    fn size(&self) -> usize {
        IsospectralField::size(self)
    }

    fn generator_at_into(
        &self,
        w: &LargeSkewHermitian,
        _: f64,
        generator: &mut LargeSkewHermitian,
    ) {
        self.generator_into(w, generator);
    }
}

/// The field Σ_i u_i(t) Ξ_i of inputs. It is NaN if a matrix has another size than the first one.
impl DrivenIsospectralField for Inputs<LargeSkewHermitian> {
    fn size(&self) -> usize {
        self.iter().next().map_or(0, |(xi, _)| xi.size())
    }

    fn generator_at_into(
        &self,
        _: &LargeSkewHermitian,
        time: f64,
        generator: &mut LargeSkewHermitian,
    ) {
        generator.set_zero();
        for (xi, input) in self.iter() {
            match xi.size() == generator.size() {
                true => generator.add_multiple(input.at(time), xi),
                false => return generator.scale_in_place(f64::NAN),
            }
        }
    }

    fn next_break(&self, time: f64, forward: bool) -> Option<f64> {
        Self::next_break(self, time, forward)
    }
}

impl<X: DrivenIsospectralField, U: DrivenIsospectralField> DrivenIsospectralField
    for Controlled<X, U>
{
    fn size(&self) -> usize {
        self.field.size()
    }

    fn generator_at_into(
        &self,
        w: &LargeSkewHermitian,
        time: f64,
        generator: &mut LargeSkewHermitian,
    ) {
        let mut control = generator.zeros_like();
        self.field.generator_at_into(w, time, generator);
        self.control.generator_at_into(w, time, &mut control);
        generator.add_in_place(&control);
    }

    fn next_break(&self, time: f64, forward: bool) -> Option<f64> {
        let [field, control] =
            [self.field.next_break(time, forward), self.control.next_break(time, forward)];
        nearest_break(field, control, forward)
    }
}
