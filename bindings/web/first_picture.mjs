// What a visitor calls first: first_picture.mjs WORKER WASM SCENE OUT plays the scene and some gestures by an instrumented module.
//
// WORKER is the text of the page's worker, WASM the packed module (unpack.js), OUT the profile that wasm-split takes. What is not called
// here is in the second part of the module (parts.js), and works there too.
import fs from "node:fs";
import vm from "node:vm";

const [worker, wasm, scene, out] = process.argv.slice(2);
const answers = [];
Object.assign(globalThis, {self: globalThis, location: {href: ""}, importScripts() {}, postMessage: (answer) => answers.push(answer)});
vm.runInThisContext(fs.readFileSync(worker, "utf8"));
async function ask(call, values = {}) {
    await globalThis.onmessage({data: {call, ...values}});
    const answer = answers.pop();
    if (answer.did !== call) throw new Error(answer.text);
}
const frame = (events, units = 4) => ask("frame", {units, events, want: {sleep: true}});

const bytes = fs.readFileSync(wasm);
await ask("begin", {wasm: bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length)});
await ask("load", {text: fs.readFileSync(scene, "utf8"), plants: {plant: "GRASS"}});
for (let n = 0; n < 12; ++n) await frame(n % 4 === 0 ? [["stroke", 1, 20 * n, 40, 0]] : []);
await frame([["release", 1], ["blast", 100, 50, 0]]);
for (let n = 0; n < 12; ++n) await frame([]);
await frame([], 24); // of a slow machine, with several ticks

const module = vm.runInThisContext("library.module");
const size = 1 << 17;
const at = module._malloc(size);
const used = module.asm.__write_profile(at, size);
if (used > size) throw new Error(`the profile has ${used} bytes`);
fs.writeFileSync(out, module.HEAPU8.slice(at, at + used));
