"use strict";

const MOTION_MS = 300;

let endMotion = () => {};

/** Moves the stage from what was shown to what is shown now; returns a function that ends the motion at once. */
function animate() {
  const start = performance.now();
  let frame = 0;
  let over = false;
  const end = () => {
    over = true;
    cancelAnimationFrame(frame);
    endMotion = () => {};
    putStage(state.stage);
  };
  const go = async (now) => {
    const share = Math.max(0, now - start) / MOTION_MS;
    if (share >= 1) return end();
    const between = await ask({ do: "tween", share });
    if (over) return;
    if (between?.stage) put($("stage"), between.stage, "img");
    frame = requestAnimationFrame(go);
  };
  frame = requestAnimationFrame(go);
  return end;
}
