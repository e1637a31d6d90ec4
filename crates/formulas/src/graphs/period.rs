//! The period of the values of an angle.

use super::graph::{Graph, Id, Node};
use core::f64::consts::TAU;

/// What is known of the values of a node modulo a period.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    /// The value is one number, since no angle plays a part.
    Single,
    /// The value is an angle, and therefore determined up to multiples of this period.
    Angle(f64),
    /// The value depends on the branch of an angle.
    Branched,
}

impl Graph {
    /// Returns the period of the values of a node if it is an angle: 2π for `atan2`, for sums of such angles and for sums of
    /// them and other functions, and |c| times the period for a constant factor c.
    ///
    /// Such a function jumps by its period where a continuous angle would grow further. An `atan2` one of whose arguments is
    /// known not to be negative, as those of `arcsin`, `arccos` and `arctan`, covers half a turn alone, and is no angle in
    /// this sense.
    pub(crate) fn period(&self, id: Id) -> Option<f64> {
        // Each node comes after its parts.
        let mut kinds = Vec::new();
        for place in 0..=id {
            kinds.push(self.kind(self.node(place), &kinds));
        }
        match kinds.last() {
            Some(Kind::Angle(period)) => Some(*period),
            _ => None,
        }
    }

    /// Returns what is known of the values of a node, from what is known of its parts.
    fn kind(&self, node: Node, kinds: &[Kind]) -> Kind {
        let of = |part: Id| kinds.get(part).copied().unwrap_or(Kind::Branched);
        let is_single = node.parts().all(|part| of(part) == Kind::Single);
        match node {
            Node::Angle(y, x) if !(self.is_half(y) || self.is_half(x)) => Kind::Angle(TAU),
            _ if is_single => Kind::Single,
            Node::Add(x, y) => match (of(x), of(y)) {
                (Kind::Angle(period), Kind::Single) | (Kind::Single, Kind::Angle(period)) => {
                    Kind::Angle(period)
                }
                (Kind::Angle(one), Kind::Angle(other)) if one == other => Kind::Angle(one),
                _ => Kind::Branched,
            },
            Node::Multiply(x, y) => match (self.as_number(x), of(y)) {
                (Some(factor), Kind::Angle(period)) if factor != 0.0 => {
                    Kind::Angle(factor.abs() * period)
                }
                _ => Kind::Branched,
            },
            _ => Kind::Branched,
        }
    }

    /// Returns whether a coordinate of a point is known to be in one half of the plane, where the angle does not jump.
    fn is_half(&self, coordinate: Id) -> bool {
        self.known(coordinate).nonnegative
    }
}
