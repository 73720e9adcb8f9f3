### The words of the field that all labs share: objects, edges, regions, algorithms, verdicts, refusals.

## Objects

object-segment = 线段
object-window = 裁剪窗口
object-clip-polygon = 裁剪多边形
object-polygon = 多边形
object-triangle = 三角形
object-vertex = 顶点
object-edge = 边
object-plane = 平面
object-normal = 法向量
object-intersection = 交点
object-outcode = 区域码
object-clip-volume = 裁剪体
object-frustum = 视锥体
object-sphere = 包围球
object-mesh = 网格模型
object-scene = 场景
object-eye = 视点
object-camera = 相机
object-ray = 光线
object-pixel = 像素
object-depth = 深度

## The window’s edges, as nouns; the sides alone agree with “edge”

edge-left = 左边界
edge-right = 右边界
edge-bottom = 下边界
edge-top = 上边界
side-left = 左
side-right = 右
side-bottom = 下
side-top = 上
side-near = 近
side-far = 远

## The planes of a clip volume, as nouns

plane-left = 左平面
plane-right = 右平面
plane-bottom = 下平面
plane-top = 上平面
plane-near = 近平面
plane-far = 远平面

## The nine regions around the window

region-above-left = 左上方
region-above = 上方
region-above-right = 右上方
region-left = 左侧
region-inside = 窗口内
region-right = 右侧
region-below-left = 左下方
region-below = 下方
region-below-right = 右下方

## Algorithms

alg-brute-force = 直接求交法
alg-cohen-sutherland = Cohen–Sutherland
alg-liang-barsky = 梁友栋–Barsky
alg-cyrus-beck = Cyrus–Beck
alg-nicholl-lee-nicholl = Nicholl–Lee–Nicholl
alg-cohen-sutherland-3d = 三维 Cohen–Sutherland
alg-liang-barsky-3d = 三维梁友栋–Barsky
alg-plane-line = 用平面裁剪线段
alg-homogeneous-line = 裁剪空间中的线段
alg-sutherland-hodgman = Sutherland–Hodgman
alg-weiler-atherton = Weiler–Atherton
alg-ear-clipping = 耳切法
alg-plane-at-a-time = 逐平面裁剪
alg-intersection-polygon = 交多边形法
alg-homogeneous-triangle = 裁剪空间中的三角形
alg-sphere-cull = 包围球剔除
alg-back-face = 背面剔除
alg-depth-buffer = Z 缓冲
alg-painter = 画家算法
alg-ray-casting = 光线投射
alg-bresenham = Bresenham

## Verdicts, said of a segment, a polygon, a triangle or an object

verdict-accepted = 接受
verdict-rejected = 舍弃
verdict-clipped = 被裁剪
verdict-touches = 触及边界
verdict-inside = 在内
verdict-outside = 在外
verdict-on = 在边界上
verdict-straddles = 部分在内
verdict-entering = 进入
verdict-leaving = 离开
verdict-parallel = 平行
verdict-visible = 可见
verdict-hidden = 被遮挡
verdict-culled = 被剔除
verdict-front = 正面
verdict-back = 背面

## Why an input is refused; the last part of the key is the error’s code in the command line’s JSON

error-bad-json = 这不是有效的 JSON。
error-unknown-algorithm = 没有这个名称的算法。
error-unknown-field = 此处没有这个名称的字段。
error-missing-field = 缺少一个字段。
error-wrong-type = 值的类型不对。
error-wrong-length = 列表的长度不对。
error-not-finite = 所有坐标都必须是有限数。
error-empty-window = 裁剪窗口为空：左边界必须在右边界左侧，下边界必须在上边界下方。
error-not-convex = 裁剪多边形必须是凸多边形：该算法只保留位于所有边内侧的部分。
error-self-intersecting = 多边形自相交。
error-degenerate = 图形已退化：应有的长度或面积为零。
error-too-few-vertices = 多边形至少需要三个顶点。
error-zero-normal = 平面的法向量不能为零。
error-bad-frustum = 视锥体要求 0° < 视场角 < 180°、宽高比为正，且 0 < 近 < 远。
error-too-large = 超出了本程序能处理的规模。
error-at = { $place }：{ $problem }
