### Provas por desenho: de onde vêm as fórmulas.

## Vistas

why-view-section = Ao longo do plano, comprimentos reais

## t por triângulos semelhantes

why-similar = Por quê: t = d₁ / (d₁ − d₂)
why-similar-opening = Depois de que parte t do caminho de P₁ a P₂ o segmento encontra o plano { $plane }?
why-similar-d1 = O valor de n·P + D em P₁ diz a quantos níveis do plano P₁ está.
why-similar-d2 = O mesmo em P₂.
why-similar-levels = De P₁ a P₂ o segmento passa por todos os níveis entre esses dois valores.
why-similar-parallel = O segmento inteiro está em um mesmo nível: é paralelo ao plano e não há t.
why-similar-piece = Todos os triângulos entre dois níveis têm os mesmos ângulos, então uma mudança de 1 ocupa em toda parte o mesmo pedaço do segmento.
why-similar-t = O plano é o nível 0. De P₁ até o plano o valor muda em −d₁, e no caminho todo, em d₂ − d₁.
why-code-d1 = d₁ ← n·P₁ + D;  d₂ ← n·P₂ + D
why-words-d1 = Ache o nível de cada extremo.
why-code-levels = níveis ← d₂ − d₁
why-words-levels = Conte os níveis de um extremo ao outro.
why-code-piece = pedaço ← 1 / níveis
why-words-piece = Cada nível ocupa o mesmo pedaço do segmento.
why-code-t = t ← −d₁ · pedaço = d₁ / (d₁ − d₂)
why-words-t = De P₁ até o plano há −d₁ níveis.

## n·(P − p₀) como sombra

why-view-above = Visto de cima
why-view-side = Visto de lado
why-view-front = Visto de frente
why-shadow = Por quê: d = n·(P − p₀)
why-shadow-opening = Vá de p₀, um ponto do plano { $plane }, até P em passos ao longo dos eixos. A luz corre ao longo do plano.
why-shadow-piece = O passo ao longo de { $axis } projeta a própria sombra sobre n: tão longa quanto o passo vezes esta componente de n.
why-shadow-sum = Postas uma após a outra, as sombras dos passos são a sombra do caminho inteiro P − p₀.
why-shadow-distance = A sombra e a perpendicular são lados opostos de um retângulo, então a sombra é a distância d de P ao plano { $plane }.
why-shadow-elsewhere = A partir de p₀ = { $other } cada sombra é outra, e a soma é a mesma.
why-code-steps = para cada eixo: passo ← P − p₀
why-words-steps = Vá de um ponto do plano até P, eixo por eixo.
why-code-shadow = sombra ← passo · componente de n
why-words-shadow = Cada passo projeta uma sombra sobre a normal.
why-code-sum = n·(P − p₀) ← soma das sombras
why-words-sum = As sombras se somam.
why-code-rectangle = d ← n·(P − p₀) = n·P + D
why-words-rectangle = A perpendicular é tão longa quanto a sombra, seja qual for o ponto p₀.
