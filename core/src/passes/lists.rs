//! Memory layout of the neighbour lists. Particles are listed in groups of four that lie in consecutive slots. The
//! memory holds a range for each group, followed by the codes of all groups.
//!
//! The codes of a group are stored in the order in which they are read: four neighbours of its first particle, four of
//! the second, of the third and of the fourth. These 16 codes are a chunk. The next chunk holds the next four
//! neighbours of each particle. A list that is shorter than the longest of the group is padded with the particle's own
//! code.
//!
//! A code has 16 bits: the number of a window, and a place in it. A window is a range of consecutive slots. The first
//! slots of all windows are stored in front of the codes of the first group that uses these windows, and later groups
//! refer to them as well. A group whose lists do not fit is not listed: it searches its cells in every pass.
use crate::arithmetic::codes::{MOST_LANES, WINDOW_BITS, WINDOWS, Windows};
use crate::memory::MOST_LISTED;
use core::ops::Range;

/// Number of particles in a group; they lie in consecutive slots.
pub(crate) const GROUP: usize = 4;

/// Number of codes in a chunk, by which the lists of a group grow: four for each particle of the group, which is as
/// many codes as the widest lanes take at once.
pub(crate) const CHUNK: usize = MOST_LANES;

const _: () = assert!(CHUNK == 4 * GROUP && CHUNK * size_of::<u16>() == size_of::<Windows>());

/// Capacity of the buffer for the neighbours of a particle while they are being found.
pub(crate) const ROOM: usize = MOST_LISTED + CHUNK;

/// Number of words in a range: the start of the codes, in chunks; the start of their windows, in chunks; the length of
/// the longest list, rounded up to a multiple of four; the length of each of the four lists, one byte each.
const RANGE: usize = 4;

/// Length of the longest list in the range of a group that is not listed.
const NOT_LISTED: u32 = u32::MAX;

/// Returns the number of groups for this many particles.
pub(crate) fn groups(particles: usize) -> usize {
    particles.div_ceil(GROUP)
}

/// Splits the memory of the lists into ranges and codes. Both are empty if the memory is too small for the ranges.
fn parts(memory: &[u32], particles: usize) -> (&[[u32; RANGE]], &[u16]) {
    let (ranges, codes) = memory.split_at_checked(RANGE * groups(particles)).unwrap_or((&[], &[]));
    (ranges.as_chunks().0, bytemuck::cast_slice(codes))
}

/// How full the neighbour lists of a step are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ListReport {
    /// Number of groups of four particles.
    pub groups: usize,
    /// Number of groups whose lists fit; the other groups search their cells in each pass.
    pub listed: usize,
    /// Number of pairs in the lists. The pair of a particle with itself counts as one.
    pub pairs: u64,
    /// Number of entries in the lists, padding included: the number of pairs that the lanes process.
    pub places: u64,
}

/// Read access to the lists.
#[derive(Clone, Copy)]
pub(crate) struct Lists<'a> {
    ranges: &'a [[u32; RANGE]],
    codes: &'a [u16],
}

/// The lists of one group.
#[derive(Clone, Copy)]
pub(crate) struct Listed<'a> {
    /// The codes, chunk by chunk.
    pub codes: &'a [u16],
    /// The windows that the codes refer to.
    pub windows: &'a Windows,
    /// Number of neighbours of each particle.
    pub counts: [u8; GROUP],
}

impl<'a> Lists<'a> {
    /// No lists: all groups search their cells.
    pub(crate) const NONE: Lists<'a> = Lists { ranges: &[], codes: &[] };

    /// Reads the lists in this memory.
    pub(crate) fn new(memory: &'a [u32], particles: usize) -> Lists<'a> {
        let (ranges, codes) = parts(memory, particles);
        Lists { ranges, codes }
    }

    /// Reports how full the lists are.
    pub(crate) fn report(&self, particles: usize) -> ListReport {
        let mut report = ListReport { groups: groups(particles), listed: 0, pairs: 0, places: 0 };
        for listed in (0..report.groups).filter_map(|group| self.of(group)) {
            report.listed += 1;
            report.pairs += listed.counts.iter().map(|&count| u64::from(count)).sum::<u64>();
            report.places += listed.codes.len() as u64;
        }
        report
    }

    /// Returns the lists of a group, or `None` if it is not listed.
    #[inline(always)]
    pub(crate) fn of(&self, group: usize) -> Option<Listed<'a>> {
        let [begin, windows, longest, counts] = *self.ranges.get(group)?;
        // the range of a group that was never listed may hold any numbers
        let from = |chunk: u32| self.codes.get((chunk as usize).checked_mul(CHUNK)?..);
        let codes = from(begin)?.get(..(longest as usize).checked_mul(GROUP)?)?;
        let windows = from(windows)?.get(..CHUNK)?;
        let windows = bytemuck::try_from_bytes(bytemuck::cast_slice(windows)).ok()?;
        Some(Listed { codes, windows, counts: counts.to_le_bytes() })
    }
}

/// A part of the lists, which one job fills group by group.
pub(crate) struct Filling<'a> {
    ranges: &'a mut [[u32; RANGE]],
    codes: &'a mut [u16],
    /// Number of chunks that belong to parts before this one.
    chunks_before: usize,
    /// Number of chunks of this part that are filled.
    filled: usize,
    windows: Windows,
    /// Number of windows in use.
    used: usize,
    /// Index of the window that was used last.
    recent: usize,
    /// The chunk that the windows were written to; `None` if they were not written since they last changed.
    written: Option<usize>,
}

/// Cuts the memory of the lists into one part for each of the given ranges of groups.
pub(crate) fn share(
    memory: &mut [u32],
    particles: usize,
    shares: impl Iterator<Item = Range<usize>>,
) -> impl Iterator<Item = (Range<usize>, Filling<'_>)> {
    let all = groups(particles);
    let (ranges, codes) = memory.split_at_mut_checked(RANGE * all).unwrap_or((&mut [], &mut []));
    let mut ranges = ranges.as_chunks_mut().0;
    // the sorting arrays used the same memory, so it holds stale data
    ranges.fill([0, 0, NOT_LISTED, 0]);
    let mut codes: &mut [u16] = bytemuck::cast_slice_mut(codes);
    let chunks = codes.len() / CHUNK;
    let mut chunks_before = 0;
    shares.map(move |groups| {
        // the codes are divided in proportion to the number of groups
        let until = (chunks as u64 * groups.end as u64 / all.max(1) as u64) as usize;
        let filling = Filling {
            ranges: ranges.split_off_mut(..groups.len()).unwrap_or_default(),
            codes: codes.split_off_mut(..(until - chunks_before) * CHUNK).unwrap_or_default(),
            chunks_before,
            filled: 0,
            windows: [0; WINDOWS],
            used: 0,
            recent: 0,
            written: None,
        };
        chunks_before = until;
        (groups, filling)
    })
}

/// Returns whether a slot lies in the window that begins at `start`.
fn is_within(start: u32, slot: u32) -> bool {
    slot.wrapping_sub(start) < 1 << WINDOW_BITS
}

impl Filling<'_> {
    /// Returns the wrapping difference between code and slot for the slots of this run. Uses an existing window if one
    /// contains the run, or else adds one. Returns `None` if there is no room for another window, or if the run is
    /// longer than a window.
    #[inline(always)]
    pub(crate) fn shift(&mut self, run: &Range<usize>) -> Option<u32> {
        let (first, last) = (run.start as u32, run.end as u32 - 1);
        // most runs lie in the same window as the previous one
        let start = self.windows[self.recent];
        if self.recent >= self.used || !is_within(start, first) || !is_within(start, last) {
            self.recent = self.window_of(first, last)?;
        }
        Some(((self.recent as u32) << WINDOW_BITS).wrapping_sub(self.windows[self.recent]))
    }

    /// Returns the index of the window that contains a run, after adding one if necessary. Returns `None` under the
    /// same conditions as `shift`.
    #[inline(never)]
    fn window_of(&mut self, first: u32, last: u32) -> Option<usize> {
        let has_both = |&start: &u32| is_within(start, first) && is_within(start, last);
        let known = self.windows[..self.used].iter().position(has_both);
        if known.is_some() {
            return known;
        }
        if self.used == WINDOWS || !is_within(first, last) {
            return None;
        }
        self.windows[self.used] = first;
        self.used += 1;
        self.written = None;
        Some(self.used - 1)
    }

    /// Removes all windows.
    pub(crate) fn reset(&mut self) {
        self.used = 0;
        self.written = None;
    }

    /// Stores the lists of a group, unless `fits` is false or they do not fit. `codes` are the neighbours of its
    /// particles, `counts` their numbers, and `own` the codes of the particles themselves.
    #[inline(always)]
    pub(crate) fn push(
        &mut self,
        group: usize,
        fits: bool,
        codes: &mut [[u32; ROOM]; GROUP],
        counts: [usize; GROUP],
        own: [u32; GROUP],
    ) {
        let Some(range) = self.ranges.get_mut(group) else { return };
        let longest = counts.into_iter().max().unwrap_or(0).next_multiple_of(GROUP);
        let needed = longest / GROUP + usize::from(self.written.is_none());
        if !fits || longest > MOST_LISTED || self.codes.len() < (self.filled + needed) * CHUNK {
            return;
        }
        let windows = self.written.unwrap_or(self.filled);
        if self.written.is_none() {
            self.codes[windows * CHUNK..][..CHUNK].copy_from_slice(bytemuck::cast_slice(&self.windows));
            self.written = Some(windows);
            self.filled += 1;
        }
        for ((codes, count), own) in codes.iter_mut().zip(counts).zip(own) {
            // fill whole chunks, whose length the compiler knows, up to the end of the longest list
            let mut from = count;
            while from < longest {
                codes[from..][..CHUNK].fill(own);
                from += CHUNK;
            }
        }
        let chunks = &mut self.codes[self.filled * CHUNK..][..longest * GROUP];
        let (chunks, _) = chunks.as_chunks_mut::<CHUNK>();
        for (k, chunk) in chunks.iter_mut().enumerate() {
            for (own, codes) in chunk.as_chunks_mut::<GROUP>().0.iter_mut().zip(&*codes) {
                let four = &codes[GROUP * k..][..GROUP];
                *own = [four[0] as u16, four[1] as u16, four[2] as u16, four[3] as u16];
            }
        }
        let before = self.chunks_before;
        let counts = counts.map(|count| count as u8);
        *range = [(before + self.filled) as u32, (before + windows) as u32, longest as u32, u32::from_le_bytes(counts)];
        self.filled += chunks.len();
    }
}
