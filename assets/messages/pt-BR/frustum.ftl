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
gauges-sphere = Uma esfera, { $planes ->
        [1] { $planes } plano
       *[other] { $planes } planos
    }
gauges-sphere-of = Objeto { $object }: uma esfera, { $planes ->
        [1] { $planes } plano
       *[other] { $planes } planos
    }
gauges-faces = Faces: { $faces }, por n·e
plane-from-matrix = Sem ângulos: { $sum }. Dividido pelo comprimento da normal, { $length }, é o plano { $plane }, até { $decimals } casas decimais.
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
handle-space-end = { $number ->
    [1] Extremo P₁
   *[other] Extremo P₂
  }
handle-space-corner = Vértice dado { $vertex }
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
alg-faulty-winding = Errado: vértices no sentido horário
alg-faulty-constant-view = Errado: uma só direção de visão

## A point

point-opening = P está do lado de dentro { $planes ->
        [1] de { $planes } plano
       *[other] dos { $planes } planos
    }?
point-inside = P está do lado de dentro do plano { $plane }.
point-on = P está no plano { $plane }, o que conta como dentro.
point-outside = P está do lado de fora do plano { $plane }.
point-answer-inside = Dentro: nenhum plano deixa o ponto fora.
point-answer-outside = Fora: pelo menos um plano deixa o ponto fora.
point-done-inside = P está do lado de dentro { $planes ->
        [1] de { $planes } plano
       *[other] dos { $planes } planos
    }: está no volume.
point-done-outside = P está do lado de fora de { $outside } { $planes ->
        [1] de { $planes } plano
       *[other] dos { $planes } planos
    }: não está no volume.
code-plane-each = para cada plano (n, D):
code-point-distance = d ← n·P + D
code-point-outside = se d < 0: fora
code-point-inside = dentro se nenhum plano o deixa fora
words-plane-each = Teste cada plano por vez; sua normal aponta para dentro.
words-point-distance = O produto escalar da normal e do ponto, mais D, é a distância com sinal.
words-point-outside = Se é negativa, está do lado de fora; se é 0, está no plano e conta como dentro.
words-point-inside = Um ponto que nenhum plano deixa fora está no volume.

## A bounding sphere

sphere-opening = Uma esfera em torno de todos os vértices representa o objeto: { $planes ->
        [1] { $planes } plano
       *[other] { $planes } planos
    }.
sphere-inside = A esfera está do lado de dentro do plano { $plane }.
sphere-straddles = A esfera cruza o plano { $plane }.
sphere-outside = A esfera está do lado de fora do plano { $plane }: o objeto é descartado inteiro.
sphere-done-inside = A esfera está do lado de dentro { $planes ->
        [1] de { $planes } plano
       *[other] dos { $planes } planos
    }: nenhum triângulo precisa de teste.
sphere-done-straddles = A esfera cruza { $cut } { $planes ->
        [1] de { $planes } plano
       *[other] dos { $planes } planos
    }: seus triângulos são testados.
planes-done-outside = O plano { $plane } descarta o objeto após { $planes ->
        [1] { $planes } teste
       *[other] { $planes } testes
    }: nada dele é desenhado.
option-beyond = Fora do plano { $option }
option-within = Dentro de todos os planos
option-across = Fora de nenhum plano, mas não dentro de todos
code-sphere-distance = d ← n·c + D
code-sphere-outside = se d < −r: descarte
code-sphere-straddles = se d < r: cruza o plano
code-sphere-done = dentro se não cruza nenhum
words-sphere-distance = Calcule a distância com sinal do centro ao plano.
words-sphere-outside = O centro está fora a mais de um raio do plano: toda a esfera está do lado de fora.
words-sphere-straddles = O centro está a menos de um raio do plano: o plano corta a esfera.
words-sphere-done = Se a esfera está do lado de dentro de todos os planos, não é preciso testar mais nada.
class-inside = dentro
class-straddles = cruza o plano
class-outside = fora
watch-class = classe
watch-object = objeto

## A bounding box

box-opening = Uma caixa em torno de todos os vértices representa o objeto: { $planes ->
        [1] { $planes } plano, oito vértices.
       *[other] { $planes } planos, oito vértices cada um.
    }
box-inside = Os oito vértices estão do lado de dentro do plano { $plane } ({ $outside } fora).
box-straddles = { $outside ->
        [1] { $outside } de 8 vértices está
       *[other] { $outside } de 8 vértices estão
    } do lado de fora do plano { $plane }: a caixa o cruza.
box-outside = Os { $outside } vértices estão do lado de fora do plano { $plane }: o objeto é descartado inteiro.
box-meets = A caixa cruza { $cut ->
        [1] { $cut } plano
       *[other] { $cut } planos
    }, e uma parte está dentro de todos.
box-in-vain = A caixa cruza { $cut ->
        [1] { $cut } plano
       *[other] { $cut } planos
    } e, mesmo assim, nenhum ponto dela está dentro de todos.
box-done-inside = A caixa está do lado de dentro { $planes ->
        [1] de { $planes } plano.
       *[other] dos { $planes } planos.
    }
box-done-straddles = { $planes ->
        [1] O plano ({ $planes }) não descarta a caixa:
       *[other] Nenhum dos { $planes } planos descarta a caixa:
    } seus triângulos são testados.
box-done-in-vain = Os { $planes } planos mantêm a caixa e ela seria desenhada em vão: é conservador, não errado.
box-note-in-vain = { $triangles ->
        [1] Seu { $triangles } triângulo é desenhado mesmo assim e custa tempo.
       *[other] Seus { $triangles } triângulos são desenhados mesmo assim e custam tempo.
    } Nenhum pixel muda: a imagem está certa.
option-box-inside = Os oito vértices estão do lado de dentro do plano { $plane }.
option-box-straddles = Só alguns vértices estão do lado de dentro do plano { $plane }: a caixa o cruza.
option-box-outside = Os oito vértices estão do lado de fora do plano { $plane }: a caixa é descartada.
code-box-corners = conte vértices com n·p + D < 0
code-box-outside = se os oito: descarte
code-box-meets = há um ponto dentro de todos?
code-box-done = mantenha, ou desenhe em vão
words-box-corners = Só contam os sinais das oito distâncias.
words-box-outside = Se os oito estão do lado de fora de um mesmo plano, nada do objeto pode ser visto.
words-box-meets = Um segundo teste acha as caixas que cruzam planos e mesmo assim estão fora.
words-box-done = Os planos nunca descartam o que é visível; podem manter o que não é visível.

## A face

face-of-object = { $face } do objeto { $object }
face-opening = A face { $face } está de frente para a câmera?
face-normal = Vista de fora, a face { $face } é percorrida no sentido anti-horário: sua normal aponta para fora.
face-to-eye = e = olho − V₀: o vetor que vai de V₀ da face { $face } à câmera.
face-to-direction = Na projeção paralela, para a face { $face } como para todas, o vetor (e) aponta no sentido contrário ao da linha de visão.
face-products = Para a face { $face }, o produto escalar e o determinante são o mesmo número.
face-front = A face { $face } está de frente para a câmera: desenhada.
face-back = A face { $face } está de costas para a câmera: descartada.
face-edge-on = A face { $face } está de perfil: nada se vê, descartada.
code-face-normal = n ← (V₁ − V₀) × (V₂ − V₀)
code-face-viewer = e ← olho − V₀
code-face-product = n·e = |e, V₁ − V₀, V₂ − V₀|
code-face-decide = da frente se n·e > 0; senão, descarte
words-face-normal = O produto vetorial de duas arestas é perpendicular à face.
words-face-viewer = Em perspectiva a direção ao olho muda de face para face.
words-face-product = O sinal de n·e diz de que lado da face está o olho.
words-face-decide = Visto de fora, um sólido fechado esconde com as faces da frente as traseiras.

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
        [1] { $objects } objeto
       *[other] { $objects } objetos
    } com { $triangles ->
        [1] { $triangles } triângulo
       *[other] { $triangles } triângulos
    }: que triângulos é preciso desenhar?
funnel-object = Objeto { $object }: { $triangles ->
        [1] { $triangles } triângulo
       *[other] { $triangles } triângulos
    } em uma esfera.
funnel-sphere-inside = O objeto { $object } está dentro: { $triangles ->
        [1] seu { $triangles } triângulo não precisa
       *[other] seus { $triangles } triângulos não precisam
    } de recorte.
funnel-sphere-straddles = O objeto { $object } cruza algum plano: { $triangles ->
        [1] seu { $triangles } triângulo é testado.
       *[other] seus { $triangles } triângulos são testados um a um.
    }
funnel-sphere-outside = O objeto { $object } é descartado inteiro: { $triangles ->
        [1] poupa-se { $triangles } triângulo.
       *[other] poupam-se { $triangles } triângulos.
    }
funnel-triangle-inside = Triângulo { $triangle }: { $inside } de 3 vértices estão dentro; é mantido inteiro.
funnel-triangle-outside = Triângulo { $triangle }: todos os vértices estão além de um mesmo lado ({ $inside } dentro); é descartado.
funnel-triangle-cut = Triângulo { $triangle }: { $inside } de 3 vértices dentro; o recorte deixa { $pieces ->
        [1] { $pieces } triângulo
       *[other] { $pieces } triângulos
    }.
funnel-triangle-across = Triângulo { $triangle }: { $inside ->
        [1] { $inside } vértice
       *[other] { $inside } vértices
    } dentro e, mesmo assim, uma parte é visível: { $pieces ->
        [1] { $pieces } triângulo
       *[other] { $pieces } triângulos
    }.
funnel-triangle-nothing = Triângulo { $triangle }: { $inside ->
        [1] { $inside } vértice
       *[other] { $inside } vértices
    } dentro, e o recorte deixa { $pieces ->
        [1] { $pieces } peça.
       *[other] { $pieces } peças.
    }
option-triangle-inside = O triângulo { $triangle } está dentro e é mantido inteiro.
option-triangle-outside = O triângulo { $triangle } fica além de um lado e é descartado.
option-triangle-clipped = O triângulo { $triangle } vai para o recorte.
funnel-face-front = O triângulo { $triangle } do objeto { $object } está de frente para a câmera: desenhado.
funnel-face-back = O triângulo { $triangle } do objeto { $object } está de costas para a câmera: descartado.
funnel-face-edge-on = O triângulo { $triangle } do objeto { $object } está de perfil: descartado.
funnel-done = Restam a desenhar { $facing } de { $triangles ->
        [1] { $triangles } triângulo
       *[other] { $triangles } triângulos
    } e { $kept } de { $objects ->
        [1] { $objects } objeto
       *[other] { $objects } objetos
    }.
code-funnel-each = para cada objeto:
code-funnel-sphere = c, r ← esfera envolvente
code-funnel-plane = para cada plano: d ← n·c + D
code-funnel-cull = se d < −r: descarte o objeto
code-funnel-straddles = se algum d < r: para cada triângulo:
code-funnel-triangle = códigos: descarte, mantenha ou recorte
code-funnel-face = descarte triângulos com n·e ≤ 0
code-funnel-draw = desenhe o que resta
words-funnel-each = Teste primeiro objetos inteiros: um teste pode poupar todos os triângulos.
words-funnel-sphere = Seu centro é a média dos vértices; ela chega até o mais distante.
words-funnel-plane = Calcule a distância do centro aos seis planos.
words-funnel-cull = Se o centro está fora a mais de um raio do plano, deixe o objeto de fora.
words-funnel-straddles = Só os objetos que cruzam algum plano passam ao nível seguinte.
words-funnel-triangle = Todos os vértices além de um mesmo lado: descarte; nenhum fora: mantenha; senão, recorte.
words-funnel-face = Os triângulos de costas para a câmera ficam escondidos pelos que estão de frente.
words-funnel-draw = Cada nível tirou o que o seu teste podia decidir.

## Mistakes

faulty-one-angle-differs = O passo { $step } é o primeiro que difere: o ângulo de baixo para cima foi usado também da esquerda para a direita.
faulty-turned-sign-differs = O passo { $step } é o primeiro que difere: o lado de dentro do plano foi tomado pelo de fora.
faulty-around-origin-differs = O passo { $step } é o primeiro que difere: a esfera fica em torno da origem do modelo, não do centroide.
faulty-winding-differs = O passo { $step } é o primeiro que difere: os vértices foram tomados no sentido horário, e assim a normal aponta para dentro.
faulty-constant-view-differs = O passo { $step } é o primeiro que difere: uma só direção de visão foi usada para todas as faces.
code-faulty-one-angle = planos com um só ângulo: d ← n·c + D
words-faulty-one-angle = Os planos laterais se abrem tanto quanto os de baixo e de cima.
code-faulty-turned-sign = se d > r: descarte o objeto
words-faulty-turned-sign = Deixa-se de fora o que está do lado para o qual a normal aponta.
code-faulty-around-origin = c, r ← origem, raio em relação ao centroide
words-faulty-around-origin = A esfera tem o centro na origem do modelo, com o raio medido a partir do centroide.
code-faulty-winding = n ← (V₂ − V₀) × (V₁ − V₀)
words-faulty-winding = Calcule a normal como se os vértices fossem no sentido horário.
code-faulty-constant-view = descarte triângulos com n·v ≥ 0, v constante
words-faulty-constant-view = Use uma só direção de visão para todas as faces.

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
objects-not-drawn = Este método não desenha objetos.
object-add = Adicionar um objeto
object-remove = Remover o objeto em foco
object-focus = Objeto { $object }
object-face = Face
object-number = Número
object-place = Lugar
object-turn = Giro
object-size = Tamanho
section-point = Ponto
section-segment = Segmento
section-triangle = Triângulo
object-opacity = Opacidade
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

verdict-culled = O plano { $plane } descarta o objeto { $object }: d = { $distance } < −r, r = { $radius }. Deslocado { $move } para dentro, não seria descartado por nenhum plano.
verdict-culled-for-good = O plano { $plane } descarta o objeto { $object }: d = { $distance } < −r, r = { $radius }. Nenhum deslocamento pela normal desse plano o faria entrar.
verdict-straddles = O objeto { $object } cruza algum plano: o que está mais perto é o plano { $plane }, d = { $distance } < r = { $radius }. Deslocado { $move } para fora, seria descartado.
verdict-inside = O objeto { $object } está dentro: o que está mais perto é o plano { $plane }, d = { $distance } ≥ r = { $radius }. Deslocado { $move } para fora, seria descartado.
verdict-face-in = Deslocada { $move } pela normal do plano { $plane }, a face já não teria todos os vértices além de um mesmo plano.
verdict-face-never = Nenhum deslocamento pela normal do plano { $plane } mudaria isso.
verdict-face-cut = Nenhum ponto da face está dentro de todos os planos ao mesmo tempo: deslocá-la pela normal de um só não diz nada.
verdict-face-turn-to = Girada { $angle }° em torno de V₀, diretamente para a câmera, a face começaria a mostrar o lado da frente.
verdict-face-turn-away = Girada { $angle }° em torno de V₀, afastando-se da câmera, a face ficaria de perfil e seria descartada.
verdict-face-no-normal = A face não tem normal: nenhum giro mostraria o lado da frente.
part-segment = o segmento
part-corner = o vértice { $vertex }
part-edge = a aresta { $from }{ $to }
verdict-part-kept = Nenhum plano corta { $part }: nada se perde.
verdict-part-cut = O plano { $plane } é o primeiro que corta { $part }; resta uma parte.
verdict-part-lost = Quem decide é o plano { $plane }: { $part } se perde por inteiro.
verdict-part-in = Com um deslocamento de { $move } para dentro, perpendicular ao plano { $plane }, não se perderia.
verdict-part-back = Com um deslocamento de { $move } para fora, perpendicular ao plano { $plane }, não se perderia.
verdict-part-never = Nenhum deslocamento perpendicular ao plano { $plane } mudaria isso.
verdict-part-out = Com um deslocamento para fora de mais de { $move }, perpendicular ao plano { $plane }, não restaria nada.
verdict-part-touch = Só toca o plano { $plane }: com o menor deslocamento para fora não restaria nada.
verdict-crossing-out = A aresta tem aqui uma interseção porque seus extremos estão em lados diferentes do plano { $plane }: d = { $inner } e d = { $outer }. Com esse plano { $move } mais para fora não haveria interseção.
verdict-crossing-in = A aresta tem aqui uma interseção porque seus extremos estão em lados diferentes do plano { $plane }: d = { $inner } e d = { $outer }. Com esse plano mais de { $move } para dentro não haveria interseção.

## What culling costs, measured

culling-title = Quanto custa o descarte
culling-about = Testa-se cada objeto e depois se desenha o que resta: a mesma imagem de três maneiras, medida aqui e agora.
culling-objects = Objetos
culling-own = Os desta cena
culling-nothing = Sem descartar nada
culling-rough = Com esferas envolventes
culling-exact = Com todos os triângulos
culling-row = { $way }: descartar { $cull } ms + desenhar { $draw } ms; restam objetos: { $objects }, triângulos: { $triangles }
culling-inequality = Descarte aproximado comparado com o exato: { $rough-cull } { $cull-relation } { $exact-cull } ms. Desenho do que resta: { $rough-draw } { $draw-relation } { $exact-draw } ms.
culling-axis-objects = Objetos (caixas em uma rua)
culling-axis-millis = Milissegundos
culling-best-always = O mais rápido em todas as quantidades medidas: { $way }.
culling-best-changes = O mais rápido no início: { $first }. A partir de { $many } objetos: { $last } (com { $few } ainda não).
culling-note = A mais rápida de cinco passagens, em 320 × 200 pixels; as esferas são testadas muitas de uma vez. Os tempos são deste computador e deste momento: as figuras exportadas mostram contagens.

## A pixel of the camera's picture

pixel-seen = O pixel { $at } mostra a face { $face } do objeto { $object }: { $count ->
    [1] é a única que há ali, a esta profundidade:
   *[other] é a mais próxima de { $count }. Sua profundidade e a da seguinte:
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
picture-seen = Aqui se vê a face { $face } do objeto { $object }: { $count ->
    [1] é a única que há, a esta profundidade:
   *[other] é a mais próxima de { $count }. Sua profundidade e a da seguinte:
  }
picture-empty = Aqui não se vê nenhuma face.
picture-other = A { $percent } % da imagem { $direction } vê-se a face { $face } do objeto { $object }.
picture-other-nothing = A { $percent } % da imagem { $direction } não se vê nada.
pixel-shows = Neste passo, o pixel { $at } mostra a face { $face } do objeto { $object }.
pixel-shows-nothing = Neste passo, o pixel { $at } não mostra nada.
pixel-truth = A mais próxima ali é a face { $face } do objeto { $object }.
pixel-truth-nothing = Nenhuma face cobre este pixel.
pixel-alone = Só este pixel
pixel-all = Todos os pixels
pixel-right = à direita
pixel-left = à esquerda
pixel-down = para baixo
pixel-up = para cima
