//! Lanes as receivers by neighbours. Each block of four lanes holds four neighbours of one particle, the receiver,
//! whose own numbers are the same in all four lanes, so nearly every lane holds a pair. The terms do not depend on this
//! layout. Sums are added up in the order of the neighbours, one after the other, so that the SIMD level does not
//! change a bit.
use super::blocks::Blocks;
use super::codes::{FEW, MOST_LANES, Offsets, ROW_BITS, Windows, slot};
use super::real::{Real, vec3};
use crate::layout::f32x4;

/// The slot of a particle for each lane. All slots are below the number of particles.
pub(crate) struct Slots {
    /// Byte offsets of the rows: one array is in use, while the other is being prepared.
    offsets: [Offsets; 2],
    /// Index of the array in use.
    turn: usize,
    particles: usize,
}

impl Slots {
    /// Returns the first slot in all lanes, for a scene with this number of particles.
    #[inline(always)]
    pub(crate) fn first(particles: usize) -> Slots {
        assert!(particles > 0 && particles < 1 << (u32::BITS - ROW_BITS), "offsets have 32 bits");
        Slots { offsets: [Offsets([0; MOST_LANES]); 2], turn: 0, particles }
    }

    /// Decodes the slots of the next neighbours, one per lane, while the current slots stay in use.
    ///
    /// # Panics
    /// If a code does not stand for a particle.
    #[inline(always)]
    pub(crate) fn prepare<R: Lanes>(&mut self, codes: &[u16], windows: &Windows) {
        let ready = &mut self.offsets[(self.turn ^ 1) & 1];
        assert!(R::decode(codes, windows, ready, self.particles as u32), "a list names nobody");
    }

    /// Switches to the slots that were decoded last.
    #[inline(always)]
    pub(crate) fn advance(&mut self) {
        self.turn ^= 1;
    }

    /// Switches to these slots.
    ///
    /// # Panics
    /// If a slot does not hold a particle.
    #[inline(always)]
    pub(crate) fn set(&mut self, slots: &[u32; MOST_LANES]) {
        assert!(slots.iter().all(|&slot| (slot as usize) < self.particles), "a search found nobody");
        self.offsets[self.turn] = Offsets(slots.map(|slot| slot << ROW_BITS));
    }

    #[inline(always)]
    #[expect(
        unsafe_code,
        reason = "to be read from memory, where a vector was stored: lanes taken out of its register are slower"
    )]
    fn offset(&self, lane: usize) -> usize {
        // SAFETY: the pointer comes from a reference to a number that this value owns.
        unsafe { core::ptr::from_ref(&self.offsets[self.turn & 1].0[lane]).read_volatile() as usize }
    }

    /// Returns the slot of a lane's particle.
    #[inline(always)]
    pub(crate) fn lane(&self, lane: usize) -> usize {
        self.offset(lane) >> ROW_BITS
    }

    /// Returns the row of a lane's particle.
    #[inline(always)]
    #[expect(unsafe_code, reason = "a bound to check a lane and array would cost a fifth of a step")]
    pub(crate) fn row<'r>(&self, rows: &'r [f32x4], lane: usize) -> &'r f32x4 {
        assert!(self.particles <= rows.len());
        // SAFETY: `first`, `prepare` and `set`, which fill the offsets, check that each slot is below `particles`, and
        // there are at least that many rows.
        unsafe { &*rows.as_ptr().byte_add(self.offset(lane)) }
    }
}

/// A SIMD level whose lanes can hold receivers by neighbours.
pub(crate) trait Lanes: Real {
    /// Number of receivers side by side.
    const RECEIVERS: usize;
    /// Number of neighbours of each receiver side by side.
    const NEIGHBOURS: usize;
    /// Four running sums for each receiver.
    type Sums: Copy;

    /// Returns the four numbers of each lane's particle.
    fn gather(rows: &[f32x4], slots: &Slots) -> [Self; 4];
    /// Returns the four numbers of each receiver, in all of the receiver's lanes.
    fn spread<'r>(row: impl Fn(usize) -> &'r f32x4) -> [Self; 4];
    /// Writes a row for each receiver, from four vectors that hold one number in all lanes of a receiver.
    fn rows(spread: [Self; 4], out: &mut [f32x4]);
    /// Returns the four numbers of as many particles as there are lanes, one particle per lane.
    fn load<'r>(row: impl Fn(usize) -> &'r f32x4) -> [Self; 4];
    /// Writes vectors with one particle per lane back as rows.
    fn store(lanes: [Self; 4], out: &mut [f32x4]);

    /// Returns sums to which nothing has been added.
    fn nothing() -> Self::Sums;
    /// Returns the sums after adding the contributions of the neighbours in the lanes, one after the other.
    fn add_up(sums: Self::Sums, parts: [Self; 4]) -> Self::Sums;
    /// Returns the sums of each receiver, in all of the receiver's lanes.
    fn sums(sums: Self::Sums) -> [Self; 4];

    /// Returns as many numbers of each receiver as it has neighbours in the lanes.
    fn numbers<'r>(of: impl Fn(usize) -> &'r [f32]) -> Self;
    /// Reads consecutive numbers, one per lane.
    fn read(from: &[f32]) -> Self;
    /// Writes consecutive numbers, one per lane.
    fn write(self, to: &mut [f32]);
    /// Decodes codes to the byte offsets of their slots. Returns false if a slot is not below the limit.
    fn decode(codes: &[u16], windows: &Windows, offsets: &mut Offsets, limit: u32) -> bool;
    /// Appends the codes and numbers of the lanes in which the mask holds, and returns the new number of entries. There
    /// must be room for all lanes.
    fn append(to: (&mut [u32], &mut [f32]), used: usize, codes: &[u32], numbers: Self, mask: Self::Mask) -> usize;
    /// Returns entries of a column. `index` is an integer below the column's length.
    fn pick(column: &[f32; FEW], index: Self) -> Self;
}

/// Returns the first three of four numbers as a vector.
#[inline(always)]
pub(crate) fn xyz<R>([x, y, z, _]: [R; 4]) -> vec3<R> {
    vec3(x, y, z)
}

/// One receiver and one of its neighbours.
impl Lanes for f32 {
    const RECEIVERS: usize = 1;
    const NEIGHBOURS: usize = 1;
    type Sums = [f32; 4];

    #[inline(always)]
    fn gather(rows: &[f32x4], slots: &Slots) -> [f32; 4] {
        *slots.row(rows, 0)
    }
    #[inline(always)]
    fn spread<'r>(row: impl Fn(usize) -> &'r f32x4) -> [f32; 4] {
        *row(0)
    }
    #[inline(always)]
    fn rows(spread: [f32; 4], out: &mut [f32x4]) {
        out[0] = spread;
    }
    #[inline(always)]
    fn load<'r>(row: impl Fn(usize) -> &'r f32x4) -> [f32; 4] {
        *row(0)
    }
    #[inline(always)]
    fn store(lanes: [f32; 4], out: &mut [f32x4]) {
        out[0] = lanes;
    }
    #[inline(always)]
    fn nothing() -> [f32; 4] {
        [0.0; 4]
    }
    #[inline(always)]
    fn add_up([x, y, z, w]: [f32; 4], [a, b, c, d]: [f32; 4]) -> [f32; 4] {
        [x + a, y + b, z + c, w + d]
    }
    #[inline(always)]
    fn sums(sums: [f32; 4]) -> [f32; 4] {
        sums
    }
    #[inline(always)]
    fn numbers<'r>(of: impl Fn(usize) -> &'r [f32]) -> f32 {
        of(0)[0]
    }
    #[inline(always)]
    fn read(from: &[f32]) -> f32 {
        from[0]
    }
    #[inline(always)]
    fn write(self, to: &mut [f32]) {
        to[0] = self;
    }
    #[inline(always)]
    fn decode(codes: &[u16], windows: &Windows, offsets: &mut Offsets, limit: u32) -> bool {
        let slot = slot(codes[0], windows);
        offsets.0[0] = slot << ROW_BITS;
        slot < limit
    }
    #[inline(always)]
    fn append(to: (&mut [u32], &mut [f32]), used: usize, codes: &[u32], number: f32, mask: bool) -> usize {
        to.0[used] = codes[0];
        to.1[used] = number;
        used + usize::from(mask)
    }
    #[inline(always)]
    fn pick(column: &[f32; FEW], index: f32) -> f32 {
        column[(index as usize).min(FEW - 1)]
    }
}

/// Blocks of four lanes: each block holds one receiver, with four of its neighbours.
impl<R: Blocks> Lanes for R {
    const RECEIVERS: usize = R::LANES / 4;
    const NEIGHBOURS: usize = 4;
    type Sums = R;

    #[inline(always)]
    fn gather(rows: &[f32x4], slots: &Slots) -> [R; 4] {
        let first = R::of_rows(|block| slots.row(rows, 4 * block));
        let second = R::of_rows(|block| slots.row(rows, 4 * block + 1));
        let third = R::of_rows(|block| slots.row(rows, 4 * block + 2));
        let fourth = R::of_rows(|block| slots.row(rows, 4 * block + 3));
        R::transpose([first, second, third, fourth])
    }
    #[inline(always)]
    fn spread<'r>(row: impl Fn(usize) -> &'r f32x4) -> [R; 4] {
        R::sums(R::of_rows(row))
    }
    #[inline(always)]
    fn rows(spread: [R; 4], out: &mut [f32x4]) {
        let [rows, ..] = R::transpose(spread);
        for (block, out) in out.iter_mut().enumerate().take(R::RECEIVERS) {
            *out = rows.block(block);
        }
    }
    #[inline(always)]
    fn load<'r>(row: impl Fn(usize) -> &'r f32x4) -> [R; 4] {
        let first = R::of_rows(|block| row(4 * block));
        let second = R::of_rows(|block| row(4 * block + 1));
        let third = R::of_rows(|block| row(4 * block + 2));
        let fourth = R::of_rows(|block| row(4 * block + 3));
        R::transpose([first, second, third, fourth])
    }
    #[inline(always)]
    fn store(lanes: [R; 4], out: &mut [f32x4]) {
        let [first, second, third, fourth] = R::transpose(lanes);
        if out.len() >= R::LANES {
            for block in 0..R::RECEIVERS {
                out[4 * block] = first.block(block);
                out[4 * block + 1] = second.block(block);
                out[4 * block + 2] = third.block(block);
                out[4 * block + 3] = fourth.block(block);
            }
            return;
        }
        for (lane, out) in out.iter_mut().enumerate() {
            let row = match lane % 4 {
                0 => first,
                1 => second,
                2 => third,
                _ => fourth,
            };
            *out = row.block(lane / 4);
        }
    }
    #[inline(always)]
    fn nothing() -> R {
        R::splat(0.0)
    }
    #[inline(always)]
    fn add_up(sums: R, parts: [R; 4]) -> R {
        let [first, second, third, fourth] = R::transpose(parts);
        sums + first + second + third + fourth
    }
    #[inline(always)]
    fn sums(sums: R) -> [R; 4] {
        [sums.first(), sums.second(), sums.third(), sums.fourth()]
    }
    #[inline(always)]
    fn numbers<'r>(of: impl Fn(usize) -> &'r [f32]) -> R {
        R::of_rows(|block| of(block).first_chunk().unwrap_or(&[0.0; 4]))
    }
    #[inline(always)]
    fn read(from: &[f32]) -> R {
        R::read_lanes(from)
    }
    #[inline(always)]
    fn write(self, to: &mut [f32]) {
        self.write_lanes(to);
    }
    #[inline(always)]
    fn decode(codes: &[u16], windows: &Windows, offsets: &mut Offsets, limit: u32) -> bool {
        R::decode_lanes(codes, windows, offsets, limit)
    }
    #[inline(always)]
    fn append(to: (&mut [u32], &mut [f32]), used: usize, codes: &[u32], numbers: R, mask: R::Mask) -> usize {
        R::compress(to, used, codes, numbers, mask)
    }
    #[inline(always)]
    fn pick(column: &[f32; FEW], index: R) -> R {
        R::permute(column, index)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arithmetic::codes::WINDOW_BITS;
    use crate::arithmetic::level::{Simd, Work};

    /// Decodes a code in all lanes, and notes whether the slots are below the limit.
    struct Decode<'a> {
        code: u16,
        windows: &'a Windows,
        limit: u32,
        fits: &'a mut bool,
    }

    impl Work for Decode<'_> {
        #[inline(always)]
        fn run<R: Lanes>(self) {
            let mut offsets = Offsets([0; MOST_LANES]);
            *self.fits = R::decode(&[self.code; MOST_LANES], self.windows, &mut offsets, self.limit);
        }
    }

    #[test]
    fn codes_of_no_particle_are_seen_whatever_the_windows_hold() {
        let windows = [0, 90, 1 << 31, u32::MAX - 5, u32::MAX, 8000, i32::MIN as u32, 100];
        for simd in Simd::available() {
            for (window, start) in (0u16..).zip(windows) {
                for place in [0, 1, 5, 8191] {
                    let code = window << WINDOW_BITS | place;
                    let slot = start.wrapping_add(u32::from(place));
                    for limit in [1, 6, 100, (1 << 28) - 1] {
                        let mut fits = false;
                        simd.run(Decode { code, windows: &windows, limit, fits: &mut fits });
                        assert_eq!(fits, slot < limit, "{simd:?}: window at {start}, place {place}, {limit} particles");
                    }
                }
            }
        }
    }

    /// Collects the bits of the larger and the smaller of every two of some numbers, as computed in the last lane.
    struct Extremes<'a>(&'a mut std::vec::Vec<[u32; 4]>);

    impl Work for Extremes<'_> {
        #[inline(always)]
        fn run<R: Lanes>(self) {
            let subnormal = f32::from_bits(1);
            let numbers =
                [0.0, -0.0, 1.0, -1.0, subnormal, -subnormal, f32::MAX, f32::INFINITY, f32::NEG_INFINITY, f32::NAN];
            for x in numbers {
                for y in numbers {
                    let (a, b) = (R::splat(x), R::splat(y));
                    let lane = R::LANES - 1;
                    let found = [a.larger(b), a.smaller(b)].map(|extreme| extreme.lane(lane).to_bits());
                    self.0.push([x.to_bits(), y.to_bits(), found[0], found[1]]);
                }
            }
        }
    }

    #[test]
    fn the_larger_and_the_smaller_are_the_same_at_every_level() {
        let of = |simd: Simd| {
            let mut found = std::vec::Vec::new();
            simd.run(Extremes(&mut found));
            found
        };
        let want = of(Simd::Scalar);
        for [x, y, larger, smaller] in &want {
            let (a, b) = (f32::from_bits(*x), f32::from_bits(*y));
            assert_eq!([*larger, *smaller], [if a < b { y } else { x }, if b < a { y } else { x }].map(|bits| *bits));
        }
        for simd in Simd::available() {
            assert_eq!(of(simd), want, "{simd:?}");
        }
    }
}
