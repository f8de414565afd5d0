"""An ordered hash table from 64-bit keys to their positions, with one layout for any order of insertion.

Amble and Knuth, "Ordered hash tables", The Computer Journal 17, 1974: along a probe sequence keys ascend, so a slot
holds the smallest key that wants it. Insertion is `atomic_min` alone, no compare-and-swap, and the layout does not
depend on which thread came first. 12 B a slot, at most half of the slots taken.
"""

from ..lang import array, atomic_min, func, int32, int64, kernel, launch, struct, tid, uint8
from ..memory import empty, full

EMPTY = 0x7FFF_FFFF_FFFF_FFFF  # larger than any key


@func
def mix_bits(key: int64) -> int64:
    """Spread a key's bits (the finalizer of MurmurHash3, without its last step)."""
    h = key ^ ((key >> int64(33)) & int64(0x7FFFFFFF))
    h = h * int64(-49064778989728563)
    return h ^ ((h >> int64(29)) & int64(0x7FFFFFFFF))


@struct
class HashTable:
    """Positions of the keys in a growing list of distinct keys, none of them negative.

    Attributes:
        keys: int64, one a slot; EMPTY where none is.
        positions: int32, that of each slot's key in the list.
        capacity: Slots, a power of two.
        mask: capacity - 1.
    """

    keys: array(dtype=int64)
    positions: array(dtype=int32)
    mask: int64

    def __init__(self, device):
        self.device = device
        self._allocate(1024)

    def _allocate(self, capacity):
        self.keys, self.positions = full(capacity, EMPTY, int64, self.device), empty(capacity, int32, self.device)
        self.capacity, self.mask = capacity, capacity - 1

    def append(self, all_keys, count, new_count):
        """Take in the last `new_count` of the first `count` keys of a device array; grows by itself."""
        if new_count == 0:
            return
        first = count - new_count
        if 2 * count > self.capacity:
            self._allocate(1 << (4 * count - 1).bit_length())
            first = 0
        launch(insert_keys_kernel, count - first, [all_keys[first:count], self])
        launch(store_positions_kernel, count, [all_keys[:count], self])

    def find(self, wanted):
        """The position of each key of a device array, int32, -1 where it is not in the list; and uint8, 1 there."""
        found, missing = empty(wanted.size, int32, self.device), empty(wanted.size, uint8, self.device)
        launch(find_positions_kernel, wanted.size, [wanted, self, found, missing])
        return found, missing


def list_keys(keys, count):
    """A table of the first `count` keys of a device array."""
    table = HashTable(keys.device)
    table.append(keys, count, count)
    return table


@func
def find_slot(key: int64, table: HashTable) -> int:
    """The first slot of a key's probe that holds it or a larger one: keys ascend along the probe."""
    slot = mix_bits(key) & table.mask
    while table.keys[int(slot)] < key:
        slot = (slot + int64(1)) & table.mask
    return int(slot)


@func
def find_position(key: int64, table: HashTable) -> int:
    """The position stored for a key, or -1."""
    slot = find_slot(key, table)
    found = int(-1)
    if table.keys[slot] == key:
        found = table.positions[slot]
    return found


@kernel
def insert_keys_kernel(new_keys: array(dtype=int64), table: HashTable):
    """Put each key into the first slot of its probe that holds a larger one, and carry that one on."""
    i = tid()
    key = new_keys[i]
    slot = mix_bits(key) & table.mask
    carrying = int(1)
    while carrying == 1:
        old = atomic_min(table.keys, int(slot), key)  # settles which of two keys stays: the smaller
        if old == key or old == int64(EMPTY):
            carrying = 0
        else:
            if old > key:
                key = old
            slot = (slot + int64(1)) & table.mask


@kernel
def store_positions_kernel(all_keys: array(dtype=int64), table: HashTable):
    """Store each key's position beside it."""
    i = tid()
    table.positions[find_slot(all_keys[i], table)] = i


@kernel
def find_positions_kernel(
    wanted: array(dtype=int64), table: HashTable, found: array(dtype=int32), missing: array(dtype=uint8)
):
    """The position of each wanted key, or -1; and 1 where it is missing."""
    i = tid()
    position = find_position(wanted[i], table)
    absent = int(0)
    if position < 0:
        absent = 1
    found[i] = position
    missing[i] = uint8(absent)


@kernel
def number_new_kernel(missing: array(dtype=int32), first: int, found: array(dtype=int32)):
    """The i-th missing key stands at position first + i."""
    i = tid()
    found[missing[i]] = first + i


def number_new(missing, first, found):
    """Give the keys at the places `missing` the positions from `first` on, in `found`."""
    launch(number_new_kernel, missing.size, [missing, first, found])
