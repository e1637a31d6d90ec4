//! Drawings of any content: an outcome, and never a panic.

use crate::drawing;
use proptest::prelude::*;
use svg_pictures::{Picture, boxes, outlined, width};

fn number() -> impl Strategy<Value = String> {
    prop_oneof![
        any::<f64>().prop_map(|number| number.to_string()),
        (-99..99_i32).prop_map(|number| number.to_string()),
        "[-+0-9.eEmxp%]{0,6}",
    ]
}

proptest! {
    #[test]
    fn any_characters_have_an_outcome(text in "\\PC*") {
        let _ = (outlined(&text), boxes(&text), width(&text), Picture::new(&text));
        let escaped = text.replace('&', "&amp;").replace('<', "&lt;").replace(']', "&#93;");
        prop_assert!(width(&escaped)? >= 0.0);
        let drawing = drawing(&format!("<text>{escaped}</text>"));
        prop_assert!(outlined(&drawing).is_ok());
    }

    #[test]
    fn any_attributes_have_an_outcome(
        values in proptest::array::uniform5(number()),
        transform in "(rotate|scale|matrix|skewX)\\([-0-9e., ]{0,9}\\)",
    ) {
        let [x, y, dx, dy, size] = values;
        let drawing = drawing(&format!(
            "<text x='{x}' y='{y}' dx='{dx}' dy='{dy}' font-size='{size}' transform='{transform}'>\
             a<tspan font-style='italic'>b</tspan></text>"
        ));
        if let Ok(found) = boxes(&drawing) {
            for place in found {
                let sides = [place.left, place.top, place.right, place.bottom];
                prop_assert!(sides.iter().all(|side| side.abs() <= 1e9));
                prop_assert!(place.left <= place.right && place.top <= place.bottom);
            }
        }
        if let Ok(picture) = Picture::new(&drawing) {
            prop_assert!(picture.png(0.1).is_ok());
        }
    }
}
