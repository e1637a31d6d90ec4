//! Expressions as a graph in which equal expressions are one node: [`Graph`].

use std::collections::HashMap;

/// A function of one scalar.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Unary {
    Sqrt,
    Exp,
    Ln,
    Sin,
    Cos,
    Sinh,
    Cosh,
    Tanh,
    Absolute,
    /// 1 for x ≥ 0 and −1 elsewhere, the slope of |x|.
    Sign,
}

/// A node, by its place in the graph.
pub(crate) type Id = usize;

/// An expression in terms of nodes that were added before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Node {
    /// A number, by its bits.
    Number(u64),
    Input(usize),
    Add(Id, Id),
    Multiply(Id, Id),
    Divide(Id, Id),
    /// A power with a constant exponent, by the bits of the exponent.
    Power(Id, u64),
    Function(Unary, Id),
    /// The angle of the point (x, y), with y first.
    Angle(Id, Id),
    /// √(x² + y²), also where the squares are out of range.
    Hypotenuse(Id, Id),
    /// The second where the first is ≥ 0, the third where it is negative, and no number where it is none.
    Choose([Id; 3]),
}

impl Node {
    /// Returns the nodes that this one refers to.
    pub(crate) fn parts(self) -> impl Iterator<Item = Id> {
        let parts = match self {
            Self::Number(_) | Self::Input(_) => [None; 3],
            Self::Add(a, b)
            | Self::Multiply(a, b)
            | Self::Divide(a, b)
            | Self::Angle(a, b)
            | Self::Hypotenuse(a, b) => [Some(a), Some(b), None],
            Self::Power(a, _) | Self::Function(_, a) => [Some(a), None, None],
            Self::Choose(parts) => parts.map(Some),
        };
        parts.into_iter().flatten()
    }
}

/// Properties of the values of a node, if they are known.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Known {
    /// The value is a real number for all real coordinates, as that of a polynomial is.
    pub(crate) everywhere: bool,
    /// The value is not negative where it is a real number.
    pub(crate) nonnegative: bool,
    /// The value is not negative, and smooth where it is 0, so that its derivative is 0 there, too. Sums of squares are
    /// of this kind.
    pub(crate) flat: bool,
}

/// A graph of expressions, in which each node comes after those that it refers to.
#[derive(Clone, Debug, Default)]
pub(crate) struct Graph {
    nodes: Vec<Node>,
    known: Vec<Known>,
    places: HashMap<Node, Id>,
}

impl Graph {
    /// Returns the node at a place.
    pub(crate) fn node(&self, id: Id) -> Node {
        self.nodes.get(id).copied().unwrap_or(Node::Number(0))
    }

    /// Returns the known properties of the values of a node.
    pub(crate) fn known(&self, id: Id) -> Known {
        self.known.get(id).copied().unwrap_or_default()
    }

    /// Returns the number of nodes.
    pub(crate) fn len(&self) -> usize {
        self.nodes.len()
    }

    /// Returns the value of a number, and `None` for every other node.
    pub(crate) fn as_number(&self, id: Id) -> Option<f64> {
        match self.node(id) {
            Node::Number(bits) => Some(f64::from_bits(bits)),
            _ => None,
        }
    }

    /// Returns the place of a node, if the graph has it.
    pub(crate) fn find(&self, node: Node) -> Option<Id> {
        self.places.get(&node).copied()
    }

    /// Returns the place of a node, and adds the node if it is new.
    pub(crate) fn place(&mut self, node: Node) -> Id {
        if let Some(&place) = self.places.get(&node) {
            return place;
        }
        let known = self.judge(node);
        self.nodes.push(node);
        self.known.push(known);
        self.places.insert(node, self.nodes.len() - 1);
        self.nodes.len() - 1
    }

    /// Derives the known properties of the values of a new node.
    fn judge(&self, node: Node) -> Known {
        let both = |a: Id, b: Id| self.known(a).everywhere && self.known(b).everywhere;
        let positive = |a: Id| self.known(a).nonnegative;
        let (everywhere, nonnegative) = match node {
            Node::Number(bits) => (f64::from_bits(bits).is_finite(), f64::from_bits(bits) >= 0.0),
            Node::Input(_) => (true, false),
            Node::Add(a, b) => (both(a, b), positive(a) && positive(b)),
            Node::Multiply(a, b) => (both(a, b), a == b || positive(a) && positive(b)),
            Node::Divide(a, b) => (
                self.known(a).everywhere && self.as_number(b).is_some_and(|b| b != 0.0),
                positive(a) && positive(b),
            ),
            Node::Power(a, bits) => {
                let exponent = f64::from_bits(bits);
                let whole = exponent.fract() == 0.0;
                let even = whole && exponent % 2.0 == 0.0;
                (self.known(a).everywhere && whole && exponent >= 0.0, even || positive(a))
            }
            Node::Function(function, a) => {
                let entire = !matches!(function, Unary::Sqrt | Unary::Ln);
                let even =
                    matches!(function, Unary::Sqrt | Unary::Exp | Unary::Cosh | Unary::Absolute);
                (self.known(a).everywhere && entire, even)
            }
            Node::Angle(..) => (false, false),
            Node::Hypotenuse(..) => (false, true),
            Node::Choose([c, a, b]) => {
                (self.known(c).everywhere && both(a, b), positive(a) && positive(b))
            }
        };
        Known { everywhere, nonnegative, flat: nonnegative && self.is_flat(node) }
    }

    /// Returns whether an expression has parts that are chosen by a condition or a sign.
    pub(crate) fn is_piecewise(&self, root: Id) -> bool {
        let reachable = self.reachable(&[root]);
        let parts = self.nodes.iter().zip(reachable).filter(|(_, is_part)| *is_part);
        let chosen = |node: &Node| {
            let sign = matches!(node, Node::Function(Unary::Sign | Unary::Absolute, _));
            sign || matches!(node, Node::Choose(_))
        };
        parts.map(|(node, _)| node).any(chosen)
    }

    /// Returns whether the derivative of a node that is not negative is 0 where the node is.
    fn is_flat(&self, node: Node) -> bool {
        let flat = |a: Id| self.known(a).flat;
        match node {
            Node::Number(_) => true,
            Node::Multiply(a, b) if a == b => self.known(a).everywhere,
            Node::Add(a, b) | Node::Multiply(a, b) => flat(a) && flat(b),
            Node::Power(a, bits) => {
                let exponent = f64::from_bits(bits);
                let square = exponent >= 2.0 && self.known(a).everywhere;
                square || flat(a) && exponent >= 1.0
            }
            Node::Function(function, _) => matches!(function, Unary::Exp | Unary::Cosh),
            Node::Divide(..)
            | Node::Angle(..)
            | Node::Hypotenuse(..)
            | Node::Choose(_)
            | Node::Input(_) => false,
        }
    }

    /// Returns whether each node is one of `roots` or a part of them.
    pub(crate) fn reachable(&self, roots: &[Id]) -> Vec<bool> {
        let mut reachable = vec![false; self.len()];
        for &root in roots {
            if let Some(mark) = reachable.get_mut(root) {
                *mark = true;
            }
        }
        for id in (0..self.len()).rev() {
            if reachable.get(id) == Some(&true) {
                for part in self.node(id).parts() {
                    if let Some(mark) = reachable.get_mut(part) {
                        *mark = true;
                    }
                }
            }
        }
        reachable
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quotients_and_powers_have_a_value_everywhere_or_not() {
        let mut graph = Graph::default();
        let (x, two, zero) = (graph.input(0), graph.number(2.0), graph.number(0.0));
        let root = graph.place(Node::Function(Unary::Sqrt, x));
        let mut everywhere = |node| {
            let id = graph.place(node);
            graph.known(id).everywhere
        };
        let power = |a, exponent: f64| Node::Power(a, exponent.to_bits());
        for (node, expected) in [
            (Node::Divide(x, two), true),
            (Node::Divide(x, zero), false),
            (Node::Divide(two, x), false),
            (Node::Divide(root, two), false),
            (power(x, 2.0), true),
            (power(x, 3.0), true),
            (power(x, -1.0), false),
            (power(x, 0.5), false),
            (power(root, 2.0), false),
        ] {
            assert_eq!(everywhere(node), expected, "{node:?}");
        }
    }

    #[test]
    fn even_powers_and_powers_of_roots_are_not_negative() {
        let mut graph = Graph::default();
        let x = graph.input(0);
        let root = graph.place(Node::Function(Unary::Sqrt, x));
        for (base, exponent, expected) in [
            (x, 4.0, true),
            (x, -2.0, true),
            (x, 3.0, false),
            (x, 0.5, false),
            (x, 2.5, false),
            (root, 3.0, true),
            (root, 2.5, true),
        ] {
            let power = graph.place(Node::Power(base, f64::to_bits(exponent)));
            assert_eq!(graph.known(power).nonnegative, expected, "{base} {exponent}");
        }
    }
}
