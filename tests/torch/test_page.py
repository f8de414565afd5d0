"""The examples of docs/torch.md."""

import torch

from ..page_blocks import blocks_of


def test_the_examples_of_the_page_run(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    torch.manual_seed(0)
    names = {"__name__": "page"}
    blocks = [block for block in blocks_of("docs/torch.md") if block.language == "python"]
    assert len(blocks) == 11
    for block in blocks:
        exec(compile(block.source(), block.page, "exec"), names)
    assert names["loss"] > 0 and names["edge_loss"] > 0 and names["made"].grad.abs().sum() > 0
    assert names["vertices"].grad.abs().sum() > 0 and names["source"].grad.abs().sum() > 0
    assert names["indices"].shape == (8 * 1024, 7) and names["edges"].shape == (2, 8 * 1024 * 6)
    assert names["upsampled"].shape == (8, 256, 32) and names["chosen"].shape == (8, 128)
    assert (names["signed"] < 0).any() and names["fscore"].shape == names["largest"].shape == (8,)
