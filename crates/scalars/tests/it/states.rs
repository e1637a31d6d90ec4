//! The operations of states in place, against the same operations on their coordinates.

use generic_scalars::{
    Blocks, Covector, Pair, Power, Quaternion, Sites, State, Vector, state_of_parts,
};
use nalgebra::{Matrix2, Vector1, Vector2, Vector3};
use num_complex::Complex;

/// A structure of another crate, as a state by the macro.
#[derive(Clone, Debug, PartialEq)]
struct Gyrostat {
    body: Vector3<f64>,
    rotor: Vector1<f64>,
}

state_of_parts!([] Gyrostat, f64, body: Vector3<f64>, rotor: Vector1<f64>);

/// Returns the coordinates of a state.
fn entries<V: State<Scalar = f64>>(v: &V) -> Vec<f64> {
    (0..v.dimension()).map(|i| v.coordinate(i)).collect()
}

/// Returns the state of the space of `like` with the coordinates f(i).
fn with_entries<V: State<Scalar = f64>>(like: &V, f: impl Fn(usize) -> f64) -> V {
    let mut v = like.zeros_like();
    (0..v.dimension()).for_each(|i| v.set_coordinate(i, f(i)));
    v
}

/// Checks every operation of the space of `like` on generic elements.
fn check<V: State<Scalar = f64>>(like: &V) {
    let (f, g) = (|i: usize| 1.0 - 0.3 * i as f64, |i: usize| (0.7 * i as f64 + 0.2).sin());
    let (v, x) = (with_entries(like, f), with_entries(like, g));
    let n = like.dimension();
    assert!(n > 0 && v.same_shape(&x) && v != x);
    assert!((0..n).all(|i| v.block(i) < V::BLOCKS));
    assert_eq!(entries(&v), (0..n).map(f).collect::<Vec<_>>());
    assert_eq!((v.coordinate(n), entries(&v.zeros_like())), (0.0, vec![0.0; n]));

    let mut pool = V::Pool::default();
    let becomes = |what: &dyn Fn(&mut V), expected: &dyn Fn(f64, f64) -> f64| {
        let mut changed = v.clone();
        what(&mut changed);
        assert_eq!(entries(&changed), (0..n).map(|i| expected(f(i), g(i))).collect::<Vec<_>>());
    };
    becomes(&|v| v.set_zero(), &|_, _| 0.0);
    becomes(&|v| v.set_coordinates(&g), &|_, x| x);
    becomes(&|v| v.assign(&x), &|_, x| x);
    becomes(&|v| v.move_from(&mut x.clone()), &|_, x| x);
    becomes(&|v| v.add_in_place(&x), &|v, x| v + x);
    becomes(&|v| v.subtract_in_place(&x), &|v, x| v - x);
    becomes(&|v| v.subtract_from(&x), &|v, x| x - v);
    becomes(&|v| v.negate_in_place(), &|v, _| -v);
    becomes(&|v| v.scale_in_place(1.7), &|v, _| v * 1.7);
    becomes(&|v| v.add_multiple(1.7, &x), &|v, x| v + x * 1.7);
    becomes(&|v| v.replace_where(true, &x), &|_, x| x);
    becomes(&|v| v.replace_where(false, &x), &|v, _| v);
    becomes(&|y| y.add_combination(&[2.0], &[x.clone(), v.clone()]), &|v, x| v + x * 2.0);
    // surplus terms are dropped
    becomes(&|y| y.add_combination(&[2.0, -3.0, 9.0], &[x.clone(), v.clone()]), &|v, x| {
        v + x * 2.0 + v * -3.0
    });

    // A temporary vector belongs to the space, also after one of it was given back.
    for _ in 0..2 {
        let mut temporary = V::take(&mut pool, &v);
        assert!(temporary.same_shape(&v));
        temporary.assign(&x);
        temporary.give(&mut pool);
    }

    measures(&v, &x);
}

/// Checks the sizes of v and of v − x, block by block, and that nothing infinite is overlooked.
fn measures<V: State<Scalar = f64>>(v: &V, x: &V) {
    let measured = |measure: &dyn Fn(&mut V::Blocks, &mut f64)| {
        let (mut largest, mut sum) = (V::Blocks::uniform(0.0), 0.0);
        measure(&mut largest, &mut sum);
        ((0..V::BLOCKS).map(|block| largest.at(block)).collect::<Vec<_>>(), sum)
    };
    let expected = |size: &dyn Fn(usize) -> f64| {
        let mut largest = vec![0.0_f64; V::BLOCKS];
        for i in 0..v.dimension() {
            largest[v.block(i)] = largest[v.block(i)].max(size(i));
        }
        (largest, (0..v.dimension()).map(size).sum::<f64>())
    };
    let size = |i: usize| v.coordinate(i).abs();
    assert_eq!(measured(&|largest, sum| v.measure(largest, sum)), expected(&size));
    let apart = |i: usize| (v.coordinate(i) - x.coordinate(i)).abs();
    assert_eq!(measured(&|largest, sum| v.measure_difference(x, largest, sum)), expected(&apart));
    assert!(v.is_finite());
    for i in 0..v.dimension() {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let mut spoilt = v.clone();
            spoilt.set_coordinate(i, bad);
            assert!(!spoilt.is_finite(), "{i} {bad}");
            let (_, sum) = measured(&|largest, sum| spoilt.measure(largest, sum));
            assert_eq!(sum.is_nan(), bad.is_nan());
        }
        let mut huge = v.clone();
        huge.set_coordinate(i, f64::MAX);
        huge.set_coordinate(0, f64::MAX);
        assert!(huge.is_finite(), "the sum overflows, and the numbers do not");
    }
}

#[test]
fn every_state_computes_coordinate_by_coordinate() {
    check(&Vector3::<f64>::zeros());
    check(&Matrix2::<Complex<f64>>::zeros());
    check(&Quaternion::<f64>::one());
    check(&Covector(Vector2::<f64>::zeros()));
    check(&Pair(Vector2::<f64>::zeros(), Covector(Vector1::<Complex<f64>>::zeros())));
    check(&Power([Pair(Vector1::<f64>::zeros(), Vector2::<f64>::zeros()); 3]));
    check(&Sites::new(vec![Vector3::<f64>::zeros(); 5]));
    check(&Covector(Sites::new(vec![Pair(Vector1::<f64>::zeros(), Vector2::<f64>::zeros()); 2])));
    check(&Pair(Sites::new(vec![Vector2::<f64>::zeros(); 3]), Vector3::<f64>::zeros()));
    check(&Gyrostat { body: Vector3::zeros(), rotor: Vector1::zeros() });
}

/// A state with the default of every method that has one.
#[derive(Clone, Debug, PartialEq)]
struct ByDefault(Vec<f64>);

impl State for ByDefault {
    type Scalar = f64;
    type Blocks = ((f64,), (f64,));
    type Shape = usize;
    type Pool = Vec<Self>;

    fn dimension(&self) -> usize {
        self.0.len()
    }

    fn shape(&self) -> usize {
        self.0.len()
    }

    fn zeros_of(length: &usize) -> Self {
        Self(vec![0.0; *length])
    }

    fn take(pool: &mut Vec<Self>, like: &Self) -> Self {
        pool.pop().filter(|v| v.same_shape(like)).unwrap_or_else(|| like.zeros_like())
    }

    fn give(self, pool: &mut Vec<Self>) {
        pool.push(self);
    }

    fn coordinate(&self, i: usize) -> f64 {
        self.0.get(i).copied().unwrap_or(0.0)
    }

    fn set_coordinate(&mut self, i: usize, x: f64) {
        if let Some(v) = self.0.get_mut(i) {
            *v = x;
        }
    }

    fn block(&self, i: usize) -> usize {
        i % 2
    }

    fn scale_in_place(&mut self, s: f64) {
        self.0.iter_mut().for_each(|v| *v *= s);
    }

    fn add_multiple(&mut self, s: f64, x: &Self) {
        self.0.iter_mut().zip(&x.0).for_each(|(v, x)| *v += x * s);
    }
}

#[test]
fn the_default_methods_compute_coordinate_by_coordinate() {
    check(&ByDefault(vec![0.0; 5]));
}

#[test]
fn no_sites_are_a_space_of_dimension_0() {
    let mut none = Sites::<Vector3<f64>>::new(Vec::new());
    none.set_coordinate(0, 1.0);
    none.add_combination(&[1.0], &[none.clone()]);
    assert_eq!((none.dimension(), none.coordinate(0), none.is_finite()), (0, 0.0, true));
}

#[test]
fn sites_have_the_coordinates_and_the_blocks_of_powers() {
    type Site = Pair<Vector1<f64>, Vector2<f64>>;
    let power = Power::<Site, 4>::from_coordinates(|i| i as f64 + 0.5);
    let sites: Sites<Site> = power.0.into_iter().collect();
    assert_eq!((sites.dimension(), sites.len()), (12, 4));
    for i in 0..12 {
        assert_eq!(sites.coordinate(i), power.coordinate(i));
        assert_eq!(sites.block(i), power.block(i));
    }
    assert_eq!(sites.into_inner(), power.0);
}

#[test]
fn sites_of_different_number_belong_to_different_spaces() {
    let sites = |n| Sites::new(vec![Vector2::<f64>::zeros(); n]);
    assert!(!sites(2).same_shape(&sites(3)));
    // A vector of another space in the pool is not handed out.
    let mut pool = Vec::new();
    sites(2).give(&mut pool);
    assert_eq!(Sites::take(&mut pool, &sites(3)).len(), 3);
}

#[test]
fn both_parts_of_a_pair_go_back_to_the_pool() {
    let pair = Pair(Sites::new(vec![Vector1::new(1.0)]), Sites::new(vec![Vector2::new(3.0, 4.0)]));
    let places = |pair: &Pair<Sites<Vector1<f64>>, Sites<Vector2<f64>>>| {
        (pair.0.as_ptr() as usize, pair.1.as_ptr() as usize)
    };
    let (like, given, mut pool) = (pair.clone(), places(&pair), Default::default());
    pair.give(&mut pool);
    let taken = Pair::take(&mut pool, &like);
    assert!(places(&taken) == given && taken.same_shape(&like));
}

#[test]
fn the_maximum_norm_loses_nothing_that_is_not_finite() {
    let v = Vector3::new(2.0, -5.0, 3.0);
    assert_eq!((v.max_norm(), Vector3::<f64>::zeros().max_norm()), (5.0, 0.0));
    for i in 0..3 {
        let with = |x: f64| {
            let mut v = v;
            v[i] = x;
            v.max_norm()
        };
        assert_eq!([f64::INFINITY, f64::NEG_INFINITY].map(with), [f64::INFINITY; 2]);
        assert!(with(f64::NAN).is_nan());
    }
    // the sum overflows, and the numbers do not
    assert_eq!(Vector3::repeat(-f64::MAX).max_norm(), f64::MAX);
}
