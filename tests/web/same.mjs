// The program for browsers answers, byte for byte, as a native one does: pictures,
// words, hex floats and traces of all lessons and the hard cases.
// Usage: node same.mjs NATIVE_PLAYER GJKSCOPE
import { execFileSync } from "node:child_process";
import { readdirSync } from "node:fs";

import { read, root, startProgram } from "./program.mjs";

const [nativePlayer, command] = process.argv.slice(2);
const layouts = [
  { do: "layout", width: 344, height: 592, panel: 344, timeline: 344, theme: "dark" },
  { do: "layout", width: 900, height: 450, panel: 384, timeline: 900, theme: "light" },
];

const counting = await startProgram();
const requests = [];
const ask = (request) => requests.push(request);
const lessons = readdirSync(`${root}/lessons`).filter((name) => name.endsWith(".toml"));
for (const file of lessons) {
  const files = { "accuracy-cost.json": read("lessons/accuracy-cost.json") };
  ask({ do: "open", lesson: read(`lessons/${file}`), name: file, files });
  const { count } = counting(requests.at(-1));
  ask({ do: "trace" });
  for (const layout of layouts) {
    ask(layout);
    ask({ do: "go", to: 0 });
    for (let step = 1; step < count; ++step) ask({ do: "step", by: 1 });
  }
  ask({ do: "frame" });
  ask({ do: "go", to: 1 });
  ask({ do: "go", to: 2 });
  ask({ do: "tween", share: 0.4 });
  ask({ do: "press", x: 300, y: 200 });
  ask({ do: "move", x: 333.3, y: 222.2 });
  ask({ do: "release" });
  for (const language of ["cpp", "python"]) ask({ do: "listing", language });
  ask({ do: "code" });
  ask({ do: "predict", on: true });
  ask({ do: "step", by: 5 });
  ask({ do: "print" });
  ask({ do: "lesson" });
  const kept = (id) => ({ id, change: "move a vertex", lesson: read(`lessons/${file}`) });
  ask({ do: "restore", name: file, past: [kept(1)], now: kept(2), future: [], to: 2, predicting: false });
  ask({ do: "undo" });
}
ask({ do: "open", lesson: read("assets/web/playground.toml"), name: "playground.toml" });
// A press in a shape selects it, a drag of its handle turns it.
const trial = await startProgram();
trial(requests.at(-1));
const drawn = trial(layouts[1]).stage;
const corners = [...drawn.matchAll(/<circle cx="([\d.]+)" cy="([\d.]+)"[^>]*data-of="y \d+"/g)];
const middle = (i) => corners.reduce((sum, corner) => sum + Number(corner[i]), 0) / corners.length;
const pressed = { do: "press", x: middle(1), y: middle(2) };
const [, cx, cy] = trial(pressed).stage.match(/<circle cx="([\d.]+)" cy="([\d.]+)"[^>]*data-mark="handle"/);
const [x, y] = [Number(cx), Number(cy)];
ask(layouts[1]);
ask(pressed);
ask({ do: "release" });
ask({ do: "press", x, y });
for (let i = 1; i <= 10; ++i) ask({ do: "move", x: x + 7.3 * i, y: y + 4.1 * i });
ask({ do: "move", x: x + 90, y: y + 90, snaps: true });
ask({ do: "release" });
ask({ do: "lesson" });
for (const chapter of [1, 2, 3, 4, 5, 9]) {
  for (const answers of [[], [true, false, true, false, false]]) {
    ask({ do: "practise", chapter, seed: 7, answers });
    ask({ do: "task" });
    ask({ do: "trace" });
  }
}
ask({ do: "open", lesson: read("assets/web/playground.toml"), name: "playground.toml" });
const cases = readdirSync(`${root}/tests/hard-cases`);
for (const file of cases) {
  const text = read(`tests/hard-cases/${file}`);
  for (const scalar of ["half", "float", "double", "exact"]) ask({ command: "trace", text, name: file, scalar, method: "boxes" });
  ask({ do: "case", text, name: file });
}
for (const file of readdirSync(`${root}/tests/fuzz/solve`).filter((name) => !name.endsWith(".json"))) {
  const text = read(`tests/fuzz/solve/${file}`);
  ask({ command: "trace", text, name: file, scalar: "double", method: "boxes" });
  ask({ do: "case", text, name: file });
}

const program = await startProgram();
const began = performance.now();
const answers = requests.map((request) => program(request));
const time = performance.now() - began;
const lines = execFileSync(nativePlayer, [`${root}/assets`], {
  input: requests.map((request) => JSON.stringify(request)).join("\n"),
  maxBuffer: 1 << 30,
  encoding: "utf8",
}).trimEnd().split("\n");

let different = 0;
let traces = 0;
let pictures = 0;
let problems = 0;
requests.forEach((request, i) => {
  const here = JSON.stringify(answers[i]);
  const there = JSON.stringify(JSON.parse(lines[i]));
  traces += answers[i].trace ? 1 : (answers[i].out?.length ?? 0);
  if (answers[i].stage ?? answers[i].svg) ++pictures;
  if (answers[i].problem) ++problems;
  if (here === there) return;
  if (++different > 5) return;
  let at = 0;
  while (here[at] === there[at]) ++at;
  const told = { ...request, lesson: undefined, files: undefined };
  console.error(`request ${i}, ${JSON.stringify(told).slice(0, 200)}:
  browser ${here.slice(Math.max(0, at - 80), at + 80)}
  native  ${there.slice(Math.max(0, at - 80), at + 80)}`);
});

// The traces are those that the command prints.
let printed = 0;
for (const file of cases) {
  const path = `tests/hard-cases/${file}`;
  const here = program({ command: "trace", text: read(path), name: path, scalar: "double", method: "boxes" });
  const said = execFileSync(command, ["trace", path, "--json"], { cwd: root, encoding: "utf8" });
  if (here.out.join("") === said) ++printed;
  else console.error(`${path}: the trace is not the one that the command prints`);
}
console.log(`${requests.length} answers compared: ${pictures} pictures, ${traces} traces, ${problems} refusals; ` +
  `${different} differ; ${(time / requests.length).toFixed(2)} ms each`);
const expected = lessons.length + 4 * cases.length;
if (different || printed !== cases.length || traces < expected || pictures < 2000) {
  console.error(`expected no difference, ${expected} traces and 2000 pictures or more, and ${cases.length} traces as printed: ${printed} were`);
  process.exit(1);
}
