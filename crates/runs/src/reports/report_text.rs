//! A report as a table for people.

use super::report_line::ReportLine;
use super::top_report::TopReport;
use core::fmt;

impl fmt::Display for TopReport {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.write_str(self.kind)?;
        for ReportLine { name, measured, unit, formulas } in &self.lines {
            let measured = measured
                .map_or_else(|| "not in this run".into(), |x| format!("{} {unit}", short(x)));
            write!(to, "\n  {name:<50} {measured}")?;
            for (formula, value) in formulas {
                write!(to, "\n    {formula:<48} {} {unit}", short(*value))?;
            }
        }
        if !self.steady.is_empty() {
            to.write_str(
                "\nsteady rotations with the same angular momentum, those of least energy first",
            )?;
        }
        for one in &self.steady {
            let direction = if self.is_free { "L along" } else { "Γ =" };
            let [x, y, z] = [one.vertical.x, one.vertical.y, one.vertical.z].map(digits);
            let circle = if one.is_circle { ", and about the axis" } else { "" };
            let stability = match one.growth {
                0.0 => "disturbances do not grow".to_string(),
                growth => format!("disturbances grow e-fold in {} s", short(1.0 / growth)),
            };
            write!(
                to,
                "\n  {direction} ({x}, {y}, {z}){circle}\n    Ω = {} rad/s; {stability}; the run comes as near as \
                 {:.3} deg",
                short(one.rate),
                one.nearest.to_degrees()
            )?;
        }
        Ok(())
    }
}

/// Returns a number with six digits.
fn short(x: f64) -> String {
    let rounded = format!("{x:.5e}").parse().unwrap_or(x);
    match rounded == 0.0 || (1e-4..1e9).contains(&f64::abs(rounded)) {
        true => rounded.to_string(),
        false => format!("{rounded:e}"),
    }
}

/// Returns a component of a unit vector with four decimals, without the sign of zero.
fn digits(x: f64) -> String {
    format!("{:.4}", (x * 1e4).round() / 1e4 + 0.0)
}
