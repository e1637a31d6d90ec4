//! Lattices of spins with `[drive]` and `[inputs]`.

use crate::program::{Folder, numbers};

/// A ring in a constant field along e₃ and a small one that turns at the rate of the spins.
const RING: &str = "\
[system]
kind = 'spin-lattice'
parameters = { shape = [4], exchange = 1, field = [0, 0, 2] }
initial.direction = [0, 0, 1]

[drive]
field = ['0.3*cos(2*t)', '-0.3*sin(2*t)', 0]

[integrator]
step = 0.01
end = 10

[output]
every = 100
";

/// A table that turns the spins by a half, about e₁.
const PULSE: &str = "\
[system]
kind = 'spin-lattice'
parameters = { shape = [2, 2], exchange = 1 }
initial.direction = [0, 0, 1]

[inputs.u]
times = [0, 0.97, 1.03, 2]
values = [0, 1.5707963267948966, 0, 0]
interpolation = 'linear'

[drive]
field = ['u*2', 0, 0]

[integrator]
step = 0.05
end = 2
";

fn run(folder: &Folder, text: &str) -> (String, Vec<Vec<f64>>) {
    folder.write("a.toml", text);
    let done = folder.heavytop(&["simulate", "a.toml", "--out", "a.csv", "--force"]);
    assert_eq!(done.code(), 0, "{}", done.stderr());
    (done.stderr(), numbers(&folder.read("a.csv")).1)
}

/// Rabi's resonance: s₃ = cos(0.3 t), of spins of which all are one, so that their exchange does nothing.
#[test]
fn a_small_field_that_turns_with_the_spins_turns_them_over() {
    let folder = Folder::new();
    let (told, rows) = run(&folder, RING);
    for part in
        ["largest deviations C ", "what the motion does not keep, ", "direct, implicit-midpoint"]
    {
        assert!(told.contains(part), "{told}: {part}");
    }
    assert!(!told.contains("noise"), "{told}");
    for row in &rows {
        // The method has the order 2: the small field turns by 0.3 · 10 · (2 · 0.01)²/24 too little, and the large one, too.
        assert!((row[3] - (0.3 * row[0]).cos()).abs() < 1e-3, "{row:?}");
        // h has the field of its time: that one turns with the spins, which stay at a right angle to it.
        let h = -4.0 - 8.0 * row[3];
        assert!((row[13] - h).abs() < 0.02, "{row:?} {h}");
        assert!((row[17] - 4.0).abs() < 1e-12);
    }
    // Control: a field that turns the other way does next to nothing.
    let (_, other) = run(&folder, &RING.replace("'-0.3*sin", "'0.3*sin"));
    assert!(other.iter().all(|row| row[3] > 0.95));
    // The other outputs, the check, and a picture.
    let options = ["simulate", "a.toml", "--set", "integrator.end=2"];
    for more in [
        &["--out", "a.npz", "--check"][..],
        &["--out", "b.parquet"],
        &["--out", "c.csv", "--dry-run"],
    ] {
        let done = folder.heavytop(&[&options[..], more].concat());
        assert_eq!(done.code(), 0, "{}", done.stderr());
    }
    assert_eq!(folder.heavytop(&["plot", "a.npz", "--out", "a.svg"]).code(), 0);
    assert!(folder.read("a.svg").contains("driven"));
}

/// Tables may stand in files, and steps end at their times, so that the angle is the area of the table but for the order.
#[test]
fn a_table_turns_spins_by_its_area() {
    let folder = Folder::new();
    let (_, rows) = run(&folder, PULSE);
    // ∫u = (0.97 + 0.06)/2 · π/2.
    let angle = 2.0 * 0.515 * core::f64::consts::FRAC_PI_2;
    let end = rows.last().unwrap();
    assert!((end[3] - angle.cos()).abs() < 2e-3 && (end[2] - angle.sin()).abs() < 2e-3, "{end:?}");
    folder.write("u.csv", "t,u\n0,0\n0.97,1.5707963267948966\n1.03,0\n2,0\n");
    let file = PULSE.replace("times = [0, 0.97, 1.03, 2]\n", "file = 'u.csv'\n");
    let file = file.replace("values = [0, 1.5707963267948966, 0, 0]\n", "");
    assert_eq!(run(&folder, &file).1, rows);
    // Backward, and with friction and noise.
    let back =
        PULSE.replace("end = 2", "end = -1").replace("[0, 0.97, 1.03, 2]", "[-2, -0.97, -0.4, 1]");
    assert!((run(&folder, &back).1.last().unwrap()[3] - 1.0).abs() > 0.1);
    let warm =
        format!("{PULSE}[damping]\nfriction = 0.5\nform = 'gilbert'\n[noise]\ntemperature = 0.1\n");
    let (told, rows) = run(&folder, &warm);
    assert!(told.contains("noise of seed 1, path 0"), "{told}");
    assert!((rows.last().unwrap()[17] - 4.0).abs() < 1e-12);
    let done = folder.heavytop(&["ensemble", "a.toml", "--paths", "3", "--out", "m.csv"]);
    assert_eq!(done.code(), 0, "{}", done.stderr());
}

#[test]
fn what_is_no_drive_of_a_lattice_is_refused_before_anything_is_written() {
    let folder = Folder::new();
    for (old, new, parts) in [
        ("end = 2", "end = 3", &["the input u", "from 0 to 2", "from 0 to 3"][..]),
        ("1.03, 2]", "0.97, 2]", &["must increase", "time 3 is 0.97, after 0.97"]),
        ("values = [0,", "values = [nan,", &["value 1", "NaN"]),
        ("values = [0,", "values = [0, 0,", &["4 times and 5 values"]),
        ("interpolation = 'linear'\n", "", &["interpolation"]),
        ("[inputs.u]", "[inputs.t]", &["is that of the time"]),
        ("['u*2', 0, 0]", "['u*2', 0]", &["needs 3 formulas", "has 2", "field = "]),
        ("['u*2', 0, 0]", "'u'", &["needs 3 formulas", "has 1"]),
        ("['u*2', 0, 0]", "['u*2', 'S_1', 0]", &["drive field2", "S_1", "^"]),
        ("field = ['u*2', 0, 0]", "", &["field is missing in [drive]"]),
        ("[drive]\nfield = ['u*2', 0, 0]\n", "", &["no formula names the input u", "[inputs.u]"]),
        ("['u*2', 0, 0]", "[0, 0, 't']", &["no formula names the input u", "remove the table"]),
        (
            "field = ['u*2', 0, 0]",
            "S = [0, 0, 1]",
            &[
                "drive.S is of other systems: a spin-lattice has friction and form in [damping], field in [drive]",
                "leave it out",
            ],
        ),
        (
            "kind = 'spin-lattice'\nparameters = { shape = [2, 2], exchange = 1 }",
            "kind = 'sphere-fluid'\nparameters = { size = 4 }",
            &[
                "[inputs] is for tops",
                "a spin-lattice has [inputs], [drive], [damping] and [noise]",
            ],
        ),
        ("end = 2", "end = 2\nscheme = 'gauss-8'", &["direct has implicit-midpoint"]),
    ] {
        let text = PULSE.replace(old, new);
        assert_ne!(text, PULSE, "{old}");
        folder.write("a.toml", &text);
        let done = folder.heavytop(&["simulate", "a.toml", "--out", "a.csv"]);
        let told = done.stderr();
        assert_eq!(done.code(), 2, "{new}: {told}");
        assert!(parts.iter().all(|part| told.contains(part)), "{new}: {told}");
        assert_eq!(folder.names(), ["a.toml"], "{new}");
    }
    // A formula without a value ends the run there.
    folder.write("a.toml", &PULSE.replace("'u*2', 0, 0", "'log(1.02 - t) + 0*u', 0, 0"));
    let done = folder.heavytop(&["simulate", "a.toml", "--out", "a.csv"]);
    assert!(done.code() == 1, "{}", done.stderr());
    assert_eq!(folder.names(), ["a.csv.partial", "a.toml"]);
}
