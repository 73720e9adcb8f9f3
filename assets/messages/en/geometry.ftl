### The words of the field that all labs share: objects, edges, regions, algorithms, verdicts, refusals.

## Objects

object-segment = segment
object-window = clip window
object-clip-polygon = clip polygon
object-polygon = polygon
object-triangle = triangle
object-vertex = vertex
object-edge = edge
object-plane = plane
object-normal = normal
object-intersection = intersection
object-outcode = outcode
object-clip-volume = clip volume
object-frustum = view frustum
object-sphere = bounding sphere
object-mesh = mesh
object-scene = scene
object-eye = eye
object-camera = camera
object-ray = ray
object-pixel = pixel
object-depth = depth

## The window’s edges, as nouns; the sides alone agree with “edge”

edge-left = left edge
edge-right = right edge
edge-bottom = bottom edge
edge-top = top edge
side-left = left
side-right = right
side-bottom = bottom
side-top = top
side-near = near
side-far = far

## The planes of a clip volume, as nouns

plane-left = left plane
plane-right = right plane
plane-bottom = bottom plane
plane-top = top plane
plane-near = near plane
plane-far = far plane

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
alg-cohen-sutherland-3d = Cohen–Sutherland in 3D
alg-liang-barsky-3d = Liang–Barsky in 3D
alg-plane-line = Segment against planes
alg-homogeneous-line = Segment in clip space
alg-sutherland-hodgman = Sutherland–Hodgman
alg-weiler-atherton = Weiler–Atherton
alg-ear-clipping = Ear clipping
alg-plane-at-a-time = Plane at a time
alg-intersection-polygon = Polygon of intersection
alg-homogeneous-triangle = Triangle in clip space
alg-sphere-cull = Bounding-sphere culling
alg-back-face = Back-face culling
alg-depth-buffer = Z-buffer
alg-painter = Painter’s algorithm
alg-ray-casting = Ray casting
alg-bresenham = Bresenham

## Verdicts, said of a segment, a polygon, a triangle or an object

verdict-accepted = accepted
verdict-rejected = rejected
verdict-clipped = clipped
verdict-touches = touches the boundary
verdict-inside = inside
verdict-outside = outside
verdict-on = on the boundary
verdict-straddles = partly inside
verdict-entering = entering
verdict-leaving = leaving
verdict-parallel = parallel
verdict-visible = visible
verdict-hidden = hidden
verdict-culled = culled
verdict-front = front-facing
verdict-back = back-facing

## Why an input is refused; the last part of the key is the error’s code in the command line’s JSON

error-bad-json = This is not valid JSON.
error-unknown-algorithm = There is no algorithm of this name.
error-unknown-field = There is no field of this name here.
error-missing-field = A field is missing.
error-wrong-type = The value is of the wrong type.
error-wrong-length = The list has the wrong length.
error-not-finite = Every coordinate must be a finite number.
error-empty-window = The window is empty: its left edge must lie left of its right edge, and its bottom edge below its top edge.
error-not-convex = The clip polygon must be convex: this algorithm keeps what is inside every one of its edges.
error-self-intersecting = The polygon crosses itself.
error-degenerate = The shape is degenerate: it has no extent where it needs one.
error-too-few-vertices = A polygon needs at least three vertices.
error-zero-normal = The normal of a plane must not be zero.
error-bad-frustum = The frustum needs 0° < field of view < 180°, a positive aspect ratio and 0 < near < far.
error-too-large = This is more than the visualiser can handle.
error-at = { $place }: { $problem }
