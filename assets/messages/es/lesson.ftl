### The course panel and what it says about lesson files.

## Walking through the course

lesson-question = La pregunta
card-rule = Regla
card-formula = Fórmula
card-cost = Coste
card-pitfall = Cuidado
card-can = Ahora sabes
lesson-answer-show = Mostrar la respuesta
lesson-answer-hide = Ocultar la respuesta
lesson-changed = Esta es tu escena. El texto habla de la escena de la lección.
lesson-has-changes = contiene cambios tuyos
lesson-contents = Todas las lecciones y la escena libre
lesson-to-control = Pulsa para ver dónde se ajusta.
lesson-restore = Restaurar la de la lección
lesson-not-translated = Este texto aún no está traducido.

## Lesson files

lesson-empty = El curso no tiene lecciones.
lesson-error = error
lesson-warning = aviso

## What is wrong with a lesson file; the last part of the key is the problem’s code

problem-toml = Esto no es TOML válido.
problem-toml-deep = Los valores están anidados a demasiada profundidad.
problem-toml-comma = Falta una coma entre dos valores.
problem-toml-extra = Sobra una «,» o un «=».
problem-toml-number = Un número no se puede escribir así.
problem-toml-escape = En un texto, este carácter no puede seguir a «\».
problem-toml-duplicate = Este nombre aparece dos veces.
problem-toml-value = Esto no es un valor.
problem-toml-no-value = Faltan «=» y un valor después del nombre.
problem-toml-name = Un nombre no puede tener este carácter.
problem-toml-unclosed = Falta { $closer } para cerrar.
problem-not-utf8 = El archivo no es texto UTF-8: el byte { $byte } no puede estar aquí.
problem-course-file = Esto no es un curso empaquetado: { $reason }
problem-course-version = El curso se empaquetó con otra versión de Clipscope: la versión { $version } no se puede leer aquí.
problem-no-link = Esto no es un enlace de Clipscope.
problem-link-version = El enlace se hizo con otra versión de Clipscope: { $version } no se puede leer aquí.
problem-link-damaged = El enlace se ha cortado o modificado: su escena no se puede descomprimir.
problem-link-too-large = La escena del enlace es demasiado grande.
problem-link-value = «{ $value }» no tiene sentido como valor de «{ $key }» en un enlace.
problem-link-no-lesson = El curso abierto no tiene ninguna lección para «{ $name }».
problem-link-no-step = La lección no tiene el paso «{ $name }».
problem-picture-without-link = La imagen no lleva ningún enlace a un paso.
problem-no-lessons = Aquí no hay ninguna lección.
problem-too-many-lessons = Hay más de { $limit } lecciones: las demás se omiten.
problem-missing-file = Falta este archivo.
problem-unknown-language = «{ $name }» no es un idioma del curso.
problem-missing-language = No hay texto en este idioma ({ $language }): se muestra el inglés.
problem-unknown-field = Aquí no existe el campo «{ $name }».
problem-missing-field = Falta el campo «{ $name }».
problem-wrong-type = El valor es del tipo equivocado: es { $found }.
problem-wrong-length =
    { $count ->
        [one] La lista no tiene la longitud debida: { $count } valor.
       *[other] La lista no tiene la longitud debida: { $count } valores.
    }
problem-not-finite = Debe ser un número finito.
problem-out-of-range = { $value } está fuera del intervalo permitido.
problem-empty-text = Este texto está vacío.
problem-two-kinds-of-segments = Se dan a la vez «segments» y «random»: solo puede haber uno de los dos.
problem-two-kinds-of-polygons = Se dan a la vez «polygon» y «random»: solo puede haber uno de los dos.
problem-two-kinds-of-objects = Se dan a la vez «objects» y «street»: solo puede haber uno de los dos.
problem-too-many-beside = Métodos junto al primero: { $count }; caben como máximo { $most }.
problem-too-few-places = Lugares dados aquí: { $count }.
problem-two-openings = Se dan a la vez «fov_y_deg» y «height»: el primero es para la perspectiva, el segundo para una cámara paralela.
problem-two-models = Se dan a la vez «solid» y «mesh»: solo puede haber uno de los dos.
problem-two-meshes = Se dan a la vez «obj» y listas de números: solo puede haber uno de los dos.
problem-no-picture = Esto no es una imagen.
problem-mesh-plain = La malla se dibuja sin su textura.
problem-too-many-texels = Las texturas de este archivo tienen { $count } téxeles en total, más de { $limit }.
picture-elsewhere = «{ $name }» no está junto a la malla.
picture-unread = «{ $name }»: { $reason }
picture-no-material = «{ $library }» no tiene el material «{ $name }».
picture-broken = «{ $name }» no es un PNG o JPEG de { $most } téxeles por lado como máximo, o está dañado.
problem-mesh-too-large = La lista tiene { $count } entradas; un archivo de escena admite { $limit } como máximo.
problem-no-such-mesh = Junto a este archivo no hay ninguna malla «{ $name }».
problem-unknown-method = No existe el método «{ $name }».
problem-unknown-lab = No existe el laboratorio «{ $name }».
problem-unknown-control = El laboratorio no tiene ningún control «{ $name }».
problem-unknown-scene = No existe la escena «{ $name }».
problem-unknown-lock = No existe el tirador «{ $name }».
problem-unknown-value = «{ $name }» no es un valor de este campo.
problem-no-steps = La lección no tiene pasos.
problem-too-many-steps = La lección tiene { $count } pasos, más de { $limit }.
problem-bad-step-id = «{ $name }» no puede ser el id de un paso.
problem-duplicate-step = Hay dos pasos «{ $name }».
problem-bad-figure = «{ $name }» no puede ser el nombre de una figura.
problem-duplicate-figure = Hay dos figuras «{ $name }».
problem-moment-never-happens = El momento «{ $name }» no ocurre nunca en la ejecución de esta escena.
problem-unused-scene = Ningún paso muestra esta escena.
problem-bad-reference = Esta referencia no se puede leer.
problem-reference-outside = El título de una lección no admite referencias.
problem-unknown-name = Ningún valor se llama «{ $name }» en este paso.
problem-no-value = «{ $name }» no es un valor que se pueda decir en una frase.
problem-unknown-form = Un número no tiene la forma «{ $name }».
problem-like-itself = La escena «{ $name }» se toma a sí misma como modelo.
problem-missing-title = El texto no tiene título.
problem-second-title = Una lección tiene un solo título, al principio.
problem-bad-heading = Este encabezado no dice a qué paso pertenece.
problem-text-outside = Este texto no pertenece a ningún paso.
problem-unknown-step = La lección no tiene ningún paso «{ $name }».
problem-missing-section = Falta el texto del paso «{ $name }».
problem-duplicate-section = El paso «{ $name }» tiene dos textos.
problem-empty-section = El paso «{ $name }» tiene encabezado, pero no texto.
problem-long-paragraph = El párrafo tiene { $count } caracteres, más de { $limit }.
problem-unsupported-markdown = Este tipo de Markdown no se admite en una lección.
problem-stray-emphasis = Estos asteriscos no ponen el texto en negrita.
problem-stale-translation = El inglés de «{ $name }» ha cambiado desde que se tradujo.
expect-translated = Tradúcelo de nuevo y ejecuta después «clipscope check CARPETA --translated».
problem-stray-claim = Esta conclusión no está bajo el título de un paso.
expect-claim = Escribe un párrafo que empiece por «=> » justo debajo del título «## id: Título».
problem-stray-sides = La línea «=| … | …» no nombra los dos dibujos de un paso.
expect-sides = Debajo de la conclusión de un paso con `before`, escribe «=| » y dos nombres separados por « | »: cómo era y cómo es.
problem-bad-card = Esto no es una ficha.
expect-card = Escribe «## card» al final del archivo y, debajo, una lista: rule, formula, cost, pitfall dos o más veces y can; por ejemplo, «- rule: …». Una ficha no tiene referencias.
problem-stray-note = Esta nota para quien presenta la leería todo el mundo.
problem-more =
    { $count ->
        [one] No se muestra { $count } problema más de este archivo.
       *[other] No se muestran { $count } problemas más de este archivo.
    }

## What was expected in its place

expect-did-you-mean = ¿Querías decir «{ $name }»?
expect-one-of = Se esperaba: uno de { $names }.
expect-toml-value = Se esperaba: texto entre comillas rectas "", un número, true o false, o una lista con comas entre sus valores.
expect-toml-name = Se esperaba: las letras a–z y A–Z, cifras, «-» y «_».
expect-utf8 = Se esperaba: texto guardado como UTF-8.
expect-link = Se esperaba: «#lección/paso» o «#v1=» y una escena; delante puede haber una dirección.
expect-lesson-folder = Se esperaba: una carpeta con lesson.toml y en.md, o una carpeta de carpetas así.
expect-text = Se esperaba: texto entre comillas.
expect-number = Se esperaba: un número.
expect-whole = Se esperaba: un número entero de { $min } a { $max }.
expect-table = Se esperaba: una tabla de campos.
expect-window = Se esperaba: [xmin, ymin, xmax, ymax], con xmin < xmax e ymin < ymax.
expect-point = Se esperaba: los dos números de un punto, [x, y].
expect-segment = Se esperaba: los cuatro números de un segmento, [x1, y1, x2, y2].
expect-segments = Se esperaba: una lista de segmentos, [[x1, y1, x2, y2], …], o bien «random» con «count» y «seed».
expect-clip = Se esperaba: al menos tres vértices de un polígono convexo, [[x, y], …], en cualquier sentido.
expect-polygon = Se esperaba: al menos tres vértices de un polígono, [[x, y], …].
expect-holes = Se esperaba: una lista de agujeros, cada uno con al menos tres vértices, [[[x, y], …], …].
expect-place = Se esperaba: los tres números de un lugar, [x, y, z].
expect-space-segment = Se esperaba: los dos extremos de un segmento, [[x, y, z], [x, y, z]].
expect-space-triangle = Se esperaba: los tres vértices de un triángulo, [[x, y, z], [x, y, z], [x, y, z]].
expect-camera = Se esperaba: position, target, up, fov_y_deg (o height), aspect, near y far, con 0 < near < far en perspectiva.
expect-eye = Se esperaba: pitch_deg de −89 a 89, distance de 1e-6 a 1e6, fov_y_deg de 1 a 120.
expect-objects = Se esperaba: una lista de objetos, [{ "{" } solid = "cube", at = [x, y, z], size = 1 { "}" }, …], o «street» con «count» y «seed».
expect-mesh = Se esperaba: name, vertices [[x, y, z], …] y faces [[i, j, k], …], cuyos índices cuentan desde 0; también puede haber uvs [[u, v], …], una por vértice. En lugar de las listas puede estar obj, el texto de un archivo OBJ; picture es su textura, un archivo PNG o JPEG en base64.
expect-opacity = Se esperaba: un número de 0, que no se ve, a 1, que tapa todo lo que tiene detrás.
expect-picture = Se esperaba: un archivo PNG o JPEG en base64.
expect-pixel = Se esperaba: un píxel [columna, fila], contado desde 0 arriba a la izquierda.
expect-mesh-file = Se esperaba: el nombre de un archivo OBJ de la carpeta de la lección, como "cow.obj", o una tabla con name, vertices y faces.
expect-steps = Se esperaba: al menos un [[step]].
expect-kebab = Se esperaba: letras minúsculas sin tilde y cifras, unidas por guiones simples: nine-regions.
expect-figure = Se esperaba: como mucho 64 letras minúsculas sin tilde, cifras y guiones: nine-regions.
expect-first-here = El primero está en la línea { $line }.
expect-first-scene = El primer paso debe nombrar su escena; los siguientes la conservan.
expect-moment = Se esperaba: start, end o un suceso con sus palabras, como «cut left».
expect-moments = Se esperaba: una lista de momentos, como ["cut left"].
expect-moment-number = Se esperaba: un número a partir de 1 después de «#».
expect-reference = Se esperaba: un valor entre llaves, como { "{" }u_min{ "}" }, { "{" }P₁.x @ end{ "}" } o { "{" }output.segment[2] of practice : 2{ "}" }.
expect-locks = Se esperaba: una lista de los tiradores bloqueados, como ["window"].
expect-drags = Se esperaba: una lista de los tiradores que pide el texto, como ["far"].
expect-title = Se esperaba: «# Título de la lección» en la primera línea.
expect-heading = Se esperaba: un encabezado «## id: Título» para cada paso, con su texto debajo.
expect-section = Se esperaba: «## { $name }: Título» a continuación, con su texto debajo.
expect-markdown = Se esperaba: párrafos, **negrita**, *cursiva*, `código`, listas, bloques de código y una cita para la respuesta.
expect-emphasis = Se esperaba: **negrita**, sin espacios por dentro de los asteriscos; junto a un carácter chino, con la puntuación fuera.
expect-note = Se esperaba: un párrafo propio, fuera de listas y respuestas, con «!> » al principio de cada línea.

## What a value is

type-text = un texto
type-integer = un número entero
type-float = un número con decimales
type-boolean = verdadero o falso
type-date = una fecha u hora
type-list = una lista
type-table = una tabla de campos

## Archivos de malla

problem-no-number = «{ $word }» no es un número finito.
problem-too-few-numbers = Números en esta línea: solo { $count } de { $needed }.
problem-no-such-vertex = No existe el vértice { $index }: el archivo tiene { $count }.
problem-no-such-uv = No existen las coordenadas de textura { $index }: el archivo tiene { $count }. La cara se dibuja sin ellas.
problem-face-too-short = Esta cara tiene solo { $count ->
        [one] { $count } vértice
       *[other] { $count } vértices
    }: se omite.
problem-face-too-long = Esta cara tiene { $count } vértices, más de { $limit }: se omite.
problem-face-not-simple = Esta cara se corta a sí misma o no tiene área: se omite.
problem-flat-faces =
    { $count ->
        [one] { $count } triángulo no tiene área: no se ve.
       *[other] { $count } triángulos no tienen área, el primero de ellos aquí: no se ven.
    }
problem-no-faces = El archivo no tiene ninguna cara que se pueda dibujar.
problem-too-many-faces = El archivo tiene más de { $limit } triángulos: es demasiado grande para dibujarlo.
expect-obj-index = Se espera: 1 para el primer vértice del archivo, 2 para el siguiente; −1 para el anterior a esta línea.

problem-nothing-asked = La ejecución de este paso no toma ninguna decisión antes de detenerse.
expect-ask = Se esperaba: true, false o "run".
expect-decision = Se esperaba: un momento en una decisión o posterior a una.
problem-goal-missed = La parte { $count } del objetivo no se cumple en la escena que debe alcanzarlo.
problem-goal-met = El objetivo ya se cumple en la escena del paso.
expect-reached = Se esperaba: el nombre de una escena en la que se cumplan todas las partes del objetivo, que no se cumplen todas en la escena del paso.
problem-goal-parts = El objetivo tiene { $count } partes, y como máximo puede tener { $limit }.
expect-goal = Se esperaba: una lista de condiciones, como ["output.visible = false", "events(cut) = 1"].
goal-words-visible = Se ve algo
goal-words-invisible = No se ve nada
goal-words-output = En la respuesta, «{ $name }» es «{ $value }»
goal-words-event = En «{ $event }» número { $nth }, «{ $name }» es «{ $value }»
goal-words-count =
    { $count ->
        [one] La ejecución tiene { $count } paso «{ $name }»
       *[other] La ejecución tiene { $count } pasos «{ $name }»
    }
problem-goal-text = El paso «{ $name }» tiene { $count } líneas de objetivo, y lesson.toml { $limit } condiciones.
expect-goal-text = Se esperaba: una línea «- [ ] …» por cada condición.

handout-work-out = Para resolver
handout-open = Este paso se abre con { $link }
handout-kept = Para recordar
