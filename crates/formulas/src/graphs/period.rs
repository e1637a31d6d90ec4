//! The period of the values of an angle.

use super::graph::{Graph, Id, Node};
use core::f64::consts::TAU;

/// What is known of the values of a node modulo a period.
enum Kind {
    Constant,
    Angle(f64),
}

impl Graph {
    /// Returns the period of the values of a node if it is an angle: 2π for `atan2`, for sums of such angles and for sums of
    /// them and constants, and |c| times the period for a constant factor c.
    ///
    /// Such a function jumps by its period where a continuous angle would grow further.
    pub(crate) fn period(&self, id: Id) -> Option<f64> {
        // Each node comes after its parts.
        let mut kinds: Vec<Option<Kind>> = Vec::new();
        for place in 0..=id {
            let kind = |part: Id| kinds.get(part).and_then(Option::as_ref);
            let own = match self.node(place) {
                Node::Number(_) => Some(Kind::Constant),
                Node::Angle(..) => Some(Kind::Angle(TAU)),
                Node::Add(x, y) => match (kind(x), kind(y)) {
                    (Some(Kind::Angle(period)), Some(Kind::Constant))
                    | (Some(Kind::Constant), Some(Kind::Angle(period))) => {
                        Some(Kind::Angle(*period))
                    }
                    (Some(Kind::Angle(one)), Some(Kind::Angle(other))) if one == other => {
                        Some(Kind::Angle(*one))
                    }
                    _ => None,
                },
                Node::Multiply(x, y) => match (self.as_number(x), kind(y)) {
                    (Some(factor), Some(Kind::Angle(period))) if factor != 0.0 => {
                        Some(Kind::Angle(factor.abs() * period))
                    }
                    _ => None,
                },
                _ => None,
            };
            kinds.push(own);
        }
        match kinds.pop() {
            Some(Some(Kind::Angle(period))) => Some(period),
            _ => None,
        }
    }
}
