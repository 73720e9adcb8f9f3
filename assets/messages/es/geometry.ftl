### The words of the field that all labs share: objects, edges, regions, algorithms, verdicts, refusals.

## Objects

object-segment = segmento
object-window = ventana de recorte
object-clip-polygon = polígono de recorte
object-polygon = polígono
object-triangle = triángulo
object-vertex = vértice
object-edge = arista
object-plane = plano
object-normal = normal
object-intersection = intersección
object-outcode = código de región
object-clip-volume = volumen de recorte
object-frustum = frustum de visión
object-sphere = esfera envolvente
object-mesh = malla
object-scene = escena
object-eye = ojo
object-camera = cámara
object-ray = rayo
object-pixel = píxel
object-depth = profundidad

## The window’s edges, as nouns; the sides alone agree with “edge”

edge-left = borde izquierdo
edge-right = borde derecho
edge-bottom = borde inferior
edge-top = borde superior
side-left = izquierdo
side-right = derecho
side-bottom = inferior
side-top = superior
side-near = cercano
side-far = lejano

## The planes of a clip volume, as nouns

plane-left = plano izquierdo
plane-right = plano derecho
plane-bottom = plano inferior
plane-top = plano superior
plane-near = plano cercano
plane-far = plano lejano

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
alg-cohen-sutherland-3d = Cohen–Sutherland en 3D
alg-liang-barsky-3d = Liang–Barsky en 3D
alg-plane-line = Segmento contra planos
alg-homogeneous-line = Segmento en el espacio de recorte
alg-sutherland-hodgman = Sutherland–Hodgman
alg-weiler-atherton = Weiler–Atherton
alg-ear-clipping = Recorte de orejas
alg-plane-at-a-time = Plano a plano
alg-intersection-polygon = Polígono de intersección
alg-homogeneous-triangle = Triángulo en el espacio de recorte
alg-sphere-cull = Descarte por esfera envolvente
alg-back-face = Descarte de caras traseras
alg-depth-buffer = Z-buffer
alg-painter = Algoritmo del pintor
alg-ray-casting = Lanzamiento de rayos
alg-bresenham = Bresenham

## Verdicts, said of a segment, a polygon, a triangle or an object

verdict-accepted = aceptado
verdict-rejected = rechazado
verdict-clipped = recortado
verdict-touches = toca el borde
verdict-inside = dentro
verdict-outside = fuera
verdict-on = sobre el borde
verdict-straddles = en parte dentro
verdict-entering = entra
verdict-leaving = sale
verdict-parallel = paralelo
verdict-visible = visible
verdict-hidden = oculto
verdict-culled = descartado
verdict-front = de frente
verdict-back = de espaldas

## Why an input is refused; the last part of the key is the error’s code in the command line’s JSON

error-bad-json = No es JSON válido.
error-unknown-algorithm = No existe ningún algoritmo con ese nombre.
error-unknown-field = Aquí no hay ningún campo con ese nombre.
error-missing-field = Falta un campo.
error-wrong-type = El valor no es del tipo esperado.
error-wrong-length = La lista no tiene la longitud esperada.
error-not-finite = Todas las coordenadas deben ser números finitos.
error-empty-window = La ventana está vacía: su borde izquierdo debe quedar a la izquierda del derecho, y el inferior por debajo del superior.
error-not-convex = El polígono de recorte debe ser convexo: este algoritmo conserva lo que queda en el lado interior de todas sus aristas.
error-self-intersecting = El polígono se corta a sí mismo.
error-degenerate = La figura es degenerada: no tiene extensión donde la necesita.
error-too-few-vertices = Un polígono necesita al menos tres vértices.
error-zero-normal = La normal de un plano no puede ser nula.
error-bad-frustum = El frustum necesita 0° < campo de visión < 180°, una relación de aspecto positiva y 0 < cercano < lejano.
error-too-large = Es más de lo que el visualizador puede manejar.
error-at = { $place }: { $problem }
