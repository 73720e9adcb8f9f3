//! Which surface is in front: every algorithm against exact arithmetic of another kind, and against each other.

mod bsp;
mod depth_buffer;
mod glass;
mod occlusion;
mod oracle;
mod painter;
mod ray_casting;
mod scenes;
mod soup;
