### What is said where triangles in space are cut: plane by plane, as one polygon, before the divide.

## Methods

alg-plane-at-a-time = Plane at a time
alg-intersection-polygon = One polygon, a fan at the end
alg-textured-triangle = One polygon with a texture
alg-homogeneous-triangle = Triangle before the divide
alg-faulty-missed-edge = Wrong: with d₀ = 0 the triangle stays whole
alg-faulty-on-plane = Wrong: on the plane counts as outside
alg-faulty-kept-uv = Wrong: (u, v) is not interpolated
alg-undivided-texture = Wrong: a texture without the divide
alg-faulty-edge-by-edge = Wrong: edges clipped as lines
alg-faulty-all-sides = Wrong: all six sides clip
alg-faulty-divided-triangle = Wrong: the triangle is divided first

## Views

tri-list-in = List in
tri-list-out = List out
tri-list-given = Triangle
tri-list-left = What is left
tri-corners = vertices
tri-none = no triangle
tri-not-asked = not tested
tri-list-fan = Fan from V₀: { $vertices } − 2 = { $triangles ->
        [one] { $triangles } triangle
       *[other] { $triangles } triangles
    }
tally-triangles = triangles
tally-crossings = crossings
tally-one-polygon = one polygon
tally-one-by-one = triangle by triangle
tally-same = Both methods leave the same { $n ->
        [one] { $n } vertex
       *[other] { $n } vertices
    }, to { $decimals } decimals.

## One polygon

ip-opening = One polygon is clipped by { $planes ->
        [one] { $planes } plane
       *[other] { $planes } planes
    }: its list begins with the triangle’s { $n ->
        [one] { $n } vertex
       *[other] { $n } vertices
    }.
ip-plane = The { $plane } plane takes a list of { $n ->
        [one] { $n } vertex.
       *[other] { $n } vertices.
    }
ip-first-inside = { $vertex } is inside the { $plane } plane: it is put out.
ip-first-outside = { $vertex } is outside the { $plane } plane: it is not put out.
ip-touch = { $from } → { $to }: { $rule }. The end that lies on the plane is itself the crossing.
ip-in-out = { $from } → { $to }: in → out. Put out the crossing { $cut }.
ip-out-in = { $from } → { $to }: out → in. Put out the crossing { $cut }, then { $to }.
ip-closing-cross = The closing edge { $from } → { $to }: { $rule }. Put out only the crossing { $cut }.
ip-cross = { $from } → { $to } crosses the { $plane } plane at { $cut }.
ip-output = { $vertex } goes into the list out, which now has { $n ->
        [one] { $n } vertex.
       *[other] { $n } vertices.
    }
ip-pass-cuts = The { $plane } plane removes { $dropped } and adds { $cuts }: { $before } → { $after }.
ip-pass-drops = The { $plane } plane removes { $dropped }: { $before } → { $after }.
ip-pass-same = The { $plane } plane cuts nothing: { $before } → { $after }.
ip-pass-empty = The { $plane } plane leaves nothing: { $before } → { $after }.
ip-fan = Triangle { $n } of { $total } in the fan: { $corners }.
ip-done = Done: { $vertices ->
        [one] { $vertices } vertex
       *[other] { $vertices } vertices
    }, a fan of { $n ->
        [one] { $n } triangle
       *[other] { $n } triangles
    }. Crossings computed: { $crossings }.
ip-done-empty = Done: nothing with an area is left. Triangles: { $n }, vertices: { $vertices }, crossings computed: { $crossings }.
code-ip-each = for each plane (n, D):
code-ip-first = if d(V₀) ≥ 0: put out V₀
code-ip-distance = for each edge S → P: d ← n·P + D
code-ip-inside = if d ≥ 0 and P ≠ V₀: put out P
code-ip-cross = where the sides differ: put out C
code-ip-pass = list ← what was put out
code-ip-fan = triangles ← fan of the list
words-ip-each = Test each plane in turn; its normal points inside.
words-ip-first = The first vertex is put out if it is inside; the border counts as inside.
words-ip-distance = Follow the edges, the last one back to V₀. Compute the signed distance of each end.
words-ip-inside = Then the end is put out if it is inside; V₀ is already in the list.
words-ip-cross = Where an edge goes from one side to the other, its crossing is put out: t = d₁ / (d₁ − d₂).
words-ip-pass = What was put out is the list for the next plane.
words-ip-fan = The convex polygon is divided into triangles only once, at the end.

## Triangle by triangle

pat-opening = Each triangle is clipped by { $planes ->
        [one] { $planes } plane
       *[other] { $planes } planes
    } in turn: the list begins with { $n ->
        [one] { $n } triangle.
       *[other] { $n } triangles.
    }
pat-plane =
    { $n ->
        [one] The { $plane } plane takes { $n } triangle.
       *[other] The { $plane } plane takes { $n } triangles.
    }
pat-three = { $triangle }: { $inside } vertices are inside the { $plane } plane. It is kept whole.
pat-two = { $triangle }: { $inside } vertices are inside the { $plane } plane. A quadrilateral is left: two triangles.
pat-one = { $triangle }: { $inside } vertex is inside the { $plane } plane. One triangle is left.
pat-on = { $triangle }: { $inside } of 3 vertices are inside the { $plane } plane. On the plane: { $on }.
pat-none = { $triangle }: { $inside } vertices are inside the { $plane } plane. It is dropped.
pat-option-three = All three vertices of { $triangle } are inside.
pat-option-two = Two vertices of { $triangle } are inside.
pat-option-one = One vertex of { $triangle } is inside.
pat-option-none = No vertex of { $triangle } is inside.
pat-piece = Triangle { $n } of the list out: { $corners }.
pat-pass =
    { $after ->
        [one] The { $plane } plane took { $before } and hands on { $after } triangle.
       *[other] The { $plane } plane took { $before } and hands on { $after } triangles.
    }
pat-pass-empty = The { $plane } plane took { $before } and hands on { $after }: nothing is left.
pat-done = Done: { $n ->
        [one] { $n } triangle is
       *[other] { $n } triangles are
    } left, after { $crossings ->
        [one] { $crossings } crossing.
       *[other] { $crossings } crossings.
    }
pat-done-empty = Done: { $n ->
        [one] { $n } triangle is
       *[other] { $n } triangles are
    } left, after { $crossings ->
        [one] { $crossings } crossing.
       *[other] { $crossings } crossings.
    }
code-pat-each = for each plane (n, D):
code-pat-triangle = for each triangle: count d ≥ 0
code-pat-three = 3: keep it
code-pat-two = 2: cut; two triangles
code-pat-one = 1: cut; one triangle
code-pat-none = 0: drop it
code-pat-pass = list ← what was kept
words-pat-each = Test each plane in turn; its normal points inside.
words-pat-triangle = How many vertices of a triangle are inside?
words-pat-three = If all three are inside, the triangle is kept whole.
words-pat-two = If two are inside, a quadrilateral is left; it is split from its first vertex.
words-pat-one = If one is inside, a smaller triangle is left.
words-pat-none = If none is inside, the triangle is dropped.
words-pat-pass = The triangles kept are the list for the next plane.

## Before the divide

ht-opening = Of { $n } vertices in clip space { $behind ->
        [one] { $behind } has
       *[other] { $behind } have
    } w ≤ 0: nothing is divided yet.
ht-divide = All { $n } vertices are divided by their w.
ht-codes-outside = All vertices are beyond the same side: rejected without clipping; sides with a bit set: { $sides }.
ht-codes-inside = No vertex is beyond any side: the triangle is kept whole; sides with a bit set: { $sides }.
ht-codes-cut =
    { $sides ->
        [one] Only { $sides } of the six sides has a bit set: only this side clips.
       *[other] Only { $sides } of the six sides have a bit set: only these sides clip.
    }
ht-side = The { $side } side takes { $n ->
        [one] { $n } vertex:
       *[other] { $n } vertices:
    } it needs only the sign of a sum, no division.
ht-inside = { $vertex } is inside the { $side } side.
ht-outside = { $vertex } is outside the { $side } side.
ht-cross = { $from } → { $to } crosses the { $side } side at I.
ht-pass = The { $side } side is done: { $before } → { $n }.
ht-done = { $n ->
        [one] { $n } vertex is
       *[other] { $n } vertices are
    } left, a fan of { $triangles ->
        [one] { $triangles } triangle
       *[other] { $triangles } triangles
    }: now the vertices can be divided by w.
ht-done-empty = Nothing with an area is left. Vertices: { $n }, triangles: { $triangles }.
code-ht-codes = six bits a vertex: w ± x, y, z < 0
code-ht-decide = OR = 0: keep; AND ≠ 0: reject
code-ht-each = for each side with a bit in the OR:
code-ht-first = if w ± x ≥ 0 at V₀: put out V₀
code-ht-bound = for each edge S → P: w ± x of P
code-ht-cross = where the sign changes: put out I
code-ht-inside = if w ± x ≥ 0 and P ≠ V₀: put out P
code-ht-fan = fan, then divide by w
words-ht-codes = Give each vertex a bit for each side of −w ≤ x, y, z ≤ w that it lies beyond.
words-ht-decide = Either there is nothing to clip, or there is nothing to see.
words-ht-each = Only sides that some vertex lies beyond need to be tested.
words-ht-bound = The test is the sign of a sum: it needs no division, and w may have any sign.
words-ht-cross = All four coordinates are interpolated with the same t.
words-ht-fan = What is left has w ≥ near > 0 and can be divided by w.

## What is wrong here?

faulty-missed-edge-differs = Step { $step } is the first that differs: with d₀ = 0 neither product is negative, so the triangle was kept whole.
faulty-on-plane-differs = Step { $step } is the first that differs: a vertex on the plane was taken for outside.
faulty-kept-uv-differs = Step { $step } is the first that differs: the crossing kept the (u, v) of the outer vertex.
faulty-edge-by-edge-differs = Step { $step } is the first that differs: each edge is clipped on its own, not as a part of the outline.
faulty-all-sides-differs = Step { $step } is the first that differs: a side that has no bit set is tested, and it cuts nothing.
faulty-divided-triangle-differs = Step { $step } is the first that differs: the vertices were divided by w before anything was clipped.
code-faulty-missed-edge = if d₀·d₁ < 0 or d₀·d₂ < 0: cut
words-faulty-missed-edge = The triangle is cut only where the first distance and another one differ in sign.
code-faulty-on-plane = if d > 0 and P ≠ V₀: put out P
code-faulty-on-plane-first = if d(V₀) > 0: put out V₀
words-faulty-on-plane-first = The first vertex is put out if it is strictly inside.
words-faulty-on-plane = Then the end is put out if it is strictly inside.
code-faulty-kept-uv = put out C, uv(C) ← uv(V)
words-faulty-kept-uv = The crossing takes the (u, v) of the vertex that it replaces.
code-undivided-texture = fan, fill: uv linear on the screen
words-undivided-texture = The polygon is divided into a fan of triangles; on the screen (u, v) is interpolated without 1/w.
code-faulty-edge-by-edge = for each plane: clip each edge
words-faulty-edge-by-edge = Test each plane in turn; it clips the three edges as three lines.
code-faulty-all-sides = for each of the six sides:
words-faulty-all-sides = All six sides are tested, one after the other.
code-faulty-divided-triangle = (x, y, z) ← (x, y, z)/w, then six bits
words-faulty-divided-triangle = Every vertex is divided by its w before it is tested.

## Cases

object-triangle-uv = texture coordinates
case-triangles-left =
    { $triangles ->
        [one] { $triangles } triangle is left.
       *[other] { $triangles } triangles are left.
    }
case-triangles-none = Nothing with an area is left.
