### The words of the field that all labs share: objects, edges, regions, algorithms, verdicts.

## Objects

object-segment = segmento
object-window = ventana de recorte
object-clip-polygon = polígono de recorte
object-polygon = polígono
object-hole = agujero
object-uv = coordenadas de textura
object-outcode = código de región
object-planes = planos
object-point = punto
object-view-volume = volumen de visión
object-sphere = esfera
object-box = caja
object-triangle = triángulo
object-eye = ojo
object-view-direction = dirección de visión
object-culled = se descarta
object-backs = triángulos que muestran su cara trasera

## The window’s edges, as nouns; the sides alone agree with “edge”

edge-left = borde izquierdo
edge-right = borde derecho
edge-bottom = borde inferior
edge-top = borde superior
side-left = izquierdo
side-right = derecho
side-bottom = inferior
side-top = superior

## The nine regions around the window

region-above-left = arriba a la izquierda
region-above = arriba
region-above-right = arriba a la derecha
region-left = a la izquierda
region-inside = dentro
region-right = a la derecha
region-below-left = abajo a la izquierda
region-below = abajo
region-below-right = abajo a la derecha

## Algorithms

alg-brute-force = Fuerza bruta
alg-cohen-sutherland = Cohen–Sutherland
alg-liang-barsky = Liang–Barsky
alg-cyrus-beck = Cyrus–Beck
alg-nicholl-lee-nicholl = Nicholl–Lee–Nicholl
alg-weiler-atherton = Weiler–Atherton
alg-ear-clipping = Recorte de orejas
alg-triangulate-and-clip = Triangular y después recortar

## Verdicts, said of a segment, a polygon, a triangle or an object

verdict-entering = entra
verdict-leaving = sale
verdict-parallel = paralelo
