// A browser for the tests of the page: a server of a folder, Chromium on a software GPU, and every message of the console.
import fs from "node:fs";
import http from "node:http";
import path from "node:path";
import {createRequire} from "node:module";

const require = createRequire(import.meta.url);
// Where `npm install playwright-core` was run; WINDROW_NODE_MODULES names the folder.
const {chromium} = require(path.join(process.env.WINDROW_NODE_MODULES ?? "node_modules", "playwright-core"));
const KINDS = {".html": "text/html", ".js": "text/javascript", ".mjs": "text/javascript", ".wasm": "application/wasm", ".json": "application/json"};
const FLAGS = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist", "--no-sandbox"];

/** `fails` has by a file's name "missing", "stalls" (a beginning, then nothing) or "silent"; a test may change it. */
export function serve(root, fails = {}) {
    const folder = path.resolve(root);
    const server = http.createServer((request, answer) => {
        const name = path.join(folder, decodeURIComponent(new URL(request.url, "http://x").pathname));
        const file = fs.existsSync(name) && fs.statSync(name).isDirectory() ? path.join(name, "index.html") : name;
        const fault = fails[path.basename(file)];
        if (fault === "silent") return;
        if (fault === "stalls") {
            answer.writeHead(200, {"content-length": fs.statSync(file).size});
            answer.write(fs.readFileSync(file).subarray(0, 1000));
            return;
        }
        if (fault === "missing" || !file.startsWith(folder) || !fs.existsSync(file)) {
            answer.writeHead(404).end();
            return;
        }
        answer.writeHead(200, {"content-type": KINDS[path.extname(file)] ?? "application/octet-stream"}).end(fs.readFileSync(file));
    });
    return new Promise((resolve) => server.listen(0, "127.0.0.1", () => resolve({server, address: `http://127.0.0.1:${server.address().port}/`})));
}

export async function launch() {
    return chromium.launch({executablePath: process.env.WINDROW_CHROMIUM ?? "/usr/bin/chromium", args: FLAGS});
}

/** A tab whose messages are kept: a page says nothing. */
export async function open(browser, address, {width = 960, height = 540, touch = false, patience} = {}) {
    const context = await browser.newContext({viewport: {width, height}, hasTouch: touch, permissions: []});
    const tab = await context.newPage();
    if (patience) await tab.addInitScript(`window.windrowPatience = ${patience}`);
    const messages = [];
    tab.on("console", (message) => messages.push(`${message.type()}: ${message.text()}`));
    tab.on("pageerror", (fault) => messages.push(`error: ${fault.stack ?? fault.message}`));
    await tab.goto(address, {timeout: 120000});
    return {tab, messages, context};
}
export async function drawn(tab, timeout = 180000) {
    await tab.waitForFunction(() => document.documentElement.dataset.drawn !== undefined, null, {timeout});
    return Number(await tab.evaluate(() => document.documentElement.dataset.drawn));
}
