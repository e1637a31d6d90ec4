//! The processes that share a sweep: a single one, or those of an MPI job.

use crate::errors::Error;

/// The variables that launchers set: those of Open MPI, of PMIx and of PMI (MPICH, Slurm).
#[cfg(feature = "mpi")]
const LAUNCHED: [&str; 3] = ["OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK"];

/// This process among those that share the work.
pub(super) struct Processes {
    #[cfg(feature = "mpi")]
    universe: Option<mpi::environment::Universe>,
}

impl Processes {
    /// Joins the other processes. A program that was not started by `mpirun` is alone.
    pub fn join() -> Self {
        Self {
            // Only the main thread of a process communicates with the others. To initialise MPI outside a job would
            // start a daemon.
            #[cfg(feature = "mpi")]
            universe: LAUNCHED
                .iter()
                .any(|name| std::env::var_os(name).is_some())
                .then(|| mpi::initialize_with_threading(mpi::Threading::Funneled))
                .flatten()
                .map(|(universe, _)| universe),
        }
    }

    /// Returns the number of this process, from 0, and the number of processes.
    #[cfg(feature = "mpi")]
    pub fn place(&self) -> (u64, u64) {
        use mpi::traits::Communicator;
        self.universe.as_ref().map_or((0, 1), |universe| {
            let world = universe.world();
            (u64::try_from(world.rank()).unwrap_or(0), u64::try_from(world.size()).unwrap_or(1))
        })
    }

    /// Returns the number of this process, from 0, and the number of processes.
    #[cfg(not(feature = "mpi"))]
    pub fn place(&self) -> (u64, u64) {
        (0, 1)
    }

    /// Waits until all processes have come here.
    pub fn wait_for_all(&self) {
        #[cfg(feature = "mpi")]
        if let Some(universe) = &self.universe {
            use mpi::traits::CommunicatorCollectives;
            universe.world().barrier();
        }
    }

    /// Returns the outcome of the sweep. If one of several processes failed, it prints the error and ends all of them, for
    /// the others would wait for it.
    pub fn conclude<T>(&self, outcome: Result<T, Error>) -> Result<T, Error> {
        #[cfg(feature = "mpi")]
        if let (Err(error), Some(universe)) = (&outcome, &self.universe) {
            use mpi::traits::Communicator;
            use std::io::Write;
            let (rank, size) = self.place();
            if size > 1 {
                let message = error.message();
                let _ =
                    writeln!(std::io::stderr(), "heavytop: process {rank} of {size}: {message}");
                universe.world().abort(error.exit_code().into());
            }
        }
        outcome
    }
}
