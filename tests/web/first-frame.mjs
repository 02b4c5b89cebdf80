// When a page of an exported site shows its first frame, and when it can be stepped: from a disk, and from a server over a line of
// 1.6 Mbit/s with 150 ms to and fro, with an empty cache. Nothing here fails; it prints.
// Usage: node first-frame.mjs SITE [PAGE ...]
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

import { serve } from "./server.mjs";

const site = resolve(process.argv[2]);
const names = process.argv.length > 3 ? process.argv.slice(3) : ["index", "playground", "polygons-gjk", "hierarchy-large"];
const LINE = { offline: false, latency: 150, downloadThroughput: 1.6e6 / 8, uploadThroughput: 1.6e6 / 8 };
const RUNS = 3;

const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: ["--no-sandbox", "--disable-gpu"] });

/** Milliseconds from the navigation until the figure, or the first text of a page that has none, is painted; and until it is live. */
async function times(address, line) {
  const context = await browser.newContext({ viewport: { width: 1366, height: 768 }, serviceWorkers: "block" });
  const page = await context.newPage();
  const client = await context.newCDPSession(page);
  await client.send("Network.enable");
  let bytes = 0;
  client.on("Network.loadingFinished", ({ encodedDataLength }) => { bytes += encodedDataLength; });
  if (line) await client.send("Network.emulateNetworkConditions", line);
  await page.addInitScript(() => {
    const look = () => {
      const seen = [...document.querySelectorAll("#stage svg, body.index h1, body.about h1")].some((one) => one.getBoundingClientRect().height);
      if (!seen) return requestAnimationFrame(look);
      requestAnimationFrame(() => setTimeout(() => { window.firstFrame = performance.now(); }));
    };
    requestAnimationFrame(look);
  });
  await page.goto(address);
  const isLesson = await page.locator("#data").count();
  if (isLesson) await page.locator("html[data-ready]").waitFor({ state: "attached", timeout: 60000 });
  const first = await page.evaluate(() => Math.max(window.firstFrame, performance.getEntriesByName("first-contentful-paint")[0].startTime));
  const live = isLesson ? Number(await page.locator("html").getAttribute("data-ready")) : null;
  await context.close();
  return { first, live, bytes };
}

const server = await serve(site);
console.log(`largest of ${RUNS} runs              first frame      live     bytes`);
for (const name of names) {
  for (const [where, address, line] of [["disk", `${pathToFileURL(site).href}/${name}.html`, null], ["1.6 Mbit/s", `${server.address}${name}.html`, LINE]]) {
    const all = [];
    for (let i = 0; i < RUNS; ++i) all.push(await times(address, line));
    const most = (key) => Math.max(...all.map((one) => one[key]));
    console.log(`${name.padEnd(16)} ${where.padEnd(10)} ${most("first").toFixed(0).padStart(10)} ms ${(all[0].live === null ? "" : `${most("live")} ms`).padStart(9)} ${(line ? String(most("bytes")) : "").padStart(9)}`);
  }
}
server.close();
await browser.close();
