// A scene and a log as text of a link, and back: deflated where the browser can, in the letters of base64 that a link may hold.
import {fetchBytes} from "./fetched.js";

async function through(stream, bytes) {
    const writer = stream.writable.getWriter();
    writer.write(bytes);
    writer.close();
    return new Uint8Array(await new Response(stream.readable).arrayBuffer());
}
function letters(bytes) {
    let text = "";
    for (let n = 0; n < bytes.length; n += 8192) text += String.fromCharCode(...bytes.subarray(n, n + 8192));
    return btoa(text).replace(/\+/g, "-").replace(/\//g, "_").replace(/=+$/, "");
}
export function bytesOf(text) {
    return Uint8Array.from(atob(text.replace(/-/g, "+").replace(/_/g, "/")), (letter) => letter.charCodeAt(0));
}
export async function toLink(value) {
    const bytes = new TextEncoder().encode(JSON.stringify(value));
    if (typeof CompressionStream === "undefined") return "0" + letters(bytes);
    return "1" + letters(await through(new CompressionStream("deflate-raw"), bytes));
}
export async function fromLink(text) {
    const bytes = bytesOf(text.slice(1));
    const plain = text[0] === "1" ? await through(new DecompressionStream("deflate-raw"), bytes) : bytes;
    return JSON.parse(new TextDecoder().decode(plain));
}
export const isInlined = typeof INLINED !== "undefined";
/** What the single file holds inlined, else what a server or a folder has. */
export async function fetchFile(name) {
    if (isInlined && name in INLINED) return (await through(new DecompressionStream("gzip"), bytesOf(INLINED[name]))).buffer;
    return fetchBytes(name);
}
