"""Websocket connection between the program and its pages: docs/viewer-protocol.md."""

from .camera import CameraState, PageCamera
from .client import PageClient
from .controls import Command, Handle, PanelEvent, Shown, Tree, UploadedFile
from .gui import Gui
from .scene import ClickEvent, Node, Scene
from .server import PageServer

__all__ = [
    "CameraState",
    "ClickEvent",
    "Command",
    "Gui",
    "Handle",
    "Node",
    "PageCamera",
    "PageClient",
    "PageServer",
    "PanelEvent",
    "Scene",
    "Shown",
    "Tree",
    "UploadedFile",
]
