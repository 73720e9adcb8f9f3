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
refused-edges-meet = Este algoritmo exige um contorno simples: em { $part }, as arestas { $first } e { $second } se encontram.
refused-misplaced-hole = Este algoritmo exige que cada furo fique dentro do polígono, sem tocar a borda nem outros furos: { $part } não cumpre isso.
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

## Weiler–Atherton

wa-opening = Um polígono de { $n } vértices contra um de { $m }: os dois são escritos como listas de vértices, no sentido anti-horário.
wa-vertex-subject = { $vertex } entra na lista do sujeito. Agora: onde a aresta { $edge } encontra o polígono de recorte?
wa-vertex-clip = { $vertex } entra na lista do polígono de recorte. Agora: as interseções na aresta { $edge }, em ordem.
wa-found-crossing = { $node }: { $subject } cruza { $clip }.
wa-found-on-edge = { $node }: o vértice { $vertex } está sobre a aresta { $edge }.
wa-found-both = { $node }: os vértices { $subject } e { $clip } são o mesmo ponto.
wa-inserted = { $node } entra também na lista do polígono de recorte, na aresta { $edge }.
wa-inserted-vertex = Na lista do polígono de recorte, { $node } é o vértice { $vertex }.
wa-entering = { $node } é de entrada: o sujeito passa de { $before } para { $after }.
wa-leaving = { $node } é de saída: o sujeito passa de { $before } para { $after }.
wa-touching = { $node } apenas toca: o sujeito passa de { $before } para { $after } e continua do mesmo lado.
wa-pinching = { $node } é um estrangulamento: cada borda passa pelo interior da outra, e dois cantos do resultado se tocam.
wa-inside = dentro
wa-outside = fora
wa-along = uma aresta comum no mesmo sentido (dentro)
wa-against = uma aresta comum no sentido oposto (fora)
wa-in = entra
wa-out = sai
wa-touches = toca
wa-pinches = estrangula
wa-start = Um percurso começa em { $node }, na lista do sujeito.
wa-visit-subject = Pelo sujeito: { $entry } é o canto { $n } do caminho.
wa-visit-clip = Pelo polígono de recorte: { $entry } é o canto { $n } do caminho.
wa-past = { $entry } não é canto: o percurso passa direto.
wa-switch-clip = { $node } é de saída: segue-se pela lista do polígono de recorte.
wa-switch-subject = { $node } é de entrada: segue-se pela lista do sujeito.
wa-switch-pinch-clip = { $node } é um estrangulamento: segue-se pela lista do polígono de recorte, para que cada pedaço fique com o seu canto.
wa-switch-pinch-subject = { $node } é um estrangulamento: segue-se pela lista do sujeito, para que cada pedaço fique com o seu canto.
wa-closed-outer = De volta a um ponto do caminho: fecha-se o anel { $ring }, de { $n } cantos.
wa-closed-hole = De volta a um ponto do caminho: é um anel inteiro do sujeito. { $ring }, de { $n } cantos, é um furo.
wa-closed-sliver = De volta a um ponto do caminho: { $ring }, de { $n } cantos, é tão fino que, arredondado, não tem mais área. É descartado.
wa-whole-subject-kept = O contorno do sujeito não muda de lista e está { $side }: inteiro, é o anel { $ring }.
wa-whole-subject-dropped = O contorno do sujeito não muda de lista e está { $side }: não delimita nada.
wa-whole-hole-kept = O furo { $hole } do sujeito não muda de lista e está { $side }: é um furo, { $ring }.
wa-whole-hole-dropped = O furo { $hole } do sujeito não muda de lista e está { $side }: não delimita nada.
wa-whole-clip-kept = O polígono de recorte não muda de lista e está { $side }: inteiro, é o anel { $ring }.
wa-whole-clip-dropped = O polígono de recorte não muda de lista e está { $side }: não delimita nada.
wa-hole = O furo { $hole } está dentro do anel { $ring }.
wa-done-disjoint = Pronto: os dois polígonos não têm nenhum ponto em comum.
wa-done-touching = Pronto: os dois polígonos se tocam, mas não têm área em comum.
wa-done-subject = Pronto: o sujeito está dentro do polígono de recorte e fica como está.
wa-done-clip = Pronto: o polígono de recorte está dentro do sujeito e é a resposta.
wa-done-equal = Pronto: os dois polígonos são o mesmo, e a resposta também.
wa-done-crossing =
    { $n ->
        [one] Pronto: um pedaço.
       *[other] Pronto: { $n } pedaços.
    }
wa-row-start = começou em
wa-row-path = cantos do caminho
wa-row-rings = anéis fechados
code-wa-find = para cada aresta de S: lista S ← vértice, interseções com C
code-wa-insert = para cada aresta de C: lista C ← vértice, suas interseções
code-wa-label = marque cada uma: entra, sai, toca, estrangula
code-wa-start = enquanto restar um entra: comece ali, na lista S
code-wa-follow = siga a lista, emita seus vértices
code-wa-enter = em um entra: siga pela lista S
code-wa-leave = em um sai: siga pela lista C
code-wa-close = de volta a um vértice emitido: feche o anel
code-wa-whole = bordas sem entra nem sai: dentro ⇒ um anel
code-wa-holes = dê cada furo ao anel em volta dele
words-wa-find = Copie o sujeito S vértice a vértice para uma lista e, depois de cada vértice, as interseções na sua aresta, em ordem.
words-wa-insert = Copie do mesmo modo o polígono de recorte C: as mesmas interseções, na ordem da sua própria borda.
words-wa-label = Marque cada interseção pelo que o sujeito faz ali. Uma aresta comum conta como dentro se as duas bordas correm no mesmo sentido e como fora se correm em sentidos opostos.
words-wa-start = Tome uma interseção de entrada por onde nenhum percurso passou ainda e comece ali, na lista do sujeito.
words-wa-follow = Siga a lista de vértice em vértice e emita cada um.
words-wa-enter = Onde o sujeito entra, e onde as bordas se estrangulam, siga pela lista do sujeito.
words-wa-leave = Onde o sujeito sai, e onde as bordas se estrangulam, siga pela lista do polígono de recorte.
words-wa-close = De volta a um vértice já emitido: o que fica no meio é um anel. De volta ao começo, o percurso termina.
words-wa-whole = Uma borda na qual nunca se muda de lista está inteira dentro ou inteira fora.
words-wa-holes = Um furo pertence ao anel em que está.
