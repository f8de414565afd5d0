"""Write docs/open3d-names.md from the installed Open3D, and docs/other-libraries.md.

.venv/bin/python scripts/write_open3d_names.py
"""

import sys
from pathlib import Path

ROOT = Path(__file__).parents[1]


def main() -> None:
    sys.path.insert(0, str(ROOT))
    from scripts.open3d_names_page import common_page, page

    (ROOT / "docs/other-libraries.md").write_text(common_page())
    (ROOT / "docs/open3d-names.md").write_text(page())


if __name__ == "__main__":
    main()
