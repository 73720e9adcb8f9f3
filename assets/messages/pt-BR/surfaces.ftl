### O que diz o laboratório de superfícies: qual superfície está na frente, pixel a pixel.

alg-depth-buffer = Buffer de profundidade
alg-faulty-depth-clear = Buffer de profundidade, iniciado com 0
alg-faulty-depth-compare = Buffer de profundidade, comparação invertida
alg-faulty-depth-always = Buffer de profundidade, sem comparar
alg-faulty-depth-straight = Buffer de profundidade, distância linear na tela

## Pseudocode

code-depth-clear = picture ← background, z ← ∞
words-depth-clear = Limpe a imagem com o fundo e ponha cada profundidade em infinito.
code-depth-triangle = for each triangle T
words-depth-triangle = Pegue os triângulos, em qualquer ordem.
code-depth-fragment = for each pixel in T: z_T ← depth of T there
words-depth-fragment = Para cada pixel cujo centro o triângulo cobre, ache ali a sua profundidade.
code-depth-compare = if z_T < z[pixel]
words-depth-compare = Compare-a com a profundidade guardada.
code-depth-write = picture[pixel] ← T, z[pixel] ← z_T
words-depth-write = Se for menor, escreva o triângulo e a sua profundidade.
code-faulty-depth-clear = picture ← background, z ← 0
words-faulty-depth-clear = Ponha cada profundidade em 0, a do plano próximo.
code-faulty-depth-compare = if z_T > z[pixel]
words-faulty-depth-compare = Escreva quando a nova profundidade é maior.
code-faulty-depth-always = always
words-faulty-depth-always = Não compare nada.
code-faulty-depth-straight = for each pixel in T: z_T ← distance, straight across the screen
words-faulty-depth-straight = Interpole a distância no espaço da câmera linearmente na tela, sem a divisão.
faulty-depth-clear-differs = O passo { $step } é o primeiro que difere: nenhuma profundidade é menor que 0, então nada será escrito.
faulty-depth-compare-differs = O passo { $step } é o primeiro que difere: escreve-se o mais distante.
faulty-depth-always-differs = O passo { $step } é o primeiro que difere: escreve-se, embora ali haja algo mais próximo.
faulty-depth-straight-differs = O passo { $step } é o primeiro que difere: esta não é a profundidade da superfície, pois a distância não é linear na tela.

## The depth buffer

depth-opening = { $triangles ->
    [one] Um triângulo
   *[other] { $triangles } triângulos
  } em { $columns } × { $rows } pixels: { $pixels } profundidades, uma por pixel.
depth-clear = Limpo: nenhum dos { $pixels } pixels tem triângulo.
depth-triangle = Chega { $triangle }, { $place } de { $triangles }.
depth-triangle-unseen = De { $triangle } nada se desenha: está fora do volume, de perfil ou de costas.
depth-triangle-whole = Desenhado { $triangle }: de { $fragments } fragmentos, { $writes } estão mais próximos do que o que havia.
depth-span = Linha { $row } de { $triangle }, colunas { $first } a { $last }: de { $fragments } fragmentos escrevem-se { $writes }.
depth-fragment-first = O pixel { $at } ainda está vazio: escreve-se { $triangle }.
depth-fragment-kept = No pixel { $at }, { $triangle } está mais próximo que { $other }: escreve-se.
depth-fragment-lost = No pixel { $at }, { $triangle } não está mais próximo que { $other }: { $other } fica.
depth-fragment-tie = No pixel { $at }, { $triangle } está tão próximo quanto { $other }: { $other } chegou antes e fica.
depth-fragment-lost-to-nothing = No pixel { $at } { $triangle } não é escrito, embora ali não houvesse nada.
depth-nothing = nada
depth-done = Pronto: { $fragments } fragmentos, { $writes } escritos, para { $pixels } pixels. Vezes que cada um foi calculado, em média:

## Views

raster-depth = Imagem, { $columns } × { $rows }: profundidade em milésimos
raster-depth-steps = Imagem, { $columns } × { $rows }: profundidade em { $bits } bits, de 0 a { $last }
story-stored = guardada
story-fate = resultado
story-kept = escrito
story-lost = perde
watch-triangle = triângulo
watch-pixel = pixel
watch-fragments = fragmentos
watch-writes = escritos
watch-pixels = pixels

## Ray casting

alg-ray-casting = Lançamento de raios
code-ray-pixel = for each pixel: ray o + t · r through its middle
words-ray-pixel = Para cada pixel, pegue o raio que sai do olho pelo seu centro.
code-ray-triangle = for each triangle T with plane n·p + d = 0
words-ray-triangle = Pergunte a cada triângulo.
code-ray-plane = t ← −(n·o + d) / (n·r)
words-ray-plane = Ache onde o raio corta o plano; paralelo ou atrás do olho não conta.
code-ray-inside = if o + t · r in T: hit
words-ray-inside = Se o ponto está no triângulo, o raio o atinge.
code-ray-nearest = picture[pixel] ← T of the smallest t
words-ray-nearest = Vê-se o ponto atingido de menor t.
ray-opening = { $rays ->
    [one] Um raio
   *[other] { $rays } raios
  } para { $columns } × { $rows } pixels; cada um pergunta a { $triangles ->
    [one] um triângulo.
   *[other] { $triangles } triângulos.
  }
ray-pixel = O raio pelo centro do pixel { $at }: em t = 0 o olho, em t = 1 o plano próximo.
ray-hit-first = O raio atinge { $triangle }: o mais próximo até agora.
ray-hit-nearer = O raio atinge { $triangle } antes de { $other }, que está em t = { $t }: agora é o mais próximo.
ray-hit-farther = O raio também atinge { $triangle }, atrás de { $other }, que está em t = { $t }.
ray-says-culled = { $triangle } não é perguntado: está de perfil ou de costas.
ray-says-parallel = O raio é paralelo ao plano de { $triangle }: n·r = 0, nunca se cortam.
ray-says-behind = O plano de { $triangle } é cortado atrás do olho: t < 0.
ray-says-before-near = { $triangle } é cortado antes do plano próximo: t < 1.
ray-says-beyond-far = { $triangle } é cortado além do plano distante.
ray-says-beside = O raio corta o plano de { $triangle } fora do triângulo: não o atinge.
ray-seen = O pixel { $at } fica com { $triangle }: o menor t de { $hits ->
    [one] um ponto atingido.
   *[other] { $hits } pontos atingidos.
  }
ray-seen-nothing = O pixel { $at } continua fundo: nenhum triângulo é atingido.
ray-done = Pronto: { $rays } raios, cada um perguntou a { $triangles } triângulos.
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
raster-rays = Imagem até agora, { $columns } × { $rows }
watch-hits = atingidos
watch-nearest = mais próximo
watch-asked = perguntas

## The raster's form

raster-title = Raster
raster-rows = Linhas
raster-shuffle = Embaralhar (0: não)
raster-steps = Um passo é
raster-steps-fragments = um fragmento
raster-steps-spans = uma linha de um triângulo
raster-steps-triangles = um triângulo
raster-number = Profundidade
raster-reversed = Invertida: 1 é perto
raster-cull = Descartar faces traseiras
