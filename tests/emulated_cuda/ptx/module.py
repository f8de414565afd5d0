"""A module of PTX: its variables, its functions, and the C file that they become."""

from __future__ import annotations

import re
from dataclasses import dataclass, field

from .function import Function, FunctionTranslator, parameter
from .instructions import SIZES, UnknownPtx, clean

__all__ = ["Kernel", "Translation", "UnknownPtx", "translate"]

_NUMBER = re.compile(r"^-?(0[xX][0-9a-fA-F]+|\d+)U?$")


@dataclass
class Kernel:
    """What a launch has to know of a kernel."""

    name: str
    symbol: str
    parameters: list[tuple[int, int]]  # offset and size of each
    parameter_bytes: int
    waits: bool  # its threads wait for each other: barriers, shuffles, votes
    max_threads: int
    static_shared: int
    findings: list[str]  # notes about the PTX: float atomics, products that ptxas may fuse, approximations
    statements: int
    local_bytes: int


@dataclass
class Translation:
    """The C source of a module, and its kernels."""

    source: str
    shared_window: int  # bytes of static shared memory, which dynamic memory follows
    kernels: list[Kernel]


@dataclass
class Variables:
    """A module's variables: offsets in shared memory, and the bytes of global and constant memory."""

    shared: dict[str, tuple[int, int]] = field(default_factory=dict)
    shared_size: int = 0
    dynamic: set[str] = field(default_factory=set)
    data: dict[str, int] = field(default_factory=dict)
    content: bytearray = field(default_factory=bytearray)
    relocations: list[tuple[int, str, int]] = field(default_factory=list)

    def declare(self, text: str) -> None:
        """A declaration such as `.const .align 4 .b8 table[8] = {1, 2}`."""
        declared, _, value = text.partition("=")
        kind = next((t for t in re.findall(r"\.([a-z]+\d+)\b", declared) if t in SIZES), None)
        named = re.search(r"([%$\w]+)\s*((?:\[\d*\]\s*)*)$", declared.strip())
        if kind is None or named is None:
            raise UnknownPtx(f"variable {text[:80]!r}")
        name, count = named.group(1), 1
        for length in re.findall(r"\[(\d*)\]", named.group(2)):
            count *= int(length or 0)
        aligned = re.search(r"\.align\s+(\d+)", declared)
        size, align = SIZES[kind] * count, int(aligned.group(1)) if aligned else SIZES[kind]
        if ".shared" not in declared:
            self._fill(name, size, align, SIZES[kind], value)
        elif ".extern" in declared:
            self.dynamic.add(name)
        else:
            offset = -(-self.shared_size // align) * align
            self.shared[name], self.shared_size = (offset, size), offset + size

    def _fill(self, name: str, size: int, align: int, width: int, value: str) -> None:
        offset = -(-len(self.content) // align) * align
        self.content += bytes(offset - len(self.content))
        self.data[name] = offset
        content = bytearray(size)
        entries = [e.strip() for e in re.sub(r"[{}]", "", value).split(",") if e.strip()]
        for k, entry in enumerate(entries):
            byte_range = slice(k * width, (k + 1) * width)
            if _NUMBER.match(entry):
                content[byte_range] = (int(entry.rstrip("U"), 0) % (1 << 8 * width)).to_bytes(width, "little")
            elif entry[:2].lower() in ("0f", "0d"):
                content[byte_range] = int(entry[2:], 16).to_bytes(width, "little")
            else:
                symbol = re.match(r"^(?:generic\()?([$\w]+)\)?(?:\+(\d+))?$", entry)
                if not symbol:
                    raise UnknownPtx(f"initializer {entry!r}")
                self.relocations.append((offset + k * width, symbol.group(1), int(symbol.group(2) or 0)))
        self.content += content

    def in_c(self) -> list[str]:
        """The C declarations of global and constant memory."""
        content = ",".join(map(str, self.content)) or "0"
        size = max(len(self.content), 1)
        lines = [
            f"#define DYNAMIC_SHARED {-(-self.shared_size // 16) * 16}ull",
            f"static u8 MODULE_DATA[{size}] __attribute__((aligned(256))) = {{{content}}};",
            f"static const u64 MODULE_DATA_SIZE = {size};",
        ]
        if self.relocations:
            lines.append("__attribute__((constructor)) static void relocate(void) {")
            for at, name, extra in self.relocations:
                target = f"(u64)(uintptr_t)(MODULE_DATA + {self.data[name] + extra})"
                lines.append(f"  *(u64 *)(MODULE_DATA + {at}) = {target};")
            lines.append("}")
        return lines


def _matching(text: str, start: int, opening: str = "{", closing: str = "}") -> int:
    """Where the bracket that opens at `start` closes."""
    depth = 0
    for match in re.compile(f"[{re.escape(opening + closing)}]").finditer(text, start):
        depth += 1 if match.group() == opening else -1
        if depth == 0:
            return match.start()
    raise UnknownPtx("unbalanced brackets")


def _function(head: str, body: str | None) -> Function:
    is_kernel = ".entry" in head
    rest = head.split(".entry" if is_kernel else ".func", 1)[1].strip()

    def take_list() -> list[tuple[str, int, int]]:
        nonlocal rest
        if not rest.startswith("("):
            return []
        end = _matching(rest, 0, "(", ")")
        parameters = [parameter(p) for p in rest[1:end].split(",") if p.strip()]
        rest = rest[end + 1 :].strip()
        return parameters

    returns = [] if is_kernel else take_list()
    named = re.match(r"[$\w]+", rest)
    if not named:
        raise UnknownPtx(f"function {head[:80]!r}")
    rest = rest[named.end() :].strip()
    function = Function(named.group(), is_kernel, take_list(), returns, body)
    limit = re.search(r"\.maxntid\s+(\d+)(?:\s*,\s*(\d+))?(?:\s*,\s*(\d+))?", rest)
    if limit:
        function.max_threads = int(limit.group(1)) * int(limit.group(2) or 1) * int(limit.group(3) or 1)
    return function


def _read(text: str) -> tuple[Variables, dict[str, Function]]:
    """Take a module apart."""
    variables, functions = Variables(), {}
    skipped = re.compile(r"\s+|;|\.(?:version|target|address_size|file|pragma)[^\n]*")
    position = 0
    while position < len(text):
        if blank := skipped.match(text, position):
            position = blank.end()
            continue
        if text.startswith(".section", position):
            position = _matching(text, text.index("{", position)) + 1
            continue
        semicolon, brace = text.find(";", position), text.find("{", position)
        first = text[position : min(x for x in (semicolon, brace, len(text)) if x >= 0)]
        if ".entry" not in first and ".func" not in first:
            variables.declare(text[position:semicolon])
            position = semicolon + 1
            continue
        has_body = brace >= 0 and not 0 <= semicolon < brace
        end = _matching(text, brace) if has_body else semicolon
        function = _function(text[position : brace if has_body else end], text[brace + 1 : end] if has_body else None)
        if function.name not in functions or functions[function.name].body is None:
            functions[function.name] = function
        position = end + 1
    return variables, functions


def _spread_calls(functions: dict[str, Function]) -> None:
    """A function waits, and uses shared memory, where one that it calls does."""
    changed = True
    while changed:
        changed = False
        for f in functions.values():
            for g in (functions[name] for name in f.calls):
                if (g.waits and not f.waits) or not g.shared <= f.shared or not g.findings <= f.findings:
                    f.waits, changed = f.waits or g.waits, True
                    f.shared |= g.shared
                    f.findings |= g.findings


def translate(text: str) -> Translation:
    """The C source of a module of PTX, and what its kernels take."""
    text = re.sub(r"//[^\n]*", "", re.sub(r"/\*.*?\*/", "", text.rstrip("\0 \n"), flags=re.S))
    variables, functions = _read(text)
    written = [f for f in functions.values() if f.body is not None]
    bodies, unknown = [], set()
    for function in written:
        translator = FunctionTranslator(function, functions, variables)
        bodies.append(translator.in_c())
        unknown |= translator.unknown
    if unknown:
        raise UnknownPtx("not translated: " + "; ".join(sorted(unknown)[:20]))
    _spread_calls(functions)
    declared = [f"{f.signature()};" for f in written if not f.is_kernel]
    head = ['#include "arithmetic.h"', *variables.in_c()]
    kernels = [
        Kernel(
            f.name,
            clean(f.name),
            list(f.offsets.values()),
            f.parameter_bytes,
            f.waits,
            f.max_threads,
            sum(variables.shared[name][1] for name in f.shared if name in variables.shared),
            sorted(f.findings),
            (f.body or "").count(";"),
            f.local_bytes,
        )
        for f in written
        if f.is_kernel
    ]
    source = "\n".join([*head, *declared, *bodies])
    return Translation(source, -(-variables.shared_size // 16) * 16, kernels)
