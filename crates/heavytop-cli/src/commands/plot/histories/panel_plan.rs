//! The coordinates that a panel shows: [`PanelPlan`].

use crate::commands::plot::run_subject::shape_of;
use crate::pictures::curves::curve::STYLES;

/// The largest number of panels of coordinates.
const MOST_PANELS: usize = 4;

/// A panel: a vector, or some numbers.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct PanelPlan {
    /// The names and the shapes of the arrays.
    pub arrays: Vec<(String, Vec<usize>)>,
    /// The names of the columns that are drawn, the first ones of the arrays.
    pub columns: Vec<String>,
    is_of_numbers: bool,
}

impl PanelPlan {
    /// Returns the panels of some coordinates, at most four: one for each vector, and one for numbers that stand together.
    pub fn all(coordinates: Vec<(String, Vec<String>)>) -> Vec<Self> {
        let mut plans: Vec<Self> = Vec::new();
        for (name, mut columns) in coordinates {
            let (shape, is_number) = (shape_of(&columns), columns.len() == 1);
            columns.truncate(STYLES.len());
            let has_room = |last: &&mut Self| {
                is_number && last.is_of_numbers && last.columns.len() < STYLES.len()
            };
            match plans.last_mut().filter(has_room) {
                Some(last) => {
                    last.arrays.push((name, shape));
                    last.columns.extend(columns);
                }
                None => plans.push(Self {
                    arrays: vec![(name, shape)],
                    columns,
                    is_of_numbers: is_number,
                }),
            }
        }
        plans.truncate(MOST_PANELS);
        plans
    }

    /// Returns the title of the ordinate; the names of several numbers are in the legend alone.
    pub fn title(&self) -> String {
        match &self.arrays[..] {
            [(name, _)] => name.clone(),
            _ => "coordinates".into(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn vectors_have_panels_and_numbers_share_them() {
        fn numbers(names: &str) -> impl Iterator<Item = (String, Vec<String>)> {
            names.split(' ').map(|name| (name.to_owned(), vec![name.to_owned()]))
        }
        let vector = |name: &str, count: usize| {
            (name.to_owned(), (1..=count).map(|i| format!("{name}{i}")).collect())
        };
        let titles = |coordinates: Vec<(String, Vec<String>)>| -> Vec<(String, usize)> {
            let plans = PanelPlan::all(coordinates);
            plans.iter().map(|plan| (plan.title(), plan.columns.len())).collect()
        };
        let expected = |all: &[(&str, usize)]| -> Vec<(String, usize)> {
            all.iter().map(|(title, count)| ((*title).into(), *count)).collect()
        };
        let mixed = [vector("Pi", 3)].into_iter().chain(numbers("x y")).chain([vector("l", 2)]);
        assert_eq!(titles(mixed.collect()), expected(&[("Pi", 3), ("coordinates", 2), ("l", 2)]));
        let seven = numbers("a b c d e f g").collect();
        assert_eq!(titles(seven), expected(&[("coordinates", 6), ("g", 1)]));
        assert_eq!(titles(vec![vector("mu", 15)]), expected(&[("mu", 6)]));
        let many = (0..9).map(|i| vector(&format!("S_{i}"), 3)).collect();
        assert_eq!(titles(many).len(), MOST_PANELS);
    }
}
