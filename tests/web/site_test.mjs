// The site of ./dev docs in Chromium, as it opens from a disk: site_test.mjs BUILD [--pictures FOLDER] [--without-playground]
//
// Each claim names what a wrong site would do. --without-playground is for a site that was made before ./dev web.
import fs from "node:fs";
import path from "node:path";
import {pathToFileURL} from "node:url";
import {drawn, launch} from "./browser.mjs";

const [build, ...rest] = process.argv.slice(2);
const site = path.resolve(build, "site");
const pictures = rest.includes("--pictures") ? rest[rest.indexOf("--pictures") + 1] : path.join(build, "pictures");
fs.mkdirSync(pictures, {recursive: true});

let failures = 0;
function claim(holds, text) {
    if (!holds) ++failures;
    console.log(`${holds ? "ok    " : "FAILED"} ${text}`);
}

const browser = await launch();
/** A tab of a page on the disk, with what it said and what it asked of others. */
async function read(page, width, height) {
    const context = await browser.newContext({viewport: {width, height}});
    const tab = await context.newPage();
    const faults = [];
    tab.on("console", (message) => faults.push(`${message.type()}: ${message.text()}`));
    tab.on("pageerror", (fault) => faults.push(`error: ${fault.message}`));
    tab.on("requestfailed", (request) => faults.push(`failed: ${request.url()}`));
    tab.on("request", (request) => /^(file|data|blob|about):/.test(request.url()) || faults.push(`asked for ${request.url()}`));
    await tab.goto(pathToFileURL(path.join(site, page)).href);
    return {tab, faults, context};
}

/** The links of the search's hits for what a hand types. */
async function search(tab, words, narrow) {
    await tab.click(narrow ? "label[for=__search].md-icon" : ".md-search__input");
    await tab.type(".md-search__input", words, {delay: 20});
    await tab.waitForSelector(".md-search-result__link", {timeout: 60000}).catch(() => {});
    return tab.evaluate(() => [...document.querySelectorAll(".md-search-result__link")].map((link) => link.href));
}

for (const [width, height] of [[1280, 900], [390, 844]]) {
    for (const [name, page] of Object.entries({first: "index.html", table: "docs/motors.html", headers: "api.html", settings: "api/structwindrow_1_1Config.html"})) {
        const {tab, faults, context} = await read(page, width, height);
        await tab.waitForTimeout(300);
        claim(faults.length === 0, `${page} at ${width} pixels says nothing and takes nothing from a server${faults.map((text) => `: ${text}`).join("")}`);
        const wide = await tab.evaluate(() => document.documentElement.scrollWidth);
        claim(wide <= width, `${page} is ${wide} pixels wide on a screen of ${width}`);
        await tab.screenshot({path: path.join(pictures, `site_${name}_${width}.png`)});
        await context.close();
    }
    const {tab, faults, context} = await read("docs/air.html", width, height);
    const hits = await search(tab, "log profile", width < 960);
    await tab.screenshot({path: path.join(pictures, `site_search_${width}.png`)});
    claim(hits.some((hit) => hit.includes("/docs/")), `the search for "log profile" at ${width} pixels finds a page (${hits.length} hits)`);
    claim(hits.some((hit) => hit.includes("/api/")), "and a place of the reference");
    if (hits.length > 0) {
        const hit = hits.find((link) => link.includes("#")) ?? hits[0];
        await tab.goto(hit);
        const there = decodeURIComponent(new URL(hit).hash.slice(1));
        claim(await tab.evaluate((id) => !id || document.getElementById(id) !== null || document.getElementsByName(id).length > 0, there),
              `a hit leads to its place, ${path.basename(hit)}`);
    }
    claim(faults.length === 0, `the search says nothing${faults.map((text) => `: ${text}`).join("")}`);
    await context.close();
}

for (const name of ["windrow_wind_create", "Wind::step"]) {
    const {tab, context} = await read("docs/air.html", 1280, 900);
    claim((await search(tab, name, false)).slice(0, 2).some((hit) => hit.includes("/api/")), `the search finds ${name} in the reference first`);
    await context.close();
}

if (!rest.includes("--without-playground")) {
    const {tab, faults} = await read("index.html", 1280, 900);
    claim(tab.frames().every((frame) => !frame.url().includes("play/")), "the playground is not loaded before someone asks for it");
    await tab.click(".play > a");
    const frame = await (await tab.waitForSelector(".play > iframe")).contentFrame();
    claim((await drawn(frame)) >= 0, "the playground draws in the first page");
    claim(faults.length === 0, `the playground says nothing and takes nothing from a server${faults.map((text) => `: ${text}`).join("")}`);
    await tab.screenshot({path: path.join(pictures, "site_play_1280.png")});
}

await browser.close();
console.log(failures ? `${failures} claims failed` : "all claims hold");
process.exit(failures ? 1 : 0);
