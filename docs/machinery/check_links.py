"""Hold that a built site is whole: every relative link leads to what is there, and nothing loads from elsewhere.

    python docs/machinery/check_links.py build/docs/html

Addresses elsewhere that pages link to are listed in `external-links.txt` beside the folder, and not visited.
"""

from __future__ import annotations

import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

LOADS = {"script": "src", "img": "src", "iframe": "src", "source": "src", "video": "src", "link": "href"}
TEMPLATE = "webpack-macros.html"  # a part of the theme that comes along, no page
NO_LOAD = {"canonical", "next", "prev", "index", "search", "alternate", "author", "copyright"}


class Page(HTMLParser):
    """What a page links to, loads, and which parts of it can be linked to."""

    def __init__(self, text: str) -> None:
        super().__init__(convert_charrefs=True)
        self.parts: set[str] = {"", "top"}
        self.links: set[str] = set()
        self.loads: set[str] = set()
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Take an element."""
        values = {name: value or "" for name, value in attrs}
        self.parts |= {values[name] for name in ("id", "name") if name in values}
        if tag == "a" and "href" in values:
            self.links.add(values["href"])
        if tag in LOADS and values.get(LOADS[tag]) and not NO_LOAD & set(values.get("rel", "").split()):
            self.loads.add(values[LOADS[tag]])
        for candidate in values.get("srcset", "").split(","):
            if candidate.strip():
                self.loads.add(candidate.split()[0])


def faults_of(site: Path) -> tuple[list[str], list[str]]:
    """What is wrong with a built site, and the addresses elsewhere that it links to."""
    paths = [path for path in sorted(site.rglob("*.html")) if path.name != TEMPLATE]
    pages = {path: Page(path.read_text(encoding="utf-8")) for path in paths}
    faults, elsewhere = [], set()
    for path, page in pages.items():
        name = path.relative_to(site)
        for target in sorted(page.links | page.loads):
            url = urlsplit(target)
            if url.scheme in {"data", "mailto", "javascript"}:
                continue
            if url.scheme or url.netloc:
                elsewhere.add(target)
                if target in page.loads:
                    faults.append(f"{name}: loads {target} from another site")
                continue
            target_path = (path.parent / unquote(url.path)).resolve() if url.path else path
            target_path = target_path / "index.html" if target_path.is_dir() else target_path
            if not target_path.exists():
                faults.append(f"{name}: {target} does not exist")
            elif target_path in pages and unquote(url.fragment) not in pages[target_path].parts:
                faults.append(f"{name}: {target} has no such anchor")
    return faults, sorted(elsewhere)


def main() -> int:
    """Print all faults. The exit status is 1 if there are any."""
    site = Path(sys.argv[1]).resolve()
    faults, elsewhere = faults_of(site)
    (site.parent / "external-links.txt").write_text("\n".join(elsewhere) + "\n", encoding="utf-8")
    for fault in faults:
        print(fault)
    count = len(list(site.rglob("*.html")))
    print(f"{site}: {count} pages, {len(faults)} faults, {len(elsewhere)} external links")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
