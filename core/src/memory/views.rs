//! The arrays of a simulation as slices, generated from the table of arrays. An unused array is empty.
use super::lend::{Lender, Memory};
use super::requirements::{LIST_WORDS, Requirements};
use crate::error::SceneError;
use crate::layout::{Model, f32x4, u32x2, u32x4};
use crate::plan::arrays::{Array, with_arrays};

macro_rules! views {
    (
        State { $($(#[$state_doc:meta])* $state:ident as $quantity:ident: $state_type:ident per $state_unit:ident,
            if $state_exists:expr $(, constant if $constant:expr)?
            $(, from $state_from:ident $(@ $state_side:ident)?)?;)* }
        Index { $($(#[$index_doc:meta])* $index:ident: $index_type:ident per $index_unit:ident,
            if $index_exists:expr;)* }
        Sorting { $($(#[$sorting_doc:meta])* $sorting:ident: $sorting_type:ident per $sorting_unit:ident,
            if $sorting_exists:expr;)* }
        Scratch { $($(#[$scratch_doc:meta])* $scratch:ident: $scratch_type:ident per $scratch_unit:ident,
            if $scratch_exists:expr $(, from $from:ident $(@ $side:ident)?)?;)* }
        Given { $($(#[$given_doc:meta])* $given:ident: $given_type:ident per $given_unit:ident,
            if $given_exists:expr;)* }
    ) => {
        view! {
            /// The arrays of one state. A step reads one state and writes the other.
            State { $($(#[$state_doc])* $state: $state_type,)* $($(#[$index_doc])* $index: $index_type,)* }
        }
        view! {
            /// Arrays used only within a step.
            Scratch { $($(#[$scratch_doc])* $scratch: $scratch_type,)* }
        }
        view! {
            /// Arrays that steps only read.
            Given { $($(#[$given_doc])* $given: $given_type,)* }
        }

        /// Arrays used by a step until the particles are sorted. They lie in the memory of the neighbour lists, which
        /// are made afterwards.
        #[derive(Debug)]
        pub(crate) struct Sorting<'s> { $($(#[$sorting_doc])* pub $sorting: &'s mut [$sorting_type],)* }

        /// The sorting arrays by name.
        const SORTING: &[Array] = &[$(Array::$sorting),*];

        const _: () = assert!(
            0 $(+ size_of::<$sorting_type>())* <= LIST_WORDS * size_of::<u32>(),
            "the sort arrays lie in the memory of the neighbour lists"
        );

        impl<'s> Sorting<'s> {
            /// Places the arrays in this memory.
            pub(crate) fn of(lists: &'s mut [u32], particles: usize) -> Sorting<'s> {
                let mut rest = lists;
                Sorting { $($sorting: {
                    let words = particles * size_of::<$sorting_type>() / size_of::<u32>();
                    bytemuck::cast_slice_mut(rest.split_off_mut(..words).unwrap_or_default())
                },)* }
            }

            /// An array as words of four bytes; empty for an array that does not belong to this view.
            pub(crate) fn words(&self, array: Array) -> &[u32] {
                match array {
                    $(Array::$sorting => bytemuck::cast_slice(self.$sorting),)*
                    _ => &[],
                }
            }
        }

        impl State<'_> {
            /// Swaps with the other state those arrays that a scene never changes, and of which there is only one copy.
            pub(crate) fn pass_on_constants(&mut self, other: &mut Self, model: &Model) {
                $(if Array::$state.copies(model) == 1 {
                    core::mem::swap(&mut self.$state, &mut other.$state);
                })*
            }
        }
    };
}

macro_rules! view {
    ($(#[$doc:meta])* $view:ident { $($(#[$field_doc:meta])* $name:ident: $type:ident,)* }) => {
        $(#[$doc])*
        #[derive(Debug)]
        pub struct $view<'m> { $($(#[$field_doc])* pub $name: &'m mut [$type],)* }

        impl<'m> $view<'m> {
            /// Takes copy 0 or 1 of each array of this view.
            pub(super) fn carve(lender: &mut Lender<'m, '_>, copy: usize) -> Result<Self, SceneError> {
                Ok($view { $($name: lender.take(Array::$name, copy)?,)* })
            }

            /// An array as words of four bytes; empty for an array that does not belong to this view.
            #[must_use]
            pub fn words(&self, array: Array) -> &[u32] {
                match array {
                    $(Array::$name => bytemuck::cast_slice(self.$name),)*
                    _ => &[],
                }
            }

            /// An array as mutable words of four bytes; empty for an array that does not belong to this view.
            pub(crate) fn words_mut(&mut self, array: Array) -> &mut [u32] {
                match array {
                    $(Array::$name => bytemuck::cast_slice_mut(self.$name),)*
                    _ => &mut [],
                }
            }
        }
    };
}

with_arrays!(views);

/// All arrays of a simulation.
#[derive(Debug)]
pub struct Arrays<'m> {
    /// The two states.
    pub states: [State<'m>; 2],
    /// Arrays used only within a step.
    pub scratch: Scratch<'m>,
    /// Arrays that steps only read.
    pub given: Given<'m>,
    /// Number of words of the neighbour lists that a step may use for lists.
    pub(crate) list_words: usize,
}

const _: () = assert!(matches!(SORTING[0], Array::source_slot), "`Scratch::source_slot` reads it there");

impl Scratch<'_> {
    /// For each of the first `particles` slots after the step, the particle's slot before the step. Valid until
    /// neighbour lists are made.
    pub(crate) fn source_slot(&self, particles: usize) -> &[u32] {
        self.neighbours.get(..particles).unwrap_or_default()
    }
}

impl<'m> Memory<'m> {
    /// Divides the memory into the arrays of a simulation with these requirements.
    pub(crate) fn carve(self, requirements: &Requirements) -> Result<Arrays<'m>, SceneError> {
        let mut lender = self.lender(requirements);
        let states = [State::carve(&mut lender, 0)?, State::carve(&mut lender, 1)?];
        let scratch = Scratch::carve(&mut lender, 0)?;
        let list_words = lender.list_words(scratch.neighbours.len());
        Ok(Arrays { states, scratch, given: Given::carve(&mut lender, 0)?, list_words })
    }
}
