// Fingers, a phone's size, and what the system wishes.

import assert from "node:assert/strict";

import { assertQuiet, at, bench, caption, opened, remembered, server, test } from "./bench.mjs";

/// A clock that goes on by ten milliseconds a frame, however long that takes, and by a tenth: at just the 0.8 s for which a long
/// touch waits, egui neither takes it for one nor looks again. What is drawn is counted.
const CLOCK = `{
  let now = 0;
  performance.now = () => now;
  const frame = window.requestAnimationFrame.bind(window);
  window.requestAnimationFrame = (run) => frame(() => run((now += 10.1)));
  window.drawn = 0;
  const { clear } = WebGL2RenderingContext.prototype;
  WebGL2RenderingContext.prototype.clear = function (...bits) { drawn += 1; return clear.apply(this, bits); };
}`;

const PHONE = { size: [390, 844], touch: true };
/// Its clock, so that a tap on a machine that is slow is a tap.
const STEP = at("05-intervals", "clip-the-parameter") + CLOCK;
const N_DISCS = "document.querySelectorAll('#mirror [role=tab]').length";

/// Fingers come down together, go their ways in six parts, and are lifted.
async function fingers(page, ways, { rest = 0 } = {}) {
  const points = (part) => ways.map(([[x, y], [dx, dy] = [0, 0]], id) => ({ x: x + dx * part, y: y + dy * part, id }));
  const send = async (type, touchPoints) => {
    await page.send("Input.dispatchTouchEvent", { type, touchPoints });
    await page.settled();
  };
  for (let n = 1; n <= ways.length; n += 1) await send("touchStart", points(0).slice(0, n));
  for (let i = 0; i < rest; i += 1) await page.settled();
  if (ways.some(([, by]) => by)) for (let i = 1; i <= 6; i += 1) await send("touchMove", points(i / 6));
  await send("touchEnd", []);
}

const tap = (page, x, y) => fingers(page, [[[x, y]]]);

test("on a phone stage, caption and transport are there, the rest is a tap or a swipe away", async () => {
  const page = await opened({ ...PHONE, scale: 1, init: STEP });
  const { size, colours, most } = await page.compared(await page.picture());
  assert.deepEqual(size, [390, 844]);
  assert(colours > 100 && most < 0.95, `${colours} colours, ${most} of it in one`);
  assert((await caption(page)).length > 10);
  assert.equal(await page.see(N_DISCS), 0, "the course is out of sight");
  await tap(page, 200, 690);
  await page.until(`${N_DISCS} > 3`, "a tap on the sheet brings the course");
  await fingers(page, [[[200, 90], [0, 150]]]);
  await page.until(`${N_DISCS} === 0`, "a swipe takes it away");
  const code = "document.querySelector('#mirror').textContent.includes('Pseudocode')";
  await fingers(page, [[[250, 690], [-150, 0]]]);
  await page.until(code, "a swipe brings the inspector");
  await tap(page, 318, 28);
  await page.until(`!${code}`, "its button takes it away");
  assertQuiet(page);
});

test("the large button goes a step on, the line is slid on, and held it plays", async () => {
  const page = await opened({ ...PHONE, init: STEP });
  await tap(page, 120, 784);
  const before = await caption(page);
  await tap(page, 350, 798);
  await page.until(`document.querySelector('#mirror [data-name=caption]').textContent !== ${JSON.stringify(before)}`, "a step on");
  const after = await caption(page);
  await fingers(page, [[[350, 798]]], { rest: 30 });
  await page.until(`document.querySelector('#mirror [data-name=caption]').textContent !== ${JSON.stringify(after)}`, "it plays");
  assertQuiet(page);
});

/// The angles, the distance and the target that the address has of the eye.
const eye = async (page) => {
  const [x, y, z, yaw, pitch, distance] = (await page.see(`/eye=([^&]*)/.exec(location.hash)?.[1] ?? ""`)).split(",").map(Number);
  return { target: [x, y, z], angles: [yaw, pitch], distance };
};

test("two fingers bring a space nearer, and do not turn it", async () => {
  const page = await opened({ ...PHONE, search: "#19-the-view-volume", init: remembered({ asks: false }) + CLOCK });
  const apart = (by, way) => [[[195 - by, 250], [-way, 0]], [[195 + by, 250], [way, 0]]];
  await fingers(page, apart(40, 40));
  await page.until("location.hash.includes('eye=')", "the eye has moved");
  const first = await eye(page);
  const address = await page.see("location.hash");
  await fingers(page, apart(40, 40));
  await page.until(`location.hash !== ${JSON.stringify(address)}`, "the address has followed");
  const second = await eye(page);
  assert(Math.abs(first.distance / second.distance - 2) < 0.2, `${first.distance} / ${second.distance}`);
  assert.deepEqual(second.angles, first.angles, "two fingers do not turn it");
  assertQuiet(page);
});

test("dark as the system is on a first visit, and light where it is light", async () => {
  for (const [value, isDark] of [["dark", true], ["light", false]]) {
    const page = await bench.browser.page();
    await page.send("Emulation.setEmulatedMedia", { features: [{ name: "prefers-color-scheme", value }] });
    await page.go(server.url);
    await page.running();
    const { commonest } = await page.compared(await page.picture());
    const lightness = [16, 8, 0].reduce((sum, by) => sum + ((commonest >> by) & 255), 0) / 3;
    assert.equal(lightness < 64, isDark, `${value}: ${commonest.toString(16)}`);
    assertQuiet(page);
  }
});

test("nothing moves by itself where that is wished", async () => {
  const counts = [];
  for (const value of ["no-preference", "reduce"]) {
    const page = await bench.browser.page({ init: STEP });
    await page.send("Emulation.setEmulatedMedia", { features: [{ name: "prefers-reduced-motion", value }] });
    await page.go(server.url);
    await page.running();
    for (let i = 0; i < 20; i += 1) await page.settled();
    const before = await page.see("drawn");
    // The menu of the scene comes in.
    await page.press("?");
    for (let i = 0; i < 20; i += 1) await page.settled();
    counts.push((await page.see("drawn")) - before);
    assertQuiet(page);
  }
  assert(counts[1] < counts[0], `${counts[1]} frames, and ${counts[0]} with motion`);
});
