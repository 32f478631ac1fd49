// The memory of Python once the game is imported: the first visit stores it, so that the next ones only copy it.
// It holds for one version of the site in one browser; everything else is a start without it.

const VERSION = "VERSION-OF-THE-SITE";
const PREFIX = "polar-breakout memory ";
const NAME = PREFIX + VERSION;
const KEY = `memory?${encodeURIComponent(navigator.userAgent)}`;

async function digest(bytes) {
  const found = new Uint8Array(await crypto.subtle.digest("SHA-256", bytes));
  return Array.from(found, (byte) => byte.toString(16).padStart(2, "0")).join("");
}

/** The stored snapshot; null where there is none that is whole. */
export async function storedSnapshot() {
  try {
    const held = await caches.match(KEY, { cacheName: NAME });
    if (!held) return null;
    const bytes = new Uint8Array(await held.arrayBuffer());
    if ((await digest(bytes)) === held.headers.get("X-Digest")) return bytes;
    await discardSnapshots();
  } catch {
    // Storage is forbidden or broken.
  }
  return null;
}

/** Store a snapshot in place of all others. Where storage is full or forbidden, the next visit starts as this one did. */
export async function storeSnapshot(bytes) {
  try {
    await discardSnapshots();
    const cache = await caches.open(NAME);
    await cache.put(KEY, new Response(bytes, { headers: { "X-Digest": await digest(bytes) } }));
    return true;
  } catch {
    return false;
  }
}

/** Remove all snapshots, of other versions too. */
export async function discardSnapshots() {
  try {
    for (const name of await caches.keys()) if (name.startsWith(PREFIX)) await caches.delete(name);
  } catch {
    // There is nothing where storage is forbidden.
  }
}
