//! The rows of solids: constants that stand in the parameters, and the poses, which change from step to step.
use super::f32x4;

/// Number of rows of the constants of a solid:
///
/// 0. kind of shape ([`terms::shape`](crate::terms::shape)), 1 if the fluid is outside or -1 if it is inside, how the
///    fluid feels it ([`SolidModel`](crate::scene::SolidModel)), and how it moves (0: not, 1: on its course, 2: as the
///    host says);
/// 1. size of the shape, m; w unused;
/// 2. restitution, slip, dynamic viscosity in Pa s (negative for that of the particle), strength of the repulsion in
///    m2/s2;
/// 3. position at the start, m; w: frequency, 1/s;
/// 4. rotation at the start, a quaternion (x, y, z, w);
/// 5. velocity, m/s; w: phase at the start, in periods;
/// 6. amplitude, m; w: amplitude of the angle, turns;
/// 7. axis of the rotation; w: turns per second;
/// 8. first side of a polygon, and the number of its sides; z and w unused.
pub const SOLID_STRIDE: usize = 9;

/// How a solid moves, as the fourth number of its first row: on its course, or as the host says; 0: not at all.
pub const ON_COURSE: f32 = 1.0;
/// See [`ON_COURSE`].
pub const DRIVEN: f32 = 2.0;

/// How often a particle is put back to the surface of solids in a step.
pub const ROUNDS: u32 = 3;

/// Largest number of steps of a search along a path. After these the particle is where the search has come to, which is
/// outside of the solid.
pub const MOST_TRACED: u32 = 64;

/// Smallest step of a search over the length of the path, for paths along a surface.
pub const LEAST_STEP: f32 = 1.0 / 32.0;

/// Number of rows of the pose of a solid: position, m; rotation, a quaternion (x, y, z, w); velocity, m/s; angular
/// velocity, 1/s. The w of the others is unused.
pub const POSE_STRIDE: usize = 4;

/// Number of rows of all solids.
pub const SOLID_ROWS: usize = SOLID_STRIDE * 16;

/// The constants of all solids.
pub type SolidRows = [f32x4; SOLID_ROWS];
