// The time in which a page of an exported site turns space by the pointer: the program's, in its thread; the script's, from the answer until
// the picture is in the page; both, which are the page's own work; and the layout that the browser makes then. Nothing here fails; it prints.
// Usage: node turning.mjs SITE [PAGE ...]
import { resolve } from "node:path";
import { chromium } from "playwright-core";

import { serve } from "./server.mjs";

const site = resolve(process.argv[2]);
const names = process.argv.length > 3 ? process.argv.slice(3) : ["polyhedra-gjk", "tetrahedron-regions", "hill-climbing", "slab-in-space"];
const MOVES = 60;

const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: ["--no-sandbox", "--disable-gpu"] });

/** Milliseconds of each move: in the program, in the page's script, in both, and in the browser's layout. */
async function times(address) {
  const context = await browser.newContext({ viewport: { width: 1366, height: 768 }, serviceWorkers: "block" });
  const page = await context.newPage();
  await page.goto(address);
  await page.locator("html[data-ready]").waitFor({ state: "attached", timeout: 60000 });
  const box = await page.locator("#stage svg").boundingBox();
  const from = [box.x + 20, box.y + box.height / 2];
  await page.mouse.move(...from);
  await page.mouse.down();
  while (!(await page.evaluate(() => state.dragging))) await page.waitForTimeout(20);
  const [thread] = page.workers();
  await thread.evaluate(() => {
    const whole = answer;
    globalThis.spent = [];
    answer = (message) => {
      const begin = performance.now();
      const answered = whole(message);
      if (message.includes('"move"')) globalThis.spent.push(performance.now() - begin);
      return answered;
    };
  });
  const eye = () => page.evaluate(() => String(state.eye));
  const before = await eye();
  const [ofScript, ofLayout] = await page.evaluate(async ({ from: [x, y], moves }) => {
    const heard = worker.onmessage;
    const shown = window.show;
    const spent = [[], []];
    let began;
    let isShown;
    worker.onmessage = (event) => {
      began = performance.now();
      heard(event);
    };
    window.show = (...answer) => {
      shown(...answer);
      const inPage = performance.now();
      document.body.getBoundingClientRect();
      spent[0].push(inPage - began);
      spent[1].push(performance.now() - inPage);
      isShown();
    };
    for (let i = 1; i <= moves; ++i) {
      const next = new Promise((done) => { isShown = done; });
      const place = { clientX: x + 3 * i, clientY: y + i, pointerId: 1, pointerType: "mouse", bubbles: true };
      document.getElementById("stage").dispatchEvent(new window.PointerEvent("pointermove", place));
      await next;
    }
    worker.onmessage = heard;
    window.show = shown;
    return spent;
  }, { from, moves: MOVES });
  if (await eye() === before) throw new Error(`${address} does not turn`);
  const ofProgram = await thread.evaluate(() => globalThis.spent);
  await page.mouse.up();
  await context.close();
  return [ofProgram, ofScript, ofProgram.map((time, i) => time + ofScript[i]), ofLayout];
}

const leastAndMedian = (all) => {
  const sorted = [...all].sort((a, b) => a - b);
  return `${sorted[0].toFixed(1).padStart(7)} ${sorted[Math.floor(sorted.length / 2)].toFixed(1).padStart(7)}`;
};

const server = await serve(site);
console.log(`least and median of ${MOVES} moves, ms      program          script        own work          layout`);
for (const name of names) {
  const columns = await times(`${server.address}${name}.html`);
  console.log(`${name.padEnd(28)} ${columns.map(leastAndMedian).join(" ")}`);
}
server.close();
await browser.close();
