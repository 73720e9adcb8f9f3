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
