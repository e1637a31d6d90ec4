//! Functions that are made of others.

use super::graph::{Graph, Id, Node, Unary};
use lie_poisson::euclidean_norm;
use nalgebra::Vector2;

impl Graph {
    /// Returns √(x² + y²), which is |x| for y = 0.
    pub(crate) fn hypotenuse(&mut self, x: Id, y: Id) -> Id {
        match (self.as_number(x), self.as_number(y)) {
            (Some(x), Some(y)) => self.number(euclidean_norm(&Vector2::new(x, y))),
            (Some(0.0), _) => self.function(Unary::Absolute, y),
            (_, Some(0.0)) => self.function(Unary::Absolute, x),
            _ => self.place(Node::Hypotenuse(x.min(y), x.max(y))),
        }
    }

    /// Returns a number y whose root √y a node is, if y cannot be negative.
    pub(crate) fn square_of_root(&mut self, root: Id) -> Option<Id> {
        match self.node(root) {
            Node::Function(Unary::Sqrt, square) => self.known(square).nonnegative.then_some(square),
            Node::Hypotenuse(x, y) => {
                let (xx, yy) = (self.multiply(x, x), self.multiply(y, y));
                Some(self.add(xx, yy))
            }
            _ => None,
        }
    }

    /// Returns arcsin x, the angle of the point (√(1 − x²), x), in [−π/2, π/2].
    pub(crate) fn arcsine(&mut self, x: Id) -> Id {
        let root = self.complement(x);
        self.angle(x, root)
    }

    /// Returns arccos x, the angle of the point (x, √(1 − x²)), in [0, π].
    pub(crate) fn arccosine(&mut self, x: Id) -> Id {
        let root = self.complement(x);
        self.angle(root, x)
    }

    /// Returns √(1 − x²) as √((1 − x)(1 + x)), which is accurate near x = ±1 too.
    fn complement(&mut self, x: Id) -> Id {
        let (one, negative) = (self.number(1.0), self.negate(x));
        let (below, above) = (self.add(one, negative), self.add(one, x));
        let square = self.multiply(below, above);
        self.function(Unary::Sqrt, square)
    }

    /// Returns log₁₀ x = ln x/ln 10.
    pub(crate) fn decadic_logarithm(&mut self, x: Id) -> Id {
        let (logarithm, ten) = (self.function(Unary::Ln, x), self.number(core::f64::consts::LN_10));
        self.divide(logarithm, ten)
    }

    /// Returns ∛x, with the sign of x.
    ///
    /// It is r = |x|^(1/3) = exp(ln|x|/3), corrected by a step of Newton's method, (2r + |x|/r²)/3, since the
    /// exponential of a large number has large rounding errors; at x = 0 it is r = 0, whose slope is infinite.
    pub(crate) fn cube_root(&mut self, x: Id) -> Id {
        let size = self.function(Unary::Absolute, x);
        let root = self.power(size, 1.0 / 3.0);
        let square = self.multiply(root, root);
        let (twice, quotient) = (self.scale(2.0, root), self.divide(size, square));
        let sum = self.add(twice, quotient);
        let corrected = self.scale(1.0 / 3.0, sum);
        let below = self.negate(size);
        let root = self.choose(below, root, corrected);
        let sign = self.function(Unary::Sign, x);
        self.multiply(sign, root)
    }
}
