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

from .language import taichi_compiler, warp_compiler
from .language.arguments import checked_arguments, taichi_arguments
from .language.device_lock import lock, run_while
from .language.notices import announced
from .language.segment_launches import launch_segments
from .memory import empty, zeros

if TYPE_CHECKING:
    from .lang import Kernel, Reduction

BLOCK = 1024  # elements of a CPU partial sum: many blocks per core at 100k elements, few partial sums to fold
SMALL_THREADS = 2048  # of a launch that one core runs sooner than several can be told to
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
    global _fallback_reason
    wanted = _compiler.get() or os.environ.get("POINTLOOM_CPU", "")
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
            f"pointloom uses one CPU core: {error}. POINTLOOM_CPU=warp silences this", RuntimeWarning, stacklevel=2
        )
        return "warp"
    return "taichi"


def _is_small(thread_count: int, values: Sequence[Any]) -> bool:
    """Whether a CPU launch is Warp's by its size, where nobody forces a compiler."""
    if thread_count > SMALL_THREADS or _compiler.get() or os.environ.get("POINTLOOM_CPU"):
        return False
    return sum(value.size for value in values if isinstance(value, wp.array)) <= SMALL_ELEMENTS


def _is_warps(device: Any, thread_count: int, values: Sequence[Any]) -> bool:
    return device.is_cuda or _is_small(thread_count, values) or current_cpu_compiler() == "warp"


class Turn:
    """The CPU launches of a loop's first turn, kept with their arguments to be made again.

    Both compilers read the arguments of a launch in Python, which takes longer than a small kernel runs. The arrays
    must outlive it.
    """

    def __init__(self):
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
_launched: set[tuple[int, str]] = set()  # compiled kernels that ran, and where


def _announced(kernel: Any, name: str, place: str) -> contextlib.AbstractContextManager[None]:
    """Announces the kernel's first launch in this process."""
    if (id(kernel), place) in _launched:
        return contextlib.nullcontext()
    _launched.add((id(kernel), place))
    return announced(name)


def _run_warp(kernel: Any, thread_count: int, values: Sequence[Any], device: Any, **options: Any) -> None:
    with _announced(kernel, kernel.key, device.alias):
        _launch_or_keep(kernel, thread_count, values, device, options)


def _launch_or_keep(kernel: Any, thread_count: int, values: Sequence[Any], device: Any, options: dict) -> None:
    if _turn is None or device.is_cuda:
        wp.launch(kernel, thread_count, values, device=device, **options)
        return
    command = wp.launch(kernel, thread_count, values, device=device, record_cmd=True, **options)
    if command is not None:  # nothing is launched for no threads
        command.launch()
        _turn.launches.append(command.launch)


def _run_taichi(kernel: Any, *arguments: Any) -> None:
    taichi = taichi_compiler.start()
    with _announced(kernel, kernel.__name__, "taichi"):
        if _turn is None:
            taichi.run(kernel, *arguments)
            return
        _turn.launches += taichi.record(kernel, *arguments)
        _turn.program = taichi.program


def launch(kernel: Kernel, thread_count: int, arguments: Sequence[Any]) -> None:
    """Run `thread_count` threads of a kernel where its arrays live; returns before a CUDA launch has finished.

    Safe from several Python threads at once: launches, recordings and what kernels/memory.py does take turns.

    Args:
        kernel: The kernel.
        thread_count: Threads, below 2^31.
        arguments: One per parameter: arrays as Warp arrays, contiguous, all on one device; vectors and matrices as
            Warp's or as anything that NumPy takes; whole numbers for integers; for a structure an object that has its
            fields as attributes.

    Raises:
        ValueError: Arrays on different devices or not contiguous, too many threads, an argument too many or too few,
            or a number out of its parameter's range.
        TypeError: An argument is not what its parameter says.
    """
    values, device = checked_arguments(kernel, thread_count, arguments)
    if thread_count == 0:
        return
    with lock:  # neither Taichi nor Warp's loading of modules is thread-safe
        if _is_warps(device, thread_count, values):
            _run_warp(kernel.warp, thread_count, values, device)
            return
        chunks = taichi_compiler.start().chunks(thread_count)
        _run_taichi(kernel.taichi, *taichi_arguments(kernel, values), *chunks)


def reduce(reduction: Reduction, count: int, arguments: Sequence[Any]) -> wp.array:
    """Sum a reduction's vectors over `count` elements, in two stages of fixed order.

    Returns:
        The sum as a device array of one vector; zero where there are no elements.

    Raises:
        ValueError, TypeError: As `launch`.
    """
    values, device = checked_arguments(reduction, count, arguments)
    out = zeros(1, reduction.vector, device)
    if count == 0:
        return out
    size = warp_compiler.REDUCTION_BLOCK if device.is_cuda else BLOCK
    blocks = -(-count // size)
    partials = empty(blocks, reduction.vector, device)
    with lock:
        if device.is_cuda:
            inputs = [*values, count, partials]
            _run_warp(reduction.warp.tiles, blocks * size, inputs, device, block_dim=size)
            _run_warp(reduction.warp.fold_tiles, size, [blocks, partials, out], device, block_dim=size)
        elif _is_warps(device, count, values):
            _run_warp(reduction.warp.blocks, blocks, [*values, count, partials, BLOCK], device)
            _run_warp(reduction.warp.fold, 1, [blocks, partials, out], device)
        else:
            run_blocks, run_fold = reduction.taichi
            sums, chunks = partials.numpy(), taichi_compiler.start().chunks(blocks)
            _run_taichi(run_blocks, *taichi_arguments(reduction, values), count, sums, BLOCK, *chunks)
            _run_taichi(run_fold, blocks, sums, out.numpy())
    return out


def reduce_segments(
    reduction: Reduction, blocks: Any, live: wp.array, arguments: Sequence[Any], partials: wp.array, out: wp.array
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
    tables = [blocks.firsts, blocks.lasts, blocks.owners, live]
    ends = [blocks.starts, live, partials, out]
    with lock:
        if device.is_cuda:
            launch_segments(_run_warp, reduction.warp, values, blocks, live, partials, out)
        elif _is_warps(device, blocks.element_count, values):
            _run_warp(reduction.warp.blocks, blocks.count, [*values, *tables, partials], device)
            _run_warp(reduction.warp.fold, out.size, ends, device)
        else:
            run_blocks, run_fold = reduction.taichi
            inputs = [*taichi_arguments(reduction, values), *(t.numpy() for t in (*tables, partials))]
            _run_taichi(run_blocks, *inputs, *taichi_compiler.start().chunks(blocks.count))
            _run_taichi(run_fold, *(t.numpy() for t in ends), out.size)


def loop_while(condition: Any, body: Callable[[], None]) -> None:
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
    if not condition.device.is_cuda:
        _loop_on_cpu(condition.numpy(), body)
        return
    run_while(condition, body)


def _loop_on_cpu(flag: Any, body: Callable[[], None]) -> None:
    turn: Turn | None = None
    while flag[0]:
        with lock:
            if turn is None or not turn.repeat():
                turn = _keep(body)


def _keep(body: Callable[[], None]) -> Turn:
    """Run a body of CPU launches, and keep them; take the lock first."""
    global _turn
    outer, _turn = _turn, Turn()
    try:
        body()
        return _turn
    finally:
        _turn = outer
