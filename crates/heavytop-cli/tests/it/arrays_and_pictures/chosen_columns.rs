//! Pictures of the columns that somebody chooses, against time, against one another, and as directions on the sphere.

use super::drawn_marks::{Outline, lines, numbers_of, outlines};
use super::plots::{COLOURS, drawn, on_map};
use crate::program::{Folder, numbers};

/// A top in slow precession, whose spin passes ±π, with all columns that can be asked for.
const TOP: &str = "body = { inertia = [0.8, 0.8, 0.5], mass = 2, gravity = 9.81, length = 0.05, \
    center_of_mass = [0, 0, 1] }\n\
    initial = { angular_velocity = [0.5, 0.2, 9], euler_angles = [0, 0.5, 1] }\n\
    integrator = { step = 0.01, end = 3 }\n\
    output = { columns = ['Omega', 'euler-angles', 'height', 'kinetic', 'potential', 'spatial-momentum'] }\n";

/// Returns the values of a column of the table.
fn column(folder: &Folder, name: &str) -> Vec<f64> {
    let (header, rows) = numbers(&folder.read("a.csv"));
    let place = header.iter().position(|other| other == name);
    rows.iter().map(|row| row[place.unwrap()]).collect()
}

/// Returns the least and the largest value with a twentieth of the range around.
fn ends(values: &[f64]) -> [f64; 2] {
    let least = values.iter().copied().fold(f64::INFINITY, f64::min);
    let most = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let room = 0.05 * (most - least);
    [least - room, most + room]
}

/// Returns whether a curve goes through these places along a field: the abscissa from the left, the ordinate from below.
fn goes_through(field: &Outline, curve: &str, along: &[f64], upward: &[f64]) -> bool {
    let points = numbers_of(curve);
    let points = points.as_chunks::<2>().0;
    let is_near = |(([x, y], along), upward): ((&[f64; 2], &f64), &f64)| {
        let at_x = field.left + field.width() * along;
        let at_y = field.bottom - (field.bottom - field.top) * upward;
        (x - at_x).abs() < 1.0 && (y - at_y).abs() < 1.0
    };
    points.len() == along.len() && points.iter().zip(along).zip(upward).all(is_near)
}

fn scaled(values: &[f64], [least, most]: [f64; 2]) -> Vec<f64> {
    values.iter().map(|value| (value - least) / (most - least)).collect()
}

#[test]
fn columns_that_a_run_was_asked_for_have_panels() {
    let folder = Folder::new();
    let (svg, _) = drawn(&folder, TOP, &[]);
    let fields = outlines(&svg);
    // Π, Γ, Ω, φ and ψ, θ, the height, both energies, the spatial momentum, and the deviations.
    assert_eq!(fields.len(), 9);
    let time = scaled(&column(&folder, "t"), [0.0, 3.0]);
    let omega: Vec<Vec<f64>> = ["Omega1", "Omega2", "Omega3"].map(|n| column(&folder, n)).into();
    let range = ends(&omega.concat());
    for (values, colour) in omega.iter().zip(COLOURS) {
        let curves = lines(&svg, colour, 21);
        let through = |values: &[f64]| {
            curves.iter().any(|one| goes_through(&fields[2], one, &time, &scaled(values, range)))
        };
        assert!(through(values), "{colour}");
        // Control: 1 % of the range is seen.
        let off: Vec<f64> = values.iter().map(|x| x + 0.01 * (range[1] - range[0])).collect();
        assert!(!through(&off), "{colour}");
    }
    // ψ has a piece more for each jump.
    let spin = column(&folder, "psi");
    let jumps = spin.windows(2).filter(|pair| (pair[0] - pair[1]).abs() > 3.0).count();
    let second = |field: &Outline| {
        let inside = |curve: &&String| {
            let place = Outline::of(curve);
            place.top >= field.top && place.bottom <= field.bottom
        };
        lines(&svg, COLOURS[1], 21).iter().filter(inside).count()
    };
    assert!(jumps > 2, "the spin does not pass π");
    assert_eq!((second(&fields[3]), second(&fields[2])), (jumps + 1, 1));
}

#[test]
fn only_chosen_columns_are_drawn_and_in_their_order() {
    let folder = Folder::new();
    let (svg, _) = drawn(&folder, TOP, &["--columns", "potential,theta,Pi3,kinetic,h,Pi1"]);
    let fields = outlines(&svg);
    assert_eq!(fields.len(), 3);
    let time = scaled(&column(&folder, "t"), [0.0, 3.0]);
    let panels: [&[&str]; 3] = [&["potential", "kinetic", "h"], &["theta"], &["Pi3", "Pi1"]];
    for (field, names) in fields.iter().zip(panels) {
        let values: Vec<Vec<f64>> = names.iter().map(|name| column(&folder, name)).collect();
        let range = ends(&values.concat());
        for (values, colour) in values.iter().zip(COLOURS) {
            let curves = lines(&svg, colour, 21);
            let values = scaled(values, range);
            assert!(curves.iter().any(|one| goes_through(field, one, &time, &values)), "{names:?}");
        }
    }
    let counts = |svg: &str| COLOURS.map(|colour| lines(svg, colour, 21).len());
    assert_eq!(counts(&svg), [3, 2, 1, 0, 0, 0]);
    // The names of `[output] columns` are names of arrays.
    let (svg, _) = drawn(&folder, TOP, &["--columns", "spatial-momentum"]);
    assert_eq!((outlines(&svg).len(), counts(&svg)), (1, [1, 1, 1, 0, 0, 0]));
}

#[test]
fn a_column_is_drawn_against_another_one() {
    let folder = Folder::new();
    let (svg, _) = drawn(&folder, TOP, &["--columns", "Pi2,height", "--against", "Pi1"]);
    let fields = outlines(&svg);
    assert_eq!(fields.len(), 2);
    let scaled_column = |name: &str| {
        let values = column(&folder, name);
        scaled(&values, ends(&values))
    };
    let curves = lines(&svg, COLOURS[0], 21);
    assert_eq!(curves.len(), 2);
    for ((field, curve), name) in fields.iter().zip(&curves).zip(["Pi2", "height"]) {
        let upward = scaled_column(name);
        assert!(goes_through(field, curve, &scaled_column("Pi1"), &upward), "{name}");
        // Control: the time is not on the abscissa.
        assert!(!goes_through(field, curve, &scaled_column("t"), &upward), "{name}");
    }
}

/// Returns the components of R e₃ by the Euler angles: (sin θ sin φ, −sin θ cos φ, cos θ).
fn axis_in_space(folder: &Folder) -> [Vec<f64>; 3] {
    let [phi, theta] = ["phi", "theta"].map(|name| column(folder, name));
    let angles = || phi.iter().zip(&theta);
    [
        angles().map(|(phi, theta)| theta.sin() * phi.sin()).collect(),
        angles().map(|(phi, theta)| -theta.sin() * phi.cos()).collect(),
        angles().map(|(_, theta)| theta.cos()).collect(),
    ]
}

#[test]
fn the_track_of_a_direction_is_on_the_sphere() {
    let folder = Folder::new();
    for (array, size) in [("Gamma", 1.0), ("spatial_momentum", 4.6), ("axis", 1.0)] {
        let (svg, _) = drawn(&folder, TOP, &["--trace", array]);
        // The outline of the map is the narrower of the two.
        let outline = outlines(&svg).into_iter().min_by(|a, b| a.width().total_cmp(&b.width()));
        let outline = outline.unwrap();
        let vector = match array {
            "axis" => axis_in_space(&folder),
            _ => [1, 2, 3].map(|i| column(&folder, &format!("{array}{i}"))),
        };
        let points: Vec<f64> =
            lines(&svg, "#0072b2", 14).iter().flat_map(|piece| numbers_of(piece)).collect();
        for sample in 0..vector[0].len() {
            let vector = [0, 1, 2].map(|i| vector[i][sample]);
            let length = vector.iter().map(|x| x * x).sum::<f64>().sqrt();
            assert!((length / size - 1.0).abs() < 0.1, "{array} {length}");
            let is_drawn = |vector: [f64; 3]| {
                let [x, y] = on_map(&outline, vector.map(|component| component / length));
                let is_near = |[a, b]: &[f64; 2]| (x - a).abs() < 1.0 && (y - b).abs() < 1.0;
                points.as_chunks::<2>().0.iter().any(is_near)
            };
            assert!(is_drawn(vector), "{array} {sample}");
            // Control: the opposite direction is not.
            assert!(!is_drawn(vector.map(|component| -component)), "{array} {sample}");
        }
    }
}

#[test]
fn columns_that_are_missing_and_options_that_contradict_each_other_are_refused() {
    let folder = Folder::new();
    let text = "integrator = { step = 0.02, end = 0.1 }";
    drawn(&folder, text, &[]);
    for (options, told) in [
        (
            &["--columns", "Pi1,Omega"][..],
            "no column or array Omega; it has t, Pi, Pi1, Pi2, Pi3, Gamma",
        ),
        (&["--columns", "Pi1", "--against", "Pi"], "no column Pi; it has t, Pi1, Pi2"),
        (&["--trace", "h"], "no vector of three components h; it has Pi, Gamma"),
        (&["--trace", "axis"], "write attitude = true under [output]"),
        (&["--columns", "theta"], "write columns = [\"euler-angles\"] under [output]"),
        (&["--against", "Pi1"], "--against is for pictures of --columns"),
        (&["--columns", "Pi1", "--trace", "Pi"], "--columns is for pictures without --trace"),
        (&["--columns", "Pi1", "--sample", "0"], "--sample is for lattices"),
        (&["--trace", "Pi", "--plane", "0"], "--plane is for lattices"),
    ] {
        let run = folder.heavytop(&[&["plot", "a.npz", "--out", "other.svg"], options].concat());
        assert!(run.code() != 0 && run.stderr().contains(told), "{options:?} {}", run.stderr());
    }
    let film = folder.heavytop(&["plot", "a.npz", "--out", "a.gif", "--columns", "Pi"]);
    assert!(film.code() == 2 && film.stderr().contains("would be a film"), "{}", film.stderr());
    // A lattice has no columns.
    let spins = "[system]\nkind = 'spin-lattice'\nparameters = { shape = [2, 2], exchange = 1 }\n\
        initial = { tilt = 1 }\n[integrator]\nstep = 0.1\nend = 0.2\n";
    folder.write("spins.toml", spins);
    assert_eq!(folder.heavytop(&["simulate", "spins.toml", "--out", "s.npz"]).code(), 0);
    for option in [&["--columns", "h"], &["--trace", "S"]] {
        let run = folder.heavytop(&[&["plot", "s.npz", "--out", "s.svg"][..], option].concat());
        let told = format!("{} is for runs of tops and of formulas", option[0]);
        assert!(run.code() == 2 && run.stderr().contains(&told), "{}", run.stderr());
    }
}

#[test]
fn spins_and_numbers_by_formula_are_chosen_by_their_own_names() {
    let folder = Folder::new();
    let text = "[system]\nkind = 'spin-chain'\nparameters = { spins = 3, exchange = 1, field = [0.3, 0, 0.2] }\n\
        initial = { S_1 = [1, 0, 0], S_2 = [0, 1, 0], S_3 = [0, 0.6, 0.8] }\n[integrator]\nstep = 0.05\nend = 2\n";
    let (svg, rows) = drawn(&folder, text, &["--columns", "S_2,h"]);
    assert_eq!(outlines(&svg).len(), 2);
    assert_eq!(COLOURS.map(|colour| lines(&svg, colour, 21).len()), [2, 1, 1, 0, 0, 0]);
    let (track, _) = drawn(&folder, text, &["--trace", "S_1"]);
    let points: usize = lines(&track, "#0072b2", 14).iter().map(|p| numbers_of(p).len() / 2).sum();
    assert!(points >= rows.len());
}

/// Returns the rows of dots of a chart of text, from the top: whether each place has one.
fn dots(chart: &[&str]) -> Vec<Vec<bool>> {
    let bits = [[0x01, 0x08], [0x02, 0x10], [0x04, 0x20], [0x40, 0x80]];
    let row = |(line, row): (&&str, usize)| -> Vec<bool> {
        let characters = line.chars().map(|c| u32::from(c) - 0x2800);
        characters.flat_map(|set| bits[row].map(|bit| set & bit != 0)).collect()
    };
    chart.iter().flat_map(|line| (0..4).map(move |i| row((line, i)))).collect()
}

#[test]
fn columns_are_drawn_in_the_terminal() {
    let folder = Folder::new();
    drawn(&folder, TOP, &[]);
    let run = folder.heavytop(&["plot", "a.npz", "--columns", "theta,Pi1", "--quiet"]);
    assert_eq!((run.code(), run.stderr()), (0, String::new()));
    let text = run.stdout();
    let lines: Vec<&str> = text.lines().filter(|line| !line.is_empty()).collect();
    assert_eq!(lines.len(), 2 * (1 + 8));
    for (chart, (name, title)) in
        lines.chunks(9).zip([("theta", "θ (rad)"), ("Pi1", "Π₁ (kg m²/s)")])
    {
        let values = column(&folder, name);
        let least = values.iter().copied().fold(f64::INFINITY, f64::min);
        let most = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        assert!(
            chart[0].starts_with(title) && chart[0].ends_with("against t (s) from 0 to 3"),
            "{text}"
        );
        let dots = dots(&chart[1..]);
        let [width, height] = [dots[0].len(), dots.len()];
        assert_eq!([width, height], [152, 32]);
        for (number, value) in values.iter().enumerate() {
            let at = |part: f64, count: usize| (part * (count - 1) as f64).round() as usize;
            let x = at(number as f64 / (values.len() - 1) as f64, width);
            let y = height - 1 - at((value - least) / (most - least), height);
            let near = |y: usize| (x.max(1) - 1..=(x + 1).min(width - 1)).any(|x| dots[y][x]);
            assert!((y.max(1) - 1..=(y + 1).min(height - 1)).any(near), "{name} {number}");
        }
        // Control: most of the chart has no dots.
        let set = dots.iter().flatten().filter(|dot| **dot).count();
        assert!(set < width * height / 4, "{set}");
    }
    for (options, told) in [
        (&["--trace", "Gamma"][..], "a direction on the sphere cannot be drawn in a terminal"),
        (&["--columns", "x"], "no column or array x"),
        (&["--fps", "9"], "--fps is for films"),
    ] {
        let run = folder.heavytop(&[&["plot", "a.npz"], options].concat());
        assert!(run.code() == 2 && run.stderr().contains(told), "{options:?} {}", run.stderr());
    }
}
