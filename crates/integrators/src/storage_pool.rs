//! Storage for the evaluations of a vector field: [`StoragePool`].

use std::sync::{Mutex, PoisonError};

/// Storage for the evaluations of a [`VectorField`](crate::VectorField): a separate one for each evaluation that runs
/// at the same time.
///
/// A field is evaluated through a shared reference, also on several threads. A large field that needs storage keeps it
/// here, so that evaluations allocate nothing after the first and no thread waits for another. What the storage
/// contains between evaluations does not matter: any two pools are equal, and a clone is empty.
///
/// # Example
/// ```
/// use collective_integrators::StoragePool;
/// let pool: StoragePool<Vec<f64>> = StoragePool::default();
/// let sum = |values: &[f64]| pool.with(|storage| {
///     storage.clear();
///     storage.extend(values.iter().map(|x| x * x));
///     storage.iter().sum::<f64>()
/// });
/// assert_eq!(sum(&[3.0, 4.0]), 25.0);
/// assert_eq!(sum(&[1.0]), 1.0);
/// ```
#[derive(Debug, Default)]
pub struct StoragePool<T>(Mutex<Vec<T>>);

impl<T: Default> StoragePool<T> {
    /// Calls `f` with storage that nothing else uses meanwhile. If there is storage of an earlier call, it is used
    /// again, with what that call has left in it.
    pub fn with<R>(&self, f: impl FnOnce(&mut T) -> R) -> R {
        let mut storage = self.lock(Vec::pop).unwrap_or_default();
        let result = f(&mut storage);
        self.lock(|pool| pool.push(storage));
        result
    }

    fn lock<R>(&self, f: impl FnOnce(&mut Vec<T>) -> R) -> R {
        // The vector is whole even if a thread has panicked.
        f(&mut self.0.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

impl<T> Clone for StoragePool<T> {
    fn clone(&self) -> Self {
        Self(Mutex::default())
    }
}

impl<T> PartialEq for StoragePool<T> {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}
