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
