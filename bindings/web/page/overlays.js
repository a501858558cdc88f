// What shows the air itself: slices, arrows, streaks, the box with its blend zone, and where the air rests.
import {add, scaled} from "./gl.js";

const ARROWS = [16, 16];
const STREAKS = 700, TAIL = 10;

/** Halves to numbers, of four a cell, blended in the box at a point: what the arrows and streaks follow. */
export class Field {
    constructor() {
        this.table = new Float32Array(65536);
        for (let h = 0; h < 65536; ++h) {
            const exponent = (h >> 10) & 31, fraction = h & 1023;
            const value = exponent === 0 ? fraction * 2 ** -24 : exponent === 31 ? 0 : (1 + fraction / 1024) * 2 ** (exponent - 15);
            this.table[h] = h & 0x8000 ? -value : value;
        }
    }
    set(halves, cells, box) {
        Object.assign(this, {halves, cells, box});
    }
    /** [m/s] at a point, 0 outside of the box. */
    at(point) {
        const {cells, box, halves, table} = this;
        const place = [0, 1, 2].map((n) => ((point[n] - box.origin[n]) / box.size[n]) * cells[n] - 0.5);
        if (place.some((x, n) => x < -0.5 || x > cells[n] - 0.5)) return null;
        const low = place.map((x, n) => Math.min(Math.max(Math.floor(x), 0), cells[n] - 2));
        const t = place.map((x, n) => Math.min(Math.max(x - low[n], 0), 1));
        const sum = [0, 0, 0];
        for (let corner = 0; corner < 8; ++corner) {
            const bits = [corner & 1, (corner >> 1) & 1, corner >> 2];
            const weight = bits.reduce((product, bit, n) => product * (bit ? t[n] : 1 - t[n]), 1);
            const index = 4 * ((low[0] + bits[0]) + cells[0] * ((low[1] + bits[1]) + cells[1] * (low[2] + bits[2])));
            for (let n = 0; n < 3; ++n) sum[n] += weight * table[halves[index + n]];
        }
        return sum;
    }
}

export class Overlays {
    constructor(device, meadow, field) {
        Object.assign(this, {device, meadow, field});
        const {gl} = device;
        this.array = gl.createVertexArray();
        gl.bindVertexArray(this.array);
        this.buffer = gl.createBuffer();
        gl.bindBuffer(gl.ARRAY_BUFFER, this.buffer);
        [[3, 0], [4, 12]].forEach(([size, offset], n) => {
            gl.enableVertexAttribArray(n);
            gl.vertexAttribPointer(n, size, gl.FLOAT, false, 28, offset);
        });
        gl.bindVertexArray(null);
        this.clear();
    }
    clear() {
        Object.assign(this, {slices: [], arrows: false, streaks: false, pressure: false, box: false, mark: null});
        this.places = null;
    }
    get shows() {
        return this.slices.length > 0 || this.arrows || this.streaks || this.box || this.mark !== null;
    }
    line(from, to, tint) {
        this.lines.push(...from, ...tint, ...to, ...tint);
    }
    makeArrows() {
        const {box} = this.field;
        for (let j = 0; j < ARROWS[1]; ++j)
            for (let i = 0; i < ARROWS[0]; ++i) {
                const [x, z] = [box.origin[0] + (box.size[0] * (i + 0.5)) / ARROWS[0], box.origin[2] + (box.size[2] * (j + 0.5)) / ARROWS[1]];
                const at = [x, this.meadow.groundHeight(x, z) + 1.1, z];
                const u = this.field.at(at);
                if (!u) continue;
                const tip = add(at, scaled(u, 0.18)), side = [-u[2] * 0.03, 0, u[0] * 0.03], back = add(at, scaled(u, 0.13));
                const tint = [1, 1, 1, 0.85];
                this.line(at, tip, tint);
                this.line(tip, add(back, side), tint);
                this.line(tip, add(back, scaled(side, -1)), tint);
            }
    }
    born() {
        const {box} = this.field;
        const at = [box.origin[0] + box.size[0] * Math.random(), 0, box.origin[2] + box.size[2] * Math.random()];
        at[1] = this.meadow.groundHeight(at[0], at[2]) + 0.3 + 2.2 * Math.random() ** 2;
        return {trail: [at], left: 20 + 80 * Math.random()};
    }
    makeStreaks(seconds) {
        this.places ??= Array.from({length: STREAKS}, () => this.born());
        this.places.forEach((one, n) => {
            const u = this.field.at(one.trail[0]);
            if (!u || --one.left < 0) {
                this.places[n] = this.born();
                return;
            }
            if (seconds > 0) one.trail.unshift(add(one.trail[0], scaled(u, seconds)));
            one.trail.length = Math.min(one.trail.length, TAIL);
            for (let k = 0; k + 1 < one.trail.length; ++k) this.line(one.trail[k], one.trail[k + 1], [1, 1, 1, 0.7 * (1 - k / TAIL)]);
        });
    }
    makeBox() {
        const {box} = this.field;
        const frame = (low, high, tint) => {
            const corner = (n) => [0, 1, 2].map((axis) => ((n >> axis) & 1 ? high[axis] : low[axis]));
            for (let n = 0; n < 8; ++n) for (const bit of [1, 2, 4]) if (!(n & bit)) this.line(corner(n), corner(n | bit), tint);
        };
        const high = add(box.origin, box.size), margin = 3 * box.cell_size; // two of blending, one more
        frame(box.origin, high, [1, 0.85, 0.2, 0.9]);
        frame([box.origin[0] + margin, box.origin[1], box.origin[2] + margin], [high[0] - margin, high[1] - margin, high[2] - margin], [1, 0.85, 0.2, 0.35]);
    }
    draw(shared, seconds) {
        const {device} = this, {gl} = device;
        gl.enable(gl.BLEND);
        gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
        gl.depthMask(false);
        if (this.slices.length) {
            const places = device.use("slice", shared);
            gl.bindVertexArray(this.meadow.bare);
            const {max = 1} = this;
            for (const [axis, along] of this.slices) {
                gl.uniform2f(places.across, axis, along);
                gl.uniform2f(places.scale, this.pressure ? 0.5 * max * max : max, Number(this.pressure && this.meadow.pressure !== null));
                gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
            }
        }
        this.lines = [];
        if (this.arrows) this.makeArrows();
        if (this.streaks) this.makeStreaks(seconds);
        if (this.box) this.makeBox();
        if (this.mark) {
            const ring = Array.from({length: 33}, (_, n) => {
                const [x, z] = [this.mark[0] + 0.7 * Math.cos((n * Math.PI) / 16), this.mark[2] + 0.7 * Math.sin((n * Math.PI) / 16)];
                return [x, this.meadow.groundHeight(x, z) + 0.6, z];
            });
            ring.slice(1).forEach((point, n) => this.line(ring[n], point, [1, 0.9, 0.5, 0.9]));
        }
        if (this.lines.length) {
            device.use("line", shared);
            gl.bindVertexArray(this.array);
            gl.bindBuffer(gl.ARRAY_BUFFER, this.buffer);
            gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(this.lines), gl.DYNAMIC_DRAW);
            gl.drawArrays(gl.LINES, 0, this.lines.length / 7);
        }
        gl.depthMask(true);
        gl.disable(gl.BLEND);
    }
}
