"""small_png.py: PNGs of 8-bit RGB without interlace, as windrow-draw writes them, read and written; how far two are apart.

A picture is (width, height, bytes), three bytes a pixel, rows from above. `apart` is vegetation/tests/images/drawn.h's.
"""
import struct
import zlib

SIGNATURE = b"\x89PNG\r\n\x1a\n"
FAR = 24  # a tenth of the range: what the eye sees in one pixel beside another


def _paeth(a, b, c):
    p = a + b - c
    return min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))[2]


def read(file):
    data = file.read_bytes()
    if not data.startswith(SIGNATURE):
        raise ValueError(f"{file} is not a PNG")
    width = height = 0
    packed, at = b"", 8
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        if kind == b"IHDR":
            width, height, *form = struct.unpack(">IIBBBBB", body)
            if form != [8, 2, 0, 0, 0]:
                raise ValueError(f"{file} is not a PNG of 8-bit RGB without interlace")
        elif kind == b"IDAT":
            packed += body
        at += 12 + size
    raw, wide = zlib.decompress(packed), 3 * width
    rows, above = [], bytes(wide)
    for y in range(height):
        how, row = raw[y * (wide + 1)], bytearray(raw[y * (wide + 1) + 1:(y + 1) * (wide + 1)])
        for x in range(wide):
            left, up, corner = (row[x - 3] if x >= 3 else 0), above[x], (above[x - 3] if x >= 3 else 0)
            guess = (0, left, up, (left + up) // 2, _paeth(left, up, corner) if how == 4 else 0)[how]
            row[x] = (row[x] + guess) & 255
        rows.append(bytes(row))
        above = rows[-1]
    return width, height, b"".join(rows)


def write(file, picture):
    width, height, values = picture
    rows = b"".join(b"\0" + values[3 * width * y:3 * width * (y + 1)] for y in range(height))

    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
    file.write_bytes(SIGNATURE + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
                     chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def apart(a, b):
    """Of two pictures of one size: mean difference of the channels, 0 to 255, and the fraction of pixels with one above FAR."""
    off = [abs(x - y) for x, y in zip(a[2], b[2])]
    far = sum(max(off[n:n + 3]) > FAR for n in range(0, len(off), 3))
    return sum(off) / len(off), 3 * far / len(off)


def difference(a, b):
    """Eight times as strong, on black."""
    return a[0], a[1], bytes(min(255, 8 * abs(x - y)) for x, y in zip(a[2], b[2]))
