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

## Desenhar um contorno com cliques

action-draw-subject = Desenhar o polígono
action-draw-clip = Desenhar o polígono de recorte
action-draw-hole = Desenhar um furo
action-no-holes = Remover todos os furos
draw-subject = Clique para colocar o vértice { $number } do novo polígono; Backspace retira um, Esc desiste.
draw-clip = Clique para colocar o vértice { $number } do novo polígono de recorte; Backspace retira um, Esc desiste.
draw-hole = Clique para colocar o vértice { $number } do novo furo; Backspace retira um, Esc desiste.
draw-close = Clique para colocar o vértice { $number }; Enter, um clique duplo ou um clique no primeiro vértice fecha o contorno.
refused-last-three = O vértice fica: um polígono precisa de pelo menos três.
refused-too-many = { $count } vértices são demais: no máximo { $most }.

## Polígonos e regiões para começar

preset-title = Polígonos de exemplo
preset-convex = Convexo
preset-triangle = Triângulo
preset-arrow = Ponta de flecha (côncavo)
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

ear-opening = Este polígono de { $n } vértices será cortado em triângulos.
ear-classify = { $vertex } é { $corner }.
ear-classify-again = Com o novo vizinho, { $vertex } é { $corner }.
ear-convex = convexo
ear-straight = colinear
ear-reflex = reflexo
ear-round = A volta { $round } começa com { $n } vértices.
ear-pass = { $vertex } é { $corner }: não é orelha.
ear-candidate = { $vertex } é convexo. Há outro vértice dentro de { $triangle }?
ear-blocked = { $by } está dentro de { $triangle }: { $vertex } não é orelha.
ear-ear = Nenhum outro vértice está dentro de { $triangle }: { $vertex } é uma orelha.
ear-cut = { $triangle } é cortado pela diagonal { $diagonal }: restam { $n } vértices.
ear-last = Restam três vértices: { $triangle } é o último triângulo.
ear-done =
    { $n ->
        [one] Pronto: um triângulo, tal como foi dado.
       *[other] Pronto: { $n } triângulos, dois a menos que os vértices.
    }
ear-left = o que resta
ear-n-left = vértices restantes
ear-n-triangles = triângulos
code-ear-classify = para cada v: corner(v) ← sinal de turn(a, v, b)
code-ear-round = enquanto restarem mais de 3 vértices
code-ear-each = para cada v cujo canto é novo
code-ear-convex = se corner(v) > 0
code-ear-empty = e nenhum vértice com corner ≤ 0 está em avb
code-ear-cut = emita avb; retire v
code-ear-again = corner(a), corner(b) de novo
code-ear-last = emita os três que restam
words-ear-classify = Em cada vértice v, entre o anterior, a, e o seguinte, b: o contorno vira à esquerda, à direita ou não vira?
words-ear-round = Dê voltas até restarem três vértices.
words-ear-each = Examine cada vértice cujo canto mudou na volta anterior; na primeira, todos.
words-ear-convex = Um canto só pode ser cortado onde o contorno vira à esquerda.
words-ear-empty = Nenhum outro vértice pode estar no triângulo. Basta examinar os que não são convexos.
words-ear-cut = É uma orelha: corte-a pela diagonal ab.
words-ear-again = Os cantos em a e b mudaram: classifique-os de novo e examine-os na próxima volta.
words-ear-last = O que resta é um triângulo.

## Triangulate, then clip

tac-opening = Corte em triângulos o polígono de { $n } vértices; depois recorte cada um por si.
tac-triangle = Triângulo { $number } de { $total }: { $triangle }.
tac-whole = { $triangle } está dentro da região: é um pedaço tal como está.
tac-piece = { $triangle } deixa um pedaço convexo de { $n } vértices.
tac-none = { $triangle } não deixa nada na região.
tac-touch = { $triangle } apenas toca a região: nenhum pedaço.
tac-finish =
    { $n ->
        [0] Pronto: nenhum pedaço. O polígono não entra na região.
        [one] Pronto: um pedaço.
       *[other] Pronto: { $n } pedaços, todos convexos: sem pontes.
    }
tac-now = triângulo
tac-pieces = pedaços
code-tac-triangulate = triângulos ← corte de orelhas(polígono)
code-tac-each = para cada triângulo
code-tac-clip = anel ← Sutherland–Hodgman(triângulo, região)
code-tac-piece = se o anel tem área: emita anel
words-tac-triangulate = Corte o polígono em triângulos pelo corte de orelhas.
words-tac-each = Tome um triângulo após o outro.
words-tac-clip = Recorte-o por Sutherland–Hodgman: o que resta de um polígono convexo é convexo.
words-tac-piece = Se resta algo que se possa preencher, é um pedaço da resposta.
