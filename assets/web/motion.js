"use strict";

const MOTION_MS = 300;

/** Moves the stage from what was shown to what is shown now; returns a function that ends the motion at once. */
function animate() {
  const start = performance.now();
  let frame = 0;
  const end = () => {
    cancelAnimationFrame(frame);
    put($("stage"), state.stage, "img");
  };
  const go = (now) => {
    const share = Math.max(0, now - start) / MOTION_MS;
    if (share >= 1) return end();
    put($("stage"), ask({ do: "tween", share }).stage, "img");
    frame = requestAnimationFrame(go);
  };
  go(start);
  return end;
}
