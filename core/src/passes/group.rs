//! Groups of receivers, and the walk over their neighbours. A group here is as many receivers as fit side by side into
//! the lanes: each receiver takes a block of lanes, and each lane of the block holds another of its neighbours. The
//! neighbours come from the lists (`lists.rs`). Where the lists of a group did not fit, they come from a search of the
//! cells.
use super::context::Setup;
use super::lanes::is_wall;
use super::lists::{CHUNK, GROUP, Listed, Lists};
use super::local::{Particles, spread};
use crate::arithmetic::codes::MOST_LANES;
use crate::arithmetic::lanes::{Lanes, Slots};
use crate::arithmetic::real::{less, real, select, vec3};
use crate::grid::{Cells, Stencil, cell_of};
use crate::layout::f32x4;
use crate::terms::pair::{Local, pair_scale, separation, squared_ratio};
use crate::terms::wall::MIRRORED;

/// Input of the cell search. The search is a separate function, so it gets the constants of the whole step. A reference
/// to a loop's own copy would keep the compiler from treating that copy as constant.
#[derive(Clone, Copy)]
pub(crate) struct Surroundings<'a> {
    pub setup: Setup<'a>,
    pub particles: Particles<'a>,
    pub cells: Cells<'a>,
}

/// A group of receivers: the particles in slots `first ..= last`. There are at most as many as the lanes hold
/// receivers.
#[derive(Clone, Copy)]
pub(crate) struct Group<'a> {
    pub setup: &'a Setup<'a>,
    pub particles: Particles<'a>,
    pub lists: Lists<'a>,
    pub surroundings: &'a Surroundings<'a>,
    pub first: usize,
    pub last: usize,
}

/// Sums the contributions of all neighbours of a group. Each receiver has four sums. Each sum is added up in the order
/// of the receiver's neighbours, and the result is returned in all lanes of the receiver.
///
/// Lanes that hold no pair hold the receiver itself as its own neighbour, and are masked to zero. With `is zero with
/// itself` the caller states that the contribution of a particle to itself is zero, so no mask is needed.
///
/// This is a macro because a closure cannot be forced to be inlined into its caller and compiled at the caller's SIMD
/// level.
macro_rules! fold {
    ($group:ident: $R:ident, |$slots:ident| $parts:expr) => {
        $crate::passes::group::fold!(@ $group: $R, true, |$slots| $parts)
    };
    ($group:ident: $R:ident, is zero with itself, |$slots:ident| $parts:expr) => {
        $crate::passes::group::fold!(@ $group: $R, false, |$slots| $parts)
    };
    (@ $group:ident: $R:ident, $is_masked:literal, |$slots:ident| $parts:expr) => {{
        let mut sums = <$R>::nothing();
        // separate from the walk: the search takes their address, which would keep the whole walk in memory
        let mut cursors = $crate::passes::group::Cursors::default();
        let mut slots = $crate::arithmetic::lanes::Slots::first($group.particles.position.len());
        let mut walk = $crate::passes::group::Walk::<$R>::of($group, &mut slots);
        while walk.next(&mut slots, &mut cursors) {
            let $slots = &slots;
            let parts: [$R; 4] = $parts;
            sums = <$R>::add_up(sums, if $is_masked { walk.listed(parts) } else { parts });
        }
        <$R>::sums(sums)
    }};
}
pub(crate) use fold;

impl Group<'_> {
    /// Returns the data of the receivers that the pair terms use.
    #[inline(always)]
    pub(crate) fn receivers<R: Lanes>(&self) -> Local<R> {
        self.particles.receivers(self.setup, self.first, self.last)
    }

    /// Returns the data of the neighbours in the lanes that the pair terms use.
    #[inline(always)]
    pub(crate) fn neighbours<R: Lanes>(&self, slots: &Slots) -> Local<R> {
        self.particles.neighbours(self.setup, slots)
    }

    /// Loads one row of four numbers per receiver. Each number is returned in all lanes of its receiver.
    #[inline(always)]
    pub(crate) fn spread<R: Lanes>(&self, rows: &[f32x4]) -> [R; 4] {
        spread(rows, self.first, self.last)
    }

    /// Returns whether all receivers are wall particles or inactive. These have no acceleration, so a pass can skip the
    /// group.
    #[inline(always)]
    pub(crate) fn are_walls(&self) -> bool {
        self.particles.are_walls(self.setup, self.first, self.last)
    }

    /// Returns whether some receivers are wall particles or inactive.
    #[inline(always)]
    pub(crate) fn have_walls(&self) -> bool {
        self.particles.have_walls(self.setup, self.first, self.last)
    }
}

/// Position of the cell search for each receiver: the index of the run of slots, and the slot in that run.
pub(crate) type Cursors = [(usize, usize); GROUP];

/// An iteration over the neighbours of a group, as many at a time as fit into the lanes.
pub(crate) struct Walk<'a, R> {
    surroundings: &'a Surroundings<'a>,
    first: usize,
    last: usize,
    /// The lists of the group, with the codes from its first receiver on. `None` if the group is not listed.
    listed: Option<Listed<'a>>,
    /// Index of the first code that is not decoded yet.
    next: usize,
    /// Whether the next neighbours are decoded already.
    is_ready: bool,
    /// Number of neighbours of each receiver that came before those in the lanes, and the total number of its
    /// neighbours. In a cell search they are 0 and the number of neighbours in the lanes.
    before: usize,
    count: R,
}

impl<'a, R: Lanes> Walk<'a, R> {
    /// Starts at the first neighbours of a group.
    #[inline(always)]
    pub(crate) fn of(group: &Group<'a>, slots: &mut Slots) -> Self {
        let receiver = group.first % GROUP;
        let mut listed = group.lists.of(group.first / GROUP);
        let mut count = real(0.0);
        if let Some(lists) = &mut listed {
            lists.codes = lists.codes.get(receiver * GROUP..).unwrap_or_default();
            let counts = lists.counts;
            count = R::from_lanes(|lane| f32::from(counts[(receiver + lane / R::NEIGHBOURS) % GROUP]));
        }
        let Group { surroundings, first, last, .. } = *group;
        let mut walk = Walk { surroundings, first, last, listed, next: 0, is_ready: false, before: 0, count };
        walk.prepare(slots);
        walk
    }

    /// Advances to the next neighbours. Returns false if there are none. The slots of the next neighbours are decoded
    /// while the caller still works on the previous ones, because the processor does not look far enough ahead to
    /// overlap the two by itself.
    #[inline(always)]
    pub(crate) fn next(&mut self, slots: &mut Slots, cursors: &mut Cursors) -> bool {
        if self.is_ready {
            // with four neighbours per receiver, go from chunk to chunk; with one, take the receiver's four codes of a
            // chunk first
            self.before = self.next / CHUNK * GROUP + self.next % GROUP;
            self.next +=
                if self.next % GROUP + R::NEIGHBOURS == GROUP { CHUNK + R::NEIGHBOURS - GROUP } else { R::NEIGHBOURS };
            slots.advance();
            self.prepare(slots);
            return true;
        }
        if self.listed.is_some() {
            return false;
        }
        let lanes = [R::RECEIVERS, R::NEIGHBOURS];
        let Some(found) = search(self.surroundings, [self.first, self.last], cursors, lanes) else { return false };
        slots.set(&found.slots);
        self.count = R::from_lanes(|lane| found.counts[lane / R::NEIGHBOURS] as f32);
        true
    }

    /// Decodes the slots of the next neighbours, if there are any.
    #[inline(always)]
    fn prepare(&mut self, slots: &mut Slots) {
        self.is_ready = false;
        let Some(listed) = &self.listed else { return };
        if let Some(codes) = listed.codes.get(self.next..).filter(|codes| codes.len() >= R::LANES) {
            slots.prepare::<R>(codes, listed.windows);
            self.is_ready = true;
        }
    }

    /// Sets the contributions of lanes that hold no pair to zero.
    #[inline(always)]
    pub(crate) fn listed(&self, parts: [R; 4]) -> [R; 4] {
        let place = R::from_lanes(|lane| (lane % R::NEIGHBOURS) as f32) + self.before as f32;
        masked(parts, less(place, self.count))
    }
}

/// Sets lanes for which the mask is false to zero.
#[inline(always)]
pub(crate) fn masked<R: Lanes>([x, y, z, w]: [R; 4], mask: R::Mask) -> [R; 4] {
    let none = real(0.0);
    [select(none, x, mask), select(none, y, mask), select(none, z, mask), select(none, w, mask)]
}

/// The next neighbours of each receiver and their number, as found by the cell search.
struct Found {
    slots: [u32; MOST_LANES],
    counts: [usize; GROUP],
}

/// Finds the next neighbours of each receiver in the cells around it. Returns `None` if there are no more.
#[cold]
#[inline(never)]
fn search(
    surroundings: &Surroundings<'_>,
    [first, last]: [usize; 2],
    cursors: &mut Cursors,
    [receivers, neighbours]: [usize; 2],
) -> Option<Found> {
    let Surroundings { setup, particles, cells } = *surroundings;
    let Setup { model: m, parameters: p, materials, .. } = setup;
    let support = |slot: usize| if m.has_variable_support == 1 { particles.support[slot] } else { 1.0 };
    let mut found = Found { slots: [first as u32; MOST_LANES], counts: [0; GROUP] };
    for (receiver, cursor) in cursors.iter_mut().enumerate().take(receivers.min(last + 1 - first)) {
        let a = first + receiver;
        let own = &mut found.slots[receiver * neighbours..][..neighbours];
        own.fill(a as u32);
        if m.wall_particles == MIRRORED && is_wall(materials, particles.velocity[a][3]) {
            continue;
        }
        let Ok(cell) = cell_of(p, particles.position[a]) else { continue };
        let stencil = Stencil::around(p, m.is_3d as i32, cells, cell as usize);
        let x_a = vec3::<f32>::splat(particles.position[a]);
        let count = &mut found.counts[receiver];
        'search: for run in stencil.runs().skip(cursor.0) {
            for b in run.start.max(cursor.1)..run.end {
                let x_ab = separation(m, p, x_a, vec3::splat(particles.position[b]));
                if squared_ratio(m, p, x_ab, pair_scale(m, support(a), support(b))) < 1.0 {
                    if *count == neighbours {
                        cursor.1 = b;
                        break 'search;
                    }
                    own[*count] = b as u32;
                    *count += 1;
                }
            }
            *cursor = (cursor.0 + 1, 0);
        }
    }
    (found.counts != [0; GROUP]).then_some(found)
}
