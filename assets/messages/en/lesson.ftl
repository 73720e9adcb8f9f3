### The course panel and what it says about lesson files.

## Walking through the course

lesson-question = What is asked
card-rule = Rule
card-formula = Formula
card-cost = Cost
card-pitfall = Take care
card-can = You can now
lesson-answer-show = Show the answer
lesson-answer-hide = Hide the answer
lesson-changed = This is your scene. The text is about the lesson’s own scene.
lesson-has-changes = has your changes
lesson-contents = All lessons, and the free scene
lesson-to-control = Press to see where this is set.
lesson-restore = Restore the lesson’s scene
lesson-not-translated = This text has not been translated yet.

## Lesson files

lesson-empty = The course has no lessons.
lesson-error = error
lesson-warning = warning

## What is wrong with a lesson file; the last part of the key is the problem’s code

problem-toml = This is not valid TOML.
problem-toml-deep = The values are nested too deeply.
problem-toml-comma = A comma is missing between two values.
problem-toml-extra = There is one “,” or “=” too many here.
problem-toml-number = A number cannot be written like this.
problem-toml-escape = This character cannot follow “\” in a text.
problem-toml-duplicate = This name is given twice.
problem-toml-value = This is not a value.
problem-toml-no-value = An “=” and a value are missing after the name.
problem-toml-name = A name cannot have this character.
problem-toml-unclosed = A closing { $closer } is missing.
problem-not-utf8 = The file is not UTF-8 text: the byte { $byte } does not belong here.
problem-course-file = This is no packed course: { $reason }
problem-course-version = The course was packed by another version of Clipscope: version { $version } cannot be read here.
problem-no-link = This is no link of Clipscope.
problem-link-version = The link was made by another version of Clipscope: { $version } cannot be read here.
problem-link-damaged = The link was cut short or changed: its scene cannot be unpacked.
problem-link-too-large = The scene in the link is too large.
problem-link-value = “{ $value }” means nothing as the “{ $key }” of a link.
problem-link-no-lesson = The course that is open has no lesson for “{ $name }”.
problem-link-no-step = The lesson has no step “{ $name }”.
problem-picture-without-link = The picture carries no link to a step.
problem-no-lessons = There is no lesson here.
problem-too-many-lessons = There are more than { $limit } lessons: the rest are left out.
problem-missing-file = This file is missing.
problem-unknown-language = “{ $name }” is not a language of the course.
problem-missing-language = There is no text in this language ({ $language }): English is shown instead.
problem-unknown-field = There is no field “{ $name }” here.
problem-missing-field = The field “{ $name }” is missing.
problem-wrong-type = The value is of the wrong type: it is { $found }.
problem-wrong-length =
    { $count ->
        [one] The list has the wrong length: { $count } value.
       *[other] The list has the wrong length: { $count } values.
    }
problem-not-finite = This must be a finite number.
problem-out-of-range = { $value } is out of range.
problem-empty-text = This text is empty.
problem-two-kinds-of-segments = Both “segments” and “random” are given: only one of the two may be.
problem-two-kinds-of-polygons = Both “polygon” and “random” are given: only one of the two may be.
problem-two-kinds-of-objects = Both “objects” and “street” are given: only one of the two may be.
problem-too-many-beside = Methods beside the first one: { $count }; at most { $most } fit there.
problem-too-few-places = Places given here: { $count }.
problem-two-openings = Both “fov_y_deg” and “height” are given: the first is for perspective, the second for a parallel camera.
problem-two-models = Both “solid” and “mesh” are given: only one of the two may be.
problem-two-meshes = Both “obj” and lists of numbers are given: only one of the two may be.
problem-no-picture = This is not a picture.
problem-mesh-plain = The mesh is drawn without its texture.
problem-too-many-texels = The textures of this file have { $count } texels together, more than { $limit }.
picture-elsewhere = “{ $name }” is not beside the mesh.
picture-unread = “{ $name }”: { $reason }
picture-no-material = “{ $library }” has no material “{ $name }”.
picture-broken = “{ $name }” is not a PNG or JPEG of at most { $most } texels a side, or it is broken.
problem-mesh-too-large = The list has { $count } entries, but a scene file holds at most { $limit }.
problem-no-such-mesh = There is no mesh “{ $name }” beside this file.
problem-unknown-method = There is no method “{ $name }”.
problem-unknown-lab = There is no lab “{ $name }”.
problem-unknown-control = The lab has no control “{ $name }”.
problem-unknown-scene = There is no scene “{ $name }”.
problem-unknown-lock = There is no handle “{ $name }”.
problem-unknown-value = “{ $name }” is not one of the values that this field takes.
problem-no-steps = The lesson has no steps.
problem-too-many-steps = The lesson has { $count } steps, more than { $limit }.
problem-bad-step-id = “{ $name }” cannot be the id of a step.
problem-duplicate-step = There are two steps “{ $name }”.
problem-bad-figure = “{ $name }” cannot be the name of a figure.
problem-duplicate-figure = There are two figures “{ $name }”.
problem-moment-never-happens = The moment “{ $name }” never happens in the run of this scene.
problem-unused-scene = No step shows this scene.
problem-bad-reference = This reference cannot be read.
problem-reference-outside = The title of a lesson cannot have a reference.
problem-unknown-name = No value is called “{ $name }” at this step.
problem-no-value = “{ $name }” is not a value that a sentence can say.
problem-unknown-form = A number has no form “{ $name }”.
problem-like-itself = The scene “{ $name }” takes itself as its model.
problem-missing-title = The text has no title.
problem-second-title = A lesson has one title, at the top.
problem-bad-heading = This heading does not say which step it belongs to.
problem-text-outside = This text belongs to no step.
problem-unknown-step = The lesson has no step “{ $name }”.
problem-missing-section = The text of the step “{ $name }” is missing.
problem-duplicate-section = The step “{ $name }” has two texts.
problem-empty-section = The step “{ $name }” has a heading but no text.
problem-long-paragraph = The paragraph has { $count } characters, more than { $limit }.
problem-unsupported-markdown = This kind of Markdown cannot be used in a lesson.
problem-stray-emphasis = These asterisks do not make the text bold.
problem-stale-translation = The English of “{ $name }” has changed since it was translated.
expect-translated = Translate it anew, then run “clipscope check FOLDER --translated”.
problem-stray-claim = This claim does not stand under a step's heading.
expect-claim = Write one paragraph that begins with “=> ” right under the heading “## id: Title”.
problem-stray-sides = The line “=| … | …” does not name the two drawings of a step.
expect-sides = Under the claim of a step with `before`, write “=| ” and two names with “ | ” between them: how it was, how it is.
problem-bad-card = This is no card.
expect-card = Write “## card” at the end of the file, and under it a list: rule, formula, cost, two or more times pitfall, and can, such as “- rule: …”. A card has no references.
problem-stray-note = This note for the speaker would be read by all.
problem-more =
    { $count ->
        [one] { $count } more problem in this file is not shown.
       *[other] { $count } more problems in this file are not shown.
    }

## What was expected in its place

expect-did-you-mean = Did you mean “{ $name }”?
expect-one-of = Expected: one of { $names }.
expect-toml-value = Expected: text in straight "quotation marks", a number, true or false, or a list with commas between its values.
expect-toml-name = Expected: the letters a–z and A–Z, digits, “-” and “_”.
expect-utf8 = Expected: text saved as UTF-8.
expect-link = Expected: “#lesson/step” or “#v1=” and a scene, with or without an address in front.
expect-lesson-folder = Expected: a folder with lesson.toml and en.md, or a folder of such folders.
expect-text = Expected: text in quotation marks.
expect-number = Expected: a number.
expect-whole = Expected: a whole number from { $min } to { $max }.
expect-table = Expected: a table of fields.
expect-window = Expected: [xmin, ymin, xmax, ymax], with xmin < xmax and ymin < ymax.
expect-point = Expected: the two numbers of a point, [x, y].
expect-segment = Expected: the four numbers of a segment, [x1, y1, x2, y2].
expect-segments = Expected: a list of segments, [[x1, y1, x2, y2], …], or “random” with “count” and “seed”.
expect-clip = Expected: at least three vertices of a convex polygon, [[x, y], …], in either direction.
expect-polygon = Expected: at least three vertices of a polygon, [[x, y], …].
expect-holes = Expected: a list of holes, each a list of at least three vertices, [[[x, y], …], …].
expect-place = Expected: the three numbers of a place, [x, y, z].
expect-space-segment = Expected: the two ends of a segment, [[x, y, z], [x, y, z]].
expect-space-triangle = Expected: the three vertices of a triangle, [[x, y, z], [x, y, z], [x, y, z]].
expect-camera = Expected: position, target, up, fov_y_deg (or height), aspect, near and far, with 0 < near < far in perspective.
expect-eye = Expected: pitch_deg from −89 to 89, distance from 1e-6 to 1e6, fov_y_deg from 1 to 120.
expect-objects = Expected: a list of objects, [{ "{" } solid = "cube", at = [x, y, z], size = 1 { "}" }, …], or “street” with “count” and “seed”.
expect-mesh = Expected: name, vertices [[x, y, z], …] and faces [[i, j, k], …], whose indices count from 0; there can also be uvs [[u, v], …], one for each vertex. In place of the lists there can be obj, the text of an OBJ file; picture is its texture, a PNG or JPEG file in base64.
expect-opacity = Expected: a number from 0, which is not seen, to 1, which hides all behind it.
expect-picture = Expected: a PNG or a JPEG file in base64.
expect-pixel = Expected: a pixel [column, row], counted from 0 at the top left.
expect-mesh-file = Expected: the name of an OBJ file in the lesson’s folder, such as "cow.obj", or a table with name, vertices and faces.
expect-steps = Expected: at least one [[step]].
expect-kebab = Expected: lower-case letters and digits, joined by single hyphens: nine-regions.
expect-figure = Expected: at most 64 lower-case letters, digits and hyphens: nine-regions.
expect-first-here = The first one is in line { $line }.
expect-first-scene = The first step must name its scene; later steps keep it.
expect-moment = Expected: start, end, or an event with its words, such as “cut left”.
expect-moments = Expected: a list of moments, such as ["cut left"].
expect-moment-number = Expected: a number from 1 after “#”.
expect-reference = Expected: a value in braces, such as { "{" }u_min{ "}" }, { "{" }P₁.x @ end{ "}" } or { "{" }output.segment[2] of practice : 2{ "}" }.
expect-locks = Expected: a list of the handles that are locked, such as ["window"].
expect-drags = Expected: a list of the handles that the text asks for, such as ["far"].
expect-title = Expected: “# Title of the lesson” in the first line.
expect-heading = Expected: a heading “## id: Title” for each step, with its text below.
expect-section = Expected: “## { $name }: Title” after this, with its text below.
expect-markdown = Expected: paragraphs, **bold**, *italics*, `code`, lists, code blocks, and a block quote for an answer.
expect-emphasis = Expected: **bold**, with no space inside the asterisks; next to a Chinese character, move punctuation outside them.
expect-note = Expected: a paragraph of its own, outside lists and answers, in which every line begins with “!> ”.

## What a value is

type-text = a text
type-integer = a whole number
type-float = a number with decimals
type-boolean = true or false
type-date = a date or time
type-list = a list
type-table = a table of fields

## Mesh files

problem-no-number = “{ $word }” is not a finite number.
problem-too-few-numbers = Numbers in this line: only { $count } of { $needed }.
problem-no-such-vertex = There is no vertex { $index }: the file has { $count }.
problem-no-such-uv = There are no texture coordinates { $index }: the file has { $count }. The face is drawn without them.
problem-face-too-short = This face has only { $count ->
        [one] { $count } vertex
       *[other] { $count } vertices
    }: it is left out.
problem-face-too-long = This face has { $count } vertices, more than { $limit }: it is left out.
problem-face-not-simple = This face crosses itself or has no area: it is left out.
problem-flat-faces =
    { $count ->
        [one] { $count } triangle has no area: it cannot be seen.
       *[other] { $count } triangles have no area, the first of them here: they cannot be seen.
    }
problem-no-faces = The file has no face that can be drawn.
problem-too-many-faces = The file has more than { $limit } triangles: it is too large to be drawn.
expect-obj-index = Expected: 1 for the first vertex of the file, 2 for the next; −1 for the one before this line.

problem-nothing-asked = The run of this step makes no decision before the step stops.
expect-ask = Expected: true, false or "run".
expect-decision = Expected: a moment at a decision, or after one.
problem-goal-missed = Part { $count } of the goal does not hold of the scene that is said to reach it.
problem-goal-met = The goal holds of the step’s own scene.
expect-reached = Expected: the name of a scene of which all parts of the goal hold, while they do not all hold of the step’s own scene.
problem-goal-parts = The goal has { $count } parts, and { $limit } at most.
expect-goal = Expected: a list of conditions, such as ["output.visible = false", "events(cut) = 1"].
goal-words-visible = Something is visible
goal-words-invisible = Nothing is visible
goal-words-output = The answer’s “{ $name }” is “{ $value }”
goal-words-event = At “{ $event }” number { $nth }, “{ $name }” is “{ $value }”
goal-words-count =
    { $count ->
        [one] The run has { $count } step “{ $name }”
       *[other] The run has { $count } steps “{ $name }”
    }
problem-goal-text = Step “{ $name }” has { $count } goal lines, and { $limit } conditions in lesson.toml.
expect-goal-text = Expected: one line “- [ ] …” for each condition.

handout-work-out = To work out
handout-open = This step opens with { $link }
handout-kept = What to keep
