# SPDX-License-Identifier: Apache-2.0
"""The 1 kHz thread: a device, a simulation, and what they exchange with other threads."""
from typing import TYPE_CHECKING

from ._export import export
from ._hapticut import kWithIo as _with_io
from ._hapticut import (
    RealtimeLoop as RealtimeLoop,
    RealtimeLoopOptions as RealtimeLoopOptions,
    SimulationModel as SimulationModel,
    SimulationModelOptions as SimulationModelOptions,
    SpindleInterlock as SpindleInterlock,
    commands as commands,

    # What it shows
    ChangeFeedOptions as ChangeFeedOptions,
    ChangedBlock as ChangedBlock,
    LoopSnapshot as LoopSnapshot,
    TickEffort as TickEffort,
    ToolSnapshot as ToolSnapshot,

    # From the workspace of the device to that of the scene
    WorkspaceMap as WorkspaceMap,
    WorkspaceMapOptions as WorkspaceMapOptions,
    gains_in_world as gains_in_world,

    # Its clock
    LatencyHistogram as LatencyHistogram,
    RealtimeOptions as RealtimeOptions,
)

if TYPE_CHECKING or _with_io:
    from ._hapticut import (
        # What recordings keep of a tick
        DeviceTick as DeviceTick,
    )

export(__name__)
