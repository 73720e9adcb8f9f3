### What is said of segments in space: six-bit codes, inequalities, and clipping before the divide.

## Methods

alg-cohen-sutherland-3d = Cohen–Sutherland en el espacio
alg-liang-barsky-3d = Liang–Barsky en el espacio
alg-plane-line = Segmento contra planos
alg-homogeneous-line = Segmento antes de dividir
alg-faulty-divide-first = Erróneo: se divide primero

## What is asked, and what comes of it

space-line-opening-box = ¿Qué parte de P₁P₂ queda en la caja de −1 a 1?
space-line-opening-planes =
    ¿Qué parte de P₁P₂ está por dentro de { $planes ->
        [one] el plano
       *[other] los { $planes } planos
    }?
space-line-opening-clip = ¿Qué parte de P₁P₂ cumple −w ≤ x, y, z ≤ w?
space-line-touch = Se acepta: toca en un solo punto, { $at }.
space-line-point = Se acepta: los dos extremos son el mismo punto { $at }, y está dentro.

## Six-bit codes

space-line-code-inside = { $end } está dentro: { $code } = { $bits }.
space-line-code-one = { $end } está más allá del plano { $first }: { $code } = { $bits }.
space-line-code-two = { $end } está más allá de dos planos, el { $first } y el { $second }: { $code } = { $bits }.
space-line-code-three = { $end } está más allá de tres planos: el { $first }, el { $second } y el { $third }; { $code } = { $bits }.
space-line-or-accept = OR = { $bits }: los dos extremos están dentro.
space-line-or-open = OR = { $bits } ≠ 000000: no todo está dentro.
space-line-and-open = AND = { $bits }: ninguna cara deja fuera los dos extremos. Los códigos no deciden.
space-line-and-reject = AND = { $bits } ≠ 000000: los dos extremos están más allá del plano { $plane }.
space-line-choose = El último 1 es el del plano { $plane }: { $end } está más allá.
space-line-reject-codes = Se rechaza: los dos extremos están más allá del plano { $plane }; AND = { $and }.
space-line-note-code = Cada 1 indica una cara más allá de la cual está el punto.

## One inequality a plane

space-line-delta = P(u) = P₁ + u (P₂ − P₁): a lo largo del segmento, x, y, z cambian en Δx, Δy, Δz.
space-line-before = Los dos extremos tienen w ≥ 0: ninguno está detrás del ojo.
space-line-behind = { $end } tiene w < 0: está detrás del ojo y no debe dividirse entre w.
space-line-all-behind = Los dos extremos tienen w < 0: todo el segmento está detrás del ojo.
space-line-option-behind = Un extremo tiene w < 0.
space-line-divided = Los dos extremos se dividen entre w y se recortan después.
space-line-row = Plano { $plane }: { $direction }.
space-line-parallel-inside = Es paralelo al plano { $plane } y está por dentro: este plano, por sí solo, no decide nada.
space-line-parallel-outside = Es paralelo al plano { $plane } y está por fuera: no puede verse nada.
space-line-enter = La recta entra por el plano { $plane }: { $bound } sube.
space-line-enter-idle = La recta entra por el plano { $plane }, pero no después de { $bound }: nada cambia.
space-line-leave = La recta sale por el plano { $plane }: { $bound } baja.
space-line-leave-idle = La recta sale por el plano { $plane }, pero no antes de { $bound }: nada cambia.
space-line-put = { $end } pasa a { $symbol } = { $u }, en { $border }.
space-line-the-plane = el plano { $plane }
space-line-reject = Se rechaza en el plano { $plane }: del segmento no queda nada.
space-line-reject-behind = Se rechaza: ningún punto está delante del ojo.
space-line-note-enter = { $first } < { $second }, entra: { $bound } = max({ $bound }; { $crossing })
space-line-note-leave = { $first } > { $second }, sale: { $bound } = min({ $bound }; { $crossing })

## The w-lens

w-lens-eye = ojo
w-lens-screen = pantalla, w = 1
screen-divide-first = Dividir primero
screen-clip-first = Recortar primero
screen-wrong = mal: una parte que nunca existió
screen-same = lo mismo: ningún extremo está detrás del ojo
screen-no-image = un extremo no tiene imagen: w = 0
screen-so-far = lo que queda hasta ahora
screen-right = bien: lo que está delante del ojo
screen-nothing = no se ve nada

## Cases

case-no-point = (0; 0; 0; 0) no es un punto del espacio de recorte.
case-flat-box = La caja no tiene interior: { $low } y { $high } son ambos { $at }.

## Pseudocode

code-lb3-each = para cada cara k = 1 … 6: p, q
words-lb3-each = Para cada una de las seis caras, escribe «dentro» como una desigualdad u · p ≤ q.
code-pl-start = a_min ← 0; a_max ← 1
code-pl-each = para cada plano (n, D): d₁ ← n·P₁ + D; d₂ ← n·P₂ + D
code-pl-parallel = si d₁ = d₂ y d₁ < 0: rechazar
code-pl-enter = si d₁ < d₂: a_min ← max(a_min; d₁/(d₁ − d₂))
code-pl-leave = si d₁ > d₂: a_max ← min(a_max; d₁/(d₁ − d₂))
code-pl-empty = si a_min > a_max: rechazar
code-pl-accept = aceptar P(a_min) P(a_max)
words-pl-start = Empieza con el segmento entero, a de 0 a 1.
words-pl-each = Calcula, para cada plano, cuánto están dentro los dos extremos.
words-pl-enter = d crece: la recta entra por aquí. Antes de a no puede verse nada.
words-pl-leave = d disminuye: la recta sale por aquí. Después de a no puede verse nada.
code-hl-start = si w₁ < 0 y w₂ < 0: rechazar
code-hl-each = para cada lado x, y, z = ±w: d₁, d₂ ← w ± x, y, z
code-hl-enter = si d₁ < d₂: t_min ← max(t_min; d₁/(d₁ − d₂))
code-hl-leave = si d₁ > d₂: t_max ← min(t_max; d₁/(d₁ − d₂))
code-hl-empty = si t_min > t_max: rechazar
code-hl-accept = aceptar P(t_min) P(t_max); solo ahora dividir entre w
words-hl-start = Si los dos extremos están detrás del ojo, no se ve nada.
words-hl-each = Para cada lado, w más o menos una coordenada dice cuánto está dentro un punto.
words-hl-enter = d crece: la recta entra por aquí.
words-hl-leave = d disminuye: la recta sale por aquí.
words-hl-accept = Lo que queda tiene w ≥ near > 0: ahora se puede dividir entre w.
code-faulty-divide = P₁ ← P₁ / w₁; P₂ ← P₂ / w₂
code-faulty-divide-accept = aceptar P(t_min) P(t_max)
words-faulty-divide = Divide los dos extremos entre w.
words-faulty-divide-accept = Los extremos del intervalo se toman por los de la parte visible.
faulty-divide-first-differs = El paso { $step } es el primero que difiere: los dos extremos se dividieron entre w antes de recortar.
