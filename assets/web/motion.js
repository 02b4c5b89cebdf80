"use strict";

const MOTION_MS = 280;
const NUMERIC = ["cx", "cy", "r", "x", "y", "width", "height"];
const PATH_NUMBER = /-?\d+(?:\.\d+)?/g;

/** Marks by what they are and stand for, so that those of two pictures can be paired. */
function marksOf(svg) {
  const seen = new Map();
  const marks = new Map();
  for (const mark of svg.querySelectorAll("[data-mark]")) {
    const what = mark.tagName === "text" ? mark.textContent : (mark.dataset.of ?? "");
    const name = `${mark.tagName}|${mark.dataset.mark}|${what}`;
    const count = (seen.get(name) ?? 0) + 1;
    seen.set(name, count);
    marks.set(`${name}|${count}`, mark);
  }
  return marks;
}

/** How `to` comes from `from`: a function of the share of the way; nothing where nothing moves. */
function wayOf(from, to) {
  const moves = [];
  for (const name of NUMERIC) {
    const end = to.getAttribute(name);
    const a = parseFloat(from.getAttribute(name));
    const b = parseFloat(end);
    if (a !== b && Number.isFinite(a) && Number.isFinite(b))
      moves.push((t) => to.setAttribute(name, t < 1 ? a + (b - a) * t : end));
  }
  const before = from.getAttribute("d");
  const after = to.getAttribute("d");
  if (before !== after && before && after) {
    const a = before.match(PATH_NUMBER).map(Number);
    const b = after.match(PATH_NUMBER).map(Number);
    // A line that becomes one with more corners only fades.
    if (a.length !== b.length) return null;
    moves.push((t) => {
      let i = 0;
      const between = () => a[i] + (b[i] - a[i++]) * t;
      to.setAttribute("d", t < 1 ? after.replace(PATH_NUMBER, between) : after);
    });
  }
  return moves.length ? (t) => moves.forEach((move) => move(t)) : undefined;
}

/**
 * Moves what is in both pictures from where it was to where it is, lets what is new appear and what
 * is gone fade. `after` is shown; returns a function that ends the motion at once.
 */
function animate(before, after) {
  const old = marksOf(before);
  const ways = [];
  for (const [name, mark] of marksOf(after)) {
    const from = old.get(name);
    old.delete(name);
    const way = from && wayOf(from, mark);
    if (way) ways.push(way);
    if (from && way !== null) continue;
    const opacity = (t) => (t < 1 ? mark.setAttribute("opacity", t) : mark.removeAttribute("opacity"));
    ways.push(opacity);
  }
  const gone = [...old.values()].filter((mark) => mark.tagName !== "text");
  for (const mark of gone) {
    mark.removeAttribute("data-of");
    after.append(mark);
    ways.push((t) => mark.setAttribute("opacity", 1 - t));
  }
  if (!ways.length) return () => {};
  const start = performance.now();
  let frame = 0;
  const put = (t) => ways.forEach((way) => way(t));
  const end = () => {
    cancelAnimationFrame(frame);
    put(1);
    gone.forEach((mark) => mark.remove());
  };
  const go = (now) => {
    const t = Math.min(1, Math.max(0, (now - start) / MOTION_MS));
    if (t === 1) return end();
    put(t * t * (3 - 2 * t));
    frame = requestAnimationFrame(go);
  };
  put(0);
  frame = requestAnimationFrame(go);
  return end;
}
