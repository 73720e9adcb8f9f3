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
