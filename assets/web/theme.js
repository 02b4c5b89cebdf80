"use strict";

const THEMES = ["light", "dark", "high-contrast", "print"];

/** The theme that the address names, or that was chosen; empty for the system's. */
function chosenTheme() {
  const named = new URLSearchParams(location.hash.slice(1)).get("theme");
  if (named !== null) return THEMES.includes(named) ? named : "";
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
// The page holds its first step in the light theme; a figure that will be another one waits.
{
  const { classList, dataset: { theme } } = document.documentElement;
  classList.toggle("embed", /[#&]embed(&|$)/.test(location.hash));
  classList.toggle("late", theme !== "light" || !/^#step=1&/.test(location.hash));
}
