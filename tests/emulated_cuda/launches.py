"""Modules and launches: PTX to a library, arguments to bytes, faults to words."""

import ctypes
import hashlib
import json
import os
import re
import time
from dataclasses import asdict
from pathlib import Path
from typing import Any

from . import gcc, ptx
from .findings import FAULTS, NOTES, Findings, Launch, caller
from .kernel_coverage import Marks
from .memory import SPAN, Memory
from .properties import OPT_IN_SHARED, STATIC_SHARED
from .settings import settings
from .streams import Streams, address_of

LAUNCH_FAILED = 1
ARRAY_BYTES = 56  # of Warp's description of an array, an argument of kernels
MAX_THREADS, MAX_GRID = 1024, (2**31 - 1, 65535, 65535)
GRID_WIDTH = 1 << 24  # threads in the first dimension of a grid, as Warp has it
# A module that is kept goes with the translator that wrote it.
_TRANSLATOR = "".join(path.read_text() for path in sorted((Path(__file__).parent / "ptx").glob("*.py")))


class State(ctypes.Structure):
    """`struct Emulator` of runtime/emulator.h."""

    _fields_ = (
        ("base", ctypes.c_uint64),
        ("size", ctypes.c_uint64),
        *((name, ctypes.c_void_p) for name in ("bytes", "valid", "written", "tracks", "byte_tracks")),
        *((name, ctypes.c_uint32) for name in ("launch", "block_threads")),
        *((name, ctypes.c_int32) for name in ("interval", "countdown")),
        ("random", ctypes.c_uint64),
        *((name, ctypes.c_uint32) for name in ("fault", "fault_size", "fault_access", "fault_statement")),
        ("fault_address", ctypes.c_uint64),
        ("fault_tid", ctypes.c_uint32 * 3),
        ("fault_ctaid", ctypes.c_uint32 * 3),
        ("fault_text", ctypes.c_char * 256),
        ("note_count", ctypes.c_uint64 * len(NOTES)),
        ("note_address", ctypes.c_uint64 * len(NOTES)),
        *((name, ctypes.c_uint32 * len(NOTES)) for name in ("note_statement", "note_thread", "note_other")),
        ("jump", ctypes.c_void_p * 5),
        ("covered", ctypes.c_void_p),
        ("atomics", ctypes.c_uint64),
    )


class Work(ctypes.Structure):
    """`emulator_work` of runtime/threads.c: memory accesses of the last launch, and those of its longest thread."""

    _fields_ = (("accesses", ctypes.c_uint64), ("longest", ctypes.c_uint64))


_SHARED: Any = ((State, "EMULATOR"), (Work, "emulator_work"))


class LoadedKernel:
    def __init__(self, *, kernel: ptx.Kernel, entry: int, window: int, argument_names: list[str]):
        self.kernel, self.entry, self.window, self.argument_names = kernel, entry, window, argument_names
        self.name = re.sub(r"_[0-9a-f]{8}_cuda_kernel_forward$", "", kernel.name)
        self.dynamic_limit = STATIC_SHARED - kernel.static_shared

    def argument_name(self, position: int) -> str:
        return self.argument_names[position] if position < len(self.argument_names) else f"argument {position}"


def _cuda_source(ptx_path: str) -> Path:
    """The CUDA source that Warp leaves beside the PTX."""
    return Path(re.sub(r"\.sm\d+\w*\.ptx$", ".cu", ptx_path))


def _argument_names(ptx_path: str, kernel: str) -> list[str]:
    source = _cuda_source(ptx_path)
    if not source.exists():
        return []
    pattern = rf"__global__ void (?:\w+\([^)]*\)\s*)?{re.escape(kernel)}\(\s*(.*?)\)\s*\{{"
    match = re.search(pattern, source.read_text(), re.S)
    return [p.split()[-1].removeprefix("var_") for p in re.split(r",\s*\n", match.group(1))] if match else []


class Launches:
    def __init__(self, streams: Streams, memory: Memory, findings: Findings):
        self.streams, self.memory, self.findings = streams, memory, findings
        self.runtime = gcc.load_runtime()
        pointer, number = ctypes.c_void_p, ctypes.c_uint32
        types = [pointer, ctypes.c_char_p, pointer, pointer, number, number, number, ctypes.c_uint64]
        self.runtime.emulator_launch.argtypes, self.runtime.emulator_launch.restype = types, number
        self.state, self.work = (kind.in_dll(self.runtime, name) for kind, name in _SHARED)
        self.state.base, self.state.size = memory.base, SPAN
        self.state.bytes, self.state.valid = memory.bytes, memory.valid
        self.state.written = memory.written
        self.state.tracks, self.state.byte_tracks = memory.tracks, memory.byte_tracks
        self.marks = Marks(Path(settings.coverage.replace("%p", str(os.getpid())))) if settings.coverage else None
        self.state.covered = self.marks.address if self.marks else None

    def _compile(self, text: str) -> tuple[ctypes.CDLL, ptx.Translation]:
        """A module's library and what its kernels take, from the cache where they are there."""
        name = hashlib.sha256((gcc.headers_key() + _TRANSLATOR + text).encode()).hexdigest()[:24]
        described = gcc.cache_folder() / f"{name}.json"
        if described.exists():
            window, kernels = json.loads(described.read_text())
            translation = ptx.Translation("", window, [ptx.Kernel(**k) for k in kernels])
            return ctypes.CDLL(str(gcc.cache_folder() / f"{name}.so")), translation
        start = time.process_time()
        translation = ptx.translate(text)
        self.findings.seconds["translate"] += time.process_time() - start
        start = time.perf_counter()
        library = ctypes.CDLL(str(gcc.build_text(name, translation.source)))
        self.findings.seconds["compile"] += time.perf_counter() - start
        content = json.dumps([translation.shared_window, [asdict(k) for k in translation.kernels]])
        gcc.write_atomically(described, content.encode())  # written last: its existence marks a complete library
        return library, translation

    def wp_cuda_load_module(self, _, path):
        name = path.decode()
        if not name.endswith(".ptx"):
            self.findings.error = "the emulated device loads PTX only: leave wp.config.cuda_output alone"
            return None
        library, module = self._compile(Path(name).read_bytes().decode(errors="replace"))
        if self.marks:
            self.marks.note_module(_cuda_source(name))
        kernels = {}
        for kernel in module.kernels:
            entry = ctypes.cast(getattr(library, kernel.symbol), ctypes.c_void_p).value or 0
            kernels[kernel.name] = LoadedKernel(
                kernel=kernel,
                entry=entry,
                window=module.shared_window,
                argument_names=_argument_names(name, kernel.name),
            )
            self.findings.kernels[kernels[kernel.name].name] = kernel.findings
        return self.streams.handle(kernels)

    def wp_cuda_unload_module(self, _, module):
        self.streams.flush_all()
        self.streams.handles.pop(address_of(module), None)

    def wp_cuda_get_kernel(self, _, module, name):
        kernel = self.streams.named(module).get(name.decode())
        return self.streams.handle(kernel) if kernel else None

    def wp_cuda_get_kernel_static_shared_memory(self, _, kernel):
        return self.streams.named(kernel).kernel.static_shared

    def wp_cuda_configure_kernel_shared_memory(self, kernel, size):
        loaded = self.streams.named(kernel)
        static = loaded.kernel.static_shared
        if static + size > OPT_IN_SHARED:
            text = f"{loaded.name}: {static} + {size} bytes of shared memory, {OPT_IN_SHARED} at most"
            return self.findings.refuse(text)
        loaded.dynamic_limit = max(loaded.dynamic_limit, size)
        return True

    def wp_cuda_set_kernel_cluster_attrs(self, *_):
        return True

    def wp_cuda_launch_kernel(
        self, _, kernel, dim, max_blocks, block_dim, strided, cluster, shared, args, stream, apic
    ):
        loaded = self.streams.named(kernel)
        self.findings.counts["launches asked for"] += 1  # by the host, those that a graph records among them
        block_dim = block_dim if block_dim > 0 else 256
        limit = min(MAX_THREADS, loaded.kernel.max_threads)
        if block_dim > limit:
            self.findings.refuse(f"invalid configuration: {loaded.name}: {block_dim} threads a block, {limit} at most")
            return LAUNCH_FAILED
        if shared > loaded.dynamic_limit or loaded.kernel.static_shared + shared > OPT_IN_SHARED:
            self.findings.refuse(f"invalid value: {loaded.name}: {shared} bytes of dynamic shared memory")
            return LAUNCH_FAILED
        if dim == 0:
            return 0
        grid = _grid(dim, block_dim, max_blocks if strided else None)
        parameters = bytearray(max(loaded.kernel.parameter_bytes, 8))
        pointers = ctypes.cast(args, ctypes.POINTER(ctypes.c_void_p))
        for k, (offset, size) in enumerate(loaded.kernel.parameters):
            parameters[offset : offset + size] = ctypes.string_at(pointers[k], size)
        given, where = bytes(parameters), caller()
        run = lambda: self._run(loaded, given, grid, block_dim, shared, where)  # noqa: E731
        self.streams.enqueue(self.streams.stream(stream), run, "kernel launch")
        return 0

    def _run(self, loaded: LoadedKernel, parameters: bytes, grid: tuple, block: int, shared: int, where: str) -> None:
        start, counts, state = time.process_time(), self.findings.counts, self.state
        threads = grid[0] * grid[1] * grid[2] * block
        counts["launches"] += 1
        counts["threads"] += threads
        ctypes.memset(state.note_count, 0, ctypes.sizeof(state.note_count))
        state.atomics = 0
        sizes = (ctypes.c_uint32 * 3)(*grid), (ctypes.c_uint32 * 3)(block, 1, 1)
        how = int(loaded.kernel.waits), settings.order, settings.seed * 1_000_003 + counts["launches"]
        fault = self.runtime.emulator_launch(loaded.entry, parameters, *sizes, loaded.window + shared, *how)
        seconds = time.process_time() - start
        entry = self.findings.launches.setdefault(loaded.name, [0, 0, 0.0])
        entry[:] = entry[0] + 1, entry[1] + threads, entry[2] + seconds
        if self.findings.recorded is not None:
            self.findings.recorded.append(Launch(loaded.name, threads, self.work.accesses, self.work.longest))
        self.findings.seconds["run"] += seconds
        self.findings.atomics[loaded.name] += state.atomics
        self._note(loaded, parameters, where)
        if fault:
            self._fault(loaded, fault, where)

    def _note(self, loaded: LoadedKernel, parameters: bytes, where: str) -> None:
        state = self.state
        for k, kind in enumerate(NOTES):
            if not state.note_count[k]:
                continue
            address, thread = state.note_address[k], str(state.note_thread[k])
            if "race" in kind or "atomic" in kind:
                thread += f" and {state.note_other[k]}"
            location = f"{self._argument(loaded, parameters, address)}, " if address else ""
            text = f"{location}thread {thread}, statement {state.note_statement[k]}; {where}"
            self.findings.note(loaded.name, kind, text, state.note_count[k])

    def _fault(self, loaded: LoadedKernel, fault: int, where: str) -> None:
        state = self.state
        text = f"{loaded.name}: {FAULTS[fault]}: "
        if state.fault_size:
            access = ("read", "write", "atomic")[state.fault_access]
            array = self.memory.describe(state.fault_address)
            text += f"{access} of {state.fault_size} bytes at {state.fault_address:#x}, {array}, "
        text += f"block {tuple(state.fault_ctaid)}, thread {tuple(state.fault_tid)}"
        message = state.fault_text.decode(errors="replace")
        self.findings.fault(f"{text}{f', {message}' if message else ''}; launched by {where}")

    def _argument(self, loaded: LoadedKernel, parameters: bytes, address: int) -> str:
        start, size = self.memory.array_at(address)
        for k, (offset, length) in enumerate(loaded.kernel.parameters):
            data = int.from_bytes(parameters[offset : offset + 8], "little")
            if length == ARRAY_BYTES and start <= data <= address and data < start + size:
                return f"{loaded.argument_name(k)}[byte {address - data}]"
        return f"address {address:#x}"


def _grid(dim: int, block_dim: int, max_blocks: Any) -> tuple[int, int, int]:
    """The grid that Warp's native code launches: strided over a number of blocks, or in up to three dimensions."""
    blocks = -(-dim // block_dim)
    if max_blocks is not None:
        return max(1, min(blocks, max_blocks if max_blocks > 0 else MAX_GRID[0])), 1, 1
    width = max(1, min(blocks, GRID_WIDTH // block_dim))
    rest = -(-blocks // width)
    height = max(1, min(rest, MAX_GRID[1]))
    return width, height, max(1, min(-(-rest // height), MAX_GRID[2]))
