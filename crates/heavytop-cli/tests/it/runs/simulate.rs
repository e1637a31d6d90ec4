//! `heavytop simulate`: what it writes.

use crate::program::{Folder, numbers};

#[test]
fn without_a_configuration_it_is_the_paper_s_top() {
    let folder = Folder::new();
    let run = folder.heavytop(&["simulate", "--out", "top.csv"]);
    assert_eq!((run.code(), run.stdout(), run.complaints()), (0, String::new(), String::new()));
    assert_eq!(folder.names(), ["top.csv"]);

    let (header, rows) = numbers(&folder.read("top.csv"));
    assert_eq!(header.join(","), "t,Pi1,Pi2,Pi3,Gamma1,Gamma2,Gamma3,h,f1,f2,K");
    assert_eq!(rows.len(), 5001);
    assert_eq!(rows[0][..7], [0.0, 2.0, 3.0, 4.0, 0.5, 0.0, 0.866_025_403_784_438_6]);
    for (value, exact) in rows[0][7..].iter().zip([11.75, 1.0, 1.0 + 12_f64.sqrt(), 193.0]) {
        assert!((value - exact).abs() < 1e-13 * exact);
    }
    assert_eq!(rows[5000][0], 100.0);
    let drift =
        |rows: &[Vec<f64>]| rows.iter().map(|row| (row[10] - 193.0).abs()).fold(0.0, f64::max);
    assert!(drift(&rows) < 1e-10, "{}", drift(&rows));
    // By the method of the paper K oscillates.
    let midpoint = ["--set", "integrator.scheme=implicit-midpoint"];
    let run = folder.heavytop(&[&["simulate", "--out", "midpoint.csv"], &midpoint[..]].concat());
    assert_eq!(run.code(), 0);
    let (_, rows) = numbers(&folder.read("midpoint.csv"));
    assert!((drift(&rows) - 6.344e-2).abs() < 5e-5, "{}", drift(&rows));
}

#[test]
fn an_empty_configuration_is_the_same_as_none_and_as_the_one_in_the_help() {
    let folder = Folder::new();
    let help = folder.heavytop(&["simulate", "--help"]).stdout();
    let (_, configuration) = help.split_once("value below.\n").unwrap();
    folder.write("full.toml", configuration.split_once("Formulations:").unwrap().0);
    folder.write("empty.toml", "");
    folder.write("part.toml", "body.mass = 1\n[output]\n");
    assert_eq!(folder.heavytop(&["simulate", "--out", "none.csv"]).code(), 0);
    let expected = folder.read("none.csv");
    for name in ["full", "empty", "part"] {
        let (config, out) = (format!("{name}.toml"), format!("{name}.csv"));
        let run = folder.heavytop(&["simulate", &config, "--out", &out]);
        assert_eq!((run.code(), run.complaints()), (0, String::new()), "{name}");
        assert!(folder.read(&out) == expected, "{name}");
    }
}

#[test]
fn numbers_read_back_as_they_were() {
    // Each number, read and written again, gives the same text; and f₂ is the product of the written Π and Γ to the
    // last bit. So the text is the number that was computed with.
    let folder = Folder::new();
    folder.write("a.toml", "[integrator]\nend = 4\n");
    assert_eq!(folder.heavytop(&["simulate", "a.toml", "--out", "a.csv"]).code(), 0);
    let text = folder.read("a.csv");
    let (header, rows) = numbers(&text);
    let mut again = header.join(",") + "\n";
    for row in &rows {
        again += &(row.iter().map(|x| format!("{x:?}")).collect::<Vec<_>>().join(",") + "\n");
        assert_eq!(row[1] * row[4] + row[2] * row[5] + row[3] * row[6], row[9]);
    }
    assert!(again == text);
}

#[test]
fn the_solution_converges_to_the_exact_one() {
    let exact = [
        2.611_034_121_401_548,
        -2.670_466_863_410_764,
        3.844_759_745_406_407_6,
        0.871_688_137_126_708_8,
        -0.145_727_408_391_562_16,
        0.467_892_417_160_234_5,
    ];
    for (scheme, error) in [
        ("implicit-midpoint", 1e-2),
        ("explicit-midpoint", 1e-2),
        ("rk4", 1e-5),
        ("gauss-4", 1e-6),
        ("gauss-6", 1e-9),
        ("gauss-8", 1e-13),
        ("gauss-10", 1e-13),
        ("gauss-12", 1e-13),
        ("gauss-16", 1e-13),
    ] {
        for formulation in ["collective", "direct"] {
            let folder = Folder::new();
            folder.write(
                "a.toml",
                &format!(
                    "[integrator]\nend = 1.0\nscheme = '{scheme}'\nformulation = '{formulation}'"
                ),
            );
            assert_eq!(folder.heavytop(&["simulate", "a.toml", "--out", "a.csv"]).code(), 0);
            let (_, rows) = numbers(&folder.read("a.csv"));
            let last = &rows[50][1..7];
            let found = last.iter().zip(exact).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
            // The result is neither too far, nor so near that another scheme must have run.
            let least = if error > 1e-12 { error / 3e3 } else { 0.0 };
            assert!(found < error && found >= least, "{formulation} {scheme}: {found:e}");
        }
    }
}

#[test]
fn every_nth_step_is_kept_and_the_last() {
    let folder = Folder::new();
    folder.write("a.toml", "integrator = { step = 0.125, end = 1.25 }\noutput.every = 4");
    assert_eq!(folder.heavytop(&["simulate", "a.toml", "--out", "a.csv"]).code(), 0);
    let (_, rows) = numbers(&folder.read("a.csv"));
    let times: Vec<f64> = rows.iter().map(|row| row[0]).collect();
    assert_eq!(times, [0.0, 0.5, 1.0, 1.25]);
}

#[test]
fn the_tolerance_reaches_the_stage_equations() {
    let folder = Folder::new();
    let deviations = [0.0, 1e-3].map(|tolerance| {
        folder.write("a.toml", &format!("integrator = {{ end = 10, tolerance = {tolerance} }}"));
        assert_eq!(folder.heavytop(&["--quiet", "simulate", "a.toml", "--out", "a.csv"]).code(), 0);
        let (_, rows) = numbers(&folder.read("a.csv"));
        rows.iter().map(|row| (row[8] - 1.0).abs()).fold(0.0, f64::max)
    });
    assert!(deviations[0] < 1e-13 && deviations[1] > 1e-9, "{deviations:?}");
}

#[test]
fn each_top_has_its_own_columns() {
    let base = "t,Pi1,Pi2,Pi3,Gamma1,Gamma2,Gamma3,h,f1,f2";
    for (body, last) in [
        (
            "inertia = [4.0, 4.0, 1.0]\n[initial]\nangular_momentum = [2, 3, 0]\nvertical = [0, 0, 1]",
            ",G",
        ),
        // G is conserved where Π·Γ = 0 alone.
        ("inertia = [4.0, 4.0, 1.0]", ""),
        ("inertia = [2.0, 2.0, 2.0]\ncenter_of_mass = [0.6, 0.8, 0.0]", ",f3"),
        ("inertia = [2.0, 2.0, 1.0]", ",K"),
        ("inertia = [2.0, 2.0, 1.0]\ncenter_of_mass = [0.6, 0.8, 0.0]", ",K"),
        ("inertia = [3.0, 2.0, 1.5]", ""),
        ("inertia = [3.0, 3.0, 1.5]\ngravity = 0\ncenter_of_mass = [0, 0, 1]", ",C"),
        ("inertia = [2.0, 1.0, 2.0]", ",K"),
    ] {
        let folder = Folder::new();
        folder.write("a.toml", &format!("[body]\n{body}\n[integrator]\nend = 0.1"));
        assert_eq!(folder.heavytop(&["simulate", "a.toml", "--out", "a.csv"]).code(), 0);
        let (header, rows) = numbers(&folder.read("a.csv"));
        assert_eq!(header.join(","), format!("{base}{last}"), "{body}");
        assert!(rows.iter().all(|row| row.len() == header.len()));
    }
}

#[test]
fn an_old_file_is_replaced_whole() {
    let folder = Folder::new();
    let header = "t,Pi1,Pi2,Pi3,Gamma1,Gamma2,Gamma3,h,f1,f2\n".to_owned();
    folder.write("a.csv", &(header + &"0.0,1,1,1,1,0,0,3,1,1\n".repeat(100_000)));
    folder.write("a.toml", "[integrator]\nend = 0.1");
    assert_eq!(folder.heavytop(&["simulate", "a.toml", "--out", "a.csv"]).code(), 0);
    assert_eq!(numbers(&folder.read("a.csv")).1.len(), 6);
    assert_eq!(folder.names(), ["a.csv", "a.toml"]);
}

#[test]
#[cfg(unix)]
fn a_device_is_written_to_and_a_link_stays() {
    let folder = Folder::new();
    folder.write("a.toml", "[integrator]\nend = 0.1");
    let run = folder.heavytop(&["simulate", "a.toml", "--out", "/dev/stdout"]);
    assert_eq!(numbers(&run.stdout()).1.len(), 6);

    folder.write("real.csv", "");
    std::os::unix::fs::symlink("real.csv", folder.path("link.csv")).unwrap();
    assert_eq!(folder.heavytop(&["simulate", "a.toml", "--out", "link.csv"]).code(), 0);
    assert!(folder.path("link.csv").is_symlink());
    assert_eq!(numbers(&folder.read("real.csv")).1.len(), 6);
}

/// A link to a file that does not exist yet is followed like any other.
#[test]
#[cfg(unix)]
fn a_link_to_nothing_stays_and_what_it_leads_to_is_made() {
    use std::os::unix::fs::symlink;
    let folder = Folder::new();
    folder.write("a.toml", "[integrator]\nend = 0.1");
    std::fs::create_dir(folder.path("below")).unwrap();
    // The links lead from one to the next, each relative to its own folder.
    symlink("below/next.csv", folder.path("link.csv")).unwrap();
    symlink("../real.csv", folder.path("below/next.csv")).unwrap();
    let run = folder.heavytop(&["simulate", "a.toml", "--out", "link.csv"]);
    assert_eq!((run.code(), run.complaints()), (0, String::new()));
    assert!(folder.path("link.csv").is_symlink() && folder.path("below/next.csv").is_symlink());
    assert_eq!(numbers(&folder.read("real.csv")).1.len(), 6);
    assert_eq!(folder.names(), ["a.toml", "below", "link.csv", "real.csv"]);

    symlink("missing/real.html", folder.path("lost.html")).unwrap();
    symlink("round.csv", folder.path("round.csv")).unwrap();
    symlink("below", folder.path("folder.csv")).unwrap();
    for (arguments, message) in [
        (["animate", "lost.html"], "cannot create missing/real.html: No such file"),
        (["simulate", "round.csv"], "cannot create round.csv: too many levels of symbolic links"),
        (["simulate", "folder.csv"], "cannot create folder.csv: is a directory"),
    ] {
        let run = folder.heavytop(&[arguments[0], "a.toml", "--out", arguments[1]]);
        assert_eq!(run.code(), 2, "{}", run.stderr());
        assert!(run.stderr().contains(message), "{}", run.stderr());
        assert!(folder.path(arguments[1]).is_symlink());
    }
}

/// Returns Rᵀe₃ for the unit quaternion (w, x, y, z) of R: the last row of its matrix.
fn vertical(q: &[f64]) -> [f64; 3] {
    let [w, x, y, z] = [q[0], q[1], q[2], q[3]];
    [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), w * w - x * x - y * y + z * z]
}

#[test]
fn the_attitude_is_written_where_asked() {
    let mut ends = Vec::new();
    for (formulation, scheme) in [
        ("collective", "gauss-8"),
        ("collective", "yoshida-6"),
        ("reduced", "gauss-8"),
        ("reduced", "kahan-li-8"),
        ("splitting", "kahan-li-8"),
    ] {
        let folder = Folder::new();
        let integrator =
            format!("[integrator]\nformulation = '{formulation}'\nscheme = '{scheme}'\nend = 4\n");
        folder.write("plain.toml", &integrator);
        folder.write("a.toml", &format!("{integrator}[output]\nattitude = true\nevery = 10"));
        for name in ["plain", "a"] {
            let (config, out) = (format!("{name}.toml"), format!("{name}.csv"));
            assert_eq!(folder.heavytop(&["simulate", &config, "--out", &out]).code(), 0);
        }
        let (header, rows) = numbers(&folder.read("a.csv"));
        assert!(header.join(",").ends_with(",K,qw,qx,qy,qz"), "{header:?}");
        for row in &rows {
            let (gamma, seen) = (&row[4..7], vertical(&row[11..]));
            for i in 0..3 {
                assert!((gamma[i] - seen[i]).abs() < 1e-13, "{formulation} {scheme}: {row:?}");
            }
        }
        // The start is the shortest rotation that takes Γ(0) = (1/2, 0, √3/2) to e₃: by 30° about −e₂.
        let start =
            [(0.5 + 0.75_f64.sqrt() / 2.0).sqrt(), 0.0, -(0.5 - 0.75_f64.sqrt() / 2.0).sqrt(), 0.0];
        assert!(rows[0][11..].iter().zip(start).all(|(x, y)| (x - y).abs() < 1e-15));
        // The other columns are the same as without the attitude, to the last bit.
        let (_, plain) = numbers(&folder.read("plain.csv"));
        for (row, plain) in rows.iter().zip(plain.iter().step_by(10)) {
            assert_eq!(row[..11], plain[..]);
        }
        ends.push(rows[20][11..].to_vec());
    }
    // Γ alone leaves a rotation about the vertical open; all formulations agree on it.
    for end in &ends {
        assert!(end.iter().zip(&ends[2]).all(|(x, y)| (x - y).abs() < 1e-6), "{ends:?}");
    }
}
