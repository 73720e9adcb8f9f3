// The page without a network, after the first visit. This file alone has always the same name; all others are named by content.

const SET = "clipscope-@set@";
const FILES = [@files@];
/// Who saves data does without what only some need.
const WANTED = location.search === "?few" ? FILES.filter((name) => !/(NotoSansSC|texts|spot)-/.test(name)) : FILES;

/// A network that asks for a password first answers every file with a page of its own.
const isRight = (answer, url) =>
  answer.ok && answer.type === "basic" && /\.html$|\/$/.test(new URL(url).pathname) === /^text\/html/.test(answer.headers.get("content-type") ?? "");

async function keep(cache, name) {
  const url = new URL(name, location).href;
  const answer = await fetch(url, { cache: name === "./" ? "no-cache" : "default" });
  if (!isRight(answer, url)) throw new Error(`${name}: ${answer.status}`);
  await cache.put(url, answer);
}

/// The whole new set, or the old one stays. Who has a page open keeps its set until the last of these is closed.
addEventListener("install", (event) =>
  event.waitUntil(
    caches
      .open(SET)
      .then((cache) => Promise.all(WANTED.map((name) => keep(cache, name))))
      .catch(async (error) => {
        await caches.delete(SET);
        throw error;
      }),
  ),
);

addEventListener("activate", (event) =>
  event.waitUntil(
    caches
      .keys()
      .then((sets) => Promise.all(sets.filter((set) => /^clipscope-/.test(set) && set !== SET).map((set) => caches.delete(set))))
      .then(() => clients.claim()),
  ),
);

addEventListener("fetch", (event) => {
  const { request } = event;
  if (request.method !== "GET" || !request.url.startsWith(registration.scope)) return;
  const page = new URL("./", location).href;
  if (request.mode === "navigate") {
    const path = new URL(request.url).pathname;
    // Pages beside this one are not this one.
    if (path !== new URL(page).pathname && !path.endsWith("/index.html")) return;
    const fresh = fetch(request).then((answer) => (isRight(answer, page) ? answer : Promise.reject(answer)));
    event.respondWith(fresh.catch(async (answer) => (await caches.match(page)) ?? (answer instanceof Response ? answer : Response.error())));
  } else {
    event.respondWith(caches.match(request, { ignoreSearch: true }).then((kept) => kept ?? fetch(request)));
  }
});
