//! Panels of curves one above the other, with a common abscissa: [`Panels`].

use super::curve::{Curve, entry_width};
use crate::errors::Error;
use crate::pictures::charts::frame::WIDTH;
use crate::pictures::charts::scale::Scale;
use crate::pictures::charts::scaled_chart::{TEXT, below, beside, draw_axes};
use crate::pictures::charts::sheet::{EDGE, Sheet};
use crate::pictures::lettering::widest;
use plotters::prelude::*;

/// The height of a panel against time, in units of 0.01 mm, with the gap below it: the names of six curves have room beside it.
pub(crate) const PANEL: i32 = 2500;
/// The height of everything else: the caption and the abscissa.
const REST: i32 = 2600;
/// The gap below a panel.
const GAP: i32 = 300;
/// The distance of the legend from the panel, and the height of its rows.
const LEGEND: [i32; 2] = [200, 370];

/// A panel: its ordinate, and its curves in the order of the legend. The points are places, from 0 to 1 along both axes.
#[derive(Clone, Debug)]
pub(crate) struct Panel<'a> {
    pub ordinate: Scale,
    pub curves: Vec<Curve<'a>>,
}

/// Panels one above the other, with the names of the curves beside them.
pub(crate) struct Panels<'a> {
    sheet: Sheet,
    panels: Vec<Panel<'a>>,
    /// The room on the left and on the right of the panels.
    sides: [i32; 2],
}

impl<'a> Panels<'a> {
    /// Lays the panels out, each of this height, the first one above.
    ///
    /// # Errors
    /// If the caption cannot be drawn.
    pub fn new(caption: &[String], panels: Vec<Panel<'a>>, height: i32) -> Result<Self, Error> {
        let names = panels.iter().flat_map(|panel| &panel.curves).map(|curve| curve.name.as_str());
        let right = LEGEND[0] + entry_width(widest(names) * TEXT) + EDGE;
        let left = panels.iter().map(|panel| beside(&panel.ordinate, TEXT)).max().unwrap_or(0);
        let sheet = Sheet::new([WIDTH, REST + height * panels.len() as i32], caption, TEXT)?;
        Ok(Self { sheet, panels, sides: [left, right] })
    }

    /// Returns the length of the abscissa, as a multiple of the size of the text.
    pub fn length(&self) -> f64 {
        f64::from(WIDTH - EDGE - self.sides[0] - self.sides[1]) / TEXT
    }

    /// Draws the panels as SVG.
    ///
    /// # Errors
    /// If a name or a title cannot be drawn.
    pub fn draw(&self, abscissa: &Scale) -> Result<String, Error> {
        let ticks = abscissa.ticks.iter().map(|(along, _)| (*along, String::new())).collect();
        let unlabelled = Scale { ticks, ..Scale::default() };
        let (count, [left, right]) = (self.panels.len() as i32, self.sides);
        let height = self.sheet.body.dim_in_pixel().1 as i32;
        let step = (height - EDGE - below(TEXT) + GAP) / count.max(1);
        let breaks: Vec<i32> = (1..count).map(|row| row * step).collect();
        let areas = self.sheet.body.split_by_breakpoints([0; 0], breaks);
        let last = self.panels.len().saturating_sub(1);
        for (row, (panel, area)) in self.panels.iter().zip(&areas).enumerate() {
            let is_last = row == last;
            let mut chart = ChartBuilder::on(area)
                .margin_left(EDGE)
                .margin_right(right)
                .margin_bottom(if is_last { EDGE } else { 0 })
                .y_label_area_size(left)
                .x_label_area_size(if is_last { below(TEXT) } else { GAP })
                .build_cartesian_2d(
                    if is_last { abscissa.clone() } else { unlabelled.clone() },
                    panel.ordinate.clone(),
                )?;
            for (entry, curve) in panel.curves.iter().enumerate() {
                curve.draw(&mut chart, |place| place)?;
                let [apart, height] = LEGEND;
                let place = (WIDTH - right + apart, height * entry as i32 + height / 2);
                curve.draw_entry(area, place, TEXT)?;
            }
            draw_axes(&mut chart, TEXT, false)?;
        }
        Ok(self.sheet.drawing())
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::super::curve::STYLES;
    use super::*;
    use crate::pictures::charts::axis::Axis;
    use crate::pictures::lettering::checks::{collisions, texts};

    #[test]
    fn labels_are_apart_and_cut_at_no_scale() {
        for size in [1e-300, 1e-20, 2e-4, 1.0, 1e20, 1e300] {
            for count in 1..=5 {
                let points = [(0.0, 0.5), (1.0, 0.5)];
                let curve = |(name, (colour, dashes)): (usize, (RGBColor, &'static str))| Curve {
                    name: format!("curve {name}, absolute"),
                    colour,
                    dashes,
                    points: &points,
                };
                let panel = |row: usize| {
                    let axis = Axis::new(size * row as f64, size * (row as f64 + 1e-6), 4);
                    let ordinate = Scale::linear(&axis, "relative deviation (kg m²/s)", false);
                    Panel { ordinate, curves: STYLES.into_iter().enumerate().map(curve).collect() }
                };
                let caption = ["a system", "a method", "step 0.1 s"].map(String::from);
                let panels = Panels::new(&caption, (0..count).map(panel).collect(), PANEL).unwrap();
                let axis = Axis::along_line(0.0, size, 5, panels.length());
                let drawing = panels.draw(&Scale::linear(&axis, "t (s)", false)).unwrap();
                let canvas = [WIDTH, REST + PANEL * count as i32].map(f64::from).into();
                assert_eq!(collisions(&drawing, canvas), [""; 0], "{size} {count}");
                let texts = texts(&drawing);
                let entries = texts.iter().filter(|text| text.starts_with("curve"));
                assert_eq!(entries.count(), 6 * count);
                assert_eq!(drawing.matches("stroke-width=\"21\"").count(), 6 * count);
            }
        }
    }
}
