"""Every public call whose first argument is a path refuses anything else by the same error, swapped arguments too."""

import inspect
from types import ModuleType

import pytest

import pointloom as loom

PATHS = ("PathLike", "FilePath")


def public_calls(module, prefix="loom"):
    """Functions, classes and class methods of a package and its public modules, by name."""
    for name in module.__all__:
        value, full = getattr(module, name), f"{prefix}.{name}"
        if isinstance(value, ModuleType):
            if hasattr(value, "__all__"):
                yield from public_calls(value, full)
        elif inspect.isclass(value):
            if not issubclass(value, BaseException):
                yield full, value
            yield from ((f"{full}.{each}", call) for each, call in inspect.getmembers(value, inspect.ismethod))
        elif inspect.isfunction(value):
            yield full, value


def parameters_of(call):
    try:
        return list(inspect.signature(call).parameters.values())
    except ValueError:  # a class without a signature
        return []


def takes_a_path(call):
    first = next(iter(parameters_of(call)), None)
    annotation = "" if first is None else str(first.annotation)
    is_other = any(word in annotation for word in ("None", "Sequence", "Iterable"))
    is_required = first is not None and first.default is first.empty
    return is_required and not is_other and any(kind in annotation for kind in PATHS)


CALLS = {
    name: call
    for name, call in public_calls(loom)
    if takes_a_path(call) and not name.rpartition(".")[2].startswith("_") and ".open3d." not in name
}


@pytest.mark.parametrize("name", CALLS)
def test_invalid_paths_raise_the_same_error(name, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    _, *others = parameters_of(CALLS[name])
    required = [each.name for each in others if each.default is each.empty and each.kind is not each.VAR_KEYWORD]
    given = dict.fromkeys(required, "a.ply")  # where the arguments are swapped, the path is here
    for wrong, kind in ((loom.PointCloud(), "PointCloud"), (7, "int"), (None, "NoneType"), (b"a.ply", "bytes")):
        with pytest.raises(TypeError, match=rf"\w+: expected the path of a file or folder, got a {kind}"):
            CALLS[name](wrong, **given)
    assert list(tmp_path.iterdir()) == []


def test_the_table_has_the_readers_and_writers():
    names = {"read_point_cloud", "write_point_cloud", "read_triangle_mesh", "write_triangle_mesh", "save_picture"}
    names |= {"read_trajectory", "write_trajectory", "open_frames", "registration.read_pose_graph", "TSDFVolume.load"}
    assert {f"loom.{name}" for name in names} <= CALLS.keys()
    assert len(CALLS) > 50
