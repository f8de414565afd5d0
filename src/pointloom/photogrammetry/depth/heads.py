"""Classification of depth networks by the last operations of their graph, traced back from the output.

- `ReLU`: relative inverse depth (Depth Anything V2's depth_anything_v2/dpt.py, MiDaS `non_negative`, DPT), or canonical
  inverse depth (Depth Pro `DepthPro.head`).
- `Sigmoid` times 20 or 80: Depth Anything V2's metric_depth/depth_anything_v2/dpt.py, meters.
- `ReLU` times 20 or 80: a wrong export of a metric network, unusable: fabio-sim/Depth-Anything-ONNX before pull request
  27 (October 2024), transformers before issue 32890 (August 2024).
- Sum of `Softmax` times bin depths: ZoeDepth (`ZoeDepthMultipleMetricDepthEstimationHeads`), Metric3D ConvNeXt.
- `1 / x` of a ReLU: Depth Pro in meters. `Exp`: Depth Anything 3 (`DPT`, activation "exp"), UniDepth.
- `a - ReLU(a - x)`: Metric3D ViT, which clamps its depth range (`RAFTDepthNormalDPT5.clamp`).
"""

from __future__ import annotations

import dataclasses

from .graph import Graph, Node

INVERSE, SIGMOID, BROKEN, BINS, RECIPROCAL, EXP, CLAMPED = (
    "inverse", "sigmoid", "broken", "bins", "reciprocal", "exp", "clamped",
)  # fmt: skip
DEPTH_ANYTHING_RANGES = (20.0, 80.0)  # [m] Depth Anything V2 metric: indoors (Hypersim), outdoors (Virtual KITTI)
MAX_STEPS = 1000  # about ten are usual; guards against recursive functions

# Pass-through operations that only change shape, size or type.
_PASSING = {
    "Identity", "Cast", "CastLike", "Reshape", "Squeeze", "Unsqueeze", "Flatten", "Transpose", "Resize", "Upsample",
    "Slice", "Gather", "Split", "Expand", "Dropout", "Pad", "QuantizeLinear", "DequantizeLinear", "Clip",
}  # fmt: skip


@dataclasses.dataclass(frozen=True)
class Head:
    """End of a network: `kind` (one of the above or None) and `factor`, the multiplier of its values."""

    kind: str | None = None
    factor: float = 1.0


UNKNOWN = Head()


@dataclasses.dataclass(frozen=True)
class _ValueRef:
    """A value, its graph, and the stack of function calls."""

    value: str
    graph: Graph
    calls: tuple[tuple[Graph, Node], ...] = ()

    def producer(self) -> tuple[Node | None, _ValueRef]:
        """The node that computes the value, across function boundaries. None for a model input."""
        here = self
        for _ in range(MAX_STEPS):
            node = here.graph.producers.get(here.value)
            if node is None:
                if not here.calls or here.value not in here.graph.inputs:
                    return None, here
                outer, call = here.calls[-1]
                position = here.graph.inputs.index(here.value)
                if position >= len(call.inputs):
                    return None, here
                here = _ValueRef(call.inputs[position], outer, here.calls[:-1])
                continue
            function = _functions(here).get((node.domain, node.operation))
            if function is None:
                return node, here
            position = node.outputs.index(here.value)
            if position >= len(function.outputs):
                return None, here
            here = _ValueRef(function.outputs[position], function, (*here.calls, (here.graph, node)))
        return None, here

    def input(self, node: Node, position: int = 0) -> _ValueRef:
        value = node.inputs[position] if position < len(node.inputs) else ""
        return dataclasses.replace(self, value=value)

    def constant(self) -> float | None:
        here = self
        for _ in range(MAX_STEPS):
            if here.value in here.graph.constants:
                return here.graph.constants[here.value]
            node, here = here.producer()
            if node is None or node.operation not in ("Cast", "CastLike", "Identity", "Unsqueeze", "Reshape"):
                return here.graph.constants.get(here.value)
            here = here.input(node)
        return None


def _functions(ref: _ValueRef) -> dict[tuple[str, str], Graph]:
    return (ref.calls[0][0] if ref.calls else ref.graph).functions


def find_head(graph: Graph, output: str) -> Head:
    ref, factor, is_inverted = _ValueRef(output, graph), 1.0, False
    for _ in range(MAX_STEPS):
        node, ref = ref.producer()
        if node is None:
            return UNKNOWN
        kind = _decides(node, ref)
        if kind is not None:
            return _head(kind, factor, is_inverted)
        if node.operation in _PASSING and not node.domain:
            ref = ref.input(node)
        elif node.operation == "Reciprocal":
            ref, factor, is_inverted = ref.input(node), 1.0, not is_inverted
        elif node.operation in ("Mul", "Div"):
            first, second = (ref.input(node, k).constant() for k in (0, 1))
            if second:
                factor = factor * second if node.operation == "Mul" else factor / second
                ref = ref.input(node)
            elif first and node.operation == "Mul":
                factor, ref = factor * first, ref.input(node, 1)
            elif first:
                ref, factor, is_inverted = ref.input(node, 1), 1.0, not is_inverted
            elif is_inverted and node.operation == "Mul":  # Depth Pro's focal length, from another output
                ref = ref.input(node, _map_of(node, ref))
            else:
                return UNKNOWN
        else:
            return UNKNOWN
    return UNKNOWN


def _head(kind: str, factor: float, is_inverted: bool) -> Head:
    if is_inverted:
        return Head(RECIPROCAL, factor) if kind == INVERSE else UNKNOWN
    if factor <= 0 or (kind == SIGMOID and factor <= 1):
        return UNKNOWN  # a plain sigmoid is ambiguous: disparity networks have one too
    if kind == INVERSE and factor in DEPTH_ANYTHING_RANGES:
        return Head(BROKEN, factor)
    return Head(kind, factor)


def _decides(node: Node, ref: _ValueRef) -> str | None:
    """The kind of map that a node produces, or None if it only passes values on."""
    if node.operation == "Relu" or node.attributes.get("activation") == "Relu":
        return INVERSE
    if node.operation == "Clip" and ref.input(node, 1).constant() == 0 and ref.input(node, 2).constant() is None:
        return INVERSE
    if node.operation == "Max" and len(node.inputs) == 2 and 0.0 in (ref.input(node, k).constant() for k in (0, 1)):
        return INVERSE
    if node.operation == "Sigmoid" or node.attributes.get("activation") == "Sigmoid":
        return SIGMOID
    if node.operation == "Exp":
        return EXP
    if node.operation == "ReduceSum" and _sums_bins(node, ref):
        return BINS
    if node.operation == "Sub" and _clamps(node, ref):
        return CLAMPED
    return None


def _through(ref: _ValueRef) -> tuple[Node | None, _ValueRef]:
    """The node that computes a value, skipping pass-through nodes."""
    for _ in range(MAX_STEPS):
        node, ref = ref.producer()
        if node is None or node.operation not in _PASSING or node.domain:
            return node, ref
        ref = ref.input(node)
    return None, ref


def _sums_bins(node: Node, ref: _ValueRef) -> bool:
    product, there = _through(ref.input(node))
    if product is None or product.operation != "Mul":
        return False
    factors = (_through(there.input(product, k))[0] for k in (0, 1))
    return any(each is not None and each.operation == "Softmax" for each in factors)


def _clamps(node: Node, ref: _ValueRef) -> bool:
    """True for a - ReLU(a - x)."""
    limit = ref.input(node).constant()
    inner, there = _through(ref.input(node, 1))
    if limit is None or inner is None or inner.operation != "Relu":
        return False
    last, there = _through(there.input(inner))
    return last is not None and last.operation == "Sub" and there.input(last).constant() == limit


def _map_of(node: Node, ref: _ValueRef) -> int:
    """Which factor of a product comes from a ReLU: the map, not a scalar."""
    second, _ = _through(ref.input(node, 1))
    return 1 if second is not None and second.operation == "Relu" else 0
