//! The configurations with forces that `init --kind` writes: they run as they are, and their physics is right.

use crate::program::{Folder, numbers};

fn done(folder: &Folder, arguments: &[&str]) {
    let run = folder.heavytop(arguments);
    assert_eq!(run.code(), 0, "{}", run.stderr());
}

/// Returns the index of a column.
fn column(header: &[String], name: &str) -> usize {
    header.iter().position(|own| own == name).unwrap()
}

/// Returns the mean of h over the sphere |Π| = 2 with the weight exp(−βh), for the moments (2, 3, 4): by the midpoint rule, whose error
/// is 1e-5 with 200 cells in cos θ, and less in the angle, in which the integrand is periodic.
fn gibbs_mean(beta: f64) -> f64 {
    let energy = |z: f64, angle: f64| {
        let across = 4.0 * (1.0 - z * z);
        let (x, y) = (across * angle.cos().powi(2), across * angle.sin().powi(2));
        (x / 2.0 + y / 3.0 + 4.0 * z * z / 4.0) / 2.0
    };
    let cells = (0..200).flat_map(|i| (0..64).map(move |j| (f64::from(i), f64::from(j))));
    let (sum, weights) = cells.fold((0.0, 0.0), |(sum, weights), (i, j)| {
        let h = energy((i + 0.5) / 100.0 - 1.0, j * std::f64::consts::TAU / 64.0);
        let weight = (-beta * h).exp();
        (sum + h * weight, weights + weight)
    });
    sum / weights
}

#[test]
fn a_stochastic_rigid_body_has_the_energy_of_gibbs() {
    let folder = Folder::new();
    done(&folder, &["init", "--kind", "stochastic-rigid-body", "a.toml"]);
    done(&folder, &["simulate", "a.toml", "--out", "a.csv"]);
    let (header, rows) = numbers(&folder.read("a.csv"));
    let casimir = column(&header, "c1");
    assert_eq!((rows.len(), header[1..4].join(",")), (201, "Pi1,Pi2,Pi3".into()));
    // 200 steps, each with a rounding error or two.
    assert!(rows.iter().all(|row| (row[casimir] - 4.0).abs() < 1e-13), "{:?}", rows.last());

    // The relaxation of h takes ½ s, so that 3 s leave 1 % of the distance of the start.
    let end = ["--set", "integrator.end=3", "--set", "output.every=60"];
    let paths = ["ensemble", "a.toml", "--paths", "300", "--out", "means.csv"];
    done(&folder, &[&paths[..], &end].concat());
    let (header, rows) = numbers(&folder.read("means.csv"));
    let last = rows.last().unwrap();
    let [mean, error] = ["h_mean", "h_error"].map(|name| last[column(&header, name)]);
    assert!((mean - gibbs_mean(5.0)).abs() < 4.0 * error, "{mean} ± {error}");
    // Controls: at other temperatures it is another mean.
    for beta in [0.0, 2.5, 10.0] {
        assert!((mean - gibbs_mean(beta)).abs() > 4.0 * error, "{mean} ± {error}");
    }
}

/// Along the axis dΠ₃/dt = motor − (k/I₃) Π₃, and the energy changes by the work of the motor and of the friction.
#[test]
fn a_driven_top_balances_its_energy() {
    let folder = Folder::new();
    done(&folder, &["init", "--kind", "driven-top", "a.toml"]);
    let shorter = ["--set", "integrator.end=12", "--set", "output.every=1"];
    done(&folder, &[&["simulate", "a.toml", "--out", "a.csv"], &shorter[..]].concat());
    let (header, rows) = numbers(&folder.read("a.csv"));
    assert_eq!((rows.len(), header[10..].join(",")), (1201, "qw,qx,qy,qz".into()), "{header:?}");
    let at_ten = &rows[1000];
    assert!((at_ten[3] - (4.0 - 3.0 * (-2.5_f64).exp())).abs() < 1e-12, "{at_ten:?}");

    let work = |friction: f64| {
        let power = |row: &Vec<f64>| {
            let motor = if row[0] < 10.0 { 1.0 } else { 1.0 - (row[0] - 10.0) / 10.0 };
            let omega = [row[1] / 0.3, row[2] / 0.3, row[3] / 0.2];
            motor * omega[2] - friction * omega.map(|x| x * x).iter().sum::<f64>()
        };
        let powers: Vec<f64> = rows.iter().map(power).collect();
        let panels = powers.windows(3).step_by(2);
        panels.map(|p| 0.01 / 3.0 * (p[0] + 4.0 * p[1] + p[2])).sum::<f64>()
    };
    let h = column(&header, "h");
    let gained = rows[1200][h] - rows[0][h];
    // Simpson's rule: the nutation turns by 0.1 rad in a step, 0.1⁴/180 of the work of a nutation that is 1 % of the whole.
    assert!((work(0.05) / gained - 1.0).abs() < 1e-6, "{} {gained}", work(0.05));
    // Controls: with another friction the balance does not hold, and without a motor the top falls.
    assert!((work(0.051) / gained - 1.0).abs() > 1e-3);
    let slow = ["--set", "inputs.motor.values=[0, 0, 0, 0]"];
    done(&folder, &[&["simulate", "a.toml", "--out", "b.csv"], &shorter[..], &slow[..]].concat());
    let (_, still) = numbers(&folder.read("b.csv"));
    let height = |rows: &[Vec<f64>]| rows[1200][6];
    assert!(height(&rows) > 0.85 && height(&still) < 0.0, "{} {}", height(&rows), height(&still));
}
