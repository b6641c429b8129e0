//! Computes one iteration of pressure: predicts the density error of the next step, and corrects the pressure for it.
//! Runs only with pressure correction.
use crate::arithmetic::lanes::{Lanes, xyz};
use crate::arithmetic::real::{less, real, root, select};
use crate::layout::f32x4;
use crate::passes::beyond::{self, Front};
use crate::passes::by_model;
use crate::passes::context::{Setup, Step};
use crate::passes::group::{Group, fold};
use crate::passes::local::{own_numbers, particles};
use crate::passes::pairs::{self, Job, PairPass, cells, lists};
use crate::terms::beyond::{completed, rate_by_walls};
use crate::terms::correction::{
    inverse_correction, predicted_density_error, predicted_velocity, pressure_corrected, residual,
};
use crate::terms::density::{continuity_neighbour, continuity_slope, deviation_rate};
use crate::terms::geometry::dot3;
use crate::terms::pair::{pair_scale, separation, squared_ratio};
use crate::terms::wall::{follows_fluid, mass_seen};

/// Corrects the pressures, and records the largest density error.
pub(crate) fn run(step: &mut Step<'_, '_>) {
    let (particles, cells, lists) = (particles!(step but density), cells!(step), lists!(step));
    let pass = PressureCorrect { acceleration: step.new.acceleration };
    let residual = pairs::run(step.setup, step.executor, particles, cells, lists, &pass, step.new.density_pressure);
    step.found.residual = f32::from_bits(residual);
}

/// Corrects the pressures in `density_pressure`. Returns the largest density error as the bits of a number that is not
/// negative.
struct PressureCorrect<'a> {
    acceleration: &'a [f32x4],
}

impl PairPass for PressureCorrect<'_> {
    fn work(job: &mut Job<'_, Self>) {
        by_model::run_one_material_or_general(job);
    }

    fn absent(&self, _: &Setup<'_>, _: &mut [f32x4]) {}

    #[inline(always)]
    fn group<R: Lanes>(&self, group: &Group<'_>, own: &mut [f32x4]) -> u32 {
        let (setup, particles) = (group.setup, group.particles);
        let (m, p, u, t) = (setup.model, setup.parameters, setup.uniform, setup.tables);
        if follows_fluid(m) && group.are_walls() {
            return 0;
        }
        let a = group.receivers::<R>();
        let none = real::<R>(0.0);
        let v_a = predicted_velocity(u, a.velocity, xyz(group.spread(self.acceleration)));
        let [rate, ..] = fold!(group: R, is zero with itself, |slots| {
            let b = group.neighbours::<R>(slots);
            let x_ab = separation(m, p, a.position, b.position);
            let scale = pair_scale(m, a.support, b.support);
            let v_ab = v_a - predicted_velocity(u, b.velocity, xyz(R::gather(self.acceleration, slots)));
            let mass = mass_seen(m, a.rest_ratio, b.mass, b.rest_ratio, b.wall);
            let q = root(squared_ratio(m, p, x_ab, scale));
            let slope = continuity_slope(m, t, q, scale);
            [continuity_neighbour(m, dot3(x_ab, v_ab), mass, q, slope, scale), none, none, none]
        });
        let [deviation, before, near_pressure, volume] = own_numbers::<R>(own);
        let k = particles.stiffness::<R>(setup, group.first, group.last);
        let mut rate = deviation_rate(m, p, rate, a.mass, a.rest_ratio);
        if m.has_closed_walls == 1 {
            let front = Front { velocity: v_a, ..Front::of(a) };
            let beyond = beyond::of_pressure(setup, front);
            rate = completed(rate + rate_by_walls(deviation, beyond), beyond.gamma);
        }
        let miss = predicted_density_error(m, p, u, before, deviation, rate, k.compressibility);
        let inverse = inverse_correction(u, k.pressure_response, k.response_offset);
        let mut after = pressure_corrected(m, before, miss, inverse);
        if follows_fluid(m) {
            after = select(after, none, less(none, a.wall));
        }
        let left = residual(before, after, inverse);
        let mut largest = 0;
        for receiver in 0..own.len() {
            largest = largest.max(left.lane(receiver * R::NEIGHBOURS).to_bits());
        }
        R::rows([deviation, after, near_pressure, volume], own);
        largest
    }
}
