//! Memory layout shared by the CPU and GPU backends: arrays with elements of up to four numbers (structure of arrays),
//! and structs that provide their own WGSL declaration.
//!
//! Fields have the types `u32` and `f32`, vectors of four of them, and arrays of these. The types `vec3`, `usize` and
//! `bool` are not used, since their sizes differ between the two languages. There is no hidden padding: bytemuck's
//! derive rejects it, and a test compares the layout with the WGSL as parsed by naga.
#![expect(non_camel_case_types, reason = "the WGSL aliases have these names")]

mod materials;
mod model;
mod parameters;
mod solids;
mod status;
mod step_uniform;
mod tables;

pub use materials::{MATERIALS, MaterialRows, Materials};
pub use model::Model;
pub use parameters::{DRAIN_ROWS, PLANES, Parameters};
pub use solids::{
    DRIVEN, LEAST_STEP, MOST_TRACED, ON_COURSE, POSE_STRIDE, ROUNDS, SOLID_ROWS, SOLID_STRIDE, SolidRows,
};
pub use status::{MOST_ATTEMPTS, NONE, QUANTITIES_OF_ID, Status};
pub use step_uniform::StepUniform;
pub use tables::{TABLE_ENTRIES, TABLE_WORDS, TABLES, Tables};

/// Four floats: xyz and one scalar.
pub type f32x4 = [f32; 4];
/// Four unsigned integers.
pub type u32x4 = [u32; 4];
/// Two unsigned integers.
pub type u32x2 = [u32; 2];
/// The penalty planes of a scene: normal and offset of each.
pub type Planes = [f32x4; PLANES];
/// The drains of a scene: two rows of each.
pub type DrainRows = [f32x4; DRAIN_ROWS];

/// Threads in a GPU work group.
pub const WORKGROUP: u32 = 64;

/// Names of the derived quantities of a particle, in the order of the four numbers of `density_pressure`.
pub const QUANTITIES: [&str; 4] = ["deviation", "pressure", "near_pressure", "volume"];

/// Declares a struct for Rust and, in its constant `WGSL`, for the GPU.
macro_rules! shared {
    ($(#[$doc:meta])* pub struct $name:ident { $($(#[$field_doc:meta])* pub $field:ident: $type:ident,)* }) => {
        $(#[$doc])*
        #[repr(C)]
        #[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
        pub struct $name { $($(#[$field_doc])* pub $field: $type,)* }

        impl $name {
            /// The declaration of this struct in WGSL.
            pub const WGSL: &str = concat!(
                "struct ", stringify!($name), " {\n",
                $("  ", stringify!($field), ": ", stringify!($type), ",\n",)*
                "}\n"
            );

            /// Name, offset and size of each field in Rust, to compare with the WGSL layout.
            pub const FIELDS: &[(&str, usize, usize)] = &[
                $((stringify!($field), core::mem::offset_of!($name, $field), size_of::<$type>()),)*
            ];
        }
    };
}
pub(crate) use shared;
