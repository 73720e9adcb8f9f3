### Why something is refused, or fails: one sentence for each typed error, whoever reports it.

## Shapes; the last part of the key is the code in the command line’s JSON where that has one

error-not-finite = Every coordinate must be a finite number.
error-empty-window = The window is empty: { $low } = { $min } must be less than { $high } = { $max }.
error-too-few-vertices = A polygon needs at least three vertices.
error-degenerate = The shape is degenerate: it has no length or area where it needs one.
error-not-convex = The clip polygon must be convex: this algorithm keeps what is inside every one of its edges.
error-self-intersecting = The polygon crosses itself.
error-edges-meet = The outline must not meet itself: edges { $first } and { $second } cross, touch or overlap.
error-misplaced-hole = Hole { $hole } must lie inside the outline and must not touch it or any other hole.
error-at = { $place }: { $problem }

## Shapes in space

error-empty-box = The box is empty: { $low } = { $min } must not be greater than { $high } = { $max }.
error-zero-normal = A plane needs a normal that is not zero.
error-negative-radius = A radius must not be negative, but this one is { $radius }.
error-no-vertices = Without any vertex there is no bounding volume.
error-target-at-position = The camera has no direction: its position and its target are the same point.
error-up-along-view = The camera’s up vector must not be zero, nor parallel to its direction of view.
error-field-of-view = The field of view must lie between 0° and 180°, both excluded, but it is { $degrees }°.
error-size = A size must be greater than 0, but this one is { $size }.
error-height = The height of the view volume must be greater than 0, but it is { $height }.
error-aspect = The aspect ratio, width over height, must be greater than 0 and leave the view volume a width, but it is { $aspect }.
error-near = The near plane must lie in front of the eye, at a distance greater than 0, but it is at { $near }.
error-far = The far plane must lie beyond the near plane: far = { $far } must be greater than near = { $near }.
error-not-affine = The last row of this matrix must be 0 0 0 1.
error-face-vertex = Face { $face }, counted from 0, names a vertex that does not exist.
error-no-mesh-faces = A mesh needs at least one face.
error-uv-length = A mesh needs as many texture coordinates as vertices, or none. Texture coordinates: { $uvs }, vertices: { $vertices }.

## Scenes

error-no-objects = A scene needs at least one object.
error-too-many-objects = A scene takes at most { $limit } objects, but there are { $count }.
error-no-such-object = There is no object { $focus }: objects in the scene: { $count }.
error-no-such-face = There is no face { $face }: faces of the object: { $count }.
error-no-such-vertex = There is no vertex { $vertex }: vertices of the object: { $count }.
error-no-segments = There is no segment.
error-too-many-segments = There are too many segments: { $count }, and at most { $limit } are allowed.
error-no-such-focus =
    { $count ->
        [one] There is no segment { $focus }: there is { $count } segment, counted from 0.
       *[other] There is no segment { $focus }: there are { $count } segments, counted from 0.
    }
error-last-three = The vertex is kept: a polygon needs at least three.
error-too-many-vertices = There are too many vertices: { $count }, and at most { $limit } are allowed.

## Moments of a run

error-bad-moment = This does not name a moment.

## Files

error-unreadable = The file cannot be read: { $reason }.
error-file-too-large = The file is larger than { $limit } MiB.
error-link-out = The file is a link that leads out of the lesson’s folder.
memory-broken = This is not a settings file.

## What the system answers; set after a colon, in the middle of a sentence

system-not-found = no such file or folder
system-denied = there is no permission
system-exists = it exists already
system-is-folder = it is a folder
system-not-file = it is not a file
system-not-folder = part of the path is not a folder
system-full = the disk is full
system-read-only = the disk is read-only
system-bad-name = the name is not valid
system-too-large = the file is too large
system-busy = another program is using it
system-no-files = there are no files here
system-loop = it is a link that leads to itself
system-number = the system reports error { $number }
system-silent = the system gives no reason
error-typed-range = expected a number from { $least } to { $most }, but { $typed } was typed
error-typed-place = expected { $count ->
    [1] one number
   *[other] { $count } numbers
}, such as −1.5 or 1/4, but { $typed } was typed

error-progress-broken = This is no file of progress.
error-progress-version = A later version of Clipscope wrote this file.
