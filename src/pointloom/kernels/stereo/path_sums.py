"""Semi-global matching: costs of all disparities summed along eight paths, with penalties for changes of disparity.

Hirschmueller, "Stereo processing by semiglobal matching and mutual information", PAMI 2008, equations 13 and 14. All
numbers are integers, so the result is bitwise identical on every device. A cell is a pixel at a disparity. `step_rows`
computes costs and both horizontal paths, one thread per row. `step_down` computes three paths from one row to the next,
one launch per row: each row depends on the previous one. Memory: 3 B per cell, read or written are 13 B per cell.
Eight paths take 8 x 6 integer operations per cell, vectorized over LANE_COUNT disparities. On CUDA the lanes of a warp
have the disparities of a pixel.
"""

from ..array_types import Array1, Bytes, Integers
from ..arrays.lanes import min_int_of_lanes
from ..lang import (
    WARP,
    array,
    bit_count,
    compute,
    func,
    int32,
    kernel,
    lane,
    launch,
    sync_lanes,
    tid,
    uint8,
    uint16,
    vector,
)
from ..memory import empty, full
from .census import LANE_COUNT, lanes

SMALL_STEP_PENALTY = 8  # penalty of a change by one disparity (P1)
LARGE_STEP_PENALTY = 32  # penalty of any other change (P2)
MAX_CODE_DISTANCE = 31  # cost without a code, the maximum distance of codes
OUTSIDE_PATH_COST = 200  # path cost beyond the range of disparities: above any other, plus P1 below 256
PATHS_PER_ROW = 3  # from the previous row
COLUMNS_PER_THREAD = 40  # per thread on the CPU
NO_COST = 255  # above any path cost

byte_lanes = vector(LANE_COUNT, uint8)
sum_lanes = vector(LANE_COUNT, uint16)


@func
def least_of(values: lanes) -> int:
    least = int(NO_COST)
    for k in range(LANE_COUNT):
        least = min(least, values[k])
    return least


@func
def least_byte_of(values: byte_lanes) -> int:
    least = int(NO_COST)
    for k in range(LANE_COUNT):
        least = min(least, int(values[k]))
    return least


@func
def path_cost(cost: int, before: array(dtype=uint8), b: int, low: int) -> int:
    """Path cost of a disparity from those `before` the pixel, whose minimum is `low`."""
    near = min(int(before[b - 1]), int(before[b + 1])) + SMALL_STEP_PENALTY
    return cost + min(min(int(before[b]), near), low + LARGE_STEP_PENALTY) - low


@func
def cost_of(code: int, other: int) -> int:
    return min(bit_count(code ^ other) | (((code | other) >> 31) & MAX_CODE_DISTANCE), MAX_CODE_DISTANCE)


@func
def step_path(costs: lanes, before: array(dtype=uint8), b: int, low: int, after: array(dtype=uint8), a: int) -> lanes:
    """`path_cost` of LANE_COUNT disparities."""
    values = lanes(0)
    for k in range(LANE_COUNT):
        values[k] = path_cost(costs[k], before, b + k, low)
    for k in range(LANE_COUNT):
        after[a + k] = uint8(values[k])
    return values


@func
def step_path_of_bytes(
    costs: byte_lanes, before: array(dtype=uint8), b: int, low: int, after: array(dtype=uint8), a: int
) -> byte_lanes:
    """`step_path` with a byte per disparity. All sums are below 256, so a byte is exact.

    Only `step_down` has it: in `step_rows` it takes twice as long as `step_path`.
    """
    values = byte_lanes(uint8(0))
    limit = int(uint8(low + LARGE_STEP_PENALTY))
    for k in range(LANE_COUNT):
        near = int(uint8(min(int(before[b + k - 1]), int(before[b + k + 1])) + SMALL_STEP_PENALTY))
        values[k] = uint8(int(costs[k]) + min(min(int(before[b + k]), near), limit) - low)
    for k in range(LANE_COUNT):
        after[a + k] = values[k]
    return values


@kernel
def step_rows_kernel(
    left: array(dtype=int32),
    right: array(dtype=int32),
    width: int,
    count: int,
    paths: array(dtype=uint8),
    costs: array(dtype=uint8),
    sums: array(dtype=uint16),
):
    """Costs of a row, and the sums of its paths from the left and from the right."""
    y = tid()
    stride = count + LANE_COUNT
    for direction in range(2):
        low = 0
        for k in range(2 * (stride + LANE_COUNT)):
            paths[y * 2 * (stride + LANE_COUNT) + k] = uint8(0)
        for k in range(4):
            row = y * 2 * (stride + LANE_COUNT) + k // 2 * (stride + LANE_COUNT)
            paths[row + LANE_COUNT - 1 + k % 2 * (count + 1)] = uint8(OUTSIDE_PATH_COST)
        for step in range(width):
            x = step
            if direction == 1:
                x = width - 1 - step
            cell = (y * width + x) * count
            opposite = y * (width + count) + width - 1 - x
            code = left[y * width + x]
            here = (2 * y + step % 2) * (stride + LANE_COUNT) + LANE_COUNT
            there = (2 * y + 1 - step % 2) * (stride + LANE_COUNT) + LANE_COUNT
            least = lanes(NO_COST)
            for chunk in range(count // LANE_COUNT):
                d = chunk * LANE_COUNT
                c = lanes(0)
                total = lanes(0)
                if direction == 0:
                    for k in range(LANE_COUNT):
                        c[k] = cost_of(code, right[opposite + d + k])
                    for k in range(LANE_COUNT):
                        costs[cell + d + k] = uint8(c[k])
                else:
                    for k in range(LANE_COUNT):
                        c[k] = int(costs[cell + d + k])
                        total[k] = int(sums[cell + d + k])
                values = step_path(c, paths, here + d, low, paths, there + d)
                for k in range(LANE_COUNT):
                    total[k] = total[k] + values[k]
                    least[k] = min(least[k], values[k])
                for k in range(LANE_COUNT):
                    sums[cell + d + k] = uint16(total[k])
            low = least_of(least)


@step_rows_kernel.on_cuda
def step_rows_in_lanes_kernel(
    left: array(dtype=int32),
    right: array(dtype=int32),
    width: int,
    count: int,
    paths: array(dtype=uint8),
    costs: array(dtype=uint8),
    sums: array(dtype=uint16),
):
    """CUDA variant: a warp per row, a lane per disparity."""
    i = tid()
    y = i // WARP
    stride = count + LANE_COUNT
    both = 2 * (stride + LANE_COUNT)
    n = int(2)
    for direction in range(n):
        for step in range((both + WARP - 1) // WARP):
            k = step * WARP + lane()
            if k < both:
                at = k % (stride + LANE_COUNT)
                paths[y * both + k] = uint8(
                    OUTSIDE_PATH_COST if at == LANE_COUNT - 1 or at == LANE_COUNT + count else 0
                )
        low = 0
        for step in range(width):
            x = step
            if direction == 1:
                x = width - 1 - step
            cell = (y * width + x) * count
            opposite = y * (width + count) + width - 1 - x
            here = (2 * y + step % 2) * (stride + LANE_COUNT) + LANE_COUNT
            there = (2 * y + 1 - step % 2) * (stride + LANE_COUNT) + LANE_COUNT
            least = int(NO_COST)
            sync_lanes()  # path costs of the previous pixel are complete
            for chunk in range((count + WARP - 1) // WARP):
                d = chunk * WARP + lane()
                if d < count:
                    cost = 0
                    total = 0
                    if direction == 0:
                        cost = cost_of(left[y * width + x], right[opposite + d])
                        costs[cell + d] = uint8(cost)
                    else:
                        cost = int(costs[cell + d])
                        total = int(sums[cell + d])
                    value = path_cost(cost, paths, here + d, low)
                    paths[there + d] = uint8(value)
                    sums[cell + d] = uint16(total + value)
                    least = min(least, value)
            low = min_int_of_lanes(least)
        sync_lanes()


@kernel
def step_down_kernel(
    y: int,
    width: int,
    count: int,
    columns: int,
    costs: array(dtype=uint8),
    before: array(dtype=uint8),
    lows_before: array(dtype=int32),
    after: array(dtype=uint8),
    lows_after: array(dtype=int32),
    sums: array(dtype=uint16),
):
    """Add the three paths from the previous row to the sums of a row. A thread has some adjacent columns."""
    i = tid()
    stride = count + LANE_COUNT
    row = width + 2
    for x in range(i * columns, min((i + 1) * columns, width)):
        cell = (y * width + x) * count
        low_left = lows_before[x]
        low_above = lows_before[row + x + 1]
        low_right = lows_before[2 * row + x + 2]
        least_left = byte_lanes(uint8(NO_COST))
        least_above = byte_lanes(uint8(NO_COST))
        least_right = byte_lanes(uint8(NO_COST))
        for chunk in range(count // LANE_COUNT):
            d = chunk * LANE_COUNT
            at = LANE_COUNT + (x + 1) * stride + d
            c = byte_lanes(uint8(0))
            total = sum_lanes(uint16(0))
            for k in range(LANE_COUNT):
                c[k] = costs[cell + d + k]
                total[k] = sums[cell + d + k]
            from_left = step_path_of_bytes(c, before, at - stride, low_left, after, at)
            from_above = step_path_of_bytes(c, before, at + row * stride, low_above, after, at + row * stride)
            from_right = step_path_of_bytes(
                c, before, at + (2 * row + 1) * stride, low_right, after, at + 2 * row * stride
            )
            for k in range(LANE_COUNT):
                added = int(from_left[k]) + int(from_above[k]) + int(from_right[k])
                total[k] = uint16(int(total[k]) + int(uint8(added)))
                least_left[k] = uint8(min(int(least_left[k]), int(from_left[k])))
                least_above[k] = uint8(min(int(least_above[k]), int(from_above[k])))
                least_right[k] = uint8(min(int(least_right[k]), int(from_right[k])))
            for k in range(LANE_COUNT):
                sums[cell + d + k] = total[k]
        lows_after[x + 1] = least_byte_of(least_left)
        lows_after[row + x + 1] = least_byte_of(least_above)
        lows_after[2 * row + x + 1] = least_byte_of(least_right)


@step_down_kernel.on_cuda
def step_down_in_lanes_kernel(
    y: int,
    width: int,
    count: int,
    columns: int,
    costs: array(dtype=uint8),
    before: array(dtype=uint8),
    lows_before: array(dtype=int32),
    after: array(dtype=uint8),
    lows_after: array(dtype=int32),
    sums: array(dtype=uint16),
):
    """CUDA variant: a warp per column, a lane per disparity."""
    i = tid()
    x = i // WARP
    stride = count + LANE_COUNT
    row = width + 2
    cell = (y * width + x) * count
    low_left = lows_before[x]
    low_above = lows_before[row + x + 1]
    low_right = lows_before[2 * row + x + 2]
    least_left = int(NO_COST)
    least_above = int(NO_COST)
    least_right = int(NO_COST)
    for chunk in range((count + WARP - 1) // WARP):
        d = chunk * WARP + lane()
        if d < count:
            at = LANE_COUNT + (x + 1) * stride + d
            cost = int(costs[cell + d])
            from_left = path_cost(cost, before, at - stride, low_left)
            from_above = path_cost(cost, before, at + row * stride, low_above)
            from_right = path_cost(cost, before, at + (2 * row + 1) * stride, low_right)
            after[at] = uint8(from_left)
            after[at + row * stride] = uint8(from_above)
            after[at + 2 * row * stride] = uint8(from_right)
            sums[cell + d] = uint16(int(sums[cell + d]) + from_left + from_above + from_right)
            least_left = min(least_left, from_left)
            least_above = min(least_above, from_above)
            least_right = min(least_right, from_right)
    least_left = min_int_of_lanes(least_left)
    least_above = min_int_of_lanes(least_above)
    least_right = min_int_of_lanes(least_right)
    if lane() == 0:
        lows_after[x + 1] = least_left
        lows_after[row + x + 1] = least_above
        lows_after[2 * row + x + 1] = least_right


@kernel
def clear_paths_kernel(count: int, paths: array(dtype=uint8)):
    """Path costs of zero before the first row and beside the image: a path begins with the cost of its first pixel."""
    i = tid()
    value = 0
    if i % (count + LANE_COUNT) < LANE_COUNT:
        value = OUTSIDE_PATH_COST
    paths[i] = uint8(value)


def sum_paths(left: Integers, right: Integers, width: int, height: int, count: int) -> Array1[uint16]:
    """Sums of the eight path costs (height, width, count), flat.

    `left` has the codes of the left image, (height, width). `right` those of the right image from right to left,
    (height, width + count): pixel x at disparity number d is compared with element width - 1 - x + d.
    """
    device, stride = left.device, count + LANE_COUNT
    costs, sums = empty(width * height * count, uint8, device), empty(width * height * count, uint16, device)
    paths = empty(2 * height * (stride + LANE_COUNT), uint8, device)
    warp = WARP if device.is_cuda else 1
    launch(step_rows_kernel, height * warp, [left, right, width, count, paths, costs, sums])
    columns = 1 if device.is_cuda else COLUMNS_PER_THREAD
    size, rows = PATHS_PER_ROW * (width + 2) * stride + LANE_COUNT, PATHS_PER_ROW * (width + 2)
    for order in (range(height), range(height - 1, -1, -1)):
        states: list[tuple[Bytes, Integers]] = []
        for _ in range(2):
            state = compute(clear_paths_kernel, size, [count], uint8, device)
            states.append((state, full(rows, 0, int32, device)))
        for k, y in enumerate(order):
            arrays = [y, width, count, columns, costs, *states[k % 2], *states[1 - k % 2], sums]
            launch(step_down_kernel, -(-width // columns) * warp, arrays)
    return sums
