"""Basic blocks of a module, for counting: where lanes that part meet again, what a block costs, what it accesses."""

from __future__ import annotations

import re
from dataclasses import asdict, dataclass, field
from typing import Any

from .costs import SHARED_LATENCY, UNITS, cost_of
from .dominators import dominators
from .instructions import Instruction

SPACES = ("local", "shared", "global", "generic")  # as in runtime/counters.h
ACCESSES = ("load", "store", "atomic")
ENDS = ("bra", "brx", "ret", "exit", "trap", "brkpt", "call")
NO_LEVEL, MOST_LEVELS, MOST_SITES = 255, 8, 1 << 15
END = -1
WARP_FOLDER, DEEPEST = "/warp/native/", 30  # lines of Warp's headers count as those that called them
_REGISTER = re.compile(r"%[\w$]+")


@dataclass
class Block:
    """Statements that run one after the other."""

    statements: int = 0
    units: dict[str, int] = field(default_factory=lambda: dict.fromkeys(UNITS, 0))
    cycles: int = 0  # of the longest chain of instructions that wait for each other, loads from memory left out
    meets: int = END
    after_call: int = END
    places: dict[str, list[int]] = field(default_factory=dict)  # source line -> instructions and statements of it


@dataclass(frozen=True)
class Site:
    """An instruction that accesses memory."""

    space: int
    size: int
    access: int
    level: int
    place: str  # in the source, where the PTX says so


@dataclass
class Blocks:
    """Of a whole module; a block's number is its place in the list."""

    blocks: list[Block] = field(default_factory=list)
    sites: list[Site] = field(default_factory=list)
    functions: dict[str, int] = field(default_factory=dict)  # instructions that the code of each is expected to have
    files: dict[str, str] = field(default_factory=dict)  # of the source, by number

    def described(self) -> dict[str, Any]:
        """As JSON has it."""
        return asdict(self)


class FunctionBlocks:
    """The basic blocks of one function, while it is translated."""

    def __init__(self, blocks: Blocks, function: str):
        self.all, self.function = blocks, function
        self.first = len(blocks.blocks)
        self.labels: dict[str, int] = {}
        self.ways: dict[int, list[str | int]] = {}  # of each block's end: labels, blocks, END
        self.current: int | None = None
        self.called: int | None = None  # the block whose end is a call, until the next begins
        self.ready: dict[str, tuple[int, int]] = {}  # register -> cycle and number of loads before it
        self.is_open, self.level = False, 0
        self.place = ""
        self.inlined: dict[str, str] = {}  # a place in Warp's own headers -> where it was called

    def _begin(self) -> str:
        number = len(self.all.blocks)
        if self.current is not None:
            self.ways.setdefault(self.current, []).append(number)
        if self.called is not None:
            self.all.blocks[self.called].after_call = number
        self.all.blocks.append(Block())
        self.current, self.called, self.ready = number, None, {}
        self.is_open = True
        return f"block_begins(t, {number});"

    def label(self, name: str) -> str:
        """C at a label: a block begins."""
        code = self._begin()
        self.labels[name] = len(self.all.blocks) - 1
        return code

    def before(self, i: Instruction) -> str:
        """C before an instruction: where none is open, a block begins."""
        code = "" if self.is_open else self._begin()
        block = self.all.blocks[self.current or 0]
        block.statements += 1
        cost = cost_of(i)
        for unit in UNITS:
            block.units[unit] += getattr(cost, unit)
        if self.place:
            counts = block.places.setdefault(self.place, [0, 0])
            counts[0], counts[1] = counts[0] + cost.issued, counts[1] + 1
        self._follow(i, block, cost.latency)
        return code

    def line(self, text: str) -> None:
        """`.loc 4 444 5, function_name $L__info_string29, inlined_at 4 1171 5`: what follows is of that line."""
        numbers = re.match(r"\.loc\s+(\d+) (\d+) (\d+)(?:.*inlined_at (\d+) (\d+) (\d+))?", text)
        if numbers is None:
            return
        file, line, column, *caller = numbers.groups()
        here = f"{file} {line} {column}"
        if caller[0] is not None:
            self.inlined[here] = " ".join(caller)
        steps = 0
        while WARP_FOLDER in self.all.files.get(here.split()[0], "") and here in self.inlined and steps < DEEPEST:
            here, steps = self.inlined[here], steps + 1
        number, line, _ = here.split()
        self.place = f"{self.all.files.get(number, number)}:{line}"

    def _follow(self, i: Instruction, block: Block, latency: int) -> None:
        """Put an instruction at the end of the chain that it waits for."""
        stores = i.op in ("st", "red")
        written = [] if stores else _REGISTER.findall("".join(i.operands[:1]))
        read = _REGISTER.findall(" ".join(i.operands if stores else i.operands[1:])) + _REGISTER.findall(i.guard)
        if i.op == "mov" and i.operands[0].startswith("{"):
            written = _REGISTER.findall(i.operands[0])
        start = max((self.ready.get(r, (0, 0))[0] for r in read), default=0)
        self.level = max((self.ready.get(r, (0, 0))[1] for r in read), default=0)
        is_load = i.op in ("ld", "ldu", "atom") and not {"param", "const"} & set(i.parts)
        if is_load and "shared" in "".join(i.parts):
            latency = SHARED_LATENCY
        waits = is_load and "shared" not in "".join(i.parts)
        end = start + latency
        block.cycles = max(block.cycles, end)
        for register in written:
            self.ready[register] = (end, self.level + waits)

    def after(self, i: Instruction, tables: dict[str, list[str]]) -> None:
        """An instruction may end its block."""
        if i.op not in ENDS or self.current is None:
            return
        here, ways = self.current, self.ways.setdefault(self.current, [])
        if i.op == "call":
            self.called = here
        elif i.op == "bra":
            ways.append(i.operands[0])
        elif i.op == "brx":
            ways += tables[i.operands[1]]
        else:
            ways.append(END)
        self.is_open = False
        if i.op != "call" and not i.guard:
            self.current = None  # nothing falls through to what follows

    def site(self, space: str, size: int, access: str, i: Instruction) -> int:
        """The number of an access; of a load, how many loads its address waits for."""
        waits = access == "load" or (access == "atomic" and i.op == "atom" and i.operands[0] != "_")
        level = min(self.level, MOST_LEVELS - 1) if waits else NO_LEVEL
        self.all.sites.append(Site(SPACES.index(space), size, ACCESSES.index(access), level, self.place))
        if len(self.all.sites) > MOST_SITES:
            raise ValueError(f"more than {MOST_SITES} accesses to memory in a module: they cannot be counted")
        return len(self.all.sites) - 1

    def end(self) -> None:
        """Find where the ways from each block meet again: its immediate post-dominator (Cooper et al. 2001)."""
        count = len(self.all.blocks) - self.first
        self.all.functions[self.function] = sum(b.units["issued"] for b in self.all.blocks[self.first :])
        if not count:
            return
        ways = {
            b: {END if w == END else w if isinstance(w, int) else self.labels[w] for w in self.ways.get(b, [END])}
            for b in range(self.first, self.first + count)
        }
        for b, meets in post_dominators(ways).items():
            self.all.blocks[b].meets = meets


def post_dominators(ways: dict[int, set[int]]) -> dict[int, int]:
    """The immediate post-dominator of each block; END where there is none but the function's end."""
    before: dict[int, list[int]] = {}
    for b, targets in ways.items():
        for w in targets:
            before.setdefault(w, []).append(b)
    found = dominators(before, END)
    return {b: found.get(b, END) for b in ways}
