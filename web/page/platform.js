// A learning platform around this page: SCORM 1.2 by the API of a window around it, or SPLICE by messages to it. What a student has
// reached is the app's own score (0 to 1) of some lessons and the marks that it comes from; nothing is reckoned here.

/// What SCORM 1.2 keeps of a state.
const MOST_STATE = 4096;

/// The state, without steps that were only seen where there is no room for them.
function fitting(progress) {
  if (progress.length <= MOST_STATE) return progress;
  const state = JSON.parse(progress);
  const steps = Object.entries(state.steps).filter(([, mark]) => mark.told !== "open" || mark.reached);
  const short = JSON.stringify({ ...state, steps: Object.fromEntries(steps) });
  return short.length <= MOST_STATE ? short : null;
}

/// Has `heard` told of each answer, and of every change, once all of a frame has been told.
function listen(heard) {
  const now = { score: null, open: null, progress: null };
  let answers = [];
  let waits = false;
  addEventListener("clipscope-told", ({ detail }) => {
    const told = JSON.parse(detail);
    if (told.answered) answers.push(told);
    if (told.progress) Object.assign(now, told);
    if (waits || !(told.answered || told.progress)) return;
    waits = true;
    queueMicrotask(() => {
      waits = false;
      heard(now, answers);
      answers = [];
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

/// `HHHH:MM:SS.SS`, as SCORM 1.2 writes a time.
export function timespan(ms) {
  const two = (n) => String(n).padStart(2, "0");
  const secs = Math.floor(ms / 1000);
  return `${String(Math.floor(secs / 3600)).padStart(4, "0")}:${two(Math.floor(secs / 60) % 60)}:${two(secs % 60)}`;
}

/// Reports these lessons to a SCORM 1.2 platform, if there is one.
export function scorm(lessons, ask) {
  const api = scormApi();
  if (!api) return false;
  const set = (key, value) => api.LMSSetValue(key, String(value));
  const began = Date.now();
  api.LMSInitialize("");
  if (!["completed", "passed", "failed"].includes(api.LMSGetValue("cmi.core.lesson_status"))) {
    set("cmi.core.lesson_status", "incomplete");
    api.LMSCommit("");
  }
  let n = Number(api.LMSGetValue("cmi.interactions._count")) || 0;
  listen(({ score, open, progress }, answers) => {
    const state = fitting(progress ?? "");
    if (state) set("cmi.suspend_data", state);
    if (answers.length === 0) return;
    for (const { page, answered } of answers) {
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
  const kept = api.LMSGetValue("cmi.suspend_data");
  ask({ scored: lessons, progress: kept || null });
  let isOver = false;
  addEventListener("pagehide", () => {
    if (isOver) return;
    isOver = true;
    set("cmi.core.session_time", timespan(Date.now() - began));
    set("cmi.core.exit", "suspend");
    api.LMSCommit("");
    api.LMSFinish("");
  });
  return true;
}

/// Reports these lessons to the page around this one, by SPLICE: it starts at once, and takes up a state that comes.
export function splice(lessons, ask) {
  const parent = window.parent;
  if (parent === window) return;
  const activity = location.href;
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
  listen((now, answers) => {
    [latest, isTold] = [{ ...now }, false];
    for (const { page, answered } of answers) post("SPLICE.sendEvent", { name: "answered", data: { page, answered } });
    if (answers.length > 0) report();
  });
  addEventListener("message", ({ source, data }) => {
    const isAnswer = source === parent && data?.subject === "SPLICE.getState.response";
    if (isAnswer && typeof data.state === "string") ask({ progress: data.state });
  });
  addEventListener("pagehide", report);
  document.addEventListener("visibilitychange", () => document.hidden && report());
  ask({ scored: lessons });
  post("SPLICE.getState", {});
}
