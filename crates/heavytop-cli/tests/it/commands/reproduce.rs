//! `heavytop reproduce`: the paper's numbers, its figures, and how the command ends.

use crate::program::Folder;

/// The maxima over all steps of |h − h(0)|, |f₁ − f₁(0)|, |f₂ − f₂(0)| and |K − K(0)| in the paper's experiment, from
/// an independent computation; 0 stands for round-off.
const NUMBERS: [(&str, [f64; 4]); 4] = [
    ("collective,implicit-midpoint,0.02,100.0", [9.091e-4, 0.0, 0.0, 6.344e-2]),
    ("collective,explicit-midpoint,0.02,100.0", [0.31584, 2.3770e-2, 0.10625, 5.3352]),
    ("direct,explicit-midpoint,0.02,100.0", [1.2766e-2, 3.0957e-2, 9.784e-3, 1.4383]),
    ("direct,implicit-midpoint,0.02,100.0", [0.0, 0.0, 0.0, 0.35420]),
];

const FILES: [&str; 14] = [
    "fig1a.png",
    "fig1a.svg",
    "fig1b.png",
    "fig1b.svg",
    "fig1c.png",
    "fig1c.svg",
    "fig1d.png",
    "fig1d.svg",
    "fig2a.png",
    "fig2a.svg",
    "fig2b.png",
    "fig2b.svg",
    "summary.csv",
    "trajectories.csv",
];

#[test]
fn the_paper_is_reproduced() {
    let folder = Folder::new();
    let run = folder.heavytop(&["reproduce"]);
    assert_eq!((run.code(), run.complaints().as_str()), (0, ""));

    let mut names: Vec<_> = std::fs::read_dir(folder.path("figures"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    assert_eq!(names, FILES);

    let summary = folder.read("figures/summary.csv");
    let mut lines = summary.lines();
    assert_eq!(lines.next(), Some("formulation,scheme,step,end,h,f1,f2,K"));
    for (method, expected) in NUMBERS {
        let cells = lines.next().unwrap().strip_prefix(method).unwrap();
        let found: Vec<f64> = cells[1..].split(',').map(|cell| cell.parse().unwrap()).collect();
        assert_eq!(found.len(), 4);
        for (found, expected) in found.into_iter().zip(expected) {
            let slack = if expected == 0.0 { 1e-12 } else { 5e-4 * expected };
            assert!((found - expected).abs() < slack, "{method}: {found} for {expected}");
        }
    }
    assert_eq!(lines.next(), None);

    let table = run.stdout();
    for shown in ["9.091e-4", "3.158e-1", "1.438e0", "3.542e-1"] {
        assert!(table.contains(shown), "{shown} in {table}");
    }
}

#[test]
#[ignore = "long"]
fn the_summary_in_json_is_that_of_the_table() {
    let folder = Folder::new();
    let run = folder.heavytop(&["reproduce", "--out", ".", "--end", "1", "--json"]);
    let summary: serde_json::Value = serde_json::from_str(&run.stdout()).unwrap();
    let table = folder.read("summary.csv");
    for (row, run) in table.lines().skip(1).zip(summary["runs"].as_array().unwrap()) {
        let cells: Vec<&str> = row.split(',').collect();
        assert_eq!((&run["formulation"], &run["scheme"]), (&cells[0].into(), &cells[1].into()));
        assert_eq!(run["K"].as_f64(), cells[7].parse().ok());
    }
    assert_eq!(summary["runs"].as_array().unwrap().len(), 4);
}

#[test]
#[ignore = "long"]
fn trajectories_hold_every_step_of_every_integrator() {
    let folder = Folder::new();
    let run = folder.heavytop(&["reproduce", "--out", "a/b", "--end", "1", "--step", "0.1"]);
    assert_eq!(run.code(), 0);
    let trajectories = folder.read("a/b/trajectories.csv");
    let lines: Vec<&str> = trajectories.lines().collect();
    let header = "formulation,scheme,t,Pi1,Pi2,Pi3,Gamma1,Gamma2,Gamma3,h,f1,f2,K";
    assert_eq!(lines[0], header);
    assert_eq!(lines.len(), 1 + 4 * 11);
    assert!(lines[1].starts_with("collective,implicit-midpoint,0.0,2.0,3.0,4.0,0.5,0.0,0.866025"));
    assert!(lines[44].starts_with("direct,implicit-midpoint,1.0,"));
}

#[test]
#[ignore = "long"]
fn figures_need_no_font_and_have_the_paper_s_colours() {
    let folder = Folder::new();
    assert_eq!(folder.heavytop(&["reproduce", "--out", ".", "--end", "2"]).code(), 0);
    let (blue, green, red, gray) = ("#0072b2", "#009e73", "#d55e00", "#555555");
    for (name, colours, others) in [
        ("fig1a", &[blue, green, red][..], &[gray][..]),
        ("fig1b", &[blue, green, red], &[gray]),
        ("fig1c", &[blue, green, red], &[gray]),
        ("fig1d", &[blue, green, red], &[gray]),
        ("fig2a", &[gray, red], &[blue, green]),
        ("fig2b", &[gray, red], &[blue, green]),
    ] {
        let svg = folder.read(&format!("{name}.svg"));
        assert!(!svg.contains("<text") && !svg.contains("font-family"), "{name} has text");
        let letters = svg.matches("<path fill=\"#000000\" stroke=\"none\"").count();
        // A figure has two titles, a legend, and some ticks.
        assert!(letters >= 12, "{name} has {letters} outlines of text");
        for colour in colours {
            // The colour occurs twice: in the curve, and in its sample in the legend.
            assert_eq!(svg.matches(&format!("stroke=\"{colour}\"")).count(), 2, "{name} {colour}");
        }
        for colour in others {
            assert!(!svg.contains(colour), "{name} {colour}");
        }
        let png = std::fs::read(folder.path(&format!("{name}.png"))).unwrap();
        assert!(png.starts_with(b"\x89PNG\r\n\x1a\n") && png.len() > 10_000, "{name}.png");
    }
}

#[test]
fn a_wrong_request_makes_not_even_the_folder() {
    for (arguments, message) in [
        (&["--step", "0"][..], "step must be positive and finite, got 0"),
        (&["--step", "-0.02"], "step must be positive and finite, got -0.02"),
        (&["--step", "NaN"], "step must be positive and finite, got NaN"),
        (&["--end", "inf"], "end must be positive and finite, got inf"),
        (&["--step", "1e-11"], "more than 1e12"),
        (&["--step", "0.03"], "the nearest ends are 99.99 and 100.02"),
        (&["--step", "small"], "invalid value 'small'"),
    ] {
        let folder = Folder::new();
        let run = folder.heavytop(&[&["reproduce"], arguments].concat());
        assert_eq!(run.code(), 2, "{arguments:?}");
        assert!(run.stderr().contains(message), "{arguments:?}: {}", run.stderr());
        assert!(folder.names().is_empty());
    }
}

#[test]
fn a_place_is_refused_before_the_run_and_fails_after_it() {
    let folder = Folder::new();
    folder.write("file", "");
    let run = folder.heavytop(&["reproduce", "--out", "file"]);
    assert_eq!(run.code(), 2, "{}", run.stderr());
    assert_eq!(folder.names(), ["file"]);

    std::fs::create_dir_all(folder.path("figures/fig1a.svg")).unwrap();
    let run = folder.heavytop(&["reproduce", "--end", "2"]);
    assert_eq!(run.code(), 2, "{}", run.stderr());
    assert!(run.stderr().contains("cannot create figures/fig1a.svg: is a directory"));
    std::fs::rename(folder.path("figures/fig1a.svg"), folder.path("figures/fig1a.svg.partial"))
        .unwrap();
    let run = folder.heavytop(&["reproduce", "--end", "2"]);
    assert_eq!(run.code(), 1, "{}", run.stderr());
    assert!(run.stderr().contains("cannot write figures/fig1a.svg: "), "{}", run.stderr());
    assert!(folder.path("figures/trajectories.csv.partial").exists());
}

#[test]
fn a_run_that_fails_leaves_its_numbers_and_no_figure() {
    let folder = Folder::new();
    let run = folder.heavytop(&["reproduce", "--out", ".", "--step", "0.5"]);
    assert_eq!(run.code(), 1);
    let said = run.stderr();
    assert!(said.contains("collective, explicit-midpoint: step 5 at t = 2: "), "{said}");
    assert_eq!(folder.names(), ["trajectories.csv.partial"]);
}
