### The window around the labs: tabs, panels, transport, menus, keys, and what it says when something goes right or wrong.

## The program

app-title = Clipscope

## Labs: the tabs of the window

lab-lines = Segmentos
lab-lines-about = Recorte um segmento com uma janela.
lab-polygons = Polígonos
lab-polygons-about = Recorte um polígono com uma janela ou com outro polígono.
lab-frustum = Volume de visão
lab-frustum-about = Veja o que uma câmera vê e o que se pode descartar antes de desenhar.
lab-surfaces = Superfícies
lab-surfaces-about = Veja qual superfície está na frente, pixel a pixel.

## Panels

panel-course = Curso
panel-stage = Cena
stage-boundary = Divisa entre o desenho e o que está ao lado: arraste-a ou use as setas.
panel-inspector = Inspetor
panel-algorithm = Algoritmo
panel-pseudocode = Pseudocódigo
panel-watch = Variáveis
panel-controls = Ajustar
panel-cost = Custo
panel-timeline = Linha do tempo
panel-scene = Dados da cena

## Transport: moving through the steps of a run

transport-first = Primeiro passo
transport-back = Um passo atrás
transport-play = Reproduzir
transport-pause = Pausar
transport-forward = Um passo adiante
transport-last = Último passo
transport-next-page = Próximo passo da lição
transport-speed-value = Passos por segundo: { $speed }
transport-step = passo { $step } de { $total }
transport-steps =
    { $count ->
        [1] { $count } passo
       *[other] { $count } passos
    }

## Pseudocode, watch table, cost and verdict

pseudocode-full = Código
pseudocode-words = Em palavras
pseudocode-hidden = Oculto
pseudocode-hidden-note = Oculto: o que vem a seguir?
watch-empty = Nada foi calculado ainda.
verdict-title = Por quê?
verdict-go = Ir a esse passo (Enter)
cost-additions = somas e subtrações
cost-sums = somas
cost-multiplications = multiplicações
cost-divisions = divisões
cost-comparisons = comparações
cost-total = no total
cost-compare = Comparar com…
cost-compare-none = Sem comparação

## Settings

settings-theme = Tema
theme-light = Claro
theme-dark = Escuro
theme-projector = Projetor
settings-text = Tamanho do texto
settings-snap = Ajustar à grade

## Actions

action-present = Apresentar
action-present-leave = Sair da apresentação
action-open-whole = Abrir no Clipscope
action-notes = Notas para quem apresenta
speaker-clock = { $clock } desde que a apresentação começou (horas e minutos)
speaker-no-note = Este passo não tem notas.
speaker-next = Depois: { $title }
speaker-last = Este é o último passo.
courses = Outros cursos
course-built-in = O curso incluído
action-picture = A imagem da câmera ao lado da do observador
no-picture = Nenhum método do palco mostra aqui a imagem da câmera.
type-what = Escolha antes uma alça: Tab passa de uma a outra, um clique pega uma.
action-free = Cena livre
action-course = Voltar ao curso
free-title = Cena livre
free-scenes = Cenas livres
scene-new = Nova cena livre…
scene-copy = Cópia desta cena…
scene-rename = Mudar o nome desta cena livre…
scene-delete = Excluir esta cena livre…
scene-numbered = Cena { $n }
scene-name = Nome
scene-name-taken = Outra cena deste laboratório já tem este nome.
scene-make = Criar
scene-rename-it = Mudar
scene-delete-it = Excluir
scene-delete-asks = “{ $name }” some, com tudo o que podia ser desfeito nela. Nada a traz de volta.
free-about = Sua própria cena: nada está bloqueado e ela é guardada.
free-about-large = Sua própria cena: nada está bloqueado. A cena é grande demais para ser guardada quando a janela fecha: salve-a em um arquivo (Ctrl+S).
free-back = ← {$lesson}
free-from-course = Cenas do curso
scene-adopt = Abrir esta cena em: { $lab }
action-help = Ajuda
action-undo = Desfazer
action-redo = Refazer
save-exists = Este arquivo já existe e não é o que foi aberto.
action-replace = Substituí-lo
action-open = Abrir…
action-open-it = Abrir
action-open-path = Abrir pelo caminho…
action-recent = Abrir um arquivo recente
action-save = Salvar
action-save-path = Salvar em um caminho…
action-browse = Procurar…
action-export = Exportar esta figura
action-copy = Copiar esta figura
action-copy-svg = Copiar como texto SVG
action-link = Copiar um link para o que se vê
action-reset = Redefinir
action-fit = Enquadrar
handle-locked = Não é possível mover { $name } neste passo.
handle-other = clique: { $name }
handles-listed = { $list }; { $name }
action-reset-view = Enquadrar tudo
action-close = Fechar
action-cancel = Cancelar

## Help: the keys

help-title = Teclas
help-step = Um passo atrás ou adiante
help-step-ten = Dez passos
help-phase = Fase anterior ou próxima
help-ends = Primeiro ou último passo
help-play = Reproduzir ou pausar
help-reset = Redefinir a cena do passo; mostrar uma cena livre desde o primeiro passo, ajustada
help-lesson-step = Passo anterior ou próximo da lição
help-drag = Arraste qualquer ponto de controle, em qualquer passo: a execução é registrada de novo

## What the program reports

status-exported = Exportado para { $path }
status-exporting = Passos exportados: { $count } de { $total }. Esc interrompe a exportação.
status-export-failed = Não foi possível exportar a figura: { $reason }
status-copied = A figura está na área de transferência: { $width } × { $height } pixels.
status-copied-svg = A figura está na área de transferência como texto de um arquivo SVG ({ $count } kB).
status-copy-failed = Não foi possível copiar a figura: { $reason }
status-link-copied = O link está na área de transferência ({ $count } caracteres). Quem o abrir verá o que você vê.
status-link-long = O link está na área de transferência. Ele tem { $count } caracteres: alguns programas cortam links com mais de 2.000.
status-link-of-page = Esta cena é grande demais para um link. O link na área de transferência leva ao passo da lição como ele era.
status-link-none = Esta cena é grande demais para um link. Salve-a em um arquivo.
greeting = ← e → percorrem a execução passo a passo, Espaço a reproduz. Tudo o que tem um ponto de controle pode ser arrastado, em qualquer passo.
status-restored = Seu trabalho da última vez está de volta; desfazer o retira.
status-saved = Salvo em { $path }
status-memory-aside = Não foi possível ler { $path }: { $reason } Agora se chama { $aside }, e os ajustes recomeçam.
status-memory-unread = Não foi possível ler { $path }: { $reason } Os ajustes e o trabalho não serão guardados.
status-memory-unkept = Os ajustes e o trabalho não podem ser guardados em { $path }: { $reason }.
status-memory-full = O navegador não consegue guardar os ajustes nem o trabalho: { $reason }.
status-memory-refused = O navegador não guarda nada desta página: os ajustes e o trabalho se perderão quando você a fechar. Salve em um arquivo o que quiser conservar.
status-coming = { $what } está a caminho.
status-not-come = { $what } não chegou. Escolha outra vez para tentar de novo.
status-fonts-coming = Os caracteres chineses ainda estão sendo carregados. Tente de novo daqui a pouco.
status-save-failed = Não foi possível salvar a cena: { $reason }
status-open-failed = Não foi possível abrir { $path }: { $reason }
status-forgotten = Ele não está mais entre os arquivos recentes.
status-no-window = Não foi possível abrir a janela: ela precisa de uma tela e de OpenGL. Sem isso, clipscope export desenha as figuras em arquivos. O sistema diz: “{ $reason }”
status-kept = A cena continua como estava.
status-mesh-reading = Lendo { $path }… Esc cancela.
status-mesh-given-up = A leitura de { $path } foi cancelada: a cena está como estava.
status-mesh-plain = Não foi possível ler a textura que { $library } indica: a malha é desenhada sem ela.
status-mesh-picture = { $name } está ao lado da malha e é usada como sua textura.
status-mesh-added =
    { $count ->
        [1] { $name }, com { $count } triângulo, já está na cena.
       *[other] { $name }, com { $count } triângulos, já está na cena.
    }
status-reloaded = { $path } mudou e foi lido de novo.

## For screen readers

access-handle = ponto de controle de { $name } em { $point }

## More of the window: menus, dialogs, keys

menu-more = Mais
cost-title = Custo até aqui
cost-compared-with = em comparação com { $method }
open-title = Abrir uma cena
save-title = Salvar a cena
export-title = Exportar esta figura
export-format = Formato
export-weight = Tamanho do arquivo
export-weight-of =
    { $count ->
        [1] { $size } kB
       *[other] { $count } arquivos de cerca de { $size } kB
    }
export-size = Tamanho
export-language = Idioma
export-steps = Passos
export-this-step = este passo
export-all-steps = todos os passos da execução
save-path = Arquivo
save-folder = Pasta
key-space = Espaço
key-enter = Enter
key-escape = Esc
key-delete = Delete
key-insert = Insert
key-home = Home
key-end = End
key-page-up = PageUp
key-page-down = PageDown
key-backspace = Backspace
key-shift = Shift
help-zoom = Aproximar ou afastar; também Ctrl e a roda do mouse
help-text = Texto maior, menor ou como no início
help-course = Mostrar ou ocultar o curso
help-free = Cena livre anterior ou seguinte do laboratório
help-inspector = Mostrar ou ocultar o inspetor
help-leave = Fechar, ou sair da apresentação
help-tab = Ir para o próximo ponto de controle ou botão
help-nudge = Mover o ponto de controle que tem o foco; com Shift, dez vezes mais longe
help-deeper = No espaço: afastar esse ponto de controle do olho ou aproximá-lo dele
help-axis = No espaço, pressionada enquanto um ponto de controle se move: só ao longo desse eixo
help-type = Digitar a posição do ponto de controle escolhido
help-alt = Ao arrastar: sem ajustar à grade
help-pen = Ao apresentar, mantida: desenhar sobre a cena, até o passo seguinte
help-verdict = Ir ao passo que decidiu o destino do que foi clicado
status-last-good = É exibida a última versão que funcionava.
status-more-problems =
    { $count ->
        [1] … e mais { $count } problema.
       *[other] … e mais { $count } problemas.
    }

## Vertices, outlines, and the methods that are wrong on purpose

help-add = Mais um segmento, ou um vértice depois do selecionado
help-remove = Remover o segmento ou o vértice selecionado
help-draw-close = Ao desenhar: fechar o contorno
help-draw-back = Ao desenhar: desfazer o último vértice
help-edge = Clique duplo, ou Ctrl e clique, em uma aresta: um novo vértice ali
help-turn = No espaço, o botão direito gira a vista, onde quer que seja arrastado; a roda a aproxima
faulty-title = O que está errado aqui?
methods-objects = Objetos, faces e pontos
methods-segments = Segmentos
methods-triangles = Triângulos
methods-vertices = Vértices
methods-why = De onde vêm as fórmulas
faulty-unnamed = O programa de um estudante
differs-from = difere a partir do passo { $step }
differs-nowhere = mesmos passos com esta entrada
not-so = × { $what }
wrong-and-right = Errado: { $wrong } Certo: { $right }
part-missing = falta
result-right = Resultado certo: { $n }
result-wrong = × Resultado errado: { $n }
again = { $what } de novo
is-missing = falta { $what }
refused = recusado
run-later = A cena é grande demais para que o método execute enquanto você arrasta. Ele executa quando você solta.
recording-triangles = { $method } está sendo registrado com { $count ->
        [1] { $count } triângulo
       *[other] { $count } triângulos
    }…
recording-vertices = { $method } está sendo registrado com { $count ->
        [1] { $count } vértice
       *[other] { $count } vértices
    }…
recording-segments = { $method } está sendo registrado com { $count ->
        [1] { $count } segmento
       *[other] { $count } segmentos
    }…
recording-stop = Parar (Esc)

## Vistas ao lado do desenho

view-empty = não sobra nada
view-more = … mais { $count }

practice = Pergunte-me
action-practise = Antes de cada decisão, pergunte-me o que vem
practice-question = O que vem agora?
practice-how = Pressione um número ou escolha.
practice-take-back = Desfazer a resposta (Backspace)
practice-show = Mostre (S)
practice-right = ✓ { $right }.
practice-wrong = × { $chosen }. O correto: { $right }.
practice-shown = { $right }.
practice-go-on = Continuar (Enter)
practice-told = { $right } de { $count } acertadas antes de vê-las
practice-done = A execução terminou: não há mais decisões.
practice-on = A pergunta virá antes da próxima decisão.
practice-leave = Não perguntar mais
practice-step = passo { $step }
what-comes-next = O que vem agora? { $options }
named-sentence = { $name }: { $said }
figure-before = Antes
figure-now = Agora

lesson-waits = O resto se abre com a sua resposta, ou com S.
lesson-ask-again = Pergunte-me de novo
settings-asks = As lições perguntam antes de mostrar
settings-marks-at-end = Marcas no fim da execução
answers-title = Perguntas desta execução
answers-earlier = Respostas anteriores nesta execução: { $count }
answer-right = Passo { $step }: { $right }. Dito de antemão.
answer-wrong = Passo { $step }: { $right }, não: { $chosen }.
answer-shown = Passo { $step }: { $right }. Mostrado.
practice-stands = A pergunta deste passo: { $told }.
told-beforehand = respondida de antemão
told-after = respondida depois de ver os números
told-open = em aberto
told-missed = em aberto; sua resposta não era a certa
told-seen = visto
told-unseen = ainda não visto
progress-title = Progresso
progress-counts = { $seen ->
    [1] Um passo visto
   *[other] { $seen } passos vistos
} · respondidos de antemão: { $beforehand } · respondidos depois dos números: { $after } · em aberto: { $open } · metas alcançadas: { $reached } / { $goals }
progress-hand-in = Entregar…
progress-take-up = Carregar um arquivo…
progress-afresh = Começar do zero
progress-sure = Todas as marcas deste computador se perdem.
hand-in-title = Entregar o seu progresso
take-up-title = Carregar um arquivo de progresso
progress-taken-up = As marcas do arquivo foram somadas às suas.
goal-reached = Todas as partes valem: a meta foi alcançada.
goal-part-met = vale
goal-part-open = ainda não vale
mark-reached = meta alcançada
mark-goal = meta ainda não alcançada
goal-hint = Dica (T)
goal-hint-part = { $part } de { $count } vistas
goal-hint-none = A execução desta cena não decide nada: mude primeiro a cena.
goal-hint-now = “{ $part }”: agora { $now }; pede-se { $sign }{ $wanted }.
goal-hint-open = “{ $part }”: ainda não.
goal-hint-way = Uma solução move só isto: { $handles }.
goal-hint-parts = Em uma solução os dois programas se separam aqui: { $said }
goal-so-far = Onde as suas execuções terminaram
goal-ended =
    { $count ->
        [0] { $said } { $count } execuções terminaram assim.
        [one] { $said } { $count } execução terminou assim.
       *[other] { $said } { $count } execuções terminaram assim.
    }
action-hint = Uma dica para o objetivo: o que decide e depois a equação
mark-hints =
    { $count ->
        [0] { $count } partes da dica vistas
        [one] { $count } parte da dica vista
       *[other] { $count } partes da dica vistas
    }
action-smaller = Uma cena menor com a mesma diferença
smaller-search = Procura-se uma cena menor. Esc interrompe a busca e deixa a menor que tiver sido encontrada.
smaller-none = Não foi encontrada nenhuma cena menor com a mesma diferença: esta já é pequena.
smaller-not-yet = Primeiro mude a cena até alcançar o objetivo. Depois, M reduz a cena.
smaller-fewer = A cena está menor, e a diferença é a mesma. Vértices: { $after } em vez de { $before }.
smaller-rounder-only = Os números estão mais redondos, e a diferença é a mesma.
smaller-rounder = Os números estão mais redondos, e a diferença é a mesma. Foi movido: { $handles }.
smaller-no-difference = Aqui não há diferença a reduzir: ao lado do método certo deve haver um com erro, e os dois devem diferir.

## A lesson that is made

compose-title = Criar uma lição
compose-begin = Modificar esta lição
compose-leave = Terminar com a lição
compose-try = Testar como estudante
compose-back = Voltar a criar a lição
compose-saved = ✓ Tudo está salvo.
compose-unsaved = … As mudanças ainda não estão salvas.
compose-outside = Outro programa mudou os arquivos desta lição. Nada é salvo até você decidir. Agora está escrito:
compose-take-theirs = Usar essa versão
compose-keep-mine = Manter a versão desta janela
compose-settle-first = Outro programa mudou os arquivos desta lição: decida primeiro qual versão fica.
compose-step-title = Passo { $n } de { $total }, título
compose-text = Texto, em Markdown
compose-text-how = > oculta uma resposta até um estudante pedir. Uma linha --- termina o que se lê antes de responder a uma pergunta.
compose-stands = Onde está a execução
compose-follows = segue a linha do tempo
compose-locked = Bloqueado
compose-lock-focused = ao criar uma lição: bloqueia ou desbloqueia a alça ativa
compose-ask = Perguntar antes deste passo
compose-ask-decision = a última decisão
compose-ask-run = cada decisão da execução
compose-figure = Uma figura que pode ser exportada
compose-figure-name = Nome da figura
compose-id = Nome do passo em links
compose-goal = Uma meta: é preciso alcançar a cena como está
compose-goal-how = Agora arraste a cena até onde os estudantes começam. Estas partes são verificadas:
compose-add = Adicionar um passo aqui
compose-insert = Inserir um passo depois do passo { $n }
compose-row = passo { $n } de { $total }, { $title }, em { $at }
compose-own-scene = Nova cena a partir daqui
compose-own-scene-about = De agora em diante este passo tem uma cena própria: o que você arrastar nela não muda nenhum outro passo.
compose-how = O que você mudar no palco é, a partir daí, a cena deste passo. Nesta lista Insert adiciona um passo, Delete o tira, e Alt com ↑ ↓ o move.
compose-lesson = Título da lição
compose-source = De onde vem
compose-source-at-first = Feita no Clipscope
compose-new-title = O que acontece aqui?
compose-has-goal = tem uma meta
compose-asks-first = pergunta antes
compose-refused = Isso não cabe nos arquivos da lição: um título é uma linha, uma linha que começa com # começaria outro passo, e cada nome aparece uma só vez.
compose-form = A janela não pode mudar lesson.toml na forma que ele tem: cada passo precisa estar abaixo de uma linha [[step]].
compose-own-only = Só é possível modificar uma lição de uma pasta sua. Copie primeiro esta para uma pasta.
compose-mend-first = Corrija primeiro o erro: passos só entram, saem e mudam de lugar em uma lição sem erros.
lesson-save = Salvar como lição…
lesson-copy = Copiar esta lição para uma pasta…
lesson-save-title = Uma pasta para a lição
lesson-save-taken = Nesta pasta já há uma lição.
