//! What holds the fluid of a study: walls of particles, or planes.
use glam::Vec3;
use millpond_core::scene::{Container, FACES, Face, PlaneModel, Scene, Wall, WallPressure, WallShape};
use millpond_core::{Solver, heapless};

/// A kind of walls.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Enclosure {
    /// Walls of particles.
    Particles(WallPressure),
    /// A container of planes.
    Planes(PlaneModel),
}

impl Enclosure {
    pub(super) const PENALTY: Enclosure = Enclosure::Planes(PlaneModel::Penalty);
    pub(super) const CLOSED_FORM: Enclosure = Enclosure::Planes(PlaneModel::ClosedForm);
    pub(super) const MIRRORED: Enclosure = Enclosure::Particles(WallPressure::Mirrored);
    pub(super) const DYNAMIC: Enclosure = Enclosure::Particles(WallPressure::Dynamic);
    pub(super) const EXTRAPOLATED: Enclosure = Enclosure::Particles(WallPressure::Extrapolated);

    /// Returns its name in a scene file.
    pub(super) fn name(self) -> &'static str {
        match self {
            Enclosure::Particles(wall) => wall.name(),
            Enclosure::Planes(PlaneModel::Penalty) => "Penalty",
            Enclosure::Planes(PlaneModel::ClosedForm) => "ClosedForm",
        }
    }

    /// Puts a box around the origin and `high` that is open at these faces, with this viscosity between the walls and
    /// the fluid (`None`: that of the fluid).
    pub(super) fn enclose(self, scene: &mut Scene, high: Vec3, open: &[Face], dynamic_viscosity: Option<f32>) {
        let open: heapless::Vec<Face, FACES> = open.iter().copied().collect();
        match self {
            Enclosure::Particles(wall_pressure) => {
                scene.model.wall_pressure = wall_pressure;
                let shape = WallShape::Box { low: Vec3::ZERO, high, open };
                scene.walls = [Wall { dynamic_viscosity, ..Wall::still(shape) }].into_iter().collect();
            }
            Enclosure::Planes(model) => {
                let container = Container::closed(Vec3::ZERO, high);
                let dynamic_viscosity = dynamic_viscosity.filter(|_| model == PlaneModel::ClosedForm);
                scene.container = Some(Container { open, model, dynamic_viscosity, ..container });
            }
        }
    }

    /// Returns the force on the walls, N; 0 for penalty planes.
    pub(super) fn force(self, solver: &mut Solver<'_>) -> Vec3 {
        let neighbours = solver.neighbours();
        match self {
            Enclosure::Particles(_) => neighbours.force_on_wall(0),
            Enclosure::Planes(_) => Face::ALL.iter().map(|face| neighbours.force_on_face(*face)).sum(),
        }
    }
}
