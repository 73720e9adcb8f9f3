### What the command line says to people, on the standard error; its JSON is not translated.

## Results

cli-exported = 已将 { $count } 幅图导出到 { $path }
cli-checked = { $count } 课检查通过
cli-refused = 拒绝了 { $count } 项输入
cli-case-refused = 用例 { $case }：{ $problem }
cli-unreadable = 无法读取 { $path }：{ $reason }
cli-nothing = 没有要处理的内容。
