// WebGL 2 by hand: programs, textures, matrices.

/** The text of a shader with its includes, each once. */
export function assemble(texts, name, seen = new Set()) {
    seen.add(name);
    return texts[name].replace(/^#include "(.*)"$/gm, (_, other) => (seen.has(other) ? "" : assemble(texts, other, seen)));
}

const BLOCKS = ["Page", "WindrowBlock", "Plants", "Ground", "Tree", "Coat"]; // by their bindings

export class Device {
    constructor(canvas, texts) {
        // Smooth edges cost a software device twice its time.
        const probe = document.createElement("canvas").getContext("webgl2");
        const software = /swiftshader|llvmpipe|software/i.test(probe?.getParameter(probe.getExtension("WEBGL_debug_renderer_info")?.UNMASKED_RENDERER_WEBGL ?? 7937) ?? "");
        probe?.getExtension("WEBGL_lose_context")?.loseContext();
        this.software = software;
        this.gl = canvas.getContext("webgl2", {antialias: !software, alpha: false, powerPreference: "high-performance"});
        if (!this.gl) throw new Error("This browser has no WebGL 2: open the page in a current browser.");
        const {gl} = this;
        this.texts = texts;
        this.floats = gl.getExtension("EXT_color_buffer_float") !== null; // else halves
        if (!this.floats && !gl.getExtension("EXT_color_buffer_half_float"))
            throw new Error("This device cannot draw into textures of floats, which the springs of the grass need.");
        gl.getExtension("OES_texture_float_linear");
        this.programs = {};
        this.blocks = {};
        this.pending = [];
    }
    /** Starts to compile; `ready` looks at the result, so that a driver may compile all at once. */
    program(name, vertex, fragment) {
        const {gl} = this;
        const id = gl.createProgram();
        for (const [kind, file] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
            const shader = gl.createShader(kind);
            gl.shaderSource(shader, assemble(this.texts, file));
            gl.compileShader(shader);
            gl.attachShader(id, shader);
        }
        gl.linkProgram(id);
        this.pending.push([name, id]);
    }
    ready() {
        const {gl} = this;
        for (const [name, id] of this.pending) {
            if (!gl.getProgramParameter(id, gl.LINK_STATUS))
                throw new Error(`${name}: ${gl.getAttachedShaders(id).map((shader) => gl.getShaderInfoLog(shader)).join("")}${gl.getProgramInfoLog(id)}`);
            const places = {};
            const samplers = [];
            const count = gl.getProgramParameter(id, gl.ACTIVE_UNIFORMS);
            for (let n = 0; n < count; ++n) {
                const {name: uniform, type} = gl.getActiveUniform(id, n);
                const place = gl.getUniformLocation(id, uniform);
                if (!place) continue; // of a block
                places[uniform] = place;
                if ([gl.SAMPLER_2D, gl.SAMPLER_3D, gl.SAMPLER_2D_SHADOW].includes(type)) samplers.push([uniform, type]);
            }
            gl.useProgram(id);
            samplers.forEach(([uniform], unit) => gl.uniform1i(places[uniform], unit));
            for (const [point, block] of BLOCKS.entries()) {
                const index = gl.getUniformBlockIndex(id, block);
                if (index !== gl.INVALID_INDEX) gl.uniformBlockBinding(id, index, point);
            }
            this.programs[name] = {id, places, samplers};
        }
        this.pending = [];
    }
    /** A uniform buffer at the binding of its block. */
    block(name, bytes) {
        const {gl} = this;
        const point = BLOCKS.indexOf(name);
        if (!this.blocks[name]) {
            this.blocks[name] = gl.createBuffer();
            gl.bindBuffer(gl.UNIFORM_BUFFER, this.blocks[name]);
            gl.bufferData(gl.UNIFORM_BUFFER, bytes, gl.DYNAMIC_DRAW);
            gl.bindBufferBase(gl.UNIFORM_BUFFER, point, this.blocks[name]);
        } else {
            gl.bindBuffer(gl.UNIFORM_BUFFER, this.blocks[name]);
            gl.bufferSubData(gl.UNIFORM_BUFFER, 0, bytes);
        }
    }
    /** Makes a program the current one, with textures by name. */
    use(name, textures = {}) {
        const {gl} = this;
        const program = this.programs[name];
        gl.useProgram(program.id);
        program.samplers.forEach(([uniform, type], unit) => {
            gl.activeTexture(gl.TEXTURE0 + unit);
            gl.bindTexture(type === gl.SAMPLER_3D ? gl.TEXTURE_3D : gl.TEXTURE_2D, textures[uniform] ?? null);
        });
        return program.places;
    }
    texture2d(format, width, height, {filter = this.gl.NEAREST, data = null, kind, type, wrap = this.gl.CLAMP_TO_EDGE} = {}) {
        const {gl} = this;
        const texture = gl.createTexture();
        gl.bindTexture(gl.TEXTURE_2D, texture);
        gl.texStorage2D(gl.TEXTURE_2D, 1, format, width, height);
        if (data) gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, kind, type, data);
        this.sampling(gl.TEXTURE_2D, filter, wrap);
        return texture;
    }
    texture3d(format, [x, y, z], filter) {
        const {gl} = this;
        const texture = gl.createTexture();
        gl.bindTexture(gl.TEXTURE_3D, texture);
        gl.texStorage3D(gl.TEXTURE_3D, 1, format, x, y, z);
        this.sampling(gl.TEXTURE_3D, filter, gl.CLAMP_TO_EDGE);
        return texture;
    }
    sampling(target, filter, wrap) {
        const {gl} = this;
        for (const key of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(target, key, filter);
        gl.texParameteri(target, gl.TEXTURE_WRAP_S, wrap);
        for (const key of [gl.TEXTURE_WRAP_T, gl.TEXTURE_WRAP_R]) gl.texParameteri(target, key, gl.CLAMP_TO_EDGE);
    }
    target(textures, depth = null) {
        const {gl} = this;
        const frame = gl.createFramebuffer();
        gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
        textures.forEach((texture, n) =>
            gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0 + n, gl.TEXTURE_2D, texture, 0));
        if (depth) gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, depth, 0);
        gl.drawBuffers(textures.length ? textures.map((_, n) => gl.COLOR_ATTACHMENT0 + n) : [gl.NONE]);
        return frame;
    }
    /** A vertex array of [data, size] attributes, and of indices. */
    mesh(attributes, indices = null) {
        const {gl} = this;
        const array = gl.createVertexArray();
        gl.bindVertexArray(array);
        attributes.forEach(([data, size], n) => {
            gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
            gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
            gl.enableVertexAttribArray(n);
            gl.vertexAttribPointer(n, size, gl.FLOAT, false, 0, 0);
        });
        if (indices) {
            gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
            gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, indices, gl.STATIC_DRAW);
        }
        gl.bindVertexArray(null);
        return {array, count: indices ? indices.length : attributes[0][0].length / attributes[0][1]};
    }
}

// --- matrices by columns ---------------------------------------------------------------------------------------------
export const add = (a, b) => a.map((x, n) => x + b[n]);
export const sub = (a, b) => a.map((x, n) => x - b[n]);
export const scaled = (a, k) => a.map((x) => k * x);
export const dot = (a, b) => a.reduce((sum, x, n) => sum + x * b[n], 0);
export const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];
export const length = (a) => Math.hypot(...a);
export const unit = (a) => scaled(a, 1 / length(a));

export function product(a, b) {
    const m = new Float32Array(16);
    for (let c = 0; c < 4; ++c)
        for (let r = 0; r < 4; ++r) for (let k = 0; k < 4; ++k) m[4 * c + r] += a[4 * k + r] * b[4 * c + k];
    return m;
}
export function lookAt(eye, target, up = [0, 1, 0]) {
    const back = unit(sub(eye, target)), right = unit(cross(up, back)), above = cross(back, right);
    return new Float32Array([right[0], above[0], back[0], 0, right[1], above[1], back[1], 0, right[2], above[2], back[2], 0,
        -dot(right, eye), -dot(above, eye), -dot(back, eye), 1]);
}
export function perspective(view, aspect, near, far) {
    const f = 1 / Math.tan(view / 2);
    return new Float32Array([f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, (near + far) / (near - far), -1, 0, 0, (2 * near * far) / (near - far), 0]);
}
export function orthographic(width, height, near, far) {
    return new Float32Array([2 / width, 0, 0, 0, 0, 2 / height, 0, 0, 0, 0, -2 / (far - near), 0, 0, 0, -(far + near) / (far - near), 1]);
}
export function inverse(m) {
    const rows = Array.from({length: 4}, (_, r) => [...[0, 1, 2, 3].map((c) => m[4 * c + r]), ...[0, 1, 2, 3].map((c) => Number(c === r))]);
    for (let c = 0; c < 4; ++c) {
        let best = c;
        for (let r = c + 1; r < 4; ++r) if (Math.abs(rows[r][c]) > Math.abs(rows[best][c])) best = r;
        [rows[c], rows[best]] = [rows[best], rows[c]];
        const lead = rows[c][c];
        rows[c] = rows[c].map((x) => x / lead);
        for (let r = 0; r < 4; ++r) if (r !== c) {
            const k = rows[r][c];
            rows[r] = rows[r].map((x, n) => x - k * rows[c][n]);
        }
    }
    return new Float32Array(16).map((_, n) => rows[n % 4][4 + (n >> 2)]);
}
/** A model matrix of a place, [yaw, pitch, roll] in degrees and a size along each axis. */
export function placed(at, turn = [0, 0, 0], size = [1, 1, 1]) {
    const [y, x, z] = turn.map((deg) => (deg * Math.PI) / 180);
    const [cy, sy, cx, sx, cz, sz] = [Math.cos(y), Math.sin(y), Math.cos(x), Math.sin(x), Math.cos(z), Math.sin(z)];
    const columns = [[cy * cz + sy * sx * sz, cx * sz, -sy * cz + cy * sx * sz], [-cy * sz + sy * sx * cz, cx * cz, sy * sz + cy * sx * cz],
        [sy * cx, -sx, cy * cx]];
    const m = new Float32Array(16);
    columns.forEach((column, c) => column.forEach((value, r) => (m[4 * c + r] = value * size[c])));
    m.set([...at, 1], 12);
    return m;
}
export function transform(m, [x, y, z, w = 1]) {
    return [0, 1, 2, 3].map((r) => m[r] * x + m[4 + r] * y + m[8 + r] * z + m[12 + r] * w);
}
