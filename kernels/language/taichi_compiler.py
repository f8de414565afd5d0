"""The half of the shared language that Taichi compiles: every CPU core. The one file that imports Taichi.

A per-thread body becomes the body of a parallel loop, whose source reaches Taichi through
linecache. Taichi works on the Warp arrays' own buffers, with no copy.

From the source of a kernel as it is written to the source that Taichi compiles; trees of Python's ast in and out.
`return` turns into `continue`, `atomic_x(a, i, v)` into `ti.atomic_x(a[i], v)`, `%` into the remainder of C, and plain
numbers get the precision that Warp gives them.

How Taichi starts and ends in a process, beside others that share its folder of compiled kernels. Taichi guards that
folder by a file, ticache.lock, which it makes, removes, and waits for 0.2 s. It reads the list of kernels when the
first one is compiled and writes it with the new ones when its program ends: left to itself after the interpreter, in a
destructor. So without what is here

- a process that is killed in its turn leaves the file behind: all that come later compile everything, in silence;
- one that waits longer compiles everything too, or loses what it compiled;
- a kernel whose file is gone while the list names it is compiled in each process, and never kept again;
- a folder that is removed while Taichi writes ends the process by abort(), as does a thread that the system refuses.

Our processes take turns by flock(), which the system takes back from one that dies. Written for Taichi 1.7.
"""

from __future__ import annotations

import ast
import atexit
import contextlib
import ctypes
import io
import linecache
import os
import re
import threading
import time
import warnings
import weakref
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

import warp as wp

from .arguments import taichi_arguments
from .cache_folders import cache_folder, is_writable, temporary_cache
from .cpu_pool import default_thread_count
from .device_lock import lock
from .prepared_launches import Recorder, TaichiLaunch

try:
    import fcntl
except ImportError:  # Windows: Taichi's own lock has to do
    fcntl = None

PATIENCE = 10.0  # [s] for a turn, which takes some ms; then it is done without
LEFT_BEHIND = 2.0  # [s] after which a ticache.lock is nobody's


class TaichiUnavailableError(RuntimeError):
    """Taichi cannot serve here; the message says why and how to mend it."""


def require_threads(count: int) -> None:
    """Start as many threads as Taichi will, and end them: it aborts where the system refuses it one.

    Raises:
        TaichiUnavailableError: The system refuses one.
    """
    end, threads = threading.Event(), list[threading.Thread]()
    try:
        for _ in range(count):
            thread = threading.Thread(target=end.wait, daemon=True)
            thread.start()
            threads.append(thread)
    except RuntimeError as error:
        raise TaichiUnavailableError(
            f"the system refuses this process {count} threads (a limit of the user's or the container's tasks); "
            "POINTLOOM_CPU_THREADS asks for fewer"
        ) from error
    finally:
        end.set()
        for thread in threads:
            thread.join()


class KernelFolder:
    """The folder of compiled kernels, or none where they are not kept."""

    def __init__(self, path: str | None) -> None:
        self.path = Path(path) if path else None

    @contextlib.contextmanager
    def turn(self) -> Iterator[None]:
        """Be the one process of ours that reads or writes the folder, and find it in order."""
        if self.path is None:
            yield
            return
        with contextlib.ExitStack() as held:
            with contextlib.suppress(OSError):  # a full disk, a file system without locks
                self.path.mkdir(parents=True, exist_ok=True)
                file = held.enter_context((self.path / "pointloom.lock").open("w"))
                _take_lock(file.fileno(), held)
                _remove_left_lock(self.path / "ticache.lock")
                _forget_lost_kernels(self.path)
            yield


def _take_lock(descriptor: int, held: contextlib.ExitStack) -> None:
    """Lock a file until the stack ends, or the process."""
    last = time.monotonic() + PATIENCE
    while fcntl is not None and time.monotonic() < last:
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            time.sleep(0.005)
        else:
            held.callback(fcntl.flock, descriptor, fcntl.LOCK_UN)  # closing is not enough where another thread forked
            return


def _remove_left_lock(path: Path) -> None:
    """Remove Taichi's lock if its process is dead: it is none of ours, and no program holds it as long."""
    with contextlib.suppress(FileNotFoundError):
        while 0 <= time.time() - path.stat().st_mtime < LEFT_BEHIND:
            time.sleep(0.02)
        path.unlink()


def _forget_lost_kernels(folder: Path) -> None:
    """Remove the list of kernels if one of them is not there, for Taichi to write a new one."""
    listing = folder / "ticache.tcb"
    with contextlib.suppress(FileNotFoundError):
        named = set(re.findall(r"T[0-9a-f]{64}", listing.read_bytes().decode("latin-1")))
        there = {path.stem for path in folder.glob("*.tic")}
        if not named <= there:
            listing.unlink()


class OwnProgram:
    """Taichi's program that this process started by itself, and not its user."""

    def __init__(self, ti: Any, impl: Any) -> None:
        """Call it when Taichi has just started: has it read the list of kernels, which it does for the first kernel."""
        self._ti, self._impl = ti, impl
        self._program = weakref.ref(impl.get_runtime().prog)
        self._folder = KernelFolder(ti.cfg.offline_cache_file_path if ti.cfg.offline_cache else None)
        with self._folder.turn(), warnings.catch_warnings():
            warnings.simplefilter("ignore")  # Taichi's compiler uses what newer Pythons deprecate
            ti.kernel(_nothing)()

    def end(self) -> None:
        """End it while an error in that is an exception still; what it compiled is kept in the folder."""
        if self._impl.get_runtime().prog is not self._program():
            return
        with self._folder.turn():
            try:
                self._ti.reset()
            except Exception:
                self.keep_for_ever()  # its destructor would try again, and abort

    def keep_for_ever(self) -> None:
        """Never destroy it."""
        program = self._program()
        if program is not None:
            ctypes.pythonapi.Py_IncRef(ctypes.py_object(program))


def _nothing():
    pass


@contextlib.contextmanager
def same_arithmetic() -> Iterator[None]:
    """Give this thread its floating-point mode back: ti.init makes it flush subnormal numbers to zero, NumPy's too."""
    try:
        libc = ctypes.CDLL(None)
        read, write = libc.fegetenv, libc.fesetenv
    except (OSError, AttributeError, TypeError):  # a platform whose C library has no such function
        yield
        return
    mode = ctypes.create_string_buffer(64)  # fenv_t: 32 bytes on x86-64, 8 on ARM
    read(mode)
    try:
        yield
    finally:
        write(mode)


NEGATED = "negated_"  # the name of what stands for a minus sign
TURNS = 512  # turns of a parallel loop that Taichi gives to a core at once

TURNS_LOOP = f"""
for turn_ in range(chunk_count_ * {TURNS}):
    if turn_ % {TURNS} == 0:
        chunk_ = turn_ // {TURNS}
"""
# first + min(...), not min((chunk_ + 1) * size, count): that product can pass 2^31
CHUNK_LOOP = """
for i in range(chunk_ * chunk_size_, chunk_ * chunk_size_ + min(chunk_size_, thread_count_ - chunk_ * chunk_size_)):
    pass
"""
# Two parts of one launch: blocks on all cores, then their sums; what stands within an `if` is on one core.
REDUCTION = """
def {name}_sum({arguments}count_, block_, partials_, out_, block_count_, chunk_size_, chunk_count_):
    first_ = chunk_ * chunk_size_
    for b_ in range(first_, first_ + min(chunk_size_, block_count_ - first_)):
        total_ = vector_(0)
        for i_ in range(b_ * block_, b_ * block_ + min(block_, count_ - b_ * block_)):
            total_ += element_({arguments}i_)
        partials_[b_] = total_
    if block_count_ > 0:
        sum_ = vector_(0)
        for k_ in range(block_count_):
            sum_ += partials_[k_]
        out_[0] = sum_
"""
SEGMENT_REDUCTION = """
def {name}_sum({arguments}firsts_, lasts_, owners_, starts_, live_, partials_, out_, segment_count_,
               block_count_, chunk_size_, chunk_count_):
    first_ = chunk_ * chunk_size_
    for b_ in range(first_, first_ + min(chunk_size_, block_count_ - first_)):
        if live_[owners_[b_]] != 0:
            total_ = vector_(0)
            for i_ in range(firsts_[b_], lasts_[b_]):
                total_ += element_({arguments}i_)
            partials_[b_] = total_
    for s_ in range(segment_count_):
        if live_[s_] != 0:
            sum_ = vector_(0)
            for k_ in range(starts_[s_], starts_[s_ + 1]):
                sum_ += partials_[k_]
            out_[s_] = sum_
"""


class ToTaichi(ast.NodeTransformer):
    """Rewrites what the two compilers spell or read differently.

    Taichi folds expressions of plain numbers in Python, in float64; Warp computes them in the type that they have in
    the kernel. So the first number of such an expression is given its type.
    """

    def __init__(self, names: dict[str, Any], is_builtin: Callable, *, in_kernel: bool) -> None:
        self.names, self.is_builtin, self.in_kernel = names, is_builtin, in_kernel

    def visit_Call(self, node: ast.Call) -> ast.AST:
        """Atomics, numbers that take their type from a constructor, built-ins of plain numbers."""
        self.generic_visit(node)
        name = node.func.id if isinstance(node.func, ast.Name) else ""
        if name.startswith("atomic_"):
            target, *index, value = node.args
            place = index[0] if len(index) == 1 else ast.Tuple(index, ast.Load())
            cell = ast.Subscript(target, place, ast.Load())
            return ast.Call(ast.Attribute(ast.Name("ti_", ast.Load()), name, ast.Load()), [cell, value], [])
        made = self.names.get(name)
        scalar = getattr(getattr(made, "_wp_scalar_type_", made), "__name__", name)
        is_vector = hasattr(made, "_wp_scalar_type_")
        numbers = [self._number(argument) for argument in node.args]
        if not is_vector and scalar in {"float", "float32", "float64"} and isinstance(numbers[0], int):
            node.args = [ast.Constant(float(numbers[0]))]  # Taichi's float64(1) is an error
        elif is_vector and scalar == "float64":  # Taichi's vec3d(0.1) holds float32(0.1)
            node.args = [
                argument if number is None else _call("f64", ast.Constant(float(number)))
                for argument, number in zip(node.args, numbers, strict=True)
            ]
        elif (name in {"min", "max", "abs"} or self.is_builtin(made)) and any(isinstance(n, float) for n in numbers):
            if None not in numbers:
                node.args[0] = _call("f32", node.args[0])
        return node

    def visit_BinOp(self, node: ast.BinOp) -> ast.AST:
        """`%` as in C; the first of two plain numbers gets its type."""
        self.generic_visit(node)
        if isinstance(self._number(node.left), float) and isinstance(self._number(node.right), float):
            node.left = _call("f32", node.left)
        if isinstance(node.op, ast.Mod):
            return _call("raw_mod", node.left, node.right)
        return node

    def visit_UnaryOp(self, node: ast.UnaryOp) -> ast.AST:
        """`-x` as Warp has it: of a scalar 0 - x, so that of zero it is zero, and not minus zero."""
        self.generic_visit(node)
        if isinstance(node.op, ast.USub) and self._number(node) is None:
            return ast.Call(ast.Name(NEGATED, ast.Load()), [node.operand], [])
        return node

    def visit_AugAssign(self, node: ast.AugAssign) -> ast.AST:
        """`a %= b` as `a = a % b`."""
        self.generic_visit(node)
        if isinstance(node.op, ast.Mod):
            return ast.Assign([node.target], _call("raw_mod", _loaded(node.target), node.value))
        return node

    def visit_Return(self, node: ast.Return) -> ast.AST:
        """The end of a thread is the end of a turn of the loop."""
        self.generic_visit(node)
        return ast.Continue() if self.in_kernel else node

    def _number(self, node: ast.expr) -> int | float | None:
        match node:
            case ast.Constant(value=int() | float() as value) if not isinstance(value, bool):
                return value
            case ast.Name(id=name) if type(self.names.get(name)) in (int, float):
                return self.names[name]
            case ast.UnaryOp(op=ast.USub(), operand=operand):
                value = self._number(operand)
                return None if value is None else -value
        return None


def _call(name: str, *arguments: ast.expr) -> ast.Call:
    return ast.Call(ast.Attribute(ast.Name("ti_", ast.Load()), name, ast.Load()), list(arguments), [])


def _loaded(target: ast.expr) -> ast.expr:
    return ast.parse(ast.unparse(target), mode="eval").body


def in_parallel(body: list[ast.stmt]) -> ast.For:
    """A parallel loop over chunks around a body that works on `chunk_`."""
    loop: ast.For = ast.parse(TURNS_LOOP).body[0]  # type: ignore[assignment]
    loop.body[0].body += body  # type: ignore[attr-defined]
    return loop


def copy_tree(definition: ast.FunctionDef) -> ast.FunctionDef:
    """A copy that may be changed."""
    return ast.parse(ast.unparse(definition)).body[0]  # type: ignore[return-value]


def without_docstring(definition: ast.FunctionDef) -> list[ast.stmt]:
    """The statements of a function."""
    first = definition.body[0]
    is_doc = isinstance(first, ast.Expr) and isinstance(first.value, ast.Constant)
    return definition.body[1:] if is_doc else definition.body


def _after_fork() -> None:
    Taichi.forked = Taichi.instance is not None
    if Taichi.instance is not None and Taichi.instance.own is not None:
        Taichi.instance.own.keep_for_ever()  # its destructor would wait for threads that did not come along


if hasattr(os, "register_at_fork"):  # not on Windows
    os.register_at_fork(after_in_child=_after_fork)


@atexit.register
def _end() -> None:
    is_idle = lock.acquire(timeout=5)  # and keep it: daemon threads that come later wait here for the end
    if Taichi.instance is not None and Taichi.instance.own is not None and not Taichi.forked:
        (Taichi.instance.own.end if is_idle else Taichi.instance.own.keep_for_ever)()


CHUNKS = {"thread_count_": int, "chunk_size_": int, "chunk_count_": int}  # what a kernel takes after its own


def sum_types(vector: Any, *, segmented: bool) -> dict[str, Any]:
    """What the kernel of a reduction takes after the reduction's own parameters."""
    sums, table = wp.array(dtype=vector), wp.array(dtype=int)
    ends = {"partials_": sums, "out_": sums}
    if segmented:
        tables = dict.fromkeys(("firsts_", "lasts_", "owners_", "starts_", "live_"), table)
        ends = {**tables, **ends, "segment_count_": int}
    else:
        ends = {"count_": int, "block_": int, **ends}
    return {**ends, "block_count_": int, "chunk_size_": int, "chunk_count_": int}


def start() -> Taichi:
    """The running Taichi, started at the first call.

    A Taichi that the user's program started before is used as it stands when it runs on the CPU; nobody's fields are
    ever destroyed by a second `ti.init`.

    Raises:
        TaichiUnavailableError: Taichi does not import, or the user's program runs it on a GPU.
    """
    found = Taichi.instance
    if found is not None and found.is_running():
        return found
    with lock:
        if Taichi.forked:
            raise TaichiUnavailableError(
                "this process was forked from one that uses Taichi, whose threads do not come along; "
                "start workers with multiprocessing.get_context('spawn')"
            )
        if Taichi.instance is None:
            Taichi.instance = Taichi()
        Taichi.instance.ensure_running()
        return Taichi.instance


class Taichi:
    """Taichi's side of the vocabulary and types."""

    instance: Taichi | None = None
    forked = False  # whether the process is a fork of one where Taichi ran

    def __init__(self) -> None:
        os.environ.setdefault("ENABLE_TAICHI_HEADER_PRINT", "False")
        os.environ.setdefault("TI_SKIP_VERSION_CHECK", "ON")  # no thread that asks the internet for newer versions
        os.environ.setdefault("TI_ENABLE_PYBUF", "0")  # no line about "graphical shells" under a captured stdout
        try:
            # a deprecated call in Taichi 1.7.4, where the program makes warnings errors
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", DeprecationWarning)
                import taichi as ti
                from taichi.lang import impl
                from taichi.lang.ast.ast_transformer_utils import ASTTransformerContext
        except ImportError as error:
            remedies = {"libX11": "apt-get install libx11-6", "'taichi'": "pip install taichi"}
            fitting = [remedy for sign, remedy in remedies.items() if sign in str(error)]
            remedy = (*fitting, "reinstall it: pip install --force-reinstall taichi")[0]
            raise TaichiUnavailableError(f"Taichi does not import ({error}); {remedy}") from error
        self.ti, self._impl, self._reader = ti, impl, ASTTransformerContext
        self.scalars = {
            int: ti.i32, float: ti.f32, bool: ti.i32, wp.int32: ti.i32, wp.int64: ti.i64, wp.float32: ti.f32,
            wp.float64: ti.f64, wp.uint8: ti.u8, wp.uint16: ti.u16, wp.uint32: ti.u32, wp.uint64: ti.u64,
            wp.int8: ti.i8, wp.int16: ti.i16,
        }  # fmt: skip
        self.builtins = _builtins(ti)
        self._serving: Callable[[], Any] = lambda: None  # the program that was last found to serve, while it lives
        self.thread_count = 1  # of a CPU launch
        self.own: OwnProgram | None = None  # not the user's

    def is_running(self) -> bool:
        """Whether the program that was last found to serve still runs, in the process that started it."""
        program = self.program
        return program is not None and self._serving() is program and not Taichi.forked

    def prepare(self, kernel: Any, name: str, annotations: Sequence[Any], values: Sequence[Any]) -> TaichiLaunch:
        """Compile a kernel and launch it; what launches it again. Take the lock first.

        Args:
            kernel: Taichi's.
            name: As errors name it.
            annotations: The types of its parameters, Warp's.
            values: Checked arguments.
        """
        runtime, recorder = self._impl.get_runtime(), Recorder(self.program)
        arguments = taichi_arguments(name, annotations, values)
        with self.settings(), self._plain_positions(), warnings.catch_warnings():
            warnings.simplefilter("ignore")  # Taichi's compiler uses what newer Pythons deprecate
            runtime.prog = recorder
            try:
                kernel(*arguments)
            finally:
                runtime.prog = recorder.program
        return TaichiLaunch(name, annotations, recorder)

    @contextlib.contextmanager
    def _plain_positions(self) -> Iterator[None]:
        """Give positions as file and line, while Taichi reads a kernel.

        It wraps and underlines the source of every node in case that an error should name it, for half of the time that
        it reads. Errors are found before, by rules.py.
        """

        def plain(context: Any, node: ast.AST) -> str:
            line = node.lineno  # type: ignore[attr-defined]
            return f'File "{context.file}", line {line + context.lineno_offset}:\n{context.src[line - 1].rstrip()}\n'

        held = self._reader.get_pos_info
        self._reader.get_pos_info = plain  # type: ignore[assignment]
        try:
            yield
        finally:
            self._reader.get_pos_info = held

    @property
    def program(self) -> Any:
        """Taichi's runtime; another one where the program has started Taichi anew."""
        return self._impl.get_runtime().prog

    @contextlib.contextmanager
    def settings(self) -> Iterator[None]:
        """The settings that give Warp's results, held for a launch and then given back.

        They matter where the program started Taichi itself: its fast arithmetic would take NaN for a number, and
        float64 as the default type would turn our literals into float64.
        """
        ti, runtime = self.ti, self._impl.get_runtime()
        held = (ti.cfg.fast_math, runtime.default_fp, runtime.default_ip, runtime.short_circuit_operators)
        wanted = (False, ti.f32, ti.i32, True)
        if held == wanted:
            yield
            return
        try:
            self._apply(wanted)
            yield
        finally:
            self._apply(held)

    def _apply(self, settings: tuple[bool, Any, Any, bool]) -> None:
        runtime = self._impl.get_runtime()
        self.ti.cfg.fast_math, runtime.default_fp, runtime.default_ip, runtime.short_circuit_operators = settings
        self.ti.cfg.default_fp, self.ti.cfg.default_ip = settings[1], settings[2]

    def ensure_running(self) -> None:
        """Start the runtime, unless one runs that serves."""
        ti = self.ti
        if self._impl.get_runtime().prog is None:
            threads = default_thread_count()
            options: dict[str, Any] = {"cpu_max_num_threads": threads}
            if "TI_NUM_COMPILE_THREADS" not in os.environ:
                # With 0 each Python thread compiles for itself, and the second one to do so ends the process: LLVM 15
                # reads the runtime's code with opaque pointers in one context and without in the other. Our kernels
                # have one part each, so that more threads would only be started.
                options["num_compile_threads"] = 1
            require_threads(1 + threads)
            if not is_writable(
                cache_folder() / "taichi"
            ):  # Taichi would crash at exit, whether it keeps kernels or not
                options |= {"offline_cache": False, "offline_cache_file_path": temporary_cache()}
            # "[Taichi] Starting on ..." goes nowhere: stdout is the program's
            with contextlib.redirect_stdout(io.StringIO()), same_arithmetic():
                ti.init(
                    arch=ti.cpu, log_level=ti.ERROR, default_fp=ti.f32, default_ip=ti.i32, fast_math=False, **options
                )  # fmt: skip
                self.own = OwnProgram(ti, self._impl)
        elif ti.cfg.arch not in (ti.x64, ti.arm64):
            raise TaichiUnavailableError(f"the program runs Taichi on {ti.cfg.arch.name}; start it with arch=ti.cpu")
        self._serving, self.thread_count = weakref.ref(self.program), int(ti.cfg.cpu_max_num_threads)

    def chunks(self, thread_count: int) -> tuple[int, int, int]:
        """(threads, threads a chunk, chunks) of a launch: some 16 chunks a core, so that uneven work evens out."""
        size = max(1, thread_count // (16 * self.thread_count))
        return thread_count, size, -(-thread_count // size)

    def type_of(self, t: Any) -> Any:
        """Taichi's type for one of Warp's."""
        if t in self.scalars:
            return self.scalars[t]
        scalar = self.scalars[t._wp_scalar_type_]
        return (self.ti.types.vector if len(t._shape_) == 1 else self.ti.types.matrix)(*t._shape_, scalar)

    def argument(self, annotation: Any) -> Any:
        """The annotation of a Taichi kernel's parameter."""
        if isinstance(annotation, wp.array):
            return self.ti.types.ndarray(dtype=self.type_of(annotation.dtype), ndim=annotation.ndim)
        return self.type_of(annotation)

    def scope(self, module_globals: dict[str, Any], names: set[str], is_builtin: Callable) -> dict[str, Any]:
        """The names that a function uses, as Taichi must see them."""
        scope: dict[str, Any] = {}
        for name in names:
            if name not in module_globals:
                continue
            value = module_globals[name]
            if is_builtin(value):
                scope[name] = self.builtins.get(value.name)
            elif hasattr(value, "taichi"):
                scope[name] = value.taichi
            elif isinstance(value, type) and (value in self.scalars or hasattr(value, "_wp_scalar_type_")):
                scope[name] = self.type_of(value)
            else:
                scope[name] = value
        return scope | {"ti_": self.ti, NEGATED: self.builtins[NEGATED]}

    def make_func(self, function: Callable, definition: ast.FunctionDef, is_builtin: Callable) -> Any:
        """A Taichi device function; arrays come in as templates."""
        definition = copy_tree(definition)
        to_taichi = self._rewriter(function, definition, is_builtin, in_kernel=False)
        definition.body = [to_taichi.visit(s) for s in without_docstring(definition)]
        arrays = {k: self.ti.template() for k, t in function.__annotations__.items() if isinstance(t, wp.array)}
        return self.ti.func(self._compile(function, definition, arrays, is_builtin, {}))

    def make_kernel(self, function: Callable, definition: ast.FunctionDef, is_builtin: Callable) -> Any:
        """A Taichi kernel: parallel chunks of threads, the per-thread body in a plain loop over each chunk.

        The chunks are ours, since Taichi calls a function for each turn of its parallel loop (no vectorisation, no
        hoisting) and hands its turns to cores in blocks of 512 whatever its settings say: so one turn in 512 works.
        """
        definition = copy_tree(definition)
        body = without_docstring(definition)
        inner: ast.For = ast.parse(CHUNK_LOOP).body[0]  # type: ignore[assignment]
        inner.target = body[0].targets[0]  # type: ignore[attr-defined]
        to_taichi = self._rewriter(function, definition, is_builtin, in_kernel=True)
        inner.body = [to_taichi.visit(s) for s in body[1:]] or [ast.Pass()]
        definition.body = [in_parallel([inner])]
        definition.args.args += [ast.arg("thread_count_"), ast.arg("chunk_size_"), ast.arg("chunk_count_")]
        types = {k: self.argument(t) for k, t in function.__annotations__.items() if k != "return"}
        types |= dict.fromkeys(CHUNKS, self.ti.i32)
        return self.ti.kernel(self._compile(function, definition, types, is_builtin, {}))

    def make_reduction(
        self, function: Callable, definition: ast.FunctionDef, is_builtin: Callable, *, segmented: bool
    ) -> Any:
        """The Taichi kernel of a reduction: partial sums of blocks, then their sums, both in a fixed order."""
        element_definition = copy_tree(definition)
        body = without_docstring(element_definition)
        index = body[0].targets[0].id  # type: ignore[attr-defined]
        element_definition.name = f"{definition.name}_element"
        element_definition.args.args.append(ast.arg(index))
        to_taichi = self._rewriter(function, definition, is_builtin, in_kernel=False)
        element_definition.body = [to_taichi.visit(s) for s in body[1:]]
        arrays = {k: self.ti.template() for k, t in function.__annotations__.items() if isinstance(t, wp.array)}
        element = self.ti.func(self._compile(function, element_definition, arrays, is_builtin, {}))
        arguments = [a.arg for a in definition.args.args]
        source = (SEGMENT_REDUCTION if segmented else REDUCTION).format(
            name=definition.name, arguments="".join(f"{a}, " for a in arguments)
        )
        whole: ast.FunctionDef = ast.parse(source).body[0]  # type: ignore[assignment]
        whole.body = [in_parallel(whole.body[:2]), *whole.body[2:]]
        types = {k: t for k, t in function.__annotations__.items() if k != "return"}
        types |= sum_types(function.__annotations__["return"], segmented=segmented)
        extra = {"element_": element, "vector_": self.type_of(function.__annotations__["return"])}
        annotations = {k: self.argument(t) for k, t in types.items()}
        return self.ti.kernel(self._compile(function, whole, annotations, is_builtin, extra))

    def _rewriter(
        self, function: Callable, definition: ast.FunctionDef, is_builtin: Callable, *, in_kernel: bool
    ) -> ToTaichi:
        local = {a.arg for a in definition.args.args}
        local |= {n.id for n in ast.walk(definition) if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Store)}
        names = {k: v for k, v in function.__globals__.items() if k not in local}
        return ToTaichi(names, is_builtin, in_kernel=in_kernel)

    def _compile(
        self, function: Callable, definition: ast.FunctionDef, annotations: dict, is_builtin: Callable, extra: dict
    ) -> Callable:
        definition.decorator_list, definition.returns = [], None
        for argument in definition.args.args:
            argument.annotation = None
        source = ast.unparse(ast.fix_missing_locations(ast.Module([definition], [])))
        name = f"<taichi {function.__module__}.{definition.name}>"
        linecache.cache[name] = (len(source), None, source.splitlines(True), name)
        names = {n.id for n in ast.walk(definition) if isinstance(n, ast.Name)}
        scope = self.scope(function.__globals__, names, is_builtin) | extra
        exec(compile(source, name, "exec"), scope)
        twin = scope[definition.name]
        twin.__annotations__ = annotations
        twin.__module__ = function.__module__
        return twin


def _builtins(ti: Any) -> dict[str, Any]:
    def dot(a, b):
        return a.dot(b)

    def cross(a, b):
        return a.cross(b)

    def outer(a, b):
        return a.outer_product(b)

    def transpose(a):
        return a.transpose()

    def length(a):
        return a.norm()

    def normalize(a):
        size = a.norm()
        unit = ti.zero(a)
        if size > 0:
            unit = a / size
        return unit

    def float_bits(x):
        return ti.bit_cast(x, ti.i32)

    def bits_float(i):
        return ti.bit_cast(i, ti.f32)

    def bit_count(x):
        return ti.math.popcnt(x)

    own = (*_by_kind(ti), dot, cross, outer, transpose, length, normalize, float_bits, bits_float, bit_count)
    named = {f.__name__: ti.func(f) for f in own}
    same = "floor ceil sqrt sin cos tan acos asin atan2 exp log pow".split()
    return named | {name: getattr(ti, name) for name in same}


def _by_kind(ti: Any) -> list[Callable]:
    def isfinite(x):
        if ti.static(is_vector(x)):
            return (x - x).sum() == 0  # a component that is not finite leaves NaN
        else:
            return (x - x) == 0

    def negated_(x):
        if ti.static(is_vector(x)):
            return -x
        else:
            return 0 - x

    def is_vector(x):
        return isinstance(x, ti.Matrix) or x.is_tensor()

    return [isfinite, negated_]
