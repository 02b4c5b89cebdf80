// What the scripts of the pages and of their tests are held to.
const browser = ["document", "window", "location", "history", "localStorage", "navigator", "performance", "matchMedia",
  "innerWidth", "innerHeight", "scrollY", "scrollTo", "addEventListener", "requestAnimationFrame", "cancelAnimationFrame",
  "setTimeout", "setInterval", "clearInterval", "atob", "btoa", "Blob", "URL", "Image", "TextEncoder", "TextDecoder",
  "CompressionStream", "DecompressionStream", "WebAssembly", "MutationObserver", "getComputedStyle"];
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
const readonly = (names) => Object.fromEntries(names.map((name) => [name, "readonly"]));

export default [
  {
    files: ["**/assets/web/*.js"],
    languageOptions: {
      sourceType: "script",
      // The three scripts of a page are one.
      globals: readonly([...browser, "bytesOf", "startPlayerWith", "animate"]),
    },
    rules: { ...rules, "no-redeclare": ["error", { builtinGlobals: false }] },
  },
  {
    files: ["**/*.mjs"],
    languageOptions: {
      globals: readonly([...browser, "process", "console", "Buffer", "state", "act", "ask", "say", "axe"]),
    },
    rules,
  },
];
