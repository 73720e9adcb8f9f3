# O laboratório de polígonos.

handle-clip-vertex = vértice { $number } do polígono de recorte
handle-hole-vertex = vértice { $number } do furo { $hole }
handle-polygon = o polígono
texture-title = Textura
texture-none = nenhuma
texture-interpolated = interpolada com t
texture-kept = sem interpolar (errada)
part-subject = o polígono sujeito
part-hole = um furo
part-clip = o polígono de recorte
refused-not-convex = Este algoritmo exige uma região de recorte convexa: { $part } vira para o lado errado em { $vertex }.
refused-winds-twice = Este algoritmo exige um contorno simples: { $part } já deu mais de uma volta em { $vertex }.
refused-degenerate = Não há nada a recortar: { $part } não tem área.
