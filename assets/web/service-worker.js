// Keeps a site for where there is no network. Above stand VERSION, which its content gives, and FILES, all that it has.

const PREFIX = `gjkscope ${registration.scope} `;
const NAME = PREFIX + VERSION;

/** One after the other, so that a page has its share of the line; what has come stays when the line breaks. */
async function keepAll() {
  const cache = await caches.open(NAME);
  for (const file of FILES) {
    if (await cache.match(file)) continue;
    const answer = await fetch(file, { cache: "no-cache" });
    if (!answer.ok) throw new Error(`${file}: ${answer.status}`);
    // A browser shows no page that was redirected.
    await cache.put(file, answer.redirected ? new Response(await answer.blob(), { headers: answer.headers }) : answer);
  }
}

async function forgetOlder() {
  for (const name of await caches.keys())
    if (name.startsWith(PREFIX) && name !== NAME) await caches.delete(name);
}

/** A page and what it loads are of one version: of the kept one, if there is one. */
async function answerTo(request) {
  const cache = await caches.open(NAME);
  const kept = await cache.match(request.url === registration.scope ? "index.html" : request, { ignoreVary: true });
  return kept ?? fetch(request);
}

addEventListener("install", (event) => event.waitUntil(keepAll()));
addEventListener("activate", (event) => event.waitUntil(forgetOlder()));
addEventListener("fetch", (event) => {
  if (event.request.method === "GET") event.respondWith(answerTo(event.request));
});
