// The order in which a page's functions are packed changes nothing that they do.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

import { test } from "./bench.mjs";

const N = 400;
const [GET, CONST, ADD, MUL, CALL, CALL_INDIRECT, DROP, END] = [0x20, 0x41, 0x6a, 0x6c, 0x10, 0x11, 0x1a, 0x0b];
const I32 = 0x7f;

const signed = (n) => (n < 64 ? [n] : [(n & 0x7f) | 0x80, ...signed(n >> 7)]);
const count = (n) => (n < 128 ? [n] : [(n & 0x7f) | 0x80, ...count(n >> 7)]);
const sized = (bytes) => [...count(bytes.length), ...bytes];
const vector = (items) => [...count(items.length), ...items.flat()];
const section = (id, items) => [id, ...sized(vector(items))];
const name = (i) => `f${i}`;

/// Each function adds its number or multiplies by it, and calls the one of half its number: by its index, or through a table. Every
/// fourth one begins alike.
function program() {
  const all = [...Array(N).keys()];
  const body = (i) => {
    if (i === 0) return [0, GET, 0, END];
    const half = i >> 1;
    const call = i % 2 ? [CONST, ...signed(half), CALL_INDIRECT, 0, 0] : [CALL, ...count(half)];
    const alike = [CONST, ...signed((1 + (i % 4)) << 24), DROP];
    return [0, ...alike, GET, 0, CONST, ...signed(i), i % 3 ? ADD : MUL, ...call, END];
  };
  const exported = (i) => [...sized([...Buffer.from(name(i))]), 0, ...count(i)];
  const elements = [0, CONST, 0, END, ...vector(all.map(count))];
  return Buffer.from([
    ...[0, 0x61, 0x73, 0x6d, 1, 0, 0, 0],
    ...section(1, [[0x60, 1, I32, 1, I32]]),
    ...section(3, all.map(() => [0])),
    ...section(4, [[0x70, 0, ...count(N)]]),
    ...section(7, all.map(exported)),
    ...section(9, [elements]),
    ...section(10, all.map((i) => sized(body(i)))),
  ]);
}

const answers = async (bytes) => {
  const { instance } = await WebAssembly.instantiate(bytes);
  return [...Array(N).keys()].map((i) => instance.exports[name(i)](7));
};

test("functions in another order do the same", async () => {
  const folder = mkdtempSync(join(tmpdir(), "clipscope-order-"));
  const [from, to] = ["from.wasm", "to.wasm"].map((file) => join(folder, file));
  writeFileSync(from, program());
  execFileSync(process.env.BINDGEN, ["order", from, to]);
  const [given, sorted] = [from, to].map((file) => readFileSync(file));
  rmSync(folder, { recursive: true });
  assert(!sorted.equals(given), "it is another order");
  assert.deepEqual(await answers(sorted), await answers(given));
});
