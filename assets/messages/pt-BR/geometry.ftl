### The words of the field that all labs share: objects, edges, regions, algorithms, verdicts, refusals.

## Objects

object-segment = segmento
object-window = janela de recorte
object-clip-polygon = polígono de recorte
object-polygon = polígono
object-hole = furo
object-uv = coordenadas de textura
object-outcode = código de região

## The window’s edges, as nouns; the sides alone agree with “edge”

edge-left = borda esquerda
edge-right = borda direita
edge-bottom = borda inferior
edge-top = borda superior
side-left = esquerda
side-right = direita
side-bottom = inferior
side-top = superior

## The nine regions around the window

region-above-left = acima e à esquerda
region-above = acima
region-above-right = acima e à direita
region-left = à esquerda
region-inside = dentro
region-right = à direita
region-below-left = abaixo e à esquerda
region-below = abaixo
region-below-right = abaixo e à direita

## Algorithms

alg-brute-force = Força bruta
alg-cohen-sutherland = Cohen–Sutherland
alg-liang-barsky = Liang–Barsky
alg-cyrus-beck = Cyrus–Beck
alg-nicholl-lee-nicholl = Nicholl–Lee–Nicholl
alg-weiler-atherton = Weiler–Atherton
alg-ear-clipping = Corte de orelhas
alg-triangulate-and-clip = Triangular e depois recortar

## Verdicts, said of a segment, a polygon, a triangle or an object

verdict-entering = entrando
verdict-leaving = saindo
verdict-parallel = paralelo

## Why an input is refused; the last part of the key is the error’s code in the command line’s JSON

error-not-finite = Todas as coordenadas devem ser números finitos.
error-empty-window = A janela está vazia: a borda esquerda deve ficar à esquerda da direita, e a inferior abaixo da superior.
error-not-convex = O polígono de recorte deve ser convexo: este algoritmo conserva o que fica do lado interno de todas as arestas.
error-self-intersecting = O polígono cruza a si mesmo.
error-edges-meet = O contorno não pode encontrar a si mesmo: as arestas { $first } e { $second } se cruzam, se tocam ou se sobrepõem.
error-misplaced-hole = O furo { $hole } deve ficar dentro do contorno, sem tocar suas arestas nem qualquer outro furo.
error-degenerate = A figura é degenerada: não tem extensão onde precisa.
error-too-few-vertices = Um polígono precisa de pelo menos três vértices.
error-at = { $place }: { $problem }
