### The lines lab: captions, watch table and controls.

## Said by several methods

line-opening = ¿Qué parte de P₁P₂ queda dentro de la ventana?
line-not-on-it = { $point }: fuera de P₁P₂
line-parallel = Es paralelo al { $edge }: no hay intersección.
line-reject-edge = Se rechaza: los dos extremos están más allá del { $edge }.
line-accept = Se acepta: visible desde { $p1 } hasta { $p2 }.
line-touch = Se acepta: el segmento toca la ventana en un solo punto, { $at }.
line-point = Se acepta: los dos extremos son el mismo punto { $at }, y está en la ventana.
param-left = { $min } < { $max }: queda una parte.
param-touch = { $min } = { $max }: queda un solo punto, y el borde cuenta como interior.
param-empty = { $min } > { $max }: no queda nada.
param-put-end = { $end } = { $at } ya estaba dentro: no cambia.
watch-crossings = intersecciones
watch-crossings-used = útiles
table-edge = borde
table-polygon-edge = arista
table-start = inicio
table-corner = esquina

## Brute force

bf-intersect = Halla la intersección con la recta del { $edge }.
bf-keep = Ninguna parte queda más allá del { $edge }: esta intersección no hacía falta.
bf-keep-parallel = Ninguna parte queda más allá del { $edge }: este borde no cambia nada.
bf-cut = { $end } está más allá de { $border }: pasa a { $to }.
bf-option-none = Ninguna parte queda más allá del { $edge }.
bf-option-one = Un extremo está más allá del { $edge }.
bf-option-both = Los dos extremos están más allá del { $edge }.
bf-note-tests = Un punto está dentro si supera las cuatro pruebas.
bf-in-vain = no hacía falta
bf-kept = { $part } es visible
code-bf-each = para cada borde no paralelo a P₁P₂
code-bf-intersect = X ← recta P₁P₂ ∩ recta del borde
code-bf-reject = si ambos más allá: rechazar
code-bf-cut = si uno más allá: extremo ← X
code-bf-accept = aceptar P₁P₂
words-bf-each = Toma los cuatro bordes, uno tras otro; salta los que sean paralelos al segmento.
words-bf-intersect = Calcula dónde se cortan la recta del segmento y la del borde.
words-bf-reject = Si los dos extremos están más allá del borde, no se ve nada.
words-bf-cut = Si solo uno está más allá, llévalo a la intersección.
words-bf-accept = Lo que queda es visible.

## Cohen–Sutherland

cs-code = { $end } está { $region }: { $code } = { $bits }.
cs-or-accept = OR = { $bits }: los dos extremos están dentro.
cs-or-open = OR = { $bits } ≠ 0000: no todo está dentro.
cs-and-reject = AND = { $bits } ≠ 0000: los dos extremos están más allá del { $edge }.
cs-and-open = AND = { $bits }: ningún borde deja fuera los dos extremos. Los códigos no deciden.
cs-choose = El último 1 es el del { $edge }: { $end } está más allá.
cs-cut = { $end } se recorta en { $border }.
cs-reject = Se rechaza: los dos extremos están { $region }; AND = { $and }.
cs-reject-two = Se rechaza: los dos extremos están fuera de la ventana.
cs-option-inside = Los dos extremos están dentro.
cs-option-not-inside = No todo está dentro.
cs-option-undecided = Ningún borde deja fuera los dos extremos.
cs-option-beyond = Los dos extremos están más allá de un mismo borde.
cs-note-code = Cada 1 indica un borde más allá del cual está el punto.
cs-note-order = En el orden superior, inferior, derecho, izquierdo, el código es { $other }.
cs-note-or = OR pone un 1 donde lo tiene alguno de los dos.
cs-note-and = AND conserva un 1 solo donde lo tienen los dos.
cs-cuts = corte
cs-this-order = este orden:
cs-usual-order = orden habitual:
code-cs-codes = code₁ ← code(P₁); code₂ ← code(P₂)
code-cs-loop = repetir
code-cs-accept = si code₁ OR code₂ = 0: aceptar
code-cs-reject = si code₁ AND code₂ ≠ 0: rechazar
code-cs-choose = borde ← último 1 de code₁ OR code₂
code-cs-end = P ← el extremo cuyo código lo tiene
code-cs-cut = P ← P₁P₂ ∩ borde
code-cs-recode = código de P ← code(P)
words-cs-codes = Da un código a cada extremo: un bit para cada borde, 1 si está más allá.
words-cs-loop = Repite:
words-cs-accept = Si no hay ningún 1 en los códigos, todo lo que queda es visible.
words-cs-reject = Si los códigos tienen un 1 en común, los dos extremos están más allá del mismo borde.
words-cs-choose = Si no, toma el borde del último 1.
words-cs-end = Exactamente un extremo está más allá de él.
words-cs-cut = Lleva ese extremo adonde el segmento cruza el borde.
words-cs-recode = Dale un código nuevo.
alg-faulty-looks-once = Erróneo: se corta una sola vez
faulty-looks-once-differs = El paso { $step } es el primero que difiere: tras un corte, el programa acepta lo que queda, diga lo que diga el código nuevo.
code-faulty-looks-once = si ya hay un corte o code₁ OR code₂ = 0: aceptar
words-faulty-looks-once = Si ningún código tiene bits 1, o ya se ha cortado un extremo, todo lo que queda es visible.
alg-faulty-two-outside = Erróneo: se rechaza con los dos extremos fuera
faulty-two-outside-differs = El paso { $step } es el primero que difiere: ningún código es 0 y el programa rechaza, aunque ningún borde deje fuera a los dos extremos.
code-faulty-two-outside = si code₁ ≠ 0 y code₂ ≠ 0: rechazar
words-faulty-two-outside = Si cada código tiene algún bit 1, los dos extremos están fuera y no se ve nada.
settings-bit-order = Orden de los bits
bit-order-tbrl = arriba, abajo, derecha, izquierda
bit-order-lrbt = izquierda, derecha, abajo, arriba

## Liang–Barsky

lb-delta = P(u) = P₁ + u (P₂ − P₁): a lo largo del segmento, x e y cambian en Δx y Δy.
lb-row = k = { $k } ({ $edge }): u · p ≤ q, { $direction }.
lb-parallel-inside = Es paralelo al { $edge } y está por dentro: este borde, por sí solo, no decide nada.
lb-parallel-outside = Es paralelo al { $edge } y está por fuera: ningún valor de u sirve.
lb-parallel-forgotten = El segmento es paralelo al { $edge }: el programa sigue sin comprobar nada.
lb-enter = La recta entra por el { $edge }: u_min sube.
lb-enter-idle = La recta entra por el { $edge }, pero no después de u_min: nada cambia.
lb-leave = La recta sale por el { $edge }: u_max baja.
lb-leave-idle = La recta sale por el { $edge }, pero no antes de u_max: nada cambia.
lb-put = { $end } pasa a u = { $u }, en { $border }.
lb-reject = Se rechaza en el { $edge }: del segmento no queda nada.
lb-note-enter = p < 0, entra: { $bound } = max({ $bound }; r)
lb-note-leave = p > 0, sale: { $bound } = min({ $bound }; r)
lb-note-parallel = p = 0: paralelo; dentro si q ≥ 0
code-lb-start = u_min ← 0; u_max ← 1; Δ ← P₂ − P₁
code-lb-each = para cada borde k = 1 … 4: p, q
code-lb-parallel = si p = 0 y q < 0: rechazar
code-lb-enter = si p < 0: u_min ← max(u_min; q/p)
code-lb-leave = si p > 0: u_max ← min(u_max; q/p)
code-lb-empty = si u_min > u_max: rechazar
code-lb-accept = aceptar P(u_min) P(u_max)
words-lb-start = Empieza con el segmento entero, u de 0 a 1.
words-lb-each = Para cada borde, escribe «dentro» como una desigualdad u · p ≤ q.
words-lb-parallel = p = 0: el segmento es paralelo al borde; si está por fuera, recházalo.
words-lb-enter = p < 0: la recta entra por aquí. Antes de q/p no puede verse nada.
words-lb-leave = p > 0: la recta sale por aquí. Después de q/p no puede verse nada.
words-lb-empty = Si el intervalo está vacío, no se ve nada.
words-lb-accept = Si no, los extremos del intervalo son los de la parte visible.
alg-faulty-parallel = Erróneo: con p = 0 no se comprueba nada
faulty-parallel-differs = El paso { $step } es el primero que difiere: p = 0 y q < 0, así que el segmento queda fuera de este borde, pero el programa sigue.
code-faulty-parallel = si p = 0: borde siguiente
words-faulty-parallel = p = 0: el segmento es paralelo al borde; pasa al borde siguiente.

## Cyrus–Beck

cb-edge-entering = { $edge }: n·D > 0, la recta entra.
cb-edge-leaving = { $edge }: n·D < 0, la recta sale.
cb-edge-parallel = { $edge }: n·D = 0, la recta es paralela a la arista.
cb-parallel-inside = Es paralelo a { $edge } y está por dentro: esta arista, por sí sola, no decide nada.
cb-parallel-outside = Es paralelo a { $edge } y está por fuera: ningún valor de t sirve.
cb-enter = La recta entra por { $edge }: t_min sube.
cb-enter-idle = La recta entra por { $edge }, pero no después de t_min: nada cambia.
cb-leave = La recta sale por { $edge }: t_max baja.
cb-leave-idle = La recta sale por { $edge }, pero no antes de t_max: nada cambia.
cb-put = { $end } pasa a t = { $t }, en { $edge }.
cb-reject = Se rechaza en { $edge }: del segmento no queda nada.
cb-sign-enters = { $product } > 0: la recta entra
cb-sign-leaves = { $product } < 0: la recta sale
cb-sign-parallel = { $product } = 0: la recta es paralela
cb-sign-inside = { $product } > 0: { $end } está dentro
cb-sign-on = { $product } = 0: { $end } está en la arista
cb-sign-outside = { $product } < 0: { $end } está fuera
cb-measured = Medido a lo largo de { $normal }, desde la arista
alg-faulty-normals = Erróneo: todas las normales apuntan hacia fuera
faulty-normals-differs = El paso { $step } es el primero que difiere: la normal apunta hacia fuera, y entrar se toma por salir.
code-cb-start = t_min ← 0; t_max ← 1; D ← P₂ − P₁
code-cb-each = para cada arista: n; w ← P₁ − E
code-cb-parallel = si n·D = 0 y n·w < 0: rechazar
code-cb-enter = si n·D > 0: t_min ← max(t_min; −n·w/n·D)
code-cb-leave = si n·D < 0: t_max ← min(t_max; −n·w/n·D)
code-cb-empty = si t_min > t_max: rechazar
code-cb-accept = aceptar P(t_min) P(t_max)
words-faulty-normals = Para cada arista, gírala a la izquierda y tómala por normal, sea cual sea el sentido de los vértices.
words-cb-start = Empieza con el segmento entero, t de 0 a 1.
words-cb-each = Para cada arista, toma su normal, que apunta hacia dentro.
words-cb-parallel = n·D = 0: paralelo a la arista; si está por fuera, recházalo.
words-cb-enter = n·D > 0: a favor de la normal, así que la recta entra por aquí.
words-cb-leave = n·D < 0: en contra de la normal, así que la recta sale por aquí.
words-cb-empty = Si el intervalo está vacío, no se ve nada.
words-cb-accept = Si no, los extremos del intervalo son los de la parte visible.

## Nicholl–Lee–Nicholl

nln-region = { $end } está { $region }.
nln-option-region = { $end } está { $option }.
nln-side-enters = P₂ está { $turn } de la recta que va de P₁ a { $corner }: primero se cruza el { $first }.
nln-side-meets = P₂ está { $turn } de la recta que va de P₁ a { $corner }: primero se cruza el { $first }.
nln-side-leaves = P₂ está { $turn } de la recta que va de P₁ a { $corner }: sale por el { $first }.
nln-side-through = P₂ está sobre la recta que va de P₁ a { $corner }: se cruzan los dos bordes a la vez.
nln-option-side = La recta que va de P₁ a { $corner }: P₂ está { $option }.
nln-miss = Se rechaza: el segmento pasa por fuera de { $corner }, más allá del { $edge }.
nln-sector-inside = Los dos extremos están dentro: no hace falta ninguna intersección.
nln-sector-enters = Entra por el { $enters } y P₂ está dentro: una intersección.
nln-sector-leaves = P₁ está dentro; sale por el { $leaves }: una intersección.
nln-sector-both = Entra por el { $enters } y sale por el { $leaves }: dos intersecciones, las dos útiles.
nln-question-enters = por dónde entra
nln-question-meets = si llega a entrar
nln-question-leaves = por dónde sale
nln-note-products = Desde la esquina: P₁ = (a₁; b₁), P₂ = (a₂; b₂)
turn-left = a la izquierda
turn-through = sobre ella
turn-right = a la derecha
watch-region-1 = región de P₁
watch-region-2 = región de P₂
watch-enters = entra por
watch-leaves = sale por
code-nln-regions = región de P₁, región de P₂
code-nln-shared = si ambos más allá de un mismo borde: rechazar
code-nln-enters = si P₁ en región de esquina: recta → entra por
code-nln-meets = si pasa por fuera de la esquina: rechazar
code-nln-leaves = si P₂ en región de esquina: recta → sale por
code-nln-cut = P₁, P₂ ← la intersección o las dos
words-nln-regions = Averigua en qué región está cada extremo.
words-nln-shared = Si los dos están más allá del mismo borde, no se ve nada.
words-nln-enters = Si P₁ está en una región de esquina, la recta que pasa por esa esquina dice por qué borde entra el segmento.
words-nln-meets = Si P₂ está más allá de un borde contiguo, la recta que pasa por la esquina común dice si el segmento llega a la ventana.
words-nln-leaves = Si P₂ está en una región de esquina, la recta que pasa por esa esquina dice por qué borde sale.
words-nln-cut = Calcula solo esas intersecciones.

## Handles, by name

handle-end = { $end }
handle-segment = el segmento
handle-window = la ventana
handle-side = { $edge }
handle-corner-bottom-left = la esquina inferior izquierda
handle-corner-bottom-right = la esquina inferior derecha
handle-corner-top-left = la esquina superior izquierda
handle-corner-top-right = la esquina superior derecha
handle-vertex = vértice { $number }

## The scene

action-add-segment = Añadir un segmento
action-remove-segment = Quitar el segmento
batch-title = Segmentos al azar
batch-count = Cuántos
batch-seed = Semilla
batch-again = Otro conjunto, con la semilla siguiente
batch-make = Reemplazar todos los segmentos

## Costs, measured

cost-measure = Medir en este equipo…
cost-of-all-segments = { $count ->
        [one] el segmento ({ $count })
       *[other] los { $count } segmentos
    }: divisiones { $divisions }, multiplicaciones { $multiplications }, sumas { $additions }, comparaciones { $comparisons }
measure-title = Lo que cuesta un segmento
measure-about = Todos los métodos recortan los mismos segmentos al azar, aquí y ahora.
measure-start = Medir
measure-again = Medir de nuevo
measure-nanos = Nanosegundos
measure-operations = Operaciones
measure-batch = Por lotes, sin saltos
measure-note = Por segmento, promedio de { $count }. El tiempo es el de la más rápida de cinco pasadas.

## The verdict

verdict-part-dropped = Este paso quita el segmento de { $from } a { $to }.
verdict-line-between = La recta entra ({ $enters }) solo después de haber salido ({ $leaves }).
verdict-line-in = Desplazado { $move } hacia dentro, en perpendicular al borde ({ $edge }), sería visible.
verdict-line-back = Desplazado { $move } hacia fuera, en perpendicular al borde ({ $edge }), sería visible.
verdict-line-never = Ningún desplazamiento en perpendicular al borde ({ $edge }) lo haría visible.
verdict-line-out = Desplazado más de { $move } hacia fuera, en perpendicular al borde más cercano ({ $edge }), desaparecería.
verdict-line-touch = Solo toca el borde ({ $edge }): con el menor desplazamiento hacia fuera desaparecería.
