//! Errors of the systems besides the heavy top.

use super::refused;
use collective_integrators::Integrator;
use lie_poisson_systems::{
    Gyrostat, HeisenbergLattice, KidaVortex, Kirchhoff, LatticeMidpoint, ManyVortices, SpinLattice,
    Zeitlin,
};
use nalgebra::{Matrix3, Vector3};

/// Returns the errors of parameters, and that of a state of another size.
pub fn errors() -> Vec<String> {
    let (zero, one) = (Matrix3::zeros(), Matrix3::identity());
    let skewed = Matrix3::new(1.0, 0.5, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0);
    let lattice = |cells| HeisenbergLattice::new([cells, 1, 1]);
    let small = LatticeMidpoint::new(lattice(2).unwrap());
    let mut spins = lattice(3).unwrap().state(|_| Vector3::z());
    vec![
        refused(small.step_in_place(&mut spins, 0.1, &mut Integrator::<f64>::workspace(&small))),
        refused(KidaVortex::new(f64::NAN, 0.0, 0.0)),
        refused(Kirchhoff::new(-one, zero, one)),
        refused(SpinLattice::<3>::new(1.0, -1.0, 1.0, 0.0)),
        refused(KidaVortex::momentum(1e-200, 1.0, 0.0)),
        refused(lattice(0)),
        refused(lattice(usize::MAX)),
        refused(Zeitlin::new(1)),
        refused(ManyVortices::new(vec![1.0; 2]).unwrap().momentum([Vector3::z()])),
        refused(Kirchhoff::new(skewed, zero, one)),
        refused(Gyrostat::new(Vector3::new(1.0, 1.0, 3.0), 1.0, Vector3::z(), Vector3::zeros())),
    ]
}
