"use strict";

const $ = (id) => document.getElementById(id);
const data = JSON.parse($("data").textContent);
const root = document.documentElement;
const PLAY_MS = 1800;

let ask = null;
let state = null;
let endMotion = () => {};
let playing = 0;
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
function put(host, markup, role) {
  const template = document.createElement("template");
  template.innerHTML = markup;
  const svg = template.content.querySelector("svg");
  const title = svg.querySelector("title");
  svg.setAttribute("role", role);
  svg.setAttribute("aria-label", title.textContent);
  title.remove();
  host.replaceChildren(svg);
}

/** What the mouse points at stays lit. */
function putStage(markup) {
  put($("stage"), markup, "img");
  if (pointed) light(pointed);
}

function show(next, moves) {
  const last = state;
  state = { ...last, ...next, question: next.question };
  if (next.numbers) state.shapes = next.shapes;  // none where there are too many vertices to list
  const focused = document.activeElement;
  endMotion();
  endMotion = () => {};
  if (moves && !matchMedia("(prefers-reduced-motion: reduce)").matches) endMotion = animate();
  else putStage(state.stage);
  $("panel").hidden = !state.panel;
  if (state.panel) putPanel();
  put($("timeline"), state.timeline, "img");
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
  if ($("next")) $("next").hidden = !atEnd;
  $("step").disabled = atEnd || Boolean(state.question && next.question);
  if (!next.numbers) return;  // while dragging
  showTools(next, last);
  keepFocus(focused);
  showNumbers();
  showVertices();
  showNumerics();
  markTranscript();
  if (last && (last.index !== state.index || last.changed !== state.changed)) keepLink();
}

/** A button that cannot be pressed any more hands the keyboard to what comes next. */
function keepFocus(focused) {
  if (!focused || focused === document.body || (!focused.disabled && focused.isConnected && !focused.closest("[hidden]"))) return;
  const next = $("choices").querySelector("button");
  if (next && !$("question").hidden) next.focus({ preventScroll: true });
  else ($("step").disabled ? $("back") : $("step")).focus({ preventScroll: true });
}

/** Text that is the same is left alone, so that it is not announced again. */
function setText(id, text) {
  if ($(id).textContent !== text) $(id).textContent = text;
}

/** The lines of the pseudocode are buttons: to the next step that takes them. */
function putPanel() {
  const focused = document.activeElement?.dataset?.of;
  put($("panel"), state.panel, "group");
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

// Size and theme ----------------------------------------------------------------------------------

/** The most characters that a step says. */
const longest = Math.max(...[...document.querySelectorAll(".transcript li")].map((item) => item.textContent.length));

/** Pictures are laid out in the room that they have, so that type keeps its size. */
function layout(theme = themeName($("theme").value)) {
  zoom = Math.min(2, Math.max(1, innerWidth / 1440));
  root.style.setProperty("--zoom", zoom);
  root.dataset.theme = theme;
  const width = $("stage").clientWidth / zoom;
  const top = ($("stage").getBoundingClientRect().top + scrollY) / zoom;
  // Controls and timeline, and the lines of the longest words, so that all of them are in sight.
  const [controls, lineHeight, characterWidth, widestLine] = [194, 27, 8.9, 1080];
  const below = controls + lineHeight * Math.ceil((characterWidth * longest) / Math.min(width, widestLine));
  const fit = Math.max(330, innerHeight / zoom - top - below);
  const two = data.views > 1;
  const isLow = innerHeight <= 496;  // as in style.css: the bar stands beside the figure
  const height = isLow ? Math.max(200, innerHeight / zoom - 16) : width < 600 ? Math.max((two ? 1.72 : 0.9) * width, 300) : Math.min((two ? 0.5 : 0.62) * width, fit);
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
  if (event.key === "Escape" && held?.drags) return letGo();
  if (event.altKey || $("link").open) return;
  if (at.closest("input:not([type=checkbox]), textarea, select")) return;
  if (event.ctrlKey || event.metaKey) {
    const key = event.key.toLowerCase();
    if (key !== "z" && key !== "y") return;
    event.preventDefault();
    act({ do: key === "y" || event.shiftKey ? "redo" : "undo" });
    return;
  }
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
