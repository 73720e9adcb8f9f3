### What is said where triangles in space are cut: plane by plane, as one polygon, before the divide.

## Methods

alg-plane-at-a-time = Plane at a time
alg-intersection-polygon = One polygon, fanned at the end
alg-textured-triangle = One polygon with a texture
alg-homogeneous-triangle = Triangle before the divide
alg-faulty-missed-edge = Wrong: with d₀ = 0 the triangle stays whole
alg-faulty-on-plane = Wrong: on the plane is outside
alg-faulty-kept-uv = Wrong: (u, v) is not mixed
alg-undivided-texture = Wrong: a texture without the divide
alg-faulty-edge-by-edge = Wrong: three clipped edges
alg-faulty-all-sides = Wrong: all six sides in a row
alg-faulty-divided-triangle = Wrong: the triangle is divided first

## Views

tri-list-in = List in
tri-list-out = List out
tri-list-given = Triangle
tri-list-left = What is left
tri-corners = corners
tri-none = no triangle
tri-not-asked = not asked
tri-list-fan = Fan from V₀: { $vertices } − 2 = { $triangles ->
        [one] { $triangles } triangle
       *[other] { $triangles } triangles
    }
tally-triangles = triangles
tally-crossings = crossings
tally-one-polygon = one polygon
tally-one-by-one = triangle by triangle
tally-same = Both methods leave the same { $n } corners, to { $decimals } decimals.

## One polygon

ip-opening = One polygon against { $planes ->
        [one] { $planes } plane
       *[other] { $planes } planes
    }: its list begins with the triangle’s { $n } corners.
ip-plane = The { $plane } plane takes a list of { $n } vertices.
ip-first-inside = { $vertex } is inside the { $plane } plane: it is put out.
ip-first-outside = { $vertex } is outside the { $plane } plane: it is not put out.
ip-touch = { $from } → { $to }: { $rule }. The end on the plane is the crossing itself.
ip-in-out = { $from } → { $to }: in → out. Put out the crossing { $cut }.
ip-out-in = { $from } → { $to }: out → in. Put out the crossing { $cut }, then { $to }.
ip-closing-cross = The closing edge { $from } → { $to }: { $rule }. Put out only the crossing { $cut }.
ip-cross = { $from } → { $to } crosses the { $plane } plane in { $cut }.
ip-output = { $vertex } goes into the list out, which has { $n } now.
ip-pass-cuts = The { $plane } plane drops { $dropped } and puts in { $cuts }: { $before } → { $after }.
ip-pass-drops = The { $plane } plane drops { $dropped }: { $before } → { $after }.
ip-pass-same = The { $plane } plane cuts nothing: { $before } → { $after }.
ip-pass-empty = The { $plane } plane leaves nothing: { $before } → { $after }.
ip-fan = Triangle { $n } of { $total } in the fan: { $corners }.
ip-done = Done: { $vertices ->
        [one] { $vertices } vertex
       *[other] { $vertices } vertices
    }, a fan of { $n ->
        [one] { $n } triangle
       *[other] { $n } triangles
    }, after { $crossings ->
        [one] { $crossings } crossing
       *[other] { $crossings } crossings
    }.
ip-done-empty = Done: { $n } triangles. Nothing with an area is left ({ $vertices } vertices, { $crossings } crossings).
code-ip-each = for each plane (n, D):
code-ip-first = if d(V₀) ≥ 0: put out V₀
code-ip-distance = for each edge S → P: d ← n·P + D
code-ip-inside = if d ≥ 0 and P ≠ V₀: put out P
code-ip-cross = where the sides differ: put out C
code-ip-pass = list ← what was put out
code-ip-fan = triangles ← fan of the list
words-ip-each = Ask each plane in turn; its normal points inside.
words-ip-first = The first vertex is put out if it is inside; on the border is inside.
words-ip-distance = Follow the edges, the last one back to V₀: the signed distance of each end.
words-ip-inside = Then the end is put out if it is inside; V₀ stands in the list already.
words-ip-cross = Where an edge changes sides, its crossing is put out: t = d₁ / (d₁ − d₂).
words-ip-pass = What was put out is the next plane’s list.
words-ip-fan = One convex polygon is cut into triangles once, at the end.

## Triangle by triangle

pat-opening = Triangle by triangle against { $planes ->
        [one] { $planes } plane
       *[other] { $planes } planes
    }: the list begins with { $n } triangle.
pat-plane =
    { $n ->
        [one] The { $plane } plane takes { $n } triangle.
       *[other] The { $plane } plane takes { $n } triangles.
    }
pat-three = { $triangle }: { $inside } corners inside the { $plane } plane. Kept whole.
pat-two = { $triangle }: { $inside } corners inside the { $plane } plane. A quadrilateral is left, two triangles.
pat-one = { $triangle }: { $inside } corner inside the { $plane } plane. One triangle is left.
pat-on = { $triangle }: { $inside } of 3 corners inside the { $plane } plane, { $on } of them on it.
pat-none = { $triangle }: { $inside } corners inside the { $plane } plane. Dropped.
pat-option-three = All three corners of { $triangle } are inside.
pat-option-two = Two corners of { $triangle } are inside.
pat-option-one = One corner of { $triangle } is inside.
pat-option-none = No corner of { $triangle } is inside.
pat-piece = Piece { $n } of the list out: { $corners }.
pat-pass =
    { $after ->
        [one] The { $plane } plane took { $before } and hands on { $after } triangle.
       *[other] The { $plane } plane took { $before } and hands on { $after } triangles.
    }
pat-pass-empty = The { $plane } plane took { $before } and hands on { $after }: nothing is left.
pat-done =
    { $n ->
        [one] Done: { $n } triangle is left, after { $crossings } crossings.
       *[other] Done: { $n } triangles are left, after { $crossings } crossings.
    }
pat-done-empty = Done: { $n ->
        [one] { $n } triangle
       *[other] { $n } triangles
    } are left, after { $crossings ->
        [one] { $crossings } crossing
       *[other] { $crossings } crossings
    }.
code-pat-each = for each plane (n, D):
code-pat-triangle = for each triangle: count d ≥ 0
code-pat-three = 3: keep it
code-pat-two = 2: cut; two triangles
code-pat-one = 1: cut; one triangle
code-pat-none = 0: drop it
code-pat-pass = list ← what was kept
words-pat-each = Ask each plane in turn; its normal points inside.
words-pat-triangle = How many corners of a triangle are inside?
words-pat-three = All three: it is kept whole.
words-pat-two = Two: a quadrilateral is left, split at its first vertex.
words-pat-one = One: a smaller triangle is left.
words-pat-none = None: it is dropped.
words-pat-pass = What was kept is the next plane’s list.

## Before the divide

ht-opening = { $n } corners in clip space, { $behind } of them with w ≤ 0: nothing is divided yet.
ht-divide = All { $n } corners are divided by their w.
ht-codes-outside = All corners lie beyond one side: rejected without a cut, { $sides } sides named.
ht-codes-inside = No corner lies beyond any side: kept whole, { $sides } sides named.
ht-codes-cut =
    { $sides ->
        [one] Only { $sides } side of six is named: that one clips.
       *[other] Only { $sides } sides of six are named: those clip.
    }
ht-side = The { $side } side takes { $n } vertices: one bound, no division.
ht-inside = { $vertex } is inside the { $side } side.
ht-outside = { $vertex } is outside the { $side } side.
ht-cross = { $from } → { $to } crosses the { $side } side in I.
ht-pass = The { $side } side is done: { $before } → { $n }.
ht-done = { $n ->
        [one] { $n } vertex
       *[other] { $n } vertices
    } are left, a fan of { $triangles ->
        [one] { $triangles } triangle
       *[other] { $triangles } triangles
    }: now they can be divided.
ht-done-empty = Nothing with an area is left: { $n } vertices, { $triangles } triangles.
code-ht-codes = six bits a corner: w ± x, y, z < 0
code-ht-decide = OR = 0: keep; AND ≠ 0: reject
code-ht-each = for each side that the OR names:
code-ht-first = if w ± x ≥ 0 at V₀: put out V₀
code-ht-bound = for each edge S → P: w ± x of P
code-ht-cross = where it changes sign: put out I
code-ht-inside = if w ± x ≥ 0 and P ≠ V₀: put out P
code-ht-fan = fan, then divide by w
words-ht-codes = A bit for each side of −w ≤ x, y, z ≤ w that a corner lies beyond.
words-ht-decide = Nothing to clip, or nothing to see.
words-ht-each = Only sides that some corner lies beyond need be asked.
words-ht-bound = The bound is a sum: no division, and any sign of w.
words-ht-cross = All four coordinates are mixed by the same t.
words-ht-fan = What is left has w ≥ near > 0, and can be divided.

## What is wrong here?

faulty-missed-edge-differs = Step { $step } is the first that differs: with d₀ = 0 neither product is negative, and the triangle was kept whole.
faulty-on-plane-differs = Step { $step } is the first that differs: a vertex on the plane was taken for outside.
faulty-kept-uv-differs = Step { $step } is the first that differs: the crossing kept the (u, v) of the vertex outside.
faulty-edge-by-edge-differs = Step { $step } is the first that differs: the edges are clipped each by itself, not as a ring.
faulty-all-sides-differs = Step { $step } is the first that differs: a side that no outcode names is asked, and cuts nothing.
faulty-divided-triangle-differs = Step { $step } is the first that differs: corners with w < 0 were divided before anything was clipped.
code-faulty-missed-edge = if d₀·d₁ < 0 or d₀·d₂ < 0: cut
words-faulty-missed-edge = It is cut where the first distance and another differ in sign.
code-faulty-on-plane = if d > 0 and P ≠ V₀: put out P
code-faulty-on-plane-first = if d(V₀) > 0: put out V₀
words-faulty-on-plane-first = The first vertex is put out if it is strictly inside.
words-faulty-on-plane = Then the end is put out if it is strictly inside.
code-faulty-kept-uv = put out C, uv(C) ← uv(V)
words-faulty-kept-uv = The crossing takes the (u, v) of the vertex that it stands for.
code-undivided-texture = fan, fill: uv even on the screen
words-undivided-texture = The polygon is fanned into triangles; on the screen (u, v) is mixed without 1/w.
code-faulty-edge-by-edge = for each plane: clip each edge
words-faulty-edge-by-edge = Ask each plane in turn; it clips the three edges as three lines.
code-faulty-all-sides = for each of the six sides:
words-faulty-all-sides = All six sides are asked, one after the other.
code-faulty-divided-triangle = (x, y, z) ← (x, y, z)/w, then six bits
words-faulty-divided-triangle = Every corner is divided by its w before it is looked at.

## Cases

object-triangle-uv = texture coordinates
case-triangles-left =
    { $triangles ->
        [one] { $triangles } triangle is left.
       *[other] { $triangles } triangles are left.
    }
case-triangles-none = Nothing with an area is left.
