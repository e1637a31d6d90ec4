//! The order of a composition method, from its coefficients.

/// The largest weight up to which words are compared, or p + 2 if that is larger.
const WEIGHTS: usize = 12;

/// The largest value of a condition on rounded coefficients that counts as zero, in units of the sizes of its terms.
///
/// This is for weights up to [`WEIGHTS`]. Above, rounding errors of the powers grow with the weight.
const TOLERANCE: f64 = 64.0 * f64::EPSILON;

/// Returns the order of the composition Φ(γ_s h) ∘ … ∘ Φ(γ₁ h) for every method Φ(h) of order p = `base`.
///
/// A method of order p is the time-one flow of a formal field h E₁ + hᵖ⁺¹ E(p+1) + …, without even powers if it is
/// symmetric. In the free associative algebra of the letters E_k, of weight k, the composition is the product of the
/// exponentials exp(Σ_k γ_iᵏ E_k). Its order is the largest weight up to which it agrees with exp(E₁).
///
/// Words of E₁ alone agree if γ₁ + … + γ_s = 1. Other words have a weight above p.
pub(crate) fn order_over(gammas: &[f64], base: usize, symmetric: bool) -> usize {
    if base == 0 || !agrees(gammas, &[1], 1) {
        return 0;
    }
    // The coefficients of the other words are homogeneous in γ and must vanish. After division by the largest γ,
    // overflow and underflow of powers do not matter.
    let largest = gammas.iter().fold(0.0, |most: f64, gamma| most.max(gamma.abs()));
    let gammas: Vec<f64> = gammas.iter().map(|gamma| gamma / largest).collect();
    let letter = |k: usize| !(symmetric && k.is_multiple_of(2));
    let mut order = base;
    let limit = WEIGHTS.max(base.saturating_add(2));
    while order < limit && words_agree(&mut Vec::new(), order + 1, base, &letter, &gammas) {
        order += 1;
    }
    order
}

/// Returns whether product and exponential agree on all words that extend `word` by `missing` weight.
///
/// The words have a letter beyond E₁, which is one of E_k, k > `base`.
fn words_agree(
    word: &mut Vec<usize>,
    missing: usize,
    base: usize,
    letter: &impl Fn(usize) -> bool,
    gammas: &[f64],
) -> bool {
    let pure = word.iter().all(|&k| k == 1);
    if missing == 0 || (pure && missing <= base) {
        return pure || agrees(gammas, word, 0);
    }
    let letters = (base.saturating_add(1)..=missing).filter(|&k| letter(k));
    core::iter::once(1).chain(letters).all(|k| {
        word.push(k);
        let agree = words_agree(word, missing - k, base, letter, gammas);
        word.pop();
        agree
    })
}

/// Returns whether the coefficient of a word is `exact` to within rounding.
fn agrees(gammas: &[f64], word: &[usize], exact: u8) -> bool {
    let (value, size) = coefficient(gammas, word);
    let weight = word.iter().map(|&k| k as f64).sum::<f64>();
    let tolerance = TOLERANCE * (weight / WEIGHTS as f64).max(1.0);
    (value - f64::from(exact)).abs() <= tolerance * size
}

/// Returns the coefficient of a word in Π_i exp(Σ_k γ_iᵏ E_k), and the size of the terms of its sum.
///
/// In one exponential a word of m letters and weight n has the coefficient γⁿ/m!. In a product the coefficient is the
/// sum over all cuts of the word in two.
fn coefficient(gammas: &[f64], word: &[usize]) -> (f64, f64) {
    let mut prefixes = vec![(0.0, 0.0); word.len() + 1];
    prefixes[0] = (1.0, 1.0);
    for &gamma in gammas {
        for end in (1..=word.len()).rev() {
            let mut factor: f64 = 1.0;
            let (mut sum, mut size) = prefixes[end];
            for start in (0..end).rev() {
                factor *= power(gamma, word[start]) / (end - start) as f64;
                sum += prefixes[start].0 * factor;
                size += prefixes[start].1 * factor.abs();
            }
            prefixes[end] = (sum, size);
        }
    }
    prefixes[word.len()]
}

/// Returns the power γᵏ, or NaN for a k so large that rounding leaves no digits.
fn power(gamma: f64, k: usize) -> f64 {
    i32::try_from(k).map_or(f64::NAN, |k| gamma.powi(k))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coefficients_are_those_of_exponentials() {
        // exp(γE₁ + γ³E₃) on E₁E₃: γ⁴/2; the product of two on E₁E₃ adds the cut, γ₁·γ₂³.
        assert_eq!(coefficient(&[2.0], &[1, 3]).0, 8.0);
        assert_eq!(coefficient(&[2.0, -1.0], &[1, 3]).0, 8.0 - 2.0 + 0.5);
    }

    #[test]
    fn splitting_a_step_evenly_changes_nothing() {
        for (base, symmetric) in [(1, false), (2, true), (2, false), (3, false), (4, true)] {
            assert_eq!(order_over(&[1.0], base, symmetric), base);
            assert_eq!(order_over(&[0.25; 4], base, symmetric), base);
        }
        assert_eq!(order_over(&[1.0], 0, false), 0);
        assert_eq!(order_over(&[0.5, 0.6], 2, true), 0);
    }
}
