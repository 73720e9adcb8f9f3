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
alg-faulty-edge-by-edge = Erróneo: cada arista como un segmento
alg-faulty-all-sides = Erróneo: los seis lados, uno tras otro
alg-faulty-divided-triangle = Erróneo: el triángulo se divide primero

## Vistas

tri-list-in = Lista de entrada
tri-list-out = Lista de salida
tri-list-given = Triángulo
tri-list-left = Lo que queda
tri-corners = vértices
tri-none = no hay triángulo
tri-not-asked = no se prueba
tri-list-fan = Abanico desde V₀: { $vertices } − 2 = { $triangles ->
        [one] { $triangles } triángulo
       *[other] { $triangles } triángulos
    }
tally-triangles = triángulos
tally-crossings = intersecciones
tally-one-polygon = un solo polígono
tally-one-by-one = triángulo a triángulo
tally-same = Los dos métodos dejan { $n ->
        [one] el mismo vértice ({ $n })
       *[other] los mismos { $n } vértices
    }, hasta { $decimals } decimales.

## Un solo polígono

ip-opening = Se recorta un polígono con { $planes ->
        [one] { $planes } plano
       *[other] { $planes } planos
    }: su lista empieza con los { $n ->
        [one] { $n } vértice
       *[other] { $n } vértices
    } del triángulo.
ip-plane = El plano { $plane } recibe una lista de { $n ->
        [one] { $n } vértice.
       *[other] { $n } vértices.
    }
ip-first-inside = { $vertex } está por dentro del plano { $plane }: se emite.
ip-first-outside = { $vertex } está por fuera del plano { $plane }: no se emite.
ip-touch = { $from } → { $to }: { $rule }. El extremo que está sobre el plano es la propia intersección.
ip-in-out = { $from } → { $to }: dentro → fuera. Se emite la intersección { $cut }.
ip-out-in = { $from } → { $to }: fuera → dentro. Se emiten la intersección { $cut } y después { $to }.
ip-closing-cross = La arista de cierre { $from } → { $to }: { $rule }. Se emite solo la intersección { $cut }.
ip-cross = { $from } → { $to } corta el plano { $plane } en { $cut }.
ip-output = { $vertex } pasa a la lista de salida, que ya tiene { $n ->
        [one] { $n } vértice.
       *[other] { $n } vértices.
    }
ip-pass-cuts = El plano { $plane } quita { $dropped } y añade { $cuts }: { $before } → { $after }.
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
    }. Intersecciones calculadas: { $crossings }.
ip-done-empty = Terminado: no queda nada con área. Triángulos: { $n }; vértices: { $vertices }; intersecciones calculadas: { $crossings }.
code-ip-each = para cada plano (n, D):
code-ip-first = si d(V₀) ≥ 0: emitir V₀
code-ip-distance = para cada arista S → P: d ← n·P + D
code-ip-inside = si d ≥ 0 y P ≠ V₀: emitir P
code-ip-cross = donde cambia el lado: emitir C
code-ip-pass = lista ← lo emitido
code-ip-fan = triángulos ← abanico de la lista
words-ip-each = Prueba cada plano por turno; su normal apunta hacia dentro.
words-ip-first = Emite el primer vértice si está dentro; el borde cuenta como dentro.
words-ip-distance = Sigue las aristas, la última de vuelta a V₀, y calcula la distancia con signo de cada final.
words-ip-inside = Después emite el final si está dentro; V₀ ya está en la lista.
words-ip-cross = Donde una arista pasa de un lado al otro, emite su intersección: t = d₁ / (d₁ − d₂).
words-ip-pass = Lo emitido es la lista para el plano siguiente.
words-ip-fan = El polígono convexo se divide en triángulos una sola vez, al final.

## Triángulo a triángulo

pat-opening = Cada triángulo se recorta con { $planes ->
        [one] { $planes } plano
       *[other] { $planes } planos, uno tras otro
    }: la lista empieza con { $n ->
        [one] { $n } triángulo.
       *[other] { $n } triángulos.
    }
pat-plane =
    { $n ->
        [one] El plano { $plane } recibe { $n } triángulo.
       *[other] El plano { $plane } recibe { $n } triángulos.
    }
pat-three = { $triangle }: { $inside } vértices por dentro del plano { $plane }. Se conserva entero.
pat-two = { $triangle }: { $inside } vértices por dentro del plano { $plane }. Queda un cuadrilátero: dos triángulos.
pat-one = { $triangle }: { $inside } vértice por dentro del plano { $plane }. Queda un triángulo.
pat-on = { $triangle }: { $inside } de 3 vértices por dentro del plano { $plane }. Sobre el plano: { $on }.
pat-none = { $triangle }: { $inside } vértices por dentro del plano { $plane }. Se descarta.
pat-option-three = Los tres vértices de { $triangle } están dentro.
pat-option-two = Dos vértices de { $triangle } están dentro.
pat-option-one = Un vértice de { $triangle } está dentro.
pat-option-none = Ningún vértice de { $triangle } está dentro.
pat-piece = Triángulo { $n } de la lista de salida: { $corners }.
pat-pass =
    { $after ->
        [one] El plano { $plane } recibió { $before } y entrega { $after } triángulo.
       *[other] El plano { $plane } recibió { $before } y entrega { $after } triángulos.
    }
pat-pass-empty = El plano { $plane } recibió { $before } y entrega { $after }: no queda nada.
pat-done = Terminado: { $n ->
        [one] queda { $n } triángulo,
       *[other] quedan { $n } triángulos,
    } tras { $crossings ->
        [one] { $crossings } intersección.
       *[other] { $crossings } intersecciones.
    }
pat-done-empty = Terminado: { $n ->
        [one] queda { $n } triángulo,
       *[other] quedan { $n } triángulos,
    } tras { $crossings ->
        [one] { $crossings } intersección.
       *[other] { $crossings } intersecciones.
    }
code-pat-each = para cada plano (n, D):
code-pat-triangle = para cada triángulo: contar d ≥ 0
code-pat-three = 3: conservarlo
code-pat-two = 2: cortar; dos triángulos
code-pat-one = 1: cortar; un triángulo
code-pat-none = 0: descartarlo
code-pat-pass = lista ← lo conservado
words-pat-each = Prueba cada plano por turno; su normal apunta hacia dentro.
words-pat-triangle = ¿Cuántos vértices del triángulo están dentro?
words-pat-three = Si están los tres, se conserva entero.
words-pat-two = Si están dos, queda un cuadrilátero, que se parte desde su primer vértice.
words-pat-one = Si está uno, queda un triángulo menor.
words-pat-none = Si no está ninguno, se descarta.
words-pat-pass = Los triángulos conservados son la lista para el plano siguiente.

## Antes de la división

ht-opening = Hay { $n } vértices en el espacio de recorte, { $behind } de ellos con w ≤ 0: aún no se divide nada.
ht-divide = Los { $n } vértices se dividen entre su w.
ht-codes-outside = Todos los vértices están más allá de un mismo lado: rechazado sin recortar; lados con algún 1: { $sides }.
ht-codes-inside = Ningún vértice está más allá de un lado: queda entero; lados con algún 1: { $sides }.
ht-codes-cut =
    { $sides ->
        [one] Solo { $sides } de los seis lados tiene algún 1: solo ese recorta.
       *[other] Solo { $sides } de los seis lados tienen algún 1: solo esos recortan.
    }
ht-side = El lado { $side } recibe { $n ->
        [one] { $n } vértice:
       *[other] { $n } vértices:
    } basta el signo de una suma, sin división.
ht-inside = { $vertex } está por dentro del lado { $side }.
ht-outside = { $vertex } está por fuera del lado { $side }.
ht-cross = { $from } → { $to } corta el lado { $side } en I.
ht-pass = El lado { $side } ha terminado: { $before } → { $n }.
ht-done = { $n ->
        [one] Queda { $n } vértice
       *[other] Quedan { $n } vértices
    }, un abanico de { $triangles ->
        [one] { $triangles } triángulo
       *[other] { $triangles } triángulos
    }: ahora se pueden dividir entre w.
ht-done-empty = No queda nada con área. Vértices: { $n }; triángulos: { $triangles }.
code-ht-codes = seis bits por vértice: w ± x, y, z < 0
code-ht-decide = OR = 0: conservar; AND ≠ 0: rechazar
code-ht-each = para cada lado con un 1 en el OR:
code-ht-first = si w ± x ≥ 0 en V₀: emitir V₀
code-ht-bound = para cada arista S → P: w ± x de P
code-ht-cross = donde cambia de signo: emitir I
code-ht-inside = si w ± x ≥ 0 y P ≠ V₀: emitir P
code-ht-fan = abanico, y luego dividir entre w
words-ht-codes = Da a cada vértice un bit por cada lado de −w ≤ x, y, z ≤ w más allá del cual está.
words-ht-decide = O no hay nada que recortar, o no hay nada que ver.
words-ht-each = Solo hace falta probar los lados más allá de los cuales está algún vértice.
words-ht-bound = La prueba es el signo de una suma: sin división, y con w de cualquier signo.
words-ht-cross = Las cuatro coordenadas se interpolan con el mismo t.
words-ht-fan = Lo que queda tiene w ≥ near > 0 y se puede dividir entre w.

## ¿Qué está mal aquí?

faulty-missed-edge-differs = El paso { $step } es el primero que difiere: con d₀ = 0 ningún producto es negativo, y el triángulo quedó entero.
faulty-on-plane-differs = El paso { $step } es el primero que difiere: un vértice sobre el plano se tomó por exterior.
faulty-kept-uv-differs = El paso { $step } es el primero que difiere: la intersección conservó el (u, v) del vértice exterior.
faulty-edge-by-edge-differs = El paso { $step } es el primero que difiere: cada arista se recorta por su cuenta, no como parte del contorno.
faulty-all-sides-differs = El paso { $step } es el primero que difiere: se prueba un lado que no tiene ningún 1, y que no corta nada.
faulty-divided-triangle-differs = El paso { $step } es el primero que difiere: los vértices se dividieron por w antes de recortar nada.
code-faulty-missed-edge = si d₀·d₁ < 0 o d₀·d₂ < 0: cortar
words-faulty-missed-edge = Se corta solo donde la primera distancia y otra difieren en signo.
code-faulty-on-plane = si d > 0 y P ≠ V₀: emitir P
code-faulty-on-plane-first = si d(V₀) > 0: emitir V₀
words-faulty-on-plane-first = Emite el primer vértice si está estrictamente dentro.
words-faulty-on-plane = Después emite el final si está estrictamente dentro.
code-faulty-kept-uv = emitir C, uv(C) ← uv(V)
words-faulty-kept-uv = La intersección toma el (u, v) del vértice al que sustituye.
code-undivided-texture = abanico, rellenar: uv lineal en la pantalla
words-undivided-texture = El polígono se divide en abanico; en la pantalla se interpola (u, v) sin 1/w.
code-faulty-edge-by-edge = para cada plano: recortar cada arista
words-faulty-edge-by-edge = Prueba cada plano por turno; recorta las tres aristas como tres segmentos.
code-faulty-all-sides = para cada uno de los seis lados:
words-faulty-all-sides = Se prueban los seis lados, uno tras otro.
code-faulty-divided-triangle = (x, y, z) ← (x, y, z)/w; luego seis bits
words-faulty-divided-triangle = Cada vértice se divide entre su w antes de probarlo.

## Casos

object-triangle-uv = coordenadas de textura
case-triangles-left =
    { $triangles ->
        [one] Queda { $triangles } triángulo.
       *[other] Quedan { $triangles } triángulos.
    }
case-triangles-none = No queda nada con área.
