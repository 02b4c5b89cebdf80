import { readFileSync, readdirSync } from "node:fs";

// What the scripts of the pages and of their tests are held to.
const browser = ["document", "window", "location", "history", "localStorage", "navigator", "performance", "matchMedia",
  "innerWidth", "innerHeight", "scrollY", "scrollTo", "addEventListener", "dispatchEvent", "requestAnimationFrame", "cancelAnimationFrame",
  "setTimeout", "clearTimeout", "setInterval", "clearInterval", "atob", "btoa", "Blob", "URL", "Image", "TextEncoder", "TextDecoder",
  "URLSearchParams", "fetch", "CompressionStream", "DecompressionStream", "WebAssembly", "Worker", "postMessage", "MutationObserver", "getComputedStyle"];
const rules = {
  "no-undef": "error",
  "no-unused-vars": ["error", { vars: "local", args: "after-used" }],
  "prefer-const": "error",
  "no-var": "error",
  eqeqeq: "error",
  "no-eval": "error",
  "no-implied-eval": "error",
  "no-shadow": "error",
  "no-unreachable": "error",
};
// The scripts of a page are one.
const scripts = new URL("assets/web/", import.meta.url);
const names = readdirSync(scripts).filter((file) => file.endsWith(".js")).flatMap((file) =>
  [...readFileSync(new URL(file, scripts), "utf8").matchAll(/^(?:async )?(?:function|const|let) ([\w$]+)/gm)].map(([, name]) => name));
const readonly = (names) => Object.fromEntries(names.map((name) => [name, "readonly"]));

export default [
  {
    files: ["**/assets/web/*.js"],
    languageOptions: {
      sourceType: "script",
      globals: { ...readonly([...browser, ...names]), onmessage: "writable" },
    },
    rules: { ...rules, "no-redeclare": ["error", { builtinGlobals: false }] },
  },
  {
    files: ["**/assets/web/service-worker.js"],
    languageOptions: { globals: readonly(["registration", "caches", "fetch", "Response", "VERSION", "FILES"]) },
  },
  {
    files: ["**/assets/web/npm/*.js"],
    languageOptions: {
      sourceType: "module",
      globals: readonly([...browser, "compiled", "instanceOf", "HTMLElement", "CSSStyleSheet", "IntersectionObserver", "CustomEvent", "KeyboardEvent", "customElements", "removeEventListener"]),
    },
    rules,
  },
  {
    files: ["**/*.mjs"],
    languageOptions: {
      globals: readonly([...browser, "process", "console", "Buffer", "state", "act", "ask", "say", "sent", "waiting", "worker", "giveUp", "paper", "axe", "caches", "answer", "MessageChannel"]),
    },
    rules,
  },
];
