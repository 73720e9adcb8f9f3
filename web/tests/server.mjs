// Sends web/dist below a path, as hosts do, well or badly.

import { createReadStream, existsSync, readFileSync, statSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";
import { gunzipSync } from "node:zlib";

const TYPES = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".png": "image/png", ".json": "application/json" };

/// `manner` is what the server does to files of the program: "well", "cut" (half of it, then the connection ends), "short" (half of
/// it, and calls that all), "inflated" (what is gzipped it unpacks), "gone". `pages` are there besides, by their names.
export async function serve(folder, path = "/a/school/clipscope/") {
  const state = { manner: "well", asked: [], pages: new Map() };
  const server = createServer((request, response) => {
    const { pathname } = new URL(request.url, "http://localhost");
    state.asked.push(pathname);
    const name = normalize(decodeURIComponent(pathname.slice(path.length)) || "index.html");
    if (state.pages.has(name)) return response.writeHead(200, { "content-type": TYPES[extname(name)] }).end(state.pages.get(name));
    const file = join(folder, name.endsWith("/") ? `${name}index.html` : name);
    if (!pathname.startsWith(path) || name.startsWith("..") || !existsSync(file)) return response.writeHead(404).end();
    const isProgram = /\.(bin|wasm)$/.test(file);
    const manner = isProgram ? state.manner : "well";
    // Neutral, as of a host that knows no wasm.
    const type = TYPES[extname(file)] ?? "application/octet-stream";
    if (manner === "gone") return response.writeHead(404).end();
    if (manner === "well") {
      response.writeHead(200, { "content-type": type, "content-length": statSync(file).size });
      return createReadStream(file).pipe(response);
    }
    const bytes = readFileSync(file);
    const half = bytes.subarray(0, bytes.length / 2);
    if (manner === "inflated") return response.writeHead(200, { "content-type": type }).end(gunzipSync(bytes));
    if (manner === "short") return response.writeHead(200, { "content-type": type }).end(half);
    response.writeHead(200, { "content-type": type, "content-length": bytes.length });
    response.write(half, () => response.destroy());
  });
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
  return {
    state,
    url: `http://127.0.0.1:${server.address().port}${path}`,
    close: () => server.closeAllConnections?.() ?? server.close(),
  };
}
