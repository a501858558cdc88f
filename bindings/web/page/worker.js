// The worker: it owns the library and the air. One message in, one out; big arrays are handed over, not copied.
import {Air} from "./air.js";
import {UNITS_A_SECOND} from "./made.js";
import {instantiateParts} from "./parts.js";
import {runVortices} from "./vortices.js";

let library = null;
let parts = null; // of its module
let air = null;
let grass = null; // of the scene's plants: blade class, springs
let lastHash = "";

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
function floats(name, count) {
    const at = library.module._malloc(4 * count);
    library.call(name, air.wind.at, at, BigInt(count));
    const values = new Float32Array(library.memory, at, count).slice();
    library.module._free(at);
    return values;
}

function view({units, sampling, want = {}}) {
    const begun = performance.now();
    const halves = air.wind.halves().slice();
    const block = air.wind.frameBlock([0, 0, 0], sampling);
    const packed = performance.now() - begun;
    const ground = air.groundTexels();
    const answer = {halves, block, swing: swingSteps(units / UNITS_A_SECOND), ground, time: air.time, packed, placed: {...air.placed},
        objects: Object.entries(air.objects).map(([id, {kind, at, yaw, begun: since}]) =>
            ({id, kind, at: kind === "walker" ? air.walk({at, begun: since}, air.units) : at, yaw}))};
    if (want.pressure) answer.pressure = floats("windrow_wind_write_pressure", air.wind.cells);
    if (want.sleep) {
        const hash = air.hash();
        answer.resting = hash === lastHash;
        lastHash = hash;
    }
    return [answer, [halves.buffer, ...(ground ? [ground.texels.buffer] : []), ...(answer.pressure ? [answer.pressure.buffer] : [])]];
}

const calls = {
    async begin({wasm, rest}) {
        parts = await instantiateParts(createWindrow, wasm, rest, INTERFACE);
        library = parts.library;
        return [{version: library.version}];
    },
    load({text, files, plants, frames, sampling}) {
        const next = new Air(library, text, files); // a fault leaves the old one
        if (air) air.destroy();
        air = next;
        grass = plantsOf(plants ?? {});
        let played = 0;
        for (const [units, events] of Air.played(frames ?? [])) {
            air.frame(units, events);
            if (++played % 200 === 0) postMessage({did: "replaying", seconds: air.units / UNITS_A_SECOND});
        }
        const tile = air.wind.gustTile();
        const [first, transfer] = view({units: 1, sampling});
        if (frames) Object.assign(first, {hash: air.hash(), units: air.units});
        return [{...first, tile, cells: air.wind.box().cells, box: air.wind.box(), blade: grass.block, made: air.makes},
            [...transfer, ...(tile ? [tile.buffer] : [])]];
    },
    async rest() {
        await parts.fetchRest();
        return [{}];
    },
    frame({units, events, begins, sampling, want}) {
        if (begins) air.snapshot();
        const begun = performance.now();
        const faults = air.frame(units, events);
        const ms = performance.now() - begun;
        const [answer, transfer] = view({units: Math.max(units, 1), sampling, want});
        return [{...answer, faults, ms, units, steps: air.snapshots.length}, transfer];
    },
    undo({sampling}) {
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
        const [answer, transfer = []] = await calls[call](values);
        postMessage({did: call, number, ...answer}, transfer);
    } catch (fault) {
        postMessage({did: "fault", call, number, text: fault.message ?? String(fault)});
    }
};
