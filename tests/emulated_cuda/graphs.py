"""Captures and graphs: conditional nodes, loops and child graphs included."""

import ctypes
from typing import Any

from .findings import Findings
from .memory import Memory
from .streams import Graph, Streams, address_of

ENDLESS = 10**6  # iterations of a captured loop
ALLOWED_IN_BODY = {"memcpy", "memset", "kernel launch", "graph launch", "conditional node"}


class Graphs:
    def __init__(self, streams: Streams, memory: Memory, findings: Findings):
        self.streams, self.memory, self.findings = streams, memory, findings
        self.begun: set[int] = set()  # graphs that a capture began with, not bodies of nodes
        self.put_off: list[Any] = []  # what waits for the end of the last capture

    def _graph(self) -> tuple[Graph, int]:
        graph = Graph(0)
        graph.identity = self.streams.handle(graph)
        return graph, graph.identity

    def _flag(self, pointer: int) -> int:
        return ctypes.c_int32.from_address(self.memory.real(pointer, 4, "condition")).value

    def wp_cuda_graph_begin_capture(self, _, stream, external, mode):
        stream_object = self.streams.stream(stream)
        if stream_object.capture is not None:
            return self.findings.refuse("stream is capturing already")
        if stream_object is self.streams.legacy:
            return self.findings.refuse("operation not permitted on the legacy stream: capture")
        stream_object.capture, identity = self._graph()
        self.begun.add(identity)
        self.streams.captures += 1
        self.streams.blocking_captures += stream_object.blocks
        return True

    def wp_cuda_graph_end_capture(self, _, stream, out):
        stream_object = self.streams.stream(stream)
        graph = stream_object.capture
        if graph is None:
            return self.findings.refuse("stream has no capture started")
        if graph.identity not in self.begun:  # the body would be destroyed twice, and the graph around it never
            self.findings.faults.append("a capture is ended in the body of a conditional node")
        for other in self.streams.streams.values():
            if other.capture is graph:
                other.capture = None
        self.streams.captures -= 1
        self.streams.blocking_captures -= stream_object.blocks
        if not self.streams.captures:
            waiting, self.put_off = self.put_off, []
            for release in waiting:
                self.streams.on_legacy(release)
        out._obj.value = graph.identity
        return True

    def wp_cuda_graph_pause_capture(self, _, stream, out):
        stream_object = self.streams.stream(stream)
        out._obj.value = stream_object.capture.identity if stream_object.capture else 0
        stream_object.capture = None
        return True

    def wp_cuda_graph_resume_capture(self, _, stream, graph):
        self.streams.stream(stream).capture = self.streams.named(graph)
        return True

    def wp_cuda_graph_create_exec(self, _, stream, graph, out):
        self.findings.counts["graphs made"] += 1
        out._obj.value = self.streams.handle(self.streams.named(graph))
        return True

    def wp_cuda_graph_launch(self, graph, stream):
        self.findings.counts["graphs"] += 1
        self.streams.enqueue(self.streams.stream(stream), self.streams.named(graph).play, "graph launch")
        return True

    def wp_cuda_graph_destroy(self, _, graph):
        return self.streams.handles.pop(address_of(graph), None) is not None

    wp_cuda_graph_exec_destroy = wp_cuda_graph_destroy

    def wp_cuda_graph_check_conditional_body(self, graph):
        for _, kind in self.streams.named(graph).nodes:
            if kind not in ALLOWED_IN_BODY:
                return self.findings.refuse(f"Conditional body graph contains an unsupported operation ({kind})")
        return True

    def _add(self, stream: Any, operation: Any, kind: str) -> bool:
        """Record a node in the capture of a stream."""
        capture = self.streams.stream(stream).capture
        if capture is None:
            return self.findings.refuse("Stream is not capturing")
        capture.nodes.append((operation, kind))
        return True

    def wp_cuda_graph_insert_child_graph(self, _, stream, graph):
        return self._add(stream, self.streams.named(graph).play, "graph launch")

    def wp_cuda_graph_insert_while(self, _, stream, arch, use_ptx, condition, body, handle):
        pointer = address_of(condition)
        graph, body._obj.value = self._graph()
        value = [0]  # the device's own copy of the condition: set at the start, then by the body
        handle._obj.value = self.streams.handle(value)

        def loop() -> None:
            value[0] = self._flag(pointer)
            for _ in range(ENDLESS):
                if not value[0]:
                    return
                graph.play()
            self.findings.fault(f"a captured loop of more than {ENDLESS:,} turns")

        return self._add(stream, loop, "conditional node")

    def wp_cuda_graph_set_condition(self, _, stream, arch, use_ptx, condition, handle):
        pointer, value = address_of(condition), self.streams.named(handle)
        return self._add(stream, lambda: value.__setitem__(0, self._flag(pointer)), "kernel launch")

    def wp_cuda_graph_insert_if_else(self, _, stream, arch, use_ptx, condition, on_true, on_false):
        pointer, branches = address_of(condition), []
        for out in (on_true, on_false):
            graph, identity = self._graph()
            branches.append(graph)
            if out is not None:
                out._obj.value = identity
        return self._add(stream, lambda: branches[0 if self._flag(pointer) else 1].play(), "conditional node")
