//! The columns and arrays that somebody names: [`chosen`], [`column`] and [`vector`].

use super::run_column::RunColumn;
use crate::errors::FieldFileError;

/// Returns the columns of these names of columns or arrays, in their order, each once.
///
/// # Errors
/// [`FieldFileError::NoArray`] for a name of neither.
pub(in crate::commands::plot) fn chosen(
    all: &[RunColumn],
    names: &[String],
) -> Result<Vec<RunColumn>, FieldFileError> {
    let mut chosen: Vec<RunColumn> = Vec::new();
    for name in names {
        let meant = in_archives(name);
        let of_array = all.iter().any(|column| column.array == meant);
        let is_meant = |column: &&RunColumn| match of_array {
            true => column.array == meant,
            false => column.name == meant,
        };
        let mut found = all.iter().filter(is_meant).peekable();
        if found.peek().is_none() {
            let has = all.iter().flat_map(|column| [&column.array, &column.name]);
            return Err(missing("column or array", name, has));
        }
        for column in found {
            if !chosen.contains(column) {
                chosen.push(column.clone());
            }
        }
    }
    Ok(chosen)
}

/// Returns the column of this name.
///
/// # Errors
/// [`FieldFileError::NoArray`] if there is none.
pub(in crate::commands::plot) fn column<'a>(
    all: &'a [RunColumn],
    name: &str,
) -> Result<&'a RunColumn, FieldFileError> {
    let found = all.iter().find(|column| column.name == name);
    found.ok_or_else(|| missing("column", name, all.iter().map(|column| &column.name)))
}

/// Returns the first column of the array of this name, a vector of three components.
///
/// # Errors
/// [`FieldFileError::NoArray`] if there is none.
pub(in crate::commands::plot) fn vector<'a>(
    all: &'a [RunColumn],
    name: &str,
) -> Result<&'a RunColumn, FieldFileError> {
    // Angles are no direction.
    let is_vector = |column: &&RunColumn| column.shape == [3] && column.array != "euler_angles";
    let found = all.iter().filter(is_vector).find(|column| column.array == in_archives(name));
    found.ok_or_else(|| {
        let has = all.iter().filter(is_vector).map(|column| &column.array);
        missing("vector of three components", name, has)
    })
}

/// Returns the first column of the attitude.
///
/// # Errors
/// [`FieldFileError::NoArray`] if there is none.
pub(in crate::commands::plot) fn attitude(all: &[RunColumn]) -> Result<&RunColumn, FieldFileError> {
    let found = all.iter().find(|column| column.array == "q" && column.shape == [4]);
    found.ok_or_else(|| missing("attitude", "q", all.iter().map(|column| &column.array)))
}

/// Returns a name as archives have it: those of `[output] columns` have hyphens.
fn in_archives(name: &str) -> String {
    name.replace('-', "_")
}

fn missing<'a>(
    kind: &'static str,
    name: &str,
    names: impl Iterator<Item = &'a String>,
) -> FieldFileError {
    let mut has: Vec<String> = Vec::new();
    for name in names {
        if !has.contains(name) {
            has.push(name.clone());
        }
    }
    FieldFileError::NoArray { kind, name: name.into(), has }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn columns() -> Vec<RunColumn> {
        let array = |array: &str, names: &str| {
            let names: Vec<String> = names.split(' ').map(String::from).collect();
            let shape = if names.len() == 1 { Vec::new() } else { vec![names.len()] };
            let column = |(place, name): (usize, &String)| RunColumn {
                name: name.clone(),
                symbol: name.clone(),
                array: array.into(),
                title: array.into(),
                shape: shape.clone(),
                place,
                unit: None,
            };
            names.iter().enumerate().map(column).collect::<Vec<_>>()
        };
        [array("t", "t"), array("Pi", "Pi1 Pi2 Pi3"), array("q", "qw qx qy qz"), array("h", "h")]
            .concat()
    }

    fn names(found: &[RunColumn]) -> Vec<&str> {
        found.iter().map(|column| &*column.name).collect()
    }

    #[test]
    fn arrays_and_columns_are_chosen_in_their_order_and_once() {
        let all = columns();
        let choose =
            |names: &[&str]| chosen(&all, &names.iter().map(|s| s.to_string()).collect::<Vec<_>>());
        let found = choose(&["h", "Pi3", "Pi", "h"]).unwrap();
        assert_eq!(names(&found), ["h", "Pi3", "Pi1", "Pi2"]);
        assert_eq!((column(&all, "qx").unwrap().place, vector(&all, "Pi").unwrap().place), (1, 0));
    }

    #[test]
    fn what_is_missing_is_told_with_what_there_is() {
        let all = columns();
        let told = chosen(&all, &["Pi4".into()]).unwrap_err().to_string();
        assert_eq!(
            told,
            "it has no column or array Pi4; it has t, Pi, Pi1, Pi2, Pi3, q, qw, qx, qy, qz, h"
        );
        // An array is no column, and neither a number nor four numbers are a direction.
        let told = column(&all, "Pi").unwrap_err().to_string();
        assert_eq!(told, "it has no column Pi; it has t, Pi1, Pi2, Pi3, qw, qx, qy, qz, h");
        for name in ["h", "q", "Pi1"] {
            let told = vector(&all, name).unwrap_err().to_string();
            assert_eq!(told, format!("it has no vector of three components {name}; it has Pi"));
        }
        assert!(vector(&all[..1], "t").unwrap_err().to_string().ends_with("; it has none"));
    }
}
