# SPDX-License-Identifier: Apache-2.0
"""The surface of a workpiece during cutting, page by page. As one mesh: hapticut.extract_surface."""
from ._export import export
from ._hapticut import (
    SurfacePage as SurfacePage,
    SurfaceStream as SurfaceStream,
)

export(__name__)
