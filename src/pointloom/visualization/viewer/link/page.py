"""The served page with its compressed form, ETag and hashes: `ServedPage`."""

from __future__ import annotations

import base64
import gzip
import hashlib
import re

_INLINE = re.compile(rb"<(script|style)\b[^>]*>(.*?)</\1>", re.DOTALL | re.IGNORECASE)


class ServedPage:
    """A self-contained page in UTF-8, `packed` by gzip, with its ETag and the hashes of its scripts and styles."""

    def __init__(self, text: bytes):
        self.text, self.packed = text, gzip.compress(text, 6, mtime=0)
        self.tag = f'"{hashlib.sha256(text).hexdigest()[:32]}"'
        self.sources: dict[str, list[str]] = {"script": [], "style": []}
        for kind, inside in _INLINE.findall(text):
            digest = base64.b64encode(hashlib.sha256(inside).digest()).decode()
            self.sources[kind.decode().lower()].append(f"sha256-{digest}")


REFUSED = """<!doctype html>
<html lang="en"><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>pointloom</title>
<style>{style}</style>
<h1>This address lacks its token</h1>
<p>Open the complete address that the program printed, including <code>?token=</code> and the text after it.</p>
<p>If the program was restarted, it printed a new address, and the old one is no longer valid.</p>
</html>
"""
_STYLE = (
    ":root{color-scheme:light dark}body{font:16px/1.5 system-ui,sans-serif;max-width:34em;margin:15vh auto;"
    "padding:0 1em}h1{font-size:1.3em}code{white-space:nowrap}"
)


def refused_page() -> ServedPage:
    return ServedPage(REFUSED.format(style=_STYLE).encode())
