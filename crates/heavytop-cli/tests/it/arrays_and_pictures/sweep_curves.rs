//! Sweeps with a single axis: the table in CSV, and the curves of their observables.

use super::drawn_marks::{lines, numbers_of, outlines, paths};
use crate::commands::sweep::{column, failures, rows};
use crate::program::Folder;

/// A body with a spring k, which has no Hamiltonian at k = 0 in the middle of the axis.
const SYSTEM: &str = "[system]\nalgebra = 'so(3)'\nhamiltonian = 'Pi1^2/2 + Pi2^2/3 + Pi3^2/(2*k)'\n\
    parameters.k = 1\ninitial.Pi = [1, 0.5, 0.3]\n\
    [sweep]\nobservables = ['final-state', 'invariant-drift']\n\
    axes = [{ parameter = 'system.parameters.k', from = -1, to = 1, count = 9 }]\n\
    [integrator]\nformulation = 'reduced'\nscheme = 'gauss-4'\nstep = 0.1\nend = 2.0\n";

fn swept(folder: &Folder, text: &str) {
    folder.write("a.toml", text);
    let run = folder.heavytop(&["sweep", "a.toml", "--out", "made", "--restart"]);
    assert_eq!(run.code(), 0, "{}", run.stderr());
}

/// Returns the cells of a line of a table by RFC 4180.
fn cells(line: &str) -> Vec<String> {
    let (mut cells, mut is_quoted) = (vec![String::new()], false);
    let mut characters = line.chars().peekable();
    while let Some(character) = characters.next() {
        match character {
            '"' if is_quoted && characters.peek() == Some(&'"') => {
                characters.next();
                cells.last_mut().unwrap().push('"');
            }
            '"' => is_quoted = !is_quoted,
            ',' if !is_quoted => cells.push(String::new()),
            other => cells.last_mut().unwrap().push(other),
        }
    }
    cells
}

#[test]
fn the_table_of_a_single_axis_is_that_of_parquet() {
    let folder = Folder::new();
    swept(&folder, SYSTEM);
    let table = folder.read("made/sweep.csv");
    let lines: Vec<Vec<String>> = table.lines().map(cells).collect();
    let names = ["index", "system.parameters.k", "Pi1", "Pi2", "Pi3", "drift_h", "drift_c1"];
    assert_eq!(lines[0], [&names[..], &["failure"]].concat());
    let rows = rows(&folder, "made/sweep.parquet");
    assert_eq!((lines.len(), rows.len()), (10, 9));
    for (place, name) in names.iter().enumerate().skip(1) {
        let parsed = lines[1..].iter().map(|line| match line[place].as_str() {
            "" => None,
            number => Some(number.parse::<f64>().unwrap().to_bits()),
        });
        let expected = column(&rows, name).into_iter().map(|value| value.map(f64::to_bits));
        assert!(parsed.eq(expected), "{name}");
    }
    for (number, (line, failure)) in lines[1..].iter().zip(failures(&rows)).enumerate() {
        assert_eq!(line[0], number.to_string());
        assert_eq!(*line.last().unwrap(), failure.clone().unwrap_or_default());
        // Control: only the member in the middle has failed.
        assert_eq!(failure.is_some(), number == 4, "{failure:?}");
    }
    // A table that is there is replaced, and one of somebody else is not.
    swept(&folder, &SYSTEM.replace("count = 9", "count = 5"));
    assert_eq!(folder.read("made/sweep.csv").lines().count(), 6);
    folder.write("made/sweep.csv", "index,k,failure,mine\n0,1,,2\n");
    let run = folder.heavytop(&["sweep", "a.toml", "--out", "made"]);
    assert!(run.code() == 2 && run.stderr().contains("sweep.csv"), "{}", run.stderr());
    assert!(folder.read("made/sweep.csv").contains("mine"));
}

#[test]
fn curves_go_through_the_values_and_have_gaps_without_them() {
    let folder = Folder::new();
    swept(&folder, SYSTEM);
    let rows = rows(&folder, "made/sweep.parquet");
    for (name, is_logarithmic) in [("Pi2", false), ("drift_h", true)] {
        let scaled = |value: f64| if is_logarithmic { value.log10() } else { value };
        let values: Vec<Option<f64>> =
            column(&rows, name).into_iter().map(|value| value.map(scaled)).collect();
        let all = || values.iter().copied().flatten();
        let (least, most) = (all().fold(f64::INFINITY, f64::min), all().fold(-1e300, f64::max));
        let room = 0.05 * (most - least);
        let svg = folder.read(&format!("made/{name}.svg"));
        let field = &outlines(&svg)[0];
        let height = field.bottom - field.top;
        let place = |(number, value): (usize, Option<f64>)| {
            let upward = (value? - least + room) / (most - least + 2.0 * room);
            Some([field.left + field.width() * number as f64 / 8.0, field.bottom - height * upward])
        };
        let places: Vec<[f64; 2]> = values.iter().copied().enumerate().filter_map(place).collect();
        // The member in the middle is a gap.
        let pieces: Vec<Vec<f64>> =
            lines(&svg, "#0072b2", 21).iter().map(|piece| numbers_of(piece)).collect();
        assert_eq!(pieces.iter().map(Vec::len).collect::<Vec<_>>(), [8, 8], "{name}");
        let points: Vec<f64> = pieces.concat();
        let near = |expected: &[[f64; 2]]| {
            let points = points.as_chunks::<2>().0.iter();
            points
                .zip(expected)
                .all(|(a, b)| (a[0] - b[0]).abs() < 1.0 && (a[1] - b[1]).abs() < 1.0)
        };
        assert!(near(&places), "{name}: {points:?} {places:?}");
        // Control: in another order they are not.
        assert!(!near(&places.iter().rev().copied().collect::<Vec<_>>()), "{name}");
        assert!(folder.path(&format!("made/{name}.png")).exists());
    }
}

#[test]
fn random_members_are_dots_and_two_axes_have_no_table_in_csv() {
    let folder = Folder::new();
    let random = SYSTEM
        .replace("from = -1, to = 1, count = 9", "uniform = [1, 2]")
        .replace("[sweep]", "[sweep]\ncount = 300");
    swept(&folder, &random);
    let svg = folder.read("made/Pi1.svg");
    assert!(lines(&svg, "#0072b2", 21).is_empty());
    let dots = paths(&svg, "stroke-linecap=\"round\"");
    assert_eq!(dots.iter().map(|path| path.matches('M').count()).sum::<usize>(), 300);
    let folder = Folder::new();
    let axis = "{ parameter = 'system.parameters.k', from = -1, to = 1, count = 9 }";
    let second = ", { parameter = 'system.initial.Pi[0]', from = 1, to = 2, count = 2 }";
    swept(&folder, &SYSTEM.replace(axis, &format!("{axis}{second}")));
    assert!(folder.path("made/Pi1.svg").exists() && !folder.path("made/sweep.csv").exists());
}
