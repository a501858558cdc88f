// A server that fails while the page loads: loads_test.mjs BUILD. The page says one sentence with a button, goes on as far as it can, and
// after the button has all. One that waits for ever, stays broken or plays another air than before is found here.
import path from "node:path";
import {drawn, launch, open, serve} from "./browser.mjs";

const [build] = process.argv.slice(2);
let failures = 0;
function claim(holds, text) {
    if (!holds) ++failures;
    console.log(`${holds ? "ok    " : "FAILED"} ${text}`);
}
const fails = {};
const {server, address} = await serve(path.join(build, "page"), fails);
const browser = await launch();
const ask = (tab, call, values = {}) => tab.evaluate(([name, rest]) => window.windrow.ask(name, rest), [call, values]);
const sentence = (tab) => tab.evaluate(() => document.getElementById("says").textContent);
/** Waits for a sentence of a missing part, with its button. */
async function says(tab, wanted) {
    await tab.waitForFunction(() => document.querySelector("#says button") !== null, null, {timeout: 60000, polling: 100}).catch(() => {});
    const text = await sentence(tab);
    claim(wanted.test(text) && /Try again/.test(text), `it says: ${text}`);
}
async function goesOn(tab, what) {
    const [time, frames] = await tab.evaluate(() => [window.windrow.time, window.windrow.frames]);
    const went = await tab.waitForFunction(([t, k]) => window.windrow.time > t && window.windrow.frames > k + 1, [time, frames], {timeout: 60000, polling: 100})
        .then(() => true, () => false);
    claim(went, what);
}
async function heal(tab) {
    for (const name of Object.keys(fails)) delete fails[name];
    await tab.click("#says button");
    await tab.waitForFunction(() => document.getElementById("says").textContent === "", null, {timeout: 60000, polling: 100}).catch(() => {});
    claim((await sentence(tab)) === "", `after the button nothing is missing: '${await sentence(tab)}'`);
}
const size = {width: 480, height: 320, patience: 1500};
try {
    for (const fault of ["missing", "silent", "stalls"]) {
        // --- the rest of the module, behind the first picture ---------------------------------------------------------------
        fails["windrow_rest.lzma"] = fault;
        let {tab} = await open(browser, address + "?quality=0", size);
        await drawn(tab);
        await says(tab, fault === "missing" ? /windrow_rest.lzma: the server answered 404/ : /windrow_rest.lzma: the server does not answer/);
        await goesOn(tab, `the rest of the module: ${fault}; the air goes on`);
        await tab.focus("#view");
        await tab.evaluate(() => window.windrow.say(""));
        await tab.keyboard.press("h"); // needs the rest
        await says(tab, /windrow_rest.lzma/);
        await goesOn(tab, "without the house that was asked for the air goes on too");
        await heal(tab);
        await tab.keyboard.press("h");
        await tab.waitForFunction(() => window.windrow.objects().some(({kind}) => kind === "house"), null, {timeout: 60000});
        claim(true, "then the house is there");
        await tab.context().close();

        // --- within a call: the module is begun anew, and plays the same air --------------------------------------------------
        fails["windrow_rest.lzma"] = fault;
        ({tab} = await open(browser, address + "?quality=0", size));
        await drawn(tab);
        await says(tab, /windrow_rest.lzma/);
        await tab.evaluate(() => (window.windrow.paused = true));
        await tab.waitForFunction(() => !window.windrow.busy);
        const before = await ask(tab, "log");
        await tab.evaluate(() => (window.windrow.say(""), window.windrow.runVortices()));
        claim(await tab.evaluate(() => window.windrow.broken === true), "a call was left half done: the air has stopped");
        await says(tab, /windrow_rest.lzma/);
        await heal(tab);
        const after = await ask(tab, "log");
        claim(after.hash === before.hash && after.units === before.units && before.units > 0, `the air is the same again: ${before.hash}, ${after.hash}`);
        await tab.evaluate(() => (window.windrow.paused = false));
        await goesOn(tab, "and goes on");

        // --- the script of trees and fur ------------------------------------------------------------------------------------------
        fails["scenery.js"] = fault;
        await tab.selectOption("#scene", {label: "Oak"});
        await says(tab, /scenery.js/);
        claim(await tab.evaluate(() => document.getElementById("scene").selectedOptions[0].textContent === "Lawn"), "the list names the scene that is shown");
        await goesOn(tab, `trees' script: ${fault}; the lawn goes on`);
        await heal(tab);
        claim(await tab.evaluate(() => window.windrow.description.name === "oak" && window.windrow.meadow.scenery.trees.stands.length > 0), "then the oak is there");
        await tab.context().close();
    }
    // --- what the first picture needs ---------------------------------------------------------------------------------------------
    fails["windrow.lzma"] = "missing";
    const {tab} = await open(browser, address + "?quality=0", size);
    await says(tab, /windrow.lzma: the server answered 404/);
} catch (fault) {
    claim(false, fault.stack);
} finally {
    await browser.close();
    server.close();
    server.closeAllConnections?.();
}
console.log(failures === 0 ? "A page whose server fails says so and recovers." : `${failures} claims failed.`);
process.exit(failures === 0 ? 0 : 1);
