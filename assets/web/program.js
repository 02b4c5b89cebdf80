"use strict";

// The program beside the page: what is asked is answered one after the other, while the page goes
// on. Long work says so, and can be given up: then another thread goes on from the kept history.

const BUSY_MS = 150;
/** Requests of which only the newest that waits is sent. */
const NEWEST = new Set(["go", "layout", "move", "point", "tween"]);

let worker = null;
let script = null;  // the address of the worker's
let module = null;
let sent = null;
const waiting = [];
let busyTimer = 0;

/** Promises the answer to a request (docs/web.md); null when a newer one took its place, or it was given up. */
function ask(request) {
  return new Promise((done) => {
    const last = waiting.at(-1)?.message;
    const steps = last?.do === "step" && request.do === "step";
    const message = steps ? { do: "step", by: last.by + request.by } : request;
    if (steps || (last?.do === request.do && NEWEST.has(request.do))) waiting.pop().done(null);
    waiting.push({ message, done });
    sendNext();
  });
}

function sendNext() {
  if (sent || !waiting.length) return;
  sent = waiting.shift();
  const isRequest = sent.message.do !== undefined;
  worker.postMessage(isRequest ? JSON.stringify(sent.message) : sent.message);
  // Before, the page says that it gets ready.
  if (isRequest && root.dataset.live) busyTimer = setTimeout(() => showBusy(true), BUSY_MS);
}

function hear(heard) {
  if (!sent) return;
  showBusy(false);
  const { message, done } = sent;
  sent = null;
  if (heard.stopped !== undefined && message.do !== undefined) {
    done(null);
    giveUp(`The program has stopped (${heard.stopped}): this is what was shown before.`);
    return;
  }
  if (heard.module) ({ module } = heard);
  done(typeof heard === "string" ? JSON.parse(heard) : heard);
  sendNext();
}

function showBusy(on) {
  clearTimeout(busyTimer);
  const focused = document.activeElement;
  $("busy").hidden = !on;
  root.classList.toggle("working", on);
  keepFocus(focused);
}

/** The parts that a program is started from. */
let needed = null;

async function load() {
  const fetched = async (address) => {
    const answer = await fetch(address);
    if (!answer.ok) throw new Error(`${address.split("?")[0]} is not there`);
    return answer;
  };
  const { address } = $("wasm").dataset;
  const { href, textContent } = $("fonts");
  needed = {
    wasm: address ? new Uint8Array(await (await fetched(address)).arrayBuffer()) : await textOf("wasm"),
    fonts: href ? await (await fetched(href)).text() : textContent,
    assets: JSON.parse($("assets").textContent),
  };
}

/** The text of an element; of one that is in a file for all pages, when that has come and put it there. */
async function textOf(id) {
  const { dataset } = $(id);
  if (dataset.file && !$(id).textContent) {
    await new Promise((done, fail) => {
      const onerror = () => fail(new Error(`${dataset.file.split("?")[0]} is not there`));
      document.head.append(element("script", { src: dataset.file, onload: done, onerror }));
    });
  }
  return $(id).textContent;
}

/** Starts the program, in place of one that there is: what that was asked is given up. */
async function startProgram() {
  worker?.terminate();
  showBusy(false);
  for (const { done } of [sent, ...waiting.splice(0)].filter(Boolean)) done(null);
  script ??= $("worker").dataset.address ?? URL.createObjectURL(new Blob([$("worker").textContent], { type: "text/javascript" }));
  const thread = new Worker(script);
  worker = thread;
  thread.onmessage = (event) => thread === worker && hear(event.data);
  thread.onerror = (event) => thread === worker && hear({ stopped: event.message ?? "its thread does not start" });
  const started = await new Promise((done) => {
    sent = null;
    waiting.unshift({ message: { ...needed, module, wasm: module ? undefined : needed.wasm }, done });
    sendNext();
  });
  if (started?.stopped !== undefined) throw new Error(started.stopped);
}

// The kept history --------------------------------------------------------------------------------

const MOST_KEPT = 1 << 22;  // characters of lessons

/** Lessons of the history by their number, and the place in the run, as last shown. */
const kept = { lessons: new Map(), history: null, to: 0, predicting: false, layout: null };

/** Notes what another program would need to go on from here. */
async function keep({ history, index, predicting }) {
  Object.assign(kept, { history, to: index, predicting });
  if (kept.lessons.has(history.now)) return;
  const answer = await ask({ do: "lesson" });
  if (answer?.lesson !== undefined) kept.lessons.set(answer.id, answer.lesson);
  const ids = new Set([kept.history.now, ...[...kept.history.past, ...kept.history.future].map(({ id }) => id)]);
  let room = MOST_KEPT;
  for (const [id, lesson] of [...kept.lessons].reverse()) {
    room -= lesson.length;
    if (!ids.has(id) || (room < 0 && id !== kept.history.now)) kept.lessons.delete(id);
  }
}

/** The end of a list whose last entry is the present: all entries after the last one not kept. */
function known(list) {
  const from = list.findLastIndex(({ id }) => !kept.lessons.has(id)) + 1;
  return list.slice(from).map(({ id, change }) => ({ id, change, lesson: kept.lessons.get(id) }));
}

/** The lesson of the page, in a program that has just started; of practice the task that was shown. */
async function openLesson() {
  if (data.kind === "practice") return openPractice();
  const { lesson, name, files } = data;
  const depth = data.kind === "playground" ? true : undefined;
  const opened = await ask({ do: "open", lesson, name, files, depth });
  if (opened?.problem !== undefined) throw new Error(opened.problem);
  return opened;
}

async function openPractice() {
  const { chapter, seed, answers } = state?.practice ?? wantedPractice();
  const opened = await ask({ do: "practise", chapter, seed, answers });
  if (opened?.problem !== undefined) throw new Error(opened.problem);
  return opened;
}

let givenUp = 0;  // times, since something was shown

/** Gives up what the program does, and brings back what was shown before. */
async function giveUp(why) {
  const mostTimes = 3;
  if (++givenUp > mostTimes) return say("The program stops again and again; reload the page.");
  const { history, to, predicting, layout } = kept;
  kept.history = null;  // should this be given up, too, the lesson is opened as it was written
  dropHand();
  stop();
  try {
    // All of it waits before anything that one presses meanwhile.
    const started = startProgram();
    const opened = openLesson();
    if (layout) ask(layout);
    const lesson = history && !state.practice && kept.lessons.get(history.now);
    const shown = act(lesson ? { do: "restore", name: data.name, to, predicting, past: known(history.past),
      now: { id: history.now, change: "", lesson }, future: known(history.future) } : { do: "go", to: state.practice ? to : 0 });
    await Promise.all([started, opened]);
    if (await shown) tell(why);
  } catch (error) {
    say(`The program does not start again: ${error.message}. Reload the page.`);
  }
}
