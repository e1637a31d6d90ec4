//! Charts of the columns of a run for a terminal.

use super::dots::{Dots, lines};
use crate::commands::plot::histories::panel_plan::PanelPlan;
use crate::commands::plot::histories::phase_portrait::read;
use crate::commands::plot::histories::plan_curves::{Curves, read_against_time};
use crate::commands::plot::quantities::run_column::RunColumn;
use crate::commands::plot::run_arrays::RunArrays;
use crate::errors::Error;
use crate::pictures::numerals::significant;
use plotters::prelude::*;

/// The numbers of characters in a row and in a column of a chart.
const SIZE: [usize; 2] = [76, 8];

/// The number of digits of the ends of an axis.
const DIGITS: usize = 6;

/// Draws a chart of each column, against time or another column, with its range above it.
///
/// # Errors
/// If the samples cannot be read.
pub(in crate::commands::plot) fn terminal_charts(
    run: &RunArrays,
    columns: Vec<RunColumn>,
    abscissa: Option<&RunColumn>,
) -> Result<String, Error> {
    let along = abscissa.map_or_else(|| "t (s)".into(), |one| one.with_unit(&one.symbol));
    let mut charts = String::new();
    for column in columns {
        let plan = PanelPlan { columns: vec![column] };
        let curves = match abscissa {
            None => read_against_time(run, &plan)?,
            Some(abscissa) => read(run, &plan, abscissa, 1)?,
        };
        let title = plan.columns.iter().map(|one| one.with_unit(&one.symbol)).collect::<String>();
        charts += &chart(&title, &along, &curves)?;
    }
    Ok(charts)
}

/// Draws curves, with the ranges of both axes in a line above.
fn chart(title: &str, along: &str, curves: &Curves) -> Result<String, Error> {
    let points = || curves.iter().flat_map(|(_, points)| points);
    let [x, y] = [range(points().map(|point| point.0)), range(points().map(|point| point.1))];
    let words = |[least, most]: [f64; 2]| match least <= most {
        true => format!("from {} to {}", significant(least, DIGITS), significant(most, DIGITS)),
        false => "without values".into(),
    };
    let [width, height] = SIZE;
    let mut characters = vec![0; width * height];
    for (_, points) in curves {
        let place = |(a, b): &(f64, f64)| (along_range(*a, x), along_range(*b, y));
        let pieces = points.split(|point| !(point.0.is_finite() && point.1.is_finite()));
        let pieces = pieces.map(|piece| piece.iter().map(place).collect::<Vec<_>>());
        draw(&mut characters, pieces.filter(|piece| !piece.is_empty()))?;
    }
    let heading = format!("{title} {}, against {along} {}", words(y), words(x));
    Ok(format!("{heading}\n{}", lines(&characters, width)))
}

/// Draws lines whose coordinates are from 0 to 1.
fn draw(
    characters: &mut [u32],
    pieces: impl Iterator<Item = Vec<(f64, f64)>>,
) -> Result<(), Error> {
    let failed = |error: &dyn std::fmt::Display| Error::Figure(error.to_string());
    let area = Dots::new(characters, SIZE[0]).into_drawing_area();
    let chart = ChartBuilder::on(&area).build_cartesian_2d(0.0..1.0, 0.0..1.0);
    let mut chart = chart.map_err(|error| failed(&error))?;
    // A line has two ends, also that of a lone point.
    let series = pieces.map(|mut piece| {
        piece.extend(piece.first().copied());
        piece.rotate_right(1);
        PathElement::new(piece, BLACK)
    });
    chart.draw_series(series).map_err(|error| failed(&error))?;
    Ok(())
}

/// Returns the least and the largest number.
fn range(numbers: impl Iterator<Item = f64>) -> [f64; 2] {
    let finite = numbers.filter(|number| number.is_finite());
    finite.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(x), b.max(x)])
}

/// Returns the place of a number in a range, from 0 to 1; the middle of a range without length.
fn along_range(number: f64, [least, most]: [f64; 2]) -> f64 {
    let length = most / 2.0 - least / 2.0;
    if length > 0.0 { (number / 2.0 - least / 2.0) / length } else { 0.5 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_lone_point_has_a_dot_and_a_column_without_values_none() {
        let dots = |value: f64| {
            let curves = vec![("x".into(), vec![(0.0, value)])];
            let text = chart("x", "t (s)", &curves).unwrap_or_default();
            (
                text.contains("without values"),
                text.contains(|c| ('\u{2801}'..='\u{28ff}').contains(&c)),
            )
        };
        assert_eq!((dots(1.0), dots(f64::NAN)), ((false, true), (true, false)));
    }
}
