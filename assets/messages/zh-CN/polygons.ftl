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

## 逐点单击绘制轮廓

action-draw-subject = 绘制多边形
action-draw-clip = 绘制裁剪多边形
action-draw-hole = 绘制内孔
action-no-holes = 删除所有内孔
draw-subject = 单击放置新多边形的顶点 { $number }；Backspace 撤回一个，Esc 放弃。
draw-clip = 单击放置新裁剪多边形的顶点 { $number }；Backspace 撤回一个，Esc 放弃。
draw-hole = 单击放置新内孔的顶点 { $number }；Backspace 撤回一个，Esc 放弃。
draw-close = 单击放置顶点 { $number }；按 Enter、双击或单击第一个顶点即可闭合轮廓。
refused-last-three = 保留该顶点：多边形至少需要三个顶点。
refused-too-many = { $count } 个顶点过多：最多 { $most } 个。

## 可供选用的多边形与区域

preset-title = 示例多边形
preset-convex = 凸多边形
preset-triangle = 三角形
preset-arrow = 箭头（凹）
preset-comb = 梳形：裁成多块
preset-corner = 绕过窗口角：产生桥边
preset-spiral = 螺旋形
preset-star = 星形
preset-hole = 带内孔
preset-around = 包围整个窗口
preset-inside = 完全在窗口内
preset-touch = 只接触一点
preset-along = 一条边与边界重合
preset-bow-tie = 蝴蝶结：自相交
preset-random = 随机
random-count = 顶点数
random-make = 替换多边形
region-title = 裁剪区域
region-window = 窗口
region-corners = 窗口的四个角
region-triangle = 三角形
region-diamond = 菱形
region-octagon = 八边形
region-bracket = L 形（凹）
## Ear clipping

ear-opening = 把这个有 { $n } 个顶点的多边形切成三角形。
ear-classify = { $vertex } 是{ $corner }。
ear-classify-again = 邻点变了：现在 { $vertex } 是{ $corner }。
ear-convex = 凸顶点
ear-straight = 共线顶点
ear-reflex = 凹顶点
ear-round = 第 { $round } 轮开始，还有 { $n } 个顶点。
ear-pass = { $vertex } 是{ $corner }：不是耳尖。
ear-candidate = { $vertex } 是凸顶点。三角形 { $triangle } 内还有别的顶点吗？
ear-blocked = { $by } 落在三角形 { $triangle } 内：{ $vertex } 不是耳尖。
ear-ear = 三角形 { $triangle } 内没有别的顶点：这是一只耳朵，{ $vertex } 是耳尖。
ear-cut = 沿对角线 { $diagonal } 切下 { $triangle }：还剩 { $n } 个顶点。
ear-last = 只剩三个顶点：{ $triangle } 是最后一个三角形。
ear-done =
    { $n ->
        [1] 完成：本来就是一个三角形。
       *[other] 完成：共 { $n } 个三角形，比顶点数少 2。
    }
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
words-ear-classify = 在每个顶点 v 处，从前一点 a 到后一点 b，边界是左转、右转还是不转？
words-ear-round = 一轮一轮地走，直到只剩三个顶点。
words-ear-each = 检查上一轮中角有变化的每个顶点；第一轮检查全部顶点。
words-ear-convex = 只有在边界左转的地方，角才可能被切下。
words-ear-empty = 三角形内不得有别的顶点；只需检查那些不是凸的顶点。
words-ear-cut = 这是一只耳朵：沿对角线 ab 切下。
words-ear-again = a、b 处的角变了：重新分类，下一轮再检查这两点。
words-ear-last = 剩下的就是一个三角形。

## Triangulate, then clip

tac-opening = 先把这个有 { $n } 个顶点的多边形切成三角形，再逐个裁剪。
tac-triangle = 第 { $number } 个三角形（共 { $total } 个）：{ $triangle }。
tac-whole = { $triangle } 全部在区域内：原样就是一块。
tac-piece = { $triangle } 留下一块有 { $n } 个顶点的凸多边形。
tac-none = { $triangle } 在区域内什么也没留下。
tac-touch = { $triangle } 只与区域相接：不留下任何一块。
tac-finish =
    { $n ->
        [0] 完成：一块也没有，多边形没有伸进区域。
       *[other] 完成：共 { $n } 块，都是凸的，没有桥边。
    }
tac-now = 三角形
tac-pieces = 块数
code-tac-triangulate = 三角形列表 ← 耳切法(多边形)
code-tac-each = 对每个三角形：
code-tac-clip = 环 ← Sutherland–Hodgman(三角形, 区域)
code-tac-piece = 若环的面积不为零，则输出环
words-tac-triangulate = 用耳切法把多边形切成三角形。
words-tac-each = 逐个处理三角形。
words-tac-clip = 用萨瑟兰–霍奇曼算法裁剪它：凸多边形裁剪后仍是凸的。
words-tac-piece = 若还剩下可以填充的部分，它就是答案中的一块。
