### The lines lab: captions, watch table and controls.

## Said by several methods

line-opening = Que parte de P₁P₂ está na janela?
line-not-on-it = { $point }: fora de P₁P₂
line-parallel = É paralelo à { $edge }: não há interseção.
line-reject-edge = Rejeitado: os dois extremos estão além da { $edge }.
line-accept = Aceito: visível de { $p1 } a { $p2 }.
line-touch = Aceito: o segmento toca a janela em um único ponto, { $at }.
line-point = Aceito: os dois extremos são o mesmo ponto { $at }, e ele está na janela.
param-left = { $min } < { $max }: sobra uma parte.
param-touch = { $min } = { $max }: sobra um único ponto, e a borda conta como dentro.
param-empty = { $min } > { $max }: não sobra nada.
param-put-end = { $end } = { $at } já estava dentro e permanece.
watch-crossings = interseções
watch-crossings-used = úteis
table-edge = borda
table-polygon-edge = aresta
table-start = início
table-corner = canto

## Brute force

bf-intersect = Ache a interseção com a reta da { $edge }.
bf-keep = Nenhuma parte está além da { $edge }: esta interseção não era necessária.
bf-keep-parallel = Nenhuma parte está além da { $edge }: este lado não muda nada.
bf-cut = { $end } está além de { $border }: passa para { $to }.
bf-option-none = Nenhuma parte está além da { $edge }.
bf-option-one = Um extremo está além da { $edge }.
bf-option-both = Os dois extremos estão além da { $edge }.
bf-note-tests = Um ponto está dentro se cumpre as quatro condições.
bf-in-vain = desnecessária
bf-kept = { $part } é visível
code-bf-each = para cada lado não paralelo a P₁P₂
code-bf-intersect = X ← reta P₁P₂ ∩ reta do lado
code-bf-reject = se ambos além dele: rejeite
code-bf-cut = se um além dele: extremo ← X
code-bf-accept = aceite P₁P₂
words-bf-each = Tome os quatro lados, um de cada vez; pule o que for paralelo ao segmento.
words-bf-intersect = Calcule onde a reta do segmento encontra a reta do lado.
words-bf-reject = Se os dois extremos estão além do lado, nada é visível.
words-bf-cut = Se só um está além dele, leve esse extremo até a interseção.
words-bf-accept = O que sobra é visível.

## Cohen–Sutherland

cs-code = { $end } está { $region }: { $code } = { $bits }.
cs-or-accept = OR = { $bits }: os dois extremos estão dentro.
cs-or-open = OR = { $bits } ≠ 0000: nem tudo está dentro.
cs-and-reject = AND = { $bits } ≠ 0000: os dois extremos estão além da { $edge }.
cs-and-open = AND = { $bits }: nenhum lado deixa os dois extremos de fora. Os códigos não decidem.
cs-choose = O último bit 1 é o da { $edge }: { $end } está além dela.
cs-cut = { $end } é cortado em { $border }.
cs-reject = Rejeitado: os dois extremos estão { $region }; AND = { $and }.
cs-reject-two = Rejeitado: os dois extremos estão fora da janela.
cs-option-inside = Os dois extremos estão dentro.
cs-option-not-inside = Nem tudo está dentro.
cs-option-undecided = Nenhum lado deixa os dois extremos de fora.
cs-option-beyond = Os dois extremos estão além de um mesmo lado.
cs-note-code = Cada 1 indica um lado além do qual o ponto está.
cs-note-order = Na ordem superior, inferior, direita, esquerda, o código é { $other }.
cs-note-or = OR põe um 1 onde algum dos dois códigos o tem.
cs-note-and = AND mantém um 1 só onde os dois códigos o têm.
cs-cuts = corte
cs-this-order = esta ordem:
cs-usual-order = ordem usual:
code-cs-codes = code₁ ← code(P₁); code₂ ← code(P₂)
code-cs-loop = repita
code-cs-accept = se code₁ OR code₂ = 0: aceite
code-cs-reject = se code₁ AND code₂ ≠ 0: rejeite
code-cs-choose = lado ← último bit 1 de code₁ OR code₂
code-cs-end = P ← o extremo cujo código tem esse bit
code-cs-cut = P ← P₁P₂ ∩ lado
code-cs-recode = código de P ← code(P)
words-cs-codes = Dê um código a cada extremo: um bit 1 para cada lado além do qual ele está.
words-cs-loop = Repita:
words-cs-accept = Se nenhum dos códigos tem bit 1, tudo o que sobrou é visível.
words-cs-reject = Se os códigos têm um bit 1 em comum, os dois extremos estão além do mesmo lado.
words-cs-choose = Senão, tome o lado do último bit 1, o menos significativo.
words-cs-end = Exatamente um extremo está além dele.
words-cs-cut = Leve esse extremo até onde o segmento cruza o lado.
words-cs-recode = Dê a ele um novo código.
alg-faulty-looks-once = Errado: só um corte é feito
faulty-looks-once-differs = O passo { $step } é o primeiro que difere: depois de um corte, o programa aceita o que sobra, diga o que disser o novo código.
code-faulty-looks-once = se já há um corte ou code₁ OR code₂ = 0: aceite
words-faulty-looks-once = Se nenhum dos códigos tem bit 1, ou um extremo já foi cortado, tudo o que sobrou é visível.
alg-faulty-two-outside = Errado: dois extremos de fora são rejeitados
faulty-two-outside-differs = O passo { $step } é o primeiro que difere: nenhum código é 0, e o programa rejeita, embora nenhum lado deixe os dois extremos de fora.
code-faulty-two-outside = se code₁ ≠ 0 e code₂ ≠ 0: rejeite
words-faulty-two-outside = Se cada código tem um bit 1, os dois extremos estão fora, e nada é visível.
settings-bit-order = Ordem dos bits
bit-order-tbrl = superior, inferior, direita, esquerda
bit-order-lrbt = esquerda, direita, inferior, superior

## Liang–Barsky

lb-delta = P(u) = P₁ + u (P₂ − P₁): ao longo do segmento, x varia Δx e y varia Δy.
lb-row = k = { $k } ({ $edge }): u · p ≤ q, { $direction }.
lb-parallel-inside = É paralelo à { $edge } e está do lado de dentro: este lado, sozinho, não decide nada.
lb-parallel-outside = É paralelo à { $edge } e está do lado de fora: nenhum u serve.
lb-parallel-forgotten = É paralelo à { $edge }: o programa segue sem verificar nada.
lb-enter = A reta entra pela { $edge }: u_min sobe.
lb-enter-idle = A reta entra pela { $edge }, mas não depois de u_min: nada muda.
lb-leave = A reta sai pela { $edge }: u_max desce.
lb-leave-idle = A reta sai pela { $edge }, mas não antes de u_max: nada muda.
lb-put = { $end } vai para u = { $u }, em { $border }.
lb-reject = Rejeitado na { $edge }: não sobra nada do segmento.
lb-note-enter = p < 0, entra: { $bound } = max({ $bound }; r)
lb-note-leave = p > 0, sai: { $bound } = min({ $bound }; r)
lb-note-parallel = p = 0: paralelo; dentro se q ≥ 0
code-lb-start = u_min ← 0; u_max ← 1; Δ ← P₂ − P₁
code-lb-each = para cada k = 1 … 4: p, q do lado k
code-lb-parallel = se p = 0 e q < 0: rejeite
code-lb-enter = se p < 0: u_min ← max(u_min; q/p)
code-lb-leave = se p > 0: u_max ← min(u_max; q/p)
code-lb-empty = se u_min > u_max: rejeite
code-lb-accept = aceite P(u_min) P(u_max)
words-lb-start = Comece com o segmento inteiro, u de 0 a 1.
words-lb-each = Para cada lado, escreva “dentro” como uma desigualdade u · p ≤ q.
words-lb-parallel = p = 0: o segmento é paralelo ao lado; se está do lado de fora, rejeite.
words-lb-enter = p < 0: a reta entra por aqui. Antes de q/p, nada pode ser visível.
words-lb-leave = p > 0: a reta sai por aqui. Depois de q/p, nada pode ser visível.
words-lb-empty = Se o intervalo é vazio, nada é visível.
words-lb-accept = Senão, os extremos do intervalo são os da parte visível.
alg-faulty-parallel = Errado: p = 0 não é verificado
faulty-parallel-differs = O passo { $step } é o primeiro que difere: p = 0 e q < 0, então o segmento está fora deste lado, mas o programa segue adiante.
code-faulty-parallel = se p = 0: próximo lado
words-faulty-parallel = p = 0: o segmento é paralelo ao lado; passe ao próximo lado.

## Cyrus–Beck

cb-edge-entering = { $edge }: n·D > 0, a reta entra.
cb-edge-leaving = { $edge }: n·D < 0, a reta sai.
cb-edge-parallel = { $edge }: n·D = 0, a reta é paralela à aresta.
cb-parallel-inside = É paralelo a { $edge } e está do lado de dentro: esta aresta, sozinha, não decide nada.
cb-parallel-outside = É paralelo a { $edge } e está do lado de fora: nenhum t serve.
cb-enter = A reta entra por { $edge }: t_min sobe.
cb-enter-idle = A reta entra por { $edge }, mas não depois de t_min: nada muda.
cb-leave = A reta sai por { $edge }: t_max desce.
cb-leave-idle = A reta sai por { $edge }, mas não antes de t_max: nada muda.
cb-put = { $end } vai para t = { $t }, em { $edge }.
cb-reject = Rejeitado em { $edge }: não sobra nada do segmento.
cb-sign-enters = { $product } > 0: a reta entra
cb-sign-leaves = { $product } < 0: a reta sai
cb-sign-parallel = { $product } = 0: a reta é paralela
cb-sign-inside = { $product } > 0: { $end } está dentro
cb-sign-on = { $product } = 0: { $end } está na aresta
cb-sign-outside = { $product } < 0: { $end } está fora
cb-measured = Medido ao longo de { $normal }, a partir da aresta
alg-faulty-normals = Errado: todas as normais apontam para fora
faulty-normals-differs = O passo { $step } é o primeiro que difere: a normal aponta para fora, e entrar é tomado por sair.
code-cb-start = t_min ← 0; t_max ← 1; D ← P₂ − P₁
code-cb-each = para cada aresta: n; w ← P₁ − E
code-cb-parallel = se n·D = 0 e n·w < 0: rejeite
code-cb-enter = se n·D > 0: t_min ← max(t_min; −n·w / n·D)
code-cb-leave = se n·D < 0: t_max ← min(t_max; −n·w / n·D)
code-cb-empty = se t_min > t_max: rejeite
code-cb-accept = aceite P(t_min) P(t_max)
words-faulty-normals = Para cada aresta, gire-a para a esquerda e tome-a como normal, seja qual for o sentido dos vértices.
words-cb-start = Comece com o segmento inteiro, t de 0 a 1.
words-cb-each = Para cada aresta, tome a normal, que aponta para dentro.
words-cb-parallel = n·D = 0: paralelo à aresta; se está do lado de fora, rejeite.
words-cb-enter = n·D > 0: no sentido da normal; a reta entra por aqui.
words-cb-leave = n·D < 0: contra a normal; a reta sai por aqui.
words-cb-empty = Se o intervalo é vazio, nada é visível.
words-cb-accept = Senão, os extremos do intervalo são os da parte visível.

## Nicholl–Lee–Nicholl

nln-region = { $end } está { $region }.
nln-option-region = { $end } está { $option }.
nln-side-enters = P₂ está { $turn } da reta que vai de P₁ a { $corner }: a { $first } é cruzada primeiro.
nln-side-meets = P₂ está { $turn } da reta que vai de P₁ a { $corner }: a { $first } é cruzada primeiro.
nln-side-leaves = P₂ está { $turn } da reta que vai de P₁ a { $corner }: sai pela { $first }.
nln-side-through = P₂ está na reta que vai de P₁ a { $corner }: os dois lados são cruzados ao mesmo tempo.
nln-option-side = A reta que vai de P₁ a { $corner }: P₂ está { $option }.
nln-miss = Rejeitado: o segmento passa por fora de { $corner }, além da { $edge }.
nln-sector-inside = Os dois extremos estão dentro: nenhuma interseção é necessária.
nln-sector-enters = Entra pela { $enters }, e P₂ está dentro: uma interseção.
nln-sector-leaves = P₁ está dentro; sai pela { $leaves }: uma interseção.
nln-sector-both = Entra pela { $enters }, sai pela { $leaves }: duas interseções, ambas úteis.
nln-question-enters = por onde entra
nln-question-meets = se entra
nln-question-leaves = por onde sai
nln-note-products = A partir do canto: P₁ = (a₁; b₁), P₂ = (a₂; b₂)
turn-left = à esquerda
turn-through = sobre ela
turn-right = à direita
watch-region-1 = região de P₁
watch-region-2 = região de P₂
watch-enters = entra por
watch-leaves = sai por
code-nln-regions = região de P₁, região de P₂
code-nln-shared = se ambos além de um mesmo lado: rejeite
code-nln-enters = se P₁ em canto: reta do canto → entra por
code-nln-meets = se P₂ além do vizinho e não entra: rejeite
code-nln-leaves = se P₂ em canto: reta do canto → sai por
code-nln-cut = P₁, P₂ ← uma ou duas interseções
words-nln-regions = Encontre a região de cada extremo.
words-nln-shared = Se os dois estão além do mesmo lado, nada é visível.
words-nln-enters = Se P₁ está em uma região de canto, a reta de P₁ a esse canto diz por qual lado o segmento entra.
words-nln-meets = Se P₂ está além de um lado vizinho, a reta de P₁ ao canto comum diz se o segmento chega a encontrar a janela.
words-nln-leaves = Se P₂ está em uma região de canto, a reta de P₁ a esse canto diz por qual lado ele sai.
words-nln-cut = Calcule só essas interseções.

## Handles, by name

handle-end = { $end }
handle-segment = o segmento
handle-window = a janela
handle-side = { $edge }
handle-corner-bottom-left = o canto inferior esquerdo
handle-corner-bottom-right = o canto inferior direito
handle-corner-top-left = o canto superior esquerdo
handle-corner-top-right = o canto superior direito
handle-vertex = vértice { $number }

## The scene

action-add-segment = Adicionar um segmento
action-remove-segment = Remover o segmento
batch-title = Segmentos aleatórios
batch-count = Quantos
batch-seed = Semente
batch-again = Outro conjunto, com a semente seguinte
batch-make = Substituir todos os segmentos

## Costs, measured

cost-measure = Medir neste computador…
cost-of-all-segments = { $count ->
        [1] o segmento ({ $count })
       *[other] os { $count } segmentos
    }: divisões { $divisions }, multiplicações { $multiplications }, somas { $additions }, comparações { $comparisons }
measure-title = Quanto custa um segmento
measure-about = Todos os métodos recortam os mesmos segmentos aleatórios, aqui e agora.
measure-start = Medir
measure-again = Medir de novo
measure-nanos = Nanossegundos
measure-operations = Operações
measure-batch = Em lote, sem desvios
measure-note = Por segmento, na média de { $count }. O tempo é o da mais rápida de cinco passagens.

## The verdict

verdict-part-dropped = Este passo descarta a parte do segmento de { $from } a { $to }.
verdict-line-between = A reta entra ({ $enters }) só depois de ter saído ({ $leaves }).
verdict-line-in = Deslocado { $move } para dentro, na perpendicular à borda ({ $edge }), seria visível.
verdict-line-back = Deslocado { $move } para fora, na perpendicular à borda ({ $edge }), seria visível.
verdict-line-never = Nenhum deslocamento na perpendicular à borda ({ $edge }) o tornaria visível.
verdict-line-out = Deslocado mais de { $move } para fora, na perpendicular à borda mais próxima ({ $edge }), desapareceria.
verdict-line-touch = Apenas toca a borda ({ $edge }): com o menor deslocamento para fora desapareceria.
