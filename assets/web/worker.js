"use strict";

// The program in a thread of its own: a text in, a text out. The first message starts it and is
// answered by the compiled module, so that another thread starts without compiling.

let answer = null;

onmessage = async ({ data }) => {
  try {
    if (answer) {
      postMessage(answer(data));
      return;
    }
    const { wasm, fonts, assets } = data;
    const module = data.module ?? await compiled(typeof wasm === "string" ? bytesOf(wasm) : wasm);
    answer = await startPlayerWith(module, fonts, assets);
    postMessage({ module });
  } catch (error) {
    postMessage({ stopped: error.message });
  }
};
