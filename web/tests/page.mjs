// The page by itself: what it shows, what it does with keys and files, and what stands when something fails.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

import { assertQuiet, at, bare, bench, caption, choose, dist, failed, open, opened, read, remembered, root, said, server, test, told } from "./bench.mjs";
import { Browser, sleep } from "./browser.mjs";
import { serve } from "./server.mjs";

test("the course is drawn, from below a path and by a server that knows no wasm", async () => {
  server.state.asked = [];
  const page = await opened({ scale: 1 });
  const { size, colours, most } = await page.compared(await page.picture());
  assert.deepEqual(size, [1280, 720]);
  assert(colours > 100 && most < 0.95, `${colours} colours, ${most} of it in one`);
  assert((await read(page)).includes("Clipscope"));
  assert(await page.see("document.activeElement === document.querySelector('#stage')"), "the canvas has the focus");
  const foreign = await page.see(
    `performance.getEntriesByType("resource").map((it) => it.name).filter((name) => !name.startsWith(${JSON.stringify(page.at(server.url))}) && !/^(data|blob):/.test(name))`,
  );
  assert.deepEqual(foreign, [], "nothing comes from anywhere else");
  assert(!server.state.asked.some((path) => path.endsWith(".wasm")), "it came gzipped");
  assertQuiet(page);
});

for (const lang of ["en", "zh-CN", "es", "pt-BR"])
  test(`each step's caption is that of trace: ${lang}`, async () => {
    const given = { algorithm: "liang-barsky", window: [-1, -1, 1, 1], segment: [-2, -1, 2, 1.5] };
    const page = await opened({ init: at("05-intervals", "clip-the-parameter", { lang }) });
    assert.equal(await page.see("document.documentElement.lang"), lang);
    await page.press("Home");
    for (const [step, [happens, formula]] of told(given, lang).entries()) {
      const shown = bare(await caption(page));
      assert(shown.startsWith(bare(happens)), `step ${step}: ${shown} / ${bare(happens)}`);
      for (const part of formula.split("<br>")) assert(shown.includes(bare(part)), `step ${step}: ${shown} / ${part}`);
      await page.press("ArrowRight");
    }
    assertQuiet(page);
  });

const THEMES = ["light", "dark", "projector"];
for (const [lesson, step, figure, looks] of [
  ["03-outcodes", "rejected", "outcode-reject", [...THEMES, "zh-CN"]],
  ["14-both-lists", "the-walk-that-switches", "walk-switch", THEMES],
  ["22-whole-objects-first", "outside-is-culled", "sphere-culled", THEMES],
])
  for (const look of looks)
    test(`the window looks as on a desktop: ${figure}, ${look}`, async () => {
      const settings = look === "zh-CN" ? { lang: look } : { theme: look };
      const page = await opened({ scale: 1, init: at(lesson, step, settings) });
      // The fonts for Chinese come after the first frame.
      const isBold = "performance.getEntriesByType('resource').some((it) => it.name.includes('SC-Bold') && it.responseEnd)";
      if (look === "zh-CN") await page.until(isBold, "its fonts come");
      await page.settled();
      const accepted = readFileSync(join(root, "tests/windows", `${figure}-${look}.png`)).toString("base64");
      const { far, mean } = await page.compared(await page.picture(), accepted);
      // A GPU, or what plays one, rounds otherwise along the edges of what it draws.
      assert(far < 0.002 && mean < 0.5, `${(100 * far).toFixed(3)} % of the pixels differ by more than 32; by ${mean.toFixed(3)} in the mean`);
      assertQuiet(page);
    });

test("keys that are the app's do nothing else, and the browser's never reach it", async () => {
  const page = await opened({ init: at("05-intervals", "clip-the-parameter") });
  await page.see(`window.kept = {}; addEventListener("keydown", (event) => (kept[event.key] = event.defaultPrevented)); 1`);
  // eframe stops what it takes: this listener stands before it.
  await page.see(`document.querySelector("#stage").addEventListener("keydown", (event) => (kept[event.key] = event.defaultPrevented), true); 1`);
  const step = await open(page);
  await page.press("PageDown");
  assert.notEqual(await open(page), step, "the next step of the lesson");
  await page.press("PageUp");
  await page.press("End");
  const end = await caption(page);
  await page.press("Home");
  assert.notEqual(await caption(page), end);
  const kept = await page.see("kept");
  assert.deepEqual(kept, { PageDown: true, PageUp: true, End: true, Home: true });
  await page.press("F5");
  await page.press("Ctrl+l");
  assert.deepEqual(await page.see("Object.keys(kept).length"), 4, "F5 and Ctrl+L are the browser's");
  await page.press("p");
  await page.until("document.fullscreenElement === document.documentElement");
  await page.see("document.exitFullscreen()");
  await page.until("!document.fullscreenElement");
  await page.settled();
  // As a window again, with its course beside the stage.
  await page.until("document.querySelectorAll('#mirror [role=tab]').length > 3");
  assertQuiet(page);
});

test("a page at which nobody does anything draws nothing", async () => {
  const init = `window.drawn = 0; const { clear } = WebGL2RenderingContext.prototype;
    WebGL2RenderingContext.prototype.clear = function (...bits) { drawn += 1; return clear.apply(this, bits); };`;
  const page = await opened({ init: at("05-intervals", "clip-the-parameter") + init });
  await page.until("performance.getEntriesByType('resource').some((it) => it.name.includes('SC-Bold') && it.responseEnd)");
  await sleep(2000);
  const drawn = await page.see("drawn");
  assert(drawn > 0);
  await sleep(2000);
  assert.equal(await page.see("drawn"), drawn);
});

test("what is done is there again after a reload, and in another tab", async () => {
  const page = await opened();
  const first = await open(page);
  // The first is the answer to what the step asks.
  for (let i = 0; i < 4; i++) await page.press("PageDown");
  await page.until("JSON.parse(localStorage.getItem('clipscope') ?? '{}').page?.Step !== undefined", "it is kept");
  const left = await open(page);
  assert.notEqual(left, first);
  await sleep(1500);
  await page.settled();
  await page.go(server.url);
  await page.running();
  assert.equal(await open(page), left);
  const other = await opened({ beside: page });
  assert.equal(await open(other), left);
  assertQuiet(page);
});

test("a storage that is refused is said once, and all else works", async () => {
  const refuse = `Object.defineProperty(window, "localStorage", { get() { throw new DOMException("no", "SecurityError"); } });`;
  const page = await opened({ init: refuse });
  assert((await read(page)).includes("keeps nothing for this page"));
  await page.press("PageDown");
  assertQuiet(page);
});

test("a download that the server has unpacked is taken as it comes", async () => {
  server.state.manner = "inflated";
  await opened();
});

for (const manner of ["cut", "short", "gone"])
  test(`a download that does not come whole is said, and can be tried again: ${manner}`, async () => {
    server.state.manner = manner;
    const page = await bench.browser.page();
    await page.go(server.url);
    await failed(page, "broken");
    assert((await said(page)).includes("did not arrive whole"));
    server.state.manner = "well";
    await page.see("document.querySelector('#again').click()");
    await page.running();
  });

test("a panic is told, with a way back to where it was", async () => {
  const page = await opened({ init: at("05-intervals", "clip-the-parameter") });
  await page.press("PageDown");
  await sleep(1500);
  await page.settled();
  const before = await open(page);
  const script = await page.see(`document.querySelector("link[rel=modulepreload]").href`);
  await page.see(`import(${JSON.stringify(script)}).then((app) => app.panic()).catch(() => {})`);
  await failed(page, "stopped");
  assert((await said(page)).includes("for a test"));
  await page.see("document.querySelector('#again').click()");
  await page.running();
  assert.equal(await open(page), before);
});

test("without JavaScript the page says in four languages what it needs", async () => {
  const page = await bench.browser.page();
  await page.send("Emulation.setScriptExecutionDisabled", { value: true });
  await page.go(server.url);
  const words = async () => {
    const { root: document } = await page.send("DOM.getDocument", { depth: -1 });
    return (await page.send("DOM.querySelectorAll", { nodeId: document.nodeId, selector: "noscript p" })).nodeIds;
  };
  let nodeIds = [];
  // No script can say when the page has come; until then nodes go while one looks at them.
  for (let i = 0; i < 100 && nodeIds.length < 4; i += 1, await sleep(50)) nodeIds = await words().catch(() => []);
  assert.equal(nodeIds.length, 4);
  const { model } = await page.send("DOM.getBoxModel", { nodeId: nodeIds[0] });
  assert(model.width > 100 && model.height > 10, "it is to be seen");
});

test("without WebGL the page says so", async () => {
  const blind = new Browser({ hasGl: false });
  try {
    const page = await blind.page();
    await page.go(server.url);
    await failed(page, "no-webgl");
    assert((await said(page)).includes("WebGL 2"));
  } finally {
    await blind.close();
  }
});

test("a scene is saved as a download, and opened again by choosing it", async () => {
  const folder = mkdtempSync(join(tmpdir(), "clipscope-down-"));
  const page = await opened({ init: at("05-intervals", "clip-the-parameter") });
  await bench.browser.send("Browser.setDownloadBehavior", { behavior: "allow", downloadPath: folder });
  await page.press("Ctrl+s");
  await page.press("Enter");
  const arrived = async () => {
    for (let i = 0; i < 100; i++, await sleep(50)) {
      const [file] = readdirSync(folder).filter((name) => !name.endsWith(".crdownload"));
      if (file) return join(folder, file);
    }
    throw new Error("nothing was downloaded");
  };
  const file = await arrived();
  assert(readFileSync(file, "utf8").includes('method = "liang-barsky"'));
  await choose(page, [file]);
  await page.until("document.title.includes('.toml')", "the file is open");
  assertQuiet(page);
  rmSync(folder, { recursive: true });
});

test("a mesh is chosen with its picture", async () => {
  const page = await opened({ init: at("22-whole-objects-first", "outside-is-culled") });
  const spot = (name) => join(root, "assets/meshes/spot", name);
  await choose(page, [spot("spot_texture.png"), spot("spot.obj")]);
  await page.until("document.querySelector('#mirror').textContent.includes('5,856') || document.querySelector('#mirror').textContent.includes('5856')", "its faces are counted");
  assertQuiet(page);
});

test("a figure is the same bytes as the desktop's", async () => {
  const folder = mkdtempSync(join(tmpdir(), "clipscope-figure-"));
  const page = await opened({ init: at("05-intervals", "clip-the-parameter") });
  await bench.browser.send("Browser.setDownloadBehavior", { behavior: "allow", downloadPath: folder });
  await page.press("Ctrl+e");
  await page.press("Enter");
  let file;
  for (let i = 0; i < 200 && !file; i++, await sleep(50)) file = readdirSync(folder).find((name) => name.endsWith(".png"));
  assert(file, "nothing was downloaded");
  const out = join(folder, "desktop");
  execFileSync(process.env.CLIPSCOPE, ["export", "--out", out, "--size", "1920x1080", "05-intervals"], { stdio: "ignore" });
  const desktop = readFileSync(join(out, "05-intervals", file));
  assert(desktop.equals(readFileSync(join(folder, file))), `${file} differs`);
  rmSync(folder, { recursive: true });
});

test("after the first visit it works without a network", async () => {
  const alone = await serve(dist, "/once/");
  const page = await bench.browser.page();
  await page.go(alone.url);
  await page.running();
  await page.until("navigator.serviceWorker.ready.then(() => caches.match('./')).then((kept) => !!kept)");
  const left = await read(page);
  alone.close();
  await page.go("about:blank");
  await page.go(alone.url);
  await page.running();
  assert.equal(await read(page), left);
});

test("the example of embedding: it takes no focus and no wheel, tells what is done, and does what it is asked", async () => {
  const page = await bench.browser.page({ size: [900, 700] });
  await page.go(`${server.url}example.html`);
  const told = (what) => page.until(`document.querySelector("#told").textContent.includes(${JSON.stringify(what)})`, what);
  await told('"page":"05-intervals/a-row-for-each-side"');
  assert.deepEqual(await page.see("[document.activeElement.tagName, scrollY]"), ["BODY", 0]);
  const { x, y } = await page.see("(({ left, top }) => ({ x: left + 100, y: top + 100 }))(document.querySelector('iframe').getBoundingClientRect())");
  await page.send("Input.dispatchMouseEvent", { type: "mouseWheel", x, y, deltaX: 0, deltaY: 120 });
  await page.until("scrollY > 0", "the page scrolls under the wheel");
  await page.see("scrollTo(0, 0)");
  await page.see("ask({ page: '03-outcodes/rejected' })");
  await told('"page":"03-outcodes/rejected"');
  await page.see("ask({ page: '05-intervals/clip-the-parameter', lang: 'es', theme: 'dark' })");
  await told('"page":"05-intervals/clip-the-parameter"');
  await page.until("document.querySelector('iframe').contentDocument.documentElement.lang === 'es'");
  const before = await page.see("document.querySelector('#told').textContent");
  await page.click(x, y);
  await page.press("ArrowRight");
  await page.until(`document.querySelector("#told").textContent !== ${JSON.stringify(before)}`, "a step is told");
  assertQuiet(page);
});

test("an address leads to its step, and follows the steps", async () => {
  const page = await opened({ search: "#05-intervals/clip-the-parameter", init: remembered({ asks: false }) });
  assert((await caption(page)).length > 10);
  await page.press("PageDown");
  await page.until("location.hash.startsWith('#05-intervals/') && !location.hash.endsWith('clip-the-parameter')");
  const length = await page.see("history.length");
  await page.press("PageDown");
  assert.equal(await page.see("history.length"), length, "Back leads to where one came from");
  await page.see("location.hash = '#03-outcodes/rejected'");
  await page.settled();
  await page.until("document.querySelector('#mirror').textContent.includes('outcode') || document.querySelector('#mirror').textContent.includes('Outcode')");
  assertQuiet(page);
});

test("the page's own words are there in each language", async () => {
  const name = readdirSync(dist).find((file) => /^words-/.test(file));
  const { LANGUAGES, language } = await import(join(dist, name));
  const keys = Object.keys(LANGUAGES.en).sort();
  for (const [lang, words] of Object.entries(LANGUAGES)) assert.deepEqual(Object.keys(words).sort(), keys, lang);
  assert.equal(language(["fr", "pt-PT", "en"]), "pt-BR");
  assert.equal(language(["fr"]), "en");
});
