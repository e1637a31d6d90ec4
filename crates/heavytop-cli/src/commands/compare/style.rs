//! Colours, dashes and marks: a hue and a mark for each family of schemes, darker for higher order.

use heavytop::methods::{ComposedScheme, PartitionedScheme, SchemeName};

/// The style in which a curve is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Style {
    /// The colour, as CSS writes it.
    pub colour: &'static str,
    /// The dashes and gaps, in units of 0.01 mm; empty for a whole line.
    pub dashes: &'static str,
    /// The mark of each run.
    pub mark: Mark,
}

/// The mark of a run, one for each family.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Mark {
    Circle,
    Square,
    Triangle,
    Diamond,
}

const DASHED: &str = "110 60";
const DOTTED: &str = "40 40";

impl Style {
    /// Returns the style of a scheme.
    ///
    /// The hues are the blue, bluish green, reddish purple, orange and vermillion of Okabe and Ito, which readers with
    /// all kinds of colour vision tell apart. Source: M. Okabe & K. Ito, *Color Universal Design* (2008).
    pub fn of(scheme: SchemeName) -> Self {
        use Mark::{Circle, Diamond, Square, Triangle};
        let (colour, dashes, mark) = match scheme {
            SchemeName::ImplicitMidpoint => ("#80c4ec", "", Circle),
            SchemeName::SphericalMidpoint => ("#80c4ec", DOTTED, Circle),
            SchemeName::Gauss(2) => ("#80c4ec", DASHED, Circle),
            SchemeName::Gauss(3) => ("#2a95d5", "", Circle),
            SchemeName::Gauss(4) => ("#2a95d5", DASHED, Circle),
            SchemeName::Gauss(5) => ("#0072b2", "", Circle),
            SchemeName::Gauss(6) => ("#00436a", DASHED, Circle),
            SchemeName::Gauss(_) => ("#002338", "", Circle),
            SchemeName::ExplicitMidpoint => ("#4fc7a5", DASHED, Square),
            SchemeName::Rk4 => ("#009e73", "", Square),
            SchemeName::Partitioned(PartitionedScheme::SymplecticEuler) => {
                ("#e0a9c8", DOTTED, Triangle)
            }
            SchemeName::Partitioned(PartitionedScheme::StormerVerlet) => {
                ("#cc79a7", DASHED, Triangle)
            }
            SchemeName::Partitioned(PartitionedScheme::Lobatto) => ("#8f3f6b", "", Triangle),
            SchemeName::Composed(ComposedScheme::Strang) => ("#e69f00", "", Diamond),
            SchemeName::Composed(ComposedScheme::Yoshida4) => ("#e69f00", DASHED, Diamond),
            SchemeName::Composed(ComposedScheme::Suzuki4) => ("#d55e00", "", Diamond),
            SchemeName::Composed(ComposedScheme::Yoshida6) => ("#d55e00", DASHED, Diamond),
            SchemeName::Composed(ComposedScheme::KahanLi6) => ("#7a3600", "", Diamond),
            SchemeName::Composed(ComposedScheme::KahanLi8) => ("#7a3600", DASHED, Diamond),
        };
        Self { colour, dashes, mark }
    }
}

impl Mark {
    /// Returns the outline of the mark about a place, as the data of an SVG path.
    pub fn path(self, x: f64, y: f64, radius: f64) -> String {
        let polygon = |corners: &[(f64, f64)]| {
            let corners =
                corners.iter().map(|(a, b)| format!("{:.0},{:.0}", x + radius * a, y + radius * b));
            format!("M{}Z", corners.collect::<Vec<_>>().join("L"))
        };
        match self {
            Self::Circle => format!(
                "M{:.0},{y:.0}a{radius},{radius} 0 1 0 {d},0a{radius},{radius} 0 1 0 -{d},0Z",
                x - radius,
                d = 2.0 * radius
            ),
            Self::Square => polygon(&[(-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)]),
            Self::Triangle => polygon(&[(0.0, -1.2), (1.1, 0.8), (-1.1, 0.8)]),
            Self::Diamond => polygon(&[(0.0, -1.3), (1.1, 0.0), (0.0, 1.3), (-1.1, 0.0)]),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_two_schemes_look_alike() {
        for (n, (name, scheme)) in SchemeName::NAMES.iter().enumerate() {
            for (other, second) in &SchemeName::NAMES[..n] {
                let (one, two) = (Style::of(*scheme), Style::of(*second));
                assert_ne!(one, two, "{name} and {other}");
            }
        }
        // Control: colours alone would not do.
        let mut colours: Vec<_> = SchemeName::NAMES
            .iter()
            .map(|(_, scheme)| format!("{:?}", Style::of(*scheme).colour))
            .collect();
        colours.sort();
        colours.dedup();
        assert!(colours.len() < SchemeName::NAMES.len());
    }
}
