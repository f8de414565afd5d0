"""The code blocks of pages: what language they are in, and why some of them cannot run anywhere."""

from __future__ import annotations

import dataclasses
import doctest
import re
import shlex
import tomllib

from .test_imports import ROOT

PAGES = ["README.md", *sorted(path.relative_to(ROOT).as_posix() for path in ROOT.glob("docs/*.md"))]
PAGES += [path.relative_to(ROOT).as_posix() for path in ROOT.glob("src/pointloom/cli/shell/*.md")]
# Pages that take over 10 s of CPU.
NIGHTLY = {
    f"docs/{name}.md" for name in ("change", "mvs", "reconstruction", "recordings", "slam", "terrain", "tiles", "video")
}
NIGHTLY |= {"src/pointloom/cli/shell/SKILL.md"}
NOT_RUN = re.compile(r"<!-- not run: (.+) -->")


@dataclasses.dataclass(frozen=True)
class Block:
    """A block of code.

    Attributes:
        page: Path of the page, from the root.
        line: Line of its fence, from 1.
        language: The language of its fence.
        code: The code.
        reason: Why it is not run; None if it is.
    """

    page: str
    line: int
    language: str
    code: str
    reason: str | None

    def input_lines(self) -> list[str]:
        """The lines of the code, of an interactive session only its input."""
        code = self.code
        if code.startswith(">>>"):
            code = "".join(example.source for example in doctest.DocTestParser().get_examples(code))
        return code.splitlines()

    def source(self) -> str:
        """The code as Python compiles it, with its line numbers on the page."""
        return "\n".join([""] * self.line + self.input_lines()) + "\n"


def blocks_of(page: str) -> list[Block]:
    """The blocks of a page, in order."""
    blocks, lines = [], (ROOT / page).read_text().splitlines()
    start = None
    for number, line in enumerate(lines):
        if not line.lstrip().startswith("```"):
            continue
        if start is None:
            start = number
            continue
        before = next((text for text in reversed(lines[:start]) if text.strip()), "")
        reason = NOT_RUN.fullmatch(before.strip())
        code = "\n".join(lines[start + 1 : number]) + "\n"
        blocks.append(Block(page, start + 1, lines[start].strip().strip("`"), code, reason[1] if reason else None))
        start = None
    assert start is None, f"{page}: the block of line {start} has no end"
    return blocks


# Why a command of a page is not run by the tests: the first pattern that its line contains. All other commands run.
NOT_RUNNABLE = {
    "network": r"^(git|pip|ssh) ",
    "checkout": r"^([A-Z_]+=\S* )*(make|python) ",
    "a name for the reader to replace": r" [A-Z]{3,} ",
    "new environment": r"^(python3 -m venv|\.) ",
    "browser": r"^pointloom (view (?!.*--screenshot)|docs .*--open)",
    "another shell": r"completion (zsh|fish)",
    "installed package": r"^man ",
}


def shell_lines(code: str) -> list[str]:
    """The commands of a shell block, one per line, without comments."""
    lines = [re.sub(r"(^|\s+)#.*", "", line) for line in code.replace("\\\n", " ").splitlines()]
    return [line for line in lines if commands_in(line)]


def obstacle(line: str) -> str | None:
    """Why the tests do not run a line of a shell block, a key of NOT_RUNNABLE. None if they do."""
    return next((reason for reason, pattern in NOT_RUNNABLE.items() if re.search(pattern, line)), None)


EXTRAS = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["optional-dependencies"]
TARGETS = set(re.findall(r"^([\w-]+):", (ROOT / "Makefile").read_text(), flags=re.MULTILINE))


def commands_in(code: str) -> list[list[str]]:
    """The commands of a shell block in words, the parts of a pipe apart, without settings of the environment."""
    commands = []
    for line in code.replace("\\\n", " ").splitlines():
        words = shlex.split(line, comments=True)
        part: list[str] = []
        for word in [*words, "|"]:
            if word in ("|", "&&", ">"):
                commands += [part] if part else []
                part = []
            elif part or not re.fullmatch(r"[A-Z_]+=.*", word):
                part.append(word)
    return commands


def fault_of(words: list[str]) -> str | None:
    """What is wrong with a command that a page shows; None where a reader could type it."""
    import click

    from pointloom.cli.shell.cli import cli

    name, *rest = words
    if name == "pointloom":
        try:
            if not rest:  # shows the help
                return None
            with cli.make_context(name, list(rest)) as context:
                left = [*context._protected_args, *context.args]
                command_name, command, given = cli.resolve_command(context, left)
                if command is not None:
                    command.make_context(command_name, given, parent=context)
        except click.exceptions.Exit:  # --help, --version
            return None
        except click.ClickException as error:
            return error.format_message()
        return None
    if name == "make":
        wrong = [word for word in rest if "=" not in word and not word.startswith("-") and word not in TARGETS]
        return f"no such target of the Makefile: {wrong}" if wrong else None
    if name == "pip":
        extras = [extra for word in rest for extra in re.findall(r"pointloom\[(.+)\]", word)]
        wrong = [extra for listed in extras for extra in listed.split(",") if extra not in EXTRAS]
        return f"no such extra: {wrong}" if wrong else None
    if words[:3] == ["python3", "-m", "venv"]:
        return None
    if name == "python":
        return None if (ROOT / rest[0]).is_file() else f"no such script: {rest[0]}"
    return None if name in KNOWN else f"{name}: a command that nobody checks"


KNOWN = (".", "cd", "git", "ssh", "eval", "source", "zcat", "cat", "man")  # of every system
