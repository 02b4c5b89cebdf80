// The pages in a real browser, by pointer, touch and keys. Each test is a claim; the first thing
// that does not hold ends it. An action is tried at one size, on a phone, a laptop or a projector in turn, in
// themes that change from action to action; of claims about every page one lesson in sixteen is opened,
// and of claims about windows or themes each lesson is tried in every second. With --all, an action is
// tried at each size in each theme, and every page is opened, in every window and theme.
// Usage: node browser.mjs SITE [--shots DIR] [--only WORD] [--all]
// Pages that need no other file are made by the program that $GJKSCOPE names, or that is built here.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { copyFileSync, existsSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { deflateRawSync, inflateRawSync } from "node:zlib";
import { chromium } from "playwright-core";

import { read, root, startProgram } from "./program.mjs";
import { serve } from "./server.mjs";

const option = (name) => (process.argv.includes(name) ? process.argv[process.argv.indexOf(name) + 1] : null);
const site = resolve(process.argv[2]);
const shots = option("--shots");
const only = option("--only") ?? "";
if (shots) mkdirSync(shots, { recursive: true });

const SIZES = {
  phone: { width: 360, height: 740, touch: true },
  laptop: { width: 1280, height: 800 },
  projector: { width: 1920, height: 1080 },
};
const THEMES = ["light", "dark", "high-contrast", "print"];
const pages = readdirSync(site).filter((name) => name.endsWith(".html"));
const isLesson = (name) => !["index.html", "about.html", "playground.html", "practice.html"].includes(name);
const everything = process.argv.includes("--all");
const opened = everything ? pages : pages.filter((name, i) => !isLesson(name) || i % 16 === 0);
/** Every second one, the others for the next lesson. */
const everySecond = (list, lesson) => list.filter((_, i) => everything || i % 2 === lesson % 2);
const url = (name, hash = "") => pathToFileURL(join(site, `${name}.html`)).href + hash;

const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
    "--disable-component-update", "--disable-sync"],
});
const failures = [];

/** The page is live; else what it says instead. */
async function ready(page) {
  try {
    await page.locator("html[data-ready]").waitFor({ state: "attached", timeout: 120000 });
  } catch (error) {
    const said = await page.locator("#problem, #hint").allTextContents();
    throw new Error(`${page.url()} is not live; it says ${JSON.stringify(said)}, its console ${JSON.stringify(page.complaints ?? [])}`, { cause: error });
  }
}

/** A page that must not complain, nor ask for anything but what its site shares. */
async function open(address, size = "laptop", { theme, waits = true, init, ...more } = {}) {
  const { width, height, touch } = SIZES[size];
  const context = await browser.newContext({ viewport: { width, height }, hasTouch: Boolean(touch), acceptDownloads: true, ...more });
  const page = await context.newPage();
  page.complaints = [];
  page.on("console", (message) => message.type() === "error" && page.complaints.push(message.text()));
  page.on("pageerror", (error) => page.complaints.push(String(error)));
  page.on("request", (request) => {
    const shared = ["shared/", "cards/"].some((folder) => request.url().startsWith(new URL(folder, address).href));
    if (!/^(data:|blob:)/.test(request.url()) && !request.isNavigationRequest() && !shared) page.complaints.push(`asks for ${request.url()}`);
  });
  if (theme) await page.addInitScript((name) => localStorage.setItem("gjkscope-theme", name), theme);
  if (init) await page.addInitScript(init);
  await page.goto(address);
  if (waits && more.javaScriptEnabled !== false && (await page.locator("#wasm").count()))
    await ready(page);
  if (theme) assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), theme);
  return page;
}

async function close(page) {
  assert.deepEqual(page.complaints, []);
  await page.context().close();
}

const tests = [];
/** One that is `alone` measures time, uses the clipboard, or takes so long that others would hold it up: nothing runs beside it. */
const claim = (name, body, alone = false) => tests.push({ name, body, alone });
let actions = 0;
/**
 * What a hand does: `body` gets how to open a page at a size and in a theme. Each action starts with
 * the next theme, and takes a phone or one of the larger sizes in turn.
 */
function action(name, body, { sizes = Object.keys(SIZES), alone = false } = {}) {
  const pairs = everything
    ? sizes.flatMap((size) => THEMES.map((theme) => [size, theme]))
    : sizes.filter((size) => size !== (actions % 2 ? "laptop" : "projector") || sizes.length === 1)
      .map((size, i) => [size, THEMES[(i + (actions >> 1)) % THEMES.length]])
      .filter((_, i, both) => i === (actions >> 1) % both.length);
  ++actions;
  for (const [size, theme] of pairs)
    claim(`${size}, ${theme}: ${name}`, () => body((address, at = size) => open(address, at, { theme }), size, theme), alone);
}
/** `holds` in the page; the driver's own way of waiting needs an eval, which pages forbid. */
async function until(page, holds) {
  const began = performance.now();
  for (let pause = 1; !(await page.evaluate(holds)); pause = Math.min(50, 2 * pause)) {
    assert.ok(performance.now() - began < 60000, `waited too long for ${holds}`);
    await new Promise((done) => setTimeout(done, pause));
  }
}
/** All that the page asked its program for is shown. */
async function rest(page) {
  for (let i = 0; i < 2; ++i) await until(page, () => typeof waiting === "undefined" || (!sent && !waiting.length));
}
/** After all that was asked for is shown. */
const text = async (page, id) => (await rest(page), page.locator(`#${id}`).textContent());
const count = async (page) => (await text(page, "count")).split(" / ").map(Number);
/** Motion is over. */
const settle = (page) => page.waitForTimeout(350);

/** The page has heard that its size changed. */
const twoFrames = async (page) => {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  await rest(page);
};

/** The middle of a vertex on the screen. */
async function vertex(page, of) {
  await rest(page);
  const box = await page.locator(`#stage circle[data-of="${of}"]`).first().boundingBox();
  return [box.x + box.width / 2, box.y + box.height / 2];
}

/** To where no bar lies over it. */
const toMiddle = (page, of) =>
  page.locator(`#stage circle[data-of="${of}"]`).first().evaluate((mark) => mark.scrollIntoView({ block: "center" }));

async function dragByMouse(page, from, by) {
  await page.mouse.move(...from);
  await page.mouse.down();
  for (let i = 1; i <= 5; ++i) await page.mouse.move(from[0] + by[0] * i / 5, from[1] + by[1] * i / 5);
  await page.mouse.up();
}

async function touchPath(page, from, by) {
  const client = await page.context().newCDPSession(page);
  const send = (type, points) => client.send("Input.dispatchTouchEvent", { type, touchPoints: points });
  await send("touchStart", [{ x: from[0], y: from[1] }]);
  for (let i = 1; i <= 6; ++i) await send("touchMove", [{ x: from[0] + by[0] * i / 6, y: from[1] + by[1] * i / 6 }]);
  await send("touchEnd", []);
}

/** One finger at a place, the other 80 pixels to its right, both moved. */
async function twoFingers(page, [x, y], [dx, dy]) {
  const client = await page.context().newCDPSession(page);
  const send = (type, touchPoints) => client.send("Input.dispatchTouchEvent", { type, touchPoints });
  const both = (share) => [0, 80].map((beside, id) => ({ id, x: x + beside + share * dx, y: y + share * dy }));
  await send("touchStart", both(0).slice(0, 1));
  await send("touchStart", both(0));
  for (let i = 1; i <= 6; ++i) await send("touchMove", both(i / 6));
  await send("touchEnd", []);
}

const state = async (page) => (await rest(page), page.evaluate(() => ({ index: state.index, count: state.count, changed: state.changed,
  caption: state.caption, outcome: state.outcome, shapes: state.shapes, numerics: state.numerics, question: state.question, practice: state.practice })));
/** Steps on until there is a question. */
async function toQuestion(page) {
  for (let i = 0; i < 30 && !(await rest(page), await page.locator("#question").isVisible()); ++i) await page.locator("body").press("ArrowRight");
}
const distance = async (page) => Number((await state(page)).outcome[0][1]);

// Steps -------------------------------------------------------------------------------------------

action("buttons, keys, slider and ticks step", async (visit, size) => {
  const page = await visit(url("polygons-gjk"), size);
  const [, all] = await count(page);
  assert.equal(all, (await page.locator(".transcript li").count()));
  await page.click("#step");
  assert.deepEqual(await count(page), [2, all]);
  await page.click("#iteration");
  const [after] = await count(page);
  assert.ok(after > 2);
  await page.click("#iteration-back");
  await page.click("#back");
  assert.deepEqual(await count(page), [1, all]);
  await page.locator("body").press("ArrowRight");
  await page.locator("body").press("Shift+ArrowRight");
  assert.ok((await count(page))[0] >= 3);
  await page.locator("body").press("End");
  assert.deepEqual(await count(page), [all, all]);
  assert.ok(await page.locator("#step").isDisabled());
  await page.locator("body").press("Home");
  assert.deepEqual(await count(page), [1, all]);
  await page.locator("#scrub").focus();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowRight");
  assert.deepEqual(await count(page), [3, all]);
  assert.equal(await text(page, "caption"), (await state(page)).caption);
  await until(page, () => location.hash === "#step=3");
  const slider = await page.locator("#scrub").boundingBox();
  await page.mouse.click(slider.x + slider.width / 2, slider.y + slider.height / 2);
  const [middle] = await count(page);
  assert.ok(Math.abs(middle - all / 2) <= 2, `the slider's middle is step ${middle} of ${all}`);
  if (size !== "phone") {
    await page.locator('#timeline [data-of="frame 4"]').first().click();
    assert.deepEqual(await count(page), [5, all]);
  }
  await page.locator('#panel [role="button"]').nth(1).click();
  const [byLine] = await count(page);
  await page.locator('#panel [role="button"]').nth(1).press("Enter");
  assert.notEqual((await count(page))[0], byLine);
  await page.locator(".transcript a").nth(6).click();
  assert.deepEqual(await count(page), [7, all]);
  await close(page);
});

action("play goes on by itself and ends at the end", async (visit) => {
  const page = await visit(url("segment-regions", "#step=1"));
  await page.clock.install();
  const [, all] = await count(page);
  await page.locator("body").press(" ");
  await page.clock.runFor(1800 * 3 + 100);
  assert.equal((await count(page))[0], 4);
  await page.locator("body").press(" ");
  await page.clock.runFor(4000);
  assert.equal((await count(page))[0], 4);
  await page.click("#play");
  await page.clock.runFor(1800 * all);
  assert.equal((await count(page))[0], all);
  await page.locator('#play[aria-pressed="false"]').waitFor();
  assert.equal(await page.locator("#play").getAttribute("aria-pressed"), "false");
  await close(page);
});

action("an address names the step, also a later one", async (visit) => {
  const page = await visit(url("polygons-gjk", "#step=7"));
  assert.equal((await count(page))[0], 7);
  await page.evaluate(() => { location.hash = "9"; });
  await page.locator("#count", { hasText: /^9 / }).waitFor();
  await close(page);
});

// The hand ----------------------------------------------------------------------------------------

action("a vertex and a shape are dragged, and undo takes it back", async (visit, size) => {
  const page = await visit(url("polygons-gjk", "#step=5"), size);
  await page.locator("#stage").scrollIntoViewIfNeeded();
  const drag = SIZES[size].touch ? touchPath : dragByMouse;
  const before = await state(page);
  const scrolled = await page.evaluate(() => scrollY);
  await drag(page, await vertex(page, "y 0"), [-30, 34]);
  const after = await state(page);
  assert.notDeepEqual(after.shapes.y.vertices[0], before.shapes.y.vertices[0]);
  assert.deepEqual(after.shapes.y.vertices.slice(1), before.shapes.y.vertices.slice(1));
  assert.notEqual(after.outcome[0][1], before.outcome[0][1]);
  assert.equal(await page.evaluate(() => scrollY), scrolled, "the page stays under a dragging finger");
  const box = await page.locator('#stage path[data-of="X"]').first().boundingBox();
  await drag(page, [box.x + box.width / 2, box.y + box.height / 2], [24, -10]);
  const moved = await state(page);
  const shift = (i, axis) => moved.shapes.x.vertices[i][axis] - before.shapes.x.vertices[i][axis];
  assert.ok(shift(0, 0) > 0.01);
  for (let i = 1; i < moved.shapes.x.vertices.length; ++i) assert.ok(Math.abs(shift(i, 0) - shift(0, 0)) < 1e-9);
  await page.locator("body").press("u");
  assert.deepEqual((await state(page)).shapes, after.shapes);
  await page.click("#undo");
  assert.deepEqual((await state(page)).shapes, before.shapes);
  assert.equal((await state(page)).changed, false);
  await page.click("#redo");
  await page.click("#redo");
  assert.deepEqual((await state(page)).shapes, moved.shapes);
  await page.click("#reset");
  assert.deepEqual((await state(page)).shapes, before.shapes);
  await close(page);
});

action("a finger that swipes over the empty stage steps, one that drags does not", async (visit) => {
  const page = await visit(url("polygons-gjk", "#step=4"));
  const box = await page.locator("#stage").boundingBox();
  const empty = [box.x + box.width - 30, box.y + 14];
  await touchPath(page, empty, [-160, 6]);
  assert.equal((await count(page))[0], 5);
  await touchPath(page, [box.x + 30, box.y + 14], [160, 6]);
  assert.equal((await count(page))[0], 4);
  assert.equal((await state(page)).changed, false);
  await close(page);
}, { sizes: ["phone"] });

action("a difference that is pointed at lights up with its two vertices", async (visit, size) => {
  const page = await visit(url("polygons-gjk", "#step=17"));
  await toMiddle(page, "z 2 0");
  const at = await vertex(page, "z 2 0");
  if (SIZES[size].touch) await page.touchscreen.tap(...at);
  else await page.mouse.move(...at);
  await rest(page);
  const lit = await page.locator("#stage .ring").evaluateAll((rings) => [...new Set(rings.map((ring) => ring.dataset.lit))].sort());
  assert.deepEqual(lit, ["x 2", "y 0", "z 2 0"]);
  await close(page);
});

action("a support point, drawn as a diamond alone, lights up", async (visit, size) => {
  const page = await visit(url("penetration-depth"));
  const diamond = () => page.evaluate(() => {
    const marks = [...document.querySelectorAll('#stage path[data-of^="z "]')];
    const alone = marks.find((mark) => !document.querySelector(`#stage circle[data-of="${mark.dataset.of}"]`));
    if (!alone) return null;
    alone.scrollIntoView({ block: "center" });
    const box = alone.getBoundingClientRect();
    return { of: alone.dataset.of, at: [box.x + box.width / 2, box.y + box.height / 2] };
  });
  let found = null;
  for (let i = 0; i < 20 && !found; ++i) {
    await page.click("#step");
    await settle(page);
    found = await diamond();
  }
  assert.ok(found, "no step has such a diamond");
  if (SIZES[size].touch) await page.touchscreen.tap(...found.at);
  else await page.mouse.move(...found.at);
  await rest(page);
  const lit = await page.locator("#stage .ring").evaluateAll((rings) => rings.map((ring) => ring.dataset.lit));
  assert.ok(lit.includes(found.of), `lit: ${lit}`);
  await close(page);
});

action("the hint to drag goes when something is dragged", async (visit, size) => {
  const page = await visit(url("polygons-gjk", "#step=17"));
  assert.match(await text(page, "hint"), /^Drag a corner/);
  await toMiddle(page, "z 2 0");
  const drag = SIZES[size].touch ? touchPath : dragByMouse;
  await drag(page, await vertex(page, "z 2 0"), [30, -20]);
  assert.equal(await text(page, "hint"), "");
  await close(page);
});

action("in the difference a drag moves Y", async (visit, size) => {
  const page = await visit(url("polygons-gjk", "#step=17"));
  await toMiddle(page, "z 2 0");
  const drag = SIZES[size].touch ? touchPath : dragByMouse;
  const before = await state(page);
  await drag(page, await vertex(page, "z 2 0"), [30, -20]);
  const after = await state(page);
  assert.deepEqual(after.shapes.x, before.shapes.x);
  assert.ok(after.shapes.y.vertices[0][0] - before.shapes.y.vertices[0][0] > 0.01);
  await close(page);
});

action("the handle of a selected shape turns it, and goes when another place is pressed", async (visit, size) => {
  const page = await visit(url("polygons-gjk", "#step=17"));
  const { touch } = SIZES[size];
  const drag = touch ? touchPath : dragByMouse;
  const tap = (at) => (touch ? page.touchscreen.tap(...at) : page.mouse.click(...at));
  const middle = async (mark) => {
    await rest(page);
    const box = await page.locator(mark).first().boundingBox();
    return [box.x + box.width / 2, box.y + box.height / 2];
  };
  await toMiddle(page, "y 0");
  const before = await state(page);
  await tap(await middle('#stage path[data-of="Y"]'));
  const handle = await middle('#stage [data-mark="handle"]');
  assert.equal((await state(page)).changed, false);
  await drag(page, handle, [40, 30]);
  const after = await state(page);
  assert.equal(await page.evaluate(() => state.undo), "turn a shape");
  assert.notDeepEqual(after.outcome, before.outcome);
  const box = await page.locator("#stage").boundingBox();
  await tap([box.x + box.width - 8, box.y + 8]);
  await rest(page);
  assert.equal(await page.locator('#stage [data-mark="handle"]').count(), 0);
  await close(page);
});

action("a double click beside an edge adds a vertex there, with a ring around it", async (visit) => {
  const page = await visit(url("polygons-gjk", "#step=17"));
  await toMiddle(page, "y 0");
  const before = await state(page);
  const [from, to] = [await vertex(page, "y 0"), await vertex(page, "y 1")];
  await page.mouse.dblclick((from[0] + to[0]) / 2, (from[1] + to[1]) / 2);
  await rest(page);
  const after = await state(page);
  assert.equal(await page.evaluate(() => state.undo), "add a vertex");
  assert.equal(after.shapes.y.vertices.length, before.shapes.y.vertices.length + 1);
  assert.ok(await page.locator('#stage [data-mark="selected"]').count() > 0);
  await close(page);
});

action("Shift holds a drag to round numbers, and G does it for all", async (visit) => {
  const page = await visit(url("polygons-gjk", "#step=17"));
  const short = async () => (await state(page)).shapes.y.vertices[0].slice(0, 2).every((each) => each.length <= 5);
  await toMiddle(page, "y 0");
  const drag = async () => dragByMouse(page, await vertex(page, "y 0"), [23.7, 17.3]);
  await drag();
  assert.equal(await short(), false);
  await page.keyboard.down("Shift");
  await drag();
  await page.keyboard.up("Shift");
  assert.equal(await short(), true, `${(await state(page)).shapes.y.vertices[0]}`);
  await page.locator("body").press("g");
  assert.match(await text(page, "hint"), /round numbers/);
  await drag();
  assert.equal(await short(), true);
  await close(page);
}, { sizes: ["laptop", "projector"] });

action("vertices are typed as decimals and hex floats, and moved by arrow keys", async (visit) => {
  const page = await visit(url("polygons-gjk"));
  await page.click("#vertices-part summary");
  await page.fill("#y-0-0", "0.75");
  await page.locator("#y-0-0").press("Enter");
  assert.equal((await state(page)).shapes.y.vertices[0][0], "0.75");
  await page.check("#hex");
  assert.equal(await page.inputValue("#y-0-0"), "0x1.8p-1");
  await page.fill("#y-0-0", "0x1p-1");
  await page.locator("#y-0-0").press("Enter");
  assert.equal((await state(page)).shapes.y.vertices[0][0], "0.5");
  await page.fill("#y-0-0", "a lot");
  await page.locator("#y-0-0").press("Enter");
  assert.match(await text(page, "problem"), /^x of K: 'a lot' is no number; expected one like 0\.25/);
  assert.equal(await page.inputValue("#y-0-0"), "0x1p-1");
  await page.fill("#y-0-0", "1e300");
  await page.locator("#y-0-0").press("Enter");
  assert.match(await text(page, "problem"), /^polygons-gjk\.toml:\d+:\d+: entry 1 of entry 1 of 'vertices' is 1e\+300; expected number of at most 1e\+18/);
  const before = await state(page);
  const name = page.locator("#vertices tbody th button").first();
  await name.focus();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowUp");
  const after = await state(page);
  assert.ok(after.shapes.x.vertices[0][0] > Number(before.shapes.x.vertices[0][0]));
  assert.ok(after.shapes.x.vertices[0][1] > Number(before.shapes.x.vertices[0][1]));
  assert.ok(await name.evaluate((button) => button === document.activeElement));
  await close(page);
});

action("values are shown in decimal and hex", async (visit) => {
  const page = await visit(url("polygons-gjk", "#step=17"));
  await page.click("#numbers-part summary");
  await page.locator("#numbers table").first().waitFor();
  assert.match(await text(page, "numbers"), /distance1\.35566/);
  await page.click("#vertices-part summary");
  await page.check("#hex");
  assert.match(await text(page, "numbers"), /distance0x1\.5b0/);
  await close(page);
});

action("the listing becomes code, is copied by a click, and the link holds it", async (visit) => {
  const page = await visit(url("polygons-gjk", "#step=5"));
  await page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
  assert.ok(!(await page.locator("#copy-code").isVisible()), "pseudocode is no file");
  for (const [language, name, line] of [["cpp", "textbook.hpp", "Simplex"], ["python", "textbook.py", "SimplexVertex"]]) {
    await page.selectOption("#language", language);
    await rest(page);
    assert.ok((await page.locator("#panel").textContent()).includes(`${name}, lines`));
    await page.click("#copy-code");
    await rest(page);
    const copied = await page.evaluate(() => navigator.clipboard.readText());
    assert.equal(copied, read(`tests/gjk/${name}`));
    assert.ok(copied.includes(line));
  }
  await until(page, () => location.hash.includes("lesson="));
  const again = await visit(await page.evaluate(() => location.href));
  await rest(again);
  assert.equal(await again.inputValue("#language"), "python");
  assert.ok((await again.locator("#panel").textContent()).includes("textbook.py, lines"));
  await close(again);
  const without = await visit(url("lin-canny"));
  assert.ok(!(await without.locator("#listing").isVisible()), "no code for this listing");
  await close(without);
  await close(page);
}, { alone: true });

action("scalar and rules are chosen, and the run follows", async (visit) => {
  const page = await visit(url("direction-half"));
  await page.locator("summary", { hasText: "How the run computes" }).click();
  const before = await state(page);
  assert.equal(before.numerics.scalar, "half");
  await page.selectOption("#numerics-scalar", "exact");
  assert.match(await text(page, "problem"), /^direction-half\.toml:\d+:\d+: the second run has the scalar of the first; expected another/);
  assert.equal(await page.inputValue("#numerics-scalar"), "half");
  await page.selectOption("#numerics-scalar", "float");
  const after = await state(page);
  assert.equal(after.numerics.scalar, "float");
  assert.notDeepEqual(after.outcome, before.outcome);
  await page.selectOption("#numerics-direction", "perpendicular");
  await rest(page);
  await page.uncheck("#numerics-repeated");
  assert.equal((await state(page)).numerics.repeated, false);
  await close(page);
});

action("space turns under the hand, by keys and by buttons; its run stays, and a link holds the side", async (visit, size) => {
  const page = await visit(url("polyhedra-gjk"));
  const eye = async () => (await rest(page), page.evaluate(() => state.eye));
  const before = await eye();
  const run = (await state(page)).outcome;
  await page.locator("#stage").evaluate((stage) => stage.scrollIntoView({ block: "center" }));
  const box = await page.locator("#stage").boundingBox();
  const drag = SIZES[size].touch ? touchPath : dragByMouse;
  await drag(page, [box.x + 8, box.y + 60], [60, 20]);
  const dragged = await eye();
  assert.ok(dragged[0] < before[0] - 5 && dragged[1] > before[1] + 2, `${before} became ${dragged}`);
  await page.locator("body").press("d");
  assert.ok(Math.abs((await eye())[0] - dragged[0] - 10) < 1e-9);
  const link = page.url();
  assert.match(link, /&eye=-?[\d.]+,[\d.]+/);
  const there = await eye();
  const again = await visit(link);
  await rest(again);
  const seen = await again.evaluate(() => state.eye);
  assert.ok(seen.every((degrees, i) => Math.abs(degrees - there[i]) < 0.06), `${there} and ${seen}`);
  await close(again);
  await page.locator("#sides button", { hasText: "top" }).click();
  assert.deepEqual(await eye(), [0, 90]);
  await page.locator("body").press("Shift+Digit2");
  assert.deepEqual(await eye(), [90, 0]);
  if (SIZES[size].touch) {
    await toMiddle(page, "x 0");
    const [x, y] = await vertex(page, "x 0");
    await twoFingers(page, [x, y], [50, 30]);
    const turned = await eye();
    assert.ok(turned[0] < 85 && turned[1] > 5, `two fingers turn to ${turned}`);
  }
  const after = await state(page);
  assert.deepEqual(after.outcome, run);
  assert.equal(after.changed, false);
  await close(page);
});

action("a vertex in space is dragged and typed, and the distance follows", async (visit, size) => {
  const page = await visit(url("polyhedra-gjk"));
  const before = await distance(page);
  await page.locator("#stage").evaluate((stage) => stage.scrollIntoView({ block: "center" }));
  const drag = SIZES[size].touch ? touchPath : dragByMouse;
  await drag(page, await vertex(page, "y 1"), [-20, 14]);
  assert.ok((await state(page)).changed);
  await page.locator("summary", { hasText: "Vertices" }).click();
  assert.equal(await page.locator("#x-0-2").inputValue(), "0.8");
  await page.fill("#x-0-2", "3");
  await page.locator("#x-0-2").press("Enter");
  const moved = (await state(page)).shapes.x.vertices[0];
  assert.deepEqual(moved.slice(0, 3), ["-1", "-0.6", "3"]);
  assert.notEqual(await distance(page), before);
  await close(page);
});

action("questions are asked before they are told, and graded from the run", async (visit) => {
  const page = await visit(url("polygon-evolution"));
  await page.locator("body").press("p");
  await toQuestion(page);
  assert.ok(await page.locator("#question").isVisible());
  const [asked] = await count(page);
  await page.locator("body").press("ArrowRight");
  assert.equal((await count(page))[0], asked, "no step past an open question");
  const right = await page.evaluate(async () => (await ask({ do: "answer", choice: "-" })).answers.answer);
  await page.locator("body").press("ArrowLeft");
  await rest(page);
  assert.equal(await page.locator("#question").isVisible(), false, "a question is answered once");
  await close(page);
  const again = await visit(url("polygon-evolution"));
  await again.locator("body").press("p");
  await toQuestion(again);
  await again.locator("#choices button", { hasText: new RegExp(`^${right}$`) }).click();
  assert.match(await text(again, "verdict"), new RegExp(`^Right: ${right}\\. 1 of 1 so far`));
  await close(again);
});

// Links and files ---------------------------------------------------------------------------------

action("a shared link restores lesson, step and vertices", async (visit) => {
  const page = await visit(url("polygons-gjk", "#step=6"));
  await dragByMouse(page, await vertex(page, "y 0"), [-25, 30]);
  const before = await state(page);
  await page.click("#share");
  await page.locator("#link-title", { hasText: "Share" }).waitFor();
  const link = await page.inputValue("#link-value");
  assert.ok(link.length < 2500, `${link.length} characters`);
  const other = await visit(link, "phone");
  const after = await state(other);
  assert.deepEqual(after, before);
  await other.click("#reset");
  assert.equal((await state(other)).changed, false);
  await close(other);
  await page.keyboard.press("Escape");
  await page.click("#embed");
  await page.locator("#link-title", { hasText: "Embed" }).waitFor();
  const line = await page.inputValue("#link-value");
  const [, source] = line.match(/^<iframe src="([^"]+)" width="\d+" height="\d+" title="[^"]*"><\/iframe>$/);
  const framed = await visit(source);
  assert.deepEqual((await state(framed)).shapes, before.shapes);
  assert.equal(await framed.locator(".transcript").isVisible(), false);
  assert.equal(await framed.locator("#stage").isVisible(), true);
  await close(framed);
  await close(page);
});

action("frames are saved as SVG and PNG", async (visit, _, theme) => {
  const page = await visit(url("stop-vertex", "#step=3"));
  const file = async (button) => {
    const [download] = await Promise.all([page.waitForEvent("download"), page.click(button)]);
    return [download.suggestedFilename(), readFileSync(await download.path())];
  };
  const [svgName, svg] = await file("#svg");
  const program = await startProgram();
  program({ do: "open", lesson: read("lessons/stop-vertex.toml"), name: "stop-vertex.toml" });
  program({ do: "layout", width: 1280, height: 720, panel: 368, timeline: 800, theme });
  program({ do: "go", to: 2 });
  assert.equal(svgName, "stop-vertex-0003.svg");
  assert.equal(svg.toString(), program({ do: "frame" }).svg);
  const [pngName, png] = await file("#png");
  assert.equal(pngName, "stop-vertex-0003.png");
  assert.equal(png.toString("latin1", 1, 4), "PNG");
  assert.deepEqual([png.readUInt32BE(16), png.readUInt32BE(20)], [2560, 1440]);
  assert.ok(png.length > 40000, `${png.length} bytes`);
  await close(page);
});

const lessonLink = (toml) => `#lesson=${deflateRawSync(Buffer.from(toml)).toString("base64url")}`;

claim("hostile and damaged links get a located problem, and nothing runs", async () => {
  const page = await open(url("polygons-gjk"));
  const source = read("lessons/polygons-gjk.toml");
  const follow = async (hash, wanted) => {
    await page.evaluate((to) => { say(""); location.hash = to; }, hash);
    await page.locator("#problem").waitFor({ timeout: 5000 });
    const problem = await text(page, "problem");
    assert.match(problem, wanted, `${hash.slice(0, 80)} gives: ${problem}`);
    assert.equal(await page.locator("#stage svg:visible").count(), 1);
  };
  const [, all] = await count(page);
  await follow("#step=999", new RegExp(`^link: there is no step 999; expected 1 to ${all}$`));
  await follow("#step=-1", /there is no step -1/);
  await follow("#step=1e99", /there is no step 1e99/);
  await follow("#lesson=%%%", /^link: 'lesson' has a % that no two hexadecimal digits follow$/);
  await follow("#lesson=@@@", /^link: 'lesson' has characters that no link has; expected letters, digits, - and _$/);
  await follow("#lesson=AAAA", /^link: 'lesson' is cut off or changed; expected the whole of a link that Share gave$/);
  await follow(lessonLink("title = 3"), /^link:1:9: 'title' is a number; expected text of 1 to 80 characters$/m);
  await follow(lessonLink(source.replace("-3.4", "1e999")), /^link:1[0-9]:\d+: /m);
  await follow(lessonLink(source.replace('"A", "B"', '"<img src=x onerror=alert(1)>", "B"')), /^link:\d+:\d+: entry 1 of 'names' has 28 characters; expected vertex name of 1 to 3/);
  await follow(`#case=${encodeURIComponent('{"a":[[0,0]],"b":[[1]]}')}`, /^link:1:\d+: \/b\/0 has 1 coordinates; expected two/);
  await follow(`#case=${encodeURIComponent('{"a":[[1e999,0]],"b":[[1,1]]}')}`, /^link:1:\d+: the number 1e999 is too large/);
  await follow(`#lesson=${deflateRawSync(Buffer.alloc(50e6)).toString("base64url")}`, /it holds more than 2097152 bytes/);
  await close(page);
});

claim("a script in names and titles of a link is text", async () => {
  const hostile = read("lessons/polygons-gjk.toml")
    .replace(/title = .*/, 'title = "<img src=x onerror=document.title=1><script>document.title=2</script>"')
    .replace('names = ["K"', 'names = ["<b>"').replaceAll(/"[KLMN]-[A-E]"/g, '"<b>-C"').replace('"<b>-C", "<b>-C", "<b>-C", "<b>-C"', '"L-D"');
  const page = await open(url("polygons-gjk", `${lessonLink(hostile)}&step=3`));
  assert.equal(await text(page, "problem"), "");
  assert.match(await page.locator("#stage").textContent(), /<b>/);
  assert.equal(await page.locator("#stage b, #stage img, #panel img, #panel script, .words script").count(), 0);
  assert.match(await page.title(), /^Polygon to polygon/);
  await close(page);
});

// The playground ----------------------------------------------------------------------------------

action("the playground answers for shapes of the kit", async (visit, size) => {
  const page = await visit(url("playground"), size);
  assert.equal((await count(page))[0], await page.evaluate(() => state.answer + 1), "it opens at the answer");
  for (const shape of ["point", "segment", "box", "ngon"]) {
    await page.click(`[data-for="x"][data-shape="${shape}"]`);
    await page.click(`[data-for="y"][data-shape="${shape}"]`);
    const { shapes } = await state(page);
    const corners = { point: 1, segment: 2, box: 4, ngon: 6 }[shape];
    assert.deepEqual([shapes.x.vertices.length, shapes.y.vertices.length], [corners, corners]);
    assert.match(await text(page, "answer"), /distance[\d.]+lower bound[\d.]+upper bound/);
  }
  assert.ok((await distance(page)) > 0);
  await page.click("#random");
  await page.locator(".kit summary").click();
  await page.fill("#case", '{"a": [[0, 0], [2, 0], [2, 2], [0, 2]], "b": [[1.5, 0.5], [3, 0.5], [3, 1.5], [1.5, 1.5]]}');
  await page.click("#paste");
  assert.equal(await distance(page), 0);
  assert.match(await text(page, "answer"), /penetration depth0\.5its lower bound0\.(5|4999)/);
  await page.fill("#case", '{"a": [[0, 0]], "b": [[3, 4]]}');
  await page.click("#paste");
  assert.equal(await distance(page), 5);
  assert.match(await text(page, "answer"), /closest point of Y\.x3closest point of Y\.y4/);
  await page.fill("#case", '{"a": [[0, 0]],\n "b": [[3, "four"]]}');
  await page.click("#paste");
  assert.match(await text(page, "problem"), /^pasted:2:\d+: \/b\/0\/1 is "four"; expected a finite number/);
  assert.equal(await distance(page), 5);
  await close(page);
});

claim("a case of 10 MB and one of 10,000 vertices are refused or drawn, not hung", async () => {
  const page = await open(url("playground"));
  await page.evaluate(() => {
    document.getElementById("case").value = `{"a": [${"[0,0],".repeat(1.7e6)}[1,1]], "b": [[3,4]]}`;
    document.getElementById("paste").click();
  });
  assert.match(await text(page, "problem"), /^pasted: 1\d{7} bytes are too many; expected at most 2097152$/);

  await page.evaluate((json) => {
    document.getElementById("case").value = json;
    document.getElementById("paste").click();
  }, JSON.stringify({ a: ring(10000, 0), b: ring(10000, 4) }));
  assert.ok(Math.abs((await distance(page)) - 2) < 1e-6 || /expected/.test(await text(page, "problem")));
  await page.evaluate((json) => {
    document.getElementById("case").value = json;
    document.getElementById("paste").click();
  }, JSON.stringify({ a: ring(10001, 0), b: ring(3, 4) }));
  assert.match(await text(page, "problem"), /^pasted:1:6: \/a has 10001 points; expected at most 10000/);
  await close(page);
});

claim("10 MB that are pasted or linked are refused at once, and the page goes on", async () => {
  const page = await open(url("playground"), "laptop", { permissions: ["clipboard-read", "clipboard-write"] });
  await page.evaluate(() => {
    window.frozen = 0;
    let last = performance.now();
    (function watch() {
      const now = performance.now();
      window.frozen = Math.max(window.frozen, now - last);
      last = now;
      setTimeout(watch);
    })();
  });
  const frozen = () => page.evaluate(() => new Promise((done) => setTimeout(() => done([window.frozen, window.frozen = 0][0]), 50)));
  const before = (await state(page)).shapes;
  const text10 = "[0, 0],\n".repeat(1.25e6);
  await page.locator(".kit summary").click();
  for (const [many, problem] of [
    [`{"a": [${text10}[1, 1]], "b": [[3, 4]]}`, /^pasted: 1\d{7} bytes are too many; expected at most 2097152$/],
    [`{"a": [${'"far",\n'.repeat(2.5e5)}0], "b": [[3, 4]]}`, /^pasted:1:7: \/a has 250001 points; expected at most 10000$/],
  ]) {
    await page.evaluate((json) => navigator.clipboard.writeText(json), many);
    await page.locator("#case").focus();
    await frozen();
    await page.keyboard.press("Control+a");
    await page.keyboard.press("Control+v");
    await page.locator("#problem").filter({ hasText: "pasted" }).waitFor();
    const pause = await frozen();
    console.log(`    ${(many.length / 1e6).toFixed(0)} MB pasted: ${pause.toFixed(0)} ms`);
    assert.match(await text(page, "problem"), problem);
    await page.click("#back");
    await rest(page);
    assert.equal(await page.locator("#problem").isVisible(), false);
  }
  await page.evaluate((json) => { location.hash = `case=${encodeURIComponent(json)}`; }, text10);
  await page.locator("#problem", { hasText: /^link: \d{8} characters are too many; expected at most 6291456$/ }).waitFor();
  assert.deepEqual((await state(page)).shapes, before);
  await page.evaluate((json) => navigator.clipboard.writeText(json), '{"a": [[0, 0]], "b": [[3, 4]]}');
  await page.locator("#case").focus();
  await page.keyboard.press("Control+a");
  await page.keyboard.press("Control+v");
  await page.click("#paste");
  assert.equal(await distance(page), 5);
  await close(page);
}, true);

claim("a link to the playground is followed in a fresh profile: a shared pair, a case, a step, an embedded figure", async () => {
  const page = await open(url("playground"));
  await page.click("#random");
  const before = await state(page);
  await page.click("#share");
  await page.locator("#link-title", { hasText: "Share" }).waitFor();
  const other = await open(await page.inputValue("#link-value"), "phone");
  assert.deepEqual((await state(other)).shapes, before.shapes);
  assert.equal(await distance(other), await distance(page));
  await close(other);
  await close(page);
  const given = await open(url("playground", `#case=${encodeURIComponent('{"a":[[0,0],[1,0]],"b":[[4,4]]}')}`));
  assert.equal(await distance(given), 5);
  await close(given);
  const framed = await open(url("playground", "#step=3&embed"));
  assert.equal((await count(framed))[0], 3);
  assert.ok(await framed.evaluate(() => document.documentElement.classList.contains("embed")));
  await close(framed);
});

const ring = (n, x, radius = 1) => Array.from({ length: n }, (_, i) =>
  [x + radius * Math.cos(2 * Math.PI * i / n), radius * Math.sin(2 * Math.PI * i / n)]);
const paste = (page, shapes) => page.evaluate((json) => {
  document.getElementById("case").value = json;
  document.getElementById("paste").click();
}, JSON.stringify(shapes));
/** Outlines that go in and out, which take the program seconds. */
const star = (n, x) => Array.from({ length: n }, (_, i) => {
  const [turn, radius] = [2 * Math.PI * i / n, 1 + 0.4 * Math.sin(37 * i)];
  return [x + radius * Math.cos(turn), radius * Math.sin(turn)];
});
/** The program takes 20 s more for every case, however fast it has become. */
const slow = (page) => page.workers().at(-1).evaluate(() => {
  const answer = globalThis.onmessage;
  globalThis.onmessage = (event) => {
    const end = String(event.data).includes('"do":"case"') ? performance.now() + 20000 : 0;
    while (performance.now() < end);
    return answer(event);
  };
});
/** The same from the beginning: the program hears of a case 20 s late. */
const slowFromTheStart = () => {
  const post = Worker.prototype.postMessage;
  Worker.prototype.postMessage = function (message, ...others) {
    if (!String(message).includes('"do":"case"')) return post.call(this, message, ...others);
    setTimeout(() => post.call(this, message, ...others), 20000);
  };
};
const long = { a: star(10000, 0), b: star(10000, 4) };

claim("what takes long runs beside the page, says so, and is given up by a button or Escape: all is as it was, undo included", async () => {
  const page = await open(url("playground"));
  await page.click("#random");
  await page.click('[data-for="y"][data-shape="box"]');
  const before = await state(page);
  const undo = await page.locator("#undo").getAttribute("title");
  for (const gives of [() => page.click("#cancel"), () => page.keyboard.press("Escape")]) {
    await settle(page);
    await slow(page);
    await paste(page, long);
    await page.locator("#busy").waitFor();
    await page.waitForFunction(() => sent?.message.do === "case"); // the page answers while the program works
    await page.locator(".kit summary").click();
    await page.locator(".kit summary").click();
    await gives();
    assert.deepEqual(await state(page), before);
    assert.equal(await page.locator("#busy").isVisible(), false);
    assert.match(await text(page, "hint"), /^Given up/);
    assert.equal(await page.locator("#undo").getAttribute("title"), undo);
  }
  await page.click("#undo");
  assert.notDeepEqual((await state(page)).shapes, before.shapes);
  await page.click("#undo");
  assert.equal((await state(page)).changed, false);
  await page.click("#redo");
  await page.click("#redo");
  assert.deepEqual((await state(page)).shapes, before.shapes);
  await close(page);
});

claim("a vertex without a name is named where the pointer comes near", async () => {
  const page = await open(url("playground"));
  await paste(page, { a: ring(40, 0, 3), b: ring(3, 6) });
  await rest(page);
  await settle(page);
  const places = await page.evaluate(() => {
    const names = new Set([...document.querySelectorAll("#stage text")].map((label) => label.textContent));
    return [...document.querySelectorAll('#stage circle[data-of^="x "]')]
      .map((mark) => ({ name: `x${Number(mark.dataset.of.slice(2)) + 1}`, box: mark.getBoundingClientRect() }))
      .filter(({ name }) => !names.has(name))
      .map(({ name, box }) => ({ name, at: [box.x + box.width / 2, box.y + box.height / 2] }));
  });
  assert.ok(places.length > 0, "all 40 have names");
  const near = () => page.locator("#stage .near text").allTextContents();
  for (const { name, at } of places.slice(0, 3)) {
    await page.mouse.move(...at);
    await rest(page);
    assert.deepEqual(await near(), [name]);
  }
  await page.mouse.move(5, 5);
  await rest(page);
  assert.deepEqual(await near(), []);
  await close(page);
});

claim("a link that takes long does not hang the page", async () => {
  const page = await open(url("polygons-gjk", `#case=${encodeURIComponent(JSON.stringify(long))}`), "laptop", { waits: false, init: slowFromTheStart });
  await page.locator("#busy").waitFor();
  await page.click("#cancel");
  await ready(page);
  assert.equal((await count(page))[0], 1);
  await page.click("#step");
  assert.equal((await count(page))[0], 2);
  assert.equal((await state(page)).changed, false);
  await close(page);
});

claim("a program that stops is started again where it was", async () => {
  const page = await open(url("polygons-gjk", "#step=6"));
  await dragByMouse(page, await vertex(page, "y 0"), [-25, 30]);
  const before = await state(page);
  await page.evaluate(() => {
    act({ do: "reset" });
    worker.onmessage({ data: { stopped: "out of memory" } });
    act({ do: "step", by: 1 });
  });
  assert.deepEqual({ ...(await state(page)), index: before.index, caption: before.caption }, before);
  assert.equal((await state(page)).index, before.index + 1, "what is pressed meanwhile comes after");
  await page.evaluate(() => { act({ do: "reset" }); worker.onmessage({ data: { stopped: "out of memory" } }); });
  assert.match(await text(page, "hint"), /^The program has stopped \(out of memory\): this is what was shown before/);
  await page.click("#undo");
  assert.equal((await state(page)).changed, false);
  await close(page);
});

claim("of moves that come faster than they are drawn only the newest is drawn", async () => {
  const page = await open(url("polygons-gjk", "#step=17"));
  await toMiddle(page, "y 0");
  const from = await vertex(page, "y 0");
  await page.mouse.move(...from);
  await page.mouse.down();
  await rest(page);
  const asked = await page.evaluate(async ([x, y]) => {
    let moves = 0;
    const post = worker.postMessage.bind(worker);
    worker.postMessage = (message) => { moves += message.includes('"move"'); post(message); };
    for (let i = 1; i <= 40; ++i)
      document.getElementById("stage").dispatchEvent(new window.PointerEvent("pointermove", { clientX: x + i, clientY: y, pointerId: 1, pointerType: "mouse", bubbles: true }));
    return new Promise((done) => setTimeout(() => done(moves), 500));
  }, from);
  assert.equal(asked, 2);
  await page.mouse.move(from[0] + 40, from[1]);
  await page.mouse.up();
  const to = await vertex(page, "y 0");
  assert.ok(Math.abs(to[0] - from[0] - 40) < 2 && Math.abs(to[1] - from[1]) < 2, `${from} to ${to}`);
  await close(page);
});

action("changes survive a reload and Back", async (visit, size) => {
  const page = await visit(url("polygons-gjk", "#step=5"), size);
  await toMiddle(page, "y 0");
  await (SIZES[size].touch ? touchPath : dragByMouse)(page, await vertex(page, "y 0"), [-30, 34]);
  const before = await state(page);
  assert.ok(before.changed);
  await until(page, () => location.hash.includes("&lesson="));
  await page.reload();
  await ready(page);
  assert.deepEqual(await state(page), before);
  await page.goto(url("about"));
  await page.goBack();
  await ready(page);
  assert.deepEqual(await state(page), before);
  await page.click("#reset");
  await until(page, () => /^#step=\d+$/.test(location.hash));
  await close(page);
});

claim("what is pressed or typed while the program works keeps what was pressed before", async () => {
  const page = await open(url("playground"));
  await page.evaluate(() => {
    for (const [shape, kind] of [["x", "point"], ["y", "segment"], ["x", "box"], ["y", "ngon"]]) document.querySelector(`[data-for="${shape}"][data-shape="${kind}"]`).click();
  });
  await until(page, () => state.shapes.x.vertices.length === 4 && state.shapes.y.vertices.length === 6);
  await page.locator("#vertices-part summary").click();
  await page.evaluate(() => {
    for (const [id, value] of [["x-0-0", "-4"], ["x-0-1", "-3"]]) {
      document.getElementById(id).value = value;
      document.getElementById(id).dispatchEvent(new window.Event("change"));
    }
  });
  assert.deepEqual((await state(page)).shapes.x.vertices[0].slice(0, 2), ["-4", "-3"]);
  await page.evaluate(() => ["step", "back", "back", "back"].forEach((id) => document.getElementById(id).click()));
  const [at, all] = await count(page);
  assert.equal(at, all - 3);
  await close(page);
});

claim("Back brings the random pair of the playground again", async () => {
  const page = await open(url("playground"));
  await page.click("#random");
  const before = await state(page);
  await until(page, () => location.hash.includes("&lesson="));
  await page.locator("nav.site a", { hasText: "About" }).click();
  await page.goBack();
  await ready(page);
  assert.deepEqual(await state(page), before);
  await close(page);
});

claim("a shape that is dented or crosses itself is said to count as its hull", async () => {
  const page = await open(url("polygons-gjk"));
  const at = await vertex(page, "x 2");
  const far = await vertex(page, "x 4");
  await dragByMouse(page, at, [2 * (far[0] - at[0]), far[1] - at[1]]);
  assert.match(await text(page, "hint"), /^X is not convex: GJK sees its hull\.$/);
  assert.ok(await page.locator("#hint").isVisible());
  await page.click("#undo");
  assert.equal(await text(page, "hint"), "");
  await page.goto(url("playground"));
  await ready(page);
  await page.locator(".kit summary").click();
  const rounded = (n, x) => ring(n, x, 2).map((point) => point.map((c) => Number(c.toFixed(4))));
  await paste(page, { a: rounded(5000, 0), b: rounded(9, 5) });
  assert.doesNotMatch(await text(page, "hint"), /not convex/, "what rounding does to a round shape is no dent");
  await close(page);
  const both = await open(url("playground", `#case=${encodeURIComponent('{"a":[[0,0],[2,2],[2,0],[0,2]],"b":[[5,0],[7,0],[6,1],[6,4]]}')}`), "phone");
  assert.match(await text(both, "hint"), /^X and Y are not convex: GJK sees their hulls\.$/);
  const [hint, bar] = await both.evaluate(() => [document.getElementById("hint").getBoundingClientRect().bottom, document.querySelector(".bar").getBoundingClientRect().top]);
  assert.ok(hint <= bar, `the note ends at ${hint}, the bar begins at ${bar}`);
  await close(both);
});

claim("a message points to the place in the text, below the field", async () => {
  const page = await open(url("playground"), "phone");
  await page.locator(".kit summary").click();
  for (const [json, problem] of [
    ['{"a": [[1e308,0],[-1e308,0]], "b": [[3,1e308]]}', /^pasted:1:9: \/a\/0\/0 is 1e\+308; expected a number from -1e\+18 to 1e\+18$/m],
    ['{"a": [[0, 0]],\n "b": [[3, "four"]]}', /^pasted:2:12: \/b\/0\/1 is "four"; expected a finite number/],
    ["POLYGON((0 0,1 0,0 1,0 0))", /^pasted:1:27: there is one shape, of 3 vertices; expected a second one, Y$/],
    ["a = [(0, 0), (1, x)]", /^pasted:1:18: 'x' stands among numbers/],
    [JSON.stringify({ a: ring(10001, 0), b: [[3, 4]] }), /^pasted:1:6: \/a has 10001 points; expected at most 10000$/],
  ]) {
    await page.evaluate((value) => { document.getElementById("case").value = value; }, json);
    await page.click("#paste");
    assert.match(await text(page, "problem"), problem);
    const { field, top, bottom } = await page.evaluate(() => {
      const box = document.getElementById("problem").getBoundingClientRect();
      return { field: document.getElementById("case").getBoundingClientRect().bottom, top: box.top, bottom: box.bottom };
    });
    assert.ok(top >= field - 1 && top - field < 60 && bottom <= SIZES.phone.height, `field to ${field}, message from ${top} to ${bottom}`);
  }
  await close(page);
  const typed = await open(url("polygons-gjk"));
  await typed.click("#vertices-part summary");
  await typed.fill("#x-0-0", "abc");
  await typed.locator("#x-0-0").press("Enter");
  assert.match(await text(typed, "problem"), /^x of A: 'abc' is no number; expected one like/);
  const [field, message] = await typed.evaluate(() => ["x-0-0", "problem"].map((id) => document.getElementById(id).getBoundingClientRect()).map(({ top, bottom }) => ({ top, bottom })));
  assert.ok(message.top - field.bottom < 30 && message.bottom <= SIZES.laptop.height, JSON.stringify([field, message]));
  await typed.fill("#x-0-0", "1");
  await typed.locator("#x-0-0").press("Enter");
  await rest(typed);
  assert.equal(await typed.locator("#problem").isVisible(), false);
  await close(typed);
});

claim("a file is chosen, or dropped on the page", async () => {
  const page = await open(url("playground"));
  await page.locator(".kit summary").click();
  const file = { name: "pair.json", mimeType: "application/json", buffer: Buffer.from('{"a": [[0, 0]], "b": [[3, 4]]}') };
  const [chooser] = await Promise.all([page.waitForEvent("filechooser"), page.click("#choose")]);
  await chooser.setFiles(file);
  await until(page, () => state.undo === "pair.json");
  assert.equal(await distance(page), 5);
  const drop = (content) => page.evaluate((value) => {
    const transfer = new window.DataTransfer();
    transfer.items.add(new window.File([value], "dropped.json"));
    document.body.dispatchEvent(new window.DragEvent("drop", { dataTransfer: transfer, bubbles: true, cancelable: true }));
  }, content);
  await drop('{"a": [[0, 0]], "b": [[6, 8]]}');
  await until(page, () => state.undo === "dropped.json");
  assert.equal(await distance(page), 10);
  await drop('{"a": [[0, 0]]}');
  await page.locator("#problem", { hasText: /^dropped\.json:1:1: \/b is missing; expected/ }).waitFor();
  assert.equal(await distance(page), 10);
  await drop(" ".repeat(3e6));
  await page.locator("#problem", { hasText: /^dropped\.json: 3000000 bytes are too many; expected at most 2097152$/ }).waitFor();
  await close(page);
});

claim("after a long case no vertices of the shapes before are listed, and the kit keeps the long shape", async () => {
  const page = await open(url("playground"));
  await page.locator("#vertices-part summary").click();
  await paste(page, { a: ring(1000, 0), b: [[5, 0], [6, 0]] });
  assert.match(await text(page, "vertices"), /too many vertices to list and to type/);
  await page.click('[data-for="y"][data-shape="point"]');
  assert.ok(Math.abs((await distance(page)) - 4.5) < 1e-9, "X is still the polygon of 1,000");
  await close(page);
});

claim("a view of many vertices has some 24 names, those of the run among them", async () => {
  const page = await open(url("playground"));
  for (const n of [40, 64, 100, 150, 200, 256, 1000]) {
    await paste(page, { a: ring(n, 0, 3), b: [[5, 5], [6, 5]] });
    await rest(page);
    const { names, run } = await page.evaluate(() => ({
      names: [...document.querySelectorAll("#stage text")].map((label) => label.textContent),
      run: state.outcome.flat().join(" "),
    }));
    const ofX = names.filter((name) => /^x\d+$/.test(name));
    assert.ok(ofX.length >= 1 && ofX.length <= 26, `${n} vertices: ${ofX.length} names`);
    assert.ok(run.length > 0);
  }
  await close(page);
});

claim("undo brings the view back, Escape ends a drag, Ctrl+Z takes back", async () => {
  const page = await open(url("polygons-gjk", "#step=17"));
  const width = () => page.evaluate(() => {
    const at = [...document.querySelectorAll('#stage circle[data-of^="z "]')].map((mark) => mark.getBoundingClientRect().x);
    return Math.max(...at) - Math.min(...at);
  });
  const before = await state(page);
  const wide = await width();
  await page.evaluate(() => {
    ask({ do: "nudge", shape: "x", index: 2, right: 4000, up: 3000 });
    return act({ do: "undo" });
  });
  assert.ok(Math.abs((await width()) - wide) < 1, `${await width()} of ${wide} pixels`);
  await toMiddle(page, "y 0");
  const from = await vertex(page, "y 0");
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move(from[0] + 40, from[1] + 20);
  await page.keyboard.press("Escape");
  await page.mouse.up();
  assert.deepEqual((await state(page)).shapes, before.shapes);
  await dragByMouse(page, await vertex(page, "y 0"), [30, 20]);
  assert.notDeepEqual((await state(page)).shapes, before.shapes);
  await page.keyboard.press("Control+z");
  assert.deepEqual((await state(page)).shapes, before.shapes);
  await page.keyboard.press("Control+Shift+z");
  assert.notDeepEqual((await state(page)).shapes, before.shapes);
  await close(page);
});

// Room --------------------------------------------------------------------------------------------

const WINDOWS = { phone: [360, 740], "short phone": [360, 640], "phone on its side": [740, 360], "laptop at 200 %": [683, 384],
  "laptop at 150 %": [911, 438], "browser with its bars": [1366, 657] };
const boxes = (page, ...ids) => page.evaluate((names) => Object.fromEntries(names.map((id) => {
  const { left, right, top, bottom } = document.getElementById(id).getBoundingClientRect();
  return [id, { left, right, top, bottom }];
})), ids);

claim("figure and controls are in sight together in any window, at any step, with a question, too", async () => {
  for (const [i, lesson] of ["polygons-gjk", "segment-regions", "penetration-nested", "hierarchy-large", "accuracy-cost", "lin-canny"].entries()) {
    for (const [name, [width, height]] of everySecond(Object.entries(WINDOWS), i)) {
      const page = await open(url(lesson), name.includes("phone") ? "phone" : "laptop", { viewport: { width, height } });
      const checkIt = async (when) => {
        await rest(page);
        const { stage, back, step, caption, hint } = await boxes(page, "stage", "back", "step", "caption", "hint");
        const where = `${lesson}, ${name}, ${when}: ${JSON.stringify({ stage, step, caption, hint })}`;
        const low = height < 576 && width > 544;
        for (const box of [stage, back, step]) assert.ok(box.top >= 0 && box.bottom <= height + 1 && box.left >= -1 && box.right <= width + 1, where);
        assert.ok(stage.bottom - stage.top >= (low ? 0.7 : when === "with a question" ? 0.3 : 0.4) * height, where);
        assert.ok(low ? stage.right <= back.left : stage.bottom <= back.top, where);
        assert.ok(caption.top < height - 20, where);
        if (!low && width < 704) assert.ok(stage.bottom <= caption.top && hint.bottom <= caption.top + 1, where);
      };
      await checkIt("at first");
      await page.locator("body").press("End");
      await checkIt("at the end");
      if (await page.locator("#predict").isVisible()) {
        await page.locator("body").press("Home");
        await page.locator("body").press("p");
        await toQuestion(page);
        await checkIt("with a question");
      }
      await close(page);
    }
  }
}, true);

claim("on a phone both views are in sight while a finger drags", async () => {
  const page = await open(url("polygons-gjk", "#step=7"), "phone");
  const from = await vertex(page, "y 0");
  const client = await page.context().newCDPSession(page);
  const send = (type, points) => client.send("Input.dispatchTouchEvent", { type, touchPoints: points });
  await send("touchStart", [{ x: from[0], y: from[1] }]);
  await send("touchMove", [{ x: from[0] - 12, y: from[1] + 9 }]);
  await send("touchMove", [{ x: from[0] - 25, y: from[1] + 18 }]);
  await rest(page);
  const { changed, cards, bar } = await page.evaluate(() => ({
    changed: state.changed,
    cards: [...document.querySelectorAll("#stage [data-mark=card]")].map((card) => card.getBoundingClientRect()).map(({ top, bottom }) => [top, bottom]),
    bar: document.querySelector(".bar").getBoundingClientRect().top,
  }));
  await send("touchEnd", []);
  assert.ok(changed && cards.length === 2, JSON.stringify(cards));
  for (const [top, bottom] of cards) assert.ok(top >= 0 && bottom <= bar && bottom - top > 150, `${JSON.stringify(cards)}, bar at ${bar}`);
  await close(page);
});

claim("a finger holds a vertex from 22 pixels away, and everything that it presses is 44 pixels high", async () => {
  const page = await open(url("polygons-gjk", "#step=7"), "phone");
  const before = await state(page);
  const [x, y] = await vertex(page, "x 0");
  await touchPath(page, [x - 22, y], [-20, 14]);
  const after = await state(page);
  assert.notDeepEqual(after.shapes.x.vertices[0], before.shapes.x.vertices[0]);
  assert.deepEqual(after.shapes.x.vertices.slice(1), before.shapes.x.vertices.slice(1));
  await page.evaluate(() => document.querySelectorAll("details").forEach((part) => { part.open = true; }));
  const small = await page.evaluate(() => [...document.querySelectorAll("button, select, summary, input:not([type=checkbox]), label.tick, nav a, .transcript a")]
    .filter((each) => each.getClientRects().length && each.getBoundingClientRect().height < 43.5).map((each) => each.outerHTML.slice(0, 80)));
  assert.deepEqual(small, []);
  await close(page);
});

claim("in the window of a browser with its bars on a small laptop the figure has half of the height and the caption is in sight", async () => {
  const lessons = opened.filter(isLesson);
  let page = null;
  const failing = [];
  for (const [i, name] of lessons.entries()) {
    // A new tab from time to time: nobody reads all lessons in one.
    if (i % 20 === 0) {
      if (page) await close(page);
      page = await open(url("polygons-gjk"));
      await page.setViewportSize({ width: 1366, height: 657 });
    }
    await page.goto(url(name.replace(".html", "")));
    await ready(page);
    const { stage, caption } = await boxes(page, "stage", "caption");
    if (stage.bottom - stage.top < 657 / 2) failing.push(`${name}: ${stage.bottom - stage.top} pixels`);
    if (caption.bottom > 657) failing.push(`${name}: the caption ends at ${caption.bottom}`);
  }
  assert.deepEqual(failing, []);
  await close(page);
});

claim("an embedded figure fits its frame, and leads to the lesson", async () => {
  for (const [width, height] of [[960, 720], [400, 500]]) {
    const page = await open(url("polygons-gjk", "#step=6&embed"));
    await page.setViewportSize({ width, height });
    await twoFrames(page);
    const { stage, step, caption } = await boxes(page, "stage", "step", "caption");
    for (const box of [stage, step, caption]) assert.ok(box.top >= 0 && box.bottom <= height, `${width}x${height}: ${JSON.stringify({ stage, step, caption })}`);
    assert.ok(stage.bottom - stage.top >= 0.42 * height);
    if (width === 960) {
      const { panel } = await boxes(page, "panel");
      assert.ok(panel.bottom <= height && panel.left >= stage.right, JSON.stringify(panel));
    }
    const link = page.locator("#whole a");
    assert.equal(await link.textContent(), "Open “Polygon to polygon: GJK on the Minkowski difference”");
    const [other] = await Promise.all([page.context().waitForEvent("page"), link.click()]);
    await ready(other);
    assert.equal((await count(other))[0], 6);
    assert.ok(await other.locator(".transcript").isVisible());
    await close(page);
  }
});

claim("on a slow line the controls have their room, and the page says that it gets ready; nothing moves when it is", async () => {
  for (const [lesson, size, width, height] of [["polygons-gjk", "laptop", 1366, 768], ["polygons-gjk", "phone", 360, 740], ["playground", "laptop", 1366, 768], ["playground", "phone", 360, 740], ["stop-vertex", "laptop", 740, 360]]) {
    let goOn = null;
    const arrived = new Promise((done) => { goOn = done; });
    const server = await serve(site, async (name) => {
      if (name === "shared/program.js") await arrived;
      return readFileSync(join(site, name));
    });
    const context = await browser.newContext({ viewport: { width, height }, hasTouch: size === "phone" });
    const page = await context.newPage();
    page.complaints = [];
    page.goto(`${server.address}${lesson}.html`).catch(() => {});
    await page.locator(".transcript li").first().waitFor();
    await until(page, () => document.getElementById("data")?.dataset.starts);
    assert.equal(await page.locator("#hint").textContent(), "Getting ready …");
    assert.ok(await page.locator("#step").isVisible());
    const ids = ["stage", "step", "scrub", "count", "position", "caption"];
    const early = await boxes(page, ...ids);
    goOn();
    await ready(page);
    const late = await boxes(page, ...ids);
    for (const id of ids) {
      for (const side of ["left", "top", "right", "bottom"])
        assert.ok(Math.abs(early[id][side] - late[id][side]) <= 1, `${lesson}, ${width}x${height}: ${side} of ${id} from ${early[id][side]} to ${late[id][side]}`);
    }
    await close(page);
    server.close();
  }
});

/** In a new folder, by the command. */
function exported(...options) {
  const program = process.env.GJKSCOPE ?? ["release", "gcc", "dev"].map((build) => join(root, `build/${build}/bin/gjkscope`)).find(existsSync);
  assert.ok(program, "there is no gjkscope in build; name one in $GJKSCOPE");
  const folder = mkdtempSync(join(tmpdir(), "gjkscope-"));
  execFileSync(program, ["export", "--format", "html", "--out", folder, ...options]);
  return { folder, at: (name) => pathToFileURL(join(folder, name)).href };
}

claim("a page that was cut off, that lacks what its site shares, or has no scripts, says so", async () => {
  const { folder, at } = exported("polygons-gjk");
  writeFileSync(join(folder, "cut.html"), readFileSync(join(folder, "polygons-gjk.html")).subarray(0, 1_200_000));
  const page = await open(at("cut.html"), "laptop", { waits: false });
  await page.locator("#problem", { hasText: /^This page did not arrive as a whole/ }).waitFor();
  assert.equal(await page.locator("#step").isVisible(), false);
  await close(page);
  copyFileSync(join(site, "polygons-gjk.html"), join(folder, "alone.html"));
  const alone = await open(at("alone.html"), "laptop", { waits: false });
  await alone.locator("#problem", { hasText: /^This page is of a site, and needs the folder “shared” beside it/ }).waitFor();
  await alone.context().close();
  rmSync(folder, { recursive: true });
  const server = await serve(site, (name) => {
    if (name === "shared/program.js") throw new Error("lost");
    return readFileSync(join(site, name));
  });
  const without = await open(`${server.address}polygons-gjk.html`, "laptop", { waits: false });
  await without.locator("#problem", { hasText: /cannot be made live here: shared\/program\.js is not there/ }).waitFor();
  assert.equal(await without.locator("#stage svg:visible").count(), 1);
  await without.context().close();
  server.close();
  const plain = await open(url("playground"), "laptop", { javaScriptEnabled: false });
  assert.match(await plain.locator("main noscript").innerText(), /^Scripts are off, so nothing here can be stepped or dragged/);
  await plain.context().close();
});

// Questions ---------------------------------------------------------------------------------------

claim("only lessons that have questions offer them", async () => {
  const program = await startProgram();
  const wrong = opened.filter((name) => {
    if (name === "practice.html") return false;  // it asks by itself
    const page = readFileSync(join(site, name), "utf8");
    const told = page.match(/<script type="application\/json" id="data">(.*?)<\/script>/s);
    if (!told) return false;
    const { lesson, files } = JSON.parse(told[1]);
    for (const [file, packed] of Object.entries(files)) files[file] = inflateRawSync(Buffer.from(packed, "base64")).toString();
    const { count: steps } = program({ do: "open", lesson, files, name });
    const asks = program({ do: "predict", on: true }).count > steps;
    program({ do: "predict", on: false });
    return asks === /<button id="predict"[^>]* hidden>/.test(page);
  });
  assert.deepEqual(wrong, []);
});

claim("who asks to be asked in the middle of a run is asked there, and told nothing", async () => {
  for (const size of ["laptop", "phone"]) {
    const page = await open(url("polygons-gjk", "#step=7"), size);
    await page.click("#predict");
    assert.match(await text(page, "caption"), /^Question: /);
    assert.ok(await page.locator("#question").isVisible());
    const { stage, choices } = await boxes(page, "stage", "choices");
    assert.ok(stage.top >= -1 && choices.bottom <= SIZES[size].height, JSON.stringify({ stage, choices }));
    await close(page);
  }
});

/** To a question for two vertices; others are answered on the way. */
async function toPair(page) {
  for (;;) {
    await toQuestion(page);
    if (await page.evaluate(() => state.question.pair)) return;
    await page.locator("#choices button").first().click();
    await rest(page);
  }
}

action("questions are answered in the figure: vertices of two shapes, a region, a place and how far off it was", async (visit, size) => {
  const page = await visit(url("polygons-gjk"), size);
  const tap = async (x, y) => {
    const place = await page.evaluate(([px, py]) => {
      const svg = document.querySelector("#stage svg");
      const box = svg.getBoundingClientRect();
      const scale = box.width / svg.viewBox.baseVal.width;
      return [box.left + px * scale, box.top + py * scale];
    }, [x, y]);
    await page.mouse.click(...place);
    await rest(page);
  };
  const disk = (of) => page.evaluate((name) => {
    const mark = document.querySelector(`#stage circle[data-of="${name}"]`);
    return [Number(mark.getAttribute("cx")), Number(mark.getAttribute("cy"))];
  }, of);
  await page.locator("body").press("p");
  await toPair(page);
  const { pair } = await page.evaluate(() => state.question);
  const [at] = await count(page);
  await tap(...(await disk("x 1")));  // halves in any order
  assert.equal((await count(page))[0], at);
  await tap(...(await disk("y 1")));
  assert.ok((await count(page))[0] > at);
  const chosen = `${pair[0].vertices[1]}−${pair[1].vertices[1]}`;
  const verdict = await text(page, "verdict");
  assert.ok(verdict.startsWith(`Right: ${chosen}.`) || verdict.startsWith(`Not ${chosen}:`), verdict);
  await close(page);

  const regions = await visit(url("segment-regions"), size);
  await regions.locator("body").press("p");
  for (;;) {
    await toQuestion(regions);
    if (await regions.evaluate(() => state.question.ask === "closest")) break;
    await regions.locator("#choices button").first().click();
    await rest(regions);
  }
  const middle = await regions.evaluate(() => {
    document.querySelector("#stage").scrollIntoView({ block: "start" });
    const ends = ["y 0", "y 1"].map((name) => document.querySelector(`#stage circle[data-of="${name}"]`).getBoundingClientRect());
    return [(ends[0].x + ends[1].x + ends[0].width) / 2, (ends[0].y + ends[1].y + ends[0].height) / 2];
  });
  await regions.mouse.click(...middle);
  await rest(regions);
  assert.match(await text(regions, "verdict"), /You pointed [\d.·⁻⁰-⁹]+ away from it\./);
  await close(regions);
});

action("a question for two vertices has two short lists, answered by hand or by digits; its text stands there once", async (visit, size) => {
  const page = await visit(url("polygons-gjk"), size);
  await page.locator("body").press("p");
  await toPair(page);
  const { question } = await page.evaluate(() => ({ question: state.question }));
  assert.deepEqual(question.pair.map(({ of }) => of), ["Y", "X"]);
  assert.equal(await page.locator("#choices button").count(), question.pair[0].vertices.length + question.pair[1].vertices.length);
  const words = await page.evaluate(() => document.querySelector("main").innerText);
  assert.equal(words.split((await state(page)).caption).length, 2);
  const [at] = await count(page);
  await page.locator("#choices fieldset").nth(1).locator("button", { hasText: /^B$/ }).click();
  assert.equal((await count(page))[0], at);
  await page.locator("#choices fieldset").nth(0).locator("button", { hasText: /^L$/ }).click();
  assert.ok((await count(page))[0] > at);
  assert.match(await text(page, "verdict"), /^(Right: L−B\.|Not L−B: the run says \S+\.) \d of \d so far/);
  await toQuestion(page);
  const { choices, pair } = await page.evaluate(() => state.question);
  await page.keyboard.press("2");
  if (pair) await page.keyboard.press("1");
  const chosen = pair ? `${pair[0].vertices[1]}−${pair[1].vertices[0]}` : choices[1];
  const verdict = await text(page, "verdict");
  assert.ok(verdict.startsWith(`Right: ${chosen}.`) || verdict.startsWith(`Not ${chosen}:`), verdict);
  await close(page);
});

claim("the index leads to where one stopped and to questions answered wrong, says what is done, and forgets all of it", async () => {
  const page = await open(url("index"));
  const memory = page.locator("#memory");
  assert.equal(await memory.isVisible(), false);
  await page.goto(url("triangle-ordered-test"));
  await ready(page);
  for (let i = 0; i < 3; ++i) await page.locator("body").press("ArrowRight");
  await rest(page);
  await page.goto(url("index"));
  assert.match(await memory.locator("p a").first().textContent(), /^Continue: .* \(step 4 of \d+\)$/);
  assert.match(await page.locator('.cards a[href="triangle-ordered-test.html"] .so-far').textContent(), /^step 4 of \d+$/);
  await memory.locator("p a").first().click();
  await ready(page);
  assert.equal((await count(page))[0], 4);
  await page.click("#predict");
  let at = 0;
  // The first choice is wrong sooner or later.
  do {
    await toQuestion(page);
    [at] = await count(page);
    await page.locator("#choices button").first().click();
    await rest(page);
  } while (!(await page.locator("#verdict.wrong").count()));
  await page.locator("body").press("End");
  await rest(page);
  await page.goto(url("index"));
  assert.equal(await page.locator('.cards a[href="triangle-ordered-test.html"] .so-far').textContent(), "✓ done");
  assert.match(await memory.locator("p a").first().textContent(), /^Continue: (?!.*step)/, "with the lesson after it");
  const repeat = memory.locator("p", { hasText: "Repeat a question" }).locator("a").first();
  assert.equal(await repeat.textContent(), `step ${at}`);
  await repeat.click();
  await ready(page);
  assert.equal((await count(page))[0], at);
  assert.match(await text(page, "caption"), /^Question: /);
  await page.goto(url("index"));
  await memory.locator("button").click();
  assert.equal(await memory.isVisible(), false);
  assert.equal(await page.locator(".so-far").count(), 0);
  await page.reload();
  assert.equal(await memory.isVisible(), false);
  await page.evaluate(() => localStorage.setItem("gjkscope-memory", '{"last":3,"lessons":{"triangle-ordered-test":{"step":"7"},"simplex":null}}'));
  await page.reload();
  assert.equal(await memory.isVisible(), false);
  await close(page);
});

claim("Play stops where a dialog opens", async () => {
  const page = await open(url("polygons-gjk", "#step=2"));
  for (const dialog of ["share", "embed"]) {
    await page.click("#play");
    await page.click(`#${dialog}`);
    await page.locator("#link").waitFor();
    assert.equal(await text(page, "play-name"), "Play");
    assert.match(await page.inputValue("#link-value"), new RegExp(`#step=${(await count(page))[0]}`));
    await page.keyboard.press("Escape");
  }
  await close(page);
});

claim("paper has a theme of its own, whatever the page shows", async () => {
  const page = await open(url("polygons-gjk", "#step=6"));
  await page.selectOption("#theme", "print");
  await rest(page);
  const wanted = await page.locator("#stage").innerHTML();
  await page.selectOption("#theme", "dark");
  await rest(page);
  const shown = await page.locator("#stage").innerHTML();
  assert.notEqual(shown, wanted);
  await until(page, () => paper);
  const printed = await page.evaluate(() => {
    dispatchEvent(new window.Event("beforeprint"));
    return document.getElementById("stage").innerHTML;
  });
  assert.equal(printed, wanted);
  await page.evaluate(() => dispatchEvent(new window.Event("afterprint")));
  await rest(page);
  assert.equal(await page.locator("#stage").innerHTML(), shown);
  assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), "dark");
  await close(page);
});

claim("the keyboard stays in the page's controls where Step cannot be pressed any more", async () => {
  const page = await open(url("stop-vertex"));
  await page.locator("#step").focus();
  const [, all] = await count(page);
  for (let i = 1; i < all; ++i) await page.keyboard.press("Enter");
  await rest(page);
  assert.equal(await page.evaluate(() => document.activeElement.id), "back");
  await close(page);
});

// Looks -------------------------------------------------------------------------------------------

/** Texts that are set smaller than 14 pixels, and by how much the page is too wide. */
const measure = (page) => page.evaluate(() => {
  const small = [];
  for (const element of document.querySelectorAll("body *")) {
    if (![...element.childNodes].some((node) => node.nodeType === 3 && node.data.trim())) continue;
    if (element.getBoundingClientRect().width === 0 || ["SCRIPT", "STYLE", "OPTION"].includes(element.tagName)) continue;
    const svg = element.ownerSVGElement;
    const box = svg?.getBoundingClientRect();
    const scale = svg ? Math.min(box.width / svg.viewBox.baseVal.width, box.height / svg.viewBox.baseVal.height) : 1;
    const pixels = parseFloat(getComputedStyle(element).fontSize) * scale;
    if (pixels < 14) small.push(`${pixels.toFixed(1)}: ${element.textContent.slice(0, 30)}`);
  }
  return { wide: document.documentElement.scrollWidth - innerWidth, small };
});

/** To the last step, by key events made in the page: a real press each, as in other claims, takes long. */
const pressToTheEnd = (page) => page.evaluate(() => {
  for (let i = 1; i < state.count; ++i)
    document.body.dispatchEvent(new window.KeyboardEvent("keydown", { key: "ArrowRight", bubbles: true, cancelable: true }));
});

// In two halves, which run side by side.
for (const half of [0, 1]) {
  claim(`pages open from a file of their own and step to their end; at any size nothing scrolls sideways and no type is below 14 pixels (${half + 1} of 2)`, async () => {
    for (const name of opened.filter((_, i) => i % 2 === half)) {
      const page = await open(url(name.replace(".html", "")), "laptop");
      if (await page.locator("#wasm").count()) {
        await pressToTheEnd(page);
        const [at, all] = await count(page);
        if (name === "practice.html") assert.ok(await page.evaluate(() => state.question), "nobody steps past its question");
        else assert.equal(at, all, name);
        if (shots) await page.screenshot({ path: join(shots, `${name}-end.png`) });
      }
      for (const [size, viewport] of Object.entries(SIZES)) {
        await page.setViewportSize(viewport);
        await twoFrames(page);
        for (const key of ["Home", "End"]) {
          await page.locator("body").press(key);
          await rest(page);
          assert.deepEqual(await measure(page), { wide: 0, small: [] }, `${name} at ${size}`);
        }
      }
      await close(page);
    }
  });
}

claim("what a step says is in sight without scrolling", async () => {
  for (const size of ["laptop", "projector"]) {
    for (const name of ["polygons-gjk", "triangle-obtuse", "segment-balance", "penetration-nested", "accuracy-cost"]) {
      const page = await open(url(name), size);
      const below = await page.evaluate(async () => {
        const hidden = [];
        for (let step = 0; step < state.count; ++step) {
          await act({ do: "go", to: step });
          const words = document.getElementById(state.detail ? "detail" : "caption").getBoundingClientRect();
          if (words.bottom > innerHeight) hidden.push(step + 1);
        }
        return hidden;
      });
      assert.deepEqual(below, [], `steps of ${name} at ${size}`);
      await close(page);
    }
  }
});

claim("without a script there are the first frame and all words, and no type is below 14 pixels", async () => {
  for (const name of ["polygons-gjk", "stop-vertex", "hierarchy-distance"]) {
    const program = await startProgram();
    const { count: steps } = program({ do: "open", lesson: read(`lessons/${name}.toml`), name });
    const page = await open(url(name), "phone", { javaScriptEnabled: false });
    for (const width of [360, 700, 710, 1080, 1090, 1280, 1920]) {
      await page.setViewportSize({ width, height: 740 });
      assert.equal(await page.locator("#stage svg:visible").count(), 1);
      assert.deepEqual(await measure(page), { wide: 0, small: [] }, `${name} at ${width}`);
    }
    assert.equal(await page.locator(".controls").isVisible(), false);
    assert.ok((await text(page, "caption")).length > 20);
    assert.equal(await page.locator(".transcript li").count(), steps);
    await page.context().close();
  }
});

claim("without WebAssembly, too, and the page says so", async () => {
  const context = await browser.newContext();
  const page = await context.newPage();
  page.complaints = [];
  page.on("pageerror", (error) => page.complaints.push(String(error)));
  await page.addInitScript(() => { delete window.WebAssembly; });
  await page.goto(url("polygons-gjk"));
  await page.locator("#problem").waitFor();
  assert.match(await text(page, "problem"), /cannot be made live here.*The first frame and all words are below/);
  assert.equal(await page.locator("#stage svg:visible").count(), 1);
  assert.equal(await page.locator(".controls").isVisible(), false);
  assert.ok(await page.locator(".transcript li").count() > 10);
  await close(page);
});

claim("things move between steps, and not for who prefers less of it", async () => {
  for (const [reducedMotion, moves] of [["no-preference", true], ["reduce", false]]) {
    const page = await open(url("polygons-gjk", "#step=4"), "laptop", { reducedMotion });
    const changes = await page.evaluate(async () => {
      let seen = 0;
      document.getElementById("step").click();
      const watch = new MutationObserver((list) => { seen += list.length; });
      watch.observe(document.querySelector("#stage"), { childList: true });
      await new Promise((done) => setTimeout(done, 450));
      return seen;
    });
    assert.equal(changes > 2, moves, `${changes} pictures`);
    const shown = await page.locator("#stage").innerHTML();
    await page.evaluate(() => act({ do: "go", to: state.index }));
    await rest(page);
    const drawn = await page.locator("#stage").innerHTML();
    assert.equal(shown, drawn, "motion ends at the picture");
    await close(page);
  }
}, true);

claim("axe finds nothing, in any theme", async () => {
  const axe = readFileSync(join(root, "tests/web/node_modules/axe-core/axe.min.js"), "utf8");
  const server = await serve(site);  // axe reads the style sheets
  for (const [i, name] of ["index", "about", "playground", "polygons-gjk", "accuracy-cost", "triangle-two-maps"].entries()) {
    const page = await open(`${server.address}${name}.html`, "laptop", { bypassCSP: true, serviceWorkers: "block" });
    await page.evaluate(() => document.querySelectorAll("details").forEach((part) => { part.open = true; }));
    await page.addScriptTag({ content: axe });
    for (const theme of everySecond(THEMES, i)) {
      if (await page.locator("#theme").count()) await page.selectOption("#theme", theme), await rest(page);
      else await page.evaluate((to) => { document.documentElement.dataset.theme = to; }, theme);
      const { violations } = await page.evaluate(() => axe.run());
      assert.deepEqual(violations.map((v) => `${v.id}: ${v.nodes[0].html.slice(0, 120)} ${v.nodes[0].failureSummary}`), [], `${name}, ${theme}`);
    }
    await close(page);
  }
  server.close();
});

claim("captions are announced, figures have names, focus is seen", async () => {
  const page = await open(url("polygons-gjk", "#step=3"));
  assert.equal(await page.locator("#caption").evaluate((node) => node.closest("[aria-live]").getAttribute("aria-live")), "polite");
  assert.ok((await page.locator("#stage svg").getAttribute("aria-label")).startsWith(await text(page, "caption")));
  for (let i = 0; i < 60; ++i) {
    await page.keyboard.press("Tab");
    const outline = await page.evaluate(() => {
      const at = document.activeElement;
      const style = getComputedStyle(at);
      return at === document.body || (style.outlineStyle !== "none" && parseFloat(style.outlineWidth) >= 2);
    });
    assert.ok(outline, await page.evaluate(() => document.activeElement.outerHTML.slice(0, 100)));
  }
  await close(page);
});

claim("a term shows its sentence to pointer and keyboard, in words and panel", async () => {
  const page = await open(url("segment-regions"));
  const tip = page.locator("#term");
  const sentence = "The Voronoi region of a feature holds all points whose closest point lies on that feature.";
  const term = page.locator("#prose .term", { hasText: "Voronoi region" });
  assert.ok(await tip.isHidden());
  await term.hover();
  assert.equal(await tip.textContent(), sentence);
  await page.mouse.move(5, 5);
  assert.ok(await tip.isHidden());
  await term.focus();
  assert.equal(await tip.textContent(), sentence);
  await page.keyboard.press("Escape");
  assert.ok(await tip.isHidden());
  await page.locator("#panel .term").first().hover();
  assert.ok(await tip.isVisible());
  const { x, y, width, height } = await tip.boundingBox();
  const window = page.viewportSize();
  assert.ok(x >= 0 && y >= 0 && x + width <= window.width && y + height <= window.height);
  await close(page);
});

claim("all themes are shown, and remembered", async () => {
  const page = await open(url("polygons-gjk"));
  const seen = new Set();
  for (const theme of THEMES) {
    await page.selectOption("#theme", theme);
    await rest(page);
    seen.add(await page.evaluate(() => getComputedStyle(document.body).backgroundColor + document.querySelector("#stage rect").getAttribute("fill") + document.querySelector("#stage [data-mark=card]").getAttribute("stroke")));
  }
  assert.equal(seen.size, 4);
  await page.selectOption("#theme", "dark");
  await page.reload();
  await ready(page);
  assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), "dark");
  await close(page);
});

/** Milliseconds, sorted, from each of 200 moves of a vertex until the page has the picture of it. */
async function timesOfADrag(address) {
  const page = await open(address);
  const times = await page.evaluate(async () => {
    const svg = document.querySelector("#stage svg").getBoundingClientRect();
    const mark = document.querySelector('#stage circle[data-of="y 0"]') ?? document.querySelector('#stage [data-of="Y"]');
    const circle = mark.getBoundingClientRect();
    const from = { x: circle.x + circle.width / 2 - svg.x, y: circle.y + circle.height / 2 - svg.y };
    await act({ do: "press", ...from });
    const all = [];
    for (let i = 0; i < 200; ++i) {
      const began = performance.now();
      await act({ do: "move", x: from.x - 30 * Math.sin(i / 8) - 3, y: from.y + 20 * Math.cos(i / 8) });
      all.push(performance.now() - began);
    }
    return all;
  });
  await close(page);
  return times.sort((a, b) => a - b);
}

claim("a page that is exported alone, or with --single, is one file that opens from anywhere", async () => {
  const one = exported("polygons-gjk");
  const several = exported("stop-vertex", "--index", "--single");
  assert.deepEqual(readdirSync(one.folder), ["polygons-gjk.html"]);
  assert.deepEqual(readdirSync(several.folder).sort(), ["about.html", "index.html", "playground.html", "practice.html", "stop-vertex.html"]);
  for (const [{ folder, at }, name] of [[one, "polygons-gjk"], [several, "stop-vertex"], [several, "playground"], [several, "practice"], [several, "index"], [several, "about"]]) {
    copyFileSync(join(folder, `${name}.html`), join(folder, "copy.html"));
    const page = await open(at("copy.html"));
    if (await page.locator("#wasm").count()) {
      await page.locator("body").press("Home");
      await page.click("#step");
      assert.equal((await count(page))[0], 2);
    }
    assert.deepEqual(await page.evaluate(() => performance.getEntriesByType("resource").map((each) => each.name).filter((each) => !/^(data|blob):/.test(each))), []);
    await close(page);
  }
  for (const { folder } of [one, several]) rmSync(folder, { recursive: true });
});

claim("no script runs in a page but its own", async () => {
  const { folder, at } = exported("stop-vertex", "--index", "--single");
  const intrude = () => {
    document.body.append(Object.assign(document.createElement("script"), { textContent: "window.intruded = 1;" }));
    document.body.insertAdjacentHTML("beforeend", '<img src="data:," onerror="window.intruded = 2"><a id="intruder" href="javascript:window.intruded=3">x</a>');
    document.body.append(Object.assign(document.createElement("script"), { src: "data:text/javascript,window.intruded=4" }));
    document.getElementById("intruder").click();
    return new Promise((done) => setTimeout(() => done(window.intruded), 300));
  };
  for (const address of ["stop-vertex", "playground", "practice", "index", "about"].flatMap((name) => [url(name), at(`${name}.html`)])) {
    const page = await open(address);
    assert.deepEqual(page.complaints, [], address);
    assert.doesNotMatch(await page.locator("meta[http-equiv]").getAttribute("content"), /script-src[^;]*'unsafe-(inline|eval)'/);
    assert.equal(await page.evaluate(intrude), undefined, address);
    assert.ok(page.complaints.some((line) => /Content Security Policy/.test(line)), address);
    await page.context().close();
  }
  rmSync(folder, { recursive: true });
});

claim("a site that a server gave once works without a network, until a newer one has come", async () => {
  let newer = false;
  const server = await serve(site, (name) => {
    const bytes = readFileSync(join(site, name));
    if (!newer) return bytes;
    if (name === "service-worker.js") return Buffer.from(bytes.toString().replace(/VERSION = "/, '$&newer-'));
    return name === "about.html" ? Buffer.from(bytes.toString().replace("<h1>About these pages", "<h1>Newer pages")) : bytes;
  });
  const page = await open(`${server.address}polygons-gjk.html`);
  const context = page.context();
  await page.evaluate(() => navigator.serviceWorker.ready);
  assert.deepEqual(page.complaints, []);
  await context.setOffline(true);
  for (const name of ["", "index.html", "playground.html", "practice.html", ...pages.filter((_, i) => i % 9 === 0)]) {
    const visit = await context.newPage();
    await visit.goto(server.address + name);
    if (await visit.locator("#wasm").count()) await ready(visit);
    else if (name === "index.html") {
      await visit.locator(".cards img.bright").first().scrollIntoViewIfNeeded();
      await until(visit, () => document.querySelector(".cards img.bright").naturalWidth > 0);
    }
    await visit.close();
  }
  await context.setOffline(false);
  newer = true;
  const old = await context.newPage();
  await old.goto(`${server.address}about.html`);
  assert.equal(await old.locator("h1").textContent(), "About these pages", "page and scripts are of one version");
  await until(old, async () => Boolean((await navigator.serviceWorker.getRegistration()).waiting));
  for (const each of context.pages()) await each.goto("about:blank");
  const fresh = await context.newPage();
  for (let i = 0; i < 20 && (await fresh.locator("h1").count() === 0 || (await fresh.locator("h1").textContent()) !== "Newer pages"); ++i) {
    await fresh.goto("about:blank");
    await fresh.waitForTimeout(200);
    await fresh.goto(`${server.address}about.html`);
  }
  assert.equal(await fresh.locator("h1").textContent(), "Newer pages");
  assert.equal(await fresh.evaluate(async () => (await caches.keys()).length), 1, "what is older is forgotten");
  await context.close();
  server.close();
});

claim("the site is at most 10 MB, a further page at most 90 kB", async () => {
  const files = readdirSync(site, { recursive: true }).map((name) => join(site, name)).filter((file) => statSync(file).isFile());
  const size = (file) => statSync(file).size;
  const whole = files.reduce((sum, file) => sum + size(file), 0);
  const largest = pages.map((name) => [size(join(site, name)), name]).sort(([a], [b]) => b - a);
  console.log(`    ${files.length} files, ${whole} bytes; largest page ${largest[0].join(" ")}, middle one ${largest[largest.length >> 1][0]}`);
  assert.ok(whole <= 10e6, `${whole} bytes`);
  assert.ok(largest[0][0] <= 90e3, largest[0].join(" "));
});

claim("the program is small; how fast pages are is printed", async () => {
  const compressed = statSync(`${root}/build/wasm/web/gjkscope.wasm.gz`).size;
  // Before lessons in space it had 1,195 kB, and space may add 150.
  assert.ok(compressed <= 1.345e6, `${compressed} bytes`);
  const page = await open(url("polygons-gjk"));
  const live = Number(await page.evaluate(() => document.documentElement.dataset.ready));
  await close(page);
  console.log(`    wasm ${(compressed / 1e6).toFixed(2)} MB compressed, live after ${live} ms`);
  for (const name of ["polygons-gjk", "nearly-parallel", "polygons-motion", "lin-canny", "hierarchy-large"]) {
    const times = await timesOfADrag(url(name));
    console.log(`    ${name}: move to frame ${times[100].toFixed(1)} ms, 95 % below ${times[190].toFixed(1)} ms`);
  }
}, true);

if (shots) {
  claim("screenshots", async () => {
    for (const size of Object.keys(SIZES)) {
      for (const name of ["index", "playground", "polygons-gjk", "triangle-ordered-test", "accuracy-cost"]) {
        const page = await open(url(name), size);
        if (await page.locator("#wasm").count()) {
          for (let i = 0; i < 8; ++i) await page.locator("body").press("ArrowRight");
          await settle(page);
        }
        await page.screenshot({ path: join(shots, `${name}-${size}.png`), fullPage: size === "phone" });
        await page.context().close();
      }
    }
    for (const theme of THEMES) {
      const page = await open(url("polygons-gjk", "#step=17"));
      await page.selectOption("#theme", theme);
      await page.screenshot({ path: join(shots, `theme-${theme}.png`) });
      await page.context().close();
    }
  });
}

// Practice ----------------------------------------------------------------------------------------

/** Answers all questions of the task with the choice of a number, from 1. */
async function answerTask(page, number = 1) {
  for (;;) {
    const { question, practice } = await state(page);
    if (practice.answered) return;
    if (!question) await page.click("#step");
    else if (question.pair) for (const list of await page.locator("#choices fieldset").all()) await list.locator("button").nth(number - 1).click();
    else await page.locator("#choices button").nth(number - 1).click();
    await rest(page);
  }
}

action("practice gives task after task, and goes on where it was left", async (visit, size) => {
  // A browser that loads a file anew may forget what it keeps; of a served page it does not.
  const server = await serve(site);
  const page = await visit(`${server.address}practice.html#chapter=3&seed=7`, size);
  const seen = new Set();
  for (let i = 0; i < 4; ++i) {
    const { practice, question, shapes } = await state(page);
    assert.deepEqual([practice.chapter, practice.seed, practice.answers.length], [3, 7, i]);
    assert.ok(question, "a task begins with its question");
    assert.equal(await page.locator("#next-task").isVisible(), false);
    await page.locator("body").press("n");
    assert.equal((await state(page)).practice.answers.length, i, "an open question is not passed over");
    seen.add(JSON.stringify(shapes));
    await answerTask(page);
    assert.ok(await page.locator("#verdict").isVisible(), "the verdict stays, though the figure is laid out anew");
    if (i % 2) await page.click("#next-task");
    else await page.locator("body").press("n");
    await rest(page);
  }
  assert.equal(seen.size, 4, "each task has other shapes");
  await answerTask(page);
  await page.reload();
  await ready(page);
  assert.equal((await state(page)).practice.answers.length, 5, "a task that was answered is not asked again");
  const { practice, shapes } = await state(page);
  assert.match(await text(page, "so-far"), new RegExp(`^${practice.right} of 5 tasks right, ${practice.repeating} to repeat\\.`));
  await page.reload();
  await ready(page);
  assert.deepEqual((await state(page)).shapes, shapes);
  await page.evaluate(() => giveUp("Given up."));
  await rest(page);
  assert.deepEqual((await state(page)).shapes, shapes, "a program that was given up brings the task again");
  await page.locator("#chapters button", { hasText: "9" }).click();
  await rest(page);
  assert.equal((await state(page)).practice.chapter, 9);
  assert.match(page.url(), /#chapter=9&seed=\d+$/);
  await page.goto(`${server.address}index.html`);
  await page.locator("#memory a", { hasText: "Continue practice of chapter 3" }).click();
  await ready(page);
  assert.deepEqual((await state(page)).shapes, shapes);
  await page.goto(`${server.address}index.html`);
  await page.locator("#memory button", { hasText: "Forget" }).click();
  assert.equal(await page.locator("#memory").isVisible(), false);
  await close(page);
  await server.close();
});

claim("a task whose shapes were changed is brought back, and links to practice say what is wrong with them", async () => {
  const page = await open(url("practice", "#chapter=2&seed=1"));
  const before = (await state(page)).shapes;
  await page.evaluate(() => act({ do: "nudge", shape: "y", index: 0, right: 40, up: 0 }));
  assert.notDeepEqual((await state(page)).shapes, before);
  assert.match(await text(page, "so-far"), /Reset brings the task back/);
  await page.click("#reset");
  await rest(page);
  assert.deepEqual((await state(page)).shapes, before);
  assert.ok((await state(page)).question);
  for (const [hash, problem] of [["chapter=7", /^chapter 7 has no practice; expected one of 1, 2, 3, 4, 5, 9$/], ["chapter=x", /^link: 'chapter' is x; expected a number/], ["chapter=2&seed=-1", /^link: 'seed' is -1; expected a number/]]) {
    await page.evaluate((to) => { location.hash = to; }, hash);
    await page.locator("#problem").filter({ hasText: "expected" }).waitFor();
    assert.match(await text(page, "problem"), problem);
    assert.deepEqual((await state(page)).shapes, before);
    await page.evaluate(() => say(""));
  }
  await close(page);
});

claim("a direction that is asked for is dragged from P, and the shape below stays where it is", async () => {
  const page = await open(url("polygon-evolution"));
  await page.locator("body").press("p");
  for (;;) {
    await toQuestion(page);
    if (await page.evaluate(() => state.question.origin)) break;
    await page.locator("#choices button").first().click();
    await rest(page);
  }
  const [from, scale] = await page.evaluate(() => {
    const svg = document.querySelector("#stage svg");
    svg.scrollIntoView({ block: "nearest" });
    const box = svg.getBoundingClientRect();
    const one = box.width / svg.viewBox.baseVal.width;
    const [x, y] = state.question.origin;
    return [[box.left + one * x, box.top + one * y], one];
  });
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move(from[0] + 90 * scale, from[1] - 30 * scale, { steps: 5 });
  assert.equal(await page.locator("#stage .aim").count(), 1);
  await page.mouse.up();
  await rest(page);
  assert.match(await text(page, "verdict"), /^(Right: towards Q|Not \S.*: the run says towards Q)\. Yours is turned by [\d.]+°\./);
  assert.ok(await page.locator("#undo").isDisabled());
  await close(page);
});

claim("practice works where nothing can be kept, and its page says nothing of the answer", async () => {
  const init = () => Object.defineProperty(window, "localStorage", { get() { throw new Error("no storage"); } });
  const page = await open(url("practice", "#chapter=1&seed=3"), "laptop", { init });
  const { question } = await state(page);
  assert.ok(question);
  assert.equal(await page.locator(".transcript").isVisible(), false);
  assert.equal(await page.locator(".transcript li").count(), 0);
  await answerTask(page, 2);
  await page.click("#next-task");
  await rest(page);
  assert.equal((await state(page)).practice.answers.length, 1);
  await close(page);
});

const wanted = tests.filter((test) => test.name.includes(only));
async function check({ name, body }) {
  const began = performance.now();
  try {
    await body();
    console.log(`ok      ${name} (${((performance.now() - began) / 1000).toFixed(1)} s)`);
  } catch (error) {
    failures.push(name);
    console.log(`FAILED  ${name}\n${String(error.stack ?? error).replace(/^/gm, "        ")}`);
  }
}

const began = performance.now();
const together = wanted.filter((test) => !test.alone);
const lane = async () => {
  for (let test = together.shift(); test; test = together.shift()) await check(test);
};
await Promise.all([lane(), lane()]);
for (const test of wanted.filter(({ alone }) => alone)) await check(test);
await browser.close();
console.log(`${wanted.length - failures.length} of ${wanted.length} claims hold, in ${((performance.now() - began) / 1000).toFixed(0)} s`);
process.exit(failures.length ? 1 : 0);
