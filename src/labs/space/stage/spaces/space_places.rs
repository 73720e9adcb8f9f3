//! Where places of the world, and vertices of the object in focus, are drawn in each space.

use super::{
    super::{super::Object, Scenery, prelude::*},
    picture_space::PictureSpace,
};

/// The screen is so deep as it is drawn: enough to tell what is in front.
pub const SCREEN_DEPTH: f64 = 0.02;

pub struct SpacePlaces<'a> {
    pub scenery: &'a Scenery,
    /// Who looks.
    pub camera: &'a Camera,
    size: [u32; 2],
}

impl<'a> SpacePlaces<'a> {
    /// Of a scene whose picture has so many columns and rows.
    pub fn new(scenery: &'a Scenery, size: [u32; 2]) -> Self {
        let camera = scenery.scene().camera.camera();
        Self {
            scenery,
            camera,
            size,
        }
    }

    pub fn is_parallel(&self) -> bool {
        self.camera.volume().sight() == Sight::Parallel
    }

    /// The object whose vertex is followed.
    pub fn focused(&self) -> &Object {
        self.scenery.scene().focused()
    }

    /// A place in the world, as it is drawn in a space.
    pub fn drawn_from_world(&self, space: PictureSpace, at: [f64; 3]) -> [f64; 3] {
        let view = self.camera.view_from_world().point(at);
        let [x, y, z] = view;
        match space {
            PictureSpace::Model | PictureSpace::World => at,
            PictureSpace::View => view,
            PictureSpace::Clip | PictureSpace::Ndc | PictureSpace::Screen => {
                let clip = self.camera.volume().clip_from_view().times([x, y, z, 1.0]);
                self.drawn(space, clip)
            }
        }
    }

    /// Coordinates of a space, as they are drawn; from clip space on all four are taken.
    pub fn drawn(&self, space: PictureSpace, [x, y, z, w]: [f64; 4]) -> [f64; 3] {
        match space {
            PictureSpace::Model | PictureSpace::World | PictureSpace::View => [x, y, z],
            PictureSpace::Clip if self.is_parallel() => [x, y, -z],
            PictureSpace::Clip => [x, y, -w],
            PictureSpace::Ndc => [x / w, y / w, -z / w],
            PictureSpace::Screen => {
                let [width, height] = self.half_screen();
                [x / w * width, y / w * height, -z / w * SCREEN_DEPTH]
            }
        }
    }

    /// Half of the screen's width and height, as it is drawn.
    pub fn half_screen(&self) -> [f64; 2] {
        let [width, height] = self.size.map(f64::from);
        [width / height, 1.0]
    }

    pub fn place(&self, space: PictureSpace) -> [f64; 3] {
        let vertex = self.scenery.scene().vertex();
        self.place_of(space, vertex)
    }

    pub fn place_of(&self, space: PictureSpace, vertex: usize) -> [f64; 3] {
        let position = self.focused().model().mesh().positions()[vertex].map(f64::from);
        if space == PictureSpace::Model {
            return position;
        }
        let in_world = self.focused().world_from_model().point(position);
        self.drawn_from_world(space, in_world)
    }

    /// What is not before the eye has no place after the divide.
    pub fn is_drawn(&self, space: PictureSpace) -> bool {
        let is_divided = matches!(space, PictureSpace::Ndc | PictureSpace::Screen);
        let [_, _, z] = self.place(PictureSpace::View);
        !is_divided || self.is_parallel() || z < 0.0
    }
}
