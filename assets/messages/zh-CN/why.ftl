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
