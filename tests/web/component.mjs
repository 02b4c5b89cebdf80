// The package for npm, as somebody who has the document alone uses it: the pages are the examples of docs/web.md, the files those
// that `npm pack` packed, the hand a pointer and keys. Each test is a claim; the first thing that does not hold ends it.
// Usage: node component.mjs PACKAGE GJKSCOPE [--shots DIR] [--only WORD]
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

import { read, root } from "./program.mjs";
import { serve } from "./server.mjs";

const option = (name) => (process.argv.includes(name) ? process.argv[process.argv.indexOf(name) + 1] : null);
const [folder, command] = process.argv.slice(2, 4).map((path) => resolve(path));
const shots = option("--shots");
const only = option("--only") ?? "";
if (shots) mkdirSync(shots, { recursive: true });

// A project that has installed the package, and Reveal.js.
const host = mkdtempSync(join(tmpdir(), "gjkscope-package-"));
const installed = join(host, "node_modules", "gjkscope");
mkdirSync(installed, { recursive: true });
const pack = () => {
  const [{ filename }] = JSON.parse(execFileSync("npm", ["pack", "--json", "--pack-destination", host], { cwd: folder, encoding: "utf8" }));
  return join(host, filename);
};
const packed = pack();
execFileSync("tar", ["xzf", packed, "-C", installed, "--strip-components", "1"]);
symlinkSync(`${root}/tests/web/node_modules/reveal.js`, join(host, "node_modules", "reveal.js"));

const examples = [...read("docs/web.md").matchAll(/^```html\n([^]*?)^```$/gm)].map(([, text]) => text);
const plain = examples.find((text) => text.includes("addEventListener(\"step\""));
const deck = examples.find((text) => text.includes("reveal.js"));
const framed = examples.find((text) => text.includes("<iframe")).replace("site/", "node_modules/gjkscope/pages/");
const [, policy] = read("docs/web.md").match(/^ {4}Content-Security-Policy: (.*)$/m);
const page = (name, text) => writeFileSync(join(host, `${name}.html`), text);
const head = '<!doctype html><html lang="en"><meta charset="utf-8"><title>GJK</title><script type="module" src="node_modules/gjkscope/gjk-lesson.js"></script>';
page("plain", plain);
page("deck", deck);
page("framed", `<!doctype html><html lang="en"><meta charset="utf-8"><title>A frame</title>${framed}`);
page("far", `${head}<a id="before" href="#after">before</a><p style="height: 400vh">Above</p><gjk-lesson id="one" lesson="segment-regions"></gjk-lesson>
  <p style="height: 400vh">Between</p><gjk-lesson id="two" lesson="stop-vertex" step="3"></gjk-lesson><a id="after" href="#before">after</a>`);
page("box", `${head}<style>body { margin: 0; } gjk-lesson { width: 900px; height: 600px; }</style><gjk-lesson lesson="polygons-gjk" step="6"></gjk-lesson>`);
page("strict", `${head}<link rel="stylesheet" href="strict.css"><script type="module" src="strict.js"></script><h1>Strict</h1><gjk-lesson lesson="polygons-gjk" step="6"></gjk-lesson>`);
writeFileSync(join(host, "strict.css"), "gjk-lesson { width: 960px; height: 620px; }");
writeFileSync(join(host, "strict.js"), 'import * as functions from "./node_modules/gjkscope/index.js"; window.functions = functions;');

const server = await serve(host);
const strict = await serve(host, undefined, { "Content-Security-Policy": policy });
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
    "--disable-component-update", "--disable-sync"],
});

/** A page that must not complain, nor ask another server; it notes the elements' events. */
async function open(name, { from = server, width = 1280, height = 800, ...more } = {}) {
  const context = await browser.newContext({ viewport: { width, height }, ...more });
  const opened = await context.newPage();
  opened.complaints = [];
  opened.on("console", (message) => ["error", "warning"].includes(message.type()) && !message.location().url.endsWith("/favicon.ico") && opened.complaints.push(message.text()));
  opened.on("pageerror", (error) => opened.complaints.push(String(error)));
  opened.on("request", (request) => /^(data:|blob:)/.test(request.url()) || request.url().startsWith(from.address) || opened.complaints.push(`asks for ${request.url()}`));
  await opened.addInitScript(() => {
    window.told = [];
    for (const type of ["ready", "step", "answer", "problem"]) addEventListener(type, ({ detail }) => window.told.push({ type, ...detail }));
    addEventListener("keydown", ({ key }) => window.told.push({ type: "key", key }));
    addEventListener("securitypolicyviolation", (event) => console.error(`policy: ${event.violatedDirective} ${event.blockedURI}`));
  });
  await opened.goto(`${from.address}${name}.html`);
  return opened;
}
async function close(opened) {
  assert.deepEqual(opened.complaints, []);
  await opened.context().close();
}
async function until(holds, what) {
  const began = performance.now();
  while (!(await holds())) {
    assert.ok(performance.now() - began < 30000, `waited too long: ${what}`);
    await new Promise((done) => setTimeout(done, 20));
  }
}
const told = (opened, type) => opened.evaluate((wanted) => window.told.filter((each) => each.type === wanted), type);
const hears = (opened, type, count = 1) => until(async () => (await told(opened, type)).length >= count, `${count} ${type}`);
/** The page in the frame of an element, which is live. */
async function figure(opened, which = "gjk-lesson") {
  const element = opened.locator(which).first();
  const frame = await (await element.locator("iframe").elementHandle()).contentFrame();
  await frame.locator("html[data-ready]").waitFor({ state: "attached" });
  return frame;
}
const step = (opened, which = "gjk-lesson") => opened.locator(which).first().evaluate((element) => element.step);
const shows = (opened, number, which) => until(async () => (await step(opened, which)) === number, `step ${number}`);
const shoot = (opened, name) => shots && opened.screenshot({ path: join(shots, `${name}.png`) });

const tests = [];
const claim = (name, body) => tests.push({ name, body });

claim("npm pack makes the same file again, which has all that the document names", async () => {
  const before = readFileSync(packed);
  pack();
  assert.ok(before.equals(readFileSync(packed)));
  const { name, version, license, exports } = JSON.parse(readFileSync(join(installed, "package.json"), "utf8"));
  const [, project] = read("CMakeLists.txt").match(/project\(gjkscope VERSION ([\d.]+)/);
  assert.deepEqual([name, version, license], ["gjkscope", project, "MIT"]);
  const files = Object.values(exports).flatMap((entry) => (typeof entry === "string" ? [entry] : Object.values(entry)));
  for (const file of files.filter((each) => !each.includes("*"))) readFileSync(join(installed, file));
  assert.equal(readFileSync(join(installed, "LICENSE"), "utf8"), read("LICENSE"));
  const lessons = readdirSync(`${root}/lessons`).filter((file) => file.endsWith(".toml")).map((file) => file.replace(".toml", ".html"));
  assert.deepEqual(readdirSync(join(installed, "pages")).filter((file) => file.endsWith(".html")).sort(), [...lessons, "playground.html"].sort());
  const { size } = JSON.parse(execFileSync("npm", ["pack", "--json", "--dry-run"], { cwd: folder, encoding: "utf8" }))[0];
  console.log(`  ${size} bytes packed`);
});

claim("types name what the modules export, and nothing else", async () => {
  for (const name of ["index", "gjk-lesson"]) {
    const types = readFileSync(join(installed, `${name}.d.ts`), "utf8");
    const declared = [...types.matchAll(/^export (?:const|class|function) (\w+)/gm)].map(([, each]) => each);
    const script = readFileSync(join(installed, `${name}.js`), "utf8");
    const there = [...script.matchAll(/^export (?:const |class |async function |\{ )(\w+)/gm)].map(([, each]) => each);
    assert.deepEqual(declared.sort(), there.sort());
  }
});

claim("on a plain page two figures are live, each at its step; clicks, keys and events are their own", async () => {
  const opened = await open("plain", { height: 1400 });
  const [first, second] = [await figure(opened, "gjk-lesson >> nth=0"), await figure(opened, "gjk-lesson >> nth=1")];
  await hears(opened, "ready", 2);
  assert.equal(await step(opened, "gjk-lesson >> nth=0"), 12);
  assert.equal(await step(opened, "gjk-lesson >> nth=1"), 1);
  await shoot(opened, "plain");
  await second.click("#step");
  await shows(opened, 2, "gjk-lesson >> nth=1");
  await first.click("#back");
  await shows(opened, 11, "gjk-lesson >> nth=0");
  await opened.keyboard.press("ArrowLeft");
  await shows(opened, 10, "gjk-lesson >> nth=0");
  const steps = await told(opened, "step");
  assert.deepEqual(steps.map(({ lesson, step: at }) => [lesson, at]), [["polygon-evolution", 2], ["polygons-gjk", 11], ["polygons-gjk", 10]]);
  assert.equal(steps[2].caption, await first.textContent("#caption"));
  assert.equal(steps[2].count, await opened.locator("gjk-lesson >> nth=0").evaluate((element) => element.count));
  await close(opened);
});

claim("the keyboard goes in and out, and what a figure does not use is pressed in the page", async () => {
  const opened = await open("far");
  await opened.locator("#before").focus();
  assert.equal(await opened.locator("iframe").count(), 0);
  await opened.keyboard.press("Tab");
  await figure(opened, "#one");
  await hears(opened, "ready");
  await opened.keyboard.press("ArrowRight");
  await shows(opened, 2, "#one");
  assert.equal((await told(opened, "key")).length, 1, "the Tab");
  await opened.keyboard.press("ArrowLeft");
  await shows(opened, 1, "#one");
  await opened.keyboard.press("ArrowLeft");
  await opened.keyboard.press("b");
  await opened.keyboard.press("s");  // which turns a figure in space alone
  await until(async () => (await told(opened, "key")).length === 4, "three keys");
  assert.deepEqual((await told(opened, "key")).map(({ key }) => key), ["Tab", "ArrowLeft", "b", "s"]);
  const active = () => opened.evaluate(() => document.activeElement.id || document.activeElement.localName);
  assert.equal(await active(), "one");
  await opened.keyboard.press("Escape");
  await until(async () => (await active()) === "body", "the page has the keyboard again");
  await opened.locator("#one").focus();
  let presses = 0;
  while ((await active()) === "one" && presses < 80) {
    await opened.keyboard.press("Tab");
    ++presses;
  }
  assert.equal(await active(), "two");
  await figure(opened, "#two");
  await hears(opened, "ready", 2);
  for (presses = 0; (await active()) === "two" && presses < 80; ++presses) await opened.keyboard.press("Tab");
  assert.equal(await active(), "after");
  await close(opened);
});

claim("a figure starts when it comes near, and not before", async () => {
  const pages = () => server.asked.filter((name) => name.endsWith("segment-regions.html") || name.endsWith("stop-vertex.html"));
  server.asked.length = 0;
  const opened = await open("far");
  assert.equal(await opened.locator("#two").evaluate((element) => element.count), 0);
  await opened.waitForTimeout(500);
  assert.deepEqual(pages(), []);
  assert.ok(!server.asked.some((name) => name.endsWith(".gz")), "nor is the program asked for");
  await opened.mouse.wheel(0, 8000);
  await until(async () => (await opened.locator("#two iframe").count()) === 1, "the second starts");
  await figure(opened, "#two");
  await shows(opened, 3, "#two");
  await close(opened);
});

claim("an answer is told, by a key and by a click", async () => {
  const opened = await open("box");
  const frame = await figure(opened);
  const toQuestion = async () => {
    for (let i = 0; i < 30 && !(await frame.locator("#question").isVisible()); ++i) {
      const before = await step(opened);
      await opened.keyboard.press("ArrowRight");
      await until(async () => (await step(opened)) !== before, `a step after ${before}`);
    }
  };
  await opened.locator("gjk-lesson").evaluate((element) => { Object.assign(element, { step: 1, ask: true }); element.focus(); });
  await hears(opened, "step");
  await until(() => frame.evaluate(() => state.predicting && !sent && !waiting.length), "it asks");
  await toQuestion();
  await shoot(opened, "question");
  await opened.keyboard.press("1");
  if (await frame.locator("#choices fieldset").count()) await opened.keyboard.press("1");
  await hears(opened, "answer");
  await toQuestion();
  await frame.locator("#choices button").first().click();
  if (await frame.locator("#choices fieldset").count()) await frame.locator("#choices fieldset").nth(1).locator("button").first().click();
  await hears(opened, "answer", 2);
  const answers = await told(opened, "answer");
  answers.forEach(({ lesson, chosen, answer, right, asked, correct }, i) => {
    assert.equal(lesson, "polygons-gjk");
    assert.equal(right, chosen === answer);
    assert.equal(asked, i + 1);
    assert.equal(correct, answers.slice(0, i + 1).filter((each) => each.right).length);
  });
  await close(opened);
});

claim("the box gives the size: stage, buttons and words are in it", async () => {
  const opened = await open("box", { width: 1700, height: 1200 });
  const frame = await figure(opened);
  for (const [width, height] of [[900, 600], [1600, 900], [1240, 620], [960, 540], [640, 480], [640, 560], [500, 700], [360, 640], [700, 360]]) {
    await opened.locator("gjk-lesson").evaluate((element, size) => Object.assign(element.style, size), { width: `${width}px`, height: `${height}px` });
    const boxes = () => frame.evaluate(() => Object.fromEntries(["stage", "step", "caption"].map((id) => {
      const { left, top, right, bottom } = document.getElementById(id).getBoundingClientRect();
      return [id, { left, top, right, bottom }];
    })));
    const fits = async () => Object.values(await boxes()).every((box) => box.left >= 0 && box.right <= width && box.top >= 0 && box.bottom <= height && box.bottom > box.top);
    await until(() => frame.evaluate((wanted) => innerWidth === wanted[0] && innerHeight === wanted[1], [width, height]), "the size");
    await frame.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    await until(() => frame.evaluate(() => !sent && !waiting.length), "the layout");
    await shoot(opened, `box-${width}x${height}`);
    await until(fits, `${width}x${height}: ${JSON.stringify(await boxes())}`);
    const { stage } = await boxes();
    assert.ok(stage.bottom - stage.top >= 0.35 * height, `${width}x${height}: the stage is ${stage.bottom - stage.top} high`);
    assert.equal(await frame.evaluate(() => document.documentElement.scrollWidth), width);
  }
  await close(opened);
});

claim("attributes go where they say: step, theme, another lesson; a move keeps the step; an unknown lesson is a problem", async () => {
  const opened = await open("box");
  const element = opened.locator("gjk-lesson");
  const frame = await figure(opened);
  await element.evaluate((each) => each.setAttribute("step", "4"));
  await shows(opened, 4);
  await frame.locator("#count", { hasText: "4 / " }).waitFor();
  await element.evaluate((each) => { each.step += 2; });
  await frame.locator("#count", { hasText: "6 / " }).waitFor();
  await element.evaluate((each) => { each.theme = "dark"; });
  await frame.locator('html[data-theme="dark"]').waitFor();
  await shoot(opened, "dark");
  await element.evaluate((each) => { each.theme = "auto"; });
  await frame.locator('html[data-theme="light"]').waitFor();
  await opened.emulateMedia({ colorScheme: "dark" });
  await frame.locator('html[data-theme="dark"]').waitFor();
  await frame.click("#step");
  await shows(opened, 7);
  await element.evaluate((each) => document.body.append(document.createElement("p"), each));
  await hears(opened, "ready", 2);
  assert.equal((await told(opened, "ready"))[1].step, 7);
  await element.evaluate((each) => { each.lesson = "playground"; });
  await hears(opened, "ready", 3);
  assert.equal((await told(opened, "ready"))[2].lesson, "playground");
  await element.evaluate((each) => { each.lesson = "polygon-gjk"; });
  await hears(opened, "problem");
  assert.equal(await opened.getByRole("alert").textContent(), "There is no lesson “polygon-gjk” here.");
  await element.evaluate((each) => each.remove());
  await close(opened);
});

claim("a figure that starts late or dark shows no first frame of its own before", async () => {
  const opened = await open("box");
  await opened.evaluate(() => document.querySelector("gjk-lesson").remove());
  let goOn = null;
  const arrived = new Promise((done) => { goOn = done; });
  await opened.route("**/*.wasm.gz*", async (route) => (await arrived, route.continue()));
  await opened.evaluate(() => document.body.append(Object.assign(document.createElement("gjk-lesson"), { lesson: "stop-vertex", theme: "dark" }),
    Object.assign(document.createElement("gjk-lesson"), { lesson: "stop-vertex", theme: "light" })));
  for (const [at, visible] of [[0, false], [1, true]]) {
    const frame = await (await opened.locator("iframe").nth(at).elementHandle()).contentFrame();
    await frame.locator("#whole").waitFor({ state: "attached" });
    await frame.locator("#stage svg >> nth=0").waitFor({ state: "attached" });
    await frame.waitForLoadState();
    assert.equal(await frame.locator("#caption").isVisible(), visible);
  }
  await shoot(opened, "waiting");
  goOn();
  await hears(opened, "ready", 2);
  await close(opened);
});

claim("in a deck of Reveal.js keys step the figure, and turn slides where it has no use for them", async () => {
  const opened = await open("deck");
  const slide = () => opened.evaluate(() => window.Reveal.getIndices().h);
  const at = (number) => until(async () => (await slide()) === number, `slide ${number}`);
  await at(0);
  assert.equal(await opened.locator("iframe").count(), 0, "a slide that is not shown does not start");
  await opened.keyboard.press("ArrowRight");
  await at(1);
  const frame = await figure(opened);
  await hears(opened, "ready");
  await opened.waitForTimeout(900);  // the slide has come
  await shoot(opened, "deck");
  const count = await opened.locator("gjk-lesson").evaluate((element) => element.count);
  for (let number = 13; number <= count; ++number) {
    if (await frame.locator("#question").isVisible()) {
      const lists = await frame.locator("#choices fieldset").count();
      for (let i = 0; i < Math.max(1, lists); ++i) await opened.keyboard.press("1");
    } else {
      await opened.keyboard.press("ArrowRight");
    }
    await shows(opened, number);
  }
  await opened.keyboard.press("ArrowRight");
  await at(2);
  await opened.waitForTimeout(900);
  await opened.keyboard.press("PageUp");
  await at(1);
  await opened.waitForTimeout(900);
  await opened.keyboard.press("ArrowLeft");
  await shows(opened, count - 1);
  const corner = frame.locator('#stage circle[data-of="x 0"]').first();
  const before = await frame.evaluate(() => state.changed);
  await opened.waitForTimeout(400);  // motion is over
  const box = await corner.boundingBox();
  await opened.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await opened.mouse.down();
  await opened.mouse.move(box.x - 20, box.y + 20, { steps: 4 });
  await opened.mouse.up();
  await until(() => frame.evaluate(() => state.changed), "the drag is done in a slide that is scaled");
  assert.equal(before, false);
  await opened.keyboard.press("PageDown");
  await at(2);
  await close(opened);
});

claim("under the strict policy of the document a page with a figure and functions runs, and nothing is refused", async () => {
  const opened = await open("strict", { from: strict });
  const frame = await figure(opened);
  await hears(opened, "ready");
  await shows(opened, 6);
  await frame.click("#step");
  await shows(opened, 7);
  await frame.locator('#stage circle[data-of="x 0"]').first().hover();
  await frame.evaluate(() => new Promise((done) => setTimeout(done, 300)));
  const fonts = await frame.evaluate(() => [...document.fonts].filter((face) => face.status === "loaded").map((face) => face.family));
  assert.ok(fonts.some((family) => family.includes("Inter")), fonts.join());
  await shoot(opened, "strict");
  assert.equal(await opened.evaluate(async () => (await window.functions.solve({ a: [[0, 0]], b: [[3, 4]] }))[0].distance), 5);
  await close(opened);
});

claim("a policy that forbids frames is named in the element", async () => {
  const forbidding = await serve(host, undefined, { "Content-Security-Policy": `${policy}; frame-src 'none'` });
  const context = await browser.newContext();
  const opened = await context.newPage();
  await opened.goto(`${forbidding.address}strict.html`);
  await opened.getByRole("alert").waitFor();
  assert.match(await opened.getByRole("alert").textContent(), /policy/);
  await context.close();
  forbidding.close();
});

claim("the frame of the document is a figure at its step", async () => {
  const opened = await open("framed");
  const frame = await (await opened.locator("iframe").elementHandle()).contentFrame();
  await frame.locator("html.embed[data-ready]").waitFor({ state: "attached" });
  await frame.locator("#count", { hasText: "12 / " }).waitFor();
  await close(opened);
});

// The functions -----------------------------------------------------------------------------------

const hard = readdirSync(`${root}/tests/hard-cases`).filter((_, i) => i % 4 === 0).map((file) => `tests/hard-cases/${file}`);
const forms = readdirSync(`${root}/tests/fuzz/solve`).map((file) => `tests/fuzz/solve/${file}`);
const logs = readdirSync(`${root}/tests/fuzz/log`).map((file) => `tests/fuzz/log/${file}`);
const SCALARS = ["half", "float", "double", "exact"];
const outlines = '{"outlines_a":[[[0,0],[4,0],[4,4],[2,1],[0,4]]],"outlines_b":[[[2,3],[3,4],[1,4]]]}';
const box = '{"outlines_a":[[[0,0],[4,0],[4,4],[0,4]]],"outlines_b":[[[6,3],[7,4],[5,9]]]}';
const right = read("tests/fuzz/log/right.jsonl");
const wrong = right.replace("1.5811388300841898", "3");
const changes = [["1.5811388300841898", "1.58"], ["1.5811388300841898", "1e-300"], ['"overlap":false', '"overlap":true'], ['"support":[1,2]', '"support":[0,0]'],
  ["[-3,0]", "[3,0.1]"], ['"weights":[1]', '"weights":[2]'], ['"scalar":"double"', '"scalar":"half"'], ['"b":[2.5,1.5]', '"b":["nan",1.5]'], [/\n[^\n]*\n$/, "\n"], [/"[^"]*$/, ""]];
const questions = [
  ...[...hard, ...forms].flatMap((file, i) => ["solve", "trace"].map((what) => [what, read(file), { scalar: SCALARS[i % 4] }])),
  ...["brute", "pieces", "boxes", "circles"].map((method) => ["solve", outlines, { method }]),
  ...["pieces", "boxes", "circles"].map((method) => ["trace", outlines, { method }]),
  ...["solve", "trace"].map((what) => [what, box, { method: "lin-canny" }]),
  ["solve", "no case", {}], ["trace", "no case", {}], ["solve", '{"name":"é\u{1f600}","a":[[1e308,0]],"b":[[-1e308,0]]}', {}], ["solve", '{"a":[[0.1,"0x1p-3"]],"b":[[-0.0,5e-324]]}', {}],
  ...["polygons-gjk", "penetration-depth", "hierarchy-distance"].filter((id) => readdirSync(`${root}/lessons`).includes(`${id}.toml`))
    .map((id) => ["trace", read(`lessons/${id}.toml`), { name: `lessons/${id}.toml` }]),
  ...logs.map((file) => ["judge", read(file), {}]),
  ...changes.map((change) => ["judge", right.replace(...change), {}]),
  ["judge", "", {}], ["judge", "{", {}], ["judge", wrong.split("\n")[0], {}],
];
/** The output of the command. */
function said([what, text, { scalar, method, name }]) {
  const args = [what, name ?? "-", ...(scalar ? ["--scalar", scalar] : []), ...(method ? ["--method", method] : []), ...(what === "solve" ? [] : ["--json"])];
  const { stdout, stderr } = spawnSync(command, args, { input: text, cwd: root, encoding: "utf8", maxBuffer: 1 << 28 });
  return { out: stdout, err: stderr };
}
const expected = questions.map(said);
const counted = (what) => questions.filter((question, i) => question[0] === what && expected[i].out).length;
for (const what of ["solve", "trace", "judge"]) assert.ok(counted(what) >= 12, `${counted(what)} answers of ${what}`);

/** Text that is printed is what the command prints; objects are what it says. */
async function compared(functions) {
  for (const [i, question] of questions.entries()) {
    const [what, text, options] = question;
    const about = `${question[0]} ${text.slice(0, 80)} ${JSON.stringify(options)}`;
    assert.deepEqual(await functions.printed(what, text, options), expected[i], about);
  }
}

claim("in node solve, trace and judge answer what the command prints, byte for byte", async () => {
  const functions = await import(pathToFileURL(join(installed, "index.js")).href);
  await compared(functions);
  const [answer] = await functions.solve({ a: [[0, 0]], b: [[3, 4]] });
  assert.deepEqual(answer, JSON.parse(said(["solve", '{"a":[[0,0]],"b":[[3,4]]}', {}]).out));
  const [run] = await functions.trace({ a: [[0, 0]], b: [[3, 4]] }, { scalar: "exact" });
  assert.deepEqual(run, JSON.parse(said(["trace", '{"a":[[0,0]],"b":[[3,4]]}', { scalar: "exact" }]).out));
  assert.equal((await functions.judge(wrong)).right, false);
  await assert.rejects(functions.judge("{"), { message: said(["judge", "{", {}]).err.trimEnd() });
  await assert.rejects(functions.trace("no case"), { message: said(["trace", "no case", {}]).err.trimEnd() });
  await assert.rejects(functions.solve("", { scalar: "quad" }), /there is no scalar 'quad'/);
  await assert.rejects(functions.trace(outlines, { method: "brute" }), /no trace/);
});

claim("in Chromium they do so, too", async () => {
  const opened = await open("strict", { from: strict });
  await until(() => opened.evaluate(() => Boolean(window.functions)), "the functions");
  await compared({ printed: (...question) => opened.evaluate((all) => window.functions.printed(...all), question) });
  await figure(opened);
  await close(opened);
});

let failed = 0;
const chosen = tests.filter(({ name }) => name.includes(only));
for (const { name, body } of chosen) {
  const began = performance.now();
  try {
    await body();
    console.log(`ok ${name} (${((performance.now() - began) / 1000).toFixed(1)} s)`);
  } catch (error) {
    ++failed;
    console.log(`FAILED ${name}\n${error.stack}`);
  }
}
await browser.close();
server.close();
strict.close();
rmSync(host, { recursive: true });
console.log(`${chosen.length - failed} passed, ${failed} failed`);
process.exit(failed ? 1 : 0);
