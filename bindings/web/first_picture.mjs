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
const frame = (events, units) => ask("frame", {units, events, want: {sleep: true}});

const bytes = fs.readFileSync(wasm);
await ask("begin", {wasm: bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length)});
// A quick machine's frames, then a slow one's with several ticks each, and what lies between.
for (const units of [[4], [24], [1, 8, 13, 16, 24]]) {
    let n = 0;
    const next = (events) => frame(events, units[n++ % units.length]);
    await ask("load", {text: fs.readFileSync(scene, "utf8"), plants: {plant: "GRASS"}});
    for (let k = 0; k < 12; ++k) await next(k % 4 === 0 ? [["stroke", 1, 20 * k, 40, 0]] : []);
    await next([["release", 1], ["blast", 100, 50, 0]]);
    for (let k = 0; k < 12; ++k) await next([]);
}

const module = vm.runInThisContext("library.module");
const size = 1 << 17;
const at = module._malloc(size);
const used = module.asm.__write_profile(at, size);
if (used > size) throw new Error(`the profile has ${used} bytes`);
fs.writeFileSync(out, module.HEAPU8.slice(at, at + used));
