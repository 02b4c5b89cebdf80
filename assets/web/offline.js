"use strict";

/** Keeps the whole site for where there is no network. Files of a disk are there anyway, and a page inside another one is a guest. */
function keepSite() {
  if (!/^https?:$/.test(location.protocol) || window.parent !== window || navigator.connection?.saveData) return;
  navigator.serviceWorker?.register("service-worker.js").catch(() => {});  // what is not kept still works with a network
}

// A lesson does it when its program is there.
addEventListener("load", () => document.getElementById("data") ?? keepSite());
