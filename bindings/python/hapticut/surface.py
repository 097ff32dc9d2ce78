# SPDX-License-Identifier: Apache-2.0
"""The surface of a workpiece that is being cut, page by page, beside the steps. As one mesh: hapticut.extract_surface."""
from ._export import export
from ._hapticut import (
    SurfacePage as SurfacePage,
    SurfaceStream as SurfaceStream,
)

export(__name__)
