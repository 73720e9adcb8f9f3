### What the frustum lab says of one vertex on its way through all spaces.

alg-viewing-pipeline = Viewing pipeline

## Spaces

space-model = model
space-world = world
space-view = view
space-clip = clip
space-ndc = NDC
space-screen = screen
space-model-title = Model space
space-world-title = World space
space-view-title = View space: the camera is the origin
space-clip-title = Clip space, over x, y and w
space-clip-parallel-title = Clip space, over x, y and z
space-ndc-title = NDC: divided by w
space-screen-title = Screen, in pixels
object-vertex = Vertex
pipeline-note-world = size, turn and place of the object
pipeline-note-view = camera at { $at }
pipeline-note-clip = { $angle }°, { $aspect } : 1, near plane { $near }, far { $far }
pipeline-note-clip-parallel = height { $height }, { $aspect } : 1, near plane { $near }, far { $far }

## Pseudocode

code-pipeline-world = world ← world_from_model · (P, 1)
code-pipeline-view = view ← view_from_world · (world, 1)
code-pipeline-clip = clip ← clip_from_view · (view, 1)
code-pipeline-test = inside if −w ≤ x, y, z ≤ w
code-pipeline-divide = if w > 0: ndc ← (x, y, z) / w
code-pipeline-screen = screen ← ((x + 1)/2 · columns, (1 − y)/2 · rows)
code-pipeline-behind = otherwise: no place on the screen
words-pipeline-world = The object’s own matrix puts the vertex into the world.
words-pipeline-view = The camera’s matrix tells where the vertex is, seen from the camera.
words-pipeline-clip = The projection scales x and y, and copies the depth into w.
words-pipeline-test = Clipping tests this, before anything is divided.
words-pipeline-divide = Dividing by the depth makes things far away small.
words-pipeline-screen = Scale from −1 … 1 to pixels, counted from the top left.
words-pipeline-behind = A point that is not in front of the eye has no image.

## Steps

pipeline-opening = One vertex is given as the modeller put it: where on the screen will it be?
pipeline-world-row = Row { $row } of the object’s matrix scales, turns and moves the vertex to its place in the world.
pipeline-view-right = Row 1 measures along the camera’s right: P lies { $value } to the right.
pipeline-view-left = Row 1 measures along the camera’s right: P lies { $value } to the left.
pipeline-view-above = Row 2 measures along the camera’s up: P lies { $value } above its axis.
pipeline-view-under = Row 2 measures along the camera’s up: P lies { $value } below its axis.
pipeline-view-back = Row 3 measures backwards: P lies { $value } behind the camera.
pipeline-view-ahead = Row 3 measures backwards: P lies { $value } in front of the camera, so z is negative.
pipeline-clip-x = Row 1 scales x, so that the left and right planes are at x = ±w.
pipeline-clip-y = Row 2 scales y, so that the bottom and top planes are at y = ±w.
pipeline-clip-z = Row 3 puts the near plane at z = −w and the far plane at z = w.
pipeline-clip-w = Row 4 copies the depth into w: { $value }. Later x, y and z are divided by it.
pipeline-clip-w-parallel = Row 4 leaves w at 1: with parallel lines of sight no division is needed.
pipeline-inside = P is inside: x, y and z lie between −w and w.
pipeline-outside = P is outside: clipping removes it.
pipeline-divide = Divide by w = { $w }: what is inside now lies between −1 and 1.
pipeline-screen = Scale from −1 … 1 to { $columns } × { $rows } pixels; rows are counted from the top.
pipeline-behind = P is not in front of the eye: its w cannot be a divisor, and P has no place on the screen.

## Cases

object-model-matrix = model matrix
object-camera = camera
object-picture = picture
json-whole = a whole number
case-whole-too-large = { $number } is larger than any pixel’s number.
case-picture-side = A side of a picture is 1 to { $max } pixels, found { $found }.
case-pipeline-inside = Inside, and on the screen at { $screen }.
case-pipeline-outside = Outside; without clipping it would be on the screen at { $screen }.
case-pipeline-behind = Not in front of the eye: no place on the screen.
object-from = from
object-to = to
case-too-many-pixels = The line has { $found } pixels: at most { $max } are taken.
case-pixels =
    { $count ->
        [one] One pixel.
       *[other] { $count } pixels.
    }

## A line to its pixels

alg-bresenham = Line to pixels (Bresenham)
raster-line = Screen, { $columns } × { $rows } pixels
raster-lens = From the midpoint to the line: e / { $whole } of a pixel
code-drawn-project = clip ← clip_from_world · (P, 1), for both ends
code-drawn-clip = clip the line to −w ≤ x, y, z ≤ w
code-drawn-divide = S ← viewport(x / w, y / w)
code-drawn-begin = a, b ← longer, shorter of |Δx|, |Δy|; e ← 2b − a
code-drawn-put = put the pixel; until the last one:
code-drawn-diagonal = if e > 0, or e = 0 and across has the smaller coordinate:
code-drawn-across = one across; e ← e − 2a
code-drawn-straight = one along; e ← e + 2b
words-drawn-project = Project: both ends go to clip space; nothing is divided yet.
words-drawn-clip = Clip: what the camera cannot see is cut off.
words-drawn-divide = Divide by w, and count in pixels.
words-drawn-begin = Each end goes to its pixel; e tells on which side of the first midpoint the line runs.
words-drawn-put = Go pixel by pixel along the longer axis.
words-drawn-diagonal = Does the line run beyond the midpoint? If it runs exactly through it, the smaller coordinate is taken.
words-drawn-across = Then also go one pixel along the shorter axis.
words-drawn-straight = Go one pixel along the longer axis.
drawn-line-opening = Which pixels does the line have?
drawn-line-project = { $end } goes to clip space, where its depth { $w } becomes w.
drawn-line-project-behind = { $end } goes to clip space. It is not in front of the eye: w = { $w } must not be a divisor.
drawn-line-clip-whole = The whole line is inside: nothing is cut off.
drawn-line-clip-cut = The line is clipped before anything is divided: what is left has w > 0.
drawn-line-reject = No part of the line is inside: no pixel is drawn.
drawn-line-divide = Divided by w and scaled, both ends are places on the screen.
drawn-line-round = Each end goes to the pixel that it lies in; the line now runs from middle to middle.
drawn-line-first = { $at } is the first pixel. e tells on which side of the next midpoint the line runs.
drawn-line-straight = e = { $e } < 0: the line has not reached the midpoint. Go one pixel straight on, to { $at }.
drawn-line-diagonal = e = { $e } > 0: the line runs beyond the midpoint. Go one pixel diagonally, to { $at }.
drawn-line-tie-straight = e = 0: the line is exactly between two pixels, so the smaller coordinate is taken: { $at }.
drawn-line-tie-diagonal = e = 0: the line is exactly between two pixels, so the smaller coordinate is taken: { $at }, diagonally.
