"""Metadata of the package that is not in pyproject.toml: URLs, and the README with absolute links.

The URL of the repository is set in pyproject.toml under [tool.hatch.metadata.hooks.custom]. If it is empty, there are
no URLs, and the links of the README stay relative. The build backend runs this as a metadata hook of hatchling.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

from hatchling.metadata.plugin.interface import MetadataHookInterface

# [text](target) and ![text](target), except for URLs, absolute paths and anchors.
_LINK = re.compile(r"(!?)(\[[^\]]*\]\()(?![a-z]+:|#|/)([^)\s]+)(\))")


class Metadata(MetadataHookInterface):
    """Set the dynamic fields of pyproject.toml: readme and urls."""

    def update(self, metadata: dict[str, Any]) -> None:
        """Add the fields to the metadata."""
        repository, branch = self.config["repository"], self.config["branch"]
        text = Path(self.root, "README.md").read_text(encoding="utf-8")
        metadata["readme"] = {"content-type": "text/markdown", "text": absolute_links(text, repository, branch)}
        metadata["urls"] = project_urls(repository, branch, self.config["documentation"])


def absolute_links(text: str, repository: str, branch: str) -> str:
    """Replace relative links of Markdown by URLs into the repository: raw files for images, pages for the rest."""
    if not repository:
        return text
    base = repository.rstrip("/")

    def absolute(link: re.Match[str]) -> str:
        bang, opening, target, closing = link.groups()
        return f"{bang}{opening}{base}/{'raw' if bang else 'blob'}/{branch}/{target}{closing}"

    return _LINK.sub(absolute, text)


def project_urls(repository: str, branch: str, documentation: str = "") -> dict[str, str]:
    """URLs of the project by name; empty without a repository. The documentation is the site if its URL is set."""
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
