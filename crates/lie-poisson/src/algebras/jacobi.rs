//! The Jacobi identity for a table of structure constants of any size.

use generic_scalars::larger;

/// The brackets of the basis vectors, in numbers whose products do not overflow.
pub(crate) struct Brackets {
    dimension: usize,
    /// The coordinates of [e_i, e_j] that are not zero, at i N + j in N dimensions.
    rows: Vec<Vec<(usize, Extended)>>,
    /// The maximum norms of the brackets, in the same order.
    norms: Vec<Extended>,
}

impl Brackets {
    /// Creates the table of structure constants (i, j, k, c[i][j][k]) whose indices are below the dimension.
    pub(crate) fn new(
        dimension: usize,
        entries: impl Iterator<Item = (usize, usize, usize, f64)>,
    ) -> Self {
        let mut rows = vec![Vec::new(); dimension * dimension];
        let mut norms = vec![0.0; dimension * dimension];
        for (i, j, k, value) in entries {
            rows[i * dimension + j].push((k, Extended::new(value)));
            norms[i * dimension + j] = larger(norms[i * dimension + j], value.abs());
        }
        Self { dimension, rows, norms: norms.into_iter().map(Extended::new).collect() }
    }

    fn row(&self, i: usize, j: usize) -> &[(usize, Extended)] {
        &self.rows[i * self.dimension + j]
    }

    fn constant(&self, i: usize, j: usize, k: usize) -> Extended {
        let found = self.row(i, j).iter().find(|(index, _)| *index == k);
        found.map_or(Extended::new(0.0), |(_, value)| *value)
    }

    /// Returns the coordinates at which the cyclic sum of [e_i, [e_j, e_k]] has a term; the others are zero.
    pub(crate) fn reached(&self, [i, j, k]: [usize; 3]) -> Vec<usize> {
        let cyclic = [(i, j, k), (j, k, i), (k, i, j)];
        let inner = cyclic.into_iter().flat_map(|(a, b, d)| {
            self.row(b, d).iter().flat_map(move |(l, _)| self.row(a, *l)).map(|(m, _)| *m)
        });
        let mut reached: Vec<usize> = inner.collect();
        reached.sort_unstable();
        reached.dedup();
        reached
    }

    /// Returns the maximum norm of [e_i, e_j].
    pub(crate) fn norm(&self, i: usize, j: usize) -> Extended {
        self.norms[i * self.dimension + j]
    }

    /// Returns the m-th coordinate of the cyclic sum of [e_i, [e_j, e_k]], relative to the size of its
    /// terms.
    pub(crate) fn jacobi_residual(&self, [i, j, k]: [usize; 3], m: usize) -> f64 {
        let cyclic = [(i, j, k), (j, k, i), (k, i, j)];
        let n = self.dimension;
        let factors = || {
            cyclic.into_iter().flat_map(|(a, b, d)| (0..n).map(move |l| (a, b, d, l))).map(
                |(a, b, d, l)| {
                    let inner = [self.constant(b, d, l), self.norm(b, d)];
                    (inner, [self.constant(a, l, m), self.norm(a, l)])
                },
            )
        };
        let sizes = || {
            factors().flat_map(|([inner, inner_norm], [outer, outer_norm])| {
                [inner_norm.times(outer), inner.times(outer_norm)]
            })
        };
        // The sizes bound the terms, so that no term overflows in units of the largest size.
        let Some(unit) = sizes().filter(|x| !x.is_zero()).map(|x| x.exponent).max() else {
            return 0.0;
        };
        let sum: f64 = factors().map(|([c, _], [d, _])| c.times(d).in_units_of(unit)).sum();
        let size: f64 = sizes().map(|size| size.in_units_of(unit).abs()).sum();
        (sum / size).abs()
    }
}

/// A number mantissa · 2ⁿ, with n the exponent, that may lie beyond the range of `f64`.
#[derive(Clone, Copy)]
pub(crate) struct Extended {
    /// The mantissa: 0, or a number of size between 1 and 4.
    mantissa: f64,
    /// The exponent of two, without meaning for zero.
    exponent: i32,
}

impl Extended {
    /// Converts a finite number.
    fn new(x: f64) -> Self {
        if x == 0.0 {
            return Self { mantissa: 0.0, exponent: 0 };
        }
        // The logarithm of the largest number rounds to 1024, and 2¹⁰²⁴ overflows.
        let exponent = x.abs().log2().floor().min(1023.0);
        Self { mantissa: x / exponent.exp2(), exponent: exponent as i32 }
    }

    pub(crate) fn is_zero(self) -> bool {
        self.mantissa == 0.0
    }

    /// Returns the product of two numbers, neither of which is itself a product.
    fn times(self, other: Self) -> Self {
        Self { mantissa: self.mantissa * other.mantissa, exponent: self.exponent + other.exponent }
    }

    /// Returns the number divided by 2ⁿ, where n is `unit`.
    fn in_units_of(self, unit: i32) -> f64 {
        if self.is_zero() { 0.0 } else { self.mantissa * f64::from(self.exponent - unit).exp2() }
    }
}
