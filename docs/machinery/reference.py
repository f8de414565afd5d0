"""The pages of the reference: one for each public class and function, one for each module, one that counts."""

from __future__ import annotations

import inspect
import re
from pathlib import Path
from typing import Any

from sphinx.util.inspect import stringify_signature
from sphinx.util.typing import stringify_annotation

from .public import (
    ORDER,
    OTHER,
    PublicName,
    all_names,
    first_sentence,
    has_example,
    members_of,
    names_of,
    public_modules,
)
from .texts import plain, remove_others, titled, write_if_changed
from .usage import Example, examples, users

HEAD = """``import pointloom as loom`` loads nothing but names: each is loaded when it is first used. Operations return
what they make and change nothing in place.

"""
# The sections of pointloom.registration, by the room that defines a name.
ROOMS = {
    "icp": "ICP",
    "globally": "From no guess",
    "matching": "From no guess",
    "pose_graphs": "Many clouds: pose graphs",
    "lidar": "LiDAR",
    "trajectories": "Paths",
    "robust_kernels": "Robust kernels",
}
DOCS = Path(__file__).parents[1]
PAGE = re.compile(r"(?<!`)docs/([\w-]+)\.md(?!`)")
SHOWN = 12  # examples that a page names


def write_pages(folder: Path) -> None:
    """Write them all."""
    pages = {"index.rst": index_page(), "coverage.rst": coverage_page()}
    for module in public_modules():
        if module != "pointloom":
            pages[f"{module}.rst"] = module_page(module)
    pages.update({f"{name}.rst": page_of(found) for name, found in all_names().items()})
    for name, text in pages.items():
        write_if_changed(folder / name, text)
    remove_others(folder, set(pages))


def index_page() -> str:
    """All names of `pointloom` by subject, and its modules."""
    sections: dict[str, list[PublicName]] = {}
    for found in names_of("pointloom").values():
        sections.setdefault(found.group, []).append(found)
    modules = [module for module in public_modules() if module != "pointloom"]
    text = titled("Reference") + HEAD + titled("Modules", "-") + ".. list-table::\n   :widths: 30 70\n\n"
    for module in modules:
        about = first_sentence(public_modules()[module].__doc__)
        text += f"   * - :doc:`loom.{module.removeprefix('pointloom.')} <{module}>`\n     - {plain(about)}\n"
    text += "\n" + _toctree(modules)
    for group in [*ORDER, OTHER]:
        if group in sections:
            text += titled(group, "-") + _table(sections[group])
    return text + "How many of these names have an example: :doc:`coverage`.\n\n" + _toctree(["coverage"])


def module_page(module: str) -> str:
    """A module's docstring and its names; those of registration by room."""
    text = titled(f"loom.{module.removeprefix('pointloom.')}") + f".. automodule:: {module}\n   :no-members:\n\n"
    found = list(names_of(module).values())
    if module != "pointloom.registration":
        return text + titled("Names", "-") + _table(found)
    sections: dict[str, list[PublicName]] = {}
    for name in found:
        place = name.home.removeprefix(f"{module}.").split(".")[0]
        sections.setdefault(ROOMS.get(place, "Results and files"), []).append(name)
    for title in dict.fromkeys([*ROOMS.values(), "Results and files"]):
        text += titled(title, "-") + _table(sections.get(title, []))
    return text


def page_of(found: PublicName) -> str:
    """The page of a class or function; a class begins with a table of its methods."""
    short = found.name.removeprefix("pointloom.")
    text = titled(f"loom.{short}") + f".. currentmodule:: {found.module}\n\n"
    if found.kind not in {"class", "exception"}:
        return text + f".. auto{found.kind}:: {found.name}\n"
    members = members_of(found.name)
    text += f".. auto{found.kind}:: {found.name}\n"
    text += "   :members: " + ", ".join(members) + "\n   :member-order: bysource\n" if members else ""
    if len(members) > 5:
        rows = "".join(f"   ~{_within(found)}.{member}\n" for member in members)
        text += f"\n{titled('All at a glance', '-')}.. autosummary::\n   :nosignatures:\n\n{rows}"
    return text


def _table(names: list[PublicName]) -> str:
    if not names:
        return ""
    rows = "".join(f"   {_within(found)}\n" for found in names)
    return f".. currentmodule:: {names[0].module}\n\n.. autosummary::\n   :nosignatures:\n\n{rows}\n" + _toctree(
        [found.name for found in names]
    )


def _within(found: PublicName) -> str:
    """A name as it stands in its module."""
    return found.name.removeprefix(f"{found.module}.")


def _toctree(pages: list[str]) -> str:
    return ".. toctree::\n   :hidden:\n\n" + "".join(f"   {page}\n" for page in pages) + "\n"


def examples_of(name: str) -> list[str]:
    """Lines of reST that name the pages of the gallery that use a public name or method; none where none does."""
    found = users().get(name, [])
    if not found:
        return []
    links = ", ".join(f":doc:`{plain(example.title)} </{example.page}>`" for example in found[:SHOWN])
    more = f" and {len(found) - SHOWN} more" if len(found) > SHOWN else ""
    return ["", ".. rst-class:: used-in", "", f"**Seen in** {links}{more}", ""]


def signature_of(what: str, name: str, thing: Any) -> tuple[str, str] | None:
    """Parameters and result of a function, method or class with their hints as they are written; None for all else."""
    if what not in {"function", "method", "class", "exception"}:
        return None
    try:
        signature = inspect.signature(thing)
    except (TypeError, ValueError):
        return None
    if what == "method":
        owner, _, member = name.rpartition(".")
        found = all_names().get(owner)
        is_static = found is not None and isinstance(inspect.getattr_static(found.value, member), staticmethod)
        if inspect.isfunction(thing) and not is_static:
            signature = signature.replace(parameters=list(signature.parameters.values())[1:])
    is_class = what in {"class", "exception"}
    written = stringify_signature(signature, show_return_annotation=False, unqualified_typehints=True)
    result = signature.return_annotation
    return written, "" if is_class or result is inspect.Signature.empty else stringify_annotation(result, "smart")


def linked(line: str) -> str:
    """A line of a docstring whose mentions of pages, "docs/arrays.md", are links to them."""
    return PAGE.sub(lambda found: f":doc:`/{found[1]}`" if (DOCS / f"{found[1]}.md").exists() else found[0], line)


def missing() -> tuple[list[str], list[str]]:
    """The public names whose docstring has no example, and those that no page of the gallery uses."""
    names = all_names()
    without = [name for name, found in names.items() if not has_example(found)]
    return without, [name for name in names if name not in users()]


def said() -> str:
    """The counts of `missing` in a line."""
    without, unseen = missing()
    count, methods = len(all_names()), [f"{n}.{m}" for n in all_names() if _is_class(n) for m in members_of(n)]
    seen = sum(name in users() for name in methods)
    return (
        f"{count} public names: {count - len(without)} with an example in their docstring, {count - len(unseen)} in "
        f"one of {len(examples())} pages of the gallery; {seen} of {len(methods)} methods and properties there"
    )


def _is_class(name: str) -> bool:
    return all_names()[name].kind in {"class", "exception"}


def coverage_page() -> str:
    """Which names lack what."""
    without, unseen = missing()
    text = titled("Names and their examples") + said() + ".\n\n"
    for title, names in (("No page of the gallery uses", unseen), ("No example in the docstring", without)):
        listed = "".join(f"- :py:obj:`{name}`\n" for name in names) or "None.\n"
        text += titled(title, "-") + listed + "\n"
    return text


def example_pages() -> dict[str, Example]:
    """The scripts by their page."""
    return {example.page: example for example in examples()}
