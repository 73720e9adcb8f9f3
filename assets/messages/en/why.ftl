### Proofs by picture: where formulas come from.

## Views

why-view-section = Seen along the plane, true lengths

## t by similar triangles

why-similar = Why: t = d₁ / (d₁ − d₂)
why-similar-opening = After which part t of the way from P₁ to P₂ does the segment meet the { $plane } plane?
why-similar-d1 = The value of n·P + D at P₁ says how many levels P₁ lies from the plane.
why-similar-d2 = The same at P₂.
why-similar-levels = From P₁ to P₂ the segment passes through all levels between these two values.
why-similar-parallel = The whole segment lies on one level: it is parallel to the plane, and there is no t.
why-similar-piece = All triangles between two levels have the same angles, so a change of 1 takes the same piece of the segment everywhere.
why-similar-t = The plane is level 0. From P₁ to the plane the value changes by −d₁, and on the whole way by d₂ − d₁.
why-code-d1 = d₁ ← n·P₁ + D;  d₂ ← n·P₂ + D
why-words-d1 = Find the level of each end.
why-code-levels = levels ← d₂ − d₁
why-words-levels = Count the levels from end to end.
why-code-piece = piece ← 1 / levels
why-words-piece = Every level takes the same piece of the segment.
why-code-t = t ← −d₁ · piece = d₁ / (d₁ − d₂)
why-words-t = From P₁ to the plane there are −d₁ levels.

## n·(P − p₀) as a shadow

why-view-above = Seen from above
why-view-side = Seen from the side
why-view-front = Seen from the front
why-shadow = Why: d = n·(P − p₀)
why-shadow-opening = Go from p₀, a point of the { $plane } plane, to P in steps along the axes. Light shines along the plane.
why-shadow-piece = The step along { $axis } casts its own shadow on n: as long as the step times this component of n.
why-shadow-sum = Put end to end, the shadows of the steps are the shadow of the whole way P − p₀.
why-shadow-distance = Shadow and perpendicular are opposite sides of a rectangle, so the shadow is the distance d of P from the { $plane } plane.
why-shadow-elsewhere = From p₀ = { $other } the single shadows are different, and their sum is the same.
why-code-steps = for each axis: step ← P − p₀
why-words-steps = Go from a point of the plane to P, axis by axis.
why-code-shadow = shadow ← step · component of n
why-words-shadow = Each step casts a shadow on the normal.
why-code-sum = n·(P − p₀) ← sum of the shadows
why-words-sum = Shadows add up.
why-code-rectangle = d ← n·(P − p₀) = n·P + D
why-words-rectangle = The perpendicular is as long as the shadow, whatever point p₀ is.

## Strips: why p < 0 is “in”

why-view-strips = x and y over u, each with its strip of the window
why-in = in
why-out = out
why-strips = Why: p < 0 is “in”, p > 0 is “out”
why-strips-opening = Over u both coordinates are straight lines, and the window is a strip for each of them.
why-strips-in = The line enters its strip through the { $edge }.
why-strips-out = The line leaves its strip through the { $edge }.
why-strips-level = The line is level and stays inside the { $edge } all the way.
why-strips-beyond = The line is level and stays beyond the { $edge } all the way: no part is visible.
why-strips-from = Both strips hold the line only after the later “in”.
why-strips-empty = The earlier “out” comes before the later “in”: there is no u at which both strips hold the line.
why-strips-to = From the later “in” to the earlier “out” both strips hold the line.
why-code-strip = for each border of a strip:
why-words-strip = Left and right bound the strip of x, bottom and top that of y.
why-code-in = if p < 0: in at u = q / p
why-words-in = A line that rises comes in from below, one that falls from above.
why-code-out = if p > 0: out at u = q / p
why-words-out = Across the other border of the strip it goes out.
why-code-level = if p = 0: always inside, or never
why-words-level = A level line crosses no border of its strip.
why-code-both = u_min ← latest in;  u_max ← earliest out
why-words-both = Visible is what both strips hold.

## Row 3 of the projection

why-view-depth = z′ over depth, between −w and w
why-projection-row = Why: row 3 of the projection
why-row-opening = Row 3 makes z′ = a · depth + b. Which a and b put the depths from { $near } to { $far } between −w and w?
why-row-near = The near plane, at depth { $near }, has to lie on the lower border.
why-row-far = The far plane, at depth { $far }, has to lie on the upper border.
why-row-slope = Only one straight line passes through both points. From one to the other z′ grows by { $climb } and the depth by { $way }: a is the quotient.
why-row-start = Continued back to depth 0, the line starts at b.
why-row-point = P is { $depth } deep; the line gives its z′.
why-row-divided = On a line from 0 the quotient z′ / w is the same everywhere: it is read on the ruler at the far plane.
why-row-middle = Each of { $steps } equal steps of depth is read on the ruler, on its own line from 0. The first half, from −1 to 0, is used up by the depths from { $near } to { $middle }.
why-code-near-far = near ↦ z′ = −w;  far ↦ z′ = w
why-words-near-far = Two conditions: each plane goes to its border.
why-code-slope = a ← (w_far + w_near) / (far − near)
why-words-slope = Two points fix a straight line, and so its slope.
why-code-start = b ← −w_near − a · near
why-words-start = Where the line starts, at depth 0.
why-code-row = z′ ← a · depth + b = −a · z + b
why-words-row = The depth is −z, so row 3 is 0 0 −a b.
why-code-divide = z′ / w
why-words-divide = After the divide, depths near the far plane crowd together.

## n·e > 0

why-view-bar = Each face seen from the side, its normal upwards
why-facing = Why: n·e > 0 faces the eye
why-facing-opening = The bar is face { $face }, seen from the side, its normal upwards. Is the eye above the bar or below it?
why-facing-product = n·e is the length of n times the shadow of e on n.
why-facing-length = The length of n is positive, so it does not change the sign.
why-facing-no-length = This face has no area, so it has no normal, and no side to show.
why-facing-above = The shadow of e is the height of the eye above the plane of face { $face }: the eye sees its front.
why-facing-below = The shadow of e points the other way: the eye is not above the plane of face { $face }, so it does not see its front.
why-facing-other-above = For face { $face } the eye is above the bar.
why-facing-other-below = For face { $face } the eye is not above the bar.
why-facing-fronts = { $fronts ->
    [one] The eye is above the bar for { $fronts } of { $faces } faces: this face shows its front, and its n·e is positive.
   *[other] The eye is above the bar for { $fronts } of { $faces } faces: these show their front, and their n·e is positive.
}
why-code-product = n·e = |n| · shadow of e on n
why-words-product = A dot product is a length times a shadow.
why-code-height = height ← n·e / |n|
why-words-height = How high the eye is above the plane of the face.
why-code-bar = for each other face: the same bar
why-words-bar = Seen from the side every face is a bar.
why-code-front = front ⇔ height > 0 ⇔ n·e > 0
why-words-front = The sign alone says on which side the eye is.
why-depth = depth

## A side's normal

why-quarter-turn = Why: the normal of a side plane
why-mirrored = n of the left plane
why-turn-opening = From above, the right plane is a line through the eye. Its normal is to be found, and then the distance of P.
why-turn-tangent = For each unit ahead the plane goes this far to the side: the tangent of half the angle of view, α.
why-turn-across = One unit along the plane goes this far across: the sine of α.
why-turn-ahead = The same unit goes this far ahead: the cosine of α.
why-turn-turned-across = The triangle turns by 90° to the inside. The leg that went ahead now goes across, to the left.
why-turn-turned-ahead = The leg that went across now goes ahead. Ahead is −z, so the normal is (−cos α, 0, −sin α).
why-turn-distance = The length of n is still 1, so n·P is the distance of P from the right plane.
why-code-tangent = tan α ← aspect · tan (fov / 2)
why-words-tangent = Half the angle of view says how the plane opens.
why-code-unit = one unit along the plane: (sin α, cos α)
why-words-unit = A unit has two legs, across and ahead.
why-code-turn = turned by 90°: (−cos α, sin α)
why-words-turn = The legs change places, and one changes its sign.
why-code-check = d ← n·P + D
why-words-check = A turn keeps lengths, so n has length 1.

## A fence

why-view-screen = On the screen: posts 1 high
why-fence = Why: 1 / depth is linear
why-fence-opening = A fence of posts 1 high stands along an edge of the scene. Where do equal steps on the screen meet it?
why-fence-nothing = No edge can be seen from aside by a camera in perspective: there is no fence to divide into { $steps } steps.
why-fence-first = The first post is { $depth } deep.
why-fence-last = The last post is { $depth } deep.
why-fence-post = Step { $post } on the screen is as wide as the others; its sight line meets the fence at depth { $depth }, after { $before }.
why-fence-height = On the screen a post 1 high is 1 / depth high.
why-fence-drop = The top of the fence is straight in space, so it is straight on the screen, from the first post to the last.
why-fence-step = Under a straight line equal steps take equal amounts: each step on the screen takes this much from 1 / depth.
why-code-ends = depth of the first and the last post
why-words-ends = The fence stands between two vertices.
why-code-posts = for each equal step on the screen: depth of the fence
why-words-posts = Equal steps on the screen are unequal steps on the fence.
why-code-post = height on the screen ← 1 / depth
why-words-post = What is twice as deep looks half as high.
why-code-top = a straight top: 1 / depth changes evenly
why-words-top = A straight line looks straight.

## Bresenham’s e

why-error-term = Why: Bresenham’s e
why-view-columns = The first columns, large
why-error-opening = In a column the line moves b / a of a pixel aside; the midpoint between two pixels is 1/2 aside. Which is farther?
why-error-parts = Measure both with one ruler that has 2a parts to a pixel.
why-error-one-pixel = The line begins and ends in the same pixel: nothing has to be chosen.
why-error-line = Then the line moves a whole number of parts in each column.
why-error-midpoint = The midpoint is a whole number of parts aside, too.
why-error-beyond = Column { $column }: the line is beyond the midpoint, so the pixel aside is taken, and the midpoint moves on by a pixel.
why-error-short = Column { $column }: the line is not beyond the midpoint, so the pixel straight ahead is taken.
why-code-parts = one pixel = 2a parts
why-words-parts = Divide each pixel so finely that there are no fractions.
why-code-both-whole = line: 2b in each column;  midpoint: a
why-words-both-whole = Both are whole numbers then.
why-code-columns = for each column:
why-words-columns = Go from column to column.
why-code-error = e ← line − midpoint
why-words-error = The sign of e says on which side of the midpoint the line is.

## Crosses once

why-view-sight = Distance from the plane along two lines of sight
why-crosses-once = Why: the far side hides nothing
why-bend = it would have to bend
why-once = once
why-once-opening = Can anything on the far side of a triangle’s plane hide something on the eye’s side?
why-once-no-sides = The eye lies in the plane of { $plane }: neither side is the eye’s.
why-once-eye = The eye is on one side of the plane of { $plane }, at this distance.
why-once-own = Q, the middle of { $own }, is on the same side.
why-once-least = On the way to Q the distance changes evenly and is never 0: whatever hides Q is on the eye’s side of { $plane }.
why-once-other = R, the middle of { $other }, is on the other side.
why-once-crossing = On the way to R the distance is 0 once: before that place the near side may hide R, after it the far side.
why-code-eye = E: d(E) > 0
why-words-eye = The eye’s side is the positive one.
why-code-own = d(Q) > 0: d > 0 all the way
why-words-own = Between two positive values there is no 0 on a straight line.
why-code-other = d(R) < 0: d = 0 once
why-words-other = A straight line meets a plane once.
why-code-order = draw: far side, the triangle, the eye’s side
why-words-order = What is hidden is drawn first.

## A bridge

why-bridge = Why: a bridge has no area
why-edge = edge
why-width = width
why-height = height
why-strip = strip
why-sum = sum
why-bridge-opening = Each edge of the ring has a strip, from the left border to the edge: added if the edge goes up, taken away if it goes down.
why-bridge-up = { $edge } goes up, so its strip is added.
why-bridge-down = { $edge } goes down, so its strip is taken away.
why-bridge-none = { $edge } has no strip: it is level, or it lies where the strips begin.
why-bridge-back = { $edge } runs back over { $other }: a bridge. There the same strip is added once and taken away once.
why-bridge-area = All strips together leave { $area }: the area of the ring, without any for the bridge.
why-bridge-elsewhere = If the strips begin at the right border, every strip is another one, and their sum is the same.
why-code-edges = for each edge of the ring:
why-words-edges = Walk once round the ring.
why-code-swept = strip ← mean width · height
why-words-swept = An edge that goes down has a negative height.
why-code-area = area ← sum of the strips
why-words-area = What is walked there and back cancels.

## A crossing as a weighted mean

why-mean = Why: a crossing is a weighted mean
why-triangle = triangle
why-across = across
why-along = along
why-mean-opening = A segment crosses the line of an edge. At which place along the edge?
why-mean-nothing = No edge has its line between P₁ and P₂: there is no crossing to find.
why-mean-first = P₁ is this far from the { $edge }, { $border }.
why-mean-second = P₂ is this far from it, on the other side.
why-mean-part = So the { $edge } is reached after this part of the way across.
why-mean-rise = The triangle up to the edge has the angles of the whole segment’s triangle: it is the same triangle, t times as large. So t of the way along the edge is done, too.
why-mean-level = The segment does not move along the edge: both triangles are flat.
why-mean-mean = Put together: the { $along } of each end is weighted by the distance of the other end.
why-mean-given = The same mean of the other coordinate, { $across }, gives the edge itself. So it is copied, not computed.
why-code-weights = w₁, w₂ ← distances of P₁ and P₂ from the edge
why-words-weights = Measure how far each end lies from the line of the edge.
why-code-part = t ← w₁ / (w₁ + w₂)
why-words-part = Of the way across, w₁ lies before the edge.
why-code-rise = X ← P₁ + t · (P₂ − P₁)
why-words-rise = In both directions the same part of the way is done.
why-code-mean = X = (w₂ · P₁ + w₁ · P₂) / (w₁ + w₂)
why-words-mean = The nearer end counts more.

## Twice an area

why-double-area = Why: a₁·b₂ < b₁·a₂ is “to the left”
why-area = area
why-left = left
why-right = right
why-rectangle = rectangle
why-ends = + two halves
why-half = − half of all
why-more = more than half
why-area-opening = On which side of the line from P₁ through a corner does P₂ lie? Measure both from that corner.
why-area-nothing = Here the regions of P₁ and P₂ are enough: no corner is tested.
why-area-first = The lines through { $corner } divide the rectangle from P₁ to P₂ into four parts. One of them is |a₁| wide and |b₂| high.
why-area-second = The part across from it is |a₂| wide and |b₁| high.
why-area-ends = Go from P₁ to P₂ over { $corner }: this way halves the other two parts.
why-area-half = The straight way from P₁ to P₂ halves the whole rectangle.
why-area-more = Left of the way over { $corner } there is more than half, by the triangle between both ways. Right of it there is as much less.
why-area-less = Left of the way over { $corner } there is less than half, by the triangle between both ways. Right of it there is as much more.
why-area-none = { $corner } lies on the straight way: there is no triangle, and each side is one half.
why-area-left = Left minus right is twice the triangle, and positive: P₂ lies to the left of the line from P₁ through { $corner }.
why-area-right = Left minus right is twice the triangle, and negative: P₂ lies to the right of the line from P₁ through { $corner }.
why-area-through = Left minus right is 0: P₂ lies on the line from P₁ through { $corner }.
why-code-rectangles = rectangles: |a₁·b₂| and |b₁·a₂|
why-words-rectangles = These are the two parts that touch neither P₁ nor P₂.
why-code-over = way over the corner: halves the other two
why-words-over = A diagonal halves a rectangle.
why-code-straight = straight way: halves all four
why-words-straight = The whole rectangle has a diagonal, too.
why-code-between = triangle ← left + two halves − half of all
why-words-between = What lies between both ways is more on one side and less on the other.
why-code-twice = b₁·a₂ − a₁·b₂ = left − right = 2 · triangle
why-words-twice = The sign tells the side: positive is to the left.
