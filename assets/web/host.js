"use strict";

// In a frame of another page: what happens is told to that page, which may say where to go (docs/web.md).

const isGuest = () => root.classList.contains("embed") && window.parent !== window;

function tellHost(gjkscope, detail = {}) {
  if (isGuest()) window.parent.postMessage({ gjkscope, ...detail }, "*");
}

const shownStep = () => ({ step: state.index + 1, count: state.count, position: state.position, caption: state.caption });

/** A key that nothing here wants is the other page's. */
function passOn({ key, code, keyCode, shiftKey, ctrlKey, altKey, metaKey }) {
  if (key !== "Tab" && !ctrlKey && !altKey && !metaKey) tellHost("key", { key, code, keyCode, shiftKey });
}

tellHost("here");
document.addEventListener("keydown", (event) => root.dataset.live || passOn(event));
addEventListener("message", ({ source, data: said }) => {
  if (isGuest() && source === window.parent && said?.gjkscope === "follow") location.replace(`#${String(said.hash).replace(/^#/, "")}`);
});
