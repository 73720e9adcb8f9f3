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

## Sutherland–Hodgman

alg-sutherland-hodgman = Sutherland–Hodgman
alg-sutherland-hodgman-pipeline = Sutherland–Hodgman, en cadena
rule-in-in = dentro → dentro
rule-in-out = dentro → fuera
rule-out-in = fuera → dentro
rule-out-out = fuera → fuera
sh-inside = dentro
sh-outside = fuera
sh-bridge = puente
sh-opening = Se recorta el polígono entero, { $n } vértices, contra un borde de la región tras otro: { $edges } bordes.
sh-edge-side = Recorte contra el { $edge }: dentro es { $inside }.
sh-edge = Recorte contra { $edge }: dentro es { $inside }.
sh-first-inside = El primer vértice, { $vertex }, está dentro: se emite.
sh-first-outside = El primer vértice, { $vertex }, está fuera: no se emite nada.
sh-in-in = { $from } → { $to }: dentro → dentro. Se emite { $to }.
sh-in-out = { $from } → { $to }: dentro → fuera. Se emite la intersección I.
sh-in-out-touch = { $from } → { $to }: dentro → fuera. { $from } está sobre el borde y es la propia intersección: ya figura en la lista.
sh-out-in = { $from } → { $to }: fuera → dentro. Se emiten la intersección I y después { $to }.
sh-out-in-touch = { $from } → { $to }: fuera → dentro. { $to } está sobre el borde y es la propia intersección: se emite una sola vez.
sh-out-out = { $from } → { $to }: fuera → fuera. No se emite nada.
sh-closing-cross = La arista de cierre { $from } → { $to }: { $rule }. Se emite solo la intersección I.
sh-closing = La arista de cierre { $from } → { $to }: { $rule }. No se emite nada más.
sh-cross = { $from } → { $to } corta { $border } en I.
sh-output = { $vertex } entra en la lista de salida como { $place }.
sh-pass = { $border } está listo: la lista de salida, de longitud { $n }, es la próxima lista de entrada.
sh-pass-empty = { $border } está listo: la lista de salida tiene longitud { $n }. No queda nada que recortar.
sh-done-empty = Fin: nada del polígono está en la región. Longitud de la última lista: { $n }; bordes de recorte: { $edges }.
sh-done-whole = Fin: los { $n } vértices están dentro de los { $edges } bordes. El polígono queda como estaba.
sh-done-cut = Fin tras { $edges } bordes: queda un anillo de { $n } vértices.
sh-done-degenerate = Fin tras { $edges } bordes: lo que queda no tiene área. Longitud de la última lista: { $n }.
code-sh-each = para cada borde de recorte: salida ← vacía
code-sh-first = F ← primer vértice; si está dentro: emitir F
code-sh-edges = para cada arista S → P, la última hasta F:
code-sh-in-in = dentro → dentro: emitir P
code-sh-in-out = dentro → fuera: emitir I
code-sh-out-in = fuera → dentro: emitir I, P
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

pipe-opening = Los { $edges } recortadores a la vez: los { $n } vértices pasan por ellos uno a uno.
pipe-send = { $vertex } = { $at } del polígono entra en el primer recortador, { $border }.
pipe-enter = { $vertex } = { $at } pasa al recortador siguiente, { $border }.
pipe-first-inside = Es el primer vértice que llega al recortador { $border }: se guarda como F y, como está dentro, sigue adelante.
pipe-first-outside = Es el primer vértice que llega al recortador { $border }: se guarda como F y, como está fuera, no sigue.
pipe-vertex = S → P: { $rule }. P sigue adelante.
pipe-crossing = S → P: { $rule }. Sigue adelante la intersección I.
pipe-both = S → P: { $rule }. Sigue adelante la intersección I y después P.
pipe-nothing = S → P: { $rule }. No hay intersección, y P no sigue.
pipe-closing-cross = La arista de cierre S → F: { $rule }. Sigue adelante la intersección I.
pipe-closing = La arista de cierre S → F: { $rule }. No sigue nada.
pipe-cross = S y el vértice siguiente están a uno y otro lado de { $border }: la arista lo corta en I.
pipe-output = { $at } sale del último recortador: es { $vertex } del anillo, definitivamente.
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
words-pipe-output = Detrás del último recortador, un vértice pertenece a la respuesta.
words-pipe-close = Al final, cada recortador mira a su vez la arista que vuelve de su último vértice a F.

## Sutherland–Hodgman, con errores a propósito

alg-faulty-on-border = Erróneo: el borde cuenta como fuera
alg-faulty-open = Erróneo: falta la arista de cierre
alg-faulty-clockwise = Erróneo: los bordes se recorren en sentido horario
alg-faulty-twice = Erróneo: las intersecciones se emiten dos veces
alg-faulty-end-first = Erróneo: el final va antes que la intersección
faulty-on-border-differs = El paso { $step } es el primero que difiere: un vértice sobre el borde se toma por exterior.
faulty-open-differs = El paso { $step } es el primero que difiere: la arista de cierre, del último vértice al primero, no se mira nunca.
faulty-clockwise-differs = El paso { $step } es el primero que difiere: los bordes se recorren en sentido horario, y se toma por interior el lado equivocado de cada uno.
faulty-twice-differs = El paso { $step } es el primero que difiere: la misma intersección se emite por segunda vez.
faulty-end-first-differs = El paso { $step } es el primero que difiere: la arista entra, y su final se emite antes que su intersección.
