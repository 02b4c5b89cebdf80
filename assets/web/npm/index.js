
// The functions of the package. Above stand `compiled` and `instanceOf`, as pages have them.

const MODULE = new URL("{{module}}", import.meta.url);

async function bytesOfModule() {
  if (MODULE.protocol === "file:") return (await import("node:fs/promises")).readFile(MODULE);
  const answer = await fetch(MODULE);
  if (!answer.ok) throw new Error(`${MODULE} is not there`);
  return new Uint8Array(await answer.arrayBuffer());
}

let program = null;

async function answers(command, input, { name = "<stdin>", scalar = "double", method = "boxes" } = {}) {
  const text = typeof input === "string" ? input : JSON.stringify(input);
  program ??= bytesOfModule().then(compiled).then(instanceOf);
  let said;
  try {
    const { ask } = await program;
    said = JSON.parse(ask(JSON.stringify({ command, text, name, scalar, method })));
  } catch (error) {
    program = null;  // the next call starts another one
    throw error;
  }
  if (said.problem !== undefined) throw new Error(said.problem);
  return said;
}

/** The output of the command: `out` on standard output, `err` on standard error. */
export async function printed(command, input, options) {
  const { out, err } = await answers(command, input, options);
  return { out: out.join(""), err };
}

export async function solve(input, options) {
  return (await answers("solve", input, options)).out.map((text) => JSON.parse(text));
}

export async function trace(input, options) {
  const { out, err } = await answers("trace", input, options);
  if (!out.length) throw new Error(err.trimEnd());
  return out.map((text) => JSON.parse(text));
}

export async function judge(log, options) {
  const { out, err } = await answers("judge", log, options);
  if (!out.length) throw new Error(err.trimEnd());
  return JSON.parse(out[0]);
}
