// Opens the page in a real browser and looks at it: `node run.mjs [PART OF A NAME]`. test.sh builds what it needs. `PART=1/2` takes
// every second test, for two that run beside each other. What fails is tried once more.

import { bench, server, tests } from "./bench.mjs";
import { Browser } from "./browser.mjs";
import "./page.mjs";
import "./platforms.mjs";
import "./links.mjs";
import "./touch.mjs";
import "./fetched.mjs";
import "./order.mjs";

const wanted = process.argv[2] ?? "";
const [part, parts] = (process.env.PART ?? "1/1").split("/").map(Number);
const chosen = tests.filter(({ name }, i) => name.includes(wanted) && i % parts === part - 1);
const began = Date.now();

async function passes({ name, run }) {
  const start = Date.now();
  server.state.manner = "well";
  try {
    await run();
    await bench.browser.closePages();
    console.log(`ok      ${name} (${((Date.now() - start) / 1000).toFixed(1)} s)`);
    return true;
  } catch (error) {
    console.log(`FAILED  ${name}\n${error.stack}`);
    // A page that hangs is not the next one's.
    await bench.browser.close();
    bench.browser = new Browser();
    return false;
  }
}

async function failing(tests) {
  const failed = [];
  for (const test of tests) {
    if (!(await passes(test))) failed.push(test);
  }
  return failed;
}

const failed = await failing(chosen);
if (failed.length) console.log(`${failed.length} once more, since a busy machine may have kept the browser from answering in time`);
const n_failed = (await failing(failed)).length;
await bench.browser.close();
server.close();
console.log(`${n_failed} of ${chosen.length} failed, in ${((Date.now() - began) / 1000).toFixed(0)} s`);
process.exit(n_failed ? 1 : 0);
