### What the command line says to people, on the standard error; its JSON is not translated.

## Results

cli-exported =
    { $count ->
        [one] { $count } figura exportada en { $path }
       *[other] { $count } figuras exportadas en { $path }
    }
cli-checked =
    { $count ->
        [one] { $count } lección en orden
       *[other] { $count } lecciones en orden
    }
cli-refused =
    { $count ->
        [one] Se rechazó { $count } entrada
       *[other] Se rechazaron { $count } entradas
    }
cli-case-refused = caso { $case }: { $problem }
cli-unreadable = No se pudo leer { $path }: { $reason }
cli-nothing = No hay nada que hacer.
