### lines
