"""One function of PTX: registers, operands and statements.

Registers are containers of bits in C, unsigned and as wide as PTX declares them; each instruction defines their type.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from . import arithmetic, control, conversions, memory  # noqa: F401  they fill HANDLERS
from .instructions import HANDLERS, SIZES, Instruction, UnknownPtx, c_type, clean
from .shuffles import ShuffleRun

if TYPE_CHECKING:
    from .module import Variables

_LANES = {
    "lt": "((1u << t->lane) - 1)",
    "le": "((2u << t->lane) - 1)",
    "eq": "(1u << t->lane)",
    "gt": "~((2u << t->lane) - 1)",
    "ge": "~((1u << t->lane) - 1)",
}
_INDEX_REGISTERS = ("tid", "ctaid", "ntid", "nctaid")
SPECIAL = {
    **{f"%{name}.{axis}": f"t->{name}[{k}]" for name in _INDEX_REGISTERS for k, axis in enumerate("xyz")},
    **{f"%lanemask_{name}": lanes for name, lanes in _LANES.items()},
    **{"%laneid": "t->lane", "%warpid": "(t->linear >> 5)", "%smid": "0u", "WARP_SZ": "32u"},
    **{"%clock": "0u", "%clock64": "0ull", "%globaltimer": "0ull"},
}
_TOKEN = re.compile(r"\s*(?:([$%\w]+):(?!:)|([{}])|([^;{}]*(?:\{[^;{}]*\}[^;{}]*)*);)", re.S)
_TABLE = re.compile(r"([$\w]+):\s*\.branchtargets\s+([^;]*);")
_INTEGER = re.compile(r"^-?(0[xX][0-9a-fA-F]+|\d+)U?$")
_CONTAINERS = {1: "u8", 2: "u16", 4: "u32", 8: "u64", 16: "u128"}


def split(text: str) -> list[str]:
    """Operands, parted at the commas outside brackets."""
    parts, depth, start = [], 0, 0
    for k, character in enumerate(text):
        if character in "([{":
            depth += 1
        elif character in ")]}":
            depth -= 1
        elif character == "," and depth == 0:
            parts.append(text[start:k].strip())
            start = k + 1
    return [x for x in [*parts, text[start:].strip()] if x]


def parameter(text: str) -> tuple[str, int, int]:
    """Name, size and alignment of `.param .align 8 .b8 name[56]`."""
    kinds = [t for t in re.findall(r"\.([a-z]+\d+)\b", text) if t in SIZES]
    name = re.search(r"([%$\w]+)\s*(?:\[(\d*)\])?\s*$", text.strip())
    if not kinds or not name:
        raise UnknownPtx(f"parameter {text!r}")
    aligned = re.search(r"\.align\s+(\d+)", text)  # of a .ptr it is what the pointer leads to
    size = SIZES[kinds[0]]
    return (
        name.group(1),
        size * int(name.group(2) or 1),
        int(aligned.group(1)) if aligned and ".ptr" not in text else size,
    )


@dataclass
class Function:
    """A kernel or a device function."""

    name: str
    is_kernel: bool
    parameters: list[tuple[str, int, int]]  # name, size, alignment
    returns: list[tuple[str, int, int]]
    body: str | None
    offsets: dict[str, tuple[int, int]] = field(default_factory=dict)
    parameter_bytes: int = 0
    max_threads: int = 1024
    local_bytes: int = 0
    waits: bool = False
    calls: set[str] = field(default_factory=set)
    shared: set[str] = field(default_factory=set)
    findings: set[str] = field(default_factory=set)

    def __post_init__(self) -> None:
        for name, size, align in self.parameters:
            offset = -(-self.parameter_bytes // align) * align
            self.offsets[name] = (offset, size)
            self.parameter_bytes = offset + size

    def signature(self) -> str:
        """How it is declared in C."""
        if self.is_kernel:
            return f"void {clean(self.name)}(const u8 *parameters, Thread *t)"
        out = "".join(f", u8 *{clean(name)}" for name, _, _ in self.returns)
        taken = "".join(f", const u8 *{clean(name)}" for name, _, _ in self.parameters)
        return f"static void f_{clean(self.name)}(Thread *t{out}{taken})"


class FunctionTranslator:
    """Writes one function in C."""

    def __init__(self, function: Function, functions: dict[str, Function], variables: Variables):
        self.function, self.functions, self.variables = function, functions, variables
        self.registers: dict[str, int] = {}  # name -> bytes
        self.spaces: set[str] = {name for name, _, _ in function.returns}  # names of bytes on the stack
        self.tables: dict[str, list[str]] = {}
        self.declared: list[str] = []
        self.unknown: set[str] = set()
        self.number = 0
        self.shuffles = ShuffleRun(self)
        self.longest_shuffle = 0

    def in_c(self) -> str:
        """The whole function."""
        body = self.function.body or ""
        self.tables = {name: [t.strip() for t in targets.split(",")] for name, targets in _TABLE.findall(body)}
        body = re.sub(r"(\.loc\s[^\n;]*)", "", _TABLE.sub("", body))
        code, scopes, position = [], [], 0
        while match := _TOKEN.match(body, position):
            position = match.end()
            label, bracket, statement = match.groups()
            if label:
                code += [*self.shuffles.end(), f"{clean(label)}:;"]
            elif bracket:
                if bracket == "{":
                    scopes.append(dict(self.registers))
                else:
                    self.registers = scopes.pop()
                code += [*self.shuffles.end(), bracket]
            elif statement.strip():
                self.number += 1
                code += self._statement(" ".join(statement.split()))
        if body[position:].strip():
            raise UnknownPtx(f"cannot read {body[position : position + 80]!r}")
        if self.longest_shuffle:
            self.declared.append(f"u32 sent[{self.longest_shuffle}], received[{self.longest_shuffle}]; u8 inside;")
        start = ["t->data = MODULE_DATA;", "t->data_size = MODULE_DATA_SIZE;"] if self.function.is_kernel else []
        return "\n".join([self.function.signature(), "{", *start, *self.declared, *code, "}"])

    def need(self, declaration: str) -> None:
        """Declare something at the function's start, once."""
        if declaration not in self.declared:
            self.declared.append(declaration)

    # ------------------------------------------------------------------------------------------ declarations

    def _declaration(self, text: str) -> str:
        space = text.split(None, 1)[0]
        if space == ".reg":
            return self._declare_registers(text)
        if space == ".local":
            match = re.match(r"\.local\s+(?:\.align\s+(\d+)\s+)?\.(\w+)\s+([%$\w]+)\s*\[(\d+)\]", text)
            if match:
                align, kind, name, count = match.groups()
                self._declare_bytes(name, SIZES[kind] * int(count), int(align or 16), self.declared)
                self.function.local_bytes += SIZES[kind] * int(count)
                return ""
        if space == ".shared":
            self.variables.declare(text)
            return ""
        if space == ".param":
            lines: list[str] = []
            self._declare_bytes(*parameter(text), lines)
            return lines[0]
        if space == ".pragma":
            return ""
        raise UnknownPtx(text)

    def _declare_registers(self, text: str) -> str:
        kind, names = re.match(r"\.reg\s+\.(\w+)\s+(.*)", text).groups()  # type: ignore[union-attr]
        declared = []
        for name, count in re.findall(r"([%$\w]+)(?:<(\d+)>)?\s*(?:,|$)", names):
            declared += [f"{name}{k}" for k in range(int(count))] if count else [name]
        self.registers |= dict.fromkeys(declared, SIZES[kind])
        # zero, so that a register which is read before it is set is the same in every run
        return f"{_CONTAINERS[SIZES[kind]]} " + ", ".join(f"{clean(name)} = 0" for name in declared) + ";"

    def _declare_bytes(self, name: str, size: int, align: int, lines: list[str]) -> None:
        self.spaces.add(name)
        lines.append(f"u8 {clean(name)}[{size}] __attribute__((aligned({max(align, 1)})));")

    # ------------------------------------------------------------------------------------------ operands

    def value(self, token: str, kind: str) -> str:
        """An operand as a C expression of a PTX type."""
        t = token.strip()
        if t in SPECIAL:
            return f"({c_type(kind)})({SPECIAL[t]})"
        if t in self.registers:
            if kind in ("f32", "f64"):
                return f"{kind.upper()}({clean(t)})"
            return clean(t) if kind == "pred" else f"({c_type(kind)}){clean(t)}"
        if re.match(r"^0[fF][0-9a-fA-F]{8}$", t):
            return f"F32(0x{t[2:]}u)" if kind == "f32" else f"({c_type(kind)})0x{t[2:]}u"
        if re.match(r"^0[dD][0-9a-fA-F]{16}$", t):
            return f"F64(0x{t[2:]}ull)" if kind == "f64" else f"({c_type(kind)})0x{t[2:]}ull"
        if _INTEGER.match(t):
            n = int(t.rstrip("U"), 0)
            if kind == "pred":  # `xor.pred %p1, %p0, -1` is its negation
                return str(int(n != 0))
            return f"({kind}){n}" if kind in ("f32", "f64") else f"({c_type(kind)}){n % 2**64}ull"
        if moved := re.match(r"^([$%\w]+)\+(\d+)$", t):
            return f"({self.value(moved.group(1), kind)} + {moved.group(2)})"
        return f"({c_type(kind)})({self._symbol(t)})"

    def condition(self, token: str) -> str:
        """A predicate, which may be negated, as a C expression."""
        return f"{'!' if token.startswith('!') else ''}{self.value(token.lstrip('!'), 'pred')}"

    def _symbol(self, name: str) -> str:
        function, variables = self.function, self.variables
        if name in function.offsets:
            where = f"parameters + {function.offsets[name][0]}" if function.is_kernel else clean(name)
            return f"(u64)(uintptr_t)({where})"
        if name in self.spaces:
            return f"(u64)(uintptr_t){clean(name)}"
        if name in variables.shared:
            function.shared.add(name)
            return f"{variables.shared[name][0]}ull"
        if name in variables.dynamic:
            function.shared.add(name)
            return "DYNAMIC_SHARED"
        if name in variables.data:
            return f"(u64)(uintptr_t)(MODULE_DATA + {variables.data[name]})"
        self.unknown.add(f"symbol {name}")
        return "0"

    def address(self, operand: str) -> str:
        """`[%rd1+8]` as a C expression."""
        inner = operand.strip()[1:-1].strip()
        if re.match(r"^-?\d+$", inner):
            return f"{inner}ull"
        match = re.match(r"^([$%\w]+)\s*(?:\+\s*(-?\d+))?$", inner)
        if not match:
            raise UnknownPtx(f"address {operand}")
        base, offset = match.groups()
        start = clean(base) if base in self.registers else self._symbol(base)
        return f"((u64)({start}) + (s64){offset or 0}ll)"

    def set(self, register: str, kind: str, expression: str) -> str:
        """C that puts an expression of a PTX type into a register."""
        if register == "_":
            return f"(void)({expression});"
        if register not in self.registers:
            self.unknown.add(f"destination {register}")
            return ""
        name = clean(register)
        if kind in ("f32", "f64"):
            return f"{name} = B{kind[1:]}({expression});"
        if kind == "pred":
            return f"{name} = ({expression}) != 0;"
        return f"{name} = ({_CONTAINERS[self.registers[register]]})({c_type(kind)})({expression});"

    # ------------------------------------------------------------------------------------------ statements

    def _statement(self, text: str) -> list[str]:
        if text.startswith("."):
            return [self._declaration(text)]
        guard, match = "", re.match(r"^@(!?\s*[%$\w]+)\s+(.*)$", text)
        if match:
            guard, text = match.group(1).replace(" ", ""), match.group(2)
        opcode, _, operands = text.partition(" ")
        instruction = Instruction(opcode.split("."), split(operands), text, self.number, guard)
        try:
            handler = HANDLERS.get(instruction.op)
            code = handler(self, instruction) if handler else None
        except (KeyError, IndexError, StopIteration):
            code = None
        if code is None:
            self.unknown.add(text)
            return []
        if guard:
            code = f"if ({'!' if guard.startswith('!') else ''}{clean(guard.lstrip('!'))}) {{ {code} }}"
        return self.shuffles.add(instruction, code)

    def float_value(self, i: Instruction, position: int) -> str:
        """A float operand, subnormals flushed if the instruction requires it."""
        value = self.value(i.operands[position], i.kind)
        return f"flush({value})" if "ftz" in i and i.kind == "f32" else value

    def set_float(self, i: Instruction, expression: str) -> str:
        """Put a float result into the first operand, saturated and flushed if the instruction requires it."""
        if "sat" in i:
            expression = f"saturate_{i.kind}({expression})"
        if "ftz" in i and i.kind == "f32":
            expression = f"flush({expression})"
        return self.set(i.operands[0], i.kind, expression)
