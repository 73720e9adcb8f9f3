### Demostraciones con dibujos: de dónde salen las fórmulas.

## Vistas

why-view-section = A lo largo del plano, longitudes reales

## t por triángulos semejantes

why-similar = Por qué: t = d₁ / (d₁ − d₂)
why-similar-opening = ¿Qué parte t del camino de P₁ a P₂ hay que recorrer hasta el plano { $plane }?
why-similar-d1 = El valor de n·P + D en P₁ dice a cuántos niveles del plano está P₁.
why-similar-d2 = Lo mismo en P₂.
why-similar-levels = De P₁ a P₂ el segmento pasa por todos los niveles entre esos dos valores.
why-similar-parallel = Todo el segmento está en un mismo nivel: es paralelo al plano y no hay t.
why-similar-piece = Todos los triángulos entre dos niveles tienen los mismos ángulos, así que un cambio de 1 ocupa en todas partes el mismo trozo del segmento.
why-similar-t = El plano es el nivel 0. De P₁ al plano el valor cambia en −d₁, y en todo el camino, en d₂ − d₁.
why-code-d1 = d₁ ← n·P₁ + D;  d₂ ← n·P₂ + D
why-words-d1 = Halla el nivel de cada extremo.
why-code-levels = niveles ← d₂ − d₁
why-words-levels = Cuenta los niveles de un extremo al otro.
why-code-piece = trozo ← 1 / niveles
why-words-piece = Cada nivel ocupa el mismo trozo del segmento.
why-code-t = t ← −d₁ · trozo = d₁ / (d₁ − d₂)
why-words-t = De P₁ al plano hay −d₁ niveles.

## n·(P − p₀) como sombra

why-view-above = Visto desde arriba
why-view-side = Visto de lado
why-view-front = Visto de frente
why-shadow = Por qué: d = n·(P − p₀)
why-shadow-opening = Avanza de p₀, un punto del plano { $plane }, a P con pasos a lo largo de los ejes. La luz llega paralela al plano.
why-shadow-piece = El paso a lo largo de { $axis } proyecta su propia sombra sobre n, tan larga como el paso multiplicado por esta componente de n.
why-shadow-sum = Puestas una tras otra, las sombras de los pasos son la sombra de todo el camino P − p₀.
why-shadow-distance = La sombra y la perpendicular son lados opuestos de un rectángulo, así que la sombra es la distancia d de P al plano { $plane }.
why-shadow-elsewhere = Desde p₀ = { $other } cada sombra es otra, pero la suma es la misma.
why-code-steps = para cada eje: paso ← P − p₀
why-words-steps = Avanza de un punto del plano a P, eje por eje.
why-code-shadow = sombra ← paso · componente de n
why-words-shadow = Cada paso proyecta una sombra sobre la normal.
why-code-sum = n·(P − p₀) ← suma de las sombras
why-words-sum = Las sombras se suman.
why-code-rectangle = d ← n·(P − p₀) = n·P + D
why-words-rectangle = La perpendicular es tan larga como la sombra, sea cual sea el punto p₀.

## Franjas: por qué p < 0 es «entra»

why-view-strips = x e y en función de u, cada una con su franja de la ventana
why-in = entra
why-out = sale
why-strips = Por qué: p < 0 es «entra» y p > 0 es «sale»
why-strips-opening = En función de u, las dos coordenadas son rectas, y la ventana es una franja para cada una.
why-strips-in = La recta entra en su franja por el { $edge }.
why-strips-out = La recta sale de su franja por el { $edge }.
why-strips-level = La recta es horizontal y queda siempre del lado interior del { $edge }.
why-strips-beyond = La recta es horizontal y queda siempre más allá del { $edge }: no se ve ninguna parte.
why-strips-from = Las dos franjas contienen la recta solo después de la última entrada.
why-strips-empty = La primera salida llega antes que la última entrada: no hay ningún u en que las dos franjas contengan la recta.
why-strips-to = De la última entrada a la primera salida, las dos franjas contienen la recta.
why-code-strip = para cada borde de una franja:
why-words-strip = Izquierda y derecha limitan la franja de x; abajo y arriba, la de y.
why-code-in = si p < 0: entra en u = q / p
why-words-in = Una recta que sube entra por abajo; una que baja, por arriba.
why-code-out = si p > 0: sale en u = q / p
why-words-out = Por el otro borde de la franja sale.
why-code-level = si p = 0: siempre dentro, o nunca
why-words-level = Una recta horizontal no cruza ningún borde de su franja.
why-code-both = u_min ← última entrada;  u_max ← primera salida
why-words-both = Se ve lo que las dos franjas contienen.

## La fila 3 de la proyección

why-view-depth = z′ en función de la profundidad, entre −w y w
why-projection-row = Por qué: la fila 3 de la proyección
why-row-opening = La fila 3 da z′ = a · profundidad + b. ¿Qué a y b ponen las profundidades de { $near } a { $far } entre −w y w?
why-row-near = El plano cercano, a profundidad { $near }, tiene que quedar en el borde inferior.
why-row-far = El plano lejano, a profundidad { $far }, tiene que quedar en el borde superior.
why-row-slope = Solo una recta pasa por los dos puntos. De uno al otro, z′ aumenta en { $climb } y la profundidad en { $way }: a es el cociente.
why-row-start = Prolongada hacia atrás hasta la profundidad 0, la recta empieza en b.
why-row-point = P está a profundidad { $depth }; la recta da su z′.
why-row-divided = En una recta que parte de 0, el cociente z′ / w es igual en todos los puntos: se lee en la regla graduada del plano lejano.
why-row-middle = Cada uno de { $steps } pasos iguales de profundidad se lee en la regla, por su propia recta desde 0. La primera mitad, de −1 a 0, la ocupan las profundidades de { $near } a { $middle }.
why-code-near-far = cercano ↦ z′ = −w;  lejano ↦ z′ = w
why-words-near-far = Dos condiciones: cada plano va a su borde.
why-code-slope = a ← (w_lejano + w_cercano) / (lejano − cercano)
why-words-slope = Dos puntos fijan una recta, y con ella su pendiente.
why-code-start = b ← −w_cercano − a · cercano
why-words-start = Donde empieza la recta, a profundidad 0.
why-code-row = z′ ← a · profundidad + b = −a · z + b
why-words-row = La profundidad es −z, así que la fila 3 es 0 0 −a b.
why-code-divide = z′ / w
why-words-divide = Después de dividir, las profundidades cercanas al plano lejano se apiñan.

## n·e > 0

why-view-bar = Cada cara de canto, con la normal hacia arriba
why-facing = Por qué: con n·e > 0, la cara mira al ojo
why-facing-opening = La barra es la cara { $face }, vista de canto, con la normal hacia arriba. ¿Está el ojo por encima o por debajo de la barra?
why-facing-product = n·e es la longitud de n por la sombra de e sobre n.
why-facing-length = La longitud de n es positiva, así que no cambia el signo.
why-facing-no-length = Esta cara no tiene área, así que no tiene normal ni lado que mostrar.
why-facing-above = La sombra de e es la altura del ojo sobre el plano de la cara { $face }: el ojo la ve por delante.
why-facing-below = La sombra de e apunta al otro lado: el ojo no está por encima del plano de la cara { $face }, así que no la ve por delante.
why-facing-other-above = Para la cara { $face }, el ojo está por encima de la barra.
why-facing-other-below = Para la cara { $face }, el ojo no está por encima de la barra.
why-facing-fronts = { $fronts ->
    [one] El ojo queda por encima de la barra para { $fronts } de { $faces } caras: esa se ve por delante, y su n·e es positivo.
   *[other] El ojo queda por encima de la barra para { $fronts } de { $faces } caras: esas se ven por delante, y su n·e es positivo.
}
why-code-product = n·e = |n| · sombra de e sobre n
why-words-product = Un producto escalar es una longitud por una sombra.
why-code-height = altura ← n·e / |n|
why-words-height = A qué altura está el ojo sobre el plano de la cara.
why-code-bar = para cada una de las demás caras: la misma barra
why-words-bar = Vista de canto, cada cara es una barra.
why-code-front = delantera ⇔ altura > 0 ⇔ n·e > 0
why-words-front = El signo, por sí solo, ya dice de qué lado está el ojo.
why-depth = profundidad
why-quarter-turn = Por qué: la normal de un plano lateral
why-mirrored = n del plano izquierdo
why-turn-opening = Visto desde arriba, el plano derecho es una recta que pasa por el ojo. Se busca su normal, y luego la distancia de P.
why-turn-tangent = Por cada unidad hacia delante el plano se aparta esto hacia el lado: la tangente de la mitad del ángulo de visión, α.
why-turn-across = Una unidad a lo largo del plano avanza esto de través: el seno de α.
why-turn-ahead = La misma unidad avanza esto hacia delante: el coseno de α.
why-turn-turned-across = El triángulo gira 90° hacia dentro. El cateto que iba hacia delante va ahora de través, a la izquierda.
why-turn-turned-ahead = El cateto que iba de través va ahora hacia delante. Hacia delante es −z, así que la normal es (−cos α; 0; −sen α).
why-turn-distance = La longitud de n sigue siendo 1, así que n·P es la distancia de P al plano derecho.
why-code-tangent = tan α ← aspecto · tan (ángulo / 2)
why-words-tangent = La mitad del ángulo de visión dice cuánto se abre el plano.
why-code-unit = una unidad a lo largo del plano: (sen α; cos α)
why-words-unit = Una unidad tiene dos catetos, de través y hacia delante.
why-code-turn = girada 90°: (−cos α; sen α)
why-words-turn = Los catetos cambian de lugar, y uno cambia de signo.
why-code-check = d ← n·P + D
why-words-check = Un giro conserva las longitudes, así que n mide 1.
why-view-screen = En la pantalla: postes de altura 1
why-fence = Por qué: 1 / profundidad es lineal
why-fence-opening = A lo largo de una arista de la escena hay una valla de postes de altura 1. ¿Dónde la encuentran pasos iguales en la pantalla?
why-fence-nothing = Una cámara en perspectiva no ve ninguna arista de lado: no hay valla que dividir en { $steps } pasos.
why-fence-first = El primer poste está a profundidad { $depth }.
why-fence-last = El último poste está a profundidad { $depth }.
why-fence-post = El paso { $post } en la pantalla es tan ancho como los demás; su línea de visión encuentra la valla a profundidad { $depth }, tras { $before }.
why-fence-height = En la pantalla un poste de altura 1 mide 1 / profundidad.
why-fence-drop = El borde superior de la valla es recto en el espacio, así que también lo es en la pantalla, del primer poste al último.
why-fence-step = Bajo una recta, pasos iguales quitan cantidades iguales: cada paso en la pantalla quita esto de 1 / profundidad.
why-code-ends = profundidad del primer y del último poste
why-words-ends = La valla está entre dos vértices.
why-code-posts = para cada paso igual en la pantalla: profundidad de la valla
why-words-posts = Pasos iguales en la pantalla son pasos desiguales en la valla.
why-code-post = altura en la pantalla ← 1 / profundidad
why-words-post = Lo que está al doble de profundidad se ve la mitad de alto.
why-code-top = borde recto: 1 / profundidad cambia de manera uniforme
why-words-top = Una recta se ve recta.
why-error-term = Por qué: el e de Bresenham
why-view-columns = Las primeras columnas, ampliadas
why-error-opening = En cada columna la recta se aparta b / a de píxel; el punto medio entre dos píxeles está a 1/2. ¿Qué queda más lejos?
why-error-parts = Mide ambos con una misma regla que tiene 2a partes por píxel.
why-error-one-pixel = La recta empieza y acaba en el mismo píxel: no hay nada que elegir.
why-error-line = Entonces la recta se aparta un número entero de partes en cada columna.
why-error-midpoint = El punto medio también está a un número entero de partes.
why-error-beyond = Columna { $column }: la recta pasa del punto medio, así que se toma el píxel de la fila siguiente, y el punto medio avanza un píxel.
why-error-short = Columna { $column }: la recta no pasa del punto medio, así que se toma el píxel de la misma fila.
why-code-parts = un píxel = 2a partes
why-words-parts = Divide cada píxel tan fino que no queden fracciones.
why-code-both-whole = recta: 2b en cada columna;  punto medio: a
why-words-both-whole = Ambos son entonces números enteros.
why-code-columns = para cada columna:
why-words-columns = Ve de columna en columna.
why-code-error = e ← recta − punto medio
why-words-error = El signo de e dice de qué lado del punto medio está la recta.
why-view-sight = Distancia al plano a lo largo de dos líneas de visión
why-crosses-once = Por qué: el lado lejano no oculta nada
why-bend = tendría que doblarse
why-once = una vez
why-once-opening = ¿Puede algo del lado lejano del plano de un triángulo ocultar algo del lado del ojo?
why-once-no-sides = El ojo está en el plano de { $plane }: ningún lado es el del ojo.
why-once-eye = El ojo está a un lado del plano de { $plane }, a esta distancia.
why-once-own = Q, el centro de { $own }, está del mismo lado.
why-once-least = En el camino a Q la distancia cambia de manera uniforme y nunca es 0: lo que oculte a Q está en el mismo lado de { $plane } que el ojo.
why-once-other = R, el centro de { $other }, está del otro lado.
why-once-crossing = En el camino a R la distancia es 0 una vez: antes de ese lugar, el lado cercano puede ocultar a R; después, el lejano.
why-code-eye = E: d(E) > 0
why-words-eye = El lado del ojo es el positivo.
why-code-own = d(Q) > 0: d > 0 en todo el camino
why-words-own = Entre dos valores positivos no hay ningún 0 en una recta.
why-code-other = d(R) < 0: d = 0 una vez
why-words-other = Una recta encuentra un plano una sola vez.
why-code-order = dibujar: lado lejano, el triángulo, lado del ojo
why-words-order = Lo que queda oculto se dibuja primero.
why-bridge = Por qué: un puente no tiene área
why-edge = arista
why-width = ancho
why-height = alto
why-strip = franja
why-sum = suma
why-bridge-opening = Cada arista del anillo tiene una franja, desde el borde izquierdo hasta la arista: se suma si la arista sube y se resta si baja.
why-bridge-up = { $edge } sube, así que su franja se suma.
why-bridge-down = { $edge } baja, así que su franja se resta.
why-bridge-none = { $edge } no tiene franja: es horizontal o está donde empiezan las franjas.
why-bridge-back = { $edge } vuelve por la misma línea que { $other }: es un puente. Allí la misma franja se suma una vez y se resta una vez.
why-bridge-area = Todas las franjas juntas dejan { $area }: el área del anillo, sin nada para el puente.
why-bridge-elsewhere = Si las franjas empiezan en el borde derecho, cada una es otra, y la suma es la misma.
why-code-edges = para cada arista del anillo:
why-words-edges = Da una vuelta al anillo.
why-code-swept = franja ← ancho medio · alto
why-words-swept = Una arista que baja tiene alto negativo.
why-code-area = área ← suma de las franjas
why-words-area = Lo que se recorre de ida y vuelta se anula.

## Una intersección como media ponderada

why-mean = Por qué: una intersección es una media ponderada
why-triangle = triángulo
why-across = de través
why-along = a lo largo
why-mean-opening = Un segmento cruza la recta de un borde. ¿En qué lugar, a lo largo del borde?
why-mean-nothing = Ningún borde tiene su recta entre P₁ y P₂: no hay ninguna intersección que hallar.
why-mean-first = P₁ está a esta distancia del { $edge }, { $border }.
why-mean-second = P₂ está a esta distancia de él, al otro lado.
why-mean-part = Así que se llega al { $edge } tras esta parte del camino de través.
why-mean-rise = El triángulo hasta el borde tiene los ángulos del triángulo del segmento entero: es el mismo, con t veces su tamaño. Así que también a lo largo del borde se ha hecho la parte t del camino.
why-mean-level = El segmento no se mueve a lo largo del borde: los dos triángulos son planos.
why-mean-mean = En conjunto, la { $along } de cada extremo lleva como peso la distancia del otro extremo.
why-mean-given = La misma media de la otra coordenada, { $across }, da el propio borde. Por eso se copia y no se calcula.
why-code-weights = w₁, w₂ ← distancias de P₁ y P₂ al borde
why-words-weights = Mide a qué distancia de la recta del borde está cada extremo.
why-code-part = t ← w₁ / (w₁ + w₂)
why-words-part = Del camino de través, w₁ queda antes del borde.
why-code-rise = X ← P₁ + t · (P₂ − P₁)
why-words-rise = En las dos direcciones se ha hecho la misma parte del camino.
why-code-mean = X = (w₂ · P₁ + w₁ · P₂) / (w₁ + w₂)
why-words-mean = El extremo más cercano cuenta más.

## El doble de un área

why-double-area = Por qué: a₁·b₂ < b₁·a₂ es «a la izquierda»
why-area = área
why-left = izquierda
why-right = derecha
why-rectangle = rectángulo
why-ends = + dos mitades
why-half = − mitad del total
why-more = más que la mitad
why-area-opening = ¿De qué lado de la recta que va de P₁ a una esquina está P₂? Mide los dos puntos desde esa esquina.
why-area-nothing = Aquí bastan las regiones de P₁ y P₂: no se prueba ninguna esquina.
why-area-first = Las rectas que pasan por { $corner } dividen el rectángulo de P₁ a P₂ en cuatro partes. Una mide |a₁| de ancho y |b₂| de alto.
why-area-second = La parte opuesta mide |a₂| de ancho y |b₁| de alto.
why-area-ends = Ve de P₁ a P₂ pasando por { $corner }: este camino divide por la mitad las otras dos partes.
why-area-half = El camino recto de P₁ a P₂ divide por la mitad el rectángulo entero.
why-area-more = A la izquierda del camino por { $corner } hay más que la mitad: sobra el triángulo que queda entre los dos caminos. A la derecha falta lo mismo.
why-area-less = A la izquierda del camino por { $corner } hay menos que la mitad: falta el triángulo que queda entre los dos caminos. A la derecha sobra lo mismo.
why-area-none = { $corner } está en el camino recto: no hay triángulo, y cada lado es una mitad.
why-area-left = Izquierda menos derecha es el doble del triángulo, con signo positivo: P₂ está a la izquierda de la recta que va de P₁ a { $corner }.
why-area-right = Izquierda menos derecha es el doble del triángulo, con signo negativo: P₂ está a la derecha de la recta que va de P₁ a { $corner }.
why-area-through = Izquierda menos derecha es 0: P₂ está en la recta que va de P₁ a { $corner }.
why-code-rectangles = rectángulos: |a₁·b₂| y |b₁·a₂|
why-words-rectangles = Son las dos partes que no tocan ni P₁ ni P₂.
why-code-over = camino por la esquina: las otras dos, por la mitad
why-words-over = Una diagonal divide un rectángulo por la mitad.
why-code-straight = camino recto: las cuatro, por la mitad
why-words-straight = También el rectángulo entero tiene una diagonal.
why-code-between = triángulo ← izquierda + dos mitades − mitad del total
why-words-between = Lo que queda entre los dos caminos sobra de un lado y falta del otro.
why-code-twice = b₁·a₂ − a₁·b₂ = izquierda − derecha = 2 · triángulo
why-words-twice = El signo dice el lado: positivo es a la izquierda.
