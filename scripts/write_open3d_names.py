"""Write the table of names in docs/open3d.md, and docs/open3d-names.md from the installed Open3D.

`.venv/bin/python scripts/write_open3d_names.py`
"""

import sys
from pathlib import Path

from pointloom.core.open3d_names import sections

ROOT = Path(__file__).parents[1]
PAGE = ROOT / "docs/open3d.md"
EVERY_NAME = ROOT / "docs/open3d-names.md"
HEAD = "## Every other name\n"
TEXT = """
Names that are the same in the same module are not listed. Accessing another name raises an error with its row of this
table, for example `loom.KDTreeFlann`. [open3d-names.md](open3d-names.md) lists all names of Open3D by module.

| Open3D | pointloom |
|---|---|
"""


def main() -> None:
    """Replace the last section of docs/open3d.md and all of docs/open3d-names.md."""
    rows = []
    for section, names in sections().items():
        rows += [f"| **{section}** | |", *(f"| `{name}` | {row} |" for name, row in names.items())]
    PAGE.write_text(PAGE.read_text().partition(HEAD)[0].rstrip() + f"\n\n{HEAD}{TEXT}" + "\n".join(rows) + "\n")
    sys.path.insert(0, str(ROOT))
    from scripts.open3d_names_page import page

    EVERY_NAME.write_text(page())


if __name__ == "__main__":
    main()
