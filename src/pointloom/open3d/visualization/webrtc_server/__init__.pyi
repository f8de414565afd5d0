"""The names of `open3d.visualization.webrtc_server`."""

from .switches import disable_http_handshake as disable_http_handshake
from .switches import enable_webrtc as enable_webrtc
