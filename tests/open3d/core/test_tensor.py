"""Tensors and searches: values as NumPy's on every device, and Open3D's rules."""

import ast
import copy
import importlib
import pickle
from pathlib import Path

import numpy as np
import pytest

import pointloom as loom
import pointloom.open3d
import pointloom.open3d.core as o3c

TYPES = ("float32", "float64", "int8", "int16", "int32", "int64", "uint8", "uint16", "uint32", "uint64", "bool")
ARITHMETIC = {"add": np.add, "sub": np.subtract, "mul": np.multiply}
COMPARISONS = {"gt": np.greater, "lt": np.less, "ge": np.greater_equal, "le": np.less_equal, "eq": np.equal}
COMPARISONS |= {"ne": np.not_equal, "logical_and": np.logical_and, "logical_or": np.logical_or}
COMPARISONS |= {"logical_xor": np.logical_xor}
UNARY = ("sqrt", "sin", "cos", "exp", "abs", "floor", "ceil", "round", "trunc", "isnan", "isinf", "isfinite")
VIEWS = ["m[0]", "m[-1, 2]", "m[:, 1:3, ::2]", "m[::-1]", "m[:, 2:0:-1, 3]", "m[1, 0, 2]", "m[1:0]", "m[5:]"]
COPIES = ["m[[1, 0]]", "m[I([-1, 0])]", "m[m > 12]", "m[:, I([True, False, True])]", "m[[0, 1], :, [1, 0]]", "m[[]]"]
COPIES += ["m[1, 0:2, [1, 2]]", "m[I([[0, 1], [1, 0]])]", "m[I([False, True])]", "m[(0, 1), [2, 0]]", "m[I([0, 0, 1])]"]

# Open3D's rules for a tensor m of Int64 (2, 3, 4) with the values 0 to 23, and others
RULES = """m[0]; m[-1, 2]; m[:, ::-1, 1]; m[[1, 0]]; m[[True, False]]; m[T([-1])]; m[m > 12]; m[:, [0, 2], :2]
m[5]; m[0, 0, 0, 0]; m[[0, 1], :, [0, 1]]; m[0, [1, 2]]; m[[[0, 1], [1, 0]]]; m[1, 0:2, [1, 2]]; m[T([5])]; m[()]
m[np.int64(1)]; T(5)[0]; T(5)[:]; i + 1.5; i * 1.7; i / 2; -i / 2; 7 / i; i // 2; i - 2 > 0; i < 1.5; 1.5 - i
f + np.float64(1.5); f + np.int64(1); f / 0; -u; u - 2; u * -1; u + 300; u * 1.7; f // 2; i + f
i + T([1], o3c.int32); f + f.to(o3c.float64); b + b; b & b; b | b; b ^ b; i & i; i.logical_not()
f.logical_and(True); i == 2; b == True; i.sqrt(); b.exp(); u.abs(); b.abs(); -b; i.floor(); f.round(); i.isnan()
i + T([1, 2]); i @ i; i.sum(); u.sum(); u.prod(); b.sum(); i.mean(); f.mean(); b.min(); f.all(); b.all(); b.any()
m.sum((0, 2)); m.sum(dim=1, keepdim=True); m.argmax(); m.argmin(1); m.sum(5); f.isclose(f.to(o3c.float64))
i.clip(1.5, 2.2); f.clip(1.5, 2.5); m.T(); m[0].T(); m[0].T().clone(); m.reshape((4, -1)); m.flatten(1)
i.nonzero(as_tuple=True); T.arange(5); T.arange(0, 5.0); T.arange(5, 0, -2); T.arange(0, 1, 0.3); T.eye(2)
T.zeros(3); T.full((2,), 3.5, o3c.uint8); T([]); T(True); T(2); T(2.5); T([1.5, -1.5], o3c.int32); f.to(o3c.bool)
T(np.eye(3)) @ T([1.0, 2, 3]); T(np.eye(2)).det(); T([[2.0, 0], [0, 4]]).inv(); T([[1.0, 1], [1, 1]]).inv()
m.det(); i.item(); T([[2.0, 0], [0, 4]]).solve(T([1.0, 1])); i.append(i); m.append(m, 1)
m.append(i, 0); o3c.concatenate((i, i), 5); o3c.maximum(i, i[0])"""
RULES = [rule.strip() for rule in RULES.replace("\n", ";").split(";")]
CHANGES = """m[0] = 1.7; m[0] = [1, 2, 3, 4]; m[:, [0, 2]] = T(np.zeros((2, 2, 4))); m[m > 12] = 0; m[[0, 1]] = 7
m[0][1] = 55; m[[0]][0] = 55; m[:, 0] -= T([1, 2, 3, 4]); m[m > 21] += 100; m[m > 21] = T([1, 2])
m[0] = T([1, 2, 3]); m[5] = 1; m[0, 0, 0] = 9; m += 1.7; m.gt_(3); m.logical_not_(); m.sub_(T([1, 2, 3, 4]))
m[0, 0].add_(m); m -= T([1.5]); m[:, ::-1] = T([[1], [2], [3]])"""
CHANGES = [rule.strip() for rule in CHANGES.replace("\n", ";").split(";")]


def results_of_rules(o3d):
    """Type and values of each expression, or None if it raises."""
    results = {}
    for rule in (*RULES, *CHANGES):
        core, tensor = o3d.core, o3d.core.Tensor
        names = {"o3c": core, "T": tensor, "np": np, "m": tensor(np.arange(24).reshape(2, 3, 4))}
        names |= {"i": tensor([1, 2, 3]), "u": tensor([1, 2, 3], core.uint8), "b": tensor([True, False, True])}
        names["f"] = tensor([1.0, 2.5, -3], core.float32)
        try:
            if rule in CHANGES:
                exec(rule, names)
            value = names["m"] if rule in CHANGES else eval(rule, names)
        except RuntimeError:
            results[rule] = None
            continue
        is_tensor = isinstance(value, tensor)
        results[rule] = [str(value.dtype), list(value.strides), value.numpy().copy()] if is_tensor else value
    return results


def test_types_indices_and_views_follow_open3ds_rules(oracle):
    expected, results = oracle("open3d/tensor_rules", results_of_rules), results_of_rules(pointloom.open3d)
    for rule in (*RULES, *CHANGES):
        if isinstance(expected[rule], list) and isinstance(results[rule], list):
            assert results[rule][0] == expected[rule][0], rule
            np.testing.assert_allclose(results[rule][2], expected[rule][2], rtol=1e-6, atol=1e-12, err_msg=rule)
            if ".inv" not in rule:  # LAPACK's results are stored by columns there
                assert results[rule][1] == expected[rule][1], rule
        else:
            assert results[rule] == expected[rule], rule


def values_of(name, rng, shape=(3, 4)):
    values = rng.integers(0, 2 if name == "bool" else 100, shape).astype(name)
    return values - 50 if values.dtype.kind in "if" else values


@pytest.mark.parametrize("name", TYPES)
def test_elementwise_functions_are_numpys(device, name, rng):
    a, b = values_of(name, rng), values_of(name, rng, 4)
    left, right = (o3c.Tensor(values, device=device) for values in (a, b))
    table = COMPARISONS if name == "bool" else ARITHMETIC | COMPARISONS
    for function, expected in table.items():
        result = getattr(left, function)(right)
        assert result.device == left.device
        np.testing.assert_array_equal(result.numpy(), expected(a, b), err_msg=function, strict=True)
        changed = left.clone()
        assert getattr(changed, f"{function}_")(right) is changed
        np.testing.assert_array_equal(changed.numpy(), expected(a, b).astype(name), err_msg=function, strict=True)
    if name != "bool":
        np.testing.assert_array_equal((left - 3).numpy(), a - a.dtype.type(3), strict=True)
        is_float = a.dtype.kind == "f"
        quotients = a[0] / a.dtype.type(7) if is_float else np.trunc(a[0].astype(np.float64) / 7).astype(name)
        np.testing.assert_array_equal((left[0] / 7).numpy(), quotients, strict=True)
    for function in UNARY if a.dtype.kind == "f" else UNARY[4:] if name != "bool" else UNARY[9:]:
        with np.errstate(all="ignore"):
            expected = getattr(np, function)(a)
        result = getattr(left, function)()
        np.testing.assert_allclose(result.numpy(), expected, rtol=3e-7, atol=1e-7, err_msg=function)
        assert result.numpy().dtype in (a.dtype, bool)
    for other in TYPES:  # C leaves negative floats as unsigned integers undefined
        positive = abs(a) if a.dtype.kind == "f" else a
        result = o3c.Tensor(positive, device=device).to(getattr(o3c, other))
        np.testing.assert_array_equal(result.numpy(), positive.astype(other), strict=True)


@pytest.mark.parametrize("name", TYPES)
def test_reductions_are_numpys(device, name, rng):
    a = (values_of(name, rng, (3, 4, 5)) % 5).astype(name)
    tensor = o3c.Tensor(a, device=device)
    functions = ("all", "any") if name == "bool" else ("sum", "min", "max", "prod", "mean")[: 5 - (a.dtype.kind != "f")]
    for function in functions:
        options = {"dtype": a.dtype} if function in ("sum", "prod") else {}
        for axes in (None, 0, -1, (0, 2), [0, 1, 2], ()):
            numpy_axes = tuple(axes) if isinstance(axes, list) else axes
            for keep in (False, True):
                result = getattr(tensor, function)(dim=axes, keepdim=keep)
                expected = getattr(np, function)(a, axis=numpy_axes, keepdims=keep, **options)
                assert result.shape == expected.shape
                np.testing.assert_allclose(result.numpy(), expected, rtol=1e-5)
                assert (result.numpy().dtype, result.issame(tensor)) == (a.dtype, False)
    for function in ("argmin", "argmax") if name != "bool" else ():
        np.testing.assert_array_equal(getattr(tensor, function)(1).numpy(), getattr(a, function)(1))


@pytest.mark.parametrize("key", VIEWS + COPIES)
def test_slices_are_views_and_indices_are_copies(device, key):
    values = np.arange(24).reshape(2, 3, 4)
    tensor = o3c.Tensor(values, device=device)
    part = eval(key, {"m": tensor, "I": lambda index: o3c.Tensor(index, device=device)})
    numpy_key = f"{key[:-1]}, ...]" if key in VIEWS else key  # NumPy's m[1, 0, 2] is a copy
    expected = eval(numpy_key, {"m": values, "I": np.array})
    np.testing.assert_array_equal(part.numpy(), expected)
    assert (part.shape, part.device) == (expected.shape, tensor.device)
    part += 100
    expected += 100
    np.testing.assert_array_equal(tensor.numpy(), values)
    exec(f"{key} = 7", {"m": tensor, "I": lambda index: o3c.Tensor(index, device=device)})
    exec(f"{key} = 7", {"m": values, "I": np.array})
    np.testing.assert_array_equal(tensor.numpy(), values)
    np.testing.assert_array_equal(tensor.T().numpy() if tensor.ndim < 3 else tensor[0].T().numpy(), values[0].T)


def test_memory_is_shared_as_documented(tmp_path):
    values = np.arange(6.0).reshape(2, 3)
    shared, copied = o3c.Tensor.from_numpy(values[:, ::2]), o3c.Tensor(values)
    shared[0] = 9
    assert (values[0].tolist(), copied[0].numpy().tolist()) == ([9, 1, 9], [0, 1, 2])
    other = np.from_dlpack(copied)
    copied[1, 1] = -1
    assert other[1, 1] == -1 and o3c.Tensor.from_dlpack(other).issame(copied)
    assert not copied.clone().issame(copied) and copied.to(o3c.float64) is copied
    copied.save(tmp_path / "values.npy")
    for made in (o3c.Tensor.load(tmp_path / "values.npy"), pickle.loads(pickle.dumps(copied)), copy.deepcopy(copied)):
        assert made.allclose(copied) and not made.issame(copied)
    np.testing.assert_array_equal(np.ones(3) + copied, copied.numpy() + 1)


def test_dlpack_shares_memory_in_both_directions(device):
    tensor = o3c.Tensor(np.arange(6, dtype=np.float32).reshape(2, 3), device=device)
    for shared in (o3c.Tensor.from_dlpack(tensor), o3c.Tensor.from_dlpack(tensor.to_dlpack())):
        shared[1] += 1
        assert (shared.issame(tensor), shared.device) == (True, tensor.device)
    assert tensor.numpy().tolist() == [[0, 1, 2], [5, 6, 7]]
    part = tensor[:, 1:]
    part[:] = o3c.Tensor([[8.0, 9]], o3c.float32, device)
    assert tensor.numpy().tolist() == [[0, 8, 9], [5, 8, 9]]
    assert part.to(o3c.int64).flatten().numpy().tolist() == [8, 9, 8, 9]
    assert (part.is_contiguous(), part.contiguous().is_contiguous(), tensor[0, 0].item()) == (False, True, 0)
    assert pickle.loads(pickle.dumps(part)).allclose(part)


def test_tensors_are_printed_as_by_open3d():
    printed = repr(o3c.Tensor([[[1.5, 2], [3, 1e-10]], [[1 / 3, 1e10], [0, -1]]], device="cpu"))
    values, _, rest = printed.rpartition("\n")
    assert values == "[[[1.5 2],\n  [3 1e-10]],\n [[0.3333333333333333 10000000000],\n  [0 -1]]]"
    assert rest.startswith("Tensor[shape={2, 2, 2}, stride={4, 2, 1}, Float64, CPU:0, 0x")
    assert repr(o3c.Tensor.ones((), o3c.int32)).startswith("1\nTensor[shape={}, stride={}, Int32, CPU:0, 0x")
    assert repr(o3c.Tensor.zeros((0, 3))).startswith("0-element Tensor\nTensor[shape={0, 3}, stride={3, 1}, Float32")
    texts = str(o3c.Device("cuda", 1)), repr(o3c.uint8), str(o3c.SizeVector([2, 3]))
    assert texts == ("CUDA:1", "UInt8", "SizeVector[2, 3]")


@pytest.mark.parametrize("name", ["core/methods", "argument_types"])
def test_stubs_list_the_names_of_their_modules(name):
    folder = Path(pointloom.open3d.__file__).parent
    module = importlib.import_module(f"pointloom.open3d.{name.replace('/', '.')}")
    listed = ast.parse((folder / f"{name}.pyi").read_text()).body
    if name == "core/methods":
        methods = next(each for each in listed if isinstance(each, ast.ClassDef))
        stub = {each.name for each in methods.body if isinstance(each, ast.FunctionDef)}
        inherited = {"__module__", "__doc__", "__dict__", "__weakref__", "__hash__", "__firstlineno__"}
        inherited.add("__annotations__")  # Python 3.11 adds it to a class when it is first read
        assert stub == vars(module.TensorMethods).keys() - inherited - {"__static_attributes__"}
    else:
        stub = {ast.unparse(each.target) for each in listed if isinstance(each, ast.AnnAssign)}
        assert stub == {each for each in vars(module) if each[0].isupper()} - {"Any"}


def test_functions_of_one_name_exist_as_method_and_function():
    a = o3c.Tensor([[3.0, 1], [1, 2]])
    for name in ("det", "inv", "svd"):
        of_function, of_method = getattr(o3c, name)(a), getattr(a, name)()
        pairs = zip(of_function, of_method, strict=True) if isinstance(of_method, tuple) else [(of_function, of_method)]
        for left, right in pairs:
            np.testing.assert_array_equal(left, right)
    u, s, vt = a.svd()
    np.testing.assert_allclose((u @ o3c.Tensor.diag(s) @ vt).numpy(), a.numpy(), atol=1e-14)
    tall = o3c.Tensor([[1.0, 0], [0, 2], [1, 1]])
    expected = np.linalg.lstsq(tall.numpy(), [1.0, 2, 3], rcond=None)[0]
    np.testing.assert_allclose(tall.lstsq(o3c.Tensor([1.0, 2, 3])).numpy(), expected, atol=1e-14)


@pytest.mark.parametrize(
    ("call", "argument"),
    [
        (lambda: o3c.Tensor([1, 2]) + o3c.Tensor([1.0, 2]), "add"),
        (lambda: o3c.Tensor([1, 2]) / 0, "div"),
        (lambda: o3c.Tensor(["a"]), "np_array"),
        (lambda: o3c.Tensor(np.zeros(2, np.float16)), "dtype"),
        (lambda: o3c.Tensor([1, 2])[None], "index"),
        (lambda: o3c.Tensor.zeros((2, 2, 2)).argmax((0, 1)), "dim: expected one axis or all"),
        (lambda: o3c.Tensor([1, 2]).item(), "item"),
        (lambda: len(o3c.Tensor(1)), "length"),
        (lambda: o3c.Tensor([1, 2]).reshape((2, -3)), "dst_shape"),
        (lambda: o3c.Tensor([[1, 2]]).flatten(1, 0), "end_dim"),
        (lambda: o3c.Tensor.zeros((2, 2.5)), "shape"),
        (lambda: o3c.Device("disk:0"), "device"),
        (lambda: o3c.Tensor([1.0]).allclose(o3c.Tensor([1.0, 2])), "other"),
    ],
)
def test_errors_name_the_argument_and_are_runtime_errors(call, argument):
    with pytest.raises(RuntimeError, match=argument):
        call()


@pytest.mark.parametrize("values", [np.array("text"), np.array([1j]), np.zeros(2, np.float16), np.zeros(1, "i4,f4")])
def test_arrays_that_are_no_tensor_are_named(tmp_path, values):
    np.save(tmp_path / "a.npy", values)
    for data in ((tmp_path / "a.npy").read_bytes(), b"", b"\x93NUMPY"):
        (tmp_path / "a.npy").write_bytes(data)
        with pytest.raises(loom.FileError, match=r"a\.npy"):
            o3c.Tensor.load(tmp_path / "a.npy")


HEADERS = ["{'shape': (" + "9" * 9000, "{" + "'a':True  " * 800 + "!", "{'a': (" + "1  " * 2500 + "!"]


@pytest.mark.parametrize("text", HEADERS, ids=["digits", "keys", "numbers"])
def test_damaged_headers_are_rejected_in_linear_time(tmp_path, text):
    """Backtracking would take longer than the age of the universe."""
    (tmp_path / "a.npy").write_bytes(b"\x93NUMPY\1\0" + len(text).to_bytes(2, "little") + text.encode())
    with pytest.raises(loom.FileError, match=r"a\.npy.*header is damaged"):
        o3c.Tensor.load(tmp_path / "a.npy")


def search():
    made = o3c.nns.NearestNeighborSearch(o3c.Tensor([[0.0, 0, 0]]))
    made.knn_index()
    return made


@pytest.mark.parametrize(
    ("call", "argument"),
    [
        (lambda: search().hybrid_search(o3c.Tensor([[0.0, 0, 0]]), 1.0, 2), "hybrid_index"),
        (lambda: search().knn_search(o3c.Tensor([[0.0, 0, 0]]), 0), "knn"),
        (lambda: search().knn_search(o3c.Tensor([[0.0, 0, 0]], o3c.float32), 1), "query_points"),
        (lambda: search().knn_search(o3c.Tensor([[0.0, 0]]), 1), "query_points"),
        (lambda: o3c.nns.NearestNeighborSearch(o3c.Tensor([1.0, 2])), "dataset_points"),
        (lambda: o3c.nns.NearestNeighborSearch(o3c.Tensor([[1.0, 2]]), o3c.float32), "index_dtype"),
    ],
)
def test_errors_name_the_argument(call, argument):
    with pytest.raises(ValueError, match=argument):
        call()


RADIUS = 0.4


@pytest.mark.parametrize(("dtype", "index_dtype"), [(o3c.float32, o3c.int32), (o3c.float64, o3c.int64)])
@pytest.mark.parametrize("dimension", [3, 5])
def test_neighbors_are_those_of_brute_force(device, dtype, index_dtype, dimension, rng):
    points, queries = (rng.random((count, dimension)).astype(dtype.numpy) for count in (60, 20))
    expected = ((queries[:, None].astype(float) - points[None]) ** 2).sum(axis=2)
    order = np.argsort(expected, axis=1, kind="stable")
    queries = o3c.Tensor(queries, device=device)
    search = o3c.nns.NearestNeighborSearch(o3c.Tensor(points, device=device), index_dtype)
    search.knn_index(), search.fixed_radius_index(RADIUS), search.hybrid_index(), search.multi_radius_index()
    indices, sqdists = search.knn_search(queries, 4)
    assert (indices.dtype, sqdists.dtype, indices.device) == (index_dtype, dtype, queries.device)
    np.testing.assert_array_equal(indices.numpy(), order[:, :4])
    np.testing.assert_allclose(sqdists.numpy(), np.take_along_axis(expected, order[:, :4], 1), rtol=1e-5, atol=1e-7)
    assert search.knn_search(queries, 99)[0].shape == (20, 60)

    indices, sqdists, counts = search.hybrid_search(queries, RADIUS, 5)
    assert (indices.dtype, sqdists.dtype, counts.dtype) == (index_dtype, dtype, index_dtype)
    near = np.minimum((expected < RADIUS**2).sum(axis=1), 5)
    is_filled = np.arange(5) < near[:, None]
    np.testing.assert_array_equal(counts.numpy(), near)
    np.testing.assert_array_equal(indices.numpy(), np.where(is_filled, order[:, :5], -1))
    filled = np.where(is_filled, np.take_along_axis(expected, order[:, :5], 1), 0)
    np.testing.assert_allclose(sqdists.numpy(), filled, rtol=1e-5, atol=1e-7)

    found = search.fixed_radius_search(queries, RADIUS), search.multi_radius_search(queries, np.full(20, RADIUS / 2))
    for (indices, sqdists, splits), radius in zip(found, (RADIUS, RADIUS / 2), strict=True):
        assert (indices.dtype, sqdists.dtype, splits.dtype) == (index_dtype, dtype, index_dtype)
        near = (expected < radius**2).sum(axis=1)
        np.testing.assert_array_equal(splits.numpy(), np.concatenate([[0], np.cumsum(near)]))
        rows = np.concatenate([each[:count] for each, count in zip(order, near, strict=True)])
        np.testing.assert_array_equal(indices.numpy(), rows)


def test_points_at_the_radius_are_excluded_and_queries_may_be_none():
    search = o3c.nns.NearestNeighborSearch(o3c.Tensor([[1.0, 0, 0], [0.5, 0, 0]]))
    search.fixed_radius_index(1.0), search.knn_index(), search.hybrid_index()
    origin, none = o3c.Tensor([[0.0, 0, 0]]), o3c.Tensor.zeros((0, 3), o3c.float64)
    assert [part.numpy().tolist() for part in search.fixed_radius_search(origin, 1.0)] == [[1], [0.25], [0, 1]]
    assert [part.shape for part in search.knn_search(none, 2)] == [[0, 2], [0, 2]]
    assert [part.shape for part in search.hybrid_search(none, 1.0, 3)] == [[0, 3], [0, 3], [0]]
    assert search.fixed_radius_search(none, 1.0)[2].numpy().tolist() == [0]


def test_gpus_are_counted(device):
    assert o3c.cuda.is_available() == (o3c.cuda.device_count() > 0)
    o3c.cuda.synchronize(o3c.Device(device) if device != "cpu" else None)
    o3c.cuda.release_cache()
    assert o3c.Tensor([1], device=device).cpu().device == o3c.Device.DeviceType.CPU.name + ":0"


@pytest.mark.parametrize("kind", [np.float32, np.float64])
def test_sums_and_means_of_many_large_values_are_accurate_over_all_axes(rng, kind):
    values = (1e6 + rng.random((3, 40_000, 2))).astype(kind)
    exact = np.ascontiguousarray(np.moveaxis(values.astype(np.float64), 1, 2)).mean(axis=2)
    limit = 2 * np.spacing(kind(1e6))
    np.testing.assert_allclose(o3c.Tensor(values).mean([1]).numpy(), exact, rtol=0, atol=limit)
    np.testing.assert_allclose(
        o3c.Tensor(values).sum([1], keepdim=True).numpy()[:, 0] / 40_000, exact, rtol=0, atol=limit
    )
    np.testing.assert_allclose(o3c.Tensor(values[0]).mean(0).numpy(), exact[0], rtol=0, atol=limit)
    assert o3c.Tensor(values).mean([0, 2]).numpy().shape == (40_000,)
    assert o3c.Tensor(values[:0]).sum([0]).numpy().shape == (40_000, 2)
