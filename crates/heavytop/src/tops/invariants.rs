//! The conserved quantities of the tops.

use crate::HeavyTop;
use core::fmt;
use lie_poisson::{Covector, Hamiltonian, Pair, Real, Se3Dual};
use num_complex::Complex;

/// A conserved quantity of some heavy top.
///
/// # Example
/// ```
/// use heavytop::{HeavyTop, Invariant};
/// use lie_poisson::Se3Dual;
/// use nalgebra::Vector3;
/// let top = HeavyTop::kovalevskaya(1.0, 1.0)?;
/// let start = Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::new(0.5, 0.0, 0.75_f64.sqrt()));
/// let values: Vec<f64> = top.invariants().iter().map(|i| i.value(&top, &start)).collect();
/// for (value, expected) in values.iter().zip([11.75, 1.0, 1.0 + 2.0 * 3.0_f64.sqrt(), 193.0]) {
///     assert!((value - expected).abs() < 1e-13 * expected);
/// }
/// # Ok::<(), heavytop::TopError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Invariant {
    /// The energy h = ½ Π·(I⁻¹Π) + m g l Γ·c, conserved by every top, in joules. Source: Ohsawa 2019, eq.
    /// (1.3).
    Energy,
    /// The Casimir f₁ = |Γ|², dimensionless. Source: Ohsawa 2019, §4.2.
    VerticalSquared,
    /// The Casimir f₂ = Π·Γ, the vertical angular momentum, kg m²/s. Source: Ohsawa 2019, §4.2.
    VerticalMomentum,
    /// The axial angular momentum f₃ = Π₃ of Lagrange's top, kg m²/s. Source: Ohsawa 2019, §4.3.
    AxialMomentum,
    /// The invariant K = |(Π₁+iΠ₂)² − 4 m g l I₃ (c₁+ic₂)(Γ₁+iΓ₂)|² of Kovalevskaya's top, (kg m²/s)⁴.
    ///
    /// Source: Ohsawa 2019, §5.2, for c = e₁. A rotation about e₃ gives the general case.
    Kovalevskaya,
    /// The invariant G = Π₃(Π₁²+Π₂²) − 4 I₃ m g l Γ₃ (c₁Π₁+c₂Π₂) of Goryachev and Chaplygin's top, (kg
    /// m²/s)³.
    ///
    /// It is conserved on Π·Γ = 0 only, where dG/dt = −m g l (c₁Π₂−c₂Π₁)(Π·Γ) vanishes.
    GoryachevChaplygin,
}

impl Invariant {
    /// Returns the symbol: `h`, `f1`, `f2`, `f3`, `K` or `G`.
    #[must_use]
    pub const fn symbol(self) -> &'static str {
        match self {
            Self::Energy => "h",
            Self::VerticalSquared => "f1",
            Self::VerticalMomentum => "f2",
            Self::AxialMomentum => "f3",
            Self::Kovalevskaya => "K",
            Self::GoryachevChaplygin => "G",
        }
    }

    /// Returns the unit, in SI units; the empty text for f₁, which is a number.
    ///
    /// ```
    /// use heavytop::Invariant;
    /// assert_eq!((Invariant::Energy.unit(), Invariant::VerticalSquared.unit()), ("J", ""));
    /// ```
    #[must_use]
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Energy => "J",
            Self::VerticalSquared => "",
            Self::VerticalMomentum | Self::AxialMomentum => "kg m²/s",
            Self::Kovalevskaya => "(kg m²/s)⁴",
            Self::GoryachevChaplygin => "(kg m²/s)³",
        }
    }

    /// Returns the value of the invariant for a top in the state (Π, Γ).
    pub fn value<T: Real>(self, top: &HeavyTop, mu: &Se3Dual<T>) -> T {
        let Covector(Pair(pi, gamma)) = mu;
        match self {
            Self::Energy => top.value(mu),
            Self::VerticalSquared => gamma.dot(gamma),
            Self::VerticalMomentum => pi.dot(gamma),
            Self::AxialMomentum => pi.z,
            Self::Kovalevskaya => {
                let center = equatorial::<T>(top);
                let vertical = Complex { re: gamma.x, im: gamma.y } * center;
                let spin = Complex { re: pi.x, im: pi.y };
                let strength = T::from_f64(4.0 * top.weight_moment() * top.inertia().z);
                (spin * spin - vertical.scale(strength)).norm_sqr()
            }
            Self::GoryachevChaplygin => {
                let center = equatorial::<T>(top);
                let along = center.re * pi.x + center.im * pi.y;
                let strength = 4.0 * top.weight_moment() * top.inertia().z;
                pi.z * (pi.x * pi.x + pi.y * pi.y) - gamma.z * along * strength
            }
        }
    }
}

impl fmt::Display for Invariant {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.symbol())
    }
}

/// Returns the equatorial part c₁ + ic₂ of the centre of mass.
fn equatorial<T: Real>(top: &HeavyTop) -> Complex<T> {
    let center = top.center_of_mass();
    Complex { re: T::from_f64(center.x), im: T::from_f64(center.y) }
}

impl HeavyTop {
    /// Returns whether I₁ = I₂ and the centre of mass is on the third axis (or there is no gravity).
    #[must_use]
    pub fn is_lagrange(&self) -> bool {
        self.has_transverse_moment(self.inertia().x)
            && (self.weight_moment() == 0.0 || is_small(self.center_of_mass().xy().norm()))
    }

    /// Returns whether I₁ = I₂ = 2I₃ and the centre of mass is in the equatorial plane.
    #[must_use]
    pub fn is_kovalevskaya(&self) -> bool {
        self.has_transverse_moment(2.0 * self.inertia().z) && is_small(self.center_of_mass().z)
    }

    /// Returns whether I₁ = I₂ = 4I₃ and the centre of mass is in the equatorial plane.
    #[must_use]
    pub fn is_goryachev_chaplygin(&self) -> bool {
        self.has_transverse_moment(4.0 * self.inertia().z) && is_small(self.center_of_mass().z)
    }

    /// Returns the invariants of this top: h, f₁ and f₂, and the fourth one if the top is integrable.
    ///
    /// G is listed for a Goryachev–Chaplygin top at every level of Π·Γ.
    #[must_use]
    pub fn invariants(&self) -> Vec<Invariant> {
        use Invariant::{
            AxialMomentum, Energy, GoryachevChaplygin, Kovalevskaya, VerticalMomentum,
            VerticalSquared,
        };
        let special = [
            (self.is_lagrange(), AxialMomentum),
            (self.is_kovalevskaya(), Kovalevskaya),
            (self.is_goryachev_chaplygin(), GoryachevChaplygin),
        ];
        let fourth =
            special.into_iter().filter_map(|(holds, invariant)| holds.then_some(invariant));
        [Energy, VerticalSquared, VerticalMomentum].into_iter().chain(fourth).collect()
    }

    fn has_transverse_moment(&self, moment: f64) -> bool {
        let inertia = self.inertia();
        [inertia.x, inertia.y].iter().all(|i| is_small(i / moment - 1.0))
    }
}

/// Returns whether x is zero up to the rounding of parameters that were given with 12 digits.
fn is_small(x: f64) -> bool {
    x.abs() <= 1e-12
}
