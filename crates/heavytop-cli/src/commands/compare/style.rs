//! Colours and dashes: a hue for each family of schemes, darker for higher order.

use crate::vocabulary::{Pair, Raise, Scheme};

/// The style in which a curve is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Style {
    /// The colour, as CSS writes it.
    pub colour: &'static str,
    /// The dashes and gaps, in units of 0.01 mm; empty for a whole line.
    pub dashes: &'static str,
}

const DASHED: &str = "110 60";
const DOTTED: &str = "40 40";

impl Style {
    /// Returns the style of a scheme.
    pub fn of(scheme: Scheme) -> Self {
        let (colour, dashes) = match scheme {
            Scheme::ImplicitMidpoint => ("#7cc4ee", ""),
            Scheme::Gauss(2) => ("#4aa3df", ""),
            Scheme::Gauss(3) => ("#2f83c9", ""),
            Scheme::Gauss(4) => ("#2466ad", ""),
            Scheme::Gauss(5) => ("#1d4b8f", ""),
            Scheme::Gauss(6) => ("#17346f", ""),
            Scheme::Gauss(_) => ("#0c1a45", ""),
            Scheme::ExplicitMidpoint => ("#6cc070", ""),
            Scheme::Rk4 => ("#14802f", ""),
            Scheme::Partitioned(Pair::SymplecticEuler) => ("#c9a3dc", DOTTED),
            Scheme::Partitioned(Pair::StormerVerlet) => ("#9b59b6", DOTTED),
            Scheme::Partitioned(Pair::Lobatto) => ("#5e2a7e", DOTTED),
            Scheme::Composed(Raise::Strang) => ("#f2b134", ""),
            Scheme::Composed(Raise::Yoshida4) => ("#ef7d1a", DASHED),
            Scheme::Composed(Raise::Suzuki4) => ("#ef7d1a", ""),
            Scheme::Composed(Raise::Yoshida6) => ("#d62728", DASHED),
            Scheme::Composed(Raise::KahanLi6) => ("#d62728", ""),
            Scheme::Composed(Raise::KahanLi8) => ("#6e0f12", ""),
        };
        Self { colour, dashes }
    }
}
