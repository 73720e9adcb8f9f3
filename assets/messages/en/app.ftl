### The window around the labs: tabs, panels, transport, menus, keys, and what it says when something goes right or wrong.

## The program

app-title = Clipscope

## Labs: the tabs of the window

lab-lines = Lines
lab-lines-about = Clip a segment against a window.
lab-polygons = Polygons
lab-polygons-about = Clip a polygon against a window or another polygon.
lab-frustum = Frustum
lab-frustum-about = See what a camera sees, and what can be left out before it is drawn.
lab-surfaces = Surfaces
lab-surfaces-about = See which surface is in front, pixel by pixel.

## Panels

panel-course = Course
panel-stage = Stage
stage-boundary = Boundary between the drawing and the part beside it: drag it, or press the arrow keys.
panel-inspector = Inspector
panel-algorithm = Algorithm
panel-pseudocode = Pseudocode
panel-watch = Watch
panel-controls = Set
panel-cost = Cost
panel-timeline = Timeline
panel-scene = Scene

## Transport: moving through the steps of a run

transport-first = First step
transport-back = One step back
transport-play = Play
transport-pause = Pause
transport-forward = One step forward
transport-last = Last step
transport-next-page = Next step of the lesson
transport-speed-value = Steps per second: { $speed }
transport-step = step { $step } of { $total }
transport-steps =
    { $count ->
        [one] { $count } step
       *[other] { $count } steps
    }

## Pseudocode, watch table, cost and verdict

pseudocode-full = Code
pseudocode-words = Words
pseudocode-hidden = Hidden
pseudocode-hidden-note = Hidden: what comes next?
watch-empty = Nothing has been computed yet.
verdict-title = Why?
verdict-go = Go to that step (Enter)
cost-additions = additions and subtractions
cost-sums = additions
cost-multiplications = multiplications
cost-divisions = divisions
cost-comparisons = comparisons
cost-total = in total
cost-compare = Compare with…
cost-compare-none = No comparison

## Settings

settings-theme = Theme
theme-light = Light
theme-dark = Dark
theme-projector = Projector
settings-text = Text size
settings-snap = Snap to grid

## Actions

action-present = Present
action-present-leave = Leave presentation
action-open-whole = Open in Clipscope
action-notes = Notes for the speaker
speaker-clock = { $clock } since the presentation began (hours and minutes)
speaker-no-note = This step has no note.
speaker-next = Next: { $title }
speaker-last = This is the last step.
courses = Other courses
course-built-in = The built-in course
action-picture = The camera’s picture beside the observer’s
no-picture = No method on the stage shows a picture of the camera here.
type-what = Choose a handle first: Tab goes from one to the next, a click takes one.
action-free = Free scene
action-course = Back to the course
free-title = Free scene
free-scenes = Free scenes
scene-new = New free scene…
scene-copy = Copy of this scene…
scene-rename = Rename this free scene…
scene-delete = Delete this free scene…
scene-numbered = Scene { $n }
scene-name = Name
scene-name-taken = Another scene of this lab has this name.
scene-make = Make it
scene-rename-it = Rename it
scene-delete-it = Delete it
scene-delete-asks = “{ $name }” goes, with everything that could be undone in it. Nothing brings it back.
free-about = Your own scene: nothing is locked, and it is kept.
free-about-large = Your own scene: nothing is locked. The scene is too large to be kept when the window closes: save it as a file (Ctrl+S).
free-back = ← {$lesson}
free-from-course = Scenes of the course
scene-adopt = Open this scene in: { $lab }
action-help = Help
action-undo = Undo
action-redo = Redo
save-exists = This file already exists and is not the one that was opened.
action-replace = Replace it
action-open = Open…
action-open-it = Open
action-open-path = Open a path…
action-recent = Open a recent file
action-save = Save
action-save-path = Save to a path…
action-browse = Browse…
action-export = Export this figure
action-copy = Copy this figure
action-copy-svg = Copy as SVG text
action-link = Copy a link to this
action-reset = Reset
action-fit = Fit
handle-locked = { $name } is locked in this step.
handle-other = click: { $name }
handles-listed = { $list }; { $name }
action-reset-view = Fit the view
action-close = Close
action-cancel = Cancel

## Help: the keys

help-title = Keys
help-step = One step back or forward
help-step-ten = Ten steps
help-phase = Previous or next phase
help-ends = First or last step
help-play = Play or pause
help-reset = Reset the step’s scene; show a free scene from its first step, fitted
help-lesson-step = Previous or next lesson step
help-drag = Drag any handle, at any step: the run is then recorded again

## What the program reports

status-exported = Exported to { $path }
status-exporting = Steps exported: { $count } of { $total }. Esc stops the export.
status-export-failed = The figure could not be exported: { $reason }
greeting = ← and → step through the run, Space plays it. Everything that has a handle can be dragged, at any step.
status-restored = Your work from last time is back; undo removes it.
status-copied = The figure is on the clipboard: { $width } × { $height } pixels.
status-copied-svg = The figure is on the clipboard as the text of an SVG file ({ $count } kB).
status-copy-failed = The figure could not be copied: { $reason }
status-link-copied = The link is on the clipboard ({ $count } characters). Anyone who opens it sees what you see.
status-link-long = The link is on the clipboard. It has { $count } characters: some programs cut a link of more than 2,000.
status-link-of-page = This scene is too large for a link. The link on the clipboard leads to the lesson’s step as it was.
status-link-none = This scene is too large for a link. Save it as a file.
status-saved = Saved to { $path }
status-memory-aside = { $path } could not be read: { $reason } The file is now { $aside }, and the settings start again.
status-memory-unread = { $path } could not be read: { $reason } Settings and work will not be kept.
status-memory-unkept = Settings and work cannot be kept in { $path }: { $reason }.
status-memory-full = The browser cannot keep settings and work: { $reason }.
status-memory-refused = The browser keeps nothing for this page: settings and work are gone when you close it. Save what you want to keep.
status-coming = { $what } is on its way.
status-not-come = { $what } did not arrive. Choose it once more to try again.
status-fonts-coming = The Chinese characters are still being loaded. Try again in a moment.
status-save-failed = The scene could not be saved: { $reason }
status-open-failed = { $path } could not be opened: { $reason }
status-forgotten = It is no longer among the recent files.
status-no-window = The window could not be opened: it needs a display and OpenGL. Without them, clipscope export draws the figures to files. The system says: “{ $reason }”
status-kept = The scene is as it was.
status-mesh-reading = Reading { $path }… Esc cancels.
status-mesh-given-up = Reading { $path } was cancelled: the scene is as it was.
status-mesh-plain = The texture that { $library } names could not be read: the mesh is drawn without it.
status-mesh-picture = { $name } is beside the mesh and is used as its texture.
status-mesh-added =
    { $count ->
        [one] { $name } with { $count } triangle is now in the scene.
       *[other] { $name } with { $count } triangles is now in the scene.
    }
status-reloaded = { $path } changed and was read again.

## For screen readers

access-handle = handle of { $name } at { $point }

## More of the window: menus, dialogs, keys

menu-more = More
cost-title = Cost so far
cost-compared-with = compared with { $method }
open-title = Open a scene
save-title = Save the scene
export-title = Export this figure
export-format = Format
export-weight = File size
export-weight-of =
    { $count ->
        [one] { $size } kB
       *[other] { $count } files of about { $size } kB
    }
export-size = Size
export-language = Language
export-steps = Steps
export-this-step = this step
export-all-steps = all steps of the run
save-path = File
save-folder = Folder
key-space = Space
key-enter = Enter
key-escape = Esc
key-delete = Delete
key-insert = Insert
key-home = Home
key-end = End
key-page-up = PageUp
key-page-down = PageDown
key-backspace = Backspace
key-shift = Shift
help-zoom = Zoom in or out; also Ctrl and the wheel
help-text = Larger text, smaller, or as at first
help-course = Show or hide the course
help-free = Previous or next free scene of the lab
help-inspector = Show or hide the inspector
help-leave = Close, or leave the presentation
help-tab = To the next handle or button
help-nudge = Move the handle that has the focus; with Shift, ten times as far
help-deeper = In space: move that handle away from the eye or towards it
help-axis = In space, held while a handle moves: only along that axis
help-type = Type the position of the selected handle
help-alt = While dragging: ignore the grid
help-pen = While presenting, held: draw over the stage, until the next step
help-verdict = Go to the step that decided about what was clicked
status-last-good = The last version that worked is shown.
status-more-problems =
    { $count ->
        [one] … and { $count } more problem.
       *[other] … and { $count } more problems.
    }

## Vertices, outlines, and the methods that are wrong on purpose

help-add = Another segment, or a vertex after the selected one
help-remove = Remove the segment, or the selected vertex
help-draw-close = While drawing: close the outline
help-draw-back = While drawing: remove the last vertex
help-edge = Double click, or Ctrl and click, on an edge: a new vertex there
help-turn = In space the right button turns the view, wherever it is dragged; the wheel brings the view nearer
faulty-title = What is wrong here?
methods-objects = Objects, faces and points
methods-segments = Segments
methods-triangles = Triangles
methods-vertices = Vertices
methods-why = Where formulas come from
faulty-unnamed = A student’s program
differs-from = differs from step { $step } on
differs-nowhere = the same steps for this input
not-so = × { $what }
wrong-and-right = Wrong: { $wrong } Right: { $right }
part-missing = missing
result-right = Right result: { $n }
result-wrong = × Wrong result: { $n }
again = { $what } again
is-missing = { $what } missing
refused = refused
run-later = The scene is too large for the method to run while you drag. It runs when you let go.
recording-triangles = { $method } is being recorded on { $count ->
        [one] { $count } triangle
       *[other] { $count } triangles
    }…
recording-vertices = { $method } is being recorded on { $count ->
        [one] { $count } vertex
       *[other] { $count } vertices
    }…
recording-segments = { $method } is being recorded on { $count ->
        [one] { $count } segment
       *[other] { $count } segments
    }…
recording-stop = Stop (Esc)

## Views beside the drawing

view-empty = nothing is left
view-more = … { $count } more

practice = Ask me
action-practise = Let me say each decision before it is shown
practice-question = What comes next?
practice-how = Press a digit, or choose.
practice-take-back = Take back (Backspace)
practice-show = Show me (S)
practice-right = ✓ { $right }.
practice-wrong = × { $chosen }. Right: { $right }.
practice-shown = { $right }.
practice-go-on = Go on (Enter)
practice-told = { $right } of { $count } told before they were shown
practice-done = The run is done: there are no more decisions.
practice-on = You will be asked before the next decision.
practice-leave = Ask no more
practice-step = step { $step }
what-comes-next = What comes next? { $options }
named-sentence = { $name }: { $said }
figure-before = Before
figure-now = Now

lesson-waits = The rest opens with your answer, or with S.
lesson-ask-again = Ask me this again
settings-asks = Lessons ask before they show
settings-marks-at-end = Marks at the end of the run
answers-title = Asked in this run
answers-earlier = Earlier answers in this run: { $count }
answer-right = Step { $step }: { $right }. Told beforehand.
answer-wrong = Step { $step }: { $right }, not: { $chosen }.
answer-shown = Step { $step }: { $right }. Shown.
practice-stands = The question of this step: { $told }.
told-beforehand = answered beforehand
told-after = answered after the numbers were shown
told-open = open
told-missed = open; your answer was not right
told-seen = seen
told-unseen = not seen yet
progress-title = Progress
progress-counts = { $seen ->
    [one] One step seen
   *[other] { $seen } steps seen
} · { $beforehand } told beforehand · { $after } told after the numbers · { $open } open · goals reached: { $reached } / { $goals }
progress-hand-in = Hand in…
progress-take-up = Take up a file…
progress-afresh = Begin afresh
progress-sure = All marks of this computer go.
hand-in-title = Hand in your progress
take-up-title = Take up a file of progress
progress-taken-up = The marks of the file were added to yours.
goal-reached = All parts hold: the goal is reached.
goal-part-met = holds
goal-part-open = does not hold yet
mark-reached = goal reached
mark-goal = goal not reached yet
goal-hint = Hint (T)
goal-hint-part = { $part } of { $count } seen
goal-hint-none = The run of this scene decides nothing: change the scene first.
goal-hint-now = “{ $part }”: now { $now }, wanted { $sign }{ $wanted }.
goal-hint-open = “{ $part }”: not yet.
goal-hint-way = One solution moves only: { $handles }.
goal-hint-parts = In one solution the two programs part here: { $said }
goal-so-far = Where your runs ended
goal-ended =
    { $count ->
        [one] { $said } One run ended so.
       *[other] { $said } { $count } runs ended so.
    }
action-hint = A hint towards the goal: what decides, then the equation
mark-hints =
    { $count ->
        [one] { $count } part of the hint seen
       *[other] { $count } parts of the hint seen
    }
action-smaller = A smaller scene with the same difference
smaller-search = A smaller scene is looked for. Esc stops, and the smallest so far stays.
smaller-none = No smaller scene was found with the same difference: this one is small already.
smaller-not-yet = First change the scene until the goal is reached. Then M makes the scene smaller.
smaller-fewer = The scene is smaller, with the same difference. Vertices: { $after } in place of { $before }.
smaller-rounder-only = The numbers are rounder, and the difference is the same.
smaller-rounder = The numbers are rounder, and the difference is the same. Moved: { $handles }.
smaller-no-difference = There is no difference here to be made smaller: a mistake must stand beside the right method, and differ.

## A lesson that is made

compose-title = Making a lesson
compose-begin = Change this lesson
compose-leave = Finish with the lesson
compose-try = Try it as a student
compose-back = Back to making the lesson
compose-saved = ✓ Everything is saved.
compose-unsaved = … Changes are not saved yet.
compose-outside = Another program has changed the files of this lesson. Nothing is saved until you decide. There now stands:
compose-take-theirs = Take that version
compose-keep-mine = Keep the version in this window
compose-settle-first = Another program has changed the files of this lesson: first decide which version stays.
compose-step-title = Step { $n } of { $total }, title
compose-text = Text, in Markdown
compose-text-how = > hides an answer until a student asks for it. A line --- ends what can be read before a question is answered.
compose-stands = Where the run stands
compose-follows = follows the timeline
compose-locked = Locked
compose-lock-focused = while a lesson is made: locks the handle in focus, or unlocks it
compose-ask = Ask before this step
compose-ask-decision = the last decision
compose-ask-run = every decision of the run
compose-figure = A figure that can be exported
compose-figure-name = Name of the figure
compose-id = Name of the step in links
compose-goal = A goal: the scene as it stands is to be reached
compose-goal-how = Now drag the scene to where students begin. These parts are checked:
compose-add = Add a step where I am
compose-insert = Insert a step after step { $n }
compose-row = step { $n } of { $total }, { $title }, at { $at }
compose-own-scene = New scene from here
compose-own-scene-about = From now on this step has a scene of its own: what you drag in it changes no other step.
compose-how = What you change on the stage is the scene of this step from then on. In this list Insert adds a step, Delete takes one away, and Alt with ↑ ↓ moves it.
compose-lesson = Title of the lesson
compose-source = Where it comes from
compose-source-at-first = Made in Clipscope
compose-new-title = What happens here?
compose-has-goal = has a goal
compose-asks-first = asks first
compose-refused = That does not fit into the files of the lesson: a title is one line, a line that begins with # would begin another step, and each name comes once.
compose-form = The window cannot change lesson.toml in the form that it has: each step has to stand under a line [[step]].
compose-own-only = Only a lesson in a folder of yours can be changed. Copy this one to a folder first.
compose-mend-first = Mend the mistake first: steps come, go and move only in a lesson without one.
lesson-save = Save as a lesson…
lesson-copy = Copy this lesson to a folder…
lesson-save-title = A folder for the lesson
lesson-save-taken = There is a lesson in this folder already.
