"use strict";

const MOTION_MS = 300;

/** Moves the stage from what was shown to what is shown now; returns a function that ends the motion at once. */
function animate() {
  const start = performance.now();
  let frame = 0;
  const end = () => {
    cancelAnimationFrame(frame);
    putStage(state.stage);
  };
  const go = (now) => {
    const share = Math.max(0, now - start) / MOTION_MS;
    if (share >= 1) return end();
    putStage(ask({ do: "tween", share }).stage);
    frame = requestAnimationFrame(go);
  };
  go(start);
  return end;
}
