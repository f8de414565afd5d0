"""Functions that damage a file, given a random generator and bytes: numbers, words, lines, bytes, boundaries."""

from __future__ import annotations

import random
import re
import struct
from collections.abc import Callable

Mutation = Callable[[random.Random, bytes], bytes]

# Replacements for numbers: limits of types, other scripts, spellings, empty.
WORDS = [
    *(b"-1 0 1 2 -0 +5 5.5 1e3 1.0 .5 . 1e --1 1-2 00 007 0x10 0x1p3 1_0 nan -nan NaN inf -inf None x").split(),
    *(b"2147483647 2147483648 4294967295 4294967296 9223372036854775808 18446744073709551616 1e39 3.4e38").split(),
    *(b"1e400 1e-400 1e308 -1e308 12345678901234567890 100000 1/1 1//1 1/1/1 1/1/1/1 1// 1/ /1 //1 2/2/ -4").split(),
    *(b"list float int uchar property element comment end_header f v vt vn usemtl g o l $ # alpha red x nx").split(),
    b"", b"9" * 30, b"0" * 400 + b"1", b"9" * 5000, b"\xef\xbc\x91", b"\xd9\xa1", b"1\x00", b"\\", b"\xff",
    b"\xc2\xa0", b"\xe2\x80\xa8", b"\x0b", b"\x1c", b"\t", b"\r", b"\x00", b'"', b"}",
]  # fmt: skip
_INTEGERS = (
    0,
    1,
    2,
    3,
    7,
    8,
    127,
    128,
    255,
    256,
    32767,
    32768,
    65535,
    65536,
    2**31 - 1,
    2**31,
    2**32 - 1,
    2**63,
    2**64 - 1,
)
_REAL = (float("nan"), float("inf"), -float("inf"), 0.0, -0.0, 1e300, -1e300, 1e-300, 1e38, 3.4e38, 1.0, -1.0)
_NUMBER = re.compile(rb"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")


def change_number(rng: random.Random, data: bytes) -> bytes:
    """Replace a number, usually by a similar one."""
    matches = list(_NUMBER.finditer(data[:4000]))
    if not matches:
        return data
    at = rng.choice(matches)
    word = rng.choice(WORDS)
    if rng.random() < 0.5:
        try:
            word = str(int(at.group()) + rng.choice([-2, -1, 1, 2, 10])).encode()
        except ValueError:
            word = repr(float(at.group()) * rng.choice([-1, 2, 1e10, 1e39])).encode()
    return data[: at.start()] + word + data[at.end() :]


def change_word(rng: random.Random, data: bytes) -> bytes:
    matches = list(re.finditer(rb"\S+", data[:4000]))
    if not matches:
        return data
    at = rng.choice(matches)
    return data[: at.start()] + rng.choice(WORDS) + data[at.end() :]


def change_lines(rng: random.Random, data: bytes) -> bytes:
    """Swap, repeat, drop or cut lines, or the words of one."""
    lines = data.split(b"\n")
    i, j = rng.randrange(len(lines)), rng.randrange(len(lines))
    words = lines[i].split(b" ")
    k = rng.randrange(7)
    if k == 0:
        lines[i], lines[j] = lines[j], lines[i]
    elif k == 1:
        lines.insert(i, lines[j])
    elif k == 2:
        del lines[i]
    elif k == 3:
        rng.shuffle(words)
        lines[i] = b" ".join(words)
    elif k == 4:
        words.insert(rng.randrange(len(words) + 1), rng.choice(WORDS))
        lines[i] = b" ".join(words)
    elif k == 5:
        del words[rng.randrange(len(words))]
        lines[i] = b" ".join(words)
    else:
        lines[i] = lines[i] + rng.choice([b" ", b"\\\n", b" # x", b"\r"]) + lines[j]
    return b"\n".join(lines)


def change_bytes(rng: random.Random, data: bytes) -> bytes:
    """Flip, overwrite, insert, drop, repeat or append bytes."""
    size = len(data)
    if not size:
        return data
    at = rng.randrange(min(size, 600)) if rng.random() < 0.4 else rng.randrange(size)
    end = min(size, at + rng.randrange(1, 64))
    some = bytes(rng.randrange(256) for _ in range(rng.randrange(1, 9)))
    value = rng.choice(_INTEGERS)
    width = rng.choice([1, 2, 4, 8])
    order = rng.choice(["<", ">"])
    real = rng.choice(_REAL)
    number = struct.pack(order + "d", real) if abs(real) > 1e39 else struct.pack(order + rng.choice("fd"), real)
    encoded = (value % (1 << 8 * width)).to_bytes(width, "little" if order == "<" else "big")
    return rng.choice(
        [
            data[:at] + bytes([data[at] ^ (1 << rng.randrange(8))]) + data[at + 1 :],
            data[:at] + encoded + data[at + width :],
            data[:at] + number + data[at + len(number) :],
            data[:at] + some + data[at:],
            data[:at] + data[end:],
            data[:end] + data[at:end] + data[end:],
            data[:at] + bytes(end - at) + data[end:],
            data + some,
        ]
    )


def cut(rng: random.Random, data: bytes) -> bytes:
    """Truncate after, before or in the middle of a line, a word or a block of a few bytes."""
    borders = [match.end() for match in re.finditer(rb"[ \n]", data)] or [len(data)]
    at = rng.choice(borders) if rng.random() < 0.7 else rng.randrange(len(data) + 1)
    return data[: max(0, at - rng.choice([0, 0, 1, 2, 4, 12, 50]))]


def mix(*mutations: Mutation) -> Mutation:
    """Apply one to three mutations in sequence."""

    def mutate(rng: random.Random, data: bytes) -> bytes:
        for _ in range(rng.choice([1, 1, 1, 2, 3])):
            data = rng.choice(mutations)(rng, data)
        return data

    return mutate


text = mix(change_number, change_number, change_word, change_word, change_lines, change_bytes, cut)
binary = mix(change_bytes, change_bytes, change_number, change_word, cut)


def corners(rng: random.Random, data: bytes) -> bytes:
    """OBJ with face words of every form, valid and invalid ones mixed."""
    lines = data.split(b"\n")
    rows = [k for k, line in enumerate(lines) if line.startswith(b"f ")]
    for k in rng.sample(rows, rng.randint(1, len(rows))):
        form = rng.choice([b"%d", b"%d/%d", b"%d//%d", b"%d/%d/%d", b"%d/", b"%d//", b"%d/%d/", b"/%d", b"%d/%d/%d/%d"])
        words = []
        for _ in range(rng.choice([1, 2, 3, 3, 3, 4, 4, 5, 8])):
            if rng.random() < 0.1:
                form = rng.choice([b"%d", b"%d/%d", b"%d//%d", b"%d/%d/%d", b"%d//%d/%d", b"//%d/", b"%d/%d/", b"-%d"])
            numbers = [rng.choice([1, 2, 3, 4, 5, -1, -2, -3, 1, 2, 3]) for _ in range(form.count(b"%d"))]
            if rng.random() < 0.05:
                numbers[-1] = rng.choice([0, 6, -6, 99, 10**20, -(10**20)])
            words.append(form % tuple(numbers))
        lines[k] = b"f " + rng.choice([b" ", b"  ", b"\t"]).join(words)
    return b"\n".join(lines)
