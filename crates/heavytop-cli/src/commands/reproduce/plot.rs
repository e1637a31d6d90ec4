//! Drawing of a figure as SVG whose text is still text.

use super::figures::Figure;
use crate::errors::Error;
use crate::pictures::charts::scaled_chart::{below, beside, draw_axes};
use crate::pictures::charts::sheet::{EDGE, Sheet};
use crate::pictures::lettering::width;
use crate::pictures::{Axis, Scale};
use plotters::chart::ChartBuilder;

/// The width of one column of a journal, in units of 0.01 mm.
const WIDTH: i32 = 8000;
const HEIGHT: i32 = 5800;

/// The size of the text, 7 pt.
const TEXT: f64 = 247.0;
/// The size of the caption, 5.5 pt.
const SMALL: f64 = 194.0;
/// The height of a row of the legend, and the gap between the legend and the field.
const ROW: i32 = 350;
const GAP: i32 = 150;
/// The least room on the right of the field.
const MARGIN: i32 = 400;

/// Draws the figure as an SVG document.
///
/// # Errors
/// If a text cannot be drawn.
pub(super) fn plot(figure: &Figure<'_>) -> Result<String, Error> {
    let points = || figure.curves.iter().flat_map(|curve| curve.points);
    let end = points().fold(0.0, |end: f64, point| end.max(point.0));
    let values = Axis::around(points().map(|point| point.1), 4);
    let ordinate = Scale::linear(&values, figure.label, false);
    let left = beside(&ordinate, TEXT);
    let field = f64::from(WIDTH - EDGE - left - MARGIN);
    let time = Axis::along_line(0.0, end, 4, field / TEXT);
    let abscissa = Scale::linear(&time, "<tspan font-style='italic'>t</tspan> (s)", false);
    // The label at the end of the axis is centred on it.
    let last = abscissa.ticks.last().map_or(0.0, |(_, label)| width(label) * TEXT / 2.0);
    let right = MARGIN.max(last as i32 + EDGE);

    let sheet = Sheet::new([WIDTH, HEIGHT], &figure.caption, SMALL)?;
    for (row, curve) in figure.curves.iter().enumerate() {
        let place = (EDGE + left, ROW * row as i32 + ROW / 2);
        curve.draw_entry(&sheet.body, place, TEXT)?;
    }
    let mut chart = ChartBuilder::on(&sheet.body)
        .margin_top(ROW * figure.curves.len() as i32 + GAP)
        .margin_left(EDGE)
        .margin_right(right)
        .margin_bottom(EDGE)
        .y_label_area_size(left)
        .x_label_area_size(below(TEXT))
        .build_cartesian_2d(abscissa, ordinate)?;
    draw_axes(&mut chart, TEXT, true)?;
    // The flattest curve is on top, where the others cannot hide it.
    let mut curves: Vec<_> = figure.curves.iter().collect();
    curves.sort_by(|one, other| other.span().total_cmp(&one.span()));
    for curve in curves {
        curve.draw(&mut chart, |(t, value)| (time.along(t), values.along(value)))?;
    }
    Ok(sheet.drawing())
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::super::figures::all;
    use super::super::record::Record;
    use super::*;
    use crate::configuration::Config;
    use crate::pictures::lettering::checks::{collisions, texts};
    use heavytop::methods::{Formulation, SchemeName};

    /// The records of quantities that oscillate about `value` with this amplitude, up to time `end`.
    fn records(value: f64, amplitude: f64, end: f64) -> Vec<Record> {
        let pairs = [
            (Formulation::Collective, SchemeName::ExplicitMidpoint),
            (Formulation::Direct, SchemeName::ExplicitMidpoint),
            (Formulation::Collective, SchemeName::ImplicitMidpoint),
            (Formulation::Direct, SchemeName::ImplicitMidpoint),
        ];
        let record = |(formulation, scheme)| {
            let mut config = Config::default();
            config.integrator.formulation = Some(formulation);
            config.integrator.scheme = Some(scheme);
            (config.integrator.step, config.integrator.end) = (Some(end / 8.0), Some(end));
            let mut record = Record::new(&config.experiment().unwrap());
            for step in 0..=8_u64 {
                let phase = [0.0, 1.0, 0.3, -1.0][step as usize % 4];
                record.add(step, end * step as f64 / 8.0, [value + amplitude * phase; 4]);
            }
            record
        };
        pairs.into_iter().map(record).collect()
    }

    #[test]
    fn labels_are_apart_and_cut_at_no_scale() {
        for size in [1e-20, 2e-4, 193.0, 1e20] {
            for (value, amplitude) in
                [(0.0, 1.0), (1.0, 1e-3), (-1.0, 1e-8), (1.0, 0.0), (0.0, 0.0)]
            {
                for end in [2e-5, 2.0] {
                    let records = records(size * value, size * amplitude, end);
                    // Of the longest and the shortest title and legend.
                    for figure in all(&records).into_iter().skip(3).take(2) {
                        let drawing = plot(&figure).unwrap();
                        let canvas = (WIDTH.into(), HEIGHT.into());
                        let texts = texts(&drawing);
                        assert_eq!(
                            collisions(&drawing, canvas),
                            [""; 0],
                            "{size} {value} {texts:?}"
                        );
                        let has = |part: &str| texts.iter().any(|text| text.contains(part));
                        assert!(has("I = (2, 2, 1) kg m²") && has(" s, 0 to "), "{texts:?}");
                    }
                }
            }
        }
        // The unit of K is written as everywhere else, and the label has the power of ten.
        let records = records(0.0, 3e-20, 2.0);
        let drawing = plot(&all(&records)[3]).unwrap();
        assert!(texts(&drawing).iter().any(|text| text == "K (10⁻²⁰ (kg m²/s)⁴)"));
    }

    /// The room is some two fifths of the size of the text: a line that touches the letters reads as underlining.
    #[test]
    fn the_legend_is_apart_from_the_field() {
        let records = records(1.0, 1e-3, 2.0);
        for figure in all(&records) {
            let drawing = plot(&figure).unwrap();
            let (_, edge) = drawing.rsplit_once("<rect ").unwrap();
            let top = edge.split("y=\"").nth(1).and_then(|top| top.split('"').next()).unwrap();
            let top: f64 = top.parse().unwrap();
            let boxes = svg_pictures::boxes(&drawing).unwrap();
            let entries = boxes.iter().filter(|place| place.text.contains("midpoint"));
            let room: Vec<f64> = entries.map(|entry| top - entry.bottom).collect();
            assert_eq!(room.len(), figure.curves.len());
            assert!(room.iter().all(|room| *room > 0.4 * TEXT), "{}: {room:?}", figure.name);
        }
    }

    #[test]
    fn curves_differ_without_colours() {
        let records = records(1.0, 1e-3, 2.0);
        for figure in all(&records) {
            let drawing = plot(&figure).unwrap();
            let mut styles: Vec<_> = figure.curves.iter().map(|curve| curve.dashes).collect();
            for style in &styles {
                // In the curve and in the legend.
                let style = if style.is_empty() { "none" } else { style };
                let attribute = format!("stroke-dasharray=\"{style}\"");
                assert_eq!(drawing.matches(&attribute).count(), 2, "{}: {style}", figure.name);
            }
            let count = styles.len();
            styles.sort_unstable();
            styles.dedup();
            assert_eq!(styles.len(), count, "{}", figure.name);
        }
    }
}
