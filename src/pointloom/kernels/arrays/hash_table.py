"""Ordered hash table from 64-bit keys to positions, with a layout independent of the order of insertion.

Amble and Knuth, "Ordered hash tables", The Computer Journal 17, 1974: keys ascend along a probe sequence, so insertion
needs only `atomic_min`. 12 B per slot, load up to one half.
"""

from ..array_types import Bytes, Device, Indices, Integers, Keys, LongIntegers
from ..lang import array, atomic_min, func, int32, int64, kernel, launch, struct, tid, uint8
from ..memory import empty, full

MAX_SEQUENTIAL = 4096  # keys that one CPU core inserts faster than a parallel launch
EMPTY_KEY = 0x7FFF_FFFF_FFFF_FFFF  # larger than any key


@func
def mix_bits(key: int64) -> int64:
    """Mix a key's bits (finalizer of MurmurHash3 without its last step)."""
    h = key ^ ((key >> 33) & 0x7FFFFFFF)
    h = h * -49064778989728563
    return h ^ ((h >> 29) & 0x7FFFFFFFF)


@struct
class HashTable:
    """Positions of distinct non-negative keys: `keys` per slot or EMPTY_KEY, `positions`, `mask` = `capacity` - 1."""

    keys: array(dtype=int64)
    positions: array(dtype=int32)
    mask: int64

    def __init__(self, device: Device, room: int = 0) -> None:
        """An empty table for `room` keys without growing."""
        self.device = device
        self._allocate(max(1024, 1 << (2 * room - 1).bit_length()))

    def _allocate(self, capacity: int) -> None:
        self.keys, self.positions = full(capacity, EMPTY_KEY, int64, self.device), empty(capacity, int32, self.device)
        self.capacity, self.mask = capacity, capacity - 1

    def append(self, all_keys: Keys, count: int, new_count: int) -> None:
        """Insert the last `new_count` of the first `count` keys of a device array. Grows as needed."""
        if new_count == 0:
            return
        first = count - new_count
        if 2 * count > self.capacity:
            self._allocate(1 << (4 * count - 1).bit_length())
            first = 0
        if count - first <= MAX_SEQUENTIAL and all_keys.device.is_cpu:
            launch(insert_sequentially_kernel, 1, [all_keys, first, count, self])
            return
        launch(insert_keys_kernel, count - first, [all_keys[first:count], self])
        launch(store_positions_kernel, count, [all_keys[:count], self])

    def find(self, wanted: LongIntegers) -> tuple[Indices, Bytes]:
        """Position of each key, int32, or -1; and uint8, 1 for missing keys."""
        positions, missing = empty(wanted.size, int32, self.device), empty(wanted.size, uint8, self.device)
        launch(find_positions_kernel, wanted.size, [wanted, self, positions, missing])
        return positions, missing


def list_keys(keys: Keys, count: int, room: int = 0) -> HashTable:
    """Table of the first `count` keys of a device array, with room for more."""
    table = HashTable(keys.device, room)
    table.append(keys, count, count)
    return table


@func
def find_slot(key: int64, table: HashTable) -> int:
    """First slot of a key's probe with this key or a larger one."""
    slot = mix_bits(key) & table.mask
    while table.keys[int(slot)] < key:
        slot = (slot + 1) & table.mask
    return int(slot)


@func
def find_position(key: int64, table: HashTable) -> int:
    slot = find_slot(key, table)
    position = -1
    if table.keys[slot] == key:
        position = table.positions[slot]
    return position


@func
def insert_entry(entry: int64, low_bits: int, entries: array(dtype=int64), mask: int64):
    """Insert an entry into its probe, moving larger ones on. The smallest entry per key (above the low bits) stays."""
    carried = entry
    slot = mix_bits(carried >> int64(low_bits)) & mask
    carrying = 1
    while carrying == 1:
        old = atomic_min(entries, int(slot), carried)  # resolves the race for the slot: the smaller entry stays
        if old == int64(EMPTY_KEY) or (old >> int64(low_bits)) == (carried >> int64(low_bits)):
            carrying = 0
        else:
            if old > carried:
                carried = old
            slot = (slot + 1) & mask


@func
def insert_key(key: int64, table: HashTable):
    insert_entry(key, 0, table.keys, table.mask)


@kernel
def insert_keys_kernel(new_keys: array(dtype=int64), table: HashTable):
    i = tid()
    insert_key(new_keys[i], table)


@kernel(for_cpu=True)
def insert_sequentially_kernel(keys: array(dtype=int64), first: int, count: int, table: HashTable):
    """Insert keys sequentially, moving positions with them. One thread."""
    i = tid()
    for k in range(first + i, count):
        key = keys[k]
        position = k
        slot = int(mix_bits(key) & table.mask)
        carrying = 1
        while carrying == 1:
            old = table.keys[slot]
            if old >= key:
                moved = table.positions[slot]
                table.keys[slot] = key
                table.positions[slot] = position
                if old == key or old == int64(EMPTY_KEY):
                    carrying = 0
                key = old
                position = moved
            slot = (slot + 1) & int(table.mask)


@kernel
def store_positions_kernel(all_keys: array(dtype=int64), table: HashTable):
    i = tid()
    table.positions[find_slot(all_keys[i], table)] = i


@kernel
def find_positions_kernel(
    wanted: array(dtype=int64), table: HashTable, positions: array(dtype=int32), missing: array(dtype=uint8)
):
    """Position of each key, or -1; and 1 where it is missing."""
    i = tid()
    position = find_position(wanted[i], table)
    absent = 0
    if position < 0:
        absent = 1
    positions[i] = position
    missing[i] = uint8(absent)


@kernel
def number_new_kernel(missing: array(dtype=int32), first: int, positions: array(dtype=int32)):
    """The i-th missing key gets position first + i."""
    i = tid()
    positions[missing[i]] = first + i


def number_new(missing: Integers, first: int, positions: Integers) -> None:
    """Assign positions from `first` on to the `missing` keys, in `positions`."""
    launch(number_new_kernel, missing.size, [missing, first, positions])
