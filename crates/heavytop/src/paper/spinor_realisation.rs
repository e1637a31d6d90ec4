//! The realisation M = ϖ ∘ L: T∗C² → se(3)∗: [`SpinorRealisation`].

use lie_poisson::{
    ComplexSpace, Covector, LiePoisson, Mask, Pair, Real, SO3OnR3, Se3, Se3Dual, SemidirectAlgebra,
    Vector, euclidean_norm, nearest_power_of_two, squaring_scale,
};
use momentum_map::{
    Cotangent, CotangentBundle, FibreSymmetry, Lift, LiftError, PoissonMap, RecentringWorkspace,
    hopf_map, hopf_pull_back, hopf_section, pauli,
};
use nalgebra::{Vector2, Vector3};
use num_complex::Complex;

/// A point (χ, ψ) ∈ T∗C² ≅ T∗R⁴, χ = (q₁+iq₂, q₃+iq₄) and ψ = (p₁+ip₂, p₃+ip₄).
pub type SpinorPoint<T = f64> = Cotangent<Vector2<Complex<T>>>;

/// The Poisson map M = ϖ ∘ L from T∗C² to se(3)∗ with the minus bracket, in closed form:
///
/// ```text
/// Π = ½ ( −Im(χ₁ψ₂* + χ₂ψ₁*), Re(χ₂ψ₁* − χ₁ψ₂*), Im(χ₂ψ₂* − χ₁ψ₁*) )
/// Γ = ( 2 Re ψ₁*ψ₂, 2 Im ψ₁*ψ₂, |ψ₁|² − |ψ₂|² )
/// ```
///
/// Its generator for (Ω, γ) = dh(Π, Γ) gives collective dynamics without a Jacobian:
///
/// ```text
/// dχ/dt = (i/2)(Ω·σ) χ + 2 (γ·σ) ψ,    dψ/dt = (i/2)(Ω·σ) ψ
/// ```
///
/// The fibre through (χ, ψ), ψ ≠ 0, consists of the points (exp(iθ)(χ + bψ), exp(iθ)ψ). It is the orbit of two
/// one-parameter groups, index 0 for b with momentum J₁ = ‖ψ‖²/2 and index 1 for θ with J₂ = −Im(ψ∗χ). The
/// Casimirs are f₁ = |Γ|² = 4J₁² and f₂ = Π·Γ = J₁J₂.
///
/// Source: Ohsawa 2019, eq. (4.1) in its complex form (the real form has Γ misprinted), Cor. 3.2,
/// §4.2.
///
/// # Example
/// ```
/// use heavytop::SpinorRealisation;
/// use lie_poisson::Se3Dual;
/// use momentum_map::{Lift, PoissonMap};
/// use nalgebra::Vector3;
/// let mu = Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::new(0.0, 0.0, -1.0));
/// let z = SpinorRealisation.lift(&mu)?;
/// assert!(((SpinorRealisation.apply(&z) - mu).0.0).norm() < 1e-14);
/// # Ok::<(), momentum_map::LiftError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SpinorRealisation;

impl PoissonMap for SpinorRealisation {
    type Source = CotangentBundle<ComplexSpace<2>>;
    type Target = LiePoisson<Se3>;

    fn source(&self) -> Self::Source {
        CotangentBundle(ComplexSpace)
    }

    fn target(&self) -> Self::Target {
        LiePoisson::minus(SemidirectAlgebra(SO3OnR3))
    }

    #[cfg_attr(optimised, inline(always))]
    fn apply<T: Real>(&self, z: &SpinorPoint<T>) -> Se3Dual<T> {
        if T::HAS_SLOW_PATHS { momentum(z) } else { inlined_momentum(z) }
    }

    #[cfg_attr(optimised, inline(always))]
    fn generator<T: Real>(
        &self,
        dh: &Pair<Vector3<T>, Vector3<T>>,
        z: &SpinorPoint<T>,
    ) -> SpinorPoint<T> {
        if T::HAS_SLOW_PATHS { velocity(dh, z) } else { inlined_velocity(dh, z) }
    }

    /// Returns the slide (bψ, 0) along the fibre if ‖χ‖ has grown beyond √2 times its minimum on the line χ + bψ, and 0
    /// otherwise.
    ///
    /// The number b is the power of two next to −Re(ψ∗χ)/‖ψ‖², so that bψ is not rounded. The slide leaves at most a
    /// third of Re(ψ∗χ).
    ///
    /// Along collective dynamics d/dt Re(ψ∗χ) = 2γ·Γ, so that χ may grow linearly along ψ. A slide breaks the sequence
    /// of stages from which a scheme extrapolates the next ones ([`StageSolver`](collective_integrators::StageSolver)).
    /// It is therefore made only if ‖χ‖ has grown.
    #[cfg_attr(optimised, inline(always))]
    fn gauge<T: Real>(&self, z: &SpinorPoint<T>) -> SpinorPoint<T> {
        let (chi, psi) = (&z.q, &z.p.0);
        let overlap = (psi.x.conj() * chi.x + psi.y.conj() * chi.y).re;
        let square = psi.x.norm_sqr() + psi.y.norm_sqr();
        let least = (chi.x.norm_sqr() + chi.y.norm_sqr()) * square - overlap * overlap;
        let short = (overlap * overlap).at_most(least);
        // For ψ = 0 the fibre is not a line, and z stays.
        let line = (overlap / square).magnitude().at_most(T::from_f64(LONGEST));
        let along =
            T::select(line.and(short.not()), nearest_power_of_two(-overlap / square), T::zero());
        let slide = Vector2::new(psi.x.scale(along), psi.y.scale(along));
        Cotangent { q: slide, ..Vector::zero() }
    }

    /// Returns z, since the [gauge](Self::gauge) keeps ‖χ‖ within √2 times its minimum.
    #[cfg_attr(optimised, inline(always))]
    fn recentred<T: Real>(
        &self,
        z: &SpinorPoint<T>,
        _: &mut RecentringWorkspace<T>,
    ) -> SpinorPoint<T> {
        *z
    }
}

// What the formulas for wide registers call stands in functions with their attribute, since the operators of other crates have none.

/// Returns sv.
#[cfg_attr(optimised, inline(always))]
fn multiple<T: Real>(v: &Vector3<T>, s: T) -> Vector3<T> {
    Vector3::new(v.x * s, v.y * s, v.z * s)
}

/// Returns a∗b.
#[cfg_attr(optimised, inline(always))]
fn overlap<T: Real>(a: &Complex<T>, b: &Complex<T>) -> Complex<T> {
    Complex { re: a.re * b.re + a.im * b.im, im: a.re * b.im - a.im * b.re }
}

/// Returns i (v·σ) ζ.
#[cfg_attr(optimised, inline(always))]
fn turned<T: Real>(v: &Vector3<T>, zeta: &Vector2<Complex<T>>) -> Vector2<Complex<T>> {
    let moved = pauli(v, zeta);
    Vector2::new(
        Complex { re: -moved.x.im, im: moved.x.re },
        Complex { re: -moved.y.im, im: moved.y.re },
    )
}

/// Returns ζ + η.
#[cfg_attr(optimised, inline(always))]
fn sum<T: Real>(zeta: &Vector2<Complex<T>>, eta: &Vector2<Complex<T>>) -> Vector2<Complex<T>> {
    Vector2::new(
        Complex { re: zeta.x.re + eta.x.re, im: zeta.x.im + eta.x.im },
        Complex { re: zeta.y.re + eta.y.re, im: zeta.y.im + eta.y.im },
    )
}

/// Defines M(z) and its generator with an attribute.
macro_rules! formulas {
    (#[$attribute:meta] $momentum:ident, $velocity:ident) => {
        #[$attribute]
        fn $momentum<T: Real>(z: &SpinorPoint<T>) -> Se3Dual<T> {
            let (chi, psi) = (&z.q, &z.p.0);
            let (a, b) = (overlap(&psi.y, &chi.x), overlap(&psi.x, &chi.y));
            let (c, d) = (overlap(&psi.x, &chi.x), overlap(&psi.y, &chi.y));
            let pi = Vector3::new(-(a.im + b.im), b.re - a.re, d.im - c.im);
            Se3Dual::new(multiple(&pi, T::from_f64(0.5)), hopf_map(psi))
        }

        #[$attribute]
        fn $velocity<T: Real>(
            Pair(omega, gamma): &Pair<Vector3<T>, Vector3<T>>,
            z: &SpinorPoint<T>,
        ) -> SpinorPoint<T> {
            let (chi, psi) = (&z.q, &z.p.0);
            let half = multiple(omega, T::from_f64(0.5));
            let (chi, moved) = (turned(&half, chi), hopf_pull_back(gamma, psi));
            Cotangent::new(sum(&chi, &moved), Covector(turned(&half, psi)))
        }
    };
}
// The compiler simplifies these two before it inlines them, with fewer instructions for plain numbers.
formulas! { #[inline] momentum, velocity }
// Wide registers need these two.
formulas! { #[cfg_attr(optimised, inline(always))] inlined_momentum, inlined_velocity }

/// The largest b of a slide χ + bψ; a longer slide is not made.
const LONGEST: f64 = 1e100;

impl Lift for SpinorRealisation {
    /// Returns the lift of least norm.
    ///
    /// The spinor ψ is a section of the Hopf fibration with two charts, and
    ///
    /// ```text
    /// q = (4/‖p‖²) A(p)ᵀ Π,    ⟨p, q⟩ = 0
    /// ```
    ///
    /// where Π = A(p) q and A Aᵀ = (‖p‖²/4) I; in complex form χ = −(2i/|Γ|) (Π·σ) ψ.
    ///
    /// Source: Ohsawa 2019, Prop. 2.2 and Thm. 4.1(i).
    ///
    /// The lift is exact to round-off for Π and Γ of any size, as long as ‖χ‖ = 2|Π|/√|Γ| and the products
    /// ‖χ‖‖ψ‖ = 2|Π| and ‖ψ‖² = |Γ| in M(χ, ψ) do not overflow.
    ///
    /// # Errors
    /// Returns [`LiftError`] if Γ = 0, if a coordinate is not finite, or if one of these three sizes
    /// overflows.
    #[inline]
    fn lift<T: Real>(&self, mu: &Se3Dual<T>) -> Result<SpinorPoint<T>, LiftError> {
        let Covector(Pair(pi, gamma)) =
            LiftError::unless_finite(*mu, "μ", mu.max_abs(), "Π and Γ must be finite")?;
        let (pi_scale, gamma_scale) = (squaring_scale(&pi), squaring_scale(&gamma));
        let unit = gamma * gamma_scale;
        let size = euclidean_norm(&unit);
        if size.at_most(T::zero()).any() {
            return Err(LiftError {
                quantity: "Γ",
                value: 0.0,
                reason: "Γ must be different from 0",
            });
        }
        let psi = hopf_section(&unit);
        let scaled = pi * pi_scale * (T::from_f64(-2.0) / size);
        let chi = pauli(&scaled, &psi).map(|z| Complex { re: -z.im, im: z.re });
        // ψ has the size √|Γ|, and χ the size |Π|/√|Γ|.
        let root = gamma_scale.sqrt();
        let chi = chi.map(|z| z.scale(root / pi_scale));
        let lifted = Cotangent::new(chi, Covector(psi.map(|z| z.scale(T::one() / root))));
        let reason = "2|Π|/√|Γ|, 2|Π| and |Γ| must be below 1.7e308";
        let range = Pair(lifted, self.apply::<T>(&lifted));
        Ok(LiftError::unless_finite(range, "μ", mu.max_abs(), reason)?.0)
    }
}

/// The least |ψ₁|/‖ψ‖ of a lift with a given Re χ₁.
///
/// Its χ has the size Re χ₁ ‖ψ‖/|ψ₁| and loses as many digits of Π: half of them at this bound.
const STEEPEST: f64 = 1e-8;

impl SpinorRealisation {
    /// Returns the lift with Re χ₁ = `re_chi1` and ψ₁ > 0.
    ///
    /// For Γ₂ = 0 it has a real ψ. With `re_chi1` = 1 and Γ₂ = 0 this is the initial condition of Ohsawa 2019, §5.2,
    /// which requires Re χ₁ = 1 and chooses a real ψ. Its norm is larger than that of the [minimal lift](Lift::lift).
    ///
    /// # Errors
    /// Returns [`LiftError`] in the cases of the minimal lift, and if χ or M(χ, ψ) overflows. It is also returned if Γ
    /// points straight down, where ψ₁ = 0, or is within an angle of 2e-8 of that direction, where the long χ rounds
    /// half of the digits of Π away.
    pub fn lift_with<T: Real>(
        &self,
        mu: &Se3Dual<T>,
        re_chi1: T,
    ) -> Result<SpinorPoint<T>, LiftError> {
        let z = self.lift::<T>(mu)?;
        let first = z.p.0.x;
        let length = euclidean_norm(&Vector2::new(first.re, first.im));
        let sine = length / euclidean_norm(&z.p);
        let steep = sine.at_most(T::from_f64(STEEPEST));
        if steep.any() {
            let reason = "|ψ₁|/‖ψ‖ must be above 1e-8, or bψ, which is added to χ, rounds Π away: Γ must \
                          not point along −e₃";
            let value = T::select(steep, sine, T::zero()).max_abs();
            return Err(LiftError { quantity: "ψ₁/ψ", value, reason });
        }
        // exp(iθ) = conj(ψ₁)/|ψ₁| turns ψ₁ to the positive axis.
        let phase = first.conj().unscale(length);
        let (chi, psi) = (z.q.map(|x| x * phase), z.p.0.map(|x| x * phase));
        let along = (re_chi1 - chi.x.re) / length;
        let lifted = Cotangent::new(chi + psi.map(|x| x.scale(along)), Covector(psi));
        let reason = "Re χ₁ must be so small that χ, and M of it, are numbers";
        let range = Pair(lifted, self.apply::<T>(&lifted));
        Ok(LiftError::unless_finite(range, "Re χ₁", re_chi1.max_abs(), reason)?.0)
    }
}

impl FibreSymmetry for SpinorRealisation {
    const COUNT: usize = 2;

    /// Moves the point along the fibre: (χ + sψ, ψ) for index 0, (exp(is)χ, exp(is)ψ) for index 1. Source:
    /// Ohsawa 2019, §4.2.
    #[inline]
    fn flow<T: Real>(&self, index: usize, s: T, z: &SpinorPoint<T>) -> SpinorPoint<T> {
        match index {
            0 => Cotangent { q: z.q + z.p.0.map(|x| x.scale(s)), ..*z },
            1 => {
                let square = s * s;
                let phase = Complex { re: square.stumpff(0), im: s * square.stumpff(1) };
                let turn = |spinor: &Vector2<Complex<T>>| spinor.map(|x| x * phase);
                Cotangent::new(turn(&z.q), Covector(turn(&z.p.0)))
            }
            _ => *z,
        }
    }

    /// Returns the momentum J₁ = ‖ψ‖²/2 for index 0 and J₂ = −Im(ψ∗χ) for index 1. Source: Ohsawa 2019, §4.2.
    #[inline]
    fn momentum<T: Real>(&self, index: usize, z: &SpinorPoint<T>) -> T {
        let (chi, psi) = (&z.q, &z.p.0);
        match index {
            0 => (psi.x.norm_sqr() + psi.y.norm_sqr()) * 0.5,
            1 => -(psi.x.conj() * chi.x + psi.y.conj() * chi.y).im,
            _ => T::zero(),
        }
    }
}
