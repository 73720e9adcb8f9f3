### Why something is refused, or fails: one sentence for each typed error, whoever reports it.

## Shapes; the last part of the key is the code in the command line’s JSON where that has one

error-not-finite = Todas as coordenadas devem ser números finitos.
error-empty-window = A janela está vazia: { $low } = { $min } deve ser menor que { $high } = { $max }.
error-too-few-vertices = Um polígono precisa de pelo menos três vértices.
error-degenerate = A figura é degenerada: não tem comprimento ou área onde precisa.
error-not-convex = O polígono de recorte deve ser convexo: este algoritmo conserva o que fica do lado interno de todas as arestas.
error-self-intersecting = O polígono cruza a si mesmo.
error-edges-meet = O contorno não pode tocar nem cruzar a si mesmo: as arestas { $first } e { $second } se cruzam, se tocam ou se sobrepõem.
error-misplaced-hole = O furo { $hole } deve ficar dentro do contorno, sem tocá-lo nem tocar qualquer outro furo.
error-at = { $place }: { $problem }

## Shapes in space

error-empty-box = A caixa está vazia: { $low } = { $min } não pode ser maior que { $high } = { $max }.
error-zero-normal = Um plano precisa de um vetor normal diferente de zero.
error-negative-radius = Um raio não pode ser negativo, mas este é { $radius }.
error-no-vertices = Sem vértices não há volume envolvente.
error-target-at-position = A câmera não tem direção: está no mesmo ponto para o qual olha.
error-up-along-view = O vetor “para cima” da câmera não pode ser zero, e não pode ser paralelo à direção de visão.
error-field-of-view = O campo de visão deve ficar entre 0° e 180°, sem incluí-los, mas é { $degrees }°.
error-size = Um tamanho deve ser maior que 0, mas este é { $size }.
error-height = A altura do volume de visão deve ser maior que 0, mas é { $height }.
error-aspect = A razão de aspecto, largura por altura, deve ser maior que 0 e deixar largura ao volume de visão, mas é { $aspect }.
error-near = O plano próximo deve ficar à frente do olho, a uma distância maior que 0, mas está a { $near }.
error-far = O plano distante deve ficar além do plano próximo: far = { $far } deve ser maior que near = { $near }.
error-not-affine = A última linha desta matriz deve ser 0 0 0 1.
error-face-vertex = A face { $face }, contando a partir de 0, cita um vértice que não existe.
error-no-mesh-faces = Uma malha precisa de pelo menos uma face.
error-uv-length = Uma malha precisa de tantas coordenadas de textura quantos vértices, ou de nenhuma. Coordenadas de textura: { $uvs }; vértices: { $vertices }.

## Scenes

error-no-objects = Uma cena precisa de pelo menos um objeto.
error-too-many-objects = Uma cena aceita no máximo { $limit } objetos, mas há { $count }.
error-no-such-object = Não há objeto { $focus }; objetos da cena: { $count }.
error-no-such-face = Não há face { $face }; faces do objeto: { $count }.
error-no-such-vertex = Não há vértice { $vertex }; vértices do objeto: { $count }.
error-no-segments = Não há nenhum segmento.
error-too-many-segments = Há segmentos demais: { $count }; são aceitos no máximo { $limit }.
error-no-such-focus =
    { $count ->
        [1] Não existe o segmento { $focus }: há { $count } segmento, contando a partir de 0.
       *[other] Não existe o segmento { $focus }: há { $count } segmentos, contando a partir de 0.
    }
error-last-three = O vértice é mantido: um polígono precisa de pelo menos três.
error-too-many-vertices = Há vértices demais: { $count }; são aceitos no máximo { $limit }.

## Moments of a run

error-bad-moment = Isto não nomeia nenhum momento.

## Files

error-unreadable = Não é possível ler o arquivo: { $reason }.
error-file-too-large = O arquivo tem mais de { $limit } MiB.
error-link-out = O arquivo é um link que leva para fora da pasta da lição.
memory-broken = Não é um arquivo de ajustes.

## What the system answers; set after a colon, in the middle of a sentence

system-not-found = não existe esse arquivo ou pasta
system-denied = não há permissão
system-exists = já existe
system-is-folder = é uma pasta
system-not-file = não é um arquivo
system-not-folder = uma parte do caminho não é uma pasta
system-full = o disco está cheio
system-read-only = o disco é somente leitura
system-bad-name = o nome não é válido
system-too-large = o arquivo é grande demais
system-busy = outro programa o está usando
system-no-files = aqui não há arquivos
system-loop = é um link que leva a si mesmo
system-number = o sistema relata o erro { $number }
system-silent = o sistema não dá nenhum motivo
error-typed-range = era esperado um número de { $least } a { $most }, mas foi digitado { $typed }
error-typed-place = { $count ->
    [1] era esperado um número
   *[other] eram esperados { $count } números
}, como −1,5 ou 1/4, mas foi digitado { $typed }

error-progress-broken = Este arquivo não é de progresso.
error-progress-version = Este arquivo é de uma versão posterior do Clipscope.
