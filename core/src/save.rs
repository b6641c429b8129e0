//! A fluid as bytes, and back: every array of the state and what else the next step goes on from. Going on from there gives the same bits
//! as never having stopped, on either backend.
//!
//! The bytes are words of four, little-endian: a head, the [`Record`], then the arrays in the order of the table, the entries
//! of particles in the order of their ids, so that neither slots nor backend nor grid change a byte.
use crate::clock::Clock;
use crate::error::RestoreError;
use crate::hash::Fnv;
use crate::memory::Requirements;
use crate::plan::arrays::{Array, Class, Unit};
pub use crate::record::Record;
use crate::solver::Solver;

/// First word: `MPND`.
const MAGIC: u32 = u32::from_le_bytes(*b"MPND");

/// Version of the bytes. It changes with whatever is written.
pub const VERSION: u32 = 2;

/// Words before the record: magic, version, the fingerprint of the scene, and the hash of all that follows.
const HEAD_WORDS: usize = 6;

/// Bytes of the head.
const HEAD: usize = HEAD_WORDS * size_of::<u32>();

/// The arrays that are saved: those of the state, and what the host or the start has given but for what follows from the scene.
fn saved(requirements: &Requirements) -> impl Iterator<Item = Array> + use<> {
    let model = *requirements.model();
    let is_saved = |array: &Array| match array.class() {
        Class::State => true,
        Class::Given => *array != Array::kernel_tables,
        Class::Index | Class::Sorting | Class::Scratch => false,
    };
    Array::ALL.iter().copied().filter(move |array| is_saved(array) && array.exists(&model))
}

/// Bytes of a fluid with these requirements.
#[must_use]
pub fn saved_bytes(requirements: &Requirements) -> usize {
    let words: usize = saved(requirements).map(|array| requirements.entries(array) * array.words()).sum();
    (HEAD_WORDS + Record::WORDS + words) * size_of::<u32>()
}

/// Writes a fluid whose arrays are given by `words`, and whose particles lie in these slots. Used by both backends.
///
/// # Errors
/// A buffer of another length than [`saved_bytes`].
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

/// What tells damaged bytes.
fn hash_of(body: &[u8]) -> u64 {
    words_of(body).fold(Fnv::default(), Fnv::word).0
}

/// Do the entries of an array lie in the slots of the particles? Else they stand by id, or are no particles'.
fn by_slot(array: Array) -> bool {
    array.class() == Class::State && array.unit() == Unit::Particle
}

impl Solver<'_> {
    /// Bytes that [`Solver::save`] writes.
    #[must_use]
    pub fn saved_bytes(&self) -> usize {
        saved_bytes(self.requirements())
    }

    /// Writes the fluid as bytes: going on from them, by [`Solver::restore`] of a solver of the same scene, gives the same bits as never
    /// having stopped. The bytes are the same on both backends, whatever the grid's structure, threads and lanes were.
    ///
    /// # Errors
    /// A buffer of another length than [`Solver::saved_bytes`].
    pub fn save(&self, out: &mut [u8]) -> Result<(), RestoreError> {
        let key = (self.requirements(), self.fingerprint());
        write(key, &self.record(), self.slots(), |array| self.words(array), out)
    }

    /// Goes on from the bytes of [`Solver::save`], or of a device.
    ///
    /// # Errors
    /// Bytes of another length, another version or another scene, or damaged ones; the fluid then is as it was.
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
        // particles now lie in the order of their ids; the next step sorts them
        self.lie_by_id();
        Ok(())
    }

    fn record(&self) -> Record {
        let (clock, counts) = self.clock.to_record();
        Record {
            steps: self.steps(),
            steady: self.steady_time(),
            clock,
            time_step: self.uniform().time_step,
            counts,
            correction: self.correction(),
            air_refused: self.air_refused,
            live: self.live().values(),
        }
    }

    fn take_record(&mut self, record: &Record) -> Result<(), RestoreError> {
        let (live, mut constants) = self.live().with_values(&record.live).map_err(RestoreError::Scene)?;
        constants.step = constants.step.with_time_step(record.time_step);
        constants.step.step = record.steps as u32;
        self.go_on(live, &constants, record);
        self.clock = Clock::of_record(record.clock, record.counts);
        self.air_refused = record.air_refused;
        Ok(())
    }
}
