//! The triangle rendering pipeline, every stage exact and steppable, with no screen.
//!
//! Reading the modules from top to bottom is reading the pipeline. `trace`, `replay` and
//! `explain` are what makes any algorithm steppable; `memo` and `history` are what makes a
//! document editable. There is no I/O here, no clock, no thread, no global and no word of a user
//! interface.
#![forbid(unsafe_code)]

pub mod compare;
pub mod explain;
pub mod history;
pub mod labs;
pub mod memo;
pub mod message;
pub mod replay;
pub mod stage;
pub mod trace;

pub mod math;

pub mod scene;

pub mod transform;

pub mod cull;

pub mod clip;

pub mod raster;

pub mod interpolate;

pub mod shade;

pub mod depth;

pub mod visibility;

pub mod stencil;

pub mod blend;

pub mod pipeline;

pub mod engine;

pub mod stress;
