### What the frustum lab says: planes, spheres, boxes, faces, the funnel, and what goes wrong in it.

## Planes of the view volume, as they agree with “plane”

plane-near = near
plane-far = far
plane-left = left
plane-right = right
plane-bottom = bottom
plane-top = top

## Views

view-observer = Observer
view-camera = Camera
view-observer-frozen = Observer: culling is frozen
view-camera-flying = Flying camera
camera-that-culls = frozen: it culls
camera-that-flies = it flies
gauge-outside = out
gauge-inside = in
gauge-away = looks away
gauge-faces-camera = faces the camera
gauge-drawn = drawn
gauge-culled = culled
gauges-sphere = One sphere, { $planes } planes
gauges-faces = Faces: { $faces }, by n·e
planes-from-matrix = Taken from the rows of the matrix they are the same, to { $decimals } decimals.
plane-from-matrix = Rows of the matrix: { $sum }. Divided by the length of its normal, { $length }, it is the { $plane } plane, to { $decimals } decimals.
column-plane = plane
column-outside = out
column-vertex = vertex
column-code = code
column-beyond = beyond
no-side = no side in common
codes-left = Vertices inside: { $inside } of 3. Triangles left of it: { $pieces }.
column-least = least
column-most = most

## What can be taken hold of

handle-camera = Camera position
handle-target = Camera target
handle-near = Near plane
handle-far = Far plane
handle-top = Opening of the camera
handle-point = Point P
handle-space-end = End P{ $number }
handle-space-corner = Corner V{ $number }
handle-object = Object { $number }
handle-object-corner = Object { $number }, corner { $corner }

## Methods

alg-point-planes = Point against planes
alg-sphere-cull = Bounding sphere
alg-box-cull = Bounding box
alg-back-face = Back-face test
alg-funnel = Culling funnel
alg-faulty-one-angle = Wrong: one angle for both axes
alg-faulty-turned-sign = Wrong: the sign is turned
alg-faulty-around-origin = Wrong: the sphere is around the origin
alg-faulty-winding = Wrong: corners run clockwise
alg-faulty-constant-view = Wrong: one direction of sight for all

## A point

point-opening = Is P inside { $planes ->
        [one] { $planes } plane
       *[other] all { $planes } planes
    }?
point-inside = P is inside the { $plane } plane.
point-on = P is on the { $plane } plane, which counts as inside.
point-outside = P is outside the { $plane } plane.
point-done-inside = None of { $planes } planes has P outside: it is in the volume.
point-done-outside = P is outside { $outside } of { $planes } planes: it is not in the volume.
code-plane-each = for each plane (n, D):
code-point-distance = d ← n·P + D
code-point-outside = if d < 0: outside
code-point-inside = inside if no plane says outside
words-plane-each = Ask each plane in turn; its normal points inside.
words-point-distance = The normal times the point, plus D, is the signed distance.
words-point-outside = Negative is outside; zero is on the plane, and inside.
words-point-inside = What no plane has outside is in the volume.

## A bounding sphere

sphere-opening = A sphere around all vertices answers for the object: { $planes ->
        [one] { $planes } plane
       *[other] { $planes } planes
    }.
sphere-inside = The sphere is inside the { $plane } plane.
sphere-straddles = The sphere straddles the { $plane } plane.
sphere-outside = The sphere is outside the { $plane } plane: culled whole.
sphere-done-inside = All { $planes } planes have it inside: none of its triangles needs a test.
sphere-done-straddles = It straddles { $cut } of { $planes } planes: its triangles are asked in turn.
planes-done-outside = The { $plane } plane has rejected it after { $planes ->
        [one] { $planes } test
       *[other] { $planes } tests
    }: nothing of it is drawn.
code-sphere-distance = d ← n·c + D
code-sphere-outside = if d < −r: cull
code-sphere-straddles = if d < r: straddles
code-sphere-done = inside if none straddles
words-sphere-distance = The signed distance of the centre from the plane.
words-sphere-outside = Farther out than the radius: all of it is outside.
words-sphere-straddles = Nearer than the radius: the plane cuts the sphere.
words-sphere-done = Inside all planes nothing more need be asked.
class-inside = inside
class-straddles = straddles
class-outside = outside
watch-class = class
watch-object = object

## A bounding box

box-opening = A box around all vertices answers for the object: { $planes } planes, eight corners each.
box-inside = All eight corners are inside the { $plane } plane ({ $outside } outside).
box-straddles = { $outside ->
        [one] { $outside } of 8 corners is
       *[other] { $outside } of 8 corners are
    } outside the { $plane } plane: it straddles.
box-outside = All { $outside } corners are outside the { $plane } plane: culled whole.
box-meets = It straddles { $cut ->
        [one] { $cut } plane
       *[other] { $cut } planes
    }, and something of it is inside them all.
box-in-vain = It straddles { $cut ->
        [one] { $cut } plane
       *[other] { $cut } planes
    }, and yet nothing of it is inside them all.
box-done-inside = All { $planes } planes have it inside.
box-done-straddles = No plane of { $planes } rejects it: its triangles are asked in turn.
box-done-in-vain = The { $planes } planes keep it, and it would be drawn in vain: conservative, not wrong.
box-note-in-vain = Drawn all the same, its { $triangles } triangles cost time. Not one pixel changes: the picture is right.
option-box-inside = All eight corners are inside the { $plane } plane.
option-box-straddles = Only some corners are inside the { $plane } plane: the box straddles it.
option-box-outside = All eight corners are outside the { $plane } plane: the box is culled.
code-box-corners = count corners with n·p + D < 0
code-box-outside = if all eight: cull
code-box-meets = is any point of it inside all?
code-box-done = keep, or draw in vain
words-box-corners = Only the signs of the eight corners count.
words-box-outside = All eight outside one plane: nothing of it can be seen.
words-box-meets = A second test finds boxes that straddle planes and lie outside all the same.
words-box-done = The planes never reject what can be seen; they may keep what cannot.

## A face

face-of-object = { $face } of object { $object }
face-opening = Does face { $face } show its front to the camera?
face-normal = Face { $face } runs counter-clockwise as seen from outside: its normal points outside.
face-to-eye = From V₀ of face { $face } to the camera: e = eye − V₀.
face-to-direction = Parallel: for face { $face } as for all, e is the way back along the line of sight.
face-products = Face { $face }: the dot product, and as a determinant the same number.
face-front = Face { $face } faces the camera: drawn.
face-back = Face { $face } looks away from the camera: culled.
face-edge-on = Face { $face } is edge-on: nothing of it is seen, culled.
code-face-normal = n ← (V₁ − V₀) × (V₂ − V₀)
code-face-viewer = e ← eye − V₀
code-face-product = n·e = |e, V₁ − V₀, V₂ − V₀|
code-face-decide = front if n·e > 0, else cull
words-face-normal = The cross product of two edges is perpendicular to the face.
words-face-viewer = In perspective the way to the eye differs from face to face.
words-face-product = Its sign says on which side of the face the eye is.
words-face-decide = Backs of closed solids are hidden by their fronts.

## The funnel

level-so-far = so far
level-scene = in the scene
level-spheres = after the spheres
level-vertices = after the vertices
level-cuts = after the cuts
level-facing = facing the camera
level-counts = { $triangles ->
        [one] { $triangles } triangle
       *[other] { $triangles } triangles
    } · { $objects ->
        [one] { $objects } object
       *[other] { $objects } objects
    }
funnel-opening = { $objects ->
        [one] { $objects } object
       *[other] { $objects } objects
    } with { $triangles ->
        [one] { $triangles } triangle
       *[other] { $triangles } triangles
    }: which of them need be drawn?
funnel-object = Object { $object }: { $triangles ->
        [one] { $triangles } triangle
       *[other] { $triangles } triangles
    } in one sphere.
funnel-sphere-inside = Object { $object } is inside: its { $triangles } triangles need no clipping.
funnel-sphere-straddles = Object { $object } straddles: its { $triangles } triangles are asked one by one.
funnel-sphere-outside = Object { $object } is culled whole: { $triangles } triangles spared.
funnel-triangle-inside = Triangle { $triangle }: { $inside } of 3 vertices are inside, kept whole.
funnel-triangle-outside = Triangle { $triangle }: all vertices lie beyond one side ({ $inside } inside), culled.
funnel-triangle-cut = Triangle { $triangle }: { $inside } of 3 vertices are inside, cut into { $pieces ->
        [one] { $pieces } triangle
       *[other] { $pieces } triangles
    }.
funnel-triangle-across = Triangle { $triangle }: { $inside ->
        [one] { $inside } vertex
       *[other] { $inside } vertices
    } are inside, and yet it is seen: { $pieces ->
        [one] { $pieces } triangle
       *[other] { $pieces } triangles
    }.
funnel-triangle-nothing = Triangle { $triangle }: { $inside } vertices are inside, and the clipper finds { $pieces } pieces.
option-triangle-inside = Triangle { $triangle } is inside and kept whole.
option-triangle-outside = Triangle { $triangle } lies beyond one side and is culled.
option-triangle-clipped = Triangle { $triangle } goes to the clipper.
funnel-face-front = Triangle { $triangle } of object { $object } faces the camera: drawn.
funnel-face-back = Triangle { $triangle } of object { $object } looks away: culled.
funnel-face-edge-on = Triangle { $triangle } of object { $object } is edge-on: culled.
funnel-done = { $facing ->
        [one] { $facing } triangle
       *[other] { $facing } triangles
    } of { $kept ->
        [one] { $kept } object
       *[other] { $kept } objects
    } are left to draw, of { $triangles ->
        [one] { $triangles } triangle
       *[other] { $triangles } triangles
    } of { $objects }.
code-funnel-each = for each object:
code-funnel-sphere = c, r ← bounding sphere
code-funnel-plane = for each plane: d ← n·c + D
code-funnel-cull = if d < −r: cull the object
code-funnel-straddles = if any d < r: for each triangle:
code-funnel-triangle = codes: cull, keep, or clip
code-funnel-face = cull triangles with n·e ≤ 0
code-funnel-draw = draw what is left
words-funnel-each = Whole objects first: one test may spare all their triangles.
words-funnel-sphere = Around the mean of the vertices, as far as the farthest.
words-funnel-plane = Ask the six planes for the distance of the centre.
words-funnel-cull = Farther out than the radius: leave the object out.
words-funnel-straddles = Only what straddles goes down a level.
words-funnel-triangle = Vertices beyond one side: cull; none beyond any: keep; else clip.
words-funnel-face = What looks away from the camera is hidden by what faces it.
words-funnel-draw = Every level has lost what the one before could tell.

## Mistakes

faulty-one-angle-differs = Step { $step } is the first that differs: the field of view from bottom to top was taken for that from left to right, too.
faulty-turned-sign-differs = Step { $step } is the first that differs: the inner side of the plane was taken for the outer.
faulty-around-origin-differs = Step { $step } is the first that differs: the sphere stands around the model’s origin, not around its centroid.
faulty-winding-differs = Step { $step } is the first that differs: corners were taken to run clockwise, and the normal points inside.
faulty-constant-view-differs = Step { $step } is the first that differs: one direction of sight was taken for all faces.
code-faulty-one-angle = planes by one angle: d ← n·c + D
words-faulty-one-angle = Planes whose sides open as wide as bottom and top.
code-faulty-turned-sign = if d > r: cull the object
words-faulty-turned-sign = What is on the side of the normal is left out.
code-faulty-around-origin = c, r ← origin, radius about the centroid
words-faulty-around-origin = Around the model’s origin, with the radius measured from the centroid.
code-faulty-winding = n ← (V₂ − V₀) × (V₁ − V₀)
words-faulty-winding = The normal of corners that run clockwise.
code-faulty-constant-view = cull triangles with n·v ≥ 0, v constant
words-faulty-constant-view = One direction of sight for every face.

## Menu

camera-title = Camera
camera-position = Position
camera-target = Target
camera-up = Way up
camera-sight = Projection
camera-perspective = Perspective
camera-parallel = Parallel
camera-fov = Field of view
camera-height = Height
camera-aspect = Aspect ratio
camera-near = Near plane
camera-far = Far plane
camera-frozen = Freeze culling
camera-frozen-about = Go on culling with the camera as it is now, and fly around what it kept
object-add = Add an object
object-remove = Remove the object in focus
object-focus = Object
object-face = Face
object-number = Number
object-place = Place
object-turn = Turn
object-size = Size
section-point = Point
section-segment = Segment
section-triangle = Triangle
solid-cube = Cube
solid-tetrahedron = Tetrahedron
solid-octahedron = Octahedron
solid-sphere = Sphere
solid-torus = Torus
solid-angle = L-shaped block
solid-spot = Spot the cow
street-title = Street of boxes
street-count = Boxes
street-make = Build the street

## The verdict

verdict-culled = Object { $object } is culled by the { $plane } plane: d = { $distance } < −r, r = { $radius }. { $move } further in, and no plane would reject it.
verdict-culled-for-good = Object { $object } is culled by the { $plane } plane: d = { $distance } < −r, r = { $radius }. No move along that plane’s normal would bring it in.
verdict-straddles = Object { $object } straddles: nearest is the { $plane } plane, d = { $distance } < r = { $radius }. { $move } further out, and it would be culled.
verdict-inside = Object { $object } is inside: nearest is the { $plane } plane, d = { $distance } ≥ r = { $radius }. { $move } further out, and it would be culled.
verdict-face-in = Moved { $move } along the normal of the { $plane } plane, its corners would no longer all lie beyond one plane.
verdict-face-never = No move along the normal of the { $plane } plane would change that.
verdict-face-cut = Nothing of it lies inside all planes at once: moving it along one plane’s normal does not tell.
verdict-face-turn-to = Turned { $angle }° about V₀, straight towards the viewer, it would begin to show its front.
verdict-face-turn-away = Turned { $angle }° about V₀, straight away from the viewer, it would be edge-on, and culled.
verdict-face-no-normal = It has no normal: no turn would show its front.
part-segment = the segment
part-corner = corner { $vertex }
part-edge = edge { $from }{ $to }
verdict-part-kept = No plane takes anything of { $part }.
verdict-part-cut = The { $plane } plane is the first that cuts { $part }; something of it is left.
verdict-part-lost = The { $plane } plane decides: nothing is left of { $part }.
verdict-part-in = Moved { $move } inwards, at right angles to the { $plane } plane, it would not be lost.
verdict-part-back = Moved { $move } outwards, at right angles to the { $plane } plane, it would not be lost.
verdict-part-never = No move at right angles to the { $plane } plane would change that.
verdict-part-out = Moved outwards by more than { $move }, at right angles to the { $plane } plane, nothing of it would be left.
verdict-part-touch = It only touches the { $plane } plane: the least move outwards, and nothing of it would be left.
verdict-crossing-out = The edge crosses here because its ends lie on different sides of the { $plane } plane: d = { $inner } and d = { $outer }. That plane moved { $move } outwards, there would be no crossing.
verdict-crossing-in = The edge crosses here because its ends lie on different sides of the { $plane } plane: d = { $inner } and d = { $outer }. That plane moved inwards by more than { $move }, there would be no crossing.

## What culling costs, measured

culling-title = What culling costs
culling-about = Every object is asked, then what is left is drawn: in each way the same picture, here and now.
culling-objects = Objects
culling-own = This scene’s own
culling-nothing = Nothing culled
culling-rough = By bounding spheres
culling-exact = By all triangles
culling-row = { $way }: { $cull } ms to cull + { $draw } ms to draw; { $objects } objects, { $triangles } triangles left
culling-inequality = To cull roughly against exactly: { $rough-cull } { $cull-relation } { $exact-cull } ms. To draw what is left: { $rough-draw } { $draw-relation } { $exact-draw } ms.
culling-axis-objects = Objects (boxes on a street)
culling-axis-millis = Milliseconds
culling-best-always = Fastest at every number measured: { $way }.
culling-best-changes = Fastest at first: { $first }. From { $many } objects on: { $last } (at { $few } not yet).
culling-note = The fastest of five passes, at 320 × 200 pixels; spheres are asked many at once. Times belong to this machine and this moment: exported figures show counts.

## A pixel of the camera's picture

pixel-seen = Pixel { $at } shows face { $face } of object { $object }: { $count ->
    [one] the only one there, at this depth.
   *[other] the nearest of { $count } there. Its depth, and the next one’s:
  }
pixel-empty = No face covers pixel { $at }.
pixel-other = { $count ->
    [one] One pixel
   *[other] { $count } pixels
  } { $direction } face { $face } of object { $object } is seen.
pixel-other-nothing = { $count ->
    [one] One pixel
   *[other] { $count } pixels
  } { $direction } nothing is seen.
pixel-shows = Pixel { $at } shows face { $face } of object { $object } at this step.
pixel-shows-nothing = Pixel { $at } shows nothing at this step.
pixel-truth = The nearest there is face { $face } of object { $object }.
pixel-truth-nothing = No face covers it.
pixel-alone = Only this pixel
pixel-all = All pixels
pixel-right = to the right
pixel-left = to the left
pixel-down = down
pixel-up = up
