"use strict";

// Practice: tasks of a chapter, one after the other. This browser remembers where one stopped.

const MOST_SEED = 1e9;

/** Practice of a chapter, of the last one unless another is given, from where it was left; with another seed from its start. */
function wantedPractice({ chapter, seed } = {}) {
  const { practice, lastPractice } = remembered();
  const wanted = chapter ?? lastPractice ?? 1;
  const known = practice[wanted];
  const from = seed ?? known?.seed ?? Math.floor(MOST_SEED * Math.random());
  return { chapter: wanted, seed: from, answers: known?.seed === from ? known.answers : [] };
}

/** The practice that a link names. */
function followPractice(parts) {
  const number = (name) => {
    if (!parts.has(name)) return undefined;
    const text = parts.get(name);
    if (!/^\d{1,9}$/.test(text)) throw new Error(`'${name}' is ${text.slice(0, 20)}; expected a number of at most nine digits`);
    return Number(text);
  };
  return practise(wantedPractice({ chapter: number("chapter"), seed: number("seed") }));
}

/** Figure and question are in sight, before what stands above them. */
function lookAtTask() {
  const isInSight = $("question").getBoundingClientRect().bottom <= innerHeight;
  $("stage").scrollIntoView({ block: isInSight ? "nearest" : "start" });
}

/** Shows a task, and notes where one stands. */
async function showTask(request) {
  if (await act(request)) lookAtTask();
}

const practise = (wanted) => showTask({ do: "practise", ...wanted });

async function nextTask() {
  if (state.practice.answered) await showTask({ do: "task" });
}

function showPractice(last) {
  const { chapter, chapters, answers, right, repeating, answered, seed } = state.practice;
  if (!$("chapters").querySelector("button")) {
    $("chapters").append(...chapters.map((each) =>
      element("button", { type: "button", textContent: each, onclick: () => practise(wantedPractice({ chapter: each })) })));
  }
  for (const button of $("chapters").querySelectorAll("button")) button.setAttribute("aria-pressed", Number(button.textContent) === chapter);
  $("question").classList.toggle("answered", answered);
  if (answered) {
    $("choices").replaceChildren(element("button", { type: "button", id: "next-task", className: "main", textContent: "Next task", title: "Next task (N)", onclick: nextTask }));
    $("question").hidden = false;
    if (last && !last.practice.answered) lookAtTask();
  }
  const score = answers.length ? `${right} of ${answers.length} tasks right, ${repeating} to repeat. ` : "";
  const moved = state.changed ? "The shapes are others now; Reset brings the task back." : "Kinds that went wrong come again after one, three and seven others.";
  setText("so-far", score + moved);
  if (last?.practice?.answers.length !== answers.length || last.practice.chapter !== chapter) rememberPractice({ chapter, seed, answers, right, repeating });
}
