// Brings the app, says how much of it is there, and what stands in its way.

import { language, words } from "@words.js@";
import { keepKeys } from "@keys.js@";
import { embed, startUnfocused, talk } from "@embed.js@";
import { scorm, splice } from "@platform.js@";

/// Of the program: gzipped under a name that no server does anything with, and as it is.
const PACKED = { url: "@clipscope.bin@", bytes: @clipscope.bin:bytes@ };
const PLAIN = { url: "@clipscope.wasm@", bytes: @clipscope.wasm:bytes@ };
const WASM = [0x00, 0x61, 0x73, 0x6d];

const WANTED = new URLSearchParams(location.search);
const EMBED = WANTED.has("embed");
/// Lessons of a package, one after the other.
const PACKED_LESSONS = WANTED.get("scorm")?.split(",").filter(Boolean);

const lang = language(navigator.languages ?? []);
const say = words(lang);
const at = (id) => document.getElementById(id);
const canvas = at("stage");

class Broken extends Error {}

function tell(text, { of = null, more = "", link = "" } = {}) {
  document.documentElement.lang = lang;
  at("notice").hidden = false;
  at("said").textContent = text;
  at("more").textContent = more;
  at("progress").hidden = of === null;
  if (of > 0) at("progress").value = of;
  at("again").hidden = !link;
  at("again").textContent = link;
  at("again").href = location.href;
}

/// What cannot be mended from here. The state is for tests, and for a page around this one.
function fail(state, text, rest) {
  if (document.body.dataset.state?.startsWith("failed")) return;
  document.body.dataset.state = `failed: ${state}`;
  tell(text, rest);
  // A link to the same address, but for what follows "#", loads nothing by itself.
  at("again").onclick = (event) => {
    event.preventDefault();
    location.reload();
  };
  at("again").focus();
}

/// The program's bytes. Servers may have unpacked it on the way, or sent half of it and called that all.
async function program() {
  const packed = typeof DecompressionStream === "function" ? PACKED : PLAIN;
  const answer = await fetch(new URL(packed.url, import.meta.url)).catch((error) => {
    throw new Broken(error);
  });
  if (!answer.ok || !answer.body) throw new Broken(`${answer.status} ${answer.statusText}`);
  const parts = [];
  let length = 0;
  const reader = answer.body.getReader();
  for (;;) {
    const { done, value } = await reader.read().catch((error) => {
      throw new Broken(error);
    });
    if (done) break;
    parts.push(value);
    length += value.length;
    const mega = (bytes) => (bytes / 1e6).toFixed(1);
    if (length <= packed.bytes)
      tell(say.loadingOf(mega(length), mega(packed.bytes)), { of: length / packed.bytes });
  }
  const isPlain = WASM.every((byte, i) => parts[0]?.[i] === byte);
  if (length !== (isPlain ? PLAIN : packed).bytes) throw new Broken(`${length} / ${packed.bytes}`);
  const bytes = new Blob(parts);
  if (isPlain) return bytes.arrayBuffer();
  const unpacked = bytes.stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(unpacked).arrayBuffer().catch((error) => {
    throw new Broken(error);
  });
}

/// What the program needs only now and then.
const BESIDE = {
  "NotoSansSC-Regular.otf": "@NotoSansSC-Regular.otf@",
  "NotoSansSC-Bold.otf": "@NotoSansSC-Bold.otf@",
  "texts-zh-CN.bin": "@texts-zh-CN.bin@",
  "texts-es.bin": "@texts-es.bin@",
  "texts-pt-BR.bin": "@texts-pt-BR.bin@",
  "spot.bin": "@spot.bin@",
};

async function beside(name) {
  const answer = await fetch(new URL(BESIDE[name], import.meta.url));
  if (!answer.ok) throw new Broken(name);
  return answer.arrayBuffer();
}

/// Where another course lies, and its one file, where that can be had.
async function otherCourse() {
  const folder = WANTED.get("course");
  if (!folder) return [];
  const place = new URL(folder.replace(/\/?$/, "/"), location.href);
  const answer = await fetch(new URL("course.json", place)).catch(() => null);
  return [folder, answer?.ok ? new Uint8Array(await answer.arrayBuffer()) : undefined];
}

/// To a learning platform around this page, if there is one.
function report() {
  const ask = (what) => dispatchEvent(new CustomEvent("clipscope-ask", { detail: JSON.stringify(what) }));
  const lang = WANTED.get("lang");
  if (lang) ask({ lang });
  const lessons = PACKED_LESSONS ?? [location.hash.slice(1).split(/[/&]/)[0]].filter(Boolean);
  if (!PACKED_LESSONS || !scorm(lessons, ask)) splice(lessons, ask);
}

function stopped(why) {
  fail("stopped", say.stopped, { more: say.stoppedMore(why), link: say.reopen });
}

function watch() {
  addEventListener("clipscope-panic", (event) => stopped(event.detail));
  // Memory that runs out ends the program without a panic.
  addEventListener("error", ({ error }) => {
    if (error instanceof WebAssembly.RuntimeError) stopped(error.message);
  });
  addEventListener("unhandledrejection", ({ reason }) => {
    if (reason instanceof WebAssembly.RuntimeError) stopped(reason.message);
  });
}

/// Chromium that plays another device says how many pixels its own screen would have: then the app counts them by the ratio.
function measurePixels() {
  return new Promise((measured) => {
    new ResizeObserver(([{ contentRect, devicePixelContentBoxSize }], observer) => {
      observer.disconnect();
      const pixels = devicePixelContentBoxSize?.[0].inlineSize ?? NaN;
      if (Math.abs(pixels - contentRect.width * devicePixelRatio) > 1) delete ResizeObserverEntry.prototype.devicePixelContentBoxSize;
      measured();
    }).observe(document.body);
  });
}

async function run() {
  tell(say.loading, { of: 0 });
  if (!document.createElement("canvas").getContext("webgl2")) return fail("no-webgl", say["no-webgl"]);
  const [bytes, app] = await Promise.all([
    program(),
    import("@clipscope.js@").catch((error) => {
      throw new Broken(error);
    }),
  ]);
  tell(say.starting, { of: 0 });
  await app.default({ module_or_path: bytes });
  watch();
  keepKeys(canvas);
  if (EMBED) embed(canvas);
  if (PACKED_LESSONS && !location.hash) location.replace(`#${PACKED_LESSONS[0]}`);
  const [course] = await Promise.all([otherCourse(), measurePixels()]);
  await startUnfocused(() => app.start(canvas, beside, ...course));
  talk();
  report();
  at("notice").hidden = true;
  document.body.dataset.state = "running";
  // In a frame that would scroll the page around it.
  if (window.top === window) canvas.focus({ preventScroll: true });
  keep();
}

/// Everything for the next time without a network; says so quietly when a newer set has come. A browser that cannot does without.
async function keep() {
  if (!("serviceWorker" in navigator) || window.top !== window || EMBED || PACKED_LESSONS) return;
  const few = navigator.connection?.saveData ? "?few" : "";
  const kept = await navigator.serviceWorker.register(new URL(`sw.js${few}`, location.href)).catch(() => null);
  kept?.addEventListener("updatefound", () => {
    const newer = kept.installing;
    newer?.addEventListener("statechange", () => newer.state === "installed" && navigator.serviceWorker.controller && tellNewer());
  });
  document.addEventListener("visibilitychange", () => document.hidden || kept?.update().catch(() => {}));
}

/// A page that came with the newer set is no older than that.
async function tellNewer() {
  const answer = await fetch(new URL("index.html", location.href), { cache: "no-cache" }).catch(() => null);
  const own = new URL(import.meta.url).pathname.split("/").pop();
  if (!answer?.ok || (await answer.text()).includes(own)) return;
  at("newer").textContent = say.newer;
  at("newer").href = location.href;
  at("newer").onclick = () => location.reload();
  at("newer").hidden = false;
}

run().catch((error) => {
  if (error instanceof Broken) fail("broken", say.broken, { more: say.brokenMore, link: say.again });
  else if (typeof WebAssembly !== "object" || error instanceof WebAssembly.CompileError)
    fail("old", say.old, { more: say.oldMore(error.message) });
  else stopped(error.message ?? error);
});
