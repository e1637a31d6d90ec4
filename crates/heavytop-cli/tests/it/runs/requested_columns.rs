//! `[output] columns`: the quantities of a top in columns of their own, recomputed from the others.

use crate::program::{Folder, numbers};
use nalgebra::{Matrix3, Quaternion, Rotation3, UnitQuaternion, Vector3};

/// A top whose axes are not principal, from an attitude that is not the shortest one.
const TOP: &str = "[body]\ninertia = [[2.0, 0.3, 0.1], [0.3, 1.5, -0.2], [0.1, -0.2, 1.2]]\nmass = 2.0\n\
                   gravity = 9.81\nlength = 0.1\ncenter_of_mass = [0.6, 0.0, 0.8]\n[initial]\n\
                   angular_momentum = [1.0, -0.5, 2.0]\neuler_angles = [0.7, \"40 deg\", -1.1]\n[integrator]\n\
                   step = 0.01\nend = 1\n[output]\nevery = 20\n";

const ALL: &str =
    "columns = ['spatial-momentum', 'height', 'Omega', 'potential', 'euler-angles', 'kinetic']";

/// Runs the top with more keys of `[output]`, and returns the names and the rows of the table.
fn table(keys: &str) -> (Vec<String>, Vec<Vec<f64>>) {
    let folder = Folder::new();
    folder.write("a.toml", &format!("{TOP}{keys}\n"));
    let run = folder.heavytop(&["simulate", "a.toml", "--out", "a.csv", "--quiet"]);
    assert_eq!((run.code(), run.stderr()), (0, String::new()));
    numbers(&folder.read("a.csv"))
}

#[test]
fn every_quantity_follows_from_the_other_columns() {
    let (names, rows) = table(ALL);
    let place = |name: &str| names.iter().position(|other| other == name).unwrap();
    let vector = |row: &[f64], first: &str| Vector3::from_column_slice(&row[place(first)..][..3]);
    let inertia = Matrix3::new(2.0, 0.3, 0.1, 0.3, 1.5, -0.2, 0.1, -0.2, 1.2);
    assert_eq!(rows.len(), 6);
    for row in &rows {
        let number = |name| row[place(name)];
        let (pi, gamma) = (vector(row, "Pi1"), vector(row, "Gamma1"));
        let q = Quaternion::new(number("qw"), number("qx"), number("qy"), number("qz"));
        let attitude = UnitQuaternion::new_normalize(q);
        // Some roundings of numbers near 1; the principal axes are those of an eigenvalue iteration.
        let close = |found: Vector3<f64>, expected: Vector3<f64>| {
            assert!((found - expected).norm() < 1e-13, "{found} {expected}");
        };
        close(inertia * vector(row, "Omega1"), pi);
        close(vector(row, "spatial_momentum1"), attitude * pi);
        close(attitude.inverse() * Vector3::z(), gamma);
        let height = 0.1 * gamma.dot(&Vector3::new(0.6, 0.0, 0.8));
        assert!((number("height") - height).abs() < 1e-15);
        assert!((number("potential") - 2.0 * 9.81 * height).abs() < 1e-13);
        assert!((number("kinetic") + number("potential") - number("h")).abs() < 1e-13);
        // Goldstein's angles, by products of rotations about the axes.
        let turn = |axis, angle| Rotation3::from_axis_angle(&axis, angle);
        let rotation = turn(Vector3::z_axis(), number("phi"))
            * turn(Vector3::x_axis(), number("theta"))
            * turn(Vector3::z_axis(), number("psi"));
        for axis in [Vector3::x(), Vector3::y(), Vector3::z()] {
            close(rotation * axis, attitude * axis);
        }
    }
    // The run begins at the angles that were given, and moves.
    let angles = |row: &[f64]| vector(row, "phi");
    let given = Vector3::new(0.7, 40.0_f64.to_radians(), -1.1);
    assert!((angles(&rows[0]) - given).norm() < 1e-14, "{}", angles(&rows[0]));
    assert!((angles(&rows[5]) - given).norm() > 0.1);
    // The vertical part of the spatial momentum is conserved, and the others are not.
    let moved = vector(&rows[5], "spatial_momentum1") - vector(&rows[0], "spatial_momentum1");
    assert!(moved.z.abs() < 1e-13 && moved.xy().norm() > 1e-2, "{moved}");
}

#[test]
fn columns_stand_in_the_order_that_is_asked_for() {
    let (names, _) = table(ALL);
    let start = names.iter().position(|name| name == "qw").unwrap();
    let expected = "qw,qx,qy,qz,spatial_momentum1,spatial_momentum2,spatial_momentum3,height,Omega1,Omega2,Omega3,\
                    potential,phi,theta,psi,kinetic";
    assert_eq!(names[start..].join(","), expected);
    // Without an angle or a spatial vector there is no attitude.
    let (names, rows) = table("columns = ['kinetic', 'Omega']");
    assert!(names.ends_with(&["f2", "kinetic", "Omega1", "Omega2", "Omega3"].map(String::from)));
    // Nothing else changes.
    let (plain, own) = table("");
    assert_eq!(names[..plain.len()], plain);
    assert!(rows.iter().zip(&own).all(|(row, own)| row[..own.len()] == own[..]));
}

/// The other formats have the same numbers, and a table with such columns is one of the program.
#[test]
fn every_format_has_the_columns() {
    let folder = Folder::new();
    folder.write("a.toml", &format!("{TOP}{ALL}\n"));
    for name in ["a.csv", "a.npz", "a.parquet", "a.csv", "a.npz"] {
        let run = folder.heavytop(&["simulate", "a.toml", "--out", name, "--quiet"]);
        assert_eq!((run.code(), run.stderr()), (0, String::new()), "{name}");
    }
    let archive = std::fs::read(folder.path("a.npz")).unwrap();
    for name in ["euler_angles.npy", "spatial_momentum.npy", "Omega.npy", "height.npy"] {
        assert!(archive.windows(name.len()).any(|part| part == name.as_bytes()), "{name}");
    }
    let parquet =
        String::from_utf8_lossy(&std::fs::read(folder.path("a.parquet")).unwrap()).into_owned();
    assert!(parquet.contains("spatial_momentum3") && parquet.contains("theta"));
    // A dry run counts them: 10 columns, 4 of the attitude and 12 more, for 6 rows.
    let run = folder.heavytop(&["simulate", "a.toml", "--out", "b.npz", "--dry-run", "--json"]);
    let bytes = 8 * 6 * (10 + 4 + 12);
    assert!(run.stdout().contains(&format!("\"bytes\": {bytes},")), "{}", run.stdout());
}
