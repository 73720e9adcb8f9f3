### What the newest method says.

alg-corner-codes = Corner codes
corners-opening = Each of the eight corners of the box gets a code of six bits, one for each plane.
corners-inside = { $corner } is inside all six planes.
corners-beyond = { $corner } is beyond at least one of the six planes.
corners-culled = All { $corners } corners are beyond the { $plane } plane: the box is culled.
corners-kept = None of the { $corners } corners is beyond a plane: all of the box is inside.
corners-cut = No one plane has all { $corners } corners beyond it, and not all are inside: the triangles are asked in turn.
option-corners-culled = All eight corners are beyond one plane: the box is culled.
code-corners-each = for each corner P of the box:
code-corners-and = if AND of the codes ≠ 0: cull
code-corners-or = if OR of the codes = 0: inside
code-corners-else = otherwise: ask its triangles
words-corners-each = Take each of the eight corners to clip space.
words-corners-and = A bit that all codes share: the whole box lies beyond that plane.
words-corners-or = No bit in any code: all corners are inside, and the volume is convex.
words-corners-else = The codes cannot tell: the box may lie across a plane, or outside near an edge.
case-corners-straddles = Undecided: corners lie beyond planes, but no plane has all eight corners beyond it.
