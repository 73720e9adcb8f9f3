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
refused-not-convex = 该算法要求裁剪区域是凸的：{ $part }在 { $vertex } 处拐向了错误的一侧。
refused-winds-twice = 该算法要求简单多边形：到 { $vertex } 为止，{ $part }已绕行不止一圈。
refused-degenerate = 没有可裁剪的内容：{ $part }的面积为零。

## 萨瑟兰–霍奇曼算法

alg-sutherland-hodgman = 萨瑟兰–霍奇曼算法
alg-sutherland-hodgman-pipeline = 萨瑟兰–霍奇曼算法（流水线形式）
rule-in-in = 内 → 内
rule-in-out = 内 → 外
rule-out-in = 外 → 内
rule-out-out = 外 → 外
sh-inside = 内侧
sh-outside = 外侧
sh-bridge = 桥接边
sh-opening = 把整个多边形（{ $n } 个顶点）依次对裁剪区域的每条边裁剪：共 { $edges } 条边。
sh-edge-side = 对{ $edge }裁剪：内侧为 { $inside }。
sh-edge = 对边 { $edge } 裁剪：内侧为 { $inside }。
sh-first-inside = 第一个顶点 { $vertex } 在内侧：输出。
sh-first-outside = 第一个顶点 { $vertex } 在外侧：不输出。
sh-in-in = { $from } → { $to }：内 → 内。输出 { $to }。
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
sh-done-empty = 完成：多边形没有任何部分在裁剪区域内。最后一张表的长度为 { $n }；裁剪边共 { $edges } 条。
sh-done-whole = 完成：{ $n } 个顶点都在全部 { $edges } 条边的内侧，多边形保持原样。
sh-done-cut = { $edges } 条边处理完毕：剩下一个有 { $n } 个顶点的环。
sh-done-degenerate = { $edges } 条边处理完毕：剩下的部分没有面积。最后一张表的长度为 { $n }。
code-sh-each = 对每条裁剪边：输出表 ← 空
code-sh-first = F ← 第一个顶点；若在内侧，输出 F
code-sh-edges = 对每条边 S → P，最后回到 F：
code-sh-in-in = 内 → 内：输出 P
code-sh-in-out = 内 → 外：输出 I
code-sh-out-in = 外 → 内：输出 I、P
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

## 萨瑟兰–霍奇曼算法的流水线形式

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
pipe-cross = S 与其后的顶点分别在 { $border } 的两侧：边与它交于 I。
pipe-output = { $at } 离开最后一个裁剪器：它最终成为环的顶点 { $vertex }。
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

## 故意出错的萨瑟兰–霍奇曼算法

alg-faulty-on-border = 错误：把边界算作外侧
alg-faulty-open = 错误：漏掉闭合边
alg-faulty-clockwise = 错误：顺时针走裁剪边
alg-faulty-twice = 错误：交点输出两次
alg-faulty-end-first = 错误：先输出终点，后输出交点
faulty-on-border-differs = 第 { $step } 步最先出现差别：边界上的顶点被当作在外侧。
faulty-open-differs = 第 { $step } 步最先出现差别：从最后一个顶点回到第一个顶点的闭合边从未被检查。
faulty-clockwise-differs = 第 { $step } 步最先出现差别：顺时针走裁剪边，于是每条边的错误一侧被当作内侧。
faulty-twice-differs = 第 { $step } 步最先出现差别：同一个交点又输出了一次。
faulty-end-first-differs = 第 { $step } 步最先出现差别：边进入内侧，却先输出终点，后输出交点。
