//! The times in words.
use super::Bench;

/// The times in words.
pub(super) fn table(b: &Bench) -> String {
    let mut out = format!("{}: {} particles, {}, {}\n", b.scene, b.particles, threads(b.threads), b.simd);
    out += &format!("  {:8.3} ms a step at least, {:.3} median\n", b.ms_per_step.min, b.ms_per_step.median);
    if let Some(ms) = b.ms_per_step_at_once {
        out += &format!("  {ms:8.3} ms a step where the device is given all of them at once\n");
    }
    for pass in &b.passes {
        out += &format!("  {:8.3} ms {}\n", pass.ms, pass.name);
    }
    out += &format!(
        "  {:8.1} ns a particle and step, {:.0} bytes a particle\n",
        b.ns_per_particle_step, b.bytes_per_particle
    );
    out += &format!("  {:8.2} neighbours first, {:.2} last\n", b.average_neighbours.first, b.average_neighbours.last);
    out += &format!("  {:8.3} of real time\n", b.real_time_factor);
    if let Some(lists) = &b.lists {
        out += &format!(
            "  {:8.1} million pairs a second, lanes {:.0} % full, {} of {} groups have lists\n",
            lists.million_pairs_per_second,
            lists.filling * 100.0,
            lists.listed,
            lists.groups
        );
    }
    for of in &b.structures {
        let (ms, bytes) = (of.ms_per_step, of.bytes_per_particle);
        out += &format!(
            "  {:8.3} ms a step at least, {:.3} median, {bytes:.0} bytes a particle with {}\n",
            ms.min, ms.median, of.structure
        );
    }
    if let Some(scaling) = &b.scaling {
        for (particles, ms) in &scaling.sizes {
            out += &format!("  {ms:8.3} ms a step at {particles} particles\n");
        }
        out += &format!("  time grows with the number of particles to the power {:.3}\n", scaling.exponent);
    }
    out
}

fn threads(count: usize) -> String {
    format!("{count} thread{}", if count == 1 { "" } else { "s" })
}
