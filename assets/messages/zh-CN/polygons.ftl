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
