// The picture: fields of the wind as textures, blades by levels around the view, ground, sky, bodies and their shadows.
import {add, dot, inverse, length, lookAt, orthographic, perspective, product, scaled, sub, transform, unit} from "./gl.js";
import {Solids} from "./solids.js";

const REACH = 5.2;       // [m] half of the finest level's side
const SHADOW_TEXELS = 1024;
const WAVELENGTHS = [0.68, 0.55, 0.44]; // [um] of red, green, blue
// Blades along a level's side, rows of vertices near, most pixels a CSS pixel: from a slow machine's to a quick one's.
export const QUALITIES = [{cells: 80, rows: 3, pixels: 0.75}, {cells: 96, rows: 3, pixels: 1}, {cells: 128, rows: 7, pixels: 1.25},
    {cells: 160, rows: 7, pixels: 1.5}, {cells: 208, rows: 7, pixels: 2}];
const GRASS = {root: [0.022, 0.045, 0.01, 0.34], tip: [0.15, 0.225, 0.042, 0.3], dry: [0.28, 0.23, 0.11, 24], through: [0.125, 0.17, 0.03, 2.5],
    size: [0, 48, 0.75, 0.8], second: [0.09, 0.185, 0.048, 0.55], head: [0.24, 0.19, 0.1, 1], soil: [0.044, 0.046, 0.02, 0],
    shape: [0.006, 1.15, 0.2, 0.45], clumps: [1.6, 0.35, 0.5, 0.3], patches: [0.125, 0.35, 0, 0], width: 1};
const WHEAT = {...GRASS, root: [0.07, 0.053, 0.022, 0.24], tip: [0.28, 0.205, 0.08, 0.2], dry: [0.28, 0.205, 0.08, 16],
    through: [0.13, 0.09, 0.025, 2.5], second: [0.26, 0.19, 0.075, 0.55], head: [0.3, 0.22, 0.09, 0.8], shape: [0.0055, 1.3, 0.2, 0.35],
    clumps: [1.25, 0.12, 0.25, 0], patches: [0.083, 0.15, 0, 0]};
const LOOKS = {GRASS, WHEAT};
export const BLADES = {
    GRASS: {length: 0.55, length_spread: 0.3, width: 0.011, tip_width: 0.06, taper: 2.6, along_wind: 0.8, rest_bend: 0.7, rest_bend_spread: 0.45,
        view_bend: 0.35},
    WHEAT: {length: 0.8, length_spread: 0.12, width: 0.01, tip_width: 0.3, rest_bend: 0.2, rest_bend_spread: 0.15, rest_curve: 0.85},
};

export class Meadow {
    constructor(device) {
        this.device = device;
        const {gl} = device;
        const shader = (name, vertex = name, fragment = name) => device.program(name, `${vertex}.vert`, `${fragment}.frag`);
        ["blade", "ground", "solid", "tree", "line", "slice"].forEach((name) => shader(name));
        ["bend", "sky", "sky_map", "light", "patches"].forEach((name) => shader(name, "whole"));
        this.solids = new Solids(device);
        this.empty3d = device.texture3d(gl.RGBA8, [1, 1, 1], gl.NEAREST);
        this.heights = device.texture2d(gl.R32F, 2, 2);
        this.shadow = device.texture2d(gl.DEPTH_COMPONENT24, SHADOW_TEXELS, SHADOW_TEXELS, {filter: gl.LINEAR});
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_COMPARE_MODE, gl.COMPARE_REF_TO_TEXTURE);
        this.shadowTarget = device.target([], this.shadow);
        this.bare = gl.createVertexArray();
        this.land = this.makeLand();
        this.trees = this.makeTrees();
        this.block = new ArrayBuffer(512);
        this.numbers = new Float32Array(this.block);
        this.words = new Int32Array(this.block);
        this.fresh = false;
        this.quality = -1;
        this.samplers = {};
        this.tileLists = [0, 1, 2].map(() => {
            const buffer = gl.createBuffer(), array = gl.createVertexArray();
            gl.bindVertexArray(array);
            gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
            gl.enableVertexAttribArray(0);
            gl.vertexAttribPointer(0, 2, gl.UNSIGNED_BYTE, false, 2, 0);
            gl.vertexAttribDivisor(0, 256);
            return {buffer, array};
        });
        gl.bindVertexArray(null);
    }
    // Rings of triangles that grow outward: fine where blades end, coarse at the horizon.
    makeLand() {
        const at = [0, 0], indices = [];
        const around = 96;
        const radii = Array.from({length: 64}, (_, n) => 0.5 * (n + 1) * Math.pow(1.085, n));
        radii.forEach((r, n) => {
            for (let k = 0; k < around; ++k) {
                const turn = (2 * Math.PI * (k + 0.5 * (n % 2))) / around;
                at.push(r * Math.cos(turn), r * Math.sin(turn));
                const next = (k + 1) % around, row = 1 + n * around, below = row - around;
                if (n === 0) indices.push(0, row + next, row + k);
                else if (n % 2) indices.push(below + k, below + next, row + k, row + k, below + next, row + next);
                else indices.push(below + k, row + next, row + k, below + k, below + next, row + next);
            }
        });
        return this.device.mesh([[new Float32Array(at), 2]], new Uint16Array(indices));
    }

    // Groves between 95 and 355 m: the same in every visit.
    makeTrees() {
        const {gl} = this.device;
        let state = 7;
        const chance = () => ((state = (Math.imul(state, 1664525) + 1013904223) >>> 0) / 2 ** 32);
        const rows = [];
        for (let grove = 0; grove < 34; ++grove) {
            const turn = 2 * Math.PI * chance(), off = 95 + 260 * chance() ** 0.8, spread = 14 + 24 * chance();
            for (let n = 2 + Math.floor(5 * chance()); n > 0; --n)
                rows.push(off * Math.cos(turn) + spread * (chance() - 0.5), off * Math.sin(turn) + spread * (chance() - 0.5), 7 + 7 * chance(), chance());
        }
        const mesh = this.device.mesh([[new Float32Array(rows), 4]]);
        gl.bindVertexArray(mesh.array);
        gl.vertexAttribDivisor(0, 1);
        gl.bindVertexArray(null);
        return mesh;
    }

    // --- a scene -----------------------------------------------------------------------------------------------------
    setScene(loaded, shown, terrain, picture) {
        const {device} = this, {gl} = device;
        this.shown = shown;
        this.plant = shown.plant ?? "GRASS";
        this.look = {...LOOKS[this.plant], ...shown.look};
        this.cells = loaded.cells;
        for (const texture of [this.now, this.before, this.tile, this.pressure]) if (texture && texture !== this.empty3d) gl.deleteTexture(texture);
        [this.now, this.before] = [0, 1].map(() => device.texture3d(gl.RGBA16F, loaded.cells, gl.LINEAR));
        this.pressure = null;
        this.tile = this.empty3d;
        if (loaded.tile) {
            this.tile = device.texture3d(gl.RGBA32F, [128, 16, 128], gl.NEAREST);
            gl.texSubImage3D(gl.TEXTURE_3D, 0, 0, 0, 0, 128, 16, 128, gl.RGBA, gl.FLOAT, loaded.tile);
        }
        this.box = loaded.box;
        this.terrain = terrain;
        gl.deleteTexture(this.heights);
        this.heights = terrain
            ? device.texture2d(gl.R32F, ...terrain.corners, {data: terrain.heights, kind: gl.RED, type: gl.FLOAT})
            : device.texture2d(gl.R32F, 2, 2);
        this.blade = new Float32Array(loaded.blade.buffer.slice(0));
        this.numbers.set(terrain ? [...terrain.corner, ...terrain.extent] : [0, 0, 0, 0], 76);
        this.numbers.set([...(terrain ? terrain.corners : [2, 2]), this.box.origin[1], 0], 80);
        this.ground = null;
        this.goesOn = false;
        this.scenery?.setScene(loaded.scenery ? picture : {}, loaded.scenery ?? {trees: [], coats: []}, (x, z) => this.groundHeight(x, z));
        this.setLight(shown);
        this.setFrame(loaded);
        this.setFrame(loaded);
    }
    setLight(shown) {
        const {device} = this, {gl} = device;
        const {elevation = 34, azimuth = 318, haze = 0.06, exposure = 1.0, fog = 0.0012, cover = [0.42, 3]} = shown.sky ?? {};
        const [up, around] = [elevation, azimuth].map((deg) => (deg * Math.PI) / 180);
        const sun = [Math.cos(up) * Math.cos(around), Math.sin(up), Math.cos(up) * Math.sin(around), 0.00465];
        const found = device.texture2d(gl.RGBA32F, 6, 1);
        const target = device.target([device.floats ? found : (gl.deleteTexture(found), device.texture2d(gl.RGBA16F, 6, 1))]);
        const light = device.use("light");
        gl.uniform4fv(light.sun, sun);
        gl.uniform3f(light.given, 10, haze, 0.76);
        gl.uniform3fv(light.wavelengths, WAVELENGTHS);
        gl.viewport(0, 0, 6, 1);
        gl.disable(gl.DEPTH_TEST);
        gl.bindVertexArray(this.bare);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        const texels = new Float32Array(24);
        gl.readPixels(0, 0, 6, 1, gl.RGBA, gl.FLOAT, texels);
        gl.deleteFramebuffer(target);
        const [beam, sky] = [texels.slice(8, 11), texels.slice(12, 15)];
        const below = [0.06, 0.09, 0.03].map((albedo, n) => albedo * (beam[n] * sun[1] + sky[n]));
        this.sun = sun.slice(0, 3);
        this.numbers.set([0, 0, 0, exposure, ...beam, fog, ...sky, 0.012, ...below, 1, ...sun, ...texels.slice(0, 8)], 48);
        this.numbers.set([this.box.origin[0] + this.box.size[0] / 2, this.box.origin[2] + this.box.size[2] / 2, 34, this.terrain ? 0 : 15], 116);
        this.numbers.set(texels.subarray(16, 24), 120);
        this.upload();
        if (!this.patches) this.makePatches();
        if (!this.skyMap) this.skyMap = device.texture2d(gl.RGBA16F, 1024, 512, {filter: gl.LINEAR, wrap: gl.REPEAT});
        const map = device.target([this.skyMap]);
        const places = device.use("sky_map");
        gl.uniform2fv(places.cover, cover);
        gl.viewport(0, 0, 1024, 512);
        gl.enable(gl.SCISSOR_TEST);
        gl.scissor(0, 256, 1024, 256);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        gl.disable(gl.SCISSOR_TEST);
        gl.deleteFramebuffer(map);
    }
    makePatches() {
        const {device} = this, {gl} = device;
        this.patches = gl.createTexture();
        gl.bindTexture(gl.TEXTURE_2D, this.patches);
        gl.texStorage2D(gl.TEXTURE_2D, 10, gl.RGBA8, 512, 512);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
        for (const key of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, key, gl.MIRRORED_REPEAT);
        const target = device.target([this.patches]);
        device.use("patches");
        gl.viewport(0, 0, 512, 512);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        gl.deleteFramebuffer(target);
        gl.bindTexture(gl.TEXTURE_2D, this.patches);
        gl.generateMipmap(gl.TEXTURE_2D);
    }
    upload() {
        this.device.block("Page", this.block);
    }
    setQuality(quality) {
        if (quality === this.quality) return;
        this.quality = quality;
        const {device} = this, {gl} = device;
        const n = QUALITIES[quality].cells;
        this.n = n;
        for (const state of this.states ?? []) {
            state.textures.forEach((texture) => gl.deleteTexture(texture));
            gl.deleteFramebuffer(state.target);
        }
        const formats = device.floats ? [gl.RGBA32F, gl.RGBA16F] : [gl.RGBA16F, gl.RGBA16F];
        const shown = device.texture2d(formats[0], n, 3 * n);
        this.states = [0, 1].map(() => {
            const textures = formats.map((format) => device.texture2d(format, n, 3 * n));
            return {textures: [...textures], target: device.target([...textures, shown]), shown};
        });
        this.goesOn = false;
        this.fresh = true;
    }
    get blades() {
        return 3 * this.n * this.n - 2 * Math.round((this.n * this.n) / 4); // the coarser levels are open inside
    }

    // --- a frame of the wind ---------------------------------------------------------------------------------------------
    setFrame(answer) {
        const {device} = this, {gl} = device;
        const begun = performance.now();
        [this.now, this.before] = [this.before, this.now];
        gl.bindTexture(gl.TEXTURE_3D, this.now);
        gl.texSubImage3D(gl.TEXTURE_3D, 0, 0, 0, 0, ...this.cells, gl.RGBA, gl.HALF_FLOAT, answer.halves);
        device.block("WindrowBlock", answer.block);
        const {look} = this;
        this.plants ??= new Float32Array(16 + 80 + 36 + 8);
        const plants = this.plants;
        plants.set(this.blade, 0);
        plants.set(new Float32Array(answer.swing.buffer, answer.swing.byteOffset, 80), 16);
        plants.set(["root", "tip", "dry", "through", "size", "second", "head", "soil", "shape", "clumps", "patches"].flatMap((key) => look[key]), 96);
        device.block("Plants", plants);
        this.motion = answer.motion;
        if (answer.ground) {
            if (!this.ground) {
                const side = Math.sqrt(answer.ground.texels.length / 4);
                this.ground = device.texture3d(gl.RGBA32F, [side, side, 1], gl.NEAREST);
                this.groundSide = side;
            }
            gl.bindTexture(gl.TEXTURE_3D, this.ground);
            gl.texSubImage3D(gl.TEXTURE_3D, 0, 0, 0, 0, this.groundSide, this.groundSide, 1, gl.RGBA, gl.FLOAT, answer.ground.texels);
            device.block("Ground", answer.ground.place);
        } else if (!device.blocks.Ground) device.block("Ground", new Uint8Array(48));
        if (answer.pressure) {
            this.pressure ??= device.texture3d(gl.R32F, this.cells, gl.NEAREST);
            gl.bindTexture(gl.TEXTURE_3D, this.pressure);
            gl.texSubImage3D(gl.TEXTURE_3D, 0, 0, 0, 0, ...this.cells, gl.RED, gl.FLOAT, answer.pressure);
        }
        this.fresh = true;
        this.uploadMs = performance.now() - begun;
    }
    groundHeight(x, z) {
        const {terrain} = this;
        if (!terrain) return this.box.origin[1];
        const [nx, nz] = terrain.corners;
        const u = Math.min(Math.max(((x - terrain.corner[0]) / terrain.extent[0]) * (nx - 1), 0), nx - 1.001);
        const v = Math.min(Math.max(((z - terrain.corner[1]) / terrain.extent[1]) * (nz - 1), 0), nz - 1.001);
        const [i, j] = [Math.floor(u), Math.floor(v)], [s, t] = [u - i, v - j];
        const h = (a, b) => terrain.heights[(j + b) * nx + i + a];
        return this.box.origin[1] + (1 - t) * ((1 - s) * h(0, 0) + s * h(1, 0)) + t * ((1 - s) * h(0, 1) + s * h(1, 1));
    }

    // --- drawing ---------------------------------------------------------------------------------------------------------
    /** `camera`: eye, target, view [rad]; `list` of bodies for Solids.draw; `over` draws the overlays. */
    draw(camera, width, height, list, over) {
        const {device, numbers, words} = this, {gl} = device;
        const view = lookAt(camera.eye, camera.target);
        this.toClip = product(perspective(camera.view, width / height, 0.08, 900), view);
        const forward = unit(sub(camera.target, camera.eye));
        const level = unit([forward[0], 0, forward[2]]);
        const ahead = Math.min(0.62 * REACH, length(sub(camera.target, camera.eye)));
        const middle = add(camera.eye, scaled(level, ahead));
        const spacing = (2 * REACH) / this.n;
        const grown = Math.pow(spacing / 0.05, 1.2) * this.look.width; // fewer blades cover as much
        numbers.set(this.toClip, 0);
        numbers.set(inverse(this.toClip), 16);
        numbers.set(camera.eye, 48);
        for (let k = 0; k < 3; ++k) {
            const s = spacing * 2 ** k, side = REACH * 2 ** k;
            numbers.set([s, side - s - 1.3 * 2 ** k, side - s, grown * [1, 1.8, 3.1][k]], 84 + 4 * k);
            const lowest = [middle[0], middle[2]].map((x) => Math.floor(x / s) - this.n / 2);
            if (this.fresh) words.copyWithin(96 + 4 * k + 2, 96 + 4 * k, 96 + 4 * k + 2);
            words.set(lowest, 96 + 4 * k);
            this.lowest ??= [];
            this.lowest[k] = lowest;
        }
        words.set([this.n, QUALITIES[this.quality].rows, Number(this.goesOn), 7], 108);
        numbers.set([middle[0], middle[2], (0.55 * Math.tan(camera.view / 2) * 2) / height, performance.now() / 1000], 112);
        numbers[83] = this.ground ? 1 : 0;
        const scenery = this.scenery?.shows ? this.scenery : null;
        const shades = list.length > 0 || scenery !== null;
        numbers[63] = shades ? 1 : 0; // without bodies no shadow is drawn or looked up
        const around = camera.target;
        const shadowView = lookAt(add(around, scaled(this.sun, 60)), around);
        const toShadow = product(orthographic(44, 44, 1, 140), shadowView);
        numbers.set(toShadow, 32);
        this.upload();

        const shared = {windrow_vectors: this.now, windrow_vectors_before: this.before, windrow_tile_texels: this.tile,
            height_texels: this.heights, shadow_map: this.shadow, sky_map: this.skyMap, patches_map: this.patches, pressure: this.pressure ?? this.empty3d};
        if (scenery && this.fresh) {
            gl.bindVertexArray(this.bare);
            scenery.bend({...shared, shadow_map: null}, this.motion, this.quality);
        }
        gl.enable(gl.DEPTH_TEST);
        if (shades) {
            gl.bindFramebuffer(gl.FRAMEBUFFER, this.shadowTarget);
            gl.viewport(0, 0, SHADOW_TEXELS, SHADOW_TEXELS);
            gl.clear(gl.DEPTH_BUFFER_BIT);
            gl.colorMask(false, false, false, false);
            this.solids.draw(list, "solid", device.use("solid", {sky_map: this.skyMap, height_texels: this.heights}), toShadow);
            scenery?.draw({...shared, shadow_map: null}, toShadow, this.quality, true);
            gl.colorMask(true, true, true, true);
        }

        if (this.fresh) this.bend(shared);
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        gl.viewport(0, 0, width, height);
        gl.clear(gl.DEPTH_BUFFER_BIT);
        this.solids.draw(list, "solid", device.use("solid", shared), this.toClip);
        scenery?.draw(shared, this.toClip, this.quality, false);
        this.drawBlades(shared);
        device.use("ground", shared);
        gl.bindVertexArray(this.land.array);
        gl.drawElements(gl.TRIANGLES, this.land.count, gl.UNSIGNED_SHORT, 0);
        if (!this.terrain) {
            device.use("tree", shared);
            gl.bindVertexArray(this.trees.array);
            gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, this.trees.count);
        }
        device.use("sky", shared);
        gl.depthFunc(gl.LEQUAL);
        gl.bindVertexArray(this.bare);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        gl.depthFunc(gl.LESS);
        if (over) over(shared);
        gl.bindVertexArray(null);
    }
    bend(shared) {
        const {device} = this, {gl} = device;
        const [from, to] = this.states;
        device.use("bend", {...shared, swing_before: from.textures[0], ripple_before: from.textures[1], ground_memory: this.ground ?? this.empty3d});
        gl.bindFramebuffer(gl.FRAMEBUFFER, to.target);
        gl.viewport(0, 0, this.n, 3 * this.n);
        gl.disable(gl.DEPTH_TEST);
        gl.bindVertexArray(this.bare);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        gl.enable(gl.DEPTH_TEST);
        this.states = [to, from];
        this.fresh = false;
        this.goesOn = true;
    }
    // Tiles of 16 x 16 blades that the view may show: one call a level.
    drawBlades(shared) {
        const {device, n} = this, {gl} = device;
        const places = device.use("blade", {...shared, shown: this.states[0].shown});
        const tiles = n / 16;
        this.list ??= new Uint8Array(2 * 16 * 16);
        const m = this.toClip;
        this.wide = [Math.hypot(m[0], m[4], m[8]) + 1, Math.hypot(m[1], m[5], m[9]) + 1];
        for (let k = 2; k >= 0; --k) {
            let count = 0;
            for (let j = 0; j < tiles; ++j)
                for (let i = 0; i < tiles; ++i)
                    if (this.tileShows(k, i, j)) {
                        this.list[2 * count] = i;
                        this.list[2 * count++ + 1] = j;
                    }
            const {buffer, array} = this.tileLists[k];
            gl.bindVertexArray(array);
            gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
            gl.bufferData(gl.ARRAY_BUFFER, this.list, gl.DYNAMIC_DRAW, 0, 2 * count);
            gl.uniform1i(places.level_drawn, k);
            gl.uniform1i(places.few_rows, Number(k > 0 && this.quality < 2));
            const rows = k === 0 ? QUALITIES[this.quality].rows : this.quality < 2 ? 2 : 3;
            gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 2 * rows + 1, 256 * count);
        }
    }
    // A tile's cells wrap around the level's square, so that it has up to two parts along each axis.
    tileShows(k, i, j) {
        const {n} = this;
        const [low, up] = this.lowest[k];
        const first = low + ((((16 * i - low) % n) + n) % n), second = up + ((((16 * j - up) % n) + n) % n);
        for (let x = 0; x < 2; ++x) {
            const x0 = x === 0 ? first : low, x1 = x === 0 ? Math.min(first + 16, low + n) : first + 16 - n;
            for (let z = 0; z < 2; ++z) {
                const z0 = z === 0 ? second : up, z1 = z === 0 ? Math.min(second + 16, up + n) : second + 16 - n;
                if (x1 > x0 && z1 > z0 && this.partShows(k, x0, x1, z0, z1)) return true;
            }
        }
        return false;
    }
    partShows(k, x0, x1, z0, z1) {
        const s = ((2 * REACH) / this.n) * 2 ** k, m = this.toClip;
        const mx = this.numbers[112], mz = this.numbers[113];
        const cx = 0.5 * s * (x0 + x1), cz = 0.5 * s * (z0 + z1), half = 0.5 * s * Math.max(x1 - x0, z1 - z0);
        const inner = k > 0 ? 0.7 * (REACH * 2 ** (k - 1) - 1.3 * 2 ** k) : 0; // where this level begins
        if (Math.max(Math.abs(cx - mx), Math.abs(cz - mz)) + half < inner) return false;
        const tall = 1.4 * this.blade[0], y = this.groundHeight(cx, cz) + 0.5 * tall;
        const radius = 1.5 * half + tall + (this.terrain ? 2 : 0);
        const w = m[3] * cx + m[7] * y + m[11] * cz + m[15];
        return w > -radius && Math.abs(m[0] * cx + m[4] * y + m[8] * cz + m[12]) < w + radius * this.wide[0] &&
            Math.abs(m[1] * cx + m[5] * y + m[9] * cz + m[13]) < w + radius * this.wide[1];
    }
    /** The point of the ground under a pixel, or null for the sky; and the ray. */
    pick(x, y) {
        const back = inverse(this.toClip);
        const [a, b] = [-1, 1].map((z) => {
            const [px, py, pz, w] = transform(back, [x, y, z]);
            return [px / w, py / w, pz / w];
        });
        const ray = unit(sub(b, a));
        let [near, far] = [0, 0];
        for (let t = 0.2; t < 120; t *= 1.04) {
            const p = add(a, scaled(ray, t));
            if (p[1] < this.groundHeight(p[0], p[2])) {
                far = t;
                break;
            }
            near = t;
        }
        if (far === 0) return {ray, from: a, at: null};
        for (let n = 0; n < 24; ++n) {
            const t = 0.5 * (near + far), p = add(a, scaled(ray, t));
            if (p[1] < this.groundHeight(p[0], p[2])) far = t;
            else near = t;
        }
        return {ray, from: a, at: add(a, scaled(ray, far))};
    }
}
/** Distance of a point from a ray [m]. */
export function offRay({from, ray}, point) {
    const along = dot(sub(point, from), ray);
    return length(sub(sub(point, from), scaled(ray, along)));
}
