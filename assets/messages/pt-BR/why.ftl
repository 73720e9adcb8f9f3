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
why-row-slope = Só uma reta passa pelos dois pontos. De um ao outro, z′ aumenta { $climb } e a profundidade, { $way }: o quociente é o valor de a.
why-row-start = Prolongada para trás até a profundidade 0, a reta começa em b.
why-row-point = P está à profundidade { $depth }; a reta dá o seu z′.
why-row-divided = Em uma reta que parte de 0, o quociente z′ / w é igual em todos os pontos: ele é lido na régua do plano distante.
why-row-middle = Cada um de { $steps } passos iguais de profundidade é lido na régua, por sua própria reta a partir de 0. A primeira metade, de −1 a 0, é ocupada pelas profundidades de { $near } a { $middle }.
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
why-facing-opening = A barra é a face { $face }, vista de perfil, com a normal para cima. O olho está acima ou abaixo da barra?
why-facing-product = n·e é o comprimento de n vezes a sombra do vetor e sobre n.
why-facing-length = O comprimento de n é positivo, então não muda o sinal.
why-facing-no-length = Esta face não tem área, então não tem normal nem lado para mostrar.
why-facing-above = A sombra do vetor e é a altura do olho acima do plano da face { $face }: o olho a vê de frente.
why-facing-below = A sombra do vetor e aponta para o outro lado: o olho não está acima do plano da face { $face }, então não a vê de frente.
why-facing-other-above = Para a face { $face }, o olho está acima da barra.
why-facing-other-below = Para a face { $face }, o olho não está acima da barra.
why-facing-fronts = { $fronts ->
    [1] O olho está acima da barra para { $fronts } de { $faces } faces: essa mostra a frente, e o n·e dela é positivo.
   *[other] O olho está acima da barra para { $fronts } de { $faces } faces: essas mostram a frente, e o n·e delas é positivo.
}
why-code-product = n·e = |n| · sombra de e sobre n
why-words-product = Um produto escalar é um comprimento vezes uma sombra.
why-code-height = altura ← n·e / |n|
why-words-height = A que altura o olho está acima do plano da face.
why-code-bar = para cada outra face: a mesma barra
why-words-bar = Vista de perfil, cada face é uma barra.
why-code-front = da frente ⇔ altura > 0 ⇔ n·e > 0
why-words-front = O sinal, por si só, já diz de que lado está o olho.
why-depth = profundidade
why-quarter-turn = Por quê: a normal de um plano lateral
why-mirrored = n do plano esquerdo
why-turn-opening = Visto de cima, o plano direito é uma reta pelo olho. Procura-se a sua normal e depois a distância de P.
why-turn-tangent = A cada unidade para a frente o plano se afasta isto para o lado: a tangente da metade do ângulo de visão, α.
why-turn-across = Uma unidade ao longo do plano avança isto para o lado: o seno de α.
why-turn-ahead = A mesma unidade avança isto para a frente: o cosseno de α.
why-turn-turned-across = O triângulo gira 90° para dentro. O cateto que ia para a frente agora vai para o lado, à esquerda.
why-turn-turned-ahead = O cateto que ia para o lado agora vai para a frente. Para a frente é −z, então a normal é (−cos α; 0; −sen α).
why-turn-distance = O comprimento de n continua 1, então n·P é a distância de P ao plano direito.
why-code-tangent = tan α ← aspecto · tan (ângulo / 2)
why-words-tangent = A metade do ângulo de visão diz quanto o plano se abre.
why-code-unit = uma unidade ao longo do plano: (sen α; cos α)
why-words-unit = Uma unidade tem dois catetos, um para o lado e um para a frente.
why-code-turn = girada 90°: (−cos α; sen α)
why-words-turn = Os catetos trocam de lugar, e um troca de sinal.
why-code-check = d ← n·P + D
why-words-check = Um giro conserva os comprimentos, então n mede 1.
why-view-screen = Na tela: postes de altura 1
why-fence = Por quê: 1 / profundidade é linear
why-fence-opening = Ao longo de uma aresta da cena há uma cerca de postes de altura 1. Onde passos iguais na tela a encontram?
why-fence-nothing = Uma câmera em perspectiva não vê nenhuma aresta de lado: não há cerca para dividir em { $steps } passos.
why-fence-first = O primeiro poste está à profundidade { $depth }.
why-fence-last = O último poste está à profundidade { $depth }.
why-fence-post = O passo { $post } na tela é tão largo quanto os outros; a sua linha de visão encontra a cerca à profundidade { $depth }, depois de { $before }.
why-fence-height = Na tela um poste de altura 1 mede 1 / profundidade.
why-fence-drop = O alto da cerca é reto no espaço, então também é reto na tela, do primeiro poste ao último.
why-fence-step = Sob uma reta, passos iguais tiram quantidades iguais: cada passo na tela tira isto de 1 / profundidade.
why-code-ends = profundidade do primeiro e do último poste
why-words-ends = A cerca está entre dois vértices.
why-code-posts = para cada passo igual na tela: profundidade da cerca
why-words-posts = Passos iguais na tela são passos desiguais na cerca.
why-code-post = altura na tela ← 1 / profundidade
why-words-post = O que está ao dobro da profundidade parece ter metade da altura.
why-code-top = alto reto: 1 / profundidade muda de modo uniforme
why-words-top = Uma reta parece reta.
why-error-term = Por quê: o e de Bresenham
why-view-columns = As primeiras colunas, ampliadas
why-error-opening = Em cada coluna a reta se afasta b / a de pixel; o ponto médio entre dois pixels está a 1/2. O que fica mais longe?
why-error-parts = Meça os dois com uma mesma régua que tem 2a partes por pixel.
why-error-one-pixel = A reta começa e acaba no mesmo pixel: não há nada para escolher.
why-error-line = Então a reta se afasta um número inteiro de partes em cada coluna.
why-error-midpoint = O ponto médio também está a um número inteiro de partes.
why-error-beyond = Coluna { $column }: a reta passa do ponto médio, então se toma o pixel da fileira seguinte, e o ponto médio avança um pixel.
why-error-short = Coluna { $column }: a reta não passa do ponto médio, então se toma o pixel em frente.
why-code-parts = um pixel = 2a partes
why-words-parts = Divida cada pixel tão fino que não sobrem frações.
why-code-both-whole = reta: 2b em cada coluna;  ponto médio: a
why-words-both-whole = Os dois são então números inteiros.
why-code-columns = para cada coluna:
why-words-columns = Vá de coluna em coluna.
why-code-error = e ← reta − ponto médio
why-words-error = O sinal de e diz de que lado do ponto médio a reta está.
why-view-sight = Distância ao plano ao longo de duas linhas de visão
why-crosses-once = Por quê: o lado distante não esconde nada
why-bend = teria de se dobrar
why-once = uma vez
why-once-opening = Algo do lado distante do plano de um triângulo pode esconder algo do lado do olho?
why-once-no-sides = O olho está no plano de { $plane }: nenhum lado é o do olho.
why-once-eye = O olho está de um lado do plano de { $plane }, a esta distância.
why-once-own = Q, o centro de { $own }, está do mesmo lado.
why-once-least = No caminho até Q a distância muda de modo uniforme e nunca é 0: o que esconde Q está do lado de { $plane } em que está o olho.
why-once-other = R, o centro de { $other }, está do outro lado.
why-once-crossing = No caminho até R a distância é 0 uma vez: antes desse lugar o lado próximo pode esconder R; depois, o distante.
why-code-eye = E: d(E) > 0
why-words-eye = O lado do olho é o positivo.
why-code-own = d(Q) > 0: d > 0 no caminho todo
why-words-own = Entre dois valores positivos não há nenhum 0 em uma reta.
why-code-other = d(R) < 0: d = 0 uma vez
why-words-other = Uma reta encontra um plano uma só vez.
why-code-order = desenhar: lado distante, o triângulo, lado do olho
why-words-order = O que fica escondido é desenhado primeiro.
why-bridge = Por quê: uma ponte não tem área
why-edge = aresta
why-width = largura
why-height = altura
why-strip = faixa
why-sum = soma
why-bridge-opening = Cada aresta do anel tem uma faixa, da borda esquerda até a aresta: ela é somada se a aresta sobe e tirada se desce.
why-bridge-up = { $edge } sobe, então a sua faixa é somada.
why-bridge-down = { $edge } desce, então a sua faixa é tirada.
why-bridge-none = { $edge } não tem faixa: é horizontal ou fica onde as faixas começam.
why-bridge-back = { $edge } volta por cima de { $other }: é uma ponte. Ali a mesma faixa é somada uma vez e tirada uma vez.
why-bridge-area = Todas as faixas juntas deixam { $area }: a área do anel, sem nada para a ponte.
why-bridge-elsewhere = Se as faixas começam na borda direita, cada uma é outra, e a soma é a mesma.
why-code-edges = para cada aresta do anel:
why-words-edges = Percorra o anel uma vez.
why-code-swept = faixa ← largura média · altura
why-words-swept = Uma aresta que desce tem altura negativa.
why-code-area = área ← soma das faixas
why-words-area = O que se percorre de ida e volta se anula.

## Uma interseção como média ponderada

why-mean = Por quê: uma interseção é uma média ponderada
why-triangle = triângulo
why-across = transversal
why-along = ao longo
why-mean-opening = Um segmento cruza a reta de uma borda. Em que lugar, ao longo da borda?
why-mean-nothing = Nenhuma borda tem sua reta entre P₁ e P₂: não há interseção a encontrar.
why-mean-first = P₁ está a esta distância da { $edge }, { $border }.
why-mean-second = P₂ está a esta distância dela, do outro lado.
why-mean-part = Então se chega à { $edge } depois desta parte do caminho na direção transversal.
why-mean-rise = O triângulo até a borda tem os ângulos do triângulo do segmento inteiro: é o mesmo, com t vezes o tamanho. Então também ao longo da borda se fez a parte t do caminho.
why-mean-level = O segmento não se move ao longo da borda: os dois triângulos se achatam em uma linha.
why-mean-mean = No conjunto, o { $along } de cada extremo tem como peso a distância do outro extremo.
why-mean-given = A mesma média da outra coordenada, { $across }, dá a própria borda. Por isso ela é copiada, e não calculada.
why-code-weights = w₁, w₂ ← distâncias de P₁ e P₂ à borda
why-words-weights = Meça a que distância da reta da borda está cada extremo.
why-code-part = t ← w₁ / (w₁ + w₂)
why-words-part = Do caminho na direção transversal, w₁ fica antes da borda.
why-code-rise = X ← P₁ + t · (P₂ − P₁)
why-words-rise = Nas duas direções se fez a mesma parte do caminho.
why-code-mean = X = (w₂ · P₁ + w₁ · P₂) / (w₁ + w₂)
why-words-mean = O extremo mais próximo conta mais.

## O dobro de uma área

why-double-area = Por quê: a₁·b₂ < b₁·a₂ é “à esquerda”
why-area = área
why-left = esquerda
why-right = direita
why-rectangle = retângulo
why-ends = + duas metades
why-half = − metade do total
why-more = mais que a metade
why-area-opening = De que lado da reta de P₁ a um canto está P₂? Meça os dois pontos a partir desse canto.
why-area-nothing = Aqui bastam as regiões de P₁ e P₂: nenhum canto é testado.
why-area-first = As retas que passam por { $corner } dividem o retângulo de P₁ a P₂ em quatro partes. Uma mede |a₁| de largura e |b₂| de altura.
why-area-second = A parte oposta mede |a₂| de largura e |b₁| de altura.
why-area-ends = Vá de P₁ a P₂ passando por { $corner }: este caminho divide ao meio as outras duas partes.
why-area-half = O caminho reto de P₁ a P₂ divide ao meio o retângulo inteiro.
why-area-more = À esquerda do caminho por { $corner } há mais que a metade: sobra o triângulo que fica entre os dois caminhos. À direita falta o mesmo tanto.
why-area-less = À esquerda do caminho por { $corner } há menos que a metade: falta o triângulo que fica entre os dois caminhos. À direita sobra o mesmo tanto.
why-area-none = { $corner } está no caminho reto: não há triângulo, e cada lado é uma metade.
why-area-left = Esquerda menos direita é o dobro do triângulo, com sinal positivo: P₂ está à esquerda da reta de P₁ a { $corner }.
why-area-right = Esquerda menos direita é o dobro do triângulo, com sinal negativo: P₂ está à direita da reta de P₁ a { $corner }.
why-area-through = Esquerda menos direita é 0: P₂ está na reta de P₁ a { $corner }.
why-code-rectangles = retângulos: |a₁·b₂| e |b₁·a₂|
why-words-rectangles = São as duas partes que não tocam nem P₁ nem P₂.
why-code-over = caminho pelo canto: as outras duas, ao meio
why-words-over = Uma diagonal divide um retângulo ao meio.
why-code-straight = caminho reto: as quatro, ao meio
why-words-straight = O retângulo inteiro também tem uma diagonal.
why-code-between = triângulo ← esquerda + duas metades − metade do total
why-words-between = O que fica entre os dois caminhos sobra de um lado e falta do outro.
why-code-twice = b₁·a₂ − a₁·b₂ = esquerda − direita = 2 · triângulo
why-words-twice = O sinal diz o lado: positivo é à esquerda.
