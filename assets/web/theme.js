"use strict";

/** The theme that was chosen, empty for the system's. */
function chosenTheme() {
  try {
    return localStorage.getItem("gjkscope-theme") ?? "";
  } catch {
    return "";  // A page without storage forgets.
  }
}

function themeName(chosen) {
  if (chosen) return chosen;
  if (matchMedia("(prefers-contrast: more)").matches) return "high-contrast";
  return matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
}

// Before anything is painted.
document.documentElement.dataset.theme = themeName(chosenTheme());
