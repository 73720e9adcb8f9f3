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
gauge-away = faces away
gauge-faces-camera = faces the camera
gauge-drawn = drawn
gauge-culled = culled
gauges-sphere = One sphere, { $planes ->
        [one] { $planes } plane
       *[other] { $planes } planes
    }
gauges-sphere-of = Object { $object }: one sphere, { $planes ->
        [one] { $planes } plane
       *[other] { $planes } planes
    }
gauges-faces = Faces: { $faces }, by n·e
plane-from-matrix = Without angles: { $sum }. Divided by the length of its normal, { $length }, the result is the { $plane } plane, to { $decimals } decimals.
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
handle-space-end = { $number ->
    [1] End P₁
   *[other] End P₂
  }
handle-space-corner = Given vertex { $vertex }
handle-object = Object { $number }
handle-object-corner = Object { $number }, vertex { $corner }

## Methods

alg-point-planes = Point against planes
alg-sphere-cull = Bounding sphere
alg-box-cull = Bounding box
alg-back-face = Back-face test
alg-funnel = Culling funnel
alg-faulty-one-angle = Wrong: one angle for both axes
alg-faulty-turned-sign = Wrong: the sign is reversed
alg-faulty-around-origin = Wrong: the sphere is around the origin
alg-faulty-winding = Wrong: vertices taken clockwise
alg-faulty-constant-view = Wrong: one view direction for all faces

## A point

point-opening = Is P inside { $planes ->
        [one] { $planes } plane
       *[other] all { $planes } planes
    }?
point-inside = P is inside the { $plane } plane.
point-on = P is on the { $plane } plane, which counts as inside.
point-outside = P is outside the { $plane } plane.
point-answer-inside = Inside: the point is outside no plane.
point-answer-outside = Outside: the point is outside at least one plane.
point-done-inside = P is inside { $planes ->
        [one] { $planes } plane
       *[other] all { $planes } planes
    }: P is in the volume.
point-done-outside = P is outside { $outside } of { $planes ->
        [one] { $planes } plane
       *[other] { $planes } planes
    }: P is not in the volume.
code-plane-each = for each plane (n, D):
code-point-distance = d ← n·P + D
code-point-outside = if d < 0: outside
code-point-inside = inside if outside no plane
words-plane-each = Test each plane in turn; its normal points inside.
words-point-distance = The dot product of the normal and the point, plus D, is the signed distance.
words-point-outside = A negative distance is outside; 0 is on the plane and counts as inside.
words-point-inside = A point that is outside no plane is in the volume.

## A bounding sphere

sphere-opening = A sphere around all vertices stands for the object: { $planes ->
        [one] { $planes } plane
       *[other] { $planes } planes
    }.
sphere-inside = The sphere is inside the { $plane } plane.
sphere-straddles = The sphere straddles the { $plane } plane.
sphere-outside = The sphere is outside the { $plane } plane: the whole object is culled.
sphere-done-inside = The sphere is inside { $planes ->
        [one] { $planes } plane
       *[other] all { $planes } planes
    }: none of its triangles needs a test.
sphere-done-straddles = The sphere straddles { $cut } of { $planes ->
        [one] { $planes } plane
       *[other] { $planes } planes
    }: its triangles are tested one by one.
planes-done-outside = The { $plane } plane rejects the object after { $planes ->
        [one] { $planes } test
       *[other] { $planes } tests
    }: nothing of it is drawn.
option-beyond = Outside the { $option } plane
option-within = Inside every plane
option-across = Outside no plane, but not inside all of them
code-sphere-distance = d ← n·c + D
code-sphere-outside = if d < −r: cull
code-sphere-straddles = if d < r: straddles
code-sphere-done = inside if none straddles
words-sphere-distance = Compute the signed distance of the centre from the plane.
words-sphere-outside = The centre is farther out than the radius: the whole sphere is outside.
words-sphere-straddles = The centre is nearer than the radius: the plane cuts the sphere.
words-sphere-done = If the sphere is inside all planes, nothing more needs to be tested.
class-inside = inside
class-straddles = straddles
class-outside = outside
watch-class = class
watch-object = object

## A bounding box

box-opening = A box around all vertices stands for the object: { $planes ->
        [one] { $planes } plane, eight corners.
       *[other] { $planes } planes, eight corners each.
    }
box-inside = All eight corners are inside the { $plane } plane ({ $outside } outside).
box-straddles = { $outside ->
        [one] { $outside } of 8 corners is
       *[other] { $outside } of 8 corners are
    } outside the { $plane } plane: the box straddles it.
box-outside = All { $outside } corners are outside the { $plane } plane: the whole object is culled.
box-meets = The box straddles { $cut ->
        [one] { $cut } plane
       *[other] { $cut } planes
    }, and a part of it is inside them all.
box-in-vain = The box straddles { $cut ->
        [one] { $cut } plane
       *[other] { $cut } planes
    }, and yet no point of it is inside them all.
box-done-inside = The box is inside { $planes ->
        [one] { $planes } plane.
       *[other] all { $planes } planes.
    }
box-done-straddles = { $planes ->
        [one] The { $planes } plane does not reject the box:
       *[other] None of the { $planes } planes rejects the box:
    } its triangles are tested one by one.
box-done-in-vain = The { $planes } planes keep the box, and it would be drawn for nothing: conservative, not wrong.
box-note-in-vain = { $triangles ->
        [one] Its { $triangles } triangle is drawn all the same and costs time.
       *[other] Its { $triangles } triangles are drawn all the same and cost time.
    } No pixel changes: the picture is right.
option-box-inside = All eight corners are inside the { $plane } plane.
option-box-straddles = Only some corners are inside the { $plane } plane: the box straddles it.
option-box-outside = All eight corners are outside the { $plane } plane: the box is culled.
code-box-corners = count corners with n·p + D < 0
code-box-outside = if all eight: cull
code-box-meets = is any point inside all planes?
code-box-done = keep, or draw for nothing
words-box-corners = Only the signs of the eight distances matter.
words-box-outside = If all eight are outside one plane, no part of the object can be seen.
words-box-meets = A second test finds boxes that straddle planes and are outside all the same.
words-box-done = The planes never reject what can be seen; they may keep what cannot be seen.

## A face

face-of-object = { $face } of object { $object }
face-opening = Does the camera see the front of face { $face }?
face-normal = Seen from outside, face { $face } runs counter-clockwise: its normal points outside.
face-to-eye = The vector e leads from V₀ of face { $face } to the camera: e = eye − V₀.
face-to-direction = In parallel projection, for face { $face } as for all, e points back along the line of sight.
face-products = For face { $face } the dot product and the determinant are the same number.
face-front = Face { $face } faces the camera: drawn.
face-back = Face { $face } faces away from the camera: culled.
face-edge-on = Face { $face } is edge-on: nothing of it is seen, and it is culled.
code-face-normal = n ← (V₁ − V₀) × (V₂ − V₀)
code-face-viewer = e ← eye − V₀
code-face-product = n·e = |e, V₁ − V₀, V₂ − V₀|
code-face-decide = front if n·e > 0, otherwise cull
words-face-normal = The cross product of two edges is perpendicular to the face.
words-face-viewer = In perspective the direction to the eye differs from face to face.
words-face-product = The sign of n·e tells on which side of the face the eye is.
words-face-decide = Seen from outside, the front faces of a closed solid hide its back faces.

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
    }: which triangles must be drawn?
funnel-object = Object { $object }: { $triangles ->
        [one] { $triangles } triangle
       *[other] { $triangles } triangles
    } in one sphere.
funnel-sphere-inside = Object { $object } is inside: { $triangles ->
        [one] its { $triangles } triangle needs
       *[other] its { $triangles } triangles need
    } no clipping.
funnel-sphere-straddles = Object { $object } straddles a plane: { $triangles ->
        [one] its { $triangles } triangle is tested.
       *[other] its { $triangles } triangles are tested one by one.
    }
funnel-sphere-outside = The whole object { $object } is culled: { $triangles ->
        [one] { $triangles } triangle is spared.
       *[other] { $triangles } triangles are spared.
    }
funnel-triangle-inside = Triangle { $triangle }: { $inside } of 3 vertices are inside, so it is kept whole.
funnel-triangle-outside = Triangle { $triangle }: all vertices are beyond the same side ({ $inside } inside), so it is culled.
funnel-triangle-cut = Triangle { $triangle }: { $inside } of 3 vertices inside; clipping leaves { $pieces ->
        [one] { $pieces } triangle
       *[other] { $pieces } triangles
    }.
funnel-triangle-across = Triangle { $triangle }: { $inside ->
        [one] { $inside } vertex is
       *[other] { $inside } vertices are
    } inside, and yet a part of it is seen: { $pieces ->
        [one] { $pieces } triangle
       *[other] { $pieces } triangles
    }.
funnel-triangle-nothing = Triangle { $triangle }: { $inside ->
        [one] { $inside } vertex is
       *[other] { $inside } vertices are
    } inside, and clipping leaves { $pieces ->
        [one] { $pieces } piece.
       *[other] { $pieces } pieces.
    }
option-triangle-inside = Triangle { $triangle } is inside and kept whole.
option-triangle-outside = Triangle { $triangle } lies beyond one side and is culled.
option-triangle-clipped = Triangle { $triangle } goes to the clipper.
funnel-face-front = Triangle { $triangle } of object { $object } faces the camera: drawn.
funnel-face-back = Triangle { $triangle } of object { $object } faces away: culled.
funnel-face-edge-on = Triangle { $triangle } of object { $object } is edge-on: culled.
funnel-done = { $facing } of { $triangles ->
        [one] { $triangles } triangle
       *[other] { $triangles } triangles
    } and { $kept } of { $objects ->
        [one] { $objects } object
       *[other] { $objects } objects
    } are left to draw.
code-funnel-each = for each object:
code-funnel-sphere = c, r ← bounding sphere
code-funnel-plane = for each plane: d ← n·c + D
code-funnel-cull = if d < −r: cull the object
code-funnel-straddles = if any d < r: for each triangle:
code-funnel-triangle = codes: cull, keep, or clip
code-funnel-face = cull triangles with n·e ≤ 0
code-funnel-draw = draw what is left
words-funnel-each = Test whole objects first: one test may spare all their triangles.
words-funnel-sphere = Its centre is the mean of the vertices; it reaches as far as the farthest vertex.
words-funnel-plane = Compute the distance of the centre from each of the six planes.
words-funnel-cull = If the centre is farther out than the radius, leave the object out.
words-funnel-straddles = Only objects that straddle a plane go on to the next level.
words-funnel-triangle = All vertices beyond one side: cull; none beyond any side: keep; otherwise clip.
words-funnel-face = Triangles that face away from the camera are hidden by those that face it.
words-funnel-draw = Each level has removed what its test could decide.

## Mistakes

faulty-one-angle-differs = Step { $step } is the first that differs: the field of view from bottom to top was also used from left to right.
faulty-turned-sign-differs = Step { $step } is the first that differs: the inner side of the plane was taken for the outer side.
faulty-around-origin-differs = Step { $step } is the first that differs: the sphere is centred at the model’s origin, not at its centroid.
faulty-winding-differs = Step { $step } is the first that differs: the vertices were taken to run clockwise, so the normal points inside.
faulty-constant-view-differs = Step { $step } is the first that differs: one view direction was used for all faces.
code-faulty-one-angle = planes by one angle: d ← n·c + D
words-faulty-one-angle = The side planes open as wide as those at the bottom and the top.
code-faulty-turned-sign = if d > r: cull the object
words-faulty-turned-sign = Objects on the side to which the normal points are left out.
code-faulty-around-origin = c, r ← origin, radius about the centroid
words-faulty-around-origin = The sphere is centred at the model’s origin, its radius measured from the centroid.
code-faulty-winding = n ← (V₂ − V₀) × (V₁ − V₀)
words-faulty-winding = Compute the normal as if the vertices ran clockwise.
code-faulty-constant-view = cull triangles with n·v ≥ 0, v constant
words-faulty-constant-view = Use one view direction for every face.

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
objects-not-drawn = This method draws no objects.
object-add = Add an object
object-remove = Remove the object in focus
object-focus = Object { $object }
object-face = Face
object-number = Number
object-place = Place
object-turn = Turn
object-size = Size
section-point = Point
section-segment = Segment
section-triangle = Triangle
object-opacity = Opacity
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

verdict-culled = Object { $object } is culled by the { $plane } plane: d = { $distance } < −r, r = { $radius }. Moved { $move } inwards, it would be rejected by no plane.
verdict-culled-for-good = Object { $object } is culled by the { $plane } plane: d = { $distance } < −r, r = { $radius }. No move along that plane’s normal would bring the object in.
verdict-straddles = Object { $object } straddles: the nearest plane is the { $plane } plane, d = { $distance } < r = { $radius }. Moved { $move } outwards, the object would be culled.
verdict-inside = Object { $object } is inside: the nearest plane is the { $plane } plane, d = { $distance } ≥ r = { $radius }. Moved { $move } outwards, the object would be culled.
verdict-face-in = Moved { $move } along the normal of the { $plane } plane, the face would no longer have all its vertices beyond one plane.
verdict-face-never = No move along the normal of the { $plane } plane would change that.
verdict-face-cut = No point of the face is inside all planes at once, so a move along one plane’s normal tells nothing.
verdict-face-turn-to = Turned { $angle }° about V₀, straight towards the camera, the face would begin to show its front.
verdict-face-turn-away = Turned { $angle }° about V₀, straight away from the camera, the face would be edge-on and culled.
verdict-face-no-normal = The face has no normal: no turn would show its front.
part-segment = the segment
part-corner = vertex { $vertex }
part-edge = edge { $from }{ $to }
verdict-part-kept = No plane takes anything of { $part }.
verdict-part-cut = The { $plane } plane is the first that cuts { $part }; a part of it is left.
verdict-part-lost = The { $plane } plane decides: nothing is left of { $part }.
verdict-part-in = Moved { $move } inwards, at right angles to the { $plane } plane, it would not be lost.
verdict-part-back = Moved { $move } outwards, at right angles to the { $plane } plane, it would not be lost.
verdict-part-never = No move at right angles to the { $plane } plane would change that.
verdict-part-out = Moved outwards by more than { $move }, at right angles to the { $plane } plane, nothing of it would be left.
verdict-part-touch = It only touches the { $plane } plane: moved outwards by any amount, nothing of it would be left.
verdict-crossing-out = The edge has a crossing here because its ends lie on different sides of the { $plane } plane: d = { $inner } and d = { $outer }. If that plane stood { $move } farther out, there would be no crossing.
verdict-crossing-in = The edge has a crossing here because its ends lie on different sides of the { $plane } plane: d = { $inner } and d = { $outer }. If that plane stood more than { $move } farther in, there would be no crossing.

## What culling costs, measured

culling-title = What culling costs
culling-about = Every object is tested, then what is left is drawn: the same picture in three ways, measured here and now.
culling-objects = Objects
culling-own = This scene’s own
culling-nothing = Nothing culled
culling-rough = By bounding spheres
culling-exact = By all triangles
culling-row = { $way }: { $cull } ms to cull + { $draw } ms to draw; objects left: { $objects }, triangles: { $triangles }
culling-inequality = Rough culling against exact culling: { $rough-cull } { $cull-relation } { $exact-cull } ms. Drawing what is left: { $rough-draw } { $draw-relation } { $exact-draw } ms.
culling-axis-objects = Objects (boxes on a street)
culling-axis-millis = Milliseconds
culling-best-always = The fastest at every number measured: { $way }.
culling-best-changes = The fastest at first: { $first }. From { $many } objects on: { $last } (not yet at { $few }).
culling-note = The fastest of five passes, at 320 × 200 pixels; many spheres are tested at once. Times belong to this machine and this moment: exported figures show counts.

## A pixel of the camera's picture

pixel-seen = Pixel { $at } shows face { $face } of object { $object }: { $count ->
    [one] it is the only one there, at this depth:
   *[other] it is the nearest of { $count } there. Its depth, and the next one’s:
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
picture-seen = Here face { $face } of object { $object } is seen: { $count ->
    [one] it is the only one there, at this depth:
   *[other] it is the nearest of { $count } there. Its depth, and the next one’s:
  }
picture-empty = No face is seen here.
picture-other = { $percent } % of the picture { $direction } face { $face } of object { $object } is seen.
picture-other-nothing = { $percent } % of the picture { $direction } nothing is seen.
pixel-shows = Pixel { $at } shows face { $face } of object { $object } at this step.
pixel-shows-nothing = Pixel { $at } shows nothing at this step.
pixel-truth = The nearest face there is face { $face } of object { $object }.
pixel-truth-nothing = No face covers this pixel.
pixel-alone = Only this pixel
pixel-all = All pixels
pixel-right = to the right
pixel-left = to the left
pixel-down = down
pixel-up = up
