"""Launches: where a kernel's arrays live, all of them by Warp: CUDA's in its stream, the CPU's on all cores.

On the CPU Taichi has the kernels too, as a second compiler of the same source: `cpu_compiler("taichi")` and
`POINTLOOM_CPU=taichi` choose it. The tests do, since what both give the same bits of is the source's.
"""

from __future__ import annotations

import contextlib
import contextvars
import os
from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, Any

import warp as wp

from .array_types import Device
from .language import kept_kernels, pool_code, taichi_compiler, warp_compiler
from .language.arguments import MAX_THREADS, checked_arguments
from .language.cuda_launches import UNFIT, PreparedKernel, PreparedSum
from .language.device_lock import RecordedLoop, lock, record, replay  # noqa: F401  handed on
from .language.module_loading import load_module
from .language.notices import announced, compiling
from .language.prepared_launches import TaichiLaunch, WarpLaunch
from .language.segment_launches import PreparedSegmentSum, launch_segments
from .language.warp_parts import launches_plainly
from .memory import empty, zeros

if TYPE_CHECKING:
    from .array_types import Array1, Integers
    from .lang import Kernel, Reduction

HAS_CUDA = wp.is_cuda_available()
BLOCK = 1024  # elements of a CPU partial sum: many blocks per core at 100k elements, few partial sums to fold

_compiler: contextvars.ContextVar[str | None] = contextvars.ContextVar("pointloom_cpu_compiler", default=None)


@contextlib.contextmanager
def cpu_compiler(name: str) -> Iterator[None]:
    """Compile CPU launches with "warp" or "taichi" inside the block; for tests and for `doctor`."""
    token = _compiler.set(name)
    try:
        yield
    finally:
        _compiler.reset(token)


def current_cpu_compiler() -> str:
    """The compiler that CPU launches go through: "warp", or "taichi" where `POINTLOOM_CPU` or `cpu_compiler` says so.

    Raises:
        RuntimeError: Taichi was asked for and cannot serve, or POINTLOOM_CPU names neither compiler.
    """
    wanted = _compiler.get() or os.environ.get("POINTLOOM_CPU") or "warp"
    if wanted not in ("warp", "taichi"):
        raise RuntimeError(f"POINTLOOM_CPU: expected warp or taichi, got {wanted!r}")
    if wanted == "taichi":
        taichi_compiler.start()
    return wanted


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
_by_warp: dict[Any, WarpLaunch] = {}  # on the CPU, by the kernel or sum
_by_taichi: dict[Any, TaichiLaunch] = {}  # by Taichi's kernel


def _announced(kernel: Any, name: str, place: str) -> contextlib.AbstractContextManager[bool]:
    """Announces the kernel's first launch in this process; gives whether it is that."""
    if (id(kernel), place) in _launched:
        return contextlib.nullcontext(False)
    _launched.add((id(kernel), place))
    return announced(name)


def _run_on_cuda(kernel: Any, thread_count: int, values: Sequence[Any], device: Device, **options: Any) -> None:
    with _announced(kernel, kernel.key, device.alias) as is_first:
        if is_first:
            load_module(kernel.module, device)
        wp.launch(kernel, thread_count, values, device=device, **options)


def _is_launched_prepared(kernel: Kernel, thread_count: int, arguments: Sequence[Any], device: Device) -> bool:
    """Launch on a GPU what has been launched there before and is plainly right; False, and nothing done, of others."""
    prepared: PreparedKernel | None = kernel.prepared.get(device.alias)
    if prepared is None or not 0 < thread_count <= MAX_THREADS or not launches_plainly():
        return False
    try:
        flat = prepared.take_apart(arguments)
        with lock:
            prepared.launch(thread_count, flat)
    except UNFIT:
        return False
    return True


def _run_on_cpu(what: Kernel | Reduction, values: Sequence[Any], thread_count: int, last_count: int = 0) -> None:
    prepared = _by_warp.get(what)
    if prepared is None:
        with announced(what.name):
            prepared = _by_warp[what] = _prepare(what, values)
    again = prepared.bound(values, thread_count, last_count)
    again()
    if _turn is not None:
        _turn.launches.append(again)


def _prepare(what: Kernel | Reduction, values: Sequence[Any]) -> WarpLaunch:
    """The machine code that an earlier process has left, or what Warp makes of the kernel; kept for later ones."""
    kept = what.kept
    if kept is not None and (address := kept_kernels.address_of(kept)):
        return WarpLaunch.of_kept(kept, address, lambda: what.on_host)
    kernel = what.on_host
    load_module(kernel.module, wp.get_device("cpu"))
    made = WarpLaunch(kernel, values)
    machine_code = kept_kernels.machine_code_of(kernel)
    if made.layout and machine_code and pool_code.is_usable():
        kept = kept_kernels.Kept(what.places, made.plan, made.layout, made.symbol, machine_code)
        kept_kernels.keep(what.module, what.name, kept)
    return made


def _run_taichi(kernel: Any, name: str, annotations: Callable[[], Sequence[Any]], values: Sequence[Any]) -> None:
    taichi = taichi_compiler.start()
    prepared = _by_taichi.get(kernel)
    if prepared is None or prepared.program() is not taichi.program:
        with announced(name):
            compiling()  # for all that is known of Taichi's cache
            prepared = _by_taichi[kernel] = taichi.prepare(kernel, name, annotations(), values)
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
    if HAS_CUDA and (home := kernel.first_device(arguments)).is_cuda:
        kernel = kernel.twin
        if _is_launched_prepared(kernel, thread_count, arguments, home):
            return
    values, device = checked_arguments(kernel, thread_count, arguments)
    if thread_count == 0:
        return
    with lock:  # neither Taichi nor Warp's loading of modules is thread-safe, and a pool runs one launch at a time
        if device.is_cuda:
            _run_on_cuda(kernel.cuda, thread_count, values, device)
            if device.alias not in kernel.prepared:
                with contextlib.suppress(*UNFIT):
                    kernel.prepared[device.alias] = PreparedKernel.of(kernel, thread_count, values, device)
        elif current_cpu_compiler() == "warp":
            _run_on_cpu(kernel, values, thread_count)
        else:
            chunks = taichi_compiler.start().chunks(thread_count)
            annotations = taichi_compiler.CHUNKS.values()
            _run_taichi(kernel.taichi, kernel.name, lambda: [*kernel.types, *annotations], [*values, *chunks])


def reduce(reduction: Reduction, count: int, arguments: Sequence[Any]) -> Array1[Any]:
    """Sum a reduction's vectors over `count` elements, in two stages of fixed order.

    Returns:
        The sum as a device array of one vector; zero where there are no elements.

    Raises:
        ValueError, TypeError: As `launch`.
    """
    if HAS_CUDA and (home := reduction.first_device(arguments)).is_cuda:
        found = _prepared_sum(reduction, count, arguments, home)
        if found is not None:
            return found
    values, device = checked_arguments(reduction, count, arguments)
    if count == 0:
        return zeros(1, reduction.vector, device)
    out = empty(1, reduction.vector, device)
    size = warp_compiler.REDUCTION_BLOCK if device.is_cuda else BLOCK
    blocks = -(-count // size)
    partials = empty(blocks, reduction.vector, device)
    with lock:
        if device.is_cuda:
            kernels, inputs = reduction.cuda, [*values, count, partials]
            _run_on_cuda(kernels.tiles, blocks * size, inputs, device, block_dim=size)
            _run_on_cuda(kernels.fold_tiles, size, [blocks, partials, out], device, block_dim=size)
            if device.alias not in reduction.prepared:
                with contextlib.suppress(*UNFIT):
                    folded = [blocks, partials, out]
                    reduction.prepared[device.alias] = PreparedSum.of(reduction, inputs, folded, device)
        elif current_cpu_compiler() == "warp":
            _run_on_cpu(reduction, [*values, count, BLOCK, blocks, partials, out], blocks, 1)
        else:
            chunks = taichi_compiler.start().chunks(blocks)
            _run_taichi_sum(reduction, [*values, count, BLOCK, partials, out, *chunks])
    return out


def _prepared_sum(reduction: Reduction, count: int, arguments: Sequence[Any], device: Device) -> Array1[Any] | None:
    """The sum on a GPU, where it has been made there before and is plainly right; None, and nothing done, of others."""
    prepared: PreparedSum | None = reduction.prepared.get(device.alias)
    if prepared is None or not 0 < count <= MAX_THREADS or not launches_plainly():
        return None
    try:
        flat = prepared.take_apart(arguments)
        out = empty(1, reduction.vector, device)
        blocks = -(-count // warp_compiler.REDUCTION_BLOCK)
        partials = empty(blocks, reduction.vector, device)
        with lock:
            prepared.sum(count, flat, blocks, partials, out)
    except UNFIT:
        return None
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
    if HAS_CUDA and (home := reduction.first_device(arguments)).is_cuda and launches_plainly():
        prepared: PreparedSegmentSum | None = reduction.prepared.get(home.alias)
        if prepared is not None and prepared.is_launched(arguments, blocks, live, partials, out):
            return
    values, device = checked_arguments(reduction, blocks.element_count, arguments)
    with lock:
        if device.is_cuda:
            launch_segments(_run_on_cuda, reduction.cuda, values, blocks, live, partials, out)
            if device.alias not in reduction.prepared:
                with contextlib.suppress(*UNFIT):
                    made = PreparedSegmentSum.of(reduction, values, blocks, live, partials, out)
                    reduction.prepared[device.alias] = made
        elif current_cpu_compiler() == "warp":
            tables = [blocks.firsts, blocks.lasts, blocks.owners, blocks.starts, live]
            _run_on_cpu(reduction, [*values, *tables, blocks.count, partials, out], blocks.count, out.size)
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
