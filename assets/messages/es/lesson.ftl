### The course panel and what it says about lesson files.

## Walking through the course

lesson-previous = Anterior
lesson-next = Siguiente
lesson-step = { $step } de { $total }
lesson-try = Pruébalo
lesson-question = Pregunta
lesson-answer = Respuesta
lesson-answer-show = Mostrar la respuesta
lesson-answer-hide = Ocultar la respuesta
lesson-spot-the-bug = Encuentra el error
lesson-changed = Has cambiado la escena de este paso.
lesson-restore = Restaurarla
lesson-not-translated = Este texto aún no está traducido.

## Lesson files

lesson-file-problem = { $file }, línea { $line }: { $problem }
lesson-empty = El curso no tiene lecciones.
