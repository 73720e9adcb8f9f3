### What the command line says to people, on the standard error; its JSON is not translated.

## Results

cli-exported =
    { $count ->
        [one] { $count } figure exported to { $path }
       *[other] { $count } figures exported to { $path }
    }
cli-handouts =
    { $count ->
        [one] { $count } handout written to { $path }
       *[other] { $count } handouts written to { $path }
    }
cli-exported-slides =
    { $count ->
        [one] { $count } page of slides written to { $path }
       *[other] { $count } pages of slides written to { $path }
    }
cli-checked =
    { $count ->
        [one] { $count } lesson without errors
       *[other] { $count } lessons without errors
    }
cli-checked-scenes =
    { $count ->
        [one] { $count } scene file without errors
       *[other] { $count } scene files without errors
    }
cli-refused =
    { $count ->
        [one] { $count } input was refused
       *[other] { $count } inputs were refused
    }
cli-untranslated =
    { $count ->
        [one] hint: { $count } lesson shows English in place of { $languages }; these languages are optional
       *[other] hint: { $count } lessons show English in place of { $languages }; these languages are optional
    }
cli-unreadable = { $path } could not be read: { $reason }
export-same-name = { $first } and { $second } would both be { $path }: nothing has been drawn.
handout-of-scene = { $name } is a scene; a handout is made of lessons. Nothing has been drawn.
export-no-moment = In { $path } the moment “{ $moment }” never comes. Nothing has been drawn.
export-no-loop = A loop shows figures: --format { $format } goes with neither --window nor --questions. Nothing has been drawn.
export-window-is-pixels = A whole window is pixels: --window goes with --format png alone, not with { $format }. Nothing has been drawn.

## Wrong usage

usage-no-such-command = There is no command “{ $name }”.
usage-no-such-argument = “{ $name }” is not accepted here.
usage-value-missing = { $name } needs a value.
usage-wrong-value = { $name } cannot be “{ $value }”.
usage-argument-missing = { $name } is missing.
usage-conflict = { $name } cannot be used with { $other }.
usage-expected = Possible values: { $expected }.
usage-expected-size = Expected WIDTHxHEIGHT, from 64x64 to { $most }, such as 1920x1080.
usage-expected-steps = Expected figures, all, or two moments such as start..end.
usage-expected-scale = Expected a number from 0.25 to 8.
usage-see-help = --help shows the commands and options, with examples.

## What the refusal of a case says; the JSON answer has the English sentence

case-bad-json = This is not valid JSON: see column { $column }.
case-not-utf8 = The line is not UTF-8: see byte { $byte }.
case-line-too-long = The line is longer than { $max } MiB.
case-bad-id = The id is nested too deep, or holds a text that is not Unicode.
case-repeated-field = The field “{ $name }” is given twice.
case-unknown-algorithm = There is no algorithm “{ $name }”. Known: { $expected }.
case-meant-algorithm = There is no algorithm “{ $name }”. Did you mean “{ $meant }”? Known: { $expected }.
case-unknown-field = There is no field “{ $name }” for { $algorithm }. It takes: { $expected }.
case-missing-field = The field “{ $name }” is missing.
case-missing-choice = One of these fields is missing: { $fields }.
case-both = “{ $one }” is given already: give “{ $one }” or “{ $other }”, not both.
case-wrong-type = Expected { $expected }, found { $found }.
case-wrong-word = Expected one of { $expected }, found “{ $found }”.
case-wrong-length = Expected { $expected } numbers, found { $found }.
case-wrong-points = Expected { $expected } points, found { $found }.
case-no-planes = Expected at least one plane.
case-zero-direction = The direction of view must not be zero.
case-not-finite = { $number } is beyond the range of a 64-bit number: every coordinate must be finite.
case-beyond-range = With { $number } a number of the answer would be beyond the range of 64-bit numbers.
case-step-beyond-range = With { $number } a number of a step would be beyond the range of 64-bit numbers. With --events false the answer is given alone.
case-too-many = The list has { $found } entries: a report of every step takes at most { $max }. With --events false any number is taken, and the answer given alone.
case-too-many-pairs = { $found } pairs of an edge and a clip edge: a report of every step takes at most { $max }. With --events false any number is taken, and the answer given alone.
case-uv-length = Expected one [u, v] for each of the { $expected } vertices, found { $found }.
case-tints-length = Expected one [opacity, brightness] for each of the { $expected } triangles, found { $found }.
object-triangles = triangles
object-object = object
object-tints = Opacity and brightness
case-too-many-raster-pixels = { $found } pixels: a report of every step takes at most { $max }. With --events false any number is taken, and the answer given alone.
case-too-many-steps = { $found } steps: a report takes at most { $max }. With --events false any number is taken, and the answer given alone.
case-over-budget = The run would have more than { $max } steps, which is the limit of this algorithm on every machine.
case-too-many-fragments = The triangles cover { $found } pixels, those behind others counted too: at most { $max } are drawn.
json-number = a number
json-numbers = a list of numbers
json-points = a list of points
json-text = a text
json-list = a list
json-object = an object
json-bool = true or false
json-null = null

## The answer to a case

case-visible = Visible from { $p1 } to { $p2 }.
case-touch = Only one point is visible: { $at }.
case-invisible = Nothing is visible.
case-nothing-left = Nothing is left.
case-no-area = What is left has no area: there is nothing to fill.
case-cull-inside = Inside: no plane cuts it.
case-cull-outside = Outside: plane { $plane } rejects it, at the distance { $distance }.
case-box-outside = Outside: all eight corners are outside one plane.
case-cull-straddles = It straddles: at least one plane cuts it, and no plane rejects it.
case-cull-in-vain = By the planes it straddles, and yet no point of it is inside: it is kept for nothing.
case-front = It shows its front: n·e = { $dot }.
case-back = It does not show its front: n·e = { $dot }.
case-polygons =
    { $n ->
        [one] One polygon: { $rings }
       *[other] { $n } polygons: { $rings }
    }
case-surfaces-seen = Pixels that show a surface: { $seen } of { $pixels }.
case-painted = Painted in this order: { $ids }.
case-painter-cycle = No order is right: each of { $ids } must be painted before the next, and the last before the first.
case-bsp-pieces = Pieces in the tree: { $pieces }. Pixels that show a surface: { $seen } of { $pixels }.
case-occlusion = Pixels that show an object: { $seen } of { $pixels }. Objects skipped: { $skipped } of { $objects }.
case-bsp-too-large = The planes would cut these triangles into more than { $pieces } pieces, or sort pieces more than { $questions } times: no tree is built of so many.
case-triangles =
    { $n ->
        [one] One triangle: { $triangles }
       *[other] { $n } triangles: { $triangles }
    }

## Reports: the step table of a case

report-title = Answer key
worksheet-title = Worksheet
worksheet-how = Fill in what each step finds. Where there are boxes, tick the one that is true.
report-case = Case { $number }
report-case-id = Case { $number } ({ $id })
report-source = source
report-symbols = symbols
case-symbols-weiler-atherton = a₁, a₂: the distances of the ends of the subject’s edge from the line of the clip edge, times the length of the clip edge; > 0 on its left, which is inside. t, u: where the two edges meet, on the subject’s edge and on the clip edge, from 0 at the start to 1 at the end.
report-step = step
report-what = what happens
report-formula = formula
report-changed = new values
report-answer = Answer:
report-row = { $name }: { $values }
report-noted = { $value } ({ $note })

## The trace, check and list commands

trace-refused-at = line { $line }, { $case }: { $problem }
trace-more-refused =
    { $count ->
        [one] and { $count } more
       *[other] and { $count } more
    }
trace-from-terminal = Reading cases from the keyboard, one per line; Ctrl+D ends.
trace-not-written = The answers could not be written: { $reason }
list-algorithms = Algorithms that cases can name
list-lessons = Lessons
list-figure = figure { $name }
cli-no-lesson = There is no lesson “{ $name }”: neither a path nor a lesson of the course. See clipscope list.
grade-score = { $right } of { $cases } { $cases ->
        [one] case is
       *[other] cases are
    } answered correctly.
grade-case = case { $number }
grade-case-named = case { $number } ({ $name })
grade-no-case = no case
grade-unlisted = { $count ->
        [one] One more difference is counted, not listed.
       *[other] { $count } more differences are counted, not listed.
    }
grade-output = { $place } is { $truth }; the program says { $said }.
grade-output-missing = The answer lacks { $place }, which is { $truth }.
grade-output-spare = The answer has { $place } = { $said }, and the true one has not.
grade-field = { $place } is { $said }, and { $truth } is true.
grade-field-missing = { $place } is missing, and { $truth } is true.
grade-field-spare = { $place } is { $said }, and such an event has no { $place }.
grade-step-differs = Step { $step }, “{ $said }”, is the first that differs: { $what }
grade-step-other = Step { $step } is the first that differs: the program does “{ $said }”, and “{ $truth }” is true.
grade-step-missing = The program stops after step { $step }: “{ $truth }” comes next.
grade-step-extra = Step { $step }, “{ $said }”, is one too many: nothing is left to do.
grade-steps-swapped = Steps { $step } and { $next } change places: “{ $truth }” comes before “{ $said }”.
grade-step-unreadable = Step { $step } is no event: an object with the text “event” is expected.
grade-missing = The program gives no answer to this case.
grade-extra = Line { $line } of the answers belongs to no case: its id is unknown, or the case has an answer already.
grade-bad-json = Line { $line } of the answers cannot be read. { $problem }
grade-no-object = This is valid JSON, but not an object.
grade-refuses = The program refuses this case, which has an answer.
grade-refusable = The program answers this case, which is refused ({ $code }).
grade-mistake = Exactly this comes out with a known mistake: “{ $mistake }”.
mistake-slope-turned-over = the slope is turned over, Δx/Δy in place of Δy/Δx
grade-both-stdin = Cases and answers cannot both come from standard input.
grade-one-at-a-time = This report is about one submission, and the answers are of several: --report json or text has a report for each.
grade-not-written = { $path } could not be written: { $reason }
grade-no-report = { $path }, line { $line }: this is no report of “clipscope grade --report json”.
usage-expected-tolerance = Expected: a number that is not negative, such as 1e-9.
grade-mark-true = true: { $at }
grade-mark-said = the program’s: { $at }
grade-raster-true = the true pixels
grade-raster-said = the program’s (different: { $count }, the first { $at })
grade-title-event = First wrong step: { $event }
grade-title-output = The first answer that differs
grade-title-none = The first case without a right answer
grade-title-extra = An answer to no case
grade-figure-said = The program said
grade-figure-true = True is
grade-figure-nothing = nothing
grade-figure-cases = all cases in their order
grade-figure-plain = This case is drawn in numbers only.

table-file = file
table-score = score

pack-one-folder = A page takes one course: name one folder.
pack-too-many =
    These lessons have { $count } characters of marks, and SCORM 1.2 keeps { $most } of a student: make packages of fewer lessons.
