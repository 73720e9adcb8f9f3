### Lo que se dice donde se cortan triángulos en el espacio: plano a plano, como un solo polígono, antes de la división.

## Métodos

alg-plane-at-a-time = Plano a plano
alg-intersection-polygon = Un solo polígono, en abanico al final
alg-textured-triangle = Un solo polígono con textura
alg-homogeneous-triangle = Triángulo antes de la división
alg-faulty-missed-edge = Erróneo: con d₀ = 0 el triángulo queda entero
alg-faulty-on-plane = Erróneo: estar en el plano cuenta como fuera
alg-faulty-kept-uv = Erróneo: (u, v) no se interpola
alg-undivided-texture = Erróneo: una textura sin la división
alg-faulty-edge-by-edge = Erróneo: tres aristas recortadas
alg-faulty-all-sides = Erróneo: los seis lados en fila
alg-faulty-divided-triangle = Erróneo: el triángulo se divide primero

## Vistas

tri-list-in = Lista de entrada
tri-list-out = Lista de salida
tri-list-given = Triángulo
tri-list-left = Lo que queda
tri-corners = vértices
tri-none = no hay triángulo
tri-not-asked = no se mira
tri-list-fan = Abanico desde V₀: { $vertices } − 2 = { $triangles ->
        [one] { $triangles } triángulo
       *[other] { $triangles } triángulos
    }
tally-triangles = triángulos
tally-crossings = cortes
tally-one-polygon = un solo polígono
tally-one-by-one = triángulo a triángulo
tally-same = Los dos métodos dejan los mismos { $n } vértices, hasta { $decimals } decimales.

## Un solo polígono

ip-opening = Un polígono contra { $planes ->
        [one] { $planes } plano
       *[other] { $planes } planos
    }: su lista empieza con los { $n ->
        [one] { $n } vértice
       *[other] { $n } vértices
    } del triángulo.
ip-plane = El plano { $plane } recibe una lista de { $n } vértices.
ip-first-inside = { $vertex } está dentro del plano { $plane }: se emite.
ip-first-outside = { $vertex } está fuera del plano { $plane }: no se emite.
ip-touch = { $from } → { $to }: { $rule }. El extremo sobre el plano es el propio corte.
ip-in-out = { $from } → { $to }: dentro → fuera. Se emite la intersección { $cut }.
ip-out-in = { $from } → { $to }: fuera → dentro. Se emiten la intersección { $cut } y después { $to }.
ip-closing-cross = La arista de cierre { $from } → { $to }: { $rule }. Se emite solo la intersección { $cut }.
ip-cross = { $from } → { $to } corta el plano { $plane } en { $cut }.
ip-output = { $vertex } pasa a la lista de salida, que ya tiene { $n }.
ip-pass-cuts = El plano { $plane } quita { $dropped } y pone { $cuts }: { $before } → { $after }.
ip-pass-drops = El plano { $plane } quita { $dropped }: { $before } → { $after }.
ip-pass-same = El plano { $plane } no corta nada: { $before } → { $after }.
ip-pass-empty = El plano { $plane } no deja nada: { $before } → { $after }.
ip-fan = Triángulo { $n } de { $total } del abanico: { $corners }.
ip-done = Terminado: { $vertices ->
        [one] { $vertices } vértice
       *[other] { $vertices } vértices
    }, un abanico de { $n ->
        [one] { $n } triángulo
       *[other] { $n } triángulos
    }, tras { $crossings ->
        [one] { $crossings } corte
       *[other] { $crossings } cortes
    }.
ip-done-empty = Terminado: { $n } triángulos. No queda nada con área ({ $vertices } vértices, { $crossings } cortes).
code-ip-each = para cada plano (n, D):
code-ip-first = si d(V₀) ≥ 0: emitir V₀
code-ip-distance = para cada arista S → P: d ← n·P + D
code-ip-inside = si d ≥ 0 y P ≠ V₀: emitir P
code-ip-cross = donde cambia el lado: emitir C
code-ip-pass = lista ← lo que ha salido
code-ip-fan = triángulos ← abanico de la lista
words-ip-each = Pregunta a cada plano por turno; su normal apunta hacia dentro.
words-ip-first = El primer vértice se emite si está dentro; el borde cuenta como dentro.
words-ip-distance = Sigue las aristas, la última de vuelta a V₀: la distancia con signo de cada final.
words-ip-inside = Después se emite el final si está dentro; V₀ ya está en la lista.
words-ip-cross = Donde una arista cambia de lado se emite su corte: t = d₁ / (d₁ − d₂).
words-ip-pass = Lo que ha salido es la lista del plano siguiente.
words-ip-fan = Un polígono convexo se divide en triángulos una sola vez, al final.

## Triángulo a triángulo

pat-opening = Triángulo a triángulo contra { $planes ->
        [one] { $planes } plano
       *[other] { $planes } planos
    }: la lista empieza con { $n } triángulo.
pat-plane =
    { $n ->
        [one] El plano { $plane } recibe { $n } triángulo.
       *[other] El plano { $plane } recibe { $n } triángulos.
    }
pat-three = { $triangle }: { $inside } vértices dentro del plano { $plane }. Queda entero.
pat-two = { $triangle }: { $inside } vértices dentro del plano { $plane }. Queda un cuadrilátero, dos triángulos.
pat-one = { $triangle }: { $inside } vértice dentro del plano { $plane }. Queda un triángulo.
pat-on = { $triangle }: { $inside } de 3 vértices dentro del plano { $plane }, { $on } de ellos sobre él.
pat-none = { $triangle }: { $inside } vértices dentro del plano { $plane }. Se descarta.
pat-option-three = Los tres vértices de { $triangle } están dentro.
pat-option-two = Dos vértices de { $triangle } están dentro.
pat-option-one = Un vértice de { $triangle } está dentro.
pat-option-none = Ningún vértice de { $triangle } está dentro.
pat-piece = Pieza { $n } de la lista de salida: { $corners }.
pat-pass =
    { $after ->
        [one] El plano { $plane } recibió { $before } y entrega { $after } triángulo.
       *[other] El plano { $plane } recibió { $before } y entrega { $after } triángulos.
    }
pat-pass-empty = El plano { $plane } recibió { $before } y entrega { $after }: no queda nada.
pat-done =
    { $n ->
        [one] Terminado: queda { $n } triángulo, tras { $crossings } cortes.
       *[other] Terminado: quedan { $n } triángulos, tras { $crossings } cortes.
    }
pat-done-empty = Terminado: quedan { $n ->
        [one] { $n } triángulo
       *[other] { $n } triángulos
    }, tras { $crossings ->
        [one] { $crossings } corte
       *[other] { $crossings } cortes
    }.
code-pat-each = para cada plano (n, D):
code-pat-triangle = para cada triángulo: contar d ≥ 0
code-pat-three = 3: conservarlo
code-pat-two = 2: cortar; dos triángulos
code-pat-one = 1: cortar; un triángulo
code-pat-none = 0: descartarlo
code-pat-pass = lista ← lo conservado
words-pat-each = Pregunta a cada plano por turno; su normal apunta hacia dentro.
words-pat-triangle = ¿Cuántos vértices del triángulo están dentro?
words-pat-three = Los tres: se conserva entero.
words-pat-two = Dos: queda un cuadrilátero, que se parte por su primer vértice.
words-pat-one = Uno: queda un triángulo menor.
words-pat-none = Ninguno: se descarta.
words-pat-pass = Lo conservado es la lista del plano siguiente.

## Antes de la división

ht-opening = { $n } vértices en el espacio de recorte, { $behind } de ellos con w ≤ 0: aún no se divide nada.
ht-divide = Los { $n } vértices se dividen por su w.
ht-codes-outside = Todos los vértices están más allá de un mismo lado: rechazado sin cortar, { $sides } lados nombrados.
ht-codes-inside = Ningún vértice está más allá de un lado: queda entero, { $sides } lados nombrados.
ht-codes-cut =
    { $sides ->
        [one] Solo se nombra { $sides } lado de seis: ese recorta.
       *[other] Solo se nombran { $sides } lados de seis: esos recortan.
    }
ht-side = El lado { $side } recibe { $n } vértices: una cota, ninguna división.
ht-inside = { $vertex } está dentro del lado { $side }.
ht-outside = { $vertex } está fuera del lado { $side }.
ht-cross = { $from } → { $to } corta el lado { $side } en I.
ht-pass = El lado { $side } ha terminado: { $before } → { $n }.
ht-done = Quedan { $n ->
        [one] { $n } vértice
       *[other] { $n } vértices
    }, un abanico de { $triangles ->
        [one] { $triangles } triángulo
       *[other] { $triangles } triángulos
    }: ahora se pueden dividir.
ht-done-empty = No queda nada con área: { $n } vértices, { $triangles } triángulos.
code-ht-codes = seis bits por vértice: w ± x, y, z < 0
code-ht-decide = OR = 0: conservar; AND ≠ 0: rechazar
code-ht-each = para cada lado que nombra el OR:
code-ht-first = si w ± x ≥ 0 en V₀: emitir V₀
code-ht-bound = para cada arista S → P: w ± x de P
code-ht-cross = donde cambia de signo: emitir I
code-ht-inside = si w ± x ≥ 0 y P ≠ V₀: emitir P
code-ht-fan = abanico, y luego dividir entre w
words-ht-codes = Un bit por cada lado de −w ≤ x, y, z ≤ w que el vértice sobrepasa.
words-ht-decide = Nada que recortar, o nada que ver.
words-ht-each = Solo hace falta preguntar por los lados que algún vértice sobrepasa.
words-ht-bound = La cota es una suma: sin división, y con w de cualquier signo.
words-ht-cross = Las cuatro coordenadas se interpolan con la misma t.
words-ht-fan = Lo que queda tiene w ≥ near > 0 y se puede dividir.

## ¿Qué está mal aquí?

faulty-missed-edge-differs = El paso { $step } es el primero que difiere: con d₀ = 0 ningún producto es negativo, y el triángulo quedó entero.
faulty-on-plane-differs = El paso { $step } es el primero que difiere: un vértice sobre el plano se tomó por exterior.
faulty-kept-uv-differs = El paso { $step } es el primero que difiere: el corte conservó el (u, v) del vértice exterior.
faulty-edge-by-edge-differs = El paso { $step } es el primero que difiere: cada arista se recorta por su cuenta, no como anillo.
faulty-all-sides-differs = El paso { $step } es el primero que difiere: se pregunta por un lado que ningún código nombra, y que no corta nada.
faulty-divided-triangle-differs = El paso { $step } es el primero que difiere: vértices con w < 0 se dividieron antes de recortar nada.
code-faulty-missed-edge = si d₀·d₁ < 0 o d₀·d₂ < 0: cortar
words-faulty-missed-edge = Se corta donde la primera distancia y otra difieren en signo.
code-faulty-on-plane = si d > 0 y P ≠ V₀: emitir P
code-faulty-on-plane-first = si d(V₀) > 0: emitir V₀
words-faulty-on-plane-first = El primer vértice se emite si está estrictamente dentro.
words-faulty-on-plane = Después se emite el final si está estrictamente dentro.
code-faulty-kept-uv = emitir C, uv(C) ← uv(V)
words-faulty-kept-uv = El corte toma el (u, v) del vértice al que sustituye.
code-undivided-texture = abanico, rellenar: uv uniforme en la pantalla
words-undivided-texture = El polígono se divide en abanico; en la pantalla se interpola (u, v) sin 1/w.
code-faulty-edge-by-edge = para cada plano: recortar cada arista
words-faulty-edge-by-edge = Pregunta a cada plano por turno; recorta las tres aristas como tres líneas.
code-faulty-all-sides = para cada uno de los seis lados:
words-faulty-all-sides = Se pregunta por los seis lados, uno tras otro.
code-faulty-divided-triangle = (x, y, z) ← (x, y, z)/w; luego seis bits
words-faulty-divided-triangle = Cada vértice se divide por su w antes de mirarlo.

## Casos

object-triangle-uv = coordenadas de textura
case-triangles-left =
    { $triangles ->
        [one] Queda { $triangles } triángulo.
       *[other] Quedan { $triangles } triángulos.
    }
case-triangles-none = No queda nada con área.
