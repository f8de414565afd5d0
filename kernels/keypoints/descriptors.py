"""Orientations and SIFT descriptors of extrema.

The slopes of a level around an extremum are counted by direction in 36 bins, each by its size and a Gaussian of 1.5
sigma; the first two maxima of at least 0.8 of the highest are orientations. A descriptor counts slopes, by their
direction against the orientation, in 4 x 4 x 8 bins of 3 sigma a side, each slope shared out among the eight nearest
bins. Its numbers are cut off at 0.2 of the length, and stored as the root of each one's share of their sum, times 512
(RootSIFT: distances become those of Hellinger's).

One thread an orientation or descriptor: a feature of sigma s (in pixels of its octave, 2 to 4) reads some 100 s^2
slopes of 16 B for the first and 450 s^2 for the second, at 60 operations each. Angles and weights by polynomials, so
that they are the same bits everywhere: angles to 1e-5 rad, weights to 3e-4 of themselves.

Source: Lowe 2004, sections 5 and 6; Arandjelovic and Zisserman 2012, "Three things everyone should know to improve
object retrieval"; the order of bins is Lowe's, bins and windows are those of VLFeat's sift.c.
"""

from ..algebra.transverse_mercator import sine_and_cosine
from ..array_types import Array1, Array2, Indices
from ..arrays.prefix_sum import exclusive_scan
from ..lang import array, float32, float64, floor, func, int32, kernel, launch, sqrt, tid, uint8, vec2, vec2d, vec4
from ..memory import empty, zeros
from .scale_space import Octave

BINS = 36  # of directions
SMOOTHINGS = 6
SHARE = 0.8  # of the highest bin, that another orientation wants
ORIENTATIONS = 2
SIDE = 4  # cells of a descriptor along each side
TURNS = 8  # directions of a cell
WIDTH = 128  # numbers of a descriptor
CELL = 3.0  # sigma a cell
CUT = 0.2  # of a descriptor's length
SCALE = 512.0  # of the root of a share in a byte
FULL_TURN = 6.283185307179586
HALF_TURN = 3.141592653589793
QUARTER_TURN = 1.5707963267948966
BINS_A_RADIAN = 5.729577951308232  # BINS in a full turn
TURNS_A_RADIAN = 1.2732395447351628  # TURNS in a full turn
BIN_WIDTH = 0.17453292519943295  # [rad]
REACH = 2.5  # cells from the middle to where a slope no longer counts: half a side, and half a cell
MIDDLE = 1.5  # of a descriptor, in cells from the middle of the first


@func
def turn_of(y: float, x: float) -> float:
    """The angle [rad] of a direction, 0 up to a full turn; to 1e-5 (Abramowitz and Stegun 1964, 4.4.49)."""
    a = abs(x)
    b = abs(y)
    most = max(a, b)
    angle = float(0.0)
    if most > 0.0:
        t = min(a, b) / most
        s = t * t
        angle = t * (0.999866 + s * (-0.3302995 + s * (0.180141 + s * (-0.085133 + s * 0.0208351))))
        if b > a:
            angle = float(QUARTER_TURN) - angle
        if x < 0.0:
            angle = float(HALF_TURN) - angle
        if y < 0.0:
            angle = float(FULL_TURN) - angle
    return angle


@func
def weight_at(x: float) -> float:
    """e^-x for x in 0 .. 8."""
    t = x * 0.0625
    p = 1.0 - t * (1.0 - t * (0.5 - t * (0.16666667 - t * (0.041666668 - t * 0.008333334))))
    p = p * p
    p = p * p
    p = p * p
    return p * p


@func
def slope_of(x: int, y: int, first: int, octave: Octave) -> vec2:
    """How brightness grows to the right and downwards at a pixel of the level that begins at `first`."""
    left = max(x - 1, 0)
    right = min(x + 1, octave.width - 1)
    above = max(y - 1, 0)
    below = min(y + 1, octave.height - 1)
    across = octave.levels[first + y * octave.stride + right] - octave.levels[first + y * octave.stride + left]
    along = octave.levels[first + below * octave.stride + x] - octave.levels[first + above * octave.stride + x]
    return vec2(across / float(right - left), along / float(below - above))


@func
def smooth_bins(base: int, bins: array(dtype=float32)):
    """The bins of an extremum, from `base` on, become means of three, six times over; the last is beside the first."""
    smoothings = int(SMOOTHINGS)
    for _ in range(smoothings):
        begin = bins[base]
        before = bins[base + BINS - 1]
        for k in range(BINS):
            here = bins[base + k]
            after = begin
            if k < BINS - 1:
                after = bins[base + k + 1]
            bins[base + k] = (before + here + after) / 3.0
            before = here


@kernel
def find_orientations_kernel(
    octave: Octave,
    places: array(dtype=vec4),
    rows: array(dtype=int32),
    bins: array(dtype=float32),
    turns: array(dtype=vec2),
    counts: array(dtype=int32),
):
    """Up to two orientations [rad] of each extremum, and how many there are."""
    i = tid()
    place = places[rows[i]]
    sigma = place[2] * 1.5
    reach = max(int(floor(3.0 * sigma)), 1)
    middle_x = int(floor(place[0] + 0.5))
    middle_y = int(floor(place[1] + 0.5))
    first = int(place[3]) * octave.height * octave.stride
    base = i * BINS
    scale = 1.0 / (2.0 * sigma * sigma)
    limit = float(reach * reach) + 0.6
    for y in range(max(middle_y - reach, 0), min(middle_y + reach, octave.height - 1) + 1):
        for x in range(max(middle_x - reach, 0), min(middle_x + reach, octave.width - 1) + 1):
            dx = float(x) - place[0]
            dy = float(y) - place[1]
            sqdist = dx * dx + dy * dy
            if sqdist < limit:
                slope = slope_of(x, y, first, octave)
                size = sqrt(slope[0] * slope[0] + slope[1] * slope[1]) * weight_at(sqdist * scale)
                at = turn_of(slope[1], slope[0]) * BINS_A_RADIAN - 0.5
                low = floor(at)
                part = at - low
                bin = (int(low) + BINS) % BINS
                bins[base + bin] = bins[base + bin] + (1.0 - part) * size
                bin = (bin + 1) % BINS
                bins[base + bin] = bins[base + bin] + part * size
    smooth_bins(base, bins)
    highest = float(0.0)
    for k in range(BINS):
        highest = max(highest, bins[base + k])
    count = 0
    found = vec2(0.0, 0.0)
    for k in range(BINS):
        here = bins[base + k]
        before = bins[base + (k + BINS - 1) % BINS]
        after = bins[base + (k + 1) % BINS]
        if here > float(SHARE) * highest and here > before and here > after and count < ORIENTATIONS:
            off = -0.5 * (after - before) / (after + before - 2.0 * here)
            angle = (float(k) + off + 0.5) * BIN_WIDTH
            if count == 0:
                found[0] = angle
            else:
                found[1] = angle
            count += 1
    turns[i] = found
    counts[i] = count


@kernel
def list_features_kernel(
    octave: Octave,
    places: array(dtype=vec4),
    rows: array(dtype=int32),
    turns: array(dtype=vec2),
    offsets: array(dtype=int32),
    first: int,
    owners: array(dtype=int32),
    features: array(dtype=vec4),
):
    """Each extremum once for each of its orientations: x, y, sigma [px of the picture] and orientation [rad]."""
    i = tid()
    place = places[rows[i]]
    for k in range(offsets[i + 1] - offsets[i]):
        angle = turns[i][0] if k == 0 else turns[i][1]
        to = offsets[i] + k
        owners[to] = rows[i]
        features[first + to] = vec4(place[0] * octave.step, place[1] * octave.step, place[2] * octave.step, angle)


@func
def direction_of(angle: float) -> vec2d:
    """Sine and cosine of an angle of up to a turn or so."""
    quarter = floor(float64(angle) / float64(QUARTER_TURN) + 0.5)
    both = sine_and_cosine(float64(angle) - quarter * float64(QUARTER_TURN))
    turned = both
    k = (int(quarter) + 8) % 4
    if k == 1:
        turned = vec2d(both[1], -both[0])
    if k == 2:
        turned = vec2d(-both[0], -both[1])
    if k == 3:
        turned = vec2d(-both[1], both[0])
    return turned


@func
def reach_in_row(nx: float, ny: float, cosine: float, sine: float) -> vec2:
    """From where to where along a row of pixels its points lie within the cells; (nx, ny) of where the step is 0.

    A step of 1 along the row moves by (cosine, -sine) cells.
    """
    half = REACH
    low = float(-1.0e6)
    high = float(1.0e6)
    if abs(cosine) > 1.0e-6:
        a = (-half - nx) / cosine
        b = (half - nx) / cosine
        low = max(low, min(a, b))
        high = min(high, max(a, b))
    elif abs(nx) > half:
        high = low
    if abs(sine) > 1.0e-6:
        a = (ny + half) / sine
        b = (ny - half) / sine
        low = max(low, min(a, b))
        high = min(high, max(a, b))
    elif abs(ny) > half:
        high = low
    return vec2(low, high)


@kernel
def describe_features_kernel(
    octave: Octave,
    places: array(dtype=vec4),
    owners: array(dtype=int32),
    first: int,
    features: array(dtype=vec4),
    cells: array(dtype=float32, ndim=2),
):
    """The sums of each cell and direction, as Lowe orders them."""
    i = tid()
    place = places[owners[i]]
    angle = features[first + i][3]
    turn = direction_of(angle)
    side = float(CELL) * place[2]
    sine = float(turn[0]) / side
    cosine = float(turn[1]) / side
    reach = int(floor(1.4142135 * side * REACH + 0.5))
    middle_x = int(floor(place[0] + 0.5))
    middle_y = int(floor(place[1] + 0.5))
    level = int(place[3]) * octave.height * octave.stride
    for y in range(max(middle_y - reach, 1), min(middle_y + reach, octave.height - 2) + 1):
        dy = float(y) - place[1]
        dx = float(middle_x) - place[0]
        span = reach_in_row(cosine * dx + sine * dy, cosine * dy - sine * dx, cosine, sine)
        begin = max(max(middle_x + int(floor(max(span[0], float(-reach)))), middle_x - reach), 1)
        end = min(min(middle_x + int(floor(min(span[1], float(reach)))) + 1, middle_x + reach), octave.width - 2)
        for x in range(begin, end + 1):
            dx = float(x) - place[0]
            nx = cosine * dx + sine * dy
            ny = cosine * dy - sine * dx
            at_x = nx + MIDDLE
            at_y = ny + MIDDLE
            if at_x > -1.0 and at_x < float(SIDE) and at_y > -1.0 and at_y < float(SIDE):
                at = level + y * octave.stride + x
                across = 0.5 * (octave.levels[at + 1] - octave.levels[at - 1])
                along = 0.5 * (octave.levels[at + octave.stride] - octave.levels[at - octave.stride])
                size = sqrt(across * across + along * along) * weight_at((nx * nx + ny * ny) * 0.125)
                # against the sense of rotation: Lowe's order of directions
                away = angle - turn_of(along, across)
                if away < 0.0:
                    away += float(FULL_TURN)
                at_turn = away * TURNS_A_RADIAN
                low_x = floor(at_x)
                low_y = floor(at_y)
                low_turn = floor(at_turn)
                part_x = at_x - low_x
                part_y = at_y - low_y
                part_turn = at_turn - low_turn
                cell_x = int(low_x)
                cell_y = int(low_y)
                one = (int(low_turn) + TURNS) % TURNS
                other = (one + 1) % TURNS
                for k in range(4):
                    column = cell_x + k % 2
                    line = cell_y + k // 2
                    if column >= 0 and column < SIDE and line >= 0 and line < SIDE:
                        share = part_x if k % 2 == 1 else 1.0 - part_x
                        share = share * (part_y if k // 2 == 1 else 1.0 - part_y) * size
                        to = (line * SIDE + column) * TURNS
                        cells[i, to + one] = cells[i, to + one] + (1.0 - part_turn) * share
                        cells[i, to + other] = cells[i, to + other] + part_turn * share


@kernel
def store_descriptors_kernel(cells: array(dtype=float32, ndim=2), first: int, descriptors: array(dtype=uint8, ndim=2)):
    """Cut off what stands out, and keep the root of each number's share of the sum."""
    i = tid()
    total = float64(0.0)
    for k in range(WIDTH):
        total += float64(cells[i, k]) * float64(cells[i, k])
    limit = float(CUT) * float(sqrt(total))
    share = float64(0.0)
    for k in range(WIDTH):
        share += float64(min(cells[i, k], limit))
    for k in range(WIDTH):
        value = float(0.0)
        if share > 0.0:
            value = sqrt(min(cells[i, k], limit) / float(share)) * float(SCALE)
        descriptors[first + i, k] = uint8(int(min(floor(value + 0.5), 255.0)))


class OrientedPlaces:
    """Extrema of an octave once for each orientation.

    Args:
        octave: Its levels.
        places: x, y, sigma and level of extrema.
        rows: Those to take.
    """

    def __init__(self, octave: Octave, places: Array1[vec4], rows: Indices) -> None:
        self.octave, self.places, self.rows = octave, places, rows
        device = octave.device
        bins = zeros(rows.size * BINS, float32, device)
        self.turns, counts = empty(rows.size, vec2, device), empty(rows.size, int32, device)
        launch(find_orientations_kernel, rows.size, [octave, places, rows, bins, self.turns, counts])
        self.offsets, self.count = exclusive_scan(counts)  # sync

    def describe(self, first: int, features: Array1[vec4], descriptors: Array2[uint8]) -> None:
        """Write features and descriptors from row `first` on."""
        device = self.octave.device
        owners: Indices = empty(self.count, int32, device)
        listing = [self.octave, self.places, self.rows, self.turns, self.offsets, first, owners, features]
        launch(list_features_kernel, self.rows.size, listing)
        cells = zeros((self.count, WIDTH), float32, device)
        launch(describe_features_kernel, self.count, [self.octave, self.places, owners, first, features, cells])
        launch(store_descriptors_kernel, self.count, [cells, first, descriptors])
