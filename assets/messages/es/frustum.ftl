### What the frustum lab says: planes, spheres, boxes, faces, the funnel, and what goes wrong in it.

## Sides of the view volume beyond those of a window

plane-near = cercano
plane-far = lejano
plane-left = izquierdo
plane-right = derecho
plane-bottom = inferior
plane-top = superior

## Views

view-observer = Observador
view-camera = Cámara
view-observer-frozen = Observador: el descarte está congelado
view-camera-flying = Cámara que vuela
camera-that-culls = congelada: descarta
camera-that-flies = vuela
gauge-outside = fuera
gauge-inside = dentro
gauge-away = de espaldas
gauge-faces-camera = de frente
gauge-drawn = se dibuja
gauge-culled = se descarta
gauges-sphere = Una esfera, { $planes ->
        [one] { $planes } plano
       *[other] { $planes } planos
    }
gauges-sphere-of = Objeto { $object }: una esfera, { $planes ->
        [one] { $planes } plano
       *[other] { $planes } planos
    }
gauges-faces = Caras: { $faces }, según n·e
plane-from-matrix = Sin ángulos: { $sum }. Dividido por la longitud de su normal, { $length }, es el plano { $plane }, hasta { $decimals } decimales.
column-plane = plano
column-outside = fuera
column-vertex = vértice
column-code = código
column-beyond = más allá de
no-side = ningún lado en común
codes-left = Vértices dentro: { $inside } de 3. Triángulos que quedan de él: { $pieces }.
column-least = mínimo
column-most = máximo

## What can be taken hold of

handle-camera = Posición de la cámara
handle-target = Punto al que mira la cámara
handle-near = Plano cercano
handle-far = Plano lejano
handle-top = Apertura de la cámara
handle-point = Punto P
handle-space-end = { $number ->
    [1] Extremo P₁
   *[other] Extremo P₂
  }
handle-space-corner = Vértice dado { $vertex }
handle-object = Objeto { $number }
handle-object-corner = Objeto { $number }, vértice { $corner }

## Methods

alg-point-planes = Punto contra planos
alg-sphere-cull = Esfera envolvente
alg-box-cull = Caja envolvente
alg-back-face = Caras traseras
alg-funnel = Embudo de descarte
alg-faulty-one-angle = Erróneo: un solo ángulo para ambos ejes
alg-faulty-turned-sign = Erróneo: signo invertido
alg-faulty-around-origin = Erróneo: esfera centrada en el origen
alg-faulty-winding = Erróneo: vértices en sentido horario
alg-faulty-constant-view = Erróneo: una sola dirección de visión

## A point

point-opening = ¿Está P por dentro de { $planes ->
        [one] { $planes } plano
       *[other] los { $planes } planos
    }?
point-inside = P está por dentro del plano { $plane }.
point-on = P está en el plano { $plane }, lo que cuenta como dentro.
point-outside = P está por fuera del plano { $plane }.
point-answer-inside = Dentro: ningún plano deja el punto fuera.
point-answer-outside = Fuera: al menos un plano deja el punto fuera.
point-done-inside = P está por dentro de { $planes ->
        [one] { $planes } plano
       *[other] los { $planes } planos
    }: está en el volumen.
point-done-outside = P está por fuera de { $outside } de { $planes ->
        [one] { $planes } plano
       *[other] los { $planes } planos
    }: no está en el volumen.
code-plane-each = para cada plano (n, D):
code-point-distance = d ← n·P + D
code-point-outside = si d < 0: fuera
code-point-inside = dentro si ningún plano lo deja fuera
words-plane-each = Prueba cada plano por turno; su normal apunta hacia dentro.
words-point-distance = El producto escalar de la normal y el punto, más D, es la distancia con signo.
words-point-outside = Si es negativa, está por fuera; si es 0, está en el plano y cuenta como dentro.
words-point-inside = Un punto que ningún plano deja fuera está en el volumen.

## A bounding sphere

sphere-opening = Una esfera alrededor de todos los vértices representa el objeto: { $planes ->
        [one] { $planes } plano
       *[other] { $planes } planos
    }.
sphere-inside = La esfera está por dentro del plano { $plane }.
sphere-straddles = La esfera cruza el plano { $plane }.
sphere-outside = La esfera está por fuera del plano { $plane }: el objeto se descarta entero.
sphere-done-inside = La esfera está por dentro de { $planes ->
        [one] { $planes } plano
       *[other] los { $planes } planos
    }: ningún triángulo necesita prueba.
sphere-done-straddles = La esfera cruza { $cut } de { $planes ->
        [one] { $planes } plano
       *[other] los { $planes } planos
    }: se prueban sus triángulos.
planes-done-outside = El plano { $plane } descarta el objeto tras { $planes ->
        [one] { $planes } prueba
       *[other] { $planes } pruebas
    }: no se dibuja nada de él.
option-beyond = Fuera del plano { $option }
option-within = Dentro de todos los planos
option-across = Fuera de ninguno, pero no dentro de todos los planos
code-sphere-distance = d ← n·c + D
code-sphere-outside = si d < −r: descartar
code-sphere-straddles = si d < r: cruza el plano
code-sphere-done = dentro si no cruza ninguno
words-sphere-distance = Calcula la distancia con signo del centro al plano.
words-sphere-outside = El centro está fuera, a más distancia que el radio: toda la esfera está por fuera.
words-sphere-straddles = El centro está más cerca que el radio: el plano corta la esfera.
words-sphere-done = Si la esfera está por dentro de todos los planos, no hace falta ninguna prueba más.
class-inside = dentro
class-straddles = cruza el plano
class-outside = fuera
watch-class = clase
watch-object = objeto

## A bounding box

box-opening = Una caja alrededor de todos los vértices representa el objeto: { $planes ->
        [one] { $planes } plano, ocho vértices.
       *[other] { $planes } planos, ocho vértices cada uno.
    }
box-inside = Los ocho vértices están por dentro del plano { $plane } ({ $outside } por fuera).
box-straddles = { $outside ->
        [one] { $outside } de 8 vértices está
       *[other] { $outside } de 8 vértices están
    } por fuera del plano { $plane }: la caja lo cruza.
box-outside = Los { $outside } vértices están por fuera del plano { $plane }: el objeto se descarta entero.
box-meets = La caja cruza { $cut ->
        [one] { $cut } plano
       *[other] { $cut } planos
    }, y una parte queda por dentro de todos.
box-in-vain = La caja cruza { $cut ->
        [one] { $cut } plano
       *[other] { $cut } planos
    } y, sin embargo, ningún punto suyo queda por dentro de todos.
box-done-inside = La caja está por dentro de { $planes ->
        [one] { $planes } plano.
       *[other] los { $planes } planos.
    }
box-done-straddles = { $planes ->
        [one] El plano ({ $planes }) no descarta la caja:
       *[other] Ninguno de los { $planes } planos descarta la caja:
    } se prueban sus triángulos.
box-done-in-vain = Los { $planes } planos conservan la caja y se dibujaría en vano: es conservador, no erróneo.
box-note-in-vain = { $triangles ->
        [one] Su { $triangles } triángulo se dibuja de todos modos y cuesta tiempo.
       *[other] Sus { $triangles } triángulos se dibujan de todos modos y cuestan tiempo.
    } No cambia ni un píxel: la imagen es correcta.
option-box-inside = Los ocho vértices están por dentro del plano { $plane }.
option-box-straddles = Solo algunos vértices están por dentro del plano { $plane }: la caja lo cruza.
option-box-outside = Los ocho vértices están por fuera del plano { $plane }: la caja se descarta.
code-box-corners = contar vértices con n·p + D < 0
code-box-outside = si los ocho: descartar
code-box-meets = ¿hay un punto dentro de todos?
code-box-done = conservar, o dibujar en vano
words-box-corners = Solo cuentan los signos de las ocho distancias.
words-box-outside = Si los ocho están por fuera de un mismo plano, no se puede ver nada del objeto.
words-box-meets = Una segunda prueba halla las cajas que cruzan planos y aun así están fuera.
words-box-done = Los planos nunca descartan lo visible; pueden conservar lo que no lo es.

## A face

face-of-object = { $face } del objeto { $object }
face-opening = ¿Está la cara { $face } de frente a la cámara?
face-normal = Vista desde fuera, la cara { $face } se recorre en sentido antihorario: su normal apunta hacia fuera.
face-to-eye = El vector e va de V₀ de la cara { $face } a la cámara: e = ojo − V₀.
face-to-direction = En proyección paralela, para la cara { $face } como para todas, e apunta en sentido contrario a la línea de visión.
face-products = Para la cara { $face }, el producto escalar y el determinante son el mismo número.
face-front = La cara { $face } está de frente a la cámara: se dibuja.
face-back = La cara { $face } está de espaldas a la cámara: se descarta.
face-edge-on = La cara { $face } está de canto: no se ve nada de ella, se descarta.
code-face-normal = n ← (V₁ − V₀) × (V₂ − V₀)
code-face-viewer = e ← ojo − V₀
code-face-product = n·e = |e, V₁ − V₀, V₂ − V₀|
code-face-decide = delantera si n·e > 0; si no, descartar
words-face-normal = El producto vectorial de dos aristas es perpendicular a la cara.
words-face-viewer = En perspectiva la dirección al ojo cambia de cara a cara.
words-face-product = El signo de n·e dice de qué lado de la cara está el ojo.
words-face-decide = Visto desde fuera, un sólido cerrado tapa con sus caras delanteras las traseras.

## The funnel

level-so-far = hasta ahora
level-scene = en la escena
level-spheres = tras las esferas
level-vertices = tras los vértices
level-cuts = tras los cortes
level-facing = de cara a la cámara
level-counts = { $triangles ->
        [one] { $triangles } triángulo
       *[other] { $triangles } triángulos
    } · { $objects ->
        [one] { $objects } objeto
       *[other] { $objects } objetos
    }
funnel-opening = { $objects ->
        [one] { $objects } objeto
       *[other] { $objects } objetos
    } con { $triangles ->
        [one] { $triangles } triángulo
       *[other] { $triangles } triángulos
    }: ¿qué triángulos hay que dibujar?
funnel-object = Objeto { $object }: { $triangles ->
        [one] { $triangles } triángulo
       *[other] { $triangles } triángulos
    } en una esfera.
funnel-sphere-inside = El objeto { $object } está dentro: { $triangles ->
        [one] su { $triangles } triángulo no necesita
       *[other] sus { $triangles } triángulos no necesitan
    } recorte.
funnel-sphere-straddles = El objeto { $object } cruza algún plano: { $triangles ->
        [one] su { $triangles } triángulo se prueba.
       *[other] sus { $triangles } triángulos se prueban uno a uno.
    }
funnel-sphere-outside = El objeto { $object } se descarta entero: { $triangles ->
        [one] se ahorra { $triangles } triángulo.
       *[other] se ahorran { $triangles } triángulos.
    }
funnel-triangle-inside = Triángulo { $triangle }: { $inside } de 3 vértices están dentro; se conserva entero.
funnel-triangle-outside = Triángulo { $triangle }: todos los vértices están más allá de un mismo lado ({ $inside } dentro); se descarta.
funnel-triangle-cut = Triángulo { $triangle }: { $inside } de 3 vértices dentro; el recorte deja { $pieces ->
        [one] { $pieces } triángulo
       *[other] { $pieces } triángulos
    }.
funnel-triangle-across = Triángulo { $triangle }: { $inside ->
        [one] { $inside } vértice
       *[other] { $inside } vértices
    } dentro y, sin embargo, se ve una parte: { $pieces ->
        [one] { $pieces } triángulo
       *[other] { $pieces } triángulos
    }.
funnel-triangle-nothing = Triángulo { $triangle }: { $inside ->
        [one] { $inside } vértice
       *[other] { $inside } vértices
    } dentro, y el recorte deja { $pieces ->
        [one] { $pieces } pieza.
       *[other] { $pieces } piezas.
    }
option-triangle-inside = El triángulo { $triangle } está dentro y se conserva entero.
option-triangle-outside = El triángulo { $triangle } queda más allá de un lado y se descarta.
option-triangle-clipped = El triángulo { $triangle } pasa al recorte.
funnel-face-front = El triángulo { $triangle } del objeto { $object } está de frente a la cámara: se dibuja.
funnel-face-back = El triángulo { $triangle } del objeto { $object } está de espaldas a la cámara: se descarta.
funnel-face-edge-on = El triángulo { $triangle } del objeto { $object } se ve de canto: se descarta.
funnel-done = Quedan por dibujar { $facing } de { $triangles ->
        [one] { $triangles } triángulo
       *[other] { $triangles } triángulos
    } y { $kept } de { $objects ->
        [one] { $objects } objeto
       *[other] { $objects } objetos
    }.
code-funnel-each = para cada objeto:
code-funnel-sphere = c, r ← esfera envolvente
code-funnel-plane = para cada plano: d ← n·c + D
code-funnel-cull = si d < −r: descartar el objeto
code-funnel-straddles = si algún d < r: para cada triángulo:
code-funnel-triangle = códigos: descartar, conservar o recortar
code-funnel-face = descartar triángulos con n·e ≤ 0
code-funnel-draw = dibujar lo que queda
words-funnel-each = Prueba primero objetos enteros: una prueba puede ahorrar todos sus triángulos.
words-funnel-sphere = Su centro es la media de los vértices; llega hasta el más lejano.
words-funnel-plane = Calcula la distancia del centro a los seis planos.
words-funnel-cull = Si el centro está fuera, a más distancia que el radio, deja fuera el objeto.
words-funnel-straddles = Solo lo que cruza algún plano pasa al nivel siguiente.
words-funnel-triangle = Todos los vértices más allá de un mismo lado: descarta; ninguno fuera: conserva; si no, recorta.
words-funnel-face = Los triángulos de espaldas a la cámara quedan tapados por los que están de frente.
words-funnel-draw = Cada nivel ha quitado lo que su prueba podía decidir.

## Mistakes

faulty-one-angle-differs = El paso { $step } es el primero que difiere: el ángulo de abajo arriba se tomó también de izquierda a derecha.
faulty-turned-sign-differs = El paso { $step } es el primero que difiere: el lado interior del plano se tomó por el exterior.
faulty-around-origin-differs = El paso { $step } es el primero que difiere: la esfera tiene el centro en el origen del modelo, no en su centroide.
faulty-winding-differs = El paso { $step } es el primero que difiere: los vértices se tomaron en sentido horario, y así la normal apunta hacia dentro.
faulty-constant-view-differs = El paso { $step } es el primero que difiere: se tomó una sola dirección de visión para todas las caras.
code-faulty-one-angle = planos con un solo ángulo: d ← n·c + D
words-faulty-one-angle = Los planos laterales se abren tanto como los de abajo y arriba.
code-faulty-turned-sign = si d > r: descartar el objeto
words-faulty-turned-sign = Se deja fuera lo que está del lado al que apunta la normal.
code-faulty-around-origin = c, r ← origen, radio respecto al centroide
words-faulty-around-origin = La esfera tiene su centro en el origen del modelo, con el radio medido desde el centroide.
code-faulty-winding = n ← (V₂ − V₀) × (V₁ − V₀)
words-faulty-winding = Calcula la normal como si los vértices fueran en sentido horario.
code-faulty-constant-view = descartar triángulos con n·v ≥ 0, v constante
words-faulty-constant-view = Usa una sola dirección de visión para todas las caras.

## Menu

camera-title = Cámara
camera-position = Posición
camera-target = Mira a
camera-up = Hacia arriba
camera-sight = Proyección
camera-perspective = Perspectiva
camera-parallel = Paralela
camera-fov = Campo de visión
camera-height = Altura
camera-aspect = Relación de aspecto
camera-near = Plano cercano
camera-far = Plano lejano
camera-frozen = Congelar el descarte
objects-not-drawn = Este método no dibuja objetos.
object-add = Añadir un objeto
object-remove = Quitar el objeto enfocado
object-focus = Objeto { $object }
object-face = Cara
object-number = Número
object-place = Lugar
object-turn = Giro
object-size = Tamaño
section-point = Punto
section-segment = Segmento
section-triangle = Triángulo
object-opacity = Opacidad
solid-cube = Cubo
solid-tetrahedron = Tetraedro
solid-octahedron = Octaedro
solid-sphere = Esfera
solid-torus = Toro
solid-angle = Bloque en L
solid-spot = La vaca Spot
street-title = Calle de cajas
street-count = Cajas
street-make = Construir la calle

## El veredicto

verdict-culled = El plano { $plane } descarta el objeto { $object }: d = { $distance } < −r, r = { $radius }. Desplazado { $move } hacia dentro, no lo descartaría ningún plano.
verdict-culled-for-good = El plano { $plane } descarta el objeto { $object }: d = { $distance } < −r, r = { $radius }. Ningún desplazamiento a lo largo de la normal de ese plano lo haría entrar.
verdict-straddles = El objeto { $object } cruza algún plano: el que está más cerca es el plano { $plane }, d = { $distance } < r = { $radius }. Desplazado { $move } hacia fuera, se descartaría.
verdict-inside = El objeto { $object } está dentro: lo que está más cerca es el plano { $plane }, d = { $distance } ≥ r = { $radius }. Desplazado { $move } hacia fuera, se descartaría.
verdict-face-in = Desplazada { $move } a lo largo de la normal del plano { $plane }, la cara ya no tendría todos sus vértices más allá de un mismo plano.
verdict-face-never = Ningún desplazamiento a lo largo de la normal del plano { $plane } lo cambiaría.
verdict-face-cut = Ningún punto de la cara está por dentro de todos los planos a la vez: desplazarla a lo largo de la normal de uno solo no dice nada.
verdict-face-turn-to = Girada { $angle }° en torno a V₀, directamente hacia la cámara, empezaría a mostrar su lado delantero.
verdict-face-turn-away = Girada { $angle }° en torno a V₀, directamente hacia el lado opuesto a la cámara, quedaría de canto y se descartaría.
verdict-face-no-normal = No tiene normal: ningún giro mostraría su lado delantero.
part-segment = el segmento
part-corner = el vértice { $vertex }
part-edge = la arista { $from }{ $to }
verdict-part-kept = Ningún plano quita nada: { $part } se conserva por completo.
verdict-part-cut = El plano { $plane } es el primero que corta { $part }; queda una parte.
verdict-part-lost = Decide el plano { $plane }: no queda nada de { $part }.
verdict-part-in = Con un desplazamiento de { $move } hacia dentro, en perpendicular al plano { $plane }, no se perdería.
verdict-part-back = Con un desplazamiento de { $move } hacia fuera, en perpendicular al plano { $plane }, no se perdería.
verdict-part-never = Ningún desplazamiento en perpendicular al plano { $plane } lo cambiaría.
verdict-part-out = Con un desplazamiento hacia fuera de más de { $move }, en perpendicular al plano { $plane }, no quedaría nada.
verdict-part-touch = Solo toca el plano { $plane }: con el menor desplazamiento hacia fuera no quedaría nada.
verdict-crossing-out = La arista tiene aquí una intersección porque sus extremos están a lados distintos del plano { $plane }: d = { $inner } y d = { $outer }. Con ese plano { $move } más afuera no habría intersección.
verdict-crossing-in = La arista tiene aquí una intersección porque sus extremos están a lados distintos del plano { $plane }: d = { $inner } y d = { $outer }. Con ese plano más de { $move } hacia dentro no habría intersección.

## What culling costs, measured

culling-title = Lo que cuesta el descarte
culling-about = Se prueba cada objeto y luego se dibuja lo que queda: la misma imagen de las tres maneras, medida aquí y ahora.
culling-objects = Objetos
culling-own = Los de esta escena
culling-nothing = Sin descartar nada
culling-rough = Con esferas envolventes
culling-exact = Con todos los triángulos
culling-row = { $way }: descartar { $cull } ms + dibujar { $draw } ms; quedan objetos: { $objects }, triángulos: { $triangles }
culling-inequality = Descarte aproximado frente a exacto: { $rough-cull } { $cull-relation } { $exact-cull } ms. Dibujo de lo que queda: { $rough-draw } { $draw-relation } { $exact-draw } ms.
culling-axis-objects = Objetos (cajas en una calle)
culling-axis-millis = Milisegundos
culling-best-always = Lo más rápido en todas las cantidades medidas: { $way }.
culling-best-changes = Lo más rápido al principio: { $first }. A partir de { $many } objetos: { $last } (con { $few } todavía no).
culling-note = La más rápida de cinco pasadas, a 320 × 200 píxeles; las esferas se prueban muchas a la vez. Los tiempos son de este equipo y de este momento: las figuras exportadas muestran recuentos.

## A pixel of the camera's picture

pixel-seen = El píxel { $at } muestra la cara { $face } del objeto { $object }: { $count ->
    [one] es la única que hay allí, a esta profundidad:
   *[other] es la más cercana de { $count }. Su profundidad y la de la siguiente:
  }
pixel-empty = Ninguna cara cubre el píxel { $at }.
pixel-other = { $count ->
    [one] Un píxel
   *[other] { $count } píxeles
  } { $direction } se ve la cara { $face } del objeto { $object }.
pixel-other-nothing = { $count ->
    [one] Un píxel
   *[other] { $count } píxeles
  } { $direction } no se ve nada.
picture-seen = Aquí se ve la cara { $face } del objeto { $object }: { $count ->
    [one] es la única que hay, a esta profundidad:
   *[other] es la más cercana de { $count }. Su profundidad y la de la siguiente:
  }
picture-empty = Aquí no se ve ninguna cara.
picture-other = A un { $percent } % de la imagen { $direction } se ve la cara { $face } del objeto { $object }.
picture-other-nothing = A un { $percent } % de la imagen { $direction } no se ve nada.
pixel-shows = En este paso el píxel { $at } muestra la cara { $face } del objeto { $object }.
pixel-shows-nothing = En este paso el píxel { $at } no muestra nada.
pixel-truth = La más cercana allí es la cara { $face } del objeto { $object }.
pixel-truth-nothing = Ninguna cara cubre este píxel.
pixel-alone = Solo este píxel
pixel-all = Todos los píxeles
pixel-right = a la derecha
pixel-left = a la izquierda
pixel-down = hacia abajo
pixel-up = hacia arriba
