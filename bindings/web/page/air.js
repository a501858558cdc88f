// The air of one scene and what hands do to it: a log of frames that gives the same bits each time it is played.
//
// A frame is a number of time units and the events at its beginning. Events hold whole numbers, lengths in centimetres, so that text
// keeps them. What a link holds is the scene and this log.
//   ["stroke", n, x, y, z]           the wake of stroke n is at a place; the first event begins it
//   ["release", n]                   it ends
//   ["blast", x, y, z]
//   ["add", id, kind, x, y, z, yaw]  kind: fan, stone, house, walker; yaw in degrees
//   ["move", id, x, y, z, yaw]       one of these, or a body of the scene by name
//   ["remove", id]
//   ["set", struct, values]          wind, gusts, and what fans, blasts and strokes are made of
import {Wind} from "../package/windrow.js";
import {Late} from "./parts.js";
import {MAKES, UNITS_A_SECOND, FAN_HEIGHT, bodiesOf, fanDirection} from "./made.js";

const SNAPSHOT_BYTES = 96 << 20; // of all steps that can be undone
const WALK = {radius: 2.5, speed: 1.4};
const GROUND = {texels: 128, size: 0.25};

const clone = (value) => JSON.parse(JSON.stringify(value));
const quaternion = ([yaw, pitch, roll]) => {
    const [y, x, z] = [yaw, pitch, roll].map((deg) => (deg * Math.PI) / 360);
    const [cy, sy, cx, sx, cz, sz] = [Math.cos(y), Math.sin(y), Math.cos(x), Math.sin(x), Math.cos(z), Math.sin(z)];
    return [cy * sx * cz + sy * cx * sz, sy * cx * cz - cy * sx * sz, cy * cx * sz - sy * sx * cz, cy * cx * cz + sy * sx * sz];
};
export class Air {
    /** Of the text of a scene, beside whose path its files are; throws the sentence of what is wrong. */
    constructor(library, text, files = {}) {
        this.library = library;
        this.description = JSON.parse(text);
        for (const [name, bytes] of Object.entries(files)) library.module.files["/" + name] = bytes;
        this.scene = library.withBytes(new TextEncoder().encode(text), (at, size) =>
            library.handle("windrow_scene_parse", at, size, "/scene.json", 0));
        this.wind = Object.create(Wind.prototype);
        Object.assign(this.wind, {library, at: library.call("windrow_scene_wind", this.scene)});
        this.wind.cells = Number(library.call("windrow_wind_cell_count", this.wind.at));
        this.wind.texels = library.module._malloc(8 * this.wind.cells);
        this.makes = clone(MAKES);
        this.objects = {}; // by id: kind, at, yaw, motor, bodies
        this.placed = {}; // of the scene's own by name, once moved: at, yaw
        this.strokes = {};
        this.frames = []; // [units, events] each
        this.units = 0;
        this.snapshots = [];
        this.ground = 0;
        this.lastDiagnostics = 0;
        this.diagnostics = library.module._malloc(library.structs.windrow_diagnostics.size);
        library.reset("windrow_diagnostics", this.diagnostics);
        this.advanceAt = library.module._malloc(library.structs.windrow_advance.size);
    }
    destroy() {
        const {library} = this;
        if (this.ground) library.call("windrow_ground_destroy", this.ground);
        library.call("windrow_scene_destroy", this.scene);
        for (const at of [this.wind.texels, this.wind.block ?? 0, this.diagnostics, this.advanceAt]) library.module._free(at);
    }
    get time() {
        return this.library.call("windrow_scene_time", this.scene);
    }

    // --- what hands do -----------------------------------------------------------------------------------------------
    apply([kind, ...values]) {
        this["do_" + kind](...values);
    }
    do_stroke(n, ...place) {
        const at = place.map((cm) => cm / 100);
        if (this.strokes[n]) this.wind.move(this.strokes[n], at);
        else this.strokes[n] = this.wind.add("wake", {...this.makes.stroke.values, position: at});
    }
    do_release(n) {
        if (this.strokes[n]) this.wind.remove(this.strokes[n]);
        delete this.strokes[n];
    }
    do_blast(...place) {
        this.wind.add("pressure", {...this.makes.blast.values, position: place.map((cm) => cm / 100)});
    }
    do_add(id, kind, x, y, z, yaw) {
        const object = {kind, at: [x, y, z].map((cm) => cm / 100), yaw, begun: this.units};
        if (kind === "fan") object.motor = this.wind.add("jet", this.fan(object));
        if (kind === "walker") {
            object.motor = this.wind.add("wake", {...this.makes.walker.values, position: this.walk(object, this.units)});
            this.needGround();
        }
        object.bodies = bodiesOf(kind, object.at, yaw).map((body) => this.addBody(body));
        this.objects[id] = object;
    }
    fan({at, yaw}) {
        return {...this.makes.fan.values, position: [at[0], at[1] + FAN_HEIGHT, at[2]], direction: fanDirection(yaw)};
    }
    addBody({position, turn_deg: turn, shape}) {
        const [kind, sizes] = Object.entries(shape)[0];
        return this.library.within(() => this.library.result("windrow_obstacle_id", "windrow_wind_add_obstacle", this.wind.at,
            this.library.make("windrow_obstacle", {position, orientation: quaternion(turn), shape: {kind, ...sizes}})));
    }
    do_move(id, x, y, z, yaw) {
        const at = [x, y, z].map((cm) => cm / 100);
        const object = this.objects[id];
        if (!object) {
            this.moveOfScene(id, at, yaw);
            return;
        }
        Object.assign(object, {at, yaw});
        if (object.kind === "fan") this.wind.set("jet", object.motor, this.fan(object));
        bodiesOf(object.kind, at, yaw).forEach((body, n) => this.moveBody(object.bodies[n], body.position, body.turn_deg));
    }
    moveBody(id, position, turn) {
        const {library} = this;
        library.within(() => library.call("windrow_wind_move_obstacle", this.wind.at, library.make("windrow_obstacle_id", id),
            library.make("windrow_dvec3", position), library.make("windrow_quat", quaternion(turn)), 0));
    }
    // A motor of the scene keeps all but its place and, of a jet, its direction.
    moveOfScene(name, at, yaw) {
        const {library} = this;
        this.placed[name] = {at, yaw};
        library.within(() => {
            const id = library.room(12);
            const isMotor = (this.description.motors ?? []).some((motor) => motor.name === name);
            library.call(isMotor ? "windrow_scene_motor" : "windrow_scene_obstacle", this.scene, name, id);
            if (!isMotor) {
                this.moveBody(library.read("windrow_obstacle_id", id), at, [yaw, 0, 0]);
                return;
            }
            const jet = library.make("windrow_jet_motor");
            library.call("windrow_wind_get_jet", this.wind.at, id, jet);
            library.write("windrow_jet_motor", jet, {position: at, direction: fanDirection(yaw)});
            library.call("windrow_wind_set_jet", this.wind.at, id, jet);
        });
    }
    do_remove(id) {
        const object = this.objects[id];
        const {library} = this;
        if (object.motor) this.wind.remove(object.motor);
        for (const body of object.bodies)
            library.within(() => library.call("windrow_wind_remove_obstacle", this.wind.at, library.make("windrow_obstacle_id", body)));
        delete this.objects[id];
    }
    do_set(what, values) {
        const {library} = this;
        library.within(() => {
            if (what === "wind") library.call("windrow_wind_set_ambient", this.wind.at, library.make("windrow_vec3", values));
            else if (what === "gusts") library.call("windrow_wind_set_gusts", this.wind.at, library.make("windrow_gusts", values));
            else {
                const make = this.makes[what];
                const merged = {...make.values, ...values, law: {...make.values.law, ...values.law}};
                if (!make.values.law) delete merged.law;
                const probe = this.wind.add(make.kind, {...merged, position: [0, 0, 0]}); // rejects what no motor may have
                this.wind.remove(probe);
                make.values = merged;
                for (const object of Object.values(this.objects))
                    if (what === "fan" && object.kind === "fan") this.wind.set("jet", object.motor, this.fan(object));
            }
        });
    }

    // --- time --------------------------------------------------------------------------------------------------------
    walk({at, begun}, units) {
        const way = ((units - begun) / UNITS_A_SECOND) * WALK.speed / WALK.radius;
        return [at[0] + WALK.radius * (Math.cos(way) - 1), at[1] + 0.8, at[2] - WALK.radius * Math.sin(way)];
    }
    needGround() {
        if (this.ground) return;
        const {library} = this;
        library.within(() => {
            this.ground = library.handle("windrow_ground_create",
                library.make("windrow_ground_config", {texels: GROUND.texels, texel_size: GROUND.size}), 0);
            library.call("windrow_ground_follow", this.ground, library.make("windrow_dvec3", this.middle()));
        });
    }
    middle() {
        const box = this.wind.box();
        return [box.origin[0] + box.size[0] / 2, box.origin[1], box.origin[2] + box.size[2] / 2];
    }
    /** A frame of `units`, with what happens at its beginning. It is logged, as far as the library accepts it. */
    frame(units, events) {
        const {library} = this;
        const faults = [];
        const accepted = [];
        for (const event of events)
            try {
                this.apply(event);
                accepted.push(event);
            } catch (fault) {
                if (fault instanceof Late) throw fault;
                faults.push({event, text: fault.message});
            }
        const end = this.units + units;
        const walkers = [];
        for (const object of Object.values(this.objects))
            if (object.kind === "walker") {
                const [before, now] = [this.walk(object, this.units), this.walk(object, end)];
                this.wind.move(object.motor, now);
                walkers.push({position: now, previous: before, foot_height: 0, previous_foot_height: 0, radius: 0.45, weight: 1});
            }
        if (units > 0) {
            library.reset("windrow_advance", this.advanceAt);
            library.call("windrow_scene_advance", this.scene, units / UNITS_A_SECOND, this.advanceAt);
            if (this.ground) this.advanceGround(units / UNITS_A_SECOND, walkers);
        }
        this.units = end;
        this.remember(units, accepted);
        return faults;
    }
    remember(units, events) {
        const last = this.frames[this.frames.length - 1];
        if (events.length === 0 && last && last[0] === units && last[1].length === 0) last[2] = (last[2] ?? 1) + 1;
        else if (units > 0 || events.length > 0) this.frames.push(events.length ? [units, events] : [units, []]);
    }
    advanceGround(duration, walkers) {
        const {library} = this;
        library.within(() => {
            const size = library.structs.windrow_ground_walker.size;
            const at = walkers.length ? library.room(size * walkers.length) : 0;
            walkers.forEach((walker, n) => library.write("windrow_ground_walker", at + n * size, walker));
            library.call("windrow_ground_advance", this.ground,
                library.make("windrow_ground_step", {duration, walker_count: walkers.length, walkers: at}), 0, 0n);
        });
    }
    /** Ground texels (lean x, lean z, trample, trail) and their place, or null while nobody has walked. */
    groundTexels() {
        const {library} = this;
        if (!this.ground) return null;
        return library.within(() => {
            const count = library.room(8);
            const first = library.call("windrow_ground_texels", this.ground, count);
            const texels = new Float32Array(library.memory, first, 4 * library.data.getUint32(count, true)).slice();
            const block = library.room(library.structs.windrow_ground_block.size);
            library.call("windrow_ground_block_of", this.ground, library.make("windrow_dvec3"), block);
            return {texels, place: library.module.HEAPU8.slice(block, block + library.structs.windrow_ground_place_block.size)};
        });
    }

    // --- undo, replay, hash ------------------------------------------------------------------------------------------
    snapshot() {
        const {library} = this;
        this.snapshots.push({
            scene: library.bytes("windrow_scene_save", this.scene),
            ground: this.ground ? library.bytes("windrow_ground_save", this.ground) : null,
            rest: clone({objects: this.objects, placed: this.placed, strokes: this.strokes, makes: this.makes, units: this.units, frames: this.frames}),
        });
        let bytes = this.snapshots.reduce((sum, one) => sum + one.scene.length, 0);
        while (bytes > SNAPSHOT_BYTES) bytes -= this.snapshots.shift().scene.length;
    }
    /** Back to the last snapshot; false where there is none. */
    undo() {
        const {library} = this;
        const last = this.snapshots.pop();
        if (!last) return false;
        library.withBytes(last.scene, (at, size) => library.call("windrow_scene_restore", this.scene, at, size));
        if (this.ground) library.call("windrow_ground_destroy", this.ground);
        this.ground = last.ground ? library.withBytes(last.ground, (at, size) =>
            library.handle("windrow_ground_load", at, size, 0)) : 0;
        Object.assign(this, last.rest);
        return true;
    }
    /** The log as text, and a frame-by-frame iterator over one. */
    log() {
        return JSON.stringify(this.frames);
    }
    static *played(frames) {
        for (const [units, events, times = 1] of frames) for (let n = 0; n < times; ++n) yield [units, n === 0 ? events : []];
    }
    /** 16 digits of the velocities of all cells, as they are after the last tick. */
    hash() {
        const {library} = this;
        return library.within(() => {
            const at = library.room(8), count = library.room(8);
            library.call("windrow_wind_field", this.wind.at, 0, at, count, 0);
            const words = new Uint32Array(library.memory, library.data.getUint32(at, true), 4 * this.wind.cells);
            let low = 0x811c9dc5, high = 0x9e3779b9;
            for (const word of words) {
                low = Math.imul(low ^ word, 0x01000193);
                high = Math.imul(high ^ (word + (low >>> 7)), 0x85ebca6b);
            }
            return [high, low].map((word) => (word >>> 0).toString(16).padStart(8, "0")).join("");
        });
    }
}
