//! A scene on its way to the screen: what can be left out is left out whole, the largest first.
//!
//! ```text
//!   scene       all objects            ████████████████████████████
//!   objects     a bounding sphere      ██████████████████              outside one plane: culled with all its triangles
//!   triangles   their vertices         ████████████████                all beyond one plane: culled
//!   cut         what straddles         █████████████████               may become more
//!   faces       seen from the back     █████████                       culled
//! ```
//!
//! 1. Each object's sphere is asked of every plane ([`SphereCull`]). Outside: it is culled. Inside: its triangles need not
//!    be asked.
//! 2. Of an object that straddles each triangle's vertices get their codes: all beyond one side: it is culled. None beyond
//!    any: it is kept whole. Else it is clipped ([`HomogeneousTriangle`]): it may come to several triangles, or none.
//! 3. Every triangle that is left is asked whether it shows its front ([`BackFace`]).
//!
//! *Conventions*: as in the three. *Bound*: for each object its turn, those of its sphere, and its fate; for each
//! triangle its cut and its face; the end. *Cost*: of the tests that are asked; the clipper is not counted here.
//!
//! *Source*: J. H. Clark, "Hierarchical geometric models for visible surface algorithms", Communications of the ACM 19,
//! 1976, pp. 547–554.
//!
//! ```
//! use clipscope::{
//!     algo::cull::{Funnel, FunnelInput, FunnelObject},
//!     geom::{Camera, Matrix, Solid, ViewVolume},
//!     trace::silent,
//! };
//! let volume = ViewVolume::perspective(60.0, 1.0, 1.0, 20.0)?;
//! let camera = Camera::new([0.0, 0.0, 5.0], [0.0; 3], [0.0, 1.0, 0.0], volume)?;
//! let cube = |x| FunnelObject::new(&Solid::Cube.mesh(), &Matrix::translation([x, 0.0, 0.0]));
//! let levels = silent::<Funnel>(&FunnelInput { camera, objects: vec![cube(0.0)?, cube(90.0)?] });
//! assert_eq!([levels.scene, levels.spheres, levels.facing].map(|level| level.triangles), [24, 12, 2]);
//! # Ok::<(), clipscope::geom::SpaceError>(())
//! ```

use std::{convert::Infallible, marker::PhantomData};

use serde::Serialize;

use crate::{
    algo::{
        ring::Right,
        volume::{ClipVertex, HomogeneousTriangle, SideCode},
    },
    geom::{Matrix, VolumeSide},
    trace::{
        Algorithm, Real,
        told::{Listening, Method, Told, silent},
    },
};

use super::{
    BackFace, BackFaceInput, BackFaceOutput, Containment, CullRules, SphereCull, SphereCullEvent,
    SphereCullInput, SphereCullOutput, Viewer,
    funnel_input::{FunnelInput, FunnelObject, asked_camera, asked_sphere, asked_viewer},
    funnel_levels::FunnelLevels,
};

/// The algorithm; see the module. `L` are its rules.
#[derive(Clone, Copy, Debug)]
pub struct Funnel<L = Right>(PhantomData<L>);

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

/// How far an object's sphere has been asked.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct AskedSphere {
    /// Each asked plane's distance, and what it says.
    pub asked: Vec<(f64, Containment)>,
    /// The answer, once known.
    pub class: Option<Containment>,
}

/// What the picture of a step needs.
#[derive(Clone, PartialEq, Debug)]
pub struct FunnelState {
    /// How much is left, as far as it is known.
    pub levels: FunnelLevels,
    /// The object whose turn it is.
    pub object_idx: Option<usize>,
    /// How far its sphere's test has come.
    pub sphere: AskedSphere,
    /// What the spheres said of each object so far.
    pub classes: Vec<Containment>,
    /// The triangles of this object so far, with their fates.
    pub triangles: Vec<(usize, TriangleFate)>,
    /// The faces of this object so far, and whether they show their front.
    pub faces: Vec<(usize, bool)>,
    /// Is nothing left to be asked?
    pub is_done: bool,
}

impl<L: CullRules> Algorithm for Funnel<L> {
    type Input = FunnelInput;
    type Output = FunnelLevels;
    type Event = FunnelEvent;
    type State = FunnelState;

    fn run<R: Real>(input: &Self::Input, mut emit: impl FnMut(Self::Event)) -> Self::Output {
        let Some(first) = input.objects.first() else {
            emit(FunnelEvent::Done);
            return FunnelLevels::default();
        };
        let mut asking = Asking {
            sphere: SphereCullInput {
                planes: asked_camera::<L>(&input.camera).planes_in_world().to_vec(),
                sphere: asked_sphere::<L>(first),
            },
            clip_from_world: input.camera.clip_from_world(),
            viewer: asked_viewer::<L>(&input.camera),
        };
        let mut levels = FunnelLevels::default();
        for (object_idx, object) in input.objects.iter().enumerate() {
            let n_triangles = object.triangles.len();
            levels.scene.add(1, n_triangles);
            emit(FunnelEvent::Object {
                object_idx,
                n_triangles,
                levels,
            });
            asking.object::<R, L>(object, &mut levels, &mut emit);
        }
        emit(FunnelEvent::Done);
        levels
    }

    fn start(_: &Self::Input) -> Self::State {
        FunnelState {
            levels: FunnelLevels::default(),
            object_idx: None,
            sphere: AskedSphere::default(),
            classes: Vec::new(),
            triangles: Vec::new(),
            faces: Vec::new(),
            is_done: false,
        }
    }

    fn apply(state: &mut Self::State, event: Self::Event) {
        state.apply(event);
    }

    fn finish(state: &Self::State) -> Self::Output {
        state.levels
    }

    /// For each object its turn, its sphere's planes and their end; for each triangle its fate and its face; the end.
    fn max_events(input: &Self::Input) -> usize {
        let of = |object: &FunnelObject| 8 + 2 * object.triangles.len();
        input.objects.iter().map(of).sum::<usize>() + 1
    }
}

/// What all objects are asked by.
struct Asking {
    /// Of each object in turn, against the same planes.
    sphere: SphereCullInput,
    clip_from_world: Matrix,
    viewer: Viewer,
}

impl Asking {
    fn object<R: Real, L: CullRules>(
        &mut self,
        object: &FunnelObject,
        levels: &mut FunnelLevels,
        emit: &mut impl FnMut(FunnelEvent),
    ) {
        self.sphere.sphere = asked_sphere::<L>(object);
        let n_triangles = object.triangles.len();
        let mut sphere = SphereCull::<L>::begin(&self.sphere);
        let mut listening = Listening(|_: &SphereCullOutput, told| {
            match told {
                SphereCullEvent::Plane {
                    plane_idx,
                    distance,
                    class,
                } => emit(FunnelEvent::Plane {
                    side: VolumeSide::ALL[plane_idx],
                    distance,
                    class,
                }),
                SphereCullEvent::Done { class } => {
                    levels.spheres_done(class, n_triangles);
                    emit(FunnelEvent::Sphere {
                        class,
                        levels: *levels,
                    });
                }
            }
            Told::<Infallible>::Continue(())
        });
        let Told::Continue(()) =
            <SphereCull<L> as Method>::run::<R, _>(&self.sphere, &mut sphere, &mut listening);
        let class = sphere.class;
        if class == Containment::Outside {
            return;
        }
        // Whether anything of it was left before its triangles were asked.
        let before = *levels;
        for (triangle_idx, triangle) in object.triangles.iter().enumerate() {
            let n_pieces = if class == Containment::Inside {
                1
            } else {
                self.triangle::<R>(triangle_idx, triangle, levels, &before, emit)
            };
            if n_pieces > 0 {
                let input = BackFaceInput {
                    triangle: *triangle,
                    viewer: self.viewer,
                };
                let BackFaceOutput { dot, front, .. } = BackFace::<L>::run::<R>(&input, |_| {});
                if front {
                    levels.facing.gain(n_pieces, before.facing);
                }
                emit(FunnelEvent::Face {
                    triangle_idx,
                    n_pieces,
                    dot,
                    front,
                    levels: *levels,
                });
            }
        }
    }

    /// To how many triangles it comes.
    fn triangle<R: Real>(
        &self,
        triangle_idx: usize,
        triangle: &[[f64; 3]; 3],
        levels: &mut FunnelLevels,
        before: &FunnelLevels,
        emit: &mut impl FnMut(FunnelEvent),
    ) -> usize {
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
            levels.vertices.gain(1, before.vertices);
        }
        if n_pieces > 0 {
            levels.cuts.gain(n_pieces, before.cuts);
        }
        emit(FunnelEvent::Triangle {
            triangle_idx,
            codes,
            fate,
            n_pieces,
            levels: *levels,
        });
        n_pieces
    }
}

impl FunnelState {
    fn apply(&mut self, event: FunnelEvent) {
        match event {
            FunnelEvent::Object {
                object_idx, levels, ..
            } => {
                self.object_idx = Some(object_idx);
                self.sphere = AskedSphere::default();
                self.triangles.clear();
                self.faces.clear();
                self.levels = levels;
            }
            FunnelEvent::Plane {
                distance, class, ..
            } => self.sphere.asked.push((distance, class)),
            FunnelEvent::Sphere { class, levels } => {
                self.sphere.class = Some(class);
                self.classes.push(class);
                self.levels = levels;
            }
            FunnelEvent::Triangle {
                triangle_idx,
                fate,
                levels,
                ..
            } => {
                self.triangles.push((triangle_idx, fate));
                self.levels = levels;
            }
            FunnelEvent::Face {
                triangle_idx,
                front,
                levels,
                ..
            } => {
                self.faces.push((triangle_idx, front));
                self.levels = levels;
            }
            FunnelEvent::Done => {
                self.object_idx = None;
                self.is_done = true;
            }
        }
    }
}
