//! Fibres of one's own, attached to the momentum map of an action by [`Realisation`].

use crate::support::{TOLERANCE, holds, laws, samples};
use lie_poisson::*;
use momentum_map::*;
use nalgebra::Vector2;

/// The momentum map J(q, p) = −(q₁p₂ − q₂p₁, p) of the right action of SE(2) on the plane.
type Map = MomentumMap<Opposite<AffineAction<SO2OnR2>>>;

const MAP: Map = MomentumMap(Opposite(AffineAction(SO2OnR2)));

/// The fibres q + sp with the lift for p = −sign Γ, which is right for the sign +1.
#[derive(Clone)]
struct Lines {
    sign: f64,
}

/// Returns the displacement of q along p by a quarter of −⟨q, p⟩/⟨p, p⟩.
fn along<T: Real>(z: &SourcePoint<Map, T>) -> SourcePoint<Map, T> {
    let p = z.p.0;
    let square = p.dot(&p) + 1e-300;
    Cotangent::new(p * (-(z.q.dot(&p) / square) * 0.25), Covector(Vector2::zeros()))
}

impl Fibres<Map> for Lines {
    const COUNT: usize = 1;

    fn gauge<T: Real>(&self, _: &Map, z: &SourcePoint<Map, T>) -> SourcePoint<Map, T> {
        along(z)
    }

    fn recentred<T: Real>(
        &self,
        _: &Map,
        z: &SourcePoint<Map, T>,
        _: &mut RecentringWorkspace<T>,
    ) -> SourcePoint<Map, T> {
        *z + along(z).scaled(T::from_f64(4.0))
    }

    fn lift<T: Real>(
        &self,
        _: &Map,
        mu: &TargetPoint<Map, T>,
    ) -> Result<SourcePoint<Map, T>, LiftError> {
        let Covector(Pair(pi, gamma)) = *mu;
        let q = Vector2::new(gamma.y, -gamma.x) * (pi.x / gamma.dot(&gamma));
        let z = Cotangent::new(q, Covector(gamma * T::from_f64(-self.sign)));
        LiftError::unless_finite(z, "Γ", 0.0, "Γ must be different from 0")
    }

    fn flow<T: Real>(
        &self,
        _: &Map,
        index: usize,
        s: T,
        z: &SourcePoint<Map, T>,
    ) -> SourcePoint<Map, T> {
        if index > 0 { *z } else { Cotangent::new(z.q + z.p.0 * s, z.p) }
    }

    fn momentum<T: Real>(&self, _: &Map, index: usize, z: &SourcePoint<Map, T>) -> T {
        if index > 0 { T::zero() } else { z.p.0.dot(&z.p.0) * (0.5 * self.sign) }
    }
}

/// A description of fibres with every method left to its default, but for the lift.
#[derive(Clone)]
struct Silent;

impl Fibres<Map> for Silent {
    fn lift<T: Real>(
        &self,
        map: &Map,
        mu: &TargetPoint<Map, T>,
    ) -> Result<SourcePoint<Map, T>, LiftError> {
        Lines { sign: 1.0 }.lift(map, mu)
    }
}

#[test]
fn attached_fibres_obey_the_laws() {
    let map = Realisation::new(MAP, Lines { sign: 1.0 });
    let points = samples();
    let momenta: Vec<_> = points.iter().map(|z| map.apply::<f64>(z)).collect();
    holds(laws::poisson_map(&map, &points).unwrap());
    holds(laws::fibre_symmetry(&map, &points, &[0.3, -1.2]).unwrap());
    laws::lift(&map, &momenta).unwrap().check(10.0 * TOLERANCE).unwrap();
    for z in points {
        assert_eq!(map.apply::<f64>(&z), MAP.apply::<f64>(&z));
        let near = map.recentred::<f64>(&z, &mut RecentringWorkspace::default());
        assert!(near.q.dot(&near.p.0).abs() < 1e-14, "recentred by the attached fibres");
        assert!(map.gauge::<f64>(&z) == along(&z) && along(&z).max_abs() > 0.0);
    }
    // Every scalar has the lift.
    let alone = map.lift::<f64>(&momenta[0]).unwrap();
    let lanes = map.lift::<DefaultLanes>(&map_coordinates(&momenta[0], Real::from_f64)).unwrap();
    assert_eq!(map_coordinates::<_, SourcePoint<Map>>(&lanes, |x| x.lane(3)), alone);
}

#[test]
fn silent_fibres_leave_the_map_as_it_is() {
    let map = Realisation::new(MAP, Silent);
    for z in samples() {
        assert_eq!(map.gauge::<f64>(&z), MAP.gauge::<f64>(&z));
        assert_eq!((map.flow(0, 0.5, &z), map.momentum(0, &z)), (z, 0.0));
        let spaces = &mut (RecentringWorkspace::default(), RecentringWorkspace::default());
        let far = Cotangent::new(z.q + z.p.0 * 1e4, z.p);
        let near = map.recentred::<f64>(&far, &mut spaces.0);
        assert_eq!(near, MAP.recentred::<f64>(&far, &mut spaces.1));
    }
}

/// A negative control: the laws see a lift and a momentum with the wrong sign.
#[test]
fn attached_fibres_with_a_wrong_sign_are_refused() {
    let map = Realisation::new(MAP, Lines { sign: -1.0 });
    let momenta: Vec<_> = samples().iter().map(|z| map.apply::<f64>(z)).collect();
    assert!(laws::lift(&map, &momenta).unwrap().residual("section").unwrap() > 0.1);
    let report = laws::fibre_symmetry(&map, &samples(), &[0.3]).unwrap();
    assert!(report.residual("momentum").unwrap() > 0.1);
    assert!(report.residual("invariance").unwrap() < TOLERANCE);
}
