//! Matrices of size 33, whose products take other kernels than those up to 16, and Hermitian ones two panels of 24 and 9
//! columns: a block of a matrix that is zero beside its blocks moves as the small matrix of the block does.

use crate::examples::{Quadratic, casimirs, generic};
use isospectral_flows::collective_integrators::{RungeKutta, Start};
use isospectral_flows::{
    ExponentialMidpoint, GaussMagnus, IsospectralField, IsospectralRungeKutta, LargeSkewHermitian,
};
use num_complex::Complex;

const SIZE: usize = 33;

/// The first rows of the blocks, and the end: the second block lies across the first panel, the last one in the second.
const BLOCKS: [usize; 4] = [0, 20, 27, SIZE];

/// The field of [`Quadratic`] of the rows from `first` on.
struct Block {
    first: usize,
    size: usize,
}

impl IsospectralField for Block {
    fn size(&self) -> usize {
        self.size
    }

    fn generator_into(&self, w: &LargeSkewHermitian, b: &mut LargeSkewHermitian) {
        let (n, first) = (self.size, self.first);
        b.change_upper(|re, im| {
            for i in 0..n * n {
                let (j, k) = (i % n, i / n);
                let value = w.at(j, k) * Quadratic::factor(first + j, first + k);
                (re[i], im[i]) = (value.re, value.im);
            }
        });
    }
}

/// Returns the blocks of the matrix that is zero beside them.
fn blocks() -> Vec<(Block, LargeSkewHermitian)> {
    let block = |ends: &[usize]| {
        let size = ends[1] - ends[0];
        (Block { first: ends[0], size }, generic(size, 0.3 + ends[0] as f64))
    };
    BLOCKS.windows(2).map(block).collect()
}

fn whole() -> LargeSkewHermitian {
    let blocks = blocks();
    LargeSkewHermitian::from_upper(SIZE, |j, k| {
        let inside = |(block, _): &&(Block, _)| {
            (block.first..block.first + block.size).contains(&j)
                && (block.first..block.first + block.size).contains(&k)
        };
        let found = blocks.iter().find(inside);
        found.map_or(Complex::ZERO, |(block, w)| w.at(j - block.first, k - block.first))
    })
}

const STEP: f64 = 0.05;

/// Compares a step of the whole with those of the blocks.
fn moves_as_its_blocks<I, J>(name: &str, of_whole: I, of_block: impl Fn(Block) -> J)
where
    I: Start<State = LargeSkewHermitian, Momentum = LargeSkewHermitian>,
    J: Start<State = LargeSkewHermitian, Momentum = LargeSkewHermitian>,
{
    let start = whole();
    let end = of_whole.after(&start, STEP, 1).unwrap().state;
    let mut beside = end.clone();
    for (block, w) in blocks() {
        let (first, size) = (block.first, block.size);
        let expected = of_block(block).after(&w, STEP, 1).unwrap().state;
        let apart = |other: &LargeSkewHermitian| {
            let places = (0..size).flat_map(|j| (0..size).map(move |k| (j, k)));
            let error = |(j, k)| (end.at(first + j, first + k) - other.at(j, k)).norm();
            places.map(error).fold(0.0, f64::max)
        };
        // The stages are solved to some units of round-off of entries up to √2, in sums of up to 33 terms.
        assert!(apart(&expected) < 1e-13, "{name}: {:e}", apart(&expected));
        // Control: the block moves, by far more than the bound; the last ones have small generators.
        assert!(apart(&w) > 1e-6, "{name}: {:e}", apart(&w));
        beside = LargeSkewHermitian::from_upper(SIZE, |j, k| {
            let inside = |i: &usize| (first..first + size).contains(i);
            if inside(&j) && inside(&k) { Complex::ZERO } else { beside.at(j, k) }
        });
    }
    assert!(beside.norm() < 1e-14, "{name}: {:e}", beside.norm());
    // Some ten roundings of the traces of the powers, which are below 1, in each of up to 33 products.
    let pairs = casimirs(&start, start.norm()).into_iter().zip(casimirs(&end, start.norm()));
    let change = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(change < 33.0 * 16.0 * f64::EPSILON, "{name}: {change:e}");
}

#[test]
fn matrices_move_as_their_blocks_do() {
    let field = || Quadratic(SIZE);
    let gauss = || RungeKutta::gauss(2).unwrap();
    moves_as_its_blocks("Gauss", IsospectralRungeKutta::new(gauss(), field()), |block| {
        IsospectralRungeKutta::new(gauss(), block)
    });
    moves_as_its_blocks("Magnus", GaussMagnus::new(3, field()).unwrap(), |block| {
        GaussMagnus::new(3, block).unwrap()
    });
    moves_as_its_blocks("exponential", ExponentialMidpoint::new(field()), ExponentialMidpoint::new);
}
