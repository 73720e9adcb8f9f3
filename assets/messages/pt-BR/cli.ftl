### What the command line says to people, on the standard error; its JSON is not translated.

## Results

cli-exported =
    { $count ->
        [one] { $count } figura exportada para { $path }
       *[other] { $count } figuras exportadas para { $path }
    }
cli-checked =
    { $count ->
        [one] { $count } lição em ordem
       *[other] { $count } lições em ordem
    }
cli-refused =
    { $count ->
        [one] { $count } entrada foi recusada
       *[other] { $count } entradas foram recusadas
    }
cli-case-refused = caso { $case }: { $problem }
cli-unreadable = Não foi possível ler { $path }: { $reason }
cli-nothing = Não há nada a fazer.
