// A tree's form at rest, in a few hundred vertices of wood and some thousand cards of leaves: Weber & Penn's rule as vegetation/trees has
// it (tree_shape.cpp, leaf_cards.cpp, crown_light.cpp), with the same settings and chances of its own.
import {add, cross, length, scaled, sub, unit} from "./gl.js";

const GOLDEN = 2.39996323, BRANCH_TURN = 2.44346;
const rad = (deg) => (deg * Math.PI) / 180;
export const clamp = (x, low, high) => Math.min(Math.max(x, low), high);

export class Chance {
    constructor(seed) {
        this.state = (Math.imul(seed + 1, 2654435761) ^ 0x9e3779b9) >>> 0;
    }
    share() {
        let x = (this.state = (this.state + 0x6d2b79f5) >>> 0);
        x = Math.imul(x ^ (x >>> 15), x | 1);
        x ^= x + Math.imul(x ^ (x >>> 7), x | 61);
        return ((x ^ (x >>> 14)) >>> 0) / 2 ** 32;
    }
    between(a, b) {
        return a + (b - a) * this.share();
    }
    around(a) {
        return this.between(-a, a);
    }
    vector(a) {
        return [this.around(a), this.around(a), this.around(a)];
    }
}
// A unit vector at right angles to a unit vector, turned about it.
function frameOf(axis) {
    const x = unit(cross(Math.abs(axis[1]) < 0.9 ? [0, 1, 0] : [1, 0, 0], axis));
    return [x, cross(axis, x)];
}
function beside(axis, turn) {
    const [x, y] = frameOf(axis);
    return add(scaled(x, Math.cos(turn)), scaled(y, Math.sin(turn)));
}
/** Length of limbs over the longest's; r from the crown's top, 0, to its base, 1. */
export function formLength(form, r) {
    const s = clamp(r, 0, 1);
    return {cone: 0.15 + 0.85 * r, round: 0.25 + 0.75 * Math.sin(Math.PI * s), dome: 0.45 + 0.55 * Math.sin(0.5 * Math.PI * s), column: 1,
        flame: 0.2 + 0.8 * (r < 0.7 ? r / 0.7 : (1.15 - r) / 0.45)}[form];
}
const on = (values, t, mix) => {
    const at = clamp(t, 0, 1) * (values.length - 1), n = Math.min(Math.floor(at), values.length - 2);
    return mix(values[n], values[n + 1], at - n);
};
const pointOn = (stem, t) => on(stem.points, t, (a, b, s) => add(a, scaled(sub(b, a), s)));
const radiusOn = (stem, t) => on(stem.radii, t, (a, b, s) => a + s * (b - a));

// A stem that turns up or down and strays as it goes.
function walk({from, direction, long, radius, tip, rise, wander, rings, limb}, chance) {
    const points = [], radii = [], steps = rings - 1;
    for (let n = 0; n <= steps; ++n) {
        points.push(from);
        radii.push(radius * (1 - ((1 - tip) * n) / steps));
        from = add(from, scaled(direction, long / steps));
        direction = unit(add(add(direction, chance.vector(wander)), [0, (2 * rise) / steps, 0]));
    }
    return {points, radii, limb};
}
function growTrunk(s, chance) {
    const points = [], radii = [], phases = [chance.between(0, 6.28), chance.between(0, 6.28)];
    for (let n = 0; n < 12; ++n) {
        const t = Math.pow(n / 11, 1.35), y = n === 0 ? -0.3 : t * s.height, stray = s.trunk_wander * s.height * t;
        points.push([stray * (Math.sin(5 * t + phases[0]) - Math.sin(phases[0])), y, stray * (Math.sin(4.3 * t + phases[1]) - Math.sin(phases[1]))]);
        radii.push(s.trunk_radius * (1 + 0.75 * Math.exp(-Math.max(y, 0) / (1.6 * s.trunk_radius))) * (1 - 0.94 * t));
    }
    return {points, radii, limb: -1};
}
function growLimb(s, trunk, n, chance) {
    const whorl = Math.max(s.whorl, 1), rows = Math.ceil(s.limbs / whorl), row = Math.floor(n / whorl);
    const t = (row + (s.whorl ? 0.5 + chance.around(0.12) : chance.share())) / rows;
    const y = s.height * (s.crown_base + (0.985 - s.crown_base) * Math.pow(t, s.limb_crowding));
    const around = s.whorl ? (2 * Math.PI * (n % s.whorl)) / s.whorl + 0.7 * row + chance.around(0.25) : GOLDEN * n + chance.around(0.35);
    const fromUp = rad(s.limb_low_deg + (s.limb_high_deg - s.limb_low_deg) * t + chance.around(9));
    const share = Math.pow(y / s.height, 1 / 1.35);
    const long = s.limb_length * formLength(s.form, 1 - t) * chance.between(0.82, 1.08);
    const radius = clamp(s.trunk_radius * Math.pow(long / s.height, 1.2), 0.004, 0.75 * radiusOn(trunk, share) + 0.004);
    return walk({from: pointOn(trunk, share), direction: [Math.sin(fromUp) * Math.cos(around), Math.cos(fromUp), Math.sin(fromUp) * Math.sin(around)],
        long, radius, tip: 0.12, rise: s.limb_rise, wander: s.wander, rings: 7, limb: n}, chance);
}
function growBranch(s, limb, n, count, turn, chance) {
    const last = n + 1 === count, bare = s.leaf_form === "needles" ? 0.06 : 0.22;
    const t = last ? 0.97 : bare + ((0.97 - bare) * (n + chance.share())) / Math.max(count - 1, 1);
    const along = unit(sub(pointOn(limb, Math.min(t + 0.08, 1)), pointOn(limb, t - 0.08)));
    const limbLength = length(sub(limb.points[limb.points.length - 1], limb.points[0]));
    const angle = rad(last ? 12 : s.branch_deg + chance.around(14));
    const side = beside(along, turn);
    side[1] *= 0.6;
    const long = limbLength * s.branch_fraction * (last ? 0.55 : 1 - 0.55 * t) * chance.between(0.8, 1.2);
    const radius = clamp(limb.radii[0] * Math.pow(long / Math.max(limbLength, 1e-3), 1.2), 0.003, 0.8 * radiusOn(limb, t) + 0.003);
    return walk({from: pointOn(limb, t), direction: unit(add(scaled(along, Math.cos(angle)), scaled(side, Math.sin(angle)))), long, radius, tip: 0.3,
        rise: s.branch_rise, wander: s.wander, rings: 3, limb: limb.limb}, chance);
}
function growTwig(s, branch, n, chance) {
    const {points} = branch, along = unit(sub(points[points.length - 1], points[0]));
    const t = s.clusters === 1 ? 1 : 0.25 + (0.75 * (n + 0.7 * chance.share())) / s.clusters;
    const angle = n + 1 === s.clusters ? 0.15 : chance.between(0.5, 1.1);
    const axis = add(scaled(along, Math.cos(angle)), scaled(beside(along, BRANCH_TURN * n + chance.around(0.6)), Math.sin(angle)));
    return {root: pointOn(branch, t), axis: unit(add(add(axis, [0, -s.leaf_droop, 0]), chance.vector(0.1))),
        long: s.cluster_length * chance.between(0.75, 1.25), limb: branch.limb};
}
function cardOn(s, twig, number, n, chance) {
    const [x, y] = frameOf(twig.axis), needles = s.leaf_form === "needles", last = n + 1 === s.leaves;
    const turn = GOLDEN * n + 2.4 * number + chance.around(0.4);
    const angle = last ? 0.1 : needles ? chance.between(0.35, 0.7) : chance.between(0.6, 1.15);
    const side = add(scaled(x, Math.cos(turn)), scaled(y, Math.sin(turn)));
    side[1] *= needles ? 0.35 : 0.7;
    const along = unit(add(add(scaled(twig.axis, Math.cos(angle)), scaled(side, Math.sin(angle))), add([0, -0.6 * s.leaf_droop, 0], chance.vector(0.12))));
    const face = unit(add([0, 1, 0], chance.vector(needles ? 0.5 : 0.9)));
    const across = unit(add(cross(face, along), scaled(x, 1e-3)));
    const size = chance.between(0.75, 1.2), long = s.leaf_length * size, wide = s.leaf_width * size * chance.between(0.85, 1.15);
    const root = add(twig.root, scaled(twig.axis, twig.long * (last ? 1 : (n + 0.5) / s.leaves)));
    return {root, along, across, long, wide, twig: number, limb: twig.limb, chance: chance.around(1), normal: unit(cross(along, across)),
        centre: add(root, scaled(along, 0.5 * long))};
}
/** trunk, limbs, branches: points, radii, limb; twigs: root, axis, long, limb; cards, in a random order. */
export function grow(s) {
    const chance = new Chance(s.seed);
    const trunk = growTrunk(s, chance), limbs = [], branches = [], twigs = [];
    for (let n = 0; n < s.limbs; ++n) {
        const limb = growLimb(s, trunk, n, chance);
        limbs.push(limb);
        const whorl = Math.max(s.whorl, 1), rows = Math.ceil(s.limbs / whorl);
        const count = 1 + Math.round(s.branches * Math.min(formLength(s.form, 1 - (Math.floor(n / whorl) + 0.5) / rows), 1));
        const turn = chance.between(0, 2 * Math.PI);
        for (let k = 0; k < count; ++k) {
            const branch = growBranch(s, limb, k, count, turn + BRANCH_TURN * k, chance);
            branches.push(branch);
            for (let c = 0; c < s.clusters; ++c) twigs.push(growTwig(s, branch, c, chance));
        }
    }
    const cards = twigs.flatMap((twig, number) => Array.from({length: s.leaves}, (_, n) => cardOn(s, twig, number, n, chance)));
    for (let n = cards.length; n > 1; --n) {
        const k = Math.floor(chance.share() * n);
        [cards[n - 1], cards[k]] = [cards[k], cards[n - 1]];
    }
    return {trunk, limbs, branches, twigs, cards};
}

// --- light within the crown ------------------------------------------------------------------------------------------------
const CELLS = 12, ABSORBED = 0.5;
/** A function of a place that gives [x, y, z, w]: the share of light from a unit vector d is w + xyz . d, by 26 rays. */
export function crownLight(cards) {
    const low = [0, 1, 2].map((k) => Math.min(...cards.map(({centre}) => centre[k])) - 0.1);
    const cell = [0, 1, 2].map((k) => (Math.max(...cards.map(({centre}) => centre[k])) + 0.1 - low[k]) / CELLS);
    const density = new Float32Array(CELLS ** 3), volume = cell[0] * cell[1] * cell[2];
    const cellAt = (p) => {
        const [i, j, k] = p.map((x, n) => Math.floor((x - low[n]) / cell[n]));
        return Math.min(i, j, k) < 0 || Math.max(i, j, k) >= CELLS ? -1 : (k * CELLS + j) * CELLS + i;
    };
    for (const {centre, long, wide} of cards) density[cellAt(centre)] += (0.3 * long * wide) / volume;
    const rays = [];
    for (let n = 0; n < 27; ++n) if (n !== 13) rays.push(unit([(n % 3) - 1, (Math.floor(n / 3) % 3) - 1, Math.floor(n / 9) - 1]));
    const step = Math.min(...cell);
    return (p) => {
        const open = [0, 0, 0, 0];
        for (const ray of rays) {
            let depth = 0;
            for (let t = 0.5 * step; ; t += step) {
                const at = cellAt(p.map((x, n) => x + t * ray[n]));
                if (at < 0) break;
                depth += density[at] * step;
            }
            const passed = Math.exp(-ABSORBED * depth) / rays.length;
            ray.forEach((x, n) => (open[n] += 3 * passed * x));
            open[3] += passed;
        }
        return open;
    };
}
/** A tube along a stem: appends to places, normals, [around 0 to 1 and back, along, radius, limb]. */
export function tube(mesh, {points, radii, limb}, sides) {
    const first = mesh.at.length / 3;
    let far = 0;
    points.forEach((point, n) => {
        const along = unit(sub(points[Math.min(n + 1, points.length - 1)], points[Math.max(n - 1, 0)]));
        const [x, y] = frameOf(along);
        if (n > 0) far += length(sub(point, points[n - 1]));
        for (let k = 0; k < sides; ++k) {
            const turn = (2 * Math.PI * k) / sides, out = add(scaled(x, Math.cos(turn)), scaled(y, Math.sin(turn)));
            mesh.at.push(...add(point, scaled(out, radii[n])));
            mesh.normals.push(...out);
            mesh.wood.push(1 - Math.abs(1 - (2 * k) / sides), far, radii[n], limb);
            if (n > 0) {
                const a = first + n * sides + k, b = first + n * sides + ((k + 1) % sides);
                mesh.indices.push(a - sides, b - sides, a, a, b - sides, b);
            }
        }
    });
}
export const chordOf = ({points}) => sub(points[points.length - 1], points[0]);
