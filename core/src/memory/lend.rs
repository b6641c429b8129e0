//! How memory is lent to a solver: some arrays by name, and an arena for all others.
use super::requirements::{LINE_WORDS, LIST_WORDS, Requirements};
use crate::error::SceneError;
use crate::plan::arrays::Array;
use bytemuck::Pod;

/// Memory lent to a solver: some arrays by name, as [`Storage`](super::Storage) provides them, and all others in an
/// arena. It may be larger than a scene needs.
#[derive(Debug)]
pub struct Memory<'m> {
    named: [[&'m mut [u32]; 2]; Array::COUNT],
    arena: &'m mut [u32],
    most_neighbour_words: usize,
}

impl<'m> Memory<'m> {
    /// Memory that consists of an arena only. Its first bytes, up to a multiple of four, may stay unused.
    #[must_use]
    pub fn of_arena(arena: &'m mut [u8]) -> Memory<'m> {
        let named = core::array::from_fn(|_| Default::default());
        Memory { named, arena: &mut [], most_neighbour_words: usize::MAX }.with_arena_bytes(arena)
    }

    pub(super) fn with_arena_bytes(mut self, arena: &'m mut [u8]) -> Memory<'m> {
        (_, self.arena, _) = bytemuck::pod_align_to_mut(arena);
        self
    }

    /// Adds an array by name, in one copy or two.
    #[must_use]
    pub(crate) fn with<T: Pod>(mut self, array: Array, copies: impl IntoIterator<Item = &'m mut [T]>) -> Memory<'m> {
        for (named, copy) in self.named[array as usize].iter_mut().zip(copies) {
            *named = bytemuck::cast_slice_mut(copy);
        }
        self
    }

    /// Limits the memory for neighbour lists to `most` words; 0 means no lists. Lists save time and never change a bit
    /// of the result: a group of particles whose list does not fit searches its cells.
    #[must_use]
    pub fn with_neighbour_words(self, most: usize) -> Memory<'m> {
        Memory { most_neighbour_words: most, ..self }
    }

    /// Returns a lender that hands out the arrays of a simulation with these requirements.
    pub(super) fn lender<'r>(self, requirements: &'r Requirements) -> Lender<'m, 'r> {
        let Memory { named, arena, most_neighbour_words } = self;
        let unnamed = |array: &&Array| named[**array as usize][0].is_empty();
        let needed = Array::ALL.iter().filter(unnamed).map(|&array| requirements.arena_bytes_of(array)).sum();
        let too_small = SceneError::CapacityExceeded { what: "bytes of arena", needed, capacity: size_of_val(arena) };
        Lender { named, arena, most_neighbour_words, requirements, too_small }
    }
}

/// Hands out arrays from the memory lent.
pub(super) struct Lender<'m, 'r> {
    named: [[&'m mut [u32]; 2]; Array::COUNT],
    arena: &'m mut [u32],
    most_neighbour_words: usize,
    requirements: &'r Requirements,
    too_small: SceneError,
}

impl<'m> Lender<'m, '_> {
    /// Number of words in which neighbour lists are made, of those that were lent for them. They also hold the arrays
    /// that sort the particles.
    pub(super) fn list_words(&self, lent: usize) -> usize {
        // the range of a group refers to a chunk of codes by a u32
        lent.min(self.most_neighbour_words).min(u32::MAX as usize)
    }

    /// Returns a copy of an array in its required length. From the arena it is all zero. An array without this copy is
    /// empty.
    pub(super) fn take<T: Pod>(&mut self, array: Array, copy: usize) -> Result<&'m mut [T], SceneError> {
        let mut entries = if copy < self.requirements.copies(array) { self.requirements.entries(array) } else { 0 };
        let named = core::mem::take(&mut self.named[array as usize][copy]);
        if array == Array::neighbours && !named.is_empty() {
            // lists may be shorter than all neighbours need, but the sorting arrays must fit
            entries = entries.min(named.len()).max(self.requirements.counts.particles.saturating_mul(LIST_WORDS));
        }
        let words = entries.saturating_mul(array.words());
        if !named.is_empty() {
            let capacity = named.len() / array.words();
            let error = SceneError::CapacityExceeded { what: array.name(), needed: entries, capacity };
            return named.get_mut(..words).map(bytemuck::cast_slice_mut).ok_or(error);
        }
        let own = words.checked_next_multiple_of(LINE_WORDS).and_then(|lines| self.arena.split_off_mut(..lines));
        let own = own.ok_or(self.too_small)?;
        own.fill(0);
        Ok(bytemuck::cast_slice_mut(&mut own[..words]))
    }
}
