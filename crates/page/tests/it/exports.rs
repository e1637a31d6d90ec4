//! The functions that JavaScript calls. Each test has a thread, and so a top, of its own.

use heavytop_page::exports::actions::{
    advance, begin_orbit, change_friction, change_method, change_section, change_step,
    measure_anew, throw_top,
};
use heavytop_page::exports::numbers::{columns, section_points, time};
use heavytop_page::exports::texts::{describe_invariants, describe_methods, text_length};

#[test]
fn nothing_works_before_a_throw_and_nothing_panics() {
    let refused = [
        advance(1.0, 10),
        begin_orbit(0.0, 0.0),
        change_method(0, 0.0),
        change_friction(0.1, 0.0),
        change_section(0),
        change_step(0.1),
        measure_anew(),
        // All moments are 0.
        throw_top(0, 0.1),
        throw_top(0, f64::NAN),
    ];
    assert_eq!(refused, [1; 9]);
    assert!(text_length() > 0);
    assert!(columns().is_null() && section_points().is_null());
    assert_eq!(time(), 0.0);
    describe_invariants();
    assert_eq!(text_length(), 0);
    describe_methods();
    assert!(text_length() > 80);
}
