"""CUDA code whose numbers begin at zero: what the compiler knows to be dead it keeps in no register."""

import pytest
import warp as wp

from pointloom.kernels import check_cuda, lang
from pointloom.kernels.lang import array, float32, int32, kernel, tid
from pointloom.kernels.language.zeroed_variables import OPTION, zeroed
from pointloom.kernels.segmentation import core_sets


@kernel
def sum_small_kernel(x: array(dtype=float32), rows: array(dtype=int32), sums: array(dtype=float32)):
    """Sums of what lies below one; a branch in a loop."""
    i = tid()
    total = 0.0
    for j in range(rows[i]):
        if x[j] < 1.0:
            half = 0.5 * x[j]
            total = total + half + half
    sums[i] = total


def source_of(module, place: str) -> str:
    """What Warp writes for a place."""
    options = module.resolve_options(wp.config) | {"output_arch": 90 if place == "cuda" else None}
    return wp._src.context.ModuleBuilder(module, options).codegen(place)


def declared(text: str) -> set[str]:
    """How variables of one number are declared."""
    lines = (line.strip() for line in text.splitlines())
    return {line.partition(" ")[2] for line in lines if line.startswith("wp::float32 var_")}


def test_numbers_of_cuda_begin_at_zero_and_those_of_the_cpu_as_warp_has_them():
    on_cuda = declared(source_of(sum_small_kernel.make("cuda").module, "cuda"))
    assert on_cuda and all(line.endswith(" = 0;") for line in on_cuda)
    on_cpu = declared(source_of(sum_small_kernel.make("cpu").module, "cpu"))
    assert on_cpu and not any("=" in line for line in on_cpu)


def test_only_numbers_are_touched():
    text = "    wp::float32* var_1;\n    wp::int32 var_2;\n    bool var_3;\n    wp::vec_t<3, wp::float32> var_4;\n"
    expected = text.replace("var_2;", "var_2 = 0;").replace("var_3;", "var_3 = 0;")
    assert zeroed(text) == expected
    assert zeroed(expected) == expected


def test_code_of_the_other_kind_is_never_taken_for_it():
    module = sum_small_kernel.make("cuda").module
    own = module.get_module_hash()
    module.options[OPTION] = False
    module.mark_modified()
    try:
        assert module.get_module_hash() != own
        assert " = 0;" not in "".join(declared(source_of(module, "cuda")))
    finally:
        module.options[OPTION] = True
        module.mark_modified()
    assert module.get_module_hash() == own


@pytest.mark.slow
def test_what_a_branch_leaves_in_a_loop_is_not_kept_for_its_next_turn():
    """Within 80 registers the kernel held 648 B in local memory when its numbers had no first value."""
    lang.settle(core_sets.__name__)
    usage = check_cuda.compile_module(core_sets.__name__, (90,)).usage[90]
    (found,) = (use for name, use in usage.items() if "unite_cores" in name)
    assert found.registers <= 80
    assert found.local_bytes < 450
