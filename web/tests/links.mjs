// Links: what is copied in one page opens the same elsewhere, and what is none does no harm. Questions, courses, drops.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { cpSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { deflateRawSync, inflateRawSync } from "node:zlib";

import { assertQuiet, bare, bench, caption, dist, open, opened, read, remembered, root, server, test } from "./bench.mjs";
import { serve } from "./server.mjs";

const PLAIN = remembered({ asks: false });
const desktop = (...args) => execFileSync(process.env.CLIPSCOPE, args, { stdio: ["ignore", "pipe", "ignore"], encoding: "utf8" });
const inFolder = async (run) => {
  const folder = mkdtempSync(join(tmpdir(), "clipscope-links-"));
  try {
    await run(folder);
  } finally {
    rmSync(folder, { recursive: true });
  }
};

/// What Ctrl+Shift+L puts on the clipboard.
async function copied(page) {
  const permissions = ["clipboardReadWrite", "clipboardSanitizedWrite"];
  await bench.browser.send("Browser.grantPermissions", { permissions });
  await page.press("Ctrl+Shift+L");
  await page.settled();
  return page.see("navigator.clipboard.readText()");
}

test("a link copied in one page opens the same in another, and on the desktop", () =>
  inFolder(async (folder) => {
    const page = await opened({ search: "#05-intervals/clip-the-parameter", init: PLAIN });
    // The first handle goes somewhere else by the keyboard.
    await page.press("Tab");
    for (let i = 0; i < 3; i++) await page.press("ArrowRight");
    await page.press("Escape");
    for (let i = 0; i < 4; i++) await page.press("ArrowRight");
    const link = await copied(page);
    assert(link.startsWith(`${page.at(server.url)}#v1=`), link);
    assert.equal(await page.see("location.href"), link, "the address says the same");
    const other = await opened({ init: PLAIN });
    const atOther = link.replace(page.host, other.host);
    await other.go(atOther);
    await other.until(`document.querySelector('#mirror [data-name=caption]')?.textContent === ${JSON.stringify(await caption(page))}`);
    assert.equal(await open(other), await open(page));
    assert.equal(await copied(other), atOther);
    const scene = inflateRawSync(Buffer.from(/#v1=([^&]*)/.exec(link)[1], "base64url")).toString();
    writeFileSync(join(folder, "own.toml"), scene);
    desktop("export", "--alt", "--out", folder, join(folder, "own.toml"));
    const [told] = readdirSync(folder, { recursive: true }).filter((name) => name.endsWith(".txt"));
    const lines = readFileSync(join(folder, told), "utf8");
    assert(bare(lines).includes(bare(await caption(page))), `${lines} / ${await caption(page)}`);
    assertQuiet(page);
    assertQuiet(other);
  }));

const ASKED = "05-intervals/a-row-for-each-side";

test("a question is answered by a digit, and the page around is told", async () => {
  const parent = `<!doctype html><link rel="icon" href="data:,"><script>
    const heard = [];
    addEventListener("message", ({ data }) => data.clipscope && heard.push(data.clipscope));
  </script><iframe style="border:0;width:100vw;height:100vh" src="./?embed#${ASKED}"></iframe>`;
  server.state.pages.set("around.html", parent);
  const page = await bench.browser.page({ init: remembered({}) });
  await page.go(`${server.url}around.html`);
  await page.until(`heard.some(({ page }) => page === "${ASKED}")`);
  const mirror = "document.querySelector('iframe').contentDocument.querySelector('#mirror').textContent";
  const asking = await page.see(mirror);
  await page.click(20, 20);
  await page.press("1");
  await page.until(`heard.some(({ answered }) => answered)`);
  const { page: of, answered } = await page.see(`heard.find(({ answered }) => answered)`);
  assert.equal(of, ASKED);
  assert(["missed", "beforehand"].includes(answered), answered);
  assert.notEqual(await page.see(mirror), asking);
  assertQuiet(page);
});

test("another course is opened from beside the page, and one that is not there is told", () =>
  inFolder(async (folder) => {
    cpSync(join(root, "lessons/02-brute-force"), join(folder, "own/01-ours"), { recursive: true });
    const file = join(folder, "own/01-ours/en.md");
    writeFileSync(file, readFileSync(file, "utf8").replace(/^# .*/m, "# A lesson of ours"));
    desktop("pack", "--web", join(folder, "own"));
    server.state.pages.set("courses/ours/course.json", readFileSync(join(folder, "own/course.json")));
    const page = await opened({ search: "?course=courses/ours/", init: PLAIN });
    const labels = (page) => page.see("[...document.querySelectorAll('#mirror [aria-label]')].map((it) => it.ariaLabel).join()");
    assert((await labels(page)).includes("A lesson of ours"), await labels(page));
    assert((await copied(page)).startsWith(`${page.at(server.url)}?course=courses/ours/#`));
    assertQuiet(page);
    const lost = await opened({ search: "?course=courses/nobodys", init: PLAIN });
    const said = (await read(lost)) + (await labels(lost));
    assert(said.includes("courses/nobodys") && !said.includes("A lesson of ours"));
  }));

/// Seconds that the page has worked so far, whatever else the machine did meanwhile.
async function worked(page) {
  await page.send("Performance.enable", { timeDomain: "threadTicks" });
  const { metrics } = await page.send("Performance.getMetrics");
  return metrics.find(({ name }) => name === "TaskDuration").value;
}

test("a link that is none, or is hostile, gets a message within a second, and changes nothing", async () => {
  const packed = (text) => `#v1=${deflateRawSync(Buffer.from(text)).toString("base64url")}`;
  const lines = (segments) => packed(`method = "liang-barsky"\nwindow = [-1, -1, 1, 1]\nsegments = [${segments}]\n`);
  const whole = lines("[-2, -1, 2, 1]");
  const hostile = {
    "one gigabyte": packed(Buffer.alloc(1 << 30)),
    "not a number": lines("[nan, 0, 1, 1]"),
    "a million vertices": packed(`method = "sutherland-hodgman"\nwindow = [-1, -1, 1, 1]\npolygon = [${"[0, 0], ".repeat(1e6)}]\n`),
    "a scene that is too large for a link": lines("[0, 0, 1, 1], ".repeat(60_000)),
    "a later version": "#v7=AAAA",
    "cut short": whole.slice(0, -7),
    "no such step": "#05-intervals/nowhere",
    "an eye that sees nothing": "#19-the-view-volume&eye=NaN,0,0,0,0,1,30",
  };
  const page = await opened({ search: "#05-intervals/clip-the-parameter", init: PLAIN });
  const before = await read(page);
  for (const [what, link] of Object.entries(hostile)) {
    const begin = await worked(page);
    await page.see(`new Promise((done) => {
      new MutationObserver((_, it) => (it.disconnect(), done())).observe(document.querySelector("#mirror"), { subtree: true, childList: true, characterData: true });
      location.hash = ${JSON.stringify(link)};
    })`);
    const secs = (await worked(page)) - begin;
    assert(secs < 1, `${what}: ${secs.toFixed(1)} s`);
    await page.press("Escape");
    await page.until(`document.querySelector("#mirror").textContent === ${JSON.stringify(before)}`, `${what}: all is as it was`);
  }
  assertQuiet(page);
});

/// Files that are dropped on the middle of the page.
async function dropped(page, files) {
  const data = { items: [], files, dragOperationsMask: 1 };
  for (const type of ["dragEnter", "dragOver", "drop"]) {
    await page.send("Input.dispatchDragEvent", { type, x: 640, y: 300, data });
    await page.settled();
  }
}

test("a figure and a scene that are dropped open what they show", () =>
  inFolder(async (folder) => {
    desktop("export", "05-intervals", "--size", "640x360", "--out", folder);
    const scene = join(folder, "dropped.toml");
    writeFileSync(scene, 'method = "liang-barsky"\nwindow = [-1, -1, 1, 1]\nsegments = [[-2, 0.5, 2, 0.25]]\n');
    const page = await opened({ search: "#03-outcodes/rejected", init: PLAIN });
    await dropped(page, [join(folder, "05-intervals/interval-row.png")]);
    await page.until(`location.hash === "#${ASKED}"`, "the step of the figure");
    await dropped(page, [scene]);
    await page.until("document.title.includes('dropped.toml')", "the scene");
    await page.until("location.hash.startsWith('#v1=')");
    assertQuiet(page);
  }));

test("a page that was left open is told that there is a newer one, and a page that is newer is not", () =>
  inFolder(async (folder) => {
    cpSync(dist, folder, { recursive: true });
    const site = await serve(folder, "/kept/");
    const page = await bench.browser.page();
    await page.go(site.url);
    await page.running();
    await page.until("navigator.serviceWorker.ready.then(() => !!navigator.serviceWorker.controller)");
    // A newer page: its script has another name.
    const [script] = readdirSync(folder).filter((name) => /^page-.*\.js$/.test(name));
    const rewrite = (name, change) => writeFileSync(join(folder, name), change(readFileSync(join(folder, name), "utf8")));
    cpSync(join(folder, script), join(folder, "page-newer.js"));
    rewrite("index.html", (text) => text.replaceAll(script, "page-newer.js"));
    rewrite("sw.js", (text) => text.replaceAll(script, "page-newer.js").replace(/"clipscope-\w*"/, '"clipscope-newer"'));
    const other = await bench.browser.page({ beside: page });
    await other.go(site.url);
    await other.running();
    await page.until("!document.querySelector('#newer').hidden", "it is told");
    assert(await other.see("document.querySelector('#newer').hidden"), "the newer one says nothing");
    await page.send("Page.bringToFront");
    await page.see("document.querySelector('#newer').click()");
    await page.until("!!document.querySelector('script[src*=newer]')");
    await page.running();
    assertQuiet(page);
    site.close();
  }));
