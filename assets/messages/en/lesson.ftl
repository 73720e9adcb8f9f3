### The course panel and what it says about lesson files.

## Walking through the course

lesson-previous = Previous
lesson-next = Next
lesson-step = { $step } of { $total }
lesson-try = Try it
lesson-question = Question
lesson-answer = Answer
lesson-answer-show = Show the answer
lesson-answer-hide = Hide the answer
lesson-spot-the-bug = Spot the bug
lesson-changed = You have changed the scene of this step.
lesson-restore = Restore it
lesson-not-translated = This text has not been translated yet.

## Lesson files

lesson-file-problem = { $file }, line { $line }: { $problem }
lesson-empty = The course has no lessons.
