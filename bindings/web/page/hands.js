// Hands: one finger strokes or drags, held still it blasts, two fingers orbit and zoom; a mouse and the keyboard do the same.
import {add, dot, scaled, sub, unit} from "./gl.js";
import {offRay} from "./meadow.js";

const HOLD_MS = 450, STILL = 8; // [CSS pixels]
const STROKE_HEIGHT = 0.45;
const centimetres = (at) => at.map((x) => Math.round(100 * x));

export class Hands {
    /** `page` has meadow, camera, objects(), send(event, begins), marked, and the actions that keys name. */
    constructor(canvas, page) {
        Object.assign(this, {canvas, page, pointers: new Map(), strokes: 0});
        canvas.addEventListener("pointerdown", (event) => this.down(event));
        canvas.addEventListener("pointermove", (event) => this.move(event));
        for (const kind of ["pointerup", "pointercancel"]) canvas.addEventListener(kind, (event) => this.up(event));
        canvas.addEventListener("contextmenu", (event) => event.preventDefault());
        canvas.addEventListener("wheel", (event) => {
            event.preventDefault();
            this.zoom(Math.exp(event.deltaY * 0.001));
        }, {passive: false});
        canvas.addEventListener("keydown", (event) => this.key(event));
    }
    pick({clientX, clientY}) {
        const {left, top, width, height} = this.canvas.getBoundingClientRect();
        return this.page.meadow.pick((2 * (clientX - left)) / width - 1, 1 - (2 * (clientY - top)) / height);
    }
    /** Depth of the crown or the furred body that a ray meets [m]: a stroke that begins there stays in the plane across the view. */
    depthOf(picked) {
        const point = this.page.meadow.scenery?.pick(picked);
        return point ? dot(sub(point, picked.from), this.forward()) : null;
    }
    forward() {
        return unit(sub(this.page.camera.target, this.page.eye()));
    }
    /** What a stroke touches, as the ground STROKE_HEIGHT below it. */
    strokeAt(picked, {depth}) {
        if (!depth) return picked.at;
        const [x, y, z] = add(picked.from, scaled(picked.ray, depth / Math.max(dot(picked.ray, this.forward()), 0.1)));
        return [x, Math.max(y - STROKE_HEIGHT, this.page.meadow.groundHeight(x, z)), z];
    }
    objectAt(picked) {
        let best = null;
        for (const object of this.page.objects()) {
            const off = offRay(picked, add(object.at, [0, object.middle, 0]));
            if (off < object.reach && (!best || off < best.off)) best = {off, object};
        }
        return best?.object ?? null;
    }
    down(event) {
        this.canvas.focus({preventScroll: true});
        this.canvas.setPointerCapture(event.pointerId);
        const pointer = {x: event.clientX, y: event.clientY, begun: [event.clientX, event.clientY], kind: "none"};
        this.pointers.set(event.pointerId, pointer);
        if (this.pointers.size === 2 || event.button === 2 || event.button === 1 || event.ctrlKey) {
            for (const other of this.pointers.values()) {
                this.end(other);
                other.kind = "orbit";
            }
            return;
        }
        if (this.pointers.size > 2) return;
        const picked = this.pick(event);
        const object = this.objectAt(picked);
        if (object) {
            Object.assign(pointer, {kind: "drag", object, off: picked.at ? add(object.at, scaled(picked.at, -1)) : [0, 0, 0]});
            this.page.mark(object.id);
            return;
        }
        pointer.depth = this.depthOf(picked);
        const at = this.strokeAt(picked, pointer);
        if (at) {
            this.page.mark(null);
            pointer.kind = "stroke";
            // Moves of the finger that wait behind a long frame come first.
            const blast = () => {
                if (pointer.moved || pointer.kind !== "stroke" || !this.pointers.has(event.pointerId)) return;
                pointer.kind = "none";
                this.page.send(["blast", ...centimetres(add(at, [0, 0.6, 0]))], true);
            };
            setTimeout(() => requestAnimationFrame(() => requestAnimationFrame(blast)), HOLD_MS);
        } else pointer.kind = "orbit";
    }
    move(event) {
        const pointer = this.pointers.get(event.pointerId);
        if (!pointer) return;
        const [dx, dy] = [event.clientX - pointer.x, event.clientY - pointer.y];
        const spread = this.spread();
        pointer.x = event.clientX;
        pointer.y = event.clientY;
        if (pointer.kind === "orbit") {
            const part = 1 / this.pointers.size;
            this.orbit(-0.3 * part * dx, 0.25 * part * dy);
            if (spread > 0) this.zoom(spread / Math.max(this.spread(), 1));
            return;
        }
        pointer.moved ||= Math.hypot(event.clientX - pointer.begun[0], event.clientY - pointer.begun[1]) > STILL;
        const picked = this.pick(event);
        const at = pointer.kind === "stroke" ? this.strokeAt(picked, pointer) : picked.at;
        if (!at) return;
        if (pointer.kind === "stroke") {
            if (!pointer.moved) return;
            const begins = !pointer.stroke;
            pointer.stroke ??= ++this.strokes + 1000 * this.page.session;
            this.page.send(["stroke", pointer.stroke, ...centimetres(add(at, [0, STROKE_HEIGHT, 0]))], begins);
        } else if (pointer.kind === "drag") {
            const to = add(at, pointer.off);
            this.page.place(pointer.object, [to[0], pointer.object.at[1], to[2]], pointer.object.yaw, !pointer.dragged);
            pointer.dragged = true;
        }
    }
    up(event) {
        const pointer = this.pointers.get(event.pointerId);
        if (pointer) this.end(pointer);
        this.pointers.delete(event.pointerId);
    }
    end(pointer) {
        if (pointer.stroke) this.page.send(["release", pointer.stroke], false);
        delete pointer.stroke;
    }
    spread() {
        if (this.pointers.size < 2) return 0;
        const [a, b] = this.pointers.values();
        return Math.hypot(a.x - b.x, a.y - b.y);
    }
    orbit(yaw, pitch) {
        const {camera} = this.page;
        camera.yaw += yaw;
        camera.pitch = Math.min(Math.max(camera.pitch + pitch, 3), 80);
    }
    zoom(factor) {
        const {camera} = this.page;
        camera.distance = Math.min(Math.max(camera.distance * factor, 2.5), 26);
    }

    // --- the keyboard ------------------------------------------------------------------------------------------------
    key(event) {
        const {page} = this;
        if (event.ctrlKey || event.metaKey || event.altKey) return;
        const steps = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]}[event.key];
        if (steps) {
            event.preventDefault();
            const object = page.marked();
            if (!object) this.orbit(4 * steps[0], -3 * steps[1]);
            else if (event.shiftKey) page.place(object, object.at, (object.yaw + 10 * steps[0] + 360) % 360, true);
            else {
                const [right, toward] = page.ways();
                page.place(object, add(object.at, add(scaled(right, 0.25 * steps[0]), scaled(toward, 0.25 * steps[1]))), object.yaw, true);
            }
            return;
        }
        const action = {" ": "pause", ".": "step", s: "slow", z: "undo", f: "fan", t: "stone", h: "house", w: "walker", b: "blast", g: "gust",
            n: "next", l: "link", p: "panel", Delete: "remove", Backspace: "remove"}[event.key];
        if (event.key === "+" || event.key === "=") this.zoom(0.9);
        else if (event.key === "-") this.zoom(1.1);
        else if (action) {
            event.preventDefault();
            page.act(action);
        }
    }
    /** A stroke across the middle of the view, as a hand would make it in half a second. */
    async gust() {
        const {page} = this;
        const [right] = page.ways();
        const number = ++this.strokes + 1000 * page.session;
        for (let n = 0; n <= 20; ++n) {
            const [x, , z] = add(page.camera.target, scaled(right, 0.25 * (n - 10)));
            page.send(["stroke", number, ...centimetres([x, page.handHeight(x, z, STROKE_HEIGHT), z])], n === 0);
            await new Promise((resolve) => setTimeout(resolve, 25));
        }
        page.send(["release", number], false);
    }
}
