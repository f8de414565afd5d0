"""Pages of the reference: one per public class, function and module, and one with the coverage by examples."""

from __future__ import annotations

import enum
import inspect
import re
from pathlib import Path
from typing import Any

from sphinx.util.inspect import stringify_signature
from sphinx.util.typing import stringify_annotation

from .pictures import NEEDS_NONE, pictures, visible, without_picture
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
from .usage import Example, examples, short_names, users

HEAD = """``import pointloom as loom`` is fast, since each module is loaded on first use. Operations return new
objects and do not change their inputs.

"""
# Sections of pointloom.registration by the subpackage that defines a name.
SUBPACKAGES = {
    "icp": "ICP",
    "globally": "Global registration",
    "matching": "Global registration",
    "pose_graphs": "Pose graphs",
    "lidar": "LiDAR",
    "trajectories": "Trajectories",
    "robust_kernels": "Robust kernels",
}
DOCS = Path(__file__).parents[1]
PAGE = re.compile(r"(?<!`)docs/([\w-]+)\.md(?!`)")
SHOWN = 12  # listed examples of a page


def write_pages(folder: Path) -> None:
    """Write all pages."""
    pages = {"index.rst": index_page(), "coverage.rst": coverage_page()}
    for module in public_modules():
        if module != "pointloom":
            pages[f"{module}.rst"] = module_page(module)
    pages.update({f"{name}.rst": page_of(public) for name, public in all_names().items()})
    for name, text in pages.items():
        write_if_changed(folder / name, text)
    remove_others(folder, set(pages))


def index_page() -> str:
    """Page of the names of `pointloom` by topic, and its modules."""
    sections: dict[str, list[PublicName]] = {}
    for public in names_of("pointloom").values():
        sections.setdefault(public.group, []).append(public)
    modules = [module for module in public_modules() if module != "pointloom"]
    text = titled("Reference") + HEAD + titled("Modules", "-") + ".. list-table::\n   :widths: 30 70\n\n"
    for module in modules:
        about = first_sentence(public_modules()[module].__doc__)
        text += f"   * - :doc:`loom.{module.removeprefix('pointloom.')} <{module}>`\n     - {plain(about)}\n"
    text += "\n" + _toctree(modules, "Modules")
    for group in [*ORDER, OTHER]:
        if group in sections:
            text += titled(group, "-") + _table(sections[group], group)
    return text + "Coverage of these names by examples: :doc:`coverage`.\n\n" + _toctree(["coverage"], "Coverage")


def module_page(module: str) -> str:
    """Page of a module: its docstring and names; those of registration by subpackage."""
    text = titled(f"loom.{module.removeprefix('pointloom.')}") + f".. automodule:: {module}\n   :no-members:\n\n"
    names = list(names_of(module).values())
    if module != "pointloom.registration":
        return text + titled("Names", "-") + _table(names, "Names")
    sections: dict[str, list[PublicName]] = {}
    for name in names:
        subpackage = name.home.removeprefix(f"{module}.").split(".")[0]
        sections.setdefault(SUBPACKAGES.get(subpackage, "Results and files"), []).append(name)
    for title in dict.fromkeys([*SUBPACKAGES.values(), "Results and files"]):
        text += titled(title, "-") + _table(sections.get(title, []), title)
    return text


def page_of(public: PublicName) -> str:
    """Page of a class or function. Classes with many methods have a table of them."""
    short = public.name.removeprefix("pointloom.")
    text = titled(f"loom.{short}") + f".. currentmodule:: {public.module}\n\n"
    if public.kind not in {"class", "exception"}:
        return text + f".. auto{public.kind}:: {public.name}\n"
    members = members_of(public.name)
    text += f".. auto{public.kind}:: {public.name}\n"
    text += "   :members: " + ", ".join(members) + "\n   :member-order: bysource\n" if members else ""
    if len(members) > 5:
        rows = "".join(f"   ~{_within(public)}.{member}\n" for member in members)
        text += f"\n{titled('Summary', '-')}.. autosummary::\n   :nosignatures:\n\n{rows}"
    return text


def _table(names: list[PublicName], caption: str) -> str:
    """Names in alphabetical order, and below the caption in the side bar."""
    if not names:
        return ""
    names = sorted(names, key=lambda public: public.name.lower())
    rows = "".join(f"   {_within(public)}\n" for public in names)
    return f".. currentmodule:: {names[0].module}\n\n.. autosummary::\n   :nosignatures:\n\n{rows}\n" + _toctree(
        [public.name for public in names], caption
    )


def _within(public: PublicName) -> str:
    """Name relative to its module."""
    return public.name.removeprefix(f"{public.module}.")


def _toctree(pages: list[str], caption: str) -> str:
    return f".. toctree::\n   :hidden:\n   :caption: {caption}\n\n" + "".join(f"   {page}\n" for page in pages) + "\n"


def examples_of(name: str) -> list[str]:
    """reST lines that list the gallery pages with a public name or method. Empty if there are none."""
    pages = users().get(name, [])
    if not pages:
        return []
    links = ", ".join(f":doc:`{plain(example.title)} </{example.page}>`" for example in pages[:SHOWN])
    more = f" and {len(pages) - SHOWN} more" if len(pages) > SHOWN else ""
    return ["", ".. rst-class:: used-in", "", f"**Used in** {links}{more}", ""]


def signature_of(what: str, name: str, thing: Any) -> tuple[str, str] | None:
    """Parameters and result of a function, method or class with their type hints; None for other objects."""
    if what not in {"function", "method", "class", "exception"}:
        return None
    try:
        signature = inspect.signature(thing)
    except (TypeError, ValueError):
        return None
    if what == "method":
        owner, _, member = name.rpartition(".")
        public = all_names().get(owner)
        is_static = public is not None and isinstance(inspect.getattr_static(public.value, member), staticmethod)
        if inspect.isfunction(thing) and not is_static:
            signature = signature.replace(parameters=list(signature.parameters.values())[1:])
    is_class = what in {"class", "exception"}
    parameters = [parameter.replace(default=_Default(parameter.default)) for parameter in signature.parameters.values()]
    signature = signature.replace(parameters=parameters)
    written = stringify_signature(signature, show_return_annotation=False, unqualified_typehints=True)
    result = signature.return_annotation
    return written, "" if is_class or result is inspect.Signature.empty else stringify_annotation(result, "smart")


class _Default:
    """A default value as the signature shows it: constants by their value, objects by their class."""

    def __new__(cls, value: Any) -> Any:
        return value if value is inspect.Parameter.empty else super().__new__(cls)

    def __init__(self, value: Any) -> None:
        self.value = value

    def __repr__(self) -> str:
        value = self.value
        if isinstance(value, enum.Enum):
            return f"{type(value).__name__}.{value.name}"
        if isinstance(value, tuple):
            return f"({', '.join(map(repr, map(_Default, value)))}{',' if len(value) == 1 else ''})"
        if isinstance(value, float):
            text = f"{value:.6g}"
            return text if set(text) & set(".en") else f"{text}.0"
        if isinstance(value, int) and not isinstance(value, bool):
            return f"{value:_}" if abs(value) >= 10_000 else str(value)
        if value is None or isinstance(value, str | bytes | bool):
            return repr(value)
        return getattr(value, "__name__", f"{type(value).__name__}(...)")


def results_as_text(lines: list[str]) -> list[str]:
    """The lines of a docstring with results that napoleon does not split into type and text, and with links to classes.

    The signature contains the type. napoleon takes all text before the first colon for a type.
    """
    changed, section = [], None  # section: the number of its lines before this one, None outside Returns and Yields
    for line in lines:
        if section is not None and line.strip():
            if not line.startswith(" "):
                section = None
            else:
                indent = len(line) - len(line.lstrip())
                start = ": " if section == 0 else ""
                line = line[:indent] + start + _CLASS.sub(_class_link, line[indent:])
                section += 1
        if line in {"Returns:", "Yields:"}:
            section = 0
        changed.append(line)
    return changed


_CLASS = re.compile(r"(?<![\w`.~<])[A-Z][a-z]+(?:[A-Z][A-Za-z]*)+(?![\w`])")


def _class_link(match: re.Match[str]) -> str:
    name = short_names().get(match[0])
    return f":py:obj:`~{name}`" if name else match[0]


def linked(line: str) -> str:
    """Replace mentions of pages such as "docs/arrays.md" in a line of a docstring by links."""
    return PAGE.sub(lambda match: f":doc:`/{match[1]}`" if (DOCS / f"{match[1]}.md").exists() else match[0], line)


def missing() -> tuple[list[str], list[str]]:
    """Public names without an example in their docstring, and those without a gallery page."""
    names = all_names()
    without = [name for name, public in names.items() if not has_example(public)]
    return without, [name for name in names if name not in users()]


def coverage_line() -> str:
    """The counts of `missing` in one line."""
    without, unused = missing()
    count, methods = len(all_names()), [f"{n}.{m}" for n in all_names() if _is_class(n) for m in members_of(n)]
    used = sum(name in users() for name in methods)
    return (
        f"{count} public names: {count - len(without)} with an example in their docstring, {count - len(unused)} in "
        f"one of {len(examples())} pages of the gallery; {used} of {len(methods)} methods and properties occur there, "
        f"{len(pictures())} names have a picture, {len(without_picture())} of {len(visible())} visible results lack one"
    )


def _is_class(name: str) -> bool:
    return all_names()[name].kind in {"class", "exception"}


def coverage_page() -> str:
    """Page of names without examples."""
    without, unused = missing()
    text = titled("Names and their examples") + coverage_line() + ".\n\n"
    text += "Operations that return something visible have a picture. A name needs none if its last part fits one of\n"
    text += "these patterns:\n\n"
    text += "".join(f"- {reason}: ``{pattern}``\n" for reason, pattern in NEEDS_NONE.items()) + "\n"
    sections = {
        "No picture of the result": without_picture(),
        "No page of the gallery uses": unused,
        "No example in the docstring": without,
    }
    for title, names in sections.items():
        listed = "".join(f"- :py:obj:`{name}`\n" for name in names) or "None.\n"
        text += titled(title, "-") + listed + "\n"
    return text


def example_pages() -> dict[str, Example]:
    """Scripts by page."""
    return {example.page: example for example in examples()}
