//! Panels of curves one above the other, with a common abscissa: [`Panels`].

use super::curve::Curve;
use crate::pictures::frame::{EDGE, Frame, TEXT};
use crate::pictures::lettering::widest;
use crate::pictures::scale::Scale;

/// The height of a panel, in units of 0.01 mm, with the gap below it: the names of six curves have room beside it.
const PANEL: f64 = 2500.0;
/// The height of everything else: the caption and the abscissa.
const REST: f64 = 2600.0;
/// The width of curves.
const CURVE: f64 = 21.0;
/// The distance of the legend from the panel, the length of its lines, the gap beside them, and the height of its rows.
const LEGEND: [f64; 4] = [200.0, 600.0, 120.0, 370.0];

/// A panel: its ordinate, and its curves in the order of the legend. The points are places, from 0 to 1 along both axes.
#[derive(Clone, Debug)]
pub(crate) struct Panel<'a> {
    pub ordinate: Scale,
    pub curves: Vec<Curve<'a>>,
}

/// Panels one above the other, with the names of the curves beside them.
#[derive(Clone, Debug)]
pub(crate) struct Panels<'a> {
    panels: Vec<Panel<'a>>,
    frames: Vec<Frame>,
    height: f64,
}

impl<'a> Panels<'a> {
    /// Lays the panels out, the first one above.
    pub fn new(caption: &[String], panels: Vec<Panel<'a>>) -> Self {
        let height = REST + PANEL * panels.len() as f64;
        let names = panels.iter().flat_map(|panel| &panel.curves).map(|curve| curve.name.as_str());
        let [apart, line, gap, _] = LEGEND;
        let beside = apart + line + gap + widest(names) * TEXT + EDGE;
        let ordinates = panels.iter().map(|panel| panel.ordinate.clone()).collect();
        let frames = Frame::stacked(height, caption, ordinates, beside);
        Self { panels, frames, height }
    }

    /// Returns the length of the abscissa, as a multiple of the size of the text.
    pub fn length(&self) -> f64 {
        self.frames.first().map_or(0.0, Frame::length)
    }

    /// Draws the panels as SVG.
    pub fn draw(&self, abscissa: &Scale) -> String {
        let mut svg = Frame::begin_of_height(self.height);
        let ticks = abscissa.ticks.iter().map(|(along, _)| (*along, String::new())).collect();
        let unlabelled = Scale { ticks, title: String::new(), line: None };
        let last = self.frames.len().saturating_sub(1);
        for (row, (panel, frame)) in self.panels.iter().zip(&self.frames).enumerate() {
            let Frame { left, right, top, bottom, .. } = *frame;
            for curve in &panel.curves {
                curve.draw(&mut svg, CURVE, |(x, y)| {
                    (left + (right - left) * x, bottom - (bottom - top) * y)
                });
            }
            let [apart, line, gap, height] = LEGEND;
            for (entry, curve) in panel.curves.iter().enumerate() {
                let y = top + height * (entry as f64 + 0.5);
                let (from, to) = (right + apart, right + apart + line);
                curve.draw_entry(&mut svg, 2.0 * CURVE, (from, to, gap), y);
            }
            frame.draw(&mut svg, if row == last { abscissa } else { &unlabelled });
        }
        svg + "</svg>"
    }
}

#[cfg(test)]
mod tests {
    use super::super::curve::STYLES;
    use super::*;
    use crate::pictures::axis::Axis;
    use crate::pictures::frame::WIDTH;
    use crate::pictures::lettering::checks::{collisions, texts};

    #[test]
    fn labels_are_apart_and_cut_at_no_scale() {
        for size in [1e-20, 2e-4, 1.0, 1e20] {
            for count in 1..=5 {
                let points = [(0.0, 0.5), (1.0, 0.5)];
                let curve =
                    |(name, (colour, dashes)): (usize, (&'static str, &'static str))| Curve {
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
                let panels = Panels::new(&caption, (0..count).map(panel).collect());
                let axis = Axis::along_line(0.0, size, 5, panels.length());
                let drawing = panels.draw(&Scale::linear(&axis, "t (s)", false));
                let canvas = (WIDTH, REST + PANEL * count as f64);
                assert_eq!(collisions(&drawing, canvas), [""; 0], "{size} {count}");
                let texts = texts(&drawing);
                let entries = texts.iter().filter(|text| text.starts_with("curve"));
                assert_eq!(entries.count(), 6 * count);
                assert_eq!(drawing.matches("<polyline").count(), 6 * count);
            }
        }
    }
}
