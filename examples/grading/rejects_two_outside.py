"""Cohen–Sutherland, with a test that is too quick."""

from grading import answer_all

LEFT, RIGHT, BOTTOM, TOP = 1, 2, 4, 8
NAMES = {LEFT: "left", RIGHT: "right", BOTTOM: "bottom", TOP: "top"}


def code(x, y, window):
    xmin, ymin, xmax, ymax = window
    return (x < xmin) * LEFT | (x > xmax) * RIGHT | (y < ymin) * BOTTOM | (y > ymax) * TOP


def clip(case, tell):
    window = xmin, ymin, xmax, ymax = case["window"]
    if xmin >= xmax or ymin >= ymax:
        raise ValueError("the window is empty")
    border = {LEFT: xmin, RIGHT: xmax, BOTTOM: ymin, TOP: ymax}
    x1, y1, x2, y2 = case["segment"]
    code1, code2 = code(x1, y1, window), code(x2, y2, window)
    while code1 | code2:
        if code1 and code2:
            tell("reject", **{"and": format(code1 & code2, "04b")})
            return {"visible": False, "segment": None}
        side = (code1 | code2) & -(code1 | code2)
        at = border[side]
        if side in (LEFT, RIGHT):
            x, y = at, y1 + (y2 - y1) / (x2 - x1) * (at - x1)
        else:
            x, y = x1 + (x2 - x1) / (y2 - y1) * (at - y1), at
        end = "p1" if code1 & side else "p2"
        if end == "p1":
            x1, y1, code1 = x, y, code(x, y, window)
        else:
            x2, y2, code2 = x, y, code(x, y, window)
        tell("cut", end=end, edge=NAMES[side], to=[x, y])
    tell("accept", segment=[x1, y1, x2, y2])
    return {"visible": True, "segment": [x1, y1, x2, y2]}


answer_all(clip)
