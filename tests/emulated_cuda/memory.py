"""Device memory: addresses that the host cannot touch, and the bytes behind them."""

import ctypes
from collections import OrderedDict

from .findings import CudaFault

SPAN = 1 << 41  # device addresses; none is used twice, so that a use after release is always seen
SMALL_SPAN = SPAN // 4  # arrays up to LARGE are here
LARGE, CHUNK = 1 << 16, 1 << 20
ALIGNMENT, GAP = 512, 256  # of addresses, as cudaMalloc has it; between arrays at least
FRESH, RELEASED = 0xCB, 0xDB
TRACK_BYTES = 32  # of struct Track: one for four bytes, and one for each byte that was touched by itself
PAGE = 4096
_PROT_NONE, _PROT_READ_WRITE = 0, 3
_MAP_PRIVATE, _MAP_ANONYMOUS, _MAP_NORESERVE, _MADV_DONTNEED = 2, 0x20, 0x4000, 4
_libc = ctypes.CDLL(None, use_errno=True)
_libc.mmap.restype = ctypes.c_void_p
_libc.mmap.argtypes = [ctypes.c_void_p, ctypes.c_size_t, ctypes.c_int, ctypes.c_int, ctypes.c_int, ctypes.c_long]
_libc.madvise.argtypes = [ctypes.c_void_p, ctypes.c_size_t, ctypes.c_int]


def _map(size: int, protection: int) -> int:
    address = _libc.mmap(None, size, protection, _MAP_PRIVATE | _MAP_ANONYMOUS | _MAP_NORESERVE, -1, 0)
    if address in (None, ctypes.c_void_p(-1).value):
        raise MemoryError(f"{size >> 30} GiB of addresses are refused: is vm.overcommit_memory 2?")
    return address


class Memory:
    """Arrays of the device.

    Device addresses are in a range without any access rights: a host that follows one crashes at once. Kernels and
    copies go through `base -> bytes`. `valid` counts the bytes of live arrays in each eight bytes, `written` marks each
    written byte, `tracks` and `byte_tracks` store the last access.
    """

    def __init__(self, room: int, *, uninitialized: bool, races: bool) -> None:
        self.room = room
        self.base = _map(SPAN, _PROT_NONE)
        self.bytes = _map(SPAN, _PROT_READ_WRITE)
        self.valid = _map(SPAN // 8, _PROT_READ_WRITE)
        self.written = _map(SPAN, _PROT_READ_WRITE) if uninitialized else 0
        self.tracks = _map(SPAN // 4 * TRACK_BYTES, _PROT_READ_WRITE) if races else 0
        self.byte_tracks = _map(SPAN * TRACK_BYTES, _PROT_READ_WRITE) if races else 0
        self.next_small, self.next_large = ALIGNMENT, SMALL_SPAN
        self.live: dict[int, tuple[int, str]] = {}  # address -> size, call site
        self.released: OrderedDict[int, tuple[int, str]] = OrderedDict()
        self.in_chunk: dict[int, int] = {}  # live small arrays
        self.used = self.peak = self.total = 0
        self.reserved = self.threshold = 0  # what the pool has of the system, and what it keeps at a wait

    def allocate(self, size: int, made_by: str = "") -> int:
        """The address of a new array; 0 if memory is exhausted."""
        if self.used + size > self.room:
            return 0
        length = -(-(size + GAP) // ALIGNMENT) * ALIGNMENT
        if size > LARGE:
            offset, self.next_large = self.next_large, self.next_large + length
        else:
            chunk = self.next_small // CHUNK
            if (self.next_small + length) // CHUNK != chunk:
                self.next_small = (chunk + 1) * CHUNK
                self._forget_chunk(chunk)
            offset, self.next_small = self.next_small, self.next_small + length
            self.in_chunk[offset // CHUNK] = self.in_chunk.get(offset // CHUNK, 0) + 1
        if self.next_small > SMALL_SPAN or self.next_large > SPAN:
            raise MemoryError("the emulated device has used up its addresses")
        address = self.base + offset
        self.live[address] = (size, made_by)
        self.used += size
        self.total += size
        self.peak = max(self.peak, self.used)
        self.reserved = max(self.reserved, self.used)
        self.freshen(address, size)
        return address

    def freshen(self, address: int, size: int) -> None:
        offset = address - self.base
        ctypes.memset(self.bytes + offset, FRESH, size)
        ctypes.memset(self.valid + offset // 8, 8, size // 8)
        if size % 8:
            ctypes.memset(self.valid + offset // 8 + size // 8, size % 8, 1)
        if self.written:
            ctypes.memset(self.written + offset, 0, size)

    def trim(self, bytes_to_keep: int) -> None:
        """Hand what the pool has beyond its arrays back to the system, but for so many bytes in all."""
        self.reserved = max(self.used, min(self.reserved, bytes_to_keep))

    def release(self, address: int) -> None:
        """Give an array back; whoever touches it afterward is at fault."""
        if address not in self.live:
            raise CudaFault(f"invalid argument: {address:#x} is released, and is no live allocation")
        self.released[address] = self.live.pop(address)
        size = self.released[address][0]
        if len(self.released) > 4096:
            self.released.popitem(last=False)
        self.used -= size
        offset = address - self.base
        ctypes.memset(self.valid + offset // 8, 0, -(-size // 8))
        if size > LARGE:
            self._forget(offset, size)
            return
        ctypes.memset(self.bytes + offset, RELEASED, size)
        chunk = offset // CHUNK
        self.in_chunk[chunk] -= 1
        self._forget_chunk(chunk)

    def _forget_chunk(self, chunk: int) -> None:
        if not self.in_chunk.get(chunk) and chunk != self.next_small // CHUNK:
            self.in_chunk.pop(chunk, None)
            self._forget(chunk * CHUNK, CHUNK)

    def _forget(self, offset: int, size: int) -> None:
        """Hand whole pages back to the system: the addresses are never used again."""
        tracks = ((self.tracks, TRACK_BYTES // 4), (self.byte_tracks, TRACK_BYTES))
        for area, scale in ((self.bytes, 1), (self.written, 1), *tracks):
            first = -(-(area + offset * scale) // PAGE) * PAGE
            last = (area + (offset + size) * scale) // PAGE * PAGE
            if area and last > first:
                _libc.madvise(first, last - first, _MADV_DONTNEED)

    def contains(self, address: int) -> bool:
        return self.base <= address < self.base + SPAN

    def describe(self, address: int) -> str:
        for start, (size, made_by) in self.live.items():
            if start - GAP <= address < start + size + GAP:
                return f"byte {address - start} of an array of {size} bytes ({made_by})"
        for start, (size, made_by) in self.released.items():
            if start <= address < start + size:
                return f"byte {address - start} of a RELEASED array of {size} bytes ({made_by})"
        return "no array" if self.contains(address) else "no array of the device"

    def array_at(self, address: int) -> tuple[int, int]:
        """Start and size of the live array that contains an address; (0, 0) if there is none."""
        return next(((a, size) for a, (size, _) in self.live.items() if a <= address < a + size), (0, 0))

    def real(self, address: int, size: int, what: str, *, write: bool = False) -> int:
        """Where the bytes are; a fault where they are not all in one live array."""
        if size == 0:
            return self.bytes
        if not self.contains(address):
            raise CudaFault(f"invalid argument: {what} at {address:#x}, which is no device memory")
        offset = address - self.base
        first, last = offset // 8, (offset + size - 1) // 8
        valid = ctypes.string_at(self.valid + first, last - first + 1)
        if valid[:-1].count(8) != len(valid) - 1 or valid[-1] < (offset + size - 1) % 8 + 1:
            raise CudaFault(f"invalid argument: {what} of {size} bytes at {self.describe(address)}")
        if write and self.written:
            ctypes.memset(self.written + offset, 1, size)
        return self.bytes + offset

    def unwritten(self, address: int, size: int) -> int:
        if not self.written or not size:
            return 0
        return size - ctypes.string_at(self.written + address - self.base, size).count(1)

    def copy(self, to: int, source: int, size: int) -> None:
        """Copy within the device, what is unwritten included."""
        ctypes.memmove(self.real(to, size, "copy to"), self.real(source, size, "copy from"), size)
        if self.written and size:
            ctypes.memmove(self.written + to - self.base, self.written + source - self.base, size)
