"use strict";

const $ = (id) => document.getElementById(id);
const data = JSON.parse($("data").textContent);
const root = document.documentElement;
const PLAY_MS = 1800;
const MOST_LINK_BYTES = 1 << 21;

let ask = null;
let state = null;
let endMotion = () => {};
let playing = 0;
let hex = false;
let zoom = 1;  // of pictures and type: a projector is looked at from afar

// What is shown -----------------------------------------------------------------------------------

function element(name, properties = {}, ...children) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
}

/** Says what went wrong until something goes right. */
function say(problem) {
  $("problem").textContent = problem;
  $("problem").hidden = !problem;
}

/** Asks the program, and shows what it answers. */
function act(request, moves = false) {
  let next;
  try {
    next = ask(request);
  } catch (error) {
    // A trap: the program's memory is not to be trusted from here on.
    ask = () => ({ problem: "the program has stopped; reload the page" });
    next = { problem: `the program has stopped: ${error.message}; reload the page` };
  }
  if (next.problem !== undefined) {
    say(next.problem);
    return false;
  }
  say("");
  show(next, moves);
  return true;
}

/** Puts a picture into its place; what it says becomes its name. */
function put(host, markup, role, moves) {
  const template = document.createElement("template");
  template.innerHTML = markup;
  const svg = template.content.querySelector("svg");
  const title = svg.querySelector("title");
  svg.setAttribute("role", role);
  svg.setAttribute("aria-label", title.textContent);
  title.remove();
  const before = host.querySelector("svg");
  host.replaceChildren(svg);
  const same = before && before.getAttribute("viewBox") === svg.getAttribute("viewBox");
  const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
  if (moves && same && !still) endMotion = animate(before, svg);
}

function show(next, moves) {
  const last = state;
  state = { ...last, ...next, question: next.question };
  endMotion();
  endMotion = () => {};
  put($("stage"), state.stage, "img", moves);
  $("panel").hidden = !state.panel;
  if (state.panel) putPanel();
  put($("timeline"), state.timeline, "img", false);
  setText("prose", state.prose);
  setText("position", state.position);
  setText("caption", state.caption);
  setText("detail", state.detail);
  const scrub = $("scrub");
  scrub.max = state.count;
  scrub.value = state.index + 1;
  scrub.setAttribute("aria-valuetext", `${state.position}: ${state.caption}`);
  $("count").textContent = `${state.index + 1} / ${state.count}`;
  $("back").disabled = $("iteration-back").disabled = state.index === 0;
  const atEnd = state.index + 1 === state.count;
  $("iteration").disabled = atEnd;
  $("step").disabled = atEnd || Boolean(state.question && next.question);
  if (!next.numbers) return;  // while dragging
  showTools(next, last);
  showNumbers();
  showVertices();
  showNumerics();
  markTranscript();
  if (last && (last.index !== state.index || last.changed !== state.changed)) keepLink();
}

/** Text that is the same is left alone, so that it is not announced again. */
function setText(id, text) {
  if ($(id).textContent !== text) $(id).textContent = text;
}

/** The lines of the pseudocode are buttons: to the next step that takes them. */
function putPanel() {
  const focused = document.activeElement?.dataset?.of;
  put($("panel"), state.panel, "group", false);
  // A panel too wide for its place is squeezed, so that type keeps its height.
  const svg = $("panel").querySelector("svg");
  svg.setAttribute("preserveAspectRatio", "none");
  svg.style.height = `${svg.viewBox.baseVal.height * zoom}px`;
  const seen = new Set();
  for (const mark of $("panel").querySelectorAll('text[data-of^="phase"]')) {
    if (seen.has(mark.dataset.of)) continue;
    seen.add(mark.dataset.of);
    mark.setAttribute("tabindex", "0");
    mark.setAttribute("role", "button");
    mark.setAttribute("aria-label", `Go to the next step of: ${mark.textContent}`);
    if (mark.dataset.of === focused) mark.focus({ preventScroll: true });
  }
}

function showTools(next, last) {
  $("undo").disabled = !state.undo;
  $("undo").title = state.undo ? `Undo: ${state.undo} (U)` : "Undo (U)";
  $("redo").disabled = !state.redo;
  $("reset").disabled = !state.changed;
  $("predict").setAttribute("aria-pressed", state.predicting);
  const asks = next.question;
  $("question").hidden = !asks;
  if (asks) {
    setText("question-text", state.caption);
    $("choices").replaceChildren(
      ...asks.choices.map((choice) =>
        element("button", { type: "button", textContent: choice, onclick: () => choose(choice) })));
  }
  const graded = next.answers && (!last?.answers || last.answers.asked !== next.answers.asked);
  $("verdict").hidden = !graded;
  if (graded) {
    const { chosen, answer, right, asked } = next.answers;
    const isRight = chosen === answer;
    $("verdict").className = isRight ? "right" : "wrong";
    const said = isRight ? `Right: ${answer}.` : `Not ${chosen}: the run says ${answer}.`;
    setText("verdict", `${said} ${right} of ${asked} so far.`);
  }
}

function rows(list) {
  return list.map(([name, decimal, hexadecimal]) =>
    element("tr", {},
      element("th", { scope: "row", textContent: name }),
      element("td", { textContent: hex ? hexadecimal : decimal })));
}

function tableOf(caption, list) {
  return element("table", {}, element("caption", { textContent: caption }),
    element("tbody", {}, ...rows(list)));
}

function showNumbers() {
  if ($("answer")) $("answer").replaceChildren(tableOf("Answer", state.outcome));
  if (!$("numbers-part").open) return;
  $("numbers").className = "tables";
  $("numbers").replaceChildren(tableOf("This step", state.numbers),
    tableOf("What the run comes to", state.outcome));
}

function vertexTable(key, shape) {
  const name = (text, index) =>
    element("button", {
      type: "button",
      textContent: text,
      title: "Arrow keys move it",
      onkeydown: (event) => nudge(event, key, index),
    });
  const cell = (text, index, axis) => {
    const input = element("input", { type: "text", value: text, spellcheck: false });
    input.setAttribute("aria-label", `${"xy"[axis]} of ${shape.names[index]}`);
    input.id = `${key}-${index}-${axis}`;
    input.onchange = () => {
      const [x, y] = [0, 1].map((i) =>
        i === axis ? input.value.trim() : shape.vertices[index][hex ? 2 + i : i]);
      act({ do: "vertex", shape: key, index, x, y }) || (input.value = text);
    };
    return element("td", {}, input);
  };
  const body = shape.vertices.map((vertex, i) =>
    element("tr", {}, element("th", { scope: "row" }, name(shape.names[i], i)),
      cell(vertex[hex ? 2 : 0], i, 0), cell(vertex[hex ? 3 : 1], i, 1)));
  const whole = element("tr", {}, element("th", { scope: "row" }, name(`all of ${shape.name}`, -1)),
    element("td", { colSpan: 2 }));
  return element("table", {}, element("caption", { textContent: `Shape ${shape.name}` }),
    element("thead", {}, element("tr", {}, element("th", { scope: "col", textContent: "vertex" }),
      element("th", { scope: "col", textContent: "x" }),
      element("th", { scope: "col", textContent: "y" }))),
    element("tbody", {}, ...body, whole));
}

function showVertices() {
  if (!$("vertices-part").open) return;
  const focused = [...$("vertices").querySelectorAll("button, input")].indexOf(document.activeElement);
  if (!state.shapes) {
    $("vertices").textContent = "There are too many to list.";
    return;
  }
  $("vertices").replaceChildren(vertexTable("x", state.shapes.x), vertexTable("y", state.shapes.y));
  $("vertices").classList.toggle("hex", hex);
  if (focused >= 0)
    $("vertices").querySelectorAll("button, input")[focused]?.focus({ preventScroll: true });
}

function nudge(event, shape, index) {
  const ways = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
  const way = ways[event.key];
  if (!way) return;
  event.preventDefault();
  event.stopPropagation();
  const far = event.shiftKey ? 40 : 8;
  act({ do: "nudge", shape, index, right: far * way[0], up: far * way[1] });
}

const NUMERICS = {
  scalar: "Arithmetic",
  direction: "Direction",
  regions: "Order of the region tests",
  repeated: "Stop when a support point repeats",
  progress: "Stop without progress",
};

function showNumerics() {
  const form = $("numerics");
  if (!form.children.length) {
    for (const [key, label] of Object.entries(NUMERICS)) {
      const choices = state.choices[key];
      const input = choices
        ? element("select", {}, ...choices.map((name) => element("option", { textContent: name })))
        : element("input", { type: "checkbox" });
      input.id = `numerics-${key}`;
      input.onchange = setNumerics;
      form.append(choices ? element("label", { textContent: `${label} ` }, input)
        : element("label", {}, input, label));
    }
  }
  for (const key of Object.keys(NUMERICS)) {
    const input = $(`numerics-${key}`);
    if (state.choices[key]) input.value = state.numerics[key];
    else input.checked = state.numerics[key];
  }
}

function setNumerics() {
  const request = { do: "numerics" };
  for (const key of Object.keys(NUMERICS)) {
    const input = $(`numerics-${key}`);
    request[key] = state.choices[key] ? input.value : input.checked;
  }
  if (!act(request)) showNumerics();
}

/** The transcript tells the lesson as it was written. */
function markTranscript() {
  document.querySelector(".transcript [aria-current]")?.removeAttribute("aria-current");
  if (state.changed || state.predicting) return;
  document.querySelectorAll(".transcript li")[state.index]?.setAttribute("aria-current", "step");
}

// Size and theme ----------------------------------------------------------------------------------

function themeName() {
  if ($("theme").value) return $("theme").value;
  if (matchMedia("(prefers-contrast: more)").matches) return "high-contrast";
  return matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
}

/** Pictures are laid out in the room that they have, so that type keeps its size. */
function layout(theme = themeName()) {
  zoom = Math.min(2, Math.max(1, innerWidth / 1440));
  root.style.setProperty("--zoom", zoom);
  root.dataset.theme = theme;
  const width = $("stage").clientWidth / zoom;
  const top = ($("stage").getBoundingClientRect().top + scrollY) / zoom;
  const below = 262;  // of controls, timeline and caption
  const fit = Math.max(330, innerHeight / zoom - top - below);
  const two = data.views > 1;
  const height = width < 600 ? Math.max((two ? 1.72 : 0.9) * width, 300) : Math.min((two ? 0.5 : 0.62) * width, fit);
  const panel = $("panel").hidden ? 368 : $("panel").clientWidth / zoom;
  act({ do: "layout", width, height, panel, timeline: Math.max(200, width), theme });
}

// Steps -------------------------------------------------------------------------------------------

function stop() {
  clearInterval(playing);
  playing = 0;
  $("play").setAttribute("aria-pressed", "false");
  $("play-name").textContent = "Play";
}

function play() {
  if (playing) return stop();
  if (state.index + 1 === state.count) act({ do: "go", to: 0 }, true);
  $("play").setAttribute("aria-pressed", "true");
  $("play-name").textContent = "Stop";
  playing = setInterval(() => {
    act({ do: "step", by: 1 }, true);
    if (state.index + 1 === state.count || !$("question").hidden) stop();
  }, PLAY_MS);
}

function step(by) {
  stop();
  if (by > 0 && !$("question").hidden) return;
  act({ do: "step", by }, true);
}
function iteration(by) {
  stop();
  act({ do: "iteration", by }, true);
}
function go(to, moves = true) {
  stop();
  act({ do: "go", to }, moves);
}
function choose(choice) {
  act({ do: "answer", choice }, true);
  $("step").focus();
}
function predict() {
  stop();
  act({ do: "predict", on: !state.predicting });
}

const KEYS = {
  ArrowRight: (event) => (event.shiftKey ? iteration(1) : step(1)),
  ArrowLeft: (event) => (event.shiftKey ? iteration(-1) : step(-1)),
  Home: () => go(0),
  End: () => go(state.count - 1),
  " ": play,
  u: () => act({ do: "undo" }),
  y: () => act({ do: "redo" }),
  p: predict,
};

function onKey(event) {
  const at = event.target;
  if (event.ctrlKey || event.metaKey || event.altKey || $("link").open) return;
  if (at.closest("input:not([type=checkbox]), textarea, select")) return;
  const presses = at.closest("button, summary, a, [role=button], input");
  if ((event.key === " " || event.key === "Enter") && presses) {
    if (at.getAttribute("role") === "button" && at.dataset.of) clickOn(at, event);
    return;
  }
  const does = KEYS[event.key] ?? KEYS[event.key.toLowerCase()];
  if (!does) return;
  event.preventDefault();
  does(event);
}

/** Lines of the pseudocode and ticks of the timeline. */
function clickOn(target, event) {
  const [kind, index] = (target.closest("[data-of]")?.dataset.of ?? "").split(" ");
  if (kind === "phase") {
    event.preventDefault();
    stop();
    act({ do: "phase", phase: Number(index) }, true);
  } else if (kind === "frame") {
    go(Number(index));
  }
}

// The hand ----------------------------------------------------------------------------------------

let held = null;

/** Where on the picture an event is, in its own pixels. */
function placeOf(event) {
  const svg = $("stage").querySelector("svg");
  const box = svg.getBoundingClientRect();
  const scale = svg.viewBox.baseVal.width / box.width;
  return { x: (event.clientX - box.left) * scale, y: (event.clientY - box.top) * scale };
}

function onDown(event) {
  if (event.button !== 0 || held) return;
  endMotion();
  stop();
  const place = placeOf(event);
  // The picture stays: what is touched must be there when the browser asks whether to scroll.
  const drags = ask({ do: "press", ...place }).dragging;
  held = { id: event.pointerId, drags, from: place, touch: event.pointerType !== "mouse" };
  if (!held.drags) return;
  $("stage").classList.add("drags");
  $("stage").setPointerCapture(event.pointerId);
  event.preventDefault();
}

function onMove(event) {
  if (held?.drags && event.pointerId === held.id) {
    act({ do: "move", ...placeOf(event) });
  } else if (!held && event.pointerType === "mouse") {
    light(placeOf(event));
  }
}

function onUp(event) {
  if (!held || event.pointerId !== held.id) return;
  const { drags, from, touch } = held;
  held = null;
  $("stage").classList.remove("drags");
  if (drags) act({ do: "release" });
  const place = placeOf(event);
  light(place);
  const swiped = place.x - from.x;
  const slanted = Math.abs(place.y - from.y) > 0.6 * Math.abs(swiped);
  if (touch && !drags && event.type === "pointerup" && Math.abs(swiped) > 40 && !slanted)
    step(swiped < 0 ? 1 : -1);
}

/** What is pointed at lights up, and what belongs to it. */
function light(place) {
  const found = ask({ do: "point", ...place });
  if (found.problem !== undefined) return;
  const svg = $("stage").querySelector("svg");
  svg.querySelectorAll(".ring").forEach((ring) => ring.remove());
  $("stage").classList.toggle("holds", /^[xyXYzZ]/.test(found.of));
  for (const name of found.linked) {
    if (!/^[xyz] /.test(name)) continue;
    for (const mark of svg.querySelectorAll(`[data-of="${name}"]`)) {
      if (mark.tagName !== "circle") continue;
      const ring = mark.cloneNode();
      for (const attribute of ["data-of", "data-mark", "fill", "stroke", "stroke-width"])
        ring.removeAttribute(attribute);
      ring.setAttribute("class", "ring");
      ring.setAttribute("r", Number(mark.getAttribute("r")) + 5);
      ring.dataset.lit = name;
      svg.append(ring);
    }
  }
}

// Links and files ---------------------------------------------------------------------------------

async function through(stream, bytes, most = Infinity) {
  const reader = new Blob([bytes]).stream().pipeThrough(stream).getReader();
  const parts = [];
  let size = 0;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    size += value.length;
    if (size > most) throw new Error(`it holds more than ${most} bytes`);
    parts.push(value);
  }
  return new Uint8Array(await new Blob(parts).arrayBuffer());
}

async function packed(text) {
  const bytes = await through(new CompressionStream("deflate-raw"), new TextEncoder().encode(text));
  const base64 = btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
  return base64.replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}
async function unpacked(text) {
  const bytes = bytesOf(text.replaceAll("-", "+").replaceAll("_", "/"));
  const all = await through(new DecompressionStream("deflate-raw"), bytes, MOST_LINK_BYTES);
  return new TextDecoder().decode(all);
}

/** The address of this page at this step, with what was changed. */
async function address(more = "") {
  const here = location.href.split("#")[0];
  const link = `${here}#step=${state.index + 1}${more}`;
  if (!state.changed) return link;
  return `${link}&lesson=${await packed(ask({ do: "lesson" }).lesson)}`;
}

function keepLink() {
  try {
    if (!state.changed) history.replaceState(null, "", `#step=${state.index + 1}`);
  } catch {
    // An address that may not change, in a frame for example.
  }
}

/** Goes where the link says; what is wrong with it is said. */
async function follow(hash) {
  const text = hash.replace(/^#/, "");
  if (!text || text === "stage") return;  // the skip link
  try {
    const parts = new Map();
    for (const part of text.split("&")) {
      const at = part.indexOf("=");
      const name = at < 0 ? part : part.slice(0, at);
      parts.set(name, at < 0 ? "" : decodeURIComponent(part.slice(at + 1)));
    }
    root.classList.toggle("embed", parts.has("embed"));
    if (parts.has("lesson")) {
      const lesson = await unpacked(parts.get("lesson"));
      if (!act({ do: "replace", lesson, name: "link" })) return;
    } else if (parts.has("case")) {
      if (!act({ do: "case", text: parts.get("case"), name: "link" })) return;
    }
    const wanted = parts.get("step") ?? (/^\d+$/.test(text) ? text : null);
    layout();
    if (wanted === null) return;
    const number = /^\d{1,9}$/.test(wanted) ? Number(wanted) : 0;
    if (number < 1 || number > state.count)
      return say(`link: there is no step ${wanted.slice(0, 20)}; expected 1 to ${state.count}`);
    act({ do: "go", to: number - 1 });
  } catch (error) {
    say(`link: it is damaged (${error.message})`);
  }
}

function offer(title, text, value) {
  $("link-title").textContent = title;
  $("link-text").textContent = text;
  $("link-value").value = value;
  $("copied").textContent = "";
  $("link").showModal();
  $("link-value").select();
}

async function copy() {
  try {
    await navigator.clipboard.writeText($("link-value").value);
  } catch {
    $("link-value").select();
    document.execCommand("copy");
  }
  $("copied").textContent = "Copied.";
}

function save(name, blob) {
  const url = URL.createObjectURL(blob);
  element("a", { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 10000);
}

function fileName(ending) {
  return `${data.id}-${String(state.index + 1).padStart(4, "0")}.${ending}`;
}

function saveSvg() {
  save(fileName("svg"), new Blob([ask({ do: "frame" }).svg], { type: "image/svg+xml" }));
}

async function savePng() {
  const fonts = `<style>${$("fonts").textContent}</style>`;
  const svg = ask({ do: "frame" }).svg.replace("<title>", `${fonts}<title>`);
  const image = new Image();
  image.src = URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" }));
  await image.decode();
  const canvas = element("canvas", { width: 2 * image.width, height: 2 * image.height });
  canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
  URL.revokeObjectURL(image.src);
  canvas.toBlob((blob) => save(fileName("png"), blob), "image/png");
}

// The playground ----------------------------------------------------------------------------------

const KIT = {
  point: () => [[0, 0]],
  segment: () => [[-0.9, -0.4], [0.9, 0.4]],
  box: () => [[-0.9, -0.6], [0.9, -0.6], [0.9, 0.6], [-0.9, 0.6]],
  ngon: (n) => Array.from({ length: n }, (_, i) => {
    const turn = 2 * Math.PI * (i + 0.5) / n - Math.PI / 2;
    return [Number(Math.cos(turn).toFixed(3)), Number(Math.sin(turn).toFixed(3))];
  }),
  random: () => Array.from({ length: 3 + Math.floor(6 * Math.random()) }, () => Math.random())
    .sort()
    .map((share) => {
      const turn = 2 * Math.PI * share;
      return [Number((1.2 * Math.cos(turn)).toFixed(3)), Number((0.9 * Math.sin(turn)).toFixed(3))];
    }),
};

/** The vertices of a shape; of one with too many to list, a box in their place. */
function world(key) {
  const vertices = state.shapes?.[key].vertices ?? KIT.box();
  return vertices.map(([x, y]) => [Number(x), Number(y)]);
}
function middle(points) {
  return [0, 1].map((i) => points.reduce((sum, p) => sum + p[i], 0) / points.length);
}

function setCase(a, b) {
  act({ do: "case", text: JSON.stringify({ a, b }), name: "shapes" });
}

function setShape(key, kind) {
  const corners = Math.min(64, Math.max(3, Math.round(Number($("corners").value) || 3)));
  const [cx, cy] = middle(world(key));
  const made = KIT[kind](corners).map(([x, y]) =>
    [Number((x + cx).toFixed(3)), Number((y + cy).toFixed(3))]);
  if (key === "x") setCase(made, world("y"));
  else setCase(world("x"), made);
}

function setRandomPair() {
  const off = () => (Math.random() - 0.5) * 1.6;
  const placed = (points, dx, dy) =>
    points.map(([x, y]) => [Number((x + dx).toFixed(3)), Number((y + dy).toFixed(3))]);
  setCase(placed(KIT.random(), -1.3 + off(), off()), placed(KIT.random(), 1.3 + off(), off()));
}

function startKit() {
  for (const button of document.querySelectorAll("[data-shape]"))
    button.onclick = () => setShape(button.dataset.for, button.dataset.shape);
  $("random").onclick = setRandomPair;
  $("paste").onclick = () => act({ do: "case", text: $("case").value, name: "pasted" });
}

// The start ---------------------------------------------------------------------------------------

function connect() {
  const clicks = {
    back: () => step(-1), step: () => step(1), iteration: () => iteration(1),
    "iteration-back": () => iteration(-1), play, predict,
    undo: () => act({ do: "undo" }), redo: () => act({ do: "redo" }),
    reset: () => act({ do: "reset" }), svg: saveSvg, png: savePng, copy,
    share: async () => offer("Share", "This link holds the lesson, the step and what was changed.", await address()),
    embed: async () => offer("Embed", "This line shows the figure in another page.",
      `<iframe src="${(await address("&embed")).replaceAll('"', "%22")}" width="960" height="720" title="${document.title.replaceAll('"', "&quot;")}"></iframe>`),
  };
  for (const [id, does] of Object.entries(clicks)) $(id).onclick = does;
  $("scrub").oninput = () => go(Number($("scrub").value) - 1, false);
  $("theme").onchange = () => {
    try {
      localStorage.setItem("gjkscope-theme", $("theme").value);
    } catch {
      // A page without storage forgets the theme.
    }
    layout();
  };
  $("hex").onchange = () => {
    hex = $("hex").checked;
    showNumbers();
    showVertices();
  };
  $("numbers-part").ontoggle = showNumbers;
  $("vertices-part").ontoggle = showVertices;
  for (const id of ["panel", "timeline"]) $(id).onclick = (event) => clickOn(event.target, event);
  const stage = $("stage");
  stage.onpointerdown = onDown;
  stage.onpointermove = onMove;
  stage.onpointerup = stage.onpointercancel = onUp;
  // Only this keeps a page from scrolling under a finger that drags.
  stage.addEventListener("touchstart", (event) => held?.drags && event.preventDefault(), { passive: false });
  document.addEventListener("keydown", onKey);
  document.querySelector(".transcript").onclick = (event) => {
    const link = event.target.closest("a");
    if (!link) return;
    event.preventDefault();
    act({ do: "reset" });
    go([...document.querySelectorAll(".transcript a")].indexOf(link));
    stage.scrollIntoView({ block: "nearest" });
  };
  addEventListener("hashchange", () => follow(location.hash));
  let wide = innerWidth;
  addEventListener("resize", () => {
    // The bars of a phone come and go while one scrolls.
    if (innerWidth === wide && innerWidth < 700) return;
    wide = innerWidth;
    layout();
  });
  for (const query of ["(prefers-color-scheme: dark)", "(prefers-contrast: more)"])
    matchMedia(query).onchange = () => layout();
  addEventListener("beforeprint", () => layout("print"));
  addEventListener("afterprint", () => layout());
  if (data.kind === "playground") startKit();
}

async function start() {
  try {
    $("theme").value = localStorage.getItem("gjkscope-theme") ?? "";
  } catch {
    // As in the theme's own handler.
  }
  const wasm = await through(new DecompressionStream("gzip"), bytesOf($("wasm").textContent));
  ask = await startPlayerWith(wasm, $("fonts").textContent, data.themes);
  const { lesson, name, files } = data;
  const depth = data.kind === "playground" ? true : undefined;
  const opened = ask({ do: "open", lesson, name, files, depth });
  if (opened.problem !== undefined) throw new Error(opened.problem);
  state = opened;
  root.classList.add("js");
  connect();
  layout();
  await document.fonts.ready;
  // Two shapes are asked for their distance first; how it was found comes after.
  if (data.kind === "playground") act({ do: "go", to: state.count - 1 });
  await follow(location.hash);
  root.dataset.ready = Math.round(performance.now());
}

start().catch((error) => say(`The figure cannot be made live here: ${error.message}. The first frame and all words are below.`));
