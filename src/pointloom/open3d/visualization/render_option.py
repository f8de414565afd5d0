"""RenderOption: the appearance of a window, with assignable fields."""

from __future__ import annotations

import enum
import json
from dataclasses import dataclass, field, fields
from typing import Any

import numpy as np

from ...core.atomic import atomic_write
from ...core.attribute_hints import KnownNames
from ...core.checks import check_color, check_count, check_positive, shown
from ...core.errors import FilePath, values_of_file
from ...core.json_files import check_keys, check_version, read_json_object


class PointColorOption(enum.Enum):
    Default, Color, XCoordinate, YCoordinate, ZCoordinate, Normal = 0, 1, 2, 3, 4, 9


class MeshColorOption(enum.Enum):
    """Coloring of meshes. Coordinates and normals are not supported and show the original colors."""

    Default, Color, XCoordinate, YCoordinate, ZCoordinate, Normal = 0, 1, 2, 3, 4, 9


class MeshShadeOption(enum.Enum):
    """Face lighting (Default) or vertex lighting (Color)."""

    Default, Color = range(2)


COLOR_BY = {  # corresponding values of `color_by`
    PointColorOption.Color: "rgb",
    PointColorOption.XCoordinate: "x",
    PointColorOption.YCoordinate: "y",
    PointColorOption.ZCoordinate: "height",
    PointColorOption.Normal: "normal",
}
ENUMS = {
    "point_color_option": PointColorOption,
    "mesh_color_option": MeshColorOption,
    "mesh_shade_option": MeshShadeOption,
}
LIGHT_POWERS = {"diffuse_power": 0.66, "specular_power": 0.2, "specular_shininess": 100.0}
OTHER_KEYS = {  # other keys of Open3D with defaults: it reads a file up to the first missing key
    **{f"light{i}_color": [1.0, 1.0, 1.0] for i in range(4)},
    **{f"light{i}_position": [0.0, 0.0, 2.0 if i < 2 else -2.0] for i in range(4)},
    **{f"light{i}_{name}": value for i in range(4) for name, value in LIGHT_POWERS.items()},
    **{"light_ambient_color": [0.0, 0.0, 0.0], "default_mesh_color": [0.7, 0.7, 0.7]},
    **{"image_max_depth": 3000, "image_stretch_option": 1, "interpolation_option": 0},
}
FILE_VERSION = {"class_name": "RenderOption", "version_major": 1, "version_minor": 0}
IGNORED = OTHER_KEYS.keys() | FILE_VERSION.keys()  # keys of a file that are not read


@dataclass(eq=False, repr=False)
class RenderOption(KnownNames):
    _internal = ("state",)

    background_color: Any = field(default_factory=lambda: np.ones(3))
    point_size: float = 5.0
    line_width: float = 1.0
    light_on: bool = True
    point_show_normal: bool = False
    mesh_show_wireframe: bool = False
    mesh_show_back_face: bool = False
    show_coordinate_frame: bool = False
    point_color_option: PointColorOption = PointColorOption.Default
    mesh_color_option: MeshColorOption = MeshColorOption.Color
    mesh_shade_option: MeshShadeOption = MeshShadeOption.Default

    def __setattr__(self, name: str, value: object) -> None:
        if name == "background_color":
            value = check_color(name, value).copy()
        elif name in ENUMS and not isinstance(value, ENUMS[name]):
            raise TypeError(f"{name}: expected a {ENUMS[name].__name__}, got {type(value).__name__}")
        super().__setattr__(name, value)

    def load_from_json(self, filename: FilePath) -> None:
        """Read a file of `save_to_json` or Open3D. Lights are ignored. Raises FileError."""
        content = read_json_object(filename)
        check_keys(filename, content, required={"class_name"}, optional={one.name for one in fields(self)} | IGNORED)
        check_version(filename, content, FILE_VERSION["class_name"])
        values = {one.name: content[one.name] for one in fields(self) if one.name in content}
        loaded = RenderOption()
        for name, value in values.items():
            with values_of_file(filename, where=f"key {name}"):
                setattr(loaded, name, _checked(name, value, getattr(loaded, name)))
        for name in values:
            setattr(self, name, getattr(loaded, name))

    def save_to_json(self, filename: FilePath) -> None:
        content: dict[str, Any] = {one.name: getattr(self, one.name) for one in fields(self)}
        content |= {name: content[name].value for name in ENUMS}
        content |= {"background_color": content["background_color"].tolist(), **OTHER_KEYS, **FILE_VERSION}
        with atomic_write(filename) as file:
            file.write(json.dumps(content, indent="\t", sort_keys=True).encode() + b"\n")

    def __repr__(self) -> str:
        return "RenderOption"

    def state(self) -> tuple[Any, ...]:
        return tuple(map(str, (getattr(self, one.name) for one in fields(self))))


def _checked(name: str, value: object, default: object) -> Any:
    """A value of JSON in the type of the field."""
    if name in ENUMS:
        return ENUMS[name](check_count(name, value, minimum=0))
    if isinstance(default, bool):
        if not isinstance(value, bool):
            raise TypeError(f"{name}: expected true or false, got {shown(value)}")
        return value
    return check_positive(name, value) if isinstance(default, float) else value
