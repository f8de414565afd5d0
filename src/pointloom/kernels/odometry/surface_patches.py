"""Surface patches of a map: planes of sufficient accuracy that do not contain their viewing ray.

Points of a ring or a column of a scan fit a plane even if they belong to several surfaces: the tangent plane of the
ring's cone, or the half-plane of the column. Both contain the ray. They move along with the sensor, and fix the pose of
a scan even if the surfaces do not determine its motion.
"""

import numpy as np

from ..algebra.eigen import orthogonal_direction, values_and_smallest_vector
from ..algebra.rigid_solve import rotate
from ..algebra.transform import widen
from ..array_types import Points
from ..lang import array, cross, dot, float64, func, kernel, launch, tid, vec3d, vec3i, vector
from ..linear_algebra import matmul
from ..memory import download, empty
from .local_cells import cell_holding, offset_in_cell
from .map_icp import MAX_FLAT_RATIO
from .pose_probes import ScanProbes, limit_at
from .voxel_map import VoxelMap
from .voxel_map_search import covariance_of, find_nearest_in_map, mean_of, moments_in_map, side_in_order, voxels_around

MIN_POINTS = 6.0  # of a patch
MIN_SQUARED_SINE = 0.01  # squared sine of the angle between a patch and its ray
MIN_SECTORS = 5  # of 8 around a patch's middle: a bent line has 4 at most
INNER_RADIUS_SQUARED = 0.0625  # of the squared radius: nearer points have no clear direction
MAX_POSES = 13  # of a comparison: one, and two along each motion
ROW_SIZE = 7  # of a point: derivatives by rotation and translation, and the distance
MAX_NORMAL_ERROR = 0.005  # squared error [rad^2] of a patch's normal
patch = vector(8, float64)  # normal, middle relative to the nearest point, points, middle eigenvalue [m^2]


@func
def sectors_in_map(center: vec3d, radius: float, u: vec3d, v: vec3d, voxel_map: VoxelMap) -> int:
    """Number of octants about a point, in the plane of two unit vectors, with map points."""
    cell = cell_holding(center, voxel_map.voxel_size)
    position = offset_in_cell(center, cell, voxel_map.voxel_size)
    near = vec3i(1, 1, 1)
    sqradius = radius * radius
    octants = int(0)
    for voxel, shift in voxels_around(cell, position, sqradius, side_in_order, near, 3, voxel_map):
        first = voxel * voxel_map.room
        for slot in range(first, first + voxel_map.counts[voxel]):
            d = widen(voxel_map.offsets[slot] + shift - position)
            sqdist = float(dot(d, d))
            a = dot(d, u)
            b = dot(d, v)
            # without branches, of which half would be mispredicted
            is_beside = (1 if sqdist < sqradius else 0) * (1 if sqdist > INNER_RADIUS_SQUARED * sqradius else 0)
            octant = (1 if a > 0.0 else 0) + (2 if b > 0.0 else 0) + (4 if abs(a) > abs(b) else 0)
            octants = octants | (is_beside << octant)
    count = int(0)
    for k in range(8):
        count += (octants >> k) & 1
    return count


@func
def patch_at(center: vec3d, ray: vec3d, radius: float, voxel_map: VoxelMap) -> patch:
    """The surface patch around a map point, seen along a ray; 0 points if there is none."""
    result = patch(0.0)
    m = moments_in_map(center, radius, 1, voxel_map)
    if m[0] >= MIN_POINTS:
        n = float64(m[0])
        mean = mean_of(m)
        C = covariance_of(m, mean)
        spectrum = values_and_smallest_vector(C)
        is_flat = (
            spectrum[1] > float64(MAX_FLAT_RATIO) * spectrum[2] and spectrum[0] < float64(MAX_FLAT_RATIO) * spectrum[1]
        )
        if is_flat and spectrum[0] < float64(MAX_NORMAL_ERROR) * n * spectrum[1]:
            normal = vec3d(spectrum[3], spectrum[4], spectrum[5])
            incidence = dot(normal, ray)
            if incidence * incidence > float64(MIN_SQUARED_SINE) * dot(ray, ray):
                u = orthogonal_direction(normal)
                if sectors_in_map(center, radius, u, cross(normal, u), voxel_map) >= MIN_SECTORS:
                    result = patch(normal[0], normal[1], normal[2], mean[0], mean[1], mean[2], n, spectrum[1])
    return result


@kernel
def find_patches_kernel(first_pose: int, probes: ScanProbes, rows: array(dtype=float64, ndim=2)):
    """Standardized squared distances of one run of points from the patches at one pose, from `first_pose` on.
    At other poses than 0 only of points with a patch there. Rows of pose 0: the Jacobian, and the distance along the
    normal.
    """
    i = tid()
    count = probes.squares.shape[1]
    runs = (count + probes.run - 1) // probes.run
    k = first_pose + i // runs
    first = (i % runs) * probes.run
    pose = probes.poses[k]
    t = vec3d(pose[0, 3], pose[1, 3], pose[2, 3])
    for j in range(first, first + min(probes.run, count - first)):
        y = rotate(pose, widen(probes.points[j * probes.step]))
        x = y + t
        square = -1.0
        residual = float64(0.0)
        normal = vec3d(0.0, 0.0, 0.0)
        nearest_point = find_nearest_in_map(x, limit_at(k, j, probes), probes.voxel_map)
        if nearest_point[4] >= 0.0:
            r = vec3d(nearest_point[0], nearest_point[1], nearest_point[2])
            at = patch_at(x - r, y, probes.radius, probes.voxel_map)
            if at[6] > 0.0:
                normal = vec3d(at[0], at[1], at[2])
                d = r - vec3d(at[3], at[4], at[5])
                along = dot(d, normal)
                beside = dot(d, d) - along * along
                square = float(along * along / (1.0 + (1.0 + beside / at[7]) / at[6]))
                residual = along
        probes.squares[k, j] = square
        if k == 0:
            turning = cross(y, normal)
            for axis in range(3):
                rows[j, axis] = turning[axis]
                rows[j, 3 + axis] = normal[axis]
            rows[j, ROW_SIZE - 1] = residual


class SurfacePatches:
    """The patches of a map around points of a scan at a pose, about `max_points` ones. One sync.

    `rows` (n, 7) of the points on patches: derivatives of the distance [m] by the rotation [rad] about the sensor and
    by the translation, and the distance. `radius` [m]: of patches. They are searched twice as far.
    """

    def __init__(self, points: Points, max_points: int, voxel_map: VoxelMap, pose: np.ndarray, radius: float) -> None:
        self._probes = ScanProbes(points, max_points, voxel_map, pose[None], radius, MAX_POSES)
        self._all_rows = empty((self._probes.count, ROW_SIZE), float64, points.device)
        launch(find_patches_kernel, self._probes.runs, [0, self._probes, self._all_rows])
        rows = download(self._all_rows)  # sync
        self.rows = rows[rows[:, 3:6].any(axis=1)]

    @property
    def information(self) -> np.ndarray:
        """Sum of the outer products of the derivatives, (6, 6)."""
        return matmul(self.rows[:, :6].T, self.rows[:, :6])

    def cost_changes(self, poses: np.ndarray) -> np.ndarray:
        """As `compare_poses`, with distances from patches in units of their error. The first of at most MAX_POSES
        poses is that of the patches. One sync.
        """
        probes = self._probes
        probes.move_to(poses)
        launch(find_patches_kernel, (len(poses) - 1) * probes.runs, [1, probes, self._all_rows])
        return probes.cost_changes()
