//! Every command that writes files, each with little to do.

use crate::program::{Finished, Folder};
use std::collections::BTreeMap;
use std::fmt;
use std::path::Path;
use std::sync::OnceLock;
use std::time::{Duration, Instant};

/// A command that writes files, with little to do.
pub struct Writing {
    pub arguments: &'static [&'static str],
    /// The files that it makes, and no others.
    pub files: &'static [&'static str],
    /// The argument by which it discards what an interrupted run has left.
    pub anew: &'static [&'static str],
    /// Whether its files are always the same; those of `compare`, which takes seconds, hold times.
    pub repeats: bool,
    /// The files of an undisturbed run, once there was one.
    undisturbed: OnceLock<Undisturbed>,
}

/// The files of an undisturbed run, and the time that it took.
pub struct Undisturbed {
    pub files: Contents,
    pub took: Duration,
}

const SHORT: &str = "integrator.end=4";
const FEW: [&str; 4] = ["--set", "section.starts=2", "--set", "section.crossings=20"];
/// A system, as an assignment.
pub const SYSTEM: &str = "system={algebra='so(3)',hamiltonian='Pi1^2+2*Pi2^2+3*Pi3^2',\
    initial={Pi=[1.0,0.5,0.3]}}";
const NOISE: &str = "noise={strength=0.1,inner_product=1}";
const EVENTS: &str = "events.functions=['Gamma3','Pi1 - 1']";
const MAP: &str = "sweep={observables=['megno'],axes=[\
    {parameter='body.inertia[1]',from=1,to=3,count=9},\
    {parameter='initial.angular_momentum[2]',from=0,to=4,count=9}]}";
const MAP_OF_SYSTEM: &str = "sweep={observables=['invariant-drift'],axes=[\
    {parameter='system.initial.Pi[0]',from=1,to=3,count=9},\
    {parameter='system.initial.Pi[2]',from=0,to=4,count=9}]}";

const LINE: &str =
    "sweep={observables=['megno'],axes=[{parameter='body.inertia[1]',from=1,to=3,count=81}]}";

/// All commands that write files, in each of their formats.
pub static WRITING: [Writing; 14] = [
    Writing {
        arguments: &["simulate", "--out", "a.csv", "--set", "integrator.end=24"],
        files: &["a.csv"],
        anew: &["--restart"],
        repeats: true,
        undisturbed: OnceLock::new(),
    },
    Writing {
        arguments: &["simulate", "--out", "a.npz", "--set", "integrator.end=24"],
        files: &["a.npz"],
        anew: &["--restart"],
        repeats: true,
        undisturbed: OnceLock::new(),
    },
    Writing {
        arguments: &["simulate", "--out", "a.parquet", "--set", "integrator.end=24"],
        files: &["a.parquet"],
        anew: &["--restart"],
        repeats: true,
        undisturbed: OnceLock::new(),
    },
    Writing {
        arguments: &["simulate", "--out", "b.csv", "--set", SYSTEM, "--set", "integrator.end=24"],
        files: &["b.csv"],
        anew: &["--restart"],
        repeats: true,
        undisturbed: OnceLock::new(),
    },
    Writing {
        arguments: &["reproduce", "--end", "1"],
        files: &[
            "figures/fig1a.png",
            "figures/fig1a.svg",
            "figures/fig1b.png",
            "figures/fig1b.svg",
            "figures/fig1c.png",
            "figures/fig1c.svg",
            "figures/fig1d.png",
            "figures/fig1d.svg",
            "figures/fig2a.png",
            "figures/fig2a.svg",
            "figures/fig2b.png",
            "figures/fig2b.svg",
            "figures/summary.csv",
            "figures/trajectories.csv",
        ],
        anew: &[],
        repeats: true,
        undisturbed: OnceLock::new(),
    },
    Writing {
        arguments: &["compare", "--out", "made", "--set", "integrator.step=0.1", "--end", "0.1"],
        files: &["made/work-precision.csv", "made/work-precision.png", "made/work-precision.svg"],
        anew: &[],
        repeats: false,
        undisturbed: OnceLock::new(),
    },
    Writing {
        arguments: &["section", "--out", "made", FEW[0], FEW[1], FEW[2], FEW[3]],
        files: &[
            "made/section.csv",
            "made/section.parquet",
            "made/section.png",
            "made/section.svg",
        ],
        anew: &["--restart"],
        repeats: true,
        undisturbed: OnceLock::new(),
    },
    Writing {
        arguments: &["sweep", "--out", "made", "--set", MAP, "--set", "integrator.end=1"],
        files: &["made/megno.png", "made/megno.svg", "made/sweep.parquet"],
        anew: &["--restart"],
        repeats: true,
        undisturbed: OnceLock::new(),
    },
    Writing {
        arguments: &[
            "sweep",
            "--out",
            "runs",
            "--set",
            SYSTEM,
            "--set",
            MAP_OF_SYSTEM,
            "--set",
            SHORT,
        ],
        files: &[
            "runs/drift_c1.png",
            "runs/drift_c1.svg",
            "runs/drift_h.png",
            "runs/drift_h.svg",
            "runs/sweep.parquet",
        ],
        anew: &["--restart"],
        repeats: true,
        undisturbed: OnceLock::new(),
    },
    Writing {
        arguments: &["sweep", "--out", "line", "--set", LINE, "--set", "integrator.end=1"],
        files: &["line/megno.png", "line/megno.svg", "line/sweep.csv", "line/sweep.parquet"],
        anew: &["--restart"],
        repeats: true,
        undisturbed: OnceLock::new(),
    },
    Writing {
        arguments: &["animate", "--out", "a.html", "--set", SHORT],
        files: &["a.html"],
        anew: &[],
        repeats: true,
        undisturbed: OnceLock::new(),
    },
    Writing {
        arguments: &["events", "--out", "e.csv", "--set", EVENTS, "--set", "integrator.end=24"],
        files: &["e.csv"],
        anew: &[],
        repeats: true,
        undisturbed: OnceLock::new(),
    },
    Writing {
        arguments: &["ensemble", "--out", "n.csv", "--paths", "3", "--set", NOISE, "--set", SHORT],
        files: &["n.csv"],
        anew: &[],
        repeats: true,
        undisturbed: OnceLock::new(),
    },
    Writing {
        arguments: &["init", "a.toml"],
        files: &["a.toml"],
        anew: &[],
        repeats: true,
        undisturbed: OnceLock::new(),
    },
];

/// The commands that write to standard output only.
const PRINTING: [&str; 5] = ["bench", "report", "man", "completions", "help"];

/// The commands that read an archive of a run, which `systems_of_arrays.rs` makes.
const FROM_ARCHIVES: [&str; 2] = ["plot", "export"];

/// The files below a folder with their contents.
pub type Contents = BTreeMap<String, Vec<u8>>;

impl fmt::Display for Writing {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(to, "{} to {}", self.arguments[0], self.files[0])
    }
}

impl Writing {
    pub fn run(&self, folder: &Folder, more: &[&str]) -> Finished {
        folder.heavytop(&[self.arguments, more].concat())
    }

    /// Returns what an undisturbed run makes, which is the same run for all tests.
    pub fn undisturbed(&self) -> &Undisturbed {
        self.undisturbed.get_or_init(|| {
            let (folder, begun) = (Folder::new(), Instant::now());
            let run = self.run(&folder, &[]);
            assert_eq!((run.code(), run.complaints()), (0, String::new()), "{self}");
            let (files, took) = (contents(&folder), begun.elapsed());
            assert!(files.keys().eq(self.files), "{self}: {:?}", files.keys());
            Undisturbed { files, took }
        })
    }

    /// Returns whether a file is complete: that of an undisturbed run or, where the files hold times, one of its form.
    pub fn is_whole(&self, name: &str, bytes: &[u8]) -> bool {
        let undisturbed = &self.undisturbed().files[name];
        if self.repeats {
            return bytes == undisturbed;
        }
        let cells = |bytes: &[u8]| -> Vec<usize> {
            let cells = |line: &[u8]| line.iter().filter(|&&byte| byte == b',').count();
            bytes.split(|&byte| byte == b'\n').map(cells).collect()
        };
        match name.rsplit_once('.').map(|(_, ending)| ending) {
            // The last line of both is empty.
            Some("csv") => cells(bytes) == cells(undisturbed),
            // PNG and SVG end with the same eight bytes for every content, so that a cut file ends otherwise.
            _ => bytes.len() > 99 && bytes.ends_with(&undisturbed[undisturbed.len() - 8..]),
        }
    }

    /// Returns a folder with files of an older run; `init`, whose files are always the same, has none.
    pub fn with_old_files(&self) -> Folder {
        let folder = Folder::new();
        for file in self.files.iter().filter(|_| self.arguments[0] != "init") {
            let path = folder.path(file);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, self.old(file)).unwrap();
        }
        folder
    }

    /// Returns the contents that a file of an older run has: it is of the same kind, and other than a new one.
    pub fn old(&self, name: &str) -> Vec<u8> {
        let mut bytes = self.undisturbed().files[name].clone();
        match name.rsplit_once('.').unwrap().1 {
            "csv" => {
                let lines = bytes.split_inclusive(|&byte| byte == b'\n').take(2);
                lines.collect::<Vec<_>>().concat()
            }
            // A number in the middle of the first array or column.
            "npz" | "parquet" => {
                bytes[300] ^= 1;
                bytes
            }
            _ => [&bytes[..], b"\n"].concat(),
        }
    }

    pub fn is_old(&self, name: &str, bytes: &[u8]) -> bool {
        self.files.contains(&name) && bytes == self.old(name)
    }

    /// Checks that the run is repeated with success, which leaves nothing but its files.
    pub fn assert_repeats(&self, folder: &Folder, more: &[&str]) {
        let run = self.run(folder, more);
        assert_eq!((run.code(), run.complaints()), (0, String::new()), "{self} {more:?}");
        let files = contents(folder);
        assert!(files.keys().eq(self.files), "{self} {more:?} left {:?}", files.keys());
        for (file, bytes) in &files {
            assert!(self.is_whole(file, bytes), "{self} {more:?}: {file}");
        }
    }
}

/// Returns the files below a folder with their contents.
pub fn contents(folder: &Folder) -> Contents {
    let mut files = Contents::new();
    let mut collect = |path: &Path, name: String| {
        files.insert(name, std::fs::read(path).unwrap());
    };
    fn visit(folder: &Path, prefix: &str, collect: &mut dyn FnMut(&Path, String)) {
        for entry in std::fs::read_dir(folder).unwrap() {
            let entry = entry.unwrap();
            let name = format!("{prefix}{}", entry.file_name().into_string().unwrap());
            match entry.path().is_dir() {
                true => visit(&entry.path(), &format!("{name}/"), collect),
                false => collect(&entry.path(), name),
            }
        }
    }
    visit(&folder.path("."), "", &mut collect);
    files
}

/// A command that is added later has to be added to one of the tables, or this fails.
#[test]
fn every_command_is_in_a_table() {
    let help = Folder::new().heavytop(&["--help"]).stdout();
    let commands = help.split("Commands:\n").nth(1).unwrap().split("\n\n").next().unwrap();
    let commands: Vec<_> =
        commands.lines().map(|line| line.split_whitespace().next().unwrap()).collect();
    assert!(commands.len() > 9, "{commands:?}");
    for command in commands {
        let writes = WRITING.iter().any(|writing| writing.arguments[0] == command)
            || FROM_ARCHIVES.contains(&command);
        assert_ne!(writes, PRINTING.contains(&command), "{command} is in no table, or in both");
        let help = Folder::new().heavytop(&["help", command]).stdout();
        assert!(writes || !help.contains("--out"), "{command} writes files");
    }
}

/// Negative control: files that are cut, even by their last byte, are not whole, nor are those of an older run.
#[test]
#[ignore = "long"]
fn files_that_are_cut_are_not_whole() {
    for writing in
        WRITING.iter().filter(|writing| ["compare", "init"].contains(&writing.arguments[0]))
    {
        for (name, bytes) in &writing.undisturbed().files {
            assert!(writing.is_whole(name, bytes), "{name}");
            let lengths = [0, 1, bytes.len() / 2, bytes.len() - 1];
            assert!(lengths.iter().all(|&n| !writing.is_whole(name, &bytes[..n])), "{name}");
            assert!(!writing.is_whole(name, &writing.old(name)), "{name}");
        }
    }
}
