### What the command line says to people, on the standard error; its JSON is not translated.

## Results

cli-exported =
    { $count ->
        [one] { $count } figure exported to { $path }
       *[other] { $count } figures exported to { $path }
    }
cli-checked =
    { $count ->
        [one] { $count } lesson is in order
       *[other] { $count } lessons are in order
    }
cli-refused =
    { $count ->
        [one] { $count } input was refused
       *[other] { $count } inputs were refused
    }
cli-case-refused = case { $case }: { $problem }
cli-unreadable = { $path } could not be read: { $reason }
cli-nothing = There is nothing to do.
