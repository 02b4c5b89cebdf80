"use strict";

/** A compiled module, of its bytes, which a server or a browser may have unpacked. */
async function compiled(bytes) {
  const gzip = 0x1f;
  return WebAssembly.compile(bytes[0] === gzip ? await through(new DecompressionStream("gzip"), bytes) : bytes);
}

/**
 * The program: an instance of a compiled module, without files and without a network. `ask` is a function from request to
 * answer, both texts (docs/web.md); `lend` calls a function with bytes.
 */
async function instanceOf(module) {
  let memory = null;
  const done = () => 0;
  const view = () => new DataView(memory.buffer);
  const wasi = {
    clock_time_get: (id, precision, at) => {
      view().setBigUint64(at, BigInt(Math.round(performance.now() * 1e6)), true);
      return 0;
    },
    environ_sizes_get: (count, size) => {
      view().setUint32(count, 0, true);
      view().setUint32(size, 0, true);
      return 0;
    },
    environ_get: done,
    fd_close: done,
    fd_read: done,
    fd_seek: done,
    // The last words of a program that gives up go nowhere; the trap that follows is seen.
    fd_write: (file, parts, count, written) => {
      let size = 0;
      for (let i = 0; i < count; ++i) size += view().getUint32(parts + 8 * i + 4, true);
      view().setUint32(written, size, true);
      return 0;
    },
    proc_exit: (code) => {
      throw new Error(`the program ended with ${code}`);
    },
  };
  const noSuchFile = -44;
  const env = { emscripten_notify_memory_growth: done, __syscall_stat64: () => noSuchFile };
  const imports = { env, wasi_snapshot_preview1: wasi };
  const instance = await WebAssembly.instantiate(module, imports);
  const program = instance.exports;
  memory = program.memory;
  program._initialize();

  const lend = (bytes, use) => {
    const at = program.gjk_alloc(bytes.length);
    new Uint8Array(memory.buffer).set(bytes, at);
    try {
      return use(at, bytes.length);
    } finally {
      program.gjk_free(at);
    }
  };
  const read = new TextDecoder();
  const ask = (request) => {
    const size = lend(encoded(request), program.gjk_ask);
    return read.decode(new Uint8Array(memory.buffer, program.gjk_said(), size));
  };
  return { program, lend, ask };
}

const encoded = (text) => new TextEncoder().encode(text);

/**
 * A program that knows lessons, too. `fonts` are those of the six faces, regular first, then their fallbacks; `assets` has
 * `themes`, texts by name, and `terms`. Returns what asks it.
 */
async function startPlayer(module, fonts, fallbacks, assets) {
  const { program, lend, ask } = await instanceOf(module);
  fonts.forEach((bytes, face) => {
    lend(bytes, (at, size) => program.gjk_font(face, 0, at, size));
    lend(fallbacks[face], (at, size) => program.gjk_font(face, 1, at, size));
  });
  if (!lend(encoded(JSON.stringify(assets)), program.gjk_start))
    throw new Error("the page's fonts, themes or terms are damaged");
  return ask;
}

/** The fonts of a style sheet that holds them as data, in its order. */
function fontsIn(css) {
  return [...css.matchAll(/base64,([^)"]+)/g)].map((found) => bytesOf(found[1]));
}

/** For each of the six faces, which of the fallbacks it has. */
const FALLBACK_OF_FACE = [0, 0, 1, 1, 2, 3];

/** `startPlayer` with the fonts of a style sheet. */
function startPlayerWith(module, css, assets) {
  const files = fontsIn(css);
  const fallbacks = FALLBACK_OF_FACE.map((i) => files[6 + i]);
  return startPlayer(module, files.slice(0, 6), fallbacks, assets);
}
