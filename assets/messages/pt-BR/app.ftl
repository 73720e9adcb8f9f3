### The window around the labs: tabs, panels, transport, menus, keys, and what it says when something goes right or wrong.

## The program

app-title = Clipscope
app-about = Veja, passo a passo, como um programa gráfico decide o que é visível.

## Labs: the tabs of the window

lab-lines = Segmentos
lab-polygons = Polígonos
lab-frustum = Frustum
lab-surfaces = Superfícies
lab-lines-about = Recorte um segmento contra uma janela.
lab-polygons-about = Recorte um polígono contra uma janela ou outro polígono.
lab-frustum-about = Descarte e recorte objetos e triângulos em três dimensões.
lab-surfaces-about = Encontre a superfície mais próxima em cada pixel.

## Panels

panel-course = Curso
panel-stage = Cena
panel-inspector = Inspetor
panel-algorithm = Algoritmo
panel-pseudocode = Pseudocódigo
panel-watch = Variáveis
panel-cost = Custo
panel-verdict = Veredito
panel-timeline = Linha do tempo
panel-scene = Dados da cena
panel-settings = Configurações
panel-show = Mostrar o painel
panel-hide = Ocultar o painel

## Second views beside the stage

view-u-axis = Eixo u
view-observer = Vista do observador
view-camera = Vista da câmera
view-depth-buffer = Buffer de profundidade

## Transport: moving through the steps of a run

transport-first = Primeiro passo
transport-back = Um passo atrás
transport-play = Reproduzir
transport-pause = Pausar
transport-forward = Um passo adiante
transport-last = Último passo
transport-previous-phase = Fase anterior
transport-next-phase = Próxima fase
transport-reset = Voltar ao início
transport-speed = Velocidade
transport-speed-value = { $speed } passos por segundo
transport-step = passo { $step } de { $total }
transport-steps =
    { $count ->
        [one] { $count } passo
       *[other] { $count } passos
    }

## What a tick on the timeline stands for

tick-phase = fase
tick-test = teste
tick-cut = corte
tick-accept = aceitação
tick-reject = rejeição

## Pseudocode, watch table, cost and verdict

pseudocode-full = Código
pseudocode-words = Em palavras
pseudocode-hidden = Oculto
pseudocode-hidden-note = Oculto: o que vem a seguir?
watch-name = Nome
watch-value = Valor
watch-new = novo
watch-empty = Nada foi calculado ainda.
cost-additions = somas e subtrações
cost-multiplications = multiplicações
cost-divisions = divisões
cost-comparisons = comparações
cost-total = no total
cost-so-far = até aqui
cost-compare = Comparar com…
cost-compare-none = Sem comparação
verdict-hint = Clique em um objeto para ver qual teste decidiu seu destino.
verdict-undecided = Neste passo ainda não está decidido.

## Settings

settings-theme = Tema
theme-light = Claro
theme-dark = Escuro
theme-projector = Projetor
settings-language = Idioma
settings-snap = Ajustar à grade

## Actions

action-present = Apresentar
action-present-leave = Sair da apresentação
action-help = Ajuda
action-undo = Desfazer
action-redo = Refazer
action-open = Abrir…
action-save = Salvar
action-save-as = Salvar como…
action-export = Exportar esta figura
action-reset = Redefinir
action-reset-view = Enquadrar tudo
action-copy = Copiar
action-close = Fechar
action-cancel = Cancelar
action-add-vertex = Adicionar um vértice
action-remove-vertex = Remover o vértice
search-hint = Buscar lições e comandos
search-none = Nada encontrado para “{ $query }”.

## Help: the keys

help-title = Teclas
help-step = um passo atrás ou adiante
help-step-ten = dez passos
help-phase = fase anterior ou próxima
help-ends = primeiro ou último passo
help-play = reproduzir ou pausar
help-reset = redefinir a cena
help-lesson-step = passo anterior ou próximo da lição
help-drag = arraste qualquer ponto de controle, em qualquer passo: a execução é gravada de novo

## What the program reports

status-exported = Exportado para { $path }
status-export-failed = Não foi possível exportar a figura: { $reason }
status-saved = Salvo em { $path }
status-save-failed = Não foi possível salvar a cena: { $reason }
status-open-failed = Não foi possível abrir { $path }: { $reason }
status-kept = A cena continua como estava.
status-reloaded = { $path } mudou e foi lido de novo.
status-drop = Solte aqui uma lição, uma cena ou uma malha.
status-empty = Ainda não há nada para recortar.
status-recording = Gravando a execução…

## For screen readers

access-handle = ponto de controle de { $name } em { $point }

## More of the window: menus, dialogs, keys

menu-more = Mais
cost-title = Custo até aqui
cost-compared-with = em comparação com { $method }
save-title = Salvar a cena
export-title = Exportar esta figura
save-path = Arquivo
help-zoom = aproximar ou afastar; também Ctrl e a roda do mouse
help-course = mostrar ou ocultar o curso
help-inspector = mostrar ou ocultar o inspetor
help-leave = fechar, ou sair da apresentação
help-tab = ir para o próximo ponto de controle ou botão
help-nudge = mover o ponto de controle que tem o foco; com Shift, dez vezes mais longe
help-alt = ao arrastar: sem ajustar à grade
status-last-good = É exibida a última versão que funcionava.
status-more-problems =
    { $count ->
        [one] … e mais { $count } problema.
       *[other] … e mais { $count } problemas.
    }
