// The package of npm in an empty project: package_test.mjs BUILD. It is packed, installed from its archive, run by node, and its
// three.js example is opened in Chromium. A package that forgets a file, or whose loader needs one beside it, fails here.
import {execFileSync} from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import {launch, open, serve} from "./browser.mjs";

const build = path.resolve(process.argv[2]);
const project = fs.mkdtempSync(path.join(os.tmpdir(), "windrow-npm-"));
const run = (program, ...words) => execFileSync(program, words, {cwd: project, encoding: "utf8"});
let failures = 0;
function claim(holds, text) {
    if (!holds) ++failures;
    console.log(`${holds ? "ok    " : "FAILED"} ${text}`);
}

const archive = run("npm", "pack", path.join(build, "package"), "--silent").trim();
claim(true, `${archive} has ${fs.statSync(path.join(project, archive)).size} bytes`);
run("npm", "init", "-y");
run("npm", "install", "--no-fund", "--no-audit", "--offline", path.join(project, archive));
fs.cpSync(path.join(process.env.WINDROW_NODE_MODULES, "three"), path.join(project, "node_modules/three"), {recursive: true});
const text = fs.readFileSync(path.join(project, "node_modules/windrow/example/index.html"), "utf8");
claim(text.trimEnd().split("\n").length <= 60, "the example has at most 60 lines");

fs.writeFileSync(path.join(project, "try.mjs"), `
import {load, Wind, windrow_wind_glsl} from "windrow";
const speeds = [];
for (const simd of [true, false]) {
    const wind = new Wind(await load({simd}), {ambient: [3, 0, 0], boundaries: {y_low: {kind: "free_slip"}}});
    wind.add("jet", {position: [-6, 1, 0], direction: [1, 0, 0], law: {kind: "drive", speed: 10, rate: 8}});
    for (let frame = 0; frame < 60; ++frame) wind.advance(1 / 60);
    speeds.push(wind.velocity([0, 1, 0]));
}
let sentence = "";
try { new Wind(await load(), {cell_size: -1}); } catch (fault) { sentence = fault.message; }
const library = await load(), floor = {y_low: {kind: "free_slip"}};
const outer = new Wind(library, {cells: [24, 8, 24], cell_size: 2, ambient: [3, 0, 0], boundaries: floor});
outer.add("jet", {position: [-9, 2, 0], direction: [1, 0, 0], law: {kind: "drive", speed: 12, rate: 8}, start_radius: 2, end_radius: 3, length: 8});
const inner = new Wind(library, {cells: [10, 6, 10], boundaries: floor}, {outer});
for (let frame = 0; frame < 90; ++frame) for (const wind of [outer, inner]) wind.advance(1 / 60);
const inside = inner.velocity([-2, 2, 0])[0], beyond = inner.velocity([-9, 2, 0])[0] - outer.velocity([-9, 2, 0])[0];
let levels = "";
try { new Wind(library, {ambient: [1, 0, 0]}, {outer}); } catch (fault) { levels = fault.message; }
outer.destroy();
inner.advance(1 / 60); // which keeps what is around it
inner.destroy();
console.log(JSON.stringify({speeds, sentence, inside, beyond, levels, glsl: windrow_wind_glsl.includes("vec3 windrow_velocity(vec3 p)")}));
`);
const found = JSON.parse(run("node", "try.mjs"));
claim(found.speeds[0][0] > 4, `a fan blows ${found.speeds[0][0].toFixed(2)} m/s, more than the wind's 3`);
claim(JSON.stringify(found.speeds[0]) === JSON.stringify(found.speeds[1]), "both forms have the same bits");
claim(/cell_size is -1/.test(found.sentence), `a wrong setting is thrown: ${found.sentence}`);
claim(found.inside > 4.5, `the fan of the wind around blows ${found.inside.toFixed(2)} m/s in a box without one`);
claim(Math.abs(found.beyond) < 1e-5, "beyond its box a wind has the one around");
claim(/outer wind/.test(found.levels), `a mean wind beside an outer one is thrown: ${found.levels}`);
claim(found.glsl, "the shader's text is there");

const {server, address} = await serve(path.join(project, "node_modules"));
const browser = await launch();
try {
    const {tab, messages} = await open(browser, address + "windrow/example/index.html", {width: 640, height: 360});
    await tab.waitForSelector("canvas", {timeout: 60000});
    await tab.waitForTimeout(3000);
    await tab.mouse.move(200, 200);
    await tab.mouse.move(420, 220, {steps: 6});
    await tab.waitForTimeout(1000);
    const picture = await tab.screenshot({path: path.join(build, "three.png")});
    claim(picture.length > 20000, `the example's picture has ${picture.length} bytes: it is not empty`);
    const real = messages.filter((message) => !/GPU stall due to ReadPixels/.test(message));
    claim(real.length === 0, `the console is silent: ${real.join("; ")}`);
} finally {
    await browser.close();
    server.close();
    fs.rmSync(project, {recursive: true});
}
process.exit(failures === 0 ? 0 : 1);
