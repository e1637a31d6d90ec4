//! The long texts of `--help` of the program, and of the commands about it.

pub(crate) const EXIT_CODES: &str = "\
Exit codes:
  0  done
  1  the run failed: a stage equation did not converge, a state is not finite, all tops of a sweep
     failed, or disk or memory is full; what was computed until then is kept as FILE.partial, or,
     where there is a FILE.checkpoint or no room, as the run had it; the message says where
  2  the request is wrong, or another run is writing the output; nothing was written
  130  interrupted by Ctrl-C, or asked to end by SIGTERM; simulate, section and sweep go on with
     --resume, of the others nothing is left

No output is a file that the command reads, by any link. An existing file is replaced if it is
empty, or if the program has written it before, as one of the same kind (a table of a system in CSV,
with the same columns); any other only with --force.

Files appear under their name only when they are complete. Until then they are locked: a second run
on the same output is refused. A run that was killed keeps nobody out. (Some network file systems
have no locks; there runs must be kept apart.)";

pub(crate) const COMPLETIONS_EXAMPLES: &str = "\
Examples:
  heavytop completions bash > ~/.local/share/bash-completion/completions/heavytop
  heavytop completions zsh > ~/.zfunc/_heavytop
  heavytop completions fish > ~/.config/fish/completions/heavytop.fish";

pub(crate) const INIT_EXAMPLES: &str = "\
Examples:
  heavytop init top.toml                          # the paper's top
  heavytop init --preset lagrange top.toml
  heavytop init --for sweep map.toml              # many tops, and a map of order and chaos
  heavytop init --kind vortices a.toml            # a system by name
  heavytop init --kind driven-top a.toml          # with forces; or stochastic-rigid-body
  heavytop init > top.toml
A file that has been edited is replaced with --force only.
A system that is no top has a table [system]: heavytop simulate --help shows some.";

pub(crate) const MAN_EXAMPLES: &str = "\
Examples:
  heavytop man | man -l -
  heavytop man simulate > ~/.local/share/man/man1/heavytop-simulate.1";
