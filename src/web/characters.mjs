// Prints the characters that the fonts of a page must have. Usage: node characters.mjs gjkscope.wasm
import { readFileSync } from "node:fs";

const nothing = () => 0;
const anything = new Proxy({}, { get: () => nothing });
const { instance } = await WebAssembly.instantiate(readFileSync(process.argv[2]), {
  env: anything,
  wasi_snapshot_preview1: anything,
});
const program = instance.exports;
program._initialize();
const size = program.gjk_characters();
process.stdout.write(new Uint8Array(program.memory.buffer, program.gjk_said(), size));
