//! The picture of a chain of spins against time.

use super::time_axis::TimeAxis;
use crate::commands::plot::run_arrays::RunArrays;
use crate::errors::Error;
use crate::pictures::charts::frame::HEIGHT;
use crate::pictures::colour_scale::colour;
use crate::pictures::raster::{cells, range};
use crate::pictures::symbols::symbol;
use crate::pictures::{Axis, Frame, Scale};

/// The largest number of columns and of rows of pixels.
const MOST: usize = 2048;

/// The part of the largest range of a component that that of the third one must have to be drawn.
const ENOUGH: f64 = 0.5;

/// Draws a component of the spins against time: the third, unless another one varies more. A long run and a long chain are
/// thinned out.
///
/// # Errors
/// If the samples cannot be read.
pub(in crate::commands::plot) fn chain_picture(run: &RunArrays) -> Result<String, Error> {
    let (name, shape) = run.subject.state();
    let sites = shape.first().copied().unwrap_or(0);
    let strides = [run.times.len(), sites].map(|count| count.div_ceil(MOST).max(1));
    let component = component(run)?;
    let mut columns: Vec<Vec<f64>> = Vec::new();
    run.each(&run.subject.parts(), |number, spins| {
        if number.is_multiple_of(strides[0]) {
            let spins = spins.as_chunks::<3>().0.iter().step_by(strides[1]);
            let column: Vec<f64> = spins.map(|spin| spin[component]).collect();
            columns.push(column);
        }
        Ok(true)
    })?;
    let rows = columns.first().map_or(0, Vec::len);
    let range = range(columns.iter().flatten().copied());
    let from_top =
        (0..rows).rev().flat_map(|row| columns.iter().map(move |column| column.get(row).copied()));
    let spins: Vec<Option<f64>> = from_top.collect();
    let ordinate =
        Scale::linear(&Axis::new(0.5, sites as f64 + 0.5, 5), "number of the spin", false);
    let scale = Scale::linear(
        &Axis::new(range[0], range[1], 4),
        &format!("{}{}", symbol(&name), ["₁", "₂", "₃"][component]),
        false,
    );
    let caption = run.caption(format!("{sites} spins"));
    let frame = Frame::new(HEIGHT, &caption, ordinate, Some(scale))?;
    let mut chart = frame.chart(TimeAxis::new(&run.times).scale(frame.length()))?;
    let size = [columns.len() as u32, rows as u32];
    chart.draw_series([cells([(0.0, 1.0), (1.0, 0.0)], size, &spins, range)?])?;
    frame.complete(chart, colour)
}

/// Returns the place of the component that is drawn.
fn component(run: &RunArrays) -> Result<usize, Error> {
    let mut ends = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
    run.each(&run.subject.parts(), |_, spins| {
        for spin in spins.as_chunks::<3>().0 {
            for ([least, most], x) in ends.iter_mut().zip(spin) {
                (*least, *most) = (least.min(*x), most.max(*x));
            }
        }
        Ok(true)
    })?;
    let ranges = ends.map(|[least, most]| most - least);
    let widest = if ranges[0] >= ranges[1] { 0 } else { 1 };
    Ok(if ranges[2] < ENOUGH * ranges[widest] { widest } else { 2 })
}
