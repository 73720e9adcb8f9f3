### Why something is refused, or fails: one sentence for each typed error, whoever reports it.

## Shapes; the last part of the key is the code in the command line’s JSON where that has one

error-not-finite = 所有坐标都必须是有限数。
error-empty-window = 窗口为空：{ $low } = { $min } 必须小于 { $high } = { $max }。
error-too-few-vertices = 多边形至少需要三个顶点。
error-degenerate = 图形已退化：应有的长度或面积为零。
error-not-convex = 裁剪多边形必须是凸多边形：该算法只保留位于所有边内侧的部分。
error-self-intersecting = 多边形自相交。
error-edges-meet = 多边形的轮廓不得与自身相交或接触：第 { $first } 条边与第 { $second } 条边相交、接触或重叠。
error-misplaced-hole = 内孔 { $hole } 必须位于外轮廓之内，且不得与外轮廓或其他内孔接触。
error-at = { $place }：{ $problem }

## Shapes in space

error-empty-box = 盒为空：{ $low } = { $min } 不得大于 { $high } = { $max }。
error-zero-normal = 平面的法向量不得为零向量。
error-negative-radius = 半径不得为负，而这里是 { $radius }。
error-no-vertices = 没有顶点，就没有包围体。
error-target-at-position = 相机没有方向：目标点与相机位置重合。
error-up-along-view = 相机的上方向不得为零向量，也不得与视线方向平行。
error-field-of-view = 视场角必须大于 0° 且小于 180°，而这里是 { $degrees }°。
error-size = 大小必须大于 0，而这里是 { $size }。
error-height = 视见体的高度必须大于 0，而这里是 { $height }。
error-aspect = 宽高比必须大于 0，且使视见体具有有效的宽度，而这里是 { $aspect }。
error-near = 近平面必须位于视点前方，距离大于 0，而这里是 { $near }。
error-far = 远平面必须比近平面更远：far = { $far } 必须大于 near = { $near }。
error-not-affine = 该矩阵的最后一行必须是 0 0 0 1。
error-face-vertex = 第 { $face } 个面（从 0 数起）引用了不存在的顶点。
error-no-mesh-faces = 网格至少需要一个面。
error-uv-length = 网格的纹理坐标个数必须与顶点个数相同，或者为零：这里有 { $uvs } 个纹理坐标和 { $vertices } 个顶点。

## Scenes

error-no-objects = 场景至少需要一个物体。
error-too-many-objects = 场景最多容纳 { $limit } 个物体；这里有 { $count } 个。
error-no-such-object = 没有物体 { $focus }：场景中有 { $count } 个。
error-no-such-face = 没有面 { $face }：该物体有 { $count } 个面。
error-no-such-vertex = 没有顶点 { $vertex }：该物体有 { $count } 个顶点。
error-no-segments = 没有线段。
error-too-many-segments = 线段太多：有 { $count } 条，最多可有 { $limit } 条。
error-no-such-focus = 没有第 { $focus } 条线段：共有 { $count } 条，从 0 数起。
error-last-three = 保留该顶点：多边形至少需要三个顶点。
error-too-many-vertices = 顶点太多：有 { $count } 个，最多可有 { $limit } 个。

## Moments of a run

error-bad-moment = 这没有指明任何时刻。

## Files

error-unreadable = 无法读取文件：{ $reason }。
error-file-too-large = 文件大于 { $limit } MiB。
error-link-out = 这个文件是指向本课文件夹之外的链接。
memory-broken = 它不是设置文件。

## What the system answers; set after a colon, in the middle of a sentence

system-not-found = 文件或文件夹不存在
system-denied = 没有访问权限
system-exists = 它已经存在
system-is-folder = 它是一个文件夹
system-not-file = 它不是文件
system-not-folder = 路径中有一部分不是文件夹
system-full = 磁盘空间不足
system-read-only = 磁盘是只读的
system-bad-name = 名称无效
system-too-large = 文件过大
system-busy = 另一个程序正在使用它
system-no-files = 这里没有文件可用
system-loop = 它是指向自身的链接
system-number = 系统报告错误 { $number }
system-silent = 系统没有说明原因
error-typed-range = 应为 { $least } 到 { $most } 之间的数，但输入的是 { $typed }
error-typed-place = 应为 { $count } 个数，例如 −1.5 或 1/4，但输入的是 { $typed }

error-progress-broken = 这不是学习进度文件。
error-progress-version = 这个文件由更新版本的 Clipscope 写成。
