//! Errors of drawings.

use super::refused;
use svg_pictures::{Picture, outlined};

/// Returns a drawing with this in it.
fn drawing(content: &str) -> String {
    format!("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"9\" height=\"9\">{content}</svg>")
}

/// Returns the errors of drawings, of their texts and of their pixels.
pub fn errors() -> Vec<String> {
    let picture = Picture::new(&drawing("")).unwrap();
    vec![
        refused(outlined("<svg>")),
        refused(Picture::new("<a/>")),
        refused(outlined(&drawing("<text x='1 2'>a</text>"))),
        refused(outlined(&drawing("<text rotate='9'>a</text>"))),
        refused(outlined(&drawing("<text><a>a</a></text>"))),
        refused(outlined(&drawing("<text x='1e10'>a</text>"))),
        refused(picture.png(f32::NAN)),
    ]
}
