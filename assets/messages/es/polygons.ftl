# El laboratorio de polígonos.

handle-clip-vertex = vértice { $number } del polígono de recorte
handle-hole-vertex = vértice { $number } del hueco { $hole }
handle-polygon = el polígono
texture-title = Textura
texture-none = ninguna
texture-interpolated = interpolada con t
texture-kept = sin interpolar (error)
part-subject = el polígono sujeto
part-hole = un hueco
part-clip = el polígono de recorte
refused-not-convex = Este algoritmo exige una región de recorte convexa: { $part } gira hacia el lado equivocado en { $vertex }.
refused-winds-twice = Este algoritmo exige un contorno simple: { $part } ya ha dado más de una vuelta en { $vertex }.
refused-degenerate = No hay nada que recortar: { $part } no tiene área.

## Dibujar un contorno con clics

action-draw-subject = Dibujar el polígono
action-draw-clip = Dibujar el polígono de recorte
action-draw-hole = Dibujar un hueco
action-no-holes = Quitar todos los huecos
draw-subject = Haz clic para poner el vértice { $number } del nuevo polígono; Retroceso quita uno, Escape abandona.
draw-clip = Haz clic para poner el vértice { $number } del nuevo polígono de recorte; Retroceso quita uno, Escape abandona.
draw-hole = Haz clic para poner el vértice { $number } del nuevo hueco; Retroceso quita uno, Escape abandona.
draw-close = Haz clic para poner el vértice { $number }; Intro, un doble clic o un clic en el primer vértice cierra el contorno.
refused-last-three = El vértice se queda: un polígono necesita al menos tres.
refused-too-many = { $count } vértices son demasiados: como máximo { $most }.

## Polígonos y regiones para empezar

preset-title = Polígonos de ejemplo
preset-convex = Convexo
preset-triangle = Triángulo
preset-arrow = Punta de flecha (cóncavo)
preset-comb = Peine: varios trozos
preset-corner = Alrededor de una esquina: un puente
preset-spiral = Espiral
preset-star = Estrella
preset-hole = Con un hueco
preset-around = Rodea toda la ventana
preset-inside = Dentro de la ventana
preset-touch = Toca en un solo punto
preset-along = Una arista sobre el borde
preset-bow-tie = Pajarita: se cruza a sí mismo
preset-random = Al azar
random-count = Vértices
random-make = Reemplazar el polígono
region-title = Región de recorte
region-window = Ventana
region-corners = Las cuatro esquinas de la ventana
region-triangle = Triángulo
region-diamond = Rombo
region-octagon = Octógono
region-bracket = Forma de L (cóncava)
## Ear clipping

ear-opening = Este polígono de { $n } vértices se va a cortar en triángulos.
ear-classify = { $vertex } es { $corner }.
ear-classify-again = Con su nuevo vecino, { $vertex } es { $corner }.
ear-convex = convexo
ear-straight = colineal
ear-reflex = cóncavo
ear-round = La vuelta { $round } empieza con { $n } vértices.
ear-pass = { $vertex } es { $corner }: no es una oreja.
ear-candidate = { $vertex } es convexo. ¿Hay otro vértice dentro de { $triangle }?
ear-blocked = { $by } está dentro de { $triangle }: { $vertex } no es una oreja.
ear-ear = Ningún otro vértice está dentro de { $triangle }: { $vertex } es una oreja.
ear-cut = Se corta { $triangle } por la diagonal { $diagonal }: quedan { $n } vértices.
ear-last = Quedan tres vértices: { $triangle } es el último triángulo.
ear-done =
    { $n ->
        [one] Listo: un triángulo, tal como se dio.
       *[other] Listo: { $n } triángulos, dos menos que vértices había.
    }
ear-left = lo que queda
ear-n-left = vértices restantes
ear-n-triangles = triángulos
code-ear-classify = para cada v: corner(v) ← signo de turn(a, v, b)
code-ear-round = mientras queden más de 3 vértices
code-ear-each = para cada v cuya esquina es nueva
code-ear-convex = si corner(v) > 0
code-ear-empty = y ningún vértice con corner ≤ 0 está en avb
code-ear-cut = emitir avb; quitar v
code-ear-again = corner(a), corner(b) de nuevo
code-ear-last = emitir los tres que quedan
words-ear-classify = En cada vértice v, entre el anterior, a, y el siguiente, b: ¿gira el contorno a la izquierda, a la derecha o no gira?
words-ear-round = Da vueltas hasta que queden tres vértices.
words-ear-each = Examina cada vértice cuya esquina cambió en la vuelta anterior; en la primera, todos.
words-ear-convex = Una esquina solo se puede cortar donde el contorno gira a la izquierda.
words-ear-empty = Ningún otro vértice puede estar en el triángulo. Basta con examinar los que no son convexos.
words-ear-cut = Es una oreja: córtala por la diagonal ab.
words-ear-again = Las esquinas de a y b han cambiado: clasifícalas de nuevo y examínalas en la vuelta siguiente.
words-ear-last = Lo que queda es un triángulo.

## Triangulate, then clip

tac-opening = Corta en triángulos el polígono de { $n } vértices; después recorta cada uno por separado.
tac-triangle = Triángulo { $number } de { $total }: { $triangle }.
tac-whole = { $triangle } está dentro de la región: es un trozo tal como está.
tac-piece = { $triangle } deja un trozo convexo de { $n } vértices.
tac-none = { $triangle } no deja nada en la región.
tac-touch = { $triangle } solo toca la región: no deja ningún trozo.
tac-finish =
    { $n ->
        [0] Listo: ningún trozo. El polígono no entra en la región.
        [one] Listo: un trozo.
       *[other] Listo: { $n } trozos, todos convexos: sin puentes.
    }
tac-now = triángulo
tac-pieces = trozos
code-tac-triangulate = triángulos ← recorte de orejas(polígono)
code-tac-each = para cada triángulo
code-tac-clip = anillo ← Sutherland–Hodgman(triángulo, región)
code-tac-piece = si el anillo tiene área: emitir anillo
words-tac-triangulate = Corta el polígono en triángulos por recorte de orejas.
words-tac-each = Toma un triángulo tras otro.
words-tac-clip = Recórtalo por Sutherland–Hodgman: lo que queda de un polígono convexo es convexo.
words-tac-piece = Si queda algo que se pueda rellenar, es un trozo de la respuesta.
