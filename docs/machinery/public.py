"""Public names of pointloom from its stubs, with their kind and their section in the reference."""

from __future__ import annotations

import dataclasses
import enum
import importlib.util
import inspect
import sys
import types
from functools import cache
from typing import Any
from unittest import mock

import pointloom
from pointloom import public_names
from pointloom.core.attribute_hints import internal_names

# Section of each name of `pointloom` in the reference, by the defining module. The longest match counts.
GROUPS = {
    "pcd": "Clouds",
    "pcd.boxes": "Boxes, hulls, lines, voxels",
    "pcd.convex_hull": "Boxes, hulls, lines, voxels",
    "pcd.line_set": "Boxes, hulls, lines, voxels",
    "pcd.polygon_volume": "Boxes, hulls, lines, voxels",
    "meshing.mesh.voxel_grid": "Boxes, hulls, lines, voxels",
    "io": "Files",
    "io.frames": "Frames of depth cameras",
    "meshing.mesh.mesh_files": "Files",
    "cameras": "Cameras, poses, depth images",
    "meshing": "Meshes and surfaces",
    "meshing.volume": "Frames of depth cameras",
    "rgbd": "Frames of depth cameras",
    "registration": "Registration",
    "photogrammetry": "Photographs",
    "torch": "Networks",
    "pcd.profile": "Terrain",
    "pcd.raster": "Terrain",
    "pcd.terrain": "Terrain",
    "tiling": "Clouds larger than memory",
    "visualization": "Images, recordings, the viewer",
    "core": "Settings, errors, warnings",
}
ORDER = list(dict.fromkeys(GROUPS.values()))
OTHER = "Others"


@dataclasses.dataclass(frozen=True)
class PublicName:
    """A public class or function.

    Attributes:
        name: Full name, as users write it: `pointloom.registration.registration_icp`.
        module: The public module that has it: `pointloom.registration`.
        home: The module that defines it.
        value: Itself.
    """

    name: str
    module: str
    home: str
    value: Any

    @property
    def kind(self) -> str:
        """The directive that documents it."""
        if inspect.isclass(self.value):
            return "exception" if issubclass(self.value, BaseException) else "class"
        return "function" if callable(self.value) else "data"

    @property
    def group(self) -> str:
        """Section in the reference."""
        module = self.home.removeprefix("pointloom.")
        fitting = [prefix for prefix in GROUPS if module == prefix or module.startswith(f"{prefix}.")]
        return GROUPS[max(fitting, key=len)] if fitting else OTHER


def replace_torch() -> None:
    """Make pointloom.torch importable without torch: its reference needs only the names of types."""
    if "torch" not in sys.modules and importlib.util.find_spec("torch") is None:
        sys.modules["torch"] = mock.MagicMock(Tensor=type("Tensor", (), {"__module__": "torch"}))


@cache
def public_modules() -> dict[str, types.ModuleType]:
    """Public modules by public name, `pointloom` first. Each can be imported by this name afterward."""
    modules = {"pointloom": pointloom}
    for name in public_names._read("pointloom"):
        value = getattr(pointloom, name)
        if inspect.ismodule(value):
            modules[f"pointloom.{name}"] = sys.modules.setdefault(f"pointloom.{name}", value)
    return modules


@cache
def names_of(module: str) -> dict[str, PublicName]:
    """The public classes and functions of a public module, in the order of its stub, by their short names."""
    value = public_modules()[module]
    names = {}
    for name, home in _homes(module, value).items():
        thing = getattr(value, name)
        if not inspect.ismodule(thing):
            names[name] = PublicName(f"{module}.{name}", module, getattr(thing, "__module__", home), thing)
    return names


def _homes(module: str, value: types.ModuleType) -> dict[str, str]:
    """Names of a stub, or of the module if it has no stub."""
    package = value.__name__
    try:
        return public_names._read(package)
    except ImportError:
        own = vars(importlib.import_module(package))
        return {
            name: package
            for name, thing in own.items()
            if not name.startswith("_") and callable(thing) and getattr(thing, "__module__", "") == package
        }


@cache
def all_names() -> dict[str, PublicName]:
    """Every public class and function by its full name."""
    return {name.name: name for module in public_modules() for name in names_of(module).values()}


@cache
def by_home() -> dict[str, str]:
    """Public name of each definition of a module: `pointloom.pcd.cloud.PointCloud` is `pointloom.PointCloud`."""
    return {f"{public.home}.{getattr(public.value, '__name__', '')}": name for name, public in all_names().items()}


@cache
def members_of(name: str) -> tuple[str, ...]:
    """The public methods and properties of a public class with a docstring of pointloom, in order of definition."""
    value = all_names()[name].value
    members: list[str] = []
    for owner in value.__mro__:
        if not owner.__module__.startswith("pointloom"):
            continue
        for key, thing in vars(owner).items():
            plain = thing.__func__ if isinstance(thing, classmethod | staticmethod) else thing
            documented = isinstance(plain, types.FunctionType | property) and inspect.getdoc(plain)
            if not key.startswith("_") and documented and key not in {*members, *internal_names(value)}:
                members.append(key)
    return tuple(members)


def first_sentence(text: str | None) -> str:
    """The first sentence of a docstring, in one line."""
    paragraph = " ".join((text or "").strip().split("\n\n")[0].split())
    head, dot, _ = paragraph.partition(". ")
    return f"{head}." if dot else paragraph


def has_example(name: PublicName) -> bool:
    """True if the docstring contains a doctest."""
    return ">>>" in (inspect.getdoc(name.value) or "")


def is_enumeration(name: PublicName) -> bool:
    """True for an enumeration."""
    return inspect.isclass(name.value) and issubclass(name.value, enum.Enum)
