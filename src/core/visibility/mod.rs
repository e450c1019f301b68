//! Which surface is seen where, by other means than the depth buffer.
//!
//! Contract: triangles on the screen with depths, smaller ones nearer; of equal depths the earlier triangle
//! wins, as the depth test `less` has it. These methods show what finding out costs; nothing steps them.

pub mod object_pairs;
pub mod rays;
