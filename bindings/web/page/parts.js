// The module in two parts: what the first picture and the first gestures call, and the rest, which comes after the picture.
//
// tools/make_web.py splits it. The first part imports a function of `placeholder` for each that its table has in the rest; when the rest
// is made, its own functions take their places in the table. A call that comes sooner waits for the rest. Both parts are one module with
// one memory, and compute the same bits as the whole.
import {instantiate} from "../package/windrow.js";
import {unpacked} from "./unpack.js";

/** The library of the packed bytes of the first part; `rest` is the address of the other, or its packed bytes. */
export async function instantiateParts(createWindrow, first, rest, description) {
    let exports = null;
    const load = (packed) => {
        if (exports === null || !rest) return;
        const bytes = unpacked(new Uint8Array(packed ?? (typeof rest === "string" ? fetchNow(rest) : rest)));
        rest = null;
        new WebAssembly.Instance(new WebAssembly.Module(bytes), {primary: exports});
    };
    const late = (index) => (...values) => {
        load();
        return exports.__indirect_function_table.get(Number(index))(...values);
    };
    const instantiateWasm = (imports, made) => {
        const placeholder = new Proxy({}, {get: (_, index) => late(index)});
        WebAssembly.instantiate(unpacked(new Uint8Array(first)), {...imports, placeholder}).then(({instance, module}) => {
            exports = instance.exports;
            made(instance, module);
        });
        return {};
    };
    const library = await instantiate(createWindrow, {instantiateWasm}, description);
    return {library, load, fetchRest: async () => typeof rest === "string" && load(await (await fetch(rest)).arrayBuffer())};
}

function fetchNow(address) {
    const request = new XMLHttpRequest();
    request.open("GET", address, false);
    request.responseType = "arraybuffer";
    request.send();
    if (request.status !== 200) throw new Error(`${address}: the server answered ${request.status}`);
    return request.response;
}
