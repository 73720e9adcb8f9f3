### The course panel and what it says about lesson files.

## Walking through the course

lesson-previous = 上一步
lesson-next = 下一步
lesson-step = 第 { $step } 步，共 { $total } 步
lesson-try = 试一试
lesson-question = 问题
lesson-answer = 答案
lesson-answer-show = 显示答案
lesson-answer-hide = 隐藏答案
lesson-spot-the-bug = 找出错误
lesson-changed = 你已修改了这一步的场景。
lesson-restore = 恢复原样
lesson-not-translated = 这段文字尚未翻译。

## Lesson files

lesson-file-problem = { $file } 第 { $line } 行：{ $problem }
lesson-empty = 课程中没有任何课。
