"""Generated pages of the documentation: public names, commands and links."""

import re

import click
import pytest
from machinery import commands, pages, public, reference, texts

from pointloom.cli.shell.cli import cli

from .conftest import DOCS

pytestmark = pytest.mark.slow  # needs Sphinx, which `make test` does not install


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
    lists = (DOCS / "guides.md").read_text() + (DOCS / "index.md").read_text() + "versions\nREADME\nindex\n"
    assert {path.stem for path in DOCS.glob("*.md")} - set(re.findall(r"^[\w-]+$", lists, flags=re.MULTILINE)) == set()


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
