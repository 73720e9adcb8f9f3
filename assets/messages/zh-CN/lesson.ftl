### The course panel and what it says about lesson files.

## Walking through the course

lesson-question = 问题
card-rule = 规则
card-formula = 公式
card-cost = 代价
card-pitfall = 注意
card-can = 你现在会
lesson-answer-show = 显示答案
lesson-answer-hide = 隐藏答案
lesson-changed = 这是你自己的场景，下文讲的是课程原来的场景。
lesson-has-changes = 含有你的改动
lesson-contents = 全部课程与自由场景
lesson-to-control = 按下即可看到在哪里设置。
lesson-restore = 恢复课程的场景
lesson-not-translated = 这段文字尚未翻译。

## Lesson files

lesson-empty = 课程中没有任何课。
lesson-error = 错误
lesson-warning = 警告

## What is wrong with a lesson file; the last part of the key is the problem’s code

problem-toml = 这不是有效的 TOML。
problem-toml-deep = 值的嵌套层数太多。
problem-toml-comma = 两个值之间缺少逗号。
problem-toml-extra = 这里多了一个“,”或“=”。
problem-toml-number = 数不能这样写。
problem-toml-escape = 在文本中，“\”之后不能是这个字符。
problem-toml-duplicate = 这个名称出现了两次。
problem-toml-value = 这不是一个值。
problem-toml-no-value = 名称之后缺少“=”和值。
problem-toml-name = 名称中不能有这个字符。
problem-toml-unclosed = 缺少右侧的 { $closer }。
problem-not-utf8 = 文件不是 UTF-8 文本：此处不应出现字节 { $byte }。
problem-course-file = 这不是打包的课程：{ $reason }
problem-course-version = 该课程由 Clipscope 的其他版本打包：这里无法读取版本 { $version }。
problem-no-link = 这不是 Clipscope 的链接。
problem-link-version = 该链接由 Clipscope 的其他版本生成：这里无法读取 { $version }。
problem-link-damaged = 链接被截断或改动过：无法还原其中的场景。
problem-link-too-large = 链接中的场景太大。
problem-link-value = “{ $value }”不能作为链接的“{ $key }”。
problem-link-no-lesson = 当前打开的课程中没有“{ $name }”所指的课。
problem-link-no-step = 该课中没有步骤“{ $name }”。
problem-picture-without-link = 图片中没有指向某一步的链接。
problem-no-lessons = 这里没有任何课。
problem-too-many-lessons = 课超过了 { $limit } 节：其余的已略去。
problem-missing-file = 缺少这个文件。
problem-unknown-language = “{ $name }”不是课程所用的语言。
problem-missing-language = 没有这种语言（{ $language }）的文本：将显示英文。
problem-unknown-field = 这里没有名为“{ $name }”的字段。
problem-missing-field = 缺少字段“{ $name }”。
problem-wrong-type = 值的类型不对：这是{ $found }。
problem-wrong-length = 列表的长度不对：有 { $count } 个值。
problem-not-finite = 这里必须是有限的数。
problem-out-of-range = { $value } 超出了范围。
problem-empty-text = 这段文本是空的。
problem-two-kinds-of-segments = 同时给出了“segments”和“random”：只能给出其中之一。
problem-two-kinds-of-polygons = 同时给出了“polygon”和“random”：只能给出其中之一。
problem-two-kinds-of-objects = 同时给出了“objects”和“street”：只能给出其中之一。
problem-too-many-beside = 第一个方法旁边列出了 { $count } 个方法：最多能并排放 { $most } 个。
problem-too-few-places = 这里给出了 { $count } 个位置。
problem-two-openings = 同时给出了“fov_y_deg”和“height”：前者用于透视相机，后者用于平行投影相机。
problem-two-models = 同时给出了“solid”和“mesh”：只能给出其中之一。
problem-two-meshes = 同时给出了“obj”和数字列表：只能给出其中之一。
problem-no-picture = 这不是图片。
problem-mesh-plain = 网格不带纹理绘制。
problem-too-many-texels = 这个文件的纹理共有 { $count } 个纹素，超过 { $limit }。
picture-elsewhere = “{ $name }”不在网格旁边。
picture-unread = “{ $name }”：{ $reason }
picture-no-material = “{ $library }”中没有材质“{ $name }”。
picture-broken = “{ $name }”不是每边至多 { $most } 个纹素的 PNG 或 JPEG，或者它已损坏。
problem-mesh-too-large = 该列表有 { $count } 项，场景文件最多容纳 { $limit } 项。
problem-no-such-mesh = 该文件旁没有网格“{ $name }”。
problem-unknown-method = 没有名为“{ $name }”的算法。
problem-unknown-lab = 没有名为“{ $name }”的实验室。
problem-unknown-control = 这个实验室没有名为“{ $name }”的控件。
problem-unknown-scene = 没有名为“{ $name }”的场景。
problem-unknown-lock = 没有名为“{ $name }”的控制柄。
problem-unknown-value = “{ $name }”不是这个字段可取的值。
problem-no-steps = 这节课没有步骤。
problem-too-many-steps = 这节课有 { $count } 步，超过 { $limit } 步。
problem-bad-step-id = “{ $name }”不能用作步骤的 id。
problem-duplicate-step = 有两个步骤都叫“{ $name }”。
problem-bad-figure = “{ $name }”不能用作插图的名称。
problem-duplicate-figure = 有两幅插图都叫“{ $name }”。
problem-moment-never-happens = 在这个场景的运行过程中，时刻“{ $name }”从不出现。
problem-unused-scene = 没有任何步骤用到这个场景。
problem-bad-reference = 无法读取这处引用。
problem-reference-outside = 课的标题中不能有引用。
problem-unknown-name = 这一步没有名为“{ $name }”的值。
problem-no-value = “{ $name }”不代表可以写进句子的值。
problem-unknown-form = 数没有“{ $name }”这种写法。
problem-like-itself = 场景“{ $name }”以自身为样本。
problem-missing-title = 文本没有标题。
problem-second-title = 一节课只有一个标题，位于最前面。
problem-bad-heading = 这个标题没有说明它属于哪一步。
problem-text-outside = 这段文本不属于任何步骤。
problem-unknown-step = 这节课没有步骤“{ $name }”。
problem-missing-section = 缺少步骤“{ $name }”的文本。
problem-duplicate-section = 步骤“{ $name }”有两段文本。
problem-empty-section = 步骤“{ $name }”只有标题，没有文本。
problem-long-paragraph = 这一段有 { $count } 个字符，超过 { $limit } 个。
problem-unsupported-markdown = 课文中不能使用这种 Markdown。
problem-stray-emphasis = 这些星号没有起到加粗的作用。
problem-stale-translation = “{ $name }”的英文在翻译之后又改过。
expect-translated = 请重新翻译，然后运行“clipscope check 文件夹 --translated”。
problem-stray-claim = 这条结论没有写在某一步的标题下面。
expect-claim = 请紧接在“## id: 标题”下面写一段，以“=> ”开头。
problem-stray-sides = “=| … | …”这一行没有给某一步的两幅图命名。
expect-sides = 请在有 `before` 的步骤的结论下一行写“=| ”和两个名称，中间用“ | ”隔开：先前的和现在的。
problem-bad-card = 这不是一张小结卡。
expect-card = 请在文件末尾写“## card”，下面是一个列表：依次是 rule、formula、cost、两条以上的 pitfall 和 can，例如“- rule: …”。小结卡里不能有引用。
problem-stray-note = 这条给讲者的备注会被所有人看到。
problem-more = 此文件中还有 { $count } 个问题未显示。

## What was expected in its place

expect-did-you-mean = 是不是想写“{ $name }”？
expect-one-of = 应为：{ $names } 之一。
expect-toml-value = 应为：直引号 "" 中的文本、一个数、true 或 false，或各值之间有逗号的列表。
expect-toml-name = 应为：字母 a–z 和 A–Z、数字、“-”和“_”。
expect-utf8 = 应为：以 UTF-8 编码保存的文本。
expect-link = 应为：“#课/步骤”，或“#v1=”加一个场景，前面可以有网址。
expect-lesson-folder = 应为：含有 lesson.toml 和 en.md 的文件夹，或由这样的文件夹组成的文件夹。
expect-text = 应为：引号中的文本。
expect-number = 应为：一个数。
expect-whole = 应为：从 { $min } 到 { $max } 的整数。
expect-table = 应为：由字段组成的表。
expect-window = 应为：[xmin, ymin, xmax, ymax]，其中 xmin < xmax，ymin < ymax。
expect-point = 应为：一个点的两个数：[x, y]。
expect-segment = 应为：一条线段的四个数：[x1, y1, x2, y2]。
expect-segments = 应为：线段的列表 [[x1, y1, x2, y2], …]，或带有“count”和“seed”的“random”。
expect-clip = 应为：凸多边形的至少三个顶点 [[x, y], …]，方向不限。
expect-polygon = 应为：多边形的至少三个顶点 [[x, y], …]。
expect-holes = 应为：内孔的列表，每个内孔至少三个顶点 [[[x, y], …], …]。
expect-place = 应为：一个位置的三个数，[x, y, z]。
expect-space-segment = 应为：一条线段的两个端点，[[x, y, z], [x, y, z]]。
expect-space-triangle = 应为：一个三角形的三个顶点，[[x, y, z], [x, y, z], [x, y, z]]。
expect-camera = 应为：position、target、up、fov_y_deg（或 height）、aspect、near 和 far；透视时须 0 < near < far。
expect-eye = 应为：pitch_deg 在 −89 到 89 之间，distance 在 1e-6 到 1e6 之间，fov_y_deg 在 1 到 120 之间。
expect-objects = 应为：物体的列表，[{ "{" } solid = "cube", at = [x, y, z], size = 1 { "}" }, …]，或带有“count”和“seed”的“street”。
expect-mesh = 应为：name、vertices [[x, y, z], …] 和 faces [[i, j, k], …]，下标从 0 数起；也可以有 uvs [[u, v], …]，每个顶点一个。也可以不用列表而用 obj，即 OBJ 文件的内容；picture 是它的纹理，为 base64 编码的 PNG 或 JPEG 文件。
expect-opacity = 应为：从 0（看不见）到 1（完全遮住后面）的一个数。
expect-picture = 应为：base64 编码的 PNG 或 JPEG 文件。
expect-pixel = 应为：一个像素 [列, 行]，从左上角的 0 数起。
expect-mesh-file = 应为：课程文件夹中 OBJ 文件的名称，例如 "cow.obj"，或含有 name、vertices 和 faces 的表。
expect-steps = 应为：至少一个 [[step]]。
expect-kebab = 应为：小写字母和数字，用单个连字符连接：nine-regions。
expect-figure = 应为：最多 64 个小写字母、数字和连字符：nine-regions。
expect-first-here = 前一个在第 { $line } 行。
expect-first-scene = 第一步必须指明场景；之后的步骤沿用它。
expect-moment = 应为：start、end，或事件名称及其词语，例如“cut left”。
expect-moments = 应为：时刻的列表，例如 ["cut left"]。
expect-moment-number = 应为：“#”之后为从 1 起的整数。
expect-reference = 应为：花括号中的一个值，例如 { "{" }u_min{ "}" }、{ "{" }P₁.x @ end{ "}" } 或 { "{" }output.segment[2] of practice : 2{ "}" }。
expect-locks = 应为：被锁定的控制柄的列表，例如 ["window"]。
expect-drags = 应为：课文要用到的控制柄的列表，例如 ["far"]。
expect-title = 应为：第一行为“# 本课标题”。
expect-heading = 应为：每一步有一个标题“## id: 标题”，正文在其下。
expect-section = 应为：此后有“## { $name }: 标题”，正文在其下。
expect-markdown = 应为：段落、**加粗**、*斜体*、`代码`、列表、代码块，以及表示答案的引用块。
expect-emphasis = 应为：**加粗**，星号内侧不留空格；若紧邻汉字，请将标点移到星号之外。
expect-note = 应为：单独成段，不在列表或答案之内，且每一行都以“!> ”开头。

## What a value is

type-text = 文本
type-integer = 整数
type-float = 小数
type-boolean = 真假值
type-date = 日期或时间
type-list = 列表
type-table = 由字段组成的表

## 网格文件

problem-no-number = “{ $word }”不是有限的数。
problem-too-few-numbers = 这一行只有 { $count } 个数，需要 { $needed } 个。
problem-no-such-vertex = 没有编号为 { $index } 的顶点：文件中共有 { $count } 个。
problem-no-such-uv = 没有编号为 { $index } 的纹理坐标：文件中共有 { $count } 组。该面不带纹理绘制。
problem-face-too-short = 这个面只有 { $count } 个顶点，略去。
problem-face-too-long = 这个面有 { $count } 个顶点，超过 { $limit } 个，略去。
problem-face-not-simple = 这个面自相交或没有面积，略去。
problem-flat-faces = { $count } 个三角形没有面积，第一个在此：看不到它们的任何部分。
problem-no-faces = 文件中没有可以绘制的面。
problem-too-many-faces = 该文件的三角形超过 { $limit } 个：太大，无法绘制。
expect-obj-index = 应为：1 表示文件的第一个顶点，2 表示下一个；−1 表示本行之前的那一个。

problem-nothing-asked = 此步骤停下之前，运行没有作出任何判断。
expect-ask = 应为：true、false 或 "run"。
expect-decision = 应为：某个判断的时刻，或其后的时刻。
problem-goal-missed = 应达成目标的场景不满足目标的第 { $count } 项。
problem-goal-met = 步骤自己的场景已经满足目标。
expect-reached = 应为：满足目标各项的场景的名称；步骤自己的场景不能已经满足全部各项。
problem-goal-parts = 目标有 { $count } 项，最多 { $limit } 项。
expect-goal = 应为：条件的列表，例如 ["output.visible = false", "events(cut) = 1"]。
goal-words-visible = 有可见的部分
goal-words-invisible = 没有可见的部分
goal-words-output = 结果中“{ $name }”为“{ $value }”
goal-words-event = 第 { $nth } 个“{ $event }”中，“{ $name }”为“{ $value }”
goal-words-count = 运行中有 { $count } 个“{ $name }”步骤
problem-goal-text = 步骤“{ $name }”有 { $count } 行目标，而 lesson.toml 中有 { $limit } 个条件。
expect-goal-text = 应为：每个条件一行“- [ ] …”。

handout-work-out = 动手计算
handout-open = 打开此步：{ $link }
handout-kept = 要点
