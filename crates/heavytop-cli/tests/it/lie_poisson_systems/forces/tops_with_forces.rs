//! Tops that are driven, damped, noisy or under a torque.

use crate::program::{Finished, Folder, numbers};

const TOP: &str = "\
[body]
inertia = [0.1, 0.15, 0.2]
weight_moment = 1
center_of_mass = [0, 0, 1]

[initial]
angular_momentum = [0.1, 0, 2]
inclination = '30 deg'

[integrator]
end = 2
step = 0.01
";

fn succeeded(done: &Finished) -> String {
    assert_eq!(done.code(), 0, "{}", done.stderr());
    done.stderr()
}

fn rows(folder: &Folder, configuration: &str) -> (String, Vec<String>, Vec<Vec<f64>>) {
    folder.write("a.toml", configuration);
    let told = succeeded(&folder.heavytop(&["simulate", "a.toml", "--out", "a.csv", "--force"]));
    let (header, rows) = numbers(&folder.read("a.csv"));
    (told, header, rows)
}

/// A torque that is 0 leaves the run of the top, in its principal axes and in others.
#[test]
fn without_a_torque_it_is_the_top() {
    let folder = Folder::new();
    let turned = TOP.replace("[0.1, 0.15, 0.2]", "[[0.12, 0.02, 0], [0.02, 0.15, 0], [0, 0, 0.2]]");
    for top in [TOP, &turned] {
        let top = format!("{top}[output]\nattitude = true\n");
        let (_, header, expected) = rows(&folder, &top);
        for table in [
            "[torque]\nPi = [0, 0, 0]\n",
            "[drive]\nPi = [0, 0, 0]\n",
            "[noise]\nstrength = 0\ninner_product = 1\n",
        ] {
            let (told, names, found) = rows(&folder, &format!("{top}{table}"));
            assert_eq!(names, header, "{told}");
            for (row, expected) in found.iter().zip(&expected) {
                let error =
                    row.iter().zip(expected).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
                // Different methods of order 8, and rounding.
                assert!(error < 1e-9, "{table} {row:?} {expected:?}");
            }
        }
    }
}

/// With a friction −c Π the vertical momentum Π·Γ falls as exp(−ct), and nothing makes Γ longer.
#[test]
fn friction_takes_the_vertical_momentum() {
    let folder = Folder::new();
    let (told, header, rows) =
        rows(&folder, &format!("{TOP}[torque]\nPi = ['-0.5*Pi1', '-0.5*Pi2', '-0.5*Pi3']\n"));
    assert_eq!(header.join(","), "t,Pi1,Pi2,Pi3,Gamma1,Gamma2,Gamma3,h,f1,f2");
    let (first, last) = (&rows[0], &rows[rows.len() - 1]);
    assert!((last[9] / first[9] - (-1.0_f64).exp()).abs() < 1e-12, "{told}");
    assert!(
        told.contains("by direct") && told.contains("deviations f1") && told.contains("keep, f2"),
        "{told}"
    );
}

/// Friction by a double bracket keeps Π·Γ, and lowers the energy.
#[test]
fn damping_keeps_the_casimirs_of_a_top() {
    let folder = Folder::new();
    let damping = "[damping]\nfriction = 0.3\ninner_product = [1, 1, 1, 0.5, 0.5, 0.5]\n";
    let (told, _, rows) = rows(&folder, &format!("{TOP}{damping}"));
    let (first, last) = (&rows[0], &rows[rows.len() - 1]);
    assert!((last[9] - first[9]).abs() < 1e-13 && (last[8] - first[8]).abs() < 1e-13, "{told}");
    assert!(rows.windows(2).all(|pair| pair[1][7] < pair[0][7]), "{told}");
}

/// The names of moments of inertia are there where the body is given in its principal axes.
#[test]
fn formulas_of_tops_have_the_moments_of_inertia() {
    let folder = Folder::new();
    let friction = "[torque]\nPi = ['-0.1*Pi1/I1', '-0.1*Pi2/I2', '-0.1*Pi3/I3']\n";
    let (_, _, rows) = rows(&folder, &format!("{TOP}{friction}"));
    // The power is −0.1 |Ω|².
    let (first, second) = (&rows[0], &rows[1]);
    let power = |row: &[f64]| {
        -0.1 * ((row[1] / 0.1).powi(2) + (row[2] / 0.15).powi(2) + (row[3] / 0.2).powi(2))
    };
    let mean = 0.5 * (power(first) + power(second)) * 0.01;
    assert!((second[7] - first[7] - mean).abs() < 1e-3 * mean.abs());
    folder.write(
        "b.toml",
        &format!(
            "{}{friction}",
            TOP.replace("[0.1, 0.15, 0.2]", "[[0.12, 0.02, 0], [0.02, 0.15, 0], [0, 0, 0.2]]")
        ),
    );
    let done = folder.heavytop(&["simulate", "b.toml", "--out", "b.csv"]);
    assert!(done.code() == 2 && done.stderr().contains("I1"), "{}", done.stderr());
}
