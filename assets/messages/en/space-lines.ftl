### What is said of segments in space: six-bit codes, inequalities, and clipping before the divide.

## Methods

alg-cohen-sutherland-3d = Cohen–Sutherland in space
alg-liang-barsky-3d = Liang–Barsky in space
alg-plane-line = Segment against planes
alg-homogeneous-line = Segment before the divide
alg-faulty-divide-first = Wrong: divided first

## What is asked, and what comes of it

space-line-opening-box = Which part of P₁P₂ lies in the box from −1 to 1?
space-line-opening-planes =
    Which part of P₁P₂ is inside { $planes ->
        [one] the plane
       *[other] all { $planes } planes
    }?
space-line-opening-clip = Which part of P₁P₂ has −w ≤ x, y, z ≤ w?
space-line-touch = Accept: the segment touches at the one point { $at }.
space-line-point = Accept: both ends are the one point { $at }, and it is inside.

## Six-bit codes

space-line-code-inside = { $end } is inside: { $code } = { $bits }.
space-line-code-one = { $end } is beyond the { $first } plane: { $code } = { $bits }.
space-line-code-two = { $end } is beyond two planes, { $first } and { $second }: { $code } = { $bits }.
space-line-code-three = { $end } is beyond three planes, { $first }, { $second } and { $third }: { $code } = { $bits }.
space-line-or-accept = OR = { $bits }: both ends are inside.
space-line-or-open = OR = { $bits } ≠ 000000: not everything is inside.
space-line-and-open = AND = { $bits }: no face has both ends beyond it. The codes cannot decide.
space-line-and-reject = AND = { $bits } ≠ 000000: both ends lie beyond the { $plane } plane.
space-line-choose = The lowest bit that is set belongs to the { $plane } plane: { $end } is beyond it.
space-line-reject-codes = Reject: both ends lie beyond the { $plane } plane; AND = { $and }.
space-line-note-code = Each 1 stands for a face that the point is beyond.

## One inequality a plane

space-line-delta = P(u) = P₁ + u (P₂ − P₁): along the segment x, y and z change by Δx, Δy and Δz.
space-line-before = Both ends have w ≥ 0: neither is behind the eye.
space-line-behind = { $end } has w < 0: it is behind the eye and must not be divided by w.
space-line-all-behind = Both ends have w < 0: the whole segment is behind the eye.
space-line-option-behind = One end has w < 0.
space-line-divided = Both ends are divided by w, and clipped afterwards.
space-line-row = The { $plane } plane: { $direction }.
space-line-parallel-inside = The segment is parallel to the { $plane } plane and inside it: this plane alone decides nothing.
space-line-parallel-outside = The segment is parallel to the { $plane } plane and outside it: no part can be visible.
space-line-enter = The line enters through the { $plane } plane: { $bound } goes up.
space-line-enter-idle = The line enters through the { $plane } plane, but not after { $bound }: no change.
space-line-leave = The line leaves through the { $plane } plane: { $bound } goes down.
space-line-leave-idle = The line leaves through the { $plane } plane, but not before { $bound }: no change.
space-line-put = { $end } moves to { $symbol } = { $u } on { $border }.
space-line-the-plane = the { $plane } plane
space-line-reject = Reject at the { $plane } plane: nothing of the segment is left.
space-line-reject-behind = Reject: no point of the segment is in front of the eye.
space-line-note-enter = { $first } < { $second } enters: { $bound } = max({ $bound }, { $crossing })
space-line-note-leave = { $first } > { $second } leaves: { $bound } = min({ $bound }, { $crossing })

## The w-lens

w-lens-eye = eye
w-lens-screen = screen, w = 1
screen-divide-first = Divide first
screen-clip-first = Clip first
screen-wrong = wrong: a piece that was never there
screen-same = the same: neither end is behind the eye
screen-no-image = an end has no image: w = 0
screen-so-far = what is left so far
screen-right = right: what is in front of the eye
screen-nothing = nothing is to be seen

## Cases

case-no-point = (0, 0, 0, 0) is no point of clip space.
case-flat-box = The box has no inside: { $low } and { $high } are both { $at }.

## Pseudocode

code-lb3-each = for k = 1 … 6: p, q of face k
words-lb3-each = For each of the six faces, write “inside” as an inequality u · p ≤ q.
code-pl-start = a_min ← 0; a_max ← 1
code-pl-each = for each plane (n, D): d₁ ← n·P₁ + D; d₂ ← n·P₂ + D
code-pl-parallel = if d₁ = d₂ and d₁ < 0: reject
code-pl-enter = if d₁ < d₂: a_min ← max(a_min, d₁/(d₁ − d₂))
code-pl-leave = if d₁ > d₂: a_max ← min(a_max, d₁/(d₁ − d₂))
code-pl-empty = if a_min > a_max: reject
code-pl-accept = accept P(a_min) P(a_max)
words-pl-start = Start with the whole segment, a from 0 to 1.
words-pl-each = For each plane, compute how far inside both ends are.
words-pl-enter = d grows: the line enters here. No part before a can be visible.
words-pl-leave = d shrinks: the line leaves here. No part after a can be visible.
code-hl-start = if w₁ < 0 and w₂ < 0: reject
code-hl-each = for each side x, y, z = ±w: d₁, d₂ ← w ± x, y, z
code-hl-enter = if d₁ < d₂: t_min ← max(t_min, d₁/(d₁ − d₂))
code-hl-leave = if d₁ > d₂: t_max ← min(t_max, d₁/(d₁ − d₂))
code-hl-empty = if t_min > t_max: reject
code-hl-accept = accept P(t_min) P(t_max); only now divide by w
words-hl-start = If both ends are behind the eye, nothing is visible.
words-hl-each = For each side, w plus or minus a coordinate tells how far inside a point is.
words-hl-enter = d grows: the line enters here.
words-hl-leave = d shrinks: the line leaves here.
words-hl-accept = What is left has w ≥ near > 0: now it can be divided by w.
code-faulty-divide = P₁ ← P₁ / w₁; P₂ ← P₂ / w₂
code-faulty-divide-accept = accept P(t_min) P(t_max)
words-faulty-divide = Divide both ends by w.
words-faulty-divide-accept = The ends of the interval count as the ends of the visible part.
faulty-divide-first-differs = Step { $step } is the first that differs: both ends were divided by w before anything was clipped.
