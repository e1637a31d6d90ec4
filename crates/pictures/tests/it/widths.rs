//! Widths of texts, against the tables of the font and the layout of another library.

use svg_pictures::width;

/// The advances of DejaVu Sans, of 2048 units: digits 1303, A and V 1401.
#[test]
fn widths_are_those_of_the_font() {
    assert!((width("0123456789").unwrap() - 13030.0 / 2048.0).abs() < 1e-12);
    let [apart, pair] = [width("A").unwrap() + width("V").unwrap(), width("AV").unwrap()];
    assert!((apart - 2.0 * 1401.0 / 2048.0).abs() < 1e-12);
    // Kerning, of −131 units.
    assert!((apart - pair - 131.0 / 2048.0).abs() < 1e-12, "{}", (apart - pair) * 2048.0);
    assert!(width("⁻⁴").unwrap() < width("−4").unwrap());
    assert_eq!(width("").unwrap(), 0.0);
}

/// The glyphs of ff and ffi are narrower than their letters side by side, 1411 and 1980 units for 1442 and 2011.
#[test]
fn letters_join_to_ligatures() {
    assert!((width("ff").unwrap() - 1411.0 / 2048.0).abs() < 1e-12);
    assert!((width("ffi").unwrap() - 1980.0 / 2048.0).abs() < 1e-12);
    // Not across a change of the style.
    let apart = width("f<tspan font-style='italic'>f</tspan>").unwrap();
    assert!((apart - 1442.0 / 2048.0).abs() < 1e-12);
}

/// Widths that usvg 0.49 gave with harfrust 0.12 and skrifa 0.44.
#[test]
fn widths_are_those_of_another_library() {
    for (text, expected) in [
        ("<tspan font-style='italic'>h</tspan> (J)", 2.0268555),
        ("<tspan font-style='italic'>f</tspan>₂ (kg m²/s)", 5.6157227),
        ("10⁻²⁰ (kg m²/s)⁴", 7.8657227),
        ("MEGNO, log₁₀", 6.7666016),
        ("computing time per simulated time", 17.733398),
        ("difference of fluid flow off Yes, To Va LT", 19.297852),
        ("Π·Γ = 0.5 kg m²/s", 8.7734375),
        ("reduced, gauss-8, step 0.1545 s", 16.083496),
        ("|δΠ| / max |Π|", 6.932617),
    ] {
        let width = width(text).unwrap();
        assert!((width - expected).abs() < 1e-5, "{text}: {width}, not {expected}");
    }
}

#[test]
fn spaces_in_a_row_are_one_and_those_at_the_ends_are_none() {
    let words = width("two words").unwrap();
    assert_eq!(width("\n  two \t\n words\n").unwrap(), words);
    assert_eq!(width("two <tspan font-style='normal'> words</tspan> ").unwrap(), words);
    assert!(width("twowords").unwrap() < words);
    let kept = crate::place("<text xml:space='preserve' font-size='1'>  two  words</text>");
    assert!(kept[2] - kept[0] > words + 0.9, "{kept:?}");
}

#[test]
fn escaped_characters_are_one_each() {
    let less = width("<tspan>&lt;</tspan>").unwrap();
    assert_eq!(width("&lt;").unwrap(), less);
    assert_eq!(width("&#x3c;<![CDATA[<]]>").unwrap(), 2.0 * less);
    assert_eq!(width("a<!-- not drawn -->a").unwrap(), width("aa").unwrap());
}
