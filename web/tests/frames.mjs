// What a frame costs the page's main thread while a lesson is stepped through and while something is dragged: of each of 60 steps or
// moves the dearest frame it has drawn. What the browser does after a frame (playing a graphics card, bringing it to the screen) is not
// in it. `DIST=… node frames.mjs [PART OF A SCENE'S NAME]`.

import assert from "node:assert/strict";

import { at, bench, caption, opened, server } from "./bench.mjs";

const N_MOVES = 60;
/// Not counted: the browser compiles what runs often anew, and better.
const N_FIRST = 20;
const SWEEP_PX = 40;
/// Lesson and step, and where a drag takes hold: of a handle, or of a space beside what is in it.
const SCENES = [
  ["a line", "05-intervals", "clip-the-parameter", [543, 130]],
  ["a polygon", "10-one-edge-at-a-time", "any-convex-region", [337, 217]],
  ["two side by side", "12-four-clippers", "the-same-ring", [308, 394]],
  ["a frustum", "25-the-funnel", "from-the-scene", [300, 440]],
  ["a depth buffer", "34-the-nearer-wins", "cleared", [260, 200]],
  ["three side by side", "43-three-ways-one-picture", "one-picture", [260, 120]],
  ["a mesh", "42-what-the-wall-hides", "cost-and-gain", [300, 180]],
];
/// Times those callbacks that draw. Keys and moves of the pointer only wait for the next of them.
const CLOCK = `{
  window.frames = [];
  let draws = false;
  const { clear } = WebGL2RenderingContext.prototype;
  WebGL2RenderingContext.prototype.clear = function (...bits) { draws = true; return clear.apply(this, bits); };
  const request = window.requestAnimationFrame.bind(window);
  window.requestAnimationFrame = (run) => request((now) => {
    draws = false;
    const start = performance.now();
    run(now);
    if (draws) frames.push(performance.now() - start);
  });
}`;

/// Processor seconds of the page's scripts so far: what else runs on the machine is not in it.
async function processor(page) {
  const { metrics } = await page.send("Performance.getMetrics");
  return metrics.find(({ name }) => name === "ScriptDuration").value;
}

const part = (sorted, of) => sorted[Math.ceil(of * sorted.length) - 1].toFixed(1);

async function measured(page, what, act) {
  for (let i = 0; i < N_FIRST; i += 1) await act(i);
  const all = [];
  const dearest = [];
  const before = await processor(page);
  for (let i = 0; i < N_MOVES; i += 1) {
    await page.see("frames.length = 0");
    await act(N_FIRST + i);
    const drawn = await page.see("frames");
    assert(drawn.length > 0, `${what}: nothing was drawn`);
    all.push(...drawn);
    dearest.push(Math.max(...drawn));
  }
  const each = (1000 * ((await processor(page)) - before)) / all.length;
  for (const times of [all, dearest]) times.sort((a, b) => a - b);
  const told = `dearest of each: ${part(dearest, 0.5)} ms, 95 % ${part(dearest, 0.95)}, slowest ${part(dearest, 1)}`;
  const rest = `all ${all.length}: ${part(all, 0.5)}, 95 % ${part(all, 0.95)}, of the processor ${each.toFixed(1)} in the mean`;
  console.log(`${what}: ${told}; ${rest}`);
}

for (const [name, lesson, step, [x, y]] of SCENES.filter(([name]) => name.includes(process.argv[2] ?? ""))) {
  const page = await opened({ scale: 1, init: at(lesson, step) + CLOCK });
  await page.send("Performance.setTimeDomain", { timeDomain: "threadTicks" });
  await page.send("Performance.enable");
  await page.press("Home");
  let before;
  await measured(page, `${name}, a step`, async () => {
    const now = await caption(page);
    // At its end a run begins again.
    await page.press(now === before ? "Home" : "ArrowRight");
    before = now;
  });
  await page.press("Home");
  const address = await page.see("location.hash");
  let hand = [x, y];
  await page.mouse("mouseMoved", ...hand, 0);
  await page.mouse("mousePressed", ...hand);
  await measured(page, `${name}, a drag`, (i) => {
    const turn = (1.5 * Math.PI * (i + 1)) / (N_FIRST + N_MOVES);
    hand = [x - SWEEP_PX * Math.sin(turn), y + (SWEEP_PX / 2) * (1 - Math.cos(turn))];
    return page.mouse("mouseMoved", ...hand);
  });
  await page.mouse("mouseReleased", ...hand);
  await page.until(`location.hash !== ${JSON.stringify(address)}`, "the drag has moved something");
  assert.deepEqual(page.complaints, []);
  await bench.browser.closePages();
}
await bench.browser.close();
server.close();
process.exit(0);
