//! Computes the density of each particle from its neighbours, and the pressures and volume that follow from it.
use crate::arithmetic::lanes::{Lanes, Slots, xyz};
use crate::arithmetic::real::{less, real, root, select, vec3};
use crate::layout::{Model, f32x4};
use crate::passes::beyond::{self, Front};
use crate::passes::by_model;
use crate::passes::context::{Setup, Step};
use crate::passes::density_sums::{beside, of_neighbour};
use crate::passes::group::{Group, fold, masked};
use crate::passes::half_stencil;
use crate::passes::listing::{self, Near, Visit};
use crate::passes::lists::GROUP;
use crate::passes::local::{Particles, of_material, own_numbers, particles, spread};
use crate::passes::pairs::{self, Job, PairPass, cells, lists};
use crate::terms::beyond::{completed, completed_twice_at_most, rate_by_walls};
use crate::terms::correction::pressure_carried;
use crate::terms::density::{
    continuity_neighbour, continuity_slope, deviation_of_sum, deviation_rate, deviation_stepped, is_stepped,
    sums_walls, volume_by_number, volume_close,
};
use crate::terms::diffusion::{
    HYDROSTATIC, NO_DIFFUSION, RENORMALISED, diffusion_neighbour, hydrostatic_difference, if_diffusing,
    linear_difference,
};
use crate::terms::geometry::dot3;
use crate::terms::near::near_pressure_close;
use crate::terms::pair::{pair_scale, separation, squared_ratio};
use crate::terms::state::{pressure_close, pressure_of_state};
use crate::terms::wall::{follows_fluid, mass_seen, repels_directly, unless_repelling};

/// Fills `density_pressure`. Where density depends on distances only, the pass also finds the neighbours and fills
/// `neighbours`.
pub(crate) fn run(step: &mut Step<'_, '_>) {
    let (setup, executor) = (step.setup, step.executor);
    let (particles, cells) = (particles!(step but density), cells!(step));
    let renormalised = &*step.scratch.renormalised_gradient;
    let pass = Density { previous: step.scratch.previous_density_pressure, renormalised };
    let out = &mut *step.new.density_pressure;
    if setup.model.is_half_stencil == 1 {
        half_stencil::density::sum_once(setup, executor, particles, cells, out);
        pairs::run(setup, executor, particles, cells, lists!(step), &Summed(pass), out);
    } else if setup.model.sums_distances() {
        let lists = &mut step.scratch.neighbours[..step.list_words];
        listing::run(setup, executor, particles, cells, lists, &pass, out);
    } else {
        pairs::run(setup, executor, particles, cells, lists!(step), &pass, out);
    }
}

/// Computes density deviation `rho / rho0 - 1`, pressure, near pressure and volume.
struct Density<'a> {
    /// Density and pressures before the step. Empty if the model does not need them.
    previous: &'a [f32x4],
    /// Renormalised gradients of the density before the step. Empty if nothing needs them.
    renormalised: &'a [f32x4],
}

/// The receivers, with the data that density needs.
struct Receivers<'a, R> {
    setup: &'a Setup<'a>,
    particles: Particles<'a>,
    position: vec3<R>,
    velocity: vec3<R>,
    support: R,
    rest: R,
    diffusing: Diffusing<'a, R>,
}

/// The data of the receivers that the diffusion of density needs.
struct Diffusing<'a, R> {
    /// Density and pressures before the step. Empty if the model does not need them.
    previous: &'a [f32x4],
    renormalised: &'a [f32x4],
    gradient: vec3<R>,
    deviation: R,
    sound: R,
    fluid: R,
}

/// Returns the contributions of a neighbour, or nothing for a wall particle that repels.
#[inline(always)]
fn counted<R: Lanes>(m: &Model, [sum, near, number, wall]: [R; 4], wall_b: R) -> [R; 4] {
    [
        unless_repelling(m, sum, wall_b),
        unless_repelling(m, near, wall_b),
        unless_repelling(m, number, wall_b),
        unless_repelling(m, wall, wall_b),
    ]
}

impl<R: Lanes> Receivers<'_, R> {
    /// Returns the contributions of neighbours to four sums: of density or its rate, of near density, of number density,
    /// and of the density of walls. With walls in closed form the second sum is the diffusion of density, which is not
    /// completed as the rate is.
    #[inline(always)]
    fn add(&self, slots: &Slots) -> [R; 4] {
        let Setup { model: m, parameters: p, materials, columns, uniform: u, tables: t, .. } = *self.setup;
        let [x, y, z, mass] = R::gather(self.particles.position, slots);
        let needs_velocity = is_stepped(m) || m.is_multi_fluid == 1 || repels_directly(m);
        let none = real::<R>(0.0);
        let [vx, vy, vz, material] =
            if needs_velocity { R::gather(self.particles.velocity, slots) } else { [none, none, none, none] };
        let of_properties = |i: usize| of_material(self.setup, &materials.properties, &columns.properties, material, i);
        // mass over that of a particle of the first fluid at rest
        let mass_b = if m.is_multi_fluid == 0 {
            mass
        } else {
            mass_seen(m, self.rest, mass, of_properties(2), of_properties(1))
        };
        let scale = pair_scale(m, self.support, self.particles.supports_of(self.setup, slots));
        let x_ab = separation(m, p, self.position, vec3(x, y, z));
        let q2 = squared_ratio(m, p, x_ab, scale);
        if !is_stepped(m) {
            let sums = of_neighbour(self.setup, mass_b, q2, scale);
            return if repels_directly(m) { counted(m, sums, of_properties(1)) } else { sums };
        }
        // `x_ab` in the middle of the step
        let v_ab = self.velocity - vec3(vx, vy, vz);
        let x_ab = x_ab - v_ab * real(u.half_time_step);
        let q = root(squared_ratio(m, p, x_ab, scale));
        let slope = continuity_slope(m, t, q, scale);
        let mut rate = continuity_neighbour(m, dot3(x_ab, v_ab), mass_b, q, slope, scale);
        let mut diffusion = none;
        if m.density_diffusion != NO_DIFFUSION {
            let Diffusing { previous, renormalised, gradient, deviation, sound, fluid } = self.diffusing;
            let [deviation_b, ..] = R::gather(previous, slots);
            let mut difference = deviation_b - deviation;
            if m.density_diffusion == HYDROSTATIC {
                difference = difference - hydrostatic_difference(m, p, u, x_ab, sound, self.rest);
            }
            if m.density_diffusion == RENORMALISED {
                let gradient_b = xyz(R::gather(renormalised, slots));
                difference = difference - linear_difference(x_ab, gradient, gradient_b);
            }
            let part = diffusion_neighbour(m, p, difference, sound, mass_b, q, slope, scale);
            let part = if_diffusing(m, part, fluid, of_properties(3), of_properties(1));
            if m.has_closed_walls == 1 {
                diffusion = part;
            } else {
                rate = rate + part;
            }
        }
        let mut sums = beside(self.setup, rate, mass_b, q2, scale);
        if m.has_closed_walls == 1 {
            // there is no near density then
            sums[1] = diffusion;
        }
        if repels_directly(m) { counted(m, sums, of_properties(1)) } else { sums }
    }
}

impl PairPass for Density<'_> {
    fn work(job: &mut Job<'_, Self>) {
        by_model::run(job);
    }

    fn absent(&self, setup: &Setup<'_>, own: &mut [f32x4]) {
        own.fill([0.0, 0.0, 0.0, setup.parameters.rest_volume]);
    }

    #[inline(always)]
    fn group<R: Lanes>(&self, group: &Group<'_>, own: &mut [f32x4]) -> u32 {
        let (setup, particles, m) = (group.setup, group.particles, group.setup.model);
        let [x, y, z, _] = group.spread::<R>(particles.position);
        let [vx, vy, vz, material] = group.spread::<R>(particles.velocity);
        let rest = of_material(setup, &setup.materials.properties, &setup.columns.properties, material, 2);
        let (position, velocity) = (vec3(x, y, z), vec3(vx, vy, vz));
        let support = particles.supports(setup, group.first, group.last);
        let (materials, columns) = (setup.materials, setup.columns);
        let none = real(0.0);
        let mut gradient = vec3(none, none, none);
        let diffusing = if m.density_diffusion == NO_DIFFUSION {
            Diffusing { previous: &[], renormalised: &[], gradient, deviation: none, sound: none, fluid: none }
        } else {
            let [deviation, ..] = group.spread(self.previous);
            let sound = of_material(setup, &materials.states, &columns.states, material, 2);
            let fluid = of_material(setup, &materials.properties, &columns.properties, material, 3);
            if m.density_diffusion == RENORMALISED {
                gradient = xyz(group.spread(self.renormalised));
            }
            let renormalised = self.renormalised;
            Diffusing { previous: self.previous, renormalised, gradient, deviation, sound, fluid }
        };
        let receivers = Receivers { setup, particles, position, velocity, support, rest, diffusing };
        let sums = fold!(group: R, |slots| receivers.add(slots));
        self.close(group, sums, own);
        0
    }
}

impl Visit for Density<'_> {
    fn work(job: &mut listing::Job<'_, Self>) {
        by_model::run(job);
    }

    #[inline(always)]
    fn visit<R: Lanes>(&self, group: &Group<'_>, near: &Near, own: &mut [f32x4]) {
        let one = real::<R>(1.0);
        let receiver = group.first % GROUP;
        let count = R::from_lanes(|lane| near.counts[(receiver + lane / R::NEIGHBOURS) % GROUP] as f32);
        let longest = near.counts.iter().copied().max().unwrap_or(0);
        let mut place = R::from_lanes(|lane| (lane % R::NEIGHBOURS) as f32);
        let mut sums = R::nothing();
        for k in (0..longest).step_by(R::NEIGHBOURS) {
            let q2 = near.q2_of::<R>(receiver, k);
            sums = R::add_up(sums, masked(of_neighbour(group.setup, one, q2, one), less(place, count)));
            place = place + R::NEIGHBOURS as f32;
        }
        self.close(group, R::sums(sums), own);
    }

    #[inline(always)]
    fn search<R: Lanes>(&self, group: &Group<'_>, own: &mut [f32x4]) {
        self.group::<R>(group, own);
    }

    fn absent(&self, setup: &Setup<'_>, own: &mut [f32x4]) {
        PairPass::absent(self, setup, own);
    }
}

/// Computes the same quantities with the half stencil: the sums are complete already, and stand in the entries that the
/// results go to.
struct Summed<'a>(Density<'a>);

impl PairPass for Summed<'_> {
    fn work(job: &mut Job<'_, Self>) {
        by_model::run_general(job);
    }

    #[inline(always)]
    fn group<R: Lanes>(&self, group: &Group<'_>, own: &mut [f32x4]) -> u32 {
        self.0.close(group, own_numbers::<R>(own), own);
        0
    }
}

impl Density<'_> {
    /// Computes the results from the sums.
    #[inline(always)]
    fn close<R: Lanes>(&self, group: &Group<'_>, sums: [R; 4], own: &mut [f32x4]) {
        let (setup, particles) = (group.setup, group.particles);
        let Setup { model: m, parameters: p, materials, columns, uniform: u, .. } = *setup;
        let (first, last) = (group.first, group.last);
        let none = real::<R>(0.0);
        let [sum, near_sum, number_sum, wall_sum] = sums;
        let [.., mass] = group.spread::<R>(particles.position);
        let [.., material] = group.spread::<R>(particles.velocity);
        let of_properties =
            |i: usize| -> R { of_material(setup, &materials.properties, &columns.properties, material, i) };
        let rest = of_properties(2);
        let previous = if self.previous.is_empty() { [none; 4] } else { spread(self.previous, first, last) };
        let stiffness = particles.stiffness::<R>(setup, first, last);
        let (mut sum, mut number_sum) = (sum, number_sum);
        let mut rate = if is_stepped(m) { deviation_rate(m, p, sum, mass, rest) } else { none };
        if m.has_closed_walls == 1 {
            let [x, y, z, _] = group.spread::<R>(particles.position);
            let [vx, vy, vz, _] = group.spread::<R>(particles.velocity);
            let (position, velocity) = (vec3(x, y, z), vec3(vx, vy, vz));
            let support = particles.supports(setup, first, last);
            let front = Front { position, velocity, support, viscosity: none };
            if is_stepped(m) {
                // in the middle of the step
                let position = position - velocity * real(u.half_time_step);
                let beyond = beyond::of_pressure(setup, Front { position, ..front });
                rate = completed(rate + rate_by_walls(previous[0], beyond), beyond.gamma);
                let diffusion = deviation_rate(m, p, near_sum, mass, rest);
                rate = rate + completed_twice_at_most(diffusion, beyond.gamma);
            } else {
                sum = completed(sum, beyond::of_density(setup, front).gamma);
            }
            if m.has_number_density_volume == 1 {
                number_sum = completed(number_sum, beyond::of_density(setup, front).gamma);
            }
        }
        let mut deviation = if is_stepped(m) {
            deviation_stepped(u, previous[0], rate)
        } else {
            deviation_of_sum(m, p, sum, mass, rest)
        };
        if sums_walls(m) {
            let of_wall = deviation_of_sum(m, p, wall_sum, mass, rest);
            deviation = select(deviation, of_wall, less(none, of_properties(1)));
        }
        let mut pressure = if m.corrects_pressure() {
            pressure_carried(m, previous[1])
        } else {
            let equation = of_material(setup, &materials.states, &columns.states, material, 3);
            pressure_of_state(m, deviation, stiffness.state, equation)
        };
        pressure = pressure_close(m, pressure);
        let mut near_pressure = near_pressure_close(m, deviation, near_sum, stiffness.near);
        if follows_fluid(m) {
            let wall = less(none, of_properties(1));
            deviation = select(deviation, none, wall);
            pressure = select(pressure, none, wall);
            near_pressure = select(near_pressure, none, wall);
        }
        let mut volume = volume_close(p, mass, deviation);
        if m.has_number_density_volume == 1 {
            volume = volume_by_number(m, p, volume, number_sum, of_properties(1));
        }
        R::rows([deviation, pressure, near_pressure, volume], own);
    }
}
