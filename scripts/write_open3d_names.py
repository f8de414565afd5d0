"""Write Open3D's names: rows into docs/open3d.md, and docs/open3d-names.md from the installed Open3D.

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
What is called the same and found in the same place is not listed; what is in another module, or called otherwise, is
told by the error that its name gives: `loom.KDTreeFlann` says the row below. [open3d-names.md](open3d-names.md) goes
through Open3D itself, module by module, name by name.

| Open3D | here |
|---|---|
"""


def main() -> None:
    """Replace the last section of the one page, and the whole of the other."""
    rows = []
    for section, names in sections().items():
        rows += [f"| **{section}** | |", *(f"| `{name}` | {row} |" for name, row in names.items())]
    PAGE.write_text(PAGE.read_text().partition(HEAD)[0].rstrip() + f"\n\n{HEAD}{TEXT}" + "\n".join(rows) + "\n")
    sys.path.insert(0, str(ROOT))
    from scripts.open3d_names_page import page

    EVERY_NAME.write_text(page())


if __name__ == "__main__":
    main()
