"""Commands for shell completion and documentation."""

from __future__ import annotations

import os
from pathlib import Path

import click

from .console import print_json
from .options import JSON, option, refuse

VARIABLE = "_POINTLOOM_COMPLETE"  # by which a shell requests completions
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
    """List the chapters and guides of the documentation that contain all WORDS, or the chapter with that number.

    Without WORDS: all chapters. For each chapter with WORDS: its Python functions (`help(loom.NAME)` has details and an
    example), the corresponding commands, and its page. Pages are those built by `make docs` in this checkout, else the
    address of the project, if any.

    \b
    pointloom docs icp
    pointloom docs 11
    pointloom docs --skill > .claude/skills/pointloom/SKILL.md
    """
    from .chapters import SKILL, chapters, docs_location, guides, page_of

    if skill:
        if words or opens or as_json:
            refuse("--skill excludes WORDS, --open and --json")
        click.echo(SKILL.read_text(encoding="utf-8"), nl=False)
        return 0
    words = tuple(" ".join(words).split())
    matches = [chapter for chapter in chapters() if chapter.speaks_of(words)]
    matching_guides = [guide for guide in guides() if words and guide.speaks_of(words)]
    if not matches and not matching_guides:
        known = ", ".join(f"{chapter.number} {chapter.title}" for chapter in chapters())
        refuse(f"no chapter and no guide contains {' '.join(words)}; the chapters are {known}")
    location = docs_location()
    pages = [page_of(chapter, location) for chapter in matches]
    guide_pages = [page_of(guide, location) for guide in matching_guides]
    if opens:
        _open([*pages, *guide_pages][0] if words else location)
    if as_json:
        rows = [chapter.as_row() | {"page": page} for chapter, page in zip(matches, pages, strict=True)]
        found = [
            {"page": page, "title": guide.title, "contents": guide.contents}
            for guide, page in zip(matching_guides, guide_pages, strict=True)
        ]
        print_json({"command": "docs", "place": location, "chapters": rows, "guides": found})
        return 0
    for chapter, page in zip(matches, pages, strict=True):
        click.echo(f"{chapter.number:>2}  {chapter.title}")
        if words:
            click.echo("    " + "\n    ".join(chapter.lines(page)))
    for guide, page in zip(matching_guides, guide_pages, strict=True):
        click.echo(f"    {guide.title}\n    " + "\n    ".join([guide.contents, *([page] if page else [])]))
    if not words:
        click.echo("\npointloom docs WORDS lists the functions and the corresponding commands.")
        click.echo(f"The pages: {location}" if location else "No built pages: `make docs` in a checkout builds them.")
    return 0


def _open(page: str | None) -> None:
    if page is None or not page.startswith(("file:", "http")):
        refuse(f"no page to open: {BUILD}")
    click.launch(page)


COMMANDS = (completion, docs)
