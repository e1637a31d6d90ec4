//! Which picture a sweep has of each column: [`SweepPicture`].

use super::heat_map::heat_map;
use super::member_curve::member_curve;
use crate::commands::sweep::sweep_plan::Plan;
use crate::configuration::{Column, Spread};
use crate::errors::Error;

/// The largest number of values of a map; more would have more pixels than a screen, and take gigabytes.
const MOST_VALUES: u64 = 1 << 24;

/// The largest number of points of a curve; more would hide each other, and make pictures of many megabytes.
const MOST_POINTS: u64 = 1 << 16;

/// The bytes of the two files of a picture without values; lettering takes most of them.
const BYTES_OF_FRAMES: u64 = 180_000;

/// The picture that a sweep has of each column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::commands::sweep) enum SweepPicture {
    /// A heat map of a grid with two axes, with so many columns and rows.
    Map([u32; 2]),
    /// A curve over a single axis.
    Curve,
}

impl SweepPicture {
    /// Returns the picture of a sweep; `None` with more axes, random ones beside others, or more members than a picture
    /// can show.
    pub fn of(plan: &Plan) -> Option<Self> {
        match plan.axes.as_slice() {
            [_] if plan.members <= MOST_POINTS => Some(Self::Curve),
            [first, second] => match (first.spread, second.spread) {
                (Spread::Grid { count: columns, .. }, Spread::Grid { count: rows, .. })
                    if plan.members <= MOST_VALUES =>
                {
                    Some(Self::Map([columns, rows]))
                }
                _ => None,
            },
            _ => None,
        }
    }

    /// Returns the word for several.
    pub fn nouns(self) -> &'static str {
        match self {
            Self::Map(_) => "heat maps",
            Self::Curve => "curves",
        }
    }

    /// Returns the bytes of the two files of the picture of a column, about.
    pub fn bytes(self, members: u64) -> u64 {
        let each = match self {
            Self::Map(_) => 2,
            // The place of a point in the SVG.
            Self::Curve => 12,
        };
        BYTES_OF_FRAMES + each * members
    }

    /// Draws the values of a column. `failed` is the number of members that could not be followed.
    ///
    /// # Errors
    /// If the picture cannot be drawn.
    pub fn draw(
        self,
        plan: &Plan,
        column: &Column,
        values: &[Option<f64>],
        failed: u64,
    ) -> Result<String, Error> {
        match self {
            Self::Map(size) => heat_map(plan, size, column, values, failed),
            Self::Curve => member_curve(plan, column, values, failed),
        }
    }
}
