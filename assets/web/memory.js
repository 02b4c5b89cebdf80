"use strict";

// The memory of a reader, kept by this browser alone: which lessons were gone to their end, where the reader stopped, and which
// questions to repeat. Where a browser keeps nothing, pages work without.

const MEMORY = "gjkscope-memory";

/**
 * `last`: the lesson that was open last. `lessons`, by their names: `step` and `count`, where the reader stopped; `asks`,
 * whether questions were on; `done`, once the end was seen; `wrong`, the steps of questions to repeat. `practice`, by
 * chapters: `seed` and `answers`, from which its tasks follow, `right` and `repeating`; `lastPractice`: the last chapter.
 */
function remembered() {
  let kept = null;
  try {
    kept = JSON.parse(localStorage.getItem(MEMORY));
  } catch {
    // Nothing is kept, or something else is.
  }
  const isMap = (value) => value !== null && typeof value === "object" && !Array.isArray(value);
  if (!isMap(kept) || !isMap(kept.lessons)) return { lessons: {}, practice: {} };
  const isStep = (value) => Number.isInteger(value) && value > 0;
  const lessons = Object.entries(kept.lessons).filter(([, lesson]) => isMap(lesson) && isStep(lesson.step) && isStep(lesson.count) && Array.isArray(lesson.wrong) && lesson.wrong.every(isStep));
  const practice = Object.entries(isMap(kept.practice) ? kept.practice : {}).filter(([, known]) => isMap(known) && Number.isInteger(known.seed) && known.seed >= 0 && Array.isArray(known.answers) && known.answers.every((answer) => typeof answer === "boolean"));
  return { last: kept.last, lastPractice: kept.lastPractice, lessons: Object.fromEntries(lessons), practice: Object.fromEntries(practice) };
}

function keepMemory(kept) {
  try {
    localStorage.setItem(MEMORY, JSON.stringify(kept));
  } catch {
    // A page without storage forgets.
  }
}

function rememberPractice({ chapter, ...known }) {
  const kept = remembered();
  kept.lastPractice = chapter;
  kept.practice[chapter] = known;
  keepMemory(kept);
}

/** Notes what happens at a step of a lesson; `answer`: the step of a question, and whether it was right. */
function remember(name, { step, count, asks }, answer) {
  const kept = remembered();
  const lesson = kept.lessons[name] ?? { wrong: [] };
  const wrong = answer ? lesson.wrong.filter((at) => at !== answer.step) : lesson.wrong;
  if (answer && !answer.right) wrong.push(answer.step);
  kept.last = name;
  kept.lessons[name] = { step, count, asks, done: lesson.done || step === count, wrong };
  keepMemory(kept);
}

function forget() {
  try {
    localStorage.removeItem(MEMORY);
  } catch {
    // Nothing is kept.
  }
}

const stepAddress = (name, step, asks) => `${encodeURIComponent(name)}.html#step=${step}${asks ? "&ask" : ""}`;

/** On the index: a way to go on, what to repeat, and what is done. */
function showMemory() {
  const place = document.getElementById("memory");
  if (!place) return;
  const { last, lessons, practice } = remembered();
  const made = (name, properties, ...children) => {
    const element = Object.assign(document.createElement(name), properties);
    element.append(...children);
    return element;
  };
  const cards = new Map([...document.querySelectorAll(".cards a")].map((card) => [decodeURIComponent(card.getAttribute("href")).replace(/\.html$/, ""), card]));
  const title = (name) => cards.get(name).querySelector("strong").textContent;
  document.querySelectorAll(".cards .so-far").forEach((note) => note.remove());
  const known = Object.entries(lessons).filter(([name]) => cards.has(name));
  for (const [name, { step, count, done }] of known)
    cards.get(name).querySelector("strong").after(made("em", { className: "so-far", textContent: done ? "✓ done" : `step ${step} of ${count}` }));
  const practised = Object.entries(practice).filter(([, { answers }]) => answers.length);
  place.hidden = !known.length && !practised.length;
  if (place.hidden) return;
  const lines = [];
  const link = (name, step, asks, text) => made("a", { href: stepAddress(name, step, asks), textContent: text });
  if (cards.has(last) && lessons[last]) {
    const { step, count, asks } = lessons[last];
    const names = [...cards.keys()];
    const next = names[names.indexOf(last) + 1];
    if (step < count) lines.push(made("p", {}, link(last, step, asks, `Continue: ${title(last)} (step ${step} of ${count})`)));
    else if (next) lines.push(made("p", {}, link(next, 1, false, `Continue: ${title(next)}`)));
  }
  for (const [name, { wrong }] of known) {
    if (!wrong.length) continue;
    const links = wrong.flatMap((step, i) => [i ? ", " : "", link(name, step, true, `step ${step}`)]);
    lines.push(made("p", {}, `Repeat a question of “${title(name)}”: `, ...links));
  }
  for (const [chapter, { answers, right, repeating }] of practised)
    lines.push(made("p", {}, made("a", { href: `practice.html#chapter=${chapter}`, textContent: `Continue practice of chapter ${chapter}` }), `: ${right} of ${answers.length} tasks right, ${repeating} to repeat`));
  const done = known.filter(([, lesson]) => lesson.done).length;
  lines.push(made("p", { className: "note" }, `Done: ${done} of ${cards.size} lessons. Only this browser knows. `,
    made("button", { type: "button", textContent: "Forget all of it", onclick: () => forget() || showMemory() })));
  place.replaceChildren(...lines);
}

// A page that Back brings again was not loaded again.
addEventListener("pageshow", showMemory);
