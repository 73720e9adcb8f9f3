### The lines lab: captions, watch table and controls.

## Handles, by name

handle-end = { $end }
handle-segment = el segmento
handle-window = la ventana
handle-side = { $edge }
handle-corner-bottom-left = la esquina inferior izquierda
handle-corner-bottom-right = la esquina inferior derecha
handle-corner-top-left = la esquina superior izquierda
handle-corner-top-right = la esquina superior derecha
handle-vertex = vértice { $number }

## The scene

action-add-segment = Añadir un segmento
action-remove-segment = Quitar el segmento
batch-title = Segmentos al azar
batch-count = Cuántos
batch-seed = Semilla
batch-make = Reemplazar todos los segmentos

## Costs, measured

cost-measure = Medir en este equipo…
measure-title = Lo que cuesta un segmento
measure-about = Todos los métodos recortan los mismos segmentos al azar, aquí y ahora.
measure-start = Medir
measure-again = Medir de nuevo
measure-nanos = Nanosegundos
measure-operations = Operaciones
measure-note = Por segmento, promedio de { $count }. El tiempo es el de la más rápida de cinco pasadas.
