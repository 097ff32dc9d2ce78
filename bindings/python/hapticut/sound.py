# SPDX-License-Identifier: Apache-2.0
"""The sound of a drill, sample by sample, from steps or a loop."""
from ._export import export
from ._hapticut import (
    DrillSound as DrillSound,
    LoopListener as LoopListener,
    SoundInput as SoundInput,
    SoundOptions as SoundOptions,
)

export(__name__)
