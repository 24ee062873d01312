//! Small pieces of work as steps of a progress bar.

use std::sync::atomic::{AtomicU64, Ordering};

/// So many pieces as so many steps.
pub struct Progress<'a> {
    done: &'a (dyn Fn(u64) + Sync),
    pieces: u64,
    steps: u64,
    so_far: AtomicU64,
    told: AtomicU64,
}

impl<'a> Progress<'a> {
    /// Tells `done` about `steps` steps while `pieces` pieces are done.
    pub fn new(done: &'a (dyn Fn(u64) + Sync), pieces: u64, steps: u64) -> Self {
        Self { done, pieces: pieces.max(1), steps, so_far: AtomicU64::new(0), told: AtomicU64::new(0) }
    }

    /// So many pieces more have been done.
    pub fn add(&self, pieces: u64) {
        let so_far = self.so_far.fetch_add(pieces, Ordering::Relaxed) + pieces;
        self.tell(self.steps * so_far.min(self.pieces) / self.pieces);
    }

    /// All are done: what was kept from an earlier run took no time.
    pub fn end(self) {
        self.tell(self.steps);
    }

    fn tell(&self, steps: u64) {
        let told = self.told.fetch_max(steps, Ordering::Relaxed);
        if steps > told {
            (self.done)(steps - told);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_steps_are_told_once() {
        let told = AtomicU64::new(0);
        let done = |steps| {
            told.fetch_add(steps, Ordering::Relaxed);
        };
        let progress = Progress::new(&done, 100, 7);
        (0..30).for_each(|_| progress.add(2));
        assert_eq!(told.load(Ordering::Relaxed), 4);
        progress.end();
        assert_eq!(told.load(Ordering::Relaxed), 7);
    }
}
