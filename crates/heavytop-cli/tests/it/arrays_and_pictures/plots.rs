//! The pictures of runs: each mark is where the numbers of the run put it.

use super::drawn_marks::{Outline, colours, lines, numbers_of, outlines, paths};
use crate::program::{Finished, Folder, numbers};
use std::f64::consts::PI;

fn succeeded(done: &Finished) {
    assert_eq!(done.code(), 0, "{}", done.stderr());
}

/// Simulates a run, draws it as `a.svg`, and returns the drawing and the rows of the run.
pub fn drawn(folder: &Folder, text: &str, more: &[&str]) -> (String, Vec<Vec<f64>>) {
    folder.write("a.toml", text);
    for out in ["a.csv", "a.npz"] {
        succeeded(&folder.heavytop(&["simulate", "a.toml", "--out", out, "--force"]));
    }
    succeeded(&folder.heavytop(&[&["plot", "a.npz", "--out", "a.svg"], more].concat()));
    (folder.read("a.svg"), numbers(&folder.read("a.csv")).1)
}

const VORTICES: &str = "[system]\nkind = 'vortices'\nparameters = { strengths = [1, 0.5, -0.7] }\n\
    initial = { positions = [[-0.96, 0.28, 0], [0, 1, 0], [-0.6, 0, 0.8]] }\n\
    [integrator]\nstep = 0.05\nend = 40\n";

/// Returns a place on a map with this outline, by bisection for Mollweide's angle.
pub fn on_map(outline: &Outline, [x, y, z]: [f64; 3]) -> [f64; 2] {
    let (longitude, wanted) = (y.atan2(x), PI * z);
    let (mut low, mut high) = (-PI / 2.0, PI / 2.0);
    for _ in 0..60 {
        let angle: f64 = (low + high) / 2.0;
        match 2.0 * angle + (2.0 * angle).sin() < wanted {
            true => low = angle,
            false => high = angle,
        }
    }
    let [centre, middle] =
        [(outline.left + outline.right) / 2.0, (outline.top + outline.bottom) / 2.0];
    let radius = (outline.bottom - outline.top) / 2.0;
    [centre + radius * 2.0 * longitude / PI * low.cos(), middle - radius * low.sin()]
}

#[test]
fn vortices_and_their_tracks_are_where_they_are_on_the_sphere() {
    let folder = Folder::new();
    let (svg, rows) = drawn(&folder, VORTICES, &["--sample", "70"]);
    // The outline of the map is the narrower of the two.
    let outline = outlines(&svg).into_iter().min_by(|a, b| a.width().total_cmp(&b.width()));
    let outline = outline.unwrap();
    let place = |row: &[f64], vortex: usize| {
        let strength = [1.0, 0.5, -0.7][vortex];
        let at = 1 + 3 * vortex;
        on_map(&outline, [row[at] / strength, row[at + 1] / strength, row[at + 2] / strength])
    };
    let near = |[x, y]: [f64; 2], mark: &Outline| {
        let [a, b] = [(mark.left + mark.right) / 2.0, (mark.top + mark.bottom) / 2.0];
        (x - a).abs() < 1.0 && (y - b).abs() < 1.0
    };
    let disks = paths(&svg, "fill=\"#b2182b\"");
    // A ring is half as wide as its radius, which is 60 for few vortices.
    let rings = lines(&svg, "#2166ac", 30);
    assert_eq!((disks.len(), rings.len()), (2, 1));
    for (vortex, mark) in disks.iter().chain(&rings).enumerate() {
        assert!(near(place(&rows[70], vortex), &Outline::of(mark)), "{vortex}");
    }
    // The pieces of the tracks, of which those of the first two vortices have one colour.
    let pieces = ["#b2182b", "#2166ac"].map(|colour| lines(&svg, colour, 12));
    let points: Vec<Vec<f64>> = pieces.iter().flatten().map(|piece| numbers_of(piece)).collect();
    let count: usize = points.iter().map(|piece| piece.len() / 2).sum();
    // A track that leaves the map has two points more, and a piece.
    assert!(points.len() > 3, "no track is at the edge");
    assert_eq!(count, 3 * rows.len() + 2 * (points.len() - 3));
    for (vortex, row) in (0..3).flat_map(|vortex| rows.iter().map(move |row| (vortex, row))) {
        let [x, y] = place(row, vortex);
        let is_near = |[a, b]: &[f64; 2]| (x - a).abs() < 1.0 && (y - b).abs() < 1.0;
        let of_colour = pieces[usize::from(vortex == 2)].iter().map(|piece| numbers_of(piece));
        let is_drawn = of_colour.into_iter().any(|piece| piece.as_chunks().0.iter().any(is_near));
        assert!(is_drawn, "{vortex} {row:?}");
    }
    // Another sample has other places, and the same tracks.
    let (first, _) = drawn(&folder, VORTICES, &["--sample", "0"]);
    assert_ne!(paths(&first, "fill=\"#b2182b\""), disks);
    assert_eq!(lines(&first, "#b2182b", 12), pieces[0]);
}

/// A chain of three spins about this field.
fn chain(field: &str) -> String {
    format!(
        "[system]\nkind = 'spin-chain'\nparameters = {{ spins = 3, exchange = 1, field = {field} }}\n\
         initial = {{ S_1 = [1, 0, 0], S_2 = [0, 1, 0], S_3 = [0, 0.6, 0.8] }}\n[integrator]\nstep = 0.05\nend = 2\n"
    )
}

#[test]
fn a_chain_by_formula_has_a_row_of_pixels_for_each_spin() {
    let folder = Folder::new();
    let (svg, rows) = drawn(&folder, &chain("[0.3, 0, 0.2]"), &[]);
    assert_eq!(colours(&svg).len(), 3 * rows.len());
    assert_drawn(&svg, &rows, 3);
}

/// A spin wave about e₃ is not seen in the third components.
#[test]
fn a_chain_shows_the_component_that_varies() {
    let folder = Folder::new();
    let text = "[system]\nkind = 'spin-lattice'\nparameters = { shape = [8], exchange = 1 }\n\
        initial = { direction = [0, 0, 1], waves = [1], cone = 0.2 }\n[integrator]\nstep = 0.1\nend = 3\n";
    let (svg, rows) = drawn(&folder, text, &[]);
    let greens =
        colours(&svg).iter().map(|pixel| pixel[1]).collect::<std::collections::BTreeSet<_>>();
    assert!(greens.len() > 50, "{greens:?}");
    // Control: the third components are all alike.
    let range = |component: usize| {
        let values = || rows.iter().map(|row| row[component]);
        values().fold(f64::MIN, f64::max) - values().fold(f64::MAX, f64::min)
    };
    assert!(range(3) < 1e-12 && range(1) > 0.1);
}

/// Checks that the pixels are those of a component of the spins, by the greens of viridis.
fn assert_drawn(svg: &str, rows: &[Vec<f64>], component: usize) {
    let pixels = colours(svg);
    let of_spin = |spin: usize| rows.iter().map(move |row| row[3 * spin + component]);
    let above: Vec<f64> = (0..3).rev().flat_map(of_spin).collect();
    let most = above.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let least = above.iter().copied().fold(f64::INFINITY, f64::min);
    // The greens of viridis at equal distances.
    let greens = [1.0, 68.0, 120.0, 168.0, 209.0, 231.0];
    for (value, pixel) in above.iter().zip(&pixels) {
        let along = 5.0 * (value - least) / (most - least);
        let index = (along as usize).min(4);
        let part = along - index as f64;
        let green = greens[index] * (1.0 - part) + greens[index + 1] * part;
        assert!((f64::from(pixel[1]) - green).abs() < 0.51, "{value} {pixel:?}");
    }
    assert!(pixels.contains(&[253, 231, 37]) && pixels.contains(&[68, 1, 84]));
}

/// The columns of the first curves of a picture, the number of curves of each panel, and the configuration.
const PANELS: [(&[usize], &[usize], &str); 5] = [
    (&[1, 2, 3], &[3, 3, 4], "integrator = { step = 0.02, end = 5 }"),
    (
        &[1, 2, 3],
        &[3, 2],
        "[system]\nkind = 'elliptical-vortex'\nparameters = { strength = 1, strain = 0.05 }\n\
         initial = { a = 1.5, b = 0.5, angle = 0.3 }\n[integrator]\nstep = 0.1\nend = 20\n",
    ),
    (
        &[1, 2, 3, 4, 5, 6],
        &[6, 3],
        "[system]\nkind = 'rigid-body'\nparameters = { moments = [1, 1.5, 2, 2.5] }\n\
         initial = { L12 = 1, L13 = 0.2, L14 = -0.3, L23 = 0.5, L24 = 0.1, L34 = 0.7 }\n\
         [integrator]\nstep = 0.1\nend = -9\n",
    ),
    (
        &[1, 2, 3],
        &[3, 2, 4],
        "[system]\nkind = 'body-with-rotors'\nparameters = { I = [1, 2, 3], J = [0.1, 0.2] }\n\
         initial = { Pi = [0.3, 1, 0.2], l = [0.2, 0.1] }\n[integrator]\nstep = 0.05\nend = 3\n",
    ),
    // Five vectors, of which four have panels; seven quantities, of which six have curves.
    (
        &[1, 2, 3],
        &[3, 3, 3, 3, 6],
        "[system]\nalgebra = 'so(3)^6'\nhamiltonian = 'if(Pi1[1] < 2, sum(Pi[i]·Pi[i+1]), 0) + Pi1[3]'\n\
         initial = { Pi_1 = [1, 0, 0], Pi_2 = [0, 1, 0], Pi_3 = [0, 0.6, 0.8], Pi_4 = [1, 0, 0], \
         Pi_5 = [0, 1, 0], Pi_6 = [0, 0, 1] }\n[integrator]\nstep = 0.05\nend = 2\n",
    ),
];

/// The colours of the curves of a panel.
pub const COLOURS: [&str; 6] = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#555555"];

#[test]
fn panels_have_a_curve_for_each_coordinate_and_each_conserved_quantity() {
    let folder = Folder::new();
    for (columns, expected, text) in PANELS {
        let (svg, rows) = drawn(&folder, text, &[]);
        let fields = outlines(&svg);
        assert_eq!(fields.len(), expected.len(), "{text}");
        let curves = |colour: &str| lines(&svg, colour, 21);
        let counts: Vec<usize> = COLOURS.iter().map(|colour| curves(colour).len()).collect();
        let panels = |curve: usize| expected.iter().filter(|count| **count > curve).count();
        assert_eq!(counts, (0..6).map(panels).collect::<Vec<_>>(), "{text}");
        // The curves of the first panel, in the order of their colours.
        let values = || rows.iter().flat_map(|row| columns.iter().map(|column| row[*column]));
        let (low, high) =
            values().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
        let room = 0.05 * (high - low);
        let (field, end) = (&fields[0], rows.last().unwrap()[0]);
        for (column, colour) in columns.iter().zip(COLOURS) {
            let points = numbers_of(&curves(colour)[0]);
            let points = points.as_chunks::<2>().0;
            assert_eq!(points.len(), rows.len(), "{text}");
            for (row, [x, y]) in rows.iter().zip(points) {
                let along = (row[*column] - low + room) / (high - low + 2.0 * room);
                let at = [
                    field.left + field.width() * row[0] / end,
                    field.bottom - (field.bottom - field.top) * along,
                ];
                assert!((x - at[0]).abs() < 1.0 && (y - at[1]).abs() < 1.0, "{at:?} {x} {y}");
            }
        }
    }
}

/// The deviations are those of the method: ten decades apart for one that is exact and one that is not.
#[test]
fn deviations_from_the_start_are_drawn_on_a_logarithmic_scale() {
    let folder = Folder::new();
    let text = "integrator = { formulation = 'direct', scheme = 'rk4', step = 0.05, end = 20 }";
    let (svg, rows) = drawn(&folder, text, &[]);
    let field = outlines(&svg).pop().unwrap();
    // The columns h, f1 and f2, and K.
    let logarithm = |row: &Vec<f64>, column: usize| {
        let start = rows[0][column];
        ((row[column] - start) / start).abs().log10().max(-17.0)
    };
    let all: Vec<Vec<f64>> = (7..11)
        .map(|column| {
            let values: Vec<f64> = rows[1..].iter().map(|row| logarithm(row, column)).collect();
            // Three samples make a point, the largest of them.
            values.chunks(3).map(|part| part.iter().copied().fold(-17.0, f64::max)).collect()
        })
        .collect();
    let least = all.iter().flatten().copied().fold(0.0, f64::min).floor() - 0.3;
    let most = all.iter().flatten().copied().fold(-17.0, f64::max).ceil() + 0.3;
    for (values, colour) in all.iter().zip(COLOURS) {
        let curve = lines(&svg, colour, 21).pop().unwrap();
        let points = numbers_of(&curve);
        let points = points.as_chunks::<2>().0;
        assert_eq!(points.len(), values.len());
        for (value, [_, y]) in values.iter().zip(points) {
            let along = (value - least) / (most - least);
            let expected = field.bottom - (field.bottom - field.top) * along;
            assert!((y - expected).abs() < 1.0, "{value}: {y} {expected}");
        }
    }
}

#[test]
fn a_run_of_a_single_sample_is_drawn() {
    let folder = Folder::new();
    let (svg, rows) =
        drawn(&folder, "integrator = { step = 0.02, end = 0.02 }\noutput.every = 7\n", &[]);
    assert!(rows.len() <= 2 && !outlines(&svg).is_empty());
    // It shows the whole run, and no sample or plane of it.
    for option in ["--sample", "--plane"] {
        let run = folder.heavytop(&["plot", "a.npz", "--out", "other.svg", option, "0"]);
        assert!(run.code() == 2 && run.stderr().contains(" is for lattices"), "{}", run.stderr());
    }
}
