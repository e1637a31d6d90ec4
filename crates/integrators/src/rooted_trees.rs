//! Rooted trees, grown one by one for the order conditions of a method.

/// A rooted tree that can be a branch of larger trees, with its contribution to the vertex that carries it.
pub(crate) struct Branch<W> {
    /// The number of vertices.
    pub(crate) order: usize,
    /// The density γ of the tree.
    pub(crate) density: f64,
    /// The elementary weight at each stage.
    pub(crate) at_stages: Vec<W>,
}

/// A root to which branches from `branches[..last]` are to be added.
pub(crate) struct Stem {
    /// The number of vertices that are missing.
    pub(crate) missing: usize,
    pub(crate) last: usize,
    /// The product of the densities of the root and of its branches.
    pub(crate) density: f64,
}

/// Adds branches until no vertex is missing, in all ways, and multiplies the weights of the root at the stages by
/// theirs.
///
/// Calls `finish` with the weights and the density of each finished tree. Returns `false` as soon as `finish` does.
pub(crate) fn grow<W>(
    branches: &[Branch<W>],
    stem: &Stem,
    weights: &[W],
    multiply: fn(&W, &W) -> W,
    finish: &mut dyn FnMut(&[W], f64) -> bool,
) -> bool {
    if stem.missing == 0 {
        return finish(weights, stem.density);
    }
    (0..stem.last).filter(|&n| branches[n].order <= stem.missing).all(|n| {
        let branch = &branches[n];
        let pairs = weights.iter().zip(&branch.at_stages);
        let product: Vec<W> = pairs.map(|(w, x)| multiply(w, x)).collect();
        let missing = stem.missing - branch.order;
        let stem = Stem { missing, last: n + 1, density: stem.density * branch.density };
        grow(branches, &stem, &product, multiply, finish)
    })
}
