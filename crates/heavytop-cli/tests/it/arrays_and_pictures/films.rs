//! Films of runs: their frames, their times, and the colours, which are the same in all frames.

use crate::program::{Finished, Folder, numbers};
use gif::{ColorOutput, DecodeOptions};
use heavytop_cli::Error;
use heavytop_cli::commands::plot::{PlotOptions, plot};
use heavytop_cli::supervision::Watch;
use std::collections::BTreeSet;
use std::sync::atomic::AtomicBool;

fn succeeded(done: &Finished) {
    assert_eq!(done.code(), 0, "{}", done.stderr());
}

const VORTICES: &str = "[system]\nkind = 'vortices'\nparameters = { strengths = [1, -0.7] }\n\
    initial = { positions = [[0, 1, 0], [-0.6, 0, 0.8]] }\n[integrator]\nstep = 0.1\nend = 3\n";

/// A lattice whose spins turn about the field, from almost upright to lying.
const SPINS: &str = "[system]\nkind = 'spin-lattice'\nparameters = { shape = [2, 3], field = [1, 0, 0] }\n\
    initial = { direction = [0, 0, 1], tilt = 0.3, seed = 1 }\n[integrator]\nstep = 0.1\nend = 1.5\n";

const FLUID: &str = "[system]\nkind = 'sphere-fluid'\nparameters = { size = 4 }\n\
    initial = { degrees = [1, 3] }\n[integrator]\nstep = 0.1\nend = 0.3\n";

/// The frames of a film: their delays, and the red, green and blue of their pixels, and the size of all.
struct Decoded {
    size: [usize; 2],
    delays: Vec<u16>,
    frames: Vec<Vec<[u8; 3]>>,
}

fn decoded(folder: &Folder, name: &str) -> Decoded {
    let mut options = DecodeOptions::new();
    options.set_color_output(ColorOutput::RGBA);
    let file = std::fs::File::open(folder.path(name)).unwrap();
    let mut decoder = options.read_info(std::io::BufReader::new(file)).unwrap();
    let size = [decoder.width(), decoder.height()].map(usize::from);
    let (mut delays, mut frames) = (Vec::new(), Vec::new());
    while let Some(frame) = decoder.read_next_frame().unwrap() {
        assert_eq!([frame.width, frame.height].map(usize::from), size);
        assert_eq!((frame.left, frame.top), (0, 0));
        delays.push(frame.delay);
        // What is transparent stays as it was; of the first frame nothing is.
        let before: Option<&Vec<[u8; 3]>> = frames.last();
        let pixels = frame.buffer.as_chunks::<4>().0.iter().enumerate();
        let pixels = pixels.map(|(place, &[red, green, blue, opacity])| match opacity {
            0 => before.unwrap()[place],
            _ => [red, green, blue],
        });
        let pixels = pixels.collect();
        frames.push(pixels);
    }
    Decoded { size, delays, frames }
}

fn simulated(folder: &Folder, text: &str) {
    folder.write("a.toml", text);
    succeeded(&folder.heavytop(&["simulate", "a.toml", "--out", "a.npz", "--force"]));
}

#[test]
#[ignore = "long"]
fn a_film_has_a_frame_for_every_n_th_sample() {
    let folder = Folder::new();
    for (text, samples) in [(VORTICES, 31), (SPINS, 16), (FLUID, 4)] {
        simulated(&folder, text);
        for (more, every, delay) in [
            (&[][..], 1, 5),
            (&["--every", "7", "--fps", "50"], 7, 2),
            (&["--fps", "3", "--every", "15"], 15, 33),
        ] {
            if text != VORTICES && more.len() < 4 {
                continue;
            }
            // A film of the program is replaced.
            let done = folder.heavytop(&[&["plot", "a.npz", "--out", "a.gif"], more].concat());
            succeeded(&done);
            let film = decoded(&folder, "a.gif");
            let frames = (samples - 1) / every + 1;
            assert_eq!(film.delays, vec![delay; frames]);
            let expected =
                if frames == 1 { "1 frame ".into() } else { format!("{frames} frames ") };
            assert!(done.stdout().starts_with(&expected), "{}", done.stdout());
            // All frames differ, as the times in their captions do.
            assert_eq!(film.frames.iter().collect::<BTreeSet<_>>().len(), frames);
        }
        let file = std::fs::read(folder.path("a.gif")).unwrap();
        let comment = b"\x21\xfe\x12Software: heavytop\x00";
        assert!(file.windows(comment.len()).any(|window| window == comment));
        assert_eq!(folder.names(), ["a.gif", "a.npz", "a.toml"]);
    }
    // The first frame has the size of a picture, in pixels of two thirds.
    succeeded(&folder.heavytop(&["plot", "a.npz", "--out", "a.svg"]));
    let svg = folder.read("a.svg");
    let of = |key: &str| -> f64 {
        let value = svg.split_once(&format!("{key}=\"")).unwrap().1.split_once('"').unwrap().0;
        value.parse().unwrap()
    };
    let size = [of("width"), of("height")].map(|x| 2 * x.ceil() as usize);
    assert_eq!(decoded(&folder, "a.gif").size, size);
    let done = folder.heavytop(&["plot", "a.npz", "--out", "b.gif", "--every", "2", "--json"]);
    succeeded(&done);
    assert!(done.stdout().contains("\"frames\": 2"), "{}", done.stdout());
}

/// Returns the first and the last place of each run of more than ten coloured pixels in a row or a column.
fn coloured(pixels: impl Iterator<Item = [u8; 3]>) -> Vec<[f64; 2]> {
    let (mut runs, mut begin) = (Vec::new(), None);
    for (place, pixel) in pixels.chain([[255; 3]]).enumerate() {
        let is_gray = pixel[0] == pixel[1] && pixel[1] == pixel[2];
        begin = match begin {
            None if !is_gray => Some(place),
            Some(begin) if is_gray && place > begin + 10 => {
                runs.push([begin as f64, place as f64 - 1.0]);
                None
            }
            begin => begin.filter(|_| !is_gray),
        };
    }
    runs
}

/// A cell has the colour of its spin on the scale of all frames, and the bar of colours is the same in all of them.
#[test]
fn the_scale_of_colours_is_that_of_all_frames() {
    let folder = Folder::new();
    simulated(&folder, SPINS);
    succeeded(&folder.heavytop(&["simulate", "a.toml", "--out", "a.csv"]));
    let (_, rows) = numbers(&folder.read("a.csv"));
    succeeded(&folder.heavytop(&["plot", "a.npz", "--out", "a.gif"]));
    let film = decoded(&folder, "a.gif");
    let [width, height] = film.size;
    let pixel = |frame: &[[u8; 3]], x: f64, y: f64| frame[y as usize * width + x as usize];
    let first = &film.frames[0];
    let across = coloured((0..width).map(|x| first[height / 8 * width + x]));
    let [[left, right], [from, to]] = across[..] else { panic!("{across:?}") };
    let centre = (from + to) / 2.0;
    let down = coloured((0..height).map(|y| first[y * width + centre as usize]));
    let [[top, bottom]] = down[..] else { panic!("{down:?}") };

    let third = |row: &[f64], x: usize, y: usize| row[1 + 3 * (3 * x + y) + 2];
    let all = || rows.iter().flat_map(|row| (0..6).map(|i| third(row, i / 3, i % 3)));
    let (least, most) =
        all().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
    for (row, frame) in rows.iter().zip(&film.frames) {
        for (x, y) in (0..6).map(|i| (i / 3, i % 3)) {
            // In a corner of the cell, beside the arrow.
            let at = [
                left + (right - left) * (x as f64 + 0.06) / 2.0,
                bottom - (bottom - top) * (y as f64 + 0.06) / 3.0,
            ];
            let along = (third(row, x, y) - least) / (most - least);
            // The ends of the bar are under its edge.
            let on_bar = bottom - (bottom - top) * along.clamp(0.01, 0.99);
            let (cell, scale) = (pixel(frame, at[0], at[1]), pixel(frame, centre, on_bar));
            let far = cell.iter().zip(scale).map(|(a, b)| a.abs_diff(b)).max().unwrap();
            assert!(far <= 10, "{x} {y} {along} {cell:?} {scale:?}");
        }
        for y in 0..height {
            assert_eq!(pixel(frame, centre, y as f64), pixel(first, centre, y as f64));
        }
    }
    // Control: the scales of the first and of the last sample alone are others.
    let ends = |skip: usize| {
        let own: Vec<f64> = all().skip(skip).take(6).collect();
        own.into_iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)))
    };
    assert!(ends(0).0 > least + 0.5 && ends(6 * (rows.len() - 1)).1 < most - 0.5);
}

#[test]
fn what_is_no_film_is_refused_before_anything_is_written() {
    let folder = Folder::new();
    folder.write("top.toml", "integrator.end = 0.1\n");
    succeeded(&folder.heavytop(&["simulate", "top.toml", "--out", "top.npz"]));
    simulated(&folder, VORTICES);
    folder.write("foreign.gif", "GIF89a of another program");
    folder.write("other.gif", "no picture");
    let before = folder.names();
    for (arguments, said) in [
        (&["top.npz", "--out", "b.gif"][..], "its name must end in .png or .svg"),
        (&["a.npz", "--out", "b.gif", "--sample", "3"], "--sample is for pictures of one time"),
        (&["a.npz", "--out", "b.png", "--every", "3"], "--every is for films"),
        (&["a.npz", "--out", "b.svg", "--fps", "3"], "--fps is for films"),
        (&["a.npz", "--out", "b.gif", "--every", "0"], "every must be at least 1, got 0"),
        (&["a.npz", "--out", "b.gif", "--fps", "0"], "fps must be from 1 to 50, got 0"),
        (&["a.npz", "--out", "b.gif", "--fps", "51"], "fps must be from 1 to 50, got 51"),
        (&["a.npz", "--out", "foreign.gif"], "exists, and is not overwritten"),
        (&["a.npz", "--out", "other.gif"], "it is no picture of heavytop"),
        (&["a.npz", "--out", "missing/b.gif"], "cannot create"),
    ] {
        let done = folder.heavytop(&[&["plot"], arguments].concat());
        assert_eq!(done.code(), 2, "{}", done.stderr());
        assert!(done.stderr().contains(said), "{said}: {}", done.stderr());
    }
    assert_eq!(folder.names(), before);
    assert_eq!(folder.read("foreign.gif"), "GIF89a of another program");
}

/// Ctrl-C ends a film and leaves nothing of it, and an older film as it was.
#[test]
fn an_interrupted_film_leaves_no_file() {
    let folder = Folder::new();
    simulated(&folder, VORTICES);
    let stop = AtomicBool::new(true);
    let watch = Watch { stop: Some(&stop), ..Watch::default() };
    let film =
        || plot(&folder.path("a.npz"), &folder.path("a.gif"), &PlotOptions::default(), &watch);
    let before = folder.names();
    assert!(matches!(film(), Err(Error::Interrupted { .. })));
    assert_eq!(folder.names(), before);
    succeeded(&folder.heavytop(&["plot", "a.npz", "--out", "a.gif", "--every", "30"]));
    let old = std::fs::read(folder.path("a.gif")).unwrap();
    assert!(film().is_err());
    assert_eq!(std::fs::read(folder.path("a.gif")).unwrap(), old);
}
