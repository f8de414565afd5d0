"""Kernels written in PTX, for what Warp would not write."""

import ctypes
from pathlib import Path

import numpy as np
import warp as wp

from .install import Device

HEAD = ".version 8.4\n.target sm_90\n.address_size 64\n"
# Thread i takes row i of three columns of 64 bits, in registers of all kinds; register 0 of one kind is the result.
ROW = """
.visible .entry {name}(.param .u64 a, .param .u64 b, .param .u64 c, .param .u64 out)
{{
    .reg .pred %p<4>; .reg .b16 %rs<4>; .reg .b32 %r<4>; .reg .b64 %rd<4>; .reg .f32 %f<4>; .reg .f64 %fd<4>;
    .reg .b32 %row; .reg .b64 %at; .reg .b64 %offset; .reg .b64 %result;
    mov.u32 %row, %tid.x;
    mul.wide.u32 %offset, %row, 8;
{loads}
    {instruction}
{store}
    ld.param.u64 %at, [out];
    add.s64 %at, %at, %offset;
    st.global.u64 [%at], %result;
    ret;
}}
"""
LOAD = """
    ld.param.u64 %at, [{column}];
    add.s64 %at, %at, %offset;
    ld.global.u64 %rd{k}, [%at];
    cvt.u32.u64 %r{k}, %rd{k};
    cvt.u16.u64 %rs{k}, %rd{k};
    mov.b32 %f{k}, %r{k};
    mov.b64 %fd{k}, %rd{k};
    setp.ne.s64 %p{k}, %rd{k}, 0;
"""
STORES = {
    "%rd0": "mov.b64 %result, %rd0;",
    "%rs0": "cvt.u64.u16 %result, %rs0;",
    "%r0": "cvt.u64.u32 %result, %r0;",
    "%fd0": "mov.b64 %result, %fd0;",
    "%f0": "mov.b32 %r0, %f0; cvt.u64.u32 %result, %r0;",
    "%p0": "selp.b64 %result, 1, 0, %p0;",
}


class Programs:
    def __init__(self, device: Device, folder: Path):
        self.device, self.folder = device, folder
        self.modules: dict[str, int] = {}

    def load(self, text: str) -> int:
        if text not in self.modules:
            path = self.folder / f"{len(self.modules)}.ptx"
            path.write_text(HEAD + text)
            self.modules[text] = self.device.launches.wp_cuda_load_module(None, str(path).encode())
        return self.modules[text]

    def launch(self, text: str, arrays: list, *, threads: int, block: int, shared: int = 0, name: str = "k") -> int:
        """Queue a launch of a kernel that takes pointers; the status."""
        launches = self.device.launches
        kernel = launches.wp_cuda_get_kernel(None, self.load(text), name.encode())
        pointers = [ctypes.c_uint64(a.ptr) for a in arrays]
        arguments = (ctypes.c_void_p * max(len(pointers), 1))(*(ctypes.addressof(p) for p in pointers))
        given = (arguments, wp.get_device("cuda:0").stream.cuda_stream, None)
        return launches.wp_cuda_launch_kernel(None, kernel, threads, 0, block, False, 0, shared, *given)

    def rows(self, instructions: list[str], instruction: str, *columns: np.ndarray) -> np.ndarray:
        """What one of the instructions makes of each row; all of them are compiled together."""
        text = "".join(_row_kernel(f"k{k}", code) for k, code in enumerate(instructions))
        count = len(columns[0])
        given = [np.zeros(count, np.uint64) for _ in range(3)]
        for k, column in enumerate(columns):
            given[k][:] = column
        arrays = [wp.array(column, dtype=wp.uint64, device="cuda:0") for column in given]
        out = wp.zeros(count, dtype=wp.uint64, device="cuda:0")
        name = f"k{instructions.index(instruction)}"
        assert self.launch(text, [*arrays, out], threads=count, block=count, name=name) == 0
        return out.numpy()


def _row_kernel(name: str, instruction: str) -> str:
    result = next(register for register in STORES if f"{register}," in instruction or f"{register}|" in instruction)
    loads = "".join(LOAD.format(column=column, k=k + 1) for k, column in enumerate("abc"))
    return ROW.format(name=name, loads=loads, instruction=instruction, store="    " + STORES[result])
