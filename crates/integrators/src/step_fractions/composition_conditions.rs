//! The order of a composition method, from its coefficients.

/// Words are compared up to this weight, or up to p + 2 if this is more.
const WEIGHTS: usize = 12;

/// How far a condition on rounded coefficients may be from zero, in units of its terms' sizes.
const TOLERANCE: f64 = 64.0 * f64::EPSILON;

/// The order of Φ_{γ_s h} ∘ … ∘ Φ_{γ_1 h} for every Φ of order `base`.
///
/// A method of order p is the time-one flow of a formal field h E_1 + h^{p+1} E_{p+1} + …, without
/// even powers if it is symmetric. In the free associative algebra of the letters E_k, of weight k,
/// the composition is the product of the exponentials exp(Σ_k γ_i^k E_k). Its order is the largest
/// weight up to which it agrees with exp(E_1).
pub(crate) fn order_over(gammas: &[f64], base: usize, symmetric: bool) -> usize {
    if base == 0 {
        return 0;
    }
    let letter = |k: usize| k == 1 || (k > base && !(symmetric && k.is_multiple_of(2)));
    let limit = WEIGHTS.max(base + 2);
    let agrees = |weight: usize| words_agree(&mut Vec::new(), weight, &letter, gammas);
    (1..=limit).take_while(|&weight| agrees(weight)).count()
}

/// Whether product and exponential agree on all words that extend `word` by `missing` weight.
fn words_agree(
    word: &mut Vec<usize>,
    missing: usize,
    letter: &impl Fn(usize) -> bool,
    gammas: &[f64],
) -> bool {
    if missing == 0 {
        let pure = word.iter().all(|&k| k == 1);
        let exact = if pure { coefficient(&[1.0], word).0 } else { 0.0 };
        let (value, size) = coefficient(gammas, word);
        return (value - exact).abs() <= TOLERANCE * size;
    }
    (1..=missing).filter(|&k| letter(k)).all(|k| {
        word.push(k);
        let agrees = words_agree(word, missing - k, letter, gammas);
        word.pop();
        agrees
    })
}

/// The coefficient of a word in Π_i exp(Σ_k γ_i^k E_k), and the size of the terms of its sum.
///
/// In one exponential a word of m letters and weight n has the coefficient γⁿ/m!; a product takes
/// the sum over all cuts of the word in two.
fn coefficient(gammas: &[f64], word: &[usize]) -> (f64, f64) {
    let mut prefixes = vec![(0.0, 0.0); word.len() + 1];
    prefixes[0] = (1.0, 1.0);
    for &gamma in gammas {
        for end in (1..=word.len()).rev() {
            let mut factor: f64 = 1.0;
            let (mut sum, mut size) = prefixes[end];
            for start in (0..end).rev() {
                factor *= gamma.powi(word[start] as i32) / (end - start) as f64;
                sum += prefixes[start].0 * factor;
                size += prefixes[start].1 * factor.abs();
            }
            prefixes[end] = (sum, size);
        }
    }
    prefixes[word.len()]
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
