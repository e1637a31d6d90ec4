//! The extrapolation of a from the last steps to the next one.

use super::register_vector::RegisterVector;
use lie_poisson::Real;

/// The number of steps that are remembered.
const DEPTH: usize = 10;

/// The weights of the extrapolation: row n − 1 has the polynomial of degree n − 1 through the last n values,
/// at the next point.
///
/// At the end of the row are −(−1)ᵏ binomial(n, k), k = n, …, 1, with the newest value last.
const WEIGHTS: [[f64; DEPTH]; DEPTH] = weights();

const fn weights() -> [[f64; DEPTH]; DEPTH] {
    let mut table = [[0.0; DEPTH]; DEPTH];
    let mut n = 1;
    while n <= DEPTH {
        let (mut k, mut w) = (1, 1.0);
        while k <= n {
            w *= (n + 1 - k) as f64 / k as f64;
            table[n - 1][DEPTH - k] = if k % 2 == 1 { w } else { -w };
            k += 1;
        }
        n += 1;
    }
    table
}

/// The last values of a, in the form `S` in which they are stored.
#[derive(Clone, Debug)]
pub(super) struct Extrapolation<S> {
    /// The values, each stored twice, `DEPTH` apart, so that the last ones are side by side, the oldest
    /// first.
    values: [S; 2 * DEPTH],
    /// The index of the oldest value.
    oldest: usize,
    /// The number of values that are known.
    known: usize,
}

impl<S: Copy> Extrapolation<S> {
    /// Creates an empty history.
    #[cfg_attr(optimised, inline(always))]
    pub fn new(zero: S) -> Self {
        Self { values: [zero; 2 * DEPTH], oldest: 0, known: 0 }
    }

    /// Returns the next value by extrapolation, or `None` if no value is known.
    ///
    /// `read` converts stored vectors to those of the computation. The newest term is added last, since it is
    /// available last.
    #[cfg_attr(optimised, inline(always))]
    pub fn predict<V: RegisterVector>(&self, read: impl Fn(&S) -> V) -> Option<V> {
        let weights = WEIGHTS.get(self.known.checked_sub(1)?)?;
        let window = self.values.get(self.oldest..)?.first_chunk::<DEPTH>()?;
        let number = |x| V::uniform(V::Scalar::from_f64(x));
        let mut sum = number(weights[0]).times(read(&window[0]));
        let mut k = 1;
        while k < DEPTH {
            sum = number(weights[k]).multiply_add(read(&window[k]), sum);
            k += 1;
        }
        Some(sum)
    }

    /// Records a value, which the given function writes.
    #[cfg_attr(optimised, inline(always))]
    pub fn push(&mut self, write: impl Fn(&mut S)) {
        let (first, second) = self.values.split_at_mut(DEPTH);
        if let (Some(first), Some(second)) =
            (first.get_mut(self.oldest), second.get_mut(self.oldest))
        {
            write(first);
            write(second);
        }
        self.oldest = if self.oldest + 1 < DEPTH { self.oldest + 1 } else { 0 };
        self.known = if self.known < DEPTH { self.known + 1 } else { DEPTH };
    }

    /// Returns the last value that was recorded.
    #[cfg_attr(optimised, inline(always))]
    pub fn newest(&self) -> &S {
        &self.values[self.oldest + DEPTH - 1]
    }
}
