"""A call with an unknown keyword fails with an error that lists the known ones: every public function and method."""

import inspect
import pickle
import warnings
from importlib.util import find_spec
from types import ModuleType, SimpleNamespace

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.attribute_hints import internal_names
from pointloom.core.serialized import CallLock

UNKNOWN = "no_such_argument"
# Those of the standard library, and a base class that users derive from and do not call.
LEFT_OUT = {"DepthMaps.count", "DepthMaps.index", "CorrespondenceChecker"}
LEFT_OUT |= {"open3d"} if find_spec("torch") else {"open3d", "torch"}  # the former has its own errors


def public_calls():
    """Each public function, constructor and method of pointloom's own classes, by name."""
    names = [name for name in loom.__all__ if name not in LEFT_OUT]
    modules = [loom, *(value for name in names if isinstance(value := getattr(loom, name), ModuleType))]
    for module in modules:
        for name in set(module.__all__) - LEFT_OUT:
            value = getattr(module, name)
            if isinstance(value, ModuleType) or (isinstance(value, type) and issubclass(value, BaseException)):
                continue
            if callable(value):
                yield name, value
            for method in dir(value) if isinstance(value, type) else ():
                member = inspect.getattr_static(value, method)
                if method.startswith("_") or method in internal_names(value):
                    continue
                if inspect.isfunction(member):
                    yield f"{name}.{method}", member.__get__(SimpleNamespace(_lock=CallLock()))
                elif isinstance(member, classmethod | staticmethod):
                    yield f"{name}.{method}", getattr(value, method)


CALLS = {
    name: call
    for name, call in public_calls()
    if name not in LEFT_OUT and not any(p.kind is p.VAR_KEYWORD for p in inspect.signature(call).parameters.values())
}


def test_the_calls_are_all_of_the_library():
    assert len(CALLS) > 800  # 824 on 29 November 2026


def test_an_unknown_keyword_is_answered_by_the_known_ones():
    faults = []
    for name, call in CALLS.items():
        try:
            call(**{UNKNOWN: 1})
        except TypeError as error:
            parameters = inspect.signature(call).parameters.values()
            known = ", ".join(p.name for p in parameters if p.kind is not p.VAR_POSITIONAL) or "none"
            if f"has no argument '{UNKNOWN}'" not in str(error) or not str(error).endswith(f"it takes {known}"):
                faults.append(f"{name}: {error}")
        else:
            faults.append(f"{name}: no error")
    assert not faults, "\n".join(faults)


def test_single_numbers_in_place_of_a_vector_are_answered_by_the_call_with_a_list():
    cloud, mesh = loom.PointCloud(np.eye(3)), loom.TriangleMesh.create_box()
    box = loom.AxisAlignedBoundingBox((0, 0, 0), (1, 1, 1))
    for shape in (cloud, mesh, box, box.get_oriented_bounding_box()):
        with pytest.raises(TypeError, match=r"as one list: translate\(\[1, 0, 0\]\)$"):
            shape.translate(1, 0, 0)
    for shape in (cloud, mesh):
        with pytest.raises(TypeError, match=r"as one list: paint_uniform_color\(\[0\.5, 0, 0\]\)$"):
            shape.paint_uniform_color(0.5, 0, 0)
    with pytest.raises(TypeError, match=r"AxisAlignedBoundingBox\(\[0, 0, 0\], \[1, 1, 1\]\)$"):
        loom.AxisAlignedBoundingBox(0, 0, 0, 1, 1, 1)
    with pytest.raises(TypeError, match=r"\(bounding_box, invert\), got 6$"):
        cloud.crop(0, 0, 0, 1, 1, 1)


def test_a_type_error_inside_a_function_is_unchanged():
    with pytest.raises(TypeError) as error:
        loom.asnumpy(object())
    assert "it takes" not in str(error.value)


def test_public_functions_and_results_can_be_pickled():
    for call in (loom.asnumpy, loom.registration.registration_icp, loom.PointCloud, loom.meshing.marching_cubes):
        assert pickle.loads(pickle.dumps(call)) is call
    intrinsic = loom.PinholeCameraIntrinsic(16, 12, 10.0, 10.0, 8.0, 6.0)
    assert pickle.loads(pickle.dumps(intrinsic)) == intrinsic


def test_warnings_refer_to_the_line_of_the_call():
    far = np.array([[0, 0, 0], [1e9, 0, 0]])
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        loom.PointCloud(far).voxel_down_sample(1e-7)
    assert {warning.filename for warning in caught} <= {__file__}
