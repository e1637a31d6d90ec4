//! The pool of storage for evaluations of a vector field: each evaluation has storage of its own.

use collective_integrators::StoragePool;
use std::sync::Barrier;
use std::thread;

/// Two evaluations at the same time, which wait for each other, do not see what the other writes.
#[test]
fn evaluations_at_the_same_time_have_different_storage() {
    let pool: StoragePool<Vec<usize>> = StoragePool::default();
    let (both, pool) = (Barrier::new(2), &pool);
    thread::scope(|scope| {
        for number in 0..2 {
            let both = &both;
            scope.spawn(move || {
                pool.with(|storage| {
                    storage.push(number);
                    both.wait();
                    assert_eq!(*storage, [number]);
                    both.wait();
                });
            });
        }
    });
    // Afterwards both are there to be used again, with what was left in them.
    let left = pool.with(|first| pool.with(|second| [first.clone(), second.clone()].concat()));
    assert_eq!(left.iter().sum::<usize>(), 1, "{left:?}");
    assert_eq!(left.len(), 2);
}

#[test]
fn storage_is_used_again_and_a_clone_is_empty() {
    let pool: StoragePool<Vec<f64>> = StoragePool::default();
    pool.with(|storage| storage.push(1.0));
    assert_eq!(pool.with(|storage| storage.len()), 1);
    let clone = pool.clone();
    assert_eq!(clone.with(|storage| storage.len()), 0);
    // What is in the storage is no part of the value of a field.
    assert!(pool == clone);
}

/// A panic of one evaluation loses its own storage, and no other.
#[test]
fn a_panic_leaves_the_pool_in_use() {
    let pool: StoragePool<Vec<f64>> = StoragePool::default();
    pool.with(|storage| storage.push(1.0));
    let panicked =
        thread::scope(|scope| scope.spawn(|| pool.with(|_| panic!("an evaluation fails"))).join());
    assert!(panicked.is_err());
    assert_eq!(pool.with(|storage| storage.len()), 0);
}
