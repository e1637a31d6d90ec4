//! Results that need no instruction: sums of multiples of coordinates, and a constant.

use crate::graphs::graph::{Graph, Id, Node};
use lie_poisson::Real;
use std::collections::BTreeMap;

/// The largest number of coordinates besides one's own. Longer sums may have parts in common, which instructions compute once.
const MOST: usize = 8;

/// The part s x + b of a result, of its own coordinate x.
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
}

/// The part Σ_j c_j x_j of a result, of other coordinates: the index and the factor of each.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Others(Box<[(u16, f64)]>);

impl Others {
    /// Returns whether there are none.
    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Returns a sum with the terms added.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn added_to<T: Real>(&self, sum: T, input: impl Fn(usize) -> T) -> T {
        let mut sum = sum;
        for &(i, factor) in &*self.0 {
            sum += input(usize::from(i)) * factor;
        }
        sum
    }
}

/// Returns the parts of a node, if it is such a sum with the input of a given index as its own.
pub(crate) fn linear(graph: &Graph, node: Id, own: usize) -> Option<(Affine, Others)> {
    let mut sum = Sum::default();
    sum.add(graph, node, 1.0)?;
    let Sum { offset, mut factors } = sum;
    let scale = factors.remove(&own).unwrap_or(0.0);
    let others = factors.into_iter().map(|(i, factor)| Some((u16::try_from(i).ok()?, factor)));
    let others: Box<[_]> = others.collect::<Option<_>>()?;
    (others.len() <= MOST).then_some((Affine { scale, offset }, Others(others)))
}

/// A constant, and the factor of each coordinate.
#[derive(Default)]
struct Sum {
    offset: f64,
    factors: BTreeMap<usize, f64>,
}

impl Sum {
    /// Adds a multiple of a node; `None` if it is no such sum, or a factor has fewer digits than a normal number.
    fn add(&mut self, graph: &Graph, node: Id, factor: f64) -> Option<()> {
        if !factor.is_normal() || self.factors.len() > MOST + 1 {
            return None;
        }
        match graph.node(node) {
            Node::Number(bits) => self.offset += factor * f64::from_bits(bits),
            Node::Input(i) => *self.factors.entry(i).or_insert(0.0) += factor,
            Node::Add(a, b) => {
                self.add(graph, a, factor)?;
                self.add(graph, b, factor)?;
            }
            Node::Multiply(c, x) => self.add(graph, x, factor * graph.as_number(c)?)?,
            _ => return None,
        }
        Some(())
    }
}
