// What is not in the program: it comes when it is wanted, from beside the page, and what does not come is said.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

import { assertQuiet, at, bare, caption, opened, read, remembered, server, test, told } from "./bench.mjs";
import { sleep } from "./browser.mjs";

const SAVES = `Object.defineProperty(navigator, "connection", { value: { saveData: true } });`;
const parts = () => server.state.asked.map((path) => /(texts-.*|spot|NotoSansSC)(?:-Regular|-Bold)?-\w+\.\w+$/.exec(path)?.[1]).filter(Boolean);
const speak = (page, lang) => page.see(`dispatchEvent(new CustomEvent("clipscope-ask", { detail: ${JSON.stringify(JSON.stringify({ lang }))} }))`);
const speaks = (page, lang) => page.until(`document.documentElement.lang === "${lang}"`, `it speaks ${lang}`);

test("who saves data gets other languages when they are chosen, and no other time", async () => {
  server.state.asked = [];
  const given = { algorithm: "liang-barsky", window: [-1, -1, 1, 1], segment: [-2, -1, 2, 1.5] };
  const page = await opened({ init: at("05-intervals", "clip-the-parameter") + SAVES });
  await page.until("navigator.serviceWorker.ready.then(() => true)");
  await sleep(1000);
  assert.deepEqual(parts(), []);
  await page.press("Home");
  await speak(page, "es");
  await speaks(page, "es");
  assert(bare(await caption(page)).startsWith(bare(told(given, "es")[0][0])), await caption(page));
  assert.deepEqual(parts(), ["texts-es"]);
  await speak(page, "en");
  await speaks(page, "en");
  await speak(page, "es");
  await speaks(page, "es");
  assert.deepEqual(parts(), ["texts-es"], "it comes once");
  assertQuiet(page);
});

test("all of it follows the first picture where nobody saves data", async () => {
  server.state.asked = [];
  await opened({ init: remembered({}) });
  for (let i = 0; i < 200 && new Set(parts()).size < 5; i += 1) await sleep(50);
  assert.deepEqual([...new Set(parts())].sort(), ["NotoSansSC", "spot", "texts-es", "texts-pt-BR", "texts-zh-CN"]);
});

test("a language that does not come is said, and can be chosen again", async () => {
  const page = await opened({ init: at("05-intervals", "clip-the-parameter") + SAVES });
  server.state.manner = "gone";
  await speak(page, "pt-BR");
  await page.until(`document.querySelector("#mirror").textContent.includes("did not arrive")`);
  assert.equal(await page.see("document.documentElement.lang"), "en");
  server.state.manner = "well";
  await speak(page, "pt-BR");
  await speaks(page, "pt-BR");
});

test("a lesson with the mesh that is shipped shows it as the desktop does, once it has come", async () => {
  const folder = mkdtempSync(join(tmpdir(), "clipscope-spot-"));
  const lesson = "42-what-the-wall-hides";
  execFileSync(process.env.CLIPSCOPE, ["export", "--alt", "--out", folder, lesson], { stdio: "ignore" });
  const files = readdirSync(folder, { recursive: true }).filter((name) => name.endsWith(".txt"));
  const lines = bare(files.map((name) => readFileSync(join(folder, name), "utf8")).join("\n"));
  rmSync(folder, { recursive: true });
  server.state.asked = [];
  const page = await opened({ search: `#${lesson}/cost-and-gain`, init: remembered({ asks: false }) + SAVES });
  for (let i = 0; i < 400 && !parts().includes("spot"); i += 1) await sleep(50);
  assert.deepEqual(parts(), ["spot"]);
  let shown;
  for (let i = 0; i < 400; i += 1, await sleep(50)) {
    shown = bare(await caption(page));
    if (lines.includes(shown)) break;
  }
  assert(lines.includes(shown), `${shown} in ${lines}`);
  assert(!(await read(page)).includes("on its way"));
  assertQuiet(page);
});
