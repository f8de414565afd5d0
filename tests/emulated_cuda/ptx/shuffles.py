"""Runs of shuffles become one meeting of the warp.

A sum of vectors shuffles word after word by the same distance: 54 times for 27 doubles, five times over. What is sent
is known before anything arrives, so the words are collected, and what works on received ones waits until the run ends.
That is a reordering of statements on registers alone, within a basic block; no result changes.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from .instructions import PURE, Instruction, clean

if TYPE_CHECKING:
    from .function import FunctionTranslator

LONGEST = 256  # words
_MODES = {"up": "UP", "down": "DOWN", "bfly": "XOR", "idx": "INDEX"}


def alone(f: FunctionTranslator, i: Instruction) -> str:
    """The C of a shuffle that is no part of a run: only the lanes whose guard is true meet."""
    to, _, inside = (x.strip() for x in i.operands[0].partition("|"))
    sent, distance, clamp, mask = (f.value(x, "b32") for x in i.operands[1:])
    mode = f"SHUFFLE_{_MODES[i.one_of(*_MODES)]}"
    code = [
        f"u32 one = {sent}, got;",
        f"u8 found = emulator_shuffle(t, {mode}, 1, &one, &got, {distance}, {clamp}, {mask}, {i.number});",
        f.set(to, "b32", "got"),
        f"{clean(inside)} = found;" if inside not in ("", "_") else "(void)found;",
    ]
    return f"{{ {' '.join(code)} }}"


def _registers(text: str) -> set[str]:
    return set(re.findall(r"[%$A-Za-z_]\w*", text))


def _accesses(i: Instruction) -> tuple[set[str], set[str]]:
    """The registers that an instruction writes and reads, the carry among them."""
    written, read = _registers("".join(i.operands[:1])), _registers(" ".join([*i.operands[1:], i.guard]))
    if "cc" in i:
        written.add("carry")
    if i.op in ("addc", "subc", "madc"):
        read.add("carry")
    return written, read | written if i.guard else read


class ShuffleRun:
    """Shuffles that have been sent and not yet received."""

    def __init__(self, translator: FunctionTranslator):
        self.translator = translator
        self._clear()

    def _clear(self) -> None:
        self.first: Instruction | None = None
        self.targets: list[tuple[str, str]] = []  # where each word goes, and whether it came from inside
        self.delayed: list[str] = []
        self.late: set[str] = set()  # registers that are not there yet
        self.needed: set[str] = set()  # registers that what is delayed will read

    def add(self, i: Instruction, code: str | None) -> list[str]:
        """The C to be written now for an instruction, of which `code` is the plain C."""
        written, read = _accesses(i)
        if i.op == "shfl" and not i.guard:
            before = [] if self._continues(i, written) else self.end()
            return [*before, self._send(i, written)]
        if self.first is None:
            return [code or ""]
        if i.op not in PURE:
            return [*self.end(), code or ""]
        if (read | written) & self.late:
            self.delayed.append(code or "")
            self.late |= written
            self.needed |= read
            return []
        return [*(self.end() if written & self.needed else []), code or ""]

    def _continues(self, i: Instruction, written: set[str]) -> bool:
        if self.first is None or len(self.targets) == LONGEST:
            return False
        same = i.parts == self.first.parts and i.operands[2:] == self.first.operands[2:]
        return same and not _registers(i.operands[1]) & self.late and not written & (self.late | self.needed)

    def _send(self, i: Instruction, written: set[str]) -> str:
        if self.first is None:
            self.first = i
            self.needed = _registers(" ".join(i.operands[2:]))
        to, _, inside = (x.strip() for x in i.operands[0].partition("|"))
        self.targets.append((to, inside))
        self.late |= written
        return f"sent[{len(self.targets) - 1}] = {self.translator.value(i.operands[1], 'b32')};"

    def end(self) -> list[str]:
        """The C that receives what was sent, and what waited for it."""
        if self.first is None:
            return []
        t, i, count = self.translator, self.first, len(self.targets)
        distance, clamp, mask = (t.value(x, "b32") for x in i.operands[2:])
        mode = f"SHUFFLE_{_MODES[i.one_of(*_MODES)]}"
        code = [
            f"inside = emulator_shuffle(t, {mode}, {count}, sent, received, {distance}, {clamp}, {mask}, {i.number});"
        ]
        code += [t.set(to, "b32", f"received[{k}]") for k, (to, _) in enumerate(self.targets) if to != "_"]
        code += [f"{clean(inside)} = inside;" for _, inside in self.targets if inside not in ("", "_")]
        code += self.delayed
        t.longest_shuffle = max(t.longest_shuffle, count)
        self._clear()
        return code
