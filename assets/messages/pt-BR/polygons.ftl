# O laboratório de polígonos.

handle-clip-vertex = vértice { $number } do polígono de recorte
handle-hole-vertex = vértice { $number } do furo { $hole }
handle-polygon = o polígono
texture-title = Textura
texture-none = nenhuma
texture-interpolated = interpolada com t
texture-kept = não interpolada (errada)
part-subject = o polígono a recortar
part-hole = um furo
part-clip = o polígono de recorte
refused-not-convex = Este algoritmo exige uma região de recorte convexa, mas { $part } vira para o outro lado em { $vertex }.
refused-winds-twice = Este algoritmo exige um contorno simples, mas em { $vertex } { $part } já deu mais de uma volta.
refused-edges-meet = Este algoritmo exige um contorno simples, mas as arestas { $first } e { $second } se encontram: { $part } não tem um contorno assim.
refused-misplaced-hole = Este algoritmo exige que cada furo fique dentro do polígono, sem tocar o contorno nem outros furos: { $part } não cumpre isso.
refused-degenerate = Não há nada a recortar: { $part } não tem área.

## Desenhar um contorno com cliques

action-draw-subject = Desenhar o polígono
action-draw-clip = Desenhar o polígono de recorte
action-draw-hole = Desenhar um furo
action-no-hole = Remover este furo
action-no-holes = Remover todos os furos
draw-subject = Clique para colocar o vértice { $number } do novo polígono; Backspace remove o último, Esc cancela.
draw-clip = Clique para colocar o vértice { $number } do novo polígono de recorte; Backspace remove o último, Esc cancela.
draw-hole = Clique para colocar o vértice { $number } do novo furo; Backspace remove o último, Esc cancela.
draw-close = Clique para colocar o vértice { $number }; Enter, um clique duplo ou um clique no primeiro vértice fecha o contorno.
draw-no-use = Os algoritmos em cena não podem usar { $part }.

## Polígonos e regiões para começar

preset-title = Polígonos de exemplo
preset-convex = Convexo
preset-triangle = Triângulo
preset-arrow = Ponta de flecha (côncava)
preset-comb = Pente: vários pedaços
preset-corner = Em volta de um canto: uma ponte
preset-spiral = Espiral
preset-star = Estrela
preset-hole = Com um furo
preset-around = Em volta de toda a janela
preset-inside = Dentro da janela
preset-touch = Toca em um só ponto
preset-along = Uma aresta sobre a borda
preset-bow-tie = Gravata-borboleta: cruza a si mesmo
preset-random = Aleatório
random-count = Vértices
random-make = Substituir o polígono
region-title = Região de recorte
region-window = Janela
region-corners = Os quatro cantos da janela
region-triangle = Triângulo
region-diamond = Losango
region-octagon = Octógono
region-bracket = Forma de L (côncava)
## Ear clipping

ear-opening = Este polígono de { $n } vértices será dividido em triângulos.
ear-classify = { $vertex } é { $corner }.
option-corner = { $vertex } é { $option }.
ear-classify-again = Com o novo vizinho, { $vertex } é { $corner }.
ear-convex = convexo
ear-straight = colinear
ear-reflex = reflexo
ear-round = A volta { $round } começa com { $n } vértices.
ear-pass = { $vertex } é { $corner }: não é orelha.
ear-candidate = { $vertex } é convexo. Há outro vértice dentro de { $triangle }?
ear-blocked = { $by } está dentro de { $triangle }: { $vertex } não é orelha.
ear-not-convex = { $vertex } não é convexo.
ear-is-convex = { $vertex } é convexo.
ear-not-empty = Outro vértice está dentro de { $triangle }: { $vertex } não é orelha.
ear-ear = Nenhum outro vértice está dentro de { $triangle }: { $vertex } é uma orelha.
ear-cut = { $triangle } é cortado pela diagonal { $diagonal }: restam { $n } vértices.
ear-last = Restam três vértices: { $triangle } é o último triângulo.
ear-done =
    { $n ->
        [1] Pronto: um triângulo, tal como foi dado.
       *[other] Pronto: { $n } triângulos, dois a menos que os vértices do polígono.
    }
ear-list-ring = O que resta
ear-list-triangles = Triângulos
ear-inside = dentro
ear-outside = fora
ear-left = o que resta
ear-n-left = vértices restantes
ear-n-triangles = triângulos
code-ear-classify = para cada v: corner(v) ← sinal de turn(a, v, b)
code-ear-round = enquanto restarem mais de 3 vértices
code-ear-each = para cada v cujo ângulo é novo
code-ear-convex = se corner(v) > 0
code-ear-empty = e nenhum vértice com corner ≤ 0 está em avb
code-ear-cut = emita avb; retire v
code-ear-again = de novo: corner(a), corner(b)
code-ear-last = emita os três que restam
words-ear-classify = Em cada vértice v, com a antes e b depois: o contorno vira à esquerda, à direita ou segue reto?
words-ear-round = Dê voltas pelo contorno até restarem três vértices.
words-ear-each = Examine cada vértice cujo ângulo mudou na volta anterior; na primeira, todos.
words-ear-convex = Um vértice só pode ser cortado onde o contorno vira à esquerda.
words-ear-empty = Nenhum outro vértice pode estar no triângulo. Basta examinar os que não são convexos.
words-ear-cut = É uma orelha: corte-a pela diagonal ab.
words-ear-again = Os ângulos em a e b mudaram: classifique-os de novo e examine-os na próxima volta.
words-ear-last = O que resta é um triângulo.

## Triangulate, then clip

tac-opening = Divida em triângulos o polígono de { $n } vértices; depois recorte cada um por si.
tac-triangle = Triângulo { $number } de { $total }: { $triangle }. Enquanto é recortado, seus vértices se chamam V₁, V₂ e V₃.
tac-whole = { $triangle } está dentro da região: é um pedaço tal como está.
tac-piece = { $triangle } deixa um pedaço convexo de { $n } vértices.
option-piece-cut = { $triangle } é cortado e deixa um pedaço convexo.
tac-none = { $triangle } não deixa nada na região.
tac-touch = { $triangle } apenas toca a região: nenhum pedaço.
tac-finish =
    { $n ->
        [0] Pronto: nenhum pedaço. O polígono não entra na região.
        [1] Pronto: um pedaço.
       *[other] Pronto: { $n } pedaços, todos convexos: sem pontes.
    }
tac-list-triangles = Triângulos
tac-list-pieces = Pedaços
tac-dropped = descartado
tac-vertices = vértices
tac-now = triângulo
tac-pieces = pedaços
code-tac-triangulate = triângulos ← corte de orelhas(polígono)
code-tac-each = para cada triângulo
code-tac-clip = anel ← Sutherland–Hodgman(triângulo, região)
code-tac-piece = se o anel tem área: emita anel
words-tac-triangulate = Divida o polígono em triângulos pelo corte de orelhas.
words-tac-each = Tome um triângulo após o outro.
words-tac-clip = Recorte-o por Sutherland–Hodgman: o que resta de um polígono convexo é convexo.
words-tac-piece = Se resta algo que tenha área, é um pedaço da resposta.
## Sutherland–Hodgman

alg-sutherland-hodgman = Sutherland–Hodgman
alg-sutherland-hodgman-pipeline = Sutherland–Hodgman, em pipeline
rule-in-in = dentro → dentro
rule-in-out = dentro → fora
rule-out-in = fora → dentro
rule-out-out = fora → fora
sh-inside = dentro
sh-outside = fora
sh-bridge = ponte: { $length }, ida e volta
sh-bridge-adds = ponte: área + 0, contorno + 2 · { $length }
sh-area = área { $area }
sh-does-not-count = { $inside }: agora não
sh-list-input = Lista de entrada
sh-list-output = Lista de saída
sh-list-handed-on = Saída = entrada
sh-list-next = Próxima lista de entrada
sh-list-given = Polígono
sh-list-left = O que resta
sh-list-wrong = × Resultado errado
sh-n-inside = { $n } dentro
sh-opening = O polígono inteiro, { $n } vértices, é recortado contra uma borda da região após a outra: { $edges } bordas.
sh-edge-side = Recorte contra a { $edge }: um ponto está dentro se { $inside }.
sh-edge = Recorte contra { $edge }: um ponto está dentro se { $inside }.
sh-first-inside = O primeiro vértice, { $vertex }, está dentro: é emitido.
sh-first-outside = O primeiro vértice, { $vertex }, está fora: nada é emitido.
sh-in-in = { $from } → { $to }: dentro → dentro. Emite-se { $to }.
option-puts-nothing = { $from } → { $to }: nada é emitido.
option-puts-end = { $from } → { $to }: emite-se { $to }.
option-puts-crossing = { $from } → { $to }: emite-se a interseção.
option-puts-both = { $from } → { $to }: emitem-se a interseção e depois { $to }.
sh-in-out = { $from } → { $to }: dentro → fora. Emite-se a interseção I.
sh-in-out-touch = { $from } → { $to }: dentro → fora. { $from } está sobre a borda e é a própria interseção: já está na lista.
sh-out-in = { $from } → { $to }: fora → dentro. Emitem-se a interseção I e depois { $to }.
sh-out-in-touch = { $from } → { $to }: fora → dentro. { $to } está sobre a borda e é a própria interseção: emite-se uma só vez.
sh-out-out = { $from } → { $to }: fora → fora. Nada é emitido.
sh-closing-cross = A aresta de fechamento { $from } → { $to }: { $rule }. Emite-se só a interseção I.
sh-closing = A aresta de fechamento { $from } → { $to }: { $rule }. Nada mais é emitido.
sh-cross = { $from } → { $to } cruza { $border } em I.
sh-output = { $vertex } entra na lista de saída como { $place }.
sh-pass = Borda { $border } concluída: a lista de saída, de comprimento { $n }, é a próxima lista de entrada.
sh-pass-empty = Borda { $border } concluída: a lista de saída tem comprimento { $n }. Não resta nada a recortar.
sh-done-empty = Pronto após { $edges } bordas: nenhuma parte do polígono está na região, e a lista está vazia.
sh-done-whole = Pronto: os { $n } vértices estão dentro das { $edges } bordas. O polígono não muda.
sh-done-cut = Pronto após { $edges } bordas: resta um anel de { $n } vértices.
sh-done-degenerate = Pronto após { $edges } bordas: o que resta não tem área. Comprimento da última lista: { $n }.
code-sh-each = para cada borda de recorte: saída ← vazia
code-sh-first = F ← primeiro vértice; se está dentro: emita F
code-sh-edges = para cada aresta S → P, por fim até F:
code-sh-in-in = dentro → dentro: emita P se P ≠ F
code-sh-in-out = dentro → fora: emita I
code-sh-out-in = fora → dentro: emita I, e P se P ≠ F
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

pipe-list-ring = Anel até agora
pipe-opening = Todos os { $edges } recortadores ao mesmo tempo: os { $n } vértices fluem por eles, um a um.
pipe-send = { $vertex } = { $at } do polígono entra no primeiro recortador, { $border }.
pipe-enter = { $vertex } = { $at } passa ao recortador seguinte, { $border }.
pipe-first-inside = É o primeiro vértice a chegar ao recortador { $border }: é guardado como F e segue adiante, pois está dentro.
pipe-first-outside = É o primeiro vértice a chegar ao recortador { $border }: é guardado como F e não segue adiante, pois está fora.
pipe-vertex = S → P: { $rule }. P segue adiante.
pipe-crossing = S → P: { $rule }. A interseção I segue adiante.
pipe-both = S → P: { $rule }. A interseção I segue adiante, e depois P.
pipe-nothing = S → P: { $rule }. Não há interseção, e P não segue.
pipe-closing-cross = A aresta de fechamento S → F: { $rule }. A interseção I segue adiante.
pipe-closing = A aresta de fechamento S → F: { $rule }. Nada segue adiante.
pipe-cross = S → P cruza { $border } em I.
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
faulty-on-border-differs = O passo { $step } é o primeiro que difere: um vértice sobre a borda é contado como fora.
faulty-open-differs = O passo { $step } é o primeiro que difere: a aresta de fechamento, do último vértice ao primeiro, nunca é examinada.
faulty-clockwise-differs = O passo { $step } é o primeiro que difere: as bordas são percorridas no sentido horário, e o exterior de cada uma é tomado por interior.
faulty-twice-differs = O passo { $step } é o primeiro que difere: a mesma interseção é emitida pela segunda vez.
faulty-end-first-differs = O passo { $step } é o primeiro que difere: a aresta entra, e o seu fim é emitido antes da interseção.
code-faulty-on-border = para cada borda de recorte: saída ← vazia; dentro é d > 0
words-faulty-on-border = Tome as bordas da região de recorte uma a uma, cada uma com uma lista de saída vazia. Um vértice sobre a borda conta como fora.
code-faulty-open = para cada aresta S → P, até o último vértice:
words-faulty-open = Depois siga o contorno, aresta por aresta, até o último vértice.
code-faulty-clockwise = para cada borda de recorte, no sentido horário: saída ← vazia
words-faulty-clockwise = Tome as bordas da região de recorte uma a uma, no sentido horário, com o interior à esquerda de cada uma.
code-faulty-twice-out = dentro → fora: emita I, I
words-faulty-twice-out = A aresta sai: emita a interseção duas vezes.
code-faulty-twice-in = fora → dentro: emita I, I, P
words-faulty-twice-in = A aresta entra: emita a interseção duas vezes e depois o seu fim.
code-faulty-end-first = fora → dentro: emita P se P ≠ F, e I
words-faulty-end-first = A aresta entra: emita o seu fim e depois a interseção.

## Weiler–Atherton

wa-opening = Um polígono de { $n } vértices é recortado por um de { $m }: os dois são escritos como listas de vértices, no sentido anti-horário.
wa-vertex-subject = { $vertex } entra na lista do polígono a recortar. Agora: onde a aresta { $edge } encontra o polígono de recorte?
wa-vertex-clip = { $vertex } entra na lista do polígono de recorte. Agora: as interseções na aresta { $edge }, em ordem.
wa-found-crossing = { $node }: { $subject } cruza { $clip }.
wa-found-on-edge = { $node }: o vértice { $vertex } está sobre a aresta { $edge }.
wa-found-both = { $node }: os vértices { $subject } e { $clip } são o mesmo ponto.
wa-meet-crossing = { $subject-edge } e { $clip-edge } se cruzam no interior das duas.
wa-meet-subject-vertex = Um vértice do polígono a recortar está no interior da aresta { $clip-edge }.
wa-meet-clip-vertex = Um vértice do polígono de recorte está no interior da aresta { $subject-edge }.
wa-meet-both = As duas arestas começam no mesmo ponto.
wa-inserted = { $node } entra também na lista do polígono de recorte, na aresta { $edge }.
wa-inserted-vertex = Na lista do polígono de recorte, { $node } é o vértice { $vertex }.
option-label = { $node }: { $option }
wa-entering = { $node } é de entrada: o polígono a recortar passa de { $before } para { $after }.
wa-leaving = { $node } é de saída: o polígono a recortar passa de { $before } para { $after }.
wa-touching = { $node } apenas toca: o polígono a recortar passa de { $before } para { $after } e continua do mesmo lado.
wa-touching-same = { $node } apenas toca: o polígono a recortar continua { $before }.
wa-pinching = { $node } é um estrangulamento: cada contorno passa pelo interior do outro, e dois vértices do resultado se tocam.
wa-inside = dentro
wa-outside = fora
wa-along = uma aresta comum no mesmo sentido (dentro)
wa-against = uma aresta comum no sentido oposto (fora)
wa-in = entrada
wa-out = saída
wa-touches = toque
wa-pinches = estrangulamento
wa-intersection = interseção
wa-mark-entering = de entrada
wa-mark-leaving = de saída
wa-start = Um percurso começa em { $node }, na lista do polígono a recortar.
wa-visit-subject = Pelo polígono a recortar: { $entry } é o vértice { $n } do caminho.
wa-visit-clip = Pelo polígono de recorte: { $entry } é o vértice { $n } do caminho.
wa-past = { $entry } não é vértice do anel: o percurso passa direto.
wa-switch-clip = { $node } é de saída: segue-se pela lista do polígono de recorte.
wa-switch-subject = { $node } é de entrada: segue-se pela lista do polígono a recortar.
wa-switch-pinch-clip = { $node } é um estrangulamento: segue-se pela lista do polígono de recorte, para que cada pedaço fique com o seu vértice.
wa-switch-pinch-subject = { $node } é um estrangulamento: segue-se pela lista do polígono a recortar, para que cada pedaço fique com o seu vértice.
wa-closed-outer = De volta a um ponto do caminho: fecha-se o anel { $ring }, de { $n } vértices.
wa-closed-hole = De volta a um ponto do caminho: é um anel inteiro do polígono a recortar. { $ring }, de { $n } vértices, é um furo.
wa-closed-sliver = De volta a um ponto do caminho: { $ring }, de { $n } vértices, é tão fino que, arredondado, não tem mais área. É descartado.
wa-whole-subject-kept = O contorno do polígono a recortar não muda de lista e está { $side }: inteiro, é o anel { $ring }.
wa-whole-subject-dropped = O contorno do polígono a recortar não muda de lista e está { $side }: não delimita nada.
wa-whole-hole-kept = O furo { $hole } do polígono a recortar não muda de lista e está { $side }: é um furo, { $ring }.
wa-whole-hole-dropped = O furo { $hole } do polígono a recortar não muda de lista e está { $side }: não delimita nada.
wa-whole-clip-kept = O polígono de recorte não muda de lista e está { $side }: inteiro, é o anel { $ring }.
wa-whole-clip-dropped = O polígono de recorte não muda de lista e está { $side }: não delimita nada.
wa-hole = O furo { $hole } está dentro do anel { $ring }.
wa-done-disjoint = Pronto: os dois polígonos não têm nenhum ponto em comum.
wa-done-touching = Pronto: os dois polígonos se tocam, mas não têm área em comum.
wa-done-subject = Pronto: o polígono a recortar está dentro do polígono de recorte e não muda.
wa-done-clip = Pronto: o polígono de recorte está dentro do polígono a recortar e é a resposta.
wa-done-equal = Pronto: os dois polígonos são o mesmo, e a resposta também.
wa-done-crossing =
    { $n ->
        [1] Pronto: um pedaço.
       *[other] Pronto: { $n } pedaços.
    }
wa-list-subject = Lista do polígono
wa-list-clip = Lista de recorte
wa-row-start = começou em
wa-row-path = vértices do caminho
wa-row-rings = anéis fechados
code-wa-find = para cada aresta de S: lista S ← vértice, interseções com C
code-wa-insert = para cada aresta de C: lista C ← vértice, suas interseções
code-wa-label = rotule cada uma: entrada, saída, toque, estrangulamento
code-wa-start = enquanto restar uma entrada: comece ali, na lista S
code-wa-follow = siga a lista, emita seus vértices
code-wa-enter = em uma entrada: siga pela lista S
code-wa-leave = em uma saída: siga pela lista C
code-wa-close = de volta a um vértice emitido: feche o anel
code-wa-whole = contornos sem entrada nem saída: dentro ⇒ um anel
code-wa-holes = dê cada furo ao anel em volta dele
words-wa-find = Copie em uma lista, vértice a vértice, o polígono a recortar, S. Depois de cada vértice, ponha as interseções da sua aresta, em ordem.
words-wa-insert = Copie do mesmo modo o polígono de recorte C: as mesmas interseções, na ordem do seu próprio contorno.
words-wa-label = Rotule cada interseção pelo que o polígono a recortar faz ali. Uma aresta comum conta como dentro se os dois contornos correm no mesmo sentido e como fora se correm em sentidos opostos.
words-wa-start = Tome uma interseção de entrada por onde nenhum percurso passou ainda e comece ali, na lista do polígono a recortar.
words-wa-follow = Siga a lista de vértice em vértice e emita cada um.
words-wa-enter = Onde o polígono entra, e onde os contornos se estrangulam, siga pela lista do polígono a recortar.
words-wa-leave = Onde o polígono sai, e onde os contornos se estrangulam, siga pela lista do polígono de recorte.
words-wa-close = Quando o percurso chega a um vértice já emitido, o que fica entre as duas passagens é um anel. Quando chega ao seu começo, termina.
words-wa-whole = Um contorno no qual nunca se muda de lista está inteiro dentro ou inteiro fora.
words-wa-holes = Um furo pertence ao anel em que está.

## The verdict

verdict-vertex-kept = { $vertex } é mantido.
verdict-vertex-cut = { $vertex } é cortado aqui: é a primeira borda além da qual ele está.
verdict-vertex-passed-by = Nenhum percurso passa por { $vertex }: ele não está no resultado.
verdict-edge-dropped = De { $from } a { $to }, a aresta é descartada.
verdict-vertex-in = Deslocado { $move } para dentro, na perpendicular à borda ({ $edge }), { $vertex } seria mantido.
verdict-vertex-never = Nenhum deslocamento na perpendicular à borda ({ $edge }) manteria { $vertex }.
verdict-vertex-out = Deslocado mais de { $move } para fora, na perpendicular à borda mais próxima ({ $edge }), { $vertex } seria cortado.
verdict-vertex-touch = { $vertex } está sobre a borda ({ $edge }): com o menor deslocamento para fora seria cortado.
