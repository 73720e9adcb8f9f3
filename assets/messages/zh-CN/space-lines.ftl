### What is said of segments in space: six-bit codes, inequalities, and clipping before the divide.

## Methods

alg-cohen-sutherland-3d = 三维 Cohen–Sutherland
alg-liang-barsky-3d = 三维梁友栋–Barsky
alg-plane-line = 线段与平面
alg-homogeneous-line = 除以 w 之前裁剪线段
alg-faulty-divide-first = 错误：先除以 w

## What is asked, and what comes of it

space-line-opening-box = P₁P₂ 的哪一部分在 −1 到 1 的盒内？
space-line-opening-planes = P₁P₂ 的哪一部分在全部 { $planes } 个平面的内侧？
space-line-opening-clip = P₁P₂ 的哪一部分满足 −w ≤ x, y, z ≤ w？
space-line-touch = 接受：只有一个公共点 { $at }。
space-line-point = 接受：两端点是同一个点 { $at }，它在内部。

## Six-bit codes

space-line-code-inside = { $end } 在盒内：{ $code } = { $bits }。
space-line-code-one = { $end } 在{ $first }平面外侧：{ $code } = { $bits }。
space-line-code-two = { $end } 在{ $first }、{ $second }两个平面外侧：{ $code } = { $bits }。
space-line-code-three = { $end } 在{ $first }、{ $second }、{ $third }三个平面外侧：{ $code } = { $bits }。
space-line-or-accept = OR = { $bits }：两端点都在盒内。
space-line-or-open = OR = { $bits } ≠ 000000：并非全在盒内。
space-line-and-open = AND = { $bits }：没有一个面使两端点都在它的外侧，仅凭区域码无法判定。
space-line-and-reject = AND = { $bits } ≠ 000000：两端点都在{ $plane }平面外侧。
space-line-choose = 最低位的 1 对应{ $plane }平面：{ $end } 在其外侧。
space-line-reject-codes = 舍弃：两端点都在{ $plane }平面外侧；AND = { $and }。
space-line-note-code = 点在哪个面外侧，哪一位就是 1。

## One inequality a plane

space-line-delta = P(u) = P₁ + u (P₂ − P₁)：沿线段从头到尾，x、y、z 的变化量为 Δx、Δy、Δz。
space-line-before = 两端点都有 w ≥ 0：都不在视点后方。
space-line-behind = { $end } 的 w < 0：它在视点后方，不能做除法。
space-line-all-behind = 两端点都有 w < 0：整条线段在视点后方。
space-line-option-behind = 一个端点的 w < 0。
space-line-divided = 两端点先除以 w，然后再裁剪。
space-line-row = { $plane }平面：{ $direction }。
space-line-parallel-inside = 与{ $plane }平面平行且在其内侧：单凭这个平面还不能判定。
space-line-parallel-outside = 与{ $plane }平面平行且在其外侧：哪一部分都看不见。
space-line-enter = 直线由{ $plane }平面进入：{ $bound } 增大。
space-line-enter-idle = 直线由{ $plane }平面进入，但不晚于 { $bound }：不变。
space-line-leave = 直线由{ $plane }平面离开：{ $bound } 减小。
space-line-leave-idle = 直线由{ $plane }平面离开，但不早于 { $bound }：不变。
space-line-put = { $end } 移到 { $symbol } = { $u } 处，落在 { $border } 上。
space-line-the-plane = { $plane }平面
space-line-reject = 处理到{ $plane }平面时舍弃：线段一点不剩。
space-line-reject-behind = 舍弃：没有一点在视点前方。
space-line-note-enter = { $first } < { $second } 进入：{ $bound } = max({ $bound }, { $crossing })
space-line-note-leave = { $first } > { $second } 离开：{ $bound } = min({ $bound }, { $crossing })

## The w-lens

w-lens-eye = 视点
w-lens-screen = 屏幕，w = 1
screen-divide-first = 先除以 w
screen-clip-first = 先裁剪
screen-wrong = 错误：这一部分从来不存在
screen-same = 结果相同：没有端点在视点后方
screen-no-image = 有一个端点没有像：w = 0
screen-so-far = 到目前为止剩下的部分
screen-right = 正确：视点前方的部分
screen-nothing = 什么也看不见

## Cases

case-no-point = (0, 0, 0, 0) 不是裁剪空间中的点。
case-flat-box = 盒没有内部：{ $low } 与 { $high } 都是 { $at }。

## Pseudocode

code-lb3-each = 对 k = 1 … 6：取第 k 个面的 p、q
words-lb3-each = 对六个面中的每一个，把“在内侧”写成不等式 u · p ≤ q。
code-pl-start = a_min ← 0; a_max ← 1
code-pl-each = 对每个平面 (n, D)：d₁ ← n·P₁ + D; d₂ ← n·P₂ + D
code-pl-parallel = 若 d₁ = d₂ 且 d₁ < 0，则舍弃
code-pl-enter = 若 d₁ < d₂，则 a_min ← max(a_min, d₁/(d₁ − d₂))
code-pl-leave = 若 d₁ > d₂，则 a_max ← min(a_max, d₁/(d₁ − d₂))
code-pl-empty = 若 a_min > a_max，则舍弃
code-pl-accept = 接受 P(a_min) P(a_max)
words-pl-start = 从整条线段开始，a 从 0 到 1。
words-pl-each = 对每个平面，求两端点各在内侧多远。
words-pl-enter = d 增大：直线由此进入，在 a 之前不可能可见。
words-pl-leave = d 减小：直线由此离开，在 a 之后不可能可见。
code-hl-start = 若 w₁ < 0 且 w₂ < 0，则舍弃
code-hl-each = 对每个面 x, y, z = ±w：d₁, d₂ ← w ± x, y, z
code-hl-enter = 若 d₁ < d₂，则 t_min ← max(t_min, d₁/(d₁ − d₂))
code-hl-leave = 若 d₁ > d₂，则 t_max ← min(t_max, d₁/(d₁ − d₂))
code-hl-empty = 若 t_min > t_max，则舍弃
code-hl-accept = 接受 P(t_min) P(t_max)；此时才除以 w
words-hl-start = 两端点都在视点后方时，什么也看不见。
words-hl-each = 对每个面，w 加或减一个坐标说明点在内侧多远。
words-hl-enter = d 增大：直线由此进入。
words-hl-leave = d 减小：直线由此离开。
words-hl-accept = 剩下的部分 w ≥ near > 0：现在可以除以 w。
code-faulty-divide = P₁ ← P₁ / w₁; P₂ ← P₂ / w₂
code-faulty-divide-accept = 接受 P(t_min) P(t_max)
words-faulty-divide = 两端点都除以 w。
words-faulty-divide-accept = 把区间两端当作可见部分的两端。
faulty-divide-first-differs = 从第 { $step } 步起出现差别：还没裁剪，两端点就除以了 w。
