### What the frustum lab says: planes, spheres, boxes, faces, the funnel, and what goes wrong in it.

## Sides of the view volume beyond those of a window

plane-near = 近
plane-far = 远
plane-left = 左
plane-right = 右
plane-bottom = 下
plane-top = 上

## Views

view-observer = 观察者
view-camera = 相机
view-observer-frozen = 观察者：剔除已冻结
view-camera-flying = 飞行相机
camera-that-culls = 已冻结：由它剔除
camera-that-flies = 飞行中
gauge-outside = 外
gauge-inside = 内
gauge-away = 背向
gauge-faces-camera = 朝向相机
gauge-drawn = 绘制
gauge-culled = 剔除
gauges-sphere = 一个包围球，{ $planes } 个平面
gauges-sphere-of = 物体 { $object }：一个包围球，{ $planes } 个平面
gauges-faces = 面数：{ $faces }，按 n·e
plane-from-matrix = 不用角度：{ $sum }。除以法向量的长度 { $length }，即为{ $plane }平面，精确到 { $decimals } 位小数。
column-plane = 平面
column-outside = 外
column-vertex = 顶点
column-code = 区域码
column-beyond = 在其外侧
no-side = 没有共同的平面
codes-left = 在内部的顶点：3 个中有 { $inside } 个。裁剪后剩下 { $pieces } 个三角形。
column-least = 最小
column-most = 最大

## What can be taken hold of

handle-camera = 相机位置
handle-target = 相机目标点
handle-near = 近平面
handle-far = 远平面
handle-top = 相机视场角
handle-point = 点 P
handle-space-end = { $number ->
    [1] 端点 P₁
   *[other] 端点 P₂
  }
handle-space-corner = 给定顶点 { $vertex }
handle-object = 物体 { $number }
handle-object-corner = 物体 { $number } 的顶点 { $corner }

## Methods

alg-point-planes = 点与平面
alg-sphere-cull = 包围球剔除
alg-box-cull = 包围盒剔除
alg-back-face = 背面剔除
alg-funnel = 剔除漏斗
alg-faulty-one-angle = 错误：两个方向用同一个视场角
alg-faulty-turned-sign = 错误：符号取反
alg-faulty-around-origin = 错误：球心取在原点
alg-faulty-winding = 错误：把顶点顺序当作顺时针
alg-faulty-constant-view = 错误：所有面用同一视线方向

## A point

point-opening = P 是否在全部 { $planes } 个平面的内侧？
point-inside = P 在{ $plane }平面的内侧。
point-on = P 在{ $plane }平面上，算作内侧。
point-outside = P 在{ $plane }平面的外侧。
point-answer-inside = 在内部：该点不在任何平面的外侧。
point-answer-outside = 在外部：该点至少在一个平面的外侧。
point-done-inside = P 不在任何一个平面的外侧（共 { $planes } 个）：P 在视见体内。
point-done-outside = P 在 { $planes } 个平面中 { $outside } 个的外侧：P 不在视见体内。
code-plane-each = 对每个平面 (n, D)：
code-point-distance = d ← n·P + D
code-point-outside = 若 d < 0：在外侧
code-point-inside = 不在任何平面外侧：在内部
words-plane-each = 依次测试每个平面；法向量指向内侧。
words-point-distance = 法向量点乘该点再加 D，就是有符号距离。
words-point-outside = 距离为负在外侧；为 0 在平面上，算作内侧。
words-point-inside = 不在任何平面外侧的点，就在视见体内。

## A bounding sphere

sphere-opening = 一个包住全部顶点的球代表物体：{ $planes } 个平面。
sphere-inside = 球在{ $plane }平面的内侧。
sphere-straddles = 球跨在{ $plane }平面上。
sphere-outside = 球在{ $plane }平面的外侧：整个物体剔除。
sphere-done-inside = 球在全部 { $planes } 个平面的内侧：三角形不必再测试。
sphere-done-straddles = 球跨在 { $planes } 个平面中的 { $cut } 个上：接着逐个测试三角形。
planes-done-outside = 第 { $planes } 次测试判定它在{ $plane }平面外侧：整个剔除。
option-beyond = 在{ $option }平面外侧
option-within = 在所有平面内侧
option-across = 不在任何平面外侧，但也不在所有平面内侧
code-sphere-distance = d ← n·c + D
code-sphere-outside = 若 d < −r：剔除
code-sphere-straddles = 若 d < r：跨界
code-sphere-done = 无跨界则在内部
words-sphere-distance = 求球心到平面的有符号距离。
words-sphere-outside = 球心在外侧且距离大于半径：整个球在外侧。
words-sphere-straddles = 球心距离小于半径：平面截到球。
words-sphere-done = 球若在所有平面内侧，就不必再测试。
class-inside = 内部
class-straddles = 跨界
class-outside = 外部
watch-class = 分类
watch-object = 物体

## A bounding box

box-opening = 包住全部顶点的盒子代表物体：{ $planes } 个平面，每个平面测试八个角。
box-inside = 八个角都在{ $plane }平面内侧（外侧 { $outside } 个）。
box-straddles = 8 个角中有 { $outside } 个在{ $plane }平面外侧：跨界。
box-outside = 全部 { $outside } 个角都在{ $plane }平面外侧：整个物体剔除。
box-meets = 盒子跨在 { $cut } 个平面上，确有一部分在所有平面内侧。
box-in-vain = 盒子跨在 { $cut } 个平面上，却没有任何一点同时在所有平面内侧。
box-done-inside = 盒子在全部 { $planes } 个平面的内侧。
box-done-straddles = { $planes } 个平面都不能剔除它：接着逐个测试三角形。
box-done-in-vain = { $planes } 个平面都保留它，画了也是白画：保守，但没有错。
box-note-in-vain = 照样绘制，它的 { $triangles } 个三角形只费时间。没有一个像素改变：画面是对的。
option-box-inside = 八个角都在{ $plane }平面内侧。
option-box-straddles = 只有部分角在{ $plane }平面内侧：盒子跨在平面上。
option-box-outside = 八个角都在{ $plane }平面外侧：盒子被剔除。
code-box-corners = 数 n·p + D < 0 的角
code-box-outside = 若八个全是：剔除
code-box-meets = 有没有一点在所有平面内侧？
code-box-done = 保留，或者白画
words-box-corners = 只看八个角的距离的符号。
words-box-outside = 八个角都在同一平面外侧：物体的任何部分都看不见。
words-box-meets = 第二个测试找出跨在平面上、却仍在外部的盒子。
words-box-done = 平面测试绝不剔除看得见的，但可能保留看不见的。

## A face

face-of-object = { $face }（物体 { $object }）
face-opening = 相机看到的是不是面 { $face } 的正面？
face-normal = 从外面看，面 { $face } 逆时针：法向量指向外面。
face-to-eye = 向量 e 从面 { $face } 的 V₀ 指向相机：e = 视点 − V₀。
face-to-direction = 平行投影中，面 { $face } 的 e 与其他各面相同：沿视线反向。
face-products = 面 { $face } 的点积与行列式是同一个数。
face-front = 面 { $face } 朝向相机：绘制。
face-back = 面 { $face } 背向相机：剔除。
face-edge-on = 面 { $face } 正好侧对相机：看不见，剔除。
code-face-normal = n ← (V₁ − V₀) × (V₂ − V₀)
code-face-viewer = e ← 视点 − V₀
code-face-product = n·e = |e, V₁ − V₀, V₂ − V₀|
code-face-decide = n·e > 0 为正面，否则剔除
words-face-normal = 两条边的叉积垂直于面。
words-face-viewer = 透视投影中，指向视点的向量随面而异。
words-face-product = n·e 的符号说明视点在面的哪一侧。
words-face-decide = 从外面看，封闭立体的正面总把背面挡住。

## The funnel

level-so-far = 至此
level-scene = 场景中
level-spheres = 包围球测试后
level-vertices = 顶点测试后
level-cuts = 裁剪后
level-facing = 朝向相机
level-counts = { $triangles } 个三角形 · { $objects } 个物体
funnel-opening = { $objects } 个物体，{ $triangles } 个三角形：哪些三角形需要绘制？
funnel-object = 物体 { $object }：{ $triangles } 个三角形，一个包围球。
funnel-sphere-inside = 物体 { $object } 在内部：{ $triangles } 个三角形都不必裁剪。
funnel-sphere-straddles = 物体 { $object } 跨界：逐个测试它的 { $triangles } 个三角形。
funnel-sphere-outside = 物体 { $object } 整个剔除：省下 { $triangles } 个三角形。
funnel-triangle-inside = 三角形 { $triangle }：3 个顶点中 { $inside } 个在内部，整个保留。
funnel-triangle-outside = 三角形 { $triangle }：顶点都在同一平面外侧（内部 { $inside } 个），剔除。
funnel-triangle-cut = 三角形 { $triangle }：3 个顶点中 { $inside } 个在内部，裁剪后剩 { $pieces } 个三角形。
funnel-triangle-across = 三角形 { $triangle }：{ $inside } 个顶点在内部，却仍有一部分看得见：{ $pieces } 个三角形。
funnel-triangle-nothing = 三角形 { $triangle }：{ $inside } 个顶点在内部，裁剪后剩 { $pieces } 块。
option-triangle-inside = 三角形 { $triangle } 在内部，整个保留。
option-triangle-outside = 三角形 { $triangle } 在某一平面外侧，被剔除。
option-triangle-clipped = 三角形 { $triangle } 需要裁剪。
funnel-face-front = 物体 { $object } 的三角形 { $triangle } 朝向相机：绘制。
funnel-face-back = 物体 { $object } 的三角形 { $triangle } 背向相机：剔除。
funnel-face-edge-on = 物体 { $object } 的三角形 { $triangle } 正好侧对相机：剔除。
funnel-done = { $objects } 个物体中剩下 { $kept } 个，{ $triangles } 个三角形中剩下 { $facing } 个要画。
code-funnel-each = 对每个物体：
code-funnel-sphere = c, r ← 包围球
code-funnel-plane = 对每个平面：d ← n·c + D
code-funnel-cull = 若 d < −r：剔除物体
code-funnel-straddles = 若有 d < r：对每个三角形：
code-funnel-triangle = 区域码：剔除、保留或裁剪
code-funnel-face = 剔除 n·e ≤ 0 的三角形
code-funnel-draw = 绘制剩下的
words-funnel-each = 先测试整个物体：一次测试可以省下全部三角形。
words-funnel-sphere = 以顶点的平均为心，半径到最远的顶点。
words-funnel-plane = 求球心到六个平面的距离。
words-funnel-cull = 球心在外侧且距离大于半径：剔除该物体。
words-funnel-straddles = 只有跨界的物体才进入下一层。
words-funnel-triangle = 顶点都在同一平面外侧：剔除；没有一个在外侧：保留；否则裁剪。
words-funnel-face = 背向相机的三角形被朝向相机的三角形挡住。
words-funnel-draw = 每一层都去掉了自己能判定的部分。

## Mistakes

faulty-one-angle-differs = 从第 { $step } 步起出现差别：左右方向也用了上下方向的视场角。
faulty-turned-sign-differs = 从第 { $step } 步起出现差别：把平面的内侧当成了外侧。
faulty-around-origin-differs = 从第 { $step } 步起出现差别：包围球的球心取在模型原点，而不是质心。
faulty-winding-differs = 从第 { $step } 步起出现差别：把顶点顺序当作顺时针，于是法向量指向内部。
faulty-constant-view-differs = 从第 { $step } 步起出现差别：所有面用了同一个视线方向。
code-faulty-one-angle = 用同一视场角的平面：d ← n·c + D
words-faulty-one-angle = 左、右平面的张角与上、下平面相同。
code-faulty-turned-sign = 若 d > r：剔除物体
words-faulty-turned-sign = 剔除法向量所指一侧的物体。
code-faulty-around-origin = c, r ← 原点，绕质心的半径
words-faulty-around-origin = 球心取在模型原点，半径却从质心量起。
code-faulty-winding = n ← (V₂ − V₀) × (V₁ − V₀)
words-faulty-winding = 把顶点顺序当作顺时针来求法向量。
code-faulty-constant-view = 剔除 n·v ≥ 0 的三角形，v 不变
words-faulty-constant-view = 每个面都用同一视线方向。

## Menu

camera-title = 相机
camera-position = 位置
camera-target = 目标点
camera-up = 向上方向
camera-sight = 投影
camera-perspective = 透视
camera-parallel = 平行投影
camera-fov = 视场角
camera-height = 高度
camera-aspect = 宽高比
camera-near = 近平面
camera-far = 远平面
camera-frozen = 冻结剔除
objects-not-drawn = 这个方法不画物体。
object-add = 添加物体
object-remove = 移除当前物体
object-focus = 物体 { $object }
object-face = 面
object-number = 编号
object-place = 位置
object-turn = 旋转
object-size = 大小
section-point = 点
section-segment = 线段
section-triangle = 三角形
object-opacity = 不透明度
solid-cube = 立方体
solid-tetrahedron = 四面体
solid-octahedron = 八面体
solid-sphere = 球
solid-torus = 圆环
solid-angle = L 形块
solid-spot = 奶牛 Spot
street-title = 排满盒子的街道
street-count = 盒子数
street-make = 建造街道

## 判定的理由

verdict-culled = 物体 { $object } 被{ $plane }平面剔除：d = { $distance } < −r，r = { $radius }。再向内移 { $move }，就不会被任何平面剔除。
verdict-culled-for-good = 物体 { $object } 被{ $plane }平面剔除：d = { $distance } < −r，r = { $radius }。沿该平面的法向量怎样移动都进不来。
verdict-straddles = 物体 { $object } 跨界：最近的是{ $plane }平面，d = { $distance } < r = { $radius }。再向外移 { $move }，就会被剔除。
verdict-inside = 物体 { $object } 在内部：最近的是{ $plane }平面，d = { $distance } ≥ r = { $radius }。再向外移 { $move }，就会被剔除。
verdict-face-in = 沿{ $plane }平面的法向量移动 { $move }，这个面的顶点就不再都在同一平面之外。
verdict-face-never = 沿{ $plane }平面的法向量怎样移动都改变不了。
verdict-face-cut = 这个面没有一点同时在所有平面之内，所以沿某一平面的法向量移动说明不了什么。
verdict-face-turn-to = 绕 V₀ 朝向视点转 { $angle }°，这个面就开始露出正面。
verdict-face-turn-away = 绕 V₀ 背离视点转 { $angle }°，这个面就正好侧对视点，被剔除。
verdict-face-no-normal = 这个面没有法向量：怎样转都不会露出正面。
part-segment = 线段
part-corner = 顶点 { $vertex }
part-edge = 边 { $from }{ $to }
verdict-part-kept = 没有平面裁去{ $part }的任何部分。
verdict-part-cut = { $plane }平面最先裁切{ $part }；它还剩下一部分。
verdict-part-lost = 由{ $plane }平面决定：{ $part }什么也不剩。
verdict-part-in = 沿垂直于{ $plane }平面的方向向内移 { $move }，它就不会被裁掉。
verdict-part-back = 沿垂直于{ $plane }平面的方向向外移 { $move }，它就不会被裁掉。
verdict-part-never = 沿垂直于{ $plane }平面的方向怎样移动都改变不了。
verdict-part-out = 沿垂直于{ $plane }平面的方向向外移动超过 { $move }，它就什么也不剩。
verdict-part-touch = 它只是碰到{ $plane }平面：稍向外移，它就什么也不剩。
verdict-crossing-out = 这条边在这里有交点，因为它的两端在{ $plane }平面的两侧：d = { $inner } 和 d = { $outer }。把该平面向外移 { $move }，就没有交点了。
verdict-crossing-in = 这条边在这里有交点，因为它的两端在{ $plane }平面的两侧：d = { $inner } 和 d = { $outer }。把该平面向内移动超过 { $move }，就没有交点了。

## What culling costs, measured

culling-title = 剔除的代价
culling-about = 先测试每个物体，再绘制剩下的：三种方式得到同一幅画面，在本机上当场测量。
culling-objects = 物体数
culling-own = 本场景的物体
culling-nothing = 不剔除
culling-rough = 用包围球
culling-exact = 用全部三角形
culling-row = { $way }：剔除 { $cull } ms + 绘制 { $draw } ms；剩下 { $objects } 个物体、{ $triangles } 个三角形
culling-inequality = 粗略剔除与精确剔除：{ $rough-cull } { $cull-relation } { $exact-cull } ms。绘制剩下的部分：{ $rough-draw } { $draw-relation } { $exact-draw } ms。
culling-axis-objects = 物体数（街道上的盒子）
culling-axis-millis = 毫秒
culling-best-always = 在测过的所有数目下最快的都是：{ $way }。
culling-best-changes = 起初最快：{ $first }。从 { $many } 个物体起：{ $last }（{ $few } 个时还不是）。
culling-note = 取五遍中最快的一遍，画面为 320 × 200 像素；包围球成批测试。时间只属于这台机器和这一刻：导出的图只显示计数。

## A pixel of the camera's picture

pixel-seen = 像素 { $at } 显示物体 { $object } 的面 { $face }：{ $count ->
    [one] 该处只有它，其深度为
   *[other] 该处 { $count } 个面中它最近。它与下一个的深度：
  }
pixel-empty = 没有面覆盖像素 { $at }。
pixel-other = { $direction } { $count } 个像素，看到的是物体 { $object } 的面 { $face }。
pixel-other-nothing = { $direction } { $count } 个像素，什么也看不到。
picture-seen = 此处看到的是物体 { $object } 的面 { $face }：{ $count ->
    [one] 该处只有它，其深度为
   *[other] 该处 { $count } 个面中它最近。它与下一个的深度：
  }
picture-empty = 此处没有看到任何面。
picture-other = { $direction }图像的 { $percent } %，看到的是物体 { $object } 的面 { $face }。
picture-other-nothing = { $direction }图像的 { $percent } %，什么也看不到。
pixel-shows = 在这一步，像素 { $at } 显示物体 { $object } 的面 { $face }。
pixel-shows-nothing = 在这一步，像素 { $at } 还没有显示任何东西。
pixel-truth = 该处最近的是物体 { $object } 的面 { $face }。
pixel-truth-nothing = 没有面覆盖这个像素。
pixel-alone = 只看这个像素
pixel-all = 看所有像素
pixel-right = 向右
pixel-left = 向左
pixel-down = 向下
pixel-up = 向上
