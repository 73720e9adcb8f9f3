### O que diz o laboratório de superfícies: qual superfície está na frente, pixel a pixel.

alg-depth-buffer = Buffer de profundidade
alg-faulty-depth-clear = Buffer de profundidade, iniciado com 0
alg-faulty-depth-compare = Buffer de profundidade, comparação invertida
alg-faulty-depth-always = Buffer de profundidade, sem comparar
alg-faulty-depth-straight = Buffer de profundidade, distância linear na tela

## Pseudocode

code-depth-clear = imagem ← fundo, z ← ∞
words-depth-clear = Limpe a imagem com o fundo e ponha cada profundidade em infinito.
code-depth-clear-reversed = imagem ← fundo, z ← −∞
words-depth-clear-reversed = Limpe a imagem com o fundo e ponha cada profundidade em menos infinito: nada está mais longe.
code-depth-triangle = para cada triângulo T
words-depth-triangle = Pegue os triângulos, em qualquer ordem.
code-depth-fragment = para cada pixel de T: z_T ← profundidade de T ali
words-depth-fragment = Para cada pixel cujo centro o triângulo cobre, ache ali a sua profundidade.
code-depth-compare = se z_T < z[pixel]
words-depth-compare = Compare-a com a profundidade guardada.
code-depth-compare-reversed = se z_T > z[pixel]
code-depth-write = imagem[pixel] ← T, z[pixel] ← z_T
words-depth-write = Se for menor, escreva o triângulo e a sua profundidade.
words-depth-write-reversed = Se for maior, escreva o triângulo e a sua profundidade: 1 é perto.
code-faulty-depth-clear = imagem ← fundo, z ← 0
words-faulty-depth-clear = Ponha cada profundidade em 0, a do plano próximo.
code-faulty-depth-clear-reversed = imagem ← fundo, z ← 1
words-faulty-depth-clear-reversed = Ponha cada profundidade em 1, a do plano próximo.
code-faulty-depth-compare = se z_T > z[pixel]
words-faulty-depth-compare = Escreva quando a nova profundidade é maior.
words-faulty-depth-compare-reversed = Escreva quando a nova profundidade é menor, embora 1 seja perto.
code-faulty-depth-always = sempre
words-faulty-depth-always = Não compare nada.
code-faulty-depth-straight = para cada pixel de T: z_T ← distância, interpolada na tela
words-faulty-depth-straight = Interpole a distância no espaço da câmera linearmente na tela, sem a divisão.
faulty-depth-clear-differs = O passo { $step } é o primeiro que difere: nenhuma profundidade é menor que 0, então nada será escrito.
faulty-depth-compare-differs = O passo { $step } é o primeiro que difere: escreve-se o mais distante.
faulty-depth-always-differs = O passo { $step } é o primeiro que difere: escreve-se, embora ali haja algo mais próximo.
faulty-depth-straight-differs = O passo { $step } é o primeiro que difere: esta não é a profundidade da superfície, pois a distância não é linear na tela.

## The depth buffer

depth-opening = { $triangles ->
    [1] Um triângulo
   *[other] { $triangles } triângulos
  } em { $columns } × { $rows } pixels: { $pixels } profundidades, uma por pixel, de { $bits } bits cada uma: { $bytes } bytes.
depth-clear = Limpo: nenhum dos { $pixels } pixels tem triângulo.
depth-triangle = Chega { $triangle }, { $place } de { $triangles }.
depth-triangle-unseen = De { $triangle } nada se desenha: está fora do volume, de perfil ou de costas.
depth-answer-drawn = { $triangle } é desenhado.
depth-triangle-whole = Desenhado { $triangle }: de { $fragments } fragmentos, { $writes } estão mais próximos do que o que havia.
depth-span = Linha { $row } de { $triangle }, colunas { $first } a { $last }: de { $fragments } fragmentos escrevem-se { $writes }.
depth-fragment-first = O pixel { $at } ainda está vazio: escreve-se { $triangle }.
depth-fragment-kept = No pixel { $at }, { $triangle } está mais próximo que { $other }: escreve-se.
depth-fragment-lost = No pixel { $at }, { $triangle } não está mais próximo que { $other }: { $other } fica.
depth-fragment-tie = No pixel { $at }, { $triangle } está tão próximo quanto { $other }: { $other } chegou antes e fica.
depth-fragment-lost-to-nothing = No pixel { $at } { $triangle } não é escrito, embora ali não houvesse nada.
depth-nothing = nada
depth-done = Pronto: { $fragments ->
    [1] um fragmento
   *[other] { $fragments } fragmentos
  }, { $writes } deles escritos, para { $pixels ->
    [1] um pixel
   *[other] { $pixels } pixels
  }. Em média, cada um foi calculado tantas vezes:

## Views

raster-depth = Profundidade em milésimos
raster-depth-unit = Profundidade em unidades de { $unit }
raster-straight = Distância do próximo ao distante, em milésimos
raster-depth-steps = Profundidade em { $bits } bits: 0 a { $last }
raster-distance = Distância até a câmera
raster-counts-none = Vezes que cada pixel é calculado
raster-counts = Vezes calculado: { $seen } à vista, { $vain } em vão
raster-counts-before = Todas as faces: { $seen } à vista, { $vain } em vão
raster-counts-after = Sem faces traseiras: { $seen } à vista, { $vain } em vão
painter-depths = Distância de cada triângulo, do vértice mais próximo ao mais distante
asks-what = pergunta
asks-now = agora
asks-so-far = até agora
asks-done = concluído
asks-of = { $count } de { $all }
asks-ray-casting = cada pixel: qual triângulo?
asks-depth-buffer = cada triângulo: quais pixels?
asks-painter = cada par: qual antes?
raster-pairs = { $pairs } perguntas por pares de { $triangles } triângulos
raster-questions = { $questions } perguntas de { $pixels } raios
occlusion-triangles = Triângulos de cada objeto
scale-near = perto { $value }
scale-far = { $value } longe
raster-wrong = { $count ->
    [1] Um pixel errado
   *[other] { $count } pixels errados
  }
depth-done-stored = Pronto: as profundidades de { $pixels ->
    [1] um pixel
   *[other] { $pixels } pixels
  } vão de { $least } a { $most }.
depth-done-distance = Pronto: as distâncias de { $pixels ->
    [1] um pixel
   *[other] { $pixels } pixels
  } vão de { $least } a { $most }.
depth-done-nothing = Pronto: de { $fragments } fragmentos nenhum foi escrito.
curve-whole = Profundidade pela distância
curve-enlarged = Ampliado
curve-forward = Sem inverter
curve-reversed = Invertida
curve-near = Plano próximo em { $near }
curve-step = um passo: { $step }
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
words-ray-pixel = Para cada pixel, pegue o raio que sai do olho pelo seu centro.
code-ray-triangle = para cada triângulo T, plano n·p + d = 0
words-ray-triangle = Pergunte a cada triângulo.
code-ray-parallel = se n·r = 0: sem acerto
words-ray-parallel = Um raio paralelo ao plano não o corta.
code-ray-plane = t ← −(n·o + d) / (n·r)
words-ray-plane = Ache onde o raio corta o plano.
code-ray-range = se t < 1 ou além de far: sem acerto
words-ray-range = Atrás do olho, na frente do plano próximo e além do distante nada se vê.
code-ray-inside = se o + t · r está em T: acerto
words-ray-inside = Se o ponto está no triângulo, o raio o atinge.
code-ray-nearest = imagem[pixel] ← T do menor t
words-ray-nearest = Vê-se o ponto atingido de menor t.
ray-opening = { $rays ->
    [1] Um raio
   *[other] { $rays } raios
  } para { $columns } × { $rows } pixels; cada um pergunta a { $triangles ->
    [1] um triângulo.
   *[other] { $triangles } triângulos.
  }
ray-pixel = O raio pelo centro do pixel { $at }: em t = 0 o olho, em t = 1 o plano próximo.
ray-hit-first = O raio atinge { $triangle }: o mais próximo até agora.
ray-hit-nearer = O raio atinge { $triangle } antes de { $other }, que está em t = { $t }: agora é o mais próximo.
ray-hit-farther = O raio também atinge { $triangle }, atrás de { $other }, que está em t = { $t }.
ray-answer-farther = O raio atinge { $triangle }, atrás do mais próximo até agora.
ray-says-culled = { $triangle } não é perguntado: está de perfil ou de costas.
ray-says-parallel = O raio é paralelo ao plano de { $triangle }: n·r = 0, nunca se cortam.
ray-says-behind = O plano de { $triangle } é cortado atrás do olho: t < 0.
ray-says-before-near = { $triangle } é cortado antes do plano próximo: t < 1.
ray-says-beyond-far = { $triangle } é cortado além do plano distante.
ray-says-beside = O raio corta o plano de { $triangle } fora do triângulo: não o atinge.
ray-seen = O pixel { $at } fica com { $triangle }: o menor t de { $hits ->
    [1] um ponto atingido.
   *[other] { $hits } pontos atingidos.
  }
ray-seen-nothing = O pixel { $at } continua fundo: nenhum triângulo é atingido.
ray-done = Pronto: { $rays ->
    [1] um raio, que
   *[other] { $rays } raios, cada um dos quais
  } perguntou a { $triangles ->
    [1] um triângulo
   *[other] { $triangles } triângulos
  }.
ray-culled = não perguntado
ray-parallel = paralelo
ray-behind = atrás do olho
ray-before-near = antes do próximo
ray-beyond-far = além do distante
ray-beside = fora
ray-hit = atrás
ray-nearest = mais próximo
ray-eye = olho
ray-raster = raster
raster-so-far = Imagem até agora
watch-hits = atingidos
watch-nearest = mais próximo
watch-asked = perguntas

## Painter's algorithm

alg-painter = Algoritmo do pintor
alg-faulty-painter-nearest = Pintor, ordenado pelo vértice mais próximo
alg-faulty-painter-keys = Pintor, ordenado sem perguntar mais nada
code-paint-key = para cada triângulo T: chave ← distância do seu vértice mais distante
words-paint-key = A chave de um triângulo é a distância do seu vértice mais distante.
code-paint-sort = ordene pela chave, o mais distante primeiro
words-paint-sort = Ordene os triângulos, primeiro o mais distante.
code-paint-ask = para cada P da lista: P vem antes de todo Q que resta?
words-paint-ask = Pegue o primeiro que resta e pergunte aos demais se ele pode vir antes deles.
code-paint-object = se P esconde parte de Q: Q vem antes de P
words-paint-object = Se ele esconde parte de um, esse deve vir antes e pergunta por sua vez.
code-paint-cycle = se Q espera por P: ciclo
words-paint-cycle = Se esse já está esperando, não há ordem.
code-paint-place = senão, P é o próximo
words-paint-place = Se ninguém se opõe, ele é o próximo.
code-paint-paint = pinte todos, nessa ordem
words-paint-paint = Pinte-os nessa ordem, cada um sobre o que já está lá.
code-faulty-painter-nearest = para cada triângulo T: chave ← seu z mais próximo
words-faulty-painter-nearest = A chave de um triângulo é a distância do seu vértice mais próximo.
code-faulty-painter-keys = para cada P da lista: P é o próximo
words-faulty-painter-keys = Pegue a lista como está ordenada, sem perguntar.
faulty-painter-nearest-differs = O passo { $step } é o primeiro que difere: a chave é o vértice mais próximo, não o mais distante.
faulty-painter-keys-differs = O passo { $step } é o primeiro que difere: não se pergunta a ninguém se este pode ser o próximo.
surfaces-first = Só os primeiros { $triangles } de { $all } triângulos: ninguém poderia acompanhar os passos de todos.
refused-too-many-faces = Recusado: a cena tem { $triangles } triângulos, e este método aceita no máximo { $most }. Tire objetos ou escolha outro método.
painter-opening = { $triangles ->
    [1] Há um triângulo
   *[other] Há { $triangles } triângulos
  } para pintar, primeiro o mais distante: o que se pinta depois esconde o que está lá.
painter-key = { $triangle } tem a chave { $key }. Fica entre estas distâncias:
painter-sort = { $triangle } é o número { $place } da lista, primeiro o mais distante.
painter-pair-depths = { $triangle } está mais fundo que todo o { $other }: pode vir antes.
painter-pair-screen = { $triangle } e { $other } estão separados na tela: qualquer um pode vir antes.
painter-pair-behind = { $triangle } está atrás do plano de { $other }: pode vir antes.
painter-pair-before = { $other } está na frente do plano de { $triangle }: { $triangle } pode vir antes.
painter-pair-overlap = Em nenhum ponto da tela { $triangle } está mais próximo que { $other }: pode vir antes.
painter-pair-hides = { $triangle } esconde uma parte de { $other }: não pode vir antes.
painter-ask-depths = 1  { $triangle } está mais fundo que todo o { $other }?
painter-ask-screen = 2  Estão separados na tela?
painter-ask-behind = 3  { $triangle } está atrás do plano de { $other }?
painter-ask-before = 4  { $other } está na frente do plano de { $triangle }?
painter-ask-overlap = 5  { $triangle } não está mais próximo em nenhum ponto?
painter-yes = sim
painter-no = não
painter-not-asked = não perguntada
painter-constraint = { $before } deve ser pintado antes de { $after }.
painter-place = Nenhum dos que restam se opõe a { $triangle }: ele é o número { $place } de { $triangles }.
painter-cycle-first = Um ciclo: { $triangle } espera por si mesmo.
painter-cycle-next = { $before } deve ser pintado antes de { $triangle }.
painter-cycle-closes = { $before } deve ser pintado antes de { $triangle }, e { $triangle } antes de { $first }: o ciclo se fecha.
painter-paint = { $triangle } é pintado sobre tudo: { $place } de { $triangles }.
painter-done = Pronto: perguntou-se por { $pairs ->
    [1] um par
   *[other] { $pairs } pares
  } de { $triangles } triângulos.
painter-done-cycle = Não existe ordem: cada um de { $cycle } triângulos deve vir antes do seguinte, e o último antes do primeiro.
painter-must = Deve vir antes
painter-cycle = ciclo
watch-pairs = pares perguntados
watch-depth-extents = pela profundidade
watch-screen-extents = pelo lugar na tela
watch-behind-plane = pelo plano do outro
watch-before-plane = pelo próprio plano
watch-overlap = pela sobreposição

## BSP trees

alg-bsp = Árvore BSP
code-bsp-node = construa(lista): nó ← plano do primeiro triângulo
words-bsp-node = O plano do primeiro triângulo é um nó.
code-bsp-ask = para cada outro T: na frente, atrás ou no plano
words-bsp-ask = Cada um dos outros está na frente, atrás ou nele.
code-bsp-cut = T dos dois lados: corte em dois; construa(frente), construa(atrás)
words-bsp-cut = O que está dos dois lados é cortado em dois; depois construa o que está na frente e o que está atrás.
code-bsp-visit = percorra(nó): de que lado está o olho?
words-bsp-visit = Ao percorrer, pergunte em cada nó de que lado está o olho.
code-bsp-paint = percorra(outro lado); pinte o nó; percorra(lado do olho)
words-bsp-paint = Primeiro o outro lado, depois o próprio nó e por fim o lado do olho.
bsp-opening = { $triangles ->
    [1] Um triângulo vira
   *[other] { $triangles } triângulos viram
  } uma árvore de planos, construída uma vez e percorrida para cada olho.
bsp-node-root = O plano de { $triangle } é o primeiro nó.
bsp-node-front = Do que está na frente de { $parent }, o primeiro é { $triangle }: o seu plano é o próximo nó.
bsp-node-back = Do que está atrás de { $parent }, o primeiro é { $triangle }: o seu plano é o próximo nó.
bsp-ask-front = { $piece } está na frente do plano de { $triangle }. Distâncias dos seus vértices:
bsp-ask-back = { $piece } está atrás do plano de { $triangle }. Distâncias dos seus vértices:
bsp-ask-on = { $piece } está no plano de { $triangle }. Distâncias dos seus vértices:
bsp-ask-cut = { $piece } está dos dois lados do plano de { $triangle }: é cortado em { $first } e { $second }. Distâncias dos seus vértices:
bsp-built = A árvore está construída: { $triangles } triângulos são { $pieces } peças em { $nodes } nós.
bsp-visit-front = O olho está na frente do plano de { $triangle }: primeiro o que está atrás, depois { $triangle }, por fim o que está na frente.
bsp-visit-back = O olho está atrás do plano de { $triangle }: primeiro o que está na frente, depois { $triangle }, por fim o que está atrás.
bsp-visit-on = O olho está no plano de { $triangle } ou olha ao longo dele: qualquer lado pode vir antes.
bsp-paint = { $piece } é pintado sobre tudo: { $place } de { $pieces }.
bsp-done = Pronto: { $pieces } peças pintadas de trás para a frente, com { $nodes } perguntas.
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
words-occlusion-occluders = Desenhe os objetos que escondem muito.
code-occlusion-others = para cada outro objeto P, se caixa(P) chega ao próximo: desenhe P
words-occlusion-others = Tome os demais um a um. Se a caixa chega ao plano próximo, o objeto é desenhado sem consulta.
code-occlusion-ask = n ← pixels de caixa(P) com z_caixa ≤ z[pixel]
words-occlusion-ask = Conte os pixels em que a caixa seria vista. Nada é escrito.
code-occlusion-skip = se n = 0: pule P
words-occlusion-skip = Em nenhum: pule-o.
code-occlusion-draw = senão, desenhe P
words-occlusion-draw = Senão, desenhe-o.
occlusion-opening = { $objects ->
    [1] Um objeto
   *[other] { $objects } objetos
  } em { $columns } × { $rows } pixels. Dos que estão na imagem, o terço (arredondado para cima) que cobre mais pixels pode esconder os demais e é desenhado primeiro: { $occluders }.
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
occlusion-unasked = A caixa de { $object } chega ao plano próximo, que pode cortar a sua frente: nada é comparado.
occlusion-answer-seen = A caixa de { $object } seria vista.
occlusion-answer-hidden = A caixa de { $object } fica oculta: em toda parte há algo mais próximo.
occlusion-skip = { $object } é pulado: { $triangles ->
    [one] seu triângulo não é desenhado.
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
  } o próprio { $object } em nenhum. Uma caixa pode dizer demais, nunca de menos.
occlusion-done = Pronto: { $drawn ->
    [1] um desenhado
   *[other] { $drawn } desenhados
  }, { $skipped ->
    [1] um pulado
   *[other] { $skipped } pulados
  }. { $spared } de { $triangles } triângulos são poupados, e a imagem é a mesma que se tudo tivesse sido desenhado.
occlusion-objects = objetos
occlusion-asked = pixels da caixa
occlusion-passed = visíveis
occlusion-drawn = desenhado
occlusion-skipped = pulado
occlusion-is-occluder = oclusor
watch-objects-drawn = objetos desenhados
watch-objects-skipped = objetos pulados
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
owns-some = { $surface } cobre { $covered } pixels e é visto em { $seen }; em { $hidden ->
    [1] um
   *[other] { $hidden }
  } há outra coisa na frente.

## What it costs

surface-costs-title = Quanto custa saber o que está na frente
surface-costs-about = Contado, não cronometrado, em { $columns } × { $rows } pixels: ruas de caixas, de doze triângulos cada uma.
surface-costs-triangles = Triângulos
surface-costs-counts = Pares, perguntas, fragmentos
surface-costs-pairs = Pintor: { $count } pares com { $triangles } triângulos; crescem como n elevado a { $exponent }.
surface-costs-questions = Lançamento de raios: { $count } perguntas dos raios a { $triangles } triângulos; como n elevado a { $exponent }.
surface-costs-fragments = Buffer de profundidade: { $count } fragmentos de { $triangles } triângulos; como n elevado a { $exponent }.
surface-costs-overdraw = Redesenho: { $fragments } fragmentos para { $pixels } pixels, cada um calculado { $overdraw } vezes.
surface-costs-note = Os expoentes são as inclinações de retas ajustadas aos logaritmos. Os pares são contados até 1000 triângulos, e só onde há uma ordem; além disso, a linha termina.

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
raster-tones-counts = quantas vezes são calculados
raster-tones-stored = a profundidade guardada
raster-tones-distance = a sua distância
raster-number = Profundidade
raster-reversed = Invertida: 1 é perto
raster-cull = Descartar faces traseiras
