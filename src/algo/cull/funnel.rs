//! A scene on its way to the screen: what can be left out is left out whole, the largest first. Objects are asked by their spheres
//! ([`SphereCull`](super::SphereCull)); of one that straddles, triangles by their vertices' codes, and what straddles is cut
//! ([`HomogeneousTriangle`]); what is left shows its front or is culled ([`BackFace`]). The run rests before each object, and within
//! one of many triangles after every few of them. *Cost*: of the tests that are asked; the clipper is not counted here.
//!
//! *Source*: J. H. Clark, "Hierarchical geometric models for visible surface algorithms", Communications of the ACM 19,
//! 1976, pp. 547–554.
//!
//! ```
//! use clipscope::{algo::cull::{Funnel, FunnelInput, FunnelObject}, geom::{Camera, Matrix, Solid, ViewVolume}, trace::silent};
//! let volume = ViewVolume::perspective(60.0, 1.0, 1.0, 20.0)?;
//! let camera = Camera::new([0.0, 0.0, 5.0], [0.0; 3], [0.0, 1.0, 0.0], volume)?;
//! let cube = |x| FunnelObject::new(&Solid::Cube.mesh(), &Matrix::translation([x, 0.0, 0.0]));
//! let levels = silent::<Funnel>(&FunnelInput { camera, objects: vec![cube(0.0)?, cube(90.0)?] });
//! assert_eq!([levels.scene, levels.spheres, levels.facing].map(|level| level.triangles), [24, 12, 2]);
//! # Ok::<(), clipscope::geom::SpaceError>(())
//! ```

use std::marker::PhantomData;

use serde::Serialize;

use crate::{
    algo::{
        ring::Right,
        volume::{ClipVertex, HomogeneousTriangle, SideCode},
    },
    geom::{Matrix, Plane, VolumeSide},
    trace::{Method, Real, Tell, Told, held_after, silent},
};

use super::{
    BackFace, BackFaceInput, Containment, CullRules, SphereCullOutput, Viewer,
    funnel_input::{FunnelInput, FunnelObject, asked_camera, asked_sphere, asked_viewer},
};

/// The algorithm; see the module. `L` are its rules.
#[derive(Clone, Copy, Debug)]
pub struct Funnel<L = Right>(PhantomData<L>);

/// How much of a scene is left.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize)]
pub struct Level {
    /// Objects of which something is left.
    pub objects: usize,
    /// Triangles.
    pub triangles: usize,
}

/// How much is left after each test.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize)]
pub struct FunnelLevels {
    /// Everything.
    pub scene: Level,
    /// After the spheres.
    pub spheres: Level,
    /// After the vertices' codes.
    pub vertices: Level,
    /// After the cuts.
    pub cuts: Level,
    /// Showing their front.
    pub facing: Level,
}

impl FunnelLevels {
    /// Of an object that is inside nothing is asked but its faces.
    fn spheres_done(&mut self, class: Containment, n_triangles: usize) {
        match class {
            Containment::Outside => {}
            Containment::Straddles => self.spheres.add(1, n_triangles),
            Containment::Inside => {
                for level in [&mut self.spheres, &mut self.vertices, &mut self.cuts] {
                    level.add(1, n_triangles);
                }
            }
        }
    }
}

impl Level {
    /// More triangles of an object of which there was `before` as much.
    const fn gain(&mut self, n_triangles: usize, before: Self) {
        self.triangles += n_triangles;
        self.objects = before.objects + 1;
    }

    const fn add(&mut self, objects: usize, triangles: usize) {
        self.objects += objects;
        self.triangles += triangles;
    }
}

/// What becomes of a triangle of an object that straddles.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum TriangleFate {
    /// All its vertices lie beyond one side.
    Outside,
    /// None lies beyond any.
    Inside,
    /// It is clipped: it may come to several triangles, or to none where it only seemed to straddle.
    Cut,
}

/// What happens, in order.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum FunnelEvent {
    /// The next object's turn.
    Object {
        /// Which.
        object_idx: usize,
        /// How many triangles it has.
        n_triangles: usize,
        /// With what it adds to the scene.
        levels: FunnelLevels,
    },
    /// A plane is asked about its sphere.
    Plane {
        /// Which of the volume's.
        side: VolumeSide,
        /// Of the centre.
        distance: f64,
        /// What this plane says of the sphere.
        class: Containment,
    },
    /// One plane has rejected its sphere, or none is left.
    Sphere {
        /// What all planes say.
        class: Containment,
        /// How much is left now.
        levels: FunnelLevels,
    },
    /// A triangle of an object that straddles.
    Triangle {
        /// Which of the object's.
        triangle_idx: usize,
        /// The codes of its vertices.
        codes: [SideCode; 3],
        /// What becomes of it.
        fate: TriangleFate,
        /// How many triangles it comes to.
        n_pieces: usize,
        /// How much is left now.
        levels: FunnelLevels,
    },
    /// A triangle that is left is asked for its side; of one that was cut all pieces together.
    Face {
        /// Which of the object's.
        triangle_idx: usize,
        /// How many triangles it comes to.
        n_pieces: usize,
        /// n·e
        dot: f64,
        /// Does it show its front?
        front: bool,
        /// How much is left now.
        levels: FunnelLevels,
    },
    /// Everything has been asked.
    Done,
}

/// What the funnel works in.
#[derive(Clone, Debug)]
pub struct FunnelHeld {
    /// How much is left, as far as it is known.
    pub levels: FunnelLevels,
    /// The object whose turn it is; after the last one, how many there are.
    pub object_idx: usize,
    /// What the planes say of its sphere.
    pub sphere: SphereCullOutput,
    /// How much was left before its triangles were asked.
    before: FunnelLevels,
    /// The triangle that the run goes on from; before the first, the object has not had its turn.
    n_asked: usize,
}

impl<L: CullRules> Method for Funnel<L> {
    type Input = FunnelInput;
    type Held = FunnelHeld;
    type Output = FunnelLevels;
    type Event = FunnelEvent;

    #[inline]
    fn begin(_: &Self::Input) -> Self::Held {
        FunnelHeld {
            levels: FunnelLevels::default(),
            object_idx: 0,
            sphere: SphereCullOutput::unasked(VolumeSide::ALL.len()),
            before: FunnelLevels::default(),
            n_asked: 0,
        }
    }

    #[inline]
    fn run<R: Real, T: Tell<Self>>(
        input: &Self::Input,
        held: &mut Self::Held,
        tell: &mut T,
    ) -> Told<T::Stop> {
        let asking = Asking::<L> {
            planes: asked_camera::<L>(&input.camera).planes_in_world(),
            clip_from_world: input.camera.clip_from_world(),
            viewer: asked_viewer::<L>(&input.camera),
            rules: PhantomData,
        };
        while let Some(object) = input.objects.get(held.object_idx) {
            if held.n_asked == 0 {
                tell.rest(held);
                asking.sphere::<R, T>(object, held, tell)?;
                held.before = held.levels;
            }
            if held.sphere.class != Containment::Outside {
                asking.triangles::<R, T>(object, held, tell)?;
            }
            held.object_idx += 1;
            held.n_asked = 0;
        }
        tell.tell(held, FunnelEvent::Done)
    }

    #[inline]
    fn output(held: Self::Held) -> Self::Output {
        held.levels
    }

    /// For each object its turn, its sphere's planes and their end; for each triangle its fate and its face; the end.
    fn max_events(input: &Self::Input) -> usize {
        let of = |object: &FunnelObject| 8 + 2 * object.triangles.len();
        input.objects.iter().map(of).sum::<usize>() + 1
    }
}

/// Triangles between two rests within an object: few enough that a step is soon there, many enough to cost nothing.
const BETWEEN_RESTS: usize = 64;

/// What all objects are asked by.
struct Asking<L> {
    planes: [Plane; 6],
    clip_from_world: Matrix,
    viewer: Viewer,
    rules: PhantomData<L>,
}

impl<L: CullRules> Asking<L> {
    /// An object's turn begins: its sphere.
    #[inline]
    fn sphere<R: Real, T: Tell<Funnel<L>>>(
        &self,
        object: &FunnelObject,
        held: &mut FunnelHeld,
        tell: &mut T,
    ) -> Told<T::Stop> {
        let n_triangles = object.triangles.len();
        held.levels.scene.add(1, n_triangles);
        held.sphere = SphereCullOutput::unasked(self.planes.len());
        let begins = FunnelEvent::Object {
            object_idx: held.object_idx,
            n_triangles,
            levels: held.levels,
        };
        tell.tell(held, begins)?;
        let sphere = asked_sphere::<L>(object);
        for (side, plane) in VolumeSide::ALL.into_iter().zip(&self.planes) {
            let (distance, class) = held.sphere.ask::<R, L>(plane, &sphere);
            let asked = FunnelEvent::Plane {
                side,
                distance,
                class,
            };
            tell.tell(held, asked)?;
            if class == Containment::Outside {
                break;
            }
        }
        let class = held.sphere.class;
        held.levels.spheres_done(class, n_triangles);
        let levels = held.levels;
        tell.tell(held, FunnelEvent::Sphere { class, levels })
    }

    /// The triangles of an object that was not culled, from the one that the run goes on from.
    #[inline]
    fn triangles<R: Real, T: Tell<Funnel<L>>>(
        &self,
        object: &FunnelObject,
        held: &mut FunnelHeld,
        tell: &mut T,
    ) -> Told<T::Stop> {
        let is_inside = held.sphere.class == Containment::Inside;
        let triangles = object.triangles.iter().enumerate();
        for (triangle_idx, triangle) in triangles.skip(held.n_asked) {
            if triangle_idx > 0 && triangle_idx.is_multiple_of(BETWEEN_RESTS) {
                held.n_asked = triangle_idx;
                tell.rest(held);
            }
            let n_pieces = if is_inside {
                1
            } else {
                self.codes::<R, T>((triangle_idx, triangle), held, tell)?
            };
            if n_pieces == 0 {
                continue;
            }
            let asked = BackFaceInput {
                triangle: *triangle,
                viewer: self.viewer,
            };
            let face = held_after::<BackFace<L>, R>(&asked);
            if face.front {
                held.levels.facing.gain(n_pieces, held.before.facing);
            }
            let told = FunnelEvent::Face {
                triangle_idx,
                n_pieces,
                dot: face.dot,
                front: face.front,
                levels: held.levels,
            };
            tell.tell(held, told)?;
        }
        Told::Continue(())
    }

    /// A triangle of an object that straddles: to how many triangles it comes.
    #[inline]
    fn codes<R: Real, T: Tell<Funnel<L>>>(
        &self,
        (triangle_idx, triangle): (usize, &[[f64; 3]; 3]),
        held: &mut FunnelHeld,
        tell: &mut T,
    ) -> Told<T::Stop, usize> {
        let corners = triangle.map(|[x, y, z]| ClipVertex {
            at: self.clip_from_world.times([x, y, z, 1.0]),
            attributes: (),
        });
        let codes = corners.map(|corner| SideCode::of(corner.at.map(R::new)));
        let [a, b, c] = codes;
        let (fate, n_pieces) = if !a.and(b).and(c).is_inside() {
            (TriangleFate::Outside, 0)
        } else if a.or(b).or(c).is_inside() {
            (TriangleFate::Inside, 1)
        } else {
            let n = silent::<HomogeneousTriangle>(&corners).triangles().count();
            (TriangleFate::Cut, n)
        };
        if fate != TriangleFate::Outside {
            held.levels.vertices.gain(1, held.before.vertices);
        }
        if n_pieces > 0 {
            held.levels.cuts.gain(n_pieces, held.before.cuts);
        }
        let told = FunnelEvent::Triangle {
            triangle_idx,
            codes,
            fate,
            n_pieces,
            levels: held.levels,
        };
        tell.tell(held, told)?;
        Told::Continue(n_pieces)
    }
}
