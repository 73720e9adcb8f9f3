### What the surfaces lab says: which surface is in front, pixel by pixel.

alg-depth-buffer = Depth buffer
alg-faulty-depth-clear = Depth buffer, cleared to 0
alg-faulty-depth-compare = Depth buffer, comparison turned
alg-faulty-depth-always = Depth buffer, nothing compared
alg-faulty-depth-straight = Depth buffer, distance straight across the screen

## Pseudocode

code-depth-clear = picture ← background, z ← ∞
words-depth-clear = Clear the picture to the background and every depth to infinity.
code-depth-triangle = for each triangle T
words-depth-triangle = Take the triangles, in any order.
code-depth-fragment = for each pixel in T: z_T ← depth of T there
words-depth-fragment = For each pixel whose middle the triangle covers, find its depth there.
code-depth-compare = if z_T < z[pixel]
words-depth-compare = Compare it with the depth that stands there.
code-depth-write = picture[pixel] ← T, z[pixel] ← z_T
words-depth-write = If it is less, write the triangle and its depth.
code-faulty-depth-clear = picture ← background, z ← 0
words-faulty-depth-clear = Clear every depth to 0, the depth of the near plane.
code-faulty-depth-compare = if z_T > z[pixel]
words-faulty-depth-compare = Write where the new depth is greater.
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
  } on { $columns } × { $rows } pixels: { $pixels } depths, one for each pixel.
depth-clear = Cleared: none of the { $pixels } pixels has a triangle.
depth-triangle = { $triangle } comes, { $place } of { $triangles }.
depth-triangle-unseen = Nothing of { $triangle } is drawn: it lies outside of the volume, is edge-on, or shows its back.
depth-triangle-whole = { $triangle } is drawn: of { $fragments } fragments { $writes } are nearer than what stood there.
depth-span = Row { $row } of { $triangle }, columns { $first } to { $last }: of { $fragments } fragments { $writes } are written.
depth-fragment-first = Pixel [{ $column }, { $row }] is still empty: { $triangle } is written.
depth-fragment-kept = { $triangle } is nearer than { $other } at pixel [{ $column }, { $row }]: it is written.
depth-fragment-lost = { $triangle } is not nearer than { $other } at pixel [{ $column }, { $row }]: { $other } stays.
depth-fragment-tie = { $triangle } is as near as { $other } at pixel [{ $column }, { $row }]: { $other } came first and stays.
depth-fragment-lost-to-nothing = { $triangle } is not written at pixel [{ $column }, { $row }], though nothing has been there.
depth-nothing = nothing
depth-done = Done: { $fragments } fragments, { $writes } of them written, for { $pixels } pixels. So often each was computed on average:

## Views

raster-depth = Picture, { $columns } × { $rows }: depth in thousandths
raster-depth-steps = Picture, { $columns } × { $rows }: depth in { $bits } bits, 0 to { $last }
story-stored = stored
story-fate = result
story-kept = written
story-lost = lost
watch-triangle = triangle
watch-pixel = pixel
watch-fragments = fragments
watch-writes = written
watch-pixels = pixels

## The raster's form

raster-title = Raster
raster-rows = Rows
raster-shuffle = Shuffle (0: not)
raster-steps = A step is
raster-steps-fragments = a fragment
raster-steps-spans = a row of a triangle
raster-steps-triangles = a triangle
raster-number = Depth
raster-reversed = Reversed: 1 is near
raster-cull = Leave out back faces
