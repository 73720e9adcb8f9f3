### What the surfaces lab says: which surface is in front, pixel by pixel.

alg-depth-buffer = Depth buffer
alg-faulty-depth-clear = Depth buffer, cleared to 0
alg-faulty-depth-compare = Depth buffer, comparison turned
alg-faulty-depth-always = Depth buffer, nothing compared
alg-faulty-depth-straight = Depth buffer, distance straight across the screen

## Pseudocode

code-depth-clear = picture ← background, z ← ∞
words-depth-clear = Clear the picture to the background and every depth to infinity.
code-depth-clear-reversed = picture ← background, z ← −∞
words-depth-clear-reversed = Clear the picture to the background and every depth to minus infinity: nothing is farther.
code-depth-triangle = for each triangle T
words-depth-triangle = Take the triangles, in any order.
code-depth-fragment = for each pixel in T: z_T ← depth of T there
words-depth-fragment = For each pixel whose middle the triangle covers, find its depth there.
code-depth-compare = if z_T < z[pixel]
words-depth-compare = Compare it with the depth that stands there.
code-depth-compare-reversed = if z_T > z[pixel]
code-depth-write = picture[pixel] ← T, z[pixel] ← z_T
words-depth-write = If it is less, write the triangle and its depth.
words-depth-write-reversed = If it is greater, write the triangle and its depth: 1 is near.
code-faulty-depth-clear = picture ← background, z ← 0
words-faulty-depth-clear = Clear every depth to 0, the depth of the near plane.
code-faulty-depth-clear-reversed = picture ← background, z ← 1
words-faulty-depth-clear-reversed = Clear every depth to 1, the depth of the near plane.
code-faulty-depth-compare = if z_T > z[pixel]
words-faulty-depth-compare = Write where the new depth is greater.
words-faulty-depth-compare-reversed = Write where the new depth is less, although 1 is near.
code-faulty-depth-always = always
words-faulty-depth-always = Do not compare at all.
code-faulty-depth-straight = for each pixel in T: z_T ← distance, straight across the screen
words-faulty-depth-straight = Interpolate the distance in view space straight across the screen, without the divide.
faulty-depth-clear-differs = Step { $step } is the first that differs: no depth is less than 0, so nothing will be written.
faulty-depth-compare-differs = Step { $step } is the first that differs: the farther one is written.
faulty-depth-always-differs = Step { $step } is the first that differs: it is written, although something nearer stands there.
faulty-depth-straight-differs = Step { $step } is the first that differs: this depth is not that of the surface, since distance is not linear over the screen.

## The depth buffer

depth-opening = { $triangles ->
    [one] One triangle
   *[other] { $triangles } triangles
  } on { $columns } × { $rows } pixels: { $pixels } depths, one for each pixel, of { $bits } bits each: { $bytes } bytes.
depth-clear = Cleared: none of the { $pixels } pixels has a triangle.
depth-triangle = { $triangle } comes, { $place } of { $triangles }.
depth-triangle-unseen = Nothing of { $triangle } is drawn: it lies outside of the volume, is edge-on, or shows its back.
depth-answer-drawn = { $triangle } is drawn.
depth-triangle-whole = { $triangle } is drawn: of { $fragments } fragments { $writes } are nearer than what stood there.
depth-span = Row { $row } of { $triangle }, columns { $first } to { $last }: of { $fragments } fragments { $writes } are written.
depth-fragment-first = Pixel { $at } is still empty: { $triangle } is written.
depth-fragment-kept = { $triangle } is nearer than { $other } at pixel { $at }: it is written.
depth-fragment-lost = { $triangle } is not nearer than { $other } at pixel { $at }: { $other } stays.
depth-fragment-tie = { $triangle } is as near as { $other } at pixel { $at }: { $other } came first and stays.
depth-fragment-lost-to-nothing = { $triangle } is not written at pixel { $at }, though nothing has been there.
depth-nothing = nothing
depth-done = Done: { $fragments ->
    [one] one fragment
   *[other] { $fragments } fragments
  }, { $writes } of them written, for { $pixels ->
    [one] one pixel
   *[other] { $pixels } pixels
  }. Average times each was computed:

## Views

raster-depth = Depth in thousandths
raster-depth-unit = Depth in units of { $unit }
raster-straight = Distance from near to far, in thousandths
raster-depth-steps = Depth in { $bits } bits: 0 to { $last }
raster-distance = Distance from the camera
raster-counts-none = Times each pixel is computed
raster-counts = Times computed: { $seen } seen, { $vain } in vain
raster-counts-before = Every face drawn: { $seen } seen, { $vain } in vain
raster-counts-after = Backs left out: { $seen } seen, { $vain } in vain
painter-depths = Distance of each triangle, from its nearest to its farthest vertex
asks-what = asks
asks-now = now
asks-so-far = so far
asks-done = done
asks-of = { $count } of { $all }
asks-ray-casting = each pixel: which triangle?
asks-depth-buffer = each triangle: which pixels?
asks-painter = each pair: which first?
raster-pairs = { $pairs } questions about pairs of { $triangles } triangles
raster-questions = { $questions } questions of { $pixels } rays
occlusion-triangles = Triangles of each object
scale-near = near { $value }
scale-far = { $value } far
raster-wrong = { $count ->
    [one] One pixel is wrong
   *[other] { $count } pixels are wrong
  }
depth-done-stored = Done: the depths of { $pixels ->
    [one] one pixel
   *[other] { $pixels } pixels
  } go from { $least } to { $most }.
depth-done-distance = Done: the distances of { $pixels ->
    [one] one pixel
   *[other] { $pixels } pixels
  } go from { $least } to { $most }.
depth-done-nothing = Done: of { $fragments } fragments none was written.
curve-whole = Depth over distance
curve-enlarged = Enlarged
curve-forward = Not reversed
curve-reversed = Reversed
curve-near = Near plane at { $near }
curve-step = one step: { $step }
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
story-tie = as near: lost
watch-triangle = triangle
watch-pixel = pixel
watch-fragments = fragments
watch-writes = written
watch-pixels = pixels

## Ray casting

alg-ray-casting = Ray casting
code-ray-pixel = for each pixel: ray o + t · r through its middle
words-ray-pixel = For each pixel take the ray from the eye through its middle.
code-ray-triangle = for each triangle T with plane n·p + d = 0
words-ray-triangle = Ask every triangle.
code-ray-parallel = if n·r = 0: no hit
words-ray-parallel = A ray that is parallel to the plane does not meet it.
code-ray-plane = t ← −(n·o + d) / (n·r)
words-ray-plane = Find where the ray meets the plane.
code-ray-range = if t < 1 or beyond far: no hit
words-ray-range = Behind the eye, in front of the near plane and beyond the far one nothing is seen.
code-ray-inside = if o + t · r in T: hit
words-ray-inside = If that point lies in the triangle, it is hit.
code-ray-nearest = picture[pixel] ← T of the smallest t
words-ray-nearest = The hit with the smallest t is seen.
ray-opening = { $rays ->
    [one] One ray
   *[other] { $rays } rays
  } for { $columns } × { $rows } pixels, each asks { $triangles ->
    [one] one triangle.
   *[other] { $triangles } triangles.
  }
ray-pixel = The ray through the middle of pixel { $at }: from the eye at t = 0, on the near plane at t = 1.
ray-hit-first = The ray meets { $triangle }: the nearest hit so far.
ray-hit-nearer = The ray meets { $triangle } before { $other } at t = { $t }: now the nearest.
ray-hit-farther = The ray meets { $triangle } too, behind { $other } at t = { $t }.
ray-answer-farther = The ray meets { $triangle } behind the nearest hit.
ray-says-culled = { $triangle } is not asked: it is edge-on, or shows its back.
ray-says-parallel = The ray is parallel to the plane of { $triangle }: n·r = 0, they never meet.
ray-says-behind = The plane of { $triangle } is met behind the eye: t < 0.
ray-says-before-near = { $triangle } is met before the near plane: t < 1.
ray-says-beyond-far = { $triangle } is met beyond the far plane.
ray-says-beside = The ray meets the plane of { $triangle } beside the triangle: no hit.
ray-seen = Pixel { $at } takes { $triangle }: the smallest t of { $hits ->
    [one] one hit.
   *[other] { $hits } hits.
  }
ray-seen-nothing = Pixel { $at } stays background: no triangle is hit.
ray-done = Done: { $rays ->
    [one] one ray, which
   *[other] { $rays } rays, each of which
  } asked { $triangles ->
    [one] one triangle
   *[other] { $triangles } triangles
  }.
ray-culled = not asked
ray-parallel = parallel
ray-behind = behind the eye
ray-before-near = before near
ray-beyond-far = beyond far
ray-beside = beside
ray-hit = behind
ray-nearest = nearest
ray-eye = eye
ray-raster = raster
raster-so-far = Picture so far
watch-hits = hits
watch-nearest = nearest
watch-asked = asked

## Painter's algorithm

alg-painter = Painter’s algorithm
alg-faulty-painter-nearest = Painter, sorted by the nearest vertex
alg-faulty-painter-keys = Painter, sorted and nothing else asked
code-paint-key = for each triangle T: key ← distance of its farthest vertex
words-paint-key = The key of a triangle is the distance of its farthest vertex.
code-paint-sort = sort by key, farthest first
words-paint-sort = Sort the triangles, the farthest first.
code-paint-ask = for each P in the list: may P come before all Q that are left?
words-paint-ask = Take the first that is left, and ask all others whether it may come before them.
code-paint-object = if P hides part of Q: Q must come before P
words-paint-object = If it hides part of one, that one must come first and asks in its turn.
code-paint-cycle = if Q waits for P: cycle
words-paint-cycle = If that one is waiting itself, there is no order.
code-paint-place = else P is next
words-paint-place = If nobody objects, it is the next.
code-paint-paint = paint all, in that order
words-paint-paint = Paint them in that order, each over what is there.
code-faulty-painter-nearest = for each triangle T: key ← its nearest z
words-faulty-painter-nearest = The key of a triangle is the distance of its nearest vertex.
code-faulty-painter-keys = for each P in the list: P is next
words-faulty-painter-keys = Take the list as it is sorted, and ask nobody.
faulty-painter-nearest-differs = Step { $step } is the first that differs: the key is the nearest vertex, not the farthest.
faulty-painter-keys-differs = Step { $step } is the first that differs: nobody is asked whether this one may come next.
surfaces-first = The first { $triangles } of { $all } triangles only: nobody could follow the steps of all.
refused-too-many-faces = Refused: the scene has { $triangles } triangles, and this method takes { $most } at most. Take objects out, or choose another method.
painter-opening = { $triangles ->
    [one] One triangle is
   *[other] { $triangles } triangles are
  } to be painted, the farthest first: what is painted later hides what is there.
painter-key = { $triangle } has the key { $key }. It lies between these distances:
painter-sort = { $triangle } is number { $place } in the list, farthest first.
painter-pair-depths = { $triangle } lies deeper than all of { $other }: it may come first.
painter-pair-screen = { $triangle } and { $other } are apart on the screen: either may come first.
painter-pair-behind = { $triangle } lies behind the plane of { $other }: it may come first.
painter-pair-before = { $other } lies before the plane of { $triangle }: { $triangle } may come first.
painter-pair-overlap = { $triangle } is nowhere nearer than { $other } on the screen: it may come first.
painter-pair-hides = { $triangle } hides a part of { $other }: it may not come first.
painter-ask-depths = 1  Is { $triangle } deeper than all of { $other }?
painter-ask-screen = 2  Are they apart on the screen?
painter-ask-behind = 3  Is { $triangle } behind the plane of { $other }?
painter-ask-before = 4  Is { $other } before the plane of { $triangle }?
painter-ask-overlap = 5  Is { $triangle } nowhere nearer?
painter-yes = yes
painter-no = no
painter-not-asked = not asked
painter-constraint = { $before } must be painted before { $after }.
painter-place = Nobody that is left objects to { $triangle }: it is number { $place } of { $triangles }.
painter-cycle-first = A cycle: { $triangle } is waiting for itself.
painter-cycle-next = { $before } must be painted before { $triangle }.
painter-cycle-closes = { $before } must be painted before { $triangle }, and { $triangle } before { $first }: the cycle is closed.
painter-paint = { $triangle } is painted over everything: { $place } of { $triangles }.
painter-done = Done: { $pairs ->
    [one] one pair
   *[other] { $pairs } pairs
  } of { $triangles } triangles { $pairs ->
    [one] was
   *[other] were
  } asked.
painter-done-cycle = No order exists: each of { $cycle } triangles must come before the next, and the last before the first.
painter-must = Must come before
painter-cycle = cycle
watch-pairs = pairs asked
watch-depth-extents = by depth
watch-screen-extents = by place on the screen
watch-behind-plane = by the other’s plane
watch-before-plane = by its own plane
watch-overlap = by overlap

## BSP trees

alg-bsp = BSP tree
code-bsp-node = build(list): node ← plane of the first triangle
words-bsp-node = The plane of the first triangle is a node.
code-bsp-ask = for each other T: to front, to back, or in the plane
words-bsp-ask = Every other one lies before it, behind it, or in it.
code-bsp-cut = T on both sides: cut in two; then build(front), build(back)
words-bsp-cut = One that lies on both sides is cut in two; then build what is before and what is behind.
code-bsp-visit = walk(node): on which side is the eye?
words-bsp-visit = Walking, ask at each node which side the eye is on.
code-bsp-paint = walk(other side); paint node; walk(eye’s side)
words-bsp-paint = First the other side, then the node itself, then the eye’s side.
bsp-opening = { $triangles ->
    [one] One triangle becomes
   *[other] { $triangles } triangles become
  } a tree of planes, built once, walked for every eye.
bsp-node-root = The plane of { $triangle } is the first node.
bsp-node-front = Of what lies before { $parent } the first is { $triangle }: its plane is the next node.
bsp-node-back = Of what lies behind { $parent } the first is { $triangle }: its plane is the next node.
bsp-ask-front = { $piece } lies before the plane of { $triangle }. Distances of its vertices:
bsp-ask-back = { $piece } lies behind the plane of { $triangle }. Distances of its vertices:
bsp-ask-on = { $piece } lies in the plane of { $triangle }. Distances of its vertices:
bsp-ask-cut = { $piece } lies on both sides of the plane of { $triangle }: it is cut into { $first } and { $second }. Distances of its vertices:
bsp-built = The tree is built: { $triangles } triangles are { $pieces } pieces in { $nodes } nodes.
bsp-visit-front = The eye is before the plane of { $triangle }: first what lies behind it, then { $triangle }, then what lies before it.
bsp-visit-back = The eye is behind the plane of { $triangle }: first what lies before it, then { $triangle }, then what lies behind it.
bsp-visit-on = The eye is in the plane of { $triangle }, or looks along it: either side may come first.
bsp-paint = { $piece } is painted over everything: { $place } of { $pieces }.
bsp-done = Done: { $pieces } pieces painted, back to front, by { $nodes } questions.
bsp-tree = Tree: ← before, behind →
bsp-before = before
bsp-behind = behind
bsp-eye-before = eye before
bsp-eye-behind = eye behind
bsp-eye-on = eye in it
watch-nodes = nodes
watch-pieces = pieces
watch-visited = visited
watch-painted = painted

## Occlusion queries

alg-occlusion = Occlusion query
code-occlusion-occluders = for each occluder: draw it
words-occlusion-occluders = Draw the objects that hide much.
code-occlusion-others = for each other object P, if box(P) reaches near: draw P
words-occlusion-others = Take the others one by one. One whose box reaches the near plane is drawn unasked.
code-occlusion-ask = n ← pixels of box(P) where z_box ≤ z[pixel]
words-occlusion-ask = Count the pixels at which its box would be seen. Nothing is written.
code-occlusion-skip = if n = 0: skip P
words-occlusion-skip = At none: skip it.
code-occlusion-draw = else draw P
words-occlusion-draw = Else draw it.
occlusion-opening = { $objects ->
    [one] One object
   *[other] { $objects } objects
  } on { $columns } × { $rows } pixels. Of those in the picture, the one third, rounded up, that covers the most pixels may hide the others and is drawn first: { $occluders }.
occlusion-none = none
occlusion-occluder = { $object } is an occluder, drawn unasked: { $triangles ->
    [one] one triangle,
   *[other] { $triangles } triangles,
  } { $writes ->
    [one] one fragment written.
   *[other] { $writes } fragments written.
  }
occlusion-seen = The box of { $object } covers { $asked ->
    [one] one pixel
   *[other] { $asked } pixels
  } and would be seen at { $passed } of them. Nothing is written.
occlusion-hidden = The box of { $object } would be seen at none of its { $asked ->
    [one] pixels, of which there is one:
   *[other] { $asked } pixels:
  } something nearer stands everywhere.
occlusion-beside = The box of { $object } covers no pixel.
occlusion-unasked = The box of { $object } reaches the near plane, which may cut its front away: nothing is compared.
occlusion-answer-seen = The box of { $object } would be seen.
occlusion-answer-hidden = The box of { $object } is hidden: something nearer stands everywhere.
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
occlusion-in-vain = { $object } is drawn in vain, { $triangles ->
    [one] one triangle:
   *[other] { $triangles } triangles:
  } its box would be seen at { $passed ->
    [one] one pixel,
   *[other] { $passed } pixels,
  } { $object } itself at none. A box may say too much, never too little.
occlusion-done = Done: { $drawn } drawn, { $skipped } skipped. { $spared } of { $triangles } triangles are spared, and the picture is as if all had been drawn.
occlusion-objects = objects
occlusion-asked = pixels of the box
occlusion-passed = seen
occlusion-drawn = drawn
occlusion-skipped = skipped
occlusion-is-occluder = occluder
watch-objects-drawn = objects drawn
watch-objects-skipped = objects skipped
watch-pixels-asked = pixels asked
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
owns-some = { $surface } covers { $covered } pixels and is seen at { $seen }; at { $hidden ->
    [one] one
   *[other] { $hidden }
  } something else is in front.

## What it costs

surface-costs-title = What it costs to find who is in front
surface-costs-about = Counted, not timed, on { $columns } × { $rows } pixels: streets of boxes, twelve triangles each.
surface-costs-triangles = Triangles
surface-costs-counts = Pairs, questions, fragments
surface-costs-pairs = Painter: { $count } pairs of { $triangles } triangles; they grow like n to the power { $exponent }.
surface-costs-questions = Ray casting: { $count } questions of rays to { $triangles } triangles; like n to the power { $exponent }.
surface-costs-fragments = Depth buffer: { $count } fragments of { $triangles } triangles; like n to the power { $exponent }.
surface-costs-overdraw = Overdraw: { $fragments } fragments for { $pixels } pixels, each computed { $overdraw } times.
surface-costs-note = Exponents are the slopes of straight lines fitted to the logarithms. Pairs are counted up to 1,000 triangles, and only where there is an order; beyond, the line ends.

## The raster's form

raster-title = Raster
raster-rows = Rows
raster-shuffle = Shuffle (0: not)
raster-pixel = Pixel (−1: all)
raster-steps = A step is
raster-steps-fragments = a fragment
raster-steps-spans = a row of a triangle
raster-steps-triangles = a triangle
raster-tones = Tones tell
raster-tones-triangles = which triangle
raster-tones-counts = how often computed
raster-tones-stored = the depth as stored
raster-tones-distance = its distance
raster-number = Depth
raster-reversed = Reversed: 1 is near
raster-cull = Leave out back faces
