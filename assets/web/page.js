"use strict";

const $ = (id) => document.getElementById(id);
const data = JSON.parse($("data").textContent);
const root = document.documentElement;
const PLAY_MS = 1800;
const PAPER_MS = 400;

let state = null;
let playing = 0;
let paper = null;  // the pictures as they are printed
let paperTimer = 0;

// The figure and its words ------------------------------------------------------------------------

function element(name, properties = {}, ...children) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
}

/** Says what went wrong until something goes right: below the element that it is about, or above the figure. */
function say(problem, about = $("problem-place")) {
  const line = $("problem");
  const place = problem ? about : $("problem-place");
  if (line.previousElementSibling !== place) place.after(line);
  line.textContent = problem;
  line.hidden = !problem;
  if (problem && place.id !== "problem-place") line.scrollIntoView({ block: "nearest" });
}

/** A note on the figure, in the place of the hint; none leaves that empty. */
function tell(note) {
  $("hint").textContent = note;
  $("hint").classList.toggle("note", Boolean(note));
}

/**
 * Asks the program, and shows what it answers, which it returns. False when that is a problem, or nothing: a newer request took the
 * place of this one, or it was given up.
 */
async function act(request, { moves = false, about } = {}) {
  const next = await ask(request);
  if (!next) return false;
  if (next.problem !== undefined) {
    say(next.problem, about);
    return false;
  }
  givenUp = 0;
  say("");
  show(next, moves);
  return next;
}

/** A picture without the style inside that a strict policy would refuse; style.css has it. */
const unstyled = (markup) => markup.replace(/ style="[^"]*"/, "");

/** The lesson as it was written, in a page of its own. */
const remembers = () => data.kind === "lesson" && !state.changed && !root.classList.contains("embed");
const whereStopped = () => ({ step: state.index + 1, count: state.count, asks: state.predicting });

/** Puts a picture into its place, which knows it; what it says becomes its name. */
function put(host, markup, role) {
  host.markup = markup;
  const template = document.createElement("template");
  template.innerHTML = unstyled(markup);
  const svg = template.content.querySelector("svg");
  const title = svg.querySelector("title");
  svg.setAttribute("role", role);
  svg.setAttribute("aria-label", title.textContent);
  title.remove();
  host.replaceChildren(svg);
}

/** A mark that the mouse points at stays lit. */
function putStage(markup) {
  put($("stage"), markup, "img");
  if (pointed) light(pointed);
}

/** Shapes that GJK does not see as they are drawn; what was told before is over. */
function tellOfHulls() {
  const names = state.changed ? state.hulls : [];
  if (names.length)
    tell(`${names.join(" and ")} ${names.length > 1 ? "are not convex: GJK sees their hulls" : "is not convex: GJK sees its hull"}.`);
  else if ($("hint").classList.contains("note")) tell("");
}

let firstEye;  // degrees, as the lesson has it

/** Views turn under the hand, and all else stays. */
function turned(next) {
  state = { ...state, ...next };
  endMotion();
  paper = null;
  putStage(state.stage);
}

function show(next, moves) {
  const last = state;
  if (next.index === undefined) return turned(next);
  state = { ...last, ...next, question: next.question, listing: next.listing, eye: next.eye, sides: next.sides };
  firstEye ??= state.eye;
  if (next.numbers) state.shapes = next.shapes;  // none where there are too many vertices to list
  const focused = document.activeElement;
  endMotion();
  paper = null;
  if (moves && !matchMedia("(prefers-reduced-motion: reduce)").matches) endMotion = animate();
  else putStage(state.stage);
  $("panel").hidden = !state.panel;
  if (state.panel) putPanel();
  showListing();
  if ($("timeline").markup !== state.timeline) put($("timeline"), state.timeline, "img");
  setText("position", state.position);
  for (const id of ["prose", "caption", "detail"]) setWords(id, state.terms[id]);
  const scrub = $("scrub");
  scrub.max = state.count;
  scrub.value = state.index + 1;
  scrub.setAttribute("aria-valuetext", `${state.position}: ${state.caption}`);
  $("count").textContent = `${state.index + 1} / ${state.count}`;
  $("back").disabled = $("iteration-back").disabled = state.index === 0;
  const atEnd = state.index + 1 === state.count;
  $("iteration").disabled = atEnd;
  if ($("next")) $("next").hidden = !atEnd;
  $("step").disabled = atEnd || Boolean(state.question);
  tellOfHulls();
  if (!next.numbers) return;  // while dragging
  showTools(next, last);
  if (state.practice) showPractice(last);
  keepFocus(focused);
  showNumbers();
  showVertices();
  showNumerics();
  markTranscript();
  // There a question takes of the figure's height.
  if (last && Boolean(last.question) !== Boolean(state.question) && placeOfBar() === "over") layout();
  keep(next);
  if (last && (last.index !== state.index || last.history.now !== state.history.now || String(last.eye) !== String(state.eye))) keepLink();
  if (root.dataset.ready && last.index !== state.index) tellHost("step", shownStep());
  if (root.dataset.ready && remembers() && last.index !== state.index) remember(data.id, whereStopped());
  clearTimeout(paperTimer);
  paperTimer = setTimeout(async () => {
    const wanted = state;
    const printed = await ask({ do: "print" });
    if (state === wanted) paper = printed;
  }, PAPER_MS);
}

/** Paper has a theme of its own. A browser does not wait for it, so it is there before one prints. */
function showOnPaper() {
  if (!paper?.stage) return;
  endMotion();
  root.dataset.theme = "print";
  put($("stage"), paper.stage, "img");
  if (paper.panel) put($("panel"), paper.panel, "group");
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
  if ($("panel").markup === state.panel) return;
  const focused = document.activeElement?.dataset?.of;
  put($("panel"), state.panel, "group");
  layTerms($("panel"), state.terms.panel);
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

/** Pictures are laid out in the room that they have, so that type keeps its size. */
function layout() {
  const theme = themeName($("theme").value);
  root.dataset.theme = theme;
  const { zoom, width, height } = makeRoom();
  const panel = $("panel").hidden ? 368 : $("panel").clientWidth / zoom;
  kept.layout = { do: "layout", width, height, panel, timeline: Math.max(200, width), theme };
  return act(kept.layout);
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
  $("play").setAttribute("aria-pressed", "true");
  $("play-name").textContent = "Stop";
  if (state.index + 1 === state.count) act({ do: "go", to: 0 }, { moves: true });
  playing = setInterval(async () => {
    await act({ do: "step", by: 1 }, { moves: true });
    if (state.index + 1 === state.count || state.question) stop();
  }, PLAY_MS);
}

function step(by) {
  stop();
  if (by > 0 && state.question) return;
  act({ do: "step", by }, { moves: true });
}
function iteration(by) {
  stop();
  act({ do: "iteration", by }, { moves: true });
}
function go(to, moves = true) {
  stop();
  act({ do: "go", to }, { moves });
}
/** `place`: where on the picture it was pointed at. */
function choose(choice, place) {
  act({ do: "answer", choice, ...place }, { moves: true });
}
async function predict() {
  stop();
  if (await act({ do: "predict", on: !state.predicting })) $("stage").scrollIntoView({ block: "nearest" });
}

const KEYS = {
  ArrowRight: (event) => (event.shiftKey ? iteration(1) : step(1)),
  ArrowLeft: (event) => (event.shiftKey ? iteration(-1) : step(-1)),
  Home: () => go(0),
  End: () => go(state.count - 1),
  " ": play,
  u: () => act({ do: "undo" }),
  y: () => act({ do: "redo" }),
  g: toggleSnaps,
  p: () => data.asks && predict(),
  n: () => state.practice && nextTask(),
};

/** Degrees, azimuth and elevation, by which keys walk around shapes in space. */
const TURNS = { a: [-10, 0], d: [10, 0], w: [0, 10], s: [0, -10] };

function onKey(event) {
  const at = event.target;
  if (event.key === "Escape" && !$("busy").hidden) return cancel();
  if (event.key === "Escape" && held?.drags) return letGo();
  if (event.key === "Escape" && !$("link").open) return explained ? explain(null) : tellHost("leave");
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
  if (state.question && /^[1-9]$/.test(event.key)) return pressChoice(Number(event.key));
  const turn = state.eye && TURNS[event.key.toLowerCase()];
  const to = event.shiftKey && /^Digit[1-5]$/.test(event.code) && state.sides?.[event.code.at(-1) - 1];
  const looks = turn ? { azimuth: turn[0], elevation: turn[1] } : to && { to };
  const does = looks ? () => act({ do: "eye", ...looks }) : KEYS[event.key] ?? KEYS[event.key.toLowerCase()];
  const isIdle = (event.key === "ArrowRight" && state.index + 1 === state.count && !state.question) || (event.key === "ArrowLeft" && state.index === 0);
  if (!does || isIdle) return passOn(event);
  event.preventDefault();
  does(event);
}

/** Lines of the pseudocode and ticks of the timeline. */
function clickOn(target, event) {
  const [kind, index] = (target.closest("[data-of]")?.dataset.of ?? "").split(" ");
  if (kind === "phase") {
    event.preventDefault();
    stop();
    act({ do: "phase", phase: Number(index) }, { moves: true });
  } else if (kind === "frame") {
    go(Number(index));
  }
}
