//! Powers as products, roots and exponentials.

use super::graph::{Graph, Id, Node, Unary};
use super::simplification::whole;

/// The largest exponent for which a power is expanded into products, whose squares other powers can share.
const MOST_FACTORS: u32 = 64;

impl Graph {
    /// Returns the same expressions in a new graph, in which the only powers are those with large whole exponents.
    ///
    /// The products are those of [`Real::powi`](lie_poisson::Real::powi), in its order: x⁵ = x (x²)². Other powers
    /// are x^(n+½) = xⁿ √x and x^c = exp(c ln x).
    pub(crate) fn without_powers(&self, roots: &[Id]) -> (Self, Vec<Id>) {
        let (reachable, mut new) = (self.reachable(roots), Self::default());
        let mut places = vec![0; self.len()];
        for id in (0..self.len()).filter(|&id| reachable.get(id) == Some(&true)) {
            let at = |part: Id| places.get(part).copied().unwrap_or(0);
            let place = match self.node(id) {
                Node::Add(a, b) => new.place(Node::Add(at(a), at(b))),
                Node::Multiply(a, b) => new.place(Node::Multiply(at(a), at(b))),
                Node::Divide(a, b) => new.place(Node::Divide(at(a), at(b))),
                Node::Function(function, a) => new.place(Node::Function(function, at(a))),
                Node::Angle(y, x) => new.place(Node::Angle(at(y), at(x))),
                Node::Hypotenuse(x, y) => new.place(Node::Hypotenuse(at(x), at(y))),
                Node::Choose(parts) => new.place(Node::Choose(parts.map(at))),
                Node::Power(a, bits) => new.expanded(at(a), f64::from_bits(bits)),
                node @ (Node::Number(_) | Node::Input(_)) => new.place(node),
            };
            if let Some(entry) = places.get_mut(id) {
                *entry = place;
            }
        }
        let roots = roots.iter().map(|&root| places.get(root).copied().unwrap_or(0)).collect();
        (new, roots)
    }

    /// Returns xᶜ as products, roots or an exponential.
    fn expanded(&mut self, x: Id, c: f64) -> Id {
        let below = c.floor();
        if let Some(n) = whole(c) {
            return self.whole_power(x, n);
        }
        if let (0.5, Some(n)) = (c - below, whole(below)) {
            // x^(−3/2) = 1/(x √x)
            let (n, inverse) = if n < 0 { (-(n + 1), true) } else { (n, false) };
            let root = self.place(Node::Function(Unary::Sqrt, x));
            let power = self.whole_power(x, n);
            let product = if n == 0 { root } else { self.place(Node::Multiply(power, root)) };
            return if inverse { self.inverse(product) } else { product };
        }
        let (c, logarithm) = (self.number(c), self.place(Node::Function(Unary::Ln, x)));
        let product = self.place(Node::Multiply(c, logarithm));
        self.place(Node::Function(Unary::Exp, product))
    }

    fn inverse(&mut self, x: Id) -> Id {
        let one = self.number(1.0);
        self.place(Node::Divide(one, x))
    }

    /// Returns xⁿ as a product of repeated squares, or its reciprocal.
    fn whole_power(&mut self, x: Id, n: i32) -> Id {
        let mut left = n.unsigned_abs();
        if left > MOST_FACTORS {
            return self.place(Node::Power(x, f64::from(n).to_bits()));
        }
        let (mut square, mut power) = (x, None);
        while left > 0 {
            if left % 2 == 1 {
                power = Some(match power {
                    Some(power) => self.place(Node::Multiply(square, power)),
                    None => square,
                });
            }
            left /= 2;
            if left > 0 {
                square = self.place(Node::Multiply(square, square));
            }
        }
        let power = power.unwrap_or_else(|| self.number(1.0));
        if n < 0 { self.inverse(power) } else { power }
    }
}
