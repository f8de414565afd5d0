"""Values that no argument expects, and the claim that each is answered by an error that names the argument."""

from __future__ import annotations

import ast
import atexit
import inspect
import re
import shutil
import tempfile
import warnings
import zlib
from collections.abc import Callable, Collection
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any

import numpy as np

import pointloom as loom
from pointloom.core.attribute_hints import internal_names
from pointloom.core.units import NonFiniteWarning
from pointloom.public_names import results_of

# Values that are not numbers, or do not fit in 64 bits: refused wherever a number is expected.
NO_NUMBERS: dict[str, Any] = {
    "a string of digits": "0.1", "a string": "much", "bytes": b"1", "an object": object(), "a list": [1.0],
    "an empty list": [], "a dictionary": {}, "an array of one number": np.array([0.5]), "an array": np.zeros((2, 3)),
    "a complex number": 1j, "10^400": 10**400, "-10^400": -(10**400), "NaN": float("nan"), "-infinity": float("-inf"),
}  # fmt: skip
NUMBERS: dict[str, Any] = {
    "true": True, "infinity": float("inf"), "-1": -1, "0": 0, "a half": 0.5, "2^24": 2**24, "2^31": 2**31,
    "2^32": 2**32, "2^63": 2**63, "2^64": 2**64, "-2^63": -(2**63), "1e-30": 1e-30, "the least float": 5e-324,
    "1e30": 1e30, "the largest float": 1.7e308, "a 32-bit NaN": np.float32("nan"),
    "an array of no dimension": np.array(0.5),
}  # fmt: skip
ARRAYS: dict[str, Any] = {
    "points": np.random.default_rng(1).random((60, 3)),
    "points that are NaN": np.full((60, 3), np.nan),
    "points that are infinite": np.full((60, 3), np.inf),
    "points that are huge": np.full((60, 3), 1e308),
    "points of all sizes": np.geomspace(1e-308, 1e308, 180).reshape(60, 3),
    "three huge numbers": np.array([1e308, -1e308, 1e308]),
    "three NaN": np.full(3, np.nan),
    "a matrix of NaN": np.full((4, 4), np.nan),
    "a huge matrix": np.diag([1e308, 1e308, 1e308, 1.0]),
    "a tiny matrix": np.diag([1e-308, 1e-308, 1e-308, 1.0]),
    "a far motion": np.array([[1, 0, 0, 1e300], [0, 1, 0, -1e300], [0, 0, 1, 0], [0, 0, 0, 1.0]]),
    "strings": np.array(["a", "b"]),
    "objects": np.array([None, object()], object),
    "complex numbers": np.ones((60, 3), complex),
    "ragged lists": [[1.0], [2.0, 3.0]],
    "huge whole numbers": [10**400] * 3,
    "no rows": np.zeros((0, 3)),
    "four dimensions": np.zeros((1, 1, 1, 1)),
}
MODULES = (loom, loom.meshing, loom.photogrammetry, loom.registration, loom.rgbd)
NO_POINTS = loom.PointCloud()
OTHERS: dict[str, Any] = {"nothing": None, "a function": len, "a class": int, "a set": {1}, "a cloud": NO_POINTS}
HOSTILE = NO_NUMBERS | NUMBERS | ARRAYS | OTHERS


def stand_in(name: str, **attributes: Any) -> Any:
    """An object of a class of another library, by its full name, with these attributes."""
    module, _, kind = name.rpartition(".")
    return type(kind, (SimpleNamespace,), {"__module__": module})(**attributes)


TORCH_CPU = stand_in("torch.device", type="cpu", index=None)
NOT_FINITE = {"NaN", "-infinity", "-10^400"}
STRINGS = {"a string", "a string of digits"}
IN_ARRAYS = HOSTILE.keys() - {"nothing", "an object", "a function", "a class"}
ARRAY_TYPES = ("ArrayLike", "NDArray", "Array", "Rows", "Sequence", "Iterable", "Collection", "list", "tuple")
# The values that each type of a signature may accept. The classes of pointloom that are not listed accept none.
ACCEPTED = dict.fromkeys(ARRAY_TYPES, IN_ARRAYS) | {
    "None": {"nothing"}, "bool": {"true"}, "str": STRINGS, "FilePath": STRINGS, "os.PathLike": STRINGS,
    "int": {*NUMBERS}, "float": NUMBERS.keys() | NOT_FINITE, "PointCloud": {"a cloud"}, "DeviceLike": {"nothing"},
    "Mapping": {"a dictionary"},
}  # fmt: skip
PATHS, CALLBACKS = {"path", "folder", "scans"}, {"progress", "callback_after_iteration"}


def _spoiled(points: Any, normals: Any = None) -> loom.PointCloud:
    """A cloud of these points with everything that operations ask for."""
    rng = np.random.default_rng(2)
    count = len(points)
    normals = rng.normal(size=(count, 3)) if normals is None else normals
    return loom.PointCloud(points, normals=normals, colors=rng.random((count, 3)), dopplers=rng.normal(size=count))


def hostile_clouds() -> dict[str, loom.PointCloud]:
    """Clouds that occur in real files: points at infinity, NaN, or so far apart that squares overflow."""
    rng = np.random.default_rng(1)
    good = rng.random((60, 3))
    some, normals = good.copy(), rng.normal(size=(60, 3))
    some[::7], some[3::11] = np.nan, np.inf
    normals[::5], normals[1::9], normals[2::9] = np.nan, 0, 1e30
    far, spread = good + 1e90, good.copy()
    spread[::6] *= 3e37
    return {
        "NaN and infinities among the points": _spoiled(some, normals),
        "all points NaN": _spoiled(np.full((60, 3), np.nan)),
        "a few points farther off than float32 holds the square of": _spoiled(spread),
        "all points that far apart": _spoiled((good - 0.5) * 6e38),
        "points a thousandth of the least float apart": _spoiled(good * 1e-41),
        "all points at one place far away": _spoiled(far),
        "no points": _spoiled(np.zeros((0, 3))),
        "one point": _spoiled(good[:1]),
    }


def ignore_true_warnings() -> None:
    """Ignore the warnings that are right for hostile clouds: random or NaN normals, huge sizes, flat or NaN shapes."""
    for category in (loom.DroppedResultWarning, loom.NormalsWarning, NonFiniteWarning, loom.UnitWarning):
        warnings.simplefilter("ignore", category)
    warnings.filterwarnings("ignore", "cloud: .* so no alpha gives a surface")
    warnings.filterwarnings("ignore", "mesh: triangle .* NaN or infinite")
    warnings.filterwarnings("ignore", "k: .* neighbors join each of the")
    warnings.filterwarnings("ignore", "num_samples: expected .* points, got")
    warnings.filterwarnings("ignore", "edge_length: expected most edges at 4/5 to 4/3")


def warnings_of(call: Callable[[], Any]) -> list[str]:
    """What a call warns of, and what it raises beside the errors that users are promised."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        ignore_true_warnings()
        try:
            result = call()
            if inspect.isgenerator(result):
                list(result)
        except ERRORS:
            pass
        except Exception as error:
            return [f"raw {type(error).__name__}: {str(error)[:200]}"]
    return [f"{w.category.__name__}: {str(w.message)[:100]} ({w.filename}:{w.lineno})" for w in caught]


def accepted_titles(annotation: str) -> set[str]:
    """The hostile values that an argument of this type may accept; all of them if a part of the type is unknown."""
    node, titles = ast.parse(annotation, mode="eval").body, set()
    parts = []
    while isinstance(node, ast.BinOp):
        parts.append(node.right)
        node = node.left
    for part in [*parts, node]:
        name = ast.unparse(part.value if isinstance(part, ast.Subscript) else part)
        if name not in ACCEPTED and not any(inspect.isclass(getattr(module, name, None)) for module in MODULES):
            return {*HOSTILE}
        titles |= ACCEPTED.get(name, set())
    return titles


ERRORS = (ValueError, TypeError, LookupError, loom.PointloomError)


def faults_of(
    call: Callable[..., Any],
    arguments: dict[str, Any],
    name: str,
    *,
    clouds: bool = False,
    finite: bool = True,
    also: str = "",
    number: bool | None = None,
    every: bool = True,
) -> list[str]:
    """Faults of a call for hostile values of one argument, one line each.

    A call is correct if it returns a result or raises a documented error. The message must name the argument, or
    another one that it conflicts with. If the argument is a number, no other type may be accepted. Warnings are faults.

    Args:
        call: The function to call with `arguments`, which are valid.
        name: The argument that each hostile value replaces.
        clouds: The argument accepts only clouds; the error for an array must show how to make one.
        finite: The argument must be finite.
        also: An alternative name of the argument in messages.
        number: The argument is a number. If None: the valid one is.
        every: Try all values; otherwise a third of them, another one for each argument.
    """
    good = arguments[name]
    names = [*arguments, also] if also else [*arguments]
    if name in PATHS:
        names.append("PathLike")  # Python's own words
    pattern = re.compile(rf"\b({'|'.join(names)})\b")
    numbers = NO_NUMBERS if finite else {title: NO_NUMBERS[title] for title in NO_NUMBERS if title not in NOT_FINITE}
    accepted, annotation = {*HOSTILE}, ""
    if parameter := inspect.signature(call).parameters.get(name):
        annotation = f"{parameter.annotation}{' | None' if parameter.default is None else ''}"
        accepted = accepted_titles(annotation)
    is_number = isinstance(good, int | float) and not isinstance(good, bool) if number is None else number
    faults = []
    first = zlib.crc32(" ".join([name, *arguments]).encode())
    for k, (title, value) in enumerate(HOSTILE.items()):
        if not every and (first + k) % 3:
            continue
        if name in CALLBACKS and callable(value):
            continue  # what it raises is the caller's
        where = f"{name} = {title}"
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            ignore_true_warnings()
            warnings.filterwarnings("ignore", "geometries: expected points or faces")  # right of no points
            warnings.filterwarnings("ignore", "almost no depth is confirmed")  # right of a limit of next to nothing
            try:
                result = call(**(arguments | {name: value}))
                if inspect.isgenerator(result):
                    list(result)
            except ERRORS as error:
                if not pattern.search(str(error)) and not isinstance(error, loom.FileError):
                    faults.append(f"{where}: the message does not name it: {type(error).__name__}: {str(error)[:160]}")
                elif clouds and value is not NO_POINTS and "PointCloud(array)" not in str(error):
                    faults.append(f"{where}: the message does not say how to make a cloud: {str(error)[:160]}")
                elif clouds and value is not NO_POINTS and not isinstance(error, TypeError):
                    faults.append(f"{where}: expected a TypeError, got {type(error).__name__}: {str(error)[:160]}")
            except Exception as error:
                faults.append(f"{where}: raw {type(error).__name__}: {str(error)[:160]}")
            else:
                if clouds and not isinstance(value, loom.PointCloud):
                    faults.append(f"{where}: taken for a cloud")
                if is_number and (title in numbers or value is True):
                    faults.append(f"{where}: taken for a number")
                elif title not in accepted:
                    faults.append(f"{where}: accepted for {annotation}")
        faults += [f"{where}: {w.category.__name__}: {str(w.message)[:100]} ({w.filename}:{w.lineno})" for w in caught]
    return faults


# For each kind of geometry: the other one, and the conversions that an error for it may name.
EXCHANGED: list[tuple[type, Any, tuple[str, ...]]] = [
    (loom.PointCloud, loom.TriangleMesh.create_box(), ("mesh.vertices", "PointCloud(x.vertices)")),
    (loom.TriangleMesh, loom.PointCloud(ARRAYS["points"]), ("create_surface(", "write_point_cloud")),
]  # fmt: skip


def faults_of_exchange(call: Callable[..., Any], arguments: dict[str, Any], either: Collection[str] = ()) -> list[str]:
    """Faults of a call that is given a mesh for each cloud or array of points, and a cloud for each mesh.

    The call must raise a TypeError that names the argument and a conversion. `either` are arguments that accept both.
    """
    faults = []
    for name, good in arguments.items():
        one = good[0] if isinstance(good, list | tuple) and good else good
        is_array = isinstance(one, np.ndarray) and one.ndim == 2 and one.shape[1] == 3 and one.dtype == np.float64
        for kind, given, conversions in () if name in either else EXCHANGED:
            if not isinstance(one, kind) and not (is_array and kind is loom.PointCloud and "point" in name):
                continue
            for value in [given] if one is good else [given, [given] * len(good)]:
                try:
                    fault = f"accepted: {call(**(arguments | {name: value}))!r}"
                except TypeError as error:
                    fault = "" if any(words in str(error) for words in conversions) else str(error)
                    fault = fault or ("" if re.search(rf"\b{name}\b", str(error)) else f"{name} is not named: {error}")
                faults += [f"{name} = {type(given).__name__}: {fault}"] if fault else []
    return faults


Table = dict[str, tuple[str, dict[str, str]]]


def call_of(function: str, things: dict[str, Any]) -> Callable[..., Any]:
    """The function of an expression over `things`, which is evaluated again in each call, with its signature."""

    def call(**given: Any) -> Any:
        return eval(function, dict(things))(**given)

    call.__signature__ = inspect.signature(eval(function, dict(things)))  # type: ignore[attr-defined]
    return call


def read_table(lines: str, homes: dict[str, str]) -> Table:
    """Calls as lines of Python: by their public name (`homes` maps variables to their classes), the function and
    the expression of each argument."""
    table = {}
    for line in filter(None, lines.splitlines()):
        call = ast.parse(line, mode="eval").body
        assert isinstance(call, ast.Call), line
        function = ast.unparse(call.func)
        owner, _, method = function.rpartition(".")
        name = f"{homes[owner]}.{method}" if owner in homes else re.sub(r"^(loom|reg)\.([a-z]+\.)?", "", function)
        assert name not in table, name
        table[name] = function, {keyword.arg: ast.unparse(keyword.value) for keyword in call.keywords if keyword.arg}
    return table


def missing_from(table: Table, arguments: dict[str, set[str]]) -> dict[str, set[str]]:
    """What a table does not try, of the arguments of each call."""
    missing = {name: names - table.get(name, ("", {}))[1].keys() for name, names in arguments.items()}
    return {name: names for name, names in missing.items() if names}


def public_arguments(module: ModuleType, left_out: set[str], within: str = "") -> dict[str, set[str]]:
    """The arguments of each public call of a module that has any, but switches and `**options`.

    Results are left out, and names that are not defined in the package `within`. A name with () is
    the constructor alone: of a `DetailTree`, users call `from_cloud` and `from_file`.
    """
    calls, left_out = {}, left_out | {"DetailTree()"}
    left_out |= results_of(module.__name__) if inspect.ismodule(module) else set()
    for name in set(module.__all__) - left_out:
        value = getattr(module, name)
        if not str(getattr(value, "__module__", "")).startswith(f"pointloom.{within}"):
            continue
        if inspect.ismodule(value) or (inspect.isclass(value) and issubclass(value, Warning)):
            continue
        if f"{name}()" not in left_out:
            calls[name] = value
        if inspect.isclass(value):
            names = set(dir(value)) - internal_names(value)
            methods = {f"{name}.{method}": method for method in sorted(names) if not method.startswith("_")}
            calls |= {
                full: getattr(value, method)
                for full, method in methods.items()
                if inspect.isroutine(getattr(value, method)) and full not in left_out
            }
    all_arguments = {name: _arguments(call) for name, call in calls.items()}
    return {name: arguments for name, arguments in all_arguments.items() if arguments}


def _arguments(call: Callable[..., Any]) -> set[str]:
    parameters = inspect.signature(call).parameters.values()
    named = {p.name: str(p.annotation) for p in parameters if p.kind not in (p.VAR_KEYWORD, p.VAR_POSITIONAL)}
    return {name for name, kind in named.items() if name != "self" and kind != "bool"}


def calls_of_clouds(table: Table, clouds: tuple[str, str]) -> list[str]:
    """The calls of a table that one of two clouds by these names takes part in."""
    named = re.compile(rf"\b({'|'.join(clouds)})\b")
    return [
        call
        for call, (function, names) in table.items()
        if function.split(".")[0] in clouds or any(named.search(good) for good in names.values())
    ]


def faults_of_clouds(entry: tuple[str, dict[str, str]], clouds: tuple[str, str], things: dict[str, Any]) -> list[str]:
    """What goes wrong where each hostile cloud takes the place of one of two clouds, or of both."""
    function, expressions = entry
    text = " ".join([function, *expressions.values()])
    used = [name for name in clouds if re.search(rf"\b{name}\b", text)]
    places = [used, *([name] for name in used if len(used) > 1)]
    assert used, text
    faults = []
    for title, cloud in hostile_clouds().items():
        for names in places:
            values = things | dict.fromkeys(names, cloud)

            def run(values=values):
                return eval(function, values)(**{name: eval(good, dict(values)) for name, good in expressions.items()})

            faults += [f"{title} as {', '.join(names)}: {fault}" for fault in warnings_of(run)]
    return faults


def temporary_folder() -> Path:
    """A new folder that is removed when the process ends."""
    folder = Path(tempfile.mkdtemp())
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    return folder
