// The module of the page in two parts and as a whole: parts_test.mjs BUILD, by node. Each scene of the page, with a stroke, a fan and an
// undo, must have the same bits in both. A part that lacks a function, or a table whose places were exchanged, ends or differs here.
import fs from "node:fs";
import path from "node:path";
import {fileURLToPath} from "node:url";

const build = process.argv[2];
const root = path.join(path.dirname(fileURLToPath(import.meta.url)), "../..");
const scenes = JSON.parse(fs.readFileSync(path.join(root, "bindings/web/page/scenes.json"), "utf8"));
const bytesOf = (file) => new Uint8Array(fs.readFileSync(file)).buffer;
const answers = [];
Object.assign(globalThis, {self: globalThis, location: {href: ""}, importScripts() {}, postMessage: (answer) => answers.push(answer)});

async function ask(call, values = {}) {
    await globalThis.onmessage({data: {call, ...values}});
    const answer = answers.pop();
    if (answer.did !== call) throw new Error(answer.text);
    return answer;
}
/** Hashes of all scenes by the worker's script and what it begins with. */
async function hashes(script, begin) {
    (0, eval)(`(() => {${script}\n})()`);
    await ask("begin", begin);
    const found = [];
    for (const {file, files = [], plant} of scenes) {
        const named = Object.fromEntries(files.map((name) => [name, new Uint8Array(bytesOf(path.join(root, "examples/scenes", name)))]));
        await ask("load", {text: fs.readFileSync(path.join(root, file), "utf8"), files: named, plants: {plant: plant ?? "GRASS"}});
        const frame = (events, begins = false) => ask("frame", {units: 8, events, begins});
        for (let n = 0; n < 6; ++n) await frame([["stroke", 1, 30 * n, 40, 0]]);
        await frame([["release", 1], ["add", "f", "fan", 100, 0, 0, 30], ["add", "w", "walker", 0, 0, 0, 0]], true);
        const before = (await ask("log")).hash;
        await ask("undo");
        await frame([["blast", 0, 50, 0]]);
        found.push(`${before} ${(await ask("log")).hash}`);
    }
    return found;
}

let failures = 0;
for (const [form, name] of [["simd", "windrow"], ["plain", "windrow_plain"]]) {
    const packed = (file) => bytesOf(path.join(build, "page", file));
    const parts = await hashes(fs.readFileSync(path.join(build, "page/worker.js"), "utf8"), {wasm: packed(`${name}.lzma`), rest: packed(`${name}_rest.lzma`)});
    const whole = await hashes(fs.readFileSync(path.join(build, form, "worker.js"), "utf8"), {wasm: bytesOf(path.join(build, form, "whole.lzma"))});
    const equal = parts.filter((hash, n) => hash === whole[n]).length;
    console.log(`${form}: ${equal} of ${scenes.length} scenes have the same bits in two parts and as a whole`);
    if (equal !== scenes.length || new Set(parts).size !== scenes.length) ++failures;
}
process.exit(failures === 0 ? 0 : 1);
