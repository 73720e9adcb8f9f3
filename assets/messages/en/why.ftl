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
