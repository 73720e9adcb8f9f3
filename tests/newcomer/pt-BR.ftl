### What the newest method says.

alg-corner-codes = Códigos dos cantos
corners-opening = Cada um dos oito cantos da caixa recebe um código de seis bits, um por plano.
corners-inside = { $corner } está dentro dos seis planos.
corners-beyond = { $corner } está além de pelo menos um dos seis planos.
corners-culled = Os { $corners } cantos estão além do plano { $plane }: a caixa é descartada.
corners-kept = Nenhum dos { $corners } cantos está além de um plano: a caixa inteira está dentro.
corners-cut = Nenhum plano deixa os { $corners } cantos de fora, e nem todos estão dentro: seus triângulos são testados.
option-corners-culled = Um mesmo plano deixa os oito cantos de fora: a caixa é descartada.
code-corners-each = para cada canto P da caixa:
code-corners-and = se AND dos códigos ≠ 0: descartar
code-corners-or = se OR dos códigos = 0: dentro
code-corners-else = senão: testar seus triângulos
words-corners-each = Levar cada um dos oito cantos ao espaço de recorte.
words-corners-and = Um bit comum a todos os códigos: a caixa inteira está além desse plano.
words-corners-or = Nenhum bit em nenhum código: todos os cantos estão dentro, e o volume é convexo.
words-corners-else = Os códigos não decidem: a caixa pode cruzar um plano, ou estar fora junto a uma aresta.
case-corners-straddles = Sem decisão: há cantos além de algum plano, mas nenhum plano deixa os oito de fora.
