//! The row of one member: the observables of its motion.

use super::sweep_plan::Plan;

/// The values of all observables of a member.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Row {
    /// The values of the columns of all observables; `None` where one has no value.
    pub values: Vec<Option<f64>>,
    /// The reason why the member has no values at all.
    pub failure: Option<String>,
}

impl Row {
    /// Returns the value in a column, if there is one.
    pub fn value(&self, column: usize) -> Option<f64> {
        self.values.get(column).copied().flatten()
    }
}

/// Follows the member with this number and measures its row, which depends on the plan and the number alone.
pub(super) fn measure(plan: &Plan, number: u64) -> Row {
    match plan.family.measure(&plan.parameters(number), &plan.course) {
        Ok(values) => {
            let finite = |value: Option<f64>| value.filter(|value| value.is_finite());
            Row { values: values.into_iter().map(finite).collect(), failure: None }
        }
        Err(failure) => Row {
            values: vec![None; plan.columns.len()],
            failure: Some(failure.message().replace('\n', " ")),
        },
    }
}
