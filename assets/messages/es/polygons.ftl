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
refused-edges-meet = Este algoritmo exige un contorno simple: en { $part }, las aristas { $first } y { $second } se encuentran.
refused-misplaced-hole = Este algoritmo exige que cada hueco quede dentro del polígono, sin tocar el borde ni otros huecos: { $part } no lo cumple.
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

## Weiler–Atherton

wa-opening = Un polígono de { $n } vértices contra uno de { $m }: ambos se escriben como listas de vértices, en sentido antihorario.
wa-vertex-subject = { $vertex } pasa a la lista del sujeto. Ahora: ¿dónde corta la arista { $edge } al polígono de recorte?
wa-vertex-clip = { $vertex } pasa a la lista del polígono de recorte. Ahora: las intersecciones de la arista { $edge }, en orden.
wa-found-crossing = { $node }: { $subject } corta a { $clip }.
wa-found-on-edge = { $node }: el vértice { $vertex } está sobre la arista { $edge }.
wa-found-both = { $node }: los vértices { $subject } y { $clip } son el mismo punto.
wa-inserted = { $node } pasa también a la lista del polígono de recorte, en la arista { $edge }.
wa-inserted-vertex = En la lista del polígono de recorte, { $node } es el vértice { $vertex }.
wa-entering = { $node } es entrante: el sujeto pasa de { $before } a { $after }.
wa-leaving = { $node } es saliente: el sujeto pasa de { $before } a { $after }.
wa-touching = { $node } solo toca: el sujeto pasa de { $before } a { $after } y sigue en el mismo lado.
wa-pinching = { $node } es un estrangulamiento: cada borde pasa por el interior del otro, y dos esquinas del resultado se tocan.
wa-inside = dentro
wa-outside = fuera
wa-along = una arista común en el mismo sentido (dentro)
wa-against = una arista común en sentido contrario (fuera)
wa-in = entra
wa-out = sale
wa-touches = toca
wa-pinches = estrangula
wa-start = Un recorrido empieza en { $node }, en la lista del sujeto.
wa-visit-subject = Por el sujeto: { $entry } es la esquina { $n } del camino.
wa-visit-clip = Por el polígono de recorte: { $entry } es la esquina { $n } del camino.
wa-past = { $entry } no es esquina: el recorrido pasa de largo.
wa-switch-clip = { $node } es saliente: se sigue por la lista del polígono de recorte.
wa-switch-subject = { $node } es entrante: se sigue por la lista del sujeto.
wa-switch-pinch-clip = { $node } es un estrangulamiento: se sigue por la lista del polígono de recorte, para que cada trozo conserve su esquina.
wa-switch-pinch-subject = { $node } es un estrangulamiento: se sigue por la lista del sujeto, para que cada trozo conserve su esquina.
wa-closed-outer = De vuelta a un punto del camino: se cierra el anillo { $ring }, de { $n } esquinas.
wa-closed-hole = De vuelta a un punto del camino: es un anillo entero del sujeto. { $ring }, de { $n } esquinas, es un hueco.
wa-closed-sliver = De vuelta a un punto del camino: { $ring }, de { $n } esquinas, es tan fino que al redondear no le queda área. Se descarta.
wa-whole-subject-kept = El contorno del sujeto no cambia de lista y está { $side }: entero es el anillo { $ring }.
wa-whole-subject-dropped = El contorno del sujeto no cambia de lista y está { $side }: no delimita nada.
wa-whole-hole-kept = El hueco { $hole } del sujeto no cambia de lista y está { $side }: es un hueco, { $ring }.
wa-whole-hole-dropped = El hueco { $hole } del sujeto no cambia de lista y está { $side }: no delimita nada.
wa-whole-clip-kept = El polígono de recorte no cambia de lista y está { $side }: entero es el anillo { $ring }.
wa-whole-clip-dropped = El polígono de recorte no cambia de lista y está { $side }: no delimita nada.
wa-hole = El hueco { $hole } está dentro del anillo { $ring }.
wa-done-disjoint = Listo: los dos polígonos no tienen ningún punto en común.
wa-done-touching = Listo: los dos polígonos se tocan, pero no tienen área en común.
wa-done-subject = Listo: el sujeto está dentro del polígono de recorte y queda como está.
wa-done-clip = Listo: el polígono de recorte está dentro del sujeto y es la respuesta.
wa-done-equal = Listo: los dos polígonos son el mismo, y la respuesta también.
wa-done-crossing =
    { $n ->
        [one] Listo: un trozo.
       *[other] Listo: { $n } trozos.
    }
wa-row-start = empezó en
wa-row-path = esquinas del camino
wa-row-rings = anillos cerrados
code-wa-find = para cada arista de S: lista S ← vértice, intersecciones con C
code-wa-insert = para cada arista de C: lista C ← vértice, sus intersecciones
code-wa-label = marcar cada una: entra, sale, toca, estrangula
code-wa-start = mientras quede un entra: empezar ahí, en la lista S
code-wa-follow = seguir la lista, emitir sus vértices
code-wa-enter = en un entra: seguir por la lista S
code-wa-leave = en un sale: seguir por la lista C
code-wa-close = de vuelta a un vértice emitido: cerrar el anillo
code-wa-whole = bordes sin entra ni sale: dentro ⇒ un anillo
code-wa-holes = dar cada hueco al anillo que lo rodea
words-wa-find = Copia el sujeto S vértice a vértice en una lista y, detrás de cada vértice, las intersecciones de su arista, en orden.
words-wa-insert = Copia igual el polígono de recorte C: las mismas intersecciones, en el orden de su propio borde.
words-wa-label = Marca cada intersección según lo que hace allí el sujeto. Una arista común cuenta como dentro si ambos bordes van en el mismo sentido y como fuera si van en sentido contrario.
words-wa-start = Toma una intersección entrante por la que aún no ha pasado ningún recorrido y empieza ahí, en la lista del sujeto.
words-wa-follow = Sigue la lista de vértice en vértice y emite cada uno.
words-wa-enter = Donde el sujeto entra, y donde los bordes se estrangulan, sigue por la lista del sujeto.
words-wa-leave = Donde el sujeto sale, y donde los bordes se estrangulan, sigue por la lista del polígono de recorte.
words-wa-close = De vuelta a un vértice ya emitido: lo que queda en medio es un anillo. De vuelta al comienzo, el recorrido termina.
words-wa-whole = Un borde en el que nunca se cambia de lista está entero dentro o entero fuera.
words-wa-holes = Un hueco pertenece al anillo en el que está.
