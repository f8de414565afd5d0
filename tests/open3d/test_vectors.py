"""NumPy and Python treat a vector of pointloom.open3d as they treat one of Open3D."""

import numpy as np
import pytest

import pointloom.open3d as bridge

SHAPES = {"DoubleVector": (4,), "IntVector": (4,), "Vector2dVector": (4, 2), "Vector3dVector": (4, 3)}
SHAPES |= {"Vector2iVector": (4, 2), "Vector3iVector": (4, 3), "Vector4iVector": (4, 4)}
SHAPES |= {"Matrix3dVector": (4, 3, 3), "Matrix4dVector": (4, 4, 4)}
NUMPY = """v - a; a - v; v * np.float64(2); np.float64(2) / v; v < a.mean(); a[v > a.mean()]; v == a; a == v; v != a
np.max(v, axis=0); np.min(v); np.sum(v); np.abs(v); np.sqrt(v); np.isnan(v); np.any(v); np.all(v); np.add(v, 1)
np.power(v, 2); np.multiply(v, v); np.maximum.reduce(v); np.add.accumulate(v); np.cumsum(v); np.clip(v, 1, 2)
np.linalg.norm(v - a.mean(axis=0), axis=-1); np.quantile(v, 0.5); np.round(v, 1); np.where(v > np.mean(v), v, 0)
np.asarray(v, np.int64); np.array_equal(v, a); np.concatenate([v, v]); np.argsort(v, axis=0)
v >= a.min(axis=0); a.mean(axis=0) - v; a.mean(axis=0) > v; v ** np.float64(2); a % v; v // a; np.subtract.outer(v, v)
np.mean(v, axis=0); np.std(v); np.var(v); np.median(v); np.ptp(v, axis=0); np.prod(v, axis=0); np.argmax(v)
np.unique(v); np.ravel(v); np.sort(v, axis=0); np.diff(v, axis=0); np.shape(v); np.size(v); np.ndim(v); np.flip(v)
np.vstack([v, a]); np.stack([v, v]); np.append(v, v); np.delete(v, 0, axis=0); np.insert(v, 0, 1, axis=0); np.tile(v, 2)
np.repeat(v, 2, axis=0); np.roll(v, 1, axis=0); np.split(v, 2)[0]; np.take(v, [0, 2], axis=0); np.isin(v, [1, 2])
np.percentile(v, 30); np.average(v, axis=0); np.histogram(v)[0]; np.nonzero(v)[0]; np.allclose(v, a); np.isclose(v, a)
np.isfinite(v); np.nan_to_num(v); np.zeros_like(v); np.ones_like(v); np.full_like(v, 2); np.expand_dims(v, 0)
np.reshape(v, -1); np.transpose(v); np.moveaxis(v, 0, -1); np.einsum("i...->...", v); np.tensordot(v, v, axes=(0, 0))
np.dot(v, a.T); np.inner(v, v); np.count_nonzero(v); np.digitize(v, [1, 2]); np.interp(v, [0, 9], [0, 1]); np.sign(v)
np.maximum(v, a); np.hypot(v, v); np.logical_and(v, a); np.floor(v); np.exp(v); np.union1d(v, v); np.nansum(v)
np.array(v, np.float32); v == a.tolist(); np.pad(v, 1); np.broadcast_to(v, (2, *a.shape))"""
NUMPY = [call.strip() for call in NUMPY.replace("\n", ";").split(";")]

# Vectors compare as wholes with each other, and are no numbers in Python's own operators.
COMPARED = ["v == new(a)", "v != new(a + 1)", "not v == new(a[1:])", "v != None", "v[1:] == new(a[1:])", "not v == 2"]
REFUSED = ["v - v", "v + 1", "2 * v", "-v", "abs(v)", "v < v", "v < 2", "hash(v)", "v.shape", "v.sum()", "v @ v"]
REFUSED += ["np.add(v, 1, out=v)", "new(a.T[:, None])", "new(['a'])", "new(3)", "v[9]", "v['a']"]
MADE = [
    "list(a)",
    "tuple(a)",
    "(row for row in a)",
    "iter(a)",
    "map(list, a) if a.ndim > 1 else map(type(a[0]), a)",
    "v",
]
MADE += ["dict.fromkeys(range(4), 0) and a", "a[::-1][::-1]", "np.asfortranarray(a)", "new(a)[:]"]


def behavior(o3d, kind):
    """True for each call that has the result of the vector's array, and for each that is rejected."""
    array = np.arange(1, 1 + np.prod(SHAPES[kind])).reshape(SHAPES[kind]) % 7 + 1
    array = array.astype(np.int32) if "iVector" in kind or kind == "IntVector" else array / 4
    new = getattr(o3d.utility, kind)
    names = {"np": np, "v": new(array), "a": np.asarray(new(array)), "new": new}
    found = [
        not is_refused(call, names) and equals(*(eval(call, names | {"v": names[v]}) for v in "va")) for call in NUMPY
    ]
    found += [eval(call, names) for call in COMPARED] + [is_refused(call, names) for call in REFUSED]
    return np.array(found + [equals(np.asarray(new(eval(call, names))), array) for call in MADE], bool)


def equals(one, other):
    return np.array_equal(one, other) and type(one) is type(other)


def is_refused(call, names):
    try:
        eval(call, names)
    except (TypeError, ValueError, AttributeError, IndexError, RuntimeError):
        return True
    return False


@pytest.fixture(scope="module")
def of_open3d(oracle):
    return oracle("open3d/vectors", lambda o3d: {kind: behavior(o3d, kind) for kind in SHAPES})


@pytest.mark.parametrize("kind", SHAPES)
def test_vectors_behave_as_those_of_open3d(kind, of_open3d):
    stored, actual = of_open3d[kind], behavior(bridge, kind)
    calls = [*NUMPY, *COMPARED, *REFUSED, *MADE]
    assert [call for call, one, other in zip(calls, stored, actual, strict=True) if one != other] == []
    assert stored.sum() > 0.95 * len(stored)


@pytest.mark.parametrize("kind", SHAPES)
def test_ufuncs_take_vectors_as_arrays(kind):
    array = (np.arange(np.prod(SHAPES[kind])).reshape(SHAPES[kind]) % 5 + 1).astype(
        getattr(bridge.utility, kind)._dtype
    )
    vector = getattr(bridge.utility, kind)(array)
    ufuncs = [value for value in vars(np).values() if isinstance(value, np.ufunc) and value.nin < 3]
    checked = 0
    with np.errstate(all="ignore"):
        for ufunc in ufuncs:
            try:
                expected = ufunc(*[array] * ufunc.nin)
            except (TypeError, ValueError):
                continue  # not for this type or shape
            for given in [(vector,)] if ufunc.nin == 1 else [(vector, array), (array, vector), (vector, vector)]:
                np.testing.assert_array_equal(ufunc(*given), expected, err_msg=ufunc.__name__)
            checked += 1
    assert checked > 60


def test_sets_and_dictionaries_become_vectors():
    assert list(bridge.utility.IntVector({3, 1})) == [1, 3]
    assert list(bridge.utility.IntVector({3: 0, 1: 0})) == [3, 1]
    numbers = bridge.utility.DoubleVector(x / 2 for x in range(3))
    numbers.extend(x for x in (5, 6))
    assert list(numbers) == [0, 0.5, 1, 5, 6]
    with pytest.raises(TypeError, match="Vector3dVector"):
        bridge.utility.Vector3dVector("abc")
