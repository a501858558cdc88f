// The worker: it owns the library and the air. One message in, one out; big arrays are handed over, not copied.
import {Air} from "./air.js";
import {UNITS_A_SECOND} from "./made.js";
import {Late, instantiateParts} from "./parts.js";
import {runVortices} from "./vortices.js";

let library = null;
let parts = null; // of its module
let source = null; // of its parts: wasm, rest
let begun = null; // what the air was loaded of
let broken = ""; // why a call of the module was left half done
let air = null;
let grass = null; // of the scene's plants: blade class, springs
let scenery = null; // of the scene's trees and coats: blocks
let lastHash = "";
const FIRST_EVENTS = new Set(["stroke", "release", "blast"]); // which need no more than the first part, as first_picture.mjs plays it

function copyOf(at, name) {
    return library.module.HEAPU8.slice(at, at + library.structs[name].size);
}
function plantsOf({plant = "GRASS", blade = {}}) {
    return library.within(() => {
        const stalk = library.make("windrow_drag");
        library.call("windrow_drag_of", library.choices[`WINDROW_PLANT_${plant}`], stalk);
        if (blade.length) library.write("windrow_drag", stalk, {length: blade.length});
        const {length, ...settings} = blade;
        const blades = library.handle("windrow_blades_create", library.make("windrow_blade_settings", {stalk, ...settings}));
        const block = library.room(library.structs.windrow_blade_block.size);
        library.call("windrow_blades_block", blades, block);
        const bytes = copyOf(block, "windrow_blade_block");
        library.call("windrow_blades_destroy", blades);
        const spring = library.result("windrow_spring_class", "windrow_spring_class_of", library.choices[`WINDROW_SPRING_${plant}`]);
        return {block: bytes, spring};
    });
}
/** The four bands' coefficients of a frame of `duration` [s]. */
function swingSteps(duration) {
    return library.within(() => {
        const size = library.structs.windrow_swing_block.size;
        const blocks = library.room(4 * size);
        library.call("windrow_swing_steps_make", library.make("windrow_spring_class", grass.spring), duration, blocks);
        return library.module.HEAPU8.slice(blocks, blocks + 4 * size);
    });
}
/** Blocks of trees' and coats' classes, for shaders; `wants` is of scenery.js. */
function sceneryOf({classes, coats}) {
    const {choices} = library;
    return library.within(() => {
        const drag = (plant, values) => {
            const at = library.make("windrow_drag");
            library.call("windrow_drag_of", choices[`WINDROW_PLANT_${plant}`], at);
            return library.write("windrow_drag", at, values);
        };
        const block = (name, made, fill, destroy) => {
            const at = library.room(library.structs[name].size);
            library.call(fill, made, at);
            const floats = new Float32Array(copyOf(at, name).buffer);
            library.call(destroy, made);
            return floats;
        };
        const trees = classes.map(({trunk, branch}) => block("windrow_tree_block", library.handle("windrow_tree_create", library.make("windrow_tree_classes",
            {trunk: drag("SMALL_TRUNK", trunk), branch: drag("BRANCH", branch), leaf: drag("TWIG", {})})), "windrow_tree_block_of", "windrow_tree_destroy"));
        const shells = coats.map(({strand, ...layers}) => block("windrow_shell_block", library.handle("windrow_shells_create",
            library.make("windrow_shell_settings", {...layers, ...(strand ? {strand: {struct: "windrow_drag", values: strand}} : {})})),
        "windrow_shells_block", "windrow_shells_destroy"));
        return {trees, coats: shells};
    });
}
/** A frame of `duration` [s] of trees: four bands each of trunk, limbs and twigs, then the leaves' flutter. */
function treeMotion(duration) {
    const {structs, choices} = library;
    return library.within(() => {
        const size = structs.windrow_spring_block.size, all = library.room(12 * size + structs.windrow_flutter_block.size);
        const step = library.room(structs.windrow_spring_step.size), bands = library.room(4 * structs.windrow_spring_class.size);
        ["TRUNK", "BRANCH", "TWIG"].forEach((plant, n) => {
            const spring = library.result("windrow_spring_class", "windrow_spring_class_of", choices[`WINDROW_SPRING_${plant}`]);
            library.call("windrow_spring_bands", library.make("windrow_spring_class", spring), bands);
            for (let band = 0; band < 4; ++band) {
                library.call("windrow_spring_step_make", bands + band * structs.windrow_spring_class.size, duration, step);
                library.call("windrow_spring_step_block", step, all + (4 * n + band) * size);
            }
        });
        library.call("windrow_flutter_step_make", 0, air.time, duration, all + 12 * size);
        return new Float32Array(library.memory, all, 3 * size + structs.windrow_flutter_block.size / 4).slice();
    });
}
function floats(name, count) {
    const at = library.module._malloc(4 * count);
    library.call(name, air.wind.at, at, BigInt(count));
    const values = new Float32Array(library.memory, at, count).slice();
    library.module._free(at);
    return values;
}

function view({units, sampling, want = {}}) {
    const start = performance.now();
    const halves = air.wind.halves().slice();
    const block = air.wind.frameBlock([0, 0, 0], sampling);
    const packed = performance.now() - start;
    const ground = air.groundTexels();
    const answer = {halves, block, swing: swingSteps(units / UNITS_A_SECOND), ground, time: air.time, packed, placed: {...air.placed},
        objects: Object.entries(air.objects).map(([id, {kind, at, yaw, begun: since}]) =>
            ({id, kind, at: kind === "walker" ? air.walk({at, begun: since}, air.units) : at, yaw}))};
    if (scenery?.trees.length) answer.motion = treeMotion(units / UNITS_A_SECOND);
    if (want.pressure) answer.pressure = floats("windrow_wind_write_pressure", air.wind.cells);
    if (want.sleep) {
        const hash = air.hash();
        answer.resting = hash === lastHash;
        lastHash = hash;
    }
    return [answer, [halves.buffer, ...(ground ? [ground.texels.buffer] : []), ...(answer.pressure ? [answer.pressure.buffer] : [])]];
}

const calls = {
    async begin({wasm, rest, patience}) {
        self.windrowPatience = patience;
        source = {wasm, rest};
        parts = await instantiateParts(createWindrow, wasm, rest, INTERFACE);
        library = parts.library;
        return [{version: library.version}];
    },
    async load({frames, sampling, ...given}) {
        if (air || given.scenery || frames) await parts.fetchRest();
        const {text, files, plants} = given;
        const next = new Air(library, text, files); // a fault leaves the old one
        const blocks = given.scenery ? sceneryOf(given.scenery) : null;
        if (air) air.destroy();
        [air, scenery, begun] = [next, blocks, given];
        grass = plantsOf(plants ?? {});
        let played = 0;
        for (const [units, events] of Air.played(frames ?? [])) {
            air.frame(units, events);
            if (++played % 200 === 0) postMessage({did: "replaying", seconds: air.units / UNITS_A_SECOND});
        }
        const tile = air.wind.gustTile();
        const [first, transfer] = view({units: 1, sampling});
        if (frames) Object.assign(first, {hash: air.hash(), units: air.units});
        return [{...first, tile, cells: air.wind.box().cells, box: air.wind.box(), blade: grass.block, made: air.makes, scenery: blocks},
            [...transfer, ...(tile ? [tile.buffer] : [])]];
    },
    async rest() {
        await parts.fetchRest();
        return [{}];
    },
    /** After a load that failed: the rest is fetched again. Where a call was left half done, the air is played again in a new module. */
    async again({sampling}) {
        source.rest = await parts.fetchRest();
        if (broken) {
            const frames = air ? JSON.parse(air.log()) : [];
            parts = await instantiateParts(createWindrow, source.wasm, source.rest, INTERFACE);
            library = parts.library;
            parts.load();
            air = null;
            broken = "";
            if (begun) await calls.load({...begun, frames});
        }
        if (!air) return [{}];
        const [answer, transfer] = view({units: 1, sampling});
        return [{...answer, faults: [], steps: air.snapshots.length}, transfer];
    },
    async frame({units, events, begins, sampling, want}) {
        if (!events.every(([kind]) => FIRST_EVENTS.has(kind))) await parts.fetchRest();
        if (begins && parts.isWhole()) air.snapshot(); // the rest has it, and undo
        const start = performance.now();
        const faults = air.frame(units, events);
        const ms = performance.now() - start;
        const [answer, transfer] = view({units: Math.max(units, 1), sampling, want});
        return [{...answer, faults, ms, units, steps: air.snapshots.length}, transfer];
    },
    async undo({sampling}) {
        await parts.fetchRest();
        const undone = air.undo();
        const [answer, transfer] = view({units: 1, sampling});
        return [{...answer, undone, steps: air.snapshots.length}, transfer];
    },
    probe({point}) {
        return [{velocity: air.wind.velocity(point)}];
    },
    log() {
        return [{frames: air.log(), hash: air.hash(), units: air.units}];
    },
    async vortices({cells}) {
        await runVortices(library, cells, (point) => postMessage({did: "vortex", ...point}));
        return [{}];
    },
};

onmessage = async ({data}) => {
    const {call, number, ...values} = data;
    try {
        if (broken && call !== "again") throw new Late(broken);
        const [answered, transfer = []] = await calls[call](values);
        postMessage({did: call, number, ...answered}, transfer);
    } catch (fault) {
        const late = fault instanceof Late;
        if (late && fault.within) broken = fault.message;
        postMessage({did: "fault", call, number, late, broken: broken !== "", text: fault.message ?? String(fault)});
    }
};
