// A learning platform around this page: SCORM 1.2 by the API of a window around it, or SPLICE by messages to it. What a student has
// reached is the app's own score (0 to 1) of some lessons and the marks that it comes from; nothing is reckoned here.

/// Has `heard` told of all answers and goals of a frame, and of every change, once all of it has been told.
function listen(heard) {
  const now = { page: null, score: null, open: null, progress: null };
  let done = [];
  let waits = false;
  addEventListener("clipscope-told", ({ detail }) => {
    const { answered, reached, ...told } = JSON.parse(detail);
    if (answered || reached) done.push({ page: told.page, answered: answered ?? "reached" });
    Object.assign(now, told);
    if (waits) return;
    waits = true;
    queueMicrotask(() => {
      waits = false;
      heard(now, done);
      done = [];
    });
  });
}

function scormApi() {
  let at = window;
  try {
    for (let n = 0; n < 16; n += 1) {
      if (at.API) return at.API;
      if (at.parent === at) break;
      at = at.parent;
    }
    return window.opener?.API ?? window.opener?.parent?.API ?? null;
  } catch {
    return null;
  }
}

/// `HH:MM:SS`.
export function timespan(ms) {
  const secs = Math.floor(ms / 1000);
  return [secs / 3600, (secs / 60) % 60, secs % 60].map((n) => String(Math.floor(n)).padStart(2, "0")).join(":");
}

/// Reports these lessons to a SCORM 1.2 platform, if there is one.
export function scorm(lessons, ask) {
  const api = scormApi();
  if (!api) return false;
  const get = (key) => String(api.LMSGetValue(key));
  const set = (key, value) => api.LMSSetValue(key, String(value));
  const began = Date.now();
  api.LMSInitialize("");
  if (!["completed", "passed", "failed"].includes(get("cmi.core.lesson_status"))) {
    set("cmi.core.lesson_status", "incomplete");
    api.LMSCommit("");
  }
  // What this browser remembers may be another student's.
  ask({ scored: lessons, afresh: true, progress: get("cmi.suspend_data") || null });
  const place = get("cmi.core.lesson_location");
  if (place && location.hash === `#${lessons[0]}`) location.replace(`#${place}`);
  let n = Number(get("cmi.interactions._count")) || 0;
  let isOver = false;
  listen(({ page, score, open, progress }, done) => {
    if (isOver) return;
    if (progress) set("cmi.suspend_data", progress);
    if (page) set("cmi.core.lesson_location", page);
    if (done.length === 0) return;
    for (const { page, answered } of done) {
      set(`cmi.interactions.${n}.id`, page.replace(/[^A-Za-z0-9]+/g, "_"));
      set(`cmi.interactions.${n}.type`, "performance");
      set(`cmi.interactions.${n}.result`, answered === "missed" ? "wrong" : "correct");
      n += 1;
    }
    set("cmi.core.score.min", 0);
    set("cmi.core.score.max", 100);
    set("cmi.core.score.raw", Math.round(100 * score));
    if (open === 0) set("cmi.core.lesson_status", "completed");
    api.LMSCommit("");
  });
  const keep = () => {
    set("cmi.core.session_time", timespan(Date.now() - began));
    api.LMSCommit("");
  };
  document.addEventListener("visibilitychange", () => document.hidden && !isOver && keep());
  addEventListener("pagehide", () => {
    if (isOver) return;
    set("cmi.core.exit", "suspend");
    keep();
    isOver = true;
    api.LMSFinish("");
  });
  // A page that the browser has kept as it was has been finished.
  addEventListener("pageshow", ({ persisted }) => persisted && location.reload());
  return true;
}

/// Reports these lessons to the page around this one, by SPLICE: it starts at once, and takes up a state that comes.
export function splice(lessons, ask) {
  const parent = window.parent;
  if (parent === window) return;
  const activity = new URL(`#${lessons.join()}`, location.href).href;
  let n = 0;
  const post = (subject, more) => {
    n += 1;
    parent.postMessage({ subject, message_id: `clipscope-${n}`, activity_id: activity, ...more }, "*");
  };
  let latest = null;
  let isTold = true;
  const report = () => {
    if (isTold || !latest) return;
    isTold = true;
    post("SPLICE.reportScoreAndState", { score: latest.score, state: latest.progress });
  };
  listen((now, done) => {
    if (now.progress && now.progress !== latest?.progress) [latest, isTold] = [{ ...now }, false];
    for (const data of done) post("SPLICE.sendEvent", { name: "answered", data });
    if (done.length > 0) report();
  });
  addEventListener("message", ({ source, data }) => {
    const isAnswer = source === parent && data?.subject === "SPLICE.getState.response";
    // What this browser remembers may be another student's.
    if (isAnswer) ask({ afresh: true, progress: typeof data.state === "string" ? data.state : null });
  });
  addEventListener("pagehide", report);
  document.addEventListener("visibilitychange", () => document.hidden && report());
  ask({ scored: lessons });
  post("SPLICE.getState", {});
}
