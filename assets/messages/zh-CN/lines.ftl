### The lines lab: captions, watch table and controls.

## Handles, by name

handle-end = { $end }
handle-segment = 线段
handle-window = 窗口
handle-side = { $edge }
handle-corner-bottom-left = 左下角
handle-corner-bottom-right = 右下角
handle-corner-top-left = 左上角
handle-corner-top-right = 右上角
handle-vertex = 顶点 { $number }

## The scene

action-add-segment = 添加线段
action-remove-segment = 删除线段
batch-title = 随机线段
batch-count = 数量
batch-seed = 种子
batch-make = 替换所有线段

## Costs, measured

cost-measure = 在本机上测量…
measure-title = 裁剪一条线段的代价
measure-about = 每种方法都在本机上当场裁剪同一批随机线段。
measure-start = 测量
measure-again = 重新测量
measure-nanos = 纳秒
measure-operations = 运算次数
measure-note = 每条线段的平均值，共 { $count } 条。时间取五遍中最快的一遍。
