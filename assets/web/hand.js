"use strict";

// Pointers on the stage: drags, swipes, and what lights up.

let held = null;
let pointed = null;  // the mouse, on the picture
let lit = null;  // what lights up belongs to this place
let snaps = false;  // to round numbers; Shift does the other thing

/** The place of an event on the picture, in its own pixels. */
function placeOf(event) {
  const svg = $("stage").querySelector("svg");
  const box = svg.getBoundingClientRect();
  const scale = svg.viewBox.baseVal.width / box.width;
  return { x: (event.clientX - box.left) * scale, y: (event.clientY - box.top) * scale };
}

const FINGER = 24;  // pixels that a finger reaches, as the program has it

/**
 * Whether the marks that are shown have a vertex or a shape within `reach` pixels. The program says what is held; but a
 * browser asks at once whether it may scroll.
 */
function isOverShape({ clientX, clientY }, reach) {
  const stage = $("stage");
  const isHeld = (mark) => /^([xyz] |[XYZ]$|node )/.test(mark.dataset.of ?? "");
  const isArea = (x, y) => document.elementsFromPoint(x, y).some((mark) => stage.contains(mark) && isHeld(mark));
  const around = Array.from({ length: 8 }, (_, i) => i * Math.PI / 4);
  if (isArea(clientX, clientY) || around.some((turn) => isArea(clientX + reach * Math.cos(turn), clientY + reach * Math.sin(turn))))
    return true;
  const pointSize = 32;
  return [...stage.querySelectorAll("[data-of]")].filter(isHeld).map((mark) => mark.getBoundingClientRect()).some((box) =>
    Math.max(box.width, box.height) <= pointSize && clientX > box.left - reach && clientX < box.right + reach &&
    clientY > box.top - reach && clientY < box.bottom + reach);
}

/** A second finger: the two turn space, whatever lies below them. */
function onSecond(event) {
  if (!state.eye || !held.touch || held.second) return;
  event.preventDefault();
  $("stage").setPointerCapture(event.pointerId);
  held.second = { id: event.pointerId, at: placeOf(event) };
  act({ do: "cancel" });
  act({ do: "press", ...middleOf(held), ground: true });
}

function middleOf({ last, second }) {
  return { x: (last.x + second.at.x) / 2, y: (last.y + second.at.y) / 2 };
}

function onDown(event) {
  if (event.button !== 0) return;
  if (held) return onSecond(event);
  pointed = lit = null;
  endMotion();
  stop();
  const touch = event.pointerType !== "mouse";
  if (aimsFrom(placeOf(event))) {
    held = { id: event.pointerId, aims: true };
    $("stage").setPointerCapture(event.pointerId);
    event.preventDefault();
    return;
  }
  const press = { id: event.pointerId, drags: Boolean(state.eye) || isOverShape(event, touch ? FINGER : 14), from: placeOf(event), last: placeOf(event), at: { x: event.clientX, y: event.clientY }, touch };
  held = press;
  if (!press.drags) {
    // A press beside the shapes selects none.
    if ($("stage").querySelector("[data-mark=handle]")) act({ do: "press", ...press.from });
    return;
  }
  $("stage").classList.add("drags");
  $("stage").setPointerCapture(event.pointerId);
  event.preventDefault();
  act({ do: "press", ...press.from, ...(touch && { finger: true }) }).then(() => {
    if (state.dragging) return tell("");
    press.drags = false;
    $("stage").classList.remove("drags");
  });
}

/** A direction that is asked for is dragged from a point: whether this is the place. */
function aimsFrom({ x, y }) {
  const [left, top] = state.question?.origin ?? [];
  return Math.hypot(x - left, y - top) < FINGER;
}

/** The direction that is dragged. */
function drawAim({ x, y }) {
  const svg = $("stage").querySelector("svg");
  const line = svg.querySelector(".aim") ?? svg.appendChild(document.createElementNS(svg.namespaceURI, "line"));
  const [left, top] = state.question.origin;
  line.setAttribute("class", "aim");
  for (const [name, value] of Object.entries({ x1: left, y1: top, x2: x, y2: y })) line.setAttribute(name, value);
}

function onMove(event) {
  if (held?.aims) {
    if (event.pointerId === held.id) drawAim(placeOf(event));
    return;
  }
  if (held && event.pointerId === held.id) held.last = placeOf(event);
  if (held?.second) {
    if (event.pointerId === held.second.id) held.second.at = placeOf(event);
    act({ do: "move", ...middleOf(held) });
  } else if (held?.drags && event.pointerId === held.id) {
    act({ do: "move", ...placeOf(event), ...(snaps !== event.shiftKey && { snaps: true }) });
  } else if (!held && event.pointerType === "mouse") {
    pointed = placeOf(event);
    light(pointed);
  }
}

/** A double click beside an edge adds a vertex. */
function onDoubleClick(event) {
  act({ do: "add", ...placeOf(event), ...(snaps !== event.shiftKey && { snaps: true }) });
}

function toggleSnaps() {
  snaps = !snaps;
  tell(snaps ? "Drags go to round numbers." : "Drags go anywhere.");
}

/** Ends a drag as if it had not been. */
function letGo() {
  dropHand();
  act({ do: "cancel" });
}

function dropHand() {
  held = null;
  $("stage").classList.remove("drags");
}

function onLeave(event) {
  if (event.pointerType !== "mouse") return;
  pointed = lit = null;
  $("stage").querySelectorAll(".ring, .near").forEach((mark) => mark.remove());
}

function onUp(event) {
  if (held?.second && [held.id, held.second.id].includes(event.pointerId)) {
    dropHand();
    act({ do: "release" });
    return;
  }
  if (!held || event.pointerId !== held.id) return;
  if (held.aims) {
    const place = placeOf(event);
    dropHand();
    $("stage").querySelector(".aim")?.remove();
    if (event.type === "pointerup" && !aimsFrom(place)) pointAtChoice(place);
    return;
  }
  const { drags, from, touch, at } = held;
  dropHand();
  if (drags) act({ do: "release" });
  const place = placeOf(event);
  light(place);
  const isClick = Math.hypot(event.clientX - at.x, event.clientY - at.y) < 5;
  if (isClick && event.type === "pointerup" && state.question) pointAtChoice({ ...place, ...(touch && { finger: true }) });
  const swiped = place.x - from.x;
  const slanted = Math.abs(place.y - from.y) > 0.6 * Math.abs(swiped);
  if (touch && !drags && event.type === "pointerup" && Math.abs(swiped) > 40 && !slanted)
    step(swiped < 0 ? 1 : -1);
}

/** The circle around a disc or a diamond; null for words and lines. */
function circleAround(mark) {
  if (mark.tagName === "circle") return ["cx", "cy", "r"].map((name) => Number(mark.getAttribute(name)));
  if (mark.tagName !== "path") return null;
  const box = mark.getBBox();
  return [box.x + box.width / 2, box.y + box.height / 2, Math.max(box.width, box.height) / 2];
}

/** A mark's own outline as a ring: of a volume, which no circle fits. */
function outlineOf(mark, name) {
  const ring = document.createElementNS(mark.namespaceURI, "path");
  ring.setAttribute("class", "ring");
  ring.setAttribute("d", mark.getAttribute("d"));
  ring.dataset.lit = name;
  return ring;
}

/** A mark that is pointed at lights up, and those that belong to it. */
async function light(place) {
  lit = place;
  const found = await ask({ do: "point", ...place });
  if (!found?.linked || lit !== place) return;
  const svg = $("stage").querySelector("svg");
  svg.querySelectorAll(".ring, .near").forEach((mark) => mark.remove());
  if (found.names) {
    svg.insertAdjacentHTML("beforeend", unstyled(found.names));
    svg.lastElementChild.classList.add("near");
  }
  $("stage").classList.toggle("holds", /^[xyXYzZ]/.test(found.of));
  for (const name of found.linked) {
    if (!/^(node )?[xyz] /.test(name)) continue;
    for (const mark of svg.querySelectorAll(`[data-of="${name}"]`)) {
      if (name.startsWith("node ") && mark.tagName === "path") {
        svg.append(outlineOf(mark, name));
        continue;
      }
      const circle = circleAround(mark);
      if (!circle) continue;
      const ring = document.createElementNS(svg.namespaceURI, "circle");
      ring.setAttribute("class", "ring");
      ring.setAttribute("cx", circle[0]);
      ring.setAttribute("cy", circle[1]);
      ring.setAttribute("r", circle[2] + 5);
      ring.dataset.lit = name;
      svg.append(ring);
    }
  }
}
