"""POINTLOOM_MAX_REGISTERS: other limits of registers, each a separate build."""

import pytest

from pointloom.kernels.lang import array, float32, kernel, segment_reduction, tid, vector
from pointloom.kernels.language.warp_compiler import VARIABLE, max_registers_of

Two = vector(2, float32)


def made(device: str) -> object:
    @kernel(max_registers=80)
    def double_numbers_kernel(x: array(dtype=float32)):
        i = tid()
        x[i] = x[i] + x[i]

    return double_numbers_kernel.make(device)


def test_a_kernel_keeps_its_own_bound_where_none_is_tried(monkeypatch):
    monkeypatch.delenv(VARIABLE, raising=False)
    assert made("").options["cuda_max_registers"] == 80
    monkeypatch.setenv(VARIABLE, "another_kernel=96")
    assert made("").options["cuda_max_registers"] == 80


def test_a_bound_that_is_tried_is_part_of_the_hash_of_its_module(monkeypatch):
    hashes = {}
    for text, expected in (("", 80), ("double_numbers_kernel=96", 96), ("double_numbers_kernel=0", None)):
        monkeypatch.setenv(VARIABLE, text)
        kernel = made("cuda")
        assert kernel.options.get("cuda_max_registers") == expected
        hashes[text] = kernel.module.get_module_hash()
    assert len(set(hashes.values())) == 3


def test_the_cpu_has_no_registers_to_bound(monkeypatch):
    monkeypatch.setenv(VARIABLE, "double_numbers_kernel=96")
    assert "cuda_max_registers" not in made("cpu").options


def test_a_sum_goes_by_the_name_of_its_function(monkeypatch):
    monkeypatch.setenv(VARIABLE, "sum_of_squares=40")

    @segment_reduction(max_registers=128)
    def sum_of_squares(x: array(dtype=float32)) -> Two:
        i = tid()
        return Two(x[i], x[i] * x[i])

    assert sum_of_squares.make("cuda").tiles.options["cuda_max_registers"] == 40


@pytest.mark.parametrize("text", ["a", "a=", "a=b", "a=-1", "a=256", "a b=3", "=3"])
def test_another_form_is_refused(monkeypatch, text):
    monkeypatch.setenv(VARIABLE, text)
    with pytest.raises(ValueError, match=rf"{VARIABLE}: expected KERNEL=NUMBER"):
        max_registers_of("a", 80)


def test_several_kernels_are_listed_with_commas(monkeypatch):
    monkeypatch.setenv(VARIABLE, " a=64, b = 0,")
    assert [max_registers_of(name, 80) for name in "abc"] == [64, 0, 80]
