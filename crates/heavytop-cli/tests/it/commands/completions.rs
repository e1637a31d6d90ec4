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
fn fish_completes_commands_options_and_presets() {
    let folder = completions("fish");
    let lines = ["sec", "simulate --dry", "simulate --preset gory", "section --rest", "xyz"];
    for (line, expected) in
        lines.iter().zip(["section", "--dry-run", "goryachev-chaplygin", "--restart", ""])
    {
        let script = format!("source ./completions\ncomplete --do-complete 'heavytop {line}'");
        let Some(said) = in_shell("fish", &folder, &script) else { return };
        let words: Vec<&str> = said.lines().filter_map(|line| line.split('\t').next()).collect();
        let expected: Vec<&str> = Some(expected).into_iter().filter(|e| !e.is_empty()).collect();
        assert_eq!(words, expected, "{line}: {said}");
    }
}

#[test]
fn zsh_completes_commands_options_and_presets() {
    let folder = completions("zsh");
    // The name by which zsh finds the completions of heavytop.
    folder.write("_heavytop", &folder.read("completions"));
    // Completion needs a terminal: the module zpty makes one, into which the script types each line and the tab key.
    let script = r#"
        zmodload zsh/zpty
        zpty shell zsh -f -i
        zpty -w shell 'fpath=($PWD $fpath); autoload -U compinit; compinit -D -u'
        zpty -w shell 'function heavytop { print -r -- "GOT $* END" }; print READY$((1))'
        zpty -r -m shell line '*READY1*'
        for typed in 'sec' 'simulate --dry' 'simulate --preset gory' 'section --rest' 'xyz'; do
            zpty -w -n shell "heavytop $typed"$'\t\n'
            zpty -r -m shell line '*GOT *END*'
            print -r -- ${${line##*GOT }%% END*}
        done
    "#;
    let Some(said) = in_shell("zsh", &folder, script) else { return };
    let expected = "section\nsimulate --dry-run\nsimulate --preset goryachev-chaplygin\n\
                    section --restart\nxyz\n";
    assert_eq!(said, expected);
}
