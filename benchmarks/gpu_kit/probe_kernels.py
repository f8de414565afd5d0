"""The kernel of the timed loop, in a separate module, since importing it starts Warp."""

from pointloom.kernels.lang import array, int32, kernel, tid


@kernel
def count_down_kernel(left: array(dtype=int32)):  # type: ignore[valid-type]
    i = tid()
    left[i] = left[i] - 1
