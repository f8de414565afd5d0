"""Exponential function, bitwise identical everywhere: Cody-Waite reduction and the polynomial of Cephes (expf)."""

from ..lang import bits_float, floor, func

LOWEST_EXPONENT, HIGHEST_EXPONENT = -87.0, 88.0  # range in which e^x is a normal float32
PER_TWO = 1.44269504  # log2(e)
TWO_HIGH = 0.693359375  # part of ln(2) whose products with integers are exact
TWO_LOW = -2.12194440e-4  # the remainder


@func
def exp_in_float(x: float) -> float:
    """e^x to 2 units in the last place, clamped to the range."""
    y = min(max(x, LOWEST_EXPONENT), HIGHEST_EXPONENT)
    twos = floor(y * PER_TWO + 0.5)
    r = (y - twos * TWO_HIGH) - twos * TWO_LOW
    p = 1.9875691500e-4 * r + 1.3981999507e-3
    p = p * r + 8.3334519073e-3
    p = p * r + 4.1665795894e-2
    p = p * r + 1.6666665459e-1
    p = p * r + 5.0000001201e-1
    value = (p * r) * r + r + 1.0
    return value * bits_float((int(twos) + 127) << 23)
