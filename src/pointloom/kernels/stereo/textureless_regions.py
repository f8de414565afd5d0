"""Textureless regions of an image (4-connected), and the reliable pixels in or within REGION_MARGIN pixels of each."""

from ..array_types import Array1, Device, Indices, Integers, Keys
from ..arrays.prefix_sum import exclusive_scan
from ..arrays.row_numbers import count_numbers
from ..arrays.select import number_rows_kernel, positions_of
from ..arrays.sort import argsort_keys
from ..arrays.union_find import flatten_sets_kernel, unite
from ..lang import array, compute, func, int32, int64, kernel, launch, struct, tid, uint8, vec2
from ..memory import empty, fill, zeros

REGION_MARGIN = 3  # [px] from an untextured pixel
MARGIN_PIXELS = 2 * REGION_MARGIN * (REGION_MARGIN + 1) + 1  # pixels within REGION_MARGIN
MIN_AREA = 64  # [px] minimum area of a region
PIXEL_BITS = 32  # of a pair's key: pixel, below the region


@struct
class TexturelessRegions:
    """Textureless regions: `labels`: lowest pixel of the region or -1; `numbers` at lowest pixels, -1 if too small;
    `pairs` with reliable pixels, ascending, `region << 32 | pixel`, in `firsts`..`lasts` (exclusive).
    """

    labels: array(dtype=int32)
    numbers: array(dtype=int32)
    count: int
    pairs: array(dtype=int64)
    firsts: array(dtype=int32)
    lasts: array(dtype=int32)
    width: int

    def __init__(self, labels: Integers, numbers: Integers, count: int, pairs: Keys, width: int) -> None:
        device = labels.device
        self.labels, self.numbers, self.count, self.pairs, self.width = labels, numbers, count, pairs, width
        self.firsts, self.lasts = zeros(count, int32, device), zeros(count, int32, device)
        launch(bound_pairs_kernel, pairs.size, [pairs, self.firsts, self.lasts])

    @property
    def device(self) -> Device:
        return self.labels.device


@func
def pixel_of(pair: int64) -> int:
    return int(pair & int64(0xFFFFFFFF))


@func
def region_of(pair: int64) -> int:
    return int(pair >> int64(PIXEL_BITS))


@kernel
def label_plain_kernel(judged: array(dtype=vec2), labels: array(dtype=int32)):
    i = tid()
    label = -1
    if judged[i][0] > 0.0:
        label = i
    labels[i] = label


@kernel
def unite_plain_kernel(width: int, labels: array(dtype=int32)):
    i = tid()
    if labels[i] >= 0:
        if i % width + 1 < width and labels[i + 1] >= 0:
            unite(labels, i, i + 1)
        if i + width < labels.shape[0] and labels[i + width] >= 0:
            unite(labels, i, i + width)


@kernel
def mark_regions_kernel(areas: array(dtype=int32), large: array(dtype=uint8)):
    i = tid()
    mark = 0
    if areas[i] >= MIN_AREA:
        mark = 1
    large[i] = uint8(mark)


@func
def region_near(i: int, dx: int, dy: int, width: int, labels: array(dtype=int32), numbers: array(dtype=int32)) -> int:
    """Region number of a neighboring pixel, or -1."""
    x = i % width + dx
    y = i // width + dy
    number = -1
    if x >= 0 and x < width and y >= 0 and y * width + x < labels.shape[0]:
        label = labels[y * width + x]
        if label >= 0:
            number = numbers[label]
    return number


@func
def is_first(
    i: int, dx: int, dy: int, region: int, width: int, labels: array(dtype=int32), numbers: array(dtype=int32)
) -> bool:
    """True if no earlier pixel of the window is in the same region."""
    before = int(0)
    rows = int(dy + REGION_MARGIN + 1)
    for r in range(rows):
        v = r - REGION_MARGIN
        half_width = REGION_MARGIN - abs(v)
        columns = int(2 * half_width + 1)
        for c in range(columns):
            u = c - half_width
            if v < dy or u < dx:
                if region_near(i, u, v, width, labels, numbers) == region:
                    before += 1
    return before == 0


@kernel
def list_near_kernel(
    judged: array(dtype=vec2),
    width: int,
    labels: array(dtype=int32),
    numbers: array(dtype=int32),
    offsets: array(dtype=int32),
    counts: array(dtype=int32),
    keys: array(dtype=int64),
):
    """Count the regions around each reliable pixel, or list them if there are keys."""
    i = tid()
    count = int(0)
    last = -1  # last region found: usually the same, which saves the search
    if judged[i][1] > 0.0:
        rows = int(2 * REGION_MARGIN + 1)
        for r in range(rows):
            dy = r - REGION_MARGIN
            half_width = REGION_MARGIN - abs(dy)
            columns = int(2 * half_width + 1)
            for c in range(columns):
                dx = c - half_width
                region = region_near(i, dx, dy, width, labels, numbers)
                if region >= 0 and region != last:
                    last = region
                    if is_first(i, dx, dy, region, width, labels, numbers):
                        if keys.shape[0] > 0:
                            keys[offsets[i] + count] = (int64(region) << int64(PIXEL_BITS)) | int64(i)
                        count += 1
    if keys.shape[0] == 0:
        counts[i] = count


@kernel
def bound_pairs_kernel(pairs: array(dtype=int64), firsts: array(dtype=int32), lasts: array(dtype=int32)):
    j = tid()
    region = region_of(pairs[j])
    if j == 0 or region_of(pairs[max(j - 1, 0)]) != region:
        firsts[region] = j
    if j == pairs.shape[0] - 1 or region_of(pairs[min(j + 1, pairs.shape[0] - 1)]) != region:
        lasts[region] = j + 1


def find_regions(judged: Array1[vec2], width: int) -> TexturelessRegions | None:
    """Textureless regions from `judged` (pixels). None if none is large enough or has reliable pixels (two syncs)."""
    device, size = judged.device, judged.size
    labels = compute(label_plain_kernel, size, [judged], int32, device)
    launch(unite_plain_kernel, size, [width, labels])
    launch(flatten_sets_kernel, size, [labels])
    areas = count_numbers(labels, size)
    large: Array1[uint8] = empty(size, uint8, device)
    launch(mark_regions_kernel, size, [areas, large])
    roots = positions_of(large)  # sync
    if not roots.size:
        return None
    numbers = areas  # reused
    fill(numbers, -1)
    launch(number_rows_kernel, roots.size, [roots, numbers])
    pairs = _list_pairs(judged, width, labels, numbers, roots)
    return TexturelessRegions(labels, numbers, roots.size, pairs, width) if pairs.size else None


def _list_pairs(judged: Array1[vec2], width: int, labels: Indices, numbers: Integers, roots: Indices) -> Keys:
    device, size = judged.device, judged.size
    counts, none = empty(size, int32, device), empty(0, int64, device)
    launch(list_near_kernel, size, [judged, width, labels, numbers, empty(0, int32, device), counts, none])
    offsets, total = exclusive_scan(counts, largest=MARGIN_PIXELS)  # sync
    keys = empty(total, int64, device)
    if total:
        launch(list_near_kernel, size, [judged, width, labels, numbers, offsets, counts, keys])
    return argsort_keys(keys, PIXEL_BITS + max(1, (roots.size - 1).bit_length()))[0]
