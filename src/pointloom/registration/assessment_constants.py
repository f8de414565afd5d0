"""The constants of the assessment of a registration: quantity, unit, and their reason or the data of their fit.

benchmarks/trust/fit_assessment.py prints this table, fits the evidence of `score` again, and measures the error rates.
"""

from typing import Annotated, NamedTuple


class Constant(NamedTuple):
    """Description of a constant. `source`: its reason, or the data and the date of its fit. No unit: a pure number."""

    quantity: str
    source: str
    unit: str = ""


MATCH, VOXEL, SIGMA, NOISE = "match distances", "voxels", "standard deviations", "that of independent pairs"
CHOSEN = "chosen, not fitted"
ODDS = "fitted: 580 ICP poses of objects, rooms and streets that overlap by 15 %, 2026-11-20"
ROOMS = "fitted: benchmarks/beliefs.py, 33 wrong and 235 correct poses, 2026-11-25"
BOXES = "fitted: benchmarks/box_rooms.py, rooms 0 to 15, 2026-11-25"
WRONG_BOXES = "fitted: supported wrong poses of benchmarks/box_rooms.py; kitchens and hills are correct, 2026-11-22"
IMAGES = "fitted: depth images of a kitchen and of benchmarks/trust/places.py, seeds 60 to 62, 2026-11-26"
SCANS = "fitted: 24 rooms, 60 sites, 40 streets, 40 divided real scans of benchmarks/trust/calibration.py, 2026-11-26"
REFINED = "fitted: ICP poses of 24 pairs of scans, rooms and objects, 2026-11-27"
LEAST_FRACTION = f"{REFINED}: 574 correct ones from 0.23, 112 of clouds that share nothing up to 0.10"
OPEN_MOTIONS = f"{REFINED}: 14 of 1,587 correct ones are below it, a bare corridor has 0.003"
SUPPORTED = f"{REFINED}: none of 513 correct ones is unsupported, 32 of 34 wrong ones are"
FEW = "fitted: 29 wrong poses up to 4.3, 75 of 76 correct ones from 4.5, 2026-11-22"
SENSORS = "fitted: kitchen frames 0 to 149, handheld LiDAR scans 0 to 87 (benchmarks/trust/sensor_pairs.py), 2026-11-29"
PAIRS = "fitted: 93 correct poses of the fitted half of benchmarks/trust/alignment.py, 2026-11-27"
WALLS = "fitted: bare corridors and tunnels 0.0001 to 0.03; streets, halls, woods 0.02 to 0.3, 2026-11-22"
BLOCKED = "fitted: LiDAR and moving cameras up to 0.013, half of the wrong poses above 0.02, 2026-11-25"
PLACES = "fitted: benchmarks/trust/fit_assessment.py, rooms, sites, streets and real scans, seeds 0 to 11, 2026-11-28"
FEATURES = (
    "fitted: depth images of a kitchen (every 15th) and of benchmarks/trust/places.py, seeds 60 to 63, 2026-11-29"
)
RELIEFS = f"{FEATURES}: 34 of 35 correct ones from 0.93, wrong ones up to 0.88"
OPEN_SITES = "fitted: three synthetic corridors, a tunnel, a field; doors of 6 cm and far boxes, 2026-11-25"

# Surfaces
MATCH_VOXELS: Annotated[float, Constant("match distance", "usual for downsampled clouds", VOXEL)] = 1.5
NORMAL_RADIUS: Annotated[float, Constant("radius for normals", "28 voxels of a plane", VOXEL)] = 3.0
SIDE_RADIUS: Annotated[float, Constant("radius for sides of normals", "beyond the radius for normals", VOXEL)] = 5.0
SURFACE_DISTANCE: Annotated[float, Constant("distance within which surfaces should match", CHOSEN, MATCH)] = 4.0
MIN_NORMAL_COSINE: Annotated[
    float, Constant("normal cosine of a match", "30 degrees: most correct ones differ by less")
] = 0.866
MIN_MATCHES: Annotated[int, Constant("matches below which they may be chance", CHOSEN)] = 30
SOURCE_VOXEL_FACTOR: Annotated[float, Constant("source voxel", "avoids aligned grids", "target voxels")] = 0.8
FINE_VOXEL_FACTOR: Annotated[float, Constant("voxel of displacements", CHOSEN, "voxels of the score")] = 0.5
MAX_DISTORTION: Annotated[float, Constant("deviation of R R^T from identity", "beyond: a scale, 5 mm in 1 km")] = 1e-5

# Score: agreement of all matches
MIN_SCORE: Annotated[float, Constant("score up to which a pose is rejected", "even odds")] = 0.5
MAX_NORMAL_DISTANCE: Annotated[float, Constant("normal distance at which a match counts 0", "0.3 voxels", MATCH)] = 0.2
OVERLAP_RIDGE: Annotated[float, Constant("overlap ridge", "weak overlap is no evidence", "mean eigenvalue")] = 1e-3
FRACTION_WEIGHT: Annotated[float, Constant("log odds per ln(fraction)", ODDS)] = 5.15
FIRMNESS_WEIGHT: Annotated[float, Constant("log odds per ln(firmness)", ODDS)] = 0.48
ODDS_BIAS: Annotated[float, Constant("log odds", f"{ODDS}; lowered to require 25 % more than even evidence")] = 10.2
FRACTION_FLOOR: Annotated[float, Constant("added to the fraction", "the logarithm of 0 is none")] = 0.01
FIRMNESS_FLOOR: Annotated[float, Constant("added to the firmness", "the logarithm of 0 is none")] = 3e-4
MIN_FIRMNESS: Annotated[float, Constant("minimum firmness", "planes, spheres, tubes: at most a quarter of it")] = 0.002
FITTING_FRACTION: Annotated[float, Constant("matching fraction although a motion is undetermined", CHOSEN)] = 0.5
# Score: number of matches
MATCH_CHANCE: Annotated[float, Constant("fraction times the root of the matches", FEW)] = 4.4
LIMIT_STEEPNESS: Annotated[float, Constant("steepness of a score", "20 % beyond the limit give 0.67")] = 4.0
# Score: matches beside the three main planes
MIN_REST: Annotated[float, Constant("fraction beside the planes relative to the total", ROOMS)] = 0.25
MIN_ALIGNED: Annotated[float, Constant("the same, if parallel to the planes", BOXES)] = 0.18
SOME_ALIGNED: Annotated[float, Constant("parallel fraction from which this limit sets in", BOXES)] = 0.5
ALL_ALIGNED: Annotated[float, Constant("parallel fraction from which it applies", BOXES)] = 0.75
ENOUGH_BESIDE: Annotated[int, Constant("matches beside the planes", WRONG_BOXES)] = 100
PART_BESIDE: Annotated[float, Constant("the same, relative to all matches", WRONG_BOXES)] = 0.05
FEW_ALIGNED: Annotated[float, Constant("parallel fraction from which their number counts", WRONG_BOXES)] = 0.37
MANY_ALIGNED: Annotated[float, Constant("parallel fraction from which it counts fully", WRONG_BOXES)] = 0.47
# Score: free space
OCCLUSION_MARGIN: Annotated[float, Constant("distance of an occluding surface", CHOSEN, VOXEL)] = 4.0
MAX_BLOCKED: Annotated[float, Constant("occluding points relative to matches", BLOCKED)] = 0.02
# Score: details
MIN_DETAIL: Annotated[float, Constant("fraction beside the planes, within the borders", IMAGES)] = 0.19
DETAIL_CHANCE: Annotated[float, Constant("the same times the root of its matches", IMAGES)] = 1.35
MIN_DETAIL_MATCHES: Annotated[int, Constant("number of these matches", FEATURES)] = 25
MIN_VISIBLE: Annotated[float, Constant("fraction of all matches, within the borders", IMAGES)] = 0.3
VISIBLE_CHANCE: Annotated[float, Constant("the same times the root of the matches", IMAGES)] = 6.0
MIN_RELIEF: Annotated[float, Constant("correlation of the slopes on planes", RELIEFS)] = 0.9
RELIEF_MATCHES: Annotated[int, Constant("number of these slopes", IMAGES)] = 400
MIN_VISIBLE_WITH_RELIEF: Annotated[float, Constant("fraction of all matches with relief", IMAGES)] = 0.45
CONFLICT_SIGMAS: Annotated[float, Constant("contradicting distance", "0.3 % of a normal distribution", SIGMA)] = 3.0
NOISE_RADIUS: Annotated[float, Constant("radius of the noise", "2 voxels", MATCH)] = 4 / 3
# Score: features that agree with the pose of a search, relative to the best other pose
CHANCE_FEATURES: Annotated[int, Constant("features that agree with any pose by chance", FEATURES)] = 10
MANY_FEATURES: Annotated[float, Constant("ratio of features from which less other evidence is needed", FEATURES)] = 1.6
MAX_FEATURE_WEIGHT: Annotated[
    float, Constant("maximum factor of the other evidence", "highest ratio of a wrong pose 4.1")
] = 3.0

# Displacement and covariance
PAIR_RADIUS: Annotated[float, Constant("distance of pairs", "twice the match distance", VOXEL)] = 3.0
BLOCK_VOXELS: Annotated[float, Constant("edge of blocks with correlated errors", CHOSEN, VOXEL)] = 10.0
REWEIGHTING_ITERATIONS: Annotated[int, Constant("reweighted solutions", CHOSEN)] = 5
TO_SIGMA: Annotated[float, Constant("standard deviation", "normal distribution", "median absolute deviations")] = 1.4826
WEIGHT_WIDTH: Annotated[float, Constant("residual of weight 1/4", "5 % of a normal distribution", SIGMA)] = 2.0
MOTION_RIDGE: Annotated[float, Constant("ridge of the step", "for undetermined motions", "matrix of a row")] = 1e-6
MODEL_ERROR: Annotated[float, Constant("error common to all points", SCANS, "residuals")] = 0.005
NORMAL_ERROR: Annotated[float, Constant("the same by biased normals", SCANS, "squared residuals per voxel")] = 0.35
STEP_FACTOR: Annotated[float, Constant("factor of the squared distance from the step", SCANS)] = 1.1
SHARED_POINTS: Annotated[float, Constant("variance of blocks by noise: pairs share points", SENSORS, NOISE)] = 1.5
SENSOR_FACTOR: Annotated[float, Constant("error of the sensor common to all points", SENSORS, "biases of blocks")] = 1.3
COMMON_ERROR: Annotated[float, Constant("the same of lenses and motion, for the test", PAIRS, "residuals")] = 0.09
MAX_DISTANCE: Annotated[float, Constant("distance from the step", "95 % of chi, six degrees of freedom", SIGMA)] = 3.55
MIN_DISPLACEMENT: Annotated[float, Constant("displacement of an unreliable pose", PLACES, VOXEL)] = 0.1
MIN_SUPPORT: Annotated[float, Constant("constraint of the matches relative to the attainable one", CHOSEN)] = 0.05
SUPPORT_RIDGE: Annotated[float, Constant("ridge of this ratio", "for undetermined motions", "mean eigenvalue")] = 0.01

# Undetermined motions
SUSPECT_FRACTION: Annotated[float, Constant("squared component below which a motion is tested", WALLS)] = 0.03
STEP_VOXELS: Annotated[float, Constant("displacement both ways", "half of the match distance", VOXEL)] = 0.75
JUDGING_POINTS: Annotated[int, Constant("sampled points", "detect a mean rise of the cost of 0.01")] = 1024
MIN_RISE: Annotated[float, Constant("mean rise of the cost, 0..1", OPEN_SITES)] = 0.02
MIN_DEVIATIONS: Annotated[float, Constant("the same", OPEN_SITES, SIGMA)] = 3.0
RADIUS_VOXELS: Annotated[float, Constant("search radius of planes", "beyond the displacement", VOXEL)] = 2.0

# Refined poses (`warnings` of ICP and NDT), whose start excludes other places
MIN_OPEN_FRACTION: Annotated[float, Constant("fraction if a motion may be undetermined", LEAST_FRACTION)] = 0.15
MAX_OPEN: Annotated[float, Constant("squared component of an undetermined motion", OPEN_MOTIONS)] = 5e-3
MIN_PAIRS: Annotated[int, Constant("pairs that decide about support", SUPPORTED)] = 1000
PLANE_MOTIONS: Annotated[int, Constant("undetermined motions of few matches", "as many as of a plane")] = 3
