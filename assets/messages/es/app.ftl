### The window around the labs: tabs, panels, transport, menus, keys, and what it says when something goes right or wrong.

## The program

app-title = Clipscope

## Labs: the tabs of the window

lab-lines = Segmentos
lab-lines-about = Recorta un segmento con una ventana.
lab-polygons = Polígonos
lab-polygons-about = Recorta un polígono con una ventana o con otro polígono.
lab-frustum = Volumen de visión
lab-frustum-about = Mira lo que ve una cámara y lo que se puede descartar antes de dibujarlo.
lab-surfaces = Superficies
lab-surfaces-about = Mira qué superficie está delante, píxel a píxel.

## Panels

panel-course = Curso
panel-stage = Escena
stage-boundary = Límite entre el dibujo y lo que está a su lado: se arrastra o se mueve con las flechas.
panel-inspector = Inspector
panel-algorithm = Algoritmo
panel-pseudocode = Pseudocódigo
panel-watch = Variables
panel-controls = Ajustar
panel-cost = Coste
panel-timeline = Línea de tiempo
panel-scene = Datos de la escena

## Transport: moving through the steps of a run

transport-first = Primer paso
transport-back = Un paso atrás
transport-play = Reproducir
transport-pause = Pausar
transport-forward = Un paso adelante
transport-last = Último paso
transport-next-page = Siguiente paso de la lección
transport-speed-value = Pasos por segundo: { $speed }
transport-step = paso { $step } de { $total }
transport-steps =
    { $count ->
        [one] { $count } paso
       *[other] { $count } pasos
    }

## Pseudocode, watch table, cost and verdict

pseudocode-full = Código
pseudocode-words = En palabras
pseudocode-hidden = Oculto
pseudocode-hidden-note = Oculto: ¿qué sigue ahora?
watch-empty = Todavía no se ha calculado nada.
verdict-title = ¿Por qué?
verdict-go = Ir a ese paso (Intro)
cost-additions = sumas y restas
cost-sums = sumas
cost-multiplications = multiplicaciones
cost-divisions = divisiones
cost-comparisons = comparaciones
cost-total = en total
cost-compare = Comparar con…
cost-compare-none = Sin comparación

## Settings

settings-theme = Tema
theme-light = Claro
theme-dark = Oscuro
theme-projector = Proyector
settings-text = Tamaño del texto
settings-snap = Ajustar a la cuadrícula

## Actions

action-present = Presentar
action-present-leave = Salir de la presentación
action-open-whole = Abrir en Clipscope
action-notes = Notas para quien presenta
speaker-clock = { $clock } desde que empezó la presentación (horas y minutos)
speaker-no-note = Este paso no tiene notas.
speaker-next = Después: { $title }
speaker-last = Este es el último paso.
courses = Otros cursos
course-built-in = El curso incluido
action-picture = La imagen de la cámara junto a la del observador
no-picture = Ningún método del escenario muestra aquí la imagen de la cámara.
type-what = Elige primero un tirador: Tab pasa de uno a otro y un clic toma uno.
action-free = Escena libre
action-course = Volver al curso
free-title = Escena libre
free-scenes = Escenas libres
scene-new = Nueva escena libre…
scene-copy = Copia de esta escena…
scene-rename = Cambiar el nombre de esta escena libre…
scene-delete = Eliminar esta escena libre…
scene-numbered = Escena { $n }
scene-name = Nombre
scene-name-taken = Otra escena de este laboratorio ya tiene este nombre.
scene-make = Crear
scene-rename-it = Cambiar
scene-delete-it = Eliminar
scene-delete-asks = «{ $name }» desaparece, con todo lo que se podía deshacer en ella. No se podrá recuperar.
free-about = Tu propia escena: no hay nada bloqueado y la escena se conserva.
free-about-large = Tu propia escena: no hay nada bloqueado. La escena es demasiado grande para conservarse al cerrar la ventana: guárdala en un archivo (Ctrl+S).
free-back = ← {$lesson}
free-from-course = Escenas del curso
scene-adopt = Abrir esta escena en: { $lab }
action-help = Ayuda
action-undo = Deshacer
action-redo = Rehacer
save-exists = Este archivo ya existe y no es el que se abrió.
action-replace = Reemplazarlo
action-open = Abrir…
action-open-it = Abrir
action-open-path = Abrir por su ruta…
action-recent = Abrir un archivo reciente
action-save = Guardar
action-save-path = Guardar en una ruta…
action-browse = Examinar…
action-export = Exportar esta figura
action-copy = Copiar esta figura
action-copy-svg = Copiar como texto SVG
action-link = Copiar un enlace a lo que se ve
action-reset = Restablecer
action-fit = Encuadrar
handle-locked = { $name } no se puede mover en este paso.
handle-other = haz clic: { $name }
handles-listed = { $list }; { $name }
action-reset-view = Encuadrar todo
action-close = Cerrar
action-cancel = Cancelar

## Help: the keys

help-title = Teclas
help-step = Un paso atrás o adelante
help-step-ten = Diez pasos
help-phase = Fase anterior o siguiente
help-ends = Primer o último paso
help-play = Reproducir o pausar
help-reset = Restablecer la escena del paso; mostrar una escena libre desde su primer paso, encuadrada
help-lesson-step = Paso anterior o siguiente de la lección
help-drag = Arrastra cualquier tirador, en cualquier paso: la ejecución se vuelve a registrar

## What the program reports

status-exported = Exportado en { $path }
status-exporting = Pasos exportados: { $count } de { $total }. Esc detiene la exportación.
status-export-failed = No se pudo exportar la figura: { $reason }
status-copied = La figura está en el portapapeles: { $width } × { $height } píxeles.
status-copied-svg = La figura está en el portapapeles como texto de un archivo SVG ({ $count } kB).
status-copy-failed = No se pudo copiar la figura: { $reason }
status-link-copied = El enlace está en el portapapeles ({ $count } caracteres). Quien lo abra verá lo que ves tú.
status-link-long = El enlace está en el portapapeles. Tiene { $count } caracteres: algunos programas cortan los enlaces de más de 2000.
status-link-of-page = Esta escena es demasiado grande para un enlace. El enlace del portapapeles lleva al paso de la lección tal como era.
status-link-none = Esta escena es demasiado grande para un enlace. Guárdala en un archivo.
greeting = ← y → recorren la ejecución paso a paso, Espacio la reproduce. Todo lo que tiene un tirador se puede arrastrar, en cualquier paso.
status-restored = Tu trabajo de la última vez está de vuelta; deshacer lo quita.
status-saved = Guardado en { $path }
status-memory-aside = No se pudo leer { $path }: { $reason } Ahora se llama { $aside } y los ajustes empiezan de nuevo.
status-memory-unread = No se pudo leer { $path }: { $reason } Los ajustes y el trabajo no se guardarán.
status-memory-unkept = Los ajustes y el trabajo no se pueden guardar en { $path }: { $reason }.
status-memory-full = El navegador no puede guardar los ajustes ni el trabajo: { $reason }.
status-memory-refused = El navegador no guarda nada de esta página: los ajustes y el trabajo se perderán cuando la cierres. Guarda en un archivo lo que quieras conservar.
status-coming = { $what } está en camino.
status-not-come = { $what } no ha llegado. Elígelo otra vez para volver a intentarlo.
status-fonts-coming = Los caracteres chinos todavía se están cargando. Prueba de nuevo dentro de un momento.
status-save-failed = No se pudo guardar la escena: { $reason }
status-open-failed = No se pudo abrir { $path }: { $reason }
status-forgotten = Ya no está entre los archivos recientes.
status-no-window = No se pudo abrir la ventana: necesita una pantalla y OpenGL. Sin ellos, clipscope export dibuja las figuras en archivos. El sistema dice: «{ $reason }»
status-kept = La escena queda como estaba.
status-mesh-reading = Leyendo { $path }… Esc cancela.
status-mesh-given-up = Se canceló la lectura de { $path }: la escena sigue como estaba.
status-mesh-plain = No se pudo leer la textura que nombra { $library }: la malla se dibuja sin ella.
status-mesh-picture = { $name } está junto a la malla y se usa como su textura.
status-mesh-added =
    { $count ->
        [one] { $name }, con { $count } triángulo, ya está en la escena.
       *[other] { $name }, con { $count } triángulos, ya está en la escena.
    }
status-reloaded = { $path } cambió y se volvió a leer.

## For screen readers

access-handle = tirador de { $name } en { $point }

## More of the window: menus, dialogs, keys

menu-more = Más
cost-title = Coste hasta aquí
cost-compared-with = en comparación con { $method }
open-title = Abrir una escena
save-title = Guardar la escena
export-title = Exportar esta figura
export-format = Formato
export-weight = Tamaño del archivo
export-weight-of =
    { $count ->
        [one] { $size } kB
       *[other] { $count } archivos de unos { $size } kB
    }
export-size = Tamaño
export-language = Idioma
export-steps = Pasos
export-this-step = este paso
export-all-steps = todos los pasos de la ejecución
save-path = Archivo
save-folder = Carpeta
key-space = Espacio
key-enter = Intro
key-escape = Esc
key-delete = Supr
key-insert = Insert
key-home = Inicio
key-end = Fin
key-page-up = RePág
key-page-down = AvPág
key-backspace = Retroceso
key-shift = Mayús
help-zoom = Acercar o alejar; también Ctrl y la rueda
help-text = Texto mayor, menor o como al principio
help-course = Mostrar u ocultar el curso
help-free = Escena libre anterior o siguiente del laboratorio
help-inspector = Mostrar u ocultar el inspector
help-leave = Cerrar, o salir de la presentación
help-tab = Al siguiente tirador o botón
help-nudge = Mover el tirador que tiene el foco; con Mayús, diez veces más lejos
help-deeper = En el espacio: alejar o acercar ese tirador respecto al ojo
help-axis = En el espacio, pulsada mientras se mueve un tirador: solo a lo largo de ese eje
help-type = Escribir la posición del tirador elegido
help-alt = Al arrastrar: sin ajustar a la cuadrícula
help-pen = Al presentar, mantenida: dibujar sobre la escena, hasta el paso siguiente
help-verdict = Ir al paso que decidió el destino de lo pulsado
status-last-good = Se muestra la última versión que funcionaba.
status-more-problems =
    { $count ->
        [one] … y { $count } problema más.
       *[other] … y { $count } problemas más.
    }

## Vertices, outlines, and the methods that are wrong on purpose

help-add = Otro segmento, o un vértice después del seleccionado
help-remove = Quitar el segmento o el vértice seleccionado
help-draw-close = Al dibujar: cerrar el contorno
help-draw-back = Al dibujar: deshacer el último vértice
help-edge = Doble clic, o Ctrl y clic, en una arista: un vértice nuevo ahí
help-turn = En el espacio, el botón derecho gira la vista, se arrastre donde se arrastre; la rueda la acerca
faulty-title = ¿Qué falla aquí?
methods-objects = Objetos, caras y puntos
methods-segments = Segmentos
methods-triangles = Triángulos
methods-vertices = Vértices
methods-why = De dónde salen las fórmulas
faulty-unnamed = El programa de un estudiante
differs-from = difiere desde el paso { $step }
differs-nowhere = mismos pasos con esta entrada
not-so = × { $what }
wrong-and-right = Mal: { $wrong } Bien: { $right }
part-missing = falta
result-right = Resultado correcto: { $n }
result-wrong = × Resultado erróneo: { $n }
again = { $what } otra vez
is-missing = falta { $what }
refused = rechazado
run-later = La escena es demasiado grande para que el método se ejecute mientras arrastras. Se ejecuta cuando sueltas.
recording-triangles = Se registra { $method } con { $count ->
        [one] { $count } triángulo
       *[other] { $count } triángulos
    }…
recording-vertices = Se registra { $method } con { $count ->
        [one] { $count } vértice
       *[other] { $count } vértices
    }…
recording-segments = Se registra { $method } con { $count ->
        [one] { $count } segmento
       *[other] { $count } segmentos
    }…
recording-stop = Detener (Esc)

## Vistas junto al dibujo

view-empty = no queda nada
view-more = … { $count } más

practice = Pregúntame
action-practise = Antes de cada decisión, pregúntame qué viene
practice-question = ¿Qué viene ahora?
practice-how = Pulsa una cifra o elige.
practice-take-back = Deshacer la respuesta (Retroceso)
practice-show = Muéstramelo (S)
practice-right = ✓ { $right }.
practice-wrong = × { $chosen }. Lo correcto: { $right }.
practice-shown = { $right }.
practice-go-on = Seguir (Intro)
practice-told = { $right } de { $count } acertadas antes de verlas
practice-done = La ejecución ha terminado: no quedan decisiones.
practice-on = Te preguntaré antes de la próxima decisión.
practice-leave = No preguntar más
practice-step = paso { $step }
what-comes-next = ¿Qué viene ahora? { $options }
named-sentence = { $name }: { $said }
figure-before = Antes
figure-now = Ahora

lesson-waits = El resto se abre con tu respuesta, o con S.
lesson-ask-again = Pregúntamelo otra vez
settings-asks = Las lecciones preguntan antes de mostrar
settings-marks-at-end = Marcas al final de la ejecución
answers-title = Preguntas de esta ejecución
answers-earlier = Respuestas anteriores en esta ejecución: { $count }
answer-right = Paso { $step }: { $right }. Dicho de antemano.
answer-wrong = Paso { $step }: { $right }, no: { $chosen }.
answer-shown = Paso { $step }: { $right }. Mostrado.
practice-stands = La pregunta de este paso: { $told }.
told-beforehand = respondida de antemano
told-after = respondida después de ver los números
told-open = pendiente
told-missed = pendiente; tu respuesta no era correcta
told-seen = visto
told-unseen = aún no visto
progress-title = Progreso
progress-counts = { $seen ->
    [one] Un paso visto
   *[other] { $seen } pasos vistos
} · dichos de antemano: { $beforehand } · dichos después de los números: { $after } · pendientes: { $open } · objetivos alcanzados: { $reached } / { $goals }
progress-hand-in = Entregar…
progress-take-up = Cargar un archivo…
progress-afresh = Empezar de cero
progress-sure = Se pierden todas las marcas de este ordenador.
hand-in-title = Entregar tu progreso
take-up-title = Cargar un archivo de progreso
progress-taken-up = Las marcas del archivo se han añadido a las tuyas.
goal-reached = Se cumplen todas las partes: has alcanzado el objetivo.
goal-part-met = se cumple
goal-part-open = aún no se cumple
mark-reached = objetivo alcanzado
mark-goal = objetivo aún no alcanzado
goal-hint = Pista (T)
goal-hint-part = { $part } de { $count } vistas
goal-hint-none = La ejecución de esta escena no decide nada: cambia primero la escena.
goal-hint-now = «{ $part }»: ahora { $now }; se pide { $sign }{ $wanted }.
goal-hint-open = «{ $part }»: todavía no.
goal-hint-way = Una solución mueve solo esto: { $handles }.
goal-hint-parts = En una solución los dos programas se separan aquí: { $said }
goal-so-far = Dónde acabaron tus ejecuciones
goal-ended =
    { $count ->
        [one] { $said } { $count } ejecución acabó así.
       *[other] { $said } { $count } ejecuciones acabaron así.
    }
action-hint = Una pista hacia el objetivo: qué decide y después la ecuación
mark-hints =
    { $count ->
        [one] { $count } parte de la pista vista
       *[other] { $count } partes de la pista vistas
    }
action-smaller = Una escena más pequeña con la misma diferencia
smaller-search = Se busca una escena más pequeña. Esc detiene la búsqueda y deja la más pequeña que se haya encontrado.
smaller-none = No se ha encontrado ninguna escena más pequeña con la misma diferencia: esta ya es pequeña.
smaller-not-yet = Primero cambia la escena hasta alcanzar el objetivo. Después, M reduce la escena.
smaller-fewer = La escena es más pequeña, y la diferencia es la misma. Vértices: { $after } en lugar de { $before }.
smaller-rounder-only = Los números son más redondos, y la diferencia es la misma.
smaller-rounder = Los números son más redondos, y la diferencia es la misma. Se ha movido: { $handles }.
smaller-no-difference = Aquí no hay diferencia que reducir: junto al método correcto debe haber uno con un error, y los dos deben diferir.

## A lesson that is made

compose-title = Crear una lección
compose-begin = Modificar esta lección
compose-leave = Terminar con la lección
compose-try = Probarla como estudiante
compose-back = Volver a crear la lección
compose-saved = ✓ Todo está guardado.
compose-unsaved = … Los cambios aún no están guardados.
compose-outside = Otro programa ha cambiado los archivos de esta lección. No se guarda nada hasta que decidas. Ahora dicen:
compose-take-theirs = Tomar esa versión
compose-keep-mine = Conservar la versión de esta ventana
compose-settle-first = Otro programa ha cambiado los archivos de esta lección: decide primero qué versión se queda.
compose-step-title = Paso { $n } de { $total }, título
compose-text = Texto, en Markdown
compose-text-how = > oculta una respuesta hasta que un estudiante la pide. Una línea --- termina lo que se lee antes de responder a una pregunta.
compose-stands = Dónde está la ejecución
compose-follows = sigue la línea de tiempo
compose-locked = Bloqueado
compose-lock-focused = al crear una lección: bloquea o desbloquea el control activo
compose-ask = Preguntar antes de este paso
compose-ask-decision = la última decisión
compose-ask-run = cada decisión de la ejecución
compose-figure = Una figura que se puede exportar
compose-figure-name = Nombre de la figura
compose-id = Nombre del paso en enlaces
compose-goal = Un objetivo: hay que alcanzar la escena tal como está
compose-goal-how = Ahora arrastra la escena hasta donde empiezan los estudiantes. Se comprueban estas partes:
compose-add = Añadir un paso aquí
compose-insert = Insertar un paso después del paso { $n }
compose-row = paso { $n } de { $total }, { $title }, en { $at }
compose-own-scene = Nueva escena desde aquí
compose-own-scene-about = Desde ahora este paso tiene una escena propia: lo que arrastres en ella no cambia ningún otro paso.
compose-how = Lo que cambies en el escenario es desde entonces la escena de este paso. En esta lista Insert añade un paso, Supr lo quita y Alt con ↑ ↓ lo mueve.
compose-lesson = Título de la lección
compose-source = De dónde viene
compose-source-at-first = Hecha en Clipscope
compose-new-title = ¿Qué pasa aquí?
compose-has-goal = tiene un objetivo
compose-asks-first = pregunta primero
compose-refused = Eso no cabe en los archivos de la lección: un título es una línea, una línea que empieza con # empezaría otro paso y cada nombre aparece una sola vez.
compose-form = La ventana no puede cambiar lesson.toml en la forma que tiene: cada paso tiene que estar bajo una línea [[step]].
compose-own-only = Solo se puede modificar una lección de una carpeta tuya. Copia primero esta en una carpeta.
compose-mend-first = Corrige primero el error: los pasos solo se añaden, se quitan y se mueven en una lección sin errores.
lesson-save = Guardar como lección…
lesson-copy = Copiar esta lección en una carpeta…
lesson-save-title = Una carpeta para la lección
lesson-save-taken = En esta carpeta ya hay una lección.
