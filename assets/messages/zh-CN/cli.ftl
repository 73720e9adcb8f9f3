### What the command line says to people, on the standard error; its JSON is not translated.

## Results

cli-exported = 已将 { $count } 幅图导出到 { $path }
cli-handouts = 已将 { $count } 份讲义写入 { $path }
cli-exported-slides = 已将 { $count } 个演示页面写入 { $path }
cli-checked = { $count } 节课检查通过
cli-checked-scenes = { $count } 个场景文件检查通过
cli-refused = 有 { $count } 项输入不被接受
cli-untranslated = 提示：{ $count } 课以英文代替 { $languages }；这些语言可有可无
cli-unreadable = 无法读取 { $path }：{ $reason }
export-same-name = { $first } 和 { $second } 都会成为 { $path }：什么也没有绘制。
handout-of-scene = { $name } 是场景，讲义由各节课生成。什么也没有绘制。
export-no-moment = 在 { $path } 中，时刻“{ $moment }”从未出现。什么也没有绘制。
export-no-loop = 循环动画只显示插图：--format { $format } 不能与 --window 或 --questions 同用。什么也没有绘制。
export-window-is-pixels = 整个窗口由像素组成：--window 只能与 --format png 同用，不能与 { $format } 同用。什么也没有绘制。

## Wrong usage

usage-no-such-command = 没有名为“{ $name }”的命令。
usage-no-such-argument = 这里不接受“{ $name }”。
usage-value-missing = { $name } 需要一个值。
usage-wrong-value = { $name } 不能是“{ $value }”。
usage-argument-missing = 缺少 { $name }。
usage-conflict = { $name } 不能与 { $other } 同时使用。
usage-expected = 可用：{ $expected }。
usage-expected-size = 应为 宽 x 高，从 64x64 到 { $most }，例如 1920x1080。
usage-expected-steps = 应为 figures、all，或两个时刻，例如 start..end。
usage-expected-scale = 应为 0.25 到 8 之间的数。
usage-see-help = --help 列出全部命令和选项，并附示例。

## What the refusal of a case says; the JSON answer has the English sentence

case-bad-json = 不是有效的 JSON：见第 { $column } 列。
case-not-utf8 = 该行不是 UTF-8：见第 { $byte } 字节。
case-line-too-long = 该行超过 { $max } MiB。
case-bad-id = id 嵌套过深，或含有不属于 Unicode 的文本。
case-repeated-field = 字段“{ $name }”出现了两次。
case-unknown-algorithm = 没有名为“{ $name }”的算法。可用：{ $expected }。
case-meant-algorithm = 没有算法“{ $name }”。是不是想写“{ $meant }”？可用：{ $expected }。
case-unknown-field = { $algorithm } 没有字段“{ $name }”。可用：{ $expected }。
case-missing-field = 缺少字段“{ $name }”。
case-missing-choice = 缺少以下字段之一：{ $fields }。
case-both = 已给出“{ $one }”：“{ $one }”和“{ $other }”只能给出一个。
case-wrong-type = 应为{ $expected }，实为{ $found }。
case-wrong-word = 应为以下之一：{ $expected }，实为“{ $found }”。
case-wrong-length = 应有 { $expected } 个数，实有 { $found } 个。
case-wrong-points = 应有 { $expected } 个点，实有 { $found } 个。
case-no-planes = 至少需要一个平面。
case-zero-direction = 视线方向不得为零向量。
case-not-finite = { $number } 超出 64 位浮点数的范围：每个坐标都必须是有限的数。
case-beyond-range = { $number } 会使答案中的一个数超出 64 位浮点数的范围。
case-step-beyond-range = { $number } 会使某一步中的一个数超出 64 位浮点数的范围。加上 --events false 则只给出答案。
case-too-many = 该列表有 { $found } 项：输出每一步的报告最多接受 { $max } 项。使用 --events false 则不限数量，只给出答案。
case-too-many-pairs = 边与裁剪边共有 { $found } 对：逐步报告最多 { $max } 对。加上 --events false 则数目不限，只给出答案。
case-uv-length = 应为 { $expected } 个顶点各给出一个 [u, v]，这里有 { $found } 个。
case-tints-length = 应为 { $expected } 个三角形各给出一个 [不透明度, 亮度]，这里有 { $found } 个。
object-triangles = 三角形
object-object = 物体
object-tints = 不透明度和亮度
case-too-many-raster-pixels = 共 { $found } 个像素：逐步报告最多 { $max } 个。加上 --events false 则不限数量，只给出答案。
case-too-many-steps = 共 { $found } 步：报告最多 { $max } 步。加上 --events false 则不限步数，只给出答案。
case-over-budget = 这次运行将超过 { $max } 步，这是此算法在任何机器上的上限。
case-too-many-fragments = 这些三角形共覆盖 { $found } 个像素（被遮挡的也计入）：最多绘制 { $max } 个。
json-number = 数
json-numbers = 数的列表
json-points = 点的列表
json-text = 文本
json-list = 列表
json-object = 对象
json-bool = 真假值
json-null = null

## The answer to a case

case-visible = 从 { $p1 } 到 { $p2 } 可见。
case-touch = 只有一点可见：{ $at }。
case-invisible = 完全不可见。
case-nothing-left = 什么也不剩。
case-no-area = 剩下的部分面积为零：没有可填充的内容。
case-cull-inside = 在内部：没有平面与它相交。
case-cull-outside = 在外部：平面 { $plane } 将其剔除，距离为 { $distance }。
case-box-outside = 在外部：八个角全部在某一平面的外侧。
case-cull-straddles = 跨界：至少有一个平面与它相交，且没有平面将其剔除。
case-cull-in-vain = 按各平面判定为跨界，但它没有任何一点在内部：白白保留。
case-front = 可见正面：n·e = { $dot }。
case-back = 看不到正面：n·e = { $dot }。
case-polygons = { $n } 个多边形：{ $rings }
case-surfaces-seen = { $pixels } 个像素中有 { $seen } 个显示出表面。
case-painted = 绘制次序：{ $ids }。
case-painter-cycle = 没有正确的次序：{ $ids } 中每一个都必须先于下一个绘制，最后一个又必须先于第一个。
case-bsp-pieces = 树中共有 { $pieces } 块；{ $pixels } 个像素中有 { $seen } 个显示出表面。
case-occlusion = { $pixels } 个像素中有 { $seen } 个显示出物体；{ $objects } 个物体中跳过了 { $skipped } 个。
case-bsp-too-large = 这些三角形会被平面切成 { $pieces } 块以上，或者需要判断 { $questions } 次以上：不为这么多三角形建树。
case-triangles = { $n } 个三角形：{ $triangles }

## Reports: the step table of a case

report-title = 参考答案
worksheet-title = 练习纸
worksheet-how = 填写每一步得到的结果。有方框处，勾选正确的一项。
report-case = 第 { $number } 题
report-case-id = 第 { $number } 题（{ $id }）
report-source = 出处
report-symbols = 符号
case-symbols-weiler-atherton = a₁、a₂：被裁剪边的两端到裁剪边所在直线的距离乘以该边的长度，> 0 表示在其左侧，即内部。t、u：交点在被裁剪边和裁剪边上的位置，起点为 0，终点为 1。
report-step = 步骤
report-what = 说明
report-formula = 算式
report-changed = 新的值
report-answer = 答案：
report-row = { $name }：{ $values }
report-noted = { $value }（{ $note }）

## The trace, check and list commands

trace-refused-at = 第 { $line } 行，{ $case }：{ $problem }
trace-more-refused = 另有 { $count } 项
trace-from-terminal = 从键盘读取用例，每行一个；按 Ctrl+D 结束。
trace-not-written = 无法写出答案：{ $reason }
list-algorithms = 用例可用的算法
list-lessons = 课程
list-figure = 图 { $name }
cli-no-lesson = 没有课程“{ $name }”：既不是路径，也不是内置课程。请见 clipscope list。
grade-score = 共 { $cases } 题，答对 { $right } 题。
grade-case = 第 { $number } 题
grade-case-named = 第 { $number } 题（{ $name }）
grade-no-case = 不属于任何题
grade-unlisted = 另有 { $count } 处差异只计数，未列出。
grade-output = { $place } 应为 { $truth }，程序给出的是 { $said }。
grade-output-missing = 答案缺少 { $place }，它应为 { $truth }。
grade-output-spare = 答案中有 { $place } = { $said }，正确答案中没有。
grade-field = { $place } 是 { $said }，应为 { $truth }。
grade-field-missing = 缺少 { $place }，应为 { $truth }。
grade-field-spare = { $place } 是 { $said }，而这种事件没有 { $place }。
grade-step-differs = 第 { $step } 步“{ $said }”最先出现差异：{ $what }
grade-step-other = 第 { $step } 步最先出现差异：程序执行的是“{ $said }”，应为“{ $truth }”。
grade-step-missing = 程序在第 { $step } 步之后停止：接下来应为“{ $truth }”。
grade-step-extra = 第 { $step } 步“{ $said }”是多余的：已经没有要做的事。
grade-steps-swapped = 第 { $step } 步与第 { $next } 步的次序颠倒：“{ $truth }”应在“{ $said }”之前。
grade-step-unreadable = 第 { $step } 步不是事件：应为带有文本“event”的对象。
grade-missing = 程序没有给出这一题的答案。
grade-extra = 答案的第 { $line } 行不属于任何题：它的 id 未知，或这一题已有答案。
grade-bad-json = 无法读取答案的第 { $line } 行。{ $problem }
grade-no-object = 这是有效的 JSON，但不是对象。
grade-refuses = 程序没有接受这一题，而它是有答案的。
grade-refusable = 程序回答了这一题，而它本不应被接受（{ $code }）。
grade-mistake = 一种已知的错误恰好得到这个结果：“{ $mistake }”。
mistake-slope-turned-over = 斜率颠倒了，把 Δy/Δx 写成了 Δx/Δy
grade-both-stdin = 题目和答案不能都来自标准输入。
grade-one-at-a-time = 这种报告只针对一份提交，而答案来自多份：--report json 或 text 为每份各给出一个报告。
grade-not-written = 无法写入 { $path }：{ $reason }
grade-no-report = { $path }，第 { $line } 行：这不是“clipscope grade --report json”的报告。
usage-expected-tolerance = 应为不小于 0 的数，例如 1e-9。
grade-mark-true = 正确：{ $at }
grade-mark-said = 程序：{ $at }
grade-raster-true = 正确的像素
grade-raster-said = 程序的像素（有 { $count } 个不同，第一个在 { $at }）
grade-title-event = 第一个出错的步骤：{ $event }
grade-title-output = 第一个有差异的答案
grade-title-none = 第一道没有正确答案的题
grade-title-extra = 不属于任何题的答案
grade-figure-said = 程序给出的是
grade-figure-true = 正确的是
grade-figure-nothing = 无
grade-figure-cases = 所有题，按其次序
grade-figure-plain = 这一题只用数字表示。

table-file = 文件
table-score = 得分

pack-one-folder = 一个网页只能放一门课程：请只给出一个文件夹。
pack-too-many = 这些课的学习记录有 { $count } 个字符，而 SCORM 1.2 只为每位学生保存 { $most } 个字符：请把课分成几个包。
