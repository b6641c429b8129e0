//! Guided creation: from the size of a volume of fluid, its physical properties and one number for the resolution to
//! everything that a scene needs (Pirovano, sections 4.1.4 and 4.1.5).
use crate::derive::support_radius;
use crate::error::SceneError;
use crate::scene::{Block, Dimension, Fluid, Scene};
use glam::Vec3;

/// Particles along the shortest side of the volume, by number class. Class 0 is that of Pirovano's figure 4.1, class 2
/// that of the performance test (section 5.2), and class 3 that of the water jet (section 5.1.3); the others are our
/// choice.
pub const NUMBER_CLASSES: [u32; 11] = [5, 10, 16, 32, 40, 48, 64, 80, 96, 112, 128];

/// Neighbours of class 0, which has so few particles that more neighbours help (Pirovano, figure 4.1), and of all others
/// (section 4.1.5).
const NEIGHBOURS: [f32; 2] = [40.0, 32.0];

/// What the user decides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Guide {
    /// Dimension of space.
    pub dimension: Dimension,
    /// Extents of the volume of fluid, m, larger than 0. In 2D the extent along z is ignored.
    pub size: Vec3,
    /// Number class, 0 to 10: how fine the resolution is ([`NUMBER_CLASSES`]).
    pub number_class: u32,
    /// The fluid. The speed of sound should be ten times the speed of the fastest flow.
    pub fluid: Fluid,
    /// Average number of neighbours (`None`: 40 in class 0, else 32).
    pub average_neighbours: Option<f32>,
}

/// What follows from it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Guided {
    /// Particles along x, y and z: as many along the shortest side as the number class says, and along the others in
    /// proportion, as in Pirovano's source code 4.1.
    pub counts: [u32; 3],
    /// Number of particles.
    pub particles: u32,
    /// Distance between particles whose outermost ones lie on the surface of the volume, m: Pirovano's fixed distance.
    pub fixed_distance: f32,
    /// Distance between particles in the centres of equal cells, m, each of which has the mass of the fluid in its cell.
    /// The scene starts with this one.
    pub particle_spacing: f32,
    /// Average number of neighbours.
    pub average_neighbours: f32,
    /// Support radius, m.
    pub support_radius: f64,
    /// Mass of a particle, kg (per metre of depth in 2D): that of the fluid over the number of particles. With
    /// [`Formulation::normalize_mass`](crate::scene::Formulation::normalize_mass) the scene adapts it to the lattice.
    pub particle_mass: f64,
    /// Mass of the fluid, kg (per metre of depth in 2D).
    pub total_mass: f64,
    /// Time step, s: what [`Checked::recommended_time_step`](crate::Checked::recommended_time_step) recommends.
    pub time_step: f32,
}

impl Guide {
    /// Derives everything else, and makes a scene of it: one block of fluid at the origin, without gravity and walls.
    ///
    /// # Errors
    /// [`SceneError::OutOfBounds`] for a number class above 10, and those of [`Scene::check`]. The error of an ill choice
    /// names the number to change.
    pub fn derive(&self) -> Result<(Guided, Scene), SceneError> {
        let class = self.number_class as usize;
        let Some(&along) = NUMBER_CLASSES.get(class) else {
            let most = NUMBER_CLASSES.len() as f32 - 1.0;
            let value = self.number_class as f32;
            return Err(SceneError::OutOfBounds { field: "number_class".into(), value, least: 0.0, most });
        };
        let d = self.dimension.count();
        for &x in &self.size.as_ref()[..d] {
            if !x.is_finite() {
                return Err(SceneError::NotFinite { field: "size".into(), value: x });
            }
            if x <= 0.0 {
                return Err(SceneError::NotPositive { field: "size".into(), value: x });
            }
        }
        let shortest = self.size.as_ref()[..d].iter().copied().fold(f32::MAX, f32::min);
        // as many gaps per length along every side
        let gaps = f64::from(along - 1);
        let mut counts = [1; 3];
        for (count, &length) in counts.iter_mut().zip(self.size.as_ref()).take(d) {
            *count = 1u32.saturating_add((gaps * f64::from(length) / f64::from(shortest)) as u32);
        }
        let particles = counts.iter().fold(1u32, |all, &count| all.saturating_mul(count));
        let volume: f64 = self.size.as_ref()[..d].iter().map(|&x| f64::from(x)).product();
        let per_particle = volume / f64::from(particles);
        let spacing = if d == 2 { libm::sqrt(per_particle) } else { libm::cbrt(per_particle) } as f32;
        let neighbours = self.average_neighbours.unwrap_or(NEIGHBOURS[class.min(1)]);
        let size = Vec3::from_array(counts.map(|count| count as f32 * spacing));
        let block = Block { size, ..Block::default() };
        let mut scene = Scene::of(self.dimension, spacing, 1.0, self.fluid, block);
        scene.average_neighbours = Some(neighbours);
        scene.time_step = scene.check()?.recommended_time_step();
        scene.check()?;
        let total_mass = volume * f64::from(self.fluid.rest_density);
        let guided = Guided {
            counts,
            particles,
            fixed_distance: shortest / (along - 1) as f32,
            particle_spacing: spacing,
            average_neighbours: neighbours,
            support_radius: support_radius(&scene),
            particle_mass: total_mass / f64::from(particles),
            total_mass,
            time_step: scene.time_step,
        };
        Ok((guided, scene))
    }
}
