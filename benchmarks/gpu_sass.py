"""What a cubin's machine code says that its headers do not: how deep in loops instructions lie, and which spill.

An instruction of sm_70 and later is 16 bytes, its kind in the low 12 bits; bits 12 to 15 are the predicate of it
(CUDA binary utilities; the encodings as nvdisasm prints them). Depth is that of
natural loops: the assembler puts rare ways behind all others, so that not every branch back makes a loop.
"""

from __future__ import annotations

import struct
import sys
from dataclasses import dataclass, field
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1] / "tests"))
from emulated_cuda.ptx.dominators import dominators  # pyright: ignore[reportMissingImports]

BYTES = 16
BRANCH, LOAD_LOCAL, STORE_LOCAL = 0x947, 0x983, 0x387
LEAVES = (0x94D, 0x949, 0x94A, 0x950)  # EXIT, BRX, JMX, RET: nothing but a predicate leads on
ALWAYS = 7  # a predicate that is true
WORDS = {5: 2, 6: 4}  # of a lane, by the size field: 64 and 128 bits; all others one word or less
SIZE_BIT = 73 - 64
SPLIT = 90  # from this architecture on a branch's distance is in units of 4 bytes, its low 8 bits by themselves


@dataclass
class Code:
    """A kernel's instructions by depth: all, words loaded from local memory, words stored there."""

    code: list[int] = field(default_factory=list)
    local_loads: list[int] = field(default_factory=list)
    local_stores: list[int] = field(default_factory=list)


def sections(cubin: bytes) -> dict[str, bytes]:
    """The code of each kernel: sections .text.<kernel> of the ELF file."""
    table, entry_size, count, names_at = struct.unpack_from("<Q", cubin, 40) + struct.unpack_from("<3H", cubin, 58)
    headers = [struct.unpack_from("<IIQQQQII", cubin, table + k * entry_size) for k in range(count)]
    found = {}
    for header in headers:
        start = headers[names_at][4] + header[0]
        name = cubin[start : cubin.index(b"\0", start)].decode()
        if name.startswith(".text."):
            found[name.removeprefix(".text.")] = cubin[header[4] : header[4] + header[5]]
    return found


def _distance(low: int, architecture: int) -> int:
    """Bytes from a branch's end to where it goes."""
    if architecture < SPLIT:
        return (low >> 32) - (low >> 63 << 32)
    return 4 * ((low >> 34) - (low >> 63 << 30) << 8 | low >> 16 & 0xFF)


def read_code(text: bytes, architecture: int) -> Code:
    """A kernel's code by depth."""
    words = [struct.unpack_from("<QQ", text, at) for at in range(0, len(text) - BYTES + 1, BYTES)]
    found = Code()
    for (low, high), depth in zip(words, depths(words, architecture), strict=True):
        for counts in (found.code, found.local_loads, found.local_stores):
            counts += [0] * (depth + 1 - len(counts))
        kind, size = low & 0xFFF, WORDS.get(high >> SIZE_BIT & 7, 1)
        found.code[depth] += 1
        found.local_loads[depth] += size * (kind == LOAD_LOCAL)
        found.local_stores[depth] += size * (kind == STORE_LOCAL)
    return found


def depths(words: list[tuple[int, int]], architecture: int) -> list[int]:
    """By instruction: how many natural loops hold it (Aho et al. 2006, 9.6)."""
    leaders, ways = _graph(words, architecture)
    inside: dict[int, set[int]] = {}
    above = dominators(ways, 0)
    before: dict[int, list[int]] = {}
    for block, targets in ways.items():
        for to in targets:
            before.setdefault(to, []).append(block)
    for block, targets in ways.items():
        for head in targets:
            if block in above and _dominates(head, block, above):
                _gather(block, before, inside.setdefault(head, {head}))
    found, places = [], [*leaders, len(words)]
    for block, first in enumerate(leaders):
        found += [sum(block in body for body in inside.values())] * (places[block + 1] - first)
    return found


def _graph(words: list[tuple[int, int]], architecture: int) -> tuple[list[int], dict[int, list[int]]]:
    """The first instruction of each basic block, and where each block leads."""
    targets = {}
    for k, (low, _) in enumerate(words):
        if low & 0xFFF == BRANCH:
            to = k + 1 + _distance(low, architecture) // BYTES
            targets[k] = to if 0 <= to < len(words) else k
    ends = {k for k, (low, _) in enumerate(words) if low & 0xFFF in (BRANCH, *LEAVES)}
    leaders = sorted({0, *targets.values(), *(k + 1 for k in ends if k + 1 < len(words))}) if words else []
    number = {first: block for block, first in enumerate(leaders)}
    ways: dict[int, list[int]] = {}
    for block in range(len(leaders)):
        last = (leaders[block + 1] if block + 1 < len(leaders) else len(words)) - 1
        low, high = words[last]
        goes_on = last not in ends or low >> 12 & 0xF != ALWAYS or (last in targets and high >> 23 & 0xF != ALWAYS)
        ways[block] = [number[targets[last]]] if last in targets else []
        ways[block] += [block + 1] if goes_on and last + 1 < len(words) else []
    return leaders, ways


def _dominates(head: int, block: int, above: dict[int, int]) -> bool:
    while block not in (head, above[block]):
        block = above[block]
    return block == head


def _gather(tail: int, before: dict[int, list[int]], body: set[int]) -> None:
    """Add to a loop what leads to the block that goes back to its head, without passing the head, which is in it."""
    waiting = [tail]
    while waiting:
        block = waiting.pop()
        if block not in body:
            body.add(block)
            waiting += before.get(block, [])
