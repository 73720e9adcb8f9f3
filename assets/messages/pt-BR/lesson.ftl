### The course panel and what it says about lesson files.

## Walking through the course

lesson-question = A pergunta
card-rule = Regra
card-formula = Fórmula
card-cost = Custo
card-pitfall = Cuidado
card-can = Agora você sabe
lesson-answer-show = Mostrar a resposta
lesson-answer-hide = Ocultar a resposta
lesson-changed = Esta é a sua cena. O texto fala da cena da lição.
lesson-has-changes = contém mudanças suas
lesson-contents = Todas as lições e a cena livre
lesson-to-control = Pressione para ver onde isto se ajusta.
lesson-restore = Restaurar a da lição
lesson-not-translated = Este texto ainda não foi traduzido.

## Lesson files

lesson-empty = O curso não tem lições.
lesson-error = erro
lesson-warning = aviso

## What is wrong with a lesson file; the last part of the key is the problem’s code

problem-toml = Isto não é TOML válido.
problem-toml-deep = Os valores estão aninhados fundo demais.
problem-toml-comma = Falta uma vírgula entre dois valores.
problem-toml-extra = Há uma “,” ou um “=” a mais.
problem-toml-number = Um número não pode ser escrito assim.
problem-toml-escape = Em um texto, este caractere não pode vir depois de “\”.
problem-toml-duplicate = Este nome aparece duas vezes.
problem-toml-value = Isto não é um valor.
problem-toml-no-value = Faltam “=” e um valor depois do nome.
problem-toml-name = Um nome não pode ter este caractere.
problem-toml-unclosed = Falta { $closer } para fechar.
problem-not-utf8 = O arquivo não é texto UTF-8: o byte { $byte } não pode estar aqui.
problem-course-file = Isto não é um curso empacotado: { $reason }
problem-course-version = O curso foi empacotado por outra versão do Clipscope: a versão { $version } não pode ser lida aqui.
problem-no-link = Isto não é um link do Clipscope.
problem-link-version = O link foi feito por outra versão do Clipscope: { $version } não pode ser lido aqui.
problem-link-damaged = O link foi cortado ou alterado: não é possível descompactar a cena dele.
problem-link-too-large = A cena do link é grande demais.
problem-link-value = “{ $value }” não faz sentido como valor de “{ $key }” em um link.
problem-link-no-lesson = O curso aberto não tem nenhuma lição para “{ $name }”.
problem-link-no-step = A lição não tem o passo “{ $name }”.
problem-picture-without-link = A imagem não traz nenhum link para um passo.
problem-no-lessons = Não há nenhuma lição aqui.
problem-too-many-lessons = Há mais de { $limit } lições: as demais ficam de fora.
problem-missing-file = Falta este arquivo.
problem-unknown-language = “{ $name }” não é um idioma do curso.
problem-missing-language = Não há texto neste idioma ({ $language }): o inglês é mostrado no lugar.
problem-unknown-field = Aqui não existe o campo “{ $name }”.
problem-missing-field = Falta o campo “{ $name }”.
problem-wrong-type = O valor é do tipo errado: é { $found }.
problem-wrong-length =
    { $count ->
        [1] A lista não tem o comprimento certo: { $count } valor.
       *[other] A lista não tem o comprimento certo: { $count } valores.
    }
problem-not-finite = Deve ser um número finito.
problem-out-of-range = { $value } está fora do intervalo permitido.
problem-empty-text = Este texto está vazio.
problem-two-kinds-of-segments = “segments” e “random” foram dados ao mesmo tempo: só pode haver um dos dois.
problem-two-kinds-of-polygons = “polygon” e “random” foram dados ao mesmo tempo: só pode haver um dos dois.
problem-two-kinds-of-objects = “objects” e “street” foram dados ao mesmo tempo: só pode haver um dos dois.
problem-too-many-beside = Métodos ao lado do primeiro: { $count }; cabem no máximo { $most }.
problem-too-few-places = Lugares dados aqui: { $count }.
problem-two-openings = “fov_y_deg” e “height” foram dados ao mesmo tempo: o primeiro é para a perspectiva, o segundo para uma câmera paralela.
problem-two-models = “solid” e “mesh” foram dados ao mesmo tempo: só pode haver um dos dois.
problem-two-meshes = “obj” e listas de números foram dados ao mesmo tempo: só pode haver um dos dois.
problem-no-picture = Isto não é uma imagem.
problem-mesh-plain = A malha é desenhada sem a sua textura.
problem-too-many-texels = As texturas deste arquivo têm { $count } texels no total, mais que { $limit }.
picture-elsewhere = “{ $name }” não está ao lado da malha.
picture-unread = “{ $name }”: { $reason }
picture-no-material = “{ $library }” não tem o material “{ $name }”.
picture-broken = “{ $name }” não é um PNG ou JPEG de no máximo { $most } texels por lado, ou está danificado.
problem-mesh-too-large = A lista tem { $count } itens; um arquivo de cena aceita no máximo { $limit }.
problem-no-such-mesh = Não há nenhuma malha “{ $name }” ao lado deste arquivo.
problem-unknown-method = Não existe o método “{ $name }”.
problem-unknown-lab = Não existe o laboratório “{ $name }”.
problem-unknown-control = O laboratório não tem nenhum controle “{ $name }”.
problem-unknown-scene = Não existe a cena “{ $name }”.
problem-unknown-lock = Não existe o ponto de controle “{ $name }”.
problem-unknown-value = “{ $name }” não é um valor deste campo.
problem-no-steps = A lição não tem passos.
problem-too-many-steps = A lição tem { $count } passos, mais que { $limit }.
problem-bad-step-id = “{ $name }” não pode ser o id de um passo.
problem-duplicate-step = Há dois passos “{ $name }”.
problem-bad-figure = “{ $name }” não pode ser o nome de uma figura.
problem-duplicate-figure = Há duas figuras “{ $name }”.
problem-moment-never-happens = O momento “{ $name }” nunca ocorre na execução desta cena.
problem-unused-scene = Nenhum passo mostra esta cena.
problem-bad-reference = Não é possível ler esta referência.
problem-reference-outside = O título de uma lição não admite referências.
problem-unknown-name = Nenhum valor se chama “{ $name }” neste passo.
problem-no-value = “{ $name }” não é um valor que caiba em uma frase.
problem-unknown-form = Um número não tem a forma “{ $name }”.
problem-like-itself = A cena “{ $name }” toma a si mesma como modelo.
problem-missing-title = O texto não tem título.
problem-second-title = Uma lição tem um só título, no início.
problem-bad-heading = Este cabeçalho não diz a que passo pertence.
problem-text-outside = Este texto não pertence a nenhum passo.
problem-unknown-step = A lição não tem nenhum passo “{ $name }”.
problem-missing-section = Falta o texto do passo “{ $name }”.
problem-duplicate-section = O passo “{ $name }” tem dois textos.
problem-empty-section = O passo “{ $name }” tem cabeçalho, mas não tem texto.
problem-long-paragraph = O parágrafo tem { $count } caracteres, mais que { $limit }.
problem-unsupported-markdown = Este tipo de Markdown não é aceito em uma lição.
problem-stray-emphasis = Estes asteriscos não deixam o texto em negrito.
problem-stale-translation = O inglês de “{ $name }” mudou desde que foi traduzido.
expect-translated = Traduza-o de novo e depois execute “clipscope check PASTA --translated”.
problem-stray-claim = Esta conclusão não está sob o título de um passo.
expect-claim = Escreva um parágrafo que comece com “=> ” logo abaixo do título “## id: Título”.
problem-stray-sides = A linha “=| … | …” não dá nome aos dois desenhos de um passo.
expect-sides = Abaixo da conclusão de um passo com `before`, escreva “=| ” e dois nomes separados por “ | ”: como era e como é.
problem-bad-card = Isto não é uma ficha.
expect-card = Escreva “## card” no fim do arquivo e, abaixo, uma lista: rule, formula, cost, pitfall duas ou mais vezes e can; por exemplo, “- rule: …”. Uma ficha não tem referências.
problem-stray-note = Esta nota para quem apresenta seria lida por todos.
problem-more =
    { $count ->
        [1] Mais { $count } problema deste arquivo não é mostrado.
       *[other] Mais { $count } problemas deste arquivo não são mostrados.
    }

## What was expected in its place

expect-did-you-mean = Você quis dizer “{ $name }”?
expect-one-of = Esperado: um de { $names }.
expect-toml-value = Esperado: texto entre aspas retas "", um número, true ou false, ou uma lista com vírgulas entre seus valores.
expect-toml-name = Esperado: as letras a–z e A–Z, algarismos, “-” e “_”.
expect-utf8 = Esperado: texto salvo como UTF-8.
expect-link = Esperado: “#lição/passo” ou “#v1=” e uma cena; antes pode vir um endereço.
expect-lesson-folder = Esperado: uma pasta com lesson.toml e en.md, ou uma pasta de pastas assim.
expect-text = Esperado: texto entre aspas.
expect-number = Esperado: um número.
expect-whole = Esperado: um número inteiro de { $min } a { $max }.
expect-table = Esperado: uma tabela de campos.
expect-window = Esperado: [xmin, ymin, xmax, ymax], com xmin < xmax e ymin < ymax.
expect-point = Esperado: os dois números de um ponto, [x, y].
expect-segment = Esperado: os quatro números de um segmento, [x1, y1, x2, y2].
expect-segments = Esperado: uma lista de segmentos, [[x1, y1, x2, y2], …], ou “random” com “count” e “seed”.
expect-clip = Esperado: pelo menos três vértices de um polígono convexo, [[x, y], …], em qualquer sentido.
expect-polygon = Esperado: pelo menos três vértices de um polígono, [[x, y], …].
expect-holes = Esperado: uma lista de furos, cada um com pelo menos três vértices, [[[x, y], …], …].
expect-place = Esperado: os três números de um lugar, [x, y, z].
expect-space-segment = Esperado: os dois extremos de um segmento, [[x, y, z], [x, y, z]].
expect-space-triangle = Esperado: os três vértices de um triângulo, [[x, y, z], [x, y, z], [x, y, z]].
expect-camera = Esperado: position, target, up, fov_y_deg (ou height), aspect, near e far, com 0 < near < far em perspectiva.
expect-eye = Esperado: pitch_deg de −89 a 89, distance de 1e-6 a 1e6, fov_y_deg de 1 a 120.
expect-objects = Esperado: uma lista de objetos, [{ "{" } solid = "cube", at = [x, y, z], size = 1 { "}" }, …], ou “street” com “count” e “seed”.
expect-mesh = Esperado: name, vertices [[x, y, z], …] e faces [[i, j, k], …], cujos índices contam a partir de 0; também pode haver uvs [[u, v], …], uma por vértice. No lugar das listas pode estar obj, o texto de um arquivo OBJ; picture é sua textura, um arquivo PNG ou JPEG em base64.
expect-opacity = Esperado: um número de 0, que não se vê, a 1, que esconde tudo o que está atrás.
expect-picture = Esperado: um arquivo PNG ou JPEG em base64.
expect-pixel = Esperado: um pixel [coluna, linha], contado a partir de 0 no canto superior esquerdo.
expect-mesh-file = Esperado: o nome de um arquivo OBJ da pasta da lição, como "cow.obj", ou uma tabela com name, vertices e faces.
expect-steps = Esperado: pelo menos um [[step]].
expect-kebab = Esperado: letras minúsculas sem acento e algarismos, unidos por hifens simples: nine-regions.
expect-figure = Esperado: no máximo 64 letras minúsculas sem acento, algarismos e hifens: nine-regions.
expect-first-here = O primeiro está na linha { $line }.
expect-first-scene = O primeiro passo deve nomear sua cena; os seguintes a mantêm.
expect-moment = Esperado: start, end ou um evento com suas palavras, como “cut left”.
expect-moments = Esperado: uma lista de momentos, como ["cut left"].
expect-moment-number = Esperado: um número a partir de 1 depois de “#”.
expect-reference = Esperado: um valor entre chaves, como { "{" }u_min{ "}" }, { "{" }P₁.x @ end{ "}" } ou { "{" }output.segment[2] of practice : 2{ "}" }.
expect-locks = Esperado: uma lista dos pontos de controle bloqueados, como ["window"].
expect-drags = Esperado: uma lista dos pontos de controle que o texto pede, como ["far"].
expect-title = Esperado: “# Título da lição” na primeira linha.
expect-heading = Esperado: um cabeçalho “## id: Título” para cada passo, com seu texto abaixo.
expect-section = Esperado: “## { $name }: Título” a seguir, com seu texto abaixo.
expect-markdown = Esperado: parágrafos, **negrito**, *itálico*, `código`, listas, blocos de código e uma citação para a resposta.
expect-emphasis = Esperado: **negrito**, sem espaços por dentro dos asteriscos; ao lado de um caractere chinês, com a pontuação fora.
expect-note = Esperado: um parágrafo próprio, fora de listas e respostas, com “!> ” no início de cada linha.

## What a value is

type-text = um texto
type-integer = um número inteiro
type-float = um número com decimais
type-boolean = verdadeiro ou falso
type-date = uma data ou hora
type-list = uma lista
type-table = uma tabela de campos

## Arquivos de malha

problem-no-number = “{ $word }” não é um número finito.
problem-too-few-numbers = Números nesta linha: só { $count } de { $needed }.
problem-no-such-vertex = Não existe o vértice { $index }: o arquivo tem { $count }.
problem-no-such-uv = Não existem as coordenadas de textura { $index }: o arquivo tem { $count }. A face é desenhada sem elas.
problem-face-too-short = Esta face tem só { $count ->
        [1] { $count } vértice
       *[other] { $count } vértices
    }: fica de fora.
problem-face-too-long = Esta face tem { $count } vértices, mais que { $limit }: fica de fora.
problem-face-not-simple = Esta face cruza a si mesma ou não tem área: fica de fora.
problem-flat-faces =
    { $count ->
        [1] { $count } triângulo não tem área: não é visto.
       *[other] { $count } triângulos não têm área, o primeiro deles aqui: não são vistos.
    }
problem-no-faces = O arquivo não tem nenhuma face que possa ser desenhada.
problem-too-many-faces = O arquivo tem mais de { $limit } triângulos: é grande demais para ser desenhado.
expect-obj-index = Espera-se: 1 para o primeiro vértice do arquivo, 2 para o seguinte; −1 para o anterior a esta linha.

problem-nothing-asked = A execução deste passo não toma nenhuma decisão antes de parar.
expect-ask = Esperado: true, false ou "run".
expect-decision = Esperado: um momento em uma decisão ou depois de uma.
problem-goal-missed = A parte { $count } da meta não vale na cena que deveria alcançá-la.
problem-goal-met = A meta já vale na cena do passo.
expect-reached = Esperado: o nome de uma cena em que valem todas as partes da meta, que não valem todas na cena do passo.
problem-goal-parts = A meta tem { $count } partes, e o máximo é { $limit }.
expect-goal = Esperado: uma lista de condições, como ["output.visible = false", "events(cut) = 1"].
goal-words-visible = Algo é visível
goal-words-invisible = Nada é visível
goal-words-output = Na resposta, “{ $name }” é “{ $value }”
goal-words-event = No “{ $event }” número { $nth }, “{ $name }” é “{ $value }”
goal-words-count =
    { $count ->
        [1] A execução tem { $count } passo “{ $name }”
       *[other] A execução tem { $count } passos “{ $name }”
    }
problem-goal-text = O passo “{ $name }” tem { $count } linhas de meta, e lesson.toml { $limit } condições.
expect-goal-text = Esperado: uma linha “- [ ] …” para cada condição.

handout-work-out = Para resolver
handout-open = Este passo abre com { $link }
handout-kept = Para guardar
