// Chromium over the DevTools protocol, through a pipe: no port, no package, and any node will do.

import { spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

const FLAGS = [
  "--headless=new",
  "--no-sandbox",
  "--disable-dev-shm-usage",
  "--force-device-scale-factor=1",
  "--hide-scrollbars",
  "--no-first-run",
  "--disable-extensions",
  "--remote-debugging-pipe",
];
/// Without these a machine with no graphics card has no WebGL, and a test that does not look is green on nothing.
const SOFTWARE_GL = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"];
/// What one page has compiled the next one need not: a fresh process would spend most of a test on that.
const ONE_PROCESS = "--process-per-site";
const PATIENCE_MS = 60_000;

export const sleep = (ms) => new Promise((done) => setTimeout(done, ms));

export class Browser {
  #next = 1;
  #asked = new Map();
  #heard = new Map();
  #pages = [];
  #first = null;
  #n_hosts = 0;

  /// `isFresh`: each page is compiled anew, as it is on a first visit.
  constructor({ hasGl = true, isFresh = false } = {}) {
    this.home = mkdtempSync(join(tmpdir(), "clipscope-page-"));
    const flags = [...FLAGS, ...(isFresh ? [] : [ONE_PROCESS]), ...(hasGl ? SOFTWARE_GL : ["--disable-gpu", "--disable-3d-apis"])];
    this.child = spawn(process.env.CHROMIUM, [...flags, `--user-data-dir=${this.home}`, "about:blank"], {
      stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"],
    });
    let rest = "";
    this.child.stdio[4].setEncoding("utf8").on("data", (data) => {
      const messages = (rest + data).split("\0");
      rest = messages.pop();
      for (const message of messages) this.#take(JSON.parse(message));
    });
  }

  #take({ id, result, error, method, params, sessionId }) {
    if (id === undefined) return this.#heard.get(sessionId)?.(method, params);
    const { resolve, reject, what } = this.#asked.get(id);
    this.#asked.delete(id);
    error ? reject(new Error(`${what}: ${error.message}`)) : resolve(result);
  }

  send(method, params = {}, sessionId = undefined) {
    const id = this.#next++;
    this.child.stdio[3].write(`${JSON.stringify({ id, method, params, sessionId })}\0`);
    return new Promise((resolve, reject) => this.#asked.set(id, { resolve, reject, what: method }));
  }

  /// A page at a host of its own, and so with a storage of its own, unless it is to share that of another. `scale` is its pixels a point: half of one where no
  /// picture is looked at, since what plays a graphics card takes most of a test's time.
  async page({ size = [1280, 720], scale = 0.5, beside = null, touch = false, init = "" } = {}) {
    const host = beside?.host ?? `page-${(this.#n_hosts += 1)}.clipscope.localhost`;
    const { targetId } = await this.send("Target.createTarget", { url: "about:blank" });
    const { sessionId } = await this.send("Target.attachToTarget", { targetId, flatten: true });
    const page = new Page(this, { host, targetId, sessionId });
    this.#pages.push(page);
    this.#heard.set(sessionId, (method, params) => page.hear(method, params));
    for (const domain of ["Page", "Runtime", "Log", "Network"]) await page.send(`${domain}.enable`);
    const [width, height] = size;
    await page.send("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: scale, mobile: touch });
    if (touch) await page.send("Emulation.setTouchEmulationEnabled", { enabled: true });
    if (init) await page.send("Page.addScriptToEvaluateOnNewDocument", { source: init });
    return page;
  }

  /// Pages that have been looked at draw on, and take the time of those that follow. The first one stays, at rest, and with it what is
  /// compiled.
  async closePages() {
    this.#first ??= this.#pages.shift();
    for (const page of this.#pages) {
      await page.close();
      if (page.origin) await this.#first.send("Storage.clearDataForOrigin", { origin: page.origin, storageTypes: "all" });
    }
    this.#pages = [];
    this.#heard.clear();
  }

  async close() {
    const gone = new Promise((done) => this.child.once("exit", done));
    await Promise.race([this.send("Browser.close").catch(() => {}), sleep(2000)]);
    await Promise.race([gone, sleep(3000)]);
    this.child.kill("SIGKILL");
    rmSync(this.home, { recursive: true, force: true, maxRetries: 5 });
  }
}

/// How keys are told to the browser: what is typed has text.
const KEYS = { PageDown: 34, PageUp: 33, End: 35, Home: 36, ArrowLeft: 37, ArrowRight: 39, Escape: 27, Tab: 9, Enter: 13, F5: 116 };
const HELD = { Alt: 1, Ctrl: 2, Shift: 8 };

class Page {
  constructor(browser, ids) {
    Object.assign(this, { browser }, ids);
    /// What the console called an error or a warning, and what was thrown.
    this.complaints = [];
    this.downloads = [];
  }

  hear(method, params) {
    if (method === "Runtime.exceptionThrown") {
      const { text, exception } = params.exceptionDetails;
      this.complaints.push(`${text} ${exception?.description ?? ""}`);
    } else if (method === "Runtime.consoleAPICalled" && ["error", "warning", "assert"].includes(params.type)) {
      this.complaints.push(params.args.map((arg) => arg.value ?? arg.description).join(" "));
    } else if (method === "Log.entryAdded" && params.entry.level === "error") {
      this.complaints.push(`${params.entry.text} ${params.entry.url ?? ""}`);
    }
  }

  send(method, params) {
    return this.browser.send(method, params, this.sessionId);
  }

  /// An address on this machine, at the page's own host.
  at(url) {
    return url.replace("//127.0.0.1:", `//${this.host}:`);
  }

  async go(url) {
    if (url.startsWith("http")) this.origin = new URL(this.at(url)).origin;
    await this.send("Page.navigate", { url: this.at(url) });
  }

  /// What an expression comes to in the page; promises are waited for.
  async see(expression) {
    const asked = { expression, awaitPromise: true, returnByValue: true, userGesture: true };
    const { result, exceptionDetails } = await this.send("Runtime.evaluate", asked);
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }

  /// Waits until an expression is true, and says what it was where it never is.
  async until(expression, what = expression, patience = PATIENCE_MS) {
    const end = Date.now() + patience;
    let last;
    while (Date.now() < end) {
      last = await this.see(expression).catch((error) => error.message);
      if (last === true) return;
      await sleep(50);
    }
    const state = await this.see("document.body?.dataset.state + ' · ' + document.querySelector('#said')?.textContent");
    throw new Error(`never: ${what}; last ${JSON.stringify(last)}; the page is: ${state}; ${this.complaints.join("; ")}`);
  }

  async running() {
    await this.until("document.body?.dataset.state === 'running'", "the app runs");
    await this.settled();
  }

  /// Until the next frames have been drawn.
  settled() {
    const frames = "new Promise((done) => { let n = 4; const frame = () => (n-- ? requestAnimationFrame(frame) : done()); frame(); })";
    return this.see(frames);
  }

  async press(keys) {
    const parts = keys.split("+");
    const key = parts.pop();
    const modifiers = parts.reduce((sum, held) => sum | HELD[held], 0);
    const text = key.length === 1 && !modifiers ? { text: key } : {};
    const code = KEYS[key] ?? key.toUpperCase().charCodeAt(0);
    const of = { key, code: key.length === 1 ? `Key${key.toUpperCase()}` : key, modifiers, windowsVirtualKeyCode: code };
    await this.send("Input.dispatchKeyEvent", { type: text.text ? "keyDown" : "rawKeyDown", ...of, ...text });
    await this.send("Input.dispatchKeyEvent", { type: "keyUp", ...of });
    await this.settled();
  }

  async mouse(type, x, y, buttons = 1) {
    await this.send("Input.dispatchMouseEvent", { type, x, y, button: buttons ? "left" : "none", buttons, clickCount: 1 });
    await this.settled();
  }

  async click(x, y) {
    await this.mouse("mouseMoved", x, y, 0);
    await this.mouse("mousePressed", x, y);
    await this.mouse("mouseReleased", x, y);
  }

  /// What is on the screen, as a PNG in base64.
  async picture() {
    return (await this.send("Page.captureScreenshot", { format: "png" })).data;
  }

  /// How a picture differs from another one, or what it is by itself: the page has what reads PNGs.
  async compared(png, other = null) {
    const read = `async (base64) => {
      const blob = await (await fetch("data:image/png;base64," + base64)).blob();
      const image = await createImageBitmap(blob, { colorSpaceConversion: "none" });
      const canvas = new OffscreenCanvas(image.width, image.height);
      const context = canvas.getContext("2d");
      context.drawImage(image, 0, 0);
      return context.getImageData(0, 0, image.width, image.height);
    }`;
    return this.see(`(async () => {
      const read = ${read};
      const { data, width, height } = await read(${JSON.stringify(png)});
      const colours = new Map();
      for (let i = 0; i < data.length; i += 4) {
        const colour = (data[i] << 16) | (data[i + 1] << 8) | data[i + 2];
        colours.set(colour, (colours.get(colour) ?? 0) + 1);
      }
      const [commonest, count] = [...colours].reduce((a, b) => (a[1] < b[1] ? b : a));
      const about = { size: [width, height], colours: colours.size, most: count / (width * height), commonest };
      const other = ${JSON.stringify(other)};
      if (!other) return about;
      const its = (await read(other)).data;
      let far = 0, sum = 0;
      for (let i = 0; i < data.length; i += 4) {
        const by = Math.max(...[0, 1, 2].map((k) => Math.abs(data[i + k] - its[i + k])));
        sum += by;
        far += by > 32;
      }
      return { ...about, far: far / (width * height), mean: sum / (width * height) };
    })()`);
  }

  async close() {
    await this.browser.send("Target.closeTarget", { targetId: this.targetId });
  }
}
