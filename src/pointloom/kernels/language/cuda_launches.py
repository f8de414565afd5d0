"""Prepared CUDA launches: later launches of a kernel only pack their arguments.

`wp.launch` takes 20 to 40 us of Python. Here the first launch records the kernel's handle, grid, shared memory, and
argument bytes. If the bytes packed here differ, all launches go through Warp. Later arguments are flattened as on the
CPU (prepared_launches.py).
"""

from __future__ import annotations

import contextlib
import ctypes
import itertools
import struct
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import warp as wp

from ..array_types import Device
from . import warp_parts
from .device_arrays import kind_of
from .prepared_launches import FORMATS, UNFIT, Flat, Flattener, Parameter, flattener
from .warp_compiler import LANE_COUNT as WARP
from .warp_compiler import REDUCTION_BLOCK

if TYPE_CHECKING:
    from .launched import Launched, LaunchedReduction

_BOUNDS = "I4xQQ"  # the extent, the threads, and how many share a coordinate
_ALIGNMENT_BYTES = 8


class _Buffer:
    def __init__(self, size: int, offsets: Sequence[int]) -> None:
        self.room = ctypes.create_string_buffer(size)
        start = ctypes.addressof(self.room)
        self.addresses = (ctypes.c_void_p * len(offsets))(*(start + offset for offset in offsets))


class CudaLaunch:
    """A loaded Warp kernel on a GPU. `is_known` is True if its arguments are packed as Warp does."""

    def __init__(self, kernel: Any, device: Device, command: Any, flat: Flat) -> None:
        """Prepare from a recorded Warp launch and its flattened arguments."""
        self._kernel, self._device = kernel, device
        self._idle: _Buffer | None = None
        self._full = 0  # threads below which blocks are smaller
        self.is_known = False
        with contextlib.suppress(*UNFIT, KeyError):
            self._read(command)
            self.is_known = self._packs_as(command, flat)

    def _read(self, command: Any) -> None:
        hooks = command.hooks
        self._module_exec = command.module_exec  # else Warp might unload the module of the handle
        self._hooks, self._handle = hooks, hooks.forward
        self._grid = (command.max_blocks, command.block_dim, int(command.grid_stride), command.cluster_dim)
        self._shared = hooks.forward_smem_bytes
        parameters = [Parameter.of(argument.type) for argument in self._kernel.adj.args]
        parts = [_BOUNDS, *(_format(parameter) for parameter in parameters)]
        sizes = [struct.calcsize("=" + part) for part in parts]
        padded = [size + -size % _ALIGNMENT_BYTES for size in sizes]
        self._sizes, self._offsets = sizes, [0, *itertools.accumulate(padded)][:-1]
        gaps = [f"{room - size}x" for size, room in zip(sizes, padded, strict=True)]
        self._layout = struct.Struct("=" + "".join(map("".join, zip(parts, gaps, strict=True))))

    def _packs_as(self, command: Any, flat: Flat) -> bool:
        """True if the packed arguments equal Warp's bytes."""
        hooks, bounds = command.hooks, command.bounds
        is_plain = hooks.forward is not None and getattr(hooks.det_launch_meta, "needs_deterministic", False) is False
        if not (is_plain and command.cluster_dim == 1 and len(bounds.shape) == 1 and not command.adjoint):
            return False
        packed = self._layout.pack(bounds.size, bounds.size, 1, *flat)
        given = [packed[start : start + size] for start, size in zip(self._offsets, self._sizes, strict=True)]
        return given == [bytes(param) for param in command.params]

    def fill_multiprocessors(self) -> None:
        """Use smaller blocks for launches with fewer blocks than the device has multiprocessors, but not for one block.
        Not with tiles.
        """
        self._full = self._grid[1] * self._device.sm_count

    def __call__(self, thread_count: int, flat: Flat) -> None:
        """Launch. Take the lock. Raises struct.error or OverflowError (not launched), RuntimeError of the driver."""
        # Detached while in use: a signal handler may launch the same kernel in between, and an interrupted
        # launch leaves a half-filled buffer that must not be reused.
        buffer, self._idle = self._idle, None
        if buffer is None:
            buffer = _Buffer(self._layout.size, self._offsets)
        try:
            self._layout.pack_into(buffer.room, 0, thread_count, thread_count, 1, *flat)
        except (struct.error, OverflowError):
            self._idle = buffer
            raise
        device, grid = self._device, self._grid
        if grid[1] < thread_count < self._full:  # a power of two from WARP, for a block on each multiprocessor
            block = max(WARP, 1 << (thread_count // device.sm_count).bit_length() >> 1)
            grid = (grid[0], block, *grid[2:])
        failed = warp_parts.core().wp_cuda_launch_kernel(
            device.context,
            self._handle,
            thread_count,
            *grid,
            self._shared,
            buffer.addresses,
            device.stream.cuda_stream,
            None,
        )
        self._idle = buffer
        if failed:
            warp_parts.raise_launch_error(self._kernel, device, self._hooks)


def prepared_launch(
    kernel: Any, thread_count: int, values: Sequence[Any], device: Device, **options: Any
) -> CudaLaunch:
    """Prepare a launch from `wp.launch` arguments. Raises one of UNFIT if they cannot show whether it is equivalent."""
    flat = flattener([argument.type for argument in kernel.adj.args], device)(values)
    command = wp.launch(kernel, thread_count, values, device=device, record_cmd=True, **options)
    return CudaLaunch(kernel, device, command, flat)


class PreparedKernel:
    def __init__(self, flatten: Flattener, launch: CudaLaunch) -> None:
        self.flatten, self.launch = flatten, launch

    @classmethod
    def of(cls, kernel: Launched, thread_count: int, values: Sequence[Any], device: Device) -> PreparedKernel | None:
        """Prepare from launch arguments. None if Warp must launch it. Raises one of UNFIT as `prepared_launch`."""
        launch = prepared_launch(kernel.cuda, thread_count, values, device)
        if not launch.is_known:
            return None
        if not kernel.twin.waits_for_block:
            launch.fill_multiprocessors()
        return cls(flattener(kernel.types, device, kernel.field_paths, len(kernel.takes)), launch)


class PreparedSum:
    def __init__(self, reduction: LaunchedReduction, tiles: CudaLaunch, device: Device) -> None:
        self.flatten = flattener(reduction.types, device, reduction.field_paths, len(reduction.takes))
        self.sums = kind_of(reduction.vector, 1, device)
        self._tiles = tiles

    @classmethod
    def of(cls, reduction: LaunchedReduction, given: Sequence[Any], device: Device) -> PreparedSum | None:
        """Prepare from the kernel's arguments. None if Warp must launch it. Raises one of UNFIT."""
        tiles = prepared_launch(reduction.cuda.tiles, REDUCTION_BLOCK, given, device, block_dim=REDUCTION_BLOCK)
        return cls(reduction, tiles, device) if tiles.is_known else None

    def sum(self, flat: Flat, numbers: tuple[int, int, int], partials: wp.array, out: wp.array) -> None:
        """Sum. `numbers`: of elements, of those of a block, and of blocks. Take the lock."""
        packed = self.sums.packed
        self._tiles(numbers[2] * REDUCTION_BLOCK, (*flat, *numbers, packed(partials), packed(out)))


def _format(parameter: Parameter) -> str:
    if parameter.is_array:
        return f"{warp_parts.DESCRIPTION_BYTES}s"
    return f"{parameter.size}s" if parameter.is_vector else FORMATS[parameter.scalar]
