// Clipscope in a frame of another page: it leaves the page its focus and its wheel until someone clicks, and talks with it by messages.

/// Height of a frame that suits its width: a stage of 16 : 9, the caption and the transport.
const heightFor = (width) => Math.round(width * 0.45 + 100);

/// eframe takes the focus for a field of its own when it starts, from the page around as well: not in a frame.
export async function startUnfocused(start) {
  if (window.top === window) return start();
  const { focus } = HTMLElement.prototype;
  HTMLElement.prototype.focus = () => {};
  try {
    await start();
  } finally {
    HTMLElement.prototype.focus = focus;
  }
}

export function embed(canvas) {
  document.body.classList.add("embed");
  const leave = (event) => {
    if (document.activeElement !== canvas) event.stopImmediatePropagation();
  };
  addEventListener("wheel", leave, { capture: true, passive: true });
  canvas.addEventListener("pointerdown", () => canvas.focus({ preventScroll: true }), { capture: true });
  addEventListener("keydown", (event) => event.key === "Escape" && !document.fullscreenElement && canvas.blur(), { capture: true });
}

/// What the app tells goes to the page around, and what that asks comes to the app: from no one else.
export function talk() {
  const parent = window.parent;
  if (parent === window) return;
  const post = (message) => parent.postMessage(message, "*");
  addEventListener("clipscope-told", ({ detail }) => post({ clipscope: JSON.parse(detail) }));
  addEventListener("message", ({ source, data }) => {
    if (source === parent && data?.clipscope)
      dispatchEvent(new CustomEvent("clipscope-ask", { detail: JSON.stringify(data.clipscope) }));
  });
  post({ clipscope: { loaded: true } });
  post({ subject: "lti.frameResize", height: heightFor(innerWidth) });
}
