### 视锥体实验对一个顶点穿过各个空间的说明。

alg-viewing-pipeline = 观察流水线

## 空间

space-model = 模型
space-world = 世界
space-view = 观察
space-clip = 裁剪
space-ndc = NDC
space-screen = 屏幕
space-model-title = 模型空间
space-world-title = 世界空间
space-view-title = 观察空间：相机位于原点
space-clip-title = 裁剪空间，以 x、y、w 为轴
space-clip-parallel-title = 裁剪空间，以 x、y、z 为轴
space-ndc-title = NDC：已除以 w
space-screen-title = 屏幕，以像素计
object-vertex = 顶点
pipeline-note-world = 物体的大小、转动和位置
pipeline-note-view = 相机位于 { $at }
pipeline-note-clip = { $angle }°，{ $aspect } : 1，近平面 { $near }，远平面 { $far }
pipeline-note-clip-parallel = 高 { $height }，{ $aspect } : 1，近平面 { $near }，远平面 { $far }

## 伪代码

code-pipeline-world = world ← world_from_model · (P, 1)
code-pipeline-view = view ← view_from_world · (world, 1)
code-pipeline-clip = clip ← clip_from_view · (view, 1)
code-pipeline-test = 若 −w ≤ x, y, z ≤ w：在内部
code-pipeline-divide = 若 w > 0：ndc ← (x, y, z) / w
code-pipeline-screen = screen ← ((x + 1)/2 · 列数, (1 − y)/2 · 行数)
code-pipeline-behind = 否则：在屏幕上没有位置
words-pipeline-world = 物体自己的矩阵把顶点放进世界。
words-pipeline-view = 相机的矩阵给出从相机看来顶点在哪里。
words-pipeline-clip = 投影缩放 x 和 y，并把深度复制到 w。
words-pipeline-test = 裁剪检验的就是这个条件，此时还没有做除法。
words-pipeline-divide = 除以深度，远处的东西就变小。
words-pipeline-screen = 从 −1 … 1 变到像素，从左上角数起。
words-pipeline-behind = 不在视点前方的点没有像。

## 步骤

pipeline-opening = 一个顶点，坐标如建模者所给：它会落在屏幕的哪里？
pipeline-world-row = 物体矩阵的第 { $row } 行：把顶点缩放、转动、平移到它在世界中的位置。
pipeline-view-right = 第 1 行沿相机的右方量：P 偏右 { $value }。
pipeline-view-left = 第 1 行沿相机的右方量：P 偏左 { $value }。
pipeline-view-above = 第 2 行沿相机的上方量：P 比光轴高 { $value }。
pipeline-view-under = 第 2 行沿相机的上方量：P 比光轴低 { $value }。
pipeline-view-back = 第 3 行向后量：P 在相机后方 { $value } 处。
pipeline-view-ahead = 第 3 行向后量：P 在相机前方 { $value } 处，所以 z 为负。
pipeline-clip-x = 第 1 行缩放 x，使左右两面落在 x = ±w。
pipeline-clip-y = 第 2 行缩放 y，使上下两面落在 y = ±w。
pipeline-clip-z = 第 3 行把近平面放到 z = −w，远平面放到 z = w。
pipeline-clip-w = 第 4 行把深度复制到 w：{ $value }，之后 x、y、z 要除以它。
pipeline-clip-w-parallel = 第 4 行让 w 保持为 1：视线平行时不需要除法。
pipeline-inside = P 在内部：x、y、z 都在 −w 与 w 之间。
pipeline-outside = P 在外部：会被裁掉。
pipeline-divide = 除以 w = { $w }：内部的点落在 −1 与 1 之间。
pipeline-screen = 从 −1 … 1 变到 { $columns } × { $rows } 个像素，行从上往下数。
pipeline-behind = P 不在视点前方：它的 w 不能作除数，屏幕上也没有它的位置。

## 题目

object-model-matrix = 模型矩阵
object-camera = 相机
object-picture = 画面
json-whole = 一个整数
case-whole-too-large = { $number } 大于任何像素的编号。
case-picture-side = 画面的一边为 1 到 { $max } 个像素，实为 { $found }。
case-pipeline-inside = 在内部，屏幕位置为 { $screen }。
case-pipeline-outside = 在外部；若不裁剪，屏幕位置为 { $screen }。
case-pipeline-behind = 不在视点前方：屏幕上没有位置。
object-from = 起点
object-to = 终点
case-too-many-pixels = 该直线有 { $found } 个像素：最多接受 { $max } 个。
case-pixels = { $count } 个像素。

## 从线段到像素

alg-bresenham = 线段到像素（Bresenham）
raster-line = 屏幕，{ $columns } × { $rows } 个像素
raster-lens = 从中点到直线：e / { $whole } 个像素
code-drawn-project = clip ← clip_from_world · (P, 1)，两个端点
code-drawn-clip = 把线段裁剪到 −w ≤ x, y, z ≤ w
code-drawn-divide = S ← viewport(x / w, y / w)
code-drawn-begin = a, b ← |Δx|, |Δy| 中较长、较短者；e ← 2b − a
code-drawn-put = 放置像素；直到最后一个：
code-drawn-diagonal = 若 e > 0，或 e = 0 且横移后坐标较小：
code-drawn-across = 横移一格；e ← e − 2a
code-drawn-straight = 前进一格；e ← e + 2b
words-drawn-project = 投影：两个端点进入裁剪空间，还没有除法。
words-drawn-clip = 裁剪：去掉相机看不见的部分。
words-drawn-divide = 除以 w，换算成像素。
words-drawn-begin = 每个端点归入它的像素；e 说明直线在第一个中点的哪一侧。
words-drawn-put = 沿较长的轴逐个像素前进。
words-drawn-diagonal = 直线是否越过中点？恰好过中点时取较小的坐标。
words-drawn-across = 若是，沿较短的轴也走一格。
words-drawn-straight = 沿较长的轴走一格。
drawn-line-opening = 这条线段有哪些像素？
drawn-line-project = { $end } 进入裁剪空间：它的深度 { $w } 成为 w。
drawn-line-project-behind = { $end } 进入裁剪空间。它不在视点前方：不可除以 w = { $w }。
drawn-line-clip-whole = 整条线段在内部：什么也不裁。
drawn-line-clip-cut = 线段在做除法之前裁剪：剩下的部分 w > 0。
drawn-line-reject = 线段没有一点在内部：不画任何像素。
drawn-line-divide = 除以 w 并缩放之后，两个端点成为屏幕上的位置。
drawn-line-round = 每个端点归入它所在的像素；直线现在从中心到中心。
drawn-line-first = { $at } 是第一个像素。e 说明直线在下一个中点的哪一侧。
drawn-line-straight = e = { $e } < 0：直线未到中点。直走一格，到 { $at }。
drawn-line-diagonal = e = { $e } > 0：直线越过中点。斜走一格，到 { $at }。
drawn-line-tie-straight = e = 0：正好在两个像素中间，取坐标较小者：{ $at }。
drawn-line-tie-diagonal = e = 0：正好在两个像素中间，取坐标较小者：{ $at }，斜走。
