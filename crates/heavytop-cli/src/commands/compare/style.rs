//! Colours, dashes and marks: a hue and a mark for each family of schemes, darker for higher order.

use heavytop::methods::{ComposedScheme, PartitionedScheme, SchemeName};
use plotters::style::RGBColor;
use std::f64::consts::TAU;

/// The style in which a curve is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Style {
    pub colour: RGBColor,
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
            SchemeName::ImplicitMidpoint => (RGBColor(128, 196, 236), "", Circle),
            SchemeName::SphericalMidpoint => (RGBColor(128, 196, 236), DOTTED, Circle),
            SchemeName::Gauss(2) => (RGBColor(128, 196, 236), DASHED, Circle),
            SchemeName::Gauss(3) => (RGBColor(42, 149, 213), "", Circle),
            SchemeName::Gauss(4) => (RGBColor(42, 149, 213), DASHED, Circle),
            SchemeName::Gauss(5) => (RGBColor(0, 114, 178), "", Circle),
            SchemeName::Gauss(6) => (RGBColor(0, 67, 106), DASHED, Circle),
            SchemeName::Gauss(_) => (RGBColor(0, 35, 56), "", Circle),
            SchemeName::ExplicitMidpoint => (RGBColor(79, 199, 165), DASHED, Square),
            SchemeName::Rk4 => (RGBColor(0, 158, 115), "", Square),
            SchemeName::Partitioned(PartitionedScheme::SymplecticEuler) => {
                (RGBColor(224, 169, 200), DOTTED, Triangle)
            }
            SchemeName::Partitioned(PartitionedScheme::StormerVerlet) => {
                (RGBColor(204, 121, 167), DASHED, Triangle)
            }
            SchemeName::Partitioned(PartitionedScheme::Lobatto) => {
                (RGBColor(143, 63, 107), "", Triangle)
            }
            SchemeName::Composed(ComposedScheme::Strang) => (RGBColor(230, 159, 0), "", Diamond),
            SchemeName::Composed(ComposedScheme::Yoshida4) => {
                (RGBColor(230, 159, 0), DASHED, Diamond)
            }
            SchemeName::Composed(ComposedScheme::Suzuki4) => (RGBColor(213, 94, 0), "", Diamond),
            SchemeName::Composed(ComposedScheme::Yoshida6) => {
                (RGBColor(213, 94, 0), DASHED, Diamond)
            }
            SchemeName::Composed(ComposedScheme::KahanLi6) => (RGBColor(122, 54, 0), "", Diamond),
            SchemeName::Composed(ComposedScheme::KahanLi8) => {
                (RGBColor(122, 54, 0), DASHED, Diamond)
            }
        };
        Self { colour, dashes, mark }
    }
}

impl Mark {
    /// Returns the corners of the mark about a place.
    pub fn corners(self, (x, y): (i32, i32), radius: f64) -> Vec<(i32, i32)> {
        let corners = match self {
            Self::Circle => {
                (0..48).map(|n| (TAU * f64::from(n) / 48.0).sin_cos()).collect::<Vec<_>>()
            }
            Self::Square => vec![(-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)],
            Self::Triangle => vec![(0.0, -1.2), (1.1, 0.8), (-1.1, 0.8)],
            Self::Diamond => vec![(0.0, -1.3), (1.1, 0.0), (0.0, 1.3), (-1.1, 0.0)],
        };
        let place = |(a, b)| (x + (radius * a) as i32, y + (radius * b) as i32);
        corners.into_iter().map(place).collect()
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
