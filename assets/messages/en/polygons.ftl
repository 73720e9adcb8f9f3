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
refused-not-convex = This algorithm needs a convex clip region, but { $part } turns the other way at { $vertex }.
refused-winds-twice = This algorithm needs a simple outline, but { $part } has gone around more than once at { $vertex }.
refused-edges-meet = This algorithm needs a simple outline, but in { $part } the edges { $first } and { $second } meet.
refused-misplaced-hole = This algorithm needs every hole inside the polygon, and holes must not touch its border or each other. Here { $part } breaks this rule.
refused-degenerate = There is nothing to clip: { $part } has no area.

## Drawing an outline by clicking

action-draw-subject = Draw the polygon
action-draw-clip = Draw the clip polygon
action-draw-hole = Draw a hole
action-no-hole = Remove this hole
action-no-holes = Remove all holes
draw-subject = Click to place vertex { $number } of the new polygon; Backspace removes the last one, Esc cancels.
draw-clip = Click to place vertex { $number } of the new clip polygon; Backspace removes the last one, Esc cancels.
draw-hole = Click to place vertex { $number } of the new hole; Backspace removes the last one, Esc cancels.
draw-close = Click to place vertex { $number }. Enter, a double click or a click on the first vertex closes the outline.
draw-no-use = The algorithms on the stage cannot use { $part }.

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

ear-opening = This polygon with { $n } vertices is to be divided into triangles.
ear-classify = { $vertex } is { $corner }.
option-corner = { $vertex } is { $option }.
ear-classify-again = With its new neighbour, { $vertex } is { $corner }.
ear-convex = convex
ear-straight = straight
ear-reflex = reflex
ear-round = Round { $round } begins with { $n } vertices.
ear-pass = { $vertex } is { $corner }: it is not an ear.
ear-candidate = { $vertex } is convex. Is another vertex in { $triangle }?
ear-blocked = { $by } is in { $triangle }: { $vertex } is not an ear.
ear-not-convex = { $vertex } is not convex.
ear-is-convex = { $vertex } is convex.
ear-not-empty = Another vertex is in { $triangle }: { $vertex } is not an ear.
ear-ear = No other vertex is in { $triangle }: { $vertex } is an ear.
ear-cut = { $triangle } is cut off along the diagonal { $diagonal }: { $n ->
        [one] { $n } vertex is left.
       *[other] { $n } vertices are left.
    }
ear-last = Three vertices are left: { $triangle } is the last triangle.
ear-done =
    { $n ->
        [one] Done: one triangle, as it was given.
       *[other] Done: { $n } triangles, two fewer than the polygon had vertices.
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
code-ear-again = again: corner(a), corner(b)
code-ear-last = output the three that are left
words-ear-classify = At each vertex v, with a before it and b after it: does the outline turn left, turn right or go straight on?
words-ear-round = Go around until three vertices are left.
words-ear-each = Test every vertex whose corner has changed in the round before; in the first round, test all of them.
words-ear-convex = A vertex can be cut off only where the outline turns left.
words-ear-empty = No other vertex may lie in the triangle. Only vertices that are not convex need to be tested.
words-ear-cut = It is an ear: cut it off along the diagonal ab.
words-ear-again = The corners at a and b have changed: classify both again, and test them in the next round.
words-ear-last = What is left is a triangle.

## Triangulate, then clip

tac-opening = Divide the polygon with { $n } vertices into triangles; then clip each triangle on its own.
tac-triangle = Triangle { $number } of { $total }: { $triangle }. While it is clipped, its vertices are called V₁, V₂ and V₃.
tac-whole = { $triangle } is wholly in the region: it is a piece as it is.
tac-piece = { $triangle } leaves a convex piece with { $n } vertices.
option-piece-cut = { $triangle } is cut: a convex piece is left.
tac-none = { $triangle } leaves nothing in the region.
tac-touch = { $triangle } only touches the region: no piece.
tac-finish =
    { $n ->
        [0] Done: no piece is left. The polygon does not reach into the region.
        [one] Done: one piece.
       *[other] Done: { $n } pieces, all convex and without a bridge.
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
words-tac-triangulate = Divide the polygon into triangles by ear clipping.
words-tac-each = Take one triangle after the other.
words-tac-clip = Clip the triangle by Sutherland–Hodgman: what is left of a convex polygon is convex.
words-tac-piece = If something with an area is left, it is a piece of the answer.
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
sh-opening = Clip the whole polygon, { $n } vertices, against one edge of the region after another: { $edges } edges.
sh-edge-side = Clip against the { $edge }: a point is inside if { $inside }.
sh-edge = Clip against { $edge }: a point is inside if { $inside }.
sh-first-inside = The first vertex, { $vertex }, is inside: it is put out.
sh-first-outside = The first vertex, { $vertex }, is outside: nothing is put out.
sh-in-in = { $from } → { $to }: in → in. Put out { $to }.
option-puts-nothing = { $from } → { $to }: put out nothing.
option-puts-end = { $from } → { $to }: put out { $to }.
option-puts-crossing = { $from } → { $to }: put out the crossing.
option-puts-both = { $from } → { $to }: put out the crossing, then { $to }.
sh-in-out = { $from } → { $to }: in → out. Put out the crossing I.
sh-in-out-touch = { $from } → { $to }: in → out. { $from } is on the edge and is itself the crossing: it is already in the list.
sh-out-in = { $from } → { $to }: out → in. Put out the crossing I, then { $to }.
sh-out-in-touch = { $from } → { $to }: out → in. { $to } is on the edge and is itself the crossing: put it out once.
sh-out-out = { $from } → { $to }: out → out. Put out nothing.
sh-closing-cross = The closing edge { $from } → { $to }: { $rule }. Put out only the crossing I.
sh-closing = The closing edge { $from } → { $to }: { $rule }. Nothing more is put out.
sh-cross = { $from } → { $to } crosses { $border } at I.
sh-output = { $vertex } goes into the output list as { $place }.
sh-pass = { $border } is done: the output list, of length { $n }, is the next input list.
sh-pass-empty = { $border } is done: the output list has length { $n }. Nothing is left to clip.
sh-done-empty = Done after { $edges } edges: no part of the polygon is in the region, and the list is empty.
sh-done-whole = Done: all { $n } vertices are inside all { $edges } edges. The polygon does not change.
sh-done-cut = Done after { $edges } edges: one ring of { $n } vertices is left.
sh-done-degenerate = Done after { $edges } edges: what is left has no area. Length of the last list: { $n }.
code-sh-each = for each clip edge: output ← empty
code-sh-first = F ← first vertex; if inside: put out F
code-sh-edges = for each edge S → P, the last one to F:
code-sh-in-in = in → in: put out P if P ≠ F
code-sh-in-out = in → out: put out I
code-sh-out-in = out → in: put out I, and P if P ≠ F
code-sh-out-out = out → out: put out nothing
code-sh-pass = input ← output
words-sh-each = Take the edges of the clip region in turn, each with an empty output list.
words-sh-first = Put out the first vertex if it is inside.
words-sh-edges = Then follow the outline edge by edge, and close it; at the closing edge F is not put out again.
words-sh-in-in = The edge stays inside: put out its end.
words-sh-in-out = The edge leaves: put out its crossing.
words-sh-out-in = The edge enters: put out its crossing, then its end.
words-sh-out-out = The edge stays outside: put out nothing.
words-sh-pass = What was put out is the polygon for the next clip edge; after the last edge, it is the answer.

## Sutherland–Hodgman as a pipeline

pipe-list-ring = Ring so far
pipe-opening = All { $edges } clippers work at once: the { $n } vertices flow through them one by one.
pipe-send = { $vertex } = { $at } of the polygon goes into the first clipper, { $border }.
pipe-enter = { $vertex } = { $at } flows on into the next clipper, { $border }.
pipe-first-inside = This is the first vertex to reach the clipper { $border }: it is kept as F and flows on, because it is inside.
pipe-first-outside = This is the first vertex to reach the clipper { $border }: it is kept as F and goes no further, because it is outside.
pipe-vertex = S → P: { $rule }. P flows on.
pipe-crossing = S → P: { $rule }. The crossing I flows on.
pipe-both = S → P: { $rule }. The crossing I flows on, then P.
pipe-nothing = S → P: { $rule }. There is no crossing, and P does not flow on.
pipe-closing-cross = The closing edge S → F: { $rule }. The crossing I flows on.
pipe-closing = The closing edge S → F: { $rule }. Nothing flows on.
pipe-cross = S → P crosses { $border } at I.
pipe-output = { $at } leaves the last clipper: it is now { $vertex } of the ring and stays there.
pipe-close = No more vertices will reach the clipper { $border }: it closes its ring.
pipe-close-empty = No vertex has reached the clipper { $border }: there is nothing to close.
pipe-closed = closed
code-pipe-send = for each vertex: send it to clipper 1
code-pipe-enter = clipper k, when P arrives:
code-pipe-first = the first time: F ← P
code-pipe-cross = otherwise, if SP crosses: send I to clipper k + 1
code-pipe-pass-on = S ← P; if P is inside: send P to clipper k + 1
code-pipe-output = what leaves the last clipper joins the ring
code-pipe-close = close clippers 1, 2, …: if SF crosses, send I on
words-pipe-send = The polygon’s vertices go in one by one.
words-pipe-enter = A clipper knows only two vertices: F, its first one, and S, the one before.
words-pipe-first = It keeps the first vertex that arrives.
words-pipe-cross = If the edge from S crosses the border, the crossing goes on first.
words-pipe-pass-on = The vertex is kept as S and goes on if it is inside.
words-pipe-output = A vertex that leaves the last clipper belongs to the answer.
words-pipe-close = At the end each clipper in turn tests the edge from its last vertex back to F.

## Sutherland–Hodgman, wrong on purpose

alg-faulty-on-border = Wrong: the border counts as outside
alg-faulty-open = Wrong: the closing edge is missing
alg-faulty-clockwise = Wrong: the clip edges are walked clockwise
alg-faulty-twice = Wrong: crossings are put out twice
alg-faulty-end-first = Wrong: the end comes before the crossing
faulty-on-border-differs = Step { $step } is the first that differs: a vertex on the border is taken for outside.
faulty-open-differs = Step { $step } is the first that differs: the closing edge, from the last vertex to the first, is never tested.
faulty-clockwise-differs = Step { $step } is the first that differs: the clip edges are walked clockwise, so the outside of each is taken for the inside.
faulty-twice-differs = Step { $step } is the first that differs: the same crossing is put out a second time.
faulty-end-first-differs = Step { $step } is the first that differs: the edge enters, and its end is put out before its crossing.
code-faulty-on-border = for each clip edge: output ← empty; inside is d > 0
words-faulty-on-border = Take the edges of the clip region in turn, each with an empty output list. A vertex on the border counts as outside.
code-faulty-open = for each edge S → P, up to the last vertex:
words-faulty-open = Then follow the outline, edge by edge, up to the last vertex.
code-faulty-clockwise = for each clip edge, clockwise: output ← empty
words-faulty-clockwise = Take the edges of the clip region in turn, clockwise, and take the left of each edge for the inside.
code-faulty-twice-out = in → out: put out I, I
words-faulty-twice-out = The edge leaves: put out its crossing, twice.
code-faulty-twice-in = out → in: put out I, I, P
words-faulty-twice-in = The edge enters: put out its crossing, twice, then its end.
code-faulty-end-first = out → in: put out P if P ≠ F, and I
words-faulty-end-first = The edge enters: put out its end, then its crossing.
## Weiler–Atherton

wa-opening = A polygon with { $n } vertices is clipped by one with { $m } vertices: both become lists of vertices, counter-clockwise.
wa-vertex-subject = { $vertex } goes into the subject’s list. Next: where does the edge { $edge } cross the clip polygon?
wa-vertex-clip = { $vertex } goes into the clip polygon’s list. Next come the intersections on the edge { $edge }, in order.
wa-found-crossing = { $node }: { $subject } crosses { $clip }.
wa-found-on-edge = { $node }: the vertex { $vertex } lies on the edge { $edge }.
wa-found-both = { $node }: the vertices { $subject } and { $clip } are the same point.
wa-meet-crossing = { $subject-edge } crosses { $clip-edge } between the ends of both.
wa-meet-subject-vertex = A vertex of the subject is between the ends of { $clip-edge }.
wa-meet-clip-vertex = A vertex of the clip polygon is between the ends of { $subject-edge }.
wa-meet-both = Both edges begin at the same point.
wa-inserted = { $node } also goes into the clip polygon’s list, on the edge { $edge }.
wa-inserted-vertex = In the clip polygon’s list, { $node } is the vertex { $vertex }.
option-label = { $node }: { $option }
wa-entering = { $node } is entering: the subject goes from { $before } to { $after }.
wa-leaving = { $node } is leaving: the subject goes from { $before } to { $after }.
wa-touching = { $node } only touches: the subject goes from { $before } to { $after }, and stays on the same side.
wa-touching-same = { $node } only touches: the subject stays { $before }.
wa-pinching = { $node } pinches: each border passes through the inside of the other, and two vertices of the result meet here.
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
wa-visit-subject = Along the subject, { $entry } becomes vertex { $n } of the path.
wa-visit-clip = Along the clip polygon, { $entry } becomes vertex { $n } of the path.
wa-past = { $entry } is not a vertex of the ring: the walk goes straight on.
wa-switch-clip = { $node } is leaving: the walk goes on in the clip polygon’s list.
wa-switch-subject = { $node } is entering: the walk goes on in the subject’s list.
wa-switch-pinch-clip = { $node } pinches: the walk goes on in the clip polygon’s list, so that each piece keeps its own vertex.
wa-switch-pinch-subject = { $node } pinches: the walk goes on in the subject’s list, so that each piece keeps its own vertex.
wa-closed-outer = The walk is back on its path: the ring { $ring } with { $n } vertices is closed.
wa-closed-hole = The walk is back on its path: it has gone around a whole ring of the subject. { $ring } with { $n } vertices is a hole.
wa-closed-sliver = The walk is back on its path: { $ring } with { $n } vertices is so thin that no area is left after rounding. It is left out.
wa-whole-subject-kept = The subject’s outline has no change of lists and is { $side }: all of it is the ring { $ring }.
wa-whole-subject-dropped = The subject’s outline has no change of lists and is { $side }: it bounds nothing.
wa-whole-hole-kept = The subject’s hole { $hole } has no change of lists and is { $side }: it stays a hole, { $ring }.
wa-whole-hole-dropped = The subject’s hole { $hole } has no change of lists and is { $side }: it bounds nothing.
wa-whole-clip-kept = The clip polygon has no change of lists and is { $side }: all of it is the ring { $ring }.
wa-whole-clip-dropped = The clip polygon has no change of lists and is { $side }: it bounds nothing.
wa-hole = The hole { $hole } is in the ring { $ring }.
wa-done-disjoint = Done: the two polygons have no point in common.
wa-done-touching = Done: the two polygons touch, but have no area in common.
wa-done-subject = Done: the subject is inside the clip polygon and does not change.
wa-done-clip = Done: the clip polygon is inside the subject and is the answer.
wa-done-equal = Done: both polygons are the same, and so is the answer.
wa-done-crossing =
    { $n ->
        [one] Done: one piece.
       *[other] Done: { $n } pieces.
    }
wa-list-subject = Subject list
wa-list-clip = Clip list
wa-row-start = started at
wa-row-path = vertices on the path
wa-row-rings = rings closed
code-wa-find = for each edge of S: list S ← vertex, intersections with C
code-wa-insert = for each edge of C: list C ← vertex, its intersections
code-wa-label = label each: in, out, touches, pinches
code-wa-start = while an “in” is left: start there, in list S
code-wa-follow = follow the list, output its vertices
code-wa-enter = at an “in”: go on in list S
code-wa-leave = at an “out”: go on in list C
code-wa-close = back at an output vertex: close the ring
code-wa-whole = borders without in or out: inside ⇒ a ring
code-wa-holes = give each hole to the ring around it
words-wa-find = Copy the subject S vertex by vertex into a list. After each vertex put the intersections on its edge, in order.
words-wa-insert = Copy the clip polygon C in the same way: the same intersections, in the order of its own border.
words-wa-label = Label each intersection by what the subject does there. A shared edge counts as inside where both borders run the same way, and as outside where they run in opposite ways.
words-wa-start = Take an entering intersection that no walk has passed yet, and start there in the subject’s list.
words-wa-follow = Follow the list from vertex to vertex, and output each.
words-wa-enter = Where the subject enters, and where both borders pinch, go on in the subject’s list.
words-wa-leave = Where the subject leaves, and where both borders pinch, go on in the clip polygon’s list.
words-wa-close = When the walk reaches a vertex that was output already, what lies between is a ring. When it reaches its start, it ends.
words-wa-whole = A border on which the walk never changes lists is inside or outside as a whole.
words-wa-holes = A hole belongs to the ring that it lies in.
## Sutherland–Hodgman

## Sutherland–Hodgman as a pipeline

## Sutherland–Hodgman, wrong on purpose

## The verdict

verdict-vertex-kept = { $vertex } is kept.
verdict-vertex-cut = { $vertex } is cut away here: this is the first border that it is beyond.
verdict-vertex-passed-by = No walk passes { $vertex }: it is not in the answer.
verdict-edge-dropped = From { $from } to { $to } the edge is cut away.
verdict-vertex-in = Moved { $move } inwards, at right angles to the border ({ $edge }), { $vertex } would be kept.
verdict-vertex-never = No move at right angles to the border ({ $edge }) would keep { $vertex }.
verdict-vertex-out = Moved outwards by more than { $move }, at right angles to the nearest border ({ $edge }), { $vertex } would be cut away.
verdict-vertex-touch = { $vertex } is on the border ({ $edge }): moved outwards by any amount, it would be cut away.
