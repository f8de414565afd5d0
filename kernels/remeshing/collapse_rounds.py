"""The rounds in which edges collapse, until enough triangles are gone: on CUDA one graph, whose end the device decides.

A round: edges get the prices that they lack, those up to a limit are looked at, some are picked that are not next to
each other, the cheapest of them collapse, and what that changed is found anew. Some 70 launches, most of them over what
is left and little more.
"""

from collections.abc import Sequence

from ..array_types import Indices
from ..arrays.loop_scan import LoopList
from ..lang import DeviceLoop, array, float64, int32, kernel, launch, tid, uint8
from ..memory import empty, full, host_view
from .collapse_mesh import (
    BENDING,
    BIN,
    CHOSEN,
    EDGES,
    EVERY,
    PICKED,
    SEAMS,
    SLOTS,
    SQUEEZE,
    TRIANGLES,
    VERTICES,
    CollapseMesh,
)
from .edge_bins import EdgeBins
from .edge_choice import EdgeChoice
from .edge_collapse import EdgeCollapse
from .edge_prices import mark_cheap_edges_kernel, price_edges_kernel
from .squeezed_mesh import Squeezing, left_vertices

TURNS = 3  # of choosing a round
LEFT, PARTS = 3, 4  # where fewer of the triangles are left, what is gone is squeezed out


@kernel
def take_rows_kernel(
    values: array(dtype=int32),
    rows: array(dtype=int32),
    counts: array(dtype=int32),
    place: int,
    out: array(dtype=int32),
):
    """The values at the first rows."""
    i = tid()
    if i < counts[place]:
        out[i] = values[rows[i]]


@kernel
def judge_round_kernel(mesh: CollapseMesh, ends_there: int, numbers: array(dtype=int32), running: array(dtype=int32)):
    """What the round has led to: what is let go where no edge may collapse any more, and whether to squeeze."""
    i = tid()
    left = mesh.starts[numbers[VERTICES]] // 3
    numbers[TRIANGLES] = left
    numbers[EVERY] = i
    running[0] = 1
    if numbers[BIN] < 0:
        if numbers[BENDING] == 1 or ends_there == 1:
            running[0] = 0
        else:
            has_seams = numbers[SEAMS] * max(mesh.has_uvs, mesh.has_materials)
            numbers[BENDING] = 1 - has_seams
            numbers[SEAMS] = numbers[SEAMS] * (1 - has_seams)
            numbers[EVERY] = 1
    elif numbers[CHOSEN] > 0:
        numbers[BENDING] = 0
    numbers[SQUEEZE] = 1 if PARTS * left < LEFT * numbers[SLOTS] else 0


@kernel
def end_round_kernel(
    mesh: CollapseMesh, ranks: array(dtype=int32), target: int, numbers: array(dtype=int32), running: array(dtype=int32)
):
    """The sizes after a squeeze, and whether there is another round."""
    i = tid()
    count = left_vertices(mesh, ranks)
    if count >= 0:
        numbers[VERTICES] = count
        numbers[SLOTS] = numbers[TRIANGLES]
    numbers[SQUEEZE] = i
    numbers[EVERY] = i
    if numbers[TRIANGLES] <= target:
        running[0] = 0


@kernel
def ask_squeeze_kernel(numbers: array(dtype=int32)):
    """What is gone is to be squeezed out."""
    i = tid()
    numbers[SQUEEZE] = i + 1


class CollapseRounds:
    """All rounds of a mesh, with the arrays that they share.

    Args:
        mesh: CollapseMesh with features and quadrics, and more triangles than the target.
        unit: For each of its rows whether they have unit length.
        target: Triangles to be left.
        most: The error up to which edges collapse.
    """

    def __init__(self, mesh: CollapseMesh, unit: Sequence[bool], target: int, most: float) -> None:
        device, halves = mesh.numbers.device, mesh.keys.size
        self.mesh, self.twin, self.target, self.most = mesh, mesh.twin(), target, float64(most)
        self.ends_there = int(most < float("inf"))
        self.bins, self.choice, self.squeezing = EdgeBins(target, mesh.numbers), EdgeChoice(mesh), Squeezing(mesh)
        self.cheap = empty(halves, uint8, device)
        self.looked_at, self.picked_places = LoopList(halves, device), LoopList(halves, device)
        apart = max(1, min(mesh.triangles.size, mesh.positions.size // 2))  # edges with a triangle and no common end
        self.picked: Indices = empty(apart, int32, device)
        self.taken, self.taken_places = empty(apart, uint8, device), LoopList(apart, device)
        self.chosen: Indices = empty(apart, int32, device)
        self.collapse = EdgeCollapse(mesh, apart, unit)
        self.running = full(1, int(mesh.triangles.size > target), int32, device)

    def run(self) -> None:
        """Collapse edges to the target, or as far as that goes; then squeeze out what is gone."""
        if self.running.device.is_cuda:
            DeviceLoop(self.running, self.run_round).run()
        else:
            running = host_view(self.running)
            while running[0]:
                self.run_round()
        launch(ask_squeeze_kernel, 1, [self.mesh.numbers])
        self.squeeze()

    def price_edges(self) -> None:
        """Give edges the prices that they lack, and find the limit of those to be looked at."""
        mesh = self.mesh
        count = 3 * mesh.live(SLOTS, mesh.triangles.size)
        launch(price_edges_kernel, count, [mesh, self.most, mesh.keys, self.bins.bins])
        self.bins.limit_prices()

    def choose(self) -> None:
        """Choose edges of which none is next to another, cheap ones, no more than are to go."""
        mesh, numbers = self.mesh, self.mesh.numbers
        count = 3 * mesh.live(SLOTS, mesh.triangles.size)
        launch(mark_cheap_edges_kernel, count, [mesh.keys, numbers, self.cheap])
        self.looked_at.find(self.cheap, count, numbers, EDGES)
        self.choice.run(mesh, self.looked_at.rows, TURNS)
        looked_at = mesh.live(EDGES, self.looked_at.rows.size)
        self.picked_places.find(self.choice.chosen, looked_at, numbers, PICKED)
        picked = mesh.live(PICKED, self.picked.size)
        rows = [self.looked_at.rows, self.picked_places.rows, numbers, PICKED, self.picked]
        launch(take_rows_kernel, picked, rows)
        self.bins.mark_cheapest(mesh, self.picked, picked, self.taken)
        self.taken_places.find(self.taken, picked, numbers, CHOSEN)
        rows = [self.picked, self.taken_places.rows, numbers, CHOSEN, self.chosen]
        launch(take_rows_kernel, mesh.live(CHOSEN, self.chosen.size), rows)

    def run_round(self) -> None:
        """Collapse some edges."""
        mesh = self.mesh
        self.price_edges()
        self.choose()
        self.collapse.run(mesh, self.twin, self.chosen)
        mesh.find_features(self.collapse.moved, self.collapse.most)
        launch(judge_round_kernel, 1, [mesh, self.ends_there, mesh.numbers, self.running])
        if self.running.device.is_cuda or host_view(mesh.numbers)[EVERY]:
            mesh.find_all_features()
        self.squeeze()

    def squeeze(self) -> None:
        """Renumber what is left where the record says so."""
        mesh, on_cuda = self.mesh, self.running.device.is_cuda
        if on_cuda or host_view(mesh.numbers)[SQUEEZE]:
            self.squeezing.run(mesh, self.twin)
        launch(end_round_kernel, 1, [mesh, self.squeezing.ranks, self.target, mesh.numbers, self.running])
