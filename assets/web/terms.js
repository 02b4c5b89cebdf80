"use strict";

// Terms of the course: pointing at one, by a hand or the keyboard, shows its sentence.

let explained = null;

function termOf(words, sentence) {
  const term = element("dfn", { className: "term", textContent: words, tabIndex: 0, sentence });
  term.setAttribute("aria-description", sentence);
  return term;
}

/** A box around a term's words, which are part of a picture. */
function noteOf(sentence) {
  const note = element("span", { className: "term", tabIndex: 0, sentence });
  note.setAttribute("role", "note");
  note.setAttribute("aria-label", sentence);
  return note;
}

/** Pieces of a text: words, and terms with their sentences. Text that is the same is left alone, so that it is not announced again. */
function setWords(id, pieces) {
  const text = pieces.map((piece) => (typeof piece === "string" ? piece : piece[0])).join("");
  const place = $(id);
  if (place.pieces === text) return;
  place.pieces = text;
  place.replaceChildren(...pieces.map((piece) => (typeof piece === "string" ? piece : termOf(...piece))));
  explain(null);
}

/** Lays terms on the words of a picture that the host holds. */
function layTerms(host, terms) {
  const { width, height } = host.querySelector("svg").viewBox.baseVal;
  for (const [x, y, wide, high, sentence] of terms) {
    const term = noteOf(sentence);
    const share = (part, whole) => `${(100 * part) / whole}%`;
    Object.assign(term.style, { left: share(x, width), top: share(y, height), width: share(wide, width), height: share(high, height) });
    host.append(term);
  }
}

/** Shows the sentence of a term below it, or above where there is no room; none hides what is shown. */
function explain(term) {
  explained = term?.isConnected ? term : null;
  const tip = $("term");
  tip.hidden = !explained;
  if (!explained) return;
  tip.textContent = explained.sentence;
  const at = explained.getBoundingClientRect();
  const right = root.clientWidth - tip.offsetWidth - 8;
  tip.style.left = `${Math.max(8, Math.min(at.left, right))}px`;
  const fits = at.bottom + tip.offsetHeight < innerHeight;
  tip.style.top = `${fits ? at.bottom : at.top - tip.offsetHeight}px`;
}
