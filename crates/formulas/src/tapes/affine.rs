//! Results that need no instruction: a multiple of one coordinate plus a constant.

use crate::graphs::graph::{Graph, Id, Node};
use lie_poisson::Real;

/// The result s x + b of a coordinate x.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Affine {
    scale: f64,
    offset: f64,
}

impl Affine {
    /// Returns s x + b.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn at<T: Real>(self, x: T) -> T {
        x * self.scale + self.offset
    }

    /// Returns the form of a node, if it is s x + b for the input of a given index.
    pub(crate) fn of(graph: &Graph, node: Id, input: usize) -> Option<Self> {
        let multiple = |node: Id| match graph.node(node) {
            Node::Input(i) if i == input => Some(1.0),
            Node::Multiply(c, x) if graph.node(x) == Node::Input(input) => graph.as_number(c),
            _ => None,
        };
        if let Some(offset) = graph.as_number(node) {
            return Some(Self { scale: 0.0, offset });
        }
        if let Some(scale) = multiple(node) {
            return Some(Self { scale, offset: 0.0 });
        }
        let Node::Add(a, b) = graph.node(node) else { return None };
        [(a, b), (b, a)]
            .into_iter()
            .find_map(|(a, b)| Some(Self { scale: multiple(a)?, offset: graph.as_number(b)? }))
    }
}
