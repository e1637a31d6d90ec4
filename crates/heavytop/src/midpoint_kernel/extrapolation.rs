//! a of the next step, from those of the last ones.

use super::components::{Components, each};
use lie_poisson::Lanes;

/// How many steps are remembered.
const DEPTH: usize = 10;

/// The length of the ring that they are in, a power of two.
const RING: usize = 16;

/// (−1)^{k+1} binomial(n, k), k = 1, …, n, in row n − 1: the polynomial of degree n − 1 through the
/// last n values, at the next point; the newest first.
const WEIGHTS: [[f64; DEPTH]; DEPTH] = weights();

const fn weights() -> [[f64; DEPTH]; DEPTH] {
    let mut table = [[0.0; DEPTH]; DEPTH];
    let mut n = 1;
    while n <= DEPTH {
        let (mut k, mut w) = (1, 1.0);
        while k <= n {
            w *= (n + 1 - k) as f64 / k as f64;
            table[n - 1][k - 1] = if k % 2 == 1 { w } else { -w };
            k += 1;
        }
        n += 1;
    }
    table
}

/// The last values of a, in a ring.
#[derive(Clone, Debug)]
pub(super) struct Extrapolation<S> {
    ring: [Components<S>; RING],
    /// Where the next one goes.
    next: usize,
    /// How many there are.
    known: usize,
}

impl<S: Lanes> Extrapolation<S> {
    /// Nothing is known.
    #[inline(always)]
    pub fn new() -> Self {
        let zero = S::from_f64(0.0);
        Self { ring: [[zero; 3]; RING], next: 0, known: 0 }
    }

    /// The next value, if anything is known, the newest term last, which is the one that is waited
    /// for. `read` makes lanes to compute with from those that are stored.
    #[inline(always)]
    pub fn predict<T: Lanes>(&self, read: impl Fn(S) -> T) -> Option<Components<T>> {
        let weights = WEIGHTS.get(self.known.checked_sub(1)?)?;
        let mut sum = [T::from_f64(0.0); 3];
        let mut k = DEPTH;
        while k > 0 {
            let a = &self.ring[self.next.wrapping_sub(k) & (RING - 1)];
            let w = T::from_f64(weights[k - 1]);
            sum = each!(i => w.multiply_add(read(a[i]), sum[i]));
            k -= 1;
        }
        Some(sum)
    }

    /// Remembers a value.
    #[inline(always)]
    pub fn push(&mut self, a: Components<S>) {
        self.ring[self.next & (RING - 1)] = a;
        self.next = self.next.wrapping_add(1) & (RING - 1);
        self.known = if self.known < DEPTH { self.known + 1 } else { DEPTH };
    }

    /// The last value that was remembered.
    #[inline(always)]
    pub fn newest(&self) -> Components<S> {
        self.ring[self.next.wrapping_sub(1) & (RING - 1)]
    }
}
