//! Runs a computation in the registers that are detected at run time, with each lane bit-identical to `f64`:
//! [`dispatch_unfused`].

use super::{DefaultLanes, InstructionSet, Lanes, MissingInstructions};

#[cfg(target_arch = "x86_64")]
use super::{packed::Packed, registers::avx2::Avx2, registers::avx512::Avx512, registers::unfused};

/// Four lanes in one register of AVX2.
#[cfg(target_arch = "x86_64")]
type Lanes256 = Packed<unfused::Unfused<Avx2>>;
/// Eight lanes in one register of AVX-512.
#[cfg(target_arch = "x86_64")]
type Lanes512 = Packed<unfused::Unfused<Avx512>>;
#[cfg(not(target_arch = "x86_64"))]
type Lanes256 = DefaultLanes;
#[cfg(not(target_arch = "x86_64"))]
type Lanes512 = DefaultLanes;

/// A type that creates the storage which a [`TaskOver`] lanes of type `T` keeps from one run to the next.
pub trait StorageOver<T: Lanes> {
    /// The type of the storage.
    type Storage;

    /// Creates the storage over these lanes.
    fn storage(&self) -> Self::Storage;
}

/// A computation on SIMD lanes (several numbers in one register) of type `T`, to be run by [`dispatch_unfused`].
///
/// A [`LaneTask`](super::LaneTask) must be written over every type of lanes. This trait is implemented over a type `T`,
/// so that an implementation can require more of it, such as a trait `Method<T>` of a parameter.
///
/// # Speed
/// The speed rules of [`LaneTask`](super::LaneTask) apply here too.
pub trait TaskOver<T: Lanes, S: StorageOver<T>> {
    /// Runs the computation on these lanes. Mark it with `#[inline(always)]`.
    fn run(self, storage: &mut S::Storage);
}

/// A type that implements [`StorageOver`] for each type of lanes that [`dispatch_unfused`] chooses from. Every such
/// type has this trait automatically.
pub trait UnfusedStorage:
    StorageOver<DefaultLanes> + StorageOver<Lanes256> + StorageOver<Lanes512>
{
}

impl<S> UnfusedStorage for S where
    S: StorageOver<DefaultLanes> + StorageOver<Lanes256> + StorageOver<Lanes512>
{
}

/// A type that implements [`TaskOver`] for each type of lanes that [`dispatch_unfused`] chooses from. Every such type
/// has this trait automatically.
pub trait UnfusedTask<S: UnfusedStorage>:
    TaskOver<DefaultLanes, S> + TaskOver<Lanes256, S> + TaskOver<Lanes512, S>
{
}

impl<S: UnfusedStorage, K> UnfusedTask<S> for K where
    K: TaskOver<DefaultLanes, S> + TaskOver<Lanes256, S> + TaskOver<Lanes512, S>
{
}

/// An instruction set that this processor has, and storage for the lanes of its registers.
#[derive(Debug)]
pub struct UnfusedWorkspace<S: UnfusedStorage>(Space<S>);

/// The storage for one type of lanes. A variant is created only after its instructions have been detected.
enum Space<S: UnfusedStorage> {
    Portable(<S as StorageOver<DefaultLanes>>::Storage),
    Avx2(<S as StorageOver<Lanes256>>::Storage),
    Avx512(<S as StorageOver<Lanes512>>::Storage),
}

impl<S: UnfusedStorage> core::fmt::Debug for Space<S> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        core::fmt::Display::fmt(&self.instructions(), f)
    }
}

impl<S: UnfusedStorage> Space<S> {
    fn instructions(&self) -> InstructionSet {
        match self {
            Self::Portable(_) => InstructionSet::Portable,
            Self::Avx2(_) => InstructionSet::Avx2,
            Self::Avx512(_) => InstructionSet::Avx512,
        }
    }
}

impl<S: UnfusedStorage> UnfusedWorkspace<S> {
    /// Creates the storage for the lanes of an instruction set.
    ///
    /// # Errors
    /// Returns [`MissingInstructions`] if the processor lacks the instructions.
    pub fn new(of: &S, set: InstructionSet) -> Result<Self, MissingInstructions> {
        Ok(Self(match set.if_available()? {
            InstructionSet::Portable => Space::Portable(StorageOver::<DefaultLanes>::storage(of)),
            InstructionSet::Avx2 => Space::Avx2(StorageOver::<Lanes256>::storage(of)),
            InstructionSet::Avx512 => Space::Avx512(StorageOver::<Lanes512>::storage(of)),
        }))
    }

    /// Creates the storage for the lanes that every processor has.
    pub fn portable(of: &S) -> Self {
        Self(Space::Portable(StorageOver::<DefaultLanes>::storage(of)))
    }

    /// Returns the instruction set.
    #[must_use]
    pub fn instructions(&self) -> InstructionSet {
        self.0.instructions()
    }
}

/// Runs a task on SIMD lanes (several numbers in one register) with the instructions of its storage. Each lane is
/// bit-identical to `f64`.
///
/// The lanes are [`DefaultLanes`] for `Portable`, one register of 4 lanes for `Avx2`, and one of 8 for `Avx512`. None
/// of these types is [`FUSED`](Lanes::FUSED). [`Real::HAS_SLOW_PATHS`](crate::Real::HAS_SLOW_PATHS) is true for the
/// first type alone.
///
/// # Soundness
/// Code outside of this crate cannot name the last two types, and a type parameter is never inferred to be one of them:
/// [`UnfusedTask`] and [`UnfusedStorage`] mention both, so that the inference is ambiguous, which is a compile error.
/// Safe code can reach them in one way only: as the `T` of [`StorageOver`] and [`TaskOver`]. [`UnfusedWorkspace::new`]
/// calls `StorageOver` only after the instructions have been detected, and this function calls `TaskOver` only with
/// storage created in that way. A processor keeps its instructions in every thread for as long as the program runs.
///
/// ```compile_fail,E0283
/// use generic_scalars::{StorageOver, UnfusedStorage};
/// fn not_chosen<S: UnfusedStorage>(storage: &S) {
///     StorageOver::<_>::storage(storage);
/// }
/// ```
///
/// # Example
/// The task has a parameter: a formula that is implemented only over the scalars that it was written for:
/// ```
/// use generic_scalars::{
///     InstructionSet, Lanes, Real, StorageOver, TaskOver, UnfusedWorkspace, UnfusedTask, dispatch_unfused,
/// };
///
/// trait Formula<T> {
///     fn at(&self, x: T) -> T;
/// }
/// struct SquareAndThird;
/// impl<T: Real> Formula<T> for SquareAndThird {
///     #[inline(always)]
///     fn at(&self, x: T) -> T {
///         x * x + x / 3.0
///     }
/// }
///
/// struct Stateless;
/// impl<T: Lanes> StorageOver<T> for Stateless {
///     type Storage = ();
///     fn storage(&self) {}
/// }
///
/// /// Replaces each number by the value of the formula there.
/// struct Replace<'a, F>(&'a F, &'a mut [f64]);
/// impl<F: Formula<T>, T: Lanes> TaskOver<T, Stateless> for Replace<'_, F> {
///     #[inline(always)]
///     fn run(self, (): &mut ()) {
///         for chunk in self.1.chunks_mut(T::COUNT) {
///             self.0.at(T::load(chunk)).store(chunk);
///         }
///     }
/// }
///
/// fn replace<F>(formula: &F, values: &mut [f64], set: InstructionSet)
/// where
///     for<'a> Replace<'a, F>: UnfusedTask<Stateless>,
/// {
///     if let Ok(mut space) = UnfusedWorkspace::new(&Stateless, set) {
///         dispatch_unfused(Replace(formula, values), &mut space);
///     }
/// }
///
/// for set in InstructionSet::available() {
///     let mut values: Vec<f64> = (0..19).map(f64::from).collect();
///     replace(&SquareAndThird, &mut values, set);
///     assert_eq!(values[17], SquareAndThird.at(17.0));
/// }
/// ```
#[allow(unsafe_code)] // calls into functions compiled for more than the baseline
pub fn dispatch_unfused<S: UnfusedStorage, K: UnfusedTask<S>>(
    task: K,
    space: &mut UnfusedWorkspace<S>,
) {
    match &mut space.0 {
        Space::Portable(storage) => TaskOver::<DefaultLanes, S>::run(task, storage),
        // SAFETY: the processor has AVX2, as was checked when this variant was made.
        #[cfg(target_arch = "x86_64")]
        Space::Avx2(storage) => unsafe { with_avx2(task, storage) },
        // SAFETY: the processor has AVX-512 F, DQ and VL and AVX2, as was checked when this variant was made.
        #[cfg(target_arch = "x86_64")]
        Space::Avx512(storage) => unsafe { with_avx512(task, storage) },
        #[cfg(not(target_arch = "x86_64"))]
        Space::Avx2(storage) => TaskOver::<Lanes256, S>::run(task, storage),
        #[cfg(not(target_arch = "x86_64"))]
        Space::Avx512(storage) => TaskOver::<Lanes512, S>::run(task, storage),
    }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn with_avx2<S: UnfusedStorage, K: UnfusedTask<S>>(
    task: K,
    storage: &mut <S as StorageOver<Lanes256>>::Storage,
) {
    TaskOver::<Lanes256, S>::run(task, storage);
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512dq,avx512vl,avx2")]
fn with_avx512<S: UnfusedStorage, K: UnfusedTask<S>>(
    task: K,
    storage: &mut <S as StorageOver<Lanes512>>::Storage,
) {
    TaskOver::<Lanes512, S>::run(task, storage);
}
