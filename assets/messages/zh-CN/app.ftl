### The window around the labs: tabs, panels, transport, menus, keys, and what it says when something goes right or wrong.

## The program

app-title = Clipscope

## Labs: the tabs of the window

lab-lines = 线段
lab-lines-about = 用裁剪窗口裁剪一条线段。
lab-polygons = 多边形
lab-polygons-about = 用裁剪窗口或另一个多边形裁剪多边形。
lab-frustum = 视见体
lab-frustum-about = 看相机看到什么，绘制之前可以剔除什么。
lab-surfaces = 表面
lab-surfaces-about = 逐像素看清哪个表面在前面。

## Panels

panel-course = 课程
panel-stage = 演示区
stage-boundary = 图与旁边内容的分界线：可以拖动，也可以按方向键。
panel-inspector = 检查器
panel-algorithm = 算法
panel-pseudocode = 伪代码
panel-watch = 变量
panel-controls = 设置
panel-cost = 运算量
panel-timeline = 时间轴
panel-scene = 场景

## Transport: moving through the steps of a run

transport-first = 第一步
transport-back = 后退一步
transport-play = 播放
transport-pause = 暂停
transport-forward = 前进一步
transport-last = 最后一步
transport-next-page = 本课的下一步
transport-speed-value = 每秒 { $speed } 步
transport-step = 第 { $step } 步，共 { $total } 步
transport-steps = 共 { $count } 步

## Pseudocode, watch table, cost and verdict

pseudocode-full = 代码
pseudocode-words = 文字
pseudocode-hidden = 隐藏
pseudocode-hidden-note = 已隐藏：下一步会是什么？
watch-empty = 尚未进行任何计算。
verdict-title = 为什么？
verdict-go = 转到该步（Enter）
cost-additions = 加减法
cost-sums = 加减
cost-multiplications = 乘法
cost-divisions = 除法
cost-comparisons = 比较
cost-total = 合计
cost-compare = 与……比较
cost-compare-none = 不比较

## Settings

settings-theme = 主题
theme-light = 浅色
theme-dark = 深色
theme-projector = 投影仪
settings-text = 文字大小
settings-snap = 吸附到网格

## Actions

action-present = 演示
action-present-leave = 退出演示
action-open-whole = 在 Clipscope 中打开
action-notes = 讲者备注
speaker-clock = 演示已进行 { $clock }（小时:分钟）
speaker-no-note = 本步没有备注。
speaker-next = 下一步：{ $title }
speaker-last = 这是最后一步。
courses = 其他课程
course-built-in = 内置课程
action-picture = 相机画面与观察者画面并排
no-picture = 这里没有方法显示相机画面。
type-what = 请先选一个控制点：按 Tab 逐个切换，或单击一个。
action-free = 自由场景
action-course = 回到课程
free-title = 自由场景
free-scenes = 自由场景列表
scene-new = 新建自由场景…
scene-copy = 复制此场景…
scene-rename = 重命名此自由场景…
scene-delete = 删除此自由场景…
scene-numbered = 场景 { $n }
scene-name = 名称
scene-name-taken = 本实验室已有另一个场景使用此名称。
scene-make = 新建
scene-rename-it = 重命名
scene-delete-it = 删除
scene-delete-asks = “{ $name }”将被删除，其中可撤销的步骤也一并消失，无法恢复。
free-about = 你自己的场景：没有任何锁定，并会一直保留。
free-about-large = 你自己的场景：没有任何锁定。场景太大，关闭窗口后不会保留：请保存为文件（Ctrl+S）。
free-back = ← {$lesson}
free-from-course = 课程中的场景
scene-adopt = 在此实验室打开该场景：{ $lab }
action-help = 帮助
action-undo = 撤销
action-redo = 重做
save-exists = 该文件已存在，且不是打开的那个文件。
action-replace = 替换它
action-open = 打开…
action-open-it = 打开
action-open-path = 按路径打开…
action-recent = 打开最近的文件
action-save = 保存
action-save-path = 按路径保存…
action-browse = 选取文件…
action-export = 导出此图
action-copy = 复制此图
action-copy-svg = 复制为 SVG 文本
action-link = 复制当前画面的链接
action-reset = 重置
action-fit = 适应视图
handle-locked = { $name } 在这一步中已锁定。
handle-other = 单击：{ $name }
handles-listed = { $list }、{ $name }
action-reset-view = 适应视图
action-close = 关闭
action-cancel = 取消

## Help: the keys

help-title = 快捷键
help-step = 后退或前进一步
help-step-ten = 一次十步
help-phase = 上一阶段或下一阶段
help-ends = 第一步或最后一步
help-play = 播放或暂停
help-reset = 重置本步的场景；自由场景则回到第一步并适应视图
help-lesson-step = 课程上一步或下一步
help-drag = 任何一步都可拖动控制柄：运行过程会重新记录

## What the program reports

status-exported = 已导出到 { $path }
status-exporting = 已导出 { $count } / { $total } 步。按 Esc 停止导出。
status-export-failed = 无法导出此图：{ $reason }
status-copied = 图已复制到剪贴板：{ $width } × { $height } 像素。
status-copied-svg = 图已作为 SVG 文件的文本复制到剪贴板（{ $count } kB）。
status-copy-failed = 无法复制此图：{ $reason }
status-link-copied = 链接已复制到剪贴板（{ $count } 个字符）。打开它的人会看到与您相同的画面。
status-link-long = 链接已复制到剪贴板。它有 { $count } 个字符：有些程序会截断超过 2,000 个字符的链接。
status-link-of-page = 这个场景太大，放不进链接。剪贴板上的链接指向课程中这一步原来的场景。
status-link-none = 这个场景太大，放不进链接。请把它保存为文件。
greeting = 按 ← 和 → 逐步走过运行过程，空格键播放。凡有控制柄之处，任何一步都可拖动。
status-restored = 已恢复上次的内容；撤销即可去掉。
status-saved = 已保存到 { $path }
status-memory-aside = 无法读取 { $path }：{ $reason }该文件现在名为 { $aside }，设置从头开始。
status-memory-unread = 无法读取 { $path }：{ $reason }设置和所做的工作将不会保存。
status-memory-unkept = 设置和所做的工作无法保存到 { $path }：{ $reason }。
status-memory-full = 本页无法保存设置和所做的工作：{ $reason }。
status-memory-refused = 本页不能保存任何内容：关闭后，设置和所做的工作都会丢失。想留下的请另存为文件。
status-coming = 正在下载 { $what }。
status-not-come = { $what } 没有下载成功。请再选一次重试。
status-fonts-coming = 中文字体还在下载，请稍后再试。
status-save-failed = 无法保存场景：{ $reason }
status-open-failed = 无法打开 { $path }：{ $reason }
status-forgotten = 它已从最近的文件中移除。
status-no-window = 无法打开窗口：需要显示器和 OpenGL。没有它们时，可用 clipscope export 把图画成文件。系统的说明：“{ $reason }”
status-kept = 场景保持不变。
status-mesh-reading = 正在读取 { $path }……按 Esc 取消。
status-mesh-given-up = 已取消读取 { $path }：场景保持不变。
status-mesh-plain = 无法读取 { $library } 所指的纹理：网格不带纹理绘制。
status-mesh-picture = { $name } 与网格同在一处，用作它的纹理。
status-mesh-added = { $name } 已加入场景，共 { $count } 个三角形。
status-reloaded = { $path } 已更改并重新读取。

## For screen readers

access-handle = { $name } 的控制柄，位于 { $point }

## More of the window: menus, dialogs, keys

menu-more = 更多
cost-title = 至此的运算量
cost-compared-with = 比较对象：{ $method }
open-title = 打开场景
save-title = 保存场景
export-title = 导出此图
export-format = 格式
export-weight = 文件大小
export-weight-of =
    { $count ->
        [1] { $size } kB
       *[other] { $count } 个文件，各约 { $size } kB
    }
export-size = 大小
export-language = 语言
export-steps = 步骤
export-this-step = 当前这一步
export-all-steps = 运行的所有步骤
save-path = 文件
save-folder = 文件夹
key-space = 空格
key-enter = Enter
key-escape = Esc
key-delete = Delete
key-insert = Insert
key-home = Home
key-end = End
key-page-up = PageUp
key-page-down = PageDown
key-backspace = Backspace
key-shift = Shift
help-zoom = 放大或缩小；也可按住 Ctrl 滚动滚轮
help-text = 放大、缩小文字或恢复原大小
help-course = 显示或隐藏课程
help-free = 本实验室的上一个或下一个自由场景
help-inspector = 显示或隐藏检查器
help-leave = 关闭，或退出演示
help-tab = 转到下一个控制柄或按钮
help-nudge = 移动获得焦点的控制柄；按住 Shift：十倍距离
help-deeper = 在空间中：使该控制柄远离或靠近视点
help-axis = 在空间中，移动控制柄时按住：只沿该轴移动
help-type = 输入所选控制柄的坐标
help-alt = 拖动时：不吸附网格
help-pen = 演示时按住：在画面上画线，到下一步消失
help-verdict = 转到决定所点对象去留的那一步
status-last-good = 显示的是上一个可用的版本。
status-more-problems = ……另有 { $count } 个问题。

## Vertices, outlines, and the methods that are wrong on purpose

help-add = 添加线段，或在选中的顶点之后插入顶点
help-remove = 删除线段或选中的顶点
help-draw-close = 绘制时：闭合轮廓
help-draw-back = 绘制时：撤回上一个顶点
help-edge = 双击一条边，或按住 Ctrl 单击：在该处插入顶点
help-turn = 在三维空间中，在任何地方按住右键拖动可转动视图；滚轮可拉近或拉远视图
faulty-title = 这里错在哪里？
methods-objects = 物体、面和点
methods-segments = 线段
methods-triangles = 三角形
methods-vertices = 顶点
methods-why = 公式的由来
faulty-unnamed = 某位学生的程序
differs-from = 从第 { $step } 步起不同
differs-nowhere = 对此输入，各步相同
not-so = × { $what }
wrong-and-right = 错误：{ $wrong }正确：{ $right }
part-missing = 缺失
result-right = 正确结果：{ $n }
result-wrong = × 错误结果：{ $n }
again = { $what } 重复
is-missing = 缺 { $what }
refused = 不接受
run-later = 场景太大，拖动时来不及运行算法，松开后才运行。
recording-triangles = 正在记录 { $method } 在 { $count } 个三角形上的运行……
recording-vertices = 正在记录 { $method } 在 { $count } 个顶点上的运行……
recording-segments = 正在记录 { $method } 在 { $count } 条线段上的运行……
recording-stop = 停止（Esc）

## 图旁的视图

view-empty = 什么也不剩
view-more = …… 还有 { $count } 项

practice = 考考我
action-practise = 每次判断之前，先让我说出结果
practice-question = 下一步会怎样？
practice-how = 按数字键，或点选。
practice-take-back = 收回（Backspace）
practice-show = 显示答案（S）
practice-right = ✓ { $right }。
practice-wrong = × { $chosen }。正确的是：{ $right }。
practice-shown = { $right }。
practice-go-on = 继续（Enter）
practice-told = { $count } 次判断，事先答对 { $right } 次
practice-done = 运行已结束，不再有判断了。
practice-on = 下一次判断之前会先问你。
practice-leave = 不再提问
practice-step = 第 { $step } 步
what-comes-next = 下一步会怎样？{ $options }
named-sentence = { $name }：{ $said }
figure-before = 之前
figure-now = 现在

lesson-waits = 作答之后（或按 S）才显示其余内容。
lesson-ask-again = 再问我一次
settings-asks = 课程先提问再演示
settings-marks-at-end = 运行结束后才评判
answers-title = 这次运行问过的
answers-earlier = 这次运行中较早的回答：{ $count } 个
answer-right = 第 { $step } 步：{ $right }。事先答对。
answer-wrong = 第 { $step } 步：{ $right }，而不是：{ $chosen }。
answer-shown = 第 { $step } 步：{ $right }。已给出答案。
practice-stands = 这一步的问题：{ $told }。
told-beforehand = 事先答对
told-after = 看过数字后答对
told-open = 未答
told-missed = 未答对
told-seen = 看过
told-unseen = 还没看过
progress-title = 学习进度
progress-counts = 看过 { $seen } 步 · 事先答对 { $beforehand } 题 · 看过数字后答对 { $after } 题 · 未答 { $open } 题 · 目标 { $goals } 个，已达成 { $reached } 个
progress-hand-in = 提交…
progress-take-up = 载入文件…
progress-afresh = 重新开始
progress-sure = 这台电脑上的全部标记都会清除。
hand-in-title = 提交学习进度
take-up-title = 载入学习进度文件
progress-taken-up = 文件中的标记已并入你的标记。
goal-reached = 各项都已满足：目标达成。
goal-part-met = 已满足
goal-part-open = 尚未满足
mark-reached = 目标已达成
mark-goal = 目标尚未达成
goal-hint = 提示 (T)
goal-hint-part = 已看 { $part } / { $count }
goal-hint-none = 这个场景的运行没有作出任何判断：请先改变场景。
goal-hint-now = “{ $part }”：现在是 { $now }，要求 { $sign }{ $wanted }。
goal-hint-open = “{ $part }”：还没有做到。
goal-hint-way = 有一种解法只移动：{ $handles }。
goal-hint-parts = 有一种解法中，两个程序在这里分开：{ $said }
goal-so-far = 各次运行的结局
goal-ended = { $said }{ $count } 次运行这样结束。
action-hint = 朝目标的提示：先看由什么决定，再看等式
mark-hints = 已看过 { $count } 段提示
action-smaller = 差别相同的更小场景
smaller-search = 正在找更小的场景。按 Esc 停止，并保留已找到的最小场景。
smaller-none = 没有找到差别相同而更小的场景：这个场景已经很小。
smaller-not-yet = 请先改变场景，直到达到目标。然后按 M 缩小场景。
smaller-fewer = 场景变小了：{ $before } 个顶点只剩 { $after } 个，差别不变。
smaller-rounder-only = 数字变得更整了，差别不变。
smaller-rounder = 数字变得更整了，差别不变。移动了：{ $handles }。
smaller-no-difference = 这里没有可以缩小的差别：正确方法旁要有一个有错误的方法，并且两者结果不同。

## A lesson that is made

compose-title = 正在制作课程
compose-begin = 修改这节课
compose-leave = 结束制作
compose-try = 以学生身份试做
compose-back = 返回制作
compose-saved = ✓ 全部已保存。
compose-unsaved = ……改动尚未保存。
compose-outside = 另一个程序更改了这节课的文件。在你决定之前不会保存任何内容。文件中现在是：
compose-take-theirs = 采用该版本
compose-keep-mine = 保留此窗口中的版本
compose-settle-first = 另一个程序更改了这节课的文件：请先决定保留哪个版本。
compose-step-title = 第 { $n } 步（共 { $total } 步），标题
compose-text = 正文（Markdown）
compose-text-how = > 隐藏答案，学生要求时才显示。一行 --- 之后的内容，在回答问题之前不显示。
compose-stands = 运行停在何处
compose-follows = 随时间轴而变
compose-locked = 锁定
compose-lock-focused = 制作课程时：锁定或解锁当前控制点
compose-ask = 在这一步之前提问
compose-ask-decision = 最后一次判断
compose-ask-run = 运行中的每次判断
compose-figure = 可导出的图
compose-figure-name = 图的名称
compose-id = 步骤在链接中的名称
compose-goal = 目标：学生要达到现在的场景
compose-goal-how = 现在把场景拖到学生开始的位置。将检查以下各项：
compose-add = 在当前位置添加步骤
compose-insert = 在第 { $n } 步之后插入步骤
compose-row = 第 { $n } 步，共 { $total } 步，{ $title }，时刻 { $at }
compose-own-scene = 从这里另建场景
compose-own-scene-about = 从现在起，这一步有自己的场景：在其中拖动不会改变其他步骤。
compose-how = 你在演示区中所做的改动即成为这一步的场景。在此列表中，Insert 添加步骤，Delete 删除步骤，Alt 加 ↑ ↓ 移动步骤。
compose-lesson = 课程标题
compose-source = 出处
compose-source-at-first = 用 Clipscope 制作
compose-new-title = 这里发生了什么？
compose-has-goal = 有目标
compose-asks-first = 先提问
compose-refused = 这不符合课程文件的格式：标题只有一行，以 # 开头的行会开始另一个步骤，每个名称只能出现一次。
compose-form = 窗口无法修改这种写法的 lesson.toml：每个步骤都必须写在一行 [[step]] 之下。
compose-own-only = 只能修改你自己文件夹中的课程。请先把这节课复制到一个文件夹中。
compose-mend-first = 请先改正错误：课程没有错误时，才能添加、删除和移动步骤。
lesson-save = 另存为课程…
lesson-copy = 把这节课复制到文件夹…
lesson-save-title = 课程的文件夹
lesson-save-taken = 这个文件夹中已有一节课。
