"""Check a built site: every relative link has a target, and no page loads files from other sites.

    python docs/machinery/check_links.py build/docs/html

External links are listed in `external-links.txt` next to the folder and not visited.
"""

from __future__ import annotations

import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

LOADS = {"script": "src", "img": "src", "iframe": "src", "source": "src", "video": "src", "link": "href"}
TEMPLATE = "webpack-macros.html"  # a part of the theme, not a page
NO_LOAD = {"canonical", "next", "prev", "index", "search", "alternate", "author", "copyright"}


class Page(HTMLParser):
    """Links, loaded files and anchors of a page."""

    def __init__(self, text: str) -> None:
        super().__init__(convert_charrefs=True)
        self.parts: set[str] = {"", "top"}
        self.links: set[str] = set()
        self.loads: set[str] = set()
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Record the attributes of an element."""
        values = {name: value or "" for name, value in attrs}
        self.parts |= {values[name] for name in ("id", "name") if name in values}
        if tag == "a" and "href" in values:
            self.links.add(values["href"])
        if tag in LOADS and values.get(LOADS[tag]) and not NO_LOAD & set(values.get("rel", "").split()):
            self.loads.add(values[LOADS[tag]])
        for candidate in values.get("srcset", "").split(","):
            if candidate.strip():
                self.loads.add(candidate.split()[0])


def check_site(site: Path) -> tuple[list[str], list[str]]:
    """Errors of a built site, and its external links."""
    paths = [path for path in sorted(site.rglob("*.html")) if path.name != TEMPLATE]
    pages = {path: Page(path.read_text(encoding="utf-8")) for path in paths}
    errors, external = [], set()
    for path, page in pages.items():
        name = path.relative_to(site)
        for target in sorted(page.links | page.loads):
            url = urlsplit(target)
            if url.scheme in {"data", "mailto", "javascript"}:
                continue
            if url.scheme or url.netloc:
                external.add(target)
                if target in page.loads:
                    errors.append(f"{name}: loads {target} from another site")
                continue
            target_path = (path.parent / unquote(url.path)).resolve() if url.path else path
            target_path = target_path / "index.html" if target_path.is_dir() else target_path
            if not target_path.exists():
                errors.append(f"{name}: {target} does not exist")
            elif target_path in pages and unquote(url.fragment) not in pages[target_path].parts:
                errors.append(f"{name}: {target} has no such anchor")
    return errors, sorted(external)


def main() -> int:
    """Print all errors. The exit code is 1 if there are any."""
    site = Path(sys.argv[1]).resolve()
    errors, external = check_site(site)
    (site.parent / "external-links.txt").write_text("\n".join(external) + "\n", encoding="utf-8")
    for error in errors:
        print(error)
    count = len(list(site.rglob("*.html")))
    print(f"{site}: {count} pages, {len(errors)} errors, {len(external)} external links")
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main())
