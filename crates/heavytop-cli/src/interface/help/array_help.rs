//! The long texts of `--help` of the commands that read archives of runs.

pub(crate) const PLOT: &str = "\
Draws a run of simulate, as PNG or SVG:
  chain of spins   the third components, or those that vary more, against time
  lattice          a plane at one time: third components as colours, the others as arrows
  fluid            the vorticity at one time, in Mollweide's projection
  vortices         their places at one time, in Mollweide's projection; the tracks of up to 48
  other systems    the coordinates against time, and how far the conserved quantities are from
  and tops         their start: relative to it, or absolute where it is 0; columns that the run
                   of a top was asked for, [output] columns, have panels, too

Of a top or a system by formula it draws, instead of this:
  --columns NAMES   only these columns or arrays, such as theta,Omega, in this order: a panel for
                    each array or unit
  --against NAME    the columns against this one instead of t: a projection of the orbit
  --trace ARRAY     the track of the direction of a vector, such as Gamma, on the sphere; axis is
                    the line from the support of a top to its centre of mass, in space
Without --out the columns, or the first six coordinates, are drawn in the terminal, with the range
of each. An unknown name is an error that lists the names of the run.

What is drawn at one time is a film in a file .gif. All frames have the same scale of colours.";

pub(crate) const PLOT_EXAMPLES: &str = "\
Examples:
  heavytop plot top.npz --columns theta           # in the terminal
  heavytop plot top.npz --out top.svg
  heavytop plot top.npz --out energies.svg --columns kinetic,potential,theta
  heavytop plot top.npz --out portrait.svg --columns Pi2 --against Pi1
  heavytop plot top.npz --out track.svg --trace Gamma
  heavytop plot lattice.npz --out lattice.svg --sample 0 --plane 3
  heavytop plot fluid.npz --out fluid.gif --every 10 --fps 25";

pub(crate) const EXPORT: &str = "\
Writes each sample of the vectors of a run, such as spins on a lattice, to a file of its own that
other programs read. One sample is in memory at a time.
  vti   ParaView: open NAME.pvd, which lists the files NAME_000000.vti and so on with their times
  ovf   OOMMF and Ubermag: NAME_000000.ovf and so on, OVF 2 with 8-byte numbers
The first index of an array is along x. simulate reads a start from such files: initial_file.";

pub(crate) const EXPORT_EXAMPLES: &str = "\
Examples:
  heavytop export lattice.npz --out frames --format vti --every 10
  heavytop export lattice.npz --out fields --format ovf";
