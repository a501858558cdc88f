// What scenes may have beside a meadow, in the words of the command's pictures: trees and furred bodies. The page fetches this script with
// the first scene that has them.
import {dot, length, sub} from "./gl.js";
import {Coats} from "./coats.js";
import {Trees, windClasses} from "./trees.js";

const MOST_TREES = 12, MOST_BODIES = 4;

/** Throws the sentence of what this page cannot draw as it is written; `left_out` names what it leaves out. */
function read({trees = [], bodies = []}) {
    const leftOut = [];
    trees.forEach(({kind, scatter, places = []}, n) => {
        if (!(kind in TREE_KINDS)) throw new Error(`picture.trees[${n}].kind is '${kind}'; give one of ${Object.keys(TREE_KINDS).join(", ")}.`);
        for (const {at} of places)
            if (!(Array.isArray(at) && at.length === 2 && at.every(Number.isFinite)))
                throw new Error(`picture.trees[${n}].places: 'at' is ${JSON.stringify(at)}; give x and z in metres.`);
        if (scatter) leftOut.push(`picture.trees[${n}].scatter`);
    });
    const drawn = bodies.filter(({mesh, coats}, n) => {
        if (mesh?.beast && Array.isArray(coats)) return true;
        leftOut.push(`picture.bodies[${n}]`);
        return false;
    });
    const count = trees.reduce((sum, {places = []}) => sum + places.length, 0);
    if (count > MOST_TREES) throw new Error(`picture.trees has ${count} places; this page draws ${MOST_TREES} at most.`);
    if (drawn.length > MOST_BODIES) throw new Error(`picture.bodies has ${drawn.length} bodies; this page draws ${MOST_BODIES} at most.`);
    return {trees, bodies: drawn, leftOut};
}

class Scenery {
    constructor(device) {
        Object.assign(device.texts, SCENERY_SHADERS);
        for (const name of ["wood", "leaf", "coat"]) device.program(name, `${name}.vert`, `${name}.frag`);
        for (const name of ["sway", "strands"]) device.program(name, "whole.vert", `${name}.frag`);
        device.ready();
        this.trees = new Trees(device);
        this.coats = new Coats(device);
    }
    /** What the worker makes blocks of, and what is not drawn. */
    wants(picture) {
        const {trees, bodies, leftOut} = read(picture);
        return {classes: trees.map(({kind}) => windClasses(TREE_KINDS[kind].tree)),
            coats: bodies.flatMap(({coats}) => coats.map(({layers = {}}) => layers)), leftOut};
    }
    setScene(picture, {trees: treeBlocks, coats: coatBlocks}, heightAt) {
        const {trees, bodies} = read(picture);
        this.trees.setScene(trees, treeBlocks, heightAt);
        this.coats.setScene(bodies, coatBlocks, heightAt);
    }
    get shows() {
        return this.trees.stands.length + this.coats.bodies.length > 0;
    }
    bend(shared, motion, quality) {
        if (motion) this.trees.bend(shared, motion);
        this.coats.bend(shared, quality);
    }
    draw(shared, camera, quality, shadow) {
        this.trees.draw(shared, camera, quality, shadow);
        this.coats.draw(shared, camera, quality, shadow);
    }
    /** Where a ray meets a crown or a body: its point nearest to the middle; null beside all. */
    pick({from, ray}) {
        let best = null;
        for (const {at, reach} of [...this.trees.crowns(), ...this.coats.balls()]) {
            const along = dot(sub(at, from), ray), point = from.map((x, n) => x + along * ray[n]);
            if (along > 0 && length(sub(at, point)) < reach && (!best || along < best.along)) best = {along, point};
        }
        return best?.point ?? null;
    }
}
self.WindrowScenery = Scenery;
