# The polygons lab.

handle-clip-vertex = vertex { $number } of the clip polygon
handle-hole-vertex = vertex { $number } of hole { $hole }
handle-polygon = the polygon
texture-title = Texture
texture-none = none
texture-interpolated = interpolated with t
texture-kept = not interpolated (wrong)
part-subject = the subject polygon
part-hole = a hole
part-clip = the clip polygon
refused-not-convex = This algorithm needs a convex clip region: { $part } turns the wrong way at { $vertex }.
refused-winds-twice = This algorithm needs a simple outline: { $part } runs around more than once by { $vertex }.
refused-degenerate = Nothing to clip: { $part } has no area.

## Sutherland–Hodgman

alg-sutherland-hodgman = Sutherland–Hodgman
alg-sutherland-hodgman-pipeline = Sutherland–Hodgman, as a pipeline
rule-in-in = in → in
rule-in-out = in → out
rule-out-in = out → in
rule-out-out = out → out
sh-inside = inside
sh-outside = outside
sh-bridge = bridge
sh-opening = Clip the whole polygon, { $n } vertices, against one edge of the region after the other: { $edges } edges.
sh-edge-side = Clip against the { $edge }: inside is { $inside }.
sh-edge = Clip against { $edge }: inside is { $inside }.
sh-first-inside = The first vertex { $vertex } is inside: it is put out.
sh-first-outside = The first vertex { $vertex } is outside: nothing is put out.
sh-in-in = { $from } → { $to }: in → in. Put out { $to }.
sh-in-out = { $from } → { $to }: in → out. Put out the crossing I.
sh-in-out-touch = { $from } → { $to }: in → out. { $from } lies on the edge and is the crossing itself: it stands in the list already.
sh-out-in = { $from } → { $to }: out → in. Put out the crossing I, then { $to }.
sh-out-in-touch = { $from } → { $to }: out → in. { $to } lies on the edge and is the crossing itself: put it out once.
sh-out-out = { $from } → { $to }: out → out. Put out nothing.
sh-closing-cross = The closing edge { $from } → { $to }: { $rule }. Put out only the crossing I.
sh-closing = The closing edge { $from } → { $to }: { $rule }. Nothing more is put out.
sh-cross = { $from } → { $to } crosses { $border } at I.
sh-output = { $vertex } goes into the output list as { $place }.
sh-pass = { $border } is done: the output list, of length { $n }, is the next input list.
sh-pass-empty = { $border } is done: the output list has length { $n }. Nothing is left to clip.
sh-done-empty = Done: nothing of the polygon lies in the region. Length of the last list: { $n }; clip edges: { $edges }.
sh-done-whole = Done: all { $n } vertices are inside all { $edges } edges. The polygon stays as it was.
sh-done-cut = Done after { $edges } edges: one ring of { $n } vertices is left.
sh-done-degenerate = Done after { $edges } edges: what is left has no area. Length of the last list: { $n }.
code-sh-each = for each clip edge: output ← empty
code-sh-first = F ← first vertex; if inside: put out F
code-sh-edges = for each edge S → P, last of all to F:
code-sh-in-in = in → in: put out P
code-sh-in-out = in → out: put out I
code-sh-out-in = out → in: put out I, P
code-sh-out-out = out → out: put out nothing
code-sh-pass = input ← output
words-sh-each = Take the edges of the clip region in turn, each with an empty output list.
words-sh-first = Put out the first vertex if it is inside.
words-sh-edges = Then follow the outline, edge by edge, and close it; at the closing edge F is not put out again.
words-sh-in-in = The edge stays inside: put out where it ends.
words-sh-in-out = The edge leaves: put out where it crosses.
words-sh-out-in = The edge comes in: put out where it crosses, then where it ends.
words-sh-out-out = The edge stays outside: put out nothing.
words-sh-pass = What was put out is the polygon for the next clip edge; after the last one, the answer.

## Sutherland–Hodgman as a pipeline

pipe-opening = All { $edges } clippers at once: the { $n } vertices flow through them one by one.
pipe-send = { $vertex } = { $at } of the polygon goes into the first clipper, { $border }.
pipe-enter = { $vertex } = { $at } flows on into the next clipper, { $border }.
pipe-first-inside = The first vertex to reach the clipper { $border }: it is kept as F, and flows on, as it is inside.
pipe-first-outside = The first vertex to reach the clipper { $border }: it is kept as F, and goes no further, as it is outside.
pipe-vertex = S → P: { $rule }. P flows on.
pipe-crossing = S → P: { $rule }. The crossing I flows on.
pipe-both = S → P: { $rule }. The crossing I flows on, then P.
pipe-nothing = S → P: { $rule }. No crossing, and P stays behind.
pipe-closing-cross = The closing edge S → F: { $rule }. The crossing I flows on.
pipe-closing = The closing edge S → F: { $rule }. Nothing flows on.
pipe-cross = S and the vertex after it lie on either side of { $border }: the edge crosses at I.
pipe-output = { $at } leaves the last clipper: it is { $vertex } of the ring, for good.
pipe-close = No more vertices will come to the clipper { $border }: it closes its ring.
pipe-close-empty = No vertex has come to the clipper { $border }: there is nothing to close.
pipe-closed = closed
code-pipe-send = for each vertex: send it to clipper 1
code-pipe-enter = clipper k, when P comes:
code-pipe-first = the first time: F ← P
code-pipe-cross = else if SP crosses: send I to clipper k + 1
code-pipe-pass-on = S ← P; if P is inside: send P to clipper k + 1
code-pipe-output = what leaves the last clipper joins the ring
code-pipe-close = close clippers 1, 2, …: if SF crosses, send I on
words-pipe-send = The polygon’s vertices go in one by one.
words-pipe-enter = A clipper knows two vertices only: F, its first, and S, the one before.
words-pipe-first = It keeps the first vertex that comes.
words-pipe-cross = If the edge from S crosses the border, the crossing goes on first.
words-pipe-pass-on = The vertex is remembered as S, and goes on if it is inside.
words-pipe-output = Behind the last clipper, a vertex belongs to the answer.
words-pipe-close = At the end each clipper in turn looks at the edge from its last vertex back to F.

## Sutherland–Hodgman, wrong on purpose

alg-faulty-on-border = Wrong: the border counts as outside
alg-faulty-open = Wrong: the closing edge is left out
alg-faulty-clockwise = Wrong: the clip edges are walked clockwise
alg-faulty-twice = Wrong: crossings are put out twice
alg-faulty-end-first = Wrong: the end comes before the crossing
faulty-on-border-differs = Step { $step } is the first that differs: a vertex on the border is taken for outside.
faulty-open-differs = Step { $step } is the first that differs: the closing edge, from the last vertex to the first, is never looked at.
faulty-clockwise-differs = Step { $step } is the first that differs: the clip edges are walked clockwise, and the wrong side of each is taken for the inside.
faulty-twice-differs = Step { $step } is the first that differs: the same crossing is put out a second time.
faulty-end-first-differs = Step { $step } is the first that differs: the edge comes in, and its end is put out before its crossing.
