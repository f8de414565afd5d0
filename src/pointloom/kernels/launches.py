"""Launch kernels on the device of their arrays: on CUDA in Warp's stream, on the CPU on all cores.

`cpu_compiler("taichi")` or `POINTLOOM_CPU=taichi` selects Taichi as the CPU compiler, for cross-checks in tests.
"""

from __future__ import annotations

import contextlib
import contextvars
import functools
from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, Any

import warp as wp

from .array_types import Array1, Device, Element
from .language import cpu_code, cpu_pool, kernel_cache, pool_code, prepared_launches, taichi_compiler, warp_compiler
from .language.arguments import MAX_THREADS, checked_arguments
from .language.compile_notices import announced, compiling
from .language.cuda_launches import PreparedKernel, PreparedSum
from .language.device_lock import RecordedLoop, lock, record, record_loop, replay  # noqa: F401  handed on
from .language.environment import setting
from .language.module_loading import load_module
from .language.prepared_launches import UNFIT, FlatLaunch, LaunchSequence, WarpLaunch, flatteners, record_launches
from .language.segment_launches import PreparedSegmentSum, launch_segments
from .language.taichi_launches import TaichiLaunch
from .language.warp_parts import launches_plainly
from .memory import empty, rows_of, zeros

if TYPE_CHECKING:
    from .array_types import Array1, Integers
    from .language.launched import Launched, LaunchedReduction

HAS_CUDA = wp.is_cuda_available()
ELEMENTS_PER_BLOCK = 1024  # of a CPU partial sum: many blocks per core at 100k elements, few to fold

_compiler: contextvars.ContextVar[str | None] = contextvars.ContextVar("pointloom_cpu_compiler", default=None)


@contextlib.contextmanager
def cpu_compiler(name: str) -> Iterator[None]:
    """Compile CPU launches with "warp" or "taichi" inside the block. For tests and for `doctor`."""
    token = _compiler.set(name)
    try:
        yield
    finally:
        _compiler.reset(token)


@functools.cache
def compiler_of_environment() -> str:
    """POINTLOOM_CPU at the first launch, or "warp": reading it takes a quarter of a launch."""
    return setting("POINTLOOM_CPU") or "warp"


def current_cpu_compiler() -> str:
    """The compiler of CPU launches, "warp" or "taichi" (see `cpu_compiler`). Raises RuntimeError if unusable."""
    wanted = _compiler.get() or compiler_of_environment()
    if wanted not in ("warp", "taichi"):
        raise RuntimeError(f"POINTLOOM_CPU: expected warp or taichi, got {wanted!r}")
    if wanted == "taichi":
        taichi_compiler.start()
    return wanted


_launched: set[tuple[int, str]] = set()  # kernels launched on a GPU, by device
_by_warp: dict[Any, WarpLaunch | PlainLaunch] = {}  # on the CPU, by the kernel or sum
_by_taichi: dict[Any, TaichiLaunch] = {}  # by Taichi's kernel


def _announced(kernel: object, name: str, target: str) -> contextlib.AbstractContextManager[bool]:
    """Announce the first launch of a kernel in this process. True if it was the first."""
    if (id(kernel), target) in _launched:
        return contextlib.nullcontext(False)
    _launched.add((id(kernel), target))
    return announced(name)


def _run_on_cuda(kernel: Any, thread_count: int, values: Sequence[Any], device: Device, **options: Any) -> None:
    with _announced(kernel, kernel.key, device.alias) as is_first:
        if is_first:
            load_module(kernel.module, device)
        wp.launch(kernel, thread_count, values, device=device, **options)


def _is_launched_prepared(kernel: Launched, thread_count: int, arguments: Sequence[Any], device: Device) -> bool:
    """Use a prepared GPU launch. False, without effect, if there is none or the arguments need conversion."""
    prepared: PreparedKernel | None = kernel.prepared.get(device.alias)
    if prepared is None or not 0 < thread_count <= MAX_THREADS or not launches_plainly():
        return False
    try:
        flat = prepared.flatten(arguments)
        with lock:
            prepared.launch(thread_count, flat)
    except UNFIT:
        return False
    return True


def _prepare_flat(what: Launched, arguments: Sequence[Any], values: Sequence[Any], rest: Sequence[Any] = ()) -> None:
    """Prepare later CPU launches from these arguments, or none if they do not show that it is equivalent. `rest`:
    further arguments."""
    if "cpu" in what.prepared:
        return
    launch, made = _by_warp[what], None
    with contextlib.suppress(*UNFIT):
        if isinstance(launch, WarpLaunch) and launch.layout:
            pair = flatteners(what.types, wp.get_device("cpu"), what.field_paths, len(what.takes))
            made = FlatLaunch.of(launch, pair, arguments, values, rest)
    what.prepared["cpu"] = made


def _run_on_cpu(what: Launched, values: Sequence[Any], thread_count: int, last_count: int = 0) -> None:
    again = _prepared_on_cpu(what, values).bound(values, thread_count, last_count)
    again()
    if (sequence := prepared_launches.sequence) is not None:
        sequence.launches.append(again)


def _prepared_on_cpu(what: Launched, values: Sequence[Any]) -> WarpLaunch | PlainLaunch:
    prepared = _by_warp.get(what)
    if prepared is None:
        cpu_pool.check_stack()
        with announced(what.name):
            prepared = _by_warp[what] = _prepare(what, values)
    return prepared


def bind(kernel: Launched, arguments: Sequence[Any]) -> Callable[[], None]:
    """A repeatable launch of one thread on the CPU, for the host's own algebra: 1 us instead of 10. The code is Warp's,
    also inside `cpu_compiler("taichi")`. Different threads need different arrays. Raises as `launch`.
    """
    values, _ = checked_arguments(kernel, 1, arguments)
    with lock:
        return _prepared_on_cpu(kernel, values).bound_alone(values)


class PlainLaunch:
    """A launch by Warp on one core, for a Warp without the parts that WarpLaunch uses."""

    def __init__(self, kernel: object) -> None:
        self._kernel = kernel

    def bound(self, values: Sequence[Any], thread_count: int, last_count: int = 0) -> Callable[[], None]:
        """A repeatable launch, as of WarpLaunch."""
        return lambda: wp.launch(self._kernel, thread_count + last_count, values, device="cpu")

    def bound_alone(self, values: Sequence[Any]) -> Callable[[], None]:
        return self.bound(values, 1)


def _prepare(what: Launched, values: Sequence[Any]) -> WarpLaunch | PlainLaunch:
    """Load the machine code of an earlier process, or compile with Warp and store it."""
    cached = what.cached
    if cached is not None and (address := kernel_cache.address_of(cached)):
        return WarpLaunch.of_cached(cached, address, lambda: what.on_host)
    kernel = what.on_host
    load_module(kernel.module, wp.get_device("cpu"))
    try:
        made = WarpLaunch(kernel, values)
        symbol, machine_code = made.symbol, kernel_cache.machine_code_of(kernel)
        cpu_code.full_bounds(1)
    except (AttributeError, TypeError):  # a Warp with other private parts
        return PlainLaunch(kernel)
    if made.layout and machine_code and pool_code.is_usable():
        cached = kernel_cache.CachedKernel(what.field_paths, made.plan, made.layout, symbol, machine_code)
        kernel_cache.store(what.module, what.name, cached)
    return made


def _run_taichi(kernel: object, name: str, annotations: Callable[[], Sequence[Any]], values: Sequence[Any]) -> None:
    taichi, sequence = taichi_compiler.start(), prepared_launches.sequence
    prepared = _by_taichi.get(kernel)
    if prepared is None or prepared.program() is not taichi.program:
        with announced(name):
            compiling()  # before Taichi's cache is queried
            prepared = _by_taichi[kernel] = taichi.prepare(kernel, name, annotations(), values)
        again = None if sequence is None else prepared.bound(values)
    elif sequence is None:
        prepared(values)
        return
    else:
        again = prepared.bound(values)
        again()
    if sequence is not None and again is not None:
        sequence.launches.append(again)
        sequence.program = taichi.program


def _run_taichi_sum(reduction: LaunchedReduction, values: Sequence[Any]) -> None:
    def annotations() -> list[Any]:
        ends = taichi_compiler.sum_types(reduction.vector, segmented=reduction.segmented)
        return [*reduction.types, *ends.values()]

    _run_taichi(reduction.taichi, reduction.name, annotations, values)


def launch(kernel: Launched, thread_count: int, arguments: Sequence[Any]) -> None:
    """Run `thread_count` threads of a kernel on the device of its arrays. Asynchronous on CUDA, and thread-safe.

    Args:
    kernel: The kernel.
    thread_count: Threads, below 2^31.
    arguments: One per parameter: contiguous Warp arrays on one device; vectors and matrices as Warp or NumPy values.
    Integers. For a structure an object with its fields as attributes.

    Raises:
    ValueError: Different devices, a non-contiguous array, a wrong count or a number out of range.
    TypeError: An argument of the wrong type.
    """
    if HAS_CUDA and (home := kernel.first_device(arguments)).is_cuda:
        kernel = kernel.twin
        if _is_launched_prepared(kernel, thread_count, arguments, home):
            return
    elif (prepared := kernel.prepared.get("cpu")) is not None and 0 < thread_count <= MAX_THREADS:
        if (_compiler.get() or compiler_of_environment()) == "warp" and prepared.is_run(thread_count, arguments):
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
            _prepare_flat(kernel, arguments, values)
        else:
            chunks = taichi_compiler.start().chunks(thread_count)
            annotations = taichi_compiler.CHUNKS.values()
            _run_taichi(kernel.taichi, kernel.name, lambda: [*kernel.types, *annotations], [*values, *chunks])


def compute(
    kernel: Launched, count: int, arguments: Sequence[Any], dtype: type[Element], device: Device
) -> Array1[Element]:
    """Launch one thread for each of `count` elements of a new array, the kernel's last parameter. Return the array."""
    out = empty(count, dtype, device)
    launch(kernel, count, [*arguments, out])
    return out


def reduce(reduction: LaunchedReduction, count: int, arguments: Sequence[Any]) -> Array1[Any]:
    """Sum a reduction over `count` elements in two stages of fixed order: an array (1). Raises as `launch`."""
    if HAS_CUDA and (home := reduction.first_device(arguments)).is_cuda:
        total = _prepared_sum(reduction, count, arguments, home)
        if total is not None:
            return total
    elif (prepared := reduction.prepared.get("cpu")) is not None and 0 < count <= MAX_THREADS:
        if (_compiler.get() or compiler_of_environment()) == "warp":
            numbers, partials, out = _arrays_of_sum(reduction, count, wp.get_device("cpu"))
            if prepared.is_run(numbers[2], arguments, [*numbers, partials, out], 1):
                return out
    values, device = checked_arguments(reduction, count, arguments)
    if count == 0:
        return zeros(1, reduction.vector, device)
    numbers, partials, out = _arrays_of_sum(reduction, count, device)
    blocks, rest = numbers[2], [*numbers, partials, out]
    with lock:
        if device.is_cuda:
            size = warp_compiler.REDUCTION_BLOCK
            _run_on_cuda(reduction.cuda.tiles, blocks * size, [*values, *rest], device, block_dim=size)
            if device.alias not in reduction.prepared:
                with contextlib.suppress(*UNFIT):
                    reduction.prepared[device.alias] = PreparedSum.of(reduction, [*values, *rest], device)
        elif current_cpu_compiler() == "warp":
            _run_on_cpu(reduction, [*values, *rest], blocks, 1)
            _prepare_flat(reduction, arguments, values, rest)
        else:
            chunks = taichi_compiler.start().chunks(blocks)
            _run_taichi_sum(reduction, [*values, count, ELEMENTS_PER_BLOCK, partials, out, *chunks])
    return out


def block_elements(count: int, device: Device) -> int:
    """Elements of a block of `reduce` over `count` elements."""
    if not device.is_cuda:
        return ELEMENTS_PER_BLOCK
    size = warp_compiler.REDUCTION_BLOCK
    return size * max(1, -(-count // (size * warp_compiler.MAX_REDUCTION_BLOCKS)))


def _arrays_of_sum(
    reduction: LaunchedReduction, count: int, device: Device
) -> tuple[tuple[int, int, int], wp.array, Any]:
    """Numbers of elements, of those of a block, and of blocks; the partial sums and the total, in one allocation."""
    size = block_elements(count, device)
    blocks = -(-count // size)
    if device.is_cuda:
        sums = zeros(1 + warp_compiler.partial_rows(reduction.vector, blocks, 1), reduction.vector, device)
    else:
        sums = empty(1 + blocks, reduction.vector, device)
    return (count, size, blocks), rows_of(sums, 1, sums.size), rows_of(sums, 0, 1)


def _prepared_sum(
    reduction: LaunchedReduction, count: int, arguments: Sequence[Any], device: Device
) -> Array1[Any] | None:
    """The sum by a prepared GPU launch. None, without effect, if there is none or the arguments need conversion."""
    prepared: PreparedSum | None = reduction.prepared.get(device.alias)
    if prepared is None or not 0 < count <= MAX_THREADS or not launches_plainly():
        return None
    try:
        flat = prepared.flatten(arguments)
        numbers, partials, out = _arrays_of_sum(reduction, count, device)
        with lock:
            prepared.sum(flat, numbers, partials, out)
    except UNFIT:
        return None
    return out


def reduce_segments(
    reduction: LaunchedReduction,
    blocks: Any,
    live: Integers,
    arguments: Sequence[Any],
    partials: wp.array,
    out: wp.array,
) -> None:
    """Sum a reduction's vectors over segments, each in a fixed order, without allocation. `blocks` is a SegmentBlocks;
    `out` is undefined where `live` (segments) is 0; `partials` is scratch of `blocks.partials`. Raises as `launch`.
    """
    if not reduction.segmented:
        raise TypeError(f"{reduction.name}: a @reduction, where many sums take a @segment_reduction")
    if HAS_CUDA and (home := reduction.first_device(arguments)).is_cuda and launches_plainly():
        on_gpu: PreparedSegmentSum | None = reduction.prepared.get(home.alias)
        if on_gpu is not None and on_gpu.is_launched(arguments, blocks, live, partials, out):
            return
    rest = [blocks.firsts, blocks.lasts, blocks.owners, blocks.starts, live, blocks.count, partials, out]
    prepared = reduction.prepared.get("cpu") if out.device.is_cpu and 0 < blocks.count <= MAX_THREADS else None
    if prepared is not None and (_compiler.get() or compiler_of_environment()) == "warp":
        if prepared.is_run(blocks.count, arguments, rest, out.size):
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
            _run_on_cpu(reduction, [*values, *rest], blocks.count, out.size)
            _prepare_flat(reduction, arguments, values, rest)
        else:
            chunks = taichi_compiler.start().chunks(blocks.count)
            _run_taichi_sum(reduction, [*values, *rest[:5], partials, out, out.size, *chunks])


def loop_while(condition: Integers, body: Callable[[], None]) -> None:
    """Run a body of launches while `condition[0]` is not zero. On CUDA the loop is one graph with a conditional node,
    without host synchronization, or a part of the graph that `record` captures. The body may only launch kernels and
    reductions over existing arrays. On the CPU the launches of the first iteration are repeated. `condition` is an
    int32 device array (1) that the body's last kernel sets. Raises RuntimeError for a CUDA driver before 12.4.
    """
    DeviceLoop(condition, body).run()


class DeviceLoop:
    """A reusable `loop_while`, prepared once. Each run must have the same launches, arrays and numbers."""

    def __init__(self, condition: Integers, body: Callable[[], None]) -> None:
        self._condition, self._body = condition, body
        self._recorded: RecordedLoop | None = None
        self._sequence: LaunchSequence | None = None

    def run(self) -> None:
        """Run the body while the condition is not zero. Raises RuntimeError for a CUDA driver before 12.4."""
        if self._condition.device.is_cuda:
            with lock:
                if self._condition.device.captures:  # in `record`
                    record_loop(self._condition, self._body)
                    return
                if self._recorded is None:
                    self._recorded = RecordedLoop(self._condition, self._body)
                self._recorded.launch()
            return
        flag = self._condition.numpy()
        while flag[0]:
            with lock:
                sequence = self._sequence
                program = None if sequence is None else sequence.program
                if sequence is None or (program is not None and program is not taichi_compiler.start().program):
                    self._sequence = record_launches(self._body)  # the first iteration, or Taichi was restarted
                else:
                    for again in sequence.launches:
                        again()
