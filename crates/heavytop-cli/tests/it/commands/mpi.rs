//! `heavytop sweep` in an MPI job: the processes share the work, and the bytes do not change.

use crate::program::Folder;
use std::process::{Command, Output};

const GRID: &str = "\
    [sweep]\nobservables = ['megno', 'final-state']\n\
    axes = [{ parameter = 'body.inertia[1]', from = 1, to = 3, count = 40 }, \
    { parameter = 'initial.angular_momentum[2]', from = 0, to = 4, count = 40 }]\n\
    [integrator]\nformulation = 'reduced'\nscheme = 'gauss-4'\nstep = 0.1\nend = 0.5";

const SYSTEM: &str = "\
    [system]\nalgebra = 'so(3)'\nhamiltonian = '(Pi1^2/I1 + Pi2^2/I2 + Pi3^2/I3)/2'\n\
    parameters.I = [3, 2, 1]\ninitial.Pi = [0.1, 1, 0.2]\n\
    [sweep]\nobservables = ['megno', 'invariant-drift']\n\
    axes = [{ parameter = 'system.parameters.I[1]', from = 1, to = 3, count = 40 }, \
    { parameter = 'system.initial.Pi[2]', from = 0, to = 1, count = 40 }]\n\
    [integrator]\nscheme = 'gauss-4'\nstep = 0.1\nend = 0.5";

fn mpirun(folder: &Folder, processes: u32, arguments: &[&str]) -> Output {
    let mut command = Command::new("mpirun");
    command.args(["--oversubscribe", "-n", &processes.to_string()]);
    command.arg(env!("CARGO_BIN_EXE_heavytop")).args(arguments).current_dir(folder.path("."));
    // In a container the tests may run as root, which Open MPI must be told twice.
    command.env("OMPI_ALLOW_RUN_AS_ROOT", "1").env("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1");
    command.env("RAYON_NUM_THREADS", "1").output().unwrap()
}

#[test]
fn no_bit_depends_on_the_number_of_processes() {
    for configuration in [GRID, SYSTEM] {
        let folder = Folder::new();
        folder.write("a.toml", configuration);
        let alone = folder.heavytop(&["sweep", "a.toml", "--out", "alone"]);
        assert_eq!(alone.code(), 0, "{}", alone.stderr());
        for processes in [1, 2, 4] {
            let name = processes.to_string();
            let run = mpirun(&folder, processes, &["sweep", "a.toml", "--out", &name]);
            assert!(run.status.success(), "{run:?}");
            for file in ["sweep.parquet", "megno.svg", "megno.png"] {
                let read = |name: &str| std::fs::read(folder.path(name).join(file)).unwrap();
                assert!(read("alone") == read(&name), "{processes}: {file}");
            }
            assert!(!folder.path(&name).join("sweep.partial").exists());
        }
    }
}

#[test]
fn a_process_that_fails_says_why_and_ends_the_job_and_tiles_survive() {
    let folder = Folder::new();
    folder.write("a.toml", GRID);
    // Tile 3 belongs to process 1 of 2, and cannot be written where there is a folder.
    std::fs::create_dir_all(folder.path("cut/sweep.partial/0000003")).unwrap();
    let run = mpirun(&folder, 2, &["sweep", "a.toml", "--out", "cut"]);
    let said = String::from_utf8_lossy(&run.stderr);
    assert!(!run.status.success());
    assert!(said.contains("heavytop: process 1 of 2: "), "{said}");
    assert!(said.contains("0000003"), "{said}");
    assert!(folder.path("cut/sweep.partial/0000001").exists());

    std::fs::remove_dir(folder.path("cut/sweep.partial/0000003")).unwrap();
    let resumed = mpirun(&folder, 2, &["sweep", "a.toml", "--out", "cut", "--resume"]);
    assert!(resumed.status.success(), "{resumed:?}");
    assert_eq!(folder.heavytop(&["sweep", "a.toml", "--out", "alone"]).code(), 0);
    let bytes = |name: &str| std::fs::read(folder.path(name).join("sweep.parquet")).unwrap();
    assert!(bytes("cut") == bytes("alone"));
}

#[test]
fn a_wrong_request_ends_the_job_with_its_reason() {
    let folder = Folder::new();
    folder.write("a.toml", "sweep.axes = []");
    let run = mpirun(&folder, 2, &["sweep", "a.toml", "--out", "made"]);
    assert_eq!(run.status.code(), Some(2), "{run:?}");
    let said = String::from_utf8_lossy(&run.stderr);
    assert!(said.contains("[sweep] axes must have at least one axis"), "{said}");
    assert_eq!(folder.names(), ["a.toml"]);
}
