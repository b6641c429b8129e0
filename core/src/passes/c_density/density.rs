//! Density of each particle from its neighbours, and the pressures that follow.
use crate::arithmetic::real::{Real, less, real, select, vec3};
use crate::executor::Executor;
use crate::layout::f32x4;
use crate::passes::context::{Setup, Step};
use crate::passes::lanes::{is_dormant, kind, load, load_one, row_of};
use crate::passes::local::{Particles, particles};
use crate::passes::pairs::{self, Block, Job, PairPass, fold, lists};
use crate::terms::correction::pressure_carried;
use crate::terms::density::{
    continuity_neighbour, deviation_of_sum, deviation_rate, deviation_stepped, is_stepped, number_density_neighbour,
    summed_neighbour, volume_by_number, volume_close,
};
use crate::terms::kernel::if_inside;
use crate::terms::near::{ARTICLE, near_density_neighbour, near_pressure_close};
use crate::terms::pair::{pair_scale, separation, squared_ratio};
use crate::terms::state::{pressure_close, pressure_of_state};
use crate::terms::wall::{MIRRORED, mass_seen};

/// Fills `density_pressure`.
pub(crate) fn run(step: &mut Step<'_, '_, impl Executor>) {
    let (particles, lists) = (particles!(step but density), lists!(step));
    let pass = Density { previous: step.scratch.previous_density_pressure };
    pairs::run(step.setup, step.executor, particles, lists, &pass, step.new.density_pressure);
}

/// Deviation, pressure, near pressure, volume.
struct Density<'a> {
    /// Density and pressures before the step, where it needs them.
    previous: &'a [f32x4],
}

/// The particles of a block, and what tells them who is near.
struct Near<'a, R> {
    setup: &'a Setup<'a>,
    particles: &'a Particles<'a>,
    x_a: vec3<R>,
    v_a: vec3<R>,
    support_a: R,
    rest_a: R,
}

impl<R: Real> Near<'_, R> {
    /// Mass of `b`, over that of a particle of the first fluid.
    #[inline(always)]
    fn mass(&self, b: usize) -> R {
        let m = self.setup.model;
        let mass = real(self.particles.position[b][3]);
        if m.fluids == 0 {
            return mass;
        }
        let [_, wall, rest, _] = self.setup.materials.species[kind(self.particles.velocity[b][3])].map(real);
        mass_seen(m, self.rest_a, mass, rest, wall)
    }

    /// What `b` adds to the three sums: of density or its rate, of the near density, of the number density.
    #[inline(always)]
    fn add(&self, [sum, mut near, mut number]: [R; 3], b: usize) -> [R; 3] {
        let (m, p, t) = (self.setup.model, self.setup.parameters, self.setup.tables);
        let mass_b = self.mass(b);
        let scale = pair_scale(m, self.support_a, self.particles.support_of(self.setup, b));
        let x_ab = separation(m, p, self.x_a, vec3::splat(self.particles.position[b]));
        let q2 = squared_ratio(m, p, x_ab, scale);
        let added = if is_stepped(m) {
            // where the pair was in the middle of the step
            let v_ab = self.v_a - vec3::splat(self.particles.velocity[b]);
            let x_ab = x_ab - v_ab * real(self.setup.uniform.half_time_step);
            if_inside(q2, continuity_neighbour(m, p, t, x_ab, v_ab, mass_b, scale))
        } else {
            summed_neighbour(m, t, mass_b, q2, scale)
        };
        if m.near_pressure == ARTICLE {
            near = near + near_density_neighbour(m, mass_b, q2, scale);
        }
        if m.numbers == 1 {
            number = number + number_density_neighbour(m, t, q2, scale);
        }
        [sum + added, near, number]
    }
}

impl PairPass for Density<'_> {
    fn work(job: &mut Job<'_, Self>) {
        job.run();
    }

    #[inline(always)]
    fn block<R: Real>(&self, block: &Block<'_>, own: &mut [f32x4]) -> u32 {
        let (setup, particles) = (block.setup, block.particles);
        let Setup { model: m, parameters: p, materials, uniform: u, .. } = *setup;
        let (first, last) = (block.first, block.last);
        // those of a cell are all inactive, or none
        if m.air == 1 && is_dormant(setup.materials, particles.velocity[first][3]) {
            own.fill([0.0, 0.0, 0.0, p.rest_volume]);
            return 0;
        }
        let none = real::<R>(0.0);
        let row = |rows, i| row_of::<R>(m, rows, particles.velocity, first, last, i);
        let near = Near::<R> {
            setup,
            particles,
            // the box keeps LLVM from carrying the loop below in the shape of this load, at half its speed
            x_a: core::hint::black_box(load(particles.position, first, last)),
            v_a: load(particles.velocity, first, last),
            support_a: particles.supports(setup, first, last),
            rest_a: row(&materials.species, 2),
        };
        let [sum, near_sum, number_sum] = fold!(block, [none; 3], |sums, b| near.add(sums, b));
        let previous = |i| load_one::<R>(self.previous, first, last, i);
        let mass = load_one::<R>(particles.position, first, last, 3);
        let stiffness = particles.stiffness::<R>(setup, first, last);
        let mut deviation = if is_stepped(m) {
            deviation_stepped(u, previous(0), deviation_rate(m, p, sum, mass, near.rest_a))
        } else {
            deviation_of_sum(m, p, sum, mass, near.rest_a)
        };
        let mut pressure = if m.corrects_pressure() {
            pressure_carried(m, previous(1))
        } else {
            pressure_of_state(m, deviation, stiffness.state, row(&materials.states, 3))
        };
        pressure = pressure_close(m, pressure);
        let mut near_pressure = near_pressure_close(m, deviation, near_sum, stiffness.near);
        if m.wall_particles == MIRRORED {
            let wall = less(none, row(&materials.species, 1));
            deviation = select(deviation, none, wall);
            pressure = select(pressure, none, wall);
            near_pressure = select(near_pressure, none, wall);
        }
        let mut volume = volume_close(p, mass, deviation);
        if m.numbers == 1 {
            volume = volume_by_number(m, p, volume, number_sum, row(&materials.species, 1));
        }
        for (lane, own) in own.iter_mut().enumerate() {
            let of = |x: R| x.lane(lane);
            *own = [of(deviation), of(pressure), of(near_pressure), of(volume)];
        }
        0
    }
}
