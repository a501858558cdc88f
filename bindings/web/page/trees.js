// Trees of a scene, picture.trees: each part is a spring in a texel, each vertex is moved by windrow_tree_bent.
import {length, unit} from "./gl.js";
import {chordOf, clamp, crownLight, formLength, grow, tube} from "./grow.js";

const ROW = 64;           // parts in a row of their textures
const MEAN_RADIUS = 0.56; // as vegetation/trees/tree_wind.cpp has these, and the formulas of both functions below
const FOLIAGE = 0.24;
const LIMB_WOOD = 0.5;
// Cards that each quality draws, of all: fewer ones are larger.
const SHARES = [0.35, 0.55, 0.8, 1, 1];
const rod = (modulus, thickness) => (modulus * Math.PI * thickness ** 4) / 64;
const limbRadius = (s) => s.trunk_radius * Math.pow(s.limb_length / s.height, 1.2);

/** What the worker makes the classes of trunk and limbs of, in the words of windrow_drag. */
export function windClasses(s) {
    let form = 0;
    for (let n = 0; n < 8; ++n) form += formLength(s.form, (n + 0.5) / 8) / 8;
    const spread = Math.max(Math.sin((0.5 * (s.limb_low_deg + s.limb_high_deg) * Math.PI) / 180), 0.2);
    const crown = 2 * s.limb_length * form * spread * (1 - s.crown_base);
    return {trunk: {length: s.height, width: crown + 2 * s.trunk_radius * s.crown_base, rigidity: rod(s.wood, 2 * MEAN_RADIUS * s.trunk_radius)},
        branch: {length: s.limb_length, width: FOLIAGE * s.limb_length, rigidity: rod(LIMB_WOOD * s.wood, 2 * MEAN_RADIUS * limbRadius(s))}};
}
function limbStiffness(s, long, radius) {
    return clamp(((s.limb_length / Math.max(long, 1e-3)) * (radius / limbRadius(s))) ** 4, 0.05, 1e4);
}

export class Trees {
    constructor(device) {
        Object.assign(this, {device, models: {}, stands: []});
    }
    /** Textures and vertices of a kind, once. */
    model(name) {
        if (this.models[name]) return this.models[name];
        const {device} = this, {gl} = device, {tree: s} = TREE_KINDS[name];
        const {trunk, limbs, branches, twigs, cards} = grow(s);
        const parts = [[[0, 0, 0], [0, 1, 0], s.height, 1],
            ...limbs.map((limb) => [limb.points[0], unit(chordOf(limb)), length(chordOf(limb)), limbStiffness(s, length(chordOf(limb)), limb.radii[0])]),
            ...twigs.map(({root, axis, long}, n) => [root, axis, long, 0.6 + 0.8 * ((0.618034 * n) % 1)])];
        const rows = Math.ceil(parts.length / ROW), texels = new Float32Array(8 * ROW * rows);
        parts.forEach(([root, axis, reach, stiffness], n) => texels.set([...root, reach, ...axis, stiffness], 8 * n));
        const light = crownLight(cards);
        const wood = {at: [], normals: [], wood: [], indices: []};
        [[trunk], limbs, branches].forEach((stems, kind) => stems.forEach((stem) => tube(wood, stem, [10, 6, 3][kind])));
        const open = [];
        for (let n = 0; n < wood.at.length; n += 3) open.push(...light(wood.at.slice(n, n + 3)));
        const leaf = {at: [], normals: [], which: [], open: [], centre: [], indices: []};
        const twigLight = twigs.map(({root, axis, long}) => light(root.map((x, n) => x + 0.5 * long * axis[n])));
        cards.forEach(({root, along, across, long, wide, twig, limb, chance, normal, centre}, n) => {
            for (const [u, v] of [[0, 0], [0.5, 1], [1, 0], [0.5, -1]]) {
                leaf.at.push(...root.map((x, k) => x + u * long * along[k] + 0.5 * v * wide * across[k]));
                leaf.normals.push(...normal);
                leaf.which.push(1 + limbs.length + twig, 1 + limb, u, v);
                leaf.open.push(...twigLight[twig]);
                leaf.centre.push(...centre, chance);
            }
            leaf.indices.push(4 * n, 4 * n + 1, 4 * n + 2, 4 * n, 4 * n + 2, 4 * n + 3);
        });
        const floats = (values) => new Float32Array(values);
        return (this.models[name] = {parts: parts.length, stems: 1 + limbs.length, rows, count: cards.length,
            places: device.texture2d(gl.RGBA32F, 2 * ROW, rows, {data: texels, kind: gl.RGBA, type: gl.FLOAT}),
            wood: device.mesh([[floats(wood.at), 3], [floats(wood.normals), 3], [floats(wood.wood), 4], [floats(open), 4]], new Uint16Array(wood.indices)),
            leaves: device.mesh([[floats(leaf.at), 3], [floats(leaf.normals), 3], [floats(leaf.which), 4], [floats(leaf.open), 4],
                [floats(leaf.centre), 4]], new Uint16Array(leaf.indices))});
    }
    setScene(trees, blocks, heightAt) {
        const {device} = this, {gl} = device;
        for (const {states} of this.stands)
            for (const {textures, target} of states) {
                textures.forEach((texture) => gl.deleteTexture(texture));
                gl.deleteFramebuffer(target);
            }
        const format = device.floats ? gl.RGBA32F : gl.RGBA16F;
        this.stands = trees.flatMap(({kind, places = []}, row) => places.map(({at: [x, z], size = 1, yaw_deg: yaw = 0}, n) => {
            const model = this.model(kind);
            const states = [0, 1].map(() => {
                const textures = [0, 1, 2].map(() => device.texture2d(format, ROW, model.rows));
                return {textures, target: device.target(textures)};
            });
            return {kind, model, states, wind: blocks[row], base: [x, heightAt(x, z), z, size], yaw: (yaw * Math.PI) / 180,
                chance: ((0.618034 * (n + 3 * row + 1)) % 1) * 2 - 1, block: new ArrayBuffer(640), begun: false};
        }));
    }
    /** The middle of each crown and its reach [m]. */
    crowns() {
        return this.stands.map(({kind, base: [x, y, z, size]}) => {
            const {height, crown_base: low, limb_length: reach} = TREE_KINDS[kind].tree;
            return {at: [x, y + 0.5 * size * height * (1 + low), z], reach: size * Math.max(0.85 * reach, 0.4 * height * (1 - low))};
        });
    }
    /** A frame of springs: `motion` has the steps of the twelve bands and the leaves' flutter. */
    bend(shared, motion) {
        const {device} = this, {gl} = device;
        gl.disable(gl.DEPTH_TEST);
        for (const stand of this.stands) {
            const {model, states, kind} = stand;
            const {look, tree} = TREE_KINDS[kind], numbers = new Float32Array(stand.block);
            numbers.set(stand.wind, 0);
            numbers.set(motion, 12);
            numbers.set([...stand.base, Math.cos(stand.yaw), Math.sin(stand.yaw), stand.chance, 0], 120);
            new Int32Array(stand.block).set([model.parts, model.stems, Number(stand.begun), Number(tree.leaf_form === "needles")], 128);
            numbers.set([...look.bark, look.bark_lines, ...look.furrow, 0, ...look.leaf, look.variation, ...look.young, look.gloss, ...look.through,
                look.against_light], 132);
            device.block("Tree", numbers);
            const [from, to] = states;
            device.use("sway", {...shared, places: model.places, sway_now: from.textures[0], sway_speed: from.textures[1], sway_target: from.textures[2]});
            gl.bindFramebuffer(gl.FRAMEBUFFER, to.target);
            gl.viewport(0, 0, ROW, model.rows);
            gl.drawArrays(gl.TRIANGLES, 0, 3);
            stand.states = [to, from];
            stand.begun = true;
        }
        gl.enable(gl.DEPTH_TEST);
    }
    draw(shared, camera, quality, shadow) {
        const {device} = this, {gl} = device;
        for (const {model, states, block} of this.stands) {
            device.block("Tree", new Float32Array(block));
            const textures = {...shared, places: model.places, sway_now: states[0].textures[0]};
            for (const name of ["wood", "leaf"]) {
                const uniforms = device.use(name, textures);
                gl.uniformMatrix4fv(uniforms.camera, false, camera);
                gl.uniform1i(uniforms.depth_alone, Number(shadow));
                const mesh = name === "wood" ? model.wood : model.leaves;
                const share = shadow ? Math.min(SHARES[quality], 0.5) : SHARES[quality];
                if (name === "leaf") gl.uniform1f(uniforms.wide, 1.06 * Math.pow(share, -0.5));
                gl.bindVertexArray(mesh.array);
                gl.drawElements(gl.TRIANGLES, name === "wood" ? mesh.count : 6 * Math.ceil(share * model.count), gl.UNSIGNED_SHORT, 0);
            }
        }
    }
}
