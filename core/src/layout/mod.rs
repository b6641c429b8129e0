//! The bytes that both backends share: struct of arrays of four numbers, and structs that name their own WGSL.
//!
//! Fields are `u32`, `f32`, fours of them and arrays of those: never `vec3`, `usize` or `bool`, whose sizes differ
//! between the languages. No hidden padding: bytemuck's derive refuses it, and a test reads the WGSL back through naga.
#![expect(non_camel_case_types, reason = "the WGSL aliases have these names")]

mod materials;
mod model;
mod parameters;
mod status;
mod step_uniform;
mod tables;

pub use materials::{MATERIALS, MaterialRows, Materials};
pub use model::Model;
pub use parameters::{PLANES, Parameters};
pub use status::{MOST_ATTEMPTS, NONE, QUANTITIES_OF_ID, Status};
pub use step_uniform::StepUniform;
pub use tables::{TABLE_ENTRIES, TABLE_WORDS, TABLES, Tables};

/// Four floats: xyz and one scalar.
pub type f32x4 = [f32; 4];
/// Four unsigned integers.
pub type u32x4 = [u32; 4];
/// Two unsigned integers.
pub type u32x2 = [u32; 2];
/// The penalty walls of a scene: normal and offset of each plane.
pub type Planes = [f32x4; PLANES];

/// Threads of a work group on a GPU.
pub const WORKGROUP: u32 = 64;

/// What a particle's derived quantities are, in the order of the four numbers of `density_pressure`.
pub const QUANTITIES: [&str; 4] = ["deviation", "pressure", "near_pressure", "volume"];

/// Declares a struct once, for Rust and, as `WGSL`, for the GPU.
macro_rules! shared {
    ($(#[$doc:meta])* pub struct $name:ident { $($(#[$field_doc:meta])* pub $field:ident: $type:ident,)* }) => {
        $(#[$doc])*
        #[repr(C)]
        #[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
        pub struct $name { $($(#[$field_doc])* pub $field: $type,)* }

        impl $name {
            /// The same struct in WGSL.
            pub const WGSL: &str = concat!(
                "struct ", stringify!($name), " {\n",
                $("  ", stringify!($field), ": ", stringify!($type), ",\n",)*
                "}\n"
            );

            /// Name, offset and size of each field in Rust, for whoever compares.
            pub const FIELDS: &[(&str, usize, usize)] = &[
                $((stringify!($field), core::mem::offset_of!($name, $field), size_of::<$type>()),)*
            ];
        }
    };
}
pub(crate) use shared;
