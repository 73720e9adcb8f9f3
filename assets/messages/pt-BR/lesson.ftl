### The course panel and what it says about lesson files.

## Walking through the course

lesson-previous = Anterior
lesson-next = Próximo
lesson-step = { $step } de { $total }
lesson-try = Experimente
lesson-question = Pergunta
lesson-answer = Resposta
lesson-answer-show = Mostrar a resposta
lesson-answer-hide = Ocultar a resposta
lesson-spot-the-bug = Encontre o erro
lesson-changed = Você alterou a cena deste passo.
lesson-restore = Restaurá-la
lesson-not-translated = Este texto ainda não foi traduzido.

## Lesson files

lesson-file-problem = { $file }, linha { $line }: { $problem }
lesson-empty = O curso não tem lições.
