### Why something is refused, or fails: one sentence for each typed error, whoever reports it.

## Shapes; the last part of the key is the code in the command line’s JSON where that has one

error-not-finite = Every coordinate must be a finite number.
error-empty-window = The window is empty: { $low } = { $min } must be less than { $high } = { $max }.
error-too-few-vertices = A polygon needs at least three vertices.
error-degenerate = The shape is degenerate: it has no extent where it needs one.
error-not-convex = The clip polygon must be convex: this algorithm keeps what is inside every one of its edges.
error-self-intersecting = The polygon crosses itself.
error-edges-meet = The outline must not meet itself: edges { $first } and { $second } cross, touch or overlap.
error-misplaced-hole = Hole { $hole } must lie inside the outline, clear of its edges and of every other hole.
error-at = { $place }: { $problem }

## Scenes

error-no-segments = There is no segment.
error-too-many-segments = There are too many segments: { $count }, where { $limit } are the most.
error-no-such-focus =
    { $count ->
        [one] There is no segment { $focus }: there is { $count } segment, counted from 0.
       *[other] There is no segment { $focus }: there are { $count } segments, counted from 0.
    }
error-last-three = The vertex stays: a polygon needs at least three.
error-too-many-vertices = There are too many vertices: { $count }, where { $limit } are the most.

## Moments of a run

error-bad-moment = This does not name a moment.

## Files

error-unreadable = The file cannot be read: { $reason }.
error-file-too-large = The file is larger than { $limit } MiB.

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
system-number = the system reports error { $number }
system-silent = the system gives no reason
error-typed-place = expected { $count ->
    [1] one number
   *[other] { $count } numbers
}, such as −1.5 or 1/4, but { $typed } was typed
