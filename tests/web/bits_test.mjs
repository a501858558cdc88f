// The stories of tests/bits in Chromium, in both forms: bits_test.mjs BUILD. Every hash must be that of tests/bits/bits.txt. A module
// that contracts a product and a sum, or calls the browser's own functions, differs here.
import fs from "node:fs";
import path from "node:path";
import {fileURLToPath} from "node:url";
import {launch, open, serve} from "./browser.mjs";

const build = process.argv[2];
const table = path.join(path.dirname(fileURLToPath(import.meta.url)), "../bits/bits.txt");
const pinned = fs.readFileSync(table, "utf8").split("\n").filter((row) => row.startsWith("baseline/"));
const browser = await launch();
let failures = 0;
for (const form of ["simd", "plain"]) {
    fs.writeFileSync(path.join(build, form, "bits.html"), `<!doctype html><link rel="icon" href="data:,"><script>
        var rows = [], Module = {arguments: ["--level", "baseline"], print: (row) => rows.push(row), onExit: () => (Module.ended = true),
                                 postRun: () => (Module.ended = true)};
        </script><script src="windrow_bits.js"></script>`);
    const {server, address} = await serve(path.join(build, form));
    const {tab} = await open(browser, address + "bits.html");
    await tab.waitForFunction(() => window.Module.ended, null, {timeout: 300000, polling: 500});
    const found = await tab.evaluate(() => window.rows);
    const equal = pinned.filter((row) => found.includes(row)).length;
    console.log(`${form}: ${equal} of ${pinned.length} pinned hashes are equal in Chromium`);
    if (equal !== pinned.length || found.length !== pinned.length) ++failures;
    server.close();
}
await browser.close();
process.exit(failures === 0 ? 0 : 1);
