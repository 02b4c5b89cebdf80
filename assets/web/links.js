"use strict";

// Links to a step and what was changed, and files to keep.

const MOST_LINK_BYTES = 1 << 21;

async function through(stream, bytes, most = Infinity) {
  const reader = new Blob([bytes]).stream().pipeThrough(stream).getReader();
  const parts = [];
  let size = 0;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    size += value.length;
    if (size > most) throw new Error(`it holds more than ${most} bytes`);
    parts.push(value);
  }
  return new Uint8Array(await new Blob(parts).arrayBuffer());
}

async function packed(text) {
  const bytes = await through(new CompressionStream("deflate-raw"), new TextEncoder().encode(text));
  const base64 = btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
  return base64.replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}
async function unpacked(text) {
  const bytes = bytesOf(text.replaceAll("-", "+").replaceAll("_", "/"));
  const all = await through(new DecompressionStream("deflate-raw"), bytes, MOST_LINK_BYTES);
  return new TextDecoder().decode(all);
}

/** The address of this page at this step, with what was changed. */
async function address(more = "") {
  const here = location.href.split("#")[0];
  const link = `${here}#step=${state.index + 1}${more}`;
  if (!state.changed) return link;
  return `${link}&lesson=${await packed(ask({ do: "lesson" }).lesson)}`;
}

function keepLink() {
  try {
    if (!state.changed) history.replaceState(null, "", `#step=${state.index + 1}`);
  } catch {
    // An address that may not change, in a frame for example.
  }
}

/** Goes where the link says; what is wrong with it is said. */
async function follow(hash) {
  const text = hash.replace(/^#/, "");
  if (!text || text === "stage") return;  // the skip link
  const most = 3 * MOST_LINK_BYTES;  // %20
  if (text.length > most) return say(`link: ${text.length} characters are too many; expected at most ${most}`);
  try {
    const parts = new Map();
    for (const part of text.split("&")) {
      const at = part.indexOf("=");
      const name = at < 0 ? part : part.slice(0, at);
      parts.set(name, at < 0 ? "" : decodeURIComponent(part.slice(at + 1)));
    }
    root.classList.toggle("embed", parts.has("embed"));
    if (parts.has("lesson")) {
      const lesson = await unpacked(parts.get("lesson"));
      if (!act({ do: "replace", lesson, name: "link" })) return;
    } else if (parts.has("case")) {
      if (!act({ do: "case", text: parts.get("case"), name: "link" })) return;
    }
    const wanted = parts.get("step") ?? (/^\d+$/.test(text) ? text : null);
    layout();
    if (wanted === null) return;
    const number = /^\d{1,9}$/.test(wanted) ? Number(wanted) : 0;
    if (number < 1 || number > state.count)
      return say(`link: there is no step ${wanted.slice(0, 20)}; expected 1 to ${state.count}`);
    act({ do: "go", to: number - 1 });
  } catch (error) {
    say(`link: it is damaged (${error.message})`);
  }
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

function save(name, blob) {
  const url = URL.createObjectURL(blob);
  element("a", { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 10000);
}

function fileName(ending) {
  return `${data.id}-${String(state.index + 1).padStart(4, "0")}.${ending}`;
}

function saveSvg() {
  save(fileName("svg"), new Blob([ask({ do: "frame" }).svg], { type: "image/svg+xml" }));
}

async function savePng() {
  const fonts = `<style>${$("fonts").textContent}</style>`;
  const svg = ask({ do: "frame" }).svg.replace("<title>", `${fonts}<title>`);
  const image = new Image();
  image.src = URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" }));
  await image.decode();
  const canvas = element("canvas", { width: 2 * image.width, height: 2 * image.height });
  canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
  URL.revokeObjectURL(image.src);
  canvas.toBlob((blob) => save(fileName("png"), blob), "image/png");
}
