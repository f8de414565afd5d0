"""Rules of form and names in the kernel language, checked before compilation.

Warp and Taichi accept different supersets of Python. Code that fails in one of them or has another meaning is rejected
with file, line and remedy. Type rules are in inference.py.
"""

from __future__ import annotations

import ast
from collections.abc import Callable
from dataclasses import replace
from typing import Any, get_args, get_origin

from .callbacks import callback
from .inference import Inference, Inferred, Scope
from .literals import Beginnings
from .loops import YIELDED, Writer, check_loop, with_assignments
from .signatures import BOOL, FLOAT, INT, ArrayType, Type, remedy, words
from .source import Source, Vocabulary, compiled
from .structs import JOINT, fields_of, flatten
from .syntax_trees import is_stored, nodes_of, stored_names

FORBIDDEN = {
    ast.Try: "exceptions",
    ast.With: "with blocks",
    ast.Lambda: "lambdas",
    ast.ListComp: "comprehensions",
    ast.SetComp: "comprehensions",
    ast.DictComp: "comprehensions",
    ast.GeneratorExp: "comprehensions",
    ast.JoinedStr: "f-strings",
    ast.Global: "global statements",
    ast.Nonlocal: "nonlocal statements",
    ast.FunctionDef: "nested functions",
    ast.ClassDef: "classes",
    ast.Dict: "dictionaries",
    ast.List: "lists",
    ast.Set: "sets",
    ast.Starred: "starred expressions",
    ast.Delete: "del statements",
    ast.Raise: "exceptions",
    ast.Assert: "assertions",
    ast.Yield: "generators",
    ast.Await: "coroutines",
    ast.NamedExpr: "assignment expressions",
    ast.Match: "match statements",
    ast.AnnAssign: "annotations of variables (write `x = float(...)`)",
    ast.Slice: "slices",
    ast.Is: "tests by `is` (write `==`)",
    ast.IsNot: "tests by `is not` (write `!=`)",
    ast.In: "tests by `in`",
    ast.NotIn: "tests by `not in`",
    ast.Import: "imports",
    ast.ImportFrom: "imports",
}
PYTHON_NAMES = {"range", "min", "max", "abs", "int", "float", "bool", "True", "False"}
RESERVED = {"ti", "wp"}
# C++ keywords that are valid names in Python: Warp's C++ uses the names of parameters.
CPP_WORDS = frozenset(
    "alignas alignof and_eq asm auto bitand bitor case catch char16_t char32_t compl concept const consteval "
    "constexpr constinit const_cast decltype default delete do double dynamic_cast enum explicit export extern friend "
    "goto inline long mutable namespace new noexcept not_eq operator or_eq private protected public register "
    "reinterpret_cast requires short signed sizeof static static_assert static_cast struct switch template this "
    "thread_local throw typedef typeid typename union unsigned using virtual void volatile wchar_t xor xor_eq char "
    "float int bool".split()
)


def check(
    function: Callable, role: str, vocabulary: Vocabulary, source: Source | None = None, *, for_cuda: bool = False
) -> Source:
    """Check and flatten a "kernel", "reduction", "func" or "loop". Raises KernelLanguageError with a remedy."""
    is_written = source is None
    source = source or Source.of(function)
    source.for_cuda = for_cuda
    if function.__closure__ or function.__code__.co_freevars:
        names = ", ".join(function.__code__.co_freevars)
        source.fail(source.definition, f"closes over {names}; constants of a kernel stand at module level")
    if is_written:
        _check_spelling(source)
    _read_annotations(source, role)
    if role == "loop":
        check_loop(source.definition, source.fail)
        _check_named_loop(source, vocabulary)
        return source
    source.is_template = callback in source.written.values()
    if source.is_template:
        if role != "func":
            source.fail(source.definition, f"a {role} takes no function: hand it on to a `@func` or `@loop`")
        return source
    _write_out(source, vocabulary)
    _check_flat(source, role, vocabulary)
    return source


def _check_named_loop(source: Source, vocabulary: Vocabulary) -> None:
    if callback in source.written.values():
        return  # the type of its calls is inferred where it is used
    inlined = replace(source, definition=with_assignments(source.definition))
    _write_out(inlined, vocabulary)
    known = _check_flat(inlined, "loop", vocabulary)
    parts = (
        inlined.result
        if isinstance(inlined.result, tuple) and not isinstance(inlined.result, Type)
        else (inlined.result,)
    )
    yielded = tuple(known.get(name) for name in sorted(known) if name.startswith(YIELDED))
    if inlined.result is not None and None not in yielded and parts != yielded:
        source.fail(source.definition, f"hands out {words(yielded)}, declared {words(parts)}")


def _write_out(source: Source, vocabulary: Vocabulary) -> None:
    """Inline loops, callbacks and structures, and compile the flat function if there were any."""
    function, definition = source.function, source.definition
    writer = Writer(definition, source.written, function.__globals__, vocabulary.words, source.fail)
    if writer.has_work(function):
        definition.body, source.expected = writer.write(definition.body), writer.expected
    scope = {**function.__globals__, **writer.names}
    annotations, source.field_paths = flatten(definition, source.written, scope, source.fail)
    if not writer.count and len(annotations) == len(source.written) and not any(p.path for p in source.field_paths):
        return
    if "return" in function.__annotations__:
        annotations["return"] = function.__annotations__["return"]
    source.function = compiled(definition, annotations, scope, function)


def _check_spelling(source: Source) -> None:
    for node in nodes_of([source.definition]):
        name = node.id if isinstance(node, ast.Name) else node.arg if isinstance(node, ast.arg) else ""
        if isinstance(node, ast.arg) and name in CPP_WORDS:
            source.fail(node, f"{name} is a word of C++, which no parameter may be called; choose another name")
        if JOINT in name:
            message = f"{name}: two underscores join a structure and its field; choose another name"
            source.fail(node, message, as_it_is=True)


def _check_flat(source: Source, role: str, vocabulary: Vocabulary) -> dict[str, Inferred]:
    _check_annotations(source, role, vocabulary)
    nodes = nodes_of(source.body)
    shapes = {id(node.value) for node in nodes if isinstance(node, ast.Subscript)}
    for node in nodes:
        _check_form(source, node)
        if isinstance(node, ast.Attribute) and not (id(node) in shapes and _is_shape(source, node)):
            source.fail(node, f".{node.attr}: `array.shape[k]` is the one attribute; components are v[0], v[1], ...")
    if role in ("kernel", "reduction"):
        _check_thread_index(source, role)
    _check_pairs(source, nodes)
    _check_returns(source, role, nodes)
    local = {node.id for node in nodes if is_stored(node)}  # type: ignore[attr-defined]
    _check_globals(source, vocabulary, nodes, local | {a.arg for a in source.definition.args.args})
    _check_scopes(source, role, local)
    return _check_types(source, vocabulary, local)


def _read_annotations(source: Source, role: str) -> None:
    arguments = source.definition.args
    if arguments.vararg or arguments.kwarg or arguments.kwonlyargs or arguments.posonlyargs or arguments.defaults:
        source.fail(source.definition, "parameters are positional, without defaults")
    annotations = source.function.__annotations__
    for argument in arguments.args:
        annotation = annotations.get(argument.arg)
        if annotation is None:
            source.fail(argument, f"parameter {argument.arg} needs a type")
        if isinstance(annotation, str):
            source.fail(argument, "remove `from __future__ import annotations` from kernel files: it hides the types")
        source.written[argument.arg] = annotation
    if fields_of(annotations.get("return")) is not None:
        source.fail(source.definition, f"a {role} returns no structure: return numbers, or write to its arrays")


def _check_annotations(source: Source, role: str, vocabulary: Vocabulary) -> None:
    annotations = source.function.__annotations__
    for argument in source.definition.args.args:
        annotation = annotations.get(argument.arg)
        kind = vocabulary.array_of(annotation) or vocabulary.type_of(annotation)
        if kind is None or kind == BOOL or (isinstance(kind, ArrayType) and kind.element == BOOL):
            remedy = "write uint8 for flags" if isinstance(kind, ArrayType) else "write int for flags"
            source.fail(argument, f"parameter {argument.arg} is no number, vector, matrix or array of them; {remedy}")
        source.parameters[argument.arg] = kind
    source.result = _declared(annotations.get("return"), vocabulary)
    if role == "reduction" and not (isinstance(source.result, Type) and len(source.result.shape) == 1):
        source.fail(source.definition, "a reduction names the type of its vector: `-> vec4`")


def _declared(annotation: object, vocabulary: Vocabulary) -> Inferred:
    if get_origin(annotation) is tuple:
        return tuple(vocabulary.type_of(part) for part in get_args(annotation))
    return vocabulary.type_of(annotation)


def _check_form(source: Source, node: ast.AST) -> None:
    if type(node) in FORBIDDEN:
        source.fail(node, f"{FORBIDDEN[type(node)]} are not in the kernel language")
    match node:
        case ast.Compare(ops=ops):
            if (banned := next((op for op in ops if type(op) in FORBIDDEN), None)) is not None:
                source.fail(node, f"{FORBIDDEN[type(banned)]} are not in the kernel language")
            if len(ops) > 1:
                source.fail(node, "chained comparisons: write `a < b and b < c`")
        case ast.Assign(targets=targets) if len(targets) > 1:
            source.fail(node, "one assignment a line: `a = b = c` is not in the kernel language")
        case ast.For() | ast.While() if node.orelse:
            source.fail(node.orelse[0], "`else` of a loop is not in the kernel language: keep a flag")
        case ast.Subscript(value=ast.Attribute(attr="shape"), slice=index) if not isinstance(index, ast.Constant):
            source.fail(node, "`.shape[k]` takes a literal k")
        case ast.Call(func=called, keywords=keywords):
            if keywords:
                source.fail(node, "arguments are positional")
            if not isinstance(called, ast.Name):
                source.fail(node, "call functions by their plain names; methods are not in the kernel language")
        case ast.Expr(value=value) if not isinstance(value, ast.Call):
            source.fail(node, "a line that does nothing" if isinstance(value, ast.Constant) else "its value is lost")
        case ast.Name(id=name) | ast.arg(arg=name) if name in RESERVED or (name.endswith("_") and name != "_"):
            source.fail(node, f"the name {name} is taken by the compilers: choose another")
    if isinstance(node, ast.For):
        called = node.iter
        if not (isinstance(called, ast.Call) and getattr(called.func, "id", "") == "range"):
            source.fail(node, "loops run over range(...) or a @loop")
        if not isinstance(node.target, ast.Name):
            source.fail(node, "a loop has one variable")
        if len(called.args) > 2:
            source.fail(node, "range has no step: count by one and compute, or write a `while` loop")


def _is_shape(source: Source, node: ast.Attribute) -> bool:
    owner = source.parameters.get(node.value.id) if isinstance(node.value, ast.Name) else None
    return node.attr == "shape" and isinstance(owner, ArrayType)


def _check_thread_index(source: Source, role: str) -> None:
    first = source.body[0]
    is_tid = (
        isinstance(first, ast.Assign)
        and isinstance(first.targets[0], ast.Name)
        and isinstance(first.value, ast.Call)
        and isinstance(first.value.func, ast.Name)
        and first.value.func.id == "tid"
    )
    if not is_tid:
        source.fail(first, f"the first statement of a {role} is `i = tid()`")


def _check_pairs(source: Source, nodes: list[ast.AST]) -> None:
    """Reject `a, b = b, a`: Warp copies nothing there, so one name may change the other's value."""
    stored = [node.id for node in nodes if is_stored(node)] + list(source.parameters)  # type: ignore[attr-defined]
    for node in nodes:
        match node:
            case ast.Assign(targets=[ast.Tuple()], value=ast.Tuple(elts=values)):
                names = {n.id for n in nodes_of([node]) if isinstance(n, ast.Name)}
                is_changed = any(stored.count(name) > 1 for name in names)
                if is_changed or any(isinstance(value, ast.Subscript) for value in values):
                    source.fail(node, "one variable a line: Warp copies nothing here, so that a, b = b, a is no swap")


def _check_returns(source: Source, role: str, nodes: list[ast.AST]) -> None:
    returns = [n for n in nodes if isinstance(n, ast.Return)]
    source.returns = bool(returns)
    if role == "func" and source.result is not None and not returns:
        source.fail(source.body[-1], f"returns nothing, declared {words(source.result)}")
    if role != "kernel":
        for node in returns:
            if node is not source.body[-1]:
                source.fail(node, f"a {role} has one `return`, as its last statement")
        if role == "reduction" and not returns:
            source.fail(source.body[-1], "a reduction returns its vector")
        return
    for node in returns:
        if node.value is not None:
            source.fail(node, "a kernel returns nothing: write to an array")
    for loop in (n for n in nodes if isinstance(n, ast.For | ast.While)):
        for node in nodes_of([loop]):
            if isinstance(node, ast.Return):
                source.fail(node, "no `return` inside a loop: it would end the iteration in one compiler, not both")


def _check_globals(source: Source, vocabulary: Vocabulary, nodes: list[ast.AST], local: set[str]) -> None:
    scope = source.function.__globals__
    calls = {id(n.func) for n in nodes if isinstance(n, ast.Call)}
    for node in (n for n in nodes if isinstance(n, ast.Name)):
        if node.id in local or node.id in PYTHON_NAMES:
            continue
        if node.id not in scope:
            source.fail(node, f"{node.id} is not known here; define it above, at module level")
        value = scope[node.id]
        known = (
            type(value) in (int, float, bool)
            or vocabulary.is_builtin(value)
            or vocabulary.is_device_function(value)
            or vocabulary.type_of(value) is not None
        )
        if not known:
            remedy = "; constants are Python numbers" if not callable(value) else ""
            source.fail(node, f"{node.id} is a {type(value).__name__}, not a word of the kernel language{remedy}")
        if vocabulary.is_for_cuda(value) and not source.for_cuda:
            source.fail(node, f"{node.id} is CUDA's alone: it belongs in a variant, `@walk.on_cuda`")
        if vocabulary.is_device_function(value) and id(node) not in calls:
            source.fail(node, f"{node.id} is a function: call it, or hand it on to a `callback`")


def _check_scopes(source: Source, role: str, assigned: set[str]) -> None:
    """Reject names first assigned inside a branch or loop and read after it, and changes to outer variables."""
    fixed, index = {}, None
    if role in ("kernel", "reduction"):
        index = source.body[0]
        fixed = dict.fromkeys(source.parameters, "a parameter")
        fixed[index.targets[0].id] = "the thread's index"  # type: ignore[attr-defined]
    fixed |= {name: "an array" for name, kind in source.parameters.items() if isinstance(kind, ArrayType)}

    def visit(statements: list[ast.stmt], known: set[str], fixed: dict[str, str]) -> None:
        for statement in statements:
            if isinstance(statement, ast.If | ast.While):
                read(statement.test, known)
                visit(statement.body, set(known), fixed)
                visit(statement.orelse, set(known), fixed)
            elif isinstance(statement, ast.For):
                assert isinstance(statement.target, ast.Name)
                read(statement.iter, known)
                name = statement.target.id
                if name in known:
                    source.fail(statement, f"{name} is in use: give the loop a variable of its own")
                visit(statement.body, known | {name}, fixed | {name: "the variable of a loop"})
            else:
                read(statement, known)
                for name in sorted(stored_names([statement])):
                    if name in fixed and statement is not index:
                        source.fail(statement, f"{name} is {fixed[name]}: change a copy, `copy = {name}`")
                    known.add(name)

    def read(tree: ast.AST, known: set[str]) -> None:
        for node in nodes_of([tree]):
            if isinstance(node, ast.AugAssign) and isinstance(node.target, ast.Name) and node.target.id not in known:
                source.fail(node, f"set {node.target.id} before it is changed")
            if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load):
                if node.id in assigned and node.id not in known:
                    source.fail(node, f"set {node.id} before the branch or loop that changes it")
            if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "tid" and tree is not index:
                source.fail(node, "tid() is called once, first in a kernel: pass the index on")

    visit(source.body, set(source.parameters), fixed)


def _check_types(source: Source, vocabulary: Vocabulary, local: set[str]) -> dict[str, Inferred]:
    names = source.function.__globals__

    def constant(name: str) -> int | float | bool | None:
        value = names.get(name)
        return value if type(value) in (int, float, bool) else None

    def type_named(name: str) -> Type | None:
        return {"int": INT, "float": FLOAT, "bool": BOOL}.get(name) or vocabulary.type_of(names.get(name))

    def builtin_named(name: str) -> str | None:
        value: Any = names.get(name)
        if vocabulary.is_builtin(value):
            return value.name
        return name if name in {"min", "max", "abs"} else None

    def signature(name: str) -> tuple[list[Inferred], Inferred] | None:
        value: Any = names.get(name)
        if not vocabulary.is_device_function(value):
            return None
        return list(value.source.parameters.values()), value.source.result if value.source.returns else ()

    scope = Scope(constant, type_named, builtin_named, signature, source.fail)
    inference = Inference(scope, source.parameters, source.result)
    inference.run(source.body)
    beginnings = Beginnings(lambda name: None if name in local else constant(name), type_named)
    beginnings.write(source.body)
    for value, annotation, description in source.expected:
        kind, wanted = inference.infer(value), vocabulary.array_of(annotation) or vocabulary.type_of(annotation)
        if kind and wanted and kind != wanted:
            advice = f": {remedy(wanted)}" if isinstance(wanted, Type) else ""
            source.fail(value, f"{description} is {words(wanted)}, got {words(kind)}{advice}")
    source.result = source.result or inference.returned
    if beginnings.count or inference.numbers.widened:
        taken = {name: vocabulary.scalar(name) for name in inference.numbers.widened}
        source.function = compiled(source.definition, source.function.__annotations__, names | taken, source.function)
    return inference.known
