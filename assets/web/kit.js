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

/** The vertices of a shape. */
function world(key) {
  const { vertices } = (state.shapes ?? ask({ do: "vertices" }))[key];
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
  const paste = (text) => {
    if (act({ do: "case", text, name: "pasted" })) $("stage").scrollIntoView({ block: "nearest" });
  };
  $("paste").onclick = () => paste($("case").value);
  // A field takes minutes to set so many lines: a long case is shown, and not listed.
  $("case").addEventListener("beforeinput", (event) => {
    if (!(event.data?.length > MOST_LISTED)) return;
    event.preventDefault();
    $("case").value = "";
    $("case").placeholder = "The case is too long to list; it is shown at once.";
    paste(event.data);
  });
}
