"""Matrix products without fused multiply-add. The kernel language rejects `@` of two matrices because Warp fuses."""

from ..lang import func, mat33d, mat44d


@func
def multiply33(a: mat33d, b: mat33d) -> mat33d:
    product = mat33d(0.0)
    for row in range(3):
        for column in range(3):
            product[row, column] = a[row, 0] * b[0, column] + a[row, 1] * b[1, column] + a[row, 2] * b[2, column]
    return product


@func
def multiply44(a: mat44d, b: mat44d) -> mat44d:
    product = mat44d(0.0)
    for row in range(4):
        for column in range(4):
            total = a[row, 0] * b[0, column] + a[row, 1] * b[1, column]
            product[row, column] = total + a[row, 2] * b[2, column] + a[row, 3] * b[3, column]
    return product
