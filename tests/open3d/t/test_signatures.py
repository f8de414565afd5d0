"""Methods of tensor geometries have Open3D's argument names. A name that is missing has a row for its error."""

import inspect
import re

import pytest

import pointloom.open3d
from pointloom.core.open3d_names import SHAPES, row_of

CLASSES = ("TensorMap", "PointCloud", "LineSet", "Image", "RGBDImage", "AxisAlignedBoundingBox", "OrientedBoundingBox")
FUNCTIONS = ("read_point_cloud", "write_point_cloud", "read_image", "write_image")
ROLES = {"self", "arg0", "arg1"}  # names that no caller writes
NOT_TAKEN = {"gaussian_splat_antialias"}


def arguments(thing, name):
    """Argument names of each overload, from the first lines of a docstring."""
    found = re.findall(rf"^(?:\d+\. )?{name}\((.*)\) ->", thing.__doc__ or "", re.MULTILINE)
    names = [[word for word in re.findall(r"(\w+): ", line) if word not in ROLES] for line in found]
    return ["property" if not found else " ".join(overload) for overload in (names or [[]])]


def signatures(o3d, owner):
    parent = o3d.t.io if owner == "io" else getattr(o3d.t.geometry, owner)
    names = FUNCTIONS if owner == "io" else [name for name in dir(parent) if not name.startswith("_")]
    return {name: arguments(getattr(parent, name), name) for name in names}


@pytest.mark.parametrize("owner", [*CLASSES, "io"])
def test_arguments_have_their_names(oracle, owner):
    parent = pointloom.open3d.t.io if owner == "io" else getattr(pointloom.open3d.t.geometry, owner)
    for name, overloads in oracle(f"open3d/t/signatures_{owner}", signatures, owner).items():
        made = inspect.getattr_static(parent, name, None) if owner != "io" else getattr(parent, name)
        is_field = any(name in getattr(base, "__annotations__", {}) for base in getattr(parent, "__mro__", ()))
        if made is None and not is_field:
            assert row_of(name, (*(base.__name__ for base in parent.__mro__), SHAPES)), f"{owner}.{name}: no row"
            continue
        if [*overloads] == ["property"]:
            continue
        taken = inspect.signature(getattr(parent, name)).parameters
        takes_any = any(part.kind is part.VAR_KEYWORD for part in taken.values())
        for overload in overloads:
            assert takes_any or {*overload.split()} - NOT_TAKEN <= {*taken}, f"{owner}.{name}({overload})"
