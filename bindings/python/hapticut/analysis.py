# SPDX-License-Identifier: Apache-2.0
"""Closed loops of a model and a simulated device: stability, and faults of the device."""
from ._export import export
from ._hapticut import (
    # Closed loop: a force model, a plant and the guard
    ClosedLoop as ClosedLoop,
    ClosedLoopConfig as ClosedLoopConfig,
    ForceModel as ForceModel,
    LinearWall as LinearWall,
    ModelFactory as ModelFactory,

    # Contact: models that press a head into voxels
    PressedBall as PressedBall,
    contact_models as contact_models,
    pressed_search as pressed_search,

    # Stability
    Bounce as Bounce,
    BounceTest as BounceTest,
    Buzz as Buzz,
    PressTest as PressTest,
    StabilitySearch as StabilitySearch,
    is_stable as is_stable,
    max_stable_stiffness as max_stable_stiffness,
    measure_bounce as measure_bounce,
    measure_buzz as measure_buzz,

    # Faults
    FaultResponse as FaultResponse,
    InjectedFault as InjectedFault,
    injected_faults as injected_faults,
    measure_fault_response as measure_fault_response,
    obeys_the_rules as obeys_the_rules,
)

export(__name__)
