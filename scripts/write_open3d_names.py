"""Write the rows of core/open3d_names.toml into docs/open3d.md: `.venv/bin/python scripts/write_open3d_names.py`."""

from pathlib import Path

from pointloom.core.open3d_names import sections

PAGE = Path(__file__).parents[1] / "docs/open3d.md"
HEAD = "## Every other name\n"
TEXT = """
What is called the same and found in the same place is not listed; what is in another module, or called otherwise, is
told by the error that its name gives: `loom.KDTreeFlann` says the row below.

| Open3D | here |
|---|---|
"""


def main() -> None:
    """Replace the page's last section."""
    rows = []
    for section, names in sections().items():
        rows += [f"| **{section}** | |", *(f"| `{name}` | {row} |" for name, row in names.items())]
    PAGE.write_text(PAGE.read_text().partition(HEAD)[0].rstrip() + f"\n\n{HEAD}{TEXT}" + "\n".join(rows) + "\n")


if __name__ == "__main__":
    main()
