// From navigation to the first frame: medians of ten first visits, from a server on this machine. `DIST=… node measure.mjs`.

import { bench, server } from "./bench.mjs";
import { Browser } from "./browser.mjs";

const N_VISITS = 10;
const MARKS = `{
  window.marks = {};
  const mark = (name) => (marks[name] ??= performance.now());
  const { instantiate } = WebAssembly;
  WebAssembly.instantiate = (...given) => (mark("arrived"), instantiate(...given).then((made) => (mark("compiled"), made)));
  const { drawElements } = WebGL2RenderingContext.prototype;
  WebGL2RenderingContext.prototype.drawElements = function (...given) {
    drawElements.apply(this, given);
    if (!marks.begun) requestAnimationFrame(() => mark("drawn"));
    mark("begun");
  };
}`;

const browser = new Browser({ isFresh: true });
const visits = [];
for (let i = 0; i < N_VISITS; i += 1) {
  const page = await browser.page({ scale: 1, init: MARKS });
  await page.go(server.url);
  await page.running();
  await page.until("marks.drawn > 0");
  const { arrived, compiled, begun, drawn } = await page.see("marks");
  visits.push({ "fetched and unpacked": arrived, compiled: compiled - arrived, started: begun - compiled, drawn: drawn - begun, all: drawn });
  await browser.closePages();
}
for (const part of Object.keys(visits[0])) {
  const sorted = visits.map((visit) => visit[part]).sort((a, b) => a - b);
  const middle = (sorted[N_VISITS / 2 - 1] + sorted[N_VISITS / 2]) / 2;
  console.log(`${part}: ${(middle / 1000).toFixed(2)} s (${(sorted[0] / 1000).toFixed(2)} to ${(sorted.at(-1) / 1000).toFixed(2)})`);
}
await browser.close();
await bench.browser.close();
server.close();
process.exit(0);
