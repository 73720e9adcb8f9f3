//! Nicholl–Lee–Nicholl: find out which sides are crossed first; compute no crossing that is not output.
//!
//! The lines from P₁ through the window's corners cut the plane into sectors. The sector in which P₂ lies tells by which side the
//! segment comes in and by which it goes out. The paper turns and mirrors every case into one of three; here the sides change names
//! instead of the points' coordinates, and products are compared exactly: the decisions are those of Liang–Barsky. A line through a
//! corner belongs to the vertical side. *Bound*: at most three corners are looked at. *Cost*: 4 to 8 comparisons for the regions; 4 +,
//! 2 × and 1 comparison a corner; 4 +, 2 ×, 1 ÷ and 6 comparisons a cut.
//!
//! *Source*: Tina M. Nicholl, D. T. Lee and Robin A. Nicholl, "An Efficient New Algorithm for 2-D Line Clipping: Its Development and
//! Analysis", SIGGRAPH '87, Computer Graphics 21(4), pp. 253–262, doi:10.1145/37401.37432.
//!
//! ```
//! use clipscope::{algo::line::{NichollLeeNicholl, WindowInput}, geom::{Segment, Window}, trace::silent};
//! let window = Window::new(-1.0, -1.0, 1.0, 1.0)?;
//! let segment = Segment::new(-2.0, -1.0, 2.0, 1.5)?;
//! let visible = silent::<NichollLeeNicholl>(&WindowInput { window, segment });
//! assert_eq!(visible, Some(Segment::new(-1.0, -0.375, 1.0, 0.875)?));
//! # Ok::<(), clipscope::geom::GeomError>(())
//! ```

use std::cmp::Ordering;

use serde::Serialize;

use crate::{
    geom::{Axis, Edge, Point, Segment, Window},
    trace::{Method, Real, Tell, Told},
};

use super::{
    super::parameter::compare_products,
    End, Ratio, Visible, WindowInput,
    crossing::{crossing, on_border, signed_distances},
    segment_between,
};

/// The algorithm; see the module.
#[derive(Clone, Copy, Debug)]
pub struct NichollLeeNicholl;

/// One of the nine regions: the sides that a point lies beyond.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
pub struct WindowRegion {
    /// Left or right, if either.
    pub x: Option<Edge>,
    /// Bottom or top, if either.
    pub y: Option<Edge>,
}

impl WindowRegion {
    /// The region of a point. A point on a border is inside it.
    pub fn of<R: Real>([x, y]: [R; 2], window: &Window) -> Self {
        let beyond = |a: R, low: Edge, high: Edge| {
            if a < R::new(window.border(low)) {
                return Some(low);
            }
            (a > R::new(window.border(high))).then_some(high)
        };
        Self {
            x: beyond(x, Edge::Left, Edge::Right),
            y: beyond(y, Edge::Bottom, Edge::Top),
        }
    }

    /// The sides that the point lies beyond: none, one or two.
    pub fn edges(self) -> impl Iterator<Item = Edge> {
        self.x.into_iter().chain(self.y)
    }

    /// Its vertical and its horizontal side, where it is one of the four corner regions.
    #[must_use]
    pub fn corner(self) -> Option<[Edge; 2]> {
        Some([self.x?, self.y?])
    }

    /// The side that two regions both lie beyond.
    #[must_use]
    pub fn shared(self, other: Self) -> Option<Edge> {
        let same = |a: Option<Edge>, b| if a == b { a } else { None };
        same(self.x, other.x).or(same(self.y, other.y))
    }
}

/// What happens, in order.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum NichollLeeNichollEvent {
    /// The region that an end lies in.
    Region {
        /// Which end.
        end: End,
        /// The sides that it lies beyond.
        region: WindowRegion,
    },
    /// The side of a corner's line on which P₂ lies.
    Side {
        /// What it decides.
        question: Question,
        /// The line from P₁ through the corner, and P₂ beside it.
        #[serde(flatten)]
        line: CornerLine,
    },
    /// The sector in which P₂ lies.
    Sector {
        /// Where the segment comes in; `None` where P₁ is inside.
        enters: Option<Edge>,
        /// Where it goes out; `None` where P₂ is inside.
        leaves: Option<Edge>,
    },
    /// An end moves to its crossing.
    Cut {
        /// Which end.
        end: End,
        /// The side.
        edge: Edge,
        /// Where on the original segment.
        u: Ratio,
        /// From where.
        from: Point,
        /// To where.
        to: Point,
    },
    /// What is left is visible.
    Accept {
        /// The visible part.
        segment: Segment,
    },
    /// Nothing is visible.
    Reject {
        /// The side that both ends lie beyond, or that the segment is beyond where it should come in.
        edge: Edge,
        /// The corner that it misses the window by; `None` where both ends lie beyond the side.
        corner: Option<Point>,
    },
}

/// A line from P₁ through a corner C, and P₂ beside it.
///
/// With `a` and `b` the ends' coordinates from C, P₂ is left of the line where `(C − P₁) × (P₂ − P₁) = b₁·a₂ − a₁·b₂` is
/// positive. Each border lies between P₁ and P₂ wherever the algorithm asks, so both products have the same sign, and their
/// magnitudes tell which is crossed first: `u = |a₁| / (|a₁| + |a₂|)` is below `|b₁| / (|b₁| + |b₂|)` where `|a₁·b₂| < |b₁·a₂|`.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
pub struct CornerLine {
    /// C, the corner.
    pub corner: Point,
    /// The vertical and the horizontal side that meet there.
    pub edges: [Edge; 2],
    /// `a₁·b₂` and `b₁·a₂`, rounded: P₂ is left of the line where the second is larger.
    pub products: [f64; 2],
    /// Where P₂ lies.
    pub turn: Turn,
    /// Of the two borders, the one that the segment's line crosses first; `None` through the corner.
    pub first: Option<Edge>,
}

/// Where a point lies, looking from P₁ through the corner.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Turn {
    /// To the left.
    Left,
    /// On the line.
    Through,
    /// To the right.
    Right,
}

impl CornerLine {
    /// Where P₂ lies. Neither border may have both ends strictly on the same side.
    #[must_use]
    pub fn beside<R: Real>(
        [x_edge, y_edge]: [Edge; 2],
        window: &Window,
        segment: &Segment,
    ) -> Self {
        // Distances are positive inside: right and top need their signs turned to give coordinates.
        let from_corner = |edge: Edge| {
            let distances = signed_distances::<R>(segment, window, edge);
            distances.map(|d| if edge.is_max() { -d } else { d })
        };
        let ([a1, a2], [b1, b2]) = (from_corner(x_edge), from_corner(y_edge));
        let order = compare_products([a1, b2], [b1, a2]);
        let negative = [[a1, b2], [b1, a2]].iter().any(|factors| {
            let [p, q] = factors.map(R::get);
            p < 0.0 && q > 0.0 || p > 0.0 && q < 0.0
        });
        let nearer = if negative { order.reverse() } else { order };
        Self {
            corner: Point::from_finite(window.border(x_edge), window.border(y_edge)),
            edges: [x_edge, y_edge],
            products: [a1.get() * b2.get(), b1.get() * a2.get()],
            turn: match order {
                Ordering::Less => Turn::Left,
                Ordering::Equal => Turn::Through,
                Ordering::Greater => Turn::Right,
            },
            first: match nearer {
                Ordering::Less => Some(x_edge),
                Ordering::Equal => None,
                Ordering::Greater => Some(y_edge),
            },
        }
    }
}

/// What a corner's line is asked.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Question {
    /// By which of two sides does the segment come in?
    Enters,
    /// Does it meet the window at all?
    Meets,
    /// By which of two sides does it go out?
    Leaves,
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub struct NichollLeeNichollHeld {
    /// Of both ends, once known.
    pub regions: [Option<WindowRegion>; 2],
    /// The ends, cut ones at their crossings.
    pub ends: [Point; 2],
    pub visible: Visible,
}

impl Method for NichollLeeNicholl {
    type Input = WindowInput;
    type Held = NichollLeeNichollHeld;
    type Output = Visible;
    type Event = NichollLeeNichollEvent;

    #[inline]
    fn begin(input: &WindowInput) -> NichollLeeNichollHeld {
        NichollLeeNichollHeld {
            regions: [None; 2],
            ends: [input.segment.p1, input.segment.p2],
            visible: None,
        }
    }

    #[inline]
    fn run<R: Real, T: Tell<Self>>(
        input: &WindowInput,
        held: &mut NichollLeeNichollHeld,
        tell: &mut T,
    ) -> Told<T::Stop> {
        use NichollLeeNichollEvent as Event;
        let WindowInput { window, segment } = input;
        let mut regions = [WindowRegion { x: None, y: None }; 2];
        for end in End::BOTH {
            let region = WindowRegion::of(end.of(segment).to_array().map(R::new), window);
            regions[end.idx()] = region;
            held.regions[end.idx()] = Some(region);
            tell.tell(held, Event::Region { end, region })?;
        }
        let sector = match find_sector::<R, T>(input, regions, held, tell)? {
            Ok(sector) => sector,
            Err(reject) => return tell.tell(held, reject),
        };
        let [enters, leaves] = sector.edges;
        tell.tell(held, Event::Sector { enters, leaves })?;
        for end in End::BOTH {
            if let Some(edge) = sector.edges[end.idx()] {
                let (u, to) = cut::<R>(edge, sector.touch, input);
                let from = std::mem::replace(&mut held.ends[end.idx()], to);
                let cut = Event::Cut {
                    end,
                    edge,
                    u,
                    from,
                    to,
                };
                tell.tell(held, cut)?;
            }
        }
        let segment = segment_between(held.ends);
        held.visible = Some(segment);
        tell.tell(held, Event::Accept { segment })
    }

    #[inline]
    fn output(held: NichollLeeNichollHeld) -> Visible {
        held.visible
    }

    /// Two regions, three corners, a sector, two cuts, a verdict.
    fn max_events(_: &WindowInput) -> usize {
        2 + 3 + 1 + 2 + 1
    }
}

struct Sector {
    /// Where the segment comes in and goes out.
    edges: [Option<Edge>; 2],
    /// The corner that is all that it meets of the window.
    touch: Option<Point>,
}

/// Where the segment comes in and goes out, from the regions of both ends; or the event that rejects it.
#[inline]
fn find_sector<R: Real, T: Tell<NichollLeeNicholl>>(
    input: &WindowInput,
    [region1, region2]: [WindowRegion; 2],
    held: &NichollLeeNichollHeld,
    tell: &mut T,
) -> Told<T::Stop, Result<Sector, NichollLeeNichollEvent>> {
    use NichollLeeNichollEvent as Event;
    if let Some(edge) = region1.shared(region2) {
        let corner = None;
        return Told::Continue(Err(Event::Reject { edge, corner }));
    }
    let mut ask = |question, edges| {
        let line = CornerLine::beside::<R>(edges, &input.window, &input.segment);
        tell.tell(held, Event::Side { question, line })?;
        Told::Continue(line)
    };
    let enters = match region1.corner() {
        // P₁ has both sides to cross, and comes in by the second of them.
        Some([x, y]) => match ask(Question::Enters, [x, y])?.first {
            Some(first) if first == x => Some(y),
            _ => Some(x),
        },
        None => region1.edges().next(),
    };
    let mut touch = None;
    if let Some(enters) = enters
        && let Some(next) = region2.edges().find(|e| e.axis() != enters.axis())
    {
        let line = ask(Question::Meets, in_order([enters, next]))?;
        match line.first {
            Some(first) if first == next => {
                let (edge, corner) = (next, Some(line.corner));
                return Told::Continue(Err(Event::Reject { edge, corner }));
            }
            Some(_) => {}
            None => touch = Some((next, line.corner)),
        }
    }
    let leaves = match region2.corner() {
        Some([x, y]) => ask(Question::Leaves, [x, y])?.first.or(Some(x)),
        None => region2.edges().next(),
    };
    // Through the corner and out by the other side is more than a touch.
    let touch = touch.and_then(|(next, corner)| (leaves == Some(next)).then_some(corner));
    let edges = [enters, leaves];
    Told::Continue(Ok(Sector { edges, touch }))
}

/// Two sides that meet at a corner: the vertical one first.
fn in_order([e, f]: [Edge; 2]) -> [Edge; 2] {
    if e.axis() == Axis::X { [e, f] } else { [f, e] }
}

#[inline]
fn cut<R: Real>(
    edge: Edge,
    touch: Option<Point>,
    WindowInput { window, segment }: &WindowInput,
) -> (Ratio, Point) {
    let to = touch.unwrap_or_else(|| on_border::<R>(segment, window, edge));
    let [num, den] = crossing::<f64>(segment, window, edge).ratio;
    (Ratio { num, den }, to)
}
