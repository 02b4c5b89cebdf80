"use strict";

// Room for the figure, before the program is there: nothing moves when it comes.

/** Whether this browser can run the program; then the page shows what belongs to it. */
const CAN_RUN = Boolean(window.WebAssembly && window.Worker && window.DecompressionStream);
document.documentElement.classList.toggle("js", CAN_RUN);

/** In a low window the bar has no room below the figure; in one that shows nothing else it has some more. */
function setLow() {
  const { classList } = document.documentElement;
  const height = classList.contains("embed") ? 26 : 36;
  classList.toggle("low", CAN_RUN && matchMedia(`(max-height: ${height}rem) and (min-width: 34rem)`).matches);
}
setLow();

/**
 * How large the figure is, in pixels of its own, and how much larger the page shows it: a projector
 * is looked at from afar.
 */
function makeRoom() {
  const root = document.documentElement;
  const stage = document.getElementById("stage");
  const zoom = Math.min(2, Math.max(1, innerWidth / 1440));
  setLow();
  root.style.setProperty("--zoom", zoom);
  const width = stage.clientWidth / zoom;
  const top = stage.getBoundingClientRect().top + scrollY;
  const height = heightOf(width, innerHeight - top, zoom);
  stage.style.height = `${height * zoom}px`;
  root.style.setProperty("--stage-height", stage.style.height);
  return { zoom, width, height };
}

/** "below" the figure, "over" the lower edge of the window or "beside" the figure: style.css says it. */
function placeOfBar() {
  return getComputedStyle(document.documentElement).getPropertyValue("--bar").trim();
}

/** `left`: pixels of the window from the figure's top on. */
function heightOf(width, left, zoom) {
  const two = document.body.classList.contains("two");
  const place = placeOfBar();
  // The bar takes none of the figure's height, or some at the lower edge of the window.
  if (place === "beside") return Math.max(200, left / zoom - 8);
  if (place === "over") {
    const gap = 8;
    const bottom = (id) => document.getElementById(id).getBoundingClientRect().bottom;
    const hint = Math.max(0, bottom("hint") - bottom("stage"));
    const bar = document.querySelector(".bar").offsetHeight;
    return Math.min(Math.max(200, (left - hint - gap - bar) / zoom), (two ? 1.72 : 1) * width);
  }
  // Controls and timeline, and the lines of the longest words, so that all of them are in sight.
  const [controls, lineHeight, characterWidth, widestLine] = [194, 27, 8.9, 1080];
  const choices = document.body.classList.contains("practice") ? 56 : 0;  // which are all that one does there
  const longest = Number(document.getElementById("stage").dataset.longest);
  const words = lineHeight * Math.ceil((characterWidth * longest) / Math.min(width, widestLine));
  if (document.documentElement.classList.contains("embed")) {
    const others = ["controls", "timeline", "whole"].map((name) => document.querySelector(`.${name}, #${name}`).offsetHeight);
    const [gaps, position] = [34, 27];
    const rest = others.reduce((sum, height) => sum + height, gaps) / zoom + position;
    return Math.max(0.5 * left / zoom, left / zoom - rest - words);
  }
  const most = two ? Math.max(0.5 * width, Math.min(0.8 * width, 400)) : 0.62 * width;
  return Math.min(most, Math.max(330, left / zoom - controls - words - choices));
}

// A page that was cut off on its way has no script that would start it.
addEventListener("load", () => {
  const stage = document.getElementById("stage");
  if (!CAN_RUN || !stage || document.getElementById("data")?.dataset.starts) return;
  document.documentElement.classList.remove("js");
  const problem = document.getElementById("problem");
  problem.textContent = "This page did not arrive as a whole, so nothing here can be stepped or dragged. Reload it.";
  problem.hidden = false;
});
