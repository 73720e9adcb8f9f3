# El laboratorio de polígonos.

handle-clip-vertex = vértice { $number } del polígono de recorte
handle-hole-vertex = vértice { $number } del hueco { $hole }
handle-polygon = el polígono
texture-title = Textura
texture-none = ninguna
texture-interpolated = interpolada con t
texture-kept = sin interpolar (error)
part-subject = el polígono sujeto
part-hole = un hueco
part-clip = el polígono de recorte
refused-not-convex = Este algoritmo exige una región de recorte convexa: { $part } gira hacia el lado equivocado en { $vertex }.
refused-winds-twice = Este algoritmo exige un contorno simple: { $part } ya ha dado más de una vuelta en { $vertex }.
refused-degenerate = No hay nada que recortar: { $part } no tiene área.

## Dibujar un contorno con clics

action-draw-subject = Dibujar el polígono
action-draw-clip = Dibujar el polígono de recorte
action-draw-hole = Dibujar un hueco
action-no-holes = Quitar todos los huecos
draw-subject = Haz clic para poner el vértice { $number } del nuevo polígono; Retroceso quita uno, Escape abandona.
draw-clip = Haz clic para poner el vértice { $number } del nuevo polígono de recorte; Retroceso quita uno, Escape abandona.
draw-hole = Haz clic para poner el vértice { $number } del nuevo hueco; Retroceso quita uno, Escape abandona.
draw-close = Haz clic para poner el vértice { $number }; Intro, un doble clic o un clic en el primer vértice cierra el contorno.
refused-last-three = El vértice se queda: un polígono necesita al menos tres.
refused-too-many = { $count } vértices son demasiados: como máximo { $most }.

## Polígonos y regiones para empezar

preset-title = Polígonos de ejemplo
preset-convex = Convexo
preset-triangle = Triángulo
preset-arrow = Punta de flecha (cóncavo)
preset-comb = Peine: varios trozos
preset-corner = Alrededor de una esquina: un puente
preset-spiral = Espiral
preset-star = Estrella
preset-hole = Con un hueco
preset-around = Rodea toda la ventana
preset-inside = Dentro de la ventana
preset-touch = Toca en un solo punto
preset-along = Una arista sobre el borde
preset-bow-tie = Pajarita: se cruza a sí mismo
preset-random = Al azar
random-count = Vértices
random-make = Reemplazar el polígono
region-title = Región de recorte
region-window = Ventana
region-corners = Las cuatro esquinas de la ventana
region-triangle = Triángulo
region-diamond = Rombo
region-octagon = Octógono
region-bracket = Forma de L (cóncava)
