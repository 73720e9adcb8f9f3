### What the surfaces lab says: which surface is in front, pixel by pixel.

alg-depth-buffer = Depth buffer
alg-faulty-depth-clear = Depth buffer, cleared to 0
alg-faulty-depth-compare = Depth buffer, comparison reversed
alg-faulty-depth-always = Depth buffer, nothing compared
alg-faulty-depth-straight = Depth buffer, distance linear on the screen

## Pseudocode

code-depth-clear = picture ← background, z ← ∞
words-depth-clear = Set the picture to the background and every depth to infinity.
code-depth-clear-reversed = picture ← background, z ← −∞
words-depth-clear-reversed = Set the picture to the background and every depth to minus infinity: nothing is farther away.
code-depth-triangle = for each triangle T
words-depth-triangle = Take the triangles, in any order.
code-depth-fragment = for each pixel in T: z_T ← depth of T there
words-depth-fragment = For each pixel whose middle the triangle covers, find its depth there.
code-depth-compare = if z_T < z[pixel]
words-depth-compare = Compare this depth with the stored one.
code-depth-compare-reversed = if z_T > z[pixel]
code-depth-write = picture[pixel] ← T, z[pixel] ← z_T
words-depth-write = If it is less, write the triangle and its depth.
words-depth-write-reversed = If it is greater, write the triangle and its depth: 1 means near.
code-faulty-depth-clear = picture ← background, z ← 0
words-faulty-depth-clear = Set every depth to 0, the depth of the near plane.
code-faulty-depth-clear-reversed = picture ← background, z ← 1
words-faulty-depth-clear-reversed = Set every depth to 1, the depth of the near plane.
code-faulty-depth-compare = if z_T > z[pixel]
words-faulty-depth-compare = Write the triangle where the new depth is greater.
words-faulty-depth-compare-reversed = Write the triangle where the new depth is less, although 1 means near.
code-faulty-depth-always = always
words-faulty-depth-always = Always write, without comparing depths.
code-faulty-depth-straight = for each pixel in T: z_T ← distance, linear on the screen
words-faulty-depth-straight = Interpolate the distance in view space linearly on the screen, without the divide.
faulty-depth-clear-differs = Step { $step } is the first that differs: nothing is nearer than the near plane, so nothing will be written.
faulty-depth-compare-differs = Step { $step } is the first that differs: the triangle is nearer than what is stored, and is not written.
faulty-depth-always-differs = Step { $step } is the first that differs: the triangle is written, although it is not nearer than what is stored.
faulty-depth-straight-differs = Step { $step } is the first that differs: this depth is not that of the surface, since distance is not linear on the screen.

## The depth buffer

depth-opening = { $triangles ->
    [one] One triangle
   *[other] { $triangles } triangles
  } on { $columns } × { $rows } pixels. Depths stored, one for each pixel: { $pixels }, of { $bits } bits each, { $bytes } bytes in all.
depth-clear = The picture is cleared: { $pixels ->
    [one] its one pixel shows no triangle yet.
   *[other] none of its { $pixels } pixels shows a triangle yet.
  }
depth-triangle = Next comes { $triangle }, { $place } of { $triangles }.
depth-triangle-unseen = Nothing of { $triangle } is drawn: it is outside the volume, is edge-on or shows its back.
depth-answer-drawn = { $triangle } is drawn.
depth-triangle-whole = { $triangle } is drawn. Its fragments: { $fragments }; written: { $writes }.
depth-span = Row { $row } of { $triangle }, columns { $first } to { $last }: { $writes } of { $fragments ->
    [one] { $fragments } fragment
   *[other] { $fragments } fragments
  } written.
depth-fragment-first = Pixel { $at } is still empty: { $triangle } is written.
depth-fragment-kept = { $triangle } is nearer than { $other } at pixel { $at }: it is written.
depth-fragment-lost = { $triangle } is not nearer than { $other } at pixel { $at }: { $other } stays.
depth-fragment-kept-behind = { $triangle } is not nearer than { $other } at pixel { $at }, and yet it is written.
depth-fragment-tie = { $triangle } is as near as { $other } at pixel { $at }: { $other } came first and stays.
depth-fragment-lost-to-nothing = { $triangle } is not written at pixel { $at }, although nothing was there.
depth-nothing = nothing
depth-done = Done: { $fragments ->
    [one] one fragment
   *[other] { $fragments } fragments
  }, of which { $writes ->
    [one] one was
   *[other] { $writes } were
  } written, for { $pixels ->
    [one] one pixel
   *[other] { $pixels } pixels
  }. Average times each pixel was computed:
raster-brightness = Brightness in thousandths
raster-brightness-bare = Brightness

## Views

practice-then = what stands there then
raster-depth = Depth in thousandths
raster-depth-bare = Depth
raster-depth-unit = Depth in units of { $unit }
raster-straight = Distance from near plane to far plane, in thousandths
raster-straight-bare = Distance from near plane to far plane
raster-depth-steps = Depth in { $bits } bits: 0 to { $last }
raster-distance = Distance from the camera
raster-counts-none = Times each pixel is computed
raster-counts = Times computed: { $seen } seen, { $vain } for nothing
raster-counts-before = Every face drawn: { $seen } seen, { $vain } for nothing
raster-counts-after = Back faces left out: { $seen } seen, { $vain } for nothing
painter-depths = Distance of each triangle, from its nearest to its farthest vertex
asks-what = tests
asks-now = now
asks-so-far = so far
asks-done = done
asks-of = { $count } of { $all }
asks-ray-casting = each pixel: which triangle?
asks-depth-buffer = each triangle: which pixels?
asks-painter = each pair: which one first?
raster-pairs = { $pairs ->
    [one] { $pairs } test of a pair
   *[other] { $pairs } tests of pairs
  } of { $triangles ->
    [one] { $triangles } triangle
   *[other] { $triangles } triangles
  }
raster-questions = { $questions ->
    [one] { $questions } test
   *[other] { $questions } tests
  } by { $pixels ->
    [one] { $pixels } ray
   *[other] { $pixels } rays
  }
occlusion-triangles = Triangles of each object
scale-near = near { $value }
scale-far = { $value } far
raster-wrong = { $count ->
    [one] One pixel is wrong
   *[other] { $count } pixels are wrong
  }
depth-glass-behind = { $triangle } is behind { $other } at pixel { $at } and is lost, though { $other } lets { $through } of the light through.
depth-glass-done = Done: { $unsorted ->
    [0] at every pixel each surface came over what is behind it
    [one] at one pixel a pane came before what is behind it, and that was lost: one depth a pixel keeps no order
   *[other] at { $unsorted } pixels a pane came before what is behind it, and that was lost: one depth a pixel keeps no order
  }. Average times each was computed:
depth-done-stored = Done: the depths of { $pixels ->
    [one] one pixel
   *[other] { $pixels } pixels
  } go from { $least } to { $most }.
depth-done-distance = Done: the distances of { $pixels ->
    [one] one pixel
   *[other] { $pixels } pixels
  } go from { $least } to { $most }.
depth-done-nothing = Done: { $fragments ->
    [one] { $fragments } fragment,
   *[other] { $fragments } fragments,
  } none of them written.
curve-whole = Depth over distance
curve-enlarged = Enlarged
curve-forward = Not reversed
curve-reversed = Reversed
curve-near = Near plane at { $near }
curve-step = depth step: { $step }
curve-distance = distance
curve-depth = depth
story-title = Pixel { $at } in order of arrival
story-held = Stored depth
story-nearer = nearer
story-stored = stored
story-fate = result
story-kept = written
story-lost = lost
story-stays = written, stays
story-tie = equally near: lost
watch-triangle = triangle
watch-pixel = pixel
watch-fragments = fragments
watch-writes = written
watch-pixels = pixels

## Ray casting

alg-ray-casting = Ray casting
code-ray-pixel = for each pixel: ray o + t · r through its middle
words-ray-pixel = For each pixel, take the ray from the eye through its middle.
code-ray-triangle = for each triangle T with plane n·p + d = 0
words-ray-triangle = Test every triangle.
code-ray-parallel = if n·r = 0: no hit
words-ray-parallel = A ray that is parallel to the plane does not meet it.
code-ray-plane = t ← −(n·o + d) / (n·r)
words-ray-plane = Find where the ray meets the plane.
code-ray-range = if t < 1 or beyond far plane: no hit
words-ray-range = Nothing is seen behind the eye, in front of the near plane or beyond the far plane.
code-ray-inside = if o + t · r in T: hit
words-ray-inside = If that point lies in the triangle, it is a hit.
code-ray-nearest = picture[pixel] ← T of the smallest t
words-ray-nearest = The hit with the smallest t is seen.
ray-opening = { $rays ->
    [one] One ray
   *[other] { $rays } rays
  } for { $columns } × { $rows } pixels, each tested against { $triangles ->
    [one] one triangle.
   *[other] { $triangles } triangles.
  }
ray-pixel = The ray through the middle of pixel { $at } is at the eye for t = 0 and on the near plane for t = 1.
ray-hit-first = The ray hits { $triangle }: this is the nearest hit so far.
ray-hit-nearer = The ray hits { $triangle } in front of { $other }, which is at t = { $t }: now { $triangle } is the nearest.
ray-hit-farther = The ray hits { $triangle } behind { $other }, which is at t = { $t }.
ray-answer-farther = The ray hits { $triangle } behind the nearest hit.
ray-says-culled = { $triangle } is not tested: it is edge-on or shows its back.
ray-says-parallel = The ray is parallel to the plane of { $triangle }: n·r = 0, and they never meet.
ray-says-behind = The ray’s line meets the plane of { $triangle } behind the eye: t < 0.
ray-says-before-near = The ray meets { $triangle } in front of the near plane: t < 1.
ray-says-beyond-far = The ray meets { $triangle } beyond the far plane.
ray-says-beside = The ray meets the plane of { $triangle } outside the triangle: no hit.
ray-seen = Pixel { $at } shows { $triangle }: it has the smallest t of { $hits ->
    [one] one hit.
   *[other] { $hits } hits.
  }
ray-seen-before-others = Pixel { $at } takes { $triangle }: the ray ends at t = { $t }, and { $hidden } { $hits ->
    [2] lies
   *[other] lie
  } in the shadow of { $triangle }.
ray-seen-nothing = Pixel { $at } keeps the background: its ray hits no triangle.
ray-done = Done: { $rays ->
    [one] one ray,
   *[other] { $rays } rays, each
  } tested against { $triangles ->
    [one] one triangle.
   *[other] { $triangles } triangles.
  }
ray-culled = not tested
ray-parallel = parallel
ray-behind = behind the eye
ray-before-near = in front of near plane
ray-beyond-far = beyond far plane
ray-beside = outside
ray-hit = behind
ray-nearest = nearest
ray-eye = eye
ray-raster = raster
raster-so-far = Picture so far
watch-hits = hits
watch-nearest = nearest
watch-asked = tests

## Painter's algorithm

alg-painter = Painter’s algorithm
alg-faulty-painter-nearest = Painter, sorted by the nearest vertex
alg-faulty-painter-keys = Painter, sorted without further tests
code-paint-key = for each triangle T: key ← distance of its farthest vertex
words-paint-key = The sort key of a triangle is the distance of its farthest vertex.
code-paint-sort = sort by key, farthest first
words-paint-sort = Sort the triangles by key, the farthest first.
code-paint-ask = for each P in the list: may P come before all Q that are left?
words-paint-ask = Take the first triangle that is left, and test whether it may come before all others.
code-paint-object = if P hides part of Q: Q must come before P
words-paint-object = If it hides a part of another one, that one must come first and is tested next.
code-paint-cycle = if Q waits for P: cycle
words-paint-cycle = If that one is already waiting, there is no right order.
code-paint-place = otherwise P is next
words-paint-place = If it hides no part of any other, it is the next.
code-paint-paint = paint all, in that order
words-paint-paint = Paint the triangles in that order, each over what is already there.
code-faulty-painter-nearest = for each triangle T: key ← distance of its nearest vertex
words-faulty-painter-nearest = The sort key of a triangle is the distance of its nearest vertex.
code-faulty-painter-keys = for each P in the list: P is next
words-faulty-painter-keys = Take the triangles in sorted order, without any test.
faulty-painter-nearest-differs = Step { $step } is the first that differs: the key is the distance of the nearest vertex, not of the farthest.
faulty-painter-keys-differs = Step { $step } is the first that differs: no test decides whether this triangle may come next.
surfaces-first = Only the first { $triangles } of { $all } triangles: the steps of all would be too many to follow.
refused-too-many-faces = Refused: the scene has { $triangles } triangles, and this method takes { $most } at most. Take objects out, or choose another method.
painter-opening = { $triangles ->
    [one] One triangle is
   *[other] { $triangles } triangles are
  } to be painted, the farthest first: what is painted later hides what was painted earlier.
painter-key = { $triangle } has the key { $key }. Its vertices lie between these distances:
painter-sort = { $triangle } is number { $place } in the list, farthest first.
painter-pair-depths = { $triangle } is farther away than all of { $other }: it may come first.
painter-pair-screen = { $triangle } and { $other } are apart on the screen: either may come first.
painter-pair-behind = { $triangle } is behind the plane of { $other }: it may come first.
painter-pair-before = { $other } is in front of the plane of { $triangle }: { $triangle } may come first.
painter-pair-overlap = Nowhere on the screen is { $triangle } nearer than { $other }: it may come first.
painter-pair-hides = { $triangle } hides a part of { $other }: it must not come first.
painter-ask-depths = 1  Is { $triangle } farther away than all of { $other }?
painter-ask-screen = 2  Are they apart on the screen?
painter-ask-behind = 3  Is { $triangle } behind the plane of { $other }?
painter-ask-before = 4  Is { $other } in front of the plane of { $triangle }?
painter-ask-overlap = 5  Is { $triangle } nowhere nearer?
painter-yes = yes
painter-no = no
painter-not-asked = not tested
painter-constraint = { $before } must be painted before { $after }.
painter-place = { $triangle } hides no part of those that are left: it is number { $place } of { $triangles }.
painter-cycle-first = There is a cycle: { $triangle } is waiting for itself.
painter-cycle-next = { $before } must be painted before { $triangle }.
painter-cycle-closes = { $before } must be painted before { $triangle }, and { $triangle } before { $first }: the cycle is closed.
painter-paint = { $triangle } is painted over everything: { $place } of { $triangles }.
painter-done = Done: { $pairs ->
    [one] one pair
   *[other] { $pairs } pairs
  } of { $triangles ->
    [one] one triangle
   *[other] { $triangles } triangles
  } { $pairs ->
    [one] was
   *[other] were
  } tested.
painter-done-cycle = No order is right: each of { $cycle } triangles must come before the next, and the last before the first.
painter-must = Must come before
painter-cycle = cycle
watch-pairs = pairs tested
watch-depth-extents = by depth
watch-screen-extents = by place on the screen
watch-behind-plane = by the other’s plane
watch-before-plane = by its own plane
watch-overlap = by overlap

## BSP trees

alg-bsp = BSP tree
code-bsp-node = build(list): node ← plane of the first triangle
words-bsp-node = The plane of the first triangle becomes a node.
code-bsp-ask = for each other T: in front, behind, or in the plane
words-bsp-ask = Every other triangle lies in front of the plane, behind it or in it.
code-bsp-cut = T on both sides: cut in two; then build(front), build(back)
words-bsp-cut = A triangle on both sides is cut in two. Then build the tree in front and the tree behind.
code-bsp-visit = walk(node): on which side is the eye?
words-bsp-visit = Walking the tree, find at each node on which side the eye is.
code-bsp-paint = walk(other side); paint node; walk(eye’s side)
words-bsp-paint = First comes the other side, then the node itself, then the eye’s side.
bsp-opening = { $triangles ->
    [one] One triangle becomes
   *[other] { $triangles } triangles become
  } a tree of planes, which is built once and walked for each position of the eye.
bsp-plane = plane of { $triangle }
bsp-eye = eye
bsp-node-root = The plane of { $triangle } is the first node.
bsp-node-front = The first triangle in front of { $parent } is { $triangle }: its plane is the next node.
bsp-node-back = The first triangle behind { $parent } is { $triangle }: its plane is the next node.
bsp-ask-front = { $piece } is in front of the plane of { $triangle }. Distances of its vertices:
bsp-ask-back = { $piece } is behind the plane of { $triangle }. Distances of its vertices:
bsp-ask-on = { $piece } is in the plane of { $triangle }. Distances of its vertices:
bsp-ask-cut = { $piece } is on both sides of the plane of { $triangle }: it is cut into { $first } and { $second }. Distances of its vertices:
option-side-front = { $piece } is in front of the plane of { $triangle }.
option-side-back = { $piece } is behind the plane of { $triangle }.
option-side-on = { $piece } is in the plane of { $triangle }.
option-side-cut = { $piece } is on both sides of the plane of { $triangle }: it is cut into { $first } and { $second }.
bsp-built = The tree is built. { $triangles ->
    [one] One triangle is
   *[other] { $triangles } triangles are
  } now { $pieces ->
    [one] one piece
   *[other] { $pieces } pieces
  } in { $nodes ->
    [one] one node.
   *[other] { $nodes } nodes.
  }
bsp-visit-front = The eye is in front of the plane of { $triangle }: first comes what is behind it, then { $triangle }, then what is in front.
bsp-visit-back = The eye is behind the plane of { $triangle }: first comes what is in front of it, then { $triangle }, then what is behind.
bsp-visit-on = The eye is in the plane of { $triangle } or looks along it: either side may come first.
bsp-paint = { $piece } is painted over everything: { $place } of { $pieces }.
bsp-done = Done: { $pieces ->
    [one] one piece
   *[other] { $pieces } pieces
  } painted from back to front, after { $nodes ->
    [one] one test.
   *[other] { $nodes } tests.
  }
bsp-tree = Tree: ← in front, behind →
bsp-before = in front
bsp-behind = behind
bsp-eye-before = eye in front
bsp-eye-behind = eye behind
bsp-eye-on = eye in it
watch-nodes = nodes
watch-pieces = pieces
watch-visited = visited
watch-painted = painted

## Occlusion queries

alg-occlusion = Occlusion query
code-occlusion-occluders = for each occluder: draw it
words-occlusion-occluders = Draw the objects that hide much of the picture.
code-occlusion-others = for each other P: if box(P) reaches the near plane: draw P
words-occlusion-others = Take the others one by one. If the box of one reaches the near plane, draw it without a query.
code-occlusion-ask = n ← pixels of box(P) where z_box ≤ z[pixel]
words-occlusion-ask = Count the pixels at which its box would be seen. Write nothing.
code-occlusion-skip = if n = 0: skip P
words-occlusion-skip = If there is none, skip the object.
code-occlusion-draw = otherwise draw P
words-occlusion-draw = Otherwise draw the object.
occlusion-opening = { $objects ->
    [one] One object
   *[other] { $objects } objects
  } on { $columns } × { $rows } pixels. A third of those in the picture, rounded up, is drawn first: those that cover the most pixels and so may hide the others: { $occluders }.
occlusion-none = none
occlusion-occluder = { $object } is an occluder, drawn without a query: { $triangles ->
    [one] one triangle,
   *[other] { $triangles } triangles,
  } { $writes ->
    [one] one fragment written.
   *[other] { $writes } fragments written.
  }
occlusion-seen = The box of { $object } covers { $asked ->
    [one] one pixel
   *[other] { $asked } pixels
  } and would be seen at { $passed }. Nothing is written.
occlusion-hidden = The box of { $object } covers { $asked ->
    [one] one pixel
   *[other] { $asked } pixels
  } and would be seen at none: something nearer is in front everywhere.
occlusion-beside = The box of { $object } covers no pixel.
occlusion-unasked = The box of { $object } reaches the near plane, which may cut away its front: no depths are compared.
occlusion-answer-seen = The box of { $object } would be seen.
occlusion-answer-hidden = The box of { $object } is hidden: something nearer is in front everywhere.
occlusion-skip = { $object } is skipped: { $triangles ->
    [one] its triangle is
   *[other] its { $triangles } triangles are
  } not drawn.
occlusion-draw = { $object } is drawn: { $triangles ->
    [one] one triangle,
   *[other] { $triangles } triangles,
  } { $writes ->
    [one] one fragment written.
   *[other] { $writes } fragments written.
  }
occlusion-in-vain = { $object } is drawn for nothing, { $triangles ->
    [one] one triangle.
   *[other] { $triangles } triangles.
  } Its box would be seen at { $passed ->
    [one] one pixel,
   *[other] { $passed } pixels,
  } { $object } itself at none. The query may keep a hidden object; it never drops a visible one.
occlusion-done = Done: { $drawn } drawn, { $skipped } skipped. { $spared } of { $triangles ->
    [one] one triangle is
   *[other] { $triangles } triangles are
  } spared, and the picture is the same as with all objects drawn.
occlusion-objects = objects
occlusion-asked = pixels of the box
occlusion-passed = seen
occlusion-drawn = drawn
occlusion-skipped = skipped
occlusion-is-occluder = occluder
watch-objects-drawn = objects drawn
watch-objects-skipped = objects skipped
watch-pixels-asked = pixels tested
watch-triangles-spared = triangles spared

## Whose a pixel is

owns-nothing = { $surface } covers no pixel of the raster.
owns-none = { $surface } covers { $covered ->
    [one] one pixel
   *[other] { $covered } pixels
  } and is seen at none: something else is in front everywhere.
owns-all = { $surface } covers { $covered ->
    [one] one pixel and is seen there.
   *[other] { $covered } pixels and is seen at all of them.
  }
owns-some = { $surface } covers { $covered ->
    [one] one pixel
   *[other] { $covered } pixels
  } and is seen at { $seen }; at { $hidden ->
    [one] one
   *[other] { $hidden }
  } something else is in front.

## What it costs

surface-costs-title = What it costs to find what is in front
surface-costs-about = Counted, not timed, on { $columns } × { $rows } pixels: streets of boxes, twelve triangles each.
surface-costs-triangles = Triangles
surface-costs-counts = Pairs, tests, fragments
surface-costs-pairs = Painter: { $count } pairs of { $triangles } triangles tested; they grow like n to the power { $exponent }.
surface-costs-questions = Ray casting: { $count } tests of a ray against one of { $triangles } triangles; they grow like n to the power { $exponent }.
surface-costs-fragments = Depth buffer: { $count } fragments of { $triangles } triangles; they grow like n to the power { $exponent }.
surface-costs-overdraw = Overdraw: { $fragments } fragments for { $pixels } pixels; each pixel is computed { $overdraw } times on average.
surface-costs-note = The exponents are the slopes of straight lines fitted to the logarithms. Pairs are counted only where there is an order; where there is none, the line has a gap.

## The raster's form

raster-title = Raster
raster-rows = Rows
raster-shuffle = Shuffle (0: not)
raster-pixel = Pixel (−1: all)
raster-steps = A step is
raster-steps-fragments = a fragment
raster-steps-spans = a row of a triangle
raster-steps-triangles = a triangle
raster-tones = Tones show
raster-tones-triangles = which triangle
raster-tones-counts = how often it is computed
raster-tones-brightness = the brightness
raster-tones-stored = the depth as stored
raster-tones-distance = the distance
raster-number = Depth
raster-reversed = Reversed: 1 means near
raster-cull = Leave out back faces
