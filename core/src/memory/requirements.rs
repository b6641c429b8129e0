//! How much memory a scene needs for each array.
use crate::layout::{Model, TABLE_WORDS};
use crate::plan::Plan;
use crate::plan::arrays::{Array, Class, Unit};
use crate::validate::Checked;

/// Smallest number of words of the neighbour lists per particle: one for the range of its group, and two neighbours in
/// each of the others. A group whose list does not fit searches its cells in each pass.
pub const LIST_WORDS: usize = 21;

/// Largest number of neighbours that are listed for a particle.
pub(crate) const MOST_LISTED: usize = 240;

/// Places in the lists per neighbour. Lists are padded, and a fluid may be compressed.
const PLACES_PER_NEIGHBOUR: f32 = 1.25;

/// Returns the words of the lists per particle that hold this number of neighbours, or as many as a list can have.
pub(super) const fn list_words(average_neighbours: f32) -> usize {
    let places = (average_neighbours * PLACES_PER_NEIGHBOUR) as usize;
    let words = 1 + if places < MOST_LISTED { places / 2 } else { MOST_LISTED / 2 };
    if words < LIST_WORDS { LIST_WORDS } else { words }
}

/// Alignment of arrays in an arena, in words: a cache line.
pub(super) const LINE_WORDS: usize = 16;

/// The counts that determine the lengths of arrays.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// All particles, including wall particles and inactive ones.
    pub particles: usize,
    /// Number of cells; one more than the grid has if particles can be inactive.
    pub cells: usize,
    /// Words of the neighbour lists per particle.
    pub list_words: usize,
    /// Number of spring ends, two per spring.
    pub spring_ends: usize,
    /// Number of particles that can become active: those of the layer of air, or all.
    pub spares: usize,
    /// Number of emitters.
    pub emitters: usize,
    /// Number of points of all emitters.
    pub emitter_points: usize,
    /// Number of rows of the poses of solids and of the sides of polygons.
    pub pose_rows: usize,
    /// Number of nodes of the acceleration field supplied by the caller.
    pub field_nodes: usize,
}

/// How much memory a scene needs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Requirements {
    /// The model, which determines which arrays exist.
    model: Model,
    /// The counts, which determine how long the arrays are.
    pub counts: Counts,
}

impl Requirements {
    /// The requirements of a scene with its own plan.
    #[must_use]
    pub fn of(scene: &Checked<'_>) -> Requirements {
        Requirements::by_plan(scene, &Plan::of(scene))
    }

    /// The requirements of a scene with the given plan.
    #[must_use]
    pub fn by_plan(scene: &Checked<'_>, plan: &Plan) -> Requirements {
        let (model, derived) = (plan.model, scene.derived());
        let counts = Counts {
            particles: derived.particles(),
            cells: derived.parameters.cells[3] as usize,
            list_words: list_words(derived.average_neighbours),
            spring_ends: if model.has_springs == 1 { derived.spring_ends } else { 0 },
            spares: if scene.has_turnover() { derived.particles() } else { derived.inactive_particles },
            emitters: scene.emitters.len(),
            emitter_points: derived.emitter_points,
            pose_rows: derived.pose_rows,
            field_nodes: derived.field_counts[3] as usize,
        };
        Requirements { model, counts }
    }

    /// The requirements for the given model and counts.
    #[must_use]
    pub fn by_model(model: Model, counts: Counts) -> Requirements {
        Requirements { model, counts }
    }

    /// The same requirements for another number of particles.
    #[must_use]
    pub fn for_particles(mut self, particles: usize) -> Requirements {
        self.counts.particles = particles;
        if self.model.has_turnover == 1 {
            self.counts.spares = particles;
        }
        self
    }

    /// The model, which determines which arrays exist.
    #[must_use]
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// Number of entries of an array; 0 if it does not exist.
    #[must_use]
    pub fn entries(&self, array: Array) -> usize {
        let Counts { particles, cells, list_words, spring_ends, spares, .. } = self.counts;
        if !array.exists(&self.model) {
            return 0;
        }
        match array.unit() {
            Unit::Particle => particles,
            Unit::Cell => cells,
            Unit::CellPlace => cells.saturating_mul(self.model.cell_places as usize),
            Unit::NeighbourWord => particles.saturating_mul(list_words),
            Unit::SpringEnd => spring_ends,
            Unit::SpawnRequest => particles.saturating_add(spares),
            Unit::Emitter => self.counts.emitters,
            Unit::EmitterRow => self.counts.emitter_points.saturating_mul(2),
            Unit::PoseRow => self.counts.pose_rows,
            Unit::FieldPoint => self.counts.field_nodes,
            Unit::TableWord => TABLE_WORDS,
        }
    }

    /// Number of copies of an array: 0, 1 or 2.
    #[must_use]
    pub fn copies(&self, array: Array) -> usize {
        array.copies(&self.model)
    }

    /// Number of copies with memory of their own: 0 for an array that lies in the memory of the neighbour lists.
    fn own_copies(&self, array: Array) -> usize {
        if array.class() == Class::Sorting { 0 } else { self.copies(array) }
    }

    /// Bytes of all copies of an array; 0 for an array that lies in the memory of the neighbour lists.
    #[must_use]
    pub fn bytes_of(&self, array: Array) -> usize {
        self.own_copies(array).saturating_mul(self.entries(array)).saturating_mul(array.words() * size_of::<u32>())
    }

    /// Bytes of all arrays.
    #[must_use]
    pub fn bytes(&self) -> usize {
        Array::ALL.iter().map(|&array| self.bytes_of(array)).fold(0, usize::saturating_add)
    }

    /// Bytes of all copies of an array in an arena, where each copy starts at a cache line.
    pub(super) fn arena_bytes_of(&self, array: Array) -> usize {
        let line = LINE_WORDS * size_of::<u32>();
        let copy = self.entries(array).saturating_mul(array.words() * size_of::<u32>());
        self.own_copies(array).saturating_mul(copy.div_ceil(line).saturating_mul(line))
    }

    /// Bytes of an arena that holds all arrays.
    #[must_use]
    pub fn arena_bytes(&self) -> usize {
        Array::ALL.iter().map(|&array| self.arena_bytes_of(array)).fold(0, usize::saturating_add)
    }
}
