# SPDX-License-Identifier: Apache-2.0
"""Protection of the hand: the guard, the options of its stages, and its log."""
from ._export import export
from ._hapticut import (
    GuardOptions as GuardOptions,
    Requests as Requests,
    SafetyGuard as SafetyGuard,
    output_limits as output_limits,

    # Options and states of its stages
    ArmingOptions as ArmingOptions,
    ArmingState as ArmingState,
    PassivityOptions as PassivityOptions,
    PoseGateOptions as PoseGateOptions,
    ThermalOptions as ThermalOptions,
    WatchdogOptions as WatchdogOptions,

    # Log
    SafetyEvent as SafetyEvent,
    SafetyLog as SafetyLog,
    SafetyLogEntry as SafetyLogEntry,
    sentence_of as sentence_of,

    # Status of a step in sentences, with cures
    sentences_of as sentences_of,
)

export(__name__)
