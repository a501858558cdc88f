// The page: it owns the picture and the log of what hands did; the worker owns the air.
import {Device, add, cross, scaled, sub, unit} from "./gl.js";
import {Meadow, BLADES, QUALITIES} from "./meadow.js";
import {marking} from "./solids.js";
import {Overlays, Field} from "./overlays.js";
import {Hands} from "./hands.js";
import {Panel} from "./panel.js";
import {Graph, drawErrors} from "./graph.js";
import {fetchFile, fromLink, isInlined, toLink} from "./link.js";
import {FAN_HEIGHT, MAKES, UNITS_A_SECOND, bodiesOf} from "./made.js";

const MOST_SECONDS = 0.1; // of a frame: a tab that was hidden goes on, without what it missed
const SLOW = 0.25;
const KINDS = {fan: {middle: FAN_HEIGHT, reach: 1.1}, stone: {middle: 0.4, reach: 1.0}, house: {middle: 1.6, reach: 2.6}, walker: {middle: 1, reach: 1}};
const DETAIL = {detail: 0.25, detail_length: 0.5};
const find = (id) => document.getElementById(id);

class Page {
    constructor(shaders, scenes) {
        Object.assign(this, {scenes, canvas: find("view"), queue: [], begins: false, owed: 0, paused: false, slow: false, busy: true, number: 0,
            waiting: new Map(), userObjects: [], placed: {}, moved: {}, made: [], session: 0, markedId: null, frames: 0, shown: null, turned: 0});
        this.camera = {target: [0, 0.5, 0], distance: 7, yaw: 60, pitch: 15, view: 0.8};
        this.device = new Device(this.canvas, shaders);
        this.meadow = new Meadow(this.device);
        this.field = new Field();
        this.overlays = new Overlays(this.device, this.meadow, this.field);
        this.graph = new Graph(find("graph"));
        this.hands = new Hands(this.canvas, this);
        this.panel = new Panel(find("rows"), TABLES, (...change) => this.changeSetting(...change));
        const wanted = new URLSearchParams(location.search).get("quality");
        this.adapts = wanted === null;
        this.startQuality = wanted === null ? (this.device.software ? 0 : 2) : Math.min(Math.max(Number(wanted), 0), QUALITIES.length - 1);
        this.buttons();
    }
    async begin() {
        const simd = WebAssembly.validate(new Uint8Array(SIMD_PROBE));
        const form = simd ? "windrow" : "windrow_plain";
        const later = `${form}_rest.lzma`;
        const [script, wasm, rest] = await Promise.all([fetchFile("worker.js"), fetchFile(`${form}.lzma`),
            isInlined ? fetchFile(later) : new URL(later, location.href).href]);
        this.worker = new Worker(URL.createObjectURL(new Blob([script], {type: "text/javascript"})));
        this.worker.onmessage = ({data}) => this.answered(data);
        this.worker.onerror = (event) => this.say(event.message, true);
        const started = this.ask("begin", {wasm, rest, patience: window.windrowPatience}, [wasm]);
        this.device.ready();
        this.meadow.setQuality(this.startQuality);
        const {version} = await started;
        find("version").textContent = version;
        const link = location.hash.length > 2 ? await fromLink(location.hash.slice(1)).catch(() => null) : null;
        await this.load(link?.scene ?? 0, {text: link?.text, frames: link?.frames, made: link?.made});
        requestAnimationFrame((now) => this.tick(now));
        await this.ask("rest").catch((fault) => this.missing(fault));
    }
    /** What acts on blades: slow machines leave out the ripples that are smaller than a cell. */
    get sampling() {
        return this.meadow.quality < 2 ? {} : DETAIL;
    }
    ask(call, values = {}, transfer = []) {
        const number = ++this.number;
        this.worker.postMessage({call, number, ...values}, transfer);
        return new Promise((resolve, reject) => this.waiting.set(number, {resolve, reject}));
    }
    answered(data) {
        if (data.did === "replaying") this.say(`Replaying the link: ${data.seconds.toFixed(0)} s`);
        else if (data.did === "vortex") this.vortex(data);
        else {
            const {resolve, reject} = this.waiting.get(data.number) ?? {};
            this.waiting.delete(data.number);
            if (data.did === "fault") reject?.(Object.assign(new Error(data.text), {late: data.late, broken: data.broken}));
            else resolve?.(data);
        }
    }
    /** A sentence, and where `retry` is given a button that calls it. */
    say(text, wrong = false, retry = null) {
        find("says").replaceChildren(text);
        find("says").classList.toggle("wrong", wrong);
        if (!retry) return;
        const button = Object.assign(document.createElement("button"), {textContent: "Try again"});
        button.addEventListener("click", () => {
            this.say("Loading ...");
            this.canvas.focus({preventScroll: true}); // the button goes
            retry().catch((fault) => this.missing(fault, retry));
        });
        find("says").append(" ", button);
    }
    /** A part of the page did not come, or what else went wrong; `retry` asks for it again. */
    missing(fault, retry = () => this.again()) {
        this.broken ||= fault.broken === true;
        if (!fault.late) this.say(fault.message, true);
        else this.say(`A part of the page is missing: ${fault.message}.`, true, retry);
    }
    async again() {
        const answer = await this.ask("again", {sampling: this.sampling});
        Object.assign(this, {broken: false, busy: false, queue: []});
        if (answer.halves) this.took(answer);
        this.say("");
    }
    /** The script of trees and furred bodies, once; what failed is fetched again by the next call. */
    async needScenery() {
        if (this.meadow.scenery) return this.meadow.scenery;
        this.say("Loading trees and fur ...");
        const text = await fetchFile("scenery.js").catch((fault) => {
            throw Object.assign(fault, {late: true});
        });
        const script = document.createElement("script");
        script.src = URL.createObjectURL(new Blob([text], {type: "text/javascript"}));
        await new Promise((resolve, reject) => {
            script.onload = script.onerror = () => (window.WindrowScenery ? resolve() : reject(Object.assign(new Error("scenery.js is damaged"), {late: true})));
            document.head.append(script);
        });
        return (this.meadow.scenery = new window.WindrowScenery(this.device));
    }

    // --- scenes ------------------------------------------------------------------------------------------------------
    /** A scene of the list, or one of a text; a rejected one leaves what is there. */
    async load(index, {text, frames, files = {}, made} = {}) {
        const shown = this.scenes[index];
        text ??= shown.text;
        this.busy = true;
        const plants = {plant: shown.plant ?? "GRASS", blade: {...BLADES[shown.plant ?? "GRASS"], ...shown.blade}};
        const picture = pictureOf(text);
        let loaded, wants = null;
        try {
            for (const name of shown.files ?? [])
                files[name] = new Uint8Array(await fetchFile(`scenes/${name}`).catch((fault) => {
                    throw Object.assign(fault, {late: true});
                }));
            if (picture.trees?.length || picture.bodies?.length) wants = (await this.needScenery()).wants(picture);
            loaded = await this.ask("load", {text, files: {...this.dropped, ...files}, plants, frames, sampling: this.sampling, scenery: wants});
        } catch (fault) {
            find("scene").value = String(this.index ?? index);
            throw fault;
        } finally {
            this.busy = false;
        }
        Object.assign(this, {index, text, shown, description: JSON.parse(text), queue: [], owed: 0, userObjects: [], markedId: null,
            session: this.session + 1, made: made ?? []});
        this.meadow.setScene(loaded, shown, this.terrainOf(files), picture);
        this.field.set(loaded.halves, loaded.cells, loaded.box);
        const {target, distance, yaw, pitch} = shown.camera;
        Object.assign(this.camera, {target: [...target], distance, yaw, pitch});
        if (this.canvas.clientWidth < this.canvas.clientHeight) this.camera.distance *= 1.25;
        this.camera.target[1] += this.meadow.groundHeight(target[0], target[2]) - this.meadow.box.origin[1];
        this.overlays.clear();
        Object.assign(this.overlays, shown.overlays ?? {}, {max: this.topSpeed()});
        this.moved = {};
        this.replayed = frames ? {hash: loaded.hash, units: loaded.units} : null;
        this.took(loaded);
        find("scene").value = String(index);
        this.panel.show({air: this.description.air, profile: this.description.air.profile, gusts: this.description.air.gusts,
            ...Object.fromEntries(Object.entries(loaded.made).map(([key, {values}]) => [key, values]))});
        this.showState();
        this.say(wants?.leftOut.length ? `This page does not draw ${wants.leftOut.join(", ")}.` : "");
    }
    /** [m] Where keys stroke and blast: above the ground, or where a crown or a body is. */
    handHeight(x, z, above) {
        return this.meadow.scenery?.shows ? this.camera.target[1] : this.meadow.groundHeight(x, z) + above;
    }
    topSpeed() {
        const {ambient = [0, 0, 0]} = this.description.air;
        const motors = (this.description.motors ?? []).map((motor) => 0.7 * (motor.law?.drive?.speed ?? 0));
        return Math.max(1.5 * Math.hypot(...ambient), ...motors, 2);
    }
    terrainOf(files) {
        const ground = (this.description.obstacles ?? []).find(({shape}) => shape.ground);
        const bytes = ground && files[ground.shape.ground.file];
        if (!bytes) return null;
        const head = new TextDecoder("latin1").decode(bytes.subarray(0, 64)).match(/^P5\s+(\d+)\s+(\d+)\s+(\d+)\s/);
        if (!head) return null;
        const [nx, nz, most] = head.slice(1).map(Number);
        const [scale, high] = [ground.shape.ground.scale ?? [1, 1, 1], ground.position[1]];
        const view = new DataView(bytes.buffer, bytes.byteOffset + head[0].length);
        const heights = Float32Array.from({length: nx * nz}, (_, n) => high + (scale[1] * (most > 255 ? view.getUint16(2 * n) : view.getUint8(n))) / most);
        return {corners: [nx, nz], corner: [ground.position[0], ground.position[2]], extent: [(nx - 1) * scale[0], (nz - 1) * scale[2]], heights};
    }
    /** What of the scene hands may take: jets and bodies of a name of their own that follow no path. */
    sceneObjects() {
        const names = [...(this.description.motors ?? []), ...(this.description.obstacles ?? [])].map(({name}) => name);
        const single = ({name, path, turn_path: turning}) => name && !path && !turning && names.filter((other) => other === name).length === 1;
        const jets = (this.description.motors ?? []).filter((motor) => motor.kind === "jet" && single(motor)).map((motor) => ({id: motor.name,
            kind: "jet", motor, at: motor.position, yaw: (-Math.atan2(motor.direction?.[2] ?? 0, motor.direction?.[0] ?? 1) * 180) / Math.PI,
            middle: 0, reach: (motor.start_radius ?? 0.5) + 0.4}));
        const bodies = (this.description.obstacles ?? []).filter((body) => single(body) && !body.shape.ground).map((body) => ({id: body.name,
            kind: "body", body, at: body.position ?? [0, 0, 0], yaw: body.turn_deg?.[0] ?? 0, middle: 0, reach: reachOf(body.shape)}));
        return [...jets, ...bodies].map((object) => ({...object, ...this.placed[object.id], ...this.moved[object.id]}));
    }
    objects() {
        return [...this.sceneObjects(), ...this.userObjects.map((object) => ({...object, ...KINDS[object.kind], ...this.moved[object.id]}))];
    }
    bodyList(seconds) {
        this.turned += this.paused ? 0 : seconds * 700;
        const list = [];
        const {solids} = this.meadow;
        const scene = Object.fromEntries(this.sceneObjects().map((object) => [object.id, object]));
        const hidden = new Set((this.description.picture?.obstacles ?? []).filter((look) => look.hidden).map(({name}) => name));
        for (const body of (this.description.obstacles ?? []).filter(({name}) => !hidden.has(name))) {
            const object = scene[body.name];
            list.push(...solids.ofBody(object ? {...body, position: object.at, turn_deg: [object.yaw, ...(body.turn_deg ?? [0, 0, 0]).slice(1)]} : body)
                .map(([mesh, model, tint]) => [mesh, model, object && object.id === this.markedId ? marking(tint) : tint]));
        }
        for (const object of this.objects()) {
            const marked = object.id === this.markedId;
            if (object.kind === "jet") {
                const ground = this.meadow.groundHeight(object.at[0], object.at[2]);
                list.push(...solids.ofFan([object.at[0], ground, object.at[2]], object.yaw, object.at[1] - ground, object.motor.start_radius ?? 0.5, this.turned, marked));
            } else if (object.kind === "fan") list.push(...solids.ofFan(object.at, object.yaw, FAN_HEIGHT, 0.8, this.turned, marked));
            else if (object.kind === "walker") list.push(...solids.ofWalker([object.at[0], this.meadow.groundHeight(object.at[0], object.at[2]), object.at[2]], marked));
            else if (object.kind !== "body")
                bodiesOf(object.kind, object.at, object.yaw).forEach((body, n) =>
                    list.push(...solids.ofBody({...body, name: object.kind === "house" && n ? "roof" : object.kind})
                        .map(([mesh, model, tint]) => [mesh, model, marked ? marking(tint) : tint])));
        }
        return list;
    }

    // --- what hands and keys do ----------------------------------------------------------------------------------------
    send(event, begins) {
        this.queue.push(event);
        this.begins ||= begins;
    }
    place(object, at, yaw, begins) {
        if (object.kind !== "jet" && object.kind !== "body") at = [at[0], this.meadow.groundHeight(at[0], at[2]), at[2]];
        this.moved[object.id] = {at, yaw};
        Object.assign(object, {at, yaw});
        this.send(["move", object.id, ...at.map((x) => Math.round(100 * x)), Math.round(yaw)], begins);
    }
    mark(id) {
        this.markedId = id;
        this.showState();
    }
    marked() {
        return this.objects().find(({id}) => id === this.markedId) ?? null;
    }
    /** Unit vectors to the right and toward the viewer, level. */
    ways() {
        const forward = unit(sub(this.camera.target, this.eye()).map((x, n) => (n === 1 ? 0 : x)));
        return [unit(cross(forward, [0, 1, 0])), scaled(forward, -1)];
    }
    eye() {
        const {target, distance, yaw, pitch} = this.camera;
        const [a, b] = [yaw, pitch].map((deg) => (deg * Math.PI) / 180);
        const eye = add(target, scaled([Math.cos(b) * Math.cos(a), Math.sin(b), Math.cos(b) * Math.sin(a)], distance));
        eye[1] = Math.max(eye[1], this.meadow.groundHeight(eye[0], eye[2]) + 0.45);
        return eye;
    }
    act(action) {
        const {target} = this.camera;
        if (action === "pause") this.paused = !this.paused;
        else if (action === "slow") this.slow = !this.slow;
        else if (action === "step") {
            this.paused = true;
            this.owed = UNITS_A_SECOND / (this.description.tick_hz ?? 30);
            this.oneStep = true;
        } else if (action === "undo") this.undo();
        else if (action === "blast") this.send(["blast", ...[target[0], this.handHeight(target[0], target[2], 0.6), target[2]].map((x) => Math.round(100 * x))], true);
        else if (action === "gust") this.hands.gust();
        else if (action in KINDS) {
            const [right, toward] = this.ways();
            const [aside, away] = {fan: [-2.2, 0.5], stone: [1.2, 0.6], house: [1, 5.5], walker: [0.5, 1.5]}[action];
            const at = add(target, add(scaled(right, aside), scaled(toward, -away)));
            at[1] = this.meadow.groundHeight(at[0], at[2]);
            this.nextId = (this.nextId ?? 0) + 1;
            const id = `${action} ${this.session}.${this.nextId}`;
            this.userObjects.push({id, kind: action, at, yaw: 0});
            this.send(["add", id, action, ...at.map((x) => Math.round(100 * x)), 0], true);
            this.mark(id);
        } else if (action === "remove") {
            if (this.userObjects.some(({id}) => id === this.markedId)) {
                this.send(["remove", this.markedId], true);
                this.userObjects = this.userObjects.filter(({id}) => id !== this.markedId);
                this.mark(null);
            } else this.say("Choose a fan, stone, house or walker that was added: N takes the next one.");
        } else if (action === "next") {
            const ids = this.objects().map(({id}) => id);
            this.mark(ids[(ids.indexOf(this.markedId) + 1) % Math.max(ids.length, 1)] ?? null);
        } else if (action === "turn") {
            const object = this.marked();
            if (object) this.place(object, object.at, (object.yaw + 15) % 360, true);
        } else if (action === "link") this.copyLink();
        else if (action === "panel") find("panel").hidden = !find("panel").hidden;
        this.showState();
    }
    async undo() {
        while (this.busy) await new Promise((resolve) => setTimeout(resolve, 5));
        this.busy = true;
        const answer = await this.ask("undo", {sampling: this.sampling}).catch((fault) => this.missing(fault)).finally(() => (this.busy = false));
        if (!answer) return;
        this.queue = [];
        this.took(answer);
        this.say(answer.undone ? "" : "There is nothing to undo.");
    }
    async link() {
        const {frames, hash, units} = await this.ask("log");
        const own = this.text === this.scenes[this.index].text ? {} : {text: this.text};
        const code = await toLink({scene: this.index, ...own, frames: JSON.parse(frames)});
        return {address: `${location.href.split("#")[0]}#${code}`, hash, units};
    }
    async copyLink() {
        const {address} = await this.link();
        history.replaceState(null, "", address);
        await navigator.clipboard?.writeText(address).catch(() => {});
        this.say("The link is in the address bar and, where the browser allows it, in the clipboard.");
    }
    async changeSetting(group, name, value) {
        if (["fan", "blast", "stroke"].includes(group)) {
            const [head, inner] = name.split(".");
            return this.setNow(group, inner ? {[head]: {[inner]: value}} : {[name]: value});
        }
        const next = JSON.parse(this.text);
        const part = group === "air" ? next.air : (next.air[group] ??= {});
        part[name] = value;
        if (group === "air" && name === "ambient") {
            const fault = await this.setNow("wind", value);
            if (!fault) this.description.air.ambient = value;
            return fault;
        }
        if (group === "gusts" && this.meadow.tile !== this.meadow.empty3d && name !== "seed") {
            const fault = await this.setNow("gusts", part);
            if (!fault) this.description.air.gusts = part;
            return fault;
        }
        const [text, camera] = [JSON.stringify(next), {...this.camera}];
        return this.load(this.index, {text}).then(() => (Object.assign(this.camera, camera), null), (fault) => fault.message);
    }
    setNow(what, values) {
        return new Promise((resolve) => {
            this.settled ??= [];
            this.settled.push(resolve);
            this.send(["set", what, values], true);
        });
    }

    // --- a frame ---------------------------------------------------------------------------------------------------------
    took(answer) {
        this.meadow.setFrame(answer);
        this.field.set(answer.halves, this.meadow.cells, this.meadow.box);
        this.time = answer.time;
        this.resting = answer.resting;
        this.userObjects = answer.objects;
        this.placed = answer.placed;
        if (this.queue.length === 0) this.moved = {}; // else what a hand still drags stays under it
        if (answer.steps !== undefined) find("undo").disabled = answer.steps === 0;
        for (const {text} of answer.faults ?? []) this.say(text, true);
    }
    async advance() {
        const units = this.paused && !this.oneStep ? 0 : Math.floor(this.owed);
        if (this.busy || (units === 0 && this.queue.length === 0)) return;
        this.oneStep = false;
        this.owed -= units;
        this.busy = true;
        const [events, begins, settled] = [this.queue, this.begins, this.settled ?? []];
        Object.assign(this, {queue: [], begins: false, settled: []}); // the settings that wait are those of these events
        const want = {pressure: this.overlays.pressure && this.overlays.slices.length > 0, sleep: this.overlays.box};
        const answer = await this.ask("frame", {units, events, begins, sampling: this.sampling, want}).catch((fault) => {
            for (const resolve of settled) resolve(fault.message);
            throw fault;
        }).finally(() => (this.busy = false));
        this.tickMs = answer.ms;
        this.packMs = answer.packed;
        this.took(answer);
        for (const resolve of settled) resolve(answer.faults[0]?.text ?? null);
    }
    tick(now) {
        requestAnimationFrame((next) => this.tick(next));
        const seconds = Math.min((now - (this.last ?? now)) / 1000, MOST_SECONDS);
        const whole = now - (this.last ?? now);
        this.last = now;
        if (!this.paused) this.owed = Math.min(this.owed + seconds * UNITS_A_SECOND * (this.slow ? SLOW : 1), MOST_SECONDS * UNITS_A_SECOND);
        if (!this.broken)
            this.advance().catch((fault) => {
                this.broken ||= !fault.late; // else the air goes on, without what was asked for
                if (fault.late) this.missing(fault);
                else this.say(`The air has stopped; reload the page. ${fault.message}`, true);
            });
        const begun = performance.now();
        this.render(seconds);
        this.scriptMs = performance.now() - begun;
        ++this.frames;
        if (whole > 0 && whole < 2000) this.graph.add(whole, this.tickMs ?? 0);
        if (this.frames % 10 === 0) this.showFigures();
        if (this.adapts) this.adapt();
        if (this.frames === 2) document.documentElement.dataset.drawn = String(Math.round(performance.now()));
    }
    render(seconds) {
        const {canvas} = this;
        const pixels = Math.min(devicePixelRatio, QUALITIES[this.meadow.quality].pixels);
        const [width, height] = [canvas.clientWidth, canvas.clientHeight].map((x) => Math.max(Math.round(x * pixels), 1));
        if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, {width, height});
        const mark = this.marked();
        this.overlays.mark = mark ? mark.at : null;
        const over = this.overlays.shows ? (shared) => this.overlays.draw(shared, this.paused ? 0 : seconds * (this.slow ? SLOW : 1)) : null;
        this.meadow.draw({eye: this.eye(), target: this.camera.target, view: this.camera.view}, width, height, this.bodyList(seconds), over);
    }
    // The mean of some frames decides; a quality that was too slow is not tried again.
    adapt() {
        const rows = this.graph.rows.slice(-24).map(([frame]) => frame);
        const mean = rows.reduce((sum, ms) => sum + ms, 0) / Math.max(rows.length, 1);
        const {quality} = this.meadow;
        this.most ??= QUALITIES.length - 1;
        if (quality > 0 && ((rows.length >= 4 && mean > 90) || (rows.length === 24 && mean > 24))) this.most = quality - 1;
        else if (!(rows.length === 24 && mean < 17.6 && quality < this.most)) return;
        this.meadow.setQuality(Math.min(mean > 90 ? Math.max(quality - 2, 0) : mean > 24 ? quality - 1 : quality + 1, QUALITIES.length - 1));
        this.graph.rows = [];
    }
    showFigures() {
        const [frame, tick] = this.graph.means();
        this.graph.draw();
        find("figures").textContent = `frame ${frame.toFixed(1)} ms · tick ${tick.toFixed(1)} ms · ${Math.round(this.meadow.blades / 1000)},000 blades` +
            (this.resting ? " · the air rests" : "");
    }
    showState() {
        for (const [id, on] of Object.entries({pause: this.paused, slow: this.slow})) find(id).setAttribute("aria-pressed", String(on));
        const chosen = this.marked();
        for (const id of ["turn", "remove"]) find(id).disabled = chosen === null;
    }

    // --- controls ----------------------------------------------------------------------------------------------------------
    buttons() {
        for (const [n, {title}] of this.scenes.entries()) find("scene").add(new Option(title, String(n)));
        find("scene").addEventListener("change", () => this.choose(Number(find("scene").value)));
        for (const button of document.querySelectorAll("button[data-act]")) button.addEventListener("click", () => this.act(button.dataset.act));
        for (const box of document.querySelectorAll("input[data-show]")) box.addEventListener("change", () => (this.overlays[box.dataset.show] = box.checked));
        find("slice").addEventListener("change", () => this.setSlice());
        find("along").addEventListener("input", () => this.setSlice());
        find("vortices").addEventListener("click", () => this.runVortices());
        document.addEventListener("dragover", (event) => event.preventDefault());
        document.addEventListener("drop", (event) => {
            event.preventDefault();
            this.drop([...event.dataTransfer.files]).catch((fault) => this.missing(fault));
        });
    }
    choose(index) {
        const load = () => (this.broken ? this.again() : Promise.resolve()).then(() => this.load(index));
        return load().catch((fault) => this.missing(fault, load));
    }
    setSlice() {
        const axis = Number(find("slice").value);
        this.overlays.slices = axis < 0 ? [] : [[axis, Number(find("along").value)]];
    }
    /** JSON is a scene; other files are those that it names. An OBJ or a height map alone becomes a body of the present scene. */
    async drop(files) {
        this.dropped ??= {};
        for (const file of files) this.dropped[file.name] = new Uint8Array(await file.arrayBuffer());
        const scene = files.find(({name}) => name.endsWith(".json"));
        for (const {name} of files) if (/\.obj$/i.test(name)) this.meadow.solids.addFile(name, new TextDecoder().decode(this.dropped[name]));
        const next = JSON.parse(scene ? new TextDecoder().decode(this.dropped[scene.name]) : this.text);
        if (!scene)
            for (const {name} of files) {
                const [x, , z] = this.camera.target;
                if (/\.obj$/i.test(name)) (next.obstacles ??= []).push({name, position: [x, 0, z], shape: {mesh: {file: name}}});
                if (/\.pgm$/i.test(name)) (next.obstacles ??= []).push({name, position: [x - 24, 0, z - 24], shape: {ground: {file: name, scale: [0.5, 4, 0.5]}}});
            }
        await this.load(this.index, {text: JSON.stringify(next), files: {...this.dropped}});
    }
    async runVortices() {
        find("vortices").disabled = true;
        this.points = [];
        find("errors").hidden = false;
        await this.ask("vortices", {cells: 32}).catch((fault) => this.missing(fault));
        find("vortices").disabled = false;
    }
    vortex(point) {
        this.points.push(point);
        drawErrors(find("errors"), this.points);
        const last = [0, 1].map((scheme) => this.points.filter((one) => one.scheme === scheme).pop()).filter(Boolean);
        find("speeds").textContent = last.map(({name, error, ms}) => `${name}: error ${error.toPrecision(3)}, ${ms.toFixed(2)} ms a step`).join("; ");
    }
}
/** What a scene's text has of a picture; the library says what is wrong with one that cannot be read. */
function pictureOf(text) {
    try {
        return JSON.parse(text).picture ?? {};
    } catch {
        return {};
    }
}
function reachOf(shape) {
    const [kind, value] = Object.entries(shape)[0];
    return kind === "block" ? Math.min(Math.hypot(...value.half_size), 2.5) : value.radius ?? 1;
}
const SIMD_PROBE = [0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11];

try {
    const page = new Page(SHADERS, SCENES);
    window.windrow = page;
    page.begin().catch((fault) => page.say(`The page cannot begin: ${fault.message}`, true, () => (location.reload(), new Promise(() => {}))));
} catch (fault) {
    find("says").textContent = fault.message;
}
