### The lines lab: captions, watch table and controls.

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
batch-make = Substituir todos os segmentos

## Costs, measured

cost-measure = Medir neste computador…
measure-title = Quanto custa um segmento
measure-about = Todos os métodos recortam os mesmos segmentos aleatórios, aqui e agora.
measure-start = Medir
measure-again = Medir de novo
measure-nanos = Nanossegundos
measure-operations = Operações
measure-note = Por segmento, na média de { $count }. O tempo é o da mais rápida de cinco passagens.
