### What the frustum lab says: planes, spheres, boxes, faces, the funnel, and what goes wrong in it.

## Sides of the view volume beyond those of a window

plane-near = próximo
plane-far = distante
plane-left = esquerdo
plane-right = direito
plane-bottom = inferior
plane-top = superior

## Views

view-observer = Observador
view-camera = Câmera
view-observer-frozen = Observador: o descarte está congelado
view-camera-flying = Câmera que voa
camera-that-culls = congelada: descarta
camera-that-flies = voa
gauge-outside = fora
gauge-inside = dentro
gauge-away = de costas
gauge-faces-camera = de frente
gauge-drawn = desenhada
gauge-culled = descartada
gauges-sphere = Uma esfera, { $planes } planos
gauges-faces = Faces: { $faces }, por n·e
planes-from-matrix = Tirados das linhas da matriz, são os mesmos, com { $decimals } casas decimais.
plane-from-matrix = Das linhas da matriz: { $sum }. Dividido pelo comprimento da normal, { $length }, é o plano { $plane }, com { $decimals } casas decimais.
column-plane = plano
column-outside = fora
column-vertex = vértice
column-code = código
column-beyond = além de
no-side = nenhum lado em comum
codes-left = Vértices dentro: { $inside } de 3. Triângulos que sobram dele: { $pieces }.
column-least = mínimo
column-most = máximo

## What can be taken hold of

handle-camera = Posição da câmera
handle-target = Ponto para onde a câmera olha
handle-near = Plano próximo
handle-far = Plano distante
handle-top = Abertura da câmera
handle-point = Ponto P
handle-space-end = Extremo P{ $number }
handle-space-corner = Vértice V{ $number }
handle-object = Objeto { $number }
handle-object-corner = Objeto { $number }, vértice { $corner }

## Methods

alg-point-planes = Ponto contra planos
alg-sphere-cull = Esfera envolvente
alg-box-cull = Caixa envolvente
alg-back-face = Faces traseiras
alg-funnel = Funil de descarte
alg-faulty-one-angle = Errado: um só ângulo para os dois eixos
alg-faulty-turned-sign = Errado: sinal invertido
alg-faulty-around-origin = Errado: a esfera fica em torno da origem
alg-faulty-winding = Errado: vértices em sentido horário
alg-faulty-constant-view = Errado: uma só direção de visão

## A point

point-opening = P está do lado de dentro { $planes ->
        [one] de { $planes } plano
       *[other] dos { $planes } planos
    }?
point-inside = P está do lado de dentro do plano { $plane }.
point-on = P está no plano { $plane }, o que conta como dentro.
point-outside = P está do lado de fora do plano { $plane }.
point-done-inside = Nenhum dos { $planes } planos deixa P fora: está no volume.
point-done-outside = P está fora de { $outside } dos { $planes } planos: não está no volume.
code-plane-each = para cada plano (n, D):
code-point-distance = d ← n·P + D
code-point-outside = se d < 0: fora
code-point-inside = dentro se nenhum plano diz fora
words-plane-each = Pergunte a cada plano; sua normal aponta para dentro.
words-point-distance = O produto escalar da normal e do ponto, mais D, é a distância com sinal.
words-point-outside = Negativa: do lado de fora. Zero: no plano, e conta como dentro.
words-point-inside = O que nenhum plano deixa fora está no volume.

## A bounding sphere

sphere-opening = Uma esfera em torno de todos os vértices responde pelo objeto: { $planes ->
        [one] { $planes } plano
       *[other] { $planes } planos
    }.
sphere-inside = A esfera está do lado de dentro do plano { $plane }.
sphere-straddles = A esfera cruza o plano { $plane }.
sphere-outside = A esfera está do lado de fora do plano { $plane }: descartada inteira.
sphere-done-inside = Está dentro dos { $planes } planos: nenhum triângulo precisa de teste.
sphere-done-straddles = Cruza { $cut } de { $planes } planos: seus triângulos são testados.
planes-done-outside = O plano { $plane } a rejeita após { $planes ->
        [one] { $planes } teste
       *[other] { $planes } testes
    }: nada é desenhado.
code-sphere-distance = d ← n·c + D
code-sphere-outside = se d < −r: descartar
code-sphere-straddles = se d < r: cruza
code-sphere-done = dentro se nenhum cruza
words-sphere-distance = A distância com sinal do centro ao plano.
words-sphere-outside = Mais para fora que o raio: ela está toda do lado de fora.
words-sphere-straddles = Mais perto que o raio: o plano corta a esfera.
words-sphere-done = Dentro de todos os planos não há mais o que perguntar.
class-inside = dentro
class-straddles = cruza
class-outside = fora
watch-class = classe
watch-object = objeto

## A bounding box

box-opening = Uma caixa em torno de todos os vértices responde pelo objeto: { $planes } planos, oito cantos cada um.
box-inside = Os oito cantos estão do lado de dentro do plano { $plane } ({ $outside } fora).
box-straddles = { $outside ->
        [1] { $outside } de 8 cantos está
       *[other] { $outside } de 8 cantos estão
    } do lado de fora do plano { $plane }: a caixa o cruza.
box-outside = Os { $outside } cantos estão do lado de fora do plano { $plane }: descartada inteira.
box-meets = Cruza { $cut ->
        [one] { $cut } plano
       *[other] { $cut } planos
    }, e algo dela está dentro de todos.
box-in-vain = Cruza { $cut ->
        [one] { $cut } plano
       *[other] { $cut } planos
    } e, mesmo assim, nada dela está dentro de todos.
box-done-inside = Está dentro dos { $planes } planos.
box-done-straddles = Nenhum dos { $planes } planos a rejeita: seus triângulos são testados.
box-done-in-vain = Os { $planes } planos a mantêm e ela seria desenhada em vão: é conservador, não errado.
box-note-in-vain = Desenhados mesmo assim, seus { $triangles } triângulos custam tempo. Nenhum pixel muda: a imagem está certa.
option-box-inside = Os oito cantos estão do lado de dentro do plano { $plane }.
option-box-straddles = Só alguns cantos estão do lado de dentro do plano { $plane }: a caixa o cruza.
option-box-outside = Os oito cantos estão do lado de fora do plano { $plane }: a caixa é descartada.
code-box-corners = contar cantos com n·p + D < 0
code-box-outside = se os oito: descartar
code-box-meets = há um ponto dentro de todos?
code-box-done = manter, ou desenhar em vão
words-box-corners = Só contam os sinais dos oito cantos.
words-box-outside = Os oito do lado de fora de um mesmo plano: nada dela pode ser visto.
words-box-meets = Um segundo teste acha as caixas que cruzam planos e mesmo assim estão fora.
words-box-done = Os planos nunca rejeitam o que é visível; podem manter o que não é visível.

## A face

face-of-object = { $face } do objeto { $object }
face-opening = A face { $face } mostra sua frente à câmera?
face-normal = Vista de fora, a face { $face } é percorrida no sentido anti-horário: sua normal aponta para fora.
face-to-eye = De V₀ da face { $face } até a câmera: e = olho − V₀.
face-to-direction = Paralela: para a face { $face }, como para todas, e volta pela linha de visão.
face-products = Face { $face }: o produto escalar e, como determinante, o mesmo número.
face-front = A face { $face } está de frente para a câmera: desenhada.
face-back = A face { $face } está de costas para a câmera: descartada.
face-edge-on = A face { $face } está de perfil: nada se vê, descartada.
code-face-normal = n ← (V₁ − V₀) × (V₂ − V₀)
code-face-viewer = e ← olho − V₀
code-face-product = n·e = |e, V₁ − V₀, V₂ − V₀|
code-face-decide = frente se n·e > 0; senão, descartar
words-face-normal = O produto vetorial de duas arestas é perpendicular à face.
words-face-viewer = Em perspectiva a direção ao olho muda de face para face.
words-face-product = O sinal diz de que lado da face está o olho.
words-face-decide = Em um sólido fechado, as faces da frente escondem as traseiras.

## The funnel

level-so-far = até agora
level-scene = na cena
level-spheres = após as esferas
level-vertices = após os vértices
level-cuts = após os cortes
level-facing = de frente para a câmera
level-counts = { $triangles ->
        [1] { $triangles } triângulo
       *[other] { $triangles } triângulos
    } · { $objects ->
        [1] { $objects } objeto
       *[other] { $objects } objetos
    }
funnel-opening = { $objects ->
        [one] { $objects } objeto
       *[other] { $objects } objetos
    } com { $triangles ->
        [one] { $triangles } triângulo
       *[other] { $triangles } triângulos
    }: quais é preciso desenhar?
funnel-object = Objeto { $object }: { $triangles ->
        [one] { $triangles } triângulo
       *[other] { $triangles } triângulos
    } em uma esfera.
funnel-sphere-inside = O objeto { $object } está dentro: seus { $triangles } triângulos não precisam de recorte.
funnel-sphere-straddles = O objeto { $object } cruza a borda: seus { $triangles } triângulos são testados um a um.
funnel-sphere-outside = O objeto { $object } é descartado inteiro: { $triangles } triângulos poupados.
funnel-triangle-inside = Triângulo { $triangle }: { $inside } de 3 vértices dentro, mantido inteiro.
funnel-triangle-outside = Triângulo { $triangle }: todos os vértices além de um lado ({ $inside } dentro), descartado.
funnel-triangle-cut = Triângulo { $triangle }: { $inside } de 3 vértices dentro, recortado em { $pieces ->
        [one] { $pieces } triângulo
       *[other] { $pieces } triângulos
    }.
funnel-triangle-across = Triângulo { $triangle }: { $inside ->
        [one] { $inside } vértice
       *[other] { $inside } vértices
    } dentro e, mesmo assim, visível: { $pieces ->
        [one] { $pieces } triângulo
       *[other] { $pieces } triângulos
    }.
funnel-triangle-nothing = Triângulo { $triangle }: { $inside } vértices dentro, e o recorte deixa { $pieces } pedaços.
option-triangle-inside = O triângulo { $triangle } está dentro e é mantido inteiro.
option-triangle-outside = O triângulo { $triangle } fica além de um lado e é descartado.
option-triangle-clipped = O triângulo { $triangle } vai para o recorte.
funnel-face-front = O triângulo { $triangle } do objeto { $object } está de frente para a câmera: desenhado.
funnel-face-back = O triângulo { $triangle } do objeto { $object } está de costas: descartado.
funnel-face-edge-on = O triângulo { $triangle } do objeto { $object } está de perfil: descartado.
funnel-done = Restam a desenhar { $facing ->
        [one] { $facing } triângulo
       *[other] { $facing } triângulos
    } de { $kept ->
        [one] { $kept } objeto
       *[other] { $kept } objetos
    }, de { $triangles ->
        [one] { $triangles } triângulo
       *[other] { $triangles } triângulos
    } de { $objects }.
code-funnel-each = para cada objeto:
code-funnel-sphere = c, r ← esfera envolvente
code-funnel-plane = para cada plano: d ← n·c + D
code-funnel-cull = se d < −r: descartar o objeto
code-funnel-straddles = se algum d < r: para cada triângulo:
code-funnel-triangle = códigos: descartar, manter ou recortar
code-funnel-face = descartar triângulos com n·e ≤ 0
code-funnel-draw = desenhar o que resta
words-funnel-each = Primeiro objetos inteiros: um teste pode poupar todos os triângulos.
words-funnel-sphere = Em torno da média dos vértices, até o mais distante.
words-funnel-plane = Pergunte aos seis planos a distância do centro.
words-funnel-cull = Mais para fora que o raio: deixe o objeto de fora.
words-funnel-straddles = Só o que cruza desce de nível.
words-funnel-triangle = Vértices além de um mesmo lado: descartar; nenhum fora: manter; senão, recortar.
words-funnel-face = O que está de costas para a câmera fica escondido pelo que está de frente para ela.
words-funnel-draw = Cada nível tirou o que o anterior podia decidir.

## Mistakes

faulty-one-angle-differs = O passo { $step } é o primeiro que difere: o ângulo de baixo para cima foi usado também da esquerda para a direita.
faulty-turned-sign-differs = O passo { $step } é o primeiro que difere: o lado de dentro do plano foi tomado pelo de fora.
faulty-around-origin-differs = O passo { $step } é o primeiro que difere: a esfera fica em torno da origem do modelo, não do centroide.
faulty-winding-differs = O passo { $step } é o primeiro que difere: os vértices foram tomados em sentido horário e a normal aponta para dentro.
faulty-constant-view-differs = O passo { $step } é o primeiro que difere: uma só direção de visão foi usada para todas as faces.
code-faulty-one-angle = planos com um só ângulo: d ← n·c + D
words-faulty-one-angle = Planos laterais tão abertos quanto os de baixo e de cima.
code-faulty-turned-sign = se d > r: descartar o objeto
words-faulty-turned-sign = Deixa-se de fora o que está do lado da normal.
code-faulty-around-origin = c, r ← origem, raio em relação ao centroide
words-faulty-around-origin = Em torno da origem do modelo, com o raio medido a partir do centroide.
code-faulty-winding = n ← (V₂ − V₀) × (V₁ − V₀)
words-faulty-winding = A normal de vértices em sentido horário.
code-faulty-constant-view = descartar triângulos com n·v ≥ 0, v constante
words-faulty-constant-view = Uma só direção de visão para todas as faces.

## Menu

camera-title = Câmera
camera-position = Posição
camera-target = Olha para
camera-up = Para cima
camera-sight = Projeção
camera-perspective = Perspectiva
camera-parallel = Paralela
camera-fov = Campo de visão
camera-height = Altura
camera-aspect = Razão de aspecto
camera-near = Plano próximo
camera-far = Plano distante
camera-frozen = Congelar o descarte
camera-frozen-about = Continuar descartando com a câmera como está agora e voar em torno do que ela manteve
object-add = Adicionar um objeto
object-remove = Remover o objeto em foco
object-focus = Objeto
object-face = Face
object-number = Número
object-place = Lugar
object-turn = Giro
object-size = Tamanho
section-point = Ponto
section-segment = Segmento
section-triangle = Triângulo
solid-cube = Cubo
solid-tetrahedron = Tetraedro
solid-octahedron = Octaedro
solid-sphere = Esfera
solid-torus = Toro
solid-angle = Bloco em L
solid-spot = A vaca Spot
street-title = Rua de caixas
street-count = Caixas
street-make = Construir a rua

## O veredito

verdict-culled = O plano { $plane } descarta o objeto { $object }: d = { $distance } < −r, r = { $radius }. { $move } mais para dentro e nenhum plano o rejeitaria.
verdict-culled-for-good = O plano { $plane } descarta o objeto { $object }: d = { $distance } < −r, r = { $radius }. Nenhum deslocamento pela normal desse plano o faria entrar.
verdict-straddles = O objeto { $object } cruza a borda: o mais próximo é o plano { $plane }, d = { $distance } < r = { $radius }. { $move } mais para fora e seria descartado.
verdict-inside = O objeto { $object } está dentro: o mais próximo é o plano { $plane }, d = { $distance } ≥ r = { $radius }. { $move } mais para fora e seria descartado.
verdict-face-in = Deslocado { $move } pela normal do plano { $plane }, seus vértices já não estariam todos além de um mesmo plano.
verdict-face-never = Nenhum deslocamento pela normal do plano { $plane } mudaria isso.
verdict-face-cut = Nada dele está dentro de todos os planos ao mesmo tempo: deslocá-lo pela normal de um plano não diz nada.
verdict-face-turn-to = Girada { $angle }° em torno de V₀, diretamente para o observador, começaria a mostrar sua frente.
verdict-face-turn-away = Girada { $angle }° em torno de V₀, afastando-se do observador, ficaria de perfil e seria descartada.
verdict-face-no-normal = Não tem normal: nenhum giro mostraria sua frente.
part-segment = o segmento
part-corner = o vértice { $vertex }
part-edge = a aresta { $from }{ $to }
verdict-part-kept = Nenhum plano tira nada: fica { $part } por inteiro.
verdict-part-cut = O plano { $plane } é o primeiro que corta { $part }; resta uma parte.
verdict-part-lost = Quem decide é o plano { $plane }: { $part } se perde por inteiro.
verdict-part-in = Com um deslocamento de { $move } para dentro, perpendicular ao plano { $plane }, não se perderia.
verdict-part-back = Com um deslocamento de { $move } para fora, perpendicular ao plano { $plane }, não se perderia.
verdict-part-never = Nenhum deslocamento perpendicular ao plano { $plane } mudaria isso.
verdict-part-out = Com um deslocamento para fora de mais de { $move }, perpendicular ao plano { $plane }, não restaria nada.
verdict-part-touch = Só toca o plano { $plane }: com o menor deslocamento para fora não restaria nada.
verdict-crossing-out = A aresta tem aqui um corte porque seus extremos estão em lados diferentes do plano { $plane }: d = { $inner } e d = { $outer }. Com esse plano { $move } mais para fora não haveria corte.
verdict-crossing-in = A aresta tem aqui um corte porque seus extremos estão em lados diferentes do plano { $plane }: d = { $inner } e d = { $outer }. Com esse plano mais de { $move } para dentro não haveria corte.

## What culling costs, measured

culling-title = Quanto custa o descarte
culling-about = Pergunta-se a cada objeto e depois se desenha o que resta: de cada modo a mesma imagem, aqui e agora.
culling-objects = Objetos
culling-own = Os desta cena
culling-nothing = Sem descartar nada
culling-rough = Por esferas envolventes
culling-exact = Por todos os triângulos
culling-row = { $way }: { $cull } ms para descartar + { $draw } ms para desenhar; objetos restantes: { $objects }, triângulos: { $triangles }
culling-inequality = Descartar de forma aproximada ou exata: { $rough-cull } { $cull-relation } { $exact-cull } ms. Desenhar o que resta: { $rough-draw } { $draw-relation } { $exact-draw } ms.
culling-axis-objects = Objetos (caixas em uma rua)
culling-axis-millis = Milissegundos
culling-best-always = O mais rápido em todas as quantidades medidas: { $way }.
culling-best-changes = O mais rápido no início: { $first }. A partir de { $many } objetos: { $last } (com { $few } ainda não).
culling-note = A mais rápida de cinco passagens, em 320 × 200 pixels; as esferas são testadas muitas de uma vez. Os tempos são desta máquina e deste momento: as figuras exportadas mostram contagens.

## A pixel of the camera's picture

pixel-seen = O pixel { $at } mostra a face { $face } do objeto { $object }: { $count ->
    [one] a única que há ali, a esta profundidade.
   *[other] a mais próxima de { $count }. Sua profundidade e a da seguinte:
  }
pixel-empty = Nenhuma face cobre o pixel { $at }.
pixel-other = { $count ->
    [1] Um pixel
   *[other] { $count } pixels
  } { $direction } vê-se a face { $face } do objeto { $object }.
pixel-other-nothing = { $count ->
    [1] Um pixel
   *[other] { $count } pixels
  } { $direction } não se vê nada.
pixel-shows = Neste passo, o pixel { $at } mostra a face { $face } do objeto { $object }.
pixel-shows-nothing = Neste passo, o pixel { $at } não mostra nada.
pixel-truth = A mais próxima ali é a face { $face } do objeto { $object }.
pixel-truth-nothing = Nenhuma face o cobre.
pixel-alone = Só este pixel
pixel-all = Todos os pixels
pixel-right = à direita
pixel-left = à esquerda
pixel-down = para baixo
pixel-up = para cima
