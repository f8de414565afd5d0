"""Load public names on first use. Their only list is the package's stub, `__init__.pyi`."""

from __future__ import annotations

import importlib
import sys
from types import ModuleType

TYPE_CHECKING = False  # importing `typing` takes as long as all the rest
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable
    from typing import Any

_homes: dict[str, dict[str, str]] = {}  # results of `_read`
_results: dict[str, frozenset[str]] = {}  # of `results_of`

MAX_HINTS = 3  # names of a private module in an error
SHORT_NAME = "loom"  # usual import name
RESULTS = "# Results of functions, for annotations."  # above the last block of a stub
OPEN3D = f"{__name__.partition('.')[0]}.open3d"  # package of Open3D's names
TORCH = f"{__name__.partition('.')[0]}.torch"  # package of operators on tensors


class _Package(ModuleType):
    """A public subpackage that hides submodules unless they are public names.

    Python sets imported submodules as attributes of their package, where `registration.icp` would look like a function.
    """

    def __setattr__(self, name: str, value: Any) -> None:
        module = f"{self.__name__}.{name}"
        if getattr(value, "__name__", None) != module or _read(self.__name__).get(name) == module:
            super().__setattr__(name, value)


def attach(package: str) -> tuple[Callable[[str], Any], Callable[[], list[str]]]:
    """`__getattr__` (also for `__all__`) and `__dir__` of a package, from the imports in its stub.

    The stub is read on first use, so importing the package takes a millisecond.
    """
    if "." in package:
        sys.modules[package].__class__ = _Package

    def load(name: str) -> Any:
        if name.startswith("__") and name != "__all__":  # Python's own, which are optional
            raise AttributeError(f"module {package!r} has no attribute {name!r}")
        homes = _read(package)
        if name == "__all__":
            return sorted(homes)
        if name not in homes:
            if "." not in package and name in _read(OPEN3D) and name != "data":  # data sets have other names
                return _Open3DModule(f"{package}.{name}")
            raise AttributeError(_no_module(package, name, homes) or _no_name(package, name, homes))
        module = importlib.import_module(homes[name])
        value = module if homes[name] == f"{package}.{name}" else getattr(module, name, None)
        if value is None:  # a module in another folder
            value = importlib.import_module(f"{homes[name]}.{name}")
        value = _explained(package, name, value)
        vars(sys.modules[package])[name] = value
        return value

    def names() -> list[str]:
        return sorted({*(name for name in vars(sys.modules[package]) if name.startswith("__")), *_read(package)})

    return load, names


def _explained(package: str, name: str, value: Any) -> Any:
    """A public name with helpful argument errors, as the loaded classes of results. Names of Open3D have their own."""
    if package == OPEN3D or package.startswith(f"{OPEN3D}.") or isinstance(value, ModuleType):
        return value
    from .core.argument_errors import explain

    for result in results_of(package):
        if (module := sys.modules.get(_read(package)[result])) is not None:
            explain(getattr(module, result, None))
    made, module = explain(value), sys.modules[_read(package)[name]]
    if getattr(module, name, None) is value:  # there, too: `pickle` compares them
        setattr(module, name, made)
    return made


class _Open3DModule(ModuleType):
    """A module of Open3D, with its names that pointloom has: `loom.io.read_point_cloud` is `loom.read_point_cloud`.

    It repeats names and is therefore no public name itself.
    """

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(f"module {self.__name__!r} has no attribute {name!r}")
        theirs = self._theirs()
        if name in dir(theirs):
            if (place := _elsewhere(self.__name__, name)) or _is_accepted(getattr(theirs, name)):
                return _at(place) if place else getattr(theirs, name)
            if isinstance(getattr(theirs, name), ModuleType):
                return _Open3DModule(f"{self.__name__}.{name}")
        from .core.open3d_names import hint, row_of

        message, own = _no_name(self.__name__, name, dir(self)), self.__name__.rpartition(".")[2]
        raise AttributeError(message if ";" in message else message + hint(row_of(own)))

    def __dir__(self) -> list[str]:
        return [name for name in dir(self._theirs()) if _elsewhere(self.__name__, name)]

    def _theirs(self) -> ModuleType:
        return importlib.import_module(f"{OPEN3D}.{self.__name__.partition('.')[2]}")


def _at(place: str) -> Any:
    """The object at `loom.registration.registration_icp`."""
    value: Any = sys.modules[OPEN3D.partition(".")[0]]
    for name in place.split(".")[1:]:
        value = getattr(value, name)
    return value


def _is_accepted(value: Any) -> bool:
    """True for enumerations and vectors of Open3D, which functions of pointloom take, too, and for shared functions."""
    from enum import Enum

    is_vector = getattr(value, "__name__", "").endswith("Vector")
    is_shared = not isinstance(value, ModuleType) and not getattr(value, "__module__", OPEN3D).startswith(OPEN3D)
    return is_vector or is_shared or (isinstance(value, type) and issubclass(value, Enum))


def private(package: str) -> Callable[[str], Any]:
    """`__getattr__` of a private package with the name of an Open3D module, which has the names of that module."""

    def load(name: str) -> Any:
        if name.startswith("_") or _no_module(package, name, {}):
            raise AttributeError(f"module {package!r} has no attribute {name!r}")
        return getattr(_Open3DModule(package), name)

    return load


def _no_module(package: str, name: str, homes: dict[str, str]) -> str:
    """Error message for a private submodule with the public names it defines; "" for other names."""
    from importlib.machinery import PathFinder

    module = f"{package}.{name}"
    if PathFinder.find_spec(module, sys.modules[package].__path__) is None:
        return ""
    from .core.name_words import near_names
    from .core.open3d_names import COMMON, MODULES, hint, row_of

    message = f"module {package!r} has no attribute {name!r}: it is a private module"
    row = hint(row_of(name, (*MODULES, f"{COMMON}.{SHORT_NAME}")))
    inside = [
        other for other in (_constructed(package) if homes else ()) if f"{homes[other]}.".startswith(f"{module}.")
    ]
    nearest = near_names(name, (other for other in inside if other.islower()))
    if row and (not nearest or any(other in row for other in nearest)):
        return message + row
    nearest = nearest or inside[:MAX_HINTS]
    return message + (f"; did you mean {' or '.join(map(repr, nearest))}?" if nearest else "")


def _no_name(package: str, name: str, known: Iterable[str]) -> str:
    message = f"module {package!r} has no attribute {name!r}"
    if name.startswith("_"):
        return message
    from .core.attribute_hints import nearest_name
    from .core.name_words import row_of_words, same_names
    from .core.open3d_names import BRIDGE, COMMON, MODULES, hint, row_of

    if package == OPEN3D or package.startswith(f"{OPEN3D}."):
        own = hint(row_of(name, (BRIDGE,)))
        if not own and (other := _in_open3d(name)):
            return f"{message}; it is {other}"
        return message + (own or hint(row_of(name)) or _also(package, name) or nearest_name(name, known))
    rows = (*MODULES, f"{COMMON}.{SHORT_NAME}")
    if package == TORCH:  # operators with gradients first
        row = hint(row_of(name, (f"{COMMON}.torch",)))
        if row or same_names(name, known):
            return message + (row or nearest_name(name, known))
        row = hint(row_of(name, rows))
        return message + (f"{row} (without gradients)" if row else _also(package, name) or nearest_name(name, known))
    other, row = _also(package, name), hint(row_of(name, rows))
    if row and f"{SHORT_NAME}.torch." in other:  # operators on tensors, for networks
        other = ""
    known = _constructed(package) if package in _homes else known
    near = nearest_name(name, known) if same_names(name, known) else ""
    near = other or row or near or _alike(package, name) or hint(row_of_words(name, rows[-1:]))
    return message + (near or nearest_name(name, known))


def _also(package: str, name: str) -> str:
    """`; it is loom.registration` if another module has the name, else ""."""
    other = _elsewhere(package, name)
    return f"; it is {other}" if other else ""


def _alike(package: str, name: str) -> str:
    """`; it is loom.m3c2` for a name of the same words in another module, or a method of a cloud or mesh, or ""."""
    from .core.name_words import same_names

    root = package.partition(".")[0]
    for full_name, path in _packages(root):
        if full_name not in (package, TORCH) and (same := same_names(name, _constructed(full_name))):
            return f"; it is {path}.{same[0]}"
    for shape, variable in (("PointCloud", "cloud"), ("TriangleMesh", "mesh")):
        kind = getattr(sys.modules[root], shape)
        if same := same_names(name, [other for other in dir(kind) if not other.startswith("_")]):
            return f"; here: {variable}.{same[0]}"
    return ""


def function_named(name: str) -> str:
    """`; it is loom.classify_ground` for a public function with the words of a name, for errors of classes, or ""."""
    from .core.name_words import same_names

    for full_name, path in _packages(OPEN3D.partition(".")[0]):
        functions = [other for other in _constructed(full_name) if other.islower()]
        if full_name != TORCH and (same := same_names(name, functions)):
            return f"; it is {path}.{same[0]}"
    return ""


def _constructed(package: str) -> list[str]:
    """Public names of functions and classes, without modules and results."""
    names = _read(package).items()
    return [name for name, home in names if name not in results_of(package) and home != f"{package}.{name}"]


def _packages(root: str) -> list[tuple[str, str]]:
    """The packages of public names, with the paths that users write."""
    homes = _read(root).items()
    inside = [(module, _package_of(module, home)) for module, home in homes if module.islower()]
    return [(root, SHORT_NAME), *((full, f"{SHORT_NAME}.{name}") for name, full in inside if full)]


def _in_open3d(name: str) -> str:
    """Location of a name in the Open3D package, such as `o3d.pipelines.registration`, or ""."""
    from importlib.util import find_spec

    waiting = [OPEN3D]
    while waiting:
        package = waiting.pop(0)
        homes = _read(package)
        if name in homes:
            return f"o3d{package.removeprefix(OPEN3D)}.{name}"
        modules = [home for name, home in homes.items() if home == f"{package}.{name}"]
        waiting += [home for home in modules if (spec := find_spec(home)) and spec.submodule_search_locations]
    return ""


class _UnknownModules:
    """Last import finder: importing a missing Open3D module fails with the message of the attribute."""

    @staticmethod
    def find_spec(fullname: str, path: Any = None, target: Any = None) -> None:
        """Raise ModuleNotFoundError for a module of the package. Find nothing else.

        The error has no `name`: otherwise `from package import module` would replace it by another error.
        """
        package, _, name = fullname.rpartition(".")
        if package == OPEN3D or package.startswith(f"{OPEN3D}."):
            raise ModuleNotFoundError(_no_name(package, name, _read(package)))


def report_unknown_modules() -> None:
    """Append the finder once."""
    if _UnknownModules not in sys.meta_path:
        sys.meta_path.append(_UnknownModules)


def _elsewhere(package: str, name: str) -> str:
    """Other module of the package with the name, or ""."""
    root = package.partition(".")[0]
    homes = _read(root)
    if name in homes and package != root:
        return f"{SHORT_NAME}.{name}"
    for module, home in homes.items():
        if (
            module.islower()
            and (full_name := _package_of(module, home))
            and full_name != package
            and name in _read(full_name)
        ):
            return f"{SHORT_NAME}.{module}.{name}"
    return ""


def _package_of(module: str, home: str) -> str:
    """Package of a public name that has public names itself, or ""."""
    from contextlib import suppress

    for full_name in (home, f"{home}.{module}"):
        with suppress(ImportError):
            if full_name.endswith(f".{module}") and _read(full_name):
                return full_name
    return ""


def results_of(package: str) -> frozenset[str]:
    """Public names of classes that functions return and users do not construct: the last block of the stub."""
    if package not in _results:
        _results[package] = frozenset(_imports_of(package, _stub(package).partition(RESULTS)[2]))
    return _results[package]


def _read(package: str) -> dict[str, str]:
    """Module of each public name. A module maps to itself."""
    if package not in _homes:
        _homes[package] = _imports_of(package, _stub(package))
    return _homes[package]


def _stub(package: str) -> str:
    import pkgutil

    root, *inside = package.split(".")
    try:  # as data of the loaded root: a name that is only looked for imports no package
        stub = pkgutil.get_data(root, "/".join((*inside, "__init__.pyi")))
    except OSError:
        stub = None
    if stub is None:
        raise ImportError(
            f"{package}/__init__.pyi is missing: it lists the public names. Reinstall pointloom; a program packed by "
            "PyInstaller needs --collect-data pointloom"
        )
    return stub.decode()


def _imports_of(package: str, stub: str) -> dict[str, str]:
    import ast

    homes = {}
    for node in ast.parse(stub).body:
        if isinstance(node, ast.ImportFrom):
            base = package.rsplit(".", node.level - 1)[0]
            for alias in node.names:
                homes[alias.name] = f"{base}.{node.module or alias.name}"
    return homes
