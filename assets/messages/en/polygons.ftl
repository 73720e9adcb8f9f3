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
refused-last-three = The vertex stays: a polygon needs at least three.
refused-too-many = { $count } vertices are too many: at most { $most }.

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
ear-ear = No other vertex lies in { $triangle }: { $vertex } is an ear.
ear-cut = { $triangle } is cut off along the diagonal { $diagonal }: { $n } vertices are left.
ear-last = Three vertices are left: { $triangle } is the last triangle.
ear-done =
    { $n ->
        [one] Done: one triangle, as it was given.
       *[other] Done: { $n } triangles, two fewer than there were vertices.
    }
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
tac-triangle = Triangle { $number } of { $total }: { $triangle }.
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

## Weiler–Atherton

wa-opening = A polygon with { $n } vertices against one with { $m }: both become lists of vertices, counter-clockwise.
wa-vertex-subject = { $vertex } goes into the subject’s list. Next: where does the edge { $edge } meet the clip polygon?
wa-vertex-clip = { $vertex } goes into the clip polygon’s list. Next: the intersections on the edge { $edge }, in order.
wa-found-crossing = { $node }: { $subject } crosses { $clip }.
wa-found-on-edge = { $node }: the vertex { $vertex } lies on the edge { $edge }.
wa-found-both = { $node }: the vertices { $subject } and { $clip } are the same point.
wa-inserted = { $node } goes into the clip polygon’s list too, on the edge { $edge }.
wa-inserted-vertex = In the clip polygon’s list, { $node } is the vertex { $vertex }.
wa-entering = { $node } is entering: the subject goes from { $before } to { $after }.
wa-leaving = { $node } is leaving: the subject goes from { $before } to { $after }.
wa-touching = { $node } only touches: the subject goes from { $before } to { $after }, and stays on the same side.
wa-pinching = { $node } pinches: each border passes through the inside of the other, and two corners of the result meet.
wa-inside = inside
wa-outside = outside
wa-along = a shared edge in the same direction (inside)
wa-against = a shared edge in the opposite direction (outside)
wa-in = in
wa-out = out
wa-touches = touches
wa-pinches = pinches
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
