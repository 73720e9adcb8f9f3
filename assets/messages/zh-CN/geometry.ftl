### The words of the field that all labs share: objects, edges, regions, algorithms, verdicts.

## Objects

object-segment = 线段
object-window = 裁剪窗口
object-clip-polygon = 裁剪多边形
object-polygon = 多边形
object-hole = 内孔
object-uv = 纹理坐标
object-outcode = 区域码
object-planes = 平面
object-point = 点
object-view-volume = 视见体
object-sphere = 球
object-box = 盒
object-triangle = 三角形
object-eye = 视点
object-view-direction = 视线方向
object-culled = 剔除
object-backs = 背面朝向视点的三角形

## The window’s edges, as nouns; the sides alone agree with “edge”

edge-left = 左边界
edge-right = 右边界
edge-bottom = 下边界
edge-top = 上边界
side-left = 左
side-right = 右
side-bottom = 下
side-top = 上

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
alg-weiler-atherton = Weiler–Atherton
alg-ear-clipping = 耳切法
alg-triangulate-and-clip = 先三角剖分，再裁剪

## Verdicts, said of a segment, a polygon, a triangle or an object

verdict-entering = 进入
verdict-leaving = 离开
verdict-parallel = 平行
