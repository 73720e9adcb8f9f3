// Which keys are the app's, and which stay the browser's, while the canvas (or the field that eframe writes text with) has the focus.

/// These never reach the app: reload, address, tabs, windows, find, print, the browser's own zoom, full screen, tools.
const BROWSERS = {
  plain: ["F3", "F5", "F6", "F11", "F12"],
  held: ["f", "g", "j", "k", "l", "n", "p", "r", "t", "u", "w", "+", "-", "=", "0", "Tab", "F4"],
};
/// Of these the browser has a use, too: it is not to follow.
const OURS = {
  plain: ["PageUp", "PageDown", "Home", "End", "F1", "F2", "F7", "F8", "F9", "Insert"],
  held: ["d", "e", "m", "o", "s", "y", "z", "Enter", "Delete", "ArrowLeft", "ArrowRight", "PageUp", "PageDown"],
};

/// Copies a link; without Shift it is the browser's.
const copiesLink = ({ key, ctrlKey, metaKey, shiftKey }) => (ctrlKey || metaKey) && shiftKey && key.toLowerCase() === "l";

export function isBrowsers(event) {
  const { key, ctrlKey, metaKey } = event;
  if (copiesLink(event)) return false;
  return (ctrlKey || metaKey ? BROWSERS.held : BROWSERS.plain).includes(key.length === 1 ? key.toLowerCase() : key);
}

export function isOurs(event) {
  const { key, ctrlKey, metaKey } = event;
  if (copiesLink(event)) return true;
  return (ctrlKey || metaKey ? OURS.held : OURS.plain).includes(key.length === 1 ? key.toLowerCase() : key);
}

/// In the capture phase: before eframe's own listeners.
export function keepKeys(canvas) {
  const hasFocus = () => document.activeElement === canvas || document.activeElement?.tagName === "INPUT";
  for (const kind of ["keydown", "keyup"]) {
    const keep = (event) => {
      if (!hasFocus()) return;
      if (isBrowsers(event)) event.stopImmediatePropagation();
      else if (isOurs(event)) event.preventDefault();
    };
    addEventListener(kind, keep, { capture: true });
  }
}
