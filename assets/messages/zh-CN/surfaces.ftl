### 表面实验室的用语：逐像素判断哪个表面在前面。

alg-depth-buffer = 深度缓冲
alg-faulty-depth-clear = 深度缓冲，初始化为 0
alg-faulty-depth-compare = 深度缓冲，比较方向颠倒
alg-faulty-depth-always = 深度缓冲，不做比较
alg-faulty-depth-straight = 深度缓冲，距离在屏幕上直接线性插值

## Pseudocode

code-depth-clear = 画面 ← 背景，z ← ∞
words-depth-clear = 把画面清为背景色，把每个深度初始化为无穷大。
code-depth-clear-reversed = 画面 ← 背景，z ← −∞
words-depth-clear-reversed = 把画面清为背景色，把每个深度初始化为负无穷大：没有比它更远的。
code-depth-triangle = 对每个三角形 T
words-depth-triangle = 逐个取三角形，次序任意。
code-depth-fragment = 对 T 中每个像素：z_T ← T 在此处的深度
words-depth-fragment = 对中心被三角形覆盖的每个像素，求三角形在该处的深度。
code-depth-compare = 若 z_T < z[像素]
words-depth-compare = 与该处已存的深度比较。
code-depth-compare-reversed = 若 z_T > z[像素]
code-depth-write = 画面[像素] ← T，z[像素] ← z_T
words-depth-write = 如果更小，就写入三角形及其深度。
words-depth-write-reversed = 如果更大，就写入三角形及其深度：1 表示近。
code-faulty-depth-clear = 画面 ← 背景，z ← 0
words-faulty-depth-clear = 把每个深度初始化为 0，即近平面的深度。
code-faulty-depth-clear-reversed = 画面 ← 背景，z ← 1
words-faulty-depth-clear-reversed = 把每个深度初始化为 1，即近平面的深度。
code-faulty-depth-compare = 若 z_T > z[像素]
words-faulty-depth-compare = 新深度更大时写入。
words-faulty-depth-compare-reversed = 新深度更小时写入，尽管 1 表示近。
code-faulty-depth-always = 总是
words-faulty-depth-always = 总是写入，不比较深度。
code-faulty-depth-straight = 对 T 中每个像素：z_T ← 距离，在屏幕上线性插值
words-faulty-depth-straight = 不做透视除法，把观察空间中的距离在屏幕上直接线性插值。
faulty-depth-clear-differs = 从第 { $step } 步起出现差别：没有什么比近平面更近，所以什么也写不进去。
faulty-depth-compare-differs = 从第 { $step } 步起出现差别：这个三角形比已存的更近，却没有写入。
faulty-depth-always-differs = 从第 { $step } 步起出现差别：这个三角形不比已存的更近，仍写入。
faulty-depth-straight-differs = 从第 { $step } 步起出现差别：这不是该表面的深度，因为距离在屏幕上不是线性的。

## The depth buffer

depth-opening = { $triangles } 个三角形，{ $columns } × { $rows } 个像素。每个像素存一个深度，共 { $pixels } 个，每个 { $bits } 位，合计 { $bytes } 字节。
depth-clear = 画面已清空：{ $pixels } 个像素都还没有三角形。
depth-triangle = 轮到 { $triangle }，第 { $place } 个，共 { $triangles } 个。
depth-triangle-unseen = { $triangle } 什么也不画：它在视见体之外，或侧对相机，或背向相机。
depth-answer-drawn = 画 { $triangle }。
depth-triangle-whole = 画完 { $triangle }。片元数：{ $fragments }，写入：{ $writes }。
depth-span = { $triangle } 的第 { $row } 行，第 { $first } 到 { $last } 列：{ $fragments } 个片元中写入 { $writes } 个。
depth-fragment-first = 像素 { $at } 还空着：写入 { $triangle }。
depth-fragment-kept = 在像素 { $at }，{ $triangle } 比 { $other } 近：写入。
depth-fragment-lost = 在像素 { $at }，{ $triangle } 不比 { $other } 近：{ $other } 保留。
depth-fragment-kept-behind = 在像素 { $at }，{ $triangle } 不比 { $other } 近，却写入了。
depth-fragment-tie = 在像素 { $at }，{ $triangle } 与 { $other } 一样近：{ $other } 先到，保留。
depth-fragment-lost-to-nothing = 像素 { $at } 虽然还空着，{ $triangle } 却没有写入。
depth-nothing = 空
depth-done = 完成：{ $fragments } 个片元，写入 { $writes } 次，占 { $pixels } 个像素。平均每个像素计算的次数：
raster-brightness = 亮度，以千分之一计
raster-brightness-bare = 亮度

## Views

practice-then = 之后存的值
raster-depth = 深度，以千分之一计
raster-depth-bare = 深度
raster-depth-unit = 深度，以 { $unit } 为单位
raster-straight = 近平面到远平面的距离，以千分之一计
raster-straight-bare = 近平面到远平面的距离
raster-depth-steps = { $bits } 位深度：0 到 { $last }
raster-distance = 到相机的距离
raster-counts-none = 每个像素计算的次数
raster-counts = 计算次数：{ $seen } 次可见，{ $vain } 次白算
raster-counts-before = 画所有面：{ $seen } 次可见，{ $vain } 次白算
raster-counts-after = 剔除背面：{ $seen } 次可见，{ $vain } 次白算
painter-depths = 每个三角形的距离：从最近的顶点到最远的顶点
asks-what = 测试
asks-now = 此刻
asks-so-far = 目前
asks-done = 已完成
asks-of = { $count } / { $all }
asks-ray-casting = 每个像素：哪个三角形？
asks-depth-buffer = 每个三角形：哪些像素？
asks-painter = 每一对：谁先画？
raster-pairs = 对 { $triangles } 个三角形两两检验 { $pairs } 次
raster-questions = { $pixels } 条光线测试 { $questions } 次
occlusion-triangles = 每个物体的三角形数
scale-near = 近 { $value }
scale-far = { $value } 远
raster-wrong = { $count } 个像素有误
depth-glass-behind = 在像素 { $at }，{ $triangle } 在 { $other } 后面而被舍弃，虽然 { $other } 让 { $through } 的光透过。
depth-glass-done = 完成：{ $unsorted ->
    [0] 在每个像素，每个面都画在它后面的面之后
   *[other] 在 { $unsorted } 个像素，玻璃先于它后面的面到来，后面的面被舍弃：每个像素只有一个深度，记不住次序
  }。平均每个像素计算的次数：
depth-done-stored = 完成：{ $pixels } 个像素的深度从 { $least } 到 { $most }。
depth-done-distance = 完成：{ $pixels } 个像素的距离从 { $least } 到 { $most }。
depth-done-nothing = 完成：{ $fragments } 个片元，一个也没有写入。
curve-whole = 深度随距离的变化
curve-enlarged = 放大
curve-forward = 未反向
curve-reversed = 反向
curve-near = 近平面在 { $near }
curve-step = 深度步长：{ $step }
curve-distance = 距离
curve-depth = 深度
story-title = 像素 { $at }：按到达次序
story-held = 已存深度
story-nearer = 更近
story-stored = 已存
story-fate = 结果
story-kept = 写入
story-lost = 舍弃
story-stays = 写入，保留
story-tie = 同样近：舍弃
watch-triangle = 三角形
watch-pixel = 像素
watch-fragments = 片元
watch-writes = 写入
watch-pixels = 像素数

## Ray casting

alg-ray-casting = 光线投射
code-ray-pixel = 对每个像素：过其中心的光线 o + t · r
words-ray-pixel = 对每个像素，取从视点穿过其中心的光线。
code-ray-triangle = 对每个三角形 T，平面 n·p + d = 0
words-ray-triangle = 逐个测试三角形。
code-ray-parallel = 若 n·r = 0：不命中
words-ray-parallel = 平行于平面的光线与它没有交点。
code-ray-plane = t ← −(n·o + d) / (n·r)
words-ray-plane = 求光线与平面的交点。
code-ray-range = 若 t < 1 或超出远平面：不命中
words-ray-range = 视点后方、近平面之前和远平面之外的都看不见。
code-ray-inside = 若 o + t · r 在 T 内：命中
words-ray-inside = 若交点在三角形内，就是命中。
code-ray-nearest = 画面[像素] ← t 最小的 T
words-ray-nearest = t 最小的命中可见。
ray-opening = { $columns } × { $rows } 个像素，{ $rays } 条光线，每条测试 { $triangles } 个三角形。
ray-pixel = 穿过像素 { $at } 中心的光线：t = 0 在视点，t = 1 在近平面上。
ray-hit-first = 光线命中 { $triangle }：目前最近的命中。
ray-hit-nearer = 光线命中 { $triangle }，它在 { $other }（t = { $t }）前面：现在它最近。
ray-hit-farther = 光线也命中 { $triangle }，它在 { $other }（t = { $t }）后面。
ray-answer-farther = 光线命中 { $triangle }，但在最近的命中后面。
ray-says-culled = 不测试 { $triangle }：它侧对或背向视点。
ray-says-parallel = 光线与 { $triangle } 的平面平行：n·r = 0，永不相交。
ray-says-behind = 与 { $triangle } 的平面交于视点后方：t < 0。
ray-says-before-near = 与 { $triangle } 的交点在近平面之前：t < 1。
ray-says-beyond-far = 与 { $triangle } 的交点在远平面之外。
ray-says-beside = 光线与 { $triangle } 的平面交于三角形之外：未命中。
ray-seen = 像素 { $at } 显示 { $triangle }：它是 { $hits } 个命中中 t 最小的。
ray-seen-before-others = 像素 { $at } 取 { $triangle }：{ $hits } 个命中里光线止于 t = { $t }，{ $hidden } 被 { $triangle } 遮住。
ray-seen-nothing = 像素 { $at } 保持背景色：光线没有命中任何三角形。
ray-done = 完成：{ $rays } 条光线，每条测试 { $triangles } 个三角形。
ray-culled = 未测试
ray-parallel = 平行
ray-behind = 视点后方
ray-before-near = 近平面之前
ray-beyond-far = 远平面之外
ray-beside = 三角形外
ray-hit = 在后面
ray-nearest = 最近
ray-eye = 视点
ray-raster = 光栅
raster-so-far = 目前的画面
watch-hits = 命中数
watch-nearest = 最近
watch-asked = 测试次数

## Painter's algorithm

alg-painter = 画家算法
alg-faulty-painter-nearest = 画家算法，按最近顶点排序
alg-faulty-painter-keys = 画家算法，只排序，不检验
code-paint-key = 对每个三角形 T：排序键 ← 其最远顶点的距离
words-paint-key = 三角形的排序键是其最远顶点的距离。
code-paint-sort = 按排序键排序，最远的在先
words-paint-sort = 按排序键排序，最远的在前。
code-paint-ask = 对表中每个 P：P 可否先于剩下的每个 Q？
words-paint-ask = 取剩下的第一个三角形，检验它能否先于其余各个。
code-paint-object = 若 P 遮挡 Q 的一部分：Q 必须先于 P
words-paint-object = 若它遮住另一个的一部分，那一个必须先画，接着检验那一个。
code-paint-cycle = 若 Q 在等 P：循环
words-paint-cycle = 若那一个已经在等待，就没有正确的次序。
code-paint-place = 否则下一个是 P
words-paint-place = 若它不遮住其他任何一个，下一个就是它。
code-paint-paint = 按此次序全部画出
words-paint-paint = 按此次序绘制，后画的盖住先画的。
code-faulty-painter-nearest = 对每个三角形 T：排序键 ← 其最近顶点的距离
words-faulty-painter-nearest = 三角形的排序键取其最近顶点的距离。
code-faulty-painter-keys = 对表中每个 P：下一个是 P
words-faulty-painter-keys = 照排好的次序取，不做检验。
faulty-painter-nearest-differs = 从第 { $step } 步起出现差别：排序键取了最近顶点的距离，而不是最远顶点的。
faulty-painter-keys-differs = 从第 { $step } 步起出现差别：没有检验这个三角形能否接着画。
surfaces-first = 只取 { $all } 个三角形中的前 { $triangles } 个：全部的步骤太多，没法跟踪。
refused-too-many-faces = 不接受：场景有 { $triangles } 个三角形，这个方法最多接受 { $most } 个。请移除一些物体，或者换一个方法。
painter-opening = 要画 { $triangles } 个三角形，最远的先画：后画的遮住先画的。
painter-key = { $triangle } 的排序键是 { $key }。它的顶点位于这两个距离之间：
painter-sort = { $triangle } 在表中排第 { $place }，最远的在前。
painter-pair-depths = { $triangle } 比整个 { $other } 都远：可以先画。
painter-pair-screen = { $triangle } 与 { $other } 在屏幕上分开：谁先画都可以。
painter-pair-behind = { $triangle } 在 { $other } 的平面后面：可以先画。
painter-pair-before = { $other } 在 { $triangle } 的平面前面：{ $triangle } 可以先画。
painter-pair-overlap = 在屏幕上任何一处，{ $triangle } 都不比 { $other } 近：可以先画。
painter-pair-hides = { $triangle } 遮住 { $other } 的一部分：不能先画。
painter-ask-depths = 1  { $triangle } 是否比整个 { $other } 都远？
painter-ask-screen = 2  二者在屏幕上是否分开？
painter-ask-behind = 3  { $triangle } 是否在 { $other } 的平面后面？
painter-ask-before = 4  { $other } 是否在 { $triangle } 的平面前面？
painter-ask-overlap = 5  { $triangle } 是否处处都不更近？
painter-yes = 是
painter-no = 否
painter-not-asked = 未检验
painter-constraint = { $before } 必须先于 { $after } 绘制。
painter-place = { $triangle } 不遮住剩下的任何一个：它是第 { $place } 个，共 { $triangles } 个。
painter-cycle-first = 出现循环：{ $triangle } 在等它自己。
painter-cycle-next = { $before } 必须先于 { $triangle } 绘制。
painter-cycle-closes = { $before } 必须先于 { $triangle } 绘制，{ $triangle } 又必须先于 { $first } 绘制：构成循环。
painter-paint = { $triangle } 画在最上面：第 { $place } 个，共 { $triangles } 个。
painter-done = 完成：{ $triangles } 个三角形，检验了 { $pairs } 对。
painter-done-cycle = 没有正确的次序：{ $cycle } 个三角形中每个都必须先于下一个，最后一个又必须先于第一个。
painter-must = 必须先画
painter-cycle = 循环
watch-pairs = 检验的三角形对
watch-depth-extents = 由深度
watch-screen-extents = 由屏幕位置
watch-behind-plane = 由对方的平面
watch-before-plane = 由自己的平面
watch-overlap = 由重叠

## BSP trees

alg-bsp = BSP 树
code-bsp-node = 建树(表)：结点 ← 第一个三角形的平面
words-bsp-node = 第一个三角形的平面成为一个结点。
code-bsp-ask = 其余每个 T：前方、后方或平面上
words-bsp-ask = 其余每个三角形在平面前面、后面或平面上。
code-bsp-cut = T 跨两侧：一分为二；再 建树(前方)、建树(后方)
words-bsp-cut = 跨两侧的三角形切成两块；再分别建前侧和后侧的树。
code-bsp-visit = 遍历(结点)：视点在哪一侧？
words-bsp-visit = 遍历时，在每个结点判断视点在哪一侧。
code-bsp-paint = 遍历(另一侧)；画结点；遍历(视点一侧)
words-bsp-paint = 先走另一侧，再画结点本身，最后走视点一侧。
bsp-opening = { $triangles } 个三角形建成一棵由平面组成的树：只建一次，对每个视点遍历一遍。
bsp-plane = { $triangle } 的平面
bsp-eye = 视点
bsp-node-root = { $triangle } 的平面是第一个结点。
bsp-node-front = 在 { $parent } 前面的第一个是 { $triangle }：它的平面是下一个结点。
bsp-node-back = 在 { $parent } 后面的第一个是 { $triangle }：它的平面是下一个结点。
bsp-ask-front = { $piece } 在 { $triangle } 的平面前面。各顶点的距离：
bsp-ask-back = { $piece } 在 { $triangle } 的平面后面。各顶点的距离：
bsp-ask-on = { $piece } 在 { $triangle } 的平面上。各顶点的距离：
bsp-ask-cut = { $piece } 跨在 { $triangle } 的平面两侧：切成 { $first } 和 { $second }。各顶点的距离：
option-side-front = { $piece } 在 { $triangle } 的平面前面。
option-side-back = { $piece } 在 { $triangle } 的平面后面。
option-side-on = { $piece } 在 { $triangle } 的平面上。
option-side-cut = { $piece } 跨在 { $triangle } 的平面两侧：切成 { $first } 和 { $second }。
bsp-built = 树已建成：{ $triangles } 个三角形分成 { $pieces } 块，放在 { $nodes } 个结点里。
bsp-visit-front = 视点在 { $triangle } 的平面前面：先画它后面的，再画 { $triangle }，最后画它前面的。
bsp-visit-back = 视点在 { $triangle } 的平面后面：先画它前面的，再画 { $triangle }，最后画它后面的。
bsp-visit-on = 视点在 { $triangle } 的平面上，或沿着它看：先画哪一侧都可以。
bsp-paint = { $piece } 画在最上面：第 { $place } 块，共 { $pieces } 块。
bsp-done = 完成：由后到前画了 { $pieces } 块，判断了 { $nodes } 次。
bsp-tree = 树：← 前方，后方 →
bsp-before = 前方
bsp-behind = 后方
bsp-eye-before = 视点在前
bsp-eye-behind = 视点在后
bsp-eye-on = 视点在平面上
watch-nodes = 结点
watch-pieces = 块数
watch-visited = 已访问
watch-painted = 已画

## Occlusion queries

alg-occlusion = 遮挡查询
code-occlusion-occluders = 对每个遮挡体：画它
words-occlusion-occluders = 先画遮挡很多的物体。
code-occlusion-others = 对其余每个物体 P，若 盒(P) 到达近平面：画 P
words-occlusion-others = 其余物体逐个处理。包围盒到达近平面的，不查询，直接画。
code-occlusion-ask = n ← 盒(P) 中 z_盒 ≤ z[像素] 的像素数
words-occlusion-ask = 数一数它的包围盒在多少个像素可见，什么也不写入。
code-occlusion-skip = 若 n = 0：跳过 P
words-occlusion-skip = 若一个也没有，就跳过该物体。
code-occlusion-draw = 否则画 P
words-occlusion-draw = 否则画该物体。
occlusion-opening = { $columns } × { $rows } 像素上有 { $objects } 个物体。画面中的物体，先画覆盖像素最多的三分之一（向上取整），它们可能遮挡其他物体：{ $occluders }。
occlusion-none = 无
occlusion-occluder = { $object } 是遮挡体，不查询直接画：{ $triangles } 个三角形，写入 { $writes } 个片元。
occlusion-seen = { $object } 的包围盒覆盖 { $asked } 个像素，其中 { $passed } 个像素处可见。什么也不写入。
occlusion-hidden = { $object } 的包围盒覆盖 { $asked } 个像素，处处都有更近的物体：一个像素也不可见。
occlusion-beside = { $object } 的包围盒不覆盖任何像素。
occlusion-unasked = { $object } 的包围盒到达近平面，正面可能被切掉：不做比较。
occlusion-answer-seen = { $object } 的包围盒可见。
occlusion-answer-hidden = { $object } 的包围盒被遮住：处处都有更近的物体。
occlusion-skip = 跳过 { $object }：它的 { $triangles } 个三角形不画。
occlusion-draw = 画 { $object }：{ $triangles } 个三角形，写入 { $writes } 个片元。
occlusion-in-vain = { $object } 白画了 { $triangles } 个三角形：包围盒在 { $passed } 个像素处可见，{ $object } 本身却处处不可见。查询可能留下看不见的物体，绝不漏掉看得见的。
occlusion-done = 完成：画了 { $drawn } 个，跳过 { $skipped } 个。{ $triangles } 个三角形省去了 { $spared } 个，画面与全部画出时相同。
occlusion-objects = 物体
occlusion-asked = 盒的像素
occlusion-passed = 可见
occlusion-drawn = 已画
occlusion-skipped = 跳过
occlusion-is-occluder = 遮挡体
watch-objects-drawn = 画出的物体
watch-objects-skipped = 跳过的物体
watch-pixels-asked = 查询的像素
watch-triangles-spared = 省去的三角形

## Whose a pixel is

owns-nothing = { $surface } 不覆盖光栅的任何像素。
owns-none = { $surface } 覆盖 { $covered } 个像素，但处处有别的面在前：一个也看不到。
owns-all = { $surface } 覆盖 { $covered } 个像素，处处可见。
owns-some = { $surface } 覆盖 { $covered } 个像素，在其中 { $seen } 个可见；其余 { $hidden } 个有别的面在前。

## What it costs

surface-costs-title = 判定哪个表面在前面的代价
surface-costs-about = 在 { $columns } × { $rows } 像素上计数而非计时：街道上的盒子，每个十二个三角形。
surface-costs-triangles = 三角形数
surface-costs-counts = 三角形对、测试、片元的个数
surface-costs-pairs = 画家算法：{ $triangles } 个三角形检验 { $count } 对；随 n 的 { $exponent } 次幂增长。
surface-costs-questions = 光线投射：光线对 { $triangles } 个三角形共测试 { $count } 次；随 n 的 { $exponent } 次幂增长。
surface-costs-fragments = 深度缓冲：{ $triangles } 个三角形产生 { $count } 个片元；随 n 的 { $exponent } 次幂增长。
surface-costs-overdraw = 过度绘制：{ $fragments } 个片元对 { $pixels } 个像素，每个像素平均计算 { $overdraw } 次。
surface-costs-note = 指数是对数坐标下拟合直线的斜率。检验的三角形对只在存在次序时计数；没有次序处，曲线缺一个点。

## The raster's form

raster-title = 光栅
raster-rows = 行数
raster-shuffle = 打乱次序（0：不打乱）
raster-pixel = 像素（−1：全部）
raster-steps = 一步是
raster-steps-fragments = 一个片元
raster-steps-spans = 三角形的一行
raster-steps-triangles = 一个三角形
raster-tones = 浓淡表示
raster-tones-triangles = 哪个三角形
raster-tones-counts = 计算了几次
raster-tones-brightness = 亮度
raster-tones-stored = 存储的深度
raster-tones-distance = 距离
raster-number = 深度格式
raster-reversed = 反向：1 表示近
raster-cull = 剔除背面
