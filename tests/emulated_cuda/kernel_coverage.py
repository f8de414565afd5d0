"""Coverage of kernels: the lines and branches of their Python source that no thread of the emulated device takes.

    make kernel-coverage                              the quick set of tests; TESTS=full for all tests of cuda:0
    PYTHONPATH=tests python -m emulated_cuda.kernel_coverage MARKS [--missed FILE]     the table of a run

With EMULATED_CUDA_COVERAGE=MARKS, Warp compiles each function of `kernels/` with marks: one call at its start and one
around each condition. A call becomes the instruction `covered` of PTX. It is volatile, so NVRTC cannot remove it where
it turns a branch into a selection. MARKS is a file of 4 bytes a mark (false, true, compiled, unused). All processes map
this file, so nothing has to be merged.

A branch is one outcome of `if`, `elif`, `while`, `x if c else y`, or of `for` over a `range` (no iteration, or at least
one). Constant conditions have no branches. Loops that always run have none: `range(3)`, `range(i, i + N)`, and loops
over a chunk, `range(i, min(i + N, count))`, or window, `range(max(i - n, 0), min(i + n + 1, count))`. A line is a
statement. Functions that CUDA does not compile do not count.
"""

import argparse
import ast
import copy
import ctypes
import functools
import mmap
import re
import sys
from collections.abc import Collection, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from .loop_ranges import Loops, is_traversal

ROOT = Path(__file__).resolve().parents[2]
KERNELS = ROOT / "src" / "pointloom" / "kernels"
MARKS_OF_FILE, BYTES_OF_MARK = 256, 4
FALSE, TRUE, COMPILED = range(3)  # bytes of a mark
MARK = re.compile(r"\bcovered_(\d+)\w*\(")  # a call in Warp's CUDA source
MARKED = ast.FunctionDef | ast.If | ast.For | ast.While | ast.IfExp
DECORATORS = {"kernel", "func", "loop", "reduction", "segment_reduction", "cuda_func", "cuda_loop", "on_cuda"}

# ------------------------------------------------------------------------------------------------ numbers of marks


@functools.cache
def kernel_files() -> list[Path]:
    return sorted(path for path in KERNELS.rglob("*.py") if path.parent.name != "language")


def is_device_code(node: ast.AST, decorators: Collection[str] = DECORATORS) -> bool:
    """True if a node is a function with one of these decorators."""
    names = [ast.unparse(each) for each in node.decorator_list] if isinstance(node, ast.FunctionDef) else []
    return any(re.match(r"(\w+\.)*(\w+)", name)[2] in decorators for name in names)  # type: ignore[index]


@functools.cache
def functions_of(path: Path) -> list[ast.FunctionDef]:
    """The device functions of a file; each of their nodes that takes a mark has its number as `mark`."""
    functions = [node for node in ast.parse(path.read_text()).body if is_device_code(node)]
    marked = [node for function in functions for node in ast.walk(function) if isinstance(node, MARKED)]
    assert len(marked) <= MARKS_OF_FILE, f"{path}: more than {MARKS_OF_FILE} marks"
    for k, node in enumerate(marked, MARKS_OF_FILE * kernel_files().index(path)):
        node.mark = k  # type: ignore[union-attr]
    return functions  # type: ignore[return-value]


def _key(node: ast.AST) -> tuple[str, int, int]:
    return type(node).__name__, node.lineno, node.col_offset  # type: ignore[attr-defined]


@functools.cache
def _numbers(path: Path) -> dict[tuple[str, int, int], int]:
    nodes = [node for function in functions_of(path) for node in ast.walk(function)]
    return {_key(node): node.mark for node in nodes if hasattr(node, "mark")}  # type: ignore[attr-defined]


# ------------------------------------------------------------------------------------------------ marks in kernels


_SIGNATURES = {  # what each kind of mark takes, which outcome it notes, and what it returns
    "start": ("()", "1", ""),
    "condition": ("(c: bool) -> bool", "c", "return c;"),
    "end": ("(a: int, b: int) -> int", "a < b", "return b;"),
}


@functools.cache
def _mark(number: int, kind: str) -> Any:
    """The function of a mark: an instruction with the mark's number and the outcome, and nothing on the CPU."""
    import warp as wp

    from pointloom.kernels.language.warp_compiler import compile_source

    signature, outcome, result = _SIGNATURES[kind]
    instruction = f'asm volatile("covered {number}, %0;" :: "r"((int)({outcome})));'
    snippet = f"\n#if defined(__CUDA_ARCH__)\n{instruction}\n#endif\n{result}"
    name = f"covered_{number}"
    text = f"@wp.func_native(snippet)\ndef {name}{signature}: ..."
    return compile_source(name, text, {"wp": wp, "snippet": snippet}, __name__)


class _Marker(ast.NodeTransformer):
    def __init__(self, scope: dict[str, Any]) -> None:
        self.scope = scope
        self.names: dict[str, Any] = {}
        self.constant: set[str] = set()  # variables of loops over constants

    def call(self, number: int, kind: str, *arguments: ast.expr) -> ast.Call:
        name = f"covered_{number}"
        self.names[name] = _mark(number, kind)
        return ast.Call(ast.Name(name, ast.Load()), list(arguments), [])

    def is_constant(self, node: ast.expr) -> bool:
        """True if Warp can evaluate the value: numbers, constants of the module and variables of loops over them."""
        names = [n.id for n in ast.walk(node) if isinstance(n, ast.Name)]
        others = [n for n in ast.walk(node) if isinstance(n, ast.Call | ast.Subscript)]
        return not others and all(n in self.constant or type(self.scope.get(n)) in (int, float, bool) for n in names)

    def visit(self, node: ast.AST) -> Any:
        """A node, behind the mark of the walk's body that it begins."""
        begins = getattr(node, "begins", None)
        visited = super().visit(node)
        if begins is None:
            return visited
        return [ast.Expr(self.call(begins, "start")), *(visited if isinstance(visited, list) else [visited])]

    def visit_condition(self, node: Any) -> Any:
        self.generic_visit(node)
        if hasattr(node, "mark") and not self.is_constant(node.test):
            node.test = self.call(node.mark, "condition", node.test)
        return node

    visit_If = visit_While = visit_IfExp = visit_condition  # noqa: N815

    def visit_For(self, node: Any) -> Any:
        """`for` over a range: its mark is around the end."""
        if all(map(self.is_constant, node.iter.args)):
            before = set(self.constant)
            self.constant.add(node.target.id)
            self.generic_visit(node)
            self.constant = before
            return node
        self.generic_visit(node)
        if not hasattr(node, "mark"):
            return node
        first, last = node.iter.args if len(node.iter.args) == 2 else (ast.Constant(0), *node.iter.args)
        before = []
        if not isinstance(first, ast.Name | ast.Constant):  # to be evaluated once
            name = f"first_{node.mark}_"
            before = [ast.Assign([ast.Name(name, ast.Store())], first)]
            first = ast.Name(name, ast.Load())
        node.iter.args = [first, self.call(node.mark, "end", copy.deepcopy(first), last)]
        return [*before, node]


def _number_nodes(source: Any) -> None:
    """Give the nodes of a function of `kernels/` their numbers, which its copies keep."""
    path = Path(source.filename).resolve()
    if path not in kernel_files():
        return
    numbers = _numbers(path)
    for node in ast.walk(source.definition):
        number = numbers.get(_key(node)) if hasattr(node, "lineno") else None
        if number is not None:
            node.mark = number  # type: ignore[attr-defined]
        if is_traversal(node):
            node.body[0].begins = node.mark  # type: ignore[attr-defined]  of a walk only whether its body ran is marked


def _put_marks(source: Any, role: str, compiled: Any) -> None:
    definition: Any = copy.deepcopy(source.definition)
    scope = source.function.__globals__
    marker = _Marker(scope)
    marker.generic_visit(definition)
    if hasattr(definition, "mark"):
        start = len(definition.body) - len(source.body) + (role in ("kernel", "reduction"))  # behind `i = tid()`
        definition.body.insert(start, ast.Expr(marker.call(definition.mark, "start")))
    if not marker.names:
        return
    function = source.function
    source.function = compiled(definition, function.__annotations__, scope | marker.names, function)
    if role == "reduction":
        source.definition = definition  # of which Warp gets the text


def mark_kernels() -> None:
    """Have all functions of `kernels/` compiled with marks from now on."""
    from pointloom.kernels.language import rules, source

    of, check = source.Source.of, rules.check

    def numbered(function: Any) -> Any:
        node = of(function)
        _number_nodes(node)
        return node

    def marked(function: Any, role: str, *rest: Any, **options: Any) -> Any:
        node = check(function, role, *rest, **options)
        if role == "loop":
            first: Any = node.body[0]
            first.begins = getattr(node.definition, "mark", None)
        elif not node.is_template:
            _put_marks(node, role, source.compiled)
        return node

    source.Source.of, rules.check = staticmethod(numbered), marked  # type: ignore[assignment,method-assign]


class Marks:
    def __init__(self, path: Path) -> None:
        size = BYTES_OF_MARK * MARKS_OF_FILE * len(kernel_files())
        path.parent.mkdir(parents=True, exist_ok=True)
        with path.open("a+b") as file:
            file.truncate(size)
            self.bytes = mmap.mmap(file.fileno(), size)
        self.address = ctypes.addressof((ctypes.c_char * size).from_buffer(self.bytes))

    def note_module(self, source: Path) -> None:
        """Note the marks of a module that is loaded, by Warp's CUDA source of it."""
        for number in set(MARK.findall(source.read_text())) if source.exists() else ():
            self.bytes[BYTES_OF_MARK * int(number) + COMPILED] = 1


# ------------------------------------------------------------------------------------------------ the table


@dataclass
class FileCoverage:
    path: Path
    lines: dict[int, bool] = field(default_factory=dict)  # whether each was taken
    branches: dict[tuple[int, int, str], bool] = field(default_factory=dict)
    unused: list[str] = field(default_factory=list)  # functions that are not compiled for CUDA

    @property
    def missed_lines(self) -> list[int]:
        return sorted(line for line, taken in self.lines.items() if not taken)

    @property
    def missed_branches(self) -> list[tuple[int, int, str]]:
        return sorted(branch for branch, taken in self.branches.items() if not taken)

    def missed(self) -> Iterator[str]:
        name = self.path.relative_to(ROOT)
        yield from (f"{name}:{line}: line" for line in self.missed_lines)
        yield from (f"{name}:{line}: branch: {text}" for line, _, text in self.missed_branches)


class _Reader:
    def __init__(self, marks: bytes, coverage: FileCoverage) -> None:
        self.marks, self.coverage = marks, coverage

    def byte(self, node: Any, which: int) -> bool:
        return self.marks[BYTES_OF_MARK * node.mark + which] != 0

    def read(self, function: ast.FunctionDef) -> None:
        marked = [node for node in ast.walk(function) if hasattr(node, "mark")]
        if not any(self.byte(node, COMPILED) for node in marked):
            self.coverage.unused.append(function.name)
            return
        loops = Loops(function)
        for node in marked:
            texts = _OUTCOMES.get(type(node))
            if texts is None or not self.byte(node, COMPILED) or is_traversal(node) or loops.always_run(node):
                continue
            for which, text in zip((FALSE, TRUE), texts, strict=True):
                key = node.lineno, node.col_offset, text  # type: ignore[attr-defined]
                self.coverage.branches[key] = self.byte(node, which)
        body = function.body[1:] if ast.get_docstring(function, clean=False) else function.body
        self.statements(body, reached=any(self.byte(node, which) for node in marked for which in (FALSE, TRUE)))

    def outcomes(self, node: Any) -> tuple[bool, bool]:
        """Whether a condition was ever false, ever true; both where that is not known."""
        if not self.byte(node, COMPILED):
            return True, True
        return self.byte(node, FALSE), self.byte(node, TRUE)

    def statements(self, statements: list[ast.stmt], *, reached: bool) -> bool:
        """Note the lines; returns whether the end is reached."""
        for s in statements:
            self.coverage.lines[s.lineno] = reached or self.coverage.lines.get(s.lineno, False)
            if isinstance(s, ast.If):
                false, true = self.outcomes(s)
                ends = [self.statements(s.body, reached=reached and true)]
                ends.append(self.statements(s.orelse, reached=reached and false))
                reached = reached and any(ends)
            elif isinstance(s, ast.For | ast.While):
                self.statements(s.body, reached=reached and self.outcomes(s)[1])
            elif isinstance(s, ast.Return | ast.Break | ast.Continue):
                reached = False
        return reached


_OUTCOMES: dict[type, tuple[str, str]] = {
    ast.If: ("`if` never false", "`if` never true"),
    ast.While: ("`while` never false", "`while` never true"),
    ast.For: ("`for` never without an iteration", "`for` never with an iteration"),
    ast.IfExp: ("choice never false", "choice never true"),
}


def coverage_of(marks: bytes) -> list[FileCoverage]:
    """What the tests took of each file with device functions that CUDA runs."""
    files = []
    for path in kernel_files():
        coverage = FileCoverage(path)
        for function in functions_of(path):
            _Reader(marks, coverage).read(function)
        files += [coverage] if functions_of(path) else []
    return files


def table(coverages: list[FileCoverage]) -> list[str]:
    """A row for each file where something was missed, and the total."""
    head = f"{'file':<52}{'lines':>7}{'missed':>8}{'branches':>10}{'missed':>8}{'share':>9}"

    def row(name: str, files: list[FileCoverage]) -> str:
        lines, missed = sum(len(f.lines) for f in files), sum(len(f.missed_lines) for f in files)
        branches, untaken = sum(len(f.branches) for f in files), sum(len(f.missed_branches) for f in files)
        fraction = 1 - untaken / branches if branches else 1.0
        return f"{name:<52}{lines:>7,}{missed:>8,}{branches:>10,}{untaken:>8,}{fraction:>9.1%}"

    incomplete = [f for f in coverages if f.missed_lines or f.missed_branches]
    rows = [row(str(f.path.relative_to(ROOT)), [f]) for f in incomplete]
    note = f"{len(coverages) - len(incomplete)} files without a miss are not listed."
    kinds: dict[str, list[bool]] = {}
    for (_, _, text), taken in (branch for f in coverages for branch in f.branches.items()):
        kinds.setdefault(text.replace("never ", ""), []).append(taken)
    fractions = ", ".join(f"{kind} {sum(taken) / len(taken):.1%}" for kind, taken in sorted(kinds.items()))
    return [head, *rows, note, fractions, row(f"total of {len(coverages)} files", coverages)]


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("marks", type=Path, help="the file that EMULATED_CUDA_COVERAGE named")
    parser.add_argument("--missed", type=Path, metavar="FILE", help="write the missed lines and branches to this file")
    options = parser.parse_args()
    files = coverage_of(options.marks.read_bytes())
    if options.missed:
        options.missed.write_text("".join(f"{line}\n" for f in files for line in f.missed()))
    print("\n".join(table(files)))
    return 0


if __name__ == "__main__":
    sys.exit(main())
