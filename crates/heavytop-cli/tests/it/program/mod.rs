//! The program in a folder of its own, for the tests that run it. No test file needs all of this.
#![allow(dead_code)]

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::sync::OnceLock;
use tempfile::TempDir;

/// Returns the program under test, which is a release where there is one, since that makes long runs in a fraction of the
/// time: the program that the variable `HEAVYTOP_PROGRAM` names; the release beside the tests, if it is no older than its
/// sources; the program in the profile of the tests.
pub fn heavytop() -> &'static str {
    static PROGRAM: OnceLock<String> = OnceLock::new();
    let compiled = env!("CARGO_BIN_EXE_heavytop");
    PROGRAM.get_or_init(|| {
        let named = std::env::var("HEAVYTOP_PROGRAM").ok();
        named.or_else(|| release(Path::new(compiled))).unwrap_or_else(|| compiled.to_owned())
    })
}

/// Returns the release in the target folder of this program, if it comes from these sources, and none of them, nor the manifest or the
/// lock file of the workspace, has changed since it was linked.
fn release(compiled: &Path) -> Option<String> {
    // A release need not have this feature.
    if cfg!(feature = "mpi") {
        return None;
    }
    let changed = |path: &Path| path.metadata().and_then(|found| found.modified()).ok();
    let release = compiled.ancestors().nth(2)?.join("release").join(compiled.file_name()?);
    let made = changed(&release)?;
    let sources = std::fs::read_to_string(release.with_extension("d")).ok()?;
    let (_, sources) = sources.split_once(": ")?;
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let manifests = ["Cargo.toml", "../../Cargo.toml", "../../Cargo.lock"];
    let manifests = manifests.map(|name| folder.join(name));
    // A path with a space is not found in this list: then the release is not taken.
    let sources: Vec<PathBuf> = sources.split_whitespace().map(PathBuf::from).collect();
    let mut all = sources.iter().chain(&manifests);
    let is_current = sources.contains(&folder.join("src/main.rs"))
        && all.all(|path| changed(path).is_some_and(|changed| changed <= made));
    is_current.then(|| release.display().to_string())
}

#[test]
#[cfg(not(feature = "mpi"))]
fn a_release_is_taken_if_it_comes_from_these_sources_and_is_newer() {
    let folder = Folder::new();
    std::fs::create_dir_all(folder.path("debug")).unwrap();
    std::fs::create_dir_all(folder.path("release")).unwrap();
    let [compiled, made] = ["debug/heavytop", "release/heavytop"].map(|name| folder.path(name));
    assert_eq!(release(&compiled), None);
    folder.write("release/heavytop", "");
    let own = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/main.rs");
    folder.write("release/heavytop.d", &format!("{}: {}\n", made.display(), own.display()));
    assert_eq!(release(&compiled), Some(made.display().to_string()));
    // Another checkout shares the folder.
    folder.write("other.rs", "");
    let other = folder.path("other.rs");
    folder.write("release/heavytop.d", &format!("{}: {}\n", made.display(), other.display()));
    assert_eq!(release(&compiled), None);
    // A source has changed since.
    folder.write("release/heavytop.d", &format!("{}: {}\n", made.display(), own.display()));
    let old = std::fs::File::options().write(true).open(&made).unwrap();
    old.set_modified(std::time::UNIX_EPOCH).unwrap();
    assert_eq!(release(&compiled), None);
}

/// A folder that is removed with its contents when the test ends.
pub struct Folder(TempDir);

impl Folder {
    pub fn new() -> Self {
        Self(TempDir::new().unwrap())
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub fn write(&self, name: &str, text: &str) {
        std::fs::write(self.path(name), text).unwrap();
    }

    pub fn read(&self, name: &str) -> String {
        std::fs::read_to_string(self.path(name)).unwrap()
    }

    /// Returns the names in the folder, sorted.
    pub fn names(&self) -> Vec<String> {
        let entries = std::fs::read_dir(self.0.path()).unwrap();
        let mut names: Vec<String> =
            entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    /// Runs `heavytop` with these arguments in the folder.
    pub fn heavytop(&self, arguments: &[&str]) -> Finished {
        Finished(self.command(arguments).output().unwrap())
    }

    /// Runs `heavytop` with these arguments in the folder, on so many threads.
    pub fn heavytop_on(&self, threads: &str, arguments: &[&str]) -> Finished {
        Finished(self.command(arguments).env("RAYON_NUM_THREADS", threads).output().unwrap())
    }

    /// Runs `heavytop` with these arguments in the folder, and with this text as its standard input.
    pub fn heavytop_fed(&self, text: &str, arguments: &[&str]) -> Finished {
        let mut command = self.command(arguments);
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = command.spawn().unwrap();
        // The program may end before it has read everything.
        let _ = child.stdin.take().unwrap().write_all(text.as_bytes());
        Finished(child.wait_with_output().unwrap())
    }

    /// Starts `heavytop` with these arguments in the folder.
    pub fn start(&self, arguments: &[&str]) -> Child {
        self.command(arguments).stderr(Stdio::piped()).spawn().unwrap()
    }

    /// Starts `heavytop` with these arguments in the folder, and keeps its standard output too.
    pub fn start_piped(&self, arguments: &[&str]) -> Child {
        let mut command = self.command(arguments);
        command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap()
    }

    fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(heavytop());
        command.args(arguments).current_dir(self.0.path());
        command
    }
}

/// The exit code and the output of a finished run.
pub struct Finished(Output);

impl Finished {
    pub fn of(output: Output) -> Self {
        Self(output)
    }

    pub fn code(&self) -> i32 {
        self.0.status.code().unwrap()
    }

    pub fn stdout(&self) -> String {
        String::from_utf8(self.0.stdout.clone()).unwrap()
    }

    pub fn stderr(&self) -> String {
        String::from_utf8(self.0.stderr.clone()).unwrap()
    }

    /// Returns what is on stderr besides the closing line, the notes on the configuration after it, and the warning about
    /// the accuracy of the motion, which depends on the configuration alone.
    pub fn complaints(&self) -> String {
        let expected = ["heavytop: done", "heavytop: left out, "];
        let is_expected = |line: &str| {
            expected.iter().any(|text| line.starts_with(text)) || is_about_accuracy(line)
        };
        self.stderr().split_inclusive('\n').filter(|line| !is_expected(line)).collect()
    }

    /// Returns the number of messages, each with the lines that it quotes, without the warning about the accuracy.
    pub fn messages(&self) -> usize {
        let is_message = |line: &&str| line.starts_with("heavytop: ") && !is_about_accuracy(line);
        self.stderr().lines().filter(is_message).count()
    }
}

/// Returns whether a line is the warning about the accuracy of the motion.
pub fn is_about_accuracy(line: &str) -> bool {
    line.starts_with("heavytop: warning: ") && line.contains("the motion turns by ")
}

/// Runs a shell command in a terminal, types the answer, and returns all that the terminal shows; `None`, with a message,
/// where there is no `script` that makes terminals.
pub fn in_terminal(folder: &Folder, command: &str, answer: &str) -> Option<String> {
    let mut terminal = Command::new("script");
    terminal.args(["-q", "-e", "-c", command, "/dev/null"]).current_dir(folder.path("."));
    terminal.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let Ok(mut child) = terminal.spawn() else {
        println!("skipped: there is no script here");
        return None;
    };
    let mut typed = child.stdin.take().unwrap();
    typed.write_all(answer.as_bytes()).unwrap();
    let done = child.wait_with_output().unwrap();
    drop(typed);
    Some(String::from_utf8_lossy(&done.stdout).into_owned())
}

/// Reads the header and the numbers of a table whose cells are all numbers.
pub fn numbers(csv: &str) -> (Vec<String>, Vec<Vec<f64>>) {
    let mut lines = csv.lines();
    let header = lines.next().unwrap().split(',').map(String::from).collect();
    let parse = |line: &str| line.split(',').map(|cell| cell.parse().unwrap()).collect();
    (header, lines.map(parse).collect())
}
