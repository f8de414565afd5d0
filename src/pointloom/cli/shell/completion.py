"""Completion in bash, zsh and fish: click's, with files by extension. Imported for completion only."""

from __future__ import annotations

import os
from pathlib import Path

from click.shell_completion import (
    BashComplete,
    CompletionItem,
    FishComplete,
    ShellComplete,
    ZshComplete,
    add_completion_class,
)

from .format_lists import EXTENSIONS

PATH = "path"  # type of items for files and folders, which shells show by their last part
_PLAIN = "[[ $type == 'plain' ]]"


def complete_path(metavar: str | None, incomplete: str) -> list[CompletionItem]:
    """Files that match a parameter, and folders. All files if none matches."""
    extensions = EXTENSIONS.get(metavar or "")
    items: list[CompletionItem] = []
    if extensions is not None:
        folder, prefix = os.path.split(incomplete)
        begin = incomplete.removesuffix(prefix) if prefix else incomplete
        try:
            entries = sorted(os.scandir(Path(folder or ".").expanduser()), key=lambda entry: entry.name)
        except OSError:
            entries = []
        for entry in entries:
            suits = entry.is_dir() or entry.name.lower().endswith(extensions)
            if suits and entry.name.startswith(prefix) and (prefix or not entry.name.startswith(".")):
                slash = "/" if entry.is_dir() else ""
                items.append(CompletionItem(begin + entry.name + slash, type=PATH))
    return items or [CompletionItem(incomplete, type="file" if extensions != () else "dir")]


class _Bash(BashComplete):
    """Bash completion that treats files as files: a folder does not end a word."""

    source_template = BashComplete.source_template.replace(
        f"elif {_PLAIN}; then",
        f"elif [[ $type == '{PATH}' ]]; then\n            compopt -o filenames\n            "
        f'COMPREPLY+=("${{value%%/}}")\n        elif {_PLAIN}; then',
    )

    @staticmethod
    def _check_version() -> None:
        """Skipped: it would start bash each time, and versions before 4.4 report an error themselves."""


class _Zsh(ZshComplete):
    source_template = ZshComplete.source_template.replace(
        'elif [[ "$type" == "dir" ]]; then',
        f'elif [[ "$type" == "{PATH}" ]]; then\n            if [[ "$key" == */ ]]; then\n                '
        'compadd -U -S "" -- "$key"\n            else\n                compadd -U -- "$key"\n            fi\n'
        '        elif [[ "$type" == "dir" ]]; then',
    )


class _Fish(FishComplete):
    source_template = FishComplete.source_template.replace(
        'else if test $metadata[1] = "plain";',
        f'else if test $metadata[1] = "{PATH}";\n            echo $metadata[2];\n        '
        'else if test $metadata[1] = "plain";',
    )


SHELLS: dict[str, type[ShellComplete]] = {"bash": _Bash, "zsh": _Zsh, "fish": _Fish}
for _name, _class in SHELLS.items():
    add_completion_class(_class, _name)
