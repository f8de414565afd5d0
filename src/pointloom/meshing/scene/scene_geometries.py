"""Meshes of a ray casting scene and their poses."""

from __future__ import annotations

import warnings
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.attribute_hints import KnownNames
from ...core.checks import check_count, check_rigid, check_rows, is_on_gpu
from ...core.coordinates import NEAR_ZERO
from ...core.devices import DeviceLike, check_same_device, resolve_device
from ...core.gpu_arrays import take_rows
from ...core.other_geometry import conversion_of
from ...core.pickled_arrays import device_like, unpickling
from ...core.serialized import Serialized
from ...kernels.linear_algebra import matmul
from ...kernels.rays.scene_trees import SceneTrees
from ...kernels.rays.triangle_tree import TriangleTree
from ...pcd.point_arrays import PointArrays
from ..mesh.mesh import TriangleMesh
from ..mesh.mesh_arrays import check_mesh
from ..mesh.mesh_checks import find_wrong_corner


class SceneGeometries(Serialized, KnownNames):
    """Meshes of a RaycastingScene. Base of the query mixins.

    A geometry is a posed mesh. `_meshes` and `_trees` store each mesh once, `_mesh_of` maps geometries to meshes, and
    `_poses` are float64 (4, 4) from mesh to scene. Device positions are float32 about the scene's `_origin`, those of a
    mesh about its own `origin`.
    """

    _device: Any
    _meshes: list[TriangleMesh]
    _trees: list[TriangleTree]
    _mesh_of: list[int]
    _poses: list[NDArray[np.float64]]
    _instances: SceneTrees | None  # for the current `_meshes`. Poses are current unless `_is_moved`
    _is_moved: bool

    def __init__(self, device: DeviceLike = None):
        self._device = resolve_device(device)
        self._meshes, self._trees, self._mesh_of, self._poses = [], [], [], []
        self._instances, self._is_moved = None, False

    def __len__(self) -> int:
        return len(self._mesh_of)

    def __repr__(self) -> str:
        triangles = sum(len(mesh) for mesh in self._meshes)
        counts = f"{len(self)} geometries of {len(self._meshes)} meshes, {triangles} triangles"
        return f"{type(self).__name__}({counts}, {self._device})"

    def __copy__(self) -> Self:
        """Independent scene that shares the meshes."""
        scene = type(self)(self._device)
        lists = {"_meshes": self._meshes, "_trees": self._trees, "_mesh_of": self._mesh_of}
        vars(scene).update({name: list(values) for name, values in lists.items()})
        vars(scene)["_poses"] = [pose.copy() for pose in self._poses]
        return scene

    def __deepcopy__(self, memo: dict[int, Any]) -> Self:
        return self.__copy__()  # meshes of a scene are immutable

    def __getstate__(self) -> dict[str, Any]:
        """Meshes and poses for pickle. Trees are rebuilt."""
        return {"device": str(self._device), "meshes": self._meshes, "mesh_of": self._mesh_of, "poses": self._poses}

    def __setstate__(self, state: dict[str, Any]) -> None:
        """Restore on the saved device, or the first GPU if its index does not exist."""
        with unpickling("scene"):
            device, meshes, mesh_of = device_like("scene", state["device"]), state["meshes"], state["mesh_of"]
            for mesh in meshes:
                check_mesh("meshes", mesh)
                check_same_device("meshes", device, mesh.device)
            numbers = [check_count("mesh_of", number, minimum=0, maximum=len(meshes) - 1) for number in mesh_of]
            poses = [check_rigid("poses", pose) for pose in state["poses"]]
            if len(poses) != len(numbers):
                raise ValueError(f"poses: expected one for each of {len(numbers)} geometries, got {len(poses)}")
        self.__init__(device)
        self._meshes, self._mesh_of, self._poses = [*meshes], numbers, poses
        self._trees = [TriangleTree(mesh.arrays["vertices"], mesh.arrays["triangles"]) for mesh in self._meshes]

    @property
    def device(self) -> Any:
        """Device of the scene."""
        return self._device

    def add_triangles(self, mesh: Any, triangles: Any = None, *, pose: ArrayLike | None = None) -> int:
        """Add a mesh. Returns the id of the new geometry: 0, 1, ...

        Args:
            mesh: A TriangleMesh on the scene's device, whose arrays are shared; or vertices [m], shape (m, 3).
            triangles: Vertex indices, shape (t, 3), if `mesh` is vertices.
            pose: Rigid motion (4, 4) from mesh to scene. If None: identity.

        Raises:
            TypeError: If `mesh` has another type, or the triangles are not integers.
            ValueError: If a shape or index is invalid, or the pose is not rigid.
            DeviceError: If the mesh is on another device.

        Warns:
            UserWarning: If triangles with a corner that is not finite are ignored. Other ids stay unchanged.

        Example:
            >>> import pointloom as loom
            >>> scene = loom.RaycastingScene()
            >>> scene.add_triangles([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
            0
        """
        if isinstance(mesh, TriangleMesh):
            if triangles is not None:
                raise TypeError("triangles: expected None with a mesh. Pass vertices and triangles, or a mesh alone")
            check_same_device("mesh", self._device, mesh.device)
            added = mesh.copy()
        else:
            if triangles is None or isinstance(mesh, PointArrays):
                given = f"{type(mesh).__name__}{conversion_of(mesh, expected='mesh')}"
                raise TypeError(f"mesh: expected a TriangleMesh, or vertices and triangles, got {given}")
            vertices = take_rows("mesh", mesh, 3, self._device) if is_on_gpu(mesh) else check_rows("mesh", mesh, 3)
            added = TriangleMesh(vertices, triangles, device=self._device)
        T = np.eye(4) if pose is None else check_rigid("pose", pose)
        if (wrong := find_wrong_corner(added)) is not None:
            message = f"mesh: {wrong}; such triangles are ignored, so distances and occupancy refer to an open surface"
            warnings.warn(message, UserWarning, stacklevel=2)
        self._trees.append(TriangleTree(added.arrays["vertices"], added.arrays["triangles"]))
        self._meshes.append(added)
        return self._add_instance(len(self._meshes) - 1, T)

    def add_instance(self, geometry_id: int, pose: ArrayLike | None) -> int:
        """Add another instance of a mesh, which shares its triangles. Returns its geometry id.

        Args:
            geometry_id: A geometry of that mesh.
            pose: Rigid motion (4, 4) from mesh to scene.

        Raises:
            TypeError, ValueError: If the id is not an integer or unknown, or the pose is not rigid.

        Example:
            >>> import numpy as np
            >>> import pointloom as loom
            >>> scene = loom.RaycastingScene()
            >>> first = scene.add_triangles([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
            >>> shift = np.eye(4)
            >>> shift[2, 3] = -2
            >>> second = scene.add_instance(first, shift)
            >>> scene.list_intersections([[0.2, 0.2, 1, 0, 0, -1]])["t_hit"].tolist()
            [1.0, 3.0]
        """
        return self._add_instance(self._mesh_of[self._known("geometry_id", geometry_id)], check_rigid("pose", pose))

    def set_pose(self, geometry_id: int, pose: ArrayLike | None) -> None:
        """Set the pose of a geometry. Mesh trees are not rebuilt.

        Args:
            geometry_id: The geometry.
            pose: Rigid motion (4, 4) from mesh to scene.

        Raises:
            TypeError, ValueError: If the id is not an integer or unknown, or the pose is not rigid.

        Example:
            >>> import numpy as np
            >>> import pointloom as loom
            >>> scene = loom.RaycastingScene()
            >>> part = scene.add_triangles([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
            >>> pose = np.eye(4)
            >>> pose[2, 3] = -4
            >>> scene.set_pose(part, pose)
            >>> scene.cast_rays([[0.2, 0.2, 1, 0, 0, -1]])["t_hit"].tolist()
            [5.0]
        """
        number, T = self._known("geometry_id", geometry_id), check_rigid("pose", pose)
        self._poses[number] = T.copy()
        self._is_moved = True

    def _known(self, name: str, geometry_id: int) -> int:
        number = check_count(name, geometry_id, minimum=0)
        if number >= len(self):
            raise ValueError(f"{name}: expected a geometry id below {len(self)}, got {number}")
        return number

    def _add_instance(self, mesh: int, pose: NDArray[np.float64]) -> int:
        self._mesh_of.append(mesh)
        self._poses.append(pose.copy())
        self._instances = None
        return len(self) - 1

    @property
    def _origin(self) -> NDArray[np.float64]:
        """Origin of the scene's float32 positions: zero, or that of the first mesh if it is far away."""
        if not self._poses:
            return np.zeros(3)
        anchor = self._meshes[self._mesh_of[0]].origin
        origin = matmul(self._poses[0][:3, :3], anchor) + self._poses[0][:3, 3]
        return origin if anchor.any() or np.abs(origin).max() > NEAR_ZERO else np.zeros(3)

    def _stored_poses(self) -> NDArray[np.float64]:
        """float64 (geometries, 4, 4), from the meshes' float32 vertices to positions about `_origin`."""
        poses = np.array(self._poses).reshape(-1, 4, 4)
        origins = np.array([self._meshes[mesh].origin for mesh in self._mesh_of]).reshape(-1, 3)
        poses[:, :3, 3] += np.einsum("nij,nj->ni", poses[:, :3, :3], origins) - self._origin
        return poses

    def _scene_trees(self) -> SceneTrees:
        """Trees and poses of all meshes, built at the first query after a change."""
        if self._instances is None:
            self._instances = SceneTrees(self._trees, self._mesh_of, self._stored_poses())
        elif self._is_moved:
            self._instances.put(self._stored_poses())
        self._is_moved = False
        return self._instances
