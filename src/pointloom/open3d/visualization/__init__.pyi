"""The names of `open3d.visualization`."""

from . import rendering as rendering
from .editing import VisualizerWithEditing as VisualizerWithEditing
from .o3d_visualizer import O3DVisualizer as O3DVisualizer
from .polygon import SelectionPolygonVolume as SelectionPolygonVolume
from .polygon import read_selection_polygon_volume as read_selection_polygon_volume
from .render_option import MeshColorOption as MeshColorOption
from .render_option import MeshShadeOption as MeshShadeOption
from .render_option import PointColorOption as PointColorOption
from .render_option import RenderOption as RenderOption
from .view_control import ViewControl as ViewControl
from .visualizer import Visualizer as Visualizer
from .visualizer import VisualizerWithKeyCallback as VisualizerWithKeyCallback
from .windows import draw as draw
from .windows import draw_geometries as draw_geometries
from .windows import draw_geometries_with_animation_callback as draw_geometries_with_animation_callback
from .windows import draw_geometries_with_editing as draw_geometries_with_editing
from .windows import draw_geometries_with_key_callbacks as draw_geometries_with_key_callbacks
