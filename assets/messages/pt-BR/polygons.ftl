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
