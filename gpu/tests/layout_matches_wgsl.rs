//! Promise: every shared struct has the same bytes in WGSL as in Rust, and no pass binds more storage buffers than wgpu
//! allows by default.
//!
//! naga parses the complete program of every pass, so no device is needed.
use millpond_core::backend::layout::{Materials, Model, Parameters, Status, StepUniform, f32x4, u32x4};
use millpond_core::{Pass, Plan};
use millpond_gpu::program::{Intrinsics, program};
use millpond_gpu::strict::validate;
use naga::{AddressSpace, Module, TypeInner};

mod support;

fn module(pass: Pass) -> Module {
    let plan = Plan::everything(&support::checked(&support::dam_break(1.0)));
    validate(&program(pass, &plan.model, Intrinsics::Native)).unwrap_or_else(|e| panic!("{}: {e}", pass.name())).0
}

/// Returns the name, offset and size of each member of a WGSL struct, and the size of the struct.
fn members(module: &Module, name: &str) -> (Vec<(String, usize, usize)>, usize) {
    let (_, found) = module.types.iter().find(|(_, t)| t.name.as_deref() == Some(name)).expect("the struct is used");
    let TypeInner::Struct { members, span } = &found.inner else { panic!("{name} is no struct") };
    let size = |ty| module.types[ty].inner.size(module.to_ctx()) as usize;
    let members = members.iter().map(|m| (m.name.clone().unwrap_or_default(), m.offset as usize, size(m.ty)));
    (members.collect(), *span as usize)
}

fn same(module: &Module, name: &str, rust: &[(&str, usize, usize)], size: usize) {
    let rust: Vec<_> = rust.iter().map(|(name, offset, size)| ((*name).to_owned(), *offset, *size)).collect();
    assert_eq!(members(module, name), (rust, size), "{name}");
}

#[test]
fn every_shared_struct_has_the_same_bytes() {
    let module = module(Pass::Commit);
    same(&module, "Status", Status::FIELDS, size_of::<Status>());
    same(&module, "Parameters", Parameters::FIELDS, size_of::<Parameters>());
    same(&module, "StepUniform", StepUniform::FIELDS, size_of::<StepUniform>());
    same(&module, "Materials", Materials::FIELDS, size_of::<Materials>());
    same(&module, "Model", Model::FIELDS, size_of::<Model>());
    let (head, _) = members(&module, "Head");
    assert_eq!(head[1], ("counter".to_owned(), size_of::<Status>(), size_of::<u32>()), "counters follow the status");
}

#[test]
fn arrays_have_rusts_strides() {
    let module = module(Pass::Force);
    let strides: Vec<u32> = module
        .types
        .iter()
        .filter_map(|(_, t)| match t.inner {
            TypeInner::Array { base, stride, .. } => {
                let vector = matches!(module.types[base].inner, TypeInner::Vector { .. });
                let want = if vector { size_of::<f32x4>() } else { size_of::<u32>() };
                assert_eq!(stride as usize, want);
                Some(stride)
            }
            _ => None,
        })
        .collect();
    assert!(strides.contains(&16) && strides.contains(&4), "{strides:?}");
    assert_eq!(size_of::<u32x4>(), size_of::<f32x4>());
}

#[test]
fn no_pass_binds_more_than_eight_storage_buffers() {
    for pass in Pass::ALL {
        let module = module(pass);
        let storage = |space| matches!(space, AddressSpace::Storage { .. });
        let bound = module.global_variables.iter().filter(|(_, v)| storage(v.space)).count();
        assert!((1..=8).contains(&bound), "{}: {bound}", pass.name());
    }
}
