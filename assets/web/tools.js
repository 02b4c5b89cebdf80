"use strict";

// Below the figure: tools, questions, numbers, vertices, options, the transcript.

let hex = false;

function showTools(next, last) {
  $("undo").disabled = !state.undo;
  $("undo").title = state.undo ? `Undo: ${state.undo} (U)` : "Undo (U)";
  $("redo").disabled = !state.redo;
  $("reset").disabled = !state.changed;
  $("predict").setAttribute("aria-pressed", state.predicting);
  showSides();
  $("question").hidden = !next.question;
  const isAsked = last?.index === next.index && last.history?.now === next.history.now && last.question?.choices.join() === next.question?.choices.join();
  if (next.question && !(isAsked && $("choices").children.length)) showChoices(next.question);
  const graded = next.answers && (!last?.answers || last.answers.asked !== next.answers.asked);
  // Another layout of the same step keeps it.
  if (last?.index !== next.index || graded) $("verdict").hidden = !graded;
  if (graded) {
    const { chosen, answer, right, asked, away, turned } = next.answers;
    const isRight = chosen === answer;
    $("verdict").className = isRight ? "right" : "wrong";
    const said = isRight ? `Right: ${answer}.` : `Not ${chosen}: the run says ${answer}.`;
    const off = away ? ` You pointed ${away} away from it.` : turned ? ` Yours is turned by ${turned}°.` : "";
    // Practice counts tasks, not questions.
    setText("verdict", `${said}${off}${state.practice ? "" : ` ${right} of ${asked} so far.`}`);
    if (last?.question && remembers()) remember(data.id, whereStopped(), { step: last.index + 1, right: isRight });
    tellHost("answer", { step: state.index + 1, chosen, answer, right: isRight, asked, correct: right });
  }
}

/** Space can be seen from sides that have names. */
function showSides() {
  const sides = $("sides");
  sides.hidden = !state.sides;
  if (sides.hidden || sides.children.length) return;
  sides.replaceChildren(...state.sides.map((to, index) =>
    element("button", { type: "button", textContent: to, title: `See it from this side: ${to} (Shift+${index + 1}; A, D, W and S turn it)`, onclick: () => act({ do: "eye", to }) })));
}

const LANGUAGES = { pseudocode: "pseudocode", cpp: "C++", python: "Python" };

/** Lessons whose listing has code can show it in each language. */
function showListing() {
  $("listing").hidden = !state.listing;
  if (!state.listing) return;
  const { language, languages } = state.listing;
  const select = $("language");
  if (!select.children.length)
    select.append(...languages.map((value) => element("option", { value, textContent: LANGUAGES[value] })));
  select.value = language;
  $("copy-code").hidden = language === "pseudocode";
}

/**
 * A question for two vertices has two short lists, which may be answered in either order. Its choices are all pairs of
 * both, in their order.
 */
function showChoices({ choices, pair, drawn }) {
  const button = (textContent, onclick) => element("button", { type: "button", textContent, onclick });
  const hint = drawn ? [element("span", { className: "drawn", textContent: "or point at it in the figure" })] : [];
  if (!pair) {
    $("choices").replaceChildren(...choices.map((choice) => button(choice, () => choose(choice))), ...hint);
    return;
  }
  const chosen = pair.map(() => null);
  $("choices").replaceChildren(...pair.map(({ of, vertices }, i) => {
    const legend = element("legend", { textContent: of });
    const list = element("fieldset", {}, legend, ...vertices.map((vertex) => button(vertex, (event) => {
      chosen[i] = vertex;
      for (const each of list.querySelectorAll("button")) each.setAttribute("aria-pressed", each === event.currentTarget);
      if (chosen.includes(null)) return;
      const [first, second] = pair.map((half, k) => half.vertices.indexOf(chosen[k]));
      choose(choices[first * pair[1].vertices.length + second]);
    })));
    list.querySelectorAll("button").forEach((each) => each.setAttribute("aria-pressed", "false"));
    return list;
  }), ...hint);
}

/** A click in the figure answers what can be pointed at there: at once, or for one of two lists. */
async function pointAtChoice(place) {
  const { index } = state;
  const { choice, half } = (await ask({ do: "choice", ...place })) ?? {};
  if (!choice || !state.question || state.index !== index) return;
  if (half === undefined) return choose(choice, place);
  const buttons = $("choices").querySelectorAll("fieldset")[half].querySelectorAll("button");
  [...buttons].find((button) => button.textContent === choice)?.click();
}

/** The choice with this number; of two lists of the first that is not answered. */
function pressChoice(number) {
  const open = [...$("choices").querySelectorAll("fieldset")].find((list) => !list.querySelector("[aria-pressed=true]"));
  (open ?? $("choices")).querySelectorAll("button")[number - 1]?.click();
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
    input.setAttribute("aria-label", `${"xyz"[axis]} of ${shape.names[index]}`);
    input.id = `${key}-${index}-${axis}`;
    input.onchange = async () => {
      const typed = { ["xyz"[axis]]: input.value.trim() };
      if (!(await act({ do: "vertex", shape: key, index, ...typed }, { about: input }))) input.value = text;
    };
    return element("td", {}, input);
  };
  const axes = [..."xyz"].slice(0, shape.vertices[0].length / 2);  // decimals, then hexadecimals
  const body = shape.vertices.map((vertex, i) =>
    element("tr", {}, element("th", { scope: "row" }, name(shape.names[i], i)),
      ...axes.map((_, axis) => cell(vertex[axis + (hex ? axes.length : 0)], i, axis))));
  const whole = element("tr", {}, element("th", { scope: "row" }, name(`all of ${shape.name}`, -1)),
    element("td", { colSpan: axes.length }));
  return element("table", {}, element("caption", { textContent: `Shape ${shape.name}` }),
    element("thead", {}, element("tr", {}, element("th", { scope: "col", textContent: "vertex" }),
      ...axes.map((axis) => element("th", { scope: "col", textContent: axis })))),
    element("tbody", {}, ...body, whole));
}

function showVertices() {
  if (!$("vertices-part").open) return;
  const focused = [...$("vertices").querySelectorAll("button, input")].indexOf(document.activeElement);
  if (!state.shapes) {
    $("vertices").textContent = "These shapes have too many vertices to list and to type. Drag them on the stage.";
    return;
  }
  $("vertices").replaceChildren(vertexTable("x", state.shapes.x), vertexTable("y", state.shapes.y));
  $("vertices").classList.toggle("hex", hex);
  if (focused >= 0)
    $("vertices").querySelectorAll("button, input")[focused]?.focus({ preventScroll: true });
}

function showAsHex(on) {
  hex = on;
  showNumbers();
  showVertices();
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

async function setNumerics(event) {
  const request = { do: "numerics" };
  for (const key of Object.keys(NUMERICS)) {
    const input = $(`numerics-${key}`);
    request[key] = state.choices[key] ? input.value : input.checked;
  }
  if (!(await act(request, { about: event.currentTarget.closest("label") }))) showNumerics();
}

/** The transcript tells the lesson as it was written. */
function markTranscript() {
  document.querySelector(".transcript [aria-current]")?.removeAttribute("aria-current");
  if (state.changed || state.predicting) return;
  document.querySelectorAll(".transcript li")[state.index]?.setAttribute("aria-current", "step");
}
