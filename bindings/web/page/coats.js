// Coats of shells on the bodies of a scene, picture.bodies: the wind bends each vertex's strand once a frame, layers follow it.
import {beastMesh} from "./beast.js";
import {unit} from "./gl.js";

const SKIN_ROW = 64;         // vertices in a row of their textures
const MOST_SPOTS = 24;
const BLOCK_FLOATS = 4 * (4 + 6 + 2 + 8 + 1 + 4 * MOST_SPOTS);
const LAYERS = [12, 16, 20, 32, 96]; // that each quality draws at most

// Defaults as vegetation/fur has them (coat_settings.h, strand_field.h).
const STRANDS = {density: 100, low: 0.4, high: 1, thickness: 1, bow: 0, bow_turns: 0.25, tuft: 0, tuft_size: 6, seed: 0};
const COMB = {along: [0, -1, 0], bend: 0, tousle: 0, tousle_size: 0.05};
const LOOK = {root: [0.05, 0.04, 0.03], tip: [0.45, 0.38, 0.3], second: null, skin: [0.25, 0.18, 0.15], second_size: 1, tip_power: 1, variation: 0.15,
    occlusion: 0.7, occlusion_bias: 0.15, wrap: 1, gloss: 0.05, gloss_power: 24, sheen: 0.15, sheen_power: 40, through: 0.2, strand_normals: 0.6};
const SPOT = {from: [0, 0, 0], to: [0, 0, 0], radius: 0.05, soft: 0.02, length: 1, colour: [0, 0, 0], tint: 0};

export class Coats {
    constructor(device) {
        Object.assign(this, {device, meshes: {}, bodies: []});
    }
    mesh(beast) {
        const key = JSON.stringify(beast);
        if (this.meshes[key]) return this.meshes[key];
        const {device} = this, {gl} = device, {places, normals, indices} = beastMesh(beast);
        const rows = Math.ceil(places.length / SKIN_ROW), texels = new Float32Array(8 * SKIN_ROW * rows);
        places.forEach((place, n) => texels.set([...place, 0, ...normals[n], 0], 8 * n));
        const floats = (values) => new Float32Array(values.flat());
        return (this.meshes[key] = {count: places.length, rows, skin: device.texture2d(gl.RGBA32F, 2 * SKIN_ROW, rows, {data: texels, kind: gl.RGBA, type: gl.FLOAT}),
            drawn: device.mesh([[floats(places), 3], [floats(normals), 3]], new Uint16Array(indices))});
    }
    setScene(bodies, blocks, heightAt) {
        const {device} = this, {gl} = device;
        for (const {textures, target} of this.bodies) {
            textures.forEach((texture) => gl.deleteTexture(texture));
            gl.deleteFramebuffer(target);
        }
        let row = 0;
        this.bodies = bodies.flatMap((body) => body.coats.map((coat) => {
            const mesh = this.mesh(body.mesh.beast ?? {});
            const {position = [0, 0, 0], yaw_deg: yaw = 0, above_ground: above = false} = body.place ?? {};
            const format = device.floats ? gl.RGBA32F : gl.RGBA16F;
            const textures = [0, 1].map(() => device.texture2d(format, SKIN_ROW, mesh.rows));
            const at = above ? [position[0], position[1] + heightAt(position[0], position[2]), position[2]] : position;
            return {mesh, coat, height: body.mesh.beast?.height ?? 2, at, yaw: (yaw * Math.PI) / 180, shells: blocks[row++], textures, target: device.target(textures),
                block: new ArrayBuffer(4 * BLOCK_FLOATS)};
        }));
    }
    /** A ball about each body, for hands. */
    balls() {
        return this.bodies.map(({at: [x, y, z], height}) => ({at: [x, y + 0.7 * height, z], reach: 0.75 * height}));
    }
    fill({coat, mesh, at, yaw, shells, block}, layers, tufts) {
        const numbers = new Float32Array(block);
        const [strands, comb, look] = [{...STRANDS, ...coat.strands}, {...COMB, ...coat.comb}, {...LOOK, ...coat.look}];
        const spots = (coat.spots ?? []).slice(0, MOST_SPOTS).map((spot) => ({...SPOT, ...spot}));
        numbers.set(shells, 0);
        numbers[3] = layers - 1;
        numbers.set([strands.density, 1, 0, strands.seed, 1, 0, 0, 0, strands.low, strands.high, 0, 0, strands.thickness, 0, 1, 0.7,
            strands.bow, strands.bow_turns, tufts ? strands.tuft : 0, 1 / strands.tuft_size, 0, 0, 0, 0], 16);
        numbers.set([...at, layers, Math.cos(yaw), Math.sin(yaw), 0, 0, ...unit(comb.along), comb.bend, comb.tousle, 1 / comb.tousle_size, 0, 0.02,
            ...look.root, look.tip_power, ...look.tip, look.variation, ...(look.second ?? look.tip), 1 / look.second_size, ...look.skin, look.occlusion_bias,
            look.occlusion, look.wrap, look.gloss, look.gloss_power, look.sheen, look.sheen_power, look.through, look.strand_normals], 40);
        new Int32Array(block).set([mesh.count, spots.length, 0, 0], 80);
        spots.forEach((spot, n) => numbers.set([...spot.from, spot.radius, ...spot.to, spot.soft, ...spot.colour, spot.tint, spot.length, 0, 0, 0], 84 + 16 * n));
        this.device.block("Coat", numbers);
    }
    layers({coat}, quality) {
        return Math.min(coat.layers?.shells ?? 32, LAYERS[quality]);
    }
    bend(shared, quality) {
        const {device} = this, {gl} = device;
        gl.disable(gl.DEPTH_TEST);
        for (const body of this.bodies) {
            this.fill(body, this.layers(body, quality), quality > 2);
            device.use("strands", {...shared, skin_places: body.mesh.skin});
            gl.bindFramebuffer(gl.FRAMEBUFFER, body.target);
            gl.viewport(0, 0, SKIN_ROW, body.mesh.rows);
            gl.drawArrays(gl.TRIANGLES, 0, 3);
        }
        gl.enable(gl.DEPTH_TEST);
    }
    draw(shared, camera, quality, shadow) {
        const {device} = this, {gl} = device;
        for (const body of this.bodies) {
            const layers = this.layers(body, quality);
            this.fill(body, layers, quality > 2);
            const uniforms = device.use("coat", {...shared, strand_bend: body.textures[0], strand_own: body.textures[1]});
            gl.uniformMatrix4fv(uniforms.camera, false, camera);
            gl.uniform1i(uniforms.depth_alone, Number(shadow));
            gl.bindVertexArray(body.mesh.drawn.array);
            gl.drawElementsInstanced(gl.TRIANGLES, body.mesh.drawn.count, gl.UNSIGNED_SHORT, 0, shadow ? 1 : layers);
        }
    }
}
