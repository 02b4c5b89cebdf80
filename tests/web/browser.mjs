// The pages in a real browser, by pointer, touch and keys. Each test is a claim; the first thing
// that does not hold ends it. An action is tried in four pairs of a size and a theme, so that each
// size and each theme is among them; with --all, in all twelve pairs.
// Usage: node browser.mjs SITE [--shots DIR] [--only WORD] [--all]
import assert from "node:assert/strict";
import { mkdirSync, readFileSync, readdirSync, statSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { deflateRawSync } from "node:zlib";
import { chromium } from "playwright-core";

import { read, root, startProgram } from "./program.mjs";

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
const url = (name, hash = "") => pathToFileURL(join(site, `${name}.html`)).href + hash;

const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
    "--disable-component-update", "--disable-sync"],
});
const failures = [];

const ready = (page) => page.locator("html[data-ready]").waitFor({ state: "attached" });

/** A page that must not complain, nor ask anybody for anything. */
async function open(address, size = "laptop", { theme, ...more } = {}) {
  const { width, height, touch } = SIZES[size];
  const context = await browser.newContext({ viewport: { width, height }, hasTouch: Boolean(touch), acceptDownloads: true, ...more });
  const page = await context.newPage();
  page.complaints = [];
  page.on("console", (message) => message.type() === "error" && page.complaints.push(message.text()));
  page.on("pageerror", (error) => page.complaints.push(String(error)));
  page.on("request", (request) => {
    if (!/^(data:|blob:)/.test(request.url()) && !request.isNavigationRequest()) page.complaints.push(`asks for ${request.url()}`);
  });
  if (theme) await page.addInitScript((name) => localStorage.setItem("gjkscope-theme", name), theme);
  await page.goto(address);
  if (more.javaScriptEnabled !== false && (await page.locator("#wasm").count()))
    await ready(page);
  if (theme) assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), theme);
  return page;
}

async function close(page) {
  assert.deepEqual(page.complaints, []);
  await page.context().close();
}

const tests = [];
/** One that is `alone` measures time, so nothing runs beside it. */
const claim = (name, body, alone = false) => tests.push({ name, body, alone });
let actions = 0;
/**
 * What a hand does: `body` gets how to open a page at a size and in a theme. Each action starts with
 * the next size, so that over all actions all pairs are tried.
 */
function action(name, body, sizes = Object.keys(SIZES)) {
  const pairs = process.argv.includes("--all")
    ? sizes.flatMap((size) => THEMES.map((theme) => [size, theme]))
    : THEMES.map((theme, i) => [sizes[(i + actions) % sizes.length], theme]);
  ++actions;
  for (const [size, theme] of pairs)
    claim(`${size}, ${theme}: ${name}`, () => body((address, at = size) => open(address, at, { theme }), size, theme));
}
/** All that the page asked its program for is shown. */
async function rest(page) {
  for (let i = 0; i < 2; ++i)
    await page.waitForFunction(() => typeof waiting === "undefined" || (!sent && !waiting.length), null, { polling: 4, timeout: 60000 });
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

const state = async (page) => (await rest(page), page.evaluate(() => ({ index: state.index, count: state.count, changed: state.changed,
  caption: state.caption, outcome: state.outcome, shapes: state.shapes, numerics: state.numerics })));
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
  await page.locator("#scrub").focus();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowRight");
  assert.deepEqual(await count(page), [3, all]);
  assert.equal(await text(page, "caption"), (await state(page)).caption);
  await page.waitForFunction(() => location.hash === "#step=3");
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
}, ["phone"]);

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
  await page.uncheck("#numerics-repeated");
  assert.equal((await state(page)).numerics.repeated, false);
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
  assert.ok(await page.locator("#question").isVisible());
  await page.locator("#choices button", { hasText: new RegExp(`^${right}$`) }).click();
  assert.match(await text(page, "verdict"), new RegExp(`^Right: ${right}\\. 1 of 2 so far`));
  await close(page);
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
  await follow("#lesson=%%%", /^link: it is damaged/);
  await follow("#lesson=AAAA", /^link: it is damaged/);
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
  assert.equal(await page.locator("#stage b, #stage img, #panel img, main script").count(), 0);
  assert.match(await page.title(), /^Polygon to polygon/);
  await close(page);
});

// The playground ----------------------------------------------------------------------------------

action("the playground answers for shapes of the kit", async (visit, size) => {
  const page = await visit(url("playground"), size);
  assert.equal((await count(page))[0], (await count(page))[1], "it opens at the answer");
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
  assert.match(await text(page, "problem"), /^pasted:1:1: 'vertices' has 10001 entries; expected 1 to 10000/);
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
    [`{"a": [${'"far",\n'.repeat(2.5e5)}0], "b": [[3, 4]]}`, /^pasted:1:8: \/a\/0 is a string; expected two coordinates, \[x, y\]$/m],
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

claim("after a long case no vertices of the shapes before are listed, and the kit keeps the long shape", async () => {
  const page = await open(url("playground"));
  await page.locator("#vertices-part summary").click();
  await paste(page, { a: ring(1000, 0), b: [[5, 0], [6, 0]] });
  assert.equal(await text(page, "vertices"), "There are too many to list.");
  await page.click('[data-for="y"][data-shape="point"]');
  assert.ok(Math.abs((await distance(page)) - 4.5) < 1e-9, "X is still the polygon of 1,000");
  await close(page);
});

claim("a view of many vertices has some 24 names, those of the run among them", async () => {
  const page = await open(url("playground"));
  for (const n of [40, 64, 100, 150, 200, 256, 1000]) {
    await paste(page, { a: ring(n, 0, 3), b: [[5, 5], [6, 5]] });
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

claim("on a phone a question leaves the figure in sight, and a problem is seen where the hand is", async () => {
  const page = await open(url("polygons-gjk"), "phone");
  await page.locator("body").press("p");
  await toQuestion(page);
  const seen = await page.evaluate(() => document.querySelector(".bar").getBoundingClientRect().top - document.getElementById("stage").getBoundingClientRect().top);
  assert.ok(seen > 250, `${seen} pixels of the figure`);
  await close(page);
  const wrong = await open(url("playground"), "phone");
  await wrong.locator(".kit summary").click();
  await wrong.fill("#case", "POLYGON((0 0,1 0,0 1,0 0))");
  await wrong.click("#paste");
  const { top, bottom } = await wrong.evaluate(() => document.getElementById("problem").getBoundingClientRect());
  assert.ok(top >= 0 && bottom <= SIZES.phone.height, `from ${top} to ${bottom}`);
  await close(wrong);
});

claim("in the window of a browser with its bars on a small laptop the figure has half of the height and the caption is in sight", async () => {
  for (const name of ["polygons-gjk", "stop-vertex", "triangle-obtuse", "minkowski-support", "penetration-depth"]) {
    const page = await open(url(name));
    await page.setViewportSize({ width: 1366, height: 657 });
    await twoFrames(page);
    const { stage, caption } = await page.evaluate(() => ({
      stage: document.getElementById("stage").getBoundingClientRect().height,
      caption: document.getElementById("caption").getBoundingClientRect().bottom,
    }));
    assert.ok(stage >= 657 / 2, `${name}: ${stage} pixels`);
    assert.ok(caption <= 657, `${name}: the caption ends at ${caption}`);
    await close(page);
  }
});

claim("in a low window the controls stand beside the figure", async () => {
  for (const [width, height] of [[740, 360], [683, 384]]) {
    const page = await open(url("polygons-gjk", "#step=7"));
    await page.setViewportSize({ width, height });
    await twoFrames(page);
    await page.evaluate(() => document.getElementById("stage").scrollIntoView({ block: "start" }));
    const [stage, step] = await page.evaluate(() => ["stage", "step"].map((id) => {
      const box = document.getElementById(id).getBoundingClientRect();
      return { left: box.left, right: box.right, top: box.top, bottom: box.bottom };
    }));
    assert.ok(stage.bottom - stage.top <= height + 1 && stage.right <= step.left, `${width}x${height}`);
    assert.ok(step.top >= 0 && step.bottom <= height, `${width}x${height}: Step from ${step.top} to ${step.bottom}`);
    await close(page);
  }
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
  claim(`every page opens from a file of its own and steps to its end; at any size nothing scrolls sideways and no type is below 14 pixels (${half + 1} of 2)`, async () => {
    for (const name of pages.filter((_, i) => i % 2 === half)) {
      const page = await open(url(name.replace(".html", "")), "laptop");
      if (await page.locator("#wasm").count()) {
        await pressToTheEnd(page);
        const [at, all] = await count(page);
        assert.equal(at, all, name);
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
  for (const name of ["index", "about", "playground", "polygons-gjk", "accuracy-cost", "triangle-two-maps"]) {
    const page = await open(url(name), "laptop", { bypassCSP: true });
    await page.evaluate(() => document.querySelectorAll("details").forEach((part) => { part.open = true; }));
    await page.addScriptTag({ content: axe });
    for (const theme of THEMES) {
      if (await page.locator("#theme").count()) await page.selectOption("#theme", theme), await rest(page);
      else await page.evaluate((to) => { document.documentElement.dataset.theme = to; }, theme);
      const { violations } = await page.evaluate(() => axe.run());
      assert.deepEqual(violations.map((v) => `${v.id}: ${v.nodes[0].html.slice(0, 120)} ${v.nodes[0].failureSummary}`), [], `${name}, ${theme}`);
    }
    await close(page);
  }
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

/**
 * Milliseconds of its thread's processor time, sorted, that the page takes for each of 200 moves of a vertex: what else runs
 * does not count. The moves are commands of the driver, so that is where Chromium books them.
 */
async function workOfADrag(address) {
  const page = await open(address);
  const client = await page.context().newCDPSession(page);
  await client.send("Performance.enable", { timeDomain: "threadTicks" });
  const spent = async () => (await client.send("Performance.getMetrics")).metrics.find(({ name }) => name === "DevToolsCommandDuration").value;
  await page.evaluate(() => {
    const svg = document.querySelector("#stage svg").getBoundingClientRect();
    const circle = document.querySelector('#stage circle[data-of="y 0"]').getBoundingClientRect();
    window.from = { x: circle.x + circle.width / 2 - svg.x, y: circle.y + circle.height / 2 - svg.y };
    act({ do: "press", ...window.from });
  });
  const work = [];
  for (let i = 0; i < 200; ++i) {
    const before = await spent();
    await page.evaluate((turn) => {
      act({ do: "move", x: window.from.x - 30 * Math.sin(turn) - 3, y: window.from.y + 20 * Math.cos(turn) });
    }, i / 8);
    work.push(1000 * ((await spent()) - before));
  }
  await close(page);
  return work.sort((a, b) => a - b);
}

claim("pages are small; how fast they are is printed", async () => {
  const largest = Math.max(...pages.map((name) => statSync(join(site, name)).size));
  assert.ok(largest <= 3e6, `${largest} bytes`);
  const compressed = statSync(`${root}/build/wasm/web/gjkscope.wasm.gz`).size;
  assert.ok(compressed <= 1.2e6, `${compressed} bytes`);
  const page = await open(url("polygons-gjk"));
  const live = Number(await page.evaluate(() => document.documentElement.dataset.ready));
  await close(page);
  console.log(`    largest page ${(largest / 1e6).toFixed(2)} MB, wasm ${(compressed / 1e6).toFixed(2)} MB compressed, live after ${live} ms`);
  for (const name of ["polygons-gjk", "nearly-parallel", "polygons-motion", "lin-canny"]) {
    const work = await workOfADrag(url(name));
    console.log(`    ${name}: drag to frame ${work[100].toFixed(1)} ms, 95 % below ${work[190].toFixed(1)} ms of processor time`);
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
