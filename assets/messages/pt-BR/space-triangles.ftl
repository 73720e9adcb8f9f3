### O que se diz onde triângulos no espaço são cortados: plano a plano, como um só polígono, antes da divisão.

## Métodos

alg-plane-at-a-time = Plano a plano
alg-intersection-polygon = Um só polígono, em leque no fim
alg-textured-triangle = Um só polígono com textura
alg-homogeneous-triangle = Triângulo antes da divisão
alg-faulty-missed-edge = Errado: com d₀ = 0 o triângulo fica inteiro
alg-faulty-on-plane = Errado: sobre o plano é fora
alg-faulty-kept-uv = Errado: (u, v) não é misturado
alg-undivided-texture = Errado: uma textura sem a divisão
alg-faulty-edge-by-edge = Errado: três arestas recortadas
alg-faulty-all-sides = Errado: os seis lados em fila
alg-faulty-divided-triangle = Errado: o triângulo é dividido primeiro

## Vistas

tri-list-in = Lista de entrada
tri-list-out = Lista de saída
tri-list-given = Triângulo
tri-list-left = O que sobra
tri-corners = vértices
tri-none = não há triângulo
tri-not-asked = não é visto
tri-list-fan = Leque a partir de V₀: { $vertices } − 2 = { $triangles ->
        [one] { $triangles } triângulo
       *[other] { $triangles } triângulos
    }
tally-triangles = triângulos
tally-crossings = cortes
tally-one-polygon = um só polígono
tally-one-by-one = triângulo a triângulo
tally-same = Os dois métodos deixam os mesmos { $n } vértices, até { $decimals } casas decimais.

## Um só polígono

ip-opening = Um polígono contra { $planes ->
        [one] { $planes } plano
       *[other] { $planes } planos
    }: sua lista começa com os { $n ->
        [one] { $n } vértice
       *[other] { $n } vértices
    } do triângulo.
ip-plane = O plano { $plane } recebe uma lista de { $n } vértices.
ip-first-inside = { $vertex } está dentro do plano { $plane }: sai.
ip-first-outside = { $vertex } está fora do plano { $plane }: não sai.
ip-touch = { $from } → { $to }: { $rule }. O extremo sobre o plano é o próprio corte.
ip-in-out = { $from } → { $to }: dentro → fora. Emite-se a interseção { $cut }.
ip-out-in = { $from } → { $to }: fora → dentro. Emitem-se a interseção { $cut } e depois { $to }.
ip-closing-cross = A aresta de fechamento { $from } → { $to }: { $rule }. Emite-se só a interseção { $cut }.
ip-cross = { $from } → { $to } corta o plano { $plane } em { $cut }.
ip-output = { $vertex } vai para a lista de saída, que agora tem { $n }.
ip-pass-cuts = O plano { $plane } retira { $dropped } e põe { $cuts }: { $before } → { $after }.
ip-pass-drops = O plano { $plane } retira { $dropped }: { $before } → { $after }.
ip-pass-same = O plano { $plane } não corta nada: { $before } → { $after }.
ip-pass-empty = O plano { $plane } não deixa nada: { $before } → { $after }.
ip-fan = Triângulo { $n } de { $total } do leque: { $corners }.
ip-done = Fim: { $vertices ->
        [one] { $vertices } vértice
       *[other] { $vertices } vértices
    }, um leque de { $n ->
        [one] { $n } triângulo
       *[other] { $n } triângulos
    }, após { $crossings ->
        [one] { $crossings } corte
       *[other] { $crossings } cortes
    }.
ip-done-empty = Fim: { $n } triângulos. Não sobra nada com área ({ $vertices } vértices, { $crossings } cortes).
code-ip-each = para cada plano (n, D):
code-ip-first = se d(V₀) ≥ 0: sai V₀
code-ip-distance = para cada aresta S → P: d ← n·P + D
code-ip-inside = se d ≥ 0 e P ≠ V₀: sai P
code-ip-cross = onde o lado muda: sai C
code-ip-pass = lista ← o que saiu
code-ip-fan = triângulos ← leque da lista
words-ip-each = Pergunte a cada plano por vez; sua normal aponta para dentro.
words-ip-first = O primeiro vértice sai se está dentro; sobre a borda é dentro.
words-ip-distance = Siga as arestas, a última de volta a V₀: a distância com sinal de cada fim.
words-ip-inside = Depois sai o fim, se está dentro; V₀ já está na lista.
words-ip-cross = Onde uma aresta muda de lado, sai seu corte: t = d₁ / (d₁ − d₂).
words-ip-pass = O que saiu é a lista do plano seguinte.
words-ip-fan = Um polígono convexo é dividido em triângulos uma só vez, no fim.

## Triângulo a triângulo

pat-opening = Triângulo a triângulo contra { $planes ->
        [one] { $planes } plano
       *[other] { $planes } planos
    }: a lista começa com { $n } triângulo.
pat-plane =
    { $n ->
        [one] O plano { $plane } recebe { $n } triângulo.
       *[other] O plano { $plane } recebe { $n } triângulos.
    }
pat-three = { $triangle }: { $inside } vértices dentro do plano { $plane }. Fica inteiro.
pat-two = { $triangle }: { $inside } vértices dentro do plano { $plane }. Sobra um quadrilátero, dois triângulos.
pat-one = { $triangle }: { $inside } vértice dentro do plano { $plane }. Sobra um triângulo.
pat-on = { $triangle }: { $inside } de 3 vértices dentro do plano { $plane }, { $on } deles sobre ele.
pat-none = { $triangle }: { $inside } vértices dentro do plano { $plane }. É descartado.
pat-option-three = Os três vértices de { $triangle } estão dentro.
pat-option-two = Dois vértices de { $triangle } estão dentro.
pat-option-one = Um vértice de { $triangle } está dentro.
pat-option-none = Nenhum vértice de { $triangle } está dentro.
pat-piece = Peça { $n } da lista de saída: { $corners }.
pat-pass =
    { $after ->
        [one] O plano { $plane } recebeu { $before } e entrega { $after } triângulo.
       *[other] O plano { $plane } recebeu { $before } e entrega { $after } triângulos.
    }
pat-pass-empty = O plano { $plane } recebeu { $before } e entrega { $after }: não sobra nada.
pat-done =
    { $n ->
        [one] Fim: sobra { $n } triângulo, após { $crossings } cortes.
       *[other] Fim: sobram { $n } triângulos, após { $crossings } cortes.
    }
pat-done-empty = Fim: sobram { $n ->
        [one] { $n } triângulo
       *[other] { $n } triângulos
    }, após { $crossings ->
        [one] { $crossings } corte
       *[other] { $crossings } cortes
    }.
code-pat-each = para cada plano (n, D):
code-pat-triangle = para cada triângulo: conte d ≥ 0
code-pat-three = 3: mantenha
code-pat-two = 2: corte; dois triângulos
code-pat-one = 1: corte; um triângulo
code-pat-none = 0: descarte
code-pat-pass = lista ← o que foi mantido
words-pat-each = Pergunte a cada plano por vez; sua normal aponta para dentro.
words-pat-triangle = Quantos vértices do triângulo estão dentro?
words-pat-three = Os três: ele é mantido inteiro.
words-pat-two = Dois: sobra um quadrilátero, dividido em seu primeiro vértice.
words-pat-one = Um: sobra um triângulo menor.
words-pat-none = Nenhum: ele é descartado.
words-pat-pass = O que foi mantido é a lista do plano seguinte.

## Antes da divisão

ht-opening = { $n } vértices no espaço de recorte, { $behind } deles com w ≤ 0: nada é dividido ainda.
ht-divide = Os { $n } vértices são divididos por seu w.
ht-codes-outside = Todos os vértices estão além de um mesmo lado: rejeitado sem corte, { $sides } lados indicados.
ht-codes-inside = Nenhum vértice está além de um lado: mantido inteiro, { $sides } lados indicados.
ht-codes-cut =
    { $sides ->
        [one] Só { $sides } lado de seis é indicado: esse recorta.
       *[other] Só { $sides } lados de seis são indicados: esses recortam.
    }
ht-side = O lado { $side } recebe { $n } vértices: uma cota, nenhuma divisão.
ht-inside = { $vertex } está dentro do lado { $side }.
ht-outside = { $vertex } está fora do lado { $side }.
ht-cross = { $from } → { $to } corta o lado { $side } em I.
ht-pass = O lado { $side } terminou: { $before } → { $n }.
ht-done = Sobram { $n ->
        [one] { $n } vértice
       *[other] { $n } vértices
    }, um leque de { $triangles ->
        [one] { $triangles } triângulo
       *[other] { $triangles } triângulos
    }: agora podem ser divididos.
ht-done-empty = Não sobra nada com área: { $n } vértices, { $triangles } triângulos.
code-ht-codes = seis bits por vértice: w ± x, y, z < 0
code-ht-decide = OR = 0: mantenha; AND ≠ 0: rejeite
code-ht-each = para cada lado que o OR indica:
code-ht-first = se w ± x ≥ 0 em V₀: sai V₀
code-ht-bound = para cada aresta S → P: w ± x de P
code-ht-cross = onde muda de sinal: sai I
code-ht-inside = se w ± x ≥ 0 e P ≠ V₀: sai P
code-ht-fan = leque, depois divida por w
words-ht-codes = Um bit para cada lado de −w ≤ x, y, z ≤ w que o vértice ultrapassa.
words-ht-decide = Nada a recortar, ou nada a ver.
words-ht-each = Só é preciso perguntar pelos lados que algum vértice ultrapassa.
words-ht-bound = A cota é uma soma: sem divisão, e com w de qualquer sinal.
words-ht-cross = As quatro coordenadas são misturadas com o mesmo t.
words-ht-fan = O que sobra tem w ≥ near > 0 e pode ser dividido.

## O que está errado aqui?

faulty-missed-edge-differs = O passo { $step } é o primeiro diferente: com d₀ = 0 nenhum produto é negativo, e o triângulo ficou inteiro.
faulty-on-plane-differs = O passo { $step } é o primeiro diferente: um vértice sobre o plano foi tomado por externo.
faulty-kept-uv-differs = O passo { $step } é o primeiro diferente: o corte manteve o (u, v) do vértice externo.
faulty-edge-by-edge-differs = O passo { $step } é o primeiro diferente: cada aresta é recortada por si, não como anel.
faulty-all-sides-differs = O passo { $step } é o primeiro diferente: pergunta-se por um lado que nenhum código indica, e que não corta nada.
faulty-divided-triangle-differs = O passo { $step } é o primeiro diferente: vértices com w < 0 foram divididos antes de qualquer recorte.
code-faulty-missed-edge = se d₀·d₁ < 0 ou d₀·d₂ < 0: corte
words-faulty-missed-edge = Corta-se onde a primeira distância e outra diferem em sinal.
code-faulty-on-plane = se d > 0 e P ≠ V₀: sai P
code-faulty-on-plane-first = se d(V₀) > 0: sai V₀
words-faulty-on-plane-first = O primeiro vértice sai se está estritamente dentro.
words-faulty-on-plane = Depois sai o fim, se está estritamente dentro.
code-faulty-kept-uv = sai C, uv(C) ← uv(V)
words-faulty-kept-uv = O corte toma o (u, v) do vértice que substitui.
code-undivided-texture = leque, preencher: uv uniforme na tela
words-undivided-texture = O polígono é dividido em leque; na tela (u, v) é interpolado sem 1/w.
code-faulty-edge-by-edge = para cada plano: recorte cada aresta
words-faulty-edge-by-edge = Pergunte a cada plano por vez; ele recorta as três arestas como três linhas.
code-faulty-all-sides = para cada um dos seis lados:
words-faulty-all-sides = Pergunta-se pelos seis lados, um após o outro.
code-faulty-divided-triangle = (x, y, z) ← (x, y, z)/w; depois seis bits
words-faulty-divided-triangle = Cada vértice é dividido por seu w antes de ser olhado.

## Casos

object-triangle-uv = coordenadas de textura
case-triangles-left =
    { $triangles ->
        [one] Sobra { $triangles } triângulo.
       *[other] Sobram { $triangles } triângulos.
    }
case-triangles-none = Não sobra nada com área.
