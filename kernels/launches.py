"""Launches: where a kernel's arrays live, by the compiler that serves there.

CUDA launches are Warp's. On the CPU both compilers have the kernel, and the size of a launch decides:

- a large one is Taichi's, on all cores; a process waits some tenths of a second for each kernel's first launch, while
  Taichi reads its text again and compiles what it kept;
- a small one is Warp's, on one core: it loads the kernel's machine code from its cache in some milliseconds, and a
  launch costs less than handing work to other cores.

The sizes of a launch alone decide, never a time or what was launched before: the two round sines and exponentials
differently, and a program must give the same bits in each run.
"""

from __future__ import annotations

import contextlib
import contextvars
import os
import warnings
from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, Any

import warp as wp

from .array_types import Device
from .language import taichi_compiler, warp_compiler
from .language.arguments import checked_arguments, device_of
from .language.device_lock import RecordedLoop, lock, record, replay  # noqa: F401  handed on
from .language.module_loading import load_module
from .language.notices import announced
from .language.prepared_launches import TaichiLaunch, WarpLaunch
from .language.segment_launches import launch_segments
from .memory import empty, zeros

if TYPE_CHECKING:
    from .array_types import Array1, Integers
    from .lang import Kernel, Reduction

BLOCK = 1024  # elements of a CPU partial sum: many blocks per core at 100k elements, few partial sums to fold
SMALL_THREADS = 2048  # or elements of a launch that one core runs sooner than several can be told to
SMALL_ELEMENTS = 2**16  # of all its arrays, since a thread may walk over them

_compiler: contextvars.ContextVar[str | None] = contextvars.ContextVar("pointloom_cpu_compiler", default=None)
_fallback_reason: str | None = None


@contextlib.contextmanager
def cpu_compiler(name: str) -> Iterator[None]:
    """Compile CPU launches with "warp" or "taichi" inside the block; for tests and for `doctor`."""
    token = _compiler.set(name)
    try:
        yield
    finally:
        _compiler.reset(token)


def current_cpu_compiler() -> str:
    """The compiler that large CPU launches go through: "taichi", or "warp" where Taichi cannot serve.

    `POINTLOOM_CPU=warp|taichi` forces one, for small launches too; without it, a Taichi that does not work is replaced
    by Warp's serial CPU with one warning that says why and how to mend it.

    Raises:
        RuntimeError: Taichi was asked for by name and cannot serve, or POINTLOOM_CPU names neither compiler.
    """
    return _serving_compiler(_wanted_compiler())


def _wanted_compiler() -> str:
    return _compiler.get() or os.environ.get("POINTLOOM_CPU", "")


def _serving_compiler(wanted: str) -> str:
    global _fallback_reason
    if wanted not in ("", "warp", "taichi"):
        raise RuntimeError(f"POINTLOOM_CPU: expected warp or taichi, got {wanted!r}")
    if wanted == "warp" or (not wanted and _fallback_reason is not None):
        return "warp"
    try:
        taichi_compiler.start()
    except taichi_compiler.TaichiUnavailableError as error:
        if wanted == "taichi":
            raise
        _fallback_reason = str(error)
        warnings.warn(
            f"pointloom uses one CPU core: {error}. POINTLOOM_CPU=warp silences this", RuntimeWarning, stacklevel=3
        )
        return "warp"
    return "taichi"


def _is_warps(device: Device, element_count: int, values: Sequence[Any]) -> bool:
    """Whether a launch is Warp's: on CUDA all are, on the CPU those that are small, where nobody forces a compiler."""
    if device.is_cuda:
        return True
    wanted = _wanted_compiler()
    if not wanted and element_count <= SMALL_THREADS:
        if sum(value.size for value in values if isinstance(value, wp.array)) <= SMALL_ELEMENTS:
            return True
    return _serving_compiler(wanted) == "warp"


class Turn:
    """The CPU launches of a loop's first turn, kept with their arguments to be made again.

    Even a prepared launch takes longer to read its arguments than a small kernel runs.
    """

    def __init__(self) -> None:
        self.launches: list[Callable[[], None]] = []
        self.program: Any = None  # Taichi's, where launches are its

    def repeat(self) -> bool:
        """Launch the same again; False, and nothing done, where the program has started Taichi anew."""
        if self.program is not None and self.program is not taichi_compiler.start().program:
            return False
        for again in self.launches:
            again()
        return True


_turn: Turn | None = None  # the one that is being kept; whoever holds the lock may look
_launched: set[tuple[int, str]] = set()  # kernels that ran on a GPU, and on which
_on_one_core: dict[Any, WarpLaunch] = {}  # by Warp's kernel
_on_all_cores: dict[Any, TaichiLaunch] = {}  # by Taichi's kernel


def _announced(kernel: Any, name: str, place: str) -> contextlib.AbstractContextManager[bool]:
    """Announces the kernel's first launch in this process; gives whether it is that."""
    if (id(kernel), place) in _launched:
        return contextlib.nullcontext(False)
    _launched.add((id(kernel), place))
    return announced(name)


def _run_warp(kernel: Any, thread_count: int, values: Sequence[Any], device: Device, **options: Any) -> None:
    if device.is_cuda:
        with _announced(kernel, kernel.key, device.alias) as is_first:
            if is_first:
                load_module(kernel.module, device)
            wp.launch(kernel, thread_count, values, device=device, **options)
        return
    if thread_count == 0:
        return
    prepared = _on_one_core.get(kernel)
    if prepared is None:
        with announced(kernel.key):
            load_module(kernel.module, device)
            prepared = _on_one_core[kernel] = WarpLaunch(kernel, values)
    again = prepared.bound(thread_count, values)
    again()
    if _turn is not None:
        _turn.launches.append(again)


def _run_taichi(kernel: Any, name: str, annotations: Callable[[], Sequence[Any]], values: Sequence[Any]) -> None:
    taichi = taichi_compiler.start()
    prepared = _on_all_cores.get(kernel)
    if prepared is None or prepared.program() is not taichi.program:
        with announced(name):
            prepared = _on_all_cores[kernel] = taichi.prepare(kernel, name, annotations(), values)
        again = None if _turn is None else prepared.bound(values)
    elif _turn is None:
        prepared(values)
        return
    else:
        again = prepared.bound(values)
        again()
    if _turn is not None and again is not None:
        _turn.launches.append(again)
        _turn.program = taichi.program


def _run_taichi_sum(reduction: Reduction, values: Sequence[Any]) -> None:
    def annotations() -> list[Any]:
        ends = taichi_compiler.sum_types(reduction.vector, segmented=reduction.segmented)
        return [*reduction.types, *ends.values()]

    _run_taichi(reduction.taichi, reduction.name, annotations, values)


def launch(kernel: Kernel, thread_count: int, arguments: Sequence[Any], *, width: int = 1) -> None:
    """Run `thread_count` threads of a kernel where its arrays live; returns before a CUDA launch has finished.

    Safe from several Python threads at once: launches, recordings and what kernels/memory.py does take turns.

    Args:
        kernel: The kernel.
        thread_count: Threads, below 2^31.
        arguments: One per parameter: arrays as Warp arrays, contiguous, all on one device; vectors and matrices as
            Warp's or as anything that NumPy takes; whole numbers for integers; for a structure an object that has its
            fields as attributes.
        width: Elements that a thread works on side by side. A launch over many is a large one, however few threads
            it has.

    Raises:
        ValueError: Arrays on different devices or not contiguous, too many threads, an argument too many or too few,
            or a number out of its parameter's range.
        TypeError: An argument is not what its parameter says.
    """
    if kernel.twin is not kernel and device_of(arguments).is_cuda:
        kernel = kernel.twin
    values, device = checked_arguments(kernel, thread_count, arguments)
    if thread_count == 0:
        return
    with lock:  # neither Taichi nor Warp's loading of modules is thread-safe
        if _is_warps(device, thread_count * width, values):
            _run_warp(kernel.warp, thread_count, values, device)
            return
        chunks = taichi_compiler.start().chunks(thread_count)
        _run_taichi(
            kernel.taichi, kernel.name, lambda: [*kernel.types, *taichi_compiler.CHUNKS.values()], [*values, *chunks]
        )


def reduce(reduction: Reduction, count: int, arguments: Sequence[Any]) -> Array1[Any]:
    """Sum a reduction's vectors over `count` elements, in two stages of fixed order.

    Returns:
        The sum as a device array of one vector; zero where there are no elements.

    Raises:
        ValueError, TypeError: As `launch`.
    """
    values, device = checked_arguments(reduction, count, arguments)
    if count == 0:
        return zeros(1, reduction.vector, device)
    out = empty(1, reduction.vector, device)
    size = warp_compiler.REDUCTION_BLOCK if device.is_cuda else BLOCK
    blocks = -(-count // size)
    with lock:
        if device.is_cuda:
            partials = empty(blocks, reduction.vector, device)
            inputs = [*values, count, partials]
            _run_warp(reduction.warp.tiles, blocks * size, inputs, device, block_dim=size)
            _run_warp(reduction.warp.fold_tiles, size, [blocks, partials, out], device, block_dim=size)
        elif _is_warps(device, count, values):
            _run_warp(reduction.warp.sum, 1, [*values, count, BLOCK, out], device)
        else:
            partials = empty(blocks, reduction.vector, device)
            chunks = taichi_compiler.start().chunks(blocks)
            _run_taichi_sum(reduction, [*values, count, BLOCK, partials, out, *chunks])
    return out


def reduce_segments(
    reduction: Reduction, blocks: Any, live: Integers, arguments: Sequence[Any], partials: wp.array, out: wp.array
) -> None:
    """Sum a reduction's vectors over segments of its elements, each in a fixed order; allocates nothing.

    Args:
        reduction: A `@segment_reduction`.
        blocks: How the segments are cut into blocks: a `segment_blocks.SegmentBlocks`.
        live: int32 [segments]; what a segment with 0 has in `out` is not to be looked at.
        arguments: As of `launch`.
        partials: Room for one vector a block.
        out: The sums, one vector a segment.

    Raises:
        ValueError, TypeError: As `launch`.
    """
    if not reduction.segmented:
        raise TypeError(f"{reduction.name}: a @reduction, where many sums take a @segment_reduction")
    values, device = checked_arguments(reduction, blocks.element_count, arguments)
    with lock:
        if device.is_cuda:
            launch_segments(_run_warp, reduction.warp, values, blocks, live, partials, out)
        elif _is_warps(device, blocks.element_count, values):
            tables = [blocks.firsts, blocks.lasts, blocks.starts, live]
            _run_warp(reduction.warp.sum, out.size, [*values, *tables, out], device)
        else:
            chunks = taichi_compiler.start().chunks(blocks.count)
            tables = [blocks.firsts, blocks.lasts, blocks.owners, blocks.starts, live]
            _run_taichi_sum(reduction, [*values, *tables, partials, out, out.size, *chunks])


def loop_while(condition: Integers, body: Callable[[], None]) -> None:
    """Run a body of launches as long as `condition[0]` is not zero.

    On CUDA the loop is one graph with a conditional node, and nothing goes back to the host; so the body may only
    launch kernels and reductions over arrays that exist already. On the CPU the flag is read in place, and the launches
    are those of the first turn again.

    Args:
        condition: int32 device array [1], which the body's last kernel sets.
        body: Launches, the same in each turn; called once to be recorded.

    Raises:
        RuntimeError: A CUDA driver before 12.4, which has no conditional graphs.
    """
    DeviceLoop(condition, body).run()


class DeviceLoop:
    """A `loop_while` that is prepared when it first runs, and run again for a small part of that.

    On CUDA the graph is kept, on the CPU the launches of the first turn: a loop that is run anew for each scan or each
    step of something else costs its preparation once.

    Args:
        condition: As of `loop_while`.
        body: As of `loop_while`; its launches are the same in each run, over the same arrays and with the same numbers.
    """

    def __init__(self, condition: Integers, body: Callable[[], None]) -> None:
        self._condition, self._body = condition, body
        self._recorded: RecordedLoop | None = None
        self._turn: Turn | None = None

    def run(self) -> None:
        """Run the body as long as the condition is not zero.

        Raises:
            RuntimeError: A CUDA driver before 12.4, which has no conditional graphs.
        """
        if self._condition.device.is_cuda:
            with lock:
                if self._recorded is None:
                    self._recorded = RecordedLoop(self._condition, self._body)
                self._recorded.launch()
            return
        flag = self._condition.numpy()
        while flag[0]:
            with lock:
                if self._turn is None or not self._turn.repeat():
                    self._turn = _keep(self._body)


def _keep(body: Callable[[], None]) -> Turn:
    """Run a body of CPU launches, and keep them; take the lock first."""
    global _turn
    outer, _turn = _turn, Turn()
    try:
        body()
        return _turn
    finally:
        _turn = outer
