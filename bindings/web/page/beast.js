// The beast's skin: a net on the surface of its capsules, melted together (vegetation/fur/flesh.h, surface_nets.cpp), whose table is the
// renderer's own.
import {dot, scaled, unit} from "./gl.js";

function flesh([px, py, pz]) {
    let whole = 1e9;
    for (const [ax, ay, az, bx, by, bz, ra, rb, melt] of BEAST_FLESH) {
        const [x, y, z, u, v, w] = [bx - ax, by - ay, bz - az, px - ax, py - ay, pz - az];
        const t = Math.min(Math.max((u * x + v * y + w * z) / (x * x + y * y + z * z), 0), 1);
        const one = Math.sqrt((u - t * x) ** 2 + (v - t * y) ** 2 + (w - t * z) ** 2) - ra - t * (rb - ra);
        const h = Math.max(1 - Math.abs(whole - one) / melt, 0);
        whole = Math.min(whole, one) - 0.25 * h * h * melt;
    }
    return whole;
}
const slope = (p) => [0, 1, 2].map((axis) => {
    const [more, less] = [1e-4, -1e-4].map((step) => flesh(p.map((x, n) => (n === axis ? x + step : x))));
    return (more - less) / 2e-4;
});
/** Places [m], unit normals, indices; `height` at the withers, `detail` cells along it. It stands on y = 0 and looks along +z. */
export function beastMesh({height = 2, detail = 23}) {
    const cell = 1 / detail, side = Math.ceil(0.35 / cell) * cell;
    const low = [-side, -0.06, -1], cells = [side, 1.4, 1.1].map((x, n) => Math.ceil((x - low[n]) / cell));
    const [nx, ny] = cells.map((n) => n + 1), distances = new Float32Array(nx * ny * (cells[2] + 1)), numbers = new Int32Array(distances.length).fill(-1);
    const index = ([i, j, k]) => (k * ny + j) * nx + i, corner = (at) => at.map((n, axis) => low[axis] + n * cell);
    const each = (most, body) => {
        for (let k = 0; k < most[2]; ++k) for (let j = 0; j < most[1]; ++j) for (let i = 0; i < most[0]; ++i) body([i, j, k]);
    };
    each(cells.map((n) => n + 1), (at) => (distances[index(at)] = flesh(corner(at))));
    const vertices = [], indices = [];
    each(cells, (at) => {
        let sum = [0, 0, 0], crossings = 0;
        for (let axis = 0; axis < 3; ++axis)
            for (let other = 0; other < 4; ++other) {
                const from = [...at];
                from[(axis + 1) % 3] += other & 1;
                from[(axis + 2) % 3] += other >> 1;
                const to = [...from];
                ++to[axis];
                const [d0, d1] = [distances[index(from)], distances[index(to)]];
                if (d0 < 0 === d1 < 0) continue;
                sum = sum.map((x, n) => x + corner(from)[n] + (n === axis ? (cell * d0) / (d0 - d1) : 0));
                ++crossings;
            }
        if (crossings === 0) return;
        let p = scaled(sum, 1 / crossings), normal = slope(p);
        const least = corner(at);
        for (let step = 0; step < 3; ++step) {
            const way = flesh(p) / dot(normal, normal);
            p = p.map((x, n) => Math.min(Math.max(x - normal[n] * way, least[n] + 0.05 * cell), least[n] + 0.95 * cell));
            normal = slope(p);
        }
        numbers[index(at)] = vertices.length;
        vertices.push([p, unit(normal)]);
    });
    each(cells, (at) => {
        for (let axis = 0; axis < 3; ++axis) {
            const to = [...at], u = (axis + 1) % 3, v = (axis + 2) % 3;
            ++to[axis];
            const inside = distances[index(at)] < 0;
            if (at[u] === 0 || at[v] === 0 || inside === distances[index(to)] < 0) continue;
            const [a, b, c, d] = [0, 1, 2, 3].map((k) => {
                const one = [...at];
                one[u] -= Number(k === 0 || k === 3);
                one[v] -= Number(k < 2);
                return numbers[index(one)];
            });
            indices.push(...(inside ? [a, b, c, a, c, d] : [d, c, b, d, b, a]));
        }
    });
    const floor = Math.min(...vertices.map(([[, y]]) => y));
    return {places: vertices.map(([[x, y, z]]) => [height * x, height * (y - floor), height * z]), normals: vertices.map(([, normal]) => normal), indices};
}
