// LZMA, which packs a module by a quarter more than the gzip that a browser has. tools/make_web.py packs.
//
// A file is its unpacked length (4 bytes, the lowest first) and a raw stream of LZMA with lc = 4, lp = 0 and pb = 0, which the wholly
// unaligned bytes of WebAssembly like best.
// Based on: Igor Pavlov, LZMA specification (draft), 2015.
const LITERAL_BITS = 4;
const LONGEST_RUN = 272;
// Where the probabilities of each model are.
const [MATCH, REP, REP_0, REP_1, REP_2, SHORT] = [0, 12, 24, 36, 48, 60];
const [SLOTS, PLACES, ALIGNED, LENGTHS, REP_LENGTHS, LITERALS] = [72, 328, 456, 472, LONGEST_RUN + 474, 2 * LONGEST_RUN + 476];

export function unpacked(packed) {
    const size = new DataView(packed.buffer, packed.byteOffset).getUint32(0, true);
    const out = new Uint8Array(size);
    const odds = new Uint16Array(LITERALS + (0x300 << LITERAL_BITS)).fill(1024);
    let at = 5, range = 0xffffffff, code = 0;
    const next = () => {
        code = ((code << 8) | packed[at++]) >>> 0;
    };
    const bit = (n) => {
        const odd = odds[n], bound = (range >>> 11) * odd;
        const one = code >= bound ? 1 : 0;
        if (one) {
            range -= bound;
            code -= bound;
            odds[n] = odd - (odd >>> 5);
        } else {
            range = bound;
            odds[n] = odd + ((2048 - odd) >>> 5);
        }
        if (range < 0x1000000) {
            range = (range << 8) >>> 0;
            next();
        }
        return one;
    };
    const tree = (first, bits) => {
        let node = 1;
        for (let n = 0; n < bits; ++n) node = (node << 1) | bit(first + node);
        return node - (1 << bits);
    };
    const reversed = (first, bits) => {
        let node = 1, value = 0;
        for (let n = 0; n < bits; ++n) {
            const one = bit(first + node);
            node = (node << 1) | one;
            value |= one << n;
        }
        return value;
    };
    const direct = (bits) => {
        let value = 0;
        for (let n = 0; n < bits; ++n) {
            range >>>= 1;
            const one = code >= range ? 1 : 0;
            if (one) code -= range;
            value = (value << 1) | one;
            if (range < 0x1000000) {
                range = (range << 8) >>> 0;
                next();
            }
        }
        return value;
    };
    const lengthOf = (first) => {
        if (!bit(first)) return 2 + tree(first + 2, 3);
        return bit(first + 1) ? 18 + tree(first + 18, 8) : 10 + tree(first + 10, 3);
    };
    for (let n = 0; n < 4; ++n) next();
    let state = 0, place = 0;
    let back = [0, 0, 0, 0]; // the last distances, less one
    while (place < size) {
        if (!bit(MATCH + state)) {
            const model = LITERALS + 0x300 * (place > 0 ? out[place - 1] >> (8 - LITERAL_BITS) : 0);
            let letter = 1;
            if (state >= 7) {
                let other = out[place - back[0] - 1], same = true;
                while (same && letter < 0x100) {
                    const expected = (other >> 7) & 1;
                    other <<= 1;
                    const one = bit(model + ((1 + expected) << 8) + letter);
                    letter = (letter << 1) | one;
                    same = one === expected;
                }
            }
            while (letter < 0x100) letter = (letter << 1) | bit(model + letter);
            out[place++] = letter;
            state = state < 4 ? 0 : state < 10 ? state - 3 : state - 6;
            continue;
        }
        let length;
        if (bit(REP + state)) {
            if (!bit(REP_0 + state)) {
                if (!bit(SHORT + state)) {
                    out[place] = out[place - back[0] - 1];
                    ++place;
                    state = state < 7 ? 9 : 11;
                    continue;
                }
            } else {
                const which = bit(REP_1 + state) ? 2 + bit(REP_2 + state) : 1;
                back = [back[which], ...back.filter((_, n) => n !== which)];
            }
            length = lengthOf(REP_LENGTHS);
            state = state < 7 ? 8 : 11;
        } else {
            length = lengthOf(LENGTHS);
            state = state < 7 ? 7 : 10;
            const slot = tree(SLOTS + 64 * Math.min(length - 2, 3), 6);
            let far = slot;
            if (slot >= 4) {
                const bits = (slot >> 1) - 1;
                far = (2 | (slot & 1)) << bits;
                if (slot < 14) far += reversed(PLACES + far - slot, bits);
                else far += (direct(bits - 4) << 4) + reversed(ALIGNED, 4);
            }
            back = [far, back[0], back[1], back[2]];
        }
        for (; length > 0 && place < size; --length, ++place) out[place] = out[place - back[0] - 1];
    }
    return out;
}
