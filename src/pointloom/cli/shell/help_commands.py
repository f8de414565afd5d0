"""Commands for shell completion and documentation."""

from __future__ import annotations

import os
from pathlib import Path

import click

from .console import print_json
from .options import JSON, option, refuse

VARIABLE = "_POINTLOOM_COMPLETE"  # by which a shell requests completions
MAX_NAMES = 20  # public names that `docs` prints
BUILD = "`make docs` in a checkout builds them"


@click.command(short_help="Print a script for shell completion.")
@click.argument("shell", required=False, type=click.Choice(["bash", "zsh", "fish"]), metavar="[bash|zsh|fish]")
@JSON
def completion(shell: str | None, as_json: bool) -> int:
    """Print a script for completion of commands, options, choices, and files by extension with the tab key.

    Default: the current shell ($SHELL). Add to its startup file:

    \b
    bash    eval "$(pointloom completion bash)"      # in ~/.bashrc. Requires bash 4.4
    zsh     eval "$(pointloom completion zsh)"       # in ~/.zshrc
    fish    pointloom completion fish | source       # in ~/.config/fish/config.fish

    \b
    pointloom completion > ~/.pointloom-completion   # source this file to avoid starting Python in each shell
    """
    from .completion import SHELLS

    name = shell or Path(os.environ.get("SHELL", "")).name
    if name not in SHELLS:
        refuse(f"expected one of {', '.join(SHELLS)}, got {name or 'an unknown shell'}")
    root = click.get_current_context().find_root()
    script = SHELLS[name](root.command, {}, "pointloom", VARIABLE).source()
    if as_json:
        print_json({"command": "completion", "shell": name, "script": script})
    else:
        click.echo(script)
    return 0


@click.command(short_help="Search the documentation.")
@click.argument("words", nargs=-1, metavar="[WORDS]...")
@option("--open opens", bool, "Open the first matching page in the browser, if available.")
@option("--skill", bool, "Print the guide for coding assistants.")
@JSON
def docs(words: tuple[str, ...], opens: bool, skill: bool, as_json: bool) -> int:
    """List the chapters and guides of the documentation that contain all WORDS, or else most of them. A number is that
    of a chapter.

    For each one: its Python functions (`help(loom.NAME)` has details and an example), the corresponding commands, and
    its page. Public names that contain the words follow. Without words: all chapters. Pages are those built by `make
    docs` in this checkout, else the address of the project, if any.

    \b
    pointloom docs icp
    pointloom docs bag
    pointloom docs 11
    pointloom docs --skill > .claude/skills/pointloom/SKILL.md
    """
    from .chapters import SKILL, Chapter, chapters, docs_location, entries_of, page_of, public_names

    if skill:
        if words or opens or as_json:
            refuse("--skill excludes WORDS, --open and --json")
        click.echo(SKILL.read_text(encoding="utf-8"), nl=False)
        return 0
    words = tuple(word.lower() for word in words)
    matches = entries_of(words)
    names = public_names(words) if words else []
    if not matches and not names:
        known = ", ".join(f"{chapter.number} {chapter.title}" for chapter in chapters())
        refuse(f"no chapter, guide or public name contains {' or '.join(words)}; the chapters are {known}")
    location = docs_location()
    pages = [page_of(entry, location) for entry in matches]
    if opens:
        _open(pages[0] if words and pages else location)
    if as_json:
        rows = [(entry, entry.as_row() | {"page": page}) for entry, page in zip(matches, pages, strict=True)]
        found = [row for entry, row in rows if isinstance(entry, Chapter)]
        others = [row for entry, row in rows if not isinstance(entry, Chapter)]
        print_json({"command": "docs", "place": location, "chapters": found, "guides": others, "names": names})
        return 0
    for entry, page in zip(matches, pages, strict=True):
        click.echo(f"{entry.number if isinstance(entry, Chapter) else '':>2}  {entry.title}")
        if words:
            click.echo("    " + "\n    ".join(entry.lines(page)))
    if names:
        click.echo("    " + ", ".join(names[:MAX_NAMES]) + (", ..." if len(names) > MAX_NAMES else ""))
    if not words:
        click.echo("\npointloom docs WORDS lists the functions and the corresponding commands, also of guides.")
        click.echo(f"The pages: {location}" if location else "No built pages: `make docs` in a checkout builds them.")
    return 0


def _open(page: str | None) -> None:
    if page is None or not page.startswith(("file:", "http")):
        refuse(f"no page to open: {BUILD}")
    click.launch(page)


COMMANDS = (completion, docs)
