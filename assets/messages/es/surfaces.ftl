### Lo que dice el laboratorio de superficies: qué superficie está delante, píxel a píxel.

alg-depth-buffer = Búfer de profundidad
alg-faulty-depth-clear = Búfer de profundidad, inicializado a 0
alg-faulty-depth-compare = Búfer de profundidad, comparación al revés
alg-faulty-depth-always = Búfer de profundidad, sin comparar
alg-faulty-depth-straight = Búfer de profundidad, distancia lineal en pantalla

## Pseudocode

code-depth-clear = imagen ← fondo, z ← ∞
words-depth-clear = Llena la imagen con el color de fondo y pon cada profundidad a infinito.
code-depth-clear-reversed = imagen ← fondo, z ← −∞
words-depth-clear-reversed = Llena la imagen con el color de fondo y pon cada profundidad a menos infinito: nada está más lejos.
code-depth-triangle = para cada triángulo T
words-depth-triangle = Toma los triángulos, en cualquier orden.
code-depth-fragment = para cada píxel de T: z_T ← profundidad de T ahí
words-depth-fragment = Para cada píxel cuyo centro cubre el triángulo, halla allí su profundidad.
code-depth-compare = si z_T < z[píxel]
words-depth-compare = Compara esta profundidad con la guardada.
code-depth-compare-reversed = si z_T > z[píxel]
code-depth-write = imagen[píxel] ← T, z[píxel] ← z_T
words-depth-write = Si es menor, escribe el triángulo y su profundidad.
words-depth-write-reversed = Si es mayor, escribe el triángulo y su profundidad: 1 significa cerca.
code-faulty-depth-clear = imagen ← fondo, z ← 0
words-faulty-depth-clear = Pon cada profundidad a 0, la del plano cercano.
code-faulty-depth-clear-reversed = imagen ← fondo, z ← 1
words-faulty-depth-clear-reversed = Pon cada profundidad a 1, la del plano cercano.
code-faulty-depth-compare = si z_T > z[píxel]
words-faulty-depth-compare = Escribe el triángulo donde la nueva profundidad es mayor.
words-faulty-depth-compare-reversed = Escribe el triángulo donde la nueva profundidad es menor, aunque 1 significa cerca.
code-faulty-depth-always = siempre
words-faulty-depth-always = Escribe siempre, sin comparar profundidades.
code-faulty-depth-straight = para cada píxel de T: z_T ← distancia, interpolada en la pantalla
words-faulty-depth-straight = Interpola la distancia en el espacio de vista linealmente en la pantalla, sin la división.
faulty-depth-clear-differs = El paso { $step } es el primero que difiere: nada está más cerca que el plano cercano, así que no se escribirá nada.
faulty-depth-compare-differs = El paso { $step } es el primero que difiere: el triángulo está más cerca que lo guardado y no se escribe.
faulty-depth-always-differs = El paso { $step } es el primero que difiere: el triángulo se escribe aunque no está más cerca que lo guardado.
faulty-depth-straight-differs = El paso { $step } es el primero que difiere: esta no es la profundidad de la superficie, pues la distancia no es lineal en la pantalla.

## The depth buffer

depth-opening = { $triangles ->
    [one] Un triángulo
   *[other] { $triangles } triángulos
  } en { $columns } × { $rows } píxeles. Profundidades guardadas, una por píxel: { $pixels }, de { $bits } bits cada una, { $bytes } bytes en total.
depth-clear = La imagen está vacía: { $pixels ->
    [one] el píxel no muestra
   *[other] ninguno de los { $pixels } píxeles muestra
  } aún un triángulo.
depth-triangle = Llega { $triangle } ({ $place } de { $triangles }).
depth-triangle-unseen = De { $triangle } no se dibuja nada: está fuera del volumen, de canto o de espaldas.
depth-answer-drawn = { $triangle } se dibuja.
depth-triangle-whole = { $triangle } está dibujado. Sus fragmentos: { $fragments }; escritos: { $writes }.
depth-span = Fila { $row } de { $triangle }, columnas { $first } a { $last }: { $fragments ->
    [one] de { $fragments } fragmento
   *[other] de { $fragments } fragmentos
  } se escriben { $writes }.
depth-fragment-first = El píxel { $at } aún está vacío: se escribe { $triangle }.
depth-fragment-kept = { $triangle } está más cerca que { $other } en el píxel { $at }: se escribe.
depth-fragment-lost = { $triangle } no está más cerca que { $other } en el píxel { $at }: { $other } no cambia.
depth-fragment-kept-behind = En el píxel { $at } { $triangle } no está más cerca que { $other } y, aun así, se escribe.
depth-fragment-tie = { $triangle } está tan cerca como { $other } en el píxel { $at }: { $other } llegó antes y se conserva.
depth-fragment-lost-to-nothing = En el píxel { $at } no se escribe { $triangle }, aunque allí no había nada.
depth-nothing = nada
depth-done = Terminado: { $fragments ->
    [one] un fragmento
   *[other] { $fragments } fragmentos
  }, { $writes ->
    [one] uno escrito
   *[other] { $writes } escritos
  }, para { $pixels ->
    [one] un píxel
   *[other] { $pixels } píxeles
  }. Veces que se calculó cada píxel, en promedio:
raster-brightness = Brillo en milésimas
raster-brightness-bare = Brillo

## Views

practice-then = lo que quedaría ahí
raster-depth = Profundidad en milésimas
raster-depth-bare = Profundidad
raster-depth-unit = Profundidad en unidades de { $unit }
raster-straight = Distancia del plano cercano al lejano, en milésimas
raster-straight-bare = Distancia del plano cercano al lejano
raster-depth-steps = Profundidad en { $bits } bits: 0 a { $last }
raster-distance = Distancia a la cámara
raster-counts-none = Veces que se calcula cada píxel
raster-counts = Veces calculado: { $seen } a la vista, { $vain } en vano
raster-counts-before = Todas las caras: { $seen } a la vista, { $vain } en vano
raster-counts-after = Sin caras traseras: { $seen } a la vista, { $vain } en vano
painter-depths = Distancia de cada triángulo, del vértice más cercano al más lejano
asks-what = pruebas
asks-now = ahora
asks-so-far = hasta ahora
asks-done = terminado
asks-of = { $count } de { $all }
asks-ray-casting = cada píxel: ¿qué triángulo?
asks-depth-buffer = cada triángulo: ¿qué píxeles?
asks-painter = cada par: ¿cuál va antes?
raster-pairs = { $pairs ->
    [one] { $pairs } prueba de un par
   *[other] { $pairs } pruebas de pares
  } de { $triangles ->
    [one] { $triangles } triángulo
   *[other] { $triangles } triángulos
  }
raster-questions = { $questions ->
    [one] { $questions } prueba
   *[other] { $questions } pruebas
  } de { $pixels ->
    [one] { $pixels } rayo
   *[other] { $pixels } rayos
  }
occlusion-triangles = Triángulos de cada objeto
scale-near = cerca { $value }
scale-far = { $value } lejos
raster-wrong = { $count ->
    [one] Un píxel equivocado
   *[other] { $count } píxeles equivocados
  }
depth-glass-behind = En el píxel { $at }, { $triangle } está detrás de { $other } y se pierde, aunque { $other } deja pasar { $through } de la luz.
depth-glass-done = Terminado: { $unsorted ->
    [0] en cada píxel, cada superficie llegó después de lo que tiene detrás
    [one] en un píxel, un cristal llegó antes que lo que tiene detrás, y eso se perdió: una profundidad por píxel no guarda ningún orden
   *[other] en { $unsorted } píxeles, un cristal llegó antes que lo que tiene detrás, y eso se perdió: una profundidad por píxel no guarda ningún orden
  }. Veces que se calculó cada uno, en promedio:
depth-done-stored = Terminado: las profundidades de { $pixels ->
    [one] un píxel
   *[other] { $pixels } píxeles
  } van de { $least } a { $most }.
depth-done-distance = Terminado: las distancias de { $pixels ->
    [one] un píxel
   *[other] { $pixels } píxeles
  } van de { $least } a { $most }.
depth-done-nothing = Terminado: { $fragments ->
    [one] { $fragments } fragmento,
   *[other] { $fragments } fragmentos,
  } ninguno escrito.
curve-whole = Profundidad según la distancia
curve-enlarged = Ampliado
curve-forward = Sin invertir
curve-reversed = Invertida
curve-near = Plano cercano en { $near }
curve-step = paso de la profundidad: { $step }
curve-distance = distancia
curve-depth = profundidad
story-title = Píxel { $at }, por orden de llegada
story-held = Profundidad guardada
story-nearer = más cerca
story-stored = guardada
story-fate = resultado
story-kept = escrito
story-lost = se pierde
story-stays = escrito, queda
story-tie = empate: se pierde
watch-triangle = triángulo
watch-pixel = píxel
watch-fragments = fragmentos
watch-writes = escritos
watch-pixels = píxeles

## Ray casting

alg-ray-casting = Lanzamiento de rayos
code-ray-pixel = para cada píxel: rayo o + t · r por su centro
words-ray-pixel = Para cada píxel, toma el rayo que va del ojo a través de su centro.
code-ray-triangle = para cada triángulo T, plano n·p + d = 0
words-ray-triangle = Prueba todos los triángulos.
code-ray-parallel = si n·r = 0: sin impacto
words-ray-parallel = Un rayo paralelo al plano no lo corta.
code-ray-plane = t ← −(n·o + d) / (n·r)
words-ray-plane = Halla dónde corta el rayo el plano.
code-ray-range = si t < 1 o tras el plano lejano: sin impacto
words-ray-range = Detrás del ojo, antes del plano cercano y más allá del lejano no se ve nada.
code-ray-inside = si o + t · r está en T: impacto
words-ray-inside = Si ese punto está en el triángulo, hay impacto.
code-ray-nearest = imagen[píxel] ← T del menor t
words-ray-nearest = Se ve el impacto con el menor t.
ray-opening = { $rays ->
    [one] Un rayo
   *[other] { $rays } rayos
  } para { $columns } × { $rows } píxeles; cada uno se prueba con { $triangles ->
    [one] un triángulo.
   *[other] { $triangles } triángulos.
  }
ray-pixel = El rayo que pasa por el centro del píxel { $at }: en t = 0 está en el ojo; en t = 1, en el plano cercano.
ray-hit-first = El rayo da en { $triangle }: es el impacto más cercano hasta ahora.
ray-hit-nearer = El rayo da en { $triangle }, delante de { $other }, que está en t = { $t }: ahora { $triangle } es el más cercano.
ray-hit-farther = El rayo da también en { $triangle }, detrás de { $other }, que está en t = { $t }.
ray-answer-farther = El rayo da en { $triangle }, detrás del impacto más cercano.
ray-says-culled = { $triangle } no se prueba: está de canto o de espaldas.
ray-says-parallel = El rayo es paralelo al plano de { $triangle }: n·r = 0, nunca se cortan.
ray-says-behind = La recta del rayo corta el plano de { $triangle } detrás del ojo: t < 0.
ray-says-before-near = El rayo corta { $triangle } antes del plano cercano: t < 1.
ray-says-beyond-far = El rayo corta { $triangle } más allá del plano lejano.
ray-says-beside = El rayo corta el plano de { $triangle } fuera del triángulo: no hay impacto.
ray-seen = El píxel { $at } muestra { $triangle }: tiene el menor t de { $hits ->
    [one] un impacto.
   *[other] { $hits } impactos.
  }
ray-seen-before-others = El píxel { $at } toma { $triangle }: el rayo acaba en t = { $t }, y { $hidden } { $hits ->
    [2] queda
   *[other] quedan
  } en la sombra de { $triangle }.
ray-seen-nothing = El píxel { $at } conserva el fondo: su rayo no da en ningún triángulo.
ray-done = Terminado: { $rays ->
    [one] un rayo, probado con
   *[other] { $rays } rayos, cada uno probado con
  } { $triangles ->
    [one] un triángulo.
   *[other] { $triangles } triángulos.
  }
ray-culled = no se prueba
ray-parallel = paralelo
ray-behind = tras el ojo
ray-before-near = antes del plano cercano
ray-beyond-far = más allá del plano lejano
ray-beside = fuera
ray-hit = detrás
ray-nearest = el más cercano
ray-eye = ojo
ray-raster = ráster
raster-so-far = Imagen hasta ahora
watch-hits = impactos
watch-nearest = más cercano
watch-asked = pruebas

## Painter's algorithm

alg-painter = Algoritmo del pintor
alg-faulty-painter-nearest = Pintor, ordenado por el vértice más cercano
alg-faulty-painter-keys = Pintor, ordenado sin más pruebas
code-paint-key = para cada triángulo T: clave ← distancia de su vértice más lejano
words-paint-key = La clave de un triángulo es la distancia de su vértice más lejano.
code-paint-sort = ordenar por clave, el más lejano primero
words-paint-sort = Ordena los triángulos por su clave, primero el más lejano.
code-paint-ask = para cada P de la lista: ¿puede ir P antes que todo Q que queda?
words-paint-ask = Toma el primer triángulo que queda y comprueba si puede ir antes que todos los demás.
code-paint-object = si P tapa parte de Q: Q va antes que P
words-paint-object = Si tapa una parte de otro, ese debe ir antes y se comprueba a continuación.
code-paint-cycle = si Q espera a P: ciclo
words-paint-cycle = Si ese ya está esperando, no hay ningún orden correcto.
code-paint-place = si no, P es el siguiente
words-paint-place = Si no tapa parte de ningún otro, es el siguiente.
code-paint-paint = pintar todos, en ese orden
words-paint-paint = Píntalos en ese orden, cada uno sobre lo que hay.
code-faulty-painter-nearest = para cada triángulo T: clave ← distancia de su vértice más cercano
words-faulty-painter-nearest = La clave de un triángulo es la distancia de su vértice más cercano.
code-faulty-painter-keys = para cada P de la lista: P es el siguiente
words-faulty-painter-keys = Toma los triángulos tal como están ordenados, sin comprobar nada.
faulty-painter-nearest-differs = El paso { $step } es el primero que difiere: la clave es la distancia del vértice más cercano, no la del más lejano.
faulty-painter-keys-differs = El paso { $step } es el primero que difiere: no se comprueba si este triángulo puede ser el siguiente.
surfaces-first = Solo los primeros { $triangles } de { $all } triángulos: los pasos de todos serían demasiados para seguirlos.
refused-too-many-faces = Rechazado: la escena tiene { $triangles } triángulos y este método admite { $most } como máximo. Quita objetos o elige otro método.
painter-opening = { $triangles ->
    [one] Hay un triángulo
   *[other] Hay { $triangles } triángulos
  } por pintar, primero el más lejano: lo que se pinta después tapa lo anterior.
painter-key = { $triangle } tiene la clave { $key }. Sus vértices están entre estas distancias:
painter-sort = { $triangle } es el número { $place } de la lista, primero el más lejano.
painter-pair-depths = { $triangle } está más lejos que todo { $other }: puede ir antes.
painter-pair-screen = { $triangle } y { $other } están separados en la pantalla: cualquiera puede ir antes.
painter-pair-behind = { $triangle } está detrás del plano de { $other }: puede ir antes.
painter-pair-before = { $other } está delante del plano de { $triangle }: { $triangle } puede ir antes.
painter-pair-overlap = { $triangle } no está en ningún punto de la pantalla más cerca que { $other }: puede ir antes.
painter-pair-hides = { $triangle } tapa una parte de { $other }: no puede ir antes.
painter-ask-depths = 1  ¿Está { $triangle } más lejos que todo { $other }?
painter-ask-screen = 2  ¿Están separados en la pantalla?
painter-ask-behind = 3  ¿Está { $triangle } detrás del plano de { $other }?
painter-ask-before = 4  ¿Está { $other } delante del plano de { $triangle }?
painter-ask-overlap = 5  ¿Está { $triangle } igual de lejos o más en todas partes?
painter-yes = sí
painter-no = no
painter-not-asked = sin comprobar
painter-constraint = { $before } debe pintarse antes que { $after }.
painter-place = { $triangle } no tapa parte de ninguno de los que quedan: es el número { $place } de { $triangles }.
painter-cycle-first = Hay un ciclo: { $triangle } se espera a sí mismo.
painter-cycle-next = { $before } debe pintarse antes que { $triangle }.
painter-cycle-closes = { $before } debe pintarse antes que { $triangle }, y { $triangle } antes que { $first }: el ciclo se cierra.
painter-paint = { $triangle } se pinta encima de todo: { $place } de { $triangles }.
painter-done = Terminado: { $pairs ->
    [one] se comprobó un par
   *[other] se comprobaron { $pairs } pares
  } de { $triangles ->
    [one] un triángulo.
   *[other] { $triangles } triángulos.
  }
painter-done-cycle = Ningún orden es correcto: cada uno de { $cycle } triángulos debe ir antes que el siguiente, y el último antes que el primero.
painter-must = Debe ir antes
painter-cycle = ciclo
watch-pairs = pares comprobados
watch-depth-extents = por profundidad
watch-screen-extents = por lugar en pantalla
watch-behind-plane = por el plano del otro
watch-before-plane = por su propio plano
watch-overlap = por solapamiento

## BSP trees

alg-bsp = Árbol BSP
code-bsp-node = construir(lista): nodo ← plano del primer triángulo
words-bsp-node = El plano del primer triángulo pasa a ser un nodo.
code-bsp-ask = para cada otro T: delante, detrás o en el plano
words-bsp-ask = Cada uno de los demás está delante del plano, detrás o en él.
code-bsp-cut = T a ambos lados: cortar en dos; construir(delante), construir(detrás)
words-bsp-cut = El triángulo que está a ambos lados se corta en dos. Después construye el árbol de delante y el de detrás.
code-bsp-visit = recorrer(nodo): ¿de qué lado está el ojo?
words-bsp-visit = Al recorrer el árbol, averigua en cada nodo de qué lado está el ojo.
code-bsp-paint = recorrer(otro lado); pintar nodo; recorrer(lado del ojo)
words-bsp-paint = Primero el otro lado, después el nodo y al final el lado del ojo.
bsp-opening = { $triangles ->
    [one] Un triángulo se convierte
   *[other] { $triangles } triángulos se convierten
  } en un árbol de planos, que se construye una vez y se recorre para cada punto de vista.
bsp-plane = plano de { $triangle }
bsp-eye = ojo
bsp-node-root = El plano de { $triangle } es el primer nodo.
bsp-node-front = De lo que está delante de { $parent }, el primero es { $triangle }: su plano es el siguiente nodo.
bsp-node-back = De lo que está detrás de { $parent }, el primero es { $triangle }: su plano es el siguiente nodo.
bsp-ask-front = { $piece } está delante del plano de { $triangle }. Distancias de sus vértices:
bsp-ask-back = { $piece } está detrás del plano de { $triangle }. Distancias de sus vértices:
bsp-ask-on = { $piece } está en el plano de { $triangle }. Distancias de sus vértices:
bsp-ask-cut = { $piece } está a ambos lados del plano de { $triangle }: se corta en { $first } y { $second }. Distancias de sus vértices:
option-side-front = { $piece } está delante del plano de { $triangle }.
option-side-back = { $piece } está detrás del plano de { $triangle }.
option-side-on = { $piece } está en el plano de { $triangle }.
option-side-cut = { $piece } está a ambos lados del plano de { $triangle }: se corta en { $first } y { $second }.
bsp-built = El árbol está construido: { $triangles ->
    [one] un triángulo queda
   *[other] { $triangles } triángulos quedan
  } en { $pieces ->
    [one] una pieza,
   *[other] { $pieces } piezas,
  } en { $nodes ->
    [one] un nodo.
   *[other] { $nodes } nodos.
  }
bsp-visit-front = El ojo está delante del plano de { $triangle }: primero lo de detrás, después { $triangle } y al final lo de delante.
bsp-visit-back = El ojo está detrás del plano de { $triangle }: primero lo de delante, después { $triangle } y al final lo de detrás.
bsp-visit-on = El ojo está en el plano de { $triangle } o mira a lo largo de él: cualquier lado puede ir antes.
bsp-paint = { $piece } se pinta encima de todo: { $place } de { $pieces }.
bsp-done = Terminado: { $pieces ->
    [one] una pieza pintada
   *[other] { $pieces } piezas pintadas
  } de atrás hacia delante, con { $nodes ->
    [one] una prueba.
   *[other] { $nodes } pruebas.
  }
bsp-tree = Árbol: ← delante, detrás →
bsp-before = delante
bsp-behind = detrás
bsp-eye-before = ojo delante
bsp-eye-behind = ojo detrás
bsp-eye-on = ojo en él
watch-nodes = nodos
watch-pieces = piezas
watch-visited = visitados
watch-painted = pintadas

## Occlusion queries

alg-occlusion = Consulta de oclusión
code-occlusion-occluders = para cada oclusor: dibujarlo
words-occlusion-occluders = Dibuja los objetos que tapan mucho de la imagen.
code-occlusion-others = para cada otro objeto P, si caja(P) llega al plano cercano: dibujar P
words-occlusion-others = Toma los demás objetos uno a uno. Si su caja llega al plano cercano, dibuja el objeto sin consultar.
code-occlusion-ask = n ← píxeles de caja(P) con z_caja ≤ z[píxel]
words-occlusion-ask = Cuenta los píxeles en los que se vería su caja. No escribas nada.
code-occlusion-skip = si n = 0: omitir P
words-occlusion-skip = Si no hay ninguno, omite el objeto.
code-occlusion-draw = si no, dibujar P
words-occlusion-draw = Si no, dibuja el objeto.
occlusion-opening = { $objects ->
    [one] Un objeto
   *[other] { $objects } objetos
  } en { $columns } × { $rows } píxeles. De los que están en la imagen, primero se dibuja un tercio (redondeado hacia arriba), los que cubren más píxeles, pues pueden tapar a los demás: { $occluders }.
occlusion-none = ninguno
occlusion-occluder = { $object } es un oclusor y se dibuja sin consultar: { $triangles ->
    [one] un triángulo,
   *[other] { $triangles } triángulos,
  } { $writes ->
    [one] un fragmento escrito.
   *[other] { $writes } fragmentos escritos.
  }
occlusion-seen = La caja de { $object } cubre { $asked ->
    [one] un píxel
   *[other] { $asked } píxeles
  } y se vería en { $passed }. No se escribe nada.
occlusion-hidden = La caja de { $object } cubre { $asked ->
    [one] un píxel
   *[other] { $asked } píxeles
  } y no se vería en ninguno: en todas partes hay algo más cercano.
occlusion-beside = La caja de { $object } no cubre ningún píxel.
occlusion-unasked = La caja de { $object } llega al plano cercano, que puede cortar su parte delantera: no se compara nada.
occlusion-answer-seen = La caja de { $object } se vería.
occlusion-answer-hidden = La caja de { $object } queda oculta: en todas partes hay algo más cercano.
occlusion-skip = { $object } se omite: { $triangles ->
    [one] su triángulo no se dibuja.
   *[other] sus { $triangles } triángulos no se dibujan.
  }
occlusion-draw = { $object } se dibuja: { $triangles ->
    [one] un triángulo,
   *[other] { $triangles } triángulos,
  } { $writes ->
    [one] un fragmento escrito.
   *[other] { $writes } fragmentos escritos.
  }
occlusion-in-vain = { $object } se dibuja en vano, { $triangles ->
    [one] un triángulo:
   *[other] { $triangles } triángulos:
  } su caja se vería en { $passed ->
    [one] un píxel,
   *[other] { $passed } píxeles,
  } { $object } mismo en ninguno. La consulta puede conservar lo oculto, pero nunca descarta lo visible.
occlusion-done = Terminado: { $drawn ->
    [one] uno dibujado
   *[other] { $drawn } dibujados
  }, { $skipped ->
    [one] uno omitido
   *[other] { $skipped } omitidos
  }. Triángulos ahorrados: { $spared } de { $triangles }. La imagen es la misma que si se hubiera dibujado todo.
occlusion-objects = objetos
occlusion-asked = píxeles de la caja
occlusion-passed = visibles
occlusion-drawn = dibujado
occlusion-skipped = omitido
occlusion-is-occluder = oclusor
watch-objects-drawn = objetos dibujados
watch-objects-skipped = objetos omitidos
watch-pixels-asked = píxeles consultados
watch-triangles-spared = triángulos ahorrados

## Whose a pixel is

owns-nothing = { $surface } no cubre ningún píxel del ráster.
owns-none = { $surface } cubre { $covered ->
    [one] un píxel
   *[other] { $covered } píxeles
  } y no se ve en ninguno: en todas partes hay otra cosa delante.
owns-all = { $surface } cubre { $covered ->
    [one] un píxel y se ve en él.
   *[other] { $covered } píxeles y se ve en todos.
  }
owns-some = { $surface } cubre { $covered ->
    [one] un píxel
   *[other] { $covered } píxeles
  } y se ve en { $seen }; en { $hidden ->
    [one] uno
   *[other] { $hidden }
  } hay otra cosa delante.

## What it costs

surface-costs-title = Lo que cuesta saber qué está delante
surface-costs-about = Contado, no cronometrado, en { $columns } × { $rows } píxeles: calles de cajas, de doce triángulos cada una.
surface-costs-triangles = Triángulos
surface-costs-counts = Pares, pruebas, fragmentos
surface-costs-pairs = Pintor: { $count } pares comprobados con { $triangles } triángulos; crecen como n elevado a { $exponent }.
surface-costs-questions = Lanzamiento de rayos: { $count } pruebas de un rayo con uno de { $triangles } triángulos; crecen como n elevado a { $exponent }.
surface-costs-fragments = Búfer de profundidad: { $count } fragmentos de { $triangles } triángulos; crecen como n elevado a { $exponent }.
surface-costs-overdraw = Sobredibujado: { $fragments } fragmentos para { $pixels } píxeles; cada píxel se calcula { $overdraw } veces de media.
surface-costs-note = Los exponentes son las pendientes de rectas ajustadas a los logaritmos. Los pares se cuentan solo donde hay un orden; donde no lo hay, a la línea le falta un punto.

## The raster's form

raster-title = Ráster
raster-rows = Filas
raster-shuffle = Barajar (0: no)
raster-pixel = Píxel (−1: todos)
raster-steps = Un paso es
raster-steps-fragments = un fragmento
raster-steps-spans = una fila de un triángulo
raster-steps-triangles = un triángulo
raster-tones = Los tonos muestran
raster-tones-triangles = qué triángulo
raster-tones-counts = cuántas veces se calcula el píxel
raster-tones-brightness = el brillo
raster-tones-stored = la profundidad guardada
raster-tones-distance = la distancia
raster-number = Profundidad
raster-reversed = Invertida: 1 significa cerca
raster-cull = Descartar caras traseras
