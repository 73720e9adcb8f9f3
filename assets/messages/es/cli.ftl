### What the command line says to people, on the standard error; its JSON is not translated.

## Results

cli-exported =
    { $count ->
        [one] { $count } figura exportada en { $path }
       *[other] { $count } figuras exportadas en { $path }
    }
cli-handouts =
    { $count ->
        [one] { $count } hoja escrita en { $path }
       *[other] { $count } hojas escritas en { $path }
    }
cli-exported-slides =
    { $count ->
        [one] { $count } página de diapositivas escrita en { $path }
       *[other] { $count } páginas de diapositivas escritas en { $path }
    }
cli-checked =
    { $count ->
        [one] { $count } lección sin errores
       *[other] { $count } lecciones sin errores
    }
cli-checked-scenes =
    { $count ->
        [one] { $count } archivo de escena sin errores
       *[other] { $count } archivos de escena sin errores
    }
cli-refused =
    { $count ->
        [one] Se rechazó { $count } entrada
       *[other] Se rechazaron { $count } entradas
    }
cli-untranslated =
    { $count ->
        [one] nota: { $count } lección muestra el inglés en lugar de { $languages }; estos idiomas son opcionales
       *[other] nota: { $count } lecciones muestran el inglés en lugar de { $languages }; estos idiomas son opcionales
    }
cli-unreadable = No se pudo leer { $path }: { $reason }
export-same-name = { $first } y { $second } serían ambos { $path }: no se ha dibujado nada.
handout-of-scene = { $name } es una escena; las hojas se hacen de lecciones. No se ha dibujado nada.
export-no-moment = En { $path } nunca llega el momento “{ $moment }”. No se ha dibujado nada.
export-no-loop = Un bucle muestra figuras: --format { $format } no va con --window ni con --questions. No se ha dibujado nada.
export-window-is-pixels = Una ventana entera son píxeles: --window solo va con --format png, no con { $format }. No se ha dibujado nada.

## Wrong usage

usage-no-such-command = No existe la orden «{ $name }».
usage-no-such-argument = «{ $name }» no se admite aquí.
usage-value-missing = { $name } necesita un valor.
usage-wrong-value = { $name } no puede ser «{ $value }».
usage-argument-missing = Falta { $name }.
usage-conflict = { $name } no se puede usar con { $other }.
usage-expected = Valores posibles: { $expected }.
usage-expected-size = Se esperaba ANCHOxALTO, de 64x64 a { $most }, como 1920x1080.
usage-expected-steps = Se esperaba figures, all o dos momentos como start..end.
usage-expected-scale = Se esperaba un número de 0.25 a 8.
usage-see-help = --help muestra las órdenes y opciones, con ejemplos.

## What the refusal of a case says; the JSON answer has the English sentence

case-bad-json = No es JSON válido: véase la columna { $column }.
case-not-utf8 = La línea no es UTF-8: véase el byte { $byte }.
case-line-too-long = La línea tiene más de { $max } MiB.
case-bad-id = El id está anidado en exceso o contiene un texto que no es Unicode.
case-repeated-field = El campo «{ $name }» aparece dos veces.
case-unknown-algorithm = No hay ningún algoritmo «{ $name }». Disponibles: { $expected }.
case-meant-algorithm = No existe el algoritmo «{ $name }». ¿Querías decir «{ $meant }»? Disponibles: { $expected }.
case-unknown-field = No hay ningún campo «{ $name }» en { $algorithm }. Admite: { $expected }.
case-missing-field = Falta el campo «{ $name }».
case-missing-choice = Falta uno de estos campos: { $fields }.
case-both = Ya se dio «{ $one }»: indica «{ $one }» o «{ $other }», no ambos.
case-wrong-type = Se esperaba { $expected } y hay { $found }.
case-wrong-word = Se esperaba uno de { $expected } y hay «{ $found }».
case-wrong-length = Se esperaban { $expected } números y hay { $found }.
case-wrong-points = Se esperaban { $expected } puntos y hay { $found }.
case-no-planes = Se esperaba al menos un plano.
case-zero-direction = La dirección de visión no debe ser cero.
case-not-finite = { $number } excede el rango de un número de 64 bits: toda coordenada debe ser finita.
case-beyond-range = Con { $number }, un número de la respuesta excedería el rango de los números de 64 bits.
case-step-beyond-range = Con { $number }, un número de un paso excedería el rango de los números de 64 bits. Con --events false se da solo la respuesta.
case-too-many = La lista tiene { $found } entradas: un informe de todos los pasos admite { $max } como máximo. Con --events false se admite cualquier número y se da solo la respuesta.
case-too-many-pairs = { $found } pares de arista y arista de recorte: un informe de todos los pasos admite { $max } como máximo. Con --events false se admite cualquier cantidad y se da solo la respuesta.
case-uv-length = Se esperaba un [u, v] para cada uno de los { $expected } vértices; hay { $found }.
case-tints-length = Se esperaba un [opacidad, brillo] para cada uno de los { $expected } triángulos; hay { $found }.
object-triangles = triángulos
object-object = objeto
object-tints = Opacidad y brillo
case-too-many-raster-pixels = { $found } píxeles: un informe de cada paso admite como máximo { $max }. Con --events false se admite cualquier número y se da solo la respuesta.
case-too-many-steps = { $found } pasos: un informe admite como máximo { $max }. Con --events false se admite cualquier número y se da solo la respuesta.
case-over-budget = La ejecución tendría más de { $max } pasos, que es el límite de este algoritmo en cualquier equipo.
case-too-many-fragments = Los triángulos cubren { $found } píxeles, contando también los que quedan detrás de otros: se dibujan como máximo { $max }.
json-number = un número
json-numbers = una lista de números
json-points = una lista de puntos
json-text = un texto
json-list = una lista
json-object = un objeto
json-bool = verdadero o falso
json-null = null

## The answer to a case

case-visible = Visible desde { $p1 } hasta { $p2 }.
case-touch = Visible en un solo punto: { $at }.
case-invisible = No hay nada visible.
case-nothing-left = No queda nada.
case-no-area = Lo que queda no tiene área: no hay nada que rellenar.
case-cull-inside = Dentro: ningún plano lo corta.
case-cull-outside = Fuera: el plano { $plane } lo descarta, a una distancia de { $distance }.
case-box-outside = Fuera: los ocho vértices están por fuera de un mismo plano.
case-cull-straddles = Cruza algún plano: al menos uno lo corta y ninguno lo descarta.
case-cull-in-vain = Según las pruebas cruza algún plano y, sin embargo, ningún punto suyo está dentro: se conserva en vano.
case-front = Muestra su lado delantero: n·e = { $dot }.
case-back = No muestra su lado delantero: n·e = { $dot }.
case-polygons =
    { $n ->
        [one] Un polígono: { $rings }
       *[other] { $n } polígonos: { $rings }
    }
case-surfaces-seen = Píxeles que muestran una superficie: { $seen } de { $pixels }.
case-painted = Pintados en este orden: { $ids }.
case-painter-cycle = Ningún orden es correcto: cada uno de { $ids } debe pintarse antes que el siguiente, y el último antes que el primero.
case-bsp-pieces = Piezas del árbol: { $pieces }. Píxeles que muestran una superficie: { $seen } de { $pixels }.
case-occlusion = Píxeles que muestran un objeto: { $seen } de { $pixels }. Objetos omitidos: { $skipped } de { $objects }.
case-bsp-too-large = Los planos cortarían estos triángulos en más de { $pieces } piezas, o clasificarían piezas más de { $questions } veces: de tantas no se construye un árbol.
case-triangles =
    { $n ->
        [one] Un triángulo: { $triangles }
       *[other] { $n } triángulos: { $triangles }
    }

## Reports: the step table of a case

report-title = Solucionario
worksheet-title = Hoja de ejercicios
worksheet-how = Completa lo que halla cada paso. Donde haya casillas, marca la que sea cierta.
report-case = Caso { $number }
report-case-id = Caso { $number } ({ $id })
report-source = fuente
report-symbols = símbolos
case-symbols-weiler-atherton = a₁, a₂: distancias de los extremos de la arista que se recorta a la recta de la arista de recorte, multiplicadas por la longitud de esta; > 0 a su izquierda, es decir, dentro. t, u: dónde se encuentran las dos aristas, en la que se recorta y en la de recorte, de 0 en su inicio a 1 en su final.
report-step = paso
report-what = qué ocurre
report-formula = fórmula
report-changed = valores nuevos
report-answer = Respuesta:
report-row = { $name }: { $values }
report-noted = { $value } ({ $note })

## The trace, check and list commands

trace-refused-at = línea { $line } ({ $case }): { $problem }
trace-more-refused = y { $count } más
trace-from-terminal = Se leen casos del teclado, uno por línea; Ctrl+D termina.
trace-not-written = No se pudieron escribir las respuestas: { $reason }
list-algorithms = Algoritmos que admiten los casos
list-lessons = Lecciones
list-figure = figura { $name }
cli-no-lesson = No hay ninguna lección «{ $name }»: no es una ruta ni una lección del curso. Véase clipscope list.
grade-score = { $right } de { $cases } { $cases ->
        [one] caso está respondido
       *[other] casos están respondidos
    } correctamente.
grade-case = caso { $number }
grade-case-named = caso { $number } ({ $name })
grade-no-case = ningún caso
grade-unlisted = { $count ->
        [one] Se cuenta una diferencia más, que no está en la lista.
       *[other] Se cuentan { $count } diferencias más, que no están en la lista.
    }
grade-output = { $place } es { $truth }; el programa dice { $said }.
grade-output-missing = A la respuesta le falta { $place }, que es { $truth }.
grade-output-spare = La respuesta tiene { $place } = { $said }, y la verdadera no.
grade-field = { $place } es { $said }, y lo verdadero es { $truth }.
grade-field-missing = Falta { $place }, y lo verdadero es { $truth }.
grade-field-spare = { $place } es { $said }, y un evento así no tiene { $place }.
grade-step-differs = El paso { $step }, «{ $said }», es el primero que difiere: { $what }
grade-step-other = El paso { $step } es el primero que difiere: el programa hace «{ $said }», y lo verdadero es «{ $truth }».
grade-step-missing = El programa se detiene tras el paso { $step }: después viene «{ $truth }».
grade-step-extra = El paso { $step }, «{ $said }», sobra: no queda nada por hacer.
grade-steps-swapped = Los pasos { $step } y { $next } están intercambiados: «{ $truth }» va antes de «{ $said }».
grade-step-unreadable = El paso { $step } no es un evento: se espera un objeto con el texto “event”.
grade-missing = El programa no da respuesta a este caso.
grade-extra = La línea { $line } de las respuestas no es de ningún caso: su id es desconocido, o el caso ya tiene una respuesta.
grade-bad-json = No se puede leer la línea { $line } de las respuestas. { $problem }
grade-no-object = Es JSON válido, pero no un objeto.
grade-refuses = El programa rechaza este caso, que tiene una respuesta.
grade-refusable = El programa responde a este caso, que se rechaza ({ $code }).
grade-mistake = Exactamente esto sale con un error conocido: «{ $mistake }».
mistake-slope-turned-over = la pendiente está al revés, Δx/Δy en lugar de Δy/Δx
grade-both-stdin = Los casos y las respuestas no pueden venir ambos de la entrada estándar.
grade-one-at-a-time = Este informe trata de una sola entrega, y las respuestas son de varias: --report json o text tiene un informe para cada una.
grade-not-written = No se pudo escribir { $path }: { $reason }
grade-no-report = { $path }, línea { $line }: esto no es un informe de «clipscope grade --report json».
usage-expected-tolerance = Se espera un número que no sea negativo, como 1e-9.
grade-mark-true = verdadero: { $at }
grade-mark-said = el del programa: { $at }
grade-raster-true = los píxeles correctos
grade-raster-said = los del programa (distintos: { $count }, el primero { $at })
grade-title-event = El primer paso erróneo: { $event }
grade-title-output = La primera respuesta que difiere
grade-title-none = El primer caso sin una respuesta correcta
grade-title-extra = Una respuesta a ningún caso
grade-figure-said = El programa dijo
grade-figure-true = Lo verdadero es
grade-figure-nothing = nada
grade-figure-cases = todos los casos en su orden
grade-figure-plain = Este caso se muestra solo en números.

table-file = archivo
table-score = puntuación

pack-one-folder = Una página admite un solo curso: indica una sola carpeta.
pack-too-many =
    Las marcas de estas lecciones ocupan { $count } caracteres, y SCORM 1.2 guarda { $most } de cada estudiante: haz paquetes con menos lecciones.
