// The element gjk-lesson: a lesson's figure in a box of any page. The figure is the lesson's page of this
// package in a frame, so no style, key or policy of either page reaches the other one.

import { lessons } from "./lessons.js";

export { lessons };

const PAGES = new URL("pages/", import.meta.url);
const NEAR = "50%";  // how far outside the window, in parts of it, an element starts
const PATIENCE_MS = 3000;

const style = new CSSStyleSheet();
style.replaceSync(`
  :host { display: block; box-sizing: border-box; height: 38rem; overflow: hidden; }
  :host([hidden]) { display: none; }
  iframe, button, p { box-sizing: border-box; display: block; width: 100%; height: 100%; margin: 0; border: 0; }
  button, p { padding: 1rem; border: 1px solid; border-radius: inherit; background: none; color: inherit; font: inherit; overflow: auto; }
`);

export class GjkLesson extends HTMLElement {
  static observedAttributes = ["lesson", "step", "theme", "ask"];

  #root = this.attachShadow({ mode: "open", delegatesFocus: true });
  #frame = null;
  #step = 1;
  #count = 0;
  #live = false;
  #asked = "";  // the part after # that the frame was told
  #came = false;  // whether the page in the frame has been heard
  #near = new IntersectionObserver((seen) => seen.some((each) => each.isIntersecting) && this.#start(), { rootMargin: NEAR });
  #hear = (event) => event.source === this.#frame?.contentWindow && this.#take(event.data);

  constructor() {
    super();
    this.#root.adoptedStyleSheets = [style];
  }

  get lesson() { return this.getAttribute("lesson") ?? ""; }
  set lesson(id) { this.setAttribute("lesson", id); }
  get theme() { return this.getAttribute("theme") ?? "auto"; }
  set theme(name) { this.setAttribute("theme", name); }
  get ask() { return this.hasAttribute("ask"); }
  set ask(on) { this.toggleAttribute("ask", on); }
  /** The step that is shown, from 1. */
  get step() { return this.#step; }
  set step(number) { this.setAttribute("step", number); }
  /** How many steps there are; 0 until the figure is live. */
  get count() { return this.#count; }

  connectedCallback() {
    addEventListener("message", this.#hear);
    this.#wait();
  }

  disconnectedCallback() {
    removeEventListener("message", this.#hear);
    this.#stop();
  }

  attributeChangedCallback(name, last, value) {
    if (name === "step" || name === "lesson") this.#step = Math.max(1, Math.floor(Number(this.getAttribute("step"))) || 1);
    if (!this.isConnected) return;
    if (name === "lesson" || (name === "ask" && value === null)) {
      if (value !== last) this.#wait();
    } else if (this.#live) {
      this.#follow();
    }
  }

  #stop() {
    this.#near.disconnect();
    this.#frame = null;
    this.#live = false;
    this.#count = 0;
    this.#root.replaceChildren();
  }

  /** Until the element is near the window it holds a button, which the keyboard reaches. */
  #wait() {
    this.#stop();
    if (!Object.hasOwn(lessons, this.lesson))
      return this.#fail(this.lesson ? `There is no lesson “${this.lesson}” here.` : "The attribute lesson names no lesson.");
    const button = Object.assign(document.createElement("button"), { type: "button", textContent: lessons[this.lesson] });
    button.onclick = button.onfocus = () => this.#start();
    this.#root.replaceChildren(button);
    this.#near.observe(this);
  }

  #start() {
    this.#near.disconnect();
    const hadFocus = this.#root.activeElement !== null;
    const frame = document.createElement("iframe");
    this.#frame = frame;
    this.#asked = this.#hash();
    frame.title = lessons[this.lesson];
    frame.src = new URL(`${encodeURIComponent(this.lesson)}.html${this.#asked}`, PAGES).href;
    frame.onload = () => setTimeout(() => frame === this.#frame && !this.#came &&
      this.#fail(`The page of this lesson does not load: ${frame.src}. Is the folder “pages” there, and does the policy of this page let it be framed?`), PATIENCE_MS);
    this.#came = false;
    this.#root.replaceChildren(frame);
    if (hadFocus) frame.focus();
  }

  #hash() {
    return `#step=${this.#step}&embed&theme=${encodeURIComponent(this.theme)}${this.ask ? "&ask" : ""}`;
  }

  #follow() {
    this.#asked = this.#hash();
    this.#frame.contentWindow.postMessage({ gjkscope: "follow", hash: this.#asked }, PAGES.origin);
  }

  #fail(message) {
    this.#frame = null;
    const line = Object.assign(document.createElement("p"), { textContent: message });
    line.setAttribute("role", "alert");
    this.#root.replaceChildren(line);
    this.#say("problem", { message });
  }

  #say(type, detail) {
    this.dispatchEvent(new CustomEvent(type, { bubbles: true, detail: { lesson: this.lesson, ...detail } }));
  }

  #take({ gjkscope: type, ...detail }) {
    this.#came = true;
    if (type === "key") {
      this.dispatchEvent(new KeyboardEvent("keydown", { ...detail, bubbles: true, composed: true, cancelable: true }));
    } else if (type === "leave") {
      this.#frame.blur();
    } else if (type === "ready" || type === "step") {
      if (type === "ready" && this.#asked !== this.#hash()) this.#follow();
      else this.#step = detail.step;
      this.#count = detail.count;
      this.#live = true;
      this.#say(type, detail);
    } else if (type === "answer" || type === "problem") {
      this.#say(type, detail);
    }
  }
}

customElements.define("gjk-lesson", GjkLesson);
