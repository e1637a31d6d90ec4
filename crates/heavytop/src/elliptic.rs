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

#[cfg(test)]
mod tests {
    use super::jacobi_elliptic;

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
}
