//! Sine and cosine by sums, products and comparisons alone, whose bits are the same on every processor and in every lane.

use super::real::Real;

/// The largest |x|, 2²⁰ rad, which is less than 2²⁰ quarter turns.
const LARGEST: f64 = (1 << 20) as f64;

/// The largest |x|, 2⁻²⁶, at which sin x = x to a rounding error.
const SMALL: f64 = 1.0 / (1 << 26) as f64;

/// The parts of π/2: the first two have 33 bits, so that their products by a number of 20 bits are exact.
const QUARTER_TURN: [f64; 3] = [
    f64::from_bits(0x3FF9_21FB_5440_0000),
    f64::from_bits(0x3DD0_B461_1A60_0000),
    f64::from_bits(0x3BA3_198A_2E03_7073),
];

/// 1.5 · 2⁵²: a number below 2⁵¹ that is added to it and subtracted from the sum is rounded to a whole number.
const ROUNDING: f64 = 6_755_399_441_055_744.0;

/// The coefficients (−1)ᵏ/(2k + 1)! of sin r − r, and those of cos r − 1 + r²/2. For |r| ≤ π/4 the terms that are left out are
/// below a thirtieth of a rounding error.
const SINE: [f64; 8] = [
    -1.0 / 6.0,
    1.0 / 120.0,
    -1.0 / 5040.0,
    1.0 / 362_880.0,
    -1.0 / 39_916_800.0,
    1.0 / 6_227_020_800.0,
    -1.0 / 1_307_674_368_000.0,
    1.0 / 355_687_428_096_000.0,
];
const COSINE: [f64; 7] = [
    1.0 / 24.0,
    -1.0 / 720.0,
    1.0 / 40_320.0,
    -1.0 / 3_628_800.0,
    1.0 / 479_001_600.0,
    -1.0 / 87_178_291_200.0,
    1.0 / 20_922_789_888_000.0,
];

/// An angle x = n π/2 + r + t with |r| ≤ π/4 and a rounding error t of r, and n modulo 4, from −2 to 2.
///
/// Source: Cody & Waite, *Software manual for the elementary functions* (1980), for the parts of π/2.
struct Reduced<T> {
    quadrant: T,
    angle: T,
    rest: T,
}

impl<T: Real> Reduced<T> {
    #[cfg_attr(optimised, inline(always))]
    fn new(x: T) -> Self {
        let whole = |x: T| (x + ROUNDING) + -ROUNDING;
        let n = whole(x * core::f64::consts::FRAC_2_PI);
        let [first, second, third] = QUARTER_TURN.map(|part| n * part);
        let rough = x - first;
        let finer = rough - second;
        let rest = ((rough - finer) - second) - third;
        let angle = finer + rest;
        let quadrant = n - whole(n * 0.25) * 4.0;
        Self { quadrant, angle, rest: (finer - angle) + rest }
    }

    /// Returns sin(r + t).
    #[cfg_attr(optimised, inline(always))]
    fn sine(&self) -> T {
        let (r, square) = (self.angle, self.angle * self.angle);
        let slope = (square * -0.5) + 1.0;
        r + (r * square * polynomial(square, &SINE) + self.rest * slope)
    }

    /// Returns cos(r + t).
    #[cfg_attr(optimised, inline(always))]
    fn cosine(&self) -> T {
        let (r, square) = (self.angle, self.angle * self.angle);
        let half = square * 0.5;
        let main = (-half) + 1.0;
        let lost = (-main + 1.0) - half;
        main + (lost + (square * square * polynomial(square, &COSINE) - r * self.rest))
    }

    /// Returns whether n is odd, where sine and cosine change places.
    #[cfg_attr(optimised, inline(always))]
    fn is_odd(&self) -> T::Mask {
        (self.quadrant.magnitude() + -1.0).magnitude().at_most(T::zero())
    }

    /// Returns whether n is `first` or the next number, modulo 4: −1 or 0 where the cosine is not negative, 0 or 1 for the sine.
    #[cfg_attr(optimised, inline(always))]
    fn is_among(&self, first: f64) -> T::Mask {
        (self.quadrant + (-first - 0.5)).magnitude().at_most(T::from_f64(0.5))
    }
}

#[cfg_attr(optimised, inline(always))]
fn polynomial<T: Real>(x: T, coefficients: &[f64]) -> T {
    let mut sum = T::zero();
    for &coefficient in coefficients.iter().rev() {
        sum = sum * x + coefficient;
    }
    sum
}

/// Returns whether [`sine_of_moderate`] and [`cosine_of_moderate`] are right in every lane: whether each |x| is at most 2²⁰.
#[cfg_attr(optimised, inline(always))]
pub(crate) fn is_moderate<T: Real>(x: T) -> bool {
    x.all_below(LARGEST)
}

/// Returns sin x for [moderate](is_moderate) x, to a unit in the last place.
#[cfg_attr(optimised, inline(always))]
pub(crate) fn sine_of_moderate<T: Real>(x: T) -> T {
    let reduced = Reduced::new(x);
    let value = T::select(reduced.is_odd(), reduced.cosine(), reduced.sine());
    let value = T::select(reduced.is_among(0.0), value, -value);
    T::select(x.magnitude().at_most(T::from_f64(SMALL)), x, value)
}

/// Returns cos x for [moderate](is_moderate) x, to a unit in the last place.
#[cfg_attr(optimised, inline(always))]
pub(crate) fn cosine_of_moderate<T: Real>(x: T) -> T {
    let reduced = Reduced::new(x);
    let value = T::select(reduced.is_odd(), reduced.sine(), reduced.cosine());
    T::select(reduced.is_among(-1.0), value, -value)
}

/// Returns sin x; what is not moderate is left to the standard library, whose last bits depend on the system.
pub(super) fn sine_of_number(x: f64) -> f64 {
    let reduced = Reduced::new(x);
    match (is_moderate(x), reduced.is_odd()) {
        (false, _) => x.sin(),
        _ if x.abs() <= SMALL => x,
        (true, odd) => {
            let value = if odd { reduced.cosine() } else { reduced.sine() };
            if reduced.is_among(0.0) { value } else { -value }
        }
    }
}

/// Returns cos x, as [`sine_of_number`] does.
pub(super) fn cosine_of_number(x: f64) -> f64 {
    let reduced = Reduced::new(x);
    match (is_moderate(x), reduced.is_odd()) {
        (false, _) => x.cos(),
        (true, odd) => {
            let value = if odd { reduced.sine() } else { reduced.cosine() };
            if reduced.is_among(-1.0) { value } else { -value }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The difference of two numbers in units of the last place.
    fn units(a: f64, b: f64) -> f64 {
        let size = b.abs();
        (a - b).abs() / (size.next_up() - size)
    }

    /// Numbers of all sizes, and the nearest ones to multiples of π/2, at which nearly all digits cancel.
    fn numbers() -> impl Iterator<Item = f64> {
        let spread = (1..40_000).map(|n| f64::from(n) * 0.618_033_988_749_895);
        let spread = spread.flat_map(|x| [x.fract(), x, x * 42.0, x.fract() * 1e-9]);
        let multiples =
            (1..600_000).step_by(7).map(|n| f64::from(n) * core::f64::consts::FRAC_PI_2);
        spread.chain(multiples).chain([LARGEST, SMALL, SMALL.next_up(), 1e-300, 5e-324])
    }

    #[test]
    fn values_are_those_of_the_standard_library_to_a_unit() {
        for x in numbers().flat_map(|x| [x, -x]) {
            let (sine, cosine) = (sine_of_number(x), cosine_of_number(x));
            // Each of the two is within a unit of the exact value.
            assert!(units(sine, x.sin()) <= 1.0, "sin {x:e} = {sine:e}, {:e}", x.sin());
            assert!(units(cosine, x.cos()) <= 1.0, "cos {x:e} = {cosine:e}, {:e}", x.cos());
            assert_eq!((sine, cosine), (-sine_of_number(-x), cosine_of_number(-x)));
            // The branches of numbers and the masks of lanes choose the same.
            assert_eq!(
                (sine.to_bits(), cosine.to_bits()),
                (sine_of_moderate(x).to_bits(), cosine_of_moderate(x).to_bits())
            );
        }
        assert_eq!(sine_of_number(-0.0).to_bits(), (-0.0_f64).to_bits());
    }

    #[test]
    fn what_is_not_moderate_is_left_to_the_standard_library() {
        for x in [LARGEST.next_up(), 1e22, -1e300, f64::MAX] {
            assert_eq!((sine_of_number(x), cosine_of_number(x)), (x.sin(), x.cos()));
            // Control: the sums would be wrong there, or no numbers.
            let apart = units(sine_of_moderate(x), x.sin());
            assert!(x.abs() < 2e6 || apart.is_nan() || apart > 1e6, "{x}");
        }
        assert!(
            [f64::NAN, f64::INFINITY]
                .iter()
                .all(|&x| sine_of_number(x).is_nan() && cosine_of_number(x).is_nan())
        );
    }

    /// π in base 16 is 3.243F6A88 85A308D3 13198A2E 0370734…
    #[test]
    fn the_parts_are_those_of_pi() {
        let pi = 0x3243_F6A8_885A_308D_3131_98A2_E037_0734_i128; // in units of 2⁻¹²⁴
        let exact = |part: &f64| (part * 2.0_f64.powi(124)) as i128;
        let sum = QUARTER_TURN.iter().map(exact).sum::<i128>();
        assert!((2 * sum - pi).abs() < 16, "{}", 2 * sum - pi);
        assert!(QUARTER_TURN[..2].iter().all(|part| part.to_bits().trailing_zeros() >= 20));
    }
}
