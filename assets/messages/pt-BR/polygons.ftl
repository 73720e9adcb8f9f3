# O laboratório de polígonos.

handle-clip-vertex = vértice { $number } do polígono de recorte
handle-hole-vertex = vértice { $number } do furo { $hole }
handle-polygon = o polígono
texture-title = Textura
texture-none = nenhuma
texture-interpolated = interpolada com t
texture-kept = sem interpolar (errada)
part-subject = o polígono sujeito
part-hole = um furo
part-clip = o polígono de recorte
refused-not-convex = Este algoritmo exige uma região de recorte convexa: { $part } vira para o lado errado em { $vertex }.
refused-winds-twice = Este algoritmo exige um contorno simples: { $part } já deu mais de uma volta em { $vertex }.
refused-degenerate = Não há nada a recortar: { $part } não tem área.

## Sutherland–Hodgman

alg-sutherland-hodgman = Sutherland–Hodgman
alg-sutherland-hodgman-pipeline = Sutherland–Hodgman, em pipeline
rule-in-in = dentro → dentro
rule-in-out = dentro → fora
rule-out-in = fora → dentro
rule-out-out = fora → fora
sh-inside = dentro
sh-outside = fora
sh-bridge = ponte
sh-opening = O polígono inteiro, { $n } vértices, é recortado contra uma borda da região após a outra: { $edges } bordas.
sh-edge-side = Recorte contra a { $edge }: dentro é { $inside }.
sh-edge = Recorte contra { $edge }: dentro é { $inside }.
sh-first-inside = O primeiro vértice, { $vertex }, está dentro: é emitido.
sh-first-outside = O primeiro vértice, { $vertex }, está fora: nada é emitido.
sh-in-in = { $from } → { $to }: dentro → dentro. Emite-se { $to }.
sh-in-out = { $from } → { $to }: dentro → fora. Emite-se a interseção I.
sh-in-out-touch = { $from } → { $to }: dentro → fora. { $from } está sobre a borda e é a própria interseção: já está na lista.
sh-out-in = { $from } → { $to }: fora → dentro. Emitem-se a interseção I e depois { $to }.
sh-out-in-touch = { $from } → { $to }: fora → dentro. { $to } está sobre a borda e é a própria interseção: emite-se uma só vez.
sh-out-out = { $from } → { $to }: fora → fora. Nada é emitido.
sh-closing-cross = A aresta de fechamento { $from } → { $to }: { $rule }. Emite-se só a interseção I.
sh-closing = A aresta de fechamento { $from } → { $to }: { $rule }. Nada mais é emitido.
sh-cross = { $from } → { $to } cruza { $border } em I.
sh-output = { $vertex } entra na lista de saída como { $place }.
sh-pass = { $border } está pronto: a lista de saída, de comprimento { $n }, é a próxima lista de entrada.
sh-pass-empty = { $border } está pronto: a lista de saída tem comprimento { $n }. Não resta nada a recortar.
sh-done-empty = Fim: nada do polígono está na região. Comprimento da última lista: { $n }; bordas de recorte: { $edges }.
sh-done-whole = Fim: os { $n } vértices estão dentro das { $edges } bordas. O polígono fica como estava.
sh-done-cut = Fim após { $edges } bordas: resta um anel de { $n } vértices.
sh-done-degenerate = Fim após { $edges } bordas: o que resta não tem área. Comprimento da última lista: { $n }.
code-sh-each = para cada borda de recorte: saída ← vazia
code-sh-first = F ← primeiro vértice; se está dentro: emita F
code-sh-edges = para cada aresta S → P, a última até F:
code-sh-in-in = dentro → dentro: emita P
code-sh-in-out = dentro → fora: emita I
code-sh-out-in = fora → dentro: emita I, P
code-sh-out-out = fora → fora: não emita nada
code-sh-pass = entrada ← saída
words-sh-each = Tome as bordas da região de recorte uma a uma, cada uma com uma lista de saída vazia.
words-sh-first = Emita o primeiro vértice se ele estiver dentro.
words-sh-edges = Depois siga o contorno, aresta por aresta, e feche-o; na aresta de fechamento F não é emitido de novo.
words-sh-in-in = A aresta continua dentro: emita o seu fim.
words-sh-in-out = A aresta sai: emita a interseção.
words-sh-out-in = A aresta entra: emita a interseção e depois o seu fim.
words-sh-out-out = A aresta continua fora: não emita nada.
words-sh-pass = O que foi emitido é o polígono para a borda seguinte; após a última borda, é a resposta.

## Sutherland–Hodgman em pipeline

pipe-opening = Os { $edges } recortadores ao mesmo tempo: os { $n } vértices passam por eles um a um.
pipe-send = { $vertex } = { $at } do polígono entra no primeiro recortador, { $border }.
pipe-enter = { $vertex } = { $at } passa ao recortador seguinte, { $border }.
pipe-first-inside = É o primeiro vértice a chegar ao recortador { $border }: é guardado como F e, como está dentro, segue adiante.
pipe-first-outside = É o primeiro vértice a chegar ao recortador { $border }: é guardado como F e, como está fora, não segue.
pipe-vertex = S → P: { $rule }. P segue adiante.
pipe-crossing = S → P: { $rule }. A interseção I segue adiante.
pipe-both = S → P: { $rule }. A interseção I segue adiante, e depois P.
pipe-nothing = S → P: { $rule }. Não há interseção, e P não segue.
pipe-closing-cross = A aresta de fechamento S → F: { $rule }. A interseção I segue adiante.
pipe-closing = A aresta de fechamento S → F: { $rule }. Nada segue adiante.
pipe-cross = S e o vértice seguinte estão em lados opostos de { $border }: a aresta o cruza em I.
pipe-output = { $at } sai do último recortador: é { $vertex } do anel, em definitivo.
pipe-close = Não chegarão mais vértices ao recortador { $border }: ele fecha o seu anel.
pipe-close-empty = Nenhum vértice chegou ao recortador { $border }: não há nada a fechar.
pipe-closed = fechado
code-pipe-send = para cada vértice: envie-o ao recortador 1
code-pipe-enter = recortador k, quando chega P:
code-pipe-first = na primeira vez: F ← P
code-pipe-cross = senão, se SP cruza: envie I ao recortador k + 1
code-pipe-pass-on = S ← P; se P está dentro: envie P ao recortador k + 1
code-pipe-output = o que sai do último recortador entra no anel
code-pipe-close = feche os recortadores 1, 2, …: se SF cruza, envie I
words-pipe-send = Os vértices do polígono entram um a um.
words-pipe-enter = Um recortador conhece só dois vértices: F, o primeiro que chegou, e S, o anterior.
words-pipe-first = Ele guarda o primeiro vértice que chega.
words-pipe-cross = Se a aresta a partir de S cruza a borda, primeiro segue a interseção.
words-pipe-pass-on = O vértice é guardado como S e, se está dentro, segue adiante.
words-pipe-output = Depois do último recortador, um vértice pertence à resposta.
words-pipe-close = No fim, cada recortador por sua vez examina a aresta que volta do seu último vértice a F.

## Sutherland–Hodgman, errado de propósito

alg-faulty-on-border = Errado: a borda conta como fora
alg-faulty-open = Errado: falta a aresta de fechamento
alg-faulty-clockwise = Errado: as bordas são percorridas no sentido horário
alg-faulty-twice = Errado: as interseções são emitidas duas vezes
alg-faulty-end-first = Errado: o fim vem antes da interseção
faulty-on-border-differs = O passo { $step } é o primeiro que difere: um vértice sobre a borda é tomado como externo.
faulty-open-differs = O passo { $step } é o primeiro que difere: a aresta de fechamento, do último vértice ao primeiro, nunca é examinada.
faulty-clockwise-differs = O passo { $step } é o primeiro que difere: as bordas são percorridas no sentido horário, e o lado errado de cada uma é tomado como interior.
faulty-twice-differs = O passo { $step } é o primeiro que difere: a mesma interseção é emitida pela segunda vez.
faulty-end-first-differs = O passo { $step } é o primeiro que difere: a aresta entra, e o seu fim é emitido antes da interseção.
