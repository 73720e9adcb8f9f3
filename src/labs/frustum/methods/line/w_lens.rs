//! The w-lens: w over x, as the camera's own space has them, the screen at w = 1, and what lands on it.
//!
//! ```text
//!   x = −w ╲    w    ╱ x = w        From above the view volume is the wedge −w ≤ x ≤ w, the depth of a point its w,
//!           ╲   │ P₁╱               and its image where the line to the eye meets the screen. Of a point behind the
//!   ── w = 1 ╲──┼──╱────            eye that line goes on through the eye: the image is on the other side.
//!             ╲ │ ╱
//!   ───────────eye────── x
//! ```

use crate::{
    algo::volume::{HomogeneousLine, VisibleLine},
    figure::{Multiples, SmallDrawing},
    labs::frustum::prelude::*,
};

use super::marks::{DIVIDED, interval_marks, is_rejected, left_so_far, on_line};

pub const SCREENS_VIEW: &str = "screens";
/// Images farther out are not marked.
const FAR: f64 = 40.0;
const SQUARE: [[f64; 2]; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];

type Ends = [[f64; 4]; 2];

pub fn views(shown: &LineStep<'_, 4, ClipSpace>, scenery: &Scenery) -> Vec<View> {
    let lens = WLens::new(shown, scenery.scene().culler());
    let mut marks = lens.wedge();
    if let Some(side) = shown.in_hand() {
        marks.extend(plane_at_work(lens.camera, side));
    }
    let given = scenery.scene().places().segment;
    let world = given.map(|at| foot(lens.camera, at));
    let feet = given.into_iter().zip(world).filter(|(at, foot)| at != foot);
    let feet = feet.map(|(at, foot)| Mark3::new(Role::Soft, Shape3::Segment([at, foot])));
    marks.extend(feet.map(Mark3::fine));
    marks.extend(lens.segment(&world));
    marks.extend(lens.images(&world));
    let screens = Body::Multiples(Multiples {
        drawings: vec![lens.divided_screen(), lens.clipped_screen()],
        bounds: seen(shown.input.ends.into_iter().filter_map(image)),
        tiles: Tiles::Large,
    });
    vec![
        scenery.observer(|_| Fate::ToCome, marks),
        View::new(SCREENS_VIEW, screens),
    ]
}

/// All of the lens lies in one plane, that of x and w: of a point there is its foot in it.
pub fn foot(camera: &Camera, at: [f64; 3]) -> [f64; 3] {
    let [x, _, z] = camera.view_from_world().point(at);
    camera.world_from_view([x, 0.0, z])
}

/// The square, and around it as much as is needed for what lands beside it, if that is not too far away.
pub fn seen(images: impl Iterator<Item = [f64; 2]>) -> [[f64; 2]; 2] {
    const FARTHEST: f64 = 5.0;
    const AROUND: f64 = 0.4;
    let near = images.filter(|at| at.iter().all(|x| x.abs() <= FARTHEST));
    let widened = |[min, max]: [[f64; 2]; 2], at: [f64; 2]| {
        let low = [0, 1].map(|i| min[i].min(at[i]));
        [low, [0, 1].map(|i| max[i].max(at[i]))]
    };
    let [min, max] = near.fold([[-1.0; 2], [1.0; 2]], widened);
    [min.map(|x| x - AROUND), max.map(|x| x + AROUND)]
}

/// Where a point lands on the screen; `None` where there is no such place, or none that can be shown.
fn image([x, y, _, w]: [f64; 4]) -> Option<[f64; 2]> {
    let at = [x / w, y / w];
    let is_near = at.iter().all(|x| x.abs() <= FAR);
    is_near.then_some(at)
}

/// The image of a segment: of one through w = 0 it leaves on one side and comes back from the other.
fn images_of(ends: Ends) -> Vec<Shape> {
    let [from, to] = ends.map(image);
    let [a, b] = ends;
    // Which way the image goes on the screen, on the way from a to b.
    let [dx, dy] = [0, 1].map(|i| b[i] * a[3] - a[i] * b[3]);
    let ray = |at: [f64; 2], sign: f64| Shape::Ray([at, [at[0] + sign * dx, at[1] + sign * dy]]);
    let shapes = match ends.map(|[.., w]| w > 0.0) {
        [true, true] => [from.zip(to).map(|(a, b)| Shape::Segment([a, b])), None],
        [false, false] => [None, None],
        _ => [from.map(|at| ray(at, 1.0)), to.map(|at| ray(at, -1.0))],
    };
    shapes.into_iter().flatten().collect()
}

pub fn square() -> Vec<Mark> {
    vec![
        Mark::new(Role::Accent, Shape::Fill(vec![SQUARE.to_vec()])),
        Mark::new(Role::Ink, Shape::Outline(SQUARE.to_vec())),
    ]
}

const CUT: [&str; 2] = ["P₁′", "P₂′"];
const CUT_DIVIDED: [&str; 2] = ["P₁′ / w", "P₂′ / w"];

struct WLens<'a> {
    shown: &'a LineStep<'a, 4, ClipSpace>,
    camera: &'a Camera,
    /// By the right rules, the whole run.
    right: VisibleLine<4>,
    joined: Option<[[f64; 2]; 2]>,
}

impl<'a> WLens<'a> {
    fn new(shown: &'a LineStep<'a, 4, ClipSpace>, camera: &'a Camera) -> Self {
        let [from, to] = shown.input.ends.map(image);
        Self {
            shown,
            camera,
            right: silent::<HomogeneousLine>(shown.input),
            joined: from.zip(to).map(Into::into),
        }
    }

    fn is_behind(&self, end: End) -> bool {
        self.shown.input.ends[end.idx()][3] < 0.0
    }

    /// Is the segment between both images a piece that is not to be seen there?
    fn is_wrong(&self) -> bool {
        End::BOTH.into_iter().any(|end| self.is_behind(end))
    }

    fn on_screen(&self, [x, _]: [f64; 2]) -> [f64; 3] {
        let [width, _] = self.camera.volume().half_size();
        self.camera.world_from_view([x * width, 0.0, -1.0])
    }

    fn wedge(&self) -> Vec<Mark3> {
        let volume = self.camera.volume();
        if volume.sight() == Sight::Parallel {
            return Vec::new();
        }
        let (far, eye) = (volume.far(), self.camera.position());
        let [width, _] = volume.half_size();
        let at = |x: f64, w: f64| self.camera.world_from_view([x * width, 0.0, -w]);
        let line = |role, ends| Mark3::new(role, Shape3::Segment(ends));
        let sides = [-far, far].map(|x| at(x, far));
        let mut marks = vec![
            Mark3::new(Role::Accent, Shape3::Wash(vec![eye, sides[0], sides[1]])),
            line(Role::Accent, [eye, sides[0]]).fine(),
            line(Role::Accent, [eye, sides[1]]).fine(),
            line(Role::Soft, [at(-2.6, 1.0), at(2.6, 1.0)]).fine(),
            line(Role::Soft, [at(-2.6, 0.0), at(2.6, 0.0)]).fine(),
            line(Role::Ink, [at(-1.0, 1.0), at(1.0, 1.0)]),
            Mark3::new(Role::Ink, Shape3::Ring(eye)),
            Mark3::new(Role::Ink, Shape3::Label(at(-0.3, -0.1)))
                .labelled(Value::Term("w-lens-eye")),
            Mark3::new(Role::Ink, Shape3::Label(at(2.4, 1.0)))
                .labelled(Value::Term("w-lens-screen")),
            Mark3::new(Role::Soft, Shape3::Label(at(2.4, -0.22))).labelled(name("w = 0")),
        ];
        let equations = ["x = −w", "x = w"].into_iter().zip([-0.7, 0.7]);
        marks.extend(equations.map(|(equation, part)| {
            let label = Shape3::Label(at(part * far, 0.7 * far));
            Mark3::new(Role::Accent, label).labelled(name(equation))
        }));
        marks
    }

    /// The segment in the world: what is left of it by the run, or as it is where the run is about the images.
    fn segment(&self, world: &[[f64; 3]; 2]) -> Vec<Mark3> {
        let shown = self.shown;
        if shown.is_divided {
            return super::marks::segment_marks(world, world, None);
        }
        let visible = shown.verdict.flatten();
        let visible = visible.map(|_| shown.bounds.map(|u| on_line(world, u)));
        interval_marks(world, &shown.interval(None), ClipSpace::SYMBOLS[1], visible)
    }

    fn images(&self, world: &[[f64; 3]; 2]) -> Vec<Mark3> {
        if self.camera.volume().sight() == Sight::Parallel {
            return Vec::new();
        }
        let is_past = self.shown.in_hand().is_some() && !self.shown.is_divided;
        let wrong = if is_past {
            Role::Discarded
        } else {
            Role::Signal
        };
        let mut marks = Vec::new();
        if let (Some(joined), true) = (self.joined, self.is_wrong()) {
            let ends = joined.map(|at| self.on_screen(at));
            marks.push(Mark3::new(wrong, Shape3::Segment(ends)).dashed());
        }
        if let Some(right) = self.right.filter(|_| !self.shown.is_divided)
            && let [Some(from), Some(to)] = right.map(image)
        {
            let ends = [from, to].map(|at| self.on_screen(at));
            marks.push(Mark3::new(Role::Accent, Shape3::Segment(ends)));
        }
        let eye = self.camera.position();
        for end in End::BOTH {
            let given = self.shown.input.ends[end.idx()];
            let Some(at) = image(given) else {
                continue;
            };
            let place = self.on_screen(at);
            let behind = self.is_behind(end);
            let role = if behind { wrong } else { Role::Accent };
            let at = world[end.idx()];
            let sight = if behind { [at, place] } else { [eye, at] };
            let mut sight = Mark3::new(role, Shape3::Segment(sight)).fine();
            sight.is_dashed = behind;
            marks.push(sight);
            let label = sym(["x₁ / w₁ = ", "x₂ / w₂ = "][end.idx()]);
            let label = label.ratio(given[0], given[3]);
            let ring = Mark3::new(role, Shape3::Ring(place)).labelled(label);
            marks.push(ring.linked(end_link(end)));
        }
        marks
    }

    /// An image with its name; of what lies behind the eye also where it is.
    fn point(
        &self,
        (end, symbol): (End, &'static str),
        at: [f64; 2],
        role: Role,
        shape: fn([f64; 2]) -> Shape,
    ) -> Mark {
        let mark = Mark::new(role, shape(at)).linked(end_link(end));
        let is_wrong = self.is_behind(end) && role == Role::Signal;
        let label = is_wrong.then(|| Value::Formula(sym(symbol).sym(" ").point(at)));
        mark.labelled(label.unwrap_or_else(|| name(symbol)))
    }

    fn divided_screen(&self) -> SmallDrawing {
        let is_wrong = self.is_wrong();
        let role = if is_wrong { Role::Signal } else { Role::Accent };
        let mut marks = square();
        if let Some(joined) = self.joined {
            let mut whole = Mark::new(role, Shape::Segment(joined)).linked("segment");
            whole.is_dashed = is_wrong;
            marks.push(whole);
            let [a, b] = joined.map(|[x, y]| [x, y, 0.0, 1.0]);
            if self.shown.is_divided {
                let ends = self.shown.bounds.map(|u| on_line(&[a, b], u));
                let left = ends.map(|[x, y, ..]| [x, y]);
                if !is_rejected(self.shown) {
                    marks.push(Mark::new(role, Shape::Segment(left)));
                    for (end, at) in End::BOTH.into_iter().zip(left) {
                        let cut = Mark::new(role, Shape::Dot(at)).labelled(name(CUT[end.idx()]));
                        marks.extend((at != joined[end.idx()]).then_some(cut));
                    }
                }
            }
            for (end, at) in End::BOTH.into_iter().zip(joined) {
                let role = if self.is_behind(end) { role } else { Role::Ink };
                let named = (end, DIVIDED[end.idx()]);
                marks.push(self.point(named, at, role, Shape::Ring));
            }
            if is_wrong && let Some([Some(from), Some(to)]) = self.right.map(|ends| ends.map(image))
            {
                marks.push(Mark::new(Role::Accent, Shape::Segment([from, to])).dashed());
            }
        }
        let note = match self.joined {
            _ if is_wrong => "screen-wrong",
            None => "screen-no-image",
            Some(_) => "screen-same",
        };
        let role = if is_wrong { Role::Signal } else { Role::Soft };
        let note = Some((role, Value::Term(note)));
        SmallDrawing::new(Value::Term("screen-divide-first"), note, marks)
    }

    fn clipped_screen(&self) -> SmallDrawing {
        let shown = self.shown;
        let given = &shown.input.ends;
        let so_far = (!is_rejected(shown)).then(|| left_so_far(shown));
        let left: Option<Ends> = if shown.is_divided { self.right } else { so_far };
        let is_done = shown.is_divided || shown.verdict.is_some();
        let mut marks = square();
        let mark = |shape| Mark::new(Role::Discarded, shape);
        let discarded = |ends| images_of(ends).into_iter().map(mark);
        match left {
            None => marks.extend(discarded(*given)),
            Some([from, to]) => {
                marks.extend(discarded([given[0], from]));
                marks.extend(discarded([to, given[1]]));
                let role = if is_done {
                    Role::Accepted
                } else {
                    Role::Accent
                };
                let seen = images_of([from, to]).into_iter();
                marks.extend(seen.map(|shape| Mark::new(role, shape).linked("segment")));
                for (end, at) in End::BOTH.into_iter().zip([from, to]) {
                    let place = image(at).filter(|_| at[3] > 0.0);
                    let is_given = at == given[end.idx()];
                    let symbol = if is_given { DIVIDED } else { CUT_DIVIDED }[end.idx()];
                    let point = |place| self.point((end, symbol), place, role, Shape::Dot);
                    marks.extend(place.map(point));
                }
            }
        }
        let (note, role) = match (is_done, left.is_some()) {
            (false, true) => ("screen-so-far", Role::Soft),
            (true, true) => ("screen-right", Role::Accent),
            (_, false) => ("screen-nothing", Role::Soft),
        };
        let note = Some((role, Value::Term(note)));
        SmallDrawing::new(Value::Term("screen-clip-first"), note, marks)
    }
}
