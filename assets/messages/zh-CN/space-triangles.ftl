### 空间三角形裁剪时所说的话：逐平面、整个多边形、透视除法之前。

## 方法

alg-plane-at-a-time = 逐平面裁剪
alg-intersection-polygon = 整个多边形，最后作扇形剖分
alg-textured-triangle = 带纹理的整个多边形
alg-homogeneous-triangle = 除以 w 之前裁剪三角形
alg-faulty-missed-edge = 错误：d₀ = 0 时三角形原样保留
alg-faulty-on-plane = 错误：平面上的点算在外侧
alg-faulty-kept-uv = 错误：(u, v) 没有插值
alg-undivided-texture = 错误：贴图时不做除法
alg-faulty-edge-by-edge = 错误：把边当作线段裁剪
alg-faulty-all-sides = 错误：六个面全都用来裁剪
alg-faulty-divided-triangle = 错误：先除以 w，再裁剪

## 视图

tri-list-in = 输入表
tri-list-out = 输出表
tri-list-given = 三角形
tri-list-left = 剩下的部分
tri-corners = 顶点
tri-none = 不成三角形
tri-not-asked = 未检验
tri-list-fan = 从 V₀ 出发的扇形：{ $vertices } − 2 = { $triangles } 个三角形
tally-triangles = 三角形
tally-crossings = 交点
tally-one-polygon = 整个多边形
tally-one-by-one = 逐个三角形
tally-same = 两种方法留下同样的 { $n } 个顶点，一致到小数点后 { $decimals } 位。

## 整个多边形

ip-opening = 用 { $planes } 个平面裁剪一个多边形：表从三角形的 { $n } 个顶点开始。
ip-plane = { $plane }平面接到 { $n } 个顶点的表。
ip-first-inside = { $vertex } 在{ $plane }平面内侧：输出。
ip-first-outside = { $vertex } 在{ $plane }平面外侧：不输出。
ip-touch = { $from } → { $to }：{ $rule }。平面上的端点就是交点。
ip-in-out = { $from } → { $to }：内 → 外。输出交点 { $cut }。
ip-out-in = { $from } → { $to }：外 → 内。先输出交点 { $cut }，再输出 { $to }。
ip-closing-cross = 闭合边 { $from } → { $to }：{ $rule }。只输出交点 { $cut }。
ip-cross = { $from } → { $to } 与{ $plane }平面交于 { $cut }。
ip-output = { $vertex } 进入输出表，表中现有 { $n } 个顶点。
ip-pass-cuts = { $plane }平面去掉 { $dropped }，放入 { $cuts }：{ $before } → { $after }。
ip-pass-drops = { $plane }平面去掉 { $dropped }：{ $before } → { $after }。
ip-pass-same = { $plane }平面什么也没切：{ $before } → { $after }。
ip-pass-empty = { $plane }平面之后什么也不剩：{ $before } → { $after }。
ip-fan = 扇形的第 { $n } 个三角形，共 { $total } 个：{ $corners }。
ip-done = 完成：{ $vertices } 个顶点，扇形剖分成 { $n } 个三角形，求交 { $crossings } 次。
ip-done-empty = 完成：没有剩下有面积的部分。三角形 { $n } 个，顶点 { $vertices } 个，求交 { $crossings } 次。
code-ip-each = 对每个平面 (n, D)：
code-ip-first = 若 d(V₀) ≥ 0：输出 V₀
code-ip-distance = 对每条边 S → P：d ← n·P + D
code-ip-inside = 若 d ≥ 0 且 P ≠ V₀：输出 P
code-ip-cross = 两端不同侧处：输出 C
code-ip-pass = 表 ← 输出的顶点
code-ip-fan = 三角形 ← 表的扇形
words-ip-each = 依次检验每个平面；法向量指向内侧。
words-ip-first = 若第一个顶点在内侧，就输出它；平面上的点算在内侧。
words-ip-distance = 逐边前进，最后一条回到 V₀；求每条边终点的有符号距离。
words-ip-inside = 然后，若终点在内侧就输出它；V₀ 已经在表中。
words-ip-cross = 边从一侧到另一侧时，输出它与平面的交点：t = d₁ / (d₁ − d₂)。
words-ip-pass = 输出的顶点就是下一个平面的表。
words-ip-fan = 凸多边形只在最后剖分成三角形，只做一次。

## 逐个三角形

pat-opening = 用 { $planes } 个平面逐个裁剪三角形：表从 { $n } 个三角形开始。
pat-plane = { $plane }平面接到 { $n } 个三角形。
pat-three = { $triangle }：{ $inside } 个顶点在{ $plane }平面内侧，原样保留。
pat-two = { $triangle }：{ $inside } 个顶点在{ $plane }平面内侧，剩一个四边形，分成两个三角形。
pat-one = { $triangle }：{ $inside } 个顶点在{ $plane }平面内侧，剩一个三角形。
pat-on = { $triangle }：3 个顶点中 { $inside } 个在{ $plane }平面内侧，其中在平面上的有 { $on } 个。
pat-none = { $triangle }：{ $inside } 个顶点在{ $plane }平面内侧，舍弃。
pat-option-three = { $triangle } 的三个顶点都在内侧。
pat-option-two = { $triangle } 有两个顶点在内侧。
pat-option-one = { $triangle } 有一个顶点在内侧。
pat-option-none = { $triangle } 没有顶点在内侧。
pat-piece = 输出表的第 { $n } 个三角形：{ $corners }。
pat-pass = { $plane }平面接到 { $before } 个，交出 { $after } 个三角形。
pat-pass-empty = { $plane }平面接到 { $before } 个，交出 { $after } 个：什么也不剩。
pat-done = 完成：剩下 { $n } 个三角形，求交 { $crossings } 次。
pat-done-empty = 完成：剩下 { $n } 个三角形，求交 { $crossings } 次。
code-pat-each = 对每个平面 (n, D)：
code-pat-triangle = 对每个三角形：数 d ≥ 0 的个数
code-pat-three = 3：保留
code-pat-two = 2：切成两个三角形
code-pat-one = 1：切成一个三角形
code-pat-none = 0：舍弃
code-pat-pass = 表 ← 保留的三角形
words-pat-each = 依次检验每个平面；法向量指向内侧。
words-pat-triangle = 三角形有几个顶点在内侧？
words-pat-three = 若三个都在，原样保留。
words-pat-two = 若有两个，剩下四边形，从它的第一个顶点分开。
words-pat-one = 若有一个，切成一个较小的三角形。
words-pat-none = 若一个也没有，舍弃。
words-pat-pass = 保留的三角形就是下一个平面的表。

## 除法之前

ht-opening = 裁剪空间中有 { $n } 个顶点，其中 { $behind } 个 w ≤ 0：还没有做除法。
ht-divide = { $n } 个顶点都除以各自的 w。
ht-codes-outside = 所有顶点都在同一个面的外侧：不必裁剪，直接舍弃；区域码涉及 { $sides } 个面。
ht-codes-inside = 没有顶点在任何面的外侧：原样保留；区域码涉及 { $sides } 个面。
ht-codes-cut = 区域码只涉及六个面中的 { $sides } 个：只用它们裁剪。
ht-side = { $side }面接到 { $n } 个顶点：只看一个和的符号，不做除法。
ht-inside = { $vertex } 在{ $side }面内侧。
ht-outside = { $vertex } 在{ $side }面外侧。
ht-cross = { $from } → { $to } 与{ $side }面交于 I。
ht-pass = { $side }面完成：{ $before } → { $n }。
ht-done = 剩下 { $n } 个顶点，扇形剖分成 { $triangles } 个三角形：现在可以除以 w。
ht-done-empty = 没有剩下有面积的部分：顶点 { $n } 个，三角形 { $triangles } 个。
code-ht-codes = 每个顶点六位：w ± x, y, z < 0
code-ht-decide = OR = 0：保留；AND ≠ 0：舍弃
code-ht-each = 对 OR 涉及的每个面：
code-ht-first = 若 V₀ 处 w ± x ≥ 0：输出 V₀
code-ht-bound = 对每条边 S → P：P 的 w ± x
code-ht-cross = 变号处：输出 I
code-ht-inside = 若 w ± x ≥ 0 且 P ≠ V₀：输出 P
code-ht-fan = 扇形剖分，然后除以 w
words-ht-codes = 对 −w ≤ x, y, z ≤ w 的每个面，顶点在其外侧就记一位 1。
words-ht-decide = 无需裁剪，或者什么也看不见。
words-ht-each = 只需检验有顶点在其外侧的面。
words-ht-bound = 判据只是一个和的符号：不用除法，w 正负皆可。
words-ht-cross = 四个坐标都用同一个 t 插值。
words-ht-fan = 剩下的部分 w ≥ near > 0，可以除以 w。

## 哪里错了？

faulty-missed-edge-differs = 从第 { $step } 步起出现差别：d₀ = 0 时两个乘积都不为负，三角形被原样保留。
faulty-on-plane-differs = 从第 { $step } 步起出现差别：平面上的顶点被当作外侧的顶点。
faulty-kept-uv-differs = 从第 { $step } 步起出现差别：交点沿用了外侧顶点的 (u, v)。
faulty-edge-by-edge-differs = 从第 { $step } 步起出现差别：三条边各自裁剪，而不是作为一个轮廓。
faulty-all-sides-differs = 从第 { $step } 步起出现差别：检验了区域码没有涉及的面，而这个面什么也没切。
faulty-divided-triangle-differs = 从第 { $step } 步起出现差别：还没裁剪，各顶点就除以了 w。
code-faulty-missed-edge = 若 d₀·d₁ < 0 或 d₀·d₂ < 0：切
words-faulty-missed-edge = 只有第一个距离与另一个异号时才切。
code-faulty-on-plane = 若 d > 0 且 P ≠ V₀：输出 P
code-faulty-on-plane-first = 若 d(V₀) > 0：输出 V₀
words-faulty-on-plane-first = 若第一个顶点严格在内侧，就输出它。
words-faulty-on-plane = 然后，若终点严格在内侧就输出它。
code-faulty-kept-uv = 输出 C，uv(C) ← uv(V)
words-faulty-kept-uv = 交点沿用它所代替的顶点的 (u, v)。
code-undivided-texture = 扇形剖分，填充：uv 在屏幕上线性变化
words-undivided-texture = 把多边形剖分成扇形的三角形；在屏幕上插值 (u, v) 时不用 1/w。
code-faulty-edge-by-edge = 对每个平面：裁剪每条边
words-faulty-edge-by-edge = 依次用每个平面裁剪；它把三条边当作三条线段。
code-faulty-all-sides = 对六个面中的每一个：
words-faulty-all-sides = 六个面逐一检验，不看区域码。
code-faulty-divided-triangle = (x, y, z) ← (x, y, z)/w，再算六位
words-faulty-divided-triangle = 每个顶点先除以 w，然后才检验。

## 算例

object-triangle-uv = 纹理坐标
case-triangles-left = 剩下 { $triangles } 个三角形。
case-triangles-none = 没有剩下有面积的部分。
