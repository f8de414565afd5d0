"""Pages of the command line, generated from the commands: arguments, options and examples."""

from __future__ import annotations

import inspect
import re
from pathlib import Path

import click

from pointloom.cli.shell.cli import cli

from .texts import indented, plain, remove_others, titled, write_if_changed

HEAD = """``--help`` of each command prints the same text. Common options: :doc:`/shell`.

"""


def write_pages(folder: Path) -> None:
    """Write a page for each command, and an index."""
    commands = dict(sorted(cli.commands.items()))
    rows = [
        f"   * - :doc:`pointloom {name} <{name}>`\n     - {plain(command.get_short_help_str(200))}"
        for name, command in commands.items()
        if not command.hidden
    ]
    table = ".. list-table::\n   :widths: 25 75\n\n" + "\n".join(rows) + "\n\n"
    toctree = ".. toctree::\n   :hidden:\n\n" + "".join(f"   {name}\n" for name in commands)
    text = titled("Command line") + HEAD + table + titled("pointloom", "-") + described(cli) + "\n" + toctree
    write_if_changed(folder / "index.rst", text)
    for name, command in commands.items():
        write_if_changed(folder / f"{name}.rst", page_of(name, command))
    remove_others(folder, {"index.rst", *(f"{name}.rst" for name in commands)})


def page_of(name: str, command: click.Command) -> str:
    """The page of a command: usage, description and options."""
    context = click.Context(command, info_name=f"pointloom {name}", **cli.context_settings)
    usage = " ".join([context.info_name or name, *command.collect_usage_pieces(context)])
    text = titled(f"pointloom {name}") + f".. code-block:: bash\n\n   {usage}\n\n{described(command)}"
    options = [param for param in command.get_params(context) if isinstance(param, click.Option) and not param.hidden]
    if options:
        text += titled("Options", "-") + f".. program:: pointloom {name}\n\n"
    for option in options:
        record = option.get_help_record(context)
        if record is not None:
            text += f".. option:: {spelled(record[0])}\n\n{indented(plain(record[1]))}\n\n"
    return text


def spelled(names: str) -> str:
    """Names of an option in the format of Sphinx's directive."""
    return names.replace(" / ", ", ").replace("\\", "\\\\")


def described(command: click.Command) -> str:
    """The help text of a command. Paragraphs after a line of \\b become code blocks."""
    text = inspect.cleandoc(command.help or "").replace("\f", "")
    parts = []
    for paragraph in re.split(r"\n\s*\n", text):
        if not paragraph.startswith("\b"):
            parts.append(plain(" ".join(paragraph.split())))
            continue
        lines = inspect.cleandoc("\n" + paragraph.removeprefix("\b").lstrip("\n")).splitlines()
        kind = "bash" if any(line.startswith("pointloom ") for line in lines) else "text"
        parts.append(f".. code-block:: {kind}\n\n" + indented("\n".join(lines)))
    return "\n\n".join(parts) + "\n\n"
