//! exploration
use lie_poisson::*;
use momentum_map::laws;
use momentum_map::*;
use nalgebra::SVector;
use workspace_tests::low_dimensional::{Entry, FIVE, FOUR, THREE, TWO, table};

fn sample<const N: usize>(seed: usize) -> Covector<SVector<f64, N>> {
    Covector(SVector::from_fn(|i, _| ((i * i + 3 * i + 7 * seed + 1) as f64 * 0.7).sin()))
}

fn explore<const N: usize>(entry: &Entry) {
    let a = table::<N>(entry, 1.0).unwrap();
    let ad = InfinitesimalAdjoint(a.clone());
    let ext = ExtendedAdjoint::of(a.clone()).unwrap();
    let rank = |r: usize| r;
    let r1 = rank(clebsch_realisation(ad.clone(), Side::Left).unwrap().fibres().rank());
    let r2 = rank(
        clebsch_realisation(Diagonal::<_, 2>(ad.clone()), Side::Left).unwrap().fibres().rank(),
    );
    let r5 = rank(
        clebsch_realisation(Diagonal::<_, 5>(ad.clone()), Side::Left).unwrap().fibres().rank(),
    );
    let e1 = rank(clebsch_realisation(ext.clone(), Side::Left).unwrap().fibres().rank());
    let e2 = rank(
        clebsch_realisation(Diagonal::<_, 2>(ext.clone()), Side::Left).unwrap().fibres().rank(),
    );
    let e3 = rank(
        clebsch_realisation(Diagonal::<_, 3>(ext.clone()), Side::Left).unwrap().fibres().rank(),
    );
    let one = clebsch_realisation(ad.clone(), Side::Left).unwrap();
    let x1 = clebsch_realisation(ext.clone(), Side::Left).unwrap();
    let mut line = String::new();
    for seed in 0..4 {
        let mu = sample::<N>(seed);
        let show = |r: Result<f64, LiftError>| match r {
            Ok(x) => format!("{x:.0e}"),
            Err(e) => format!("!{:.0e}", e.value),
        };
        line += &show(one.lift::<f64>(&mu).map(|z| (one.apply(&z) - mu).max_abs()));
        line += "/";
        line += &show(x1.lift::<f64>(&mu).map(|z| (x1.apply(&z) - mu).max_abs()));
        line += " ";
    }
    println!(
        "{} N={N} ad rank {r1} {r2} {r5}; ext {e1} {e2} {e3}; odd ad {:.1e} ext {:.1e}; one/ext1 {line}",
        entry.name,
        odd_power_defect(&ad),
        odd_power_defect(&ext)
    );
}

#[test]
fn exploration() {
    TWO.iter().for_each(explore::<2>);
    THREE.iter().for_each(explore::<3>);
    FOUR.iter().for_each(explore::<4>);
    FIVE.iter().for_each(explore::<5>);
}
