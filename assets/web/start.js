"use strict";

// Buttons, keys and events get what they do, and the program starts.

/** Gives up what takes long. */
function cancel() {
  giveUp("Given up: this is what was shown before.");
}

function connect() {
  const clicks = {
    back: () => step(-1), step: () => step(1), iteration: () => iteration(1),
    "iteration-back": () => iteration(-1), play, predict,
    undo: () => act({ do: "undo" }), redo: () => act({ do: "redo" }),
    reset: () => act({ do: "reset" }), svg: saveSvg, png: savePng, copy, "copy-code": copyCode, cancel,
    share: async () => stop() || offer("Share", "This link holds the lesson, the step and what was changed.", await address()),
    embed: async () => stop() || offer("Embed", "This line shows the figure in another page.",
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
  $("language").onchange = () => act({ do: "listing", language: $("language").value });
  $("hex").onchange = () => showAsHex($("hex").checked);
  $("numbers-part").ontoggle = showNumbers;
  $("vertices-part").ontoggle = showVertices;
  for (const id of ["panel", "timeline"]) $(id).onclick = (event) => clickOn(event.target, event);
  const stage = $("stage");
  stage.onpointerdown = onDown;
  stage.onpointermove = onMove;
  stage.onpointerleave = onLeave;
  stage.ondblclick = onDoubleClick;
  stage.onpointerup = stage.onpointercancel = onUp;
  // Only this keeps a page from scrolling under a finger that drags.
  stage.addEventListener("touchstart", (event) => held?.drags && event.preventDefault(), { passive: false });
  document.addEventListener("keydown", onKey);
  document.addEventListener("pointerover", (event) => event.target.closest("#term") || explain(event.target.closest(".term")));
  document.addEventListener("focusout", () => explain(null));
  document.addEventListener("focusin", (event) => explain(event.target.closest(".term")));
  $("term").onclick = () => explain(null);
  document.addEventListener("scroll", () => explain(explained), { capture: true, passive: true });
  document.querySelector(".transcript").onclick = (event) => {
    const link = event.target.closest("a");
    if (!link) return;
    event.preventDefault();
    act({ do: "reset" });
    go([...document.querySelectorAll(".transcript a")].indexOf(link));
    stage.scrollIntoView({ block: "nearest" });
  };
  addEventListener("hashchange", () => follow(location.hash));
  const whole = $("whole").querySelector("a");
  whole.onpointerdown = whole.onfocus = whole.onclick = () => { whole.href = location.href.replace(LOOKS, (part) => part.replace(/[^#]/g, "")); };
  whole.onclick();
  let wide = innerWidth;
  addEventListener("resize", () => {
    // The bars of a phone come and go while one scrolls; a frame that is not shown has no size.
    if (!innerWidth || (innerWidth === wide && innerWidth < 700 && !root.classList.contains("embed"))) return;
    wide = innerWidth;
    layout();
  });
  for (const query of ["(prefers-color-scheme: dark)", "(prefers-contrast: more)"])
    matchMedia(query).onchange = () => layout();
  addEventListener("beforeprint", showOnPaper);
  addEventListener("afterprint", layout);
  if (data.kind === "playground") startKit();
}

async function start() {
  // Steps write the address, so the link is kept first.
  const link = location.hash;
  $("data").dataset.starts = true;
  $("theme").value = chosenTheme();
  await load();
  for (const [name, text] of Object.entries(data.files)) data.files[name] = await inflated(text);
  await startProgram();
  state = await openLesson();
  connect();
  // Two shapes are asked for their distance first; how it was found comes after.
  if (data.kind === "playground") state = await ask({ do: "go", to: state.answer });
  await document.fonts.ready;
  $("hint").textContent = data.kind === "practice" ? "Point at the answer in the figure, or press its button."
    : "Drag a corner or a shape: the steps follow.";
  await layout();
  document.querySelectorAll("[inert]").forEach((part) => { part.inert = false; });
  root.dataset.live = true;
  await follow(link);
  // There the words of what it leads to take of the figure's height.
  if (link && placeOfBar() === "over") await layout();
  root.dataset.ready = Math.round(performance.now());
  tellHost("ready", shownStep());
  window.keepSite?.();
}

if (CAN_RUN) start().catch(cannotStart);
else cannotStart(new Error("this browser runs no WebAssembly"));

function cannotStart(error) {
  root.classList.remove("js");
  $("stage").style.height = "";
  say(`The figure cannot be made live here: ${error.message}. The first frame and all words are below.`);
  tellHost("problem", { message: error.message });
}
