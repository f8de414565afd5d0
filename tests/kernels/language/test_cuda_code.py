"""CUDA code of our kernels: elements of contiguous arrays, found without strides."""

import re
from pathlib import Path

import numpy as np
import pytest
import warp as wp

from pointloom.kernels import lang
from pointloom.kernels.lang import array, atomic_add, atomic_max, atomic_min, float32, int32, int64, kernel, launch, tid
from pointloom.kernels.language import cuda_code
from pointloom.kernels.language.warp_compiler import modules_for_cuda
from pointloom.kernels.memory import download, full, upload


@kernel
def touch_elements_kernel(
    row: array(dtype=float32), table: array(dtype=float32, ndim=2), block: array(dtype=int64, ndim=3),
    counts: array(dtype=int32, ndim=2), ends: array(dtype=int32),
):  # fmt: skip
    """Loads, stores and atomics of one, two and three axes."""
    i = tid()
    for j in range(table.shape[1]):
        table[i, j] = row[i] + float(j)
        for k in range(block.shape[2]):
            block[i, j, k] = block[i, j, k] + int64(100 * i + 10 * j + k)
        atomic_add(counts, i // 2, j, 1)
    row[i] = 2.0 * row[i]
    atomic_add(ends, 0, i)
    atomic_min(ends, 1, i)
    atomic_max(ends, 2, i)


@kernel
def move_elements_kernel(rows: array(dtype=int32), row: array(dtype=float32), out: array(dtype=float32)):
    """One axis: an index that is read, a load, a store and an atomic."""
    i = tid()
    j = rows[i]
    out[j] = row[j + 1]
    atomic_add(rows, j, 1)


def test_elements_have_the_expected_offsets(device):
    row, table = upload(np.arange(6, dtype=np.float32), float32, device), full((6, 5), -1.0, float32, device)
    block, counts = full((6, 5, 4), 7, int64, device), full((3, 5), 0, int32, device)
    ends = upload(np.array([0, 99, -1], np.int32), int32, device)
    launch(touch_elements_kernel, 6, [row, table, block, counts, ends])
    i, j, k = np.ogrid[:6, :5, :4]
    np.testing.assert_array_equal(download(row), 2.0 * np.arange(6))
    np.testing.assert_array_equal(download(table), (i + j)[..., 0])
    np.testing.assert_array_equal(download(block), 7 + 100 * i + 10 * j + k)
    np.testing.assert_array_equal(download(counts), np.full((3, 5), 2))
    np.testing.assert_array_equal(download(ends), [15, 0, 5])


@pytest.mark.slow
def test_no_element_costs_a_product_of_64_bits(tmp_path):
    lang.resolve_module(__name__)
    (module,) = modules_for_cuda(__name__)
    assert module.options["extra_build_options"].extra_cuda_preamble == cuda_code.header()
    (path,) = wp.compile_aot_module(module, arch=[90], module_dir=str(tmp_path), use_ptx=True)
    text = Path(path).read_text()
    (code,) = (part for part in text.split(".entry")[1:] if "move_elements_kernel" in part[:100])
    code = code[code.index("move_elements") :]
    assert len(re.findall(r"mul\.wide\.s32", code)) >= 2
    assert not re.search(r"(mul|mad)\.lo\.s64", code), "strides of Warp's arrays"
    assert "setp.lt.s32" not in code, "indices that count from the end"
