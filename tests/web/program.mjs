// The page's program without a page: the same script, the same fonts.
import { readFileSync } from "node:fs";
import { gunzipSync } from "node:zlib";

export const root = new URL("../..", import.meta.url).pathname;
export const read = (path) => readFileSync(`${root}/${path}`, "utf8");

const themes = Object.fromEntries(
  ["light", "dark", "high-contrast", "print"].map((name) => [name, read(`assets/themes/${name}.toml`)]));
const assets = { themes, terms: read("assets/terms.toml") };

/** A function from request to answer, plain objects. */
export async function startProgram() {
  const start = new Function(`${read("assets/web/bytes.js")}; ${read("assets/web/player.js")}; return startPlayerWith;`)();
  const wasm = gunzipSync(readFileSync(`${root}/build/wasm/web/gjkscope.wasm.gz`));
  const answer = await start(await WebAssembly.compile(wasm), read("build/wasm/web/fonts.css"), assets);
  return (request) => JSON.parse(answer(JSON.stringify(request)));
}
