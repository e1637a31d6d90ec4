//! Bodies and satellites with reaction wheels, whose motors are `[torque] l`.

use crate::program::{Folder, numbers};

/// A motor with a table and one with a formula; the first one stops within a step.
const BODY: &str = "\
[system]
kind = 'reaction-wheels'
parameters = { I = [3, 2, 1.5], axes = [[0, 1, 0], [3, 0, 4]], J = [0.1, 0.05] }
initial = { Omega = [0.3, 0.5, -0.2], speeds = [0, 20] }

[inputs.motor]
times = [0, 3.33, 8]
values = [0.2, 0, 0]
interpolation = 'constant'

[torque]
l = ['motor', '0.1*sin(t)']

[integrator]
step = 0.1
end = 8
";

fn rows(folder: &Folder, configuration: &str) -> (String, Vec<String>, Vec<Vec<f64>>) {
    folder.write("a.toml", configuration);
    let run = folder.heavytop(&["simulate", "a.toml", "--out", "a.csv", "--force"]);
    assert_eq!(run.code(), 0, "{}", run.stderr());
    let (header, rows) = numbers(&folder.read("a.csv"));
    (run.stderr(), header, rows)
}

/// The wheels take up the impulses of their motors, and the momentum of the whole keeps its length.
#[test]
fn motors_move_momentum_and_keep_its_length() {
    let folder = Folder::new();
    let (told, header, moved) = rows(&folder, BODY);
    assert_eq!(header.join(","), "t,Pi1,Pi2,Pi3,l1,l2,h,c1,c2,c3", "{told}");
    let (first, last) = (&moved[0], moved.last().unwrap());
    // l = J (a·Ω + s) at the start.
    assert!((first[4] - 0.1 * 0.5).abs() < 1e-16);
    assert!((first[5] - 0.05 * (0.6 * 0.3 - 0.8 * 0.2 + 20.0)).abs() < 1e-15);
    assert!((last[4] - first[4] - 0.2 * 3.33).abs() < 1e-14, "{last:?}");
    assert!((last[5] - first[5] - 0.1 * (1.0 - 8.0_f64.cos())).abs() < 1e-13, "{last:?}");
    // c3 = |Π|², which is conserved by motors inside, and moves within the body.
    assert!(moved.iter().all(|row| (row[9] / first[9] - 1.0).abs() < 1e-13), "{last:?}");
    assert!((last[2] - first[2]).abs() > 0.1, "{last:?}");
    // Control: a torque from outside changes it.
    let outside = BODY.replace("[torque]\n", "[torque]\nPi = [0, 0.1, 0]\n");
    let (_, _, pushed) = rows(&folder, &outside);
    assert!((pushed.last().unwrap()[9] / first[9] - 1.0).abs() > 0.1);
}

/// A wheel about the normal of the orbit stops the swing of a boom: its motor is a spring and a brake for the pitch.
#[test]
fn a_wheel_stops_the_swing_of_a_satellite() {
    let folder = Folder::new();
    let satellite = |spring: &str, brake: &str| {
        format!(
            "[system]\nkind = 'satellite'\n\
             parameters = {{ I = [100, 120, 40], n = 0.001, axes = [0, 1, 0], J = 0.05, eccentricity = 0 }}\n\
             initial = {{ pitch = 0.1 }}\n[torque]\n\
             l = ['-{spring}*Gamma_1[1] + {brake}*((Pi2 - l1)/120 - 0.001)']\n\
             [integrator]\nstep = 20\nend = 4000\n"
        )
    };
    let pitch = |row: &Vec<f64>| (-row[4]).atan2(row[6]);
    let last = |text: &str| rows(&folder, text).2.pop().unwrap();
    // The pitch p has p″ = −(ω² + 9e-4/120) p − (0.6/120) p′: damped at the rate 0.0025/s.
    let stopped = last(&satellite("9e-4", "0.6"));
    assert!(pitch(&stopped).abs() < 1e-4, "{stopped:?}");
    let free = last(&satellite("0", "0"));
    assert!(pitch(&free).abs() > 1e-3, "{free:?}");
    // The wheel has what the body has lost, but for what the tide has taken.
    assert!((stopped[10] - free[10]).abs() > 1e-3, "{stopped:?} {free:?}");
}

#[test]
fn bad_tables_and_wheels_are_refused_before_anything_is_written() {
    let folder = Folder::new();
    for (from, to, part) in [
        ("[0, 3.33, 8]", "[0, 8, 3.33]", "motor"),
        ("[0, 3.33, 8]", "[0, 3.33, 7.5]", "from 0 to 7.5, and the run from 0 to 8"),
        ("[0.2, 0, 0]", "[0.2, 0]", "motor"),
        ("[0.2, 0, 0]", "[0.2, nan, 0]", "motor"),
        ("'motor', ", "'engine', ", "engine"),
        ("'motor', ", "", "torque l needs 2 formulas, one for each coordinate, and has 1"),
        ("[3, 0, 4]]", "[0, 0, 0]]", "axes must be of a length that is not 0"),
        ("[0.1, 0.05]", "[0.1, 0.05, 0.2]", "J must be a number for each of 2 axes, got 3"),
        ("[0.1, 0.05]", "[0.1, -0.05]", "J must be positive, got -0.05"),
        ("speeds = [0, 20]", "speeds = [0]", "speeds must be a number for each of 2 wheels, got 1"),
    ] {
        assert!(BODY.contains(from), "{from}");
        folder.write("a.toml", &BODY.replace(from, to));
        let run = folder.heavytop(&["simulate", "a.toml", "--out", "a.csv"]);
        assert!(run.code() == 2 && run.stderr().contains(part), "{to}: {}", run.stderr());
        assert!(!folder.path("a.csv").exists() && !folder.path("a.csv.partial").exists());
    }
}
