//! Sums, products and functions in simple form.
//!
//! Wherever the original is a real number, a simplification changes its value by rounding at most:
//!
//! * constants are computed, and constant factors of one product are multiplied, unless the product would be zero,
//!   subnormal or infinite;
//! * a quotient by a constant becomes a product with its reciprocal, unless the reciprocal is subnormal or infinite;
//! * 0 x becomes 0, and terms cancel, only if x is a real number for all real coordinates, as for polynomials; 0/y
//!   and 0 ln y stay as they are;
//! * c₁ x + c₂ x is (c₁ + c₂) x;
//! * (√x)ᶜ is x^(c/2) if x is a sum of squares or otherwise never negative.

use super::graph::{Graph, Id, Node, Unary};
use lie_poisson::Real;
use std::collections::HashMap;

impl Graph {
    /// Returns the node of a number.
    pub(crate) fn number(&mut self, value: f64) -> Id {
        // −0 and 0 are one node.
        self.place(Node::Number((value + 0.0).to_bits()))
    }

    /// Returns the node of the coordinate with an index.
    pub(crate) fn input(&mut self, index: usize) -> Id {
        self.place(Node::Input(index))
    }

    /// Returns c x for a constant c.
    pub(crate) fn scale(&mut self, c: f64, x: Id) -> Id {
        if c == 1.0 || (c == 0.0 && self.as_number(x) == Some(0.0)) {
            return x;
        }
        if c == 0.0 && self.known(x).everywhere {
            return self.number(0.0);
        }
        if let Some(value) = self.as_number(x) {
            let product = c * value;
            if !value.is_finite() || !product.is_finite() || product.is_normal() {
                return self.number(product);
            }
        }
        let (factor, base) = self.split(x);
        if factor != 1.0 && (c * factor).is_normal() {
            return self.scale(c * factor, base);
        }
        let c = self.number(c);
        self.place(Node::Multiply(c, x))
    }

    /// Returns c and y such that the node is c y. The factor c is 1 if the node is not a product with a constant.
    fn split(&self, x: Id) -> (f64, Id) {
        match self.node(x) {
            Node::Multiply(c, base) => self.as_number(c).map_or((1.0, x), |c| (c, base)),
            _ => (1.0, x),
        }
    }

    /// Returns the node of the product x y.
    pub(crate) fn multiply(&mut self, x: Id, y: Id) -> Id {
        if let Some(c) = self.as_number(x) {
            return self.scale(c, y);
        }
        if let Some(c) = self.as_number(y) {
            return self.scale(c, x);
        }
        for (x, y) in [(x, y), (y, x)] {
            // A sign, which is exact, moves to the front.
            if let (-1.0, base) = self.split(x) {
                let product = self.multiply(base, y);
                return self.scale(-1.0, product);
            }
        }
        if x == y
            && let Some(square) = self.square_of_root(x)
        {
            return square;
        }
        self.place(Node::Multiply(x.min(y), x.max(y)))
    }

    /// Returns x + y.
    pub(crate) fn add(&mut self, x: Id, y: Id) -> Id {
        match (self.as_number(x), self.as_number(y)) {
            (Some(x), Some(y)) => return self.number(x + y),
            (Some(0.0), _) => return y,
            (_, Some(0.0)) => return x,
            _ => {}
        }
        let ((c, base), (d, other)) = (self.split(x), self.split(y));
        let sum = c + d;
        if base == other && sum.is_finite() && (sum != 0.0 || self.known(base).everywhere) {
            return self.scale(sum, base);
        }
        self.place(Node::Add(x.min(y), x.max(y)))
    }

    /// Returns the sum of terms. Terms with the same non-constant factor are added first.
    pub(crate) fn sum(&mut self, terms: &[Id]) -> Id {
        let (mut sums, mut places) = (Vec::new(), HashMap::new());
        for &term in terms {
            let base = self.split(term).1;
            let known = places.get(&base).and_then(|&place: &usize| sums.get(place).copied());
            let place = *places.entry(base).or_insert(sums.len());
            match (known, sums.get_mut(place)) {
                (Some(sum), Some(entry)) => *entry = self.add(sum, term),
                _ => sums.push(term),
            }
        }
        let zero = self.number(0.0);
        sums.into_iter().fold(zero, |total, sum| self.add(total, sum))
    }

    /// Returns the node of −x.
    pub(crate) fn negate(&mut self, x: Id) -> Id {
        self.scale(-1.0, x)
    }

    /// Returns the node of the quotient x/y.
    pub(crate) fn divide(&mut self, x: Id, y: Id) -> Id {
        if let Some(divisor) = self.as_number(y) {
            if let Some(value) = self.as_number(x) {
                let quotient = value / divisor;
                if value == 0.0 || !quotient.is_finite() || quotient.is_normal() {
                    return self.number(quotient);
                }
            }
            if (1.0 / divisor).is_normal() {
                return self.scale(1.0 / divisor, x);
            }
        }
        if let (-1.0, base) = self.split(x) {
            let quotient = self.divide(base, y);
            return self.scale(-1.0, quotient);
        }
        self.place(Node::Divide(x, y))
    }

    /// Returns xᶜ for a constant c.
    pub(crate) fn power(&mut self, x: Id, c: f64) -> Id {
        if c == 0.0 {
            return self.number(1.0);
        } else if c == 1.0 {
            return x;
        } else if c == 2.0 {
            return self.multiply(x, x);
        } else if c == -1.0 {
            let one = self.number(1.0);
            return self.divide(one, x);
        } else if c == 0.5 {
            return self.function(Unary::Sqrt, x);
        }
        if c.fract() == 0.0 && whole(c).is_none() && !self.known(x).nonnegative {
            // A whole exponent beyond those of products: the sign is that of x if the exponent is odd.
            let size = self.function(Unary::Absolute, x);
            let power = self.power(size, c);
            if c % 2.0 == 0.0 {
                return power;
            }
            let sign = self.function(Unary::Sign, x);
            return self.multiply(sign, power);
        }
        if let Some(base) = self.as_number(x) {
            let value = power(base, c);
            if !value.is_finite() || value.is_normal() {
                return self.number(value);
            }
        }
        if let Some(square) = self.square_of_root(x) {
            return self.power(square, c / 2.0);
        }
        self.place(Node::Power(x, c.to_bits()))
    }

    /// Returns the node of the function value f(x).
    pub(crate) fn function(&mut self, function: Unary, x: Id) -> Id {
        match (function, self.node(x)) {
            // √(a²) = a and √(aᶜ) = a^(c/2) for a ≥ 0, whose derivatives have values where a is 0
            (Unary::Sqrt, Node::Multiply(a, b)) if a == b && self.known(a).nonnegative => return a,
            (Unary::Sqrt, Node::Power(a, bits)) if self.known(a).nonnegative => {
                return self.power(a, f64::from_bits(bits) / 2.0);
            }
            _ => {}
        }
        match self.as_number(x) {
            Some(x) => self.number(function.apply(x)),
            None => self.place(Node::Function(function, x)),
        }
    }

    /// Returns y where x ≥ 0, z where x < 0, and no number where x is none.
    pub(crate) fn choose(&mut self, x: Id, y: Id, z: Id) -> Id {
        match self.as_number(x) {
            _ if y == z && self.known(x).everywhere => y,
            Some(x) if x >= 0.0 => y,
            Some(_) => z,
            None => self.place(Node::Choose([x, y, z])),
        }
    }

    /// Returns x^c for the derivative of a power of x with a larger exponent: 0 where x is 0 and its own derivative, too.
    pub(crate) fn inner_power(&mut self, x: Id, c: f64) -> Id {
        let power = self.power(x, c);
        if !(self.known(x).flat && -0.5 < c && c < 0.0) {
            return power;
        }
        // x^(c + 1) grows more slowly than x, but its derivative x^c dx vanishes with x if x is at least quadratic.
        let (below, zero) = (self.negate(x), self.number(0.0));
        self.choose(below, zero, power)
    }

    /// Returns the angle of the point (x, y).
    pub(crate) fn angle(&mut self, y: Id, x: Id) -> Id {
        match (self.as_number(y), self.as_number(x)) {
            (Some(y), Some(x)) => self.number(y.atan2(x)),
            _ => self.place(Node::Angle(y, x)),
        }
    }
}

/// Returns the exponent as `i32` if it is a whole number of that range.
pub(crate) fn whole(exponent: f64) -> Option<i32> {
    let fits = exponent.fract() == 0.0 && exponent.abs() <= f64::from(i32::MAX);
    fits.then_some(exponent as i32)
}

/// Returns xᶜ: a product for a whole c, and exp(c ln x) for any other.
fn power(x: f64, c: f64) -> f64 {
    whole(c).map_or_else(|| (c * x.ln()).exp(), |n| Real::powi(x, n))
}

impl Unary {
    /// Returns f(x), over any scalar.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn apply<T: Real>(self, x: T) -> T {
        match self {
            Self::Sqrt => x.sqrt(),
            Self::Exp => x.exp(),
            Self::Ln => x.ln(),
            Self::Sin => x.sin(),
            Self::Cos => x.cos(),
            // sinh x = x c₁(−x²) and cosh x = c₀(−x²), accurate near 0 too
            Self::Sinh => x * (-(x * x)).stumpff(1),
            Self::Cosh => (-(x * x)).stumpff(0),
            Self::Tanh => x.tanh(),
            // + 0 makes 0 of −0
            Self::Absolute => x.select_nonnegative(x, -x) + 0.0,
            Self::Sign => x.select_nonnegative(T::from_f64(1.0), T::from_f64(-1.0)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A result below the normal numbers has lost digits that the factors still have.
    #[test]
    fn numbers_are_combined_if_they_keep_their_digits() {
        let mut graph = Graph::default();
        let [tiny, zero, infinite] = [1e-300, 0.0, f64::INFINITY].map(|x| graph.number(x));
        let [small, large, two] = [1e-10, 1e10, 2.0].map(|x| graph.number(x));
        for (id, expected) in [
            (graph.scale(2.0, tiny), Some(2e-300)),
            (graph.scale(1e-10, tiny), None),
            (graph.scale(2.0, infinite), Some(f64::INFINITY)),
            (graph.scale(1e305, large), Some(f64::INFINITY)),
            (graph.divide(zero, two), Some(0.0)),
            (graph.divide(tiny, small), Some(1e-300 / 1e-10)),
            (graph.divide(tiny, large), None),
            (graph.divide(two, zero), Some(f64::INFINITY)),
        ] {
            assert_eq!(graph.as_number(id), expected);
        }
        assert_eq!(graph.number(-0.0), zero);
    }

    #[test]
    fn equal_terms_are_added_where_the_sum_has_the_same_values() {
        let mut graph = Graph::default();
        let x = graph.input(0);
        let root = graph.function(Unary::Sqrt, x);
        let (twice, opposite) = (graph.scale(2.0, root), graph.negate(root));
        assert_eq!(graph.add(root, root), twice);
        // Not a number for negative x, as the root is.
        let rest = graph.add(root, opposite);
        assert_eq!(graph.as_number(rest), None);
        let opposite = graph.negate(x);
        let rest = graph.add(x, opposite);
        assert_eq!(graph.as_number(rest), Some(0.0));
        let largest = graph.scale(f64::MAX, x);
        assert!(
            matches!(graph.add(largest, largest), id if matches!(graph.node(id), Node::Add(..)))
        );
    }
}
