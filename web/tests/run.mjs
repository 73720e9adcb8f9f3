// Opens the page in a real browser and looks at it: `node run.mjs [PART OF A NAME]`. test.sh builds what it needs. `PART=1/2` takes
// every second test, for two that run beside each other.

import { bench, server, tests } from "./bench.mjs";
import { Browser } from "./browser.mjs";
import "./page.mjs";
import "./platforms.mjs";
import "./links.mjs";
import "./touch.mjs";
import "./fetched.mjs";

const wanted = process.argv[2] ?? "";
const [part, parts] = (process.env.PART ?? "1/1").split("/").map(Number);
const chosen = tests.filter(({ name }, i) => name.includes(wanted) && i % parts === part - 1);
let n_failed = 0;
const began = Date.now();
for (const { name, run } of chosen) {
  const start = Date.now();
  server.state.manner = "well";
  try {
    await run();
    await bench.browser.closePages();
    console.log(`ok      ${name} (${((Date.now() - start) / 1000).toFixed(1)} s)`);
  } catch (error) {
    n_failed += 1;
    console.log(`FAILED  ${name}\n${error.stack}`);
    // A page that hangs is not the next one's.
    await bench.browser.close();
    bench.browser = new Browser();
  }
}
await bench.browser.close();
server.close();
console.log(`${n_failed} of ${chosen.length} failed, in ${((Date.now() - began) / 1000).toFixed(0)} s`);
process.exit(n_failed ? 1 : 0);
