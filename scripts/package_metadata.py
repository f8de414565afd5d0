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

ADDRESSES = ("repository", "issues", "security", "documentation", "branch")


class Metadata(MetadataHookInterface):
    """Set the dynamic fields of pyproject.toml: readme and urls."""

    def update(self, metadata: dict[str, Any]) -> None:
        """Add the fields to the metadata."""
        repository, branch = self.config["repository"], self.config["branch"]
        text = Path(self.root, "README.md").read_text(encoding="utf-8")
        metadata["readme"] = {"content-type": "text/markdown", "text": absolute_links(text, repository, branch)}
        metadata["urls"] = project_urls(**{key: self.config[key] for key in ADDRESSES})


def absolute_links(text: str, repository: str, branch: str) -> str:
    """Replace relative links of Markdown by URLs into the repository: raw files for images, pages for the rest.

    The clone command gets the address, too.
    """
    if not repository:
        return text
    base = repository.rstrip("/")

    def absolute(link: re.Match[str]) -> str:
        bang, opening, target, closing = link.groups()
        return f"{bang}{opening}{base}/{'raw' if bang else 'blob'}/{branch}/{target}{closing}"

    return with_address(_LINK.sub(absolute, text), repository)


def with_address(text: str, repository: str) -> str:
    """Replace the placeholder of clone commands by the address of the repository, if it is set."""
    placeholder = r"git clone REPOSITORY (.*?)(?: +# REPOSITORY:.*)?$"
    return re.sub(placeholder, rf"git clone {repository} \1", text, flags=re.MULTILINE) if repository else text


def project_urls(
    repository: str, branch: str, documentation: str = "", issues: str = "", security: str = ""
) -> dict[str, str]:
    """URLs of the project by name; empty without a repository. The documentation is the site if its URL is set."""
    if not repository:
        return {}
    base = repository.rstrip("/")
    urls = {
        "Repository": base,
        "Documentation": f"{documentation.rstrip('/')}/stable/"
        if documentation
        else f"{base}/blob/{branch}/docs/README.md",
        "Changelog": f"{base}/blob/{branch}/CHANGELOG.md",
        "Issues": issues or f"{base}/issues",
    }
    return urls | ({"Security": security} if security else {})
