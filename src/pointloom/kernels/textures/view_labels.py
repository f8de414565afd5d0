"""Image selection per triangle: Potts model with data costs and a price per edge between different images.

Integer energy, bitwise reproducible. Damped parallel min-sum belief propagation (odd iterations round up, even ones
down), then parallel greedy moves in which no neighbors change together. Waechter, Moehrle and Goesele 2014, section
3.2. Felzenszwalb and Huttenlocher, "Efficient Belief Propagation for Early Vision", IJCV 2006.
"""

from ..array_types import Indices, Integers
from ..arrays.prefix_sum import sum_counts
from ..arrays.quantiles import quantiles_of
from ..lang import array, atomic_add, compute, float64, floor, func, int32, kernel, launch, loop_while, struct, tid
from ..memory import empty, full, zeros
from .face_views import FaceViews

MAX_IMAGE_COST = 1 << 16  # cost of an invisible triangle
BEST_QUALITY_QUANTILE = 0.995  # quality quantile from which on the cost is zero
MAX_BELIEF = 1 << 30
MESSAGE_ITERATIONS = 120  # message iterations: the range of a message in triangles
MAX_CHANGES = 4096


@struct
class LabelGraph:
    """Ascending candidate `views` per triangle with `costs` (0 to MAX_IMAGE_COST); `twins` or -1; edge `price`."""

    starts: array(dtype=int32)
    views: array(dtype=int32)
    costs: array(dtype=int32)
    twins: array(dtype=int32)
    price: int

    def __init__(self, starts: Integers, views: Indices, costs: Integers, twins: Indices, price: int) -> None:
        self.starts, self.views, self.costs, self.twins, self.price = starts, views, costs, twins, int(price)
        self.count, self.device = starts.size - 1, starts.device


@kernel
def cost_views_kernel(qualities: array(dtype=float64), best: float64, costs: array(dtype=int32)):
    """Cost of an image: 0 at the best quality, MAX_IMAGE_COST at zero."""
    i = tid()
    fraction = float64(1.0)
    if best > 0.0:
        fraction = min(qualities[i] / best, 1.0)
    costs[i] = int(floor((1.0 - fraction) * float64(MAX_IMAGE_COST) + 0.5))


@kernel
def sum_beliefs_kernel(graph: LabelGraph, messages: array(dtype=int32), beliefs: array(dtype=int32)):
    """Belief of each candidate: cost plus messages."""
    i = tid()
    beliefs[i] = graph.costs[i] + messages[3 * i] + messages[3 * i + 1] + messages[3 * i + 2]


@kernel
def pass_messages_kernel(
    graph: LabelGraph,
    beliefs: array(dtype=int32),
    messages: array(dtype=int32),
    parity: int,
    new_messages: array(dtype=int32),
):
    """Messages to a triangle through one of its edges."""
    i = tid()
    first = graph.starts[i // 3]
    last = graph.starts[i // 3 + 1]
    side = i % 3
    twin = graph.twins[i]
    begin = 0
    end = 0
    if twin >= 0:
        begin = graph.starts[twin // 3]
        end = graph.starts[twin // 3 + 1]
    other = twin % 3
    min_belief = int(MAX_BELIEF)
    for j in range(begin, end):
        min_belief = min(min_belief, beliefs[j] - messages[3 * j + other])
    j = begin
    for k in range(first, last):
        message = 0
        if end > begin:
            while j < end and graph.views[j] < graph.views[k]:
                j += 1
            message = graph.price
            if j < end and graph.views[j] == graph.views[k]:
                message = min(message, beliefs[j] - messages[3 * j + other] - min_belief)
        new_messages[3 * k + side] = (messages[3 * k + side] + message + parity) // 2


@kernel
def take_best_kernel(graph: LabelGraph, beliefs: array(dtype=int32), labels: array(dtype=int32)):
    """Candidate with the least belief, the first of equals, or -1 if there is none."""
    i = tid()
    label = -1
    min_belief = int(MAX_BELIEF)
    for k in range(graph.starts[i], graph.starts[i + 1]):
        if beliefs[k] < min_belief:
            min_belief = beliefs[k]
            label = k
    labels[i] = label


@func
def view_beyond(graph: LabelGraph, labels: array(dtype=int32), h: int) -> int:
    view = -1
    if graph.twins[h] >= 0:
        label = labels[graph.twins[h] // 3]
        if label >= 0:
            view = graph.views[label]
    return view


@func
def price_at(graph: LabelGraph, view: int, a: int, b: int, c: int) -> int:
    count = 0
    if a >= 0 and a != view:
        count += 1
    if b >= 0 and b != view:
        count += 1
    if c >= 0 and c != view:
        count += 1
    return count * graph.price


@kernel
def weigh_changes_kernel(
    graph: LabelGraph, labels: array(dtype=int32), gains: array(dtype=int32), better: array(dtype=int32)
):
    """Gain of a triangle's cheapest image, with fixed neighbors."""
    i = tid()
    gains[i] = 0
    better[i] = labels[i]
    if labels[i] >= 0:
        a = view_beyond(graph, labels, 3 * i)
        b = view_beyond(graph, labels, 3 * i + 1)
        c = view_beyond(graph, labels, 3 * i + 2)
        now = graph.costs[labels[i]] + price_at(graph, graph.views[labels[i]], a, b, c)
        for k in range(graph.starts[i], graph.starts[i + 1]):
            gain = now - graph.costs[k] - price_at(graph, graph.views[k], a, b, c)
            if gain > gains[i]:
                gains[i] = gain
                better[i] = k


@kernel
def change_kernel(
    graph: LabelGraph,
    gains: array(dtype=int32),
    better: array(dtype=int32),
    labels: array(dtype=int32),
    changes: array(dtype=int32),
):
    """Change triangles that gain more than all neighbors (ties: the lower)."""
    i = tid()
    if gains[i] > 0:
        is_best = 1
        for side in range(3):
            twin = graph.twins[3 * i + side]
            if twin >= 0:
                j = twin // 3
                if gains[j] > gains[i] or (gains[j] == gains[i] and j < i):
                    is_best = 0
        if is_best == 1:
            labels[i] = better[i]
            atomic_add(changes, 0, 1)  # integer sum: order-independent


@kernel
def end_changes_kernel(changes: array(dtype=int32), running: array(dtype=int32)):
    i = tid()
    changes[1] = changes[1] + 1
    running[i] = 0
    if changes[0] > 0 and changes[1] < MAX_CHANGES:
        running[i] = 1
    changes[0] = 0


@kernel
def count_energy_kernel(graph: LabelGraph, labels: array(dtype=int32), energies: array(dtype=int32)):
    """Cost of a triangle and price of its edges to higher triangles."""
    i = tid()
    energy = 0
    if labels[i] >= 0:
        energy = graph.costs[labels[i]]
        for side in range(3):
            view = view_beyond(graph, labels, 3 * i + side)
            if graph.twins[3 * i + side] // 3 > i and view >= 0 and view != graph.views[labels[i]]:
                energy += graph.price
    energies[i] = energy


@kernel
def name_views_kernel(views: array(dtype=int32), labels: array(dtype=int32), named: array(dtype=int32)):
    i = tid()
    view = -1
    if labels[i] >= 0:
        view = views[labels[i]]
    named[i] = view


def cost_views(views: FaceViews) -> Integers:
    """Costs of all pairs, int32 (k). One sync."""
    costs = empty(views.count, int32, views.device)
    best = quantiles_of(views.qualities, [BEST_QUALITY_QUANTILE])[0] if views.count else 0.0  # sync
    launch(cost_views_kernel, views.count, [views.qualities, best, costs])
    return costs


def energy_of(graph: LabelGraph, labels: Indices) -> int:
    """Energy of a labeling. One sync."""
    energies = compute(count_energy_kernel, graph.count, [graph, labels], int32, graph.device)
    return int(sum_counts(energies))  # sync


def improve(graph: LabelGraph, labels: Indices) -> None:
    count, device = graph.count, graph.device
    gains, better = empty(count, int32, device), empty(count, int32, device)
    changes, running = zeros(2, int32, device), full(1, 1, int32, device)

    def run_round() -> None:
        launch(weigh_changes_kernel, count, [graph, labels, gains, better])
        launch(change_kernel, count, [graph, gains, better, labels, changes])
        launch(end_changes_kernel, 1, [changes, running])

    loop_while(running, run_round)


def choose_labels(graph: LabelGraph, iterations: int = MESSAGE_ITERATIONS) -> Indices:
    """Low-energy candidate per triangle, int32 (t), -1 if it has none. No single change improves it."""
    pairs, device = graph.views.size, graph.device
    messages, new_messages, beliefs = (
        zeros(3 * pairs, int32, device),
        empty(3 * pairs, int32, device),
        empty(pairs, int32, device),
    )
    for iteration in range(iterations):
        launch(sum_beliefs_kernel, pairs, [graph, messages, beliefs])
        launch(pass_messages_kernel, 3 * graph.count, [graph, beliefs, messages, iteration % 2, new_messages])
        messages, new_messages = new_messages, messages
    launch(sum_beliefs_kernel, pairs, [graph, messages, beliefs])
    labels = compute(take_best_kernel, graph.count, [graph, beliefs], int32, device)
    improve(graph, labels)
    return labels


def name_views(graph: LabelGraph, labels: Indices) -> Indices:
    return compute(name_views_kernel, graph.count, [graph.views, labels], int32, graph.device)
