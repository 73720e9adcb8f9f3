### What is said of segments in space: six-bit codes, inequalities, and clipping before the divide.

## Methods

alg-cohen-sutherland-3d = Cohen–Sutherland no espaço
alg-liang-barsky-3d = Liang–Barsky no espaço
alg-plane-line = Segmento contra planos
alg-homogeneous-line = Segmento antes da divisão
alg-faulty-divide-first = Errado: dividido primeiro

## What is asked, and what comes of it

space-line-opening-box = Que parte de P₁P₂ está na caixa de −1 a 1?
space-line-opening-planes =
    Que parte de P₁P₂ está do lado de dentro { $planes ->
        [1] do plano
       *[other] dos { $planes } planos
    }?
space-line-opening-clip = Que parte de P₁P₂ satisfaz −w ≤ x, y, z ≤ w?
space-line-touch = Aceito: toca em um único ponto, { $at }.
space-line-point = Aceito: os dois extremos são o mesmo ponto { $at }, e ele está dentro.

## Six-bit codes

space-line-code-inside = { $end } está dentro: { $code } = { $bits }.
space-line-code-one = { $end } está além do plano { $first }: { $code } = { $bits }.
space-line-code-two = { $end } está além de dois planos, o { $first } e o { $second }: { $code } = { $bits }.
space-line-code-three = { $end } está além de três planos: o { $first }, o { $second } e o { $third }; { $code } = { $bits }.
space-line-or-accept = OR = { $bits }: os dois extremos estão dentro.
space-line-or-open = OR = { $bits } ≠ 000000: nem tudo está dentro.
space-line-and-open = AND = { $bits }: nenhuma face deixa os dois extremos de fora. Os códigos não decidem.
space-line-and-reject = AND = { $bits } ≠ 000000: os dois extremos estão além do plano { $plane }.
space-line-choose = O último bit 1 é o do plano { $plane }: { $end } está além dele.
space-line-reject-codes = Rejeitado: os dois extremos estão além do plano { $plane }; AND = { $and }.
space-line-note-code = Cada 1 indica uma face além da qual o ponto está.

## One inequality a plane

space-line-delta = P(u) = P₁ + u (P₂ − P₁): ao longo do segmento, x, y e z variam Δx, Δy e Δz.
space-line-before = Os dois extremos têm w ≥ 0: nenhum está atrás do olho.
space-line-behind = { $end } tem w < 0: está atrás do olho e não se deve dividi-lo por w.
space-line-all-behind = Os dois extremos têm w < 0: todo o segmento está atrás do olho.
space-line-option-behind = Um extremo tem w < 0.
space-line-divided = Os dois extremos são divididos por w e recortados depois.
space-line-row = Plano { $plane }: { $direction }.
space-line-parallel-inside = É paralelo ao plano { $plane } e está do lado de dentro: este plano, sozinho, não decide nada.
space-line-parallel-outside = É paralelo ao plano { $plane } e está do lado de fora: nada pode ser visível.
space-line-enter = A reta entra pelo plano { $plane }: { $bound } sobe.
space-line-enter-idle = A reta entra pelo plano { $plane }, mas não depois de { $bound }: nada muda.
space-line-leave = A reta sai pelo plano { $plane }: { $bound } desce.
space-line-leave-idle = A reta sai pelo plano { $plane }, mas não antes de { $bound }: nada muda.
space-line-put = { $end } vai para { $symbol } = { $u }, em { $border }.
space-line-the-plane = o plano { $plane }
space-line-reject = Rejeitado no plano { $plane }: não sobra nada do segmento.
space-line-reject-behind = Rejeitado: nenhum ponto está à frente do olho.
space-line-note-enter = { $first } < { $second }, entra: { $bound } = max({ $bound }; { $crossing })
space-line-note-leave = { $first } > { $second }, sai: { $bound } = min({ $bound }; { $crossing })

## The w-lens

w-lens-eye = olho
w-lens-screen = tela, w = 1
screen-divide-first = Dividir primeiro
screen-clip-first = Recortar primeiro
screen-wrong = errado: uma parte que nunca existiu
screen-same = o mesmo: nenhum extremo está atrás do olho
screen-no-image = um extremo não tem imagem: w = 0
screen-so-far = o que resta até agora
screen-right = certo: o que está à frente do olho
screen-nothing = nada se vê

## Cases

case-no-point = (0; 0; 0; 0) não é um ponto do espaço de recorte.
case-flat-box = A caixa não tem interior: { $low } e { $high } são ambos { $at }.

## Pseudocode

code-lb3-each = para cada face k = 1 … 6: p, q
words-lb3-each = Para cada uma das seis faces, escreva “dentro” como uma desigualdade u · p ≤ q.
code-pl-start = a_min ← 0; a_max ← 1
code-pl-each = para cada plano (n, D): d₁ ← n·P₁ + D; d₂ ← n·P₂ + D
code-pl-parallel = se d₁ = d₂ e d₁ < 0: rejeite
code-pl-enter = se d₁ < d₂: a_min ← max(a_min; d₁/(d₁ − d₂))
code-pl-leave = se d₁ > d₂: a_max ← min(a_max; d₁/(d₁ − d₂))
code-pl-empty = se a_min > a_max: rejeite
code-pl-accept = aceite P(a_min) P(a_max)
words-pl-start = Comece com o segmento inteiro: a vai de 0 até 1.
words-pl-each = Calcule, para cada plano, quanto os dois extremos estão para dentro.
words-pl-enter = d cresce: a reta entra por aqui. Antes desse valor de a, nada pode ser visível.
words-pl-leave = d diminui: a reta sai por aqui. Depois desse valor de a, nada pode ser visível.
code-hl-start = se w₁ < 0 e w₂ < 0: rejeite
code-hl-each = para cada lado x, y, z = ±w: d₁, d₂ ← w ± x, y, z
code-hl-enter = se d₁ < d₂: t_min ← max(t_min; d₁/(d₁ − d₂))
code-hl-leave = se d₁ > d₂: t_max ← min(t_max; d₁/(d₁ − d₂))
code-hl-empty = se t_min > t_max: rejeite
code-hl-accept = aceite P(t_min) P(t_max); só agora divida por w
words-hl-start = Se os dois extremos estão atrás do olho, nada é visível.
words-hl-each = Para cada lado, w mais ou menos uma coordenada diz quanto um ponto está para dentro.
words-hl-enter = d cresce: a reta entra por aqui.
words-hl-leave = d diminui: a reta sai por aqui.
words-hl-accept = O que sobra tem w ≥ near > 0: agora se pode dividir por w.
code-faulty-divide = P₁ ← P₁ / w₁; P₂ ← P₂ / w₂
code-faulty-divide-accept = aceite P(t_min) P(t_max)
words-faulty-divide = Divida os dois extremos por w.
words-faulty-divide-accept = Os extremos do intervalo são tomados pelos da parte visível.
faulty-divide-first-differs = O passo { $step } é o primeiro que difere: os dois extremos foram divididos por w antes de recortar.
