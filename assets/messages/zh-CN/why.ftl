### 图证：公式从哪里来。

## 视图

why-view-section = 沿平面看去，长度如实

## 用相似三角形求 t

why-similar = 为什么：t = d₁ / (d₁ − d₂)
why-similar-opening = 从 P₁ 到 P₂，线段走过全程的哪一部分 t 时遇到{ $plane }平面？
why-similar-d1 = n·P + D 在 P₁ 处的值说明 P₁ 离平面有几级。
why-similar-d2 = P₂ 处也一样。
why-similar-levels = 从 P₁ 到 P₂，线段经过这两个值之间的所有各级。
why-similar-parallel = 整条线段都在同一级上：它与平面平行，没有 t。
why-similar-piece = 相邻两级之间的三角形角都相同，所以值每变 1，走过的线段都一样长。
why-similar-t = 平面是第 0 级。从 P₁ 到平面，值变化 −d₁；走完全程，值变化 d₂ − d₁。
why-code-d1 = d₁ ← n·P₁ + D;  d₂ ← n·P₂ + D
why-words-d1 = 求出两端各在哪一级。
why-code-levels = 级数 ← d₂ − d₁
why-words-levels = 数出从一端到另一端有多少级。
why-code-piece = 每段 ← 1 / 级数
why-words-piece = 每一级占去同样长的一段。
why-code-t = t ← −d₁ · 每段 = d₁ / (d₁ − d₂)
why-words-t = 从 P₁ 到平面有 −d₁ 级。

## 影子 n·(P − p₀)

why-view-above = 从上面看
why-view-side = 从侧面看
why-view-front = 从正面看
why-shadow = 为什么：d = n·(P − p₀)
why-shadow-opening = 从{ $plane }平面上的一点 p₀ 出发，沿坐标轴一步步走到 P。光沿着平面照射。
why-shadow-piece = 沿 { $axis } 走的这一步在 n 上投下自己的影子：长度是这一步乘以 n 的这个分量。
why-shadow-sum = 各步的影子首尾相接，就是整段路 P − p₀ 的影子。
why-shadow-distance = 影子和垂线是一个矩形的两条对边，所以影子的长度就是 P 到{ $plane }平面的距离 d。
why-shadow-elsewhere = 从 p₀ = { $other } 出发，各个影子都不同，而它们的和不变。
why-code-steps = 对每个坐标轴：步 ← P − p₀
why-words-steps = 从平面上的一点沿各坐标轴走到 P。
why-code-shadow = 影子 ← 步 · n 的分量
why-words-shadow = 每一步都在法向量上投下一个影子。
why-code-sum = n·(P − p₀) ← 影子之和
why-words-sum = 影子可以相加。
why-code-rectangle = d ← n·(P − p₀) = n·P + D
why-words-rectangle = 无论 p₀ 是哪一点，垂线都与影子一样长。

## 条带：为什么 p < 0 是“进”

why-view-strips = x 和 y 随 u 变化，各有窗口的一条条带
why-in = 进
why-out = 出
why-strips = 为什么：p < 0 是“进”，p > 0 是“出”
why-strips-opening = 两个坐标随 u 都是直线，窗口对每个坐标来说是一条条带。
why-strips-in = 直线从{ $edge }进入它的条带。
why-strips-out = 直线从{ $edge }离开它的条带。
why-strips-level = 直线是水平的，始终在{ $edge }以内。
why-strips-beyond = 直线是水平的，始终在{ $edge }以外：没有任何部分可见。
why-strips-from = 要到较晚的那个“进”之后，直线才同时在两条条带里。
why-strips-empty = 较早的“出”比较晚的“进”还早：没有哪个 u 使直线同时在两条条带里。
why-strips-to = 从较晚的“进”到较早的“出”，两条条带都含有这条直线。
why-code-strip = 对条带的每条边界：
why-words-strip = 左右是 x 的条带的边界，上下是 y 的条带的边界。
why-code-in = 若 p < 0：在 u = q / p 进
why-words-in = 上升的直线从下面进来，下降的从上面进来。
why-code-out = 若 p > 0：在 u = q / p 出
why-words-out = 它从条带的另一条边界出去。
why-code-level = 若 p = 0：始终在里面，或始终不在
why-words-level = 水平的直线不穿过条带的边界。
why-code-both = u_min ← 最晚的进；u_max ← 最早的出
why-words-both = 两条条带都含有的部分才可见。

## 投影的第 3 行

why-view-depth = z′ 随深度变化，介于 −w 和 w 之间
why-projection-row = 为什么：投影的第 3 行
why-row-opening = 第 3 行给出 z′ = a · 深度 + b。哪个 a 和 b 能把 { $near } 到 { $far } 的深度放到 −w 和 w 之间？
why-row-near = 近平面深度为 { $near }，它必须落在下边界上。
why-row-far = 远平面深度为 { $far }，它必须落在上边界上。
why-row-slope = 经过这两点的直线只有一条。它在 { $way } 中上升 { $climb }：这就是 a。
why-row-start = 往回延长到深度 0，直线从 b 开始。
why-row-point = P 的深度是 { $depth }；直线给出它的 z′。
why-row-divided = 在从 0 出发的一条直线上，商 z′ / w 处处相同：在远平面处的标尺上读出它。
why-row-middle = 范围的前一半，从 −1 到 0，被 { $near } 到 { $middle } 的深度用掉了。
why-code-near-far = 近 ↦ z′ = −w；远 ↦ z′ = w
why-words-near-far = 两个条件：每个平面都到自己的边界上。
why-code-slope = a ← (w_远 + w_近) / (远 − 近)
why-words-slope = 两点确定一条直线，也就确定了它的斜率。
why-code-start = b ← −w_近 − a · 近
why-words-start = 直线在深度 0 处的起点。
why-code-row = z′ ← a · 深度 + b = −a · z + b
why-words-row = 深度是 −z，所以第 3 行是 0 0 −a b。
why-code-divide = z′ / w
why-words-divide = 相除之后，靠近远平面的深度挤在一起。

## n·e > 0

why-view-bar = 每个面都从侧边看，法向量朝上
why-facing = 为什么：n·e > 0 朝向眼睛
why-facing-opening = 把第 { $face } 个面放在一条横杆上，法向量朝上。眼睛在横杆上方还是下方？
why-facing-product = n·e 等于 n 的长度乘以 e 在 n 上的影子。
why-facing-length = n 的长度是正数，所以不改变符号。
why-facing-no-length = 这个面没有面积，所以没有法向量，也没有朝向。
why-facing-above = e 的影子就是眼睛在第 { $face } 个面所在平面上方的高度：眼睛看到它的正面。
why-facing-below = e 的影子指向另一边：眼睛不在第 { $face } 个面所在平面的上方，所以看不到它的正面。
why-facing-other-above = 第 { $face } 个面放在同一条横杆上，眼睛在它上方。
why-facing-other-below = 第 { $face } 个面放在同一条横杆上，眼睛不在它上方。
why-facing-fronts = 横杆上的 { $faces } 个面中，眼睛在其中 { $fronts } 个的上方：这些面露出正面，它们的 n·e 是正数。
why-code-product = n·e = |n| · e 在 n 上的影子
why-words-product = 点积是一个长度乘以一个影子。
why-code-height = 高度 ← n·e / |n|
why-words-height = 眼睛在这个面所在平面上方多高。
why-code-bar = 对其他每个面：同一条横杆
why-words-bar = 从侧边看，每个面都是一条横杆。
why-code-front = 正面 ⇔ 高度 > 0 ⇔ n·e > 0
why-words-front = 单看符号就知道眼睛在哪一侧。
