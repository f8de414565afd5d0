"""Depth, normals and confidence (1 - cost) n / (n + 1) of planes, with n sources that agree in the round trip."""

from ..array_types import Array1, Scalars, Vectors
from ..lang import array, float32, kernel, launch, tid, vec3, vec4
from ..memory import empty
from .inverse_planes import normal_of
from .patch_costs import Reference, Sources, round_trip

WORST_COST = 1.0  # of uncorrelated patches: no depth
AGREED_PIXELS = 1.0
AGREED_FRACTION = 0.01


@kernel
def finish_planes_kernel(
    reference: Reference,
    sources: Sources,
    planes: array(dtype=vec4),
    depth: array(dtype=float32),
    normals: array(dtype=vec3),
    confidence: array(dtype=float32),
):
    """Depth, normal toward the camera, and confidence of each pixel. Zero without depth."""
    i = tid()
    x = i % reference.width
    y = i // reference.width
    plane = planes[i]
    z = 0.0
    n = vec3(0.0, 0.0, 0.0)
    trust = 0.0
    if plane[0] > 0.0 and plane[3] < WORST_COST:
        z = 1.0 / plane[0]
        n = normal_of(plane, x, y, reference.lens) * -1.0
        agreed = 0
        for s in range(sources.count):
            back = round_trip(x, y, plane[0], s, sources)
            if back[0] < AGREED_PIXELS and abs(back[1] - plane[0]) < AGREED_FRACTION * plane[0]:
                agreed += 1
        trust = (1.0 - plane[3]) * float(agreed) / float(agreed + 1)
    depth[i] = z
    normals[i] = n
    confidence[i] = trust


def finish_planes(reference: Reference, sources: Sources, planes: Array1[vec4]) -> tuple[Scalars, Vectors, Scalars]:
    count, device = reference.width * reference.height, planes.device
    depth, normals, confidence = (
        empty(count, float32, device),
        empty(count, vec3, device),
        empty(count, float32, device),
    )
    launch(finish_planes_kernel, count, [reference, sources, planes, depth, normals, confidence])
    return depth, normals, confidence
