// The page in learning platforms: a SCORM package under scorm-again, and a page around it that speaks SPLICE.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { copyFileSync, existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";

import { assertQuiet, bench, dist, remembered, server, test } from "./bench.mjs";
import { serve } from "./server.mjs";

const LESSON = "05-intervals";
/// These steps ask something, so that "1" answers.
const ASKED = `${LESSON}/a-row-for-each-side`;

/// The files of a zip that holds them as they are, one after the other.
function unzipped(bytes) {
  const files = new Map();
  for (let at = 0; bytes.readUInt32LE(at) === 0x04034b50; ) {
    const [size, name, extra] = [bytes.readUInt32LE(at + 22), bytes.readUInt16LE(at + 26), bytes.readUInt16LE(at + 28)];
    assert.equal(bytes.readUInt16LE(at + 8), 0, "stored");
    const begin = at + 30 + name + extra;
    files.set(bytes.toString("utf8", at + 30, at + 30 + name), bytes.subarray(begin, begin + size));
    at = begin + size;
  }
  return files;
}

/// A platform that keeps what is committed, notes each call with what came of it, and takes 4,096 characters of a state as the standard has
/// it: scorm-again is milder.
const PLATFORM = `<!doctype html><link rel="icon" href="data:,"><body style="margin:0"><script src="scorm12.min.js"></script><script>
const inner = new Scorm12API({ logLevel: 5 });
const kept = localStorage.getItem("cmi");
if (kept) inner.loadFromJSON(JSON.parse(kept), "cmi");
const calls = [];
window.API = {};
for (const name of ["Initialize", "Finish", "Commit", "GetValue", "SetValue", "GetLastError", "GetErrorString", "GetDiagnostic"].map((it) => "LMS" + it))
  API[name] = (...args) => {
    const isFit = args.every((it) => typeof it === "string") && !(args[0] === "cmi.suspend_data" && args[1]?.length > 4096);
    const answer = isFit ? String(inner[name](...args)) : "false";
    calls.push([name, ...args, answer]);
    if (name === "LMSCommit" || name === "LMSFinish") localStorage.setItem("cmi", JSON.stringify(inner.cmi.toJSON()));
    localStorage.setItem("calls", JSON.stringify(calls));
    return answer;
  };
</script><iframe style="border:0;width:100vw;height:100vh" src="FRAME"></iframe>`;

/// A page whose frame runs the app, has been clicked, and stands at a step that asks.
async function framed(page, url) {
  await page.go(url);
  const frame = "document.querySelector('iframe').contentDocument";
  await page.until(`${frame}?.body?.dataset.state === "running"`);
  await page.settled();
  await page.click(5, 715);
  return frame;
}

async function asked(page) {
  await page.see(`document.querySelector("iframe").contentWindow.location.hash = "#${ASKED}"`);
  await page.settled();
}

/// test.sh says so where npm's scorm-again could not be had.
const testWithPlatform = existsSync(process.env.SCORM_AGAIN) ? test : () => {};

async function withPackage(run) {
  const folder = mkdtempSync(join(tmpdir(), "clipscope-scorm-"));
  try {
    execFileSync(process.env.CLIPSCOPE, ["pack", "--scorm", LESSON, "--lang", "es", "--page", dist, "--out", join(folder, "a.zip")], { stdio: "ignore" });
    const files = unzipped(readFileSync(join(folder, "a.zip")));
    for (const [name, bytes] of files) {
      mkdirSync(dirname(join(folder, "package", name)), { recursive: true });
      writeFileSync(join(folder, "package", name), bytes);
    }
    const manifest = files.get("imsmanifest.xml").toString();
    const value = (name) => new RegExp(`${name}="([^"]*)"`).exec(manifest)[1].replaceAll("&amp;", "&");
    const launched = /adlcp:scormtype="sco" href="([^"]*)"/.exec(manifest)[1] + value("parameters");
    writeFileSync(join(folder, "platform.html"), PLATFORM.replace("FRAME", `package/${launched}`));
    copyFileSync(join(process.env.SCORM_AGAIN, "dist/scorm12.min.js"), join(folder, "scorm12.min.js"));
    writeFileSync(join(folder, "left.html"), `<!doctype html><link rel="icon" href="data:,">`);
    const platform = await serve(folder, "/mod/scorm/");
    await run(`${platform.url}platform.html`, { files, manifest });
    platform.close();
  } finally {
    rmSync(folder, { recursive: true });
  }
}

const calls = (page) => page.see("calls");
const setsOf = (calls) => calls.filter(([name]) => name === "LMSSetValue").map(([, key, value]) => [key, value]);
const last = (calls, key) => setsOf(calls).findLast(([it]) => it === key)?.[1];

testWithPlatform("a SCORM package lists every file, and has its manifest first", () =>
  withPackage((_, { files, manifest }) => {
    const names = [...files.keys()];
    assert.equal(names[0], "imsmanifest.xml");
    const listed = [...manifest.matchAll(/<file href="([^"]*)"/g)].map(([, name]) => name);
    assert.deepEqual(names.slice(1).sort(), listed.sort());
    assert(!names.some((name) => /sw\.js|\.br$|\.zip$/.test(name)), names.join());
  }));

testWithPlatform("a SCORM platform is told score, answers and state, and brings the state back", () =>
  withPackage(async (url) => {
    const page = await bench.browser.page({ init: remembered({ progress: { begun: 1, steps: { [ASKED]: { told: "beforehand" } } } }) });
    const frame = await framed(page, url);
    await page.until("calls.length > 3");
    assert.equal(await page.see(`${frame}.documentElement.lang`), "es");
    const began = await calls(page);
    assert.deepEqual(began[0], ["LMSInitialize", "", "true"]);
    const before = (it) => began.findIndex((call) => call.join().startsWith(it));
    assert(before("LMSSetValue,cmi.core.lesson_status,incomplete") < before("LMSCommit"), "incomplete at once");
    await page.until("calls.some(([, key]) => key === 'cmi.suspend_data' && calls.length)");
    assert.equal(last(await calls(page), "cmi.core.score.raw"), undefined, "no score before an answer");
    assert(!last(await calls(page), "cmi.suspend_data").includes("beforehand"), "what another student did in this browser is not theirs");
    await asked(page);
    await page.press("1");
    await page.until("calls.some(([, key]) => key === 'cmi.core.score.raw')");
    const answered = await calls(page);
    const id = setsOf(answered).find(([key]) => key === "cmi.interactions.0.id")[1];
    assert.equal(id, ASKED.replace(/[^a-z0-9]+/g, "_"));
    assert(["correct", "wrong"].includes(last(answered, "cmi.interactions.0.result")));
    assert(Number(last(answered, "cmi.core.score.raw")) < 100);
    assert.equal(answered.at(-1)[0], "LMSCommit");
    const state = last(answered, "cmi.suspend_data");
    assert(state.includes(ASKED), state);
    const told = JSON.parse(state).steps[ASKED].told;
    assert(told, state);

    // The student goes, and comes back.
    await page.see("document.querySelector('iframe').src = 'about:blank'");
    await page.until("calls.at(-1)[0] === 'LMSFinish'");
    const ended = await calls(page);
    assert(/^\d\d:\d\d:\d\d$/.test(last(ended, "cmi.core.session_time")));
    assert.equal(ended.filter(([name]) => name === "LMSFinish").length, 1);
    assert.deepEqual(ended.filter((call) => call.at(-1) === "false"), [], "each value is a string, and is taken");
    await framed(page, url);
    await page.until(`calls.some(([, key, value]) => key === "cmi.suspend_data" && value?.includes('"told":"${told}"'))`, "the state is taken up");
    const again = await calls(page);
    assert.equal(last(again, "cmi.core.score.raw"), undefined, "what was answered another time is not told again");
    const place = await page.see(`document.querySelector("iframe").contentWindow.location.hash`);
    assert(place.startsWith(`#${ASKED}`), place);
    // To a page of the same host, which reads what was kept and begins nothing anew.
    await page.go(new URL("left.html", url).href);
    const counted = `JSON.parse(localStorage.getItem("calls")).filter(([name]) => name === "LMSFinish").length`;
    await page.until(`location.pathname.endsWith("left.html") && ${counted} > 0`, "leaving the page ends it");
    await page.settled();
    assert.equal(await page.see(counted), 1, "once");
    assertQuiet(page);
  }));

/// A page that notes what its frame posts, and answers when it is told to.
const PARENT = `<!doctype html><link rel="icon" href="data:,"><body style="margin:0"><script>
const heard = [];
addEventListener("message", ({ data, source }) => {
  if (!data.subject?.startsWith("SPLICE.")) return;
  heard.push(structuredClone(data));
  localStorage.setItem("heard", JSON.stringify(heard));
});
const say = (data) => document.querySelector("iframe").contentWindow.postMessage(data, "*");
</script><iframe style="border:0;width:100vw;height:100vh" src="FRAME"></iframe>`;

for (const named of [true, false])
  test(`a SPLICE platform gets score and state, and its state is taken when it comes: ${named ? "with" : "without"} message_id`, async () => {
    const state = JSON.stringify({ version: 1, begun: 1, steps: { [`${LESSON}/entering`]: { told: "beforehand" } } });
    const parent = PARENT.replace("FRAME", `./#${ASKED}`);
    server.state.pages.set("parent.html", parent);
    const others = `${LESSON}/of-another-student`;
    const page = await bench.browser.page({ init: remembered({ progress: { begun: 1, steps: { [others]: { told: "beforehand" } } } }) });
    await framed(page, `${server.url}parent.html`);
    await page.until(`heard.some(({ subject }) => subject === "SPLICE.getState")`);
    const { message_id, activity_id } = await page.see(`heard.find(({ subject }) => subject === "SPLICE.getState")`);
    assert(message_id && activity_id);
    await page.press("1");
    const reports = `heard.filter(({ subject }) => subject === "SPLICE.reportScoreAndState")`;
    await page.until(`${reports}.length === 1`);
    const [first] = await page.see(reports);
    assert(first.score >= 0 && first.score < 1 && first.state.includes(ASKED), JSON.stringify(first));
    assert.equal(first.activity_id, activity_id);
    assert(!first.state.includes(others), "what another student did in this browser is not told");
    const [event] = await page.see(`heard.filter(({ subject }) => subject === "SPLICE.sendEvent")`);
    assert.equal(event.name, "answered");
    assert.equal(event.data.page, ASKED);

    // Late, and with more than is asked for.
    const answer = { subject: "SPLICE.getState.response", state, later: true, ...(named ? { message_id } : {}) };
    await page.see(`say(${JSON.stringify(answer)})`);
    await page.settled();
    await page.settled();
    // Another tab comes before it.
    const hide = (hidden) =>
      page.see(`(() => {
        const { contentDocument } = document.querySelector("iframe");
        Object.defineProperty(contentDocument, "hidden", { value: ${hidden}, configurable: true });
        contentDocument.dispatchEvent(new Event("visibilitychange"));
      })()`);
    await hide(true);
    await page.until(`${reports}.length === 2`, "what was not told is told when the page is hidden");
    const second = (await page.see(reports))[1];
    assert(second.score > first.score && second.state.includes("entering") && second.state.includes(ASKED), JSON.stringify(second));
    assert(!second.state.includes(others), second.state);
    assert.equal((await page.see(`heard.filter(({ subject }) => subject === "SPLICE.sendEvent")`)).length, 1, "the state is no answer");
    await hide(false);
    await page.see(`document.querySelector("iframe").contentWindow.location.hash = "#${LESSON}"`);
    await page.settled();
    await page.settled();
    await page.see(`document.querySelector("iframe").src = "about:blank"`);
    await page.until(`${reports}.length === 3`, "and when it goes");
    assert((await page.see(`localStorage.getItem("clipscope")`)).includes(others), "the other student's marks stay in this browser");
    assertQuiet(page);
  });
