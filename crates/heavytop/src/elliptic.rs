//! Jacobi's elliptic functions.

/// sn, cn, dn and the amplitude am of u for the parameter m = k², 0 ≤ m ≤ 1; real u.
///
/// By the arithmetic–geometric mean (descending Landen transformation), to a few units of
/// round-off relative to max(1, |u|). NaN for m outside [0, 1].
///
/// Source: Abramowitz & Stegun, *Handbook of Mathematical Functions*, §16.4.
///
/// # Example
/// ```
/// let [sn, cn, dn, _] = heavytop::jacobi_elliptic(0.7, 0.36);
/// assert!((sn * sn + cn * cn - 1.0).abs() < 1e-15);
/// assert!((dn * dn + 0.36 * sn * sn - 1.0).abs() < 1e-15);
/// ```
#[must_use]
pub fn jacobi_elliptic(u: f64, m: f64) -> [f64; 4] {
    if !(0.0..=1.0).contains(&m) {
        return [f64::NAN; 4];
    }
    if m == 1.0 {
        let sech = 1.0 / u.cosh();
        return [u.tanh(), sech, sech, u.sinh().atan()];
    }
    // a_n, c_n of the mean of 1 and √(1−m); it converges quadratically.
    let (mut a, mut b) = (1.0, (1.0 - m).sqrt());
    let mut ratios = [0.0; 12];
    let mut levels = 0;
    let mut c = m.sqrt();
    while c > f64::EPSILON * a && levels < ratios.len() {
        c = 0.5 * (a - b);
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
        ratios[levels] = c / a;
        levels += 1;
    }
    let mut phi = a * u * f64::from(1_u32 << levels);
    for ratio in ratios[..levels].iter().rev() {
        phi = 0.5 * (phi + (ratio * phi.sin()).asin());
    }
    let (sn, cn) = phi.sin_cos();
    // 1 − m sn² without cancellation near sn² = 1.
    let dn = ((1.0 - m) + m * cn * cn).sqrt();
    [sn, cn, dn, phi]
}

/// The incomplete elliptic integral of the first kind F(φ | m) = ∫₀^φ dθ/√(1 − m sin²θ) for
/// 0 ≤ m ≤ 1 and |φ| ≤ π: the inverse of the amplitude am(u | m).
///
/// By Carlson's duplication theorem for R_F. Source: NIST Digital Library of Mathematical
/// Functions, §19.36(i) and (19.25.5).
pub(crate) fn incomplete_elliptic(phi: f64, m: f64) -> f64 {
    use core::f64::consts::FRAC_PI_2;
    if phi.abs() > FRAC_PI_2 {
        let half_period = 2.0 * incomplete_elliptic(FRAC_PI_2, m);
        let rest = core::f64::consts::PI.copysign(phi) - phi;
        return half_period.copysign(phi) - incomplete_elliptic(rest, m);
    }
    let (sine, cosine) = phi.sin_cos();
    let (mut x, mut y, mut z) = (cosine * cosine, (1.0 - m) + m * cosine * cosine, 1.0);
    // Each duplication divides the differences by four.
    for _ in 0..26 {
        let (a, b, c) = (f64::sqrt(x), f64::sqrt(y), f64::sqrt(z));
        let lambda = a * b + b * c + c * a;
        (x, y, z) = ((x + lambda) / 4.0, (y + lambda) / 4.0, (z + lambda) / 4.0);
    }
    sine / ((x + y + z) / 3.0).sqrt()
}

#[cfg(test)]
mod tests {
    use super::{incomplete_elliptic, jacobi_elliptic};

    #[test]
    fn against_reference_values() {
        // (u, m, sn, cn, dn) with 17 digits from 40-digit arithmetic.
        let table = [
            (0.5, 0.3, 0.474_215_622_711_820_6, 0.880_408_736_426_462_4, 0.965_678_964_745_951_2),
            (2.5, 0.9, 0.999_694_538_450_586_1, 0.024_714_971_010_898_663, 0.317_095_800_686_263_5),
            (-7.25, 0.64, 0.639_712_855_116_601_1, 0.768_613_988_292_280_9, 0.859_122_329_077_229),
            (12.0, 0.01, -0.562_687_173_881_792, 0.826_669_912_570_260_5, 0.998_415_660_656_166_4),
            (
                3.0,
                0.999_999,
                0.995_054_995_047_900_6,
                0.099_325_509_463_694_94,
                0.099_330_493_629_427_57,
            ),
        ];
        for (u, m, sn, cn, dn) in table {
            let computed = jacobi_elliptic(u, m);
            for (value, expected) in computed.iter().zip([sn, cn, dn]) {
                assert!(
                    (value - expected).abs() < 2e-16 * (2.0 + f64::abs(u)),
                    "{u} {m}: {value} {expected}"
                );
            }
        }
    }

    #[test]
    fn limits_are_circular_and_hyperbolic() {
        let [sn, cn, dn, am] = jacobi_elliptic(1.3, 0.0);
        assert_eq!((sn, cn, dn, am), (1.3_f64.sin(), 1.3_f64.cos(), 1.0, 1.3));
        assert_eq!(jacobi_elliptic(1.3, 1.0)[0], 1.3_f64.tanh());
        assert!(
            jacobi_elliptic(0.3, 1.5)[0].is_nan() && jacobi_elliptic(0.3, f64::NAN)[1].is_nan()
        );
    }

    #[test]
    fn the_incomplete_integral_inverts_the_amplitude() {
        for m in [0.0, 0.3, 0.9, 0.999] {
            for phi in [-3.1, -1.0, 1e-9, 0.5, 1.5, 2.5] {
                let [.., am] = jacobi_elliptic(incomplete_elliptic(phi, m), m);
                // d am/du = dn ≥ √(1−m): the inverse magnifies nothing.
                assert!((am - phi).abs() < 4e-15, "{phi} {m}: {am}");
            }
        }
        assert!((incomplete_elliptic(1.0, 1.0) - 1.0_f64.sin().atanh()).abs() < 1e-15);
    }
}
