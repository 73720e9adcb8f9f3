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
depth-fragment-first = O pixel [{ $column }, { $row }] ainda está vazio: escreve-se { $triangle }.
depth-fragment-kept = No pixel [{ $column }, { $row }], { $triangle } está mais próximo que { $other }: escreve-se.
depth-fragment-lost = No pixel [{ $column }, { $row }], { $triangle } não está mais próximo que { $other }: { $other } fica.
depth-fragment-tie = No pixel [{ $column }, { $row }], { $triangle } está tão próximo quanto { $other }: { $other } chegou antes e fica.
depth-fragment-lost-to-nothing = No pixel [{ $column }, { $row }] { $triangle } não é escrito, embora ali não houvesse nada.
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
