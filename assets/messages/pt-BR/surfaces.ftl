### O que diz o laboratório de superfícies: qual superfície está na frente, pixel a pixel.

alg-depth-buffer = Buffer de profundidade
alg-faulty-depth-clear = Buffer de profundidade, iniciado com 0
alg-faulty-depth-compare = Buffer de profundidade, comparação invertida
alg-faulty-depth-always = Buffer de profundidade, sem comparar
alg-faulty-depth-straight = Buffer de profundidade, distância linear na tela

## Pseudocode

code-depth-clear = imagem ← fundo, z ← ∞
words-depth-clear = Ponha a imagem na cor de fundo e cada profundidade em infinito.
code-depth-clear-reversed = imagem ← fundo, z ← −∞
words-depth-clear-reversed = Ponha a imagem na cor de fundo e cada profundidade em menos infinito: nada está mais longe.
code-depth-triangle = para cada triângulo T
words-depth-triangle = Tome os triângulos, em qualquer ordem.
code-depth-fragment = para cada pixel de T: z_T ← profundidade de T ali
words-depth-fragment = Para cada pixel cujo centro o triângulo cobre, calcule ali a sua profundidade.
code-depth-compare = se z_T < z[pixel]
words-depth-compare = Compare esta profundidade com a guardada.
code-depth-compare-reversed = se z_T > z[pixel]
code-depth-write = imagem[pixel] ← T, z[pixel] ← z_T
words-depth-write = Se for menor, escreva o triângulo e a sua profundidade.
words-depth-write-reversed = Se for maior, escreva o triângulo e a sua profundidade: 1 significa perto.
code-faulty-depth-clear = imagem ← fundo, z ← 0
words-faulty-depth-clear = Ponha cada profundidade em 0, a do plano próximo.
code-faulty-depth-clear-reversed = imagem ← fundo, z ← 1
words-faulty-depth-clear-reversed = Ponha cada profundidade em 1, a do plano próximo.
code-faulty-depth-compare = se z_T > z[pixel]
words-faulty-depth-compare = Escreva o triângulo onde a nova profundidade é maior.
words-faulty-depth-compare-reversed = Escreva o triângulo onde a nova profundidade é menor, embora 1 signifique perto.
code-faulty-depth-always = sempre
words-faulty-depth-always = Escreva sempre, sem comparar profundidades.
code-faulty-depth-straight = para cada pixel de T: z_T ← distância, interpolada na tela
words-faulty-depth-straight = Interpole a distância no espaço de visão linearmente na tela, sem a divisão.
faulty-depth-clear-differs = O passo { $step } é o primeiro que difere: nada está mais próximo que o plano próximo, então nada será escrito.
faulty-depth-compare-differs = O passo { $step } é o primeiro que difere: o triângulo está mais próximo que o guardado e não é escrito.
faulty-depth-always-differs = O passo { $step } é o primeiro que difere: o triângulo é escrito, embora não esteja mais próximo que o guardado.
faulty-depth-straight-differs = O passo { $step } é o primeiro que difere: esta não é a profundidade da superfície, pois a distância não é linear na tela.

## The depth buffer

depth-opening = { $triangles ->
    [1] Um triângulo
   *[other] { $triangles } triângulos
  } em { $columns } × { $rows } pixels. Profundidades guardadas, uma por pixel: { $pixels }, de { $bits } bits cada uma, { $bytes } bytes ao todo.
depth-clear = A imagem está vazia: { $pixels ->
    [1] o pixel ainda não mostra
   *[other] nenhum dos { $pixels } pixels mostra ainda
  } um triângulo.
depth-triangle = Chega { $triangle } ({ $place } de { $triangles }).
depth-triangle-unseen = De { $triangle } nada se desenha: está fora do volume, de perfil ou de costas.
depth-answer-drawn = { $triangle } é desenhado.
depth-triangle-whole = { $triangle } está desenhado. Seus fragmentos: { $fragments }; escritos: { $writes }.
depth-span = Linha { $row } de { $triangle }, colunas { $first } a { $last }: { $fragments ->
    [1] de { $fragments } fragmento
   *[other] de { $fragments } fragmentos
  } escrevem-se { $writes }.
depth-fragment-first = O pixel { $at } ainda está vazio: escreve-se { $triangle }.
depth-fragment-kept = { $triangle } está mais próximo que { $other } no pixel { $at }: escreve-se.
depth-fragment-lost = { $triangle } não está mais próximo que { $other } no pixel { $at }: { $other } é mantido.
depth-fragment-kept-behind = No pixel { $at } { $triangle } não está mais próximo que { $other } e, mesmo assim, é escrito.
depth-fragment-tie = { $triangle } está tão próximo quanto { $other } no pixel { $at }: { $other } chegou antes e é mantido.
depth-fragment-lost-to-nothing = No pixel { $at } { $triangle } não é escrito, embora ali não houvesse nada.
depth-nothing = nada
depth-done = Pronto: { $fragments ->
    [1] um fragmento
   *[other] { $fragments } fragmentos
  }, { $writes ->
    [1] um escrito
   *[other] { $writes } escritos
  }, para { $pixels ->
    [1] um pixel
   *[other] { $pixels } pixels
  }. Em média, quantas vezes cada pixel foi calculado:
raster-brightness = Brilho em milésimos
raster-brightness-bare = Brilho

## Views

practice-then = o que ficaria ali
raster-depth = Profundidade em milésimos
raster-depth-bare = Profundidade
raster-depth-unit = Profundidade em unidades de { $unit }
raster-straight = Distância do plano próximo ao distante, em milésimos
raster-straight-bare = Distância do plano próximo ao distante
raster-depth-steps = Profundidade em { $bits } bits: 0 a { $last }
raster-distance = Distância até a câmera
raster-counts-none = Vezes que cada pixel é calculado
raster-counts = Vezes calculado: { $seen } à vista, { $vain } em vão
raster-counts-before = Todas as faces: { $seen } à vista, { $vain } em vão
raster-counts-after = Sem faces traseiras: { $seen } à vista, { $vain } em vão
painter-depths = Distância de cada triângulo, do vértice mais próximo ao mais distante
asks-what = testes
asks-now = agora
asks-so-far = até agora
asks-done = concluído
asks-of = { $count } de { $all }
asks-ray-casting = cada pixel: qual triângulo?
asks-depth-buffer = cada triângulo: quais pixels?
asks-painter = cada par: qual vem antes?
raster-pairs = { $pairs ->
    [1] { $pairs } teste de um par
   *[other] { $pairs } testes de pares
  } de { $triangles ->
    [1] { $triangles } triângulo
   *[other] { $triangles } triângulos
  }
raster-questions = { $questions ->
    [1] { $questions } teste
   *[other] { $questions } testes
  } de { $pixels ->
    [1] { $pixels } raio
   *[other] { $pixels } raios
  }
occlusion-triangles = Triângulos de cada objeto
scale-near = perto { $value }
scale-far = { $value } longe
raster-wrong = { $count ->
    [1] Um pixel errado
   *[other] { $count } pixels errados
  }
depth-glass-behind = No pixel { $at }, { $triangle } está atrás de { $other } e se perde, embora { $other } deixe passar { $through } da luz.
depth-glass-done = Pronto: { $unsorted ->
    [0] em cada pixel, cada superfície veio depois do que está atrás dela
    [1] em um pixel, um vidro veio antes do que está atrás dele, e isso se perdeu: uma profundidade por pixel não guarda ordem nenhuma
   *[other] em { $unsorted } pixels, um vidro veio antes do que está atrás dele, e isso se perdeu: uma profundidade por pixel não guarda ordem nenhuma
  }. Em média, cada um foi calculado tantas vezes:
depth-done-stored = Pronto: as profundidades de { $pixels ->
    [1] um pixel
   *[other] { $pixels } pixels
  } vão de { $least } a { $most }.
depth-done-distance = Pronto: as distâncias de { $pixels ->
    [1] um pixel
   *[other] { $pixels } pixels
  } vão de { $least } a { $most }.
depth-done-nothing = Pronto: { $fragments ->
    [1] { $fragments } fragmento,
   *[other] { $fragments } fragmentos,
  } nenhum escrito.
curve-whole = Profundidade em função da distância
curve-enlarged = Ampliado
curve-forward = Sem inverter
curve-reversed = Invertida
curve-near = Plano próximo em { $near }
curve-step = passo da profundidade: { $step }
curve-distance = distância
curve-depth = profundidade
story-title = Pixel { $at }, por ordem de chegada
story-held = Profundidade guardada
story-nearer = mais perto
story-stored = guardada
story-fate = resultado
story-kept = escrito
story-lost = perde
story-stays = escrito, fica
story-tie = empate: perde
watch-triangle = triângulo
watch-pixel = pixel
watch-fragments = fragmentos
watch-writes = escritos
watch-pixels = pixels

## Ray casting

alg-ray-casting = Lançamento de raios
code-ray-pixel = para cada pixel: raio o + t · r pelo seu centro
words-ray-pixel = Para cada pixel, tome o raio que sai do olho e passa pelo seu centro.
code-ray-triangle = para cada triângulo T, plano n·p + d = 0
words-ray-triangle = Teste todos os triângulos.
code-ray-parallel = se n·r = 0: não atingido
words-ray-parallel = Um raio paralelo ao plano não o corta.
code-ray-plane = t ← −(n·o + d) / (n·r)
words-ray-plane = Calcule onde o raio corta o plano.
code-ray-range = se t < 1 ou além do plano distante: não atingido
words-ray-range = Atrás do olho, antes do plano próximo e além do distante nada se vê.
code-ray-inside = se o + t · r está em T: atingido
words-ray-inside = Se esse ponto está no triângulo, o raio o atinge.
code-ray-nearest = imagem[pixel] ← T do menor t
words-ray-nearest = Vê-se o ponto atingido com o menor t.
ray-opening = { $rays ->
    [1] Um raio
   *[other] { $rays } raios
  } para { $columns } × { $rows } pixels; cada um é testado com { $triangles ->
    [1] um triângulo.
   *[other] { $triangles } triângulos.
  }
ray-pixel = O raio que passa pelo centro do pixel { $at }: em t = 0 está no olho; em t = 1, no plano próximo.
ray-hit-first = O raio atinge { $triangle }: é o ponto mais próximo até agora.
ray-hit-nearer = O raio atinge { $triangle }, na frente de { $other }, que está em t = { $t }: agora { $triangle } é o mais próximo.
ray-hit-farther = O raio também atinge { $triangle }, atrás de { $other }, que está em t = { $t }.
ray-answer-farther = O raio atinge { $triangle }, atrás do ponto mais próximo até agora.
ray-says-culled = { $triangle } não é testado: está de perfil ou de costas.
ray-says-parallel = O raio é paralelo ao plano de { $triangle }: n·r = 0, nunca se cortam.
ray-says-behind = A reta do raio corta o plano de { $triangle } atrás do olho: t < 0.
ray-says-before-near = O raio corta { $triangle } antes do plano próximo: t < 1.
ray-says-beyond-far = O raio corta { $triangle } além do plano distante.
ray-says-beside = O raio corta o plano de { $triangle } fora do triângulo: não o atinge.
ray-seen = O pixel { $at } mostra { $triangle }: ele tem o menor t de { $hits ->
    [1] um ponto atingido.
   *[other] { $hits } pontos atingidos.
  }
ray-seen-before-others = O pixel { $at } fica com { $triangle }: o raio acaba em t = { $t }, e { $hidden } { $hits ->
    [2] fica
   *[other] ficam
  } na sombra de { $triangle }.
ray-seen-nothing = O pixel { $at } continua com a cor de fundo: nenhum triângulo é atingido.
ray-done = Pronto: { $rays ->
    [1] um raio, testado com
   *[other] { $rays } raios, cada um testado com
  } { $triangles ->
    [1] um triângulo.
   *[other] { $triangles } triângulos.
  }
ray-culled = não testado
ray-parallel = paralelo
ray-behind = atrás do olho
ray-before-near = antes do plano próximo
ray-beyond-far = além do plano distante
ray-beside = fora
ray-hit = atrás
ray-nearest = mais próximo
ray-eye = olho
ray-raster = raster
raster-so-far = Imagem até agora
watch-hits = atingidos
watch-nearest = mais próximo
watch-asked = testes

## Painter's algorithm

alg-painter = Algoritmo do pintor
alg-faulty-painter-nearest = Pintor, ordenado pelo vértice mais próximo
alg-faulty-painter-keys = Pintor, ordenado sem outros testes
code-paint-key = para cada triângulo T: chave ← distância do seu vértice mais distante
words-paint-key = A chave de um triângulo é a distância do seu vértice mais distante.
code-paint-sort = ordene pela chave, o mais distante primeiro
words-paint-sort = Ordene os triângulos pela chave, primeiro o mais distante.
code-paint-ask = para cada P da lista: P pode vir antes de todo Q que resta?
words-paint-ask = Tome o primeiro triângulo que resta e teste se ele pode vir antes de todos os demais.
code-paint-object = se P esconde parte de Q: Q vem antes de P
words-paint-object = Se ele esconde uma parte de outro, esse deve vir antes e é testado em seguida.
code-paint-cycle = se Q espera por P: ciclo
words-paint-cycle = Se esse já está esperando, não há ordem certa.
code-paint-place = senão, P é o próximo
words-paint-place = Se não esconde parte de nenhum outro, ele é o próximo.
code-paint-paint = pinte todos, nessa ordem
words-paint-paint = Pinte-os nessa ordem, cada um sobre o que já está lá.
code-faulty-painter-nearest = para cada triângulo T: chave ← distância do seu vértice mais próximo
words-faulty-painter-nearest = A chave de um triângulo é a distância do seu vértice mais próximo.
code-faulty-painter-keys = para cada P da lista: P é o próximo
words-faulty-painter-keys = Tome os triângulos como estão ordenados, sem nenhum teste.
faulty-painter-nearest-differs = O passo { $step } é o primeiro que difere: a chave é a distância do vértice mais próximo, não a do mais distante.
faulty-painter-keys-differs = O passo { $step } é o primeiro que difere: não se testa se este triângulo pode ser o próximo.
surfaces-first = Só os primeiros { $triangles } de { $all } triângulos: os passos de todos seriam muitos para acompanhar.
refused-too-many-faces = Recusado: a cena tem { $triangles } triângulos, e este método aceita no máximo { $most }. Tire objetos ou escolha outro método.
painter-opening = { $triangles ->
    [1] Há um triângulo
   *[other] Há { $triangles } triângulos
  } para pintar, primeiro o mais distante: o que se pinta depois esconde o anterior.
painter-key = { $triangle } tem a chave { $key }. Seus vértices ficam entre estas distâncias:
painter-sort = { $triangle } é o número { $place } da lista, primeiro o mais distante.
painter-pair-depths = { $triangle } está mais longe que todo o { $other }: pode vir antes.
painter-pair-screen = { $triangle } e { $other } estão separados na tela: qualquer um pode vir antes.
painter-pair-behind = { $triangle } está atrás do plano de { $other }: pode vir antes.
painter-pair-before = { $other } está na frente do plano de { $triangle }: { $triangle } pode vir antes.
painter-pair-overlap = Em nenhum ponto da tela { $triangle } está mais próximo que { $other }: pode vir antes.
painter-pair-hides = { $triangle } esconde uma parte de { $other }: não pode vir antes.
painter-ask-depths = 1  { $triangle } está mais longe que todo o { $other }?
painter-ask-screen = 2  Estão separados na tela?
painter-ask-behind = 3  { $triangle } está atrás do plano de { $other }?
painter-ask-before = 4  { $other } está na frente do plano de { $triangle }?
painter-ask-overlap = 5  { $triangle } está tão longe quanto o outro, ou mais, em toda parte?
painter-yes = sim
painter-no = não
painter-not-asked = não testada
painter-constraint = { $before } deve ser pintado antes de { $after }.
painter-place = { $triangle } não esconde parte de nenhum dos que restam: ele é o número { $place } de { $triangles }.
painter-cycle-first = Há um ciclo: { $triangle } espera por si mesmo.
painter-cycle-next = { $before } deve ser pintado antes de { $triangle }.
painter-cycle-closes = { $before } deve ser pintado antes de { $triangle }, e { $triangle } antes de { $first }: o ciclo se fecha.
painter-paint = { $triangle } é pintado sobre tudo: { $place } de { $triangles }.
painter-done = Pronto: { $pairs ->
    [1] foi testado um par
   *[other] foram testados { $pairs } pares
  } de { $triangles ->
    [1] um triângulo.
   *[other] { $triangles } triângulos.
  }
painter-done-cycle = Nenhuma ordem é certa: cada um de { $cycle } triângulos deve vir antes do seguinte, e o último antes do primeiro.
painter-must = Deve vir antes
painter-cycle = ciclo
watch-pairs = pares testados
watch-depth-extents = pela profundidade
watch-screen-extents = pelo lugar na tela
watch-behind-plane = pelo plano do outro
watch-before-plane = pelo próprio plano
watch-overlap = pela sobreposição

## BSP trees

alg-bsp = Árvore BSP
code-bsp-node = construa(lista): nó ← plano do primeiro triângulo
words-bsp-node = O plano do primeiro triângulo passa a ser um nó.
code-bsp-ask = para cada outro T: na frente, atrás ou no plano
words-bsp-ask = Cada um dos outros está na frente do plano, atrás ou nele.
code-bsp-cut = T dos dois lados: corte em dois; depois construa(frente), construa(atrás)
words-bsp-cut = O triângulo que está dos dois lados é cortado em dois. Depois construa a árvore da frente e a de trás.
code-bsp-visit = percorra(nó): de que lado está o olho?
words-bsp-visit = Ao percorrer a árvore, determine em cada nó de que lado está o olho.
code-bsp-paint = percorra(outro lado); pinte o nó; percorra(lado do olho)
words-bsp-paint = Primeiro o outro lado, depois o próprio nó e por fim o lado do olho.
bsp-opening = { $triangles ->
    [1] Um triângulo vira
   *[other] { $triangles } triângulos viram
  } uma árvore de planos, construída uma vez e percorrida para cada ponto de vista.
bsp-plane = plano de { $triangle }
bsp-eye = olho
bsp-node-root = O plano de { $triangle } é o primeiro nó.
bsp-node-front = Do que está na frente de { $parent }, o primeiro é { $triangle }: o seu plano é o próximo nó.
bsp-node-back = Do que está atrás de { $parent }, o primeiro é { $triangle }: o seu plano é o próximo nó.
bsp-ask-front = { $piece } está na frente do plano de { $triangle }. Distâncias dos seus vértices:
bsp-ask-back = { $piece } está atrás do plano de { $triangle }. Distâncias dos seus vértices:
bsp-ask-on = { $piece } está no plano de { $triangle }. Distâncias dos seus vértices:
bsp-ask-cut = { $piece } está dos dois lados do plano de { $triangle }: é cortado em { $first } e { $second }. Distâncias dos seus vértices:
option-side-front = { $piece } está na frente do plano de { $triangle }.
option-side-back = { $piece } está atrás do plano de { $triangle }.
option-side-on = { $piece } está no plano de { $triangle }.
option-side-cut = { $piece } está dos dois lados do plano de { $triangle }: é cortado em { $first } e { $second }.
bsp-built = A árvore está construída: { $triangles ->
    [1] um triângulo fica
   *[other] { $triangles } triângulos ficam
  } em { $pieces ->
    [1] uma peça,
   *[other] { $pieces } peças,
  } em { $nodes ->
    [1] um nó.
   *[other] { $nodes } nós.
  }
bsp-visit-front = O olho está na frente do plano de { $triangle }: primeiro o que está atrás, depois { $triangle }, por fim o que está na frente.
bsp-visit-back = O olho está atrás do plano de { $triangle }: primeiro o que está na frente, depois { $triangle }, por fim o que está atrás.
bsp-visit-on = O olho está no plano de { $triangle } ou olha ao longo dele: qualquer lado pode vir antes.
bsp-paint = { $piece } é pintado sobre tudo: { $place } de { $pieces }.
bsp-done = Pronto: { $pieces ->
    [1] uma peça pintada
   *[other] { $pieces } peças pintadas
  } de trás para a frente, com { $nodes ->
    [1] um teste.
   *[other] { $nodes } testes.
  }
bsp-tree = Árvore: ← na frente, atrás →
bsp-before = na frente
bsp-behind = atrás
bsp-eye-before = olho na frente
bsp-eye-behind = olho atrás
bsp-eye-on = olho nele
watch-nodes = nós
watch-pieces = peças
watch-visited = visitados
watch-painted = pintadas

## Occlusion queries

alg-occlusion = Consulta de oclusão
code-occlusion-occluders = para cada oclusor: desenhe-o
words-occlusion-occluders = Desenhe os objetos que escondem muito da imagem.
code-occlusion-others = para cada outro P, se caixa(P) alcança o plano próximo: desenhe P
words-occlusion-others = Tome os demais objetos um a um. Se a caixa alcança o plano próximo, desenhe o objeto sem consulta.
code-occlusion-ask = n ← pixels de caixa(P) com z_caixa ≤ z[pixel]
words-occlusion-ask = Conte os pixels em que a caixa seria vista. Não escreva nada.
code-occlusion-skip = se n = 0: ignore P
words-occlusion-skip = Se não há nenhum, ignore o objeto.
code-occlusion-draw = senão, desenhe P
words-occlusion-draw = Senão, desenhe o objeto.
occlusion-opening = { $objects ->
    [1] Um objeto
   *[other] { $objects } objetos
  } em { $columns } × { $rows } pixels. Dos que estão na imagem, desenha-se primeiro um terço (arredondado para cima), os que cobrem mais pixels, pois podem esconder os demais: { $occluders }.
occlusion-none = nenhum
occlusion-occluder = { $object } é um oclusor e é desenhado sem consulta: { $triangles ->
    [1] um triângulo,
   *[other] { $triangles } triângulos,
  } { $writes ->
    [1] um fragmento escrito.
   *[other] { $writes } fragmentos escritos.
  }
occlusion-seen = A caixa de { $object } cobre { $asked ->
    [1] um pixel
   *[other] { $asked } pixels
  } e seria vista em { $passed }. Nada é escrito.
occlusion-hidden = A caixa de { $object } cobre { $asked ->
    [1] um pixel
   *[other] { $asked } pixels
  } e não seria vista em nenhum: em toda parte há algo mais próximo.
occlusion-beside = A caixa de { $object } não cobre nenhum pixel.
occlusion-unasked = A caixa de { $object } alcança o plano próximo, que pode cortar a sua parte da frente: nada é comparado.
occlusion-answer-seen = A caixa de { $object } seria vista.
occlusion-answer-hidden = A caixa de { $object } fica oculta: em toda parte há algo mais próximo.
occlusion-skip = { $object } é ignorado: { $triangles ->
    [1] seu triângulo não é desenhado.
   *[other] seus { $triangles } triângulos não são desenhados.
  }
occlusion-draw = { $object } é desenhado: { $triangles ->
    [1] um triângulo,
   *[other] { $triangles } triângulos,
  } { $writes ->
    [1] um fragmento escrito.
   *[other] { $writes } fragmentos escritos.
  }
occlusion-in-vain = { $object } é desenhado em vão, { $triangles ->
    [1] um triângulo:
   *[other] { $triangles } triângulos:
  } sua caixa seria vista em { $passed ->
    [1] um pixel,
   *[other] { $passed } pixels,
  } o próprio { $object } em nenhum. A consulta pode manter o oculto, mas nunca descarta o visível.
occlusion-done = Pronto: { $drawn ->
    [1] um desenhado
   *[other] { $drawn } desenhados
  }, { $skipped ->
    [1] um ignorado
   *[other] { $skipped } ignorados
  }. Triângulos poupados: { $spared } de { $triangles }. A imagem é a mesma que se tudo tivesse sido desenhado.
occlusion-objects = objetos
occlusion-asked = pixels da caixa
occlusion-passed = visíveis
occlusion-drawn = desenhado
occlusion-skipped = ignorado
occlusion-is-occluder = oclusor
watch-objects-drawn = objetos desenhados
watch-objects-skipped = objetos ignorados
watch-pixels-asked = pixels consultados
watch-triangles-spared = triângulos poupados

## Whose a pixel is

owns-nothing = { $surface } não cobre nenhum pixel do raster.
owns-none = { $surface } cobre { $covered ->
    [1] um pixel
   *[other] { $covered } pixels
  } e não é visto em nenhum: em toda parte há outra coisa na frente.
owns-all = { $surface } cobre { $covered ->
    [1] um pixel e é visto nele.
   *[other] { $covered } pixels e é visto em todos.
  }
owns-some = { $surface } cobre { $covered ->
    [1] um pixel
   *[other] { $covered } pixels
  } e é visto em { $seen }; em { $hidden ->
    [1] um
   *[other] { $hidden }
  } há outra coisa na frente.

## What it costs

surface-costs-title = Quanto custa saber o que está na frente
surface-costs-about = Contado, não cronometrado, em { $columns } × { $rows } pixels: ruas de caixas, de doze triângulos cada uma.
surface-costs-triangles = Triângulos
surface-costs-counts = Pares, testes, fragmentos
surface-costs-pairs = Pintor: { $count } pares testados com { $triangles } triângulos; crescem como n elevado a { $exponent }.
surface-costs-questions = Lançamento de raios: { $count } testes de um raio com um de { $triangles } triângulos; crescem como n elevado a { $exponent }.
surface-costs-fragments = Buffer de profundidade: { $count } fragmentos de { $triangles } triângulos; crescem como n elevado a { $exponent }.
surface-costs-overdraw = Sobredesenho: { $fragments } fragmentos para { $pixels } pixels; cada pixel é calculado { $overdraw } vezes em média.
surface-costs-note = Os expoentes são as inclinações de retas ajustadas aos logaritmos. Os pares são contados só onde há uma ordem; onde não há, falta um ponto na linha.

## The raster's form

raster-title = Raster
raster-rows = Linhas
raster-shuffle = Embaralhar (0: não)
raster-pixel = Pixel (−1: todos)
raster-steps = Um passo é
raster-steps-fragments = um fragmento
raster-steps-spans = uma linha de um triângulo
raster-steps-triangles = um triângulo
raster-tones = Os tons mostram
raster-tones-triangles = qual triângulo
raster-tones-counts = quantas vezes cada pixel é calculado
raster-tones-brightness = o brilho
raster-tones-stored = a profundidade guardada
raster-tones-distance = a distância
raster-number = Profundidade
raster-reversed = Invertida: 1 significa perto
raster-cull = Descartar faces traseiras
