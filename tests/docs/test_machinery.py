"""Generated pages of the documentation: public names, commands and links."""

import enum
import math
import re

import click
import pytest
from machinery import commands, pages, public, reference, texts
from sphinx.ext.napoleon import GoogleDocstring

from pointloom.cli.shell.cli import cli

from .conftest import DOCS

Color = enum.Enum("Color", ["RED"])


class Settings:
    """An object without a short form."""


def with_defaults(a=0.05, b=1_000_000, c=(0.0, 1.5), d=None, e="x", f=Color.RED, g=Settings(), h=math.inf, i=1.0):  # noqa: B008
    """A function with a default of each kind."""


# slow: needs Sphinx, which `make test` does not install
pytestmark = [pytest.mark.slow, pytest.mark.usefixtures("names_of_torch")]


def test_the_page_of_coverage_lists_results_without_picture(monkeypatch):
    monkeypatch.setattr(reference, "without_picture", lambda: ["pointloom.PointCloud.thin"])
    assert "PointCloud.thin" in reference.coverage_page().partition("No picture of the result")[2]


def test_every_public_name_has_a_page_and_an_index_entry():
    listed = set(re.findall(r"^   ([\w.]+)$", reference.index_page(), flags=re.MULTILINE))
    for module in public.public_modules():
        if module != "pointloom":
            listed |= set(re.findall(r"^   ([\w.]+)$", reference.module_page(module), flags=re.MULTILINE))
    assert listed >= {*public.all_names(), *public.public_modules()} - {"pointloom"}
    stub = (DOCS.parent / "src/pointloom/__init__.pyi").read_text()
    names = {line.rsplit(" ", 1)[1] for line in stub.splitlines() if line.startswith("from ")}
    assert listed >= {f"pointloom.{name}" for name in names}


@pytest.mark.parametrize("name", sorted(cli.commands))
def test_the_page_of_a_command_contains_its_help(name):
    command = cli.commands[name]
    text = commands.page_of(name, command)
    for option in command.params:
        if isinstance(option, click.Option) and not option.hidden:
            assert all(spelling in text for spelling in option.opts)
            assert texts.plain(option.help or "").split("\n")[0] in text
    assert "\b" not in text


def test_every_page_is_listed_in_the_site():
    lists = (
        (DOCS / "guides.md").read_text() + (DOCS / "index.md").read_text() + "versions\narchitecture\nREADME\nindex\n"
    )
    assert {path.stem for path in DOCS.glob("*.md")} - set(re.findall(r"^[\w-]+$", lists, flags=re.MULTILINE)) == set()


def test_results_have_no_type_before_a_colon_and_link_their_classes():
    returned = "Returns:\n    A SurfaceResult: the mesh\n    of a PointCloud."
    text = f"Mesh a scan.\n\n{returned}\n\nRaises:\n    TypeError: No PointCloud."
    expected = (
        "Mesh a scan.\n\nReturns:\n    : A :py:obj:`~pointloom.meshing.SurfaceResult`: the mesh\n"
        "    of a :py:obj:`~pointloom.PointCloud`.\n\nRaises:\n    TypeError: No PointCloud."
    )
    assert "\n".join(reference.results_as_text(text.split("\n"))) == expected
    typed = GoogleDocstring("\n".join(reference.results_as_text(["Returns:", "    Distances [m]: one a point."])))
    assert ":returns: Distances [m]: one a point." in str(typed) and ":rtype:" not in str(typed)


def test_signatures_show_defaults_by_value():
    shown = reference.signature_of("function", "pointloom.registration.get_undetermined_motions", with_defaults)
    assert shown == (
        "(a=0.05, b=1_000_000, c=(0.0, 1.5), d=None, e='x', f=Color.RED, g=Settings(...), h=inf, i=1.0)",
        "",
    )


def test_no_signature_of_the_reference_shows_a_private_constant():
    for name, public_name in public.all_names().items():
        things = [("function" if public_name.kind == "function" else "class", name, public_name.value)]
        if public_name.kind == "class":
            things += [("method", f"{name}.{key}", getattr(public_name.value, key)) for key in public.members_of(name)]
        for what, full, thing in things:
            signature = reference.signature_of(what, full, thing)
            assert not re.search(r"= ?[A-Z][A-Z_]+\b", signature[0] if signature else ""), full


@pytest.mark.parametrize(
    ("page", "text", "expected"),
    [
        ("gpu", "[a](../CONTRIBUTING.md#test)", "[a](project/contributing.md#test)"),
        ("project/kernels", "[a](../../../CONTRIBUTING.md)", "[a](contributing.md)"),
        ("project/changelog", "[a](docs/gpu.md) ![b](docs/room.png)", "[a](../gpu.md) ![b](../room.png)"),
        ("adr/README", "[`a`](../README.md)", "[`a`](../guides.md)"),
        ("gpu", "[a](../pyproject.toml) [b](#part) [c](https://x.y)", "a [b](#part) [c](https://x.y)"),
        ("gpu", "```\n[a](../README.md)\n```", "```\n[a](../README.md)\n```"),
    ],
)
def test_links_between_pages_are_rewritten_for_the_site(page, text, expected):
    assert pages.rewrite_links(page, text) == expected
