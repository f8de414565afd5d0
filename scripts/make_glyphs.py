"""Draw glyphs with Pillow's font (Aileron, CC0) and write src/pointloom/visualization/render/glyphs.npz.

    python scripts/make_glyphs.py [--show sheet.png]

Characters missing from the font are composed of others. Another version of Pillow or FreeType may draw other shades of
gray, which also changes the stored hashes of the tests.
"""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np
from PIL import Image, ImageFont

OUTPUT = Path(__file__).resolve().parents[1] / "src/pointloom/visualization/render/glyphs.npz"
SIZES = (12, 14, 16, 20, 24, 32)
ASCII = "".join(map(chr, range(32, 127)))
FURTHER = "°±·…"  # contained in the font
MADE = "µ×²³–−\ufffd"  # composed; the last one replaces unknown characters
CHARACTERS = ASCII + FURTHER + MADE


def draw(font, character):
    """Coverage (h, w), and the column and row of its first pixel relative to the pen on the baseline."""
    mask, (left, top) = font.getmask2(character, mode="L", anchor="ls")
    width, height = mask.size
    cells = np.asarray(mask, np.uint8).reshape(height, width)
    rows, columns = np.flatnonzero(cells.any(axis=1)), np.flatnonzero(cells.any(axis=0))
    if not len(rows):
        return np.zeros((0, 0), np.uint8), 0, 0
    cells = cells[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1]
    return cells, left + int(columns[0]), top + int(rows[0])


def stroke(length, thickness):
    """A horizontal bar."""
    return np.full((thickness, length), 255, np.uint8)


def make(font, size, character):
    """Compose a character missing from the font. Returns (coverage, left, top, advance)."""
    plus, left, top = draw(font, "+")
    advance = round(font.getlength("+"))
    middle = top + len(plus) // 2
    thickness = max(1, round(size / 14))
    if character in "²³":
        small = ImageFont.load_default(round(0.65 * size))
        cells, left, _ = draw(small, "2" if character == "²" else "3")
        cap = draw(font, "H")[2]
        return cells, left, cap, round(small.getlength("2"))
    if character == "–":
        length = round(font.getlength("n"))
        return stroke(length, thickness), 0, draw(font, "-")[2], length
    if character == "−":
        return stroke(plus.shape[1], thickness), left, middle, advance
    if character == "×":
        cells, left, top = draw(font, "x")
        return cells, left, top, round(font.getlength("x"))
    if character == "µ":
        cells, left, top = draw(font, "u")
        stem = cells[len(cells) // 2].copy()
        stem[cells.shape[1] // 2 :] = 0
        depth = len(draw(font, "p")[0]) - len(draw(font, "x")[0])
        cells[-1, : cells.shape[1] // 2] = np.maximum(cells[-1], stem)[: cells.shape[1] // 2]
        return np.vstack([cells, np.tile(stem, (depth, 1))]), left, top, round(font.getlength("u"))
    height, width = len(draw(font, "H")[0]), round(0.55 * size)
    box = np.full((height, width), 255, np.uint8)
    box[thickness:-thickness, thickness:-thickness] = 0
    return box, 1, -height, width + 2


def main() -> None:
    """Write the glyphs, and an optional image of them."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--show", type=Path)
    options = parser.parse_args()
    blocks, rows, offset = [], [], 0
    for size in SIZES:
        font = ImageFont.load_default(size)
        for character in CHARACTERS:
            if character in MADE:
                cells, left, top, advance = make(font, size, character)
            else:
                cells, left, top = draw(font, character)
                advance = round(font.getlength(character))
            height, width = cells.shape
            rows.append([offset, width, height, left, top, advance])
            blocks.append(cells.ravel())
            offset += cells.size
    table = np.array(rows, np.int32).reshape(len(SIZES), len(CHARACTERS), 6)
    codes = np.array([ord(character) for character in CHARACTERS], np.int32)
    coverage = np.concatenate(blocks)
    np.savez_compressed(OUTPUT, coverage=coverage, glyphs=table, codes=codes, sizes=np.array(SIZES, np.int32))
    print(f"{OUTPUT.name}: {len(CHARACTERS)} glyphs in {len(SIZES)} sizes, {OUTPUT.stat().st_size:,} bytes")
    if options.show:
        Image.fromarray(coverage[: len(coverage) // 256 * 256].reshape(-1, 256)).save(options.show)


if __name__ == "__main__":
    main()
