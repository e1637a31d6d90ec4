//! The words of the pictures of a sweep.

use crate::commands::sweep::sweep_plan::Plan;
use crate::configuration::Column;
use crate::errors::Error;
use crate::pictures::caption::{self, number};
use crate::pictures::charts::scaled_chart::TEXT;
use crate::pictures::charts::sheet::{Area, LINE, text};
use plotters::style::text_anchor::{HPos, VPos};

/// Returns the parts of the caption: how many members, by which method, and what all of them share.
pub(super) fn words(plan: &Plan) -> Vec<String> {
    let (schedule, method) = (plan.course.schedule, plan.family.method());
    let (formulation, scheme) = (method.formulation(), method.scheme());
    let mut parts = vec![
        format!("{} {}", plan.members, plan.nouns()),
        caption::method(formulation, scheme, schedule.step),
        format!("0 to {} s", number(schedule.end())),
    ];
    parts.extend(plan.family.shared());
    parts
}

/// Says in a picture without values why it is blank.
pub(super) fn blank(
    area: &Area,
    column: &Column,
    (failed, plan): (u64, &Plan),
) -> Result<(), Error> {
    let [noun, nouns] = plan.family.nouns();
    let mut lines = vec![format!("No {noun} has a value of"), column.label.clone()];
    if failed > 0 {
        lines.push(format!("{failed} of {} {nouns} could not be followed", plan.members));
        lines.push("sweep.parquet has the reasons".into());
    }
    let (width, height) = area.dim_in_pixel();
    for (row, line) in lines.iter().enumerate() {
        let y = f64::from(height) / 2.0 + 1.2 * LINE * TEXT * (row as f64 - 1.0);
        let style = text(TEXT, HPos::Center, VPos::Center);
        area.draw_text(line, &style, (width as i32 / 2, y as i32))?;
    }
    Ok(())
}
