"""Taichi compiler of the kernel language for the CPU: the only module that imports Taichi.

The thread body becomes a parallel loop on the Warp arrays' buffers. Taichi 1.7 guards its kernel folder by a file
ticache.lock, which a killed process leaves behind. It loses kernels if it waits more than 0.2 s, never restores files
that the list names, and aborts if the folder is removed or a thread is refused. So processes use flock() here, and the
folder is repaired.
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
from .taichi_launches import Recorder, TaichiLaunch

try:
    import fcntl
except ImportError:  # Windows: Taichi's own lock has to suffice
    fcntl = None

LOCK_TIMEOUT = 10.0  # [s] to wait for the lock, which takes some ms. Then it continues without
STALE_AFTER = 2.0  # [s] after which a ticache.lock is stale


class TaichiUnavailableError(RuntimeError):
    """Taichi is not usable. The message gives the cause and the fix."""


def require_threads(count: int) -> None:
    """Start and end as many threads as Taichi will, which aborts if one is refused. Raises TaichiUnavailableError."""
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
    def __init__(self, path: str | None) -> None:
        self.path = Path(path) if path else None

    @contextlib.contextmanager
    def locked(self) -> Iterator[None]:
        """Lock the folder among processes and repair it."""
        if self.path is None:
            yield
            return
        with contextlib.ExitStack() as stack:
            with contextlib.suppress(OSError):  # a full disk, a file system without locks
                self.path.mkdir(parents=True, exist_ok=True)
                file = stack.enter_context((self.path / "pointloom.lock").open("w"))
                _take_lock(file.fileno(), stack)
                _remove_left_lock(self.path / "ticache.lock")
                _forget_lost_kernels(self.path)
            yield


def _take_lock(descriptor: int, stack: contextlib.ExitStack) -> None:
    last = time.monotonic() + LOCK_TIMEOUT
    while fcntl is not None and time.monotonic() < last:
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            time.sleep(0.005)
        else:
            stack.callback(fcntl.flock, descriptor, fcntl.LOCK_UN)  # closing is not enough if another thread forked
            return


def _remove_left_lock(path: Path) -> None:
    """Remove the lock file of a dead Taichi process: a live one releases it sooner."""
    with contextlib.suppress(FileNotFoundError):
        while 0 <= time.time() - path.stat().st_mtime < STALE_AFTER:
            time.sleep(0.02)
        path.unlink()


def _forget_lost_kernels(folder: Path) -> None:
    """Remove the list of kernels if one is missing, so that Taichi rewrites it."""
    listing = folder / "ticache.tcb"
    with contextlib.suppress(FileNotFoundError):
        named = set(re.findall(r"T[0-9a-f]{64}", listing.read_bytes().decode("latin-1")))
        there = {path.stem for path in folder.glob("*.tic")}
        if not named <= there:
            listing.unlink()


class OwnProgram:
    """Taichi program started by this library, not by the user."""

    def __init__(self, ti: Any, impl: Any) -> None:
        """Load the list of kernels, right after Taichi has started."""
        self._ti, self._impl = ti, impl
        self._program = weakref.ref(impl.get_runtime().prog)
        self._folder = KernelFolder(ti.cfg.offline_cache_file_path if ti.cfg.offline_cache else None)
        with self._folder.locked(), warnings.catch_warnings():
            warnings.simplefilter("ignore")  # Taichi's compiler uses features deprecated in newer Pythons
            ti.kernel(_nothing)()

    def end(self) -> None:
        """End the program while errors can be caught. Compiled kernels are saved."""
        if self._impl.get_runtime().prog is not self._program():
            return
        with self._folder.locked():
            try:
                self._ti.reset()
            except Exception:
                self.keep_for_ever()  # its destructor would try again, and abort

    def keep_for_ever(self) -> None:
        program = self._program()
        if program is not None:
            ctypes.pythonapi.Py_IncRef(ctypes.py_object(program))


def _nothing():
    pass


@contextlib.contextmanager
def same_arithmetic() -> Iterator[None]:
    """Restore the floating-point mode: ti.init flushes subnormal numbers to zero, also for NumPy."""
    try:
        libc = ctypes.CDLL(None)
        read, write = libc.fegetenv, libc.fesetenv
    except (OSError, AttributeError, TypeError):  # a platform whose C library lacks the function
        yield
        return
    mode = ctypes.create_string_buffer(64)  # fenv_t: 32 bytes on x86-64, 8 on ARM
    read(mode)
    try:
        yield
    finally:
        write(mode)


NEGATED = "negated_"  # name of the function for a minus sign
BATCH_SIZE = 512  # iterations of a parallel loop that Taichi gives to a core at once

BATCH_LOOP = f"""
for step_ in range(chunk_count_ * {BATCH_SIZE}):
    if step_ % {BATCH_SIZE} == 0:
        chunk_ = step_ // {BATCH_SIZE}
"""
# first + min(...), not min((chunk_ + 1) * size, count): that product can exceed 2^31
CHUNK_LOOP = """
for i in range(chunk_ * chunk_size_, chunk_ * chunk_size_ + min(chunk_size_, thread_count_ - chunk_ * chunk_size_)):
    pass
"""
# Two parts of one launch: blocks on all cores, then their sums. The body of an `if` runs on one core.
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
    """Rewrites what the compilers interpret differently, such as literals: Taichi folds them in float64."""

    def __init__(self, names: dict[str, Any], is_builtin: Callable, *, in_kernel: bool) -> None:
        self.names, self.is_builtin, self.in_kernel = names, is_builtin, in_kernel

    def visit_Call(self, node: ast.Call) -> ast.AST:
        """Rewrite atomics, typed literals, and built-ins of literals."""
        self.generic_visit(node)
        name = node.func.id if isinstance(node.func, ast.Name) else ""
        if name.startswith("atomic_"):
            target, *index, value = node.args
            subscript = index[0] if len(index) == 1 else ast.Tuple(index, ast.Load())
            cell = ast.Subscript(target, subscript, ast.Load())
            return ast.Call(ast.Attribute(ast.Name("ti_", ast.Load()), name, ast.Load()), [cell, value], [])
        made = self.names.get(name)
        scalar = getattr(getattr(made, "_wp_scalar_type_", made), "__name__", name)
        is_vector = hasattr(made, "_wp_scalar_type_")
        numbers = [self._number(argument) for argument in node.args]
        if not is_vector and scalar in {"float", "float32", "float64"} and isinstance(numbers[0], int):
            node.args = [ast.Constant(float(numbers[0]))]  # Taichi's float64(1) is an error
        elif is_vector and scalar == "float64":  # Taichi's vec3d(0.1) stores float32(0.1)
            node.args = [
                argument if number is None else _call("f64", ast.Constant(float(number)))
                for argument, number in zip(node.args, numbers, strict=True)
            ]
        elif (name in {"min", "max", "abs"} or self.is_builtin(made)) and any(isinstance(n, float) for n in numbers):
            if None not in numbers:
                node.args[0] = _call("f32", node.args[0])
        return node

    def visit_BinOp(self, node: ast.BinOp) -> ast.AST:
        """`%` as in C. The first of two literals gets its type."""
        self.generic_visit(node)
        if isinstance(self._number(node.left), float) and isinstance(self._number(node.right), float):
            node.left = _call("f32", node.left)
        if isinstance(node.op, ast.Mod):
            return _call("raw_mod", node.left, node.right)
        return node

    def visit_UnaryOp(self, node: ast.UnaryOp) -> ast.AST:
        """`-x` of a scalar as 0 - x, as in Warp: -0 becomes 0."""
        self.generic_visit(node)
        if isinstance(node.op, ast.USub) and self._number(node) is None:
            return ast.Call(ast.Name(NEGATED, ast.Load()), [node.operand], [])
        return node

    def visit_AugAssign(self, node: ast.AugAssign) -> ast.AST:
        self.generic_visit(node)
        if isinstance(node.op, ast.Mod):
            return ast.Assign([node.target], _call("raw_mod", _loaded(node.target), node.value))
        return node

    def visit_Return(self, node: ast.Return) -> ast.AST:
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
    loop: ast.For = ast.parse(BATCH_LOOP).body[0]  # type: ignore[assignment]
    loop.body[0].body += body  # type: ignore[attr-defined]
    return loop


def copy_tree(definition: ast.FunctionDef) -> ast.FunctionDef:
    return ast.parse(ast.unparse(definition)).body[0]  # type: ignore[return-value]


def without_docstring(definition: ast.FunctionDef) -> list[ast.stmt]:
    first = definition.body[0]
    is_doc = isinstance(first, ast.Expr) and isinstance(first.value, ast.Constant)
    return definition.body[1:] if is_doc else definition.body


def _after_fork() -> None:
    Taichi.forked = Taichi.instance is not None
    if Taichi.instance is not None and Taichi.instance.own is not None:
        Taichi.instance.own.keep_for_ever()  # its destructor would wait for threads that do not exist in the fork


if hasattr(os, "register_at_fork"):  # not on Windows
    os.register_at_fork(after_in_child=_after_fork)


@atexit.register
def _end() -> None:
    is_idle = lock.acquire(timeout=5)  # and keep it: daemon threads that come later wait here until exit
    if Taichi.instance is not None and Taichi.instance.own is not None and not Taichi.forked:
        (Taichi.instance.own.end if is_idle else Taichi.instance.own.keep_for_ever)()


CHUNKS = {"thread_count_": int, "chunk_size_": int, "chunk_count_": int}  # additional parameters of a kernel


def sum_types(vector: Any, *, segmented: bool) -> dict[str, Any]:
    sums, table = wp.array(dtype=vector), wp.array(dtype=int)
    ends = {"partials_": sums, "out_": sums}
    if segmented:
        tables = dict.fromkeys(("firsts_", "lasts_", "owners_", "starts_", "live_"), table)
        ends = {**tables, **ends, "segment_count_": int}
    else:
        ends = {"count_": int, "block_": int, **ends}
    return {**ends, "block_count_": int, "chunk_size_": int, "chunk_count_": int}


def start() -> Taichi:
    """Start Taichi on the first call, or use the program's, since ti.init would destroy its fields. Raises
    TaichiUnavailableError if the import fails or it runs on a GPU."""
    taichi = Taichi.instance
    if taichi is not None and taichi.is_running():
        return taichi
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
    instance: Taichi | None = None
    forked = False  # True if the process is a fork of one in which Taichi ran

    def __init__(self) -> None:
        os.environ.setdefault("ENABLE_TAICHI_HEADER_PRINT", "False")
        os.environ.setdefault("TI_SKIP_VERSION_CHECK", "ON")  # no thread that searches the internet for newer versions
        os.environ.setdefault("TI_ENABLE_PYBUF", "0")  # no line about "graphical shells" under a captured stdout
        try:
            # a deprecated call in Taichi 1.7.4, if the program turns warnings into errors
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
        self._serving: Callable[[], Any] = lambda: None  # the last usable program, while it exists
        self.thread_count = 1  # of a CPU launch
        self.own: OwnProgram | None = None  # not started by the user

    def is_running(self) -> bool:
        """True if the last program still runs in the process that started it."""
        program = self.program
        return program is not None and self._serving() is program and not Taichi.forked

    def prepare(self, kernel: Any, name: str, annotations: Sequence[Any], values: Sequence[Any]) -> TaichiLaunch:
        """Compile and launch a kernel with checked arguments. Return a prepared launch. Take the lock first."""
        runtime, recorder = self._impl.get_runtime(), Recorder(self.program)
        arguments = taichi_arguments(name, annotations, values)
        with self.settings(), self._plain_positions(), warnings.catch_warnings():
            warnings.simplefilter("ignore")  # Taichi's compiler uses features deprecated in newer Pythons
            runtime.prog = recorder
            try:
                kernel(*arguments)
            finally:
                runtime.prog = recorder.program
        return TaichiLaunch(name, annotations, recorder)

    @contextlib.contextmanager
    def _plain_positions(self) -> Iterator[None]:
        """Skip Taichi's formatting of source positions, half of its parsing time; rules.py reports errors earlier."""

        def plain(context: Any, node: ast.AST) -> str:
            line = node.lineno  # type: ignore[attr-defined]
            return f'File "{context.file}", line {line + context.lineno_offset}:\n{context.src[line - 1].rstrip()}\n'

        original = self._reader.get_pos_info
        self._reader.get_pos_info = plain  # type: ignore[assignment]
        try:
            yield
        finally:
            self._reader.get_pos_info = original

    @property
    def program(self) -> Any:
        """Taichi's runtime; replaced if the program restarts Taichi."""
        return self._impl.get_runtime().prog

    @contextlib.contextmanager
    def settings(self) -> Iterator[None]:
        """Settings during a launch for Warp's results, as the program's fast math and default types may differ."""
        ti, runtime = self.ti, self._impl.get_runtime()
        saved = (ti.cfg.fast_math, runtime.default_fp, runtime.default_ip, runtime.short_circuit_operators)
        wanted = (False, ti.f32, ti.i32, True)
        if saved == wanted:
            yield
            return
        try:
            self._apply(wanted)
            yield
        finally:
            self._apply(saved)

    def _apply(self, settings: tuple[bool, Any, Any, bool]) -> None:
        runtime = self._impl.get_runtime()
        self.ti.cfg.fast_math, runtime.default_fp, runtime.default_ip, runtime.short_circuit_operators = settings
        self.ti.cfg.default_fp, self.ti.cfg.default_ip = settings[1], settings[2]

    def ensure_running(self) -> None:
        ti = self.ti
        if self._impl.get_runtime().prog is None:
            threads = default_thread_count()
            options: dict[str, Any] = {"cpu_max_num_threads": threads}
            if "TI_NUM_COMPILE_THREADS" not in os.environ:
                # With 0 each Python thread compiles for itself, and the second one to do so ends the process: LLVM 15
                # reads the runtime's code with opaque pointers in one context and without in the other. Kernels have
                # one part each, so more threads would be unused.
                options["num_compile_threads"] = 1
            require_threads(1 + threads)
            if not is_writable(cache_folder() / "taichi"):  # Taichi would crash at exit, with or without a cache
                options |= {"offline_cache": False, "offline_cache_file_path": temporary_cache()}
            # "[Taichi] Starting on ..." is discarded: stdout belongs to the program
            with contextlib.redirect_stdout(io.StringIO()), same_arithmetic():
                ti.init(
                    arch=ti.cpu, log_level=ti.ERROR, default_fp=ti.f32, default_ip=ti.i32, fast_math=False, **options
                )  # fmt: skip
                self.own = OwnProgram(ti, self._impl)
        elif ti.cfg.arch not in (ti.x64, ti.arm64):
            raise TaichiUnavailableError(f"the program runs Taichi on {ti.cfg.arch.name}; start it with arch=ti.cpu")
        self._serving, self.thread_count = weakref.ref(self.program), int(ti.cfg.cpu_max_num_threads)

    def chunks(self, thread_count: int) -> tuple[int, int, int]:
        """(threads, threads per chunk, chunks): about 16 chunks per core for load balance."""
        size = max(1, thread_count // (16 * self.thread_count))
        return thread_count, size, -(-thread_count // size)

    def type_of(self, t: Any) -> Any:
        if t in self.scalars:
            return self.scalars[t]
        scalar = self.scalars[t._wp_scalar_type_]
        return (self.ti.types.vector if len(t._shape_) == 1 else self.ti.types.matrix)(*t._shape_, scalar)

    def argument(self, annotation: object) -> Any:
        if isinstance(annotation, wp.array):
            return self.ti.types.ndarray(dtype=self.type_of(annotation.dtype), ndim=annotation.ndim)
        return self.type_of(annotation)

    def scope(self, module_globals: dict[str, Any], names: set[str], is_builtin: Callable) -> dict[str, Any]:
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
        """A Taichi device function. Arrays are templates."""
        definition = copy_tree(definition)
        to_taichi = self._rewriter(function, definition, is_builtin, in_kernel=False)
        definition.body = [to_taichi.visit(s) for s in without_docstring(definition)]
        arrays = {k: self.ti.template() for k, t in function.__annotations__.items() if isinstance(t, wp.array)}
        return self.ti.func(self._compile(function, definition, arrays, is_builtin, {}))

    def make_kernel(self, function: Callable, definition: ast.FunctionDef, is_builtin: Callable) -> Any:
        """A Taichi kernel: a parallel loop over chunks, with a plain loop over each chunk. Taichi calls a function per
        parallel iteration (no vectorization) in blocks of 512, so one iteration in 512 works."""
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
        """Taichi kernel of a reduction: partial sums of blocks, then their sum, in a fixed order."""
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
        combined: ast.FunctionDef = ast.parse(source).body[0]  # type: ignore[assignment]
        combined.body = [in_parallel(combined.body[:2]), *combined.body[2:]]
        types = {k: t for k, t in function.__annotations__.items() if k != "return"}
        types |= sum_types(function.__annotations__["return"], segmented=segmented)
        extra = {"element_": element, "vector_": self.type_of(function.__annotations__["return"])}
        annotations = {k: self.argument(t) for k, t in types.items()}
        return self.ti.kernel(self._compile(function, combined, annotations, is_builtin, extra))

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
            return (x - x).sum() == 0  # a component that is not finite gives NaN
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
