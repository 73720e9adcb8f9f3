### Why something is refused, or fails: one sentence for each typed error, whoever reports it.

## Shapes; the last part of the key is the code in the command line’s JSON where that has one

error-not-finite = Todas las coordenadas deben ser números finitos.
error-empty-window = La ventana está vacía: { $low } = { $min } debe ser menor que { $high } = { $max }.
error-too-few-vertices = Un polígono necesita al menos tres vértices.
error-degenerate = La figura es degenerada: no tiene longitud o área donde la necesita.
error-not-convex = El polígono de recorte debe ser convexo: este algoritmo conserva lo que queda en el lado interior de todas sus aristas.
error-self-intersecting = El polígono se corta a sí mismo.
error-edges-meet = El contorno no debe tocarse ni cortarse a sí mismo: las aristas { $first } y { $second } se cortan, se tocan o se superponen.
error-misplaced-hole = El agujero { $hole } debe quedar dentro del contorno, sin tocarlo ni tocar ningún otro agujero.
error-at = { $place }: { $problem }

## Shapes in space

error-empty-box = La caja está vacía: { $low } = { $min } no debe ser mayor que { $high } = { $max }.
error-zero-normal = Un plano necesita un vector normal distinto de cero.
error-negative-radius = Un radio no puede ser negativo, pero este es { $radius }.
error-no-vertices = Sin vértices no hay volumen envolvente.
error-target-at-position = La cámara no tiene dirección: está en el mismo punto al que mira.
error-up-along-view = El vector «arriba» de la cámara no debe ser cero ni paralelo a la dirección de visión.
error-field-of-view = El campo de visión debe estar entre 0° y 180°, sin incluirlos, pero es { $degrees }°.
error-size = Un tamaño debe ser mayor que 0, pero este es { $size }.
error-height = La altura del volumen de visión debe ser mayor que 0, pero es { $height }.
error-aspect = La relación de aspecto, anchura entre altura, debe ser mayor que 0 y dejar anchura al volumen de visión, pero es { $aspect }.
error-near = El plano cercano debe estar delante del ojo, a una distancia mayor que 0, pero está a { $near }.
error-far = El plano lejano debe estar más allá del plano cercano: far = { $far } debe ser mayor que near = { $near }.
error-not-affine = La última fila de esta matriz debe ser 0 0 0 1.
error-face-vertex = La cara { $face }, contando desde 0, nombra un vértice que no existe.
error-no-mesh-faces = Una malla necesita al menos una cara.
error-uv-length = Una malla necesita tantas coordenadas de textura como vértices, o ninguna. Coordenadas de textura: { $uvs }; vértices: { $vertices }.

## Scenes

error-no-objects = Una escena necesita al menos un objeto.
error-too-many-objects = Una escena admite como máximo { $limit } objetos, pero hay { $count }.
error-no-such-object = No hay objeto { $focus }; objetos de la escena: { $count }.
error-no-such-face = No hay cara { $face }; caras del objeto: { $count }.
error-no-such-vertex = No hay vértice { $vertex }; vértices del objeto: { $count }.
error-no-segments = No hay ningún segmento.
error-too-many-segments = Hay demasiados segmentos: { $count }; se admiten { $limit } como máximo.
error-no-such-focus =
    { $count ->
        [one] No existe el segmento { $focus }: hay { $count } segmento, contando desde 0.
       *[other] No existe el segmento { $focus }: hay { $count } segmentos, contando desde 0.
    }
error-last-three = El vértice se conserva: un polígono necesita al menos tres.
error-too-many-vertices = Hay demasiados vértices: { $count }; se admiten { $limit } como máximo.

## Moments of a run

error-bad-moment = Esto no nombra ningún momento.

## Files

error-unreadable = No se puede leer el archivo: { $reason }.
error-file-too-large = El archivo supera los { $limit } MiB.
error-link-out = El archivo es un enlace que lleva fuera de la carpeta de la lección.
memory-broken = No es un archivo de ajustes.

## What the system answers; set after a colon, in the middle of a sentence

system-not-found = no existe ese archivo o carpeta
system-denied = no hay permiso
system-exists = ya existe
system-is-folder = es una carpeta
system-not-file = no es un archivo
system-not-folder = una parte de la ruta no es una carpeta
system-full = el disco está lleno
system-read-only = el disco es de solo lectura
system-bad-name = el nombre no es válido
system-too-large = el archivo es demasiado grande
system-busy = otro programa lo está usando
system-no-files = aquí no hay archivos
system-loop = es un enlace que lleva a sí mismo
system-number = el sistema indica el error { $number }
system-silent = el sistema no da ningún motivo
error-typed-range = se esperaba un número de { $least } a { $most }, pero se escribió { $typed }
error-typed-place = { $count ->
    [1] se esperaba un número
   *[other] se esperaban { $count } números
}, como −1,5 o 1/4, pero se escribió { $typed }

error-progress-broken = Este archivo no es de progreso.
error-progress-version = Este archivo es de una versión posterior de Clipscope.
