"""Text of docs/open3d-names.md: each name of the installed Open3D, its equivalent in pointloom, and in the bridge.

`scripts/write_open3d_names.py` writes the page. A test compares the stored page with this text.
"""

from __future__ import annotations

import importlib
import inspect
from collections.abc import Iterator
from types import ModuleType
from typing import Any, NamedTuple

import pointloom as loom
from pointloom.core.open3d_names import SHAPES, row_of
from pointloom.registration.result import RegistrationResult

HOMES = {  # module of Open3D -> preferred module of pointloom
    "geometry": loom, "geometry.keypoint": loom, "io": loom, "io.rpc": loom, "camera": loom, "utility": loom,
    "utility.random": loom, "visualization": loom, "visualization.app": loom, "visualization.gui": loom,
    "visualization.rendering": loom, "visualization.webrtc_server": loom,
    "pipelines.registration": loom.registration, "pipelines.odometry": loom.odometry, "pipelines.integration": loom,
    "pipelines.color_map": loom.color_map, "t.geometry": loom, "t.io": loom,
    "t.pipelines.registration": loom.registration, "t.pipelines.registration.robust_kernel": loom.registration,
    "t.pipelines.odometry": loom.odometry, "t.pipelines.slac": loom.reconstruction, "t.pipelines.slam": loom.slam,
}  # fmt: skip
CLASSES = {  # class of Open3D -> class of pointloom, or None if only the rows of the table describe its members
    "geometry.PointCloud": loom.PointCloud, "geometry.TriangleMesh": loom.TriangleMesh,
    "geometry.LineSet": loom.LineSet, "geometry.AxisAlignedBoundingBox": loom.AxisAlignedBoundingBox,
    "geometry.OrientedBoundingBox": loom.OrientedBoundingBox, "geometry.Image": None,
    "geometry.RGBDImage": loom.RGBDImage, "geometry.VoxelGrid": loom.VoxelGrid,
    "geometry.KDTreeFlann": loom.NearestNeighborSearch, "camera.PinholeCameraIntrinsic": loom.PinholeCameraIntrinsic,
    "camera.PinholeCameraTrajectory": loom.Trajectory,
    "pipelines.registration.RegistrationResult": RegistrationResult,
    "pipelines.registration.FastGlobalRegistrationOption": loom.registration.FastGlobalRegistrationOption,
    "pipelines.registration.PoseGraph": loom.registration.PoseGraph,
    "pipelines.registration.PoseGraphEdge": loom.registration.PoseGraphEdge,
    "pipelines.registration.GlobalOptimizationOption": loom.registration.GlobalOptimizationOption,
    "pipelines.registration.GlobalOptimizationConvergenceCriteria":
        loom.registration.GlobalOptimizationConvergenceCriteria,
    "pipelines.odometry.OdometryOption": loom.odometry.OdometryOption,
    "pipelines.integration.ScalableTSDFVolume": loom.TSDFVolume,
    "pipelines.integration.UniformTSDFVolume": loom.TSDFVolume,
    "visualization.Visualizer": loom.Viewer, "visualization.VisualizerWithKeyCallback": loom.Viewer,
    "visualization.RenderOption": None, "visualization.ViewControl": None,
    "visualization.SelectionPolygonVolume": loom.SelectionPolygonVolume,
    "t.geometry.PointCloud": loom.PointCloud, "t.geometry.TriangleMesh": loom.TriangleMesh,
    "t.geometry.LineSet": loom.LineSet, "t.geometry.AxisAlignedBoundingBox": loom.AxisAlignedBoundingBox,
    "t.geometry.OrientedBoundingBox": loom.OrientedBoundingBox, "t.geometry.RGBDImage": loom.RGBDImage,
    "t.geometry.RaycastingScene": loom.RaycastingScene, "t.geometry.VoxelBlockGrid": loom.TSDFVolume,
    "t.pipelines.slam.Model": loom.slam.Model,
}  # fmt: skip
KINDS = {"Visualizer": ("Visualizer",), "VisualizerWithKeyCallback": ("Visualizer",)}  # classes whose rows also apply
NO_NAMES = {"m", "n", "capsule", "open3d", "name", "value"}  # artifacts of its bindings
GUI = ("visualization.gui", "visualization.rendering", "visualization.app", "visualization.webrtc_server", "io.rpc")
IN_T = "; one class, on any device"
HEAD = """# Every name of Open3D

Generated from Open3D {version} by `.venv/bin/python scripts/write_open3d_names.py`. Differences between functions of
the same name are listed in [open3d.md](open3d.md).

- *pointloom* is the name with `import pointloom as loom`: "same", another name, or "not here" with a reason or an
  alternative.
- *bridge*: "yes" if `import pointloom.open3d as o3d` has the name as in Open3D, so that a script only needs another
  import.
- Open3D has two versions of each geometry, the second one as `t.geometry` on a chosen device. pointloom has one
  `PointCloud` and one `TriangleMesh` for all devices. The bridge has no `t`.

{counts}
"""


class Entry(NamedTuple):
    """The equivalent of a name of Open3D."""

    name: str
    here: str
    in_bridge: bool

    @property
    def kind(self) -> str:
        """One of "same", "other", "not here"."""
        if self.here.startswith("same"):
            return "same"
        return "not here" if self.here.startswith("not here") else "other"


def public(owner: Any) -> list[str]:
    """The public names of a module or class of Open3D, without submodules."""
    names = [name for name in dir(owner) if not name.startswith("_") and name not in NO_NAMES]
    return [name for name in names if not isinstance(getattr(owner, name), ModuleType)]


def of_path(root: Any, path: str) -> Any:
    """The attribute at a dotted path, or None if it does not exist."""
    for part in path.split("."):
        root = getattr(root, part, None)
    return root


def members(kind: type | None) -> set[str]:
    """The members of a class of pointloom, including attributes of its instances."""
    if kind is None:
        return set()
    annotated = {name for base in kind.__mro__ for name in getattr(base, "__annotations__", {})}
    return {*dir(kind), *annotated, *inspect.signature(kind).parameters, *_documented(kind)}


def _documented(kind: type) -> Iterator[str]:
    """The names under "Attributes:" in the docstring of a class."""
    _, _, rest = (inspect.getdoc(kind) or "").partition("Attributes:\n")
    for line in rest.splitlines():
        if not line.startswith("    "):
            return
        if not line.startswith("     ") and ":" in line:
            yield from line.strip().partition(":")[0].split(", ")


def names_of(open3d: Any, path: str) -> list[Entry]:
    """The equivalent of each name of a module of Open3D."""
    bridge, entries = _bridge(), []
    for name in public(of_path(open3d, path)):
        module = next((owner for owner in (HOMES[path], loom) if hasattr(owner, name)), None)
        row = row_of(name)
        if path in GUI:
            here = row or "not here"
        elif module is not None:
            here = "same" if module is HOMES[path] else f"same, in `{_called(module)}`"
            here += IN_T if path == "t.geometry" else ""
        else:
            here = row or ""
        entries.append(Entry(name, here, hasattr(of_path(bridge, path), name)))
    return entries


def members_of(open3d: Any, path: str) -> list[Entry]:
    """The equivalent of each member of a class of Open3D."""
    kind, name = CLASSES[path], path.rpartition(".")[2]
    known, bridge = members(kind), of_path(_bridge(), path)
    sections = [*KINDS.get(name, ()), *(base.__name__ for base in (kind.__mro__ if kind else ())), name, SHAPES]
    entries = []
    for member in public(of_path(open3d, path)):
        here = "same" if member in known else row_of(member, sections) or ""
        entries.append(Entry(member, here, bridge is not None and member in members(bridge)))
    return entries


def page() -> str:
    """The text of the page.

    Raises:
        ModuleNotFoundError: Open3D is not installed.
    """
    open3d = importlib.import_module("open3d")
    modules = {path: names_of(open3d, path) for path in HOMES}
    classes = {path: members_of(open3d, path) for path in CLASSES}
    parts = [HEAD.format(version=open3d.__version__, counts=_counts(modules, classes))]
    for title, tables in (("Modules", modules), ("Members of the main classes", classes)):
        parts.append(f"## {title}\n")
        for path, entries in tables.items():
            parts.append(f"### open3d.{path}\n\n{_where(path)}\n")
            rows = [f"| `{one.name}` | {_cell(one.here)} | {'yes' if one.in_bridge else ''} |" for one in entries]
            parts.append("\n".join(["| Open3D | pointloom | bridge |", "|---|---|---|", *rows]) + "\n")
    return "\n".join(parts)


def _where(path: str) -> str:
    if path in GUI:
        return "Windows and connections of Open3D. Use `loom.draw` and `loom.Viewer`, or `loom.render` for images."
    if path in CLASSES:
        kind, row = CLASSES[path], row_of(path.rpartition(".")[2])
        return f"In pointloom: `{_called(kind)}`." if kind and _home(kind) else f"In pointloom: {row}."
    return f"In pointloom: `{_called(HOMES[path])}`."


def _counts(*tables: dict[str, list[Entry]]) -> str:
    rows = ["| | names | same | other name or module | not here | in the bridge |", "|---|---|---|---|---|---|"]
    for title, table in zip(("modules", "members"), tables, strict=True):
        all_entries = [one for entries in table.values() for one in entries]
        kinds = [sum(one.kind == kind for one in all_entries) for kind in ("same", "other", "not here")]
        bridged = sum(one.in_bridge for one in all_entries)
        rows.append(f"| {title} | {len(all_entries)} | {' | '.join(map(str, kinds))} | {bridged} |")
    return "\n".join(rows)


def _cell(text: str) -> str:
    return text.replace("|", "\\|").replace("*", "\\*")


def _called(owner: Any) -> str:
    """The name of a module or class of pointloom in code."""
    if owner is loom:
        return "loom"
    if isinstance(owner, ModuleType):
        return f"loom.{owner.__name__.rpartition('.')[2]}"
    return f"{_called(_home(owner))}.{owner.__name__}"


def _home(kind: type) -> Any:
    """The public module of a class of pointloom, or None for a private class."""
    modules = (loom, loom.registration, loom.odometry, loom.slam)
    return next((module for module in modules if hasattr(module, kind.__name__)), None)


def _bridge() -> Any:
    return importlib.import_module("pointloom.open3d")
