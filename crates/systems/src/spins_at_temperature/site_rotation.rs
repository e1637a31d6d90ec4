//! The rotation of one spin in a step at a temperature: [`SiteConstants`], [`SpinDamping`].

use lie_poisson::thermal_strength;
use nalgebra::Vector3;

/// The damping of spins at a temperature.
///
/// Source of both: Lakshmanan, Phil. Trans. R. Soc. A 369 (2011).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SpinDamping {
    /// The friction θ of Landau and Lifshitz, ds/dt = s × H − θ s × (s × H), with the unit of 1/s; as a
    /// [`DoubleBracket`](lie_poisson::DoubleBracket) has it.
    LandauLifshitz(f64),
    /// The damping α of Gilbert, ds/dt = s × H − (α/|s|) s × ds/dt for the plus bracket, without a unit; as
    /// [`GilbertDamping`](lie_poisson::GilbertDamping) has it.
    Gilbert(f64),
}

impl SpinDamping {
    /// Returns the name of the constant, and its value.
    pub(crate) const fn named(self) -> (&'static str, f64) {
        match self {
            Self::LandauLifshitz(friction) => ("the friction of Landau and Lifshitz", friction),
            Self::Gilbert(damping) => ("the damping of Gilbert", damping),
        }
    }

    /// Returns the friction b of a spin of a length, with the unit of 1/s: θ, or α/((1 + α²)|s|). Noise at the energy kT turns
    /// the spin by the angle √(2bkTh), rad, in a time h.
    #[must_use]
    pub fn friction(self, length: f64) -> f64 {
        self.constants(length)[1]
    }

    /// Returns the rate ds/dt = s × (aH + bH × s) of a spin in a field H = −∂h/∂s, without noise. With noise it is the drift in
    /// Stratonovich's sense.
    #[must_use]
    pub fn rate(self, spin: &Vector3<f64>, field: &Vector3<f64>) -> Vector3<f64> {
        let [factor, friction] = self.constants(spin.norm());
        spin.cross(&(field * factor + field.cross(spin) * friction))
    }

    /// Returns the factor a of the field and the friction b for a spin of a length.
    fn constants(self, length: f64) -> [f64; 2] {
        match self {
            Self::LandauLifshitz(friction) => [1.0, friction],
            Self::Gilbert(_) if length == 0.0 => [1.0, 0.0],
            Self::Gilbert(damping) => {
                let slower = 1.0 / (1.0 + damping * damping);
                [slower, slower * damping / length]
            }
        }
    }
}

/// What is constant in a step at one site, and the rate ω of its rotation.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct SiteConstants {
    factor: f64,
    friction: f64,
    noise: Vector3<f64>,
    pub(crate) omega: Vector3<f64>,
}

impl SiteConstants {
    /// Returns the constants of a spin in a step with increments ΔW, at the energy kT.
    pub(crate) fn new(
        damping: SpinDamping,
        temperature: f64,
        spin: &Vector3<f64>,
        increments: &Vector3<f64>,
        step: f64,
    ) -> Self {
        let [factor, friction] = damping.constants(spin.norm());
        let strength = thermal_strength(friction, temperature);
        // In a step of size 0 there is no noise.
        let rate = if step == 0.0 { 0.0 } else { strength / step };
        let noise = increments * rate;
        Self { factor, friction, noise, omega: Vector3::zeros() }
    }

    /// Returns ω = a H + b H × m + noise, with H = −dh.
    #[inline]
    pub(crate) fn rate(&self, dh: &Vector3<f64>, m: &Vector3<f64>) -> Vector3<f64> {
        let drag = m.cross(dh) * self.friction;
        drag - dh * self.factor + self.noise
    }
}

/// Returns the midpoint m = s + m × v of the rotation of a spin s, m = (s + s × v + (s·v) v)/(1 + |v|²).
#[inline]
pub(crate) fn turned_middle(s: &Vector3<f64>, v: &Vector3<f64>) -> Vector3<f64> {
    (s + s.cross(v) + v * s.dot(v)) / (1.0 + v.norm_squared())
}
