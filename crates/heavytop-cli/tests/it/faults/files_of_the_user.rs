//! Files of the user: no command destroys one that it reads, or replaces one that the program has not written.
#![cfg(unix)]

use crate::program::{Finished, Folder, heavytop};
use crate::writing::{WRITING, Writing, contents};
use std::fs;
use std::os::unix::fs::symlink;
use std::path::Path;
use std::process::{Command, Stdio};

/// The files that a command writes or removes, and its arguments between the configuration and the output.
struct Files {
    command: &'static [&'static str],
    out: &'static str,
    files: &'static [&'static str],
}

const TILES: [&str; 4] = ["identity", "lock", "0000000", "0000001.partial"];

const FILES: [Files; 7] = [
    Files {
        command: &["simulate"],
        out: "made/a.csv",
        files: &["a.csv", "a.csv.partial", "a.csv.checkpoint", "a.csv.checkpoint.partial"],
    },
    Files {
        command: &["simulate"],
        out: "made/a.npz",
        files: &["a.npz", "a.npz.partial", "a.npz.rows", "a.npz.checkpoint"],
    },
    Files {
        command: &["compare"],
        out: "made",
        files: &["work-precision.csv", "work-precision.svg.partial", "work-precision.png"],
    },
    Files {
        command: &["section"],
        out: "made",
        files: &["section.csv", "section.parquet.partial", "section.svg", "section.png"],
    },
    Files {
        command: &["sweep"],
        out: "made",
        files: &["sweep.parquet", "sweep.parquet.partial", "megno.svg", "megno.png"],
    },
    Files {
        command: &["sweep", "--set", LINE],
        out: "made",
        files: &["sweep.parquet", "sweep.csv", "sweep.csv.partial", "megno.svg", "megno.png"],
    },
    Files { command: &["animate"], out: "made/a.html", files: &["a.html", "a.html.partial"] },
];

/// A single axis, as an assignment.
const LINE: &str = "sweep.axes=[{parameter='body.inertia[1]',from=1,to=3,count=3}]";

const CONFIGURATION: &str = "integrator.end = 0.1\n[sweep]\nobservables = ['megno']\n";

/// Makes a file reachable by another name.
type Link = fn(&Path, &Path);

/// How a name leads to a file: by a symbolic link, a hard link, a chain of links, or through a linked folder.
const LINKS: [Link; 4] = [
    |file, link| symlink(file, link).unwrap(),
    |file, link| fs::hard_link(file, link).unwrap(),
    |file, link| {
        let middle = file.with_extension("middle");
        let _ = fs::remove_file(&middle);
        symlink(file.file_name().unwrap(), &middle).unwrap();
        symlink(middle, link).unwrap();
    },
    // The file itself lies there, and the configuration is named by a path through a linked folder.
    |file, link| {
        fs::rename(file, link).unwrap();
        let linked = file.with_file_name("linked");
        let _ = fs::remove_file(&linked);
        symlink(link.parent().unwrap(), &linked).unwrap();
        symlink(linked.join(link.file_name().unwrap()), file).unwrap();
    },
];

impl Files {
    /// Returns all names, those in the folder of tiles included.
    fn names(&self) -> Vec<String> {
        let tiles = match self.command[0] {
            "section" | "sweep" => &TILES[..],
            _ => &[],
        };
        let tiles = tiles.iter().map(|tile| format!("{}.partial/{tile}", self.command[0]));
        self.files.iter().map(ToString::to_string).chain(tiles).collect()
    }

    fn run(&self, folder: &Folder, configuration: &str, more: &[&str]) -> Finished {
        let out = ["--out", self.out, "--quiet"];
        folder.heavytop(&[self.command, &[configuration], &out[..], more].concat())
    }
}

/// Returns a folder with a configuration, and the place of an output in it.
fn folder_with(name: &str) -> (Folder, std::path::PathBuf) {
    let folder = Folder::new();
    folder.write("top.toml", CONFIGURATION);
    let place = folder.path("made").join(name);
    fs::create_dir_all(place.parent().unwrap()).unwrap();
    (folder, place)
}

#[track_caller]
fn assert_input_is_kept(run: &Finished, folder: &Folder, before: &crate::writing::Contents) {
    let said = run.stderr();
    assert_eq!((run.code(), said.lines().count()), (2, 1), "{said}");
    assert!(said.contains(", which this command reads; choose another name\n"), "{said}");
    assert!(contents(folder) == *before, "{said}: {:?}", contents(folder).keys());
}

#[test]
#[ignore = "long"]
fn no_output_is_an_input_by_any_link() {
    for files in &FILES {
        for name in files.names() {
            for (number, link) in LINKS.into_iter().enumerate() {
                let (folder, place) = folder_with(&name);
                link(&folder.path("top.toml"), &place);
                let before = contents(&folder);
                let force = [&[][..], &["--force"]][number % 2];
                assert_input_is_kept(&files.run(&folder, "top.toml", force), &folder, &before);
            }
            // The same path, by another name; it is wrong that a name ends so, and right to refuse it for its file.
            let (folder, place) = folder_with(&name);
            fs::rename(folder.path("top.toml"), place).unwrap();
            let before = contents(&folder);
            let run = files.run(&folder, &format!("./made/../made/{name}"), &["--force"]);
            assert_input_is_kept(&run, &folder, &before);
        }
        // Control: a copy of the configuration is no input.
        let (folder, _) = folder_with("a");
        fs::copy(folder.path("top.toml"), folder.path("made/copy.toml")).unwrap();
        if files.command[0] != "compare" && files.command[0] != "section" {
            let run = files.run(&folder, "top.toml", &[]);
            assert_eq!((run.code(), run.stderr()), (0, String::new()));
        }
    }
}

/// A configuration may name another file, come from standard input, or be that of a checkpoint.
#[test]
fn a_table_standard_input_and_a_checkpoint_are_inputs() {
    let folder = Folder::new();
    folder.write("so3.csv", "1, 2, 3, 1\n2, 3, 1, 1\n3, 1, 2, 1\n");
    let system = "[system]\nstructure_constants = 'so3.csv'\nhamiltonian = 'mu1^2'\ninitial.mu = [1, 2, 3]\n";
    folder.write("so3.toml", &format!("{system}[integrator]\nend = 0.1\n"));
    fs::hard_link(folder.path("so3.csv"), folder.path("other.csv")).unwrap();
    let before = contents(&folder);
    for out in ["so3.csv", "other.csv", "./so3.csv"] {
        let run = folder.heavytop(&["simulate", "so3.toml", "--out", out, "--force"]);
        assert_input_is_kept(&run, &folder, &before);
    }

    folder.write("fed.csv", "integrator.end = 0.1\n");
    let before = contents(&folder);
    let mut command = Command::new(heavytop());
    command.args(["simulate", "-", "--out", "fed.csv", "--force"]).current_dir(folder.path("."));
    command.stdin(fs::File::open(folder.path("fed.csv")).unwrap());
    let run = Finished::of(command.stderr(Stdio::piped()).output().unwrap());
    assert_input_is_kept(&run, &folder, &before);
    // Standard output that goes on where the configuration ends.
    let mut command = Command::new(heavytop());
    command.args(["simulate", "fed.csv", "--out", "-", "--force"]).current_dir(folder.path("."));
    let appended = fs::File::options().append(true).open(folder.path("fed.csv")).unwrap();
    command.stdout(appended).stderr(Stdio::piped());
    assert_input_is_kept(&Finished::of(command.output().unwrap()), &folder, &before);

    let folder = crate::resumption::checkpoint::interrupted("a.csv");
    for kept in ["b.csv", "b.csv.checkpoint.partial", "b.csv.partial"] {
        fs::copy(folder.path("a.csv.checkpoint"), folder.path(kept)).unwrap();
        let before = contents(&folder);
        let run = folder.heavytop(&["simulate", "--out", "b.csv", "--resume", kept, "--force"]);
        assert_input_is_kept(&run, &folder, &before);
        fs::remove_file(folder.path(kept)).unwrap();
    }
}

/// Runs a command where one of its files has these contents.
fn beside(files: &Files, name: &str, text: &str, more: &[&str]) -> (Folder, Finished) {
    let (folder, place) = folder_with(name);
    fs::write(place, text).unwrap();
    let run = files.run(&folder, "top.toml", more);
    (folder, run)
}

#[test]
fn a_file_that_the_program_has_not_written_is_not_replaced() {
    for files in &FILES {
        for name in files.names() {
            let notes = "my notes\n";
            let (folder, run) = beside(files, &name, notes, &[]);
            let said = run.stderr();
            assert_eq!((run.code(), said.lines().count()), (2, 1), "{name}: {said}");
            assert!(said.contains(" exists, and is not overwritten: it is no "), "{name}: {said}");
            assert!(said.ends_with("choose another name, or replace it with --force\n"), "{said}");
            assert!(said.contains(&name), "{name}: {said}");
            assert_eq!(fs::read_to_string(folder.path("made").join(&name)).unwrap(), notes);
            assert_eq!(contents(&folder).len(), 2, "{name}");
        }
    }
}

/// By force any file is replaced. An empty one has nothing to lose.
#[test]
#[ignore = "long"]
fn force_replaces_a_file_and_an_empty_one_needs_none() {
    for writing in WRITING.iter().filter(|writing| writing.repeats) {
        for (text, more) in [("my notes\n", &["--force"][..]), ("", &[])] {
            let folder = Folder::new();
            for name in writing.files {
                let place = folder.path(name);
                fs::create_dir_all(place.parent().unwrap()).unwrap();
                fs::write(place, text).unwrap();
            }
            writing.assert_repeats(&folder, more);
        }
    }
}

/// Files of other kinds are not of the kind of the output, though the program has written them.
#[test]
#[ignore = "long"]
fn a_file_of_another_kind_is_not_replaced() {
    let of = |name: &str| -> &Writing {
        WRITING
            .iter()
            .find(|writing| writing.files.iter().any(|file| file.ends_with(name)))
            .unwrap()
    };
    for (from, to) in [
        ("section.parquet", "a.parquet"),
        ("a.parquet", "sweep.parquet"),
        ("section.csv", "a.csv"),
        ("section.csv", "sweep.csv"),
        ("sweep.csv", "section.csv"),
        ("a.csv", "summary.csv"),
        ("trajectories.csv", "work-precision.csv"),
    ] {
        let (source, target) = (of(from), of(to));
        let source_name = source.files.iter().find(|file| file.ends_with(from)).unwrap();
        let target_name = target.files.iter().find(|file| file.ends_with(to)).unwrap();
        let folder = Folder::new();
        fs::create_dir_all(folder.path(target_name).parent().unwrap()).unwrap();
        fs::write(folder.path(target_name), &source.undisturbed().files[*source_name]).unwrap();
        let run = target.run(&folder, &[]);
        assert_eq!((run.code(), contents(&folder).len()), (2, 1), "{from} {to}: {}", run.stderr());
        // Control: one of its own kind is replaced.
        if target.repeats {
            fs::write(folder.path(target_name), target.old(target_name)).unwrap();
            target.assert_repeats(&folder, &[]);
        }
    }
}

/// In folders, also in that of unfinished parts, only files with the names of the command's own are touched.
#[test]
#[ignore = "long"]
fn other_files_in_the_folders_of_a_command_stay() {
    for command in ["section", "sweep"] {
        let (folder, _) = folder_with(&format!("{command}.partial/x"));
        let ours = ["made/notes.txt", "made/PARTS/notes.txt", "made/PARTS/12.csv"];
        let ours = ours.map(|name| name.replace("PARTS", &format!("{command}.partial")));
        ours.iter().for_each(|name| folder.write(name, "my notes\n"));
        let few = ["--set", "section.starts=2", "--set", "section.crossings=2", "--quiet"];
        for restart in [&[][..], &["--restart"]] {
            let arguments = [&[command, "top.toml", "--out", "made"], &few[..], restart].concat();
            let run = folder.heavytop(&arguments);
            assert_eq!((run.code(), run.stderr()), (0, String::new()));
            assert!(ours.iter().all(|name| folder.read(name) == "my notes\n"), "{command}");
        }
    }
}

#[test]
fn a_folder_is_no_standard_output() {
    for command in ["reproduce", "compare", "section", "sweep"] {
        let folder = Folder::new();
        let run = folder.heavytop(&[command, "--out", "-"]);
        assert_eq!((run.code(), folder.names().len()), (2, 0), "{}", run.stderr());
        assert!(run.stderr().contains("name a folder, such as ./-"), "{}", run.stderr());
    }
}

/// A table of numbers with the columns t and h, such as heights over times, is not one of a run; nor is that of another
/// system.
#[test]
fn a_table_of_heights_is_not_replaced() {
    let folder = Folder::new();
    folder.write("top.toml", "integrator.end = 0.1\n");
    folder.write("system.toml", &format!("{}\nintegrator.end = 0.1\n", crate::writing::SYSTEM));
    let simulate = |config: &str| folder.heavytop(&["simulate", config, "--out", "a.csv"]);
    for config in ["top.toml", "system.toml"] {
        for header in ["t,h", "t,x,h", "t,x,h,c1", "t,Pi1,Pi2,Pi3,h"] {
            let zeros = vec!["0.0"; header.split(',').count()].join(",");
            let table = format!("{header}\n{zeros}\n");
            for name in ["a.csv", "a.csv.partial"] {
                folder.write(name, &table);
                let run = simulate(config);
                assert_eq!(run.code(), 2, "{config} {header} {name}: {}", run.stderr());
                assert!(run.stderr().contains("table of simulate with these columns"));
                assert_eq!(folder.read(name), table);
                fs::remove_file(folder.path(name)).unwrap();
            }
        }
        // Control: what the same run has written is replaced.
        for _ in 0..2 {
            assert_eq!((simulate(config).code(), folder.names().len()), (0, 3), "{config}");
        }
        fs::remove_file(folder.path("a.csv")).unwrap();
    }
}

/// A run that goes on makes npz and Parquet anew at its end, in a file that may be the user's.
#[test]
fn a_run_that_goes_on_does_not_replace_another_partial_file() {
    for out in ["a.npz", "a.parquet"] {
        let folder = crate::resumption::checkpoint::interrupted(out);
        let partial = format!("{out}.partial");
        folder.write(&partial, "my notes\n");
        let before = contents(&folder);
        let run = folder.heavytop(&["simulate", "--out", out, "--resume"]);
        assert_eq!(run.code(), 2, "{}", run.stderr());
        assert!(run.stderr().contains(" exists, and is not overwritten: "), "{}", run.stderr());
        assert!(contents(&folder) == before, "{out}");
    }
}
