### What the newest method says.

alg-corner-codes = 角点区域码
corners-opening = 盒子的八个角点各得一个六位区域码，每个平面一位。
corners-inside = { $corner } 在全部六个平面的内侧。
corners-beyond = { $corner } 至少在六个平面之一的外侧。
corners-culled = { $corners } 个角点都在{ $plane }平面外侧：剔除盒子。
corners-kept = { $corners } 个角点都不在任何平面外侧：整个盒子在内部。
corners-cut = { $corners } 个角点既不全在同一平面外侧，也不全在内部：接着逐个测三角形。
option-corners-culled = 八个角点都在同一平面外侧：剔除盒子。
code-corners-each = 对盒子的每个角点 P：
code-corners-and = 若各码的 AND ≠ 0：剔除
code-corners-or = 若各码的 OR = 0：在内部
code-corners-else = 否则：测它的三角形
words-corners-each = 把八个角点逐个变换到裁剪空间。
words-corners-and = 各码共有一位为 1：整个盒子在该平面外侧。
words-corners-or = 各码的每一位都是 0：角点都在内部，而视体是凸的。
words-corners-else = 区域码无法判定：盒子可能跨在平面上，也可能在视体棱边的外侧。
case-corners-straddles = 无法判定：有角点在某些平面外侧，但没有一个平面使八个角点都在其外侧。
