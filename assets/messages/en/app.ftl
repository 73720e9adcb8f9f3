### The window around the labs: tabs, panels, transport, menus, keys, and what it says when something goes right or wrong.

## The program

app-title = Clipscope
app-about = See, step by step, how graphics programs decide what is visible.

## Labs: the tabs of the window

lab-lines = Lines
lab-polygons = Polygons
lab-frustum = Frustum
lab-surfaces = Surfaces
lab-lines-about = Clip a segment against a window.
lab-polygons-about = Clip a polygon against a window or another polygon.
lab-frustum-about = Cull and clip objects and triangles in three dimensions.
lab-surfaces-about = Find the nearest surface at every pixel.

## Panels

panel-course = Course
panel-stage = Stage
panel-inspector = Inspector
panel-algorithm = Algorithm
panel-pseudocode = Pseudocode
panel-watch = Watch
panel-cost = Cost
panel-verdict = Verdict
panel-timeline = Timeline
panel-scene = Scene
panel-settings = Settings
panel-show = Show panel
panel-hide = Hide panel

## Second views beside the stage

view-u-axis = u-axis
view-observer = Observer’s view
view-camera = Camera’s view
view-depth-buffer = Depth buffer

## Transport: moving through the steps of a run

transport-first = First step
transport-back = One step back
transport-play = Play
transport-pause = Pause
transport-forward = One step forward
transport-last = Last step
transport-previous-phase = Previous phase
transport-next-phase = Next phase
transport-reset = Back to the start
transport-speed = Speed
transport-speed-value = { $speed } steps per second
transport-step = step { $step } of { $total }
transport-steps =
    { $count ->
        [one] { $count } step
       *[other] { $count } steps
    }

## What a tick on the timeline stands for

tick-phase = phase
tick-test = test
tick-cut = cut
tick-accept = accept
tick-reject = reject

## Pseudocode, watch table, cost and verdict

pseudocode-full = Code
pseudocode-words = Words
pseudocode-hidden = Hidden
pseudocode-hidden-note = Hidden: what comes next?
watch-name = Name
watch-value = Value
watch-new = new
watch-empty = Nothing has been computed yet.
cost-additions = additions and subtractions
cost-multiplications = multiplications
cost-divisions = divisions
cost-comparisons = comparisons
cost-total = in total
cost-so-far = so far
cost-compare = Compare with…
cost-compare-none = No comparison
verdict-hint = Click an object to see which test decided its fate.
verdict-undecided = Not decided yet at this step.

## Settings

settings-theme = Theme
theme-light = Light
theme-dark = Dark
theme-projector = Projector
settings-language = Language
settings-snap = Snap to grid

## Actions

action-present = Present
action-present-leave = Leave presentation
action-help = Help
action-undo = Undo
action-redo = Redo
action-open = Open…
action-save = Save
action-save-as = Save as…
action-export = Export this figure
action-reset = Reset
action-reset-view = Fit the view
action-copy = Copy
action-close = Close
action-cancel = Cancel
action-add-vertex = Add a vertex
action-remove-vertex = Remove the vertex
search-hint = Search lessons and commands
search-none = Nothing found for “{ $query }”.

## Help: the keys

help-title = Keys
help-step = one step back or forward
help-step-ten = ten steps
help-phase = previous or next phase
help-ends = first or last step
help-play = play or pause
help-reset = reset the scene
help-lesson-step = previous or next lesson step
help-drag = drag any handle, at any step: the run is recorded again

## What the program reports

status-exported = Exported to { $path }
status-export-failed = The figure could not be exported: { $reason }
status-saved = Saved to { $path }
status-save-failed = The scene could not be saved: { $reason }
status-open-failed = { $path } could not be opened: { $reason }
status-kept = The scene is as it was.
status-reloaded = { $path } changed and was read again.
status-drop = Drop a lesson, a scene or a mesh here.
status-empty = There is nothing to clip yet.
status-recording = Recording the run…

## For screen readers

access-handle = handle of { $name } at { $point }

## More of the window: menus, dialogs, keys

menu-more = More
cost-title = Cost so far
cost-compared-with = compared with { $method }
save-title = Save the scene
export-title = Export this figure
save-path = File
help-zoom = zoom in or out; also Ctrl and wheel
help-course = show or hide the course
help-inspector = show or hide the inspector
help-leave = close, or leave the presentation
help-tab = to the next handle or button
help-nudge = move the handle that has the focus; Shift: ten times as far
help-alt = while dragging: off the grid
status-last-good = The last version that worked is shown.
status-more-problems =
    { $count ->
        [one] … and { $count } more problem.
       *[other] … and { $count } more problems.
    }
