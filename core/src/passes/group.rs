//! Receivers side by side, and the walk over their neighbours: from the lists, or where those did not fit by a search
//! of the cells.
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

/// What the search of a group's cells needs. The search is not compiled into the loops, so it gets the constants of the
/// whole step: were it handed a reference to a loop's own copy, the compiler could not take that for constant any more.
#[derive(Clone, Copy)]
pub(crate) struct Surroundings<'a> {
    pub setup: Setup<'a>,
    pub particles: Particles<'a>,
    pub cells: Cells<'a>,
}

/// As many particles, side by side from `first` on, as the lanes hold receivers.
#[derive(Clone, Copy)]
pub(crate) struct Group<'a> {
    pub setup: &'a Setup<'a>,
    pub particles: Particles<'a>,
    pub lists: Lists<'a>,
    pub surroundings: &'a Surroundings<'a>,
    pub first: usize,
    pub last: usize,
}

/// Folds what the neighbours of a group add: four sums a receiver, each in the order of its neighbours, in all of the
/// receiver's lanes. Where a particle `adds nothing to itself`, but zeros, the lanes that hold no pair need no mask.
///
/// A macro, since a closure cannot be told to be compiled into its caller, at its caller's SIMD level.
macro_rules! fold {
    ($group:ident: $R:ident, |$slots:ident| $parts:expr) => {
        $crate::passes::group::fold!(@ $group: $R, true, |$slots| $parts)
    };
    ($group:ident: $R:ident, adds nothing to itself, |$slots:ident| $parts:expr) => {
        $crate::passes::group::fold!(@ $group: $R, false, |$slots| $parts)
    };
    (@ $group:ident: $R:ident, $is_masked:literal, |$slots:ident| $parts:expr) => {{
        let mut sums = <$R>::nothing();
        // apart from the walk, which would have to lie in memory with them
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
    /// What the pair terms know of the receivers.
    #[inline(always)]
    pub(crate) fn receivers<R: Lanes>(&self) -> Local<R> {
        self.particles.receivers(self.setup, self.first, self.last)
    }

    /// And of the neighbours in the lanes.
    #[inline(always)]
    pub(crate) fn neighbours<R: Lanes>(&self, slots: &Slots) -> Local<R> {
        self.particles.neighbours(self.setup, slots)
    }

    /// Four numbers of the receivers, each in all of its lanes.
    #[inline(always)]
    pub(crate) fn spread<R: Lanes>(&self, rows: &[f32x4]) -> [R; 4] {
        spread(rows, self.first, self.last)
    }

    /// Are all of them walls', or inactive? Nothing acts on those.
    #[inline(always)]
    pub(crate) fn are_walls(&self) -> bool {
        self.particles.are_walls(self.setup, self.first, self.last)
    }
}

/// Where the search of each receiver's cells stands: its run, and the slot in it.
pub(crate) type Cursors = [(usize, usize); GROUP];

/// A walk over the neighbours of a group.
pub(crate) struct Walk<'a, R> {
    surroundings: &'a Surroundings<'a>,
    first: usize,
    last: usize,
    /// The codes from the group's first receiver on.
    listed: Option<Listed<'a>>,
    /// Those after the ones that are ready.
    next: usize,
    /// Are any ready?
    is_ready: bool,
    /// How many neighbours of each receiver came before those in the lanes, and how many there are of each.
    before: usize,
    count: R,
}

impl<'a, R: Lanes> Walk<'a, R> {
    /// From the first neighbours on.
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

    /// Goes on to the next neighbours; false where there are none. Their slots were made ready while the ones before
    /// were worked on: a processor does not look far enough ahead to do so by itself.
    #[inline(always)]
    pub(crate) fn next(&mut self, slots: &mut Slots, cursors: &mut Cursors) -> bool {
        if self.is_ready {
            // a chunk after the other, or the places of a receiver in them
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

    /// Makes the slots of the next neighbours ready, if there are any.
    #[inline(always)]
    fn prepare(&mut self, slots: &mut Slots) {
        self.is_ready = false;
        let Some(listed) = &self.listed else { return };
        if let Some(codes) = listed.codes.get(self.next..).filter(|codes| codes.len() >= R::LANES) {
            slots.prepare::<R>(codes, listed.windows);
            self.is_ready = true;
        }
    }

    /// Zeros in the lanes that hold no pair.
    #[inline(always)]
    pub(crate) fn listed(&self, parts: [R; 4]) -> [R; 4] {
        let place = R::from_lanes(|lane| (lane % R::NEIGHBOURS) as f32) + self.before as f32;
        masked(parts, less(place, self.count))
    }
}

/// Zeros where the mask does not hold.
#[inline(always)]
pub(crate) fn masked<R: Lanes>([x, y, z, w]: [R; 4], mask: R::Mask) -> [R; 4] {
    let none = real(0.0);
    [select(none, x, mask), select(none, y, mask), select(none, z, mask), select(none, w, mask)]
}

/// The next neighbours of each receiver.
struct Found {
    slots: [u32; MOST_LANES],
    counts: [usize; GROUP],
}

/// Finds the next few neighbours of each receiver in its cells; nothing where none is left.
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
