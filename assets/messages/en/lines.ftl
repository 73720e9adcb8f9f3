### The lines lab: captions, watch table and controls.

## Said by several methods

line-opening = Which part of P₁P₂ lies in the window?
line-not-on-it = { $point }: not on P₁P₂
line-parallel = Parallel to the { $edge }: no crossing.
line-reject-edge = Reject: both ends lie beyond the { $edge }.
line-accept = Accept: visible from { $p1 } to { $p2 }.
line-touch = Accept: the segment touches the window in the one point { $at }.
line-point = Accept: both ends are the one point { $at }, and it lies in the window.
param-left = { $min } < { $max }: a part is left.
param-touch = { $min } = { $max }: a single point is left, and on the border is inside.
param-empty = { $min } > { $max }: nothing is left.
param-put-end = { $end } = { $at } was inside and stays.
watch-crossings = crossings
watch-crossings-used = of use
table-edge = edge
table-polygon-edge = edge
table-start = start
table-corner = corner

## Brute force

bf-intersect = Meet the line of the { $edge }.
bf-keep = Nothing lies beyond the { $edge }: this crossing was not needed.
bf-keep-parallel = Nothing lies beyond the { $edge }: this side changes nothing.
bf-cut = { $end } lies beyond { $border }: it moves to { $to }.
bf-option-none = Nothing lies beyond the { $edge }.
bf-option-one = One end lies beyond the { $edge }.
bf-option-both = Both ends lie beyond the { $edge }.
bf-note-tests = A point is inside if it passes all four.
bf-in-vain = in vain
bf-kept = { $part } of it is visible
code-bf-each = for each side, not parallel to P₁P₂
code-bf-intersect = X ← line P₁P₂ ∩ line of side
code-bf-reject = if both ends are beyond: reject
code-bf-cut = if one end is beyond: it ← X
code-bf-accept = accept P₁P₂
words-bf-each = Take the four sides in turn; skip a side that the segment runs parallel to.
words-bf-intersect = Compute where the segment’s line meets the side’s line.
words-bf-reject = If both ends lie beyond the side, nothing is visible.
words-bf-cut = If one end lies beyond it, move that end to the crossing.
words-bf-accept = What is left is visible.

## Cohen–Sutherland

cs-code = { $end } is { $region }: { $code } = { $bits }.
cs-or-accept = OR = { $bits }: both ends are inside.
cs-or-open = OR = { $bits } ≠ 0000: not everything is inside.
cs-and-reject = AND = { $bits } ≠ 0000: both ends lie beyond the { $edge }.
cs-and-open = AND = { $bits }: no side has both ends beyond it. The codes do not decide.
cs-choose = The lowest bit set is the { $edge }’s: { $end } lies beyond it.
cs-cut = Cut { $end } at { $border }.
cs-reject = Reject: both ends are { $region }; AND = { $and }.
cs-option-inside = Both ends are inside.
cs-option-not-inside = Not everything is inside.
cs-option-undecided = No side has both ends beyond it.
cs-option-beyond = Both ends lie beyond one side.
cs-note-code = A 1 for each side that the point lies beyond.
cs-note-order = In the order top, bottom, right, left it is { $other }.
cs-note-or = OR sets a bit where either code has it.
cs-note-and = AND keeps a bit only where both codes have it.
cs-cuts = cut
cs-this-order = this order:
cs-usual-order = usual order:
code-cs-codes = code₁ ← code(P₁); code₂ ← code(P₂)
code-cs-loop = loop
code-cs-accept = if code₁ OR code₂ = 0: accept
code-cs-reject = if code₁ AND code₂ ≠ 0: reject
code-cs-choose = side ← lowest bit of code₁ OR code₂
code-cs-end = P ← the end whose code has it
code-cs-cut = P ← P₁P₂ ∩ side
code-cs-recode = code of P ← code(P)
words-cs-codes = Give each end a code: one bit for each side that it lies beyond.
words-cs-loop = Repeat:
words-cs-accept = If no bit is set in either code, all that is left is visible.
words-cs-reject = If the codes share a bit, both ends lie beyond the same side.
words-cs-choose = Otherwise take the side of the lowest bit that is set.
words-cs-end = Exactly one end lies beyond it.
words-cs-cut = Move that end to where the segment crosses the side.
words-cs-recode = Give it a new code.
settings-bit-order = Bit order
bit-order-tbrl = top, bottom, right, left
bit-order-lrbt = left, right, bottom, top

## Liang–Barsky

lb-delta = P(u) = P₁ + u (P₂ − P₁): along the segment x and y change by Δx and Δy.
lb-row = k = { $k }, { $edge }: u · p ≤ q, { $direction }.
lb-parallel-inside = Parallel to the { $edge } and inside it: this side alone decides nothing.
lb-parallel-outside = Parallel to the { $edge } and outside it: no u can help.
lb-enter = The line enters across the { $edge }: u_min goes up.
lb-enter-idle = The line enters across the { $edge }, but not after u_min: no change.
lb-leave = The line leaves across the { $edge }: u_max comes down.
lb-leave-idle = The line leaves across the { $edge }, but not before u_max: no change.
lb-put = { $end } moves to u = { $u } on { $border }.
lb-reject = Reject at the { $edge }: nothing of the segment is left.
lb-note-enter = p < 0 enters: { $bound } = max({ $bound }, r)
lb-note-leave = p > 0 leaves: { $bound } = min({ $bound }, r)
lb-note-parallel = p = 0 is parallel: inside where q ≥ 0
code-lb-start = u_min ← 0; u_max ← 1; Δ ← P₂ − P₁
code-lb-each = for k = 1 … 4: p, q of side k
code-lb-parallel = if p = 0 and q < 0: reject
code-lb-enter = if p < 0: u_min ← max(u_min, q/p)
code-lb-leave = if p > 0: u_max ← min(u_max, q/p)
code-lb-empty = if u_min > u_max: reject
code-lb-accept = accept P(u_min) P(u_max)
words-lb-start = Start with the whole segment, u from 0 to 1.
words-lb-each = For each side, write “inside” as an inequality u · p ≤ q.
words-lb-parallel = p = 0: the segment is parallel to the side; if it lies outside, reject.
words-lb-enter = p < 0: the line comes in here. It cannot be visible before q/p.
words-lb-leave = p > 0: the line goes out here. It cannot be visible after q/p.
words-lb-empty = If the interval is empty, nothing is visible.
words-lb-accept = Otherwise the interval’s two ends are the visible part’s.

## Cyrus–Beck

cb-edge-entering = { $edge }: n·D > 0, the line comes in.
cb-edge-leaving = { $edge }: n·D < 0, the line goes out.
cb-edge-parallel = { $edge }: n·D = 0, the line is parallel to it.
cb-parallel-inside = Parallel to { $edge } and inside it: this edge alone decides nothing.
cb-parallel-outside = Parallel to { $edge } and outside it: no t can help.
cb-enter = The line enters across { $edge }: t_min goes up.
cb-enter-idle = The line enters across { $edge }, but not after t_min: no change.
cb-leave = The line leaves across { $edge }: t_max comes down.
cb-leave-idle = The line leaves across { $edge }, but not before t_max: no change.
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
faulty-normals-differs = Step { $step } is the first that differs: the normal points outside, and what enters is taken for leaving.
code-cb-start = t_min ← 0; t_max ← 1; D ← P₂ − P₁
code-cb-each = for each edge: n; w ← P₁ − E
code-cb-parallel = if n·D = 0 and n·w < 0: reject
code-cb-enter = if n·D > 0: t_min ← max(t_min, −n·w / n·D)
code-cb-leave = if n·D < 0: t_max ← min(t_max, −n·w / n·D)
code-cb-empty = if t_min > t_max: reject
code-cb-accept = accept P(t_min) P(t_max)
words-faulty-normals = For each edge, turn it to the left for its normal, whichever way the corners run.
words-cb-start = Start with the whole segment, t from 0 to 1.
words-cb-each = For each edge, take its normal, which points inside.
words-cb-parallel = n·D = 0: parallel to the edge; if it lies outside, reject.
words-cb-enter = n·D > 0: along the normal, so the line comes in here.
words-cb-leave = n·D < 0: against the normal, so the line goes out here.
words-cb-empty = If the interval is empty, nothing is visible.
words-cb-accept = Otherwise the interval’s two ends are the visible part’s.

## Nicholl–Lee–Nicholl

nln-region = { $end } is { $region }.
nln-side-enters = P₂ lies { $turn } of the line from P₁ through { $corner }: the { $first } is crossed first.
nln-side-meets = P₂ lies { $turn } of the line from P₁ through { $corner }: the { $first } is crossed first.
nln-side-leaves = P₂ lies { $turn } of the line from P₁ through { $corner }: out by the { $first }.
nln-side-through = P₂ lies on the line from P₁ through { $corner }: both sides are crossed at once.
nln-miss = Reject: the segment passes outside { $corner }, beyond the { $edge }.
nln-sector-inside = Both ends are inside: no crossing is needed.
nln-sector-enters = In by the { $enters }, and P₂ is inside: one crossing.
nln-sector-leaves = P₁ is inside; out by the { $leaves }: one crossing.
nln-sector-both = In by the { $enters }, out by the { $leaves }: two crossings, both of use.
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
words-nln-shared = If both lie beyond the same side, nothing is visible.
words-nln-enters = If P₁ lies in a corner region, the line through that corner tells by which side the segment comes in.
words-nln-meets = If P₂ lies beyond a neighbouring side, the line through their corner tells whether the segment meets the window at all.
words-nln-leaves = If P₂ lies in a corner region, the line through that corner tells by which side it goes out.
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
cost-of-all-segments = all { $count } segments: { $divisions } divisions, { $multiplications } multiplications, { $additions } additions, { $comparisons } comparisons
measure-title = What a segment costs
measure-about = Every method clips the same random segments, here and now.
measure-start = Measure
measure-again = Measure again
measure-nanos = Nanoseconds
measure-operations = Operations
measure-batch = Batch, branch-free
measure-note = For one segment, on average over { $count }. Time is that of the fastest of five passes.

## The verdict

verdict-line-between = The line comes in ({ $enters }) only after it has gone out ({ $leaves }).
verdict-line-in = Moved { $move } inwards, at right angles to the border ({ $edge }), it would be visible.
verdict-line-back = Moved { $move } outwards, at right angles to the border ({ $edge }), it would be visible.
verdict-line-never = No move at right angles to the border ({ $edge }) would make it visible.
verdict-line-out = Moved outwards by more than { $move }, at right angles to the nearest border ({ $edge }), it would vanish.
verdict-line-touch = It only touches: the least move outwards over the border ({ $edge }), and it would vanish.
