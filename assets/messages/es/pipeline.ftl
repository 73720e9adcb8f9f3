### Lo que dice el laboratorio del volumen de visión de un vértice en su camino por todos los espacios.

alg-viewing-pipeline = Cadena de visualización

## Espacios

space-model = modelo
space-world = mundo
space-view = vista
space-clip = recorte
space-ndc = NDC
space-screen = pantalla
space-model-title = Espacio del modelo
space-world-title = Espacio del mundo
space-view-title = Espacio de vista: la cámara es el origen
space-clip-title = Espacio de recorte, ejes x, y, w
space-clip-parallel-title = Espacio de recorte, ejes x, y, z
space-ndc-title = NDC: dividido entre w
space-screen-title = Pantalla, en píxeles
object-vertex = Vértice
pipeline-note-world = tamaño, giro y lugar del objeto
pipeline-note-view = cámara en { $at }
pipeline-note-clip = { $angle }°; { $aspect } : 1; plano cercano { $near }, lejano { $far }
pipeline-note-clip-parallel = altura { $height }; { $aspect } : 1; plano cercano { $near }, lejano { $far }

## Pseudocódigo

code-pipeline-world = world ← world_from_model · (P, 1)
code-pipeline-view = view ← view_from_world · (world, 1)
code-pipeline-clip = clip ← clip_from_view · (view, 1)
code-pipeline-test = dentro si −w ≤ x, y, z ≤ w
code-pipeline-divide = si w > 0: ndc ← (x, y, z) / w
code-pipeline-screen = screen ← ((x + 1)/2 · columnas, (1 − y)/2 · filas)
code-pipeline-behind = si no: sin lugar en la pantalla
words-pipeline-world = La matriz del objeto pone el vértice en el mundo.
words-pipeline-view = La matriz de la cámara dice dónde está el vértice, visto desde ella.
words-pipeline-clip = La proyección escala x e y, y copia la profundidad en w.
words-pipeline-test = El recorte comprueba esto antes de dividir nada.
words-pipeline-divide = Dividir entre la profundidad hace pequeño lo lejano.
words-pipeline-screen = Pasa de −1 … 1 a píxeles, contados desde arriba a la izquierda.
words-pipeline-behind = Un punto que no está delante del ojo no tiene imagen.

## Pasos

pipeline-opening = Un vértice se da tal como lo puso quien lo modeló: ¿dónde quedará en la pantalla?
pipeline-world-row = La fila { $row } de la matriz del objeto escala, gira y lleva el vértice a su lugar en el mundo.
pipeline-view-right = La fila 1 mide hacia la derecha de la cámara: P está { $value } a la derecha.
pipeline-view-left = La fila 1 mide hacia la derecha de la cámara: P está { $value } a la izquierda.
pipeline-view-above = La fila 2 mide hacia arriba de la cámara: P está { $value } por encima de su eje.
pipeline-view-under = La fila 2 mide hacia arriba de la cámara: P está { $value } por debajo de su eje.
pipeline-view-back = La fila 3 mide hacia atrás: P está { $value } por detrás de la cámara.
pipeline-view-ahead = La fila 3 mide hacia atrás: P está { $value } por delante, y por eso z es negativa.
pipeline-clip-x = La fila 1 escala x: los planos izquierdo y derecho quedan en x = ±w.
pipeline-clip-y = La fila 2 escala y: los planos inferior y superior quedan en y = ±w.
pipeline-clip-z = La fila 3 pone el plano cercano en z = −w y el lejano en z = w.
pipeline-clip-w = La fila 4 copia la profundidad en w: { $value }. Después x, y, z se dividen entre ella.
pipeline-clip-w-parallel = La fila 4 deja w en 1: con líneas de visión paralelas no hace falta dividir.
pipeline-inside = P está dentro: x, y, z quedan entre −w y w.
pipeline-outside = P está fuera: el recorte lo quita.
pipeline-divide = Divide entre w = { $w }: lo que está dentro queda entre −1 y 1.
pipeline-screen = Pasa de −1 … 1 a { $columns } × { $rows } píxeles; las filas se cuentan desde arriba.
pipeline-behind = P no está delante del ojo: su w no puede ser divisor, y P no tiene lugar en la pantalla.

## Casos

object-model-matrix = matriz del modelo
object-camera = cámara
object-picture = imagen
json-whole = un número entero
case-whole-too-large = { $number } es mayor que el número de cualquier píxel.
case-picture-side = Un lado de la imagen tiene de 1 a { $max } píxeles, y hay { $found }.
case-pipeline-inside = Dentro, y en la pantalla en { $screen }.
case-pipeline-outside = Fuera; sin recorte estaría en la pantalla en { $screen }.
case-pipeline-behind = No está delante del ojo: no tiene lugar en la pantalla.
object-from = desde
object-to = hasta
case-too-many-pixels = La línea tiene { $found } píxeles: se admiten { $max } como máximo.
case-pixels =
    { $count ->
        [one] Un píxel.
       *[other] { $count } píxeles.
    }

## De una línea a sus píxeles

alg-bresenham = De la línea a los píxeles (Bresenham)
raster-line = Pantalla, { $columns } × { $rows } píxeles
raster-lens = Del punto medio a la línea: e / { $whole } de píxel
code-drawn-project = clip ← clip_from_world · (P, 1), para ambos extremos
code-drawn-clip = recortar la línea a −w ≤ x, y, z ≤ w
code-drawn-divide = S ← viewport(x / w, y / w)
code-drawn-begin = a, b ← el mayor y el menor de |Δx|, |Δy|; e ← 2b − a
code-drawn-put = poner el píxel; hasta el último:
code-drawn-diagonal = si e > 0, o e = 0 y lateral da menor coordenada:
code-drawn-across = un paso lateral; e ← e − 2a
code-drawn-straight = un paso adelante; e ← e + 2b
words-drawn-project = Proyecta: ambos extremos van al espacio de recorte; aún no se divide nada.
words-drawn-clip = Recorta: se quita lo que la cámara no puede ver.
words-drawn-divide = Divide entre w y cuenta en píxeles.
words-drawn-begin = Cada extremo va a su píxel; e dice de qué lado del primer punto medio pasa la línea.
words-drawn-put = Avanza píxel a píxel por el eje mayor.
words-drawn-diagonal = ¿Va la línea más allá del punto medio? Si pasa justo por él, se toma la coordenada menor.
words-drawn-across = Entonces, da también un paso por el eje menor.
words-drawn-straight = Da un paso por el eje mayor.
drawn-line-opening = ¿Qué píxeles tiene la línea?
drawn-line-project = { $end } va al espacio de recorte: su profundidad { $w } pasa a ser w.
drawn-line-project-behind = { $end } va al espacio de recorte. No está delante del ojo: no se debe dividir entre w = { $w }.
drawn-line-clip-whole = Toda la línea está dentro: no se quita nada.
drawn-line-clip-cut = La línea se recorta antes de dividir: lo que queda tiene w > 0.
drawn-line-reject = Nada de la línea está dentro: no se dibuja ningún píxel.
drawn-line-divide = Divididos entre w y escalados, ambos extremos son lugares de la pantalla.
drawn-line-round = Cada extremo va al píxel en que está; la línea va ahora de centro a centro.
drawn-line-first = { $at } es el primer píxel. e dice de qué lado del siguiente punto medio pasa la línea.
drawn-line-straight = e = { $e } < 0: la línea no llega al punto medio. Un paso recto, a { $at }.
drawn-line-diagonal = e = { $e } > 0: la línea pasa del punto medio. Un paso en diagonal, a { $at }.
drawn-line-tie-straight = e = 0: justo entre dos píxeles, y se toma la coordenada menor: { $at }.
drawn-line-tie-diagonal = e = 0: justo entre dos píxeles, y se toma la coordenada menor: { $at }, en diagonal.
