### The lines lab: captions, watch table and controls.

## Said by several methods

line-opening = P₁P₂ 的哪一部分在窗口内？
line-not-on-it = { $point }：不在 P₁P₂ 上
line-parallel = 与{ $edge }平行：没有交点。
line-reject-edge = 舍弃：两端点都在{ $edge }外侧。
line-accept = 接受：可见部分从 { $p1 } 到 { $p2 }。
line-touch = 接受：线段与窗口只有一个公共点 { $at }。
line-point = 接受：两端点是同一个点 { $at }，它在窗口内。
param-left = { $min } < { $max }：还剩一段。
param-touch = { $min } = { $max }：只剩一点，而边界上的点也算在内。
param-empty = { $min } > { $max }：区间为空，什么也不剩。
param-put-end = { $end } = { $at } 本来就在内侧，保持不动。
watch-crossings = 交点数
watch-crossings-used = 有用的
table-edge = 边界
table-polygon-edge = 边
table-start = 初始
table-corner = 角点

## Brute force

bf-intersect = 求与{ $edge }所在直线的交点。
bf-keep = { $edge }外侧没有线段的任何部分：这个交点没有用上。
bf-keep-parallel = { $edge }外侧没有线段的任何部分：这条边界不改变什么。
bf-cut = { $end } 在 { $border } 外侧：移到 { $to }。
bf-option-none = { $edge }外侧没有线段的任何部分。
bf-option-one = 一个端点在{ $edge }外侧。
bf-option-both = 两端点都在{ $edge }外侧。
bf-note-tests = 四个不等式都成立，点就在窗口内。
bf-in-vain = 未用上
bf-kept = 可见部分占 { $part }
code-bf-each = 对每条不与 P₁P₂ 平行的边界：
code-bf-intersect = X ← 直线 P₁P₂ ∩ 边界所在直线
code-bf-reject = 若两端点都在这条边界外侧，则舍弃
code-bf-cut = 若一个端点在这条边界外侧，则该端点 ← X
code-bf-accept = 接受 P₁P₂
words-bf-each = 依次处理四条边界；与线段平行的边界跳过。
words-bf-intersect = 求线段所在直线与边界所在直线的交点。
words-bf-reject = 若两端点都在这条边界外侧，则线段完全不可见。
words-bf-cut = 若有一个端点在外侧，就把它移到交点处。
words-bf-accept = 剩下的就是可见部分。

## Cohen–Sutherland

cs-code = { $end } 在{ $region }：{ $code } = { $bits }。
cs-or-accept = OR = { $bits }：两端点都在窗口内。
cs-or-open = OR = { $bits } ≠ 0000：并非全在窗口内。
cs-and-reject = AND = { $bits } ≠ 0000：两端点都在{ $edge }外侧。
cs-and-open = AND = { $bits }：没有一条边界使两端点都在它的外侧，仅凭区域码无法判定。
cs-choose = 最低位的 1 对应{ $edge }：{ $end } 在其外侧。
cs-cut = 在 { $border } 处截断：{ $end } 移到交点。
cs-reject = 舍弃：两端点都在{ $region }；AND = { $and }。
cs-reject-two = 舍弃：两端点都在窗口外。
cs-option-inside = 两端点都在裁剪区域内。
cs-option-not-inside = 并非全在裁剪区域内。
cs-option-undecided = 没有哪条边界使两端点都在其外侧。
cs-option-beyond = 两端点都在同一条边界的外侧。
cs-note-code = 点在哪条边界外侧，哪一位就是 1。
cs-note-order = 按上、下、右、左的顺序，则写作 { $other }。
cs-note-or = OR：任一区域码该位为 1，结果就是 1。
cs-note-and = AND：两个区域码该位都为 1，结果才是 1。
cs-cuts = 截断
cs-this-order = 本次顺序：
cs-usual-order = 常用顺序：
code-cs-codes = code₁ ← code(P₁); code₂ ← code(P₂)
code-cs-loop = 循环：
code-cs-accept = 若 code₁ OR code₂ = 0，则接受
code-cs-reject = 若 code₁ AND code₂ ≠ 0，则舍弃
code-cs-choose = 边界 ← code₁ OR code₂ 最低位的 1
code-cs-end = P ← 区域码中该位为 1 的端点
code-cs-cut = P ← P₁P₂ ∩ 边界
code-cs-recode = P 的区域码 ← code(P)
words-cs-codes = 给每个端点编一个区域码：每条边界占一位，端点在其外侧则该位为 1。
words-cs-loop = 反复执行：
words-cs-accept = 若两个区域码的各位全为 0，则剩下的全部可见。
words-cs-reject = 若两个区域码有同为 1 的位，则两端点在同一条边界外侧。
words-cs-choose = 否则取最低位的 1 所对应的边界。
words-cs-end = 恰有一个端点在它的外侧。
words-cs-cut = 把这个端点移到线段与该边界的交点处。
words-cs-recode = 重新给它编码。
alg-faulty-looks-once = 错误：只截断一次
faulty-looks-once-differs = 从第 { $step } 步起出现差别：截断一次之后，不管新的区域码是什么，程序都接受剩下的部分。
code-faulty-looks-once = 若已截断一次或 code₁ OR code₂ = 0，则接受
words-faulty-looks-once = 若两个区域码的各位全为 0，或已有一端被截断，则剩下的全部可见。
alg-faulty-two-outside = 错误：两端点都在窗口外就舍弃
faulty-two-outside-differs = 从第 { $step } 步起出现差别：两个区域码都不为 0，程序便舍弃，尽管没有一条边界使两端点都在它的外侧。
code-faulty-two-outside = 若 code₁ ≠ 0 且 code₂ ≠ 0，则舍弃
words-faulty-two-outside = 若两个区域码都有为 1 的位，则两端点都在窗口外，线段完全不可见。
settings-bit-order = 区域码的位序
bit-order-tbrl = 上、下、右、左
bit-order-lrbt = 左、右、下、上

## Liang–Barsky

lb-delta = P(u) = P₁ + u (P₂ − P₁)：沿线段从头到尾，x、y 的变化量为 Δx、Δy。
lb-row = k = { $k }，{ $edge }：u · p ≤ q，{ $direction }。
lb-parallel-inside = 与{ $edge }平行且在其内侧：单凭这条边界还不能判定。
lb-parallel-outside = 与{ $edge }平行且在其外侧：任何 u 都不满足。
lb-parallel-forgotten = 与{ $edge }平行：程序不作判断，继续处理下一条边界。
lb-enter = 直线由{ $edge }进入：u_min 增大。
lb-enter-idle = 直线由{ $edge }进入，但不晚于 u_min：不变。
lb-leave = 直线由{ $edge }离开：u_max 减小。
lb-leave-idle = 直线由{ $edge }离开，但不早于 u_max：不变。
lb-put = { $end } 移到 u = { $u } 处，落在 { $border } 上。
lb-reject = 处理到{ $edge }时舍弃：线段一点不剩。
lb-note-enter = p < 0 进入：{ $bound } = max({ $bound }, r)
lb-note-leave = p > 0 离开：{ $bound } = min({ $bound }, r)
lb-note-parallel = p = 0 平行：q ≥ 0 时在内侧
code-lb-start = u_min ← 0; u_max ← 1; Δ ← P₂ − P₁
code-lb-each = 对 k = 1 … 4：取第 k 条边界的 p、q
code-lb-parallel = 若 p = 0 且 q < 0，则舍弃
code-lb-enter = 若 p < 0，则 u_min ← max(u_min, q/p)
code-lb-leave = 若 p > 0，则 u_max ← min(u_max, q/p)
code-lb-empty = 若 u_min > u_max，则舍弃
code-lb-accept = 接受 P(u_min) P(u_max)
words-lb-start = 从整条线段开始，u 从 0 到 1。
words-lb-each = 对每条边界，把“在内侧”写成不等式 u · p ≤ q。
words-lb-parallel = p = 0：线段与边界平行；若在外侧，则舍弃。
words-lb-enter = p < 0：直线由此进入，在 q/p 之前不可能可见。
words-lb-leave = p > 0：直线由此离开，在 q/p 之后不可能可见。
words-lb-empty = 若参数区间为空，则线段完全不可见。
words-lb-accept = 否则，区间的两端就是可见部分的两端。
alg-faulty-parallel = 错误：p = 0 时不作判断
faulty-parallel-differs = 从第 { $step } 步起出现差别：p = 0 且 q < 0，线段在这条边界外侧，程序却继续处理下一条边界。
code-faulty-parallel = 若 p = 0，则处理下一条边界
words-faulty-parallel = p = 0：线段与边界平行；继续处理下一条边界。

## Cyrus–Beck

cb-edge-entering = { $edge }：n·D > 0，直线进入。
cb-edge-leaving = { $edge }：n·D < 0，直线离开。
cb-edge-parallel = { $edge }：n·D = 0，直线与该边平行。
cb-parallel-inside = 与 { $edge } 平行且在其内侧：单凭这条边还不能判定。
cb-parallel-outside = 与 { $edge } 平行且在其外侧：任何 t 都不满足。
cb-enter = 直线由 { $edge } 进入：t_min 增大。
cb-enter-idle = 直线由 { $edge } 进入，但不晚于 t_min：不变。
cb-leave = 直线由 { $edge } 离开：t_max 减小。
cb-leave-idle = 直线由 { $edge } 离开，但不早于 t_max：不变。
cb-put = { $end } 移到 t = { $t } 处，落在 { $edge } 上。
cb-reject = 处理到 { $edge } 时舍弃：线段一点不剩。
cb-sign-enters = { $product } > 0：直线进入
cb-sign-leaves = { $product } < 0：直线离开
cb-sign-parallel = { $product } = 0：直线平行
cb-sign-inside = { $product } > 0：{ $end } 在内侧
cb-sign-on = { $product } = 0：{ $end } 在边所在直线上
cb-sign-outside = { $product } < 0：{ $end } 在外侧
cb-measured = 沿 { $normal } 从边量起
alg-faulty-normals = 错误：法向量全部朝外
faulty-normals-differs = 从第 { $step } 步起出现差别：法向量朝外，于是进入被当作离开。
code-cb-start = t_min ← 0; t_max ← 1; D ← P₂ − P₁
code-cb-each = 对每条边：取 n；w ← P₁ − E
code-cb-parallel = 若 n·D = 0 且 n·w < 0，则舍弃
code-cb-enter = 若 n·D > 0，则 t_min ← max(t_min, −n·w/n·D)
code-cb-leave = 若 n·D < 0，则 t_max ← min(t_max, −n·w/n·D)
code-cb-empty = 若 t_min > t_max，则舍弃
code-cb-accept = 接受 P(t_min) P(t_max)
words-faulty-normals = 对每条边，把它左转作为法向量，不管顶点按什么方向排列。
words-cb-start = 从整条线段开始，t 从 0 到 1。
words-cb-each = 对每条边，取它指向内侧的法向量。
words-cb-parallel = n·D = 0：线段与该边平行；若在外侧，则舍弃。
words-cb-enter = n·D > 0：顺着法向量，直线由此进入。
words-cb-leave = n·D < 0：逆着法向量，直线由此离开。
words-cb-empty = 若参数区间为空，则线段完全不可见。
words-cb-accept = 否则，区间的两端就是可见部分的两端。

## Nicholl–Lee–Nicholl

nln-region = { $end } 在{ $region }。
nln-option-region = { $end } 在{ $option }。
nln-side-enters = 从 P₁ 望向角点 { $corner }，P₂ 在{ $turn }：先越过{ $first }。
nln-side-meets = 从 P₁ 望向角点 { $corner }，P₂ 在{ $turn }：先越过{ $first }。
nln-side-leaves = 从 P₁ 望向角点 { $corner }，P₂ 在{ $turn }：由{ $first }离开。
nln-side-through = P₂ 恰在从 P₁ 过角点 { $corner } 的直线上：同时越过两条边界。
nln-option-side = 从 P₁ 过角点 { $corner } 的直线：P₂ 在{ $option }。
nln-miss = 舍弃：线段从角点 { $corner } 外绕过，在{ $edge }外侧。
nln-sector-inside = 两端点都在窗口内：无需求交。
nln-sector-enters = 由{ $enters }进入，P₂ 在窗口内：只求一个交点。
nln-sector-leaves = P₁ 在窗口内，由{ $leaves }离开：只求一个交点。
nln-sector-both = 由{ $enters }进入，由{ $leaves }离开：求两个交点，都有用。
nln-question-enters = 由哪条边界进入
nln-question-meets = 是否进入
nln-question-leaves = 由哪条边界离开
nln-note-products = 以角点为原点：P₁ = (a₁, b₁)，P₂ = (a₂, b₂)
turn-left = 左侧
turn-through = 线上
turn-right = 右侧
watch-region-1 = P₁ 的区域
watch-region-2 = P₂ 的区域
watch-enters = 入边
watch-leaves = 出边
code-nln-regions = 求 P₁、P₂ 所在的区域
code-nln-shared = 若两端点在同一边界外侧，则舍弃
code-nln-enters = 若 P₁ 在角区域，则由角点直线定入边
code-nln-meets = 若 P₂ 在邻边外侧且绕过角点，则舍弃
code-nln-leaves = 若 P₂ 在角区域，则由角点直线定出边
code-nln-cut = P₁、P₂ ← 所求的一个或两个交点
words-nln-regions = 判断两端点各在哪个区域。
words-nln-shared = 若两端点在同一条边界外侧，则线段完全不可见。
words-nln-enters = 若 P₁ 在角区域，则由 P₁ 与该角点的连线判断线段从哪条边界进入。
words-nln-meets = 若 P₂ 在相邻边界的外侧，则由 P₁ 与公共角点的连线判断线段是否与窗口相交。
words-nln-leaves = 若 P₂ 在角区域，则由 P₁ 与该角点的连线判断线段从哪条边界离开。
words-nln-cut = 只计算这些交点。

## Handles, by name

handle-end = { $end }
handle-segment = 线段
handle-window = 窗口
handle-side = { $edge }
handle-corner-bottom-left = 左下角
handle-corner-bottom-right = 右下角
handle-corner-top-left = 左上角
handle-corner-top-right = 右上角
handle-vertex = 顶点 { $number }

## The scene

action-add-segment = 添加线段
action-remove-segment = 删除线段
batch-title = 随机线段
batch-count = 数量
batch-seed = 种子
batch-again = 用下一个种子再来一组
batch-make = 替换所有线段

## Costs, measured

cost-measure = 在本机上测量…
cost-of-all-segments = 全部 { $count } 条线段：除法 { $divisions } 次，乘法 { $multiplications } 次，加减 { $additions } 次，比较 { $comparisons } 次
measure-title = 裁剪一条线段的代价
measure-about = 每种方法都在本机上当场裁剪同一批随机线段。
measure-start = 测量
measure-again = 重新测量
measure-nanos = 纳秒
measure-operations = 运算次数
measure-batch = 无分支批处理
measure-note = 每条线段的平均值，共 { $count } 条。时间取五遍中最快的一遍。

## The verdict

verdict-part-dropped = 从 { $from } 到 { $to }，这一步把线段的这一部分裁去。
verdict-line-between = 直线先穿出（{ $leaves }），之后才穿入（{ $enters }）。
verdict-line-in = 垂直于该边界（{ $edge }）向内移动 { $move }，它就可见。
verdict-line-back = 垂直于该边界（{ $edge }）向外移动 { $move }，它就可见。
verdict-line-never = 垂直于该边界（{ $edge }）怎样移动，它都不可见。
verdict-line-out = 垂直于最近的边界（{ $edge }）向外移动超过 { $move }，它就消失。
verdict-line-touch = 它只是接触边界（{ $edge }）：稍向外移，就会消失。
