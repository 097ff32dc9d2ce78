# SPDX-License-Identifier: Apache-2.0
"""The 1 kHz thread: a device, a simulation, and their exchange with other threads."""
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

    # Data from the loop
    ChangeFeedOptions as ChangeFeedOptions,
    ChangedBlock as ChangedBlock,
    LoopSnapshot as LoopSnapshot,
    TickEffort as TickEffort,
    ToolSnapshot as ToolSnapshot,

    # Map from the workspace of the device to the scene
    WorkspaceMap as WorkspaceMap,
    WorkspaceMapOptions as WorkspaceMapOptions,
    gains_in_world as gains_in_world,

    # Timing
    LatencyHistogram as LatencyHistogram,
    RealtimeOptions as RealtimeOptions,
)

if TYPE_CHECKING or _with_io:
    from ._hapticut import (
        # Device data of a tick in recordings
        DeviceTick as DeviceTick,
    )

export(__name__)
