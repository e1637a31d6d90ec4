//! The heat map of a grid with two axes, as SVG.

use super::colours::{NONE, scaled};
use super::map_colours::MapColours;
use super::words::{blank, words};
use crate::commands::sweep::sweep_plan::Plan;
use crate::configuration::{Column, Spread, SweepAxis};
use crate::errors::Error;
use crate::pictures::charts::frame::{HEIGHT, WIDTH};
use crate::pictures::charts::scaled_chart::TEXT;
use crate::pictures::charts::sheet::{Area, EDGE, text};
use crate::pictures::lettering::width;
use crate::pictures::{Axis, Frame, Scale};
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};
use svg_pictures::SvgElement;

/// Draws the values over the plane of the two axes, in a map of the given size.
///
/// `failed` is the number of members that could not be followed.
///
/// # Errors
/// If the map cannot be drawn.
pub(super) fn heat_map(
    plan: &Plan,
    [columns, rows]: [u32; 2],
    column: &Column,
    values: &[Option<f64>],
    failed: u64,
) -> Result<String, Error> {
    let (column, scaled) = &scaled(column, values);
    let missing = scaled.iter().filter(|value| value.is_none()).count();
    let colours = MapColours::of(column, values, scaled);
    let colour = |value: f64| colours.as_ref().map_or([NONE; 3], |colours| colours.at(value));
    // The first axis is the abscissa, and the top row has the largest value of the second.
    let (width, height) = (columns as usize, rows as usize);
    let from_top = (0..height).rev().flat_map(|y| (0..width).map(move |x| x * height + y));
    let shades =
        from_top.map(|index| scaled.get(index).copied().flatten().map_or([NONE; 3], colour));

    let labels = plan.family.labels();
    let ([first, second], [along, upward]) = (plan.axes.as_slice(), labels.as_slice()) else {
        return Err(Error::Figure("a heat map needs two axes".into()));
    };
    let (low, high) = ends(second);
    let ordinate = Axis::new(low, high, 5);
    let ordinate = Scale::linear(&ordinate, upward, is_reversed(second));
    let mut caption = words(plan);
    caption.extend(colours.iter().flat_map(|colours| colours.outside(column)));
    let bar = colours.as_ref().map(|colours| colours.scale(column));
    let frame = Frame::new(HEIGHT, &caption, ordinate, bar)?;
    let (low, high) = ends(first);
    let abscissa = Axis::along_line(low, high, 5, frame.length());
    let mut chart = frame.chart(Scale::linear(&abscissa, along, is_reversed(first)))?;
    let corners = [(0.0, 1.0), (1.0, 0.0)];
    chart.draw_series([SvgElement::cells(corners, [columns, rows], shades)?])?;
    if colours.is_none() {
        blank(&chart.plotting_area().strip_coord_spec(), column, (failed, plan))?;
    } else if missing > 0 {
        key(&frame.sheet.body, missing)?;
    }
    frame
        .complete(chart, |place| colours.as_ref().map_or([NONE; 3], |colours| colours.along(place)))
}

/// Returns the edges of an axis of the map: values are in the middle of their pixels.
fn ends(axis: &SweepAxis) -> (f64, f64) {
    let (from, to, count) = match axis.spread {
        Spread::Grid { from, to, count } => (from, to, count),
        Spread::Uniform { from, to } => (from, to, 2),
        Spread::Normal { mean, deviation } => (mean - deviation, mean + deviation, 2),
    };
    let half = (to - from).abs() / f64::from(2 * count.max(2) - 2);
    (from.min(to) - half, from.max(to) + half)
}

pub(super) fn is_reversed(axis: &SweepAxis) -> bool {
    matches!(axis.spread, Spread::Grid { from, to, .. } if from > to)
}

/// Explains the colour of what has no value, below the bar of colours.
fn key(area: &Area, missing: usize) -> Result<(), Error> {
    let label = format!("no value: {missing}");
    let (right, bottom) = (WIDTH - EDGE, area.dim_in_pixel().1 as i32 - EDGE);
    area.draw_text(&label, &text(TEXT, HPos::Right, VPos::Bottom), (right, bottom))?;
    let left = right - (width(&label) * TEXT) as i32 - 420;
    let corners = [(left, bottom - 310), (left + 300, bottom - 50)];
    area.draw(&Rectangle::new(corners, RGBColor(NONE, NONE, NONE).filled()))?;
    Ok(())
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::pictures::lettering::checks::{collisions, texts as texts_of};

    /// The map of an observable of 3 × 3 tops whose sizes are all of this size, and its texts.
    fn map(size: f64, observable: &str, values: &[Option<f64>; 9]) -> (String, Vec<String>) {
        let text = format!(
            "integrator = {{ step = 0.1, end = 100 }}\n\
             body = {{ inertia = [{0:e}, {1:e}, {size:e}], mass = {size:e}, gravity = 1.0 }}\n\
             sweep.observables = ['{observable}']\n\
             [[sweep.axes]]\nparameter = 'initial.angular_momentum[0]'\n\
             from = -{0:e}\nto = {0:e}\ncount = 3\n\
             [[sweep.axes]]\nparameter = 'body.inertia[1]'\nfrom = {0:e}\nto = {1:e}\ncount = 3",
            2.0 * size,
            2.5 * size,
        );
        let plan = Plan::new(&toml::from_str(&text).unwrap()).unwrap();
        let column = plan.columns.first().unwrap();
        let failed = values.iter().filter(|value| value.is_none()).count() as u64;
        let drawing = heat_map(&plan, [3, 3], column, values, failed).unwrap();
        let texts = texts_of(&drawing);
        (drawing, texts)
    }

    fn with(values: [f64; 9]) -> [Option<f64>; 9] {
        values.map(Some)
    }

    const VALUES: [f64; 9] = [0.1, 0.2, 0.9, 0.4, 0.5, -0.7, 0.3, 0.8, 0.6];

    #[test]
    fn labels_are_apart_and_cut_at_no_scale() {
        for size in [1e-20, 2e-4, 1.0, 1e20] {
            for observable in ["final-state", "megno", "invariant-drift"] {
                for values in [
                    VALUES.map(|x| x * size),
                    [size; 9],
                    [size, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0],
                ] {
                    let (drawing, texts) = map(size, observable, &with(values));
                    let found = collisions(&drawing, (WIDTH.into(), HEIGHT.into()));
                    assert_eq!(found, [""; 0], "{size} {observable} {texts:?}");
                    let has = |part: &str| texts.iter().any(|text| text.contains(part));
                    assert!(has("9 tops; ") && has("step 0.1 s") && has("0 to 100 s"), "{texts:?}");
                    assert!(has("Γ(0) = (0.5, 0, 0.866025)"), "{texts:?}");
                }
            }
        }
        let (_, texts) = map(2e-4, "final-state", &with(VALUES.map(|x| 1e-3 * x)));
        for text in ["Π₁(0) (10⁻⁴ kg m²/s)", "I₂ (10⁻⁴ kg m²)", "Π₁ at the end (10⁻⁴ kg m²/s)"]
        {
            assert!(texts.iter().any(|found| found == text), "{text}: {texts:?}");
        }
    }

    #[test]
    fn the_map_of_a_system_tells_what_all_runs_share() {
        let text = "[system]\nalgebra = 'se(3)'\n\
            hamiltonian = 'Pi1^2/I1 + Pi2^2/I2 + Pi3^2/I3 + k*c·Gamma'\n\
            parameters = { I = [1, 2, 3], c = [0, 0, 1], k = 0.25 }\n\
            initial = { Pi = [1, 0.5, 0.3], Gamma = [0.6, 0, 0.8] }\n\
            [sweep]\nobservables = ['invariant-drift']\naxes = [\
            { parameter = 'system.parameters.I[1]', from = 1, to = 3, count = 3 }, \
            { parameter = 'system.initial.Gamma[0]', from = 0, to = 1, count = 3 }]";
        let plan = Plan::new(&toml::from_str(text).unwrap()).unwrap();
        let names: Vec<&str> = plan.columns.iter().map(|column| &*column.name).collect();
        assert_eq!(names, ["drift_h", "drift_c1", "drift_c2"]);
        let drawing = heat_map(&plan, [3, 3], &plan.columns[1], &with(VALUES), 0).unwrap();
        assert_eq!(collisions(&drawing, (WIDTH.into(), HEIGHT.into())), [""; 0]);
        let written = texts_of(&drawing);
        let caption = written.join("; ");
        for part in [
            "9 runs",
            "reduced, gauss-8, step 0.1 s",
            "c₁ = Π·Γ",
            "c₂ = |Γ|²",
            "I = (1, I₂, 3)",
            "c = (0, 0, 1)",
            "k = 0.25",
            "Π(0) = (1, 0.5, 0.3)",
            "Γ(0) = (Γ₁, 0, 0.8)",
        ] {
            assert!(caption.contains(part), "{part}: {caption}");
        }
        for title in ["I₂", "Γ₁(0)", "deviation of c₁"] {
            assert!(written.iter().any(|text| text == title), "{title}: {written:?}");
        }
        let blank = heat_map(&plan, [3, 3], &plan.columns[0], &[None; 9], 9).unwrap();
        let texts = texts_of(&blank);
        assert!(texts.iter().any(|text| text == "9 of 9 runs could not be followed"), "{texts:?}");
    }

    #[test]
    fn regular_motion_is_marked_on_the_bar_of_megno() {
        // All tops are chaotic, all are regular, or the bar is narrow.
        for values in [VALUES.map(|x| 100.0 + x), VALUES, [2.0; 9]] {
            let (_, texts) = map(1.0, "megno", &with(values));
            assert!(texts.iter().any(|text| text == "2 (regular)"), "{texts:?}");
        }
        // A deviation far below that of large tops has colours of its own, and one of zero is no deviation.
        let (_, texts) = map(1.0, "invariant-drift", &with(VALUES.map(|x| 1e-18 * x.abs())));
        assert!(texts.iter().any(|text| text.starts_with("2×10⁻¹⁹")), "{texts:?}");
        let (_, texts) = map(1.0, "invariant-drift", &with([0.0; 9]));
        assert!(texts.iter().any(|text| text == "0.0"), "{texts:?}");
        // Control: other observables have no such value.
        let (_, texts) = map(1.0, "lyapunov", &with(VALUES));
        assert!(!texts.iter().any(|text| text.contains("regular")));
    }

    #[test]
    fn a_map_without_values_says_why() {
        let (drawing, texts) = map(1.0, "megno", &[None; 9]);
        assert!(texts.iter().any(|text| text == "9 of 9 tops could not be followed"), "{texts:?}");
        assert_eq!(collisions(&drawing, (WIDTH.into(), HEIGHT.into())), [""; 0]);
        // A value that is not a number is none.
        let (_, of_nan) = map(1.0, "megno", &[Some(f64::NAN); 9]);
        assert!(of_nan.iter().any(|text| text == "No top has a value of"), "{of_nan:?}");
        // Controls: one value is enough for a bar of colours; the others are counted beside the colour of no value.
        let (_, texts) =
            map(1.0, "megno", &[Some(3.0), None, None, None, None, None, None, None, None]);
        assert!(texts.iter().any(|text| text == "no value: 8"));
        assert!(!texts.iter().any(|text| text.contains("could not be followed")));
        // Nothing failed, and yet there is no value: nothing is said of failures.
        let text = "sweep.observables = ['rotation-number']\nsweep.axes = [\
            { parameter = 'body.mass', from = 1, to = 2, count = 3 }, \
            { parameter = 'body.length', from = 1, to = 2, count = 3 }]";
        let plan = Plan::new(&toml::from_str(text).unwrap()).unwrap();
        let found = texts_of(&heat_map(&plan, [3, 3], &plan.columns[0], &[None; 9], 0).unwrap());
        assert!(found.iter().any(|text| text == "No top has a value of"), "{found:?}");
        assert!(!found.iter().any(|text| text.contains("could not be followed")), "{found:?}");
        assert!(!map(1.0, "megno", &with(VALUES)).1.iter().any(|text| text.contains("no value")));
    }
}
