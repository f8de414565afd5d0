"""What a package page shows beside pyproject.toml: the project's URLs, and the README with links that work there.

The repository's address stands once, in pyproject.toml under [tool.hatch.metadata.hooks.custom]. Where it is empty
there are no URLs, and the README's links stay relative. The build backend runs this (hatchling's metadata hooks).
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

from hatchling.metadata.plugin.interface import MetadataHookInterface

# [text](place) and ![text](place), where the place is no address and no part of the page itself.
_LINK = re.compile(r"(!?)(\[[^\]]*\]\()(?![a-z]+:|#|/)([^)\s]+)(\))")


class Metadata(MetadataHookInterface):
    """Gives the fields that pyproject.toml calls dynamic: readme and urls."""

    def update(self, metadata: dict[str, Any]) -> None:
        """Add them."""
        repository, branch = self.config["repository"], self.config["branch"]
        text = Path(self.root, "README.md").read_text(encoding="utf-8")
        metadata["readme"] = {"content-type": "text/markdown", "text": absolute_links(text, repository, branch)}
        metadata["urls"] = project_urls(repository, branch, self.config["documentation"])


def absolute_links(text: str, repository: str, branch: str) -> str:
    """Markdown whose links into the repository are addresses: of pages, and of files themselves for pictures."""
    if not repository:
        return text
    base = repository.rstrip("/")

    def absolute(link: re.Match[str]) -> str:
        bang, opening, target, closing = link.groups()
        return f"{bang}{opening}{base}/{'raw' if bang else 'blob'}/{branch}/{target}{closing}"

    return _LINK.sub(absolute, text)


def project_urls(repository: str, branch: str, documentation: str = "") -> dict[str, str]:
    """The project's addresses by name; none without a repository. Pages are those of the site, where it has a place."""
    if not repository:
        return {}
    base = repository.rstrip("/")
    return {
        "Repository": base,
        "Documentation": f"{documentation.rstrip('/')}/stable/"
        if documentation
        else f"{base}/blob/{branch}/docs/README.md",
        "Changelog": f"{base}/blob/{branch}/CHANGELOG.md",
        "Issues": f"{base}/issues",
    }
