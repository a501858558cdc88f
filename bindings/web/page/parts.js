// The module in two parts: what the first picture and the first gestures call, and the rest, which comes after the picture.
//
// tools/make_web.py splits it. The first part imports a function of `placeholder` for each that its table has in the rest; when the rest
// is made, its own functions take their places in the table. A call that comes sooner waits for the rest. Both parts are one module with
// one memory, and compute the same bits as the whole. A load that fails within a call leaves that call half done: its error is `Late`,
// after which the module is no more to be used.
import {instantiate} from "../package/windrow.js";
import {fetchBytes, nameOf, patience} from "./fetched.js";
import {unpacked} from "./unpack.js";

/** The other part could not be had; `within` a call, which is then left half done. */
export class Late extends Error {
    constructor(text, within = false) {
        super(text);
        this.within = within;
    }
}

/** The library of the packed bytes of the first part; `rest` is the address of the other, or its packed bytes. */
export async function instantiateParts(createWindrow, first, rest, description) {
    const address = typeof rest === "string" ? rest : null;
    let exports = null, fails, bytes = address ? null : rest, whole = !rest, coming = null;
    const failure = new Promise((_, reject) => (fails = reject));
    const load = (within = true) => {
        if (exports === null || whole) return;
        bytes ??= fetchNow(address);
        try {
            new WebAssembly.Instance(new WebAssembly.Module(unpacked(new Uint8Array(bytes))), {primary: exports});
        } catch (fault) {
            if (!address) throw fault;
            bytes = null;
            throw new Late(`${nameOf(address)} is damaged`, within);
        }
        whole = true;
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
        coming ??= bytes || whole ? null : fetchBytes(address).finally(() => (coming = null));
        const fetched = await coming?.catch((fault) => {
            throw new Late(fault.message);
        });
        bytes ??= fetched ?? null;
        load(false);
        return bytes;
    };
    return {library, load, fetchRest, isWhole: () => whole};
}

// Within a call, which cannot wait in another way.
function fetchNow(address) {
    const request = new XMLHttpRequest();
    request.open("GET", address, false);
    request.responseType = "arraybuffer";
    request.timeout = patience();
    try {
        request.send();
    } catch {
        throw new Late(`${nameOf(address)}: the server does not answer`, true);
    }
    if (request.status !== 200) throw new Late(`${nameOf(address)}: the server answered ${request.status}`, true);
    return request.response;
}
