//! The conserved quantities of the tops.

use crate::tops::top::HeavyTop;
use core::fmt;
use lie_poisson::{Covector, Hamiltonian, Pair, Real, Se3Dual};
use num_complex::Complex;

/// A quantity that every heavy top, or some integrable top, conserves.
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
    /// The axial angular momentum f₃ of Lagrange's top, kg m²/s: Π₃, or Π₁ or Π₂ if that axis is the symmetry axis.
    ///
    /// A sphere, I₁ = I₂ = I₃, is symmetric about every axis, also about one through a centre of mass that is on no principal
    /// axis. It then is Π·c.
    ///
    /// Source: Ohsawa 2019, §4.3.
    AxialMomentum,
    /// The invariant K = |(Π₁+iΠ₂)² − 4 m g l I₃ (c₁+ic₂)(Γ₁+iΓ₂)|² of Kovalevskaya's top, (kg m²/s)⁴.
    ///
    /// Source: Ohsawa 2019, §5.2, for c = e₁. A rotation about e₃ gives the general case. If another axis is the
    /// symmetry axis, the indices are permuted cyclically.
    Kovalevskaya,
    /// The invariant G = Π₃(Π₁²+Π₂²) − 4 I₃ m g l Γ₃ (c₁Π₁+c₂Π₂) of Goryachev and Chaplygin's top, (kg
    /// m²/s)³.
    ///
    /// It is conserved on Π·Γ = 0 only, where dG/dt = −m g l (c₁Π₂−c₂Π₁)(Π·Γ) vanishes. If another axis is the
    /// symmetry axis, the indices are permuted cyclically.
    GoryachevChaplygin,
    /// The square C = |Π|² of the angular momentum of the free rigid body, (kg m²/s)²: the Casimir of so(3)∗.
    ///
    /// Source: Marsden & Ratiu, *Introduction to Mechanics and Symmetry*, §15.1.
    MomentumSquared,
}

impl Invariant {
    /// Returns the symbol: `h`, `f1`, `f2`, `f3`, `K`, `G` or `C`.
    #[must_use]
    pub const fn symbol(self) -> &'static str {
        match self {
            Self::Energy => "h",
            Self::VerticalSquared => "f1",
            Self::VerticalMomentum => "f2",
            Self::AxialMomentum => "f3",
            Self::Kovalevskaya => "K",
            Self::GoryachevChaplygin => "G",
            Self::MomentumSquared => "C",
        }
    }

    /// Returns the SI unit, or the empty text for f₁, which is dimensionless.
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
            Self::MomentumSquared => "(kg m²/s)²",
        }
    }

    /// Returns the value of the invariant for a top in the state (Π, Γ).
    pub fn value<T: Real>(self, top: &HeavyTop, mu: &Se3Dual<T>) -> T {
        let Covector(Pair(pi, gamma)) = mu;
        match self {
            Self::Energy => top.value(mu),
            Self::VerticalSquared => gamma.dot(gamma),
            Self::VerticalMomentum => pi.dot(gamma),
            Self::AxialMomentum => match top.axial_component() {
                None if top.is_sphere() => pi.dot(&top.center_of_mass().map(T::from_f64)),
                axis => pi[axis.unwrap_or(2)],
            },
            Self::Kovalevskaya => {
                let axis = top.axis(HeavyTop::is_kovalevskaya_about);
                let [x, y] = equator(axis);
                let center = equatorial::<T>(top, axis);
                let vertical = Complex { re: gamma[x], im: gamma[y] } * center;
                let spin = Complex { re: pi[x], im: pi[y] };
                let strength = T::from_f64(4.0 * top.weight_moment() * top.inertia()[axis]);
                (spin * spin - vertical.scale(strength)).norm_sqr()
            }
            Self::GoryachevChaplygin => {
                let axis = top.axis(HeavyTop::is_goryachev_chaplygin_about);
                let [x, y] = equator(axis);
                let center = equatorial::<T>(top, axis);
                let along = pi[x] * center.re + pi[y] * center.im;
                let strength = 4.0 * top.weight_moment() * top.inertia()[axis];
                pi[axis] * (pi[x] * pi[x] + pi[y] * pi[y]) - gamma[axis] * along * strength
            }
            Self::MomentumSquared => pi.dot(pi),
        }
    }
}

impl fmt::Display for Invariant {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.symbol())
    }
}

/// Returns the two axes that follow an axis cyclically.
fn equator(axis: usize) -> [usize; 2] {
    [(axis + 1) % 3, (axis + 2) % 3]
}

/// Returns the part of the centre of mass at right angles to an axis: c₁ + ic₂ for the third.
fn equatorial<T: Real>(top: &HeavyTop, axis: usize) -> Complex<T> {
    let (center, [x, y]) = (top.center_of_mass(), equator(axis));
    Complex { re: T::from_f64(center[x]), im: T::from_f64(center[y]) }
}

impl HeavyTop {
    /// Returns whether I₁ = I₂ and the centre of mass is on the third axis (or there is no gravity).
    #[must_use]
    pub fn is_lagrange(&self) -> bool {
        self.is_lagrange_about(2)
    }

    /// Returns whether I₁ = I₂ = 2I₃ and the centre of mass is in the equatorial plane.
    #[must_use]
    pub fn is_kovalevskaya(&self) -> bool {
        self.is_kovalevskaya_about(2)
    }

    /// Returns whether I₁ = I₂ = 4I₃ and the centre of mass is in the equatorial plane.
    #[must_use]
    pub fn is_goryachev_chaplygin(&self) -> bool {
        self.is_goryachev_chaplygin_about(2)
    }

    fn is_lagrange_about(&self, axis: usize) -> bool {
        let ([x, y], center) = (equator(axis), self.center_of_mass());
        self.has_transverse_moment(axis, self.inertia()[x])
            && (self.weight_moment() == 0.0 || is_small(center[x].hypot(center[y])))
    }

    fn is_kovalevskaya_about(&self, axis: usize) -> bool {
        self.has_transverse_moment(axis, 2.0 * self.inertia()[axis])
            && is_small(self.center_of_mass()[axis])
    }

    fn is_goryachev_chaplygin_about(&self, axis: usize) -> bool {
        self.has_transverse_moment(axis, 4.0 * self.inertia()[axis])
            && is_small(self.center_of_mass()[axis])
    }

    /// Returns the axis about which the top is of the given kind. The third axis comes first, and is also the answer if
    /// the top is of this kind about no axis.
    fn axis(&self, is_of_kind: impl Fn(&Self, usize) -> bool) -> usize {
        [2, 0, 1].into_iter().find(|axis| is_of_kind(self, *axis)).unwrap_or(2)
    }

    /// Returns the principal axis 0, 1 or 2 along which Π has the component f₃, or `None` if f₃ is Π·c of a sphere or is not
    /// conserved.
    #[must_use]
    pub fn axial_component(&self) -> Option<usize> {
        [2, 0, 1].into_iter().find(|axis| self.is_lagrange_about(*axis))
    }

    /// Returns whether the top is a sphere, I₁ = I₂ = I₃.
    fn is_sphere(&self) -> bool {
        self.has_transverse_moment(2, self.inertia().z)
    }

    /// Returns the invariants of the motion from a state: those of [`invariants`](Self::invariants), and G of a
    /// Goryachev–Chaplygin top if Π·Γ = 0 there, to within 1e-12 of |Π||Γ|.
    ///
    /// ```
    /// use heavytop::{HeavyTop, Invariant};
    /// use lie_poisson::Se3Dual;
    /// use nalgebra::Vector3;
    /// let top = HeavyTop::goryachev_chaplygin(1.0, 1.0)?;
    /// let level = |third: f64| Se3Dual::new(Vector3::new(2.0, 3.0, third), Vector3::z());
    /// assert_eq!(top.invariants_from(&level(0.0)).last(), Some(&Invariant::GoryachevChaplygin));
    /// assert_eq!(top.invariants_from(&level(0.1)), top.invariants());
    /// # Ok::<(), heavytop::TopError>(())
    /// ```
    #[must_use]
    pub fn invariants_from(&self, Covector(Pair(pi, gamma)): &Se3Dual) -> Vec<Invariant> {
        let is_kind = Self::is_goryachev_chaplygin_about;
        let mut invariants = self.invariants();
        // Of size 1, so that no product over- or underflows.
        let (sizes, [pi, gamma]) = ([pi.amax(), gamma.amax()], [pi, gamma]);
        let [pi, gamma] = [pi / sizes[0], gamma / sizes[1]];
        let is_level = sizes.contains(&0.0) || is_small(pi.dot(&gamma));
        if is_level && is_kind(self, self.axis(is_kind)) {
            invariants.push(Invariant::GoryachevChaplygin);
        }
        invariants
    }

    /// Returns the invariants of this top in every state: h, f₁ and f₂; C for a free body; and the additional invariant of
    /// an integrable top.
    ///
    /// The symmetry axis may be any of the three. G of a Goryachev–Chaplygin top is conserved on Π·Γ = 0 alone, where
    /// [`invariants_from`](Self::invariants_from) lists it.
    ///
    /// ```
    /// use heavytop::{Body, HeavyTop, Invariant};
    /// use nalgebra::Vector3;
    /// // a Kovalevskaya top whose symmetry axis is the second
    /// let body = Body {
    ///     inertia: Vector3::new(2.0, 1.0, 2.0),
    ///     mass: 1.0,
    ///     gravity: 1.0,
    ///     length: 1.0,
    ///     center_of_mass: Vector3::new(0.0, 0.0, 1.0),
    /// };
    /// assert_eq!(HeavyTop::new(&body)?.invariants().last(), Some(&Invariant::Kovalevskaya));
    /// let free = HeavyTop::free_rigid_body(Vector3::new(1.0, 1.5, 2.0))?;
    /// assert_eq!(free.invariants().last(), Some(&Invariant::MomentumSquared));
    /// # Ok::<(), heavytop::TopError>(())
    /// ```
    #[must_use]
    pub fn invariants(&self) -> Vec<Invariant> {
        use Invariant::{
            AxialMomentum, Energy, Kovalevskaya, MomentumSquared, VerticalMomentum, VerticalSquared,
        };
        let about_some_axis =
            |is_of_kind: fn(&Self, usize) -> bool| is_of_kind(self, self.axis(is_of_kind));
        let special = [
            (self.weight_moment() == 0.0, MomentumSquared),
            (self.axial_component().is_some() || self.is_sphere(), AxialMomentum),
            (about_some_axis(Self::is_kovalevskaya_about), Kovalevskaya),
        ];
        let others =
            special.into_iter().filter_map(|(holds, invariant)| holds.then_some(invariant));
        [Energy, VerticalSquared, VerticalMomentum].into_iter().chain(others).collect()
    }

    /// Returns whether both moments at right angles to an axis have the given value.
    fn has_transverse_moment(&self, axis: usize, moment: f64) -> bool {
        equator(axis).iter().all(|&i| is_small(self.inertia()[i] / moment - 1.0))
    }
}

/// Returns whether x is zero up to the rounding of parameters that were given with 12 digits.
fn is_small(x: f64) -> bool {
    x.abs() <= 1e-12
}
