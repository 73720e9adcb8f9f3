### O que se diz onde triângulos no espaço são cortados: plano a plano, como um só polígono, antes da divisão.

## Métodos

alg-plane-at-a-time = Plano a plano
alg-intersection-polygon = Um só polígono, em leque no fim
alg-textured-triangle = Um só polígono com textura
alg-homogeneous-triangle = Triângulo antes da divisão
alg-faulty-missed-edge = Errado: com d₀ = 0 o triângulo fica inteiro
alg-faulty-on-plane = Errado: sobre o plano conta como fora
alg-faulty-kept-uv = Errado: (u, v) não é interpolado
alg-undivided-texture = Errado: uma textura sem a divisão
alg-faulty-edge-by-edge = Errado: cada aresta como um segmento
alg-faulty-all-sides = Errado: todos os seis lados recortam
alg-faulty-divided-triangle = Errado: o triângulo é dividido primeiro

## Vistas

tri-list-in = Lista de entrada
tri-list-out = Lista de saída
tri-list-given = Triângulo
tri-list-left = O que sobra
tri-corners = vértices
tri-none = não há triângulo
tri-not-asked = não testado
tri-list-fan = Leque a partir de V₀: { $vertices } − 2 = { $triangles ->
        [1] { $triangles } triângulo
       *[other] { $triangles } triângulos
    }
tally-triangles = triângulos
tally-crossings = interseções
tally-one-polygon = um só polígono
tally-one-by-one = triângulo a triângulo
tally-same = Os dois métodos deixam { $n ->
        [1] o mesmo vértice ({ $n })
       *[other] os mesmos { $n } vértices
    }, até { $decimals } casas decimais.

## Um só polígono

ip-opening = Um polígono é recortado por { $planes ->
        [1] { $planes } plano
       *[other] { $planes } planos
    }: sua lista começa com os { $n ->
        [1] { $n } vértice
       *[other] { $n } vértices
    } do triângulo.
ip-plane = O plano { $plane } recebe uma lista de { $n ->
        [1] { $n } vértice.
       *[other] { $n } vértices.
    }
ip-first-inside = { $vertex } está do lado de dentro do plano { $plane }: é emitido.
ip-first-outside = { $vertex } está do lado de fora do plano { $plane }: não é emitido.
ip-touch = { $from } → { $to }: { $rule }. O extremo que está sobre o plano é a própria interseção.
ip-in-out = { $from } → { $to }: dentro → fora. Emite-se a interseção { $cut }.
ip-out-in = { $from } → { $to }: fora → dentro. Emitem-se a interseção { $cut } e depois { $to }.
ip-closing-cross = A aresta de fechamento { $from } → { $to }: { $rule }. Emite-se só a interseção { $cut }.
ip-cross = { $from } → { $to } corta o plano { $plane } em { $cut }.
ip-output = { $vertex } vai para a lista de saída, que agora tem { $n ->
        [1] { $n } vértice.
       *[other] { $n } vértices.
    }
ip-pass-cuts = O plano { $plane } retira { $dropped } e acrescenta { $cuts }: { $before } → { $after }.
ip-pass-drops = O plano { $plane } retira { $dropped }: { $before } → { $after }.
ip-pass-same = O plano { $plane } não corta nada: { $before } → { $after }.
ip-pass-empty = O plano { $plane } não deixa nada: { $before } → { $after }.
ip-fan = Triângulo { $n } de { $total } do leque: { $corners }.
ip-done = Pronto: { $vertices ->
        [1] { $vertices } vértice
       *[other] { $vertices } vértices
    }, um leque de { $n ->
        [1] { $n } triângulo
       *[other] { $n } triângulos
    }. Interseções calculadas: { $crossings }.
ip-done-empty = Pronto: não sobra nada com área. Triângulos: { $n }; vértices: { $vertices }; interseções calculadas: { $crossings }.
code-ip-each = para cada plano (n, D):
code-ip-first = se d(V₀) ≥ 0: emita V₀
code-ip-distance = para cada aresta S → P: d ← n·P + D
code-ip-inside = se d ≥ 0 e P ≠ V₀: emita P
code-ip-cross = onde o lado muda: emita C
code-ip-pass = lista ← o que foi emitido
code-ip-fan = triângulos ← leque da lista
words-ip-each = Teste cada plano por vez; sua normal aponta para dentro.
words-ip-first = Emita o primeiro vértice se ele está dentro; a borda conta como dentro.
words-ip-distance = Siga as arestas, a última de volta a V₀, e calcule a distância com sinal de cada fim.
words-ip-inside = Depois emita o fim, se está dentro; V₀ já está na lista.
words-ip-cross = Onde uma aresta passa de um lado ao outro, emita a sua interseção: t = d₁ / (d₁ − d₂).
words-ip-pass = O que foi emitido é a lista para o plano seguinte.
words-ip-fan = O polígono convexo é dividido em triângulos uma só vez, no fim.

## Triângulo a triângulo

pat-opening = Cada triângulo é recortado por { $planes ->
        [1] { $planes } plano
       *[other] { $planes } planos, um após o outro
    }: a lista começa com { $n ->
        [1] { $n } triângulo.
       *[other] { $n } triângulos.
    }
pat-plane =
    { $n ->
        [1] O plano { $plane } recebe { $n } triângulo.
       *[other] O plano { $plane } recebe { $n } triângulos.
    }
pat-three = { $triangle }: { $inside } vértices do lado de dentro do plano { $plane }. É mantido inteiro.
pat-two = { $triangle }: { $inside } vértices do lado de dentro do plano { $plane }. Sobra um quadrilátero: dois triângulos.
pat-one = { $triangle }: { $inside } vértice do lado de dentro do plano { $plane }. Sobra um triângulo.
pat-on = { $triangle }: { $inside } de 3 vértices do lado de dentro do plano { $plane }. Sobre o plano: { $on }.
pat-none = { $triangle }: { $inside } vértices do lado de dentro do plano { $plane }. É descartado.
pat-option-three = Os três vértices de { $triangle } estão dentro.
pat-option-two = Dois vértices de { $triangle } estão dentro.
pat-option-one = Um vértice de { $triangle } está dentro.
pat-option-none = Nenhum vértice de { $triangle } está dentro.
pat-piece = Triângulo { $n } da lista de saída: { $corners }.
pat-pass =
    { $after ->
        [1] O plano { $plane } recebeu { $before } e entrega { $after } triângulo.
       *[other] O plano { $plane } recebeu { $before } e entrega { $after } triângulos.
    }
pat-pass-empty = O plano { $plane } recebeu { $before } e entrega { $after }: não sobra nada.
pat-done = Pronto: { $n ->
        [1] sobra { $n } triângulo,
       *[other] sobram { $n } triângulos,
    } após { $crossings ->
        [1] { $crossings } interseção.
       *[other] { $crossings } interseções.
    }
pat-done-empty = Pronto: { $n ->
        [1] sobra { $n } triângulo,
       *[other] sobram { $n } triângulos,
    } após { $crossings ->
        [1] { $crossings } interseção.
       *[other] { $crossings } interseções.
    }
code-pat-each = para cada plano (n, D):
code-pat-triangle = para cada triângulo: conte d ≥ 0
code-pat-three = 3: mantenha
code-pat-two = 2: corte; dois triângulos
code-pat-one = 1: corte; um triângulo
code-pat-none = 0: descarte
code-pat-pass = lista ← o que foi mantido
words-pat-each = Teste cada plano por vez; sua normal aponta para dentro.
words-pat-triangle = Quantos vértices do triângulo estão dentro?
words-pat-three = Se estão os três, ele é mantido inteiro.
words-pat-two = Se estão dois, sobra um quadrilátero, dividido a partir do seu primeiro vértice.
words-pat-one = Se está um, sobra um triângulo menor.
words-pat-none = Se não está nenhum, ele é descartado.
words-pat-pass = Os triângulos mantidos são a lista para o plano seguinte.

## Antes da divisão

ht-opening = Há { $n } vértices no espaço de recorte, { $behind } deles com w ≤ 0: ainda não se divide nada.
ht-divide = Os { $n } vértices são divididos por seu w.
ht-codes-outside = Todos os vértices estão além de um mesmo lado: rejeitado sem recortar; lados com algum bit 1: { $sides }.
ht-codes-inside = Nenhum vértice está além de lado algum: mantido inteiro; lados com algum bit 1: { $sides }.
ht-codes-cut =
    { $sides ->
        [1] Só { $sides } dos seis lados tem algum bit 1: só esse recorta.
       *[other] Só { $sides } dos seis lados têm algum bit 1: só esses recortam.
    }
ht-side = O plano { $side } recebe { $n ->
        [1] { $n } vértice:
       *[other] { $n } vértices:
    } basta o sinal de uma soma, sem divisão.
ht-inside = { $vertex } está do lado de dentro do plano { $side }.
ht-outside = { $vertex } está do lado de fora do plano { $side }.
ht-cross = { $from } → { $to } corta o plano { $side } em I.
ht-pass = O plano { $side } terminou: { $before } → { $n }.
ht-done = { $n ->
        [1] Sobra { $n } vértice
       *[other] Sobram { $n } vértices
    }, um leque de { $triangles ->
        [1] { $triangles } triângulo
       *[other] { $triangles } triângulos
    }: agora podem ser divididos por w.
ht-done-empty = Não sobra nada com área. Vértices: { $n }; triângulos: { $triangles }.
code-ht-codes = seis bits por vértice: w ± x, y, z < 0
code-ht-decide = OR = 0: mantenha; AND ≠ 0: rejeite
code-ht-each = para cada lado com bit 1 no OR:
code-ht-first = se w ± x ≥ 0 em V₀: emita V₀
code-ht-bound = para cada aresta S → P: w ± x de P
code-ht-cross = onde muda de sinal: emita I
code-ht-inside = se w ± x ≥ 0 e P ≠ V₀: emita P
code-ht-fan = leque, depois divida por w
words-ht-codes = Dê a cada vértice um bit para cada lado de −w ≤ x, y, z ≤ w além do qual ele está.
words-ht-decide = Ou não há nada a recortar, ou não há nada a ver.
words-ht-each = Só é preciso testar os lados além dos quais está algum vértice.
words-ht-bound = O teste é o sinal de uma soma: sem divisão, e com w de qualquer sinal.
words-ht-cross = As quatro coordenadas são interpoladas com o mesmo t.
words-ht-fan = O que sobra tem w ≥ near > 0 e pode ser dividido por w.

## O que está errado aqui?

faulty-missed-edge-differs = O passo { $step } é o primeiro que difere: com d₀ = 0 nenhum produto é negativo, e o triângulo ficou inteiro.
faulty-on-plane-differs = O passo { $step } é o primeiro que difere: um vértice sobre o plano foi tomado por externo.
faulty-kept-uv-differs = O passo { $step } é o primeiro que difere: a interseção manteve o (u, v) do vértice externo.
faulty-edge-by-edge-differs = O passo { $step } é o primeiro que difere: cada aresta é recortada por si, não como parte do contorno.
faulty-all-sides-differs = O passo { $step } é o primeiro que difere: testa-se um lado que não tem nenhum bit 1, e que não corta nada.
faulty-divided-triangle-differs = O passo { $step } é o primeiro que difere: os vértices foram divididos por w antes de qualquer recorte.
code-faulty-missed-edge = se d₀·d₁ < 0 ou d₀·d₂ < 0: corte
words-faulty-missed-edge = Corta-se só onde a primeira distância e outra diferem em sinal.
code-faulty-on-plane = se d > 0 e P ≠ V₀: emita P
code-faulty-on-plane-first = se d(V₀) > 0: emita V₀
words-faulty-on-plane-first = Emita o primeiro vértice se ele está estritamente dentro.
words-faulty-on-plane = Depois emita o fim, se está estritamente dentro.
code-faulty-kept-uv = emita C, uv(C) ← uv(V)
words-faulty-kept-uv = A interseção toma o (u, v) do vértice que substitui.
code-undivided-texture = leque, preencha: uv linear na tela
words-undivided-texture = O polígono é dividido em leque; na tela (u, v) é interpolado sem 1/w.
code-faulty-edge-by-edge = para cada plano: recorte cada aresta
words-faulty-edge-by-edge = Teste cada plano por vez; ele recorta as três arestas como três segmentos.
code-faulty-all-sides = para cada um dos seis lados:
words-faulty-all-sides = Testam-se os seis lados, um após o outro.
code-faulty-divided-triangle = (x, y, z) ← (x, y, z)/w; depois seis bits
words-faulty-divided-triangle = Cada vértice é dividido por seu w antes de ser testado.

## Casos

object-triangle-uv = coordenadas de textura
case-triangles-left =
    { $triangles ->
        [1] Sobra { $triangles } triângulo.
       *[other] Sobram { $triangles } triângulos.
    }
case-triangles-none = Não sobra nada com área.
