//! The table of vortices that the example `many_vortices` reads: both headers, and what is wrong by line and value.

#[path = "../../../examples/many_vortices/vortex_table.rs"]
mod table;

use lie_poisson_systems::nalgebra::Vector3;
use std::path::Path;
use table::VortexTable;

#[test]
fn both_headers_give_the_same_vortices() {
    let by_angles = "strength,latitude,longitude\n1,0,90\n\n-2.5,90,17\n";
    let by_places = " Strength , x, y, z\n1, 0, 1, 0\n-2.5, 0, 0, 0.9995\n";
    for text in [by_angles, by_places] {
        let table = VortexTable::from_text(text).unwrap();
        assert_eq!(table.strengths, [1.0, -2.5]);
        for (found, expected) in table.positions.iter().zip([Vector3::y(), Vector3::z()]) {
            assert!((found - expected).norm() < 1e-15, "{found}");
        }
    }
}

#[test]
fn the_table_of_the_example_is_a_ring() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/many_vortices");
    let table = VortexTable::read(&folder.join("six_on_a_parallel.csv")).unwrap();
    assert_eq!(table.strengths, [1.0; 6]);
    assert!(table.positions.iter().sum::<Vector3<f64>>().xy().norm() < 1e-15);
    let missing = VortexTable::read(&folder.join("missing.csv")).unwrap_err().to_string();
    assert!(missing.contains("missing.csv"), "{missing}");
}

#[test]
fn errors_name_the_line_and_the_value() {
    let after_header = |line: &str| format!("strength,x,y,z\n1,1,0,0\n{line}\n");
    let angles = |line: &str| format!("strength,latitude,longitude\n1,1,0\n\n{line}\n");
    for (text, parts) in [
        (String::new(), &["empty"][..]),
        ("k,x,y,z\n1,1,0,0\n".into(), &["line 1", "'k,x,y,z'", "strength,latitude"]),
        (after_header("1,0,up,1"), &["line 3", "y: 'up'"]),
        (after_header("1,0,1"), &["line 3", "3 values", "4"]),
        (after_header("NaN,0,1,0"), &["line 3", "strength: 'NaN'"]),
        (after_header("0,0,1,0"), &["line 3", "strength: '0' is zero"]),
        (after_header("1,0,2,0"), &["line 3", "centre is 2"]),
        (after_header("1,0,0,0"), &["line 3", "centre is 0"]),
        (after_header("2,1,0,0"), &["line 3", "same place as in line 2"]),
        (angles("1,91,0"), &["line 4", "latitude: '91'"]),
        (angles("1,0,inf"), &["line 4", "longitude: 'inf'"]),
        ("strength,x,y,z\n1,1,0,0\n".into(), &["two are needed, and 1 given"]),
    ] {
        let message = VortexTable::from_text(&text).unwrap_err();
        for part in parts {
            assert!(message.contains(part), "{message} does not contain {part}");
        }
    }
}
