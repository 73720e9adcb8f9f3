### What the command line says to people, on the standard error; its JSON is not translated.

## Results

cli-exported =
    { $count ->
        [1] { $count } figura exportada para { $path }
       *[other] { $count } figuras exportadas para { $path }
    }
cli-handouts =
    { $count ->
        [1] { $count } apostila escrita em { $path }
       *[other] { $count } apostilas escritas em { $path }
    }
cli-exported-slides =
    { $count ->
        [1] { $count } página de slides escrita em { $path }
       *[other] { $count } páginas de slides escritas em { $path }
    }
cli-checked =
    { $count ->
        [1] { $count } lição sem erros
       *[other] { $count } lições sem erros
    }
cli-checked-scenes =
    { $count ->
        [1] { $count } arquivo de cena sem erros
       *[other] { $count } arquivos de cena sem erros
    }
cli-refused =
    { $count ->
        [1] { $count } entrada foi recusada
       *[other] { $count } entradas foram recusadas
    }
cli-untranslated =
    { $count ->
        [1] nota: { $count } lição mostra o inglês no lugar de { $languages }; esses idiomas são opcionais
       *[other] nota: { $count } lições mostram o inglês no lugar de { $languages }; esses idiomas são opcionais
    }
cli-unreadable = Não foi possível ler { $path }: { $reason }
export-same-name = { $first } e { $second } seriam ambos { $path }: nada foi desenhado.
handout-of-scene = { $name } é uma cena; apostilas são feitas de lições. Nada foi desenhado.
export-no-moment = Em { $path } o momento “{ $moment }” nunca chega. Nada foi desenhado.
export-no-loop = Um laço mostra figuras: --format { $format } não vai com --window nem com --questions. Nada foi desenhado.
export-window-is-pixels = Uma janela inteira é feita de pixels: --window só vai com --format png, não com { $format }. Nada foi desenhado.

## Wrong usage

usage-no-such-command = Não existe o comando “{ $name }”.
usage-no-such-argument = “{ $name }” não é aceito aqui.
usage-value-missing = { $name } precisa de um valor.
usage-wrong-value = { $name } não pode ser “{ $value }”.
usage-argument-missing = Falta { $name }.
usage-conflict = { $name } não pode ser usado com { $other }.
usage-expected = Valores possíveis: { $expected }.
usage-expected-size = Esperava-se LARGURAxALTURA, de 64x64 a { $most }, como 1920x1080.
usage-expected-steps = Esperado: figures, all ou dois momentos como start..end.
usage-expected-scale = Esperava-se um número de 0.25 a 8.
usage-see-help = --help mostra os comandos e opções, com exemplos.

## What the refusal of a case says; the JSON answer has the English sentence

case-bad-json = Não é JSON válido: veja a coluna { $column }.
case-not-utf8 = A linha não é UTF-8: veja o byte { $byte }.
case-line-too-long = A linha tem mais de { $max } MiB.
case-bad-id = O id está aninhado em excesso ou contém um texto que não é Unicode.
case-repeated-field = O campo “{ $name }” aparece duas vezes.
case-unknown-algorithm = Não há nenhum algoritmo “{ $name }”. Disponíveis: { $expected }.
case-meant-algorithm = Não existe o algoritmo “{ $name }”. Você quis dizer “{ $meant }”? Disponíveis: { $expected }.
case-unknown-field = Não há nenhum campo “{ $name }” em { $algorithm }. Ele aceita: { $expected }.
case-missing-field = Falta o campo “{ $name }”.
case-missing-choice = Falta um destes campos: { $fields }.
case-both = “{ $one }” já foi dado: informe “{ $one }” ou “{ $other }”, não ambos.
case-wrong-type = Esperava-se { $expected }, mas há { $found }.
case-wrong-word = Esperava-se um de { $expected }, mas há “{ $found }”.
case-wrong-length = Esperavam-se { $expected } números, mas há { $found }.
case-wrong-points = Eram esperados { $expected } pontos, e há { $found }.
case-no-planes = Era esperado pelo menos um plano.
case-zero-direction = A direção de visão não pode ser zero.
case-not-finite = { $number } excede o intervalo de um número de 64 bits: toda coordenada deve ser finita.
case-beyond-range = Com { $number }, um número da resposta excederia o intervalo dos números de 64 bits.
case-step-beyond-range = Com { $number }, um número de um passo excederia o intervalo dos números de 64 bits. Com --events false só a resposta é dada.
case-too-many = A lista tem { $found } itens: um relatório de todos os passos aceita no máximo { $max }. Com --events false qualquer número é aceito, e só a resposta é dada.
case-too-many-pairs = { $found } pares de aresta e aresta de recorte: um relatório de todos os passos aceita no máximo { $max }. Com --events false qualquer quantidade é aceita, e só a resposta é dada.
case-uv-length = Era esperado um [u, v] para cada um dos { $expected } vértices; há { $found }.
case-tints-length = Era esperado um [opacidade, brilho] para cada um dos { $expected } triângulos; há { $found }.
object-triangles = triângulos
object-object = objeto
object-tints = Opacidade e brilho
case-too-many-raster-pixels = { $found } pixels: um relatório de cada passo aceita no máximo { $max }. Com --events false qualquer número é aceito, e só a resposta é dada.
case-too-many-steps = { $found } passos: um relatório aceita no máximo { $max }. Com --events false qualquer número é aceito, e só a resposta é dada.
case-over-budget = A execução teria mais de { $max } passos, que é o limite deste algoritmo em qualquer computador.
case-too-many-fragments = Os triângulos cobrem { $found } pixels, contando também os que ficam atrás de outros: são desenhados no máximo { $max }.
json-number = um número
json-numbers = uma lista de números
json-points = uma lista de pontos
json-text = um texto
json-list = uma lista
json-object = um objeto
json-bool = verdadeiro ou falso
json-null = null

## The answer to a case

case-visible = Visível de { $p1 } até { $p2 }.
case-touch = Visível em um único ponto: { $at }.
case-invisible = Nada é visível.
case-nothing-left = Não resta nada.
case-no-area = O que resta não tem área: não há nada a preencher.
case-cull-inside = Dentro: nenhum plano o corta.
case-cull-outside = Fora: o plano { $plane } o descarta, a uma distância de { $distance }.
case-box-outside = Fora: os oito vértices estão do lado de fora de um mesmo plano.
case-cull-straddles = Cruza algum plano: pelo menos um o corta e nenhum o descarta.
case-cull-in-vain = Pelo teste dos planos, cruza algum deles e, no entanto, nenhum ponto seu está dentro: é mantido em vão.
case-front = Mostra a frente: n·e = { $dot }.
case-back = Não mostra a frente: n·e = { $dot }.
case-polygons =
    { $n ->
        [1] Um polígono: { $rings }
       *[other] { $n } polígonos: { $rings }
    }
case-surfaces-seen = Pixels que mostram uma superfície: { $seen } de { $pixels }.
case-painted = Pintados nesta ordem: { $ids }.
case-painter-cycle = Nenhuma ordem está certa: cada um de { $ids } deve ser pintado antes do seguinte, e o último antes do primeiro.
case-bsp-pieces = Peças da árvore: { $pieces }. Pixels que mostram uma superfície: { $seen } de { $pixels }.
case-occlusion = Pixels que mostram um objeto: { $seen } de { $pixels }. Objetos ignorados: { $skipped } de { $objects }.
case-bsp-too-large = Os planos cortariam estes triângulos em mais de { $pieces } peças, ou classificariam peças mais de { $questions } vezes: não se constrói uma árvore de tantas.
case-triangles =
    { $n ->
        [1] Um triângulo: { $triangles }
       *[other] { $n } triângulos: { $triangles }
    }

## Reports: the step table of a case

report-title = Gabarito
worksheet-title = Folha de exercícios
worksheet-how = Preencha o que cada passo encontra. Onde houver caixas, marque a que for verdadeira.
report-case = Caso { $number }
report-case-id = Caso { $number } ({ $id })
report-source = fonte
report-symbols = símbolos
case-symbols-weiler-atherton = a₁, a₂: distâncias dos extremos da aresta a recortar à reta da aresta de recorte, vezes o comprimento desta; > 0 à sua esquerda, que é dentro. t, u: onde as duas arestas se encontram, na aresta a recortar e na de recorte, de 0 no início a 1 no fim.
report-step = passo
report-what = o que acontece
report-formula = fórmula
report-changed = valores novos
report-answer = Resposta:
report-row = { $name }: { $values }
report-noted = { $value } ({ $note })

## The trace, check and list commands

trace-refused-at = linha { $line } ({ $case }): { $problem }
trace-more-refused = e mais { $count }
trace-from-terminal = Lendo casos do teclado, um por linha; Ctrl+D encerra.
trace-not-written = Não foi possível escrever as respostas: { $reason }
list-algorithms = Algoritmos que os casos aceitam
list-lessons = Lições
list-figure = figura { $name }
cli-no-lesson = Não há nenhuma lição “{ $name }”: não é um caminho nem uma lição do curso. Veja clipscope list.
grade-score = Casos respondidos corretamente: { $right } de { $cases }.
grade-case = caso { $number }
grade-case-named = caso { $number } ({ $name })
grade-no-case = nenhum caso
grade-unlisted = { $count ->
        [0] Mais { $count } diferenças são contadas, e não estão na lista.
        [1] Mais { $count } diferença é contada, e não está na lista.
       *[other] Mais { $count } diferenças são contadas, e não estão na lista.
    }
grade-output = { $place } é { $truth }; o programa diz { $said }.
grade-output-missing = Na resposta falta { $place }, que é { $truth }.
grade-output-spare = A resposta tem { $place } = { $said }, e a verdadeira não tem.
grade-field = { $place } é { $said }, e o verdadeiro é { $truth }.
grade-field-missing = Falta { $place }, e o verdadeiro é { $truth }.
grade-field-spare = { $place } é { $said }, e um evento assim não tem { $place }.
grade-step-differs = O passo { $step }, “{ $said }”, é o primeiro que difere: { $what }
grade-step-other = O passo { $step } é o primeiro que difere: o programa faz “{ $said }”, e o verdadeiro é “{ $truth }”.
grade-step-missing = O programa para depois do passo { $step }: em seguida vem “{ $truth }”.
grade-step-extra = O passo { $step }, “{ $said }”, sobra: não há mais nada a fazer.
grade-steps-swapped = Os passos { $step } e { $next } estão trocados: “{ $truth }” vem antes de “{ $said }”.
grade-step-unreadable = O passo { $step } não é um evento: espera-se um objeto com o texto “event”.
grade-missing = O programa não dá resposta a este caso.
grade-extra = A linha { $line } das respostas não é de nenhum caso: o id é desconhecido, ou o caso já tem uma resposta.
grade-bad-json = Não é possível ler a linha { $line } das respostas. { $problem }
grade-no-object = É JSON válido, mas não um objeto.
grade-refuses = O programa recusa este caso, que tem uma resposta.
grade-refusable = O programa responde a este caso, que é recusado ({ $code }).
grade-mistake = É exatamente o que resulta de um erro conhecido: “{ $mistake }”.
mistake-slope-turned-over = a inclinação está invertida, Δx/Δy em lugar de Δy/Δx
grade-both-stdin = Os casos e as respostas não podem vir ambos da entrada padrão.
grade-one-at-a-time = Este relatório trata de uma só entrega, e as respostas são de várias: --report json ou text tem um relatório para cada uma.
grade-not-written = Não foi possível gravar { $path }: { $reason }
grade-no-report = { $path }, linha { $line }: isto não é um relatório de “clipscope grade --report json”.
usage-expected-tolerance = Espera-se um número que não seja negativo, como 1e-9.
grade-mark-true = verdadeiro: { $at }
grade-mark-said = o do programa: { $at }
grade-raster-true = os pixels certos
grade-raster-said = os do programa (diferentes: { $count }, o primeiro { $at })
grade-title-event = O primeiro passo errado: { $event }
grade-title-output = A primeira resposta que difere
grade-title-none = O primeiro caso sem uma resposta correta
grade-title-extra = Uma resposta a nenhum caso
grade-figure-said = O programa disse
grade-figure-true = O verdadeiro é
grade-figure-nothing = nada
grade-figure-cases = todos os casos na sua ordem
grade-figure-plain = Este caso é mostrado apenas em números.

table-file = arquivo
table-score = pontuação

pack-one-folder = Uma página aceita um só curso: indique uma única pasta.
pack-too-many =
    As marcas destas lições ocupam { $count } caracteres, e o SCORM 1.2 guarda { $most } de cada estudante: faça pacotes com menos lições.
