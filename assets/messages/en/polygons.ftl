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

## Drawing an outline by clicking

action-draw-subject = Draw the polygon
action-draw-clip = Draw the clip polygon
action-draw-hole = Draw a hole
action-no-holes = Remove all holes
draw-subject = Click to place vertex { $number } of the new polygon; Backspace takes one back, Escape gives up.
draw-clip = Click to place vertex { $number } of the new clip polygon; Backspace takes one back, Escape gives up.
draw-hole = Click to place vertex { $number } of the new hole; Backspace takes one back, Escape gives up.
draw-close = Click to place vertex { $number }; Enter, a double click or a click on the first vertex closes the outline.
refused-last-three = The vertex stays: a polygon needs at least three.
refused-too-many = { $count } vertices are too many: at most { $most }.

## Polygons and regions to start from

preset-title = Example polygons
preset-convex = Convex
preset-triangle = Triangle
preset-arrow = Arrowhead (concave)
preset-comb = Comb: several pieces
preset-corner = Around a corner: a bridge
preset-spiral = Spiral
preset-star = Star
preset-hole = With a hole
preset-around = All around the window
preset-inside = Inside the window
preset-touch = Touching in one point
preset-along = An edge along the border
preset-bow-tie = Bow tie: crosses itself
preset-random = Random
random-count = Vertices
random-make = Replace the polygon
region-title = Clip region
region-window = Window
region-corners = The window’s four corners
region-triangle = Triangle
region-diamond = Diamond
region-octagon = Octagon
region-bracket = L shape (concave)
