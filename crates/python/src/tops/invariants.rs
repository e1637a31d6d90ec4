//! The invariants of a top along a run.

use crate::arrays::state_of;
use crate::runs::recording::Quantities;
use heavytop::{HeavyTop, Invariant};

/// The invariants of a top.
pub(super) struct Invariants<'a> {
    pub(super) top: &'a HeavyTop,
    pub(super) list: &'a [Invariant],
}

impl Quantities for Invariants<'_> {
    fn count(&self) -> usize {
        self.list.len()
    }

    fn append(&self, mu: &[f64], values: &mut Vec<f64>) {
        let mu = state_of(mu);
        values.extend(self.list.iter().map(|invariant| invariant.value(self.top, &mu)));
    }

    fn without_value(&self, mu: &[f64]) -> String {
        let mu = state_of(mu);
        let is_infinite = |i: &&Invariant| !i.value(self.top, &mu).is_finite();
        let symbol = self.list.iter().find(is_infinite).map_or("h", |i| i.symbol());
        format!("the invariant {symbol} is not finite")
    }
}
