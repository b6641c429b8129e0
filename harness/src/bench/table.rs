//! The result of `bench` as text.
use super::{Bench, PassTime};

/// Formats the result as text.
pub(super) fn table(b: &Bench) -> String {
    let mut out = format!("{}: {} particles, {}, {}\n", b.scene, b.particles, threads(b.threads), b.simd);
    out += &format!("  {:8.3} ms per step, minimum, {:.3} median\n", b.ms_per_step.min, b.ms_per_step.median);
    if let Some(ms) = b.ms_per_step_at_once {
        out += &format!("  {ms:8.3} ms per step if the device is given all steps at once\n");
    }
    for pass in &b.passes {
        out += format!("  {:8.3} ms {:18}{}", pass.ms, pass.name, roof(pass)).trim_end();
        out += "\n";
    }
    out += &format!(
        "  {:8.1} ns per particle and step, {:.0} bytes per particle\n",
        b.ns_per_particle_step, b.bytes_per_particle
    );
    out += &format!("  {:8.2} neighbours first, {:.2} last\n", b.average_neighbours.first, b.average_neighbours.last);
    out += &format!("  {:8.3} of real time\n", b.real_time_factor);
    if let Some(lists) = &b.lists {
        out += &format!(
            "  {:8.1} million pairs/s, of {:.0} million tested, lanes {:.0} % full, {} of {} groups have lists\n",
            lists.million_pairs_per_second,
            lists.million_tested_pairs_per_second,
            lists.filling * 100.0,
            lists.listed,
            lists.groups
        );
    }
    if let Some(at_most) = b.ceilings {
        out += &format!(
            "  {:8.1} Gop/s peak arithmetic in registers, {:.1} GB/s peak memory (caches can be faster)\n",
            at_most.gigaoperations_per_second, at_most.gigabytes_per_second
        );
    }
    for of in &b.levels {
        let ms = of.ms_per_step;
        out += &format!(
            "  {:8.3} ms per step, minimum, {:.3} median with {}, {}\n",
            ms.min,
            ms.median,
            threads(of.threads),
            of.simd
        );
    }
    for of in &b.structures {
        let (ms, bytes) = (of.ms_per_step, of.bytes_per_particle);
        out += &format!(
            "  {:8.3} ms per step, minimum, {:.3} median, {bytes:.0} bytes per particle with {}\n",
            ms.min, ms.median, of.structure
        );
    }
    if let Some(scaling) = &b.scaling {
        for (particles, pairs, ms) in &scaling.sizes {
            let ns = ms * 1e6 / pairs;
            out += &format!("  {ms:8.3} ms per step with {particles} particles, {ns:.2} ns per pair\n");
        }
        out += &format!(
            "  time grows as the number of particles to the power {:.3}, as the number of pairs to the power {:.3}\n",
            scaling.exponent, scaling.exponent_of_pairs
        );
    }
    out
}

/// Formats the rates of a pass and their shares of the peak rates.
fn roof(pass: &PassTime) -> String {
    let Some(roof) = pass.roof else { return String::new() };
    let rate = |count: Option<u64>, unit: &str, share: Option<f64>| match (count, share) {
        (Some(count), Some(share)) => {
            format!("{:7.1} {unit} ({:2.0} %)", count as f64 / pass.ms * 1e-6, share * 100.0)
        }
        _ => " ".repeat(15 + unit.len()),
    };
    rate(roof.operations, "Gop/s", roof.share_of_arithmetic) + &rate(roof.bytes, "GB/s", roof.share_of_memory)
}

fn threads(count: usize) -> String {
    format!("{count} thread{}", if count == 1 { "" } else { "s" })
}
