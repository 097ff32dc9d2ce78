# SPDX-License-Identifier: Apache-2.0
"""What a drill sounds like, sample by sample, from what steps or a loop show."""
from ._export import export
from ._hapticut import (
    DrillSound as DrillSound,
    LoopListener as LoopListener,
    SoundInput as SoundInput,
    SoundOptions as SoundOptions,
)

export(__name__)
