// Windrow in JavaScript: the library as WebAssembly, behind its C interface.
//
//     import {load, Wind} from "windrow";
//     const library = await load();
//     const wind = new Wind(library, {ambient: [3, 0, 0], boundaries: {y_low: {kind: "free_slip"}}});
//     const fan = wind.add("jet", {position: [-6, 1, 0], direction: [1, 0, 0], law: {kind: "drive", speed: 10, rate: 8}});
//     wind.advance(1 / 60);
//     wind.velocity([0, 1, 0]);
//
// Structs are plain objects with the names of c_api; what is left out keeps its default. Vectors are arrays. A call that the library
// rejects throws an Error with its sentence. Lengths are metres, speeds metres a second, y is up.

const VECTORS = /^windrow_(d|i|u)?vec[234]$|^windrow_quat$/;
const SCALARS = {
    float: ["getFloat32", "setFloat32"], double: ["getFloat64", "setFloat64"], int32_t: ["getInt32", "setInt32"],
    uint32_t: ["getUint32", "setUint32"], uint16_t: ["getUint16", "setUint16"], uint8_t: ["getUint8", "setUint8"],
    pointer: ["getUint32", "setUint32"], size_t: ["getUint32", "setUint32"], int64_t: ["getBigInt64", "setBigInt64"],
    uint64_t: ["getBigUint64", "setBigUint64"],
};
// The choices that a word in a struct may name, by the end of their names in C.
const WORDS = {kind: ["BOUNDARY", "LAW", "REGION", "SHAPE"], scheme: ["SCHEME"], interpolation: ["INTERPOLATION"], surface: ["SURFACE"]};
const SCRATCH_BYTES = 1 << 16;

// A module of 43 bytes with one vector instruction: whether this machine compiles it.
const PROBE = new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11]);
export function hasSimd() {
    return WebAssembly.validate(PROBE);
}

/** The C interface: functions by name, structs in the module's memory. */
export class Library {
    constructor(module, description) {
        this.module = module;
        this.structs = description.structs;
        this.choices = description.choices;
        this.scratch = module._malloc(SCRATCH_BYTES);
        this.used = 0;
    }
    get memory() {
        return this.module.HEAPU8.buffer; // another one after it has grown
    }
    get data() {
        return new DataView(this.memory);
    }
    text(at) {
        return this.module.UTF8ToString(at);
    }
    get version() {
        return this.text(this.module._windrow_version_string());
    }

    /** A function of the module by its name in C. The page's module has those alone that convert no axes. */
    function(name) {
        return this.module["_" + name] ?? this.module["_own_" + name];
    }
    /** Calls a function of the C interface; arguments are numbers, strings and addresses. A rejection is thrown. */
    call(name, ...values) {
        const result = this.function(name)(...values.map((value) => (typeof value === "string" ? this.string(value) : value)));
        if (typeof result === "number" && result < 0) throw new Error(this.text(this.module._windrow_last_error()));
        return result;
    }
    /** Runs `body`, after which what it took from the scratch memory is free again. */
    within(body) {
        const before = this.used;
        try {
            return body();
        } finally {
            this.used = before;
        }
    }
    room(bytes) {
        const at = (this.scratch + this.used + 15) & ~15;
        this.used = at + bytes - this.scratch;
        if (this.used > SCRATCH_BYTES) throw new Error(`${bytes} bytes exceed the scratch memory`);
        this.module.HEAPU8.fill(0, at, at + bytes);
        return at;
    }
    string(value) {
        const bytes = this.module.lengthBytesUTF8(value) + 1;
        const at = this.room(bytes);
        this.module.stringToUTF8(value, at, bytes);
        return at;
    }
    /** A struct in the scratch memory: its defaults, then `values`. */
    make(name, values = {}) {
        const at = this.room(this.structs[name].size);
        this.reset(name, at);
        return this.write(name, at, values);
    }
    reset(name, at) {
        const init = this.function(`${name}_init`);
        if (init) init(at, this.structs[name].size);
    }
    write(name, at, values) {
        const {fields} = this.structs[name];
        const entries = Array.isArray(values) ? Object.keys(fields).map((field, n) => [field, values[n]]) : Object.entries(values);
        for (const [field, value] of entries) {
            if (!(field in fields)) throw new Error(`${name} has no field '${field}'`);
            const [type, offset, length] = fields[field];
            if (length) value.forEach((one, n) => this.writeOne(type, at + offset + n * this.sizeOf(type), one, field));
            else this.writeOne(type, at + offset, value, field);
        }
        return at;
    }
    writeOne(type, at, value, field) {
        if (type === "pointer" && value !== null && typeof value === "object") value = this.make(value.struct, value.values);
        if (!(type in SCALARS)) {
            this.write(type, at, value);
            return;
        }
        if (typeof value === "string") value = this.choice(field, value);
        this.data[SCALARS[type][1]](at, type.endsWith("64_t") ? BigInt(value) : Number(value), true);
    }
    choice(field, word) {
        for (const kind of WORDS[field] ?? [])
            if (`WINDROW_${kind}_${word.toUpperCase()}` in this.choices) return this.choices[`WINDROW_${kind}_${word.toUpperCase()}`];
        throw new Error(`${field} has no choice '${word}'`);
    }
    sizeOf(type) {
        return this.structs[type]?.size ?? {double: 8, int64_t: 8, uint64_t: 8, uint16_t: 2, uint8_t: 1}[type] ?? 4;
    }
    read(name, at) {
        const result = {};
        for (const [field, [type, offset, length]] of Object.entries(this.structs[name].fields))
            result[field] = length
                ? Array.from({length}, (_, n) => this.readOne(type, at + offset + n * this.sizeOf(type)))
                : this.readOne(type, at + offset);
        return VECTORS.test(name) ? Object.values(result) : result;
    }
    readOne(type, at) {
        return type in SCALARS ? this.data[SCALARS[type][0]](at, true) : this.read(type, at);
    }
    /** What a call wrote behind its last argument, a handle. */
    handle(name, ...values) {
        return this.within(() => {
            const at = this.room(4);
            this.call(name, ...values, at);
            return this.data.getUint32(at, true);
        });
    }
    /** What a call wrote into a struct of type `struct` behind its last argument. */
    result(struct, name, ...values) {
        return this.within(() => {
            const at = this.room(this.structs[struct].size);
            this.reset(struct, at);
            this.call(name, ...values, at);
            return this.read(struct, at);
        });
    }
    /** Bytes that the library made, as an array of this side's own. */
    bytes(name, ...values) {
        const at = this.handle(name, ...values);
        const first = this.module._windrow_bytes_data(at);
        const copy = this.module.HEAPU8.slice(first, first + Number(this.module._windrow_bytes_size(at)));
        this.module._windrow_bytes_destroy(at);
        return copy;
    }
    /** Runs `body` with the address of a copy of `bytes`. */
    withBytes(bytes, body) {
        const at = this.module._malloc(Math.max(bytes.length, 1));
        this.module.HEAPU8.set(bytes, at);
        try {
            return body(at, BigInt(bytes.length));
        } finally {
            this.module._free(at);
        }
    }
}

// Fields of a config that C has behind pointers.
const POINTERS = {profile: "log_profile", gusts: "gusts", canopy: "canopy", roughness: "roughness", rows: "rows"};

/** A wind on its own; a scene's is made by `air`. */
export class Wind {
    /** `outer`: a larger wind around the box in place of the ambient one, of the same library; advance it first in each frame. */
    constructor(library, config = {}, {outer = null} = {}) {
        this.library = library;
        library.within(() => {
            const values = {};
            for (const [key, value] of Object.entries(config))
                values[key] = key in POINTERS && value ? {struct: `windrow_${POINTERS[key]}`, values: value} : value;
            const struct = library.make("windrow_config", values);
            this.at = outer ? library.handle("windrow_wind_create_inside", struct, outer.at)
                : library.handle("windrow_wind_create", struct);
        });
        this.cells = Number(library.call("windrow_wind_cell_count", this.at));
        this.texels = library.module._malloc(8 * this.cells);
    }
    destroy() {
        this.library.module._free(this.texels);
        if (this.block) this.library.module._free(this.block);
        this.library.call("windrow_wind_destroy", this.at);
    }
    /** A frame of dt [s]; ticks that ran, factor between the last two, time that was dropped. */
    advance(dt) {
        const {library} = this;
        return library.within(() => {
            const at = library.make("windrow_advance");
            library.call("windrow_wind_advance", this.at, dt, at, 0);
            return library.read("windrow_advance", at);
        });
    }
    step(dt) {
        const {library} = this;
        return library.within(() => {
            const at = library.make("windrow_diagnostics");
            library.call("windrow_wind_step", this.at, dt, at);
            return library.read("windrow_diagnostics", at);
        });
    }
    follow(point) {
        const {library} = this;
        library.within(() => library.call("windrow_wind_follow", this.at, library.make("windrow_dvec3", point)));
    }
    /** [m/s] at a point [m]. */
    velocity(point) {
        const {library} = this;
        return library.within(() =>
            library.result("windrow_vec3", "windrow_wind_velocity", this.at, library.make("windrow_dvec3", point)));
    }
    box() {
        return this.library.result("windrow_box", "windrow_wind_box", this.at);
    }
    /** A motor of kind directional, wake, jet, vortex, omni or pressure; its id. */
    add(kind, motor) {
        const {library} = this;
        return library.within(() => library.result("windrow_motor_id", `windrow_wind_add_${kind}`, this.at,
            library.make(`windrow_${kind}_motor`, motor)));
    }
    set(kind, id, motor) {
        const {library} = this;
        library.within(() => library.call(`windrow_wind_set_${kind}`, this.at, library.make("windrow_motor_id", id),
            library.make(`windrow_${kind}_motor`, motor)));
    }
    move(id, position) {
        const {library} = this;
        library.within(() => library.call("windrow_wind_move_motor", this.at, library.make("windrow_motor_id", id),
            library.make("windrow_dvec3", position)));
    }
    remove(id) {
        const {library} = this;
        library.within(() => library.call("windrow_wind_remove_motor", this.at, library.make("windrow_motor_id", id)));
    }
    /** The texture of this frame, x, y, z, 0 a cell as halves (Uint16Array of the module's memory, good until the next call). */
    halves() {
        this.library.call("windrow_wind_write_vectors", this.at, 0, 0, this.texels, BigInt(4 * this.cells));
        return new Uint16Array(this.library.memory, this.texels, 4 * this.cells);
    }
    /** windrow_frame_block of windrow_wind.glsl, relative to `anchor` [m]: 1072 bytes of a uniform buffer. */
    frameBlock(anchor = [0, 0, 0], sampling = {}) {
        const {library} = this;
        const key = JSON.stringify([anchor, sampling]);
        if (!this.block) this.block = library.module._malloc(2048); // the block, the anchor, the sampling
        const [at, place, struct] = [this.block, this.block + 1536, this.block + 1792];
        if (this.blockOf !== key) {
            library.write("windrow_dvec3", place, anchor);
            library.reset("windrow_sampling", struct);
            library.write("windrow_sampling", struct, sampling);
            this.blockOf = key;
        }
        library.call("windrow_wind_frame_block", this.at, place, struct, at);
        return library.module.HEAPU8.slice(at, at + library.structs.windrow_frame_block.size);
    }
    /** The pattern of gusts, 128 x 16 x 128 texels of four floats, or null where the wind has none. */
    gustTile() {
        const {library} = this;
        const ambient = library.handle("windrow_ambient_wind_of", this.at, 0);
        const tile = library.handle("windrow_ambient_wind_tile", ambient);
        let texels = null;
        if (tile !== 0)
            library.within(() => {
                const count = library.room(8);
                const first = library.call("windrow_gust_tile_texels", tile, count);
                texels = new Float32Array(library.memory, first, 4 * library.data.getUint32(count, true)).slice();
            });
        library.call("windrow_gust_tile_destroy", tile);
        library.call("windrow_ambient_wind_destroy", ambient);
        return texels;
    }
}

/** Makes a Library of a loader, what it takes of the module (`wasmBinary`), and the description of the C interface (interface.json). */
export async function instantiate(createWindrow, taken, description) {
    return new Library(await createWindrow(taken), description);
}
