"""Fragments of frames: consecutive frames that align, and new fragments at gaps."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.rgbd.reconstruction.fragments import Keyframe, fragments_in
from pointloom.rgbd.reconstruction.job_files import JobFiles

from .walks import ShortSequence, blank, config, drift_of, frame_at

make_fragments = loom.reconstruction.make_fragments


def frames_of(result):
    return [fragment.indices.tolist() for fragment in result.fragments]


def test_frames_that_follow_each_other_become_fragments(tmp_path, device):
    sequence = ShortSequence(range(8))
    result = make_fragments(sequence, config(n_frames_per_fragment=5), tmp_path, device=device)
    assert (frames_of(result), result.lost) == ([[0, 1, 2, 3, 4], [5, 6, 7]], [])
    assert max(drift_of(fragment, sequence) for fragment in result.fragments) < 0.015
    first, second = result.fragments
    assert first.joint is None
    assert second.joint.fragment == 0
    truth = np.linalg.inv(frame_at(0).T_world_camera) @ frame_at(5).T_world_camera
    assert np.abs(second.T_earlier(first) - truth).max() < 0.02
    cloud = first.read_cloud(device)
    assert cloud.has_normals
    assert cloud.has_colors


def test_loops_are_detected_where_keyframes_overlap(tmp_path):
    there_and_back = ShortSequence([0, 1, 2, 3, 4, 3, 2, 1, 0])
    result = make_fragments(there_and_back, config(n_keyframes_per_n_frame=2), tmp_path)
    (fragment,) = result.fragments
    tried, aligned, accepted = fragment.loops
    assert tried >= aligned >= accepted >= 4
    graph = loom.registration.read_pose_graph(tmp_path / "fragments" / "fragment_000.json")
    before, after = (np.linalg.norm(pose[:3, 3]) for pose in (graph.nodes[-1].pose, fragment.poses[-1]))
    assert after < 0.75 * before
    ends = [(edge.source_node_id, edge.target_node_id) for edge in graph.edges if edge.uncertain]
    assert len(ends) == aligned
    assert (8, 0) in ends


def test_a_covered_lens_breaks_the_fragment_and_odometry_bridges_it(tmp_path):
    sequence = ShortSequence(range(7), changed={3: blank(frame_at(3))})
    result = make_fragments(sequence, config(), tmp_path)
    assert frames_of(result) == [[0, 1, 2], [4, 5, 6]]
    assert [(frame.index, frame.name) for frame in result.lost] == [(3, "frame-3")]
    assert "0.0% of its pixels have a depth" in result.lost[0].reason
    joint = result.fragments[1].joint
    assert (joint.fragment, joint.skipped) == (0, 1)


def test_a_pair_that_does_not_align_breaks_the_fragment(tmp_path):
    sequence = ShortSequence([0, 1, 2, 40, 41, 42])
    result = make_fragments(sequence, config(), tmp_path)
    assert frames_of(result) == [[0, 1, 2], [3, 4, 5]]
    assert result.fragments[1].joint is None
    assert result.fragments[1].broke
    for number, fragment in enumerate(result.fragments):
        graph = loom.registration.read_pose_graph(tmp_path / "fragments" / f"fragment_{number:03d}.json")
        assert len(graph.edges) == len(fragment) - 1
        assert not any(np.array_equal(edge.transformation, np.eye(4)) for edge in graph.edges)


def test_isolated_frames_are_excluded_and_reported(tmp_path):
    result = make_fragments(ShortSequence([0, 1, 2, 40, 80, 81]), config(), tmp_path)
    assert frames_of(result) == [[0, 1, 2], [4, 5]]
    (lost,) = result.lost
    assert lost.index == 3
    assert "1 frame unconnected, 2 needed" in lost.reason


def test_one_frame_remains_where_no_two_frames_overlap(tmp_path):
    result = make_fragments(ShortSequence([0, 40, 80]), config(), tmp_path)
    assert frames_of(result) == [[0]]
    assert [frame.index for frame in result.lost] == [1, 2]


def test_a_missing_frame_breaks_the_fragment(tmp_path):
    result = make_fragments(ShortSequence(range(5), missing=(2,)), config(), tmp_path)
    assert frames_of(result) == [[0, 1], [3, 4]]
    assert "does not exist" in result.lost[0].reason


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda frame: {"depth": (frame.depth // 256).astype(np.uint8)}, "its depth is uint8"),
        (lambda frame: {"depth": frame.depth[::2, ::2]}, "its depth has shape"),
        (lambda frame: {"color": frame.color[::2, ::2]}, "its color is"),
        (lambda frame: {"color": frame.color.astype(np.float32)}, "its color is float32"),
    ],
    ids=["depth of 8 bits", "depth of another size", "color of another size", "color in floats"],
)
def test_an_unsuitable_frame_is_excluded_with_a_reason(tmp_path, change, message):
    result = make_fragments(ShortSequence(range(3), changed={2: change(frame_at(2))}), config(), tmp_path)
    assert frames_of(result) == [[0, 1]]
    assert message in result.lost[0].reason


def test_depth_alone_is_enough(tmp_path):
    sequence = ShortSequence(range(4), changed={i: {"color": None} for i in range(4)})
    (fragment,) = make_fragments(sequence, config(), tmp_path).fragments
    assert drift_of(fragment, sequence) < 0.015
    assert not fragment.colored
    assert not fragment.read_cloud().has_colors


@pytest.mark.parametrize("shade", [128, None], ids=["one shade of gray", "no color"])
def test_a_room_without_texture_is_tracked_where_its_shape_constrains_the_pose(tmp_path, shade):
    """Frames of corners and furniture, whose least certain motion costs two to four times the limit."""
    steps = range(92, 98)
    color = None if shade is None else np.full_like(frame_at(92, 160).color, shade)
    sequence = ShortSequence(steps, changed={i: {"color": color} for i in range(len(steps))}, width=160)
    result = make_fragments(sequence, config(), tmp_path)
    assert (frames_of(result), result.lost) == ([[0, 1, 2, 3, 4, 5]], [])
    assert drift_of(result.fragments[0], sequence) < 0.005


def test_a_frame_without_color_gives_a_cloud_without_colors(tmp_path):
    sequence = ShortSequence(range(4), changed={2: {"color": None}})
    (fragment,) = make_fragments(sequence, config(), tmp_path).fragments
    assert len(fragment) == 4
    assert not fragment.read_cloud().has_colors


def test_depth_in_meters_is_supported(tmp_path):
    meters = {i: {"depth": frame_at(i).depth.astype(np.float32) / 1000} for i in range(3)}
    first = make_fragments(ShortSequence(range(3)), config(), tmp_path / "a").fragments[0]
    second = make_fragments(ShortSequence(range(3), changed=meters), config(), tmp_path / "b").fragments[0]
    assert np.array_equal(first.poses, second.poses)


def test_depth_out_of_range_is_not_used(tmp_path):
    near = make_fragments(ShortSequence([0, 1]), config(depth_min=0.1, depth_max=0.2), tmp_path)
    assert [frame.index for frame in near.lost] == [0, 1]
    assert "from 0.1 to 0.2 m" in near.lost[0].reason


def test_written_fragments_match_the_returned_ones(tmp_path):
    settings = config(n_frames_per_fragment=3)
    result = make_fragments(ShortSequence(range(5)), settings, tmp_path)
    again = fragments_in(JobFiles.make(tmp_path, settings))
    for one, other in zip(result.fragments, again, strict=True):
        assert np.array_equal(one.poses, other.poses)
        for name in ("names", "broke", "loops", "made_from"):
            assert getattr(one, name) == getattr(other, name)


@pytest.mark.parametrize("source", [[], iter(()), None, object()], ids=["a list", "a stream", "None", "an object"])
def test_a_source_must_be_readable_by_index(tmp_path, source):
    with pytest.raises(TypeError, match="source:"):
        make_fragments(source, config(), tmp_path)


def test_no_frame_is_an_error(tmp_path):
    with pytest.raises(ValueError, match="source:"):
        make_fragments(ShortSequence([]), config(), tmp_path)


def test_a_keyframe_overlaps_itself_completely_and_nothing_behind_it():
    frame = frame_at(0)
    depth = frame.depth.astype(np.float32) / 1000
    key = Keyframe.make(0, None, depth, frame.intrinsic)
    backwards = np.diag([-1.0, 1.0, -1.0, 1.0])
    assert key.share_seen_by(key, np.eye(4), frame.intrinsic) == 1.0
    assert key.share_seen_by(key, backwards, frame.intrinsic) == 0.0
