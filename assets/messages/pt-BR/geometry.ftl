### The words of the field that all labs share: objects, edges, regions, algorithms, verdicts.

## Objects

object-segment = segmento
object-window = janela de recorte
object-clip-polygon = polígono de recorte
object-polygon = polígono
object-hole = furo
object-uv = coordenadas de textura
object-outcode = código de região
object-planes = planos
object-point = ponto
object-view-volume = volume de visão
object-sphere = esfera
object-box = caixa
object-triangle = triângulo
object-eye = olho
object-view-direction = direção de visão
object-culled = descartado
object-backs = triângulos que mostram a sua face traseira

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
