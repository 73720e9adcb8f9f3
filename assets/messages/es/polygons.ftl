# El laboratorio de polígonos.

handle-clip-vertex = vértice { $number } del polígono de recorte
handle-hole-vertex = vértice { $number } del agujero { $hole }
handle-polygon = el polígono
texture-title = Textura
texture-none = ninguna
texture-interpolated = interpolada con t
texture-kept = sin interpolar (erróneo)
part-subject = el polígono que se recorta
part-hole = un agujero
part-clip = el polígono de recorte
refused-not-convex = Este algoritmo exige una región de recorte convexa, pero { $part } gira hacia el otro lado en { $vertex }.
refused-winds-twice = Este algoritmo exige un contorno simple, pero { $part } ya ha dado más de una vuelta en { $vertex }.
refused-edges-meet = Este algoritmo exige un contorno simple, pero en { $part } las aristas { $first } y { $second } se encuentran.
refused-misplaced-hole = Este algoritmo exige que cada agujero quede dentro del polígono, sin tocar el borde ni otros agujeros: { $part } no lo cumple.
refused-degenerate = No hay nada que recortar: { $part } no tiene área.

## Dibujar un contorno con clics

action-draw-subject = Dibujar el polígono
action-draw-clip = Dibujar el polígono de recorte
action-draw-hole = Dibujar un agujero
action-no-hole = Quitar este agujero
action-no-holes = Quitar todos los agujeros
draw-subject = Haz clic para poner el vértice { $number } del nuevo polígono; Retroceso quita el último; Esc cancela.
draw-clip = Haz clic para poner el vértice { $number } del nuevo polígono de recorte; Retroceso quita el último; Esc cancela.
draw-hole = Haz clic para poner el vértice { $number } del nuevo agujero; Retroceso quita el último; Esc cancela.
draw-close = Haz clic para poner el vértice { $number }; Intro, un doble clic o un clic en el primer vértice cierra el contorno.
draw-no-use = Los algoritmos en escena no pueden usar { $part }.

## Polígonos y regiones para empezar

preset-title = Polígonos de ejemplo
preset-convex = Convexo
preset-triangle = Triángulo
preset-arrow = Punta de flecha (cóncava)
preset-comb = Peine: varios trozos
preset-corner = Alrededor de una esquina: un puente
preset-spiral = Espiral
preset-star = Estrella
preset-hole = Con un agujero
preset-around = Rodea toda la ventana
preset-inside = Dentro de la ventana
preset-touch = Toca en un solo punto
preset-along = Una arista sobre el borde
preset-bow-tie = Pajarita: se cruza a sí misma
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

ear-opening = Este polígono de { $n } vértices se va a dividir en triángulos.
ear-classify = { $vertex } es { $corner }.
option-corner = { $vertex } es { $option }.
ear-classify-again = Con su nuevo vecino, { $vertex } es { $corner }.
ear-convex = convexo
ear-straight = colineal
ear-reflex = cóncavo
ear-round = La vuelta { $round } empieza con { $n } vértices.
ear-pass = { $vertex } es { $corner }: no es una oreja.
ear-candidate = { $vertex } es convexo. ¿Hay otro vértice dentro de { $triangle }?
ear-blocked = { $by } está dentro de { $triangle }: { $vertex } no es una oreja.
ear-not-convex = { $vertex } no es convexo.
ear-is-convex = { $vertex } es convexo.
ear-not-empty = Otro vértice está dentro de { $triangle }: { $vertex } no es una oreja.
ear-ear = Ningún otro vértice está dentro de { $triangle }: { $vertex } es una oreja.
ear-cut = Se corta { $triangle } por la diagonal { $diagonal }: quedan { $n } vértices.
ear-last = Quedan tres vértices: { $triangle } es el último triángulo.
ear-done =
    { $n ->
        [one] Terminado: un triángulo, tal como se dio.
       *[other] Terminado: { $n } triángulos, dos menos que vértices tenía el polígono.
    }
ear-list-ring = Lo que queda
ear-list-triangles = Triángulos
ear-inside = dentro
ear-outside = fuera
ear-left = lo que queda
ear-n-left = vértices restantes
ear-n-triangles = triángulos
code-ear-classify = para cada v: corner(v) ← signo de turn(a, v, b)
code-ear-round = mientras queden más de 3 vértices
code-ear-each = para cada v cuyo ángulo sea nuevo
code-ear-convex = si corner(v) > 0
code-ear-empty = y ningún vértice con corner ≤ 0 está en avb
code-ear-cut = emitir avb; quitar v
code-ear-again = otra vez: corner(a), corner(b)
code-ear-last = emitir los tres que quedan
words-ear-classify = En cada vértice v, con a antes y b después: ¿gira el contorno a la izquierda, a la derecha o sigue recto?
words-ear-round = Da vueltas hasta que queden tres vértices.
words-ear-each = Examina cada vértice cuyo ángulo cambió en la vuelta anterior; en la primera, todos.
words-ear-convex = Un vértice solo se puede cortar donde el contorno gira a la izquierda.
words-ear-empty = Ningún otro vértice puede estar en el triángulo. Basta con examinar los que no son convexos.
words-ear-cut = Es una oreja: córtala por la diagonal ab.
words-ear-again = Los ángulos de a y b han cambiado: clasifícalos de nuevo y examínalos en la vuelta siguiente.
words-ear-last = Lo que queda es un triángulo.

## Triangulate, then clip

tac-opening = Divide en triángulos el polígono de { $n } vértices; después recorta cada uno por separado.
tac-triangle = Triángulo { $number } de { $total }: { $triangle }. Mientras se recorta, sus vértices se llaman V₁, V₂ y V₃.
tac-whole = { $triangle } está dentro de la región: es un trozo tal como está.
tac-piece = { $triangle } deja un trozo convexo de { $n } vértices.
option-piece-cut = { $triangle } se corta y deja un trozo convexo.
tac-none = { $triangle } no deja nada en la región.
tac-touch = { $triangle } solo toca la región: no deja ningún trozo.
tac-finish =
    { $n ->
        [0] Terminado: ningún trozo. El polígono no entra en la región.
        [one] Terminado: un trozo.
       *[other] Terminado: { $n } trozos, todos convexos: sin puentes.
    }
tac-list-triangles = Triángulos
tac-list-pieces = Trozos
tac-dropped = descartado
tac-vertices = vértices
tac-now = triángulo
tac-pieces = trozos
code-tac-triangulate = triángulos ← recorte de orejas(polígono)
code-tac-each = para cada triángulo
code-tac-clip = anillo ← Sutherland–Hodgman(triángulo, región)
code-tac-piece = si el anillo tiene área: emitir anillo
words-tac-triangulate = Divide el polígono en triángulos mediante el recorte de orejas.
words-tac-each = Toma un triángulo tras otro.
words-tac-clip = Recórtalo con Sutherland–Hodgman: lo que queda de un polígono convexo es convexo.
words-tac-piece = Si queda algo que tenga área, es un trozo de la respuesta.
## Sutherland–Hodgman

alg-sutherland-hodgman = Sutherland–Hodgman
alg-sutherland-hodgman-pipeline = Sutherland–Hodgman, en cadena
rule-in-in = dentro → dentro
rule-in-out = dentro → fuera
rule-out-in = fuera → dentro
rule-out-out = fuera → fuera
sh-inside = dentro
sh-outside = fuera
sh-bridge = puente: { $length }, ida y vuelta
sh-bridge-adds = puente: área + 0, contorno + 2 · { $length }
sh-area = área { $area }
sh-does-not-count = { $inside }: ahora no
sh-list-input = Lista de entrada
sh-list-output = Lista de salida
sh-list-handed-on = Salida = entrada
sh-list-next = Próxima lista de entrada
sh-list-given = Polígono
sh-list-left = Lo que queda
sh-list-wrong = × Resultado erróneo
sh-n-inside = { $n } dentro
sh-opening = Se recorta el polígono entero, { $n } vértices, contra un borde de la región tras otro: { $edges } bordes.
sh-edge-side = Recorte contra el { $edge }: un punto está dentro si { $inside }.
sh-edge = Recorte contra { $edge }: un punto está dentro si { $inside }.
sh-first-inside = El primer vértice, { $vertex }, está dentro: se emite.
sh-first-outside = El primer vértice, { $vertex }, está fuera: no se emite nada.
sh-in-in = { $from } → { $to }: dentro → dentro. Se emite { $to }.
option-puts-nothing = { $from } → { $to }: no se emite nada.
option-puts-end = { $from } → { $to }: se emite { $to }.
option-puts-crossing = { $from } → { $to }: se emite la intersección.
option-puts-both = { $from } → { $to }: se emiten la intersección y después { $to }.
sh-in-out = { $from } → { $to }: dentro → fuera. Se emite la intersección I.
sh-in-out-touch = { $from } → { $to }: dentro → fuera. { $from } está sobre el borde y es la propia intersección: ya figura en la lista.
sh-out-in = { $from } → { $to }: fuera → dentro. Se emiten la intersección I y después { $to }.
sh-out-in-touch = { $from } → { $to }: fuera → dentro. { $to } está sobre el borde y es la propia intersección: se emite una sola vez.
sh-out-out = { $from } → { $to }: fuera → fuera. No se emite nada.
sh-closing-cross = La arista de cierre { $from } → { $to }: { $rule }. Se emite solo la intersección I.
sh-closing = La arista de cierre { $from } → { $to }: { $rule }. No se emite nada más.
sh-cross = { $from } → { $to } corta { $border } en I.
sh-output = { $vertex } entra en la lista de salida como { $place }.
sh-pass = Fin de { $border }: la lista de salida, de longitud { $n }, es la próxima lista de entrada.
sh-pass-empty = Fin de { $border }: la lista de salida tiene longitud { $n }. No queda nada que recortar.
sh-done-empty = Terminado tras { $edges } bordes: ninguna parte del polígono está en la región, y la lista queda vacía.
sh-done-whole = Terminado: los { $n } vértices están dentro de los { $edges } bordes. El polígono no cambia.
sh-done-cut = Terminado tras { $edges } bordes: queda un anillo de { $n } vértices.
sh-done-degenerate = Terminado tras { $edges } bordes: lo que queda no tiene área. Longitud de la última lista: { $n }.
code-sh-each = para cada borde de recorte: salida ← vacía
code-sh-first = F ← primer vértice; si está dentro: emitir F
code-sh-edges = para cada arista S → P, la última hasta F:
code-sh-in-in = dentro → dentro: emitir P si P ≠ F
code-sh-in-out = dentro → fuera: emitir I
code-sh-out-in = fuera → dentro: emitir I, y P si P ≠ F
code-sh-out-out = fuera → fuera: no emitir nada
code-sh-pass = entrada ← salida
words-sh-each = Toma uno a uno los bordes de la región de recorte, cada uno con una lista de salida vacía.
words-sh-first = Emite el primer vértice si está dentro.
words-sh-edges = Después sigue el contorno, arista por arista, y ciérralo; en la arista de cierre no se emite F otra vez.
words-sh-in-in = La arista sigue dentro: emite su final.
words-sh-in-out = La arista sale: emite la intersección.
words-sh-out-in = La arista entra: emite la intersección y después su final.
words-sh-out-out = La arista sigue fuera: no emitas nada.
words-sh-pass = Lo emitido es el polígono para el borde siguiente; tras el último borde, la respuesta.

## Sutherland–Hodgman en cadena

pipe-list-ring = Anillo hasta ahora
pipe-opening = Los { $edges } recortadores a la vez: los { $n } vértices pasan por ellos uno a uno.
pipe-send = { $vertex } = { $at } del polígono entra en el primer recortador, { $border }.
pipe-enter = { $vertex } = { $at } pasa al recortador siguiente, { $border }.
pipe-first-inside = Es el primer vértice que llega al recortador { $border }: se guarda como F y, como está dentro, sigue adelante.
pipe-first-outside = Es el primer vértice que llega al recortador { $border }: se guarda como F y, como está fuera, no sigue.
pipe-vertex = S → P: { $rule }. P sigue adelante.
pipe-crossing = S → P: { $rule }. Sigue adelante la intersección I.
pipe-both = S → P: { $rule }. Siguen adelante la intersección I y después P.
pipe-nothing = S → P: { $rule }. No hay intersección, y P no sigue.
pipe-closing-cross = La arista de cierre S → F: { $rule }. Sigue adelante la intersección I.
pipe-closing = La arista de cierre S → F: { $rule }. No sigue nada.
pipe-cross = S → P cruza { $border } en I.
pipe-output = { $at } sale del último recortador: ya es, de forma definitiva, { $vertex } del anillo.
pipe-close = Ya no llegarán más vértices al recortador { $border }: cierra su anillo.
pipe-close-empty = No ha llegado ningún vértice al recortador { $border }: no hay nada que cerrar.
pipe-closed = cerrado
code-pipe-send = para cada vértice: enviarlo al recortador 1
code-pipe-enter = recortador k, cuando llega P:
code-pipe-first = la primera vez: F ← P
code-pipe-cross = si no, si SP cruza: enviar I al recortador k + 1
code-pipe-pass-on = S ← P; si P está dentro: enviar P al recortador k + 1
code-pipe-output = lo que sale del último recortador se une al anillo
code-pipe-close = cerrar los recortadores 1, 2, …: si SF cruza, enviar I
words-pipe-send = Los vértices del polígono entran uno a uno.
words-pipe-enter = Un recortador conoce solo dos vértices: F, el primero que llegó, y S, el anterior.
words-pipe-first = Guarda el primer vértice que llega.
words-pipe-cross = Si la arista desde S cruza el borde, primero sigue la intersección.
words-pipe-pass-on = El vértice se guarda como S y, si está dentro, sigue adelante.
words-pipe-output = Pasado el último recortador, un vértice ya pertenece a la respuesta.
words-pipe-close = Al final, cada recortador, por turno, examina la arista que vuelve de su último vértice a F.

## Sutherland–Hodgman, con errores a propósito

alg-faulty-on-border = Erróneo: el borde cuenta como exterior
## Sutherland–Hodgman, con errores a propósito

alg-faulty-open = Erróneo: falta la arista de cierre
alg-faulty-clockwise = Erróneo: los bordes se recorren en sentido horario
alg-faulty-twice = Erróneo: las intersecciones se emiten dos veces
alg-faulty-end-first = Erróneo: el final va antes que la intersección
faulty-on-border-differs = El paso { $step } es el primero que difiere: un vértice sobre el borde se toma por exterior.
faulty-open-differs = El paso { $step } es el primero que difiere: la arista de cierre, del último vértice al primero, no se examina nunca.
faulty-clockwise-differs = El paso { $step } es el primero que difiere: los bordes se recorren en sentido horario, y el exterior de cada uno se toma por interior.
faulty-twice-differs = El paso { $step } es el primero que difiere: la misma intersección se emite por segunda vez.
faulty-end-first-differs = El paso { $step } es el primero que difiere: la arista entra, y su final se emite antes que su intersección.
code-faulty-on-border = para cada borde de recorte: salida ← vacía; dentro es d > 0
words-faulty-on-border = Toma uno a uno los bordes de la región de recorte, cada uno con una lista de salida vacía. Un vértice sobre el borde cuenta como exterior.
code-faulty-open = para cada arista S → P, hasta el último vértice:
words-faulty-open = Después sigue el contorno, arista por arista, hasta el último vértice.
code-faulty-clockwise = para cada borde de recorte, en sentido horario: salida ← vacía
words-faulty-clockwise = Toma uno a uno los bordes de la región de recorte, en sentido horario, con el interior a la izquierda de cada uno.
code-faulty-twice-out = dentro → fuera: emitir I, I
words-faulty-twice-out = La arista sale: emite la intersección dos veces.
code-faulty-twice-in = fuera → dentro: emitir I, I, P
words-faulty-twice-in = La arista entra: emite la intersección dos veces y después su final.
code-faulty-end-first = fuera → dentro: emitir P si P ≠ F, e I
words-faulty-end-first = La arista entra: emite su final y después la intersección.

## Weiler–Atherton

wa-opening = Se recorta un polígono de { $n } vértices con uno de { $m }: ambos se escriben como listas de vértices, en sentido antihorario.
wa-vertex-subject = { $vertex } pasa a la lista del polígono que se recorta. Ahora: ¿dónde corta la arista { $edge } al polígono de recorte?
wa-vertex-clip = { $vertex } pasa a la lista del polígono de recorte. Ahora: las intersecciones de la arista { $edge }, en orden.
wa-found-crossing = { $node }: { $subject } corta a { $clip }.
wa-found-on-edge = { $node }: el vértice { $vertex } está sobre la arista { $edge }.
wa-found-both = { $node }: los vértices { $subject } y { $clip } son el mismo punto.
wa-meet-crossing = { $subject-edge } y { $clip-edge } se cortan en el interior de ambas.
wa-meet-subject-vertex = Un vértice del polígono que se recorta está en el interior de la arista { $clip-edge }.
wa-meet-clip-vertex = Un vértice del polígono de recorte está en el interior de la arista { $subject-edge }.
wa-meet-both = Las dos aristas empiezan en el mismo punto.
wa-inserted = { $node } pasa también a la lista del polígono de recorte, en la arista { $edge }.
wa-inserted-vertex = En la lista del polígono de recorte, { $node } es el vértice { $vertex }.
option-label = { $node }: { $option }
wa-entering = { $node } es de entrada: el polígono que se recorta pasa de { $before } a { $after }.
wa-leaving = { $node } es de salida: el polígono que se recorta pasa de { $before } a { $after }.
wa-touching = { $node } solo toca: el polígono que se recorta pasa de { $before } a { $after } y sigue en el mismo lado.
wa-touching-same = { $node } solo toca: el polígono que se recorta sigue { $before }.
wa-pinching = { $node } es un estrangulamiento: cada borde pasa por el interior del otro, y dos vértices del resultado se tocan.
wa-inside = dentro
wa-outside = fuera
wa-along = una arista común en el mismo sentido (dentro)
wa-against = una arista común en sentido contrario (fuera)
wa-in = de entrada
wa-out = de salida
wa-touches = contacto
wa-pinches = estrangulamiento
wa-intersection = intersección
wa-mark-entering = de entrada
wa-mark-leaving = de salida
wa-start = Un recorrido empieza en { $node }, en la lista del polígono que se recorta.
wa-visit-subject = Por el polígono que se recorta: { $entry } es el vértice { $n } del camino.
wa-visit-clip = Por el polígono de recorte: { $entry } es el vértice { $n } del camino.
wa-past = { $entry } no es vértice del anillo: el recorrido pasa de largo.
wa-switch-clip = { $node } es de salida: se sigue por la lista del polígono de recorte.
wa-switch-subject = { $node } es de entrada: se sigue por la lista del polígono que se recorta.
wa-switch-pinch-clip = { $node } es un estrangulamiento: se sigue por la lista del polígono de recorte, para que cada trozo conserve su vértice.
wa-switch-pinch-subject = { $node } es un estrangulamiento: se sigue por la lista del polígono que se recorta, para que cada trozo conserve su vértice.
wa-closed-outer = De vuelta a un punto del camino: se cierra el anillo { $ring }, de { $n } vértices.
wa-closed-hole = De vuelta a un punto del camino: es un anillo entero del polígono que se recorta. { $ring }, de { $n } vértices, es un agujero.
wa-closed-sliver = De vuelta a un punto del camino: { $ring }, de { $n } vértices, es tan fino que al redondear no le queda área. Se descarta.
wa-whole-subject-kept = El contorno del polígono que se recorta no cambia de lista y está { $side }: todo él es el anillo { $ring }.
wa-whole-subject-dropped = El contorno del polígono que se recorta no cambia de lista y está { $side }: no delimita nada.
wa-whole-hole-kept = El agujero { $hole } del polígono que se recorta no cambia de lista y está { $side }: es un agujero, { $ring }.
wa-whole-hole-dropped = El agujero { $hole } del polígono que se recorta no cambia de lista y está { $side }: no delimita nada.
wa-whole-clip-kept = El polígono de recorte no cambia de lista y está { $side }: todo él es el anillo { $ring }.
wa-whole-clip-dropped = El polígono de recorte no cambia de lista y está { $side }: no delimita nada.
wa-hole = El agujero { $hole } está dentro del anillo { $ring }.
wa-done-disjoint = Terminado: los dos polígonos no tienen ningún punto en común.
wa-done-touching = Terminado: los dos polígonos se tocan, pero no tienen área en común.
wa-done-subject = Terminado: el polígono que se recorta está dentro del polígono de recorte y no cambia.
wa-done-clip = Terminado: el polígono de recorte está dentro del polígono que se recorta y es la respuesta.
wa-done-equal = Terminado: los dos polígonos son el mismo, y la respuesta también.
wa-done-crossing =
    { $n ->
        [one] Terminado: un trozo.
       *[other] Terminado: { $n } trozos.
    }
wa-list-subject = Lista del polígono
wa-list-clip = Lista de recorte
wa-row-start = empezó en
wa-row-path = vértices del camino
wa-row-rings = anillos cerrados
code-wa-find = para cada arista de S: lista S ← vértice, intersecciones con C
code-wa-insert = para cada arista de C: lista C ← vértice, sus intersecciones
code-wa-label = marcar cada una: de entrada, de salida, contacto, estrangulamiento
code-wa-start = mientras quede una intersección de entrada: empezar ahí, en la lista S
code-wa-follow = seguir la lista, emitir sus vértices
code-wa-enter = en una de entrada: seguir por la lista S
code-wa-leave = en una de salida: seguir por la lista C
code-wa-close = de vuelta a un vértice emitido: cerrar el anillo
code-wa-whole = bordes sin entradas ni salidas: dentro ⇒ un anillo
code-wa-holes = dar cada agujero al anillo que lo rodea
words-wa-find = Copia en una lista, vértice a vértice, el polígono que se recorta, S. Detrás de cada vértice pon las intersecciones de su arista, en orden.
words-wa-insert = Copia igual el polígono de recorte C: las mismas intersecciones, en el orden de su propio borde.
words-wa-label = Marca cada intersección según lo que hace allí el polígono que se recorta. Una arista común cuenta como dentro si ambos bordes van en el mismo sentido y como fuera si van en sentido contrario.
words-wa-start = Toma una intersección de entrada por la que aún no ha pasado ningún recorrido y empieza ahí, en la lista del polígono que se recorta.
words-wa-follow = Sigue la lista de vértice en vértice y emite cada uno.
words-wa-enter = Donde ese polígono entra, y donde los bordes se estrangulan, sigue por la lista del polígono que se recorta.
words-wa-leave = Donde ese polígono sale, y donde los bordes se estrangulan, sigue por la lista del polígono de recorte.
words-wa-close = Cuando el recorrido llega a un vértice ya emitido, lo que queda en medio es un anillo. Cuando llega a su comienzo, termina.
words-wa-whole = Un borde en el que nunca se cambia de lista está entero dentro o entero fuera.
words-wa-holes = Un agujero pertenece al anillo en el que está.

## The verdict

verdict-vertex-kept = { $vertex } se conserva.
verdict-vertex-cut = { $vertex } se recorta aquí: es el primer borde más allá del cual está.
verdict-vertex-passed-by = Ningún recorrido pasa por { $vertex }: no está en el resultado.
verdict-edge-dropped = De { $from } a { $to } se quita la arista.
verdict-vertex-in = Desplazado { $move } hacia dentro, en perpendicular al borde ({ $edge }), { $vertex } se conservaría.
verdict-vertex-never = Ningún desplazamiento en perpendicular al borde ({ $edge }) conservaría { $vertex }.
verdict-vertex-out = Desplazado más de { $move } hacia fuera, en perpendicular al borde más cercano ({ $edge }), { $vertex } se recortaría.
verdict-vertex-touch = { $vertex } está sobre el borde ({ $edge }): con el menor desplazamiento hacia fuera se recortaría.
