### What the newest method says.

alg-corner-codes = Códigos de los vértices
corners-opening = Cada uno de los ocho vértices de la caja recibe un código de seis bits, uno por plano.
corners-inside = { $corner } está dentro de los seis planos.
corners-beyond = { $corner } está más allá de al menos uno de los seis planos.
corners-culled = Los { $corners } vértices están más allá del plano { $plane }: la caja se descarta.
corners-kept = Ninguno de los { $corners } vértices está más allá de un plano: la caja está dentro entera.
corners-cut = Ningún plano deja fuera los { $corners } vértices, y no todos están dentro: se prueban sus triángulos.
option-corners-culled = Un mismo plano deja fuera los ocho vértices: la caja se descarta.
code-corners-each = para cada vértice P de la caja:
code-corners-and = si AND de los códigos ≠ 0: descartar
code-corners-or = si OR de los códigos = 0: dentro
code-corners-else = si no: probar sus triángulos
words-corners-each = Llevar cada uno de los ocho vértices al espacio de recorte.
words-corners-and = Un bit común a todos los códigos: toda la caja está más allá de ese plano.
words-corners-or = Ningún bit en ningún código: todos los vértices están dentro, y el volumen es convexo.
words-corners-else = Los códigos no deciden: la caja puede cruzar un plano, o estar fuera junto a una arista.
case-corners-straddles = Sin decidir: hay vértices más allá de algún plano, pero ningún plano deja fuera los ocho.
