### The words of the field that all labs share: objects, edges, regions, algorithms, verdicts, refusals.

## Objects

object-segment = segment
object-window = clip window
object-clip-polygon = clip polygon
object-polygon = polygon
object-hole = hole
object-uv = texture coordinates
object-outcode = outcode

## The window’s edges, as nouns; the sides alone agree with “edge”

edge-left = left edge
edge-right = right edge
edge-bottom = bottom edge
edge-top = top edge
side-left = left
side-right = right
side-bottom = bottom
side-top = top

## The nine regions around the window

region-above-left = above left
region-above = above
region-above-right = above right
region-left = to the left
region-inside = inside
region-right = to the right
region-below-left = below left
region-below = below
region-below-right = below right

## Algorithms

alg-brute-force = Brute force
alg-cohen-sutherland = Cohen–Sutherland
alg-liang-barsky = Liang–Barsky
alg-cyrus-beck = Cyrus–Beck
alg-nicholl-lee-nicholl = Nicholl–Lee–Nicholl
alg-weiler-atherton = Weiler–Atherton
alg-ear-clipping = Ear clipping
alg-triangulate-and-clip = Triangulate, then clip

## Verdicts, said of a segment, a polygon, a triangle or an object

verdict-entering = entering
verdict-leaving = leaving
verdict-parallel = parallel

## Why an input is refused; the last part of the key is the error’s code in the command line’s JSON

error-not-finite = Every coordinate must be a finite number.
error-empty-window = The window is empty: its left edge must lie left of its right edge, and its bottom edge below its top edge.
error-not-convex = The clip polygon must be convex: this algorithm keeps what is inside every one of its edges.
error-self-intersecting = The polygon crosses itself.
error-edges-meet = The outline must not meet itself: edges { $first } and { $second } cross, touch or overlap.
error-misplaced-hole = Hole { $hole } must lie inside the outline, clear of its edges and of every other hole.
error-degenerate = The shape is degenerate: it has no extent where it needs one.
error-too-few-vertices = A polygon needs at least three vertices.
error-at = { $place }: { $problem }
