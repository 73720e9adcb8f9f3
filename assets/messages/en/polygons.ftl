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
