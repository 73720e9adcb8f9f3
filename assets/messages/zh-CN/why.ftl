### 图证：公式从哪里来。

## 视图

why-view-section = 沿平面看去，显示真实长度

## 用相似三角形求 t

why-similar = 为什么：t = d₁ / (d₁ − d₂)
why-similar-opening = 从 P₁ 走向 P₂，走过全程的几分之几（t）时与{ $plane }平面相交？
why-similar-d1 = n·P + D 在 P₁ 处的值说明 P₁ 离平面有几级。
why-similar-d2 = P₂ 处同理。
why-similar-levels = 从 P₁ 到 P₂，线段经过这两个值之间的所有各级。
why-similar-parallel = 整条线段都在同一级上：它与平面平行，没有 t。
why-similar-piece = 相邻两级之间的三角形对应角相等，所以值每变化 1，在线段上走过的长度都相同。
why-similar-t = 平面是第 0 级。从 P₁ 到平面，值变化 −d₁；走完全程，值变化 d₂ − d₁。
why-code-d1 = d₁ ← n·P₁ + D;  d₂ ← n·P₂ + D
why-words-d1 = 求两端点各在哪一级。
why-code-levels = 级差 ← d₂ − d₁
why-words-levels = 数出从一端到另一端有多少级。
why-code-piece = 每段 ← 1 / 级差
why-words-piece = 每一级占去线段上同样长的一段。
why-code-t = t ← −d₁ · 每段 = d₁ / (d₁ − d₂)
why-words-t = 从 P₁ 到平面有 −d₁ 级。

## 影子 n·(P − p₀)

why-view-above = 从上面看
why-view-side = 从侧面看
why-view-front = 从正面看
why-shadow = 为什么：d = n·(P − p₀)
why-shadow-opening = 从{ $plane }平面上的一点 p₀ 出发，沿坐标轴一步步走到 P。光沿着平面照射。
why-shadow-piece = 沿 { $axis } 走的这一步在 n 上投下自己的影子：长度是这一步乘以 n 的这个分量。
why-shadow-sum = 各步的影子首尾相接，就是整段位移 P − p₀ 的影子。
why-shadow-distance = 影子和垂线段是一个矩形的两条对边，所以影子的长度就是 P 到{ $plane }平面的距离 d。
why-shadow-elsewhere = 从 p₀ = { $other } 出发，各步的影子都不同，而它们的和不变。
why-code-steps = 对每个坐标轴：步 ← P − p₀
why-words-steps = 从平面上的一点沿各坐标轴走到 P。
why-code-shadow = 影子 ← 步 · n 的分量
why-words-shadow = 每一步都在法向量上投下一个影子。
why-code-sum = n·(P − p₀) ← 影子之和
why-words-sum = 影子可以相加。
why-code-rectangle = d ← n·(P − p₀) = n·P + D
why-words-rectangle = 无论 p₀ 是哪一点，垂线段都与影子一样长。

## 条带：为什么 p < 0 是“进”

why-view-strips = x 和 y 随 u 变化，窗口对它们各是一个条带
why-in = 进
why-out = 出
why-strips = 为什么：p < 0 是“进”，p > 0 是“出”
why-strips-opening = 两个坐标随 u 变化的图像都是直线，窗口对每个坐标来说是一个条带。
why-strips-in = 直线由{ $edge }进入它的条带。
why-strips-out = 直线由{ $edge }离开它的条带。
why-strips-level = 直线是水平的，始终在{ $edge }内侧。
why-strips-beyond = 直线是水平的，始终在{ $edge }外侧：没有任何部分可见。
why-strips-from = 过了较晚的那个“进”，直线才同时在两个条带里。
why-strips-empty = 较早的“出”先于较晚的“进”：没有哪个 u 使直线同时在两个条带里。
why-strips-to = 从较晚的“进”到较早的“出”，直线同时在两个条带里。
why-code-strip = 对条带的每条边界：
why-words-strip = 左、右边界围成 x 的条带，下、上边界围成 y 的条带。
why-code-in = 若 p < 0：在 u = q / p 处进
why-words-in = 上升的直线从下方进入，下降的从上方进入。
why-code-out = 若 p > 0：在 u = q / p 处出
why-words-out = 它由条带的另一条边界离开。
why-code-level = 若 p = 0：始终在内，或始终在外
why-words-level = 水平的直线与它的条带的边界不相交。
why-code-both = u_min ← 最晚的进；u_max ← 最早的出
why-words-both = 同时在两个条带里的部分才可见。

## 投影的第 3 行

why-view-depth = z′ 随深度变化，介于 −w 和 w 之间
why-projection-row = 为什么：投影的第 3 行
why-row-opening = 第 3 行给出 z′ = a · 深度 + b。a 和 b 取什么值，才能把 { $near } 到 { $far } 的深度变到 −w 与 w 之间？
why-row-near = 近平面深度为 { $near }，它必须落在下边界上。
why-row-far = 远平面深度为 { $far }，它必须落在上边界上。
why-row-slope = 经过这两点的直线只有一条。从一点到另一点，z′ 增加 { $climb }，深度增加 { $way }：两者之比就是 a。
why-row-start = 反向延长到深度 0，得到直线的起点 b。
why-row-point = P 的深度是 { $depth }；直线给出它的 z′。
why-row-divided = 在过原点的一条直线上，商 z′ / w 处处相同：在远平面处的标尺上读出它。
why-row-middle = 把深度等分成 { $steps } 步，每一步沿自己从 0 出发的直线在标尺上读数。从 −1 到 0 这前一半，被 { $near } 到 { $middle } 的深度用掉了。
why-code-near-far = 近 ↦ z′ = −w；远 ↦ z′ = w
why-words-near-far = 两个条件：近、远平面各落在自己的边界上。
why-code-slope = a ← (w_远 + w_近) / (远 − 近)
why-words-slope = 两点确定一条直线，也就确定了它的斜率。
why-code-start = b ← −w_近 − a · 近
why-words-start = 直线在深度 0 处的起点。
why-code-row = z′ ← a · 深度 + b = −a · z + b
why-words-row = 深度是 −z，所以第 3 行是 0 0 −a b。
why-code-divide = z′ / w
why-words-divide = 除以 w 之后，靠近远平面的深度挤在一起。

## n·e > 0

why-view-bar = 每个面都从侧面看，法向量朝上
why-facing = 为什么：n·e > 0 就朝向视点
why-facing-opening = 横线就是第 { $face } 个面，从侧面看，法向量朝上。视点在横线上方还是下方？
why-facing-product = n·e 等于 n 的长度乘以 e 在 n 上的影子（投影）。
why-facing-length = n 的长度是正数，所以不改变符号。
why-facing-no-length = 这个面没有面积，所以没有法向量，也没有朝向。
why-facing-above = e 的影子就是视点高出第 { $face } 个面所在平面的高度：从视点看到的是它的正面。
why-facing-below = e 的影子指向另一边：视点不在第 { $face } 个面所在平面的上方，所以看不到它的正面。
why-facing-other-above = 对第 { $face } 个面，视点在横线上方。
why-facing-other-below = 对第 { $face } 个面，视点不在横线上方。
why-facing-fronts = { $faces } 个面中有 { $fronts } 个，视点在横线上方：这些面露出正面，n·e 是正数。
why-code-product = n·e = |n| · e 在 n 上的影子
why-words-product = 点积是一个长度乘以一个影子。
why-code-height = 高度 ← n·e / |n|
why-words-height = 视点高出这个面所在平面多少。
why-code-bar = 对其他每个面：同一条横线
why-words-bar = 从侧面看，每个面都是一条线段。
why-code-front = 正面 ⇔ 高度 > 0 ⇔ n·e > 0
why-words-front = 单看符号就知道视点在哪一侧。
why-depth = 深度
why-quarter-turn = 为什么：侧平面的法向量
why-mirrored = 左平面的 n
why-turn-opening = 从上面看，右平面是一条经过视点的直线。要求它的法向量，再求 P 的距离。
why-turn-tangent = 每向前一个单位，平面向旁边偏这么多：半视场角 α 的正切。
why-turn-across = 沿平面走一个单位，横向走这么多：α 的正弦。
why-turn-ahead = 同样这一个单位，向前走这么多：α 的余弦。
why-turn-turned-across = 三角形向内转 90°。原来向前的直角边现在横着，指向左边。
why-turn-turned-ahead = 原来横着的直角边现在向前。向前就是 −z，所以法向量是 (−cos α, 0, −sin α)。
why-turn-distance = n 的长度仍是 1，所以 n·P 就是 P 到右平面的距离。
why-code-tangent = tan α ← 宽高比 · tan (视场角 / 2)
why-words-tangent = 半视场角说明平面张开多大。
why-code-unit = 沿平面一个单位：(sin α, cos α)
why-words-unit = 一个单位有两条直角边，横向和向前。
why-code-turn = 转 90°：(−cos α, sin α)
why-words-turn = 两条直角边互换位置，其中一条变号。
why-code-check = d ← n·P + D
why-words-check = 旋转不改变长度，所以 n 的长度是 1。
why-view-screen = 在屏幕上：高为 1 的桩
why-fence = 为什么：1 / 深度是线性的
why-fence-opening = 沿场景的一条边立着一排高为 1 的桩。屏幕上相等的各步落在栅栏的哪里？
why-fence-nothing = 透视相机从侧面看不到任何边：没有可以分成 { $steps } 步的栅栏。
why-fence-first = 第一根桩的深度是 { $depth }。
why-fence-last = 最后一根桩的深度是 { $depth }。
why-fence-post = 屏幕上的第 { $post } 步与其他各步一样宽；它的视线在深度 { $depth } 处遇到栅栏，前一根在 { $before }。
why-fence-height = 在屏幕上，高为 1 的桩高 1 / 深度。
why-fence-drop = 栅栏的顶边在空间中是直的，所以在屏幕上从第一根桩到最后一根也是直的。
why-fence-step = 在直线下，相等的步带来相等的变化：屏幕上每一步都从 1 / 深度中减去这么多。
why-code-ends = 第一根和最后一根桩的深度
why-words-ends = 栅栏立在两个顶点之间。
why-code-posts = 对屏幕上相等的每一步：栅栏的深度
why-words-posts = 屏幕上相等的步，在栅栏上并不相等。
why-code-post = 屏幕上的高度 ← 1 / 深度
why-words-post = 深一倍，看起来就矮一半。
why-code-top = 顶边是直的：1 / 深度均匀变化
why-words-top = 直线看起来也是直的。
why-error-term = 为什么：Bresenham 的 e
why-view-columns = 最前面几列，放大
why-error-opening = 每过一列，直线偏移 b / a 个像素；两个像素之间的中点偏移 1/2。哪个更远？
why-error-parts = 用同一把尺量两者，一个像素分成 2a 份。
why-error-one-pixel = 直线的起点和终点在同一个像素里：没有什么要选。
why-error-line = 这样，直线每过一列偏移整数份。
why-error-midpoint = 中点偏移的份数也是整数。
why-error-beyond = 第 { $column } 列：直线越过了中点，所以取旁边的像素，中点再移一个像素。
why-error-short = 第 { $column } 列：直线没有越过中点，所以取正前方的像素。
why-code-parts = 一个像素 = 2a 份
why-words-parts = 把每个像素分得足够细，使分数消失。
why-code-both-whole = 直线：每列 2b；中点：a
why-words-both-whole = 这样两者都是整数。
why-code-columns = 对每一列：
why-words-columns = 一列一列地走。
why-code-error = e ← 直线 − 中点
why-words-error = e 的符号说明直线在中点的哪一侧。
why-view-sight = 沿两条视线到平面的距离
why-crosses-once = 为什么：远侧挡不住任何东西
why-bend = 它就得拐弯
why-once = 一次
why-once-opening = 三角形所在平面的远侧，会有东西挡住视点这一侧的东西吗？
why-once-no-sides = 视点就在 { $plane } 的平面里：哪一侧都不是视点那一侧。
why-once-eye = 视点在 { $plane } 的平面的一侧，距离是这么多。
why-once-own = Q 是 { $own } 的中心，在同一侧。
why-once-least = 在去 Q 的路上，距离均匀变化，从不为 0：挡住 Q 的东西一定在 { $plane } 的平面的视点一侧。
why-once-other = R 是 { $other } 的中心，在另一侧。
why-once-crossing = 在去 R 的路上，距离有一次为 0：在那之前近侧可能挡住 R，在那之后是远侧。
why-code-eye = E: d(E) > 0
why-words-eye = 视点那一侧是正的。
why-code-own = d(Q) > 0：一路上 d > 0
why-words-own = 直线上两个正值之间没有 0。
why-code-other = d(R) < 0：d = 0 一次
why-words-other = 直线与平面只相交一次。
why-code-order = 绘制：远侧，三角形，视点这一侧
why-words-order = 被挡住的先画。
why-bridge = 为什么：桥边没有面积
why-edge = 边
why-width = 宽
why-height = 高
why-strip = 条带
why-sum = 和
why-bridge-opening = 环的每条边都有一条条带，从左边界到这条边：边向上就加，边向下就减。
why-bridge-up = { $edge } 向上，所以加上它的条带。
why-bridge-down = { $edge } 向下，所以减去它的条带。
why-bridge-none = { $edge } 没有条带：它是水平的，或者就在条带开始的地方。
why-bridge-back = { $edge } 沿着 { $other } 走回来：这是桥边。在那里，同一条条带加一次又减一次。
why-bridge-area = 所有条带合起来剩下 { $area }：这就是环的面积，桥边不占面积。
why-bridge-elsewhere = 如果条带从右边界开始，每条条带都不同，而它们的和不变。
why-code-edges = 对环的每条边：
why-words-edges = 绕环走一圈。
why-code-swept = 条带 ← 平均宽度 · 高
why-words-swept = 向下的边高为负。
why-code-area = 面积 ← 条带之和
why-words-area = 走过去又走回来的部分互相抵消。

## 交点是加权平均

why-mean = 为什么：交点是加权平均
why-triangle = 三角形
why-across = 垂直于边界
why-along = 沿边界
why-mean-opening = 线段穿过一条边界所在的直线。它在边界上的哪个位置穿过？
why-mean-nothing = 没有哪条边界所在的直线从 P₁ 和 P₂ 之间经过：没有交点可求。
why-mean-first = P₁ 离{ $edge }（{ $border }）这么远。
why-mean-second = P₂ 在另一侧，离它这么远。
why-mean-part = 所以在垂直于边界的方向上，走完全程的这一部分就到{ $edge }。
why-mean-rise = 到边界为止的三角形与整条线段的三角形角都相等，只是大小为它的 t 倍。所以沿边界的方向，走的也是全程的 t。
why-mean-level = 线段沿边界方向没有移动：两个三角形都没有高。
why-mean-mean = 合起来：每个端点的 { $along } 以另一端点的距离为权。
why-mean-given = 对另一个坐标 { $across } 求同样的平均，得到的正是边界。所以它直接取自边界，不必计算。
why-code-weights = w₁, w₂ ← P₁、P₂ 到边界的距离
why-words-weights = 量出每个端点离边界所在的直线多远。
why-code-part = t ← w₁ / (w₁ + w₂)
why-words-part = 垂直于边界的路程中，w₁ 在边界之前。
why-code-rise = X ← P₁ + t · (P₂ − P₁)
why-words-rise = 两个方向上走的是全程的同一部分。
why-code-mean = X = (w₂ · P₁ + w₁ · P₂) / (w₁ + w₂)
why-words-mean = 离得近的端点权大。

## 面积的两倍

why-double-area = 为什么：a₁·b₂ < b₁·a₂ 表示“在左侧”
why-area = 面积
why-left = 左侧
why-right = 右侧
why-rectangle = 矩形
why-ends = + 两个半块
why-half = − 总面积的一半
why-more = 比一半多
why-area-opening = P₂ 在从 P₁ 过一个角点的直线的哪一侧？两点的坐标都从这个角点量起。
why-area-nothing = 这里知道 P₁ 和 P₂ 所在的区域就够了：不检验角点。
why-area-first = 过 { $corner } 的两条线把从 P₁ 到 P₂ 的矩形分成四块，其中一块宽 |a₁|、高 |b₂|。
why-area-second = 它对面的一块宽 |a₂|、高 |b₁|。
why-area-ends = 从 P₁ 经 { $corner } 走到 P₂：这条折线平分另外两块。
why-area-half = 从 P₁ 直接走到 P₂，平分整个矩形。
why-area-more = 经 { $corner } 的折线左侧比一半多：多的是两条路线之间的三角形。右侧少的也是它。
why-area-less = 经 { $corner } 的折线左侧比一半少：少的是两条路线之间的三角形。右侧多的也是它。
why-area-none = { $corner } 就在 P₁ 到 P₂ 的线段上：没有三角形，两侧各是一半。
why-area-left = 左减右是三角形面积的两倍，是正数：P₂ 在从 P₁ 过 { $corner } 的直线的左侧。
why-area-right = 左减右是三角形面积的两倍，带负号：P₂ 在从 P₁ 过 { $corner } 的直线的右侧。
why-area-through = 左减右等于 0：P₂ 就在从 P₁ 过 { $corner } 的直线上。
why-code-rectangles = 两块矩形：|a₁·b₂| 和 |b₁·a₂|
why-words-rectangles = 就是既不挨着 P₁ 也不挨着 P₂ 的两块。
why-code-over = 经角点的折线：平分另外两块
why-words-over = 对角线平分矩形。
why-code-straight = 直接走的线段：平分四块的总和
why-words-straight = 整个矩形也有对角线。
why-code-between = 三角形 ← 左 + 两个半块 − 总面积的一半
why-words-between = 两条路线之间的部分，一侧多出来，另一侧就缺少。
why-code-twice = b₁·a₂ − a₁·b₂ = 左 − 右 = 2 · 三角形
why-words-twice = 符号说明在哪一侧：正号是左侧。
