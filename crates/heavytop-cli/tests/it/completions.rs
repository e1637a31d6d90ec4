//! `heavytop completions`: the scripts work in the shells themselves.
#![cfg(unix)]

use crate::program::Folder;
use std::process::Command;

/// Runs the script in a shell and returns what it prints; `None`, with a message, if the shell is not installed.
fn in_shell(shell: &str, folder: &Folder, script: &str) -> Option<String> {
    folder.write("script", script);
    let done = Command::new(shell).arg("script").current_dir(folder.path(".")).output();
    let Ok(done) = done else {
        println!("skipped: there is no {shell} here");
        return None;
    };
    let said = String::from_utf8(done.stderr).unwrap();
    assert!(done.status.success() && said.is_empty(), "{shell}: {said}");
    Some(String::from_utf8(done.stdout).unwrap())
}

/// Returns a folder with the completions of a shell.
fn completions(shell: &str) -> Folder {
    let folder = Folder::new();
    let run = folder.heavytop(&["completions", shell]);
    assert_eq!((run.code(), run.stderr()), (0, String::new()));
    folder.write("completions", &run.stdout());
    folder
}

#[test]
fn bash_completes_commands_options_presets_and_nothing_else() {
    let folder = completions("bash");
    // Each line holds the text before the cursor, and the completions.
    let script = r#"
        source ./completions
        function try {
            COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); COMPREPLY=()
            local command=$(complete -p heavytop | sed 's/.*-F \([^ ]*\).*/\1/')
            $command heavytop "${COMP_WORDS[COMP_CWORD]}" "${COMP_WORDS[COMP_CWORD-1]}"
            echo "$*: ${COMPREPLY[*]}"
        }
        try heavytop se
        try heavytop sw
        try heavytop section --resu
        try heavytop sweep --rest
        try heavytop simulate --preset go
        try heavytop completions fi
        try heavytop xyz
    "#;
    let Some(said) = in_shell("bash", &folder, script) else { return };
    let expected = "\
        heavytop se: section\n\
        heavytop sw: sweep\n\
        heavytop section --resu: --resume\n\
        heavytop sweep --rest: --restart\n\
        heavytop simulate --preset go: goryachev-chaplygin\n\
        heavytop completions fi: fish\n\
        heavytop xyz: \n";
    assert_eq!(said, expected);
}

#[test]
fn fish_completes_commands() {
    let folder = completions("fish");
    let script = "source ./completions\ncomplete --do-complete 'heavytop sec'";
    let Some(said) = in_shell("fish", &folder, script) else { return };
    assert!(said.starts_with("section\t") && said.lines().count() == 1, "{said}");
}

#[test]
fn zsh_has_the_commands() {
    let folder = completions("zsh");
    // Completion itself needs a terminal; the test reads what `_describe` receives.
    let script = "\
        autoload -U compinit; compinit -D\n\
        source ./completions 2>/dev/null\n\
        function _describe { print -l ${(P)4} }\n\
        _heavytop_commands";
    let Some(said) = in_shell("zsh", &folder, script) else { return };
    assert!(said.lines().any(|line| line.starts_with("section:")), "{said}");
}
