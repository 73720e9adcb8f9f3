// What tests of the page have in common: a server, a browser, and ways to look at what the app shows.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

import { Browser } from "./browser.mjs";
import { serve } from "./server.mjs";

const here = dirname(fileURLToPath(import.meta.url));
export const root = join(here, "../..");
export const dist = process.env.DIST ?? join(here, "../dist");
export const server = await serve(dist);
export const tests = [];
export const test = (name, run) => tests.push({ name, run });
/// One that hangs is not the next test's.
export const bench = { browser: new Browser() };

/// A script that remembers this before the page comes, as if the reader had been here.
export const remembered = (settings) =>
  `localStorage.getItem("clipscope") ?? localStorage.setItem("clipscope", ${JSON.stringify(JSON.stringify({ is_greeted: true, ...settings }))});`;

export const at = (lesson, step, settings = {}) => remembered({ asks: false, page: { Step: [lesson, step] }, ...settings });

export async function opened(options = {}) {
  const page = await bench.browser.page(options);
  await page.go(server.url + (options.search ?? ""));
  await page.running();
  return page;
}

export const caption = (page) => page.see("document.querySelector('#mirror [data-name=caption]')?.textContent ?? null");
export const read = (page) => page.see("document.querySelector('#mirror').textContent");
/// The open lesson and its open step, by their names in the course.
export const open = (page) =>
  page.see("[...document.querySelectorAll('#mirror [role=tab][aria-selected=true]')].map((it) => it.getAttribute('aria-label')).join()");
export const failed = (page, state) => page.until(`document.body?.dataset.state === "failed: ${state}"`);
export const said = (page) => page.see("document.querySelector('#notice').innerText");

/// Ctrl+O, and these files in the browser's dialog.
export async function choose(page, files) {
  const chooser = new Promise((done) => {
    const hear = page.hear.bind(page);
    page.hear = (method, params) => (method === "Page.fileChooserOpened" ? done(params) : hear(method, params));
  });
  await page.send("Page.setInterceptFileChooserDialog", { enabled: true });
  await page.press("Ctrl+o");
  const { backendNodeId } = await chooser;
  await page.send("DOM.setFileInputFiles", { files, backendNodeId });
}

export function assertQuiet(page) {
  assert.deepEqual(page.complaints, []);
}

/// Steps of a case as `clipscope trace` tells them: what happens, and the formulas.
export function told(given, lang) {
  const args = ["trace", "--format", "markdown", "--lang", lang];
  const key = execFileSync(process.env.CLIPSCOPE, args, { input: JSON.stringify(given), encoding: "utf8" });
  const rows = key.split("\n").filter((line) => /^\| \d+ \|/.test(line));
  return rows.map((row) => row.split(" | ").slice(1, 3).map((cell) => cell.replaceAll("\\", "")));
}

export const bare = (text) => text.replaceAll("<br>", "").replace(/[\s*`]/g, "");
