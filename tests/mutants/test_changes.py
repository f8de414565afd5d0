"""Each kind of change on a small source, what is never changed, and the draw."""

from __future__ import annotations

from collections import Counter

import pytest

from .changes import ChangeFinder, draw, find_changes, option_fields

FILE = "src/pointloom/pcd/limits.py"


def changes_of(source, fields=None):
    return ChangeFinder(FILE, source.encode(), fields or {}).find()


def results(source, operator, fields=None):
    """The source after each change of a kind, by its lines that differ."""
    return [change.lines(source.encode())[1] for change in changes_of(source, fields) if change.operator == operator]


@pytest.mark.parametrize(
    ("operator", "line", "expected"),
    [
        ("comparison", "return a < b <= c", ["return a <= b <= c", "return a < b < c"]),
        ("comparison", "return a is not None", ["return a is None"]),
        ("comparison", "return a not in b or not c", ["return a in b or not c", "return a not in b and not c",
         "return a not in b or bool(c)"]),
        ("constant", "return f(a, 3, 0.5, True)", ["return f(a, 4, 0.5, True)", "return f(a, 3, 1.0, True)",
         "return f(a, 3, 0.5, False)"]),
        ("operator", "return a + b * c", ["return a - b * c", "return a + b / c"]),
        ("operator", "a -= b", ["a += b"]),
        ("operator", "return 'x' + a", []),
        ("sign", "return -a", ["return (a)"]),
        ("index", "return a[0], a[-1], a[2:], a[b, 1]", ["return a[1], a[-1], a[2:], a[b, 1]",
         "return a[0], a[-2], a[2:], a[b, 1]", "return a[0], a[-1], a[1:], a[b, 1]",
         "return a[0], a[-1], a[2:], a[b, 0]"]),
        ("arguments", "return f(a, b, 1)", ["return f(b, a, 1)"]),
        ("arguments", "return isinstance(a, b)", []),
        ("minmax", "return max(a, np.floor(b))", ["return min(a, np.floor(b))", "return max(a, np.ceil(b))"]),
        ("checked", "a = check_count('a', a, low=1)", ["a = (a)"]),
    ],
)  # fmt: skip
def test_an_expression_changes_in_one_place(operator, line, expected):
    found = results(f"def f(a, b, c):\n    {line}\n    return a\n", operator)
    assert sorted(found) == sorted(expected)


@pytest.mark.parametrize(
    ("operator", "body", "expected"),
    [
        ("check", "if a < 0:\n        raise ValueError('a')", ["if False:"]),
        ("lock", "with self.lock:\n        a.b()", ["if True:"]),
        ("lock", "with open(a):\n        a.b()", []),
        ("statement", "a.b()", ["pass"]),
        ("statement", "a.b = c", ["pass"]),
        ("statement", "a = c", ["pass"]),
        ("statement", "d = c", []),
        ("statement", "if a:\n        return b", ["pass"]),
    ],
)
def test_a_statement_is_dropped_only_if_later_ones_still_have_their_variables(operator, body, expected):
    assert results(f"def f(self, a, b, c):\n    {body}\n    return a\n", operator) == expected


def test_fields_of_a_new_object_are_not_dropped():
    source = "class A:\n    def {}(self, a):\n        self.a = a\n        return\n"
    assert results(source.format("__init__"), "statement") == []
    assert results(source.format("set"), "statement") == ["pass"]


def test_an_option_is_replaced_by_its_default_at_the_start_and_where_it_is_passed_on():
    source = "def f(a, *, limit=3, mode=None):\n    b = g(a, limit=limit)\n    return h(b, mode)\n"
    assert results(source, "option") == [
        "limit = 3; b = g(a, limit=limit)", "mode = None; b = g(a, limit=limit)", "b = g(a, limit=3)",
    ]  # fmt: skip
    assert not results(source.replace("def f", "def _f"), "option")[:-1]


def test_an_option_is_replaced_before_a_loop_and_as_a_field():
    loop = 'def f(limit=3):\n    """Text."""\n    for a in range(limit):\n        yield a\n'
    assert results(loop, "option") == ['"""Text."""; limit = 3']
    source = "class IcpOption:\n    limit: int = 3\n\n\ndef f(option, other):\n    return option.limit + other.limit\n"
    fields = option_fields([source.encode()])
    assert fields == {"limit": "3"}
    assert results(source, "option", fields) == ["return 3 + other.limit"]


@pytest.mark.parametrize(
    "source",
    [
        'def f(a: int = 3) -> Array[2]:\n    """Text of 1 < 2."""\n    raise ValueError(a + 1, f"{a - 1}")\n',
        "def f(a):\n    logger.info('number %d', a + 1)\n",
        "class A:\n    b: Array[3]\n\n    def __repr__(self):\n        return g(self.a + 1, self.b < 2)\n",
        "__all__ = [1]\nfrom a import b\nif TYPE_CHECKING:\n    c = 3\nReal = float | Array\n",
        "@cache(maxsize=3)\ndef f(a):\n    return f'{a + 1}'\n",
    ],
)
def test_texts_types_and_decorators_never_change(source):
    assert changes_of(source) == []


def test_all_other_bytes_keep_their_lines():
    source = (
        "def f(a, b):\n    c = g(  # a < b\n        a, b\n    )  # é\n    a.h(\n        c,\n    )\n"
        "    return (c  # <\n  < a)\n"
    )
    data = source.encode()
    for change in changes_of(source):
        changed = change.apply(data)
        assert changed.count(b"\n") == data.count(b"\n")
        before, after = data.splitlines(), changed.splitlines()
        assert next(line for line in range(len(before)) if before[line] != after[line]) == change.line - 1
    assert results(source, "comparison") == ["<= a)"]


def test_a_draw_is_that_of_its_seed_and_has_rare_kinds(tmp_path):
    lines = [f"    a = a + {k} * b\n" for k in range(50)]
    source = f"def f(self, a, b):\n    with self.lock:\n        a = b\n{''.join(lines)}    return a\n"
    path = tmp_path / FILE
    path.parent.mkdir(parents=True)
    path.write_text(source)
    drawn = {seed: draw(tmp_path, find_changes(tmp_path, [FILE], {}), 40, seed) for seed in ("1", "2")}
    assert drawn["1"] == draw(tmp_path, find_changes(tmp_path, [FILE], {}), 40, "1") != drawn["2"]
    assert len(set(drawn["1"])) == 40
    counts = Counter(change.operator for changes in drawn.values() for change in changes)
    assert counts["lock"] >= 1 and counts["constant"] >= 5 and counts["operator"] >= 5


def test_a_draw_has_no_more_than_the_changes_that_exist(tmp_path):
    path = tmp_path / FILE
    path.parent.mkdir(parents=True)
    path.write_text("def f(a, b):\n    return a + b\n")
    assert [str(change) for change in draw(tmp_path, find_changes(tmp_path, [FILE], {}), 9, "1")] == [
        f"{FILE}:2:14:operator"
    ]
