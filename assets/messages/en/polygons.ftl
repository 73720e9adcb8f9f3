# The polygons lab.

handle-clip-vertex = vertex { $number } of the clip polygon
handle-hole-vertex = vertex { $number } of hole { $hole }
handle-polygon = the polygon
texture-title = Texture
texture-none = none
texture-interpolated = interpolated with t
texture-kept = not interpolated (wrong)
part-subject = the subject polygon
part-hole = a hole
part-clip = the clip polygon
refused-not-convex = This algorithm needs a convex clip region: { $part } turns the wrong way at { $vertex }.
refused-winds-twice = This algorithm needs a simple outline: { $part } runs around more than once by { $vertex }.
refused-edges-meet = This algorithm needs a simple outline: in { $part }, the edges { $first } and { $second } meet.
refused-misplaced-hole = This algorithm needs every hole inside the polygon, clear of its border and of the other holes: { $part } is not.
refused-degenerate = Nothing to clip: { $part } has no area.

## Drawing an outline by clicking

action-draw-subject = Draw the polygon
action-draw-clip = Draw the clip polygon
action-draw-hole = Draw a hole
action-no-holes = Remove all holes
draw-subject = Click to place vertex { $number } of the new polygon; Backspace takes one back, Escape gives up.
draw-clip = Click to place vertex { $number } of the new clip polygon; Backspace takes one back, Escape gives up.
draw-hole = Click to place vertex { $number } of the new hole; Backspace takes one back, Escape gives up.
draw-close = Click to place vertex { $number }; Enter, a double click or a click on the first vertex closes the outline.
draw-no-use = The algorithms on stage cannot use { $part }.

## Polygons and regions to start from

preset-title = Example polygons
preset-convex = Convex
preset-triangle = Triangle
preset-arrow = Arrowhead (concave)
preset-comb = Comb: several pieces
preset-corner = Around a corner: a bridge
preset-spiral = Spiral
preset-star = Star
preset-hole = With a hole
preset-around = All around the window
preset-inside = Inside the window
preset-touch = Touching in one point
preset-along = An edge along the border
preset-bow-tie = Bow tie: crosses itself
preset-random = Random
random-count = Vertices
random-make = Replace the polygon
region-title = Clip region
region-window = Window
region-corners = The window’s four corners
region-triangle = Triangle
region-diamond = Diamond
region-octagon = Octagon
region-bracket = L shape (concave)
## Ear clipping

ear-opening = This polygon with { $n } vertices is to be cut into triangles.
ear-classify = { $vertex } is { $corner }.
ear-classify-again = With its new neighbour, { $vertex } is { $corner }.
ear-convex = convex
ear-straight = straight
ear-reflex = reflex
ear-round = Round { $round } begins with { $n } vertices.
ear-pass = { $vertex } is { $corner }: no ear.
ear-candidate = { $vertex } is convex. Does another vertex lie in { $triangle }?
ear-blocked = { $by } lies in { $triangle }: { $vertex } is no ear.
ear-not-convex = { $vertex } is not convex.
ear-is-convex = { $vertex } is convex.
ear-not-empty = Another vertex lies in { $triangle }: { $vertex } is no ear.
ear-ear = No other vertex lies in { $triangle }: { $vertex } is an ear.
ear-cut = { $triangle } is cut off along the diagonal { $diagonal }: { $n } vertices are left.
ear-last = Three vertices are left: { $triangle } is the last triangle.
ear-done =
    { $n ->
        [one] Done: one triangle, as it was given.
       *[other] Done: { $n } triangles, two fewer than there were vertices.
    }
ear-list-ring = What is left
ear-list-triangles = Triangles
ear-inside = inside
ear-outside = outside
ear-left = what is left
ear-n-left = vertices left
ear-n-triangles = triangles
code-ear-classify = for each v: corner(v) ← sign of turn(a, v, b)
code-ear-round = while more than 3 vertices are left
code-ear-each = for each v whose corner is new
code-ear-convex = if corner(v) > 0
code-ear-empty = and no vertex with corner ≤ 0 lies in avb
code-ear-cut = output avb; take v out
code-ear-again = corner(a), corner(b) anew
code-ear-last = output the three that are left
words-ear-classify = At each vertex v, between the one before, a, and the one after, b: does the outline turn left, right or not at all?
words-ear-round = Go around until three vertices are left.
words-ear-each = Ask every vertex whose corner has changed in the round before; in the first round, all of them.
words-ear-convex = A corner can be cut off only where the outline turns left.
words-ear-empty = No other vertex may lie in the triangle. Only those that are not convex need to be asked.
words-ear-cut = It is an ear: cut it off along the diagonal ab.
words-ear-again = The corners at a and b have changed: classify both again, and ask them in the next round.
words-ear-last = What is left is a triangle.

## Triangulate, then clip

tac-opening = Cut the polygon with { $n } vertices into triangles; then clip each of them on its own.
tac-triangle = Triangle { $number } of { $total }: { $triangle }. While it is clipped, its corners are called V₁, V₂ and V₃.
tac-whole = { $triangle } lies in the region: it is a piece as it stands.
tac-piece = { $triangle } leaves a convex piece with { $n } vertices.
tac-none = { $triangle } leaves nothing in the region.
tac-touch = { $triangle } only touches the region: no piece.
tac-finish =
    { $n ->
        [0] Done: no piece. The polygon does not reach into the region.
        [one] Done: one piece.
       *[other] Done: { $n } pieces, all convex: no bridge.
    }
tac-list-triangles = Triangles
tac-list-pieces = Pieces
tac-dropped = dropped
tac-vertices = vertices
tac-now = triangle
tac-pieces = pieces
code-tac-triangulate = triangles ← ear clipping(polygon)
code-tac-each = for each triangle
code-tac-clip = ring ← Sutherland–Hodgman(triangle, region)
code-tac-piece = if ring has an area: output ring
words-tac-triangulate = Cut the polygon into triangles by ear clipping.
words-tac-each = Take one triangle after the other.
words-tac-clip = Clip it by Sutherland–Hodgman: what is left of a convex polygon is convex.
words-tac-piece = If something is left that can be filled, it is a piece of the answer.
## Sutherland–Hodgman

alg-sutherland-hodgman = Sutherland–Hodgman
alg-sutherland-hodgman-pipeline = Sutherland–Hodgman, as a pipeline
rule-in-in = in → in
rule-in-out = in → out
rule-out-in = out → in
rule-out-out = out → out
sh-inside = inside
sh-outside = outside
sh-bridge = bridge: { $length }, there and back
sh-bridge-adds = bridge: area + 0, outline + 2 · { $length }
sh-area = area { $area }
sh-does-not-count = { $inside }: not now
sh-list-input = Input list
sh-list-output = Output list
sh-list-handed-on = Output list = input list
sh-list-next = Next input list
sh-list-given = Polygon
sh-list-left = What is left
sh-list-wrong = × Wrong result
sh-n-inside = { $n } inside
sh-opening = Clip the whole polygon, { $n } vertices, against one edge of the region after the other: { $edges } edges.
sh-edge-side = Clip against the { $edge }: inside is { $inside }.
sh-edge = Clip against { $edge }: inside is { $inside }.
sh-first-inside = The first vertex { $vertex } is inside: it is put out.
sh-first-outside = The first vertex { $vertex } is outside: nothing is put out.
sh-in-in = { $from } → { $to }: in → in. Put out { $to }.
sh-in-out = { $from } → { $to }: in → out. Put out the crossing I.
sh-in-out-touch = { $from } → { $to }: in → out. { $from } lies on the edge and is the crossing itself: it stands in the list already.
sh-out-in = { $from } → { $to }: out → in. Put out the crossing I, then { $to }.
sh-out-in-touch = { $from } → { $to }: out → in. { $to } lies on the edge and is the crossing itself: put it out once.
sh-out-out = { $from } → { $to }: out → out. Put out nothing.
sh-closing-cross = The closing edge { $from } → { $to }: { $rule }. Put out only the crossing I.
sh-closing = The closing edge { $from } → { $to }: { $rule }. Nothing more is put out.
sh-cross = { $from } → { $to } crosses { $border } at I.
sh-output = { $vertex } goes into the output list as { $place }.
sh-pass = { $border } is done: the output list, of length { $n }, is the next input list.
sh-pass-empty = { $border } is done: the output list has length { $n }. Nothing is left to clip.
sh-done-empty = Done after { $edges } edges: nothing of the polygon lies in the region, and the list is empty.
sh-done-whole = Done: all { $n } vertices are inside all { $edges } edges. The polygon stays as it was.
sh-done-cut = Done after { $edges } edges: one ring of { $n } vertices is left.
sh-done-degenerate = Done after { $edges } edges: what is left has no area. Length of the last list: { $n }.
code-sh-each = for each clip edge: output ← empty
code-sh-first = F ← first vertex; if inside: put out F
code-sh-edges = for each edge S → P, last of all to F:
code-sh-in-in = in → in: put out P
code-sh-in-out = in → out: put out I
code-sh-out-in = out → in: put out I, P
code-sh-out-out = out → out: put out nothing
code-sh-pass = input ← output
words-sh-each = Take the edges of the clip region in turn, each with an empty output list.
words-sh-first = Put out the first vertex if it is inside.
words-sh-edges = Then follow the outline, edge by edge, and close it; at the closing edge F is not put out again.
words-sh-in-in = The edge stays inside: put out where it ends.
words-sh-in-out = The edge leaves: put out where it crosses.
words-sh-out-in = The edge comes in: put out where it crosses, then where it ends.
words-sh-out-out = The edge stays outside: put out nothing.
words-sh-pass = What was put out is the polygon for the next clip edge; after the last one, the answer.

## Sutherland–Hodgman as a pipeline

pipe-list-ring = Ring so far
pipe-opening = All { $edges } clippers at once: the { $n } vertices flow through them one by one.
pipe-send = { $vertex } = { $at } of the polygon goes into the first clipper, { $border }.
pipe-enter = { $vertex } = { $at } flows on into the next clipper, { $border }.
pipe-first-inside = The first vertex to reach the clipper { $border }: it is kept as F, and flows on, as it is inside.
pipe-first-outside = The first vertex to reach the clipper { $border }: it is kept as F, and goes no further, as it is outside.
pipe-vertex = S → P: { $rule }. P flows on.
pipe-crossing = S → P: { $rule }. The crossing I flows on.
pipe-both = S → P: { $rule }. The crossing I flows on, then P.
pipe-nothing = S → P: { $rule }. No crossing, and P stays behind.
pipe-closing-cross = The closing edge S → F: { $rule }. The crossing I flows on.
pipe-closing = The closing edge S → F: { $rule }. Nothing flows on.
pipe-cross = S → P crosses { $border } at I.
pipe-output = { $at } leaves the last clipper: it is { $vertex } of the ring, for good.
pipe-close = No more vertices will come to the clipper { $border }: it closes its ring.
pipe-close-empty = No vertex has come to the clipper { $border }: there is nothing to close.
pipe-closed = closed
code-pipe-send = for each vertex: send it to clipper 1
code-pipe-enter = clipper k, when P comes:
code-pipe-first = the first time: F ← P
code-pipe-cross = else if SP crosses: send I to clipper k + 1
code-pipe-pass-on = S ← P; if P is inside: send P to clipper k + 1
code-pipe-output = what leaves the last clipper joins the ring
code-pipe-close = close clippers 1, 2, …: if SF crosses, send I on
words-pipe-send = The polygon’s vertices go in one by one.
words-pipe-enter = A clipper knows two vertices only: F, its first, and S, the one before.
words-pipe-first = It keeps the first vertex that comes.
words-pipe-cross = If the edge from S crosses the border, the crossing goes on first.
words-pipe-pass-on = The vertex is remembered as S, and goes on if it is inside.
words-pipe-output = Behind the last clipper, a vertex belongs to the answer.
words-pipe-close = At the end each clipper in turn looks at the edge from its last vertex back to F.

## Sutherland–Hodgman, wrong on purpose

alg-faulty-on-border = Wrong: the border counts as outside
alg-faulty-open = Wrong: the closing edge is left out
alg-faulty-clockwise = Wrong: the clip edges are walked clockwise
alg-faulty-twice = Wrong: crossings are put out twice
alg-faulty-end-first = Wrong: the end comes before the crossing
faulty-on-border-differs = Step { $step } is the first that differs: a vertex on the border is taken for outside.
faulty-open-differs = Step { $step } is the first that differs: the closing edge, from the last vertex to the first, is never looked at.
faulty-clockwise-differs = Step { $step } is the first that differs: the clip edges are walked clockwise, and the wrong side of each is taken for the inside.
faulty-twice-differs = Step { $step } is the first that differs: the same crossing is put out a second time.
faulty-end-first-differs = Step { $step } is the first that differs: the edge comes in, and its end is put out before its crossing.
code-faulty-on-border = for each clip edge: output ← empty; inside is d > 0
words-faulty-on-border = Take the edges of the clip region in turn, each with an empty output list. A vertex on the border counts as outside.
code-faulty-open = for each edge S → P, up to the last vertex:
words-faulty-open = Then follow the outline, edge by edge, up to the last vertex.
code-faulty-clockwise = for each clip edge, clockwise: output ← empty
words-faulty-clockwise = Take the edges of the clip region in turn, clockwise, with the inside to the left of each.
code-faulty-twice-out = in → out: put out I, I
words-faulty-twice-out = The edge leaves: put out where it crosses, twice.
code-faulty-twice-in = out → in: put out I, I, P
words-faulty-twice-in = The edge comes in: put out where it crosses, twice, then where it ends.
code-faulty-end-first = out → in: put out P, I
words-faulty-end-first = The edge comes in: put out where it ends, then where it crosses.
## Weiler–Atherton

wa-opening = A polygon with { $n } vertices against one with { $m }: both become lists of vertices, counter-clockwise.
wa-vertex-subject = { $vertex } goes into the subject’s list. Next: where does the edge { $edge } meet the clip polygon?
wa-vertex-clip = { $vertex } goes into the clip polygon’s list. Next: the intersections on the edge { $edge }, in order.
wa-found-crossing = { $node }: { $subject } crosses { $clip }.
wa-found-on-edge = { $node }: the vertex { $vertex } lies on the edge { $edge }.
wa-found-both = { $node }: the vertices { $subject } and { $clip } are the same point.
wa-meet-crossing = { $subject-edge } crosses { $clip-edge } within both.
wa-meet-subject-vertex = A vertex of the subject lies within { $clip-edge }.
wa-meet-clip-vertex = A vertex of the clip polygon lies within { $subject-edge }.
wa-meet-both = Both edges begin at the same point.
wa-inserted = { $node } goes into the clip polygon’s list too, on the edge { $edge }.
wa-inserted-vertex = In the clip polygon’s list, { $node } is the vertex { $vertex }.
wa-entering = { $node } is entering: the subject goes from { $before } to { $after }.
wa-leaving = { $node } is leaving: the subject goes from { $before } to { $after }.
wa-touching = { $node } only touches: the subject goes from { $before } to { $after }, and stays on the same side.
wa-touching-same = { $node } only touches: the subject stays { $before }.
wa-pinching = { $node } pinches: each border passes through the inside of the other, and two corners of the result meet.
wa-inside = inside
wa-outside = outside
wa-along = a shared edge in the same direction (inside)
wa-against = a shared edge in the opposite direction (outside)
wa-in = in
wa-out = out
wa-touches = touches
wa-pinches = pinches
wa-intersection = intersection
wa-mark-entering = entering
wa-mark-leaving = leaving
wa-start = A walk starts at { $node }, in the subject’s list.
wa-visit-subject = Along the subject: { $entry } becomes corner { $n } of the path.
wa-visit-clip = Along the clip polygon: { $entry } becomes corner { $n } of the path.
wa-past = { $entry } is no corner: the walk goes straight past it.
wa-switch-clip = { $node } is leaving: on in the clip polygon’s list.
wa-switch-subject = { $node } is entering: on in the subject’s list.
wa-switch-pinch-clip = { $node } pinches: on in the clip polygon’s list, so that each piece keeps to its own corner.
wa-switch-pinch-subject = { $node } pinches: on in the subject’s list, so that each piece keeps to its own corner.
wa-closed-outer = Back where the path has been: the ring { $ring } with { $n } corners is closed.
wa-closed-hole = Back where the path has been: a whole ring of the subject. { $ring } with { $n } corners is a hole.
wa-closed-sliver = Back where the path has been: { $ring } with { $n } corners is so thin that no area is left after rounding. It is left out.
wa-whole-subject-kept = The subject’s outline changes no lists and lies { $side }: all of it is the ring { $ring }.
wa-whole-subject-dropped = The subject’s outline changes no lists and lies { $side }: it bounds nothing.
wa-whole-hole-kept = The subject’s hole { $hole } changes no lists and lies { $side }: it is a hole, { $ring }.
wa-whole-hole-dropped = The subject’s hole { $hole } changes no lists and lies { $side }: it bounds nothing.
wa-whole-clip-kept = The clip polygon changes no lists and lies { $side }: all of it is the ring { $ring }.
wa-whole-clip-dropped = The clip polygon changes no lists and lies { $side }: it bounds nothing.
wa-hole = The hole { $hole } lies in the ring { $ring }.
wa-done-disjoint = Done: the two polygons have no point in common.
wa-done-touching = Done: the two polygons touch, but have no area in common.
wa-done-subject = Done: the subject lies in the clip polygon and stays as it is.
wa-done-clip = Done: the clip polygon lies in the subject and is the answer.
wa-done-equal = Done: both polygons are the same, and so is the answer.
wa-done-crossing =
    { $n ->
        [one] Done: one piece.
       *[other] Done: { $n } pieces.
    }
wa-list-subject = Subject list
wa-list-clip = Clip list
wa-row-start = started at
wa-row-path = corners on the path
wa-row-rings = rings closed
code-wa-find = for each edge of S: list S ← vertex, intersections with C
code-wa-insert = for each edge of C: list C ← vertex, its intersections
code-wa-label = label each: in, out, touches, pinches
code-wa-start = while an in is left: start there, in list S
code-wa-follow = follow the list, output its vertices
code-wa-enter = at an in: go on in list S
code-wa-leave = at an out: go on in list C
code-wa-close = back at an output vertex: close the ring
code-wa-whole = borders without in or out: inside ⇒ a ring
code-wa-holes = give each hole to the ring around it
words-wa-find = Copy the subject S vertex by vertex into a list, and behind each vertex the intersections on its edge, in order.
words-wa-insert = Copy the clip polygon C in the same way: the same intersections, in the order of its own border.
words-wa-label = Label each intersection by what the subject does there. A shared edge counts as inside where both borders run the same way, as outside where they run against each other.
words-wa-start = Take an entering intersection that no walk has come through yet, and start there in the subject’s list.
words-wa-follow = Follow the list from vertex to vertex, and output each.
words-wa-enter = Where the subject enters, and where both borders pinch, go on in the subject’s list.
words-wa-leave = Where the subject leaves, and where both borders pinch, go on in the clip polygon’s list.
words-wa-close = Back at a vertex that was output already: what lies between is a ring. Back at the start, the walk ends.
words-wa-whole = A border on which the walk never changes lists lies inside or outside as a whole.
words-wa-holes = A hole belongs to the ring that it lies in.
## Sutherland–Hodgman

## Sutherland–Hodgman as a pipeline

## Sutherland–Hodgman, wrong on purpose

## The verdict

verdict-vertex-kept = { $vertex } is kept.
verdict-vertex-cut = { $vertex } is cut away here: this is the first border that it lies beyond.
verdict-vertex-passed-by = No walk comes by { $vertex }: it is not in the answer.
verdict-edge-dropped = From { $from } to { $to } the edge is cut away.
verdict-vertex-in = Moved { $move } inwards, at right angles to the border ({ $edge }), { $vertex } would be kept.
verdict-vertex-never = No move at right angles to the border ({ $edge }) would keep { $vertex }.
verdict-vertex-out = Moved outwards by more than { $move }, at right angles to the nearest border ({ $edge }), { $vertex } would be cut away.
verdict-vertex-touch = { $vertex } lies on the border ({ $edge }): the least move outwards, and it would be cut away.
