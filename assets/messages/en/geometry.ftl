### The words of the field that all labs share: objects, edges, regions, algorithms, verdicts.

## Objects

object-segment = segment
object-window = clip window
object-clip-polygon = clip polygon
object-polygon = polygon
object-hole = hole
object-uv = texture coordinates
object-outcode = outcode
object-planes = planes
object-point = point
object-view-volume = view volume
object-sphere = sphere
object-box = box
object-triangle = triangle
object-eye = eye
object-view-direction = direction of view
object-culled = left out
object-backs = triangles that show their back

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
