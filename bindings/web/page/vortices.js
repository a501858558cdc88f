// Speed beside error: the vortices of README, classic step and second order side by side, in the worker.
//
// Taylor-Green vortices that a mean wind carries through a periodic box of 2 pi x 2 pi x pi, at CFL 1, to t = pi:
//   u = M + e^(-2 nu t) (sin a cos b, -cos a sin b, 0),  a = x - M_x t,  b = y - M_y t,  nu = 0.01
// The error is the root mean square of the difference, relative to that of the vortices: as tests/bench/accuracy_bench.cpp has it.
import {Wind} from "../package/windrow.js";

const MEAN = [1, 0.5, 0];
const VISCOSITY = 0.01;
export const SCHEMES = [
    {name: "stable fluids, linear", scheme: "stable_fluids", interpolation: "linear"},
    {name: "second order", scheme: "second_order", interpolation: "cubic"},
];

function vortex(x, y, t) {
    const [a, b, fade] = [x - MEAN[0] * t, y - MEAN[1] * t, Math.exp(-2 * VISCOSITY * t)];
    return [MEAN[0] + fade * Math.sin(a) * Math.cos(b), MEAN[1] - fade * Math.cos(a) * Math.sin(b)];
}

class Run {
    constructor(library, cells, scheme) {
        this.library = library;
        this.n = [cells, cells, cells / 2];
        this.h = (2 * Math.PI) / cells;
        this.steps = Math.round(Math.PI / (0.5 * this.h));
        this.done = 0;
        this.least = Infinity;
        this.total = 0;
        const face = {kind: "periodic"};
        const boundaries = {x_low: face, x_high: face, y_low: face, y_high: face, z_low: face, z_high: face};
        this.wind = new Wind(library, {cells: this.n, cell_size: this.h, boundaries, ambient: MEAN, viscosity: VISCOSITY,
            relaxation_time: 0, sleep_speed: 0, scheme: scheme.scheme, interpolation: scheme.interpolation});
        const origin = this.wind.box().origin;
        this.centres = [0, 1].map((axis) => Float64Array.from({length: cells}, (_, i) => origin[axis] + (i + 0.5) * this.h));
        const count = this.wind.cells;
        const at = library.module._malloc(16 * count);
        const field = new Float32Array(library.memory, at, 4 * count);
        field.fill(0); // along z the air rests; memory that was used before holds anything
        this.each((index, x, y) => field.set(vortex(x, y, 0), 4 * index));
        library.call("windrow_wind_set_field", this.wind.at, at, BigInt(count));
        library.module._free(at);
    }
    each(body) {
        const [nx, ny, nz] = this.n;
        for (let z = 0, index = 0; z < nz; ++z)
            for (let y = 0; y < ny; ++y) for (let x = 0; x < nx; ++x) body(index++, this.centres[0][x], this.centres[1][y]);
    }
    step() {
        const begun = performance.now();
        this.wind.step(Math.PI / this.steps);
        const took = performance.now() - begun;
        this.least = Math.min(this.least, took);
        this.total += took;
        ++this.done;
    }
    /** Relative error at the time that it has reached. */
    error() {
        const {library} = this;
        const time = (Math.PI * this.done) / this.steps;
        return library.within(() => {
            const at = library.room(8), count = library.room(8);
            library.call("windrow_wind_field", this.wind.at, 0, at, count, 0);
            const field = new Float32Array(library.memory, library.data.getUint32(at, true), 4 * this.wind.cells);
            let wrong = 0, all = 0;
            this.each((index, x, y) => {
                const [u, v] = vortex(x, y, time);
                wrong += (field[4 * index] - u) ** 2 + (field[4 * index + 1] - v) ** 2 + field[4 * index + 2] ** 2;
                all += (u - MEAN[0]) ** 2 + (v - MEAN[1]) ** 2;
            });
            return Math.sqrt(wrong / all);
        });
    }
}

/** Runs both schemes to t = pi in turns of a step, and reports each: report({name, time, error, ms, cells}). */
export async function runVortices(library, cells, report) {
    const runs = SCHEMES.map((scheme) => new Run(library, cells, scheme));
    while (runs.some((run) => run.done < run.steps)) {
        for (const [n, run] of runs.entries()) {
            run.step();
            report({scheme: n, name: SCHEMES[n].name, time: (Math.PI * run.done) / run.steps, error: run.error(), ms: run.least, cells});
        }
        await new Promise((resolve) => setTimeout(resolve, 0)); // the meadow goes on
    }
    for (const run of runs) run.wind.destroy();
}
