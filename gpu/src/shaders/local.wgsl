// A particle with the density and pressures of this step.
fn local(a: u32) -> Local { return particle(a, new_density_pressure[a]); }
