// Bodies as meshes: blocks, balls, cylinders, what a scene's files hold; the fan and the walker of the page.
import {placed, product} from "./gl.js";

// A surface of revolution about y from a profile of [radius, height]; normals are smooth along it unless `edges`.
function lathe(profile, around = 20, edges = false) {
    const at = [], normals = [], indices = [];
    const rows = edges ? profile.flatMap((point, n) => (n > 0 && n + 1 < profile.length ? [point, point] : [point])) : profile;
    rows.forEach(([r, y], n) => {
        const pair = edges ? [rows[n - (n % 2)], rows[n - (n % 2) + 1]] : [rows[Math.max(n - 1, 0)], rows[Math.min(n + 1, rows.length - 1)]];
        const slope = [pair[1][1] - pair[0][1], pair[0][0] - pair[1][0]];
        const size = Math.hypot(...slope) || 1;
        for (let k = 0; k <= around; ++k) {
            const turn = (2 * Math.PI * k) / around, [c, s] = [Math.cos(turn), Math.sin(turn)];
            at.push(r * c, y, r * s);
            normals.push((slope[0] / size) * c, slope[1] / size, (slope[0] / size) * s);
        }
    });
    for (let n = 0; n + 1 < rows.length; n += edges ? 2 : 1)
        for (let k = 0; k < around; ++k) {
            const a = n * (around + 1) + k, b = a + around + 1;
            indices.push(a, b, a + 1, a + 1, b, b + 1);
        }
    return [at, normals, indices];
}
function block() {
    const at = [], normals = [], indices = [];
    for (let axis = 0; axis < 3; ++axis)
        for (const sign of [-1, 1]) {
            const first = at.length / 3;
            for (const [u, v] of [[-1, -1], [1, -1], [1, 1], [-1, 1]]) {
                const point = [0, 0, 0];
                point[axis] = sign;
                point[(axis + 1) % 3] = u;
                point[(axis + 2) % 3] = v;
                at.push(...point);
                normals.push(...[0, 1, 2].map((n) => (n === axis ? sign : 0)));
            }
            indices.push(first, first + 1, first + 2, first, first + 2, first + 3);
        }
    return [at, normals, indices];
}
function ball() {
    return lathe(Array.from({length: 13}, (_, n) => [Math.sin((Math.PI * n) / 12), Math.cos((Math.PI * n) / 12)]), 24);
}
function ring() { // about y, of radius 1
    const at = [], normals = [], indices = [];
    const [around, across] = [40, 8];
    for (let n = 0; n <= around; ++n)
        for (let k = 0; k <= across; ++k) {
            const [a, b] = [(2 * Math.PI * n) / around, (2 * Math.PI * k) / across];
            const out = [Math.cos(a) * Math.cos(b), Math.sin(b), Math.sin(a) * Math.cos(b)];
            at.push(Math.cos(a) + 0.045 * out[0], 0.045 * out[1], Math.sin(a) + 0.045 * out[2]);
            normals.push(...out);
            if (n < around && k < across) {
                const c = n * (across + 1) + k, d = c + across + 1;
                indices.push(c, d, c + 1, c + 1, d, d + 1);
            }
        }
    return [at, normals, indices];
}
/** Triangles of an OBJ file: places and normals by face. */
export function readObj(text) {
    const vertices = [], at = [], normals = [];
    for (const line of text.split("\n")) {
        const words = line.trim().split(/\s+/);
        if (words[0] === "v") vertices.push(words.slice(1, 4).map(Number));
        if (words[0] !== "f") continue;
        const corners = words.slice(1).map((word) => parseInt(word, 10)).map((n) => vertices[n < 0 ? vertices.length + n : n - 1]);
        for (let n = 1; n + 1 < corners.length; ++n) {
            const [a, b, c] = [corners[0], corners[n], corners[n + 1]];
            const [u, v] = [b.map((x, k) => x - a[k]), c.map((x, k) => x - a[k])];
            const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
            for (const corner of [a, b, c]) {
                at.push(...corner);
                normals.push(...normal);
            }
        }
    }
    return [at, normals, at.map((_, n) => n).slice(0, at.length / 3)];
}

const TINTS = {wall: [0.52, 0.46, 0.38, 0.25], roof: [0.3, 0.1, 0.06, 0.5], stone: [0.3, 0.29, 0.27, 0.7], metal: [0.2, 0.23, 0.26, 0],
    cape: [0.42, 0.012, 0.012, 0], skin: [0.5, 0.28, 0.2, 0], hat: [0.1, 0.045, 0.02, 0.2], marked: [0.75, 0.5, 0.08, 0]};

export class Solids {
    constructor(device) {
        this.device = device;
        const make = ([at, normals, indices]) =>
            device.mesh([[new Float32Array(at), 3], [new Float32Array(normals), 3]], new Uint16Array(indices));
        this.make = make;
        this.meshes = {block: make(block()), sphere: make(ball()), ring: make(ring()),
            cylinder: make(lathe([[0, -1], [1, -1], [1, 1], [0, 1]], 24, true)),
            cape: make(lathe([[0.02, 1.52], [0.12, 1.46], [0.2, 1.3], [0.24, 1.0], [0.3, 0.7], [0.36, 0.42]], 20)),
            hat: make(lathe([[0, 1.86], [0.1, 1.86], [0.12, 1.75], [0.26, 1.74], [0.26, 1.72], [0, 1.72]], 20, true))};
        this.files = {};
    }
    /** [mesh, model, tint] of a body of a scene. */
    ofBody({name = "", position = [0, 0, 0], turn_deg: turn = [0, 0, 0], shape}) {
        const [kind, value] = Object.entries(shape)[0];
        const tint = /roof|gable/.test(name) ? TINTS.roof : kind === "sphere" || /stone|chimney/.test(name) ? TINTS.stone : TINTS.wall;
        if (kind === "sphere") return [["sphere", placed(position, turn, [value.radius, value.radius, value.radius]), tint]];
        if (kind === "block") return [["block", placed(position, turn, value.half_size), tint]];
        if (kind === "plate") return [["block", placed(position, turn, [...value.half_size, 0.02]), tint]];
        if (kind === "cylinder") return [["cylinder", placed(position, turn, [value.radius, value.half_length, value.radius]), tint]];
        if (kind === "mesh" && this.files[value.file])
            return [[value.file, placed(position, turn, Array(3).fill(value.scale ?? 1)), tint]];
        return [];
    }
    addFile(name, text) {
        this.files[name] = true;
        this.meshes[name] = this.make(readObj(text));
    }
    ofFan(at, yaw, height, radius, turned, marked) {
        const tint = marked ? marking(TINTS.metal) : TINTS.metal;
        const hub = placed([at[0], at[1] + height, at[2]], [yaw, 0, 0]);
        const face = product(hub, placed([0, 0, 0], [0, 0, 90], [radius, radius, radius]));
        const wings = [0, 1, 2, 3].map((n) => product(product(hub, placed([0, 0, 0], [0, turned + 90 * n, 0])),
            product(placed([0, 0.5 * radius, 0], [28, 0, 0]), placed([0, 0, 0], [0, 0, 0], [0.015, 0.42 * radius, 0.2 * radius]))));
        const pole = placed([at[0], at[1] + 0.5 * (height - radius), at[2]], [0, 0, 0], [0.045, 0.5 * (height - radius), 0.045]);
        return [["ring", face, tint], ...wings.map((wing) => ["block", wing, tint]), ["cylinder", pole, tint],
            ["sphere", product(hub, placed([0, 0, 0], [0, 0, 0], [0.1, 0.1, 0.1])), tint]];
    }
    ofWalker(at, marked) {
        const place = placed(at);
        return [["cape", place, marked ? marking(TINTS.cape) : TINTS.cape], ["hat", place, TINTS.hat],
            ["sphere", placed([at[0], at[1] + 1.64, at[2]], [0, 0, 0], [0.11, 0.13, 0.11]), TINTS.skin],
            ...[-0.09, 0.09].map((off) => ["cylinder", placed([at[0] + off, at[1] + 0.25, at[2]], [0, 0, 0], [0.06, 0.25, 0.06]), TINTS.hat])];
    }
    draw(list, program, places, camera) {
        const {gl} = this.device;
        gl.uniformMatrix4fv(places.camera, false, camera);
        for (const [name, model, tint] of list) {
            const mesh = this.meshes[name];
            gl.bindVertexArray(mesh.array);
            gl.uniformMatrix4fv(places.model, false, model);
            if (places.tint) gl.uniform4fv(places.tint, tint);
            gl.drawElements(gl.TRIANGLES, mesh.count, gl.UNSIGNED_SHORT, 0);
        }
    }
}
/** A tint of what is chosen. */
export const marking = (tint) => tint.map((x, n) => (n < 3 ? 0.65 * x + 0.35 * TINTS.marked[n] : x));
