"""Reads cases and writes answers for `clipscope grade`. Import it into your program, in this folder:

    from grading import answer_all

    def clip(case, tell):
        ...
        tell("cut", end="p1", edge="left", to=[x, y])
        ...
        return {"visible": True, "segment": [x1, y1, x2, y2]}

    answer_all(clip)

`case` has the fields of a line of cases. Call `tell` where something happens: tell as many kinds of events as you like, and leave
out the fields that you have not. Raise ValueError where a case makes no sense.
"""

import json
import sys


def answer_all(solve):
    for line in sys.stdin:
        if not line.strip():
            continue
        case = json.loads(line)
        events = []

        def tell(event, **fields):
            events.append({"event": event, **fields})

        answer = {name: case[name] for name in ("id", "submission") if name in case}
        try:
            answer["output"] = solve(case, tell)
        except (ValueError, ZeroDivisionError) as error:
            answer["error"] = str(error)
        answer["events"] = events
        print(json.dumps(answer))
