# 多边形实验室。

handle-clip-vertex = 裁剪多边形的顶点 { $number }
handle-hole-vertex = 内孔 { $hole } 的顶点 { $number }
handle-polygon = 被裁剪多边形
texture-title = 纹理
texture-none = 无
texture-interpolated = 用 t 插值
texture-kept = 不插值（错误）
part-subject = 被裁剪多边形
part-hole = 内孔
part-clip = 裁剪多边形
refused-not-convex = 该算法要求裁剪区域是凸的：{ $part }在 { $vertex } 处拐向了另一侧。
refused-winds-twice = 该算法要求简单多边形：到 { $vertex } 为止，{ $part }已绕行不止一圈。
refused-edges-meet = 该算法要求简单多边形：{ $part }的边 { $first } 与边 { $second } 相交或接触。
refused-misplaced-hole = 该算法要求每个内孔都在多边形内部，且不与边界或其他内孔接触：{ $part }不符合这一要求。
refused-degenerate = 没有可裁剪的内容：{ $part }的面积为零。

## 逐点单击绘制轮廓

action-draw-subject = 绘制多边形
action-draw-clip = 绘制裁剪多边形
action-draw-hole = 绘制内孔
action-no-hole = 删除这个内孔
action-no-holes = 删除所有内孔
draw-subject = 单击放置新多边形的顶点 { $number }；Backspace 撤回一个，Esc 取消。
draw-clip = 单击放置新裁剪多边形的顶点 { $number }；Backspace 撤回一个，Esc 取消。
draw-hole = 单击放置新内孔的顶点 { $number }；Backspace 撤回一个，Esc 取消。
draw-close = 单击放置顶点 { $number }；按 Enter、双击或单击第一个顶点即可闭合轮廓。
draw-no-use = 当前算法不支持{ $part }。

## 可供选用的多边形与区域

preset-title = 示例多边形
preset-convex = 凸多边形
preset-triangle = 三角形
preset-arrow = 箭头（凹）
preset-comb = 梳形：裁成多块
preset-corner = 绕过角点：产生桥边
preset-spiral = 螺旋形
preset-star = 星形
preset-hole = 带内孔
preset-around = 包围整个窗口
preset-inside = 完全在窗口内
preset-touch = 只有一个公共点
preset-along = 一条边与边界重合
preset-bow-tie = 蝴蝶结：自相交
preset-random = 随机
random-count = 顶点数
random-make = 替换多边形
region-title = 裁剪区域
region-window = 窗口
region-corners = 窗口的四个角点
region-triangle = 三角形
region-diamond = 菱形
region-octagon = 八边形
region-bracket = L 形（凹）
## Ear clipping

ear-opening = 要把这个有 { $n } 个顶点的多边形剖分成三角形。
ear-classify = { $vertex } 是{ $corner }。
option-corner = { $vertex } 是{ $option }。
ear-classify-again = 邻点变了：现在 { $vertex } 是{ $corner }。
ear-convex = 凸顶点
ear-straight = 共线顶点
ear-reflex = 凹顶点
ear-round = 第 { $round } 轮开始，还有 { $n } 个顶点。
ear-pass = { $vertex } 是{ $corner }：不是耳尖。
ear-candidate = { $vertex } 是凸顶点。三角形 { $triangle } 内还有别的顶点吗？
ear-blocked = { $by } 落在三角形 { $triangle } 内：{ $vertex } 不是耳尖。
ear-not-convex = { $vertex } 不是凸顶点。
ear-is-convex = { $vertex } 是凸顶点。
ear-not-empty = 三角形 { $triangle } 内还有别的顶点：{ $vertex } 不是耳尖。
ear-ear = 三角形 { $triangle } 内没有别的顶点：这是一只耳朵，{ $vertex } 是耳尖。
ear-cut = 沿对角线 { $diagonal } 切下 { $triangle }：还剩 { $n } 个顶点。
ear-last = 只剩三个顶点：{ $triangle } 是最后一个三角形。
ear-done =
    { $n ->
        [1] 完成：本来就是一个三角形。
       *[other] 完成：共 { $n } 个三角形，比顶点数少 2。
    }
ear-list-ring = 剩余部分
ear-list-triangles = 三角形
ear-inside = 在内
ear-outside = 在外
ear-left = 剩余部分
ear-n-left = 剩余顶点数
ear-n-triangles = 三角形数
code-ear-classify = 对每个顶点 v：corner(v) ← turn(a, v, b) 的符号
code-ear-round = 当剩余顶点多于 3 个时循环：
code-ear-each = 对每个角有变化的 v：
code-ear-convex = 若 corner(v) > 0
code-ear-empty = 且没有 corner ≤ 0 的顶点落在 avb 内
code-ear-cut = 输出 avb；去掉 v
code-ear-again = 重新计算 corner(a)、corner(b)
code-ear-last = 输出剩下的三个顶点
words-ear-classify = 在每个顶点 v 处，从前一点 a 到后一点 b，轮廓是左转、右转还是直行？
words-ear-round = 一轮一轮地检查，直到只剩三个顶点。
words-ear-each = 检查上一轮中角有变化的每个顶点；第一轮检查全部顶点。
words-ear-convex = 只有在轮廓左转的地方，角才可能被切下。
words-ear-empty = 三角形内不得有别的顶点；只需检查非凸的顶点。
words-ear-cut = 这是一只耳朵：沿对角线 ab 切下。
words-ear-again = a、b 处的角变了：重新分类，下一轮再检查这两点。
words-ear-last = 剩下的就是一个三角形。

## Triangulate, then clip

tac-opening = 先把这个有 { $n } 个顶点的多边形剖分成三角形，再逐个裁剪。
tac-triangle = 第 { $number } 个三角形（共 { $total } 个）：{ $triangle }。裁剪时，它的三个顶点记作 V₁、V₂、V₃。
tac-whole = { $triangle } 全部在区域内：原样就是一块。
tac-piece = { $triangle } 留下一块有 { $n } 个顶点的凸多边形。
option-piece-cut = { $triangle } 被切开，留下一块凸多边形。
tac-none = { $triangle } 在区域内什么也没留下。
tac-touch = { $triangle } 只与区域接触：不留下任何一块。
tac-finish =
    { $n ->
        [0] 完成：一块也没有，多边形没有伸进区域。
       *[other] 完成：共 { $n } 块，都是凸的，没有桥边。
    }
tac-list-triangles = 三角形
tac-list-pieces = 块
tac-dropped = 舍弃
tac-vertices = 顶点数
tac-now = 三角形
tac-pieces = 块数
code-tac-triangulate = 三角形列表 ← 耳切法(多边形)
code-tac-each = 对每个三角形：
code-tac-clip = 环 ← Sutherland–Hodgman(三角形, 区域)
code-tac-piece = 若环的面积不为零，则输出环
words-tac-triangulate = 用耳切法把多边形剖分成三角形。
words-tac-each = 逐个处理三角形。
words-tac-clip = 用 Sutherland–Hodgman 裁剪它：凸多边形裁剪后仍是凸的。
words-tac-piece = 若剩下的部分面积不为零，它就是答案中的一块。
## Sutherland–Hodgman

alg-sutherland-hodgman = Sutherland–Hodgman
alg-sutherland-hodgman-pipeline = Sutherland–Hodgman（流水线）
## 萨瑟兰–霍奇曼算法

rule-in-in = 内 → 内
rule-in-out = 内 → 外
rule-out-in = 外 → 内
rule-out-out = 外 → 外
sh-inside = 内侧
sh-outside = 外侧
sh-bridge = 桥边：往返各 { $length }
sh-bridge-adds = 桥边：面积 + 0，轮廓 + 2 · { $length }
sh-area = 面积 { $area }
sh-does-not-count = { $inside }：现在不算
sh-list-input = 输入表
sh-list-output = 输出表
sh-list-handed-on = 输出表 = 输入表
sh-list-next = 下一轮的输入表
sh-list-given = 被裁剪多边形
sh-list-left = 裁剪结果
sh-list-wrong = × 错误的结果
sh-n-inside = 内侧 { $n } 个
sh-opening = 依次用裁剪区域的每条边裁剪整个多边形（{ $n } 个顶点）：共 { $edges } 条边。
sh-edge-side = 用{ $edge }裁剪：{ $inside } 时点在内侧。
sh-edge = 用边 { $edge } 裁剪：{ $inside } 时点在内侧。
sh-first-inside = 第一个顶点 { $vertex } 在内侧：输出。
sh-first-outside = 第一个顶点 { $vertex } 在外侧：不输出。
sh-in-in = { $from } → { $to }：内 → 内。输出 { $to }。
option-puts-nothing = { $from } → { $to }：不输出。
option-puts-end = { $from } → { $to }：输出 { $to }。
option-puts-crossing = { $from } → { $to }：输出交点。
option-puts-both = { $from } → { $to }：先输出交点，再输出 { $to }。
sh-in-out = { $from } → { $to }：内 → 外。输出交点 I。
sh-in-out-touch = { $from } → { $to }：内 → 外。{ $from } 在边界上，本身就是交点：它已在表中。
sh-out-in = { $from } → { $to }：外 → 内。先输出交点 I，再输出 { $to }。
sh-out-in-touch = { $from } → { $to }：外 → 内。{ $to } 在边界上，本身就是交点：只输出一次。
sh-out-out = { $from } → { $to }：外 → 外。不输出。
sh-closing-cross = 闭合边 { $from } → { $to }：{ $rule }。只输出交点 I。
sh-closing = 闭合边 { $from } → { $to }：{ $rule }。不再输出。
sh-cross = { $from } → { $to } 与 { $border } 交于 I。
sh-output = { $vertex } 进入输出表，成为 { $place }。
sh-pass = { $border } 处理完毕：输出表（长度 { $n }）成为下一轮的输入表。
sh-pass-empty = { $border } 处理完毕：输出表长度为 { $n }，没有可继续裁剪的顶点。
sh-done-empty = { $edges } 条边处理完毕：多边形没有任何部分在裁剪区域内，表是空的。
sh-done-whole = 完成：{ $n } 个顶点都在全部 { $edges } 条边的内侧，多边形保持原样。
sh-done-cut = { $edges } 条边处理完毕：剩下一个有 { $n } 个顶点的环。
sh-done-degenerate = { $edges } 条边处理完毕：剩下的部分没有面积。最后一张表的长度为 { $n }。
code-sh-each = 对每条裁剪边：输出表 ← 空
code-sh-first = F ← 第一个顶点；若在内侧，输出 F
code-sh-edges = 对每条边 S → P，最后回到 F：
code-sh-in-in = 内 → 内：若 P ≠ F，输出 P
code-sh-in-out = 内 → 外：输出 I
code-sh-out-in = 外 → 内：输出 I；若 P ≠ F，再输出 P
code-sh-out-out = 外 → 外：不输出
code-sh-pass = 输入表 ← 输出表
words-sh-each = 依次取裁剪区域的每条边，每次从空的输出表开始。
words-sh-first = 若第一个顶点在内侧，就输出它。
words-sh-edges = 然后沿轮廓逐边前进，最后闭合；在闭合边上不再输出 F。
words-sh-in-in = 边始终在内侧：输出它的终点。
words-sh-in-out = 边离开内侧：输出交点。
words-sh-out-in = 边进入内侧：先输出交点，再输出终点。
words-sh-out-out = 边始终在外侧：不输出。
words-sh-pass = 输出的顶点就是下一条裁剪边要处理的多边形；最后一条边之后即为结果。

## The pipeline
## 萨瑟兰–霍奇曼算法的流水线形式

pipe-list-ring = 已输出的环
pipe-opening = { $edges } 个裁剪器同时工作：{ $n } 个顶点逐个流过。
pipe-send = 多边形的顶点 { $vertex } = { $at } 进入第一个裁剪器 { $border }。
pipe-enter = { $vertex } = { $at } 流入下一个裁剪器 { $border }。
pipe-first-inside = 到达裁剪器 { $border } 的第一个顶点：记为 F；它在内侧，继续流动。
pipe-first-outside = 到达裁剪器 { $border } 的第一个顶点：记为 F；它在外侧，到此为止。
pipe-vertex = S → P：{ $rule }。P 继续流动。
pipe-crossing = S → P：{ $rule }。交点 I 继续流动。
pipe-both = S → P：{ $rule }。先是交点 I，然后 P 继续流动。
pipe-nothing = S → P：{ $rule }。没有交点，P 到此为止。
pipe-closing-cross = 闭合边 S → F：{ $rule }。交点 I 继续流动。
pipe-closing = 闭合边 S → F：{ $rule }。没有顶点继续流动。
pipe-cross = S → P 与 { $border } 交于 I。
pipe-output = { $at } 离开最后一个裁剪器：它从此就是环的顶点 { $vertex }。
pipe-close = 不再有顶点到达裁剪器 { $border }：闭合它的环。
pipe-close-empty = 没有顶点到达过裁剪器 { $border }：没有可闭合的环。
pipe-closed = 已闭合
code-pipe-send = 对每个顶点：送入裁剪器 1
code-pipe-enter = 裁剪器 k 收到 P 时：
code-pipe-first = 若是第一个：F ← P
code-pipe-cross = 否则，若 SP 穿过边界：把 I 送入裁剪器 k + 1
code-pipe-pass-on = S ← P；若 P 在内侧：把 P 送入裁剪器 k + 1
code-pipe-output = 离开最后一个裁剪器的顶点加入环
code-pipe-close = 依次闭合裁剪器 1、2、…：若 SF 穿过边界，送出 I
words-pipe-send = 多边形的顶点逐个进入。
words-pipe-enter = 裁剪器只记住两个顶点：最先到达的 F 和前一个 S。
words-pipe-first = 记住最先到达的顶点。
words-pipe-cross = 若从 S 出发的边穿过边界，交点先往下送。
words-pipe-pass-on = 把这个顶点记为 S；若它在内侧，就往下送。
words-pipe-output = 离开最后一个裁剪器的顶点属于结果。
words-pipe-close = 最后，每个裁剪器依次检查从它的最后一个顶点回到 F 的边。

## Faulty on purpose
## 故意出错的萨瑟兰–霍奇曼算法

alg-faulty-on-border = 错误：把边界算作外侧
alg-faulty-open = 错误：漏掉闭合边
alg-faulty-clockwise = 错误：顺时针走裁剪边
alg-faulty-twice = 错误：交点输出两次
alg-faulty-end-first = 错误：先输出终点，后输出交点
faulty-on-border-differs = 从第 { $step } 步起出现差别：边界上的顶点被当作外侧的顶点。
faulty-open-differs = 从第 { $step } 步起出现差别：从最后一个顶点回到第一个顶点的闭合边从未检验。
faulty-clockwise-differs = 从第 { $step } 步起出现差别：顺时针走裁剪边，于是每条边的外侧被当作内侧。
faulty-twice-differs = 从第 { $step } 步起出现差别：同一个交点又输出了一次。
faulty-end-first-differs = 从第 { $step } 步起出现差别：边进入内侧，却先输出终点，后输出交点。
code-faulty-on-border = 对每条裁剪边：输出表 ← 空；内侧为 d > 0
words-faulty-on-border = 依次取裁剪区域的每条边，每次从空的输出表开始。边界上的顶点算作在外侧。
code-faulty-open = 对每条边 S → P，到最后一个顶点为止：
words-faulty-open = 然后沿轮廓逐边前进，到最后一个顶点为止。
code-faulty-clockwise = 对每条裁剪边（顺时针）：输出表 ← 空
words-faulty-clockwise = 按顺时针依次取裁剪区域的每条边，把每条边的左侧当作内侧。
code-faulty-twice-out = 内 → 外：输出 I、I
words-faulty-twice-out = 边离开内侧：把交点输出两次。
code-faulty-twice-in = 外 → 内：输出 I、I、P
words-faulty-twice-in = 边进入内侧：先把交点输出两次，再输出终点。
code-faulty-end-first = 外 → 内：若 P ≠ F，输出 P；再输出 I
words-faulty-end-first = 边进入内侧：先输出终点，再输出交点。
## Weiler–Atherton

wa-opening = 用有 { $m } 个顶点的多边形裁剪有 { $n } 个顶点的多边形：两者都写成逆时针的顶点表。
wa-vertex-subject = { $vertex } 进入被裁剪多边形的顶点表。接下来：边 { $edge } 与裁剪多边形在哪里相交？
wa-vertex-clip = { $vertex } 进入裁剪多边形的顶点表。接下来：边 { $edge } 上的交点，按顺序。
wa-found-crossing = { $node }：{ $subject } 与 { $clip } 相交。
wa-found-on-edge = { $node }：顶点 { $vertex } 落在边 { $edge } 上。
wa-found-both = { $node }：顶点 { $subject } 与 { $clip } 是同一个点。
wa-meet-crossing = { $subject-edge } 与 { $clip-edge } 在两边的内部相交。
wa-meet-subject-vertex = 被裁剪多边形的一个顶点落在边 { $clip-edge } 的内部。
wa-meet-clip-vertex = 裁剪多边形的一个顶点落在边 { $subject-edge } 的内部。
wa-meet-both = 两条边从同一个点出发。
wa-inserted = { $node } 也进入裁剪多边形的顶点表，位于边 { $edge } 上。
wa-inserted-vertex = 在裁剪多边形的顶点表中，{ $node } 就是顶点 { $vertex }。
option-label = { $node }：{ $option }
wa-entering = { $node } 是入点：被裁剪多边形由{ $before }转到{ $after }。
wa-leaving = { $node } 是出点：被裁剪多边形由{ $before }转到{ $after }。
wa-touching = { $node } 只是接触：被裁剪多边形由{ $before }转到{ $after }，仍在同一侧。
wa-touching-same = { $node } 只是接触：被裁剪多边形前后都在{ $before }。
wa-pinching = { $node } 是对顶点：两条边界各自穿过对方内部，结果的两个顶点在此相碰。
wa-inside = 内部
wa-outside = 外部
wa-along = 同向的公共边（算内部）
wa-against = 反向的公共边（算外部）
wa-in = 入
wa-out = 出
wa-touches = 接触
wa-pinches = 对顶
wa-intersection = 交点
wa-mark-entering = 入点
wa-mark-leaving = 出点
wa-start = 从 { $node } 出发，沿被裁剪多边形的顶点表行走。
wa-visit-subject = 沿被裁剪多边形：{ $entry } 成为路径的第 { $n } 个顶点。
wa-visit-clip = 沿裁剪多边形：{ $entry } 成为路径的第 { $n } 个顶点。
wa-past = { $entry } 处不拐弯，不算顶点：直接走过。
wa-switch-clip = { $node } 是出点：转到裁剪多边形的顶点表。
wa-switch-subject = { $node } 是入点：转到被裁剪多边形的顶点表。
wa-switch-pinch-clip = { $node } 是对顶点：转到裁剪多边形的顶点表，使每一块各有自己的顶点。
wa-switch-pinch-subject = { $node } 是对顶点：转到被裁剪多边形的顶点表，使每一块各有自己的顶点。
wa-closed-outer = 回到已经走过的点：环 { $ring } 闭合，共 { $n } 个顶点。
wa-closed-hole = 回到已经走过的点：这是被裁剪多边形的整个环。{ $ring }（{ $n } 个顶点）是内孔。
wa-closed-sliver = 回到已经走过的点：{ $ring }（{ $n } 个顶点）太窄，舍入后面积为零，不输出。
wa-whole-subject-kept = 沿被裁剪多边形的外轮廓从不换表，位于{ $side }：整条边界就是环 { $ring }。
wa-whole-subject-dropped = 沿被裁剪多边形的外轮廓从不换表，位于{ $side }：不围成任何部分。
wa-whole-hole-kept = 沿被裁剪多边形的内孔 { $hole } 从不换表，位于{ $side }：它是内孔 { $ring }。
wa-whole-hole-dropped = 沿被裁剪多边形的内孔 { $hole } 从不换表，位于{ $side }：不围成任何部分。
wa-whole-clip-kept = 沿裁剪多边形从不换表，位于{ $side }：整条边界就是环 { $ring }。
wa-whole-clip-dropped = 沿裁剪多边形从不换表，位于{ $side }：不围成任何部分。
wa-hole = 内孔 { $hole } 位于环 { $ring } 之内。
wa-done-disjoint = 完成：两个多边形没有公共点。
wa-done-touching = 完成：两个多边形只有接触，但没有公共面积。
wa-done-subject = 完成：被裁剪多边形在裁剪多边形之内，保持原样。
wa-done-clip = 完成：裁剪多边形在被裁剪多边形之内，它就是答案。
wa-done-equal = 完成：两个多边形相同，答案也相同。
wa-done-crossing =
    { $n ->
       *[other] 完成：共 { $n } 块。
    }
wa-list-subject = 被裁剪多边形
wa-list-clip = 裁剪多边形
wa-row-start = 起点
wa-row-path = 路径顶点数
wa-row-rings = 已闭合的环
code-wa-find = 对 S 的每条边：表 S ← 顶点、与 C 的交点
code-wa-insert = 对 C 的每条边：表 C ← 顶点、其上的交点
code-wa-label = 标记每个交点：入点、出点、接触点、对顶点
code-wa-start = 只要还有未走过的入点：由此出发，沿表 S
code-wa-follow = 沿表前进，输出顶点
code-wa-enter = 遇到入点：转到表 S
code-wa-leave = 遇到出点：转到表 C
code-wa-close = 回到已输出的顶点：环闭合
code-wa-whole = 没有入点和出点的边界：在内部 ⇒ 一个环
code-wa-holes = 把每个内孔归给包围它的环
words-wa-find = 把被裁剪多边形 S 的顶点逐个抄入表中；每个顶点之后按顺序放入其边上的交点。
words-wa-insert = 用同样方法抄写裁剪多边形 C：交点相同，但按它自己边界的顺序。
words-wa-label = 按被裁剪多边形在交点处的走向标记。公共边上，两条边界同向算作内部，反向算作外部。
words-wa-start = 取一个还没有走过的入点，从被裁剪多边形的顶点表开始。
words-wa-follow = 沿顶点表逐点前进，并输出每个顶点。
words-wa-enter = 在入点和对顶点处，转到被裁剪多边形的顶点表。
words-wa-leave = 在出点和对顶点处，转到裁剪多边形的顶点表。
words-wa-close = 走到已经输出过的顶点时，其间就是一个环。走回起点时，行走结束。
words-wa-whole = 行走时从不换表的边界，整条在内部或整条在外部。
words-wa-holes = 内孔属于包围它的环。

## The verdict

verdict-vertex-kept = { $vertex } 保留。
verdict-vertex-cut = { $vertex } 在这里被裁去：在各条边界中，它最先落在这一条的外侧。
verdict-vertex-passed-by = 没有任何行走经过 { $vertex }：它不在结果中。
verdict-edge-dropped = 从 { $from } 到 { $to }，这段边被舍去。
verdict-vertex-in = 垂直于该边界（{ $edge }）向内移动 { $move }，{ $vertex } 就会保留。
verdict-vertex-never = 垂直于该边界（{ $edge }）怎样移动，{ $vertex } 都不会保留。
verdict-vertex-out = 垂直于最近的边界（{ $edge }）向外移动超过 { $move }，{ $vertex } 就会被裁去。
verdict-vertex-touch = { $vertex } 在边界（{ $edge }）上：稍向外移，就会被裁去。
