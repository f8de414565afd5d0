"""A fork of a process that uses CUDA: the child raises an error, keeps the parent's memory intact, and uses the CPU."""

from .processes import START, run

PROGRAM = """
points = np.random.default_rng(0).random((100, 3)).astype(np.float32)
cloud = loom.PointCloud(points, device="cuda:0")
before = cloud.voxel_down_sample(0.2).points

reading, writing = os.pipe()
child = os.fork()
if child == 0:
    found = {
        "new": attempt(lambda: loom.PointCloud(points, device="cuda:0")),
        "auto": attempt(lambda: loom.PointCloud(points, device="auto")),
        "old": attempt(lambda: cloud.voxel_down_sample(0.2)),
        "read": attempt(lambda: cloud.select_by_index([0]).points),
        "cpu": attempt(lambda: loom.PointCloud(points).voxel_down_sample(0.2)),
    }
    live = len(installed().memory.live)
    del cloud
    found["released"] = live - len(installed().memory.live)
    os.write(writing, json.dumps(found).encode())
    sys.exit(0)
_, status = os.waitpid(child, 0)
found = json.loads(os.read(reading, 1 << 16))
found["status"] = status
found["same"] = bool((cloud.voxel_down_sample(0.2).points == before).all())
print(json.dumps(found))
"""


def test_a_child_reports_the_reason_and_the_parent_continues(emulated):
    report = run("-c", START + PROGRAM, POINTLOOM_CPU="warp")
    for name in ("new", "auto", "old", "read"):
        kind, message = report[name]
        assert kind in ("DeviceError", "RuntimeError"), report[name]
        assert message.startswith("cuda:0: this process was forked") and "get_context('spawn')" in message
    assert report["new"][0] == "DeviceError"
    assert report["cpu"] == ["none", ""]
    assert (report["released"], report["status"], report["same"]) == (0, 0, True)
