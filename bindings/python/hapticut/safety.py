# SPDX-License-Identifier: Apache-2.0
"""What protects the hand: the guard, its inner stages and its log."""
from ._export import export
from ._hapticut import (
    GuardOptions as GuardOptions,
    Requests as Requests,
    SafetyGuard as SafetyGuard,
    output_limits as output_limits,

    # Its stages
    Arming as Arming,
    ArmingOptions as ArmingOptions,
    ArmingState as ArmingState,
    PassivityController as PassivityController,
    PassivityOptions as PassivityOptions,
    PoseGate as PoseGate,
    PoseGateOptions as PoseGateOptions,
    ThermalBudget as ThermalBudget,
    ThermalOptions as ThermalOptions,
    Watchdog as Watchdog,
    WatchdogOptions as WatchdogOptions,

    # What it notes
    SafetyEvent as SafetyEvent,
    SafetyLog as SafetyLog,
    SafetyLogEntry as SafetyLogEntry,
    kSafetyEvents as kSafetyEvents,
    sentence_of as sentence_of,

    # What a step says, in sentences with their cures
    sentences_of as sentences_of,
)

export(__name__)
