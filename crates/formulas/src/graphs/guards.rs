//! Derivatives that count only where a formula is chosen: [`Term`].

use super::graph::{Graph, Id, Node};
use std::collections::HashMap;

/// A derivative that a whole passes on to one of its parts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Term {
    /// The node that is ≥ 0 where the derivative counts, and negative where it does not; `None` if it counts everywhere.
    pub(crate) guard: Option<Id>,
    /// The derivative. Where it does not count, it may be infinite or not a number.
    pub(crate) slope: Id,
}

/// A guard that excludes another one, since one condition decides between them.
struct Contrary {
    guard: Id,
    condition: Id,
    /// Whether it is the guard of the formula that is chosen where the condition is ≥ 0.
    holds: bool,
    /// The guard that both have beside the condition.
    outer: Option<Id>,
}

impl Graph {
    /// Returns the derivative y where x ≥ 0, and z elsewhere.
    pub(crate) fn choose_slope(&mut self, x: Id, y: Id, z: Id) -> Id {
        if y == z { y } else { self.choose(x, y, z) }
    }

    /// Returns the derivative where it counts, and 0 elsewhere.
    pub(crate) fn counted(&mut self, Term { guard, slope }: Term) -> Id {
        let zero = self.number(0.0);
        guard.map_or(slope, |guard| self.choose_slope(guard, slope, zero))
    }

    /// Returns the guards of the two formulas between which a condition chooses, within a part with a guard.
    pub(crate) fn guards(&mut self, outer: Option<Id>, condition: Id) -> [Option<Id>; 2] {
        let [below, above] = [-1.0, 1.0].map(|number| self.number(number));
        let contrary = self.choose(condition, below, above);
        [condition, contrary]
            .map(|inner| Some(outer.map_or(inner, |outer| self.choose(outer, inner, below))))
    }

    /// Returns the derivatives that a part receives, with one term for each guard. Two terms that are passed on by the two
    /// formulas of one condition become one, which chooses between them.
    pub(crate) fn merged(&mut self, terms: &[Term]) -> Vec<Term> {
        let mut sums = self.sums(terms);
        let (mut open, mut next) = (HashMap::new(), 0);
        while let Some(&Term { guard, slope }) = sums.get(next) {
            let known = open.remove(&guard).map(|(_, slope)| slope);
            let slope = known.map_or(slope, |known| self.sum(&[known, slope]));
            let excluded = guard.into_iter().flat_map(|guard| self.contraries(guard));
            let found = excluded.into_iter().find_map(|contrary| {
                let (_, slope) = open.remove(&Some(contrary.guard))?;
                Some((contrary, slope))
            });
            if let Some((Contrary { condition, holds, outer, .. }, other)) = found {
                let [first, second] = if holds { [other, slope] } else { [slope, other] };
                let slope = self.choose_slope(condition, first, second);
                sums.push(Term { guard: outer, slope });
            } else {
                open.insert(guard, (next, slope));
            }
            next += 1;
        }
        let mut left: Vec<_> = open.into_iter().collect();
        left.sort_unstable_by_key(|(_, (place, _))| *place);
        left.into_iter().map(|(guard, (_, slope))| Term { guard, slope }).collect()
    }

    /// Returns the sum of terms with different guards, each of which is 0 where it does not count.
    pub(crate) fn total(&mut self, terms: &[Term]) -> Id {
        let counted: Vec<Id> = terms.iter().map(|term| self.counted(*term)).collect();
        self.sum(&counted)
    }

    /// Returns the sum of terms with different guards, which counts where one of them does.
    ///
    /// A term that does not count everywhere where the sum does is 0 elsewhere. What the part passes on is guarded again,
    /// because 0 times the slope of √x at 0 is not 0.
    pub(crate) fn joined(&mut self, terms: &[Term]) -> Term {
        if let [term] = *terms {
            return term;
        }
        let (slope, one) = (self.total(terms), self.number(1.0));
        let guards: Option<Vec<Id>> = terms.iter().map(|term| term.guard).collect();
        let either = |guard: Id, other: Id| self.choose(other, one, guard);
        Term { guard: guards.and_then(|guards| guards.into_iter().reduce(either)), slope }
    }

    /// Returns the sums of the terms with the same guard.
    fn sums(&mut self, terms: &[Term]) -> Vec<Term> {
        let (mut groups, mut places) = (Vec::new(), HashMap::new());
        for &Term { guard, slope } in terms {
            let place = *places.entry(guard).or_insert(groups.len());
            match groups.get_mut(place) {
                None => groups.push((guard, vec![slope])),
                Some((_, slopes)) => slopes.push(slope),
            }
        }
        groups.into_iter().map(|(guard, slopes)| Term { guard, slope: self.sum(&slopes) }).collect()
    }

    /// Returns the guards in the graph that exclude a guard.
    fn contraries(&self, guard: Id) -> Vec<Contrary> {
        let alone = self.contrary(guard).map(|(contrary, condition)| Contrary {
            guard: contrary,
            condition,
            holds: condition != guard,
            outer: None,
        });
        let within = match self.node(guard) {
            Node::Choose([outer, inner, below]) if self.as_number(below) == Some(-1.0) => {
                self.contrary(inner).and_then(|(contrary, condition)| {
                    let guard = self.find(Node::Choose([outer, contrary, below]))?;
                    let holds = condition != inner;
                    Some(Contrary { guard, condition, holds, outer: Some(outer) })
                })
            }
            _ => None,
        };
        alone.into_iter().chain(within).collect()
    }

    /// Returns the guard that is negative where a guard is ≥ 0, and ≥ 0 where that is negative, if it is in the graph,
    /// with the condition, which is one of the two.
    fn contrary(&self, guard: Id) -> Option<(Id, Id)> {
        let number = |value: f64| self.find(Node::Number(value.to_bits()));
        let (below, above) = (number(-1.0)?, number(1.0)?);
        match self.node(guard) {
            Node::Choose([condition, x, y]) if (x, y) == (below, above) => {
                Some((condition, condition))
            }
            _ => Some((self.find(Node::Choose([guard, below, above]))?, guard)),
        }
    }
}
