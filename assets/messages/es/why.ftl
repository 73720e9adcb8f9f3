### Demostraciones con dibujos: de dónde salen las fórmulas.

## Vistas

why-view-section = A lo largo del plano, longitudes reales

## t por triángulos semejantes

why-similar = Por qué: t = d₁ / (d₁ − d₂)
why-similar-opening = ¿Después de qué parte t del camino de P₁ a P₂ encuentra el segmento el plano { $plane }?
why-similar-d1 = El valor de n·P + D en P₁ dice a cuántos niveles del plano está P₁.
why-similar-d2 = Lo mismo en P₂.
why-similar-levels = De P₁ a P₂ el segmento pasa por todos los niveles entre esos dos valores.
why-similar-parallel = Todo el segmento está en un mismo nivel: es paralelo al plano y no hay t.
why-similar-piece = Todos los triángulos entre dos niveles tienen los mismos ángulos, así que un cambio de 1 ocupa en todas partes el mismo trozo del segmento.
why-similar-t = El plano es el nivel 0. De P₁ al plano el valor cambia en −d₁, y en todo el camino, en d₂ − d₁.
why-code-d1 = d₁ ← n·P₁ + D;  d₂ ← n·P₂ + D
why-words-d1 = Halla el nivel de cada extremo.
why-code-levels = niveles ← d₂ − d₁
why-words-levels = Cuenta los niveles de un extremo al otro.
why-code-piece = trozo ← 1 / niveles
why-words-piece = Cada nivel ocupa el mismo trozo del segmento.
why-code-t = t ← −d₁ · trozo = d₁ / (d₁ − d₂)
why-words-t = De P₁ al plano hay −d₁ niveles.

## n·(P − p₀) como sombra

why-view-above = Visto desde arriba
why-view-side = Visto de lado
why-view-front = Visto de frente
why-shadow = Por qué: d = n·(P − p₀)
why-shadow-opening = Ve de p₀, un punto del plano { $plane }, a P en pasos a lo largo de los ejes. La luz corre a lo largo del plano.
why-shadow-piece = El paso a lo largo de { $axis } da su propia sombra sobre n: tan larga como el paso por esta componente de n.
why-shadow-sum = Puestas una tras otra, las sombras de los pasos son la sombra de todo el camino P − p₀.
why-shadow-distance = La sombra y la perpendicular son lados opuestos de un rectángulo, así que la sombra es la distancia d de P al plano { $plane }.
why-shadow-elsewhere = Desde p₀ = { $other } cada sombra es distinta, y la suma es la misma.
why-code-steps = para cada eje: paso ← P − p₀
why-words-steps = Ve de un punto del plano a P, eje por eje.
why-code-shadow = sombra ← paso · componente de n
why-words-shadow = Cada paso da una sombra sobre la normal.
why-code-sum = n·(P − p₀) ← suma de las sombras
why-words-sum = Las sombras se suman.
why-code-rectangle = d ← n·(P − p₀) = n·P + D
why-words-rectangle = La perpendicular es tan larga como la sombra, sea cual sea el punto p₀.
