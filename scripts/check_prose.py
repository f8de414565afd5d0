"""Check the prose of docstrings, comments, messages, documentation, examples and tests: part of `make lint`.

LIMITS contains one limit for each measure and each group of texts. It has room for several findings above the value of
its group: 10 %, and 0.1 per 100 sentences or 1 per 10,000 words. A limit of 0 is for words that are not used at all:
one of them fails, like a spelling error. A change that exceeds a limit needs better sentences, not a higher limit.
Code, quoted text, tables, links and doctests do not count.

    python scripts/check_prose.py                   print the table of values
    python scripts/check_prose.py --list private    print each finding as file:line: sentence [words found]
"""

from __future__ import annotations

import argparse
import re
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
# docstrings, comments, messages: of src; examples: all three of docs/examples; tests: the first two of TEST_FOLDERS
GROUPS = ("docstrings", "comments", "messages", "docs", "examples", "tests")
LIMITS = {
    "relative": (0.2, 0.6, 0.2, 0.2, 0.1, 1.4),  # % of sentences that begin with a relative word; target: 0.5
    "semicolons": (6.8, 1.7, 11.0, 0.5, 1.9, 10.6),  # per 100 sentences; target: 8
    "private": (0.0, 0.0, 5.0, 0.0, 0.0, 6.0),  # PRIVATE_WORDS per 10,000 words; target: 1
    "long": (0.4, 0.2, 0.2, 0.2, 0.2, 0.5),  # sentences of more than MAX_WORDS words, per 100 sentences
    "british": (0.0, 0.0, 1.0, 1.0, 0.0, 1.0),  # BRITISH_WORDS per 10,000 words
}
TEST_FOLDERS = ("tests", "benchmarks", "scripts")
MESSAGE_WORDS = 4  # a string of fewer words is a name or a label
MAX_WORDS = 35
GENERATED = {"chapters", "commands", "gallery", "made", "project", "reference"}  # folders of docs, from `make docs`

# Words that other libraries of the field do not use, and their replacements.
PRIVATE_WORDS = (
    "told|tells?|telling|says?|said|saying|asks?|asked|knows?|believes?|believed",  # report, raise, request, accept
    r"holds?(?! (?:[\w']+ ){1,2}lock\b)|(?<!lock )(?<!lock is )held(?![ -]out)",  # contain, store, ensure
    "stands?(?! for)|stood|lies?|lay|laid(?! out)",  # is located, is defined
    "verdicts?|doubts?|doubtful|misfits?|settles?|settled|wish|wishes",  # result, warning, residual, converge, request
    "mends?|mended|mending|lent|lends?|crews?|dear|dearer|dearest|fewest|lingers?",  # fix, borrow, pool, slow, minimum
    "nobody|somebody|nowhere|ours|audience|aside(?! from)|in vain|lonely|farewell",  # no caller, pointloom, quarantined
    "shares? of|same bits|whole or not at all",  # fraction of, bitwise identical, atomically
)
# Not in the list, since each is also correct in another sense:
#   house, room, door: objects in scenes       place, turn: "in place", "in turn"       walk, reach, cheap: common verbs
#   whole, own, shown: "whole number"          poor, peer: "poor texture", sockets      twin: a half-edge
#   heap, ears, fans, forks: field terms       image: a rendered file                 farthest: point sampling
BRITISH_WORDS = (
    r"(?:dis|un)?colour\w*|neighbour\w*|behaviour\w*|favour\w*|grey\w*|\w*metres?|centre[ds]?|centring|localisab\w+",
    "fibres?|litres?|lustre|artefacts?|aluminium|defence|licences?|fulfil|judgements?|programmes?|whilst|storeys?",
    "(?:un)?(?:cancel|channel|label|level|model|signal|travel|unravel)l(?:ed|ing)|analys(?:e|ed|ing)",
    "(?:un)?(?:amort|categor|character|digit|discret|equal|factor|final|formal|general|initial|linear|local|material|maxim|minim|"
    "neutral|normal|optim|organ|parallel|parametr|quant|random|raster|real|recogn|regular|serial|stabil|standard|"
    "summar|synchron|triangular|util|vector|visual|voxel)is(?:e[ds]?|ers?|ing|ations?)",
)

# A triple-quoted string that begins its line is a docstring. The other strings are messages if they have enough words.
# Strings side by side are one. Those with three quotes are matched since they may contain a #.
STRING = r"""[rRfFbB]*(?:"(?!"")(?:[^"\\\n]|\\.)*"|'(?!'')(?:[^'\\\n]|\\.)*')"""
TOKEN = re.compile(
    r'^[ \t]*[rR]?"{3}(?P<docstrings>(?:[^"\\]|\\.|"(?!""))*)"{3}'
    r'|"{3}(?:[^"\\]|\\.|"(?!""))*"{3}'
    r"|'{3}(?:[^'\\]|\\.|'(?!''))*'{3}"
    rf"|(?P<messages>{STRING}(?:\s*{STRING})*)"
    r"|(?P<comments>^[ \t]*\#[^\n]*(?:\n[ \t]*\#[^\n]*)*|\#[^\n]*)",
    re.M | re.S,
)
JOINT = re.compile(r"""(?<!\\)["']\s*[rRfFbB]*["']""")
FIELD = re.compile(r"\{[^{}]*\}|\\n")
SQL = re.compile(r"\s*(?:SELECT|INSERT|UPDATE|DELETE|CREATE|THEN|AND|WHERE) ")
# Comment signs, pragmas, and the underlined titles of examples.
HASH = re.compile(
    r"^# [^\n]+(?=\n# ?-{3,}$)|^[ \t]*#(?: ?(?:noqa|type:|pyright|fmt:|pragma|ruff|sync$|!)[^\n]*)?|-{3,}", re.M
)
MARKUP = re.compile(
    r"^[ \t]*(```|~~~).*?^[ \t]*\1[^\n]*|<!--.*?-->|``[^`]*``|`[^`]*`|!?\[[^]]*\](?:\([^)\s]*\)|\[[^]]*\])?"
    r'|https?://\S+|"(?:[^"\n]|\n(?!\s*\n)){1,200}"|</?\w[^>\n]*>|&\w+;',
    re.M | re.S,
)
SECTION = re.compile(r"[A-Z]\w+:$")
SKIPPED = re.compile(r"\||:::|:[\w-]+:|\.\. |\(\S+\)=$|[^A-Za-z]*$|[A-Z]\w+:$")  # tables, directives, section titles
ITEM = re.compile(r"#+ +|[-*+] +|\d+[.)] +")
ENTRY = re.compile(r"[\w.*]+(?:, [\w.*]+)*(?: \([^)]*\))?: +")  # the description of an argument follows
NO_ABBREVIATION = r"(?:(?<!\b[A-Z])|(?<=\d [A-Z]))(?<!e\.g)(?<!i\.e)(?<!\bal)(?<!\bcf)(?<!\bvs)(?<!\b[Ee]q)(?<!Fig)"
END = re.compile(NO_ABBREVIATION + r"[.!?][)*_]*\s+(?=[(*_]*(?:[A-Z0-9]|--))")
PROSE = re.compile(r"[a-z]{2}")
WORD = re.compile(r"[A-Za-z][\w'-]*")

PRONOUN = r"(?:what|who|whom|whose|where|which|whatever|whoever|whomever|whichever|wherever)\b"
NOUN_CLAUSE = r"that (?:the|an?|it|its|they|this|these|those|there|he|we|you|all|both|each|every|no|nothing|one|two)\b"
RELATIVE = re.compile(rf"\W*(?:(?:(?:at|by|for|from|in|of|on|to|with) )?{PRONOUN}|{NOUN_CLAUSE})", re.I)
PRIVATE = re.compile(rf"(?<!-)\b(?:{'|'.join(PRIVATE_WORDS)})\b")
BRITISH = re.compile(rf"\b(?:{'|'.join(BRITISH_WORDS)})\b")


def relative_opening(text: str) -> list[str]:
    match = None if text.endswith("?") else RELATIVE.match(text)
    return [match[0]] if match else []


# Each returns the findings in the text of a sentence.
MEASURES: dict[str, Callable[[str], list[str]]] = {
    "relative": relative_opening,
    "semicolons": lambda text: [";"] * text.count(";"),
    "private": lambda text: PRIVATE.findall(text[:1].lower() + text[1:]),  # names and constants are capitalized
    "long": lambda text: WORD.findall(text)[MAX_WORDS:][:1],  # the first word that exceeds the limit
    "british": lambda text: BRITISH.findall(text[:1].lower() + text[1:]),
}
PER_WORDS = {"private", "british"}  # the other measures are per 100 sentences


def sentences(text: str, first_line: int = 1) -> Iterator[tuple[int, str]]:
    """The sentences of a docstring, a comment or a page of Markdown, each with its line."""
    text = MARKUP.sub(lambda match: "CODE" + "\n" * match[0].count("\n"), text)
    block: list[str] = []
    in_code = False
    section: int | None = None  # indentation of the entries of a section, -1 before the first one
    for number, row in enumerate([*text.split("\n"), ""], first_line):
        line, indent = row.strip(), len(row) - len(row.lstrip())
        in_code = bool(line) and (in_code or line.startswith((">>>", "\\b")))
        section = (indent if section == -1 else section) if line else None
        skipped = in_code or SKIPPED.match(line)
        start = ITEM.match(line) or (ENTRY.match(line) if section == indent else None)
        if skipped or start:
            yield from split(block, number - len(block))
            block = []
        if not skipped:
            block.append(line[start.end() :] if start else line)
        elif SECTION.match(line):
            section = -1


def split(block: list[str], first_line: int) -> Iterator[tuple[int, str]]:
    """The sentences of a paragraph, given as its lines."""
    text, begin = "\n".join(block), 0
    for end in [*(match.end() for match in END.finditer(text)), len(text)]:
        if PROSE.search(text, begin, end):
            yield first_line + text.count("\n", 0, begin), " ".join(text[begin:end].split())
        begin = end


def python_sentences(source: str) -> Iterator[tuple[str, int, str]]:
    """The sentences of a module, each with its group and line."""
    for match in TOKEN.finditer(source):
        if group := match.lastgroup:
            line = source.count("\n", 0, match.start(group)) + 1
            text = match[group]
            if group == "comments":
                text = HASH.sub("", text)
            elif group == "messages":
                if text.count(" ") < MESSAGE_WORDS - 1:
                    continue
                text = FIELD.sub("CODE", JOINT.sub("", text).strip("rRfFbB")[1:-1])
                if SQL.match(text) or len(WORD.findall(text)) < MESSAGE_WORDS:
                    continue
            yield from ((group, *sentence) for sentence in sentences(text, line))


def python_files(root: Path, *folders: str) -> list[Path]:
    """The modules in folders and below."""
    return sorted(path for folder in folders for path in root.glob(f"{folder}/**/*.py"))


def pages(root: Path) -> list[Path]:
    """README.md, CONTRIBUTING.md, the changes of the next version and the written pages of docs."""
    docs = [path for path in root.glob("docs/**/*.md") if path.relative_to(root).parts[1] not in GENERATED]
    return [root / "README.md", root / "CONTRIBUTING.md", *sorted(root.glob("changes/*.md")), *sorted(docs)]


def read(root: Path) -> dict[str, list[tuple[Path, int, str]]]:
    """The sentences of each group, each with its file and line."""
    texts: dict[str, list[tuple[Path, int, str]]] = {group: [] for group in GROUPS}
    for path in python_files(root, "src"):
        for group, line, text in python_sentences(path.read_text()):
            texts[group].append((path, line, text))
    for name, folders in (("examples", ["docs/examples"]), ("tests", TEST_FOLDERS)):
        for path in python_files(root, *folders):
            found = python_sentences(path.read_text())
            read_groups = GROUPS[:3] if name == "examples" else GROUPS[:2]  # strings of tests are data
            texts[name] += ((path, line, text) for group, line, text in found if group in read_groups)
    headers = sorted(root.glob("docs/examples/**/*.rst"))
    for name, paths in (("examples", headers), ("docs", pages(root))):
        texts[name] += ((path, *sentence) for path in paths for sentence in sentences(path.read_text()))
    return texts


def main() -> int:
    """The command."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--list", choices=MEASURES, metavar="MEASURE", help=f"one of {', '.join(MEASURES)}")
    parser.add_argument("--root", type=Path, default=ROOT, help="another checkout to measure")
    arguments = parser.parse_args()
    root = arguments.root.resolve()
    texts = read(root)
    if arguments.list:
        for path, line, text in (sentence for group in GROUPS for sentence in texts[group]):
            if words := MEASURES[arguments.list](text):
                print(f"{path.relative_to(root)}:{line}: {text} [{', '.join(words)}]")
        return 0
    counts = [sum(len(WORD.findall(text)) for *_, text in texts[group]) for group in GROUPS]
    print("value / limit".ljust(14), *(group.rjust(16) for group in GROUPS))
    failures = []
    for measure, find in MEASURES.items():
        row = measure.ljust(14)
        for group, count, limit in zip(GROUPS, counts, LIMITS[measure], strict=True):
            total = sum(len(find(text)) for *_, text in texts[group])
            rate = total / max(count if measure in PER_WORDS else len(texts[group]), 1)
            value = rate * (10_000 if measure in PER_WORDS else 100)
            row += f"{value:9.2f} /{limit:6g}"
            if value > limit:
                message = f"{measure} in {group}: expected at most {limit:g}, got {value:.2f}"
                failures.append(f"{message}. List the findings: python scripts/check_prose.py --list {measure}")
        print(row)
    print("".join(f"\n{failure}" for failure in failures))
    return bool(failures)


if __name__ == "__main__":
    sys.exit(main())
