//! Walks over the tree of supernodes: small subtrees one after another by one thread, large ones side by side.
//! Where a subtree goes has no bearing on any number, because every visit sees the same inputs in the same order.

use super::symbolic::Symbolic;
use rayon::prelude::*;

/// Number of pieces that the work is cut into for each thread.
const PIECES: f64 = 8.0;
/// Deeper in the tree nothing is shared out any more, so that no shape of tree exhausts the stack.
const DEEPEST: usize = 256;

/// A subtree and its part of the data.
struct Part<'a> {
    root: usize,
    /// Where the data start, counted over the whole tree.
    offset: usize,
    data: &'a mut [f64],
    depth: usize,
}

/// The tree, and where each supernode's part of the data starts (asked for one more than there are supernodes).
pub(super) struct Walk<'a, S> {
    tree: &'a Symbolic,
    start: S,
    smallest: f64,
}

impl<'a, S: Fn(usize) -> usize + Sync> Walk<'a, S> {
    /// Over data cut where `start` says, shared out among the threads of the current pool.
    pub fn new(tree: &'a Symbolic, start: S) -> Self {
        let threads = rayon::current_num_threads();
        let smallest = if threads == 1 { f64::INFINITY } else { tree.flops() / (PIECES * threads as f64) };
        Walk { tree, start, smallest }
    }

    /// From the leaves to the roots. Each visit owns the supernode's data, takes what the children left from the end
    /// of the stack and leaves its own there, one thing. The error is that of the first supernode that has one.
    pub fn up<T, E>(
        &self,
        data: &mut [f64],
        visit: &(impl Fn(usize, &mut [f64], &mut Vec<T>) -> Result<(), E> + Sync),
    ) -> Result<(), E>
    where
        T: Send,
        E: Send,
    {
        self.children_up(&self.tree.roots, 0, data, 0, visit).map(|_| ())
    }

    /// From the roots to the leaves. Each visit owns the supernode's data, sees what the parent left (nothing at a
    /// root) and returns what it leaves to its children.
    pub fn down<T: Send + Sync>(&self, data: &mut [f64], visit: &(impl Fn(usize, &mut [f64], Option<&T>) -> T + Sync)) {
        self.children_down(&self.tree.roots, 0, data, 0, None, visit);
    }

    /// Cuts the data of brothers apart.
    fn parts<'d>(&self, children: &[u32], offset: usize, data: &'d mut [f64], depth: usize) -> Vec<Part<'d>> {
        let (mut rest, mut at, mut parts) = (data, offset, Vec::with_capacity(children.len()));
        for &child in children {
            let end = (self.start)(child as usize + 1);
            let (data, after) = std::mem::take(&mut rest).split_at_mut(end - at);
            parts.push(Part { root: child as usize, offset: at, data, depth });
            (rest, at) = (after, end);
        }
        parts
    }

    fn is_small(&self, part: &Part) -> bool {
        self.tree.supernodes[part.root].flops <= self.smallest || part.depth > DEEPEST
    }

    /// Does the work on brothers, side by side when more than one is large.
    fn share<R: Send>(&self, parts: Vec<Part>, work: impl Fn(Part) -> R + Send + Sync) -> Vec<R> {
        if parts.iter().filter(|part| !self.is_small(part)).count() > 1 || self.many_small(&parts) {
            parts.into_par_iter().map(work).collect()
        } else {
            parts.into_iter().map(work).collect()
        }
    }

    /// Bodies or branches each too small to be cut, but together worth sharing out.
    fn many_small(&self, parts: &[Part]) -> bool {
        parts.iter().map(|part| self.tree.supernodes[part.root].flops).sum::<f64>() > self.smallest
            && parts.iter().filter(|part| self.tree.supernodes[part.root].flops > self.smallest / 16.0).count() > 1
    }

    fn children_up<T: Send, E: Send>(
        &self,
        children: &[u32],
        offset: usize,
        data: &mut [f64],
        depth: usize,
        visit: &(impl Fn(usize, &mut [f64], &mut Vec<T>) -> Result<(), E> + Sync),
    ) -> Result<Vec<T>, E> {
        let results = self.share(self.parts(children, offset, data, depth), |part| self.subtree_up(part, visit));
        let mut stack = Vec::with_capacity(children.len());
        for result in results {
            stack.extend(result?);
        }
        Ok(stack)
    }

    fn subtree_up<T: Send, E: Send>(
        &self,
        part: Part,
        visit: &(impl Fn(usize, &mut [f64], &mut Vec<T>) -> Result<(), E> + Sync),
    ) -> Result<Vec<T>, E> {
        let root = &self.tree.supernodes[part.root];
        if !self.is_small(&part) {
            let (below, own) = part.data.split_at_mut((self.start)(part.root) - part.offset);
            let mut stack = self.children_up(&root.children, part.offset, below, part.depth + 1, visit)?;
            visit(part.root, own, &mut stack)?;
            return Ok(stack);
        }
        let (mut rest, mut stack) = (part.data, Vec::new());
        for s in root.subtree..part.root + 1 {
            let length = (self.start)(s + 1) - (self.start)(s);
            let (own, after) = std::mem::take(&mut rest).split_at_mut(length);
            visit(s, own, &mut stack)?;
            rest = after;
        }
        Ok(stack)
    }

    fn children_down<T: Send + Sync>(
        &self,
        children: &[u32],
        offset: usize,
        data: &mut [f64],
        depth: usize,
        above: Option<&T>,
        visit: &(impl Fn(usize, &mut [f64], Option<&T>) -> T + Sync),
    ) {
        self.share(self.parts(children, offset, data, depth), |part| self.subtree_down(part, above, visit));
    }

    fn subtree_down<T: Send + Sync>(
        &self,
        part: Part,
        above: Option<&T>,
        visit: &(impl Fn(usize, &mut [f64], Option<&T>) -> T + Sync),
    ) {
        let root = &self.tree.supernodes[part.root];
        if !self.is_small(&part) {
            let (below, own) = part.data.split_at_mut((self.start)(part.root) - part.offset);
            let left = visit(part.root, own, above);
            self.children_down(&root.children, part.offset, below, part.depth + 1, Some(&left), visit);
            return;
        }
        // what supernodes left whose children are still to come, and how many these are
        let mut waiting: Vec<(T, usize)> = Vec::new();
        let mut rest = part.data;
        for s in (root.subtree..part.root + 1).rev() {
            let length = (self.start)(s + 1) - (self.start)(s);
            let (before, own) = rest.split_at_mut(rest.len() - length);
            rest = before;
            let parent = waiting.last().map(|w| &w.0).or(above);
            let left = visit(s, own, parent);
            if let Some(last) = waiting.last_mut() {
                last.1 -= 1;
                if last.1 == 0 {
                    waiting.pop();
                }
            }
            let children = self.tree.supernodes[s].children.len();
            if children > 0 {
                waiting.push((left, children));
            }
        }
    }
}
