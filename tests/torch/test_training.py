"""An autoencoder of point clouds is trained with the Chamfer distance."""

import math

import torch

import pointloom as loom

STEPS, SHAPES, POINTS = 50, 24, 128
# Losses end at 0.061 to 0.069 with seeds 0 to 2. One shape in place of all has 0.116 at best (29 November 2026).
FINAL_LOSS = 0.08


def shapes(seed):
    """Boxes, ellipsoids and tubes of random sizes: (SHAPES, POINTS, 3)."""
    generator = torch.Generator().manual_seed(seed)
    directions = torch.randn(SHAPES, POINTS, 3, generator=generator)
    spheres = directions / directions.norm(dim=-1, keepdim=True)
    boxes = directions / directions.abs().amax(-1, keepdim=True)
    tubes = torch.cat([spheres[..., :2] / spheres[..., :2].norm(dim=-1, keepdim=True), boxes[..., 2:]], -1)
    kinds = torch.arange(SHAPES)[:, None, None] % 3
    sizes = 0.4 + 0.6 * torch.rand(SHAPES, 1, 3, generator=generator)
    return torch.where(kinds == 0, spheres, torch.where(kinds == 1, boxes, tubes)) * sizes


class Autoencoder(torch.nn.Module):
    """Edges to neighbors, a maximum over the points, and a decoder of moved points."""

    def __init__(self):
        super().__init__()
        self.edges = torch.nn.Sequential(torch.nn.Linear(6, 32), torch.nn.ReLU(), torch.nn.Linear(32, 64))
        self.decoder = torch.nn.Sequential(torch.nn.Linear(64, 128), torch.nn.ReLU(), torch.nn.Linear(128, 3 * POINTS))

    def forward(self, points):
        indices = loom.torch.knn(points, points, 6).indices
        near = points[torch.arange(len(points))[:, None, None], indices]
        own = points[:, :, None].expand_as(near)
        codes = self.edges(torch.cat([own, near - own], -1)).amax((1, 2))
        return self.decoder(codes).reshape(-1, POINTS, 3)


def losses_of_training(seed=0):
    torch.manual_seed(seed)
    network, data = Autoencoder(), shapes(seed)
    optimizer, losses = torch.optim.Adam(network.parameters(), lr=2e-3), []
    for _ in range(STEPS):
        loss = loom.torch.chamfer_distance(network(data), data).mean()
        optimizer.zero_grad()
        loss.backward()
        optimizer.step()
        losses.append(loss.item())
    return losses


def test_training_reaches_the_same_low_loss_bit_for_bit():
    losses = losses_of_training()
    assert losses_of_training() == losses
    assert losses[-1] < FINAL_LOSS < losses[0] and not any(map(math.isnan, losses))
