//! Saves a fluid as bytes and restores it: every array of the state, and everything else that the next step depends on.
//! Continuing from the bytes gives the same bits as never having stopped, on either backend.
//!
//! The bytes are little-endian words of four bytes: a head, the [`Record`], then the arrays in the order of the table.
//! The entries of particles are in order of ids, so that slots, backend and grid do not change a byte.
use crate::clock::Clock;
use crate::error::RestoreError;
use crate::hash::Fnv;
use crate::memory::Requirements;
use crate::plan::arrays::{Array, Class, Unit};
pub use crate::record::Record;
use crate::solver::Solver;

/// First word: `MPND`.
const MAGIC: u32 = u32::from_le_bytes(*b"MPND");

/// Version of the format. It is incremented whenever the format changes.
pub const VERSION: u32 = 5;

/// Words before the record: magic number, version, fingerprint of the scene, and hash of everything after the head.
const HEAD_WORDS: usize = 6;

/// Bytes of the head.
const HEAD: usize = HEAD_WORDS * size_of::<u32>();

/// The arrays that are saved: those of the state, and those that were set at the start or by the caller and cannot be
/// computed from the scene.
fn saved(requirements: &Requirements) -> impl Iterator<Item = Array> + use<> {
    let model = *requirements.model();
    let is_saved = |array: &Array| match array.class() {
        Class::State => true,
        Class::Given => !matches!(array, Array::kernel_tables | Array::emitters | Array::emitter_points),
        Class::Index | Class::Sorting | Class::Scratch => false,
    };
    Array::ALL.iter().copied().filter(move |array| is_saved(array) && array.exists(&model))
}

/// Number of bytes of a saved fluid with these requirements.
#[must_use]
pub fn saved_bytes(requirements: &Requirements) -> usize {
    let words: usize = saved(requirements).map(|array| requirements.entries(array) * array.words()).sum();
    (HEAD_WORDS + Record::WORDS + words) * size_of::<u32>()
}

/// Writes a fluid to `out`. `words` returns the contents of an array, and `slots` is the slot of each particle by id.
/// Both backends use this function.
///
/// # Errors
/// [`RestoreError::WrongLength`] if the length of `out` is not [`saved_bytes`].
pub fn write<'a>(
    (requirements, fingerprint): (&Requirements, u64),
    record: &Record,
    slots: &[u32],
    words: impl Fn(Array) -> &'a [u32],
    out: &mut [u8],
) -> Result<(), RestoreError> {
    let (given, expected) = (out.len(), saved_bytes(requirements));
    if given != expected {
        return Err(RestoreError::WrongLength { given, expected });
    }
    let (head, body) = out.split_at_mut(HEAD);
    let mut places = body.chunks_exact_mut(size_of::<u32>());
    let mut put = |word: u32| {
        if let Some(place) = places.next() {
            place.copy_from_slice(&word.to_le_bytes());
        }
    };
    record.each_word(&mut put);
    for array in saved(requirements) {
        let (all, entry) = (words(array), array.words());
        if by_slot(array) {
            let entries = slots.iter().filter_map(|&slot| all.get(slot as usize * entry..)?.get(..entry));
            entries.flatten().copied().for_each(&mut put);
        } else {
            all.iter().copied().for_each(&mut put);
        }
    }
    let hash = hash_of(body);
    let words = [MAGIC, VERSION, fingerprint as u32, (fingerprint >> 32) as u32, hash as u32, (hash >> 32) as u32];
    for (place, word) in head.chunks_exact_mut(size_of::<u32>()).zip(words) {
        place.copy_from_slice(&word.to_le_bytes());
    }
    Ok(())
}

/// Bytes as words, little-endian.
fn words_of(bytes: &[u8]) -> impl Iterator<Item = u32> {
    bytes.chunks_exact(4).map(|bytes| u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]))
}

/// Hash that detects damaged bytes.
fn hash_of(body: &[u8]) -> u64 {
    words_of(body).fold(Fnv::default(), Fnv::word).0
}

/// Returns whether the entries of an array are in the slots of the particles. Otherwise they are in order of ids, or do
/// not belong to particles.
fn by_slot(array: Array) -> bool {
    array.class() == Class::State && array.unit() == Unit::Particle
}

impl Solver<'_> {
    /// Number of bytes that [`Solver::save`] writes.
    #[must_use]
    pub fn saved_bytes(&self) -> usize {
        saved_bytes(self.requirements())
    }

    /// Writes the fluid as bytes. Continuing from them, by [`Solver::restore`] of a solver of the same scene, gives the
    /// same bits as never having stopped. The bytes are the same on both backends, and do not depend on the structure
    /// of the grid, the number of threads or the width of SIMD lanes.
    ///
    /// # Errors
    /// [`RestoreError::WrongLength`] if the length of `out` is not [`Solver::saved_bytes`].
    pub fn save(&self, out: &mut [u8]) -> Result<(), RestoreError> {
        let key = (self.requirements(), self.fingerprint());
        write(key, &self.record(), self.slots(), |array| self.words(array), out)
    }

    /// Continues from the bytes of [`Solver::save`], or from those saved on a GPU.
    ///
    /// # Errors
    /// If the bytes were not written by a solver, are of another version, of another scene or of another length, are
    /// damaged, or hold values that the scene does not allow. In these cases the fluid stays as it was.
    pub fn restore(&mut self, bytes: &[u8]) -> Result<(), RestoreError> {
        let (given, expected) = (bytes.len(), self.saved_bytes());
        let mut words = words_of(bytes);
        let mut head = [0; HEAD_WORDS];
        head.iter_mut().zip(&mut words).for_each(|(place, word)| *place = word);
        let [magic, version, low, high, hash_low, hash_high] = head;
        let wide = |low: u32, high: u32| u64::from(low) | u64::from(high) << 32;
        if magic != MAGIC {
            return Err(RestoreError::NotSaved);
        }
        if version != VERSION {
            return Err(RestoreError::WrongVersion { given: version, known: VERSION });
        }
        if wide(low, high) != self.fingerprint() {
            return Err(RestoreError::AnotherScene);
        }
        if given != expected {
            return Err(RestoreError::WrongLength { given, expected });
        }
        if wide(hash_low, hash_high) != hash_of(&bytes[HEAD..]) {
            return Err(RestoreError::Damaged);
        }
        let mut record = [0; Record::WORDS];
        record.iter_mut().zip(&mut words).for_each(|(place, word)| *place = word);
        self.take_record(&Record::of_words(&record))?;
        for array in saved(self.requirements()) {
            let place = self.words_mut(array);
            place.iter_mut().zip(&mut words).for_each(|(place, word)| *place = word);
        }
        // particles are now in order of their ids; the next step sorts them
        self.number_in_order();
        Ok(())
    }

    fn record(&self) -> Record {
        let (clock, counts) = self.clock.to_record();
        Record {
            steps: self.steps(),
            steady: self.steady_time(),
            due: self.due(),
            clock,
            time_step: self.uniform().time_step,
            counts,
            correction: self.correction(),
            flux: self.census,
            live: self.live().values(),
        }
    }

    fn take_record(&mut self, record: &Record) -> Result<(), RestoreError> {
        let (live, mut constants) = self.live().with_values(&record.live).map_err(RestoreError::Scene)?;
        constants.step = constants.step.with_time_step(record.time_step);
        constants.step.step = record.steps as u32;
        self.continue_from(live, &constants, record);
        self.clock = Clock::of_record(record.clock, record.counts);
        self.census = record.flux;
        Ok(())
    }
}
