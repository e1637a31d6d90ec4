//! Pictures as files.

use crate::drawing;
use resvg::tiny_skia::Pixmap;
use svg_pictures::{Picture, PictureError};

/// A PNG of 2 × 2 cells: red and green above blue and white.
const CELLS: &str = "iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAIAAAD91JpzAAAAEklEQVR4nGP4z8DAAMIM/4EAAB/u\
    BfsL2WiLAAAAAElFTkSuQmCC";

fn pixels(content: &str, scale: f32) -> Result<Pixmap, PictureError> {
    let png = Picture::new(&drawing(content))?.png(scale)?;
    Ok(Pixmap::decode_png(&png).unwrap())
}

/// Returns red, green, blue and opacity at a place.
fn colour(pixels: &Pixmap, x: u32, y: u32) -> [u8; 4] {
    let colour = pixels.pixel(x, y).unwrap().demultiply();
    [colour.red(), colour.green(), colour.blue(), colour.alpha()]
}

/// The letter l is a rectangle, from 193 to 377 of 2048 units.
#[test]
fn letters_are_drawn_in_their_colour() {
    let text = "<text x='100' y='250' font-size='204.8' fill='#f00'>l</text>";
    for scale in [1.0, 2.0] {
        let pixels = pixels(text, scale).unwrap();
        assert_eq!(
            (pixels.width(), pixels.height()),
            ((900.0 * scale) as u32, (300.0 * scale) as u32)
        );
        let at = |x: f32| colour(&pixels, (x * scale) as u32, (200.0 * scale) as u32);
        assert_eq!(at(128.0), [255, 0, 0, 255]);
        assert_eq!([at(117.0), at(140.0)], [[0; 4]; 2]);
    }
}

#[test]
fn an_svg_has_no_text_and_looks_the_same() {
    let text = "<text x='100' y='250' font-size='80' fill='#060'>a &lt; b</text>";
    let picture = Picture::new(&drawing(text)).unwrap();
    let svg = picture.svg();
    assert!(svg.starts_with("<svg ") && !svg.contains("<text") && !svg.contains("font"), "{svg}");
    let again = Picture::new(&svg).unwrap();
    let [one, other] = [picture, again]
        .map(|picture| Pixmap::decode_png(&picture.png(1.0).unwrap()).unwrap().data().to_vec());
    // Paths are rounded to two decimals, which may move an edge across two of the sixteen samples of a pixel.
    let largest = one.iter().zip(&other).map(|(a, b)| a.abs_diff(*b)).max();
    assert!(largest <= Some(2 * 16), "{largest:?}");
}

fn image(attributes: &str) -> String {
    format!(
        "<image x='100' y='50' width='400' height='200' preserveAspectRatio='none' {attributes} \
         image-rendering='optimizeSpeed' href='data:image/png;base64,{CELLS}'/>"
    )
}

#[test]
fn cells_are_drawn_between_what_is_before_and_after() {
    let content = format!(
        "<rect width='900' height='300' fill='#ccc'/><g transform='translate(10 0)'>{}</g>\
         <rect x='200' y='0' width='20' height='300' fill='#000'/>",
        image("")
    );
    let pixels = pixels(&content, 1.0).unwrap();
    let colours = [
        ((109, 100), [204, 204, 204, 255]),
        ((111, 51), [255, 0, 0, 255]),
        ((309, 149), [255, 0, 0, 255]),
        ((311, 149), [0, 255, 0, 255]),
        ((309, 151), [0, 0, 255, 255]),
        ((311, 249), [255, 255, 255, 255]),
        ((210, 100), [0, 0, 0, 255]),
        ((511, 100), [204, 204, 204, 255]),
    ];
    for ((x, y), expected) in colours {
        assert_eq!(colour(&pixels, x, y), expected, "{x} {y}");
    }
    let svg = Picture::new(&drawing(&content)).unwrap().svg();
    assert!(svg.contains("<image") && svg.contains("data:image/png;base64,"), "{svg}");
}

/// What is drawn beside an image is drawn as without it.
#[test]
fn an_image_does_not_move_the_rest() {
    // Lines along the axes alone and in groups, one of them with the image: they have no area.
    let rest = "<g transform='translate(3.3 1.7)'><path d='M5 5L800 33.3' stroke='#333'/></g>\
                <path d='M540.2 50.5H890' stroke='#a00' stroke-width='3' stroke-dasharray='9 4'/>\
                <g transform='rotate(90 700 60)'><path d='M700 60H800' stroke='#0a0'/>{}</g>\
                <text x='600.4' y='170.3' font-size='33'>0.25</text>";
    let alone = pixels(&rest.replace("{}", ""), 1.7).unwrap();
    let small = image("transform='scale(0.1)'");
    let beside = pixels(&format!("{}{}", image(""), rest.replace("{}", &small)), 1.7).unwrap();
    let mut largest = 0;
    let drawn = alone.data().iter().filter(|byte| **byte != 0).count();
    assert!(drawn > 10_000, "{drawn}");
    for (x, y) in (900..1530).flat_map(|x| (0..510).map(move |y| (x, y))) {
        let pairs = colour(&alone, x, y).into_iter().zip(colour(&beside, x, y));
        largest = largest.max(pairs.map(|(a, b)| a.abs_diff(b)).max().unwrap_or(0));
    }
    assert!(largest <= 2, "{largest}");
}

#[test]
fn images_that_cannot_be_drawn_are_errors() {
    let cut = image("").replace(CELLS, &CELLS[..60]);
    let jpeg = image("").replace("image/png", "image/jpeg");
    for content in [format!("<g opacity='0.5'>{}</g>", image("")), cut, jpeg] {
        let outcome = pixels(&content, 1.0);
        assert!(matches!(outcome, Err(PictureError::Svg { .. })), "{content}");
    }
    assert!(pixels(&image("visibility='hidden'"), 1.0).unwrap().data().iter().all(|b| *b == 0));
}
