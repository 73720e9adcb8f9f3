// Opens the page in a real browser and looks at it: `node run.mjs [PART OF A NAME]`. test.sh builds what it needs.

import { bench, server, tests } from "./bench.mjs";
import { Browser } from "./browser.mjs";
import "./page.mjs";
import "./platforms.mjs";
import "./links.mjs";

const wanted = process.argv[2] ?? "";
let n_failed = 0;
const began = Date.now();
for (const { name, run } of tests.filter(({ name }) => name.includes(wanted))) {
  const start = Date.now();
  server.state.manner = "well";
  try {
    await run();
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
console.log(`${n_failed} failed, in ${((Date.now() - began) / 1000).toFixed(0)} s`);
process.exit(n_failed ? 1 : 0);
