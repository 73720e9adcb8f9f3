// Reads cases and writes answers for `clipscope grade`. Import it into your program, in this folder:
//
//     const { answerAll } = require("./grading.js");
//
//     answerAll((test, tell) => {
//       ...
//       tell("cut", { end: "p1", edge: "left", to: [x, y] });
//       ...
//       return { visible: true, segment: [x1, y1, x2, y2] };
//     });
//
// The first argument has the fields of a line of cases. Call `tell` where something happens: tell as many kinds of events as you
// like, and leave out the fields that you have not. Throw an Error where a case makes no sense.

const readline = require("node:readline");

async function answerAll(solve) {
  for await (const line of readline.createInterface({ input: process.stdin })) {
    if (line.trim() === "") continue;
    const test = JSON.parse(line);
    const events = [];
    const tell = (event, fields) => events.push({ event, ...fields });
    const answer = { id: test.id, submission: test.submission };
    try {
      answer.output = solve(test, tell);
    } catch (error) {
      answer.error = String(error);
    }
    answer.events = events;
    console.log(JSON.stringify(answer));
  }
}

module.exports = { answerAll };
