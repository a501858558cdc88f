// The module in two parts: what the first picture and the first gestures call, and the rest, which comes after the picture.
//
// tools/make_web.py splits it. The first part imports a function of `placeholder` for each that its table has in the rest; when the rest
// is made, its own functions take their places in the table. A call that comes sooner waits for the rest. Both parts are one module with
// one memory, and compute the same bits as the whole.
import {instantiate} from "../package/windrow.js";
import {unpacked} from "./unpack.js";

/** The library of the packed bytes of the first part; `rest` is the address of the other, or its packed bytes. */
export async function instantiateParts(createWindrow, first, rest, description) {
    let exports = null, fails;
    const failure = new Promise((_, reject) => (fails = reject));
    const load = (packed) => {
        if (exports === null || !rest) return;
        const bytes = unpacked(new Uint8Array(packed ?? (typeof rest === "string" ? fetchNow(rest) : rest)));
        new WebAssembly.Instance(new WebAssembly.Module(bytes), {primary: exports});
        rest = null; // what failed is tried again by the next call
    };
    const late = (index) => (...values) => {
        load();
        return exports.__indirect_function_table.get(Number(index))(...values);
    };
    const instantiateWasm = (imports, made) => {
        const placeholder = new Proxy({}, {get: (_, index) => late(index)});
        // Emscripten keeps what is thrown here to itself, and would wait for `made`.
        (async () => {
            const {instance, module} = await WebAssembly.instantiate(unpacked(new Uint8Array(first)), {...imports, placeholder});
            exports = instance.exports;
            made(instance, module);
        })().catch(fails);
        return {};
    };
    const library = await Promise.race([instantiate(createWindrow, {instantiateWasm}, description), failure]);
    const fetchRest = async () => {
        if (typeof rest !== "string") return;
        const answer = await fetch(rest);
        if (!answer.ok) throw new Error(`${rest}: the server answered ${answer.status}`);
        load(await answer.arrayBuffer());
    };
    return {library, load, fetchRest};
}

function fetchNow(address) {
    const request = new XMLHttpRequest();
    request.open("GET", address, false);
    request.responseType = "arraybuffer";
    request.send();
    if (request.status !== 200) throw new Error(`${address}: the server answered ${request.status}`);
    return request.response;
}
