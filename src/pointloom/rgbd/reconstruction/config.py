"""Configuration of the reconstruction system with Open3D's names, from Python or strictly read JSON files."""

from __future__ import annotations

import dataclasses
import json
import re
from collections.abc import Mapping
from pathlib import PurePosixPath
from typing import Any

from ...cameras.depth_range import OPEN3D_DEPTH_MAX
from ...core.atomic import atomic_write
from ...core.attribute_hints import nearest_name
from ...core.checks import check_count, check_name, check_positive, shown
from ...core.errors import FileError, FilePath
from ...core.escaped_text import escaped
from ...core.json_files import read_json_object

TSDF_RESOLUTION = 512  # voxels per edge of Open3D's cube, `tsdf_cubic_size`
MIN_TRUNCATION = 0.04  # [m] as in Open3D; above depth camera noise at 3 m
TRUNCATION_VOXELS = 4.0
FRAGMENT_VOXELS = 5.0  # per registration voxel: fragments are downsampled to at most a quarter of it

ICP_METHODS = ("point_to_point", "point_to_plane", "color", "generalized")
GLOBAL_METHODS = ("ransac", "fgr", "robust")
ODOMETRY_METHODS = ("hybrid", "intensity", "point_to_plane")

# Aliases: older configurations, and Open3D's tensor system (t_reconstruction_system).
ALIASES = {
    "max_depth": "depth_max",
    "min_depth": "depth_min",
    "max_depth_diff": "depth_diff_max",
    "fragment_size": "n_frames_per_fragment",
    "odometry_loop_interval": "n_keyframes_per_n_frame",
    "odometry_loop_weight": "preference_loop_closure_odometry",
    "odometry_distance_thr": "depth_diff_max",
    "registration_loop_weight": "preference_loop_closure_registration",
    "global_registration_method": "global_registration",
    "icp_voxelsize": "voxel_size",
    "surface_weight_thr": "surface_weight_threshold",
}
# Names of the tensor system only. With one of them `voxel_size` is that of the volume.
_TENSOR_NAMES = frozenset(("icp_voxelsize", "fragment_size", "odometry_loop_interval", "trunc_voxel_multiplier"))
_TENSOR_GROUPS = frozenset(("general", "input", "odometry", "registration", "integration", "slac"))
VALUE_ALIASES = {
    "icp_method": {"colored": "color", "point2point": "point_to_point", "point2plane": "point_to_plane"},
    "odometry_method": {"point2plane": "point_to_plane"},
}
# Ignored: Open3D's parallelization and memory options, and names of files and folders that are not written here.
IGNORED = frozenset(
    (
        *("name", "python_multi_threading", "multiprocessing", "block_count", "est_point_count", "engine"),
        *("debug_mode", "depth_map_type", "device", "depth_folder", "color_folder", "path_color_intrinsic"),
        *("integrate_color", "subfolder_slac", "icp_distance_thr"),
        *("folder_fragment", "folder_scene", "template_global_posegraph"),
    )
)


@dataclasses.dataclass(frozen=True)
class ReconstructionConfig:
    """Options of the reconstruction system. Names and most defaults are Open3D's.

    Args:
        path_dataset: Folder of the frames, for callers. The functions here take a source.
        path_intrinsic: Camera file, likewise.
        depth_min, depth_max: Used depth range [m].
        depth_scale: Stored depth units per meter; None: the source's.
        depth_diff_max: Maximum depth difference of matching pixels in odometry [m].
        odometry_method: "hybrid", "intensity" or "point_to_plane" (always for frames without color).
        n_frames_per_fragment: Maximum frames per fragment.
        n_frames_least: Minimum frames per fragment. Shorter ones are left out and reported.
        n_keyframes_per_n_frame: Frames between keyframes, which are used for loop closures.
        preference_loop_closure_odometry: For the pose graph of a fragment, as `GlobalOptimizationOption`.
        voxel_size: Voxel edge of the fragment registration [m]; refined at a half and a quarter of it.
        global_registration: Open3D's choices are accepted. All mean `registration.register_multiway`.
        icp_method: "point_to_point", "point_to_plane", "color" (point-to-plane without color) or "generalized".
        preference_loop_closure_registration: For the pose graph of the fragments.
        tsdf_cubic_size: 512 voxels [m]: defines the scene's voxel edge if `tsdf_voxel_size` does not.
        tsdf_voxel_size: Voxel edge of the scene's volume [m].
        fragment_voxel_size: Voxel edge of the fragments' volumes [m]; None: a fifth of `voxel_size`.
        sdf_trunc: Truncation of the scene's volume [m]; None: 4 voxels, but at least 4 cm.
        surface_weight_threshold: Minimum weight (exclusive) of the scene's surface; None: by the frames, as `fuse`.
        seed: Selects correspondences if there are very many.
        max_iterations, distance_threshold, fitness_threshold, regularizer_weight, method, save_output_as: Options of
        the non-rigid refinement (SLAC).
        folder_slac: Folder of the refinement's files. It and all `template_` names are relative to the job's folder.

    Raises:
        TypeError, ValueError: A value of another type or out of range; named in the message.

    Example:
        >>> import pointloom as loom
        >>> config = loom.rgbd.ReconstructionConfig(voxel_size=0.1)
        >>> config.n_frames_per_fragment, round(config.volume_voxel_size, 5), config.truncation
        (100, 0.00586, 0.04)
        >>> loom.rgbd.ReconstructionConfig.from_names({"max_depth": 2.0, "icp_method": "color"}).depth_max
        2.0
    """

    path_dataset: str = ""
    path_intrinsic: str = ""
    depth_min: float = 0.3
    depth_max: float = OPEN3D_DEPTH_MAX
    depth_scale: float | None = None
    depth_diff_max: float = 0.07
    odometry_method: str = "hybrid"
    n_frames_per_fragment: int = 100
    n_frames_least: int = 2
    n_keyframes_per_n_frame: int = 5
    preference_loop_closure_odometry: float = 0.1
    voxel_size: float = 0.05
    global_registration: str = "robust"
    icp_method: str = "color"
    preference_loop_closure_registration: float = 5.0
    tsdf_cubic_size: float = 3.0
    tsdf_voxel_size: float | None = None
    fragment_voxel_size: float | None = None
    sdf_trunc: float | None = None
    surface_weight_threshold: float | None = None
    seed: int = 0
    max_iterations: int = 5
    distance_threshold: float = 0.07
    fitness_threshold: float = 0.3
    regularizer_weight: float = 1.0
    method: str = "slac"
    save_output_as: str = "pointcloud"
    folder_slac: str = "slac/"
    template_fragment_posegraph: str = "fragments/fragment_%03d.json"
    template_fragment_posegraph_optimized: str = "fragments/fragment_optimized_%03d.json"
    template_fragment_pointcloud: str = "fragments/fragment_%03d.ply"
    template_global_posegraph_optimized: str = "scene/global_registration_optimized.json"
    template_refined_posegraph: str = "scene/refined_registration.json"
    template_refined_posegraph_optimized: str = "scene/refined_registration_optimized.json"
    template_global_mesh: str = "scene/integrated.ply"
    template_global_traj: str = "scene/trajectory.log"
    template_optimized_posegraph_slac: str = "optimized_posegraph_slac.json"

    def __post_init__(self):
        for field in dataclasses.fields(self):
            value = getattr(self, field.name)
            object.__setattr__(self, field.name, _checked(field.name, value, field.default))
        if self.depth_min >= self.depth_max:
            raise ValueError(f"depth_min: expected less than depth_max, got {self.depth_min} and {self.depth_max}")
        if self.n_frames_least > self.n_frames_per_fragment:
            limits = f"{self.n_frames_least} and {self.n_frames_per_fragment}"
            raise ValueError(f"n_frames_least: expected at most n_frames_per_fragment, got {limits}")
        if self.sdf_trunc is not None and self.sdf_trunc < self.volume_voxel_size:
            raise ValueError(
                f"sdf_trunc: expected at least one voxel ({self.volume_voxel_size:.4g} m), got {self.sdf_trunc} m; "
                "4 voxels are usual"
            )

    @property
    def volume_voxel_size(self) -> float:
        """Voxel edge of the scene's volume [m]."""
        return self.tsdf_voxel_size or self.tsdf_cubic_size / TSDF_RESOLUTION

    @property
    def truncation(self) -> float:
        """Truncation of the scene's volume [m]."""
        return self.sdf_trunc or max(MIN_TRUNCATION, TRUNCATION_VOXELS * self.volume_voxel_size)

    @property
    def fragment_voxel(self) -> float:
        """Voxel edge of the fragments' volumes [m]."""
        return self.fragment_voxel_size or self.voxel_size / FRAGMENT_VOXELS

    @classmethod
    def from_names(cls, names: Mapping[str, Any]) -> ReconstructionConfig:
        """Create a configuration from names and values as in a JSON file, including Open3D's aliases.

        Names of the tensor system are accepted with or without groups. With `icp_voxelsize`, its `voxel_size` is the
        volume's. Options of Open3D's parallelization (`python_multi_threading`, `block_count`, ...) are ignored.

        Raises:
            TypeError, ValueError: An unknown name (with the nearest known one), a duplicate, or an invalid value.
        """
        if not isinstance(names, Mapping):
            raise TypeError(f"names: expected a mapping of names to values, got {type(names).__name__}")
        return cls(**_translated(_flat(names)))

    @classmethod
    def read(cls, path: FilePath) -> ReconstructionConfig:
        """Read the configuration from a JSON file of Open3D or `write`.

        Raises:
            FileError: Unreadable, not JSON, an unknown or duplicate name, or an invalid value.
        """
        content = read_json_object(path)
        try:
            return cls.from_names(content)
        except (TypeError, ValueError) as error:
            raise FileError(path, str(error)) from error

    def to_names(self) -> dict[str, Any]:
        """All names and values, as JSON types."""
        return dataclasses.asdict(self)

    def write(self, path: FilePath, *, overwrite: bool = True) -> None:
        """Write all names and values as JSON, atomically.

        Raises:
            FileError: The file cannot be written, or exists and may not be replaced.
        """
        text = json.dumps(self.to_names(), indent=4) + "\n"
        with atomic_write(path, overwrite=overwrite) as file:
            file.write(text.encode())


_CHOICES = {
    "icp_method": ICP_METHODS,
    "global_registration": GLOBAL_METHODS,
    "odometry_method": ODOMETRY_METHODS,
    "method": ("slac", "rigid"),
    "save_output_as": ("pointcloud", "mesh"),
}
_MAY_BE_NONE = frozenset(("depth_scale", "tsdf_voxel_size", "fragment_voxel_size", "sdf_trunc"))
_MAY_BE_ZERO = frozenset(("depth_min", "regularizer_weight", "fitness_threshold"))


def _checked(name: str, value: object, default: object) -> Any:
    if name == "surface_weight_threshold":
        return None if value is None else check_positive(name, value, allow_zero=True)
    if name in _MAY_BE_NONE:
        return None if value is None else check_positive(name, value)
    if name in _CHOICES:
        if check_name(name, value) not in _CHOICES[name]:
            raise ValueError(f"{name}: expected one of {_CHOICES[name]}, got {shown(value)}")
        return value
    if isinstance(default, int):
        return check_count(name, value, minimum=0 if name == "seed" else 1)
    if isinstance(default, float):
        return check_positive(name, value, allow_zero=name in _MAY_BE_ZERO)
    text = check_name(name, value)
    if name.startswith(("folder_", "template_")):
        _check_path(name, text)
    return text


def _check_path(name: str, text: str) -> None:
    path = PurePosixPath(text)
    if not path.parts or path.is_absolute() or ".." in path.parts:
        raise ValueError(f"{name}: expected a path within the job's folder, got {shown(text)}")
    if name.startswith("template_fragment_") and not re.fullmatch(r"[^%]*%(0?\d)?d[^%]*", text):
        raise ValueError(f"{name}: expected one %03d for the fragment's number, got {shown(text)}")


def _flat(names: Mapping[str, Any]) -> dict[str, Any]:
    flat: dict[str, Any] = {}
    for name, value in names.items():
        inner = value if name in _TENSOR_GROUPS and isinstance(value, Mapping) else {name: value}
        for key in inner:
            if key in flat:
                raise ValueError(f"{escaped(key)}: given twice")
        flat.update(inner)
    return flat


def _translated(names: Mapping[str, Any]) -> dict[str, Any]:
    known = {field.name for field in dataclasses.fields(ReconstructionConfig)}
    of_volume = not _TENSOR_NAMES.isdisjoint(names)
    fields: dict[str, Any] = {}
    origins: dict[str, str] = {}
    for given, value in names.items():
        if given in IGNORED:
            continue
        name = ALIASES.get(given, given)
        if given == "voxel_size" and of_volume:
            name = "tsdf_voxel_size"
        elif given == "trunc_voxel_multiplier":
            name = "sdf_trunc"
        if name not in known:
            near = nearest_name(str(given), [*known, *ALIASES, *IGNORED])
            raise ValueError(f"{escaped(given)}: unknown name in a reconstruction configuration{near}")
        if name in fields:
            raise ValueError(
                f"{escaped(given)}: a second name of {origins[name]}, which is also given; pass one of them"
            )
        choices = VALUE_ALIASES.get(name, {})
        fields[name] = choices.get(value, value) if isinstance(value, str) else value
        origins[name] = given
    if "trunc_voxel_multiplier" in names:
        sizes = {name: fields[name] for name in ("tsdf_voxel_size", "tsdf_cubic_size") if name in fields}
        voxel = ReconstructionConfig(**sizes).volume_voxel_size
        fields["sdf_trunc"] = voxel * check_positive("trunc_voxel_multiplier", names["trunc_voxel_multiplier"])
    return fields
