### O que o laboratório do volume de visão diz de um vértice a caminho por todos os espaços.

alg-viewing-pipeline = Pipeline de visualização

## Espaços

space-model = modelo
space-world = mundo
space-view = visão
space-clip = recorte
space-ndc = NDC
space-screen = tela
space-model-title = Espaço do modelo
space-world-title = Espaço do mundo
space-view-title = Espaço de visão: a câmera é a origem
space-clip-title = Espaço de recorte, sobre x, y e w
space-clip-parallel-title = Espaço de recorte, sobre x, y e z
space-ndc-title = NDC: dividido por w
space-screen-title = Tela, em pixels
object-vertex = Vértice
pipeline-note-world = tamanho, giro e lugar do objeto
pipeline-note-view = câmera em { $at }
pipeline-note-clip = { $angle }°; { $aspect } : 1; plano próximo { $near }, distante { $far }
pipeline-note-clip-parallel = altura { $height }; { $aspect } : 1; plano próximo { $near }, distante { $far }

## Pseudocódigo

code-pipeline-world = world ← world_from_model · (P, 1)
code-pipeline-view = view ← view_from_world · (world, 1)
code-pipeline-clip = clip ← clip_from_view · (view, 1)
code-pipeline-test = dentro se −w ≤ x, y, z ≤ w
code-pipeline-divide = se w > 0: ndc ← (x, y, z) / w
code-pipeline-screen = screen ← ((x + 1)/2 · colunas, (1 − y)/2 · linhas)
code-pipeline-behind = senão: sem lugar na tela
words-pipeline-world = A matriz do objeto põe o vértice no mundo.
words-pipeline-view = A matriz da câmera diz onde o vértice está, visto dela.
words-pipeline-clip = A projeção escala x e y, e copia a profundidade para w.
words-pipeline-test = O recorte testa isto antes de dividir qualquer coisa.
words-pipeline-divide = Dividir pela profundidade torna pequeno o que está longe.
words-pipeline-screen = Passe de −1 … 1 a pixels, contados do canto superior esquerdo.
words-pipeline-behind = Um ponto que não está diante do olho não tem imagem.

## Passos

pipeline-opening = Um vértice é dado tal como foi modelado: onde ficará na tela?
pipeline-world-row = A linha { $row } da matriz do objeto escala, gira e leva o vértice ao seu lugar no mundo.
pipeline-view-right = A linha 1 mede para a direita da câmera: P está { $value } à direita.
pipeline-view-left = A linha 1 mede para a direita da câmera: P está { $value } à esquerda.
pipeline-view-above = A linha 2 mede para cima da câmera: P está { $value } acima do seu eixo.
pipeline-view-under = A linha 2 mede para cima da câmera: P está { $value } abaixo do seu eixo.
pipeline-view-back = A linha 3 mede para trás: P está { $value } atrás da câmera.
pipeline-view-ahead = A linha 3 mede para trás: P está { $value } à frente, e por isso z é negativo.
pipeline-clip-x = A linha 1 escala x: os planos esquerdo e direito ficam em x = ±w.
pipeline-clip-y = A linha 2 escala y: os planos inferior e superior ficam em y = ±w.
pipeline-clip-z = A linha 3 põe o plano próximo em z = −w e o distante em z = w.
pipeline-clip-w = A linha 4 copia a profundidade para w: { $value }. Depois x, y e z são divididos por ele.
pipeline-clip-w-parallel = A linha 4 deixa w em 1: com linhas de visão paralelas não é preciso dividir.
pipeline-inside = P está dentro: x, y e z ficam entre −w e w.
pipeline-outside = P está fora: o recorte o retira.
pipeline-divide = Divida por w = { $w }: o que está dentro fica entre −1 e 1.
pipeline-screen = Passe de −1 … 1 a { $columns } × { $rows } pixels; as linhas são contadas de cima.
pipeline-behind = P não está diante do olho: seu w não pode ser divisor, e P não tem lugar na tela.

## Casos

object-model-matrix = matriz do modelo
object-camera = câmera
object-picture = imagem
json-whole = um número inteiro
case-whole-too-large = { $number } é maior que o número de qualquer pixel.
case-picture-side = Um lado da imagem tem de 1 a { $max } pixels, e há { $found }.
case-pipeline-inside = Dentro, e na tela em { $screen }.
case-pipeline-outside = Fora; sem recorte estaria na tela em { $screen }.
case-pipeline-behind = Não está diante do olho: não tem lugar na tela.
object-from = de
object-to = até
case-too-many-pixels = A linha tem { $found } pixels: são aceitos no máximo { $max }.
case-pixels =
    { $count ->
        [1] Um pixel.
       *[other] { $count } pixels.
    }

## De uma linha a seus pixels

alg-bresenham = Da linha aos pixels (Bresenham)
raster-line = Tela, { $columns } × { $rows } pixels
raster-lens = Do ponto médio à linha: e / { $whole } de pixel
code-drawn-project = clip ← clip_from_world · (P, 1), para os dois extremos
code-drawn-clip = recorte a linha a −w ≤ x, y, z ≤ w
code-drawn-divide = S ← viewport(x / w, y / w)
code-drawn-begin = a, b ← o maior e o menor de |Δx|, |Δy|; e ← 2b − a
code-drawn-put = ponha o pixel; até o último:
code-drawn-diagonal = se e > 0, ou e = 0 e a coordenada ao lado é menor:
code-drawn-across = um passo ao lado; e ← e − 2a
code-drawn-straight = um passo adiante; e ← e + 2b
words-drawn-project = Projete: os dois extremos vão ao espaço de recorte; nada é dividido ainda.
words-drawn-clip = Recorte: tira-se o que a câmera não pode ver.
words-drawn-divide = Divida por w e conte em pixels.
words-drawn-begin = Cada extremo vai ao seu pixel; o termo de erro (e) diz de que lado do primeiro ponto médio a linha passa.
words-drawn-put = Avance pixel a pixel ao longo do eixo maior.
words-drawn-diagonal = A linha passa além do ponto médio? Se passa exatamente por ele, toma-se a coordenada menor.
words-drawn-across = Então, dê também um passo pelo eixo menor.
words-drawn-straight = Dê um passo pelo eixo maior.
drawn-line-opening = Que pixels a linha tem?
drawn-line-project = { $end } vai ao espaço de recorte: sua profundidade { $w } passa a ser w.
drawn-line-project-behind = { $end } vai ao espaço de recorte. Não está diante do olho: não se deve dividir por w = { $w }.
drawn-line-clip-whole = A linha toda está dentro: nada é tirado.
drawn-line-clip-cut = A linha é recortada antes de dividir: o que sobra tem w > 0.
drawn-line-reject = Nada da linha está dentro: nenhum pixel é desenhado.
drawn-line-divide = Divididos por w e escalados, os dois extremos são lugares na tela.
drawn-line-round = Cada extremo vai ao pixel em que está; a linha vai agora de centro a centro.
drawn-line-first = { $at } é o primeiro pixel. O termo de erro (e) diz de que lado do ponto médio seguinte a linha passa.
drawn-line-straight = e = { $e } < 0: a linha não chega ao ponto médio. Um passo reto, até { $at }.
drawn-line-diagonal = e = { $e } > 0: a linha passa além do ponto médio. Um passo na diagonal, até { $at }.
drawn-line-tie-straight = e = 0: exatamente entre dois pixels, e toma-se a coordenada menor: { $at }.
drawn-line-tie-diagonal = e = 0: exatamente entre dois pixels, e toma-se a coordenada menor: { $at }, na diagonal.
