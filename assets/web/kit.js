"use strict";

// Shapes of the playground.

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

const MOST_LISTED = 20000;  // characters of a case

function middle(points) {
  return [0, 1].map((i) => points.reduce((sum, p) => sum + p[i], 0) / points.length);
}

function setCase(a, b) {
  return act({ do: "case", text: JSON.stringify({ a, b }), name: "shapes" });
}

let kitChange = Promise.resolve();

/** One after the other: each change keeps the shape that the one before made. */
function setShape(key, kind) {
  const corners = Math.min(64, Math.max(3, Math.round(Number($("corners").value) || 3)));
  kitChange = kitChange.then(async () => {
    const answer = await ask({ do: "vertices" });
    if (!answer?.x) return;
    const points = (shape) => shape.vertices.map(([x, y]) => [Number(x), Number(y)]);
    const shapes = { x: points(answer.x), y: points(answer.y) };
    const [cx, cy] = middle(shapes[key]);
    shapes[key] = KIT[kind](corners).map(([x, y]) =>
      [Number((x + cx).toFixed(3)), Number((y + cy).toFixed(3))]);
    await setCase(shapes.x, shapes.y);
  });
}

function setRandomPair() {
  const off = () => (Math.random() - 0.5) * 1.6;
  const placed = (points, dx, dy) =>
    points.map(([x, y]) => [Number((x + dx).toFixed(3)), Number((y + dy).toFixed(3))]);
  setCase(placed(KIT.random(), -1.3 + off(), off()), placed(KIT.random(), 1.3 + off(), off()));
}

async function showCase(text, name) {
  const next = await act({ do: "case", text, name }, { about: $("case") });
  if (!next) return;
  const hint = $("hint").classList.contains("note") ? $("hint").textContent : "";
  if (next.understood) tell(`${next.understood}. ${hint}`);
  $("stage").scrollIntoView({ block: "nearest" });
}

async function readFile(file) {
  if (!file) return;
  if (file.size > MOST_LINK_BYTES)
    return say(`${file.name}: ${file.size} bytes are too many; expected at most ${MOST_LINK_BYTES}`, $("case"));
  await showCase(await file.text(), file.name);
}

function startKit() {
  for (const button of document.querySelectorAll("[data-shape]"))
    button.onclick = () => setShape(button.dataset.for, button.dataset.shape);
  $("random").onclick = setRandomPair;
  $("paste").onclick = () => showCase($("case").value, "pasted");
  $("choose").onclick = () => $("file").click();
  $("file").onchange = async () => {
    await readFile($("file").files[0]);
    $("file").value = "";  // so that the same file can be chosen again
  };
  addEventListener("dragover", (event) => event.preventDefault());
  addEventListener("drop", (event) => {
    event.preventDefault();
    document.querySelector(".kit details").open = true;
    readFile(event.dataTransfer.files[0]);
  });
  // A field takes minutes to set so many lines: a long case is shown, and not listed.
  $("case").addEventListener("beforeinput", (event) => {
    if (!(event.data?.length > MOST_LISTED)) return;
    event.preventDefault();
    $("case").value = "";
    $("case").placeholder = "The case is too long to list; it is shown at once.";
    showCase(event.data, "pasted");
  });
}
