// A stroke in the page as an animated WebP: film.mjs BUILD OUT.webp [--scene TITLE] [--camera JSON] [--size 480x270] [--quality 2].
//
// The page's own loop stops; each frame is a step of 1/15 s with the events of a hand, so that a slow machine makes the same film. The
// ring is where the finger is. tools/webp_film.py writes it: a browser shows each frame whole.
import {execFileSync} from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import {drawn, launch, open, serve} from "./browser.mjs";

const FPS = 15, SECONDS = 3.6, BEGIN = 0.4, STROKE = 1.3, REACH = 1.9;
const CAMERA = '{"target": [-0.6, 0.4, 2.1], "distance": 5.2, "yaw": 62, "pitch": 15}';
const [build, out, ...rest] = process.argv.slice(2);
const option = (name, other) => (rest.includes(name) ? rest[rest.indexOf(name) + 1] : other);
const [width, height] = option("--size", "480x270").split("x").map(Number);
const folder = fs.mkdtempSync(path.join(os.tmpdir(), "windrow-film-"));
const {server, address} = await serve(path.join(build, "page"));
const browser = await launch();

/** How far a hand that goes there and back is across the view at t [s], -1 to 1; null where it does not touch. */
function handAt(t) {
    const part = (t - BEGIN) / STROKE;
    if (part < 0 || part > 2) return null;
    return part < 1 ? -Math.cos(Math.PI * part) : Math.cos(Math.PI * (part - 1));
}
try {
    const {tab, messages} = await open(browser, `${address}?quality=${option("--quality", "2")}`, {width, height});
    await drawn(tab, 600000);
    await tab.evaluate(async ([title, camera]) => {
        const page = window.windrow;
        const wanted = page.scenes.findIndex((scene) => scene.title === title);
        if (wanted < 0) throw new Error(`no scene is named '${title}'`);
        if (wanted !== page.index) await page.load(wanted);
        Object.assign(page.camera, camera);
        page.tick = () => {}; // from here on by hand
        while (page.busy) await new Promise((resolve) => setTimeout(resolve, 20));
        page.film = Object.assign(document.createElement("canvas"), {width: page.canvas.clientWidth, height: page.canvas.clientHeight});
    }, [option("--scene", "Fan and stone"), JSON.parse(option("--camera", CAMERA))]);
    const frames = [];
    for (let n = -FPS; n < FPS * SECONDS; ++n) { // a second before, for springs that begin
        const picture = await tab.evaluate(async ([across, ends, units, seconds]) => {
            const page = window.windrow, [right, toward] = page.ways();
            let at = null;
            if (across !== null) {
                const [x, , z] = page.camera.target.map((value, k) => value + across * right[k] + 0.9 * toward[k]);
                at = [x, page.handHeight(x, z, 0.45), z];
                page.send(["stroke", 1, ...at.map((value) => Math.round(100 * value))], false);
            } else if (ends) page.send(["release", 1], false);
            page.owed = units;
            await page.advance();
            page.render(seconds);
            const {film, canvas} = page, paint = film.getContext("2d");
            paint.drawImage(canvas, 0, 0, film.width, film.height);
            if (at) {
                const m = page.meadow.toClip, [px, py, , pw] = [0, 1, 2, 3].map((r) => m[r] * at[0] + m[4 + r] * at[1] + m[8 + r] * at[2] + m[12 + r]);
                paint.lineWidth = 2.5;
                paint.strokeStyle = "#fffc";
                paint.beginPath();
                paint.arc((0.5 + (0.5 * px) / pw) * film.width, (0.5 - (0.5 * py) / pw) * film.height, 0.035 * film.width, 0, 7);
                paint.stroke();
            }
            return film.toDataURL("image/png").split(",")[1];
        }, [handAt(n / FPS) === null ? null : REACH * handAt(n / FPS), handAt((n - 1) / FPS) !== null, 240 / FPS, 1 / FPS]);
        if (n < 0) continue;
        frames.push(path.join(folder, `${String(n).padStart(3, "0")}.png`));
        fs.writeFileSync(frames[n], Buffer.from(picture, "base64"));
    }
    if (messages.length) throw new Error(`the console says: ${messages.join("\n")}`);
    execFileSync("/usr/bin/python3", ["-B", "tools/webp_film.py", out, ...frames, "--fps", String(FPS), "--most", "1500000"], {stdio: "inherit"});
} finally {
    fs.rmSync(folder, {recursive: true});
    await browser.close();
    server.close();
}
