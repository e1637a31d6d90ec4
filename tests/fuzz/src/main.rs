//! `unpack TARGET FOLDER` writes a file for each case of a corpus, as a fuzzer reads them; `pack TARGET FOLDER` makes the
//! corpus from them.

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::{env, fs, io};

fn corpus(target: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("corpus").join(format!("{target}.txt"))
}

fn unpack(target: &str, folder: &Path) -> io::Result<()> {
    fs::create_dir_all(folder)?;
    let text = fs::read_to_string(corpus(target)).unwrap_or_default();
    for (number, case) in fuzz_targets::cases(&text).iter().enumerate() {
        fs::write(folder.join(format!("{number:04}")), case)?;
    }
    Ok(())
}

fn pack(target: &str, folder: &Path) -> io::Result<()> {
    let mut lines = Vec::new();
    for entry in fs::read_dir(folder)? {
        lines.push(fuzz_targets::line(&fs::read(entry?.path())?) + "\n");
    }
    // In the order of their lengths a change of the corpus changes few lines.
    lines.sort_by(|a, b| (a.len(), a).cmp(&(b.len(), b)));
    lines.dedup();
    fs::write(corpus(target), lines.concat())
}

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let done = match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["unpack", target, folder] => unpack(target, folder.as_ref()),
        ["pack", target, folder] => pack(target, folder.as_ref()),
        _ => Err(io::Error::other("arguments: unpack TARGET FOLDER, or pack TARGET FOLDER")),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}
