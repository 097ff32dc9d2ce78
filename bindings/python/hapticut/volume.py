# SPDX-License-Identifier: Apache-2.0
"""Volumes of grey values and labels, and their processing before a workpiece is built."""
from typing import TYPE_CHECKING

from ._export import export
from ._hapticut import kWithIo as _with_io
from ._hapticut import (
    GreyVolume as GreyVolume,
    LabelVolume as LabelVolume,

    # Inspect
    box_around as box_around,
    box_of_volume as box_of_volume,
    count_from as count_from,
    count_labels as count_labels,
    grey_range as grey_range,
    unused_label as unused_label,

    # Change
    crop_to_box as crop_to_box,
    crop_to_samples as crop_to_samples,
    fill_cavities as fill_cavities,
    keep_largest_component as keep_largest_component,
    label_range as label_range,
    with_spacing as with_spacing,
)

if TYPE_CHECKING or _with_io:
    from ._hapticut import (
        # Change, with ITK
        LabelInterpolation as LabelInterpolation,
        close_gaps as close_gaps,
        resample as resample,
    )

export(__name__)
