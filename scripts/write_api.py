"""Write docs/api.txt: each public name with its signature, from the stubs.

    python scripts/write_api.py            # write the file
    python scripts/write_api.py --check    # print the difference and names without a docstring; exit code 1 if any
    python scripts/write_api.py --compare FILE    # print what was removed or changed since; 1 if any

The file makes each change of the public interface visible in a diff. Names of `pointloom.open3d` are Open3D's and are
left out.
"""

from __future__ import annotations

import argparse
import difflib
import enum
import importlib
import importlib.util
import inspect
import re
import sys
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType
from typing import Any
from unittest import mock

from pointloom import public_names
from pointloom.core.attribute_hints import internal_names

ROOT = Path(__file__).resolve().parent.parent
FILE = ROOT / "docs" / "api.txt"
PACKAGE = "pointloom"
PROTOCOL = {"reliable", "warnings", "notes", "fields", "to_dict"}  # of results, documented in core/reports.py


def parameters(call: Any) -> str:
    """The parameters of a callable in one line, without their types."""
    try:
        signature = inspect.signature(call)
    except (TypeError, ValueError):
        return "(...)"
    plain = [each.replace(annotation=each.empty) for each in signature.parameters.values()]
    text = str(signature.replace(parameters=plain, return_annotation=signature.empty))
    return re.sub(r" at 0x[0-9a-f]+", "", text)


def is_own(cls: type) -> bool:
    """True if a class is defined in this package and not private."""
    return cls.__module__.split(".")[0] == PACKAGE


def is_public(cls: type, name: str) -> bool:
    """True if a member has no underscore and is not one that only other modules of this package use."""
    return not name.startswith("_") and name not in internal_names(cls)


def members(cls: type) -> Iterator[str]:
    """Each documented method, property and field of a class, with inherited ones of this package.

    A field counts if the docstring of a class names it; the values of an enumeration count.
    """
    own: dict[str, Any] = {}
    docstrings = ""
    for base in reversed([each for each in cls.__mro__ if is_own(each)]):
        fields = {name: None for name in inspect.get_annotations(base)}
        own |= {name: value for name, value in {**fields, **vars(base)}.items() if is_public(cls, name)}
        docstrings += vars(base).get("__doc__") or ""
    for name, value in sorted(own.items()):
        if isinstance(value, staticmethod | classmethod):
            yield f"{name}{parameters(getattr(cls, name))}"
        elif inspect.isfunction(value):
            yield f"{name}{parameters(value)}"
        elif isinstance(value, property) or issubclass(cls, enum.Enum) or re.search(rf"\b{name}\b", docstrings):
            yield name


def lines_of(name: str, value: Any, *, is_result: bool = False) -> Iterator[str]:
    """A public function or constant in one line, a class with its members below it. Users do not construct results."""
    if not inspect.isclass(value):
        yield f"{name}{parameters(value)}" if callable(value) else name
        return
    is_error = issubclass(value, BaseException)
    kind = "result" if is_result else "class"
    yield f"{kind} {name}" if is_error or is_result else f"{kind} {name}{parameters(value)}"
    yield from (f"    {member}" for member in (() if is_error else members(value)))


def packages(name: str) -> Iterator[tuple[str, ModuleType]]:
    """A package and its public subpackages."""
    package = importlib.import_module(name)
    yield "loom", package
    for each in package.__all__:
        value = getattr(package, each)
        if inspect.ismodule(value):
            yield f"loom.{each}", value


def api() -> str:
    """The text of the file."""
    lines: list[str] = []
    counts = {False: [0, 0], True: [0, 0]}  # names and members, by "is a result"
    for title, package in packages(PACKAGE):
        lines += ["", title]
        results = public_names.results_of(package.__name__)
        for name in sorted(package.__all__, key=lambda name: (name in results, name)):
            value = getattr(package, name)
            if inspect.ismodule(value):
                continue
            own = list(lines_of(name, value, is_result=name in results))
            count = counts[name in results]
            count[:] = count[0] + 1, count[1] + len(own) - 1
            lines += [f"    {line}" for line in own]
    (names, member_count), (result_count, field_count) = counts.values()
    total = f"{names} public classes and functions, {member_count} members"
    return "\n".join([f"{total}; {result_count} classes of results, {field_count} members", *lines, ""])


def undocumented() -> Iterator[str]:
    """Each public class, function, method and property without a docstring."""
    for title, package in packages(PACKAGE):
        results = public_names.results_of(package.__name__)
        for name in package.__all__:
            value = getattr(package, name)
            if not inspect.isclass(value):
                if inspect.isroutine(value) and not inspect.getdoc(value):
                    yield f"{title}.{name}"
                continue
            own = vars(value).get("__doc__") or ""
            if not own or own.startswith(f"{name}("):  # the latter is what dataclass writes
                yield f"{title}.{name}"
            for base in filter(is_own, value.__mro__):
                for member, each in vars(base).items():
                    is_call = inspect.isroutine(each) or isinstance(each, property | staticmethod | classmethod)
                    if not is_call or not is_public(value, member) or (member in PROTOCOL and name in results):
                        continue
                    if not inspect.getdoc(getattr(value, member, None)):
                        yield f"{title}.{name}.{member}"


def entries(text: str) -> dict[str, str]:
    """Full name -> signature of each name in the text of the file, empty for names without one."""
    result, parents = {}, [""]
    for line in text.splitlines()[1:]:
        depth = (len(line) - len(line.lstrip())) // 4
        name, parenthesis, rest = line.strip().removeprefix("class ").removeprefix("result ").partition("(")
        if name:
            parents = [*parents[: depth + 1], f"{parents[depth]}{name}."]
            result[parents[-1][:-1]] = parenthesis + rest
    return result


def breaking(earlier: str, current: str) -> Iterator[str]:
    """Each name that was removed since an earlier text of the file, and each changed signature.

    Parameters with a default that were appended are no change.
    """
    names = entries(current)
    for name, old in entries(earlier).items():
        new = names.get(name)
        kept = old.removesuffix(")") + (", " if old != "()" else "")
        if new is None:
            yield f"removed: {name}{old}"
        elif new != old:
            appended = new[len(kept) :].removeprefix("*, ").partition(", ")[0]
            if not (old and new.startswith(kept) and "=" in appended):
                yield f"changed: {name}{old} -> {name}{new}"


def main() -> int:
    """The command."""
    if importlib.util.find_spec("torch") is None:  # signatures of pointloom.torch need no more than its names
        sys.modules["torch"] = mock.MagicMock()
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="print the difference instead of writing")
    parser.add_argument(
        "--compare", type=Path, metavar="FILE", help="print changes since this file of an earlier release"
    )
    options = parser.parse_args()
    text = api()
    if options.compare:
        messages = list(breaking(options.compare.read_text(), text))
        print("\n".join([*messages, f"{len(messages)} names removed or changed since {options.compare.name}"]))
        return bool(messages)
    if not options.check:
        FILE.write_text(text)
        return 0
    stored = FILE.read_text() if FILE.exists() else ""
    change = list(
        difflib.unified_diff(stored.splitlines(), text.splitlines(), "docs/api.txt", "public names", lineterm="")
    )
    missing = [f"{name}: a public name needs a docstring" for name in sorted(set(undocumented()))]
    print("\n".join(change + missing))
    return bool(change or missing)


if __name__ == "__main__":
    sys.exit(main())
