### The lines lab: captions, watch table and controls.

## Said by several methods

line-opening = Which part of P₁P₂ lies in the window?
line-not-on-it = { $point }: not on P₁P₂
line-parallel = The segment is parallel to the { $edge }: there is no crossing.
line-reject-edge = Reject: both ends are beyond the { $edge }.
line-accept = Accept: visible from { $p1 } to { $p2 }.
line-touch = Accept: the segment touches the window at the one point { $at }.
line-point = Accept: both ends are the one point { $at }, and it lies in the window.
param-left = { $min } < { $max }: a part is left.
param-touch = { $min } = { $max }: a single point is left, and the border counts as inside.
param-empty = { $min } > { $max }: nothing is left.
param-put-end = { $end } = { $at } was inside and stays.
watch-crossings = crossings
watch-crossings-used = used
table-edge = edge
table-polygon-edge = edge
table-start = start
table-corner = corner

## Brute force

bf-intersect = Find the crossing with the line of the { $edge }.
bf-keep = No part is beyond the { $edge }: this crossing was not needed.
bf-keep-parallel = No part is beyond the { $edge }: this side changes nothing.
bf-cut = { $end } is beyond { $border }: it moves to { $to }.
bf-option-none = No part is beyond the { $edge }.
bf-option-one = One end is beyond the { $edge }.
bf-option-both = Both ends are beyond the { $edge }.
bf-note-tests = A point is inside if it passes all four tests.
bf-in-vain = not needed
bf-kept = { $part } of it is visible
code-bf-each = for each side, not parallel to P₁P₂
code-bf-intersect = X ← line P₁P₂ ∩ line of side
code-bf-reject = if both ends beyond it: reject
code-bf-cut = if one end beyond it: end ← X
code-bf-accept = accept P₁P₂
words-bf-each = Take the four sides in turn; skip a side that the segment runs parallel to.
words-bf-intersect = Find the crossing of the segment’s line with the side’s line.
words-bf-reject = If both ends are beyond the side, nothing is visible.
words-bf-cut = If one end is beyond the side, move that end to the crossing.
words-bf-accept = What is left is visible.

## Cohen–Sutherland

cs-code = { $end } is { $region }: { $code } = { $bits }.
cs-or-accept = OR = { $bits }: both ends are inside.
cs-or-open = OR = { $bits } ≠ 0000: not everything is inside.
cs-and-reject = AND = { $bits } ≠ 0000: both ends are beyond the { $edge }.
cs-and-open = AND = { $bits }: no side has both ends beyond it. The codes cannot decide.
cs-choose = The lowest bit that is set belongs to the { $edge }: { $end } is beyond it.
cs-cut = { $end } is cut off at { $border }.
cs-reject = Reject: both ends are { $region }; AND = { $and }.
cs-reject-two = Reject: both ends are outside the window.
cs-option-inside = Both ends are inside.
cs-option-not-inside = Not everything is inside.
cs-option-undecided = No side has both ends beyond it.
cs-option-beyond = Both ends are beyond one side.
cs-note-code = Each 1 stands for a side that the point is beyond.
cs-note-order = In the order top, bottom, right, left the code is { $other }.
cs-note-or = OR sets a bit that is set in either code.
cs-note-and = AND keeps only bits that are set in both codes.
cs-cuts = cut
cs-this-order = this order:
cs-usual-order = usual order:
code-cs-codes = code₁ ← code(P₁); code₂ ← code(P₂)
code-cs-loop = loop
code-cs-accept = if code₁ OR code₂ = 0: accept
code-cs-reject = if code₁ AND code₂ ≠ 0: reject
code-cs-choose = side ← lowest bit of code₁ OR code₂
code-cs-end = P ← the end whose code has this bit
code-cs-cut = P ← P₁P₂ ∩ side
code-cs-recode = code of P ← code(P)
words-cs-codes = Give each end a code: one bit for each side that the end is beyond.
words-cs-loop = Repeat:
words-cs-accept = If no bit is set in either code, everything that is left is visible.
words-cs-reject = If a bit is set in both codes, both ends are beyond the same side.
words-cs-choose = Otherwise take the side of the lowest bit that is set.
words-cs-end = Exactly one end is beyond it.
words-cs-cut = Move that end to where the segment crosses the side.
words-cs-recode = Give this end a new code.
alg-faulty-looks-once = Wrong: only one cut is made
faulty-looks-once-differs = Step { $step } is the first that differs: after one cut, the program accepts what is left, whatever the new code says.
code-faulty-looks-once = if cut once or code₁ OR code₂ = 0: accept
words-faulty-looks-once = If no bit is set in either code, or an end has been cut, everything that is left is visible.
alg-faulty-two-outside = Wrong: two ends outside are rejected
faulty-two-outside-differs = Step { $step } is the first that differs: neither code is 0, so the program rejects, though no side has both ends beyond it.
code-faulty-two-outside = if code₁ ≠ 0 and code₂ ≠ 0: reject
words-faulty-two-outside = If each code has a bit that is set, both ends are outside, and nothing is visible.
settings-bit-order = Bit order
bit-order-tbrl = top, bottom, right, left
bit-order-lrbt = left, right, bottom, top

## Liang–Barsky

lb-delta = P(u) = P₁ + u (P₂ − P₁): along the segment x and y change by Δx and Δy.
lb-row = k = { $k }, { $edge }: u · p ≤ q, { $direction }.
lb-parallel-inside = The segment is parallel to the { $edge } and inside it: this side alone decides nothing.
lb-parallel-outside = The segment is parallel to the { $edge } and outside it: no u is possible.
lb-parallel-forgotten = The segment is parallel to the { $edge }: the program goes on without a check.
lb-enter = The line enters through the { $edge }: u_min goes up.
lb-enter-idle = The line enters through the { $edge }, but not after u_min: no change.
lb-leave = The line leaves through the { $edge }: u_max goes down.
lb-leave-idle = The line leaves through the { $edge }, but not before u_max: no change.
lb-put = { $end } moves to u = { $u } on { $border }.
lb-reject = Reject at the { $edge }: nothing of the segment is left.
lb-note-enter = p < 0 means entering: { $bound } = max({ $bound }, r)
lb-note-leave = p > 0 means leaving: { $bound } = min({ $bound }, r)
lb-note-parallel = p = 0 means parallel: inside if q ≥ 0
code-lb-start = u_min ← 0; u_max ← 1; Δ ← P₂ − P₁
code-lb-each = for k = 1 … 4: p, q of side k
code-lb-parallel = if p = 0 and q < 0: reject
code-lb-enter = if p < 0: u_min ← max(u_min, q/p)
code-lb-leave = if p > 0: u_max ← min(u_max, q/p)
code-lb-empty = if u_min > u_max: reject
code-lb-accept = accept P(u_min) P(u_max)
words-lb-start = Start with the whole segment, u from 0 to 1.
words-lb-each = For each side, write “inside” as an inequality u · p ≤ q.
words-lb-parallel = p = 0: the segment is parallel to the side; if it is outside, reject it.
words-lb-enter = p < 0: the line enters here. No part before q/p can be visible.
words-lb-leave = p > 0: the line leaves here. No part after q/p can be visible.
words-lb-empty = If the interval is empty, nothing is visible.
words-lb-accept = Otherwise the ends of the interval are the ends of the visible part.
alg-faulty-parallel = Wrong: p = 0 is not checked
faulty-parallel-differs = Step { $step } is the first that differs: p = 0 and q < 0, so the segment is outside this side, but the program goes on.
code-faulty-parallel = if p = 0: next side
words-faulty-parallel = p = 0: the segment is parallel to the side; go on to the next side.

## Cyrus–Beck

cb-edge-entering = { $edge }: n·D > 0, the line enters.
cb-edge-leaving = { $edge }: n·D < 0, the line leaves.
cb-edge-parallel = { $edge }: n·D = 0, the line is parallel to it.
cb-parallel-inside = The segment is parallel to { $edge } and inside it: this edge alone decides nothing.
cb-parallel-outside = The segment is parallel to { $edge } and outside it: no t is possible.
cb-enter = The line enters through { $edge }: t_min goes up.
cb-enter-idle = The line enters through { $edge }, but not after t_min: no change.
cb-leave = The line leaves through { $edge }: t_max goes down.
cb-leave-idle = The line leaves through { $edge }, but not before t_max: no change.
cb-put = { $end } moves to t = { $t } on { $edge }.
cb-reject = Reject at { $edge }: nothing of the segment is left.
cb-sign-enters = { $product } > 0: the line enters
cb-sign-leaves = { $product } < 0: the line leaves
cb-sign-parallel = { $product } = 0: the line is parallel
cb-sign-inside = { $product } > 0: { $end } is inside
cb-sign-on = { $product } = 0: { $end } is on the edge
cb-sign-outside = { $product } < 0: { $end } is outside
cb-measured = Measured along { $normal }, from the edge
alg-faulty-normals = Wrong: all normals point outside
faulty-normals-differs = Step { $step } is the first that differs: the normal points outside, so entering is taken for leaving.
code-cb-start = t_min ← 0; t_max ← 1; D ← P₂ − P₁
code-cb-each = for each edge: n; w ← P₁ − E
code-cb-parallel = if n·D = 0 and n·w < 0: reject
code-cb-enter = if n·D > 0: t_min ← max(t_min, −n·w / n·D)
code-cb-leave = if n·D < 0: t_max ← min(t_max, −n·w / n·D)
code-cb-empty = if t_min > t_max: reject
code-cb-accept = accept P(t_min) P(t_max)
words-faulty-normals = For each edge, turn it to the left to get its normal, whichever way the vertices run.
words-cb-start = Start with the whole segment, t from 0 to 1.
words-cb-each = For each edge, take its normal, which points inside.
words-cb-parallel = n·D = 0: the segment is parallel to the edge; if it is outside, reject it.
words-cb-enter = n·D > 0: the line runs along the normal, so it enters here.
words-cb-leave = n·D < 0: the line runs against the normal, so it leaves here.
words-cb-empty = If the interval is empty, nothing is visible.
words-cb-accept = Otherwise the ends of the interval are the ends of the visible part.

## Nicholl–Lee–Nicholl

nln-region = { $end } is { $region }.
nln-option-region = { $end } is { $option }.
nln-side-enters = P₂ is { $turn } of the line from P₁ through { $corner }: the { $first } is crossed first.
nln-side-meets = P₂ is { $turn } of the line from P₁ through { $corner }: the { $first } is crossed first.
nln-side-leaves = P₂ is { $turn } of the line from P₁ through { $corner }: the segment leaves through the { $first }.
nln-side-through = P₂ is on the line from P₁ through { $corner }: both sides are crossed at once.
nln-option-side = The line from P₁ through { $corner }: P₂ is { $option }.
nln-miss = Reject: the segment passes outside { $corner }, beyond the { $edge }.
nln-sector-inside = Both ends are inside: no crossing is needed.
nln-sector-enters = The segment enters through the { $enters }, and P₂ is inside: one crossing.
nln-sector-leaves = P₁ is inside; the segment leaves through the { $leaves }: one crossing.
nln-sector-both = The segment enters through the { $enters } and leaves through the { $leaves }: two crossings, both used.
nln-question-enters = in by which side
nln-question-meets = in at all
nln-question-leaves = out by which side
nln-note-products = From the corner: P₁ = (a₁, b₁), P₂ = (a₂, b₂)
turn-left = left
turn-through = on it
turn-right = right
watch-region-1 = region of P₁
watch-region-2 = region of P₂
watch-enters = in by
watch-leaves = out by
code-nln-regions = region of P₁, region of P₂
code-nln-shared = if both are beyond one side: reject
code-nln-enters = P₁ beyond two: its corner’s line → in by
code-nln-meets = P₂ beyond the next side: if past C: reject
code-nln-leaves = P₂ beyond two: its corner’s line → out by
code-nln-cut = P₁, P₂ ← the one or two crossings found
words-nln-regions = Find the region of each end.
words-nln-shared = If both ends are beyond the same side, nothing is visible.
words-nln-enters = If P₁ is in a corner region, the line through that corner tells through which side the segment enters.
words-nln-meets = If P₂ is beyond a neighbouring side, the line through their common corner tells whether the segment meets the window at all.
words-nln-leaves = If P₂ is in a corner region, the line through that corner tells through which side the segment leaves.
words-nln-cut = Compute only those crossings.

## Handles, by name

handle-end = { $end }
handle-segment = the segment
handle-window = the window
handle-side = the { $edge }
handle-corner-bottom-left = the bottom left corner
handle-corner-bottom-right = the bottom right corner
handle-corner-top-left = the top left corner
handle-corner-top-right = the top right corner
handle-vertex = vertex { $number }

## The scene

action-add-segment = Add a segment
action-remove-segment = Remove the segment
batch-title = Random segments
batch-count = How many
batch-seed = Seed
batch-again = Another set, from the next seed
batch-make = Replace all segments

## Costs, measured

cost-measure = Measure on this machine…
cost-of-all-segments = all { $count ->
        [one] { $count } segment
       *[other] { $count } segments
    }: divisions { $divisions }, multiplications { $multiplications }, additions { $additions }, comparisons { $comparisons }
measure-title = What a segment costs
measure-about = Every method clips the same random segments, here and now.
measure-start = Measure
measure-again = Measure again
measure-nanos = Nanoseconds
measure-operations = Operations
measure-batch = Batch, branch-free
measure-note = The numbers are for one segment, on average over { $count }. The time is that of the fastest of five passes.

## The verdict

verdict-part-dropped = From { $from } to { $to } this step cuts the segment away.
verdict-line-between = The line enters ({ $enters }) only after it has left ({ $leaves }).
verdict-line-in = Moved { $move } inwards, at right angles to the border ({ $edge }), the segment would be visible.
verdict-line-back = Moved { $move } outwards, at right angles to the border ({ $edge }), the segment would be visible.
verdict-line-never = No move at right angles to the border ({ $edge }) would make the segment visible.
verdict-line-out = Moved outwards by more than { $move }, at right angles to the nearest border ({ $edge }), the segment would disappear.
verdict-line-touch = The segment only touches the border ({ $edge }): moved outwards by any amount, it would disappear.
