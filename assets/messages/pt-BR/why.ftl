### Provas por desenho: de onde vêm as fórmulas.

## Vistas

why-view-section = Ao longo do plano, comprimentos reais

## t por triângulos semelhantes

why-similar = Por quê: t = d₁ / (d₁ − d₂)
why-similar-opening = Que parte t do caminho de P₁ a P₂ é preciso percorrer até o plano { $plane }?
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
why-shadow-opening = Vá de p₀, um ponto do plano { $plane }, até P em passos ao longo dos eixos. A luz chega paralela ao plano.
why-shadow-piece = O passo ao longo de { $axis } projeta sua própria sombra sobre n, tão longa quanto o passo vezes esta componente de n.
why-shadow-sum = Postas uma após a outra, as sombras dos passos são a sombra do caminho inteiro P − p₀.
why-shadow-distance = A sombra e a perpendicular são lados opostos de um retângulo, então a sombra é a distância d de P ao plano { $plane }.
why-shadow-elsewhere = A partir de p₀ = { $other } cada sombra é outra, mas a soma é a mesma.
why-code-steps = para cada eixo: passo ← P − p₀
why-words-steps = Vá de um ponto do plano até P, eixo por eixo.
why-code-shadow = sombra ← passo · componente de n
why-words-shadow = Cada passo projeta uma sombra sobre a normal.
why-code-sum = n·(P − p₀) ← soma das sombras
why-words-sum = As sombras se somam.
why-code-rectangle = d ← n·(P − p₀) = n·P + D
why-words-rectangle = A perpendicular é tão longa quanto a sombra, seja qual for o ponto p₀.

## Faixas: por que p < 0 é “entra”

why-view-strips = x e y em função de u, cada uma com sua faixa da janela
why-in = entra
why-out = sai
why-strips = Por quê: p < 0 é “entra” e p > 0 é “sai”
why-strips-opening = Em função de u, as duas coordenadas são retas, e a janela é uma faixa para cada uma.
why-strips-in = A reta entra na sua faixa pela { $edge }.
why-strips-out = A reta sai da sua faixa pela { $edge }.
why-strips-level = A reta é horizontal e fica sempre do lado de dentro da { $edge }.
why-strips-beyond = A reta é horizontal e fica sempre além da { $edge }: nenhuma parte é visível.
why-strips-from = As duas faixas contêm a reta só depois da última entrada.
why-strips-empty = A primeira saída vem antes da última entrada: não há u em que as duas faixas contenham a reta.
why-strips-to = Da última entrada à primeira saída, as duas faixas contêm a reta.
why-code-strip = para cada borda de uma faixa:
why-words-strip = Esquerda e direita limitam a faixa de x; embaixo e em cima, a de y.
why-code-in = se p < 0: entra em u = q / p
why-words-in = Uma reta que sobe entra por baixo; uma que desce, por cima.
why-code-out = se p > 0: sai em u = q / p
why-words-out = Pela outra borda da faixa ela sai.
why-code-level = se p = 0: sempre dentro, ou nunca
why-words-level = Uma reta horizontal não cruza nenhuma borda da sua faixa.
why-code-both = u_min ← última entrada;  u_max ← primeira saída
why-words-both = É visível o que as duas faixas contêm.

## A linha 3 da projeção

why-view-depth = z′ em função da profundidade, entre −w e w
why-projection-row = Por quê: a linha 3 da projeção
why-row-opening = A linha 3 dá z′ = a · profundidade + b. Que a e b põem as profundidades de { $near } a { $far } entre −w e w?
why-row-near = O plano próximo, à profundidade { $near }, tem de ficar na borda inferior.
why-row-far = O plano distante, à profundidade { $far }, tem de ficar na borda superior.
why-row-slope = Só uma reta passa pelos dois pontos. Ela sobe { $climb } em { $way }: isso é a.
why-row-start = Prolongada para trás até a profundidade 0, a reta começa em b.
why-row-point = P está à profundidade { $depth }; a reta dá o seu z′.
why-row-divided = Em uma reta que parte de 0, o quociente z′ / w é igual em todos os pontos: ele é lido na régua do plano distante.
why-row-middle = A primeira metade do intervalo, de −1 a 0, é ocupada pelas profundidades de { $near } a { $middle }.
why-code-near-far = próximo ↦ z′ = −w;  distante ↦ z′ = w
why-words-near-far = Duas condições: cada plano vai para a sua borda.
why-code-slope = a ← (w_distante + w_próximo) / (distante − próximo)
why-words-slope = Dois pontos fixam uma reta, e com ela a inclinação.
why-code-start = b ← −w_próximo − a · próximo
why-words-start = Onde a reta começa, à profundidade 0.
why-code-row = z′ ← a · profundidade + b = −a · z + b
why-words-row = A profundidade é −z, então a linha 3 é 0 0 −a b.
why-code-divide = z′ / w
why-words-divide = Depois da divisão, as profundidades perto do plano distante se apertam.

## n·e > 0

why-view-bar = Cada face de perfil, com a normal para cima
why-facing = Por quê: com n·e > 0, a face está de frente para o olho
why-facing-opening = A face { $face } é posta sobre uma barra, com a normal para cima. O olho está acima ou abaixo da barra?
why-facing-product = n·e é o comprimento de n vezes a sombra de e sobre n.
why-facing-length = O comprimento de n é positivo, então não muda o sinal.
why-facing-no-length = Esta face não tem área, então não tem normal nem lado para mostrar.
why-facing-above = A sombra de e é a altura do olho acima do plano da face { $face }: o olho a vê de frente.
why-facing-below = A sombra de e aponta para o outro lado: o olho não está acima do plano da face { $face }, então não a vê de frente.
why-facing-other-above = A face { $face }, posta sobre a mesma barra, tem o olho acima dela.
why-facing-other-below = A face { $face }, posta sobre a mesma barra, não tem o olho acima dela.
why-facing-fronts = De { $faces } faces sobre a barra, o olho fica acima de { $fronts }: essas mostram a frente, e o n·e delas é positivo.
why-code-product = n·e = |n| · sombra de e sobre n
why-words-product = Um produto escalar é um comprimento vezes uma sombra.
why-code-height = altura ← n·e / |n|
why-words-height = A que altura o olho está acima do plano da face.
why-code-bar = para cada outra face: a mesma barra
why-words-bar = Vista de perfil, cada face é uma barra.
why-code-front = da frente ⇔ altura > 0 ⇔ n·e > 0
why-words-front = O sinal, por si só, já diz de que lado está o olho.
