"""Write the man page docs/pointloom.1 from the commands. Wheels install it under share/man/man1.

.venv/bin/python scripts/write_man_page.py            # write it
.venv/bin/python scripts/write_man_page.py --check    # exit code 1 if it differs from the help of the commands
"""

from __future__ import annotations

import re
import sys
from pathlib import Path

import click

ROOT = Path(__file__).resolve().parents[1]
PAGE = ROOT / "docs" / "pointloom.1"


def escaped(text: str) -> str:
    """Escape text for roff, including control characters at the beginning of a line."""
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return re.sub(r"^([.'])", r"\\&\1", text, flags=re.MULTILINE)


def paragraphs(help_text: str) -> list[str]:
    """The paragraphs of a help text. Those marked by a backspace (click) keep their line breaks."""
    lines, keeps = [], False
    for part in re.split(r"\n\s*\n", help_text):
        rows = [row.strip("\b") for row in part.split("\n") if row.strip()]
        keeps = "\b" in part
        if not rows:
            continue
        text = "\n".join(rows) if keeps else " ".join(row.strip() for row in rows)
        lines.append(f".PP\n.nf\n{escaped(text)}\n.fi" if keeps else f".PP\n{escaped(text)}")
    return lines


def of_options(command: click.Command, context: click.Context) -> list[str]:
    """The options with their help."""
    lines = []
    for parameter in command.get_params(context):
        row = parameter.get_help_record(context) if isinstance(parameter, click.Option) else None
        if row is not None:
            lines.append(f".TP\n.B {escaped(row[0])}\n{escaped(row[1])}")
    return lines


def of_command(name: str, command: click.Command, parent: click.Context) -> list[str]:
    """The section of a command, followed by those of its subcommands."""
    with click.Context(command, info_name=name, parent=parent) as context:
        usage = " ".join(command.collect_usage_pieces(context))
        head = [f'.SS "{escaped(name)}"', f".B pointloom {escaped(name)}", escaped(usage)]
        parts = [*head, *paragraphs(command.help or ""), *of_options(command, context)]
        if isinstance(command, click.Group):
            for subcommand in command.list_commands(context):
                parts += of_command(f"{name} {subcommand}", command.commands[subcommand], parent)
        return parts


def man_page() -> str:
    """The text of the page."""
    sys.path.insert(0, str(ROOT / "src"))  # this checkout's commands
    from pointloom import __version__
    from pointloom.cli.shell.cli import cli

    with click.Context(cli, info_name="pointloom", **cli.context_settings) as context:
        parts = [
            f'.TH POINTLOOM 1 "" "pointloom {__version__}" "User Commands"',
            ".ad l",
            ".SH NAME",
            r"pointloom \- point clouds, scans and RGB\-D frames to clouds and meshes",
            ".SH SYNOPSIS",
            ".B pointloom",
            escaped("COMMAND [OPTIONS] [ARGS]..."),
            ".SH DESCRIPTION",
            *paragraphs(cli.help or ""),
            ".SH OPTIONS",
            *of_options(cli, context),
            ".SH COMMANDS",
        ]
        for name in cli.list_commands(context):
            parts += of_command(name, cli.commands[name], context)
        parts += [".SH NOTES", *paragraphs(cli.epilog or "")]
    return "\n".join(parts) + "\n"


def main() -> int:
    """Write the page, or compare it with the commands."""
    page = man_page()
    if "--check" in sys.argv[1:]:
        if PAGE.read_text(encoding="utf-8") != page:
            print(f"{PAGE} differs from the help of the commands: run {sys.executable} {__file__}", file=sys.stderr)
            return 1
        return 0
    PAGE.write_text(page, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
