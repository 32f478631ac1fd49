// Service worker: stores all files at the first visit, and answers from there. offline.json says which, and their version.

const LIST = "offline.json";
const PREFIX = "polar-breakout files "; // other pages of the same host have caches too
const NAME = `${PREFIX}VERSION-OF-THE-SITE`;

async function stored() {
  const { files } = await (await fetch(LIST, { cache: "no-cache" })).json();
  const cache = await caches.open(NAME);
  const known = new Set((await cache.keys()).map((request) => request.url));
  const missing = files.filter((file) => !known.has(new URL(file, location.href).href));
  await cache.addAll(missing.map((file) => new Request(file, { cache: "no-cache" })));
  for (const name of await caches.keys()) if (name.startsWith(PREFIX) && name !== NAME) await caches.delete(name);
}

async function answer(request) {
  const held = await caches.match(request, { ignoreSearch: true, cacheName: NAME });
  return held ?? fetch(request);
}

self.addEventListener("install", (event) => event.waitUntil(stored().then(() => self.skipWaiting())));
self.addEventListener("activate", (event) => event.waitUntil(self.clients.claim()));
self.addEventListener("fetch", (event) => {
  if (event.request.method === "GET" && new URL(event.request.url).origin === location.origin) event.respondWith(answer(event.request));
});
