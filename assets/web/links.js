"use strict";

// Links to a step and what was changed, and files to keep.

const MOST_LINK_BYTES = 1 << 21;

async function packed(text) {
  const bytes = await through(new CompressionStream("deflate-raw"), new TextEncoder().encode(text));
  const base64 = btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
  return base64.replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}
async function unpacked(text) {
  let bytes;
  try {
    bytes = bytesOf(text.replaceAll("-", "+").replaceAll("_", "/"));
  } catch {
    throw new Error("'lesson' has characters that no link has; expected letters, digits, - and _");
  }
  let all;
  try {
    all = await through(new DecompressionStream("deflate-raw"), bytes, MOST_LINK_BYTES);
  } catch (error) {
    throw error instanceof RangeError ? error
      : new Error("'lesson' is cut off or changed; expected the whole of a link that Share gave");
  }
  return new TextDecoder().decode(all);
}

/** The part after # in the address of this step, with all changes. */
async function hashOfStep() {
  if (state.practice) return `#chapter=${state.practice.chapter}&seed=${state.practice.seed}`;
  const turned = state.eye && state.eye.some((degrees, i) => degrees !== firstEye[i]);
  const hash = `#step=${state.index + 1}${turned ? `&eye=${state.eye.map((degrees) => Math.round(degrees * 10) / 10).join()}` : ""}`;
  if (!state.changed) return hash;
  const answer = await ask({ do: "lesson" });
  return answer?.lesson === undefined ? null : `${hash}&lesson=${await packed(answer.lesson)}`;
}

async function address(more = "") {
  return location.href.split("#")[0] + ((await hashOfStep()) ?? `#step=${state.index + 1}`) + more;
}

/** How the address wants the page to look: it stays so from step to step. */
function look() {
  return (location.hash.match(LOOKS) ?? []).map((part) => `&${part.slice(1)}`).join("");
}
const LOOKS = /[#&](embed|ask|theme=[\w-]*)(?=&|$)/g;

let keptLinks = 0;

/** The address names the step, and holds what was changed: a reload and Back bring it again. */
async function keepLink() {
  const number = ++keptLinks;
  const hash = await hashOfStep();
  if (hash === null || number !== keptLinks) return;
  try {
    history.replaceState(null, "", hash + look());
  } catch {
    // An address that may not change, in a frame for example.
  }
}

/** Names and values of a link. */
function partsOf(text) {
  const parts = new Map();
  for (const part of text.split("&")) {
    const [name, ...value] = part.split("=");
    try {
      parts.set(name, decodeURIComponent(value.join("=")));
    } catch {
      throw new Error(`'${name.slice(0, 20)}' has a % that no two hexadecimal digits follow`);
    }
  }
  return parts;
}

/** Goes where the link says; what is wrong with it is said. */
async function follow(hash) {
  const text = hash.replace(/^#/, "");
  if (!text || text === "stage") return;  // the skip link
  const most = 3 * MOST_LINK_BYTES;  // %20
  if (text.length > most) return say(`link: ${text.length} characters are too many; expected at most ${most}`);
  try {
    const parts = partsOf(text);
    setLook(parts);
    if (data.kind === "practice") {
      if (parts.has("chapter")) await followPractice(parts);
      return;
    }
    if (parts.has("ask") && data.asks && !state.predicting) await act({ do: "predict", on: true });
    if (parts.has("lesson")) {
      const lesson = await unpacked(parts.get("lesson"));
      if (!(await act({ do: "replace", lesson, name: "link" }))) return;
    } else if (parts.has("case")) {
      if (!(await act({ do: "case", text: parts.get("case"), name: "link" }))) return;
    }
    if (parts.has("eye") && state.eye) {
      const [azimuth, elevation] = parts.get("eye").split(",").map(Number);
      if (!Number.isFinite(azimuth + elevation)) return say(`link: 'eye' is ${parts.get("eye").slice(0, 20)}; expected two numbers, azimuth and elevation`);
      await act({ do: "eye", azimuth: azimuth - state.eye[0], elevation: elevation - state.eye[1] });
    }
    const wanted = parts.get("step") ?? (/^\d+$/.test(text) ? text : null);
    if (wanted === null) return;
    const number = /^\d{1,9}$/.test(wanted) ? Number(wanted) : 0;
    if (number < 1 || number > state.count)
      return say(`link: there is no step ${wanted.slice(0, 20)}; expected 1 to ${state.count}`);
    await act({ do: "go", to: number - 1 });
  } catch (error) {
    say(`link: ${error.message}`);
  }
}

/** Embedded, a page is the figure and a way to the lesson. */
function setLook(parts) {
  const embedded = parts.has("embed");
  const theme = parts.has("theme") ? chosenTheme() : $("theme").value;
  if (root.classList.contains("embed") === embedded && theme === $("theme").value) return;
  root.classList.toggle("embed", embedded);
  $("theme").value = theme;
  layout();
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

/** The whole file of which the listing is a part; where nothing can be copied, it is shown. */
async function copyCode() {
  const file = await ask({ do: "code" });
  if (file?.text === undefined) return;
  try {
    await navigator.clipboard.writeText(file.text);
    tell(`Copied ${file.name}, the whole file.`);
  } catch {
    offer(file.name, "The whole file:", file.text);
    copy();
  }
}

function save(name, blob) {
  const url = URL.createObjectURL(blob);
  element("a", { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 10000);
}

function fileName(ending) {
  return `${data.id}-${String(state.index + 1).padStart(4, "0")}.${ending}`;
}

async function saveSvg() {
  const frame = await ask({ do: "frame" });
  if (frame?.svg) save(fileName("svg"), new Blob([frame.svg], { type: "image/svg+xml" }));
}

async function savePng() {
  const frame = await ask({ do: "frame" });
  if (!frame?.svg) return;
  const fonts = `<style>${needed.fonts}</style>`;
  const svg = frame.svg.replace("<title>", `${fonts}<title>`);
  const image = new Image();
  image.src = URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" }));
  await image.decode();
  const canvas = element("canvas", { width: 2 * image.width, height: 2 * image.height });
  canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
  URL.revokeObjectURL(image.src);
  canvas.toBlob((blob) => save(fileName("png"), blob), "image/png");
}
