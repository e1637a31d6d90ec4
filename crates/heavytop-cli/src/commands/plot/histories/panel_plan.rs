//! The columns that a panel shows: [`PanelPlan`].

use crate::commands::plot::quantities::run_column::RunColumn;
use crate::errors::Error;
use crate::pictures::curves::curve::STYLES;

/// The largest number of panels of coordinates.
const MOST_PANELS: usize = 4;

/// The largest number of panels of chosen columns, which are a third of a metre high.
const MOST_CHOSEN: usize = 12;

/// A panel: columns of a vector, or some numbers of one unit.
#[derive(Clone, Debug, Default, PartialEq)]
pub(in crate::commands::plot) struct PanelPlan {
    pub columns: Vec<RunColumn>,
}

impl PanelPlan {
    /// Returns the panels of some columns, in their order: one for each vector, and one for numbers of one unit. Where
    /// there are more curves than styles, the others have panels of their own.
    pub fn all(columns: impl IntoIterator<Item = RunColumn>) -> Vec<Self> {
        let mut plans: Vec<Self> = Vec::new();
        for column in columns {
            let fits = |plan: &&mut Self| {
                plan.columns.len() < STYLES.len()
                    && plan.columns.first().is_some_and(|first| are_together(first, &column))
            };
            match plans.iter_mut().find(fits) {
                Some(plan) => plan.columns.push(column),
                None => plans.push(Self { columns: vec![column] }),
            }
        }
        plans
    }

    /// Returns the panels of all coordinates that have room: at most four, of at most as many curves as there are styles.
    pub fn of_coordinates(columns: impl IntoIterator<Item = RunColumn>) -> Vec<Self> {
        let drawn = columns.into_iter().filter(|column| column.place < STYLES.len());
        let mut plans = Self::all(drawn);
        plans.truncate(MOST_PANELS);
        plans
    }

    /// Returns the panels of the columns that somebody chose.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if there are more than twelve.
    pub fn chosen(columns: Vec<RunColumn>) -> Result<Vec<Self>, Error> {
        let plans = Self::all(columns);
        match plans.len() {
            0..=MOST_CHOSEN => Ok(plans),
            count => {
                let range = "at most 12 panels";
                Err(Error::OutOfRange { name: "columns", range, value: count as f64 })
            }
        }
    }

    /// Returns the title of the ordinate; the names of several numbers without a common unit are in the legend alone.
    pub fn title(&self) -> String {
        match &self.columns[..] {
            [] => String::new(),
            [only] => only.with_unit(&only.symbol),
            [first, ..] if first.is_periodic() => {
                let symbols: Vec<&str> = self.columns.iter().map(|one| &*one.symbol).collect();
                first.with_unit(&symbols.join(", "))
            }
            [first, ..] if !first.is_number() => first.with_unit(&first.title),
            [first, ..] if first.unit.is_none() => "coordinates".into(),
            [first, ..] if first.unit == Some("J") => first.with_unit("energy"),
            [first, ..] => {
                let symbols: Vec<&str> = self.columns.iter().map(|one| &*one.symbol).collect();
                first.with_unit(&symbols.join(", "))
            }
        }
    }

    /// Returns the names and the shapes of the arrays.
    pub fn arrays(&self) -> Vec<(String, Vec<usize>)> {
        let mut arrays: Vec<(String, Vec<usize>)> = Vec::new();
        for column in &self.columns {
            if !arrays.iter().any(|(name, _)| *name == column.array) {
                arrays.push((column.array.clone(), column.shape.clone()));
            }
        }
        arrays
    }

    /// Returns the places of the columns in the numbers of a sample of some arrays, one after the other.
    pub fn places(&self, arrays: &[(String, Vec<usize>)]) -> Vec<usize> {
        let place = |column: &RunColumn| {
            let before = arrays.iter().take_while(|(name, _)| *name != column.array);
            before.map(|(_, shape)| shape.iter().product::<usize>()).sum::<usize>() + column.place
        };
        self.columns.iter().map(place).collect()
    }
}

/// Returns whether two columns belong into one panel.
fn are_together(one: &RunColumn, other: &RunColumn) -> bool {
    // The inclination is in degrees of its own: beside angles that turn round it would look flat.
    let angles = one.array == "euler_angles" && one.unit.is_some();
    if angles && one.array == other.array {
        return one.is_periodic() == other.is_periodic();
    }
    one.array == other.array || one.is_number() && other.is_number() && one.unit == other.unit
}

#[cfg(test)]
mod tests {
    use super::*;

    fn array(array: &str, count: usize, unit: Option<&'static str>) -> Vec<RunColumn> {
        let shape = if count == 1 { Vec::new() } else { vec![count] };
        let column = |place: usize| {
            let name = if count == 1 { array.into() } else { format!("{array}{}", place + 1) };
            let (array, title, shape) = (array.into(), array.into(), shape.clone());
            RunColumn { symbol: name.clone(), name, array, title, shape, place, unit }
        };
        (0..count).map(column).collect()
    }

    fn titles(plans: Vec<PanelPlan>) -> Vec<(String, usize)> {
        plans.iter().map(|plan| (plan.title(), plan.columns.len())).collect()
    }

    fn expected(all: &[(&str, usize)]) -> Vec<(String, usize)> {
        all.iter().map(|(title, count)| ((*title).into(), *count)).collect()
    }

    #[test]
    fn vectors_have_panels_and_numbers_share_them() {
        let numbers =
            |names: &str| names.split(' ').flat_map(|name| array(name, 1, None)).collect();
        let mixed: Vec<RunColumn> =
            [array("Pi", 3, None), numbers("x y"), array("l", 2, None)].concat();
        let found = titles(PanelPlan::of_coordinates(mixed));
        assert_eq!(found, expected(&[("Pi", 3), ("coordinates", 2), ("l", 2)]));
        let seven: Vec<RunColumn> = numbers("a b c d e f g");
        let found = titles(PanelPlan::of_coordinates(seven));
        assert_eq!(found, expected(&[("coordinates", 6), ("g", 1)]));
        let wide = || array("mu", 15, None);
        assert_eq!(titles(PanelPlan::of_coordinates(wide())), expected(&[("mu", 6)]));
        let many = (0..9).flat_map(|i| array(&format!("S_{i}"), 3, None));
        assert_eq!(PanelPlan::of_coordinates(many).len(), MOST_PANELS);
        // Nothing that somebody chose is left out.
        let found = PanelPlan::chosen(wide()).map(titles);
        assert_eq!(found.ok(), Some(expected(&[("mu", 6), ("mu", 6), ("mu", 3)])));
        let many = (0..13).flat_map(|i| array(&format!("S_{i}"), 3, None)).collect();
        assert!(PanelPlan::chosen(many).is_err());
    }

    #[test]
    fn numbers_of_one_unit_share_a_panel_whose_title_has_it() {
        let all = [
            array("kinetic", 1, Some("J")),
            array("height", 1, Some("m")),
            array("potential", 1, Some("J")),
            array("f1", 1, Some("")),
            array("Omega", 3, Some("rad/s")),
        ];
        let plans = PanelPlan::all(all.concat());
        let places: Vec<Vec<usize>> =
            plans.iter().map(|plan| plan.places(&plan.arrays())).collect();
        assert_eq!(places, [vec![0, 1], vec![0], vec![0], vec![0, 1, 2]]);
        let titles = titles(plans);
        let wanted = [("energy (J)", 2), ("height (m)", 1), ("f1", 1), ("Omega (rad/s)", 3)];
        assert_eq!(titles, expected(&wanted));
    }
}
