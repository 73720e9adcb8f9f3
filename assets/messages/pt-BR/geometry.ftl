### The words of the field that all labs share: objects, edges, regions, algorithms, verdicts, refusals.

## Objects

object-segment = segmento
object-window = janela de recorte
object-clip-polygon = polígono de recorte
object-polygon = polígono
object-triangle = triângulo
object-vertex = vértice
object-edge = aresta
object-plane = plano
object-normal = normal
object-intersection = interseção
object-outcode = código de região
object-clip-volume = volume de recorte
object-frustum = frustum de visão
object-sphere = esfera envolvente
object-mesh = malha
object-scene = cena
object-eye = olho
object-camera = câmera
object-ray = raio
object-pixel = pixel
object-depth = profundidade

## The window’s edges, as nouns; the sides alone agree with “edge”

edge-left = borda esquerda
edge-right = borda direita
edge-bottom = borda inferior
edge-top = borda superior
side-left = esquerda
side-right = direita
side-bottom = inferior
side-top = superior
side-near = próximo
side-far = distante

## The planes of a clip volume, as nouns

plane-left = plano esquerdo
plane-right = plano direito
plane-bottom = plano inferior
plane-top = plano superior
plane-near = plano próximo
plane-far = plano distante

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
alg-cohen-sutherland-3d = Cohen–Sutherland em 3D
alg-liang-barsky-3d = Liang–Barsky em 3D
alg-plane-line = Segmento contra planos
alg-homogeneous-line = Segmento no espaço de recorte
alg-sutherland-hodgman = Sutherland–Hodgman
alg-weiler-atherton = Weiler–Atherton
alg-ear-clipping = Corte de orelhas
alg-plane-at-a-time = Plano a plano
alg-intersection-polygon = Polígono de interseção
alg-homogeneous-triangle = Triângulo no espaço de recorte
alg-sphere-cull = Descarte por esfera envolvente
alg-back-face = Descarte de faces traseiras
alg-depth-buffer = Z-buffer
alg-painter = Algoritmo do pintor
alg-ray-casting = Lançamento de raios
alg-bresenham = Bresenham

## Verdicts, said of a segment, a polygon, a triangle or an object

verdict-accepted = aceito
verdict-rejected = rejeitado
verdict-clipped = recortado
verdict-touches = toca a borda
verdict-inside = dentro
verdict-outside = fora
verdict-on = sobre a borda
verdict-straddles = em parte dentro
verdict-entering = entrando
verdict-leaving = saindo
verdict-parallel = paralelo
verdict-visible = visível
verdict-hidden = oculto
verdict-culled = descartado
verdict-front = de frente
verdict-back = de costas

## Why an input is refused; the last part of the key is the error’s code in the command line’s JSON

error-bad-json = Não é um JSON válido.
error-unknown-algorithm = Não existe algoritmo com esse nome.
error-unknown-field = Aqui não há campo com esse nome.
error-missing-field = Falta um campo.
error-wrong-type = O valor não é do tipo esperado.
error-wrong-length = A lista não tem o comprimento esperado.
error-not-finite = Todas as coordenadas devem ser números finitos.
error-empty-window = A janela está vazia: a borda esquerda deve ficar à esquerda da direita, e a inferior abaixo da superior.
error-not-convex = O polígono de recorte deve ser convexo: este algoritmo conserva o que fica do lado interno de todas as arestas.
error-self-intersecting = O polígono cruza a si mesmo.
error-degenerate = A figura é degenerada: não tem extensão onde precisa.
error-too-few-vertices = Um polígono precisa de pelo menos três vértices.
error-zero-normal = A normal de um plano não pode ser nula.
error-bad-frustum = O frustum precisa de 0° < campo de visão < 180°, proporção positiva e 0 < próximo < distante.
error-too-large = É mais do que o visualizador consegue tratar.
error-at = { $place }: { $problem }
