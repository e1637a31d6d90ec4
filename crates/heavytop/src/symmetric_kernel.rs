//! The two flows of a symmetric top in components, as many tops at once as there are lanes.

use crate::SymmetricTopSplitting;
use lie_poisson::{Covector, Lanes, Mask, Pair, Se3Dual};

/// The largest sum of squared angles, rad², that a flow may have; [`sine_and_versine`] is good up to
/// here.
const RANGE: f64 = 2.0;

/// Π and Γ in components.
#[derive(Clone, Copy)]
pub(crate) struct Momenta<T> {
    pi: [T; 3],
    gamma: [T; 3],
}

/// What the flows need of a top.
#[derive(Clone, Copy)]
pub(crate) struct Parameters<T> {
    /// 1/I₁
    transverse: T,
    /// 1/I₃ − 1/I₁
    difference: T,
    /// m g l c
    force: [T; 3],
}

impl<T: Lanes> Momenta<T> {
    /// Lane i from f(i).
    #[inline(always)]
    pub(crate) fn from_lanes<'a>(f: impl Fn(usize) -> &'a Se3Dual) -> Self {
        let component = |k: usize| T::from_lanes(|i| f(i).0.0[k]);
        let vertical = |k: usize| T::from_lanes(|i| f(i).0.1[k]);
        Self {
            pi: [component(0), component(1), component(2)],
            gamma: [vertical(0), vertical(1), vertical(2)],
        }
    }

    /// The state in lane i.
    #[inline(always)]
    pub(crate) fn lane(&self, i: usize) -> Se3Dual {
        let vector = |v: &[T; 3]| nalgebra::Vector3::new(v[0].lane(i), v[1].lane(i), v[2].lane(i));
        Covector(Pair(vector(&self.pi), vector(&self.gamma)))
    }

    /// φ_2^t: Π ← Π + t Γ×F.
    #[inline(always)]
    pub(crate) fn kick(&mut self, top: &Parameters<T>, time: f64) {
        let f = [top.force[0] * time, top.force[1] * time, top.force[2] * time];
        let g = self.gamma;
        self.pi[0] = g[1].multiply_add(f[2], g[2].negative_multiply_add(f[1], self.pi[0]));
        self.pi[1] = g[2].multiply_add(f[0], g[0].negative_multiply_add(f[2], self.pi[1]));
        self.pi[2] = g[0].multiply_add(f[1], g[1].negative_multiply_add(f[0], self.pi[2]));
    }

    /// φ_1^t, and where its angles are in range: with s = t/I₁ and the Stumpff functions c₁, c₂ at
    /// s²|Π|²,
    ///
    /// ```text
    /// Γ ← Γ − s c₁ Π×Γ + s² c₂ Π×(Π×Γ),
    /// ```
    ///
    /// then Π and Γ turn about e₃.
    #[inline(always)]
    pub(crate) fn drift(&mut self, top: &Parameters<T>, time: f64) -> T::Mask {
        let pi = self.pi;
        let s = top.transverse * time;
        let angle = -(top.difference * time) * pi[2];
        let s_squared = s * s;
        let x = s_squared * dot(&pi, &pi);
        let y = angle * angle;
        let (c1, c2) = sine_and_versine(x);
        let (first, second) = (s * c1, s_squared * c2);
        let once = cross(&pi, &self.gamma);
        let twice = cross(&pi, &once);
        for k in 0..3 {
            let turned = first.negative_multiply_add(once[k], self.gamma[k]);
            self.gamma[k] = second.multiply_add(twice[k], turned);
        }
        let (d1, d2) = sine_and_versine(y);
        let (sine, cosine) = (angle * d1, y.negative_multiply_add(d2, T::from_f64(1.0)));
        self.pi = turn(&pi, cosine, sine);
        self.gamma = turn(&self.gamma, cosine, sine);
        (x + y).at_most(T::from_f64(RANGE))
    }
}

impl<T: Lanes> Parameters<T> {
    /// Lane i from f(i).
    #[inline(always)]
    pub(crate) fn from_lanes<'a>(f: impl Fn(usize) -> &'a SymmetricTopSplitting) -> Self {
        let force = |k: usize| {
            T::from_lanes(|i| f(i).top().weight_moment() * f(i).top().center_of_mass()[k])
        };
        Self {
            transverse: T::from_lanes(|i| 1.0 / f(i).top().inertia().x),
            difference: T::from_lanes(|i| {
                let inertia = f(i).top().inertia();
                1.0 / inertia.z - 1.0 / inertia.x
            }),
            force: [force(0), force(1), force(2)],
        }
    }
}

/// sin θ/θ and (1 − cos θ)/θ² for x = θ² ∈ [0, 2], as polynomials of degree 7: the Chebyshev series
/// of c₁ and c₂ on this interval, cut off, within 4.3e-17 and 7e-18 of them.
///
/// The terms are gathered in pairs and pairs of pairs, which takes three products in sequence
/// where Horner's rule takes seven.
///
/// Source of the scheme: Estrin, *Organization of computer systems* (1960).
#[inline(always)]
pub(crate) fn sine_and_versine<T: Lanes>(x: T) -> (T, T) {
    const SINE: [f64; 8] = [
        1.0,
        -0.166_666_666_666_665_3,
        0.008_333_333_333_318_923,
        -0.000_198_412_698_355_017_9,
        2.755_731_808_991_546e-6,
        -2.505_198_724_802_774e-8,
        1.605_186_895_443_167e-10,
        -7.425_363_829_007_876e-13,
    ];
    const VERSINE: [f64; 8] = [
        0.5,
        -0.041_666_666_666_666_59,
        0.001_388_888_888_888_086_4,
        -2.480_158_729_837_534_2e-5,
        2.755_731_859_253_434_6e-7,
        -2.087_668_954_794_906e-9,
        1.146_675_211_819_745_3e-11,
        -4.656_083_268_560_329e-14,
    ];
    let square = x * x;
    let fourth = square * square;
    (polynomial(&SINE, x, square, fourth), polynomial(&VERSINE, x, square, fourth))
}

#[inline(always)]
fn polynomial<T: Lanes>(c: &[f64; 8], x: T, square: T, fourth: T) -> T {
    let pair = |k: usize| T::from_f64(c[k + 1]).multiply_add(x, T::from_f64(c[k]));
    let low = pair(2).multiply_add(square, pair(0));
    let high = pair(6).multiply_add(square, pair(4));
    high.multiply_add(fourth, low)
}

/// v turned about e₃ to the right.
#[inline(always)]
fn turn<T: Lanes>(v: &[T; 3], cosine: T, sine: T) -> [T; 3] {
    [cosine.multiply_subtract(v[0], sine * v[1]), sine.multiply_add(v[0], cosine * v[1]), v[2]]
}

#[inline(always)]
fn dot<T: Lanes>(a: &[T; 3], b: &[T; 3]) -> T {
    a[0].multiply_add(b[0], a[1].multiply_add(b[1], a[2] * b[2]))
}

#[inline(always)]
fn cross<T: Lanes>(a: &[T; 3], b: &[T; 3]) -> [T; 3] {
    [
        a[1].multiply_subtract(b[2], a[2] * b[1]),
        a[2].multiply_subtract(b[0], a[0] * b[2]),
        a[0].multiply_subtract(b[1], a[1] * b[0]),
    ]
}

/// Truth in every lane.
#[inline(always)]
pub(crate) fn everywhere<T: Lanes>() -> T::Mask {
    T::Mask::from_bool(true)
}

#[cfg(test)]
mod tests {
    use super::*;
    use lie_poisson::{DefaultLanes, Real};

    #[test]
    fn polynomials_are_stumpff_functions_on_their_range() {
        for n in 0..=1000 {
            let x = RANGE * f64::from(n) / 1000.0;
            let (c1, c2) = sine_and_versine(x);
            // The error of the series, and some roundings of sums below 1 and ½.
            assert!((c1 - x.stumpff(1)).abs() <= 1.5 * f64::EPSILON, "{x}");
            assert!((c2 - x.stumpff(2)).abs() <= f64::EPSILON, "{x}");
        }
        // Beyond it they are not, so that the bound is needed.
        let (c1, _) = sine_and_versine(2.0 * RANGE);
        assert!((c1 - (2.0 * RANGE).stumpff(1)).abs() > 16.0 * f64::EPSILON);
    }

    #[test]
    fn angles_out_of_range_and_nan_are_seen() {
        let top = Parameters {
            transverse: DefaultLanes::from_f64(1.0),
            difference: DefaultLanes::from_f64(0.5),
            force: [DefaultLanes::from_f64(0.0); 3],
        };
        let pi = DefaultLanes::load(&[1.0, 3.0, f64::NAN, -1.0]);
        let zero = DefaultLanes::from_f64(0.0);
        let mut momenta = Momenta { pi: [pi, zero, pi], gamma: [zero; 3] };
        let fine = momenta.drift(&top, 0.5);
        assert_eq!([0, 1, 2, 3].map(|i| fine.lane(i)), [true, false, false, true]);
    }
}
