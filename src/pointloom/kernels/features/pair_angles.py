"""The three angles between two points with normals, and their bins.

Rusu, Blodow and Beetz, "Fast point feature histograms (FPFH) for 3D registration", ICRA 2009, section II, as in PCL and
Open3D. The first point is the one whose normal is closer to the line. With offset d, normals a and b, v = (d x a) / |d
x a| and w = a x v:

f0 = atan2(w . b, a . b) over -pi..pi,    f1 = v . b over -1..1,    f2 = (a . d) / |d| over -1..1,

eleven bins each. All zero if d is zero or along a. `quick_bins` uses float32 and reports pairs near a bin edge (about
1e-4), which `exact_bins` decides in float64. Float32 error bounds, with u = 2^-24 and r = |d|^2 |a|^2 / |d x a|^2 >= 1:
f1 21 u r, w . b 29 u r, sector border 37 u r, f2 7 u. The margins are at least 1.7 times that; f1 and f2 count in bins,
5.5 to the unit.
"""

from ..algebra.plain_min_max import larger, smaller
from ..lang import acos, atan2, cross, dot, float64, floor, func, sqrt, vec3, vec3d

BINS_PER_ANGLE = 11
FEATURE_COLUMNS = 33  # bins of all three
ZERO_BIN = 5  # the bin of zero
BIN_BITS = 4
BIN_MASK = 15
UNSURE_BINS = -1
PI_64 = 3.141592653589793

# Sectors of f0 are mirror images in the x axis: borders at 1, 3, 5, 7 and 9 elevenths of pi above it.
COS_1, SIN_1 = 0.9594929736144974, 0.2817325568414297
COS_3, SIN_3 = 0.6548607339452851, 0.7557495743542583
COS_5, SIN_5 = 0.1423148382732851, 0.9898214418809327
COS_7, SIN_7 = -0.4154150130018863, 0.9096319953545184
COS_9, SIN_9 = -0.8412535328311811, 0.5406408174555976

HALF_BINS = 5.5  # bins per unit of f1 and f2
SECTOR_MARGIN = 4.0e-6  # times r
SIDE_MARGIN = 2.0e-5  # [bins] times r
SLOPE_MARGIN = 1.0e-5  # [bins]
TIE_MARGIN = 2.0e-6  # of |d|: which normal is closer to the line. The error 8 u is 5e-7
MAX_SQUARED_NORMAL = 1.00005  # squared normal length above which Open3D's arc cosines are NaN, so it does not swap
MIN_SQUARED_SINE = 1.0e-4  # squared sine between line and normal: smaller makes r too large
MIN_SQUARED_LENGTH = 1.0e-30  # [m^2] squares that underflow are not trusted
FLAT_SLOPE = 0.05  # of |d|: below half a bin of f2 ...
FLAT_COSINE = 0.95  # ... and with w . b below 0.11, this a . b is in the middle sector: both orders give these bins
SAME_LENGTH = 1.0e-6


@func
def quick_bins(d: vec3, n1: vec3, n2: vec3) -> int:
    """Bins of a pair, four bits each, f0 lowest. UNSURE_BINS near an edge. `d` leads from normal `n1` to `n2`."""
    sqdist = dot(d, d)
    along1 = dot(n1, d)
    along2 = dot(n2, d)
    sqlength1 = dot(n1, n1)
    sqlength2 = dot(n2, n2)
    normal_dot = dot(n1, n2)
    side = dot(cross(d, n1), n2)
    ordered = abs(along1) >= abs(along2)
    a = along1 if ordered else -along2
    b = along2 if ordered else -along1
    sqlength = sqlength1 if ordered else sqlength2
    square = sqdist * sqlength
    across = square - a * a  # |d x a|^2
    distance = sqrt(sqdist)
    inverse = 1.0 / sqrt(across)
    ratio = square / across
    f1 = side * inverse * HALF_BINS + HALF_BINS
    f2 = a / distance * HALF_BINS + HALF_BINS
    y = (b * sqlength - normal_dot * a) * inverse
    height = abs(y)
    t1 = COS_1 * height - SIN_1 * normal_dot
    t3 = COS_3 * height - SIN_3 * normal_dot
    t5 = COS_5 * height - SIN_5 * normal_dot
    t7 = COS_7 * height - SIN_7 * normal_dot
    t9 = COS_9 * height - SIN_9 * normal_dot
    sectors = int(t1 > 0.0) + int(t3 > 0.0) + int(t5 > 0.0) + int(t7 > 0.0) + int(t9 > 0.0)
    border = smaller(smaller(smaller(abs(t1), abs(t3)), smaller(abs(t5), abs(t7))), abs(t9))
    seam = height if normal_dot < 0.0 else border
    level1 = floor(f1)
    level2 = floor(f2)
    tie = abs(abs(along1) - abs(along2))
    flat = int(abs(a) < FLAT_SLOPE * distance) + int(normal_dot > FLAT_COSINE)
    alike = int(abs(sqlength1 - sqlength2) < SAME_LENGTH)
    gap = distance if flat + alike == 3 else tie
    # Every comparison is false for NaN, and all of them must be true.
    sure = (
        int(sqdist > MIN_SQUARED_LENGTH)
        + int(across > square * MIN_SQUARED_SINE)
        + int(smaller(border, seam) > SECTOR_MARGIN * ratio)
        + int(abs(f1 - level1 - 0.5) < 0.5 - SIDE_MARGIN * ratio)
        + int(abs(f2 - level2 - 0.5) < 0.5 - SLOPE_MARGIN)
        + int(gap > TIE_MARGIN * distance)
        + int(larger(sqlength1, sqlength2) < MAX_SQUARED_NORMAL)
    )
    bin0 = ZERO_BIN + sectors if y >= 0.0 else ZERO_BIN - sectors
    bin1 = int(smaller(larger(level1, 0.0), 10.0))
    bin2 = int(smaller(larger(level2, 0.0), 10.0))
    bins = bin0 | (bin1 << BIN_BITS) | (bin2 << (2 * BIN_BITS))
    return bins if sure == 7 else UNSURE_BINS


@func
def bin_of(level: float64) -> int:
    """Bin from an angle in bins, clamped."""
    return int(min(max(floor(level), 0.0), 10.0))


@func
def exact_bins(p: vec3, n: vec3, q: vec3, m: vec3) -> int:
    """Bins of a pair in float64, by Open3D's operations."""
    d = vec3d(float64(q[0]), float64(q[1]), float64(q[2])) - vec3d(float64(p[0]), float64(p[1]), float64(p[2]))
    a = vec3d(float64(n[0]), float64(n[1]), float64(n[2]))
    b = vec3d(float64(m[0]), float64(m[1]), float64(m[2]))
    f0 = float64(0.0)
    f1 = float64(0.0)
    f2 = float64(0.0)
    distance = sqrt(dot(d, d))
    if distance > 0.0:
        slope = dot(a, d) / distance
        slope2 = dot(b, d) / distance
        one = float64(1.0)
        # The arc cosine of more than 1 is NaN, which is not greater.
        if abs(slope2) <= one and acos(min(abs(slope), one)) > acos(abs(slope2)):
            a = vec3d(float64(m[0]), float64(m[1]), float64(m[2]))
            b = vec3d(float64(n[0]), float64(n[1]), float64(n[2]))
            d = -d
            slope = -slope2
        v = cross(d, a)
        size = sqrt(dot(v, v))
        if size > 0.0:
            v = v / size
            f0 = atan2(dot(cross(a, v), b), dot(a, b))
            f1 = dot(v, b)
            f2 = slope
    bins = float64(11.0)
    pi = float64(PI_64)
    bin0 = bin_of(bins * (f0 + pi) / (2.0 * pi))
    bin1 = bin_of(bins * (f1 + 1.0) * 0.5)
    bin2 = bin_of(bins * (f2 + 1.0) * 0.5)
    return bin0 | (bin1 << BIN_BITS) | (bin2 << (2 * BIN_BITS))


@func
def resolved_bins(bins: int, p: vec3, n: vec3, q: vec3, m: vec3) -> int:
    """The quick bins, or the exact ones if UNSURE_BINS."""
    resolved = bins
    if bins == UNSURE_BINS:
        resolved = exact_bins(p, n, q, m)
    return resolved
