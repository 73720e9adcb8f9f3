// Cohen–Sutherland.

const { answerAll } = require("./grading.js");

const [LEFT, RIGHT, BOTTOM, TOP] = [1, 2, 4, 8];
const NAMES = { [LEFT]: "left", [RIGHT]: "right", [BOTTOM]: "bottom", [TOP]: "top" };

function code(x, y, [xmin, ymin, xmax, ymax]) {
  return (x < xmin) * LEFT | (x > xmax) * RIGHT | (y < ymin) * BOTTOM | (y > ymax) * TOP;
}

answerAll(({ window, segment }, tell) => {
  const [xmin, ymin, xmax, ymax] = window;
  if (xmin >= xmax || ymin >= ymax) throw new Error("the window is empty");
  const border = { [LEFT]: xmin, [RIGHT]: xmax, [BOTTOM]: ymin, [TOP]: ymax };
  let [x1, y1, x2, y2] = segment;
  let [code1, code2] = [code(x1, y1, window), code(x2, y2, window)];
  while (code1 | code2) {
    if (code1 & code2) {
      tell("reject", { and: (code1 & code2).toString(2).padStart(4, "0") });
      return { visible: false, segment: null };
    }
    const side = (code1 | code2) & -(code1 | code2);
    const at = border[side];
    const isUpright = side === LEFT || side === RIGHT;
    const x = isUpright ? at : x1 + (x2 - x1) / (y2 - y1) * (at - y1);
    const y = isUpright ? y1 + (y2 - y1) / (x2 - x1) * (at - x1) : at;
    const end = code1 & side ? "p1" : "p2";
    if (end === "p1") [x1, y1, code1] = [x, y, code(x, y, window)];
    else [x2, y2, code2] = [x, y, code(x, y, window)];
    tell("cut", { end, edge: NAMES[side], to: [x, y] });
  }
  tell("accept", { segment: [x1, y1, x2, y2] });
  return { visible: true, segment: [x1, y1, x2, y2] };
});
