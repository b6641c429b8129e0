//! How the neighbours of a group of four particles lie in memory: a range for each group, then the codes of all.
//!
//! The codes of a group stand as they are read: four neighbours of its first particle, four of the second, of the third
//! and of the fourth, then the next four of each. A list that is shorter than the longest of the four is filled up with
//! the particle itself. A code of 16 bits is a window of slots and a place in it; the first slots of the windows stand
//! before the codes of the first group that uses them. A group whose lists do not fit is not listed, and searches its
//! cells in every pass.
use crate::arithmetic::codes::{MOST_LANES, WINDOW_BITS, WINDOWS, Windows};
use core::ops::Range;

/// Particles of a group, side by side in their slots.
pub(crate) const GROUP: usize = 4;

/// Most neighbours that are listed of a particle.
pub(crate) const MOST_LISTED: usize = 240;

/// Codes that a group's lists grow by: four for each of its particles, which is what the widest lanes take at once.
pub(crate) const CHUNK: usize = MOST_LANES;

const _: () = assert!(CHUNK == 4 * GROUP && CHUNK * size_of::<u16>() == size_of::<Windows>());

/// Room for the neighbours of a particle while they are being found.
pub(crate) const ROOM: usize = MOST_LISTED + CHUNK;

/// Words of a range: where the codes begin, in chunks; where their windows stand, likewise; the longest list; the
/// length of each in a byte.
const RANGE: usize = 4;

/// Length of a list that there is not.
const NOT_LISTED: u32 = u32::MAX;

/// Groups of so many particles.
pub(crate) fn groups(particles: usize) -> usize {
    particles.div_ceil(GROUP)
}

/// The memory of the lists in its two parts; no ranges where there is no memory even for those.
fn parts(memory: &[u32], particles: usize) -> (&[[u32; RANGE]], &[u16]) {
    let (ranges, codes) = memory.split_at_checked(RANGE * groups(particles)).unwrap_or((&[], &[]));
    (ranges.as_chunks().0, bytemuck::cast_slice(codes))
}

/// How full the neighbour lists of a step are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ListReport {
    /// Groups of four particles.
    pub groups: usize,
    /// Those whose lists fit; the others search their cells in each pass.
    pub listed: usize,
    /// Pairs that are listed, a particle with itself among them.
    pub pairs: u64,
    /// Places of the lists that lanes work on, those that hold no pair included.
    pub places: u64,
}

/// The lists, to be read.
#[derive(Clone, Copy)]
pub(crate) struct Lists<'a> {
    ranges: &'a [[u32; RANGE]],
    codes: &'a [u16],
}

/// The lists of a group.
#[derive(Clone, Copy)]
pub(crate) struct Listed<'a> {
    /// The codes, chunk by chunk.
    pub codes: &'a [u16],
    /// What they refer to.
    pub windows: &'a Windows,
    /// How many neighbours each particle has.
    pub counts: [u8; GROUP],
}

impl<'a> Lists<'a> {
    /// None: all groups search their cells.
    pub(crate) const NONE: Lists<'a> = Lists { ranges: &[], codes: &[] };

    /// Those in this memory.
    pub(crate) fn new(memory: &'a [u32], particles: usize) -> Lists<'a> {
        let (ranges, codes) = parts(memory, particles);
        Lists { ranges, codes }
    }

    /// How full they are.
    pub(crate) fn report(&self, particles: usize) -> ListReport {
        let mut report = ListReport { groups: groups(particles), listed: 0, pairs: 0, places: 0 };
        for listed in (0..report.groups).filter_map(|group| self.of(group)) {
            report.listed += 1;
            report.pairs += listed.counts.iter().map(|&count| u64::from(count)).sum::<u64>();
            report.places += listed.codes.len() as u64;
        }
        report
    }

    /// Those of a group; none where it is not listed.
    #[inline(always)]
    pub(crate) fn of(&self, group: usize) -> Option<Listed<'a>> {
        let [begin, windows, longest, counts] = *self.ranges.get(group)?;
        // of a group that was never listed these may be any numbers
        let from = |chunk: u32| self.codes.get((chunk as usize).checked_mul(CHUNK)?..);
        let codes = from(begin)?.get(..(longest as usize).checked_mul(GROUP)?)?;
        let windows = from(windows)?.get(..CHUNK)?;
        let windows = bytemuck::try_from_bytes(bytemuck::cast_slice(windows)).ok()?;
        Some(Listed { codes, windows, counts: counts.to_le_bytes() })
    }
}

/// A share of the lists, to be filled group by group.
pub(crate) struct Filling<'a> {
    ranges: &'a mut [[u32; RANGE]],
    codes: &'a mut [u16],
    /// Chunks of other shares before this one.
    chunks_before: usize,
    /// Chunks of it that are filled.
    filled: usize,
    windows: Windows,
    /// How many of them are in use.
    used: usize,
    /// The one that was asked for last.
    recent: usize,
    /// Where they were written; nowhere yet where they are new.
    written: Option<usize>,
}

/// The memory of the lists in shares of so many groups each.
pub(crate) fn share(
    memory: &mut [u32],
    particles: usize,
    shares: impl Iterator<Item = Range<usize>>,
) -> impl Iterator<Item = (Range<usize>, Filling<'_>)> {
    let all = groups(particles);
    let (ranges, codes) = memory.split_at_mut_checked(RANGE * all).unwrap_or((&mut [], &mut []));
    let mut ranges = ranges.as_chunks_mut().0;
    // what sorted the particles lay here
    ranges.fill([0, 0, NOT_LISTED, 0]);
    let mut codes: &mut [u16] = bytemuck::cast_slice_mut(codes);
    let chunks = codes.len() / CHUNK;
    let mut chunks_before = 0;
    shares.map(move |groups| {
        // each share's part of the codes is in proportion to its groups
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

/// Is a slot in the window that begins there?
fn is_within(start: u32, slot: u32) -> bool {
    slot.wrapping_sub(start) < 1 << WINDOW_BITS
}

impl Filling<'_> {
    /// What a slot of this run differs by from its code, in a window that there is or a new one; nothing where there is
    /// no more room for one.
    #[inline(always)]
    pub(crate) fn shift(&mut self, run: &Range<usize>) -> Option<u32> {
        let (first, last) = (run.start as u32, run.end as u32 - 1);
        // most runs lie beside the one before
        let start = self.windows[self.recent];
        if self.recent >= self.used || !is_within(start, first) || !is_within(start, last) {
            self.recent = self.window_of(first, last)?;
        }
        Some(((self.recent as u32) << WINDOW_BITS).wrapping_sub(self.windows[self.recent]))
    }

    /// The window of a run, a new one if need be.
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

    /// Forgets the windows.
    pub(crate) fn reset(&mut self) {
        self.used = 0;
        self.written = None;
    }

    /// Lists a group, of which `codes` are those of its particles, or, `fits` being false, does not.
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
            // no more than to the end of the longest, but a number of entries that the compiler knows
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
